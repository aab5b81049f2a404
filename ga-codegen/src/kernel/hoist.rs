//! Splitting a kernel by what is uniform: inputs that stay the same over many calls.
//!
//! Every output of a kernel that is linear in its varying inputs v is a sum of c(u) and c(u) v_j with polynomials c in the
//! uniform inputs u. The prepare part computes those coefficients, once, into a record of their own; the apply part is the
//! sum. Coefficients that the relations make equal up to sign share a field, constant ones need none. Both parts are
//! proved like any kernel, and so is that one after the other gives the kernel back.

use super::{Coefficient, Expression, ExpressionKind, Kernel, Specification};
use crate::symbolic::{Monomial, Multivector, Overflow, Polynomial, Rational, Relations, Symbol};
use proc_macro2::Span;
use std::collections::BTreeMap;

/// The names of a kernel's parts.
#[derive(Clone, Debug)]
pub struct Hoist {
    /// The struct between the parts.
    pub record: String,
    /// The function from the uniform inputs to the record.
    pub prepare: String,
    /// The function from the record and the varying inputs to the output.
    pub apply: String,
    /// Where the struct's name stands.
    pub span: Span,
}

/// Which terms of which output make up the fields of a record.
#[derive(Clone, Debug)]
pub struct Projection {
    /// For every field, the output that it goes into and the varying input that it is a factor of, if any.
    pub labels: Vec<(String, Option<String>)>,
    varying: Vec<bool>,
    sources: Vec<(usize, Monomial)>,
}

impl Projection {
    /// The fields, from polynomials that equal the kernel's outputs modulo the relations.
    ///
    /// # Errors
    /// [`Overflow`]
    pub fn fields(&self, outputs: &[Polynomial]) -> Result<Vec<Polynomial>, Overflow> {
        self.sources.iter().map(|(output, varying)| self.coefficient(&outputs[*output], varying)).collect()
    }

    fn coefficient(&self, output: &Polynomial, varying: &Monomial) -> Result<Polynomial, Overflow> {
        let mut coefficient = Polynomial::zero();
        for (monomial, number) in output.terms() {
            let (uniform, found) = self.split(monomial);
            if found == *varying {
                coefficient.add_term(uniform, number)?;
            }
        }
        Ok(coefficient)
    }

    /// The uniform and the varying part of a monomial.
    fn split(&self, monomial: &Monomial) -> (Monomial, Monomial) {
        let (varying, uniform) = monomial.symbols().iter().partition(|&&symbol| self.varying[usize::from(symbol)]);
        (Monomial::new(uniform), Monomial::new(varying))
    }
}

/// A coefficient that a field of the record holds already.
struct Known {
    normal_form: Polynomial,
    field: usize,
}

/// The specifications of the prepare and of the apply part.
///
/// # Errors
/// A kernel that is not linear in its varying inputs; overflow.
pub fn split(kernel: &Kernel, specification: &Specification) -> Result<(Specification, Specification), String> {
    let overflow = |error: Overflow| error.to_string();
    let uniform = |coefficient: &Coefficient| kernel.uniform[coefficient.parameter];
    let varying: Vec<bool> = specification.coefficients.iter().map(|coefficient| !uniform(coefficient)).collect();
    let mut projection = Projection { labels: Vec::new(), varying, sources: Vec::new() };
    let (mut known, mut names): (Vec<Known>, Vec<String>) = (Vec::new(), Vec::new());
    let first_field = specification.coefficients.len() as Symbol;
    let mut sums = Vec::new();
    for (index, output) in specification.outputs.iter().enumerate() {
        let mut sum = Polynomial::zero();
        for term in linear_terms(&projection, output, specification)? {
            let coefficient = projection.coefficient(output, &term).map_err(overflow)?;
            let reduced = specification.relations.normal_form(&coefficient).map_err(overflow)?;
            let (factor, field) = match reduced.as_constant() {
                Some(number) => (number, None),
                None => {
                    let (sign, field) = find_field(&mut known, &reduced);
                    if field == names.len() {
                        let label = label(kernel, specification, index, &term);
                        names.push(field_name(&label, &names));
                        projection.labels.push(label);
                        projection.sources.push((index, term.clone()));
                    }
                    (sign, Some(Monomial::new(vec![first_field + field as Symbol])))
                }
            };
            sum.add_term(term.times(&field.unwrap_or_default()), factor).map_err(overflow)?;
        }
        sums.push(sum);
    }
    if names.is_empty() {
        return Err("expected an output that depends on the uniform inputs, found none".to_owned());
    }
    let prepare = prepare(specification, projection, names).map_err(overflow)?;
    check_composition(specification, &prepare, &sums).map_err(overflow)?;
    let apply = apply(kernel, specification, &prepare, sums);
    Ok((prepare, apply))
}

/// The varying parts of an output's terms, none of more than first degree.
fn linear_terms(
    projection: &Projection,
    output: &Polynomial,
    specification: &Specification,
) -> Result<Vec<Monomial>, String> {
    let terms: BTreeMap<Monomial, ()> =
        output.terms().map(|(monomial, _)| (projection.split(monomial).1, ())).collect();
    if let Some(term) = terms.keys().find(|term| term.degree() > 1) {
        let text = Polynomial::term(term.clone(), Rational::ONE).display(&specification.names());
        return Err(format!("expected a definition that is linear in the varying inputs, found a term with {text}"));
    }
    Ok(terms.into_keys().collect())
}

/// The field that holds a normal form, up to sign; a new one if there is none.
fn find_field(known: &mut Vec<Known>, reduced: &Polynomial) -> (Rational, usize) {
    let negative = reduced.neg();
    for other in known.iter() {
        if other.normal_form == *reduced {
            return (Rational::ONE, other.field);
        }
        if other.normal_form == negative {
            return (Rational::MINUS_ONE, other.field);
        }
    }
    known.push(Known { normal_form: reduced.clone(), field: known.len() });
    (Rational::ONE, known.len() - 1)
}

/// An output and a varying input that goes into it; no input for what is always added.
fn label(kernel: &Kernel, specification: &Specification, output: usize, term: &Monomial) -> (String, Option<String>) {
    let several = kernel.uniform.iter().filter(|uniform| !**uniform).count() > 1;
    let input = term.symbols().first().map(|&symbol| {
        let coefficient = &specification.coefficients[usize::from(symbol)];
        if several || coefficient.field.is_empty() { coefficient.name.clone() } else { coefficient.field.clone() }
    });
    (specification.fields[output].clone(), input)
}

/// `OUTPUT_INPUT`, such as `x_y` for what y contributes to x, and `x_1` for what is always added; for a scalar output
/// `by_INPUT`. A number behind it where that is taken.
fn field_name((output, input): &(String, Option<String>), taken: &[String]) -> String {
    let output = if output.is_empty() { "by" } else { output };
    let input = input.as_deref().unwrap_or("1").replace('.', "_");
    let name = format!("{output}_{input}");
    let numbered = (2..).map(|number| format!("{name}_{number}"));
    let mut names = std::iter::once(name.clone()).chain(numbered);
    names.find(|name| !taken.contains(name)).expect("invariant: numbers do not run out")
}

fn prepare(
    specification: &Specification,
    projection: Projection,
    names: Vec<String>,
) -> Result<Specification, Overflow> {
    let outputs = projection.fields(&specification.outputs)?;
    Ok(Specification { outputs, fields: names, projection: Some(projection), ..specification.clone() })
}

/// The apply part: the varying inputs keep their symbols, the record's fields come behind all inputs.
fn apply(
    kernel: &Kernel,
    specification: &Specification,
    prepare: &Specification,
    outputs: Vec<Polynomial>,
) -> Specification {
    let mut coefficients = specification.coefficients.clone();
    coefficients.extend(prepare.fields.iter().zip(prepare.output_degrees()).map(|(field, degree)| Coefficient {
        parameter: kernel.parameters.len(),
        field: field.clone(),
        name: format!("{}.{field}", Hoist::RECORD),
        degree,
    }));
    Specification {
        coefficients,
        relations: Relations::default(),
        stated: Vec::new(),
        inputs: Vec::new(),
        expression: Expression { kind: ExpressionKind::Number(Rational::ZERO), span: specification.expression.span },
        value: Multivector::zero(),
        outputs,
        ..specification.clone()
    }
}

impl Hoist {
    /// The name of the record among the inputs of the apply part.
    pub const RECORD: &'static str = "prepared";
}

/// Proves that applying what was prepared is the kernel.
fn check_composition(
    specification: &Specification,
    prepare: &Specification,
    sums: &[Polynomial],
) -> Result<(), Overflow> {
    let inputs = (0..specification.coefficients.len()).map(|symbol| Polynomial::symbol(symbol as Symbol));
    let values: Vec<_> = inputs.chain(prepare.outputs.iter().cloned()).collect();
    for (sum, output) in sums.iter().zip(&specification.outputs) {
        let difference = specification.relations.difference(&sum.substitute(&values)?, output)?;
        assert!(difference.is_zero(), "invariant: the coefficients of a linear polynomial add up to it");
    }
    Ok(())
}
