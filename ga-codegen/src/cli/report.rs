//! What every kernel is and costs, and whether it is proved.

use super::source::{Source, compiled};
use ga_codegen::Compiled;
use ga_codegen::kernel::{Definition, Kernel};
use ga_codegen::program::{Bound, Count};
use serde_json::{Value, json};
use std::time::Instant;

/// The report as text or JSON.
pub(crate) fn run(source: &str, json: bool) -> Result<String, String> {
    let start = Instant::now();
    let Source { definition, compiled } = compiled(source)?;
    let pairs: Vec<_> = compiled.iter().map(|compiled| (&definition.kernels[compiled.kernel], compiled)).collect();
    if json {
        let objects: Vec<_> = pairs.iter().map(|(kernel, compiled)| object(&definition, kernel, compiled)).collect();
        let text = serde_json::to_string_pretty(&objects).map_err(|error| format!("error: {error}"))?;
        return Ok(text + "\n");
    }
    let rows: Vec<[String; 6]> = pairs.iter().map(|(kernel, compiled)| row(&definition, kernel, compiled)).collect();
    let mut text = format!("{source}: {} and {} kernels\n\n", definition.basis.signature(), rows.len());
    text += &table(["kernel", "definition", "expanded", "emitted", "error / u", "proof"], &rows);
    text += &format!("\nAll {} kernels proved, in {:.2} s.\n", rows.len(), start.elapsed().as_secs_f64());
    Ok(text)
}

fn signature(definition: &Definition, kernel: &Kernel) -> String {
    let parameters: Vec<_> =
        kernel.parameters.iter().map(|p| format!("{}: {}", p.name, definition.entities[p.entity].name)).collect();
    format!("({}) -> {}", parameters.join(", "), definition.entities[kernel.output].name)
}

fn row(definition: &Definition, kernel: &Kernel, compiled: &Compiled) -> [String; 6] {
    let expanded = compiled.expanded.map_or("-".to_owned(), |count| format!("{}+{}", count.mul, count.add));
    let count = Count::of(&compiled.program);
    let further = [(count.div, "div"), (count.sqrt, "sqrt"), (count.trigonometric, "trig")];
    let mut emitted = format!("{}+{}", count.mul, count.add);
    for (number, name) in further.into_iter().filter(|(number, _)| *number > 0) {
        emitted += &format!(" {number} {name}");
    }
    let meaning = format!("{} = {}", signature(definition, kernel), kernel.definition());
    [compiled.name.clone(), meaning, expanded, emitted, bound_cell(compiled, definition), compiled.proof.to_string()]
}

/// The greatest number in the rounding-error bound of every part of the output, Euclidean first.
fn bound_cell(compiled: &Compiled, definition: &Definition) -> String {
    let Some(bound) = compiled.promised_bound(definition) else { return "-".to_owned() };
    let factors: Vec<_> = bound.groups.iter().map(|group| group.display_factor(bound.roundings)).collect();
    factors.join(", ")
}

/// Left-aligned columns under a header.
fn table(header: [&str; 6], rows: &[[String; 6]]) -> String {
    let header = header.map(str::to_owned);
    let width = |column: usize| rows.iter().chain([&header]).map(|row| row[column].chars().count()).max().unwrap_or(0);
    let widths: Vec<_> = (0..6).map(width).collect();
    let rule: [String; 6] = std::array::from_fn(|column| "-".repeat(widths[column]));
    let mut text = String::new();
    for row in [&header, &rule].into_iter().chain(rows) {
        let cells: Vec<_> = row.iter().zip(&widths).map(|(cell, width)| format!("{cell:width$}")).collect();
        text += cells.join("  ").trim_end();
        text.push('\n');
    }
    text
}

fn object(definition: &Definition, kernel: &Kernel, compiled: &Compiled) -> Value {
    let inputs: Vec<_> = kernel
        .parameters
        .iter()
        .map(|p| json!({ "name": p.name, "type": definition.entities[p.entity].name }))
        .collect();
    let count = Count::of(&compiled.program);
    json!({
        "kernel": kernel.name,
        "definition": kernel.definition(),
        "inputs": inputs,
        "output": definition.entities[kernel.output].name,
        "cost_model": compiled.model.name(),
        "expanded": compiled.expanded.map(|count| json!({ "mul": count.mul, "add": count.add })),
        "emitted": {
            "mul": count.mul,
            "add": count.add,
            "div": count.div,
            "sqrt": count.sqrt,
            "trigonometric": count.trigonometric,
            "fma": count.fma,
            "depth": count.depth,
        },
        "bound": compiled.promised_bound(definition).map(|bound| bound_object(definition, compiled, &bound)),
        "proved": true,
        "proof": compiled.proof.to_string(),
    })
}

/// The rounding-error bound of every part of the output: the greatest number in it, and the whole of it for u = 1.
fn bound_object(definition: &Definition, compiled: &Compiled, bound: &Bound) -> Value {
    let names = compiled.parameter_names(definition);
    let groups = bound.groups.iter().map(|group| {
        json!({
            "part": group.group.name(),
            "factor": (group.factor() * 1e6).ceil() / 1e6,
            "bound": group.display(bound.roundings, &names),
            "roundings": bound.roundings,
        })
    });
    groups.collect()
}
