//! Laws that hold in every Clifford algebra, checked with integers and therefore exactly.

use ga_codegen::algebra::Signature;
use ga_codegen::reference::Multivector;
use proptest::prelude::*;

use crate::{PGA_3D, basis, basis_words, multivector, pseudoscalar};

/// Signatures with every mix of squares, from no generator to eight.
const SIGNATURES: [Signature; 13] = [
    Signature::new(0, 0, 0),
    Signature::new(0, 1, 0),
    Signature::new(0, 0, 2),
    Signature::new(2, 0, 1),
    Signature::new(3, 0, 0),
    Signature::new(3, 0, 1),
    Signature::new(1, 3, 0),
    Signature::new(1, 1, 2),
    Signature::new(4, 1, 0),
    Signature::new(2, 2, 2),
    Signature::new(4, 2, 2),
    Signature::new(8, 0, 0),
    Signature::new(0, 0, 8),
];

/// The signatures up to `dimension`, for checks of all pairs of blades.
fn signatures_to(dimension: usize) -> impl Iterator<Item = Signature> {
    SIGNATURES.into_iter().filter(move |signature| signature.dimension() <= dimension)
}

/// A sum of at most six blades with small integer coefficients.
fn any_multivector(signature: Signature) -> impl Strategy<Value = Multivector<i64>> {
    let term = (prop::sample::select(basis_words(signature)), -9_i64..=9);
    prop::collection::vec(term, 0..=6)
        .prop_map(move |terms| Multivector::from_blades(signature, terms).expect("basis words are blades"))
}

/// Three multivectors of one signature.
fn any_triple() -> impl Strategy<Value = [Multivector<i64>; 3]> {
    prop::sample::select(SIGNATURES.to_vec())
        .prop_flat_map(|signature| [any_multivector(signature), any_multivector(signature), any_multivector(signature)])
}

/// The sum over all pairs of grades r of a and s of b of the part of grade `wanted(r, s)` of their product.
fn graded(
    a: &Multivector<i64>,
    b: &Multivector<i64>,
    wanted: impl Fn(usize, usize) -> Option<usize>,
) -> Multivector<i64> {
    let dimension = a.signature().dimension();
    let mut sum = Multivector::zero(a.signature());
    for r in 0..=dimension {
        for s in 0..=dimension {
            if let Some(k) = wanted(r, s) {
                sum = &sum + &a.grade(r).geometric(&b.grade(s)).grade(k);
            }
        }
    }
    sum
}

proptest! {
    #[test]
    fn associative_products_are_associative([a, b, c] in any_triple()) {
        prop_assert_eq!(a.geometric(&b).geometric(&c), a.geometric(&b.geometric(&c)));
        prop_assert_eq!(a.outer(&b).outer(&c), a.outer(&b.outer(&c)));
        prop_assert_eq!(a.regressive(&b).regressive(&c), a.regressive(&b.regressive(&c)));
    }

    #[test]
    fn products_distribute_over_sums([a, b, c] in any_triple()) {
        let sum = b.add(&c);
        prop_assert_eq!(a.geometric(&sum), &a.geometric(&b) + &a.geometric(&c));
        prop_assert_eq!(sum.geometric(&a), &b.geometric(&a) + &c.geometric(&a));
        prop_assert_eq!(a.outer(&sum), &a.outer(&b) + &a.outer(&c));
        prop_assert_eq!(a.regressive(&sum), &a.regressive(&b) + &a.regressive(&c));
        prop_assert_eq!(sum.regressive(&a), &b.regressive(&a) + &c.regressive(&a));
    }

    #[test]
    fn scalars_commute_with_products([a, b, _] in any_triple(), k in -9_i64..=9) {
        let signature = a.signature();
        prop_assert_eq!(a.scale(k).geometric(&b), a.geometric(&b).scale(k));
        prop_assert_eq!(Multivector::scalar(signature, k).geometric(&a), a.scale(k));
        prop_assert_eq!(Multivector::scalar(signature, k).outer(&a), a.scale(k));
        prop_assert_eq!(pseudoscalar(signature).scale(k).regressive(&a), a.scale(k));
    }

    #[test]
    fn sums_form_a_group([a, b, c] in any_triple()) {
        prop_assert_eq!(a.add(&b).add(&c), a.add(&b.add(&c)));
        prop_assert_eq!(a.add(&b), b.add(&a));
        prop_assert_eq!(&(&a - &b) + &b, a.clone());
        prop_assert_eq!(&a + &-&a, Multivector::zero(a.signature()));
        prop_assert_eq!(a.neg(), a.scale(-1));
    }

    #[test]
    fn reverse_and_conjugate_turn_products_around([a, b, _] in any_triple()) {
        prop_assert_eq!(a.geometric(&b).reverse(), b.reverse().geometric(&a.reverse()));
        prop_assert_eq!(a.outer(&b).reverse(), b.reverse().outer(&a.reverse()));
        let conjugates = b.clifford_conjugate().geometric(&a.clifford_conjugate());
        prop_assert_eq!(a.geometric(&b).clifford_conjugate(), conjugates);
        prop_assert_eq!(a.reverse().reverse(), a);
    }

    #[test]
    fn grade_involution_keeps_products([a, b, _] in any_triple()) {
        prop_assert_eq!(a.geometric(&b).grade_involution(), a.grade_involution().geometric(&b.grade_involution()));
        prop_assert_eq!(a.grade_involution().reverse(), a.reverse().grade_involution());
        prop_assert_eq!(a.grade_involution().grade_involution(), a);
    }

    #[test]
    fn graded_products_are_parts_of_the_geometric([a, b, _] in any_triple()) {
        prop_assert_eq!(a.outer(&b), graded(&a, &b, |r, s| Some(r + s)));
        prop_assert_eq!(a.inner(&b), graded(&a, &b, |r, s| Some(r.abs_diff(s))));
        prop_assert_eq!(a.left_contraction(&b), graded(&a, &b, |r, s| s.checked_sub(r)));
        prop_assert_eq!(a.right_contraction(&b), graded(&a, &b, |r, s| r.checked_sub(s)));
        prop_assert_eq!(a.scalar_product(&b), a.geometric(&b).grade(0));
    }

    #[test]
    fn grades_add_up_to_the_whole([a, _, _] in any_triple()) {
        let zero = Multivector::zero(a.signature());
        let sum = (0..=a.signature().dimension()).fold(zero.clone(), |sum, k| &sum + &a.grade(k));
        prop_assert_eq!(&sum, &a);
        prop_assert_eq!(a.grade(9), zero);
    }

    #[test]
    fn commutators_are_half_the_difference_and_the_sum([a, b, _] in any_triple()) {
        let (ab, ba) = (a.geometric(&b), b.geometric(&a));
        prop_assert_eq!(a.commutator(&b).scale(2), &ab - &ba);
        prop_assert_eq!(a.anticommutator(&b).scale(2), &ab + &ba);
    }

    #[test]
    fn commutator_satisfies_the_jacobi_identity([a, b, c] in any_triple()) {
        let cycle = [(&a, &b, &c), (&b, &c, &a), (&c, &a, &b)];
        let sum = cycle.iter().fold(Multivector::zero(a.signature()), |sum, (x, y, z)| {
            &sum + &x.commutator(&y.commutator(z))
        });
        prop_assert_eq!(sum, Multivector::zero(a.signature()));
    }

    #[test]
    fn regressive_is_the_undual_of_the_outer_of_duals([a, b, _] in any_triple()) {
        prop_assert_eq!(a.regressive(&b), a.dual().outer(&b.dual()).undual());
        prop_assert_eq!(a.dual().undual(), a.clone());
        prop_assert_eq!(a.undual().dual(), a);
    }

    #[test]
    fn left_contraction_is_adjoint_to_the_outer_product([a, b, c] in any_triple()) {
        // (a ^ b) _| c = a _| (b _| c): L. Dorst, "The inner products of geometric algebra" (2002).
        prop_assert_eq!(a.outer(&b).left_contraction(&c), a.left_contraction(&b.left_contraction(&c)));
        prop_assert_eq!(a.right_contraction(&b), b.reverse().left_contraction(&a.reverse()).reverse());
    }

    #[test]
    fn sandwich_is_two_products([a, b, _] in any_triple()) {
        prop_assert_eq!(a.sandwich(&b), a.geometric(&b).geometric(&a.reverse()));
    }

    #[test]
    fn norm_squared_is_the_scalar_of_the_product_with_the_reverse([a, _, _] in any_triple()) {
        prop_assert_eq!(a.norm_squared(), a.geometric(&a.reverse()).coefficient("1"));
    }

    #[test]
    fn squares_of_all_coefficients_are_the_norm_and_the_ideal_norm(x in any_multivector(PGA_3D)) {
        let squares: i64 = x.blades().iter().map(|(_, value)| value * value).sum();
        prop_assert_eq!(x.norm_squared() + x.ideal_norm_squared(), squares);
    }
}

#[test]
fn every_blade_times_its_dual_is_the_pseudoscalar() {
    for signature in SIGNATURES {
        for blade in basis(signature) {
            assert_eq!(blade.outer(&blade.dual()), pseudoscalar(signature), "{blade} of {signature}");
            assert_eq!(blade.undual().outer(&blade), pseudoscalar(signature), "{blade} of {signature}");
        }
    }
}

#[test]
fn regressive_of_every_two_blades_is_the_undual_of_the_outer_of_duals() {
    for signature in signatures_to(5) {
        let blades = basis(signature);
        for a in &blades {
            for b in &blades {
                let by_duals = a.dual().outer(&b.dual()).undual();
                assert_eq!(a.regressive(b), by_duals, "{a} & {b} of {signature}");
            }
        }
    }
}

#[test]
fn geometric_product_of_every_three_blades_is_associative() {
    for signature in signatures_to(4) {
        let blades = basis(signature);
        for a in &blades {
            for b in &blades {
                for c in &blades {
                    let left_first = a.geometric(b).geometric(c);
                    assert_eq!(left_first, a.geometric(&b.geometric(c)), "{a} * {b} * {c} of {signature}");
                }
            }
        }
    }
}

#[test]
fn involutions_have_the_period_four_signs_of_the_grades() {
    let x = multivector(PGA_3D, [("1", 1), ("e1", 1), ("e12", 1), ("e123", 1), ("e0123", 1)]);
    let signed = |signs: [i64; 5]| {
        let [s0, s1, s2, s3, s4] = signs;
        multivector(PGA_3D, [("1", s0), ("e1", s1), ("e12", s2), ("e123", s3), ("e0123", s4)])
    };
    assert_eq!(x.reverse(), signed([1, 1, -1, -1, 1]));
    assert_eq!(x.grade_involution(), signed([1, -1, 1, -1, 1]));
    assert_eq!(x.clifford_conjugate(), signed([1, -1, -1, 1, 1]));
}

#[test]
fn inner_product_with_a_scalar_scales() {
    let (three, line) = (multivector(PGA_3D, [("1", 3)]), multivector(PGA_3D, [("e23", 2), ("e01", 5)]));
    assert_eq!(three.inner(&line), line.scale(3));
    assert_eq!(line.inner(&three), line.scale(3));
    assert_eq!(three.left_contraction(&line), line.scale(3));
    assert_eq!(line.left_contraction(&three), Multivector::zero(PGA_3D));
    assert_eq!(line.right_contraction(&three), line.scale(3));
}

#[test]
fn what_is_normalised_has_norm_one() {
    // Over 3 (squares 1, 4, 4), 7 (4, 9, 36) and 2 (the negative square of e1 in Cl(0,1,0)), all exact but the thirds
    // and sevenths, whose quotients meet one rounding each: the tolerance is 4 roundings of numbers up to 1.
    let plane = multivector(PGA_3D, [("e1", 1.0), ("e2", 2.0), ("e3", -2.0), ("e0", 6.0)]);
    let line = multivector(PGA_3D, [("e23", 2.0), ("e31", 3.0), ("e12", 6.0), ("e01", 3.0), ("e02", -2.0)]);
    let imaginary = multivector(Signature::new(0, 1, 0), [("e1", 2.0)]);
    for (x, ideal) in [(plane, 2.0_f64), (line, 13.0_f64.sqrt() / 7.0), (imaginary, 0.0)] {
        let unit = x.normalize().expect("a norm other than 0");
        assert!((unit.norm() - 1.0_f64).abs() <= 4.0 * f64::EPSILON, "{unit}");
        assert!((unit.ideal_norm() - ideal).abs() <= 4.0 * f64::EPSILON, "{unit}");
    }
}

#[test]
fn what_has_no_norm_is_not_normalised() {
    let ideal = multivector(PGA_3D, [("e032", 3.0), ("e021", 4.0)]);
    let null = multivector(Signature::new(1, 1, 0), [("e1", 1.0), ("e2", 1.0)]);
    let too_long = multivector(PGA_3D, [("e1", 1e200)]);
    let too_short = multivector(PGA_3D, [("e1", 1e-200)]);
    let not_a_number = multivector(PGA_3D, [("e1", f64::NAN)]);
    for x in [Multivector::zero(PGA_3D), ideal, null, too_long, too_short, not_a_number] {
        assert_eq!(x.normalize(), None, "{x}");
    }
}

#[test]
fn an_absent_blade_is_an_exact_zero() {
    let infinite = multivector(PGA_3D, [("e0", f64::INFINITY)]);
    assert_eq!(infinite.geometric(&infinite), Multivector::zero(PGA_3D));
    assert_eq!(infinite.geometric(&Multivector::zero(PGA_3D)), Multivector::zero(PGA_3D));
    let not_a_number = multivector(PGA_3D, [("e1", f64::NAN)]);
    assert!(not_a_number.coefficient("e1").is_nan());
}
