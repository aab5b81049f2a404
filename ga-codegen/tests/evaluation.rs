//! Programs run on numbers and polynomials, and what they say about themselves.

use ga_codegen::approximation::{Function, Precision};
use ga_codegen::program::{FloatDomain, Operands, Operation, Program, Value};
use ga_codegen::proof::{Proof, Refutation, prove_evaluation};
use ga_codegen::symbolic::{Polynomial, Rational};

fn rational(numerator: i128, denominator: i128) -> Rational {
    Rational::new(numerator, denominator).expect("a rational number")
}

/// One operation on two inputs, the values 0 and 1, and a zero, the value 2.
fn one(operation: Operation) -> Program {
    let operations = vec![Operation::Input(0), Operation::Input(1), Operation::Constant(Rational::ZERO), operation];
    Program { operations, outputs: vec![3] }
}

fn on_three_and_four(operation: Operation) -> f64 {
    let Ok(outputs) = one(operation).evaluate(&FloatDomain, &[3.0, 4.0]);
    outputs[0]
}

fn operands(values: &[Value]) -> Operands {
    Operands::new(values).expect("few values")
}

#[test]
fn operations_on_floats_are_those_of_their_names() {
    let limit = rational(-3, 4);
    for (operation, expected) in [
        (Operation::Input(1), 4.0),
        (Operation::Constant(limit), -0.75),
        (Operation::Add(0, 1), 7.0),
        (Operation::Sub(0, 1), -1.0),
        (Operation::Mul(0, 1), 12.0),
        (Operation::Neg(0), -3.0),
        (Operation::Double(0), 6.0),
        (Operation::Div(0, 1), 0.75),
        (Operation::Sqrt(1), 2.0),
        (Operation::Norm(operands(&[0, 1])), 5.0),
        (Operation::Norm(operands(&[0, 2])), 3.0),
        (Operation::Norm(operands(&[])), 0.0),
        (Operation::Sin(0), 3_f64.sin()),
        (Operation::Cos(0), 3_f64.cos()),
        (Operation::Atan2(0, 1), 3_f64.atan2(4.0)),
        (Operation::Quotient(0, 1, limit), 0.75),
        (Operation::Quotient(0, 2, limit), -0.75),
    ] {
        assert_eq!(on_three_and_four(operation), expected, "{operation:?}");
    }
    // A polynomial comes nearer than two EPSILON, and Horner's rule rounds twice at each of fewer and fewer digits.
    for function in [Function::CosRoot, Function::SincRoot] {
        let quarter = Operation::Polynomial(function, Precision::F64, 0);
        let Ok(found) = one(quarter).evaluate(&FloatDomain, &[0.25, 0.0]);
        let expected = if function == Function::CosRoot { 0.5_f64.cos() } else { 0.5_f64.sin() / 0.5 };
        assert!((found[0] - expected).abs() <= 4.0 * f64::EPSILON, "{function:?}: {found:?}");
    }
}

#[test]
fn ring_operations_are_proved_on_polynomials() {
    let (x, y) = (Polynomial::symbol(0), Polynomial::symbol(1));
    let overflow = "small numbers";
    for (operation, expected) in [
        (Operation::Input(1), y.clone()),
        (Operation::Constant(rational(2, 3)), Polynomial::constant(rational(2, 3))),
        (Operation::Add(0, 1), x.add(&y).expect(overflow)),
        (Operation::Sub(0, 1), x.sub(&y).expect(overflow)),
        (Operation::Mul(0, 1), x.mul(&y).expect(overflow)),
        (Operation::Neg(0), x.neg()),
        (Operation::Double(0), x.scale(Rational::integer(2)).expect(overflow)),
    ] {
        let proof = |expected: &Polynomial| prove_evaluation(&one(operation), std::slice::from_ref(expected), 2);
        assert_eq!(proof(&expected), Ok(Proof::Exact), "{operation:?}");
        let other = expected.add(&x.mul(&x).expect(overflow)).expect(overflow);
        let difference = Refutation::Different("0".to_owned(), "-x0^2".to_owned());
        assert_eq!(proof(&other), Err(difference), "{operation:?}");
    }
    assert_eq!(prove_evaluation(&one(Operation::Neg(0)), &[], 2), Err(Refutation::OutputCount));
    assert_eq!(prove_evaluation(&one(Operation::Neg(0)), &[x.neg(), y], 2), Err(Refutation::OutputCount));
}

#[test]
fn polynomials_have_no_other_operations() {
    let (function, limit) = (Function::SincRoot, Rational::ONE);
    for (operation, name) in [
        (Operation::Div(0, 1), "a division"),
        (Operation::Sqrt(0), "a square root"),
        (Operation::Norm(operands(&[0, 1])), "a square root"),
        (Operation::Sin(0), "a sine"),
        (Operation::Cos(0), "a cosine"),
        (Operation::Atan2(0, 1), "an arc tangent"),
        (Operation::Quotient(0, 1, limit), "a quotient"),
        (Operation::Polynomial(function, Precision::F32, 0), "sinc_root"),
    ] {
        let refutation = prove_evaluation(&one(operation), &[Polynomial::zero()], 2).expect_err("no polynomial");
        assert_eq!(refutation.to_string(), format!("expected a program of ring operations, found {name}"));
    }
}

#[test]
fn an_overflow_refutes() {
    let most = Operation::Constant(rational(i128::MAX, 1));
    let operations = vec![Operation::Input(0), most, Operation::Mul(0, 1), Operation::Add(2, 2)];
    let twice = Program { operations, outputs: vec![3] };
    let refutation = prove_evaluation(&twice, &[Polynomial::zero()], 1);
    assert_eq!(refutation, Err(Refutation::Overflow));
    assert_eq!(Refutation::Overflow.to_string(), "exact arithmetic overflowed 128-bit rationals");
}

#[test]
fn operations_have_their_operands_in_order_and_keep_their_kind() {
    let (function, precision, limit) = (Function::AngleRatio, Precision::F64, Rational::ONE);
    type Make = Box<dyn Fn(Value, Value) -> Operation>;
    let make: [(Make, usize); 15] = [
        (Box::new(|_, _| Operation::Input(3)), 0),
        (Box::new(|_, _| Operation::Constant(Rational::ONE)), 0),
        (Box::new(|a, _| Operation::Neg(a)), 1),
        (Box::new(|a, _| Operation::Double(a)), 1),
        (Box::new(|a, _| Operation::Sqrt(a)), 1),
        (Box::new(|a, _| Operation::Sin(a)), 1),
        (Box::new(|a, _| Operation::Cos(a)), 1),
        (Box::new(move |a, _| Operation::Polynomial(function, precision, a)), 1),
        (Box::new(Operation::Add), 2),
        (Box::new(Operation::Sub), 2),
        (Box::new(Operation::Mul), 2),
        (Box::new(Operation::Div), 2),
        (Box::new(Operation::Atan2), 2),
        (Box::new(move |a, b| Operation::Quotient(a, b, limit)), 2),
        (Box::new(|a, b| Operation::Norm(operands(&[a, b]))), 2),
    ];
    for (make, count) in make {
        let operation = make(5, 7);
        assert_eq!(operation.operands().collect::<Vec<_>>(), [5, 7][..count]);
        assert_eq!(operation.map_operands(|value| 2 * value), make(10, 14));
    }
}

#[test]
fn operands_are_at_most_eight() {
    let eight: Vec<Value> = (1..=Operands::MOST).collect();
    assert_eq!(operands(&eight).iter().collect::<Vec<_>>(), eight);
    assert_eq!((operands(&eight).count(), operands(&[]).count(), operands(&[4]).count()), (8, 0, 1));
    assert_eq!(Operands::new(&[0; 9]), None);
    assert_eq!((operands(&[4]), operands(&[4, 2])), (Operands::from([4]), Operands::from([4, 2])));
    let negated = Operation::Norm(operands(&eight)).map_operands(|value| 8 - value);
    assert_eq!(negated.operands().collect::<Vec<_>>(), [7, 6, 5, 4, 3, 2, 1, 0]);
}

#[test]
fn a_program_names_its_polynomials() {
    let polynomials = [(Function::CosRoot, Precision::F32, 0), (Function::SincRoot, Precision::F64, 1)];
    let operations = polynomials.map(|(function, precision, value)| Operation::Polynomial(function, precision, value));
    let operations = vec![Operation::Input(0), Operation::Double(0), operations[0], operations[1]];
    assert_eq!(Program { operations, outputs: vec![2, 3] }.polynomials(), polynomials);
    assert_eq!(one(Operation::Sin(0)).polynomials(), []);
}

#[test]
fn numbers_of_emitted_code_are_quotients_of_two_i32() {
    let most = i128::from(i32::MAX);
    for (number, fits) in [
        (rational(most, 1), true),
        (rational(-most, 2), true),
        (rational(1, most), true),
        (rational(most + 1, 1), false),
        (rational(-most - 1, 1), false),
        (rational(-1, most + 1), false),
    ] {
        for operation in [Operation::Constant(number), Operation::Quotient(0, 1, number)] {
            assert_eq!(one(operation).unnameable_number(), (!fits).then_some(number), "{operation:?}");
        }
    }
}

#[test]
fn proofs_and_refutations_say_what_they_are() {
    for (proof, text) in
        [(Proof::Exact, "exact"), (Proof::Roots, "exact, roots included"), (Proof::Series(12), "series to order 12")]
    {
        assert_eq!(proof.to_string(), text);
    }
    let name = || "e12".to_owned();
    for (refutation, text) in [
        (Refutation::OutputCount, "the program has another number of outputs than its type has fields"),
        (Refutation::Undefined(name()), "e12"),
        (Refutation::CannotHold(name()), "expected an output that can hold `e12`, found none"),
        (Refutation::Different(name(), "2 a".to_owned()), "coefficient `e12`: program minus definition is 2 a"),
        (Refutation::BrokenPromise(name(), "2 a".to_owned()), "relation `e12`: the difference is 2 a"),
        (Refutation::Imprecise(name(), 7), "coefficient `e12`: the series is not known to order 7"),
    ] {
        assert_eq!(refutation.to_string(), text);
    }
}
