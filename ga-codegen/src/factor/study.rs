//! Closed forms of exp and log of bivectors whose square is a Study number.
//!
//! Let B^2 = -A + N with A a scalar, a sum of squares, and N nilpotent (N^2 = 0) and commuting with B; l = sqrt(A).
//! An analytic f of B^2 is f(-A) + f'(-A) N, so with C = cos l, S = sin(l)/l and g = (C - S)/A
//! ```text
//! exp B = cosh(sqrt(B^2)) + sinh(sqrt(B^2))/sqrt(B^2) B = C + S N/2 + (S - g N/2) B.
//! ```
//! Conversely, for a unit m = s + V + P with V of grade 2, P nilpotent and commuting with V, and A = -<V^2>,
//! ```text
//! log m = (k - h P) V,   k = atan2(sqrt A, s)/sqrt A,   h = (1 - s k)/A.
//! ```
//! (Dorst and De Keninck, "A Guided Tour to the Plane-Based Geometric Algebra PGA", 2022, give the same for 3D.)

use super::FactorError;
use super::extract::greedy;
use super::system::System;
use crate::algebra::{Blade, Product};
use crate::kernel::Specification;
use crate::program::{Operation, Program, ProgramBuilder, Value};
use crate::symbolic::{Multivector, Polynomial, Rational, Symbol};

fn no_closed_form<T>(text: &str) -> Result<T, FactorError> {
    Err(FactorError::NoClosedForm(text.to_owned()))
}

fn mul(a: &Multivector, b: &Multivector, specification: &Specification) -> Result<Multivector, FactorError> {
    Ok(a.product(Product::Geometric, b, &specification.basis)?)
}

/// Checks that a multivector squares to 0 and commutes with another.
fn check_nilpotent(n: &Multivector, with: &Multivector, specification: &Specification) -> Result<(), FactorError> {
    let (square, left, right) = (mul(n, n, specification)?, mul(n, with, specification)?, mul(with, n, specification)?);
    if square.is_zero() && left.sub(&right)?.is_zero() {
        return Ok(());
    }
    no_closed_form(
        "expected a bivector whose square is a scalar plus a nilpotent part that commutes with it, found another",
    )
}

/// The scalar A in B^2 = -A + N, which must be a sum of squares.
fn negated_square(
    bivector: &Multivector,
    specification: &Specification,
) -> Result<(Polynomial, Multivector), FactorError> {
    let square = mul(bivector, bivector, specification)?;
    let scalar = square.coefficient(Blade::SCALAR);
    let nilpotent = square.sub(&Multivector::scalar(scalar.clone()))?;
    check_nilpotent(&nilpotent, bivector, specification)?;
    let a = scalar.neg();
    let sum_of_squares = a.terms().all(|(monomial, coefficient)| {
        !coefficient.is_negative() && monomial.symbols().chunk_by(|x, y| x == y).all(|power| power.len() % 2 == 0)
    });
    if !sum_of_squares {
        return no_closed_form(
            "expected a bivector whose square is nowhere positive, found one that can be hyperbolic",
        );
    }
    Ok((a, nilpotent))
}

/// A program with nothing but its inputs.
fn start(specification: &Specification) -> (ProgramBuilder, Vec<Value>) {
    let mut builder = ProgramBuilder::new();
    let inputs = (0..specification.coefficients.len()).map(|input| builder.push(Operation::Input(input))).collect();
    (builder, inputs)
}

/// The finished program whose output is a multivector over the given values.
fn build(
    value: &Multivector,
    specification: &Specification,
    mut builder: ProgramBuilder,
    given: &[Value],
) -> Result<Program, FactorError> {
    let fields = specification.output.fields();
    let polynomials: Vec<_> = fields.map(|(_, c)| value.coefficient(c.blade).signed(c.sign)).collect();
    let outputs = greedy(System::new(&polynomials, given.len())?).build(&mut builder, given);
    Ok(builder.finish(&outputs))
}

/// exp B = C + S N/2 + (S - g N/2) B.
pub(super) fn exp(specification: &Specification) -> Result<Program, FactorError> {
    let (mut builder, inputs) = start(specification);
    let b = &specification.value;
    let (a, nilpotent) = negated_square(b, specification)?;
    let half = nilpotent.scale(Rational::new(1, 2)?)?;
    let mut given = inputs.clone();
    let (c, s, g) = if a.is_zero() {
        let third = Polynomial::constant(Rational::new(-1, 3)?);
        (Polynomial::one(), Polynomial::one(), third)
    } else {
        let square = greedy(System::new(&[a], inputs.len())?).build(&mut builder, &inputs)[0];
        let norm = builder.push(Operation::Sqrt(square));
        let cos = builder.push(Operation::Cos(norm));
        let sin = builder.push(Operation::Sin(norm));
        let sinc = builder.push(Operation::Quotient(sin, norm, Rational::ONE));
        let difference = builder.push(Operation::Sub(cos, sinc));
        let g = builder.push(Operation::Quotient(difference, square, Rational::new(-1, 3)?));
        let first = given.len() as Symbol;
        given.extend([cos, sinc, g]);
        (Polynomial::symbol(first), Polynomial::symbol(first + 1), Polynomial::symbol(first + 2))
    };
    let times = |value: &Multivector, factor: &Polynomial| value.map(|coefficient| coefficient.mul(factor));
    let value = Multivector::scalar(c)
        .add(&times(&half, &s)?)?
        .add(&times(b, &s)?)?
        .sub(&times(&mul(&half, b, specification)?, &g)?)?;
    build(&value, specification, builder, &given)
}

/// log m = (k - h P) V.
pub(super) fn log(specification: &Specification) -> Result<Program, FactorError> {
    let (mut builder, inputs) = start(specification);
    let m = &specification.value;
    let (scalar, v) = (m.coefficient(Blade::SCALAR), m.grade(2));
    let p = m.sub(&v)?.sub(&Multivector::scalar(scalar.clone()))?;
    check_nilpotent(&p, &v, specification)?;
    let (a, _) = negated_square(&v, specification)?;
    if a.is_zero() {
        return build(&v, specification, builder, &inputs);
    }
    let sources = greedy(System::new(&[a, scalar], inputs.len())?).build(&mut builder, &inputs);
    let (square, s) = (sources[0], sources[1]);
    let norm = builder.push(Operation::Sqrt(square));
    let angle = builder.push(Operation::Atan2(norm, s));
    let k = builder.push(Operation::Quotient(angle, norm, Rational::ONE));
    let one = builder.push(Operation::Constant(Rational::ONE));
    let product = builder.push(Operation::Mul(s, k));
    let difference = builder.push(Operation::Sub(one, product));
    let h = builder.push(Operation::Quotient(difference, square, Rational::new(1, 3)?));
    let first = inputs.len() as Symbol;
    let given: Vec<_> = inputs.iter().copied().chain([k, h]).collect();
    let times = |value: &Multivector, symbol: Symbol| value.map(|c| c.mul(&Polynomial::symbol(symbol)));
    let value = times(&v, first)?.sub(&times(&mul(&p, &v, specification)?, first + 1)?)?;
    build(&value, specification, builder, &given)
}
