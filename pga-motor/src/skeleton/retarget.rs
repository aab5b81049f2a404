//! Motion made for one skeleton, played on another.

use alloc::string::String;
use alloc::vec::Vec;

use super::{Clip, ClipError, JointModes, Skeleton, SkeletonError, local_to_model};
use crate::{Direction, Motor, Real, Rotor, Translator};

#[cfg(test)]
mod tests;

/// Carries poses of one skeleton over to another of different proportions, whose joints have the same names.
///
/// Both rest poses must show the same stance, seen in each skeleton's own space; the axes of the joints' frames may differ.
/// - Rotations: a joint turns, seen from the skeleton's space, as far from its rest as its namesake does.
/// - Translations: what a joint is displaced from its rest, seen from there too, is scaled by the length of its bone over that of its
///   namesake: the distance at rest to the next joint above that has a namesake. Roots, and joints whose namesake's bone has no
///   length, take the ratio of the sums of all these lengths.
/// - Joints without a namesake keep their rest pose.
///
/// It keeps buffers, so that [`Retarget::pose_into`] allocates nothing.
#[derive(Clone, Debug)]
pub struct Retarget<T> {
    links: Vec<Option<Link<T>>>,
    source: Buffers<T>,
    target: Buffers<T>,
    unmatched: Unmatched,
}

/// The joints that have no counterpart, by name.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Unmatched {
    /// Joints of the skeleton that the motion was made for; their motion is lost, but for what it does to joints below.
    pub source: Vec<String>,
    /// Joints of the skeleton that it is played on; they keep their rest pose.
    pub target: Vec<String>,
    /// Names that several joints of one skeleton have; the first of them counts. They stand in the lists above as well.
    pub repeated: Vec<String>,
}

/// How a joint of the target follows one of the source.
#[derive(Clone, Copy, Debug)]
struct Link<T> {
    source: usize,
    /// The length of its bone over that of its namesake.
    scale: T,
}

/// A skeleton, its rest pose and what the present pose is, in the skeleton's space.
#[derive(Clone, Debug)]
struct Buffers<T> {
    skeleton: Skeleton<T>,
    rest: Vec<Motor<T>>,
    model: Vec<Motor<T>>,
}

impl<T: Real> Buffers<T> {
    fn new(skeleton: &Skeleton<T>) -> Self {
        let mut rest = alloc::vec![Motor::IDENTITY; skeleton.len()];
        local_to_model(skeleton, skeleton.rest_pose(), &mut rest).expect("invariant: buffers of the skeleton's length");
        Self { skeleton: skeleton.clone(), model: rest.clone(), rest }
    }

    /// The rotation from a joint's frame at rest, or for the parent of a root from the skeleton's own, to the skeleton's space.
    fn rest_frame(&self, joint: Option<usize>) -> Rotor<T> {
        joint.map_or(Rotor::IDENTITY, |joint| self.rest[joint].rotor())
    }

    /// The distance at rest to the next joint above that is one of `matched`; `None` where there is none.
    fn bone_length(&self, joint: usize, matched: impl Fn(usize) -> bool) -> Option<T> {
        let mut above = core::iter::successors(self.skeleton.parent(joint), |&joint| self.skeleton.parent(joint));
        let above = above.find(|&joint| matched(joint))?;
        Some(self.rest[joint].transform_origin().distance_to_point(self.rest[above].transform_origin()))
    }
}

impl<T: Real> Retarget<T> {
    /// From a skeleton that motion was made for to one that it is to be played on. [`Retarget::unmatched`] tells which joints found no
    /// counterpart.
    pub fn new(source: &Skeleton<T>, target: &Skeleton<T>) -> Self {
        let (source, target) = (Buffers::new(source), Buffers::new(target));
        let namesakes = namesakes(source.skeleton.names(), target.skeleton.names());
        let mut used = alloc::vec![false; source.skeleton.len()];
        namesakes.iter().flatten().for_each(|&joint| used[joint] = true);
        let lengths: Vec<Option<(T, T)>> = namesakes
            .iter()
            .enumerate()
            .map(|(joint, namesake)| {
                let from = source.bone_length((*namesake)?, |joint| used[joint])?;
                Some((from, target.bone_length(joint, |joint| namesakes[joint].is_some())?))
            })
            .collect();
        let sum = |length: fn(&(T, T)) -> T| lengths.iter().flatten().fold(T::ZERO, |sum, pair| sum + length(pair));
        let overall = ratio(sum(|pair| pair.0), sum(|pair| pair.1)).unwrap_or(T::ONE);
        let scales = lengths.iter().map(|pair| pair.and_then(|(from, to)| ratio(from, to)).unwrap_or(overall));
        let links = namesakes.iter().zip(scales).map(|(&source, scale)| source.map(|source| Link { source, scale }));
        let unmatched = Unmatched {
            source: names_where(&source.skeleton, |joint| !used[joint]),
            target: names_where(&target.skeleton, |joint| namesakes[joint].is_none()),
            repeated: repeated(&[source.skeleton.names(), target.skeleton.names()]),
        };
        Self { links: links.collect(), source, target, unmatched }
    }

    /// The joints that have no counterpart.
    pub fn unmatched(&self) -> &Unmatched {
        &self.unmatched
    }

    /// Writes the pose of the target that a pose of the source becomes.
    ///
    /// # Errors
    /// [`SkeletonError::PoseLength`] where one has not one motor for each joint of its skeleton; `out` is then as it was.
    pub fn pose_into(&mut self, pose: &[Motor<T>], out: &mut [Motor<T>]) -> Result<(), SkeletonError> {
        super::kinematics::check_length("out", self.target.skeleton.len(), out.len())?;
        local_to_model(&self.source.skeleton, pose, &mut self.source.model)?;
        for (joint, out) in out.iter_mut().enumerate() {
            let rest = self.target.skeleton.rest_pose()[joint];
            let parent = self.target.skeleton.parent(joint);
            let local = self.links[joint].map_or(rest, |link| self.follow(link, joint, parent, pose));
            let model = &mut self.target.model;
            model[joint] = parent.map_or(local, |parent| model[parent] * local);
            *out = local;
        }
        Ok(())
    }

    /// The local motor of a joint of the target. Model motors of joints before it are those of the new pose.
    fn follow(&self, link: Link<T>, joint: usize, parent: Option<usize>, pose: &[Motor<T>]) -> Motor<T> {
        let (source, target) = (&self.source, &self.target);
        // As far from rest as the namesake, in the skeleton's space; seen from the parent as it is now.
        let turn = source.model[link.source].rotor() * source.rest[link.source].rotor().reverse();
        let now = parent.map_or(Rotor::IDENTITY, |parent| target.model[parent].rotor());
        let rotor = now.reverse() * turn * target.rest[joint].rotor();
        // The displacement in the parent's frame at rest becomes one in the skeleton's space, and one in the other parent's frame.
        let rest = |skeleton: &Skeleton<T>, joint: usize| skeleton.rest_pose()[joint].translator().vector();
        let displaced = pose[link.source].translator().vector() - rest(&source.skeleton, link.source);
        let between = target.rest_frame(parent).reverse() * source.rest_frame(source.skeleton.parent(link.source));
        let displaced: Direction<T> = between.transform_direction(displaced) * link.scale;
        Motor::from_rotor_translator(rotor, Translator::from_vector(rest(&target.skeleton, joint) + displaced))
    }

    /// A clip of the source as one of the target, key by key.
    ///
    /// # Errors
    /// [`ClipError::JointCount`] where the clip has another number of joints than the source; [`ClipError::NonFinite`] where a length
    /// leaves the range of the numbers.
    pub fn clip(&mut self, clip: &Clip<T>) -> Result<Clip<T>, ClipError> {
        let expected = self.source.skeleton.len();
        if clip.joint_count() != expected {
            return Err(ClipError::JointCount { expected, found: clip.joint_count() });
        }
        let joints = self.target.skeleton.len();
        let mut keys = alloc::vec![Motor::IDENTITY; clip.key_count() * joints];
        for (key, out) in keys.chunks_exact_mut(joints).enumerate() {
            let pose = clip.key(key).expect("invariant: a key below the number of keys");
            self.pose_into(pose, out).expect("invariant: buffers of the skeletons' lengths");
        }
        let modes = |link: &Option<Link<T>>| link.map_or(JointModes::default(), |link| clip.modes()[link.source]);
        let modes = self.links.iter().map(modes).collect();
        Ok(Clip::new(joints, clip.times().to_vec(), keys)?.with_modes(modes)?.with_name(clip.name()))
    }
}

/// For each of the target's names the first joint of the source that has it; of joints with the same name only the first.
fn namesakes(source: &[String], target: &[String]) -> Vec<Option<usize>> {
    let namesake = |(joint, name): (usize, &String)| {
        let first = !target[..joint].contains(name);
        if first && !name.is_empty() { source.iter().position(|other| other == name) } else { None }
    };
    target.iter().enumerate().map(namesake).collect()
}

fn ratio<T: Real>(from: T, to: T) -> Option<T> {
    let ratio = to / from;
    (from > T::ZERO && to > T::ZERO && ratio.is_finite()).then_some(ratio)
}

fn names_where<T>(skeleton: &Skeleton<T>, is_wanted: impl Fn(usize) -> bool) -> Vec<String> {
    let names = skeleton.names().iter().enumerate();
    names.filter(|(joint, _)| is_wanted(*joint)).map(|(_, name)| name.clone()).collect()
}

/// The names that come more than once in one of the lists, each once.
fn repeated(lists: &[&[String]]) -> Vec<String> {
    let mut found: Vec<String> = Vec::new();
    for names in lists {
        for (joint, name) in names.iter().enumerate() {
            if names[..joint].contains(name) && !found.contains(name) {
                found.push(name.clone());
            }
        }
    }
    found
}
