//! The claims about the kernels of one definition, for any compiled form of them.

use crate::dispatch::CompiledKernel;
use crate::exact::Exact;
use crate::interpreter::{Coefficient, interpret, multivector};
use crate::samples::{self, Random, is_ideal, relation_values};
use crate::tracked::{ROUNDING, Tracked};
use ga_codegen::kernel::{Analytic, ComponentValue, Definition, Entity, Kernel};
use ga_codegen::reference::Multivector;
use ga_codegen::symbolic::Rational;
use std::f64::consts::PI;

/// Samples of every polynomial kernel in floating point.
const FLOAT_CASES: u64 = 40;

/// No bound on a rounding error may be larger than this, relative to what goes in and comes out: a bound that is not
/// small says nothing.
const LARGEST_BOUND: f64 = 1e-10;

/// The definition of a preset.
pub(crate) fn definition(preset: &str) -> Definition {
    let text = ga_codegen::preset::text(preset).expect("a preset");
    ga_codegen::define(text.parse().expect("a preset made of tokens")).expect("a preset without errors")
}

/// Pairs every kernel of a definition with its compiled form; none is left over on either side.
fn pairs<'a, T>(
    definition: &'a Definition,
    table: &'a [CompiledKernel<T>],
) -> Vec<(&'a Kernel, &'a CompiledKernel<T>)> {
    let names: Vec<_> = definition.kernels.iter().map(|kernel| kernel.name.as_str()).collect();
    let compiled: Vec<_> = table.iter().map(|compiled| compiled.name).collect();
    assert_eq!(compiled, names, "every kernel of the definition, in its order, is compiled");
    definition.kernels.iter().zip(table).collect()
}

/// The fields that an entity has in a multivector, once it is known to hold it: nothing is lost and nothing is made up.
fn held_fields<T: Coefficient + std::fmt::Display>(
    value: &Multivector<T>,
    entity: &Entity,
    case: impl Fn() -> String,
) -> Vec<T> {
    let mut rest = value.clone();
    let mut fields = Vec::new();
    for component in &entity.components {
        let coefficient = value.coefficient(&component.name);
        match component.value {
            ComponentValue::Field(_) => fields.push(coefficient),
            ComponentValue::Constant(constant) => {
                let is_met = coefficient == T::rational(constant);
                assert!(is_met, "{}: `{}` is not {constant}", case(), component.name);
            }
        }
        let term = Multivector::from_blades(value.signature(), [(&component.name, coefficient)]);
        rest = rest.sub(&term.expect("a word of the signature"));
    }
    assert!(rest.blades().is_empty(), "{}: {} cannot hold {rest}", case(), entity.name);
    fields
}

/// On so many random inputs that satisfy their types' relations, every polynomial kernel gives what its definition gives
/// on the reference, and what the output type promises holds; both exactly.
pub(crate) fn agree_exactly(preset: &str, table: &[CompiledKernel<Exact>], cases: usize) {
    let definition = definition(preset);
    let (mut kernels, mut promises) = (0, 0);
    let pairs = pairs(&definition, table);
    let pools = samples::Pools::new(&definition, cases, &mut Random(1));
    for (kernel, compiled) in pairs.iter().filter(|(kernel, _)| kernel.analytic.is_none()) {
        let output = &definition.entities[kernel.output];
        let mut random = Random(1);
        for index in 0..cases {
            let row = pools.row(&definition, kernel, index, &mut random);
            let case = || format!("{preset} {} case {index} {row:?}", kernel.name);
            let expected = held_fields(&interpret(&definition, kernel, &row), output, case);
            let found = (compiled.call)(&row);
            assert_eq!(found.fields, expected, "{}", case());
            assert_eq!(found.relation_errors.len(), output.statements.len(), "{}", case());
            assert!(found.relation_errors.iter().all(|error| *error == Exact::ZERO), "{}: broken promise", case());
            promises += found.relation_errors.len();
        }
        kernels += 1;
    }
    let analytic = definition.kernels.iter().filter(|kernel| kernel.analytic.is_some()).count();
    assert_eq!(kernels + analytic, definition.kernels.len());
    println!("{preset}: {kernels} polynomial kernels, {cases} cases each, {promises} promises kept");
}

/// `relation_errors()` is left minus right side of each relation, also where that is not 0.
pub(crate) fn relation_errors_are_left_minus_right(preset: &str, table: &[CompiledKernel<Exact>]) {
    let definition = definition(preset);
    let mut random = Random(2);
    let mut checked = Vec::new();
    for (kernel, compiled) in pairs(&definition, table) {
        let output = &definition.entities[kernel.output];
        if kernel.analytic.is_some() || output.statements.is_empty() {
            continue;
        }
        for _ in 0..200 {
            // Coefficients that break the promises of the inputs, so that those of the output are broken as well.
            let fields = kernel.parameters.iter().map(|p| definition.entities[p.entity].fields().count()).sum();
            let row: Vec<_> = (0..fields).map(|_| random.fraction()).collect();
            let found = (compiled.call)(&row);
            assert_eq!(found.relation_errors, relation_values(output, &found.fields), "{} {row:?}", kernel.name);
        }
        checked.push(output.name.as_str());
    }
    let promising = definition.entities.iter().filter(|entity| !entity.statements.is_empty());
    for entity in promising {
        assert!(checked.contains(&entity.name.as_str()), "no kernel gives a {}", entity.name);
    }
}

/// A result in floating point and its bound, from the same compiled kernel on the same numbers.
fn run_tracked(
    compiled: &CompiledKernel<f64>,
    tracked: &CompiledKernel<Tracked>,
    row: &[Tracked],
    case: &str,
) -> Vec<Tracked> {
    let values: Vec<_> = row.iter().map(|coefficient| coefficient.value).collect();
    let (found, bounded) = ((compiled.call)(&values).fields, (tracked.call)(row).fields);
    for (found, bounded) in found.iter().zip(&bounded) {
        assert!(found.to_bits() == bounded.value.to_bits() || *found == 0.0 && bounded.value == 0.0, "{case}");
    }
    bounded
}

fn assert_within(found: Tracked, expected: f64, expected_bound: f64, size: f64, case: &str) {
    let bound = found.bound + expected_bound;
    assert!(bound <= LARGEST_BOUND * size, "{case}: the bound {bound:e} says nothing");
    let error = (found.value - expected).abs();
    assert!(error <= bound, "{case}: found {}, expected {expected}, error {error:e} > {bound:e}", found.value);
}

/// In `f64` every polynomial kernel is within its running error bound of the exact result. The inputs are rounded too:
/// the bound starts with theirs, so that the exact motor near the rounded one is what is compared with.
pub(crate) fn agree_within_rounding(
    preset: &str,
    table: &[CompiledKernel<f64>],
    tracked_table: &[CompiledKernel<Tracked>],
) {
    let definition = definition(preset);
    let mut worst: f64 = 0.0;
    let pairs = pairs(&definition, table);
    for ((kernel, compiled), tracked) in pairs.iter().zip(tracked_table).filter(|((k, _), _)| k.analytic.is_none()) {
        let output = &definition.entities[kernel.output];
        let mut random = Random(3);
        for index in 0..FLOAT_CASES {
            let exact = samples::row(&definition, kernel, &mut random);
            let case = format!("{preset} {} case {index} {exact:?}", kernel.name);
            let expected = held_fields(&interpret(&definition, kernel, &exact), output, || case.clone());
            // `to_f64` is off by up to 3 u = 1.5 ROUNDING, relatively.
            let round = |x: &Exact| Tracked { value: x.to_f64(), bound: 2.0 * ROUNDING * x.to_f64().abs() };
            let row: Vec<_> = exact.iter().map(round).collect();
            // Kernels are of degree at most 4 in coefficients of at most 9 or so.
            for (found, expected) in run_tracked(compiled, tracked, &row, &case).into_iter().zip(&expected) {
                assert_within(found, expected.to_f64(), round(expected).bound, 1e4, &case);
                worst = worst.max(found.bound);
            }
        }
    }
    println!("{preset}: the largest bound on a rounding error is {worst:e}");
}

/// Bivectors of half-angle `norm`, with Euclidean parts in random directions and ideal parts of size `ideal`.
fn bivector(entity: &Entity, norm: f64, ideal: f64, random: &mut Random) -> Vec<Tracked> {
    let words: Vec<_> = entity.fields().map(|(_, component)| component.name.as_str()).collect();
    let raw: Vec<_> = words.iter().map(|_| random.float()).collect();
    let squares = words.iter().zip(&raw).filter(|(word, _)| !is_ideal(word)).map(|(_, x)| x * x);
    let scale = norm / squares.sum::<f64>().sqrt();
    let scaled = words.iter().zip(&raw).map(|(word, x)| if is_ideal(word) { x * ideal } else { x * scale });
    scaled.map(Tracked::new).collect()
}

/// Half-angles from 0 to pi, each with no, a small and a large translation. Pure translations are those of half-angle 0.
fn bivectors(entity: &Entity, largest: f64) -> Vec<Vec<Tracked>> {
    let mut random = Random(4);
    let mut found = Vec::new();
    for norm in [0.0, 1e-100, 1e-9, 1e-5, 1e-3, 0.1, 0.5, 1.0, PI / 2.0, 2.0, 2.5, 3.0, PI] {
        for ideal in [0.0, 1e-6, 1.0, 100.0] {
            for _ in 0..4 {
                found.push(bivector(entity, norm, ideal, &mut random));
            }
        }
    }
    let norm = |b: &Vec<Tracked>| {
        let squares = entity.fields().zip(b).filter(|((_, c), _)| !is_ideal(&c.name)).map(|(_, x)| x.value * x.value);
        squares.sum::<f64>().sqrt()
    };
    found.retain(|b| norm(b) <= largest);
    found
}

/// The number of terms of the exponential series. With l <= 3.2 the Euclidean part and c <= 200 the ideal part of B, the
/// coefficients of B^n are at most l^n and n l^(n-1) c, so what is left out is less than 2 c 3.2^60 / 60! < 1e-47.
const TERMS: i128 = 60;

/// sum of B^n / n! on the reference, with a bound on its rounding errors.
fn exponential_series(b: &Multivector<Tracked>) -> Multivector<Tracked> {
    let mut term = Multivector::scalar(b.signature(), Tracked::new(1.0));
    let mut sum = term.clone();
    for n in 1..TERMS {
        let reciprocal = Rational::new(1, n).expect("a divisor other than 0");
        term = term.geometric(b).scale(Tracked::rational(reciprocal));
        sum = sum.add(&term);
    }
    sum
}

fn find(definition: &Definition, analytic: Analytic) -> Vec<(usize, &Kernel)> {
    definition.kernels.iter().enumerate().filter(|(_, kernel)| kernel.analytic == Some(analytic)).collect()
}

/// exp(B) is sum B^n / n! up to rounding, at every half-angle up to pi, at 0, and for pure translations.
pub(crate) fn exp_is_its_series(
    preset: &str,
    table: &[CompiledKernel<f64>],
    tracked_table: &[CompiledKernel<Tracked>],
) {
    let definition = definition(preset);
    let (mut cases, mut worst) = (0, 0.0_f64);
    for (index, kernel) in find(&definition, Analytic::Exp) {
        let input = &definition.entities[kernel.parameters[0].entity];
        let output = &definition.entities[kernel.output];
        for row in bivectors(input, 3.2) {
            let case = format!("{preset} {} {row:?}", kernel.name);
            let expected = exponential_series(&interpret(&definition, kernel, &row));
            let found = run_tracked(&table[index], &tracked_table[index], &row, &case);
            let size = 1.0 + row.iter().map(|x| x.value.abs()).sum::<f64>();
            let mut rest = expected.clone();
            for ((_, component), found) in output.fields().zip(found) {
                let expected = expected.coefficient(&component.name);
                assert_within(found, expected.value, expected.bound, size, &case);
                worst = worst.max(found.bound / size);
                let term = Multivector::from_blades(rest.signature(), [(&component.name, expected)]);
                rest = rest.sub(&term.expect("a word of the signature"));
            }
            let beyond = rest.blades().into_iter().find(|(_, value)| value.value != 0.0);
            assert_eq!(beyond, None, "{case}: {} holds the exponential", output.name);
            cases += 1;
        }
    }
    assert!(cases > 0, "{preset} has an exponential");
    println!("{preset}: exp in {cases} cases, the largest relative bound is {worst:e}");
}

/// log(exp(B)) = B up to rounding, at every half-angle below pi, at 0, and for pure translations.
pub(crate) fn log_inverts_exp(preset: &str, table: &[CompiledKernel<f64>], tracked_table: &[CompiledKernel<Tracked>]) {
    let definition = definition(preset);
    let mut cases = 0;
    for (exp_index, exp) in find(&definition, Analytic::Exp) {
        let suits = |log: &Kernel| log.parameters[0].entity == exp.output && log.output == exp.parameters[0].entity;
        for (log_index, log) in find(&definition, Analytic::Log).into_iter().filter(|(_, log)| suits(log)) {
            for row in bivectors(&definition.entities[log.output], 3.1) {
                let case = format!("{preset} {} of {} {row:?}", log.name, exp.name);
                let motor = run_tracked(&table[exp_index], &tracked_table[exp_index], &row, &case);
                let found = run_tracked(&table[log_index], &tracked_table[log_index], &motor, &case);
                let size = 1.0 + row.iter().map(|x| x.value.abs()).sum::<f64>();
                for (found, expected) in found.into_iter().zip(&row) {
                    assert_within(found, expected.value, 0.0, size, &case);
                }
                cases += 1;
            }
        }
    }
    assert!(cases > 0, "{preset} has a logarithm of its exponential");
    println!("{preset}: log of exp in {cases} cases");
}

/// What `normalize` gives, x, is y over the root of its norm y ~y = A + N: x (2 A + N) = 2 sqrt(A) y up to rounding, on the
/// reference; and so is the square root of a unit m, with y = 1 + m, whose square is m besides.
pub(crate) fn units_are_normalized(
    preset: &str,
    table: &[CompiledKernel<f64>],
    tracked_table: &[CompiledKernel<Tracked>],
) {
    let definition = definition(preset);
    let kernels = find(&definition, Analytic::Normalize).into_iter().chain(find(&definition, Analytic::Sqrt));
    let (mut cases, mut skipped) = (0, 0);
    for (index, kernel) in kernels {
        let output = &definition.entities[kernel.output];
        let mut random = Random(6);
        for _ in 0..FLOAT_CASES {
            // The rounded inputs are taken as they are: what is compared is a function of them, not a promise.
            let row: Vec<_> =
                samples::row(&definition, kernel, &mut random).iter().map(|x| Tracked::new(x.to_f64())).collect();
            let case = format!("{preset} {} {row:?}", kernel.name);
            let value = interpret(&definition, kernel, &row);
            let one = Multivector::scalar(value.signature(), Tracked::new(1.0));
            let is_root = kernel.analytic == Some(Analytic::Sqrt);
            let y = if is_root { value.add(&one) } else { value.clone() };
            let norm = y.geometric(&y.reverse());
            let square = norm.coefficient("1");
            if square.value < 1e-2 {
                skipped += 1; // -1 and its like, of which no root is asked.
                continue;
            }
            let found = run_tracked(&table[index], &tracked_table[index], &row, &case);
            let x = multivector(definition.basis.signature(), output, &found);
            let left = x.geometric(&norm.add(&Multivector::scalar(value.signature(), square)));
            let right = y.scale(square.sqrt() + square.sqrt());
            assert_vanishes(&left.sub(&right), &case);
            if is_root {
                // The root relies on m ~m = 1, which the rounded input misses by some rounding errors, and so does the square.
                for (blade, difference) in x.geometric(&x).sub(&value).blades() {
                    assert!(difference.value.abs() <= difference.bound + 1e-12, "{case}: the square's {blade}");
                }
            }
            cases += 1;
        }
    }
    assert!(cases > 20 * skipped && cases > 0, "{preset}: {cases} cases, {skipped} skipped");
    println!("{preset}: roots and units in {cases} cases, {skipped} skipped");
}

fn assert_vanishes(value: &Multivector<Tracked>, case: &str) {
    for (blade, coefficient) in value.blades() {
        let Tracked { value, bound } = coefficient;
        assert!(bound <= 1e-9, "{case}: the bound {bound:e} says nothing");
        assert!(value.abs() <= bound, "{case}: {value:e} > {bound:e} at {blade}");
    }
}

/// The exponential's promises hold up to rounding, and the translators are the exponentials of ideal bivectors.
pub(crate) fn exp_of_an_ideal_bivector_is_one_more(preset: &str, table: &[CompiledKernel<f64>]) {
    let definition = definition(preset);
    for (index, kernel) in find(&definition, Analytic::Exp) {
        let (input, output) = (&definition.entities[kernel.parameters[0].entity], &definition.entities[kernel.output]);
        for row in bivectors(input, 0.0) {
            let row: Vec<f64> = row.iter().map(|x| x.value).collect();
            let found = (table[index].call)(&row).fields;
            for ((_, component), found) in output.fields().zip(found) {
                let given = input.fields().zip(&row).find(|((_, c), _)| c.name == component.name).map(|(_, x)| *x);
                let expected = if component.name == "1" { 1.0 } else { given.unwrap_or(0.0) };
                assert_eq!(found, expected, "{preset} {} {row:?}: `{}`", kernel.name, component.name);
            }
        }
    }
}

/// The samples themselves: unit motors that turn and move, in both halves of the double cover, half turns among them.
pub(crate) fn samples_reach_every_kind_of_motion(preset: &str) {
    let definition = definition(preset);
    let motor = definition.entity("Motor").expect("a motor");
    let signature = definition.basis.signature();
    let mut random = Random(1);
    let scalars: Vec<_> = (0..200)
        .map(|_| multivector(signature, motor, &samples::entity(signature, motor, &mut random)).coefficient("1"))
        .collect();
    for kind in [|s: &Exact| *s > Exact::ZERO, |s: &Exact| *s < Exact::ZERO, |s: &Exact| *s == Exact::ZERO] {
        assert!(scalars.iter().any(kind), "{preset}: {scalars:?}");
    }
}

/// The tests of one preset, on the function `table` that [`dispatch!`] has made, with so many exact cases for a kernel.
macro_rules! claims {
    ($preset:literal, $cases:expr) => {
        #[test]
        fn polynomial_kernels_agree_exactly_with_the_reference() {
            $crate::suite::agree_exactly($preset, &table(), $cases);
        }

        #[test]
        fn relation_errors_are_left_minus_right() {
            $crate::suite::relation_errors_are_left_minus_right($preset, &table());
        }

        #[test]
        fn polynomial_kernels_agree_in_f64_within_their_rounding_errors() {
            $crate::suite::agree_within_rounding($preset, &table(), &table());
        }

        #[test]
        fn exp_is_its_power_series() {
            $crate::suite::exp_is_its_series($preset, &table(), &table());
        }

        #[test]
        fn log_inverts_exp_below_a_half_angle_of_pi() {
            $crate::suite::log_inverts_exp($preset, &table(), &table());
        }

        #[test]
        fn units_are_normalized_and_roots_square_to_what_they_are_of() {
            $crate::suite::units_are_normalized($preset, &table(), &table());
        }

        #[test]
        fn exp_of_a_translation_is_exact() {
            $crate::suite::exp_of_an_ideal_bivector_is_one_more($preset, &table());
        }

        #[test]
        fn samples_reach_every_kind_of_motion() {
            $crate::suite::samples_reach_every_kind_of_motion($preset);
        }
    };
}
