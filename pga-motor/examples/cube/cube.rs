//! The cube, and what of it is seen.

use pga_motor::f64::{Direction, Motor, Plane, Point, Rotor, UnitPlane};

/// Half an edge.
const HALF: f64 = 0.62;

/// How far the eye is in front of the picture, which stands upright in the origin.
const EYE: Point = Point::new(0.0, 0.0, 9.0);

/// How far one looks down, in radians.
const TILT: f64 = 0.42;

/// How bright a face is that no light falls on.
const AMBIENT: f64 = 0.42;

/// A face in the cube's own frame.
pub(crate) struct Face {
    /// The cube is on its negative side.
    plane: UnitPlane,
    /// Counter-clockwise as seen from outside.
    corners: [Point; 4],
    pub(crate) colour: [f64; 3],
}

/// Okabe and Ito's colours, which colour-blind people can tell apart.
const COLOURS: [[f64; 3]; 6] = [
    [230.0, 159.0, 0.0],
    [86.0, 180.0, 233.0],
    [0.0, 158.0, 115.0],
    [240.0, 228.0, 66.0],
    [213.0, 94.0, 0.0],
    [204.0, 121.0, 167.0],
];

/// The six faces, those that are opposite one after the other.
pub(crate) fn faces() -> [Face; 6] {
    let corners = [[1.0, 1.0], [-1.0, 1.0], [-1.0, -1.0], [1.0, -1.0]].map(|[x, y]| Point::new(x, y, 1.0));
    std::array::from_fn(|index| {
        let quarter = std::f64::consts::FRAC_PI_2;
        let towards = match index {
            0 => Rotor::about_y(quarter),
            1 => Rotor::about_y(-quarter),
            2 => Rotor::about_x(-quarter),
            3 => Rotor::about_x(quarter),
            4 => Rotor::IDENTITY,
            _ => Rotor::about_y(2.0 * quarter),
        };
        let corners = corners.map(|corner| {
            let corner = towards.transform_point(corner);
            Point::new(HALF * corner.x, HALF * corner.y, HALF * corner.z)
        });
        let [a, b, c, _] = corners;
        let plane = UnitPlane::from_points(a, b, c).expect("three corners of a face are not in a line");
        Face { plane, corners, colour: COLOURS[index] }
    })
}

/// What takes the cube's space to that of the eye, which looks along -z.
fn camera() -> Motor {
    Rotor::about_x(TILT).into()
}

/// Where the line from the eye to a point meets the picture.
pub(crate) fn project(point: Point) -> [f64; 2] {
    let picture = Plane::from(UnitPlane::new(0.0, 0.0, 1.0, 0.0));
    let sight = EYE & camera().transform_point(point);
    let hit = (picture ^ sight).to_point().expect("all points are in front of the eye");
    [hit.x, hit.y]
}

impl Face {
    /// How far the eye is in front of the face's plane; negative from behind, where the cube hides the face.
    pub(crate) fn turned_to_eye(&self, motor: Motor) -> f64 {
        (camera() * motor).transform_unit_plane(self.plane).signed_distance_to_point(EYE)
    }

    /// Its corners in the picture.
    pub(crate) fn outline(&self, motor: Motor) -> [[f64; 2]; 4] {
        self.corners.map(|corner| project(motor.transform_point(corner)))
    }

    /// Its colour in the light that falls on it: each face has one normal and so one brightness.
    pub(crate) fn shade(&self, motor: Motor) -> [f64; 3] {
        let light = Direction::new(-0.5, 0.8, 0.6).normalize().expect("the light comes from somewhere");
        let normal = motor.transform_unit_plane(self.plane).normal();
        let brightness = AMBIENT + (1.0 - AMBIENT) * normal.dot(light).max(0.0);
        self.colour.map(|part| part * brightness)
    }
}
