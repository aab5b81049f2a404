//! A clip being played: where the points of the figure are, at any time.

use pga_motor::skeleton::{Clip, ClipError, Interpolation, SkeletonInstance, Wrap, animate_sample};
use pga_motor::{Motor, Point};

use super::anatomy::Anatomy;
use super::source::Source;

/// A clip of a source on its skeleton.
pub(crate) struct Player<'a> {
    source: &'a Source,
    clip_name: String,
    clip: Clip<f64>,
    interpolation: Interpolation,
    every: usize,
    instance: SkeletonInstance<f64>,
    scratch: Vec<Motor<f64>>,
}

impl<'a> Player<'a> {
    /// Plays the clip at an index, each `every`-th key of it.
    pub(crate) fn new(
        source: &'a Source,
        clip: usize,
        every: usize,
        interpolation: Interpolation,
    ) -> Result<Self, ClipError> {
        Ok(Self {
            clip_name: source.clip_name(clip),
            clip: thinned(&source.clips[clip], every)?,
            interpolation,
            every,
            instance: SkeletonInstance::new(&source.skeleton, Motor::IDENTITY),
            scratch: source.skeleton.rest_pose().to_vec(),
            source,
        })
    }

    pub(crate) fn source(&self) -> &Source {
        self.source
    }

    pub(crate) fn anatomy(&self) -> Anatomy {
        Anatomy::of(self.source)
    }

    pub(crate) fn clip(&self) -> &Clip<f64> {
        &self.clip
    }

    pub(crate) fn clip_name(&self) -> &str {
        &self.clip_name
    }

    pub(crate) fn interpolation(&self) -> Interpolation {
        self.interpolation
    }

    /// The source's name, and the clip's where that says more.
    pub(crate) fn title(&self) -> String {
        let (name, clip) = (&self.source.name, &self.clip_name);
        let stem = name.rsplit_once('.').map_or(name.as_str(), |(stem, _)| stem);
        if stem == clip { name.clone() } else { format!("{name}, {clip}") }
    }

    pub(crate) fn summary(&self) -> String {
        let (joints, keys, seconds) = (self.source.joints.len(), self.clip.key_count(), self.clip.duration());
        let thinned = if self.every > 1 { format!(" (one in {})", self.every) } else { String::new() };
        let way = self.interpolation.name();
        format!("joints: {joints}, keys: {keys}{thinned}, duration: {seconds:.3} s, interpolation: {way}")
    }

    /// Whether the clip has a pose of its own at a time in seconds.
    pub(crate) fn is_within(&self, time: f64) -> bool {
        (self.clip.start()..=self.clip.end()).contains(&time)
    }

    /// Times from the clip's start to its end, of which it has `count`, or one if it stands still.
    pub(crate) fn times(&self, count: usize) -> Vec<f64> {
        let (start, duration) = (self.clip.start(), self.clip.duration());
        let steps = if duration > 0.0 { count.max(2) - 1 } else { 0 };
        (0..=steps).map(|step| start + duration * (step as f64 / steps.max(1) as f64)).collect()
    }

    /// Where the source's joints are at a time in seconds, in its order, and behind them its tips.
    pub(crate) fn points(&mut self, time: f64, interpolation: Interpolation) -> Result<Vec<Point<f64>>, String> {
        let Self { source, clip, instance, scratch, .. } = self;
        animate_sample(&source.skeleton, instance, clip, time, interpolation, Wrap::Clamp, scratch)
            .map_err(|error| format!("{}: {error}", source.name))?;
        let joints = source.joints.iter().map(|&joint| instance.joint_positions[joint]);
        let tips = source.tips.iter().map(|tip| {
            let end = Point::new(tip.offset.x, tip.offset.y, tip.offset.z);
            instance.model()[tip.joint].transform_point(end)
        });
        let points: Vec<_> = joints.chain(tips).collect();
        if points.iter().all(|point| is_within(*point, f64::MAX)) {
            Ok(points)
        } else {
            Err(format!("{}: expected all joints at finite places at {time} s", source.name))
        }
    }

    /// The same for pictures, whose arithmetic needs some room.
    pub(crate) fn drawable_points(
        &mut self,
        time: f64,
        interpolation: Interpolation,
    ) -> Result<Vec<Point<f64>>, String> {
        /// In the clip's unit of length.
        const FARTHEST: f64 = 1e100;
        let points = self.points(time, interpolation)?;
        if points.iter().all(|point| is_within(*point, FARTHEST)) {
            Ok(points)
        } else {
            Err(format!("{}: expected all joints within {FARTHEST:e} of the origin at {time} s", self.source.name))
        }
    }
}

/// Whether no coordinate is larger; false for NaN.
fn is_within(point: Point<f64>, largest: f64) -> bool {
    [point.x, point.y, point.z].iter().all(|x| x.abs() <= largest)
}

/// The clip with each `every`-th key, from the first on, and the last, so that it stays as long as it is.
fn thinned(clip: &Clip<f64>, every: usize) -> Result<Clip<f64>, ClipError> {
    let last = clip.key_count() - 1;
    let kept: Vec<usize> = (0..=last).filter(|key| key % every == 0 || *key == last).collect();
    let times = kept.iter().map(|&key| clip.times()[key]).collect();
    let keys = kept.iter().filter_map(|&key| clip.key(key)).flatten().copied().collect();
    Clip::new(clip.joint_count(), times, keys)?.with_modes(clip.modes().to_vec())
}
