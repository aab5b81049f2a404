//! The parser of packed recipes: rows of values of four lanes.

use super::{Name, check_length, comma_separated, name, number, parentheses, token, unexpected};
use crate::limits::MAX_DEPTH;
use crate::program::{LANES, PackedRecipe, PackedRow, PackedSource, PackedTerm};
use crate::symbolic::Rational;
use syn::ext::IdentExt;
use syn::parse::ParseStream;
use syn::{Ident, LitInt, Token, bracketed};

/// The rows between the braces of a recipe.
pub(super) fn recipe(kernel: Name, input: ParseStream) -> syn::Result<PackedRecipe> {
    let mut rows = Vec::new();
    while !input.is_empty() {
        let row = name(input, "the name of a row")?;
        let outputs = input.peek(syn::token::Bracket).then(|| list(input, "fields", output)).transpose()?;
        if outputs.is_some() && row.text != "out" {
            return Err(syn::Error::new(
                row.span,
                format!("expected `out` before a list of fields, found `{}`", row.text),
            ));
        }
        token::<Token![=]>(input, "`=`")?;
        let value = sum(input, 0)?;
        rows.push(match outputs {
            Some(fields) => PackedRow::Outputs(fields, value),
            None => PackedRow::Named(row.text, value),
        });
        check_length(input, rows.len())?;
        token::<Token![;]>(input, "`;`")?;
    }
    Ok(PackedRecipe { kernel: kernel.text, rows, span: kernel.span })
}

/// Four of a kind between brackets.
fn list<T>(input: ParseStream, what: &str, part: impl Fn(ParseStream) -> syn::Result<T>) -> syn::Result<[T; LANES]> {
    let (span, content) = (input.span(), brackets(input)?);
    let parts = comma_separated(&content, part)?;
    let found = parts.len();
    parts.try_into().map_err(|_| syn::Error::new(span, format!("expected a list of four {what}, found {found}")))
}

/// The inside of brackets.
fn brackets(input: ParseStream) -> syn::Result<syn::parse::ParseBuffer> {
    let content;
    bracketed!(content in input);
    Ok(content)
}

/// A field of the output, or `_` for a lane that is none.
fn output(input: ParseStream) -> syn::Result<Option<String>> {
    if input.peek(Token![_]) {
        input.parse::<Token![_]>()?;
        return Ok(None);
    }
    Ok(Some(name(input, "a field or `_`")?.text))
}

/// A lane by its number, negated where a minus stands before it.
fn lane(input: ParseStream) -> syn::Result<(bool, u8)> {
    let minus = input.parse::<Option<Token![-]>>()?.is_some();
    let span = input.span();
    let lane: u8 = number(input)?;
    if usize::from(lane) < LANES {
        return Ok((minus, lane));
    }
    Err(syn::Error::new(span, format!("expected a lane from 0 to 3, found {lane}")))
}

/// A coefficient or a number.
fn source(input: ParseStream) -> syn::Result<PackedSource> {
    if input.peek(LitInt) || input.peek(Token![-]) {
        let (minus, span) = (input.parse::<Option<Token![-]>>()?.is_some(), input.span());
        let numerator: i64 = number(input)?;
        let denominator: i64 = if input.parse::<Option<Token![/]>>()?.is_some() { number(input)? } else { 1 };
        let found = Rational::new(i128::from(numerator), i128::from(denominator));
        let found = found.map_err(|_| syn::Error::new(span, "expected a denominator other than 0"))?;
        return Ok(PackedSource::Number(if minus { found.neg() } else { found }));
    }
    let mut coefficient = name(input, "a coefficient or a number")?.text;
    if input.peek(Token![.]) {
        input.parse::<Token![.]>()?;
        coefficient = format!("{coefficient}.{}", name(input, "a field")?.text);
    }
    Ok(PackedSource::Name(coefficient))
}

/// How many terms stand in a row and around one another: what comes later walks them recursively.
fn check_depth(input: ParseStream, depth: usize) -> syn::Result<()> {
    let message = || format!("expected an expression nested at most {MAX_DEPTH} deep, found a deeper one");
    if depth > MAX_DEPTH { Err(syn::Error::new(input.span(), message())) } else { Ok(()) }
}

fn sum(input: ParseStream, mut depth: usize) -> syn::Result<PackedTerm> {
    let mut left = product(input, depth + 1)?;
    loop {
        depth += 1;
        check_depth(input, depth)?;
        let make = if input.peek(Token![+]) {
            input.parse::<Token![+]>()?;
            PackedTerm::Add
        } else if input.peek(Token![-]) {
            input.parse::<Token![-]>()?;
            PackedTerm::Sub
        } else {
            return Ok(left);
        };
        left = make(Box::new(left), Box::new(product(input, depth + 1)?));
    }
}

fn product(input: ParseStream, mut depth: usize) -> syn::Result<PackedTerm> {
    let mut left = if input.peek(LitInt) {
        let (span, two) = (input.span(), number::<i64>(input)?);
        if two != 2 {
            return Err(syn::Error::new(span, format!("expected 2 or a value of four lanes, found {two}")));
        }
        token::<Token![*]>(input, "`*`")?;
        PackedTerm::Double(Box::new(value(input, depth + 1)?))
    } else {
        value(input, depth + 1)?
    };
    while input.peek(Token![*]) {
        depth += 1;
        check_depth(input, depth)?;
        input.parse::<Token![*]>()?;
        left = PackedTerm::Mul(Box::new(left), Box::new(value(input, depth + 1)?));
    }
    Ok(left)
}

/// A load, a row or what is in parentheses, and which of its lanes.
fn value(input: ParseStream, depth: usize) -> syn::Result<PackedTerm> {
    check_depth(input, depth)?;
    let mut value = if input.peek(syn::token::Bracket) {
        PackedTerm::Load(list(input, "coefficients", source)?)
    } else if input.peek(syn::token::Paren) {
        let content = parentheses(input)?;
        let inner = sum(&content, depth + 1)?;
        if !content.is_empty() {
            return Err(unexpected(&content, "an operator or `)`"));
        }
        inner
    } else if input.peek(Ident::peek_any) {
        PackedTerm::Name(name(input, "a row")?.text)
    } else {
        return Err(unexpected(input, "a row, four coefficients or `(`"));
    };
    if input.peek(syn::token::Bracket) {
        value = PackedTerm::Lanes(Box::new(value), list(input, "lanes", lane)?);
    }
    Ok(value)
}
