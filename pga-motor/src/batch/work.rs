//! Loops over lanes, generic over what is done in each.
//!
//! Everything here is inlined into the functions that [`dispatch`] chooses from, kernel included; so the compiler makes of each loop what
//! these functions' instructions allow. There are no copies by hand. What is done is given twice, for the numbers themselves and for
//! those that fuse products with sums: one function, generic over its numbers, which the call of it tells apart.

use core::ops::Range;

use super::Lanewise;
use super::blocks::{Block, Blocks, LANES};
use super::lanes::sealed::Fusible;
use super::layout::{Lanes, Sink, Source};
use crate::LengthMismatch;
use crate::instructions::{Work, dispatch};
use crate::slices::check_lengths;

/// What is done with a block, lane by lane, in one loop or in several.
pub(crate) trait OnBlock<A, R> {
    fn run(&self, lanes: LaneCount, item: impl Fn(usize) -> A, put: impl FnMut(usize, R));
}

/// [`LANES`], which the compiler does not know to be that many: it would write a short loop out, lane after lane, and then often find no
/// vectors in it. A loop it makes vector code of.
#[derive(Clone, Copy)]
pub(crate) struct LaneCount(usize);

impl LaneCount {
    #[inline(always)]
    pub(crate) fn new() -> Self {
        Self(core::hint::black_box(LANES))
    }

    /// The lanes: within a block, and in whole registers, as the compiler can see.
    #[inline(always)]
    pub(crate) fn range(self) -> Range<usize> {
        0..self.0.min(LANES) & !(LANES - 1)
    }
}

/// A function, short enough to be inlined and to stay in registers.
impl<A, R, F: Fn(A) -> R> OnBlock<A, R> for F {
    #[inline(always)]
    fn run(&self, lanes: LaneCount, item: impl Fn(usize) -> A, mut put: impl FnMut(usize, R)) {
        for lane in lanes.range() {
            put(lane, self(item(lane)));
        }
    }
}

/// A function without branches that is right where `holds` says so, and another for the other lanes.
pub(super) struct Quickly<Q, H, E> {
    pub(super) quick: Q,
    pub(super) holds: H,
    pub(super) exact: E,
}

impl<A: Copy, R, Q: Fn(A) -> R, H: Fn(A) -> bool, E: Fn(A) -> R> OnBlock<A, R> for Quickly<Q, H, E> {
    #[inline(always)]
    fn run(&self, lanes: LaneCount, item: impl Fn(usize) -> A, mut put: impl FnMut(usize, R)) {
        let mut failures = 0_u32;
        for lane in lanes.range() {
            let item = item(lane);
            put(lane, (self.quick)(item));
            failures |= u32::from(!(self.holds)(item));
        }
        if failures != 0 {
            for lane in 0..LANES {
                let item = item(lane);
                if !(self.holds)(item) {
                    put(lane, (self.exact)(item));
                }
            }
        }
    }
}

struct Batch<S, D, P, F> {
    source: S,
    sink: D,
    plain: P,
    fused: F,
}

impl<S, D, P, F> Work for Batch<S, D, P, F>
where
    S: Source,
    D: Sink,
    P: OnBlock<S::Item, D::Item>,
    F: OnBlock<<S::Item as Fusible>::Fused, <D::Item as Fusible>::Fused>,
{
    #[inline(always)]
    fn run(self) {
        // In registers, where no result can be taken for a part of it.
        let Self { source, mut sink, plain: function, .. } = self;
        let (lanes, mut room, mut sink_room) = (LaneCount::new(), source.room(), sink.room());
        for block in 0..sink.len().div_ceil(LANES) {
            let items = source.block(block, &mut room);
            let results = sink.lanes(block, &mut sink_room);
            function.run(lanes, |lane| items.get(lane), |lane, result| result.put(results, lane));
            sink.finish(block, &sink_room);
        }
    }

    #[inline(always)]
    fn run_fused(self) {
        let Self { source, mut sink, fused: function, .. } = self;
        let (lanes, mut room, mut sink_room) = (LaneCount::new(), source.room(), sink.room());
        for block in 0..sink.len().div_ceil(LANES) {
            let items = source.block(block, &mut room);
            let results = sink.lanes(block, &mut sink_room);
            function.run(
                lanes,
                |lane| items.get(lane).fuse(),
                |lane, result| D::Item::unfuse(result).put(results, lane),
            );
            sink.finish(block, &sink_room);
        }
    }
}

/// Writes what becomes of each item into the place with the same index; nothing where the lengths differ.
#[inline]
pub(super) fn map<S: Source, D: Sink>(
    source: S,
    sink: D,
    plain: impl OnBlock<S::Item, D::Item>,
    fused: impl OnBlock<<S::Item as Fusible>::Fused, <D::Item as Fusible>::Fused>,
) -> Result<(), LengthMismatch> {
    check_lengths(source.len(), sink.len())?;
    dispatch(Batch { source, sink, plain, fused });
    Ok(())
}

struct InPlace<'a, E: Lanewise, P, F> {
    blocks: &'a mut [Block<E>],
    plain: P,
    fused: F,
}

impl<E: Lanewise, P: OnBlock<E, E>, F: OnBlock<E::Fused, E::Fused>> Work for InPlace<'_, E, P, F> {
    #[inline(always)]
    fn run(self) {
        let (function, lanes) = (self.plain, LaneCount::new());
        for block in self.blocks {
            // Apart from what is written, as the compiler can see.
            let items = *block;
            function.run(lanes, |lane| items.get(lane), |lane, result| block.put(lane, result));
        }
    }

    #[inline(always)]
    fn run_fused(self) {
        let (function, lanes) = (self.fused, LaneCount::new());
        for block in self.blocks {
            let items = *block;
            function.run(lanes, |lane| items.get(lane).fuse(), |lane, result| block.put(lane, E::unfuse(result)));
        }
    }
}

/// Replaces each item by what becomes of it.
#[inline]
pub(super) fn map_in_place<E: Lanewise>(
    items: &mut Blocks<E>,
    plain: impl OnBlock<E, E>,
    fused: impl OnBlock<E::Fused, E::Fused>,
) {
    dispatch(InPlace { blocks: &mut items.blocks, plain, fused });
}

/// [`map`] for the items of two lists, pair by pair.
#[inline]
pub(super) fn zip<A: Source, B: Source, D: Sink>(
    items: A,
    others: B,
    sink: D,
    plain: impl OnBlock<(A::Item, B::Item), D::Item>,
    fused: impl OnBlock<(<A::Item as Fusible>::Fused, <B::Item as Fusible>::Fused), <D::Item as Fusible>::Fused>,
) -> Result<(), LengthMismatch> {
    check_lengths(items.len(), others.len())?;
    map((items, others), sink, plain, fused)
}
