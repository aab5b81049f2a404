//! What the proof accepts is right: programs and definitions that look right at first sight and are not are refuted.

use ga_codegen::Compiled;
use ga_codegen::kernel::{Definition, Specification};
use ga_codegen::program::{FloatDomain, Operation, Program, ProgramBuilder, Value};
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
    for kernel in ["motor_sqrt", "even_normalize", "motor_between_lines"] {
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

/// The root of -x^2 is no number for any x but 0.
#[test]
fn a_radical_is_a_sum_of_squares() {
    let definition = define(
        "signature (1, 1, 0); entity Bivector { e12 } entity Even { s: 1, e12 } kernel f(b: Bivector) -> Even = exp(b);",
    );
    let specification = Specification::new(&definition, &definition.kernels[0]).expect("a bivector");
    let mut builder = ProgramBuilder::new();
    let x = builder.push(Operation::Input(0));
    let square = builder.push(Operation::Mul(x, x));
    let negative = builder.push(Operation::Neg(square));
    let norm = builder.push(Operation::Sqrt(negative));
    let (cos, sin) = (builder.push(Operation::Cos(norm)), builder.push(Operation::Sin(norm)));
    let sinc = builder.push(Operation::Quotient(sin, norm, Rational::ONE));
    let product = builder.push(Operation::Mul(sinc, x));
    let program = builder.finish(&[cos, product]);
    let refutation = prove(&specification, &program).expect_err("a program that is not a number");
    assert!(refutation.to_string().starts_with("expected a sum of squares as the square of a radical"), "{refutation}");
}
