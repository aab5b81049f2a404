//! Exact values, and laws that hold without rounding.

use super::*;
use crate::precision::in_both_precisions;

in_both_precisions! {
    numbers_are_what_they_are_called: constants;
    a_power_of_two_is_the_greatest_below: powers_of_two;
    quotients_by_zero_have_their_limit: quotients;
    functions_have_their_values_at_simple_arguments: functions;
    the_norm_of_three_and_four_is_five_at_every_magnitude: norms_of_two;
    the_norm_of_one_number_is_its_magnitude: norms_of_one;
    what_is_not_finite_has_no_finite_norm: norms_that_are_not_finite;
}

fn number<T: Real>(value: f64) -> T {
    T::from_f64(value)
}

/// 2 to an exponent, by products that are exact as long as the result is a number of the type, subnormal ones included.
fn two_to<T: Real>(exponent: i32) -> T {
    let factor = if exponent < 0 { T::from_ratio(1, 2) } else { T::from_ratio(2, 1) };
    (0..exponent.abs()).fold(T::ONE, |power, _| power * factor)
}

/// The exponents of the least subnormal number and of the greatest power of two.
fn exponents<T: Real>() -> (i32, i32) {
    if precision::<T>() == Precision::Single { (-149, 127) } else { (-1074, 1023) }
}

fn constants<T: Real + core::fmt::Debug>() {
    assert_eq!((T::ZERO.to_f64(), T::ONE.to_f64()), (0.0, 1.0));
    assert_eq!(T::from_ratio(-3, 4).to_f64(), -0.75);
    assert_eq!(T::from_ratio(1, 3), T::ONE / number(3.0));
    let half = T::from_ratio(1, 2);
    assert!(
        T::ONE + T::EPSILON > T::ONE && T::ONE + T::EPSILON * half == T::ONE,
        "the next number is one EPSILON away"
    );
    assert_eq!(T::PI, number(core::f64::consts::PI));
    assert_eq!(precision::<f32>(), Precision::Single);
    assert_eq!(precision::<f64>(), Precision::Double);
}

fn powers_of_two<T: Real + core::fmt::Debug>() {
    for (value, power) in [(1.0, 1.0), (5.0, 4.0), (-0.75, 0.5), (7.99, 4.0), (-8.0, 8.0)] {
        assert_eq!(number::<T>(value).power_of_two(), number(power));
    }
    let (least, greatest) = exponents::<T>();
    let top = two_to::<T>(greatest);
    assert_eq!((top * number(1.75)).power_of_two(), top);
    // A number has as many bits as the exponents of the least normal and of the least subnormal number are apart, and one.
    let least_normal = two_to::<T>(least) / T::EPSILON;
    for small in [T::ZERO, two_to(least), two_to::<T>(least) * number(-5.0), least_normal] {
        assert_eq!(small.power_of_two(), least_normal);
    }
}

fn quotients<T: Real + core::fmt::Debug>() {
    let (six, three, limit) = (number::<T>(6.0), number::<T>(3.0), number::<T>(7.0));
    assert_eq!(six.quotient(three, limit), number(2.0));
    assert_eq!(T::ZERO.quotient(three, limit), T::ZERO);
    assert_eq!((T::ZERO.quotient(T::ZERO, limit), six.quotient(T::ZERO, limit)), (limit, limit));
    assert!(!number::<T>(f64::INFINITY).quotient(T::ZERO, limit).is_finite());
    let nan = number::<T>(f64::NAN);
    assert!([nan.quotient(T::ZERO, limit), nan.quotient(three, limit), three.quotient(nan, limit)].iter().all(is_nan));
}

fn is_nan<T: Real>(value: &T) -> bool {
    value.to_f64().is_nan()
}

fn functions<T: Real + core::fmt::Debug>() {
    assert_eq!(number::<T>(6.25).sqrt(), number(2.5));
    assert!(is_nan(&number::<T>(-1.0).sqrt()));
    assert_eq!(T::ZERO.sin_cos(), (T::ZERO, T::ONE));
    let (sine, cosine) = (T::PI * T::from_ratio(1, 2)).sin_cos();
    assert!(sine == T::ONE && cosine.abs() <= T::EPSILON);
    assert_eq!(T::ZERO.atan2(T::ONE), T::ZERO);
    assert_eq!(T::ZERO.atan2(-T::ONE), T::PI);
    assert_eq!((-T::ONE).atan2(T::ZERO), -(T::PI * T::from_ratio(1, 2)));
    assert_eq!((number::<T>(-2.5).abs(), number::<T>(2.5).abs()), (number(2.5), number(2.5)));
    assert!(T::ONE.is_finite() && !number::<T>(f64::INFINITY).is_finite() && !number::<T>(f64::NAN).is_finite());
}

fn norms_of_two<T: Real + core::fmt::Debug>() {
    let (least, greatest) = exponents::<T>();
    for exponent in least..=greatest - 2 {
        let unit = two_to::<T>(exponent);
        let (three, four, five) = (unit * number(3.0), unit * number(4.0), unit * number(5.0));
        for components in [[three, four], [-four, three], [four, -three]] {
            assert_eq!(T::norm(components), five, "2^{exponent}");
        }
        // In three dimensions 1, 2, 2 has the length 3.
        assert_eq!(T::norm([unit, unit + unit, -(unit + unit)]), three, "2^{exponent}");
    }
    assert_eq!(T::norm([T::ZERO, T::ZERO]), T::ZERO);
    assert_eq!(T::norm([]), T::ZERO);
}

/// In binary floating point the root of a rounded square is the number itself, as long as the square is in the range: a
/// square of relative error u has a root of relative error u / 2 + O(u^2), and the number is the nearest there.
fn norms_of_one<T: Real + core::fmt::Debug>() {
    let (least, greatest) = exponents::<T>();
    for exponent in least + 60..greatest {
        for part in 1..40 {
            let number = two_to::<T>(exponent) * (T::ONE + T::from_ratio(part, 41));
            assert_eq!(T::norm([-number]), number, "2^{exponent} (1 + {part}/41)");
            assert_eq!(T::norm([T::ZERO, number, T::ZERO]), number, "2^{exponent} (1 + {part}/41)");
        }
    }
}

fn norms_that_are_not_finite<T: Real>() {
    let (nan, infinite) = (number::<T>(f64::NAN), number::<T>(f64::INFINITY));
    assert!(is_nan(&T::norm([T::ONE, nan])) && is_nan(&T::norm([nan, infinite])));
    assert!(T::norm([T::ONE, -infinite]) == infinite);
    let (_, greatest) = exponents::<T>();
    assert!(T::norm([two_to(greatest); 4]) == infinite, "the norm itself is beyond the range");
}

/// What four lanes give, as bits.
fn bits(value: impl Four<f32>) -> [u32; 4] {
    value.to_array().map(f32::to_bits)
}

#[test]
fn four_lanes_in_a_register_are_those_in_an_array() {
    let a = [1.5, -0.0, f32::MIN_POSITIVE / 4.0, -3e38];
    let b = [0.1, 7.0, -2.0, -3e38];
    let (x, y) = (<f32 as Scalar>::Four::new(a), <f32 as Scalar>::Four::new(b));
    let (p, q) = (Array4(a), Array4(b));
    assert_eq!((bits(x), bits(p)), (a.map(f32::to_bits), a.map(f32::to_bits)));
    assert_eq!(bits(x + y), bits(p + q));
    assert_eq!(bits(x - y), bits(p - q));
    assert_eq!(bits(x * y), bits(p * q));
    macro_rules! masks {
        ($method:ident $($mask:literal)*) => {
            $(assert_eq!(bits(x.$method::<$mask>()), bits(p.$method::<$mask>()), "{}", $mask);)*
        };
    }
    masks! { shuffle 0b11_10_01_00 0b00_01_10_11 0b00_11_10_01 0b01_01_11_10 0b00_00_00_00 0b11_11_11_11 }
    masks! { negate 0b0000 0b0001 0b0010 0b0100 0b1000 0b0111 0b1111 }
    assert_eq!(bits(p.shuffle::<0b00_11_10_01>()), [a[1], a[2], a[3], a[0]].map(f32::to_bits));
    assert_eq!(bits(p.negate::<0b0010>()), [a[0], -a[1], a[2], a[3]].map(f32::to_bits));
}

/// Every product with a packed kernel: its operator calls that one where four numbers at once are fast, and its scalar part, whose sign
/// decides which way is short, is rounded as by the scalar kernel.
#[test]
fn operators_call_what_is_fast() {
    use crate::{EvenMultivector, Motor, Rotor, kernels};

    let is_fast = <f32 as Scalar>::Four::IS_FAST;
    assert_eq!(is_fast, cfg!(target_arch = "x86_64"));
    let mut differ = 0;
    for i in 0..100 {
        let number = |k: usize| ((i * 37 + k * 101) as f32).sin();
        let (a, b) = (
            Motor::from(core::array::from_fn::<_, 8, _>(number)),
            Motor::from(core::array::from_fn::<_, 8, _>(|k| number(k + 8))),
        );
        let rotor = |m: Motor<f32>| Rotor::new(m.s, m.e23, m.e31, m.e12);
        let (even_a, even_b) = (EvenMultivector::from(a), EvenMultivector::from(b));
        macro_rules! check {
            ($a:expr, $b:expr, $packed:ident, $scalar:ident) => {
                let (packed, scalar) = (kernels::$packed($a, $b), kernels::$scalar($a, $b));
                differ += usize::from(packed != scalar);
                assert_eq!(packed.s, scalar.s);
                assert_eq!($a * $b, if is_fast { packed } else { scalar });
            };
        }
        check!(a, b, motor_mul_motor_packed, motor_mul_motor);
        check!(a, rotor(b), motor_mul_rotor_packed, motor_mul_rotor);
        check!(rotor(a), b, rotor_mul_motor_packed, rotor_mul_motor);
        check!(rotor(a), rotor(b), rotor_mul_rotor_packed, rotor_mul_rotor);
        check!(even_a, even_b, even_mul_even_packed, even_mul_even);
        let (a, b) = (a.map(f64::from), b.map(f64::from));
        assert_eq!(a * b, kernels::motor_mul_motor(a, b));
    }
    assert!(differ > 100, "numbers that tell the kernels apart");
}
