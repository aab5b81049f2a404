//! Forward kinematics.

use super::{Skeleton, SkeletonError};
use crate::{Motor, Scalar};

/// Forward kinematics: `out[i] = out[parent(i)] * locals[i]`, and `out[i] = locals[i]` for a root.
///
/// `locals` and `out` have one motor for each joint, in the skeleton's order. Nothing is allocated. The model motor of joint i
/// takes points of the joint's own frame to the skeleton's space; where the joint itself is, `out[i]` takes the origin to.
///
/// # Errors
/// [`SkeletonError::PoseLength`] where a buffer is longer or shorter than the skeleton; `out` is then as it was.
pub fn local_to_model<T: Scalar>(
    skeleton: &Skeleton<T>,
    locals: &[Motor<T>],
    out: &mut [Motor<T>],
) -> Result<(), SkeletonError> {
    check_length("locals", skeleton.len(), locals.len())?;
    check_length("out", skeleton.len(), out.len())?;
    for (i, (joint, &local)) in skeleton.joints().iter().zip(locals).enumerate() {
        out[i] = if joint.is_root() { local } else { out[i - usize::from(joint.parent_offset)] * local };
    }
    Ok(())
}

pub(super) fn check_length(buffer: &'static str, expected: usize, found: usize) -> Result<(), SkeletonError> {
    if found == expected { Ok(()) } else { Err(SkeletonError::PoseLength { buffer, expected, found }) }
}
