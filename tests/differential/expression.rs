//! Expressions as a scalar: code that runs on them writes down what it computes, operation by operation.
//!
//! A [`Traced`] is a handle to a node of an arena, so it is `Copy` as the compiled kernels ask for. Equal expressions
//! are one node, and the operands of sums and products, which rounding does not tell apart, stand in a fixed order: two
//! programs that compute the same, value by value, give the same handles.

use crate::interpreter::Coefficient;
use ga_codegen::approximation::approximation;
use ga_codegen::program::{Operation, Program};
use ga_codegen::symbolic::{Polynomial, Rational, Symbol};
use pga_motor::scalar::{Array4, Real, Scalar};
use std::cell::RefCell;
use std::cmp::Ordering;
use std::collections::HashMap;
use std::ops::{Add, Div, Mul, Neg, Sub};

/// An expression, by its node in the arena of this thread.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(crate) struct Traced(usize);

#[derive(Clone, Debug, PartialEq, Eq, Hash)]
enum Node {
    Input(Symbol),
    Constant(Rational),
    /// The bits of a floating-point number.
    Float(u64),
    /// A constant of the number type.
    Named(&'static str),
    Add(Traced, Traced),
    Sub(Traced, Traced),
    Mul(Traced, Traced),
    Neg(Traced),
    Div(Traced, Traced),
    Sqrt(Traced),
    Abs(Traced),
    Norm(Vec<Traced>),
    Sin(Traced),
    Cos(Traced),
    Atan2(Traced, Traced),
    Quotient(Traced, Traced, Traced),
}

#[derive(Default)]
struct Arena {
    nodes: Vec<Node>,
    known: HashMap<Node, Traced>,
}

impl Arena {
    /// An arena with the nodes of the associated constants, in the order of their handles.
    fn new() -> Self {
        let mut arena = Self::default();
        for node in
            [Node::Constant(Rational::ZERO), Node::Constant(Rational::ONE), Node::Named("EPSILON"), Node::Named("PI")]
        {
            arena.intern(node);
        }
        arena
    }

    fn intern(&mut self, node: Node) -> Traced {
        if let Some(&known) = self.known.get(&node) {
            return known;
        }
        let handle = Traced(self.nodes.len());
        self.nodes.push(node.clone());
        self.known.insert(node, handle);
        handle
    }
}

thread_local! {
    static ARENA: RefCell<Arena> = RefCell::new(Arena::new());
}

fn intern(node: Node) -> Traced {
    ARENA.with_borrow_mut(|arena| arena.intern(node))
}

impl Traced {
    /// An unknown.
    pub(crate) fn input(symbol: Symbol) -> Self {
        intern(Node::Input(symbol))
    }

    /// A number.
    pub(crate) fn constant(value: Rational) -> Self {
        intern(Node::Constant(value))
    }

    fn node(self) -> Node {
        ARENA.with_borrow(|arena| arena.nodes[self.0].clone())
    }

    /// Two operands whose order does not matter.
    fn commuting(self, other: Self) -> (Self, Self) {
        if self.0 <= other.0 { (self, other) } else { (other, self) }
    }
}

impl From<i8> for Traced {
    fn from(value: i8) -> Self {
        Self::constant(Rational::integer(value.into()))
    }
}

impl Coefficient for Traced {
    fn rational(value: Rational) -> Self {
        Self::constant(value)
    }
}

impl Add for Traced {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        let (a, b) = self.commuting(other);
        intern(Node::Add(a, b))
    }
}

impl Sub for Traced {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        intern(Node::Sub(self, other))
    }
}

impl Mul for Traced {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        let (a, b) = self.commuting(other);
        intern(Node::Mul(a, b))
    }
}

impl Div for Traced {
    type Output = Self;
    fn div(self, other: Self) -> Self {
        intern(Node::Div(self, other))
    }
}

impl Neg for Traced {
    type Output = Self;
    fn neg(self) -> Self {
        intern(Node::Neg(self))
    }
}

impl PartialOrd for Traced {
    fn partial_cmp(&self, _: &Self) -> Option<Ordering> {
        panic!("a kernel that compares its values is no straight-line program")
    }
}

impl Scalar for Traced {
    type Four = Array4<Self>;
    const ZERO: Self = Self(0);
    const ONE: Self = Self(1);
    fn from_ratio(numerator: i32, denominator: i32) -> Self {
        Self::constant(Rational::new(numerator.into(), denominator.into()).expect("a denominator other than 0"))
    }
    /// Signs and doublings are exact, so -x y + c is c - x y, x y + -c is x y - c, and 2 x is x + x: what rounds is the same.
    fn mul_add(self, factor: Self, term: Self) -> Self {
        let two = Self::constant(Rational::integer(2));
        let times = |x: Self| if factor == two { x + x } else { x * factor };
        match (self.node(), term.node()) {
            (Node::Neg(x), _) => term - times(x),
            (_, Node::Neg(c)) => times(self) - c,
            _ => times(self) + term,
        }
    }
}

impl Real for Traced {
    const EPSILON: Self = Self(2);
    const PI: Self = Self(3);
    fn from_f64(value: f64) -> Self {
        intern(Node::Float(value.to_bits()))
    }
    fn to_f64(self) -> f64 {
        panic!("an expression has no value")
    }
    fn sqrt(self) -> Self {
        intern(Node::Sqrt(self))
    }
    fn sin_cos(self) -> (Self, Self) {
        (intern(Node::Sin(self)), intern(Node::Cos(self)))
    }
    fn atan2(self, x: Self) -> Self {
        intern(Node::Atan2(self, x))
    }
    fn abs(self) -> Self {
        intern(Node::Abs(self))
    }
    fn is_finite(self) -> bool {
        panic!("an expression has no value")
    }
    fn power_of_two(self) -> Self {
        panic!("an expression has no value")
    }
    fn quotient(self, denominator: Self, limit: Self) -> Self {
        intern(Node::Quotient(self, denominator, limit))
    }
    fn norm<const N: usize>(components: [Self; N]) -> Self {
        intern(Node::Norm(components.to_vec()))
    }
}

/// What a program computes, as the code emitted for it should.
pub(crate) fn replay(program: &Program, inputs: &[Traced]) -> Vec<Traced> {
    let mut values: Vec<Traced> = Vec::with_capacity(program.operations.len());
    for operation in &program.operations {
        let value = replay_operation(*operation, inputs, &values);
        values.push(value);
    }
    program.outputs.iter().map(|&output| values[output]).collect()
}

fn replay_operation(operation: Operation, inputs: &[Traced], values: &[Traced]) -> Traced {
    match operation {
        Operation::Input(index) => inputs[index],
        Operation::Constant(number) => Traced::constant(number),
        Operation::Add(a, b) => values[a] + values[b],
        Operation::Sub(a, b) => values[a] - values[b],
        Operation::Mul(a, b) => values[a] * values[b],
        Operation::Neg(a) => -values[a],
        Operation::Double(a) => values[a] + values[a],
        Operation::Div(a, b) => values[a] / values[b],
        Operation::Sqrt(a) => values[a].sqrt(),
        Operation::Norm(operands) => match operands.iter().map(|a| values[a]).collect::<Vec<_>>().as_slice() {
            [only] => only.abs(),
            several => intern(Node::Norm(several.to_vec())),
        },
        Operation::Sin(a) => intern(Node::Sin(values[a])),
        Operation::Cos(a) => intern(Node::Cos(values[a])),
        Operation::Atan2(y, x) => values[y].atan2(values[x]),
        Operation::Quotient(n, d, limit) => values[n].quotient(values[d], Traced::constant(limit)),
        Operation::Polynomial(function, precision, a) => {
            let mut coefficients = approximation(function, precision).coefficients.iter().rev();
            let first = coefficients.next().map_or(Traced::ZERO, |&coefficient| Traced::from_f64(coefficient));
            coefficients.fold(first, |sum, &coefficient| sum * values[a] + Traced::from_f64(coefficient))
        }
    }
}

/// Expressions multiplied out.
#[derive(Default)]
pub(crate) struct Expansion(HashMap<Traced, Polynomial>);

impl Expansion {
    /// The polynomial that an expression is; an error for one that is none.
    pub(crate) fn polynomial(&mut self, value: Traced) -> Result<Polynomial, String> {
        if let Some(known) = self.0.get(&value) {
            return Ok(known.clone());
        }
        let expanded = match value.node() {
            Node::Input(symbol) => Ok(Polynomial::symbol(symbol)),
            Node::Constant(number) => Ok(Polynomial::constant(number)),
            Node::Add(a, b) => self.polynomial(a)?.add(&self.polynomial(b)?),
            Node::Sub(a, b) => self.polynomial(a)?.sub(&self.polynomial(b)?),
            Node::Mul(a, b) => self.polynomial(a)?.mul(&self.polynomial(b)?),
            Node::Neg(a) => Ok(self.polynomial(a)?.neg()),
            other => return Err(format!("expected a polynomial, found {other:?}")),
        };
        let expanded = expanded.map_err(|overflow| overflow.to_string())?;
        self.0.insert(value, expanded.clone());
        Ok(expanded)
    }
}
