//! `ga-codegen report | emit | search | table | fit`.

mod emit;
mod fit;
mod report;
mod search;
mod source;
mod table;

use clap::{Parser, Subcommand};
use std::path::PathBuf;
use std::process::ExitCode;

/// Expands geometric algebra definitions into straight-line Rust and proves every kernel equal to its definition.
#[derive(Parser)]
#[command(name = "ga-codegen", version, about, long_about = None)]
struct Arguments {
    #[command(subcommand)]
    command: Option<Command>,
}

#[derive(Subcommand)]
enum Command {
    /// Prove every kernel of a definition and print what each costs (the default, for `pga3d`).
    Report {
        /// A preset (pga3d, pga2d) or a file with a definition block.
        #[arg(default_value = "pga3d")]
        source: String,
        /// Print JSON instead of a table.
        #[arg(long, conflicts_with = "markdown")]
        json: bool,
        /// Print a Markdown table.
        #[arg(long)]
        markdown: bool,
    },
    /// Write the Rust of a definition, self-contained unless the definition names a scalar module.
    Emit {
        /// A preset (pga3d, pga2d) or a file with a definition block.
        source: String,
        /// Only the function of this kernel.
        #[arg(long, value_name = "NAME")]
        kernel: Option<String>,
        /// The file to write; standard output without it.
        #[arg(short, long, value_name = "FILE")]
        output: Option<PathBuf>,
    },
    /// Look for cheaper programs by many restarts, and write what is found as recipes. Goes on where it was interrupted.
    Search {
        /// A preset (pga3d, pga2d) or a file with a definition block.
        #[arg(default_value = "pga3d")]
        source: String,
        /// Only these kernels.
        #[arg(long, value_name = "NAME")]
        kernel: Vec<String>,
        /// Restarts for every kernel and cost model.
        #[arg(long, default_value_t = 1000)]
        restarts: u64,
        /// Start anew: neither from the recipes that are there nor where an earlier search stopped.
        #[arg(long)]
        fresh: bool,
        /// The file for the recipes; standard output without it. How far the search came stands beside it in *.search.json.
        #[arg(short, long, value_name = "FILE")]
        output: Option<PathBuf>,
    },
    /// Print the Cayley table of a product.
    Table {
        /// A preset (pga3d, pga2d), a file with a definition block, or a signature p,q,r.
        source: String,
        /// The product.
        #[arg(long, default_value = "geometric", value_parser = table::product)]
        product: ga_codegen::algebra::Product,
        /// The format.
        #[arg(long, value_enum, default_value_t = table::Format::Text)]
        format: table::Format,
    },
    /// Fit polynomials to the functions that exp and log are made of, and print how near they come.
    Fit {
        /// The file for the polynomials as Rust; none is written without it.
        #[arg(short, long, value_name = "FILE")]
        output: Option<PathBuf>,
    },
}

/// Runs the command line; the exit status is not 0 where anything failed.
pub(crate) fn run() -> ExitCode {
    let command = Arguments::parse().command;
    let result = match command.unwrap_or(Command::Report { source: "pga3d".to_owned(), json: false, markdown: false }) {
        Command::Report { source, json, markdown } => {
            let format = match (json, markdown) {
                (true, _) => report::Format::Json,
                (_, true) => report::Format::Markdown,
                _ => report::Format::Text,
            };
            report::run(&source, format)
        }
        Command::Emit { source, kernel, output } => emit::run(&source, kernel.as_deref(), output.as_deref()),
        Command::Search { source, kernel, restarts, fresh, output } => {
            search::run(&search::Request { source, kernels: kernel, restarts, fresh, output })
        }
        Command::Table { source, product, format } => table::run(&source, product, format),
        Command::Fit { output } => fit::run(output.as_deref()),
    };
    match result.and_then(|text| source::print(&text)) {
        Ok(()) => ExitCode::SUCCESS,
        Err(message) => {
            eprintln!("{message}");
            ExitCode::FAILURE
        }
    }
}
