//! Exact polynomials over named coefficients, multivectors of them, what a type's relations make equal, and truncated
//! power series. Every operation is checked: overflow is an error, never a wrap.

pub(crate) mod effort;
mod multivector;
mod polynomial;
mod rational;
mod relations;
mod series;

pub use multivector::Multivector;
pub use polynomial::{Monomial, Polynomial, Symbol};
pub use rational::{Overflow, Rational};
pub use relations::{Relation, Relations, RelationsError};
pub(crate) use series::reciprocal_factorial;
pub use series::{Series, SeriesError, SeriesRing};
