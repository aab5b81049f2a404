//! What can be wrong with a blade or a signature that a caller names.

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

fn expected_generators(signature: Signature) -> String {
    match word::generators(signature).as_slice() {
        [] => format!("no generator, as {signature} has none"),
        [only] => format!("the generator e{only} of {signature}"),
        [first, .., last] => format!("a generator of {signature}, e{first} to e{last}"),
    }
}
