//! Packs products: which lanes of its factors the sums of a product are made of, so that few shuffles and sign changes
//! are needed.
//!
//! The coefficients of both factors and of the result are taken in groups of four, as they stand in their types. What a group
//! of each factor adds to a group of the result is a *block*: for each of the four rows the same number of signed products.
//! Written below each other, one product of each row makes a column, a product of lanes; the rows' products can be put
//! into columns in any order, and a column is computed as `a[..] * b[..]`. Columns whose signs differ alike from row to row
//! are added up first and negated at once. But those of the first group of the result are added up one after the other, as its
//! first row stands in the definition: so the scalar part of a product, whose sign decides which way is short, is rounded as by
//! the scalar kernel.
//!
//! All orders of each block are known. Every order of the first block is tried, the others are chosen one after the other,
//! each the cheapest beside those before, and then over again, beside all others, while that helps.

use crate::kernel::Specification;
use crate::program::{LANES, PackedOperation, PackedProgram, Source, Value};
use crate::symbolic::{Polynomial, Rational};
use std::collections::{BTreeMap, HashMap, HashSet};

/// Patterns of lanes: bit p for the pattern whose lanes are p in base 4.
type Patterns = [u64; 4];

/// At most how many products a row of a block has: there are 24^3 orders of four rows of four.
const MOST_COLUMNS: usize = 4;

/// The product of a lane of each factor.
#[derive(Clone, Copy, Debug)]
struct Term {
    lanes: [usize; 2],
    minus: bool,
}

/// What a group of each factor adds to a group of the result.
#[derive(Clone, Debug)]
struct Block {
    output: usize,
    groups: [usize; 2],
    rows: [Vec<Term>; LANES],
}

/// An order of the products of a block.
#[derive(Clone, Debug)]
struct Arrangement {
    /// The shuffles that it needs of each factor's group.
    shuffles: [Patterns; 2],
    /// The ways in which signs differ from row to row, bit p for the pattern p.
    signs: u8,
    /// For each column the term of each row.
    columns: Vec<[usize; LANES]>,
}

/// A packed program for a product; `None` where the definition is not one of two parameters, or not made of groups of four.
pub(super) fn arrange(specification: &Specification) -> Option<PackedProgram> {
    let blocks = blocks(specification)?;
    let arrangements: Vec<Vec<Arrangement>> = blocks.iter().map(arrangements).collect();
    let chosen = choose(&blocks, &arrangements)?;
    Some(program(specification, &blocks, &chosen))
}

/// The coefficients of a parameter in groups of four.
fn groups(specification: &Specification, parameter: usize) -> Vec<Vec<usize>> {
    let own =
        specification.coefficients.iter().enumerate().filter(|(_, coefficient)| coefficient.parameter == parameter);
    own.map(|(index, _)| index).collect::<Vec<_>>().chunks(LANES).map(<[usize]>::to_vec).collect()
}

/// The blocks by group of the result, then by those of the factors.
fn blocks(specification: &Specification) -> Option<Vec<Block>> {
    let mut blocks = Vec::new();
    let is_product = specification.coefficients.iter().all(|coefficient| coefficient.parameter < 2);
    if !is_product || specification.analytic.is_some() || !specification.outputs.len().is_multiple_of(LANES) {
        return None;
    }
    for (output, polynomials) in specification.outputs.chunks(LANES).enumerate() {
        let mut of_output: BTreeMap<[usize; 2], [Vec<Term>; LANES]> = BTreeMap::new();
        for (row, polynomial) in polynomials.iter().enumerate() {
            for (groups, term) in terms(specification, polynomial)? {
                of_output.entry(groups).or_default()[row].push(term);
            }
        }
        for (groups, rows) in of_output {
            let columns = rows[0].len();
            if columns > MOST_COLUMNS || rows.iter().any(|row| row.len() != columns) {
                return None;
            }
            blocks.push(Block { output, groups, rows });
        }
    }
    Some(blocks)
}

/// The terms of a row and the groups that they belong to; `None` where one is no product of the two parameters.
fn terms(specification: &Specification, polynomial: &Polynomial) -> Option<Vec<([usize; 2], Term)>> {
    let place = |symbol: usize| {
        let parameter = specification.coefficients[symbol].parameter;
        let first = specification.coefficients.iter().position(|coefficient| coefficient.parameter == parameter)?;
        Some((parameter, (symbol - first) / LANES, (symbol - first) % LANES))
    };
    let term = |(monomial, coefficient): (&crate::symbolic::Monomial, Rational)| {
        let [a, b] = *monomial.symbols() else { return None };
        let ((of_a, group_a, lane_a), (of_b, group_b, lane_b)) = (place(usize::from(a))?, place(usize::from(b))?);
        let suits = (of_a, of_b) == (0, 1) && coefficient.abs() == Rational::ONE;
        let term = Term { lanes: [lane_a, lane_b], minus: coefficient.is_negative() };
        suits.then_some(([group_a, group_b], term))
    };
    polynomial.terms().map(term).collect()
}

/// All orders of so many things.
fn permutations(count: usize) -> Vec<Vec<usize>> {
    if count == 0 {
        return vec![Vec::new()];
    }
    let longer = |shorter: Vec<usize>| {
        (0..count).map(move |place| {
            let mut longer = shorter.clone();
            longer.insert(place, count - 1);
            longer
        })
    };
    permutations(count - 1).into_iter().flat_map(longer).collect()
}

fn with(mut patterns: Patterns, lanes: [usize; LANES]) -> Patterns {
    // Unchanged lanes are no shuffle.
    if lanes != [0, 1, 2, 3] {
        let index = lanes.iter().fold(0, |index, lane| index * LANES + lane);
        patterns[index / 64] |= 1 << (index % 64);
    }
    patterns
}

fn union(a: Patterns, b: Patterns) -> Patterns {
    std::array::from_fn(|word| a[word] | b[word])
}

/// How many patterns are in `a` and not in `b`.
fn added(a: Patterns, b: Patterns) -> u32 {
    a.iter().zip(b).map(|(a, b)| (a & !b).count_ones()).sum()
}

/// In which rows the sign is not that of the last one.
fn sign_pattern(terms: [Term; LANES]) -> usize {
    (0..LANES).map(|row| usize::from(terms[row].minus != terms[LANES - 1].minus) << row).sum()
}

impl Block {
    fn column(&self, terms: [usize; LANES]) -> [Term; LANES] {
        std::array::from_fn(|row| self.rows[row][terms[row]])
    }
}

/// Every order of a block, of those with the same needs the first.
fn arrangements(block: &Block) -> Vec<Arrangement> {
    let orders = permutations(block.rows[0].len());
    let mut found = Vec::new();
    let mut known: HashSet<([Patterns; 2], u8)> = HashSet::new();
    for second in &orders {
        for third in &orders {
            for last in &orders {
                let columns: Vec<_> =
                    (0..second.len()).map(|column| [column, second[column], third[column], last[column]]).collect();
                let (mut shuffles, mut signs) = ([Patterns::default(); 2], 0);
                for &column in &columns {
                    let terms = block.column(column);
                    for (factor, shuffles) in shuffles.iter_mut().enumerate() {
                        *shuffles = with(*shuffles, terms.map(|term| term.lanes[factor]));
                    }
                    signs |= 1 << sign_pattern(terms);
                }
                // Where signs do not differ nothing is negated.
                signs &= !1;
                if known.insert((shuffles, signs)) {
                    found.push(Arrangement { shuffles, signs, columns });
                }
            }
        }
    }
    found
}

/// What the chosen arrangements need together.
#[derive(Clone, Debug, Default)]
struct Needs {
    shuffles: BTreeMap<(usize, usize), Patterns>,
    signs: BTreeMap<usize, u8>,
}

impl Needs {
    fn of(&self, block: &Block) -> ([Patterns; 2], u8) {
        let shuffles =
            [0, 1].map(|factor| self.shuffles.get(&(factor, block.groups[factor])).copied().unwrap_or_default());
        (shuffles, self.signs.get(&block.output).copied().unwrap_or_default())
    }

    fn add(&mut self, block: &Block, arrangement: &Arrangement) {
        for factor in [0, 1] {
            let patterns = self.shuffles.entry((factor, block.groups[factor])).or_default();
            *patterns = union(*patterns, arrangement.shuffles[factor]);
        }
        *self.signs.entry(block.output).or_default() |= arrangement.signs;
    }

    fn cost(&self) -> u32 {
        let shuffles: u32 = self.shuffles.values().map(|patterns| added(*patterns, Patterns::default())).sum();
        shuffles + self.signs.values().map(|signs| signs.count_ones()).sum::<u32>()
    }
}

/// The arrangement that adds least to what there is, the first of several.
fn cheapest(arrangements: &[Arrangement], ([a, b], signs): ([Patterns; 2], u8)) -> Option<usize> {
    let cost = |arrangement: &Arrangement| {
        let [own_a, own_b] = arrangement.shuffles;
        added(own_a, a) + added(own_b, b) + (arrangement.signs & !signs).count_ones()
    };
    (0..arrangements.len()).min_by_key(|&index| cost(&arrangements[index]))
}

/// An arrangement of each block, few shuffles and negations in all.
fn choose<'a>(blocks: &[Block], arrangements: &'a [Vec<Arrangement>]) -> Option<Vec<&'a Arrangement>> {
    let mut known: HashMap<(usize, [Patterns; 2], u8), usize> = HashMap::new();
    let mut best: Option<(u32, Vec<usize>)> = None;
    for first in 0..arrangements.first()?.len() {
        let mut needs = Needs::default();
        let mut chosen = Vec::new();
        for (index, block) in blocks.iter().enumerate() {
            let (shuffles, signs) = needs.of(block);
            let choice = match (index, known.get(&(index, shuffles, signs))) {
                (0, _) => first,
                (_, Some(&choice)) => choice,
                (_, None) => cheapest(&arrangements[index], (shuffles, signs))?,
            };
            known.insert((index, shuffles, signs), choice);
            needs.add(block, &arrangements[index][choice]);
            chosen.push(choice);
        }
        if best.as_ref().is_none_or(|(cost, _)| needs.cost() < *cost) {
            best = Some((needs.cost(), chosen));
        }
    }
    let (mut cost, mut chosen) = best?;
    loop {
        for index in 0..blocks.len() {
            let mut needs = Needs::default();
            for other in (0..blocks.len()).filter(|&other| other != index) {
                needs.add(&blocks[other], &arrangements[other][chosen[other]]);
            }
            chosen[index] = cheapest(&arrangements[index], needs.of(&blocks[index]))?;
        }
        let mut needs = Needs::default();
        for (index, block) in blocks.iter().enumerate() {
            needs.add(block, &arrangements[index][chosen[index]]);
        }
        if needs.cost() >= cost {
            break;
        }
        cost = needs.cost();
    }
    Some(chosen.iter().zip(arrangements).map(|(&choice, arrangements)| &arrangements[choice]).collect())
}

/// Operations, each once.
#[derive(Default)]
struct Builder {
    operations: Vec<PackedOperation>,
}

impl Builder {
    fn push(&mut self, operation: PackedOperation) -> Value {
        let known = self.operations.iter().position(|known| *known == operation);
        known.unwrap_or_else(|| {
            self.operations.push(operation);
            self.operations.len() - 1
        })
    }

    fn shuffle(&mut self, value: Value, lanes: [usize; LANES]) -> Value {
        if lanes == [0, 1, 2, 3] {
            value
        } else {
            self.push(PackedOperation::Shuffle(value, lanes.map(|lane| lane as u8)))
        }
    }

    /// A sum of signed values, one after the other, up to its sign; whether it is the negative.
    fn running_sum(&mut self, terms: Vec<(bool, Value)>) -> Option<(bool, Value)> {
        terms.into_iter().reduce(|total, term| self.sum(vec![total, term]).unwrap_or(total))
    }

    /// A sum of signed values, pair by pair, up to its sign; whether it is the negative.
    fn sum(&mut self, mut terms: Vec<(bool, Value)>) -> Option<(bool, Value)> {
        while terms.len() > 1 {
            let pair = |pair: &[(bool, Value)]| match *pair {
                [(minus, a), (other, b)] if minus == other => (minus, self.push(PackedOperation::Add(a, b))),
                [(false, a), (_, b)] | [(_, b), (_, a)] => (false, self.push(PackedOperation::Sub(a, b))),
                _ => pair[0],
            };
            terms = terms.chunks(2).map(pair).collect();
        }
        terms.first().copied()
    }
}

fn program(specification: &Specification, blocks: &[Block], chosen: &[&Arrangement]) -> PackedProgram {
    let mut builder = Builder::default();
    let loads: Vec<Vec<Value>> = [0, 1]
        .map(|parameter| {
            let groups = groups(specification, parameter).into_iter();
            // A group with fewer repeats its last one.
            let load = |group: Vec<usize>| std::array::from_fn(|lane| Source::Input(group[lane.min(group.len() - 1)]));
            groups.map(|group| builder.push(PackedOperation::Load(load(group)))).collect()
        })
        .into();
    let mut outputs = Vec::new();
    for output in 0..specification.outputs.len() / LANES {
        // The columns of all blocks by their pattern of signs.
        let mut columns: BTreeMap<(usize, usize), Vec<(bool, Value)>> = BTreeMap::new();
        let mut place = 0;
        for (block, arrangement) in blocks.iter().zip(chosen).filter(|(block, _)| block.output == output) {
            for &column in &arrangement.columns {
                let terms = block.column(column);
                let [a, b] = [0, 1].map(|factor| {
                    builder.shuffle(loads[factor][block.groups[factor]], terms.map(|term| term.lanes[factor]))
                });
                let product = builder.push(PackedOperation::Mul(a, b));
                place += usize::from(output == 0);
                columns.entry((place, sign_pattern(terms))).or_default().push((terms[LANES - 1].minus, product));
            }
        }
        let mut sums = Vec::new();
        for ((_, pattern), terms) in columns {
            let Some((minus, sum)) = builder.sum(terms) else { continue };
            let negated = std::array::from_fn(|row| ((pattern >> row) & 1 == 1) != minus);
            sums.push(match pattern {
                0 => (minus, sum),
                _ => (false, builder.push(PackedOperation::Negate(sum, negated))),
            });
        }
        let sum = if output == 0 { builder.running_sum(sums) } else { builder.sum(sums) };
        let Some((minus, mut total)) = sum else { continue };
        if minus {
            total = builder.push(PackedOperation::Negate(total, [true; LANES]));
        }
        outputs.extend((0..LANES as u8).map(|lane| (total, lane)));
    }
    PackedProgram { operations: builder.operations, outputs }.pruned()
}
