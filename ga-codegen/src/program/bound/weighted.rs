//! Polynomials in the magnitudes of inputs that count roundings.

use super::Packing;
use std::rc::Rc;

/// A monomial in the magnitudes of the inputs, exponents packed side by side, and what multiplies it.
#[derive(Clone, Copy, Debug)]
pub(super) struct Term {
    /// The exponents; the sum of two is the product of the monomials.
    pub(super) monomial: u128,
    /// The sum of |coefficient| over the expanded program's terms.
    pub(super) size: f64,
    /// The sum of |coefficient| times the number of roundings that the term went through.
    pub(super) error: f64,
}

/// A value of a program, expanded without cancellation.
#[derive(Clone, Debug, Default)]
pub(super) struct Weighted {
    /// The terms, ascending by monomial, each monomial once.
    pub(super) terms: Rc<Vec<Term>>,
    /// The most roundings that a term went through.
    pub(super) roundings: u32,
}

impl Weighted {
    /// An input.
    pub(super) fn input(packing: &Packing, coefficient: usize) -> Self {
        let term = Term { monomial: packing.monomial(coefficient), size: 1.0, error: 0.0 };
        Self { terms: Rc::new(vec![term]), roundings: 0 }
    }

    /// A constant whose evaluation takes this many roundings.
    pub(super) fn constant(magnitude: f64, roundings: u32) -> Self {
        if magnitude == 0.0 {
            return Self::default();
        }
        let term = Term { monomial: 0, size: magnitude, error: magnitude * f64::from(roundings) };
        Self { terms: Rc::new(vec![term]), roundings }
    }

    /// The sum or difference, not rounded.
    pub(super) fn plus(&self, other: &Self) -> Self {
        let (a, b) = (&self.terms, &other.terms);
        let mut terms = Vec::with_capacity(a.len() + b.len());
        let (mut i, mut j) = (0, 0);
        while i < a.len() && j < b.len() {
            let (first, second) = (a[i], b[j]);
            i += usize::from(first.monomial <= second.monomial);
            j += usize::from(second.monomial <= first.monomial);
            terms.push(match first.monomial.cmp(&second.monomial) {
                std::cmp::Ordering::Less => first,
                std::cmp::Ordering::Greater => second,
                std::cmp::Ordering::Equal => {
                    Term { size: first.size + second.size, error: first.error + second.error, ..first }
                }
            });
        }
        terms.extend_from_slice(&a[i..]);
        terms.extend_from_slice(&b[j..]);
        Self { terms: Rc::new(terms), roundings: self.roundings.max(other.roundings) }
    }

    /// The product, not rounded.
    pub(super) fn times(&self, other: &Self) -> Self {
        let (few, many) = if self.terms.len() < other.terms.len() { (self, other) } else { (other, self) };
        let mut sum = Self::default();
        for a in few.terms.iter() {
            let product = |b: &Term| Term {
                monomial: a.monomial + b.monomial,
                size: a.size * b.size,
                error: a.size * b.error + a.error * b.size,
            };
            // Exponents do not overflow their places, so the order of the monomials is kept.
            let row = Self { terms: Rc::new(many.terms.iter().map(product).collect()), roundings: 0 };
            sum = if sum.terms.is_empty() { row } else { sum.plus(&row) };
        }
        Self { roundings: self.roundings + other.roundings, ..sum }
    }

    /// Twice the value.
    pub(super) fn doubled(&self) -> Self {
        let double = |term: &Term| Term { size: 2.0 * term.size, error: 2.0 * term.error, ..*term };
        Self { terms: Rc::new(self.terms.iter().map(double).collect()), ..*self }
    }

    /// The same after one rounding.
    pub(super) fn rounded(self) -> Self {
        let round = |term: &Term| Term { error: term.error + term.size, ..*term };
        Self { terms: Rc::new(self.terms.iter().map(round).collect()), roundings: self.roundings + 1 }
    }
}
