//! The text of a definition, parsed and resolved.

use std::fmt;

use proc_macro2::{Span, TokenStream};

use crate::algebra::{Basis, Signature};
use crate::kernel::{Analytic, Expression};
use crate::lower::lower_expression;
use crate::syntax::{RawExpression, RawKind, parse_expression};

/// A text that is no definition.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct DefinitionError {
    message: String,
    line: usize,
    column: usize,
}

impl DefinitionError {
    /// The line, counted from 1.
    pub fn line(&self) -> usize {
        self.line
    }

    /// The column in characters, counted from 1.
    pub fn column(&self) -> usize {
        self.column
    }

    /// At the place of a span; one that is nowhere stands for the end of the text.
    fn at(span: Span, text: &str, message: impl fmt::Display) -> Self {
        let (line, column) = if span.byte_range() == (0..0) {
            let last = text.rsplit('\n').next().unwrap_or("");
            (text.matches('\n').count() + 1, last.chars().count() + 1)
        } else {
            (span.start().line, span.start().column + 1)
        };
        Self { message: message.to_string(), line, column }
    }
}

impl fmt::Display for DefinitionError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} at ", self.message)?;
        if self.line > 1 {
            write!(f, "line {}, ", self.line)?;
        }
        write!(f, "column {}", self.column)
    }
}

impl std::error::Error for DefinitionError {}

/// A definition whose names are resolved.
pub(super) struct Definition {
    pub(super) signature: Signature,
    pub(super) text: String,
    /// The inputs, in the order in which they first occur.
    pub(super) names: Vec<String>,
    /// The function of the expression that it is, where it is not polynomial.
    pub(super) function: Option<Analytic>,
    pub(super) expression: Expression,
}

impl Definition {
    pub(super) fn parse(signature: Signature, text: &str) -> Result<Self, DefinitionError> {
        let basis = Basis::canonical(signature).map_err(|error| DefinitionError {
            message: error.to_string(),
            line: 1,
            column: 1,
        })?;
        let at = |error: syn::Error| DefinitionError::at(error.span(), text, &error);
        let raw = parse_expression(tokens(text)?).map_err(at)?;
        let mut names = Vec::new();
        collect_names(&raw, &mut names);
        let (function, expression) = lower_expression(&raw, &basis, &names).map_err(at)?;
        Ok(Self { signature, text: text.trim().to_owned(), names, function, expression })
    }
}

fn tokens(text: &str) -> Result<TokenStream, DefinitionError> {
    text.parse().map_err(|error: proc_macro2::LexError| {
        // The span is a place without a length.
        let start = error.span().start();
        let message = match text.get(error.span().byte_range().start..).and_then(|rest| rest.chars().next()) {
            None | Some('(' | ')' | '[' | ']' | '{' | '}') => {
                "expected parentheses in pairs, found one without its other".to_owned()
            }
            Some(found) => format!("expected an expression, found `{}`", found.escape_debug()),
        };
        DefinitionError { message, line: start.line, column: start.column + 1 }
    })
}

/// `e` and digits is meant as a blade, whether the signature has it or not.
fn is_blade(name: &str) -> bool {
    name.strip_prefix('e').is_some_and(|digits| !digits.is_empty() && digits.bytes().all(|byte| byte.is_ascii_digit()))
}

/// The names that are inputs.
fn collect_names(raw: &RawExpression, names: &mut Vec<String>) {
    match &raw.kind {
        RawKind::Name(name) if !is_blade(name) && !names.contains(name) => names.push(name.clone()),
        RawKind::Name(_) | RawKind::Field(..) | RawKind::Number(_) => {}
        RawKind::Negate(inner) | RawKind::Reverse(inner) => collect_names(inner, names),
        RawKind::Binary(_, a, b) | RawKind::Quotient(a, b) => [a, b].into_iter().for_each(|x| collect_names(x, names)),
        RawKind::Call(_, arguments) => arguments.iter().for_each(|argument| collect_names(argument, names)),
    }
}
