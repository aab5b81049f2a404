//! Functions from kernels.

use super::body::{access, body};
use super::{doc, entity_type, ident};
use crate::expand::Compiled;
use crate::kernel::{Definition, Kernel};
use crate::program::{Count, Operation, Program};
use proc_macro2::TokenStream;
use quote::{format_ident, quote};

/// Whether a program needs more than a ring.
pub(super) fn needs_real(program: &Program) -> bool {
    program.operations.iter().any(|operation| {
        matches!(
            operation,
            Operation::Sqrt(_) | Operation::Sin(_) | Operation::Cos(_) | Operation::Atan2(..) | Operation::Quotient(..)
        )
    })
}

/// The function of a kernel, its definition, assumptions and cost above it.
pub(super) fn function(definition: &Definition, compiled: &Compiled) -> syn::Result<TokenStream> {
    let kernel = &definition.kernels[compiled.kernel];
    let inputs: Vec<_> = compiled
        .specification
        .coefficients
        .iter()
        .map(|coefficient| access(&kernel.parameters[coefficient.parameter].name, &coefficient.field))
        .collect();
    let reserved: Vec<_> = kernel.parameters.iter().map(|parameter| parameter.name.as_str()).collect();
    let body = body(&compiled.program, &inputs, &reserved, kernel.span)?;
    let parameters = kernel.parameters.iter().enumerate().map(|(index, parameter)| {
        let used = |operation: &Operation| match operation {
            Operation::Input(input) => compiled.specification.coefficients[*input].parameter == index,
            _ => false,
        };
        let used = compiled.program.operations.iter().any(used);
        let name = if used { ident(&parameter.name) } else { format_ident!("_{}", parameter.name) };
        let entity = entity_type(&definition.entities[parameter.entity]);
        quote!(#name: #entity)
    });
    let output = &definition.entities[kernel.output];
    let (output_type, outputs) = (entity_type(output), &body.outputs);
    let result = if output.is_scalar() {
        quote!(#(#outputs)*)
    } else {
        let (name, fields) = (ident(&output.name), output.fields().map(|(field, _)| ident(field)));
        quote!(#name { #(#fields: #outputs),* })
    };
    let (docs, name, statements) =
        (doc(&documentation(definition, kernel, compiled)), ident(&compiled.name), body.statements);
    let bound = if needs_real(&compiled.program) { quote!(Real) } else { quote!(Scalar) };
    Ok(quote! {
        #docs
        #[inline]
        pub fn #name<T: #bound>(#(#parameters),*) -> #output_type {
            #statements
            #result
        }
    })
}

fn documentation(definition: &Definition, kernel: &Kernel, compiled: &Compiled) -> Vec<String> {
    let mut lines = kernel.docs.clone();
    if !lines.is_empty() {
        lines.push(String::new());
    }
    lines.push(format!("`{}`", kernel.definition()));
    lines.push(String::new());
    let promises = kernel.parameters.iter().flat_map(|parameter| {
        let statements = &definition.entities[parameter.entity].statements;
        statements.iter().map(|statement| format!("`{}`: `{}`", parameter.name, statement.text))
    });
    let assumptions: Vec<_> =
        promises.chain(kernel.statements.iter().map(|statement| format!("`{}`", statement.text))).collect();
    if !assumptions.is_empty() {
        lines.push(format!("Assumes {}.", assumptions.join("; ")));
        lines.push(String::new());
    }
    lines.push(format!("Cost: {}. Proof: {}.", Count::of(&compiled.program), compiled.proof));
    lines
}

/// A macro that hands the list of kernels to another one, where the definition asks for it.
pub(super) fn export(definition: &Definition) -> TokenStream {
    let Some(name) = &definition.export else { return TokenStream::new() };
    let name = format_ident!("{name}_kernels");
    let entity = |index: usize| ident(&definition.entities[index].name);
    let kernels = definition.kernels.iter().map(|kernel| {
        let (name, output) = (ident(&kernel.name), entity(kernel.output));
        let parameters = kernel.parameters.iter().map(|parameter| {
            let (name, entity) = (ident(&parameter.name), entity(parameter.entity));
            quote!(#name: #entity)
        });
        quote!(fn #name(#(#parameters),*) -> #output;)
    });
    quote! {
        /// Calls the macro of the given name with the signature of every kernel: `fn name(parameter: Entity, ...) ->
        /// Entity;`, for tests that look at all of them. A plain scalar is called `Scalar`.
        #[macro_export]
        macro_rules! #name {
            ($callback:ident) => {
                $callback! { #(#kernels)* }
            };
        }
    }
}
