//! From a specification to a cheap program. Nothing here is trusted: whatever comes out is proved before it is emitted,
//! so this part may be as clever as it likes.

mod arrange;
mod cube;
mod extract;
mod packed;
mod recipe;
mod search;
mod starting;
mod study;
mod system;

use crate::approximation::Precision;
use crate::kernel::{Analytic, Specification};
use crate::program::{CostModel, Count, PackedProgram, PackedRecipe, Program, Recipe};
use crate::symbolic::{Overflow, Polynomial};
pub use search::Search;
use std::fmt;
use system::System;

/// Why no program was found.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum FactorError {
    /// [`Overflow`]
    Overflow,
    /// The definition has no closed form known here; the text says what was expected and found.
    NoClosedForm(String),
}

impl From<Overflow> for FactorError {
    fn from(_: Overflow) -> Self {
        Self::Overflow
    }
}

impl fmt::Display for FactorError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Overflow => Overflow.fmt(f),
            Self::NoClosedForm(text) => f.write_str(text),
        }
    }
}

impl std::error::Error for FactorError {}

/// Finds a cheap program for a specification, without much of a search.
///
/// # Errors
/// [`FactorError`]
pub fn factor(specification: &Specification, model: CostModel) -> Result<Program, FactorError> {
    match specification.analytic {
        None => {
            let programs = starting::few(specification)?.into_iter().map(|start| extract::greedy(start).program(model));
            programs.min_by_key(|program| model.cost(Count::of(program))).ok_or_else(|| {
                FactorError::NoClosedForm("expected a starting point of the factoriser, found none".to_owned())
            })
        }
        Some(Analytic::Exp) => study::exp(specification),
        Some(Analytic::Log) => study::log(specification),
        Some(Analytic::Normalize | Analytic::Sqrt) => study::normalize(specification),
    }
}

/// The program for exp or log with polynomials in place of roots, divisions and library calls.
///
/// # Errors
/// [`FactorError`]
pub fn factor_by_polynomials(specification: &Specification, precision: Precision) -> Result<Program, FactorError> {
    match specification.analytic {
        Some(Analytic::Exp) => study::exp_by_polynomials(specification, precision),
        Some(Analytic::Log) => study::log_by_polynomials(specification, precision),
        _ => {
            Err(FactorError::NoClosedForm("expected `exp` or `log` to approximate, found another function".to_owned()))
        }
    }
}

/// The program that a recipe describes, not proved.
///
/// # Errors
/// What does not fit: a name that is neither an input nor an earlier row, or an output that is missing.
pub fn replay(specification: &Specification, recipe: &Recipe) -> Result<Program, String> {
    recipe::replay(specification, recipe)
}

/// The program of a recipe given as text, not proved.
///
/// # Errors
/// Text that is no recipe, or one that does not fit.
pub fn read_recipe(specification: &Specification, text: &str) -> Result<Program, String> {
    let recipe = crate::lower::read_recipe(text).map_err(|error| error.to_string())?;
    replay(specification, &recipe)
}

/// A program of sums and products as a recipe, in the syntax of a definition block.
pub fn write_recipe(specification: &Specification, program: &Program, kernel: &str, model: CostModel) -> String {
    recipe::write(specification, program, kernel, model)
}

/// The program that a packed recipe describes, not proved.
///
/// # Errors
/// What does not fit: a name that is neither an input nor an earlier row, or an output that is missing.
pub fn replay_packed(specification: &Specification, recipe: &PackedRecipe) -> Result<PackedProgram, String> {
    packed::replay(specification, recipe)
}

/// A packed program as a recipe, in the syntax of a definition block.
pub fn write_packed_recipe(specification: &Specification, program: &PackedProgram, kernel: &str) -> String {
    packed::write(specification, program, kernel)
}

/// Finds a packed program with few shuffles for a product; `None` where the definition is not one of two parameters, or has
/// no groups of four coefficients that fit each other. It takes seconds.
pub fn pack(specification: &Specification) -> Option<PackedProgram> {
    arrange::arrange(specification)
}

/// The program that evaluates polynomials in the inputs, for what is no kernel: the excess of a type's relations.
///
/// # Errors
/// [`FactorError`]
pub fn factor_polynomials(polynomials: &[Polynomial], input_count: usize) -> Result<Program, FactorError> {
    Ok(extract::greedy(System::new(polynomials, input_count)?).program(CostModel::default()))
}

/// The multiplications and additions of evaluating the definition product by product, coefficients that no output needs
/// left out; `None` where there is one product only, or none.
///
/// # Errors
/// [`Overflow`]
pub fn staged_count(specification: &Specification) -> Result<Option<Count>, Overflow> {
    if specification.analytic.is_some() || specification.projection.is_some() {
        return Ok(None);
    }
    let cost = starting::staged(specification)?.first().map(System::cost);
    Ok(cost.map(|(flops, mul)| Count { mul, add: flops - mul, ..Count::default() }))
}

/// The multiplications and additions of the definition expanded, nothing shared; `None` for an analytic kernel.
///
/// # Errors
/// [`Overflow`]
pub fn expanded_count(specification: &Specification) -> Result<Option<Count>, Overflow> {
    if specification.analytic.is_some() {
        return Ok(None);
    }
    let (flops, mul) = System::new(&specification.outputs, specification.coefficients.len())?.cost();
    Ok(Some(Count { mul, add: flops - mul, ..Count::default() }))
}
