//! What the proof accepts is right: programs and definitions that look right at first sight and are not are refuted.

use ga_codegen::Compiled;
use ga_codegen::approximation::{Function as Approximated, Precision};
use ga_codegen::kernel::{Definition, Specification};
use ga_codegen::program::{FloatDomain, Operands, Operation, Program, Value};
use ga_codegen::proof::{ORDER, Proof, Refutation, prove};
use ga_codegen::symbolic::Rational;

fn define(block: &str) -> Definition {
    ga_codegen::define(block.parse().expect("tokens")).expect("a block without errors")
}

/// A kernel of a preset.
fn compiled(preset: &str, kernel: &str) -> Compiled {
    let text = ga_codegen::preset::text(preset).expect("a preset");
    let mut definition = define(text);
    definition.kernels.retain(|other| other.name == kernel);
    ga_codegen::compile(&definition).expect("a preset that is proved").remove(0)
}

/// The norm that a program computes, which stands for the radical.
fn norm(program: &Program) -> Value {
    program.operations.iter().position(|operation| matches!(operation, Operation::Norm(_))).expect("a norm")
}

/// The program with one output times the norm over the norm: the same but where the norm is 0, where it is 0.
fn with_output_over_norm(program: &Program, output: usize) -> Program {
    let mut mutant = program.clone();
    let (norm, first) = (norm(program), program.operations.len());
    mutant.operations.push(Operation::Mul(program.outputs[output], norm));
    mutant.operations.push(Operation::Quotient(first, norm, Rational::ZERO));
    mutant.outputs[output] = first + 1;
    mutant
}

/// The limit 0 of `x l / l` is right where x is 0 with l, and wrong where x is something for a translation.
#[test]
fn limits_are_proved_where_the_norm_is_0() {
    for (preset, kernel) in
        [("pga3d", "line_exp"), ("pga3d", "motor_log"), ("pga2d", "bivector_exp"), ("pga2d", "motor_log")]
    {
        let compiled = compiled(preset, kernel);
        assert!(matches!(prove(&compiled.specification, &compiled.program), Ok(Proof::Series(_))));
        let translation: Vec<_> = compiled.specification.coefficients.iter().map(|c| f64::from(c.degree)).collect();
        let translation: Vec<_> = translation
            .iter()
            .zip(&compiled.specification.coefficients)
            .map(|(x, c)| if c.field == "s" { 1.0 } else { *x })
            .collect();
        let Ok(at_translation) = compiled.program.evaluate(&FloatDomain, &translation);
        for (output, field) in compiled.specification.fields.iter().enumerate() {
            let mutant = with_output_over_norm(&compiled.program, output);
            let proof = prove(&compiled.specification, &mutant);
            let same = at_translation[output] == 0.0 || field == "e0123";
            assert_eq!(proof.is_ok(), same, "{kernel} {field}: {proof:?}");
        }
    }
}

/// A root that is the other one, or that belongs to another motion, is refuted, whatever its square.
#[test]
fn a_root_is_the_one_near_the_identity() {
    for kernel in ["motor_sqrt", "even_normalize"] {
        let Compiled { specification, program, .. } = compiled("pga3d", kernel);
        assert_eq!(prove(&specification, &program), Ok(Proof::Roots));
        let mut other = program.clone();
        for output in 0..other.outputs.len() {
            other.operations.push(Operation::Neg(program.outputs[output]));
            other.outputs[output] = other.operations.len() - 1;
        }
        assert!(prove(&specification, &other).is_err(), "{kernel}: the negative");
        let root = program.operations.iter().position(|o| matches!(o, Operation::Sqrt(_))).expect("a root");
        let Operation::Sqrt(square) = program.operations[root] else { panic!("a root") };
        let mut other = program;
        other.operations[root] = Operation::Sqrt(square.saturating_sub(1));
        assert!(prove(&specification, &other).is_err(), "{kernel}: the root of something else");
    }
}

/// Series are compared to order 12 at least, and beyond the degree of the program.
#[test]
fn a_polynomial_of_any_degree_is_not_overlooked() {
    for power in [1, 12, 13, 19, 20, 1000] {
        for (preset, kernel) in [("pga3d", "line_exp"), ("pga2d", "motor_log")] {
            let Compiled { specification, mut program, .. } = compiled(preset, kernel);
            let input = |operation: &Operation| matches!(operation, Operation::Input(_));
            let x = program.operations.iter().position(input).expect("an input");
            let push = |program: &mut Program, operation| {
                program.operations.push(operation);
                program.operations.len() - 1
            };
            let mut wrong = x;
            for _ in 1..power {
                wrong = push(&mut program, Operation::Mul(wrong, x));
            }
            let first = program.outputs[0];
            program.outputs[0] = push(&mut program, Operation::Add(first, wrong));
            let proof = prove(&specification, &program);
            assert!(proof.is_err(), "{kernel} and a power of {power}: {proof:?}");
        }
    }
}

/// A program of exp in the plane with something done to one of its outputs.
fn with_changed_cosine(change: impl Fn(&mut Vec<Operation>, Value, Value) -> Value) -> (Specification, Program) {
    let Compiled { specification, mut program, .. } = compiled("pga2d", "bivector_exp");
    let (norm, first) = (norm(&program), program.outputs[0]);
    program.outputs[0] = change(&mut program.operations, norm, first);
    (specification, program)
}

fn push(operations: &mut Vec<Operation>, operation: Operation) -> Value {
    operations.push(operation);
    operations.len() - 1
}

/// l^16 l / l^16 / l^8 is 1 / l^7, and times l^12 again l^5: divisions by more than is known leave nothing known.
#[test]
fn orders_that_divisions_lose_are_not_won_back() {
    let (specification, program) = with_changed_cosine(|operations, l, cosine| {
        let mut powers = vec![l, l];
        for power in 2..=16 {
            let next = push(operations, Operation::Mul(powers[power - 1], l));
            powers.push(next);
        }
        let high = push(operations, Operation::Mul(powers[16], l));
        let once = push(operations, Operation::Quotient(high, powers[16], Rational::ZERO));
        let pole = push(operations, Operation::Quotient(once, powers[8], Rational::ZERO));
        let excess = push(operations, Operation::Mul(pole, powers[12]));
        push(operations, Operation::Add(cosine, excess))
    });
    assert!(prove(&specification, &program).is_err());
}

/// Divisions by l^n lose n orders; four more are carried than are compared.
#[test]
fn a_series_must_be_known_to_the_order_of_the_proof() {
    for n in 1..=6 {
        let (specification, program) = with_changed_cosine(|operations, l, cosine| {
            let power = (1..n).fold(l, |power, _| push(operations, Operation::Mul(power, l)));
            let product = push(operations, Operation::Mul(cosine, power));
            push(operations, Operation::Quotient(product, power, Rational::ONE))
        });
        let expected =
            if n <= 4 { Ok(Proof::Series(ORDER)) } else { Err(Refutation::Imprecise("s".to_owned(), ORDER)) };
        assert_eq!(prove(&specification, &program), expected, "l^{n}");
    }
}

/// An exponential in the plane is cos l + sin l b / l: on the circle and not on the hyperbola.
#[test]
fn an_exponential_keeps_what_its_type_promises() {
    for (promise, holds) in [("1 - b*b", true), ("1 + b*b", false), ("1", false)] {
        let definition = define(&format!(
            "signature (2, 0, 0); entity Bivector {{ b: e12 }} entity Unit {{ s: 1, b: e12 }} where s*s == {promise};
             kernel f(a: Bivector) -> Unit = exp(a);"
        ));
        let compiled = ga_codegen::compile(&definition);
        assert_eq!(compiled.is_ok(), holds, "{promise}: {:?}", compiled.err());
    }
}

/// (1 - l) / (1 - l) is 1 about l = 0, and the limit 7 at l = 1.
#[test]
fn a_program_of_exp_divides_by_norms_alone() {
    let (specification, program) = with_changed_cosine(|operations, l, cosine| {
        let one = push(operations, Operation::Constant(Rational::ONE));
        let rest = push(operations, Operation::Sub(one, l));
        let ratio = push(operations, Operation::Quotient(rest, rest, Rational::integer(7)));
        push(operations, Operation::Mul(cosine, ratio))
    });
    let refutation = prove(&specification, &program).expect_err("a limit that is wrong at l = 1");
    assert!(refutation.to_string().starts_with("expected a division by a norm"), "{refutation}");
}

/// l (1 - l) / (l (1 - l)) is 1 about l = 0, and the limit at l = 1 as well as at 0, whichever it is.
#[test]
fn a_norm_times_another_number_is_no_norm() {
    for other_first in [false, true] {
        let (specification, program) = with_changed_cosine(|operations, l, cosine| {
            let one = push(operations, Operation::Constant(Rational::ONE));
            let rest = push(operations, Operation::Sub(one, l));
            let (a, b) = if other_first { (rest, l) } else { (l, rest) };
            let product = push(operations, Operation::Mul(a, b));
            let ratio = push(operations, Operation::Quotient(product, product, Rational::ONE));
            push(operations, Operation::Mul(cosine, ratio))
        });
        let refutation = prove(&specification, &program).expect_err("a denominator that is 0 at l = 1");
        assert!(refutation.to_string().starts_with("expected a division by a norm"), "{refutation}");
    }
}

/// Roots of negative numbers, and divisions by what is 0 for every input or for some, where A is not.
#[test]
fn a_program_of_roots_is_a_number_wherever_the_norm_is() {
    type Factor = fn(&mut Vec<Operation>, Value, Value) -> Value;
    let no_numbers: [Factor; 3] = [
        |operations, square, _| {
            let negative = push(operations, Operation::Neg(square));
            let root = push(operations, Operation::Sqrt(negative));
            let product = push(operations, Operation::Mul(root, root));
            push(operations, Operation::Div(product, negative))
        },
        |operations, square, root| {
            let twice = push(operations, Operation::Double(square));
            let four = push(operations, Operation::Double(twice));
            let (double, other) = (push(operations, Operation::Double(root)), push(operations, Operation::Sqrt(four)));
            let zero = push(operations, Operation::Sub(other, double));
            push(operations, Operation::Div(zero, zero))
        },
        |operations, _, _| push(operations, Operation::Div(1, 1)),
    ];
    for kernel in ["even_normalize", "motor_sqrt"] {
        for (index, factor) in no_numbers.iter().enumerate() {
            let Compiled { specification, mut program, .. } = compiled("pga3d", kernel);
            let root = program.operations.iter().position(|o| matches!(o, Operation::Sqrt(_))).expect("a root");
            let Operation::Sqrt(square) = program.operations[root] else { panic!("a root") };
            let one = factor(&mut program.operations, square, root);
            for output in 0..program.outputs.len() {
                program.outputs[output] = push(&mut program.operations, Operation::Mul(program.outputs[output], one));
            }
            assert!(prove(&specification, &program).is_err(), "{kernel}, factor {index}");
        }
    }
}

/// The norm of a translator is 1, and that of 1 more is 4: roots of numbers are numbers.
#[test]
fn translators_have_roots_and_units() {
    let definition = define(
        "signature (3, 0, 1); entity Translator { 1: 1, e01, e02, e03 }
         kernel half(t: Translator) -> Translator = sqrt(t); kernel same(t: Translator) -> Translator = normalize(t);",
    );
    let compiled = ga_codegen::compile(&definition).expect("translators are units");
    assert!(compiled.iter().all(|compiled| compiled.proof == Proof::Roots));
}

/// Of vectors in the plane a program with a wrong sign, with an output too many and with none.
#[test]
fn a_refutation_says_what_differs_and_by_how_much() {
    let definition = define(
        "signature (2, 0, 0); entity Vector { x: e1, y: e2 } entity Even { s: 1, b: e12 }
         kernel dot(a: Vector, b: Vector) -> Scalar = a | b; kernel product(a: Vector, b: Vector) -> Even = a * b;",
    );
    let compiled = ga_codegen::compile(&definition).expect("proofs");
    let [dot, product] = compiled.as_slice() else { panic!("two kernels") };
    let inputs = (0..4).map(Operation::Input);
    let wrong = |outputs: Vec<Value>| {
        let products = [Operation::Mul(0, 2), Operation::Mul(1, 3), Operation::Sub(4, 5)];
        Program { operations: inputs.clone().chain(products).collect(), outputs }
    };
    let different = |name: &str, by: &str| Err(Refutation::Different(name.to_owned(), by.to_owned()));
    assert_eq!(prove(&dot.specification, &dot.program), Ok(Proof::Exact));
    assert_eq!(prove(&dot.specification, &wrong(vec![6])), different("1", "-2 a.y b.y"));
    assert_eq!(prove(&product.specification, &wrong(vec![6, 6])), different("s", "-2 a.y b.y"));
    for outputs in [vec![], vec![6, 6]] {
        assert_eq!(prove(&dot.specification, &wrong(outputs)), Err(Refutation::OutputCount));
    }
}

/// What a program computes and does not use has to have a value as well.
fn with_operation(compiled: &Compiled, operation: impl Fn(&mut Vec<Operation>)) -> Result<Proof, Refutation> {
    let mut program = compiled.program.clone();
    operation(&mut program.operations);
    prove(&compiled.specification, &program)
}

#[test]
fn a_program_of_roots_takes_no_functions_and_no_limits() {
    let compiled = compiled("pga3d", "even_normalize");
    let function = Operation::Polynomial(Approximated::CosRoot, Precision::F64, 0);
    for (operation, name) in [
        (Operation::Sin(0), "a sine"),
        (Operation::Cos(0), "a cosine"),
        (Operation::Atan2(0, 1), "an arc tangent"),
        (Operation::Quotient(0, 1, Rational::ZERO), "a quotient with a limit"),
        (function, "cos_root"),
    ] {
        let refutation = with_operation(&compiled, |operations| operations.push(operation)).expect_err("no root");
        let expected = format!("expected a program of ring operations, roots and divisions, found {name}");
        assert_eq!(refutation, Refutation::Undefined(expected));
    }
    assert_eq!(with_operation(&compiled, |operations| operations.push(Operation::Neg(0))), Ok(Proof::Roots));
}

/// Where the norm is 0, e23 is and e01 need not be: a sine of the one has a value there, of the other none that is known.
#[test]
fn functions_have_values_where_the_norm_is_0() {
    let compiled = compiled("pga3d", "line_exp");
    let input = |field: &str| {
        let symbol = compiled.specification.coefficients.iter().position(|c| c.field == field).expect("a field");
        let value = compiled.program.operations.iter().position(|o| *o == Operation::Input(symbol));
        value.expect("an input")
    };
    let functions: [fn(&mut Vec<Operation>, Value); 4] = [
        |operations, x| operations.push(Operation::Sin(x)),
        |operations, x| operations.push(Operation::Cos(x)),
        |operations, x| operations.push(Operation::Polynomial(Approximated::SincRoot, Precision::F64, x)),
        |operations, x| {
            let one = push(operations, Operation::Constant(Rational::ONE));
            operations.push(Operation::Atan2(x, one));
        },
    ];
    for (index, function) in functions.into_iter().enumerate() {
        let proof = |field: &str| with_operation(&compiled, |operations| function(operations, input(field)));
        assert_eq!(proof("e23"), Ok(Proof::Series(ORDER)), "function {index}");
        let refutation = proof("e01").expect_err("no number").to_string();
        assert!(refutation.contains("where the norm is 0"), "function {index}: {refutation}");
    }
    let angle_about = |x: Value| {
        with_operation(&compiled, |operations| {
            let one = push(operations, Operation::Constant(Rational::ONE));
            let beside = push(operations, Operation::Add(one, x));
            operations.push(Operation::Atan2(input("e23"), beside));
        })
    };
    assert_eq!(angle_about(input("e23")), Ok(Proof::Series(ORDER)));
    assert!(angle_about(input("e01")).is_err());
}

/// l / l is 1 but where l is 0, and sqrt(1 + l^2) divides everywhere.
#[test]
fn divisions_without_a_limit_need_a_denominator_that_is_nowhere_0() {
    let compiled = compiled("pga2d", "bivector_exp");
    let radical = norm(&compiled.program);
    let Operation::Norm(components) = compiled.program.operations[radical] else { panic!("a norm") };
    let by_radical = with_operation(&compiled, |operations| operations.push(Operation::Div(radical, radical)));
    assert!(by_radical.expect_err("0 / 0").to_string().contains("a number other than 0 to divide by"));
    let (specification, program) = with_changed_cosine(|operations, _, cosine| {
        let two = push(operations, Operation::Constant(Rational::integer(2)));
        let one = push(operations, Operation::Constant(Rational::ONE));
        let components: Vec<_> = components.iter().chain([one]).collect();
        let larger = push(operations, Operation::Norm(Operands::new(&components).expect("few")));
        let product = push(operations, Operation::Mul(cosine, larger));
        let double = push(operations, Operation::Mul(product, two));
        let quotient = push(operations, Operation::Div(double, larger));
        push(operations, Operation::Sub(quotient, cosine))
    });
    assert_eq!(prove(&specification, &program), Ok(Proof::Series(ORDER)));
}

/// An exponential of what squares to 0 is 1 more.
#[test]
fn an_exponential_has_the_blades_of_its_type_and_the_numbers_that_it_fixes() {
    let error = |components: &str| {
        let definition = define(&format!(
            "signature (2, 0, 1); entity Shift {{ u: e01, v: e02 }} entity Translator {{ {components} }}
             kernel f(a: Shift) -> Translator = exp(a);"
        ));
        let errors = ga_codegen::compile(&definition).err().into_iter().flatten();
        errors.map(|error| error.to_string()).collect::<Vec<_>>().join("; ")
    };
    for components in ["1: 1, u: e01, v: e02", "s: 1, u: e01, v: e02, b: e12", "u: e01, v: e02, 1: 1"] {
        assert_eq!(error(components), "", "{components}");
    }
    for (components, expected) in [
        ("u: e01, v: e02", "expected an output that can hold `1`, found none"),
        ("1: 1, u: e01", "expected an output that can hold `e02`, found none"),
        ("2: 1, u: e01, v: e02", "coefficient `1`: program minus definition is 1"),
        ("1: 1, u: e01, v: e02, 3: e12", "coefficient `e12`: program minus definition is 3"),
    ] {
        let found = error(components);
        assert!(found.contains(expected), "{components}: {found}");
    }
}

/// (2 l^7)^2 is of degree 14, whatever it is the square of, and numbers as factors are of none.
#[test]
fn sums_have_the_degree_of_their_terms_and_numbers_none() {
    let (specification, program) = with_changed_cosine(|operations, l, cosine| {
        let seventh = (1..7).fold(l, |power, _| push(operations, Operation::Mul(power, l)));
        let double = push(operations, Operation::Double(seventh));
        let square = push(operations, Operation::Mul(double, double));
        push(operations, Operation::Add(cosine, square))
    });
    assert!(matches!(prove(&specification, &program), Err(Refutation::Different(..))));
    let (specification, program) = with_changed_cosine(|operations, _, cosine| {
        let one = push(operations, Operation::Constant(Rational::ONE));
        (0..20).fold(cosine, |product, _| push(operations, Operation::Mul(product, one)))
    });
    assert_eq!(prove(&specification, &program), Ok(Proof::Series(ORDER)));
    // What has the degree 13 is compared to order 14.
    let (specification, program) = with_changed_cosine(|operations, l, cosine| {
        let power = (1..13).fold(l, |power, _| push(operations, Operation::Mul(power, l)));
        let more = push(operations, Operation::Add(cosine, power));
        push(operations, Operation::Sub(more, power))
    });
    assert_eq!(prove(&specification, &program), Ok(Proof::Series(14)));
}

/// l / l is 1, and where l is 0 what is stated as its limit: 1 less than 7 has no sine that is known.
#[test]
fn functions_of_a_wrong_limit_are_refused() {
    let compiled = compiled("pga2d", "bivector_exp");
    let radical = norm(&compiled.program);
    for (limit, known) in [(1, true), (7, false)] {
        let proof = with_operation(&compiled, |operations| {
            let ratio = push(operations, Operation::Quotient(radical, radical, Rational::integer(limit)));
            let one = push(operations, Operation::Constant(Rational::ONE));
            let rest = push(operations, Operation::Sub(ratio, one));
            push(operations, Operation::Sin(rest));
        });
        assert_eq!(proof.is_ok(), known, "{limit}: {proof:?}");
    }
}

#[test]
fn an_argument_of_log_holds_every_exponential() {
    let definition = define(
        "signature (2, 0, 1); entity Shift { u: e01, v: e02 } entity Translator { 1: 1, u: e01, v: e02 }
         kernel f(t: Translator) -> Shift = log(t);",
    );
    assert!(ga_codegen::compile(&definition).is_ok());
    // Unit by its relation, but of exponentials, cos l + sin l b / l, it holds 1 alone.
    let definition = define(
        "signature (2, 0, 0); entity Bivector { b: e12 } entity Near { 1: 1, b: e12 } where b*b == 0;
         kernel f(n: Near) -> Bivector = log(n);",
    );
    let specification = Specification::new(&definition, &definition.kernels[0]).expect("a unit");
    let program = Program { operations: vec![Operation::Input(0)], outputs: vec![0] };
    let refutation = prove(&specification, &program).expect_err("no argument");
    let expected = "expected an argument type that holds every exponential, found none with";
    assert!(refutation.to_string().starts_with(expected), "{refutation}");
}

#[test]
fn a_wrong_coefficient_of_an_exponential_is_named() {
    let definition = define(
        "signature (2, 0, 0); entity Bivector { b: e12 } entity Even { s: 1, b: e12 }
         kernel f(a: Bivector) -> Even = exp(a);",
    );
    let compiled = ga_codegen::compile(&definition).expect("a proof").remove(0);
    for (output, field) in [(0, "s"), (1, "b")] {
        let mut program = compiled.program.clone();
        let x = program.operations.iter().position(|o| matches!(o, Operation::Input(_))).expect("an input");
        program.outputs[output] = push(&mut program.operations, Operation::Add(program.outputs[output], x));
        let expected = Refutation::Different(field.to_owned(), "a.b/l l".to_owned());
        assert_eq!(prove(&compiled.specification, &program), Err(expected));
    }
}

/// Of a unit s + b e12 the norm is s^2 + b^2.
#[test]
fn a_unit_keeps_its_promise_and_a_wrong_coefficient_is_named() {
    let block = |promise: &str| {
        define(&format!(
            "signature (2, 0, 0); entity Even {{ s: 1, b: e12 }} entity Unit {{ s: 1, b: e12 }} where s*s == {promise};
             kernel f(y: Even) -> Unit = normalize(y);"
        ))
    };
    assert!(ga_codegen::compile(&block("1 + b*b")).is_err());
    let Compiled { specification, program, .. } =
        ga_codegen::compile(&block("1 - b*b")).expect("the norm of a unit is 1").remove(0);
    for (output, name) in [(0, "1"), (1, "e12")] {
        let mut other = program.clone();
        other.outputs[output] = push(&mut other.operations, Operation::Neg(program.outputs[output]));
        let refutation = prove(&specification, &other).expect_err("another sign");
        assert!(matches!(&refutation, Refutation::Different(found, _) if found == name), "{refutation}");
    }
}

/// The root of 4 is 2, and that of 4 / r no power of r.
#[test]
fn roots_are_of_squares_of_numbers_or_of_the_norm() {
    let compiled = compiled("pga3d", "even_normalize");
    let root = compiled.program.operations.iter().position(|o| matches!(o, Operation::Sqrt(_))).expect("a root");
    for (number, over_root, known) in [(4, false, true), (2, false, false), (4, true, false)] {
        let proof = with_operation(&compiled, |operations| {
            let number = push(operations, Operation::Constant(Rational::integer(number)));
            let square = if over_root { push(operations, Operation::Div(number, root)) } else { number };
            push(operations, Operation::Sqrt(square));
        });
        assert_eq!(proof.is_ok(), known, "{number}: {proof:?}");
    }
}
