//! The signature of a geometric algebra: how many of its generators square to +1, to -1 and to 0.

use std::fmt;

/// Cl(p,q,r): `p` generators square to +1, `q` to -1 and `r` to 0.
///
/// The generators are numbered null ones first, then positive, then negative. The first is `e0` where there is a null
/// generator and `e1` where there is none, so Cl(3,0,1) has the null `e0` and the positive `e1 e2 e3`, and Cl(1,3,0)
/// has the positive `e1` and the negative `e2 e3 e4`.
///
/// Any three counts make a signature; what works with one says how many dimensions it takes, at most
/// [`Signature::MAX_DIMENSION`].
///
/// ```
/// use ga_codegen::algebra::Signature;
///
/// let pga3d = Signature::new(3, 0, 1);
/// assert_eq!(pga3d.dimension(), 4);
/// assert_eq!(pga3d.to_string(), "Cl(3,0,1)");
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Signature {
    positive: usize,
    negative: usize,
    null: usize,
}

impl Signature {
    /// The most generators that an algebra may have here: its multivectors then have 256 coefficients.
    pub const MAX_DIMENSION: usize = 8;

    /// The signature with `p` positive, `q` negative and `r` null generators.
    pub const fn new(p: usize, q: usize, r: usize) -> Self {
        Self { positive: p, negative: q, null: r }
    }

    /// How many generators square to +1.
    pub const fn positive(self) -> usize {
        self.positive
    }

    /// How many generators square to -1.
    pub const fn negative(self) -> usize {
        self.negative
    }

    /// How many generators square to 0.
    pub const fn null(self) -> usize {
        self.null
    }

    /// How many generators there are, `usize::MAX` if a `usize` cannot count them.
    pub const fn dimension(self) -> usize {
        self.positive.saturating_add(self.negative).saturating_add(self.null)
    }
}

impl fmt::Display for Signature {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "Cl({},{},{})", self.positive, self.negative, self.null)
    }
}

#[cfg(test)]
mod tests {
    use super::Signature;

    #[test]
    fn displays_its_three_counts() {
        assert_eq!(Signature::new(3, 0, 1).to_string(), "Cl(3,0,1)");
        assert_eq!(Signature::new(1, 3, 0).to_string(), "Cl(1,3,0)");
    }

    #[test]
    fn dimension_counts_every_generator_and_saturates() {
        assert_eq!(Signature::new(4, 1, 2).dimension(), 7);
        assert_eq!(Signature::new(usize::MAX, 1, usize::MAX).dimension(), usize::MAX);
    }
}
