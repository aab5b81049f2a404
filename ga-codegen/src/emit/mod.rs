//! From proved programs to Rust. The text says nothing that the program does not: operations keep their order and
//! grouping, so floating-point results are those of the program.

mod body;
mod entity;
mod kernel;
mod meaning;
mod operators;
mod packed;
mod polynomial;
mod scalar;

use crate::compile::Compiled;
use crate::errors::check_effort;
use crate::kernel::{Definition, Entity};
use crate::limits::MAX_STEPS;
use crate::symbolic::effort;
use proc_macro2::{Ident, Span, TokenStream};
use quote::quote;

/// The Rust of a definition: entities, a module `kernels`, operators and conversions; the scalar traits where the
/// definition names none.
///
/// # Errors
/// A constant that no emitted program can hold.
pub fn rust(definition: &Definition, compiled: &[Compiled]) -> syn::Result<TokenStream> {
    effort::limited(MAX_STEPS, || emit(definition, compiled))
}

fn emit(definition: &Definition, compiled: &[Compiled]) -> syn::Result<TokenStream> {
    let scalar = scalar::module(definition);
    let entities: Vec<_> = definition
        .entities
        .iter()
        .filter(|entity| !entity.is_scalar())
        .map(|entity| {
            let emitted = entity::entity(entity, definition.basis.signature());
            check_effort(entity.span)?;
            emitted
        })
        .collect::<syn::Result<_>>()?;
    let functions = kernels(definition, compiled, None)?;
    let operators = operators::operators(definition);
    let export = kernel::export(definition);
    Ok(quote! {
        #scalar
        #(#entities)*
        /// The kernels: every operation as a function, proved equal to its definition.
        ///
        /// Rounding errors are 2-norms of the difference between what is computed and the exact result for the same
        /// inputs, unless something overflows or underflows. `u` is 1.0001 times the unit roundoff, which is 2^-24 for f32
        /// and 2^-53 for f64. `|a|` is the norm of the coefficients of `a` before blades without a null generator, `|a|_0`
        /// that of its other coefficients. Where a type promises that `|a|` is 1 it is left out.
        ///
        /// Costs count a doubling, emitted as `x + x`, as a multiplication and a negation as nothing.
        ///
        /// Temporaries are named where they mean something: `cross_e1` is the coefficient of `e1`, up to sign, in the
        /// commutator (m x - x m)/2 of a sandwich m x ~m, `inner_e1` that in the product that a larger one is made of, m x
        /// for a sandwich.
        pub mod kernels {
            use super::*;
            #functions
        }
        #operators
        #export
    })
}

/// The functions of all kernels, or of the one of that name.
///
/// # Errors
/// A constant that no emitted program can hold.
pub fn kernels(definition: &Definition, compiled: &[Compiled], only: Option<&str>) -> syn::Result<TokenStream> {
    let chosen = |compiled: &&Compiled| {
        only.is_none_or(|name| compiled.name == name || definition.kernels[compiled.kernel].name == name)
    };
    let chosen: Vec<_> = compiled.iter().filter(chosen).collect();
    let functions = chosen.iter().map(|compiled| kernel::function(definition, compiled));
    let functions: Vec<_> = functions.collect::<syn::Result<_>>()?;
    let polynomials = polynomial::functions(&chosen);
    Ok(quote!(#(#functions)* #polynomials))
}

fn ident(name: &str) -> Ident {
    // A name that is a keyword of Rust becomes a raw identifier.
    syn::parse_str::<Ident>(name).unwrap_or_else(|_| Ident::new_raw(name, Span::call_site()))
}

/// The Rust type of an entity over the scalar `T`.
fn entity_type(entity: &Entity) -> TokenStream {
    if entity.is_scalar() {
        quote!(T)
    } else {
        let name = ident(&entity.name);
        quote!(#name<T>)
    }
}

/// Doc attributes, a line each.
fn doc(lines: &[String]) -> TokenStream {
    let lines = lines.iter().map(|line| if line.is_empty() { String::new() } else { format!(" {line}") });
    quote!(#(#[doc = #lines])*)
}
