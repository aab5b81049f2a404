//! Straight-line code from a program: a `let` for what is used more than once, expressions for the rest.

use super::{ident, polynomial};
use crate::limits::MAX_DEPTH;
use crate::program::{Operation, Program, Value};
use crate::symbolic::Rational;
use proc_macro2::{Delimiter, Group, Ident, Literal, Span, TokenStream, TokenTree};
use quote::{format_ident, quote};
use std::collections::BTreeMap;

/// How tightly an emitted expression binds.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum Binding {
    Sum,
    Product,
    Negation,
    Atom,
}

/// Statements and, for every output, an expression.
pub(super) struct Body {
    pub(super) statements: TokenStream,
    pub(super) outputs: Vec<TokenStream>,
}

/// How sums of products are written.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Style {
    /// As sums and products.
    Plain,
    /// By `mul_add` wherever [`Count::fma`](crate::program::Count::fma) takes the two for one instruction.
    MulAdd,
}

struct Writer<'a> {
    program: &'a Program,
    inputs: &'a [TokenStream],
    constants: BTreeMap<Rational, TokenStream>,
    reserved: &'a [&'a str],
    meanings: &'a BTreeMap<Value, String>,
    style: Style,
    uses: Vec<usize>,
    doubled: Vec<bool>,
    names: BTreeMap<Value, Ident>,
    temporaries: usize,
    /// How many operations deep the expression of a value is.
    depths: Vec<usize>,
    statements: TokenStream,
}

/// The body of a program whose inputs are these expressions; `reserved` names are not given to temporaries, `meanings` are
/// where they can. An error is at `span`.
pub(super) fn body(
    program: &Program,
    inputs: &[TokenStream],
    reserved: &[&str],
    meanings: &BTreeMap<Value, String>,
    style: Style,
    span: Span,
) -> syn::Result<Body> {
    let mut uses = vec![0; program.operations.len()];
    let operands = program.operations.iter().flat_map(|operation| operation.operands());
    operands.chain(program.outputs.iter().copied()).for_each(|value| uses[value] += 1);
    let mut doubled = vec![false; program.operations.len()];
    for operation in &program.operations {
        if let Operation::Double(value) = *operation {
            doubled[value] = true;
        }
    }
    let constants = constants(program, span)?;
    let (names, statements) = (BTreeMap::new(), TokenStream::new());
    let depths = vec![0; program.operations.len()];
    let mut writer = Writer {
        program,
        inputs,
        constants,
        reserved,
        meanings,
        style,
        uses,
        doubled,
        names,
        temporaries: 0,
        depths,
        statements,
    };
    for value in 0..program.operations.len() {
        writer.name_if_needed(value);
    }
    let outputs = program.outputs.iter().map(|&output| writer.expression(output)).collect();
    Ok(Body { statements: writer.statements, outputs })
}

/// The expressions of all numbers in a program.
fn constants(program: &Program, span: Span) -> syn::Result<BTreeMap<Rational, TokenStream>> {
    let numbers = program.operations.iter().filter_map(|operation| match operation {
        Operation::Constant(number) | Operation::Quotient(_, _, number) => Some(*number),
        _ => None,
    });
    numbers.map(|value| Ok((value, number(value, span)?))).collect()
}

/// A number as an expression of the scalar type.
pub(super) fn number(number: Rational, span: Span) -> syn::Result<TokenStream> {
    if number.is_zero() {
        return Ok(quote!(T::ZERO));
    }
    if number == Rational::ONE {
        return Ok(quote!(T::ONE));
    }
    let part = |part: i128| {
        let message = format!("expected numbers whose numerator and denominator fit an i32, found {number}");
        i32::try_from(part).map(Literal::i32_unsuffixed).map_err(|_| syn::Error::new(span, message))
    };
    let magnitude = number.abs();
    let (numerator, denominator) = (part(magnitude.numerator())?, part(magnitude.denominator())?);
    let minus = number.is_negative().then(|| quote!(-));
    Ok(quote!(T::from_ratio(#minus #numerator, #denominator)))
}

/// Two factors.
#[derive(Clone, Copy)]
struct Product {
    is_negative: bool,
    first: Value,
    /// 2 where there is none.
    second: Option<Value>,
}

impl Writer<'_> {
    /// Gives a name to what is used twice, doubled or very long, and to what reads better with one.
    fn name_if_needed(&mut self, value: Value) {
        let operation = self.program.operations[value];
        self.depths[value] = self.depth(value);
        let name = match operation {
            Operation::Input(_) | Operation::Constant(_) => return,
            Operation::Sin(angle) | Operation::Cos(angle) => return self.sine_and_cosine(angle),
            Operation::Sqrt(_) | Operation::Norm(_) => self.fresh("norm"),
            Operation::Atan2(..) => self.fresh("angle"),
            Operation::Quotient(numerator, denominator, _) => {
                self.fresh(&format!("{}_over_{}", self.word(numerator), self.word(denominator)))
            }
            Operation::Div(..) if self.uses[value] > 1 => self.fresh("inverse"),
            Operation::Polynomial(function, ..) => self.fresh(function.name()),
            _ if self.is_argument(value) => self.fresh("argument"),
            Operation::Mul(a, b) if self.uses[value] > 1 && self.is_inverse(b) && self.is_input(a) => {
                self.fresh(&format!("unit_{}", self.word(a)))
            }
            _ if self.uses[value] > 1 || self.doubled[value] || self.depths[value] > MAX_DEPTH => {
                match self.meanings.get(&value) {
                    Some(meaning) => self.fresh(meaning),
                    None => {
                        self.temporaries += 1;
                        self.fresh(&format!("t{}", self.temporaries - 1))
                    }
                }
            }
            _ => return,
        };
        let expression = self.expression(value);
        self.statements.extend(quote!(let #name = #expression;));
        self.names.insert(value, name);
    }

    /// How many operations deep the expression of a value is, what has a name left out.
    fn depth(&self, value: Value) -> usize {
        let operands = self.program.operations[value].operands();
        let unnamed = operands.filter(|operand| !self.names.contains_key(operand));
        1 + unnamed.map(|operand| self.depths[operand]).max().unwrap_or(0)
    }

    /// Whether the value is what a polynomial is evaluated at.
    fn is_argument(&self, value: Value) -> bool {
        self.program.polynomials().iter().any(|&(_, _, argument)| argument == value)
    }

    fn is_input(&self, value: Value) -> bool {
        matches!(self.program.operations[value], Operation::Input(_))
    }

    fn is_inverse(&self, value: Value) -> bool {
        matches!(self.program.operations[value], Operation::Div(..))
    }

    /// A word for a value in the name of another.
    fn word(&self, value: Value) -> String {
        match (self.names.get(&value), self.program.operations[value]) {
            (Some(name), _) => name.to_string(),
            // Of a field access the field.
            (None, Operation::Input(index)) => {
                self.inputs[index].clone().into_iter().last().map_or_else(String::new, |token| token.to_string())
            }
            (None, Operation::Sub(..)) => "difference".to_owned(),
            _ => "value".to_owned(),
        }
    }

    /// The name, with a number behind it if it is taken.
    fn fresh(&self, name: &str) -> Ident {
        let taken = |candidate: &Ident| {
            self.names.values().any(|other| other == candidate) || self.reserved.iter().any(|r| candidate == r)
        };
        let first = format_ident!("{name}");
        let numbered = (2..).map(|n| format_ident!("{name}_{n}"));
        std::iter::once(first)
            .chain(numbered)
            .find(|candidate| !taken(candidate))
            .expect("invariant: names do not run out")
    }

    /// One call for the sine and the cosine of an angle, at the first of the two.
    fn sine_and_cosine(&mut self, angle: Value) {
        let find = |wanted: Operation| self.program.operations.iter().position(|operation| *operation == wanted);
        let parts = [(find(Operation::Sin(angle)), "sin"), (find(Operation::Cos(angle)), "cos")];
        if parts.iter().any(|(value, _)| value.is_some_and(|value| self.names.contains_key(&value))) {
            return;
        }
        let names = parts.map(|(value, name)| value.map(|value| (value, self.fresh(name))));
        let pattern =
            |named: &Option<(Value, Ident)>| named.as_ref().map_or_else(|| quote!(_), |(_, name)| quote!(#name));
        let (sin, cos, angle) = (pattern(&names[0]), pattern(&names[1]), self.operand(angle, Binding::Atom));
        self.statements.extend(quote!(let (#sin, #cos) = #angle.sin_cos();));
        self.names.extend(names.into_iter().flatten());
    }

    fn binding(&self, value: Value) -> Binding {
        if self.names.contains_key(&value) {
            return Binding::Atom;
        }
        match self.program.operations[value] {
            Operation::Add(a, b) | Operation::Sub(a, b) if self.product(a).or(self.product(b)).is_some() => {
                Binding::Atom
            }
            Operation::Add(..) | Operation::Sub(..) | Operation::Double(_) => Binding::Sum,
            Operation::Mul(..) | Operation::Div(..) => Binding::Product,
            Operation::Neg(_) => Binding::Negation,
            _ => Binding::Atom,
        }
    }

    /// An operand, in parentheses where it binds less tightly than needed.
    fn operand(&self, value: Value, least: Binding) -> TokenStream {
        let expression = self.expression(value);
        if self.binding(value) >= least {
            return expression;
        }
        TokenTree::Group(Group::new(Delimiter::Parenthesis, expression)).into()
    }

    /// The operands of a commutative operation; the one that would need parentheses on the right stands left.
    fn commuted(&self, a: Value, b: Value, right: Binding) -> (Value, Value) {
        if self.binding(b) < right && self.binding(a) >= right { (b, a) } else { (a, b) }
    }

    /// A product that can be taken into a sum: what has no name of its own, with or without a sign before it.
    fn product(&self, value: Value) -> Option<Product> {
        if self.style == Style::Plain || self.names.contains_key(&value) {
            return None;
        }
        match self.program.operations[value] {
            Operation::Mul(a, b) => {
                let (first, second) = if self.binding(a) == Binding::Atom { (a, b) } else { (b, a) };
                Some(Product { is_negative: false, first, second: Some(second) })
            }
            Operation::Double(a) => Some(Product { is_negative: false, first: a, second: None }),
            Operation::Neg(a) => {
                self.product(a).map(|product| Product { is_negative: !product.is_negative, ..product })
            }
            _ => None,
        }
    }

    /// A product plus a value, or minus it.
    fn mul_add(&self, product: Product, minus: bool, value: Value) -> TokenStream {
        let Product { is_negative, first, second } = product;
        let first = self.operand(first, Binding::Atom);
        let first = if is_negative { quote!((-#first)) } else { quote!(#first) };
        let second = match second {
            Some(second) => self.expression(second),
            None => quote!(T::from_ratio(2, 1)),
        };
        let term = if minus { self.operand(value, Binding::Atom) } else { self.expression(value) };
        let minus = minus.then(|| quote!(-));
        quote!(#first.mul_add(#second, #minus #term))
    }

    /// A sum or difference by `mul_add`, where one side is a product.
    fn fused(&self, value: Value) -> Option<TokenStream> {
        match self.program.operations[value] {
            Operation::Add(a, b) => match (self.product(a), self.product(b)) {
                (_, Some(product)) => Some(self.mul_add(product, false, a)),
                (Some(product), None) => Some(self.mul_add(product, false, b)),
                (None, None) => None,
            },
            Operation::Sub(a, b) => match (self.product(a), self.product(b)) {
                (_, Some(product)) => {
                    let product = Product { is_negative: !product.is_negative, ..product };
                    Some(self.mul_add(product, false, a))
                }
                (Some(product), None) => Some(self.mul_add(product, true, b)),
                (None, None) => None,
            },
            _ => None,
        }
    }

    fn expression(&self, value: Value) -> TokenStream {
        if let Some(name) = self.names.get(&value) {
            return quote!(#name);
        }
        if let Some(fused) = self.fused(value) {
            return fused;
        }
        match self.program.operations[value] {
            Operation::Input(index) => self.inputs[index].clone(),
            Operation::Constant(number) => self.constants[&number].clone(),
            Operation::Add(a, b) => {
                let (a, b) = self.commuted(a, b, Binding::Product);
                let (a, b) = (self.operand(a, Binding::Sum), self.operand(b, Binding::Product));
                quote!(#a + #b)
            }
            Operation::Sub(a, b) => {
                let (a, b) = (self.operand(a, Binding::Sum), self.operand(b, Binding::Product));
                quote!(#a - #b)
            }
            Operation::Mul(a, b) => {
                let (a, b) = self.commuted(a, b, Binding::Negation);
                let (a, b) = (self.operand(a, Binding::Product), self.operand(b, Binding::Negation));
                quote!(#a * #b)
            }
            Operation::Neg(a) => {
                let a = self.operand(a, Binding::Atom);
                quote!(-#a)
            }
            Operation::Double(a) => {
                let a = self.operand(a, Binding::Atom);
                quote!(#a + #a)
            }
            Operation::Div(a, b) => {
                let (a, b) = (self.operand(a, Binding::Product), self.operand(b, Binding::Negation));
                quote!(#a / #b)
            }
            Operation::Sqrt(a) => {
                let a = self.operand(a, Binding::Atom);
                quote!(#a.sqrt())
            }
            Operation::Norm(operands) if operands.count() == 1 => {
                let a = operands.iter().map(|operand| self.operand(operand, Binding::Atom));
                quote!(#(#a)*.abs())
            }
            Operation::Norm(operands) => {
                let components = operands.iter().map(|operand| self.expression(operand));
                quote!(T::norm([#(#components),*]))
            }
            Operation::Sin(_) | Operation::Cos(_) => {
                unreachable!("invariant: sines and cosines are named before they are used")
            }
            Operation::Atan2(y, x) => {
                let (y, x) = (self.operand(y, Binding::Atom), self.expression(x));
                quote!(#y.atan2(#x))
            }
            Operation::Quotient(numerator, denominator, limit) => {
                let (numerator, denominator) = (self.operand(numerator, Binding::Atom), self.expression(denominator));
                let limit = &self.constants[&limit];
                quote!(#numerator.quotient(#denominator, #limit))
            }
            Operation::Polynomial(function, precision, argument) => {
                let (name, argument) = (polynomial::name(function, precision), self.expression(argument));
                quote!(#name(#argument))
            }
        }
    }
}

/// A field access, or the bare name of a scalar.
pub(super) fn access(name: &str, field: &str) -> TokenStream {
    let name = ident(name);
    if field.is_empty() {
        return quote!(#name);
    }
    let field = ident(field);
    quote!(#name.#field)
}
