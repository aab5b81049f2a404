//! Inverse kinematics: joints turned so that something gets where it should be.
//!
//! Both solvers are exact and in closed form, change rotations only, and allocate nothing. They read and write a pose and the model
//! motors that belong to it ([`local_to_model`](super::local_to_model)), so that several can follow one another.

mod aim;
mod two_bone;

use alloc::string::String;
use core::fmt;

pub use aim::Aim;
pub use two_bone::TwoBone;

use super::Skeleton;
use crate::{Direction, Motor, Point, Real, Rotor, UnitPlane};

#[cfg(test)]
mod tests;

/// How far a solver got.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Reach {
    /// To the target.
    Reached,
    /// The target is too far away. Two bones are straight towards it; an aim has changed nothing.
    TooFar,
    /// The target is too near. Two bones are folded as far as they go, the end on the line to the target; an aim has changed nothing.
    TooNear,
    /// The target is where the first joint is, so there is no way to it to turn to. Two bones are folded as far as they go, in the
    /// direction that they had; an aim has changed nothing.
    NoDirection,
}

/// Why nothing can be solved. Joints are counted in the skeleton's order.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum IkError {
    /// There is no such joint.
    NoSuchJoint {
        /// The number asked for.
        joint: usize,
        /// How many joints there are.
        joints: usize,
    },
    /// A joint is not below the one that it should be below.
    NotBelow {
        /// The joint.
        joint: usize,
        /// Its name.
        name: String,
        /// The joint that it should be below.
        ancestor: usize,
    },
    /// Two joints are at one place, so there is no bone between them.
    NoBone {
        /// Where the bone would begin.
        from: usize,
        /// Where it would end.
        to: usize,
    },
    /// A direction is zero.
    NoDirection {
        /// Which one: the name of the field.
        what: &'static str,
    },
    /// Something is NaN or infinite.
    NonFinite {
        /// What: the name of the field, or the pose.
        what: &'static str,
    },
    /// A buffer does not have one motor for each joint.
    PoseLength {
        /// Which one: the name of the parameter.
        buffer: &'static str,
        /// How many joints the skeleton has.
        expected: usize,
        /// How many motors the buffer has.
        found: usize,
    },
}

impl fmt::Display for IkError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::NoSuchJoint { joint, joints } => {
                write!(f, "expected a joint below {joints}, the number of joints, found {joint}")
            }
            Self::NotBelow { joint, name, ancestor } => {
                write!(f, "joint {joint} `{name}`: expected a joint below joint {ancestor}, found one that is not")
            }
            Self::NoBone { from, to } => {
                write!(f, "expected a bone from joint {from} to joint {to}, found both at one place")
            }
            Self::NoDirection { what } => write!(f, "expected a direction as `{what}`, found one of length 0"),
            Self::NonFinite { what } => write!(f, "expected a finite `{what}`, found a NaN or an infinity"),
            Self::PoseLength { buffer, expected, found } => {
                write!(f, "expected {expected} motors in `{buffer}`, one for each joint, found {found}")
            }
        }
    }
}

impl core::error::Error for IkError {}

/// A pose that is being solved, and its model motors.
struct Posed<'a, T> {
    skeleton: &'a Skeleton<T>,
    pose: &'a mut [Motor<T>],
    model: &'a mut [Motor<T>],
}

impl<'a, T: Real> Posed<'a, T> {
    fn new(skeleton: &'a Skeleton<T>, pose: &'a mut [Motor<T>], model: &'a mut [Motor<T>]) -> Result<Self, IkError> {
        let expected = skeleton.len();
        for (buffer, found) in [("pose", pose.len()), ("model", model.len())] {
            if found != expected {
                return Err(IkError::PoseLength { buffer, expected, found });
            }
        }
        Ok(Self { skeleton, pose, model })
    }

    /// Where a joint is, in the skeleton's space.
    fn place(&self, joint: usize) -> Result<Point<T>, IkError> {
        let joints = self.skeleton.len();
        let model = self.model.get(joint).ok_or(IkError::NoSuchJoint { joint, joints })?;
        finite("pose", model.transform_origin(), |point| point.is_finite())
    }

    fn require_below(&self, joint: usize, ancestor: usize) -> Result<(), IkError> {
        let group = usize::from(self.skeleton.joints()[ancestor].group_size);
        if (ancestor + 1..ancestor + group).contains(&joint) {
            return Ok(());
        }
        Err(IkError::NotBelow { joint, name: self.skeleton.names()[joint].clone(), ancestor })
    }

    /// Turns a joint about itself by part of a rotor given in the skeleton's space.
    fn turn(&mut self, joint: usize, rotor: Rotor<T>, weight: T) {
        let frame = self.model[joint].rotor();
        let own = frame.reverse() * rotor * frame;
        let part = if weight == T::ONE { own } else { Rotor::IDENTITY.slerp(own, weight) };
        self.pose[joint] = self.pose[joint] * part;
    }

    /// Works the model motors of a joint and of all below it out anew.
    fn update(&mut self, top: usize) {
        let group = usize::from(self.skeleton.joints()[top].group_size);
        for joint in top..top + group {
            let (local, parent) = (self.pose[joint], self.skeleton.parent(joint));
            self.model[joint] = parent.map_or(local, |parent| self.model[parent] * local);
        }
    }
}

fn finite<V>(what: &'static str, value: V, is_finite: impl Fn(&V) -> bool) -> Result<V, IkError> {
    if is_finite(&value) { Ok(value) } else { Err(IkError::NonFinite { what }) }
}

/// A direction made unit; it must have a length.
fn unit<T: Real>(what: &'static str, direction: Direction<T>) -> Result<Direction<T>, IkError> {
    finite(what, direction, |direction| direction.is_finite())?.normalize().ok_or(IkError::NoDirection { what })
}

/// The turn by the smallest angle that carries one unit direction to another; between opposite ones half a turn about `spare`, which is
/// perpendicular to them.
fn shortest_turn<T: Real>(from: Direction<T>, to: Direction<T>, spare: Direction<T>) -> Rotor<T> {
    let plane = |normal: Direction<T>| UnitPlane::new(normal.x, normal.y, normal.z, T::ZERO);
    match Motor::between_planes(plane(from), plane(to)) {
        Some(motor) => motor.rotor(),
        None => about(spare, T::PI),
    }
}

/// The turn about a unit axis that brings a direction to the side of another; the identity where either runs along the axis.
fn twist<T: Real>(axis: Direction<T>, from: Direction<T>, to: Direction<T>) -> Rotor<T> {
    match (perpendicular(from, axis), perpendicular(to, axis)) {
        // Sine and cosine instead of the shortest turn, whose axis would be as far off as these are from perpendicular.
        (Some(from), Some(to)) => about(axis, axis.dot(from.cross(to)).atan2(from.dot(to))),
        _ => Rotor::IDENTITY,
    }
}

/// The turn about a unit direction.
fn about<T: Real>(axis: Direction<T>, angle: T) -> Rotor<T> {
    Rotor::from_axis_angle(axis, angle).expect("invariant: an axis is a unit direction and an angle is finite")
}

/// What of a direction is perpendicular to a unit direction, made unit; `None` where rounding errors are all there is.
fn perpendicular<T: Real>(direction: Direction<T>, to: Direction<T>) -> Option<Direction<T>> {
    let direction = direction.normalize()?;
    let rest = direction - to * direction.dot(to);
    // Both are unit up to a few roundings.
    if rest.norm() <= T::from_ratio(16, 1) * T::EPSILON { None } else { rest.normalize() }
}

/// Some unit direction perpendicular to a unit direction.
fn any_perpendicular<T: Real>(to: Direction<T>) -> Direction<T> {
    let axis = if to.x.abs() <= to.y.abs() && to.x.abs() <= to.z.abs() {
        Direction::X
    } else if to.y.abs() <= to.z.abs() {
        Direction::Y
    } else {
        Direction::Z
    };
    perpendicular(axis, to).expect("invariant: the axis that is least along a direction is not parallel to it")
}
