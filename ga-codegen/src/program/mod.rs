//! Straight-line programs in static single assignment: what is proved, counted and emitted.

mod bound;
mod builder;
mod cost;
mod count;
mod evaluate;
mod operands;
mod packed;
mod recipe;

pub use bound::{Bound, BoundTerm, Group, GroupBound, Norm};
pub use builder::ProgramBuilder;
pub use cost::CostModel;
pub use count::Count;
pub use evaluate::{Domain, FloatDomain};
pub use operands::Operands;
pub use packed::{LANES, PackedCount, PackedOperation, PackedProgram, Source};
pub use recipe::{PackedRecipe, PackedRow, PackedSource, PackedTerm, Recipe, RecipeTerm};

use crate::approximation::{Function, Precision};
use crate::symbolic::Rational;

/// The value of an operation, by the operation's index.
pub type Value = usize;

/// One operation. Operands come before their users.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Operation {
    /// The input coefficient of that index.
    Input(usize),
    /// A number.
    Constant(Rational),
    /// a + b
    Add(Value, Value),
    /// a - b
    Sub(Value, Value),
    /// a * b
    Mul(Value, Value),
    /// -a
    Neg(Value),
    /// 2 a, computed as a + a
    Double(Value),
    /// a / b
    Div(Value, Value),
    /// The square root.
    Sqrt(Value),
    /// The square root of the sum of the squares, whatever their range.
    Norm(Operands),
    /// The sine.
    Sin(Value),
    /// The cosine.
    Cos(Value),
    /// The angle of the point (second, first), in [-pi, pi].
    Atan2(Value, Value),
    /// A quotient with a removable singularity: numerator / denominator, and the number where the denominator is 0.
    Quotient(Value, Value, Rational),
    /// A function of one value by the polynomial near it.
    Polynomial(Function, Precision, Value),
}

impl Operation {
    /// The values that it uses.
    pub fn operands(self) -> impl Iterator<Item = Value> {
        let operands = match self {
            Self::Input(_) | Self::Constant(_) => Operands::default(),
            Self::Neg(a)
            | Self::Double(a)
            | Self::Sqrt(a)
            | Self::Sin(a)
            | Self::Cos(a)
            | Self::Polynomial(_, _, a) => Operands::from([a]),
            Self::Add(a, b)
            | Self::Sub(a, b)
            | Self::Mul(a, b)
            | Self::Div(a, b)
            | Self::Atan2(a, b)
            | Self::Quotient(a, b, _) => Operands::from([a, b]),
            Self::Norm(operands) => operands,
        };
        operands.iter()
    }

    /// The same operation on other operands.
    #[must_use]
    pub fn map_operands(self, map: impl Fn(Value) -> Value) -> Self {
        match self {
            Self::Input(_) | Self::Constant(_) => self,
            Self::Add(a, b) => Self::Add(map(a), map(b)),
            Self::Sub(a, b) => Self::Sub(map(a), map(b)),
            Self::Mul(a, b) => Self::Mul(map(a), map(b)),
            Self::Neg(a) => Self::Neg(map(a)),
            Self::Double(a) => Self::Double(map(a)),
            Self::Div(a, b) => Self::Div(map(a), map(b)),
            Self::Sqrt(a) => Self::Sqrt(map(a)),
            Self::Norm(operands) => Self::Norm(operands.map(map)),
            Self::Sin(a) => Self::Sin(map(a)),
            Self::Cos(a) => Self::Cos(map(a)),
            Self::Atan2(a, b) => Self::Atan2(map(a), map(b)),
            Self::Quotient(a, b, limit) => Self::Quotient(map(a), map(b), limit),
            Self::Polynomial(function, precision, a) => Self::Polynomial(function, precision, map(a)),
        }
    }
}

/// A straight-line program. Its operations are the least that its outputs need: none is dead.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Program {
    /// The operations, operands first.
    pub operations: Vec<Operation>,
    /// The value of every field of the output.
    pub outputs: Vec<Value>,
}

impl Program {
    /// The functions that the program evaluates by polynomials, and of what values, each once.
    pub fn polynomials(&self) -> Vec<(Function, Precision, Value)> {
        let polynomials = self.operations.iter().filter_map(|operation| match *operation {
            Operation::Polynomial(function, precision, argument) => Some((function, precision, argument)),
            _ => None,
        });
        polynomials.collect()
    }

    /// The first number in the program that emitted code cannot name: its numerator or denominator does not fit an i32.
    pub fn unnameable_number(&self) -> Option<Rational> {
        let fits = |part: i128| i32::try_from(part).is_ok();
        let numbers = self.operations.iter().filter_map(|operation| match operation {
            Operation::Constant(number) | Operation::Quotient(_, _, number) => Some(*number),
            _ => None,
        });
        numbers.into_iter().find(|number| !fits(number.abs().numerator()) || !fits(number.denominator()))
    }
}
