//! Animations as clips: the channels of all joints on one list of times.

use alloc::collections::BTreeMap;
use alloc::string::String;
use alloc::vec::Vec;

use ::gltf::json::Root;
use ::gltf::json::animation::{Animation, Sampler};

use super::allowance::{Allowance, MAX_JOINT_KEYS, MAX_VALUES};
use super::buffers::Buffers;
use super::channel;
use super::curve::{Keys, Movement};
use super::document::check_index;
use super::error::{GltfError, GltfReason};
use super::hierarchy::Hierarchy;
use super::place::{Named, Place, Property, full_name};
use super::similarity::{cast, rigid};
use super::spline::{refine_rotation, refine_translation};
use super::tolerance::Tolerances;
use super::warning::Warning;
use crate::skeleton::{Clip, ClipError, JointModes, KeyMode};
use crate::{Motor, Real, Rotor};

/// Reads animations.
pub(super) struct Reader<'a, 'b> {
    pub(super) root: &'a Root,
    pub(super) hierarchy: &'a Hierarchy,
    pub(super) buffers: &'a mut Buffers<'b>,
    pub(super) warnings: &'a mut Vec<Warning>,
    values: Allowance,
    joint_keys: Allowance,
}

impl<'a, 'b> Reader<'a, 'b> {
    pub(super) fn new(
        root: &'a Root,
        hierarchy: &'a Hierarchy,
        buffers: &'a mut Buffers<'b>,
        warnings: &'a mut Vec<Warning>,
    ) -> Self {
        let values = Allowance::new(MAX_VALUES, "values of channels in all animations together");
        let joint_keys = Allowance::new(MAX_JOINT_KEYS, "keys of joints in all clips together");
        Self { root, hierarchy, buffers, warnings, values, joint_keys }
    }

    /// One clip for each animation, in the file's order.
    pub(super) fn read<T: Real>(&mut self) -> Result<Vec<Clip<T>>, GltfError> {
        (0..self.root.animations.len()).map(|index| self.read_animation(index)).collect()
    }

    fn read_animation<T: Real>(&mut self, index: usize) -> Result<Clip<T>, GltfError> {
        let animation = &self.root.animations[index];
        let mut movements: Vec<Movement> = Vec::new();
        movements.resize_with(self.hierarchy.joints.len(), Movement::default);
        let mut seen = BTreeMap::new();
        for channel in 0..animation.channels.len() {
            let target = self.target(animation, channel).map_err(|reason| {
                let animation = Named::animation(self.root, index);
                reason.at(Place::Channel { animation, channel, target: None })
            })?;
            let place = self.place(index, channel, target);
            let Some((property, node)) = target else {
                self.warnings.push(Warning::ChannelSkipped { place });
                continue;
            };
            if property == Property::Weights {
                self.warnings.push(Warning::MorphWeights { place });
                continue;
            }
            // What is not part of the skeleton may move as it likes.
            let Some(joint) = self.hierarchy.joint(node) else { continue };
            if let Some(first) = seen.insert((joint, property), channel) {
                return Err(GltfReason::RepeatedChannel { first }.at(place));
            }
            self.read_channel(animation, channel, (property, joint), &place, &mut movements)
                .map_err(|reason| reason.at(place))?;
        }
        let keys = self.refine(index, movements)?;
        self.assemble(index, &keys)
    }

    /// What a channel drives.
    fn target(&self, animation: &Animation, channel: usize) -> Result<Option<(Property, usize)>, GltfReason> {
        let target = &animation.channels[channel].target;
        match channel::property(target.path) {
            None => Ok(None),
            Some(property) => {
                let node = check_index("a node", target.node.value(), self.root.nodes.len())?;
                Ok(Some((property, node)))
            }
        }
    }

    fn place(&self, animation: usize, channel: usize, target: Option<(Property, usize)>) -> Place {
        let target = target.map(|(property, node)| (property, Named::node(self.root, node)));
        Place::Channel { animation: Named::animation(self.root, animation), channel, target }
    }

    fn read_channel(
        &mut self,
        animation: &Animation,
        channel: usize,
        (property, joint): (Property, usize),
        place: &Place,
        movements: &mut [Movement],
    ) -> Result<(), GltfReason> {
        let sampler = animation.channels[channel].sampler.value();
        let sampler: &Sampler = &animation.samplers[check_index("a sampler", sampler, animation.samplers.len())?];
        self.values.spend(channel::count_values(self.buffers, sampler)?)?;
        match property {
            Property::Translation => {
                let curve = channel::read_translation(self.buffers, sampler)?;
                movements[joint].translation = Some((channel, curve));
            }
            Property::Rotation => {
                let (curve, mending) = channel::read_rotation(self.buffers, sampler)?;
                movements[joint].rotation = Some((channel, curve));
                if mending.renormalized > 0 {
                    let (count, worst) = (mending.renormalized, mending.worst);
                    self.warnings.push(Warning::Renormalized { place: place.clone(), count, worst });
                }
                if mending.realigned > 0 {
                    self.warnings.push(Warning::Realigned { place: place.clone(), count: mending.realigned });
                }
            }
            Property::Scale => {
                let rest = self.hierarchy.joints[joint].rest.scale;
                let worst = channel::check_scale(self.buffers, sampler, rest)?;
                // A few roundings in single precision are no difference.
                if worst > 1e-6 {
                    self.warnings.push(Warning::ScaleDropped { place: place.clone(), worst });
                }
                movements[joint].scale = Some((channel, worst));
            }
            Property::Weights => {}
        }
        Ok(())
    }

    /// Follows the splines with keys, so closely that positions are right.
    fn refine(&mut self, index: usize, movements: Vec<Movement>) -> Result<Vec<JointKeys>, GltfError> {
        let tolerances = Tolerances::of(self.hierarchy, &movements);
        if let Some((joint, channel, off)) = tolerances.scale_too_far(&movements) {
            let place = self.place(index, channel, Some((Property::Scale, self.hierarchy.joints[joint].node)));
            return Err(GltfReason::ScaleDrift { off }.at(place));
        }
        let mut all = Vec::with_capacity(movements.len());
        for (joint, Movement { translation, rotation, .. }) in movements.into_iter().enumerate() {
            let node = self.hierarchy.joints[joint].node;
            let fault = |property, channel| {
                let place = self.place(index, channel, Some((property, node)));
                move |reason: GltfReason| reason.at(place)
            };
            let mut keys = JointKeys { translation: None, rotation: None };
            let mut added = 0;
            if let Some((channel, curve)) = translation {
                let is_spline = curve.is_spline();
                let refined = refine_translation(curve, tolerances.translation(joint))
                    .map_err(fault(Property::Translation, channel))?;
                added += if is_spline { refined.times.len() } else { 0 };
                keys.translation = Some(refined);
            }
            if let Some((channel, curve)) = rotation {
                let is_spline = curve.is_spline();
                let refined =
                    refine_rotation(curve, tolerances.rotation(joint)).map_err(fault(Property::Rotation, channel))?;
                added += if is_spline { refined.times.len() } else { 0 };
                keys.rotation = Some(refined);
            }
            self.values.spend(added).map_err(|reason| self.fault(index, reason))?;
            all.push(keys);
        }
        Ok(all)
    }

    fn fault(&self, animation: usize, reason: GltfReason) -> GltfError {
        reason.at(Place::Animation(Named::animation(self.root, animation)))
    }

    /// The clip: every joint at every time at which any channel has a key. In between nothing is lost, as what goes straight, or
    /// along a great arc, or holds, does so in parts too.
    fn assemble<T: Real>(&mut self, index: usize, joints: &[JointKeys]) -> Result<Clip<T>, GltfError> {
        let times = union(joints);
        let count = times.len().saturating_mul(joints.len());
        self.joint_keys.spend(count).map_err(|reason| self.fault(index, reason))?;
        let mut keys = alloc::vec![Motor::<T>::IDENTITY; count];
        for (joint, joint_keys) in joints.iter().enumerate() {
            let (rest, above) = (&self.hierarchy.joints[joint].rest, self.hierarchy.joints[joint].scale_above);
            let still =
                joint_keys.is_still().then(|| joint_keys.sampler(rest.rotation, rest.translation.to_array())(0.0));
            let mut at = joint_keys.sampler(rest.rotation, rest.translation.to_array());
            for (key, &time) in times.iter().enumerate() {
                let (rotation, translation) = still.unwrap_or_else(|| at(time));
                let motor = cast::<T>(rigid(rotation, crate::Direction::from(translation) * above));
                if !motor.is_finite() {
                    let node = Named::node(self.root, self.hierarchy.joints[joint].node);
                    let what = alloc::format!("place of node {node} at {time} s, in the type read into");
                    return Err(self.fault(index, GltfReason::NotFinite { what }));
                }
                keys[key * joints.len() + joint] = motor;
            }
        }
        let modes = joints.iter().map(JointKeys::modes).collect();
        let name: String = full_name("animation", index, self.root.animations[index].name.as_ref());
        let times = times.into_iter().map(|time| T::from_f64(time.into())).collect();
        let clip = Clip::new(joints.len(), times, keys).and_then(|clip| clip.with_modes(modes));
        clip.map(|clip| clip.with_name(name)).map_err(|error: ClipError| self.fault(index, GltfReason::Clip(error)))
    }
}

/// The keys of a joint; `None` where it keeps what it has at rest.
struct JointKeys {
    translation: Option<Keys<3>>,
    rotation: Option<Keys<4>>,
}

impl JointKeys {
    /// Whether the joint stands still.
    fn is_still(&self) -> bool {
        self.translation.as_ref().is_none_or(|keys| keys.times.len() == 1)
            && self.rotation.as_ref().is_none_or(|keys| keys.times.len() == 1)
    }

    /// How the joint gets from key to key. A part that stands still goes with the other, for that is cheaper to sample.
    fn modes(&self) -> JointModes {
        fn mode<const N: usize>(keys: Option<&Keys<N>>) -> Option<KeyMode> {
            let keys = keys.filter(|keys| keys.times.len() > 1)?;
            Some(if keys.holds { KeyMode::Step } else { KeyMode::Linear })
        }
        let (translation, rotation) = (mode(self.translation.as_ref()), mode(self.rotation.as_ref()));
        JointModes {
            rotation: rotation.or(translation).unwrap_or_default(),
            translation: translation.or(rotation).unwrap_or_default(),
        }
    }

    /// Where the joint is at times that are asked for in increasing order.
    fn sampler(&self, rotation: Rotor<f64>, translation: [f64; 3]) -> impl FnMut(f32) -> (Rotor<f64>, [f64; 3]) {
        let (mut translated, mut rotated) = (0, 0);
        move |time| {
            let line = |a: [f64; 3], b: [f64; 3], t: f64| core::array::from_fn(|i| a[i] + t * (b[i] - a[i]));
            let translation =
                self.translation.as_ref().map_or(translation, |keys| keys.at(time, &mut translated, line));
            let rotation = self.rotation.as_ref().map_or(rotation, |keys| unit(keys.at(time, &mut rotated, arc)));
            (rotation, translation)
        }
    }
}

/// The rotor of a quaternion that is unit.
fn unit([x, y, z, w]: [f64; 4]) -> Rotor<f64> {
    Rotor::new(w, -x, -y, -z)
}

/// The point of the great arc between two quaternions.
fn arc(a: [f64; 4], b: [f64; 4], t: f64) -> [f64; 4] {
    unit(a).slerp(unit(b), t).to_quaternion_xyzw()
}

/// All times at which a joint has a key, and 0 where there is none.
fn union(joints: &[JointKeys]) -> Vec<f32> {
    let mut times: Vec<f32> = Vec::new();
    for joint in joints {
        times.extend(joint.translation.iter().flat_map(|keys| &keys.times));
        times.extend(joint.rotation.iter().flat_map(|keys| &keys.times));
    }
    if times.is_empty() {
        times.push(0.0);
    }
    times.sort_unstable_by(f32::total_cmp);
    // By value, for 0 and -0 are one time.
    times.dedup();
    times
}
