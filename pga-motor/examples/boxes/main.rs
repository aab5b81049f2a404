//! Draws a box carried between two motions of the plane, by each interpolation side by side.
//!
//! ```text
//! cargo run --release -p pga-motor --example boxes -- -o boxes.svg
//! ```

mod picture;
mod scene;

use std::fs;
use std::path::{Path, PathBuf};
use std::process::ExitCode;

use lexopt::prelude::*;

const USAGE: &str = "\
Usage: boxes [-o OUT.svg]

Carries a box between two motions of the plane by nlerp, screw_lerp, log_lerp
and split_lerp and draws the four ways side by side.

  -o, --output OUT.svg   where the picture goes (boxes.svg)
  -h, --help             this text";

fn main() -> ExitCode {
    let output = match parse(lexopt::Parser::from_env()) {
        Ok(Some(output)) => output,
        Ok(None) => {
            println!("{USAGE}");
            return ExitCode::SUCCESS;
        }
        Err(error) => {
            eprintln!("boxes: {error} (--help shows the usage)");
            return ExitCode::from(2);
        }
    };
    match draw(&output) {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("boxes: cannot write {}: {error}", output.display());
            ExitCode::FAILURE
        }
    }
}

/// Where the picture goes; `None` where only help is wanted.
fn parse(mut parser: lexopt::Parser) -> Result<Option<PathBuf>, lexopt::Error> {
    let mut output = "boxes.svg".into();
    while let Some(argument) = parser.next()? {
        match argument {
            Short('h') | Long("help") => return Ok(None),
            Short('o') | Long("output") => output = parser.value()?.into(),
            _ => return Err(argument.unexpected()),
        }
    }
    Ok(Some(output))
}

fn draw(output: &Path) -> std::io::Result<()> {
    let ways = scene::ways();
    fs::write(output, picture::svg(&ways))?;
    println!("{} ways drawn to {}", ways.len(), output.display());
    Ok(())
}
