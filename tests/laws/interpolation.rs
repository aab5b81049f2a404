//! Interpolations along the path: derived errors, symmetry, speed, and that they stay motors.

use crate::law::{Law, laws};
use crate::motion::{Interpolation, Motion};
use crate::samples::{exact_times, full, pairs, times};
use crate::tie::{Side, any_of, estimate, sides};
use crate::tolerance::Estimate;
use pga_motor::Real;
use proptest::prelude::*;

laws! {
    backwards_is_the_same_path
    the_other_sign_of_the_end_changes_nothing_bit_for_bit
    interpolations_are_unit_motors
    screw_lerp_has_a_constant_twist
    part_of_a_screw_path_is_the_path_between_its_ends
    a_kept_path_gives_the_same_bits
    the_middle_is_the_same_for_nlerp_slerp_and_screw_lerp
    blend_of_two_is_nlerp
}

pub(crate) fn at<M: Motion>(interpolate: Interpolation<M>, a: M, b: M, t: f64) -> M {
    interpolate(a, b, M::Number::from_f64(t))
}

/// What the interpolation of that name commits between motors with these estimates, for t in \[0, 1\].
pub(crate) fn interpolated<M: Motion>(name: &str, (a, one): Side<M>, (b, two): Side<M>, t: f64) -> Estimate {
    let h = (a.reverse() * b).half_angle();
    match name {
        "nlerp" => {
            let chord = (1.0 - 4.0 * t * (1.0 - t) * (h / 2.0).sin().powi(2)).sqrt();
            one.times(1.0 - t).plus(two.times(t)).of_norm(chord).normalized()
        }
        "slerp" => great_arc(one, two, h, t),
        "split_lerp" => {
            let (from, to) = (one.translator().times(1.0 - t), two.translator().times(t));
            from.plus(to).of_norm(1.0).after(great_arc(one.rotor(), two.rotor(), h, t))
        }
        "log_lerp" => {
            let part = |motor: M, given: Estimate, t: f64| given.log(motor.half_angle()).times(t);
            part(a, one, 1.0 - t).plus(part(b, two, t)).exp()
        }
        _ => {
            let (end, part) = if t <= 0.5 { (one, t) } else { (two, 1.0 - t) };
            end.product(one.product(two).log(h).times(part).exp())
        }
    }
}

/// A weight sin(x h)/sin h is off by at most 0.36 times the error of h (the derivative by h is largest at h = pi/2,
/// where it is x cos(x pi/2)), and by 6 u for x, two sines, their two quotients and the product. The sum is of norm 1.
fn great_arc(one: Estimate, two: Estimate, h: f64, t: f64) -> Estimate {
    let angle = one.rotor().product(two.rotor()).error()[0] + 3.0 * one.unit();
    let weighted = |given: Estimate, x: f64| {
        let weight = if h > 1e-4 { (x * h).sin() / h.sin() } else { x };
        let off = 0.36 * angle + 6.0 * given.unit() * weight;
        given.times(weight).off_by(off, off * given.ideal_size())
    };
    weighted(one, 1.0 - t).plus(weighted(two, t)).of_norm(1.0).normalized()
}

fn given<M: Motion>(motor: M) -> Side<M> {
    (motor, estimate(motor))
}

/// Sums commute, and 1 - t is exact. The product ~b a is the reverse of ~a b to rounding, so only where there is no
/// angle taken from it, the path is the same bit for bit, up to the sign. Both ways take the same decision at half a
/// turn, for they look at the sign of one number, the same sum.
///
/// Not so log_lerp to an exact half turn b: it takes the sign of b that is nearer to a, but a half turn a with the sign
/// that it has.
fn backwards_is_the_same_path<M: Motion>(law: &Law) {
    law.holds_for((pairs::<M>(full::<M>()), exact_times()), |((a, b), t)| {
        for (name, interpolate) in M::interpolations() {
            let opposite = (a.reverse() * b).scalar() < 0.0;
            if name == "log_lerp" && opposite && (a.scalar() == 0.0 || b.scalar() == 0.0) {
                continue;
            }
            let (found, expected) = (at(interpolate, a, b, t), at(interpolate, b, a, 1.0 - t));
            if matches!(name, "nlerp" | "log_lerp") {
                prop_assert!(found == expected || found == -expected, "{name}: {found:?}, {expected:?}");
                continue;
            }
            let errors = [((a, b), t), ((b, a), 1.0 - t)].map(|((a, b), t)| interpolated(name, given(a), given(b), t));
            let outcome = law.same_motion(found, expected, &errors);
            prop_assert!(outcome.is_ok(), "{name}: {outcome:?}");
        }
        Ok(())
    });
}

/// But exactly half a turn apart, where the two signs of the end stand for the two ways.
fn the_other_sign_of_the_end_changes_nothing_bit_for_bit<M: Motion>(law: &Law) {
    law.holds_for((pairs::<M>(full::<M>()), times()), |((a, b), t)| {
        if (a.reverse() * b).scalar() != 0.0 {
            for (name, interpolate) in M::interpolations() {
                prop_assert_eq!(at(interpolate, a, -b, t), at(interpolate, a, b, t), "{}", name);
            }
        }
        Ok(())
    });
}

/// What is normalised is unit to 5 u and on the quadric to 18 u times the ideal part before; exponentials to 6 u and 18
/// u. Products add up what their factors are off, the ideal part of one times the norm's of the other, and round.
fn interpolations_are_unit_motors<M: Motion>(law: &Law) {
    law.holds_for((pairs::<M>(full::<M>()), times()), |((a, b), t)| {
        for (name, interpolate) in M::interpolations() {
            let found = at(interpolate, a, b, t).defects();
            let size = interpolated(name, given(a), given(b), t).ideal_size();
            let [norm, study] = match name {
                "nlerp" | "slerp" => [5.0, 18.0],
                "split_lerp" => [5.0, 5.0 + 14.6],
                "log_lerp" => [6.0, 18.0],
                _ => [6.0 + 6.0 + 6.8, 18.0 + 2.0 * 6.0 + 14.6],
            };
            let outcome = law.within(found[0].abs(), 2.0 * norm * M::unit());
            let outcome = outcome.and_then(|()| law.within(found[1].abs(), study * M::unit() * size));
            prop_assert!(outcome.is_ok(), "{name}: {outcome:?}");
        }
        Ok(())
    });
}

fn screw_lerp_has_a_constant_twist<M: Motion>(law: &Law) {
    law.holds_for((pairs::<M>(full::<M>()), exact_times(), exact_times()), |((a, b), x, y)| {
        let (here, next) = (x.min(y), x.max(y));
        let errors = |t| interpolated("screw_lerp", given(a), given(b), t);
        let between = estimate(a).product(estimate(b)).log((a.reverse() * b).half_angle());
        let step = M::exp(M::times(M::path_generator(a, b), next - here));
        let stepped = errors(here).product(between.times(next - here).exp());
        law.same(M::path_at(a, b, here) * step, M::path_at(a, b, next), &[stepped, errors(next)])
    });
}

fn part_of_a_screw_path_is_the_path_between_its_ends<M: Motion>(law: &Law) {
    law.holds_for((pairs::<M>(full::<M>()), exact_times()), |((a, b), t)| {
        // From 1/4 to 3/4 it is at most a quarter of a turn.
        let side = |t: f64| (M::path_at(a, b, t), interpolated("screw_lerp", given(a), given(b), t));
        let ((from, one), (to, two)) = (side(0.25), side(0.75));
        let found = M::path_at(from, to, t);
        let (expected, whole) = side(0.25 + t / 2.0);
        law.same(found, expected, &[interpolated("screw_lerp", (from, one), (to, two), t), whole])
    });
}

fn a_kept_path_gives_the_same_bits<M: Motion>(law: &Law) {
    law.holds_for((pairs::<M>(full::<M>()), times()), |((a, b), t)| {
        let (_, screw_lerp) = M::interpolations()[2];
        prop_assert_eq!(M::path_at(a, b, t), at(screw_lerp, a, b, t));
        Ok(())
    });
}

fn the_middle_is_the_same_for_nlerp_slerp_and_screw_lerp<M: Motion>(law: &Law) {
    law.holds_for(pairs::<M>(full::<M>()), |(a, b)| {
        let [(_, nlerp), (_, slerp), (_, screw_lerp), ..] = M::interpolations();
        let errors = |name| interpolated(name, given(a), given(b), 0.5);
        let expected = at(screw_lerp, a, b, 0.5);
        law.same(at(nlerp, a, b, 0.5), expected, &[errors("nlerp"), errors("screw_lerp")])?;
        law.same(at(slerp, a, b, 0.5), expected, &[errors("slerp"), errors("screw_lerp")])
    });
}

/// The weights of the mean are rounded twice more than those of nlerp. Its signs come from the product the other way
/// round or of the other sign of a motor, so near half a turn it may go the other way.
fn blend_of_two_is_nlerp<M: Motion>(law: &Law) {
    law.holds_for((pairs::<M>(full::<M>()), exact_times()), |((a, b), t)| {
        let (_, nlerp) = M::interpolations()[0];
        let between = a.reverse() * b;
        let found = M::blend(&[(a, 1.0 - t), (b, t)]).expect("the sum is at least 1/sqrt(2) long");
        let weighted = |given: Estimate| given.off_by(2.0 * M::unit(), 2.0 * M::unit() * given.ideal_size());
        let outcome = |(b, two): Side<M>| {
            let one = estimate(a);
            let mean = interpolated("nlerp", (a, weighted(one)), (b, weighted(two)), t);
            law.same_motion(found, at(nlerp, a, b, t), &[mean, interpolated("nlerp", (a, one), (b, two), t)])
        };
        let sides = sides(b, between.log(), between.scalar(), 8.0 * M::unit());
        any_of(sides.into_iter().map(outcome).collect())
    });
}
