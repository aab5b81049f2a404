//! Multivectors whose coefficients are polynomials.

use super::{Monomial, Overflow, Polynomial, Rational, effort};
use crate::algebra::{Basis, Blade, Product, Sign};
use std::collections::BTreeMap;

/// A multivector: a polynomial for every ascending blade whose coefficient is not 0.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Multivector(BTreeMap<Blade, Polynomial>);

impl Multivector {
    /// 0
    pub fn zero() -> Self {
        Self::default()
    }

    /// A coefficient times a blade.
    pub fn term(blade: Blade, coefficient: Polynomial) -> Self {
        Self::from_terms([(blade, coefficient)])
    }

    /// A scalar.
    pub fn scalar(coefficient: Polynomial) -> Self {
        Self::term(Blade::SCALAR, coefficient)
    }

    /// A multivector of these terms, one for a blade.
    pub fn from_terms(terms: impl IntoIterator<Item = (Blade, Polynomial)>) -> Self {
        Self(terms.into_iter().filter(|(_, coefficient)| !coefficient.is_zero()).collect())
    }

    /// The terms, ascending by blade.
    pub fn terms(&self) -> impl Iterator<Item = (Blade, &Polynomial)> {
        self.0.iter().map(|(&blade, coefficient)| (blade, coefficient))
    }

    /// The coefficient of an ascending blade.
    pub fn coefficient(&self, blade: Blade) -> Polynomial {
        self.0.get(&blade).cloned().unwrap_or_default()
    }

    /// Whether every coefficient is 0 as a polynomial.
    pub fn is_zero(&self) -> bool {
        self.0.is_empty()
    }

    /// The same blades with their coefficients mapped.
    ///
    /// # Errors
    /// Those of `map`.
    pub fn map<E>(&self, mut map: impl FnMut(&Polynomial) -> Result<Polynomial, E>) -> Result<Self, E> {
        let terms: Result<Vec<_>, E> = self.terms().map(|(blade, c)| Ok((blade, map(c)?))).collect();
        Ok(Self::from_terms(terms?))
    }

    fn add_term(&mut self, blade: Blade, sign: Sign, coefficient: &Polynomial) -> Result<(), Overflow> {
        let factor = if sign.is_minus() { Rational::MINUS_ONE } else { Rational::ONE };
        let sum = self.0.entry(blade).or_default();
        sum.add_multiple(factor, &Monomial::default(), coefficient)?;
        if sum.is_zero() {
            self.0.remove(&blade);
        }
        Ok(())
    }

    /// The sum.
    ///
    /// # Errors
    /// [`Overflow`]
    pub fn add(&self, other: &Self) -> Result<Self, Overflow> {
        let mut sum = self.clone();
        for (blade, coefficient) in other.terms() {
            sum.add_term(blade, Sign::Plus, coefficient)?;
        }
        Ok(sum)
    }

    /// The difference.
    ///
    /// # Errors
    /// [`Overflow`]
    pub fn sub(&self, other: &Self) -> Result<Self, Overflow> {
        self.add(&other.neg())
    }

    /// The negative.
    pub fn neg(&self) -> Self {
        self.signed(|_| Sign::Minus)
    }

    /// The product with a number.
    ///
    /// # Errors
    /// [`Overflow`]
    pub fn scale(&self, factor: Rational) -> Result<Self, Overflow> {
        self.map(|coefficient| coefficient.scale(factor))
    }

    /// A bilinear product.
    ///
    /// # Errors
    /// [`Overflow`]
    pub fn product(&self, product: Product, other: &Self, basis: &Basis) -> Result<Self, Overflow> {
        let mut result = Self::zero();
        for (a, coefficient_a) in self.terms() {
            for (b, coefficient_b) in other.terms() {
                if !effort::spend(1) {
                    return Err(Overflow);
                }
                if let Some((sign, blade)) = product.of_blades(basis, a, b) {
                    result.add_term(blade, sign, &coefficient_a.mul(coefficient_b)?)?;
                }
            }
        }
        Ok(result)
    }

    /// Every coefficient times the sign that its blade gets.
    fn signed(&self, sign: impl Fn(Blade) -> Sign) -> Self {
        let term = |(blade, c): (Blade, &Polynomial)| (blade, c.clone().signed(sign(blade)));
        Self(self.terms().map(term).collect())
    }

    /// The reverse.
    pub fn reverse(&self) -> Self {
        self.signed(Blade::reverse_sign)
    }

    /// The grade involution.
    pub fn grade_involution(&self) -> Self {
        self.signed(Blade::involution_sign)
    }

    /// The Clifford conjugate: the reverse of the grade involution.
    pub fn clifford_conjugate(&self) -> Self {
        self.reverse().grade_involution()
    }

    /// The dual against the pseudoscalar of the basis, see [`Basis::dual`].
    pub fn dual(&self, basis: &Basis) -> Self {
        self.permuted(|blade| basis.dual(blade))
    }

    /// The inverse of [`Multivector::dual`].
    pub fn undual(&self, basis: &Basis) -> Self {
        self.permuted(|blade| basis.undual(blade))
    }

    fn permuted(&self, to: impl Fn(Blade) -> (Sign, Blade)) -> Self {
        let term = |(blade, c): (Blade, &Polynomial)| {
            let (sign, image) = to(blade);
            (image, c.clone().signed(sign))
        };
        Self(self.terms().map(term).collect())
    }

    /// The part of one grade.
    pub fn grade(&self, grade: u32) -> Self {
        Self(self.0.iter().filter(|(b, _)| b.grade() == grade).map(|(&b, c)| (b, c.clone())).collect())
    }
}
