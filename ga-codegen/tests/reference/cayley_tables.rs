//! Multiplication tables entered by hand.

use ga_codegen::algebra::Signature;
use ga_codegen::reference::{Multivector, table};

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

/// The table of 3D PGA in the basis of the reference cards to L. Dorst, S. De Keninck, "A Guided Tour to the
/// Plane-Based Geometric Algebra PGA" (2022). Row times column; the first row and column are the factors themselves.
const PGA_3D_TABLE: &str = "
      1     e0     e1     e2     e3    e01    e02    e03    e12    e31    e23   e021   e013   e032   e123  e0123
     e0      0    e01    e02    e03      0      0      0  -e021  -e013  -e032      0      0      0  e0123      0
     e1   -e01      1    e12   -e31    -e0   e021  -e013     e2    -e3   e123    e02   -e03  e0123    e23   e032
     e2   -e02   -e12      1    e23  -e021    -e0   e032    -e1   e123     e3   -e01  e0123    e03    e31   e013
     e3   -e03    e31   -e23      1   e013  -e032    -e0   e123     e1    -e2  e0123    e01   -e02    e12   e021
    e01      0     e0  -e021   e013      0      0      0    e02   -e03  e0123      0      0      0  -e032      0
    e02      0   e021     e0  -e032      0      0      0   -e01  e0123    e03      0      0      0  -e013      0
    e03      0  -e013   e032     e0      0      0      0  e0123    e01   -e02      0      0      0  -e021      0
    e12  -e021    -e2     e1   e123   -e02    e01  e0123     -1    e23   -e31     e0   e032  -e013    -e3   -e03
    e31  -e013     e3   e123    -e1    e03  e0123   -e01   -e23     -1    e12  -e032     e0   e021    -e2   -e02
    e23  -e032   e123    -e3     e2  e0123   -e03    e02    e31   -e12     -1   e013  -e021     e0    -e1   -e01
   e021      0    e02   -e01 -e0123      0      0      0     e0   e032  -e013      0      0      0    e03      0
   e013      0   -e03 -e0123    e01      0      0      0  -e032     e0   e021      0      0      0    e02      0
   e032      0 -e0123    e03   -e02      0      0      0   e013  -e021     e0      0      0      0    e01      0
   e123 -e0123    e23    e31    e12   e032   e013   e021    -e3    -e2    -e1   -e03   -e02   -e01     -1     e0
  e0123      0  -e032  -e013  -e021      0      0      0   -e03   -e02   -e01      0      0      0    -e0      0
";

#[test]
fn pga_2d_multiplies_as_published() {
    assert_table(PGA_2D, &PGA_2D_TABLE.map(Vec::from));
}

#[test]
fn pga_3d_multiplies_as_published() {
    let rows = PGA_3D_TABLE.lines().map(|line| line.split_whitespace().collect::<Vec<_>>());
    assert_table(PGA_3D, &rows.filter(|row| !row.is_empty()).collect::<Vec<_>>());
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

#[test]
fn a_table_is_printed_in_the_orientation_of_its_basis() {
    let expected = "\
             1   e0   e1   e2  e12  e20  e01 e012
   1    1   e0   e1   e2  e12  e20  e01 e012
  e0   e0    0  e01 -e20 e012    0    0    0
  e1   e1 -e01    1  e12   e2 e012  -e0  e20
  e2   e2  e20 -e12    1  -e1   e0 e012  e01
 e12  e12 e012  -e2   e1   -1 -e01  e20  -e0
 e20  e20    0 e012  -e0  e01    0    0    0
 e01  e01    0   e0 e012 -e20    0    0    0
e012 e012    0  e20  e01  -e0    0    0    0
";
    let found = table(PGA_2D, &PGA_2D_TABLE[0], Multivector::geometric).expect("blades of 2D PGA");
    assert_eq!(
        found.lines().map(str::trim_start).collect::<Vec<_>>(),
        expected.lines().map(str::trim_start).collect::<Vec<_>>()
    );
}

#[test]
fn a_table_of_any_product_on_part_of_a_basis_is_printed() {
    // Lines meet in points, which this basis does not name: their generators ascend.
    let meets = table(PGA_2D, &["e0", "e1", "e2"], Multivector::outer).expect("blades of 2D PGA");
    assert_eq!(meets, "       e0   e1   e2\n  e0    0  e01  e02\n  e1 -e01    0  e12\n  e2 -e02 -e12    0\n");
    let sums = table(PGA_2D, &["e1"], |a, b| &a.geometric(b) + &a.scale(-2)).expect("a blade of 2D PGA");
    assert_eq!(sums, "               e1\n      e1 1 - 2 e1\n");
}

#[test]
fn a_table_of_blades_that_are_none_is_an_error() {
    assert!(table(PGA_2D, &["e1", "e3"], Multivector::geometric).is_err());
    assert!(table(Signature::new(9, 0, 0), &[], Multivector::geometric).is_err());
}

#[track_caller]
fn assert_table(signature: Signature, table: &[Vec<&str>]) {
    assert_eq!(table.len(), 1 << signature.dimension());
    for row in table {
        assert_eq!(row.len(), table.len());
        for (column, expected) in row.iter().enumerate() {
            assert_product(signature, row[0], table[0][column], expected);
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
