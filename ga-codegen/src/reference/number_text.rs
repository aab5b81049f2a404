//! How coefficients are written: plain numbers, and anything else in parentheses.

use std::ops::Neg;
use std::str::FromStr;

/// A coefficient as it stands in a text, without the sign before it.
pub(super) enum NumberText<'a> {
    /// `12`, `0.5` or `1/2`.
    Plain(&'a str),
    /// What stands in parentheses.
    Group(&'a str),
}

/// The length of the plain number at the start of a text, 0 if there is none.
pub(super) fn plain_length(text: &str) -> usize {
    let whole = digits(text);
    let separated = text[whole..].strip_prefix(['.', '/']).map_or(0, digits);
    match (whole, separated) {
        (0, _) => 0,
        (whole, 0) => whole,
        (whole, part) => whole + 1 + part,
    }
}

/// The number of digits at the start of a text.
fn digits(text: &str) -> usize {
    text.bytes().take_while(u8::is_ascii_digit).count()
}

/// The length of the group at the start of a text, both parentheses included; `None` if it is not closed.
pub(super) fn group_length(text: &str) -> Option<usize> {
    let mut open = 0_usize;
    for (position, byte) in text.bytes().enumerate() {
        match byte {
            b'(' => open += 1,
            b')' => open -= 1,
            _ => {}
        }
        if open == 0 {
            return Some(position + 1);
        }
    }
    None
}

/// The sign of a coefficient's own text and how it is written behind that sign: plain numbers as they are, anything
/// else in parentheses with its sign.
pub(super) fn write(text: String) -> (bool, String) {
    let (negative, magnitude) = signed(&text);
    if !magnitude.is_empty() && plain_length(magnitude) == magnitude.len() {
        (negative, magnitude.to_owned())
    } else {
        (false, format!("({text})"))
    }
}

/// Whether a text starts with a minus, and what is behind it.
fn signed(text: &str) -> (bool, &str) {
    text.strip_prefix('-').map_or((false, text), |magnitude| (true, magnitude))
}

impl NumberText<'_> {
    /// The text as it stands.
    pub(super) fn text(&self) -> &str {
        match self {
            Self::Plain(text) | Self::Group(text) => text,
        }
    }

    /// The number, or its negative; `None` if the type does not read it. A plain number gets its sign before it is
    /// read, so the least `i64`, which has no negative, can be read too.
    pub(super) fn read<T: FromStr + Neg<Output = T>>(&self, negative: bool) -> Option<T> {
        let (minus, magnitude) = match self {
            Self::Plain(text) => (false, *text),
            Self::Group(text) => signed(text.trim()),
        };
        if plain_length(magnitude) == magnitude.len() {
            return read_plain(negative != minus, magnitude);
        }
        let value: T = self.text().parse().ok()?;
        Some(if negative { -value } else { value })
    }
}

/// A plain number in the first of its forms that the type reads.
fn read_plain<T: FromStr>(negative: bool, magnitude: &str) -> Option<T> {
    let sign = if negative { "-" } else { "" };
    let forms = std::iter::once(magnitude.to_owned()).chain(other_forms(magnitude));
    forms.into_iter().find_map(|form| format!("{sign}{form}").parse().ok())
}

/// The same value as a fraction in lowest terms, and as a decimal if that ends; none where its parts are too large.
fn other_forms(magnitude: &str) -> Vec<String> {
    let Some((numerator, denominator)) = fraction(magnitude) else { return Vec::new() };
    let fraction = if denominator == 1 { numerator.to_string() } else { format!("{numerator}/{denominator}") };
    std::iter::once(fraction).chain(decimal(numerator, denominator)).collect()
}

/// Numerator and denominator in lowest terms.
fn fraction(magnitude: &str) -> Option<(u128, u128)> {
    let (numerator, denominator) = if let Some((numerator, denominator)) = magnitude.split_once('/') {
        (numerator.parse().ok()?, denominator.parse().ok()?)
    } else {
        let (whole, decimals) = magnitude.split_once('.').unwrap_or((magnitude, ""));
        let places = u32::try_from(decimals.len()).ok()?;
        (format!("{whole}{decimals}").parse().ok()?, 10_u128.checked_pow(places)?)
    };
    let divisor = greatest_common_divisor(numerator, denominator);
    (denominator != 0).then(|| (numerator / divisor, denominator / divisor))
}

fn greatest_common_divisor(a: u128, b: u128) -> u128 {
    if b == 0 { a } else { greatest_common_divisor(b, a % b) }
}

/// The decimal of a fraction in lowest terms, if it ends.
fn decimal(numerator: u128, denominator: u128) -> Option<String> {
    let mut text = format!("{}.", numerator / denominator);
    let mut rest = numerator % denominator;
    // Each place divides the denominator that is left by 2, by 5 or by both, so an end comes within 128 places.
    for _ in 0..u128::BITS {
        let tenfold = rest.checked_mul(10)?;
        text += &(tenfold / denominator).to_string();
        rest = tenfold % denominator;
        if rest == 0 {
            return Some(text);
        }
    }
    None
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn plain_numbers_end_where_they_end() {
        let cases = [("12", 2), ("0.5 e1", 3), ("1/2", 3), ("1/2/3", 3), ("3.", 1), (".5", 0), ("", 0), ("e1", 0)];
        for (text, length) in cases {
            assert_eq!(plain_length(text), length, "{text}");
        }
    }

    #[test]
    fn fractions_are_decimals_where_those_end() {
        assert_eq!(other_forms("6/16"), ["3/8", "0.375"]);
        assert_eq!(other_forms("0.50"), ["1/2", "0.5"]);
        assert_eq!(other_forms("1/3"), ["1/3"]);
        assert_eq!(other_forms("4/2"), ["2", "2.0"]);
        assert!(other_forms("1/0").is_empty());
        assert!(other_forms(&"9".repeat(40)).is_empty());
        assert_eq!(other_forms("1/1267650600228229401496703205376").len(), 2, "2^-100 has 100 places");
    }

    #[test]
    fn groups_end_at_their_own_parenthesis() {
        assert_eq!(group_length("(a (b) c) e1 (d)"), Some(9));
        assert_eq!(group_length("(a (b)"), None);
    }
}
