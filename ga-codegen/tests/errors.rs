//! What is wrong with a definition block is said at the token to blame: message, line and column.

use proc_macro2::TokenStream;
use proptest::prelude::*;

/// The errors of a block as `line:column: message`, both counted from 1.
fn errors(block: &str) -> Vec<String> {
    let tokens: TokenStream = block.trim_start().parse().expect("a block made of tokens");
    let found = ga_codegen::expand(tokens).err().into_iter().flatten();
    let described = found.map(|error| {
        let start = error.span().start();
        format!("{}:{}: {error}", start.line, start.column + 1)
    });
    described.collect()
}

#[track_caller]
fn assert_errors(block: &str, expected: &[&str]) {
    assert_eq!(errors(block), expected, "{block}");
}

// Names.

#[test]
fn an_unknown_blade_is_found_in_the_entity() {
    assert_errors(
        "
signature (2, 0, 1);
entity Line { e1, e2, e3 }",
        &["2:23: expected a blade of the basis (1 e0 e1 e2 e01 e02 e12 e012), found `e3`"],
    );
}

#[test]
fn an_unknown_entity_is_found_in_parameters_and_output() {
    assert_errors(
        "
signature (2, 0, 1);
entity Line { e1, e2, e0 }
kernel flip(a: Line, b: Lime) -> Lint = -a;",
        &[
            "3:25: expected an entity (Scalar, Line), found `Lime`",
            "3:34: expected an entity (Scalar, Line), found `Lint`",
        ],
    );
}

#[test]
fn an_unknown_name_is_found_in_the_expression() {
    assert_errors(
        "
signature (2, 0, 0);
entity Vector { e1, e2 }
kernel f(a: Vector) -> Vector = b;
kernel g(a: Vector) -> Vector = flip(a);
kernel h(a: Vector) -> Vector = a.e1;",
        &[
            "3:33: expected a parameter (`a`) or a blade, found `b`",
            "4:33: expected a function (dual, undual, grade_involution, clifford_conjugate, left_contraction, \
             right_contraction, scalar_product, commutator, anticommutator, grade, exp, log, normalize, sqrt), found `flip`",
            "5:33: expected a whole parameter, found its field `a.e1`",
        ],
    );
}

#[test]
fn names_are_distinct() {
    assert_errors(
        "
signature (2, 0, 0);
entity Vector { e1, e2 }
entity Vector { e1, e2 }
entity Fields { x: e1, x: e2 }
entity Blades { x: e1, y: e1 }
kernel f(a: Vector) -> Vector = a;
kernel f(a: Vector, a: Vector) -> Vector = -a;",
        &[
            "3:8: expected entities with distinct names, found `Vector` twice",
            "4:24: expected fields with distinct names in `Fields`, found `x` twice",
            "5:27: expected every blade once in `Blades`, found `e1` twice",
            "7:8: expected kernels with distinct names, found `f` twice",
            "7:21: expected parameters with distinct names, found `a` twice",
        ],
    );
}

#[test]
fn a_name_that_rust_or_the_emitted_code_needs_is_refused() {
    assert_errors(
        "
signature (2, 0, 0);
entity Vector { self: e1, crate: e2 }
entity Under { _: e1, e2 }
kernel super() -> Scalar = 1;",
        &[
            "2:17: expected a field, a blade or a number, found `self`",
            "3:16: expected a field, a blade or a number, found `_`",
            "4:8: expected the name of a kernel, found `super`",
        ],
    );
    assert_errors(
        "
signature (2, 0, 0);
entity Scalar { e1 }
entity Real { e1 }
entity T { e1 }
entity Vector { e1 }
kernel f(e1: Vector) -> Vector = e1;",
        &[
            "2:8: expected an entity whose name emitted code does not use, found `Scalar`",
            "3:8: expected an entity whose name emitted code does not use, found `Real`",
            "4:8: expected an entity whose name emitted code does not use, found `T`",
            "6:10: expected a parameter that is not named like a blade, found `e1`",
        ],
    );
}

#[test]
fn keywords_of_rust_that_can_be_raw_are_names() {
    let block = "signature (2, 0, 0); entity Vector { fn: e1, r#type: e2 } kernel match(r#in: Vector) -> Vector = -in;";
    let emitted = ga_codegen::expand(block.parse().expect("tokens")).expect("a block without errors").to_string();
    for name in ["r#fn", "r#type", "r#match", "r#in"] {
        assert!(emitted.contains(name), "{name}");
    }
}

#[test]
fn an_entity_without_fields_is_refused() {
    assert_errors(
        "
signature (2, 0, 0);
entity Empty { }
entity One { 1: 1 }",
        &[
            "2:8: expected at least one field in `Empty`, found none",
            "3:8: expected at least one field in `One`, found none",
        ],
    );
}

// Signature and basis.

#[test]
fn a_basis_holds_every_blade() {
    assert_errors(
        "
signature (2, 0, 1);
basis 1 e0 e1 e2 e01 e12;",
        &["2:1: expected every blade of the algebra, found none for `e02`, `e012`"],
    );
}

#[test]
fn a_basis_holds_every_blade_once() {
    assert_errors(
        "
signature (2, 0, 1);
basis 1 e0 e1 e2 e01 e20 e02 e12 e012;",
        &["2:26: expected every blade once, found `e02` and `e20`, which are the same up to sign"],
    );
    assert_errors(
        "
signature (2, 0, 0);
basis 1 x=e1 x=e2 e12;",
        &["2:16: expected distinct names, found `x` twice"],
    );
}

#[test]
fn a_word_of_the_basis_is_a_blade_of_the_signature() {
    let blade = "its generators are e0 e1 e2, each at most once in a blade";
    for word in ["e13", "x12", "e", "e11", "e9", "2"] {
        assert_errors(
            &format!("signature (2, 0, 1);\nbasis 1 e0 e1 e2 e01 e20 {word} e012;"),
            &[&format!("2:26: expected a blade of Cl(2,0,1), found `{word}`: {blade}")],
        );
    }
}

#[test]
fn a_signature_stands_there_once_with_three_numbers_and_at_most_8_generators() {
    assert_errors("entity Vector { e1 }", &["1:1: expected a signature such as `signature (3, 0, 1);`, found none"]);
    assert_errors("", &["1:1: expected a signature such as `signature (3, 0, 1);`, found none"]);
    assert_errors("signature (2, 0);", &["1:1: expected a signature of three numbers (p, q, r), found 2"]);
    assert_errors("signature (9, 0, 0);", &["1:1: expected at most 8 generators, found Cl(9,0,0)"]);
    assert_errors(
        "signature (4, 4, 1);\nbasis 1 e0;", //
        &["1:1: expected at most 8 generators, found Cl(4,4,1)"],
    );
    assert_errors(
        "signature (18446744073709551615, 1, 0);",
        &["1:1: expected at most 8 generators, found Cl(18446744073709551615,1,0)"],
    );
    assert_errors(
        "signature (99999999999999999999, x, 0);",
        &["1:12: expected a whole number of at most 63 bits, found `99999999999999999999`"],
    );
    assert_errors("signature (1, 0, 0);\nsignature (1, 0, 0);", &["2:1: expected one signature, found a second"]);
    assert_errors("signature (1, 0, 0);\nbasis 1 e1;\nbasis 1 e1;", &["3:1: expected one basis, found a second"]);
}

// What outputs can hold, and promises.

#[test]
fn an_output_holds_every_coefficient_of_the_result() {
    assert_errors(
        "
signature (2, 0, 1);
entity Line { e1, e2, e0 }
kernel product(a: Line, b: Line) -> Line = a * b;",
        &[
            "3:37: kernel `product`: expected an output that can hold `1`, found none: its coefficient is a.e1 b.e1 + a.e2 b.e2",
        ],
    );
}

#[test]
fn an_output_meets_the_constants_of_its_type() {
    assert_errors(
        "
signature (2, 0, 1);
entity Point { x: e02, 1: e12 }
entity Any { e02, e12 }
kernel pin(a: Any) -> Point = a;
kernel twice(a: Point) -> Point = 2 * a;",
        &[
            "4:23: kernel `pin`: expected the coefficient 1 of `e12` that the output type fixes, found a.e12",
            "5:27: kernel `twice`: expected the coefficient 1 of `e12` that the output type fixes, found 2",
        ],
    );
}

#[test]
fn an_output_keeps_the_promises_of_its_type() {
    assert_errors(
        "
signature (2, 0, 1);
entity Line { e1, e2, e0 }
entity Motor { s: 1, e12, e01, e02 } where s*s == 1 - e12*e12;
kernel product(a: Line, b: Line) -> Motor = a * b;
kernel twice(a: Motor) -> Motor = a + a;",
        &[
            "4:37: kernel `product`: expected an output with `s * s == 1 - e12 * e12`, found a difference of \
             -1 + a.e1^2 b.e1^2 + a.e1^2 b.e2^2 + a.e2^2 b.e1^2 + a.e2^2 b.e2^2",
            "5:27: kernel `twice`: expected an output with `s * s == 1 - e12 * e12`, found a difference of 3",
        ],
    );
}

#[test]
fn the_same_product_of_unit_lines_keeps_the_promise() {
    assert_errors(
        "
signature (2, 0, 1);
entity Line { e1, e2, e0 } where e1*e1 == 1 - e2*e2;
entity Motor { s: 1, e12, e01, e02 } where s*s == 1 - e12*e12;
kernel product(a: Line, b: Line) -> Motor = a * b;",
        &[],
    );
}

// Relations.

#[test]
fn relations_without_unique_normal_forms_are_an_error_at_the_relation() {
    let line = |first: &str| {
        format!(
            "signature (3, 0, 1);
entity UnitLine {{ e23, e13, e12, e01, e02, e03 }}
    where {first},
          e23*e01 == e13*e02 - e12*e03;"
        )
    };
    assert_errors(&line("e13*e13 == 1 - e23*e23 - e12*e12"), &[]);
    assert_errors(
        &line("e23*e23 == 1 - e13*e13 - e12*e12"),
        &[
            "4:11: expected relations with unique normal forms, found that this one and `e23 * e23 == 1 - e13 * e13 - e12 * \
           e12` leave -e23 e13 e02 + e23 e12 e03 - e13^2 e01 - e12^2 e01 + e01 undecided: write another monomial first, or \
           state that it is 0",
        ],
    );
}

#[test]
fn relations_that_contradict_each_other_are_an_error_at_the_second() {
    assert_errors(
        "
signature (1, 0, 0);
entity X { x: e1 }
    where x*x == 1,
          x*x == 2;",
        &[
            "4:11: expected relations that can hold together, found that this one and `x * x == 1` contradict each other: \
           with both of them, -1 is 0",
        ],
    );
}

#[test]
fn relations_whose_rewriting_does_not_end_are_an_error_at_the_relation() {
    let message = "expected a relation whose first monomial is the greatest in some lexicographic order that suits all \
                   relations, found none: write another monomial first";
    for relations in ["e1*e2 == e1*e1 + e2*e2", "e1 == e2, e2 == e1", "e1 == e1*e1"] {
        assert_errors(
            &format!("signature (2, 0, 0);\nentity Odd {{ e1, e2 }} where {relations};"),
            &[&format!("2:29: {message}")],
        );
    }
}

#[test]
fn a_relation_is_a_polynomial_identity_that_starts_with_its_monomial() {
    let start =
        "expected a relation that starts with the monomial to rewrite, such as `s*s == 1 - e12*e12`, found another";
    let cases = [
        ("1 == e1*e1", "2:32", start),
        ("(e1 + e2)*e1 == 1", "2:32", start),
        ("e1*e1 - e1*e1 == 1", "2:32", start),
        ("x*x == 1", "2:32", "expected a coefficient (e1, e2), found `x`"),
        ("e1 ^ e2 == 1", "2:35", "expected `+`, `-` or `*` between coefficients, found `^`"),
        ("~e1 == 1", "2:32", "expected a polynomial in the coefficients, found another expression"),
        ("e1 = 1", "2:35", "expected `==`, found `=`"),
    ];
    for (relation, place, message) in cases {
        assert_errors(
            &format!("signature (2, 0, 0);\nentity Vector {{ e1, e2 }} where {relation};"),
            &[&format!("{place}: {message}")],
        );
    }
}

#[test]
fn a_relation_of_a_kernel_names_fields_of_parameters_and_suits_those_of_the_types() {
    assert_errors(
        "
signature (2, 0, 0);
entity Vector { e1, e2 } where e1*e1 == 1 - e2*e2;
kernel f(a: Vector) -> Scalar = a | a where a.x == 1;
kernel g(a: Vector) -> Scalar = a | a
    where a.e1*a.e2 == 0;",
        &[
            "3:45: expected a coefficient (a.e1, a.e2), found `a.x`",
            "5:11: expected relations with unique normal forms, found that this one and `e1 * e1 == 1 - e2 * e2` leave \
             a.e2 - a.e2^3 undecided: write another monomial first, or state that it is 0",
        ],
    );
}

// Expressions.

#[test]
fn functions_take_as_many_arguments_as_they_have() {
    assert_errors(
        "
signature (2, 0, 0);
entity Vector { e1, e2 }
kernel f(a: Vector) -> Vector = dual(a, a);
kernel g(a: Vector) -> Vector = a + commutator(a);
kernel h(a: Vector) -> Vector = grade(a);
kernel i(a: Vector) -> Vector = grade(a, 9);
kernel j(a: Vector) -> Vector = exp();",
        &[
            "3:33: expected 1 argument for `dual`, found 2",
            "4:37: expected 2 arguments for `commutator`, found 1",
            "5:33: expected 2 arguments for `grade`, found 1",
            "6:42: expected a grade from 0 to 8 as the second argument, found another expression",
            "7:33: expected 1 argument for `exp`, found 0",
        ],
    );
}

#[test]
fn numbers_are_whole_and_divisors_not_0() {
    assert_errors(
        "
signature (2, 0, 0);
entity Vector { e1, e2 }
kernel f(a: Vector) -> Vector = a * 0.5;
kernel g(a: Vector) -> Vector = 99999999999999999999 * a;",
        &[
            "3:37: expected a whole number or a quotient of two, found `0.5`",
            "4:33: expected a whole number of at most 63 bits, found `99999999999999999999`",
        ],
    );
    assert_errors(
        "
signature (2, 0, 0);
entity Vector { e1, e2 }
kernel f(a: Vector) -> Vector = a / 0;
kernel g(a: Vector) -> Vector = a / a;",
        &[
            "3:37: expected a divisor other than 0, found 0",
            "4:37: expected a whole number as divisor, found an expression",
        ],
    );
}

#[test]
fn numbers_that_do_not_fit_are_an_error_of_the_kernel_and_never_wrap() {
    assert_errors(
        "
signature (2, 0, 0);
entity Vector { e1, e2 }
kernel f(a: Vector) -> Vector = 9223372036854775807 * 9223372036854775807 * 9223372036854775807 * a;",
        &["3:8: kernel `f`: exact arithmetic overflowed 128-bit rationals"],
    );
    assert_errors(
        "
signature (2, 0, 0);
entity Vector { e1, e2 }
kernel f(a: Vector) -> Vector = 1000000007 * 1000000009 * a;",
        &["3:8: kernel `f`: expected numbers whose numerator and denominator fit an i32, found 1000000016000000063"],
    );
}

// exp and log.

#[test]
fn exp_and_log_stand_around_the_whole_definition() {
    assert_errors(
        "
signature (2, 0, 0);
entity Bivector { e12 }
entity Rotor { s: 1, e12 }
kernel f(a: Bivector) -> Rotor = exp(a) * 2;
kernel g(a: Bivector) -> Rotor = -log(a);",
        &[
            "4:34: expected `exp` around the whole definition, found it inside an expression",
            "5:35: expected `log` around the whole definition, found it inside an expression",
        ],
    );
}

#[test]
fn exp_takes_a_bivector_into_a_type_that_holds_its_exponential() {
    assert_errors(
        "
signature (2, 0, 0);
entity Vector { e1, e2 }
entity Bivector { e12 }
entity Rotor { s: 1, e12 }
kernel f(a: Vector) -> Rotor = exp(2 * a);
kernel g(a: Bivector) -> Bivector = exp(a);",
        &[
            "5:38: kernel `f`: expected a bivector as the argument of `exp`, found one with 2 a.e1 as the coefficient of `e1`",
            "6:26: kernel `g`: expected an output that can hold `1`, found none",
        ],
    );
}

#[test]
fn exp_of_a_bivector_that_can_be_hyperbolic_is_refused() {
    for (signature, word) in [("1, 1, 0", "e12"), ("1, 1, 1", "e12"), ("2, 1, 0", "e13")] {
        assert_errors(
            &format!(
                "signature ({signature});
entity Bivector {{ {word} }}
entity Even {{ s: 1, {word} }}
kernel f(b: Bivector) -> Even = exp(b);"
            ),
            &[
                "4:8: kernel `f`: expected a bivector whose square is nowhere positive, found one that can be hyperbolic",
            ],
        );
    }
}

#[test]
fn exp_of_a_bivector_without_a_closed_form_here_is_refused() {
    assert_errors(
        "
signature (4, 0, 0);
entity Bivector { e12, e13, e14, e23, e24, e34 }
entity Even { s: 1, e12, e13, e14, e23, e24, e34, e1234 }
kernel f(b: Bivector) -> Even = exp(b);",
        &[
            "4:8: kernel `f`: expected a bivector whose square is a scalar plus a nilpotent part that commutes with it, \
           found another",
        ],
    );
}

#[test]
fn log_takes_the_parameter() {
    let message = "expected the one parameter of the kernel as the argument of `log`, found something else";
    assert_errors(
        "
signature (2, 0, 0);
entity Rotor { s: 1, e12 } where s*s == 1 - e12*e12;
entity Bivector { e12 }
kernel f(r: Rotor) -> Bivector = log(~r);
kernel g(r: Rotor, q: Rotor) -> Bivector = log(r);",
        &[&format!("4:38: {message}"), &format!("5:48: {message}")],
    );
}

#[test]
fn log_takes_a_type_that_promises_a_unit() {
    assert_errors(
        "
signature (2, 0, 0);
entity Even { s: 1, e12 }
entity Rotor { s: 1, e12 } where s*s == 1 - e12*e12;
entity Bivector { e12 }
kernel f(r: Rotor) -> Bivector = log(r);
kernel g(m: Even) -> Bivector = log(m);",
        &["6:37: kernel `g`: expected a unit, x ~x = 1 for x = m, found x ~x = m.s^2 + m.e12^2"],
    );
    assert_errors(
        "
signature (3, 0, 1);
entity Line { e23, e31, e12, e01, e02, e03 }
entity Motor { s: 1, e23, e31, e12, e01, e02, e03, e0123 }
    where s*s == 1 - e23*e23 - e31*e31 - e12*e12;
kernel f(m: Motor) -> Line = log(m);"
            .replace("e31", "e13")
            .as_str(),
        &["5:34: kernel `f`: expected a unit, x ~x = 1 for x = m, found x ~x = 1 + (2 m.s m.e0123 \
           - 2 m.e23 m.e01 + 2 m.e13 m.e02 - 2 m.e12 m.e03) e0123"],
    );
}

#[test]
fn a_root_is_taken_of_a_unit_and_a_norm_is_a_study_number() {
    assert_errors(
        "
signature (2, 0, 1);
entity Even { s: 1, e12 }
entity Everything { s: 1, e1, e2, e12 }
kernel f(m: Even) -> Even = sqrt(m);
kernel g(m: Everything) -> Everything = normalize(m);
kernel h(m: Even) -> Even = normalize(e0 * e1);",
        &[
            "4:34: kernel `f`: expected a unit, x ~x = 1 for x = m, found x ~x = m.s^2 + m.e12^2",
            "5:51: kernel `g`: expected a norm x ~x that is a number plus what squares to 0 and commutes with x, for \
             x = m, found another",
            "6:42: kernel `h`: expected a norm x ~x that is a number plus what squares to 0 and commutes with x, for \
             x = e0 * e1, found another",
        ],
    );
    assert_errors(
        "
signature (2, 0, 0);
entity Even { s: 1, e12 }
kernel f(m: Even) -> Even = 1 + normalize(m);",
        &["3:33: expected `normalize` around the whole definition, found it inside an expression"],
    );
}

#[test]
fn norms_are_nowhere_negative_and_exponents_have_single_coefficients() {
    assert_errors(
        "
signature (1, 1, 0);
entity Bivector { e12 }
entity Even { s: 1, e12 }
kernel f(m: Even) -> Even = normalize(m);
kernel g(a: Bivector) -> Even = exp(a);",
        &[
            "4:39: kernel `f`: expected a norm x ~x that is nowhere negative, for x = m, found that `e12` has a negative \
             one",
            "5:8: kernel `g`: expected a bivector whose square is nowhere positive, found one that can be hyperbolic",
        ],
    );
    assert_errors(
        "
signature (2, 0, 0);
entity Bivector { e12 }
entity Rotor { s: 1, e12 } where s*s == 1 - e12*e12;
kernel f(a: Bivector, b: Bivector) -> Rotor = exp(a + b);
kernel g(a: Bivector, t: Scalar) -> Rotor = exp(a * t);
kernel h(a: Bivector) -> Rotor = exp(-a / 2);",
        &[
            "4:53: kernel `f`: expected multiples of single input coefficients in the argument of `exp`, found a.e12 + \
             b.e12 as the coefficient of `e12`",
            "5:51: kernel `g`: expected multiples of single input coefficients in the argument of `exp`, found a.e12 t \
             as the coefficient of `e12`",
        ],
    );
}

#[test]
fn polynomials_are_for_exp_and_log_in_precisions_that_there_are() {
    assert_errors(
        "
signature (2, 0, 0);
entity Bivector { e12 }
entity Rotor { s: 1, e12 } where s*s == 1 - e12*e12;
kernel f(b: Bivector) -> Bivector = -b polynomial f32;
kernel g(b: Bivector) -> Rotor = exp(b) polynomial f16, f32, f32;
kernel f_f64(r: Rotor) -> Bivector = log(r) polynomial f64;
kernel h(b: Bivector) -> Rotor = exp(b) polynomial f32;
kernel h_f32(b: Bivector) -> Bivector = b;",
        &[
            "4:51: expected `polynomial` at a definition by `exp` or `log`, found another kernel",
            "5:52: expected `f32` or `f64`, found `f16`",
            "5:62: expected distinct precisions, found `f32` twice",
            "7:8: expected names that are not taken, found `h_f32`, which is",
        ],
    );
    assert_errors(
        "
signature (2, 0, 1);
entity Ideal { e01, e02 }
entity Translator { 1: 1, e01, e02 }
kernel f(b: Ideal) -> Translator = exp(b) polynomial f32;",
        &["4:8: kernel `f`: expected an exponential with a norm to approximate, found a polynomial"],
    );
}

// Syntax.

#[test]
fn every_item_that_does_not_parse_is_reported() {
    assert_errors(
        "
signature (2, 0, 0);
entity Vector { e1 e2 }
entity Line { e1: , e2 }
kernel f(a: Line) => Line = a;
kernel g a: Line -> Line = a;
entiti Point { e12 }
export;
preset pga4d;
scalar;",
        &[
            "2:20: expected `,`, found `e2`",
            "3:19: expected a blade, found `,`",
            "4:19: expected `->`, found `=`",
            "5:10: expected `(`, found `a`",
            "6:1: expected `signature`, `basis`, `entity`, `kernel`, `preset`, `scalar`, `export` or `recipe`, found `entiti`",
            "7:7: expected a name for the exported list of kernels, found `;`",
            "8:8: expected one of the presets `pga3d`, `pga2d`, found `pga4d`",
            "9:7: expected the path of the module with the traits `Scalar` and `Real`, found `;`",
        ],
    );
}

#[test]
fn expressions_that_do_not_parse_are_reported_at_the_token() {
    let cases = [
        ("a *", "3:36: expected an expression, found `;`"),
        ("a b", "3:35: expected an operator, `where`, `cost`, `packed`, `polynomial`, `hoist` or `;`, found `b`"),
        ("(a b)", "3:36: expected an operator or `)`, found `b`"),
        ("(a +)", "3:37: expected an expression, found the end"),
        ("dual(a b)", "3:40: expected `,`, found `b`"),
        ("[a]", "3:33: expected an expression, found `[`"),
        ("a where", "3:40: expected an expression, found `;`"),
        ("\"a\"", "3:33: expected an expression, found `\"a\"`"),
    ];
    for (expression, expected) in cases {
        assert_errors(
            &format!("signature (2, 0, 0);\nentity Vector {{ e1, e2 }}\nkernel f(a: Vector) -> Vector = {expression};"),
            &[expected],
        );
    }
}

#[test]
fn an_expression_that_is_nested_too_deep_is_refused_before_the_stack_ends() {
    let block =
        |expression: &str| format!("signature (1, 0, 0);\nentity X {{ e1 }}\nkernel f(a: X) -> X =\n{expression};");
    let (expression, brackets) = (
        "expected an expression nested at most 300 deep, found a deeper one",
        "expected brackets nested at most 300 deep, found deeper ones",
    );
    for (open, close, depth, message) in [
        ("-", "", 20_000, expression),
        ("a+", "", 20_000, expression),
        ("-(", ")", 200, expression),
        ("dual(", ")", 200, expression),
        ("(", ")", 400, brackets),
        ("dual(", ")", 400, brackets),
    ] {
        let deep = errors(&block(&format!("{}a{}", open.repeat(depth), close.repeat(depth))));
        assert!(deep.len() == 1 && deep[0].starts_with("4:") && deep[0].ends_with(message), "{open} {deep:?}");
    }
    // What an algebra of 8 generators may need.
    assert_errors(&block(&format!("{}a", "a+".repeat(255))), &[]);
    assert_errors(&block(&format!("{}a{}", "(-".repeat(100), ")".repeat(100))), &[]);
}

#[test]
fn a_forgotten_semicolon_is_found_where_it_belongs() {
    assert_errors(
        "
signature (2, 0, 0);
entity Vector { e1, e2 } where e1*e1 == 1 - e2*e2
kernel f(a: Vector) -> Vector = a;",
        &["3:1: expected `;`, found `kernel`"],
    );
    assert_errors(
        "
signature (2, 0, 0);
entity Vector { e1, e2 }
kernel f(a: Vector) -> Vector = a",
        &["3:33: expected `;` after this, found the end of the block"],
    );
}

#[test]
fn attributes_other_than_documentation_are_refused() {
    assert_errors(
        "
signature (2, 0, 0);
#[derive(Debug)]
entity Vector { e1, e2 }",
        &["2:3: expected a doc comment, found the attribute `derive`"],
    );
}

#[test]
fn mistakes_of_several_kinds_are_reported_together() {
    assert_errors(
        "
signature (2, 0, 0);
entity Vector { e1, e9 }
kernel f(a: Nope) -> Vector = a;
kernel g(a: Vector, b: Nada) -> Nix = a / 0;
kernel h(a: Vector) -> Vector = c;",
        &[
            "2:21: expected a blade of the basis (1 e1 e2 e12), found `e9`",
            "3:13: expected an entity (Scalar, Vector), found `Nope`",
            "4:24: expected an entity (Scalar, Vector), found `Nada`",
            "4:33: expected an entity (Scalar, Vector), found `Nix`",
            "5:33: expected a parameter (`a`) or a blade, found `c`",
        ],
    );
}

// Any input.

/// Small valid blocks with everything that the grammar has.
const VALID: [&str; 3] = [
    "signature ( 2 , 0 , 1 ) ; basis 1 e0 e1 e2 e01 e20 i = e12 e012 ; \
     entity Line { e1 , e2 , e0 } where e1 * e1 == 1 - e2 * e2 ; entity Point { x : e20 , y : e01 , 1 : i } ; \
     entity Motor { s : 1 , i , e01 , e20 } where s * s == 1 - i * i , ; \
     kernel move_point ( m : Motor , p : Point ) -> Point = m >> p ; \
     kernel product ( a : Line , b : Line ) -> Motor = a * ( b ) ;",
    "signature ( 2 , 0 , 0 ) ; entity Bivector { e12 } entity Rotor { s : 1 , e12 } where s * s == 1 - e12 * e12 ; \
     kernel turn ( b : Bivector ) -> Rotor = exp ( - b / 2 ) ; kernel generator ( r : Rotor ) -> Bivector = log ( r ) ; \
     scalar crate :: scalar ; export small ;",
    "signature ( 1 , 1 , 0 ) ; entity Vector { e1 , e2 } entity Even { s : 1 , e12 } \
     kernel f ( a : Vector , b : Vector ) -> Even = commutator ( a , b ) + grade ( a * ~ b , 0 ) ; \
     kernel g ( a : Vector , k : Scalar ) -> Vector = 3 * a * k & e12 where k * k == 1 , a . e1 == 0 ;",
];

/// One change of a list of tokens.
fn change(tokens: &mut Vec<String>, kind: u8, from: usize, to: usize) {
    let (from, to) = (from % tokens.len(), to % tokens.len());
    match kind {
        0 if tokens.len() > 1 => drop(tokens.remove(from)),
        1 => tokens.insert(to, tokens[from].clone()),
        2 => tokens.swap(from, to),
        _ => tokens[to] = tokens[from].clone(),
    }
}

#[test]
fn the_blocks_that_the_token_soup_is_made_of_are_valid() {
    for block in VALID {
        assert_errors(block, &[]);
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(3000))]

    #[test]
    fn no_input_panics(
        block in 0..VALID.len(),
        changes in prop::collection::vec((0..4_u8, any::<usize>(), any::<usize>()), 1..6),
    ) {
        let mut tokens: Vec<_> = VALID[block].split_whitespace().map(str::to_owned).collect();
        for (kind, from, to) in changes {
            change(&mut tokens, kind, from, to);
        }
        // A block with unbalanced brackets is no token stream; Rust refuses it before anybody is asked.
        if let Ok(tokens) = tokens.join(" ").parse::<TokenStream>()
            && let Err(errors) = ga_codegen::expand(tokens)
        {
            for error in errors {
                let message = error.to_string();
                prop_assert!(message.starts_with("expected ") || message.starts_with("kernel `"), "{}", message);
            }
        }
    }
}

#[test]
fn names_of_emitted_code_are_refused() {
    for name in ["U", "From", "Default", "kernels", "scalar"] {
        let block = format!("signature (2, 0, 0);\nentity {name} {{ e1, e2 }}\n");
        let message = format!("2:8: expected an entity whose name emitted code does not use, found `{name}`");
        assert_errors(&block, &[&message]);
    }
}

#[test]
fn parts_of_a_kernel_have_names_of_their_own() {
    assert_errors(
        "
signature (2, 0, 0);
entity Vector { e1, e2 }
kernel f(uniform a: Vector, b: Vector) -> Scalar = a | b hoist Vector, f, g;
",
        &[
            "3:64: expected names that are not taken, found `Vector`, which is",
            "3:64: expected names that are not taken, found `f`, which is",
        ],
    );
}

#[test]
fn uniform_inputs_and_hoist_go_together() {
    let block = |kernel: &str| format!("\nsignature (2, 0, 0);\nentity Vector {{ e1, e2 }}\n{kernel}\n");
    assert_errors(
        &block("kernel f(uniform a: Vector, b: Vector) -> Scalar = a | b;"),
        &[
            "3:18: expected `hoist STRUCT, PREPARE, APPLY` after the definition of a kernel with a `uniform` parameter, \
           found none",
        ],
    );
    assert_errors(
        &block("kernel f(a: Vector, b: Vector) -> Scalar = a | b hoist Dual, make, take;"),
        &["3:56: expected `hoist` at a polynomial kernel with `uniform` and other parameters, found another kernel"],
    );
    assert_errors(
        &block("kernel f(uniform a: Vector, b: Vector) -> Scalar = a | b hoist Dual, make;"),
        &["3:58: expected `hoist STRUCT, PREPARE, APPLY`, found 2 names"],
    );
    assert_errors(
        &block("kernel f(uniform a: Vector, b: Vector) -> Scalar = (a | b) * (b | b) hoist Dual, make, take;"),
        &["3:76: kernel `f`: expected a definition that is linear in the varying inputs, found a term with b.e1^3"],
    );
}

#[test]
fn recipes_that_do_not_fit_say_how_to_renew_them() {
    let block = |recipe: &str| {
        format!(
            "\nsignature (2, 0, 0);\nentity Vector {{ e1, e2 }}\nkernel f(a: Vector, b: Vector) -> Scalar = a | b;\n{recipe}\n"
        )
    };
    let expands = block("recipe f flops { t0 = a.e1 * b.e1; out = t0 + a.e2 * b.e2; }");
    assert!(ga_codegen::expand(expands.parse().expect("tokens")).is_ok());
    let unfit = |reason: &str| {
        format!(
            "4:8: expected a recipe that fits `f`, found that {reason}: remove it and renew it with `ga-codegen search \
             DEFINITION --kernel f`"
        )
    };
    assert_errors(
        &block("recipe f flops { out = a.e1 * b.e1 - a.e2 * b.e2; }"),
        &[&unfit("coefficient `1`: program minus definition is -2 a.e2 b.e2")],
    );
    assert_errors(&block("recipe f flops { t0 = a.e1; }"), &[&unfit("it has no row `out`")]);
    assert_errors(&block("recipe f flops { out = a.e3; }"), &[&unfit("it uses `a.e3`, which is not known there")]);
    assert_errors(
        &block("recipe g flops { out = a.e1; }"),
        &["4:8: expected a kernel with the cost model flops, found none named `g`"],
    );
    assert_errors(
        &block("recipe f speed { out = a.e1; }"),
        &["4:10: expected a cost model (`flops`, `fma`, `latency`), found `speed`"],
    );
    assert_errors(
        &block("recipe f flops { out = ~a.e1; }"),
        &["4:24: expected sums and products of coefficients, rows and numbers"],
    );
}

#[test]
fn recipes_name_a_row_once_and_outputs_that_are_there() {
    let block = |rows: &str| {
        format!(
            "\nsignature (2, 0, 0);\nentity Vector {{ e1, e2 }}\nkernel f(a: Vector, b: Vector) -> Scalar = a | b;\n\
             recipe f flops {{ {rows} }}\n"
        )
    };
    let unfit = |reason: &str| {
        format!(
            "4:8: expected a recipe that fits `f`, found that {reason}: remove it and renew it with `ga-codegen search \
             DEFINITION --kernel f`"
        )
    };
    assert_errors(&block("a.e1 = b.e1; out = a.e1;"), &[&unfit("it names `a.e1` twice")]);
    assert_errors(&block("t = b.e1; t = a.e1; out = t;"), &[&unfit("it names `t` twice")]);
    assert_errors(&block("out.nope = b.e1; out = a.e1;"), &[&unfit("it has a row `out.nope`, which is no output")]);
}

#[test]
fn names_that_two_programs_would_have_are_refused() {
    let block = |kernels: &str| format!("\nsignature (2, 0, 0);\nentity Vector {{ e1, e2 }}\n{kernels}\n");
    assert_errors(
        &block(
            "kernel f(a: Vector, b: Vector) -> Scalar = a | b cost flops, fma;\nkernel f_fma(a: Vector) -> Vector = -a;",
        ),
        &["3:8: expected names that are not taken, found `f_fma`, which is"],
    );
    assert_errors(
        &block("kernel f(uniform a: Vector, prepared: Vector) -> Scalar = a | prepared hoist Dual, make, take;"),
        &["3:78: expected no parameter named `prepared` beside `hoist`, found one"],
    );
    assert_errors(
        &block("kernel f(uniform a: Vector, b: Vector) -> Vector = b hoist Dual, make, take;"),
        &["3:60: kernel `f`: expected an output that depends on the uniform inputs, found none"],
    );
}

// Blocks that are too large.

/// A block of one kernel over a type of all blades of an algebra.
fn over_all_blades(dimension: u32, kernel: &str) -> String {
    let word = |blade: u32| -> String {
        (1..=dimension).filter(|i| blade >> (i - 1) & 1 == 1).map(|i| i.to_string()).collect()
    };
    let blades: Vec<_> = (1..1_u32 << dimension).map(|blade| format!("e{}", word(blade))).collect();
    format!("signature ({dimension}, 0, 0); entity M {{ s: 1, {} }} {kernel}", blades.join(", "))
}

/// A block of one kernel over vectors in space.
fn over_vectors(definition: &str) -> String {
    format!("signature (3, 0, 0); entity V {{ e1, e2, e3 }} kernel f(a: V) -> V = {definition};")
}

/// The first error of a block, found on a stack of 2 MiB.
fn first_error(block: &str) -> Option<String> {
    let block = block.to_owned();
    let small_stack = std::thread::Builder::new().stack_size(2 << 20);
    let found = small_stack.spawn(move || errors(&block).into_iter().next()).expect("a thread");
    found.join().expect("no panic")
}

#[track_caller]
fn assert_refused(block: &str, message: &str) {
    let found = first_error(block).expect("an error");
    assert!(found.ends_with(message), "{}", &found[..found.len().min(300)]);
}

const TOO_MANY_STEPS: &str = "expected a block that expands in at most 5000000 steps, found more up to here";

#[test]
fn brackets_nested_too_deep_are_refused_wherever_they_stand() {
    let message = "expected brackets nested at most 300 deep, found deeper ones";
    let nested = |count: usize| format!("{}a{}", "(".repeat(count), ")".repeat(count));
    for count in [301, 100_000] {
        assert_refused(&over_vectors(&nested(count)), message);
        assert_refused(&format!("scalar {};", nested(count)), message);
        assert_refused(&format!("entity V {{ {} }}", nested(count)), message);
        assert_refused(&nested(count), message);
    }
    assert_eq!(first_error(&over_vectors(&nested(299))), None);
}

#[test]
fn expressions_as_deep_and_as_long_as_they_may_be_expand_on_a_small_stack() {
    let deepest = [
        format!("{}a", "-".repeat(299)),
        format!("{}a", "~".repeat(299)),
        vec!["a"; 300].join(" + "),
        format!("{}a{}", "dual(undual(".repeat(49), "))".repeat(49)),
    ];
    for definition in deepest {
        assert_eq!(first_error(&over_vectors(&definition)), None, "{definition}");
    }
    for definition in [format!("{}a", "-".repeat(100_000)), vec!["a"; 1000].join(" * "), vec!["a"; 100_000].join(" + ")]
    {
        assert_refused(
            &over_vectors(&definition),
            "expected an expression nested at most 300 deep, found a deeper one",
        );
    }
}

#[test]
fn recipes_of_many_rows_are_emitted_on_a_small_stack() {
    let rows: String = (0..4000).map(|row| format!("t{} = t{row} + a.e1 - a.e1; ", row + 1)).collect();
    let recipe = format!("recipe f flops {{ t0 = a.e1 * a.e1 + a.e2 * a.e2; {rows} out = t4000; }}");
    let block = "signature (2, 0, 0); entity V { e1, e2 } kernel f(a: V) -> Scalar = a | a;";
    assert_eq!(first_error(&format!("{block} {recipe}")), None);
}

#[test]
fn products_that_expand_to_too_much_are_refused_at_the_kernel() {
    assert_refused(&over_all_blades(8, "kernel f(a: M, b: M, c: M) -> M = a * b * c;"), TOO_MANY_STEPS);
    assert_refused(&over_all_blades(8, "kernel f(a: M) -> M = normalize(a);"), TOO_MANY_STEPS);
    assert_refused(&over_vectors(&vec!["a"; 299].join(" * ")), TOO_MANY_STEPS);
}

#[test]
fn relations_that_grow_or_clash_without_end_are_refused_at_the_entity() {
    let power = |i: usize| format!("e{i} == {}", vec![format!("e{}", i + 1); 6].join(" * "));
    let relations: Vec<_> = (1..8).map(power).collect();
    let block = format!(
        "signature (8, 0, 0); entity V {{ e1, e2, e3, e4, e5, e6, e7, e8 }} where {}; \
         kernel f(a: V) -> Scalar = a | a;",
        relations.join(", ")
    );
    assert_refused(&block, TOO_MANY_STEPS);
}

#[test]
fn recipes_that_square_again_and_again_are_refused() {
    let squares = |first: &str, count: usize| -> String {
        let rows: String = (0..count).map(|row| format!("t{} = t{row} * t{row}; ", row + 1)).collect();
        format!(
            "signature (2, 0, 0); entity V {{ e1, e2 }} kernel f(a: V) -> Scalar = a | a; \
             recipe f flops {{ t0 = {first}; {rows} out = a.e1 * a.e1 + a.e2 * a.e2 + t{count}; }}"
        )
    };
    assert_refused(&squares("a.e1", 60), TOO_MANY_STEPS);
    assert!(first_error(&squares("a.e1 + a.e2", 60)).is_some());
    // What cancels in the proof does not in the bound of rounding errors, which counts terms as well or knows none.
    first_error(&squares("(a.e1 + a.e2) - (a.e1 + a.e2)", 12));
}

#[test]
fn too_many_items_and_too_long_lists_are_refused() {
    let items = "expected at most 2048 items in a block, found more";
    let entities: String = (0..5000).map(|i| format!("entity V{i} {{ e1, e2 }} ")).collect();
    assert_refused(&format!("signature (2, 0, 0); {entities}"), items);
    assert_refused(&"preset pga3d; ".repeat(100), items);
    let lists = "expected at most 4096 parts of a list, found more";
    let many = |part: &str| vec![part; 20_000].join(", ");
    assert_refused(&format!("signature (2, 0, 0); entity V {{ {} }}", many("x: e1")), lists);
    assert_refused(&format!("signature (2, 0, 0); entity V {{ e1 }} where {};", many("e1 == 1")), lists);
    assert_refused(&format!("kernel f({}) -> V = a;", many("a: V")), lists);
    assert_refused(&format!("basis {};", "e1 ".repeat(20_000)), lists);
}

#[test]
fn no_more_than_a_hundred_errors_are_reported() {
    let kernels: String = (0..500).map(|i| format!("kernel f{i}(a: W) -> W = a; ")).collect();
    assert_eq!(errors(&format!("signature (2, 0, 0); {kernels}")).len(), 100);
    assert_eq!(errors(&"nonsense; ".repeat(500)).len(), 100);
}

#[test]
fn large_powers_of_two_never_wrap() {
    let two_62 = "4611686018427387904";
    let block = format!("signature (2, 0, 0); kernel f() -> Scalar = {two_62} * {two_62};");
    assert!(
        first_error(&block).expect("too large").contains("expected numbers whose numerator and denominator fit an i32")
    );
}

/// Expressions of every operator and function, with numbers of any size.
fn any_expression() -> impl Strategy<Value = String> {
    let leaf = prop::sample::select(vec!["a", "b", "k", "e1", "e12", "e0", "2", "0", "9223372036854775807", "c"]);
    leaf.prop_map(str::to_owned).prop_recursive(5, 24, 2, |inner| {
        let binary = prop::sample::select(vec!["+", "-", "*", ">>", "&", "^", "|", "/"]);
        let two =
            prop::sample::select(vec!["commutator", "scalar_product", "left_contraction", "anticommutator", "dual"]);
        let one = prop::sample::select(vec![
            "dual",
            "undual",
            "grade_involution",
            "exp",
            "log",
            "normalize",
            "sqrt",
            "-",
            "~",
        ]);
        prop_oneof![
            4 => (inner.clone(), binary, inner.clone()).prop_map(|(a, operator, b)| format!("({a} {operator} {b})")),
            1 => (two, inner.clone(), inner.clone()).prop_map(|(name, a, b)| format!("{name}({a}, {b})")),
            2 => (one, inner.clone()).prop_map(|(name, a)| format!("{name}({a})")),
            1 => (inner, 0..10_u32).prop_map(|(a, grade)| format!("grade({a}, {grade})")),
        ]
    })
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 400, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn any_definition_expands_or_is_refused(
        signature in prop::sample::select(vec!["2, 0, 0", "2, 0, 1", "1, 1, 1", "0, 3, 0"]),
        expression in any_expression(),
        relation in any_expression(),
        related in any::<bool>(),
        output in prop::sample::select(vec!["A", "B", "Scalar"]),
        function in prop::sample::select(vec!["", "exp", "log", "normalize", "sqrt"]),
    ) {
        let promise = if related { format!(" where e1*e1 == {relation};") } else { String::new() };
        let block = format!(
            "signature ({signature}); entity A {{ e1, e2 }}{promise} entity B {{ s: 1, e12 }} \
             kernel f(a: A, b: B, k: Scalar) -> {output} = {function}({expression});"
        );
        if let Err(found) = ga_codegen::expand(block.parse().expect("tokens")) {
            for error in found {
                let message = error.to_string();
                prop_assert!(message.starts_with("expected ") || message.starts_with("kernel `"), "{}: {}", block, message);
            }
        }
    }
}
