//! The way that a clip takes a character, apart from what it does on the way.

use alloc::vec::Vec;
use core::fmt;

use super::{Clip, ClipError, Interpolation, Wrap};
use crate::{Direction, Motor, Real, Rotor, Translator};

#[cfg(test)]
mod tests;

/// Which part of a joint's motion is the way.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum RootMotionPart<T> {
    /// All of it.
    All,
    /// What happens on the ground: the translation perpendicular to `up`, and the turn about `up`. Height, and leaning, stay with the
    /// joint.
    Ground {
        /// The upward direction in the joint's parent's space; of any length but 0.
        up: Direction<T>,
    },
}

/// Why no way can be taken out of a clip.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum RootMotionError {
    /// There is no such joint.
    NoSuchJoint {
        /// The number asked for.
        joint: usize,
        /// How many joints the clip has.
        joints: usize,
    },
    /// `up` is zero or not finite.
    NoDirection,
    /// The way, or what remains, is no clip: lengths leave the range of the numbers.
    Clip(ClipError),
}

impl fmt::Display for RootMotionError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::NoSuchJoint { joint, joints } => {
                write!(f, "expected a joint below {joints}, the number of joints, found {joint}")
            }
            Self::NoDirection => write!(f, "expected a direction as `up`, found one that is zero or not finite"),
            Self::Clip(error) => write!(f, "{error}"),
        }
    }
}

impl core::error::Error for RootMotionError {
    fn source(&self) -> Option<&(dyn core::error::Error + 'static)> {
        match self {
            Self::Clip(error) => Some(error),
            Self::NoSuchJoint { .. } | Self::NoDirection => None,
        }
    }
}

impl From<ClipError> for RootMotionError {
    fn from(error: ClipError) -> Self {
        Self::Clip(error)
    }
}

/// The way of a character: for each time of a clip a motion that starts as the identity.
///
/// [`RootMotion::extract`] takes it out of a clip. Played at the same time, the way times the remaining clip is what the whole clip
/// was; and a game that adds up [`RootMotion::between`] frame by frame can loop the clip, or turn the character on its way.
#[derive(Clone, Debug, PartialEq)]
pub struct RootMotion<T> {
    way: Clip<T>,
}

impl<T: Real> RootMotion<T> {
    /// Takes the motion of a joint, in general the root, out of a clip: the way, and the clip without it. In every key the joint's
    /// local motor is way * what remains.
    ///
    /// Of [`RootMotionPart::Ground`] the turn about `up` is the twist of the joint's rotation since the first key (the rotation is
    /// swing * twist); where that has none, in half a turn about a horizontal axis, the twist of the key before counts.
    ///
    /// # Errors
    /// [`RootMotionError`]: no such joint, an `up` without direction, a way that leaves the range of the numbers.
    pub fn extract(clip: &Clip<T>, joint: usize, part: RootMotionPart<T>) -> Result<(Self, Clip<T>), RootMotionError> {
        let joints = clip.joint_count();
        if joint >= joints {
            return Err(RootMotionError::NoSuchJoint { joint, joints });
        }
        let up = match part {
            RootMotionPart::All => None,
            RootMotionPart::Ground { up } => Some(up.normalize().ok_or(RootMotionError::NoDirection)?),
        };
        let mut ways: Vec<Motor<T>> = Vec::with_capacity(clip.key_count());
        let mut remaining: Vec<Motor<T>> = Vec::with_capacity(clip.key_count() * joints);
        let start = clip.joints_of(0)[joint];
        for key in 0..clip.key_count() {
            let motors = clip.joints_of(key);
            let local = motors[joint];
            let way = match up {
                None => local * start.reverse(),
                Some(up) => ground_way(start, local, up, ways.last().copied().unwrap_or(Motor::IDENTITY)),
            };
            ways.push(way);
            let first = remaining.len();
            remaining.extend_from_slice(motors);
            remaining[first + joint] = way.reverse() * local;
        }
        let times = clip.times().to_vec();
        let way = Clip::new(1, times.clone(), ways)?.with_modes(clip.modes()[joint..=joint].to_vec())?;
        let rest = Clip::new(joints, times, remaining)?.with_modes(clip.modes().to_vec())?.with_name(clip.name());
        Ok((Self { way: way.with_name(clip.name()) }, rest))
    }

    /// The way as a clip of one joint.
    pub fn way(&self) -> &Clip<T> {
        &self.way
    }

    /// The motion from the start of the clip to a time in seconds. With [`Wrap::Loop`] each round goes on from where the one before
    /// ended, so there is no jump, and times before the clip go backwards.
    ///
    /// # Errors
    /// [`ClipError::SampleTime`] for a time that is not finite.
    pub fn at(&self, time: T, interpolation: Interpolation, wrap: Wrap) -> Result<Motor<T>, ClipError> {
        let mut way = [Motor::<T>::IDENTITY];
        self.way.sample_into(time, interpolation, wrap, &mut way)?;
        let duration = self.way.duration();
        if wrap == Wrap::Clamp || duration == T::ZERO {
            return Ok(way[0]);
        }
        let rounds = self.way.rounds_before(time);
        let round = self.way.joints_of(self.way.key_count() - 1)[0];
        let [way] = way;
        Ok(round.powf(rounds) * way)
    }

    /// The motion from one time to another, as the character sees it: `world * between(from, to)` is where a character gets that
    /// was at `world`.
    ///
    /// # Errors
    /// [`ClipError::SampleTime`] for a time that is not finite.
    pub fn between(&self, from: T, to: T, interpolation: Interpolation, wrap: Wrap) -> Result<Motor<T>, ClipError> {
        let from = self.at(from, interpolation, wrap)?;
        Ok(from.reverse() * self.at(to, interpolation, wrap)?)
    }
}

/// The way on the ground from where the joint was at the start to where it is now; `before` is the way so far.
fn ground_way<T: Real>(start: Motor<T>, local: Motor<T>, up: Direction<T>, before: Motor<T>) -> Motor<T> {
    let turn = (local * start.reverse()).rotor();
    let twist = twist(turn, up).unwrap_or(before.rotor());
    let on_ground = |motor: Motor<T>| {
        let place = motor.translator().vector();
        place - up * place.dot(up)
    };
    let (from, to) = (Translator::from_vector(on_ground(start)), Translator::from_vector(on_ground(local)));
    to * twist * from.reverse()
}

/// The rotation about a unit axis that is nearest to a rotor, which is swing * twist with the swing's axis perpendicular to it
/// (Dobrowolski 2015). `None` where none is nearer than another.
fn twist<T: Real>(Rotor { s, e23, e31, e12 }: Rotor<T>, axis: Direction<T>) -> Option<Rotor<T>> {
    let along = e23 * axis.x + e31 * axis.y + e12 * axis.z;
    let norm = T::norm([s, along]);
    // A rotor has norm 1; what is left of nothing after rounding has no direction.
    if norm <= T::from_ratio(8, 1) * T::EPSILON {
        return None;
    }
    let (s, along) = (s / norm, along / norm);
    Some(Rotor { s, e23: along * axis.x, e31: along * axis.y, e12: along * axis.z })
}
