//! lib

pub mod algebra;
pub mod factor;
pub mod kernel;
pub mod program;
pub mod proof;
pub mod symbolic;
/// x
pub fn expand(i: proc_macro2::TokenStream) -> syn::Result<proc_macro2::TokenStream> { Ok(i) }
