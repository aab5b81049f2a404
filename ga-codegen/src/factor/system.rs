//! Sums of signed products of literals: the form in which common parts are looked for.

use super::cube::{Cube, Cubes, Literal};
use crate::program::{CostModel, Operation, Program, ProgramBuilder, Value};
use crate::symbolic::{Overflow, Polynomial, Rational, effort};

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

/// The largest power of two that is written as one number; a larger one is doubled.
const LARGEST_POWER: u32 = 62;

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
        Self::staged(polynomials, given, &[])
    }

    /// The system of `outputs` in `given` symbols and further ones, which stand for the polynomials `rows`, in order.
    pub(super) fn staged(outputs: &[Polynomial], given: usize, rows: &[Polynomial]) -> Result<Self, Overflow> {
        let stages = (0..rows.len()).map(|row| Meaning::Row(outputs.len() + row));
        let meanings = (0..given).map(Meaning::Given).chain(stages).collect();
        let mut system = Self { cubes: Cubes::new(), rows: Vec::new(), meanings, outputs: outputs.len() };
        for polynomial in outputs.iter().chain(rows) {
            let mut row = Row::new();
            for (monomial, coefficient) in polynomial.terms() {
                let mut literals = monomial.symbols().to_vec();
                system.append_number(&mut literals, coefficient.abs())?;
                row.push((system.cubes.cube(literals), coefficient.is_negative()));
            }
            row.sort_unstable();
            system.rows.push(row);
        }
        system.drop_dead_rows();
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
        effort::spend(self.meanings.len() / 64);
        let known = self.meanings.iter().position(|other| *other == meaning);
        known.unwrap_or_else(|| {
            self.meanings.push(meaning);
            self.meanings.len() - 1
        }) as Literal
    }

    /// Empties the rows that no output needs.
    fn drop_dead_rows(&mut self) {
        let mut live = vec![false; self.rows.len()];
        let mut pending: Vec<usize> = (0..self.outputs).collect();
        while let Some(row) = pending.pop() {
            if std::mem::replace(&mut live[row], true) {
                continue;
            }
            let literals = self.rows[row].iter().flat_map(|&(cube, _)| self.cubes.literals(cube));
            pending.extend(literals.filter_map(|&literal| match self.meanings[usize::from(literal)] {
                Meaning::Row(row) => Some(row),
                _ => None,
            }));
        }
        for (row, _) in self.rows.iter_mut().zip(live).filter(|(_, live)| !live) {
            row.clear();
        }
    }

    /// Whether another system has the same rows.
    pub(super) fn same_rows(&self, other: &Self) -> bool {
        let literals = |system: &Self| -> Vec<Vec<(Vec<Literal>, bool)>> {
            let term = |&(cube, minus): &(Cube, bool)| (system.cubes.literals(cube).to_vec(), minus);
            let mut rows: Vec<Vec<_>> = system.rows.iter().map(|row| row.iter().map(term).collect()).collect();
            rows.iter_mut().for_each(|row: &mut Vec<(Vec<Literal>, bool)>| row.sort_unstable());
            rows
        };
        self.meanings == other.meanings && literals(self) == literals(other)
    }

    /// Multiplications and additions, then multiplications, so that the smaller is the better.
    pub(super) fn cost(&self) -> (usize, usize) {
        let degrees = self.rows.iter().flatten().map(|&(cube, _)| self.cubes.degree(cube));
        let products: usize = degrees.map(|degree| degree.saturating_sub(1)).sum();
        let sums: usize = self.rows.iter().map(|row| row.len().saturating_sub(1)).sum();
        (products + sums, products)
    }

    /// Turns extracted rows that are all minus around, with everything that uses them.
    pub(super) fn normalise_signs(&mut self) {
        for turned in self.outputs..self.rows.len() {
            if self.rows[turned].is_empty() || self.rows[turned].iter().any(|(_, minus)| !minus) {
                continue;
            }
            let literal = self.literal(Meaning::Row(turned));
            self.rows[turned].iter_mut().for_each(|(_, minus)| *minus = false);
            for (cube, minus) in self.rows.iter_mut().flatten() {
                let power = self.cubes.literals(*cube).iter().filter(|&&other| other == literal).count();
                *minus ^= power % 2 == 1;
            }
        }
    }

    /// The program of a system whose given values are the inputs; sums are chains, or balanced where the model is latency.
    pub(super) fn program(&self, model: CostModel) -> Program {
        let mut builder = ProgramBuilder::new();
        let given = self.meanings.iter().filter(|meaning| matches!(meaning, Meaning::Given(_))).count();
        let inputs: Vec<_> = (0..given).map(|input| builder.push(Operation::Input(input))).collect();
        let outputs = self.build_for(model, &mut builder, &inputs);
        builder.finish(&outputs)
    }

    /// Appends the operations of the system to a program; returns the values of the output rows.
    pub(super) fn build(&self, builder: &mut ProgramBuilder, given: &[Value]) -> Vec<Value> {
        self.build_for(CostModel::default(), builder, given)
    }

    fn build_for(&self, model: CostModel, builder: &mut ProgramBuilder, given: &[Value]) -> Vec<Value> {
        let mut built = vec![None; self.rows.len()];
        (0..self.outputs).map(|row| self.build_row(row, model, builder, given, &mut built)).collect()
    }

    fn build_row(
        &self,
        row: usize,
        model: CostModel,
        builder: &mut ProgramBuilder,
        given: &[Value],
        built: &mut [Option<Value>],
    ) -> Value {
        if let Some(value) = built[row] {
            return value;
        }
        let mut cubes = self.rows[row].clone();
        // Products come last, so that each can be fused with the addition that takes it.
        cubes.sort_by_key(|&(cube, _)| (self.cubes.degree(cube) > 1, self.cubes.literals(cube)));
        let mut terms = Vec::new();
        for (cube, minus) in cubes {
            terms.push((minus, self.build_cube(cube, model, builder, given, built)));
        }
        let value = match model {
            CostModel::Latency => builder.balanced_sum(&terms),
            CostModel::Flops | CostModel::Fma => builder.sum(&terms),
        };
        built[row] = Some(value);
        value
    }

    fn build_cube(
        &self,
        cube: Cube,
        model: CostModel,
        builder: &mut ProgramBuilder,
        given: &[Value],
        built: &mut [Option<Value>],
    ) -> Value {
        let (mut product, mut doublings) = (None, 0);
        for &literal in self.cubes.literals(cube) {
            let factor = match &self.meanings[usize::from(literal)] {
                Meaning::Given(index) => given[*index],
                Meaning::Constant(number) => builder.push(Operation::Constant(*number)),
                Meaning::Row(row) => self.build_row(*row, model, builder, given, built),
                Meaning::Two => {
                    doublings += 1;
                    continue;
                }
            };
            product = Some(product.map_or(factor, |product| builder.push(Operation::Mul(product, factor))));
        }
        let mut value = product.unwrap_or_else(|| {
            let number = Rational::integer(1 << doublings.min(LARGEST_POWER));
            doublings = doublings.saturating_sub(LARGEST_POWER);
            builder.push(Operation::Constant(number))
        });
        for _ in 0..doublings {
            value = builder.push(Operation::Double(value));
        }
        value
    }
}
