//! Where the joints are, for scripts.

use std::error::Error;

use serde::Serialize;

use super::arguments::Arguments;
use super::panel::POSES;
use super::player::Player;

/// What is printed.
#[derive(Serialize)]
struct Positions<'a> {
    /// As given on the command line; null for the clip written in code.
    file: Option<String>,
    /// Its name, or its index if it has none.
    clip: &'a str,
    samples: Vec<Sample<'a>>,
}

#[derive(Serialize)]
struct Sample<'a> {
    /// Seconds, as asked for.
    time: f64,
    /// In the file's order.
    joints: Vec<Place<'a>>,
}

/// A joint, in the file's world space.
#[derive(Serialize)]
struct Place<'a> {
    name: &'a str,
    position: [f64; 3],
}

/// The positions of all joints at the times asked for.
pub(crate) fn json(player: &mut Player<'_>, arguments: &Arguments) -> Result<String, Box<dyn Error>> {
    let times = if arguments.times.is_empty() { player.times(POSES) } else { arguments.times.clone() };
    let places = times.iter().map(|&time| player.points(time, player.interpolation()));
    let places = places.collect::<Result<Vec<_>, _>>()?;
    let (names, joints) = (player.source().skeleton.names(), &player.source().joints);
    let samples = times.into_iter().zip(places).map(|(time, points)| {
        let named = joints.iter().zip(points);
        let joints = named.map(|(&joint, point)| Place { name: &names[joint], position: [point.x, point.y, point.z] });
        Sample { time, joints: joints.collect() }
    });
    let file = arguments.file.as_ref().map(|path| path.display().to_string());
    Ok(serde_json::to_string(&Positions { file, clip: player.clip_name(), samples: samples.collect() })?)
}
