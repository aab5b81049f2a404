//! Building a program: equal operations are shared, dead ones dropped.

use super::{Operation, Program, Value};
use crate::symbolic::Rational;
use std::collections::BTreeMap;

/// Collects operations; the same operation twice gives the same value.
#[derive(Clone, Debug, Default)]
pub struct ProgramBuilder {
    operations: Vec<Operation>,
    depths: Vec<usize>,
    known: BTreeMap<Operation, Value>,
}

impl ProgramBuilder {
    /// An empty program.
    pub fn new() -> Self {
        Self::default()
    }

    /// The value of an operation whose operands were built before.
    pub fn push(&mut self, operation: Operation) -> Value {
        let operation = match operation {
            Operation::Add(a, b) if b < a => Operation::Add(b, a),
            Operation::Mul(a, b) if b < a => Operation::Mul(b, a),
            other => other,
        };
        *self.known.entry(operation).or_insert_with(|| {
            let below = operation.operands().map(|operand| self.depths[operand]).max().unwrap_or(0);
            let free = matches!(operation, Operation::Input(_) | Operation::Constant(_) | Operation::Neg(_));
            self.depths.push(if free { below } else { below + 1 });
            self.operations.push(operation);
            self.operations.len() - 1
        })
    }

    /// The negative of a value; that of a negative is the value itself.
    pub fn negate(&mut self, value: Value) -> Value {
        match self.operations[value] {
            Operation::Neg(inner) => inner,
            Operation::Constant(number) => self.push(Operation::Constant(number.neg())),
            Operation::Sub(a, b) => self.push(Operation::Sub(b, a)),
            _ => self.push(Operation::Neg(value)),
        }
    }

    /// A sum of signed values, the first positive one first; 0 for none.
    pub fn sum(&mut self, terms: &[(bool, Value)]) -> Value {
        let Some(first) = terms.iter().position(|(minus, _)| !minus).or(if terms.is_empty() { None } else { Some(0) })
        else {
            return self.push(Operation::Constant(Rational::ZERO));
        };
        let all_minus = terms[first].0;
        let mut total = terms[first].1;
        for (_, &(minus, value)) in terms.iter().enumerate().filter(|&(index, _)| index != first) {
            total = if minus == all_minus {
                self.push(Operation::Add(total, value))
            } else {
                self.push(Operation::Sub(total, value))
            };
        }
        if all_minus { self.negate(total) } else { total }
    }

    /// A sum of signed values that takes the two that are ready first again and again, so that it is as shallow as can be.
    pub fn balanced_sum(&mut self, terms: &[(bool, Value)]) -> Value {
        let mut terms = terms.to_vec();
        while terms.len() > 1 {
            terms.sort_by_key(|&(_, value)| std::cmp::Reverse(self.depths[value]));
            let (Some((minus_a, a)), Some((minus_b, b))) = (terms.pop(), terms.pop()) else { break };
            let sum = match (minus_a, minus_b) {
                (false, true) => self.push(Operation::Sub(a, b)),
                (true, false) => self.push(Operation::Sub(b, a)),
                _ => self.push(Operation::Add(a, b)),
            };
            terms.push((minus_a && minus_b, sum));
        }
        match terms.first() {
            Some(&(true, value)) => self.negate(value),
            Some(&(false, value)) => value,
            None => self.push(Operation::Constant(Rational::ZERO)),
        }
    }

    /// The program with these outputs and what they need.
    pub fn finish(self, outputs: &[Value]) -> Program {
        let mut live = vec![false; self.operations.len()];
        let mut pending = outputs.to_vec();
        while let Some(value) = pending.pop() {
            if !std::mem::replace(&mut live[value], true) {
                pending.extend(self.operations[value].operands());
            }
        }
        let mut renumbered = vec![0; self.operations.len()];
        let mut operations = Vec::new();
        for (value, operation) in self.operations.iter().enumerate().filter(|&(value, _)| live[value]) {
            renumbered[value] = operations.len();
            operations.push(operation.map_operands(|operand| renumbered[operand]));
        }
        Program { operations, outputs: outputs.iter().map(|&value| renumbered[value]).collect() }
    }
}
