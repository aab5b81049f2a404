//! Three trits that are to balance.

use super::Trit;

/// Three trits, as of three things that are combined.
///
/// Its sum modulo 3 is 0 in two ways that are told apart: +1, 0 and -1 in any order *balance*, while three that are
/// alike cancel only because 3 is 0, so they have to be rebalanced. Of the 27 triads 6 balance, 3 are alike, and the
/// sum of the other 18 is not 0.
///
/// ```
/// use pga_motor::gf3::{Balance, Triad, Trit};
///
/// let balanced = Triad::new(Trit::Plus, Trit::Ergodic, Trit::Minus);
/// let alike = Triad::new(Trit::Ergodic, Trit::Ergodic, Trit::Ergodic);
/// assert_eq!((balanced.sum(), balanced.balance()), (Trit::Ergodic, Balance::Balanced));
/// assert_eq!((alike.sum(), alike.balance()), (Trit::Ergodic, Balance::Alike));
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Triad(pub [Trit; 3]);

/// How the trits of a [`Triad`] add up.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Balance {
    /// +1, 0 and -1, each once; the sum is 0.
    Balanced,
    /// The same trit thrice; the sum is 0 modulo 3, but nothing balances anything.
    Alike,
    /// Anything else; the sum is not 0 modulo 3.
    Unbalanced,
}

impl Triad {
    /// Three trits; their order does not matter to what is asked of them.
    pub const fn new(a: Trit, b: Trit, c: Trit) -> Self {
        Self([a, b, c])
    }

    /// The sum modulo 3.
    pub fn sum(self) -> Trit {
        self.0.into_iter().sum()
    }

    /// Whether the sum is 0 modulo 3: balanced or alike.
    pub fn is_conserved(self) -> bool {
        self.sum() == Trit::Ergodic
    }

    /// Whether each of +1, 0 and -1 is there.
    pub fn is_balanced(self) -> bool {
        Trit::ALL.into_iter().all(|trit| self.0.contains(&trit))
    }

    /// How the trits add up.
    pub fn balance(self) -> Balance {
        match (self.is_balanced(), self.is_conserved()) {
            (true, _) => Balance::Balanced,
            (false, true) => Balance::Alike,
            (false, false) => Balance::Unbalanced,
        }
    }
}
