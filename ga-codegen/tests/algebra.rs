//! The algebra of blades against the naive reference: the whole Cayley tables of all products, duals, and bases with names
//! and orientations of the user's choice.

use ga_codegen::algebra::{Basis, BasisErrorKind, Blade, Product, Sign, Signature, table};
use ga_codegen::reference::Multivector;

fn value(sign: Sign) -> i64 {
    if sign.is_minus() { -1 } else { 1 }
}

fn reference(signature: Signature, word: &str) -> Multivector<i64> {
    Multivector::from_blades(signature, [(word, 1)]).expect("a word of the signature")
}

fn reference_product(product: Product, a: &Multivector<i64>, b: &Multivector<i64>) -> Multivector<i64> {
    match product {
        Product::Geometric => a.geometric(b),
        Product::Outer => a.outer(b),
        Product::Regressive => a.regressive(b),
        Product::Inner => a.inner(b),
        Product::LeftContraction => a.left_contraction(b),
        Product::RightContraction => a.right_contraction(b),
        Product::Scalar => a.scalar_product(b),
        Product::Commutator => a.commutator(b),
        Product::Anticommutator => a.anticommutator(b),
    }
}

/// Every signature of that dimension.
fn signatures(dimension: usize) -> impl Iterator<Item = Signature> {
    (0..=dimension).flat_map(move |p| (0..=dimension - p).map(move |q| Signature::new(p, q, dimension - p - q)))
}

/// Compares the entries of all tables whose row and column `chosen` picks. The names of the basis must be words.
fn compare_tables(basis: &Basis, chosen: impl Fn(usize, usize) -> bool) -> usize {
    let signature = basis.signature();
    let blades: Vec<_> = basis.blades().iter().map(|named| reference(signature, &named.name)).collect();
    let mut compared = 0;
    for product in Product::ALL {
        for (row, entries) in table(basis, product).iter().enumerate() {
            for (column, entry) in entries.iter().enumerate().filter(|&(column, _)| chosen(row, column)) {
                let expected = reference_product(product, &blades[row], &blades[column]);
                let found = match entry {
                    None => Multivector::zero(signature),
                    Some((sign, name)) => reference(signature, name).scale(value(*sign)),
                };
                assert_eq!(found, expected, "{signature} {product:?} of {} and {}", blades[row], blades[column]);
                compared += 1;
            }
        }
    }
    compared
}

#[test]
fn every_table_up_to_four_generators_is_that_of_the_reference() {
    let mut compared = 0;
    for signature in (0..=4).flat_map(signatures) {
        compared += compare_tables(&Basis::canonical(signature).expect("at most 8 generators"), |_, _| true);
    }
    println!("{compared} entries");
}

#[test]
fn the_tables_of_five_generators_are_those_of_the_reference() {
    for (p, q, r) in [(5, 0, 0), (4, 1, 0), (3, 1, 1), (2, 1, 2)] {
        let basis = Basis::canonical(Signature::new(p, q, r)).expect("at most 8 generators");
        compare_tables(&basis, |_, _| true);
    }
}

#[test]
fn samples_of_the_tables_of_eight_generators_are_those_of_the_reference() {
    for (p, q, r) in [(8, 0, 0), (4, 4, 0), (3, 3, 2), (0, 0, 8), (6, 1, 1)] {
        let basis = Basis::canonical(Signature::new(p, q, r)).expect("at most 8 generators");
        // 151 and 256 have no common divisor, so the pairs are spread over all rows and columns.
        compare_tables(&basis, |row, column| (256 * row + column) % 151 == 0);
    }
}

#[test]
fn involutions_have_the_signs_of_the_reference() {
    let signature = Signature::new(4, 3, 1);
    for named in Basis::canonical(signature).expect("at most 8 generators").blades() {
        let x = reference(signature, &named.name);
        assert_eq!(x.reverse(), x.scale(value(named.blade.reverse_sign())), "{x}");
        assert_eq!(x.grade_involution(), x.scale(value(named.blade.involution_sign())), "{x}");
    }
}

#[test]
fn dual_and_undual_are_those_of_the_reference_with_and_without_null_generators() {
    for signature in (0..=5).flat_map(signatures).chain([Signature::new(5, 1, 2), Signature::new(0, 0, 8)]) {
        let basis = Basis::canonical(signature).expect("at most 8 generators");
        for named in basis.blades() {
            let x = reference(signature, &named.name);
            let image =
                |(sign, blade): (Sign, Blade)| reference(signature, &basis.named(blade).name).scale(value(sign));
            assert_eq!(image(basis.dual(named.blade)), x.dual(), "{signature} dual of {x}");
            assert_eq!(image(basis.undual(named.blade)), x.undual(), "{signature} undual of {x}");
            let (sign, dual) = basis.dual(named.blade);
            let (back, blade) = basis.undual(dual);
            assert_eq!((sign * back, blade), (Sign::Plus, named.blade), "{signature} {x}");
        }
    }
}

/// The basis of 3D PGA in the design's orientations: a blade's own sign enters the table twice or once.
#[test]
fn names_may_be_words_in_any_order_of_generators() {
    let words = [
        "1", "e0", "e1", "e2", "e3", "e01", "e02", "e03", "e12", "e31", "e23", "e021", "e013", "e032", "e123", "e0123",
    ];
    let basis = Basis::new(Signature::new(3, 0, 1), words.map(|word| (word, word))).expect("a basis");
    assert_eq!(basis.find("e31").map(|named| named.sign), Some(Sign::Minus));
    assert_eq!(basis.find("e032").map(|named| named.sign), Some(Sign::Minus));
    assert_eq!(basis.find("e013").map(|named| named.sign), Some(Sign::Plus));
    assert_eq!(compare_tables(&basis, |_, _| true), 9 * 256);
}

#[test]
fn names_may_be_free() {
    let entries =
        [("i", "e32"), ("1", "1"), ("j", "e13"), ("k", "e21"), ("x", "e1"), ("y", "e2"), ("z", "e3"), ("I", "e123")];
    let basis = Basis::new(Signature::new(3, 0, 0), entries).expect("a basis");
    let blades: Vec<_> = basis.blades().iter().map(|named| named.name.as_str()).collect();
    assert_eq!(blades, ["i", "1", "j", "k", "x", "y", "z", "I"], "the order of the list is kept");
    let geometric = table(&basis, Product::Geometric);
    let product = |a: &str, b: &str| {
        let at = |name| blades.iter().position(|blade| *blade == name).expect("a name");
        geometric[at(a)][at(b)]
    };
    // Hamilton's quaternions.
    for (a, b, c) in [("i", "j", "k"), ("j", "k", "i"), ("k", "i", "j")] {
        assert_eq!(product(a, b), Some((Sign::Plus, c)));
        assert_eq!(product(b, a), Some((Sign::Minus, c)));
        assert_eq!(product(a, a), Some((Sign::Minus, "1")));
    }
    assert_eq!(product("x", "y"), Some((Sign::Minus, "k")));
}

/// Against the pseudoscalar e10 = -e01 every dual and undual changes its sign, and so does the join, in which there are
/// three of them.
#[test]
fn duals_and_joins_go_by_the_orientation_of_the_pseudoscalar() {
    let signature = Signature::new(1, 0, 1);
    let plain = Basis::canonical(signature).expect("at most 8 generators");
    let reversed = Basis::new(signature, ["1", "e0", "e1", "e10"].map(|word| (word, word))).expect("a basis");
    for named in plain.blades() {
        let (sign, dual) = plain.dual(named.blade);
        assert_eq!(reversed.dual(named.blade), (-sign, dual));
        let (sign, undual) = plain.undual(named.blade);
        assert_eq!(reversed.undual(named.blade), (-sign, undual));
        // X ^ dual(X) is the pseudoscalar of the basis, -e01.
        let (sign, dual) = reversed.dual(named.blade);
        let outer = Product::Outer.of_blades(&reversed, named.blade, dual).expect("a complement");
        assert_eq!((sign * outer.0, outer.1), (Sign::Minus, Blade(0b11)));
        for other in plain.blades() {
            let join = |basis| Product::Regressive.of_blades(basis, named.blade, other.blade);
            assert_eq!(join(&reversed), join(&plain).map(|(sign, blade)| (-sign, blade)));
        }
    }
    // In the table the result is named by the basis as well: the pseudoscalar is the identity of its join.
    let entries = table(&reversed, Product::Regressive);
    for (index, named) in reversed.blades().iter().enumerate() {
        assert_eq!(entries[3][index], Some((Sign::Plus, named.name.as_str())));
    }
}

#[test]
fn a_list_of_words_that_is_no_basis_says_where() {
    let signature = Signature::new(2, 0, 0);
    let error = |words: &[&str]| Basis::new(signature, words.iter().map(|word| (*word, *word))).expect_err("no basis");
    let not_a_blade = error(&["1", "e1", "e3", "e12"]);
    assert_eq!(not_a_blade.index, Some(2));
    assert_eq!(not_a_blade.kind, BasisErrorKind::NotABlade("e3".to_owned(), signature));
    for word in ["e11", "e22", "e122", "e", "12", "x1", "e0", "e1x"] {
        let not_a_blade = error(&["1", word]);
        assert_eq!(not_a_blade.index, Some(1), "{word}");
        let text = format!(
            "expected a blade of Cl(2,0,0), found `{word}`: its generators are e1 e2, each at most once in a blade"
        );
        assert_eq!(not_a_blade.to_string(), text);
    }
    let repeated = error(&["1", "e1", "e2", "e12", "e21"]);
    assert_eq!(repeated.to_string(), "expected every blade once, found `e21` and `e12`, which are the same up to sign");
    assert_eq!(repeated.index, Some(4));
    assert_eq!(repeated.kind, BasisErrorKind::Repeated("e21".to_owned(), "e12".to_owned()));
    let missing = error(&["1", "e2"]);
    assert_eq!(missing.index, None);
    assert_eq!(missing.kind, BasisErrorKind::Missing(vec!["e1".to_owned(), "e12".to_owned()]));
    assert_eq!(missing.to_string(), "expected every blade of the algebra, found none for `e1`, `e12`");
    assert_eq!(error(&["e1", "e2", "e12"]).to_string(), "expected every blade of the algebra, found none for `1`");
    let taken = Basis::new(signature, [("1", "1"), ("x", "e1"), ("x", "e2")]).expect_err("a name twice");
    assert_eq!(taken.to_string(), "expected distinct names, found `x` twice");
    assert_eq!((taken.index, taken.kind), (Some(2), BasisErrorKind::NameTaken("x".to_owned())));
    let large = Basis::canonical(Signature::new(9, 0, 0)).expect_err("too many generators");
    assert_eq!(large.to_string(), "expected at most 8 generators, found Cl(9,0,0)");
    assert_eq!(large.kind, BasisErrorKind::TooManyGenerators(Signature::new(9, 0, 0)));
}

#[test]
fn a_pseudoscalar_has_all_generators_of_at_most_eight() {
    assert_eq!(Blade::pseudoscalar(Signature::new(0, 0, 0)), Some(Blade::SCALAR));
    assert_eq!(Blade::pseudoscalar(Signature::new(3, 0, 1)), Some(Blade(0b1111)));
    assert_eq!(Blade::pseudoscalar(Signature::new(3, 3, 2)), Some(Blade(0xff)));
    for large in [Signature::new(9, 0, 0), Signature::new(8, 8, 8), Signature::new(usize::MAX, 1, 0)] {
        assert_eq!(Blade::pseudoscalar(large), None);
    }
    let basis = Basis::canonical(Signature::new(3, 3, 2)).expect("at most 8 generators");
    assert_eq!(basis.pseudoscalar().blade, Blade(0xff));
}

#[test]
fn null_degrees_are_counted_in_any_signature() {
    assert_eq!(Blade(0b0111).null_degree(Signature::new(3, 0, 1)), 1);
    assert_eq!(Blade(0b0111).null_degree(Signature::new(3, 0, 0)), 0);
    assert_eq!(Blade(0xff).null_degree(Signature::new(0, 0, 8)), 8);
    assert_eq!(Blade(0xff).null_degree(Signature::new(0, 0, 100)), 8);
}

#[test]
fn null_degree_of_a_product_is_the_sum_in_any_signature() {
    for signature in [Signature::new(3, 0, 1), Signature::new(1, 1, 2), Signature::new(2, 0, 0)] {
        let blades = || (0..1 << signature.dimension()).map(Blade);
        for (a, b) in blades().flat_map(|a| blades().map(move |b| (a, b))) {
            let sum = a.null_degree(signature) + b.null_degree(signature);
            assert!(a.geometric(b, signature).is_none_or(|(_, product)| product.null_degree(signature) == sum));
        }
    }
}

#[test]
fn trit_labels_are_the_published_ones() {
    let signature = Signature::new(3, 0, 1);
    let basis = Basis::canonical(signature).expect("at most 8 generators");
    let labelled = |label| -> Vec<&str> {
        let blades = basis.blades().iter().filter(|named| named.blade.trit_label(signature) == label);
        blades.map(|named| named.name.as_str()).collect()
    };
    assert_eq!(labelled(Some(1)), ["e01", "e02", "e03"]);
    assert_eq!(labelled(Some(0)), ["e12", "e13", "e23"]);
    assert_eq!(labelled(Some(-1)), ["1"]);
    assert_eq!(labelled(None).len(), 9);
    // A bivector of two null generators translates as well; without any there are rotations alone.
    assert_eq!(Blade(0b11).trit_label(Signature::new(1, 0, 2)), Some(1));
    assert_eq!(Blade(0b11).trit_label(Signature::new(2, 0, 0)), Some(0));
}

#[test]
#[should_panic(expected = "a blade of this basis's algebra")]
fn a_blade_of_another_algebra_has_no_name() {
    let basis = Basis::canonical(Signature::new(2, 0, 0)).expect("at most 8 generators");
    basis.named(Blade(0b100));
}

#[test]
fn a_signature_counts_its_generators() {
    let signature = Signature::new(2, 3, 2);
    assert_eq!((signature.positive(), signature.negative(), signature.null()), (2, 3, 2));
    assert_eq!((signature.dimension(), signature.to_string()), (7, "Cl(2,3,2)".to_owned()));
    let basis = Basis::canonical(signature).expect("at most 8 generators");
    assert_eq!(basis.signature(), signature);
    // Null ones first, then positive, then negative ones.
    let square = |word: &str| {
        let blade = basis.find(word).expect("a generator").blade;
        blade.geometric(blade, signature).map(|(sign, _)| value(sign))
    };
    let squares = ["e0", "e1", "e2", "e3", "e4", "e5", "e6"].map(square);
    assert_eq!(squares, [None, None, Some(1), Some(1), Some(-1), Some(-1), Some(-1)]);
    assert_eq!(basis.find("e7"), None);
}

#[test]
fn products_have_the_names_of_the_command_line() {
    let names = Product::ALL.map(Product::name).join(" ");
    let expected =
        "geometric outer regressive inner left-contraction right-contraction scalar commutator anticommutator";
    assert_eq!(names, expected);
}
