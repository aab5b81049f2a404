//! The meaning of an expression on the naive reference, product by product as it is written.

use super::coefficient::Running;
use super::{Coefficient, InputError};
use crate::algebra::{Product, Signature};
use crate::kernel::{Expression, ExpressionKind, Function, Operator};
use crate::reference::Multivector;
use crate::symbolic::Rational;

type Value<T> = Multivector<Running<T>>;

/// The value of an expression whose parameters are these.
pub(super) fn evaluate<T: Coefficient>(
    expression: &Expression,
    inputs: &[Value<T>],
    signature: Signature,
) -> Result<Value<T>, InputError> {
    let value = |inner: &Expression| evaluate(inner, inputs, signature);
    Ok(match &expression.kind {
        ExpressionKind::Parameter(index) => inputs[*index].clone(),
        ExpressionKind::Blade(name, ..) => Multivector::from_blades(signature, [(name, Running::from(1))])
            .expect("invariant: lowering checks that a blade is a word of the signature"),
        ExpressionKind::Number(number) => Multivector::scalar(signature, coefficient(*number)?),
        ExpressionKind::Negate(inner) => value(inner)?.neg(),
        ExpressionKind::Reverse(inner) => value(inner)?.reverse(),
        ExpressionKind::Grade(inner, grade) => value(inner)?.grade(*grade as usize),
        ExpressionKind::Quotient(inner, number) => {
            let reciprocal = Rational::ONE.checked_div(*number).ok().flatten();
            value(inner)?.scale(coefficient(reciprocal.expect("invariant: lowering checks the divisor"))?)
        }
        ExpressionKind::Binary(operator, a, b) => binary(*operator, &value(a)?, &value(b)?),
        ExpressionKind::Call(function, arguments) => {
            let arguments: Vec<_> = arguments.iter().map(value).collect::<Result<_, _>>()?;
            call(*function, &arguments)
        }
    })
}

fn coefficient<T: Coefficient>(number: Rational) -> Result<Running<T>, InputError> {
    let value = T::from_ratio(number.numerator(), number.denominator());
    value.map(Running::rounded).ok_or_else(|| InputError::Number { number: number.to_string() })
}

fn binary<T: Coefficient>(operator: Operator, a: &Value<T>, b: &Value<T>) -> Value<T> {
    match operator {
        Operator::Add => a.add(b),
        Operator::Sub => a.sub(b),
        Operator::Geometric => a.geometric(b),
        Operator::Outer => a.outer(b),
        Operator::Regressive => a.regressive(b),
        Operator::Inner => a.inner(b),
        Operator::Sandwich => a.sandwich(b),
    }
}

fn call<T: Coefficient>(function: Function, arguments: &[Value<T>]) -> Value<T> {
    match (function, arguments) {
        (Function::Dual, [x]) => x.dual(),
        (Function::Undual, [x]) => x.undual(),
        (Function::GradeInvolution, [x]) => x.grade_involution(),
        (Function::CliffordConjugate, [x]) => x.clifford_conjugate(),
        (Function::Product(product), [a, b]) => match product {
            Product::Geometric => a.geometric(b),
            Product::Outer => a.outer(b),
            Product::Regressive => a.regressive(b),
            Product::Inner => a.inner(b),
            Product::LeftContraction => a.left_contraction(b),
            Product::RightContraction => a.right_contraction(b),
            Product::Scalar => a.scalar_product(b),
            Product::Commutator => a.commutator(b),
            Product::Anticommutator => a.anticommutator(b),
        },
        _ => unreachable!("invariant: lowering checks the number of arguments"),
    }
}
