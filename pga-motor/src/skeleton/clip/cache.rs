//! Logarithms kept for repeated sampling between the same keys.

use alloc::vec::Vec;

use super::{Clip, ClipError, KeySpan, Wrap};
use crate::batch::{self, Way};
use crate::{Line, Motor, Real};

/// The screws from one key of a clip to the next, one for each joint: what [`Interpolation::Screw`](super::Interpolation::Screw)
/// works out anew for every sample, kept while samples fall between the same two keys.
///
/// It may be handed any clip of as many joints: it looks whether its screws still join the two keys. Memory: three motors for each
/// joint.
#[derive(Clone, Debug, PartialEq)]
pub struct ScrewCache<T> {
    starts: Vec<Motor<T>>,
    ends: Vec<Motor<T>>,
    /// log(~start end).
    generators: Vec<Line<T>>,
}

impl<T: Real> ScrewCache<T> {
    /// A cache for clips of this many joints.
    pub fn new(joint_count: usize) -> Self {
        let motors = alloc::vec![Motor::IDENTITY; joint_count];
        Self { starts: motors.clone(), ends: motors, generators: alloc::vec![Line::ZERO; joint_count] }
    }

    /// Makes the screws those from the motors of one key to those of another.
    fn join(&mut self, a: &[Motor<T>], b: &[Motor<T>]) {
        let kept = self.starts.iter_mut().zip(&mut self.ends).zip(&mut self.generators);
        for (((start, end), generator), (&a, &b)) in kept.zip(a.iter().zip(b)) {
            if *start != a || *end != b {
                (*start, *end, *generator) = (a, b, (a.reverse() * b).log());
            }
        }
    }
}

impl<T: Real> Clip<T> {
    /// [`Clip::sample_into`] with [`Interpolation::Screw`](super::Interpolation::Screw) and the same results up to the last digits, for
    /// about half the cost while samples stay between the same two keys. Nothing is allocated.
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
        batch::along_slices(&cache.starts, &cache.generators, fraction, pose);
        self.hold_parts(Way::Screw, a, b, fraction, pose);
        Ok(())
    }
}
