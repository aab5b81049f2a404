//! The multivector itself: building it, reading it, and its linear structure.

use std::collections::BTreeMap;
use std::fmt;
use std::ops::{Add, Neg, Sub};

use super::word::Word;
use super::{Number, ReferenceError, notation, number_text};
use crate::algebra::Signature;

/// A multivector of any Cl(p,q,r) of at most [`Signature::MAX_DIMENSION`] dimensions.
///
/// Only coefficients that differ from zero are kept, each under its canonical word, so two multivectors are equal
/// exactly if they have the same signature and the same coefficients. A blade that is absent is an exact zero: it
/// contributes nothing to a product, not even against an infinity.
///
/// Operations on two multivectors panic if their signatures differ.
#[derive(Clone, Debug, PartialEq)]
pub struct Multivector<T> {
    signature: Signature,
    /// Invariant: the words are canonical words of the signature, and no coefficient is zero.
    coefficients: BTreeMap<Word, T>,
}

impl<T: Number> Multivector<T> {
    /// Sums the blades, each given by its word and its coefficient; a blade may occur repeatedly.
    ///
    /// A word is `1` for the scalar, or `e` and the digits of distinct generators in any order. The sign of the order
    /// counts: `e31` is `-e13`.
    ///
    /// # Errors
    ///
    /// If the signature has too many dimensions, or a word is malformed, holds a generator that the signature does not
    /// have, or holds a generator twice.
    ///
    /// ```
    /// use ga_codegen::algebra::Signature;
    /// use ga_codegen::reference::Multivector;
    ///
    /// let pga3d = Signature::new(3, 0, 1);
    /// let rotor = Multivector::from_blades(pga3d, [("1", 0.6), ("e31", -0.8)]).expect("blades of 3D PGA");
    /// assert_eq!(rotor.to_string(), "0.6 + 0.8 e13");
    ///
    /// let error = Multivector::from_blades(pga3d, [("e14", 1.0)]).expect_err("3D PGA has no e4");
    /// assert_eq!(error.to_string(), "expected a generator of Cl(3,0,1), e0 to e3, found e4 in `e14`");
    /// ```
    pub fn from_blades<W: AsRef<str>>(
        signature: Signature,
        blades: impl IntoIterator<Item = (W, T)>,
    ) -> Result<Self, ReferenceError> {
        let mut sum = Self::try_zero(signature)?;
        for (text, value) in blades {
            let (sign, word) = notation::parse(signature, text.as_ref())?;
            sum.accumulate(sign, word, value);
        }
        Ok(sum)
    }

    /// The multivector 0.
    ///
    /// # Panics
    ///
    /// If the signature has more than [`Signature::MAX_DIMENSION`] dimensions. [`Multivector::from_blades`] with no
    /// blades is the form that returns an error instead.
    #[track_caller]
    pub fn zero(signature: Signature) -> Self {
        match Self::try_zero(signature) {
            Ok(zero) => zero,
            Err(error) => panic!("{error}"),
        }
    }

    fn try_zero(signature: Signature) -> Result<Self, ReferenceError> {
        if signature.dimension() > Signature::MAX_DIMENSION {
            return Err(ReferenceError::DimensionTooLarge { signature });
        }
        Ok(Self { signature, coefficients: BTreeMap::new() })
    }

    /// A scalar as a multivector.
    ///
    /// # Panics
    ///
    /// As [`Multivector::zero`].
    #[track_caller]
    pub fn scalar(signature: Signature, value: T) -> Self {
        let mut scalar = Self::zero(signature);
        scalar.accumulate(1, Word::new(), value);
        scalar
    }

    /// The signature of the algebra.
    pub fn signature(&self) -> Signature {
        self.signature
    }

    /// The coefficient of a blade, written with its generators in any order: that of `e31` is minus that of `e13`.
    ///
    /// # Panics
    ///
    /// If the word is not a blade of the signature; [`Multivector::try_coefficient`] returns an error instead.
    #[track_caller]
    pub fn coefficient(&self, word: &str) -> T {
        match self.try_coefficient(word) {
            Ok(value) => value,
            Err(error) => panic!("{error}"),
        }
    }

    /// The coefficient of a blade, as [`Multivector::coefficient`] gives it.
    ///
    /// # Errors
    ///
    /// If the word is malformed, holds a generator that the signature does not have, or holds a generator twice.
    pub fn try_coefficient(&self, word: &str) -> Result<T, ReferenceError> {
        let (sign, word) = notation::parse(self.signature, word)?;
        Ok(match self.coefficients.get(&word) {
            Some(value) if sign < 0 => -value.clone(),
            Some(value) => value.clone(),
            None => T::from(0),
        })
    }

    /// The blades with coefficients that differ from zero, by grade, then by word. The words are in ascending order.
    ///
    /// ```
    /// use ga_codegen::algebra::Signature;
    /// use ga_codegen::reference::Multivector;
    ///
    /// let x = Multivector::from_blades(Signature::new(2, 0, 1), [("e20", 3), ("e2", 5), ("1", 0)]).expect("blades");
    /// assert_eq!(x.blades(), [("e2".to_owned(), 5), ("e02".to_owned(), -3)]);
    /// ```
    pub fn blades(&self) -> Vec<(String, T)> {
        let mut terms: Vec<(&Word, &T)> = self.coefficients.iter().collect();
        terms.sort_by_key(|(word, _)| word.len());
        terms.into_iter().map(|(word, value)| (notation::name(word), value.clone())).collect()
    }

    /// The sum.
    ///
    /// # Panics
    ///
    /// If the signatures differ.
    #[track_caller]
    pub fn add(&self, other: &Self) -> Self {
        self.assert_same_signature(other);
        let mut sum = self.clone();
        for (word, value) in &other.coefficients {
            sum.accumulate(1, word.clone(), value.clone());
        }
        sum
    }

    /// The difference.
    ///
    /// # Panics
    ///
    /// If the signatures differ.
    #[track_caller]
    pub fn sub(&self, other: &Self) -> Self {
        self.add(&other.neg())
    }

    /// The negative.
    pub fn neg(&self) -> Self {
        self.map_words(|word| (-1, word.to_vec()))
    }

    /// The multiple by a number.
    pub fn scale(&self, factor: T) -> Self {
        let mut scaled = self.empty();
        for (word, value) in &self.coefficients {
            scaled.accumulate(1, word.clone(), value.clone() * factor.clone());
        }
        scaled
    }

    /// The words and coefficients, in no order that a caller should rely on.
    pub(super) fn terms(&self) -> impl Iterator<Item = (&[u8], &T)> {
        self.coefficients.iter().map(|(word, value)| (word.as_slice(), value))
    }

    /// Zero in the same algebra.
    pub(super) fn empty(&self) -> Self {
        Self { signature: self.signature, coefficients: BTreeMap::new() }
    }

    /// Adds `sign * value` to the coefficient of a canonical word. With the sign 0 the term is absent.
    pub(super) fn accumulate(&mut self, sign: i8, word: Word, value: T) {
        let term = match sign {
            0 => return,
            1 => value,
            _ => -value,
        };
        let sum = match self.coefficients.remove(&word) {
            Some(earlier) => earlier + term,
            None => term,
        };
        if sum != T::from(0) {
            self.coefficients.insert(word, sum);
        }
    }

    /// The linear map that takes each word to a signed word.
    pub(super) fn map_words(&self, image: impl Fn(&[u8]) -> (i8, Word)) -> Self {
        let mut mapped = self.empty();
        for (word, value) in self.terms() {
            let (sign, word) = image(word);
            mapped.accumulate(sign, word, value.clone());
        }
        mapped
    }

    #[track_caller]
    pub(super) fn assert_same_signature(&self, other: &Self) {
        assert!(
            self.signature == other.signature,
            "expected two multivectors of one signature, found {} and {}",
            self.signature,
            other.signature
        );
    }
}

impl<T: Number> Add for &Multivector<T> {
    type Output = Multivector<T>;

    #[track_caller]
    fn add(self, other: Self) -> Multivector<T> {
        Multivector::add(self, other)
    }
}

impl<T: Number> Sub for &Multivector<T> {
    type Output = Multivector<T>;

    #[track_caller]
    fn sub(self, other: Self) -> Multivector<T> {
        Multivector::sub(self, other)
    }
}

impl<T: Number> Neg for &Multivector<T> {
    type Output = Multivector<T>;

    fn neg(self) -> Multivector<T> {
        Multivector::neg(self)
    }
}

/// Writes the terms by grade, `2 e12 - e0123`, and `0` if there are none. A coefficient whose own text is not a plain
/// number stands in parentheses. [`Multivector::parse`] reads what is written, if a coefficient reads what it writes.
impl<T: Number + fmt::Display> fmt::Display for Multivector<T> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&write_terms(&self.blades()))
    }
}

/// Blades with their coefficients as a sum.
pub(super) fn write_terms<T: Number + fmt::Display>(blades: &[(String, T)]) -> String {
    if blades.is_empty() {
        return "0".to_owned();
    }
    let mut sum = String::new();
    for (position, (word, value)) in blades.iter().enumerate() {
        let (negative, term) = write_term(word, value);
        sum += match (position, negative) {
            (0, false) => "",
            (0, true) => "-",
            (_, false) => " + ",
            (_, true) => " - ",
        };
        sum += &term;
    }
    sum
}

/// Whether a term is written with a minus, and what follows the sign. The coefficients 1 and -1 of a blade are not
/// written.
fn write_term<T: Number + fmt::Display>(word: &str, value: &T) -> (bool, String) {
    match (word, number_text::write(value.to_string())) {
        ("1", written) => written,
        _ if *value == T::from(1) => (false, word.to_owned()),
        _ if *value == T::from(-1) => (true, word.to_owned()),
        (_, (negative, magnitude)) => (negative, format!("{magnitude} {word}")),
    }
}
