//! What a program costs.

use super::{Operation, Program};
use crate::approximation::approximation;
use std::fmt;

/// Operation counts. A doubling counts as one multiplication, a negation as nothing.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Count {
    /// Multiplications, doublings included.
    pub mul: usize,
    /// Additions and subtractions.
    pub add: usize,
    /// Divisions.
    pub div: usize,
    /// Square roots.
    pub sqrt: usize,
    /// Sines, cosines and arc tangents.
    pub trigonometric: usize,
    /// Instructions other than division, root and trigonometry, when every addition that can is fused with a product.
    pub fma: usize,
    /// The most arithmetic operations on a way from an input to an output.
    pub depth: usize,
}

impl Count {
    /// Counts a program.
    pub fn of(program: &Program) -> Self {
        let mut count = Self::default();
        let mut depth = vec![0; program.operations.len()];
        for (value, operation) in program.operations.iter().enumerate() {
            let below = operation.operands().map(|operand| depth[operand]).max().unwrap_or(0);
            depth[value] = below + 1;
            match operation {
                Operation::Input(_) | Operation::Constant(_) | Operation::Neg(_) => depth[value] = below,
                Operation::Add(..) | Operation::Sub(..) => count.add += 1,
                Operation::Mul(..) | Operation::Double(_) => count.mul += 1,
                Operation::Div(..) | Operation::Quotient(..) => count.div += 1,
                Operation::Sqrt(_) => count.sqrt += 1,
                Operation::Norm(operands) if operands.count() > 1 => {
                    count.mul += operands.count();
                    count.add += operands.count() - 1;
                    count.sqrt += 1;
                    // A square, the sums one after the other, and the root.
                    depth[value] = below + operands.count() + 1;
                }
                Operation::Polynomial(function, precision, _) => {
                    let degree = approximation(*function, *precision).degree();
                    count.mul += degree;
                    count.add += degree;
                    // A product and a sum for every power, one after the other.
                    depth[value] = below + 2 * degree;
                }
                // The absolute value.
                Operation::Norm(_) => depth[value] = below,
                Operation::Sin(_) | Operation::Cos(_) | Operation::Atan2(..) => count.trigonometric += 1,
            }
        }
        count.depth = program.outputs.iter().map(|&output| depth[output]).max().unwrap_or(0);
        count.fma = count.mul + count.add - fusable(program);
        count
    }

    /// Multiplications and additions.
    pub const fn flops(self) -> usize {
        self.mul + self.add
    }
}

/// How many additions can take a product that nothing else uses into one fused instruction.
fn fusable(program: &Program) -> usize {
    let mut uses = vec![0usize; program.operations.len()];
    for operand in program.operations.iter().flat_map(|operation| operation.operands()) {
        uses[operand] += 1;
    }
    for &output in &program.outputs {
        uses[output] += 1;
    }
    let single_product = |value: usize| {
        let through = match program.operations[value] {
            Operation::Neg(inner) if uses[value] == 1 => inner,
            _ => value,
        };
        uses[through] == 1 && matches!(program.operations[through], Operation::Mul(..) | Operation::Double(_))
    };
    let fuses = |operation: &&Operation| match **operation {
        Operation::Add(a, b) | Operation::Sub(a, b) => single_product(a) || single_product(b),
        _ => false,
    };
    let inside = |operation: &Operation| match *operation {
        Operation::Norm(operands) => operands.count().saturating_sub(1),
        Operation::Polynomial(function, precision, _) => approximation(function, precision).degree(),
        _ => 0,
    };
    program.operations.iter().filter(fuses).count() + program.operations.iter().map(inside).sum::<usize>()
}

impl fmt::Display for Count {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} mul + {} add", self.mul, self.add)?;
        for (number, name) in [(self.div, "div"), (self.sqrt, "sqrt"), (self.trigonometric, "trigonometric")] {
            if number > 0 {
                write!(f, " + {number} {name}")?;
            }
        }
        Ok(())
    }
}
