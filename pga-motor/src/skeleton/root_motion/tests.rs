use alloc::string::ToString;
use alloc::vec;

use super::*;
use crate::Point;

type M = Motor<f64>;

const SECONDS: f64 = 2.0;

/// A walk on a curve with a bob and a lean that are the same at both ends, and a second joint that swings.
fn walk() -> Clip<f64> {
    let keys = 9;
    let mut motors = Vec::new();
    for key in 0..keys {
        let phase = core::f64::consts::TAU * f64::from(key) / f64::from(keys - 1);
        let place = Direction::new(0.3 * f64::from(key), 1.0 + 0.1 * phase.sin(), 2.0);
        let heading = Rotor::about_y(0.15 * f64::from(key));
        motors.push(Translator::from_vector(place) * (heading * Rotor::about_x(0.2 * phase.cos())));
        motors.push(Rotor::about_z(phase.sin()).into());
    }
    let times = (0..keys).map(|key| 1.0 + SECONDS * f64::from(key) / f64::from(keys - 1)).collect();
    Clip::new(2, times, motors).unwrap().with_name("walk")
}

const GROUND: RootMotionPart<f64> = RootMotionPart::Ground { up: Direction { x: 0.0, y: 2.0, z: 0.0 } };

/// Motors of coefficients below 10, after a few products.
fn assert_near(found: M, expected: M) {
    let apart = |difference: crate::EvenMultivector<f64>| difference.norm() + difference.ideal_norm();
    let nearest = apart(found - expected).min(apart(found + expected));
    assert!(nearest < 1e-13, "{found} instead of {expected}");
}

#[test]
fn the_way_times_what_remains_is_the_clip() {
    let clip = walk();
    for part in [RootMotionPart::All, GROUND] {
        let (motion, remaining) = RootMotion::extract(&clip, 0, part).unwrap();
        assert_eq!((remaining.name(), motion.way().name()), ("walk", "walk"));
        assert_eq!((remaining.times(), motion.way().times()), (clip.times(), clip.times()));
        for key in 0..clip.key_count() {
            let (whole, remaining) = (clip.key(key).unwrap(), remaining.key(key).unwrap());
            assert_near(motion.way().key(key).unwrap()[0] * remaining[0], whole[0]);
            assert_eq!(remaining[1], whole[1]);
        }
        assert_near(motion.way().key(0).unwrap()[0], M::IDENTITY);
    }
}

#[test]
fn what_remains_of_all_stays_put() {
    let (_, remaining) = RootMotion::extract(&walk(), 0, RootMotionPart::All).unwrap();
    for key in 0..remaining.key_count() {
        assert_near(remaining.key(key).unwrap()[0], walk().key(0).unwrap()[0]);
    }
}

#[test]
fn the_way_on_the_ground_neither_climbs_nor_leans() {
    let (motion, remaining) = RootMotion::extract(&walk(), 0, GROUND).unwrap();
    for key in 0..motion.way().key_count() {
        let way = motion.way().key(key).unwrap()[0];
        let up = way.transform_direction(Direction::Y);
        assert!((up - Direction::Y).norm() < 1e-14 && way.transform_origin().y.abs() < 1e-14);
        // The joint stays over the place where it was, at its height.
        let (place, whole) =
            (remaining.key(key).unwrap()[0].transform_origin(), walk().key(key).unwrap()[0].transform_origin());
        assert!(place.distance_to_point(Point::new(0.0, whole.y, 2.0)) < 1e-13, "{place}");
    }
}

#[test]
fn rounds_go_on_where_the_one_before_ended() {
    let (motion, remaining) = RootMotion::extract(&walk(), 0, GROUND).unwrap();
    let place = |time: f64, wrap: Wrap| {
        let mut pose = [M::IDENTITY; 2];
        remaining.sample_into(time, Interpolation::Screw, wrap, &mut pose).unwrap();
        (motion.at(time, Interpolation::Screw, wrap).unwrap() * pose[0]).transform_point(Point::new(0.1, 0.2, 0.3))
    };
    let plain = |time: f64| {
        let mut pose = [M::IDENTITY; 2];
        walk().sample_into(time, Interpolation::Screw, Wrap::Loop, &mut pose).unwrap();
        pose[0].transform_point(Point::new(0.1, 0.2, 0.3))
    };
    // It moves by less than 3 per second, so by less than 1e-8 in twice a nanosecond, however many rounds have passed.
    for round in [-3.0, -1.0, 0.0, 1.0, 2.0, 40.0] {
        let end = 1.0 + SECONDS * (round + 1.0);
        let (before, after) = (place(end - 1e-9, Wrap::Loop), place(end + 1e-9, Wrap::Loop));
        assert!(before.distance_to_point(after) < 1e-8, "a jump from {before} to {after}");
        assert!(plain(end - 1e-9).distance_to_point(plain(end + 1e-9)) > 2.0);
    }
    // In the first round it is where the clip is.
    for time in [1.0, 1.3, 2.9] {
        assert_eq!(place(time, Wrap::Loop), place(time, Wrap::Clamp));
    }
    assert_eq!(place(7.0, Wrap::Clamp), place(3.0, Wrap::Clamp));
}

#[test]
fn steps_add_up_to_the_way() {
    let (motion, _) = RootMotion::extract(&walk(), 0, GROUND).unwrap();
    let mut world = M::IDENTITY;
    let step = 0.17;
    for frame in 0..100 {
        let time = 1.0 + step * f64::from(frame);
        world = world * motion.between(time, time + step, Interpolation::Screw, Wrap::Loop).unwrap();
    }
    let way = motion.at(1.0 + step * 100.0, Interpolation::Screw, Wrap::Loop).unwrap();
    // A hundred products, each with a few roundings of coefficients up to 20.
    assert!((world - way).norm().min((world + way).norm()) < 1e-12);
    assert!(world.transform_origin().distance_to_point(way.transform_origin()) < 1e-11);
}

#[test]
fn where_a_turn_has_no_twist_that_of_the_key_before_counts() {
    let half_turn_about_x = Rotor { s: 0.0, e23: -1.0, e31: 0.0, e12: 0.0 };
    let keys = vec![M::IDENTITY, Rotor::about_y(0.5).into(), (half_turn_about_x).into()];
    let clip = Clip::new(1, vec![0.0, 1.0, 2.0], keys).unwrap();
    let (motion, _) = RootMotion::extract(&clip, 0, GROUND).unwrap();
    assert_near(motion.way().key(2).unwrap()[0], Rotor::about_y(0.5).into());
}

#[test]
fn a_clip_of_one_key_goes_nowhere() {
    let clip = Clip::new(1, vec![4.0], vec![walk().key(3).unwrap()[0]]).unwrap();
    let (motion, remaining) = RootMotion::extract(&clip, 0, GROUND).unwrap();
    assert_near(motion.between(-8.0, 50.0, Interpolation::Nlerp, Wrap::Loop).unwrap(), M::IDENTITY);
    assert_near(remaining.key(0).unwrap()[0], clip.key(0).unwrap()[0]);
}

#[test]
fn faults_are_named() {
    let error = |joint, part| RootMotion::extract(&walk(), joint, part).unwrap_err().to_string();
    assert_eq!(error(2, GROUND), "expected a joint below 2, the number of joints, found 2");
    let message = "expected a direction as `up`, found one that is zero or not finite";
    assert_eq!(error(0, RootMotionPart::Ground { up: Direction::ZERO }), message);
    assert_eq!(error(0, RootMotionPart::Ground { up: Direction::new(f64::NAN, 0.0, 0.0) }), message);
    let (motion, _) = RootMotion::extract(&walk(), 0, GROUND).unwrap();
    assert_eq!(motion.at(f64::NAN, Interpolation::Nlerp, Wrap::Loop).unwrap_err(), ClipError::SampleTime);
    assert_eq!(
        motion.between(0.0, f64::INFINITY, Interpolation::Nlerp, Wrap::Clamp).unwrap_err(),
        ClipError::SampleTime
    );
}
