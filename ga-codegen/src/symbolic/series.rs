//! Formal power series about 0 in polar coordinates, truncated by total degree.
//!
//! What a proof of `exp` or `log` needs, where l is the norm of a bivector: let A be a sum of squares of unknowns with
//! positive coefficients, A = sum a_i x_i^2. Wherever A is not 0 its unknowns are x_i = l n_i with l = sqrt(A) > 0, the
//! radical, and n_i on the ellipsoid sum a_i n_i^2 = 1, the directions. Series are in l and the other unknowns; their
//! coefficients are polynomials in the directions modulo that relation. So l divides x_i, and what a program computes as
//! x_i / l is a series, n_i. Directions have degree 0 and the relation is homogeneous, so it commutes with truncation. Where
//! a series must be inverted or have its root taken, it has to be one in the radical alone.
//!
//! Where A is 0 there are no polar coordinates; that place is for others to look at.

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
}

/// Why an operation on series has no result.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum SeriesError {
    /// [`Overflow`]
    Overflow,
    /// The operation is not defined for this series; the text says what was expected and found.
    Undefined(String),
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
        }
    }
}

/// The ring: how many degrees are kept, the radical, and the directions with their relation.
#[derive(Clone, Debug)]
pub struct SeriesRing {
    order: usize,
    radical: Symbol,
    directions: Vec<Symbol>,
    relations: Relations,
}

impl SeriesRing {
    /// Series up to total degree `order` where the unknowns in `square` are the symbol `radical` times a direction each,
    /// named by the unknown's own symbol.
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
        let directions = square.terms().map(|(monomial, _)| monomial.symbols()[0]).collect();
        let leading = square.terms().map(|(monomial, _)| monomial.clone()).next();
        let mut polynomial = square.clone();
        polynomial.add_term(Monomial::default(), Rational::MINUS_ONE)?;
        let relation = leading.and_then(|leading| Relation::new(polynomial, leading));
        let relations: Vec<_> = relation.into_iter().collect();
        let relations = Relations::new(&relations)
            .map_err(|_| SeriesError::Undefined("expected a radical whose rule terminates".to_owned()))?;
        Ok(Self { order, radical, directions, relations })
    }

    /// The unknowns that are the radical times a direction.
    pub fn directions(&self) -> &[Symbol] {
        &self.directions
    }

    /// A polynomial in the unknowns as a series.
    ///
    /// # Errors
    /// [`Overflow`]
    pub fn series(&self, polynomial: &Polynomial) -> Result<Series, Overflow> {
        let mut polar = Polynomial::zero();
        for (monomial, coefficient) in polynomial.terms() {
            let radicals = monomial.symbols().iter().filter(|symbol| self.directions.contains(symbol)).count();
            polar.add_term(monomial.times(&Monomial::new(vec![self.radical; radicals])), coefficient)?;
        }
        self.truncated(&polar, self.order)
    }

    /// The degree of a monomial, directions not counted.
    pub fn degree(&self, monomial: &Monomial) -> usize {
        monomial.symbols().iter().filter(|symbol| !self.directions.contains(symbol)).count()
    }

    /// The least degree that occurs in a series, or the first unknown one.
    fn valuation(&self, a: &Series) -> usize {
        a.polynomial.terms().map(|(monomial, _)| self.degree(monomial)).min().unwrap_or(a.order + 1)
    }

    /// A polynomial in radical, directions and other unknowns as a series.
    ///
    /// # Errors
    /// [`Overflow`]
    pub fn polar(&self, polynomial: &Polynomial) -> Result<Series, Overflow> {
        self.truncated(polynomial, self.order)
    }

    fn truncated(&self, polynomial: &Polynomial, order: usize) -> Result<Series, Overflow> {
        let mut kept = Polynomial::zero();
        for (monomial, coefficient) in polynomial.terms().filter(|(monomial, _)| self.degree(monomial) <= order) {
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
        let order = (a.order + self.valuation(b)).min(b.order + self.valuation(a)).min(self.order);
        let mut product = Polynomial::zero();
        for (monomial, coefficient) in a.polynomial.terms() {
            for (other, other_coefficient) in b.polynomial.terms() {
                if self.degree(monomial) + self.degree(other) <= order {
                    product.add_term(monomial.times(other), coefficient.checked_mul(other_coefficient)?)?;
                }
            }
        }
        self.truncated(&product, order)
    }

    /// sum of `coefficients(n)` * a^n, for a series without terms of degree 0.
    ///
    /// # Errors
    /// [`SeriesError`]
    pub fn compose(
        &self,
        a: &Series,
        mut coefficients: impl FnMut(usize) -> Result<Rational, Overflow>,
    ) -> Result<Series, SeriesError> {
        if self.valuation(a) == 0 {
            return Err(SeriesError::Undefined(
                "expected a series without terms of degree 0, found one with them".to_owned(),
            ));
        }
        let mut sum = self.series(&Polynomial::constant(coefficients(0)?))?;
        let mut power = self.series(&Polynomial::one())?;
        for n in 1..=self.order {
            power = self.mul(&power, a)?;
            if power.polynomial.is_zero() {
                break;
            }
            let scaled = Series { polynomial: power.polynomial.scale(coefficients(n)?)?, order: power.order };
            sum = self.add(&sum, &scaled)?;
        }
        sum.order = sum.order.min(a.order);
        Ok(sum)
    }

    /// The sine of a series without terms of degree 0.
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

    /// The cosine of a series without terms of degree 0.
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

    /// The angle of the point (x, y) near (1, 0): arctan(y / x), for x whose terms of degree 0 are 1 and y without any.
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

    /// A power, of rational exponent, of a series whose terms of degree 0 are 1, by the binomial series.
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
        let k = self.valuation(a);
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
        let order = a.order.checked_sub(k).ok_or_else(|| {
            SeriesError::Undefined(format!("expected a series that is known to order {k} before it is divided by it"))
        })?;
        Ok(Series { polynomial: quotient, order })
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

    /// The quotient of two series, the denominator in the radical alone, wherever the radical is not 0.
    ///
    /// # Errors
    /// [`SeriesError`]
    pub fn quotient(&self, numerator: &Series, denominator: &Series) -> Result<Series, SeriesError> {
        let (k, coefficient, unit) = self.leading_power(denominator)?;
        let shifted = self.divided_by_radical(numerator, k)?;
        let quotient = self.mul(&shifted, &self.unit_power(&unit, Rational::MINUS_ONE)?)?;
        let inverse = Rational::ONE.checked_div(coefficient)?.ok_or(Overflow)?;
        Ok(Series { polynomial: quotient.polynomial.scale(inverse)?, order: quotient.order })
    }
}

/// 1 / n!
pub(crate) fn reciprocal_factorial(n: usize) -> Result<Rational, Overflow> {
    (2..=n as i64).try_fold(Rational::ONE, |value, k| value.checked_mul(Rational::new(1, i128::from(k))?))
}
