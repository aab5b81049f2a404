//! Runs the probe of the given name once on [`COUNT`] items, for its instructions to be counted; or with `expand` expands pga3d.

use std::hint::black_box;

use pga_motor::batch::Blocks;
use pga_motor::f32::{Clip, Direction, Line, Motor, Point, Poses, Rotor, Skeleton, Translator};
use probe as loops;

const COUNT: usize = 1024;
const JOINTS: usize = 64;

fn motor(index: usize) -> Motor {
    let angle = index as f32 * 0.37;
    let rotor = Rotor::about_z(angle) * Rotor::about_y(0.5 * angle) * Rotor::about_x(0.25 * angle);
    Motor::from_rotor_translator(rotor, Translator::from_vector(Direction::new(angle.sin(), angle.cos(), 1.0)))
}

fn main() {
    let name = std::env::args().nth(1).expect("the name of a probe");
    if name == "expand" {
        let block = "preset pga3d;".parse().expect("tokens");
        assert!(ga_codegen::expand(block).is_ok());
        return;
    }
    let (a, b): (Vec<Motor>, Vec<Motor>) = (0..COUNT).map(|i| (motor(i), motor(i + 3))).unzip();
    let (blocks_a, blocks_b) = (Blocks::from(&a[..]), Blocks::from(&b[..]));
    let points: Blocks<Point> = (0..COUNT).map(|i| Point::new(i as f32, 1.0, 2.0)).collect();
    let lines: Blocks<Line> = a.iter().map(|motor| motor.log()).collect();
    let (mut out, mut moved, mut logs) = (blocks_a.clone(), points.clone(), lines.clone());
    let joints = |joint: usize| (String::new(), joint.checked_sub(1).map(|before| before - before % 3), motor(joint));
    let (skeleton, _) = Skeleton::from_parents((0..JOINTS).map(joints)).expect("a tree");
    let clip = Clip::new(JOINTS, vec![0.0, 1.0], (0..2 * JOINTS).map(motor).collect()).expect("two keys");
    let locals = Poses::new(JOINTS, COUNT / JOINTS);
    let (mut models, times) = (locals.clone(), [0.3; COUNT / JOINTS]);
    let mut array = a.clone();
    match name.as_str() {
        "compose" => loops::compose(black_box(&blocks_a), &blocks_b, &mut out),
        "points" => loops::points(black_box(a[3]), &points, &mut moved),
        "point_pairs" => loops::point_pairs(black_box(&blocks_a), &points, &mut moved),
        "exp" => loops::exp(black_box(&lines), &mut out),
        "log" => loops::log(black_box(&blocks_a), &mut logs),
        "renormalize" => loops::renormalize(black_box(&blocks_a), &mut out),
        "nlerp" => loops::nlerp(black_box(&blocks_a), &blocks_b, 0.3, &mut out),
        "slerp" => loops::slerp(black_box(&blocks_a), &blocks_b, 0.3, &mut out),
        "screw_lerp" => loops::screw_lerp(black_box(&blocks_a), &blocks_b, 0.3, &mut out),
        "crowd_kinematics" => loops::crowd_kinematics(black_box(&skeleton), &locals, &mut models),
        "crowd_sampling" => loops::crowd_sampling(black_box(&clip), &times, &mut models),
        "kinematics" => {
            for (locals, models) in a.chunks_exact(JOINTS).zip(array.chunks_exact_mut(JOINTS)) {
                loops::kinematics(black_box(&skeleton), locals, models);
            }
        }
        "products" => loops::products(black_box(&a), &b, &mut array),
        _ => panic!("no probe is called {name}"),
    }
    black_box((&out, &moved, &logs, &models, &array));
}
