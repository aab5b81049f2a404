//! What multiplies to what: signatures, basis blades, their signs, Cayley tables; labels of blades. Exact, and no symbols
//! yet.
//!
//! Blades are kept in ascending order of generators ([`Blade`]); names and orientations that a user chose
//! (`e31` = -`e13`) live in the [`Basis`] alone and matter only where text comes in or goes out.

mod basis;
mod blade;
mod cayley;
mod gf3;
mod signature;

pub use basis::{Basis, BasisError, BasisErrorKind, NamedBlade};
pub use blade::{Blade, Sign};
pub use cayley::{Product, table};
pub use signature::Signature;
