//! Resolving the names of expressions and relations.

use crate::algebra::Basis;
use crate::kernel::{Analytic, Expression, ExpressionKind, Function, Operator, Parameter};
use crate::symbolic::{Monomial, Overflow, Polynomial, Rational, Relation, Symbol};
use crate::syntax::{RawExpression, RawKind, RawRelation};
use proc_macro2::Span;
use std::collections::BTreeMap;

/// What the names of an expression can stand for.
pub(super) struct Scope<'a> {
    pub(super) basis: &'a Basis,
    pub(super) parameters: &'a [Parameter],
    /// Whether a blade may be written with its generators in an order that is not the basis's.
    pub(super) any_order: bool,
}

impl Scope<'_> {
    /// The definition of a kernel: a logarithm is that of its one parameter, whose type promises a unit.
    pub(super) fn kernel_body(&self, raw: &RawExpression) -> syn::Result<(Option<Analytic>, Expression)> {
        let (analytic, argument) = self.body(raw)?;
        let is_input = self.parameters.len() == 1 && matches!(argument.kind, ExpressionKind::Parameter(_));
        if analytic == Some(Analytic::Log) && !is_input {
            let message = "expected the one parameter of the kernel as the argument of `log`, found something else";
            return Err(syn::Error::new(argument.span, message));
        }
        Ok((analytic, argument))
    }

    /// An expression, or an analytic function of one.
    pub(super) fn body(&self, raw: &RawExpression) -> syn::Result<(Option<Analytic>, Expression)> {
        if let RawKind::Call(name, arguments) = &raw.kind
            && let Some((_, analytic)) = Analytic::ALL.iter().find(|(known, _)| known == name)
        {
            check_arity(name, 1, arguments, raw.span)?;
            return Ok((Some(*analytic), self.expression(&arguments[0])?));
        }
        Ok((None, self.expression(raw)?))
    }

    fn expression(&self, raw: &RawExpression) -> syn::Result<Expression> {
        let boxed = |inner: &RawExpression| self.expression(inner).map(Box::new);
        let kind = match &raw.kind {
            RawKind::Name(name) => self.name(name, raw.span)?,
            RawKind::Number(number) => ExpressionKind::Number(Rational::integer(*number)),
            RawKind::Negate(inner) => ExpressionKind::Negate(boxed(inner)?),
            RawKind::Reverse(inner) => ExpressionKind::Reverse(boxed(inner)?),
            RawKind::Binary(operator, a, b) => ExpressionKind::Binary(*operator, boxed(a)?, boxed(b)?),
            RawKind::Quotient(inner, number) => ExpressionKind::Quotient(boxed(inner)?, divisor(number)?),
            RawKind::Call(name, arguments) => self.call(name, arguments, raw.span)?,
            RawKind::Field(parameter, field) => {
                let message = format!("expected a whole parameter, found its field `{parameter}.{field}`");
                return Err(syn::Error::new(raw.span, message));
            }
        };
        Ok(Expression { kind, span: raw.span })
    }

    fn name(&self, name: &str, span: Span) -> syn::Result<ExpressionKind> {
        if let Some(index) = self.parameters.iter().position(|parameter| parameter.name == name) {
            return Ok(ExpressionKind::Parameter(index));
        }
        if let Some(named) = self.basis.find(name) {
            return Ok(ExpressionKind::Blade(name.to_owned(), named.sign, named.blade));
        }
        if let Some((sign, blade)) = self.basis.word(name).filter(|_| self.any_order) {
            return Ok(ExpressionKind::Blade(name.to_owned(), sign, blade));
        }
        let parameters: Vec<_> = self.parameters.iter().map(|parameter| format!("`{}`", parameter.name)).collect();
        let message = format!("expected a parameter ({}) or a blade, found `{name}`", parameters.join(", "));
        Err(syn::Error::new(span, message))
    }

    fn call(&self, name: &str, arguments: &[RawExpression], span: Span) -> syn::Result<ExpressionKind> {
        if name == "grade" {
            check_arity(name, 2, arguments, span)?;
            let RawKind::Number(grade @ 0..=8) = arguments[1].kind else {
                return Err(syn::Error::new(
                    arguments[1].span,
                    "expected a grade from 0 to 8 as the second argument, found another expression",
                ));
            };
            return Ok(ExpressionKind::Grade(Box::new(self.expression(&arguments[0])?), grade as u32));
        }
        if Analytic::ALL.iter().any(|(known, _)| *known == name) {
            let message = format!("expected `{name}` around the whole definition, found it inside an expression");
            return Err(syn::Error::new(span, message));
        }
        let Some((_, function)) = Function::ALL.iter().find(|(known, _)| *known == name) else {
            let known: Vec<_> = Function::ALL.iter().map(|(known, _)| *known).collect();
            let message =
                format!("expected a function ({}, grade, exp, log, normalize, sqrt), found `{name}`", known.join(", "));
            return Err(syn::Error::new(span, message));
        };
        check_arity(name, function.arity(), arguments, span)?;
        let arguments = arguments.iter().map(|argument| self.expression(argument)).collect::<syn::Result<_>>()?;
        Ok(ExpressionKind::Call(*function, arguments))
    }
}

fn check_arity(name: &str, expected: usize, arguments: &[RawExpression], span: Span) -> syn::Result<()> {
    if arguments.len() == expected {
        return Ok(());
    }
    let plural = if expected == 1 { "argument" } else { "arguments" };
    let message = format!("expected {expected} {plural} for `{name}`, found {}", arguments.len());
    Err(syn::Error::new(span, message))
}

fn divisor(raw: &RawExpression) -> syn::Result<Rational> {
    match raw.kind {
        RawKind::Number(number) if number != 0 => Ok(Rational::integer(number)),
        RawKind::Number(_) => Err(syn::Error::new(raw.span, "expected a divisor other than 0, found 0")),
        _ => Err(syn::Error::new(raw.span, "expected a whole number as divisor, found an expression")),
    }
}

/// A relation over named symbols, its text and its place. The first monomial as written is the leading one.
pub(super) fn relation(raw: &RawRelation, symbols: &BTreeMap<String, Symbol>) -> syn::Result<(Relation, String, Span)> {
    let overflow = |error: Overflow| syn::Error::new(raw.span, error);
    let (left, right) = (polynomial(&raw.left, symbols)?, polynomial(&raw.right, symbols)?);
    let difference = left.sub(&right).map_err(overflow)?;
    let first = polynomial(first_term(&raw.left), symbols)?;
    let leading: Option<Monomial> = first.terms().next().map(|(monomial, _)| monomial.clone());
    let relation = leading
        .filter(|_| first.term_count() == 1)
        .and_then(|leading| Relation::new(difference, leading))
        .ok_or_else(|| {
        let message =
            "expected a relation that starts with the monomial to rewrite, such as `s*s == 1 - e12*e12`, found another";
        syn::Error::new(raw.span, message)
    })?;
    Ok((relation, format!("{} == {}", text(&raw.left, 0), text(&raw.right, 0)), raw.span))
}

fn first_term(raw: &RawExpression) -> &RawExpression {
    match &raw.kind {
        RawKind::Binary(Operator::Add | Operator::Sub, first, _) => first_term(first),
        RawKind::Negate(inner) => first_term(inner),
        _ => raw,
    }
}

fn polynomial(raw: &RawExpression, symbols: &BTreeMap<String, Symbol>) -> syn::Result<Polynomial> {
    let overflow = |error: Overflow| syn::Error::new(raw.span, error);
    let inner = |inner: &RawExpression| polynomial(inner, symbols);
    let symbol = |name: String| match symbols.get(&name) {
        Some(&symbol) => Ok(Polynomial::symbol(symbol)),
        None => {
            let mut known: Vec<_> = symbols.iter().collect();
            known.sort_by_key(|(_, symbol)| **symbol);
            let known: Vec<_> = known.into_iter().map(|(name, _)| name.as_str()).collect();
            let message = format!("expected a coefficient ({}), found `{name}`", known.join(", "));
            Err(syn::Error::new(raw.span, message))
        }
    };
    match &raw.kind {
        RawKind::Name(name) => symbol(name.clone()),
        RawKind::Field(parameter, field) => symbol(format!("{parameter}.{field}")),
        RawKind::Number(number) => Ok(Polynomial::constant(Rational::integer(*number))),
        RawKind::Negate(value) => Ok(inner(value)?.neg()),
        RawKind::Quotient(value, number) => {
            let reciprocal = Rational::ONE.checked_div(divisor(number)?).map_err(overflow)?.unwrap_or(Rational::ONE);
            inner(value)?.scale(reciprocal).map_err(overflow)
        }
        RawKind::Binary(Operator::Add, a, b) => inner(a)?.add(&inner(b)?).map_err(overflow),
        RawKind::Binary(Operator::Sub, a, b) => inner(a)?.sub(&inner(b)?).map_err(overflow),
        RawKind::Binary(Operator::Geometric, a, b) => inner(a)?.mul(&inner(b)?).map_err(overflow),
        RawKind::Binary(operator, ..) => {
            let message = format!("expected `+`, `-` or `*` between coefficients, found `{}`", operator.symbol());
            Err(syn::Error::new(raw.span, message))
        }
        RawKind::Reverse(_) | RawKind::Call(..) => {
            Err(syn::Error::new(raw.span, "expected a polynomial in the coefficients, found another expression"))
        }
    }
}

/// A relation's side as text.
fn text(raw: &RawExpression, outer: u8) -> String {
    let (text, precedence) = match &raw.kind {
        RawKind::Name(name) => (name.clone(), u8::MAX),
        RawKind::Field(parameter, field) => (format!("{parameter}.{field}"), u8::MAX),
        RawKind::Number(number) => (number.to_string(), u8::MAX),
        RawKind::Negate(inner) => (format!("-{}", text(inner, 7)), 7),
        RawKind::Quotient(inner, number) => (format!("{} / {}", text(inner, 6), text(number, 7)), 6),
        RawKind::Binary(operator, a, b) => {
            let precedence = operator.precedence();
            (format!("{} {} {}", text(a, precedence), operator.symbol(), text(b, precedence + 1)), precedence)
        }
        RawKind::Reverse(_) | RawKind::Call(..) => ("?".to_owned(), u8::MAX),
    };
    if precedence < outer { format!("({text})") } else { text }
}
