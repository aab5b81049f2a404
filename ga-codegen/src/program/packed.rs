//! Straight-line programs on values of four lanes. What one means is the scalar program that it unpacks to, and that is
//! what is proved, bounded and counted.

use super::{Operation, Program, ProgramBuilder, Value};
use crate::symbolic::Rational;
use std::fmt;

/// How many lanes a value has.
pub const LANES: usize = 4;

/// What a lane is loaded with.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Source {
    /// The input coefficient of that index.
    Input(usize),
    /// A number.
    Constant(Rational),
}

/// One operation on all lanes. Operands come before their users.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum PackedOperation {
    /// Inputs and numbers side by side.
    Load([Source; LANES]),
    /// In every lane what this lane of the operand has.
    Shuffle(Value, [u8; LANES]),
    /// The lanes negated that are marked.
    Negate(Value, [bool; LANES]),
    /// 2 a, computed as a + a
    Double(Value),
    /// a + b
    Add(Value, Value),
    /// a - b
    Sub(Value, Value),
    /// a * b
    Mul(Value, Value),
}

impl PackedOperation {
    /// The values that it uses.
    pub fn operands(self) -> impl Iterator<Item = Value> {
        let (first, second) = match self {
            Self::Load(_) => (None, None),
            Self::Shuffle(a, _) | Self::Negate(a, _) | Self::Double(a) => (Some(a), None),
            Self::Add(a, b) | Self::Sub(a, b) | Self::Mul(a, b) => (Some(a), Some(b)),
        };
        first.into_iter().chain(second)
    }

    /// The same operation on other operands.
    #[must_use]
    pub fn map_operands(self, map: impl Fn(Value) -> Value) -> Self {
        match self {
            Self::Load(_) => self,
            Self::Shuffle(a, lanes) => Self::Shuffle(map(a), lanes),
            Self::Negate(a, lanes) => Self::Negate(map(a), lanes),
            Self::Double(a) => Self::Double(map(a)),
            Self::Add(a, b) => Self::Add(map(a), map(b)),
            Self::Sub(a, b) => Self::Sub(map(a), map(b)),
            Self::Mul(a, b) => Self::Mul(map(a), map(b)),
        }
    }
}

/// A straight-line program on values of four lanes.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct PackedProgram {
    /// The operations, operands first.
    pub operations: Vec<PackedOperation>,
    /// The value and the lane of every field of the output.
    pub outputs: Vec<(Value, u8)>,
}

impl PackedProgram {
    /// The scalar program that it stands for: every lane of an operation is an operation of its own, what no output needs is
    /// dropped.
    pub fn unpack(&self) -> Program {
        let mut builder = ProgramBuilder::new();
        let mut values: Vec<[Value; LANES]> = Vec::with_capacity(self.operations.len());
        for operation in &self.operations {
            let lane_values = std::array::from_fn(|lane| {
                let scalar = match *operation {
                    PackedOperation::Load(sources) => match sources[lane] {
                        Source::Input(index) => Operation::Input(index),
                        Source::Constant(number) => Operation::Constant(number),
                    },
                    PackedOperation::Shuffle(a, lanes) => return values[a][usize::from(lanes[lane])],
                    PackedOperation::Negate(a, negated) if !negated[lane] => return values[a][lane],
                    PackedOperation::Negate(a, _) => Operation::Neg(values[a][lane]),
                    PackedOperation::Double(a) => Operation::Double(values[a][lane]),
                    PackedOperation::Add(a, b) => Operation::Add(values[a][lane], values[b][lane]),
                    PackedOperation::Sub(a, b) => Operation::Sub(values[a][lane], values[b][lane]),
                    PackedOperation::Mul(a, b) => Operation::Mul(values[a][lane], values[b][lane]),
                };
                builder.push(scalar)
            });
            values.push(lane_values);
        }
        let outputs: Vec<Value> = self.outputs.iter().map(|&(value, lane)| values[value][usize::from(lane)]).collect();
        builder.finish(&outputs)
    }

    /// The same without operations that no output needs.
    #[must_use]
    pub fn pruned(&self) -> Self {
        let mut live = vec![false; self.operations.len()];
        for &(value, _) in &self.outputs {
            live[value] = true;
        }
        for (value, operation) in self.operations.iter().enumerate().rev() {
            if live[value] {
                operation.operands().for_each(|operand| live[operand] = true);
            }
        }
        let mut renumbered = vec![0; self.operations.len()];
        let mut operations = Vec::new();
        for (value, operation) in self.operations.iter().enumerate().filter(|&(value, _)| live[value]) {
            renumbered[value] = operations.len();
            operations.push(operation.map_operands(|operand| renumbered[operand]));
        }
        let outputs = self.outputs.iter().map(|&(value, lane)| (renumbered[value], lane)).collect();
        Self { operations, outputs }
    }

    /// How many operations of each kind it has.
    pub fn count(&self) -> PackedCount {
        let mut count = PackedCount::default();
        for operation in &self.operations {
            match operation {
                PackedOperation::Load(_) => count.load += 1,
                PackedOperation::Shuffle(..) => count.shuffle += 1,
                PackedOperation::Negate(..) => count.negate += 1,
                PackedOperation::Double(_) | PackedOperation::Add(..) | PackedOperation::Sub(..) => count.add += 1,
                PackedOperation::Mul(..) => count.mul += 1,
            }
        }
        count
    }
}

/// Operations on four lanes, each counted once.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct PackedCount {
    /// Loads.
    pub load: usize,
    /// Multiplications.
    pub mul: usize,
    /// Additions, subtractions and doublings.
    pub add: usize,
    /// Shuffles.
    pub shuffle: usize,
    /// Negations of some lanes.
    pub negate: usize,
}

impl PackedCount {
    /// All of them but loads.
    pub const fn total(self) -> usize {
        self.mul + self.add + self.shuffle + self.negate
    }
}

impl fmt::Display for PackedCount {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { load, mul, add, shuffle, negate } = self;
        write!(f, "{mul} mul + {add} add + {shuffle} shuffle + {negate} negate on four lanes, after {load} loads")
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_operation_unpacks_to_one_for_each_lane() {
        let operations = vec![
            PackedOperation::Load([0, 1, 2, 3].map(Source::Input)),
            PackedOperation::Load([5, 6, 7, 8].map(|number| Source::Constant(Rational::integer(number)))),
            PackedOperation::Shuffle(0, [3, 0, 0, 2]),
            PackedOperation::Mul(2, 1),
            PackedOperation::Negate(3, [true, false, false, true]),
            PackedOperation::Add(4, 0),
            PackedOperation::Sub(5, 1),
            PackedOperation::Double(6),
            PackedOperation::Double(0),
        ];
        let packed = PackedProgram { operations, outputs: vec![(7, 0), (7, 1), (7, 3), (8, 2)] };
        let Ok(found) = packed.unpack().evaluate(&crate::program::FloatDomain, &[10.0, 20.0, 30.0, 40.0]);
        let lane = |negated: f64, shuffled: f64, number: f64, x: f64| 2.0 * (negated * shuffled * number + x - number);
        assert_eq!(found, [lane(-1.0, 40.0, 5.0, 10.0), lane(1.0, 10.0, 6.0, 20.0), lane(-1.0, 30.0, 8.0, 40.0), 60.0]);
    }

    #[test]
    fn what_no_output_needs_is_pruned() {
        let load = PackedOperation::Load([0, 1, 2, 3].map(Source::Input));
        let operations =
            vec![load, PackedOperation::Double(0), PackedOperation::Shuffle(0, [1; 4]), PackedOperation::Add(0, 2)];
        let packed = PackedProgram { operations, outputs: vec![(3, 1)] };
        let pruned = packed.pruned();
        assert_eq!(pruned.operations, [load, PackedOperation::Shuffle(0, [1; 4]), PackedOperation::Add(0, 1)]);
        assert_eq!(pruned.outputs, [(2, 1)]);
        assert_eq!(pruned.unpack(), packed.unpack());
    }
}
