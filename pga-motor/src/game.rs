//! Interpolation as an open game.
//!
//! An *open game* is a piece of a game with its borders left open, so that pieces can be put together. Seen from
//! outside it is a box with four wires:
//!
//! ```text
//!            +------------+
//!  state --->|            |---> play         forwards: what the player sees, and what becomes of the move
//!            |  strategy  |
//!  payoff <--|            |<--- utility      backwards: what the player gets, and what is handed on to who came before
//!            +------------+
//! ```
//!
//! Forwards, [`play`](OpenGame::play) makes a play of a state by a strategy, the move that the player picked.
//! Backwards, [`coplay`](OpenGame::coplay) makes of the utility that comes back from later games the payoff for
//! earlier ones. So time runs to the right in the upper row and the reasons for what was done run to the left in the
//! lower one.
//!
//! Games are put together [one after the other](Sequential), where the play of the first is the state of the second and
//! the payoff of the second the utility of the first, or [side by side](Parallel). The result is an open game again,
//! and how a row of them is bracketed makes no difference but to the nesting of pairs.
//!
//! The idea is that of Ghani, Hedges, Winschel and Zahn, *Compositional Game Theory*, LICS 2018. Its open games have a
//! best response besides, which says which strategies the player would not change; here nobody optimises, so it is
//! left out.

use crate::{EvenMultivector, Motor, Real};

/// A game with open borders: a state and a strategy go in, a play comes out; a utility comes back, a payoff goes out.
pub trait OpenGame {
    /// What the player sees.
    type State;
    /// What the player chooses.
    type Strategy;
    /// What comes of it.
    type Play;
    /// What comes back from what follows.
    type Utility;
    /// What is handed back to what went before.
    type Payoff;

    /// The play in a state by a strategy.
    fn play(&self, state: Self::State, strategy: Self::Strategy) -> Self::Play;

    /// The payoff of that state and strategy for a utility.
    fn coplay(&self, state: Self::State, strategy: Self::Strategy, utility: Self::Utility) -> Self::Payoff;
}

/// Two games one after the other: the second sees the play of the first, the first gets the payoff of the second.
///
/// A strategy is a pair of strategies. Utilities pass through the second game first.
///
/// ```
/// use pga_motor::f64::{Direction, Motor, Translator};
/// use pga_motor::game::{MotorGame, OpenGame, Sequential};
///
/// /// Sees a length and plays the way along x by it; what it gets it hands back in cents.
/// struct Errand;
/// impl OpenGame for Errand {
///     type State = f64;
///     type Strategy = ();
///     type Play = (Motor, Motor);
///     type Utility = f64;
///     type Payoff = f64;
///     fn play(&self, length: f64, (): ()) -> (Motor, Motor) {
///         (Motor::IDENTITY, Translator::from_vector(Direction::X * length).into())
///     }
///     fn coplay(&self, _: f64, (): (), utility: f64) -> f64 {
///         100.0 * utility
///     }
/// }
///
/// let game = Sequential(Errand, MotorGame::default());
/// let motor = game.play(4.0, ((), 0.25));
/// assert_eq!(motor.translator().vector(), Direction::X);
/// assert_eq!(game.coplay(4.0, ((), 0.25), (motor.into(), 1.0)), 1100.0);
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Sequential<First, Second>(pub First, pub Second);

impl<First, Second> OpenGame for Sequential<First, Second>
where
    First: OpenGame,
    First::State: Clone,
    First::Strategy: Clone,
    Second: OpenGame<State = First::Play, Payoff = First::Utility>,
{
    type State = First::State;
    type Strategy = (First::Strategy, Second::Strategy);
    type Play = Second::Play;
    type Utility = Second::Utility;
    type Payoff = First::Payoff;

    fn play(&self, state: Self::State, (first, second): Self::Strategy) -> Self::Play {
        self.1.play(self.0.play(state, first), second)
    }

    fn coplay(&self, state: Self::State, (first, second): Self::Strategy, utility: Self::Utility) -> Self::Payoff {
        let between = self.0.play(state.clone(), first.clone());
        self.0.coplay(state, first, self.1.coplay(between, second, utility))
    }
}

/// Two games side by side, which do not see each other: everything is a pair.
///
/// ```
/// use pga_motor::f64::{Motor, Rotor};
/// use pga_motor::game::{MotorGame, OpenGame, Parallel};
///
/// let arms = Parallel(MotorGame::default(), MotorGame::default());
/// let ends = (Motor::IDENTITY, Motor::from(Rotor::about_z(1.0)));
/// let (left, right) = arms.play((ends, ends), (0.0, 1.0));
/// assert_eq!((left, right), ends);
/// let off = left * 2.0;
/// assert_eq!(arms.coplay((ends, ends), (0.0, 1.0), ((off, 0.0), (right.into(), 0.0))), (-5.0, 10.0));
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Parallel<Left, Right>(pub Left, pub Right);

impl<Left: OpenGame, Right: OpenGame> OpenGame for Parallel<Left, Right> {
    type State = (Left::State, Right::State);
    type Strategy = (Left::Strategy, Right::Strategy);
    type Play = (Left::Play, Right::Play);
    type Utility = (Left::Utility, Right::Utility);
    type Payoff = (Left::Payoff, Right::Payoff);

    fn play(&self, (left, right): Self::State, strategy: Self::Strategy) -> Self::Play {
        (self.0.play(left, strategy.0), self.1.play(right, strategy.1))
    }

    fn coplay(&self, (left, right): Self::State, strategy: Self::Strategy, utility: Self::Utility) -> Self::Payoff {
        (self.0.coplay(left, strategy.0, utility.0), self.1.coplay(right, strategy.1, utility.1))
    }
}

/// Interpolation as a game: the player sees two motors, chooses how far to go from one to the other, and is rewarded if
/// what becomes of the play is still a motion.
///
/// What comes back is a reward and the result: the motor that was played, after whatever happened to it. Anyone may
/// have scaled or summed it, so it is an [`EvenMultivector`].
///
/// ```
/// use pga_motor::f64::{Motor, Rotor};
/// use pga_motor::game::MotorGame;
///
/// let game = MotorGame::default();
/// let ends = (Motor::IDENTITY, Motor::from(Rotor::about_z(1.0)));
/// let middle = game.play(ends, 0.5);
/// assert!((middle - Motor::from(Rotor::about_z(0.5))).norm() < 1e-15);
/// assert_eq!(game.coplay(middle.into(), 1.0), 11.0);
/// // The sum of two motors is shorter than a motor.
/// assert_eq!(game.coplay((ends.0 + ends.1) * 0.5, 1.0), -4.0);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MotorGame<T> {
    /// How far the two relations of a motor, of squares and products of coefficients, may be from holding; absolute.
    pub tolerance: T,
}

impl<T: Real> Default for MotorGame<T> {
    /// A tolerance of the square root of EPSILON: 1.5e-8 for `f64`, 3.5e-4 for `f32`.
    ///
    /// Rounding errors of a few EPSILON in every coefficient, relative to the norm of its part, are a few EPSILON in
    /// the first relation, and as many times the ideal norm in the second. So they pass up to ideal norms of some 1e7
    /// in
    /// `f64` and 500 in `f32`.
    fn default() -> Self {
        Self { tolerance: T::EPSILON.sqrt() }
    }
}

impl<T: Real> MotorGame<T> {
    /// The motor at `t` on the screw from the first to the second: [`Motor::screw_lerp`].
    pub fn play(&self, (start, end): (Motor<T>, Motor<T>), t: T) -> Motor<T> {
        start.screw_lerp(end, t)
    }

    /// The reward and 10 more if the result is a motor within the tolerance, else 5 less; NaN and infinity are none.
    pub fn coplay(&self, result: EvenMultivector<T>, reward: T) -> T {
        if result.is_unit(self.tolerance) { reward + T::from_ratio(10, 1) } else { reward - T::from_ratio(5, 1) }
    }
}

impl<T: Real> OpenGame for MotorGame<T> {
    type State = (Motor<T>, Motor<T>);
    type Strategy = T;
    type Play = Motor<T>;
    /// What became of the play, and the reward for it.
    type Utility = (EvenMultivector<T>, T);
    type Payoff = T;

    /// [`MotorGame::play`]
    fn play(&self, ends: Self::State, t: T) -> Motor<T> {
        self.play(ends, t)
    }

    /// [`MotorGame::coplay`]; it depends on the state and the strategy only by what became of them.
    fn coplay(&self, _: Self::State, _: T, (result, reward): Self::Utility) -> T {
        self.coplay(result, reward)
    }
}

#[cfg(test)]
mod tests;
