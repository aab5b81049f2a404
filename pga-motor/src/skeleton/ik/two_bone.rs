//! Arms and legs.

use super::{IkError, Posed, Reach, about, any_perpendicular, finite, perpendicular, shortest_turn, twist, unit};
use crate::skeleton::Skeleton;
use crate::{Direction, Motor, Point, Real, Rotor};

/// Two bones that reach for a point, as an arm or a leg does: the one from the joint `start` to `mid`, and the one from `mid` to `end`.
///
/// The joint `mid` bends in the plane that it bends in already, and `start` turns the whole. Between them there may be other joints,
/// which keep their local motors, and so may there be below `end`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TwoBone<T> {
    /// The shoulder or hip.
    pub start: usize,
    /// The elbow or knee, below `start`.
    pub mid: usize,
    /// The hand or foot, below `mid`.
    pub end: usize,
    /// Where the joint `end` is to get, in the skeleton's space.
    pub target: Point<T>,
    /// The side on which `mid` is to be, seen from the line between `start` and the target, in the skeleton's space: where an elbow or
    /// knee points. Without it, or where it is parallel to that line, nothing twists.
    pub pole: Option<Direction<T>>,
    /// The axis in the frame of `mid` about which it bends, counter-clockwise for a bone that folds up, where the bones are straight
    /// and so do not tell. Without it, or where it runs along the bone, it is some axis perpendicular to the bone.
    pub hinge: Option<Direction<T>>,
    /// How much of the turns is applied: 1 is all. Part of them reaches for the target along arcs.
    pub weight: T,
}

impl<T: Real> TwoBone<T> {
    /// Bones that reach for a point with neither pole nor hinge, with all their weight.
    pub const fn new(start: usize, mid: usize, end: usize, target: Point<T>) -> Self {
        Self { start, mid, end, target, pole: None, hinge: None, weight: T::ONE }
    }

    /// Turns `start` and `mid` in a pose, and brings the model motors of `start` and all below it up to date.
    ///
    /// `pose` and `model` have one motor for each joint; `model` belongs to `pose`. What the result means, the target in reach or not,
    /// [`Reach`] says.
    ///
    /// # Errors
    /// [`IkError`]: no such joint, one not below the other, bones of no length, a hinge or pole of length 0, something not finite,
    /// buffers of another length; the pose is then as it was.
    ///
    /// ```
    /// use pga_motor::f64::{Direction, Motor, Point, Translator};
    /// use pga_motor::skeleton::{Reach, Skeleton, TwoBone, local_to_model};
    ///
    /// let along_x = |length| Motor::from(Translator::from_vector(Direction::new(length, 0.0, 0.0)));
    /// let joints = [("shoulder", None, along_x(0.0)), ("elbow", Some(0), along_x(3.0)), ("hand", Some(1), along_x(2.0))];
    /// let (arm, _) = Skeleton::from_parents(joints)?;
    /// let (mut pose, mut model) = (arm.rest_pose().clone(), vec![Motor::IDENTITY; 3]);
    /// local_to_model(&arm, &pose, &mut model)?;
    ///
    /// let target = Point::new(1.0, 3.0, 2.0);
    /// let reach = TwoBone::new(0, 1, 2, target).solve(&arm, &mut pose, &mut model)?;
    /// assert_eq!(reach, Reach::Reached);
    /// assert!(model[2].transform_origin().distance_to_point(target) < 1e-14);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn solve(
        &self,
        skeleton: &Skeleton<T>,
        pose: &mut [Motor<T>],
        model: &mut [Motor<T>],
    ) -> Result<Reach, IkError> {
        let mut posed = Posed::new(skeleton, pose, model)?;
        let (start, mid, end) = (posed.place(self.start)?, posed.place(self.mid)?, posed.place(self.end)?);
        posed.require_below(self.mid, self.start)?;
        posed.require_below(self.end, self.mid)?;
        let target = finite("target", self.target, |target| target.is_finite())?;
        let weight = finite("weight", self.weight, |weight| weight.is_finite())?;
        let hinge = self.hinge.map(|hinge| unit("hinge", hinge)).transpose()?;
        let pole = self.pole.map(|pole| unit("pole", pole)).transpose()?;
        let upper = Bone::between(self.start, mid - start, self.mid)?;
        let lower = Bone::between(self.mid, end - mid, self.end)?;

        let (distance, reach) = attainable(start.distance_to_point(target), upper.length, lower.length);
        let hinge = hinge.map(|hinge| posed.model[self.mid].transform_direction(hinge));
        let axis = bending_axis(upper.direction, lower.direction, hinge);
        let bend = about(axis, bend(upper, lower, distance));
        let bent = upper.direction * upper.length + bend.transform_direction(lower.direction) * lower.length;
        // Where the bones fold up to nothing, the lower one says where they pointed.
        let along = bent.normalize().unwrap_or(upper.direction);
        let goal = (target - start).normalize().unwrap_or(along);
        let swing = shortest_turn(along, goal, axis);
        let side = swing.transform_direction(upper.direction);
        let turn = pole.map_or(Rotor::IDENTITY, |pole| twist(goal, side, pole)) * swing;
        // The bend is that of the frame in which the upper bone has not turned yet; as both turns are in the joints' own frames,
        // their order does not matter.
        posed.turn(self.mid, bend, weight);
        posed.turn(self.start, turn, weight);
        posed.update(self.start);
        Ok(reach)
    }
}

/// The straight line from one joint to another.
#[derive(Clone, Copy)]
struct Bone<T> {
    direction: Direction<T>,
    length: T,
}

impl<T: Real> Bone<T> {
    fn between(from: usize, vector: Direction<T>, to: usize) -> Result<Self, IkError> {
        let direction = vector.normalize().ok_or(IkError::NoBone { from, to })?;
        Ok(Self { direction, length: vector.norm() })
    }
}

/// The distance nearest to the one asked for that two bones can span, and whether it is that one.
fn attainable<T: Real>(asked: T, upper: T, lower: T) -> (T, Reach) {
    let (longest, shortest) = (upper + lower, (upper - lower).abs());
    if asked > longest {
        (longest, Reach::TooFar)
    } else if asked == T::ZERO {
        (shortest, Reach::NoDirection)
    } else if asked < shortest {
        (shortest, Reach::TooNear)
    } else {
        (asked, Reach::Reached)
    }
}

/// The unit axis about which the lower bone bends, perpendicular to the upper one.
fn bending_axis<T: Real>(upper: Direction<T>, lower: Direction<T>, hinge: Option<Direction<T>>) -> Direction<T> {
    let bent = perpendicular(lower, upper).and_then(|side| upper.cross(side).normalize());
    let hinged = || hinge.and_then(|hinge| perpendicular(hinge, upper));
    bent.or_else(hinged).unwrap_or_else(|| any_perpendicular(upper))
}

/// The angle by which the lower bone bends further so that the bones span a distance that they can span. Angles are those between the
/// bones' directions: 0 is straight.
///
/// By the law of cosines for half angles, which loses nothing where the bones are nearly straight or folded: of the triangle's angle
/// between bones a and b, opposite to c, the sine and cosine of the half are the roots of (c - a + b) (c + a - b) and
/// (a + b - c) (a + b + c), both over 4 a b.
fn bend<T: Real>(upper: Bone<T>, lower: Bone<T>, distance: T) -> T {
    let now = upper.direction.cross(lower.direction).norm().atan2(upper.direction.dot(lower.direction));
    // In units of the longer bone, so that squares stay in range.
    let unit = if upper.length > lower.length { upper.length } else { lower.length };
    let (a, b, c) = (upper.length / unit, lower.length / unit, distance / unit);
    // Rounding may take a bound of the distance past itself.
    let root = |square: T| if square > T::ZERO { square.sqrt() } else { T::ZERO };
    let (sine, cosine) = (root((c - a + b) * (c + a - b)), root((a + b - c) * (a + b + c)));
    T::from_ratio(2, 1) * cosine.atan2(sine) - now
}
