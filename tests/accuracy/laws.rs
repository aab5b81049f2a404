//! The reference keeps the laws that define its functions, in the products of the naive multivector.

use ga_codegen::algebra::Signature;
use ga_codegen::reference::Multivector;

use crate::big::{Big, PRECISION};
use crate::functions::{self, Function};
use crate::samples::{self, Sample};
use crate::{plane, space};

/// An algebra with the reference functions of its rows.
struct Algebra {
    signature: Signature,
    /// The blades of motors and of generators, in the order of the coefficients.
    motor: &'static [&'static str],
    generator: &'static [&'static str],
    functions: Vec<Function<f64>>,
    samples: Vec<Sample<f64>>,
}

fn algebras() -> [Algebra; 2] {
    let space = Algebra {
        signature: Signature::new(3, 0, 1),
        motor: &["1", "e23", "e31", "e12", "e01", "e02", "e03", "e0123"],
        generator: &["e23", "e31", "e12", "e01", "e02", "e03"],
        functions: functions::space(),
        samples: samples::lines(),
    };
    let plane = Algebra {
        signature: Signature::new(2, 0, 1),
        motor: &["1", "e12", "e01", "e20"],
        generator: &["e12", "e01", "e20"],
        functions: functions::plane(),
        samples: samples::bivectors(),
    };
    [space, plane]
}

impl Algebra {
    /// A function by the name of its row.
    fn call(&self, name: &str, input: &[&[Big]]) -> Vec<Big> {
        let row = self.functions.iter().find(|row| row.name.ends_with(name)).expect("a row of this name");
        (row.reference)(&input.concat()).expect("a value")
    }

    /// Samples of half-angles up to the given one, thinned.
    fn generators(&self, largest: f64) -> impl Iterator<Item = Vec<Big>> {
        let samples = self.samples.iter().filter(move |sample| sample.half_angle <= largest).step_by(7);
        samples.map(|sample| sample.input.iter().map(|&x| Big::from(x)).collect())
    }

    fn multivector(&self, blades: &[&str], coefficients: &[Big]) -> Multivector<Big> {
        let blades = blades.iter().zip(coefficients).map(|(blade, coefficient)| (*blade, coefficient.clone()));
        Multivector::from_blades(self.signature, blades).expect("blades of the algebra")
    }

    /// The coefficients of a motor.
    fn coefficients(&self, motor: &Multivector<Big>) -> Vec<Big> {
        self.motor.iter().map(|blade| motor.coefficient(blade)).collect()
    }

    fn geometric(&self, a: &[Big], b: &[Big]) -> Vec<Big> {
        let [a, b] = [a, b].map(|motor| self.multivector(self.motor, motor));
        self.coefficients(&a.geometric(&b))
    }

    /// The sum of B^n / n!.
    fn exponential_series(&self, generator: &[Big]) -> Vec<Big> {
        let generator = self.multivector(self.generator, generator);
        let mut term = Multivector::scalar(self.signature, Big::from(1.0));
        let mut sum = term.clone();
        // 5^n / n! is below 2^-340 from n = 120 on.
        for n in 1..120_i8 {
            let reciprocal = Multivector::scalar(self.signature, Big::from(1.0) / Big::from(n));
            term = term.geometric(&generator).geometric(&reciprocal);
            sum = &sum + &term;
        }
        self.coefficients(&sum)
    }

    /// What the coefficients of each blade are measured by: the sizes of the rotation and of the ideal part.
    fn scales(&self, blades: &[&str], generator: &[Big]) -> Vec<Big> {
        let size = |of_ideal: bool| {
            let coefficients = self.generator.iter().zip(generator);
            coefficients
                .filter(|(blade, _)| blade.contains('0') == of_ideal)
                .map(|(_, x)| x.abs())
                .fold(Big::from(0.0), plus)
        };
        let (rotation, ideal): (Big, Big) = (size(false), size(true));
        let scale = |blade: &&str| match *blade {
            "1" => Big::from(1.0),
            "e0123" => &rotation * &ideal,
            blade if blade.contains('0') => ideal.clone(),
            _ => rotation.clone(),
        };
        blades.iter().map(scale).collect()
    }

    /// The scales of motors that come of a motor and a generator.
    fn scales_after(&self, motor: &[Big], generator: &[Big]) -> Vec<Big> {
        let largest = motor.iter().chain(generator).map(Big::abs).fold(Big::from(1.0), plus);
        self.motor.iter().map(|blade| if blade.contains('0') { largest.clone() } else { Big::from(1.0) }).collect()
    }
}

fn plus(a: Big, b: Big) -> Big {
    a + b
}

fn times(factor: &Big, coefficients: &[Big]) -> Vec<Big> {
    coefficients.iter().map(|x| factor * x).collect()
}

/// Within 2^-290 of the scales: half-angles up to 3 divide by the square of their sine, 2^-6, which leaves 24 of the 30
/// bits to the roundings of sums of some hundred terms, each e^5 = 2^7 at most.
fn assert_close(found: &[Big], expected: &[Big], scales: &[Big], what: &str) {
    let tolerance = Big::power_of_two(30 - PRECISION as isize);
    for ((found, expected), scale) in found.iter().zip(expected).zip(scales) {
        let difference = (found - expected).abs();
        let [shown, wanted] = [found, expected].map(Big::to_f64);
        assert!(difference <= &tolerance * scale, "{what}: expected {wanted:e}, found {shown:e}");
    }
}

/// A motor to start from.
fn start(algebra: &Algebra) -> Vec<Big> {
    let generator: Vec<_> =
        [0.3, -0.5, 0.2, 1.5, 0.7, -2.0][..algebra.generator.len()].iter().map(|&x| x.into()).collect();
    algebra.call("::exp", &[&generator])
}

#[test]
fn products_are_those_of_the_naive_multivector() {
    let [in_space, in_plane] = algebras();
    let coefficients = [2.0, 3.0, 5.0, 7.0, 11.0, 13.0, 17.0, 19.0, 23.0, 29.0, 31.0, 37.0, 41.0, 43.0, 47.0, 53.0];
    let coefficients = coefficients.map(Big::from);
    let (a, b) = coefficients.split_at(8);
    assert_eq!(space::Motor::new(a).geometric(&space::Motor::new(b)).to_vec(), in_space.geometric(a, b));
    let (a, b) = coefficients[..8].split_at(4);
    assert_eq!(plane::Motor::new(a).geometric(&plane::Motor::new(b)).to_vec(), in_plane.geometric(a, b));
}

#[test]
fn exp_is_the_sum_of_its_series() {
    for algebra in algebras() {
        for generator in algebra.generators(5.0) {
            let exp = algebra.call("::exp", &[&generator]);
            let scales = algebra.scales(algebra.motor, &generator);
            assert_close(&exp, &algebra.exponential_series(&generator), &scales, "exp");
        }
    }
}

#[test]
fn log_takes_exp_back() {
    for algebra in algebras() {
        for generator in algebra.generators(3.0) {
            let motor = algebra.call("::exp", &[&generator]);
            let log = algebra.call("log_double_cover", &[&motor]);
            assert_close(&log, &generator, &algebra.scales(algebra.generator, &generator), "log");
        }
    }
}

#[test]
fn log_is_that_of_the_motor_or_its_negative() {
    for algebra in algebras() {
        for generator in algebra.generators(1.5) {
            let motor = algebra.call("::exp", &[&generator]);
            let negative = times(&Big::from(-1.0), &motor);
            let scales = algebra.scales(algebra.generator, &generator);
            for motor in [motor, negative] {
                assert_close(&algebra.call("::log", &[&motor]), &generator, &scales, "log");
            }
        }
    }
}

#[test]
fn sqrt_is_the_exponential_of_half_the_generator() {
    for algebra in algebras() {
        for generator in algebra.generators(3.0) {
            let motor = algebra.call("::exp", &[&generator]);
            let half = algebra.call("::exp", &[&times(&Big::from(0.5), &generator)]);
            let scales = algebra.scales(algebra.motor, &generator);
            assert_close(&algebra.call("sqrt_double_cover", &[&motor]), &half, &scales, "sqrt");
            assert_close(&algebra.geometric(&half, &half), &motor, &scales, "square");
        }
    }
}

#[test]
fn powers_multiply_the_generator() {
    for algebra in algebras() {
        for generator in algebra.generators(1.5) {
            let motor = algebra.call("::exp", &[&generator]);
            let t = Big::from(-0.7);
            let expected = algebra.call("::exp", &[&times(&t, &generator)]);
            let scales = algebra.scales(algebra.motor, &generator);
            assert_close(&algebra.call("powf", &[&motor, &[t]]), &expected, &scales, "powf");
        }
    }
}

#[test]
fn normalize_takes_study_numbers_off() {
    for algebra in algebras() {
        for generator in algebra.generators(3.0) {
            let motor = algebra.call("::exp", &[&generator]);
            let mut study = vec![Big::from(0.0); motor.len()];
            study[0] = Big::from(3.5);
            if algebra.motor.contains(&"e0123") {
                study[motor.len() - 1] = Big::from(-1.25);
            }
            let multiple = algebra.geometric(&motor, &study);
            let scales = algebra.scales_after(&motor, &generator);
            assert_close(&algebra.call("EvenMultivector::normalize", &[&multiple]), &motor, &scales, "normalize");
        }
    }
}

#[test]
fn interpolations_meet_at_the_ends_and_half_way() {
    for algebra in algebras() {
        let start = start(&algebra);
        for generator in algebra.generators(1.5) {
            let end = algebra.geometric(&start, &algebra.call("::exp", &[&generator]));
            let half = algebra.call("::exp", &[&times(&Big::from(0.5), &generator)]);
            let scales = algebra.scales_after(&start, &generator);
            for name in ["nlerp", "slerp", "screw_lerp"] {
                let at = |t: f64| algebra.call(&format!("Motor::{name}"), &[&start, &end, &[t.into()]]);
                assert_close(&at(0.0), &start, &scales, name);
                assert_close(&at(0.5), &algebra.geometric(&start, &half), &scales, name);
                assert_close(&at(1.0), &end, &scales, name);
            }
        }
    }
}

#[test]
fn screw_lerp_follows_the_screw_and_slerp_the_arc() {
    for algebra in algebras() {
        let start = start(&algebra);
        for generator in algebra.generators(1.5) {
            let t = Big::from(0.3);
            let end = algebra.geometric(&start, &algebra.call("::exp", &[&generator]));
            let part = algebra.call("::exp", &[&times(&t, &generator)]);
            let expected = algebra.geometric(&start, &part);
            let scales = algebra.scales_after(&start, &generator);
            let input: [&[Big]; 3] = [&start, &end, &[t]];
            assert_close(&algebra.call("screw_lerp", &input), &expected, &scales, "screw_lerp");
            let rotor = start.len() / 2;
            let slerp = algebra.call("Motor::slerp", &input);
            assert_close(&slerp[..rotor], &expected[..rotor], &scales, "slerp");
        }
    }
}
