//! The naive numeric multivector: an oracle to test anybody's geometric algebra against, this crate's or your own.
//!
//! A [`Multivector`] maps words to coefficients. A word lists generators, `e0 e1 e2`, and the whole arithmetic is
//! what one would do on paper: write two words side by side, put the letters in order one swap of neighbours at a
//! time, change the sign at each swap, and replace two equal neighbours by the square of the generator. The regressive
//! product sums over shuffles of a word, and asks no dual for help. It is slow on purpose. A reader should be able to
//! see that it is right without trusting anything else.
//!
//! # As an oracle
//!
//! Take the coefficients of your own types, do on the reference what your code claims to do, and compare. The
//! coefficients are any ring, see [`Number`]: with whole or rational numbers the comparison needs no tolerance, and a
//! wrong sign shows at almost every value. Here one is found in a formula for the line through two points:
//!
//! ```
//! use ga_codegen::algebra::Signature;
//! use ga_codegen::reference::Multivector;
//!
//! /// The join of two points of the plane, as the coefficients of e1, e2 and e0.
//! fn join([a, b]: [i64; 2], [c, d]: [i64; 2]) -> [i64; 3] {
//!     [b - d, c - a, a * d + b * c]
//! }
//!
//! let pga2d = Signature::new(2, 0, 1);
//! let point = |x: i64, y: i64| Multivector::from_blades(pga2d, [("e12", 1), ("e20", x), ("e01", y)]);
//! let expected = point(1, 2)?.regressive(&point(4, 6)?);
//! let [a, b, c] = join([1, 2], [4, 6]);
//! let found = Multivector::from_blades(pga2d, [("e1", a), ("e2", b), ("e0", c)])?;
//! assert_eq!(expected.to_string(), "-2 e0 - 4 e1 + 3 e2");
//! assert_eq!(found.to_string(), "14 e0 - 4 e1 + 3 e2"); // a d - b c was meant.
//! # Ok::<(), ga_codegen::reference::ReferenceError>(())
//! ```
//!
//! - In and out: [`from_blades`](Multivector::from_blades), [`parse`](Multivector::parse),
//!   [`scalar`](Multivector::scalar), [`coefficient`](Multivector::coefficient), [`blades`](Multivector::blades),
//!   `Display`.
//! - Linear: [`add`](Multivector::add), [`sub`](Multivector::sub), [`neg`](Multivector::neg),
//!   [`scale`](Multivector::scale), [`grade`](Multivector::grade).
//! - Products: [`geometric`](Multivector::geometric), [`outer`](Multivector::outer),
//!   [`regressive`](Multivector::regressive), [`inner`](Multivector::inner),
//!   [`left_contraction`](Multivector::left_contraction), [`right_contraction`](Multivector::right_contraction),
//!   [`scalar_product`](Multivector::scalar_product), [`commutator`](Multivector::commutator),
//!   [`anticommutator`](Multivector::anticommutator), [`sandwich`](Multivector::sandwich), all of them as a
//!   [`table`].
//! - Involutions and duals: [`reverse`](Multivector::reverse), [`grade_involution`](Multivector::grade_involution),
//!   [`clifford_conjugate`](Multivector::clifford_conjugate), [`dual`](Multivector::dual),
//!   [`undual`](Multivector::undual).
//! - Norms: [`norm_squared`](Multivector::norm_squared), [`ideal_norm_squared`](Multivector::ideal_norm_squared),
//!   of [`Real`] coefficients [`norm`](Multivector::norm), [`ideal_norm`](Multivector::ideal_norm),
//!   [`normalize`](Multivector::normalize).
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
mod number_text;
mod product;
mod table;
mod terms;
mod unary;
mod word;

pub use error::{ParseError, ReferenceError};
pub use multivector::Multivector;
pub use number::{Number, Real};
pub use table::table;
