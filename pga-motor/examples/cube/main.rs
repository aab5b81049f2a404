//! Turns a cube about several axes at once and carries it along, in three ways, as an animated picture.
//!
//! ```text
//! cargo run --release -p pga-motor --example cube -- -o cube.svg
//! ```

mod cube;
mod motion;
mod picture;

use std::fs;
use std::path::{Path, PathBuf};
use std::process::ExitCode;

use lexopt::prelude::*;

const USAGE: &str = "\
Usage: cube [-o OUT.svg]

Turns a cube about several axes at once and carries it along: by the exponential of a
sum of lines, along screws, and by a product of motors. The picture is an SVG that moves;
open it in a browser.

  -o, --output OUT.svg   where the picture goes (cube.svg)
  -h, --help             this text";

fn main() -> ExitCode {
    let output = match parse(lexopt::Parser::from_env()) {
        Ok(Some(output)) => output,
        Ok(None) => {
            println!("{USAGE}");
            return ExitCode::SUCCESS;
        }
        Err(error) => {
            eprintln!("cube: {error} (--help shows the usage)");
            return ExitCode::from(2);
        }
    };
    match draw(&output) {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("cube: cannot write {}: {error}", output.display());
            ExitCode::FAILURE
        }
    }
}

/// Where the picture goes; `None` where only help is wanted.
fn parse(mut parser: lexopt::Parser) -> Result<Option<PathBuf>, lexopt::Error> {
    let mut output = "cube.svg".into();
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
    let motions = motion::all();
    fs::write(output, picture::svg(&motions))?;
    println!("{} motions drawn to {}", motions.len(), output.display());
    Ok(())
}
