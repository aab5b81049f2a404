//! Every workload beside the crates that users would pick instead, in one run: a table of ratios, and the same as JSON.
//!
//! ```console
//! $ cargo bench --bench summary
//! $ RUSTFLAGS="-C target-cpu=native" cargo bench --bench summary -- --json summary.json
//! ```
//!
//! The contenders of a workload take turns, many rounds of them, so that what else the machine does falls on all of them alike. A ratio
//! is that of two times of one round; the table has the median of the rounds and the range of their middle half. Before products,
//! points, screws and kinematics are timed, the contenders' results are compared; interpolations of others go other ways.

mod stopwatch;
mod workloads;

use std::error::Error;
use std::fs;

use pga_motor::batch::InstructionSet;
use serde_json::json;
use stopwatch::Row;

fn main() -> Result<(), Box<dyn Error>> {
    let arguments: Vec<String> = std::env::args().skip(1).filter(|argument| argument != "--bench").collect();
    let file = match arguments.iter().map(String::as_str).collect::<Vec<_>>()[..] {
        [] => None,
        ["--json", file] => Some(file.to_owned()),
        _ => return Err("expected nothing, or --json FILE".into()),
    };
    let rows = workloads::all();
    println!("instructions of batches: {:?}\n", InstructionSet::in_use());
    println!("| workload, per item | ours | contender | its time | ratio |\n|---|---|---|---|---|");
    rows.iter().for_each(Row::print);
    if let Some(file) = file {
        let rows: Vec<_> = rows.iter().map(Row::json).collect();
        let report = json!({ "instructions": format!("{:?}", InstructionSet::in_use()), "rows": rows });
        fs::write(file, serde_json::to_string_pretty(&report)? + "\n")?;
    }
    Ok(())
}
