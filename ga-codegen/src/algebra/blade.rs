//! Basis blades as bit sets of generators, and the sign of putting two in order.

use super::Signature;
use std::ops::{Mul, Neg};

/// A sign.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Sign {
    /// +1
    Plus,
    /// -1
    Minus,
}

impl Sign {
    /// Minus for odd `count`.
    pub const fn of_parity(count: u32) -> Self {
        if count.is_multiple_of(2) { Self::Plus } else { Self::Minus }
    }

    /// Whether this is -1.
    pub const fn is_minus(self) -> bool {
        matches!(self, Self::Minus)
    }
}

impl Mul for Sign {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        if self == other { Self::Plus } else { Self::Minus }
    }
}

impl Neg for Sign {
    type Output = Self;
    fn neg(self) -> Self {
        self * Self::Minus
    }
}

/// A product of distinct generators in ascending order; bit `i` stands for the generator at position `i` of the signature.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Blade(pub u8);

impl Blade {
    /// The empty product, 1.
    pub const SCALAR: Self = Self(0);

    /// The product of all generators of `signature`; `None` where there are more than [`Signature::MAX_DIMENSION`].
    pub const fn pseudoscalar(signature: Signature) -> Option<Self> {
        if signature.dimension() > Signature::MAX_DIMENSION {
            return None;
        }
        Some(Self(((1u16 << signature.dimension()) - 1) as u8))
    }

    /// How many generators it has.
    pub const fn grade(self) -> u32 {
        self.0.count_ones()
    }

    /// The positions of its generators, ascending.
    pub fn positions(self) -> impl Iterator<Item = usize> {
        (0..8).filter(move |&position| self.0 >> position & 1 == 1)
    }

    /// The sign of the swaps that bring the generators of `self` followed by those of `other` into ascending order.
    pub const fn reordering_sign(self, other: Self) -> Sign {
        let (mut swaps, mut rest) = (0, self.0 >> 1);
        while rest != 0 {
            swaps += (rest & other.0).count_ones();
            rest >>= 1;
        }
        Sign::of_parity(swaps)
    }

    /// The geometric product of two blades: a signed blade, or `None` where a shared generator squares to 0.
    pub fn geometric(self, other: Self, signature: Signature) -> Option<(Sign, Self)> {
        let mut sign = self.reordering_sign(other);
        for position in Self(self.0 & other.0).positions() {
            match signature.square(position) {
                0 => return None,
                -1 => sign = -sign,
                _ => {}
            }
        }
        Some((sign, Self(self.0 ^ other.0)))
    }

    /// The sign of the reverse of a blade of this grade: (-1)^(g(g-1)/2).
    pub const fn reverse_sign(self) -> Sign {
        Sign::of_parity(self.grade() / 2)
    }

    /// The sign of the grade involution: (-1)^g.
    pub const fn involution_sign(self) -> Sign {
        Sign::of_parity(self.grade())
    }
}
