//! Write a geometric operation once, in geometric algebra; get straight-line Rust at few operations, proved equal to
//! what you wrote.
//!
//! A *definition block* names a signature, a basis, typed multivectors (*entities*) and *kernels*, functions whose
//! meaning is one expression:
//!
//! ```text
//! signature (2, 0, 0);
//! basis 1 e1 e2 e12;
//! entity Vector { x: e1, y: e2 }
//! entity Rotor { c: 1, s: e12 } where c*c == 1 - s*s;
//! kernel rotor_transform_vector(r: Rotor, v: Vector) -> Vector = r * v * ~r;
//! ```
//!
//! [`expand`] is the whole way of such a block, a stage a module:
//! 1. the block is parsed and its names resolved, into a [`kernel::Definition`];
//! 2. every kernel is expanded to exact polynomials in its inputs' coefficients, a [`kernel::Specification`], with the
//!    relations that its types promise (the rotor's `c*c == 1 - s*s`);
//! 3. [`factor`] finds a cheap [`program::Program`];
//! 4. [`proof`] evaluates that program back to polynomials, or to power series for `exp` and `log`, and compares it with the
//!    specification modulo the relations. What the output type promises is proved as well;
//! 5. [`emit`] writes Rust, generic over the scalar.
//!
//! A program without proof is a compile error, so whatever step 3 does cannot make the result wrong. The definitions of 2D
//! and 3D projective geometric algebra come along, see [`preset`]. [`reference`](mod@reference) is a naive multivector that
//! shares no code with all this, to test against; the feature `check` adds `check`, which tests your own code against it.
//!
//! The block's grammar is that of [`expand`].

pub mod algebra;
pub mod approximation;
#[cfg(feature = "check")]
pub mod check;
mod compile;
pub mod emit;
mod errors;
mod expand;
pub mod factor;
pub mod kernel;
mod limits;
mod lower;
pub mod preset;
pub mod program;
pub mod proof;
pub mod reference;
pub mod symbolic;
mod syntax;

pub use compile::{Compiled, Part, Task, compile, tasks};
pub use expand::{define, expand};
