//! The meaning of a definition on the naive reference: a kernel's expression, product by product as it is written.

use crate::exact::Exact;
use crate::tracked::Tracked;
use ga_codegen::algebra::{Product, Signature};
use ga_codegen::kernel::{ComponentValue, Definition, Entity, Expression, ExpressionKind, Function, Kernel, Operator};
use ga_codegen::reference::{Multivector, Number};
use ga_codegen::symbolic::Rational;

/// A coefficient that can be any rational number.
pub(crate) trait Coefficient: Number + Copy {
    fn rational(value: Rational) -> Self;
}

impl Coefficient for Exact {
    fn rational(value: Rational) -> Self {
        Self::new(value.numerator(), value.denominator())
    }
}

impl Coefficient for Tracked {
    fn rational(value: Rational) -> Self {
        Self::new(value.numerator() as f64) / Self::new(value.denominator() as f64)
    }
}

/// The multivector of an entity whose fields have these values. Blades go by their names alone: in the presets these
/// are the words that the reference reads.
pub(crate) fn multivector<T: Coefficient>(signature: Signature, entity: &Entity, fields: &[T]) -> Multivector<T> {
    let mut fields = fields.iter().copied();
    let terms = entity.components.iter().map(|component| {
        let value = match component.value {
            ComponentValue::Field(_) => fields.next().expect("a value for every field"),
            ComponentValue::Constant(value) => T::rational(value),
        };
        (component.name.as_str(), value)
    });
    let terms: Vec<_> = terms.collect();
    assert!(fields.next().is_none(), "a field for every value");
    Multivector::from_blades(signature, terms).expect("names of blades that are words")
}

/// The definition of a polynomial kernel, or the argument of an analytic one, on a row of coefficients.
pub(crate) fn interpret<T: Coefficient>(definition: &Definition, kernel: &Kernel, row: &[T]) -> Multivector<T> {
    let signature = definition.basis.signature();
    let mut rest = row;
    let inputs: Vec<_> = kernel
        .parameters
        .iter()
        .map(|parameter| {
            let entity = &definition.entities[parameter.entity];
            let (fields, after) = rest.split_at(entity.fields().count());
            rest = after;
            multivector(signature, entity, fields)
        })
        .collect();
    evaluate(&kernel.expression, &inputs, signature)
}

fn evaluate<T: Coefficient>(
    expression: &Expression,
    inputs: &[Multivector<T>],
    signature: Signature,
) -> Multivector<T> {
    let value = |inner: &Expression| evaluate(inner, inputs, signature);
    match &expression.kind {
        ExpressionKind::Parameter(index) => inputs[*index].clone(),
        ExpressionKind::Blade(name, ..) => {
            Multivector::from_blades(signature, [(name, T::from(1))]).expect("the name of a blade that is a word")
        }
        ExpressionKind::Number(number) => Multivector::scalar(signature, T::rational(*number)),
        ExpressionKind::Negate(inner) => value(inner).neg(),
        ExpressionKind::Reverse(inner) => value(inner).reverse(),
        ExpressionKind::Grade(inner, grade) => value(inner).grade(*grade as usize),
        ExpressionKind::Quotient(inner, number) => {
            let reciprocal = Rational::new(number.denominator(), number.numerator()).expect("a divisor other than 0");
            value(inner).scale(T::rational(reciprocal))
        }
        ExpressionKind::Binary(operator, a, b) => {
            let (a, b) = (value(a), value(b));
            match operator {
                Operator::Add => a.add(&b),
                Operator::Sub => a.sub(&b),
                Operator::Geometric => a.geometric(&b),
                Operator::Outer => a.outer(&b),
                Operator::Regressive => a.regressive(&b),
                Operator::Inner => a.inner(&b),
                Operator::Sandwich => a.geometric(&b).geometric(&a.reverse()),
            }
        }
        ExpressionKind::Call(function, arguments) => {
            let arguments: Vec<_> = arguments.iter().map(value).collect();
            call(*function, &arguments)
        }
    }
}

fn call<T: Coefficient>(function: Function, arguments: &[Multivector<T>]) -> Multivector<T> {
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
        _ => panic!("a function with {} arguments", arguments.len()),
    }
}
