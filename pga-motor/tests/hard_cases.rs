//! Where textbook formulas break down: ends that face each other, rotations lost in rounding errors, times far outside
//! \[0, 1\].

use pga_motor::f64::{Direction, Line, Motor, Point, Rotor, Translator, UnitLine, UnitPlane};
use pga_motor::pga2d;

/// Numbers that look random and are always the same: a linear congruential generator (Knuth's MMIX).
struct Random(u64);

impl Random {
    fn number(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 11) as f64 / (1u64 << 52) as f64 - 1.0
    }

    fn direction(&mut self) -> Direction {
        Direction::new(self.number(), self.number(), self.number()).normalize().expect("no direction is 0")
    }

    fn point(&mut self) -> Point {
        Point::ORIGIN + self.direction() * 3.0
    }
}

/// Turns from half a turn less `gap` on down, about an axis across a direction.
fn nearly_half_turn(direction: Direction, gap: f64, random: &mut Random) -> Rotor {
    let axis = direction.cross(random.direction());
    Rotor::from_axis_angle(axis, std::f64::consts::PI - gap).expect("an axis")
}

/// Normals and directions are unit to 2 u, offsets 3 long, and the kernels round each sum of at most 4 products: what is
/// carried over is off by less than 100 u = 1.1e-14, however small the angle that is left.
const CARRIED: f64 = 1.2e-14;

#[test]
fn planes_that_nearly_face_each_other_are_carried_over() {
    let mut random = Random(1);
    for gap in [1.0, 1e-3, 1e-6, 1e-9, 1e-12, 1e-14] {
        for _ in 0..200 {
            let normal = random.direction();
            let from = UnitPlane::from_point_and_normal(random.point(), normal).expect("a normal");
            let turn = nearly_half_turn(normal, gap, &mut random);
            let to = turn.transform_unit_plane(from);
            let Some(motor) = Motor::between_planes(from, to) else { panic!("{from:?} to {to:?}") };
            // Off by as much as the normals are off unit length.
            assert!(motor.rotor().is_unit(4e-15), "{motor:?}");
            let carried = motor.transform_unit_plane(from);
            let off = (carried.e1 - to.e1).hypot(carried.e2 - to.e2).hypot(carried.e3 - to.e3);
            assert!(off < CARRIED, "{off:e} at {gap:e}");
            // The planes meet as far away as the gap is small, so the motor's ideal part is large, and with it the rounding.
            let off = (carried.e0 - to.e0).abs();
            assert!(off < CARRIED * (1.0 + motor.translator().vector().norm()), "{off:e} at {gap:e}");
        }
    }
}

#[test]
fn opposite_planes_and_lines_have_no_motion_between_them() {
    let mut random = Random(2);
    for _ in 0..1000 {
        let plane = UnitPlane::from_point_and_normal(random.point(), random.direction()).expect("a normal");
        assert_eq!(Motor::between_planes(plane, -plane), None);
        let line = UnitLine::from_point_and_direction(random.point(), random.direction()).expect("a direction");
        assert_eq!(Motor::between_lines(line, line.reverse()), None);
        let beside = line.project_onto_point(random.point()).reverse();
        assert_eq!(Motor::between_lines(line, beside), None, "antiparallel");
        let (x, y, c) = (random.number(), random.number(), random.number());
        let line = pga2d::f64::Line::new(x, y, c).normalize().expect("a normal");
        assert_eq!(pga2d::f64::Motor::between_lines(line, -line), None);
    }
}

/// Between keyframes that turn alike, the coefficient of e0123 is nothing but rounding errors of the product, far greater than the
/// rotation. The logarithm is off by what rounding its coefficients costs, u |c| each for four of them, and no more: here
/// 16 u |c| with |c| below 6.
#[test]
fn logarithms_keep_to_the_translation_where_the_rotation_is_lost() {
    let mut random = Random(3);
    for gap in [0.0, 1e-300, 1e-200, 1e-16, 1e-12, 1e-8, 1e-4] {
        for _ in 0..500 {
            let axis = random.direction();
            let frame = |angle, point: Point| {
                let rotor = Rotor::from_axis_angle(axis, angle).expect("an axis");
                Motor::from_rotor_translator(rotor, Translator::from_vector(point - Point::ORIGIN))
            };
            let (a, b) = (frame(2.0, random.point()), frame(2.0 + gap, random.point()));
            let between = a.reverse() * b;
            let log = between.log();
            // For turns as small as these the logarithm's ideal part is the motor's, to the turn times it.
            let off = Line::new(0.0, 0.0, 0.0, log.e01 - between.e01, log.e02 - between.e02, log.e03 - between.e03);
            assert!(off.ideal_norm() <= 6.0 * (gap + 16.0 * f64::EPSILON / 2.0), "{gap:e}: {off:?}");
        }
    }
    let noisy = Motor::new(1.0 + f64::EPSILON, -1.12e-300, 0.0, 0.0, 0.0, 1.0, 0.0, 1e-16);
    assert!((noisy.log() - Line::new(-1.12e-300, 0.0, 0.0, 0.0, 1.0, 0.0)).ideal_norm() < 1e-15);
}

/// screw_lerp magnifies by t what rounding errors make of ~a a, the others do not.
#[test]
fn equal_ends_stay_put_at_any_time() {
    let mut random = Random(4);
    let rotor = Rotor::from_axis_angle(random.direction(), 1.0).expect("an axis");
    let motor = Motor::from_rotor_translator(rotor, Translator::from_vector(random.point() - Point::ORIGIN));
    for t in [-1e300, -1e16, -1.0, 0.0, 0.3, 1.0, 2.0, 1e8, 1e16, 1e300] {
        // Normalisation, log and exp each round by a few u of coefficients up to 3.
        let near = |other: Motor| (other - motor).norm() + (other - motor).ideal_norm() < 1e-14;
        for other in [motor, -motor] {
            assert!(near(motor.nlerp(other, t)), "nlerp at {t:e}");
            assert!(near(motor.slerp(other, t)), "slerp at {t:e}");
            assert!(t.abs() > 10.0 || near(motor.screw_lerp(other, t)), "screw_lerp at {t:e}");
            assert!(near(motor.split_lerp(other, t)), "split_lerp at {t:e}");
            assert!(near(motor.log_lerp(other, t)), "log_lerp at {t:e}");
        }
    }
}

/// Far out the chord goes towards the difference of its ends.
#[test]
fn extrapolation_keeps_to_units_as_far_as_numbers_go() {
    let end = Motor::from(Rotor::about_z(1.0));
    for t in [1e3, 1e20, 1e155, 1e300] {
        let far = Motor::IDENTITY.nlerp(end, t);
        assert!(far.is_unit(1e-15), "{far:?} at {t:e}");
        assert!(Motor::IDENTITY.nlerp(end, -t).is_unit(1e-15));
        assert!(Motor::IDENTITY.slerp(end, t).is_unit(1e-12), "at {t:e}");
    }
    assert!(!Motor::IDENTITY.nlerp(end, f64::INFINITY).is_finite());
    let end = pga_motor::f32::Motor::from(pga_motor::f32::Rotor::about_z(1.0));
    assert!(pga_motor::f32::Motor::IDENTITY.nlerp(end, 1e30).is_unit(1e-6));
    let end = pga2d::f64::Motor::about(pga2d::f64::Point::new(1.0, 2.0), 1.0);
    assert!(pga2d::f64::Motor::IDENTITY.nlerp(end, 1e200).is_unit(1e-15));
}
