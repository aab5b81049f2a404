//! Four numbers at once.

use core::ops::{Add, Mul, Sub};

/// Four numbers side by side, for packed kernels.
pub trait Four<S>: Copy + Add<Output = Self> + Sub<Output = Self> + Mul<Output = Self> {
    /// Whether arithmetic on them is faster than on four numbers one by one, so that operators call packed kernels.
    const IS_FAST: bool;
    /// The value with these lanes.
    fn new(lanes: [S; 4]) -> Self;
    /// The lanes.
    fn to_array(self) -> [S; 4];
    /// In every lane the one that two bits of the mask name, the lowest for lane 0.
    fn shuffle<const MASK: i32>(self) -> Self;
    /// The lanes negated whose bits of the mask are set, the lowest that of lane 0.
    fn negate<const MASK: i32>(self) -> Self;
}
