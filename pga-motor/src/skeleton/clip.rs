//! A clip of motion: poses at certain times.

mod cache;
mod error;
mod sample;

use alloc::string::String;
use alloc::vec::Vec;

pub use cache::ScrewCache;
pub use error::ClipError;
pub(super) use sample::joint_between;
pub use sample::{Interpolation, KeySpan, Wrap};

use super::rigidity::Rigidity;
use crate::{Motor, Real, kernels};

#[cfg(test)]
mod tests;

/// How one part of a joint's motion gets from a key to the next.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum KeyMode {
    /// It keeps the value of the key before.
    Step,
    /// It is interpolated.
    #[default]
    Linear,
}

/// How a joint gets from a key to the next: files mix the two within one clip, and within one joint.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct JointModes {
    /// Of its rotation.
    pub rotation: KeyMode,
    /// Of its translation.
    pub translation: KeyMode,
}

/// A clip: for each of some increasing times in seconds a key, and in each key one local motor for each joint.
///
/// Keys lie one after the other, all joints of a key together. From key to key a joint's motors have the sign that makes them
/// nearest to each other, though m and -m are the same motion. Every motor is finite, and unit up to rounding.
///
/// ```
/// use pga_motor::f64::{Clip, Direction, Motor, Rotor, Translator};
/// use pga_motor::skeleton::{Interpolation, Wrap};
///
/// let raised = Translator::from_vector(Direction::new(0.0, 0.0, 4.0)) * Rotor::about_z(1.0);
/// let clip = Clip::new(1, vec![0.0, 2.0], vec![Motor::IDENTITY, raised])?;
/// let mut pose = vec![Motor::IDENTITY; 1];
/// clip.sample_into(0.5, Interpolation::Split, Wrap::Clamp, &mut pose)?;
/// assert!((pose[0].transform_origin().z - 1.0).abs() < 1e-15);
/// # Ok::<(), pga_motor::skeleton::ClipError>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Clip<T> {
    name: String,
    joint_count: usize,
    times: Vec<T>,
    keys: Vec<Motor<T>>,
    modes: Vec<JointModes>,
    /// Whether all modes are linear, so that sampling need not ask.
    all_linear: bool,
}

impl<T> Clip<T> {
    /// What it is called; may be empty.
    pub fn name(&self) -> &str {
        &self.name
    }

    /// The clip with a name.
    pub fn with_name(mut self, name: impl Into<String>) -> Self {
        self.name = name.into();
        self
    }

    /// How many joints it moves.
    pub fn joint_count(&self) -> usize {
        self.joint_count
    }

    /// How many keys there are; never 0.
    pub fn key_count(&self) -> usize {
        self.times.len()
    }

    /// The times of the keys in seconds, increasing.
    pub fn times(&self) -> &[T] {
        &self.times
    }

    /// The local motors of a key, one for each joint; `None` where there is no such key.
    pub fn key(&self, key: usize) -> Option<&[Motor<T>]> {
        (key < self.key_count()).then(|| self.joints_of(key))
    }

    /// How each joint gets from a key to the next.
    pub fn modes(&self) -> &[JointModes] {
        &self.modes
    }

    /// The time of the first key, in seconds.
    pub fn start(&self) -> T
    where
        T: Copy,
    {
        self.times[0]
    }

    /// The time of the last key, in seconds.
    pub fn end(&self) -> T
    where
        T: Copy,
    {
        self.times[self.times.len() - 1]
    }

    pub(super) fn joints_of(&self, key: usize) -> &[Motor<T>] {
        &self.keys[key * self.joint_count..(key + 1) * self.joint_count]
    }
}

impl<T: Real> Clip<T> {
    /// A clip in which everything is interpolated, see [`Clip::with_modes`] for others.
    ///
    /// `keys` has the motors of all `joint_count` joints for the first of `times`, in the skeleton's order, then those for the
    /// second, and so on. Motors that are off unit by more than rounding, and by less than 1e-3, are brought back; signs are
    /// aligned to the key before.
    ///
    /// # Errors
    /// [`ClipError::Empty`] without joints or keys, [`ClipError::KeyCount`], and of the keys
    /// [`ClipError::TimeNotFinite`], [`ClipError::TimeNotIncreasing`], [`ClipError::NonFinite`],
    /// [`ClipError::ZeroKey`], [`ClipError::NotRigid`].
    pub fn new(joint_count: usize, times: Vec<T>, mut keys: Vec<Motor<T>>) -> Result<Self, ClipError> {
        if joint_count == 0 || times.is_empty() {
            return Err(ClipError::Empty { joints: joint_count, keys: times.len() });
        }
        let expected = times.len().saturating_mul(joint_count);
        if keys.len() != expected {
            return Err(ClipError::KeyCount { expected, found: keys.len() });
        }
        check_times(&times)?;
        let rigidity = Rigidity::among(&keys);
        for index in 0..keys.len() {
            let (key, joint) = (index / joint_count, index % joint_count);
            let motor = check_key(&rigidity, keys[index], key, joint)?;
            let before = index.checked_sub(joint_count).map(|before| keys[before]);
            keys[index] = before.map_or(motor, |before| nearest_sign(before, motor));
        }
        let modes = alloc::vec![JointModes::default(); joint_count];
        Ok(Self { name: String::new(), joint_count, times, keys, modes, all_linear: true })
    }

    /// The clip with these ways to get from key to key, one for each joint.
    ///
    /// # Errors
    /// [`ClipError::ModeCount`] where there is not one for each joint.
    pub fn with_modes(mut self, modes: Vec<JointModes>) -> Result<Self, ClipError> {
        if modes.len() != self.joint_count {
            return Err(ClipError::ModeCount { expected: self.joint_count, found: modes.len() });
        }
        self.all_linear = modes.iter().all(|&modes| modes == JointModes::default());
        self.modes = modes;
        Ok(self)
    }

    /// Seconds from the first key to the last; 0 where there is only one.
    pub fn duration(&self) -> T {
        self.end() - self.start()
    }
}

fn check_times<T: Real>(times: &[T]) -> Result<(), ClipError> {
    if let Some(key) = times.iter().position(|time| !time.is_finite()) {
        return Err(ClipError::TimeNotFinite { key });
    }
    match times.windows(2).position(|pair| pair[0] >= pair[1]) {
        Some(before) => Err(ClipError::TimeNotIncreasing { key: before + 1 }),
        None => Ok(()),
    }
}

/// The motor, brought back to unit if it is a little off.
fn check_key<T: Real>(
    rigidity: &Rigidity<T>,
    motor: Motor<T>,
    key: usize,
    joint: usize,
) -> Result<Motor<T>, ClipError> {
    if !motor.is_finite() {
        return Err(ClipError::NonFinite { key, joint });
    }
    let Motor { s, e23, e31, e12, .. } = motor;
    if [s, e23, e31, e12] == [T::ZERO; 4] {
        return Err(ClipError::ZeroKey { key, joint });
    }
    rigidity.brought_back(motor).ok_or(ClipError::NotRigid { key, joint })
}

/// The motor or its negative, the same motion, whichever is nearer in its rotation.
fn nearest_sign<T: Real>(reference: Motor<T>, motor: Motor<T>) -> Motor<T> {
    if kernels::rotor_scalar_product_rotor(reference.rotor(), motor.rotor()) < T::ZERO { -motor } else { motor }
}
