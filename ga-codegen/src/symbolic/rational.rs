//! Rational numbers in checked 128-bit arithmetic.

use std::cmp::Ordering;
use std::fmt;

/// An exact result does not fit 128-bit numerators and denominators.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Overflow;

impl fmt::Display for Overflow {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("exact arithmetic overflowed 128-bit rationals")
    }
}

impl std::error::Error for Overflow {}

/// A rational number in lowest terms, the denominator positive.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Rational {
    numerator: i128,
    denominator: i128,
}

fn gcd(a: i128, b: i128) -> i128 {
    let (mut a, mut b) = (a.unsigned_abs(), b.unsigned_abs());
    while b != 0 {
        (a, b) = (b, a % b);
    }
    // Only gcd(i128::MIN, i128::MIN) does not fit; `new` has ruled that out.
    a as i128
}

impl Rational {
    /// 0
    pub const ZERO: Self = Self { numerator: 0, denominator: 1 };
    /// 1
    pub const ONE: Self = Self { numerator: 1, denominator: 1 };
    /// -1
    pub const MINUS_ONE: Self = Self { numerator: -1, denominator: 1 };

    /// `numerator / denominator` in lowest terms.
    ///
    /// # Errors
    /// A zero denominator, or a numerator or denominator of -2^127.
    pub fn new(numerator: i128, denominator: i128) -> Result<Self, Overflow> {
        if denominator == 0 || numerator == i128::MIN || denominator == i128::MIN {
            return Err(Overflow);
        }
        let divisor = gcd(numerator, denominator) * denominator.signum();
        Ok(Self { numerator: numerator / divisor, denominator: denominator / divisor })
    }

    /// A whole number.
    pub const fn integer(value: i64) -> Self {
        Self { numerator: value as i128, denominator: 1 }
    }

    /// The numerator, which carries the sign.
    pub const fn numerator(self) -> i128 {
        self.numerator
    }

    /// The denominator, positive.
    pub const fn denominator(self) -> i128 {
        self.denominator
    }

    /// Whether it is 0.
    pub const fn is_zero(self) -> bool {
        self.numerator == 0
    }

    /// Whether it is less than 0.
    pub const fn is_negative(self) -> bool {
        self.numerator < 0
    }

    /// The sum.
    ///
    /// # Errors
    /// [`Overflow`]
    pub fn checked_add(self, other: Self) -> Result<Self, Overflow> {
        if self.denominator == 1 && other.denominator == 1 {
            let numerator = self.numerator.checked_add(other.numerator).ok_or(Overflow)?;
            return Self::new(numerator, 1);
        }
        let shared = gcd(self.denominator, other.denominator);
        let scale = other.denominator / shared;
        let left = self.numerator.checked_mul(scale).ok_or(Overflow)?;
        let right = other.numerator.checked_mul(self.denominator / shared).ok_or(Overflow)?;
        let numerator = left.checked_add(right).ok_or(Overflow)?;
        Self::new(numerator, self.denominator.checked_mul(scale).ok_or(Overflow)?)
    }

    /// The product.
    ///
    /// # Errors
    /// [`Overflow`]
    pub fn checked_mul(self, other: Self) -> Result<Self, Overflow> {
        if self.denominator == 1 && other.denominator == 1 {
            let numerator = self.numerator.checked_mul(other.numerator).ok_or(Overflow)?;
            return Self::new(numerator, 1);
        }
        let (left, right) = (gcd(self.numerator, other.denominator), gcd(other.numerator, self.denominator));
        let numerator = (self.numerator / left).checked_mul(other.numerator / right).ok_or(Overflow)?;
        let denominator = (self.denominator / right).checked_mul(other.denominator / left).ok_or(Overflow)?;
        Self::new(numerator, denominator)
    }

    /// The negative.
    pub const fn neg(self) -> Self {
        Self { numerator: -self.numerator, denominator: self.denominator }
    }

    /// The absolute value.
    pub const fn abs(self) -> Self {
        Self { numerator: self.numerator.abs(), denominator: self.denominator }
    }

    /// The quotient; `None` for division by 0.
    ///
    /// # Errors
    /// [`Overflow`]
    pub fn checked_div(self, other: Self) -> Result<Option<Self>, Overflow> {
        if other.is_zero() {
            return Ok(None);
        }
        self.checked_mul(Self::new(other.denominator, other.numerator)?).map(Some)
    }

    /// The square root that is not negative, where it is rational.
    pub fn exact_root(self) -> Option<Self> {
        let root = |square: i128| {
            let root = u128::try_from(square).ok()?.isqrt();
            (root * root == square as u128).then_some(root as i128)
        };
        Some(Self { numerator: root(self.numerator)?, denominator: root(self.denominator)? })
    }

    /// The nearest f64, for tests and reports; exact where numerator and denominator are below 2^53.
    pub fn to_f64(self) -> f64 {
        self.numerator as f64 / self.denominator as f64
    }
}

impl PartialOrd for Rational {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl Ord for Rational {
    /// By value: as the continued fractions, whose terms are never too large.
    fn cmp(&self, other: &Self) -> Ordering {
        let ((mut a, mut b), (mut c, mut d)) =
            ((self.numerator, self.denominator), (other.numerator, other.denominator));
        loop {
            let whole = a.div_euclid(b).cmp(&c.div_euclid(d));
            let (left, right) = (a.rem_euclid(b), c.rem_euclid(d));
            if whole.is_ne() || left == 0 || right == 0 {
                return whole.then(left.cmp(&right));
            }
            // left / b is less than right / d where d / right is less than b / left.
            (a, b, c, d) = (d, right, b, left);
        }
    }
}

impl fmt::Display for Rational {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if self.denominator == 1 {
            write!(f, "{}", self.numerator)
        } else {
            write!(f, "{}/{}", self.numerator, self.denominator)
        }
    }
}
