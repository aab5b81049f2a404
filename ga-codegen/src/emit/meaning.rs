//! What temporaries mean: names for values of a program that are coefficients of something in the definition.
//!
//! - `two_e31`, `two_inner_e1`: twice an input coefficient or another named value;
//! - `half_x`: half of what an output differs by from another value;
//! - `cross_e032`: a coefficient, up to sign, of (m x - x m)/2 in a sandwich m x ~m;
//! - `inner_e1`: one of the product that a larger product is made of, such as m x in m x ~m or a x in a x a.

use crate::algebra::{Blade, Product};
use crate::compile::{Compiled, Part};
use crate::kernel::{Expression, ExpressionKind, Operator, Specification};
use crate::program::{Operation, Program, Value};
use crate::proof::evaluate_polynomials;
use crate::symbolic::{Multivector, Overflow, Polynomial};
use std::collections::BTreeMap;

/// Names for the values of a program; distinct, but none is promised.
pub(super) fn names(compiled: &Compiled) -> BTreeMap<Value, String> {
    let mut names = doublings(&compiled.program, &compiled.specification);
    if compiled.part == Part::Whole {
        names.extend(halves(&compiled.program, &compiled.specification));
    }
    if compiled.part == Part::Whole && compiled.specification.analytic.is_none() {
        names.extend(coefficients(&compiled.program, &compiled.specification).unwrap_or_default());
    }
    for (value, operation) in compiled.program.operations.iter().enumerate() {
        let Operation::Double(inner) = operation else { continue };
        if let Some(name) = names.get(inner).filter(|name| !name.starts_with("half_")) {
            names.insert(value, format!("two_{name}"));
        }
    }
    names
}

/// Twice an input.
fn doublings(program: &Program, specification: &Specification) -> BTreeMap<Value, String> {
    let mut names = BTreeMap::new();
    for (value, operation) in program.operations.iter().enumerate() {
        let Operation::Double(inner) = *operation else { continue };
        let Operation::Input(input) = program.operations[inner] else { continue };
        let coefficient = &specification.coefficients[input];
        let field = |name: &str| specification.coefficients.iter().filter(|c| c.field == name).count();
        let name = if field(&coefficient.field) == 1 && !coefficient.field.is_empty() {
            coefficient.field.clone()
        } else {
            coefficient.name.replace('.', "_")
        };
        names.insert(value, format!("two_{name}"));
    }
    names
}

/// What is doubled in an output, as in x + 2 (...).
fn halves(program: &Program, specification: &Specification) -> BTreeMap<Value, String> {
    let mut names = BTreeMap::new();
    for (field, &output) in specification.fields.iter().zip(&program.outputs) {
        let (Operation::Add(a, b) | Operation::Sub(a, b)) = program.operations[output] else { continue };
        let half = |side: Value| match halved(program, side) {
            Some(inner) if !field.is_empty() => Some(inner),
            _ => None,
        };
        if let (Some(inner), None) | (None, Some(inner)) = (half(a), half(b)) {
            names.insert(inner, format!("half_{field}"));
        }
    }
    names
}

/// What a value is the double of.
fn halved(program: &Program, value: Value) -> Option<Value> {
    match program.operations[value] {
        Operation::Double(inner) => Some(inner),
        _ => None,
    }
}

/// The parts of a definition whose coefficients make good names: a prefix and the multivector.
fn parts(specification: &Specification) -> Result<Vec<(&'static str, Multivector)>, Overflow> {
    let value = |expression: &Expression| expression.evaluate(&specification.inputs, &specification.basis);
    let mut expression = &specification.expression;
    while let ExpressionKind::Negate(inner) = &expression.kind {
        expression = inner;
    }
    let mut parts = Vec::new();
    match &expression.kind {
        ExpressionKind::Binary(Operator::Sandwich, m, x) => {
            let (m, x) = (value(m)?, value(x)?);
            parts.push(("cross", m.product(Product::Commutator, &x, &specification.basis)?));
            parts.push(("inner", m.product(Product::Geometric, &x, &specification.basis)?));
        }
        ExpressionKind::Binary(_, left, right) => {
            for side in [left, right] {
                if matches!(side.kind, ExpressionKind::Binary(..)) {
                    parts.push(("inner", value(side)?));
                    break;
                }
            }
        }
        _ => {}
    }
    Ok(parts)
}

fn coefficients(program: &Program, specification: &Specification) -> Result<BTreeMap<Value, String>, Overflow> {
    let mut names = BTreeMap::new();
    let parts = parts(specification)?;
    if parts.is_empty() {
        return Ok(names);
    }
    let Some(values) = evaluate_polynomials(program, specification.coefficients.len()) else { return Ok(names) };
    for (value, polynomial) in values.iter().enumerate().filter(|(_, polynomial)| polynomial.term_count() > 1) {
        let negative = polynomial.neg();
        let is_it = |(_, coefficient): &(Blade, &Polynomial)| *coefficient == polynomial || **coefficient == negative;
        let found = parts.iter().find_map(|(prefix, part)| Some((prefix, part.terms().find(is_it)?.0)));
        if let Some((prefix, blade)) = found {
            let blade = &specification.basis.named(blade).name;
            names.insert(value, format!("{prefix}_{}", if blade == "1" { "s" } else { blade }));
        }
    }
    Ok(names)
}
