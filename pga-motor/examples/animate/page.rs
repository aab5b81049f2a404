//! A page for a browser that plays a clip: one file that asks for no other.

use std::collections::HashMap;

use base64::Engine as _;
use base64::engine::general_purpose::STANDARD;
use pga_motor::Point;
use serde::Serialize;

use super::anatomy::Anatomy;
use super::filmstrip::escape;
use super::player::Player;
use super::tracks::{Track, Tracks};
use super::view::{TILT, View, nice};

const TEMPLATE: &str = include_str!("page/page.html");
const STYLE: &str = include_str!("page/page.css");
const SCENE: &str = include_str!("page/scene.js");
const CONTROLS: &str = include_str!("page/controls.js");

/// Beyond this the marks of keys could not be told apart.
const MOST_MARKS: usize = 2000;

/// What the page is told, as its script reads it.
#[derive(Serialize)]
pub(crate) struct Page {
    title: String,
    summary: String,
    /// Seconds of the first pose and the last.
    span: [f64; 2],
    pose_count: usize,
    /// Seconds; none if there are too many.
    keys: Vec<f64>,
    /// How many of the points are joints; the others are tips.
    joint_count: usize,
    /// For each point its name.
    names: Vec<String>,
    /// For each bone the two points and the side of the body.
    bones: Vec<(usize, usize, &'static str)>,
    heads: Vec<(usize, usize)>,
    /// The file's unit of length in one unit of the page, in which the figure is about 1 in size.
    size: f64,
    /// Between lines on the ground, in the page's unit.
    spacing: f64,
    /// Of the camera, in radians.
    turn: f64,
    tilt: f64,
    tracks: Vec<PageTrack>,
    /// Index of the track that is shown.
    shown: usize,
    /// The point whose paths are shown.
    traced: usize,
}

#[derive(Serialize)]
struct PageTrack {
    name: &'static str,
    /// Pose after pose, point after point, three numbers each: little-endian `f32` in base 64, on the ground where y is 0.
    points: String,
}

impl Page {
    pub(crate) fn of(player: &mut Player<'_>) -> Result<Self, String> {
        let tracks = Tracks::of(player)?;
        let shown = tracks.find(player.interpolation()).unwrap_or_default();
        let poses: Vec<&[Point<f64>]> = tracks.all[shown].poses.iter().map(Vec::as_slice).collect();
        let view = View::of(&poses);
        let origin = Point { y: view.ground, ..poses[0][0] };
        let Anatomy { bones, heads, .. } = player.anatomy();
        let clip = player.clip();
        Ok(Self {
            title: player.title(),
            summary: player.summary(),
            span: tracks.span,
            pose_count: tracks.pose_count(),
            keys: if clip.key_count() > MOST_MARKS { Vec::new() } else { clip.times().to_vec() },
            joint_count: player.source().joints.len(),
            names: point_names(player),
            bones: bones.iter().map(|bone| (bone.from, bone.to, bone.side.name())).collect(),
            heads,
            size: view.size,
            spacing: nice(view.size / 4.0) / view.size,
            turn: view.turn,
            tilt: TILT,
            tracks: tracks.all.iter().map(|track| PageTrack::of(track, origin, view.size)).collect(),
            shown,
            traced: tracks.most_different(),
        })
    }

    /// What is in it, for people.
    pub(crate) fn content(&self) -> String {
        let names: Vec<_> = self.tracks.iter().map(|track| track.name).collect();
        let names = names.join(", ");
        let [start, end] = self.span;
        match self.pose_count - 1 {
            0 => "one pose".to_owned(),
            steps => format!("{} poses, {:.0} a second, by {names}", self.pose_count, steps as f64 / (end - start)),
        }
    }

    pub(crate) fn html(&self) -> String {
        let data = serde_json::to_string(self).expect("names and finite numbers can be written");
        let parts = HashMap::from([
            ("title", escape(&self.title)),
            ("style", STYLE.to_owned()),
            // No name may end the script that it stands in.
            ("data", data.replace('<', "\\u003c")),
            ("script", format!("{SCENE}\n{CONTROLS}")),
        ]);
        fill(TEMPLATE, &parts)
    }
}

impl PageTrack {
    fn of(track: &Track, origin: Point<f64>, size: f64) -> Self {
        let points = track.poses.iter().flatten();
        let numbers = points.flat_map(|p| [p.x - origin.x, p.y - origin.y, p.z - origin.z]);
        let bytes: Vec<u8> = numbers.flat_map(|x| ((x / size) as f32).to_le_bytes()).collect();
        Self { name: track.interpolation.name(), points: STANDARD.encode(bytes) }
    }
}

/// A joint's name, or its number where it has none; of a tip that of its joint.
fn point_names(player: &Player<'_>) -> Vec<String> {
    let source = player.source();
    let name = |joint: usize| match source.skeleton.names()[joint].as_str() {
        "" => format!("joint {joint}"),
        name => name.to_owned(),
    };
    let joints = source.joints.iter().map(|&joint| name(joint));
    joints.chain(source.tips.iter().map(|tip| format!("end of {}", name(tip.joint)))).collect()
}

/// The template with what stands in double braces replaced.
fn fill(template: &str, parts: &HashMap<&str, String>) -> String {
    let mut filled = String::new();
    for (index, piece) in template.split("{{").enumerate() {
        match piece.split_once("}}") {
            Some((name, rest)) if index > 0 => filled.extend([parts.get(name).map_or("", String::as_str), rest]),
            _ => filled += piece,
        }
    }
    filled
}
