//! Exact arithmetic: rationals and polynomials obey their laws or report an overflow, relations give unique normal forms,
//! and power series satisfy the identities of the functions that they stand for.

use ga_codegen::algebra::Sign;
use ga_codegen::symbolic::{
    Monomial, Overflow, Polynomial, Rational, Relation, Relations, RelationsError, Series, SeriesError, SeriesRing,
    Symbol,
};
use proptest::prelude::*;

fn rational(numerator: i128, denominator: i128) -> Rational {
    Rational::new(numerator, denominator).expect("a rational number")
}

fn monomial(symbols: &[Symbol]) -> Monomial {
    Monomial::new(symbols.to_vec())
}

/// A polynomial from coefficients and the symbols of their monomials.
fn polynomial(terms: &[(i64, &[Symbol])]) -> Polynomial {
    let mut sum = Polynomial::zero();
    for (coefficient, symbols) in terms {
        sum.add_term(monomial(symbols), Rational::integer(*coefficient)).expect("small numbers");
    }
    sum
}

// Rationals.

#[test]
fn rationals_are_in_lowest_terms_with_a_positive_denominator() {
    assert_eq!((rational(6, -4).numerator(), rational(6, -4).denominator()), (-3, 2));
    assert_eq!(rational(0, -7), Rational::ZERO);
    assert_eq!(rational(i128::MAX, i128::MAX), Rational::ONE);
    assert_eq!(rational(-4, 6).to_string(), "-2/3");
}

#[test]
fn rationals_are_ordered_by_value() {
    let largest = i128::MAX;
    let ascending = [
        Rational::integer(-2),
        rational(-3, 2),
        rational(-1, 2),
        rational(-1, 3),
        Rational::ZERO,
        rational(1, largest),
        rational(1, largest - 1),
        rational(1, 3),
        rational(1, 2),
        rational(largest - 2, largest - 1),
        rational(largest - 1, largest),
        Rational::ONE,
        rational(largest, largest - 1),
        Rational::integer(2),
        rational(largest, 1),
    ];
    for (i, a) in ascending.iter().enumerate() {
        for (j, b) in ascending.iter().enumerate() {
            assert_eq!((a.cmp(b), a.partial_cmp(b)), (i.cmp(&j), Some(i.cmp(&j))), "{a} {b}");
        }
    }
}

#[test]
fn what_does_not_fit_128_bits_is_an_overflow() {
    let (most, least) = (rational(i128::MAX, 1), rational(1, i128::MAX));
    assert_eq!(Rational::new(1, 0), Err(Overflow));
    assert_eq!(Rational::new(i128::MIN, 1), Err(Overflow));
    assert_eq!(Rational::new(1, i128::MIN), Err(Overflow));
    assert_eq!(most.checked_add(Rational::ONE), Err(Overflow));
    assert_eq!(most.neg().checked_add(Rational::MINUS_ONE), Err(Overflow), "-2^127 has no negative, so it is out");
    assert_eq!(most.checked_mul(Rational::integer(2)), Err(Overflow));
    assert_eq!(least.checked_mul(rational(1, 2)), Err(Overflow));
    assert_eq!(most.checked_add(least), Err(Overflow));
    assert_eq!(least.checked_add(rational(1, i128::MAX - 1)), Err(Overflow));
}

#[test]
fn what_fits_128_bits_is_exact_up_to_the_edge() {
    let (most, least) = (rational(i128::MAX, 1), rational(1, i128::MAX));
    assert_eq!(most.checked_mul(least), Ok(Rational::ONE), "factors cancel before they are multiplied");
    assert_eq!(most.checked_add(Rational::MINUS_ONE), Rational::new(i128::MAX - 1, 1));
    assert_eq!(most.checked_add(most.neg()), Ok(Rational::ZERO));
    assert_eq!(most.checked_div(most), Ok(Some(Rational::ONE)));
    assert_eq!(most.checked_div(Rational::ZERO), Ok(None));
    assert_eq!(least.checked_div(least.neg()), Ok(Some(Rational::MINUS_ONE)));
}

#[test]
fn an_overflow_in_a_polynomial_is_an_error_too() {
    let huge = Polynomial::term(monomial(&[0]), rational(i128::MAX, 1));
    assert_eq!(huge.add(&huge), Err(Overflow));
    assert_eq!(huge.mul(&huge), Err(Overflow));
    assert_eq!(huge.neg().sub(&huge), Err(Overflow));
    assert_eq!(huge.scale(Rational::integer(2)), Err(Overflow));
    assert_eq!(huge.sub(&huge), Ok(Polynomial::zero()));
}

#[test]
fn parts_of_rationals_are_what_they_are_called() {
    let ratio = rational(-6, 8);
    assert_eq!((ratio.numerator(), ratio.denominator(), ratio.to_f64()), (-3, 4, -0.75));
    assert_eq!((ratio.neg(), ratio.abs(), ratio.neg().abs()), (rational(3, 4), rational(3, 4), rational(3, 4)));
    assert_eq!([ratio, Rational::ZERO, Rational::ONE].map(Rational::is_negative), [true, false, false]);
    assert_eq!([ratio, Rational::ZERO, Rational::ONE].map(Rational::is_zero), [false, true, false]);
    assert_eq!((Rational::integer(-7).to_string(), Rational::integer(-7).denominator()), ("-7".to_owned(), 1));
    assert_eq!(Overflow.to_string(), "exact arithmetic overflowed 128-bit rationals");
}

#[test]
fn roots_of_rationals_are_exact_or_none() {
    for (square, root) in [
        (rational(9, 4), Some(rational(3, 2))),
        (Rational::ZERO, Some(Rational::ZERO)),
        (rational(1, 25), Some(rational(1, 5))),
        (Rational::integer(2), None),
        (rational(4, 3), None),
        (rational(3, 4), None),
        (Rational::integer(-4), None),
        (rational(i128::MAX, 1), None),
    ] {
        assert_eq!(square.exact_root(), root, "{square}");
    }
}

#[test]
fn monomials_multiply_divide_and_have_a_least_common_multiple() {
    let (a, b) = (monomial(&[2, 0, 2]), monomial(&[1, 2, 3]));
    assert_eq!((a.symbols(), a.degree(), a.power(2), a.power(1)), (&[0, 2, 2][..], 3, 2, 0));
    assert_eq!(a.times(&b).symbols(), [0, 1, 2, 2, 2, 3]);
    assert_eq!(b.times(&a), a.times(&b));
    assert_eq!(a.least_common_multiple(&b).symbols(), [0, 1, 2, 2, 3]);
    assert_eq!(b.least_common_multiple(&a), a.least_common_multiple(&b));
    assert_eq!(a.times(&b).divided_by(&b), Some(a.clone()));
    assert_eq!((a.divided_by(&b), b.divided_by(&a)), (None, None));
    assert_eq!((a.divided_by(&a), a.divided_by(&monomial(&[]))), (Some(monomial(&[])), Some(a.clone())));
    assert_eq!((a.divided_by(&monomial(&[2])), a.divided_by(&monomial(&[2, 2, 2]))), (Some(monomial(&[0, 2])), None));
}

#[test]
fn polynomials_are_written_with_signs_powers_and_names() {
    let names = ["m.s", "p.x"].map(str::to_owned);
    for (terms, text) in [
        (&[][..], "0"),
        (&[(1, &[][..])], "1"),
        (&[(-1, &[])], "-1"),
        (&[(1, &[0])], "m.s"),
        (&[(-1, &[1])], "-p.x"),
        (&[(2, &[0, 0]), (-3, &[0, 1]), (1, &[1, 1, 1])], "2 m.s^2 - 3 m.s p.x + p.x^3"),
        (&[(-5, &[]), (1, &[0, 2])], "-5 + m.s x2"),
    ] {
        assert_eq!(polynomial(terms).display(&names), text);
    }
    let half = Polynomial::term(monomial(&[1]), rational(1, 2));
    assert_eq!(half.display(&names), "1/2 p.x");
}

#[test]
fn constants_are_told_from_other_polynomials() {
    for (terms, constant) in [
        (&[][..], Some(Rational::ZERO)),
        (&[(-7, &[][..])], Some(Rational::integer(-7))),
        (&[(1, &[0])], None),
        (&[(1, &[]), (1, &[0])], None),
    ] {
        let polynomial = polynomial(terms);
        assert_eq!((polynomial.as_constant(), polynomial.term_count()), (constant, terms.len()));
        assert_eq!(polynomial.is_zero(), terms.is_empty());
    }
    assert!(
        Polynomial::constant(Rational::ZERO).is_zero() && Polynomial::term(monomial(&[0]), Rational::ZERO).is_zero()
    );
    let sum = polynomial(&[(2, &[0]), (3, &[1])]);
    assert_eq!(sum.coefficient(&monomial(&[1])), Rational::integer(3));
    assert_eq!(sum.coefficient(&monomial(&[2])), Rational::ZERO);
    assert_eq!(sum.clone().signed(Sign::Minus), sum.neg());
    assert_eq!(sum.clone().signed(Sign::Plus), sum);
    assert_eq!(sum.scale(rational(1, 2)).expect("small numbers").coefficient(&monomial(&[1])), rational(3, 2));
}

/// x0 + x1 x2 at x0 = x1 + 1 and x1 = 2: what is beyond the list stays.
#[test]
fn substitution_is_simultaneous() {
    let sum = polynomial(&[(1, &[0]), (1, &[1, 2])]);
    let values = [polynomial(&[(1, &[1]), (1, &[])]), polynomial(&[(2, &[])])];
    assert_eq!(sum.substitute(&values), Ok(polynomial(&[(1, &[1]), (1, &[]), (2, &[2])])));
}

/// Rationals of all sizes, so that some operations overflow and some do not.
fn any_rational() -> impl Strategy<Value = Rational> {
    let part =
        prop_oneof![-9..=9_i128, -1_000_000_007..=1_000_000_007_i128, any::<i64>().prop_map(i128::from), any::<i128>()];
    (part.clone(), part).prop_filter_map("a denominator", |(n, d)| Rational::new(n, d).ok())
}

fn small_rational() -> impl Strategy<Value = Rational> {
    (-9..=9_i128, 1..=6_i128).prop_map(|(n, d)| rational(n, d))
}

fn any_polynomial() -> impl Strategy<Value = Polynomial> {
    let term = (small_rational(), prop::collection::vec(0..4 as Symbol, 0..4));
    prop::collection::vec(term, 0..5).prop_map(|terms| {
        let mut sum = Polynomial::zero();
        for (coefficient, symbols) in terms {
            sum.add_term(Monomial::new(symbols), coefficient).expect("small numbers");
        }
        sum
    })
}

proptest! {
    #[test]
    fn rational_operations_are_exact_or_overflow(a in any_rational(), b in any_rational()) {
        // Multiplied out in 128 bits where that is possible; whether it is has nothing to do with the code under test.
        let wide = |x: i128, y: i128| x.checked_mul(y);
        if let (Some(left), Some(right), Some(below)) = (
            wide(a.numerator(), b.denominator()), wide(b.numerator(), a.denominator()), wide(a.denominator(), b.denominator()),
        ) && let Some(above) = left.checked_add(right).filter(|&sum| sum != i128::MIN) {
            prop_assert_eq!(a.checked_add(b), Rational::new(above, below));
        }
        if let (Some(above), Some(below)) = (wide(a.numerator(), b.numerator()), wide(a.denominator(), b.denominator()))
            && above != i128::MIN
        {
            prop_assert_eq!(a.checked_mul(b), Rational::new(above, below));
        }
        if let (Some(left), Some(right)) = (wide(a.numerator(), b.denominator()), wide(b.numerator(), a.denominator())) {
            prop_assert_eq!(a.cmp(&b), left.cmp(&right));
        }
        prop_assert_eq!(a.cmp(&b), b.cmp(&a).reverse());
        prop_assert_eq!(a.checked_add(b), b.checked_add(a));
        prop_assert_eq!(a.checked_mul(b), b.checked_mul(a));
        if let Ok(sum) = a.checked_add(b) {
            prop_assert_eq!(sum.checked_add(b.neg()).unwrap_or(a), a);
        }
        if let Ok(Some(quotient)) = a.checked_div(b) {
            prop_assert_eq!(quotient.checked_mul(b), Ok(a));
        }
    }

    #[test]
    fn polynomials_are_a_commutative_ring(a in any_polynomial(), b in any_polynomial(), c in any_polynomial()) {
        let add = |x: &Polynomial, y: &Polynomial| x.add(y).expect("small numbers");
        let mul = |x: &Polynomial, y: &Polynomial| x.mul(y).expect("small numbers");
        prop_assert_eq!(add(&a, &b), add(&b, &a));
        prop_assert_eq!(mul(&a, &b), mul(&b, &a));
        prop_assert_eq!(add(&add(&a, &b), &c), add(&a, &add(&b, &c)));
        prop_assert_eq!(mul(&mul(&a, &b), &c), mul(&a, &mul(&b, &c)));
        prop_assert_eq!(mul(&a, &add(&b, &c)), add(&mul(&a, &b), &mul(&a, &c)));
        prop_assert!(add(&a, &a.neg()).is_zero());
        prop_assert_eq!(mul(&a, &Polynomial::one()), a);
    }

    #[test]
    fn substitution_commutes_with_products(a in any_polynomial(), b in any_polynomial(), values in prop::collection::vec(any_polynomial(), 4)) {
        let values: Vec<_> = values.iter().map(|value| {
            let mut low = Polynomial::zero();
            for (monomial, coefficient) in value.terms().filter(|(monomial, _)| monomial.degree() <= 1) {
                low.add_term(monomial.clone(), coefficient).expect("small numbers");
            }
            low
        }).collect();
        let at = |x: &Polynomial| x.substitute(&values).expect("small numbers");
        prop_assert_eq!(at(&a.mul(&b).expect("small numbers")), at(&a).mul(&at(&b)).expect("small numbers"));
    }

    #[test]
    fn normal_forms_of_the_unit_motor_are_unique(
        a in any_polynomial(), first in any_polynomial(), second in any_polynomial(),
    ) {
        let (relations, rules) = unit_motor();
        let multiple = |factor: &Polynomial, rule: &Relation| factor.mul(rule.polynomial()).expect("small numbers");
        let mut other = a.clone();
        for (factor, rule) in [&first, &second].into_iter().zip(&rules) {
            other = other.add(&multiple(factor, rule)).expect("small numbers");
        }
        let form = |x: &Polynomial| relations.normal_form(x).expect("small numbers");
        prop_assert_eq!(form(&other), form(&a), "adding a multiple of a relation changes nothing");
        prop_assert_eq!(form(&form(&a)), form(&a));
        prop_assert!(relations.difference(&a, &other).expect("small numbers").is_zero());
        for (left, _) in form(&a).terms() {
            for rule in &rules {
                prop_assert!(left.divided_by(rule.leading()).is_none(), "no leading monomial is left");
            }
        }
    }
}

// Relations. The symbols are those of a motor: s e23 e31 e12 e01 e02 e03 e0123.

const S: Symbol = 0;
const E23: Symbol = 1;
const E31: Symbol = 2;
const E12: Symbol = 3;
const E01: Symbol = 4;
const E02: Symbol = 5;
const E03: Symbol = 6;
const E0123: Symbol = 7;

/// The two rules s^2 -> 1 - e23^2 - e31^2 - e12^2 and e23 e01 -> s e0123 - e31 e02 - e12 e03.
fn unit_motor() -> (Relations, [Relation; 2]) {
    let norm = polynomial(&[(1, &[S, S]), (1, &[E23, E23]), (1, &[E31, E31]), (1, &[E12, E12]), (-1, &[])]);
    let study = polynomial(&[(1, &[E23, E01]), (1, &[E31, E02]), (1, &[E12, E03]), (-1, &[S, E0123])]);
    let rules = [
        Relation::new(norm, monomial(&[S, S])).expect("a leading monomial"),
        Relation::new(study, monomial(&[E23, E01])).expect("a leading monomial"),
    ];
    (Relations::new(&rules).expect("confluent"), rules)
}

#[test]
fn the_unit_motor_has_the_normal_forms_of_its_two_rules() {
    let (relations, _) = unit_motor();
    let form = |x: &Polynomial| relations.normal_form(x).expect("small numbers");
    let square = polynomial(&[(1, &[S, S])]);
    assert_eq!(form(&square), polynomial(&[(1, &[]), (-1, &[E23, E23]), (-1, &[E31, E31]), (-1, &[E12, E12])]));
    let product = polynomial(&[(1, &[E23, E01])]);
    assert_eq!(form(&product), polynomial(&[(1, &[S, E0123]), (-1, &[E31, E02]), (-1, &[E12, E03])]));
    // The norm of a motor is 1 whatever is multiplied to it.
    let norm = polynomial(&[(1, &[S, S]), (1, &[E23, E23]), (1, &[E31, E31]), (1, &[E12, E12])]);
    let any = polynomial(&[(3, &[E01, S]), (-2, &[E0123])]);
    assert_eq!(form(&norm.mul(&any).expect("small numbers")), form(&any));
}

#[test]
fn relations_that_are_not_confluent_leave_a_remainder() {
    // The unit line with e23^2 as the leading monomial next to e23 e01.
    let norm = polynomial(&[(1, &[E23, E23]), (1, &[E31, E31]), (1, &[E12, E12]), (-1, &[])]);
    let pluecker = polynomial(&[(1, &[E23, E01]), (1, &[E31, E02]), (1, &[E12, E03])]);
    let relation = |polynomial: &Polynomial, leading: &[Symbol]| {
        Relation::new(polynomial.clone(), monomial(leading)).expect("a leading monomial")
    };
    let refused = Relations::new(&[relation(&norm, &[E23, E23]), relation(&pluecker, &[E23, E01])]);
    assert!(matches!(refused, Err(RelationsError::NotConfluent(0, 1, ref left)) if !left.is_zero()), "{refused:?}");
    let accepted = Relations::new(&[relation(&norm, &[E31, E31]), relation(&pluecker, &[E23, E01])]);
    assert!(accepted.is_ok(), "{accepted:?}");
}

/// x = z and x y = w make y z of x y as well as w.
#[test]
fn a_leading_monomial_that_divides_another_clashes_with_it() {
    let short = Relation::new(polynomial(&[(1, &[0]), (-1, &[2])]), monomial(&[0])).expect("a leading monomial");
    let long = Relation::new(polynomial(&[(1, &[0, 1]), (-1, &[3])]), monomial(&[0, 1])).expect("a leading monomial");
    for rules in [[short.clone(), long.clone()], [long, short]] {
        let refused = Relations::new(&rules);
        let Err(RelationsError::NotConfluent(0, 1, left)) = refused else { panic!("{refused:?}") };
        assert!([left.clone(), left.neg()].contains(&polynomial(&[(1, &[1, 2]), (-1, &[3])])), "{left:?}");
    }
}

#[test]
fn relations_whose_leading_monomials_are_not_the_greatest_do_not_terminate() {
    let relation = |terms: &[(i64, &[Symbol])], leading: &[Symbol]| {
        Relation::new(polynomial(terms), monomial(leading)).expect("a leading monomial")
    };
    let circle = relation(&[(1, &[0, 1]), (-1, &[0, 0]), (-1, &[1, 1])], &[0, 1]);
    assert_eq!(Relations::new(std::slice::from_ref(&circle)), Err(RelationsError::NotTerminating(0)));
    let forth = relation(&[(1, &[0]), (-1, &[1])], &[0]);
    let back = relation(&[(1, &[1]), (-1, &[0])], &[1]);
    assert!(matches!(Relations::new(&[forth, back]), Err(RelationsError::NotTerminating(_))));
}

/// 2 x0 x1 = 6 x1 + 1, moved by 3 symbols: x3 x4 = 3 x4 + 1/2.
#[test]
fn relations_are_rewritten_at_any_coefficient_and_moved() {
    let relation =
        Relation::new(polynomial(&[(2, &[0, 1]), (-6, &[1]), (-1, &[])]), monomial(&[0, 1])).expect("a monomial");
    let moved = relation.shifted(3);
    assert_eq!(
        (moved.leading(), moved.polynomial()),
        (&monomial(&[3, 4]), &polynomial(&[(2, &[3, 4]), (-6, &[4]), (-1, &[])]))
    );
    let relations = Relations::new(&[moved]).expect("it terminates");
    let mut expected = polynomial(&[(3, &[4, 7])]);
    expected.add_term(monomial(&[7]), rational(1, 2)).expect("small numbers");
    assert_eq!(relations.normal_form(&polynomial(&[(1, &[3, 4, 7])])), Ok(expected));
    assert!(!relations.is_empty() && Relations::new(&[]).expect("nothing to check").is_empty());
    assert_eq!(Relations::default().normal_form(&polynomial(&[(1, &[3, 4])])), Ok(polynomial(&[(1, &[3, 4])])));
}

/// x = y + 1, y = z + 1 end in z in the order x, y, z; x = y^2 and y = x^2 never end, nor does x = x y.
#[test]
fn rewriting_ends_in_the_order_of_some_list_of_symbols() {
    let relation = |terms: &[(i64, &[Symbol])], leading: &[Symbol]| {
        Relation::new(polynomial(terms), monomial(leading)).expect("a leading monomial")
    };
    let steps =
        [relation(&[(1, &[5]), (-1, &[3]), (-1, &[])], &[5]), relation(&[(1, &[3]), (-1, &[4]), (-1, &[])], &[3])];
    let relations = Relations::new(&steps).expect("it ends");
    assert_eq!(relations.normal_form(&polynomial(&[(1, &[5])])), Ok(polynomial(&[(1, &[4]), (2, &[])])));
    let forth = relation(&[(1, &[0]), (-1, &[1, 1])], &[0]);
    let back = relation(&[(1, &[1]), (-1, &[0, 0])], &[1]);
    for rules in
        [vec![forth.clone(), back.clone()], vec![back, forth], vec![relation(&[(1, &[0]), (-1, &[0, 1])], &[0])]]
    {
        assert!(matches!(Relations::new(&rules), Err(RelationsError::NotTerminating(_))), "{rules:?}");
    }
}

#[test]
fn a_relation_has_its_leading_monomial() {
    assert_eq!(Relation::new(polynomial(&[(1, &[0])]), monomial(&[1])), None);
    assert_eq!(
        Relation::new(polynomial(&[(1, &[0]), (1, &[])]), monomial(&[])),
        None,
        "a constant cannot be rewritten"
    );
}

// Series, in three unknowns x, y, z of norm l = sqrt(x^2 + y^2 + z^2) and a fourth, c.

const RADICAL: Symbol = 4;
const OTHER: Symbol = 3;
const ORDER: usize = 10;

fn ring() -> SeriesRing {
    SeriesRing::new(ORDER, RADICAL, &polynomial(&[(1, &[0, 0]), (1, &[1, 1]), (1, &[2, 2])])).expect("a quadratic form")
}

fn series(ring: &SeriesRing, terms: &[(i64, &[Symbol])]) -> Series {
    ring.series(&polynomial(terms)).expect("small numbers")
}

#[track_caller]
fn assert_same(ring: &SeriesRing, a: &Series, b: &Series) {
    let difference = ring.add(a, &ring.neg(b)).expect("small numbers");
    assert!(difference.polynomial().is_zero(), "{:?}", difference.polynomial());
}

#[test]
fn the_radical_squares_to_its_form() {
    let ring = ring();
    let radical = series(&ring, &[(1, &[RADICAL])]);
    let square = ring.mul(&radical, &radical).expect("small numbers");
    assert_same(&ring, &square, &series(&ring, &[(1, &[0, 0]), (1, &[1, 1]), (1, &[2, 2])]));
    assert_same(&ring, &ring.sqrt(&square).expect("a square"), &radical);
}

#[test]
fn sine_and_cosine_are_on_the_unit_circle_and_have_their_first_terms() {
    let ring = ring();
    for angle in [series(&ring, &[(1, &[RADICAL])]), series(&ring, &[(1, &[0]), (-3, &[1, 2])])] {
        let (sin, cos) = (ring.sin(&angle).expect("no constant"), ring.cos(&angle).expect("no constant"));
        let square = |x: &Series| ring.mul(x, x).expect("small numbers");
        assert_same(
            &ring,
            &ring.add(&square(&sin), &square(&cos)).expect("small numbers"),
            &series(&ring, &[(1, &[])]),
        );
        let back = ring.atan2(&sin, &cos).expect("near (1, 0)");
        assert_same(&ring, &back, &angle);
    }
    let sin = ring.sin(&series(&ring, &[(1, &[RADICAL])])).expect("no constant");
    assert_eq!(sin.polynomial().coefficient(&monomial(&[RADICAL])), Rational::ONE);
    assert_eq!(sin.polynomial().coefficient(&monomial(&[RADICAL; 3])), rational(-1, 6));
    assert_eq!(sin.polynomial().coefficient(&monomial(&[RADICAL; 9])), rational(1, 362_880));
}

#[test]
fn a_root_squares_to_its_argument() {
    let ring = ring();
    let one_more = series(&ring, &[(1, &[]), (1, &[RADICAL, RADICAL]), (-2, &[RADICAL; 3])]);
    let root = ring.sqrt(&one_more).expect("a constant term of 1");
    assert_same(&ring, &ring.mul(&root, &root).expect("small numbers"), &one_more);
}

#[test]
fn unknowns_over_the_radical_are_directions() {
    let ring = ring();
    let radical = series(&ring, &[(1, &[RADICAL])]);
    let directions: Vec<_> = (0..3)
        .map(|symbol| ring.quotient(&series(&ring, &[(1, &[symbol])]), &radical).expect("x is l times a direction"))
        .collect();
    let squares = directions.iter().map(|n| ring.mul(n, n).expect("small numbers"));
    let sum = squares.reduce(|a, b| ring.add(&a, &b).expect("small numbers")).expect("three");
    assert_same(&ring, &sum, &series(&ring, &[(1, &[])]));
    for (symbol, direction) in directions.iter().enumerate() {
        assert_eq!(ring.degree(&monomial(&[symbol as Symbol])), 0, "directions have no degree");
        let back = ring.mul(direction, &radical).expect("small numbers");
        assert_same(&ring, &back, &series(&ring, &[(1, &[symbol as Symbol])]));
    }
}

#[test]
fn quotients_by_the_radical_lose_its_orders() {
    let ring = ring();
    let radical = series(&ring, &[(1, &[RADICAL])]);
    let sin = ring.sin(&radical).expect("no constant");
    let sinc = ring.quotient(&sin, &radical).expect("sin l / l");
    assert_same(&ring, &ring.mul(&sinc, &radical).expect("small numbers"), &sin);
    let square = series(&ring, &[(1, &[RADICAL, RADICAL])]);
    let difference = ring.add(&ring.cos(&radical).expect("no constant"), &ring.neg(&sinc)).expect("small numbers");
    let g = ring.quotient(&difference, &square).expect("(cos l - sin l / l) / l^2");
    assert_eq!(g.order(), sinc.order() - 2, "a division by l^2 costs two orders");
    assert_eq!(g.polynomial().coefficient(&Monomial::default()), rational(-1, 3));
}

#[test]
fn what_has_no_series_is_an_error() {
    let ring = ring();
    let undefined = |result: Result<Series, SeriesError>| matches!(result, Err(SeriesError::Undefined(_)));
    let (one, x) = (series(&ring, &[(1, &[])]), series(&ring, &[(1, &[0])]));
    let (radical, other) = (series(&ring, &[(1, &[RADICAL])]), series(&ring, &[(1, &[OTHER])]));
    let direction = ring.quotient(&x, &radical).expect("x is l times a direction");
    assert!(undefined(ring.sin(&direction)), "a sine about a number between -1 and 1");
    assert!(undefined(ring.sin(&one)), "a sine about 1");
    assert!(undefined(ring.cos(&one)), "a cosine about 1");
    assert!(undefined(ring.sqrt(&x)), "the root of an unknown");
    assert!(undefined(ring.sqrt(&radical)), "the root of an odd power of the radical");
    assert!(undefined(ring.sqrt(&ring.neg(&one))), "the root of -1");
    assert!(undefined(ring.sqrt(&series(&ring, &[]))), "the root of 0");
    assert!(undefined(ring.quotient(&one, &radical)), "a pole");
    assert!(undefined(ring.quotient(&radical, &x)), "a division by an unknown");
    assert!(undefined(ring.atan2(&one, &x)), "an angle about a right angle");
    assert!(undefined(ring.quotient(&other, &radical)), "a quotient that grows without bound");
    let forms = [
        polynomial(&[(1, &[0, 0]), (-1, &[1, 1])]),
        polynomial(&[(-1, &[0, 0])]),
        polynomial(&[(1, &[0, 0]), (1, &[0, 1])]),
    ];
    for form in forms {
        let indefinite = SeriesRing::new(ORDER, RADICAL, &form);
        assert!(matches!(indefinite, Err(SeriesError::Undefined(_))), "a radical that may not be real: {form:?}");
    }
    let cubic = SeriesRing::new(ORDER, RADICAL, &polynomial(&[(1, &[0, 0, 0])]));
    assert!(matches!(cubic, Err(SeriesError::Undefined(_))), "a radical of a cubic form");
}

#[test]
fn what_is_wrong_with_a_series_is_said() {
    let ring = ring();
    let (one, radical) = (series(&ring, &[(1, &[])]), series(&ring, &[(1, &[RADICAL])]));
    let error = |result: Result<Series, SeriesError>| result.expect_err("no series").to_string();
    assert_eq!(error(ring.sin(&one)), "expected a series without terms of degree 0, found one with them");
    assert_eq!(
        error(ring.quotient(&one, &radical)),
        "expected a series divisible by the radical to the 1, found one that is not"
    );
    assert_eq!(error(ring.sqrt(&radical)), "expected an even power of the radical, found 1 l^1");
    assert_eq!(error(ring.atan2(&one, &radical)), "expected a second argument of atan2 near 1, found 0");
    assert_eq!(SeriesError::from(Overflow).to_string(), Overflow.to_string());
}

/// With l to the order 10, l^11 is not known; x is l times a direction, so it counts as one degree, and c is one itself.
#[test]
fn series_are_known_to_their_order_and_no_further() {
    let ring = ring();
    let power = |symbol: Symbol, n: usize| series(&ring, &[(1, &vec![symbol; n])]);
    for symbol in [RADICAL, OTHER, 0] {
        assert!(!power(symbol, ORDER).polynomial().is_zero() && power(symbol, ORDER + 1).polynomial().is_zero());
        assert_eq!(ring.mul(&power(symbol, 5), &power(symbol, 5)), Ok(power(symbol, ORDER)));
        assert!(ring.mul(&power(symbol, 6), &power(symbol, 5)).expect("small numbers").polynomial().is_zero());
    }
    let known = |a: &Series, b: &Series| ring.quotient(a, b).expect("a quotient").order();
    assert_eq!(known(&power(RADICAL, 3), &power(RADICAL, 2)), ORDER - 2);
    // What is known of a to order 7 and divisible by l is known of a l to order 8, of a l^2 to 9, of the root of l^2 b to 8.
    let seven = ring.quotient(&power(RADICAL, 4), &power(RADICAL, 3)).expect("l");
    assert_eq!(seven.order(), ORDER - 3);
    for (n, order) in [(1, 8), (2, 9), (3, 10), (4, 10)] {
        let product = ring.mul(&seven, &power(RADICAL, n)).expect("small numbers");
        assert_eq!((product.order(), product.polynomial()), (order, power(RADICAL, n + 1).polynomial()));
    }
    assert_eq!(ring.add(&seven, &power(RADICAL, 1)).expect("small numbers").order(), 7);
    assert_eq!(ring.sin(&seven).expect("no constant").order(), 7);
    let square = ring.mul(&seven, &seven).expect("small numbers");
    assert_eq!((square.order(), ring.sqrt(&square).expect("a square").order()), (8, 7));
    // Of what is known to be 0 to order 7 and l^2 known to order 2 the product is known to order 9, of two such zeros one more.
    let zero = |a: &Series| ring.add(a, &ring.neg(a)).expect("small numbers");
    let two = ring.quotient(&power(RADICAL, 10), &power(RADICAL, 8)).expect("l^2");
    let order = |a: &Series, b: &Series| ring.mul(a, b).expect("small numbers").order();
    assert_eq!((two.order(), order(&zero(&seven), &two), order(&two, &zero(&seven))), (2, 9, 9));
    assert_eq!(order(&zero(&seven), &zero(&two)), 10);
    assert_eq!(ring.directions(), [0, 1, 2]);
}
