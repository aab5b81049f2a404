//! exp and log.

use crate::law::{Law, laws};
use crate::motion::{Motion, Parts};
use crate::samples::{self, factors, full, generators, motors};
use crate::tie::{any_of, estimate, sides_of_half_turn};
use crate::tolerance::{Estimate, exact};
use proptest::prelude::*;

laws! {
    exp_of_log_is_the_motion
    exp_of_log_double_cover_is_the_motor
    log_of_exp_is_the_generator_below_half_a_turn
    log_of_the_reverse_is_the_negative_bit_for_bit
    both_signs_have_one_log_but_on_the_tie
    roundings_of_a_motor_move_its_log_as_little
    log_is_carried_with_the_motion
    exponentials_of_one_screw_add_up
    one_half_power_is_the_root_and_power_one_the_motion
}

fn exp_of_log_is_the_motion<M: Motion>(law: &Law) {
    law.holds_for(motors::<M>(full::<M>()), |m| {
        let through = estimate(m).log(m.half_angle()).exp();
        law.same_motion(M::exp(m.log()), m, &[through])
    });
}

/// The generator the long way round is that of -m and the axis pi times. The axis of a unit motor next to m is that of
/// m itself: its bivector part is scaled as a whole, and what is off the Study quadric can be in e0123.
fn exp_of_log_double_cover_is_the_motor<M: Motion>(law: &Law) {
    law.holds_for(motors::<M>(full::<M>()), |m| {
        let [_, norm, ideal] = m.sizes();
        let translator = m.scalar() < 0.0 && norm == 0.0;
        let Some(log) = m.log_double_cover() else {
            // Where the axis is so far away that its moment overflows, there is none either.
            let overflow = ideal / norm * 4.0 > largest::<M>();
            prop_assert!(translator || m.scalar() < 0.0 && overflow, "{m:?} has a generator");
            return Ok(());
        };
        prop_assert!(!translator, "{m:?} has no one axis");
        let short = estimate(m).log(m.half_angle());
        let long = || short.plus(exact(M::unit(), [0.0, norm, ideal]).axis(norm).times(std::f64::consts::PI));
        let through = if m.scalar() < 0.0 { long() } else { short };
        law.same(M::exp(log), m, &[through.exp()])
    });
}

fn largest<M: Motion>() -> f64 {
    if samples::is_double::<M>() { f64::MAX } else { f64::from(f32::MAX) }
}

fn log_of_exp_is_the_generator_below_half_a_turn<M: Motion>(law: &Law) {
    law.holds_for(generators::<M>(full::<M>()), |b| {
        let [_, norm, _] = b.sizes();
        if norm > std::f64::consts::FRAC_PI_2 {
            return Ok(());
        }
        let given = exact(M::unit(), b.sizes());
        let m = M::exp(b);
        let sides = sides_of_half_turn(m, given.exp().error()[0]);
        // Turned by a little more or less, the log is longer or shorter by as much.
        let back: Vec<M::Generator> = sides.iter().map(|&(side, _)| side.log()).collect();
        let excess = if sides.len() == 1 { 0.0 } else { 4.0 * given.exp().error()[0] };
        let through = given.exp().off_by(excess, 3.0 * excess * b.sizes()[2]).log(m.half_angle());
        let nearest = back.into_iter().min_by(|x, y| distance(*x, b).total_cmp(&distance(*y, b))).expect("a side");
        law.same(nearest, b, &[through])
    });
}

fn distance<P: Parts>(a: P, b: P) -> f64 {
    let [_, a, _] = a.parts();
    let [_, b, _] = b.parts();
    <f64 as pga_motor::Real>::norm([0, 1, 2, 3].map(|i| a[i] - b[i]))
}

fn log_of_the_reverse_is_the_negative_bit_for_bit<M: Motion>(law: &Law) {
    law.holds_for(motors::<M>(full::<M>()), |m| {
        prop_assert_eq!(m.reverse().log(), -m.log());
        Ok(())
    });
}

/// On the tie, exactly half a turn, log(-m) turns the other way but slides the same way: it is log m less pi times the
/// axis, and so -log m where nothing slides.
fn both_signs_have_one_log_but_on_the_tie<M: Motion>(law: &Law) {
    law.holds_for(motors::<M>(full::<M>()), |m| {
        if m.scalar() != 0.0 {
            prop_assert_eq!((-m).log(), m.log());
            return Ok(());
        }
        let [scalar, bivector, ideal] = m.log().parts();
        prop_assert_eq!((-m).log().parts()[1], bivector.map(|coefficient| -coefficient));
        // log m = k c + n p on the tie, of which the first is the turn's and the second the slide's.
        let slide = m.parts()[2][3] / m.sizes()[1];
        let mirrored = [0, 1, 2, 3].map(|i| 2.0 * slide * m.parts()[1][i] - ideal[i]);
        let expected = Parts::from_parts([scalar, bivector.map(|coefficient| -coefficient), mirrored]);
        let given = exact(M::unit(), m.sizes());
        law.same((-m).log(), expected, &[given.log(m.half_angle()), given.log(m.half_angle())])
    });
}

/// Products are off the Study quadric by the rounding errors of their ideal part, however little they turn.
fn roundings_of_a_motor_move_its_log_as_little<M: Motion>(law: &Law) {
    let units = prop::array::uniform3(prop::array::uniform4(-4.0..4.0));
    law.holds_for((motors::<M>(full::<M>()), units), |(m, units)| {
        let (parts, sizes) = (m.parts(), m.sizes());
        let moved = |part: usize, i: usize| parts[part][i] + units[part][i] * M::unit() * sizes[part];
        let rounded = M::from_parts([0, 1, 2].map(|part| [0, 1, 2, 3].map(|i| moved(part, i))));
        if rounded.scalar() * m.scalar() <= 0.0 {
            return Ok(());
        }
        let given = estimate(m);
        // Each of up to four coefficients by 4 u.
        let off = given.off_by_parts(sizes.map(|size| 8.0 * M::unit() * size));
        law.same(rounded.log(), m.log(), &[off.log(m.half_angle()), given.log(m.half_angle())])
    });
}

fn log_is_carried_with_the_motion<M: Motion>(law: &Law) {
    law.holds_for((motors::<M>(full::<M>()), motors::<M>(full::<M>())), |(g, m)| {
        let found = g.carry_motor(m).log();
        let carried = |m: M, given: Estimate| {
            let h = m.half_angle();
            (estimate(g).carry(given, h.sin()).log(h), estimate(g).carry(given.log(h), h))
        };
        // The scalar part stays but for the defect of g and m.
        let sides = sides_of_half_turn(m, 32.0 * M::unit());
        let outcomes: Vec<_> = sides
            .into_iter()
            .map(|(m, given)| {
                let (before, after) = carried(m, given);
                law.same(found, g.carry_generator(m.log()), &[before, after])
            })
            .collect();
        any_of(outcomes)
    });
}

fn exponentials_of_one_screw_add_up<M: Motion>(law: &Law) {
    law.holds_for((generators::<M>(full::<M>()), factors(), factors()), |(b, x, y)| {
        let part = |factor: f64| (M::exp(M::times(b, factor)), exact(M::unit(), b.sizes()).times(factor));
        let ((first, one), (second, two)) = (part(x), part(y));
        // The sum of the factors is rounded, and so is its product with b: as if b were off by 2 u more.
        let (sum, whole) = (part(x + y).0, exact(M::unit(), b.sizes()).times(x + y));
        let [_, norm, moment] = b.sizes().map(|size| size * (x + y).abs() * 2.0 * M::unit());
        let whole = whole.off_by(norm, moment).exp();
        law.same(first * second, sum, &[one.exp().product(two.exp()), whole])
    });
}

fn one_half_power_is_the_root_and_power_one_the_motion<M: Motion>(law: &Law) {
    law.holds_for(motors::<M>(full::<M>()), |m| {
        let (h, given) = (m.half_angle(), estimate(m));
        law.same(m.powf(0.5), m.sqrt(), &[given.log(h).times(0.5).exp(), given.sqrt(h)])?;
        law.same_motion(m.powf(1.0), m, &[given.log(h).exp()])
    });
}
