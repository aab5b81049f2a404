//! Forward kinematics of many characters at once.

use crate::batch::{Fusible, LaneCount, MotorBlock, product};
use crate::instructions::{Work, dispatch};
use crate::skeleton::Joint;
use crate::{Motor, Scalar};

/// Makes model motors of local ones, group after group.
pub(super) fn in_place<T: Scalar>(joints: &[Joint<T>], blocks: &mut [MotorBlock<T>]) {
    dispatch(InPlace { joints, blocks });
}

/// Writes the model motors that belong to local ones, group after group.
pub(super) fn into<T: Scalar>(joints: &[Joint<T>], locals: &[MotorBlock<T>], models: &mut [MotorBlock<T>]) {
    dispatch(Into { joints, locals, models });
}

/// The model motors of a joint. In a block of its own, which the compiler sees to be apart from the others.
#[inline(always)]
fn carry<T: Scalar>(
    lanes: LaneCount,
    product: impl Fn(Motor<T>, Motor<T>) -> Motor<T>,
    parent: MotorBlock<T>,
    model: &mut MotorBlock<T>,
) {
    for lane in lanes.range() {
        model.put(lane, product(parent.get(lane), model.get(lane)));
    }
}

struct InPlace<'a, T: Scalar> {
    joints: &'a [Joint<T>],
    blocks: &'a mut [MotorBlock<T>],
}

impl<T: Scalar> InPlace<'_, T> {
    #[inline(always)]
    fn run_with(self, product: impl Fn(Motor<T>, Motor<T>) -> Motor<T> + Copy) {
        let lanes = LaneCount::new();
        for group in self.blocks.chunks_exact_mut(self.joints.len()) {
            for (i, joint) in self.joints.iter().enumerate().filter(|(_, joint)| !joint.is_root()) {
                let (above, below) = group.split_at_mut(i);
                let parent = &above[i - usize::from(joint.parent_offset)];
                carry(lanes, product, *parent, &mut below[0]);
            }
        }
    }
}

impl<T: Scalar> Work for InPlace<'_, T> {
    #[inline(always)]
    fn run(self) {
        self.run_with(product);
    }

    #[inline(always)]
    fn run_fused(self) {
        self.run_with(fused_product);
    }
}

struct Into<'a, T: Scalar> {
    joints: &'a [Joint<T>],
    locals: &'a [MotorBlock<T>],
    models: &'a mut [MotorBlock<T>],
}

impl<T: Scalar> Into<'_, T> {
    #[inline(always)]
    fn run_with(self, product: impl Fn(Motor<T>, Motor<T>) -> Motor<T> + Copy) {
        let (lanes, joints) = (LaneCount::new(), self.joints.len());
        for (locals, models) in self.locals.chunks_exact(joints).zip(self.models.chunks_exact_mut(joints)) {
            for (i, (joint, local)) in self.joints.iter().zip(locals).enumerate() {
                let (above, below) = models.split_at_mut(i);
                below[0] = *local;
                if !joint.is_root() {
                    let parent = above[i - usize::from(joint.parent_offset)];
                    carry(lanes, product, parent, &mut below[0]);
                }
            }
        }
    }
}

impl<T: Scalar> Work for Into<'_, T> {
    #[inline(always)]
    fn run(self) {
        self.run_with(product);
    }

    #[inline(always)]
    fn run_fused(self) {
        self.run_with(fused_product);
    }
}

#[inline(always)]
fn fused_product<T: Scalar>(a: Motor<T>, b: Motor<T>) -> Motor<T> {
    Motor::unfuse(product(a.fuse(), b.fuse()))
}
