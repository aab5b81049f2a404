use alloc::string::ToString;
use alloc::vec::Vec;

use super::*;
use crate::{Rotor, Translator};

type M = Motor<f64>;

const TWIST: f64 = 179.0 * core::f64::consts::PI / 180.0;

/// The skin of a forearm along x, of radius 1: rings at tenths of the way from one joint to the other, which is twisted.
struct Forearm {
    points: Vec<Point<f64>>,
    joints: Vec<[u16; 2]>,
    weights: Vec<[f64; 2]>,
}

fn forearm() -> Forearm {
    let (mut points, mut joints, mut weights) = (Vec::new(), Vec::new(), Vec::new());
    for ring in 0..=10 {
        for spoke in 0..8 {
            let angle = core::f64::consts::TAU * f64::from(spoke) / 8.0;
            let part = f64::from(ring) / 10.0;
            points.push(Point::new(part, angle.cos(), angle.sin()));
            joints.push([0, 1]);
            weights.push([1.0 - part, part]);
        }
    }
    Forearm { points, joints, weights }
}

fn radius(point: Point<f64>) -> f64 {
    point.y.hypot(point.z)
}

#[test]
fn a_twist_of_179_degrees_thins_linear_skin_and_leaves_motors_their_radius() {
    let motors = [M::IDENTITY, Rotor::about_x(TWIST).into()];
    let Forearm { points, joints, weights } = forearm();
    let influences = Influences { joints: &joints, weights: &weights };
    let mut linear = points.clone();
    skin_points_linear(&motors, influences, &points, &mut linear).unwrap();
    let mut dual = points.clone();
    skin_points(&motors, influences, &points, &mut dual).unwrap();
    // Half-way, a point and the same turned by the twist have the mean at the cosine of half the twist: 0.0087.
    let half_way = 5 * 8..6 * 8;
    for vertex in half_way {
        assert!((radius(linear[vertex]) - (TWIST / 2.0).cos()).abs() < 1e-15);
        // And motors turn it by half the twist.
        let expected = M::from(Rotor::about_x(TWIST / 2.0)).transform_point(points[vertex]);
        assert!(dual[vertex].distance_to_point(expected) < 1e-14);
    }
    for (dual, bound) in dual.iter().zip(&points) {
        assert!((radius(*dual) - 1.0).abs() < 1e-14 && (dual.x - bound.x).abs() < 1e-14);
    }
}

#[test]
fn one_joint_moves_rigidly_either_way() {
    let motor = Translator::from_vector(Direction::new(3.0, -1.0, 2.0)) * Rotor::about_y(0.8);
    let (point, normal) = (Point::new(0.5, 1.0, -2.0), Direction::new(0.0, 3.0, 4.0));
    let influences = Influences { joints: &[[1, 7]], weights: &[[0.3, 0.0]] };
    let motors = [M { s: f64::NAN, ..M::IDENTITY }, motor];
    let mut points = [Point::ORIGIN; 2];
    skin_points(&motors, influences, &[point], &mut points[..1]).unwrap();
    skin_points_linear(&motors, influences, &[point], &mut points[1..]).unwrap();
    let mut normals = [Direction::ZERO; 2];
    skin_normals(&motors, influences, &[normal], &mut normals[..1]).unwrap();
    skin_normals_linear(&motors, influences, &[normal], &mut normals[1..]).unwrap();
    for (point_found, normal_found) in points.into_iter().zip(normals) {
        assert!(point_found.distance_to_point(motor.transform_point(point)) < 1e-14);
        assert!((normal_found - motor.transform_direction(normal)).norm() < 1e-14);
    }
}

#[test]
fn weights_count_by_their_proportions_and_signs_of_motors_do_not() {
    let (a, b) = (M::from(Rotor::about_x(0.2)), M::from(Rotor::about_x(2.2)));
    let (joints, point) = ([[0, 1]; 2], Point::new(0.0, 1.0, 0.0));
    let weights = [[0.25, 0.25], [3.0, 3.0]];
    let mut out = [Point::ORIGIN; 2];
    for motors in [[a, b], [a, -b], [-a, b]] {
        skin_points(&motors, Influences { joints: &joints, weights: &weights }, &[point; 2], &mut out).unwrap();
        for found in out {
            assert!(found.distance_to_point(M::from(Rotor::about_x(1.2)).transform_point(point)) < 1e-15);
        }
    }
}

#[test]
fn a_vertex_without_weights_stays_where_it_was_bound() {
    let motors = [M::from(Rotor::about_x(1.0))];
    let influences = Influences { joints: &[[0, 9, 0, 0]], weights: &[[0.0; 4]] };
    let (point, normal) = (Point::new(1.0, 2.0, 3.0), Direction::Y);
    let (mut points, mut normals) = ([Point::ORIGIN], [Direction::ZERO]);
    skin_points(&motors, influences, &[point], &mut points).unwrap();
    skin_normals(&motors, influences, &[normal], &mut normals).unwrap();
    assert_eq!((points, normals), ([point], [normal]));
    let (mut points, mut normals) = ([Point::ORIGIN], [Direction::ZERO]);
    skin_points_linear(&motors, influences, &[point], &mut points).unwrap();
    skin_normals_linear(&motors, influences, &[normal], &mut normals).unwrap();
    assert_eq!((points, normals), ([point], [normal]));
}

#[test]
fn a_linear_normal_that_cancels_is_zero() {
    let half_turn = Rotor { s: 0.0, e23: -1.0, e31: 0.0, e12: 0.0 };
    let influences = Influences { joints: &[[0, 1]], weights: &[[1.0, 1.0]] };
    let mut out = [Direction::X];
    skin_normals_linear(&[M::IDENTITY, half_turn.into()], influences, &[Direction::Y], &mut out).unwrap();
    assert_eq!(out, [Direction::ZERO]);
    // Others keep their length.
    skin_normals_linear(&[M::IDENTITY, Rotor::about_x(1.0).into()], influences, &[Direction::Y * 3.0], &mut out)
        .unwrap();
    assert!((out[0].norm() - 3.0).abs() < 1e-14);
}

#[test]
fn faults_are_named_and_leave_the_result_alone() {
    let motors = [M::IDENTITY, M { e01: f64::NAN, ..M::IDENTITY }];
    let untouched = [Point::new(7.0, 7.0, 7.0); 2];
    let error = |joints: [[u16; 2]; 2], weights: [[f64; 2]; 2]| {
        let mut out = untouched;
        let error =
            skin_points(&motors, Influences { joints: &joints, weights: &weights }, &[Point::ORIGIN; 2], &mut out)
                .unwrap_err();
        assert_eq!(out, untouched);
        error.to_string()
    };
    let good = [0.5, 0.5];
    let message = "vertex 1: expected joints below 2, the number of motors, found 2";
    assert_eq!(error([[0, 0], [0, 2]], [good; 2]), message);
    let message = "vertex 1: expected finite weights from 0 up, found another";
    for weights in [[-0.1, 1.0], [f64::NAN, 0.0], [0.0, f64::INFINITY], [f64::MAX, f64::MAX]] {
        assert_eq!(error([[0, 0]; 2], [good, weights]), message);
    }
    let message = "vertex 0: expected a finite motor of joint 1, found a NaN or an infinity";
    assert_eq!(error([[0, 1]; 2], [good; 2]), message);
    let influences = Influences { joints: &[[0, 0]; 2], weights: &[good; 2] };
    let mut out = untouched;
    let error = skin_points_linear(&motors, influences, &[Point::ORIGIN; 3], &mut out).unwrap_err();
    assert_eq!(error.to_string(), "expected 2 entries in `bound`, one for each vertex, found 3");
    let error = skin_points_linear(&motors, influences, &[Point::ORIGIN; 2], &mut out[..1]).unwrap_err();
    assert_eq!(error.to_string(), "expected 2 entries in `out`, one for each vertex, found 1");
    let short = Influences { joints: &[[0, 0]; 2], weights: &[good; 1] };
    let error = skin_points(&motors, short, &[Point::ORIGIN; 2], &mut out).unwrap_err();
    assert_eq!(error.to_string(), "expected 2 entries in `weights`, one for each vertex, found 1");
    assert_eq!(out, untouched);
}
