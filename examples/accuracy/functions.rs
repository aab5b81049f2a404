//! The functions that are measured: a row for each.

use pga_motor::pga2d;
use pga_motor::{EvenMultivector, Line, Motor};

use crate::float::Float;
use crate::measure::{Reference, Shape, Sizes};
use crate::samples::{self, Sample};
use crate::{plane, space, textbook};

/// A function of floats on coefficients; none where it has no value.
pub(crate) type Computed<T> = fn(&[T]) -> Option<Vec<T>>;

/// A function in its three versions, and where it is measured.
pub(crate) struct Function<T> {
    pub(crate) name: &'static str,
    pub(crate) result: Shape,
    pub(crate) samples: fn() -> Vec<Sample<T>>,
    pub(crate) sizes: Sizes,
    pub(crate) reference: Reference,
    pub(crate) textbook: Computed<T>,
    pub(crate) ours: Computed<T>,
}

/// The coefficients that a function takes.
fn all<X: Clone, const N: usize>(input: &[X]) -> [X; N] {
    input.to_vec().try_into().unwrap_or_else(|_| panic!("expected {N} coefficients, found {}", input.len()))
}

/// A motor of N coefficients and an exponent.
fn power<X: Clone, const N: usize>(input: &[X]) -> ([X; N], X) {
    (all(&input[..N]), input[N].clone())
}

/// Two motors of N coefficients and a time.
fn pair<X: Clone, const N: usize>(input: &[X]) -> ([X; N], [X; N], X) {
    (all(&input[..N]), all(&input[N..2 * N]), input[2 * N].clone())
}

fn some<X, const N: usize>(coefficients: [X; N]) -> Option<Vec<X>> {
    Some(coefficients.into())
}

/// The functions of space.
pub(crate) fn space<T: Float>() -> Vec<Function<T>> {
    vec![
        Function {
            name: "Line::exp",
            result: Shape::Motor,
            samples: samples::lines,
            sizes: Sizes::OfInputs,
            reference: |x| Some(space::Line::new(x).exp().to_vec()),
            textbook: |x| some(textbook::exp(all(x))),
            ours: |x| some(Line::from(all(x)).exp().to_array()),
        },
        Function {
            name: "Line::exp_slice",
            result: Shape::Motor,
            samples: samples::lines,
            sizes: Sizes::OfInputs,
            reference: |x| Some(space::Line::new(x).exp().to_vec()),
            textbook: |x| some(textbook::exp(all(x))),
            ours: |x| {
                let mut motor = [Motor::IDENTITY];
                Line::exp_slice(&[all(x).into()], &mut motor).ok()?;
                some(motor[0].to_array())
            },
        },
        Function {
            name: "Motor::log",
            result: Shape::Line,
            samples: samples::motors,
            sizes: Sizes::OfInputs,
            reference: |x| Some(space::Motor::new(x).log()?.to_vec()),
            textbook: |x| some(textbook::log(textbook::short_way(all(x), x[0]))),
            ours: |x| some(Motor::from(all(x)).log().to_array()),
        },
        Function {
            name: "Motor::log_slice",
            result: Shape::Line,
            samples: samples::motors,
            sizes: Sizes::OfInputs,
            reference: |x| Some(space::Motor::new(x).log()?.to_vec()),
            textbook: |x| some(textbook::log(textbook::short_way(all(x), x[0]))),
            ours: |x| {
                let mut line = [Line::ZERO];
                Motor::log_slice(&[all(x).into()], &mut line).ok()?;
                some(line[0].to_array())
            },
        },
        Function {
            name: "Motor::log between keyframes",
            result: Shape::Line,
            samples: samples::between_keyframes,
            sizes: Sizes::OfInputs,
            reference: |x| Some(space::Motor::new(x).log()?.to_vec()),
            textbook: |x| some(textbook::log(textbook::short_way(all(x), x[0]))),
            ours: |x| some(Motor::from(all(x)).log().to_array()),
        },
        Function {
            name: "Motor::log_slice between keyframes",
            result: Shape::Line,
            samples: samples::between_keyframes,
            sizes: Sizes::OfInputs,
            reference: |x| Some(space::Motor::new(x).log()?.to_vec()),
            textbook: |x| some(textbook::log(textbook::short_way(all(x), x[0]))),
            ours: |x| {
                let mut line = [Line::ZERO];
                Motor::log_slice(&[all(x).into()], &mut line).ok()?;
                some(line[0].to_array())
            },
        },
        Function {
            name: "Motor::log_double_cover",
            result: Shape::Line,
            samples: samples::motors,
            sizes: Sizes::OfInputs,
            reference: |x| Some(space::Motor::new(x).log_double_cover()?.to_vec()),
            textbook: |x| some(textbook::log(all(x))),
            ours: |x| some(Motor::from(all(x)).log_double_cover()?.to_array()),
        },
        Function {
            name: "Motor::sqrt",
            result: Shape::Motor,
            samples: samples::motors,
            sizes: Sizes::OfInputs,
            reference: |x| Some(space::Motor::new(x).sqrt()?.to_vec()),
            textbook: |x| some(textbook::sqrt(textbook::short_way(all(x), x[0]))),
            ours: |x| some(Motor::from(all(x)).sqrt().to_array()),
        },
        Function {
            name: "Motor::sqrt_double_cover",
            result: Shape::Motor,
            samples: samples::motors,
            sizes: Sizes::OfInputs,
            reference: |x| Some(space::Motor::new(x).sqrt_double_cover()?.to_vec()),
            textbook: |x| some(textbook::sqrt(all(x))),
            ours: |x| some(Motor::from(all(x)).sqrt_double_cover()?.to_array()),
        },
        Function {
            name: "Motor::powf",
            result: Shape::Motor,
            samples: samples::powers,
            sizes: Sizes::OfInputs,
            reference: |x| {
                let (m, t) = power::<_, 8>(x);
                Some(space::Motor::new(&m).powf(&t)?.to_vec())
            },
            textbook: |x| {
                let (m, t) = power(x);
                some(textbook::powf(m, t))
            },
            ours: |x| {
                let (m, t) = power::<_, 8>(x);
                some(Motor::from(m).powf(t).to_array())
            },
        },
        Function {
            name: "EvenMultivector::normalize",
            result: Shape::Motor,
            samples: samples::evens,
            sizes: Sizes::OfInputs,
            reference: |x| Some(space::Motor::new(x).normalize()?.to_vec()),
            textbook: |x| some(textbook::normalize(all(x))),
            ours: |x| some(EvenMultivector::from(all(x)).normalize()?.to_array()),
        },
        Function {
            name: "EvenMultivector::normalize off the Study quadric",
            result: Shape::Motor,
            samples: samples::off_quadric,
            sizes: Sizes::OfMotorParts,
            reference: |x| Some(space::Motor::new(x).normalize()?.to_vec()),
            textbook: |x| some(textbook::normalize(all(x))),
            ours: |x| some(EvenMultivector::from(all(x)).normalize()?.to_array()),
        },
        Function {
            name: "Motor::renormalize",
            result: Shape::Motor,
            samples: samples::motors,
            sizes: Sizes::OfInputs,
            reference: |x| Some(space::Motor::new(x).normalize()?.to_vec()),
            textbook: |x| some(textbook::normalize(all(x))),
            ours: |x| some(Motor::from(all(x)).renormalize().to_array()),
        },
        Function {
            name: "Motor::nlerp",
            result: Shape::Motor,
            samples: samples::pairs,
            sizes: Sizes::OfInputs,
            reference: |x| {
                let (a, b, t) = pair::<_, 8>(x);
                Some(space::Motor::new(&a).nlerp(&space::Motor::new(&b), &t)?.to_vec())
            },
            textbook: |x| {
                let (a, b, t) = pair(x);
                some(textbook::nlerp(a, b, t))
            },
            ours: |x| {
                let (a, b, t) = pair::<_, 8>(x);
                some(Motor::from(a).nlerp(b.into(), t).to_array())
            },
        },
        Function {
            name: "Motor::slerp",
            result: Shape::Motor,
            samples: samples::pairs,
            sizes: Sizes::OfInputs,
            reference: |x| {
                let (a, b, t) = pair::<_, 8>(x);
                Some(space::Motor::new(&a).slerp(&space::Motor::new(&b), &t)?.to_vec())
            },
            textbook: |x| {
                let (a, b, t) = pair(x);
                some(textbook::slerp(a, b, t))
            },
            ours: |x| {
                let (a, b, t) = pair::<_, 8>(x);
                some(Motor::from(a).slerp(b.into(), t).to_array())
            },
        },
        Function {
            name: "Motor::screw_lerp",
            result: Shape::Motor,
            samples: samples::pairs,
            sizes: Sizes::OfInputs,
            reference: |x| {
                let (a, b, t) = pair::<_, 8>(x);
                Some(space::Motor::new(&a).screw_lerp(&space::Motor::new(&b), &t)?.to_vec())
            },
            textbook: |x| {
                let (a, b, t) = pair(x);
                some(textbook::screw_lerp(a, b, t))
            },
            ours: |x| {
                let (a, b, t) = pair::<_, 8>(x);
                some(Motor::from(a).screw_lerp(b.into(), t).to_array())
            },
        },
    ]
}

/// The functions of the plane.
pub(crate) fn plane<T: Float>() -> Vec<Function<T>> {
    vec![
        Function {
            name: "pga2d::Bivector::exp",
            result: Shape::PlaneMotor,
            samples: samples::bivectors,
            sizes: Sizes::OfInputs,
            reference: |x| Some(plane::Bivector::new(x).exp().to_vec()),
            textbook: |x| some(textbook::plane::exp(all(x))),
            ours: |x| some(pga2d::Bivector::from(all(x)).exp().to_array()),
        },
        Function {
            name: "pga2d::Bivector::exp_slice",
            result: Shape::PlaneMotor,
            samples: samples::bivectors,
            sizes: Sizes::OfInputs,
            reference: |x| Some(plane::Bivector::new(x).exp().to_vec()),
            textbook: |x| some(textbook::plane::exp(all(x))),
            ours: |x| {
                let mut motor = [pga2d::Motor::IDENTITY];
                pga2d::Bivector::exp_slice(&[all(x).into()], &mut motor).ok()?;
                some(motor[0].to_array())
            },
        },
        Function {
            name: "pga2d::Motor::log",
            result: Shape::Bivector,
            samples: samples::plane_motors,
            sizes: Sizes::OfInputs,
            reference: |x| Some(plane::Motor::new(x).log()?.to_vec()),
            textbook: |x| some(textbook::plane::log(textbook::short_way(all(x), x[0]))),
            ours: |x| some(pga2d::Motor::from(all(x)).log().to_array()),
        },
        Function {
            name: "pga2d::Motor::log_slice",
            result: Shape::Bivector,
            samples: samples::plane_motors,
            sizes: Sizes::OfInputs,
            reference: |x| Some(plane::Motor::new(x).log()?.to_vec()),
            textbook: |x| some(textbook::plane::log(textbook::short_way(all(x), x[0]))),
            ours: |x| {
                let mut bivector = [pga2d::Bivector::ZERO];
                pga2d::Motor::log_slice(&[all(x).into()], &mut bivector).ok()?;
                some(bivector[0].to_array())
            },
        },
        Function {
            name: "pga2d::Motor::log_double_cover",
            result: Shape::Bivector,
            samples: samples::plane_motors,
            sizes: Sizes::OfInputs,
            reference: |x| Some(plane::Motor::new(x).log_double_cover()?.to_vec()),
            textbook: |x| some(textbook::plane::log(all(x))),
            ours: |x| some(pga2d::Motor::from(all(x)).log_double_cover()?.to_array()),
        },
        Function {
            name: "pga2d::Motor::sqrt",
            result: Shape::PlaneMotor,
            samples: samples::plane_motors,
            sizes: Sizes::OfInputs,
            reference: |x| Some(plane::Motor::new(x).sqrt()?.to_vec()),
            textbook: |x| some(textbook::plane::sqrt(textbook::short_way(all(x), x[0]))),
            ours: |x| some(pga2d::Motor::from(all(x)).sqrt().to_array()),
        },
        Function {
            name: "pga2d::Motor::sqrt_double_cover",
            result: Shape::PlaneMotor,
            samples: samples::plane_motors,
            sizes: Sizes::OfInputs,
            reference: |x| Some(plane::Motor::new(x).sqrt_double_cover()?.to_vec()),
            textbook: |x| some(textbook::plane::sqrt(all(x))),
            ours: |x| some(pga2d::Motor::from(all(x)).sqrt_double_cover()?.to_array()),
        },
        Function {
            name: "pga2d::Motor::powf",
            result: Shape::PlaneMotor,
            samples: samples::plane_powers,
            sizes: Sizes::OfInputs,
            reference: |x| {
                let (m, t) = power::<_, 4>(x);
                Some(plane::Motor::new(&m).powf(&t)?.to_vec())
            },
            textbook: |x| {
                let (m, t) = power(x);
                some(textbook::plane::powf(m, t))
            },
            ours: |x| {
                let (m, t) = power::<_, 4>(x);
                some(pga2d::Motor::from(m).powf(t).to_array())
            },
        },
        Function {
            name: "pga2d::EvenMultivector::normalize",
            result: Shape::PlaneMotor,
            samples: samples::plane_evens,
            sizes: Sizes::OfInputs,
            reference: |x| Some(plane::Motor::new(x).normalize()?.to_vec()),
            textbook: |x| some(textbook::plane::normalize(all(x))),
            ours: |x| some(pga2d::EvenMultivector::from(all(x)).normalize()?.to_array()),
        },
        Function {
            name: "pga2d::Motor::renormalize",
            result: Shape::PlaneMotor,
            samples: samples::plane_motors,
            sizes: Sizes::OfInputs,
            reference: |x| Some(plane::Motor::new(x).normalize()?.to_vec()),
            textbook: |x| some(textbook::plane::normalize(all(x))),
            ours: |x| some(pga2d::Motor::from(all(x)).renormalize().to_array()),
        },
        Function {
            name: "pga2d::Motor::nlerp",
            result: Shape::PlaneMotor,
            samples: samples::plane_pairs,
            sizes: Sizes::OfInputs,
            reference: |x| {
                let (a, b, t) = pair::<_, 4>(x);
                Some(plane::Motor::new(&a).nlerp(&plane::Motor::new(&b), &t)?.to_vec())
            },
            textbook: |x| {
                let (a, b, t) = pair(x);
                some(textbook::plane::nlerp(a, b, t))
            },
            ours: |x| {
                let (a, b, t) = pair::<_, 4>(x);
                some(pga2d::Motor::from(a).nlerp(b.into(), t).to_array())
            },
        },
        Function {
            name: "pga2d::Motor::slerp",
            result: Shape::PlaneMotor,
            samples: samples::plane_pairs,
            sizes: Sizes::OfInputs,
            reference: |x| {
                let (a, b, t) = pair::<_, 4>(x);
                Some(plane::Motor::new(&a).slerp(&plane::Motor::new(&b), &t)?.to_vec())
            },
            textbook: |x| {
                let (a, b, t) = pair(x);
                some(textbook::plane::slerp(a, b, t))
            },
            ours: |x| {
                let (a, b, t) = pair::<_, 4>(x);
                some(pga2d::Motor::from(a).slerp(b.into(), t).to_array())
            },
        },
        Function {
            name: "pga2d::Motor::screw_lerp",
            result: Shape::PlaneMotor,
            samples: samples::plane_pairs,
            sizes: Sizes::OfInputs,
            reference: |x| {
                let (a, b, t) = pair::<_, 4>(x);
                Some(plane::Motor::new(&a).screw_lerp(&plane::Motor::new(&b), &t)?.to_vec())
            },
            textbook: |x| {
                let (a, b, t) = pair(x);
                some(textbook::plane::screw_lerp(a, b, t))
            },
            ours: |x| {
                let (a, b, t) = pair::<_, 4>(x);
                some(pga2d::Motor::from(a).screw_lerp(b.into(), t).to_array())
            },
        },
    ]
}
