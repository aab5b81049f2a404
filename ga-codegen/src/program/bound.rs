//! How far a program's floating-point results can be from its exact ones.

mod packing;
mod spectral;
mod weighted;

use super::{Operation, Program};
use crate::algebra::Signature;
use crate::kernel::{Entity, Specification};
use crate::symbolic::{Monomial, Polynomial, Rational, Symbol, effort};
use packing::Packing;
use std::collections::BTreeMap;
use weighted::Weighted;

/// A group of coefficients that scale alike with the unit of length.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Group {
    /// The coefficients of blades without a null generator.
    Euclidean,
    /// Those of blades with one.
    Ideal,
}

impl Group {
    /// The group of the coefficients of this degree in the unit of length.
    pub const fn of_degree(degree: u32) -> Self {
        if degree == 0 { Self::Euclidean } else { Self::Ideal }
    }

    /// Its name in documentation and reports.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Euclidean => "Euclidean",
            Self::Ideal => "ideal",
        }
    }
}

/// The 2-norm of the free coefficients of one group of one parameter.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Norm {
    /// The parameter.
    pub parameter: usize,
    /// The group.
    pub group: Group,
}

/// A number times a product of norms.
#[derive(Clone, Debug, PartialEq)]
pub struct BoundTerm {
    /// The number.
    pub factor: f64,
    /// The norms, repeated according to their powers.
    pub norms: Vec<Norm>,
}

/// The bound of one group of the output.
#[derive(Clone, Debug, PartialEq)]
pub struct GroupBound {
    /// The group.
    pub group: Group,
    /// The terms of the bound, to be added. None where nothing is rounded.
    pub terms: Vec<BoundTerm>,
}

/// A bound of the 2-norm of the rounding error of a polynomial program, for each group of its outputs.
///
/// # Roundings
/// In the standard model of floating-point arithmetic an operation returns its exact result times 1 + d with |d| <= u, the
/// unit roundoff (2^-24 for f32, 2^-53 for f64), where nothing overflows or underflows. Expand a program without cancelling
/// anything: every term of an output is a product of inputs and constants, and what is computed is the sum of these
/// terms, each times a factor 1 + d for every rounding that it went through. Negations, doublings and products with powers
/// of two round nothing. A product of k such factors is 1 + t with |t| <= k u / (1 - k u): N. J. Higham, *Accuracy and
/// Stability of Numerical Algorithms*, 2nd edition, Lemma 3.1. So, with K the most roundings of a term and x the inputs,
/// ```text
/// |computed_i - exact_i| <= u / (1 - K u) E_i(|x|),    E_i = sum over the terms of  roundings |coefficient| |monomial|.
/// ```
/// That is no first-order estimate, and it remains true where a product and a sum are fused into one rounding.
///
/// # Norms
/// The coefficients of a multivector are two groups, which scale differently with the unit of length: those of blades
/// without a null generator, the Euclidean group, and all others, the ideal group. Take the outputs of one group and, in
/// their E_i, the monomials of one multidegree in the groups of the inputs. The square of the product of the groups' norms,
/// expanded, is the sum of w monomial^2 with multinomial coefficients w. So if A is the matrix of the coefficients in the
/// E_i, each divided by the root of its monomial's w, this part of the E_i has a 2-norm of at most |A|, the spectral norm,
/// times the product of the norms. Added up,
/// ```text
/// |computed - exact| of a group of outputs <= u / (1 - K u) sum over the multidegrees of  |A| product of norms
/// ```
/// for all inputs, whether or not they keep what their types promise. Both sides scale alike with the unit of length. |A| is
/// computed from above.
#[derive(Clone, Debug, PartialEq)]
pub struct Bound {
    /// K, the most roundings that a term goes through.
    pub roundings: u32,
    /// The groups of the output that have fields, Euclidean first.
    pub groups: Vec<GroupBound>,
}

impl Bound {
    /// The bound of a program; `None` where it is no polynomial, or has more than some thirty parameters.
    pub fn new(specification: &Specification, program: &Program) -> Option<Self> {
        let packing = Packing::new(specification, program)?;
        let values = weigh(&packing, program)?;
        let degrees = specification.output_degrees();
        let mut groups = Vec::new();
        let mut roundings = 0;
        for group in [Group::Euclidean, Group::Ideal] {
            let of_group =
                degrees.iter().zip(&program.outputs).filter(|(degree, _)| Group::of_degree(**degree) == group);
            let rows: Vec<&Weighted> = of_group.map(|(_, &output)| &values[output]).collect();
            if !rows.is_empty() {
                roundings = rows.iter().map(|row| row.roundings).fold(roundings, u32::max);
                groups.push(GroupBound { group, terms: combine(&packing, &rows) });
            }
        }
        Some(Self { roundings, groups })
    }

    /// The same in fewer norms, for inputs whose Euclidean group has norm 1 where their types promise it.
    pub fn promised(&self, inputs: &[&Entity], signature: Signature) -> Self {
        let unit: Vec<bool> = inputs.iter().map(|entity| is_unit(entity, signature)).collect();
        let simplify = |bound: &GroupBound| {
            let mut terms: BTreeMap<Vec<Norm>, f64> = BTreeMap::new();
            for term in &bound.terms {
                let is_one = |norm: &&Norm| norm.group == Group::Euclidean && unit.get(norm.parameter) == Some(&true);
                let norms = term.norms.iter().filter(|norm| !is_one(norm)).copied().collect();
                *terms.entry(norms).or_default() += term.factor;
            }
            let terms = terms.into_iter().map(|(norms, factor)| BoundTerm { factor, norms }).collect();
            GroupBound { group: bound.group, terms }
        };
        Self { roundings: self.roundings, groups: self.groups.iter().map(simplify).collect() }
    }

    /// The bound as a sentence without its full stop, see [`GroupBound::display`] for what its u is.
    pub fn display(&self, names: &[&str]) -> String {
        let inexact: Vec<_> = self.groups.iter().filter(|group| !group.terms.is_empty()).collect();
        let sum = |group: &GroupBound| {
            let text = group.display(self.roundings, names);
            if group.terms.len() > 1 { format!("`({text}) u`") } else { format!("`{text} u`") }
        };
        match inexact.as_slice() {
            [] => "none".to_owned(),
            [only] if self.groups.len() == 1 => format!("at most {}", sum(only)),
            several => {
                let texts = several.iter().map(|group| format!("{} in the {} part", sum(group), group.group.name()));
                format!("at most {}", texts.collect::<Vec<_>>().join(", "))
            }
        }
    }
}

impl GroupBound {
    /// The greatest of the numbers in it; 0 where nothing is rounded.
    pub fn factor(&self) -> f64 {
        self.terms.iter().map(|term| term.factor).fold(0.0, f64::max)
    }

    /// The same written out, rounded up like [`GroupBound::display`].
    pub fn display_factor(&self, roundings: u32) -> String {
        round_up(self.factor(), roundings)
    }

    /// The bound's sum, to be multiplied with u / (1 - K u), for these norms.
    pub fn sum(&self, norm: impl Fn(Norm) -> f64) -> f64 {
        self.terms.iter().map(|term| term.factor * term.norms.iter().map(|&n| norm(n)).product::<f64>()).sum()
    }

    /// The sum written out: `3.2 |a| |b|_0`, where |x| is the norm of the Euclidean group and |x|_0 that of the ideal one. Its
    /// numbers are rounded up, for a u that is 1.0001 times the unit roundoff of f32 or of anything more precise.
    pub fn display(&self, roundings: u32, names: &[&str]) -> String {
        let terms: Vec<_> = self.terms.iter().map(|term| term.display(roundings, names)).collect();
        if terms.is_empty() { "0".to_owned() } else { terms.join(" + ") }
    }
}

impl BoundTerm {
    fn display(&self, roundings: u32, names: &[&str]) -> String {
        let number = round_up(self.factor, roundings);
        let mut factors = if number == "1" && !self.norms.is_empty() { Vec::new() } else { vec![number] };
        for group in self.norms.chunk_by(|a, b| a == b) {
            let name = names.get(group[0].parameter).copied().unwrap_or("?");
            let index = if group[0].group == Group::Ideal { "_0" } else { "" };
            let power = if group.len() > 1 { format!("^{}", group.len()) } else { String::new() };
            factors.push(format!("|{name}|{index}{power}"));
        }
        factors.join(" ")
    }
}

/// How much more than the unit roundoff the u of a written bound is, so that factors stay readable.
const UNIT: f64 = 1.0001;

/// A factor of u / (1 - K u), u at most 2^-24, as a factor of [`UNIT`] u: with one decimal, rounded up.
fn round_up(factor: f64, roundings: u32) -> String {
    let inflated = factor / (1.0 - f64::from(roundings) * 2f64.powi(-24)) / UNIT;
    let tenths = (inflated * 10.0).ceil();
    if tenths % 10.0 == 0.0 { format!("{}", tenths / 10.0) } else { format!("{:.1}", tenths / 10.0) }
}

/// Every value of the program as a polynomial in the magnitudes of the inputs, roundings counted.
fn weigh(packing: &Packing, program: &Program) -> Option<Vec<Weighted>> {
    let mut values: Vec<Weighted> = Vec::with_capacity(program.operations.len());
    let is_power_of_two = |value: usize| match program.operations[value] {
        Operation::Constant(number) => {
            let number = number.abs();
            (number.numerator() as u128).is_power_of_two() && (number.denominator() as u128).is_power_of_two()
        }
        _ => false,
    };
    for operation in &program.operations {
        let value = match *operation {
            Operation::Input(index) => Weighted::input(packing, index),
            Operation::Constant(number) => Weighted::constant(number.abs().to_f64(), constant_roundings(number)),
            // Nothing cancels here, so there may be far more terms than in the proof.
            _ if !effort::spend(expected_terms(operation, &values)) => return None,
            Operation::Add(a, b) | Operation::Sub(a, b) => values[a].plus(&values[b]).rounded(),
            Operation::Mul(a, b) if is_power_of_two(a) || is_power_of_two(b) => values[a].times(&values[b]),
            Operation::Mul(a, b) => values[a].times(&values[b]).rounded(),
            Operation::Neg(a) => values[a].clone(),
            Operation::Double(a) => values[a].doubled(),
            _ => return None,
        };
        values.push(value);
    }
    Some(values)
}

/// At most how many terms an operation handles.
fn expected_terms(operation: &Operation, values: &[Weighted]) -> usize {
    let count = |value: usize| values[value].terms.len();
    match *operation {
        Operation::Add(a, b) | Operation::Sub(a, b) => count(a) + count(b),
        // A sum of as many products as the shorter has terms, in each step as long as it is by then.
        Operation::Mul(a, b) => count(a) * count(b) * count(a).min(count(b)).div_ceil(2),
        Operation::Neg(a) | Operation::Double(a) => count(a),
        _ => 1,
    }
}

/// The roundings of a constant, which is computed as a quotient of two whole numbers.
fn constant_roundings(number: Rational) -> u32 {
    const EXACT: i128 = 1 << 24;
    let rounds = |group: i128| u32::from(group.abs() > EXACT);
    let whole = number.denominator() == 1;
    let dyadic = (number.denominator() as u128).is_power_of_two();
    // A rounded divisor counts twice: 1 / (1 + d) is 1 + t with |t| <= 2 u / (1 - 2 u).
    rounds(number.numerator()) + 2 * rounds(number.denominator()) + u32::from(!whole && !dyadic)
}

/// The bound of the outputs of one group.
fn combine(packing: &Packing, rows: &[&Weighted]) -> Vec<BoundTerm> {
    // For every multidegree its monomials, and for each of those the coefficients in the rows, scaled.
    let mut matrices: BTreeMap<Vec<Norm>, BTreeMap<u128, Vec<f64>>> = BTreeMap::new();
    for (row, weighted) in rows.iter().enumerate() {
        for term in weighted.terms.iter().filter(|term| term.error > 0.0) {
            let (norms, multiplicity) = packing.norms(term.monomial);
            let column = matrices.entry(norms).or_default().entry(term.monomial);
            column.or_insert_with(|| vec![0.0; rows.len()])[row] = term.error / multiplicity.sqrt();
        }
    }
    let bound = |(norms, columns): (Vec<Norm>, BTreeMap<u128, Vec<f64>>)| {
        let columns: Vec<_> = columns.into_values().collect();
        BoundTerm { factor: spectral::norm_bound(&columns), norms }
    };
    matrices.into_iter().map(bound).collect()
}

/// Whether a type promises that its Euclidean group has norm 1.
fn is_unit(entity: &Entity, signature: Signature) -> bool {
    let squares = entity.fields().enumerate().filter(|(_, (_, c))| c.blade.null_degree(signature) == 0);
    let mut sum = Polynomial::constant(Rational::MINUS_ONE);
    let mut added = squares.map(|(symbol, _)| sum.add_term(Monomial::new(vec![symbol as Symbol; 2]), Rational::ONE));
    if added.any(|result| result.is_err()) {
        return false;
    }
    let promises = |polynomial: &Polynomial| *polynomial == sum || polynomial.neg() == sum;
    entity.statements.iter().any(|statement| promises(statement.relation.polynomial()))
}
