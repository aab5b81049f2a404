//! What a clip is at any time.

use super::{Clip, ClipError, JointModes, KeyMode};
use crate::batch::{self, Way};
use crate::weights;
use crate::{Motor, Real, Translator};

/// How a joint gets from one key to the next, where its modes say that it is interpolated.
///
/// The ways of [`Motor`]: see there for what each keeps constant. Where only the rotation is interpolated and the translation
/// holds, or the other way round, each part goes its own way: the rotation as the rotors do, the translation straight.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Interpolation {
    /// No interpolation: the key before holds.
    Step,
    /// [`Motor::nlerp`], the cheapest.
    Nlerp,
    /// [`Motor::slerp`].
    Slerp,
    /// [`Motor::screw_lerp`].
    Screw,
    /// [`Motor::split_lerp`]: what glTF calls LINEAR, and what most programs export.
    #[default]
    Split,
}

impl Interpolation {
    /// All of them.
    pub const ALL: [Self; 5] = [Self::Step, Self::Nlerp, Self::Slerp, Self::Screw, Self::Split];

    /// The name in lower case: `step`, `nlerp`, `slerp`, `screw`, `split`.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Step => "step",
            Self::Nlerp => "nlerp",
            Self::Slerp => "slerp",
            Self::Screw => "screw",
            Self::Split => "split",
        }
    }

    /// The way that interpolated joints take; `None` where they are not.
    pub(in crate::skeleton) const fn way(self) -> Option<Way> {
        match self {
            Self::Step => None,
            Self::Nlerp => Some(Way::Nlerp),
            Self::Slerp => Some(Way::Slerp),
            Self::Screw => Some(Way::Screw),
            Self::Split => Some(Way::Split),
        }
    }
}

/// What is before the first key and after the last.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Wrap {
    /// The first key, and the last.
    #[default]
    Clamp,
    /// The clip again, from its first key to its last, over and over. The last key's time is the first one's.
    Loop,
}

/// Where a time lies among the keys of a clip.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct KeySpan<T> {
    /// The key at or before it.
    pub before: usize,
    /// The key after it; the same as `before` where the time is before the first key, or at or after the last.
    pub after: usize,
    /// How much of the way from one to the other has passed: 0 at `before`, always less than 1.
    pub fraction: T,
}

impl<T: Real> Clip<T> {
    /// The keys around a time in seconds, by binary search. A time before the first key counts as that of the first key, one after
    /// the last as that of the last, and NaN as the first.
    ///
    /// ```
    /// use pga_motor::f64::{Clip, Motor};
    ///
    /// let clip = Clip::new(1, vec![1.0, 2.0, 4.0], vec![Motor::IDENTITY; 3])?;
    /// let span = clip.keys_around(2.5);
    /// assert_eq!((span.before, span.after, span.fraction), (1, 2, 0.25));
    /// # Ok::<(), pga_motor::skeleton::ClipError>(())
    /// ```
    pub fn keys_around(&self, time: T) -> KeySpan<T> {
        let times = self.times();
        let passed = times.partition_point(|&key| key <= time);
        let before = passed.saturating_sub(1);
        if passed == 0 || passed == times.len() {
            return KeySpan { before, after: before, fraction: T::ZERO };
        }
        let (from, to) = (times[before], times[passed]);
        // The distance of two finite times may be infinite; that of their halves is not.
        let half = |time: T| time * T::from_ratio(1, 2);
        let (part, whole) = if (to - from).is_finite() {
            (time - from, to - from)
        } else {
            (half(time) - half(from), half(to) - half(from))
        };
        let fraction = part / whole;
        // Rounding must not reach the next key.
        let below_one = T::ONE - T::EPSILON;
        KeySpan { before, after: passed, fraction: if fraction < below_one { fraction } else { below_one } }
    }

    /// The time within the clip that stands for any time, and the number of the round of a loop, negative before the clip; `None` for
    /// NaN and infinities.
    pub(in crate::skeleton) fn wrapped(&self, time: T, wrap: Wrap) -> Option<(T, T)> {
        if !time.is_finite() {
            return None;
        }
        let inside = self.start() <= time && time < self.end();
        if wrap == Wrap::Clamp || inside || self.key_count() == 1 {
            return Some((time, T::ZERO));
        }
        let [start, end] = [self.start(), self.end()].map(Real::to_f64);
        let (passed, duration) = (time.to_f64() - start, end - start);
        let remainder = passed % duration;
        let position = if remainder < 0.0 { remainder + duration } else { remainder };
        Some((T::from_f64(start + position), T::from_f64((passed - position) / duration)))
    }

    /// Where a time lies among the keys, for sampling.
    pub(super) fn span(&self, time: T, wrap: Wrap) -> Result<KeySpan<T>, ClipError> {
        self.wrapped(time, wrap).map(|(time, _)| self.keys_around(time)).ok_or(ClipError::SampleTime)
    }

    pub(super) fn check_pose(&self, found: usize) -> Result<(), ClipError> {
        let expected = self.joint_count();
        if found == expected { Ok(()) } else { Err(ClipError::PoseLength { expected, found }) }
    }

    /// Writes the local motors at a time in seconds, one for each joint. Nothing is allocated.
    ///
    /// `interpolation` is for what the clip's modes interpolate; what they hold is held. Joints are worked on side by side, as by
    /// [`Motor::nlerp_slice`] and its kin, so results are those of single motors up to the last digits. At a key they are the key's.
    ///
    /// # Errors
    /// [`ClipError::PoseLength`] where `pose` has not one motor for each joint of the clip, [`ClipError::SampleTime`] for a time
    /// that is not finite; `pose` is then as it was.
    pub fn sample_into(
        &self,
        time: T,
        interpolation: Interpolation,
        wrap: Wrap,
        pose: &mut [Motor<T>],
    ) -> Result<(), ClipError> {
        self.check_pose(pose.len())?;
        let KeySpan { before, after, fraction } = self.span(time, wrap)?;
        let (a, b) = (self.joints_of(before), self.joints_of(after));
        if before == after || fraction == T::ZERO {
            pose.copy_from_slice(a);
            return Ok(());
        }
        let Some(way) = interpolation.way() else {
            pose.copy_from_slice(a);
            return Ok(());
        };
        batch::between_slices(way, a, b, fraction, pose);
        self.hold_parts(way, a, b, fraction, pose);
        Ok(())
    }
}

impl<T: Real> Clip<T> {
    /// Replaces the joints of which a part holds its key.
    pub(super) fn hold_parts(&self, way: Way, a: &[Motor<T>], b: &[Motor<T>], fraction: T, pose: &mut [Motor<T>]) {
        if self.all_linear {
            return;
        }
        let joints = self.modes().iter().enumerate().filter(|(_, modes)| **modes != JointModes::default());
        for (joint, &modes) in joints {
            pose[joint] = joint_between(modes, way.of_one(), a[joint], b[joint], fraction);
        }
    }
}

/// A joint between two keys, where one part of it may hold.
#[inline]
pub(in crate::skeleton) fn joint_between<T: Real>(
    modes: JointModes,
    way: impl Fn(Motor<T>, Motor<T>, T) -> Motor<T>,
    a: Motor<T>,
    b: Motor<T>,
    fraction: T,
) -> Motor<T> {
    match (modes.rotation, modes.translation) {
        (KeyMode::Linear, KeyMode::Linear) => way(a, b, fraction),
        (KeyMode::Step, KeyMode::Step) => a,
        (KeyMode::Step, KeyMode::Linear) => {
            let (from, to) = (a.translator().vector(), b.translator().vector());
            let vector = weights::mix(from, to, fraction, weights::chord(fraction));
            Motor::from_rotor_translator(a.rotor(), Translator::from_vector(vector))
        }
        // The way of two pure rotations is the way of their rotors.
        (KeyMode::Linear, KeyMode::Step) => {
            let rotor = way(a.rotor().into(), b.rotor().into(), fraction).rotor();
            Motor::from_rotor_translator(rotor, a.translator())
        }
    }
}
