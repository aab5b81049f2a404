//! Greedy extraction of common sub-expressions from sums of products: kernels (sums that several rows contain, up to
//! a factor and a sign) and cubes (products that several terms contain), the most saving one first, until nothing saves.
//!
//! Kernels and co-kernels after Brayton and McMullen (1982); with signs, and applied to polynomials, after Hosangadi,
//! Fallah and Kastner (2006).

use super::cube::{Cube, Cubes};
use super::system::{Meaning, Row, System, sign_in};
use crate::symbolic::effort;
use std::cmp::Reverse;
use std::collections::HashSet;

/// A sum of cubes of which the first has no minus.
pub(super) type Divisor = Row;

/// A row divided by a cube: the cubes that are left, with their signs.
struct Quotient {
    row: usize,
    cokernel: Cube,
    rest: Row,
}

/// Where a divisor stands: row, factor, sign.
pub(super) type Occurrence = (usize, Cube, bool);

/// What can be made a row of its own.
pub(super) enum Extraction {
    Kernel(Divisor, Vec<Occurrence>),
    Common(Cube),
}

/// Multiplications and additions that an extraction saves.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Saving {
    pub(super) mul: i64,
    pub(super) add: i64,
}

impl Saving {
    pub(super) fn flops(self) -> i64 {
        self.mul + self.add
    }
}

/// Decides what is extracted next, of all that can be.
pub(super) trait Chooser {
    /// One more possibility; whether it may be chosen, so that its extraction is wanted.
    fn offer(&mut self, saving: Saving) -> bool;
    /// The position, among those wanted, of the one to take; forgets them all.
    fn choose(&mut self) -> Option<usize>;
}

/// Always the most saving one, the first of equals.
#[derive(Default)]
pub(super) struct Greedy {
    best: i64,
    wanted: usize,
}

impl Chooser for Greedy {
    fn offer(&mut self, saving: Saving) -> bool {
        let better = saving.flops() > self.best;
        if better {
            self.best = saving.flops();
            self.wanted += 1;
        }
        better
    }

    fn choose(&mut self) -> Option<usize> {
        self.best = 0;
        std::mem::take(&mut self.wanted).checked_sub(1)
    }
}

/// Extracts the most saving part first.
pub(super) fn greedy(system: System) -> System {
    extract(system, &mut Greedy::default())
}

/// Extracts, as the chooser decides, until nothing saves an operation.
pub(super) fn extract(mut system: System, chooser: &mut impl Chooser) -> System {
    loop {
        let mut wanted = candidates(&mut system, chooser);
        match chooser.choose().filter(|_| !effort::is_exhausted()) {
            Some(chosen) => apply(&mut system, wanted.swap_remove(chosen)),
            None => {
                system.normalise_signs();
                return system;
            }
        }
    }
}

fn candidates(system: &mut System, chooser: &mut impl Chooser) -> Vec<Extraction> {
    let quotients = quotients(system);
    let mut by_cube: Vec<Vec<usize>> = vec![Vec::new(); system.cubes.count()];
    for (index, quotient) in quotients.iter().enumerate() {
        for &(cube, _) in &quotient.rest {
            by_cube[cube as usize].push(index);
        }
    }
    let mut wanted = Vec::new();
    for divisor in divisors(&quotients, &by_cube) {
        let occurrences = occurrences(&divisor, &quotients, &by_cube, &mut system.cubes);
        let shared = occurrences.len() > 1 || occurrences.first().is_some_and(|place| place.1 != Cubes::ONE);
        if shared && chooser.offer(kernel_saving(&divisor, &occurrences, &system.cubes)) {
            wanted.push(Extraction::Kernel(divisor, occurrences));
        }
    }
    for (cube, count) in common_cubes(system) {
        let mul = (count as i64 - 1) * (system.cubes.degree(cube) as i64 - 1);
        if chooser.offer(Saving { mul, add: 0 }) {
            wanted.push(Extraction::Common(cube));
        }
    }
    wanted
}

/// Every row divided by every cube that divides at least two of its terms.
fn quotients(system: &mut System) -> Vec<Quotient> {
    let mut quotients = Vec::new();
    for (row, terms) in system.rows.iter().enumerate() {
        let mut parts: Vec<(Cube, Cube, bool)> = Vec::new();
        for &(cube, minus) in terms {
            if !effort::spend(system.cubes.split_count(cube)) {
                return quotients;
            }
            parts.extend(system.cubes.splits(cube).into_iter().map(|(part, rest)| (part, rest, minus)));
        }
        parts.sort_unstable();
        for group in parts.chunk_by(|a, b| a.0 == b.0).filter(|group| group.len() > 1) {
            let rest = group.iter().map(|&(_, rest, minus)| (rest, minus)).collect();
            quotients.push(Quotient { row, cokernel: group[0].0, rest });
        }
    }
    quotients
}

/// Whole quotients, and what two of them share up to sign; each once, in a fixed order.
fn divisors(quotients: &[Quotient], by_cube: &[Vec<usize>]) -> Vec<Divisor> {
    let (mut known, mut found) = (HashSet::new(), Vec::new());
    let mut add = |mut divisor: Divisor| {
        if divisor[0].1 {
            divisor.iter_mut().for_each(|(_, minus)| *minus = !*minus);
        }
        if known.insert(divisor.clone()) {
            found.push(divisor);
        }
    };
    let mut shared = vec![0u32; quotients.len()];
    let mut partners = Vec::new();
    for (index, quotient) in quotients.iter().enumerate() {
        if quotient.cokernel != Cubes::ONE {
            add(quotient.rest.clone());
        }
        for &(cube, _) in &quotient.rest {
            for &partner in by_cube[cube as usize].iter().rev().take_while(|&&partner| partner > index) {
                if !effort::spend(1) {
                    return found;
                }
                if shared[partner] == 0 {
                    partners.push(partner);
                }
                shared[partner] += 1;
            }
        }
        for partner in partners.drain(..) {
            if std::mem::take(&mut shared[partner]) > 1 {
                effort::spend(quotient.rest.len() + quotients[partner].rest.len());
                let (same, opposite) = intersection(&quotient.rest, &quotients[partner].rest);
                [same, opposite].into_iter().filter(|terms| terms.len() > 1).for_each(&mut add);
            }
        }
    }
    found
}

/// The cubes of `a` that `b` has too, with the same sign and with the opposite one.
fn intersection(a: &Row, b: &Row) -> (Row, Row) {
    let (mut same, mut opposite, mut position) = (Row::new(), Row::new(), 0);
    for &(cube, minus) in a {
        while position < b.len() && b[position].0 < cube {
            position += 1;
        }
        if position < b.len() && b[position].0 == cube {
            if b[position].1 == minus { same.push((cube, minus)) } else { opposite.push((cube, minus)) }
        }
    }
    (same, opposite)
}

/// The places where a divisor stands, no term used twice, those with the longest factor first.
fn occurrences(
    divisor: &Divisor,
    quotients: &[Quotient],
    by_cube: &[Vec<usize>],
    cubes: &mut Cubes,
) -> Vec<Occurrence> {
    let mut places: Vec<Occurrence> = Vec::new();
    for &index in &by_cube[divisor[0].0 as usize] {
        let quotient = &quotients[index];
        if !effort::spend(divisor.len()) {
            break;
        }
        if quotient.rest.len() >= divisor.len()
            && let Some(first) = sign_in(&quotient.rest, divisor[0].0)
            && divisor.iter().all(|&(cube, minus)| sign_in(&quotient.rest, cube) == Some(minus != first))
        {
            places.push((quotient.row, quotient.cokernel, first));
        }
    }
    places.sort_by_key(|&(row, cokernel, _)| (Reverse(cubes.degree(cokernel)), row));
    let mut used: Vec<(usize, Cube)> = Vec::new();
    places.retain(|&(row, cokernel, _)| {
        let before = used.len();
        for &(cube, _) in divisor {
            effort::spend(used.len());
            let term = (row, cubes.product(cokernel, cube));
            if used.contains(&term) {
                used.truncate(before);
                return false;
            }
            used.push(term);
        }
        true
    });
    places
}

fn kernel_saving(divisor: &Divisor, occurrences: &[Occurrence], cubes: &Cubes) -> Saving {
    let (terms, multiplications) = (divisor.len() as i64, |degree: usize| degree.saturating_sub(1) as i64);
    let own: i64 = divisor.iter().map(|&(cube, _)| multiplications(cubes.degree(cube))).sum();
    let saved = |&(_, cokernel, _): &Occurrence| {
        let degree = cubes.degree(cokernel);
        let before: i64 = divisor.iter().map(|&(cube, _)| multiplications(degree + cubes.degree(cube))).sum();
        before - degree as i64
    };
    let mul = occurrences.iter().map(saved).sum::<i64>() - own;
    Saving { mul, add: (occurrences.len() as i64 - 1) * (terms - 1) }
}

/// Products of at least two literals that stand at least twice, with how often.
fn common_cubes(system: &mut System) -> Vec<(Cube, usize)> {
    let terms: Vec<Cube> = system.rows.iter().flatten().map(|&(cube, _)| cube).collect();
    let mut parts: Vec<(Cube, Cube)> = Vec::new();
    for &term in &terms {
        if !effort::spend(system.cubes.split_count(term)) {
            break;
        }
        let splits = system.cubes.splits(term);
        parts.extend(splits.into_iter().map(|(part, _)| (part, term)));
    }
    parts.retain(|&(part, _)| system.cubes.degree(part) > 1);
    parts.sort_unstable();
    let mut counted = Vec::new();
    for group in parts.chunk_by(|a, b| a.0 == b.0) {
        let part = group[0].0;
        let count = group.iter().map(|&(_, term)| multiplicity(&mut system.cubes, term, part)).sum();
        if count > 1 {
            counted.push((part, count));
        }
    }
    counted
}

/// How often a cube divides another.
fn multiplicity(cubes: &mut Cubes, term: Cube, part: Cube) -> usize {
    let (mut count, mut rest) = (0, term);
    while let Some(smaller) = cubes.quotient(rest, part) {
        (count, rest) = (count + 1, smaller);
    }
    count
}

fn apply(system: &mut System, extraction: Extraction) {
    let new_row = system.rows.len();
    let literal = system.literal(Meaning::Row(new_row));
    let literal = system.cubes.cube(vec![literal]);
    match extraction {
        Extraction::Kernel(divisor, occurrences) => {
            for (row, cokernel, minus) in occurrences {
                let replaced: Vec<_> = divisor.iter().map(|&(cube, _)| system.cubes.product(cokernel, cube)).collect();
                system.rows[row].retain(|(cube, _)| !replaced.contains(cube));
                let product = system.cubes.product(cokernel, literal);
                system.rows[row].push((product, minus));
                system.rows[row].sort_unstable();
            }
            system.rows.push(divisor);
        }
        Extraction::Common(part) => {
            for row in &mut system.rows {
                for (cube, _) in row.iter_mut() {
                    while let Some(rest) = system.cubes.quotient(*cube, part) {
                        *cube = system.cubes.product(rest, literal);
                    }
                }
                row.sort_unstable();
            }
            system.rows.push(vec![(part, false)]);
        }
    }
}
