//! Recipes: the extractions that a search has found, written down as the rows that result, so that expansion replays
//! them instead of searching. A recipe is trusted as little as any other program: it is proved before it is emitted.
//!
//! ```text
//! recipe rotor_transform_point flops {
//!     t0 = r.e31 * p.z - r.e12 * p.y;
//!     ...
//!     out.x = p.x + 2 * (...);
//! }
//! ```
//! Rows are named once, before their use; `out.FIELD` are the outputs (`out` for a plain scalar). Sums and products group as
//! written, and `2 * x` is a doubling.

use crate::kernel::Specification;
use crate::program::{CostModel, Operation, Program, ProgramBuilder, Recipe, RecipeTerm, Value};
use std::collections::BTreeMap;
use std::fmt::Write;

const OUTPUT: &str = "out";

/// The program that a recipe describes.
///
/// # Errors
/// A name that is neither an input nor an earlier row; an output that is missing.
pub(super) fn replay(specification: &Specification, recipe: &Recipe) -> Result<Program, String> {
    let mut builder = ProgramBuilder::new();
    let mut names: BTreeMap<String, Value> = BTreeMap::new();
    for (index, coefficient) in specification.coefficients.iter().enumerate() {
        names.insert(coefficient.name.clone(), builder.push(Operation::Input(index)));
    }
    let is_field = |name: &str| match name.strip_prefix("out.") {
        Some(field) => specification.fields.iter().any(|known| known == field),
        None => name == OUTPUT && specification.fields.iter().any(String::is_empty),
    };
    for (name, term) in &recipe.rows {
        if names.contains_key(name) {
            return Err(format!("it names `{name}` twice"));
        }
        if (name == OUTPUT || name.contains('.')) && !is_field(name) {
            return Err(format!("it has a row `{name}`, which is no output"));
        }
        let value = evaluate(term, &names, &mut builder)?;
        names.insert(name.clone(), value);
    }
    let output = |field: &String| {
        let name = if field.is_empty() { OUTPUT.to_owned() } else { format!("{OUTPUT}.{field}") };
        names.get(&name).copied().ok_or_else(|| format!("it has no row `{name}`"))
    };
    let outputs: Vec<Value> = specification.fields.iter().map(output).collect::<Result<_, _>>()?;
    Ok(builder.finish(&outputs))
}

fn evaluate(term: &RecipeTerm, names: &BTreeMap<String, Value>, builder: &mut ProgramBuilder) -> Result<Value, String> {
    let mut value = |term: &RecipeTerm| evaluate(term, names, builder);
    let operation = match term {
        RecipeTerm::Name(name) => {
            return names.get(name).copied().ok_or_else(|| format!("it uses `{name}`, which is not known there"));
        }
        RecipeTerm::Number(number) => Operation::Constant(*number),
        RecipeTerm::Neg(inner) => Operation::Neg(value(inner)?),
        RecipeTerm::Double(inner) => Operation::Double(value(inner)?),
        RecipeTerm::Add(a, b) => Operation::Add(value(a)?, value(b)?),
        RecipeTerm::Sub(a, b) => Operation::Sub(value(a)?, value(b)?),
        RecipeTerm::Mul(a, b) => Operation::Mul(value(a)?, value(b)?),
    };
    Ok(builder.push(operation))
}

/// A program as the rows of a recipe.
pub(super) fn write(specification: &Specification, program: &Program, name: &str, model: CostModel) -> String {
    let mut uses = vec![0; program.operations.len()];
    let operands = program.operations.iter().flat_map(|operation| operation.operands());
    operands.chain(program.outputs.iter().copied()).for_each(|value| uses[value] += 1);
    let mut writer = Writer { specification, program, names: BTreeMap::new() };
    let mut text = format!("recipe {name} {model} {{\n");
    for (value, operation) in program.operations.iter().enumerate() {
        let plain = matches!(operation, Operation::Input(_) | Operation::Constant(_));
        if uses[value] > 1 && !plain {
            let row = format!("t{}", writer.names.len());
            let _ = writeln!(text, "    {row} = {};", writer.expression(value, 0));
            writer.names.insert(value, row);
        }
    }
    for (field, &output) in specification.fields.iter().zip(&program.outputs) {
        let dot = if field.is_empty() { "" } else { "." };
        let _ = writeln!(text, "    {OUTPUT}{dot}{field} = {};", writer.expression(output, 0));
    }
    text + "}\n"
}

struct Writer<'a> {
    specification: &'a Specification,
    program: &'a Program,
    names: BTreeMap<Value, String>,
}

impl Writer<'_> {
    fn is_sum(&self, value: Value) -> bool {
        let named = self.names.contains_key(&value);
        !named && matches!(self.program.operations[value], Operation::Add(..) | Operation::Sub(..))
    }

    /// The expression of a value, in parentheses where it binds less tightly than `least`: 1 sums, 2 products, 3 atoms.
    fn expression(&self, value: Value, least: u8) -> String {
        if let Some(name) = self.names.get(&value) {
            return name.clone();
        }
        let (text, binding) = match self.program.operations[value] {
            Operation::Input(index) => (self.specification.coefficients[index].name.clone(), 3),
            Operation::Constant(number) if number.denominator() == 1 => (number.to_string(), 3),
            Operation::Constant(number) => (format!("({}/{})", number.numerator(), number.denominator()), 3),
            Operation::Add(a, b) => {
                // Addition commutes: a sum stands left, where it needs no parentheses.
                let (a, b) = if self.is_sum(b) && !self.is_sum(a) { (b, a) } else { (a, b) };
                (format!("{} + {}", self.expression(a, 1), self.expression(b, 2)), 1)
            }
            Operation::Sub(a, b) => (format!("{} - {}", self.expression(a, 1), self.expression(b, 2)), 1),
            Operation::Mul(a, b) => (format!("{} * {}", self.expression(a, 2), self.expression(b, 3)), 2),
            Operation::Double(a) => (format!("2 * {}", self.expression(a, 3)), 2),
            Operation::Neg(a) => (format!("-{}", self.expression(a, 3)), 3),
            _ => unreachable!("invariant: the search builds sums and products only"),
        };
        if binding < least { format!("({text})") } else { text }
    }
}
