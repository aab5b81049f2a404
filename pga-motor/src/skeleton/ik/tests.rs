use alloc::string::ToString;
use alloc::vec::Vec;

use super::*;
use crate::Translator;
use crate::skeleton::local_to_model;
use crate::skeleton::tests::Sequence;

type M = Motor<f64>;

/// What a few products of motors and an arc tangent leave of lengths up to 10.
const TOLERANCE: f64 = 1e-13;

fn by(x: f64, y: f64, z: f64) -> M {
    Translator::from_vector(Direction::new(x, y, z)).into()
}

/// A body, a shoulder, a sleeve, an elbow, a hand and a finger; upper arm 3 long in two pieces, lower arm `lower`.
fn arm(lower: f64) -> Skeleton<f64> {
    let joints = [
        ("body", None, by(0.5, 1.0, 0.0)),
        ("shoulder", Some(0), by(0.0, 1.0, 0.0)),
        ("sleeve", Some(1), by(1.0, 0.0, 0.0)),
        ("elbow", Some(2), by(2.0, 0.0, 0.0)),
        ("hand", Some(3), by(lower, 0.0, 0.0)),
        ("finger", Some(4), by(0.5, 0.0, 0.0)),
        ("leg", Some(0), by(0.0, -1.0, 0.0)),
    ];
    Skeleton::from_parents(joints).unwrap().0
}

const SHOULDER: usize = 1;
const ELBOW: usize = 3;
const HAND: usize = 4;

fn bones(target: Point<f64>) -> TwoBone<f64> {
    TwoBone::new(SHOULDER, ELBOW, HAND, target)
}

/// A skeleton in a pose, with its model motors.
struct Scene {
    skeleton: Skeleton<f64>,
    pose: Vec<M>,
    model: Vec<M>,
}

impl Scene {
    fn new(skeleton: Skeleton<f64>, turns: &[(usize, Rotor<f64>)]) -> Self {
        let mut pose = skeleton.rest_pose().to_vec();
        turns.iter().for_each(|&(joint, turn)| pose[joint] = pose[joint] * turn);
        let mut model = pose.clone();
        local_to_model(&skeleton, &pose, &mut model).unwrap();
        Self { skeleton, pose, model }
    }

    fn random(sequence: &mut Sequence, lower: f64) -> Self {
        let turns: Vec<_> = [0, 1, 2, 3].map(|joint| (joint, sequence.rotor())).into();
        Self::new(arm(lower), &turns)
    }

    fn place(&self, joint: usize) -> Point<f64> {
        self.model[joint].transform_origin()
    }

    fn reach(&mut self, bones: TwoBone<f64>) -> Reach {
        let before = self.pose.clone();
        let reach = bones.solve(&self.skeleton, &mut self.pose, &mut self.model).unwrap();
        self.check(&before, &[bones.start, bones.mid]);
        reach
    }

    fn aim(&mut self, aim: Aim<f64>) -> Reach {
        let before = self.pose.clone();
        let reach = aim.solve(&self.skeleton, &mut self.pose, &mut self.model).unwrap();
        self.check(&before, &[aim.joint]);
        reach
    }

    /// Only those joints have turned, about themselves, and the model motors are those of the pose.
    fn check(&self, before: &[M], turned: &[usize]) {
        for (joint, (now, before)) in self.pose.iter().zip(before).enumerate() {
            if turned.contains(&joint) {
                assert!((now.translator().vector() - before.translator().vector()).norm() < TOLERANCE);
            } else {
                assert_eq!(now, before);
            }
        }
        let mut model = self.model.clone();
        local_to_model(&self.skeleton, &self.pose, &mut model).unwrap();
        for (found, expected) in self.model.iter().zip(&model) {
            assert!((*found - *expected).norm() + (*found - *expected).ideal_norm() < TOLERANCE);
        }
    }
}

#[test]
fn an_arm_reaches_what_is_in_reach() {
    let mut sequence = Sequence::new(1);
    for case in 0..500 {
        let mut scene = Scene::random(&mut sequence, 2.0);
        let shoulder = scene.place(SHOULDER);
        // Between |3 - 2| and 3 + 2 from the shoulder, though the sleeve may bend the upper arm: from its length then.
        let upper = scene.place(ELBOW).distance_to_point(shoulder);
        let distance = (upper - 2.0).abs() + (upper + 2.0 - (upper - 2.0).abs()) * f64::from(case % 20 + 1) / 21.0;
        let target = shoulder + sequence.direction() * distance;
        let pole = sequence.direction();
        let bones = TwoBone { pole: (case % 2 == 0).then_some(pole), ..bones(target) };
        assert_eq!(scene.reach(bones), Reach::Reached);
        assert!(
            scene.place(HAND).distance_to_point(target) < TOLERANCE,
            "{} in case {case}",
            scene.place(HAND).distance_to_point(target)
        );
        if let Some(pole) = bones.pole {
            let goal = (target - shoulder).normalize().unwrap();
            let side = perpendicular(scene.place(ELBOW) - shoulder, goal).unwrap();
            assert!((side - perpendicular(pole, goal).unwrap()).norm() < 1e-10);
        }
    }
}

#[test]
fn an_arm_is_straight_towards_what_is_too_far() {
    let mut sequence = Sequence::new(2);
    for _ in 0..100 {
        let mut scene = Scene::random(&mut sequence, 2.0);
        let shoulder = scene.place(SHOULDER);
        let longest = scene.place(ELBOW).distance_to_point(shoulder) + 2.0;
        let way = sequence.direction();
        assert_eq!(scene.reach(bones(shoulder + way * 100.0)), Reach::TooFar);
        // The square root of a rounding error is the angle that the cosine next to 1 leaves open; its square is the length.
        assert!(scene.place(HAND).distance_to_point(shoulder + way * longest) < 1e-7);
        assert!((scene.place(HAND).distance_to_point(shoulder) - longest).abs() < TOLERANCE);
    }
}

#[test]
fn an_arm_folds_towards_what_is_too_near() {
    let mut scene = Scene::new(arm(1.0), &[(ELBOW, Rotor::about_y(0.7))]);
    let shoulder = scene.place(SHOULDER);
    let way = Direction::new(0.0, 0.6, 0.8);
    assert_eq!(scene.reach(bones(shoulder + way * 0.5)), Reach::TooNear);
    assert!(scene.place(HAND).distance_to_point(shoulder + way * 2.0) < 1e-7);
}

#[test]
fn a_target_at_the_shoulder_folds_the_arm_where_it_points() {
    for lower in [1.0, 3.0] {
        let mut scene = Scene::new(arm(lower), &[(ELBOW, Rotor::about_y(0.7))]);
        let shoulder = scene.place(SHOULDER);
        let elbow = scene.place(ELBOW);
        assert_eq!(scene.reach(bones(shoulder)), Reach::NoDirection);
        assert!((scene.place(HAND).distance_to_point(shoulder) - (3.0 - lower)).abs() < TOLERANCE);
        assert!(scene.place(ELBOW).distance_to_point(elbow) < 1e-7);
    }
}

#[test]
fn a_straight_arm_bends_about_its_hinge() {
    for (hinge, side) in [(Direction::Z, -1.0), (-Direction::Z, 1.0)] {
        let mut scene = Scene::new(arm(2.0), &[]);
        let shoulder = scene.place(SHOULDER);
        let target = shoulder + Direction::new(4.0, 0.0, 0.0);
        assert_eq!(scene.reach(TwoBone { hinge: Some(hinge), ..bones(target) }), Reach::Reached);
        assert!(scene.place(HAND).distance_to_point(target) < TOLERANCE);
        // Folding up counter-clockwise about z, the hand goes up and the elbow down.
        assert!(
            ((scene.place(ELBOW) - shoulder).y * side) > 0.5 && (scene.place(ELBOW) - shoulder).z.abs() < TOLERANCE
        );
    }
    // Without a hinge, or with one along the arm, it bends some way.
    for hinge in [None, Some(Direction::X)] {
        let mut scene = Scene::new(arm(2.0), &[]);
        let target = scene.place(SHOULDER) + Direction::new(0.0, 0.0, 4.0);
        assert_eq!(scene.reach(TwoBone { hinge, ..bones(target) }), Reach::Reached);
        assert!(scene.place(HAND).distance_to_point(target) < TOLERANCE);
    }
}

#[test]
fn an_arm_turns_right_round() {
    let mut scene = Scene::new(arm(2.0), &[]);
    let target = scene.place(SHOULDER) + Direction::new(-4.5, 0.0, 0.0);
    assert_eq!(scene.reach(bones(target)), Reach::Reached);
    assert!(scene.place(HAND).distance_to_point(target) < TOLERANCE);
}

#[test]
fn weights_apply_a_part_of_the_turns() {
    let start = Scene::new(arm(2.0), &[(ELBOW, Rotor::about_y(0.7))]);
    let target = start.place(SHOULDER) + Direction::new(1.0, 3.0, 1.0);
    let reach = |weight: f64| {
        let mut scene = Scene::new(arm(2.0), &[(ELBOW, Rotor::about_y(0.7))]);
        scene.reach(TwoBone { weight, ..bones(target) });
        scene.place(HAND).distance_to_point(target)
    };
    assert!((reach(0.0) - start.place(HAND).distance_to_point(target)).abs() < TOLERANCE);
    assert!(reach(0.5) > 0.1 && reach(0.5) < reach(0.0));
    assert!(reach(1.0) < TOLERANCE);
}

#[test]
fn faults_of_two_bones_are_named_and_leave_the_pose_alone() {
    let error = |bones: TwoBone<f64>| {
        let mut scene = Scene::new(arm(2.0), &[]);
        let before = scene.pose.clone();
        let error = bones.solve(&scene.skeleton, &mut scene.pose, &mut scene.model).unwrap_err();
        assert_eq!(scene.pose, before);
        error.to_string()
    };
    let good = bones(Point::ORIGIN);
    assert_eq!(error(TwoBone { end: 7, ..good }), "expected a joint below 7, the number of joints, found 7");
    let message = "joint 6 `leg`: expected a joint below joint 3, found one that is not";
    assert_eq!(error(TwoBone { end: 6, ..good }), message);
    let message = "joint 1 `shoulder`: expected a joint below joint 1, found one that is not";
    assert_eq!(error(TwoBone { mid: 1, ..good }), message);
    let nan = Point::new(0.0, f64::NAN, 0.0);
    assert_eq!(error(bones(nan)), "expected a finite `target`, found a NaN or an infinity");
    assert_eq!(
        error(TwoBone { weight: f64::INFINITY, ..good }),
        "expected a finite `weight`, found a NaN or an infinity"
    );
    let message = "expected a direction as `pole`, found one of length 0";
    assert_eq!(error(TwoBone { pole: Some(Direction::ZERO), ..good }), message);
    let message = "expected a direction as `hinge`, found one of length 0";
    assert_eq!(error(TwoBone { hinge: Some(Direction::ZERO), ..good }), message);

    let mut scene = Scene::new(arm(0.0), &[]);
    let error = good.solve(&scene.skeleton, &mut scene.pose, &mut scene.model).unwrap_err();
    assert_eq!(error.to_string(), "expected a bone from joint 3 to joint 4, found both at one place");
    let error = good.solve(&scene.skeleton, &mut scene.pose[1..], &mut scene.model).unwrap_err();
    assert_eq!(error.to_string(), "expected 7 motors in `pose`, one for each joint, found 6");
    let error = good.solve(&scene.skeleton, &mut scene.pose, &mut scene.model[1..]).unwrap_err();
    assert_eq!(error.to_string(), "expected 7 motors in `model`, one for each joint, found 6");
    scene.model[HAND].e01 = f64::NAN;
    let error = good.solve(&scene.skeleton, &mut scene.pose, &mut scene.model).unwrap_err();
    assert_eq!(error.to_string(), "expected a finite `pose`, found a NaN or an infinity");
}

#[test]
fn an_aim_looks_at_its_target() {
    let mut sequence = Sequence::new(3);
    for case in 0..500 {
        let mut scene = Scene::random(&mut sequence, 2.0);
        let place = scene.place(HAND);
        let (forward, up, pole) = (sequence.direction() * 3.0, sequence.direction(), sequence.direction());
        let offset = if case % 3 == 0 { Direction::ZERO } else { sequence.direction() * 0.9 };
        let target = place + sequence.direction() * (1.0 + f64::from(case % 50));
        let aim = Aim { offset, up, pole: (case % 2 == 0).then_some(pole), ..Aim::new(HAND, forward, target) };
        assert_eq!(scene.aim(aim), Reach::Reached);
        let frame = scene.model[HAND];
        let ray = (target - (place + frame.transform_direction(offset))).normalize().unwrap();
        let off = (ray - frame.transform_direction(forward).normalize().unwrap()).norm();
        assert!(off < 1e-12, "{off} case {case}: {aim:?}");
        if aim.pole.is_some() {
            let goal = (target - place).normalize().unwrap();
            let raised = perpendicular(frame.transform_direction(up), goal).unwrap();
            assert!((raised - perpendicular(pole, goal).unwrap()).norm() < 1e-10);
        }
    }
}

#[test]
fn an_aim_turns_right_round_and_says_where_there_is_no_way() {
    let looks = |target: Point<f64>, offset: Direction<f64>| {
        let mut scene = Scene::new(arm(2.0), &[]);
        let aim = Aim { offset, up: Direction::Y, ..Aim::new(HAND, Direction::X, target) };
        let before = scene.pose.clone();
        let reach = scene.aim(aim);
        (reach, scene.pose == before, scene.model[HAND].transform_direction(Direction::X))
    };
    let place = Scene::new(arm(2.0), &[]).place(HAND);
    let (reach, _, forward) = looks(place - Direction::X, Direction::ZERO);
    assert_eq!(reach, Reach::Reached);
    assert!((forward + Direction::X).norm() < TOLERANCE);
    assert_eq!(looks(place, Direction::ZERO), (Reach::NoDirection, true, Direction::X));
    // The ray passes the joint at a distance of 2, and begins 2 before it.
    assert_eq!(looks(place + Direction::Z, Direction::new(0.0, 2.0, 0.0)), (Reach::TooNear, true, Direction::X));
    assert_eq!(looks(place + Direction::Z, Direction::new(2.0, 0.0, 0.0)), (Reach::TooNear, true, Direction::X));
    assert_eq!(looks(place + Direction::Z, Direction::new(0.5, 0.0, 0.0)).0, Reach::Reached);
}

#[test]
fn faults_of_an_aim_are_named() {
    let error = |aim: Aim<f64>| {
        let mut scene = Scene::new(arm(2.0), &[]);
        aim.solve(&scene.skeleton, &mut scene.pose, &mut scene.model).unwrap_err().to_string()
    };
    let good = Aim::new(HAND, Direction::X, Point::ORIGIN);
    assert_eq!(error(Aim { joint: 7, ..good }), "expected a joint below 7, the number of joints, found 7");
    let message = "expected a direction as `forward`, found one of length 0";
    assert_eq!(error(Aim { forward: Direction::ZERO, ..good }), message);
    let message = "expected a direction as `pole`, found one of length 0";
    assert_eq!(error(Aim { pole: Some(Direction::ZERO), ..good }), message);
    let broken = Direction::new(f64::NAN, 0.0, 0.0);
    for (aim, what) in [
        (Aim { forward: broken, ..good }, "forward"),
        (Aim { offset: broken, ..good }, "offset"),
        (Aim { up: broken, ..good }, "up"),
        (Aim { pole: Some(broken), ..good }, "pole"),
        (Aim { target: Point::new(f64::INFINITY, 0.0, 0.0), ..good }, "target"),
        (Aim { weight: f64::NAN, ..good }, "weight"),
    ] {
        assert_eq!(error(aim), alloc::format!("expected a finite `{what}`, found a NaN or an infinity"));
    }
}
