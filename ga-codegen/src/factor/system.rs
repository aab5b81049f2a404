//! Sums of signed products of literals: the form in which common parts are looked for.

use crate::program::{Operation, ProgramBuilder, Value};
use crate::symbolic::{Overflow, Polynomial, Rational};
use std::collections::BTreeMap;

/// A factor of a product, by its index into [`System::meanings`].
pub(super) type Literal = u16;

/// A product of literals, ascending, with repetition.
pub(super) type Cube = Vec<Literal>;

/// A sum of distinct cubes; `true` marks a minus.
pub(super) type Row = BTreeMap<Cube, bool>;

#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) enum Meaning {
    /// An input or another value that is there already.
    Given(usize),
    /// The number 2, as a literal so that doubling early is found.
    Two,
    /// Another number, positive.
    Constant(Rational),
    /// What has been extracted as a row of its own.
    Row(usize),
}

/// Output rows first, then extracted ones.
#[derive(Clone, Debug)]
pub(super) struct System {
    pub(super) meanings: Vec<Meaning>,
    pub(super) rows: Vec<Row>,
    outputs: usize,
}

impl System {
    /// The system of these polynomials in `given` symbols.
    pub(super) fn new(polynomials: &[Polynomial], given: usize) -> Result<Self, Overflow> {
        let meanings = (0..given).map(Meaning::Given).chain([Meaning::Two]).collect();
        let mut system = Self { meanings, rows: Vec::new(), outputs: polynomials.len() };
        for polynomial in polynomials {
            let mut row = Row::new();
            for (monomial, coefficient) in polynomial.terms() {
                let mut cube = monomial.symbols().to_vec();
                system.append_number(&mut cube, coefficient.abs())?;
                row.insert(cube, coefficient.is_negative());
            }
            system.rows.push(row);
        }
        Ok(system)
    }

    fn append_number(&mut self, cube: &mut Cube, mut number: Rational) -> Result<(), Overflow> {
        while number.denominator() == 1 && number.numerator() % 2 == 0 {
            number = number.mul(Rational::new(1, 2)?)?;
            cube.push(self.literal(Meaning::Two));
        }
        if number != Rational::ONE {
            cube.push(self.literal(Meaning::Constant(number)));
        }
        cube.sort_unstable();
        Ok(())
    }

    /// The literal of a meaning, new if need be.
    pub(super) fn literal(&mut self, meaning: Meaning) -> Literal {
        let known = self.meanings.iter().position(|other| *other == meaning);
        known.unwrap_or_else(|| {
            self.meanings.push(meaning);
            self.meanings.len() - 1
        }) as Literal
    }

    /// Multiplications and additions, then multiplications, so that the smaller is the better.
    pub(super) fn cost(&self) -> (usize, usize) {
        let products: usize = self.rows.iter().flat_map(BTreeMap::keys).map(|cube| cube.len().saturating_sub(1)).sum();
        let sums: usize = self.rows.iter().map(|row| row.len().saturating_sub(1)).sum();
        (products + sums, products)
    }

    /// Appends the operations of the system to a program; returns the values of the output rows.
    pub(super) fn build(&self, builder: &mut ProgramBuilder, given: &[Value]) -> Vec<Value> {
        let mut built = vec![None; self.rows.len()];
        (0..self.outputs).map(|row| self.build_row(row, builder, given, &mut built)).collect()
    }

    fn build_row(
        &self,
        row: usize,
        builder: &mut ProgramBuilder,
        given: &[Value],
        built: &mut [Option<Value>],
    ) -> Value {
        if let Some(value) = built[row] {
            return value;
        }
        let mut terms = Vec::new();
        for (cube, &minus) in &self.rows[row] {
            terms.push((minus, self.build_cube(cube, builder, given, built)));
        }
        let value = builder.sum(&terms);
        built[row] = Some(value);
        value
    }

    fn build_cube(
        &self,
        cube: &[Literal],
        builder: &mut ProgramBuilder,
        given: &[Value],
        built: &mut [Option<Value>],
    ) -> Value {
        let (mut product, mut doublings) = (None, 0);
        for &literal in cube {
            let factor = match &self.meanings[usize::from(literal)] {
                Meaning::Given(index) => given[*index],
                Meaning::Constant(number) => builder.push(Operation::Constant(*number)),
                Meaning::Row(row) => self.build_row(*row, builder, given, built),
                Meaning::Two => {
                    doublings += 1;
                    continue;
                }
            };
            product = Some(product.map_or(factor, |product| builder.push(Operation::Mul(product, factor))));
        }
        let mut value = product.unwrap_or_else(|| {
            let number = Rational::integer(1 << doublings);
            doublings = 0;
            builder.push(Operation::Constant(number))
        });
        for _ in 0..doublings {
            value = builder.push(Operation::Double(value));
        }
        value
    }
}
