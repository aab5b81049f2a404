//! Multiplication tables entered by hand.

use ga_codegen::algebra::Signature;

use crate::{PGA_2D, PGA_3D, multivector};

/// The table of 2D PGA in the basis of C. Gunn, "Geometric Algebra for Computer Graphics", SIGGRAPH 2019 course notes.
/// Row times column; the first row and column are the factors themselves.
const PGA_2D_TABLE: [[&str; 8]; 8] = [
    ["1", "e0", "e1", "e2", "e12", "e20", "e01", "e012"],
    ["e0", "0", "e01", "-e20", "e012", "0", "0", "0"],
    ["e1", "-e01", "1", "e12", "e2", "e012", "-e0", "e20"],
    ["e2", "e20", "-e12", "1", "-e1", "e0", "e012", "e01"],
    ["e12", "e012", "-e2", "e1", "-1", "-e01", "e20", "-e0"],
    ["e20", "0", "e012", "-e0", "e01", "0", "0", "0"],
    ["e01", "0", "e0", "e012", "-e20", "0", "0", "0"],
    ["e012", "0", "e20", "e01", "-e0", "0", "0", "0"],
];

/// Products in 3D PGA, worked out on paper: left, right, product.
const PGA_3D_PRODUCTS: [(&str, &str, &str); 24] = [
    ("e0", "e0", "0"),
    ("e1", "e1", "1"),
    ("e3", "e1", "e31"),
    ("e23", "e23", "-1"),
    ("e31", "e31", "-1"),
    ("e12", "e12", "-1"),
    ("e23", "e31", "-e12"),
    ("e31", "e12", "-e23"),
    ("e12", "e23", "-e31"),
    ("e12", "e31", "e23"),
    ("e01", "e01", "0"),
    ("e01", "e02", "0"),
    ("e01", "e23", "e0123"),
    ("e02", "e31", "e0123"),
    ("e03", "e12", "e0123"),
    ("e12", "e01", "-e02"),
    ("e01", "e12", "e02"),
    ("e0", "e123", "e0123"),
    ("e123", "e0", "-e0123"),
    ("e123", "e123", "-1"),
    ("e032", "e123", "e01"),
    ("e123", "e032", "-e01"),
    ("e1", "e032", "e0123"),
    ("e0123", "e0123", "0"),
];

#[test]
fn pga_2d_multiplies_as_published() {
    for row in &PGA_2D_TABLE {
        for (column, expected) in row.iter().enumerate() {
            assert_product(PGA_2D, row[0], PGA_2D_TABLE[0][column], expected);
        }
    }
}

#[test]
fn pga_3d_multiplies_as_on_paper() {
    for (left, right, expected) in PGA_3D_PRODUCTS {
        assert_product(PGA_3D, left, right, expected);
    }
}

#[test]
fn generators_square_to_their_metric() {
    let cases = [
        (Signature::new(3, 0, 1), vec![("e0", 0), ("e1", 1), ("e3", 1)]),
        (Signature::new(1, 3, 0), vec![("e1", 1), ("e2", -1), ("e4", -1)]),
        (Signature::new(1, 1, 2), vec![("e0", 0), ("e1", 0), ("e2", 1), ("e3", -1)]),
        (Signature::new(0, 2, 0), vec![("e1", -1), ("e2", -1)]),
        (Signature::new(0, 0, 8), vec![("e0", 0), ("e7", 0)]),
        (Signature::new(8, 0, 0), vec![("e1", 1), ("e8", 1)]),
    ];
    for (signature, squares) in cases {
        for (generator, square) in squares {
            let vector = multivector(signature, [(generator, 1)]);
            let expected = multivector(signature, [("1", square)]);
            assert_eq!(vector.geometric(&vector), expected, "{generator} of {signature}");
        }
    }
}

#[track_caller]
fn assert_product(signature: Signature, left: &str, right: &str, expected: &str) {
    let product = multivector(signature, [(left, 1)]).geometric(&multivector(signature, [(right, 1)]));
    let expected_multivector = match (expected, expected.strip_prefix('-')) {
        ("0", _) => multivector(signature, [("1", 0)]),
        (_, Some(blade)) => multivector(signature, [(blade, -1)]),
        (blade, None) => multivector(signature, [(blade, 1)]),
    };
    assert_eq!(product, expected_multivector, "{left} * {right} should be {expected}");
}
