//! Programs on polynomials, functions of numbers included: exact where the arguments of roots and functions are the
//! numbers 0 and 1.

use super::{Refutation, undefined};
use crate::approximation::Function;
use crate::program::Domain;
use crate::symbolic::{Polynomial, Rational};

/// Arithmetic on polynomials at the place where the norm of a bivector is 0.
pub(super) struct Locus;

impl Locus {
    /// The number that a polynomial is, if that is what `place` needs.
    fn number(a: &Polynomial, place: &str, wanted: &[Rational]) -> Result<Rational, Refutation> {
        match a.as_constant() {
            Some(number) if wanted.contains(&number) => Ok(number),
            _ => undefined(&format!("expected a number {place} where the norm is 0, found another value")),
        }
    }
}

const ZERO: &[Rational] = &[Rational::ZERO];

impl Domain for Locus {
    type Number = Polynomial;
    type Error = Refutation;

    fn constant(&self, value: Rational) -> Result<Polynomial, Refutation> {
        Ok(Polynomial::constant(value))
    }
    fn add(&self, a: &Polynomial, b: &Polynomial) -> Result<Polynomial, Refutation> {
        Ok(a.add(b)?)
    }
    fn neg(&self, a: &Polynomial) -> Result<Polynomial, Refutation> {
        Ok(a.neg())
    }
    fn mul(&self, a: &Polynomial, b: &Polynomial) -> Result<Polynomial, Refutation> {
        Ok(a.mul(b)?)
    }
    fn div(&self, a: &Polynomial, b: &Polynomial) -> Result<Polynomial, Refutation> {
        match b.as_constant() {
            Some(number) if !number.is_zero() => {
                let inverse = Rational::ONE.checked_div(number)?.unwrap_or(Rational::ONE);
                Ok(a.scale(inverse)?)
            }
            _ => undefined("expected a number other than 0 to divide by where the norm is 0, found another value"),
        }
    }
    fn sqrt(&self, a: &Polynomial) -> Result<Polynomial, Refutation> {
        Ok(Polynomial::constant(Self::number(a, "0 or 1 under a root", &[Rational::ZERO, Rational::ONE])?))
    }
    fn sin(&self, a: &Polynomial) -> Result<Polynomial, Refutation> {
        Self::number(a, "0 as the argument of the sine", ZERO)?;
        Ok(Polynomial::zero())
    }
    fn cos(&self, a: &Polynomial) -> Result<Polynomial, Refutation> {
        Self::number(a, "0 as the argument of the cosine", ZERO)?;
        Ok(Polynomial::one())
    }
    fn atan2(&self, y: &Polynomial, x: &Polynomial) -> Result<Polynomial, Refutation> {
        Self::number(y, "0 as the first argument of atan2", ZERO)?;
        Self::number(x, "1 as the second argument of atan2", &[Rational::ONE])?;
        Ok(Polynomial::zero())
    }
    fn quotient(&self, n: &Polynomial, d: &Polynomial, limit: Rational) -> Result<Polynomial, Refutation> {
        if d.is_zero() { Ok(Polynomial::constant(limit)) } else { self.div(n, d) }
    }
    fn function(&self, function: Function, a: &Polynomial) -> Result<Polynomial, Refutation> {
        Self::number(a, "0 as the argument of a polynomial", ZERO)?;
        Ok(Polynomial::constant(function.series(0)?))
    }
}
