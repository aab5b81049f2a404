//! How large a definition block may be. What is larger is refused where it grows too large, so that no block takes long, much
//! memory or a deep stack. The presets stay far below all of these.

/// How many operators and parentheses may be around a part of an expression (a call counts for three), how many terms may
/// stand in a row, and how deep brackets of any kind may be nested: what comes later walks the block recursively. The norm of
/// an element of the largest algebra has 256 terms.
pub(crate) const MAX_DEPTH: usize = 300;

/// How many items a block may have, those of its presets included.
pub(crate) const MAX_ITEMS: usize = 2048;

/// How many parts a list may have that stands between commas, or the rows of a recipe.
pub(crate) const MAX_LISTED: usize = 4096;

/// How many input coefficients a kernel may have.
pub(crate) const MAX_COEFFICIENTS: usize = 4096;

/// How many steps each stage of an expansion may take: terms that are multiplied, added, rewritten or compared, over the
/// whole block.
pub(crate) const MAX_STEPS: u64 = 5_000_000;

/// How many operations the program of a kernel may have.
pub(crate) const MAX_OPERATIONS: usize = 10_000;

/// What an operation of an emitted program counts for, in steps: it is also proved, bounded, named and printed.
pub(crate) const STEPS_OF_AN_OPERATION: usize = 50;

/// How many errors are reported; the first ones are.
pub(crate) const MAX_ERRORS: usize = 100;
