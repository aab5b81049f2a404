//! The exact meaning of a kernel: polynomials over the coefficients of its inputs, and what holds between those.

use super::{Component, ComponentValue, Definition, Entity, Expression, Kernel, Projection};
use crate::algebra::{Basis, Blade, Product, Signature};
use crate::limits::MAX_COEFFICIENTS;
use crate::symbolic::{
    Monomial, Multivector, Overflow, Polynomial, Rational, Relation, Relations, RelationsError, Symbol,
};
use std::fmt;

/// A function of a multivector that is not a polynomial.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Analytic {
    /// exp(B) = sum of B^n / n!, for a bivector B.
    Exp,
    /// The inverse of exp near the identity.
    Log,
    /// The x with x w = y for a y whose norm y ~y is a Study number, its scalar part A positive and the rest N of square 0
    /// and commuting with y; w = sqrt(A) + N / (2 sqrt(A)) is the norm's root. So x ~x = 1.
    Normalize,
    /// The square root of a unit: 1 + m normalised.
    Sqrt,
}

impl Analytic {
    /// Every function, by the name that it has in a definition.
    pub const ALL: [(&'static str, Self); 4] =
        [("exp", Self::Exp), ("log", Self::Log), ("normalize", Self::Normalize), ("sqrt", Self::Sqrt)];

    /// Its name in a definition.
    pub fn name(self) -> &'static str {
        Self::ALL.iter().find(|(_, analytic)| *analytic == self).map_or("?", |(name, _)| name)
    }
}

/// y ~y of a multivector y, where it is a Study number.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct StudyNorm {
    /// The scalar part, in normal form.
    pub scalar: Polynomial,
    /// The rest, in normal form: its square is 0 and it commutes with y.
    pub nilpotent: Multivector,
}

/// A free coefficient of an input.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Coefficient {
    /// The index of the parameter.
    pub parameter: usize,
    /// The field; empty for a plain scalar.
    pub field: String,
    /// The name in messages, such as `m.e23`.
    pub name: String,
    /// Its degree in the unit of length: how many null generators its blade has.
    pub degree: u32,
}

/// The exact meaning of a kernel.
#[derive(Clone, Debug)]
pub struct Specification {
    /// The inputs' free coefficients; a symbol is an index into this list.
    pub coefficients: Vec<Coefficient>,
    /// What holds between the symbols.
    pub relations: Relations,
    /// The same as it was stated: polynomials that are 0.
    pub stated: Vec<Polynomial>,
    /// The inputs as multivectors.
    pub inputs: Vec<Multivector>,
    /// The function of `value` that the kernel is, where it is not polynomial.
    pub analytic: Option<Analytic>,
    /// The definition, or the argument of the analytic function.
    pub expression: Expression,
    /// The same expanded, not reduced by the relations.
    pub value: Multivector,
    /// The output type.
    pub output: Entity,
    /// The names of what is computed: the fields of the output type, or of a record.
    pub fields: Vec<String>,
    /// The specified polynomials, one for each of [`Specification::fields`]; none for an analytic kernel.
    pub outputs: Vec<Polynomial>,
    /// Where the fields of a record come from.
    pub projection: Option<Projection>,
    /// The names and orientations of blades.
    pub basis: Basis,
}

/// Why a kernel has no meaning.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum SpecificationError {
    /// [`Overflow`]
    Overflow,
    /// More symbols than are supported.
    TooLarge,
    /// The inputs' relations together have no normal form.
    Relations(RelationsError),
    /// The expression has a coefficient that the output type cannot hold: blade and normal form.
    CannotHold(String, String),
    /// The output type fixes a coefficient that the expression does not meet: blade, fixed value, normal form.
    WrongConstant(String, String, String),
    /// The argument of `exp` has a coefficient of another grade than 2: blade and polynomial.
    NotABivector(String, String),
    /// The argument of `log` or `sqrt` is not promised to be a unit: its text m, and m ~m.
    NotAUnit(String, String),
    /// The norm y ~y of what is to be normalised is no Study number.
    NotAStudyNumber(String),
    /// The norm y ~y of what is to be normalised can be negative: y, and a blade whose norm is.
    IndefiniteNorm(String, String),
    /// The argument of `exp` has a coefficient that is no multiple of one input coefficient: blade and polynomial.
    CompoundCoefficient(String, String),
    /// The output type has a relation that the expression does not satisfy: its text and the normal form of the excess.
    BrokenPromise(String, String),
}

impl From<Overflow> for SpecificationError {
    fn from(_: Overflow) -> Self {
        Self::Overflow
    }
}

impl fmt::Display for SpecificationError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Overflow => Overflow.fmt(f),
            Self::TooLarge => write!(f, "expected at most {MAX_COEFFICIENTS} input coefficients, found more"),
            Self::Relations(_) => f.write_str("expected relations with a confluent normal form, found none"),
            Self::CannotHold(blade, value) => {
                write!(f, "expected an output that can hold `{blade}`, found none: its coefficient is {value}")
            }
            Self::WrongConstant(blade, constant, value) => {
                write!(f, "expected the coefficient {constant} of `{blade}` that the output type fixes, found {value}")
            }
            Self::NotABivector(blade, value) => {
                write!(
                    f,
                    "expected a bivector as the argument of `exp`, found one with {value} as the coefficient of `{blade}`"
                )
            }
            Self::NotAUnit(m, norm) => {
                write!(f, "expected a unit, x ~x = 1 for x = {m}, found x ~x = {norm}")
            }
            Self::IndefiniteNorm(y, blade) => {
                write!(
                    f,
                    "expected a norm x ~x that is nowhere negative, for x = {y}, found that `{blade}` has a negative one"
                )
            }
            Self::CompoundCoefficient(blade, value) => {
                write!(
                    f,
                    "expected multiples of single input coefficients in the argument of `exp`, found {value} as the coefficient \
                     of `{blade}`"
                )
            }
            Self::NotAStudyNumber(y) => {
                write!(
                    f,
                    "expected a norm x ~x that is a number plus what squares to 0 and commutes with x, for x = {y}, found \
                     another"
                )
            }
            Self::BrokenPromise(relation, value) => {
                write!(f, "expected an output with `{relation}`, found a difference of {value}")
            }
        }
    }
}

impl std::error::Error for SpecificationError {}

/// Inputs of given types with every free coefficient a symbol of its own.
struct Instance {
    coefficients: Vec<Coefficient>,
    multivectors: Vec<Multivector>,
    relations: Vec<Relation>,
}

impl Instance {
    fn new<'a>(
        signature: Signature,
        inputs: impl IntoIterator<Item = (&'a str, &'a Entity)>,
    ) -> Result<Self, SpecificationError> {
        let mut instance = Self { coefficients: Vec::new(), multivectors: Vec::new(), relations: Vec::new() };
        for (parameter, (name, entity)) in inputs.into_iter().enumerate() {
            let first = instance.coefficients.len() as Symbol;
            instance.multivectors.push(entity.symbolic(first));
            instance.relations.extend(entity.statements.iter().map(|statement| statement.relation.shifted(first)));
            let degree = |component: &Component| component.blade.null_degree(signature);
            instance.coefficients.extend(entity.fields().map(|(field, component)| Coefficient {
                parameter,
                field: field.to_owned(),
                name: if field.is_empty() { name.to_owned() } else { format!("{name}.{field}") },
                degree: degree(component),
            }));
            if instance.coefficients.len() > MAX_COEFFICIENTS {
                return Err(SpecificationError::TooLarge);
            }
        }
        Ok(instance)
    }
}

impl Specification {
    /// The meaning of a kernel.
    ///
    /// # Errors
    /// An output type that cannot hold the value or whose promises the value does not keep, for polynomial kernels; for
    /// analytic ones the proof decides that. An argument of `exp` that is no bivector, one of `log` that is not promised
    /// to be a unit, so that it may be no exponential. Relations without normal form; overflow.
    pub fn new(definition: &Definition, kernel: &Kernel) -> Result<Self, SpecificationError> {
        let typed = kernel.parameters.iter().map(|p| (p.name.as_str(), &definition.entities[p.entity]));
        let Instance { coefficients, multivectors: inputs, mut relations } =
            Instance::new(definition.basis.signature(), typed)?;
        relations.extend(kernel.statements.iter().map(|statement| statement.relation.clone()));
        let stated = relations.iter().map(|relation| relation.polynomial().clone()).collect();
        let relations = Relations::new(&relations).map_err(SpecificationError::Relations)?;
        let value = kernel.expression.evaluate(&inputs, &definition.basis)?;
        let expression = kernel.expression.clone();
        let output = definition.entities[kernel.output].clone();
        let basis = definition.basis.clone();
        let fields = output.fields().map(|(field, _)| field.to_owned()).collect();
        let coefficient = |(_, c): (&str, &Component)| value.coefficient(c.blade).signed(c.sign);
        let outputs = match kernel.analytic {
            None => output.fields().map(coefficient).collect(),
            Some(_) => Vec::new(),
        };
        let specification = Self {
            coefficients,
            relations,
            stated,
            inputs,
            analytic: kernel.analytic,
            expression,
            value,
            output,
            fields,
            outputs,
            projection: None,
            basis,
        };
        match specification.analytic {
            None => specification.check_output()?,
            Some(Analytic::Exp) => specification.check_bivector()?,
            Some(Analytic::Log) => specification.check_unit(&specification.argument(kernel))?,
            Some(Analytic::Sqrt) => {
                specification.check_unit(&specification.argument(kernel))?;
                specification.study_norm(&specification.argument(kernel))?;
            }
            Some(Analytic::Normalize) => {
                specification.study_norm(&specification.argument(kernel))?;
            }
        }
        Ok(specification)
    }

    /// The text of the expression.
    fn argument(&self, kernel: &Kernel) -> String {
        let names: Vec<_> = kernel.parameters.iter().map(|parameter| parameter.name.as_str()).collect();
        self.expression.display(&names)
    }

    /// What `normalize` or `sqrt` normalises: the value, or one more.
    ///
    /// # Errors
    /// [`Overflow`]
    pub fn unnormalized(&self) -> Result<Multivector, Overflow> {
        match self.analytic {
            Some(Analytic::Sqrt) => self.value.add(&Multivector::scalar(Polynomial::one())),
            _ => Ok(self.value.clone()),
        }
    }

    /// The norm of [`Specification::unnormalized`]; `text` names it in an error.
    ///
    /// # Errors
    /// [`SpecificationError::NotAStudyNumber`], [`Overflow`]
    pub fn study_norm(&self, text: &str) -> Result<StudyNorm, SpecificationError> {
        let y = self.unnormalized()?;
        let product = |a: &Multivector, b: &Multivector| {
            let product = a.product(Product::Geometric, b, &self.basis)?;
            product.map(|coefficient| self.relations.normal_form(coefficient))
        };
        for (blade, _) in y.terms() {
            let unit = Multivector::term(blade, Polynomial::one());
            let square = product(&unit, &unit.reverse())?.coefficient(Blade::SCALAR).as_constant();
            if square.is_none_or(Rational::is_negative) {
                let blade = self.basis.named(blade).name.clone();
                return Err(SpecificationError::IndefiniteNorm(text.to_owned(), blade));
            }
        }
        let norm = product(&y, &y.reverse())?;
        let scalar = norm.coefficient(Blade::SCALAR);
        let nilpotent = norm.sub(&Multivector::scalar(scalar.clone()))?;
        let commutes = product(&nilpotent, &y)? == product(&y, &nilpotent)?;
        if scalar.is_zero() || !commutes || !product(&nilpotent, &nilpotent)?.is_zero() {
            return Err(SpecificationError::NotAStudyNumber(text.to_owned()));
        }
        Ok(StudyNorm { scalar, nilpotent })
    }

    /// Checks that m ~m = 1 for the value m.
    fn check_unit(&self, name: &str) -> Result<(), SpecificationError> {
        let norm = self.value.product(Product::Geometric, &self.value.reverse(), &self.basis)?;
        let norm = norm.map(|coefficient| self.relations.normal_form(coefficient))?;
        if norm == Multivector::scalar(Polynomial::one()) {
            return Ok(());
        }
        let names = self.names();
        let term = |(blade, coefficient): (Blade, &Polynomial)| {
            let named = self.basis.named(blade);
            let value = coefficient.clone().signed(named.sign).display(&names);
            if blade == Blade::SCALAR { value } else { format!("({value}) {}", named.name) }
        };
        let terms: Vec<_> = norm.terms().map(term).collect();
        let found = if terms.is_empty() { "0".to_owned() } else { terms.join(" + ") };
        Err(SpecificationError::NotAUnit(name.to_owned(), found))
    }

    fn check_bivector(&self) -> Result<(), SpecificationError> {
        match self.value.terms().find(|(blade, _)| blade.grade() != 2) {
            None => self.check_single_coefficients(),
            Some((blade, value)) => {
                let (name, value) = self.named(blade, value);
                Err(SpecificationError::NotABivector(name, value))
            }
        }
    }

    /// What the proof of exp asks for: every coefficient whose blade squares to something else than 0 is a multiple of one of
    /// the inputs', each of another.
    fn check_single_coefficients(&self) -> Result<(), SpecificationError> {
        let mut seen = Vec::new();
        for (blade, value) in self.value.terms() {
            let unit = Multivector::term(blade, Polynomial::one());
            let is_null = unit.product(Product::Geometric, &unit, &self.basis)?.is_zero();
            let single = value.terms().next().filter(|(monomial, _)| value.term_count() == 1 && monomial.degree() == 1);
            match single {
                _ if is_null => {}
                Some((monomial, _)) if !seen.contains(monomial) => seen.push(monomial.clone()),
                _ => {
                    let (name, value) = self.named(blade, value);
                    return Err(SpecificationError::CompoundCoefficient(name, value));
                }
            }
        }
        Ok(())
    }

    /// A blade's name and a coefficient of it in words.
    fn named(&self, blade: Blade, value: &Polynomial) -> (String, String) {
        let named = self.basis.named(blade);
        (named.name.clone(), value.clone().signed(named.sign).display(&self.names()))
    }

    /// The degree of a monomial in the unit of length.
    pub fn degree(&self, monomial: &Monomial) -> u32 {
        monomial.symbols().iter().map(|&symbol| self.coefficients[usize::from(symbol)].degree).sum()
    }

    /// The degrees of [`Specification::fields`] in the unit of length: those of the output's blades, and those of their
    /// polynomials for the fields of a record.
    pub fn output_degrees(&self) -> Vec<u32> {
        if self.projection.is_none() {
            let signature = self.basis.signature();
            return self.output.fields().map(|(_, component)| component.blade.null_degree(signature)).collect();
        }
        let first = |output: &Polynomial| output.terms().next().map_or(0, |(monomial, _)| self.degree(monomial));
        self.outputs.iter().map(first).collect()
    }

    /// The names of the symbols.
    pub fn names(&self) -> Vec<String> {
        self.coefficients.iter().map(|coefficient| coefficient.name.clone()).collect()
    }

    /// Checks that the output type holds the value and that the value keeps what the type promises.
    fn check_output(&self) -> Result<(), SpecificationError> {
        let names = self.names();
        for named in self.basis.blades() {
            let value = self.value.coefficient(named.blade).signed(named.sign);
            let component = self.output.components.iter().find(|component| component.blade == named.blade);
            let constant = match component.map(|component| &component.value) {
                Some(ComponentValue::Field(_)) => continue,
                Some(ComponentValue::Constant(constant)) => Some(*constant),
                None => None,
            };
            let expected = constant.map_or_else(Polynomial::zero, Polynomial::constant);
            if !self.relations.difference(&value, &expected)?.is_zero() {
                let found = self.relations.normal_form(&value)?.display(&names);
                return Err(match constant {
                    Some(constant) => {
                        SpecificationError::WrongConstant(named.name.clone(), constant.to_string(), found)
                    }
                    None => SpecificationError::CannotHold(named.name.clone(), found),
                });
            }
        }
        let reduced: Vec<_> =
            self.outputs.iter().map(|output| self.relations.normal_form(output)).collect::<Result<_, _>>()?;
        for (statement, value) in self.output.statements.iter().zip(self.output.relation_values(&reduced)?) {
            let excess = self.relations.normal_form(&value)?;
            if !excess.is_zero() {
                return Err(SpecificationError::BrokenPromise(statement.text.clone(), excess.display(&names)));
            }
        }
        Ok(())
    }
}
