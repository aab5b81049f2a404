//! Functions over slices.

use core::fmt;

/// Two slices that should be of the same length are not.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct LengthMismatch {
    /// The number of points, or of what else there is a result for.
    pub items: usize,
    /// The number of places for results.
    pub results: usize,
}

impl fmt::Display for LengthMismatch {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "expected places for {} results, found {}", self.items, self.results)
    }
}

impl core::error::Error for LengthMismatch {}

/// Writes the image of each item into the place with the same index; nothing where the lengths differ.
#[inline]
pub(crate) fn map<X: Copy, Y>(items: &[X], results: &mut [Y], map: impl Fn(X) -> Y) -> Result<(), LengthMismatch> {
    check_lengths(items, results)?;
    for (result, item) in results.iter_mut().zip(items) {
        *result = map(*item);
    }
    Ok(())
}

/// How many items are looked at together: enough for the widest vectors, few enough to stay in the nearest cache.
const BLOCK: usize = 64;

/// Writes the image of each item into the place with the same index; nothing where the lengths differ. `quick` has no
/// branches and is right where `holds` says so; elsewhere it is done over with `exact`.
#[inline]
pub(crate) fn map_quickly<X: Copy, Y>(
    items: &[X],
    results: &mut [Y],
    quick: impl Fn(X) -> Y,
    holds: impl Fn(X) -> bool,
    exact: impl Fn(X) -> Y,
) -> Result<(), LengthMismatch> {
    check_lengths(items, results)?;
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

fn check_lengths<X, Y>(items: &[X], results: &[Y]) -> Result<(), LengthMismatch> {
    let (items, results) = (items.len(), results.len());
    if items == results { Ok(()) } else { Err(LengthMismatch { items, results }) }
}

/// Replaces each item by its image.
#[inline]
pub(crate) fn map_in_place<X: Copy>(items: &mut [X], map: impl Fn(X) -> X) {
    for item in items {
        *item = map(*item);
    }
}
