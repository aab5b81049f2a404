//! What a check reports.

use std::fmt;

use super::undefined::{Undefined, write_inputs};
use super::{Coefficient, Difference};
use crate::algebra::Signature;
use crate::reference::{Multivector, ReferenceError};

/// Why a check fails.
#[derive(Clone, Debug, PartialEq)]
pub enum CheckError<T> {
    /// The inputs do not fit the definition.
    Inputs(InputError),
    /// The function differs from the definition.
    Counterexample(Box<Counterexample<T>>),
    /// The definition has no value at some inputs.
    Undefined(Box<Undefined<T>>),
    /// The strategies give too few values, as they say.
    Exhausted(String),
}

impl<T> CheckError<T> {
    /// The counterexample, if it is one.
    pub fn counterexample(&self) -> Option<&Counterexample<T>> {
        if let Self::Counterexample(counterexample) = self { Some(counterexample) } else { None }
    }
}

impl<T> From<InputError> for CheckError<T> {
    fn from(error: InputError) -> Self {
        Self::Inputs(error)
    }
}

impl<T: Coefficient> fmt::Display for CheckError<T> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Inputs(error) => error.fmt(f),
            Self::Counterexample(counterexample) => counterexample.fmt(f),
            Self::Undefined(undefined) => undefined.fmt(f),
            Self::Exhausted(reason) => write!(f, "expected strategies that give enough values, found {reason}"),
        }
    }
}

impl<T: Coefficient> std::error::Error for CheckError<T> {}

/// Inputs that do not fit the definition or the function.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum InputError {
    /// A name of the definition has no values.
    Missing {
        /// The name.
        name: String,
    },
    /// Values for a name that the definition does not have.
    Unknown {
        /// The name.
        name: String,
        /// Those that it has.
        known: Vec<String>,
    },
    /// A name has values twice.
    Repeated {
        /// The name.
        name: String,
    },
    /// The function takes more or fewer.
    Count {
        /// How many inputs there are.
        inputs: usize,
        /// How many the function takes.
        parameters: usize,
    },
    /// A value of another algebra.
    Signature {
        /// The input.
        name: String,
        /// The signature of the definition.
        expected: Signature,
        /// That of the value.
        found: Signature,
    },
    /// A number of the definition that the coefficients cannot hold.
    Number {
        /// The number.
        number: String,
    },
    /// A function of the definition whose values are no exact numbers.
    Function {
        /// Its name.
        function: String,
    },
}

impl fmt::Display for InputError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Missing { name } => write!(f, "expected values for the input `{name}`, found none"),
            Self::Unknown { name, known } => {
                let known: Vec<_> = known.iter().map(|name| format!("`{name}`")).collect();
                write!(f, "expected an input of the definition ({}), found `{name}`", known.join(", "))
            }
            Self::Repeated { name } => write!(f, "expected values for each input once, found `{name}` twice"),
            Self::Count { inputs, parameters } => {
                write!(f, "expected a function of as many parameters as inputs, {inputs}, found one of {parameters}")
            }
            Self::Signature { name, expected, found } => {
                write!(f, "expected values of {expected} for the input `{name}`, found one of {found}")
            }
            Self::Number { number } => {
                write!(f, "expected numbers that the coefficients can hold, found `{number}` in the definition")
            }
            Self::Function { function } => {
                write!(
                    f,
                    "expected coefficients in floating point for `{function}`, found exact ones, of which it has no exact value"
                )
            }
        }
    }
}

impl std::error::Error for InputError {}

/// An answer that is no multivector of the signature.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Fault {
    /// It names a blade that there is not.
    Blade(ReferenceError),
    /// It is of another algebra.
    Signature {
        /// The signature of the definition.
        expected: Signature,
        /// That of the answer.
        found: Signature,
    },
    /// The function panicked with this text.
    Panic(String),
}

impl fmt::Display for Fault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Blade(error) => write!(f, "no answer: {error}"),
            Self::Signature { expected, found } => write!(f, "no answer of {expected}, but one of {found}"),
            Self::Panic(text) => write!(f, "a panic: {text}"),
        }
    }
}

/// Inputs at which a function differs from its definition.
#[derive(Clone, Debug, PartialEq)]
pub struct Counterexample<T> {
    /// The definition.
    pub definition: String,
    /// The inputs by name, in the order of the function.
    pub inputs: Vec<(String, Multivector<T>)>,
    /// The value of the definition.
    pub expected: Multivector<T>,
    /// What the function gives.
    pub found: Result<Multivector<T>, Fault>,
    /// The first coefficient, by grade and word, that differs; `None` where there is no answer to compare.
    pub difference: Option<Difference<T>>,
}

impl<T: Coefficient> fmt::Display for Counterexample<T> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        writeln!(f, "expected the value of `{}`, found another at", self.definition)?;
        write_inputs(f, &self.inputs)?;
        writeln!(f, "expected: {}", self.expected)?;
        match &self.found {
            Ok(found) => write!(f, "found:    {found}")?,
            Err(fault) => write!(f, "found:    {fault}")?,
        }
        let Some(Difference { blade, expected, found, allowed }) = &self.difference else { return Ok(()) };
        write!(f, "\nfirst difference: expected {expected} in {blade}, found {found}")?;
        if *allowed > 0.0 { write!(f, " (allowed: {allowed:.2e})") } else { Ok(()) }
    }
}

impl<T: Coefficient> std::error::Error for Counterexample<T> {}
