//! What is to be computed: typed entities, expressions in geometric algebra, and kernels, whose [`Specification`] is
//! the exact meaning that a program is proved against.

mod entity;
mod expression;
mod hoist;
mod homogeneity;
mod specification;

pub use entity::{Component, ComponentValue, Entity, Statement};
pub use expression::{Expression, ExpressionKind, Function, Operator};
pub use hoist::{Hoist, Projection, split};
pub use homogeneity::{Inhomogeneous, check_kernel, check_relations};
pub use specification::{Analytic, Coefficient, Specification, SpecificationError, StudyNorm};

use crate::algebra::Basis;
use crate::approximation::Precision;
use crate::program::{CostModel, PackedRecipe, Recipe};
use proc_macro2::{Span, TokenStream};

/// An input of a kernel.
#[derive(Clone, Debug)]
pub struct Parameter {
    /// The name.
    pub name: String,
    /// The entity, as an index into [`Definition::entities`].
    pub entity: usize,
}

/// A typed function with one expression as its meaning.
#[derive(Clone, Debug)]
pub struct Kernel {
    /// The name of the emitted function.
    pub name: String,
    /// Documentation lines.
    pub docs: Vec<String>,
    /// The inputs.
    pub parameters: Vec<Parameter>,
    /// The output entity, as an index into [`Definition::entities`].
    pub output: usize,
    /// The function of [`Kernel::expression`] that the definition is, where it is not polynomial.
    pub analytic: Option<Analytic>,
    /// The definition, or the argument of the analytic function.
    pub expression: Expression,
    /// Relations between the inputs beyond those of their types, over the kernel's symbols.
    pub statements: Vec<Statement>,
    /// Which of the parameters stay the same over many calls.
    pub uniform: Vec<bool>,
    /// The parts that the kernel is split into as well.
    pub hoist: Option<Hoist>,
    /// What its programs are to be cheap in; the first is emitted under the kernel's name, the others under
    /// `NAME_MODEL`.
    pub models: Vec<CostModel>,
    /// Where it asks to be emitted on values of four lanes as well, under `NAME_packed`.
    pub packed: Option<Span>,
    /// The precisions in which it is emitted with polynomials in place of functions as well, under `NAME_PRECISION`.
    pub polynomial: Vec<Precision>,
    /// Where the name stands.
    pub span: Span,
    /// Where the output type stands.
    pub output_span: Span,
}

impl Kernel {
    /// Whether a program of that name and cost model belongs to the kernel: its own, or one of its parts for the first
    /// of its models.
    pub fn has_program(&self, name: &str, model: CostModel) -> bool {
        let part = self.hoist.as_ref().is_some_and(|hoist| hoist.prepare == name || hoist.apply == name);
        (self.name == name && self.models.contains(&model)) || (part && self.models.first() == Some(&model))
    }

    /// The name of its function on values of four lanes.
    pub fn packed_name(&self) -> String {
        format!("{}_packed", self.name)
    }

    /// The definition as it is written.
    pub fn definition(&self) -> String {
        let names: Vec<_> = self.parameters.iter().map(|parameter| parameter.name.as_str()).collect();
        let inner = self.expression.display(&names);
        match self.analytic {
            None => inner,
            Some(analytic) => format!("{}({inner})", analytic.name()),
        }
    }
}

/// A whole definition block with every name resolved.
#[derive(Clone, Debug)]
pub struct Definition {
    /// Signature, names and orientations of the blades.
    pub basis: Basis,
    /// The types. The first is always the built-in `Scalar`.
    pub entities: Vec<Entity>,
    /// The kernels in the order of the block.
    pub kernels: Vec<Kernel>,
    /// Programs that were searched for before.
    pub recipes: Vec<Recipe>,
    /// The same on values of four lanes.
    pub packed_recipes: Vec<PackedRecipe>,
    /// The path of the module that has the traits `Scalar` and `Real`; where there is none they are emitted too.
    pub scalar_path: Option<TokenStream>,
    /// The name under which the list of kernels is exported as a macro.
    pub export: Option<String>,
}

impl Definition {
    /// The kernel of that name.
    pub fn kernel(&self, name: &str) -> Option<&Kernel> {
        self.kernels.iter().find(|kernel| kernel.name == name)
    }

    /// The recipe for a kernel and a cost model.
    pub fn recipe(&self, kernel: &str, model: CostModel) -> Option<&Recipe> {
        self.recipes.iter().find(|recipe| recipe.kernel == kernel && recipe.model == model)
    }

    /// The packed recipe for a kernel.
    pub fn packed_recipe(&self, kernel: &str) -> Option<&PackedRecipe> {
        self.packed_recipes.iter().find(|recipe| recipe.kernel == kernel)
    }

    /// The entity of that name.
    pub fn entity(&self, name: &str) -> Option<&Entity> {
        self.entities.iter().find(|entity| entity.name == name)
    }
}
