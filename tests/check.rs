//! What others compute is checked against definitions: glam's affine maps, and the kernels of `pga-motor` as any user's code.

use ga_codegen::check::strategies::pga2d::{self as reference_pga2d, PGA2D};
use ga_codegen::check::strategies::{self as reference, PGA3D, motors as reference_motors, points as reference_points};
use ga_codegen::check::{Check, Coefficient, Fraction, Tolerance};
use ga_codegen::reference::Multivector;
use glam::{Affine3A, DAffine3, DVec3, Vec3};
use pga_motor::strategies::{self, motors, points};
use pga_motor::{EvenMultivector, Line, Motor, Point, Real, Rotor, Scalar, pga2d};
use proptest::prelude::*;
use std::fmt::Debug;
use std::ops::{Add, Mul, Neg, Sub};

type Blades<T, const N: usize> = [(&'static str, T); N];

fn multivector<T: Coefficient, const N: usize>(blades: Blades<T, N>) -> Multivector<T> {
    Multivector::from_blades(PGA3D, blades).expect("words of 3D PGA")
}

const EVEN: [&str; 8] = ["1", "e23", "e31", "e12", "e01", "e02", "e03", "e0123"];

fn of_motor<T: Coefficient + Real>(m: Motor<T>) -> Multivector<T> {
    of_even(m.into())
}

fn of_even<T: Coefficient + Real>(m: EvenMultivector<T>) -> Multivector<T> {
    let values = [m.s, m.e23, m.e31, m.e12, m.e01, m.e02, m.e03, m.e0123];
    Multivector::from_blades(PGA3D, EVEN.into_iter().zip(values)).expect("words of 3D PGA")
}

fn of_line<T: Coefficient + Real>(l: Line<T>) -> Multivector<T> {
    let values = [l.e23, l.e31, l.e12, l.e01, l.e02, l.e03];
    Multivector::from_blades(PGA3D, EVEN[1..7].iter().zip(values)).expect("words of 3D PGA")
}

fn line<T: Coefficient + Real>(l: &Multivector<T>) -> Line<T> {
    let [a, b, c] = ["e23", "e31", "e12"].map(|word| l.coefficient(word));
    let [d, e, f] = ["e01", "e02", "e03"].map(|word| l.coefficient(word));
    Line::new(a, b, c, d, e, f)
}

fn of_point<T: Coefficient + Real>(p: Point<T>) -> Multivector<T> {
    multivector([("e032", p.x), ("e013", p.y), ("e021", p.z), ("e123", T::ONE)])
}

fn motor<T: Coefficient + Real>(m: &Multivector<T>) -> Motor<T> {
    let [s, a, b, c] = ["1", "e23", "e31", "e12"].map(|word| m.coefficient(word));
    let [d, e, f, h] = ["e01", "e02", "e03", "e0123"].map(|word| m.coefficient(word));
    Motor::new(s, a, b, c, d, e, f, h)
}

fn coordinates<T: Coefficient>(p: &Multivector<T>) -> [T; 3] {
    ["e032", "e013", "e021"].map(|word| p.coefficient(word))
}

fn point<T: Coefficient + Real>(p: &Multivector<T>) -> Point<T> {
    let [x, y, z] = coordinates(p);
    Point::new(x, y, z)
}

#[test]
fn affine_maps_of_glam_are_sandwiches() {
    let check = Check::new(PGA3D, "m >> p").expect("a definition");
    check.input("m", reference_motors()).input("p", reference_points()).assert(|[m, p]| {
        let moved = DAffine3::from(motor(m)).transform_point3(DVec3::from(coordinates(p)));
        of_point(Point::new(moved.x, moved.y, moved.z))
    });
}

#[test]
fn affine_maps_of_glam_in_single_precision_are_sandwiches() {
    let check = Check::new(PGA3D, "m >> p").expect("a definition");
    check.input("m", motors().prop_map(of_motor)).input("p", points().prop_map(of_point)).assert(|[m, p]| {
        let moved = Affine3A::from(motor::<f32>(m)).transform_point3(Vec3::from(coordinates(p)));
        of_point(Point::new(moved.x, moved.y, moved.z))
    });
}

#[test]
fn a_transposed_matrix_is_found() {
    let check = Check::new(PGA3D, "m >> p").expect("a definition");
    let check = check.input("m", reference_motors()).input("p", reference_points());
    let error = check.run(|[m, p]| {
        let mut affine = DAffine3::from(motor(m));
        affine.matrix3 = affine.matrix3.transpose();
        let moved = affine.transform_point3(DVec3::from(coordinates(p)));
        of_point(Point::new(moved.x, moved.y, moved.z))
    });
    let error = error.expect_err("the opposite rotation");
    assert!(error.to_string().contains("\n    m = 0.6 + 0.8 e"), "{error}");
}

#[test]
fn our_own_kernels_pass_as_anybody_would() {
    let check = Check::new(PGA3D, "m >> p").expect("a definition");
    check
        .input("m", motors().prop_map(of_motor))
        .input("p", points().prop_map(of_point))
        .assert(|[m, p]| of_point(motor::<f64>(m).transform_point(point(p))));
    let check = Check::new(PGA3D, "a * b").expect("a definition").cases(500);
    let pairs = strategies::motor_pairs::<f32>().prop_map(|(a, b)| [a, b].map(of_motor));
    check.inputs(["a", "b"], pairs).tolerance(Tolerance::Derived).assert(|[a, b]| of_motor(motor(a) * motor(b)));
}

/// That a type's promise holds, relative to the size of what must cancel.
fn keeps_its_promise<T: Real + Debug + 'static>() {
    let unit = 32.0 * T::EPSILON.to_f64();
    let scaled = move |size: f64| T::from_f64(unit * (1.0 + size));
    proptest!(|(
        (a, b) in strategies::motor_pairs::<T>(),
        (c, negative) in strategies::antipodal_motors::<T>(),
        rotor in strategies::rotors::<T>(),
        line in strategies::unit_lines::<T>(),
        plane in strategies::unit_planes::<T>(),
        direction in strategies::unit_directions::<T>(),
    )| {
        for motor in [a, b, c] {
            let size = [motor.e01, motor.e02, motor.e03, motor.e0123].map(|each| each.abs().to_f64()).iter().sum();
            prop_assert!(motor.is_unit(scaled(size)), "{motor:?}");
        }
        prop_assert_eq!(negative, -c);
        prop_assert!(rotor.is_unit(scaled(0.0)) && plane.is_unit(scaled(0.0)));
        let moment = [line.e01, line.e02, line.e03].map(|each| each.abs().to_f64()).iter().sum();
        prop_assert!(line.is_unit(scaled(moment)), "{line:?}");
        prop_assert!((direction.norm().to_f64() - 1.0).abs() < unit);
    });
}

#[test]
fn strategies_keep_what_types_promise() {
    keeps_its_promise::<f32>();
    keeps_its_promise::<f64>();
}

#[test]
fn strategies_reach_the_nasty_ones() {
    let half = |rotor: Rotor<f64>| rotor.s.abs() < 0.01;
    proptest!(|(
        still in strategies::motors_near_identity::<f64>(),
        turned in strategies::rotors_near_half_turn::<f64>(),
        far in strategies::motors_with_tiny_turn_and_huge_step::<f64>(),
    )| {
        prop_assert!((still - Motor::IDENTITY).norm() < 0.02 && half(turned));
        prop_assert!(far.e12.abs() < 0.01 && far.e01.abs() > 1e3);
    });
}

/// The motion that a motor and its negative are.
fn short_way<T: Real>(m: Motor<T>) -> Motor<T> {
    if m.s < T::ZERO { -m } else { m }
}

fn exp_and_log_are_what_they_say<T: Coefficient + Real>() {
    let exp =
        Check::<T>::new(PGA3D, "exp(b)").expect("a definition").input("b", strategies::lines::<T>().prop_map(of_line));
    exp.cases(1000).assert(|[b]| of_motor(line(b).exp()));
    let log = || Check::<T>::new(PGA3D, "log(m)").expect("a definition");
    let short = || motors::<T>().prop_map(|m| of_motor(short_way(m)));
    log().input("m", short()).cases(1000).assert(|[m]| of_line(motor(m).log()));
    // The long way round too, but for -1 and the negatives of translators, which have none.
    let long = strategies::rotors::<T>().prop_map(|r| of_motor(-short_way(Motor::from(r))));
    let long = long.prop_filter("a logarithm", |m: &Multivector<T>| m.grade(2).norm_squared().magnitude() > 1e-6);
    let log_double_cover = |m: &Multivector<T>| of_line(motor(m).log_double_cover().expect("no negative translator"));
    log().input("m", long).assert(|[m]| log_double_cover(m));
    let sqrt = Check::<T>::new(PGA3D, "sqrt(m)").expect("a definition").input("m", short()).cases(1000);
    sqrt.assert(|[m]| of_motor(motor(m).sqrt()));
}

#[test]
fn exp_log_and_roots_pass() {
    exp_and_log_are_what_they_say::<f64>();
    exp_and_log_are_what_they_say::<f32>();
}

#[test]
fn normalized_sums_of_motors_pass() {
    let even = |m: &Multivector<f64>| {
        let [s, a, b, c, d, e, f, h] = EVEN.map(|word| m.coefficient(word));
        EvenMultivector::new(s, a, b, c, d, e, f, h)
    };
    let sums = strategies::motor_pairs::<f64>().prop_map(|(a, b)| of_even(a * 2.0 + EvenMultivector::from(b)));
    let check = Check::new(PGA3D, "normalize(y)").expect("a definition").input("y", sums);
    check.assert(|[y]| of_motor(even(y).normalize().expect("a sum that is not 0")));
}

/// Everything that a wrong exp or log would do: a factor, a sign, a missing part, a linear approximation, the other branch.
#[test]
fn wrong_exponentials_and_logarithms_are_found() {
    type Wrong<A, B> = (&'static str, fn(A) -> B);
    let exps: [Wrong<Line<f64>, Motor<f64>>; 5] = [
        ("half", |b| (b * 0.5).exp()),
        ("reverse", |b| b.exp().reverse()),
        ("a part in 1e10", |b| (b * (1.0 + 1e-10)).exp()),
        ("without e0123", |b| Motor { e0123: 0.0, ..b.exp() }),
        ("without the slide", |b| {
            let exp = b.exp();
            let (sin, norm) = (Line::new(exp.e23, exp.e31, exp.e12, 0.0, 0.0, 0.0).norm(), b.norm());
            let sinc = if norm == 0.0 { 1.0 } else { sin / norm };
            Motor { e01: sinc * b.e01, e02: sinc * b.e02, e03: sinc * b.e03, ..exp }
        }),
    ];
    for (name, wrong) in exps {
        let check = Check::new(PGA3D, "exp(b)").expect("a definition").input("b", reference::bivectors());
        let error = check.run(|[b]| of_motor(wrong(line(b)))).expect_err(name);
        assert!(error.counterexample().is_some(), "{name}: {error}");
    }
    let logs: [Wrong<Motor<f64>, Line<f64>>; 4] = [
        ("twice", |m| m.log() * 2.0),
        ("a part in 1e10", |m| m.log() * (1.0 + 1e-10)),
        ("linear", |m| Line::new(m.e23, m.e31, m.e12, m.e01, m.e02, m.e03)),
        ("by the arc cosine", |m| {
            let norm = Line::new(m.e23, m.e31, m.e12, 0.0, 0.0, 0.0).norm();
            let ratio = if norm == 0.0 { 1.0 } else { m.s.clamp(-1.0, 1.0).acos() / norm };
            Line { e23: ratio * m.e23, e31: ratio * m.e31, e12: ratio * m.e12, ..m.log() }
        }),
    ];
    for (name, wrong) in logs {
        let short = motors::<f64>().prop_map(|m| of_motor(short_way(m)));
        let check = Check::new(PGA3D, "log(m)").expect("a definition").input("m", short);
        let error = check.run(|[m]| of_line(wrong(motor(m)))).expect_err(name);
        assert!(error.counterexample().is_some(), "{name}: {error}");
    }
}

fn of_plane_motor<T: Coefficient + Real>(m: pga2d::Motor<T>) -> Multivector<T> {
    let blades = [("1", m.s), ("e12", m.e12), ("e01", m.e01), ("e20", m.e20)];
    Multivector::from_blades(PGA2D, blades).expect("words of 2D PGA")
}

fn plane_motor<T: Coefficient + Real>(m: &Multivector<T>) -> pga2d::Motor<T> {
    let [s, a, b, c] = ["1", "e12", "e01", "e20"].map(|word| m.coefficient(word));
    pga2d::Motor::new(s, a, b, c)
}

fn of_bivector<T: Coefficient + Real>(b: pga2d::Bivector<T>) -> Multivector<T> {
    Multivector::from_blades(PGA2D, [("e12", b.e12), ("e01", b.e01), ("e20", b.e20)]).expect("words of 2D PGA")
}

fn plane_functions_are_what_they_say<T: Coefficient + Real>() {
    let check = |definition| Check::<T>::new(PGA2D, definition).expect("a definition").cases(1000);
    let bivectors = pga2d::strategies::bivectors::<T>().prop_map(of_bivector);
    check("exp(b)").input("b", bivectors).assert(|[b]| {
        let [a, c, d] = ["e12", "e01", "e20"].map(|word| b.coefficient(word));
        of_plane_motor(pga2d::Bivector::new(a, c, d).exp())
    });
    let short = || {
        let motors = pga2d::strategies::motors();
        motors.prop_map(|m: pga2d::Motor<T>| of_plane_motor(if m.s < T::ZERO { -m } else { m }))
    };
    check("log(m)").input("m", short()).assert(|[m]| of_bivector(plane_motor(m).log()));
    check("sqrt(m)").input("m", short()).assert(|[m]| of_plane_motor(plane_motor(m).sqrt()));
    let pairs = pga2d::strategies::motor_pairs::<T>().prop_map(|(a, b)| [a, b].map(of_plane_motor));
    check("a * b").inputs(["a", "b"], pairs).assert(|[a, b]| of_plane_motor(plane_motor(a) * plane_motor(b)));
}

#[test]
fn kernels_of_the_plane_pass() {
    plane_functions_are_what_they_say::<f64>();
    plane_functions_are_what_they_say::<f32>();
}

/// Fractions as the kernels' scalar.
#[derive(Clone, Copy, PartialEq)]
struct Exact(Fraction);

impl Add for Exact {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        Self(self.0 + other.0)
    }
}

impl Sub for Exact {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        Self(self.0 - other.0)
    }
}

impl Mul for Exact {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        Self(self.0 * other.0)
    }
}

impl Neg for Exact {
    type Output = Self;
    fn neg(self) -> Self {
        Self(-self.0)
    }
}

impl Scalar for Exact {
    type Four = pga_motor::scalar::Array4<Self>;
    const ZERO: Self = Self(Fraction::ZERO);
    const ONE: Self = Self(Fraction::ONE);
    fn from_ratio(numerator: i32, denominator: i32) -> Self {
        Self(Fraction::new(numerator.into(), denominator.into()).expect("a denominator other than 0"))
    }
}

#[test]
fn our_own_kernels_are_exact_on_exact_units() {
    let check = Check::<Fraction>::new(PGA3D, "m >> p").expect("a definition");
    check.input("m", reference_motors()).input("p", reference_points()).assert(|[m, p]| {
        let [s, a, b, c, d, e, f, h] = EVEN.map(|word| Exact(m.coefficient(word)));
        let [x, y, z] = coordinates(p).map(Exact);
        let moved = Motor::new(s, a, b, c, d, e, f, h).transform_point(Point::new(x, y, z));
        [("e032", moved.x.0), ("e013", moved.y.0), ("e021", moved.z.0), ("e123", Fraction::ONE)]
    });
    let check = Check::<Fraction>::new(PGA2D, "m >> p").expect("a definition");
    check.input("m", reference_pga2d::motors()).input("p", reference_pga2d::points()).assert(|[m, p]| {
        let [s, a, b, c] = ["1", "e12", "e01", "e20"].map(|word| Exact(m.coefficient(word)));
        let [x, y] = ["e20", "e01"].map(|word| Exact(p.coefficient(word)));
        let moved = pga2d::Motor::new(s, a, b, c).transform_point(pga2d::Point::new(x, y));
        [("e20", moved.x.0), ("e01", moved.y.0), ("e12", Fraction::ONE)]
    });
}

/// That a type of the plane keeps its promise, relative to the size of what must cancel.
fn keeps_its_promise_in_the_plane<T: Real + Debug + 'static>() {
    let unit = T::from_f64(32.0 * T::EPSILON.to_f64());
    proptest!(|(
        (a, b) in pga2d::strategies::motor_pairs::<T>(),
        (c, negative) in pga2d::strategies::antipodal_motors::<T>(),
        rotor in pga2d::strategies::rotors::<T>(),
        line in pga2d::strategies::unit_lines::<T>(),
        direction in pga2d::strategies::unit_directions::<T>(),
        turned in pga2d::strategies::motors_near_half_turn::<T>(),
        still in pga2d::strategies::motors_near_identity::<T>(),
        far in pga2d::strategies::motors_with_tiny_turn_and_huge_step::<T>(),
    )| {
        for motor in [a, b, c, turned, still, far] {
            prop_assert!(motor.is_unit(unit), "{motor:?}");
        }
        prop_assert_eq!(negative, -c);
        prop_assert!(rotor.is_unit(unit) && line.is_unit(unit) && direction.is_unit(unit));
        prop_assert!(turned.s.abs() < T::from_ratio(1, 100) && (still - pga2d::Motor::IDENTITY).norm() < T::from_ratio(1, 50));
        prop_assert!(far.e12.abs() < T::from_ratio(1, 100) && far.e01.abs() + far.e20.abs() > T::from_ratio(30, 1));
    });
}

#[test]
fn strategies_of_the_plane_keep_what_types_promise() {
    keeps_its_promise_in_the_plane::<f32>();
    keeps_its_promise_in_the_plane::<f64>();
}
