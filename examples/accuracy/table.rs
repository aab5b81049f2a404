//! The errors as tables.

use std::collections::BTreeMap;
use std::f64::consts::{FRAC_PI_2, PI};
use std::fmt::Write;

use crate::float::Float;
use crate::functions::{self, Function};
use crate::report::{self, Pair};

/// Every function with its largest errors by decade of half-angle.
pub(crate) fn by_decade<T: Float>() -> String {
    measured::<T>().iter().map(decades_of).collect()
}

fn measured<T: Float>() -> Vec<Function<T>> {
    functions::space().into_iter().chain(functions::plane()).collect()
}

/// Half-angles that stand in one line; decades by their exponents.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum Row {
    Zero,
    Decade(i32),
    /// A neighbour of the half turn: half-angle pi/2.
    HalfTurn,
    /// The decade of the distance from the whole turn, half-angle pi, where the motor is -1.
    BesideWholeTurn(i32),
    Beyond(i32),
    All,
}

impl Row {
    fn of(half_angle: f64) -> Self {
        // A power of ten rounded down to a float belongs to the decade above.
        let decade = |x: f64| (x.log10() + 1e-6).floor() as i32;
        match half_angle {
            0.0 => Self::Zero,
            x if (x - FRAC_PI_2).abs() < 1e-6 => Self::HalfTurn,
            x if x < FRAC_PI_2 => Self::Decade(decade(x)),
            // Half-angles from 2.1 to the float beyond pi.
            x if x < PI + 1e-6 => Self::BesideWholeTurn(decade((PI - x).abs().max(f64::EPSILON))),
            x => Self::Beyond(decade(x)),
        }
    }

    fn name(self) -> String {
        match self {
            Self::Zero => "0".to_owned(),
            Self::Decade(exponent) | Self::Beyond(exponent) => format!("1e{exponent}"),
            Self::HalfTurn => "pi/2".to_owned(),
            Self::BesideWholeTurn(exponent) => format!("pi -+ 1e{exponent}"),
            Self::All => "all".to_owned(),
        }
    }
}

const HEADER: &str = "\
              errors in units of the attainable                       relative errors
              ours                 textbook                           ours                 textbook
half-angle     without e0   with e0   without e0   with e0              without e0   with e0   without e0   with e0
";

fn decades_of<T: Float>(function: &Function<T>) -> String {
    let errors = report::errors(function);
    let mut rows = BTreeMap::<Row, Pair>::new();
    for (sample, pair) in &errors {
        for row in [Row::of(sample.half_angle), Row::All] {
            let largest = rows.entry(row).or_default();
            *largest = largest.max(*pair);
        }
    }
    let mut text = format!("{}, {}, {} samples\n{HEADER}", function.name, T::NAME, errors.len());
    text.extend(rows.into_iter().map(|(row, largest)| line(&row.name(), largest)));
    text + "\n"
}

fn line(name: &str, Pair { ours, textbook }: Pair) -> String {
    let mut text = format!("{name:<15}");
    for (errors, width) in [(ours.parts, 10), (textbook.parts, 13), (ours.relative, 24), (textbook.relative, 13)] {
        let [without, with] = errors.map(number);
        write!(text, "{without:>width$}{with:>10}").expect("text takes everything");
    }
    text + "\n"
}

/// Errors to two digits; a missing or infinite result has no number.
fn number(error: f64) -> String {
    match error {
        0.0 => "0".to_owned(),
        0.01..100.0 => format!("{error:.2}"),
        _ if error.is_finite() => format!("{error:.1e}"),
        _ => "wrong".to_owned(),
    }
}

/// The largest errors of each function over all half-angles, as a table in Markdown.
pub(crate) fn summary() -> String {
    let mut text = "| function | f64 | f32 | textbook f64 | textbook f32 |\n|---|---|---|---|---|\n".to_owned();
    for (double, single) in measured::<f64>().iter().zip(measured::<f32>()) {
        let [of_double, of_single] =
            [report::largest(&report::errors(double)), report::largest(&report::errors(&single))];
        let cells = [of_double.ours, of_single.ours, of_double.textbook, of_single.textbook];
        let cells = cells.map(|errors| errors.parts.map(number).join(" / "));
        writeln!(text, "| `{}` | {} |", double.name, cells.join(" | ")).expect("text takes everything");
    }
    text
}
