//! Looking for the cheapest program: many restarts of the extraction from many starting points, each step chosen at
//! random in favour of what saves most.

use super::extract::{Chooser, Saving, extract, greedy};
use super::starting;
use super::system::System;
use crate::kernel::Specification;
use crate::program::{CostModel, Count, Program};
use crate::symbolic::Overflow;

/// A search for the cheapest program of one polynomial kernel. Restart number n does the same on every run.
pub struct Search {
    starts: Vec<System>,
    model: CostModel,
    seed: u64,
    best: Option<Program>,
}

const TEMPERATURES: [f64; 4] = [0.3, 0.7, 1.5, 3.0];
const ADDITION_WEIGHTS: [f64; 4] = [1.0, 1.0, 0.5, 1.5];

impl Search {
    /// A search that has seen every starting point once, without chance.
    ///
    /// # Errors
    /// [`Overflow`]
    pub fn new(specification: &Specification, model: CostModel, name: &str) -> Result<Self, Overflow> {
        let starts = starting::all(specification)?;
        let mut search = Self { starts, model, seed: hash(name), best: None };
        for index in 0..search.starts.len() {
            search.offer(&greedy(search.starts[index].clone()));
        }
        Ok(search)
    }

    /// How many starting points there are.
    pub fn starting_points(&self) -> usize {
        self.starts.len()
    }

    /// One restart; whether it found something cheaper.
    pub fn restart(&mut self, number: u64) -> bool {
        let mut random = Random(self.seed.wrapping_add(number.wrapping_mul(0x9e37_79b9_7f4a_7c15)));
        let start = &self.starts[random.below(self.starts.len())];
        let mut chooser = SoftMax {
            temperature: TEMPERATURES[random.below(TEMPERATURES.len())],
            addition_weight: ADDITION_WEIGHTS[random.below(ADDITION_WEIGHTS.len())],
            random,
            savings: Vec::new(),
        };
        let system = extract(start.clone(), &mut chooser);
        self.offer(&system)
    }

    /// The cheapest program so far.
    pub fn best(&self) -> Option<&Program> {
        self.best.as_ref()
    }

    /// Takes a program that is known already as the one to beat.
    pub fn know(&mut self, program: Program) {
        self.take(program);
    }

    fn offer(&mut self, system: &System) -> bool {
        self.take(system.program(self.model))
    }

    fn take(&mut self, program: Program) -> bool {
        let cost = |program: &Program| self.model.cost(Count::of(program));
        let better = self.best.as_ref().is_none_or(|best| cost(&program) < cost(best));
        if better {
            self.best = Some(program);
        }
        better
    }
}

/// FNV-1a.
fn hash(text: &str) -> u64 {
    text.bytes().fold(0xcbf2_9ce4_8422_2325, |hash, byte| (hash ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3))
}

/// SplitMix64 (Steele, Lea, Flood 2014).
struct Random(u64);

impl Random {
    fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mixed = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let mixed = (mixed ^ (mixed >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        mixed ^ (mixed >> 31)
    }

    fn below(&mut self, bound: usize) -> usize {
        (self.next() % bound as u64) as usize
    }

    fn unit(&mut self) -> f64 {
        (self.next() >> 11) as f64 / (1u64 << 53) as f64
    }
}

/// Chooses with probability proportional to exp(saving / temperature).
struct SoftMax {
    temperature: f64,
    addition_weight: f64,
    random: Random,
    savings: Vec<f64>,
}

impl Chooser for SoftMax {
    fn offer(&mut self, saving: Saving) -> bool {
        let value = saving.mul as f64 + self.addition_weight * saving.add as f64;
        let wanted = value > 0.0 && saving.flops() > 0;
        if wanted {
            self.savings.push(value);
        }
        wanted
    }

    fn choose(&mut self) -> Option<usize> {
        let savings = std::mem::take(&mut self.savings);
        let most = savings.iter().copied().fold(f64::NEG_INFINITY, f64::max);
        let weights: Vec<_> = savings.iter().map(|saving| ((saving - most) / self.temperature).exp()).collect();
        let mut rest = self.random.unit() * weights.iter().sum::<f64>();
        for (position, weight) in weights.iter().enumerate() {
            rest -= weight;
            if rest < 0.0 {
                return Some(position);
            }
        }
        weights.len().checked_sub(1)
    }
}
