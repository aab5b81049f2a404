//! Where definitions come from, and how their errors are shown.

use ga_codegen::kernel::Definition;
use ga_codegen::{Compiled, compile, define, preset};
use proc_macro2::TokenStream;
use std::io::{ErrorKind, Write};

/// A definition, its kernels compiled, and the name and text it was read from.
pub(crate) struct Source {
    pub(crate) definition: Definition,
    pub(crate) compiled: Vec<Compiled>,
}

/// The definition of a preset or a file.
pub(crate) fn definition(source: &str) -> Result<Definition, String> {
    let text = match preset::text(source) {
        Some(text) => text.to_owned(),
        None => std::fs::read_to_string(source).map_err(|error| {
            let presets = preset::NAMES.join(", ");
            format!("error: expected a preset ({presets}) or a readable file, found `{source}`: {error}")
        })?,
    };
    let tokens: TokenStream = text.parse().map_err(|error: proc_macro2::LexError| {
        let start = error.span().start();
        format!("error: {error}\n  --> {source}:{}:{}", start.line, start.column + 1)
    })?;
    define(tokens).map_err(|errors| describe(source, &errors))
}

/// A definition with its kernels specified, factored and proved.
pub(crate) fn compiled(source: &str) -> Result<Source, String> {
    let definition = definition(source)?;
    let compiled = compile(&definition).map_err(|errors| describe(source, &errors))?;
    Ok(Source { definition, compiled })
}

/// Every error with file, line and column.
pub(crate) fn describe(source: &str, errors: &syn::Error) -> String {
    let one = |error: syn::Error| {
        let start = error.span().start();
        format!("error: {error}\n  --> {source}:{}:{}", start.line, start.column + 1)
    };
    errors.clone().into_iter().map(one).collect::<Vec<_>>().join("\n")
}

/// Prints to standard output, in colour where that is a terminal; a reader that has gone away is no error.
pub(crate) fn print(text: &str) -> Result<(), String> {
    match anstream::stdout().write_all(text.as_bytes()) {
        Err(error) if error.kind() != ErrorKind::BrokenPipe => Err(format!("error: standard output: {error}")),
        _ => Ok(()),
    }
}
