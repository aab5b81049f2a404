//! The box, the two motions and the ways between them.

use pga_motor::pga2d::f64::{Direction, Motor, Point, Rotor, Translator};

/// How many boxes are drawn from one end to the other.
pub(crate) const BOXES: usize = 11;

/// How many pieces the path of the centre is drawn in.
const PIECES: usize = 120;

/// One interpolation, run through.
pub(crate) struct Way {
    pub(crate) name: &'static str,
    pub(crate) formula: &'static str,
    pub(crate) remark: &'static str,
    /// Where the box is at equal steps of t.
    pub(crate) motors: Vec<Motor>,
    /// Where its centre goes.
    pub(crate) path: Vec<Point>,
    /// The one point about which it turns, where there is one.
    pub(crate) center: Option<Point>,
}

impl Way {
    /// The smallest and the largest turn in a step of t, in degrees.
    pub(crate) fn turns(&self) -> [f64; 2] {
        let angles = self.motors.windows(2).map(|ends| (ends[0].reverse() * ends[1]).angle().to_degrees());
        angles.fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], angle| [low.min(angle), high.max(angle)])
    }
}

/// The box about its own origin, from its lower left corner counter-clockwise.
pub(crate) fn outline(motor: Motor) -> [Point; 4] {
    let mut corners = [(-0.7, -0.4), (0.7, -0.4), (0.7, 0.4), (-0.7, 0.4)].map(|(x, y)| Point::new(x, y));
    motor.transform_points_in_place(&mut corners);
    corners
}

/// A place above the box for its name.
pub(crate) fn name_place(motor: Motor) -> Point {
    motor.transform_origin() + Direction::new(0.0, 0.8)
}

/// A mark inside the box, at its right: which way it looks.
pub(crate) fn nose(motor: Motor) -> [Point; 3] {
    let mut corners = [(0.28, -0.18), (0.56, 0.0), (0.28, 0.18)].map(|(x, y)| Point::new(x, y));
    motor.transform_points_in_place(&mut corners);
    corners
}

fn ends() -> [Motor; 2] {
    let place =
        |x, y, degrees: f64| Translator::from_vector(Direction::new(x, y)) * Rotor::from_angle(degrees.to_radians());
    [place(0.0, 3.0, -160.0), place(7.2, 4.0, -20.0)]
}

/// What takes two motors and t.
type Interpolation = fn(Motor, Motor, f64) -> Motor;

/// nlerp, screw_lerp, log_lerp and split_lerp. slerp is screw_lerp in the plane.
pub(crate) fn ways() -> Vec<Way> {
    let [a, b] = ends();
    let center = (b * a.reverse()).center();
    let way = |name, formula, remark, center, interpolate: Interpolation| Way {
        name,
        formula,
        remark,
        motors: steps(BOXES - 1).map(|t| interpolate(a, b, t)).collect(),
        path: steps(PIECES).map(|t| interpolate(a, b, t).transform_origin()).collect(),
        center,
    };
    vec![
        way("nlerp", "a (1 − t) + b t, made unit", "about one centre, fastest in the middle", center, Motor::nlerp),
        way("screw_lerp", "a exp(t log(~a b))", "about one centre, evenly: the geodesic", center, Motor::screw_lerp),
        way(
            "log_lerp",
            "exp((1 − t) log a + t log b)",
            "along a curve that depends on the origin",
            None,
            Motor::log_lerp,
        ),
        way("split_lerp", "turn and translation apart", "the box’s centre goes straight", None, Motor::split_lerp),
    ]
}

fn steps(count: usize) -> impl Iterator<Item = f64> {
    (0..=count).map(move |step| step as f64 / count as f64)
}
