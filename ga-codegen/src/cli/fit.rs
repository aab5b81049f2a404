//! Polynomials in place of the functions that exp and log are made of: `approximation/tables.rs`.
//!
//! A polynomial is that of minimax error (`exchange`), then rounded coefficient by coefficient (`rounding`); of several
//! degrees, the least that suffices is kept. All numbers have 256 bits, and no function of the platform's mathematics
//! library is called: the result is the same everywhere.

mod exchange;
mod linear;
mod number;
mod rounding;
mod sample;
mod tables;

use exchange::{Minimax, minimax};
use ga_codegen::approximation::{Function, Precision};
use number::{Number, exact, greatest, nearest, whole};
use sample::{Sample, Taylor, largest_error};
use std::path::Path;

/// The parts that Chebyshev points cut an interval into, for fits.
const COARSE: usize = 256;

/// The parts for measuring errors.
const FINE: usize = 1024;

/// Degrees from here on are not looked at.
const DEGREES: usize = 40;

/// A polynomial for a function in a precision, and how well it does. Errors are in units of the unit roundoff.
struct Fit {
    function: Function,
    precision: Precision,
    coefficients: Vec<f64>,
    /// Of the polynomial before its coefficients were rounded.
    minimax: f64,
    /// Of the polynomial: a bound.
    rounded: f64,
    /// Of its values by Horner's rule in the precision: the greatest one seen.
    horner: f64,
}

impl Fit {
    fn degree(&self) -> usize {
        self.coefficients.len() - 1
    }
}

/// Fits all polynomials, prints how well they do and writes them where there is a file.
pub(crate) fn run(output: Option<&Path>) -> Result<String, String> {
    let fits = fits()?;
    let report = report(&fits);
    let Some(path) = output else { return Ok(report) };
    std::fs::write(path, tables::text(&fits)).map_err(|error| format!("error: {}: {error}", path.display()))?;
    Ok(format!("{report}{}: {} polynomials\n", path.display(), fits.len()))
}

fn fits() -> Result<Vec<Fit>, String> {
    let mut fits = Vec::new();
    for function in Function::ALL {
        let taylor = Taylor::new(function).map_err(|error| format!("error: {}: {error}", function.name()))?;
        let fine = taylor.samples(FINE);
        let coarse: Vec<Sample> = fine.iter().step_by(FINE / COARSE).cloned().collect();
        let mut least = 2;
        for precision in Precision::ALL {
            let fit = (least..DEGREES).find_map(|degree| fit(&taylor, precision, degree, &coarse, &fine));
            let fit = fit.ok_or_else(|| {
                let (name, precision) = (function.name(), precision.name());
                format!("error: expected a polynomial of degree below {DEGREES} for {name} in {precision}, found none")
            })?;
            least = fit.degree();
            fits.push(fit);
        }
    }
    Ok(fits)
}

/// The polynomial of a degree, where its error is at most a quarter of the unit roundoff times the greatest value, where
/// that is above 1.
fn fit(taylor: &Taylor, precision: Precision, degree: usize, coarse: &[Sample], fine: &[Sample]) -> Option<Fit> {
    let unit = exact(precision.unit_roundoff());
    let limit = greatest(fine.iter().map(|sample| sample.value.clone())).max(whole(1)) * &unit / whole(4);
    let free = minimax(coarse, degree, None);
    if free.error > limit {
        return None;
    }
    let (target, coefficients) = rounded(taylor, precision, free, coarse);
    let polynomial: Vec<Number> = coefficients.iter().copied().map(exact).collect();
    let distance = taylor.distance(&polynomial, fine);
    let in_units = |error: Number| (error / &unit).to_f64().value();
    (distance <= limit).then(|| Fit {
        function: taylor.function,
        precision,
        minimax: in_units(target.error),
        rounded: in_units(distance),
        horner: in_units(evaluation_error(taylor, precision, &coefficients, fine)),
        coefficients,
    })
}

/// The better one of two polynomials with rounded coefficients, and what was rounded: the free minimax, or the one
/// whose constant is rounded already. Both have the constant that is nearest to the function at 0.
fn rounded(taylor: &Taylor, precision: Precision, free: Minimax, coarse: &[Sample]) -> (Minimax, Vec<f64>) {
    let constant = nearest(&taylor.value(&whole(0)), precision);
    let elsewhere: Vec<Sample> = coarse.iter().filter(|sample| sample.argument != whole(0)).cloned().collect();
    let pinned = minimax(&elsewhere, free.coefficients.len() - 1, Some(&exact(constant)));
    let rounded = |target: Minimax| {
        let coefficients = rounding::rounded(&target.coefficients, constant, precision, coarse);
        let error = largest_error(&coefficients.iter().copied().map(exact).collect::<Vec<_>>(), coarse);
        (error, target, coefficients)
    };
    let (pinned, free) = (rounded(pinned), rounded(free));
    let (_, target, coefficients) = if pinned.0 < free.0 { pinned } else { free };
    (target, coefficients)
}

/// The greatest error of Horner's rule in a precision, a rounding after every product and sum, at arguments in that
/// precision.
fn evaluation_error(taylor: &Taylor, precision: Precision, coefficients: &[f64], samples: &[Sample]) -> Number {
    let error = |sample: &Sample| {
        let argument = nearest(&sample.argument, precision);
        exact(evaluated(coefficients, argument, precision)) - taylor.value(&exact(argument))
    };
    greatest(samples.iter().map(error))
}

fn evaluated(coefficients: &[f64], argument: f64, precision: Precision) -> f64 {
    match precision {
        Precision::F32 => {
            let step = |sum: f32, coefficient: &f64| sum * argument as f32 + *coefficient as f32;
            f64::from(coefficients.iter().rev().fold(0.0, step))
        }
        Precision::F64 => coefficients.iter().rev().fold(0.0, |sum, coefficient| sum * argument + coefficient),
    }
}

fn report(fits: &[Fit]) -> String {
    let line = |fit: &Fit| {
        let (name, precision, degree) = (fit.function.name(), fit.precision.name(), fit.degree());
        let (low, high) = fit.function.interval();
        let interval = format!("[{low}, {high}]");
        format!(
            "{name:<11}  {precision}  {degree:>6}  {interval:<19}  {:>11.4}  {:>11.4}  {:>10.4}\n",
            fit.minimax, fit.rounded, fit.horner
        )
    };
    let header = format!(
        "{:<11}  {}  {}  {:<19}  {}  {}  {}\n",
        "function", "   ", "degree", "interval", "minimax / u", "rounded / u", "Horner / u"
    );
    header + &fits.iter().map(line).collect::<String>()
}
