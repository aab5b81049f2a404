//! Products of literals, each known by a number, so that the search works on numbers alone.

use std::collections::HashMap;

/// A factor of a product, by its index into the meanings of a system.
pub(super) type Literal = u16;

/// A product of literals, by its index into a [`Cubes`].
pub(super) type Cube = u32;

/// All products that have occurred. Numbers are given in order of occurrence, so that equal runs give equal numbers.
#[derive(Clone, Debug)]
pub(super) struct Cubes {
    literals: Vec<Vec<Literal>>,
    known: HashMap<Vec<Literal>, Cube>,
    products: HashMap<(Cube, Cube), Cube>,
    splits: Vec<Option<Vec<(Cube, Cube)>>>,
}

/// Cubes of a higher degree are not split into all their parts, of which there could be 2^degree.
const SPLIT_DEGREE: usize = 12;

impl Cubes {
    /// The empty product.
    pub(super) const ONE: Cube = 0;

    /// Only the empty product is known.
    pub(super) fn new() -> Self {
        let mut cubes =
            Self { literals: Vec::new(), known: HashMap::new(), products: HashMap::new(), splits: Vec::new() };
        cubes.cube(Vec::new());
        cubes
    }

    /// The number of a product.
    pub(super) fn cube(&mut self, mut literals: Vec<Literal>) -> Cube {
        literals.sort_unstable();
        if let Some(&cube) = self.known.get(&literals) {
            return cube;
        }
        let cube = self.literals.len() as Cube;
        self.known.insert(literals.clone(), cube);
        self.literals.push(literals);
        self.splits.push(None);
        cube
    }

    /// How many cubes there are: one more than the largest number.
    pub(super) fn count(&self) -> usize {
        self.literals.len()
    }

    /// The literals of a cube, ascending.
    pub(super) fn literals(&self, cube: Cube) -> &[Literal] {
        &self.literals[cube as usize]
    }

    /// How many literals a cube has.
    pub(super) fn degree(&self, cube: Cube) -> usize {
        self.literals[cube as usize].len()
    }

    /// The product of two cubes.
    pub(super) fn product(&mut self, a: Cube, b: Cube) -> Cube {
        if let Some(&product) = self.products.get(&(a, b)) {
            return product;
        }
        let product = self.cube([self.literals(a), self.literals(b)].concat());
        self.products.insert((a, b), product);
        product
    }

    /// What is left of a cube when another is taken out of it.
    pub(super) fn quotient(&mut self, cube: Cube, divisor: Cube) -> Option<Cube> {
        let (mut rest, mut wanted) = (Vec::new(), self.literals(divisor).iter().peekable());
        for literal in self.literals(cube) {
            if wanted.peek() == Some(&literal) {
                wanted.next();
            } else {
                rest.push(*literal);
            }
        }
        let divides = wanted.peek().is_none();
        divides.then(|| self.cube(rest))
    }

    /// How many ways to write a cube as a product of two are tried.
    pub(super) fn split_count(&self, cube: Cube) -> usize {
        let degree = self.degree(cube);
        if degree > SPLIT_DEGREE { 1 } else { 1 << degree }
    }

    /// Every way to write a cube as a product of two, each once.
    pub(super) fn splits(&mut self, cube: Cube) -> Vec<(Cube, Cube)> {
        if let Some(splits) = &self.splits[cube as usize] {
            return splits.clone();
        }
        let literals = self.literals(cube).to_vec();
        let masks = self.split_count(cube);
        let mut splits = Vec::new();
        for mask in 0..masks {
            let (mut part, mut rest) = (Vec::new(), Vec::new());
            for (position, &literal) in literals.iter().enumerate() {
                let chosen = masks > 1 && mask >> position & 1 == 1;
                if chosen { part.push(literal) } else { rest.push(literal) }
            }
            splits.push((self.cube(part), self.cube(rest)));
        }
        splits.sort_unstable();
        splits.dedup();
        self.splits[cube as usize] = Some(splits.clone());
        splits
    }
}
