//! Many characters at once, on all cores.

use rayon::prelude::*;

use super::{Clip, ClipError, Interpolation, Pose, Skeleton, SkeletonInstance, Wrap, animate_sample};
use crate::{Motor, Real};

/// One character of a crowd: an instance, when in its clip it is, and the buffer that its pose is worked out in.
#[derive(Clone, Debug, PartialEq)]
pub struct Character<T> {
    /// Where it is, and where its joints are.
    pub instance: SkeletonInstance<T>,
    /// The time in its clip, in seconds.
    pub time: T,
    /// The pose of that time, written by [`animate_characters`].
    pub pose: Pose<T>,
}

impl<T: Real> Character<T> {
    /// A character in its rest pose.
    pub fn new(skeleton: &Skeleton<T>, world: Motor<T>, time: T) -> Self {
        Self { instance: SkeletonInstance::new(skeleton, world), time, pose: skeleton.rest_pose().clone() }
    }
}

/// [`animate_sample`] for each of many characters of one skeleton and clip, spread over the threads of rayon's current pool. The
/// results are those of one after the other, bit for bit.
///
/// # Errors
/// That of a character that cannot be animated, and its index; the others may have been, or not.
pub fn animate_characters<T: Real + Send + Sync>(
    skeleton: &Skeleton<T>,
    clip: &Clip<T>,
    interpolation: Interpolation,
    wrap: Wrap,
    characters: &mut [Character<T>],
) -> Result<(), (usize, ClipError)> {
    characters.par_iter_mut().enumerate().try_for_each(|(index, character)| {
        let Character { instance, time, pose } = character;
        animate_sample(skeleton, instance, clip, *time, interpolation, wrap, pose).map_err(|error| (index, error))
    })
}

#[cfg(test)]
mod tests {
    use alloc::vec::Vec;

    use super::*;
    use crate::{Rotor, Translator};

    #[test]
    fn a_crowd_is_animated_as_one_after_the_other() {
        let step = Motor::<f64>::from(Translator::from_vector(crate::Direction::X));
        let (skeleton, _) = Skeleton::from_parents([("a", None, step), ("b", Some(0), step)]).unwrap();
        let keys = [step, step, step * Rotor::about_x(1.0), step * Rotor::about_z(2.0)];
        let clip = Clip::new(2, [0.0, 1.0].into(), keys.into()).unwrap();
        let character = |index: i32| Character::new(&skeleton, step.powf(f64::from(index)), f64::from(index) / 100.0);
        let mut crowd: Vec<_> = (0..300).map(character).collect();
        let mut expected = crowd.clone();
        animate_characters(&skeleton, &clip, Interpolation::Screw, Wrap::Loop, &mut crowd).unwrap();
        for Character { instance, time, pose } in &mut expected {
            animate_sample(&skeleton, instance, &clip, *time, Interpolation::Screw, Wrap::Loop, pose).unwrap();
        }
        assert_eq!(crowd, expected);
        crowd[17].time = f64::NAN;
        let error = animate_characters(&skeleton, &clip, Interpolation::Screw, Wrap::Loop, &mut crowd).unwrap_err();
        assert_eq!(error, (17, ClipError::SampleTime));
    }
}
