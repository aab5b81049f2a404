//! Functions for the polynomials that programs evaluate, and where those are near what they stand for.

use super::body::{Style, access, body};
use super::doc;
use crate::approximation::{Function, Precision, approximation};
use crate::compile::Compiled;
use crate::kernel::Definition;
use crate::program::{Program, ProgramBuilder};
use crate::proof::evaluate_polynomials;
use proc_macro2::{Ident, Literal, TokenStream};
use quote::{format_ident, quote};
use std::collections::{BTreeMap, BTreeSet};

/// The name of the function for a polynomial.
pub(super) fn name(function: Function, precision: Precision) -> Ident {
    format_ident!("{}_{}", function.name(), precision.name())
}

/// A function for every polynomial that one of the programs evaluates.
pub(super) fn functions(compiled: &[&Compiled]) -> TokenStream {
    let used: BTreeSet<_> =
        compiled.iter().flat_map(|compiled| compiled.program.polynomials()).map(|p| (p.0, p.1)).collect();
    used.into_iter().map(|(function, precision)| horner(function, precision)).collect()
}

/// A polynomial, evaluated from the greatest power down (Horner).
fn horner(function: Function, precision: Precision) -> TokenStream {
    let polynomial = approximation(function, precision);
    let coefficients = polynomial.coefficients.iter().rev();
    let mut terms = coefficients.map(|&coefficient| {
        let coefficient = Literal::f64_unsuffixed(coefficient);
        quote!(T::from_f64(#coefficient))
    });
    let first = terms.next().unwrap_or_else(|| quote!(T::ZERO));
    let (low, high) = function.interval();
    let docs = doc(&[format!(
        "{} by a polynomial of degree {} for {} in [{low}, {high}]; off by at most {:.2e}, roundings apart.",
        function.formula(),
        polynomial.degree(),
        function.variable(),
        polynomial.error
    )]);
    let name = name(function, precision);
    quote! {
        #docs
        #[inline(always)]
        fn #name<T: Real>(x: T) -> T {
            let mut sum = #first;
            #(sum = sum.mul_add(x, #terms);)*
            sum
        }
    }
}

/// The function that says whether the polynomials of a program hold for an input; nothing for a program without any.
pub(super) fn range(
    definition: &Definition,
    compiled: &Compiled,
    parameters: &[TokenStream],
) -> syn::Result<TokenStream> {
    let polynomials = compiled.program.polynomials();
    if polynomials.is_empty() {
        return Ok(TokenStream::new());
    }
    let intervals: BTreeMap<_, _> =
        polynomials.iter().map(|&(function, _, argument)| (argument, function.interval())).collect();
    let kernel = &definition.kernels[compiled.kernel];
    let names = compiled.parameter_names(definition);
    let coefficients = &compiled.specification.coefficients;
    let inputs: Vec<_> = coefficients.iter().map(|c| access(names[c.parameter], &c.field)).collect();
    let program = restricted(&compiled.program, &intervals.keys().copied().collect::<Vec<_>>());
    let body = body(&program, &inputs, &names, &BTreeMap::new(), Style::Plain, kernel.span)?;
    let tests = body.outputs.iter().zip(intervals.values()).map(|(argument, &(low, high))| {
        let (low, high) = (Literal::f64_unsuffixed(low), Literal::f64_unsuffixed(high));
        quote!((T::from_f64(#low)..=T::from_f64(#high)).contains(&(#argument)))
    });
    let (name, statements) = (format_ident!("{}_holds", compiled.name), body.statements);
    let ranges = intervals.iter().map(|(&argument, &(low, high))| {
        let variable = polynomials.iter().find(|polynomial| polynomial.2 == argument).map_or("", |p| p.0.variable());
        format!("{variable} = `{}` is in [{low}, {high}]", meaning_of(compiled, argument))
    });
    let docs = doc(&[
        format!("Whether [`{}`] holds for an input: true where", compiled.name),
        format!("{}. False for NaN.", ranges.collect::<Vec<_>>().join(" and ")),
    ]);
    let test = quote!(#(#tests)&&*);
    Ok(quote! {
        #docs
        #[inline]
        pub fn #name<T: Real>(#(#parameters),*) -> bool {
            #statements
            #test
        }
    })
}

/// A value as a polynomial in the inputs.
fn meaning_of(compiled: &Compiled, value: usize) -> String {
    let program = restricted(&compiled.program, &[value]);
    let values = evaluate_polynomials(&program, compiled.specification.coefficients.len()).unwrap_or_default();
    let polynomial = program.outputs.first().and_then(|&output| values.get(output));
    polynomial.map_or_else(String::new, |polynomial| polynomial.display(&compiled.specification.names()))
}

/// The part of a program that some of its values need.
fn restricted(program: &Program, outputs: &[usize]) -> Program {
    let mut builder = ProgramBuilder::new();
    let mut values: Vec<usize> = Vec::with_capacity(program.operations.len());
    for operation in &program.operations {
        let value = builder.push(operation.map_operands(|operand| values[operand]));
        values.push(value);
    }
    builder.finish(&outputs.iter().map(|&output| values[output]).collect::<Vec<_>>())
}
