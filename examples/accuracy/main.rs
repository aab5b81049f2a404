//! How accurate the functions with roots and angles are, beside the formulas of textbooks.
//!
//! ```console
//! $ cargo run --release --example accuracy                    # every function by decade of half-angle
//! $ cargo run --release --example accuracy -- --markdown      # the summary in the README
//! ```
//!
//! Errors are against a reference of 320 bits, in units of the error that any evaluation may commit; see `measure`.

mod big;
mod float;
mod functions;
mod measure;
mod plane;
mod report;
mod samples;
mod space;
mod table;
mod textbook;

use std::process::ExitCode;

fn main() -> ExitCode {
    let arguments: Vec<_> = std::env::args().skip(1).collect();
    match arguments.iter().map(String::as_str).collect::<Vec<_>>()[..] {
        [] => print!("{}{}", table::by_decade::<f64>(), table::by_decade::<f32>()),
        ["--markdown"] => print!("{}", table::summary()),
        _ => {
            eprintln!("expected nothing or --markdown, found `{}`", arguments.join(" "));
            return ExitCode::from(2);
        }
    }
    ExitCode::SUCCESS
}
