//! Many at once: operations on blocks of motors, points, lines and planes, in vector registers as wide as the machine has.
//!
//! [`Blocks`] keeps [`LANES`] items together coefficient by coefficient, which is the layout that vector instructions want; an array
//! of structs costs several times as much; for those there are `Motor::mul_slice` and its kin. The kernels are proved like those of
//! single items. Which instructions they are compiled to is chosen once per call, at run time: see [`InstructionSet`]. With AVX2 and
//! AVX-512 products are fused with sums, so results differ from those of single items within the rounding errors that the kernels' docs
//! give; those of AVX2 and AVX-512 are the same, bit for bit.
//!
//! ```
//! use pga_motor::batch::Blocks;
//! use pga_motor::f32::{Motor, Point, Rotor};
//!
//! let motors: Blocks<Motor> = (0..100).map(|i| Rotor::about_z(i as f32).into()).collect();
//! let points: Blocks<Point> = (0..100).map(|i| Point::new(i as f32, 0.0, 0.0)).collect();
//! let mut moved = points.clone();
//! motors.transform_points_into(&points, &mut moved)?;
//! let expected = motors.get(7).unwrap().transform_point(Point::new(7.0, 0.0, 0.0));
//! assert!(moved.get(7).unwrap().distance_to_point(expected) < 1e-5);
//! # Ok::<(), pga_motor::LengthMismatch>(())
//! ```

mod between;
mod blocks;
mod lanes;
mod layout;
mod lines;
mod motors;

mod work;

pub use crate::instructions::InstructionSet;
#[cfg(feature = "std")]
pub use crate::instructions::with_instruction_set;
pub(crate) use between::{Pair, Travel, Way, along_screws, between_slices, choose};
pub use blocks::{Blocks, Iter, LANES};
pub use lanes::Lanewise;
pub(crate) use lanes::sealed::Fusible;
pub(crate) use motors::product;
pub(crate) use work::{LaneCount, OnBlock};

/// Motors side by side.
pub(crate) type MotorBlock<T> = blocks::Block<crate::Motor<T>>;

#[cfg(test)]
mod tests;
