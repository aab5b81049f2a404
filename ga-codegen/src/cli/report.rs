//! What every kernel is and costs, and whether it is proved.

use super::source::{Source, compiled};
use anstyle::{AnsiColor, Style};
use ga_codegen::kernel::{Definition, Hoist};
use ga_codegen::program::{Bound, Count};
use ga_codegen::{Compiled, Part};
use serde_json::{Value, json};
use std::time::Instant;

/// How the report is printed.
#[derive(Clone, Copy)]
pub(crate) enum Format {
    Text,
    Json,
    Markdown,
}

const HEADER: [&str; 9] =
    ["kernel", "definition", "model", "expanded", "emitted", "FMA", "depth", "error / u", "proof"];

/// The report on a definition. Styles are for a terminal; who prints to something else strips them.
pub(crate) fn run(source: &str, format: Format) -> Result<String, String> {
    let start = Instant::now();
    let Source { definition, compiled } = compiled(source)?;
    let rows = || compiled.iter().map(|compiled| row(&definition, compiled));
    match format {
        Format::Json => {
            let objects: Vec<_> = compiled.iter().map(|compiled| object(&definition, compiled)).collect();
            let text = serde_json::to_string_pretty(&objects).map_err(|error| format!("error: {error}"))?;
            Ok(text + "\n")
        }
        Format::Markdown => Ok(markdown(&rows().collect::<Vec<_>>())),
        Format::Text => {
            let rows: Vec<_> = rows().collect();
            let (bold, green) = (Style::new().bold(), AnsiColor::Green.on_default());
            let mut text = format!(
                "{bold}{source}{bold:#}: {}, {} kernels\n\n",
                definition.basis.signature(),
                definition.kernels.len()
            );
            text += &table(&rows);
            let seconds = start.elapsed().as_secs_f64();
            text += &format!("\n{green}All {} programs proved{green:#}, in {seconds:.2} s.\n", rows.len());
            Ok(text)
        }
    }
}

/// Names and types of what a program takes: a part of a kernel takes less than the whole.
fn inputs<'a>(definition: &'a Definition, compiled: &Compiled) -> Vec<(&'a str, &'a str)> {
    let kernel = &definition.kernels[compiled.kernel];
    let parameters = kernel.parameters.iter().zip(&kernel.uniform).filter(|(_, uniform)| match compiled.part {
        Part::Whole => true,
        Part::Prepare => **uniform,
        Part::Apply => !**uniform,
    });
    let record = kernel.hoist.as_ref().filter(|_| compiled.part == Part::Apply);
    let record = record.map(|hoist| (Hoist::RECORD, hoist.record.as_str()));
    let own = parameters.map(|(p, _)| (p.name.as_str(), definition.entities[p.entity].name.as_str()));
    record.into_iter().chain(own).collect()
}

/// The type of what a program gives.
fn output<'a>(definition: &'a Definition, compiled: &Compiled) -> &'a str {
    let kernel = &definition.kernels[compiled.kernel];
    let record = kernel.hoist.as_ref().filter(|_| compiled.part == Part::Prepare);
    record.map_or(&definition.entities[kernel.output].name, |hoist| &hoist.record)
}

fn signature(definition: &Definition, compiled: &Compiled) -> String {
    let inputs: Vec<_> = inputs(definition, compiled).iter().map(|(name, of)| format!("{name}: {of}")).collect();
    format!("({}) -> {}", inputs.join(", "), output(definition, compiled))
}

/// What a program computes; the parts of a kernel say which they are.
fn meaning(definition: &Definition, compiled: &Compiled) -> String {
    let kernel = &definition.kernels[compiled.kernel];
    let part = match compiled.part {
        Part::Whole => "",
        Part::Prepare => ", what stays the same",
        Part::Apply => ", the rest",
    };
    format!("{} = {}{part}", signature(definition, compiled), kernel.definition())
}

/// What a program is to be cheap in.
fn model(compiled: &Compiled) -> &'static str {
    if compiled.packed.is_some() { "packed" } else { compiled.model.name() }
}

fn row(definition: &Definition, compiled: &Compiled) -> [String; 9] {
    let expanded = compiled.expanded.map_or("-".to_owned(), |count| format!("{}+{}", count.mul, count.add));
    let count = Count::of(&compiled.program);
    let further = [(count.div, "div"), (count.sqrt, "sqrt"), (count.trigonometric, "trig")];
    let mut emitted = format!("{}+{}", count.mul, count.add);
    for (number, name) in further.into_iter().filter(|(number, _)| *number > 0) {
        emitted += &format!(" {number} {name}");
    }
    [
        compiled.name.clone(),
        meaning(definition, compiled),
        model(compiled).to_owned(),
        expanded,
        emitted,
        count.fma.to_string(),
        count.depth.to_string(),
        bound_cell(compiled, definition),
        compiled.proof.to_string(),
    ]
}

/// The greatest number in the rounding-error bound of every part of the output, Euclidean first.
fn bound_cell(compiled: &Compiled, definition: &Definition) -> String {
    let Some(bound) = compiled.promised_bound(definition) else { return "-".to_owned() };
    let factors: Vec<_> = bound.groups.iter().map(|group| group.display_factor(bound.roundings)).collect();
    factors.join(", ")
}

/// Left-aligned columns under a bold header.
fn table(rows: &[[String; 9]]) -> String {
    let header = HEADER.map(str::to_owned);
    let width = |column: usize| rows.iter().chain([&header]).map(|row| row[column].chars().count()).max().unwrap_or(0);
    let widths: [usize; 9] = std::array::from_fn(width);
    let line = |row: &[String; 9]| {
        let cells: Vec<_> = row.iter().zip(widths).map(|(cell, width)| format!("{cell:width$}")).collect();
        cells.join("  ").trim_end().to_owned()
    };
    let bold = Style::new().bold();
    let rule: [String; 9] = widths.map(|width| "-".repeat(width));
    let mut text = format!("{bold}{}{bold:#}\n{}\n", line(&header), line(&rule));
    for row in rows {
        text += &line(row);
        text.push('\n');
    }
    text
}

fn markdown(rows: &[[String; 9]]) -> String {
    let escaped = |cell: &String| cell.replace('|', "\\|");
    let line = |cells: Vec<String>| format!("| {} |\n", cells.join(" | "));
    let mut text = line(HEADER.map(str::to_owned).to_vec());
    text += &format!("|{}\n", "---|".repeat(HEADER.len()));
    text + &rows.iter().map(|row| line(row.iter().map(escaped).collect())).collect::<String>()
}

fn object(definition: &Definition, compiled: &Compiled) -> Value {
    let kernel = &definition.kernels[compiled.kernel];
    let inputs = inputs(definition, compiled);
    let inputs: Vec<_> = inputs.iter().map(|(name, of)| json!({ "name": name, "type": of })).collect();
    let count = Count::of(&compiled.program);
    json!({
        "kernel": if compiled.part == Part::Whole && compiled.precision.is_none() { &kernel.name } else { &compiled.name },
        "function": compiled.name,
        "definition": kernel.definition(),
        "inputs": inputs,
        "output": output(definition, compiled),
        "cost_model": model(compiled),
        "polynomial": compiled.precision.map(|precision| precision.name()),
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
