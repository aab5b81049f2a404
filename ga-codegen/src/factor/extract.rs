//! Greedy extraction of common sub-expressions from sums of products: kernels (sums that several rows contain, up to
//! a factor and a sign) and cubes (products that several terms contain), the most saving one first, until nothing saves.
//!
//! Kernels and co-kernels after Brayton and McMullen (1982); with signs, and applied to polynomials, after Hosangadi,
//! Fallah and Kastner (2006).

use super::system::{Cube, Literal, Meaning, Row, System};
use std::cmp::Reverse;
use std::collections::{BTreeMap, BTreeSet};

/// A sum of cubes of which the first has no minus.
type Divisor = Vec<(Cube, bool)>;

/// A row divided by a cube: the cubes that are left, with their signs.
struct Quotient {
    row: usize,
    cokernel: Cube,
    rest: Row,
}

/// Where a divisor stands: row, factor, sign.
type Occurrence = (usize, Cube, bool);

enum Extraction {
    Kernel(Divisor, Vec<Occurrence>),
    Common(Cube),
}

/// Extracts until nothing saves an operation.
pub(super) fn extract(mut system: System) -> System {
    while let Some(extraction) = best_extraction(&system) {
        apply(&mut system, extraction);
    }
    system
}

fn best_extraction(system: &System) -> Option<Extraction> {
    let quotients = quotients(system);
    let mut by_cube: BTreeMap<&Cube, Vec<usize>> = BTreeMap::new();
    for (index, quotient) in quotients.iter().enumerate() {
        for cube in quotient.rest.keys() {
            by_cube.entry(cube).or_default().push(index);
        }
    }
    let mut best: Option<(i64, Extraction)> = None;
    let mut offer = |saving: i64, extraction: Extraction| {
        if saving > best.as_ref().map_or(0, |(saving, _)| *saving) {
            best = Some((saving, extraction));
        }
    };
    for divisor in divisors(&quotients, &by_cube) {
        let occurrences = occurrences(&divisor, &quotients, &by_cube);
        if occurrences.len() > 1 || occurrences.first().is_some_and(|(_, cokernel, _)| !cokernel.is_empty()) {
            offer(kernel_saving(&divisor, &occurrences), Extraction::Kernel(divisor, occurrences));
        }
    }
    for (cube, count) in common_cubes(system) {
        offer((count as i64 - 1) * (cube.len() as i64 - 1), Extraction::Common(cube));
    }
    best.map(|(_, extraction)| extraction)
}

/// Every row divided by every cube that divides at least two of its terms.
fn quotients(system: &System) -> Vec<Quotient> {
    let mut quotients = Vec::new();
    for (row, terms) in system.rows.iter().enumerate() {
        let mut by_cokernel: BTreeMap<Cube, Row> = BTreeMap::new();
        for (cube, &minus) in terms {
            for (part, rest) in splits(cube) {
                by_cokernel.entry(part).or_default().insert(rest, minus);
            }
        }
        let shared = by_cokernel.into_iter().filter(|(_, rest)| rest.len() > 1);
        quotients.extend(shared.map(|(cokernel, rest)| Quotient { row, cokernel, rest }));
    }
    quotients
}

/// Every way to write a cube as a product of two, each once.
fn splits(cube: &Cube) -> BTreeSet<(Cube, Cube)> {
    (0..1u32 << cube.len().min(16))
        .map(|mask| {
            let (mut part, mut rest) = (Cube::new(), Cube::new());
            for (position, &literal) in cube.iter().enumerate() {
                if position < 16 && mask >> position & 1 == 1 { part.push(literal) } else { rest.push(literal) }
            }
            (part, rest)
        })
        .collect()
}

/// Whole quotients, and what two of them share up to sign.
fn divisors(quotients: &[Quotient], by_cube: &BTreeMap<&Cube, Vec<usize>>) -> BTreeSet<Divisor> {
    let mut found = BTreeSet::new();
    for quotient in quotients.iter().filter(|quotient| !quotient.cokernel.is_empty()) {
        found.insert(canonical(quotient.rest.iter().map(|(cube, &minus)| (cube.clone(), minus)).collect()));
    }
    let mut shared: BTreeMap<(usize, usize), u32> = BTreeMap::new();
    for indices in by_cube.values() {
        for (position, &a) in indices.iter().enumerate() {
            for &b in &indices[position + 1..] {
                *shared.entry((a, b)).or_default() += 1;
            }
        }
    }
    for (a, b) in shared.into_iter().filter(|&(_, count)| count > 1).map(|(pair, _)| pair) {
        let (mut same, mut opposite) = (Divisor::new(), Divisor::new());
        for (cube, &minus) in &quotients[a].rest {
            match quotients[b].rest.get(cube) {
                Some(&other) if other == minus => same.push((cube.clone(), minus)),
                Some(_) => opposite.push((cube.clone(), minus)),
                None => {}
            }
        }
        found.extend([same, opposite].into_iter().filter(|terms| terms.len() > 1).map(canonical));
    }
    found
}

fn canonical(mut divisor: Divisor) -> Divisor {
    if divisor[0].1 {
        divisor.iter_mut().for_each(|(_, minus)| *minus = !*minus);
    }
    divisor
}

/// The places where a divisor stands, no term used twice, those with the longest factor first.
fn occurrences(divisor: &Divisor, quotients: &[Quotient], by_cube: &BTreeMap<&Cube, Vec<usize>>) -> Vec<Occurrence> {
    let mut places: Vec<Occurrence> = Vec::new();
    for &index in by_cube.get(&divisor[0].0).into_iter().flatten() {
        let quotient = &quotients[index];
        let Some(&first) = quotient.rest.get(&divisor[0].0) else { continue };
        if divisor.iter().all(|(cube, minus)| quotient.rest.get(cube) == Some(&(*minus != first))) {
            places.push((quotient.row, quotient.cokernel.clone(), first));
        }
    }
    places.sort_by_key(|(row, cokernel, _)| (Reverse(cokernel.len()), *row));
    let mut used = BTreeSet::new();
    places.retain(|(row, cokernel, _)| {
        let terms: Vec<_> = divisor.iter().map(|(cube, _)| (*row, product(cokernel, cube))).collect();
        let free = terms.iter().all(|term| !used.contains(term));
        if free {
            used.extend(terms);
        }
        free
    });
    places
}

fn product(a: &Cube, b: &Cube) -> Cube {
    let mut product = [a.as_slice(), b.as_slice()].concat();
    product.sort_unstable();
    product
}

fn kernel_saving(divisor: &Divisor, occurrences: &[Occurrence]) -> i64 {
    let (terms, multiplications) = (divisor.len() as i64, |length: usize| length.saturating_sub(1) as i64);
    let own: i64 = divisor.iter().map(|(cube, _)| multiplications(cube.len())).sum::<i64>() + terms - 1;
    let saved = |(_, cokernel, _): &Occurrence| {
        let before: i64 = divisor.iter().map(|(cube, _)| multiplications(cokernel.len() + cube.len())).sum();
        before - cokernel.len() as i64 + terms - 1
    };
    occurrences.iter().map(saved).sum::<i64>() - own
}

/// Products of at least two literals that stand at least twice, with how often.
fn common_cubes(system: &System) -> Vec<(Cube, usize)> {
    let cubes: Vec<&Cube> = system.rows.iter().flat_map(BTreeMap::keys).collect();
    let parts = cubes.iter().flat_map(|cube| splits(cube)).map(|(part, _)| part).filter(|part| part.len() > 1);
    let mut distinct: BTreeMap<Cube, usize> = BTreeMap::new();
    for part in parts {
        *distinct.entry(part).or_default() += 1;
    }
    let repeats = |cube: &&Cube, part: &Cube| {
        let (mut count, mut rest) = (0, Some((*cube).clone()));
        while let Some(smaller) = rest.as_ref().and_then(|rest| quotient(rest, part)) {
            (count, rest) = (count + 1, Some(smaller));
        }
        count
    };
    let counted = distinct.into_keys().map(|part| {
        let count = cubes.iter().map(|cube| repeats(cube, &part)).sum();
        (part, count)
    });
    counted.filter(|&(_, count)| count > 1).collect()
}

fn quotient(cube: &[Literal], divisor: &[Literal]) -> Option<Cube> {
    let (mut rest, mut wanted) = (Cube::new(), divisor.iter().peekable());
    for literal in cube {
        if wanted.peek() == Some(&literal) {
            wanted.next();
        } else {
            rest.push(*literal);
        }
    }
    wanted.peek().is_none().then_some(rest)
}

fn apply(system: &mut System, extraction: Extraction) {
    let new_row = system.rows.len();
    let literal = system.literal(Meaning::Row(new_row));
    match extraction {
        Extraction::Kernel(divisor, occurrences) => {
            for (row, cokernel, minus) in occurrences {
                for (cube, _) in &divisor {
                    system.rows[row].remove(&product(&cokernel, cube));
                }
                system.rows[row].insert(product(&cokernel, &vec![literal]), minus);
            }
            system.rows.push(divisor.into_iter().collect());
        }
        Extraction::Common(part) => {
            for row in &mut system.rows {
                *row = std::mem::take(row)
                    .into_iter()
                    .map(|(cube, minus)| (replaced(cube, &part, literal), minus))
                    .collect();
            }
            system.rows.push(Row::from([(part, false)]));
        }
    }
}

fn replaced(mut cube: Cube, part: &[Literal], literal: Literal) -> Cube {
    while let Some(rest) = quotient(&cube, part) {
        cube = product(&rest, &vec![literal]);
    }
    cube
}
