//! How blades are written: `1` for the scalar, `e` and digits for the others.

use super::ReferenceError;
use super::word::{self, Word};
use crate::algebra::Signature;

/// Reads a blade, `1` or `e31`, into the sign of its order and the canonical word.
pub(super) fn parse(signature: Signature, text: &str) -> Result<(i8, Word), ReferenceError> {
    if text == "1" {
        return Ok((1, Word::new()));
    }
    let known = word::generators(signature);
    let mut letters = Word::new();
    for generator in digits(text)? {
        if !known.contains(&generator) {
            return Err(ReferenceError::UnknownGenerator { word: text.to_owned(), generator, signature });
        }
        if letters.contains(&generator) {
            return Err(ReferenceError::RepeatedGenerator { word: text.to_owned(), generator });
        }
        letters.push(generator);
    }
    Ok(word::sort(letters))
}

/// The digits after the `e`, at least one of them and nothing else.
fn digits(text: &str) -> Result<Vec<u8>, ReferenceError> {
    let malformed = || ReferenceError::MalformedWord { word: text.to_owned() };
    let digits = text.strip_prefix('e').filter(|digits| !digits.is_empty()).ok_or_else(malformed)?;
    digits.bytes().map(|byte| if byte.is_ascii_digit() { Ok(byte - b'0') } else { Err(malformed()) }).collect()
}

/// Writes a word as [`parse`] reads it.
pub(super) fn name(word: &[u8]) -> String {
    if word.is_empty() {
        return "1".to_owned();
    }
    let digits: String = word.iter().map(u8::to_string).collect();
    format!("e{digits}")
}
