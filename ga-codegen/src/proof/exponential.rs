//! The proof of `exp` and `log`: formal power series wherever the norm l of the bivector B is not 0, polynomials where it is.
//!
//! The program is evaluated on power series in polar coordinates (see [`SeriesRing`]) and compared with the definition:
//! exp(B) with sum of B^n / n!, and log with B where its argument is that sum. What the output type promises is proved of
//! the same series. This is a proof to a total degree in l and the other coefficients, [`ORDER`] or one beyond the degree of
//! the program, whichever is greater, and no further: so a program that is wrong by sums and products of its inputs, such
//! as `e23^13`, is refuted, but one that is wrong by terms of higher degree alone, such as the thirteenth power of
//! 1 - cos(l), is accepted. If all terms agree, the functions, which are analytic, are equal about the identity, as far as
//! the branches of the root and of atan2 reach. An argument of log is promised to be a unit, see [`Specification`].
//!
//! What a program evaluates by a polynomial near a function counts as that function: how near it is, is measured, see
//! [`approximation`](crate::approximation).
//!
//! Where l is 0 the coefficients that make it up are 0 and the others arbitrary. There the sum ends and the program is
//! evaluated exactly, every quotient with its stated limit; see [`Locus`]. A program divides by norms alone. In exp these are 0
//! only where l is; in log, where they are those of the bivector part, also at -1 and at the negative of what is ideal alone,
//! which are as far from the identity as can be: there nothing is proved of log.

use super::locus::Locus;
use super::{Proof, Refutation, undefined};
use crate::algebra::{Blade, Product};
use crate::approximation::Function;
use crate::kernel::{Analytic, Component, ComponentValue, Entity, Specification};
use crate::program::{Domain, Operation, Program};
use crate::symbolic::{
    Monomial, Multivector, Overflow, Polynomial, Rational, Series, SeriesRing, Symbol, reciprocal_factorial,
};

/// The total degree up to which power series are compared at least.
pub const ORDER: usize = 12;

/// The greatest total degree for which power series are computed.
const MAX_ORDER: usize = 20;

/// Quotients lose up to three orders on the way, so more are carried than are compared.
const LOST_ORDERS: usize = 4;

pub(super) fn prove(specification: &Specification, program: &Program) -> Result<Proof, Refutation> {
    check_denominators(program)?;
    let unknowns = Unknowns::new(specification)?;
    let exponential = Exponential::new(specification, &unknowns, order(program)?)?;
    let (inputs, expected) = exponential.unknowns.case(specification, &exponential.sum)?;
    let ring = &exponential.ring;
    let numbers = |polynomials: &[Polynomial]| polynomials.iter().map(|p| ring.polar(p)).collect::<Result<Vec<_>, _>>();
    let computed = program.evaluate(ring, &numbers(&inputs)?)?;
    let fields = specification.output.fields().map(|(field, _)| field);
    for ((field, computed), expected) in fields.zip(&computed).zip(&numbers(&expected)?) {
        exponential.compare(field, computed, expected)?;
    }
    exponential.keep_promises(&specification.output, &computed)?;
    prove_at_zero(specification, program, &unknowns, &exponential)?;
    Ok(Proof::Series(exponential.order))
}

/// Checks that a program divides by nothing but norms and products of them, so that a denominator is 0 only where a norm is.
fn check_denominators(program: &Program) -> Result<(), Refutation> {
    let mut is_norm = Vec::with_capacity(program.operations.len());
    for operation in &program.operations {
        is_norm.push(match *operation {
            Operation::Norm(_) => true,
            Operation::Mul(a, b) => is_norm[a] && is_norm[b],
            Operation::Div(_, b) | Operation::Quotient(_, b, _) if !is_norm[b] => {
                return undefined("expected a division by a norm or a product of norms, found another");
            }
            _ => false,
        });
    }
    Ok(())
}

/// The proof where the norm of the bivector is 0: on polynomials, exactly.
fn prove_at_zero(
    specification: &Specification,
    program: &Program,
    unknowns: &Unknowns,
    exponential: &Exponential,
) -> Result<(), Refutation> {
    let restricted = unknowns.without(exponential.ring.directions())?;
    let sum = finite_exponential(&restricted.bivector, specification)?;
    let (inputs, expected) = restricted.case(specification, &sum)?;
    let computed = program.evaluate(&Locus, &inputs)?;
    let fields = specification.output.fields().map(|(field, _)| field);
    for ((field, computed), expected) in fields.zip(&computed).zip(&expected) {
        let difference = computed.sub(expected)?;
        if !difference.is_zero() {
            let place = format!("{field}, where the norm is 0");
            return Err(Refutation::Different(place, difference.display(&unknowns.names)));
        }
    }
    for statement in &specification.output.statements {
        let excess = statement.relation.polynomial().substitute(&computed)?;
        if !excess.is_zero() {
            return Err(Refutation::BrokenPromise(statement.text.clone(), excess.display(&unknowns.names)));
        }
    }
    Ok(())
}

/// sum of B^n / n! of a nilpotent B.
fn finite_exponential(bivector: &Multivector, specification: &Specification) -> Result<Multivector, Refutation> {
    let (mut sum, mut power) = (Multivector::scalar(Polynomial::one()), Multivector::scalar(Polynomial::one()));
    for n in 1..=ORDER {
        power = power.product(Product::Geometric, bivector, &specification.basis)?;
        if power.is_zero() {
            return Ok(sum);
        }
        sum = sum.add(&power.scale(reciprocal_factorial(n)?)?)?;
    }
    undefined("expected a bivector that is nilpotent where its norm is 0, found another")
}

/// The coefficients of the bivector whose exponential or logarithm is compared: the inputs of exp, the outputs of log.
struct Unknowns {
    names: Vec<String>,
    /// What each of them is at this place, in these coordinates.
    values: Vec<Polynomial>,
    bivector: Multivector,
}

impl Unknowns {
    /// Each coefficient a symbol.
    fn new(specification: &Specification) -> Result<Self, Refutation> {
        let (names, bivector) = if specification.analytic == Some(Analytic::Exp) {
            if !specification.relations.is_empty() {
                return undefined(
                    "expected an argument of exp whose coefficients are free, found relations between them",
                );
            }
            (specification.names(), specification.value.clone())
        } else {
            let [input] = specification.inputs.as_slice() else {
                return undefined("expected one input of log, found another number");
            };
            if input != &specification.value {
                return undefined("expected the input itself as the argument of log, found an expression");
            }
            let names = specification.output.fields().map(|(field, _)| field.to_owned()).collect();
            (names, specification.output.symbolic(0))
        };
        let constant = |(_, c): (Blade, &Polynomial)| !c.coefficient(&Monomial::default()).is_zero();
        if bivector.terms().any(|(blade, _)| blade.grade() != 2) || bivector.terms().any(constant) {
            return undefined(
                "expected a bivector without constant coefficients as the argument of exp, found another multivector",
            );
        }
        let names: Vec<String> = names;
        let values = (0..names.len()).map(|symbol| Polynomial::symbol(symbol as Symbol)).collect();
        Ok(Self { names, values, bivector })
    }

    /// The same with every polynomial mapped.
    fn map(
        &self,
        names: Vec<String>,
        map: impl Fn(&Polynomial) -> Result<Polynomial, Overflow>,
    ) -> Result<Self, Refutation> {
        let values = self.values.iter().map(&map).collect::<Result<_, _>>()?;
        Ok(Self { names, values, bivector: self.bivector.map(map)? })
    }

    /// The same where some of the coefficients are 0.
    fn without(&self, symbols: &[Symbol]) -> Result<Self, Refutation> {
        let is_free = |monomial: &Monomial| symbols.iter().all(|&symbol| monomial.power(symbol) == 0);
        self.map(self.names.clone(), |polynomial| {
            let mut rest = Polynomial::zero();
            for (monomial, coefficient) in polynomial.terms().filter(|(monomial, _)| is_free(monomial)) {
                rest.add_term(monomial.clone(), coefficient)?;
            }
            Ok(rest)
        })
    }

    /// What a program is given and what it should make of it, where the exponential of the bivector is `sum`.
    fn case(
        &self,
        specification: &Specification,
        sum: &Multivector,
    ) -> Result<(Vec<Polynomial>, Vec<Polynomial>), Refutation> {
        match specification.analytic {
            Some(Analytic::Exp) => Ok((self.values.clone(), fields(specification, sum, &self.names)?)),
            _ => Ok((arguments(specification, sum, &self.names)?, self.values.clone())),
        }
    }
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

/// The exponential series of a bivector in polar coordinates, and the ring of its coefficients.
struct Exponential {
    order: usize,
    ring: SeriesRing,
    unknowns: Unknowns,
    sum: Multivector,
}

impl Exponential {
    /// sum of B^n / n!, for a comparison to this order.
    fn new(specification: &Specification, unknowns: &Unknowns, order: usize) -> Result<Self, Refutation> {
        let (carried, basis, bivector) = (order + LOST_ORDERS, &specification.basis, &unknowns.bivector);
        let square = bivector.product(Product::Geometric, bivector, basis)?.coefficient(Blade::SCALAR).neg();
        let ring = SeriesRing::new(carried, unknowns.names.len() as Symbol, &square)?;
        let mut names = unknowns.names.clone();
        for &direction in ring.directions() {
            names[usize::from(direction)].push_str("/l");
        }
        names.push("l".to_owned());
        let unknowns = unknowns.map(names, |polynomial| Ok(ring.series(polynomial)?.polynomial().clone()))?;
        let mut sum = Multivector::scalar(Polynomial::one());
        let mut power = sum.clone();
        for n in 1..=carried {
            let next = power.product(Product::Geometric, &unknowns.bivector, basis)?;
            power = next.map(|c| Ok::<_, Refutation>(ring.polar(c)?.polynomial().clone()))?;
            sum = sum.add(&power.scale(reciprocal_factorial(n)?)?)?;
        }
        Ok(Self { order, ring, unknowns, sum })
    }

    /// Compares two series to the order of the proof.
    fn compare(&self, name: &str, computed: &Series, specified: &Series) -> Result<(), Refutation> {
        let difference = self.ring.add(computed, &self.ring.neg(specified))?;
        if difference.order() < self.order {
            return Err(Refutation::Imprecise(name.to_owned(), self.order));
        }
        let low = self.low_terms(&difference)?;
        if low.is_zero() {
            Ok(())
        } else {
            Err(Refutation::Different(name.to_owned(), low.display(&self.unknowns.names)))
        }
    }

    fn low_terms(&self, series: &Series) -> Result<Polynomial, Overflow> {
        let mut low = Polynomial::zero();
        for (monomial, coefficient) in series.polynomial().terms().filter(|(m, _)| self.ring.degree(m) <= self.order) {
            low.add_term(monomial.clone(), coefficient)?;
        }
        Ok(low)
    }

    /// Proves the relations of the output type on the computed series.
    fn keep_promises(&self, entity: &Entity, fields: &[Series]) -> Result<(), Refutation> {
        for statement in &entity.statements {
            let mut sum = self.ring.polar(&Polynomial::zero())?;
            for (monomial, coefficient) in statement.relation.polynomial().terms() {
                let mut product = self.ring.polar(&Polynomial::constant(coefficient))?;
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
                return Err(Refutation::BrokenPromise(statement.text.clone(), excess.display(&self.unknowns.names)));
            }
        }
        Ok(())
    }
}

/// The coefficients of a multivector in the fields of the output, once that is known to hold all of them.
fn fields(specification: &Specification, value: &Multivector, names: &[String]) -> Result<Vec<Polynomial>, Refutation> {
    let entity = &specification.output;
    for named in specification.basis.blades() {
        let component = entity.components.iter().find(|component| component.blade == named.blade);
        let expected = match component.map(|component| (&component.value, component.sign)) {
            Some((ComponentValue::Field(_), _)) => continue,
            Some((ComponentValue::Constant(constant), sign)) => Polynomial::constant(*constant).signed(sign),
            None => Polynomial::zero(),
        };
        let difference = value.coefficient(named.blade).sub(&expected)?;
        if !difference.is_zero() && component.is_none() {
            return Err(Refutation::CannotHold(named.name.clone()));
        }
        if !difference.is_zero() {
            return Err(Refutation::Different(named.name.clone(), difference.neg().display(names)));
        }
    }
    let field = |(_, component): (&str, &Component)| value.coefficient(component.blade).signed(component.sign);
    Ok(entity.fields().map(field).collect())
}

/// The input coefficients of a logarithm whose argument is an exponential.
fn arguments(
    specification: &Specification,
    exponential: &Multivector,
    names: &[String],
) -> Result<Vec<Polynomial>, Refutation> {
    let outside = |blade: Blade, value: &Polynomial| {
        let (name, value) = (&specification.basis.named(blade).name, value.display(names));
        Refutation::Undefined(format!(
            "expected an argument type that holds every exponential, found none with {value} as the coefficient of `{name}`"
        ))
    };
    let mut remaining = exponential.clone();
    let mut inputs = vec![Polynomial::zero(); specification.coefficients.len()];
    for (blade, pattern) in specification.value.terms() {
        let value = remaining.coefficient(blade);
        remaining = remaining.sub(&Multivector::term(blade, value.clone()))?;
        let mut terms = pattern.terms();
        match (terms.next(), terms.next()) {
            (Some((monomial, sign)), None) if monomial.degree() == 1 => {
                inputs[usize::from(monomial.symbols()[0])] = value.scale(sign)?;
            }
            _ if pattern == &value => {}
            _ => return Err(outside(blade, &value)),
        }
    }
    match remaining.terms().next() {
        Some((blade, value)) => Err(outside(blade, value)),
        None => Ok(inputs),
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
    fn div(&self, a: &Series, b: &Series) -> Result<Series, Refutation> {
        Ok(Self::quotient(self, a, b)?)
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
        let _ = limit; // Where the denominator is 0 is seen to by [`Locus`].
        Ok(Self::quotient(self, n, d)?)
    }
    fn function(&self, function: Function, a: &Series) -> Result<Series, Refutation> {
        Ok(self.compose(a, |n| function.series(n as u32))?)
    }
}
