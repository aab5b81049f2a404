//! The closed forms of space in exact-to-sight arithmetic, written down independently of the kernels.
//!
//! A motor is s + b.(e23, e31, e12) + c.(e01, e02, e03) + p e0123, a line b and c alone. A function of motors is
//! continued to even multivectors near a motor by the formula that its comment states; that makes it a function of
//! independent coefficients, which rounded motors need and derivatives by one coefficient too.

use std::slice;

use crate::big::{Big, alternating_series, arctangent_rest_series, arctangent_series};

type Vector = [Big; 3];

#[derive(Clone, Debug)]
pub(crate) struct Line {
    pub(crate) b: Vector,
    pub(crate) c: Vector,
}

#[derive(Clone, Debug)]
pub(crate) struct Motor {
    pub(crate) s: Big,
    pub(crate) b: Vector,
    pub(crate) c: Vector,
    pub(crate) p: Big,
}

fn vector(coefficients: &[Big]) -> Vector {
    coefficients.to_vec().try_into().expect("three coefficients")
}

fn dot(a: &Vector, b: &Vector) -> Big {
    &a[0] * &b[0] + &a[1] * &b[1] + &a[2] * &b[2]
}

fn cross(a: &Vector, b: &Vector) -> Vector {
    [&a[1] * &b[2] - &a[2] * &b[1], &a[2] * &b[0] - &a[0] * &b[2], &a[0] * &b[1] - &a[1] * &b[0]]
}

fn times(factor: &Big, a: &Vector) -> Vector {
    a.each_ref().map(|a| factor * a)
}

/// The sum of multiples of vectors.
fn combine<const N: usize>(terms: [(&Big, &Vector); N]) -> Vector {
    let zero = [0.0, 0.0, 0.0].map(Big::from);
    terms.into_iter().fold(zero, |[x, y, z], (factor, [a, b, c])| [x + factor * a, y + factor * b, z + factor * c])
}

impl Line {
    pub(crate) fn new(coefficients: &[Big]) -> Self {
        Self { b: vector(&coefficients[..3]), c: vector(&coefficients[3..]) }
    }

    pub(crate) fn to_vec(&self) -> Vec<Big> {
        [&self.b[..], &self.c[..]].concat()
    }

    pub(crate) fn times(&self, factor: &Big) -> Self {
        Self { b: times(factor, &self.b), c: times(factor, &self.c) }
    }

    /// cos l + S b + (S c + mu g b) + mu S e0123 with l = |b|, mu = b.c, S = sin l / l, g = (cos l - S) / l^2.
    pub(crate) fn exp(&self) -> Motor {
        let Self { b, c } = self;
        let Circular { cos, sinc, g } = Circular::of_squared(&dot(b, b));
        let mu = dot(b, c);
        Motor { b: times(&sinc, b), c: combine([(&sinc, c), (&(&mu * g), b)]), p: mu * sinc, s: cos }
    }
}

/// The three functions of l that make an exponential.
struct Circular {
    cos: Big,
    sinc: Big,
    g: Big,
}

impl Circular {
    /// cos l - sin l / l loses twice the bits that l is below 1, so l below 2^-20 goes by power series. Beyond l = 2^100
    /// the bits are used up: there an error of u l in the half-angle is many turns, no digit of sin l means anything,
    /// and the measure asks for no more than finite coefficients of the right size.
    fn of_squared(squared: &Big) -> Self {
        if *squared < Big::power_of_two(-40) {
            let cos = alternating_series(squared, |n| f64::from((2 * n - 1) * (2 * n)));
            let sinc = alternating_series(squared, |n| f64::from((2 * n) * (2 * n + 1)));
            // The sum of (-1)^n l^(2n-2) 2n / (2n+1)! from n = 1: consecutive terms are l^2 / (2n (2n + 3)) apart.
            let g = alternating_series(squared, |n| f64::from(2 * n * (2 * n + 3))) / Big::from(-3.0);
            return Self { cos, sinc, g };
        }
        let l = squared.sqrt();
        let (sin, cos) = l.sin_cos();
        let sinc = sin / l;
        let g = (&cos - &sinc) / squared;
        Self { cos, sinc, g }
    }
}

/// k = atan2(|b|, s) / |b| and h = (1 - s k) / |b|^2; none for no rotation and s not positive.
///
/// 1 - s k cancels where |b| is small beside a positive s; with q = |b|^2 / s^2 both are series of the arctangent.
fn inverse_circular(s: &Big, squared: &Big) -> Option<(Big, Big)> {
    let s_squared = s.square();
    let upwards = !s.is_negative() && !s.is_zero();
    if upwards && *squared < &s_squared * Big::power_of_two(-40) {
        let q = squared / &s_squared;
        return Some((arctangent_series(&q) / s, arctangent_rest_series(&q) / s_squared));
    }
    if squared.is_zero() {
        return None;
    }
    let length = squared.sqrt();
    let k = length.atan2(s) / &length;
    let h = (Big::from(1.0) - s * &k) / squared;
    Some((k, h))
}

impl Motor {
    pub(crate) fn new(coefficients: &[Big]) -> Self {
        let [s, rest @ .., p] = coefficients else { panic!("eight coefficients") };
        let Line { b, c } = Line::new(rest);
        Self { s: s.clone(), b, c, p: p.clone() }
    }

    pub(crate) fn to_vec(&self) -> Vec<Big> {
        [slice::from_ref(&self.s), &self.b[..], &self.c[..], slice::from_ref(&self.p)].concat()
    }

    pub(crate) fn times(&self, factor: &Big) -> Self {
        Self { s: &self.s * factor, b: times(factor, &self.b), c: times(factor, &self.c), p: &self.p * factor }
    }

    pub(crate) fn reverse(&self) -> Self {
        let minus = Big::from(-1.0);
        Self { s: self.s.clone(), b: times(&minus, &self.b), c: times(&minus, &self.c), p: self.p.clone() }
    }

    pub(crate) fn plus(&self, other: &Self) -> Self {
        let one = Big::from(1.0);
        Self {
            s: &self.s + &other.s,
            b: combine([(&one, &self.b), (&one, &other.b)]),
            c: combine([(&one, &self.c), (&one, &other.c)]),
            p: &self.p + &other.p,
        }
    }

    /// The geometric product.
    pub(crate) fn geometric(&self, other: &Self) -> Self {
        let minus = Big::from(-1.0);
        let (m, n) = (self, other);
        let crossed = combine([(&minus, &cross(&m.b, &n.c)), (&minus, &cross(&m.c, &n.b))]);
        let from_pseudoscalars = combine([(&-&n.p, &m.b), (&-&m.p, &n.b)]);
        let one = Big::from(1.0);
        Self {
            s: &m.s * &n.s - dot(&m.b, &n.b),
            b: combine([(&m.s, &n.b), (&n.s, &m.b), (&minus, &cross(&m.b, &n.b))]),
            c: combine([(&m.s, &n.c), (&n.s, &m.c), (&one, &crossed), (&one, &from_pseudoscalars)]),
            p: &m.s * &n.p + &m.p * &n.s + dot(&m.b, &n.c) + dot(&m.c, &n.b),
        }
    }

    /// The motor or its negative, whichever has no negative scalar part.
    fn near_identity(&self) -> Self {
        if self.s.is_negative() { self.times(&Big::from(-1.0)) } else { self.clone() }
    }

    /// k b + (k c + p h b), for any even multivector.
    pub(crate) fn log_double_cover(&self) -> Option<Line> {
        let (k, h) = inverse_circular(&self.s, &dot(&self.b, &self.b))?;
        let slide = &self.s * dot(&self.b, &self.c) + &self.p * dot(&self.b, &self.b);
        let c = combine([(&k, &self.c), (&(slide * h), &self.b)]);
        Some(Line { b: times(&k, &self.b), c })
    }

    pub(crate) fn log(&self) -> Option<Line> {
        self.near_identity().log_double_cover()
    }

    /// (1 + m) (1 - p / (2 (1 + s)) e0123) / sqrt(2 (1 + s)), for any even multivector; 1 + s is b.b / (1 - s) where s
    /// is negative.
    pub(crate) fn sqrt_double_cover(&self) -> Option<Self> {
        let one = Big::from(1.0);
        let one_plus_s = if self.s.is_negative() { dot(&self.b, &self.b) / (&one - &self.s) } else { &one + &self.s };
        if one_plus_s.is_zero() {
            return None;
        }
        let doubled = &one_plus_s + &one_plus_s;
        let over_norm = one / doubled.sqrt();
        let slide = &self.p / doubled;
        let c = combine([(&Big::from(1.0), &self.c), (&slide, &self.b)]);
        let p = &self.p - slide * &one_plus_s;
        Some(Self { s: one_plus_s, b: self.b.clone(), c, p }.times(&over_norm))
    }

    pub(crate) fn sqrt(&self) -> Option<Self> {
        self.near_identity().sqrt_double_cover()
    }

    /// exp(t log m).
    pub(crate) fn powf(&self, t: &Big) -> Option<Self> {
        Some(self.log()?.times(t).exp())
    }

    /// m (1 - (s p - b.c) / a e0123) / sqrt(a) with a = s^2 + b.b; none for a = 0.
    pub(crate) fn normalize(&self) -> Option<Self> {
        let Self { s, b, c, p } = self;
        let squared = s.square() + dot(b, b);
        if squared.is_zero() {
            return None;
        }
        let slide = (s * p - dot(b, c)) / &squared;
        let c = combine([(&Big::from(1.0), c), (&slide, b)]);
        let on_quadric = Self { s: s.clone(), b: b.clone(), c, p: p - slide * s };
        Some(on_quadric.times(&(Big::from(1.0) / squared.sqrt())))
    }

    /// The rotors' scalar product s s' + b.b'.
    pub(crate) fn scalar_product(&self, other: &Self) -> Big {
        &self.s * &other.s + dot(&self.b, &other.b)
    }

    /// The other motor or its negative, whichever is nearer.
    fn nearer(&self, other: &Self) -> Self {
        if self.scalar_product(other).is_negative() { other.times(&Big::from(-1.0)) } else { other.clone() }
    }

    /// The sum of multiples of the two, made a motor.
    fn blend(&self, weight: &Big, other: &Self, other_weight: &Big) -> Option<Self> {
        self.times(weight).plus(&other.times(other_weight)).normalize()
    }

    /// a (1 - t) + b t, made a motor.
    pub(crate) fn nlerp(&self, other: &Self, t: &Big) -> Option<Self> {
        self.blend(&(Big::from(1.0) - t), &self.nearer(other), t)
    }

    /// a sin((1 - t) w) / sin w + b sin(t w) / sin w with the angle w between the rotors, made a motor.
    pub(crate) fn slerp(&self, other: &Self, t: &Big) -> Option<Self> {
        let near = self.nearer(other);
        let between = self.reverse().geometric(&near);
        let (k, _) = inverse_circular(&between.s, &dot(&between.b, &between.b))?;
        let squared = dot(&between.b, &between.b) * k.square();
        let sinc = |factor: &Big| Circular::of_squared(&(factor.square() * &squared)).sinc;
        let whole = sinc(&Big::from(1.0));
        let weight = |t: &Big| t * sinc(t) / &whole;
        self.blend(&weight(&(Big::from(1.0) - t)), &near, &weight(t))
    }

    /// a exp(t log(~a b)).
    pub(crate) fn screw_lerp(&self, other: &Self, t: &Big) -> Option<Self> {
        Some(self.geometric(&self.reverse().geometric(other).powf(t)?))
    }
}
