//! Where items stand: in [`Blocks`], or one by one in slices.

use super::blocks::{Block, Blocks, LANES};
use super::lanes::{Lanewise, sealed::Fusible};
use crate::Scalar;

/// Items to be read, a block of [`LANES`] at a time.
pub(super) trait Source {
    type Item: Copy + Fusible;
    type Block: Lanes<Item = Self::Item>;

    fn len(&self) -> usize;
    /// The items in order; lanes past the end hold any of the items.
    fn blocks(self) -> impl Iterator<Item = Self::Block>;
}

/// A block of items.
pub(super) trait Lanes {
    type Item;

    fn get(&self, lane: usize) -> Self::Item;
}

/// Places for results.
pub(super) trait Sink {
    type Item: Lanewise;

    fn len(&self) -> usize;
    /// The places, block by block.
    fn blocks(self) -> impl Iterator<Item: Places<Self::Item>>;
}

/// A block of places.
pub(super) trait Places<R: Lanewise> {
    /// The lanes, all of which are to be written.
    fn lanes(&mut self) -> &mut R::Lanes<LANES>;
    /// Brings what was written to where it belongs.
    fn finish(self);
}

impl<'a, E: Lanewise> Source for &'a Blocks<E> {
    type Item = E;
    type Block = &'a Block<E>;

    fn len(&self) -> usize {
        Blocks::len(self)
    }

    #[inline(always)]
    fn blocks(self) -> impl Iterator<Item = Self::Block> {
        self.blocks.iter()
    }
}

impl<E: Lanewise> Lanes for &Block<E> {
    type Item = E;

    #[inline(always)]
    fn get(&self, lane: usize) -> E {
        E::get(&self.0, lane)
    }
}

impl<E: Lanewise> Sink for &mut Blocks<E> {
    type Item = E;

    fn len(&self) -> usize {
        Blocks::len(self)
    }

    #[inline(always)]
    fn blocks(self) -> impl Iterator<Item: Places<E>> {
        self.blocks.iter_mut()
    }
}

impl<E: Lanewise> Places<E> for &mut Block<E> {
    #[inline(always)]
    fn lanes(&mut self) -> &mut E::Lanes<LANES> {
        &mut self.0
    }

    #[inline(always)]
    fn finish(self) {}
}

/// Items of a slice are brought side by side first.
impl<E: Lanewise> Source for &[E] {
    type Item = E;
    type Block = Block<E>;

    fn len(&self) -> usize {
        <[E]>::len(self)
    }

    #[inline(always)]
    fn blocks(self) -> impl Iterator<Item = Block<E>> {
        self.chunks(LANES).map(|items| {
            let mut block = Block(items[0].splat());
            for (lane, item) in items.iter().enumerate() {
                item.put(&mut block.0, lane);
            }
            block
        })
    }
}

impl<E: Lanewise> Lanes for Block<E> {
    type Item = E;

    #[inline(always)]
    fn get(&self, lane: usize) -> E {
        E::get(&self.0, lane)
    }
}

impl<E: Lanewise> Sink for &mut [E] {
    type Item = E;

    fn len(&self) -> usize {
        <[E]>::len(self)
    }

    #[inline(always)]
    fn blocks(self) -> impl Iterator<Item: Places<E>> {
        self.chunks_mut(LANES).map(|places| Scattered { lanes: places[0].splat(), places })
    }
}

/// Results side by side, and where they go.
struct Scattered<'a, E: Lanewise> {
    lanes: E::Lanes<LANES>,
    places: &'a mut [E],
}

impl<E: Lanewise> Places<E> for Scattered<'_, E> {
    #[inline(always)]
    fn lanes(&mut self) -> &mut E::Lanes<LANES> {
        &mut self.lanes
    }

    #[inline(always)]
    fn finish(self) {
        for (lane, place) in self.places.iter_mut().enumerate() {
            *place = E::get(&self.lanes, lane);
        }
    }
}

/// The items of two lists, pair by pair; the first says how many.
impl<A: Source, B: Source> Source for (A, B) {
    type Item = (A::Item, B::Item);
    type Block = (A::Block, B::Block);

    fn len(&self) -> usize {
        self.0.len()
    }

    #[inline(always)]
    fn blocks(self) -> impl Iterator<Item = Self::Block> {
        self.0.blocks().zip(self.1.blocks())
    }
}

impl<A: Lanes, B: Lanes> Lanes for (A, B) {
    type Item = (A::Item, B::Item);

    #[inline(always)]
    fn get(&self, lane: usize) -> Self::Item {
        (self.0.get(lane), self.1.get(lane))
    }
}

/// One number for all items.
#[derive(Clone, Copy)]
pub(crate) struct Same<T>(pub(super) T);

impl<T: Scalar> Source for Same<T> {
    type Item = Self;
    type Block = Self;

    fn len(&self) -> usize {
        usize::MAX
    }

    #[inline(always)]
    fn blocks(self) -> impl Iterator<Item = Self> {
        core::iter::repeat(self)
    }
}

impl<T: Scalar> Lanes for Same<T> {
    type Item = Self;

    #[inline(always)]
    fn get(&self, _lane: usize) -> Self {
        *self
    }
}
