//! Proves that a program computes what a kernel is defined as.
//!
//! A polynomial kernel's program is evaluated on the symbols of the inputs; every output must equal the specified
//! polynomial modulo the inputs' relations, that is, their difference must have normal form 0.
//!
//! The program of `exp` or `log` is evaluated on formal power series (see [`SeriesRing`]) and compared with the
//! definition: exp(B) with sum of B^n / n!, and log with B where its argument is that sum. What the output type promises
//! is proved of the same series. This is a proof to a total degree in the coefficients of the bivector, [`ORDER`] or one
//! beyond the degree of the program, whichever is greater, and no further: so a program that is wrong by sums and products
//! of its inputs, such as `e23^13`, is refuted, but one that is wrong by terms of higher degree alone, such as the
//! thirteenth power of 1 - cos(l), is accepted. If all terms agree, the functions, which are analytic, are equal about the
//! identity, as far as the branches of the root and of atan2 reach. An argument of log is promised to be a unit, see
//! [`Specification`].
//!
//! This file knows nothing of how programs are found.

use crate::algebra::{Blade, Product};
use crate::kernel::{Analytic, Component, ComponentValue, Entity, Specification};
use crate::program::{Domain, Operation, Program};
use crate::symbolic::{
    Monomial, Multivector, Overflow, Polynomial, Rational, Series, SeriesError, SeriesRing, Symbol,
    reciprocal_factorial,
};
use std::fmt;

/// The total degree up to which power series are compared at least.
pub const ORDER: usize = 12;

/// The greatest total degree for which power series are computed.
const MAX_ORDER: usize = 20;

/// Quotients lose up to three orders on the way, so more are carried than are compared.
const LOST_ORDERS: usize = 4;

/// What has been proved.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Proof {
    /// Equal as polynomials modulo the relations of the inputs.
    Exact,
    /// Equal as formal power series up to this total degree.
    Series(usize),
}

impl fmt::Display for Proof {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Exact => f.write_str("exact"),
            Self::Series(order) => write!(f, "series to order {order}"),
        }
    }
}

/// Why a program is not proved.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Refutation {
    /// [`Overflow`]
    Overflow,
    /// The program has another number of outputs than the type has fields.
    OutputCount,
    /// The program uses an operation that has no meaning here, or the definition has none.
    Undefined(String),
    /// The output type does not have this blade, and the definition does.
    CannotHold(String),
    /// A coefficient of the output differs: its name, and the normal form of program minus definition.
    Different(String, String),
    /// The program breaks a promise of the output type: the relation and the normal form of the excess.
    BrokenPromise(String, String),
    /// A series is known to too low an order: its name, and the order to which it should be known.
    Imprecise(String, usize),
}

impl From<Overflow> for Refutation {
    fn from(_: Overflow) -> Self {
        Self::Overflow
    }
}

impl From<SeriesError> for Refutation {
    fn from(error: SeriesError) -> Self {
        match error {
            SeriesError::Overflow => Self::Overflow,
            other => Self::Undefined(other.to_string()),
        }
    }
}

impl fmt::Display for Refutation {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Overflow => Overflow.fmt(f),
            Self::OutputCount => f.write_str("the program has another number of outputs than its type has fields"),
            Self::Undefined(text) => f.write_str(text),
            Self::CannotHold(name) => write!(f, "expected an output that can hold `{name}`, found none"),
            Self::Different(name, difference) => {
                write!(f, "coefficient `{name}`: program minus definition is {difference}")
            }
            Self::BrokenPromise(relation, excess) => write!(f, "relation `{relation}`: the difference is {excess}"),
            Self::Imprecise(name, order) => write!(f, "coefficient `{name}`: the series is not known to order {order}"),
        }
    }
}

impl std::error::Error for Refutation {}

/// Proves a program equal to its specification.
///
/// # Errors
/// The first [`Refutation`].
pub fn prove(specification: &Specification, program: &Program) -> Result<Proof, Refutation> {
    if program.outputs.len() != specification.fields.len() {
        return Err(Refutation::OutputCount);
    }
    match specification.analytic {
        None => prove_polynomials(specification, program),
        Some(Analytic::Exp) => prove_exp(specification, program),
        Some(Analytic::Log) => prove_log(specification, program),
    }
}

fn prove_polynomials(specification: &Specification, program: &Program) -> Result<Proof, Refutation> {
    let inputs: Vec<_> = (0..specification.coefficients.len()).map(|s| Polynomial::symbol(s as Symbol)).collect();
    let computed = program.evaluate(&PolynomialDomain, &inputs)?;
    let names = specification.names();
    for ((field, computed), specified) in specification.fields.iter().zip(&computed).zip(&specification.outputs) {
        let difference = specification.relations.difference(computed, specified)?;
        if !difference.is_zero() {
            let field = if field.is_empty() { "1" } else { field };
            return Err(Refutation::Different(field.to_owned(), difference.display(&names)));
        }
    }
    Ok(Proof::Exact)
}

/// Proves that a program computes these polynomials of its inputs, identically.
///
/// # Errors
/// The first [`Refutation`].
pub fn prove_evaluation(program: &Program, polynomials: &[Polynomial], inputs: usize) -> Result<Proof, Refutation> {
    let inputs: Vec<_> = (0..inputs).map(|symbol| Polynomial::symbol(symbol as Symbol)).collect();
    let computed = program.evaluate(&PolynomialDomain, &inputs)?;
    if computed.len() != polynomials.len() {
        return Err(Refutation::OutputCount);
    }
    for (index, (computed, specified)) in computed.iter().zip(polynomials).enumerate() {
        let difference = computed.sub(specified)?;
        if !difference.is_zero() {
            return Err(Refutation::Different(index.to_string(), difference.display(&[])));
        }
    }
    Ok(Proof::Exact)
}

/// Every value of a program of ring operations, as a polynomial in its inputs; `None` for another program.
pub(crate) fn evaluate_polynomials(program: &Program, inputs: usize) -> Option<Vec<Polynomial>> {
    let inputs: Vec<_> = (0..inputs).map(|symbol| Polynomial::symbol(symbol as Symbol)).collect();
    let all = Program { operations: program.operations.clone(), outputs: (0..program.operations.len()).collect() };
    all.evaluate(&PolynomialDomain, &inputs).ok()
}

/// The order to which the series of a program are compared: beyond its degree, where roots, quotients and functions count
/// as degree 1, so that nothing that sums and products make of the inputs is overlooked.
fn order(program: &Program) -> Result<usize, Refutation> {
    let mut degrees: Vec<usize> = Vec::with_capacity(program.operations.len());
    for operation in &program.operations {
        let operands = operation.operands().map(|operand| degrees[operand]);
        degrees.push(match operation {
            Operation::Constant(_) => 0,
            Operation::Add(..) | Operation::Sub(..) | Operation::Neg(_) | Operation::Double(_) => {
                operands.max().unwrap_or(0)
            }
            Operation::Mul(..) => operands.fold(0, usize::saturating_add),
            _ => 1,
        });
    }
    let degree = degrees.into_iter().max().unwrap_or(0);
    if degree >= MAX_ORDER {
        let text = format!("expected a program of a degree below {MAX_ORDER}, found one of degree {degree}");
        return Err(Refutation::Undefined(text));
    }
    Ok(ORDER.max(degree + 1))
}

/// The exponential series of a bivector, and the ring of its coefficients.
struct Exponential {
    order: usize,
    ring: SeriesRing,
    names: Vec<String>,
    sum: Multivector,
}

impl Exponential {
    /// sum of B^n / n!, for a comparison to this order; the unknowns have these names.
    fn new(
        specification: &Specification,
        bivector: &Multivector,
        mut names: Vec<String>,
        order: usize,
    ) -> Result<Self, Refutation> {
        let carried = order + LOST_ORDERS;
        let basis = &specification.basis;
        let constant = |(_, c): (Blade, &Polynomial)| !c.coefficient(&Monomial::default()).is_zero();
        if bivector.terms().any(|(blade, _)| blade.grade() != 2) || bivector.terms().any(constant) {
            let text =
                "expected a bivector without constant coefficients as the argument of exp, found another multivector";
            return Err(Refutation::Undefined(text.to_owned()));
        }
        let square = bivector.product(Product::Geometric, bivector, basis)?.coefficient(Blade::SCALAR).neg();
        let radical = names.len() as Symbol;
        names.push("l".to_owned());
        let ring = SeriesRing::new(carried, radical, &square)?;
        let mut sum = Multivector::scalar(Polynomial::one());
        let mut power = sum.clone();
        for n in 1..=carried {
            let next = power.product(Product::Geometric, bivector, basis)?;
            power = next.map(|c| Ok::<_, Refutation>(ring.series(c)?.polynomial().clone()))?;
            sum = sum.add(&power.scale(reciprocal_factorial(n)?)?)?;
        }
        Ok(Self { order, ring, names, sum })
    }

    /// The coefficients of the series in an entity's fields, once it is known to hold all of them.
    fn fields(&self, specification: &Specification, entity: &Entity) -> Result<Vec<Series>, Refutation> {
        for named in specification.basis.blades() {
            let component = entity.components.iter().find(|component| component.blade == named.blade);
            let expected = match component.map(|component| (&component.value, component.sign)) {
                Some((ComponentValue::Field(_), _)) => continue,
                Some((ComponentValue::Constant(constant), sign)) => Polynomial::constant(*constant).signed(sign),
                None => Polynomial::zero(),
            };
            let difference = self.sum.coefficient(named.blade).sub(&expected)?;
            if !difference.is_zero() && component.is_none() {
                return Err(Refutation::CannotHold(named.name.clone()));
            }
            if !difference.is_zero() {
                return Err(Refutation::Different(named.name.clone(), difference.neg().display(&self.names)));
            }
        }
        let field = |(_, component): (&str, &Component)| {
            Ok(self.ring.series(&self.sum.coefficient(component.blade).signed(component.sign))?)
        };
        entity.fields().map(field).collect()
    }

    /// Compares two series to the order of the proof.
    fn compare(&self, name: &str, computed: &Series, specified: &Series) -> Result<(), Refutation> {
        let difference = self.ring.add(computed, &self.ring.neg(specified))?;
        if difference.order() < self.order {
            return Err(Refutation::Imprecise(name.to_owned(), self.order));
        }
        let low = self.low_terms(&difference)?;
        if low.is_zero() { Ok(()) } else { Err(Refutation::Different(name.to_owned(), low.display(&self.names))) }
    }

    fn low_terms(&self, series: &Series) -> Result<Polynomial, Overflow> {
        let mut low = Polynomial::zero();
        for (monomial, coefficient) in series.polynomial().terms().filter(|(m, _)| m.degree() <= self.order) {
            low.add_term(monomial.clone(), coefficient)?;
        }
        Ok(low)
    }

    /// Proves the relations of the output type on the computed series.
    fn keep_promises(&self, entity: &Entity, fields: &[Series]) -> Result<(), Refutation> {
        for statement in &entity.statements {
            let mut sum = self.ring.series(&Polynomial::zero())?;
            for (monomial, coefficient) in statement.relation.polynomial().terms() {
                let mut product = self.ring.series(&Polynomial::constant(coefficient))?;
                for &symbol in monomial.symbols() {
                    product = self.ring.mul(&product, &fields[usize::from(symbol)])?;
                }
                sum = self.ring.add(&sum, &product)?;
            }
            if sum.order() < self.order {
                return Err(Refutation::Imprecise(statement.text.clone(), self.order));
            }
            let excess = self.low_terms(&sum)?;
            if !excess.is_zero() {
                return Err(Refutation::BrokenPromise(statement.text.clone(), excess.display(&self.names)));
            }
        }
        Ok(())
    }
}

fn prove_exp(specification: &Specification, program: &Program) -> Result<Proof, Refutation> {
    if !specification.relations.is_empty() {
        let text = "expected an argument of exp whose coefficients are free, found relations between them";
        return Err(Refutation::Undefined(text.to_owned()));
    }
    let exponential = Exponential::new(specification, &specification.value, specification.names(), order(program)?)?;
    let inputs: Vec<_> = (0..specification.coefficients.len())
        .map(|symbol| exponential.ring.series(&Polynomial::symbol(symbol as Symbol)))
        .collect::<Result<_, _>>()?;
    let computed = program.evaluate(&exponential.ring, &inputs)?;
    let specified = exponential.fields(specification, &specification.output)?;
    let fields = specification.output.fields().map(|(field, _)| field);
    for ((field, computed), specified) in fields.zip(&computed).zip(&specified) {
        exponential.compare(field, computed, specified)?;
    }
    exponential.keep_promises(&specification.output, &computed)?;
    Ok(Proof::Series(exponential.order))
}

/// log is proved on the values of exp: the unknowns are the coefficients of the logarithm.
fn prove_log(specification: &Specification, program: &Program) -> Result<Proof, Refutation> {
    let [input] = specification.inputs.as_slice() else {
        return Err(Refutation::Undefined("expected one input of log, found another number".to_owned()));
    };
    if input != &specification.value {
        return Err(Refutation::Undefined(
            "expected the input itself as the argument of log, found an expression".to_owned(),
        ));
    }
    let output = &specification.output;
    let names = output.fields().map(|(field, _)| field.to_owned()).collect();
    let exponential = Exponential::new(specification, &output.symbolic(0), names, order(program)?)?;
    let inputs = exponential.arguments(specification)?;
    let computed = program.evaluate(&exponential.ring, &inputs)?;
    for (symbol, ((field, _), computed)) in output.fields().zip(&computed).enumerate() {
        let specified = exponential.ring.series(&Polynomial::symbol(symbol as Symbol))?;
        exponential.compare(field, computed, &specified)?;
    }
    exponential.keep_promises(output, &computed)?;
    Ok(Proof::Series(exponential.order))
}

impl Exponential {
    /// The input coefficients of a logarithm whose argument is the exponential series.
    fn arguments(&self, specification: &Specification) -> Result<Vec<Series>, Refutation> {
        let mut remaining = self.sum.clone();
        let mut inputs = vec![self.ring.series(&Polynomial::zero())?; specification.coefficients.len()];
        for (blade, pattern) in specification.value.terms() {
            let value = remaining.coefficient(blade);
            remaining = remaining.sub(&Multivector::term(blade, value.clone()))?;
            let mut terms = pattern.terms();
            match (terms.next(), terms.next()) {
                (Some((monomial, sign)), None) if monomial.degree() == 1 => {
                    inputs[usize::from(monomial.symbols()[0])] = self.ring.series(&value.scale(sign)?)?;
                }
                _ if pattern == &value => {}
                _ => return Err(self.outside(specification, blade, &value)),
            }
        }
        match remaining.terms().next() {
            Some((blade, value)) => Err(self.outside(specification, blade, value)),
            None => Ok(inputs),
        }
    }

    fn outside(&self, specification: &Specification, blade: Blade, value: &Polynomial) -> Refutation {
        let (name, value) = (&specification.basis.named(blade).name, value.display(&self.names));
        Refutation::Undefined(format!(
            "expected an argument type that holds every exponential, found none with {value} as the coefficient of `{name}`"
        ))
    }
}

/// Arithmetic on polynomials.
struct PolynomialDomain;

fn no_polynomial<T>(name: &str) -> Result<T, Refutation> {
    Err(Refutation::Undefined(format!("expected a program of ring operations, found {name}")))
}

impl Domain for PolynomialDomain {
    type Number = Polynomial;
    type Error = Refutation;

    fn constant(&self, value: Rational) -> Result<Polynomial, Refutation> {
        Ok(Polynomial::constant(value))
    }
    fn add(&self, a: &Polynomial, b: &Polynomial) -> Result<Polynomial, Refutation> {
        Ok(a.add(b)?)
    }
    fn neg(&self, a: &Polynomial) -> Result<Polynomial, Refutation> {
        Ok(a.neg())
    }
    fn mul(&self, a: &Polynomial, b: &Polynomial) -> Result<Polynomial, Refutation> {
        Ok(a.mul(b)?)
    }
    fn sqrt(&self, _: &Polynomial) -> Result<Polynomial, Refutation> {
        no_polynomial("a square root")
    }
    fn sin(&self, _: &Polynomial) -> Result<Polynomial, Refutation> {
        no_polynomial("a sine")
    }
    fn cos(&self, _: &Polynomial) -> Result<Polynomial, Refutation> {
        no_polynomial("a cosine")
    }
    fn atan2(&self, _: &Polynomial, _: &Polynomial) -> Result<Polynomial, Refutation> {
        no_polynomial("an arc tangent")
    }
    fn quotient(&self, _: &Polynomial, _: &Polynomial, _: Rational) -> Result<Polynomial, Refutation> {
        no_polynomial("a quotient")
    }
}

impl Domain for SeriesRing {
    type Number = Series;
    type Error = Refutation;

    fn constant(&self, value: Rational) -> Result<Series, Refutation> {
        Ok(self.series(&Polynomial::constant(value))?)
    }
    fn add(&self, a: &Series, b: &Series) -> Result<Series, Refutation> {
        Ok(Self::add(self, a, b)?)
    }
    fn neg(&self, a: &Series) -> Result<Series, Refutation> {
        Ok(Self::neg(self, a))
    }
    fn mul(&self, a: &Series, b: &Series) -> Result<Series, Refutation> {
        Ok(Self::mul(self, a, b)?)
    }
    fn sqrt(&self, a: &Series) -> Result<Series, Refutation> {
        Ok(Self::sqrt(self, a)?)
    }
    fn sin(&self, a: &Series) -> Result<Series, Refutation> {
        Ok(Self::sin(self, a)?)
    }
    fn cos(&self, a: &Series) -> Result<Series, Refutation> {
        Ok(Self::cos(self, a)?)
    }
    fn atan2(&self, y: &Series, x: &Series) -> Result<Series, Refutation> {
        Ok(Self::atan2(self, y, x)?)
    }
    fn quotient(&self, n: &Series, d: &Series, limit: Rational) -> Result<Series, Refutation> {
        Ok(Self::quotient(self, n, d, limit)?)
    }
}
