//! The poses of many characters of one skeleton, side by side.

mod error;
mod kinematics;
mod sampling;

use alloc::vec::Vec;
use core::fmt;

pub use error::PosesError;

use super::{Clip, Interpolation, Skeleton, Wrap};
use crate::batch::{LANES, MotorBlock};
use crate::{Motor, Real, Scalar};
use sampling::Spans;

/// One motor for each joint of each of many characters, [`LANES`] characters side by side: what blends, samples and walks down the
/// hierarchies of all of them in vector registers as wide as the machine has (see [`crate::batch`]).
///
/// Memory: that of [`Self::size_in_bytes`], 8 numbers for each joint of each character, the characters rounded up to a multiple of
/// [`LANES`]; 32.3 MB for 1000 joints of 1000 characters in `f32`. [`Self::animate`] allocates nothing and works in place, on one group of [`LANES`] characters after the other, so that what it has sampled is still in the
/// cache when it goes down the hierarchy.
///
/// ```
/// use pga_motor::f32::{Clip, Direction, Motor, Poses, Rotor, Skeleton, Translator};
/// use pga_motor::skeleton::{Interpolation, Wrap};
///
/// let step = Motor::from(Translator::from_vector(Direction::X));
/// let (arm, _) = Skeleton::from_parents([("upper", None, Motor::IDENTITY), ("lower", Some(0), step)])?;
/// let clip = Clip::new(2, vec![0.0, 1.0], vec![Motor::IDENTITY, step, Motor::IDENTITY, step * Rotor::about_z(1.0)])?;
///
/// let times: Vec<f32> = (0..100).map(|character| character as f32 / 100.0).collect();
/// let mut crowd = Poses::new(arm.len(), times.len());
/// crowd.animate(&arm, &clip, &times, Interpolation::Screw, Wrap::Clamp)?;
/// let lower = crowd.get(50, 1).unwrap();
/// assert!((lower - step * Rotor::about_z(0.5)).norm() < 1e-6);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone)]
pub struct Poses<T: Scalar> {
    joint_count: usize,
    len: usize,
    /// For each group of characters its joints. Lanes past the last character hold motors too.
    blocks: Vec<MotorBlock<T>>,
}

impl<T: Scalar> Poses<T> {
    /// All joints of so many characters where their parents are.
    ///
    /// # Panics
    /// Like `Vec`, where no memory holds so many.
    pub fn new(joint_count: usize, characters: usize) -> Self {
        let blocks = joint_count.checked_mul(characters.div_ceil(LANES)).expect("capacity overflow");
        Self { joint_count, len: characters, blocks: alloc::vec![MotorBlock::of(Motor::IDENTITY); blocks] }
    }

    /// So many characters in one pose, such as the rest pose of their skeleton.
    ///
    /// # Panics
    /// As [`Self::new`].
    pub fn filled(pose: &[Motor<T>], characters: usize) -> Self {
        let mut poses = Self::new(pose.len(), characters);
        for group in poses.blocks.chunks_exact_mut(pose.len().max(1)) {
            group.iter_mut().zip(pose).for_each(|(block, &motor)| *block = MotorBlock::of(motor));
        }
        poses
    }

    /// How many joints each character has.
    pub fn joint_count(&self) -> usize {
        self.joint_count
    }

    /// How many characters there are.
    pub fn len(&self) -> usize {
        self.len
    }

    /// Whether there are no characters.
    pub fn is_empty(&self) -> bool {
        self.len == 0
    }

    /// The memory that the motors take.
    pub fn size_in_bytes(&self) -> usize {
        size_of_val(self.blocks.as_slice())
    }

    /// The motor of a character's joint; `None` where there is no such character or joint.
    pub fn get(&self, character: usize, joint: usize) -> Option<Motor<T>> {
        let block = self.block_of(character, joint)?;
        Some(self.blocks[block].get(character % LANES))
    }

    /// Replaces the motor of a character's joint and returns the one that was there; `None`, and nothing is changed, where there is no
    /// such character or joint.
    pub fn replace(&mut self, character: usize, joint: usize, motor: Motor<T>) -> Option<Motor<T>> {
        let before = self.get(character, joint)?;
        let block = self.block_of(character, joint)?;
        self.blocks[block].put(character % LANES, motor);
        Some(before)
    }

    /// Writes the motors of a character's joints.
    ///
    /// # Errors
    /// [`PosesError::NoSuchCharacter`], and [`PosesError::Joints`] where `pose` has another number of motors; it is then as it was.
    pub fn pose_into(&self, character: usize, pose: &mut [Motor<T>]) -> Result<(), PosesError> {
        self.check_pose(character, pose.len())?;
        for (joint, motor) in pose.iter_mut().enumerate() {
            *motor = self.blocks[character / LANES * self.joint_count + joint].get(character % LANES);
        }
        Ok(())
    }

    /// Gives a character a pose.
    ///
    /// # Errors
    /// [`PosesError::NoSuchCharacter`], and [`PosesError::Joints`] where `pose` has another number of motors; nothing is changed then.
    pub fn set_pose(&mut self, character: usize, pose: &[Motor<T>]) -> Result<(), PosesError> {
        self.check_pose(character, pose.len())?;
        for (joint, &motor) in pose.iter().enumerate() {
            self.blocks[character / LANES * self.joint_count + joint].put(character % LANES, motor);
        }
        Ok(())
    }

    fn check_pose(&self, character: usize, joints: usize) -> Result<(), PosesError> {
        if character >= self.len {
            return Err(PosesError::NoSuchCharacter { character, len: self.len });
        }
        self.check_joints(joints)
    }

    fn check_joints(&self, found: usize) -> Result<(), PosesError> {
        if found == self.joint_count { Ok(()) } else { Err(PosesError::Joints { expected: self.joint_count, found }) }
    }

    fn check_characters(&self, found: usize) -> Result<(), PosesError> {
        if found == self.len { Ok(()) } else { Err(PosesError::Characters { expected: self.len, found }) }
    }

    fn block_of(&self, character: usize, joint: usize) -> Option<usize> {
        let exists = character < self.len && joint < self.joint_count;
        exists.then_some(character / LANES * self.joint_count + joint)
    }

    /// Forward kinematics: makes model motors of these local ones, for all characters. See [`super::local_to_model`].
    ///
    /// # Errors
    /// [`PosesError::Joints`] for a skeleton of another number of joints; nothing is changed then.
    pub fn make_model(&mut self, skeleton: &Skeleton<T>) -> Result<(), PosesError> {
        self.check_joints(skeleton.len())?;
        kinematics::in_place(skeleton.joints(), &mut self.blocks);
        Ok(())
    }

    /// Forward kinematics: writes the model motors that belong to these local ones, for all characters. See
    /// [`super::local_to_model`].
    ///
    /// # Errors
    /// [`PosesError::Joints`] for a skeleton or results of another number of joints, [`PosesError::Characters`] for results of another
    /// number of characters; `models` is then as it was.
    pub fn local_to_model_into(&self, skeleton: &Skeleton<T>, models: &mut Self) -> Result<(), PosesError> {
        self.check_joints(skeleton.len())?;
        self.check_joints(models.joint_count)?;
        self.check_characters(models.len)?;
        kinematics::into(skeleton.joints(), &self.blocks, &mut models.blocks);
        Ok(())
    }
}

impl<T: Scalar> PartialEq for Poses<T> {
    fn eq(&self, other: &Self) -> bool {
        let joints = |character| (0..self.joint_count).map(move |joint| (character, joint));
        (self.joint_count, self.len) == (other.joint_count, other.len)
            && (0..self.len).flat_map(joints).all(|(c, joint)| self.get(c, joint) == other.get(c, joint))
    }
}

impl<T: Scalar> fmt::Debug for Poses<T> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Poses").field("joint_count", &self.joint_count).field("len", &self.len).finish_non_exhaustive()
    }
}

impl<T: Real> Poses<T> {
    /// Samples a clip for each character at a time of its own, in seconds: its joints' local motors, those of
    /// [`Clip::sample_into`] up to the last digits. Quickest where the characters of a group of [`LANES`] are between the same keys.
    ///
    /// # Errors
    /// [`PosesError::Joints`] for a clip of another number of joints, [`PosesError::Characters`] where there is not one time for each
    /// character, [`PosesError::SampleTime`] for one that is not finite; nothing is changed then.
    pub fn sample(
        &mut self,
        clip: &Clip<T>,
        times: &[T],
        interpolation: Interpolation,
        wrap: Wrap,
    ) -> Result<(), PosesError> {
        self.check_sampling(clip, times)?;
        for (group, times) in self.groups_mut().zip(times.chunks(LANES)) {
            Spans::new(clip, times, wrap).sample(interpolation, group);
        }
        Ok(())
    }

    /// [`Self::sample`] and [`Self::make_model`]: the characters' model motors at the given times.
    ///
    /// # Errors
    /// Those of the two; nothing is changed then.
    pub fn animate(
        &mut self,
        skeleton: &Skeleton<T>,
        clip: &Clip<T>,
        times: &[T],
        interpolation: Interpolation,
        wrap: Wrap,
    ) -> Result<(), PosesError> {
        self.check_joints(skeleton.len())?;
        self.check_sampling(clip, times)?;
        for (group, times) in self.groups_mut().zip(times.chunks(LANES)) {
            Spans::new(clip, times, wrap).sample(interpolation, group);
            kinematics::in_place(skeleton.joints(), group);
        }
        Ok(())
    }

    /// [`Self::animate`] on the threads of rayon's current pool. The results are the same, bit for bit.
    ///
    /// # Errors
    /// Those of [`Self::animate`].
    #[cfg(feature = "rayon")]
    pub fn animate_in_parallel(
        &mut self,
        skeleton: &Skeleton<T>,
        clip: &Clip<T>,
        times: &[T],
        interpolation: Interpolation,
        wrap: Wrap,
    ) -> Result<(), PosesError>
    where
        T: Send + Sync,
    {
        use rayon::prelude::*;

        self.check_joints(skeleton.len())?;
        self.check_sampling(clip, times)?;
        // The instructions are chosen per thread; what was chosen here holds for the others.
        let set = crate::batch::InstructionSet::in_use();
        let groups = self.blocks.par_chunks_mut(self.joint_count.max(1)).zip(times.par_chunks(LANES));
        groups.for_each(|(group, times)| {
            crate::batch::with_instruction_set(set, || {
                Spans::new(clip, times, wrap).sample(interpolation, group);
                kinematics::in_place(skeleton.joints(), group);
            });
        });
        Ok(())
    }

    fn check_sampling(&self, clip: &Clip<T>, times: &[T]) -> Result<(), PosesError> {
        self.check_joints(clip.joint_count())?;
        self.check_characters(times.len())?;
        match times.iter().position(|time| !time.is_finite()) {
            Some(character) => Err(PosesError::SampleTime { character }),
            None => Ok(()),
        }
    }

    /// The joints of each group of characters.
    fn groups_mut(&mut self) -> impl Iterator<Item = &mut [MotorBlock<T>]> {
        self.blocks.chunks_mut(self.joint_count.max(1))
    }
}

#[cfg(test)]
mod tests;
