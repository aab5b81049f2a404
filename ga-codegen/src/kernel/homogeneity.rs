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
use std::collections::BTreeMap;
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
    /// Equations by their first unknown, which has the factor 1.
    rows: BTreeMap<usize, Row>,
}

impl Dimensions {
    /// What the types fix by their constants.
    fn new(inputs: &[&Entity], signature: Signature) -> Self {
        let mut dimensions = Self { symbols: Vec::new(), unknowns: inputs.len() + 1, rows: BTreeMap::new() };
        for (parameter, entity) in inputs.iter().enumerate() {
            for component in &entity.components {
                let degree = i64::from(component.blade.null_degree(signature));
                match component.value {
                    ComponentValue::Field(_) => dimensions.symbols.push((parameter, degree)),
                    ComponentValue::Constant(value) if value.is_zero() => {}
                    ComponentValue::Constant(_) => {
                        let mut row = Row::default();
                        row.add(parameter, Rational::ONE);
                        row.add(dimensions.unknowns, Rational::integer(degree));
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

    fn row(&self, monomial: &Monomial) -> Row {
        let mut row = Row::default();
        row.add(self.unknowns, Rational::integer(self.degree(monomial)));
        monomial.symbols().iter().for_each(|&symbol| row.add(self.symbols[usize::from(symbol)].0, Rational::ONE));
        row
    }

    /// Requires that a monomial has this degree, up to the constant of the result where it belongs to that; else by how
    /// much it is off.
    fn require(&mut self, monomial: &Monomial, degree: i64, of_result: bool) -> Result<(), Rational> {
        let mut row = self.row(monomial);
        row.add(self.unknowns, Rational::integer(-degree));
        if of_result {
            row.add(self.unknowns - 1, Rational::MINUS_ONE);
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
            let mut row = self.row(&monomial);
            row.subtract(Rational::ONE, &measure);
            self.add(row).map_err(|excess| (monomial, excess))?;
        }
        Ok(())
    }

    /// Adds an equation; the excess of its constant where it contradicts the others.
    fn add(&mut self, mut row: Row) -> Result<(), Rational> {
        while let Some((&place, &factor)) = row.0.first_key_value() {
            if place == self.unknowns {
                return Err(factor);
            }
            let Some(known) = self.rows.get(&place) else {
                self.rows.insert(place, row.divided_by(factor));
                return Ok(());
            };
            row.subtract(factor, known);
        }
        Ok(())
    }
}

/// A sum of multiples of the unknowns, and of 1 at the place after them, that is 0; what it does not name has the factor 0.
#[derive(Default)]
struct Row(BTreeMap<usize, Rational>);

impl Row {
    fn add(&mut self, place: usize, number: Rational) {
        let sum = self.0.get(&place).unwrap_or(&Rational::ZERO).checked_add(number).expect(SMALL);
        if sum.is_zero() {
            self.0.remove(&place)
        } else {
            self.0.insert(place, sum)
        };
    }

    fn subtract(&mut self, factor: Rational, other: &Self) {
        for (&place, number) in &other.0 {
            self.add(place, factor.neg().checked_mul(*number).expect(SMALL));
        }
    }

    fn divided_by(mut self, divisor: Rational) -> Self {
        for number in self.0.values_mut() {
            *number = number.checked_div(divisor).expect(SMALL).expect("invariant: a first factor is not 0");
        }
        self
    }
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
