//! The second part of the file: the frames.

use alloc::borrow::ToOwned;
use alloc::format;
use alloc::vec::Vec;

use super::error::{BvhError, BvhReason, quote};
use super::hierarchy::Hierarchy;
use super::words::{Line, Word, Words};
use crate::Real;

/// The values of all frames.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Motion<T> {
    pub(super) frame_count: usize,
    /// Seconds.
    pub(super) frame_time: T,
    /// Frame after frame, one value for each channel.
    pub(super) values: Vec<T>,
}

impl<T: Real> Motion<T> {
    /// Reads from after the keyword `MOTION` to the end of the file: the two header lines, then a line for each frame. The
    /// declared number of frames is only compared with what there is; memory is taken as values are read.
    pub(super) fn parse(words: &mut Words<'_>, hierarchy: &Hierarchy<T>) -> Result<Self, BvhError> {
        let declared = read_frame_count(words)?;
        if hierarchy.channels.is_empty() && declared > 0 {
            return Err(BvhError::new(words.last_line(), BvhReason::NoChannels { frames: declared }));
        }
        let frame_time = read_frame_time(words, declared)?;
        let mut motion = Self { frame_count: 0, frame_time, values: Vec::new() };
        motion.read_frames(words, hierarchy, declared)?;
        Ok(motion)
    }

    fn read_frames(
        &mut self,
        words: &mut Words<'_>,
        hierarchy: &Hierarchy<T>,
        declared: usize,
    ) -> Result<(), BvhError> {
        while self.frame_count < declared {
            let Some(line) = words.line() else {
                let reason = BvhReason::FrameCount { expected: declared, found: self.frame_count };
                return Err(BvhError::new(words.last_line(), reason));
            };
            self.read_frame(line, hierarchy)?;
        }
        if let Some(line) = words.line() {
            let further = 1 + core::iter::from_fn(|| words.line()).count();
            let reason = BvhReason::FrameCount { expected: declared, found: declared + further };
            return Err(BvhError::new(line.number, reason));
        }
        Ok(())
    }

    fn read_frame(&mut self, line: Line<'_>, hierarchy: &Hierarchy<T>) -> Result<(), BvhError> {
        let expected = hierarchy.channels.len();
        let found = line.words().count();
        if found != expected {
            return Err(BvhError::new(line.number, BvhReason::ValueCount { expected, found }));
        }
        for (channel, word) in line.words().enumerate() {
            let what = || format!("{} in frame {}", hierarchy.label_of_channel(channel), self.frame_count);
            self.values.push(word.number(what)?);
        }
        self.frame_count += 1;
        Ok(())
    }
}

/// `Frames: 120`.
fn read_frame_count(words: &mut Words<'_>) -> Result<usize, BvhError> {
    read_header(words, &["Frames"], "`Frames:` and the number of frames")?.count("frames")
}

/// `Frame Time: 0.0333`.
fn read_frame_time<T: Real>(words: &mut Words<'_>, frames: usize) -> Result<T, BvhError> {
    let word = read_header(words, &["Frame", "Time"], "`Frame Time:` and the seconds between frames")?;
    let time: T = word.number(|| "the time between frames".to_owned())?;
    if time < T::ZERO || (time == T::ZERO && frames > 1) {
        return Err(BvhError::new(word.line, BvhReason::FrameTime { found: quote(word.text) }));
    }
    Ok(time)
}

/// A line that is `key: value`, and nothing else; the value.
fn read_header<'a>(words: &mut Words<'a>, key: &[&str], expected: &str) -> Result<Word<'a>, BvhError> {
    let line = words.line().ok_or_else(|| words.truncated(expected))?;
    let whole = Word { text: line.text.trim_end(), line: line.number };
    let (found, value) = line.text.split_once(':').ok_or_else(|| whole.unexpected(expected))?;
    let is_key =
        found.split_whitespace().map(str::to_ascii_lowercase).eq(key.iter().map(|word| word.to_ascii_lowercase()));
    let mut values = Line { text: value, ..line }.words();
    match (values.next(), values.next()) {
        (Some(value), None) if is_key => Ok(value),
        _ => Err(whole.unexpected(expected)),
    }
}
