//! What of a skeleton is drawn: its bones, and on which side of the body they are.

use pga_motor::skeleton::Skeleton;

use super::source::Source;

/// A side of the body.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(crate) enum Side {
    Left,
    Middle,
    Right,
}

impl Side {
    pub(crate) fn name(self) -> &'static str {
        match self {
            Self::Left => "left",
            Self::Middle => "middle",
            Self::Right => "right",
        }
    }
}

/// A line from one point of the figure to another.
pub(crate) struct Bone {
    pub(crate) from: usize,
    pub(crate) to: usize,
    pub(crate) side: Side,
}

/// The points of a figure are the source's joints, then its tips.
pub(crate) struct Anatomy {
    pub(crate) bones: Vec<Bone>,
    /// For each of the source's joints, its side.
    pub(crate) sides: Vec<Side>,
    /// Pairs of points, the bottom and the top of a head.
    pub(crate) heads: Vec<(usize, usize)>,
}

impl Anatomy {
    pub(crate) fn of(source: &Source) -> Self {
        let Source { skeleton, joints, tips, .. } = source;
        let all_sides = sides_of(skeleton);
        let mut point_of = vec![None; skeleton.len()];
        joints.iter().enumerate().for_each(|(point, &joint)| point_of[joint] = Some(point));

        let mut bones: Vec<Bone> = Vec::new();
        for (to, &joint) in joints.iter().enumerate() {
            // What carries joints and is none is passed over.
            let mut ancestors = std::iter::successors(skeleton.parent(joint), |&joint| skeleton.parent(joint));
            let from = ancestors.find_map(|ancestor| point_of[ancestor]);
            bones.extend(from.map(|from| Bone { from, to, side: all_sides[joint] }));
        }
        let mut heads = Vec::new();
        for (to, tip) in (joints.len()..).zip(tips) {
            let Some(from) = point_of[tip.joint] else { continue };
            if skeleton.names()[tip.joint].to_lowercase().contains("head") {
                heads.push((from, to));
            } else {
                bones.push(Bone { from, to, side: all_sides[tip.joint] });
            }
        }
        Self { bones, sides: joints.iter().map(|&joint| all_sides[joint]).collect(), heads }
    }
}

/// The side of each joint: what its name tells, or else its parent's.
fn sides_of(skeleton: &Skeleton<f64>) -> Vec<Side> {
    let mut sides: Vec<Side> = Vec::with_capacity(skeleton.len());
    for (joint, name) in skeleton.names().iter().enumerate() {
        let inherited = || skeleton.parent(joint).map_or(Side::Middle, |parent| sides[parent]);
        sides.push(side_of(name).unwrap_or_else(inherited));
    }
    sides
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
