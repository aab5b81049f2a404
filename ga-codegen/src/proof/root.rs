//! The proof of `normalize` and `sqrt`: polynomials, fractions and square roots.
//!
//! The program is evaluated on fractions of polynomials in the inputs and in a symbol r for every root that it takes,
//! modulo the inputs' relations and r^2 = P, where P, a polynomial, is what the root is taken of. Roots of equal P, modulo
//! the relations, are the same symbol. Fractions are equal where their cross products are; that is an identity of numbers
//! wherever no denominator is 0, and none is 0 modulo the relations. A symbol r stands for the root that is not negative, as
//! the square root of numbers is.
//!
//! Let y be what is normalised and y ~y = A + N its norm, A a number and N of square 0 and commuting with y. The norm's
//! root with a positive scalar part is w = sqrt(A) + N / (2 sqrt(A)). The output x must satisfy
//! ```text
//! x w = y,  that is,  x (2 A + N) = 2 sqrt(A) y,
//! ```
//! with the same symbol for sqrt(A) as in the program, which settles the sign; w has an inverse where A is not 0, so there is
//! one such x. The square root of m is 1 + m normalised, and x^2 = m is proved of it besides. What the output type
//! promises is proved of x too.

use super::{Proof, Refutation, undefined};
use crate::algebra::{Blade, Product};
use crate::approximation::Function;
use crate::kernel::{Analytic, ComponentValue, Specification, StudyNorm};
use crate::program::{Domain, Program};
use crate::symbolic::{Monomial, Multivector, Overflow, Polynomial, Rational, Relations, Symbol};
use std::cell::RefCell;

pub(super) fn prove(specification: &Specification, program: &Program) -> Result<Proof, Refutation> {
    let field = Fractions::new(specification);
    let inputs: Vec<_> =
        (0..specification.coefficients.len()).map(|s| Fraction::whole(Polynomial::symbol(s as Symbol))).collect();
    let computed = program.evaluate(&field, &inputs)?;
    let y = specification.unnormalized()?;
    let study = specification.study_norm("").map_err(|error| Refutation::Undefined(error.to_string()))?;
    let root = field.sqrt(&Fraction::whole(study.scalar.clone()))?.numerator;
    let (x, denominator) = common_denominator(specification, &computed)?;
    let proof = Roots { specification, field: &field, x, denominator };
    proof.is_normalized(&y, &study, &root)?;
    if specification.analytic == Some(Analytic::Sqrt) {
        proof.squares_to(&specification.value)?;
    }
    keep_promises(specification, &field, &computed)?;
    Ok(Proof::Roots)
}

/// The output as a multivector over one denominator.
fn common_denominator(
    specification: &Specification,
    computed: &[Fraction],
) -> Result<(Multivector, Polynomial), Overflow> {
    let mut distinct: Vec<&Polynomial> = Vec::new();
    for fraction in computed {
        if !distinct.contains(&&fraction.denominator) {
            distinct.push(&fraction.denominator);
        }
    }
    let product_without = |left_out: Option<&Polynomial>| {
        let factors = distinct.iter().filter(|factor| Some(**factor) != left_out);
        factors.copied().try_fold(Polynomial::one(), |product, factor| product.mul(factor))
    };
    let denominator = product_without(None)?;
    let mut terms = Vec::new();
    let mut computed = computed.iter();
    for component in &specification.output.components {
        let value = match (&component.value, computed.as_slice()) {
            (ComponentValue::Constant(constant), _) => denominator.scale(*constant)?,
            (ComponentValue::Field(_), [fraction, rest @ ..]) => {
                computed = rest.iter();
                fraction.numerator.mul(&product_without(Some(&fraction.denominator))?)?
            }
            (ComponentValue::Field(_), []) => unreachable!("invariant: as many outputs as fields"),
        };
        terms.push((component.blade, value.signed(component.sign)));
    }
    Ok((Multivector::from_terms(terms), denominator))
}

/// The output x / denominator, of which is proved that it is a root or a unit.
struct Roots<'a> {
    specification: &'a Specification,
    field: &'a Fractions,
    x: Multivector,
    denominator: Polynomial,
}

impl Roots<'_> {
    /// x (2 A + N) = 2 sqrt(A) y
    fn is_normalized(&self, y: &Multivector, study: &StudyNorm, root: &Polynomial) -> Result<(), Refutation> {
        let two = Rational::integer(2);
        let twice_norm = Multivector::scalar(study.scalar.scale(two)?).add(&study.nilpotent)?;
        let left = self.x.product(Product::Geometric, &twice_norm, &self.specification.basis)?;
        let factor = root.mul(&self.denominator)?.scale(two)?;
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
                return Err(Refutation::Different(name.to_owned(), excess.display(&self.field.names())));
            }
        }
        Ok(())
    }
}

/// Proves the relations of the output type.
fn keep_promises(specification: &Specification, field: &Fractions, computed: &[Fraction]) -> Result<(), Refutation> {
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
            let excess = sum.numerator.display(&field.names());
            return Err(Refutation::BrokenPromise(statement.text.clone(), excess));
        }
    }
    Ok(())
}

/// A fraction; both parts in normal form, the denominator not 0.
#[derive(Clone, Debug)]
struct Fraction {
    numerator: Polynomial,
    denominator: Polynomial,
}

impl Fraction {
    fn whole(numerator: Polynomial) -> Self {
        Self { numerator, denominator: Polynomial::one() }
    }
}

/// Arithmetic on fractions of polynomials in inputs and roots.
struct Fractions {
    names: Vec<String>,
    roots: RefCell<Adjoined>,
}

/// The roots so far, and the relations with theirs.
struct Adjoined {
    relations: Relations,
    radicands: Vec<Polynomial>,
}

impl Fractions {
    fn new(specification: &Specification) -> Self {
        let roots = Adjoined { relations: specification.relations.clone(), radicands: Vec::new() };
        Self { names: specification.names(), roots: RefCell::new(roots) }
    }

    fn normal_form(&self, polynomial: &Polynomial) -> Result<Polynomial, Overflow> {
        self.roots.borrow().relations.normal_form(polynomial)
    }

    fn names(&self) -> Vec<String> {
        let roots = (1..=self.roots.borrow().radicands.len()).map(|n| format!("root{n}"));
        self.names.iter().cloned().chain(roots).collect()
    }

    fn fraction(&self, numerator: &Polynomial, denominator: &Polynomial) -> Result<Fraction, Refutation> {
        let (numerator, denominator) = (self.normal_form(numerator)?, self.normal_form(denominator)?);
        if denominator.is_zero() {
            return undefined("expected a denominator other than 0, found one that is 0 for every input");
        }
        Ok(Fraction { numerator, denominator })
    }
}

impl Domain for Fractions {
    type Number = Fraction;
    type Error = Refutation;

    fn constant(&self, value: Rational) -> Result<Fraction, Refutation> {
        Ok(Fraction::whole(Polynomial::constant(value)))
    }
    fn add(&self, a: &Fraction, b: &Fraction) -> Result<Fraction, Refutation> {
        if a.denominator == b.denominator {
            return self.fraction(&a.numerator.add(&b.numerator)?, &a.denominator);
        }
        let numerator = a.numerator.mul(&b.denominator)?.add(&b.numerator.mul(&a.denominator)?)?;
        self.fraction(&numerator, &a.denominator.mul(&b.denominator)?)
    }
    fn neg(&self, a: &Fraction) -> Result<Fraction, Refutation> {
        Ok(Fraction { numerator: a.numerator.neg(), denominator: a.denominator.clone() })
    }
    fn mul(&self, a: &Fraction, b: &Fraction) -> Result<Fraction, Refutation> {
        self.fraction(&a.numerator.mul(&b.numerator)?, &a.denominator.mul(&b.denominator)?)
    }
    fn div(&self, a: &Fraction, b: &Fraction) -> Result<Fraction, Refutation> {
        self.fraction(&a.numerator.mul(&b.denominator)?, &a.denominator.mul(&b.numerator)?)
    }
    fn sqrt(&self, a: &Fraction) -> Result<Fraction, Refutation> {
        if a.denominator != Polynomial::one() {
            return undefined("expected a polynomial under a root, found a fraction");
        }
        let radicand = self.normal_form(&a.numerator)?;
        let first = self.names.len() as Symbol;
        let mut roots = self.roots.borrow_mut();
        if let Some(known) = roots.radicands.iter().position(|other| *other == radicand) {
            return Ok(Fraction::whole(Polynomial::symbol(first + known as Symbol)));
        }
        if radicand.is_zero() {
            return undefined("expected something other than 0 under a root, found what is 0 for every input");
        }
        let root = first + roots.radicands.len() as Symbol;
        if radicand.terms().any(|(monomial, _)| monomial.symbols().iter().any(|&symbol| symbol >= first)) {
            return undefined("expected no root under a root, found one");
        }
        roots.relations = roots.relations.with_square(root, radicand.clone());
        roots.radicands.push(radicand);
        Ok(Fraction::whole(Polynomial::term(Monomial::new(vec![root]), Rational::ONE)))
    }
    fn sin(&self, _: &Fraction) -> Result<Fraction, Refutation> {
        undefined("expected a program of ring operations, roots and divisions, found a sine")
    }
    fn cos(&self, _: &Fraction) -> Result<Fraction, Refutation> {
        undefined("expected a program of ring operations, roots and divisions, found a cosine")
    }
    fn atan2(&self, _: &Fraction, _: &Fraction) -> Result<Fraction, Refutation> {
        undefined("expected a program of ring operations, roots and divisions, found an arc tangent")
    }
    fn quotient(&self, _: &Fraction, _: &Fraction, _: Rational) -> Result<Fraction, Refutation> {
        undefined("expected a program of ring operations, roots and divisions, found a quotient with a limit")
    }
    fn function(&self, function: Function, _: &Fraction) -> Result<Fraction, Refutation> {
        undefined(&format!("expected a program of ring operations, roots and divisions, found {}", function.name()))
    }
}
