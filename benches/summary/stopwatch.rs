//! Times of contenders that take turns.

use std::time::{Duration, Instant};

use serde_json::{Value, json};

use super::support::Workload;

/// How long a contender runs at a time: long beside the clock's step, short beside the machine's moods.
const TURN: Duration = Duration::from_micros(500);
const ROUNDS: usize = 200;

/// A workload's times in nanoseconds per item; ours is the first.
pub(crate) struct Row {
    workload: &'static str,
    names: Vec<&'static str>,
    /// For each contender its time in each round.
    times: Vec<Vec<f64>>,
}

/// The middle of some numbers, and the range of their middle half.
fn quartiles(mut numbers: Vec<f64>) -> [f64; 3] {
    numbers.sort_by(f64::total_cmp);
    [1, 2, 3].map(|quarter| numbers[(numbers.len() - 1) * quarter / 4])
}

impl Row {
    /// Times the contenders of a workload.
    pub(crate) fn measure(workload: &Workload) -> Self {
        let mut contenders = workload.contenders();
        let calls: Vec<u32> = contenders.iter_mut().map(|contender| calls_in_a_turn(&mut contender.run)).collect();
        let mut times = vec![Vec::with_capacity(ROUNDS); contenders.len()];
        for round in 0..ROUNDS {
            // Each goes first as often as the others, so none always follows the same one.
            for turn in 0..contenders.len() {
                let contender = (round + turn) % contenders.len();
                let (run, calls) = (&mut contenders[contender].run, calls[contender]);
                let start = Instant::now();
                (0..calls).for_each(|_| run());
                let time = start.elapsed().as_secs_f64() * 1e9 / f64::from(calls) / workload.items as f64;
                times[contender].push(time);
            }
        }
        eprintln!("measured: {}", workload.name);
        Self { workload: workload.name, names: contenders.iter().map(|contender| contender.name).collect(), times }
    }

    /// How many times as long as ours a contender takes, in each round.
    fn ratios(&self, contender: usize) -> [f64; 3] {
        quartiles(self.times[contender].iter().zip(&self.times[0]).map(|(theirs, ours)| theirs / ours).collect())
    }

    pub(crate) fn print(&self) {
        let [_, ours, _] = quartiles(self.times[0].clone());
        for (contender, name) in self.names.iter().enumerate().skip(1) {
            let [_, theirs, _] = quartiles(self.times[contender].clone());
            let [low, median, high] = self.ratios(contender);
            let workload = if contender == 1 { format!("{}: {}", self.workload, self.names[0]) } else { String::new() };
            println!(
                "| {workload} | {ours:.2} ns | {name} | {theirs:.2} ns | **{median:.2}** ({low:.2} to {high:.2}) |"
            );
        }
    }

    pub(crate) fn json(&self) -> Value {
        let contenders = self.names.iter().enumerate().map(|(contender, name)| {
            let [_, time, _] = quartiles(self.times[contender].clone());
            json!({ "name": name, "nanoseconds": time, "ratio": self.ratios(contender) })
        });
        json!({ "workload": self.workload, "contenders": contenders.collect::<Vec<_>>() })
    }
}

/// How many calls fill a turn.
fn calls_in_a_turn(run: &mut dyn FnMut()) -> u32 {
    let mut calls = 1;
    loop {
        let start = Instant::now();
        (0..calls).for_each(|_| run());
        if start.elapsed() >= TURN || calls > 1 << 24 {
            return calls;
        }
        calls *= 2;
    }
}
