//! What the format says, by 4 x 4 matrices in double precision, straight from the JSON: shares no code with the importer.

use std::error::Error;
use std::fs;
use std::path::Path;

use serde_json::Value;

pub(crate) type Outcome<T = ()> = Result<T, Box<dyn Error>>;

/// By rows.
pub(crate) type Matrix = [[f64; 4]; 4];

/// A file, its buffers loaded.
pub(crate) struct Raw {
    json: Value,
    buffers: Vec<Vec<u8>>,
    parents: Vec<Option<usize>>,
}

impl Raw {
    pub(crate) fn read(path: &Path) -> Outcome<Self> {
        let bytes = fs::read(path)?;
        let word = |at: usize| u32::from_le_bytes(bytes[at..at + 4].try_into().expect("four bytes")) as usize;
        let (json, blob) = if bytes.starts_with(b"glTF") {
            let end = 20 + word(12);
            (serde_json::from_slice::<Value>(&bytes[20..end])?, bytes[end + 8..end + 8 + word(end)].to_vec())
        } else {
            (serde_json::from_slice(&bytes)?, Vec::new())
        };
        let buffers = list(&json["buffers"]).iter().map(|buffer| match buffer["uri"].as_str() {
            None => blob.clone(),
            Some(uri) => base64(uri.split_once(";base64,").expect("buffers are in data addresses").1),
        });
        let buffers = buffers.collect();
        let mut parents = vec![None; list(&json["nodes"]).len()];
        for (parent, node) in list(&json["nodes"]).iter().enumerate() {
            list(&node["children"]).iter().for_each(|child| parents[number(child)] = Some(parent));
        }
        Ok(Self { json, buffers, parents })
    }

    pub(crate) fn animations(&self) -> usize {
        list(&self.json["animations"]).len()
    }

    /// The matrix from each node to the file's space: at rest, or in an animation at a time.
    pub(crate) fn world(&self, at: Option<(usize, f64)>) -> Vec<Matrix> {
        let locals: Vec<Matrix> = (0..self.parents.len()).map(|node| self.local(node, at)).collect();
        let chain = |node: usize| {
            let above = std::iter::successors(self.parents[node], |&parent| self.parents[parent]);
            above.fold(locals[node], |product, parent| multiply(locals[parent], product))
        };
        (0..locals.len()).map(chain).collect()
    }

    /// The joints of each skin as nodes, with their inverse bind matrices.
    pub(crate) fn skins(&self) -> Vec<Vec<(usize, Matrix)>> {
        let skin = |skin: &Value| {
            let joints = list(&skin["joints"]).iter().map(number);
            let matrix = |joint: usize| match &skin["inverseBindMatrices"] {
                Value::Null => IDENTITY,
                accessor => by_columns(&self.element(number(accessor), joint)),
            };
            joints.enumerate().map(|(joint, node)| (node, matrix(joint))).collect()
        };
        list(&self.json["skins"]).iter().map(skin).collect()
    }

    /// A vertex of the first mesh: its place, the joints of the skin that move it, and how much.
    pub(crate) fn vertex(&self, vertex: usize) -> ([f64; 3], [u16; 4], [f64; 4]) {
        let attributes = &self.json["meshes"][0]["primitives"][0]["attributes"];
        let read = |name: &str| self.element(number(&attributes[name]), vertex);
        let (place, joints, weights) = (read("POSITION"), read("JOINTS_0"), read("WEIGHTS_0"));
        // Whole numbers here, which `element` divides as if they were fractions.
        let joints = std::array::from_fn(|i| (joints[i] * 65535.0).round() as u16);
        (std::array::from_fn(|i| place[i]), joints, std::array::from_fn(|i| weights[i]))
    }

    fn local(&self, index: usize, at: Option<(usize, f64)>) -> Matrix {
        let node = &self.json["nodes"][index];
        let part = |name: &str, rest: &[f64]| {
            let rest = node[name].as_array().map_or_else(|| rest.to_vec(), |list| list.iter().map(real).collect());
            at.and_then(|(animation, time)| self.sample(animation, index, name, time)).unwrap_or(rest)
        };
        if let Some(matrix) = node["matrix"].as_array() {
            return by_columns(&matrix.iter().map(real).collect::<Vec<_>>());
        }
        let t = part("translation", &[0.0; 3]);
        let q = unit(part("rotation", &[0.0, 0.0, 0.0, 1.0]));
        let s = part("scale", &[1.0; 3]);
        let [x, y, z, w] = [q[0], q[1], q[2], q[3]];
        let rotation = [
            [1.0 - 2.0 * (y * y + z * z), 2.0 * (x * y - w * z), 2.0 * (x * z + w * y)],
            [2.0 * (x * y + w * z), 1.0 - 2.0 * (x * x + z * z), 2.0 * (y * z - w * x)],
            [2.0 * (x * z - w * y), 2.0 * (y * z + w * x), 1.0 - 2.0 * (x * x + y * y)],
        ];
        let mut matrix = IDENTITY;
        for (row, entries) in rotation.iter().enumerate() {
            (0..3).for_each(|column| matrix[row][column] = entries[column] * s[column]);
            matrix[row][3] = t[row];
        }
        matrix
    }

    /// What a node's property is in an animation; `None` where no channel drives it.
    fn sample(&self, animation: usize, node: usize, path: &str, time: f64) -> Option<Vec<f64>> {
        let animation = &self.json["animations"][animation];
        let mut channels = list(&animation["channels"]).iter();
        let channel =
            channels.find(|c| c["target"]["node"].as_u64() == Some(node as u64) && c["target"]["path"] == path)?;
        let sampler = &animation["samplers"][number(&channel["sampler"])];
        let (input, output) = (number(&sampler["input"]), number(&sampler["output"]));
        let times: Vec<f64> = (0..self.count(input)).map(|key| self.element(input, key)[0]).collect();
        let is_cubic = sampler["interpolation"] == "CUBICSPLINE";
        let value = |key: usize| self.element(output, if is_cubic { 3 * key + 1 } else { key });
        let last = times.len() - 1;
        if time < times[0] {
            return Some(value(0));
        }
        let key = times.iter().rposition(|&key| key <= time).expect("the first key is at or before the time");
        if key == last {
            return Some(value(last));
        }
        let span = times[key + 1] - times[key];
        let t = (time - times[key]) / span;
        let (a, b) = (value(key), value(key + 1));
        Some(match sampler["interpolation"].as_str() {
            Some("STEP") => a,
            Some("CUBICSPLINE") => {
                let (out, into) = (self.element(output, 3 * key + 2), self.element(output, 3 * key + 3));
                let (t2, t3) = (t * t, t * t * t);
                let at = |i: usize| {
                    (2.0 * t3 - 3.0 * t2 + 1.0) * a[i]
                        + span * (t3 - 2.0 * t2 + t) * out[i]
                        + (3.0 * t2 - 2.0 * t3) * b[i]
                        + span * (t3 - t2) * into[i]
                };
                (0..a.len()).map(at).collect()
            }
            _ if path == "rotation" => great_arc(unit(a), unit(b), t),
            _ => a.iter().zip(&b).map(|(a, b)| a + t * (b - a)).collect(),
        })
    }

    fn count(&self, accessor: usize) -> usize {
        number(&self.json["accessors"][accessor]["count"])
    }

    fn element(&self, accessor: usize, index: usize) -> Vec<f64> {
        let accessor = &self.json["accessors"][accessor];
        let view = &self.json["bufferViews"][number(&accessor["bufferView"])];
        let width = match accessor["type"].as_str() {
            Some("SCALAR") => 1,
            Some("VEC3") => 3,
            Some("VEC4") => 4,
            _ => 16,
        };
        let kind = number(&accessor["componentType"]);
        let size = if kind == 5126 {
            4
        } else if kind >= 5122 {
            2
        } else {
            1
        };
        let offset = |value: &Value| value.as_u64().unwrap_or(0) as usize;
        let start = offset(&view["byteOffset"]) + offset(&accessor["byteOffset"]);
        let stride = view["byteStride"].as_u64().map_or(width * size, |stride| stride as usize);
        let bytes = &self.buffers[number(&view["buffer"])][start + index * stride..];
        let component = |i: usize| {
            let b = &bytes[i * size..];
            match kind {
                5120 => f64::from(b[0] as i8) / 127.0,
                5121 => f64::from(b[0]) / 255.0,
                5122 => f64::from(i16::from_le_bytes([b[0], b[1]])) / 32767.0,
                5123 => f64::from(u16::from_le_bytes([b[0], b[1]])) / 65535.0,
                _ => f64::from(f32::from_le_bytes([b[0], b[1], b[2], b[3]])),
            }
        };
        (0..width).map(component).collect()
    }
}

const IDENTITY: Matrix = [[1.0, 0.0, 0.0, 0.0], [0.0, 1.0, 0.0, 0.0], [0.0, 0.0, 1.0, 0.0], [0.0, 0.0, 0.0, 1.0]];

pub(crate) fn multiply(a: Matrix, b: Matrix) -> Matrix {
    std::array::from_fn(|i| std::array::from_fn(|j| (0..4).map(|k| a[i][k] * b[k][j]).sum()))
}

/// Where a matrix takes a point.
pub(crate) fn apply(a: Matrix, point: [f64; 3]) -> [f64; 3] {
    std::array::from_fn(|i| a[i][3] + (0..3).map(|j| a[i][j] * point[j]).sum::<f64>())
}

fn by_columns(entries: &[f64]) -> Matrix {
    std::array::from_fn(|row| std::array::from_fn(|column| entries[4 * column + row]))
}

fn unit(mut q: Vec<f64>) -> Vec<f64> {
    let norm = q.iter().map(|x| x * x).sum::<f64>().sqrt();
    q.iter_mut().for_each(|x| *x /= norm);
    q
}

/// The format's appendix C.4.
fn great_arc(a: Vec<f64>, b: Vec<f64>, t: f64) -> Vec<f64> {
    let dot: f64 = a.iter().zip(&b).map(|(a, b)| a * b).sum();
    let sign = if dot < 0.0 { -1.0 } else { 1.0 };
    let angle = dot.abs().min(1.0).acos();
    let [p, q] = if angle < 1e-6 { [1.0 - t, t] } else { [1.0 - t, t].map(|part| (part * angle).sin() / angle.sin()) };
    a.iter().zip(&b).map(|(a, b)| p * a + sign * q * b).collect()
}

fn list(value: &Value) -> &[Value] {
    value.as_array().map_or(&[], Vec::as_slice)
}

fn number(value: &Value) -> usize {
    value.as_u64().expect("indices and counts are whole numbers") as usize
}

/// A number of the JSON, which is meant in single precision.
fn real(value: &Value) -> f64 {
    f64::from(value.as_f64().expect("entries are numbers") as f32)
}

pub(crate) fn base64(text: &str) -> Vec<u8> {
    let digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    let bits =
        text.chars().filter_map(|digit| digits.find(digit)).flat_map(|d| (0..6).rev().map(move |bit| d >> bit & 1));
    let bits: Vec<usize> = bits.collect();
    bits.chunks_exact(8).map(|byte| byte.iter().fold(0, |byte, &bit| byte << 1 | bit as u8)).collect()
}
