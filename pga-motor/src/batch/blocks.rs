//! The container.

use alloc::vec::Vec;
use core::fmt;

use super::Lanewise;

/// How many items stand together in a block: as many `f32` as the widest vector register holds.
pub const LANES: usize = 16;

/// A block, aligned to the widest vector registers and to lines of the cache.
#[derive(Clone, Copy)]
#[repr(C, align(64))]
pub(crate) struct Block<E: Lanewise>(pub(super) E::Lanes<LANES>);

impl<E: Lanewise> Block<E> {
    /// The same item in all lanes.
    #[inline(always)]
    pub(crate) fn of(item: E) -> Self {
        Self(item.splat())
    }

    /// Takes up at most [`LANES`] items; lanes past the last stay as they are.
    #[inline(always)]
    pub(crate) fn gather(&mut self, items: &[E]) {
        for (i, &item) in items.iter().enumerate() {
            self.put(i, item);
        }
    }

    /// Writes the items of the first lanes, at most [`LANES`].
    #[inline(always)]
    pub(crate) fn scatter(&self, items: &mut [E]) {
        for (i, item) in items.iter_mut().enumerate() {
            *item = self.get(i);
        }
    }

    /// The item in a lane, which is below [`LANES`].
    #[inline(always)]
    pub(crate) fn get(&self, lane: usize) -> E {
        E::get(&self.0, lane)
    }

    /// Puts an item into a lane, which is below [`LANES`].
    #[inline(always)]
    pub(crate) fn put(&mut self, lane: usize, item: E) {
        item.put(&mut self.0, lane);
    }
}

/// A list of items, [`LANES`] of them side by side: for each coefficient first those of the first items, then those of the next ones.
///
/// It grows like a `Vec`, and takes the room of a whole number of blocks.
#[derive(Clone)]
pub struct Blocks<E: Lanewise> {
    /// Lanes past the end are copies of an item of their block, so that whatever is worked out there goes as well as elsewhere.
    pub(super) blocks: Vec<Block<E>>,
    len: usize,
}

impl<E: Lanewise> Blocks<E> {
    /// An empty list.
    pub const fn new() -> Self {
        Self { blocks: Vec::new(), len: 0 }
    }

    /// An empty list with room for this many items.
    pub fn with_capacity(items: usize) -> Self {
        Self { blocks: Vec::with_capacity(items.div_ceil(LANES)), len: 0 }
    }

    /// This many copies of an item, such as a place for results.
    pub fn filled(item: E, len: usize) -> Self {
        Self { blocks: alloc::vec![Block(item.splat()); len.div_ceil(LANES)], len }
    }

    /// How many items there are.
    pub fn len(&self) -> usize {
        self.len
    }

    /// Whether there are no items.
    pub fn is_empty(&self) -> bool {
        self.len == 0
    }

    /// The item at an index; `None` past the end.
    pub fn get(&self, index: usize) -> Option<E> {
        (index < self.len).then(|| E::get(&self.blocks[index / LANES].0, index % LANES))
    }

    /// Replaces the item at an index, and returns the one that was there; `None`, and nothing is changed, past the end.
    pub fn replace(&mut self, index: usize, item: E) -> Option<E> {
        let before = self.get(index)?;
        let block = &mut self.blocks[index / LANES];
        block.put(index % LANES, item);
        // What was there may have been what the lanes past the end are copies of.
        let past_the_end = self.len.saturating_sub(index / LANES * LANES).min(LANES)..LANES;
        past_the_end.for_each(|lane| block.put(lane, item));
        Some(before)
    }

    /// Appends an item.
    pub fn push(&mut self, item: E) {
        match self.len % LANES {
            0 => self.blocks.push(Block(item.splat())),
            lane => {
                let block = self.blocks.last_mut().expect("invariant: a lane other than the first is in a block");
                item.put(&mut block.0, lane);
            }
        }
        self.len += 1;
    }

    /// Removes all items; the room stays.
    pub fn clear(&mut self) {
        self.blocks.clear();
        self.len = 0;
    }

    /// The items in order.
    pub fn iter(&self) -> Iter<'_, E> {
        Iter { blocks: self, next: 0 }
    }
}

impl<E: Lanewise> Default for Blocks<E> {
    fn default() -> Self {
        Self::new()
    }
}

impl<E: Lanewise> Extend<E> for Blocks<E> {
    fn extend<I: IntoIterator<Item = E>>(&mut self, items: I) {
        let items = items.into_iter();
        self.blocks.reserve(items.size_hint().0 / LANES);
        items.for_each(|item| self.push(item));
    }
}

impl<E: Lanewise> FromIterator<E> for Blocks<E> {
    fn from_iter<I: IntoIterator<Item = E>>(items: I) -> Self {
        let mut blocks = Self::new();
        blocks.extend(items);
        blocks
    }
}

impl<E: Lanewise> From<&[E]> for Blocks<E> {
    fn from(items: &[E]) -> Self {
        items.iter().copied().collect()
    }
}

impl<E: Lanewise> From<&Blocks<E>> for Vec<E> {
    fn from(blocks: &Blocks<E>) -> Self {
        blocks.iter().collect()
    }
}

impl<E: Lanewise + PartialEq> PartialEq for Blocks<E> {
    fn eq(&self, other: &Self) -> bool {
        self.len == other.len && self.iter().eq(other.iter())
    }
}

impl<E: Lanewise + fmt::Debug> fmt::Debug for Blocks<E> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_list().entries(self.iter()).finish()
    }
}

/// The items of [`Blocks`] in order.
#[derive(Clone)]
pub struct Iter<'a, E: Lanewise> {
    blocks: &'a Blocks<E>,
    next: usize,
}

impl<E: Lanewise> Iterator for Iter<'_, E> {
    type Item = E;

    fn next(&mut self) -> Option<E> {
        let item = self.blocks.get(self.next)?;
        self.next += 1;
        Some(item)
    }

    fn size_hint(&self) -> (usize, Option<usize>) {
        let left = self.blocks.len - self.next;
        (left, Some(left))
    }
}

impl<E: Lanewise> ExactSizeIterator for Iter<'_, E> {}

impl<'a, E: Lanewise> IntoIterator for &'a Blocks<E> {
    type Item = E;
    type IntoIter = Iter<'a, E>;

    fn into_iter(self) -> Iter<'a, E> {
        self.iter()
    }
}
