//! Logarithms kept for repeated sampling between the same keys.

use alloc::vec::Vec;

use super::{Clip, ClipError, KeySpan, Wrap};
use crate::batch::{self, Blocks, Way};
use crate::{Line, Motor, Real, Scalar};

/// The screws from one key of a clip to the next, one for each joint: what [`Interpolation::Screw`](super::Interpolation::Screw)
/// works out anew for every sample, kept while samples fall between the same two keys.
///
/// It may be handed any clip of as many joints: it looks whether its screws still join the two keys. Memory: 30 numbers for each
/// joint.
#[derive(Clone, Debug, PartialEq)]
pub struct ScrewCache<T: Scalar> {
    starts: Vec<Motor<T>>,
    ends: Vec<Motor<T>>,
    /// The starts, side by side.
    blocks: Blocks<Motor<T>>,
    /// log(~start end).
    generators: Blocks<Line<T>>,
}

impl<T: Real> ScrewCache<T> {
    /// A cache for clips of this many joints.
    pub fn new(joint_count: usize) -> Self {
        let motors = alloc::vec![Motor::IDENTITY; joint_count];
        let blocks = Blocks::filled(Motor::IDENTITY, joint_count);
        Self { starts: motors.clone(), ends: motors, blocks, generators: Blocks::filled(Line::ZERO, joint_count) }
    }

    /// Makes the screws those from the motors of one key to those of another.
    fn join(&mut self, a: &[Motor<T>], b: &[Motor<T>]) {
        if are_same(&self.starts, a) & are_same(&self.ends, b) {
            return;
        }
        for (joint, (&a, &b)) in a.iter().zip(b).enumerate() {
            if self.starts[joint] != a || self.ends[joint] != b {
                (self.starts[joint], self.ends[joint]) = (a, b);
                self.blocks.replace(joint, a);
                self.generators.replace(joint, (a.reverse() * b).log());
            }
        }
    }
}

/// Whether motors are the same, number by number. Without a branch, as mostly they are.
fn are_same<T: Real>(a: &[Motor<T>], b: &[Motor<T>]) -> bool {
    let all = |same: bool, (a, b): (&Motor<T>, &Motor<T>)| {
        a.to_array().iter().zip(b.to_array()).fold(same, |same, (a, b)| same & (*a == b))
    };
    a.iter().zip(b).fold(true, all)
}

impl<T: Real> Clip<T> {
    /// [`Clip::sample_into`] with [`Interpolation::Screw`](super::Interpolation::Screw) and the same results up to the last digits, for
    /// about two thirds of the cost while samples stay between the same two keys. Nothing is allocated.
    ///
    /// # Errors
    /// Those of [`Clip::sample_into`], [`ClipError::PoseLength`] also for a cache of another number of joints; `pose` is then as it
    /// was.
    pub fn sample_cached_into(
        &self,
        time: T,
        wrap: Wrap,
        cache: &mut ScrewCache<T>,
        pose: &mut [Motor<T>],
    ) -> Result<(), ClipError> {
        self.check_pose(pose.len())?;
        self.check_pose(cache.starts.len())?;
        let KeySpan { before, after, fraction } = self.span(time, wrap)?;
        let (a, b) = (self.joints_of(before), self.joints_of(after));
        if before == after || fraction == T::ZERO {
            pose.copy_from_slice(a);
            return Ok(());
        }
        cache.join(a, b);
        batch::along_screws(&cache.blocks, &cache.generators, fraction, pose);
        self.hold_parts(Way::Screw, a, b, fraction, pose);
        Ok(())
    }
}
