//! The motor game, and the laws of composition on games that write down what is asked of them.

use super::*;
use crate::{Direction, Rotor, Translator};

fn ends() -> (Motor<f64>, Motor<f64>) {
    let turn = Rotor::about_x(2.0);
    (Motor::IDENTITY, Translator::from_vector(Direction::new(1.0, -2.0, 3.0)) * turn)
}

/// Appends what it sees to what it is told, so that the result tells who was asked in which order.
#[derive(Clone, Copy)]
struct Scribe(char);

impl OpenGame for Scribe {
    type State = String;
    type Strategy = u8;
    type Play = String;
    type Utility = String;
    type Payoff = String;

    fn play(&self, state: String, strategy: u8) -> String {
        format!("{state}{}{strategy}", self.0)
    }

    fn coplay(&self, state: String, strategy: u8, utility: String) -> String {
        format!("{utility} {}{strategy}({state})", self.0)
    }
}

#[test]
fn play_is_the_screw_between_the_motors() {
    let game = MotorGame::default();
    for t in [-0.5, 0.0, 0.3, 1.0, 2.0] {
        assert_eq!(game.play(ends(), t), ends().0.screw_lerp(ends().1, t));
    }
}

#[test]
fn coplay_rewards_unit_motors_and_takes_from_all_else() {
    let game = MotorGame::default();
    let motor = EvenMultivector::from(game.play(ends(), 0.7));
    let pseudoscalar = EvenMultivector::new(0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0);
    assert_eq!(game.coplay(motor, 3.0), 13.0);
    assert_eq!(game.coplay(motor * -1.0, 3.0), 13.0);
    // Off the norm, and off the Study quadric alone.
    assert_eq!(game.coplay(motor * 2.0, 3.0), -2.0);
    assert_eq!(game.coplay(motor + pseudoscalar, 3.0), -2.0);
    assert_eq!(game.coplay(EvenMultivector::ZERO, 3.0), -2.0);
    assert_eq!(game.coplay(motor * f64::NAN, 3.0), -2.0);
}

#[test]
fn coplay_turns_at_the_stated_tolerance() {
    // (5/4)^2 - 1 = 9/16, exactly.
    let result = EvenMultivector::IDENTITY * 1.25;
    assert_eq!(MotorGame { tolerance: 0.5625 }.coplay(result, 0.0), 10.0);
    assert_eq!(MotorGame { tolerance: 0.5624 }.coplay(result, 0.0), -5.0);
}

#[test]
fn default_tolerance_forgives_rounding_in_both_precisions() {
    let far = Translator::from_vector(Direction::new(300.0, -200.0, 100.0));
    let motor: Motor<f32> = far * Rotor::about_z(1.0);
    let played = MotorGame::default().play((motor, motor.reverse()), 0.3);
    assert_eq!(MotorGame::default().coplay(played.into(), 0.0), 10.0);
    let played = MotorGame::default().play((motor.map(f64::from).renormalize(), Motor::IDENTITY), 0.3);
    assert_eq!(MotorGame::default().coplay(played.into(), 0.0), 10.0);
}

#[test]
fn sequential_play_runs_forwards_and_coplay_backwards() {
    let game = Sequential(Scribe('a'), Scribe('b'));
    assert_eq!(game.play("x".into(), (1, 2)), "xa1b2");
    // The second is asked first, with the play of the first as its state.
    assert_eq!(game.coplay("x".into(), (1, 2), "u".into()), "u b2(xa1) a1(x)");
}

#[test]
fn sequential_composition_is_associative() {
    let (a, b, c) = (Scribe('a'), Scribe('b'), Scribe('c'));
    let (left, right) = (Sequential(Sequential(a, b), c), Sequential(a, Sequential(b, c)));
    assert_eq!(left.play("x".into(), ((1, 2), 3)), "xa1b2c3");
    assert_eq!(right.play("x".into(), (1, (2, 3))), "xa1b2c3");
    let payoff = "u c3(xa1b2) b2(xa1) a1(x)";
    assert_eq!(left.coplay("x".into(), ((1, 2), 3), "u".into()), payoff);
    assert_eq!(right.coplay("x".into(), (1, (2, 3)), "u".into()), payoff);
}

#[test]
fn parallel_games_do_not_see_each_other() {
    let game = Parallel(Scribe('a'), Scribe('b'));
    let states = || ("x".to_owned(), "y".to_owned());
    assert_eq!(game.play(states(), (1, 2)), ("xa1".into(), "yb2".into()));
    let payoffs = game.coplay(states(), (1, 2), ("u".into(), "v".into()));
    assert_eq!(payoffs, ("u a1(x)".into(), "v b2(y)".into()));
}

#[test]
fn parallel_composition_is_associative() {
    let (a, b, c) = (Scribe('a'), Scribe('b'), Scribe('c'));
    let (left, right) = (Parallel(Parallel(a, b), c), Parallel(a, Parallel(b, c)));
    let text = str::to_owned;
    let ((x, y), z) = left.play(((text("x"), text("y")), text("z")), ((1, 2), 3));
    assert_eq!((x, (y, z)), right.play((text("x"), (text("y"), text("z"))), (1, (2, 3))));
    let utilities = ((text("u"), text("v")), text("w"));
    let ((x, y), z) = left.coplay(((text("x"), text("y")), text("z")), ((1, 2), 3), utilities);
    let utilities = (text("u"), (text("v"), text("w")));
    assert_eq!((x, (y, z)), right.coplay((text("x"), (text("y"), text("z"))), (1, (2, 3)), utilities));
}

#[test]
fn sequences_side_by_side_are_a_sequence_of_pairs() {
    let (a, b, c, d) = (Scribe('a'), Scribe('b'), Scribe('c'), Scribe('d'));
    let columns = Parallel(Sequential(a, b), Sequential(c, d));
    let rows = Sequential(Parallel(a, c), Parallel(b, d));
    let states = || ("x".to_owned(), "y".to_owned());
    assert_eq!(columns.play(states(), ((1, 2), (3, 4))), rows.play(states(), ((1, 3), (2, 4))));
    let utilities = || ("u".to_owned(), "v".to_owned());
    assert_eq!(
        columns.coplay(states(), ((1, 2), (3, 4)), utilities()),
        rows.coplay(states(), ((1, 3), (2, 4)), utilities())
    );
}

/// Carries a motor on unchanged, or scaled, and sends back what became of it.
struct Road(f64);

impl OpenGame for Road {
    type State = Motor<f64>;
    type Strategy = ();
    type Play = EvenMultivector<f64>;
    type Utility = f64;
    type Payoff = (EvenMultivector<f64>, f64);

    fn play(&self, motor: Motor<f64>, (): ()) -> EvenMultivector<f64> {
        motor * self.0
    }

    fn coplay(&self, motor: Motor<f64>, (): (), reward: f64) -> (EvenMultivector<f64>, f64) {
        (self.play(motor, ()), reward)
    }
}

#[test]
fn motor_game_composes_with_what_becomes_of_its_play() {
    for (scale, payoff) in [(1.0, 12.0), (0.5, -3.0)] {
        let game = Sequential(MotorGame::default(), Road(scale));
        assert_eq!(game.play(ends(), (0.5, ())), ends().0.screw_lerp(ends().1, 0.5) * scale);
        assert_eq!(game.coplay(ends(), (0.5, ()), 2.0), payoff);
    }
}
