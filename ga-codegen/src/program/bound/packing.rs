//! Exponents of many variables in one machine word.

use super::{Group, Norm};
use crate::kernel::Specification;
use crate::program::{Operation, Program};

/// How monomials in the magnitudes of input coefficients are packed. Where the coefficients are too many, every
/// magnitude is replaced by the norm that it is group of, a weaker bound with fewer variables.
#[derive(Clone, Debug)]
pub(super) struct Packing {
    /// The norms, each once.
    norms: Vec<Norm>,
    /// For every variable the index of the norm that it is group of.
    norm_of: Vec<usize>,
    /// The variable of every coefficient.
    variables: Vec<usize>,
    /// The bits of an exponent.
    bits: u32,
}

impl Packing {
    /// A packing for a program; `None` where even the norms of its inputs are too many.
    pub(super) fn new(specification: &Specification, program: &Program) -> Option<Self> {
        let mut norms: Vec<Norm> = Vec::new();
        let mut blocks = Vec::new();
        for coefficient in &specification.coefficients {
            let norm = Norm { parameter: coefficient.parameter, group: Group::of_degree(coefficient.degree) };
            let known = norms.iter().position(|other| *other == norm);
            blocks.push(known.unwrap_or(norms.len()));
            if known.is_none() {
                norms.push(norm);
            }
        }
        let bits = u32::BITS - degree(program)?.leading_zeros();
        let fits = |variables: usize| variables.saturating_mul(bits as usize) <= 128;
        if fits(blocks.len()) {
            let variables = (0..blocks.len()).collect();
            return Some(Self { norms, norm_of: blocks, variables, bits });
        }
        let norm_of = (0..norms.len()).collect();
        fits(norms.len()).then_some(Self { norms, norm_of, variables: blocks, bits })
    }

    /// The magnitude of one coefficient as a monomial.
    pub(super) fn monomial(&self, coefficient: usize) -> u128 {
        1 << (self.bits * self.variables[coefficient] as u32)
    }

    /// The norms, ascending and repeated by their powers, whose product bounds a monomial, and how often the square of
    /// the monomial occurs in the square of that product.
    pub(super) fn norms(&self, monomial: u128) -> (Vec<Norm>, f64) {
        let (mut norms, mut multiplicity) = (Vec::new(), 1.0);
        let mut degrees = vec![0u32; self.norms.len()];
        let mut rest = monomial;
        let mut variable = 0;
        while rest != 0 {
            let exponent = (rest & ((1 << self.bits) - 1)) as u32;
            rest >>= self.bits;
            let norm = self.norm_of[variable];
            variable += 1;
            for power in 1..=exponent {
                degrees[norm] += 1;
                multiplicity *= f64::from(degrees[norm]) / f64::from(power);
                norms.push(self.norms[norm]);
            }
        }
        norms.sort_unstable();
        (norms, multiplicity)
    }
}

/// The greatest degree of a program's values, at least 1; `None` where it is no polynomial or the degree is out of range.
fn degree(program: &Program) -> Option<u32> {
    let mut degrees: Vec<u32> = Vec::with_capacity(program.operations.len());
    for operation in &program.operations {
        degrees.push(match *operation {
            Operation::Input(_) => 1,
            Operation::Constant(_) => 0,
            Operation::Add(a, b) | Operation::Sub(a, b) => degrees[a].max(degrees[b]),
            Operation::Mul(a, b) => degrees[a].checked_add(degrees[b])?,
            Operation::Neg(a) | Operation::Double(a) => degrees[a],
            _ => return None,
        });
    }
    Some(degrees.into_iter().max().unwrap_or(0).max(1))
}
