//! Loops over lanes, generic over what is done in each.
//!
//! Everything here is inlined into the functions that [`dispatch`] chooses from, kernel included; so the compiler makes of each loop what
//! these functions' instructions allow. There are no copies by hand.

use super::Lanewise;
use super::blocks::{Block, Blocks, LANES};
use crate::LengthMismatch;
use crate::instructions::{Work, dispatch};
use crate::slices::check_lengths;

struct Map<'a, A: Lanewise, R: Lanewise, F> {
    items: &'a [Block<A>],
    results: &'a mut [Block<R>],
    function: F,
}

impl<A: Lanewise, R: Lanewise, F: Fn(A) -> R> Work for Map<'_, A, R, F> {
    #[inline(always)]
    fn run(self) {
        for (items, results) in self.items.iter().zip(self.results) {
            for lane in 0..LANES {
                (self.function)(A::get(&items.0, lane)).put(&mut results.0, lane);
            }
        }
    }
}

struct Zip<'a, A: Lanewise, B: Lanewise, R: Lanewise, F> {
    items: &'a [Block<A>],
    others: &'a [Block<B>],
    results: &'a mut [Block<R>],
    function: F,
}

impl<A: Lanewise, B: Lanewise, R: Lanewise, F: Fn(A, B) -> R> Work for Zip<'_, A, B, R, F> {
    #[inline(always)]
    fn run(self) {
        for ((items, others), results) in self.items.iter().zip(self.others).zip(self.results) {
            for lane in 0..LANES {
                (self.function)(A::get(&items.0, lane), B::get(&others.0, lane)).put(&mut results.0, lane);
            }
        }
    }
}

/// A function without branches that is right where `holds` says so, and another for the other lanes.
struct MapQuickly<'a, A: Lanewise, R: Lanewise, F, H, E> {
    items: &'a [Block<A>],
    results: &'a mut [Block<R>],
    quick: F,
    holds: H,
    exact: E,
}

impl<A: Lanewise, R: Lanewise, F: Fn(A) -> R, H: Fn(A) -> bool, E: Fn(A) -> R> Work for MapQuickly<'_, A, R, F, H, E> {
    #[inline(always)]
    fn run(self) {
        for (items, results) in self.items.iter().zip(self.results) {
            let mut failures = [0_u32; LANES];
            for (lane, failure) in failures.iter_mut().enumerate() {
                let item = A::get(&items.0, lane);
                (self.quick)(item).put(&mut results.0, lane);
                *failure = u32::from(!(self.holds)(item));
            }
            if failures.iter().fold(0, |any, failure| any | failure) != 0 {
                for (lane, _) in failures.iter().enumerate().filter(|(_, failure)| **failure != 0) {
                    (self.exact)(A::get(&items.0, lane)).put(&mut results.0, lane);
                }
            }
        }
    }
}

/// Writes the image of each item into the place with the same index; nothing where the lengths differ.
#[inline]
pub(super) fn map<A: Lanewise, R: Lanewise>(
    items: &Blocks<A>,
    results: &mut Blocks<R>,
    function: impl Fn(A) -> R,
) -> Result<(), LengthMismatch> {
    check_lengths(items.len(), results.len())?;
    dispatch(Map { items: &items.blocks, results: &mut results.blocks, function });
    Ok(())
}

/// Writes what becomes of each pair into the place with the same index; nothing where the lengths differ.
#[inline]
pub(super) fn zip<A: Lanewise, B: Lanewise, R: Lanewise>(
    items: &Blocks<A>,
    others: &Blocks<B>,
    results: &mut Blocks<R>,
    function: impl Fn(A, B) -> R,
) -> Result<(), LengthMismatch> {
    check_lengths(items.len(), others.len())?;
    check_lengths(items.len(), results.len())?;
    dispatch(Zip { items: &items.blocks, others: &others.blocks, results: &mut results.blocks, function });
    Ok(())
}

/// [`map`] by `quick` where that `holds`, else by `exact`.
#[inline]
pub(super) fn map_quickly<A: Lanewise, R: Lanewise>(
    items: &Blocks<A>,
    results: &mut Blocks<R>,
    quick: impl Fn(A) -> R,
    holds: impl Fn(A) -> bool,
    exact: impl Fn(A) -> R,
) -> Result<(), LengthMismatch> {
    check_lengths(items.len(), results.len())?;
    dispatch(MapQuickly { items: &items.blocks, results: &mut results.blocks, quick, holds, exact });
    Ok(())
}
