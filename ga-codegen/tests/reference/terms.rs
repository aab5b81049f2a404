//! Multivectors read from text, and that what is written is read again.

use std::error::Error;

use ga_codegen::algebra::Signature;
use ga_codegen::reference::{Multivector, Number, ParseError};
use proptest::prelude::*;

use crate::fraction::Fraction;
use crate::surd::Surd;
use crate::{PGA_2D, PGA_3D, basis_words, multivector};

/// Signatures of few and of many blades.
const SIGNATURES: [Signature; 4] = [Signature::new(0, 0, 0), PGA_2D, PGA_3D, Signature::new(4, 3, 1)];

#[track_caller]
fn read<T: Number + std::str::FromStr>(text: &str) -> Multivector<T> {
    Multivector::parse(PGA_3D, text).unwrap_or_else(|error| panic!("`{text}`: {error}"))
}

#[test]
fn sums_are_read_as_they_are_written() {
    assert_eq!(read::<i64>("2 e12 - e0123"), multivector(PGA_3D, [("e12", 2), ("e0123", -1)]));
    assert_eq!(read::<f64>("1/2 - 0.5 e31"), multivector(PGA_3D, [("1", 0.5), ("e31", -0.5)]));
    assert_eq!(read::<f64>("-0.25"), Multivector::scalar(PGA_3D, -0.25));
    assert_eq!(read::<i64>("0"), Multivector::zero(PGA_3D));
    assert_eq!(read::<i64>("e2 - e1"), multivector(PGA_3D, [("e1", -1), ("e2", 1)]));
}

#[test]
fn signs_stars_and_spaces_are_free() {
    let expected = multivector(PGA_3D, [("1", 4), ("e1", 2), ("e12", -3), ("e3", 1)]);
    for text in ["4+2*e1-3*e12+e3", "+4 + 2 e1 - 3 e12 + e3", " e3\n\t-3 * e12+2  e1 + 4 * 1 ", "2 e1+3 e21+4+1 e3"] {
        assert_eq!(read::<i64>(text), expected, "{text}");
    }
}

#[test]
fn a_number_is_read_in_the_form_that_its_type_knows() {
    assert_eq!(read::<f64>("3/8 e1 - 0.1 e2"), multivector(PGA_3D, [("e1", 0.375), ("e2", -0.1)]));
    let fractions = [("e1", Fraction::new(3, 8)), ("e2", Fraction::new(-1, 3))];
    assert_eq!(read::<Fraction>("0.375 e1 - 1/3 e2"), multivector(PGA_3D, fractions));
    assert_eq!(read::<i64>("6/2 e1 - 4.0 e2"), multivector(PGA_3D, [("e1", 3), ("e2", -4)]));
}

#[test]
fn the_least_whole_number_is_read_and_written() {
    let least = multivector(PGA_3D, [("1", i64::MIN), ("e13", i64::MIN)]);
    assert_eq!(read::<i64>(&least.to_string()), least);
    assert_eq!(read::<i64>("9223372036854775808 e31"), multivector(PGA_3D, [("e13", i64::MIN)]));
}

#[test]
fn what_is_no_plain_number_stands_in_parentheses() {
    let x = multivector(PGA_3D, [("1", f64::INFINITY), ("e1", f64::NEG_INFINITY)]);
    assert_eq!(x.to_string(), "(inf) + (-inf) e1");
    assert_eq!(read::<f64>(&x.to_string()), x);
    assert!(read::<f64>("(NaN) e1").coefficient("e1").is_nan());
    assert_eq!(read::<f64>("-(1e-3) e31"), multivector(PGA_3D, [("e13", 1e-3)]));
    let surd = multivector(PGA_3D, [("e1", Surd { whole: 1, root: -2 }), ("e2", Surd { whole: -1, root: 0 })]);
    assert_eq!(surd.to_string(), "(1 - 2 sqrt(3)) e1 - e2");
    assert_eq!(read::<Surd>(&surd.to_string()), surd);
}

#[test]
fn a_text_that_is_no_sum_is_an_error_that_says_where() {
    let cases = [
        ("", "expected a number or a blade, found the end at column 1"),
        ("  ", "expected a number or a blade, found the end at column 3"),
        ("2 e12 +", "expected a number or a blade, found the end at column 8"),
        ("2 e12 e3", "expected `+`, `-` or the end, found `e3` at column 7"),
        ("2 e12 * e3", "expected `+`, `-` or the end, found `*` at column 7"),
        ("2 1", "expected `+`, `-` or the end, found `1` at column 3"),
        ("1 - - e1", "expected a number or a blade, found `-` at column 5"),
        ("2 *", "expected a blade, found the end at column 4"),
        ("2 * 3", "expected a blade, found `3` at column 5"),
        ("2e12", "expected a space or `*` behind a number, found `e12` at column 2"),
        ("1.5.2", "expected a space or `*` behind a number, found `.` at column 4"),
        ("1/ 2", "expected a space or `*` behind a number, found `/` at column 2"),
        (".5 e1", "expected a number or a blade, found `.` at column 1"),
        ("2 e1 + x", "expected a number or a blade, found `x` at column 8"),
        ("é e1", "expected a number or a blade, found `é` at column 1"),
        ("e1 + é", "expected a number or a blade, found `é` at column 6"),
        ("e1 \u{7}", "expected `+`, `-` or the end, found `\\u{7}` at column 4"),
        ("(1 + (2) e1", "expected `)`, found the end at column 12"),
        ("e1 + e4", "expected a generator of Cl(3,0,1), e0 to e3, found e4 in `e4` at column 6"),
        ("e1 + e11", "expected each generator at most once in a blade, found e1 again in `e11` at column 6"),
        ("e", "expected a blade, `1` or `e` followed by the digits of its generators, found `e` at column 1"),
        ("e12 + 2 e3 - e21", "expected each blade at most once, found `e12` again at column 14"),
        ("1/3 e1", "expected a number that the coefficients can hold, found `1/3` at column 1"),
        ("e2 + 1/0 e1", "expected a number that the coefficients can hold, found `1/0` at column 6"),
        ("(x y) e1", "expected a number that the coefficients can hold, found `x y` at column 1"),
        ("() e1", "expected a number that the coefficients can hold, found `` at column 1"),
    ];
    for (text, message) in cases {
        let error = Multivector::<f64>::parse(PGA_3D, text).expect_err(text);
        assert_eq!(error.to_string(), message, "`{text}`");
    }
}

#[test]
fn errors_of_blades_and_signatures_have_a_source() {
    let signature = Signature::new(5, 3, 1);
    let error = Multivector::<f64>::parse(signature, "e1").expect_err("nine dimensions");
    assert_eq!(error.to_string(), "expected a signature of at most 8 dimensions, found Cl(5,3,1), which has 9");
    assert!(error.source().is_some());
    assert!(Multivector::<f64>::parse(PGA_3D, "e4").expect_err("no e4").source().is_some());
    assert!(Multivector::<f64>::parse(PGA_3D, "").expect_err("nothing").source().is_none());
}

#[test]
fn a_number_beyond_its_type_is_an_error() {
    let error = Multivector::<i64>::parse(PGA_3D, "9223372036854775808 e1").expect_err("2^63");
    let found = "9223372036854775808".to_owned();
    assert_eq!(error, ParseError::UnreadableNumber { found, column: 1 });
}

#[test]
fn long_texts_are_read_in_little_time_and_quoted_in_part() {
    let many = 1 << 20;
    let digits = "7".repeat(many);
    let texts = [&digits, &format!("e{digits}"), &"(".repeat(many), &"x".repeat(many), &"e1 + ".repeat(many / 5)];
    for text in texts {
        let error = Multivector::<i64>::parse(PGA_3D, text).expect_err("no multivector");
        assert!(error.to_string().len() < 200, "{error}");
    }
    let spaces = " ".repeat(many);
    assert_eq!(read::<i64>(&format!("{spaces}2{spaces}e1{spaces}")), multivector(PGA_3D, [("e1", 2)]));
}

/// A coefficient of each of its blades, zeros among them.
fn any_terms<T: Number + std::fmt::Debug>(
    number: impl Strategy<Value = T> + Clone + 'static,
) -> impl Strategy<Value = Multivector<T>> {
    prop::sample::select(SIGNATURES.to_vec()).prop_flat_map(move |signature| {
        let term = (prop::sample::select(basis_words(signature)), number.clone());
        prop::collection::btree_map(term.0, term.1, 0..9)
            .prop_map(move |terms| Multivector::from_blades(signature, terms).expect("basis words are blades"))
    })
}

fn fractions() -> impl Strategy<Value = Fraction> + Clone {
    (-99_i64..99, 1_i64..99).prop_map(|(numerator, denominator)| Fraction::new(numerator, denominator))
}

/// Pieces of terms, so that most of what is put together from them is nearly a sum.
fn pieces() -> impl Strategy<Value = String> {
    let piece = prop::sample::select(vec![
        "e", "1", "0", "2", "12", "e12", "e31", "e0123", "+", "-", "*", "/", ".", "(", ")", " ", "inf", "NaN", "é",
        "-(", "1/2",
    ]);
    prop::collection::vec(piece, 0..12).prop_map(|pieces| pieces.concat())
}

proptest! {
    #[test]
    fn floats_that_are_written_are_read_again(x in any_terms(any::<f64>().prop_filter("a number", |x| !x.is_nan()))) {
        prop_assert_eq!(&Multivector::parse(x.signature(), &x.to_string()), &Ok(x));
    }

    #[test]
    fn whole_numbers_that_are_written_are_read_again(x in any_terms(any::<i64>())) {
        prop_assert_eq!(&Multivector::parse(x.signature(), &x.to_string()), &Ok(x));
    }

    #[test]
    fn fractions_that_are_written_are_read_again(x in any_terms(fractions())) {
        prop_assert_eq!(&Multivector::parse(x.signature(), &x.to_string()), &Ok(x));
    }

    #[test]
    fn any_bytes_are_read_or_an_error(bytes in prop::collection::vec(any::<u8>(), 0..40), near in pieces()) {
        let text = String::from_utf8_lossy(&bytes);
        for text in [&*text, near.as_str()] {
            for signature in SIGNATURES {
                // What is read is also written and read again.
                if let Ok(x) = Multivector::<i64>::parse(signature, text) {
                    prop_assert_eq!(&Multivector::parse(signature, &x.to_string()), &Ok(x));
                }
                if let Err(error) = Multivector::<f64>::parse(signature, text) {
                    prop_assert!(error.to_string().starts_with("expected "), "{}", error);
                }
            }
        }
    }
}
