//! Functions over slices. Those without branches are compiled for the instructions that the machine has: see
//! [`InstructionSet`](crate::batch::InstructionSet).

use core::fmt;

use crate::instructions::{Work, dispatch};

/// Two lists that should be of the same length are not.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct LengthMismatch {
    /// The number of items in the first list.
    pub items: usize,
    /// The number of items, or of places for results, in the other one.
    pub results: usize,
}

impl fmt::Display for LengthMismatch {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "expected lists of one length, found {} items and {}", self.items, self.results)
    }
}

impl core::error::Error for LengthMismatch {}

struct Map<'a, X, Y, F> {
    items: &'a [X],
    results: &'a mut [Y],
    map: F,
}

impl<X: Copy, Y, F: Fn(X) -> Y> Work for Map<'_, X, Y, F> {
    #[inline(always)]
    fn run(self) {
        for (result, item) in self.results.iter_mut().zip(self.items) {
            *result = (self.map)(*item);
        }
    }

    /// Not fused: what bringing coefficients together costs leaves nothing to win.
    #[inline(always)]
    fn run_fused(self) {
        self.run();
    }
}

struct Zip<'a, X, Y, Z, F> {
    items: &'a [X],
    others: &'a [Y],
    results: &'a mut [Z],
    join: F,
}

impl<X: Copy, Y: Copy, Z, F: Fn(X, Y) -> Z> Work for Zip<'_, X, Y, Z, F> {
    #[inline(always)]
    fn run(self) {
        for ((result, item), other) in self.results.iter_mut().zip(self.items).zip(self.others) {
            *result = (self.join)(*item, *other);
        }
    }

    #[inline(always)]
    fn run_fused(self) {
        self.run();
    }
}

/// Writes what becomes of each pair into the place with the same index; nothing where the lengths differ.
#[inline]
pub(crate) fn zip<X: Copy, Y: Copy, Z>(
    items: &[X],
    others: &[Y],
    results: &mut [Z],
    join: impl Fn(X, Y) -> Z,
) -> Result<(), LengthMismatch> {
    check_lengths(items.len(), others.len())?;
    check_lengths(items.len(), results.len())?;
    dispatch(Zip { items, others, results, join });
    Ok(())
}

/// Writes the image of each item into the place with the same index; nothing where the lengths differ.
#[inline]
pub(crate) fn map<X: Copy, Y>(items: &[X], results: &mut [Y], map: impl Fn(X) -> Y) -> Result<(), LengthMismatch> {
    check_lengths(items.len(), results.len())?;
    dispatch(Map { items, results, map });
    Ok(())
}

/// How many items are looked at together: enough for the widest vectors, few enough to stay in the nearest cache.
const BLOCK: usize = 64;

/// Writes the image of each item into the place with the same index; nothing where the lengths differ. `quick` has no
/// branches and is right where `holds` says so; elsewhere it is done over with `exact`.
///
/// With AVX2 this is a tenth slower than without, as it spends what it wins on bringing coefficients together; so it is portable. Blocks
/// do not have that.
#[inline]
pub(crate) fn map_quickly<X: Copy, Y>(
    items: &[X],
    results: &mut [Y],
    quick: impl Fn(X) -> Y,
    holds: impl Fn(X) -> bool,
    exact: impl Fn(X) -> Y,
) -> Result<(), LengthMismatch> {
    check_lengths(items.len(), results.len())?;
    for (items, results) in items.chunks(BLOCK).zip(results.chunks_mut(BLOCK)) {
        for (result, item) in results.iter_mut().zip(items) {
            *result = quick(*item);
        }
        if items.iter().fold(true, |all, item| all & holds(*item)) {
            continue;
        }
        for (result, item) in results.iter_mut().zip(items).filter(|(_, item)| !holds(**item)) {
            *result = exact(*item);
        }
    }
    Ok(())
}

pub(crate) fn check_lengths(items: usize, results: usize) -> Result<(), LengthMismatch> {
    if items == results { Ok(()) } else { Err(LengthMismatch { items, results }) }
}

struct MapInPlace<'a, X, F> {
    items: &'a mut [X],
    map: F,
}

impl<X: Copy, F: Fn(X) -> X> Work for MapInPlace<'_, X, F> {
    #[inline(always)]
    fn run(self) {
        for item in self.items {
            *item = (self.map)(*item);
        }
    }

    #[inline(always)]
    fn run_fused(self) {
        self.run();
    }
}

/// Replaces each item by its image.
#[inline]
pub(crate) fn map_in_place<X: Copy>(items: &mut [X], map: impl Fn(X) -> X) {
    dispatch(MapInPlace { items, map });
}
