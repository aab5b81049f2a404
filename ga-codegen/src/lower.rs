//! From syntax to a [`Definition`]: every name is resolved, every arity and relation checked. Errors are collected, so
//! that several are reported at once.

mod expression;
mod recipe;

use crate::algebra::{Basis, Signature};
use crate::approximation::Precision;
use crate::errors::{Errors, check_effort};
use crate::kernel::{Analytic, Component, ComponentValue, Definition, Entity, Hoist, Kernel, Parameter, Statement};
use crate::limits::MAX_STEPS;
use crate::program::{CostModel, PackedRecipe, Recipe};
use crate::symbolic::{Rational, Relation, Relations, RelationsError, Symbol, effort};
use crate::syntax::{Item, Name, RawComponent, RawKernel, RawParameter, RawRelation};
use expression::Scope;
use proc_macro2::{Span, TokenStream};
use std::collections::BTreeMap;

/// Names that emitted code has for something else: the traits that it implements or asks for, the types of coefficients,
/// its modules.
const RESERVED: [&str; 12] =
    [Entity::SCALAR, "Real", "Four", "T", "U", "From", "Default", "FnMut", "kernels", "scalar", "f32", "f64"];

/// Resolves the items of a block.
///
/// # Errors
/// Everything that is wrong with names, arities and relations, combined.
pub(crate) fn lower(items: &[Item]) -> syn::Result<Definition> {
    effort::limited(MAX_STEPS, || lower_items(items))
}

fn lower_items(items: &[Item]) -> syn::Result<Definition> {
    let basis = lower_basis(items)?;
    let mut errors = Errors::default();
    let mut definition = Definition {
        basis,
        entities: vec![Entity::scalar()],
        kernels: Vec::new(),
        recipes: Vec::new(),
        packed_recipes: Vec::new(),
        scalar_path: None,
        export: None,
    };
    for item in items {
        match item {
            Item::Entity { docs, name, components, relations } => {
                if RESERVED.contains(&name.text.as_str()) {
                    let message =
                        format!("expected an entity whose name emitted code does not use, found `{}`", name.text);
                    errors.push(name.span, message);
                } else if definition.entity(&name.text).is_some() {
                    errors
                        .push(name.span, format!("expected entities with distinct names, found `{}` twice", name.text));
                }
                let entity = lower_entity(&definition.basis, docs, name, components, relations, &mut errors);
                check_effort(name.span)?;
                definition.entities.push(entity);
            }
            Item::Scalar { path } => definition.scalar_path = Some(path.clone()),
            Item::Export { name } => definition.export = Some(name.text.clone()),
            Item::Signature { .. } | Item::Basis { .. } | Item::Kernel(_) => {}
            Item::Recipe { .. } | Item::PackedRecipe(_) => {}
        }
    }
    let kernels = items.iter().filter_map(|item| if let Item::Kernel(kernel) = item { Some(kernel) } else { None });
    for raw in kernels {
        if definition.kernel(&raw.name.text).is_some() {
            let message = format!("expected kernels with distinct names, found `{}` twice", raw.name.text);
            errors.push(raw.name.span, message);
        }
        if let Some(kernel) = lower_kernel(&definition, raw, &mut errors) {
            definition.kernels.push(kernel);
        }
        check_effort(raw.name.span)?;
    }
    check_parts(&definition, &mut errors);
    for item in items {
        match item {
            Item::Recipe { kernel, model, rows } => match recipe::recipe(kernel, model, rows) {
                Ok(recipe) => check_recipe(&mut definition, recipe, &mut errors),
                Err(error) => errors.absorb(error),
            },
            Item::PackedRecipe(recipe) => check_packed_recipe(&mut definition, recipe, &mut errors),
            _ => {}
        }
    }
    errors.into_result(definition)
}

/// Checks that what kernels are split into has names of its own.
fn check_parts(definition: &Definition, errors: &mut Errors) {
    let mut functions: Vec<String> = definition.kernels.iter().map(|kernel| kernel.name.clone()).collect();
    let mut types: Vec<String> = definition.entities.iter().map(|entity| entity.name.clone()).collect();
    types.extend(RESERVED.map(str::to_owned));
    for kernel in &definition.kernels {
        let precisions = kernel.polynomial.iter().map(|precision| precision.name());
        let models = kernel.models.iter().skip(1).map(|model| model.name());
        let packed = kernel.packed.map(|_| "packed");
        let variants = models.chain(packed).chain(precisions).map(|suffix| format!("{}_{suffix}", kernel.name));
        let mut wanted: Vec<_> = variants.map(|name| (name, false, kernel.span)).collect();
        if let Some(hoist) = &kernel.hoist {
            let names = [(&hoist.record, true), (&hoist.prepare, false), (&hoist.apply, false)];
            wanted.extend(names.map(|(name, is_type)| (name.clone(), is_type, hoist.span)));
            if kernel.parameters.iter().any(|parameter| parameter.name == Hoist::RECORD) {
                let message = format!("expected no parameter named `{}` beside `hoist`, found one", Hoist::RECORD);
                errors.push(hoist.span, message);
            }
        }
        for (name, is_type, span) in wanted {
            let taken = if is_type { &mut types } else { &mut functions };
            if taken.contains(&name) {
                errors.push(span, format!("expected names that are not taken, found `{name}`, which is"));
            }
            taken.push(name);
        }
    }
}

/// Reads a recipe on its own.
pub(crate) fn read_recipe(text: &str) -> syn::Result<Recipe> {
    let tokens: TokenStream = text.parse()?;
    match crate::syntax::parse(tokens)?.as_slice() {
        [Item::Recipe { kernel, model, rows }] => recipe::recipe(kernel, model, rows),
        _ => Err(syn::Error::new(Span::call_site(), "expected one recipe")),
    }
}

/// Resolves an expression on its own, of these parameters and blades in any order; with the analytic function of it that
/// is meant, if any.
///
/// # Errors
/// Names that stand for nothing, arguments that do not fit, an analytic function inside an expression.
#[cfg(feature = "check")]
pub(crate) fn lower_expression(
    raw: &crate::syntax::RawExpression,
    basis: &Basis,
    names: &[String],
) -> syn::Result<(Option<Analytic>, crate::kernel::Expression)> {
    let parameters: Vec<_> = names.iter().map(|name| Parameter { name: name.clone(), entity: 0 }).collect();
    Scope { basis, parameters: &parameters, any_order: true }.body(raw)
}

/// Takes a recipe for a program that the definition asks for, once.
fn check_recipe(definition: &mut Definition, recipe: Recipe, errors: &mut Errors) {
    let (name, model) = (&recipe.kernel, recipe.model);
    let wanted = definition.kernels.iter().any(|kernel| kernel.has_program(name, model));
    let twice = definition.recipes.iter().any(|other| other.kernel == *name && other.model == model);
    if !wanted {
        errors.push(recipe.span, format!("expected a kernel with the cost model {model}, found none named `{name}`"));
    } else if twice {
        errors.push(recipe.span, format!("expected one recipe for `{name}` and {model}, found a second"));
    } else {
        definition.recipes.push(recipe);
    }
}

fn check_packed_recipe(definition: &mut Definition, recipe: &PackedRecipe, errors: &mut Errors) {
    let name = &recipe.kernel;
    if definition.kernel(name).is_none_or(|kernel| kernel.packed.is_none()) {
        errors.push(recipe.span, format!("expected a recipe for a `packed` kernel, found none named `{name}`"));
    } else if definition.packed_recipe(name).is_some() {
        errors.push(recipe.span, format!("expected one packed recipe for `{name}`, found a second"));
    } else {
        definition.packed_recipes.push(recipe.clone());
    }
}

fn lower_basis(items: &[Item]) -> syn::Result<Basis> {
    let mut errors = Errors::default();
    let (mut signature, mut blades) = (None, None);
    for item in items {
        match item {
            Item::Signature { span, .. } if signature.is_some() => {
                errors.push(*span, "expected one signature, found a second");
            }
            Item::Signature { span, numbers: [p, q, r] } => signature = Some((*span, Signature::new(*p, *q, *r))),
            Item::Basis { span, .. } if blades.is_some() => errors.push(*span, "expected one basis, found a second"),
            Item::Basis { span, blades: found } => blades = Some((*span, found)),
            _ => {}
        }
    }
    let Some((signature_span, signature)) = signature else {
        errors.push(Span::call_site(), "expected a signature such as `signature (3, 0, 1);`, found none");
        return errors.into_result(()).and(Err(syn::Error::new(Span::call_site(), "expected a signature")));
    };
    errors.into_result(())?;
    let Some((basis_span, blades)) = blades else {
        return Basis::canonical(signature).map_err(|error| syn::Error::new(signature_span, error));
    };
    let words = blades.iter().map(|(name, word)| (name.text.clone(), &word.text));
    Basis::new(signature, words).map_err(|error| {
        let span = match error.index {
            Some(index) => blades[index].1.span,
            None if signature.dimension() > Signature::MAX_DIMENSION => signature_span,
            None => basis_span,
        };
        syn::Error::new(span, error)
    })
}

fn lower_entity(
    basis: &Basis,
    docs: &[String],
    name: &Name,
    raw: &[RawComponent],
    relations: &[RawRelation],
    errors: &mut Errors,
) -> Entity {
    let mut components: Vec<Component> = Vec::new();
    for component in raw {
        let Some(named) = basis.find(&component.blade.text) else {
            let blades: Vec<_> = basis.blades().iter().map(|named| named.name.as_str()).collect();
            let (found, known) = (&component.blade.text, blades.join(" "));
            errors.push(component.blade.span, format!("expected a blade of the basis ({known}), found `{found}`"));
            continue;
        };
        if components.iter().any(|other| other.blade == named.blade) {
            let message = format!("expected every blade once in `{}`, found `{}` twice", name.text, named.name);
            errors.push(component.blade.span, message);
            continue;
        }
        let value = match (&component.field, component.constant) {
            (Some(field), _) => ComponentValue::Field(field.text.clone()),
            (None, constant) => ComponentValue::Constant(Rational::integer(constant.unwrap_or(0))),
        };
        let duplicate =
            components.iter().any(|other| matches!(value, ComponentValue::Field(_)) && other.value == value);
        if let (true, Some(field)) = (duplicate, &component.field) {
            let message =
                format!("expected fields with distinct names in `{}`, found `{}` twice", name.text, field.text);
            errors.push(field.span, message);
        }
        components.push(Component { value, name: named.name.clone(), blade: named.blade, sign: named.sign });
    }
    let mut entity =
        Entity { name: name.text.clone(), docs: docs.to_vec(), components, statements: Vec::new(), span: name.span };
    if entity.fields().next().is_none() && entity.components.len() == raw.len() {
        errors.push(name.span, format!("expected at least one field in `{}`, found none", name.text));
    }
    let fields = entity.fields().enumerate().map(|(i, (field, _))| (field.to_owned(), i as Symbol)).collect();
    entity.statements = lower_relations(relations, &fields, errors);
    check_relations(&entity.statements, &entity.statements, &fields, errors);
    entity
}

/// Relations over named symbols.
fn lower_relations(raw: &[RawRelation], symbols: &BTreeMap<String, Symbol>, errors: &mut Errors) -> Vec<Statement> {
    let mut statements = Vec::new();
    for relation in raw {
        match expression::relation(relation, symbols) {
            Ok((relation, text, span)) => statements.push(Statement { relation, text, span }),
            Err(error) => errors.absorb(error),
        }
    }
    statements
}

/// Checks that relations have normal forms; the last of the offending ones that is in `own` is reported.
fn check_relations(all: &[Statement], own: &[Statement], symbols: &BTreeMap<String, Symbol>, errors: &mut Errors) {
    let relations: Vec<Relation> = all.iter().map(|statement| statement.relation.clone()).collect();
    let Err(error) = Relations::new(&relations) else { return };
    let mut names = vec![String::new(); symbols.len()];
    for (name, &symbol) in symbols {
        names[usize::from(symbol)].clone_from(name);
    }
    let (index, message) = match error {
        RelationsError::NotTerminating(index) => {
            let message = "expected a relation whose first monomial is the greatest in some lexicographic order that \
                 suits all relations, found none: write another monomial first";
            (index, message.to_owned())
        }
        RelationsError::NotConfluent(first, second, remainder) if remainder.as_constant().is_some() => {
            let (first, remainder) = (&all[first].text, remainder.display(&names));
            let message = format!(
                "expected relations that can hold together, found that this one and `{first}` contradict each other: \
                 with both of them, {remainder} is 0"
            );
            (second, message)
        }
        RelationsError::NotConfluent(first, second, remainder) => {
            let (first, remainder) = (&all[first].text, remainder.display(&names));
            let message = format!(
                "expected relations with unique normal forms, found that this one and `{first}` leave {remainder} \
                 undecided: write another monomial first, or state that it is 0"
            );
            (second, message)
        }
        RelationsError::Overflow => (all.len() - 1, crate::symbolic::Overflow.to_string()),
    };
    let statement = all.get(index).filter(|s| own.iter().any(|other| other.text == s.text)).or(own.last());
    if let Some(statement) = statement {
        errors.push(statement.span, message);
    }
}

fn find_entity(definition: &Definition, name: &Name, errors: &mut Errors) -> Option<usize> {
    let found = definition.entities.iter().position(|entity| entity.name == name.text);
    if found.is_none() {
        let known: Vec<_> = definition.entities.iter().map(|entity| entity.name.as_str()).collect();
        errors.push(name.span, format!("expected an entity ({}), found `{}`", known.join(", "), name.text));
    }
    found
}

fn lower_kernel(definition: &Definition, raw: &RawKernel, errors: &mut Errors) -> Option<Kernel> {
    let mut parameters: Vec<Parameter> = Vec::new();
    let mut complete = true;
    for RawParameter { name, entity, .. } in &raw.parameters {
        if parameters.iter().any(|parameter| parameter.name == name.text) {
            errors.push(name.span, format!("expected parameters with distinct names, found `{}` twice", name.text));
        }
        if definition.basis.find(&name.text).is_some() {
            errors
                .push(name.span, format!("expected a parameter that is not named like a blade, found `{}`", name.text));
        }
        match find_entity(definition, entity, errors) {
            Some(entity) => parameters.push(Parameter { name: name.text.clone(), entity }),
            None => complete = false,
        }
    }
    let output = find_entity(definition, &raw.output, errors);
    if !complete {
        return None;
    }
    let scope = Scope { basis: &definition.basis, parameters: &parameters, any_order: false };
    let (analytic, expression) = match scope.kernel_body(&raw.expression) {
        Ok(body) => body,
        Err(error) => {
            errors.absorb(error);
            return None;
        }
    };
    let statements = lower_kernel_relations(definition, &parameters, &raw.relations, errors);
    let mut models = Vec::new();
    for name in &raw.models {
        match recipe::cost_model(name) {
            Ok(model) if models.contains(&model) => {
                errors.push(name.span, format!("expected distinct cost models, found `{model}` twice"));
            }
            Ok(model) => models.push(model),
            Err(error) => errors.absorb(error),
        }
    }
    if models.is_empty() {
        models.push(CostModel::default());
    }
    let plain = output.is_some_and(|output| definition.entities[output].is_scalar());
    if let Some(span) = raw.packed.filter(|_| analytic.is_some() || plain) {
        errors.push(span, "expected `packed` at a polynomial definition of a type with fields, found another kernel");
    }
    let polynomial = lower_precisions(raw, analytic, errors);
    let uniform: Vec<bool> = raw.parameters.iter().map(|parameter| parameter.uniform).collect();
    let hoist = lower_hoist(raw, analytic.is_some(), errors);
    Some(Kernel {
        name: raw.name.text.clone(),
        docs: raw.docs.clone(),
        parameters,
        output: output?,
        analytic,
        expression,
        statements,
        models,
        packed: raw.packed,
        polynomial,
        uniform,
        hoist,
        span: raw.name.span,
        output_span: raw.output.span,
    })
}

/// The precisions for which a kernel asks for polynomials.
fn lower_precisions(raw: &RawKernel, analytic: Option<Analytic>, errors: &mut Errors) -> Vec<Precision> {
    let mut precisions = Vec::new();
    for name in &raw.polynomial {
        let found = Precision::ALL.into_iter().find(|precision| precision.name() == name.text);
        match found {
            Some(_) if !matches!(analytic, Some(Analytic::Exp | Analytic::Log)) => {
                errors.push(name.span, "expected `polynomial` at a definition by `exp` or `log`, found another kernel");
            }
            Some(precision) if precisions.contains(&precision) => {
                errors.push(name.span, format!("expected distinct precisions, found `{}` twice", name.text));
            }
            Some(precision) => precisions.push(precision),
            None => errors.push(name.span, format!("expected `f32` or `f64`, found `{}`", name.text)),
        }
    }
    precisions
}

/// The names of a kernel's parts; `uniform` and `hoist` go together.
fn lower_hoist(raw: &RawKernel, analytic: bool, errors: &mut Errors) -> Option<Hoist> {
    let marked = raw.parameters.iter().filter(|parameter| parameter.uniform).count();
    let Some([record, prepare, apply]) = &raw.hoist else {
        if let Some(parameter) = raw.parameters.iter().find(|parameter| parameter.uniform) {
            let message = "expected `hoist STRUCT, PREPARE, APPLY` after the definition of a kernel with a `uniform` \
                 parameter, found none";
            errors.push(parameter.name.span, message);
        }
        return None;
    };
    if marked == 0 || marked == raw.parameters.len() || analytic {
        let message =
            "expected `hoist` at a polynomial kernel with `uniform` and other parameters, found another kernel";
        errors.push(record.span, message);
        return None;
    }
    let [record_name, prepare, apply] = [record, prepare, apply].map(|name| name.text.clone());
    Some(Hoist { record: record_name, prepare, apply, span: record.span })
}

fn lower_kernel_relations(
    definition: &Definition,
    parameters: &[Parameter],
    raw: &[RawRelation],
    errors: &mut Errors,
) -> Vec<Statement> {
    if raw.is_empty() {
        return Vec::new();
    }
    let (mut symbols, mut all) = (BTreeMap::new(), Vec::new());
    for parameter in parameters {
        let entity = &definition.entities[parameter.entity];
        let first = symbols.len() as Symbol;
        for (index, (field, _)) in entity.fields().enumerate() {
            let name = if field.is_empty() { parameter.name.clone() } else { format!("{}.{field}", parameter.name) };
            symbols.insert(name, first + index as Symbol);
        }
        let shifted = |s: &Statement| Statement { relation: s.relation.shifted(first), ..s.clone() };
        all.extend(entity.statements.iter().map(shifted));
    }
    let own = lower_relations(raw, &symbols, errors);
    all.extend(own.iter().cloned());
    check_relations(&all, &own, &symbols, errors);
    own
}
