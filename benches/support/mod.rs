//! The workloads: how ours does it, and how other crates do. The summary and the criterion benches run the very same ones.
//!
//! A contender comes with its results, and before anything is timed they are compared with ours, number by number. One that does
//! something near ours comes with the results that should agree, which are then the first of ours: see [`interpolation`].

mod compose;
mod crowds;
mod elements;
mod exponentials;
mod interpolation;
mod kinematics;
mod motion;
mod points;
mod sampling;

use std::hint::black_box;

/// What is timed side by side; ours is the first.
#[derive(Clone, Copy)]
pub(crate) struct Workload {
    pub(crate) name: &'static str,
    /// How many items one call works on.
    pub(crate) items: usize,
    /// How far a number may be from ours, relative to 1 and its size.
    tolerance: f64,
    contenders: fn() -> Vec<Contender>,
}

/// One way of doing the work.
pub(crate) struct Contender {
    pub(crate) name: &'static str,
    pub(crate) run: Box<dyn FnMut()>,
    /// What it comes to, or the first part of that.
    results: Vec<f64>,
}

/// All of them, in the order of the table.
pub(crate) fn all() -> impl Iterator<Item = Workload> {
    [
        compose::WORKLOADS,
        points::WORKLOADS,
        elements::WORKLOADS,
        exponentials::WORKLOADS,
        interpolation::WORKLOADS,
        kinematics::WORKLOADS,
        sampling::WORKLOADS,
        crowds::WORKLOADS,
    ]
    .into_iter()
    .flatten()
    .copied()
}

impl Workload {
    /// The contenders, after a comparison of what they come to.
    pub(crate) fn contenders(&self) -> Vec<Contender> {
        let contenders = (self.contenders)();
        let ours = &contenders[0].results;
        for Contender { name, results, .. } in &contenders {
            assert!(results.len() <= ours.len(), "{}: {name} has more results than ours", self.name);
            for (index, (ours, theirs)) in ours.iter().zip(results).enumerate() {
                let near = (ours - theirs).abs() <= self.tolerance * (1.0 + ours.abs());
                assert!(near, "{}: {name} disagrees in number {index}: ours is {ours}, theirs {theirs}", self.name);
            }
        }
        contenders
    }
}

impl Contender {
    /// What `run` writes into `out`, and what of that is compared.
    fn new<O: 'static>(
        name: &'static str,
        mut out: O,
        mut run: impl FnMut(&mut O) + 'static,
        results: impl FnOnce(&O) -> Vec<f64>,
    ) -> Self {
        run(&mut out);
        Self { name, results: results(&out), run: Box::new(move || run(black_box(&mut out))) }
    }
}

/// A function of a list, item by item.
fn each<A: Copy + 'static, R: 'static>(
    name: &'static str,
    items: Vec<A>,
    function: impl Fn(A) -> R + Copy + 'static,
    results: impl FnOnce(&Vec<R>) -> Vec<f64>,
) -> Contender {
    let out: Vec<R> = items.iter().map(|item| function(*item)).collect();
    let run = move |out: &mut Vec<R>| {
        let function = black_box(function);
        for (out, item) in out.iter_mut().zip(black_box(&items)) {
            *out = function(*item);
        }
    };
    Contender::new(name, out, run, results)
}

/// A function of two lists, item by item.
fn pairs<A: Copy + 'static, B: Copy + 'static, R: 'static>(
    name: &'static str,
    a: Vec<A>,
    b: Vec<B>,
    function: impl Fn(A, B) -> R + Copy + 'static,
    results: impl FnOnce(&Vec<R>) -> Vec<f64>,
) -> Contender {
    let out: Vec<R> = a.iter().zip(&b).map(|(a, b)| function(*a, *b)).collect();
    let run = move |out: &mut Vec<R>| {
        let function = black_box(function);
        for ((out, a), b) in out.iter_mut().zip(black_box(&a)).zip(black_box(&b)) {
            *out = function(*a, *b);
        }
    };
    Contender::new(name, out, run, results)
}

/// How long the lists are, where a workload does not say otherwise.
const COUNT: usize = 1024;

fn list<T>(item: impl Fn(usize) -> T) -> Vec<T> {
    (0..COUNT).map(item).collect()
}

/// Rounding of a few dozen operations on numbers some times as large as the result.
const SINGLE: f64 = 400.0 / (1_u32 << 24) as f64;
const DOUBLE: f64 = 400.0 / (1_u64 << 53) as f64;
