//! Numbers of 320 bits, with the few functions that the closed forms need.

use std::cell::RefCell;
use std::collections::HashMap;
use std::ops::{Add, Div, Mul, Neg, Sub};

use dashu_float::FBig;
use dashu_float::round::mode::HalfEven;

type Digits = FBig<HalfEven, 2>;

/// Bits of every number: 100 for the step of a difference quotient, 100 below it, and a good hundred for what cancels.
pub(crate) const PRECISION: usize = 320;

/// A binary number of [`PRECISION`] bits whose exponent never overflows.
#[derive(Clone, Debug, PartialEq, PartialOrd)]
pub(crate) struct Big(Digits);

impl From<f64> for Big {
    /// # Panics
    /// For NaN and infinities, which are no numbers.
    fn from(value: f64) -> Self {
        let digits = Digits::try_from(value).expect("a finite number");
        Self(digits.with_precision(PRECISION).value())
    }
}

impl From<i8> for Big {
    fn from(value: i8) -> Self {
        f64::from(value).into()
    }
}

macro_rules! implement_operator {
    ($($operator:ident $method:ident)*) => {$(
        impl $operator<&Big> for &Big {
            type Output = Big;
            fn $method(self, other: &Big) -> Big {
                Big((&self.0).$method(&other.0))
            }
        }
        impl $operator for Big {
            type Output = Big;
            fn $method(self, other: Big) -> Big {
                Big(self.0.$method(other.0))
            }
        }
        impl $operator<&Big> for Big {
            type Output = Big;
            fn $method(self, other: &Big) -> Big {
                Big(self.0.$method(&other.0))
            }
        }
        impl $operator<Big> for &Big {
            type Output = Big;
            fn $method(self, other: Big) -> Big {
                Big((&self.0).$method(other.0))
            }
        }
    )*};
}

implement_operator!(Add add Sub sub Mul mul Div div);

impl Neg for Big {
    type Output = Self;
    fn neg(self) -> Self {
        Self(-self.0)
    }
}

impl Neg for &Big {
    type Output = Big;
    fn neg(self) -> Big {
        -self.clone()
    }
}

impl Big {
    /// 2 to the power of `exponent`.
    pub(crate) fn power_of_two(exponent: isize) -> Self {
        Self(Self::from(1.0).0 << exponent)
    }

    pub(crate) fn to_f64(&self) -> f64 {
        self.0.to_f64().value()
    }

    pub(crate) fn to_f32(&self) -> f32 {
        self.0.to_f32().value()
    }

    pub(crate) fn is_zero(&self) -> bool {
        *self == Self::from(0.0)
    }

    pub(crate) fn is_negative(&self) -> bool {
        *self < Self::from(0.0)
    }

    pub(crate) fn abs(&self) -> Self {
        if self.is_negative() { -self } else { self.clone() }
    }

    pub(crate) fn square(&self) -> Self {
        self * self
    }

    pub(crate) fn sqrt(&self) -> Self {
        if self.is_zero() { self.clone() } else { Self(self.0.sqrt()) }
    }

    /// Sine and cosine, to about 2^-300 of 1.
    ///
    /// Near a number for which they are known they come of the angle's small rest, so that the many nearby arguments of
    /// a difference quotient cost little. Beyond 1e10 the rest is no longer small, and the library reduces the angle.
    pub(crate) fn sin_cos(&self) -> (Self, Self) {
        let near = self.to_f64();
        if near.abs() > 1e10 {
            return self.sin_cos_from_library();
        }
        let rest = self - Self::from(near);
        let (sin, cos) = known_sin_cos(near);
        let (small_sin, small_cos) = rest.sin_cos_by_series();
        (&sin * &small_cos + &cos * &small_sin, &cos * &small_cos - &sin * &small_sin)
    }

    fn sin_cos_from_library(&self) -> (Self, Self) {
        let (sin, cos) = self.0.sin_cos();
        (Self(sin), Self(cos))
    }

    fn sin_cos_by_series(&self) -> (Self, Self) {
        let squared = self.square();
        let sin = alternating_series(&squared, |n| f64::from((2 * n) * (2 * n + 1)));
        let cos = alternating_series(&squared, |n| f64::from((2 * n - 1) * (2 * n)));
        (self * sin, cos)
    }

    /// The angle in [0, pi] of the point (x, self), where self is not negative and the point not the origin.
    ///
    /// A first guess in `f64` turns the point next to the x-axis, where the series of the arctangent is short.
    pub(crate) fn atan2(&self, x: &Self) -> Self {
        let length = (self.square() + x.square()).sqrt();
        let guess = (self / &length).to_f64().atan2((x / &length).to_f64());
        let (sin, cos) = known_sin_cos(guess);
        let along = x * &cos + self * &sin;
        let across = self * &cos - x * &sin;
        let tangent = across / along;
        Self::from(guess) + &tangent * arctangent_series(&tangent.square())
    }
}

/// 1 - q/(a1) + q^2/(a1 a2) - ..., where `divisor(n)` is a_n, to the last bit; q is below 1.
pub(crate) fn alternating_series(q: &Big, divisor: impl Fn(u32) -> f64) -> Big {
    let smallest = Big::power_of_two(-(PRECISION as isize));
    let mut term = Big::from(1.0);
    let mut sum = term.clone();
    for n in 1.. {
        term = -(term * q / Big::from(divisor(n)));
        if term.abs() < smallest {
            break;
        }
        sum = sum + &term;
    }
    sum
}

/// atan(x) / x = 1 - q/3 + q^2/5 - ... for q = x^2 far below 1.
pub(crate) fn arctangent_series(q: &Big) -> Big {
    odd_reciprocals(q, 1)
}

/// (1 - atan(x) / x) / x^2 = 1/3 - q/5 + q^2/7 - ... for q = x^2 far below 1.
pub(crate) fn arctangent_rest_series(q: &Big) -> Big {
    odd_reciprocals(q, 3)
}

/// 1/first - q/(first + 2) + q^2/(first + 4) - ...
fn odd_reciprocals(q: &Big, first: u32) -> Big {
    let smallest = Big::power_of_two(-(PRECISION as isize));
    let mut power = Big::from(1.0);
    let mut sum = Big::from(0.0);
    for n in 0.. {
        if power.abs() < smallest {
            break;
        }
        sum = sum + &power / Big::from(f64::from(first + 2 * n));
        power = -(power * q);
    }
    sum
}

/// Sine and cosine of an `f64`, from the library once for each.
fn known_sin_cos(angle: f64) -> (Big, Big) {
    thread_local!(static KNOWN: RefCell<HashMap<u64, (Big, Big)>> = RefCell::default());
    KNOWN.with_borrow_mut(|known| {
        known.entry(angle.to_bits()).or_insert_with(|| Big::from(angle).sin_cos_from_library()).clone()
    })
}
