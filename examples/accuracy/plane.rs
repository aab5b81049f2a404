//! The closed forms of the plane, likewise: a motor is s + w e12 + c.(e01, e20), a bivector w and c alone.

use std::slice;

use crate::big::Big;

#[derive(Clone, Debug)]
pub(crate) struct Bivector {
    pub(crate) w: Big,
    pub(crate) c: [Big; 2],
}

#[derive(Clone, Debug)]
pub(crate) struct Motor {
    pub(crate) s: Big,
    pub(crate) w: Big,
    pub(crate) c: [Big; 2],
}

fn times(factor: &Big, c: &[Big; 2]) -> [Big; 2] {
    c.each_ref().map(|c| factor * c)
}

/// sin w / w, and 1 at 0.
fn sinc(w: &Big) -> Big {
    if w.is_zero() { Big::from(1.0) } else { w.sin_cos().0 / w }
}

impl Bivector {
    pub(crate) fn new(coefficients: &[Big]) -> Self {
        let [w, x, y] = coefficients else { panic!("three coefficients") };
        Self { w: w.clone(), c: [x.clone(), y.clone()] }
    }

    pub(crate) fn to_vec(&self) -> Vec<Big> {
        [slice::from_ref(&self.w), &self.c[..]].concat()
    }

    pub(crate) fn times(&self, factor: &Big) -> Self {
        Self { w: factor * &self.w, c: times(factor, &self.c) }
    }

    /// cos w + sin w e12 + sin w / w c.
    pub(crate) fn exp(&self) -> Motor {
        let (sin, cos) = self.w.sin_cos();
        Motor { s: cos, w: sin, c: times(&sinc(&self.w), &self.c) }
    }
}

impl Motor {
    pub(crate) fn new(coefficients: &[Big]) -> Self {
        let [s, rest @ ..] = coefficients else { panic!("four coefficients") };
        let Bivector { w, c } = Bivector::new(rest);
        Self { s: s.clone(), w, c }
    }

    pub(crate) fn to_vec(&self) -> Vec<Big> {
        [&[self.s.clone(), self.w.clone()], &self.c[..]].concat()
    }

    pub(crate) fn times(&self, factor: &Big) -> Self {
        Self { s: &self.s * factor, w: &self.w * factor, c: times(factor, &self.c) }
    }

    pub(crate) fn reverse(&self) -> Self {
        Self { s: self.s.clone(), ..self.times(&Big::from(-1.0)) }
    }

    pub(crate) fn plus(&self, other: &Self) -> Self {
        let [x, y] = &self.c;
        let c = [x + &other.c[0], y + &other.c[1]];
        Self { s: &self.s + &other.s, w: &self.w + &other.w, c }
    }

    /// The geometric product: e12 e01 = e20 and e20 e12 = e01, and the other way round with the other sign.
    pub(crate) fn geometric(&self, other: &Self) -> Self {
        let (m, n) = (self, other);
        let ([mx, my], [nx, ny]) = (&m.c, &n.c);
        Self {
            s: &m.s * &n.s - &m.w * &n.w,
            w: &m.s * &n.w + &m.w * &n.s,
            c: [&m.s * nx + mx * &n.s - &m.w * ny + my * &n.w, &m.s * ny + my * &n.s + &m.w * nx - mx * &n.w],
        }
    }

    fn near_identity(&self) -> Self {
        if self.s.is_negative() { self.times(&Big::from(-1.0)) } else { self.clone() }
    }

    /// k w e12 + k c with k = atan2(w, s) / w; none for no rotation and s not positive.
    pub(crate) fn log_double_cover(&self) -> Option<Bivector> {
        let turned = self.w.abs();
        if turned.is_zero() {
            let upwards = !self.s.is_negative() && !self.s.is_zero();
            return upwards.then(|| Bivector { w: self.w.clone(), c: times(&(Big::from(1.0) / &self.s), &self.c) });
        }
        let k = turned.atan2(&self.s) / &turned;
        Some(Bivector { w: &self.w * &k, c: times(&k, &self.c) })
    }

    pub(crate) fn log(&self) -> Option<Bivector> {
        self.near_identity().log_double_cover()
    }

    /// (1 + m) / sqrt(2 (1 + s)); 1 + s is w^2 / (1 - s) where s is negative.
    pub(crate) fn sqrt_double_cover(&self) -> Option<Self> {
        let one = Big::from(1.0);
        let one_plus_s = if self.s.is_negative() { self.w.square() / (&one - &self.s) } else { &one + &self.s };
        if one_plus_s.is_zero() {
            return None;
        }
        let over_norm = one / (&one_plus_s + &one_plus_s).sqrt();
        Some(Self { s: one_plus_s, ..self.clone() }.times(&over_norm))
    }

    pub(crate) fn sqrt(&self) -> Option<Self> {
        self.near_identity().sqrt_double_cover()
    }

    /// exp(t log m).
    pub(crate) fn powf(&self, t: &Big) -> Option<Self> {
        Some(self.log()?.times(t).exp())
    }

    /// m / sqrt(s^2 + w^2); none for 0.
    pub(crate) fn normalize(&self) -> Option<Self> {
        let squared = self.s.square() + self.w.square();
        (!squared.is_zero()).then(|| self.times(&(Big::from(1.0) / squared.sqrt())))
    }

    /// The rotors' scalar product.
    pub(crate) fn scalar_product(&self, other: &Self) -> Big {
        &self.s * &other.s + &self.w * &other.w
    }

    fn nearer(&self, other: &Self) -> Self {
        if self.scalar_product(other).is_negative() { other.times(&Big::from(-1.0)) } else { other.clone() }
    }

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
        let angle = self.reverse().geometric(&near).log_double_cover()?.w;
        let whole = sinc(&angle);
        let weight = |t: &Big| t * sinc(&(t * &angle)) / &whole;
        self.blend(&weight(&(Big::from(1.0) - t)), &near, &weight(t))
    }

    /// a exp(t log(~a b)).
    pub(crate) fn screw_lerp(&self, other: &Self, t: &Big) -> Option<Self> {
        Some(self.geometric(&self.reverse().geometric(other).powf(t)?))
    }
}
