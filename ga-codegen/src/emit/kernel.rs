//! Functions from kernels.

use super::body::{Style, access, body};
use super::{doc, entity_type, ident, meaning, packed, polynomial};
use crate::approximation::approximation;
use crate::compile::{Compiled, Part};
use crate::kernel::{Definition, Hoist, Kernel};
use crate::program::{CostModel, Count, Operation, PackedOperation, Program, Source};
use proc_macro2::{Ident, TokenStream};
use quote::{format_ident, quote};

/// Whether a program needs more than a ring.
pub(super) fn needs_real(program: &Program) -> bool {
    let is_ring = |operation: &Operation| {
        matches!(
            operation,
            Operation::Input(_)
                | Operation::Constant(_)
                | Operation::Add(..)
                | Operation::Sub(..)
                | Operation::Mul(..)
                | Operation::Neg(_)
                | Operation::Double(_)
        )
    };
    !program.operations.iter().all(is_ring)
}

/// The function of a kernel or of a part of one, its definition, assumptions and cost above it; the struct between the
/// parts comes with the first.
pub(super) fn function(definition: &Definition, compiled: &Compiled) -> syn::Result<TokenStream> {
    let kernel = &definition.kernels[compiled.kernel];
    let names = compiled.parameter_names(definition);
    let coefficients = &compiled.specification.coefficients;
    let inputs: Vec<_> = coefficients.iter().map(|c| access(names[c.parameter], &c.field)).collect();
    let style = style(compiled);
    let body = match &compiled.packed {
        Some(program) => packed::body(program, &inputs, &names, kernel.span)?,
        None => body(&compiled.program, &inputs, &names, &meaning::names(compiled), style, kernel.span)?,
    };
    let parameters = parameters(definition, compiled);
    let (record, output_type, result) = output(definition, compiled, &body.outputs);
    let (docs, name) = (doc(&documentation(definition, compiled)), ident(&compiled.name));
    let bound = if needs_real(&compiled.program) { quote!(Real) } else { quote!(Scalar) };
    let statements = body.statements;
    let range = polynomial::range(definition, compiled, &parameters)?;
    let inline = match style {
        Style::Plain => quote!(#[inline]),
        // Left by itself, the function would be compiled for machines without the instruction.
        Style::MulAdd => quote!(#[inline(always)]),
    };
    Ok(quote! {
        #range
        #record
        #docs
        #inline
        pub fn #name<T: #bound>(#(#parameters),*) -> #output_type {
            #statements
            #result
        }
    })
}

/// What is for loops over many items goes by `mul_add`: their numbers may fuse it. What is read and called singly is plain.
fn style(compiled: &Compiled) -> Style {
    let is_for_many = compiled.model == CostModel::Fma || compiled.precision.is_some() || compiled.part == Part::Apply;
    if is_for_many { Style::MulAdd } else { Style::Plain }
}

/// The parameters of a function; an underscore before the names of those that are not used.
fn parameters(definition: &Definition, compiled: &Compiled) -> Vec<TokenStream> {
    let kernel = &definition.kernels[compiled.kernel];
    let record = kernel.hoist.as_ref().filter(|_| compiled.part == Part::Apply).map(|hoist| {
        let (name, record) = (ident(Hoist::RECORD), ident(&hoist.record));
        quote!(#name: #record<T>)
    });
    let own = kernel.parameters.iter().enumerate().filter(|&(index, _)| match compiled.part {
        Part::Whole => true,
        Part::Prepare => kernel.uniform[index],
        Part::Apply => !kernel.uniform[index],
    });
    let inputs = inputs(compiled);
    let own = own.map(|(index, parameter)| {
        let used = inputs.iter().any(|&input| compiled.specification.coefficients[input].parameter == index);
        let name = if used { ident(&parameter.name) } else { unused_name(kernel, &parameter.name) };
        let entity = entity_type(&definition.entities[parameter.entity]);
        quote!(#name: #entity)
    });
    record.into_iter().chain(own).collect()
}

/// The inputs that the emitted program names.
fn inputs(compiled: &Compiled) -> Vec<usize> {
    let of_lane = |source: Source| if let Source::Input(input) = source { Some(input) } else { None };
    match &compiled.packed {
        Some(packed) => {
            let loads = packed.operations.iter().filter_map(|operation| match operation {
                PackedOperation::Load(sources) => Some(*sources),
                _ => None,
            });
            loads.flatten().filter_map(of_lane).collect()
        }
        None => {
            let inputs = compiled.program.operations.iter();
            inputs.filter_map(|o| if let Operation::Input(input) = o { Some(*input) } else { None }).collect()
        }
    }
}

/// A name with an underscore before it that no other parameter has.
fn unused_name(kernel: &Kernel, name: &str) -> Ident {
    let mut unused = format!("_{name}");
    while kernel.parameters.iter().any(|parameter| parameter.name == unused) {
        unused.insert(0, '_');
    }
    ident(&unused)
}

/// The struct of a record where the function makes one, the return type, and the expression for the result.
fn output(
    definition: &Definition,
    compiled: &Compiled,
    outputs: &[TokenStream],
) -> (TokenStream, TokenStream, TokenStream) {
    let kernel = &definition.kernels[compiled.kernel];
    let output = &definition.entities[kernel.output];
    // A plain scalar's field has no name.
    let fields = compiled.specification.fields.iter().filter(|field| !field.is_empty()).map(|field| ident(field));
    let fields: Vec<_> = fields.collect();
    match kernel.hoist.as_ref().filter(|_| compiled.part == Part::Prepare) {
        Some(hoist) => {
            let name = ident(&hoist.record);
            (record(kernel, hoist, compiled), quote!(#name<T>), quote!(#name { #(#fields: #outputs),* }))
        }
        None if output.is_scalar() => (TokenStream::new(), entity_type(output), quote!(#(#outputs)*)),
        None => {
            let name = ident(&output.name);
            (TokenStream::new(), entity_type(output), quote!(#name { #(#fields: #outputs),* }))
        }
    }
}

/// The struct between the parts of a kernel.
fn record(kernel: &Kernel, hoist: &Hoist, compiled: &Compiled) -> TokenStream {
    let name = ident(&hoist.record);
    let uniform = kernel.parameters.iter().zip(&kernel.uniform).filter(|(_, uniform)| **uniform);
    let uniform: Vec<_> = uniform.map(|(parameter, _)| format!("`{}`", parameter.name)).collect();
    let text = format!(
        " What {} determines in `{}`: made by [`{}`], used by [`{}`].",
        uniform.join(", "),
        kernel.definition(),
        hoist.prepare,
        hoist.apply
    );
    let labels = compiled.specification.projection.iter().flat_map(|projection| &projection.labels);
    let fields = compiled.specification.fields.iter().zip(labels).map(|(field, (output, input))| {
        let output = if output.is_empty() { "the result".to_owned() } else { format!("`{output}`") };
        let text = match input {
            None => format!(" What is always added to {output}."),
            Some(input) => format!(" How much of `{input}` goes into {output}."),
        };
        let field = ident(field);
        quote!(#[doc = #text] pub #field: T)
    });
    quote! {
        #[doc = #text]
        #[derive(Clone, Copy, Debug, PartialEq)]
        #[repr(C)]
        pub struct #name<T> {
            #(#fields),*
        }
    }
}

fn documentation(definition: &Definition, compiled: &Compiled) -> Vec<String> {
    let kernel = &definition.kernels[compiled.kernel];
    let mut lines = kernel.docs.clone();
    if !lines.is_empty() {
        lines.push(String::new());
    }
    let part = match (compiled.part, &kernel.hoist) {
        (Part::Prepare, Some(hoist)) => format!(": what stays the same, for [`{}`]", hoist.apply),
        (Part::Apply, Some(hoist)) => format!(": with what [`{}`] made", hoist.prepare),
        _ => String::new(),
    };
    lines.push(format!("`{}`{part}", kernel.definition()));
    lines.push(String::new());
    let promises = kernel.parameters.iter().flat_map(|parameter| {
        let statements = &definition.entities[parameter.entity].statements;
        statements.iter().map(|statement| format!("`{}`: `{}`", parameter.name, statement.text))
    });
    let assumptions: Vec<_> =
        promises.chain(kernel.statements.iter().map(|statement| format!("`{}`", statement.text))).collect();
    if !assumptions.is_empty() && compiled.part != Part::Apply {
        lines.push(format!("Assumes {}.", assumptions.join("; ")));
        lines.push(String::new());
    }
    lines.push(format!("Cost: {}. Proof: {}.", Count::of(&compiled.program), compiled.proof));
    if let Some(packed) = &compiled.packed {
        lines.push(String::new());
        lines.push(format!("Packed: {}.", packed.count()));
    }
    if compiled.precision.is_some() {
        let used = compiled.program.polynomials().into_iter();
        let off = used.map(|(function, precision, _)| {
            format!("- {}: off by at most {:.2e};", function.formula(), approximation(function, precision).error)
        });
        lines.push(String::new());
        lines.push(
            "By polynomials, each of which counts in the proof as the function that it is near, without roots,"
                .to_owned(),
        );
        lines.push(format!(
            "divisions or library calls; for the inputs of [`{}_holds`], elsewhere wrong:",
            compiled.name
        ));
        lines.extend(off);
        if let Some(precision) = compiled.precision {
            lines.push(format!("- as exact as `{}`, whatever `T` is.", precision.name()));
        }
    }
    if let Some(bound) = compiled.promised_bound(definition) {
        let text = bound.display(&compiled.parameter_names(definition));
        lines.push(String::new());
        lines.push(format!("Rounding error: {text}."));
    }
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
