//! Logarithms kept for repeated sampling between the same keys.

use alloc::vec::Vec;

use super::sample::joint_between;
use super::{Clip, ClipError, JointModes, KeySpan, Wrap};
use crate::{Motor, Real, ScrewPath};

/// The screws from one key of a clip to the next, one for each joint: what [`Interpolation::Screw`](super::Interpolation::Screw)
/// works out anew for every sample, kept while samples fall between the same two keys.
///
/// It may be handed any clip of as many joints: it looks whether its screws still join the two keys. Memory: three motors for each
/// joint.
#[derive(Clone, Debug, PartialEq)]
pub struct ScrewCache<T> {
    paths: Vec<ScrewPath<T>>,
}

impl<T: Real> ScrewCache<T> {
    /// A cache for clips of this many joints.
    pub fn new(joint_count: usize) -> Self {
        Self { paths: alloc::vec![ScrewPath::new(Motor::IDENTITY, Motor::IDENTITY); joint_count] }
    }

    /// Makes the paths those from the motors of one key to those of another.
    fn join(&mut self, a: &[Motor<T>], b: &[Motor<T>]) {
        for (path, (&a, &b)) in self.paths.iter_mut().zip(a.iter().zip(b)) {
            if path.start() != a || (path.end() != b && path.end() != -b) {
                *path = ScrewPath::new(a, b);
            }
        }
    }
}

impl<T: Real> Clip<T> {
    /// [`Clip::sample_into`] with [`Interpolation::Screw`](super::Interpolation::Screw) and the same results, bit for bit, for about
    /// half the cost while samples stay between the same two keys. Nothing is allocated.
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
        self.check_pose(cache.paths.len())?;
        let KeySpan { before, after, fraction } = self.span(time, wrap)?;
        let (a, b) = (self.joints_of(before), self.joints_of(after));
        if before == after || fraction == T::ZERO {
            pose.copy_from_slice(a);
            return Ok(());
        }
        cache.join(a, b);
        for (joint, (local, path)) in pose.iter_mut().zip(&cache.paths).enumerate() {
            let modes = self.modes()[joint];
            *local = if modes == JointModes::default() {
                path.at(fraction)
            } else {
                joint_between(modes, Motor::screw_lerp, a[joint], b[joint], fraction)
            };
        }
        Ok(())
    }
}
