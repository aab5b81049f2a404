//! What the proof accepts is right: programs and definitions that look right at first sight and are not are refuted.

use ga_codegen::Compiled;
use ga_codegen::kernel::{Definition, Specification};
use ga_codegen::program::{Operation, Program, ProgramBuilder, Value};
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

/// The root of a program, which stands for the radical.
fn root(program: &Program) -> Value {
    program.operations.iter().position(|operation| matches!(operation, Operation::Sqrt(_))).expect("a root")
}

/// The program with one output times the root over the root: the same but where the root is 0.
fn with_output_over_root(program: &Program, output: usize) -> Program {
    let mut mutant = program.clone();
    let (root, first) = (root(program), program.operations.len());
    mutant.operations.push(Operation::Mul(program.outputs[output], root));
    mutant.operations.push(Operation::Quotient(first, root, Rational::ZERO));
    mutant.outputs[output] = first + 1;
    mutant
}

/// The limit 0 of `x l / l` is right at the origin alone, while l is 0 for every translation.
#[test]
fn a_limit_holds_wherever_the_radical_is_0() {
    for (preset, kernel) in
        [("pga3d", "line_exp"), ("pga3d", "motor_log"), ("pga2d", "bivector_exp"), ("pga2d", "motor_log")]
    {
        let compiled = compiled(preset, kernel);
        assert!(matches!(prove(&compiled.specification, &compiled.program), Ok(Proof::Series(_))));
        for (output, field) in compiled.specification.fields.iter().enumerate() {
            // Where the output vanishes with the radical the limit is right, but that is not for the proof to find out.
            let mutant = with_output_over_root(&compiled.program, output);
            let proof = prove(&compiled.specification, &mutant);
            assert!(proof.is_err(), "{kernel} {field}: {proof:?}");
        }
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
