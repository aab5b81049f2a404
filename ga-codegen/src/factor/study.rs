//! Closed forms of functions whose argument is, up to a nilpotent part, like a complex number.
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
//!
//! As written, A leaves the range of floating point long before l does, and g and h cancel. So coefficients that make up A
//! occur as n = b / l, at most 1, and P as P / l. What stands before them is then sin l for S b, C - S for g b b, theta
//! for k b and 1 - s k for h P b: nothing grows, and the error of C - S and of 1 - s k is that of numbers near 1.
//!
//! P / l is no quotient, for P has the rounding errors of the products that led to m, whatever l is. A unit has
//! s P = N / 2 and s^2 + l^2 = 1, so P / l = s N / (2 l) + l P; and N has b once, so nothing but b is divided by l.
//!
//! A multivector y whose norm y ~y = A + N is such a number is (1 - N / (2 A)) / sqrt(A) times a unit, y normalised.

use super::FactorError;
use super::extract::greedy;
use super::system::System;
use crate::algebra::{Blade, Product, Sign};
use crate::approximation::{Function, Precision};
use crate::kernel::{Analytic, Specification};
use crate::program::{Operands, Operation, Program, ProgramBuilder, Value};
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

/// Half of what the square of a bivector has besides a scalar.
fn half_nilpotent(bivector: &Multivector, specification: &Specification) -> Result<Multivector, FactorError> {
    let square = mul(bivector, bivector, specification)?;
    let scalar = Multivector::scalar(square.coefficient(Blade::SCALAR));
    let nilpotent = square.sub(&scalar)?;
    check_nilpotent(&nilpotent, bivector, specification)?;
    Ok(nilpotent.scale(Rational::new(1, 2)?)?)
}

/// Values of a program under construction, each of which is a symbol of polynomials.
struct Values {
    builder: ProgramBuilder,
    given: Vec<Value>,
}

impl Values {
    /// Nothing but the inputs.
    fn new(specification: &Specification) -> Self {
        let mut builder = ProgramBuilder::new();
        let given = (0..specification.coefficients.len()).map(|input| builder.push(Operation::Input(input))).collect();
        Self { builder, given }
    }

    fn push(&mut self, operation: Operation) -> Value {
        self.builder.push(operation)
    }

    /// Makes a value a symbol.
    fn symbol(&mut self, value: Value) -> Polynomial {
        self.given.push(value);
        Polynomial::symbol((self.given.len() - 1) as Symbol)
    }

    /// The symbol of a function's polynomial.
    fn polynomial(&mut self, function: Function, precision: Precision, argument: Value) -> Polynomial {
        let value = self.push(Operation::Polynomial(function, precision, argument));
        self.symbol(value)
    }

    /// The values of polynomials.
    fn evaluate(&mut self, polynomials: &[Polynomial]) -> Result<Vec<Value>, FactorError> {
        Ok(greedy(System::new(polynomials, self.given.len())?).build(&mut self.builder, &self.given))
    }

    /// A multivector with a symbol, up to sign, for every coefficient, and the values of those symbols.
    fn symbols_for(&mut self, value: &Multivector) -> Result<(Multivector, Vec<(Blade, Value)>), FactorError> {
        let (mut terms, mut values) = (Vec::new(), Vec::new());
        for (blade, coefficient) in value.terms() {
            let symbol = coefficient.terms().next().filter(|(monomial, number)| {
                coefficient.term_count() == 1 && monomial.degree() == 1 && number.abs() == Rational::ONE
            });
            match symbol {
                Some((monomial, _)) => {
                    values.push((blade, self.given[usize::from(monomial.symbols()[0])]));
                    terms.push((blade, coefficient.clone()));
                }
                None => {
                    let value = self.evaluate(std::slice::from_ref(coefficient))?[0];
                    values.push((blade, value));
                    terms.push((blade, self.symbol(value)));
                }
            }
        }
        Ok((Multivector::from_terms(terms), values))
    }

    /// The multivector of values that are the coefficients of these terms.
    fn symbols(&mut self, terms: &[(Blade, Sign, Polynomial)], values: &[Value]) -> Multivector {
        let terms =
            terms.iter().zip(values).map(|(&(blade, sign, _), &value)| (blade, self.symbol(value).signed(sign)));
        Multivector::from_terms(terms.collect::<Vec<_>>())
    }

    /// The same with every value times a factor.
    fn scaled_symbols(&mut self, terms: &[(Blade, Sign, Polynomial)], values: &[Value], factor: Value) -> Multivector {
        let scaled: Vec<_> = values.iter().map(|&value| self.push(Operation::Mul(value, factor))).collect();
        self.symbols(terms, &scaled)
    }

    /// The finished program whose output is a multivector over the symbols.
    fn finish(mut self, value: &Multivector, specification: &Specification) -> Result<Program, FactorError> {
        let fields = specification.output.fields();
        let polynomials: Vec<_> = fields.map(|(_, c)| value.coefficient(c.blade).signed(c.sign)).collect();
        let outputs = self.evaluate(&polynomials)?;
        Ok(self.builder.finish(&outputs))
    }
}

/// A bivector b + c, where b squares to -A and c to 0, and the values of its coefficients.
struct Split {
    /// b + c
    bivector: Multivector,
    /// The symbols of b.
    euclidean: Vec<Symbol>,
    /// l = sqrt(A); none where there is no b.
    norm: Option<Value>,
}

impl Split {
    fn new(bivector: &Multivector, specification: &Specification, values: &mut Values) -> Result<Self, FactorError> {
        let (bivector, coefficients) = values.symbols_for(bivector)?;
        let (mut euclidean, mut norm) = (Vec::new(), Vec::new());
        for &(blade, value) in &coefficients {
            let unit = Multivector::term(blade, Polynomial::one());
            match mul(&unit, &unit, specification)?.coefficient(Blade::SCALAR).as_constant() {
                Some(Rational::ZERO) => {}
                Some(square) if square.is_negative() => {
                    let symbols = bivector.coefficient(blade);
                    euclidean.extend(symbols.terms().flat_map(|(monomial, _)| monomial.symbols().to_vec()));
                    norm.push(value);
                }
                _ => {
                    return no_closed_form(
                        "expected a bivector whose square is nowhere positive, found one that can be hyperbolic",
                    );
                }
            }
        }
        if norm.is_empty() {
            return Ok(Self { bivector, euclidean, norm: None });
        }
        let Some(operands) = Operands::new(&norm) else {
            return no_closed_form("expected a bivector with at most 8 coefficients of negative square, found more");
        };
        Ok(Self { bivector, euclidean, norm: Some(values.push(Operation::Norm(operands))) })
    }

    /// A multivector with n = b / l in place of b, times `factors[j]` where a monomial has j coefficients of b.
    fn polar(
        &self,
        value: &Multivector,
        directions: &[Polynomial],
        factors: &[&Polynomial],
    ) -> Result<Multivector, FactorError> {
        value.map(|coefficient| {
            let mut sum = Polynomial::zero();
            for (monomial, number) in coefficient.terms() {
                let (mut term, mut count) = (Polynomial::constant(number), 0);
                for &symbol in monomial.symbols() {
                    let place = self.euclidean.iter().position(|&other| other == symbol);
                    count += usize::from(place.is_some());
                    term = term.mul(&place.map_or_else(|| Polynomial::symbol(symbol), |at| directions[at].clone()))?;
                }
                let Some(factor) = factors.get(count) else {
                    return no_closed_form(
                        "expected a nilpotent part of a lower degree in the bivector, found another",
                    );
                };
                sum = sum.add(&term.mul(factor)?)?;
            }
            Ok(sum)
        })
    }

    /// The symbols of b / l, and 0 where l is 0.
    fn directions(&self, norm: Value, values: &mut Values) -> Vec<Polynomial> {
        let quotient = |&symbol: &Symbol| {
            let value = values.given[usize::from(symbol)];
            let quotient = values.push(Operation::Quotient(value, norm, Rational::ZERO));
            values.symbol(quotient)
        };
        self.euclidean.iter().map(quotient).collect()
    }
}

fn times(value: &Multivector, factor: &Polynomial) -> Result<Multivector, FactorError> {
    Ok(value.map(|coefficient| coefficient.mul(factor))?)
}

/// exp B = C + S N/2 + (S - g N/2) B.
pub(super) fn exp(specification: &Specification) -> Result<Program, FactorError> {
    let mut values = Values::new(specification);
    half_nilpotent(&specification.value, specification)?;
    let split = Split::new(&specification.value, specification, &mut values)?;
    let b = &split.bivector;
    let half = half_nilpotent(b, specification)?;
    let half_b = mul(&half, b, specification)?;
    let Some(norm) = split.norm else {
        let value = Multivector::scalar(Polynomial::one()).add(&half)?.add(b)?;
        return values.finish(&value.add(&half_b.scale(Rational::new(1, 3)?)?)?, specification);
    };
    let (cos_value, sin_value) = (values.push(Operation::Cos(norm)), values.push(Operation::Sin(norm)));
    let sinc_value = values.push(Operation::Quotient(sin_value, norm, Rational::ONE));
    let (cos, sinc) = (values.symbol(cos_value), values.symbol(sinc_value));
    if half.is_zero() {
        return values.finish(&Multivector::scalar(cos).add(&times(b, &sinc)?)?, specification);
    }
    let sin = values.symbol(sin_value);
    let directions = split.directions(norm, &mut values);
    let slope_value = values.push(Operation::Sub(cos_value, sinc_value));
    let slope = values.symbol(slope_value);
    // (C - S) / l and (C - S) / l^2, for what has b once or not at all in N B; not for motors.
    let once_value = values.push(Operation::Quotient(slope_value, norm, Rational::ZERO));
    let square = values.push(Operation::Mul(norm, norm));
    let never_value = values.push(Operation::Quotient(slope_value, square, Rational::new(-1, 3)?));
    let (once, never) = (values.symbol(once_value), values.symbol(never_value));
    let value = Multivector::scalar(cos)
        .add(&split.polar(&half, &directions, &[&sinc, &sin])?)?
        .add(&split.polar(b, &directions, &[&sinc, &sin])?)?
        .sub(&split.polar(&half_b, &directions, &[&never, &once, &slope])?)?;
    values.finish(&value, specification)
}

/// exp B with C, S and g as polynomials in A.
pub(super) fn exp_by_polynomials(specification: &Specification, precision: Precision) -> Result<Program, FactorError> {
    let mut values = Values::new(specification);
    let b = &specification.value;
    let half = half_nilpotent(b, specification)?;
    let square = mul(b, b, specification)?.coefficient(Blade::SCALAR).neg();
    if square.is_zero() {
        return no_closed_form("expected an exponential with a norm to approximate, found a polynomial");
    }
    let argument = values.evaluate(&[square])?[0];
    let [c, s, g] = [Function::CosRoot, Function::SincRoot, Function::SincSlope]
        .map(|function| values.polynomial(function, precision, argument));
    let value = Multivector::scalar(c)
        .add(&times(&half, &s)?)?
        .add(&times(b, &s)?)?
        .sub(&times(&mul(&half, b, specification)?, &g)?)?;
    values.finish(&value, specification)
}

/// log m with k and h as polynomials in 1 - s.
pub(super) fn log_by_polynomials(specification: &Specification, precision: Precision) -> Result<Program, FactorError> {
    let mut values = Values::new(specification);
    let m = &specification.value;
    let (scalar, v) = (m.coefficient(Blade::SCALAR), m.grade(2));
    let p = m.sub(&v)?.sub(&Multivector::scalar(scalar.clone()))?;
    check_nilpotent(&p, &v, specification)?;
    half_nilpotent(&v, specification)?;
    if scalar.as_constant().is_some() {
        return no_closed_form("expected a logarithm with an angle to approximate, found a polynomial");
    }
    let argument = values.evaluate(&[Polynomial::one().sub(&scalar)?])?[0];
    let [k, h] =
        [Function::AngleRatio, Function::AngleSlope].map(|function| values.polynomial(function, precision, argument));
    let value = times(&v, &k)?.sub(&times(&mul(&p, &v, specification)?, &h)?)?;
    values.finish(&value, specification)
}

/// log m = (k - h P) V.
pub(super) fn log(specification: &Specification) -> Result<Program, FactorError> {
    let mut values = Values::new(specification);
    let m = &specification.value;
    let (scalar, v) = (m.coefficient(Blade::SCALAR), m.grade(2));
    let p = m.sub(&v)?.sub(&Multivector::scalar(scalar.clone()))?;
    check_nilpotent(&p, &v, specification)?;
    half_nilpotent(&v, specification)?;
    let split = Split::new(&v, specification, &mut values)?;
    let v = &split.bivector;
    let Some(norm) = split.norm else { return values.finish(v, specification) };
    let s = values.evaluate(&[scalar])?[0];
    let angle_value = values.push(Operation::Atan2(norm, s));
    let ratio_value = values.push(Operation::Quotient(angle_value, norm, Rational::ONE));
    let ratio = values.symbol(ratio_value);
    if p.is_zero() {
        return values.finish(&times(v, &ratio)?, specification);
    }
    let angle = values.symbol(angle_value);
    let directions = split.directions(norm, &mut values);
    let one = values.push(Operation::Constant(Rational::ONE));
    let product = values.push(Operation::Mul(s, ratio_value));
    let rest_value = values.push(Operation::Sub(one, product));
    let square = values.push(Operation::Mul(norm, norm));
    let slope_value = values.push(Operation::Quotient(rest_value, square, Rational::new(1, 3)?));
    let (rest, slope) = (values.symbol(rest_value), values.symbol(slope_value));
    // h P V: h for what has no b; (1 - s k) (P / l) (b / l) for what has it.
    let half =
        split.polar(&half_nilpotent(v, specification)?, &directions, &[&Polynomial::zero(), &values.symbol(s)])?;
    let p_over_norm = half.add(&times(&p, &values.symbol(norm))?)?;
    let (p_over_norm, _) = values.symbols_for(&p_over_norm)?;
    let without = split.polar(v, &directions, &[&Polynomial::one(), &Polynomial::zero()])?;
    let with = split.polar(&v.sub(&without)?, &directions, &[&Polynomial::zero(), &rest])?;
    let value = split
        .polar(v, &directions, &[&ratio, &angle])?
        .sub(&times(&mul(&p, &without, specification)?, &slope)?)?
        .sub(&mul(&p_over_norm, &with, specification)?)?;
    values.finish(&value, specification)
}

/// y (1 - N / (2 A)) / sqrt(A), each coefficient as i (y - (i N / 2) (i y)) with i = 1 / sqrt(A).
pub(super) fn normalize(specification: &Specification) -> Result<Program, FactorError> {
    let norm = specification.study_norm("").map_err(|error| FactorError::NoClosedForm(error.to_string()))?;
    let mut values = Values::new(specification);
    let y = signed_terms(&specification.unnormalized()?, specification);
    let half = signed_terms(&norm.nilpotent.scale(Rational::new(1, 2)?)?, specification);
    let polynomials: Vec<_> = y.iter().chain(&half).map(|(_, _, c)| c.clone()).chain([norm.scalar.clone()]).collect();
    let evaluated = values.evaluate(&polynomials)?;
    let (y_values, half_values) = evaluated.split_at(y.len());
    let plain = values.symbols(&y, y_values);
    // The root of a unit relies on the promise that it is one. What is normalised is measured as it is, with its rounding
    // errors, so that the result is a unit however much cancelled in it.
    let square = match specification.analytic {
        Some(Analytic::Sqrt) => evaluated[evaluated.len() - 1],
        _ => values.evaluate(&[mul(&plain, &plain.reverse(), specification)?.coefficient(Blade::SCALAR)])?[0],
    };
    let root = values.push(Operation::Sqrt(square));
    let one = values.push(Operation::Constant(Rational::ONE));
    let inverse = values.push(Operation::Div(one, root));
    let scaled = values.scaled_symbols(&y, y_values, inverse);
    let half = values.scaled_symbols(&half, half_values, inverse);
    let correction = mul(&half, &scaled, specification)?;
    let mut outputs = Vec::new();
    for (_, component) in specification.output.fields() {
        let signed = |value: &Multivector| value.coefficient(component.blade).signed(component.sign);
        outputs.push(if signed(&correction).is_zero() {
            values.evaluate(&[signed(&scaled)])?[0]
        } else {
            let rest = values.evaluate(&[signed(&plain).sub(&signed(&correction))?])?[0];
            values.push(Operation::Mul(rest, inverse))
        });
    }
    Ok(values.builder.finish(&outputs))
}

/// The coefficients of a multivector with the signs that they have in the output.
fn signed_terms(value: &Multivector, specification: &Specification) -> Vec<(Blade, Sign, Polynomial)> {
    let sign = |blade: Blade| {
        let component = specification.output.components.iter().find(|component| component.blade == blade);
        component.map_or(Sign::Plus, |component| component.sign)
    };
    value.terms().map(|(blade, c)| (blade, sign(blade), c.clone().signed(sign(blade)))).collect()
}
