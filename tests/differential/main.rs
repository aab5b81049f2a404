//! Every compiled kernel of `pga-motor` against the naive reference.
//!
//! The definition of a kernel is read from its preset and interpreted on [`ga_codegen::reference::Multivector`]; the
//! compiled function is called on the same coefficients. In exact rational arithmetic both must agree without any
//! tolerance; in `f64` they must agree within a bound on the rounding errors that is computed along with the value. On
//! expressions of unknowns they must agree for all inputs at once, see `validation`.

#[macro_use]
mod dispatch;
#[macro_use]
mod exact;
mod expression;
mod interpreter;
mod samples;
#[macro_use]
mod suite;
#[macro_use]
mod tracked;
mod validation;

use exact::Exact;
use tracked::Tracked;

/// Exact cases for every polynomial kernel.
const EXACT_CASES: usize = 2000;

exact_scalar!(pga_motor::scalar {
    type Four = pga_motor::scalar::Array4<Self>;
} {
    const EPSILON: Self = Exact::ZERO;
    const PI: Self = Exact::ZERO;
    fn to_f64(self) -> f64 {
        self.to_f64()
    }
});

tracked_scalar!(pga_motor::scalar {
    type Four = pga_motor::scalar::Array4<Self>;
} {
    const EPSILON: Self = Tracked::new(f64::EPSILON);
    const PI: Self = Tracked::new(std::f64::consts::PI);
    fn to_f64(self) -> f64 {
        self.value
    }
});

mod pga3d {
    use pga_motor as compiled;
    use pga_motor::scalar;

    pga_motor::pga3d_kernels!(dispatch);
    claims!("pga3d", crate::EXACT_CASES);
}

mod pga2d {
    use pga_motor::pga2d as compiled;
    use pga_motor::scalar;

    pga_motor::pga2d_kernels!(dispatch);
    claims!("pga2d", crate::EXACT_CASES);
}

/// A suite that cannot fail claims nothing: one kernel exchanged for another with the same types is found out.
#[test]
#[should_panic(expected = "motor_reverse")]
fn a_wrong_kernel_is_found_out() {
    let mut table = pga3d::table::<Exact>();
    let find = |name: &str| table.iter().position(|kernel| kernel.name == name).expect("a kernel of pga3d");
    let (reverse, unchanged) = (find("motor_reverse"), find("even_from_motor"));
    table[reverse].call = table[unchanged].call;
    suite::agree_exactly("pga3d", &table, 10);
}

/// Parts and variants of kernels, which have no definition of their own, beside the kernels that they belong to.
mod parts {
    use crate::dispatch::take;
    use crate::exact::Exact;
    use crate::{EXACT_CASES, samples, suite};
    use pga_motor::kernels::*;

    /// Exact inputs of a kernel of pga3d.
    fn rows(name: &str) -> Vec<Vec<Exact>> {
        let definition = suite::definition("pga3d");
        let kernel = definition.kernel(name).expect("a kernel of pga3d");
        let mut random = samples::Random(name.len() as u64);
        (0..EXACT_CASES).map(|_| samples::row(&definition, kernel, &mut random)).collect()
    }

    macro_rules! equal {
        ($($whole:ident, |$a:ident, $b:ident| $other:expr;)*) => {
            $(for row in rows(stringify!($whole)) {
                let mut rest = row.as_slice();
                let ($a, $b) = (take(&mut rest), take(&mut rest));
                assert_eq!($whole($a, $b), $other, "{} on {row:?}", stringify!($whole));
            })*
        };
    }

    #[test]
    fn parts_applied_one_after_the_other_are_the_kernel() {
        equal! {
            motor_transform_point, |m, p| matrix_apply_point(motor_to_matrix(m), p);
            motor_transform_direction, |m, d| matrix_apply_direction(motor_to_direction_matrix(m), d);
            motor_transform_plane, |m, p| matrix_apply_plane(motor_to_plane_matrix(m), p);
            motor_transform_line, |m, l| matrix_apply_line(motor_to_line_matrix(m), l);
        }
    }

    #[test]
    fn packed_kernels_are_the_kernel() {
        equal! {
            motor_mul_motor, |a, b| motor_mul_motor_packed(a, b);
            motor_mul_rotor, |a, b| motor_mul_rotor_packed(a, b);
            rotor_mul_motor, |a, b| rotor_mul_motor_packed(a, b);
            rotor_mul_rotor, |a, b| rotor_mul_rotor_packed(a, b);
            even_mul_even, |a, b| even_mul_even_packed(a, b);
        }
    }

    #[test]
    fn variants_for_other_cost_models_are_the_kernel() {
        equal! { rotor_transform_line, |r, l| rotor_transform_line_fma(r, l); }
        equal! { motor_mul_motor, |a, b| motor_mul_motor_fma(a, b); }
        equal! { motor_transform_point, |m, p| motor_transform_point_fma(m, p); }
    }
}
