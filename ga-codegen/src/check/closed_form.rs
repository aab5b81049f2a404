//! exp, log, normalize and sqrt on the naive reference: closed forms, with a bound of their rounding errors.
//!
//! Let A be minus the scalar part of B B, l = sqrt(A), N = B B + A of square 0 and commuting with B, and C = cos l,
//! S = sin(l) / l. A power series f(B B) is f(-A) + f'(-A) N, so
//! ```text
//! exp B  = C + S N/2 + S B - (C - S) (N B/A)/2
//! log m  = k V - (1 - s k) (P V/A),            k = atan2(l, s) / l,
//! ```
//! the latter for a unit m = s + V + P, V of grade 2, with N = V V + A and P = s N/2 + A P, which a unit keeps; written
//! so, the size of P counts what N may have lost where m is unit only up to rounding. For the norm y ~y = A + N,
//! ```text
//! normalize y = (1 - N/(2 A)) y / sqrt(A),     sqrt m = normalize(1 + m) for a unit m.
//! ```
//!
//! # Bound
//!
//! A [`Running`] coefficient x errs by at most d u S, with its depth d and size S. So f(x) errs by |f'| d u S for the error
//! of x, to the first order, and by some c u |f| for what f itself rounds. Hence f(x) gets the depth d + c and the size
//! |f| + |f'| S. Here f is one of C, S, k, 1 / sqrt(A), and f' is replaced by a bound that holds for all arguments around x:
//! ```text
//! |dC/dA| = |S|/2 <= 1 / (2 max(1, l)),        |dS/dA| = |C - S|/(2 A) <= min(1/6, 1/A)
//! |dk/dA| = |s - k|/(2 A) <= (1 + k)/(2 A),    |dk/ds| = 1,    d(1/sqrt A)/dA = -(1/sqrt A)/(2 A)
//! ```
//! for s s + A = 1. What f rounds is a root, u l, which is 2 u A in A and so at most 2 u |f'| S; a sine, a cosine or an arc
//! tangent, to within one unit in the last place, 2 u; and a quotient, u: so c = 5 is enough for each. A quotient of two
//! running coefficients is bounded like a product. Sums and products are those of the reference.
//!
//! All this is worked out in `f64`, also for coarser coefficients.

use super::Coefficient;
use super::coefficient::{Running, map};
use super::undefined::DomainError;
use crate::kernel::Analytic;
use crate::reference::Multivector;

type Value = Multivector<Running<f64>>;

/// What a function of a running coefficient adds to its depth.
const ROUNDINGS: u32 = 5;

/// The function of an argument.
///
/// # Errors
/// An argument at which it has no value, coefficients that are no floating-point numbers.
pub(super) fn apply<T: Coefficient>(
    function: Analytic,
    argument: &Multivector<Running<T>>,
) -> Result<Multivector<Running<T>>, DomainError> {
    let wide = map(argument, |coefficient| Running {
        value: coefficient.value.to_f64().unwrap_or(f64::NAN),
        size: coefficient.size,
        depth: coefficient.depth,
    });
    let unit_roundoff = T::UNIT_ROUNDOFF;
    let value = match function {
        Analytic::Exp => exp(&wide)?,
        Analytic::Log => {
            check_unit(&wide, unit_roundoff)?;
            log(&wide)?
        }
        Analytic::Normalize => normalize(&wide, unit_roundoff)?,
        Analytic::Sqrt => {
            check_unit(&wide, unit_roundoff)?;
            let one = Multivector::scalar(wide.signature(), Running::exact(1.0));
            normalize(&one.add(&wide), unit_roundoff)?
        }
    };
    let is_finite = |coefficient: &Running<f64>| coefficient.value.is_finite() && coefficient.size.is_finite();
    if !value.blades().iter().all(|(_, coefficient)| is_finite(coefficient)) {
        return Err(DomainError::Range);
    }
    Ok(map(&value, |coefficient| Running {
        value: T::from_f64(coefficient.value).unwrap_or_else(|| T::from(0)),
        size: coefficient.size,
        depth: coefficient.depth + 1,
    }))
}

/// exp B of a bivector.
fn exp(bivector: &Value) -> Result<Value, DomainError> {
    if let Some((blade, _)) = grades(bivector, |grade| grade != 2).blades().into_iter().next() {
        return Err(DomainError::Bivector { blade });
    }
    let square = self_reverse(&bivector.geometric(bivector));
    let (a, n) = study(&square.neg(), bivector)?;
    let n = n.neg();
    let l = a.value.sqrt();
    let (sin, cos) = l.sin_cos();
    let sinc = if l == 0.0 { 1.0 } else { sin / l };
    let (cos_slope, sinc_slope) = (0.5 / l.max(1.0), (1.0 / 6.0_f64).min(1.0 / a.value));
    let c = image(cos, cos_slope * a.size, a.depth);
    let s = image(sinc, sinc_slope * a.size, a.depth);
    let half = Running::exact(0.5);
    let plain = scalar(bivector, c.clone()).add(&n.scale(s.clone() * half.clone())).add(&bivector.scale(s.clone()));
    if a.value == 0.0 {
        return Ok(plain);
    }
    Ok(plain.sub(&over(&n.geometric(bivector), &a).scale((c - s) * half)))
}

/// log m of a unit.
fn log(m: &Value) -> Result<Value, DomainError> {
    let (s, v) = (m.coefficient("1"), m.grade(2));
    let p = grades(m, |grade| grade != 0 && grade != 2);
    check_nilpotent(&p, &v)?;
    let (a, n) = study(&self_reverse(&v.geometric(&v)).neg(), &v)?;
    let n = n.neg();
    if a.value == 0.0 {
        return if s.value < 0.0 { Err(DomainError::Branch) } else { Ok(v) };
    }
    let l = a.value.sqrt();
    let ratio = l.atan2(s.value) / l;
    let k = image(ratio, 0.5 * (1.0 + ratio) * (a.size / a.value) + s.size, a.depth.max(s.depth));
    let p = n.scale(s.clone() * Running::exact(0.5)).add(&p.scale(a.clone()));
    let h = Running::exact(1.0) - s * k.clone();
    Ok(v.scale(k).sub(&over(&p.geometric(&v), &a).scale(h)))
}

/// y over the root of its norm.
fn normalize(y: &Value, unit_roundoff: f64) -> Result<Value, DomainError> {
    let (a, n) = study(&self_reverse(&y.geometric(&y.reverse())), y).map_err(|error| match error {
        DomainError::Hyperbolic => DomainError::Norm,
        other => other,
    })?;
    // Below that, a square has lost digits to underflow.
    let least = f64::MIN_POSITIVE / f64::EPSILON;
    if a.value - doubt(&a, unit_roundoff) <= least {
        return Err(DomainError::Norm);
    }
    let inverse = 1.0 / a.value.sqrt();
    let inverse = image(inverse, 0.5 * inverse * (a.size / a.value), a.depth);
    let half = Running::exact(0.5);
    Ok(y.scale(inverse.clone()).sub(&over(&n.geometric(y), &a).scale(inverse * half)))
}

/// How far a coefficient is known: as far as an answer may be off.
fn doubt(coefficient: &Running<f64>, unit_roundoff: f64) -> f64 {
    4.0 * f64::from(coefficient.depth) * unit_roundoff * coefficient.size
}

/// That m ~m is 1, as far as that can be known.
fn check_unit(m: &Value, unit_roundoff: f64) -> Result<(), DomainError> {
    let square = self_reverse(&m.geometric(&m.reverse()));
    let difference = square.sub(&scalar(m, Running::exact(1.0)));
    for (blade, coefficient) in difference.blades() {
        let allowed = doubt(&coefficient, unit_roundoff);
        // NaN is no unit either.
        let is_small = coefficient.value.abs() <= allowed;
        if !is_small {
            return Err(DomainError::Unit { blade });
        }
    }
    Ok(())
}

/// The scalar part and the rest of a square or norm, where the rest squares to 0 and commutes with what was squared. The
/// scalar part is not negative.
fn study(square: &Value, of: &Value) -> Result<(Running<f64>, Value), DomainError> {
    let a = square.coefficient("1");
    let n = grades(square, |grade| grade != 0);
    check_nilpotent(&n, of)?;
    if !a.value.is_finite() {
        return Err(DomainError::Range);
    }
    if a.value < 0.0 { Err(DomainError::Hyperbolic) } else { Ok((a, n)) }
}

/// That n squares to 0 and commutes with another, whatever their coefficients are.
fn check_nilpotent(n: &Value, with: &Value) -> Result<(), DomainError> {
    let units = |value: &Value| -> Vec<Multivector<i64>> {
        let unit = |(word, _)| Multivector::from_blades(value.signature(), [(word, 1)]);
        value.blades().into_iter().map(unit).collect::<Result<_, _>>().expect("invariant: words of the signature")
    };
    let (n, with) = (units(n), units(with));
    let is_nilpotent = n.iter().all(|a| n.iter().all(|b| a.geometric(b).blades().is_empty()));
    let commutes = n.iter().all(|a| with.iter().all(|b| a.geometric(b) == b.geometric(a)));
    if is_nilpotent && commutes { Ok(()) } else { Err(DomainError::ClosedForm) }
}

/// The parts of these grades. A difference would not do, whose coefficients keep their sizes.
fn grades(value: &Value, keep: impl Fn(usize) -> bool) -> Value {
    let grades = (0..=value.signature().dimension()).filter(|&grade| keep(grade));
    grades.map(|grade| value.grade(grade)).fold(Multivector::zero(value.signature()), |sum, part| sum.add(&part))
}

/// The grades that reversion keeps: of a multivector that is its own reverse, the others are 0 but for rounding.
fn self_reverse(value: &Value) -> Value {
    grades(value, |grade| grade % 4 < 2)
}

fn scalar(like: &Value, value: Running<f64>) -> Value {
    Multivector::scalar(like.signature(), value)
}

/// A function's value, where its slope times the size of the argument is this.
fn image(value: f64, slope_size: f64, depth: u32) -> Running<f64> {
    Running { value, size: value.abs() + slope_size, depth: depth + ROUNDINGS }
}

/// Every coefficient over a number that is not 0.
fn over(value: &Value, divisor: &Running<f64>) -> Value {
    map(value, |coefficient| Running {
        value: coefficient.value / divisor.value,
        size: (coefficient.size / divisor.value) * (divisor.size / divisor.value),
        depth: coefficient.depth + divisor.depth + 1,
    })
}
