//! The two precisions that are measured.

use std::fmt::Debug;

use pga_motor::Real;

use crate::big::Big;

/// A floating-point type, what is special about its numbers, and its inverse cosine, which only textbooks want.
pub(crate) trait Float: Real + Debug {
    const NAME: &'static str;
    /// The unit roundoff u is 2 to this power.
    const ROUNDOFF_EXPONENT: isize;
    /// The smallest positive number is 2 to this power.
    const SMALLEST_EXPONENT: isize;
    /// Half-angles up to a quarter of a turn, apart from the special ones.
    const HALF_ANGLES: &'static [f64];
    /// Half-angles beyond half a turn.
    const LARGE_HALF_ANGLES: &'static [f64];
    /// Lengths of ideal parts that only scaling survives.
    const EXTREME_LENGTHS: [f64; 2];
    /// Factors between which even multivectors normalise.
    const SCALES: [f64; 4];

    fn from_big(value: &Big) -> Self;
    fn acos(self) -> Self;
    fn next_down(self) -> Self;
    fn next_up(self) -> Self;

    fn to_big(self) -> Big {
        self.to_f64().into()
    }

    /// The unit roundoff.
    fn roundoff() -> Big {
        Big::power_of_two(Self::ROUNDOFF_EXPONENT)
    }

    /// The smallest positive number.
    fn smallest() -> Big {
        Big::power_of_two(Self::SMALLEST_EXPONENT)
    }
}

macro_rules! implement_float {
    ($float:ident, $from_big:ident, $($constants:tt)*) => {
        impl Float for $float {
            const NAME: &'static str = stringify!($float);
            const ROUNDOFF_EXPONENT: isize = -($float::MANTISSA_DIGITS as isize);
            const SMALLEST_EXPONENT: isize = ($float::MIN_EXP - $float::MANTISSA_DIGITS as i32) as isize;
            $($constants)*

            fn from_big(value: &Big) -> Self {
                value.$from_big()
            }
            fn acos(self) -> Self {
                self.acos()
            }
            fn next_down(self) -> Self {
                self.next_down()
            }
            fn next_up(self) -> Self {
                self.next_up()
            }
        }
    };
}

implement_float! { f32, to_f32,
    const HALF_ANGLES: &'static [f64] = &[
        0.0, 1e-45, 1e-40, 1e-38, 1e-30, 1e-25, 1e-20, 1e-19, 1e-15, 1e-12, 1e-10, 1e-8, 1e-7, 1e-6, 1e-5, 1e-4, 4e-4,
        1e-3, 3e-3, 1e-2, 3e-2, 1e-1, 0.3, 0.6, 1.0, 1.3,
    ];
    const LARGE_HALF_ANGLES: &'static [f64] = &[3.0, 4.0, 5.0, 10.0, 1e3, 1e6, 1e10, 1e19, 1e30, 1e38];
    const EXTREME_LENGTHS: [f64; 2] = [1e-25, 1e12];
    const SCALES: [f64; 4] = [1e-15, 1e-3, 1e3, 1e15];
}

implement_float! { f64, to_f64,
    const HALF_ANGLES: &'static [f64] = &[
        0.0, 5e-324, 1e-310, 1e-300, 1e-200, 1e-160, 1e-154, 1e-100, 1e-20, 1e-16, 1e-12, 1e-10, 1e-8, 1e-7, 1e-6, 1e-5,
        1e-4, 1e-3, 3e-3, 1e-2, 3e-2, 1e-1, 0.3, 0.6, 1.0, 1.3,
    ];
    const LARGE_HALF_ANGLES: &'static [f64] = &[3.0, 4.0, 5.0, 10.0, 1e3, 1e6, 1e10, 1e100, 1e160, 1e300];
    const EXTREME_LENGTHS: [f64; 2] = [1e-200, 1e100];
    const SCALES: [f64; 4] = [1e-120, 1e-3, 1e3, 1e120];
}
