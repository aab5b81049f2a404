//! The proof refutes wrong programs: of every emitted program, every mutant that differs from it in one operation.
//!
//! A mutant that the proof accepts must compute the same function. There are a few, such as a root with the other sign
//! where only its square and even functions of it are used. Each is evaluated in floating point next to the original, on
//! inputs that satisfy their types' relations, and has to be on the list [`EQUAL`] with the reason.

// Of what the differential tests have, only the samples are used here.
#[path = "differential/exact.rs"]
#[allow(dead_code, unused_macros)]
mod exact;
#[path = "differential/samples.rs"]
#[allow(dead_code)]
mod samples;

use ga_codegen::approximation::Function;
use ga_codegen::factor::factor_polynomials;
use ga_codegen::kernel::{Analytic, Definition, Kernel};
use ga_codegen::program::{
    FloatDomain, LANES, Operands, Operation, PackedOperation, PackedProgram, Program, Source, Value,
};
use ga_codegen::proof::{Refutation, prove, prove_evaluation};
use ga_codegen::symbolic::Rational;
use ga_codegen::{Compiled, Part};
use samples::Random;
use std::collections::BTreeSet;
use std::fmt;

/// A change of one operation.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
enum Mutation {
    NegatedResult,
    AddedForSubtracted,
    SubtractedForAdded,
    SwappedDifference,
    DroppedNegation,
    DroppedDoubling,
    DroppedRoot,
    WrongLimit,
    LeftOut,
    SwappedQuotient,
    SwappedAtan2,
    OtherFunction,
    SineForCosine,
    CosineForSine,
}

/// A mutation of the operation `at`, a kind of operation in words, and the program with it.
struct Mutant {
    mutation: Mutation,
    operation: &'static str,
    at: Value,
    program: Program,
}

const MULTIPLIED_BY_0: &str = "where the norm is 0 the quotient is multiplied by 0";
/// Mutants that are equal to their originals: preset, kernel, operation and mutation, and why.
const EQUAL: [(&str, &str, &str, Mutation, &str); 2] = [
    ("pga3d", "line_exp", "quotient", Mutation::WrongLimit, MULTIPLIED_BY_0),
    ("pga3d", "motor_log", "quotient", Mutation::WrongLimit, MULTIPLIED_BY_0),
];

fn name(operation: Operation) -> &'static str {
    match operation {
        Operation::Input(_) => "input",
        Operation::Constant(_) => "constant",
        Operation::Add(..) => "sum",
        Operation::Sub(..) => "difference",
        Operation::Mul(..) => "product",
        Operation::Neg(_) => "negation",
        Operation::Double(_) => "doubling",
        Operation::Div(..) => "division",
        Operation::Sqrt(_) => "root",
        Operation::Norm(_) => "norm",
        Operation::Sin(_) => "sine",
        Operation::Cos(_) => "cosine",
        Operation::Atan2(..) => "arc tangent",
        Operation::Quotient(..) => "quotient",
        Operation::Polynomial(..) => "polynomial",
    }
}

/// What can take the place of an operation.
fn replacements(operation: Operation) -> Vec<(Mutation, Operation)> {
    use Mutation::*;
    match operation {
        Operation::Add(a, b) => {
            vec![(SubtractedForAdded, Operation::Sub(a, b)), (SubtractedForAdded, Operation::Sub(b, a))]
        }
        Operation::Sub(a, b) => {
            vec![(AddedForSubtracted, Operation::Add(a, b)), (SwappedDifference, Operation::Sub(b, a))]
        }
        Operation::Div(a, b) => vec![(SwappedQuotient, Operation::Div(b, a))],
        Operation::Quotient(a, b, limit) => {
            let limits = [limit.neg(), limit.checked_add(Rational::ONE).expect("a small number")];
            let other = limits.into_iter().filter(|&other| other != limit);
            let other = other.map(|other| (WrongLimit, Operation::Quotient(a, b, other)));
            other.chain([(SwappedQuotient, Operation::Quotient(b, a, limit))]).collect()
        }
        Operation::Norm(operands) => {
            let operands: Vec<_> = operands.iter().collect();
            let without = |left_out: usize| {
                let rest = operands.iter().enumerate().filter(|&(at, _)| at != left_out).map(|(_, &operand)| operand);
                Operation::Norm(Operands::new(&rest.collect::<Vec<_>>()).expect("fewer operands"))
            };
            (0..operands.len()).map(|left_out| (LeftOut, without(left_out))).collect()
        }
        Operation::Polynomial(function, precision, a) => {
            let others = Function::ALL.into_iter().filter(|&other| other != function);
            others.map(|other| (OtherFunction, Operation::Polynomial(other, precision, a))).collect()
        }
        Operation::Atan2(y, x) => vec![(SwappedAtan2, Operation::Atan2(x, y))],
        Operation::Sin(angle) => vec![(CosineForSine, Operation::Cos(angle))],
        Operation::Cos(angle) => vec![(SineForCosine, Operation::Sin(angle))],
        _ => Vec::new(),
    }
}

/// The operand that an operation can be dropped for.
fn dropped(operation: Operation) -> Option<(Mutation, Value)> {
    match operation {
        Operation::Neg(a) => Some((Mutation::DroppedNegation, a)),
        Operation::Double(a) => Some((Mutation::DroppedDoubling, a)),
        Operation::Sqrt(a) => Some((Mutation::DroppedRoot, a)),
        _ => None,
    }
}

/// Whether there is nothing in the operation to change: an input, or the constant 0, which is its own negative.
fn is_fixed(operation: Operation) -> bool {
    matches!(operation, Operation::Input(_) | Operation::Constant(Rational::ZERO))
}

/// Every mutant of a program.
fn mutants(program: &Program) -> Vec<Mutant> {
    let mut mutants = Vec::new();
    for (at, &operation) in program.operations.iter().enumerate() {
        if is_fixed(operation) {
            continue;
        }
        let mut offer = |mutation, program| {
            mutants.push(Mutant { mutation, operation: name(operation), at, program });
        };
        offer(Mutation::NegatedResult, with_negated_result(program, at));
        for (mutation, replacement) in replacements(operation) {
            let mut mutant = program.clone();
            mutant.operations[at] = replacement;
            offer(mutation, mutant);
        }
        if let Some((mutation, operand)) = dropped(operation) {
            offer(mutation, with_redirected_uses(program, at, operand));
        }
    }
    mutants
}

/// The program with another value used wherever that of `at` was.
fn with_redirected_uses(program: &Program, at: Value, instead: Value) -> Program {
    let redirect = |value: Value| if value == at { instead } else { value };
    Program {
        operations: program.operations.iter().map(|operation| operation.map_operands(redirect)).collect(),
        outputs: program.outputs.iter().map(|&output| redirect(output)).collect(),
    }
}

/// The program with a negation between an operation and its uses.
fn with_negated_result(program: &Program, at: Value) -> Program {
    // The negation takes the place behind `at`, so what stood there and behind it moves on by one.
    let moved = |value: Value| if value >= at { value + 1 } else { value };
    let mut operations = Vec::with_capacity(program.operations.len() + 1);
    for (value, operation) in program.operations.iter().enumerate() {
        operations.push(operation.map_operands(moved));
        if value == at {
            operations.push(Operation::Neg(at));
        }
    }
    Program { operations, outputs: program.outputs.iter().map(|&output| moved(output)).collect() }
}

/// Inputs that satisfy the relations, in `f64`; those of exp with both signs, and down to where limits come in.
fn rows(definition: &Definition, kernel: &Kernel) -> Vec<Vec<f64>> {
    let mut random = Random(5);
    let mut rows = Vec::new();
    for _ in 0..40 {
        rows.push(samples::row(definition, kernel, &mut random).iter().map(|x| x.to_f64()).collect::<Vec<_>>());
    }
    if kernel.analytic == Some(Analytic::Exp) {
        let scaled = |factor: f64| rows.iter().map(move |row| row.iter().map(|x| x * factor).collect::<Vec<_>>());
        rows = [1.0, -1.0, 1e-3, 0.0].into_iter().flat_map(scaled).collect();
    }
    rows
}

/// Whether two programs give the same on every row, up to rounding.
fn same_function(original: &Program, mutant: &Program, rows: &[Vec<f64>]) -> bool {
    rows.iter().all(|row| {
        let Ok(expected) = original.evaluate(&FloatDomain, row);
        let Ok(found) = mutant.evaluate(&FloatDomain, row);
        // Coefficients are at most 9 and kernels of degree at most 4, so values are below 1e5 and rounding errors far
        // below this tolerance, while a sign is far above it.
        expected.iter().zip(&found).all(|(expected, found)| (expected - found).abs() <= 1e-9 * (1.0 + expected.abs()))
    })
}

#[derive(Default)]
struct Totals {
    programs: usize,
    mutants: usize,
    refuted: usize,
    equal: Vec<(String, &'static str, Mutation, Value)>,
}

impl fmt::Display for Totals {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (mutants, refuted, equal) = (self.mutants, self.refuted, self.equal.len());
        writeln!(
            f,
            "{} programs, {mutants} mutants, {refuted} refuted, {equal} equal to their originals:",
            self.programs
        )?;
        for (kernel, operation, mutation, at) in &self.equal {
            let reason = EQUAL.iter().find(|(_, k, o, m, _)| (*k, o, m) == (kernel, operation, mutation));
            let reason = reason.map_or("not on the list", |(.., reason)| reason);
            writeln!(f, "  {kernel}: {mutation:?} of the {operation} at {at}: {reason}")?;
        }
        Ok(())
    }
}

/// Mutates a program; `prepare` is the part before it, where it is the second part of a kernel.
fn mutate(definition: &Definition, compiled: &Compiled, prepare: &Program, totals: &mut Totals) {
    totals.programs += 1;
    let mut rows = rows(definition, &definition.kernels[compiled.kernel]);
    if compiled.part == Part::Apply {
        for row in &mut rows {
            let Ok(record) = prepare.evaluate(&FloatDomain, row);
            row.extend(record);
        }
    }
    for mutant in mutants(&compiled.program) {
        totals.mutants += 1;
        if let Err(refutation) = prove(&compiled.specification, &mutant.program) {
            let settled =
                !matches!(refutation, Refutation::Overflow | Refutation::OutputCount | Refutation::Imprecise(..));
            assert!(settled, "{}: given up, not refuted: {refutation}", compiled.name);
            totals.refuted += 1;
            continue;
        }
        let Mutant { mutation, operation, at, program } = mutant;
        assert!(
            same_function(&compiled.program, &program, &rows),
            "{}: the proof accepts {mutation:?} of the {operation} at {at}, and it computes something else",
            compiled.name
        );
        totals.equal.push((compiled.name.clone(), operation, mutation, at));
    }
}

fn definition(preset: &str) -> Definition {
    let text = ga_codegen::preset::text(preset).expect("a preset");
    ga_codegen::define(text.parse().expect("tokens")).expect("a preset without errors")
}

fn refute_mutants_of(preset: &str) {
    let definition = definition(preset);
    let compiled = ga_codegen::compile(&definition).expect("a preset that is proved");
    let mut totals = Totals::default();
    for (index, one) in compiled.iter().enumerate() {
        mutate(&definition, one, &compiled[index.saturating_sub(1)].program, &mut totals);
    }
    println!("{preset}: {totals}");
    assert!(totals.programs >= definition.kernels.len());
    assert_eq!(totals.refuted + totals.equal.len(), totals.mutants);
    let keys: BTreeSet<_> = totals.equal.iter().map(|(kernel, o, m, _)| (preset, kernel.as_str(), *o, *m)).collect();
    let listed: BTreeSet<_> = EQUAL.iter().map(|&(p, k, o, m, _)| (p, k, o, m)).filter(|key| key.0 == preset).collect();
    let unlisted: Vec<_> = keys.difference(&listed).collect();
    assert!(unlisted.is_empty(), "{preset}: equal mutants that are not on the list EQUAL: {unlisted:#?}");
    let unneeded: Vec<_> = listed.difference(&keys).collect();
    assert!(unneeded.is_empty(), "{preset}: entries of the list EQUAL that no mutant needs any more: {unneeded:#?}");
}

/// What can take the place of an operation on four lanes that is the `at`-th: other operands, lanes, inputs and signs, a sum for
/// a difference and the other way round.
fn packed_replacements(operation: PackedOperation, at: Value, inputs: usize) -> Vec<PackedOperation> {
    use PackedOperation::*;
    let mut replacements = Vec::new();
    for (place, operand) in operation.operands().enumerate() {
        for other in (0..at).filter(|&other| other != operand) {
            let first = std::cell::Cell::new(0);
            replacements.push(operation.map_operands(|operand| {
                let this = first.replace(first.get() + 1);
                if this == place { other } else { operand }
            }));
        }
    }
    for lane in 0..LANES {
        match operation {
            Load(sources) => {
                let of_input = |input| {
                    let mut sources = sources;
                    sources[lane] = Source::Input(input);
                    Load(sources)
                };
                replacements.extend((0..inputs).map(of_input).filter(|other| *other != operation));
            }
            Shuffle(a, lanes) => {
                let of_lane = |other| {
                    let mut lanes = lanes;
                    lanes[lane] = other;
                    Shuffle(a, lanes)
                };
                replacements.extend((0..LANES as u8).map(of_lane).filter(|other| *other != operation));
            }
            Negate(a, mut negated) => {
                negated[lane] = !negated[lane];
                replacements.push(Negate(a, negated));
            }
            _ => {}
        }
    }
    match operation {
        Add(a, b) => replacements.extend([Sub(a, b), Sub(b, a)]),
        Sub(a, b) => replacements.extend([Add(a, b), Sub(b, a)]),
        Double(a) => replacements.push(Negate(a, [false; LANES])),
        _ => {}
    }
    replacements
}

/// Every lane, operand, sign and output of a packed program matters: one changed is refuted, unless it leads to nothing that an
/// output needs, or to the very same scalar program.
#[test]
fn every_mutant_of_a_packed_program_is_refuted() {
    let (mut programs, mut refuted, mut same) = (0, 0, 0);
    for preset in ga_codegen::preset::NAMES {
        let definition = definition(preset);
        for compiled in ga_codegen::compile(&definition).expect("a preset that is proved") {
            let Some(packed) = &compiled.packed else { continue };
            let inputs = compiled.specification.coefficients.len();
            let mut mutants: Vec<PackedProgram> = Vec::new();
            for (at, &operation) in packed.operations.iter().enumerate() {
                for replacement in packed_replacements(operation, at, inputs) {
                    let mut mutant = packed.clone();
                    mutant.operations[at] = replacement;
                    mutants.push(mutant);
                }
            }
            for (field, &(value, lane)) in packed.outputs.iter().enumerate() {
                for other in (0..LANES as u8).filter(|&other| other != lane) {
                    let mut mutant = packed.clone();
                    mutant.outputs[field] = (value, other);
                    mutants.push(mutant);
                }
            }
            for mutant in mutants {
                let program = mutant.unpack();
                if prove(&compiled.specification, &program).is_err() {
                    refuted += 1;
                    continue;
                }
                assert_eq!(program, compiled.program, "{}: the proof accepts {mutant:?}", compiled.name);
                same += 1;
            }
            programs += 1;
        }
    }
    println!("{programs} packed programs, {refuted} mutants refuted, {same} the same programs");
    assert!(programs > 0 && refuted > 50 * same, "{refuted} refuted, {same} the same");
}

/// The programs of `relation_errors()` are no kernels, but emitted and proved like them: as identities, without any
/// relation to reduce by, so that here no mutant is equal at all.
#[test]
fn every_mutant_of_a_relation_is_refuted() {
    let (mut programs, mut refuted) = (0, 0);
    for preset in ga_codegen::preset::NAMES {
        for entity in &definition(preset).entities {
            let relations: Vec<_> = entity.relations().iter().map(|relation| relation.polynomial().clone()).collect();
            let inputs = entity.fields().count();
            let program = factor_polynomials(&relations, inputs).expect("a program for the relations");
            assert!(prove_evaluation(&program, &relations, inputs).is_ok(), "{preset} {}", entity.name);
            for Mutant { mutation, operation, at, program } in mutants(&program) {
                let proof = prove_evaluation(&program, &relations, inputs);
                assert!(proof.is_err(), "{preset} {}: {mutation:?} of the {operation} at {at}", entity.name);
                refuted += 1;
            }
            programs += usize::from(!relations.is_empty());
        }
    }
    println!("{programs} types with relations, {refuted} mutants, all refuted");
    assert!(programs > 0);
}

#[test]
fn every_mutant_in_space_is_refuted_or_listed_as_equal() {
    refute_mutants_of("pga3d");
}

#[test]
fn every_mutant_in_the_plane_is_refuted_or_listed_as_equal() {
    refute_mutants_of("pga2d");
}
