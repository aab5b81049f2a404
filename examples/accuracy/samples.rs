//! Where the functions are measured: every order of magnitude of angle, the special angles with a neighbour to either
//! side, small and huge ideal parts, axes along the axes of coordinates and in any direction.

use crate::big::Big;
use crate::float::Float;
use crate::{plane, space};
use pga_motor::Motor;

/// An input and the half-angle that it belongs to.
#[derive(Clone, Debug)]
pub(crate) struct Sample<T> {
    pub(crate) half_angle: f64,
    pub(crate) input: Vec<T>,
}

impl<T: Float> Sample<T> {
    fn new(half_angle: T, input: Vec<T>) -> Option<Self> {
        input.iter().all(|x| x.is_finite()).then_some(Self { half_angle: half_angle.to_f64(), input })
    }

    /// The sample with one more input.
    fn with(&self, input: T) -> Self {
        let mut sample = self.clone();
        sample.input.push(input);
        sample
    }
}

/// Numbers that look random and are always the same ones: splitmix64.
struct Random(u64);

impl Random {
    fn bits(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let mixed = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        let mixed = (mixed ^ (mixed >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        mixed ^ (mixed >> 31)
    }

    /// Between -1 and 1.
    fn number(&mut self) -> f64 {
        (self.bits() >> 11) as f64 / (1u64 << 52) as f64 - 1.0
    }

    /// Of length 1.
    fn direction<const N: usize>(&mut self) -> [f64; N] {
        loop {
            let direction = std::array::from_fn(|_| self.number());
            let length = direction.iter().map(|x| x * x).sum::<f64>().sqrt();
            if (0.1..1.0).contains(&length) {
                return direction.map(|x| x / length);
            }
        }
    }
}

fn cross([a, b, c]: [f64; 3], [x, y, z]: [f64; 3]) -> [f64; 3] {
    [b * z - c * y, c * x - a * z, a * y - b * x]
}

/// The coefficients of a direction times a length, each rounded.
fn scaled<T: Float, const N: usize>(direction: [f64; N], length: f64) -> Vec<T> {
    direction.iter().map(|x| T::from_f64(x * length)).collect()
}

/// A special number and its neighbours.
fn neighbours<T: Float>(special: f64) -> [T; 3] {
    let special = T::from_f64(special);
    [special.next_down(), special, special.next_up()]
}

/// Half-angles of motors, up to the neighbour of pi.
fn half_angles<T: Float>() -> Vec<T> {
    use std::f64::consts::{FRAC_PI_2, FRAC_PI_4, PI};
    let listed = T::HALF_ANGLES.iter().map(|&angle| T::from_f64(angle));
    let special = [FRAC_PI_4, FRAC_PI_2, PI].into_iter().flat_map(neighbours);
    // Between half a turn and the whole one, nearer and nearer to it.
    let near_whole_turn = T::HALF_ANGLES.iter().filter(|angle| (1e-20..1.0).contains(*angle));
    let beyond = near_whole_turn.map(|angle| T::from_f64(PI - angle));
    listed.chain(special).chain(beyond).collect()
}

/// Lengths of ideal parts beside a half-angle: of their own, and relative to it.
fn lengths<T: Float>(half_angle: f64) -> Vec<f64> {
    let mut lengths = vec![0.0, 1e-6, 1.0, 1e6];
    lengths.extend(T::EXTREME_LENGTHS);
    if (0.0..1e-2).contains(&half_angle) && half_angle > 0.0 {
        lengths.extend([1e-6, 1.0, 1e6].map(|factor| factor * half_angle));
    }
    lengths
}

/// Pairs of directions, of the rotation and of the ideal part: along axes and not, parallel, perpendicular, neither.
fn arrangements(random: &mut Random) -> [[[f64; 3]; 2]; 5] {
    let mut axes = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
    axes.rotate_left((random.bits() % 3) as usize);
    let (any, other) = (random.direction(), random.direction());
    [[axes[0], axes[0]], [axes[0], axes[1]], [any, any], [any, cross(any, other)], [other, random.direction()]]
}

fn lines_at<T: Float>(half_angles: &[T]) -> Vec<Sample<T>> {
    let mut random = Random(1);
    let mut samples = Vec::new();
    for &half_angle in half_angles {
        for length in lengths::<T>(half_angle.to_f64()) {
            for [direction, ideal] in arrangements(&mut random) {
                let input = [scaled(direction, half_angle.to_f64()), scaled(ideal, length)].concat();
                samples.extend(Sample::new(half_angle, input));
            }
        }
    }
    samples
}

fn bivectors_at<T: Float>(half_angles: &[T]) -> Vec<Sample<T>> {
    let mut random = Random(2);
    let mut samples = Vec::new();
    for &half_angle in half_angles {
        for length in lengths::<T>(half_angle.to_f64()) {
            for (rotation, ideal) in [(half_angle, random.direction()), (-half_angle, [1.0, 0.0])] {
                samples.extend(Sample::new(half_angle, [vec![rotation], scaled(ideal, length)].concat()));
            }
        }
    }
    samples
}

fn with_large<T: Float>() -> Vec<T> {
    let large = T::LARGE_HALF_ANGLES.iter().map(|&angle| T::from_f64(angle));
    half_angles().into_iter().chain(large).collect()
}

/// Generators for the exponential.
pub(crate) fn lines<T: Float>() -> Vec<Sample<T>> {
    lines_at(&with_large())
}

/// Generators for the exponential in the plane.
pub(crate) fn bivectors<T: Float>() -> Vec<Sample<T>> {
    bivectors_at(&with_large())
}

type Exponential = fn(&[Big]) -> Vec<Big>;

fn space_exp(line: &[Big]) -> Vec<Big> {
    space::Line::new(line).exp().to_vec()
}

fn plane_exp(bivector: &[Big]) -> Vec<Big> {
    plane::Bivector::new(bivector).exp().to_vec()
}

/// The exact exponentials, each coefficient rounded.
fn rounded<T: Float>(generators: Vec<Sample<T>>, exp: Exponential) -> Vec<Sample<T>> {
    let motor = |sample: Sample<T>| {
        let exact = exp(&sample.input.iter().map(|x| x.to_big()).collect::<Vec<_>>());
        Sample::new(T::from_f64(sample.half_angle), exact.iter().map(T::from_big).collect())
    };
    generators.into_iter().filter_map(motor).collect()
}

/// Motors as near as floats come to them.
pub(crate) fn motors<T: Float>() -> Vec<Sample<T>> {
    let mut samples = rounded(lines_at::<T>(&half_angles()), space_exp);
    samples.extend(half_turns());
    samples.extend(translators(8));
    samples
}

/// Motors from one keyframe to the next, ~a b in floats, with the rounding errors of that product: where the turn between is
/// small, the coefficient of e0123 is nothing but those.
pub(crate) fn between_keyframes<T: Float>() -> Vec<Sample<T>> {
    let mut random = Random(7);
    let mut samples = Vec::new();
    for &turn in &half_angles::<T>() {
        for _ in 0..8 {
            let (axis, moments): ([f64; 3], [[f64; 3]; 2]) =
                (random.direction(), [random.direction(), random.direction()]);
            let [a, b] = [(1.0, moments[0]), (1.0 + turn.to_f64(), moments[1])].map(|(angle, moment)| {
                let line: Vec<T> = [scaled(axis, angle), scaled(moment, 3.0)].concat();
                let motor = space_exp(&line.iter().map(|x| x.to_big()).collect::<Vec<_>>());
                Motor::from(std::array::from_fn::<T, 8, _>(|index| T::from_big(&motor[index])))
            });
            samples.extend(Sample::new(turn, (a.reverse() * b).to_array().to_vec()));
        }
    }
    samples
}

/// Motors of the plane as near as floats come to them.
pub(crate) fn plane_motors<T: Float>() -> Vec<Sample<T>> {
    let mut samples = rounded(bivectors_at::<T>(&half_angles()), plane_exp);
    let half_turn = |c: [f64; 2]| [0.0, -1.0, c[0], c[1]].map(T::from_f64).to_vec();
    let turns = [[0.0, 0.0], [1e-6, 1.0], [1e6, -1.0]].map(half_turn);
    samples.extend(turns.into_iter().filter_map(|input| Sample::new(T::from_f64(std::f64::consts::FRAC_PI_2), input)));
    samples.extend(translators(4));
    samples
}

/// Exactly half a turn, s = 0, about axes through the origin and off it, with slides and without.
fn half_turns<T: Float>() -> Vec<Sample<T>> {
    let mut random = Random(3);
    let mut samples = Vec::new();
    for length in lengths::<T>(1.0) {
        for slide in lengths::<T>(1.0) {
            for [axis, other] in arrangements(&mut random) {
                let moment = scaled(cross(axis, other), length);
                let input = [vec![T::ZERO], scaled(axis, 1.0), moment, vec![T::from_f64(slide)]].concat();
                samples.extend(Sample::new(T::from_f64(std::f64::consts::FRAC_PI_2), input));
            }
        }
    }
    samples
}

/// 1, -1 and translators with either sign.
fn translators<T: Float>(coefficients: usize) -> Vec<Sample<T>> {
    let euclidean = coefficients / 2;
    let mut samples = Vec::new();
    for (sign, half_angle) in [(1.0, 0.0), (-1.0, std::f64::consts::PI)] {
        for length in lengths::<T>(1.0) {
            let mut input = vec![T::ZERO; coefficients];
            input[0] = T::from_f64(sign);
            input[euclidean] = T::from_f64(length * 0.6);
            input[euclidean + 1] = T::from_f64(length * 0.8);
            samples.extend(Sample::new(T::from_f64(half_angle), input));
        }
    }
    samples
}

/// Multiples of motors.
fn multiples<T: Float>(motors: Vec<Sample<T>>) -> Vec<Sample<T>> {
    let scales = T::SCALES.into_iter().cycle();
    let scaled = |(sample, scale): (Sample<T>, f64)| {
        let input = sample.input.iter().map(|x| *x * T::from_f64(scale)).collect();
        Sample::new(T::from_f64(sample.half_angle), input)
    };
    motors.into_iter().zip(scales).filter_map(scaled).collect()
}

/// Multiples of motors.
pub(crate) fn evens<T: Float>() -> Vec<Sample<T>> {
    multiples(motors())
}

/// Multiples of motors with a pseudoscalar coefficient as large as it may be, which no motor has.
pub(crate) fn off_quadric<T: Float>() -> Vec<Sample<T>> {
    let mut random = Random(4);
    let mut samples = multiples(motors::<T>());
    for sample in &mut samples {
        let euclidean = sample.input[..4].iter().fold(T::ZERO, |sum, x| sum + x.abs());
        sample.input[7] = sample.input[7] + euclidean * T::from_f64(random.number());
    }
    samples
}

/// Multiples of motors of the plane.
pub(crate) fn plane_evens<T: Float>() -> Vec<Sample<T>> {
    multiples(plane_motors())
}

/// Times of interpolation and exponents: ends, in between, and outside.
const TIMES: [f64; 7] = [0.5, 0.0, 1.0, 0.3, 0.9, -0.5, 1.75];

fn at_times<T: Float>(samples: Vec<Sample<T>>) -> Vec<Sample<T>> {
    let times = TIMES.iter().cycle();
    samples.iter().zip(times).map(|(sample, &t)| sample.with(T::from_f64(t))).collect()
}

/// Motors with an exponent.
pub(crate) fn powers<T: Float>() -> Vec<Sample<T>> {
    at_times(motors())
}

/// Motors of the plane with an exponent.
pub(crate) fn plane_powers<T: Float>() -> Vec<Sample<T>> {
    at_times(plane_motors())
}

/// Two motors and a time. The half-angle is that from the one to the other.
///
/// Both ways are equally long at half a turn; rounding of the scalar product decides there, so such pairs are left to
/// starts whose rotor is 1, with which it is exact.
pub(crate) fn pairs<T: Float>() -> Vec<Sample<T>> {
    let mut random = Random(5);
    let mut samples = Vec::new();
    for (index, sample) in motors::<T>().into_iter().step_by(5).enumerate() {
        let between = space::Motor::new(&sample.input.iter().map(|x| x.to_big()).collect::<Vec<_>>());
        let turn = [0.0, 1e-8, 0.7, 1.2][index % 4];
        let shift = [0.0, 1.0, 1e6][index % 3];
        let generator = [scaled::<T, 3>(random.direction(), turn), scaled(random.direction::<3>(), shift)].concat();
        let start: Vec<_> = space_exp(&big(&generator)).iter().map(T::from_big).collect();
        let end: Vec<_> = space::Motor::new(&big(&start)).geometric(&between).to_vec();
        let end: Vec<_> = end.iter().map(T::from_big).collect();
        let product = space::Motor::new(&big(&start)).scalar_product(&space::Motor::new(&big(&end)));
        if turn == 0.0 || is_clear::<T>(&product) {
            samples.extend(Sample::new(T::from_f64(sample.half_angle), [start, end].concat()));
        }
    }
    at_times(samples)
}

/// Two motors of the plane and a time, likewise.
pub(crate) fn plane_pairs<T: Float>() -> Vec<Sample<T>> {
    let mut random = Random(6);
    let mut samples = Vec::new();
    for (index, sample) in plane_motors::<T>().into_iter().enumerate() {
        let between = plane::Motor::new(&big(&sample.input));
        let turn = [0.0, 1e-8, 0.7, 1.2][index % 4];
        let shift = [0.0, 1.0, 1e6][index % 3];
        let generator = [vec![T::from_f64(turn)], scaled(random.direction::<2>(), shift)].concat();
        let start: Vec<_> = plane_exp(&big(&generator)).iter().map(T::from_big).collect();
        let end: Vec<_> = plane::Motor::new(&big(&start)).geometric(&between).to_vec();
        let end: Vec<_> = end.iter().map(T::from_big).collect();
        let product = plane::Motor::new(&big(&start)).scalar_product(&plane::Motor::new(&big(&end)));
        if turn == 0.0 || is_clear::<T>(&product) {
            samples.extend(Sample::new(T::from_f64(sample.half_angle), [start, end].concat()));
        }
    }
    at_times(samples)
}

fn big<T: Float>(input: &[T]) -> Vec<Big> {
    input.iter().map(|x| x.to_big()).collect()
}

/// Whether rounding cannot change the sign of a sum of four products, or fewer, of unit vectors: four roundings of
/// products and three of sums, each below u, change it by less than 8 u.
fn is_clear<T: Float>(product: &Big) -> bool {
    product.abs() > T::roundoff() * Big::from(8.0)
}
