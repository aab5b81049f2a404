//! Multivectors as text, `2 e12 - e0123`: the parser of what the printer writes.

use std::str::FromStr;

use super::number_text::{self, NumberText};
use super::word::Word;
use super::{Multivector, Number, ParseError, ReferenceError, notation};
use crate::algebra::Signature;

impl<T: Number + FromStr> Multivector<T> {
    /// Reads a sum of blades, such as `2 e12 - e0123` or `1/2 - 0.5 e31`: what [`Display`](std::fmt::Display) writes,
    /// and what one would write by hand.
    ///
    /// ```text
    /// sum    := ( "+" | "-" )? term ( ( "+" | "-" ) term )*
    /// term   := number | blade | number "*"? blade
    /// number := DIGITS ( "." DIGITS )? | DIGITS "/" DIGITS | "(" TEXT ")"
    /// blade  := "e" DIGITS, or "1" behind "*"
    /// ```
    /// Whitespace may stand between any two of these, and must between a number and its blade where there is no `*`:
    /// `2e12` could be a power of ten as well as a blade, and is refused. A blade may be written in any order of its
    /// generators, and once. There are no products of blades and no powers of ten.
    ///
    /// A coefficient is read by the `FromStr` of its type, the sign in front. Where the type does not read a decimal it
    /// is given the fraction of the same value, and the other way round where that decimal ends: so `f64` reads `3/8`,
    /// but not `1/3`, which no decimal is, and an exact fraction reads `0.375`. In parentheses stands any other text
    /// that the type reads, `(inf) e1`. No coefficients are added, so nothing overflows.
    ///
    /// # Errors
    /// Where the text does not have this form, names a blade that the signature does not have, or one twice, or holds a
    /// number that the type does not; a signature of too many dimensions. Each with its column.
    ///
    /// ```
    /// use ga_codegen::algebra::Signature;
    /// use ga_codegen::reference::Multivector;
    ///
    /// let pga3d = Signature::new(3, 0, 1);
    /// let screw = Multivector::<i64>::parse(pga3d, "2 e12 - e0123").expect("a multivector of 3D PGA");
    /// assert_eq!(screw.coefficient("e21"), -2);
    /// assert_eq!(screw.to_string(), "2 e12 - e0123");
    ///
    /// let rotor = Multivector::<f64>::parse(pga3d, "1/2 - 0.5*e31").expect("a multivector of 3D PGA");
    /// assert_eq!(rotor.to_string(), "0.5 + 0.5 e13");
    ///
    /// let error = Multivector::<f64>::parse(pga3d, "2 e12 e3").expect_err("two blades without a sign between them");
    /// assert_eq!(error.to_string(), "expected `+`, `-` or the end, found `e3` at column 7");
    /// ```
    pub fn parse(signature: Signature, text: &str) -> Result<Self, ParseError> {
        // The signature first: a text is not read against one that there are no words of.
        Self::from_blades::<&str>(signature, []).map_err(|error| ParseError::Signature { error })?;
        let mut reader = Reader { signature, text, at: 0 };
        let mut terms: Vec<(Word, T)> = Vec::new();
        let mut negative = reader.sign().unwrap_or(false);
        loop {
            let start = reader.start();
            let (word, value) = reader.term(negative)?;
            if terms.iter().any(|(other, _)| *other == word) {
                return Err(ParseError::RepeatedBlade { blade: notation::name(&word), column: reader.column(start) });
            }
            terms.push((word, value));
            match reader.sign() {
                Some(sign) => negative = sign,
                None if reader.rest().is_empty() => break,
                None => return Err(reader.unexpected("`+`, `-` or the end")),
            }
        }
        let mut sum = Self::zero(signature);
        for (word, value) in terms {
            sum.accumulate(1, word, value);
        }
        Ok(sum)
    }
}

/// A text and how far it has been read.
struct Reader<'a> {
    signature: Signature,
    text: &'a str,
    /// A byte offset at the border of a character.
    at: usize,
}

impl<'a> Reader<'a> {
    /// What is left, from its first character that is not a space.
    fn rest(&mut self) -> &'a str {
        let rest = self.text[self.at..].trim_start();
        self.at = self.text.len() - rest.len();
        rest
    }

    /// Where what is left starts.
    fn start(&mut self) -> usize {
        self.rest();
        self.at
    }

    /// The column of an offset, in characters from 1. Only errors ask for it, so it is counted once.
    fn column(&self, offset: usize) -> usize {
        self.text[..offset].chars().count() + 1
    }

    /// Whether a sign that stands here is a minus.
    fn sign(&mut self) -> Option<bool> {
        let negative = match self.rest().chars().next()? {
            '+' => false,
            '-' => true,
            _ => return None,
        };
        self.at += 1;
        Some(negative)
    }

    /// A term behind its sign: the canonical word and the coefficient.
    fn term<T: Number + FromStr>(&mut self, negative: bool) -> Result<(Word, T), ParseError> {
        let start = self.start();
        let number = self.number()?;
        let is_times = number.is_some() && self.rest().starts_with('*');
        if is_times {
            self.at += 1;
        }
        let (order, word) = match (self.blade(is_times)?, &number) {
            (Some(blade), _) => blade,
            (None, Some(_)) if is_times => return Err(self.unexpected("a blade")),
            (None, Some(_)) => (1, Word::new()),
            (None, None) => return Err(self.unexpected("a number or a blade")),
        };
        let negative = negative != (order < 0);
        let value = match number {
            None if negative => T::from(-1),
            None => T::from(1),
            Some(number) => number.read(negative).ok_or_else(|| ParseError::UnreadableNumber {
                found: shortened(number.text()),
                column: self.column(start),
            })?,
        };
        Ok((word, value))
    }

    /// A number, if one stands here.
    fn number(&mut self) -> Result<Option<NumberText<'a>>, ParseError> {
        let rest = self.rest();
        let (length, number) = if rest.starts_with('(') {
            let Some(length) = number_text::group_length(rest) else {
                self.at = self.text.len();
                return Err(self.unexpected("`)`"));
            };
            (length, NumberText::Group(&rest[1..length - 1]))
        } else {
            let length = number_text::plain_length(rest);
            (length, NumberText::Plain(&rest[..length]))
        };
        if length == 0 {
            return Ok(None);
        }
        self.at += length;
        if self.text[self.at..].starts_with(|c: char| c.is_alphanumeric() || matches!(c, '.' | '/')) {
            return Err(self.unexpected("a space or `*` behind a number"));
        }
        Ok(Some(number))
    }

    /// A blade, if one stands here: the sign of its order and the canonical word. `1` is one only behind `*`.
    fn blade(&mut self, is_times: bool) -> Result<Option<(i8, Word)>, ParseError> {
        let word = leading_word(self.rest());
        if !(word.starts_with('e') || is_times && word == "1") {
            return Ok(None);
        }
        let blade = notation::parse(self.signature, word);
        let blade = blade.map_err(|error| blade_error(error, word, self.column(self.at)))?;
        self.at += word.len();
        Ok(Some(blade))
    }

    /// An error at what is left.
    fn unexpected(&mut self, expected: &'static str) -> ParseError {
        let rest = self.rest();
        let found = match (leading_word(rest), rest.chars().next()) {
            (_, None) => None,
            ("", Some(other)) => Some(other.escape_debug().to_string()),
            (word, _) => Some(shortened(word)),
        };
        ParseError::Unexpected { expected, found, column: self.column(self.at) }
    }
}

/// The letters and digits at the start of a text.
fn leading_word(text: &str) -> &str {
    let end = text.find(|c: char| !c.is_alphanumeric()).unwrap_or(text.len());
    &text[..end]
}

/// A long word is not a blade at all, and is not quoted in full.
fn blade_error(error: ReferenceError, word: &str, column: usize) -> ParseError {
    match shortened(word) {
        short if short == word => ParseError::Blade { error, column },
        short => ParseError::Blade { error: ReferenceError::MalformedWord { word: short }, column },
    }
}

/// At most as much of a text as a message can bear.
fn shortened(text: &str) -> String {
    const MOST: usize = 40;
    match text.char_indices().nth(MOST) {
        Some((end, _)) => format!("{}...", &text[..end]),
        None => text.to_owned(),
    }
}
