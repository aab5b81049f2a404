//! How much may be read of a file, whatever numbers it declares.

use super::error::GltfReason;

/// How many keys of joints all clips of a file together may have: a key of a clip counts once for each joint. Of values the channels
/// of the file may have three times as many, tangents included, and as many may stand in the sparse lists of its accessors.
pub const MAX_JOINT_KEYS: usize = 1 << 23;

/// How many values may be read.
pub(super) const MAX_VALUES: usize = 3 * MAX_JOINT_KEYS;

/// How many of something may still be read.
pub(super) struct Allowance {
    left: usize,
    limit: usize,
    what: &'static str,
}

impl Allowance {
    pub(super) fn new(limit: usize, what: &'static str) -> Self {
        Self { left: limit, limit, what }
    }

    /// Takes a number from those that are left.
    pub(super) fn spend(&mut self, number: usize) -> Result<(), GltfReason> {
        let (limit, what) = (self.limit, self.what);
        self.left = self.left.checked_sub(number).ok_or(GltfReason::TooManyKeys { limit, what })?;
        Ok(())
    }
}
