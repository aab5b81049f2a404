//! Cayley tables.

use super::source;
use clap::ValueEnum;
use ga_codegen::algebra::{Basis, Product, Sign, Signature, table};
use ga_codegen::preset;
use std::path::Path;

/// How a table is printed.
#[derive(Clone, Copy, ValueEnum)]
pub(crate) enum Format {
    /// Aligned columns.
    Text,
    /// A Markdown table.
    Markdown,
    /// Comma-separated values.
    Csv,
}

/// A product by its name.
pub(crate) fn product(name: &str) -> Result<Product, String> {
    let known = Product::ALL.map(Product::name);
    Product::ALL
        .into_iter()
        .find(|product| product.name() == name)
        .ok_or_else(|| format!("expected one of {}", known.join(", ")))
}

/// The table of a product on a basis.
pub(crate) fn run(source: &str, product: Product, format: Format) -> Result<String, String> {
    let basis = basis(source)?;
    let names = basis.blades().iter().map(|named| named.name.clone());
    let mut rows: Vec<Vec<String>> = vec![std::iter::once(String::new()).chain(names.clone()).collect()];
    for (name, row) in names.zip(table(&basis, product)) {
        rows.push(std::iter::once(name).chain(row.into_iter().map(entry)).collect());
    }
    Ok(match format {
        Format::Text => aligned(&rows),
        Format::Markdown => markdown(&rows),
        Format::Csv => rows.iter().map(|row| row.join(",") + "\n").collect(),
    })
}

fn entry(entry: Option<(Sign, &str)>) -> String {
    match entry {
        None => "0".to_owned(),
        Some((Sign::Plus, name)) => name.to_owned(),
        Some((Sign::Minus, name)) => format!("-{name}"),
    }
}

/// The basis of a preset or a file, or the ascending one of a signature p,q,r.
fn basis(source: &str) -> Result<Basis, String> {
    if preset::text(source).is_some() || Path::new(source).exists() {
        return source::definition(source).map(|definition| definition.basis);
    }
    let numbers: Option<Vec<usize>> = source.split(',').map(|number| number.trim().parse().ok()).collect();
    match numbers.as_deref() {
        Some(&[p, q, r]) => Basis::canonical(Signature::new(p, q, r)).map_err(|error| format!("error: {error}")),
        _ => {
            let presets = preset::NAMES.join(", ");
            Err(format!("error: expected a preset ({presets}), a file or a signature p,q,r, found `{source}`"))
        }
    }
}

fn aligned(rows: &[Vec<String>]) -> String {
    let width = rows.iter().flatten().map(|cell| cell.len()).max().unwrap_or(0);
    let line = |row: &Vec<String>| {
        let cells: Vec<_> = row.iter().map(|cell| format!("{cell:>width$}")).collect();
        cells.join(" ") + "\n"
    };
    rows.iter().map(line).collect()
}

fn markdown(rows: &[Vec<String>]) -> String {
    let line = |row: &Vec<String>| format!("| {} |\n", row.join(" | "));
    let rule = format!("|{}\n", "---|".repeat(rows[0].len()));
    line(&rows[0]) + &rule + &rows[1..].iter().map(line).collect::<String>()
}
