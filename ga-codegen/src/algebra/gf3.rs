//! Labels of blades in GF(3), the field of three elements -1, 0 and +1: one grading that products keep, and one
//! published table that they do not.
//!
//! The null degree counts a blade's generators that square to 0; in Cl(3,0,1) it is the degree in e0. Where the
//! product of two blades is not 0 its null degree is the sum of theirs, so it is a grading, modulo 3 as well: scalar
//! 0, e0123 +1. Every change of the unit of length rests on it, see [`check_kernel`](crate::kernel::check_kernel).
//!
//! The trit labels are a classification by the part that a blade has in a motion. No grading: the rotation e23 has the
//! label 0, its square, a scalar, -1.

use super::{Blade, Signature};

impl Blade {
    /// How many of its generators square to 0: its degree under a change of the unit of length, which scales those.
    pub const fn null_degree(self, signature: Signature) -> u32 {
        // Null generators are numbered first. A blade has at most 8 generators, whatever the signature.
        let null = if signature.null() < 8 { signature.null() } else { 8 };
        (self.0 as u32 & ((1 << null) - 1)).count_ones()
    }

    /// The published trit of the part that the blade has in a motion: +1 for a translation, a bivector with a null
    /// generator; 0 for a rotation, a bivector without; -1 for the identity, the scalar. Other blades have none.
    pub const fn trit_label(self, signature: Signature) -> Option<i8> {
        match (self.grade(), self.null_degree(signature)) {
            (0, _) => Some(-1),
            (2, 0) => Some(0),
            (2, _) => Some(1),
            _ => None,
        }
    }
}
