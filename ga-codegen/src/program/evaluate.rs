//! Running a program on numbers of any kind: floats, polynomials, power series.

use super::{Operation, Program};
use crate::approximation::{Function, Precision, approximation};
use crate::symbolic::Rational;
use std::convert::Infallible;

/// Arithmetic on one kind of numbers.
pub trait Domain {
    /// The numbers.
    type Number: Clone;
    /// Why an operation has no result.
    type Error;

    /// A constant.
    fn constant(&self, value: Rational) -> Result<Self::Number, Self::Error>;
    /// a + b
    fn add(&self, a: &Self::Number, b: &Self::Number) -> Result<Self::Number, Self::Error>;
    /// -a
    fn neg(&self, a: &Self::Number) -> Result<Self::Number, Self::Error>;
    /// a * b
    fn mul(&self, a: &Self::Number, b: &Self::Number) -> Result<Self::Number, Self::Error>;
    /// a / b
    fn div(&self, a: &Self::Number, b: &Self::Number) -> Result<Self::Number, Self::Error>;
    /// The square root.
    fn sqrt(&self, a: &Self::Number) -> Result<Self::Number, Self::Error>;
    /// The sine.
    fn sin(&self, a: &Self::Number) -> Result<Self::Number, Self::Error>;
    /// The cosine.
    fn cos(&self, a: &Self::Number) -> Result<Self::Number, Self::Error>;
    /// The angle of the point (x, y).
    fn atan2(&self, y: &Self::Number, x: &Self::Number) -> Result<Self::Number, Self::Error>;
    /// numerator / denominator, and `limit` where the denominator is 0.
    fn quotient(&self, n: &Self::Number, d: &Self::Number, limit: Rational) -> Result<Self::Number, Self::Error>;
    /// A function that the program evaluates by a polynomial: the function itself, or the polynomial for f64.
    fn function(&self, function: Function, a: &Self::Number) -> Result<Self::Number, Self::Error>;
    /// The square root of the sum of squares.
    fn norm(&self, components: &[&Self::Number]) -> Result<Self::Number, Self::Error> {
        let mut sum = self.constant(Rational::ZERO)?;
        for component in components {
            sum = self.add(&sum, &self.mul(component, component)?)?;
        }
        self.sqrt(&sum)
    }
}

impl Program {
    /// The outputs for these inputs.
    ///
    /// # Errors
    /// The first of the domain.
    ///
    /// # Panics
    /// Where an input has no value in `inputs`.
    pub fn evaluate<D: Domain>(&self, domain: &D, inputs: &[D::Number]) -> Result<Vec<D::Number>, D::Error> {
        let mut values: Vec<D::Number> = Vec::with_capacity(self.operations.len());
        for operation in &self.operations {
            let value = match *operation {
                Operation::Input(index) => inputs[index].clone(),
                Operation::Constant(number) => domain.constant(number)?,
                Operation::Add(a, b) => domain.add(&values[a], &values[b])?,
                Operation::Sub(a, b) => domain.add(&values[a], &domain.neg(&values[b])?)?,
                Operation::Mul(a, b) => domain.mul(&values[a], &values[b])?,
                Operation::Neg(a) => domain.neg(&values[a])?,
                Operation::Double(a) => domain.add(&values[a], &values[a])?,
                Operation::Div(a, b) => domain.div(&values[a], &values[b])?,
                Operation::Sqrt(a) => domain.sqrt(&values[a])?,
                Operation::Norm(operands) => {
                    domain.norm(&operands.iter().map(|operand| &values[operand]).collect::<Vec<_>>())?
                }
                Operation::Sin(a) => domain.sin(&values[a])?,
                Operation::Cos(a) => domain.cos(&values[a])?,
                Operation::Atan2(y, x) => domain.atan2(&values[y], &values[x])?,
                Operation::Quotient(n, d, limit) => domain.quotient(&values[n], &values[d], limit)?,
                Operation::Polynomial(function, _, a) => domain.function(function, &values[a])?,
            };
            values.push(value);
        }
        Ok(self.outputs.iter().map(|&output| values[output].clone()).collect())
    }
}

/// Double precision, for tests.
#[derive(Clone, Copy, Debug, Default)]
pub struct FloatDomain;

impl Domain for FloatDomain {
    type Number = f64;
    type Error = Infallible;

    fn constant(&self, value: Rational) -> Result<f64, Infallible> {
        Ok(value.to_f64())
    }
    fn add(&self, a: &f64, b: &f64) -> Result<f64, Infallible> {
        Ok(a + b)
    }
    fn neg(&self, a: &f64) -> Result<f64, Infallible> {
        Ok(-a)
    }
    fn mul(&self, a: &f64, b: &f64) -> Result<f64, Infallible> {
        Ok(a * b)
    }
    fn div(&self, a: &f64, b: &f64) -> Result<f64, Infallible> {
        Ok(a / b)
    }
    fn sqrt(&self, a: &f64) -> Result<f64, Infallible> {
        Ok(a.sqrt())
    }
    fn sin(&self, a: &f64) -> Result<f64, Infallible> {
        Ok(a.sin())
    }
    fn cos(&self, a: &f64) -> Result<f64, Infallible> {
        Ok(a.cos())
    }
    fn atan2(&self, y: &f64, x: &f64) -> Result<f64, Infallible> {
        Ok(y.atan2(*x))
    }
    fn quotient(&self, n: &f64, d: &f64, limit: Rational) -> Result<f64, Infallible> {
        Ok(if *d == 0.0 { limit.to_f64() } else { n / d })
    }
    fn function(&self, function: Function, a: &f64) -> Result<f64, Infallible> {
        let polynomial = approximation(function, Precision::F64);
        Ok(polynomial.coefficients.iter().rev().fold(0.0, |sum, coefficient| sum * a + coefficient))
    }
}
