//! Every function on every length and instruction set, against the same on single items.

use alloc::vec;
use alloc::vec::Vec;

use super::*;
use crate::{Direction, EvenMultivector, LengthMismatch, Line, Motor, Plane, Point, Real, Rotor, Translator};

/// Motions that differ with the index, of both signs.
fn motor<T: Real>(index: usize) -> Motor<T> {
    let angle = T::from_f64(0.37 * index as f64);
    let half = T::from_ratio(1, 2);
    let rotor = Rotor::about_z(angle) * Rotor::about_y(half * angle) * Rotor::about_x(half * half * angle);
    let (sin, cos) = angle.sin_cos();
    Translator::from_vector(Direction::new(sin, cos, T::ONE + angle)) * rotor
}

fn line<T: Real>(index: usize) -> Line<T> {
    motor::<T>(index).log() * T::from_ratio(9, 8)
}

fn point<T: Real>(index: usize) -> Point<T> {
    motor::<T>(index).transform_origin()
}

fn list<E: Lanewise>(len: usize, item: impl Fn(usize) -> E) -> Blocks<E> {
    (0..len).map(item).collect()
}

/// The lengths around whole blocks.
const LENGTHS: [usize; 9] = [0, 1, 15, 16, 17, 31, 32, 33, 100];

/// Does something with each instruction set that this machine has.
fn with_each(work: impl Fn()) {
    let done = InstructionSet::ALL.map(|set| with_instruction_set(set, &work).is_some());
    assert!(done[0], "the portable one is everywhere");
}

/// The coefficients of an item, to be compared one by one.
trait Coefficients<T> {
    fn coefficients(&self) -> Vec<T>;
}

macro_rules! coefficients {
    ($($name:ident)*) => { $(
        impl<T: Real> Coefficients<T> for $name<T> {
            fn coefficients(&self) -> Vec<T> {
                self.to_array().to_vec()
            }
        }
    )* };
}

coefficients! { Motor Line Plane Point Direction }

/// Kernels' rounding errors are at most 30.3 u times the size of what goes in, as their docs say, u being half of epsilon: programs of
/// other order, or fused, are at most twice that apart. An interpolation adds some ten roundings, a polynomial at most one.
fn assert_near<T: Real + core::fmt::Debug>(found: &impl Coefficients<T>, expected: &impl Coefficients<T>, size: T) {
    let tolerance = T::from_ratio(64, 1) * T::EPSILON * size;
    let (found, expected) = (found.coefficients(), expected.coefficients());
    let near = found.iter().zip(&expected).all(|(&found, &expected)| (found - expected).abs() <= tolerance);
    assert!(near, "{found:?} and {expected:?}, more than {tolerance:?} apart, with {:?}", InstructionSet::in_use());
}

/// One more than how far everything of an index is from the origin.
fn size<T: Real>(index: usize) -> T {
    let far = |i: usize| motor::<T>(i).translator().vector().norm();
    T::ONE + far(index) + far(2 * index + 5) + far(3)
}

/// Compares a function of lists, and that of slices, with that of single items, for each length and instruction set.
fn assert_agrees<T: Real + core::fmt::Debug, R>(
    empty: R,
    blocks: impl Fn(usize, &mut Blocks<R>) -> Result<(), LengthMismatch>,
    slices: impl Fn(usize, &mut [R]) -> Result<(), LengthMismatch>,
    expected: impl Fn(usize) -> R,
) where
    R: Lanewise + PartialEq + core::fmt::Debug + Coefficients<T>,
{
    for len in LENGTHS {
        with_each(|| {
            let mut results = Blocks::filled(empty, len);
            blocks(len, &mut results).unwrap();
            let mut slice = vec![empty; len];
            slices(len, &mut slice).unwrap();
            for (i, (result, in_slice)) in results.iter().zip(&slice).enumerate() {
                assert_near(&result, &expected(i), size(i));
                assert_near(in_slice, &expected(i), size(i));
            }
        });
        let mut results = Blocks::filled(empty, len + 1);
        let before = results.clone();
        assert_eq!(blocks(len, &mut results), Err(LengthMismatch { items: len, results: len + 1 }));
        assert_eq!(results, before);
        let mut slice = vec![empty; len + 1];
        assert_eq!(slices(len, &mut slice), Err(LengthMismatch { items: len, results: len + 1 }));
        assert_eq!(slice, vec![empty; len + 1]);
    }
}

fn products_agree_with_single_ones<T: Real + core::fmt::Debug>() {
    let other = |i: usize| motor::<T>(2 * i + 5);
    let (a, b) = (|n| vec(n, motor::<T>), |n| vec(n, other));
    assert_agrees(
        Motor::IDENTITY,
        |n, out| list(n, motor::<T>).mul_into(&list(n, other), out),
        |n, out| Motor::mul_slice(&a(n), &b(n), out),
        |i| motor(i) * other(i),
    );
    assert_agrees(
        Motor::IDENTITY,
        |n, out| list(n, |i| off_unit(motor::<T>(i))).renormalize_into(out),
        |n, out| Motor::renormalize_slice(&vec(n, |i| off_unit(motor(i))), out),
        |i| off_unit(motor(i)).renormalize(),
    );
    assert_agrees(
        Point::ORIGIN,
        |n, out| list(n, motor::<T>).transform_points_into(&list(n, point), out),
        |n, out| Motor::transform_points_slice(&a(n), &vec(n, point), out),
        |i| motor(i).transform_point(point(i)),
    );
}

fn off_unit<T: Real>(motor: Motor<T>) -> Motor<T> {
    Motor::from((EvenMultivector::from(motor) * T::from_ratio(9, 8)).to_array())
}

fn vec<E>(len: usize, item: impl Fn(usize) -> E) -> Vec<E> {
    (0..len).map(item).collect()
}

fn one_motion_agrees_with_single_ones<T: Real + core::fmt::Debug>() {
    let by = motor::<T>(3);
    let direction = |i: usize| point::<T>(i) - Point::ORIGIN;
    let plane = |i: usize| point::<T>(i).dual();
    assert_agrees(
        Point::ORIGIN,
        |n, out| by.transform_point_blocks(&list(n, point), out),
        |n, out| by.transform_points(&vec(n, point), out),
        |i| by.transform_point(point(i)),
    );
    with_each(|| {
        let mut points = vec(33, point);
        by.transform_points_in_place(&mut points);
        points.iter().enumerate().for_each(|(i, found)| assert_near(found, &by.transform_point(point(i)), size(i)));
    });
    assert_agrees(
        Direction::ZERO,
        |n, out| by.transform_direction_blocks(&list(n, direction), out),
        |n, out| by.transform_directions(&vec(n, direction), out),
        |i| by.transform_direction(direction(i)),
    );
    assert_agrees(
        Line::ZERO,
        |n, out| by.transform_line_blocks(&list(n, line), out),
        |n, out| by.transform_lines(&vec(n, line), out),
        |i| by.transform_line(line(i)),
    );
    assert_agrees(
        Plane::ZERO,
        |n, out| by.transform_plane_blocks(&list(n, plane), out),
        |n, out| by.transform_planes(&vec(n, plane), out),
        |i| by.transform_plane(plane(i)),
    );
}

fn in_place_is_as_beside<T: Real + core::fmt::Debug>() {
    let by = motor::<T>(3);
    fn check<E: Lanewise + PartialEq + core::fmt::Debug>(
        items: &Blocks<E>,
        beside: impl Fn(&Blocks<E>, &mut Blocks<E>) -> Result<(), LengthMismatch>,
        in_place: impl Fn(&mut Blocks<E>),
    ) {
        with_each(|| {
            let (mut moved, mut replaced) = (items.clone(), items.clone());
            beside(items, &mut moved).unwrap();
            in_place(&mut replaced);
            assert_eq!(replaced, moved);
        });
    }
    for len in LENGTHS {
        let (points, lines) = (list(len, point::<T>), list(len, line::<T>));
        let (directions, planes) = (list(len, |i| point::<T>(i) - Point::ORIGIN), list(len, |i| point::<T>(i).dual()));
        check(&points, |a, b| by.transform_point_blocks(a, b), |a| by.transform_point_blocks_in_place(a));
        check(&lines, |a, b| by.transform_line_blocks(a, b), |a| by.transform_line_blocks_in_place(a));
        check(&directions, |a, b| by.transform_direction_blocks(a, b), |a| by.transform_direction_blocks_in_place(a));
        check(&planes, |a, b| by.transform_plane_blocks(a, b), |a| by.transform_plane_blocks_in_place(a));
    }
}

fn exp_and_log_agree_with_single_ones<T: Real + core::fmt::Debug>() {
    assert_agrees(
        Motor::IDENTITY,
        |n, out| list(n, line::<T>).exp_into(out),
        |n, out| Line::exp_slice(&vec(n, line), out),
        |i| line(i).exp(),
    );
    assert_agrees(
        Line::ZERO,
        |n, out| list(n, motor::<T>).log_into(out),
        |n, out| Motor::log_slice(&vec(n, motor), out),
        |i| motor(i).log(),
    );
}

fn interpolations_agree_with_single_ones<T: Real + core::fmt::Debug>() {
    let other = |i: usize| motor::<T>(2 * i + 5);
    let (a, b) = (|n| vec(n, motor::<T>), |n| vec(n, other));
    for percent in [0, 1, 30, 50, 51, 99, 100, 150, -20] {
        let t = T::from_ratio(percent, 100);
        assert_agrees(
            Motor::IDENTITY,
            |n, out| list(n, motor::<T>).nlerp_into(&list(n, other), t, out),
            |n, out| Motor::nlerp_slice(&a(n), &b(n), t, out),
            |i| motor(i).nlerp(other(i), t),
        );
        assert_agrees(
            Motor::IDENTITY,
            |n, out| list(n, motor::<T>).slerp_into(&list(n, other), t, out),
            |n, out| Motor::slerp_slice(&a(n), &b(n), t, out),
            |i| motor(i).slerp(other(i), t),
        );
        assert_agrees(
            Motor::IDENTITY,
            |n, out| list(n, motor::<T>).screw_lerp_into(&list(n, other), t, out),
            |n, out| Motor::screw_lerp_slice(&a(n), &b(n), t, out),
            |i| motor(i).screw_lerp(other(i), t),
        );
        assert_agrees(
            Motor::IDENTITY,
            |n, out| list(n, motor::<T>).split_lerp_into(&list(n, other), t, out),
            |n, out| Motor::split_lerp_slice(&a(n), &b(n), t, out),
            |i| motor(i).split_lerp(other(i), t),
        );
    }
}

/// Pairs half a turn apart, exactly or but for a rounding, of which fused products would tell the short way otherwise.
fn half_turns<T: Real>() -> Vec<(Motor<T>, Motor<T>)> {
    let rotor = |s: f64, e23: f64| Motor::from(Rotor::new(T::from_f64(s), T::from_f64(e23), T::ZERO, T::ZERO));
    let place = |motor, x| Translator::from_vector(Direction::new(T::from_f64(x), T::ONE, T::ZERO)) * motor;
    let mut pairs = Vec::new();
    for (s, e23) in [(0.6, 0.8), (0.28, 0.96), (0.936, 0.352), (1.0, 0.0)] {
        pairs.push((place(rotor(s, e23), 2.0), place(rotor(e23, -s), 3.0)));
        pairs.push((place(rotor(s, e23), 2.0), place(rotor(-e23, s), 3.0)));
    }
    for i in 0..40 {
        let half = T::PI + T::from_f64(f64::from(i - 20)) * T::EPSILON;
        let a = motor::<T>(i as usize);
        pairs.push((a, a * Rotor::about_y(half)));
    }
    pairs
}

fn half_turns_go_the_way_of_single_motors<T: Real + core::fmt::Debug>() {
    let (a, b): (Vec<_>, Vec<_>) = half_turns::<T>().into_iter().unzip();
    type Lists<T> = fn(&Blocks<Motor<T>>, &Blocks<Motor<T>>, T, &mut Blocks<Motor<T>>) -> Result<(), LengthMismatch>;
    type Single<T> = fn(Motor<T>, Motor<T>, T) -> Motor<T>;
    let ways: [(Lists<T>, Single<T>); 4] = [
        (Blocks::nlerp_into, Motor::nlerp),
        (Blocks::slerp_into, Motor::slerp),
        (Blocks::screw_lerp_into, Motor::screw_lerp),
        (Blocks::split_lerp_into, Motor::split_lerp),
    ];
    for (lists, single) in ways {
        for t in [0, 30, 50, 80, 100].map(|percent| T::from_ratio(percent, 100)) {
            with_each(|| {
                let mut found = Blocks::filled(Motor::IDENTITY, a.len());
                lists(&a[..].into(), &b[..].into(), t, &mut found).unwrap();
                for (i, found) in found.iter().enumerate() {
                    // The parts of a motor half a turn from another are as ill-conditioned as the angle: one more of its roundings.
                    assert_near(&found, &single(a[i], b[i], t), T::from_ratio(2, 1) * size(i));
                }
            });
        }
    }
}

/// A joint that does not move must not tremble.
fn equal_ends_stay_put<T: Real + core::fmt::Debug>() {
    let far =
        |i: usize| Translator::from_vector(Direction::new(T::from_f64(1e4 / 3.0), T::ONE, T::ZERO)) * motor::<T>(i);
    let ends = list(40, far);
    let mut whole = Blocks::filled(Motor::IDENTITY, 40);
    ends.nlerp_into(&ends, T::ZERO, &mut whole).unwrap();
    for t in [1, 30, 51, 99].map(|percent| T::from_ratio(percent, 100)) {
        let mut found = Blocks::filled(Motor::IDENTITY, 40);
        ends.nlerp_into(&ends, t, &mut found).unwrap();
        assert_eq!(found, whole);
        ends.screw_lerp_into(&ends, t, &mut found).unwrap();
        for (found, end) in found.iter().zip(&ends) {
            assert!((found - end).norm() <= T::from_ratio(4, 1) * T::EPSILON);
        }
    }
}

/// What AVX2 and AVX-512 compute alike: both fuse, and neither rounds otherwise.
#[test]
fn wide_registers_change_nothing() {
    let run = |set| {
        with_instruction_set(set, || {
            let (a, b) = (list(100, motor::<f32>), list(100, |i| motor(2 * i + 5)));
            let mut out = [0; 6].map(|_| Blocks::filled(Motor::IDENTITY, 100));
            a.mul_into(&b, &mut out[0]).unwrap();
            a.nlerp_into(&b, 0.3, &mut out[1]).unwrap();
            a.slerp_into(&b, 0.3, &mut out[2]).unwrap();
            a.screw_lerp_into(&b, 0.3, &mut out[3]).unwrap();
            a.split_lerp_into(&b, 0.3, &mut out[4]).unwrap();
            list(100, |i| line::<f32>(i) * if i % 7 == 0 { 1e3 } else { 1.0 }).exp_into(&mut out[5]).unwrap();
            out
        })
    };
    if let (Some(narrow), Some(wide)) = (run(InstructionSet::Avx2), run(InstructionSet::Avx512)) {
        assert_eq!(narrow, wide);
    }
}

crate::precision::in_both_precisions! {
    products_agree: products_agree_with_single_ones;
    one_motion_agrees: one_motion_agrees_with_single_ones;
    in_place_agrees: in_place_is_as_beside;
    exp_and_log_agree: exp_and_log_agree_with_single_ones;
    half_turns_agree: half_turns_go_the_way_of_single_motors;
    nothing_trembles: equal_ends_stay_put;
    interpolations_agree: interpolations_agree_with_single_ones;
}

#[test]
fn lists_of_other_lengths_are_refused() {
    let (long, short) = (list(17, motor::<f32>), list(16, motor::<f32>));
    let mut out = short.clone();
    assert_eq!(long.mul_into(&short, &mut out), Err(LengthMismatch { items: 17, results: 16 }));
    assert_eq!(short.mul_into(&long, &mut out), Err(LengthMismatch { items: 16, results: 17 }));
    assert_eq!(short.screw_lerp_into(&long, 0.5, &mut out), Err(LengthMismatch { items: 16, results: 17 }));
    assert_eq!(out, short);
    let (long, short) = (vec(17, motor::<f32>), vec(16, motor::<f32>));
    let mut out = short.clone();
    assert_eq!(Motor::mul_slice(&long, &short, &mut out), Err(LengthMismatch { items: 17, results: 16 }));
    assert_eq!(Motor::slerp_slice(&short, &long, 0.5, &mut out), Err(LengthMismatch { items: 16, results: 17 }));
    assert_eq!(out, short);
}

#[test]
fn lanes_outside_a_polynomials_range_take_the_accurate_way() {
    let wild = |i: usize| match i % 5 {
        0 => line::<f32>(i) * 1e3,
        1 => Line::ZERO,
        2 => line::<f32>(i) * 1e30,
        3 => Line::new(0.0, 0.0, 0.0, 1.0, i as f32, 0.0),
        _ => line::<f32>(i),
    };
    with_each(|| {
        let mut found = Blocks::filled(Motor::IDENTITY, 50);
        list(50, wild).exp_into(&mut found).unwrap();
        for (i, found) in found.iter().enumerate() {
            let mut expected = [Motor::IDENTITY];
            Line::exp_slice(&[wild(i)], &mut expected).unwrap();
            let size = 1.0 + wild(i).norm() + wild(i).ideal_norm();
            assert_near(&found, &expected[0], size);
        }
    });
    // NaN stays in its lane.
    let mut lines = list(20, line::<f32>);
    lines.replace(7, Line::new(f32::NAN, 0.0, 0.0, 0.0, 0.0, 0.0));
    let mut found = Blocks::filled(Motor::IDENTITY, 20);
    lines.exp_into(&mut found).unwrap();
    assert!(found.iter().enumerate().all(|(i, motor)| motor.is_finite() == (i != 7)));
}

#[test]
fn motors_whose_scalar_parts_are_too_large_are_joined_by_the_accurate_way() {
    let off = |i: usize| if i == 3 { Motor { s: 1.5, ..motor::<f64>(i) } } else { motor(i) };
    let broken = |i: usize| if i == 9 { Motor { e02: f64::NAN, ..motor(2 * i) } } else { motor(2 * i) };
    let mut found = Blocks::filled(Motor::IDENTITY, 20);
    list(20, off).screw_lerp_into(&list(20, broken), 0.3, &mut found).unwrap();
    assert_eq!(found.get(3), Some(off(3).screw_lerp(broken(3), 0.3)));
    assert!(found.iter().enumerate().all(|(i, motor)| motor.is_finite() == (i != 9)));
}

#[test]
fn what_was_replaced_is_in_no_lane_any_more() {
    let broken = Line::new(f32::NAN, 0.0, 0.0, 0.0, 0.0, 0.0);
    let mut lines: Blocks<_> = [broken].into_iter().collect();
    lines.replace(0, Line::ZERO);
    assert!((0..LANES).all(|lane| lines.blocks[0].get(lane) == Line::ZERO));
}

#[test]
fn a_list_grows_and_is_read_like_a_vec() {
    let mut blocks = Blocks::new();
    let mut expected = Vec::new();
    for i in 0..50 {
        assert_eq!((blocks.len(), blocks.is_empty(), blocks.get(i)), (i, i == 0, None));
        blocks.push(point::<f64>(i));
        expected.push(point::<f64>(i));
        assert_eq!(Vec::from(&blocks), expected);
    }
    assert_eq!(blocks.replace(20, Point::ORIGIN), Some(expected[20]));
    expected[20] = Point::ORIGIN;
    assert_eq!(blocks.replace(50, Point::ORIGIN), None);
    assert_eq!(blocks, Blocks::from(&expected[..]));
    assert_ne!(blocks, Blocks::from(&expected[..49]));
    assert_eq!(blocks.iter().len(), 50);
    assert_eq!(blocks.iter().nth(33), blocks.get(33));
    blocks.extend(vec![Point::ORIGIN; 3]);
    assert_eq!((blocks.len(), blocks.get(52), blocks.get(53)), (53, Some(Point::ORIGIN), None));
    blocks.clear();
    assert!(blocks.is_empty() && blocks.iter().next().is_none());
    assert_eq!(Blocks::<Point<f64>>::default(), blocks);
}

#[test]
fn a_machine_that_has_a_wide_set_has_the_narrower_ones() {
    let available = InstructionSet::ALL.map(InstructionSet::is_available);
    assert!(available.is_sorted_by(|wide, wider| wide >= wider), "{available:?}");
    let widest = InstructionSet::ALL.into_iter().rev().find(|set| set.is_available());
    assert_eq!(Some(InstructionSet::in_use()), widest);
    with_instruction_set(InstructionSet::Portable, || {
        assert_eq!(InstructionSet::in_use(), InstructionSet::Portable);
    });
    assert_eq!(Some(InstructionSet::in_use()), widest);
}
