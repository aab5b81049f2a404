//! The checks of other people's code find what is wrong with it, and say so in few blades.

use ga_codegen::algebra::Signature;
use ga_codegen::check::strategies::pga2d::{self, PGA2D};
use ga_codegen::check::strategies::{self, PGA3D, motors, planes, points, rotors};
use ga_codegen::check::{Check, CheckError, Coefficient, Fraction, Tolerance};
use ga_codegen::reference::Multivector;
use proptest::prelude::*;

type Element = Multivector<f64>;
type Function = fn(&Element, &Element) -> Element;

/// The sandwich of a point by hand, with signs of two of its terms to get wrong and a factor to leave one out.
fn transform(m: &Element, p: &Element, [cross, turn]: [f64; 2], slide: f64) -> [(&'static str, f64); 4] {
    let [s, a, b, c] = ["1", "e23", "e31", "e12"].map(|word| m.coefficient(word));
    let [d, e, f, h] = ["e01", "e02", "e03", "e0123"].map(|word| m.coefficient(word));
    let [x, y, z] = ["e032", "e013", "e021"].map(|word| p.coefficient(word));
    let across = [d + b * z * cross - c * y, e + c * x - a * z, f + a * y - b * x];
    let half_x = s * across[0] + a * h * slide - b * across[2] * turn + c * across[1];
    let half_y = s * across[1] + b * h * slide - c * across[0] + a * across[2];
    let half_z = s * across[2] + c * h * slide - a * across[1] + b * across[0];
    [("e123", 1.0), ("e032", x - 2.0 * half_x), ("e013", y - 2.0 * half_y), ("e021", z - 2.0 * half_z)]
}

fn sandwich() -> Check<f64> {
    Check::new(PGA3D, "m >> p").expect("a definition").input("m", motors()).input("p", points())
}

fn message<T: std::fmt::Display>(result: Result<(), T>) -> String {
    result.expect_err("an error").to_string()
}

#[test]
fn a_right_implementation_passes() {
    sandwich().cases(2000).assert(|[m, p]| m.geometric(p).geometric(&m.reverse()));
    sandwich().cases(2000).assert(|[m, p]| transform(m, p, [1.0, 1.0], 1.0));
}

#[test]
fn a_wrong_sign_is_found_and_shown_in_few_blades() {
    let error = sandwich().run(|[m, p]| transform(m, p, [-1.0, 1.0], 1.0));
    let expected = "expected the value of `m >> p`, found another at
    m = 0.6 - 0.8 e13
    p = -e012 + e123
expected: 0.28000000000000014 e012 + 0.96 e023 + e123
found:    -2.2800000000000002 e012 - 0.96 e023 + e123
first difference: expected 0.28000000000000014 in e012, found -2.2800000000000002 (allowed: 1.33e-15)";
    assert_eq!(message(error), expected);
}

#[test]
fn the_line_of_the_readme_holds() -> Result<(), Box<dyn std::error::Error>> {
    let mine = |m: &Element, p: &Element| transform(m, p, [1.0, 1.0], 1.0);
    Check::new(PGA3D, "m >> p")?.input("m", motors()).input("p", points()).assert(|[m, p]| mine(m, p));
    Ok(())
}

#[test]
fn a_missing_term_is_found_and_the_first_differing_coefficient_named() {
    let error = sandwich().run(|[m, p]| transform(m, p, [1.0, 1.0], 0.0)).expect_err("a missing term");
    let expected = "expected the value of `m >> p`, found another at
    m = e12 + e0123
    p = e123
expected: 2 e012 + e123
found:    e123
first difference: expected 2 in e012, found 0 (allowed: 2.66e-15)";
    assert_eq!(error.to_string(), expected);
    let counterexample = error.counterexample().expect("a counterexample");
    let difference = counterexample.difference.as_ref().expect("a coefficient");
    assert_eq!((difference.blade.as_str(), difference.expected, difference.found), ("e012", 2.0, 0.0));
    assert_eq!(counterexample.inputs[0].0, "m");
}

#[test]
fn a_swapped_argument_is_found() {
    let check = Check::<f64>::new(PGA3D, "a * b").expect("a definition").input("a", rotors()).input("b", rotors());
    let error = check.run(|[a, b]| b.geometric(a)).expect_err("the other order");
    let [(_, a), (_, b)] = &error.counterexample().expect("a counterexample").inputs[..] else { panic!("two inputs") };
    assert!(a.blades().len() <= 2 && b.blades().len() <= 2, "{error}");
    check.assert(|[a, b]| a.geometric(b));
}

/// Whole numbers as coefficients of a rotor that is not unit, and of a vector.
fn whole(words: &'static [&'static str]) -> impl Strategy<Value = Multivector<i64>> {
    proptest::collection::vec(-99_i64..100, words.len()).prop_map(|coefficients| {
        Multivector::from_blades(Signature::new(2, 0, 0), words.iter().zip(coefficients)).expect("words of the plane")
    })
}

#[test]
fn whole_numbers_are_compared_exactly() {
    let check = Check::new(Signature::new(2, 0, 0), "r * v * ~r + 2 * v | e21").expect("a definition");
    let check = check.input("r", whole(&["1", "e12"])).input("v", whole(&["e1", "e2"]));
    let blade = Multivector::from_blades(Signature::new(2, 0, 0), [("e21", 1)]).expect("a blade");
    check.assert(|[r, v]| r.sandwich(v).add(&v.scale(2)).inner(&blade));
    let off_by_one = |[r, v]: [&Multivector<i64>; 2]| {
        let e1 = r.sandwich(v).add(&v.scale(2)).inner(&blade).coefficient("e1");
        [("e1", e1 + 1), ("e2", r.sandwich(v).add(&v.scale(2)).inner(&blade).coefficient("e2"))]
    };
    let expected = "expected the value of `r * v * ~r + 2 * v | e21`, found another at
    r = 0
    v = 0
expected: 0
found:    e1
first difference: expected 0 in e1, found 1";
    assert_eq!(message(check.run(off_by_one)), expected);
}

#[test]
fn every_operator_and_function_has_its_meaning() {
    let cases: [(&str, Function); 16] = [
        ("a + b", |a, b| a.add(b)),
        ("a - b", |a, b| a.sub(b)),
        ("a ^ b", |a, b| a.outer(b)),
        ("a & b", |a, b| a.regressive(b)),
        ("a | b", |a, b| a.inner(b)),
        ("-a * b / 2", |a, b| a.geometric(b).scale(-0.5)),
        ("left_contraction(a, b)", |a, b| a.left_contraction(b)),
        ("right_contraction(a, b)", |a, b| a.right_contraction(b)),
        ("scalar_product(a, b)", |a, b| a.scalar_product(b)),
        ("commutator(a, b)", |a, b| a.commutator(b)),
        ("anticommutator(a, b)", |a, b| a.anticommutator(b)),
        ("dual(a) + undual(b)", |a, b| a.dual().add(&b.undual())),
        ("grade_involution(a) * ~b", |a, b| a.grade_involution().geometric(&b.reverse())),
        ("clifford_conjugate(a) * b", |a, b| a.clifford_conjugate().geometric(b)),
        ("grade(a * b, 2)", |a, b| a.geometric(b).grade(2)),
        ("a * e31 + b", |a, b| a.geometric(&blade("e31")).add(b)),
    ];
    for (definition, function) in cases {
        let check = Check::new(PGA3D, definition).expect(definition).cases(20);
        check.input("a", motors()).input("b", planes()).assert(|[a, b]| function(a, b));
    }
}

fn blade(word: &str) -> Element {
    Multivector::from_blades(PGA3D, [(word, 1.0)]).expect("a blade")
}

#[test]
fn definitions_that_do_not_parse_say_where() {
    let cases = [
        ("m >> ", "expected an expression, found the end at column 6"),
        ("m * p * m)", "expected parentheses in pairs, found one without its other at column 10"),
        ("(m * p", "expected parentheses in pairs, found one without its other at column 1"),
        ("m p", "expected an operator or the end, found `p` at column 3"),
        ("m * e14", "expected a parameter (`m`) or a blade, found `e14` at column 5"),
        ("m\n  * $", "expected an expression, found `$` at line 2, column 5"),
        ("m * \u{a7}", "expected an expression, found `\u{a7}` at column 5"),
        ("m * 0.5", "expected a whole number or a quotient of two, found `0.5` at column 5"),
        ("dual(m, m)", "expected 1 argument for `dual`, found 2 at column 1"),
        ("2 * exp(m)", "expected `exp` around the whole definition, found it inside an expression at column 5"),
        ("log(m, 2)", "expected 1 argument for `log`, found 2 at column 1"),
        ("", "expected an expression, found the end at column 1"),
    ];
    for (definition, expected) in cases {
        let error = Check::<f64>::new(PGA3D, definition).err().expect(definition);
        assert_eq!(error.to_string(), expected, "{definition}");
    }
    let error = Check::<f64>::new(Signature::new(9, 0, 0), "m").err().expect("nine dimensions");
    assert!(error.to_string().starts_with("expected at most 8 generators, found Cl(9,0,0)"), "{error}");
}

proptest! {
    #[test]
    fn no_text_hurts(text in "[mpe0-9()*^&|>~+ /.,$'\"-]{0,40}|\\PC{0,20}") {
        if let Err(error) = Check::<f64>::new(PGA3D, &text) {
            prop_assert!(error.column() <= text.chars().count() + 1 && error.line() >= 1);
        }
    }
}

#[test]
fn inputs_that_do_not_fit_are_named() {
    let start = || Check::new(PGA3D, "m >> p").expect("a definition").input("m", motors());
    assert_eq!(message(start().run(|[m]| m.clone())), "expected values for the input `p`, found none");
    let error = start().input("q", points()).run(|[m, _]| m.clone());
    assert_eq!(message(error), "expected an input of the definition (`m`, `p`), found `q`");
    let error = start().input("m", motors()).run(|[m, _]| m.clone());
    assert_eq!(message(error), "expected values for each input once, found `m` twice");
    let error = start().input("p", points()).run(|[m]| m.clone());
    assert_eq!(message(error), "expected a function of as many parameters as inputs, 2, found one of 1");
    let other = Just(Multivector::scalar(Signature::new(2, 0, 1), 1.0));
    let error = start().input("p", other).run(|[m, _]| m.clone());
    assert_eq!(message(error), "expected values of Cl(3,0,1) for the input `p`, found one of Cl(2,0,1)");
    let check = Check::new(Signature::new(2, 0, 0), "v / 2").expect("a definition").input("v", whole(&["e1"]));
    let expected = "expected numbers that the coefficients can hold, found `1/2` in the definition";
    assert_eq!(message(check.run(|[v]| v.clone())), expected);
    let check =
        Check::<f64>::new(PGA3D, "m").expect("a definition").input("m", motors().prop_filter("none", |_| false));
    let error = check.run(|[m]| m.clone()).expect_err("no values");
    assert!(matches!(error, CheckError::Exhausted(_)), "{error}");
    assert_eq!(error.to_string(), "expected strategies that give enough values, found Too many local rejects");
}

#[test]
fn wrong_outputs_are_reported_with_the_inputs() {
    let check = Check::new(PGA3D, "~r").expect("a definition").input("r", rotors());
    let found = |error: Result<(), CheckError<f64>>| {
        let text = message(error);
        assert!(text.starts_with("expected the value of `~r`, found another at\n    r = 1\nexpected: 1\n"), "{text}");
        text.lines().last().expect("a line").to_owned()
    };
    let expected = "found:    no answer: expected a generator of Cl(3,0,1), e0 to e3, found e4 in `e4`";
    assert_eq!(found(check.run(|[_]| [("e4", 1.0)])), expected);
    let other = Multivector::scalar(Signature::new(2, 0, 1), 1.0);
    assert_eq!(found(check.run(|[_]| other.clone())), "found:    no answer of Cl(3,0,1), but one of Cl(2,0,1)");
    let panics = |_: [&Element; 1]| -> Element { panic!("not today") };
    assert_eq!(found(check.run(panics)), "found:    a panic: not today");
    assert_eq!(found(check.run(|[_]| [("1", f64::NAN)])), "first difference: expected 1 in 1, found NaN");
    let expected = "first difference: expected 0 in e0123, found inf";
    assert_eq!(found(check.run(|[_]| vec![("1", 1.0), ("e0123", f64::INFINITY)])), expected);
}

#[test]
fn tolerances_are_what_they_say() {
    let scaled = |factor: f64| move |[r]: [&Element; 1]| r.scale(factor);
    let check = |tolerance| Check::new(PGA3D, "r").expect("a definition").input("r", rotors()).tolerance(tolerance);
    check(Tolerance::Exact).assert(scaled(1.0));
    assert!(check(Tolerance::Exact).run(scaled(1.0 + f64::EPSILON)).is_err());
    check(Tolerance::Relative(1e-6)).assert(scaled(1.0 + 9e-7));
    assert!(check(Tolerance::Relative(1e-6)).run(scaled(1.0 + 2e-6)).is_err());
    // Where nothing is computed there is nothing to round.
    assert!(check(Tolerance::Derived).run(scaled(1.0 + f64::EPSILON)).is_err());
}

#[test]
fn the_same_seed_gives_the_same_counterexample() {
    let run = |seed| message(sandwich().seed(seed).run(|[m, p]| transform(m, p, [1.0, -1.0], 1.0)));
    assert_eq!(run(7), run(7));
}

#[test]
#[should_panic(expected = "first difference: ")]
fn assert_panics_with_the_message() {
    sandwich().assert(|[m, p]| transform(m, p, [1.0, -1.0], 1.0));
}

/// Whether a square is this number: exactly for exact coefficients, otherwise up to some units of what was squared.
fn is_unit<T: Coefficient>(square: &Multivector<T>, wanted: i8, size: f64) -> bool {
    let difference = square.sub(&Multivector::scalar(square.signature(), T::from(wanted)));
    let allowed = 64.0 * T::UNIT_ROUNDOFF * (1.0 + size);
    difference.blades().iter().all(|(_, value)| allowed > 0.0 && value.magnitude() <= allowed)
}

/// The sum of the magnitudes of the coefficients.
fn size<T: Coefficient>(value: &Multivector<T>) -> f64 {
    value.blades().iter().map(|(_, coefficient)| coefficient.magnitude()).sum()
}

fn square<T: Coefficient>(value: &Multivector<T>) -> Multivector<T> {
    value.geometric(&value.reverse())
}

fn strategies_keep_what_they_promise<T: Coefficient>() {
    proptest!(|(
        [a, b] in strategies::motor_pairs::<T>(),
        [c, d] in strategies::antipodal_motors::<T>(),
        line in strategies::lines::<T>(),
        plane in planes::<T>(),
        point in points::<T>(),
        direction in strategies::directions::<T>(),
        turned in strategies::motors_near_half_turn::<T>(),
        far in strategies::motors_with_tiny_turn_and_huge_step::<T>(),
        rotor in rotors::<T>(),
        translator in strategies::translators::<T>(),
        bivector in strategies::bivectors::<T>(),
    )| {
        prop_assert!(c.add(&d).blades().is_empty());
        for unit in [a, b, c, turned, far, rotor, translator, line, plane] {
            prop_assert!(is_unit(&square(&unit), 1, size(&unit)), "{unit}");
        }
        prop_assert!(is_unit(&square(&point), 1, 0.0));
        let normal = direction.dual().grade(1);
        prop_assert!(is_unit(&square(&normal), 1, 0.0), "{direction}");
        prop_assert_eq!(bivector.grade(2), bivector);
    });
}

fn strategies_of_the_plane_keep_what_they_promise<T: Coefficient>() {
    proptest!(|(
        [a, b] in pga2d::motor_pairs::<T>(),
        [c, d] in pga2d::antipodal_motors::<T>(),
        line in pga2d::lines::<T>(),
        point in pga2d::points::<T>(),
        direction in pga2d::directions::<T>(),
        turned in pga2d::motors_near_half_turn::<T>(),
        far in pga2d::motors_with_tiny_turn_and_huge_step::<T>(),
        rotor in pga2d::rotors::<T>(),
        translator in pga2d::translators::<T>(),
        bivector in pga2d::bivectors::<T>(),
    )| {
        prop_assert!(c.add(&d).blades().is_empty());
        for unit in [a, b, c, turned, far, rotor, translator, line] {
            prop_assert!(is_unit(&square(&unit), 1, size(&unit)), "{unit}");
        }
        prop_assert!(is_unit(&square(&point), 1, 0.0));
        prop_assert!(is_unit(&square(&direction.dual()), 1, 0.0), "{direction}");
        prop_assert_eq!(bivector.grade(2), bivector);
    });
}

#[test]
fn strategies_keep_promises_of_floats_up_to_rounding() {
    strategies_keep_what_they_promise::<f64>();
    strategies_keep_what_they_promise::<f32>();
    strategies_of_the_plane_keep_what_they_promise::<f64>();
    strategies_of_the_plane_keep_what_they_promise::<f32>();
}

#[test]
fn strategies_keep_promises_of_fractions_exactly() {
    strategies_keep_what_they_promise::<Fraction>();
    strategies_of_the_plane_keep_what_they_promise::<Fraction>();
}

proptest! {
    #[test]
    fn strategies_reach_the_nasty_ones(
        near in strategies::rotors_near_identity::<f64>(),
        turned in strategies::motors_near_half_turn::<f64>(),
        far in strategies::motors_with_tiny_turn_and_huge_step::<f64>(),
        exact in strategies::motors_with_tiny_turn_and_huge_step::<Fraction>(),
        plane_turned in pga2d::motors_near_half_turn::<f64>(),
        plane_far in pga2d::motors_with_tiny_turn_and_huge_step::<f64>(),
        plane_exact in pga2d::motors_near_half_turn::<Fraction>(),
    ) {
        prop_assert!(near.coefficient("1") > 0.9999 && turned.coefficient("1").abs() < 0.011);
        prop_assert!(far.ideal_norm() > 1e4 && plane_far.ideal_norm() > 1e4);
        prop_assert!(plane_turned.coefficient("1").abs() < 0.011);
        let ratio = |numerator, denominator| Fraction::new(numerator, denominator).expect("a fraction");
        prop_assert!(exact.coefficient("1") > ratio(9, 10));
        let cos = plane_exact.coefficient("1");
        prop_assert!(cos != ratio(0, 1) && cos * cos < ratio(1, 25));
    }
}

/// The sandwich of a motor and a point of the plane by hand, with a sign to get wrong.
fn transform_in_plane<T: Coefficient>(m: &Multivector<T>, p: &Multivector<T>, sign: i8) -> [(&'static str, T); 3] {
    let [s, w, a, b] = ["1", "e12", "e01", "e20"].map(|word| m.coefficient(word));
    let [x, y] = ["e20", "e01"].map(|word| p.coefficient(word));
    let (one, two, sign) = (T::from(1), T::from(2), T::from(sign));
    let product = |x: &T, y: &T| x.clone() * y.clone();
    let cos = product(&s, &s) - product(&w, &w);
    let sin = -(two.clone() * product(&s, &w));
    let step_x = two.clone() * (product(&w, &b) - product(&s, &a) * sign);
    let step_y = two * (product(&w, &a) + product(&s, &b));
    [
        ("e12", one),
        ("e20", product(&cos, &x) - product(&sin, &y) + step_x),
        ("e01", product(&sin, &x) + product(&cos, &y) + step_y),
    ]
}

fn plane_sandwich<T: Coefficient>() -> Check<T> {
    Check::new(PGA2D, "m >> p").expect("a definition").input("m", pga2d::motors()).input("p", pga2d::points())
}

#[test]
fn exact_units_need_no_tolerance() {
    plane_sandwich::<Fraction>().assert(|[m, p]| transform_in_plane(m, p, 1));
    let check = Check::<Fraction>::new(PGA3D, "(a * b) >> p").expect("a definition");
    let check = check.inputs(["a", "b"], strategies::motor_pairs()).input("p", points());
    check.assert(|[a, b, p]| a.sandwich(&b.sandwich(p)));
    // What holds of units alone holds of these.
    let check = Check::<Fraction>::new(PGA3D, "~m * (m >> l) * m").expect("a definition");
    check.input("m", motors()).input("l", strategies::lines()).assert(|[_, l]| l.clone());
}

#[test]
fn a_wrong_sign_is_found_in_the_plane_in_any_coefficients() {
    plane_sandwich::<f64>().assert(|[m, p]| transform_in_plane(m, p, 1));
    plane_sandwich::<f32>().assert(|[m, p]| transform_in_plane(m, p, 1));
    assert!(plane_sandwich::<f64>().run(|[m, p]| transform_in_plane(m, p, -1)).is_err());
    assert!(plane_sandwich::<f32>().run(|[m, p]| transform_in_plane(m, p, -1)).is_err());
    let error = plane_sandwich::<Fraction>().run(|[m, p]| transform_in_plane(m, p, -1));
    let expected = "expected the value of `m >> p`, found another at
    m = 1 - e01
    p = e12
expected: -2 e02 + e12
found:    2 e02 + e12
first difference: expected -2 in e02, found 2";
    assert_eq!(message(error), expected);
}

/// Bivectors for which the exponential's series ends soon.
fn small_bivectors(signature: Signature, words: &'static [&'static str]) -> impl Strategy<Value = Element> {
    proptest::collection::vec(-1.0..1.0, words.len()).prop_map(move |coefficients| {
        Multivector::from_blades(signature, words.iter().zip(coefficients)).expect("words of the signature")
    })
}

const LINE: [&str; 6] = ["e23", "e31", "e12", "e01", "e02", "e03"];

/// The sum of B^n / n!, in which the term of this number has another sign; no term has the number 0.
fn exp_by_series(bivector: &Element, wrong: usize) -> Element {
    let one = Multivector::scalar(bivector.signature(), 1.0);
    let (mut term, mut sum) = (one.clone(), one);
    for n in 1..40 {
        term = term.geometric(bivector).scale(1.0 / n as f64);
        sum = if n == wrong { sum.sub(&term) } else { sum.add(&term) };
    }
    sum
}

#[test]
fn exp_is_its_series() {
    let check = |signature, words| {
        Check::<f64>::new(signature, "exp(b)").expect("a definition").input("b", small_bivectors(signature, words))
    };
    for check in [check(PGA3D, &LINE), check(PGA2D, &["e12", "e01", "e20"]), check(Signature::new(3, 0, 0), &LINE[..3])]
    {
        check.assert(|[b]| exp_by_series(b, 0));
        for wrong in 1..8 {
            assert!(check.run(|[b]| exp_by_series(b, wrong)).is_err(), "term {wrong}");
        }
    }
}

/// The exponential in the plane by hand.
fn exp_in_plane(bivector: &Element) -> Element {
    let norm = bivector.norm();
    let sinc = if norm == 0.0 { 1.0 } else { norm.sin() / norm };
    bivector.scale(sinc).add(&Multivector::scalar(PGA2D, norm.cos()))
}

/// The logarithm in the plane by hand.
fn log_in_plane(motor: &Element) -> Element {
    let bivector = motor.grade(2);
    let norm = bivector.norm();
    let ratio = if norm == 0.0 { 1.0 } else { norm.atan2(motor.coefficient("1")) / norm };
    bivector.scale(ratio)
}

#[test]
fn exp_and_log_hold_in_the_plane_at_every_magnitude() {
    let exp = Check::new(PGA2D, "exp(b)").expect("a definition").input("b", pga2d::bivectors()).cases(2000);
    exp.assert(|[b]| exp_in_plane(b));
    assert!(exp.run(|[b]| exp_in_plane(&b.scale(0.5))).is_err());
    let log = Check::new(PGA2D, "log(m)").expect("a definition").input("m", pga2d::motors()).cases(2000);
    log.assert(|[m]| log_in_plane(m));
    // That of the motion the short way is another where the scalar part is negative.
    let error = log.run(|[m]| if m.coefficient("1") < 0.0 { log_in_plane(&m.neg()) } else { log_in_plane(m) });
    let error = error.expect_err("another branch");
    assert!(error.counterexample().is_some(), "{error}");
    let check = Check::new(PGA2D, "log(~a * b)").expect("a definition");
    let check = check.inputs(
        ["a", "b"],
        pga2d::motor_pairs()
            .prop_filter("-1", |[a, b]: &[Element; 2]| a.reverse().geometric(b).coefficient("1") > -0.9),
    );
    check.assert(|[a, b]| log_in_plane(&a.reverse().geometric(b)));
}

/// The unit near an even element of 3D PGA, with its Study part or without.
fn unit(y: &Element, study: bool) -> Element {
    let norm = y.geometric(&y.reverse());
    let square = norm.coefficient("1");
    let correction = if study { norm.grade(4).geometric(y).scale(0.5 / square) } else { Multivector::zero(PGA3D) };
    y.sub(&correction).scale(1.0 / square.sqrt())
}

#[test]
fn roots_and_units_are_checked() {
    let one = Multivector::scalar(PGA3D, 1.0);
    let sums = strategies::motor_pairs().prop_map(|[a, b]: [Element; 2]| a.scale(2.0).add(&b));
    let check = Check::new(PGA3D, "normalize(y)").expect("a definition").input("y", sums);
    check.assert(|[y]| unit(y, true));
    assert!(check.run(|[y]| unit(y, false)).is_err());
    let planes = planes().prop_map(|plane| plane.scale(-3.0));
    let check = Check::new(PGA3D, "normalize(p)").expect("a definition").input("p", planes);
    check.assert(|[p]| p.normalize().expect("a plane"));
    assert!(check.run(|[p]| p.scale(1.0 / 3.001)).is_err());
    let check = Check::new(PGA3D, "sqrt(m)").expect("a definition");
    let check = check.input("m", motors().prop_map(|m: Element| if m.coefficient("1") < 0.0 { m.neg() } else { m }));
    check.assert(|[m]| unit(&m.add(&one), true));
    assert!(check.run(|[m]| unit(&m.add(&one), true).neg()).is_err());
    assert!(check.run(|[m]| unit(&m.add(&one), false)).is_err());
}

#[test]
fn functions_are_worked_out_in_single_precision() {
    let check = Check::<f32>::new(PGA2D, "exp(b)").expect("a definition").input("b", pga2d::bivectors());
    check.assert(|[b]| {
        let norm = b.norm();
        let sinc = if norm == 0.0 { 1.0 } else { norm.sin() / norm };
        b.scale(sinc).add(&Multivector::scalar(PGA2D, norm.cos()))
    });
    assert!(check.run(|[b]| Multivector::scalar(PGA2D, b.norm().cos()).add(&b.scale(0.999))).is_err());
    let check = Check::<f32>::new(PGA3D, "normalize(l)").expect("a definition");
    check.input("l", strategies::lines()).assert(|[l]| l.clone());
}

#[test]
fn inputs_outside_the_domain_are_reported() {
    let at = |signature: Signature, definition: &str, blades: &[(&str, f64)]| {
        let value = Multivector::from_blades(signature, blades.iter().copied()).expect("blades");
        let check = Check::new(signature, definition).expect("a definition").input("x", Just(value));
        // Whatever is answered, nan and the argument itself among it.
        let [error, other] = [check.run(|[x]| x.clone()), check.run(|[_]| [("1", f64::NAN)])].map(message);
        assert_eq!(error, other);
        let (head, reason) = error.split_once("no value: ").expect("a reason");
        assert!(
            head.starts_with(&format!("expected inputs at which `{definition}` has a value, found\n    x = ")),
            "{head}"
        );
        reason.to_owned()
    };
    let unit = |blade| format!("expected a unit m, m ~m = 1, found another, by the coefficient of {blade} in m ~m");
    assert_eq!(at(PGA3D, "log(x)", &[("1", 1.0), ("e12", 1e-3)]), unit("1"));
    assert_eq!(at(PGA3D, "sqrt(x)", &[("1", 1.0), ("e0123", 1e-3)]), unit("e0123"));
    assert_eq!(at(PGA3D, "log(x)", &[("1", f64::NAN)]), unit("1"));
    let branch = "expected a motion with one logarithm, found -1 or a negative translator";
    assert_eq!(at(PGA3D, "log(x)", &[("1", -1.0)]), branch);
    assert_eq!(at(PGA2D, "log(x)", &[("1", -1.0), ("e01", 2.0)]), branch);
    let norm = "expected a positive norm, found one that is 0 or negative, or that rounding may have made";
    assert_eq!(at(PGA3D, "sqrt(x)", &[("1", -1.0)]), norm);
    assert_eq!(at(PGA3D, "normalize(x)", &[]), norm);
    assert_eq!(at(PGA3D, "normalize(x)", &[("e01", 1.0)]), norm);
    assert_eq!(at(Signature::new(0, 1, 0), "normalize(x)", &[("e1", 1.0)]), norm);
    assert_eq!(at(PGA3D, "normalize(x - x)", &[("e1", 0.1)]), norm);
    let bivector = "expected a bivector as the argument of exp, found one with e1";
    assert_eq!(at(PGA3D, "exp(x)", &[("e1", 1.0), ("e12", 1.0)]), bivector);
    let hyperbolic = "expected a bivector whose square is not positive, found another";
    assert_eq!(at(Signature::new(1, 1, 0), "exp(x)", &[("e12", 1.0)]), hyperbolic);
    let form = "expected a square that is a scalar and a commuting part of square 0, found another";
    assert_eq!(at(Signature::new(4, 0, 0), "exp(x)", &[("e12", 1.0), ("e34", 1.0)]), form);
    assert_eq!(at(PGA3D, "exp(x)", &[("e12", 1e200)]), "expected numbers in the range of f64, found one beyond");
}

#[test]
fn what_has_no_exact_value_is_refused() {
    for function in ["exp", "log", "normalize", "sqrt"] {
        let check =
            Check::<Fraction>::new(PGA3D, &format!("{function}(m)")).expect("a definition").input("m", motors());
        let expected = format!(
            "expected coefficients in floating point for `{function}`, found exact ones, of which it has no exact value"
        );
        assert_eq!(message(check.run(|[m]| m.clone())), expected);
    }
    let huge = Fraction::new(1 << 100, 3).expect("a fraction");
    let check = Check::<Fraction>::new(PGA3D, "x * x").expect("a definition");
    let error = check.input("x", Just(Multivector::scalar(PGA3D, huge))).run(|[x]| x.clone());
    assert!(matches!(error, Err(CheckError::Undefined(_))));
    let expected = "no value: a panic of the coefficients' arithmetic: exact arithmetic overflowed 128-bit rationals";
    assert_eq!(message(error).lines().last(), Some(expected));
}
