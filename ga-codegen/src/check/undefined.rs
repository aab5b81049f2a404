//! Inputs at which a definition has no value.

use std::fmt;

use super::Coefficient;
use crate::reference::Multivector;

/// Inputs at which the definition has no value, so that no answer is right or wrong: the strategies are to leave them out.
#[derive(Clone, Debug, PartialEq)]
pub struct Undefined<T> {
    /// The definition.
    pub definition: String,
    /// The inputs by name, in the order of the function.
    pub inputs: Vec<(String, Multivector<T>)>,
    /// Why it has none.
    pub reason: DomainError,
}

impl<T: Coefficient> fmt::Display for Undefined<T> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        writeln!(f, "expected inputs at which `{}` has a value, found", self.definition)?;
        write_inputs(f, &self.inputs)?;
        write!(f, "no value: {}", self.reason)
    }
}

impl<T: Coefficient> std::error::Error for Undefined<T> {}

/// Why a definition has no value.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum DomainError {
    /// The argument of exp is no bivector.
    Bivector {
        /// A blade that it has.
        blade: String,
    },
    /// The argument of log or sqrt is no unit.
    Unit {
        /// Where m ~m differs from 1 by more than rounding explains.
        blade: String,
    },
    /// A square is not a scalar and a part of square 0 that commutes.
    ClosedForm,
    /// A bivector has a positive square.
    Hyperbolic,
    /// The logarithm of -1, or of the negative of a translator.
    Branch,
    /// What is normalised has a norm that is not positive, as far as rounding tells; under a root that is 1 + m.
    Norm,
    /// Something leaves the range of `f64`.
    Range,
    /// The arithmetic of the coefficients panicked with this text, such as that of exact ones that are too large.
    Panic(String),
}

impl fmt::Display for DomainError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Bivector { blade } => write!(f, "expected a bivector as the argument of exp, found one with {blade}"),
            Self::Unit { blade } => {
                write!(f, "expected a unit m, m ~m = 1, found another, by the coefficient of {blade} in m ~m")
            }
            Self::ClosedForm => {
                f.write_str("expected a square that is a scalar and a commuting part of square 0, found another")
            }
            Self::Hyperbolic => f.write_str("expected a bivector whose square is not positive, found another"),
            Self::Branch => f.write_str("expected a motion with one logarithm, found -1 or a negative translator"),
            Self::Norm => {
                f.write_str("expected a positive norm, found one that is 0 or negative, or that rounding may have made")
            }
            Self::Range => f.write_str("expected numbers in the range of f64, found one beyond"),
            Self::Panic(text) => write!(f, "a panic of the coefficients' arithmetic: {text}"),
        }
    }
}

impl std::error::Error for DomainError {}

/// A line for each input.
pub(super) fn write_inputs<T: Coefficient>(
    f: &mut fmt::Formatter<'_>,
    inputs: &[(String, Multivector<T>)],
) -> fmt::Result {
    inputs.iter().try_for_each(|(name, value)| writeln!(f, "    {name} = {value}"))
}
