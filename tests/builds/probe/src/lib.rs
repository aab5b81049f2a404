//! What a user of `pga-motor` compiles: one function for each loop whose instructions are looked at.

use pga_motor::batch::Blocks;
use pga_motor::f32::{Clip, Line, Motor, Point, Poses, Skeleton};
use pga_motor::skeleton::{Interpolation, Wrap, local_to_model};

/// Functions by their own names, so that they are found again.
macro_rules! probes {
    ($($name:ident($($argument:ident: $type:ty),*) $body:block)*) => { $(
        #[unsafe(no_mangle)]
        #[inline(never)]
        pub fn $name($($argument: $type),*) $body
    )* };
}

probes! {
    compose(a: &Blocks<Motor>, b: &Blocks<Motor>, out: &mut Blocks<Motor>) { let _ = a.mul_into(b, out); }
    points(motor: Motor, points: &Blocks<Point>, out: &mut Blocks<Point>) { let _ = motor.transform_point_blocks(points, out); }
    point_pairs(motors: &Blocks<Motor>, points: &Blocks<Point>, out: &mut Blocks<Point>) {
        let _ = motors.transform_points_into(points, out);
    }
    exp(lines: &Blocks<Line>, out: &mut Blocks<Motor>) { let _ = lines.exp_into(out); }
    log(motors: &Blocks<Motor>, out: &mut Blocks<Line>) { let _ = motors.log_into(out); }
    renormalize(motors: &Blocks<Motor>, out: &mut Blocks<Motor>) { let _ = motors.renormalize_into(out); }
    nlerp(a: &Blocks<Motor>, b: &Blocks<Motor>, t: f32, out: &mut Blocks<Motor>) { let _ = a.nlerp_into(b, t, out); }
    slerp(a: &Blocks<Motor>, b: &Blocks<Motor>, t: f32, out: &mut Blocks<Motor>) { let _ = a.slerp_into(b, t, out); }
    screw_lerp(a: &Blocks<Motor>, b: &Blocks<Motor>, t: f32, out: &mut Blocks<Motor>) {
        let _ = a.screw_lerp_into(b, t, out);
    }
    crowd_kinematics(skeleton: &Skeleton, locals: &Poses, out: &mut Poses) {
        let _ = locals.local_to_model_into(skeleton, out);
    }
    crowd_sampling(clip: &Clip, times: &[f32], out: &mut Poses) {
        let _ = out.sample(clip, times, Interpolation::Screw, Wrap::Clamp);
    }
    kinematics(skeleton: &Skeleton, locals: &[Motor], out: &mut [Motor]) { let _ = local_to_model(skeleton, locals, out); }
    products(a: &[Motor], b: &[Motor], out: &mut [Motor]) {
        for ((out, a), b) in out.iter_mut().zip(a).zip(b) {
            *out = *a * *b;
        }
    }
}
