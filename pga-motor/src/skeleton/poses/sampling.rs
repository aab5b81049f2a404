//! One clip at many times at once.

use crate::batch::{Fusible, LANES, LaneCount, MotorBlock, OnBlock, Pair, Travel, choose};
use crate::instructions::{Work, dispatch};
use crate::scalar::Fused;
use crate::skeleton::clip::joint_between;
use crate::skeleton::{Clip, Interpolation, JointModes, KeySpan, Wrap};
use crate::{Motor, Real};

/// Where the times of a group of characters lie in a clip.
pub(super) struct Spans<'a, T> {
    clip: &'a Clip<T>,
    /// Lanes past the last character are as its own.
    spans: [KeySpan<T>; LANES],
}

impl<'a, T: Real> Spans<'a, T> {
    /// For 1 to [`LANES`] times, all finite.
    pub(super) fn new(clip: &'a Clip<T>, times: &[T], wrap: Wrap) -> Self {
        let span = |lane: usize| {
            let time = times[lane.min(times.len() - 1)];
            clip.keys_around(clip.wrapped(time, wrap).map_or(time, |(time, _)| time))
        };
        Self { clip, spans: core::array::from_fn(span) }
    }

    /// Writes the group's local motors, one block for each joint.
    pub(super) fn sample(&self, interpolation: Interpolation, joints: &mut [MotorBlock<T>]) {
        let Some(way) = interpolation.way() else { return self.hold(joints) };
        choose(way, true, Sampling { spans: self, joints: &mut *joints });
        // The few joints of which a part holds its key.
        for (joint, &modes) in
            self.clip.modes().iter().enumerate().filter(|(_, modes)| **modes != JointModes::default())
        {
            for (lane, span) in self.spans.iter().enumerate() {
                let (a, b) = (self.key(span.before, joint), self.key(span.after, joint));
                joints[joint].put(lane, joint_between(modes, way.of_one(), a, b, span.fraction));
            }
        }
    }

    /// The keys before.
    fn hold(&self, joints: &mut [MotorBlock<T>]) {
        for (joint, block) in joints.iter_mut().enumerate() {
            for (lane, span) in self.spans.iter().enumerate() {
                block.put(lane, self.key(span.before, joint));
            }
        }
    }

    #[inline(always)]
    fn key(&self, key: usize, joint: usize) -> Motor<T> {
        self.clip.joints_of(key)[joint]
    }

    /// The keys around all of the times, where they are the same.
    fn common_keys(&self) -> Option<(usize, usize)> {
        let keys = |span: &KeySpan<T>| (span.before, span.after);
        let first = keys(&self.spans[0]);
        self.spans.iter().all(|span| keys(span) == first).then_some(first)
    }
}

struct Sampling<'a, T: Real> {
    spans: &'a Spans<'a, T>,
    joints: &'a mut [MotorBlock<T>],
}

impl<T: Real> Travel<T> for Sampling<'_, T> {
    type Output = ();

    #[inline(always)]
    fn travel(self, plain: impl OnBlock<Pair<T>, Motor<T>>, fused: impl OnBlock<Pair<Fused<T>>, Motor<Fused<T>>>) {
        dispatch(Sampled { sampling: self, plain, fused });
    }
}

struct Sampled<'a, T: Real, P, F> {
    sampling: Sampling<'a, T>,
    plain: P,
    fused: F,
}

impl<T: Real> Sampling<'_, T> {
    #[inline(always)]
    fn run_with(
        self,
        mut between: impl FnMut(LaneCount, &MotorBlock<T>, &MotorBlock<T>, &[T; LANES], &mut MotorBlock<T>),
    ) {
        let (spans, lanes) = (self.spans, LaneCount::new());
        let fractions = spans.spans.map(|span| span.fraction);
        if let Some((before, after)) = spans.common_keys() {
            let keys = spans.clip.joints_of(before).iter().zip(spans.clip.joints_of(after));
            for (block, (&a, &b)) in self.joints.iter_mut().zip(keys) {
                between(lanes, &MotorBlock::of(a), &MotorBlock::of(b), &fractions, block);
            }
            return;
        }
        let (mut a, mut b) = (MotorBlock::of(Motor::IDENTITY), MotorBlock::of(Motor::IDENTITY));
        let before = spans.spans.map(|span| spans.clip.joints_of(span.before));
        let after = spans.spans.map(|span| spans.clip.joints_of(span.after));
        for (joint, block) in self.joints.iter_mut().enumerate() {
            a.gather(&before.map(|key| key[joint]));
            b.gather(&after.map(|key| key[joint]));
            between(lanes, &a, &b, &fractions, block);
        }
    }
}

impl<T, P, F> Work for Sampled<'_, T, P, F>
where
    T: Real,
    P: OnBlock<Pair<T>, Motor<T>>,
    F: OnBlock<Pair<Fused<T>>, Motor<Fused<T>>>,
{
    #[inline(always)]
    fn run(self) {
        let Self { sampling, plain, .. } = self;
        sampling.run_with(
            #[inline(always)]
            |lanes, a, b, fractions, block| {
                plain.run(
                    lanes,
                    |lane| Pair { a: a.get(lane), b: b.get(lane), t: fractions[lane] },
                    |lane, motor| block.put(lane, motor),
                );
            },
        );
    }

    #[inline(always)]
    fn run_fused(self) {
        let Self { sampling, fused, .. } = self;
        sampling.run_with(
            #[inline(always)]
            |lanes, a, b, fractions, block| {
                fused.run(
                    lanes,
                    |lane| Pair { a: a.get(lane).fuse(), b: b.get(lane).fuse(), t: Fused(fractions[lane]) },
                    |lane, motor| block.put(lane, Motor::unfuse(motor)),
                );
            },
        );
    }
}
