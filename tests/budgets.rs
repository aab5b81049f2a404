//! No program of the presets gets dearer unnoticed. `tests/golden/budgets.md` has what each costs, beside the record: the
//! fewest operations found in any public system or by our own searches, with its holder.

use ga_codegen::program::{CostModel, Count};
use std::collections::BTreeMap;
use std::fmt::Write;
use std::path::Path;

/// What a line of the table says of a program.
struct Budget {
    record: Option<usize>,
    record_fma: Option<usize>,
    cost: String,
}

fn table() -> BTreeMap<(String, String), Budget> {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/golden/budgets.md");
    let text = std::fs::read_to_string(&path).expect("tests/golden/budgets.md, the table of budgets");
    let mut budgets = BTreeMap::new();
    let mut preset = String::new();
    for line in text.lines() {
        if let Some(name) = line.strip_prefix("## ") {
            preset = name.to_owned();
        }
        let cells: Vec<_> = line.trim_matches('|').split('|').map(str::trim).collect();
        let [name, record, record_fma, mul_add, fma, depth] = cells[..] else { continue };
        if name.starts_with('-') || name == "program" {
            continue;
        }
        let sum = |text: &str| text.split('+').map(|part| part.parse::<usize>().ok()).sum::<Option<usize>>();
        let budget = Budget {
            record: sum(record),
            record_fma: record_fma.parse().ok(),
            cost: format!("{mul_add} | {fma} | {depth}"),
        };
        assert!(budgets.insert((preset.clone(), name.to_owned()), budget).is_none(), "{name} stands there twice");
    }
    budgets
}

/// Every program of the presets: preset, name, cost model, cost.
fn programs() -> Vec<(&'static str, String, CostModel, Count)> {
    let mut programs = Vec::new();
    for preset in ga_codegen::preset::NAMES {
        let tokens = ga_codegen::preset::text(preset).expect("a preset").parse().expect("a preset is made of tokens");
        let definition = ga_codegen::define(tokens).expect("a preset that is sound");
        for compiled in ga_codegen::compile(&definition).expect("a preset that is proved") {
            programs.push((preset, compiled.name, compiled.model, Count::of(&compiled.program)));
        }
    }
    programs
}

#[test]
fn no_program_costs_more_than_its_budget() {
    let (mut budgets, mut complaints) = (table(), String::new());
    for (preset, name, _, count) in programs() {
        let cost = format!("{}+{} | {} | {}", count.mul, count.add, count.fma, count.depth);
        match budgets.remove(&(preset.to_owned(), name.clone())) {
            None => writeln!(complaints, "{preset}: no line for `{name}`, which costs {cost}"),
            Some(budget) if budget.cost != cost => {
                writeln!(complaints, "{preset}: `{name}` costs {cost}, its line says {}", budget.cost)
            }
            Some(_) => Ok(()),
        }
        .expect("a string takes any text");
    }
    for ((preset, name), _) in budgets {
        writeln!(complaints, "{preset}: a line for `{name}`, which is not there").expect("a string takes any text");
    }
    assert!(
        complaints.is_empty(),
        "expected the costs (mul+add | FMA | depth) of tests/golden/budgets.md; where one got better, or is new, update its \
         line in a commit that says why:\n{complaints}"
    );
}

#[test]
fn every_record_is_met() {
    let budgets = table();
    let mut met = 0;
    for (preset, name, model, count) in programs() {
        let Some(budget) = budgets.get(&(preset.to_owned(), name.clone())) else { continue };
        if let Some(record) =
            budget.record.filter(|_| model == CostModel::Flops && count.trigonometric + count.sqrt == 0)
        {
            assert!(count.flops() <= record, "{name}: {} operations, the record is {record}", count.flops());
            met += 1;
        }
        if let Some(record) = budget.record_fma {
            assert!(count.fma <= record, "{name}: {} fused instructions, the record is {record}", count.fma);
        }
    }
    assert!(met >= 48, "only {met} rows have a record");
}

/// What a reader would write by hand: one product after the other, without what nobody needs.
#[test]
fn no_program_costs_more_than_its_definition_product_by_product() {
    let mut compared = 0;
    for preset in ga_codegen::preset::NAMES {
        let tokens = ga_codegen::preset::text(preset).expect("a preset").parse().expect("a preset is made of tokens");
        let definition = ga_codegen::define(tokens).expect("a preset that is sound");
        for compiled in ga_codegen::compile(&definition).expect("a preset that is proved") {
            let staged = ga_codegen::factor::staged_count(&compiled.specification).expect("counts that fit");
            let expanded = compiled.expanded.filter(|_| compiled.part == ga_codegen::Part::Whole);
            let count = Count::of(&compiled.program);
            for other in staged.into_iter().chain(expanded) {
                assert!(count.flops() <= other.flops(), "{preset} {}: {count}, by hand {other}", compiled.name);
                compared += 1;
            }
        }
    }
    assert!(compared > 300, "only {compared} comparisons");
}
