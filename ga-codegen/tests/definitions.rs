//! What definitions mean: every operator and function against the naive reference, what they look like when written out
//! again, and kernels split by what is uniform, worked out by hand.

use ga_codegen::algebra::Signature;
use ga_codegen::kernel::{Definition, Entity, Kernel, Specification, SpecificationError, split};
use ga_codegen::reference::Multivector;
use ga_codegen::symbolic::{Monomial, Overflow as NumbersOverflow, Polynomial, Rational};

fn define(block: &str) -> Definition {
    ga_codegen::define(block.parse().expect("tokens")).expect("a block without errors")
}

fn only_kernel(definition: &Definition) -> &Kernel {
    let [kernel] = definition.kernels.as_slice() else { panic!("one kernel") };
    kernel
}

fn specify(block: &str) -> Specification {
    let definition = define(block);
    Specification::new(&definition, only_kernel(&definition)).expect("a meaning")
}

const WORDS: [&str; 8] = ["1", "e0", "e1", "e2", "e01", "e20", "e12", "e012"];

/// A definition of two multivectors of the projective plane.
fn on_multivectors(expression: &str) -> Definition {
    define(&format!(
        "signature (2, 0, 1);
         basis 1 e0 e1 e2 e01 e20 e12 e012;
         entity Any {{ s: 1, e0, e1, e2, e01, e20, e12, e012 }}
         kernel f(a: Any, b: Any) -> Any = {expression};"
    ))
}

type Value = Multivector<i64>;

#[test]
fn expressions_mean_what_the_reference_works_out() {
    type Meaning = fn(&Value, &Value) -> Value;
    let cases: [(&str, Meaning); 24] = [
        ("a + b", |a, b| a.add(b)),
        ("a - b", |a, b| a.sub(b)),
        ("a * b", |a, b| a.geometric(b)),
        ("a ^ b", |a, b| a.outer(b)),
        ("a & b", |a, b| a.regressive(b)),
        ("a | b", |a, b| a.inner(b)),
        ("a >> b", |a, b| a.sandwich(b)),
        ("-a", |a, _| a.neg()),
        ("~a", |a, _| a.reverse()),
        ("grade(a, 1)", |a, _| a.grade(1)),
        ("dual(a)", |a, _| a.dual()),
        ("undual(a)", |a, _| a.undual()),
        ("grade_involution(a)", |a, _| a.grade_involution()),
        ("clifford_conjugate(a)", |a, _| a.clifford_conjugate()),
        ("left_contraction(a, b)", |a, b| a.left_contraction(b)),
        ("right_contraction(a, b)", |a, b| a.right_contraction(b)),
        ("scalar_product(a, b)", |a, b| a.scalar_product(b)),
        ("commutator(a, b)", |a, b| a.commutator(b)),
        ("anticommutator(a, b)", |a, b| a.anticommutator(b)),
        ("e20 * a - b", |a, b| blade("e20").geometric(a).sub(b)),
        ("-3 * (a - b)", |a, b| a.sub(b).scale(-3)),
        ("a + b ^ a - b", |a, b| a.add(b).outer(&a.sub(b))),
        // The operators bind as in Rust.
        ("a | b ^ a & b", |a, b| a.inner(&b.outer(&a.regressive(b)))),
        ("a >> b + a * b", |a, b| a.sandwich(&b.add(&a.geometric(b)))),
    ];
    let values: [[i64; 16]; 2] =
        [[3, -1, 4, 1, -5, 9, 2, -6, 5, 3, -5, 8, 9, -7, 9, 3], [2, 7, -1, 8, 2, -8, 1, 8, -2, 8, 4, 5, -9, 0, 4, 5]];
    for (text, meaning) in cases {
        let definition = on_multivectors(text);
        let kernel = only_kernel(&definition);
        assert_eq!(kernel.definition(), text, "written out again");
        let specification = Specification::new(&definition, kernel).expect("a meaning");
        for coefficients in values {
            let symbols = coefficients.map(|value| Polynomial::constant(Rational::integer(value)));
            let inputs = [0, 8].map(|first| multivector(&coefficients[first..first + 8]));
            let expected = meaning(&inputs[0], &inputs[1]);
            for (word, output) in WORDS.iter().zip(&specification.outputs) {
                let found = output.substitute(&symbols).expect("small numbers").as_constant();
                assert_eq!(found, Some(Rational::integer(expected.coefficient(word))), "{text}: {word}");
            }
        }
    }
}

fn multivector(coefficients: &[i64]) -> Value {
    let blades = WORDS.into_iter().zip(coefficients.iter().copied());
    Multivector::from_blades(Signature::new(2, 0, 1), blades).expect("words of the signature")
}

fn blade(word: &str) -> Value {
    Multivector::from_blades(Signature::new(2, 0, 1), [(word, 1)]).expect("a word of the signature")
}

#[test]
fn parentheses_stand_where_they_are_needed_and_nowhere_else() {
    for (text, shortest) in [
        ("((a + b)) + a", "a + b + a"),
        ("a + (b + a)", "a + (b + a)"),
        ("a - (b - a)", "a - (b - a)"),
        ("(a * b) + a", "a * b + a"),
        ("a * (b + a)", "a * (b + a)"),
        ("-(a * b)", "-(a * b)"),
        ("(-a) * b", "-a * b"),
        ("~(a + b)", "~(a + b)"),
        ("-(~a)", "-~a"),
        ("(a & b) ^ a", "a & b ^ a"),
        ("a & (b ^ a)", "a & (b ^ a)"),
        ("(a ^ b) | a", "a ^ b | a"),
        ("(a | b) ^ a", "(a | b) ^ a"),
        ("(a >> b) & a", "a >> b & a"),
        ("a >> (b & a)", "a >> (b & a)"),
        ("(a + b) / 2", "(a + b) / 2"),
        ("(a * b) / 2", "a * b / 2"),
        ("a * (b / 2)", "a * (b / 2)"),
        ("(a / 2) * b", "a / 2 * b"),
        ("(-a) / 2", "-a / 2"),
        ("grade((a + b), 2)", "grade(a + b, 2)"),
        ("commutator((a), (b | a))", "commutator(a, b | a)"),
    ] {
        let definition = on_multivectors(text);
        assert_eq!(only_kernel(&definition).definition(), shortest);
        assert_eq!(only_kernel(&on_multivectors(shortest)).definition(), shortest);
    }
}

#[test]
fn a_half_is_exact() {
    let specification =
        specify("signature (1, 0, 0); entity Any { s: 1, x: e1 } kernel f(a: Any) -> Any = (a * a - e1 * 3) / 2;");
    // (s + x e1)^2 = s^2 + x^2 + 2 s x e1.
    let names = specification.names();
    let outputs: Vec<_> = specification.outputs.iter().map(|output| output.display(&names)).collect();
    assert_eq!(outputs, ["1/2 a.s^2 + 1/2 a.x^2", "-3/2 + a.s a.x"]);
}

#[test]
fn names_and_degrees_are_those_of_the_inputs() {
    let specification = specify(
        "signature (2, 0, 1); entity Line { x: e1, y: e2, w: e0 } entity Even { s: 1, b: e12, u: e01, v: e02 }
         kernel f(k: Scalar, a: Line, b: Line) -> Even = k * a * b;",
    );
    assert_eq!(specification.names(), ["k", "a.x", "a.y", "a.w", "b.x", "b.y", "b.w"]);
    let degrees: Vec<_> = specification.coefficients.iter().map(|coefficient| coefficient.degree).collect();
    assert_eq!(degrees, [0, 0, 0, 1, 0, 0, 1]);
    let parameters: Vec<_> = specification.coefficients.iter().map(|coefficient| coefficient.parameter).collect();
    assert_eq!(parameters, [0, 1, 1, 1, 2, 2, 2]);
    assert_eq!(specification.output_degrees(), [0, 0, 1, 1]);
    assert_eq!(specification.degree(&Monomial::new(vec![0, 3, 3, 6])), 3);
}

// Kernels split by what is uniform. Rotors are s + b e12 and vectors x e1 + y e2 in the plane.

/// What both parts of the kernel compute, and of what.
struct Parts {
    prepare: Specification,
    apply: Specification,
}

fn parts(block: &str) -> Result<Parts, String> {
    let definition = define(&format!(
        "signature (2, 0, 0); entity Vector {{ x: e1, y: e2 }} entity Rotor {{ s: 1, b: e12 }} where s*s == 1 - b*b;
         entity In {{ x: e1, y_x: e2 }} entity Out {{ x: e1, x_y: e2 }} {block} hoist Record, prepare, apply;"
    ));
    let kernel = only_kernel(&definition);
    let specification = Specification::new(&definition, kernel).expect("a meaning");
    split(kernel, &specification).map(|(prepare, apply)| Parts { prepare, apply })
}

fn outputs(specification: &Specification) -> Vec<String> {
    let names = specification.names();
    specification.outputs.iter().map(|output| output.display(&names)).collect()
}

/// r v ~r = ((s^2 - b^2) x + 2 s b y) e1 + ((s^2 - b^2) y - 2 s b x) e2: two coefficients up to sign.
#[test]
fn coefficients_that_are_equal_up_to_sign_are_prepared_once() {
    let Parts { prepare, apply } =
        parts("kernel turn(uniform r: Rotor, v: Vector) -> Vector = r >> v").expect("linear in v");
    assert_eq!(prepare.fields, ["x_x", "x_y"]);
    assert_eq!(outputs(&prepare), ["r.s^2 - r.b^2", "2 r.s r.b"]);
    assert_eq!(apply.names(), ["r.s", "r.b", "v.x", "v.y", "prepared.x_x", "prepared.x_y"]);
    // It is a sum of products of its inputs, whatever these are.
    assert!(apply.relations.is_empty() && apply.stated.is_empty() && apply.inputs.is_empty() && apply.value.is_zero());
    assert_eq!(apply.expression.display(&[]), "0");
    assert_eq!(outputs(&apply), ["v.x prepared.x_x + v.y prepared.x_y", "-v.x prepared.x_y + v.y prepared.x_x"]);
}

/// r v + w = (s x + b y) e1 + (s y - b x) e2 + w: the coefficients of w are 1 and stay where they are.
#[test]
fn numbers_need_no_field_and_several_inputs_are_told_apart() {
    let Parts { prepare, apply } =
        parts("kernel f(uniform r: Rotor, v: Vector, w: Vector) -> Vector = r * v + w").expect("linear in v and w");
    assert_eq!(prepare.fields, ["x_v_x", "x_v_y"]);
    assert_eq!(outputs(&prepare), ["r.s", "r.b"]);
    assert_eq!(
        outputs(&apply),
        ["v.x prepared.x_v_x + v.y prepared.x_v_y + w.x", "-v.x prepared.x_v_y + v.y prepared.x_v_x + w.y"]
    );
}

/// What is always added is a coefficient as well: here b^2 + s^2, which is 1 by the rotor's relation, and s.
#[test]
fn what_is_always_added_is_prepared() {
    let Parts { prepare, apply } =
        parts("kernel f(uniform r: Rotor, v: Vector) -> Vector = v + grade(r, 0) * e1 + r * ~r * e2").expect("linear");
    assert_eq!((prepare.fields.as_slice(), outputs(&prepare)), (&["x_1".to_owned()][..], vec!["r.s".to_owned()]));
    assert_eq!(outputs(&apply), ["v.x + prepared.x_1", "1 + v.y"]);
    let labels = prepare.projection.expect("a record").labels;
    assert_eq!(labels, [("x".to_owned(), None)]);
}

#[test]
fn fields_of_a_record_have_names_of_their_own() {
    let names = |block: &str| parts(block).expect("linear").prepare.fields;
    assert_eq!(names("kernel f(uniform a: Vector, b: Vector) -> Scalar = a | b"), ["by_x", "by_y"]);
    assert_eq!(names("kernel f(uniform a: Vector, k: Scalar) -> Vector = k * a"), ["x_k", "y_k"]);
    let block = "kernel f(uniform k: Scalar, uniform l: Scalar, v: In) -> Out = k * (e2 | v) * e1 + l * (e1 | v) * e2";
    assert_eq!(names(block), ["x_y_x", "x_y_x_2"]);
}

#[test]
fn only_what_is_linear_in_the_varying_inputs_and_depends_on_the_uniform_ones_is_split() {
    let error = |block: &str| parts(block).err();
    assert_eq!(
        error("kernel f(uniform a: Vector, b: Vector) -> Scalar = (a | b) * (b | b)").as_deref(),
        Some("expected a definition that is linear in the varying inputs, found a term with b.x^3")
    );
    assert_eq!(
        error("kernel f(uniform a: Vector, b: Vector) -> Vector = 2 * b").as_deref(),
        Some("expected an output that depends on the uniform inputs, found none")
    );
}

/// t l ~t = x e1 + (w + 2 u x) e0 for a translator t = 1 + u e01: what is prepared is a length.
#[test]
fn degrees_of_a_record_are_those_of_its_polynomials() {
    let definition = define(
        "signature (1, 0, 1); entity Translator { 1: 1, u: e01 } entity Line { x: e1, w: e0 }
         kernel f(uniform t: Translator, l: Line) -> Line = t >> l hoist Record, prepare, apply;",
    );
    let kernel = only_kernel(&definition);
    let specification = Specification::new(&definition, kernel).expect("a meaning");
    let (prepare, apply) = split(kernel, &specification).expect("linear in l");
    assert_eq!((prepare.fields.as_slice(), outputs(&prepare)), (&["w_x".to_owned()][..], vec!["2 t.u".to_owned()]));
    assert_eq!((prepare.output_degrees(), apply.output_degrees()), (vec![1], vec![0, 1]));
    assert_eq!(apply.coefficients.iter().map(|c| c.degree).collect::<Vec<_>>(), [1, 0, 1, 1]);
    // Both parts one after the other are the kernel.
    let inputs = (0..3).map(Polynomial::symbol).chain(prepare.outputs.iter().cloned()).collect::<Vec<_>>();
    for (applied, output) in apply.outputs.iter().zip(&specification.outputs) {
        assert_eq!(applied.substitute(&inputs).as_ref(), Ok(output));
    }
}

#[test]
fn linear_types_promise_nothing_and_fix_nothing() {
    for (preset, expected) in [
        (
            "pga3d",
            "EvenMultivector Line Plane Direction ProjectivePoint OddMultivector Pseudoscalar".split(' ').collect(),
        ),
        ("pga2d", Vec::from(["EvenMultivector", "Bivector", "Line", "Direction", "OddMultivector", "Pseudoscalar"])),
    ] {
        let definition = define(ga_codegen::preset::text(preset).expect("a preset"));
        let linear = definition.entities.iter().filter(|entity| entity.is_linear());
        assert_eq!(linear.map(|entity| entity.name.as_str()).collect::<Vec<_>>(), expected);
        let scalars = definition.entities.iter().filter(|entity| entity.is_scalar());
        assert_eq!(scalars.map(|entity| entity.name.as_str()).collect::<Vec<_>>(), ["Scalar"]);
        for entity in &definition.entities {
            assert_eq!(entity.relations().len(), entity.statements.len());
            let stated = entity.relations().into_iter().zip(&entity.statements);
            assert!(stated.into_iter().all(|(relation, statement)| relation == statement.relation));
        }
    }
    let scalar = Entity::scalar();
    assert!(scalar.is_scalar() && !scalar.is_linear());
}

/// On the circle s^2 = 1 - b^2, at 3/5 and 4/5 and off it.
#[test]
fn relations_have_the_value_0_where_they_hold() {
    let definition = define("signature (2, 0, 0); entity Rotor { s: 1, b: e12 } where s*s == 1 - b*b;");
    let rotor = definition.entities.iter().find(|entity| entity.name == "Rotor").expect("an entity");
    let at = |s: (i128, i128), b: (i128, i128)| {
        let number = |(n, d)| Polynomial::constant(Rational::new(n, d).expect("a number"));
        rotor.relation_values(&[number(s), number(b)])
    };
    assert_eq!(at((3, 5), (4, 5)), Ok(vec![Polynomial::zero()]));
    assert_eq!(at((3, 1), (4, 1)), Ok(vec![Polynomial::constant(Rational::integer(24))]));
    assert_eq!(at((i128::MAX, 1), (0, 1)), Err(NumbersOverflow));
}

#[test]
fn a_norm_has_a_scalar_and_a_nilpotent_part() {
    let even = "signature (3, 0, 1); entity Even { s: 1, e23, e31: e31, e12, e01, e02, e03, e0123 }";
    let specification =
        specify(&format!("{even} kernel f(y: Even) -> Even = normalize(y);").replace("e31: e31", "e13"));
    let names = specification.names();
    let study = specification.study_norm("y").expect("a Study number");
    assert_eq!(study.scalar.display(&names), "y.s^2 + y.e23^2 + y.e13^2 + y.e12^2");
    let nilpotent: Vec<_> = study.nilpotent.terms().map(|(blade, c)| (blade.0, c.display(&names))).collect();
    assert_eq!(nilpotent.len(), 1);
    assert_eq!(nilpotent[0].0, 0b1111, "a multiple of e0123");
    let error = |kernel: &str| {
        let definition = define(kernel);
        Specification::new(&definition, only_kernel(&definition)).expect_err("no meaning")
    };
    let vectors = "signature (1, 1, 0); entity Any { s: 1, x: e1, y: e2, b: e12 }";
    let indefinite = error(&format!("{vectors} kernel f(a: Any) -> Any = normalize(a);"));
    assert!(matches!(indefinite, SpecificationError::IndefiniteNorm(..)), "{indefinite}");
    // Null vectors have no norm, and that of s + x e1 is s^2 + x^2 + 2 s x e1, which commutes but is not nilpotent.
    for block in ["signature (0, 0, 1); entity Any { w: e0 }", "signature (1, 0, 0); entity Any { s: 1, x: e1 }"] {
        let other = error(&format!("{block} kernel f(a: Any) -> Any = normalize(2 * a);"));
        assert_eq!(other, SpecificationError::NotAStudyNumber("2 * a".to_owned()));
    }
    let space = "signature (3, 0, 0); entity Any { s: 1, x: e1, y: e2, b: e12, v: e3 }";
    let other = error(&format!("{space} kernel f(a: Any) -> Any = normalize(a);"));
    assert!(matches!(other, SpecificationError::NotAStudyNumber(_)), "{other}");
}

/// The scalar part of (1 + m)(1 + ~m) is 2 + 2 s where m ~m = 1.
#[test]
fn a_square_root_is_of_a_unit_and_normalises_one_more() {
    let rotor = "signature (2, 0, 0); entity Rotor { s: 1, b: e12 } where s*s == 1 - b*b;";
    let specification = specify(&format!("{rotor} kernel f(m: Rotor) -> Rotor = sqrt(m);"));
    let names = specification.names();
    let more = specification.unnormalized().expect("small numbers");
    let written: Vec<_> = more.terms().map(|(blade, c)| (blade.0, c.display(&names))).collect();
    assert_eq!(written, [(0, "1 + m.s".to_owned()), (3, "m.b".to_owned())]);
    let study = specification.study_norm("m").expect("a Study number");
    assert_eq!((study.scalar.display(&names), study.nilpotent.is_zero()), ("2 + 2 m.s".to_owned(), true));
    for function in ["sqrt", "log"] {
        let definition = define(&format!(
            "signature (2, 0, 0); entity Even {{ s: 1, b: e12 }} entity Bivector {{ b: e12 }}
             kernel f(m: Even) -> Even = {function}(m);"
        ));
        let kernel = only_kernel(&definition);
        assert_eq!(kernel.definition(), format!("{function}(m)"));
        let error = Specification::new(&definition, kernel).expect_err("no unit");
        assert_eq!(error, SpecificationError::NotAUnit("m".to_owned(), "m.s^2 + m.b^2".to_owned()));
    }
}

#[test]
fn a_norm_that_is_no_unit_is_written_with_its_blades() {
    let definition = define("signature (1, 0, 0); entity Any { s: 1, x: e1 } kernel f(m: Any) -> Any = log(m);");
    let error = Specification::new(&definition, only_kernel(&definition)).expect_err("no unit");
    assert_eq!(error, SpecificationError::NotAUnit("m".to_owned(), "m.s^2 + m.x^2 + (2 m.s m.x) e1".to_owned()));
}

/// Where blades square to -1 each coefficient is one of the inputs' or a multiple, and where they square to 0 anything.
#[test]
fn an_exponent_is_a_bivector_of_single_coefficients() {
    let error = |definition: &str| {
        let definition = define(&format!(
            "signature (3, 0, 1); entity Rotation {{ x: e23, z: e12 }} entity Shift {{ u: e01, w: e03 }}
             entity Vector {{ a: e1, b: e2 }} entity Even {{ s: 1, e23, e13, e12, e01, e02, e03, e0123 }}
             kernel f{definition};"
        ));
        Specification::new(&definition, only_kernel(&definition)).err()
    };
    let compound = |blade: &str, value: &str| Some(SpecificationError::CompoundCoefficient(blade.into(), value.into()));
    assert_eq!(error("(r: Rotation) -> Even = exp(r)"), None);
    assert_eq!(error("(r: Rotation) -> Even = exp(-3 * r)"), None);
    assert_eq!(error("(r: Rotation, a: Shift, b: Shift) -> Even = exp(r + a - b)"), None);
    assert_eq!(error("(r: Rotation, q: Rotation) -> Even = exp(r + q)"), compound("e12", "r.z + q.z"));
    assert_eq!(error("(r: Rotation, k: Scalar) -> Even = exp(k * r)"), compound("e12", "r.z k"));
    assert_eq!(error("(k: Scalar) -> Even = exp(k * e12 + 2 * k * e23)"), compound("e23", "2 k"));
    assert_eq!(error("(k: Scalar) -> Even = exp(k * e12 + e23)"), compound("e23", "1"));
    let vector = SpecificationError::NotABivector("e1".to_owned(), "v.a".to_owned());
    assert_eq!(error("(v: Vector) -> Even = exp(v)"), Some(vector));
}

/// Of rotors 2 r has the norm 4, which is 3 too much.
#[test]
fn an_output_holds_the_value_and_keeps_the_promises_of_its_type() {
    let error = |definition: &str| {
        let definition = define(&format!(
            "signature (2, 0, 0); entity Vector {{ x: e1, y: e2 }} entity Near {{ 1: 1, b: e12 }}
             entity Rotor {{ s: 1, b: e12 }} where s*s == 1 - b*b; kernel f{definition};"
        ));
        Specification::new(&definition, only_kernel(&definition)).err()
    };
    assert_eq!(error("(r: Rotor, q: Rotor) -> Rotor = r * q"), None);
    let promise = SpecificationError::BrokenPromise("s * s == 1 - b * b".to_owned(), "3".to_owned());
    assert_eq!(error("(r: Rotor) -> Rotor = 2 * r"), Some(promise));
    assert_eq!(error("(n: Near) -> Near = n + e12"), None);
    let constant = SpecificationError::WrongConstant("1".to_owned(), "1".to_owned(), "2".to_owned());
    assert_eq!(error("(n: Near) -> Near = 2 * n"), Some(constant));
    let outside = SpecificationError::CannotHold("e12".to_owned(), "v.x w.y - v.y w.x".to_owned());
    assert_eq!(error("(v: Vector, w: Vector) -> Scalar = v * w"), Some(outside));
    // What the type cannot hold is 0 by the relation.
    assert_eq!(error("(r: Rotor) -> Vector = (r * ~r - 1) * e1 + grade(r * e1, 1)"), None);
    assert_eq!(error("(r: Rotor) -> Vector = r * ~r - 1"), None);
}

#[test]
fn errors_say_what_was_expected_and_found() {
    use SpecificationError::*;
    let text = |word: &str| word.to_owned();
    for (error, expected) in [
        (Overflow, "exact arithmetic overflowed 128-bit rationals"),
        (
            CannotHold(text("e12"), text("2 a")),
            "expected an output that can hold `e12`, found none: its coefficient is 2 a",
        ),
        (
            WrongConstant(text("e12"), text("1"), text("2 a")),
            "expected the coefficient 1 of `e12` that the output type fixes, found 2 a",
        ),
        (NotAUnit(text("m"), text("2")), "expected a unit, x ~x = 1 for x = m, found x ~x = 2"),
        (BrokenPromise(text("s == 1"), text("a")), "expected an output with `s == 1`, found a difference of a"),
    ] {
        assert_eq!(error.to_string(), expected);
    }
}
