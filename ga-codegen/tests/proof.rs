//! What the proof accepts is right: programs and definitions that look right at first sight and are not are refuted.

use ga_codegen::Compiled;
use ga_codegen::kernel::{Definition, Specification};
use ga_codegen::program::{FloatDomain, Operation, Program, Value};
use ga_codegen::proof::{Proof, prove};
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
