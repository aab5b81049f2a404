//! Motion made for one skeleton, played on another.

use alloc::collections::{BTreeMap, BTreeSet};
use alloc::string::String;
use alloc::vec::Vec;

use super::kinematics::check_length;
use super::{Clip, ClipError, JointModes, KeyMode, Skeleton, SkeletonError, local_to_model};
use crate::{Direction, Motor, Point, Real, Rotor, Translator};

#[cfg(test)]
mod tests;

/// Carries poses of one skeleton over to another of different proportions, whose joints have the same names.
///
/// Both rest poses must show the same stance, seen in each skeleton's own space; the axes of the joints' frames may differ. Joints that
/// have a namesake are *matched*.
/// - Rotations: a joint turns, seen from the skeleton's space, as far from its rest as its namesake does.
/// - Translations: how far a joint is displaced from its rest, seen from the next matched joint above, or from the skeleton's space where
///   there is none, is scaled by the length of its bone over that of its namesake: the distance at rest to that joint. Where
///   there is none, and where one of the two bones has no length, it is the ratio of the sums of all these lengths.
/// - Joints without a namesake keep their rest pose. What those of the source do reaches the joints below them.
///
/// It keeps buffers, so that [`Retarget::pose_into`] allocates nothing.
#[derive(Clone, Debug)]
pub struct Retarget<T> {
    source: Skeleton<T>,
    target: Skeleton<T>,
    links: Vec<Option<Link<T>>>,
    source_model: Vec<Motor<T>>,
    target_model: Vec<Motor<T>>,
    unmatched: Unmatched,
}

/// The joints that have no counterpart: their indexes and names.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Unmatched {
    /// Joints of the skeleton that the motion was made for.
    pub source: Vec<(usize, String)>,
    /// Joints of the skeleton that it is played on; they keep their rest pose.
    pub target: Vec<(usize, String)>,
    /// Names that several joints of one skeleton have; the first of them counts. The others stand in the lists above as well.
    pub repeated: Vec<String>,
}

/// How a joint of the target follows one of the source.
#[derive(Clone, Copy, Debug)]
struct Link<T> {
    joint: usize,
    /// The next matched joint above that one.
    above: Option<usize>,
    /// Where that one is at rest, seen from there.
    rest: Direction<T>,
    /// The rotation of that one at rest, in the skeleton's space.
    rest_rotor: Rotor<T>,
    /// From the frame of the source's joint above to that of the target's.
    frames: Rotor<T>,
    /// The length of the joint's bone over that of its namesake.
    scale: T,
    /// Where the joint is at rest, seen from the next matched joint above it in the target.
    target_rest: Direction<T>,
    /// The joint's rotation at rest, in the skeleton's space.
    target_rest_rotor: Rotor<T>,
    /// From the frame of that joint above to the joint's parent's: nothing matched stands between, so it is that at rest.
    to_parent: Motor<T>,
}

/// A bone: from the next matched joint above to a joint, at rest.
#[derive(Clone, Copy)]
struct Bone<T> {
    above: Option<usize>,
    vector: Direction<T>,
    /// 0 where rounding errors are all there is, or nothing stands above.
    length: T,
}

impl<T: Real> Bone<T> {
    fn of(skeleton: &Skeleton<T>, joint: usize, is_matched: impl Fn(usize) -> bool) -> Self {
        let above = ancestors(skeleton, joint).find(|&joint| is_matched(joint));
        let rest = skeleton.rest_pose();
        let vector = between(skeleton, rest, above, joint).translator().vector();
        let parts = core::iter::once(joint).chain(ancestors(skeleton, joint)).take_while(|&joint| Some(joint) != above);
        let sum = parts.fold(T::ZERO, |sum, joint| sum + rest[joint].translator().vector().norm());
        let length = vector.norm();
        let is_one = above.is_some() && length > T::from_ratio(64, 1) * T::EPSILON * sum;
        Self { above, vector, length: if is_one { length } else { T::ZERO } }
    }
}

/// The bones of two joints of the same name.
#[derive(Clone, Copy)]
struct Pair<T> {
    /// The source's joint.
    namesake: usize,
    from: Bone<T>,
    to: Bone<T>,
}

impl<T: Real> Pair<T> {
    fn ratio(&self) -> Option<T> {
        ratio(self.from.length, self.to.length)
    }
}

/// The joints above, from the parent up.
fn ancestors<T>(skeleton: &Skeleton<T>, joint: usize) -> impl Iterator<Item = usize> {
    core::iter::successors(skeleton.parent(joint), |&joint| skeleton.parent(joint))
}

/// Where a joint's frame is in that of one above, or in the skeleton's space, by the local motors on the way.
fn between<T: Real>(skeleton: &Skeleton<T>, pose: &[Motor<T>], above: Option<usize>, joint: usize) -> Motor<T> {
    let way = ancestors(skeleton, joint).take_while(|&joint| Some(joint) != above);
    way.fold(pose[joint], |motor, joint| pose[joint] * motor)
}

impl<T: Real> Retarget<T> {
    /// From a skeleton that motion was made for to one that it is to be played on. [`Retarget::unmatched`] tells which joints found no
    /// counterpart.
    pub fn new(source: &Skeleton<T>, target: &Skeleton<T>) -> Self {
        let namesakes = namesakes(source.names(), target.names());
        let mut is_used = alloc::vec![false; source.len()];
        namesakes.iter().flatten().for_each(|&joint| is_used[joint] = true);
        let bones: Vec<Option<Pair<T>>> = namesakes
            .iter()
            .enumerate()
            .map(|(joint, &namesake)| {
                let to = Bone::of(target, joint, |joint| namesakes[joint].is_some());
                namesake.map(|namesake| Pair { namesake, from: Bone::of(source, namesake, |joint| is_used[joint]), to })
            })
            .collect();
        let sum = |length: fn(&Pair<T>) -> T| {
            let pairs = bones.iter().flatten().filter(|pair| pair.ratio().is_some());
            pairs.fold(T::ZERO, |sum, pair| sum + length(pair))
        };
        let overall = ratio(sum(|pair| pair.from.length), sum(|pair| pair.to.length)).unwrap_or(T::ONE);
        let (source_rest, target_rest) = (rest_models(source), rest_models(target));
        let rotor_of =
            |rest: &[Motor<T>], joint: Option<usize>| joint.map_or(Rotor::IDENTITY, |joint| rest[joint].rotor());
        let link = |joint: usize, pair: Pair<T>| {
            let Pair { namesake, from, to } = pair;
            let to_parent = match target.parent(joint) {
                Some(parent) if Some(parent) != to.above => {
                    between(target, target.rest_pose(), to.above, parent).reverse()
                }
                _ => Motor::IDENTITY,
            };
            Link {
                joint: namesake,
                above: from.above,
                rest: from.vector,
                rest_rotor: source_rest[namesake].rotor(),
                frames: rotor_of(&target_rest, to.above).reverse() * rotor_of(&source_rest, from.above),
                scale: pair.ratio().unwrap_or(overall),
                target_rest: to.vector,
                target_rest_rotor: target_rest[joint].rotor(),
                to_parent,
            }
        };
        let links = bones.iter().enumerate().map(|(joint, bones)| bones.map(|bones| link(joint, bones))).collect();
        let unmatched = Unmatched {
            source: names_where(source, |joint| !is_used[joint]),
            target: names_where(target, |joint| namesakes[joint].is_none()),
            repeated: repeated(&[source.names(), target.names()]),
        };
        let (source, target) = (source.clone(), target.clone());
        Self { source, target, links, source_model: source_rest, target_model: target_rest, unmatched }
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
        check_length("pose", self.source.len(), pose.len())?;
        check_length("out", self.target.len(), out.len())?;
        local_to_model(&self.source, pose, &mut self.source_model)?;
        for (joint, out) in out.iter_mut().enumerate() {
            let parent = self.target.parent(joint).map_or(Motor::IDENTITY, |parent| self.target_model[parent]);
            let rest = self.target.rest_pose()[joint];
            let local = self.links[joint].map_or(rest, |link| self.follow(link, parent, pose));
            self.target_model[joint] = parent * local;
            *out = local;
        }
        Ok(())
    }

    /// The local motor of a joint of the target, whose parent has this model motor in the new pose.
    fn follow(&self, link: Link<T>, parent: Motor<T>, pose: &[Motor<T>]) -> Motor<T> {
        // As far from rest as the namesake, in the skeleton's space; seen from the parent as it is now.
        let turn = self.source_model[link.joint].rotor() * link.rest_rotor.reverse();
        let rotor = parent.rotor().reverse() * turn * link.target_rest_rotor;
        let place = between(&self.source, pose, link.above, link.joint).translator().vector();
        let place = link.target_rest + link.frames.transform_direction(place - link.rest) * link.scale;
        let seen = link.to_parent.transform_point(Point::ORIGIN + place) - Point::ORIGIN;
        Motor::from_rotor_translator(rotor, Translator::from_vector(seen)).renormalize()
    }

    /// A clip of the source as one of the target, key by key.
    ///
    /// A part that holds from key to key holds in the target too, if nothing does not that reaches it through joints without a
    /// namesake.
    ///
    /// # Errors
    /// [`ClipError::JointCount`] where the clip has another number of joints than the source; [`ClipError::NonFinite`] where a length
    /// leaves the range of the numbers.
    pub fn clip(&mut self, clip: &Clip<T>) -> Result<Clip<T>, ClipError> {
        let expected = self.source.len();
        if clip.joint_count() != expected {
            return Err(ClipError::JointCount { what: "clip", expected, found: clip.joint_count() });
        }
        let joints = self.target.len();
        let mut keys = alloc::vec![Motor::IDENTITY; clip.key_count() * joints];
        for (key, out) in keys.chunks_exact_mut(joints).enumerate() {
            let pose = clip.key(key).expect("invariant: a key below the number of keys");
            self.pose_into(pose, out).expect("invariant: buffers of the skeletons' lengths");
        }
        let modes = self.links.iter().map(|link| link.map_or(JointModes::default(), |link| self.modes(link, clip)));
        let modes = modes.collect();
        Ok(Clip::new(joints, clip.times().to_vec(), keys)?.with_modes(modes)?.with_name(clip.name()))
    }

    fn modes(&self, link: Link<T>, clip: &Clip<T>) -> JointModes {
        let through = ancestors(&self.source, link.joint).take_while(|&joint| Some(joint) != link.above);
        through.fold(clip.modes()[link.joint], |modes, joint| {
            let JointModes { rotation, translation } = clip.modes()[joint];
            let both = |a, b| if a == KeyMode::Step { b } else { a };
            JointModes {
                rotation: both(modes.rotation, rotation),
                translation: both(modes.translation, both(rotation, translation)),
            }
        })
    }
}

fn rest_models<T: Real>(skeleton: &Skeleton<T>) -> Vec<Motor<T>> {
    let mut models = alloc::vec![Motor::IDENTITY; skeleton.len()];
    local_to_model(skeleton, skeleton.rest_pose(), &mut models).expect("invariant: buffers of the skeleton's length");
    models
}

/// Where each name comes first; empty names do not count.
fn places(names: &[String]) -> BTreeMap<&str, usize> {
    let mut places = BTreeMap::new();
    for (joint, name) in names.iter().enumerate().filter(|(_, name)| !name.is_empty()) {
        places.entry(name.as_str()).or_insert(joint);
    }
    places
}

/// For each of the target's joints the first of the source that has its name; of joints with the same name only the first has one.
fn namesakes(source: &[String], target: &[String]) -> Vec<Option<usize>> {
    let (source, firsts) = (places(source), places(target));
    let namesake = |(joint, name): (usize, &String)| {
        let is_first = firsts.get(name.as_str()) == Some(&joint);
        source.get(name.as_str()).copied().filter(|_| is_first)
    };
    target.iter().enumerate().map(namesake).collect()
}

fn ratio<T: Real>(from: T, to: T) -> Option<T> {
    let ratio = to / from;
    (from > T::ZERO && to > T::ZERO && ratio.is_finite()).then_some(ratio)
}

fn names_where<T>(skeleton: &Skeleton<T>, is_wanted: impl Fn(usize) -> bool) -> Vec<(usize, String)> {
    let names = skeleton.names().iter().enumerate();
    names.filter(|(joint, _)| is_wanted(*joint)).map(|(joint, name)| (joint, name.clone())).collect()
}

/// The names that come more than once in one of the lists, each once, in alphabetical order.
fn repeated(lists: &[&[String]]) -> Vec<String> {
    let mut found = BTreeSet::new();
    for names in lists {
        let firsts = places(names);
        let is_later = |(joint, name): &(usize, &String)| firsts.get(name.as_str()).is_some_and(|first| first != joint);
        found.extend(names.iter().enumerate().filter(is_later).map(|(_, name)| name.clone()));
    }
    found.into_iter().collect()
}
