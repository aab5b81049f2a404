//! The macro in a crate that has nothing else: the rotations of space, and plain complex numbers, each defined in a block
//! of its own. Without `scalar` a block brings the traits of its numbers along.

/// Cl(3,0,0): vectors, and rotors as exponentials of bivectors.
#[allow(missing_docs, unreachable_pub, reason = "the emitted module is public, this test is not")]
mod rotations {
    ga_macros::algebra! {
        signature (3, 0, 0);
        basis 1 e1 e2 e3 e12 e31 e23 e123;

        /// Any vector.
        entity Vector { x: e1, y: e2, z: e3 }
        /// What generates a rotation.
        entity Bivector { e23, e31, e12 }
        /// A rotation.
        entity Rotor { s: 1, e23, e31, e12 } where s*s == 1 - e23*e23 - e31*e31 - e12*e12;

        /// The rotation b, then the rotation a.
        kernel compose(a: Rotor, b: Rotor) -> Rotor = a * b;
        kernel turn(r: Rotor, v: Vector) -> Vector = r >> v;
        kernel reverse(r: Rotor) -> Rotor = ~r;
        kernel rotor(b: Bivector) -> Rotor = exp(-b / 2);
        kernel generator(r: Rotor) -> Bivector = log(r);
        kernel cross(a: Vector, b: Vector) -> Vector = dual(a ^ b);
        kernel plane(a: Vector, b: Vector) -> Bivector = a ^ b;
    }
}

/// Cl(0,1,0), which is the complex numbers.
#[allow(missing_docs, unreachable_pub, reason = "the emitted module is public, this test is not")]
mod complex {
    ga_macros::algebra! {
        signature (0, 1, 0);
        basis 1 i = e1;
        entity Complex { re: 1, im: i }
        kernel product(a: Complex, b: Complex) -> Complex = a * b;
        kernel conjugate(a: Complex) -> Complex = grade_involution(a);
        kernel norm_squared(a: Complex) -> Scalar = a * grade_involution(a);
    }
}

use complex::Complex;
use rotations::{Bivector, Rotor, Vector, kernels};
use std::f64::consts::PI;

/// A handful of roundings of numbers about 1.
const TOLERANCE: f64 = 16.0 * f64::EPSILON;

#[track_caller]
fn assert_near<const N: usize>(found: [f64; N], expected: [f64; N]) {
    for (found_one, expected_one) in found.into_iter().zip(expected) {
        assert!((found_one - expected_one).abs() <= TOLERANCE, "found {found:?}, expected {expected:?}");
    }
}

#[test]
fn the_exponential_turns_counter_clockwise_by_its_angle() {
    let quarter = kernels::rotor(Bivector::new(0.0, 0.0, PI / 2.0));
    assert_near(kernels::turn(quarter, Vector::new(1.0, 0.0, 0.0)).to_array(), [0.0, 1.0, 0.0]);
    assert_near(kernels::turn(quarter, Vector::new(0.0, 1.0, 5.0)).to_array(), [-1.0, 0.0, 5.0]);
    assert!(quarter.satisfies_relations(TOLERANCE));
    assert_eq!(kernels::rotor(Bivector::new(0.0, 0.0, 0.0)), Rotor::IDENTITY);
}

#[test]
fn the_logarithm_inverts_the_exponential() {
    let bivector = Bivector::new(0.3, -1.0, 0.7);
    let halved = bivector * -0.5;
    assert_near(kernels::generator(kernels::rotor(bivector)).to_array(), halved.to_array());
}

#[test]
fn definitions_that_are_operators_become_operators() {
    let a = kernels::rotor(Bivector::new(0.3, -1.0, 0.7));
    let b = kernels::rotor(Bivector::new(0.0, 0.4, 0.1));
    let v = Vector::new(1.0, 2.0, 3.0);
    assert_eq!(a * b, kernels::compose(a, b));
    assert_eq!(a >> v, kernels::turn(a, v));
    assert_near(((a * b) >> v).to_array(), (a >> (b >> v)).to_array());
    assert_near((a * kernels::reverse(a)).to_array(), Rotor::IDENTITY.to_array());
    assert_eq!(v ^ v, Bivector::ZERO);
}

#[test]
fn kernels_are_generic_over_the_scalar() {
    let cross = kernels::cross(Vector::new(1.0_f32, 0.0, 0.0), Vector::new(0.0, 1.0, 0.0));
    assert_eq!(cross, Vector::new(0.0_f32, 0.0, 1.0));
}

#[test]
fn complex_numbers_multiply() {
    let (a, b) = (Complex::new(1.0, 2.0), Complex::new(3.0, -1.0));
    assert_eq!(a * b, Complex::new(5.0, 5.0));
    assert_eq!(complex::kernels::norm_squared(a), 5.0);
    assert_eq!(complex::kernels::conjugate(a), Complex::new(1.0, -2.0));
    assert_eq!((a + b) - b, a);
    assert_eq!(Complex::<f64>::IDENTITY * a, a);
    assert_eq!(format!("{a:.1}"), "1.0 + 2.0 i");
}

/// Definitions whose operators and conversions the types have already, or would have twice.
mod overlapping {
    ga_macros::algebra! {
        signature (2, 0, 0);
        entity Vector { e1, e2 }
        entity Arrow { e1, e2 }
        kernel vector_scale(v: Vector, k: Scalar) -> Vector = v * k;
        kernel vector_add(a: Vector, b: Vector) -> Vector = a + b;
        kernel arrow_from_vector(v: Vector) -> Arrow = v;
        kernel arrow_of_vector(v: Vector) -> Arrow = v;
        kernel second(a: Vector, _a: Vector) -> Vector = _a;
    }
}

#[test]
fn overlapping_operators_are_implemented_once() {
    use overlapping::{Arrow, Vector, kernels};

    let v = Vector::new(1.0_f64, 2.0);
    assert_eq!(kernels::vector_scale(v, 3.0), v * 3.0);
    assert_eq!(kernels::vector_add(v, v), v + v);
    assert_eq!(Arrow::from(v), kernels::arrow_of_vector(v));
    assert_eq!(kernels::second(v, v + v), v + v);
}

/// `uniform` inputs: what they determine is computed once.
mod hoisted {
    ga_macros::algebra! {
        signature (2, 0, 0);
        entity Vector { x: e1, y: e2 }
        entity Rotor { c: 1, s: e12 } where c*c == 1 - s*s;
        kernel turn(uniform r: Rotor, v: Vector) -> Vector = r >> v cost flops, latency hoist Matrix, prepare, apply;
    }
}

#[test]
fn parts_of_a_kernel_applied_one_after_the_other_are_the_kernel() {
    use hoisted::{Rotor, Vector, kernels};

    let (r, v) = (Rotor::new(0.6_f64, 0.8), Vector::new(2.0, 5.0));
    let (whole, parts) = (kernels::turn(r, v), kernels::apply(kernels::prepare(r), v));
    // A handful of operations on numbers up to 10 on either side.
    assert!((whole.x - parts.x).abs() < 1e-14 && (whole.y - parts.y).abs() < 1e-14);
    assert_eq!(whole, r >> v);
    let quick = kernels::turn_latency(r, v);
    assert!((whole.x - quick.x).abs() < 1e-14 && (whole.y - quick.y).abs() < 1e-14);
}

/// A kernel on four lanes, with the block's own traits.
mod packed {
    ga_macros::algebra! {
        signature (3, 0, 0);
        basis 1 e1 e2 e3 e23 e31 e12 e123;
        entity Rotor { s: 1, e23, e31, e12 }
        kernel turn(a: Rotor, b: Rotor) -> Rotor = a * b packed;
        recipe turn packed {
            p = [a.s, a.e23, a.e31, a.e12];
            q = [b.s, b.e23, b.e31, b.e12];
            t = p[1, 1, 2, 3] * q[1, 0, 0, 0] + p[2, 3, 1, 2] * q[2, 2, 3, 1];
            out[s, e23, e31, e12] = p[0, 0, 0, 0] * q + t[-0, 1, 2, 3] - p[3, 2, 3, 1] * q[3, 3, 1, 2];
        }
    }
}

#[test]
fn packed_kernels_are_the_kernel() {
    use packed::{Rotor, kernels};

    // Small whole numbers, so that nothing is rounded.
    let (a, b) = (Rotor::new(1, 2, -3, 4).map(f64::from), Rotor::new(-5, 6, 7, 8).map(f64::from));
    assert_eq!(kernels::turn_packed(a, b), kernels::turn(a, b));
    assert_eq!(a * b, kernels::turn(a, b));
}

/// Fields whose names would be the same, and a scalar output without one.
mod hoisted_names {
    ga_macros::algebra! {
        signature (2, 0, 0);
        entity Uniform { x: e1, y: e2 }
        entity Outer { a: e1, a_b: e2 }
        entity Inner { b_c: e1, c: e2 }
        kernel stretch(uniform u: Uniform, v: Inner) -> Outer = (u | v) * u hoist Stretch, stretch_prepare, stretch_apply;
        kernel along(uniform u: Uniform, v: Inner) -> Scalar = u | v hoist Along, along_prepare, along_apply;
    }
}

#[test]
fn fields_of_records_have_names_of_their_own() {
    use hoisted_names::{Inner, Uniform, kernels};

    let (u, v) = (Uniform::new(2, 3).map(f64::from), Inner::new(5, 7).map(f64::from));
    let record = kernels::stretch_prepare(u);
    assert_eq!((record.a_b_c, record.a_c, record.a_b_c_2), (4.0, 6.0, 9.0));
    assert_eq!(kernels::stretch_apply(record, v), kernels::stretch(u, v));
    let along = kernels::along_prepare(u);
    assert_eq!((along.by_b_c, along.by_c), (2.0, 3.0));
    assert_eq!(kernels::along_apply(along, v), 31.0);
}
