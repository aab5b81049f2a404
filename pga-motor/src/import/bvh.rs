//! Biovision hierarchy files (`.bvh`): a skeleton and one clip of motion, as text.
//!
//! The format has no standard. What is read here: `HIERARCHY`, one or more `ROOT`s with nested `JOINT`s and `End Site`s, then
//! `MOTION`, `Frames:`, `Frame Time:`, and one line of numbers for each frame. Keywords and channel names in capitals or not;
//! spaces or tabs; `\n`, `\r\n` or `\r`; names with spaces in them. Each joint lists its own channels, in its own order, as many
//! as it has (none, three, six, ...).
//!
//! What the numbers mean: the local motor of a joint in a frame is
//!
//! ```text
//! local = translator(OFFSET + position channels) * rotor(first rotation channel) * rotor(second) * ...
//! ```
//!
//! as three.js reads it (some programs, Blender among them, write positions of joints other than the root that have the offset in them
//! already), so the rotation listed last acts first. Angles are degrees in the file, right-handed about the joint's own axes; lengths are in
//! the file's unit, which the format does not tell. Rotations become rotors one by one, whatever their order, so nothing passes
//! through a set of angles and there is no gimbal to lock.
//!
//! ```
//! use pga_motor::import::bvh;
//! use pga_motor::skeleton::local_to_model;
//! use pga_motor::Motor;
//!
//! let text = "
//!     HIERARCHY
//!     ROOT hip { OFFSET 0 0 0 CHANNELS 6 Xposition Yposition Zposition Zrotation Xrotation Yrotation
//!         JOINT knee { OFFSET 0 -4 0 CHANNELS 3 Zrotation Xrotation Yrotation
//!             End Site { OFFSET 0 -3 0 } } }
//!     MOTION
//!     Frames: 1
//!     Frame Time: 0.0333
//!     0 9 0 90 0 0 0 0 0
//! ";
//! let file = bvh::parse::<f64>(text)?;
//! let mut pose = file.skeleton().rest_pose().clone();
//! file.pose_into(0, &mut pose)?;
//! let mut model = vec![Motor::IDENTITY; pose.len()];
//! local_to_model(file.skeleton(), &pose, &mut model)?;
//!
//! // A quarter turn about z takes the thigh, which hangs down at rest, to +x.
//! let knee = model[1].transform_origin();
//! assert!((knee.x - 4.0).abs() < 1e-12 && (knee.y - 9.0).abs() < 1e-12);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod error;
mod hierarchy;
mod motion;
mod words;

use alloc::vec::Vec;
use core::ops::Range;

pub use error::{BvhError, BvhReason, FrameError};

use crate::skeleton::{Clip, ClipError, Skeleton, SkeletonError};
use crate::{Direction, Motor, Real, Rotor, Translator};
use hierarchy::Hierarchy;
use motion::Motion;
use words::Words;

#[cfg(test)]
mod tests;

/// How many motors a clip may have, if the file does not have a sixteenth as many values.
pub const MAX_JOINT_KEYS: usize = 1 << 23;

/// A coordinate axis of a joint's frame.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Axis {
    /// The first.
    X,
    /// The second.
    Y,
    /// The third.
    Z,
}

/// What one number of a frame drives.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Channel {
    /// A displacement along an axis of the parent's frame, in the file's unit of length, on top of the joint's offset.
    Position(Axis),
    /// A right-handed rotation about an axis, in degrees.
    Rotation(Axis),
}

impl Channel {
    /// The channel's name in the file, such as `Xposition`.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Position(Axis::X) => "Xposition",
            Self::Position(Axis::Y) => "Yposition",
            Self::Position(Axis::Z) => "Zposition",
            Self::Rotation(Axis::X) => "Xrotation",
            Self::Rotation(Axis::Y) => "Yrotation",
            Self::Rotation(Axis::Z) => "Zrotation",
        }
    }
}

/// An end site: where the bone of a last joint ends. It has no motion of its own and is no joint of the skeleton, but pictures
/// want it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Tip<T> {
    /// Index of the joint that it belongs to.
    pub joint: usize,
    /// Where it is in that joint's frame, in the file's unit of length.
    pub offset: Direction<T>,
}

/// A file that has been read: its skeleton, and the values of its frames.
#[derive(Clone, Debug, PartialEq)]
pub struct Bvh<T> {
    skeleton: Skeleton<T>,
    offsets: Vec<Direction<T>>,
    tips: Vec<Tip<T>>,
    channels: Vec<Channel>,
    /// For each joint, where its channels end in `channels`; they start where those of the joint before it end.
    channel_ends: Vec<usize>,
    motion: Motion<T>,
}

/// Reads a file. What it holds is checked to the end: every number is finite, every frame complete.
///
/// Memory and time are proportional to the length of the text, whatever numbers it declares, and the depth of the hierarchy does
/// not matter.
///
/// # Errors
/// [`BvhError`], with the line and the reason, for everything that the [module](self) does not describe: words out of place,
/// missing braces, channels that are not as many as declared, numbers that are none or not finite, frames with too few or too
/// many values, fewer or more frames than declared, a file that ends early, more joints than
/// [`Skeleton::MAX_JOINTS`].
pub fn parse<T: Real>(text: &str) -> Result<Bvh<T>, BvhError> {
    let mut words = Words::of(text);
    let hierarchy = Hierarchy::parse(&mut words)?;
    let skeleton = build_skeleton(&hierarchy)?;
    let motion = Motion::parse(&mut words, &hierarchy)?;
    Ok(Bvh {
        skeleton,
        offsets: hierarchy.joints.iter().map(|joint| joint.offset()).collect(),
        channel_ends: hierarchy.channel_ends(),
        tips: hierarchy.tips,
        channels: hierarchy.channels,
        motion,
    })
}

/// The skeleton of the file, its joints in the order of the file.
fn build_skeleton<T: Real>(hierarchy: &Hierarchy<T>) -> Result<Skeleton<T>, BvhError> {
    let joints = hierarchy.joints.iter().map(|joint| {
        let rest = Motor::from(Translator::from_vector(joint.offset()));
        (joint.name.as_str(), joint.parent, rest)
    });
    let line_of = |error: &SkeletonError| error.joint().map_or(1, |joint| hierarchy.joints[joint].line);
    // The remap changes nothing: the format nests joints, so they come depth-first.
    let (skeleton, _) =
        Skeleton::from_parents(joints).map_err(|error| BvhError::new(line_of(&error), BvhReason::Skeleton(error)))?;
    Ok(skeleton)
}

impl<T> Bvh<T> {
    /// The joints in the order of the file, end sites left out. In the rest pose every joint stands at its offset, unturned.
    pub fn skeleton(&self) -> &Skeleton<T> {
        &self.skeleton
    }

    /// The end sites, in the order of the file.
    pub fn tips(&self) -> &[Tip<T>] {
        &self.tips
    }

    /// The channels of a joint, in the order of the file; none for an index at which there is no joint.
    pub fn channels(&self, joint: usize) -> &[Channel] {
        &self.channels[self.channel_range(joint)]
    }

    /// How many frames there are; may be 0.
    pub fn frame_count(&self) -> usize {
        self.motion.frame_count
    }

    /// Seconds from one frame to the next: positive, or zero where there are less than two frames.
    pub fn frame_time(&self) -> T
    where
        T: Copy,
    {
        self.motion.frame_time
    }

    /// The values of a frame as written, one for each channel of each joint; `None` where there is no such frame.
    pub fn frame(&self, frame: usize) -> Option<&[T]> {
        let width = self.channels.len();
        (frame < self.motion.frame_count).then(|| &self.motion.values[frame * width..(frame + 1) * width])
    }

    fn channel_range(&self, joint: usize) -> Range<usize> {
        match self.channel_ends.get(joint) {
            Some(&end) => joint.checked_sub(1).map_or(0, |before| self.channel_ends[before])..end,
            None => 0..0,
        }
    }
}

impl<T: Real> Bvh<T> {
    /// Writes the local motors of a frame, counted from 0, one for each joint. Nothing is allocated.
    ///
    /// # Errors
    /// [`FrameError`] where there is no such frame, or where `locals` is longer or shorter than the skeleton; `locals` is then as
    /// it was.
    pub fn pose_into(&self, frame: usize, locals: &mut [Motor<T>]) -> Result<(), FrameError> {
        let Some(values) = self.frame(frame) else {
            return Err(FrameError::OutOfRange { frame, frames: self.frame_count() });
        };
        if locals.len() != self.skeleton.len() {
            return Err(FrameError::PoseLength { expected: self.skeleton.len(), found: locals.len() });
        }
        for (joint, local) in locals.iter_mut().enumerate() {
            let range = self.channel_range(joint);
            *local = local_motor(self.offsets[joint], &self.channels[range.clone()], &values[range]);
        }
        Ok(())
    }

    /// All frames as a clip: each frame a key, the first at 0 seconds, everything between them interpolated. It has no name, as the
    /// format has none for it. It takes a motor for each joint in each frame, whether the joint has channels or not.
    ///
    /// # Errors
    /// [`ClipError::Empty`] for a file without frames. [`ClipError::TooManyKeys`] for more motors than [`MAX_JOINT_KEYS`] and than 16 for
    /// each value of the file. [`ClipError::NonFinite`] where offset and position together are too large
    /// for the scalar, [`ClipError::TimeNotFinite`] and [`ClipError::TimeNotIncreasing`] where frames are so many, or so close
    /// to each other, that it cannot tell their times.
    ///
    /// ```
    /// use pga_motor::Motor;
    /// use pga_motor::import::bvh;
    /// use pga_motor::skeleton::{Interpolation, Wrap};
    ///
    /// let text = "
    ///     HIERARCHY
    ///     ROOT hip { OFFSET 0 0 0 CHANNELS 1 Xposition }
    ///     MOTION
    ///     Frames: 2
    ///     Frame Time: 0.5
    ///     3
    ///     7
    /// ";
    /// let clip = bvh::parse::<f64>(text)?.clip()?;
    /// let mut pose = [Motor::IDENTITY];
    /// clip.sample_into(0.125, Interpolation::Split, Wrap::Clamp, &mut pose)?;
    /// assert_eq!(pose[0].transform_origin().x, 4.0);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn clip(&self) -> Result<Clip<T>, ClipError> {
        let (frames, joints) = (self.frame_count(), self.skeleton.len());
        // Joints need no channels, so motors may be many though the file is short.
        let limit = MAX_JOINT_KEYS.max(self.motion.values.len().saturating_mul(16));
        let found = frames.saturating_mul(joints);
        if found > limit {
            return Err(ClipError::TooManyKeys { limit, found });
        }
        let times = (0..frames).map(|frame| T::from_f64(frame as f64) * self.frame_time()).collect();
        let mut keys = alloc::vec![Motor::IDENTITY; frames * joints];
        for (frame, locals) in keys.chunks_exact_mut(joints).enumerate() {
            self.pose_into(frame, locals).expect("invariant: a chunk for each frame, of the skeleton's length");
        }
        Clip::new(joints, times, keys)
    }
}

/// `translator(offset + positions) * rotations`, the rotation listed first leftmost.
fn local_motor<T: Real>(offset: Direction<T>, channels: &[Channel], values: &[T]) -> Motor<T> {
    let radians = T::from_f64(core::f64::consts::PI / 180.0);
    let mut position = offset;
    let mut rotation = Rotor::IDENTITY;
    for (channel, &value) in channels.iter().zip(values) {
        match channel {
            Channel::Position(Axis::X) => position.x = position.x + value,
            Channel::Position(Axis::Y) => position.y = position.y + value,
            Channel::Position(Axis::Z) => position.z = position.z + value,
            Channel::Rotation(Axis::X) => rotation = rotation * Rotor::about_x(value * radians),
            Channel::Rotation(Axis::Y) => rotation = rotation * Rotor::about_y(value * radians),
            Channel::Rotation(Axis::Z) => rotation = rotation * Rotor::about_z(value * radians),
        }
    }
    Motor::from_rotor_translator(rotation, Translator::from_vector(position))
}
