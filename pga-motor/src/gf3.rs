//! Components of motors in GF(3), the field of three elements -1, 0 and +1: a published check, and the grading that
//! products do keep.
//!
//! # The published check
//!
//! The parts of a motor have [trits](Trit): translation (e01, e02, e03) +1 PLUS, rotation (e23, e31, e12) 0 ERGODIC,
//! identity (the scalar) -1 MINUS; e0123 has none. [`verify_motor_gf3`] adds the trits of the parts that are there and
//! calls the motor *conserved* where the sum is 0 modulo 3:
//!
//! | translation | rotation | identity | sum | conserved | for example |
//! |---|---|---|---|---|---|
//! | - | - | - | 0 | yes | 0, e0123 |
//! | - | - | there | -1 | no | the identity |
//! | - | there | - | 0 | yes | half a turn about an axis through the origin, sliding or not |
//! | - | there | there | -1 | no | any other turn about such an axis |
//! | there | - | - | +1 | no | a line at infinity; no motor |
//! | there | - | there | 0 | yes | a translation |
//! | there | there | - | +1 | no | half a turn about any other axis, sliding or not |
//! | there | there | there | 0 | yes | any other turn about any other axis, any other screw |
//!
//! So it is a check of presence: conserved exactly where translation and identity are both there or both not. It is no
//! invariant of motion. The product of two conserved motors need not be conserved: two half turns about one axis
//! through the origin make the identity, up to sign. Nor does it stay when a motion is seen from elsewhere: half a
//! turn about an axis through the origin is conserved, about a parallel one it is not. And a motor that is conserved
//! need not be right: no error in a coefficient is found that does not make it appear or vanish. For that see
//! [`Motor::satisfies_relations`](crate::Motor::satisfies_relations).
//!
//! ```
//! use pga_motor::f64::{Direction, Motor, Rotor, Translator};
//! use pga_motor::gf3::{Tolerances, verify_motor_gf3};
//!
//! let step = Translator::from_vector(Direction::X);
//! let turn = Rotor::about_z(1.0);
//! let conserved = |motor: Motor| verify_motor_gf3(motor, Tolerances::published());
//! assert!(conserved(step.into()) && conserved(step * turn));
//! assert!(!conserved(turn.into()) && !conserved(Motor::IDENTITY));
//! ```
//!
//! # The grading
//!
//! Of all ways to give the even basis blades trits, three are additive, so that the product of two blades, where it is
//! not 0, has the sum of their trits: all 0, the degree in e0, which is 0 without e0 and 1 with it, and the negative of
//! that. The published trits are not: they break 18 of the 48 products of two even blades that are not 0 where e0123,
//! which they leave out, is +1, and 30 where it is 0 or -1. The simplest: e23 e23 = -1, but 0 + 0 is not -1.
//!
//! The degree in e0 is a grading because e0 squares to 0: a product either keeps every e0 or is 0. Every entity
//! carries it as `NULL_DEGREES`, beside the published `TRIT_LABELS`; [`e0_degree`] is that of an element. At run time
//! its law is that a change of the unit of length, e0 to k e0, may be done before or after any product and any motion:
//!
//! ```
//! use pga_motor::f64::{Direction, Motor, Point, Rotor, Translator};
//!
//! let a: Motor = Translator::from_vector(Direction::new(3.0, 0.0, 1.0)) * Rotor::about_x(2.0);
//! let b: Motor = Rotor::about_z(1.0) * Translator::from_vector(Direction::Y);
//! let point = Point::new(1.0, 2.0, 3.0);
//! // From metres to halves of them; a power of two rounds nothing.
//! assert_eq!((a * b).rescale_e0(2.0), a.rescale_e0(2.0) * b.rescale_e0(2.0));
//! assert_eq!((a >> point).rescale_e0(2.0), a.rescale_e0(2.0) >> point.rescale_e0(2.0));
//! assert_eq!(point.rescale_e0(2.0), Point::new(2.0, 4.0, 6.0));
//! ```

mod grading;
mod presence;
mod triad;
mod trit;

pub use grading::e0_degree;
pub use presence::{Component, Presence, Tolerances, verify_motor_gf3};
pub use triad::{Balance, Triad};
pub use trit::Trit;

#[cfg(test)]
mod tests;
