//! The traits that generated code asks of its scalars, for definitions that do not name a module with their own.

use crate::kernel::Definition;
use proc_macro2::TokenStream;
use quote::quote;

/// The import of the named module, or a module `scalar` with the traits and its import.
pub(super) fn module(definition: &Definition) -> TokenStream {
    let is_packed = definition.kernels.iter().any(|kernel| kernel.packed.is_some());
    let four = is_packed.then(|| quote!(Four,));
    if let Some(path) = &definition.scalar_path {
        return quote! {
            use #path::{#four Real, Scalar};
        };
    }
    let type_of_four = is_packed.then(|| {
        quote! {
            /// Four of them side by side.
            type Four: Four<Self>;
        }
    });
    let (array, lanes_module) = if is_packed {
        (
            quote!(
                type Four = Array4<Self>;
            ),
            lanes(),
        )
    } else {
        Default::default()
    };
    let (f32, f64) = (implementation(quote!(f32), &array), implementation(quote!(f64), &array));
    quote! {
        use self::scalar::{#four Real, Scalar};

        /// What the generated code asks of its numbers.
        pub mod scalar {
            use core::ops::{Add, Div, Mul, Neg, Sub};

            /// A commutative ring of `Copy` values.
            pub trait Scalar:
                Copy + PartialEq + Add<Output = Self> + Sub<Output = Self> + Mul<Output = Self> + Neg<Output = Self>
            {
                #type_of_four
                /// 0
                const ZERO: Self;
                /// 1
                const ONE: Self;
                /// The number `numerator / denominator`, as exact as the type can hold it.
                fn from_ratio(numerator: i32, denominator: i32) -> Self;
                /// `self * factor + term`; a type whose instructions fuse the two may round once.
                fn mul_add(self, factor: Self, term: Self) -> Self {
                    self * factor + term
                }
            }

            /// Real numbers.
            pub trait Real: Scalar + PartialOrd + Div<Output = Self> {
                /// The nearest number.
                fn from_f64(value: f64) -> Self;
                /// The square root.
                fn sqrt(self) -> Self;
                /// Sine and cosine of an angle in radians.
                fn sin_cos(self) -> (Self, Self);
                /// The angle of the point (x, self) in radians, in [-pi, pi].
                fn atan2(self, x: Self) -> Self;
                /// The absolute value.
                fn abs(self) -> Self;
                /// Whether the number is neither infinite nor NaN.
                fn is_finite(self) -> bool;
                /// The greatest power of two that is not above the magnitude; for 0 and subnormal numbers the least normal
                /// one.
                fn power_of_two(self) -> Self;
                /// `self / denominator`, and `limit` where the denominator is 0 and this number finite.
                fn quotient(self, denominator: Self, limit: Self) -> Self {
                    if denominator == Self::ZERO && self.is_finite() { limit } else { self / denominator }
                }
                /// The square root of the sum of the squares, though these may leave the range of the numbers.
                fn norm<const N: usize>(components: [Self; N]) -> Self {
                    let square_sum = |scale: Self| {
                        let scaled = components.map(|component| component * scale);
                        scaled.into_iter().fold(Self::ZERO, |sum, component| sum + component * component)
                    };
                    let larger = |a: Self, b: Self| if b > a { b } else { a };
                    let largest = components.into_iter().fold(Self::ZERO, |largest, c| larger(largest, c.abs()));
                    if !largest.is_finite() {
                        return square_sum(Self::ONE).sqrt();
                    }
                    let scale = largest.power_of_two();
                    square_sum(Self::ONE / scale).sqrt() * scale
                }
            }

            #lanes_module
            #f32
            #f64
        }
    }
}

/// Arithmetic on four lanes, for packed kernels.
fn lanes() -> TokenStream {
    let operator = |name: TokenStream, method: TokenStream| {
        quote! {
            impl<S: Scalar> #name for Array4<S> {
                type Output = Self;
                #[inline]
                fn #method(self, other: Self) -> Self {
                    let ([a, b, c, d], [e, f, g, h]) = (self.0, other.0);
                    Self([a.#method(e), b.#method(f), c.#method(g), d.#method(h)])
                }
            }
        }
    };
    let (add, sub, mul) =
        (operator(quote!(Add), quote!(add)), operator(quote!(Sub), quote!(sub)), operator(quote!(Mul), quote!(mul)));
    quote! {
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

        /// Four numbers in an array, whatever they are.
        #[derive(Clone, Copy, Debug, PartialEq)]
        pub struct Array4<S>(pub [S; 4]);

        impl<S: Scalar> Four<S> for Array4<S> {
            const IS_FAST: bool = false;
            #[inline]
            fn new(lanes: [S; 4]) -> Self {
                Self(lanes)
            }
            #[inline]
            fn to_array(self) -> [S; 4] {
                self.0
            }
            #[inline]
            fn shuffle<const MASK: i32>(self) -> Self {
                Self([0, 2, 4, 6].map(|place| self.0[(MASK >> place & 3) as usize]))
            }
            #[inline]
            fn negate<const MASK: i32>(self) -> Self {
                let [a, b, c, d] = self.0;
                let lane = |place: i32, x: S| if MASK >> place & 1 == 1 { -x } else { x };
                Self([lane(0, a), lane(1, b), lane(2, c), lane(3, d)])
            }
        }

        #add
        #sub
        #mul
    }
}

/// The functions are named by their full path, so that a crate without std is refused and not sent into a recursion.
fn implementation(float: TokenStream, array: &TokenStream) -> TokenStream {
    quote! {
        impl Scalar for #float {
            #array
            const ZERO: Self = 0.0;
            const ONE: Self = 1.0;
            fn from_ratio(numerator: i32, denominator: i32) -> Self {
                numerator as Self / denominator as Self
            }
        }

        impl Real for #float {
            fn from_f64(value: f64) -> Self {
                value as Self
            }
            fn sqrt(self) -> Self {
                std::primitive::#float::sqrt(self)
            }
            fn sin_cos(self) -> (Self, Self) {
                std::primitive::#float::sin_cos(self)
            }
            fn atan2(self, x: Self) -> Self {
                std::primitive::#float::atan2(self, x)
            }
            fn abs(self) -> Self {
                std::primitive::#float::abs(self)
            }
            fn is_finite(self) -> bool {
                std::primitive::#float::is_finite(self)
            }
            fn power_of_two(self) -> Self {
                let infinity = std::primitive::#float::INFINITY;
                let exponent = std::primitive::#float::from_bits(self.to_bits() & infinity.to_bits());
                exponent.max(std::primitive::#float::MIN_POSITIVE)
            }
        }
    }
}
