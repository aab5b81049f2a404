//! Every function on every length and instruction set, against the same on single items.

use alloc::vec;
use alloc::vec::Vec;

use super::*;
use crate::{Direction, LengthMismatch, Line, Motor, Plane, Point, Real, Rotor, Translator, kernels};

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

/// Compares a function of lists with that of single items, bit for bit, for each length and instruction set.
fn assert_same<R>(
    empty: R,
    run: impl Fn(usize, &mut Blocks<R>) -> Result<(), LengthMismatch>,
    expected: impl Fn(usize) -> R,
) where
    R: Lanewise + PartialEq + core::fmt::Debug,
{
    for len in LENGTHS {
        with_each(|| {
            let mut results = Blocks::filled(empty, len);
            run(len, &mut results).unwrap();
            assert_eq!(results, list(len, &expected), "{len} with {:?}", InstructionSet::in_use());
        });
        let mut results = Blocks::filled(empty, len + 1);
        let before = results.clone();
        assert_eq!(run(len, &mut results), Err(LengthMismatch { items: len, results: len + 1 }));
        assert_eq!(results, before);
    }
}

fn agrees_with_single_items<T: Real + core::fmt::Debug>() {
    let other = |i: usize| motor::<T>(2 * i + 5);
    let (t, one) = (T::from_ratio(3, 10), Motor::<T>::IDENTITY);
    // The operator adds up in another order for some numbers.
    let product = |i: usize| kernels::motor_mul_motor(motor(i), other(i));
    assert_same(one, |n, out| list(n, motor::<T>).mul_into(&list(n, other), out), product);
    assert_same(one, |n, out| list(n, motor::<T>).nlerp_into(&list(n, other), t, out), |i| motor(i).nlerp(other(i), t));
    let beyond = T::from_ratio(3, 2);
    assert_same(
        one,
        |n, out| list(n, motor::<T>).nlerp_into(&list(n, other), beyond, out),
        |i| motor(i).nlerp(other(i), beyond),
    );
    assert_same(
        Point::ORIGIN,
        |n, out| list(n, motor::<T>).transform_points_into(&list(n, point), out),
        |i| motor(i).transform_point(point(i)),
    );
    let slice = |i: usize| {
        let mut found = [Point::ORIGIN];
        motor::<T>(3).transform_points(&[point(i)], &mut found).unwrap();
        found[0]
    };
    assert_same(Point::ORIGIN, |n, out| motor::<T>(3).transform_point_blocks(&list(n, point), out), slice);
    let direction = |i: usize| point::<T>(i) - Point::ORIGIN;
    let slice = |i: usize| {
        let mut found = [Direction::ZERO];
        motor::<T>(3).transform_directions(&[direction(i)], &mut found).unwrap();
        found[0]
    };
    assert_same(Direction::ZERO, |n, out| motor(3).transform_direction_blocks(&list(n, direction), out), slice);
    let slice = |i: usize| {
        let mut found = [Line::ZERO];
        motor::<T>(3).transform_lines(&[line(i)], &mut found).unwrap();
        found[0]
    };
    assert_same(Line::ZERO, |n, out| motor(3).transform_line_blocks(&list(n, line::<T>), out), slice);
    let plane = |i: usize| point::<T>(i).dual();
    let slice = |i: usize| {
        let mut found = [Plane::ZERO];
        motor::<T>(3).transform_planes(&[plane(i)], &mut found).unwrap();
        found[0]
    };
    assert_same(Plane::ZERO, |n, out| motor(3).transform_plane_blocks(&list(n, plane), out), slice);
    let slice = |i: usize| {
        let mut found = [one];
        Line::exp_slice(&[line(i)], &mut found).unwrap();
        found[0]
    };
    assert_same(one, |n, out| list(n, line::<T>).exp_into(out), slice);
    let slice = |i: usize| {
        let mut found = [Line::ZERO];
        Motor::log_slice(&[motor::<T>(i)], &mut found).unwrap();
        found[0]
    };
    assert_same(Line::ZERO, |n, out| list(n, motor::<T>).log_into(out), slice);
}

#[test]
fn lists_agree_with_single_items_on_every_length_and_instruction_set() {
    agrees_with_single_items::<f32>();
    agrees_with_single_items::<f64>();
}

#[test]
fn slices_are_moved_alike_with_every_instruction_set() {
    for len in LENGTHS {
        let points: Vec<Point<f32>> = (0..len).map(point).collect();
        let expected: Vec<_> = {
            let matrix = motor::<f32>(3).to_matrix();
            points.iter().map(|&point| matrix.transform_point(point)).collect()
        };
        with_each(|| {
            let mut found = vec![Point::ORIGIN; len];
            motor::<f32>(3).transform_points(&points, &mut found).unwrap();
            assert_eq!(found, expected);
            let mut found = points.clone();
            motor::<f32>(3).transform_points_in_place(&mut found);
            assert_eq!(found, expected);
        });
    }
}

/// Polynomials stay within 1.45 attainable errors of the functions; a logarithm, a multiple, an exponential and two products of motors
/// with translations up to 40 make some twenty roundings of numbers of that size.
fn screws_agree_with_single_ones<T: Real>() {
    let other = |i: usize| motor::<T>(2 * i + 5);
    for percent in [0, 1, 30, 50, 51, 99, 100, 150, -20] {
        let t = T::from_ratio(percent, 100);
        for len in LENGTHS {
            with_each(|| {
                let mut found = Blocks::filled(Motor::IDENTITY, len);
                list(len, motor::<T>).screw_lerp_into(&list(len, other), t, &mut found).unwrap();
                for (i, found) in found.iter().enumerate() {
                    let expected = motor::<T>(i).screw_lerp(other(i), t);
                    let expected = if (found + expected).norm() < T::ONE { -expected } else { expected };
                    let difference = found - expected;
                    let size =
                        T::ONE + motor::<T>(i).translator().vector().norm() + other(i).translator().vector().norm();
                    assert!(difference.norm() <= T::from_ratio(20, 1) * T::EPSILON, "{percent} of {i}");
                    assert!(difference.ideal_norm() <= T::from_ratio(20, 1) * T::EPSILON * size, "{percent} of {i}");
                }
            });
        }
    }
}

#[test]
fn screws_agree_with_single_ones_up_to_the_last_digits() {
    screws_agree_with_single_ones::<f32>();
    screws_agree_with_single_ones::<f64>();
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
            assert_eq!(found, expected[0]);
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
fn motors_off_unit_are_joined_by_the_accurate_way() {
    let off = |i: usize| if i == 3 { Motor { s: 1.5, ..motor::<f64>(i) } } else { motor(i) };
    let broken = |i: usize| if i == 9 { Motor { e02: f64::NAN, ..motor(2 * i) } } else { motor(2 * i) };
    let mut found = Blocks::filled(Motor::IDENTITY, 20);
    list(20, off).screw_lerp_into(&list(20, broken), 0.3, &mut found).unwrap();
    assert_eq!(found.get(3), Some(off(3).screw_lerp(broken(3), 0.3)));
    assert!(found.iter().enumerate().all(|(i, motor)| motor.is_finite() == (i != 9)));
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
