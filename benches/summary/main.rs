//! Every workload beside the crates that users would pick instead, in one run: a table of ratios, and the same as JSON.
//!
//! ```console
//! $ cargo bench --bench summary
//! $ cargo bench --bench summary -- kinematics    # those workloads that have it in their names
//! $ RUSTFLAGS="-C target-cpu=native" cargo bench --features peers --bench summary -- --json summary.json
//! ```
//!
//! The contenders of a workload take turns, many rounds of them, so that what else the machine does falls on all of them alike. A ratio
//! is that of two times of one round; the table has the median of the rounds and the range of their middle half.

mod stopwatch;
#[path = "../support/mod.rs"]
mod support;

use std::error::Error;
use std::fs;

use pga_motor::batch::InstructionSet;
use serde_json::json;
use stopwatch::Row;

/// What the compiler could use in all of the code, batches apart.
const COMPILED_FOR: &str = if cfg!(target_feature = "avx512f") {
    "AVX-512"
} else if cfg!(target_feature = "avx2") {
    "AVX2"
} else if cfg!(target_feature = "sse2") {
    "SSE2"
} else {
    "what every machine of this architecture has"
};

fn main() -> Result<(), Box<dyn Error>> {
    let (mut file, mut part) = (None, String::new());
    let mut arguments = std::env::args().skip(1).filter(|argument| argument != "--bench");
    while let Some(argument) = arguments.next() {
        match argument.as_str() {
            "--json" => file = Some(arguments.next().ok_or("expected a file after --json")?),
            option if option.starts_with('-') => {
                return Err(format!("expected --json FILE or a part of a name, found {option}").into());
            }
            _ => part = argument,
        }
    }
    let rows: Vec<Row> = support::all()
        .filter(|workload| workload.name.contains(&part))
        .map(|workload| Row::measure(&workload))
        .collect();
    if rows.is_empty() {
        return Err(format!("no workload has {part:?} in its name").into());
    }
    println!("instructions of our batches, chosen at run time: {:?}", InstructionSet::in_use());
    println!("instructions that everything else was compiled for: {COMPILED_FOR}\n");
    println!("| workload, per item | ours | contender | its time | ratio |\n|---|---|---|---|---|");
    rows.iter().for_each(Row::print);
    if let Some(file) = file {
        let rows: Vec<_> = rows.iter().map(Row::json).collect();
        let report = json!({
            "instructions": format!("{:?}", InstructionSet::in_use()),
            "compiled_for": COMPILED_FOR,
            "rows": rows
        });
        fs::write(file, serde_json::to_string_pretty(&report)? + "\n")?;
    }
    Ok(())
}
