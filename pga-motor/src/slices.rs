//! Functions over slices.

use core::fmt;

/// Two slices that should be of the same length are not.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct LengthMismatch {
    /// The number of points, or of what else is to be transformed.
    pub points: usize,
    /// The number of places for results.
    pub results: usize,
}

impl fmt::Display for LengthMismatch {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "expected places for {} results, found {}", self.points, self.results)
    }
}

impl core::error::Error for LengthMismatch {}

/// Writes the image of each item into the place with the same index; nothing where the lengths differ.
#[inline]
pub(crate) fn map<X: Copy>(items: &[X], results: &mut [X], map: impl Fn(X) -> X) -> Result<(), LengthMismatch> {
    let (points, places) = (items.len(), results.len());
    if points != places {
        return Err(LengthMismatch { points, results: places });
    }
    for (result, item) in results.iter_mut().zip(items) {
        *result = map(*item);
    }
    Ok(())
}

/// Replaces each item by its image.
#[inline]
pub(crate) fn map_in_place<X: Copy>(items: &mut [X], map: impl Fn(X) -> X) {
    for item in items {
        *item = map(*item);
    }
}
