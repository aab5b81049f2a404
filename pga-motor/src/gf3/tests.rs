//! The field, what is made of it, and what the published check says of motors. What products keep of labels is tested
//! in the workspace's root package, beside the reference.

use super::*;
use crate::EvenMultivector;
use crate::f64::{Direction, Motor, Point, Rotor, Translator};
use alloc::string::ToString;

/// An even element with these parts: translation, rotation, identity, each there or not, and a pseudoscalar.
fn with_parts(pattern: usize) -> EvenMultivector<f64> {
    let part = |bit: usize| if pattern & bit == 0 { 0.0 } else { 0.5 };
    EvenMultivector::new(part(1), 0.0, part(2), 0.0, 0.0, 0.0, part(4), 7.0)
}

#[test]
fn truth_table_of_the_published_check() {
    let table = [
        // translation, rotation, identity, sum, conserved
        (false, false, false, 0, true),
        (false, false, true, -1, false),
        (false, true, false, 0, true),
        (false, true, true, -1, false),
        (true, false, false, 1, false),
        (true, false, true, 0, true),
        (true, true, false, 1, false),
        (true, true, true, 0, true),
    ];
    for (index, (translation, rotation, identity, sum, conserved)) in table.into_iter().enumerate() {
        let expected = Presence { translation, rotation, identity };
        assert_eq!(Presence::of(with_parts(index), Tolerances::published()), expected);
        assert_eq!((expected.sum().value(), expected.is_conserved()), (sum, conserved), "{expected:?}");
        assert_eq!(verify_motor_gf3(with_parts(index), Tolerances::published()), conserved, "{expected:?}");
        assert_eq!(expected.weight(Component::Rotation), Trit::Ergodic);
        // With plain numbers in place of trits.
        let plain = i32::from(translation) - i32::from(identity);
        assert_eq!((plain.rem_euclid(3) == 0, i64::from(plain)), (conserved, i64::from(sum)));
    }
}

/// Half a turn about the line through (x, 0, 0) along z, with this slide.
fn half_turn(x: f64, slide: f64) -> Motor {
    let axis = Point::new(x, 0.0, 0.0) & Direction::Z;
    Motor::from_screw(axis, core::f64::consts::PI, slide).expect("an axis")
}

#[test]
fn published_check_passes_translations_and_screws_and_fails_turns_about_the_origin() {
    let conserved = |motor: Motor| verify_motor_gf3(motor, Tolerances::published());
    let (turn, step) = (Rotor::about_y(1.0), Translator::from_vector(Direction::new(1.0, 2.0, 0.0)));
    assert!(conserved(step.into()) && conserved(step * turn) && conserved(turn * step));
    assert!(!conserved(Motor::IDENTITY) && !conserved(-Motor::IDENTITY) && !conserved(turn.into()));
    // A scalar of 6e-17 in place of 0 is below the tolerance.
    assert!(conserved(half_turn(0.0, 0.0)) && !conserved(half_turn(2.0, 0.0)));
}

#[test]
fn published_check_is_no_invariant_of_motion() {
    let conserved =
        |motor: Motor| verify_motor_gf3(motor, Tolerances { translation: 1e-15, ..Tolerances::published() });
    // Seen from elsewhere, and composed.
    let here = half_turn(0.0, 0.0);
    let there = Translator::from_vector(Direction::X).transform_motor(here);
    assert!(conserved(here) && !conserved(there));
    assert!(!conserved(here * here));
    // And the slide of half a turn about an axis through the origin is in e0123, where the check does not look.
    assert!(conserved(half_turn(0.0, 5.0)));
}

#[test]
fn a_part_is_there_where_a_coefficient_exceeds_its_tolerance() {
    let tolerances = Tolerances { translation: 1.0, rotation: 0.5, identity: 0.25 };
    let limits = [0.25, 0.5, 0.5, 0.5, 1.0, 1.0, 1.0, 1.0];
    let nothing = Presence { translation: false, rotation: false, identity: false };
    for (place, limit) in limits.into_iter().enumerate() {
        for sign in [1.0, -1.0] {
            let with =
                |value: f64| EvenMultivector::from(core::array::from_fn(|i| if i == place { value } else { 0.0 }));
            assert_eq!(Presence::of(with(sign * limit), tolerances), nothing);
            let there = Presence {
                translation: (4..7).contains(&place),
                rotation: (1..4).contains(&place),
                identity: place == 0,
            };
            assert_eq!(Presence::of(with(sign * limit * 1.5), tolerances), there);
            let weights = [there.identity, there.rotation, there.translation];
            assert_eq!(Component::ALL.map(|component| there.has(component)), weights);
        }
    }
}

#[test]
fn what_is_not_a_number_is_not_there() {
    let nan = EvenMultivector::from([f64::NAN; 8]);
    let nothing = Presence { translation: false, rotation: false, identity: false };
    assert_eq!(Presence::of(nan, Tolerances::published()), nothing);
}

#[test]
fn components_and_trits_correspond() {
    for component in Component::ALL {
        assert_eq!(Component::of_trit(component.trit()), component);
        assert_eq!(Component::of_label(Some(component.trit().value())), Some(component));
    }
    assert_eq!(Component::of_label(Some(2)), None);
    assert_eq!(Component::ALL.map(Component::trit), Trit::ALL);
    assert_eq!(Component::ALL.map(Component::name), ["Identity", "Rotation", "Translation"]);
    assert_eq!(Trit::ALL.map(Trit::name), ["MINUS", "ERGODIC", "PLUS"]);
    assert_eq!(Trit::ALL.map(|trit| trit.to_string()), ["-1", "0", "+1"]);
}

#[test]
fn trits_are_a_field() {
    for (a, b, c) in triples() {
        assert_eq!((a + b, a * b), (b + a, b * a));
        assert_eq!(((a + b) + c, (a * b) * c), (a + (b + c), a * (b * c)));
        assert_eq!(a * (b + c), a * b + a * c);
        assert_eq!((a + Trit::Ergodic, a * Trit::Plus, a + -a, a - b), (a, a, Trit::Ergodic, a + -b));
        assert_eq!(a.inverse().map(|inverse| a * inverse), (a != Trit::Ergodic).then_some(Trit::Plus));
        assert_eq!([a, b, c].into_iter().product::<Trit>(), a * b * c);
    }
    assert_eq!(core::iter::empty::<Trit>().sum::<Trit>(), Trit::Ergodic);
}

#[test]
fn trits_add_and_multiply_as_integers_do() {
    let trit = Trit::of_integer;
    for (a, b) in (-7..=7).flat_map(|a| (-7..=7).map(move |b| (a, b))) {
        assert_eq!((trit(a) + trit(b), trit(a) - trit(b)), (trit(a + b), trit(a - b)));
        assert_eq!((trit(a) * trit(b), -trit(a)), (trit(a * b), trit(-a)));
        assert_eq!((a - i64::from(trit(a).value())) % 3, 0);
    }
    for value in i8::MIN..=i8::MAX {
        assert_eq!(Trit::from_value(value).map(i8::from), (-1..=1).contains(&value).then_some(value));
    }
}

fn triples() -> impl Iterator<Item = (Trit, Trit, Trit)> {
    let pairs = Trit::ALL.into_iter().flat_map(|a| Trit::ALL.map(|b| (a, b)));
    pairs.flat_map(|(a, b)| Trit::ALL.map(|c| (a, b, c)))
}

#[test]
fn triads_balance_only_with_all_three_trits() {
    let (mut balanced, mut alike, mut unbalanced) = (0, 0, 0);
    for (a, b, c) in triples() {
        let (triad, mut values) = (Triad::new(a, b, c), [a, b, c].map(Trit::value));
        let plain: i8 = values.iter().sum();
        values.sort_unstable();
        let expected = match values {
            [-1, 0, 1] => Balance::Balanced,
            [x, y, z] if x == y && y == z => Balance::Alike,
            _ => Balance::Unbalanced,
        };
        assert_eq!(triad.balance(), expected, "{triad:?}");
        assert_eq!(triad.sum(), Trit::of_integer(plain.into()), "{triad:?}");
        assert_eq!(triad.is_conserved(), plain.rem_euclid(3) == 0, "{triad:?}");
        assert_eq!(triad.is_balanced(), expected == Balance::Balanced, "{triad:?}");
        match expected {
            Balance::Balanced => balanced += 1,
            Balance::Alike => alike += 1,
            Balance::Unbalanced => unbalanced += 1,
        }
    }
    assert_eq!((balanced, alike, unbalanced), (6, 3, 18));
}

#[test]
fn e0_degree_of_a_product_is_the_sum_of_those_of_its_factors() {
    let blades: [EvenMultivector<f64>; 8] =
        core::array::from_fn(|i| core::array::from_fn(|j| f64::from(u8::from(i == j))).into());
    let mut products = 0;
    for (a, b) in blades.iter().flat_map(|&a| blades.iter().map(move |&b| (a, b))) {
        let sum = e0_degree(a).expect("a degree") + e0_degree(b).expect("a degree");
        let product = a * b;
        let expected = (product != EvenMultivector::ZERO).then_some(sum);
        assert_eq!(e0_degree(product), expected, "{a} times {b}");
        products += usize::from(expected.is_some());
    }
    assert_eq!(products, 48);
    assert_eq!(e0_degree(blades[7]), Some(Trit::Plus));
    assert_eq!(e0_degree(blades[0] + blades[4]), None);
}

#[test]
fn methods_rescale_what_they_are_called_on() {
    macro_rules! check {
        ($($types:path { $($entity:ident)* })*) => {
            $({
                use $types as types;
                $(
                    let ones = types::$entity::from([1.0; _]);
                    let expected = types::$entity::NULL_DEGREES.map(|degree| 3.0_f64.powi(degree as i32));
                    assert_eq!(ones.rescale_e0(3.0).to_array(), expected, "{}", stringify!($entity));
                )*
            })*
        };
    }
    check! {
        crate::f64 {
            Motor EvenMultivector OddMultivector Translator Line UnitLine Plane UnitPlane
            Point ProjectivePoint Direction
        }
        crate::pga2d::f64 { Motor EvenMultivector OddMultivector Translator Bivector Line UnitLine Point Direction }
    }
}
