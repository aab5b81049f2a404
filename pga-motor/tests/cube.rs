//! What the example `cube` shows of its cube.

#[allow(dead_code, reason = "what is drawn is for the example")]
#[path = "../examples/cube/cube.rs"]
mod cube;
#[allow(dead_code, reason = "what is written is for the example")]
#[path = "../examples/cube/motion.rs"]
mod motion;

/// Twice the area inside a line in the picture, positive if it runs counter-clockwise.
fn area([a, b, c, d]: [[f64; 2]; 4]) -> f64 {
    (c[0] - a[0]) * (d[1] - b[1]) - (d[0] - b[0]) * (c[1] - a[1])
}

#[test]
fn faces_are_shown_where_their_outline_runs_counter_clockwise() {
    for motion in motion::all() {
        for step in 0..997 {
            let motor = (motion.at)(f64::from(step) / 997.0);
            let mut shown = 0;
            for face in cube::faces() {
                let (turned, area) = (face.turned_to_eye(motor), area(face.outline(motor)));
                // An edge-on face is neither, up to rounding.
                if turned.abs() > 1e-12 {
                    assert_eq!(turned > 0.0, area > 0.0, "{}, step {step}: {turned} and {area}", motion.name);
                }
                shown += usize::from(turned > 0.0);
            }
            assert!((1..=3).contains(&shown), "{}, step {step}: {shown} faces of a cube seen at once", motion.name);
        }
    }
}

#[test]
fn motions_come_back_to_where_they_began() {
    for motion in motion::all() {
        let difference = (motion.at)(0.0).inverse() * (motion.at)(1.0);
        // Angles of some turns are off by a few times 2^-53 of them, lengths of 2 by as much.
        let place = difference.transform_point(pga_motor::Point::new(1.0, 1.0, 1.0));
        assert!(place.distance_to_point(pga_motor::Point::new(1.0, 1.0, 1.0)) < 1e-13, "{}: {place:?}", motion.name);
    }
}

#[test]
fn the_cube_stays_in_its_panel() {
    for motion in motion::all() {
        for step in 0..150 {
            let motor = (motion.at)(f64::from(step) / 150.0);
            for [x, y] in cube::faces().iter().flat_map(|face| face.outline(motor)) {
                assert!(x.abs() < 2.5 && y.abs() < 2.5, "{}, step {step}: ({x}, {y})", motion.name);
            }
        }
    }
}
