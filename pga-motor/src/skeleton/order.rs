//! Depth-first order from parents given in any order. Linear in the number of joints, and without recursion: a chain may be as
//! deep as there are joints.

use alloc::vec::Vec;

const NONE: usize = usize::MAX;

/// The old indices in depth-first order, children of one parent and roots in the order in which they were given.
///
/// Every parent must be below `parents.len()`. A joint on a cycle, or below one, hangs from no root and does not appear: the
/// result is shorter than `parents` exactly when there is a cycle.
pub(super) fn depth_first(parents: &[Option<usize>]) -> Vec<usize> {
    // Each list is linked from its last member back to its first, so that a stack gives it out first to last.
    let mut last_root = NONE;
    let mut last_child = alloc::vec![NONE; parents.len()];
    let mut previous_sibling = alloc::vec![NONE; parents.len()];
    for (joint, parent) in parents.iter().enumerate() {
        let last = parent.map_or(&mut last_root, |parent| &mut last_child[parent]);
        previous_sibling[joint] = core::mem::replace(last, joint);
    }

    let mut order = Vec::with_capacity(parents.len());
    let mut waiting = Vec::new();
    let push_list = |waiting: &mut Vec<usize>, last: usize| {
        let mut joint = last;
        while joint != NONE {
            waiting.push(joint);
            joint = previous_sibling[joint];
        }
    };
    push_list(&mut waiting, last_root);
    while let Some(joint) = waiting.pop() {
        order.push(joint);
        push_list(&mut waiting, last_child[joint]);
    }
    order
}

/// The first joint that is its own ancestor, if there is one. Every parent must be below `parents.len()`.
pub(super) fn first_on_cycle(parents: &[Option<usize>]) -> Option<usize> {
    // `seen_from[i]` is the walk that came past joint i first. A walk that meets itself has found a cycle.
    let mut seen_from = alloc::vec![NONE; parents.len()];
    let mut first = None;
    for start in 0..parents.len() {
        let mut here = Some(start);
        while let Some(joint) = here.filter(|&joint| seen_from[joint] == NONE) {
            seen_from[joint] = start;
            here = parents[joint];
        }
        if let Some(joint) = here.filter(|&joint| seen_from[joint] == start) {
            first = first.into_iter().chain([lowest_on_cycle(parents, joint)]).min();
        }
    }
    first
}

/// The lowest index on the cycle that `member` is on.
fn lowest_on_cycle(parents: &[Option<usize>], member: usize) -> usize {
    let mut lowest = member;
    let mut here = parents[member];
    while let Some(joint) = here.filter(|&joint| joint != member) {
        lowest = lowest.min(joint);
        here = parents[joint];
    }
    lowest
}
