//! Different polynomials that are equal modulo the relations of the inputs, as starting points of the extraction.

use super::oriented;
use crate::kernel::Specification;
use crate::symbolic::{Monomial, Overflow, Polynomial, Rational};

/// The outputs as they expand, their normal forms, and the outputs less or plus the coefficient of the transformed input
/// times a relation with a constant term: (s^2 + b.b) x - (s^2 + b.b - 1) x has fewer monomials.
pub(super) fn variants(specification: &Specification) -> Result<Vec<Vec<Polynomial>>, Overflow> {
    let expanded = specification.outputs();
    let reduced: Result<Vec<_>, _> = expanded.iter().map(|p| specification.relations.normal_form(p)).collect();
    let mut variants = vec![expanded.clone(), reduced?];
    let transformed = transformed_input(specification);
    for relation in specification.unit_relations() {
        for sign in [Rational::ONE, Rational::MINUS_ONE] {
            let mut outputs = Vec::new();
            for (output, input) in expanded.iter().zip(&transformed) {
                let mut output = output.clone();
                for (monomial, coefficient) in input.terms() {
                    output.add_multiple(coefficient.checked_mul(sign)?, monomial, &relation)?;
                }
                outputs.push(output);
            }
            variants.push(outputs);
        }
    }
    variants.dedup();
    Ok(variants)
}

/// For every field of the output the same component of the last input of the output's type, or 0.
fn transformed_input(specification: &Specification) -> Vec<Polynomial> {
    let input = specification.inputs.iter().rev().find(|input| {
        let holds = |blade| specification.output.components.iter().any(|component| component.blade == blade);
        input.terms().count() == specification.output.components.len() && input.terms().all(|(blade, _)| holds(blade))
    });
    let component = |component: &crate::kernel::Component| {
        input.map_or_else(Polynomial::zero, |input| oriented(input.coefficient(component.blade), component.sign))
    };
    specification.output.fields().map(|(_, c)| component(c)).collect()
}

impl Specification {
    /// The relations of the inputs that have a constant term.
    fn unit_relations(&self) -> impl Iterator<Item = Polynomial> {
        self.stated.iter().filter(|polynomial| !polynomial.coefficient(&Monomial::default()).is_zero()).cloned()
    }
}
