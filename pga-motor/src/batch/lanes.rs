//! Items taken apart into coefficients, many items side by side.

use crate::scalar::Fused;
use crate::{Direction, EvenMultivector, Line, Motor, Plane, Point, Rotor, Scalar, Translator, UnitLine, UnitPlane};

/// What can stand in [`Blocks`](super::Blocks): the types of this crate that are made of coefficients.
pub trait Lanewise: Copy + sealed::Fusible {
    /// For each coefficient its values of `W` items.
    type Lanes<const W: usize>: Copy;

    /// The same item in all lanes.
    fn splat<const W: usize>(self) -> Self::Lanes<W>;
    /// The item in a lane, which is below `W`.
    fn get<const W: usize>(lanes: &Self::Lanes<W>, lane: usize) -> Self;
    /// Puts the item into a lane, which is below `W`.
    fn put<const W: usize>(self, lanes: &mut Self::Lanes<W>, lane: usize);
}

/// The kernels know all types that there are.
pub(super) mod sealed {
    use super::super::layout::Same;
    use crate::Scalar;
    use crate::scalar::Fused;

    /// What batches turn items into where machines fuse products with sums.
    pub trait Fusible {
        /// The same of [`Fused`](crate::scalar::Fused) numbers.
        type Fused: Copy;
        /// The item of fused numbers.
        #[doc(hidden)]
        fn fuse(self) -> Self::Fused;
        /// The item of the numbers themselves.
        #[doc(hidden)]
        fn unfuse(fused: Self::Fused) -> Self;
    }

    impl<T: Scalar> Fusible for Same<T> {
        type Fused = Same<Fused<T>>;

        #[inline(always)]
        fn fuse(self) -> Self::Fused {
            Same(Fused(self.0))
        }

        #[inline(always)]
        fn unfuse(fused: Self::Fused) -> Self {
            Same(fused.0.0)
        }
    }

    impl<A: Fusible, B: Fusible> Fusible for (A, B) {
        type Fused = (A::Fused, B::Fused);

        #[inline(always)]
        fn fuse(self) -> Self::Fused {
            (self.0.fuse(), self.1.fuse())
        }

        #[inline(always)]
        fn unfuse(fused: Self::Fused) -> Self {
            (A::unfuse(fused.0), B::unfuse(fused.1))
        }
    }
}

macro_rules! lanewise {
    ($($name:ident $count:literal)*) => { $(
        impl<T: Scalar> sealed::Fusible for $name<T> {
            type Fused = $name<Fused<T>>;

            #[inline(always)]
            fn fuse(self) -> Self::Fused {
                $name::from(self.to_array().map(Fused))
            }

            #[inline(always)]
            fn unfuse(fused: Self::Fused) -> Self {
                Self::from(fused.to_array().map(|Fused(coefficient)| coefficient))
            }
        }

        impl<T: Scalar> Lanewise for $name<T> {
            type Lanes<const W: usize> = [[T; W]; $count];

            #[inline(always)]
            fn splat<const W: usize>(self) -> Self::Lanes<W> {
                self.to_array().map(|coefficient| [coefficient; W])
            }

            #[inline(always)]
            fn get<const W: usize>(lanes: &Self::Lanes<W>, lane: usize) -> Self {
                Self::from(core::array::from_fn::<T, $count, _>(|coefficient| lanes[coefficient][lane]))
            }

            #[inline(always)]
            fn put<const W: usize>(self, lanes: &mut Self::Lanes<W>, lane: usize) {
                for (coefficient, value) in self.to_array().into_iter().enumerate() {
                    lanes[coefficient][lane] = value;
                }
            }
        }
    )* };
}

lanewise! {
    Motor 8 EvenMultivector 8 Rotor 4 Translator 3 Line 6 UnitLine 6 Plane 4 UnitPlane 4 Point 3 Direction 3
}
