//! The polynomials in place of functions: their series by identities, their stated errors by sums of whole numbers.
//! That they are what `ga-codegen fit` computes is tested with the command line.

use ga_codegen::approximation::{Approximation, Function, Precision, approximation};
use ga_codegen::symbolic::{Overflow, Rational};
use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::Signed;

fn every() -> impl Iterator<Item = (Function, Precision, &'static Approximation)> {
    let both = |function| Precision::ALL.map(|precision| (function, precision, approximation(function, precision)));
    Function::ALL.into_iter().flat_map(both)
}

fn series(function: Function, n: u32) -> Rational {
    function.series(n).expect("a coefficient that fits")
}

fn times(factor: i64, value: Rational) -> Rational {
    value.checked_mul(Rational::integer(factor)).expect("a product that fits")
}

fn sum(a: Rational, b: Rational) -> Rational {
    a.checked_add(b).expect("a sum that fits")
}

// The series

#[test]
fn cos_root_and_sinc_root_are_over_factorials() {
    for n in 0..=8_i64 {
        let even = Rational::integer((1..=2 * n).product());
        let odd = Rational::integer((1..=2 * n + 1).product());
        let sign = Rational::integer(if n % 2 == 0 { 1 } else { -1 });
        assert_eq!(series(Function::CosRoot, n as u32).checked_mul(even), Ok(sign));
        assert_eq!(series(Function::SincRoot, n as u32).checked_mul(odd), Ok(sign));
    }
}

#[test]
fn sinc_slope_is_the_difference_over_the_argument_and_twice_the_derivative() {
    for n in 0..12 {
        let difference = sum(series(Function::CosRoot, n + 1), series(Function::SincRoot, n + 1).neg());
        assert_eq!(series(Function::SincSlope, n), difference);
        assert_eq!(series(Function::SincSlope, n), times(2 * i64::from(n + 1), series(Function::SincRoot, n + 1)));
    }
}

#[test]
fn angle_ratio_solves_its_differential_equation() {
    // (2x - x^2) k' = 1 - (1 - x) k, the coefficients of x^n.
    let k = |n: i64| u32::try_from(n).map_or(Rational::ZERO, |n| series(Function::AngleRatio, n));
    for n in 0..20 {
        let left = sum(times(2 * n, k(n)), times(1 - n, k(n - 1)));
        let one = if n == 0 { Rational::ONE } else { Rational::ZERO };
        assert_eq!(left, sum(one, sum(k(n).neg(), k(n - 1))), "{n}");
    }
}

#[test]
fn angle_slope_is_the_derivative_and_the_difference_over_the_square() {
    let (k, h) = (|n| series(Function::AngleRatio, n), |n| series(Function::AngleSlope, n));
    for n in 0..20 {
        assert_eq!(h(n), times(i64::from(n) + 1, k(n + 1)));
    }
    // (2x - x^2) h = 1 - (1 - x) k, where 2x - x^2 = 1 - s^2.
    for n in 1..20 {
        let before = if n == 1 { Rational::ZERO } else { h(n - 2).neg() };
        assert_eq!(sum(times(2, h(n - 1)), before), sum(k(n).neg(), k(n - 1)));
    }
}

#[test]
fn coefficients_that_do_not_fit_are_an_error() {
    for function in Function::ALL {
        assert!(function.series(10).is_ok());
        assert_eq!(function.series(100), Err(Overflow));
        assert_eq!(function.series(u32::MAX), Err(Overflow));
        assert_eq!(function.ratio(0).is_err(), function != Function::AngleRatio);
        assert!(function.ratio(u32::MAX).is_ok());
    }
}

// The polynomials

#[test]
fn at_0_a_polynomial_is_the_nearest_number_to_the_function() {
    for (function, precision, polynomial) in every() {
        let nearest = match (function, precision) {
            (Function::CosRoot | Function::SincRoot | Function::AngleRatio, _) => 1.0,
            (Function::SincSlope, Precision::F32) => f64::from(-1.0_f32 / 3.0),
            (Function::SincSlope, Precision::F64) => -1.0 / 3.0,
            (Function::AngleSlope, Precision::F32) => f64::from(1.0_f32 / 3.0),
            (Function::AngleSlope, Precision::F64) => 1.0 / 3.0,
        };
        assert_eq!(polynomial.coefficients[0], nearest, "{function:?} {precision:?}");
    }
}

#[test]
fn coefficients_for_f32_are_of_24_bits() {
    for function in Function::ALL {
        for &coefficient in approximation(function, Precision::F32).coefficients {
            assert_eq!(f64::from(coefficient as f32), coefficient, "{function:?}");
        }
    }
}

#[test]
fn the_degrees_are_those_that_kernels_are_planned_for() {
    let degrees: Vec<_> = every().map(|(.., polynomial)| polynomial.degree()).collect();
    assert_eq!(degrees, [5, 8, 4, 8, 4, 7, 9, 20, 11, 22]);
}

#[test]
fn errors_are_at_most_a_quarter_of_the_unit_roundoff_of_the_greatest_value() {
    for (function, precision, polynomial) in every() {
        let greatest = if function == Function::AngleRatio { std::f64::consts::FRAC_PI_2 } else { 1.0 };
        assert!(polynomial.error > 0.0 && polynomial.error <= greatest * precision.unit_roundoff() / 4.0);
    }
}

// Errors, in whole multiples of 2^-160. A value that is no multiple is rounded down.

const BITS: u32 = 160;

fn fixed(value: f64) -> BigInt {
    let value = BigRational::from_float(value).expect("a finite number");
    (value.numer() << BITS) / value.denom()
}

fn horner(coefficients: &[BigInt], argument: &BigInt) -> BigInt {
    coefficients.iter().rev().fold(BigInt::ZERO, |sum, coefficient| ((sum * argument) >> BITS) + coefficient)
}

/// The coefficients by closed formulas, up to x^90: what is beyond is below 2^-80 on every interval.
fn partial_sum(function: Function) -> Vec<BigInt> {
    let factorial = |n: u32| (1..=n).map(BigInt::from).product::<BigInt>();
    let over = |numerator: BigInt, denominator: BigInt| (numerator << BITS) / denominator;
    let sign = |n: u32| BigInt::from(if n.is_multiple_of(2) { 1 } else { -1 });
    let angle_ratio = |n: u32| over((factorial(n) * factorial(n)) << n, factorial(2 * n + 1));
    let coefficient = |n: u32| match function {
        Function::CosRoot => over(sign(n), factorial(2 * n)),
        Function::SincRoot => over(sign(n), factorial(2 * n + 1)),
        Function::SincSlope => over(sign(n + 1), factorial(2 * n + 2)) - over(sign(n + 1), factorial(2 * n + 3)),
        Function::AngleRatio => angle_ratio(n),
        Function::AngleSlope => angle_ratio(n + 1) * (n + 1),
    };
    (0..=90).map(coefficient).collect()
}

/// Points of the interval, denser towards its ends, with the ends.
fn points((low, high): (f64, f64)) -> Vec<BigInt> {
    let point = |i: u32| (low + high) / 2.0 - (high - low) / 2.0 * (std::f64::consts::PI * f64::from(i) / 500.0).cos();
    (1..500).map(point).chain([low, 0.0, high]).map(fixed).collect()
}

#[test]
fn no_polynomial_is_farther_from_its_function_than_it_says() {
    for function in Function::ALL {
        let sum = partial_sum(function);
        let values: Vec<_> = points(function.interval()).into_iter().map(|x| (horner(&sum, &x), x)).collect();
        for precision in Precision::ALL {
            let polynomial = approximation(function, precision);
            let coefficients: Vec<_> = polynomial.coefficients.iter().copied().map(fixed).collect();
            let errors = values.iter().map(|(value, x)| (horner(&coefficients, x) - value).abs());
            let greatest = errors.max().expect("errors");
            // The sum leaves out less than 2^-80, and no rounding counts beside that: they are some hundred of 2^-160.
            let bound = fixed(polynomial.error);
            assert!(greatest <= &bound + fixed(0.5_f64.powi(79)), "{function:?} {precision:?}");
            // The bound is no guess: it is nearly reached.
            assert!(greatest * 16 >= bound * 15, "{function:?} {precision:?}");
        }
    }
}

#[test]
fn polynomials_are_near_the_functions_of_the_standard_library() {
    for i in 1..=1000 {
        let near = |function: Function, x: f64, value: f64, tolerance: f64| {
            let coefficients = approximation(function, Precision::F64).coefficients;
            let found = coefficients.iter().rev().fold(0.0, |sum, coefficient| sum * x + coefficient);
            assert!((found - value).abs() <= tolerance, "{function:?} {x}: {found} {value}");
        };
        let (l, s) = (f64::from(i) * 0.0015, f64::from(1000 - i) * 0.001);
        let (cos, sinc, k) = (l.cos(), l.sin() / l, s.acos() / (1.0 - s * s).sqrt());
        // Arguments and values are rounded, by u, a few times; a quotient by l^2 or by 1 - s^2 magnifies that. So does
        // the root, as 1 - s^2 goes down to 2e-3.
        near(Function::CosRoot, l * l, cos, 1e-15);
        near(Function::SincRoot, l * l, sinc, 1e-15);
        near(Function::SincSlope, l * l, (cos - sinc) / (l * l), 1e-15 / (l * l));
        near(Function::AngleRatio, 1.0 - s, k, 1e-13);
        near(Function::AngleSlope, 1.0 - s, (1.0 - s * k) / (1.0 - s * s), 1e-13 / (1.0 - s * s));
    }
}
