//! How far what the laws compare may be apart: derived, by following the definitions of both sides of a law.
//!
//! An [`Estimate`] stands beside a value: how large its parts are, and how far each may be from what exact arithmetic
//! would have made of the samples. Its methods are named after the operations. Each takes the errors of its arguments
//! through a Lipschitz constant of the operation, adds what the operation itself commits, and says in its comment where
//! both come from. The estimates of both sides of a law added up are the tolerance of the law.
//!
//! Measured are the scalar part, the e0-free bivector part and the e0-bearing (ideal) part, each as a whole by its
//! Euclidean norm. So small rotations must keep their digits where the operation keeps them, and large translations may
//! spoil neither.
//!
//! With u the unit of rounding, exp, log and sqrt commit at most [`OWN`] times the attainable error
//! u (sum_i |x_i| |df/dx_i| + |f|) of each part; products and sandwiches what the documentation of the kernels states.
//! A sum over n coefficients is at most sqrt(n) times the norm: |x_1| + ... + |x_n| <= sqrt(n) |x|.
//!
//! These constants are bounds for the worst case, each of which is met at its own inputs, and they multiply along a
//! chain. So the more a law does in a row, the further below 1 is the largest ratio of an error to its tolerance that
//! the law prints: about a half for one operation, a fifth for two, a twentieth for screw_lerp of screw_lerp.
//!
//! Constants hold for quaternions with a nilpotent unit eps, which is what motors are: m = q + eps r with |q| = 1,
//! |x y| = |x| |y| for quaternions, and f(q + eps r) = f(q) + eps Df(q) r. So where L bounds the first and K the second
//! derivative of the e0-free part, an error d of q and e of r become L d, and L e + K |r| d.

use std::f64::consts::SQRT_2;

/// exp, log, sqrt: at most so many times the attainable error. The accuracy report finds up to 1.35.
const OWN: f64 = 2.0;

/// Of `motor_mul_motor`, in the e0-free part, and in the ideal part for that of the left and of the right factor: of each the
/// larger of the scalar and the packed kernel.
const PRODUCT: [f64; 3] = [6.8, 8.0, 14.6];

/// Of `motor_transform_line` and `motor_transform_motor`, in the same way.
const SANDWICH: [f64; 3] = [23.2, 45.6, 40.7];

/// Of `motor_translator`.
const TRANSLATOR: f64 = 6.8;

/// Of `translator_mul_rotor`.
const FOLLOWED: f64 = 4.7;

const SQRT_3: f64 = 1.732_050_807_568_877_3;

/// The sizes of a value and the errors of its parts: scalar, e0-free bivector, ideal.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Estimate {
    unit: f64,
    /// Of the e0-free part, and of the ideal part.
    size: [f64; 2],
    error: [f64; 3],
}

/// What is given, exactly.
pub(crate) fn exact(unit: f64, [scalar, bivector, ideal]: [f64; 3]) -> Estimate {
    Estimate { unit, size: [scalar.hypot(bivector), ideal], error: [0.0; 3] }
}

/// A bound from elsewhere, for the errors of the parts.
pub(crate) fn up_to(unit: f64, error: [f64; 3]) -> Estimate {
    Estimate { unit, size: [1.0, 0.0], error }
}

/// A sampled motor: the nearest exact unit motor is so far away.
///
/// Of an exponential, sine and cosine are of the same number, each off by u; a coefficient of the axis is off by 2.5 u
/// for the norm and u for the quotient, the product with the sine by u: the norm of (s, b) by 6 u. p = sin t and b.c =
/// sin^2 n.c + ... = sin t cos in the same way, with at most 18 roundings on numbers up to |r|. Half turns and products
/// are made unit again, which leaves no more.
pub(crate) fn motor(unit: f64, [scalar, bivector, ideal]: [f64; 3]) -> Estimate {
    let error = [6.0 * scalar, 6.0 * bivector, 18.0 * ideal].map(|units| units * unit);
    Estimate { unit, size: [1.0, ideal], error }
}

impl Estimate {
    pub(crate) fn error(self) -> [f64; 3] {
        self.error
    }

    pub(crate) fn unit(self) -> f64 {
        self.unit
    }

    pub(crate) fn ideal_size(self) -> f64 {
        self.size[1]
    }

    /// The e0-free part of a motor alone.
    pub(crate) fn rotor(self) -> Self {
        let [scalar, bivector, _] = self.error;
        Self { size: [1.0, 0.0], error: [scalar, bivector, 0.0], ..self }
    }

    /// The translation in motor = translator * rotor: the ideal part times the reverse of the e0-free part. The scalar
    /// part is 1 whatever the rounding.
    pub(crate) fn translator(self) -> Self {
        let (i, own) = (self.size[1], TRANSLATOR * self.unit);
        Self { size: [1.0, i], error: [0.0, 0.0, self.error[2] + i * (self.euclidean_error() + own)], ..self }
    }

    /// The rotation by a motor without an ideal part, followed by this translation.
    pub(crate) fn after(self, rotor: Self) -> Self {
        let (i, own) = (self.size[1], FOLLOWED * self.unit);
        let [scalar, bivector, _] = rotor.error;
        Self { error: [scalar, bivector, self.error[2] + i * (rotor.euclidean_error() + own)], ..self }
    }

    /// What products of small numbers lose where they are subnormal, whatever their size: some of the least number.
    pub(crate) fn underflow(self) -> f64 {
        8.0 * if self.unit < 1e-10 { f64::from_bits(1) } else { f64::from(f32::from_bits(1)) }
    }

    /// Of the e0-free part as a whole.
    fn euclidean_error(self) -> f64 {
        self.error[0].hypot(self.error[1])
    }

    /// The same value off by more, in all parts.
    pub(crate) fn off_by(self, euclidean: f64, ideal: f64) -> Self {
        self.off_by_parts([euclidean, euclidean, ideal])
    }

    /// The same value off by more, part by part.
    pub(crate) fn off_by_parts(self, more: [f64; 3]) -> Self {
        Self { error: [0, 1, 2].map(|part| self.error[part] + more[part]), ..self }
    }

    /// exp of a generator B = b + eps c with l = |b|. All derivatives of exp on quaternions without scalar part are at
    /// most 1, for exp'(B) V is the integral of e^(x B) V e^((1-x) B) over x in 0..1, and so on: L = K = 1. The scalar
    /// part cos l changes by sin l alone. |d(sin l b/l)/db_i| <= 1, and sum |b_i| <= sqrt(3) l.
    pub(crate) fn exp(self) -> Self {
        let ([l, i], [_, bivector, ideal]) = (self.size, self.error);
        let (sin, cos) = (l.sin().abs(), l.cos().abs());
        let own = OWN * self.unit;
        let error = [
            sin * bivector + own * (SQRT_3 * l * sin + cos),
            bivector + own * (SQRT_3 * l + sin),
            ideal + i * bivector + own * i * (SQRT_3 * l + SQRT_3 + 1.0),
        ];
        Self { size: [1.0, i], error, ..self }
    }

    /// log of a unit motor by at most half a turn, of half-angle h. b' = k b with k = h / sin h, at most pi/2, is the
    /// Lipschitz constant across the axis; along it dh = cos h d|b| - sin h ds. Of c' = k c + p g b with
    /// g = (1 - cos h k)/sin^2 h <= 1: k changes by |dk/ds| = 1 and |dk/d|b|| = t = (h - sin h cos h)/sin^2 h, which is
    /// at most pi/2; g b by at most t for s and 1 for b; so K |r| = sqrt(1 + t^2) (|c| + |p|) <= sqrt(2 (1 + t^2)) |r|.
    pub(crate) fn log(self, half_angle: f64) -> Self {
        let (h, i, [scalar, bivector, ideal]) = (half_angle, self.size[1], self.error);
        let (sin, cos) = h.sin_cos();
        let (k, t) = if h > 1e-4 { (h / sin, (h - sin * cos) / (sin * sin)) } else { (1.0, 0.0) };
        let second = SQRT_2 * t.hypot(1.0);
        let own = OWN * self.unit;
        let error = [
            0.0,
            k * bivector + sin * scalar + own * (cos * sin + (SQRT_3 + 1.0) * h),
            k * ideal + second * i * self.euclidean_error() + own * i * (3.0 * k + 2.0 * second),
        ];
        Self { size: [h, k * i], error, ..self }
    }

    /// The square root of a unit motor by at most half a turn, of half-angle h: (1 + m)/n with n = sqrt(2 (1 + s)),
    /// that is 2 cos(h/2). d/ds of s' = n/2 is 1/(2 n), of b' = b/n it is -b/n^3. Ideal part: c' = (c + b p/n^2)/n, p'
    /// = p/(2 n); with n >= sqrt(2), |b| <= 1: L^2 <= 1/2 + 1/8 + 1/8 = 3/4; derivatives by s and b of c', p' are at
    /// most |c|/n^3 + 3 |b| |p|/n^5, |p|/(2 n^3), and |p|/n^3 for each coefficient of b: K |r| <= 0.75 |r|.
    pub(crate) fn sqrt(self, half_angle: f64) -> Self {
        let (i, [scalar, bivector, ideal]) = (self.size[1], self.error);
        let (sin, cos) = half_angle.sin_cos();
        let n = 2.0 * (half_angle / 2.0).cos();
        let own = OWN * self.unit;
        let error = [
            scalar / (2.0 * n) + own * (cos / (2.0 * n) + n / 2.0),
            bivector / n + sin / n.powi(3) * scalar + own * sin * ((SQRT_3 + 1.0) / n + cos / n.powi(3)),
            0.87 * ideal + 0.75 * i * self.euclidean_error() + own * i * (3.0 * 0.87 + 2.0 * 0.75),
        ];
        Self { size: [1.0, i], error, ..self }
    }

    /// An even element over its norm e: a projection, over e, of errors in the e0-free part; likewise of those in the
    /// ideal part; and that projection turns with the e0-free part: L = 1/e, K |r| = sqrt(2) |r|/e^2. A coefficient is
    /// off by at most 2 u for the sum of squares, u for its root, u for the inverse and u for the product. t = (q .
    /// r)/e by 4 u for its terms, up to 4 for their sum and 4 for the inverse, 9 u |r|; t q has 7 u more, with the sum,
    /// the second inverse and product 13 u |r| and 5 u |r| for r itself.
    pub(crate) fn normalized(self) -> Self {
        let ([e, i], [scalar, bivector, ideal]) = (self.size, self.error);
        let size = i / e;
        let relative = scalar.hypot(bivector) / e;
        let euclidean = relative + 5.0 * self.unit;
        let ideal = ideal / e + SQRT_2 * size * relative + 18.0 * self.unit * size;
        Self { size: [1.0, size], error: [euclidean, euclidean, ideal], ..self }
    }

    /// The axis of a generator, or of a motor's bivector part, whose direction is `norm` long: of length 1, by the same
    /// estimate as [`Self::normalized`].
    pub(crate) fn axis(self, norm: f64) -> Self {
        let axis = Self { size: [norm, self.size[1]], error: [0.0, self.error[1], self.error[2]], ..self }.normalized();
        Self { error: [0.0, axis.error[1], axis.error[2]], ..axis }
    }

    /// x y: (q + eps r)(q' + eps r') = q q' + eps (r q' + q r').
    pub(crate) fn product(self, other: Self) -> Self {
        let ([e, i], [f, j]) = (self.size, other.size);
        let (d, g) = (self.euclidean_error(), other.euclidean_error());
        let (rest, ideal) = (self.error[2], other.error[2]);
        let [free, left, right] = PRODUCT.map(|units| units * self.unit);
        let euclidean = d * f + e * g + free * e * f;
        let ideal = rest * f + e * ideal + d * j + i * g + left * i * f + right * e * j;
        Self { size: [e * f, i * f + e * j], error: [euclidean, euclidean, ideal], ..self }
    }

    /// g x ~g for this unit motor g, of a generator or motor x whose direction is `norm` long: the scalar part stays,
    /// and 2 |r_g| |b| comes to the ideal part.
    pub(crate) fn carry(self, x: Self, norm: f64) -> Self {
        let (g, t) = (self.euclidean_error(), self.size[1]);
        let [free, left, right] = SANDWICH.map(|units| units * self.unit);
        let [scalar, bivector, ideal] = x.error;
        let size = x.size[1] + 2.0 * t * norm;
        let error = [
            scalar,
            bivector + (2.0 * g + free) * norm,
            ideal + 2.0 * (t * bivector + self.error[2] * norm + g * size) + left * t * norm + right * x.size[1],
        ];
        Self { size: [x.size[0], size], error, ..x }
    }

    /// Times a number, exact or rounded once.
    pub(crate) fn times(self, factor: f64) -> Self {
        let size = self.size.map(|size| size * factor.abs());
        let [scalar, bivector, ideal] = self.error.map(|error| error * factor.abs());
        let own = if factor.abs().log2().fract() == 0.0 { 0.0 } else { self.unit };
        let error = [scalar + own * size[0], bivector + own * size[0], ideal + own * size[1]];
        Self { size, error, ..self }
    }

    /// A sum, rounded once; of sizes at most `size`.
    pub(crate) fn plus(self, other: Self) -> Self {
        let size = [0, 1].map(|part| self.size[part] + other.size[part]);
        let own = [size[0], size[0], size[1]].map(|size| size * self.unit);
        let error = [0, 1, 2].map(|part| self.error[part] + other.error[part] + own[part]);
        Self { size, error, ..self }
    }

    /// The same value, when the e0-free part is known to be so long.
    pub(crate) fn of_norm(self, norm: f64) -> Self {
        Self { size: [norm, self.size[1]], ..self }
    }
}
