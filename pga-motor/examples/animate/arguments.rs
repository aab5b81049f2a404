//! The command line.

use std::ffi::OsString;
use std::path::PathBuf;

use lexopt::prelude::*;
use pga_motor::skeleton::Interpolation;

/// What is to be done.
pub(crate) enum Command {
    Help,
    Play(Arguments),
}

/// What is to be played, how and when, and what is to come of it.
pub(crate) struct Arguments {
    pub(crate) file: Option<PathBuf>,
    /// Name or index; none for the first.
    pub(crate) clip: Option<String>,
    pub(crate) interpolation: Interpolation,
    /// Which keys are kept: each one of so many.
    pub(crate) every: usize,
    /// Seconds; none for evenly spaced ones.
    pub(crate) times: Vec<f64>,
    pub(crate) output: Output,
}

/// What is made.
pub(crate) enum Output {
    Filmstrip(PathBuf),
    Page(PathBuf),
    /// Numbers on standard output.
    Positions,
}

pub(crate) fn parse(mut parser: lexopt::Parser) -> Result<Command, lexopt::Error> {
    let (mut file, mut clip, mut interpolation, mut every) = (None, None, Interpolation::Split, 1);
    let (mut times, mut output, mut json) = (Vec::new(), None, false);
    while let Some(argument) = parser.next()? {
        match argument {
            Short('h') | Long("help") => return Ok(Command::Help),
            Short('o') | Long("output") => output = Some(parser.value()?.into()),
            Long("clip") => clip = Some(parser.value()?.string()?),
            Long("interpolation") => interpolation = parse_interpolation(&parser.value()?.string()?)?,
            Long("every") => every = parse_every(&parser.value()?.string()?)?,
            Long("times") => times = parse_times(parser.value()?)?,
            Long("json") => json = true,
            Value(path) if file.is_none() => file = Some(path.into()),
            _ => return Err(argument.unexpected()),
        }
    }
    let output = choose_output(output, json)?;
    if matches!(output, Output::Page(_)) && !times.is_empty() {
        return Err("--times is for a filmstrip and for --json, a page plays the whole clip".into());
    }
    Ok(Command::Play(Arguments { file, clip, interpolation, every, times, output }))
}

fn choose_output(path: Option<PathBuf>, json: bool) -> Result<Output, lexopt::Error> {
    if json {
        return match path {
            None => Ok(Output::Positions),
            Some(_) => Err("--json writes to standard output, expected no --output with it".into()),
        };
    }
    let path = path.unwrap_or_else(|| "animate.svg".into());
    let extension = path.extension().unwrap_or_default().to_ascii_lowercase();
    match extension.to_str() {
        Some("svg") => Ok(Output::Filmstrip(path)),
        Some("html" | "htm") => Ok(Output::Page(path)),
        _ => Err(format!("--output: expected a name that ends in .svg or .html, found `{}`", path.display()).into()),
    }
}

fn parse_interpolation(name: &str) -> Result<Interpolation, lexopt::Error> {
    let known = Interpolation::ALL.into_iter().find(|interpolation| interpolation.name() == name);
    known.ok_or_else(|| {
        let names = Interpolation::ALL.map(Interpolation::name).join(", ");
        format!("--interpolation: expected one of {names}, found `{name}`").into()
    })
}

fn parse_every(text: &str) -> Result<usize, lexopt::Error> {
    match text.parse() {
        Ok(every) if every > 0 => Ok(every),
        _ => Err(format!("--every: expected a whole number from 1 up, found `{text}`").into()),
    }
}

fn parse_times(list: OsString) -> Result<Vec<f64>, lexopt::Error> {
    let list = list.string()?;
    list.split(',').map(parse_time).collect()
}

fn parse_time(text: &str) -> Result<f64, lexopt::Error> {
    match text.trim().parse() {
        Ok(time) if f64::is_finite(time) => Ok(time),
        _ => Err(format!("--times: expected seconds, separated by commas, found `{text}`").into()),
    }
}
