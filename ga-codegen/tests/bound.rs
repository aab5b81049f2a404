//! The rounding-error bounds of every polynomial program of the presets: never exceeded, and not far from what happens.
//!
//! Programs run in f32. A search for bad inputs compares them with f64; what it finds, and every input it starts from, is
//! judged with exact rationals. `cargo test -p ga-codegen --test bound -- --nocapture` prints the worst ratio of error and
//! bound for every program and part of its output.

use ga_codegen::program::{Bound, Group, GroupBound, Norm, Operation, Program};
use ga_codegen::symbolic::{Polynomial, Rational};
use ga_codegen::{Compiled, compile, define, preset};
use num_rational::BigRational;
use num_traits::{ToPrimitive, Zero};

const UNIT_ROUNDOFF: f64 = 1.0 / 16_777_216.0;

/// Numbers in which a program can run.
trait Number: Clone {
    fn of(value: f32) -> Self;
    fn ratio(value: Rational) -> Self;
    fn add(&self, other: &Self) -> Self;
    fn sub(&self, other: &Self) -> Self;
    fn mul(&self, other: &Self) -> Self;
    fn neg(&self) -> Self;
}

macro_rules! float {
    ($float:ty) => {
        impl Number for $float {
            fn of(value: f32) -> Self {
                Self::from(value)
            }
            fn ratio(value: Rational) -> Self {
                value.numerator() as Self / value.denominator() as Self
            }
            fn add(&self, other: &Self) -> Self {
                self + other
            }
            fn sub(&self, other: &Self) -> Self {
                self - other
            }
            fn mul(&self, other: &Self) -> Self {
                self * other
            }
            fn neg(&self) -> Self {
                -self
            }
        }
    };
}

float!(f32);
float!(f64);

impl Number for BigRational {
    fn of(value: f32) -> Self {
        Self::from_float(value).expect("finite")
    }
    fn ratio(value: Rational) -> Self {
        Self::new(value.numerator().into(), value.denominator().into())
    }
    fn add(&self, other: &Self) -> Self {
        self + other
    }
    fn sub(&self, other: &Self) -> Self {
        self - other
    }
    fn mul(&self, other: &Self) -> Self {
        self * other
    }
    fn neg(&self) -> Self {
        -self
    }
}

/// Every value of a polynomial program.
fn run<N: Number>(program: &Program, inputs: &[f32]) -> Vec<N> {
    let mut values: Vec<N> = Vec::with_capacity(program.operations.len());
    for operation in &program.operations {
        values.push(match *operation {
            Operation::Input(index) => N::of(inputs[index]),
            Operation::Constant(number) => N::ratio(number),
            Operation::Add(a, b) => values[a].add(&values[b]),
            Operation::Sub(a, b) => values[a].sub(&values[b]),
            Operation::Mul(a, b) => values[a].mul(&values[b]),
            Operation::Neg(a) => values[a].neg(),
            Operation::Double(a) => values[a].add(&values[a]),
            _ => panic!("expected a polynomial program, found {operation:?}"),
        });
    }
    values
}

/// A deterministic source of randomness: SplitMix64.
struct Random(u64);

impl Random {
    fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    fn below(&mut self, bound: usize) -> usize {
        (self.next() % bound as u64) as usize
    }

    /// In [-1, 1).
    fn unit(&mut self) -> f64 {
        (self.next() >> 11) as f64 / (1u64 << 52) as f64 - 1.0
    }
}

/// A program and where its inputs belong.
struct Subject<'a> {
    program: &'a Program,
    bound: &'a Bound,
    /// The group of every output.
    outputs: Vec<Group>,
    /// The group of every input.
    inputs: Vec<Norm>,
    /// What holds between the inputs.
    relations: &'a [Polynomial],
}

impl<'a> Subject<'a> {
    fn new(compiled: &'a Compiled) -> Option<Self> {
        let specification = &compiled.specification;
        let inputs = specification.coefficients.iter();
        let norm =
            |c: &ga_codegen::kernel::Coefficient| Norm { parameter: c.parameter, group: Group::of_degree(c.degree) };
        Some(Self {
            program: &compiled.program,
            bound: compiled.bound.as_ref()?,
            outputs: specification.output_degrees().into_iter().map(Group::of_degree).collect(),
            inputs: inputs.map(norm).collect(),
            relations: &specification.stated,
        })
    }

    /// The error of one group over its bound; 0 where something underflows or overflows.
    fn ratio<N: Number>(&self, group: &GroupBound, inputs: &[f32], float: impl Fn(&N) -> f64) -> f64 {
        let computed = run::<f32>(self.program, inputs);
        if computed.iter().any(|value| !(value.is_normal() || *value == 0.0)) {
            return 0.0;
        }
        let exact = run::<N>(self.program, inputs);
        let underflows = |(value, exact): (&f32, &N)| *value == 0.0 && float(exact) != 0.0;
        if computed.iter().zip(&exact).any(underflows) {
            return 0.0;
        }
        let of_group = self.program.outputs.iter().zip(&self.outputs).filter(|(_, other)| **other == group.group);
        let error: f64 = of_group.map(|(&output, _)| float(&exact[output].sub(&N::of(computed[output]))).powi(2)).sum();
        let norm = |norm: Norm| {
            let squares = inputs.iter().zip(&self.inputs).filter(|(_, of)| **of == norm);
            squares.map(|(&input, _)| f64::from(input).powi(2)).sum::<f64>().sqrt()
        };
        let unit = UNIT_ROUNDOFF / (1.0 - f64::from(self.bound.roundings) * UNIT_ROUNDOFF);
        let bound = unit * group.sum(norm);
        if error == 0.0 { 0.0 } else { error.sqrt() / bound }
    }

    fn exact_ratio(&self, group: &GroupBound, inputs: &[f32]) -> f64 {
        self.ratio::<BigRational>(group, inputs, |number| {
            if number.is_zero() { 0.0 } else { number.to_f64().expect("a rational has a nearest f64") }
        })
    }

    /// Inputs of one of several kinds: of one size, spread over magnitudes, with huge or tiny ideal parts, on the relations of
    /// their types, of few digits, near one another, with zeros.
    fn start(&self, random: &mut Random) -> Vec<f32> {
        let kind = random.below(6);
        let ideal = [1.0, 1e4, 1e-4][random.below(3)];
        let mut inputs: Vec<f64> = (0..self.inputs.len())
            .map(|index| {
                let scale = if self.inputs[index].group == Group::Ideal { ideal } else { 1.0 };
                let value = random.unit() * scale;
                match kind {
                    0 => value * 2f64.powi(random.below(17) as i32 - 8),
                    1 if random.below(3) == 0 => 0.0,
                    2 => (value * 8.0).round() / 8.0,
                    3 => scale * (1.0 - random.unit().abs() * 1e-3) * if random.below(2) == 0 { -1.0 } else { 1.0 },
                    _ => value,
                }
            })
            .collect();
        if kind >= 4 {
            self.keep_promises(&mut inputs);
        }
        inputs.into_iter().map(|value| value as f32).collect()
    }

    /// Moves inputs to where the relations of their types hold, up to rounding: steps onto one linearised relation after
    /// the other.
    fn keep_promises(&self, inputs: &mut [f64]) {
        for relation in (0..10).flat_map(|_| self.relations) {
            let (mut value, mut gradient) = (0.0, vec![0.0; inputs.len()]);
            for (monomial, coefficient) in relation.terms() {
                let symbols: Vec<_> = monomial.symbols().iter().map(|&symbol| usize::from(symbol)).collect();
                let product = |skip: Option<usize>| {
                    let factors = symbols.iter().enumerate().filter(|(place, _)| Some(*place) != skip);
                    coefficient.to_f64() * factors.map(|(_, &symbol)| inputs[symbol]).product::<f64>()
                };
                value += product(None);
                symbols.iter().enumerate().for_each(|(place, &symbol)| gradient[symbol] += product(Some(place)));
            }
            let square: f64 = gradient.iter().map(|slope| slope * slope).sum();
            if square > 0.0 {
                inputs.iter_mut().zip(&gradient).for_each(|(input, slope)| *input -= value * slope / square);
            }
        }
    }
}

/// A small or large change of one or two inputs.
fn neighbour(inputs: &[f32], random: &mut Random) -> Vec<f32> {
    let mut changed = inputs.to_vec();
    for _ in 0..=random.below(2) {
        let index = random.below(changed.len());
        let value = changed[index];
        changed[index] = match random.below(5) {
            0 => -value,
            1 => value * (1.0 + random.unit() as f32 * 0.5),
            2 => value * (1.0 + random.unit() as f32 * 1e-3),
            3 => f32::from_bits(value.to_bits() ^ (1 << random.below(20))),
            _ => changed[random.below(inputs.len())] * (1.0 + random.unit() as f32 * 0.1),
        };
    }
    changed
}

const RESTARTS: usize = 6;
const STEPS: usize = 200;

/// The worst ratio that a search finds; every start and every result is judged exactly.
fn worst_ratio(subject: &Subject<'_>, group: &GroupBound, seed: u64) -> f64 {
    let mut random = Random(seed);
    let mut worst = 0.0f64;
    let quick = |inputs: &[f32]| subject.ratio::<f64>(group, inputs, |number| *number);
    for _ in 0..RESTARTS {
        let mut inputs = subject.start(&mut random);
        worst = worst.max(subject.exact_ratio(group, &inputs));
        let mut ratio = quick(&inputs);
        for _ in 0..STEPS {
            let next = neighbour(&inputs, &mut random);
            let found = quick(&next);
            if found >= ratio {
                (inputs, ratio) = (next, found);
            }
        }
        worst = worst.max(subject.exact_ratio(group, &inputs));
    }
    worst
}

fn compiled(name: &str) -> (ga_codegen::kernel::Definition, Vec<Compiled>) {
    let tokens = preset::text(name).expect("a preset").parse().expect("a preset is tokens");
    let definition = define(tokens).expect("a preset is a definition");
    let compiled = compile(&definition).expect("a preset is proved");
    (definition, compiled)
}

/// Checks every program of a preset and prints what it found.
fn check(name: &str) {
    let (definition, all) = compiled(name);
    let mut ratios = Vec::new();
    for (index, compiled) in all.iter().enumerate() {
        let Some(subject) = Subject::new(compiled) else { continue };
        for group in &subject.bound.groups {
            let ratio = worst_ratio(&subject, group, index as u64);
            let names = compiled.parameter_names(&definition);
            let text = group.display(subject.bound.roundings, &names);
            println!("{:5.3}  {} {}: {text}", ratio, compiled.name, group.group.name());
            assert!(ratio <= 1.0, "{}: an error of {ratio} times the bound {text}", compiled.name);
            if !group.terms.is_empty() {
                ratios.push((ratio, compiled.name.clone()));
            }
        }
    }
    ratios.sort_by(|a, b| a.0.total_cmp(&b.0));
    println!("{name}: {} bounds, worst ratios from {:?} to {:?}", ratios.len(), ratios.first(), ratios.last());
    let loose: Vec<_> = ratios.iter().filter(|(ratio, _)| *ratio < 0.05).collect();
    assert!(loose.is_empty(), "bounds more than 20 times what happens: {loose:?}");
}

#[test]
fn bounds_of_pga3d_hold_and_are_met_within_a_factor_of_20() {
    check("pga3d");
}

#[test]
fn bounds_of_pga2d_hold_and_are_met_within_a_factor_of_20() {
    check("pga2d");
}

/// The bounds of a definition's only kernel, as they are written.
fn written(block: &str) -> Vec<String> {
    let definition = define(block.parse().expect("tokens")).expect("a definition");
    let compiled = compile(&definition).expect("a proof");
    let bound = compiled[0].promised_bound(&definition).expect("a polynomial program");
    let names = compiled[0].parameter_names(&definition);
    bound.groups.iter().map(|group| group.display(bound.roundings, &names)).collect()
}

const VECTORS: &str = "signature (3, 0, 1);
    entity Plane { e1, e2, e3, e0 }
    entity UnitPlane { e1, e2, e3, e0 } where e1*e1 == 1 - e2*e2 - e3*e3;
    entity Pair { a: e01, b: e1 }";

#[test]
fn a_dot_product_has_the_textbook_bound() {
    // Three products, two of which go through two additions: the matrix of roundings is (3, 3, 2), |(3, 3, 2)| = 4.69.
    assert_eq!(written(&format!("{VECTORS} kernel f(a: Plane, b: Plane) -> Scalar = a | b;")), ["4.7 |a| |b|"]);
}

#[test]
fn unit_parts_are_left_out_and_groups_kept_apart() {
    let sum = written(&format!("{VECTORS} kernel f(a: UnitPlane, b: Plane) -> Plane = a + b;"));
    assert_eq!(sum, ["1 + |b|", "|a|_0 + |b|_0"]);
}

#[test]
fn copies_negations_and_doublings_round_nothing() {
    assert_eq!(written(&format!("{VECTORS} kernel f(a: Plane) -> Plane = -(a + a);")), ["0", "0"]);
}

#[test]
fn inputs_with_many_coefficients_are_bounded_by_their_norms() {
    // 64 coefficients each do not fit one word with their exponents.
    let blades = |from: u32| {
        let words = (from..128).filter(|bits| bits.count_ones() % 2 == 0).map(|bits| {
            let digits: String = (0..7).filter(|i| bits >> i & 1 == 1).map(|i| (i + 1).to_string()).collect();
            if digits.is_empty() { "s: 1".to_owned() } else { format!("e{digits}") }
        });
        words.collect::<Vec<_>>().join(", ")
    };
    let block = format!("signature (7, 0, 0); entity Even {{ {} }}", blades(0));
    let found = written(&format!("{block} kernel f(a: Even, b: Even) -> Scalar = scalar_product(a, ~b);"));
    assert_eq!(found.len(), 1);
    assert!(found[0].ends_with(" |a| |b|"), "{found:?}");
}
