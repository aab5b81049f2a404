//! The measure: how far a result is from the exact one, in units of what any evaluation may be off by.
//!
//! Of each part of the result, the coefficients without e0 and those with it, by norm:
//!
//! ```text
//! |computed - exact| / (u (sum_i |x_i| |df/dx_i| + |f|) + smallest)
//! ```
//!
//! The sum is what rounding the inputs may cost, |f| what rounding the result may: together the error that a
//! backward-stable evaluation commits, with the unit roundoff u. Below the normal numbers a rounding is up to half the
//! smallest positive number, however small the result; four coefficients that are off by it are off by `smallest`.

use crate::big::Big;
use crate::float::Float;

/// A function in high precision; none where it has no value.
pub(crate) type Reference = fn(&[Big]) -> Option<Vec<Big>>;

/// Indices of coefficients.
pub(crate) type Part = std::ops::Range<usize>;

/// What the coefficients of a result are.
#[derive(Clone, Copy)]
pub(crate) enum Shape {
    /// s e23 e31 e12 e01 e02 e03 e0123
    Motor,
    /// e23 e31 e12 e01 e02 e03
    Line,
    /// s e12 e01 e20
    PlaneMotor,
    /// e12 e01 e20
    Bivector,
}

impl Shape {
    /// The part without e0 and the part with it.
    pub(crate) fn parts(self) -> [Part; 2] {
        match self {
            Self::Motor => [0..4, 4..8],
            Self::Line => [0..3, 3..6],
            Self::PlaneMotor => [0..2, 2..4],
            Self::Bivector => [0..1, 1..3],
        }
    }

    /// The bivector of the part without e0. Beside a scalar near 1 a small rotation has to be looked at by itself.
    fn rotation(self) -> Part {
        match self {
            Self::Motor => 1..4,
            Self::Line => 0..3,
            Self::PlaneMotor => 1..2,
            Self::Bivector => 0..1,
        }
    }
}

/// What rounding may change an input by, in units of the roundoff: |x_i| in the measure.
#[derive(Clone, Copy)]
pub(crate) enum Sizes {
    /// Its magnitude; of a subnormal one, which has been rounded to a multiple of the smallest number, that over u.
    OfInputs,
    /// The norm of the part of a motor in which it stands. For functions that take most of their input away, however
    /// large, and leave roundings of what they took.
    OfMotorParts,
}

impl Sizes {
    fn of<T: Float>(self, input: &[Big]) -> Vec<Big> {
        match self {
            Self::OfInputs => {
                let least = T::smallest() / T::roundoff();
                let size = |x: &Big| if x.is_zero() || x.abs() > least { x.abs() } else { least.clone() };
                input.iter().map(size).collect()
            }
            Self::OfMotorParts => {
                let sizes = Shape::Motor.parts().map(|part| vec![norm(&input[part.clone()]); part.len()]);
                sizes.concat()
            }
        }
    }
}

/// A value with its conditioning.
pub(crate) struct Exact {
    value: Vec<Big>,
    /// |x_i| df/dx_i for every input i.
    sensitivities: Vec<Vec<Big>>,
}

/// Errors of a result; infinite where it is missing, not finite, or there although there is no value.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Errors {
    /// In units of the attainable error: of the part without e0 and of the part with it.
    pub(crate) parts: [f64; 2],
    /// The same of the bivector without e0 alone.
    pub(crate) rotation: f64,
    /// Relative to the part's norm, beyond the rounding of the smallest numbers.
    pub(crate) relative: [f64; 2],
}

impl Errors {
    /// Of a result that is none.
    const WRONG: Self = Self { parts: [f64::INFINITY; 2], rotation: f64::INFINITY, relative: [f64::INFINITY; 2] };

    /// The larger ones.
    pub(crate) fn max(self, other: Self) -> Self {
        let larger = |a: [f64; 2], b: [f64; 2]| [a[0].max(b[0]), a[1].max(b[1])];
        Self {
            parts: larger(self.parts, other.parts),
            rotation: self.rotation.max(other.rotation),
            relative: larger(self.relative, other.relative),
        }
    }
}

impl Exact {
    /// The derivatives are difference quotients with steps of 2^-100 of the sizes: exact to about as much.
    pub(crate) fn of<T: Float>(reference: Reference, input: &[T], sizes: Sizes) -> Option<Self> {
        let step = Big::power_of_two(-100);
        let input: Vec<_> = input.iter().map(|x| x.to_big()).collect();
        let value = reference(&input)?;
        let mut sensitivities = Vec::new();
        for (i, size) in sizes.of::<T>(&input).iter().enumerate().filter(|(_, size)| !size.is_zero()) {
            let mut shifted = input.clone();
            shifted[i] = &shifted[i] + size * &step;
            let shifted = reference(&shifted)?;
            let quotient = |(shifted, value): (&Big, &Big)| (shifted - value) / &step;
            sensitivities.push(shifted.iter().zip(&value).map(quotient).collect());
        }
        Some(Self { value, sensitivities })
    }

    /// Whether the value, doubled for good measure, is a float.
    pub(crate) fn is_in_range<T: Float>(&self) -> bool {
        self.value.iter().all(|x| T::from_big(&(x * Big::from(2.0))).is_finite())
    }

    pub(crate) fn errors<T: Float>(&self, shape: Shape, computed: &[T]) -> Errors {
        if !computed.iter().all(|x| x.is_finite()) {
            return Errors::WRONG;
        }
        let difference: Vec<_> = computed.iter().zip(&self.value).map(|(x, exact)| x.to_big() - exact).collect();
        let in_units = |part: Part| (norm(&difference[part.clone()]) / self.attainable::<T>(part)).to_f64();
        Errors {
            parts: shape.parts().map(in_units),
            rotation: in_units(shape.rotation()),
            relative: shape.parts().map(|part| relative::<T>(&difference[part.clone()], &self.value[part])),
        }
    }

    fn attainable<T: Float>(&self, part: Part) -> Big {
        let of_inputs = self.sensitivities.iter().map(|derivative| norm(&derivative[part.clone()]));
        let sum = of_inputs.fold(norm(&self.value[part.clone()]), |sum, x| sum + x);
        sum * T::roundoff() + T::smallest()
    }
}

/// The errors of a result that is missing where it has no value.
pub(crate) fn errors<T: Float>(exact: Option<&Exact>, shape: Shape, computed: Option<&[T]>) -> Errors {
    match (exact, computed) {
        (Some(exact), Some(computed)) => exact.errors(shape, computed),
        (None, None) => Errors::default(),
        _ => Errors::WRONG,
    }
}

fn relative<T: Float>(difference: &[Big], value: &[Big]) -> f64 {
    let (error, value) = (norm(difference) - T::smallest(), norm(value));
    match (error.is_negative(), value.is_zero()) {
        (true, _) => 0.0,
        (false, true) => f64::INFINITY,
        (false, false) => (error / value).to_f64(),
    }
}

fn norm(coefficients: &[Big]) -> Big {
    coefficients.iter().fold(Big::from(0.0), |sum, x| sum + x.square()).sqrt()
}
