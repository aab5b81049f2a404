//! The whole pipeline on one page: parse, lower, specify, factor, prove, emit.

use crate::emit;
use crate::factor::{self, factor};
use crate::kernel::{Definition, Kernel, Specification, SpecificationError};
use crate::lower::{Errors, lower};
use crate::program::{Count, Program};
use crate::proof::{Proof, prove};
use crate::syntax::parse;
use proc_macro2::{Span, TokenStream};

/// A kernel with its meaning, its program and the proof that they are the same.
#[derive(Clone, Debug)]
pub struct Compiled {
    /// What it means.
    pub specification: Specification,
    /// What is emitted.
    pub program: Program,
    /// What has been proved.
    pub proof: Proof,
    /// Multiplications and additions of the definition expanded, nothing shared; `None` for an analytic kernel.
    pub expanded: Option<Count>,
}

/// Expands a definition block into Rust: entities, kernels as functions, operators.
///
/// Nothing unproved is emitted: every program is evaluated back to polynomials or power series and compared with its
/// definition.
///
/// # Errors
/// Everything that is wrong with the block, combined, each error at the token to blame: syntax, names, arities,
/// relations, outputs that cannot hold a result, failed proofs.
pub fn expand(input: TokenStream) -> syn::Result<TokenStream> {
    let definition = define(input)?;
    let compiled = compile(&definition)?;
    emit::rust(&definition, &compiled)
}

/// Parses a definition block and resolves its names.
///
/// # Errors
/// Everything that is wrong with the block up to there, combined.
pub fn define(input: TokenStream) -> syn::Result<Definition> {
    lower(&parse(input)?)
}

/// Specifies, factors and proves every kernel of a definition, in its order.
///
/// # Errors
/// The kernels without meaning, closed form or proof, combined.
pub fn compile(definition: &Definition) -> syn::Result<Vec<Compiled>> {
    let mut errors = Errors::default();
    let mut compiled = Vec::new();
    for kernel in &definition.kernels {
        match compile_kernel(definition, kernel) {
            Ok(one) => compiled.push(one),
            Err(error) => errors.absorb(error),
        }
    }
    errors.into_result(compiled)
}

fn compile_kernel(definition: &Definition, kernel: &Kernel) -> syn::Result<Compiled> {
    let error = |span: Span, message: String| syn::Error::new(span, format!("kernel `{}`: {message}", kernel.name));
    let specification = Specification::new(definition, kernel).map_err(|found| {
        let span = match &found {
            SpecificationError::CannotHold(..)
            | SpecificationError::WrongConstant(..)
            | SpecificationError::BrokenPromise(..) => kernel.output_span,
            _ => kernel.span,
        };
        error(span, found.to_string())
    })?;
    let program = factor(&specification).map_err(|found| error(kernel.span, found.to_string()))?;
    let proof = prove(&specification, &program)
        .map_err(|refutation| error(kernel.span, format!("expected a proof, found a refutation: {refutation}")))?;
    let expanded = factor::expanded_count(&specification).map_err(|found| error(kernel.span, found.to_string()))?;
    Ok(Compiled { specification, program, proof, expanded })
}
