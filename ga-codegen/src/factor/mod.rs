//! From a specification to a cheap program. Nothing here is trusted: whatever comes out is proved before it is emitted,
//! so this part may be as clever as it likes.

mod cube;
mod extract;
mod study;
mod system;
mod variants;

use crate::algebra::Sign;
use crate::kernel::{Analytic, Specification};
use crate::program::{Count, Operation, Program, ProgramBuilder};
use crate::symbolic::{Overflow, Polynomial};
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

/// How many of the polynomials that are equal modulo the relations are factored, those cheapest to expand first.
const STARTING_POINTS: usize = 3;

/// Finds a cheap program for a specification.
///
/// # Errors
/// [`FactorError`]
pub fn factor(specification: &Specification) -> Result<Program, FactorError> {
    let mut builder = ProgramBuilder::new();
    let inputs: Vec<_> = (0..specification.coefficients.len()).map(|i| builder.push(Operation::Input(i))).collect();
    let outputs = match specification.analytic {
        None => {
            let mut systems: Vec<_> = variants::variants(specification)?
                .iter()
                .map(|outputs| System::new(outputs, inputs.len()))
                .collect::<Result<_, _>>()?;
            systems.sort_by_key(System::cost);
            systems.truncate(STARTING_POINTS);
            let cheapest = systems.into_iter().map(extract::extract).min_by_key(System::cost);
            cheapest.map(|system| system.build(&mut builder, &inputs)).unwrap_or_default()
        }
        Some(Analytic::Exp) => study::exp(specification, &mut builder, &inputs)?,
        Some(Analytic::Log) => study::log(specification, &mut builder, &inputs)?,
    };
    Ok(builder.finish(&outputs))
}

/// The program that evaluates polynomials in the inputs, for what is no kernel: the excess of a type's relations.
///
/// # Errors
/// [`FactorError`]
pub fn factor_polynomials(polynomials: &[Polynomial], input_count: usize) -> Result<Program, FactorError> {
    let mut builder = ProgramBuilder::new();
    let inputs: Vec<_> = (0..input_count).map(|i| builder.push(Operation::Input(i))).collect();
    let outputs = extract::extract(System::new(polynomials, input_count)?).build(&mut builder, &inputs);
    Ok(builder.finish(&outputs))
}

fn oriented(polynomial: Polynomial, sign: Sign) -> Polynomial {
    if sign.is_minus() { polynomial.neg() } else { polynomial }
}

/// The multiplications and additions of the definition expanded, nothing shared; `None` for an analytic kernel.
///
/// # Errors
/// [`Overflow`]
pub fn expanded_count(specification: &Specification) -> Result<Option<Count>, Overflow> {
    if specification.analytic.is_some() {
        return Ok(None);
    }
    let (flops, mul) = System::new(&specification.outputs(), specification.coefficients.len())?.cost();
    Ok(Some(Count { mul, add: flops - mul, ..Count::default() }))
}
