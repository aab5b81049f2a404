//! Plays a motion-capture file, or a small clip written in code, and draws a filmstrip of it.
//!
//! ```text
//! cargo run --release -p pga-motor --example animate -- walk.bvh -o walk.svg
//! ```

mod anatomy;
mod arguments;
mod clip;
mod filmstrip;
mod view;

use std::error::Error;
use std::fs;
use std::process::ExitCode;

use anatomy::Anatomy;
use arguments::{Arguments, Command};
use clip::Clip;
use filmstrip::{Filmstrip, Panel};

const USAGE: &str = "\
Usage: animate [FILE.bvh] [-o OUT.svg] [--times SECONDS,SECONDS,...]

Poses the skeleton of a BVH file at several times and draws the poses side by side.
Without a file, plays a small clip written in code.

  -o, --output OUT.svg   where the picture goes (animate.svg)
      --times LIST       times in seconds, such as 0,0.5,1.25 (eight, evenly spaced)
  -h, --help             this text";

/// Beyond this, in the clip's unit of length, a picture's arithmetic would overflow.
const FARTHEST: f64 = 1e100;

fn main() -> ExitCode {
    let arguments = match arguments::parse(lexopt::Parser::from_env()) {
        Ok(Command::Play(arguments)) => arguments,
        Ok(Command::Help) => {
            println!("{USAGE}");
            return ExitCode::SUCCESS;
        }
        Err(error) => {
            eprintln!("animate: {error} (--help shows the usage)");
            return ExitCode::from(2);
        }
    };
    match play(&arguments) {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("animate: {error}");
            ExitCode::FAILURE
        }
    }
}

fn play(arguments: &Arguments) -> Result<(), Box<dyn Error>> {
    let clip = match &arguments.file {
        Some(path) => Clip::from_file(path)?,
        None => Clip::waving(),
    };
    println!("{}: {}", clip.title(), clip.summary());
    let (anatomy, panels) = draw(&clip, &arguments.times)?;
    let strip = Filmstrip { title: clip.title(), summary: clip.summary(), anatomy, panels };
    let output = &arguments.output;
    fs::write(output, strip.svg()).map_err(|error| format!("cannot write {}: {error}", output.display()))?;
    println!("{} poses drawn to {}", strip.panels.len(), output.display());
    Ok(())
}

fn draw(clip: &Clip, times: &[f64]) -> Result<(Anatomy, Vec<Panel>), Box<dyn Error>> {
    let anatomy = Anatomy::of(clip.skeleton(), clip.tips());
    let times = if times.is_empty() { evenly_spaced_times(clip) } else { times.to_vec() };
    let mut panels = Vec::with_capacity(times.len());
    for time in times {
        if time > clip.duration() {
            eprintln!(
                "animate: {time} s is after the end of the clip; showing its last pose, at {:.3} s",
                clip.duration()
            );
        }
        let (caption, pose) = clip.pose_at(time.min(clip.duration()))?;
        let points = anatomy.points(clip.skeleton(), &pose)?;
        if points.iter().any(|point| [point.x, point.y, point.z].iter().any(|x| x.is_nan() || x.abs() > FARTHEST)) {
            return Err(format!("expected all joints within {FARTHEST:e} of the origin at {caption}").into());
        }
        panels.push(Panel { caption, points });
    }
    Ok((anatomy, panels))
}

/// Eight times from the first pose to the last, or as many as there are poses.
fn evenly_spaced_times(clip: &Clip) -> Vec<f64> {
    let count = clip.pose_count().min(8);
    let steps = count.saturating_sub(1).max(1) as f64;
    (0..count).map(|step| clip.duration() * step as f64 / steps).collect()
}
