//! Composition and points: our motors beside glam's transforms, in one run, on inputs that the optimiser cannot see
//! through. Contenders are compared before they are timed.

use criterion::{BenchmarkId, Criterion, criterion_group, criterion_main};
use glam::{Affine3A, Mat4, Quat, Vec3};
use pga_motor::f32::{Direction, Rotor, Translator};
use pga_motor::f32::{Motor, Point};
use std::hint::black_box;

const COUNT: usize = 1024;

/// A motion that differs with the index, by Euler angles and a translation.
fn motor(index: usize) -> Motor {
    let angle = index as f32 * 0.37;
    let rotor = Rotor::about_z(angle) * Rotor::about_y(0.5 * angle) * Rotor::about_x(0.25 * angle);
    Motor::from_rotor_translator(rotor, Translator::from_vector(Direction::new(angle.sin(), angle.cos(), 1.0)))
}

fn affine(motor: Motor) -> Affine3A {
    let (rotation, translation): (Quat, Vec3) = motor.into();
    Affine3A::from_rotation_translation(rotation, translation)
}

fn points() -> Vec<Point> {
    (0..COUNT).map(|i| Point::new((i as f32).sin(), (i as f32).cos(), i as f32 / COUNT as f32)).collect()
}

/// Rounding of a few operations on numbers of size 4: each commits at most 2^-24 of that, and there are under 100.
const TOLERANCE: f32 = 4.0 * 100.0 / 16_777_216.0;

fn check(motor: Motor, affine: Affine3A, point: Point) {
    let ours = motor.transform_point(point);
    let theirs = affine.transform_point3(Vec3::new(point.x, point.y, point.z));
    assert!((Vec3::new(ours.x, ours.y, ours.z) - theirs).length() < TOLERANCE, "contenders disagree");
}

fn compose(criterion: &mut Criterion) {
    let motors: Vec<_> = (0..COUNT).map(motor).collect();
    let affines: Vec<_> = motors.iter().copied().map(affine).collect();
    let matrices: Vec<_> = affines.iter().copied().map(Mat4::from).collect();
    for i in 1..COUNT {
        check(motors[i - 1] * motors[i], affines[i - 1] * affines[i], Point::new(1.0, 2.0, -1.0));
    }
    let mut group = criterion.benchmark_group("compose 1024 pairs");
    group.bench_function(BenchmarkId::from_parameter("Motor"), |bencher| {
        let mut out = motors.clone();
        bencher.iter(|| {
            for ((out, a), b) in out.iter_mut().zip(black_box(&motors)).zip(black_box(&motors).iter().rev()) {
                *out = *a * *b;
            }
            black_box(&mut out);
        });
    });
    group.bench_function(BenchmarkId::from_parameter("glam Affine3A"), |bencher| {
        let mut out = affines.clone();
        bencher.iter(|| {
            for ((out, a), b) in out.iter_mut().zip(black_box(&affines)).zip(black_box(&affines).iter().rev()) {
                *out = *a * *b;
            }
            black_box(&mut out);
        });
    });
    group.bench_function(BenchmarkId::from_parameter("glam Mat4"), |bencher| {
        let mut out = matrices.clone();
        bencher.iter(|| {
            for ((out, a), b) in out.iter_mut().zip(black_box(&matrices)).zip(black_box(&matrices).iter().rev()) {
                *out = *a * *b;
            }
            black_box(&mut out);
        });
    });
    group.finish();
}

fn transform(criterion: &mut Criterion) {
    let (motor, points) = (motor(3), points());
    let matrix = Mat4::from(affine(motor));
    let vectors: Vec<_> = points.iter().map(|p| Vec3::new(p.x, p.y, p.z)).collect();
    points.iter().for_each(|&point| check(motor, affine(motor), point));
    let mut group = criterion.benchmark_group("one motion, 1024 points");
    group.bench_function(BenchmarkId::from_parameter("Motor"), |bencher| {
        let mut out = points.clone();
        bencher.iter(|| {
            black_box(motor).transform_points(black_box(&points), &mut out).expect("slices of one length");
            black_box(&mut out);
        });
    });
    group.bench_function(BenchmarkId::from_parameter("glam Mat4"), |bencher| {
        let mut out = vectors.clone();
        bencher.iter(|| {
            let matrix = black_box(matrix);
            for (out, point) in out.iter_mut().zip(black_box(&vectors)) {
                *out = matrix.transform_point3(*point);
            }
            black_box(&mut out);
        });
    });
    group.finish();
}

criterion_group!(benches, compose, transform);
criterion_main!(benches);
