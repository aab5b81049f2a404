//! Formal power series in several unknowns, truncated by total degree.
//!
//! The ring is Q[[x_1 ... x_n]] with one more unknown `l`, the radical, that satisfies l^2 = A for a quadratic form A
//! in the unknowns: what a proof of `exp` or `log` needs, where l is the norm of a bivector. As A is homogeneous, so is
//! the rule that rewrites A to l^2, and truncation by degree commutes with it. Where a series must be inverted or have
//! its root taken, it has to be one in the radical alone.
//!
//! A must be a sum of squares with positive coefficients. So l is real everywhere, and it is 0 where all the unknowns in
//! A are 0, which need not be the origin: the other unknowns may have any values there.

use super::polynomial::{Monomial, Polynomial, Symbol};
use super::rational::{Overflow, Rational};
use super::relations::{Relation, Relations};
use std::fmt;

/// A series of which the terms up to total degree `order` are known.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Series {
    polynomial: Polynomial,
    order: usize,
}

impl Series {
    /// The known terms.
    pub fn polynomial(&self) -> &Polynomial {
        &self.polynomial
    }

    /// The degree up to which terms are known.
    pub fn order(&self) -> usize {
        self.order
    }

    fn constant_term(&self) -> Rational {
        self.polynomial.coefficient(&Monomial::default())
    }

    /// The least degree that occurs, or the first unknown one.
    fn valuation(&self) -> usize {
        self.polynomial.terms().map(|(monomial, _)| monomial.degree()).min().unwrap_or(self.order + 1)
    }
}

/// Why an operation on series has no result.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum SeriesError {
    /// [`Overflow`]
    Overflow,
    /// The operation is not defined for this series; the text says what was expected and found.
    Undefined(String),
    /// A quotient's value where the radical is 0 differs from the limit that the program states.
    WrongLimit {
        /// The value of the series where the radical is 0.
        expected: Rational,
        /// The limit in the program.
        found: Rational,
    },
}

impl From<Overflow> for SeriesError {
    fn from(_: Overflow) -> Self {
        Self::Overflow
    }
}

impl fmt::Display for SeriesError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Overflow => Overflow.fmt(f),
            Self::Undefined(text) => f.write_str(text),
            Self::WrongLimit { expected, found } => {
                write!(f, "expected the limit {expected} of a quotient, found {found}")
            }
        }
    }
}

/// The ring: how many degrees are kept, and the radical with its relation.
#[derive(Clone, Debug)]
pub struct SeriesRing {
    order: usize,
    radical: Symbol,
    relations: Relations,
}

impl SeriesRing {
    /// Series up to total degree `order` in which the symbol `radical` squares to `square`.
    ///
    /// # Errors
    /// A `square` that is not a sum of squares of unknowns with positive coefficients; 0 is one.
    pub fn new(order: usize, radical: Symbol, square: &Polynomial) -> Result<Self, SeriesError> {
        let is_square = |(monomial, coefficient): (&Monomial, Rational)| {
            matches!(*monomial.symbols(), [x, y] if x == y && x != radical) && !coefficient.is_negative()
        };
        if !square.terms().all(is_square) {
            return Err(SeriesError::Undefined(
                "expected a sum of squares as the square of a radical, found another polynomial".to_owned(),
            ));
        }
        let leading = square.terms().map(|(monomial, _)| monomial.clone()).next();
        let mut polynomial = square.clone();
        polynomial.add_term(Monomial::new(vec![radical, radical]), Rational::MINUS_ONE)?;
        let relation = leading.and_then(|leading| Relation::new(polynomial, leading));
        let relations: Vec<_> = relation.into_iter().collect();
        let relations = Relations::new(&relations)
            .map_err(|_| SeriesError::Undefined("expected a radical whose rule terminates".to_owned()))?;
        Ok(Self { order, radical, relations })
    }

    /// A polynomial as a series.
    ///
    /// # Errors
    /// [`Overflow`]
    pub fn series(&self, polynomial: &Polynomial) -> Result<Series, Overflow> {
        self.truncated(polynomial, self.order)
    }

    fn truncated(&self, polynomial: &Polynomial, order: usize) -> Result<Series, Overflow> {
        let mut kept = Polynomial::zero();
        for (monomial, coefficient) in polynomial.terms().filter(|(monomial, _)| monomial.degree() <= order) {
            kept.add_term(monomial.clone(), coefficient)?;
        }
        Ok(Series { polynomial: self.relations.normal_form(&kept)?, order })
    }

    /// The sum.
    ///
    /// # Errors
    /// [`Overflow`]
    pub fn add(&self, a: &Series, b: &Series) -> Result<Series, Overflow> {
        self.truncated(&a.polynomial.add(&b.polynomial)?, a.order.min(b.order))
    }

    /// The negative.
    pub fn neg(&self, a: &Series) -> Series {
        Series { polynomial: a.polynomial.neg(), order: a.order }
    }

    /// The product.
    ///
    /// # Errors
    /// [`Overflow`]
    pub fn mul(&self, a: &Series, b: &Series) -> Result<Series, Overflow> {
        let order = (a.order + b.valuation()).min(b.order + a.valuation()).min(self.order);
        let mut product = Polynomial::zero();
        for (monomial, coefficient) in a.polynomial.terms() {
            for (other, other_coefficient) in b.polynomial.terms() {
                if monomial.degree() + other.degree() <= order {
                    product.add_term(monomial.times(other), coefficient.checked_mul(other_coefficient)?)?;
                }
            }
        }
        self.truncated(&product, order)
    }

    /// sum of `coefficients(n)` * a^n, for a series without constant term.
    fn compose(
        &self,
        a: &Series,
        mut coefficients: impl FnMut(usize) -> Result<Rational, Overflow>,
    ) -> Result<Series, SeriesError> {
        if !a.constant_term().is_zero() {
            return Err(SeriesError::Undefined(
                "expected a series without constant term, found one with it".to_owned(),
            ));
        }
        let mut sum = self.series(&Polynomial::constant(coefficients(0)?))?;
        let mut power = self.series(&Polynomial::one())?;
        for n in 1..=self.order {
            power = self.mul(&power, a)?;
            let scaled = Series { polynomial: power.polynomial.scale(coefficients(n)?)?, order: power.order };
            sum = self.add(&sum, &scaled)?;
        }
        sum.order = sum.order.min(a.order);
        Ok(sum)
    }

    /// The sine of a series without constant term.
    ///
    /// # Errors
    /// [`SeriesError`]
    pub fn sin(&self, a: &Series) -> Result<Series, SeriesError> {
        self.compose(a, |n| match n % 4 {
            1 => reciprocal_factorial(n),
            3 => Ok(reciprocal_factorial(n)?.neg()),
            _ => Ok(Rational::ZERO),
        })
    }

    /// The cosine of a series without constant term.
    ///
    /// # Errors
    /// [`SeriesError`]
    pub fn cos(&self, a: &Series) -> Result<Series, SeriesError> {
        self.compose(a, |n| match n % 4 {
            0 => reciprocal_factorial(n),
            2 => Ok(reciprocal_factorial(n)?.neg()),
            _ => Ok(Rational::ZERO),
        })
    }

    /// The angle of the point (x, y) near (1, 0): arctan(y / x), for x with constant term 1 and y without one.
    ///
    /// # Errors
    /// [`SeriesError`]
    pub fn atan2(&self, y: &Series, x: &Series) -> Result<Series, SeriesError> {
        if x.constant_term() != Rational::ONE {
            let found = x.constant_term();
            return Err(SeriesError::Undefined(format!("expected a second argument of atan2 near 1, found {found}")));
        }
        let tangent = self.mul(y, &self.unit_power(x, Rational::MINUS_ONE)?)?;
        self.compose(&tangent, |n| {
            let sign = if n % 4 == 3 { -1 } else { 1 };
            if n % 2 == 1 { Rational::new(sign, n as i128) } else { Ok(Rational::ZERO) }
        })
    }

    /// A power, of rational exponent, of a series with constant term 1, by the binomial series.
    fn unit_power(&self, a: &Series, exponent: Rational) -> Result<Series, SeriesError> {
        let rest = self.add(a, &self.series(&Polynomial::constant(Rational::MINUS_ONE))?)?;
        let mut binomial = Rational::ONE;
        self.compose(&rest, |n| {
            if n > 0 {
                let factor = exponent.checked_add(Rational::integer(1 - n as i64))?;
                binomial = binomial.checked_mul(factor)?.checked_mul(Rational::new(1, n as i128)?)?;
            }
            Ok(binomial)
        })
    }

    /// Writes a series as l^k (c + ...) with l the radical and c not 0: returns k, c and the series divided by c l^k.
    fn leading_power(&self, a: &Series) -> Result<(usize, Rational, Series), SeriesError> {
        let radical_only = |(monomial, _): (&Monomial, Rational)| monomial.symbols().iter().all(|&s| s == self.radical);
        let k = a.valuation();
        if a.polynomial.is_zero() || !a.polynomial.terms().all(radical_only) {
            return Err(SeriesError::Undefined("expected a non-zero series in the radical alone".to_owned()));
        }
        let leading = Monomial::new(vec![self.radical; k]);
        let coefficient = a.polynomial.coefficient(&leading);
        let inverse = Rational::ONE.checked_div(coefficient)?.ok_or(Overflow)?;
        let unit = self.divided_by_radical(a, k)?;
        Ok((k, coefficient, Series { polynomial: unit.polynomial.scale(inverse)?, order: unit.order }))
    }

    /// The series divided by l^k, which must divide every term.
    fn divided_by_radical(&self, a: &Series, k: usize) -> Result<Series, SeriesError> {
        let divisor = Monomial::new(vec![self.radical; k]);
        let mut quotient = Polynomial::zero();
        for (monomial, coefficient) in a.polynomial.terms() {
            let rest = monomial.divided_by(&divisor).ok_or_else(|| {
                SeriesError::Undefined(format!(
                    "expected a series divisible by the radical to the {k}, found one that is not"
                ))
            })?;
            quotient.add_term(rest, coefficient)?;
        }
        Ok(Series { polynomial: quotient, order: a.order.saturating_sub(k) })
    }

    /// The root whose first coefficient is positive, of a series l^2k (1 + ...) in the radical alone.
    ///
    /// # Errors
    /// [`SeriesError`]
    pub fn sqrt(&self, a: &Series) -> Result<Series, SeriesError> {
        let (k, coefficient, unit) = self.leading_power(a)?;
        if k % 2 == 1 || coefficient != Rational::ONE {
            return Err(SeriesError::Undefined(format!(
                "expected an even power of the radical, found {coefficient} l^{k}"
            )));
        }
        let root = self.unit_power(&unit, Rational::new(1, 2)?)?;
        let factor = Polynomial::term(Monomial::new(vec![self.radical; k / 2]), Rational::ONE);
        Ok(Series { polynomial: root.polynomial.mul(&factor)?, order: (root.order + k / 2).min(self.order) })
    }

    /// The quotient of two series, the denominator in the radical alone; wherever the radical is 0, its value must be
    /// `limit`: every other term must contain the radical.
    ///
    /// # Errors
    /// [`SeriesError`]
    pub fn quotient(&self, numerator: &Series, denominator: &Series, limit: Rational) -> Result<Series, SeriesError> {
        let (k, coefficient, unit) = self.leading_power(denominator)?;
        let shifted = self.divided_by_radical(numerator, k)?;
        let quotient = self.mul(&shifted, &self.unit_power(&unit, Rational::MINUS_ONE)?)?;
        let inverse = Rational::ONE.checked_div(coefficient)?.ok_or(Overflow)?;
        let quotient = Series { polynomial: quotient.polynomial.scale(inverse)?, order: quotient.order };
        let mut without_radical = Polynomial::zero();
        for (monomial, coefficient) in quotient.polynomial.terms().filter(|(m, _)| m.power(self.radical) == 0) {
            without_radical.add_term(monomial.clone(), coefficient)?;
        }
        match without_radical.as_constant() {
            Some(expected) if expected == limit => Ok(quotient),
            Some(expected) => Err(SeriesError::WrongLimit { expected, found: limit }),
            None => Err(SeriesError::Undefined(
                "expected a quotient with one limit wherever the radical is 0, found one whose limit varies".to_owned(),
            )),
        }
    }
}

/// 1 / n!
pub(crate) fn reciprocal_factorial(n: usize) -> Result<Rational, Overflow> {
    (2..=n as i64).try_fold(Rational::ONE, |value, k| value.checked_mul(Rational::new(1, i128::from(k))?))
}
