//! From where the figure is looked at, and how large it is drawn.

use pga_motor::{Direction, Motor, Point, Rotor, Translator};

/// How far one looks down on the figure, in radians.
pub(crate) const TILT: f64 = std::f64::consts::PI / 20.0;

/// A parallel view with y up. Each figure is brought with the ground under its root to the origin of its panel.
pub(crate) struct View {
    camera: Rotor<f64>,
    /// How far the camera has turned the figure about the upward axis, in radians.
    pub(crate) turn: f64,
    /// Height of the ground in the skeleton's space.
    pub(crate) ground: f64,
    /// Unit vector in the ground, x and z, from left to right in the picture: the way the figure goes, if it does.
    pub(crate) track: [f64; 2],
    /// The diagonal of the box around the figure where it is largest.
    pub(crate) size: f64,
}

/// A point as seen: x to the right and y up, in the skeleton's unit, and how near it is.
#[derive(Clone, Copy)]
pub(crate) struct Seen {
    pub(crate) x: f64,
    pub(crate) y: f64,
    pub(crate) near: f64,
}

impl View {
    /// A view in which a figure that travels goes to the right and a little towards us, and one that stays looks there.
    pub(crate) fn of(figures: &[&[Point<f64>]]) -> Self {
        let size = figures.iter().map(|points| diagonal(points)).fold(0.0, f64::max);
        // A figure that is a single point has no size of its own.
        let size = if size > 1e-100 { size } else { 1.0 };
        let ground = figures.iter().copied().flatten().map(|point| point.y).fold(f64::INFINITY, f64::min);
        let travel = travel(figures, size / 2.0);
        // The angle from +z, where a figure looks in the absence of anything better, towards +x.
        let heading = travel.map_or(0.0, |[x, z]| x.atan2(z));
        let turn: f64 = if travel.is_some() { 60.0 } else { 25.0 };
        let turn = turn.to_radians() - heading;
        let camera = Rotor::about_x(TILT) * Rotor::about_y(turn);
        Self { camera, turn, ground, track: travel.unwrap_or([1.0, 0.0]), size }
    }

    /// The motor that takes a figure to its panel.
    pub(crate) fn panel_motor(&self, root: Point<f64>) -> Motor<f64> {
        let to_origin = Translator::from_vector(Direction::new(-root.x, -self.ground, -root.z));
        self.camera * to_origin
    }
}

impl Seen {
    pub(crate) fn through(panel: Motor<f64>, point: Point<f64>) -> Self {
        let Point { x, y, z } = panel.transform_point(point);
        Self { x, y, near: z }
    }
}

/// The direction from the root's first place to its last, if they are at least `least` apart on the ground.
fn travel(figures: &[&[Point<f64>]], least: f64) -> Option<[f64; 2]> {
    let [first, last] = [figures.first()?[0], figures.last()?[0]];
    let [x, z] = [last.x - first.x, last.z - first.z];
    let distance = x.hypot(z);
    (distance > least).then(|| [x / distance, z / distance])
}

fn diagonal(points: &[Point<f64>]) -> f64 {
    let edge = |of: fn(&Point<f64>) -> f64| {
        let (low, high) =
            points.iter().map(of).fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), x| (l.min(x), h.max(x)));
        high - low
    };
    edge(|p| p.x).hypot(edge(|p| p.y)).hypot(edge(|p| p.z))
}

/// The largest of 1, 2, 5 times a power of ten that is not above `length`.
pub(crate) fn nice(length: f64) -> f64 {
    let power = 10_f64.powf(length.log10().floor());
    [5.0, 2.0, 1.0].into_iter().map(|digit| digit * power).find(|&candidate| candidate <= length).unwrap_or(power)
}
