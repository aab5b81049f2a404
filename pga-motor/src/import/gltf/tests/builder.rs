//! Small files, written as their text.

use alloc::format;
use alloc::string::String;
use alloc::vec::Vec;

use crate::import::gltf::{Gltf, parse};
use crate::skeleton::{Interpolation, Wrap, local_to_model};
use crate::{Motor, Point};

/// A file in the making.
#[derive(Default)]
pub(super) struct Builder {
    nodes: Vec<String>,
    skins: Vec<String>,
    channels: Vec<String>,
    samplers: Vec<String>,
    accessors: Vec<String>,
    views: Vec<String>,
    bytes: Vec<u8>,
}

impl Builder {
    /// Adds a node, the members of which are given.
    pub(super) fn node(mut self, members: &str) -> Self {
        self.nodes.push(format!("{{ {members} }}"));
        self
    }

    /// Adds a skin without inverse bind matrices.
    pub(super) fn skin(mut self, joints: &str) -> Self {
        self.skins.push(format!(r#"{{ "name": "leg", "joints": {joints} }}"#));
        self
    }

    /// Adds a skin.
    pub(super) fn bound_skin(mut self, joints: &str, matrices: &[[f32; 16]]) -> Self {
        let accessor = self.floats(matrices);
        self.skins.push(format!(r#"{{ "name": "leg", "joints": {joints}, "inverseBindMatrices": {accessor} }}"#));
        self
    }

    /// Adds a channel to the animation.
    pub(super) fn channel<const N: usize>(
        mut self,
        (node, path): (usize, &str),
        interpolation: &str,
        times: &[f32],
        values: &[[f32; N]],
    ) -> Self {
        let output = self.floats(values);
        self.channel_to((node, path), interpolation, times, output)
    }

    /// Adds a channel of normalized integers to the animation, their bytes given.
    pub(super) fn normalized(mut self, node: usize, times: &[f32], component: u32, bytes: &[u8]) -> Self {
        let output = self.accessor("VEC4", component, times.len(), r#", "normalized": true"#, bytes);
        self.channel_to((node, "rotation"), "LINEAR", times, output)
    }

    fn channel_to(mut self, (node, path): (usize, &str), interpolation: &str, times: &[f32], output: usize) -> Self {
        let input = self.floats(&times.iter().map(|&time| [time]).collect::<Vec<_>>());
        let sampler = self.samplers.len();
        self.samplers
            .push(format!(r#"{{ "input": {input}, "output": {output}, "interpolation": "{interpolation}" }}"#));
        self.channels.push(format!(r#"{{ "sampler": {sampler}, "target": {{ "node": {node}, "path": "{path}" }} }}"#));
        self
    }

    fn floats<const N: usize>(&mut self, rows: &[[f32; N]]) -> usize {
        let shape = match N {
            1 => "SCALAR",
            3 => "VEC3",
            4 => "VEC4",
            _ => "MAT4",
        };
        let bytes: Vec<u8> = rows.as_flattened().iter().flat_map(|number| number.to_le_bytes()).collect();
        self.accessor(shape, 5126, rows.len(), "", &bytes)
    }

    /// Adds a view that no accessor refers to.
    pub(super) fn view(mut self, bytes: &[u8]) -> Self {
        self.push_view(bytes);
        self
    }

    fn push_view(&mut self, bytes: &[u8]) -> usize {
        let (offset, length) = (self.bytes.len(), bytes.len());
        self.views.push(format!(r#"{{ "buffer": 0, "byteOffset": {offset}, "byteLength": {length} }}"#));
        self.bytes.extend_from_slice(bytes);
        self.views.len() - 1
    }

    fn accessor(&mut self, shape: &str, component: u32, count: usize, more: &str, bytes: &[u8]) -> usize {
        let view = self.push_view(bytes);
        self.accessors.push(format!(
            r#"{{ "bufferView": {view}, "componentType": {component}, "count": {count}, "type": "{shape}"{more} }}"#
        ));
        view
    }

    /// The text, with the buffer at an address.
    pub(super) fn text_with(&self, buffer: &str) -> String {
        let list = |items: &[String]| items.join(",\n    ");
        format!(
            r#"{{
  "asset": {{ "version": "2.0" }},
  "nodes": [ {} ],
  "skins": [ {} ],
  "animations": [ {{ "name": "kick", "channels": [ {} ], "samplers": [ {} ] }} ],
  "accessors": [ {} ],
  "bufferViews": [ {} ],
  "buffers": [ {{ "byteLength": {}{buffer} }} ]
}}"#,
            list(&self.nodes),
            list(&self.skins),
            list(&self.channels),
            list(&self.samplers),
            list(&self.accessors),
            list(&self.views),
            self.bytes.len(),
        )
    }

    pub(super) fn text(&self) -> String {
        self.text_with(&format!(r#", "uri": "data:application/octet-stream;base64,{}""#, base64(&self.bytes)))
    }

    pub(super) fn bytes(&self) -> &[u8] {
        &self.bytes
    }

    /// The file as it is read.
    #[track_caller]
    pub(super) fn read(&self) -> Gltf<f64> {
        parse(self.text().as_bytes()).unwrap_or_else(|error| panic!("{error}"))
    }

    /// Why it is not read.
    #[track_caller]
    pub(super) fn error(&self) -> String {
        error(&self.text())
    }
}

#[track_caller]
pub(super) fn error(text: &str) -> String {
    alloc::string::ToString::to_string(&parse::<f64>(text.as_bytes()).expect_err("a broken file must not be read"))
}

fn base64(bytes: &[u8]) -> String {
    const DIGITS: &[u8] = b"ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    let mut text = String::new();
    for group in bytes.chunks(3) {
        let word = group.iter().enumerate().fold(0, |word, (i, &byte)| word | usize::from(byte) << (16 - 8 * i));
        (0..=group.len()).for_each(|i| text.push(DIGITS[word >> (18 - 6 * i) & 63].into()));
    }
    text
}

/// The quaternion of a turn about z, in degrees.
pub(super) fn about_z(degrees: f32) -> [f32; 4] {
    let (sin, cos) = (degrees.to_radians() / 2.0).sin_cos();
    [0.0, 0.0, sin, cos]
}

/// Where the joints are at rest.
pub(super) fn rest(file: &Gltf<f64>) -> Vec<Point<f64>> {
    places(file, file.skeleton().rest_pose())
}

/// Where the joints are in the first clip.
pub(super) fn at(file: &Gltf<f64>, time: f64) -> Vec<Point<f64>> {
    let mut pose = file.skeleton().rest_pose().clone();
    file.clips()[0].sample_into(time, Interpolation::Split, Wrap::Clamp, &mut pose).expect("buffers of one length");
    places(file, &pose)
}

fn places(file: &Gltf<f64>, pose: &[Motor<f64>]) -> Vec<Point<f64>> {
    let mut model = alloc::vec![Motor::IDENTITY; pose.len()];
    local_to_model(file.skeleton(), pose, &mut model).expect("buffers of one length");
    model.into_iter().map(Motor::transform_origin).collect()
}

/// Single precision rounds each number by 6e-8 of it, and no joint of the tests is further than some 20 away, after some ten of
/// them.
#[track_caller]
pub(super) fn assert_near(point: Point<f64>, [x, y, z]: [f64; 3]) {
    assert!(point.distance_to_point(Point::new(x, y, z)) < 2e-5, "{point:?} should be at {x}, {y}, {z}");
}
