//! Structs from entities, with what follows from their components and relations alone.

use super::body::{Style, body};
use super::{doc, ident};
use crate::algebra::{Blade, Signature};
use crate::factor::factor_polynomials;
use crate::kernel::{ComponentValue, Entity};
use crate::program::Program;
use crate::symbolic::{Polynomial, Rational, Relations, Symbol};
use proc_macro2::{Ident, Literal, TokenStream};
use quote::quote;
use std::collections::BTreeMap;

/// The struct of an entity and its implementations.
pub(super) fn entity(entity: &Entity, signature: Signature) -> syn::Result<TokenStream> {
    let relation_errors = relation_errors(entity)?;
    let parts = [
        structure(entity),
        construction(entity),
        labels(entity, signature),
        arrays(entity),
        display(entity),
        linear(entity),
        negation(entity),
    ];
    let identity = identity(entity);
    Ok(quote! { #(#parts)* #identity #relation_errors })
}

fn fields(entity: &Entity) -> Vec<Ident> {
    entity.fields().map(|(field, _)| ident(field)).collect()
}

fn structure(entity: &Entity) -> TokenStream {
    let mut lines = entity.docs.clone();
    if lines.is_empty() {
        let blades: Vec<_> = entity.components.iter().map(|component| format!("`{}`", component.name)).collect();
        lines.push(format!("A multivector of {}.", blades.join(", ")));
    }
    if !entity.statements.is_empty() {
        let texts: Vec<_> = entity.statements.iter().map(|statement| format!("`{}`", statement.text)).collect();
        lines.extend([String::new(), format!("Every value satisfies {}.", texts.join(" and "))]);
    }
    let fixed = entity.components.iter().filter_map(|component| match component.value {
        ComponentValue::Constant(value) => Some(format!("The coefficient of `{}` is {value}.", component.name)),
        ComponentValue::Field(_) => None,
    });
    let fixed: Vec<_> = fixed.collect();
    if !fixed.is_empty() {
        lines.extend([String::new(), fixed.join(" ")]);
    }
    let (name, docs) = (ident(&entity.name), doc(&lines));
    let fields = entity.fields().map(|(field, component)| {
        let (field, text) = (ident(field), format!(" The coefficient of `{}`.", component.name));
        quote!(#[doc = #text] pub #field: T)
    });
    quote! {
        #docs
        #[derive(Clone, Copy, Debug, PartialEq)]
        #[repr(C)]
        pub struct #name<T> {
            #(#fields),*
        }
    }
}

fn construction(entity: &Entity) -> TokenStream {
    let (name, fields) = (ident(&entity.name), fields(entity));
    let promise = if entity.statements.is_empty() {
        String::new()
    } else {
        " The caller keeps the promise of the type; [`Self::satisfies_relations`] checks it.".to_owned()
    };
    let text = format!(" The coefficients in the order of the fields.{promise}");
    let many = (fields.len() > 7).then(|| quote!(#[allow(clippy::too_many_arguments)]));
    quote! {
        impl<T> #name<T> {
            #[doc = #text]
            #[inline]
            #many
            pub const fn new(#(#fields: T),*) -> Self {
                Self { #(#fields),* }
            }

            /// The same with every coefficient mapped, for example to another scalar type.
            #[inline]
            pub fn map<U>(self, mut map: impl FnMut(T) -> U) -> #name<U> {
                #name { #(#fields: map(self.#fields)),* }
            }
        }

        impl<T: Real> #name<T> {
            /// Whether no coefficient is infinite or NaN.
            #[inline]
            pub fn is_finite(self) -> bool {
                #(self.#fields.is_finite())&&*
            }
        }
    }
}

/// What is known of the fields' blades, as plain data for whoever has the struct and not the generator.
fn labels(entity: &Entity, signature: Signature) -> TokenStream {
    let name = ident(&entity.name);
    let blades: Vec<_> = entity.fields().map(|(_, component)| component.blade).collect();
    let count = Literal::usize_unsuffixed(blades.len());
    let degrees = blades.iter().map(|blade| Literal::u32_unsuffixed(blade.null_degree(signature)));
    let labels = blades.iter().map(|blade| match blade.trit_label(signature) {
        Some(label) => {
            let label = Literal::i8_unsuffixed(label);
            quote!(Some(#label))
        }
        None => quote!(None),
    });
    quote! {
        impl<T> #name<T> {
            /// How many generators that square to 0 the blade of each field has, in the order of the fields: the power
            /// of the unit of length in its coefficient. A product of blades that is not 0 has the sum of their
            /// degrees.
            pub const NULL_DEGREES: [u32; #count] = [#(#degrees),*];

            /// The trit of what the blade of each field does in a motion, in the order of the fields: 1 translation, 0
            /// rotation, -1 identity. No grading: products do not keep it.
            pub const TRIT_LABELS: [Option<i8>; #count] = [#(#labels),*];
        }
    }
}

fn arrays(entity: &Entity) -> TokenStream {
    let (name, fields) = (ident(&entity.name), fields(entity));
    let length = Literal::usize_unsuffixed(fields.len());
    quote! {
        impl<T> From<[T; #length]> for #name<T> {
            /// The coefficients in the order of the fields.
            #[inline]
            fn from([#(#fields),*]: [T; #length]) -> Self {
                Self { #(#fields),* }
            }
        }

        impl<T> From<#name<T>> for [T; #length] {
            /// The coefficients in the order of the fields.
            #[inline]
            fn from(value: #name<T>) -> Self {
                [#(value.#fields),*]
            }
        }

        impl<T> #name<T> {
            /// The coefficients in the order of the fields.
            #[inline]
            pub fn to_array(self) -> [T; #length] {
                self.into()
            }
        }
    }
}

/// `0.5 + -2 e12 + 3 e0123`: every component, in order, with its blade.
fn display(entity: &Entity) -> TokenStream {
    let name = ident(&entity.name);
    let mut fields = entity.fields();
    let mut text = String::new();
    let mut arguments = Vec::new();
    for (index, component) in entity.components.iter().enumerate() {
        text += if index == 0 { "" } else { " + " };
        let blade = if component.blade == Blade::SCALAR { "" } else { &format!(" {}", component.name) };
        match &component.value {
            ComponentValue::Constant(value) if *value == Rational::ONE && !blade.is_empty() => {
                text += blade.trim_start()
            }
            ComponentValue::Constant(value) => text += &format!("{value}{blade}"),
            ComponentValue::Field(_) => {
                text += &format!("{{}}{blade}");
                arguments.extend(fields.next().map(|(field, _)| ident(field)));
            }
        }
    }
    let pieces = text.split("{}").map(str::to_owned).collect::<Vec<_>>();
    let last = pieces.last().cloned().unwrap_or_default();
    let before = &pieces[..arguments.len()];
    quote! {
        impl<T: core::fmt::Display> core::fmt::Display for #name<T> {
            /// The terms with their blades; format options such as a precision apply to every coefficient.
            fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
                #(
                    f.write_str(#before)?;
                    core::fmt::Display::fmt(&self.#arguments, f)?;
                )*
                f.write_str(#last)
            }
        }
    }
}

/// Addition and scaling, where the type is a linear space: all coefficients free.
fn linear(entity: &Entity) -> TokenStream {
    if !entity.is_linear() {
        return TokenStream::new();
    }
    let (name, fields) = (ident(&entity.name), fields(entity));
    let left = [quote!(f32), quote!(f64)].map(|float| {
        quote! {
            impl core::ops::Mul<#name<#float>> for #float {
                type Output = #name<#float>;
                #[inline]
                fn mul(self, value: #name<#float>) -> #name<#float> {
                    value * self
                }
            }
        }
    });
    quote! {
        impl<T: Scalar> #name<T> {
            /// All coefficients 0.
            pub const ZERO: Self = Self { #(#fields: T::ZERO),* };
        }

        impl<T: Scalar> core::ops::Add for #name<T> {
            type Output = Self;
            #[inline]
            fn add(self, other: Self) -> Self {
                Self { #(#fields: self.#fields + other.#fields),* }
            }
        }

        impl<T: Scalar> core::ops::Sub for #name<T> {
            type Output = Self;
            #[inline]
            fn sub(self, other: Self) -> Self {
                Self { #(#fields: self.#fields - other.#fields),* }
            }
        }

        impl<T: Scalar> core::ops::Mul<T> for #name<T> {
            type Output = Self;
            #[inline]
            fn mul(self, factor: T) -> Self {
                Self { #(#fields: self.#fields * factor),* }
            }
        }

        impl<T: Real> core::ops::Div<T> for #name<T> {
            type Output = Self;
            #[inline]
            fn div(self, divisor: T) -> Self {
                Self { #(#fields: self.#fields / divisor),* }
            }
        }

        impl<T: Scalar> core::ops::AddAssign for #name<T> {
            #[inline]
            fn add_assign(&mut self, other: Self) {
                *self = *self + other;
            }
        }

        impl<T: Scalar> core::ops::SubAssign for #name<T> {
            #[inline]
            fn sub_assign(&mut self, other: Self) {
                *self = *self - other;
            }
        }

        impl<T: Scalar> core::ops::MulAssign<T> for #name<T> {
            #[inline]
            fn mul_assign(&mut self, factor: T) {
                *self = *self * factor;
            }
        }

        #(#left)*
    }
}

/// Whether fields with these values keep the relations, whatever the symbols in them.
fn keeps_relations(entity: &Entity, values: &[Polynomial]) -> bool {
    let decide = || {
        let relations = Relations::new(&entity.relations()).ok()?;
        let values = entity.relation_values(values).ok()?;
        Some(values.iter().all(|value| relations.normal_form(value).is_ok_and(|form| form.is_zero())))
    };
    decide().unwrap_or(false)
}

/// The negative, where it keeps the promises of the type and no coefficient is fixed.
fn negation(entity: &Entity) -> TokenStream {
    let count = entity.fields().count();
    let negative: Vec<_> = (0..count).map(|symbol| Polynomial::symbol(symbol as Symbol).neg()).collect();
    if count < entity.components.len() || !keeps_relations(entity, &negative) {
        return TokenStream::new();
    }
    let (name, fields) = (ident(&entity.name), fields(entity));
    quote! {
        impl<T: Scalar> core::ops::Neg for #name<T> {
            type Output = Self;
            #[inline]
            fn neg(self) -> Self {
                Self { #(#fields: -self.#fields),* }
            }
        }
    }
}

/// The identity where the type has a scalar part that can be 1 and the rest 0, and the default: 0 where the type holds
/// it, else the identity. Free coefficients of a type with fixed ones default to 0: a point to the origin.
fn identity(entity: &Entity) -> TokenStream {
    let (name, fields) = (ident(&entity.name), fields(entity));
    let zero = vec![Polynomial::zero(); fields.len()];
    let is_scalar = |component: &&crate::kernel::Component| component.blade == Blade::SCALAR;
    let one: Vec<_> = entity
        .fields()
        .map(|(_, c)| if c.blade == Blade::SCALAR { Polynomial::one() } else { Polynomial::zero() })
        .collect();
    let scalar = entity.components.iter().find(is_scalar).is_some_and(|component| match component.value {
        ComponentValue::Field(_) => true,
        ComponentValue::Constant(value) => value == Rational::ONE,
    });
    let others_free = entity
        .components
        .iter()
        .all(|component| component.blade == Blade::SCALAR || matches!(component.value, ComponentValue::Field(_)));
    let has_identity = scalar && others_free && keeps_relations(entity, &one);
    let values = one.iter().map(|value| if value.is_zero() { quote!(T::ZERO) } else { quote!(T::ONE) });
    let identity = has_identity.then(|| {
        quote! {
            impl<T: Scalar> #name<T> {
                /// 1, which changes nothing.
                pub const IDENTITY: Self = Self { #(#fields: #values),* };
            }
        }
    });
    let default = if keeps_relations(entity, &zero) {
        quote!(Self { #(#fields: T::ZERO),* })
    } else if has_identity {
        quote!(Self::IDENTITY)
    } else {
        return quote!(#identity);
    };
    quote! {
        #identity

        impl<T: Scalar> Default for #name<T> {
            #[inline]
            fn default() -> Self {
                #default
            }
        }
    }
}

/// How far the relations of the type are from holding.
fn relation_errors(entity: &Entity) -> syn::Result<TokenStream> {
    if entity.statements.is_empty() {
        return Ok(TokenStream::new());
    }
    let name = ident(&entity.name);
    let relations: Vec<_> = entity.statements.iter().map(|s| s.relation.polynomial().clone()).collect();
    let program = check_evaluates(entity, &relations)?;
    let inputs: Vec<_> = fields(entity).iter().map(|field| quote!(self.#field)).collect();
    let body = body(&program, &inputs, &["self"], &BTreeMap::new(), Style::Plain, entity.span)?;
    let (statements, outputs, count) = (body.statements, body.outputs, Literal::usize_unsuffixed(relations.len()));
    let texts: Vec<_> = entity.statements.iter().map(|s| format!("`{}`", s.text)).collect();
    let text = format!(" Left minus right side of {}.", texts.join(", "));
    Ok(quote! {
        impl<T: Scalar> #name<T> {
            #[doc = #text]
            #[inline]
            pub fn relation_errors(self) -> [T; #count] {
                #statements
                [#(#outputs),*]
            }
        }

        impl<T: Real> #name<T> {
            /// Whether every relation of the type holds to an absolute `tolerance`; false for NaN.
            #[inline]
            pub fn satisfies_relations(self, tolerance: T) -> bool {
                self.relation_errors().iter().all(|error| error.abs() <= tolerance)
            }
        }
    })
}

/// A program for these polynomials in an entity's fields, proved.
fn check_evaluates(entity: &Entity, polynomials: &[Polynomial]) -> syn::Result<Program> {
    let error = |text: String| syn::Error::new(entity.span, text);
    let program = factor_polynomials(polynomials, entity.fields().count()).map_err(|found| error(found.to_string()))?;
    crate::proof::prove_evaluation(&program, polynomials, entity.fields().count())
        .map_err(|refutation| error(format!("expected a proof, found a refutation: {refutation}")))?;
    Ok(program)
}
