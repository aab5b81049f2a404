//! Straight-line code on values of four lanes: a `let` for every operation.

use super::body::{Body, number};
use super::ident;
use crate::program::{LANES, PackedOperation, PackedProgram, Source};
use proc_macro2::{Ident, Literal, Span, TokenStream};
use quote::quote;

/// The body of a packed program whose inputs are these expressions; `reserved` names are not given to temporaries. An error is
/// at `span`.
pub(super) fn body(
    program: &PackedProgram,
    inputs: &[TokenStream],
    reserved: &[&str],
    span: Span,
) -> syn::Result<Body> {
    let free = |name: &String| !reserved.contains(&name.as_str());
    let mut names = (0..).map(|index| format!("v{index}")).filter(free).map(|name| ident(&name));
    let names: Vec<Ident> = names.by_ref().take(program.operations.len()).collect();
    let mut statements = TokenStream::new();
    for (name, operation) in names.iter().zip(&program.operations) {
        let expression = match *operation {
            PackedOperation::Load(sources) => {
                let source = |source: &Source| match *source {
                    Source::Input(index) => Ok(inputs[index].clone()),
                    Source::Constant(value) => number(value, span),
                };
                let lanes: Vec<_> = sources.iter().map(source).collect::<syn::Result<_>>()?;
                quote!(T::Four::new([#(#lanes),*]))
            }
            PackedOperation::Shuffle(a, lanes) => {
                let (a, mask) = (&names[a], mask(&lanes.map(|lane| format!("_{lane:02b}"))));
                quote!(#a.shuffle::<#mask>())
            }
            PackedOperation::Negate(a, negated) => {
                let (a, mask) = (&names[a], mask(&negated.map(|negated| u8::from(negated).to_string())));
                quote!(#a.negate::<#mask>())
            }
            PackedOperation::Double(a) => {
                let a = &names[a];
                quote!(#a + #a)
            }
            PackedOperation::Add(a, b) => {
                let (a, b) = (&names[a], &names[b]);
                quote!(#a + #b)
            }
            PackedOperation::Sub(a, b) => {
                let (a, b) = (&names[a], &names[b]);
                quote!(#a - #b)
            }
            PackedOperation::Mul(a, b) => {
                let (a, b) = (&names[a], &names[b]);
                quote!(#a * #b)
            }
        };
        statements.extend(quote!(let #name = #expression;));
    }
    let mut results: Vec<usize> = program.outputs.iter().map(|&(value, _)| value).collect();
    results.sort_unstable();
    results.dedup();
    for &value in &results {
        let name = &names[value];
        statements.extend(quote!(let #name = #name.to_array();));
    }
    let output = |&(value, lane): &(usize, u8)| {
        let (name, lane) = (&names[value], Literal::u8_unsuffixed(lane));
        quote!(#name[#lane])
    };
    Ok(Body { statements, outputs: program.outputs.iter().map(output).collect() })
}

/// A binary number of these digits, those of the lowest lane last.
fn mask(digits: &[String; LANES]) -> TokenStream {
    let digits: String = digits.iter().rev().map(String::as_str).collect();
    let literal: Result<Literal, _> = format!("0b{}", digits.trim_start_matches('_')).parse();
    let literal = literal.expect("invariant: binary digits are a number");
    quote!(#literal)
}
