//! Four `f32` in a register of SSE2, which every x86-64 has: the one place for these instructions.
#![expect(unsafe_code, reason = "the compiler wants it for instructions that a function is not said to need")]

use crate::four::Four;
use core::arch::x86_64::{
    __m128, _mm_add_ps, _mm_mul_ps, _mm_setr_ps, _mm_shuffle_ps, _mm_storeu_ps, _mm_sub_ps, _mm_xor_ps,
};
use core::ops::{Add, Mul, Sub};

/// Four `f32` in a register.
#[derive(Clone, Copy, Debug)]
pub struct F32x4(__m128);

/// Calls an intrinsic that takes and gives values only.
macro_rules! sse2 {
    // SAFETY: this file is compiled only where the target has SSE2, and the intrinsic asks for no more.
    ($call:expr) => {
        unsafe { $call }
    };
}

macro_rules! implement_lanewise {
    ($($name:ident $method:ident $intrinsic:ident),*) => {
        $(impl $name for F32x4 {
            type Output = Self;
            #[inline]
            fn $method(self, other: Self) -> Self {
                Self(sse2!($intrinsic(self.0, other.0)))
            }
        })*
    };
}

implement_lanewise!(Add add _mm_add_ps, Sub sub _mm_sub_ps, Mul mul _mm_mul_ps);

impl Four<f32> for F32x4 {
    const IS_FAST: bool = true;
    #[inline]
    fn new([a, b, c, d]: [f32; 4]) -> Self {
        Self(sse2!(_mm_setr_ps(a, b, c, d)))
    }
    #[inline]
    fn to_array(self) -> [f32; 4] {
        let mut lanes = [0.0; 4];
        // SAFETY: as above, and the array has room for four numbers.
        unsafe { _mm_storeu_ps(lanes.as_mut_ptr(), self.0) };
        lanes
    }
    #[inline]
    fn shuffle<const MASK: i32>(self) -> Self {
        Self(sse2!(_mm_shuffle_ps::<MASK>(self.0, self.0)))
    }
    #[inline]
    fn negate<const MASK: i32>(self) -> Self {
        let sign = |lane: i32| if MASK >> lane & 1 == 1 { -0.0 } else { 0.0 };
        Self(sse2!(_mm_xor_ps(self.0, _mm_setr_ps(sign(0), sign(1), sign(2), sign(3)))))
    }
}
