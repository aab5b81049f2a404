//! Elements of the odd part of the algebra, and multiples of the pseudoscalar.

use crate::{OddMultivector, Pseudoscalar, Scalar, kernels};

impl<T: Scalar> OddMultivector<T> {
    /// The trivector part changes its sign.
    #[inline]
    pub fn reverse(self) -> Self {
        kernels::odd_reverse(self)
    }

    /// The right complement: X ^ X.dual() is e0123 for every basis blade X.
    #[inline]
    pub fn dual(self) -> Self {
        kernels::odd_dual(self)
    }

    /// The inverse of [`Self::dual`].
    #[inline]
    pub fn undual(self) -> Self {
        kernels::odd_undual(self)
    }
}

impl<T: Scalar> Pseudoscalar<T> {
    /// The inverse of the right complement, a number: that of e0123 is 1.
    #[inline]
    pub fn undual(self) -> T {
        kernels::pseudoscalar_undual(self)
    }
}
