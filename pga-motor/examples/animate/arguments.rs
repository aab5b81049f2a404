//! The command line.

use std::ffi::OsString;
use std::path::PathBuf;

use lexopt::prelude::*;

/// What is to be done.
pub(crate) enum Command {
    Help,
    Play(Arguments),
}

/// What is to be played, when, and where the picture goes.
pub(crate) struct Arguments {
    pub(crate) file: Option<PathBuf>,
    pub(crate) output: PathBuf,
    /// Seconds; none for the clip's own choice.
    pub(crate) times: Vec<f64>,
}

pub(crate) fn parse(mut parser: lexopt::Parser) -> Result<Command, lexopt::Error> {
    let mut arguments = Arguments { file: None, output: "animate.svg".into(), times: Vec::new() };
    while let Some(argument) = parser.next()? {
        match argument {
            Short('h') | Long("help") => return Ok(Command::Help),
            Short('o') | Long("output") => arguments.output = parser.value()?.into(),
            Long("times") => arguments.times = parse_times(parser.value()?)?,
            Value(file) if arguments.file.is_none() => arguments.file = Some(file.into()),
            _ => return Err(argument.unexpected()),
        }
    }
    Ok(Command::Play(arguments))
}

fn parse_times(list: OsString) -> Result<Vec<f64>, lexopt::Error> {
    let list = list.string()?;
    list.split(',').map(parse_time).collect()
}

fn parse_time(text: &str) -> Result<f64, lexopt::Error> {
    match text.trim().parse() {
        Ok(time) if (0.0..f64::INFINITY).contains(&time) => Ok(time),
        _ => Err(format!("--times: expected seconds from 0 up, separated by commas, found `{text}`").into()),
    }
}
