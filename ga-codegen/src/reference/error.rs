//! What can be wrong with a blade or a signature that a caller names, and with a text that is to be a multivector.

use std::fmt;

use super::word;
use crate::algebra::Signature;

/// Why a multivector could not be built, or a coefficient not be read.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum ReferenceError {
    /// The signature has more than [`Signature::MAX_DIMENSION`] generators.
    DimensionTooLarge {
        /// The signature asked for.
        signature: Signature,
    },
    /// The word is neither `1` nor `e` and digits.
    MalformedWord {
        /// The word as written.
        word: String,
    },
    /// The word holds the digit of a generator that the signature does not have.
    UnknownGenerator {
        /// The word as written.
        word: String,
        /// The number of the generator.
        generator: u8,
        /// The signature of the multivector.
        signature: Signature,
    },
    /// The word holds a generator more than once, so it is a product and not a basis blade.
    RepeatedGenerator {
        /// The word as written.
        word: String,
        /// The number of the generator.
        generator: u8,
    },
}

impl fmt::Display for ReferenceError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::DimensionTooLarge { signature } => write!(
                f,
                "expected a signature of at most {} dimensions, found {signature}, which has {}",
                Signature::MAX_DIMENSION,
                signature.dimension()
            ),
            Self::MalformedWord { word } => {
                write!(f, "expected a blade, `1` or `e` followed by the digits of its generators, found `{word}`")
            }
            Self::UnknownGenerator { word, generator, signature } => {
                write!(f, "expected {}, found e{generator} in `{word}`", expected_generators(*signature))
            }
            Self::RepeatedGenerator { word, generator } => {
                write!(f, "expected each generator at most once in a blade, found e{generator} again in `{word}`")
            }
        }
    }
}

impl std::error::Error for ReferenceError {}

/// Why a text is no multivector. Columns count characters from 1.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum ParseError {
    /// The signature has too many dimensions, whatever the text.
    Signature {
        /// What is wrong with it.
        error: ReferenceError,
    },
    /// Something else stands where one of a few things may.
    Unexpected {
        /// What may stand there.
        expected: &'static str,
        /// What does, shortened where it is long; `None` for the end of the text.
        found: Option<String>,
        /// Where.
        column: usize,
    },
    /// The word is no blade of the signature.
    Blade {
        /// What is wrong with it.
        error: ReferenceError,
        /// Where it starts.
        column: usize,
    },
    /// The blade has a coefficient already.
    RepeatedBlade {
        /// The blade, its generators ascending.
        blade: String,
        /// Where its second term starts.
        column: usize,
    },
    /// The type of the coefficients does not read the number, in any of its forms.
    UnreadableNumber {
        /// The number as written, shortened where it is long.
        found: String,
        /// Where it starts.
        column: usize,
    },
}

impl fmt::Display for ParseError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Signature { error } => error.fmt(f),
            Self::Unexpected { expected, found: Some(found), column } => {
                write!(f, "expected {expected}, found `{found}` at column {column}")
            }
            Self::Unexpected { expected, found: None, column } => {
                write!(f, "expected {expected}, found the end at column {column}")
            }
            Self::Blade { error, column } => write!(f, "{error} at column {column}"),
            Self::RepeatedBlade { blade, column } => {
                write!(f, "expected each blade at most once, found `{blade}` again at column {column}")
            }
            Self::UnreadableNumber { found, column } => {
                write!(f, "expected a number that the coefficients can hold, found `{found}` at column {column}")
            }
        }
    }
}

impl std::error::Error for ParseError {
    fn source(&self) -> Option<&(dyn std::error::Error + 'static)> {
        match self {
            Self::Signature { error } | Self::Blade { error, .. } => Some(error),
            _ => None,
        }
    }
}

fn expected_generators(signature: Signature) -> String {
    match word::generators(signature).as_slice() {
        [] => format!("no generator, as {signature} has none"),
        [only] => format!("the generator e{only} of {signature}"),
        [first, .., last] => format!("a generator of {signature}, e{first} to e{last}"),
    }
}
