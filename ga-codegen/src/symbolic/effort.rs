//! How much work a definition block may be. A short block can describe polynomials of any size; what takes the terms, here
//! and in the factoriser, counts its steps, and where there are too many it gives up.
//!
//! The count belongs to the thread, so that arithmetic keeps its signatures. Outside [`limited`] nothing is counted.

use std::cell::Cell;

thread_local! {
    static LEFT: Cell<Option<u64>> = const { Cell::new(None) };
}

/// Puts the count back as it was, whatever happens in between.
struct Restore(Option<u64>);

impl Drop for Restore {
    fn drop(&mut self) {
        LEFT.set(self.0);
    }
}

/// Does work of at most that many steps; the work asks [`is_exhausted`] to tell an end of patience from other failures.
pub(crate) fn limited<T>(steps: u64, work: impl FnOnce() -> T) -> T {
    let _restore = Restore(LEFT.replace(Some(steps)));
    work()
}

/// Counts steps; whether there are any left. Once there are none it stays so.
pub(crate) fn spend(steps: usize) -> bool {
    match LEFT.get() {
        None => true,
        Some(left) => {
            let left = left.saturating_sub(steps as u64);
            LEFT.set(Some(left));
            left > 0
        }
    }
}

/// Whether the work has come to the end of its steps.
pub(crate) fn is_exhausted() -> bool {
    LEFT.get() == Some(0)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn steps_run_out_and_stay_out_until_the_work_ends() {
        assert!(spend(usize::MAX) && !is_exhausted());
        limited(3, || {
            assert!(spend(2) && !spend(1) && is_exhausted());
            assert!(!spend(0));
            limited(2, || assert!(spend(1) && !is_exhausted()));
            assert!(is_exhausted());
        });
        assert!(!is_exhausted());
    }
}
