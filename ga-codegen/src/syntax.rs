//! The parser of definition blocks. Names are resolved later, in `lower`.
//!
//! The grammar is documented at [`crate::expand`]. An item that does not parse does not keep the others from being
//! parsed.

mod packed;

use proc_macro2::{Delimiter, Ident, Punct, Spacing, Span, TokenStream, TokenTree};
use std::fmt::Display;
use std::str::FromStr;
use syn::ext::IdentExt;
use syn::parse::{Parse, ParseBuffer, ParseStream, Parser};
use syn::{LitInt, LitStr, Token, bracketed, parenthesized};

use crate::errors::Errors;
use crate::kernel::Operator;
use crate::limits::{MAX_DEPTH, MAX_ITEMS, MAX_LISTED};
use crate::preset;
use crate::program::PackedRecipe;

/// A name and where it stands.
#[derive(Clone, Debug)]
pub(crate) struct Name {
    pub(crate) text: String,
    pub(crate) span: Span,
}

/// A part of a definition block.
#[derive(Clone, Debug)]
pub(crate) enum Item {
    Signature { span: Span, numbers: [usize; 3] },
    Basis { span: Span, blades: Vec<(Name, Name)> },
    Entity { docs: Vec<String>, name: Name, components: Vec<RawComponent>, relations: Vec<RawRelation> },
    Kernel(Box<RawKernel>),
    Scalar { path: TokenStream },
    Export { name: Name },
    Recipe { kernel: Name, model: Name, rows: Vec<RawRow> },
    PackedRecipe(PackedRecipe),
}

/// A row of a recipe: a name, or `out.FIELD`, and its value.
#[derive(Clone, Debug)]
pub(crate) struct RawRow {
    pub(crate) name: String,
    pub(crate) value: RawExpression,
}

/// A component of an entity.
#[derive(Clone, Debug)]
pub(crate) struct RawComponent {
    pub(crate) field: Option<Name>,
    pub(crate) constant: Option<i64>,
    pub(crate) blade: Name,
}

/// A relation of an entity or a kernel.
#[derive(Clone, Debug)]
pub(crate) struct RawRelation {
    pub(crate) left: RawExpression,
    pub(crate) right: RawExpression,
    pub(crate) span: Span,
}

/// A kernel.
#[derive(Clone, Debug)]
pub(crate) struct RawKernel {
    pub(crate) docs: Vec<String>,
    pub(crate) name: Name,
    pub(crate) parameters: Vec<RawParameter>,
    pub(crate) output: Name,
    pub(crate) expression: RawExpression,
    pub(crate) relations: Vec<RawRelation>,
    pub(crate) models: Vec<Name>,
    pub(crate) packed: Option<Span>,
    pub(crate) polynomial: Vec<Name>,
    pub(crate) hoist: Option<[Name; 3]>,
}

/// A parameter of a kernel.
#[derive(Clone, Debug)]
pub(crate) struct RawParameter {
    pub(crate) uniform: bool,
    pub(crate) name: Name,
    pub(crate) entity: Name,
}

/// An expression whose names are not resolved.
#[derive(Clone, Debug)]
pub(crate) struct RawExpression {
    pub(crate) kind: RawKind,
    pub(crate) span: Span,
}

#[derive(Clone, Debug)]
pub(crate) enum RawKind {
    Name(String),
    Field(String, String),
    Number(i64),
    Negate(Box<RawExpression>),
    Reverse(Box<RawExpression>),
    Binary(Operator, Box<RawExpression>, Box<RawExpression>),
    Quotient(Box<RawExpression>, Box<RawExpression>),
    Call(String, Vec<RawExpression>),
}

const KEYWORDS: &str = "`signature`, `basis`, `entity`, `kernel`, `preset`, `scalar`, `export` or `recipe`";

/// Parses a block into items.
///
/// # Errors
/// Every item that does not parse, combined; brackets that are nested too deep, or too many items.
pub(crate) fn parse(tokens: TokenStream) -> syn::Result<Vec<Item>> {
    check_nesting(&tokens)?;
    let mut items = Vec::new();
    let mut errors = Errors::default();
    for chunk in chunks(tokens) {
        let span = chunk.first().map_or_else(Span::call_site, TokenTree::span);
        match parse_item(chunk) {
            Ok(parsed) => items.extend(parsed),
            Err(error) => errors.absorb(error),
        }
        if items.len() > MAX_ITEMS {
            return Err(syn::Error::new(span, format!("expected at most {MAX_ITEMS} items in a block, found more")));
        }
    }
    errors.into_result(items)
}

/// Checks how deep brackets are nested, on a stack of its own: the parser recurses into them.
fn check_nesting(tokens: &TokenStream) -> syn::Result<()> {
    let mut open = vec![tokens.clone().into_iter()];
    while let Some(innermost) = open.last_mut() {
        match innermost.next() {
            Some(TokenTree::Group(group)) if open.len() > MAX_DEPTH => {
                let message = format!("expected brackets nested at most {MAX_DEPTH} deep, found deeper ones");
                return Err(syn::Error::new(group.span_open(), message));
            }
            Some(TokenTree::Group(group)) => open.push(group.stream().into_iter()),
            Some(_) => {}
            None => drop(open.pop()),
        }
    }
    Ok(())
}

/// Checks the length of a list after a part has been added.
fn check_length(input: ParseStream, length: usize) -> syn::Result<()> {
    let message = || format!("expected at most {MAX_LISTED} parts of a list, found more");
    if length > MAX_LISTED { Err(syn::Error::new(input.span(), message())) } else { Ok(()) }
}

/// Parses an item. One that lacks its `;` is parsed as if it had it, to see whether that is all it lacks.
fn parse_item(chunk: Vec<TokenTree>) -> syn::Result<Vec<Item>> {
    let last = match chunk.last() {
        Some(TokenTree::Group(group)) if group.delimiter() == Delimiter::Brace => None,
        Some(TokenTree::Punct(punct)) if punct.as_char() == ';' => None,
        last => last.map(TokenTree::span),
    };
    let Some(span) = last else { return item.parse2(chunk.into_iter().collect()) };
    let mut semicolon = Punct::new(';', Spacing::Alone);
    semicolon.set_span(span);
    item.parse2(chunk.into_iter().chain([semicolon.into()]).collect())?;
    Err(syn::Error::new(span, "expected `;` after this, found the end of the block"))
}

/// Splits a block after every `;` and after the braces of an entity without relations.
fn chunks(tokens: TokenStream) -> Vec<Vec<TokenTree>> {
    let mut chunks = Vec::new();
    let mut chunk = Vec::new();
    let mut tokens = tokens.into_iter().peekable();
    while let Some(token) = tokens.next() {
        let ends = match &token {
            TokenTree::Punct(punct) => punct.as_char() == ';',
            TokenTree::Group(group) if group.delimiter() == Delimiter::Brace => match tokens.peek() {
                Some(TokenTree::Ident(next)) => next != "where",
                Some(TokenTree::Punct(next)) => next.as_char() != ';',
                _ => true,
            },
            _ => false,
        };
        chunk.push(token);
        if ends {
            chunks.push(std::mem::take(&mut chunk));
        }
    }
    if !chunk.is_empty() {
        chunks.push(chunk);
    }
    chunks
}

/// What is expected here, and what stands here instead.
fn unexpected(input: ParseStream, expected: &str) -> syn::Error {
    let found = match input.cursor().token_tree() {
        Some((TokenTree::Group(group), _)) => match group.delimiter() {
            Delimiter::Parenthesis => "`(`".to_owned(),
            Delimiter::Brace => "`{`".to_owned(),
            Delimiter::Bracket => "`[`".to_owned(),
            Delimiter::None => format!("`{group}`"),
        },
        Some((token, _)) => format!("`{token}`"),
        None => "the end".to_owned(),
    };
    syn::Error::new(input.span(), format!("expected {expected}, found {found}"))
}

/// A token that is written as `expected` says.
fn token<T: Parse>(input: ParseStream, expected: &str) -> syn::Result<T> {
    input.parse().map_err(|_| unexpected(input, expected))
}

/// What stands between commas, the last of which may be left out.
fn comma_separated<T>(input: ParseStream, parse: impl Fn(ParseStream) -> syn::Result<T>) -> syn::Result<Vec<T>> {
    let mut parsed = Vec::new();
    while !input.is_empty() {
        parsed.push(parse(input)?);
        check_length(input, parsed.len())?;
        if !input.is_empty() {
            token::<Token![,]>(input, "`,`")?;
        }
    }
    Ok(parsed)
}

fn number<N: FromStr<Err: Display>>(input: ParseStream) -> syn::Result<N> {
    let literal: LitInt = token(input, "a whole number")?;
    let message = format!("expected a whole number of at most 63 bits, found `{literal}`");
    literal.base10_parse().map_err(|_| syn::Error::new(literal.span(), message))
}

fn item(input: ParseStream) -> syn::Result<Vec<Item>> {
    if input.peek(Token![;]) {
        input.parse::<Token![;]>()?;
        return Ok(Vec::new());
    }
    let docs = docs(input)?;
    let keyword: Ident = any_ident(input, KEYWORDS)?;
    let item = match keyword.to_string().as_str() {
        "signature" => signature(keyword.span(), input)?,
        "basis" => basis(keyword.span(), input)?,
        "entity" => return entity(docs, input).map(|item| vec![item]),
        "kernel" => kernel(docs, input)?,
        "scalar" => scalar(input)?,
        "recipe" => return recipe(input).map(|item| vec![item]),
        "export" => Item::Export { name: name(input, "a name for the exported list of kernels")? },
        "preset" => {
            let items = included(&name(input, "the name of a preset")?)?;
            token::<Token![;]>(input, "`;`")?;
            return Ok(items);
        }
        other => return Err(syn::Error::new(keyword.span(), format!("expected {KEYWORDS}, found `{other}`"))),
    };
    token::<Token![;]>(input, "`;`")?;
    Ok(vec![item])
}

fn included(name: &Name) -> syn::Result<Vec<Item>> {
    let text = preset::text(&name.text).ok_or_else(|| {
        let message = format!("expected one of the presets {}, found `{}`", preset::names(), name.text);
        syn::Error::new(name.span, message)
    })?;
    let tokens: TokenStream = text.parse().map_err(|error| {
        syn::Error::new(name.span, format!("expected a preset that is made of tokens, found {error}"))
    })?;
    parse(tokens)
}

/// An identifier, keywords of Rust included.
fn any_ident(input: ParseStream, expected: &str) -> syn::Result<Ident> {
    input.step(|cursor| cursor.ident().ok_or_else(|| cursor.error(""))).map_err(|_| unexpected(input, expected))
}

/// An identifier that Rust lets be a name, as it is or raw.
fn name(input: ParseStream, expected: &str) -> syn::Result<Name> {
    let is_name = |ident: &Ident| !["_", "self", "Self", "super", "crate"].iter().any(|reserved| ident == reserved);
    let ident = input
        .step(|cursor| cursor.ident().filter(|(ident, _)| is_name(ident)).ok_or_else(|| cursor.error("")))
        .map_err(|_| unexpected(input, expected))?;
    Ok(Name { text: ident.unraw().to_string(), span: ident.span() })
}

fn docs(input: ParseStream) -> syn::Result<Vec<String>> {
    let mut docs = Vec::new();
    while input.peek(Token![#]) {
        input.parse::<Token![#]>()?;
        let content;
        bracketed!(content in input);
        let attribute = any_ident(&content, "a doc comment")?;
        if attribute != "doc" {
            let message = format!("expected a doc comment, found the attribute `{attribute}`");
            return Err(syn::Error::new(attribute.span(), message));
        }
        content.parse::<Token![=]>()?;
        docs.push(content.parse::<LitStr>()?.value().trim().to_owned());
    }
    Ok(docs)
}

/// The inside of parentheses.
fn parentheses(input: ParseStream) -> syn::Result<ParseBuffer> {
    if !input.peek(syn::token::Paren) {
        return Err(unexpected(input, "`(`"));
    }
    let content;
    parenthesized!(content in input);
    Ok(content)
}

fn signature(span: Span, input: ParseStream) -> syn::Result<Item> {
    let content = parentheses(input)?;
    let numbers = comma_separated(&content, number)?;
    let found = numbers.len();
    let numbers = numbers.try_into().map_err(|_| {
        syn::Error::new(span, format!("expected a signature of three numbers (p, q, r), found {found}"))
    })?;
    Ok(Item::Signature { span, numbers })
}

/// A blade: a name, or the number 1 for the scalar.
fn blade(input: ParseStream) -> syn::Result<Name> {
    if input.peek(LitInt) {
        let literal: LitInt = input.parse()?;
        return Ok(Name { text: literal.to_string(), span: literal.span() });
    }
    name(input, "a blade")
}

fn basis(span: Span, input: ParseStream) -> syn::Result<Item> {
    let mut blades = Vec::new();
    while !input.peek(Token![;]) && !input.is_empty() {
        let name = blade(input)?;
        let word = if input.peek(Token![=]) {
            input.parse::<Token![=]>()?;
            blade(input)?
        } else {
            name.clone()
        };
        blades.push((name, word));
        check_length(input, blades.len())?;
    }
    Ok(Item::Basis { span, blades })
}

fn entity(docs: Vec<String>, input: ParseStream) -> syn::Result<Item> {
    let name = name(input, "the name of an entity")?;
    if !input.peek(syn::token::Brace) {
        return Err(unexpected(input, "`{`"));
    }
    let content;
    syn::braced!(content in input);
    let components = comma_separated(&content, component)?;
    let relations = relations(input)?;
    if !input.is_empty() || !relations.is_empty() {
        token::<Token![;]>(input, "`;`")?;
    }
    Ok(Item::Entity { docs, name, components, relations })
}

fn component(input: ParseStream) -> syn::Result<RawComponent> {
    if input.peek(LitInt) || input.peek(Token![-]) {
        let minus = input.parse::<Option<Token![-]>>()?.is_some();
        let number: i64 = number(input)?;
        token::<Token![:]>(input, "`:`")?;
        let constant = Some(if minus { -number } else { number });
        return Ok(RawComponent { field: None, constant, blade: blade(input)? });
    }
    let field = name(input, "a field, a blade or a number")?;
    let blade = if input.peek(Token![:]) {
        input.parse::<Token![:]>()?;
        blade(input)?
    } else {
        field.clone()
    };
    Ok(RawComponent { field: Some(field), constant: None, blade })
}

fn relations(input: ParseStream) -> syn::Result<Vec<RawRelation>> {
    let mut relations = Vec::new();
    if !input.peek(Token![where]) {
        return Ok(relations);
    }
    input.parse::<Token![where]>()?;
    loop {
        let span = input.span();
        let left = expression(input)?;
        token::<Token![==]>(input, "`==`")?;
        relations.push(RawRelation { left, right: expression(input)?, span });
        check_length(input, relations.len())?;
        if !input.peek(Token![,]) {
            return Ok(relations);
        }
        input.parse::<Token![,]>()?;
        if input.peek(Token![;]) {
            return Ok(relations);
        }
    }
}

fn kernel(docs: Vec<String>, input: ParseStream) -> syn::Result<Item> {
    let kernel_name = name(input, "the name of a kernel")?;
    let parameter = |input: ParseStream| {
        let mut parameter = name(input, "the name of a parameter")?;
        let uniform = parameter.text == "uniform" && !input.peek(Token![:]);
        if uniform {
            parameter = name(input, "the name of a parameter")?;
        }
        token::<Token![:]>(input, "`:`")?;
        Ok(RawParameter { uniform, name: parameter, entity: name(input, "an entity")? })
    };
    let parameters = comma_separated(&parentheses(input)?, parameter)?;
    token::<Token![->]>(input, "`->`")?;
    let output = name(input, "an entity")?;
    token::<Token![=]>(input, "`=`")?;
    let expression = expression(input)?;
    let relations = relations(input)?;
    let Clauses { models, packed, polynomial, hoist } = clauses(input)?;
    Ok(Item::Kernel(Box::new(RawKernel {
        docs,
        name: kernel_name,
        parameters,
        output,
        expression,
        relations,
        models,
        packed,
        polynomial,
        hoist,
    })))
}

/// What may stand behind a definition.
#[derive(Default)]
struct Clauses {
    models: Vec<Name>,
    packed: Option<Span>,
    polynomial: Vec<Name>,
    hoist: Option<[Name; 3]>,
}

/// `cost flops, fma`, `packed`, `polynomial f32, f64` and `hoist Record, prepare, apply`, in this order.
fn clauses(input: ParseStream) -> syn::Result<Clauses> {
    let mut clauses = Clauses::default();
    while !input.peek(Token![;]) && !input.is_empty() {
        let keyword = any_ident(input, CLAUSES)?;
        let (polynomial, hoist) = (!clauses.polynomial.is_empty(), clauses.hoist.is_some());
        let packed = clauses.packed.is_some();
        if keyword == "cost" && clauses.models.is_empty() && !packed && !polynomial && !hoist {
            clauses.models = names(input, "a cost model")?;
        } else if keyword == "packed" && !packed && !polynomial && !hoist {
            clauses.packed = Some(keyword.span());
        } else if keyword == "polynomial" && !polynomial && !hoist {
            clauses.polynomial = names(input, "`f32` or `f64`")?;
        } else if keyword == "hoist" && !hoist {
            let found = names(input, "a name")?;
            let count = found.len();
            clauses.hoist = Some(found.try_into().map_err(|_| {
                let message = format!("expected `hoist STRUCT, PREPARE, APPLY`, found {count} names");
                syn::Error::new(keyword.span(), message)
            })?);
        } else {
            return Err(syn::Error::new(keyword.span(), format!("expected {CLAUSES}, found `{keyword}`")));
        }
    }
    Ok(clauses)
}

const CLAUSES: &str = "an operator, `where`, `cost`, `packed`, `polynomial`, `hoist` or `;`";

/// Names between commas.
fn names(input: ParseStream, expected: &str) -> syn::Result<Vec<Name>> {
    let mut names = vec![name(input, expected)?];
    while input.peek(Token![,]) {
        input.parse::<Token![,]>()?;
        names.push(name(input, expected)?);
        check_length(input, names.len())?;
    }
    Ok(names)
}

fn scalar(input: ParseStream) -> syn::Result<Item> {
    let mut path = TokenStream::new();
    while !input.peek(Token![;]) && !input.is_empty() {
        path.extend([input.parse::<TokenTree>()?]);
    }
    if path.is_empty() {
        return Err(unexpected(input, "the path of the module with the traits `Scalar` and `Real`"));
    }
    Ok(Item::Scalar { path })
}

fn recipe(input: ParseStream) -> syn::Result<Item> {
    let (kernel, model) = (name(input, "the name of a kernel")?, name(input, "a cost model or `packed`")?);
    let content;
    syn::braced!(content in input);
    if model.text == "packed" {
        return Ok(Item::PackedRecipe(packed::recipe(kernel, &content)?));
    }
    let mut rows = Vec::new();
    while !content.is_empty() {
        let mut row = name(&content, "the name of a row")?.text;
        if content.peek(Token![.]) {
            content.parse::<Token![.]>()?;
            row = format!("{row}.{}", name(&content, "a field")?.text);
        }
        token::<Token![=]>(&content, "`=`")?;
        rows.push(RawRow { name: row, value: expression(&content)? });
        check_length(&content, rows.len())?;
        token::<Token![;]>(&content, "`;`")?;
    }
    Ok(Item::Recipe { kernel, model, rows })
}

fn expression(input: ParseStream) -> syn::Result<RawExpression> {
    binary(input, 0, 0)
}

/// Parses an expression that stands alone.
///
/// # Errors
/// Where it is none, or something stands behind it.
#[cfg(feature = "check")]
pub(crate) fn parse_expression(tokens: TokenStream) -> syn::Result<RawExpression> {
    let whole = |input: ParseStream| {
        let parsed = expression(input)?;
        if input.is_empty() { Ok(parsed) } else { Err(unexpected(input, "an operator or the end")) }
    };
    whole.parse2(tokens)
}

/// Binary operators by precedence climbing.
fn binary(input: ParseStream, least: u8, mut depth: usize) -> syn::Result<RawExpression> {
    let mut left = unary(input, depth)?;
    loop {
        depth += 1;
        let span = input.span();
        if input.peek(Token![/]) && least <= Operator::Geometric.precedence() {
            input.parse::<Token![/]>()?;
            let right = unary(input, depth)?;
            left = RawExpression { kind: RawKind::Quotient(Box::new(left), Box::new(right)), span };
            continue;
        }
        let Some(operator) = peek_operator(input).filter(|operator| operator.precedence() >= least) else {
            return Ok(left);
        };
        if operator == Operator::Sandwich {
            input.parse::<Token![>>]>()?;
        } else {
            input.parse::<TokenTree>()?;
        }
        let right = binary(input, operator.precedence() + 1, depth)?;
        left = RawExpression { kind: RawKind::Binary(operator, Box::new(left), Box::new(right)), span };
    }
}

fn peek_operator(input: ParseStream) -> Option<Operator> {
    if input.peek(Token![>>]) {
        Some(Operator::Sandwich)
    } else if input.peek(Token![+]) {
        Some(Operator::Add)
    } else if input.peek(Token![-]) {
        Some(Operator::Sub)
    } else if input.peek(Token![*]) {
        Some(Operator::Geometric)
    } else if input.peek(Token![^]) {
        Some(Operator::Outer)
    } else if input.peek(Token![&]) {
        Some(Operator::Regressive)
    } else if input.peek(Token![|]) {
        Some(Operator::Inner)
    } else {
        None
    }
}

fn unary(input: ParseStream, depth: usize) -> syn::Result<RawExpression> {
    let span = input.span();
    if depth > MAX_DEPTH {
        let message = format!("expected an expression nested at most {MAX_DEPTH} deep, found a deeper one");
        return Err(syn::Error::new(span, message));
    }
    if input.peek(Token![-]) {
        input.parse::<Token![-]>()?;
        return Ok(RawExpression { kind: RawKind::Negate(Box::new(unary(input, depth + 1)?)), span });
    }
    if input.peek(Token![~]) {
        input.parse::<Token![~]>()?;
        return Ok(RawExpression { kind: RawKind::Reverse(Box::new(unary(input, depth + 1)?)), span });
    }
    primary(input, depth + 1)
}

fn primary(input: ParseStream, depth: usize) -> syn::Result<RawExpression> {
    let span = input.span();
    if input.peek(syn::token::Paren) {
        let content = parentheses(input)?;
        let inner = binary(&content, 0, depth)?;
        if !content.is_empty() {
            return Err(unexpected(&content, "an operator or `)`"));
        }
        return Ok(inner);
    }
    if input.peek(syn::LitFloat) {
        let literal: syn::LitFloat = input.parse()?;
        let message = format!("expected a whole number or a quotient of two, found `{literal}`");
        return Err(syn::Error::new(literal.span(), message));
    }
    if input.peek(LitInt) {
        let number = number(input)?;
        return Ok(RawExpression { kind: RawKind::Number(number), span });
    }
    let first = name(input, "an expression")?;
    if input.peek(Token![.]) {
        input.parse::<Token![.]>()?;
        let field = name(input, "a field")?;
        return Ok(RawExpression { kind: RawKind::Field(first.text, field.text), span });
    }
    if input.peek(syn::token::Paren) {
        let arguments = comma_separated(&parentheses(input)?, |input| binary(input, 0, depth + 2))?;
        return Ok(RawExpression { kind: RawKind::Call(first.text, arguments), span });
    }
    Ok(RawExpression { kind: RawKind::Name(first.text), span })
}
