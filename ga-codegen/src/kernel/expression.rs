//! Expressions of geometric algebra.

use crate::algebra::{Basis, Blade, Product, Sign};
use crate::symbolic::{Multivector, Overflow, Polynomial, Rational};
use proc_macro2::Span;

/// An operator between two expressions. Precedence is Rust's: `*` and `/` bind tightest, then `+` and `-`, then `>>`,
/// `&`, `^`, `|`; all group to the left.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Operator {
    /// `a + b`
    Add,
    /// `a - b`
    Sub,
    /// `a * b`, the geometric product.
    Geometric,
    /// `a ^ b`, the outer product.
    Outer,
    /// `a & b`, the regressive product.
    Regressive,
    /// `a | b`, the inner product.
    Inner,
    /// `m >> x`, the sandwich `m * x * ~m`.
    Sandwich,
}

impl Operator {
    /// How it is written.
    pub const fn symbol(self) -> &'static str {
        match self {
            Self::Add => "+",
            Self::Sub => "-",
            Self::Geometric => "*",
            Self::Outer => "^",
            Self::Regressive => "&",
            Self::Inner => "|",
            Self::Sandwich => ">>",
        }
    }

    /// How tightly it binds.
    pub const fn precedence(self) -> u8 {
        match self {
            Self::Inner => 1,
            Self::Outer => 2,
            Self::Regressive => 3,
            Self::Sandwich => 4,
            Self::Add | Self::Sub => 5,
            Self::Geometric => 6,
        }
    }
}

const UNARY_PRECEDENCE: u8 = 7;

/// A function that is written with its name.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Function {
    /// `dual(x)`, the right complement.
    Dual,
    /// `undual(x)`, its inverse.
    Undual,
    /// `grade_involution(x)`
    GradeInvolution,
    /// `clifford_conjugate(x)`
    CliffordConjugate,
    /// A product without an operator of its own, such as `left_contraction(a, b)`.
    Product(Product),
}

impl Function {
    /// Every function that an expression may call, by name.
    pub const ALL: [(&'static str, Self); 9] = [
        ("dual", Self::Dual),
        ("undual", Self::Undual),
        ("grade_involution", Self::GradeInvolution),
        ("clifford_conjugate", Self::CliffordConjugate),
        ("left_contraction", Self::Product(Product::LeftContraction)),
        ("right_contraction", Self::Product(Product::RightContraction)),
        ("scalar_product", Self::Product(Product::Scalar)),
        ("commutator", Self::Product(Product::Commutator)),
        ("anticommutator", Self::Product(Product::Anticommutator)),
    ];

    /// How many arguments it takes.
    pub const fn arity(self) -> usize {
        if matches!(self, Self::Product(_)) { 2 } else { 1 }
    }

    fn name(self) -> &'static str {
        Self::ALL.iter().find(|(_, function)| *function == self).map_or("?", |(name, _)| name)
    }
}

/// An expression and where it stands.
#[derive(Clone, Debug)]
pub struct Expression {
    /// What it is.
    pub kind: ExpressionKind,
    /// Where it stands.
    pub span: Span,
}

/// What an expression is.
#[derive(Clone, Debug)]
pub enum ExpressionKind {
    /// The parameter of that index.
    Parameter(usize),
    /// A basis blade under its name, which is `sign * blade`.
    Blade(String, Sign, Blade),
    /// A number.
    Number(Rational),
    /// `-x`
    Negate(Box<Expression>),
    /// `~x`
    Reverse(Box<Expression>),
    /// `grade(x, k)`
    Grade(Box<Expression>, u32),
    /// An expression divided by a number other than 0.
    Quotient(Box<Expression>, Rational),
    /// Two expressions and an operator between them.
    Binary(Operator, Box<Expression>, Box<Expression>),
    /// A function and its arguments, as many as its arity.
    Call(Function, Vec<Expression>),
}

impl Expression {
    /// The value where the parameters are these multivectors.
    ///
    /// # Errors
    /// [`Overflow`]
    pub fn evaluate(&self, inputs: &[Multivector], basis: &Basis) -> Result<Multivector, Overflow> {
        let value = |expression: &Self| expression.evaluate(inputs, basis);
        match &self.kind {
            ExpressionKind::Parameter(index) => Ok(inputs.get(*index).cloned().unwrap_or_default()),
            ExpressionKind::Blade(_, sign, blade) => {
                let coefficient = if sign.is_minus() { Rational::MINUS_ONE } else { Rational::ONE };
                Ok(Multivector::term(*blade, Polynomial::constant(coefficient)))
            }
            ExpressionKind::Number(number) => Ok(Multivector::scalar(Polynomial::constant(*number))),
            ExpressionKind::Negate(inner) => Ok(value(inner)?.neg()),
            ExpressionKind::Reverse(inner) => Ok(value(inner)?.reverse()),
            ExpressionKind::Grade(inner, grade) => Ok(value(inner)?.grade(*grade)),
            ExpressionKind::Quotient(inner, number) => {
                value(inner)?.scale(Rational::ONE.checked_div(*number)?.ok_or(Overflow)?)
            }
            ExpressionKind::Binary(operator, a, b) => apply(*operator, &value(a)?, &value(b)?, basis),
            ExpressionKind::Call(function, arguments) => {
                let values: Vec<_> = arguments.iter().map(value).collect::<Result<_, _>>()?;
                call(*function, &values, basis)
            }
        }
    }

    /// The expression as it is written, with these names for the parameters.
    pub fn display(&self, names: &[&str]) -> String {
        self.display_within(names, 0)
    }

    fn display_within(&self, names: &[&str], outer: u8) -> String {
        let text = match &self.kind {
            ExpressionKind::Parameter(index) => names.get(*index).copied().unwrap_or("?").to_owned(),
            ExpressionKind::Blade(name, ..) => name.clone(),
            ExpressionKind::Number(number) => number.to_string(),
            ExpressionKind::Negate(inner) => format!("-{}", inner.display_within(names, UNARY_PRECEDENCE)),
            ExpressionKind::Reverse(inner) => format!("~{}", inner.display_within(names, UNARY_PRECEDENCE)),
            ExpressionKind::Grade(inner, grade) => format!("grade({}, {grade})", inner.display(names)),
            ExpressionKind::Quotient(inner, number) => {
                format!("{} / {number}", inner.display_within(names, Operator::Geometric.precedence()))
            }
            ExpressionKind::Binary(operator, a, b) => {
                let precedence = operator.precedence();
                let (a, b) = (a.display_within(names, precedence), b.display_within(names, precedence + 1));
                format!("{a} {} {b}", operator.symbol())
            }
            ExpressionKind::Call(function, arguments) => {
                let arguments: Vec<_> = arguments.iter().map(|argument| argument.display(names)).collect();
                format!("{}({})", function.name(), arguments.join(", "))
            }
        };
        if self.precedence() < outer { format!("({text})") } else { text }
    }

    fn precedence(&self) -> u8 {
        match &self.kind {
            ExpressionKind::Binary(operator, ..) => operator.precedence(),
            ExpressionKind::Quotient(..) => Operator::Geometric.precedence(),
            ExpressionKind::Negate(_) | ExpressionKind::Reverse(_) => UNARY_PRECEDENCE,
            _ => u8::MAX,
        }
    }
}

fn apply(operator: Operator, a: &Multivector, b: &Multivector, basis: &Basis) -> Result<Multivector, Overflow> {
    match operator {
        Operator::Add => a.add(b),
        Operator::Sub => a.sub(b),
        Operator::Geometric => a.product(Product::Geometric, b, basis),
        Operator::Outer => a.product(Product::Outer, b, basis),
        Operator::Regressive => a.product(Product::Regressive, b, basis),
        Operator::Inner => a.product(Product::Inner, b, basis),
        Operator::Sandwich => a.product(Product::Geometric, b, basis)?.product(Product::Geometric, &a.reverse(), basis),
    }
}

fn call(function: Function, arguments: &[Multivector], basis: &Basis) -> Result<Multivector, Overflow> {
    match (function, arguments) {
        (Function::Dual, [x]) => Ok(x.dual(basis)),
        (Function::Undual, [x]) => Ok(x.undual(basis)),
        (Function::GradeInvolution, [x]) => Ok(x.grade_involution()),
        (Function::CliffordConjugate, [x]) => Ok(x.clifford_conjugate()),
        (Function::Product(product), [a, b]) => a.product(product, b, basis),
        _ => unreachable!("invariant: lowering checks the number of arguments"),
    }
}
