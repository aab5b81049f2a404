//! What is measured.

use std::hint::black_box;

use glam::{Affine3A, Mat4, Quat, Vec3};
use nalgebra::{Isometry3, Point3, Translation3, UnitDualQuaternion, UnitQuaternion};
use pga_motor::batch::Blocks;
use pga_motor::f32::{Direction, Line, Motor, Point, Rotor, Skeleton, Translator};
use pga_motor::skeleton::local_to_model;
use ultraviolet::{Isometry3x8, Rotor3x8, Vec3x8};

use super::stopwatch::{Contender, Row};

const COUNT: usize = 1024;

/// Motions that differ with the index: turns about all axes, and places at most 2 away.
fn motor(index: usize) -> Motor {
    let angle = index as f32 * 0.37;
    let rotor = Rotor::about_z(angle) * Rotor::about_y(0.5 * angle) * Rotor::about_x(0.25 * angle);
    Motor::from_rotor_translator(rotor, Translator::from_vector(Direction::new(angle.sin(), angle.cos(), 1.0)))
}

fn point(index: usize) -> Point {
    let i = index as f32;
    Point::new(i.sin(), i.cos(), i / COUNT as f32)
}

fn list<T>(item: impl Fn(usize) -> T) -> Vec<T> {
    (0..COUNT).map(item).collect()
}

fn parts(motor: Motor) -> (Quat, Vec3) {
    motor.into()
}

fn affine(motor: Motor) -> Affine3A {
    let (rotation, translation) = parts(motor);
    Affine3A::from_rotation_translation(rotation, translation)
}

fn isometry(motor: Motor) -> Isometry3<f32> {
    let (q, t) = parts(motor);
    let rotation = UnitQuaternion::new_unchecked(nalgebra::Quaternion::new(q.w, q.x, q.y, q.z));
    Isometry3::from_parts(Translation3::new(t.x, t.y, t.z), rotation)
}

fn dual_quaternion(motor: Motor) -> UnitDualQuaternion<f32> {
    UnitDualQuaternion::from_isometry(&isometry(motor))
}

/// Eight motions in ultraviolet's layout.
fn isometry_x8(motors: &[Motor]) -> Isometry3x8 {
    let column = |of: fn(&Motor) -> f32| ultraviolet::f32x8::from(std::array::from_fn::<f32, 8, _>(|i| of(&motors[i])));
    let place = |of: fn(Point) -> f32| {
        ultraviolet::f32x8::from(std::array::from_fn::<f32, 8, _>(|i| of(motors[i].transform_origin())))
    };
    let bivector = ultraviolet::Bivec3x8::new(column(|m| -m.e12), column(|m| m.e31), column(|m| -m.e23));
    let bivector = ultraviolet::Bivec3x8::new(-bivector.xy, -bivector.xz, -bivector.yz);
    Isometry3x8::new(
        Vec3x8::new(place(|p| p.x), place(|p| p.y), place(|p| p.z)),
        Rotor3x8::new(column(|m| m.s), bivector),
    )
}

/// Rounding of a few dozen operations on numbers up to 8.
const TOLERANCE: f32 = 8.0 * 50.0 / 16_777_216.0;

fn assert_near(ours: Point, theirs: [f32; 3], what: &str) {
    let distance = ours.distance_to_point(Point::from(theirs));
    assert!(distance < TOLERANCE, "contenders disagree in {what}: {ours} and {theirs:?}, {distance} apart");
}

pub(crate) fn all() -> Vec<Row> {
    vec![
        compose(),
        compose_single(),
        one_motor(),
        many_to_many(),
        stream(),
        exp(),
        log(),
        nlerp(),
        screw_lerp(),
        kinematics(64),
        kinematics(1000),
    ]
}

fn compose() -> Row {
    let (a, b) = (list(motor), list(|i| motor(COUNT - 1 - i)));
    let (ours_a, ours_b): (Blocks<_>, Blocks<_>) = (a.iter().copied().collect(), b.iter().copied().collect());
    let mut ours = ours_a.clone();
    let (affine_a, affine_b): (Vec<_>, Vec<_>) = (list(|i| affine(a[i])), list(|i| affine(b[i])));
    let mut affines = affine_a.clone();
    let (iso_a, iso_b): (Vec<_>, Vec<_>) = (list(|i| isometry(a[i])), list(|i| isometry(b[i])));
    let mut isometries = iso_a.clone();
    let wide = |motors: &[Motor]| motors.chunks_exact(8).map(isometry_x8).collect::<Vec<_>>();
    let (wide_a, wide_b) = (wide(&a), wide(&b));
    let mut wides = wide_a.clone();

    ours_a.mul_into(&ours_b, &mut ours).expect("lists of one length");
    let probe = Point::new(1.0, 2.0, -1.0);
    for i in 0..COUNT {
        let product = ours.get(i).expect("an index of the list");
        let theirs = (affine_a[i] * affine_b[i]).transform_point3(Vec3::new(probe.x, probe.y, probe.z));
        assert_near(product.transform_point(probe), theirs.to_array(), "glam's product");
        let theirs = (iso_a[i] * iso_b[i]) * Point3::new(probe.x, probe.y, probe.z);
        assert_near(product.transform_point(probe), theirs.coords.into(), "nalgebra's product");
        let theirs = (wide_a[i / 8] * wide_b[i / 8])
            .transform_vec(Vec3x8::splat(ultraviolet::Vec3::new(probe.x, probe.y, probe.z)));
        let lane = |v: ultraviolet::f32x8| v.to_array()[i % 8];
        assert_near(
            product.transform_point(probe),
            [lane(theirs.x), lane(theirs.y), lane(theirs.z)],
            "ultraviolet's product",
        );
    }
    Row::measure(
        "compose 1024 pairs",
        COUNT,
        vec![
            (
                "Blocks<Motor>",
                Box::new(|| black_box(&ours_a).mul_into(black_box(&ours_b), black_box(&mut ours)).expect("one length")),
            ),
            ("ultraviolet x8", pairs(&wide_a, &wide_b, &mut wides, |a, b| a * b)),
            ("glam Affine3A", pairs(&affine_a, &affine_b, &mut affines, |a, b| a * b)),
            ("nalgebra Isometry3", pairs(&iso_a, &iso_b, &mut isometries, |a, b| a * b)),
        ],
    )
}

fn compose_single() -> Row {
    let (a, b) = (list(motor), list(|i| motor(COUNT - 1 - i)));
    let mut ours = a.clone();
    let (affine_a, affine_b): (Vec<_>, Vec<_>) = (list(|i| affine(a[i])), list(|i| affine(b[i])));
    let mut affines = affine_a.clone();
    let (mat_a, mat_b): (Vec<Mat4>, Vec<Mat4>) = (list(|i| affine_a[i].into()), list(|i| affine_b[i].into()));
    let mut mats = mat_a.clone();
    let (part_a, part_b) = (list(|i| parts(a[i])), list(|i| parts(b[i])));
    let mut pairs_of_parts = part_a.clone();
    Row::measure(
        "compose, arrays of structs",
        COUNT,
        vec![
            ("Motor", pairs(&a, &b, &mut ours, |a, b| a * b)),
            ("glam Affine3A", pairs(&affine_a, &affine_b, &mut affines, |a, b| a * b)),
            ("glam Mat4", pairs(&mat_a, &mat_b, &mut mats, |a, b| a * b)),
            ("glam Quat, Vec3", pairs(&part_a, &part_b, &mut pairs_of_parts, |a, b| (a.0 * b.0, a.0 * b.1 + a.1))),
        ],
    )
}

/// A function of two lists, item by item.
fn pairs<'a, A: Copy, B: Copy, R>(
    a: &'a [A],
    b: &'a [B],
    out: &'a mut [R],
    function: impl Fn(A, B) -> R + 'a,
) -> Box<dyn FnMut() + 'a> {
    Box::new(move || {
        for ((out, a), b) in black_box(&mut *out).iter_mut().zip(black_box(a)).zip(black_box(b)) {
            *out = function(*a, *b);
        }
    })
}

/// A function of a list, item by item.
fn each<'a, A: Copy, R>(a: &'a [A], out: &'a mut [R], function: impl Fn(A) -> R + 'a) -> Box<dyn FnMut() + 'a> {
    Box::new(move || {
        for (out, a) in black_box(&mut *out).iter_mut().zip(black_box(a)) {
            *out = function(*a);
        }
    })
}

fn vectors() -> Vec<Vec3> {
    list(|i| Vec3::from_array(point(i).to_array()))
}

fn one_motor() -> Row {
    let (motor, points) = (motor(3), list(point).into_iter().collect::<Blocks<_>>());
    let mut ours = points.clone();
    let (structs, mut struct_results) = (list(point), list(point));
    let (matrix, vectors) = (Mat4::from(affine(motor)), vectors());
    let (mut by_matrix, mut by_affine) = (vectors.clone(), vectors.clone());
    motor.transform_point_blocks(&points, &mut ours).expect("one length");
    for (ours, v) in ours.iter().zip(&vectors) {
        assert_near(ours, matrix.transform_point3(*v).to_array(), "glam's points");
    }
    let affine = affine(motor);
    Row::measure(
        "one motor, 1024 points",
        COUNT,
        vec![
            (
                "Blocks<Point>",
                Box::new(|| {
                    black_box(motor)
                        .transform_point_blocks(black_box(&points), black_box(&mut ours))
                        .expect("one length")
                }),
            ),
            (
                "ours, array of structs",
                Box::new(|| {
                    black_box(motor)
                        .transform_points(black_box(&structs), black_box(&mut struct_results))
                        .expect("one length")
                }),
            ),
            ("glam Mat4", each(&vectors, &mut by_matrix, move |v| matrix.transform_point3(v))),
            ("glam Affine3A", each(&vectors, &mut by_affine, move |v| affine.transform_point3(v))),
        ],
    )
}

fn many_to_many() -> Row {
    let motors = list(motor);
    let (ours_m, ours_p): (Blocks<_>, Blocks<_>) =
        (motors.iter().copied().collect(), list(point).into_iter().collect());
    let mut ours = ours_p.clone();
    let (affines, vectors) = (list(|i| affine(motors[i])), vectors());
    let mut results = vectors.clone();
    ours_m.transform_points_into(&ours_p, &mut ours).expect("one length");
    for (i, ours) in ours.iter().enumerate() {
        assert_near(ours, affines[i].transform_point3(vectors[i]).to_array(), "glam's points of many");
    }
    Row::measure(
        "1024 motors, 1024 points",
        COUNT,
        vec![
            (
                "Blocks",
                Box::new(|| {
                    black_box(&ours_m)
                        .transform_points_into(black_box(&ours_p), black_box(&mut ours))
                        .expect("one length")
                }),
            ),
            ("glam Affine3A", pairs(&affines, &vectors, &mut results, |a: Affine3A, v| a.transform_point3(v))),
        ],
    )
}

fn stream() -> Row {
    const MANY: usize = 1 << 20;
    let motor = motor(3);
    let points: Blocks<Point> = (0..MANY).map(point).collect();
    let mut ours = points.clone();
    let vectors: Vec<Vec3> = (0..MANY).map(|i| Vec3::from_array(point(i).to_array())).collect();
    let (mut copy, mut results) = (vectors.clone(), vectors.clone());
    let matrix = Mat4::from(affine(motor));
    Row::measure(
        "one motor, 1M points",
        MANY,
        vec![
            (
                "Blocks<Point>",
                Box::new(|| {
                    black_box(motor)
                        .transform_point_blocks(black_box(&points), black_box(&mut ours))
                        .expect("one length")
                }),
            ),
            ("memcpy of as many bytes", Box::new(|| black_box(&mut copy).copy_from_slice(black_box(&vectors)))),
            ("glam Mat4", each(&vectors, &mut results, move |v| matrix.transform_point3(v))),
        ],
    )
}

fn lines() -> Blocks<Line> {
    list(|i| motor(i).log()).into_iter().collect()
}

fn exp() -> Row {
    let lines = lines();
    let structs: Vec<Line> = lines.iter().collect();
    let mut ours = Blocks::filled(Motor::IDENTITY, COUNT);
    let mut single = list(motor);
    Row::measure(
        "exp",
        COUNT,
        vec![
            ("Blocks<Line>", Box::new(|| black_box(&lines).exp_into(black_box(&mut ours)).expect("one length"))),
            ("ours, one by one", each(&structs, &mut single, Line::exp)),
        ],
    )
}

fn log() -> Row {
    let motors = list(motor);
    let blocks: Blocks<Motor> = motors.iter().copied().collect();
    let mut ours = lines();
    let mut single = vec![Line::ZERO; COUNT];
    Row::measure(
        "log",
        COUNT,
        vec![
            ("Blocks<Motor>", Box::new(|| black_box(&blocks).log_into(black_box(&mut ours)).expect("one length"))),
            ("ours, one by one", each(&motors, &mut single, Motor::log)),
        ],
    )
}

fn nlerp() -> Row {
    let (a, b) = (list(motor), list(|i| motor(i + 3)));
    let (ours_a, ours_b): (Blocks<_>, Blocks<_>) = (a.iter().copied().collect(), b.iter().copied().collect());
    let mut ours = ours_a.clone();
    let (part_a, part_b) = (list(|i| parts(a[i])), list(|i| parts(b[i])));
    let mut results = part_a.clone();
    Row::measure(
        "nlerp",
        COUNT,
        vec![
            (
                "Blocks<Motor>",
                Box::new(|| {
                    black_box(&ours_a)
                        .nlerp_into(black_box(&ours_b), black_box(0.3), black_box(&mut ours))
                        .expect("one length")
                }),
            ),
            (
                "glam Quat lerp, Vec3 lerp",
                pairs(&part_a, &part_b, &mut results, |a, b| (a.0.lerp(b.0, 0.3), a.1.lerp(b.1, 0.3))),
            ),
        ],
    )
}

fn screw_lerp() -> Row {
    let (a, b) = (list(motor), list(|i| motor(i + 3)));
    let (ours_a, ours_b): (Blocks<_>, Blocks<_>) = (a.iter().copied().collect(), b.iter().copied().collect());
    let mut ours = ours_a.clone();
    let (part_a, part_b) = (list(|i| parts(a[i])), list(|i| parts(b[i])));
    let mut results = part_a.clone();
    let (dual_a, dual_b) = (list(|i| dual_quaternion(a[i])), list(|i| dual_quaternion(b[i])));
    let mut duals = dual_a.clone();
    ours_a.screw_lerp_into(&ours_b, 0.3, &mut ours).expect("one length");
    for (i, ours) in ours.iter().enumerate() {
        let theirs = dual_a[i].sclerp(&dual_b[i], 0.3).to_isometry() * Point3::new(1.0, 2.0, -1.0);
        assert_near(ours.transform_point(Point::new(1.0, 2.0, -1.0)), theirs.coords.into(), "nalgebra's screw");
    }
    Row::measure(
        "screw_lerp",
        COUNT,
        vec![
            (
                "Blocks<Motor>",
                Box::new(|| {
                    black_box(&ours_a)
                        .screw_lerp_into(black_box(&ours_b), black_box(0.3), black_box(&mut ours))
                        .expect("one length")
                }),
            ),
            (
                "glam slerp + lerp",
                pairs(&part_a, &part_b, &mut results, |a, b| (a.0.slerp(b.0, 0.3), a.1.lerp(b.1, 0.3))),
            ),
            ("nalgebra sclerp", pairs(&dual_a, &dual_b, &mut duals, |a, b| a.sclerp(&b, 0.3))),
        ],
    )
}

fn kinematics(joints: usize) -> Row {
    let parent = |joint: usize| joint.checked_sub(1).map(|before| before - before % 3);
    let locals: Vec<Motor> = (0..joints).map(|joint| motor(joint).nlerp(Motor::IDENTITY, 0.9)).collect();
    let rest = |joint: usize| (String::new(), parent(joint), locals[joint]);
    let (skeleton, remap) = Skeleton::from_parents((0..joints).map(rest)).expect("a tree");
    let mut pose = locals.clone();
    (0..joints).for_each(|joint| pose[remap[joint]] = locals[joint]);
    let mut model = pose.clone();
    let parents: Vec<Option<usize>> = (0..joints).map(|joint| skeleton.parent(joint)).collect();
    let affines: Vec<Affine3A> = pose.iter().copied().map(affine).collect();
    let mut affine_model = affines.clone();
    let mats: Vec<Mat4> = affines.iter().copied().map(Mat4::from).collect();
    let mut mat_model = mats.clone();
    let name = if joints == 64 { "forward kinematics, 64 joints" } else { "forward kinematics, 1000 joints" };
    fn down<'a, M: Copy + std::ops::Mul<Output = M>>(
        parents: &'a [Option<usize>],
        pose: &'a [M],
        model: &'a mut [M],
    ) -> Box<dyn FnMut() + 'a> {
        Box::new(move || {
            let (parents, pose, model) = (black_box(parents), black_box(pose), black_box(&mut *model));
            for (joint, &local) in pose.iter().enumerate() {
                model[joint] = parents[joint].map_or(local, |parent| model[parent] * local);
            }
        })
    }
    local_to_model(&skeleton, &pose, &mut model).expect("one length");
    down(&parents, &affines, &mut affine_model)();
    down(&parents, &mats, &mut mat_model)();
    for ((ours, theirs), by_matrix) in model.iter().zip(&affine_model).zip(&mat_model) {
        // Both have gathered the rounding of chains of hundreds of joints.
        let (ours, size) = (ours.transform_origin(), 1.0 + ours.translator().vector().norm());
        for theirs in [Vec3::from(theirs.translation), by_matrix.w_axis.truncate()] {
            let distance = ours.distance_to_point(Point::from(theirs.to_array()));
            assert!(distance < joints as f32 * TOLERANCE * size, "contenders disagree in kinematics by {distance}");
        }
    }
    let contenders: Vec<Contender<'_>> = vec![
        (
            "local_to_model",
            Box::new(|| {
                local_to_model(black_box(&skeleton), black_box(&pose), black_box(&mut model)).expect("one length")
            }),
        ),
        ("glam Affine3A", down(&parents, &affines, &mut affine_model)),
        ("glam Mat4", down(&parents, &mats, &mut mat_model)),
    ];
    Row::measure(name, joints, contenders)
}
