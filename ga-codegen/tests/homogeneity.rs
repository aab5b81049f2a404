//! What does not keep its meaning under a change of the unit of length is an error, at the place to blame.

use ga_codegen::{compile, define};

const BLADES: &str = "signature (3, 0, 1);
basis 1 e0 e1 e2 e3 e01 e02 e03 e12 e31 e23 e021 e013 e032 e123 e0123;
";

/// Line, column and text of the errors of a block with the 3D basis; lines count from that of the basis.
fn errors(block: &str) -> Vec<(usize, usize, String)> {
    let tokens = format!("{BLADES}{block}").parse().expect("tokens");
    let Err(errors) = define(tokens).and_then(|definition| compile(&definition)) else { return Vec::new() };
    let place = |error: syn::Error| (error.span().start().line - 2, error.span().start().column + 1, error.to_string());
    errors.into_iter().map(place).collect()
}

#[test]
fn swapped_components_of_a_type_contradict_its_relation() {
    let found = errors(
        "entity Motor { s: 1, e23: e01, e31, e12, e01: e23, e02, e03, e0123 }
    where s*s == 1 - e23*e23 - e31*e31 - e12*e12;",
    );
    let message = "expected the relation `s * s == 1 - e23 * e23 - e31 * e31 - e12 * e12` to have one degree in the unit \
                   of length, found the monomial e23^2 of degree 2 where 0 is expected: are Euclidean and ideal \
                   coefficients swapped?";
    assert_eq!(found, [(2, 11, message.to_owned())]);
}

#[test]
fn swapped_components_in_a_study_relation_are_found() {
    let found = errors(
        "entity Motor { s: 1, e23, e31, e12, e01, e02, e03, e0123 }
    where s*e01 == e23*e0123 - e31*e02 - s*e12;",
    );
    assert_eq!(found.len(), 1);
    assert_eq!((found[0].0, found[0].1), (2, 11));
    assert!(found[0].2.contains("found the monomial s e12 of degree 0 where 1 is expected"), "{}", found[0].2);
}

#[test]
fn sums_of_different_degrees_are_found_at_the_kernel() {
    let found = errors(
        "entity Plane { e1, e2, e3, e0 }
entity Point { x: e032, y: e013, z: e021, 1: e123 }
entity Even { s: 1, e23, e31, e12, e01, e02, e03, e0123 }
kernel swapped(a: Plane, p: Point) -> Even = a * p + (a & p);",
    );
    let message = "kernel `swapped`: expected the coefficient of `e01` to have one degree in the unit of length, found the \
                   monomial a.e2 p.z of degree 1 where 2 is expected: are Euclidean and ideal coefficients swapped?";
    assert_eq!(found.len(), 1, "{found:?}");
    assert_eq!((found[0].0, found[0].1), (4, 8));
    assert_eq!(found[0].2, message);
}

#[test]
fn joins_directions_of_unit_length_and_lengths_are_fine() {
    let found = errors(
        "entity Direction { x: e032, y: e013, z: e021 }
entity UnitDirection { x: e032, y: e013, z: e021 } where x*x == 1 - y*y - z*z;
entity Point { x: e032, y: e013, z: e021, 1: e123 }
entity Line { e23, e31, e12, e01, e02, e03 }
kernel join(a: Point, b: Point) -> Line = a & b;
kernel along(a: Point, d: UnitDirection, k: Scalar) -> Point = a + d * k;
kernel from_origin(d: Direction) -> Line = e123 & d;",
    );
    assert_eq!(found, []);
}

#[test]
fn two_units_of_length_are_one_too_many() {
    let found = errors(
        "entity UnitDirection { x: e032, y: e013, z: e021 } where x*x == 1 - y*y - z*z;
entity Point { x: e032, y: e013, z: e021, 1: e123 }
kernel step(a: Point, d: UnitDirection) -> Point = a + d;",
    );
    assert_eq!(found.len(), 1, "{found:?}");
    assert_eq!((found[0].0, found[0].1), (3, 8));
    assert!(found[0].2.starts_with("kernel `step`: expected the coefficient of `e0"), "{}", found[0].2);
}

#[test]
fn duals_are_exempt_and_so_are_metrics_without_null_generators() {
    let dual = "entity Line { e23, e31, e12, e01, e02, e03 }
kernel both(l: Line) -> Line = l + dual(l);";
    assert_eq!(errors(dual), []);
    let block =
        "signature (2, 0, 0); entity Any { s: 1, x: e1, y: e2, b: e12 } kernel f(a: Any) -> Any = a + a * a + e1;";
    assert!(define(block.parse().expect("tokens")).and_then(|definition| compile(&definition)).is_ok());
}

#[test]
fn the_argument_of_exp_has_no_degree_of_its_own() {
    let found = errors(
        "entity Line { e23, e31, e12, e01, e02, e03 }
entity Motor { s: 1, e23, e31, e12, e01, e02, e03, e0123 } where s*s == 1 - e23*e23 - e31*e31 - e12*e12;
kernel good(l: Line) -> Motor = exp(l);
kernel bad(m: Motor) -> Motor = exp(grade(m, 2) * e0123);",
    );
    assert!(found.iter().any(|(line, column, _)| (*line, *column) == (4, 8)), "{found:?}");
    assert!(
        found.iter().any(|(.., text)| text.contains("monomial m.e23 of degree 0 where 1 is expected")),
        "{found:?}"
    );
}
