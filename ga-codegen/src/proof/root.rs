//! The proof of `normalize` and `sqrt`: polynomials over powers of one square root.
//!
//! Let y be what is normalised and y ~y = A + N its norm, A a sum of squares of real numbers and N of square 0 and
//! commuting with y. The program is evaluated on polynomials in the inputs and in a symbol r, modulo the inputs' relations
//! and r^2 = A, over powers of r. It may take no other root than that of A, up to a rational square, and divide by nothing
//! but rational multiples of powers of r. So wherever A is not 0 every value is a real number, and equal polynomials are
//! equal numbers; r stands for the root that is not negative, as the square root of numbers is.
//!
//! The norm's root with a positive scalar part is w = r + N / (2 r). The output x must satisfy
//! ```text
//! x w = y,  that is,  x (2 A + N) = 2 r y,
//! ```
//! with the program's own r, which settles the sign; w has an inverse where A is not 0, so there is one such x. The square root
//! of m is 1 + m normalised, and x^2 = m is proved of it besides. What the output type promises is proved of x too.
//! Where A is 0 nothing is proved: there is no such x.

use super::{Proof, Refutation, undefined};
use crate::algebra::{Blade, Product};
use crate::approximation::Function;
use crate::kernel::{Analytic, Component, ComponentValue, Specification, StudyNorm};
use crate::program::{Domain, Program};
use crate::symbolic::{Monomial, Multivector, Overflow, Polynomial, Rational, Relations, Symbol};

pub(super) fn prove(specification: &Specification, program: &Program) -> Result<Proof, Refutation> {
    let study = specification.study_norm("").map_err(|error| Refutation::Undefined(error.to_string()))?;
    let field = Quotients::new(specification, &study.scalar)?;
    let inputs: Vec<_> =
        (0..specification.coefficients.len()).map(|s| Quotient::whole(Polynomial::symbol(s as Symbol))).collect();
    let computed = program.evaluate(&field, &inputs)?;
    let y = specification.unnormalized()?;
    let power = computed.iter().map(|quotient| quotient.power).max().unwrap_or(0);
    let x = output(specification, &field, &computed, power)?;
    let proof = Roots { specification, field: &field, x, denominator: field.root_power(power)? };
    proof.is_normalized(&y, &study)?;
    if specification.analytic == Some(Analytic::Sqrt) {
        proof.squares_to(&specification.value)?;
    }
    keep_promises(specification, &field, &computed)?;
    Ok(Proof::Roots)
}

/// The output as a multivector, times this power of the root.
fn output(
    specification: &Specification,
    field: &Quotients,
    computed: &[Quotient],
    power: usize,
) -> Result<Multivector, Refutation> {
    let mut fields = computed.iter();
    let coefficient = |component: &Component| {
        let value = match &component.value {
            ComponentValue::Constant(constant) => field.root_power(power)?.scale(*constant)?,
            ComponentValue::Field(_) => match fields.next() {
                Some(quotient) => quotient.numerator.mul(&field.root_power(power - quotient.power)?)?,
                None => Polynomial::zero(),
            },
        };
        Ok::<_, Refutation>((component.blade, value.signed(component.sign)))
    };
    let terms: Vec<_> = specification.output.components.iter().map(coefficient).collect::<Result<_, _>>()?;
    Ok(Multivector::from_terms(terms))
}

/// The output x / denominator, of which is proved that it is a root or a unit.
struct Roots<'a> {
    specification: &'a Specification,
    field: &'a Quotients,
    x: Multivector,
    denominator: Polynomial,
}

impl Roots<'_> {
    /// x (2 A + N) = 2 r y
    fn is_normalized(&self, y: &Multivector, study: &StudyNorm) -> Result<(), Refutation> {
        let two = Rational::integer(2);
        let twice_norm = Multivector::scalar(study.scalar.scale(two)?).add(&study.nilpotent)?;
        let left = self.x.product(Product::Geometric, &twice_norm, &self.specification.basis)?;
        let factor = self.field.root.mul(&self.denominator)?.scale(two)?;
        self.is_zero(&left.sub(&y.map(|coefficient| coefficient.mul(&factor))?)?)
    }

    /// x^2 = m
    fn squares_to(&self, m: &Multivector) -> Result<(), Refutation> {
        let square = self.x.product(Product::Geometric, &self.x, &self.specification.basis)?;
        let factor = self.denominator.mul(&self.denominator)?;
        self.is_zero(&square.sub(&m.map(|coefficient| coefficient.mul(&factor))?)?)
    }

    fn is_zero(&self, difference: &Multivector) -> Result<(), Refutation> {
        for (blade, coefficient) in difference.terms() {
            let excess = self.field.normal_form(coefficient)?;
            if !excess.is_zero() {
                let name = if blade == Blade::SCALAR { "1" } else { &self.specification.basis.named(blade).name };
                return Err(Refutation::Different(name.to_owned(), excess.display(&self.field.names)));
            }
        }
        Ok(())
    }
}

/// Proves the relations of the output type.
fn keep_promises(specification: &Specification, field: &Quotients, computed: &[Quotient]) -> Result<(), Refutation> {
    for statement in &specification.output.statements {
        let mut sum = field.constant(Rational::ZERO)?;
        for (monomial, coefficient) in statement.relation.polynomial().terms() {
            let mut product = field.constant(coefficient)?;
            for &symbol in monomial.symbols() {
                product = field.mul(&product, &computed[usize::from(symbol)])?;
            }
            sum = field.add(&sum, &product)?;
        }
        if !sum.numerator.is_zero() {
            let excess = sum.numerator.display(&field.names);
            return Err(Refutation::BrokenPromise(statement.text.clone(), excess));
        }
    }
    Ok(())
}

/// numerator / r^power, the numerator in normal form.
#[derive(Clone, Debug)]
struct Quotient {
    numerator: Polynomial,
    power: usize,
}

impl Quotient {
    fn whole(numerator: Polynomial) -> Self {
        Self { numerator, power: 0 }
    }
}

/// Arithmetic on polynomials over powers of the root r of A.
struct Quotients {
    names: Vec<String>,
    relations: Relations,
    square: Polynomial,
    /// r, or the number that it is.
    root: Polynomial,
}

impl Quotients {
    fn new(specification: &Specification, square: &Polynomial) -> Result<Self, Refutation> {
        let mut names = specification.names();
        let symbol = names.len() as Symbol;
        names.push("r".to_owned());
        let relations = specification.relations.with_square(symbol, square.clone());
        let number = square.as_constant().and_then(Rational::exact_root);
        let root =
            number.map_or_else(|| Polynomial::term(Monomial::new(vec![symbol]), Rational::ONE), Polynomial::constant);
        Ok(Self { names, relations, square: square.clone(), root })
    }

    fn normal_form(&self, polynomial: &Polynomial) -> Result<Polynomial, Overflow> {
        self.relations.normal_form(polynomial)
    }

    /// r^power
    fn root_power(&self, power: usize) -> Result<Polynomial, Overflow> {
        let mut product = Polynomial::one();
        for _ in 0..power {
            product = self.normal_form(&product.mul(&self.root)?)?;
        }
        Ok(product)
    }

    fn over(&self, numerator: &Polynomial, power: usize) -> Result<Quotient, Refutation> {
        Ok(Quotient { numerator: self.normal_form(numerator)?, power })
    }

    /// The rational number that a polynomial is a multiple of another by, if it is one.
    fn ratio(&self, a: &Polynomial, b: &Polynomial) -> Result<Option<Rational>, Overflow> {
        let (Some((first, coefficient)), false) = (b.terms().next(), a.is_zero()) else { return Ok(None) };
        let Some(ratio) = a.coefficient(first).checked_div(coefficient)? else { return Ok(None) };
        Ok((b.scale(ratio)? == *a).then_some(ratio))
    }
}

/// The greatest power of the root by which a program may divide at once.
const MAX_POWER: usize = 4;

impl Domain for Quotients {
    type Number = Quotient;
    type Error = Refutation;

    fn constant(&self, value: Rational) -> Result<Quotient, Refutation> {
        Ok(Quotient::whole(Polynomial::constant(value)))
    }
    fn add(&self, a: &Quotient, b: &Quotient) -> Result<Quotient, Refutation> {
        let power = a.power.max(b.power);
        let raised = |quotient: &Quotient| quotient.numerator.mul(&self.root_power(power - quotient.power)?);
        self.over(&raised(a)?.add(&raised(b)?)?, power)
    }
    fn neg(&self, a: &Quotient) -> Result<Quotient, Refutation> {
        Ok(Quotient { numerator: a.numerator.neg(), power: a.power })
    }
    fn mul(&self, a: &Quotient, b: &Quotient) -> Result<Quotient, Refutation> {
        self.over(&a.numerator.mul(&b.numerator)?, a.power + b.power)
    }
    fn div(&self, a: &Quotient, b: &Quotient) -> Result<Quotient, Refutation> {
        for power in 0..=MAX_POWER {
            if let Some(ratio) = self.ratio(&b.numerator, &self.root_power(power)?)? {
                let inverse = Rational::ONE.checked_div(ratio)?.ok_or(Overflow)?;
                let numerator = a.numerator.mul(&self.root_power(b.power)?)?.scale(inverse)?;
                return self.over(&numerator, a.power + power);
            }
        }
        undefined("expected a division by a multiple of a power of the norm's root, found another")
    }
    fn sqrt(&self, a: &Quotient) -> Result<Quotient, Refutation> {
        let number = a.numerator.as_constant().filter(|_| a.power == 0).and_then(Rational::exact_root);
        if let Some(number) = number {
            return self.constant(number);
        }
        let factor = self.ratio(&a.numerator, &self.square)?.filter(|_| a.power == 0).and_then(Rational::exact_root);
        match factor {
            Some(factor) => self.over(&self.root.scale(factor)?, 0),
            None => undefined("expected the root of a rational square times the norm, found another root"),
        }
    }
    fn sin(&self, _: &Quotient) -> Result<Quotient, Refutation> {
        undefined("expected a program of ring operations, roots and divisions, found a sine")
    }
    fn cos(&self, _: &Quotient) -> Result<Quotient, Refutation> {
        undefined("expected a program of ring operations, roots and divisions, found a cosine")
    }
    fn atan2(&self, _: &Quotient, _: &Quotient) -> Result<Quotient, Refutation> {
        undefined("expected a program of ring operations, roots and divisions, found an arc tangent")
    }
    fn quotient(&self, _: &Quotient, _: &Quotient, _: Rational) -> Result<Quotient, Refutation> {
        undefined("expected a program of ring operations, roots and divisions, found a quotient with a limit")
    }
    fn function(&self, function: Function, _: &Quotient) -> Result<Quotient, Refutation> {
        undefined(&format!("expected a program of ring operations, roots and divisions, found {}", function.name()))
    }
}
