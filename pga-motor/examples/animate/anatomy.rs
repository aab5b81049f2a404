//! What of a skeleton is drawn: its bones, and on which side of the body they are.

use pga_motor::import::bvh::Tip;
use pga_motor::skeleton::{Pose, Skeleton, SkeletonError, local_to_model};
use pga_motor::{Motor, Point};

/// A side of the body.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(crate) enum Side {
    Left,
    Middle,
    Right,
}

/// A line from one point of the figure to another.
pub(crate) struct Bone {
    pub(crate) from: usize,
    pub(crate) to: usize,
    pub(crate) side: Side,
}

/// The points of a figure are its joints, then its tips.
pub(crate) struct Anatomy {
    pub(crate) bones: Vec<Bone>,
    /// For each joint, its side.
    pub(crate) sides: Vec<Side>,
    /// Pairs of points, the bottom and the top of a head.
    pub(crate) heads: Vec<(usize, usize)>,
    tips: Vec<Tip<f64>>,
}

impl Anatomy {
    pub(crate) fn of(skeleton: &Skeleton<f64>, tips: &[Tip<f64>]) -> Self {
        let mut sides: Vec<Side> = Vec::with_capacity(skeleton.len());
        let mut bones = Vec::new();
        for (to, name) in skeleton.names().iter().enumerate() {
            let parent = skeleton.parent(to);
            let side = side_of(name).unwrap_or_else(|| parent.map_or(Side::Middle, |parent| sides[parent]));
            bones.extend(parent.map(|from| Bone { from, to, side }));
            sides.push(side);
        }
        let mut heads = Vec::new();
        for (to, tip) in (skeleton.len()..).zip(tips) {
            if skeleton.names()[tip.joint].to_lowercase().contains("head") {
                heads.push((tip.joint, to));
            } else {
                bones.push(Bone { from: tip.joint, to, side: sides[tip.joint] });
            }
        }
        Self { bones, sides, heads, tips: tips.to_vec() }
    }

    /// Where the points of the figure are in a pose, by forward kinematics.
    pub(crate) fn points(&self, skeleton: &Skeleton<f64>, pose: &Pose<f64>) -> Result<Vec<Point<f64>>, SkeletonError> {
        let mut model = vec![Motor::IDENTITY; skeleton.len()];
        local_to_model(skeleton, pose, &mut model)?;
        let joints = model.iter().map(|motor| motor.transform_origin());
        let tips = self.tips.iter().map(|tip| {
            let Tip { joint, offset } = *tip;
            model[joint].transform_point(Point::new(offset.x, offset.y, offset.z))
        });
        Ok(joints.chain(tips).collect())
    }
}

/// The side that a joint's name tells, as `LeftArm`, `mixamorig:LeftArm`, `LThumb`, `lShldr`, `arm_l`, `Arm.L` or `Bip01 L Arm` do.
fn side_of(name: &str) -> Option<Side> {
    name.split(|c: char| !c.is_ascii_alphanumeric()).find_map(|word| {
        let small = word.to_ascii_lowercase();
        let initial = small.len() == 1 || word[1.min(word.len())..].starts_with(|c: char| c.is_ascii_uppercase());
        match small.chars().next()? {
            'l' if initial || small.starts_with("left") => Some(Side::Left),
            'r' if initial || small.starts_with("right") => Some(Side::Right),
            _ => None,
        }
    })
}
