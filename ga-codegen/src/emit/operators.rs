//! Operators and conversions from kernels whose definition is just that: `a * b` becomes `Mul`, `m >> x` becomes `Shr`,
//! a bare parameter becomes `From`.
//!
//! Where a type converts to another with the same fields (a unit plane to a plane), it can stand for that other in an
//! operator for which no kernel of its own exists; the first suitable kernel of the block is taken.
//!
//! Of a packed kernel the operator calls the packed function for numbers whose arithmetic on four lanes is fast.

use super::{entity_type, ident};
use crate::kernel::{Definition, ExpressionKind, Kernel, Operator};
use proc_macro2::{Ident, TokenStream};
use quote::{format_ident, quote};
use std::collections::BTreeSet;

/// All operators and conversions of a definition.
pub(super) fn operators(definition: &Definition) -> TokenStream {
    let mut converted = BTreeSet::new();
    let first =
        |kernel: &&Kernel| is_conversion(kernel) && converted.insert((kernel.parameters[0].entity, kernel.output));
    let conversions = definition.kernels.iter().filter(first).map(|kernel| {
        let (from, to) = (kernel.parameters[0].entity, kernel.output);
        let (from, to) = (entity_type(&definition.entities[from]), entity_type(&definition.entities[to]));
        let name = ident(&kernel.name);
        quote! {
            impl<T: Scalar> From<#from> for #to {
                #[inline]
                fn from(value: #from) -> Self {
                    kernels::#name(value)
                }
            }
        }
    });
    let conversions: Vec<_> = conversions.collect();
    let mut done: BTreeSet<(&str, usize, usize)> = BTreeSet::new();
    let mut implementations = Vec::new();
    let operators: Vec<_> = definition.kernels.iter().filter_map(|k| Some((k, operator_of(definition, k)?))).collect();
    for (kernel, operator) in &operators {
        let (a, b) = (kernel.parameters[0].entity, kernel.parameters[1].entity);
        if done.insert((operator.symbol(), a, b)) {
            implementations.push(implementation(definition, kernel, *operator, a, b));
        }
    }
    for (kernel, operator) in &operators {
        let (a, b) = (kernel.parameters[0].entity, kernel.parameters[1].entity);
        for a in refinements(definition, a) {
            for b in refinements(definition, b) {
                if done.insert((operator.symbol(), a, b)) {
                    implementations.push(implementation(definition, kernel, *operator, a, b));
                }
            }
        }
    }
    quote!(#(#conversions)* #(#implementations)*)
}

fn is_conversion(kernel: &Kernel) -> bool {
    let [parameter] = kernel.parameters.as_slice() else { return false };
    let is_parameter = matches!(kernel.expression.kind, ExpressionKind::Parameter(0)) && kernel.analytic.is_none();
    is_parameter && kernel.statements.is_empty() && parameter.entity != kernel.output && kernel.output != 0
}

/// The operator, where the definition is one between the two parameters and the result is not built in already.
fn operator_of(definition: &Definition, kernel: &Kernel) -> Option<Operator> {
    let ([a, b], ExpressionKind::Binary(operator, left, right)) =
        (kernel.parameters.as_slice(), &kernel.expression.kind)
    else {
        return None;
    };
    let in_order = matches!((&left.kind, &right.kind), (ExpressionKind::Parameter(0), ExpressionKind::Parameter(1)));
    let scalar = |entity: usize| definition.entities[entity].is_scalar();
    let same_type = a.entity == b.entity && a.entity == kernel.output;
    let built_in = definition.entities[a.entity].is_linear()
        && (matches!(operator, Operator::Add | Operator::Sub) && same_type
            || *operator == Operator::Geometric && scalar(b.entity));
    let suitable = in_order && !scalar(a.entity) && (!scalar(b.entity) || *operator == Operator::Geometric);
    (suitable && !built_in && kernel.analytic.is_none() && kernel.statements.is_empty()).then_some(*operator)
}

/// The entity itself and those that convert to it and have the same fields.
fn refinements(definition: &Definition, entity: usize) -> Vec<usize> {
    let same_fields = |other: usize| definition.entities[other].components == definition.entities[entity].components;
    let converting = definition.kernels.iter().filter(|kernel| is_conversion(kernel) && kernel.output == entity);
    let refining = converting.map(|kernel| kernel.parameters[0].entity).filter(|&other| same_fields(other));
    std::iter::once(entity).chain(refining).collect()
}

fn implementation(definition: &Definition, kernel: &Kernel, operator: Operator, a: usize, b: usize) -> TokenStream {
    let (operator_trait, method) = trait_of(operator);
    let convert = |name: Ident, actual: usize, expected: usize| {
        if actual == expected { quote!(#name) } else { quote!(#name.into()) }
    };
    let left = convert(format_ident!("self"), a, kernel.parameters[0].entity);
    let right = convert(format_ident!("other"), b, kernel.parameters[1].entity);
    let types = [a, b, kernel.output].map(|entity| entity_type(&definition.entities[entity]));
    let [a, b, output] = types;
    let name = ident(&kernel.name);
    let mut result = quote!(kernels::#name(#left, #right));
    if kernel.packed.is_some() {
        let packed = ident(&kernel.packed_name());
        result = quote! {
            if T::Four::IS_FAST { kernels::#packed(#left, #right) } else { #result }
        };
    }
    quote! {
        impl<T: Scalar> core::ops::#operator_trait<#b> for #a {
            type Output = #output;
            #[inline]
            fn #method(self, other: #b) -> #output {
                #result
            }
        }
    }
}

fn trait_of(operator: Operator) -> (Ident, Ident) {
    let (name, method) = match operator {
        Operator::Add => ("Add", "add"),
        Operator::Sub => ("Sub", "sub"),
        Operator::Geometric => ("Mul", "mul"),
        Operator::Outer => ("BitXor", "bitxor"),
        Operator::Regressive => ("BitAnd", "bitand"),
        Operator::Inner => ("BitOr", "bitor"),
        Operator::Sandwich => ("Shr", "shr"),
    };
    (ident(name), ident(method))
}
