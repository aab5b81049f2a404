//! Plays a skeleton from a glTF or BVH file, or a small clip written in code: as a filmstrip, as a page to look at in a browser, or as
//! numbers.
//!
//! ```text
//! cargo run --release -p pga-motor --example animate -- walk.bvh -o walk.html
//! cargo run --release -p pga-motor --example animate --features gltf -- Fox.glb --clip Run -o run.svg
//! ```

mod anatomy;
mod arguments;
mod filmstrip;
mod page;
mod panel;
mod player;
mod positions;
mod source;
mod tracks;
mod view;

use std::error::Error;
use std::fs;
use std::io::{self, Write};
use std::path::Path;
use std::process::ExitCode;

use arguments::{Arguments, Command, Output};
use filmstrip::Filmstrip;
use page::Page;
use player::Player;
use source::Source;

const USAGE: &str = "\
Usage: animate [FILE.glb|FILE.gltf|FILE.bvh] [-o OUT.svg|OUT.html] [options]

Poses the skeleton of a file at several times and draws the poses side by side, or
writes a page that plays it in a browser. Without a file, plays a figure written in code,
which has two clips, `waving` and `leaping`. glTF needs a build with `--features gltf`.
A page holds 60 poses a second, fewer of a clip of some minutes and more of a short one.

  -o, --output OUT          where the picture goes (animate.svg): a filmstrip as .svg,
                            a page as .html
      --clip NAME|INDEX     which clip of the file, by its name or counted from 0 (0)
      --interpolation WAY   step, nlerp, slerp, screw or split (split)
      --every N             keep only each N-th key of the clip, and the last: with few
                            keys the ways to interpolate differ more (1)
      --times LIST          times in seconds, such as 0,0.5,1.25; before the clip and
                            after it, it stands still (eight, evenly spaced)
      --json                where the joints are at these times, in the file's space
                            and unit, as JSON on standard output instead of a picture
  -h, --help                this text";

fn main() -> ExitCode {
    run(lexopt::Parser::from_env(), &mut io::stdout(), &mut io::stderr()).into()
}

/// Does what the command line says and returns the exit code. Where that is not 0, nothing was written to `out`.
pub(crate) fn run(parser: lexopt::Parser, out: &mut dyn Write, log: &mut dyn Write) -> u8 {
    let played = match arguments::parse(parser) {
        Ok(Command::Play(arguments)) => play(&arguments, log),
        Ok(Command::Help) => Ok(USAGE.to_owned()),
        Err(error) => {
            let _ = writeln!(log, "animate: {error} (--help shows the usage)");
            return 2;
        }
    };
    let said = played.and_then(|text| {
        writeln!(out, "{text}").map_err(|error| format!("cannot write to standard output: {error}").into())
    });
    match said {
        Ok(()) => 0,
        Err(error) => {
            let _ = writeln!(log, "animate: {error}");
            1
        }
    }
}

/// What is to be said on standard output when all is done.
fn play(arguments: &Arguments, log: &mut dyn Write) -> Result<String, Box<dyn Error>> {
    let source = arguments.file.as_deref().map_or_else(|| Ok(Source::figure()), Source::open)?;
    let clip = source.clip(arguments.clip.as_deref())?;
    for warning in source.warnings(clip) {
        let _ = writeln!(log, "animate: {}: warning: {warning}", source.name);
    }
    let mut player = Player::new(&source, clip, arguments.every, arguments.interpolation)?;
    match &arguments.output {
        Output::Positions => positions::json(&mut player, arguments),
        Output::Filmstrip(path) => {
            for &time in arguments.times.iter().filter(|&&time| !player.is_within(time)) {
                let _ = writeln!(log, "animate: {time} s is outside the clip, which stands still there");
            }
            let panels = panel::draw(&mut player, &arguments.times)?;
            let strip =
                Filmstrip { title: player.title(), summary: player.summary(), anatomy: player.anatomy(), panels };
            write(path, &strip.svg())?;
            Ok(format!("{}: {}\n{} poses drawn to {}", strip.title, strip.summary, strip.panels.len(), path.display()))
        }
        Output::Page(path) => {
            let page = Page::of(&mut player)?;
            write(path, &page.html())?;
            let (title, summary) = (player.title(), player.summary());
            Ok(format!("{title}: {summary}\n{} written to {}", page.content(), path.display()))
        }
    }
}

fn write(path: &Path, text: &str) -> Result<(), String> {
    fs::write(path, text).map_err(|error| format!("cannot write {}: {error}", path.display()))
}
