//! Random values of entities that satisfy the relations of their types exactly.
//!
//! An entity without relations takes any coefficients. One with relations is made by motion: a versor is a product of
//! rotors whose sines and cosines are rational, ((1 - t^2) + 2 t e_ij) / (1 + t^2), and of a translator where the type
//! has ideal coefficients; anything else is the image of a Euclidean basis blade under such a versor. So a unit line
//! keeps the Pluecker relation because the image of an axis is a line. Three turns make any rotation; two carry an axis
//! in any direction, and keep the fractions short enough for products of many.

use crate::exact::Exact;
use ga_codegen::algebra::Signature;
use ga_codegen::kernel::{Definition, Entity, Kernel};
use ga_codegen::reference::Multivector;
use ga_codegen::symbolic::{Polynomial, Rational, Symbol};

/// SplitMix64 (Steele, Lea, Flood 2014), so that every run sees the same samples.
pub(crate) struct Random(pub(crate) u64);

impl Random {
    pub(crate) fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    /// A whole number from -`limit` to `limit`.
    pub(crate) fn integer(&mut self, limit: i128) -> i128 {
        i128::from(self.next()) % (2 * limit + 1) - limit
    }

    /// A number in [-1, 1).
    pub(crate) fn float(&mut self) -> f64 {
        (self.next() >> 11) as f64 / (1u64 << 52) as f64 - 1.0
    }

    fn choose<'a, T>(&mut self, items: &'a [T]) -> &'a T {
        &items[(self.next() % items.len() as u64) as usize]
    }

    /// A small fraction, now and then 0.
    pub(crate) fn fraction(&mut self) -> Exact {
        let denominator = 1 + (self.next() % 4) as i128;
        Exact::new(self.integer(9), denominator)
    }
}

/// The words of the generators, `e0` first where there is a null one.
fn generators(signature: Signature) -> Vec<String> {
    let first = usize::from(signature.null() == 0);
    (first..first + signature.dimension()).map(|index| format!("e{index}")).collect()
}

/// Whether a word has the null generator in it.
pub(crate) fn is_ideal(word: &str) -> bool {
    word.contains('0')
}

/// A rotor about a random Euclidean basis bivector; the half turn and the identity among them.
fn rotor(signature: Signature, random: &mut Random) -> Multivector<Exact> {
    let euclidean: Vec<_> = generators(signature).into_iter().filter(|word| !is_ideal(word)).collect();
    let first = random.choose(&euclidean).clone();
    let others: Vec<_> = euclidean.into_iter().filter(|word| *word != first).collect();
    let bivector = format!("{first}{}", random.choose(&others).trim_start_matches('e'));
    let (p, q) = (random.integer(4), 1 + (random.next() % 4) as i128);
    let norm = q * q + p * p;
    let terms = [("1".to_owned(), Exact::new(q * q - p * p, norm)), (bivector, Exact::new(2 * p * q, norm))];
    Multivector::from_blades(signature, terms).expect("words of the signature")
}

fn translator(signature: Signature, random: &mut Random) -> Multivector<Exact> {
    let euclidean = generators(signature).into_iter().filter(|word| !is_ideal(word));
    let mut terms: Vec<_> = euclidean.map(|word| (word.replace('e', "e0"), random.fraction())).collect();
    terms.push(("1".to_owned(), Exact::ONE));
    Multivector::from_blades(signature, terms).expect("words of the signature")
}

fn versor(signature: Signature, turns: usize, with_translation: bool, random: &mut Random) -> Multivector<Exact> {
    let mut versor = Multivector::scalar(signature, Exact::ONE);
    for _ in 0..turns {
        versor = versor.geometric(&rotor(signature, random));
    }
    if with_translation { translator(signature, random).geometric(&versor) } else { versor }
}

/// The fields of a random value of the entity.
pub(crate) fn entity(signature: Signature, entity: &Entity, random: &mut Random) -> Vec<Exact> {
    if entity.statements.is_empty() {
        return entity.fields().map(|_| random.fraction()).collect();
    }
    let words: Vec<_> = entity.fields().map(|(_, component)| component.name.clone()).collect();
    let is_versor = words.iter().any(|word| word == "1");
    let turns = if is_versor { 3 } else { 2 };
    let versor = versor(signature, turns, words.iter().any(|word| is_ideal(word)), random);
    let value = if is_versor {
        versor
    } else {
        let euclidean: Vec<_> = words.iter().filter(|word| !is_ideal(word)).collect();
        let seed = Multivector::from_blades(signature, [(*random.choose(&euclidean), Exact::ONE)]);
        versor.sandwich(&seed.expect("a word of the signature"))
    };
    let fields: Vec<_> = words.iter().map(|word| value.coefficient(word)).collect();
    for excess in relation_values(entity, &fields) {
        assert_eq!(excess, Exact::ZERO, "a sample of {} that keeps its relations, {fields:?}", entity.name);
    }
    fields
}

/// Values of the entities that have relations, made once for all kernels: it is these that take time.
pub(crate) struct Pools {
    /// By entity; empty for one without relations.
    values: Vec<Vec<Vec<Exact>>>,
}

impl Pools {
    /// So many different values of every entity with relations.
    pub(crate) fn new(definition: &Definition, size: usize, random: &mut Random) -> Self {
        let pool = |one: &Entity| match one.statements.is_empty() {
            true => Vec::new(),
            false => (0..size).map(|_| entity(definition.basis.signature(), one, random)).collect(),
        };
        Self { values: definition.entities.iter().map(pool).collect() }
    }

    /// The inputs of a kernel in one of many cases. Parameters of one type get different values.
    pub(crate) fn row(&self, definition: &Definition, kernel: &Kernel, case: usize, random: &mut Random) -> Vec<Exact> {
        let mut row = Vec::new();
        for (position, parameter) in kernel.parameters.iter().enumerate() {
            let pool = &self.values[parameter.entity];
            let one = &definition.entities[parameter.entity];
            match pool.len() {
                0 => row.extend(entity(definition.basis.signature(), one, random)),
                size => row.extend_from_slice(&pool[(case + position * size / 3) % size]),
            }
        }
        keep_relations(definition, kernel, row, random)
    }
}

/// The coefficients of random inputs of a kernel, those of all parameters in one row.
pub(crate) fn row(definition: &Definition, kernel: &Kernel, random: &mut Random) -> Vec<Exact> {
    let entities = kernel.parameters.iter().map(|parameter| &definition.entities[parameter.entity]);
    let row = entities.flat_map(|one| entity(definition.basis.signature(), one, random)).collect();
    keep_relations(definition, kernel, row, random)
}

/// A row in which the kernel's own relations hold as well as those of the types.
fn keep_relations(definition: &Definition, kernel: &Kernel, mut row: Vec<Exact>, random: &mut Random) -> Vec<Exact> {
    // A kernel's own relations so far say that some coefficients, bound by nothing else, make a vector of length 1.
    for statement in &kernel.statements {
        let symbols = sphere(statement.relation.polynomial());
        let symbols = symbols.unwrap_or_else(|| panic!("{}: no sampler for `{}`", kernel.name, statement.text));
        for (symbol, coordinate) in symbols.iter().zip(unit_vector(symbols.len(), random)) {
            row[usize::from(*symbol)] = coordinate;
        }
    }
    let mut excess: Vec<_> =
        kernel.statements.iter().map(|statement| value(statement.relation.polynomial(), &row)).collect();
    let mut rest = row.as_slice();
    for parameter in &kernel.parameters {
        let entity = &definition.entities[parameter.entity];
        let (fields, after) = rest.split_at(entity.fields().count());
        excess.extend(relation_values(entity, fields));
        rest = after;
    }
    assert!(excess.iter().all(|excess| *excess == Exact::ZERO), "{}: a sample breaks a relation", kernel.name);
    row
}

/// The symbols x, y, ... of a polynomial x^2 + y^2 + ... - 1.
fn sphere(polynomial: &Polynomial) -> Option<Vec<Symbol>> {
    let mut symbols = Vec::new();
    for (monomial, coefficient) in polynomial.terms() {
        match *monomial.symbols() {
            [] if coefficient == Rational::MINUS_ONE => {}
            [x, y] if x == y && coefficient == Rational::ONE => symbols.push(x),
            _ => return None,
        }
    }
    Some(symbols)
}

/// A rational point of the unit sphere, by stereographic projection: (2 t, 1 - |t|^2) / (1 + |t|^2).
fn unit_vector(dimension: usize, random: &mut Random) -> Vec<Exact> {
    let t: Vec<_> = (1..dimension).map(|_| Exact::new(random.integer(4), 1 + (random.next() % 4) as i128)).collect();
    let square = t.iter().fold(Exact::ZERO, |sum, &x| sum + x * x);
    let last = (Exact::ONE - square) / (Exact::ONE + square);
    t.iter().map(|&x| (x + x) / (Exact::ONE + square)).chain([last]).collect()
}

/// A polynomial at a point.
fn value(polynomial: &Polynomial, at: &[Exact]) -> Exact {
    let product = |symbols: &[Symbol]| symbols.iter().fold(Exact::ONE, |product, &s| product * at[usize::from(s)]);
    polynomial.terms().fold(Exact::ZERO, |sum, (monomial, coefficient)| {
        sum + Exact::new(coefficient.numerator(), coefficient.denominator()) * product(monomial.symbols())
    })
}

/// Left minus right side of every relation of an entity.
pub(crate) fn relation_values(entity: &Entity, fields: &[Exact]) -> Vec<Exact> {
    entity.statements.iter().map(|statement| value(statement.relation.polynomial(), fields)).collect()
}
