//! What the laws of space and of the plane have in common: one name for each operation, and the parts of each type.

use pga_motor::{Real, pga2d};
use std::fmt::Debug;
use std::ops::{Add, Mul, Neg};

/// The coefficients as scalar part, e0-free bivector or vector part, and e0-bearing part, filled up with zeros: errors
/// are measured in each by its Euclidean norm.
pub(crate) type Coefficients = [[f64; 4]; 3];

/// Something whose coefficients are in parts. Conversions are exact: `f64` holds every `f32`.
pub(crate) trait Parts: Copy + Debug + PartialEq {
    fn parts(self) -> Coefficients;
    fn from_parts(parts: Coefficients) -> Self;

    /// The norms of the parts.
    fn sizes(self) -> [f64; 3] {
        self.parts().map(f64::norm)
    }

    fn map_ideal(self, map: impl Fn(f64) -> f64) -> Self {
        let [scalar, euclidean, ideal] = self.parts();
        Self::from_parts([scalar, euclidean, ideal.map(map)])
    }

    fn has_nan(self) -> bool {
        self.parts().iter().flatten().any(|coefficient| coefficient.is_nan())
    }

    fn is_all_finite(self) -> bool {
        self.parts().iter().flatten().all(|coefficient| coefficient.is_finite())
    }
}

macro_rules! parts {
    ($($type:ty: [$($scalar:ident)*] [$($euclidean:ident)*] [$($ideal:ident)*];)*) => {
        $(
            impl<T: Real + Debug> Parts for $type {
                fn parts(self) -> Coefficients {
                    [
                        padded(&[$(self.$scalar.to_f64()),*]),
                        padded(&[$(self.$euclidean.to_f64()),*]),
                        padded(&[$(self.$ideal.to_f64()),*]),
                    ]
                }

                fn from_parts([scalar, euclidean, ideal]: Coefficients) -> Self {
                    let [$($scalar,)* ..] = scalar;
                    let [$($euclidean,)* ..] = euclidean;
                    let [$($ideal,)* ..] = ideal;
                    Self {
                        $($scalar: T::from_f64($scalar),)*
                        $($euclidean: T::from_f64($euclidean),)*
                        $($ideal: T::from_f64($ideal),)*
                    }
                }
            }
        )*
    };
}

fn padded(coefficients: &[f64]) -> [f64; 4] {
    let mut padded = [0.0; 4];
    padded[..coefficients.len()].copy_from_slice(coefficients);
    padded
}

parts! {
    pga_motor::Motor<T>: [s] [e23 e31 e12] [e01 e02 e03 e0123];
    pga_motor::EvenMultivector<T>: [s] [e23 e31 e12] [e01 e02 e03 e0123];
    pga_motor::Line<T>: [] [e23 e31 e12] [e01 e02 e03];
    pga_motor::UnitLine<T>: [] [e23 e31 e12] [e01 e02 e03];
    pga_motor::UnitPlane<T>: [] [e1 e2 e3] [e0];
    pga_motor::Point<T>: [] [] [x y z];
    pga2d::Motor<T>: [s] [e12] [e01 e20];
    pga2d::EvenMultivector<T>: [s] [e12] [e01 e20];
    pga2d::Bivector<T>: [] [e12] [e01 e20];
    pga2d::UnitLine<T>: [] [e1 e2] [e0];
    pga2d::Point<T>: [] [] [x y];
}

/// A scalar product as if in twice the precision: what rounding takes from each product and each sum is added at the
/// end (Ogita, Rump, Oishi 2005, Dot2).
fn dot(a: [f64; 5], b: [f64; 5]) -> f64 {
    let (mut sum, mut rest) = (0.0, 0.0);
    for (a, b) in a.into_iter().zip(b) {
        let product = a * b;
        let next: f64 = sum + product;
        let added = next - sum;
        rest += a.mul_add(b, -product) + ((sum - (next - added)) + (product - added));
        sum = next;
    }
    sum + rest
}

/// A way from one motion to another.
pub(crate) type Interpolation<M> = fn(M, M, <M as Motion>::Number) -> M;

/// A rigid motion, in space or in the plane.
pub(crate) trait Motion: Parts + Neg<Output = Self> + Mul<Output = Self> + 'static {
    type Number: Real + Debug;
    type Generator: Parts + Neg<Output = Self::Generator> + Add<Output = Self::Generator>;
    type Even: Parts;
    const IN_SPACE: bool;

    /// A generator of the given direction and moment. In the plane the direction is the weight, up to its sign.
    fn generator(direction: [f64; 3], moment: [f64; 3]) -> Self::Generator;
    /// Half a turn, of scalar part 0 exactly, about an axis of length 1 and with a moment of any direction: what of it
    /// is parallel to the axis is the slide.
    fn half_turn(axis: [f64; 3], moment: [f64; 3]) -> Self;
    /// This motion times the Study number scale (1 + study e0123); in the plane times the scale alone.
    fn scaled(self, scale: f64, study: f64) -> Self::Even;

    fn exp(generator: Self::Generator) -> Self;
    fn times(generator: Self::Generator, factor: f64) -> Self::Generator;
    fn log(self) -> Self::Generator;
    fn log_double_cover(self) -> Option<Self::Generator>;
    fn sqrt(self) -> Self;
    fn sqrt_double_cover(self) -> Option<Self>;
    fn powf(self, exponent: f64) -> Self;
    fn reverse(self) -> Self;
    fn renormalize(self) -> Self;
    fn normalize(even: Self::Even) -> Option<Self>;
    fn carry_motor(self, motor: Self) -> Self;
    fn carry_generator(self, generator: Self::Generator) -> Self::Generator;
    fn path_at(a: Self, b: Self, t: f64) -> Self;
    fn path_generator(a: Self, b: Self) -> Self::Generator;
    fn blend(inputs: &[(Self, f64)]) -> Option<Self>;
    fn interpolations() -> [(&'static str, Interpolation<Self>); 5];

    /// The unit of rounding.
    fn unit() -> f64 {
        Self::Number::EPSILON.to_f64() / 2.0
    }

    /// How far the square of the norm is from 1, and in space how far the motor is off the Study quadric.
    fn defects(self) -> [f64; 2] {
        let [[s, ..], [x, y, z, _], [u, v, w, p]] = self.parts();
        let study = if Self::IN_SPACE { dot([s, -x, -y, -z, 0.0], [p, u, v, w, 0.0]) } else { 0.0 };
        [dot([s, x, y, z, 1.0], [s, x, y, z, -1.0]), study]
    }

    /// The half-angle of the motion the short way, in \[0, pi/2\].
    fn half_angle(self) -> f64 {
        let [scalar, bivector, _] = self.sizes();
        bivector.atan2(scalar)
    }

    fn scalar(self) -> f64 {
        self.parts()[0][0]
    }
}

macro_rules! motion {
    ($($algebra:ident)::+, $generator:ident) => {
        type Number = T;
        type Generator = $($algebra)::+::$generator<T>;
        type Even = $($algebra)::+::EvenMultivector<T>;

        fn exp(generator: Self::Generator) -> Self {
            generator.exp()
        }
        fn times(generator: Self::Generator, factor: f64) -> Self::Generator {
            generator * T::from_f64(factor)
        }
        fn log(self) -> Self::Generator {
            self.log()
        }
        fn log_double_cover(self) -> Option<Self::Generator> {
            self.log_double_cover()
        }
        fn sqrt(self) -> Self {
            self.sqrt()
        }
        fn sqrt_double_cover(self) -> Option<Self> {
            self.sqrt_double_cover()
        }
        fn powf(self, exponent: f64) -> Self {
            self.powf(T::from_f64(exponent))
        }
        fn reverse(self) -> Self {
            self.reverse()
        }
        fn renormalize(self) -> Self {
            self.renormalize()
        }
        fn normalize(even: Self::Even) -> Option<Self> {
            even.normalize()
        }
        fn carry_motor(self, motor: Self) -> Self {
            self.transform_motor(motor)
        }
        fn carry_generator(self, generator: Self::Generator) -> Self::Generator {
            self >> generator
        }
        fn path_at(a: Self, b: Self, t: f64) -> Self {
            $($algebra)::+::ScrewPath::new(a, b).at(T::from_f64(t))
        }
        fn path_generator(a: Self, b: Self) -> Self::Generator {
            $($algebra)::+::ScrewPath::new(a, b).generator()
        }
        fn blend(inputs: &[(Self, f64)]) -> Option<Self> {
            let inputs: Vec<_> = inputs.iter().map(|&(motor, weight)| (motor, T::from_f64(weight))).collect();
            $($algebra)::+::blend(&inputs)
        }
        fn interpolations() -> [(&'static str, Interpolation<Self>); 5] {
            [
                ("nlerp", Self::nlerp),
                ("slerp", Self::slerp),
                ("screw_lerp", Self::screw_lerp),
                ("split_lerp", Self::split_lerp),
                ("log_lerp", Self::log_lerp),
            ]
        }
    };
}

impl<T: Real + Debug + 'static> Motion for pga_motor::Motor<T> {
    const IN_SPACE: bool = true;
    motion!(pga_motor, Line);

    fn generator([x, y, z]: [f64; 3], [u, v, w]: [f64; 3]) -> Self::Generator {
        Parts::from_parts([[0.0; 4], [x, y, z, 0.0], [u, v, w, 0.0]])
    }

    fn half_turn(axis: [f64; 3], moment: [f64; 3]) -> Self {
        let slide: f64 = axis.iter().zip(moment).map(|(a, m)| a * m).sum();
        let [x, y, z] = axis;
        let [u, v, w] = [0, 1, 2].map(|i| moment[i] - slide * axis[i]);
        Self::from_parts([[0.0; 4], [x, y, z, 0.0], [u, v, w, slide]]).renormalize()
    }

    fn scaled(self, scale: f64, study: f64) -> Self::Even {
        let zero = T::ZERO;
        let study = Self::Even::new(T::ONE, zero, zero, zero, zero, zero, zero, T::from_f64(study));
        Self::Even::from(self) * study * T::from_f64(scale)
    }
}

impl<T: Real + Debug + 'static> Motion for pga2d::Motor<T> {
    const IN_SPACE: bool = false;
    motion!(pga2d, Bivector);

    fn generator(direction: [f64; 3], [u, v, _]: [f64; 3]) -> Self::Generator {
        let weight = f64::norm(direction).copysign(direction[0]);
        Parts::from_parts([[0.0; 4], [weight, 0.0, 0.0, 0.0], [u, v, 0.0, 0.0]])
    }

    fn half_turn(axis: [f64; 3], [u, v, _]: [f64; 3]) -> Self {
        Self::from_parts([[0.0; 4], [1_f64.copysign(axis[0]), 0.0, 0.0, 0.0], [u, v, 0.0, 0.0]])
    }

    fn scaled(self, scale: f64, _: f64) -> Self::Even {
        Self::Even::from(self) * T::from_f64(scale)
    }
}
