//! Errors of a block, combined, and the one of a block that takes too long.

use crate::limits::{MAX_ERRORS, MAX_STEPS};
use crate::symbolic::effort;
use proc_macro2::Span;

/// Errors so far, the first [`MAX_ERRORS`] of them.
#[derive(Default)]
pub(crate) struct Errors {
    combined: Option<syn::Error>,
    count: usize,
}

impl Errors {
    pub(crate) fn push(&mut self, span: Span, message: impl std::fmt::Display) {
        self.absorb(syn::Error::new(span, message));
    }

    pub(crate) fn absorb(&mut self, error: syn::Error) {
        self.count += 1;
        match &mut self.combined {
            Some(_) if self.count > MAX_ERRORS => {}
            Some(errors) => errors.combine(error),
            None => self.combined = Some(error),
        }
    }

    pub(crate) fn into_result<T>(self, value: T) -> syn::Result<T> {
        self.combined.map_or(Ok(value), Err)
    }
}

/// Where a block has turned out to take more steps than it may: an error in place of those that come of it.
pub(crate) fn check_effort(span: Span) -> syn::Result<()> {
    let message = || format!("expected a block that expands in at most {MAX_STEPS} steps, found more up to here");
    if effort::is_exhausted() { Err(syn::Error::new(span, message())) } else { Ok(()) }
}
