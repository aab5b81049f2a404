//! Whether definitions keep their meaning under a change of the unit of length.
//!
//! Where generators square to 0, scaling them by a number is a change of the unit of length: the coefficient of a blade
//! gets the factor once for every null generator, and a definition that means anything geometric commutes with that. So
//! every monomial of an output has the degree of the output's blade, where a coefficient of an input has the degree of
//! its own blade, up to
//! - one constant for the kernel: each join adds one for each null generator;
//! - one constant for each input, as a scalar may be a length and a direction a pure number: what its type, constants and
//!   relations included, and its uses leave undecided is free.
//!
//! Every monomial is an equation between these constants; they must have a solution. Duals are exempt: they exchange
//! Euclidean and ideal coefficients.

use super::{
    Analytic, ComponentValue, Definition, Entity, Expression, ExpressionKind, Function, Kernel, Specification,
};
use crate::algebra::Signature;
use crate::symbolic::{Monomial, Polynomial, Rational};
use proc_macro2::Span;
use std::fmt;

/// A monomial whose degree in the unit of length is not that of the others.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Inhomogeneous {
    /// The output's coefficient or the relation that has the monomial.
    pub place: String,
    /// The monomial.
    pub monomial: String,
    /// The degree that it should have.
    pub expected: Rational,
    /// The degree that it has.
    pub found: Rational,
}

impl fmt::Display for Inhomogeneous {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { place, monomial, expected, found } = self;
        write!(
            f,
            "expected {place} to have one degree in the unit of length, found the monomial {monomial} of degree {found} \
             where {expected} is expected: are Euclidean and ideal coefficients swapped?"
        )
    }
}

/// Checks that a kernel commutes with a change of the unit of length.
///
/// # Errors
/// The first monomial whose degree contradicts what those before it fix.
pub fn check_kernel(
    definition: &Definition,
    kernel: &Kernel,
    specification: &Specification,
) -> Result<(), Inhomogeneous> {
    let signature = specification.basis.signature();
    if signature.null() == 0 || has_dual(&specification.expression) {
        return Ok(());
    }
    let inputs: Vec<_> = kernel.parameters.iter().map(|parameter| &definition.entities[parameter.entity]).collect();
    let mut dimensions = Dimensions::new(&inputs, signature);
    for polynomial in &specification.stated {
        // What contradicts itself here is reported at the relation.
        let _ = dimensions.require_equal(polynomial);
    }
    if matches!(specification.analytic, Some(Analytic::Exp | Analytic::Log | Analytic::Sqrt)) {
        // The powers in a series have one degree together only where the argument has none of its own.
        let _ = dimensions.require(&Monomial::default(), 0, true);
    }
    for (blade, coefficient) in specification.value.terms() {
        let own = i64::from(blade.null_degree(signature));
        for (monomial, _) in coefficient.terms() {
            dimensions.require(monomial, own, true).map_err(|excess| {
                let place = format!("the coefficient of `{}`", specification.basis.named(blade).name);
                inhomogeneous(place, monomial, &specification.names(), dimensions.degree(monomial), excess)
            })?;
        }
    }
    Ok(())
}

/// Checks that every relation of a definition, of its types and of its kernels, has one degree; where those stand that have
/// not, and why.
pub fn check_relations(definition: &Definition) -> Vec<(Span, Inhomogeneous)> {
    let signature = definition.basis.signature();
    let mut wrong = Vec::new();
    if signature.null() == 0 {
        return wrong;
    }
    for entity in &definition.entities {
        let names: Vec<_> = entity.fields().map(|(name, _)| name.to_owned()).collect();
        check_statements(&mut Dimensions::new(&[entity], signature), &entity.statements, &names, &mut wrong);
    }
    for kernel in &definition.kernels {
        let inputs: Vec<_> = kernel.parameters.iter().map(|parameter| &definition.entities[parameter.entity]).collect();
        let mut dimensions = Dimensions::new(&inputs, signature);
        let (mut names, mut first) = (Vec::new(), 0);
        for (parameter, entity) in kernel.parameters.iter().zip(&inputs) {
            for statement in &entity.statements {
                let _ = dimensions.require_equal(statement.relation.shifted(first).polynomial());
            }
            names.extend(entity.fields().map(|(field, _)| format!("{}.{field}", parameter.name)));
            first = names.len() as crate::symbolic::Symbol;
        }
        check_statements(&mut dimensions, &kernel.statements, &names, &mut wrong);
    }
    wrong
}

fn check_statements(
    dimensions: &mut Dimensions,
    statements: &[super::Statement],
    names: &[String],
    wrong: &mut Vec<(Span, Inhomogeneous)>,
) {
    for statement in statements {
        if let Err((monomial, excess)) = dimensions.require_equal(statement.relation.polynomial()) {
            let place = format!("the relation `{}`", statement.text);
            let degree = dimensions.degree(&monomial);
            wrong.push((statement.span, inhomogeneous(place, &monomial, names, degree, excess)));
        }
    }
}

fn inhomogeneous(place: String, monomial: &Monomial, names: &[String], found: i64, excess: Rational) -> Inhomogeneous {
    let monomial = Polynomial::term(monomial.clone(), Rational::ONE).display(names);
    let found = Rational::integer(found);
    let expected = found.checked_add(excess.neg()).expect(SMALL);
    Inhomogeneous { place, monomial, expected, found }
}

const SMALL: &str = "invariant: degrees are small numbers";

/// What is known of the constants by which the degrees of inputs and of the result are shifted.
struct Dimensions {
    /// The parameter of every symbol and the degree of its blade.
    symbols: Vec<(usize, i64)>,
    /// The number of unknowns: one for every input and one for the result.
    unknowns: usize,
    /// Sums of multiples of the unknowns and of 1 that are 0; the first of the numbers that is not 0 is 1.
    rows: Vec<Vec<Rational>>,
}

impl Dimensions {
    /// What the types fix by their constants.
    fn new(inputs: &[&Entity], signature: Signature) -> Self {
        let mut dimensions = Self { symbols: Vec::new(), unknowns: inputs.len() + 1, rows: Vec::new() };
        for (parameter, entity) in inputs.iter().enumerate() {
            for component in &entity.components {
                let degree = i64::from(component.blade.null_degree(signature));
                match component.value {
                    ComponentValue::Field(_) => dimensions.symbols.push((parameter, degree)),
                    ComponentValue::Constant(value) if value.is_zero() => {}
                    ComponentValue::Constant(_) => {
                        let mut row = vec![Rational::ZERO; dimensions.unknowns + 1];
                        row[parameter] = Rational::ONE;
                        row[dimensions.unknowns] = Rational::integer(degree);
                        // A type with constants of different degrees fixes a length; the first of them counts.
                        let _ = dimensions.add(row);
                    }
                }
            }
        }
        dimensions
    }

    /// The degree of a monomial by the blades of its coefficients.
    fn degree(&self, monomial: &Monomial) -> i64 {
        monomial.symbols().iter().map(|&symbol| self.symbols[usize::from(symbol)].1).sum()
    }

    fn row(&self, monomial: &Monomial) -> Vec<Rational> {
        let mut row = vec![0; self.unknowns + 1];
        row[self.unknowns] = self.degree(monomial);
        monomial.symbols().iter().for_each(|&symbol| row[self.symbols[usize::from(symbol)].0] += 1);
        row.into_iter().map(Rational::integer).collect()
    }

    /// Requires that a monomial has this degree, up to the constant of the result where it belongs to that; else by how
    /// much it is off.
    fn require(&mut self, monomial: &Monomial, degree: i64, of_result: bool) -> Result<(), Rational> {
        let mut row = self.row(monomial);
        row[self.unknowns] = row[self.unknowns].checked_add(Rational::integer(-degree)).expect(SMALL);
        if of_result {
            row[self.unknowns - 1] = Rational::MINUS_ONE;
        }
        self.add(row)
    }

    /// Requires that all monomials have the same degree; else which has not, and by how much it is off.
    fn require_equal(&mut self, polynomial: &Polynomial) -> Result<(), (Monomial, Rational)> {
        let monomials: Vec<_> = polynomial.terms().map(|(monomial, _)| monomial).collect();
        let alike = |a: &&Monomial| monomials.iter().filter(|b| self.degree(b) == self.degree(a)).count();
        // The odd one out is to blame, so most of the others are the measure.
        let Some(measure) = monomials.iter().copied().max_by_key(alike) else { return Ok(()) };
        let measure = self.row(measure);
        for monomial in monomials.into_iter().cloned() {
            let row = subtract(&self.row(&monomial), Rational::ONE, &measure);
            self.add(row).map_err(|excess| (monomial, excess))?;
        }
        Ok(())
    }

    /// Adds an equation; the excess of its constant where it contradicts the others.
    fn add(&mut self, mut row: Vec<Rational>) -> Result<(), Rational> {
        let pivot = |row: &[Rational]| row.iter().position(|number| !number.is_zero());
        for known in &self.rows {
            let place = pivot(known).expect("invariant: equations that say nothing are not kept");
            row = subtract(&row, row[place], known);
        }
        match pivot(&row) {
            None => Ok(()),
            Some(place) if place == self.unknowns => Err(row[place]),
            Some(place) => {
                let leading = row[place];
                let normal = |number: Rational| number.checked_div(leading).expect(SMALL).unwrap_or(Rational::ZERO);
                self.rows.push(row.into_iter().map(normal).collect());
                Ok(())
            }
        }
    }
}

/// a - factor b
fn subtract(a: &[Rational], factor: Rational, b: &[Rational]) -> Vec<Rational> {
    let entry = |(a, b): (&Rational, &Rational)| a.checked_add(factor.neg().checked_mul(*b)?);
    a.iter().zip(b).map(|pair| entry(pair).expect(SMALL)).collect()
}

/// Whether a dual is taken anywhere in an expression.
fn has_dual(expression: &Expression) -> bool {
    match &expression.kind {
        ExpressionKind::Parameter(_) | ExpressionKind::Blade(..) | ExpressionKind::Number(_) => false,
        ExpressionKind::Negate(inner)
        | ExpressionKind::Reverse(inner)
        | ExpressionKind::Grade(inner, _)
        | ExpressionKind::Quotient(inner, _) => has_dual(inner),
        ExpressionKind::Binary(_, a, b) => has_dual(a) || has_dual(b),
        ExpressionKind::Call(Function::Dual | Function::Undual, _) => true,
        ExpressionKind::Call(_, arguments) => arguments.iter().any(has_dual),
    }
}
