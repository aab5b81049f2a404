//! Heads, eyes and turrets.

use super::{IkError, Posed, Reach, any_perpendicular, finite, perpendicular, shortest_turn, twist, unit};
use crate::skeleton::Skeleton;
use crate::{Direction, Motor, Point, Real, Rotor};

/// A joint that turns to look at a point.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Aim<T> {
    /// The joint.
    pub joint: usize,
    /// Where it looks, in its own frame; of any length but 0.
    pub forward: Direction<T>,
    /// From where it looks, in its own frame: the eye of a head. The ray from there in the direction `forward` is to pass through the
    /// target.
    pub offset: Direction<T>,
    /// What to look at, in the skeleton's space.
    pub target: Point<T>,
    /// What in its own frame is to point to the side of the pole, as the top of a head does upwards. Only its part perpendicular to
    /// the way to the target counts; without pole it is not used.
    pub up: Direction<T>,
    /// The side to which `up` is to point, in the skeleton's space. Without it, or where either is parallel to the way to the target,
    /// nothing twists.
    pub pole: Option<Direction<T>>,
    /// How much of the turn is applied: 1 is all.
    pub weight: T,
}

impl<T: Real> Aim<T> {
    /// A joint that turns the shortest way, looking from where it is, with all its weight.
    pub const fn new(joint: usize, forward: Direction<T>, target: Point<T>) -> Self {
        let offset = Direction::new(T::ZERO, T::ZERO, T::ZERO);
        Self { joint, forward, offset, target, up: forward, pole: None, weight: T::ONE }
    }

    /// Turns the joint in a pose, and brings the model motors of it and all below it up to date.
    ///
    /// `pose` and `model` have one motor for each joint; `model` belongs to `pose`. What the result means, [`Reach`] says: with an
    /// offset, a target may be nearer to the joint than the ray passes by it, or its origin further away than the target.
    /// Between opposite directions the joint turns about an axis perpendicular to them, deterministically some one.
    ///
    /// # Errors
    /// [`IkError`]: no such joint, a forward direction or pole of length 0, something not finite, buffers of another length; the pose
    /// is then as it was.
    ///
    /// ```
    /// use pga_motor::f64::{Direction, Motor, Point};
    /// use pga_motor::skeleton::{Aim, Reach, Skeleton};
    ///
    /// let (head, _) = Skeleton::from_parents([("head", None, Motor::IDENTITY)])?;
    /// let (mut pose, mut model) = (head.rest_pose().clone(), vec![Motor::IDENTITY]);
    /// let aim = Aim::new(0, Direction::Z, Point::new(5.0, 0.0, 5.0));
    /// assert_eq!(aim.solve(&head, &mut pose, &mut model)?, Reach::Reached);
    /// let looks = model[0].transform_direction(Direction::Z);
    /// assert!((looks - Direction::new(0.5, 0.0, 0.5) * 2.0_f64.sqrt()).norm() < 1e-15);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn solve(
        &self,
        skeleton: &Skeleton<T>,
        pose: &mut [Motor<T>],
        model: &mut [Motor<T>],
    ) -> Result<Reach, IkError> {
        let mut posed = Posed::new(skeleton, pose, model)?;
        let place = posed.place(self.joint)?;
        let target = finite("target", self.target, |target| target.is_finite())?;
        let weight = finite("weight", self.weight, |weight| weight.is_finite())?;
        let offset = finite("offset", self.offset, |offset| offset.is_finite())?;
        let up = finite("up", self.up, |up| up.is_finite())?;
        let forward = unit("forward", self.forward)?;
        let pole = self.pole.map(|pole| unit("pole", pole)).transpose()?;
        let way = target - place;
        let Some(goal) = way.normalize() else { return Ok(Reach::NoDirection) };

        let seen = match on_ray(offset, forward, way.norm()) {
            Ok(seen) => seen,
            Err(reach) => return Ok(reach),
        };
        let frame = posed.model[self.joint];
        let seen = frame.transform_direction(seen);
        let spare = perpendicular(frame.transform_direction(up), seen).unwrap_or_else(|| any_perpendicular(seen));
        let swing = shortest_turn(seen, goal, spare);
        let raised = swing.transform_direction(frame.transform_direction(up));
        let turn = pole.map_or(Rotor::IDENTITY, |pole| twist(goal, raised, pole)) * swing;
        posed.turn(self.joint, turn, weight);
        posed.update(self.joint);
        Ok(Reach::Reached)
    }
}

/// The unit direction to the point on a ray that is at this distance from the origin; which way it misses where there is none.
fn on_ray<T: Real>(offset: Direction<T>, forward: Direction<T>, distance: T) -> Result<Direction<T>, Reach> {
    // In units of the distance, so that squares stay in range.
    let offset = offset / distance;
    let along = offset.dot(forward);
    let aside = (offset - forward * along).norm();
    if aside > T::ONE {
        return Err(Reach::TooNear);
    }
    let reach = ((T::ONE - aside) * (T::ONE + aside)).sqrt();
    if along > reach {
        return Err(Reach::TooNear);
    }
    let seen = offset + forward * (reach - along);
    Ok(seen.normalize().unwrap_or(forward))
}
