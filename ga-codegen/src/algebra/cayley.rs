//! The products of basis blades, and their tables.

use super::{Basis, Blade, Sign};

/// A bilinear product of the algebra. On a pair of blades each is a signed blade or zero.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Product {
    /// The geometric product.
    Geometric,
    /// The outer product (meet, where vectors are planes): the part of grade r + s.
    Outer,
    /// The regressive product (join): `undual(dual a ^ dual b)`.
    Regressive,
    /// The inner product: the part of grade |r - s|, scalars included.
    Inner,
    /// The left contraction: the part of grade s - r.
    LeftContraction,
    /// The right contraction: the part of grade r - s.
    RightContraction,
    /// The part of grade 0.
    Scalar,
    /// (ab - ba) / 2.
    Commutator,
    /// (ab + ba) / 2.
    Anticommutator,
}

impl Product {
    /// Every product, in the order of the documentation.
    pub const ALL: [Self; 9] = [
        Self::Geometric,
        Self::Outer,
        Self::Regressive,
        Self::Inner,
        Self::LeftContraction,
        Self::RightContraction,
        Self::Scalar,
        Self::Commutator,
        Self::Anticommutator,
    ];

    /// The name on the command line, such as `left-contraction`.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Geometric => "geometric",
            Self::Outer => "outer",
            Self::Regressive => "regressive",
            Self::Inner => "inner",
            Self::LeftContraction => "left-contraction",
            Self::RightContraction => "right-contraction",
            Self::Scalar => "scalar",
            Self::Commutator => "commutator",
            Self::Anticommutator => "anticommutator",
        }
    }

    /// The product of two ascending blades: a signed ascending blade, or `None` for zero.
    pub fn of_blades(self, basis: &Basis, a: Blade, b: Blade) -> Option<(Sign, Blade)> {
        if self == Self::Regressive {
            let ((sign_a, dual_a), (sign_b, dual_b)) = (basis.dual(a), basis.dual(b));
            let (sign, outer) = Self::Outer.of_blades(basis, dual_a, dual_b)?;
            let (sign_undual, blade) = basis.undual(outer);
            return Some((sign_a * sign_b * sign * sign_undual, blade));
        }
        let (sign, blade) = a.geometric(b, basis.signature())?;
        let (r, s, grade) = (i64::from(a.grade()), i64::from(b.grade()), i64::from(blade.grade()));
        let kept = match self {
            Self::Geometric | Self::Regressive => true,
            Self::Outer => grade == r + s,
            Self::Inner => grade == (r - s).abs(),
            Self::LeftContraction => grade == s - r,
            Self::RightContraction => grade == r - s,
            Self::Scalar => grade == 0,
            // Two blades commute or anticommute; halving the sum or difference leaves the product itself or nothing.
            Self::Commutator => commutation_sign(a, b).is_minus(),
            Self::Anticommutator => !commutation_sign(a, b).is_minus(),
        };
        kept.then_some((sign, blade))
    }
}

/// The sign s in a b = s b a.
fn commutation_sign(a: Blade, b: Blade) -> Sign {
    a.reordering_sign(b) * b.reordering_sign(a)
}

/// The table of a product on the named blades of a basis: row times column, each entry a signed name or zero.
pub fn table(basis: &Basis, product: Product) -> Vec<Vec<Option<(Sign, &str)>>> {
    let blades = basis.blades();
    let entry = |a: &super::NamedBlade, b: &super::NamedBlade| {
        let (sign, blade) = product.of_blades(basis, a.blade, b.blade)?;
        let named = basis.named(blade);
        Some((sign * a.sign * b.sign * named.sign, named.name.as_str()))
    };
    blades.iter().map(|a| blades.iter().map(|b| entry(a, b)).collect()).collect()
}
