//! The values that an operation on several works on.

use super::Value;

/// A list of up to [`Operands::MOST`] values.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Operands {
    values: [Value; Self::MOST],
    count: usize,
}

impl Operands {
    /// The most values that an operation takes: bivectors of at most eight dimensions whose squares are numbers have at most
    /// seven coefficients.
    pub const MOST: usize = 8;

    /// The list of these values; `None` where they are too many.
    pub fn new(values: &[Value]) -> Option<Self> {
        let mut operands = Self { count: values.len(), ..Self::default() };
        operands.values.get_mut(..values.len())?.copy_from_slice(values);
        Some(operands)
    }

    /// The values in their order.
    pub fn iter(self) -> impl Iterator<Item = Value> {
        self.values.into_iter().take(self.count)
    }

    /// How many there are.
    pub const fn count(self) -> usize {
        self.count
    }

    /// The values mapped, in the same order.
    #[must_use]
    pub(super) fn map(mut self, map: impl Fn(Value) -> Value) -> Self {
        for value in &mut self.values[..self.count] {
            *value = map(*value);
        }
        self
    }
}

impl From<[Value; 1]> for Operands {
    fn from([a]: [Value; 1]) -> Self {
        Self { values: [a, 0, 0, 0, 0, 0, 0, 0], count: 1 }
    }
}

impl From<[Value; 2]> for Operands {
    fn from([a, b]: [Value; 2]) -> Self {
        Self { values: [a, b, 0, 0, 0, 0, 0, 0], count: 2 }
    }
}
