//! From kernels to proved programs: specify, factor or replay a recipe, prove.

use crate::approximation::Precision;
use crate::errors::{Errors, check_effort};
use crate::factor::{self, FactorError, factor};
use crate::kernel::{self, Definition, Hoist, Kernel, Specification, SpecificationError, split};
use crate::limits::{MAX_OPERATIONS, MAX_STEPS, STEPS_OF_AN_OPERATION};
use crate::program::{Bound, CostModel, Count, PackedProgram, PackedRecipe, Program, Recipe};
use crate::proof::{Proof, Refutation, prove};
use crate::symbolic::effort;
use proc_macro2::Span;

/// Which part of a kernel a program is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Part {
    /// All of it.
    Whole,
    /// What its uniform inputs determine, as a record.
    Prepare,
    /// The rest: from the record and the varying inputs to the output.
    Apply,
}

/// A kernel with its meaning, its program and the proof that they are the same.
#[derive(Clone, Debug)]
pub struct Compiled {
    /// The kernel, as an index into [`Definition::kernels`].
    pub kernel: usize,
    /// The part of the kernel.
    pub part: Part,
    /// What the program is to be cheap in.
    pub model: CostModel,
    /// The precision of the polynomials in place of functions, where they are.
    pub precision: Option<Precision>,
    /// The name of the emitted function.
    pub name: String,
    /// What it means.
    pub specification: Specification,
    /// What is emitted, or what the packed program unpacks to.
    pub program: Program,
    /// The program on values of four lanes that is emitted, where it is one.
    pub packed: Option<PackedProgram>,
    /// What has been proved.
    pub proof: Proof,
    /// How far its results can be from exact ones; `None` for an analytic kernel.
    pub bound: Option<Bound>,
    /// Multiplications and additions of the definition expanded, nothing shared; `None` for an analytic kernel.
    pub expanded: Option<Count>,
}

impl Compiled {
    /// The names of the program's parameters, the record between the parts behind those of the kernel.
    pub fn parameter_names<'a>(&self, definition: &'a Definition) -> Vec<&'a str> {
        let own = definition.kernels[self.kernel].parameters.iter().map(|parameter| parameter.name.as_str());
        own.chain([Hoist::RECORD]).collect()
    }

    /// The bound for inputs that keep what their types promise.
    pub fn promised_bound(&self, definition: &Definition) -> Option<Bound> {
        let parameters = definition.kernels[self.kernel].parameters.iter();
        let inputs: Vec<_> = parameters.map(|parameter| &definition.entities[parameter.entity]).collect();
        Some(self.bound.as_ref()?.promised(&inputs, definition.basis.signature()))
    }
}

/// Specifies, factors and proves every kernel of a definition, in its order, once for each of its cost models.
///
/// # Errors
/// The kernels without meaning, closed form or proof, combined.
pub fn compile(definition: &Definition) -> syn::Result<Vec<Compiled>> {
    effort::limited(MAX_STEPS, || compile_kernels(definition))
}

fn compile_kernels(definition: &Definition) -> syn::Result<Vec<Compiled>> {
    let mut errors = Errors::default();
    let mut compiled = Vec::new();
    for index in 0..definition.kernels.len() {
        let found = compile_kernel(definition, index);
        check_effort(definition.kernels[index].expression.span)?;
        match found {
            Ok(variants) => compiled.extend(variants),
            Err(error) => errors.absorb(error),
        }
    }
    errors.into_result(compiled)
}

/// A program that is to be found: a kernel or a part of one, what it means and what it is to be cheap in.
#[derive(Clone, Debug)]
pub struct Task {
    /// The part of the kernel.
    pub part: Part,
    /// What the program is to be cheap in.
    pub model: CostModel,
    /// The precision of the polynomials that are to be in place of functions.
    pub precision: Option<Precision>,
    /// Whether it is to be one on values of four lanes.
    pub packed: bool,
    /// The name of the emitted function.
    pub name: String,
    /// The name under which a recipe for it is kept.
    pub recipe: String,
    /// What it means.
    pub specification: Specification,
}

/// The programs that a kernel asks for: one for each of its cost models, the packed one, and its parts.
///
/// # Errors
/// A kernel without meaning, or one that cannot be split as it asks.
pub fn tasks(definition: &Definition, kernel: &Kernel) -> syn::Result<Vec<Task>> {
    let specification = specify(definition, kernel)?;
    let mut tasks = Vec::new();
    for (place, &model) in kernel.models.iter().enumerate() {
        let name = if place == 0 { kernel.name.clone() } else { format!("{}_{model}", kernel.name) };
        let (recipe, specification) = (kernel.name.clone(), specification.clone());
        tasks.push(Task { part: Part::Whole, model, precision: None, packed: false, name, recipe, specification });
    }
    if kernel.packed.is_some() {
        let (name, recipe, specification) = (kernel.packed_name(), kernel.name.clone(), specification.clone());
        let (part, model) = (Part::Whole, kernel.models[0]);
        tasks.push(Task { part, model, precision: None, packed: true, name, recipe, specification });
    }
    for &precision in &kernel.polynomial {
        let name = format!("{}_{}", kernel.name, precision.name());
        let (recipe, specification, model) = (name.clone(), specification.clone(), kernel.models[0]);
        tasks.push(Task {
            part: Part::Whole,
            model,
            precision: Some(precision),
            packed: false,
            name,
            recipe,
            specification,
        });
    }
    if let Some(hoist) = &kernel.hoist {
        let (prepare, apply) = split(kernel, &specification)
            .map_err(|found| syn::Error::new(hoist.span, format!("kernel `{}`: {found}", kernel.name)))?;
        let model = kernel.models[0];
        for (part, name, specification) in
            [(Part::Prepare, &hoist.prepare, prepare), (Part::Apply, &hoist.apply, apply)]
        {
            let (name, recipe) = (name.clone(), name.clone());
            tasks.push(Task { part, model, precision: None, packed: false, name, recipe, specification });
        }
    }
    Ok(tasks)
}

fn compile_kernel(definition: &Definition, index: usize) -> syn::Result<Vec<Compiled>> {
    let kernel = &definition.kernels[index];
    tasks(definition, kernel)?.into_iter().map(|task| compile_task(definition, index, task)).collect()
}

fn compile_task(definition: &Definition, index: usize, task: Task) -> syn::Result<Compiled> {
    let kernel = &definition.kernels[index];
    let Task { part, model, precision, packed, name, recipe, specification } = task;
    let expanded = factor::expanded_count(&specification).map_err(|found| at(kernel, found.to_string()))?;
    let found = match (precision, definition.recipe(&recipe, model)) {
        _ if packed => Found::Packed(packed_recipe(definition, kernel)?),
        (Some(precision), _) => Found::Factored(factor::factor_by_polynomials(&specification, precision)),
        (None, Some(recipe)) => Found::Recipe(recipe),
        (None, None) => Found::Factored(factor(&specification, model)),
    };
    let Proved { program, packed, proof } = proved_program(kernel, &specification, found)?;
    if program.operations.len() > MAX_OPERATIONS {
        let message = format!("kernel `{}`: expected at most {MAX_OPERATIONS} operations, found more", kernel.name);
        return Err(syn::Error::new(kernel.expression.span, message));
    }
    effort::spend(program.operations.len() * STEPS_OF_AN_OPERATION);
    check_effort(kernel.expression.span)?;
    if let Some(number) = program.unnameable_number() {
        let message = format!("expected numbers whose numerator and denominator fit an i32, found {number}");
        return Err(at(kernel, message));
    }
    let bound = Bound::new(&specification, &program);
    Ok(Compiled { kernel: index, part, model, precision, name, specification, program, packed, proof, bound, expanded })
}

/// The meaning of a kernel, errors at the output type where that is to blame.
fn specify(definition: &Definition, kernel: &Kernel) -> syn::Result<Specification> {
    let specification = Specification::new(definition, kernel).map_err(|found| {
        let span = match &found {
            SpecificationError::CannotHold(..)
            | SpecificationError::WrongConstant(..)
            | SpecificationError::BrokenPromise(..) => kernel.output_span,
            SpecificationError::NotABivector(..)
            | SpecificationError::NotAUnit(..)
            | SpecificationError::NotAStudyNumber(..)
            | SpecificationError::IndefiniteNorm(..)
            | SpecificationError::CompoundCoefficient(..) => kernel.expression.span,
            _ => kernel.span,
        };
        syn::Error::new(span, format!("kernel `{}`: {found}", kernel.name))
    })?;
    kernel::check_kernel(definition, kernel, &specification).map_err(|found| at(kernel, found.to_string()))?;
    Ok(specification)
}

/// The recipe of a packed kernel: packing is left to a search, so there must be one.
fn packed_recipe<'a>(definition: &'a Definition, kernel: &Kernel) -> syn::Result<&'a PackedRecipe> {
    definition.packed_recipe(&kernel.name).ok_or_else(|| {
        let message = format!(
            "expected a recipe `recipe {name} packed {{ ... }}` for a `packed` kernel, found none: `ga-codegen search \
             DEFINITION --kernel {name}` finds one for a product",
            name = kernel.name
        );
        syn::Error::new(kernel.packed.unwrap_or(kernel.span), message)
    })
}

/// Where a program comes from.
enum Found<'a> {
    Recipe(&'a Recipe),
    Packed(&'a PackedRecipe),
    Factored(Result<Program, FactorError>),
}

/// A program with its proof, and the packed one that it was unpacked from.
struct Proved {
    program: Program,
    packed: Option<PackedProgram>,
    proof: Proof,
}

/// The program of the recipe or the one that was found at once; proved either way.
fn proved_program(kernel: &Kernel, specification: &Specification, found: Found<'_>) -> syn::Result<Proved> {
    let factored = match found {
        Found::Factored(factored) => factored,
        Found::Recipe(recipe) => {
            let replayed = factor::replay(specification, recipe);
            return replayed_program(kernel, specification, (&recipe.kernel, recipe.span), replayed, None);
        }
        Found::Packed(recipe) => {
            let replayed = factor::replay_packed(specification, recipe);
            let unpacked = replayed.as_ref().map(PackedProgram::unpack).map_err(String::clone);
            return replayed_program(kernel, specification, (&recipe.kernel, recipe.span), unpacked, replayed.ok());
        }
    };
    let program = factored.map_err(|found| at(kernel, found.to_string()))?;
    let proof = prove(specification, &program).map_err(|refutation| match refutation {
        Refutation::CannotHold(_) => {
            syn::Error::new(kernel.output_span, format!("kernel `{}`: {refutation}", kernel.name))
        }
        _ => at(kernel, format!("expected a proof, found a refutation: {refutation}")),
    })?;
    Ok(Proved { program, packed: None, proof })
}

fn replayed_program(
    kernel: &Kernel,
    specification: &Specification,
    (name, span): (&str, Span),
    replayed: Result<Program, String>,
    packed: Option<PackedProgram>,
) -> syn::Result<Proved> {
    let proved = replayed.and_then(|program| {
        let proof = prove(specification, &program).map_err(|refutation| refutation.to_string())?;
        Ok(Proved { program, packed, proof })
    });
    proved.map_err(|reason| {
        let owner = &kernel.name;
        let message = format!(
            "expected a recipe that fits `{name}`, found that {reason}: remove it and renew it with `ga-codegen search \
             DEFINITION --kernel {owner}`"
        );
        syn::Error::new(span, message)
    })
}

fn at(kernel: &Kernel, message: String) -> syn::Error {
    syn::Error::new(kernel.span, format!("kernel `{}`: {message}", kernel.name))
}
