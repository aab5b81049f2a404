//! Exact numbers a + b sqrt(3), for rotations by multiples of 30 degrees. They also show that a coefficient type needs
//! nothing but the operators.

use std::fmt;
use std::num::ParseIntError;
use std::ops::{Add, Mul, Neg, Sub};
use std::str::FromStr;

/// `whole + root * sqrt(3)`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Surd {
    pub(crate) whole: i64,
    pub(crate) root: i64,
}

pub(crate) const SQRT_3: Surd = Surd { whole: 0, root: 1 };

impl From<i8> for Surd {
    fn from(value: i8) -> Self {
        Self { whole: value.into(), root: 0 }
    }
}

impl Add for Surd {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        Self { whole: self.whole + other.whole, root: self.root + other.root }
    }
}

impl Sub for Surd {
    type Output = Self;

    fn sub(self, other: Self) -> Self {
        Self { whole: self.whole - other.whole, root: self.root - other.root }
    }
}

impl Mul for Surd {
    type Output = Self;

    fn mul(self, other: Self) -> Self {
        Self {
            whole: self.whole * other.whole + 3 * self.root * other.root,
            root: self.whole * other.root + self.root * other.whole,
        }
    }
}

impl Neg for Surd {
    type Output = Self;

    fn neg(self) -> Self {
        Self { whole: -self.whole, root: -self.root }
    }
}

/// `whole`, or `whole + root sqrt(3)`.
impl fmt::Display for Surd {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.root {
            0 => write!(f, "{}", self.whole),
            root if root < 0 => write!(f, "{} - {} sqrt(3)", self.whole, -root),
            root => write!(f, "{} + {root} sqrt(3)", self.whole),
        }
    }
}

impl FromStr for Surd {
    type Err = ParseIntError;

    fn from_str(text: &str) -> Result<Self, ParseIntError> {
        let joined = text.replace(" + ", "|").replace(" - ", "|-").replace(" sqrt(3)", "");
        let (whole, root) = joined.split_once('|').unwrap_or((&joined, "0"));
        Ok(Self { whole: whole.parse()?, root: root.parse()? })
    }
}
