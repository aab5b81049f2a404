//! What makes one program cheaper than another.

use super::Count;
use std::fmt;

/// What a cheap program is.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord)]
pub enum CostModel {
    /// Fewest multiplications and additions; of equals the one with fewest fused instructions.
    #[default]
    Flops,
    /// Fewest instructions where every addition that can is fused with a product, then fewest operations.
    Fma,
    /// Fewest operations on the longest way from an input to an output, then fewest operations.
    Latency,
}

impl CostModel {
    /// Every cost model.
    pub const ALL: [Self; 3] = [Self::Flops, Self::Fma, Self::Latency];

    /// Its name in blocks and reports.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Flops => "flops",
            Self::Fma => "fma",
            Self::Latency => "latency",
        }
    }

    /// What is to be as small as possible, in order.
    pub fn cost(self, count: Count) -> [usize; 4] {
        match self {
            Self::Flops => [count.flops(), count.fma, count.mul, count.depth],
            Self::Fma => [count.fma, count.flops(), count.mul, count.depth],
            Self::Latency => [count.depth, count.flops(), count.fma, count.mul],
        }
    }
}

impl fmt::Display for CostModel {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}
