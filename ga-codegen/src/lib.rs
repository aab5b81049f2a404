//! Library.
pub mod algebra;
pub mod reference;
/// x
#[allow(missing_docs)]
pub fn expand(i: proc_macro2::TokenStream) -> syn::Result<proc_macro2::TokenStream> { Ok(i) }
