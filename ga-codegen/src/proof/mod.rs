//! Proves that a program computes what a kernel is defined as.
//!
//! A polynomial kernel's program is evaluated on the symbols of the inputs; every output must equal the specified
//! polynomial modulo the inputs' relations, that is, their difference must have normal form 0.
//!
//! The program of `normalize` or `sqrt` is evaluated on fractions of such polynomials in which roots are symbols (file
//! `root`); that of `exp` or `log` on power series, and on polynomials where the series have no value (`exponential`, `locus`).
//!
//! This folder knows nothing of how programs are found.

mod exponential;
mod locus;
mod root;

use crate::approximation::Function;
use crate::kernel::{Analytic, Specification};
use crate::program::{Domain, Program};
use crate::symbolic::{Overflow, Polynomial, Rational, SeriesError, Symbol};
use std::fmt;

pub use exponential::ORDER;

/// What has been proved.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Proof {
    /// Equal as polynomials modulo the relations of the inputs.
    Exact,
    /// Equal as polynomials in the inputs and in the square roots that the program takes, modulo the relations, wherever no
    /// denominator is 0.
    Roots,
    /// Equal as formal power series up to this total degree, and exactly where the norm of the bivector is 0.
    Series(usize),
}

impl fmt::Display for Proof {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Exact => f.write_str("exact"),
            Self::Roots => f.write_str("exact, roots included"),
            Self::Series(order) => write!(f, "series to order {order}"),
        }
    }
}

/// Why a program is not proved.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Refutation {
    /// [`Overflow`]
    Overflow,
    /// The program has another number of outputs than the type has fields.
    OutputCount,
    /// The program uses an operation that has no meaning here, or the definition has none.
    Undefined(String),
    /// The output type does not have this blade, and the definition does.
    CannotHold(String),
    /// A coefficient of the output differs: its name, and the normal form of program minus definition.
    Different(String, String),
    /// The program breaks a promise of the output type: the relation and the normal form of the excess.
    BrokenPromise(String, String),
    /// A series is known to too low an order: its name, and the order to which it should be known.
    Imprecise(String, usize),
}

impl From<Overflow> for Refutation {
    fn from(_: Overflow) -> Self {
        Self::Overflow
    }
}

impl From<SeriesError> for Refutation {
    fn from(error: SeriesError) -> Self {
        match error {
            SeriesError::Overflow => Self::Overflow,
            other => Self::Undefined(other.to_string()),
        }
    }
}

impl fmt::Display for Refutation {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Overflow => Overflow.fmt(f),
            Self::OutputCount => f.write_str("the program has another number of outputs than its type has fields"),
            Self::Undefined(text) => f.write_str(text),
            Self::CannotHold(name) => write!(f, "expected an output that can hold `{name}`, found none"),
            Self::Different(name, difference) => {
                write!(f, "coefficient `{name}`: program minus definition is {difference}")
            }
            Self::BrokenPromise(relation, excess) => write!(f, "relation `{relation}`: the difference is {excess}"),
            Self::Imprecise(name, order) => write!(f, "coefficient `{name}`: the series is not known to order {order}"),
        }
    }
}

impl std::error::Error for Refutation {}

/// Proves a program equal to its specification.
///
/// # Errors
/// The first [`Refutation`].
pub fn prove(specification: &Specification, program: &Program) -> Result<Proof, Refutation> {
    if program.outputs.len() != specification.fields.len() {
        return Err(Refutation::OutputCount);
    }
    match specification.analytic {
        None => prove_polynomials(specification, program),
        Some(Analytic::Exp | Analytic::Log) => exponential::prove(specification, program),
        Some(Analytic::Normalize | Analytic::Sqrt) => root::prove(specification, program),
    }
}

fn prove_polynomials(specification: &Specification, program: &Program) -> Result<Proof, Refutation> {
    let inputs: Vec<_> = (0..specification.coefficients.len()).map(|s| Polynomial::symbol(s as Symbol)).collect();
    let computed = program.evaluate(&PolynomialDomain, &inputs)?;
    let names = specification.names();
    for ((field, computed), specified) in specification.fields.iter().zip(&computed).zip(&specification.outputs) {
        let difference = specification.relations.difference(computed, specified)?;
        if !difference.is_zero() {
            let field = if field.is_empty() { "1" } else { field };
            return Err(Refutation::Different(field.to_owned(), difference.display(&names)));
        }
    }
    Ok(Proof::Exact)
}

/// Proves that a program computes these polynomials of its inputs, identically.
///
/// # Errors
/// The first [`Refutation`].
pub fn prove_evaluation(program: &Program, polynomials: &[Polynomial], inputs: usize) -> Result<Proof, Refutation> {
    let inputs: Vec<_> = (0..inputs).map(|symbol| Polynomial::symbol(symbol as Symbol)).collect();
    let computed = program.evaluate(&PolynomialDomain, &inputs)?;
    if computed.len() != polynomials.len() {
        return Err(Refutation::OutputCount);
    }
    for (index, (computed, specified)) in computed.iter().zip(polynomials).enumerate() {
        let difference = computed.sub(specified)?;
        if !difference.is_zero() {
            return Err(Refutation::Different(index.to_string(), difference.display(&[])));
        }
    }
    Ok(Proof::Exact)
}

/// Every value of a program of ring operations, as a polynomial in its inputs; `None` for another program.
pub(crate) fn evaluate_polynomials(program: &Program, inputs: usize) -> Option<Vec<Polynomial>> {
    let inputs: Vec<_> = (0..inputs).map(|symbol| Polynomial::symbol(symbol as Symbol)).collect();
    let all = Program { operations: program.operations.clone(), outputs: (0..program.operations.len()).collect() };
    all.evaluate(&PolynomialDomain, &inputs).ok()
}

fn undefined<T>(text: &str) -> Result<T, Refutation> {
    Err(Refutation::Undefined(text.to_owned()))
}

/// Arithmetic on polynomials.
struct PolynomialDomain;

fn no_polynomial<T>(name: &str) -> Result<T, Refutation> {
    undefined(&format!("expected a program of ring operations, found {name}"))
}

impl Domain for PolynomialDomain {
    type Number = Polynomial;
    type Error = Refutation;

    fn constant(&self, value: Rational) -> Result<Polynomial, Refutation> {
        Ok(Polynomial::constant(value))
    }
    fn add(&self, a: &Polynomial, b: &Polynomial) -> Result<Polynomial, Refutation> {
        Ok(a.add(b)?)
    }
    fn neg(&self, a: &Polynomial) -> Result<Polynomial, Refutation> {
        Ok(a.neg())
    }
    fn mul(&self, a: &Polynomial, b: &Polynomial) -> Result<Polynomial, Refutation> {
        Ok(a.mul(b)?)
    }
    fn div(&self, _: &Polynomial, _: &Polynomial) -> Result<Polynomial, Refutation> {
        no_polynomial("a division")
    }
    fn sqrt(&self, _: &Polynomial) -> Result<Polynomial, Refutation> {
        no_polynomial("a square root")
    }
    fn sin(&self, _: &Polynomial) -> Result<Polynomial, Refutation> {
        no_polynomial("a sine")
    }
    fn cos(&self, _: &Polynomial) -> Result<Polynomial, Refutation> {
        no_polynomial("a cosine")
    }
    fn atan2(&self, _: &Polynomial, _: &Polynomial) -> Result<Polynomial, Refutation> {
        no_polynomial("an arc tangent")
    }
    fn quotient(&self, _: &Polynomial, _: &Polynomial, _: Rational) -> Result<Polynomial, Refutation> {
        no_polynomial("a quotient")
    }
    fn function(&self, function: Function, _: &Polynomial) -> Result<Polynomial, Refutation> {
        no_polynomial(function.name())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::program::Operation;

    #[test]
    fn every_value_of_a_program_of_ring_operations_is_a_polynomial() {
        let operations = vec![Operation::Input(0), Operation::Input(1), Operation::Mul(0, 1), Operation::Double(2)];
        let mut program = Program { operations, outputs: vec![3] };
        let names = ["x".to_owned(), "y".to_owned()];
        let values = evaluate_polynomials(&program, 2).expect("polynomials");
        assert_eq!(values.iter().map(|value| value.display(&names)).collect::<Vec<_>>(), ["x", "y", "x y", "2 x y"]);
        program.operations.push(Operation::Sqrt(0));
        assert_eq!(evaluate_polynomials(&program, 2), None);
    }
}
