//! The field of three elements.

use core::fmt;
use core::iter::{Product, Sum};
use core::ops::{Add, Mul, Neg, Sub};

/// An element of GF(3), the integers modulo 3, by its representative of least magnitude.
///
/// The sum and the product of two trits are the remainders of the sum and the product of their values, so the three
/// are a field: 1 + 1 = -1, and every trit but 0 is its own inverse.
///
/// ```
/// use pga_motor::gf3::Trit;
///
/// assert_eq!(Trit::Plus + Trit::Plus, Trit::Minus);
/// assert_eq!(Trit::Minus * Trit::Minus, Trit::Plus);
/// assert_eq!(Trit::of_integer(-7), Trit::Minus);
/// assert_eq!([Trit::Plus, Trit::Ergodic, Trit::Minus].into_iter().sum::<Trit>(), Trit::Ergodic);
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Trit {
    /// -1
    Minus,
    /// 0
    #[default]
    Ergodic,
    /// +1
    Plus,
}

impl Trit {
    /// Every trit, in the order of the values.
    pub const ALL: [Self; 3] = [Self::Minus, Self::Ergodic, Self::Plus];

    /// -1, 0 or 1.
    pub const fn value(self) -> i8 {
        match self {
            Self::Minus => -1,
            Self::Ergodic => 0,
            Self::Plus => 1,
        }
    }

    /// The trit of that value; `None` for numbers other than -1, 0 and 1.
    pub const fn from_value(value: i8) -> Option<Self> {
        match value {
            -1 => Some(Self::Minus),
            0 => Some(Self::Ergodic),
            1 => Some(Self::Plus),
            _ => None,
        }
    }

    /// The class of an integer modulo 3, by Euclid's remainder: 2 and -1 are one class.
    pub const fn of_integer(integer: i64) -> Self {
        match integer.rem_euclid(3) {
            0 => Self::Ergodic,
            1 => Self::Plus,
            _ => Self::Minus,
        }
    }

    /// The published name: MINUS, ERGODIC or PLUS.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Minus => "MINUS",
            Self::Ergodic => "ERGODIC",
            Self::Plus => "PLUS",
        }
    }

    /// The trit whose product with this one is +1: itself; `None` for 0.
    pub const fn inverse(self) -> Option<Self> {
        match self {
            Self::Ergodic => None,
            Self::Minus | Self::Plus => Some(self),
        }
    }
}

impl fmt::Display for Trit {
    /// `-1`, `0` or `+1`.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(match self {
            Self::Minus => "-1",
            Self::Ergodic => "0",
            Self::Plus => "+1",
        })
    }
}

impl From<Trit> for i8 {
    /// -1, 0 or 1.
    fn from(trit: Trit) -> Self {
        trit.value()
    }
}

impl Add for Trit {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        Self::of_integer(i64::from(self.value() + other.value()))
    }
}

impl Sub for Trit {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        Self::of_integer(i64::from(self.value() - other.value()))
    }
}

impl Mul for Trit {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        Self::of_integer(i64::from(self.value() * other.value()))
    }
}

impl Neg for Trit {
    type Output = Self;
    fn neg(self) -> Self {
        Self::of_integer(i64::from(-self.value()))
    }
}

impl Sum for Trit {
    /// The sum modulo 3; of no trits 0.
    fn sum<I: Iterator<Item = Self>>(trits: I) -> Self {
        trits.fold(Self::Ergodic, Add::add)
    }
}

impl Product for Trit {
    /// The product modulo 3; of no trits +1.
    fn product<I: Iterator<Item = Self>>(trits: I) -> Self {
        trits.fold(Self::Plus, Mul::mul)
    }
}
