//! Packed recipes: programs on values of four lanes that a search has found, or somebody has thought out.
//!
//! ```text
//! recipe rotor_mul_rotor packed {
//!     v0 = [a.s, a.e23, a.e31, a.e12];
//!     v1 = [b.s, b.e23, b.e31, b.e12];
//!     v2 = v0[1, 1, 2, 3] * v1[1, 0, 3, 2] + ...;
//!     out[s, e23, e31, e12] = v0[0, 0, 0, 0] * v1 + v2[-0, 1, 2, 3] ...;
//! }
//! ```
//! `[...]` loads four coefficients or numbers. `v[1, 1, 2, 3]` has in its lanes, counted from 0, these lanes of `v`, negated
//! where a minus stands before them. `out[...] = v` says which fields of the output the lanes of `v` are, `_` for none.
//! Otherwise it is as in any recipe: rows are named once, before their use, sums and products group as written.

use crate::kernel::Specification;
use crate::program::{LANES, PackedOperation, PackedProgram, PackedRecipe, PackedRow, PackedSource, PackedTerm};
use crate::program::{Source, Value};
use std::collections::BTreeMap;
use std::fmt::Write;

const UNCHANGED: [u8; LANES] = [0, 1, 2, 3];

/// The program that a packed recipe describes.
///
/// # Errors
/// A name that is neither an input nor an earlier row; an output that is missing.
pub(super) fn replay(specification: &Specification, recipe: &PackedRecipe) -> Result<PackedProgram, String> {
    let mut reader = Reader { specification, operations: Vec::new(), names: BTreeMap::new() };
    let mut outputs: BTreeMap<&str, (Value, u8)> = BTreeMap::new();
    for row in &recipe.rows {
        match row {
            PackedRow::Named(name, term) => {
                let value = reader.value(term)?;
                if reader.names.insert(name.clone(), value).is_some() {
                    return Err(format!("it names `{name}` twice"));
                }
            }
            PackedRow::Outputs(fields, term) => {
                let value = reader.value(term)?;
                for (lane, field) in (0..).zip(fields).filter_map(|(lane, field)| Some((lane, field.as_ref()?))) {
                    if !specification.fields.contains(field) {
                        return Err(format!("it has a lane for `{field}`, which is no output"));
                    }
                    if outputs.insert(field, (value, lane)).is_some() {
                        return Err(format!("it has two lanes for `{field}`"));
                    }
                }
            }
        }
    }
    let output =
        |field: &String| outputs.get(field.as_str()).copied().ok_or_else(|| format!("it has no lane for `{field}`"));
    let outputs = specification.fields.iter().map(output).collect::<Result<_, _>>()?;
    Ok(PackedProgram { operations: reader.operations, outputs }.pruned())
}

struct Reader<'a> {
    specification: &'a Specification,
    operations: Vec<PackedOperation>,
    names: BTreeMap<String, Value>,
}

impl Reader<'_> {
    fn push(&mut self, operation: PackedOperation) -> Value {
        self.operations.push(operation);
        self.operations.len() - 1
    }

    fn source(&self, source: &PackedSource) -> Result<Source, String> {
        match source {
            PackedSource::Number(number) => Ok(Source::Constant(*number)),
            PackedSource::Name(name) => {
                let index = self.specification.coefficients.iter().position(|coefficient| coefficient.name == *name);
                index.map(Source::Input).ok_or_else(|| format!("it loads `{name}`, which is no input"))
            }
        }
    }

    fn value(&mut self, term: &PackedTerm) -> Result<Value, String> {
        let operation = match term {
            PackedTerm::Name(name) => {
                let known = self.names.get(name).copied();
                return known.ok_or_else(|| format!("it uses `{name}`, which is not known there"));
            }
            PackedTerm::Load(sources) => {
                let [a, b, c, d] = sources;
                PackedOperation::Load([self.source(a)?, self.source(b)?, self.source(c)?, self.source(d)?])
            }
            PackedTerm::Lanes(inner, lanes) => {
                let mut value = self.value(inner)?;
                let (negated, lanes) = (lanes.map(|(minus, _)| minus), lanes.map(|(_, lane)| lane));
                if lanes != UNCHANGED {
                    value = self.push(PackedOperation::Shuffle(value, lanes));
                }
                return Ok(if negated.contains(&true) {
                    self.push(PackedOperation::Negate(value, negated))
                } else {
                    value
                });
            }
            PackedTerm::Double(inner) => PackedOperation::Double(self.value(inner)?),
            PackedTerm::Add(a, b) => PackedOperation::Add(self.value(a)?, self.value(b)?),
            PackedTerm::Sub(a, b) => PackedOperation::Sub(self.value(a)?, self.value(b)?),
            PackedTerm::Mul(a, b) => PackedOperation::Mul(self.value(a)?, self.value(b)?),
        };
        Ok(self.push(operation))
    }
}

/// A packed program as the rows of a recipe: a name for what is loaded or used more than once.
pub(super) fn write(specification: &Specification, program: &PackedProgram, name: &str) -> String {
    let mut uses = vec![0; program.operations.len()];
    program.operations.iter().flat_map(|operation| operation.operands()).for_each(|value| uses[value] += 1);
    let mut writer = Writer { specification, program, names: BTreeMap::new() };
    let mut text = format!("recipe {name} packed {{\n");
    for (value, operation) in program.operations.iter().enumerate() {
        if uses[value] > 1 || matches!(operation, PackedOperation::Load(_)) {
            let row = format!("v{}", writer.names.len());
            let _ = writeln!(text, "    {row} = {};", writer.expression(value, 0));
            writer.names.insert(value, row);
        }
    }
    let mut rows: Vec<(Value, [&str; LANES])> = Vec::new();
    for (field, &(value, lane)) in specification.fields.iter().zip(&program.outputs) {
        let place = usize::from(lane);
        match rows.iter_mut().find(|(known, fields)| *known == value && fields[place] == "_") {
            Some((_, fields)) => fields[place] = field,
            None => {
                let mut fields = ["_"; LANES];
                fields[place] = field;
                rows.push((value, fields));
            }
        }
    }
    for (value, fields) in rows {
        let _ = writeln!(text, "    out[{}] = {};", fields.join(", "), writer.expression(value, 0));
    }
    text + "}\n"
}

struct Writer<'a> {
    specification: &'a Specification,
    program: &'a PackedProgram,
    names: BTreeMap<Value, String>,
}

impl Writer<'_> {
    fn source(&self, source: Source) -> String {
        match source {
            Source::Input(index) => self.specification.coefficients[index].name.clone(),
            Source::Constant(number) if number.denominator() == 1 => number.to_string(),
            Source::Constant(number) => format!("{}/{}", number.numerator(), number.denominator()),
        }
    }

    /// The expression of a value, in parentheses where it binds less tightly than `least`: 1 sums, 2 products, 3 lanes of
    /// something, 4 what lanes can be taken of.
    fn expression(&self, value: Value, least: u8) -> String {
        if let Some(name) = self.names.get(&value) {
            return name.clone();
        }
        let (text, binding) = match self.program.operations[value] {
            PackedOperation::Load(sources) => {
                (format!("[{}]", sources.map(|source| self.source(source)).join(", ")), 4)
            }
            PackedOperation::Shuffle(a, lanes) => {
                (format!("{}[{}]", self.expression(a, 4), lanes.map(|lane| lane.to_string()).join(", ")), 3)
            }
            PackedOperation::Negate(a, negated) => {
                let lane = |lane: usize| format!("{}{lane}", if negated[lane] { "-" } else { "" });
                (format!("{}[{}]", self.expression(a, 4), [0, 1, 2, 3].map(lane).join(", ")), 3)
            }
            PackedOperation::Double(a) => (format!("2 * {}", self.expression(a, 3)), 2),
            PackedOperation::Add(a, b) => (format!("{} + {}", self.expression(a, 1), self.expression(b, 2)), 1),
            PackedOperation::Sub(a, b) => (format!("{} - {}", self.expression(a, 1), self.expression(b, 2)), 1),
            PackedOperation::Mul(a, b) => (format!("{} * {}", self.expression(a, 2), self.expression(b, 3)), 2),
        };
        if binding < least { format!("({text})") } else { text }
    }
}
