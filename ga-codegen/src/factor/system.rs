//! Sums of signed products of literals: the form in which common parts are looked for.

use super::cube::{Cube, Cubes, Literal};
use crate::program::{Operation, ProgramBuilder, Value};
use crate::symbolic::{Overflow, Polynomial, Rational};

/// A sum of distinct cubes, ascending; `true` marks a minus.
pub(super) type Row = Vec<(Cube, bool)>;

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
    pub(super) cubes: Cubes,
    pub(super) rows: Vec<Row>,
    meanings: Vec<Meaning>,
    outputs: usize,
}

/// The sign of a cube in a row, if it is there.
pub(super) fn sign_in(row: &Row, cube: Cube) -> Option<bool> {
    row.binary_search_by_key(&cube, |&(other, _)| other).ok().map(|position| row[position].1)
}

impl System {
    /// The system of these polynomials in `given` symbols.
    pub(super) fn new(polynomials: &[Polynomial], given: usize) -> Result<Self, Overflow> {
        let meanings = (0..given).map(Meaning::Given).collect();
        let mut system = Self { cubes: Cubes::new(), rows: Vec::new(), meanings, outputs: polynomials.len() };
        for polynomial in polynomials {
            let mut row = Row::new();
            for (monomial, coefficient) in polynomial.terms() {
                let mut literals = monomial.symbols().to_vec();
                system.append_number(&mut literals, coefficient.abs())?;
                row.push((system.cubes.cube(literals), coefficient.is_negative()));
            }
            row.sort_unstable();
            system.rows.push(row);
        }
        Ok(system)
    }

    fn append_number(&mut self, literals: &mut Vec<Literal>, mut number: Rational) -> Result<(), Overflow> {
        while number.denominator() == 1 && number.numerator() % 2 == 0 {
            number = number.checked_mul(Rational::new(1, 2)?)?;
            literals.push(self.literal(Meaning::Two));
        }
        if number != Rational::ONE {
            literals.push(self.literal(Meaning::Constant(number)));
        }
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
        let degrees = self.rows.iter().flatten().map(|&(cube, _)| self.cubes.degree(cube));
        let products: usize = degrees.map(|degree| degree.saturating_sub(1)).sum();
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
        let mut cubes = self.rows[row].clone();
        cubes.sort_by_key(|&(cube, _)| self.cubes.literals(cube));
        let mut terms = Vec::new();
        for (cube, minus) in cubes {
            terms.push((minus, self.build_cube(cube, builder, given, built)));
        }
        let value = builder.sum(&terms);
        built[row] = Some(value);
        value
    }

    fn build_cube(
        &self,
        cube: Cube,
        builder: &mut ProgramBuilder,
        given: &[Value],
        built: &mut [Option<Value>],
    ) -> Value {
        let (mut product, mut doublings) = (None, 0);
        for &literal in self.cubes.literals(cube) {
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
