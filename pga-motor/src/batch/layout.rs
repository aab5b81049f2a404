//! Where items stand: in [`Blocks`], or one by one in slices.

use super::blocks::{Block, Blocks, LANES};
use super::lanes::{Lanewise, sealed::Fusible};
use crate::Scalar;

/// Items to be read, a block of [`LANES`] at a time.
pub(super) trait Source {
    type Item: Copy + Fusible;
    /// Room for a block, where items have to be brought side by side first.
    type Room;

    fn len(&self) -> usize;
    fn room(&self) -> Self::Room;
    /// The items of a block, of which there is at least one; lanes past the end hold any of the items.
    fn block<'a>(&'a self, block: usize, room: &'a mut Self::Room) -> impl Lanes<Item = Self::Item>;
}

/// A block of items.
pub(super) trait Lanes {
    type Item;

    fn get(&self, lane: usize) -> Self::Item;
}

/// Places for results.
pub(super) trait Sink {
    type Item: Lanewise;
    /// Room for a block, where results stand side by side first.
    type Room;

    fn len(&self) -> usize;
    fn room(&self) -> Self::Room;
    /// The lanes of a block, of which there is at least one, all to be written.
    fn lanes<'a>(
        &'a mut self,
        block: usize,
        room: &'a mut Self::Room,
    ) -> &'a mut <Self::Item as Lanewise>::Lanes<LANES>;
    /// Brings what was written to where it belongs.
    fn finish(&mut self, block: usize, room: &Self::Room);
}

impl<E: Lanewise> Source for &Blocks<E> {
    type Item = E;
    type Room = ();

    fn len(&self) -> usize {
        Blocks::len(self)
    }

    #[inline(always)]
    fn room(&self) {}

    #[inline(always)]
    fn block<'a>(&'a self, block: usize, (): &'a mut ()) -> impl Lanes<Item = E> {
        &self.blocks[block]
    }
}

impl<E: Lanewise> Sink for &mut Blocks<E> {
    type Item = E;
    type Room = ();

    fn len(&self) -> usize {
        Blocks::len(self)
    }

    #[inline(always)]
    fn room(&self) {}

    #[inline(always)]
    fn lanes<'a>(&'a mut self, block: usize, (): &'a mut ()) -> &'a mut E::Lanes<LANES> {
        &mut self.blocks[block].0
    }

    #[inline(always)]
    fn finish(&mut self, _block: usize, (): &()) {}
}

impl<E: Lanewise> Lanes for &Block<E> {
    type Item = E;

    #[inline(always)]
    fn get(&self, lane: usize) -> E {
        E::get(&self.0, lane)
    }
}

/// The items of a slice that make a block.
#[inline(always)]
fn of_block(block: usize, len: usize) -> core::ops::Range<usize> {
    block * LANES..len.min((block + 1) * LANES)
}

impl<E: Lanewise> Source for &[E] {
    type Item = E;
    type Room = Option<Block<E>>;

    fn len(&self) -> usize {
        <[E]>::len(self)
    }

    #[inline(always)]
    fn room(&self) -> Self::Room {
        self.first().map(|&item| Block::of(item))
    }

    #[inline(always)]
    fn block<'a>(&'a self, block: usize, room: &'a mut Self::Room) -> impl Lanes<Item = E> {
        let room = room.as_mut().expect("invariant: there is an item");
        room.gather(&self[of_block(block, self.len())]);
        &*room
    }
}

impl<E: Lanewise> Sink for &mut [E] {
    type Item = E;
    type Room = Option<Block<E>>;

    fn len(&self) -> usize {
        <[E]>::len(self)
    }

    #[inline(always)]
    fn room(&self) -> Self::Room {
        self.first().map(|&item| Block::of(item))
    }

    #[inline(always)]
    fn lanes<'a>(&'a mut self, _block: usize, room: &'a mut Self::Room) -> &'a mut E::Lanes<LANES> {
        &mut room.as_mut().expect("invariant: there is a place").0
    }

    #[inline(always)]
    fn finish(&mut self, block: usize, room: &Self::Room) {
        let (room, len) = (room.as_ref().expect("invariant: there is a place"), self.len());
        room.scatter(&mut self[of_block(block, len)]);
    }
}

/// The items of two lists, pair by pair; the first says how many.
impl<A: Source, B: Source> Source for (A, B) {
    type Item = (A::Item, B::Item);
    type Room = (A::Room, B::Room);

    fn len(&self) -> usize {
        self.0.len()
    }

    #[inline(always)]
    fn room(&self) -> Self::Room {
        (self.0.room(), self.1.room())
    }

    #[inline(always)]
    fn block<'a>(&'a self, block: usize, room: &'a mut Self::Room) -> impl Lanes<Item = Self::Item> {
        (self.0.block(block, &mut room.0), self.1.block(block, &mut room.1))
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
    type Room = ();

    fn len(&self) -> usize {
        usize::MAX
    }

    #[inline(always)]
    fn room(&self) {}

    #[inline(always)]
    fn block<'a>(&'a self, _block: usize, (): &'a mut ()) -> impl Lanes<Item = Self> {
        *self
    }
}

impl<T: Scalar> Lanes for Same<T> {
    type Item = Self;

    #[inline(always)]
    fn get(&self, _lane: usize) -> Self {
        *self
    }
}
