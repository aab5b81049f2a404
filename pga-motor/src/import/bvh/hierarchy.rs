//! The first part of the file: joints, their offsets and channels.

use alloc::format;
use alloc::string::String;
use alloc::vec::Vec;

use super::error::{BvhError, BvhReason, quote};
use super::words::{Word, Words};
use super::{Axis, Channel, Tip};
use crate::{Direction, Real};

/// What the file says about its joints. They come out depth-first, as the format nests them.
pub(super) struct Hierarchy<T> {
    pub(super) joints: Vec<ListedJoint<T>>,
    /// All channels of all joints, in the order in which a frame gives their values.
    pub(super) channels: Vec<Channel>,
    pub(super) tips: Vec<Tip<T>>,
}

pub(super) struct ListedJoint<T> {
    pub(super) name: String,
    /// The line it starts on.
    pub(super) line: usize,
    pub(super) parent: Option<usize>,
    offset: Option<Direction<T>>,
    /// Where its channels end in `Hierarchy::channels`; they start where those of the joint before it end.
    channels_end: Option<usize>,
    has_children: bool,
}

impl<T: Real> ListedJoint<T> {
    /// From the parent's origin to this joint's, in the parent's frame.
    pub(super) fn offset(&self) -> Direction<T> {
        self.offset.expect("invariant: a joint is not closed before it has its offset")
    }

    fn label(&self) -> String {
        format!("joint `{}`", quote(&self.name))
    }
}

impl<T: Real> Hierarchy<T> {
    /// Reads from the start of the file up to and with the keyword `MOTION`. The joints that are open are kept on a stack of
    /// our own, so that the depth of the file does not matter.
    pub(super) fn parse(words: &mut Words<'_>) -> Result<Self, BvhError> {
        let mut hierarchy = Self { joints: Vec::new(), channels: Vec::new(), tips: Vec::new() };
        let first = words.expect("`HIERARCHY`")?;
        if !first.is("HIERARCHY") {
            return Err(first.unexpected("`HIERARCHY`"));
        }
        let mut open = Vec::new();
        loop {
            match open.last() {
                Some(&joint) => hierarchy.continue_joint(words, joint, &mut open)?,
                None if hierarchy.starts_root(words)? => hierarchy.open_joint(words, &mut open)?,
                None => return Ok(hierarchy),
            }
        }
    }

    /// For each joint, where its channels end in `channels`.
    pub(super) fn channel_ends(&self) -> Vec<usize> {
        let ends = self.joints.iter().scan(0, |end, joint| {
            *end = joint.channels_end.unwrap_or(*end);
            Some(*end)
        });
        ends.collect()
    }

    /// A channel and its joint, for messages: `Xrotation` of joint `knee`.
    pub(super) fn label_of_channel(&self, channel: usize) -> String {
        let name = self.channels[channel].name();
        let joint = self.channel_ends().iter().position(|&end| channel < end);
        let joint = joint.expect("invariant: every channel is a joint's");
        format!("`{name}` of {}", self.joints[joint].label())
    }

    /// Outside all joints: another root begins, or the hierarchy has come to its end.
    fn starts_root(&self, words: &mut Words<'_>) -> Result<bool, BvhError> {
        let expected = if self.joints.is_empty() { "`ROOT`" } else { "`ROOT` or `MOTION`" };
        let word = words.expect(expected)?;
        match word {
            _ if word.is("ROOT") => Ok(true),
            _ if word.is("MOTION") && !self.joints.is_empty() => Ok(false),
            _ => Err(word.unexpected(expected)),
        }
    }

    /// After `ROOT` or `JOINT`: the name and the opening brace.
    fn open_joint(&mut self, words: &mut Words<'_>, open: &mut Vec<usize>) -> Result<(), BvhError> {
        let line = words.last_line();
        let name = words.name();
        if name.is_empty() {
            return Err(BvhError::new(line, BvhReason::Missing { expected: "the name of a joint".into() }));
        }
        let joint = ListedJoint {
            name: name.into(),
            line,
            parent: open.last().copied(),
            offset: None,
            channels_end: None,
            has_children: false,
        };
        expect_brace(words, "{", &joint.label())?;
        open.push(self.joints.len());
        self.joints.push(joint);
        Ok(())
    }

    /// Inside a joint: the next thing in it.
    fn continue_joint(&mut self, words: &mut Words<'_>, joint: usize, open: &mut Vec<usize>) -> Result<(), BvhError> {
        let label = self.joints[joint].label();
        let word = words.next().ok_or_else(|| words.truncated(&format!("`}}` of {label}")))?;
        match word {
            _ if word.is("OFFSET") => self.read_offset(words, word, joint),
            _ if word.is("CHANNELS") => self.read_channels(words, word, joint),
            _ if word.is("JOINT") => {
                self.joints[joint].has_children = true;
                self.open_joint(words, open)
            }
            _ if word.is("End") => self.read_end_site(words, joint),
            _ if word.is("}") => {
                open.pop();
                self.close_joint(word, joint)
            }
            _ if ["ROOT", "MOTION"].iter().any(|keyword| word.is(keyword)) => {
                Err(BvhError::new(word.line, missing_brace("}", &label, word)))
            }
            _ => Err(word.unexpected(&format!("`OFFSET`, `CHANNELS`, `JOINT`, `End Site` or `}}` in {label}"))),
        }
    }

    fn read_offset(&mut self, words: &mut Words<'_>, keyword: Word<'_>, joint: usize) -> Result<(), BvhError> {
        let joint = &mut self.joints[joint];
        if joint.offset.is_some() {
            let what = format!("`OFFSET` in {}", joint.label());
            return Err(BvhError::new(keyword.line, BvhReason::Repeated { what }));
        }
        joint.offset = Some(read_direction(words, &joint.label())?);
        Ok(())
    }

    fn close_joint(&self, brace: Word<'_>, joint: usize) -> Result<(), BvhError> {
        let joint = &self.joints[joint];
        if joint.offset.is_none() {
            let expected = format!("an `OFFSET` in {}", joint.label());
            return Err(BvhError::new(brace.line, BvhReason::Missing { expected }));
        }
        Ok(())
    }

    fn read_channels(&mut self, words: &mut Words<'_>, keyword: Word<'_>, joint: usize) -> Result<(), BvhError> {
        let label = self.joints[joint].label();
        let fault = |reason| Err(BvhError::new(keyword.line, reason));
        if self.joints[joint].channels_end.is_some() {
            return fault(BvhReason::Repeated { what: format!("`CHANNELS` in {label}") });
        }
        if self.joints[joint].has_children {
            // The values of a frame would be in another order than the joints.
            return fault(BvhReason::Missing { expected: format!("`CHANNELS` of {label} before its first `JOINT`") });
        }
        let expected = words.expect("the number of channels")?.count("channels")?;
        let start = self.channels.len();
        while let Some(channel) = words.peek().and_then(|word| Channel::from_name(word.text)) {
            words.next();
            if matches!(channel, Channel::Position(_)) && self.channels[start..].contains(&channel) {
                return fault(BvhReason::Repeated { what: format!("`{}` in {label}", channel.name()) });
            }
            self.channels.push(channel);
        }
        self.joints[joint].channels_end = Some(self.channels.len());
        let found = self.channels.len() - start;
        match words.peek_on_line().filter(|word| !is_structure(word)) {
            Some(word) => fault(BvhReason::UnknownChannel { joint: label, found: quote(word.text) }),
            None if found != expected => fault(BvhReason::ChannelCount { joint: label, expected, found }),
            None => Ok(()),
        }
    }

    /// After `End`: `Site`, and a body of nothing but an offset.
    fn read_end_site(&mut self, words: &mut Words<'_>, joint: usize) -> Result<(), BvhError> {
        let label = format!("the end site of {}", self.joints[joint].label());
        let site = words.expect("`Site`")?;
        if !site.is("Site") {
            return Err(site.unexpected("`Site`"));
        }
        expect_brace(words, "{", &label)?;
        let keyword = words.expect(&format!("an `OFFSET` in {label}"))?;
        if keyword.is("}") {
            let expected = format!("an `OFFSET` in {label}");
            return Err(BvhError::new(keyword.line, BvhReason::Missing { expected }));
        }
        if !keyword.is("OFFSET") {
            return Err(keyword.unexpected(&format!("`OFFSET` in {label}")));
        }
        self.tips.push(Tip { joint, offset: read_direction(words, &label)? });
        expect_brace(words, "}", &label)
    }
}

impl Channel {
    fn from_name(name: &str) -> Option<Self> {
        let kinds = [Channel::Position as fn(Axis) -> Self, Channel::Rotation];
        let axes = [Axis::X, Axis::Y, Axis::Z];
        let mut all = kinds.into_iter().flat_map(|kind| axes.into_iter().map(kind));
        all.find(|channel| channel.name().eq_ignore_ascii_case(name))
    }
}

/// Whether a word may follow a list of channels on the same line.
fn is_structure(word: &Word<'_>) -> bool {
    ["JOINT", "End", "OFFSET", "CHANNELS", "{", "}"].iter().any(|keyword| word.is(keyword))
}

fn read_direction<T: Real>(words: &mut Words<'_>, label: &str) -> Result<Direction<T>, BvhError> {
    let mut coordinate = |axis| {
        let what = || format!("{axis} of the `OFFSET` of {label}");
        words.next().ok_or_else(|| words.truncated(&what()))?.number(what)
    };
    Ok(Direction::new(coordinate("x")?, coordinate("y")?, coordinate("z")?))
}

fn expect_brace(words: &mut Words<'_>, brace: &str, label: &str) -> Result<(), BvhError> {
    let word = words.next().ok_or_else(|| words.truncated(&format!("`{brace}` of {label}")))?;
    if word.is(brace) { Ok(()) } else { Err(BvhError::new(word.line, missing_brace(brace, label, word))) }
}

fn missing_brace(brace: &str, label: &str, word: Word<'_>) -> BvhReason {
    BvhReason::MissingBrace { expected: format!("`{brace}` of {label}"), found: quote(word.text) }
}
