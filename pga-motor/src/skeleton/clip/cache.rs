//! Logarithms kept for repeated sampling between the same keys.

use alloc::vec::Vec;

use super::sample::joint_between;
use super::{Clip, ClipError, JointModes, KeySpan, Wrap};
use crate::{Motor, Real, ScrewPath};

/// The screws from one key of a clip to the next, one for each joint: what [`Interpolation::Screw`](super::Interpolation::Screw)
/// works out anew for every sample, kept while samples fall between the same two keys.
///
/// It belongs to one clip; [`ScrewCache::clear`] makes it ready for another. Memory: three motors for each joint.
#[derive(Clone, Debug, PartialEq)]
pub struct ScrewCache<T> {
    paths: Vec<ScrewPath<T>>,
    /// The keys that the paths join.
    keys: Option<(usize, usize)>,
}

impl<T: Real> ScrewCache<T> {
    /// A cache for clips of this many joints, with nothing in it yet.
    pub fn new(joint_count: usize) -> Self {
        let nothing = ScrewPath::new(Motor::IDENTITY, Motor::IDENTITY);
        Self { paths: alloc::vec![nothing; joint_count], keys: None }
    }

    /// Forgets what is kept, as must be done before it is handed another clip.
    pub fn clear(&mut self) {
        self.keys = None;
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
        if cache.keys != Some((before, after)) {
            for (path, (&a, &b)) in cache.paths.iter_mut().zip(a.iter().zip(b)) {
                *path = ScrewPath::new(a, b);
            }
            cache.keys = Some((before, after));
        }
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
