//! The values of a channel over time.

use alloc::vec::Vec;

/// What a channel drives, as it goes from key to key. Rotations are unit quaternions x, y, z, w.
#[derive(Clone, Debug)]
pub(super) enum Curve<const N: usize> {
    /// Values at times, at least one.
    Keys(Keys<N>),
    /// Cubic splines between times.
    Spline(Spline<N>),
}

/// Values at times. Before the first and after the last it is these.
#[derive(Clone, Debug)]
pub(super) struct Keys<const N: usize> {
    /// In seconds, increasing.
    pub(super) times: Vec<f32>,
    pub(super) values: Vec<[f64; N]>,
    /// Whether each value holds until the next key, instead of going over into it.
    pub(super) holds: bool,
}

/// One cubic from each time to the next, given by the four points of Bezier: it begins at the first, ends at the last and stays
/// within their hull.
#[derive(Clone, Debug)]
pub(super) struct Spline<const N: usize> {
    /// In seconds, increasing, one more than there are cubics.
    pub(super) times: Vec<f32>,
    pub(super) cubics: Vec<[[f64; N]; 4]>,
}

/// What moves a joint, and by which channels.
#[derive(Default)]
pub(super) struct Movement {
    pub(super) translation: Option<(usize, Curve<3>)>,
    pub(super) rotation: Option<(usize, Curve<4>)>,
    /// How far an animated scale gets from the one at rest, relative to it.
    pub(super) scale: Option<(usize, f64)>,
}

impl<const N: usize> Curve<N> {
    pub(super) fn is_spline(&self) -> bool {
        matches!(self, Self::Spline(_))
    }

    /// No value of the curve is longer.
    pub(super) fn longest(&self) -> f64 {
        let longest = |points: &[[f64; N]]| points.iter().map(|&point| length(point)).fold(0.0, f64::max);
        match self {
            Self::Keys(keys) => longest(&keys.values),
            Self::Spline(spline) => longest(spline.cubics.as_flattened()),
        }
    }
}

impl<const N: usize> Keys<N> {
    /// The value at a time. `cursor` is where the search left off for an earlier time; it starts at 0.
    pub(super) fn at(
        &self,
        time: f32,
        cursor: &mut usize,
        mix: impl Fn([f64; N], [f64; N], f64) -> [f64; N],
    ) -> [f64; N] {
        while self.times.get(*cursor + 1).is_some_and(|&next| next <= time) {
            *cursor += 1;
        }
        let value = self.values[*cursor];
        let before = self.times[*cursor];
        match self.values.get(*cursor + 1) {
            Some(&next) if !self.holds && time > before => {
                let after = f64::from(self.times[*cursor + 1]);
                let before = f64::from(before);
                mix(value, next, (f64::from(time) - before) / (after - before))
            }
            _ => value,
        }
    }
}

/// The Euclidean length of a vector of any size.
pub(super) fn length<const N: usize>(vector: [f64; N]) -> f64 {
    <f64 as crate::Real>::norm(vector)
}
