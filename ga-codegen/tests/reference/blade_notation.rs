//! How blades are read and written, and what is said of a word that names none.

use std::error::Error;

use ga_codegen::algebra::Signature;
use ga_codegen::reference::{Multivector, ReferenceError};

use crate::{PGA_2D, PGA_3D, multivector};

#[track_caller]
fn reading_error(signature: Signature, word: &str) -> ReferenceError {
    Multivector::from_blades(signature, [("1", 1), (word, 1)]).expect_err("the word names no blade")
}

#[test]
fn a_word_carries_the_sign_of_its_order() {
    let x = multivector(PGA_3D, [("e31", 5), ("e021", 7), ("e032", 11)]);
    assert_eq!(x.coefficient("e13"), -5);
    assert_eq!(x.coefficient("e31"), 5);
    assert_eq!(x.coefficient("e012"), -7);
    assert_eq!(x.coefficient("e102"), 7);
    assert_eq!(x.coefficient("e023"), -11);
    assert_eq!(x.coefficient("e320"), 11);
    assert_eq!(x.coefficient("e0123"), 0);
    assert_eq!(x.coefficient("1"), 0);
}

#[test]
fn blades_given_twice_add_up() {
    let x = multivector(PGA_3D, [("e12", 5), ("1", 1), ("e21", 2), ("e3", 4), ("e3", -4)]);
    assert_eq!(x, multivector(PGA_3D, [("1", 1), ("e12", 3)]));
}

#[test]
fn owned_words_are_read_as_well() {
    let words = ["e1", "e2"].map(|word| (word.to_owned(), 1.0_f32));
    let x = Multivector::from_blades(PGA_2D, words).expect("blades of 2D PGA");
    assert_eq!(x.coefficient("e2"), 1.0);
}

#[test]
fn blades_come_by_grade_then_by_word() {
    let x = multivector(PGA_3D, [("e0123", 1), ("e31", 2), ("e01", 3), ("e3", 4), ("1", 5), ("e0", 0)]);
    let expected = [("1", 5), ("e3", 4), ("e01", 3), ("e13", -2), ("e0123", 1)];
    assert_eq!(x.blades(), expected.map(|(word, value)| (word.to_owned(), value)));
}

#[test]
fn displays_terms_with_their_signs() {
    assert_eq!(multivector(PGA_3D, [("e12", 2), ("e0123", -1)]).to_string(), "2 e12 - e0123");
    assert_eq!(multivector(PGA_3D, [("1", -1), ("e1", 1), ("e2", -3)]).to_string(), "-1 + e1 - 3 e2");
    assert_eq!(multivector(PGA_3D, [("e1", -1), ("e2", 1)]).to_string(), "-e1 + e2");
    assert_eq!(multivector(PGA_3D, [("1", 0.5), ("e13", -0.25)]).to_string(), "0.5 - 0.25 e13");
    assert_eq!(Multivector::<f64>::zero(PGA_3D).to_string(), "0");
    assert_eq!(Multivector::scalar(PGA_3D, 7).to_string(), "7");
}

#[test]
fn a_malformed_word_is_an_error_that_quotes_it() {
    for word in ["", "e", "12", "E12", "e1x", " e1", "e-1", "-e1", "11", "é1", "e1²"] {
        let error = reading_error(PGA_3D, word);
        assert_eq!(error, ReferenceError::MalformedWord { word: word.to_owned() });
        let expected = format!("expected a blade, `1` or `e` followed by the digits of its generators, found `{word}`");
        assert_eq!(error.to_string(), expected);
    }
}

#[test]
fn an_unknown_generator_is_an_error_that_lists_the_known() {
    let cases = [
        (PGA_3D, "e014", "expected a generator of Cl(3,0,1), e0 to e3, found e4 in `e014`"),
        (Signature::new(3, 0, 0), "e0", "expected a generator of Cl(3,0,0), e1 to e3, found e0 in `e0`"),
        (Signature::new(8, 0, 0), "e9", "expected a generator of Cl(8,0,0), e1 to e8, found e9 in `e9`"),
        (Signature::new(0, 1, 0), "e2", "expected the generator e1 of Cl(0,1,0), found e2 in `e2`"),
        (Signature::new(0, 0, 0), "e1", "expected no generator, as Cl(0,0,0) has none, found e1 in `e1`"),
    ];
    for (signature, word, message) in cases {
        assert_eq!(reading_error(signature, word).to_string(), message);
    }
}

#[test]
fn a_repeated_generator_is_an_error() {
    let error = reading_error(PGA_3D, "e121");
    assert_eq!(error, ReferenceError::RepeatedGenerator { word: "e121".to_owned(), generator: 1 });
    assert_eq!(error.to_string(), "expected each generator at most once in a blade, found e1 again in `e121`");
}

#[test]
fn more_than_eight_dimensions_are_an_error() {
    let signature = Signature::new(5, 3, 1);
    let error = Multivector::from_blades(signature, [("e1", 1.0)]).expect_err("nine dimensions");
    assert_eq!(error, ReferenceError::DimensionTooLarge { signature });
    assert_eq!(error.to_string(), "expected a signature of at most 8 dimensions, found Cl(5,3,1), which has 9");

    let huge = Signature::new(usize::MAX, usize::MAX, usize::MAX);
    assert!(Multivector::<f64>::from_blades(huge, [("1", 1.0)]).is_err());
}

#[test]
fn errors_are_standard_errors() {
    let error: Box<dyn Error> = Box::new(reading_error(PGA_3D, "e121"));
    assert!(error.source().is_none());
}

#[test]
fn try_coefficient_reports_what_coefficient_panics_on() {
    let x = multivector(PGA_3D, [("e12", 5)]);
    assert_eq!(x.try_coefficient("e21"), Ok(-5));
    assert_eq!(x.try_coefficient("e4").expect_err("3D PGA has no e4"), reading_error(PGA_3D, "e4"));
}

#[test]
#[should_panic(expected = "expected a generator of Cl(3,0,1), e0 to e3, found e4 in `e4`")]
fn coefficient_panics_on_a_word_that_names_no_blade() {
    multivector(PGA_3D, [("e12", 5)]).coefficient("e4");
}

#[test]
#[should_panic(expected = "expected two multivectors of one signature, found Cl(3,0,1) and Cl(2,0,1)")]
fn products_panic_on_two_signatures() {
    let _ = multivector(PGA_3D, [("e1", 1)]).geometric(&multivector(PGA_2D, [("e1", 1)]));
}

#[test]
#[should_panic(expected = "expected two multivectors of one signature, found Cl(2,0,1) and Cl(3,0,1)")]
fn sums_panic_on_two_signatures() {
    let _ = &multivector(PGA_2D, [("e1", 1)]) + &multivector(PGA_3D, [("e1", 1)]);
}

#[test]
#[should_panic(expected = "expected a signature of at most 8 dimensions, found Cl(9,0,0), which has 9")]
fn zero_panics_on_too_many_dimensions() {
    let _ = Multivector::<f64>::zero(Signature::new(9, 0, 0));
}
