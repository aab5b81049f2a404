//! What many libraries do instead, for comparison: the formulas as textbooks print them, with a threshold where they
//! would divide by 0.
//!
//! Coefficients stand in the order of the motors, s e23 e31 e12 e01 e02 e03 e0123 or s e12 e01 e20, and of the lines,
//! e23 e31 e12 e01 e02 e03 or e12 e01 e20.

use pga_motor::pga2d;

use crate::float::Float;

/// Rotations below this are taken for none.
const THRESHOLD: f64 = 1e-5;

/// Rotors with a scalar product above this are interpolated linearly.
const NEARLY_EQUAL: f64 = 0.9995;

fn dot<T: Float, const N: usize>(a: [T; N], b: [T; N]) -> T {
    a.into_iter().zip(b).fold(T::ZERO, |sum, (a, b)| sum + a * b)
}

fn times<T: Float, const N: usize>(factor: T, a: [T; N]) -> [T; N] {
    a.map(|a| factor * a)
}

fn plus<T: Float, const N: usize>(a: [T; N], b: [T; N]) -> [T; N] {
    std::array::from_fn(|i| a[i] + b[i])
}

/// The exponential, of a rotation above the threshold; 1 + B below it.
pub(crate) fn exp<T: Float>([x, y, z, u, v, w]: [T; 6]) -> [T; 8] {
    let (b, c) = ([x, y, z], [u, v, w]);
    let length = dot(b, b).sqrt();
    if length.to_f64() < THRESHOLD {
        return [T::ONE, x, y, z, u, v, w, T::ZERO];
    }
    let (sin, cos) = length.sin_cos();
    let (over_length, slide) = (sin / length, dot(b, c) / length);
    let axis = times(T::ONE / length, b);
    let moment = plus(c, times(-slide, axis));
    let [x, y, z] = times(over_length, b);
    let [u, v, w] = plus(times(over_length, moment), times(slide * cos, axis));
    [cos, x, y, z, u, v, w, slide * sin]
}

/// The logarithm by the inverse cosine.
pub(crate) fn log<T: Float>([s, x, y, z, u, v, w, p]: [T; 8]) -> [T; 6] {
    if T::ONE - s * s <= T::ZERO {
        return [T::ZERO, T::ZERO, T::ZERO, u, v, w];
    }
    let sin_squared = T::ONE - s * s;
    let k = s.acos() / sin_squared.sqrt();
    let h = (T::ONE - s * k) / sin_squared;
    let ([x, y, z], [u, v, w]) = (times(k, [x, y, z]), plus(times(k, [u, v, w]), times(p * h, [x, y, z])));
    [x, y, z, u, v, w]
}

/// The motor over the norm of its rotor; the Study quadric is left to chance.
pub(crate) fn normalize<T: Float>(motor: [T; 8]) -> [T; 8] {
    let [s, x, y, z, ..] = motor;
    times(T::ONE / dot([s, x, y, z], [s, x, y, z]).sqrt(), motor)
}

/// 1 + m, normalised.
pub(crate) fn sqrt<T: Float>([s, rest @ ..]: [T; 8]) -> [T; 8] {
    let [x, y, z, u, v, w, p] = rest;
    normalize([T::ONE + s, x, y, z, u, v, w, p])
}

pub(crate) fn powf<T: Float>(motor: [T; 8], t: T) -> [T; 8] {
    exp(times(t, log(short_way(motor, motor[0]))))
}

/// The motor or its negative, depending on the sign of a scalar product.
pub(crate) fn short_way<T: Float, const N: usize>(motor: [T; N], product: T) -> [T; N] {
    if product < T::ZERO { times(-T::ONE, motor) } else { motor }
}

fn near<T: Float>(a: [T; 8], b: [T; 8]) -> [T; 8] {
    short_way(b, rotors_product(a, b))
}

fn rotors_product<T: Float>([a, b, c, d, ..]: [T; 8], [e, f, g, h, ..]: [T; 8]) -> T {
    dot([a, b, c, d], [e, f, g, h])
}

pub(crate) fn nlerp<T: Float>(a: [T; 8], b: [T; 8], t: T) -> [T; 8] {
    normalize(plus(times(T::ONE - t, a), times(t, near(a, b))))
}

/// Weights by the inverse cosine, and no Study quadric.
pub(crate) fn slerp<T: Float>(a: [T; 8], b: [T; 8], t: T) -> [T; 8] {
    let near = near(a, b);
    match arc_weights(rotors_product(a, near), t) {
        Some((of_a, of_b)) => plus(times(of_a, a), times(of_b, near)),
        None => nlerp(a, b, t),
    }
}

/// The weights of two rotors with the given scalar product; none where they are nearly equal.
fn arc_weights<T: Float>(product: T, t: T) -> Option<(T, T)> {
    if product.to_f64() > NEARLY_EQUAL {
        return None;
    }
    let angle = product.acos();
    let sin = |angle: T| angle.sin_cos().0;
    Some((sin((T::ONE - t) * angle) / sin(angle), sin(t * angle) / sin(angle)))
}

pub(crate) fn screw_lerp<T: Float>(a: [T; 8], b: [T; 8], t: T) -> [T; 8] {
    let [a, b] = [a, b].map(pga_motor::Motor::from);
    (a * pga_motor::Motor::from(powf((a.reverse() * b).to_array(), t))).to_array()
}

/// The same in the plane.
pub(crate) mod plane {
    use super::*;

    pub(crate) fn exp<T: Float>([w, x, y]: [T; 3]) -> [T; 4] {
        if w.abs().to_f64() < THRESHOLD {
            return [T::ONE, w, x, y];
        }
        let (sin, cos) = w.sin_cos();
        let [x, y] = times(sin / w, [x, y]);
        [cos, sin, x, y]
    }

    pub(crate) fn log<T: Float>([s, w, x, y]: [T; 4]) -> [T; 3] {
        let sin_squared = T::ONE - s * s;
        if sin_squared <= T::ZERO {
            return [T::ZERO, x, y];
        }
        times(s.acos() / sin_squared.sqrt(), [w, x, y])
    }

    pub(crate) fn normalize<T: Float>(motor: [T; 4]) -> [T; 4] {
        let [s, w, ..] = motor;
        times(T::ONE / dot([s, w], [s, w]).sqrt(), motor)
    }

    pub(crate) fn sqrt<T: Float>([s, w, x, y]: [T; 4]) -> [T; 4] {
        normalize([T::ONE + s, w, x, y])
    }

    pub(crate) fn powf<T: Float>(motor: [T; 4], t: T) -> [T; 4] {
        exp(times(t, log(short_way(motor, motor[0]))))
    }

    fn rotors_product<T: Float>([a, b, ..]: [T; 4], [c, d, ..]: [T; 4]) -> T {
        a * c + b * d
    }

    pub(crate) fn nlerp<T: Float>(a: [T; 4], b: [T; 4], t: T) -> [T; 4] {
        let near = short_way(b, rotors_product(a, b));
        normalize(plus(times(T::ONE - t, a), times(t, near)))
    }

    pub(crate) fn slerp<T: Float>(a: [T; 4], b: [T; 4], t: T) -> [T; 4] {
        let near = short_way(b, rotors_product(a, b));
        match arc_weights(rotors_product(a, near), t) {
            Some((of_a, of_b)) => plus(times(of_a, a), times(of_b, near)),
            None => nlerp(a, b, t),
        }
    }

    pub(crate) fn screw_lerp<T: Float>(a: [T; 4], b: [T; 4], t: T) -> [T; 4] {
        let [a, b] = [a, b].map(pga2d::Motor::from);
        (a * pga2d::Motor::from(powf((a.reverse() * b).to_array(), t))).to_array()
    }
}
