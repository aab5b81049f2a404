//! Programs that a search has found, written down row by row.

use super::{CostModel, LANES};
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

/// The rows of a program on four lanes.
#[derive(Clone, Debug)]
pub struct PackedRecipe {
    /// The kernel.
    pub kernel: String,
    /// The rows in order.
    pub rows: Vec<PackedRow>,
    /// Where the kernel's name stands.
    pub span: Span,
}

/// A row of a packed recipe.
#[derive(Clone, Debug)]
pub enum PackedRow {
    /// A name and its value.
    Named(String, PackedTerm),
    /// The fields of the output that the lanes of a value are.
    Outputs([Option<String>; LANES], PackedTerm),
}

/// A value of four lanes in a recipe, grouped as written.
#[derive(Clone, Debug)]
pub enum PackedTerm {
    /// An earlier row.
    Name(String),
    /// `[a.s, a.e23, 0, 1]`
    Load([PackedSource; LANES]),
    /// `v[-0, 1, 3, 2]`: which lanes of the value, and which of them negated.
    Lanes(Box<PackedTerm>, [(bool, u8); LANES]),
    /// 2 a
    Double(Box<PackedTerm>),
    /// a + b
    Add(Box<PackedTerm>, Box<PackedTerm>),
    /// a - b
    Sub(Box<PackedTerm>, Box<PackedTerm>),
    /// a * b
    Mul(Box<PackedTerm>, Box<PackedTerm>),
}

/// What a lane is loaded with.
#[derive(Clone, Debug)]
pub enum PackedSource {
    /// An input coefficient such as `m.e23`.
    Name(String),
    /// A number.
    Number(Rational),
}
