//! Procedural macros over [`ga_codegen`]: parse, call, turn errors into compile errors. All the work, and its
//! documentation, is in that crate.

use proc_macro::TokenStream;

/// Expands a definition block into entities and proved kernels. The grammar and the meaning of a block are
/// those of `ga_codegen::expand`.
#[proc_macro]
pub fn algebra(input: TokenStream) -> TokenStream {
    match ga_codegen::expand(input.into()) {
        Ok(tokens) => tokens.into(),
        Err(error) => error.to_compile_error().into(),
    }
}
