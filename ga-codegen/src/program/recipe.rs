//! Programs that a search has found, written down row by row.

use super::CostModel;
use crate::symbolic::Rational;
use proc_macro2::Span;

/// The rows of a program, to be replayed instead of searched for. It is trusted as little as any other program.
#[derive(Clone, Debug)]
pub struct Recipe {
    /// The kernel.
    pub kernel: String,
    /// The cost model for which it was searched.
    pub model: CostModel,
    /// Names and values, in order; `out.FIELD` are the outputs, `out` a plain scalar.
    pub rows: Vec<(String, RecipeTerm)>,
    /// Where the kernel's name stands.
    pub span: Span,
}

/// A sum or product in a recipe, grouped as written.
#[derive(Clone, Debug)]
pub enum RecipeTerm {
    /// An input coefficient such as `m.e23`, or an earlier row.
    Name(String),
    /// A number.
    Number(Rational),
    /// -a
    Neg(Box<RecipeTerm>),
    /// 2 a
    Double(Box<RecipeTerm>),
    /// a + b
    Add(Box<RecipeTerm>, Box<RecipeTerm>),
    /// a - b
    Sub(Box<RecipeTerm>, Box<RecipeTerm>),
    /// a * b
    Mul(Box<RecipeTerm>, Box<RecipeTerm>),
}
