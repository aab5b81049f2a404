//! The naive numeric multivector: the oracle that everything fast is tested against.
//!
//! A [`Multivector`] maps words to coefficients. A word lists generators, `e0 e1 e2`, and the whole arithmetic is
//! what one would do on paper: write two words side by side, put the letters in order one swap of neighbours at a
//! time, change the sign at each swap, and replace two equal neighbours by the square of the generator. The regressive
//! product sums over shuffles of a word, and asks no dual for help. It is slow on purpose. A reader should be able to
//! see that it is right without trusting anything else.
//!
//! # Invariant
//!
//! This module takes from the rest of the crate the value [`Signature`](crate::algebra::Signature) and nothing else:
//! it works out for itself what each generator squares to. A mistake in the algebra, in the symbolic layer or in an
//! emitted program therefore cannot hide by being here as well.
//!
//! # Conventions
//!
//! Signatures run to [`Signature::MAX_DIMENSION`](crate::algebra::Signature::MAX_DIMENSION) generators. A blade is
//! written `1`, or `e` and the digits of distinct generators in any order, with the sign of that order:
//! `e31` is `-e13`. The pseudoscalar is the word of all generators in ascending order. The dual is the right
//! complement, `X ^ dual(X)` = pseudoscalar for every basis blade X.
//!
//! # Example
//!
//! ```
//! use ga_codegen::algebra::Signature;
//! use ga_codegen::reference::{Multivector, ReferenceError};
//!
//! // In plane-based 3D PGA a translator by 12 along z moves the point (1, 2, 3) to (1, 2, 15).
//! let pga3d = Signature::new(3, 0, 1);
//! let translator = Multivector::from_blades(pga3d, [("1", 1), ("e03", -6)])?;
//! let point = Multivector::from_blades(pga3d, [("e123", 1), ("e032", 1), ("e013", 2), ("e021", 3)])?;
//! let moved = translator.sandwich(&point);
//! assert_eq!(moved.coefficient("e021"), 15);
//! assert_eq!(moved.to_string(), "-15 e012 + 2 e013 - e023 + e123");
//! # Ok::<(), ReferenceError>(())
//! ```

mod error;
mod multivector;
mod notation;
mod number;
mod product;
mod unary;
mod word;

pub use error::ReferenceError;
pub use multivector::Multivector;
pub use number::{Number, Real};
