//! Rotation, translation and one scale: what a node, or an inverse bind matrix, may do.

use alloc::borrow::ToOwned;

use ::gltf::json::Node;

use super::error::GltfReason;
use crate::{Direction, Motor, Real, Rotor, Translator};

/// How far, relatively, scales may be apart to count as the same, and how far axes may be from perpendicular: what single
/// precision and decimal text leave behind in a chain of products is below, what is meant is above.
pub(super) const TOLERANCE: f64 = 1e-4;

/// How far a quaternion of floating-point numbers may be off unit length without a word: some roundings in single precision.
pub(super) const ROUNDING: f64 = 1e-6;

/// Scales, then rotates, then translates.
#[derive(Clone, Copy, Debug)]
pub(super) struct Similarity {
    pub(super) translation: Direction<f64>,
    pub(super) rotation: Rotor<f64>,
    /// Positive.
    pub(super) scale: f64,
    /// How far the quaternion's length was from 1, where there was one.
    pub(super) off_unit: f64,
}

impl Similarity {
    /// The transform of a node; of one with a matrix, the matrix, whatever stands beside it.
    pub(super) fn of_node(node: &Node) -> Result<Self, GltfReason> {
        if let Some(matrix) = node.matrix {
            return Self::of_matrix(matrix.map(f64::from), "entry of the matrix", TOLERANCE);
        }
        let translation = node.translation.unwrap_or_default().map(f64::from);
        let translation = finite(translation, "translation")?.into();
        let scale = uniform(node.scale.unwrap_or([1.0; 3]).map(f64::from), TOLERANCE)?;
        let quaternion = node.rotation.unwrap_or_default().0.map(f64::from);
        let (rotation, off_unit) = rotor(finite(quaternion, "rotation")?, None)?;
        Ok(Self { translation, rotation, scale, off_unit })
    }

    /// The motion and scale of a 4 x 4 matrix, entries column by column.
    pub(super) fn of_matrix(entries: [f64; 16], what: &str, tolerance: f64) -> Result<Self, GltfReason> {
        finite(entries, what)?;
        let column = |i: usize| Direction::new(entries[4 * i], entries[4 * i + 1], entries[4 * i + 2]);
        let last_row = [3, 7, 11, 15].map(|i| entries[i]);
        if last_row.iter().zip([0.0, 0.0, 0.0, 1.0]).any(|(found, expected)| (found - expected).abs() > tolerance) {
            return Err(GltfReason::NotAffine);
        }
        let axes = [0, 1, 2].map(column);
        let lengths = axes.map(Direction::norm);
        // Whether there are axes at all, before asking how they stand to each other.
        positive(lengths)?;
        let [x, y, z] = core::array::from_fn(|i| axes[i] * (1.0 / lengths[i]));
        if x.cross(y).dot(z) < 0.0 {
            return Err(GltfReason::Mirrored);
        }
        let scale = uniform(lengths, tolerance)?;
        let cosine = [x.dot(y), y.dot(z), z.dot(x)].into_iter().fold(0.0, |worst: f64, c| worst.max(c.abs()));
        if cosine > tolerance {
            return Err(GltfReason::Sheared { cosine });
        }
        // The axes are nearly perpendicular; what is missing is taken from y, and z is what remains.
        let y = (y - x * x.dot(y)).normalize().unwrap_or(y);
        let z = x.cross(y);
        let four = |d: Direction<f64>, w| [d.x, d.y, d.z, w];
        let motor = Motor::from_columns([four(x, 0.0), four(y, 0.0), four(z, 0.0), [0.0, 0.0, 0.0, 1.0]])
            .map_err(|_| GltfReason::Sheared { cosine })?;
        Ok(Self { translation: column(3), rotation: motor.rotor(), scale, off_unit: 0.0 })
    }

    /// The rigid part, with the translation scaled by what stands above it.
    pub(super) fn motor(&self, scale_above: f64) -> Motor<f64> {
        rigid(self.rotation, self.translation * scale_above)
    }
}

/// A rotation, then a translation.
pub(super) fn rigid(rotation: Rotor<f64>, translation: Direction<f64>) -> Motor<f64> {
    Motor::from_rotor_translator(rotation, Translator::from_vector(translation))
}

/// A motor in another precision.
pub(super) fn cast<T: Real>(motor: Motor<f64>) -> Motor<T> {
    let Motor { s, e23, e31, e12, e01, e02, e03, e0123 } = motor;
    let [s, e23, e31, e12, e01, e02, e03, e0123] = [s, e23, e31, e12, e01, e02, e03, e0123].map(T::from_f64);
    Motor { s, e23, e31, e12, e01, e02, e03, e0123 }
}

/// Numbers that are finite.
pub(super) fn finite<const N: usize>(numbers: [f64; N], what: &str) -> Result<[f64; N], GltfReason> {
    if numbers.iter().all(|number| number.is_finite()) {
        Ok(numbers)
    } else {
        Err(GltfReason::NotFinite { what: what.to_owned() })
    }
}

/// The rotor of a quaternion of any length but 0, and how far that is from 1.
pub(super) fn rotor(quaternion: [f64; 4], key: Option<usize>) -> Result<(Rotor<f64>, f64), GltfReason> {
    let rotor = Rotor::from_quaternion_xyzw(quaternion).ok_or(GltfReason::ZeroRotation { key })?;
    let length = quaternion.iter().map(|x| x * x).sum::<f64>().sqrt();
    Ok((rotor, (length - 1.0).abs()))
}

fn positive(scale: [f64; 3]) -> Result<[f64; 3], GltfReason> {
    finite(scale, "scale")?;
    if scale.iter().any(|&factor| factor < 0.0) {
        return Err(GltfReason::Mirrored);
    }
    // Quotients of subnormal numbers need not be numbers.
    if scale.iter().all(|factor| factor.is_normal()) { Ok(scale) } else { Err(GltfReason::ZeroScale) }
}

/// The one factor that three factors are, to the tolerance.
fn uniform(scale: [f64; 3], tolerance: f64) -> Result<f64, GltfReason> {
    let [x, y, z] = positive(scale)?;
    let (least, greatest) = (x.min(y).min(z), x.max(y).max(z));
    if greatest - least > tolerance * greatest {
        return Err(GltfReason::NotUniform { scale });
    }
    Ok(x / 3.0 + y / 3.0 + z / 3.0)
}
