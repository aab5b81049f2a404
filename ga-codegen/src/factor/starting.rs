//! Where the extraction starts: systems that are equal modulo the relations of the inputs, but not alike.
//!
//! - the outputs as they expand, and their normal forms;
//! - the outputs less a multiple of a relation for every group of components, Euclidean and ideal ones: the relation of
//!   unit norm times the transformed input's own component, and the homogeneous relations (the Study quadric) times its
//!   dual's: (s^2 + b.b) x - (s^2 + b.b - 1) x has fewer monomials. Groups may differ;
//! - staged: the inner products of the definition as rows of their own;
//! - by differences: in a chain of joins or meets of inputs of one type, a & b = a & (b - a) as a & a = 0, and the
//!   difference of two points of weight 1 has no weight;
//! - by commutators, for a versor m that the relations make a unit: m x ~m = x + 2 (m × x) ~m with m × x = (mx - xm)/2, and
//!   a x a = 2 (a ∘ x) a - a² x with a ∘ x = (ax + xa)/2.

use super::system::System;
use crate::algebra::{Blade, Product};
use crate::kernel::{Component, Expression, ExpressionKind, Operator, Specification};
use crate::symbolic::{Monomial, Multivector, Overflow, Polynomial, Rational, Symbol};

/// The starting points that cost little to try, for expansion without a recipe.
pub(super) fn few(specification: &Specification) -> Result<Vec<System>, Overflow> {
    let given = specification.coefficients.len();
    let expanded = specification.outputs.clone();
    let reduced: Result<Vec<_>, _> = expanded.iter().map(|p| specification.relations.normal_form(p)).collect();
    let mut outputs = vec![expanded, reduced?];
    for sign in [Rational::ONE, Rational::MINUS_ONE] {
        outputs.extend(with_multiples(specification, |_, _| (sign, Rational::ZERO))?);
    }
    outputs.dedup();
    let mut systems: Vec<_> = outputs.iter().map(|o| System::new(o, given)).collect::<Result<_, _>>()?;
    systems.sort_by_key(System::cost);
    systems.truncate(FEW);
    if specification.projection.is_none() {
        systems.extend(staged(specification)?);
    }
    Ok(systems)
}

const FEW: usize = 3;

/// All starting points, for a search.
pub(super) fn all(specification: &Specification) -> Result<Vec<System>, Overflow> {
    let given = specification.coefficients.len();
    let mut systems = few(specification)?;
    for outputs in multiples(specification)? {
        systems.push(System::new(&outputs, given)?);
    }
    if specification.projection.is_none() {
        systems.extend(by_differences(specification)?);
        systems.extend(by_commutator(specification)?);
    }
    let mut distinct: Vec<System> = Vec::new();
    for system in systems {
        if !distinct.iter().any(|other| other.same_rows(&system)) {
            distinct.push(system);
        }
    }
    Ok(distinct)
}

/// Which multiples of the relations are added to an output: of the unit one and of the homogeneous one.
type Multiples = (Rational, Rational);

/// The outputs with multiples of relations added, which differ by group of outputs or by place in the group.
fn multiples(specification: &Specification) -> Result<Vec<Vec<Polynomial>>, Overflow> {
    let signs = [Rational::ZERO, Rational::ONE, Rational::MINUS_ONE];
    let digit = |index: usize, place: usize| signs[index / 3usize.pow(place as u32) % 3];
    let mut all = Vec::new();
    for index in 0..81 {
        let by_group = |_: usize, ideal: bool| {
            let place = if ideal { 2 } else { 0 };
            (digit(index, place), digit(index, place + 1))
        };
        all.extend(with_multiples(specification, by_group)?);
    }
    for index in 0..27 {
        all.extend(with_multiples(specification, |place, _| (digit(index, place % 3), Rational::ZERO))?);
    }
    Ok(all)
}

/// The outputs with the multiples of relations that `choose` gives for a place in a group and whether the group is the
/// ideal one; nothing where there is no transformed input or no relation.
fn with_multiples(
    specification: &Specification,
    choose: impl Fn(usize, bool) -> Multiples,
) -> Result<Option<Vec<Polynomial>>, Overflow> {
    let (unit, homogeneous) = versor_relations(specification);
    let (Some(input), Some(unit)) = (transformed_input(specification), unit) else { return Ok(None) };
    let (mut outputs, mut places) = (Vec::new(), [0, 0]);
    for (_, component) in specification.output.fields() {
        let output = specification.value.coefficient(component.blade).signed(component.sign);
        let ideal = is_ideal(specification, component.blade);
        let (a, b) = choose(places[usize::from(ideal)], ideal);
        places[usize::from(ideal)] += 1;
        let own = input.coefficient(component.blade).signed(component.sign);
        let mut sum = output.add(&own.mul(&unit)?.scale(a)?)?;
        if let Some(relation) = &homogeneous {
            let dual = dual_component(specification, &input, component);
            sum = sum.add(&dual.mul(relation)?.scale(b)?)?;
        }
        outputs.push(if specification.projection.is_none() { shortest(specification, sum)? } else { sum });
    }
    match &specification.projection {
        Some(projection) => Ok(Some(projection.fields(&outputs)?)),
        None => Ok(Some(outputs)),
    }
}

/// The normal form where that is a single term, such as an invariant coefficient; else the polynomial itself.
fn shortest(specification: &Specification, polynomial: Polynomial) -> Result<Polynomial, Overflow> {
    let reduced = specification.relations.normal_form(&polynomial)?;
    Ok(if reduced.term_count() < 2 { reduced } else { polynomial })
}

/// Whether a blade has a null generator.
fn is_ideal(specification: &Specification, blade: Blade) -> bool {
    let signature = specification.basis.signature();
    blade.positions().any(|position| signature.square(position) == 0)
}

/// The coefficient of the input that the pseudoscalar carries to this component.
fn dual_component(specification: &Specification, input: &Multivector, component: &Component) -> Polynomial {
    let pseudoscalar = Multivector::term(specification.basis.pseudoscalar().blade, Polynomial::one());
    let carried = input.product(Product::Geometric, &pseudoscalar, &specification.basis).unwrap_or_default();
    carried.coefficient(component.blade).signed(component.sign)
}

/// The last input with the components of the output.
fn transformed_input(specification: &Specification) -> Option<Multivector> {
    let input = specification.inputs.iter().rev().find(|input| {
        let holds = |blade| specification.output.components.iter().any(|component| component.blade == blade);
        input.terms().count() == specification.output.components.len() && input.terms().all(|(blade, _)| holds(blade))
    });
    input.cloned()
}

/// The first stated relation with a constant term, as a polynomial with constant term -1, and the first without one.
fn versor_relations(specification: &Specification) -> (Option<Polynomial>, Option<Polynomial>) {
    let constant = |polynomial: &&Polynomial| !polynomial.coefficient(&Monomial::default()).is_zero();
    let unit = specification.stated.iter().find(constant).cloned();
    let homogeneous = specification.stated.iter().find(|polynomial| !constant(polynomial)).cloned();
    (unit, homogeneous)
}

/// Rows of a staged system: numbered behind the inputs, in order of their making.
struct Stage<'a> {
    specification: &'a Specification,
    rows: Vec<Polynomial>,
}

impl<'a> Stage<'a> {
    fn new(specification: &'a Specification) -> Self {
        Self { specification, rows: Vec::new() }
    }

    /// The multivector with every coefficient that is not a plain symbol made a row.
    fn materialise(&mut self, value: &Multivector) -> Multivector {
        let term = |(blade, coefficient): (Blade, &Polynomial)| {
            let plain = coefficient.term_count() == 1 && coefficient.terms().all(|(m, _)| m.degree() < 2);
            if plain {
                return (blade, coefficient.clone());
            }
            self.rows.push(coefficient.clone());
            let symbol = self.specification.coefficients.len() + self.rows.len() - 1;
            (blade, Polynomial::symbol(symbol as Symbol))
        };
        Multivector::from_terms(value.terms().map(term).collect::<Vec<_>>())
    }

    fn finish(self, value: &Multivector) -> Result<System, Overflow> {
        let fields = self.specification.output.fields();
        let mut outputs: Vec<_> = fields.map(|(_, c)| value.coefficient(c.blade).signed(c.sign)).collect();
        for (output, expanded) in outputs.iter_mut().zip(&self.specification.outputs) {
            let reduced = self.specification.relations.normal_form(expanded)?;
            if reduced.term_count() < 2 {
                *output = reduced;
            }
        }
        System::staged(&outputs, self.specification.coefficients.len(), &self.rows)
    }

    /// The value of an expression, what its operators take as operands made rows.
    fn evaluate(&mut self, expression: &Expression) -> Result<Multivector, Overflow> {
        let basis = &self.specification.basis;
        match &expression.kind {
            ExpressionKind::Binary(Operator::Sandwich, m, x) => {
                let (m, x) = (self.operand(m)?, self.operand(x)?);
                let inner = m.product(Product::Geometric, &x, basis)?;
                self.materialise(&inner).product(Product::Geometric, &m.reverse(), basis)
            }
            ExpressionKind::Binary(operator, a, b) => {
                let (a, b) = (self.operand(a)?, self.operand(b)?);
                Expression::apply(*operator, &a, &b, basis)
            }
            ExpressionKind::Negate(inner) => Ok(self.evaluate(inner)?.neg()),
            _ => expression.evaluate(&self.specification.inputs, basis),
        }
    }

    fn operand(&mut self, expression: &Expression) -> Result<Multivector, Overflow> {
        let value = self.evaluate(expression)?;
        Ok(self.materialise(&value))
    }
}

pub(super) fn staged(specification: &Specification) -> Result<Vec<System>, Overflow> {
    let mut stage = Stage::new(specification);
    let value = stage.evaluate(&specification.expression)?;
    Ok(if stage.rows.is_empty() { Vec::new() } else { vec![stage.finish(&value)?] })
}

/// The inputs of a chain of one antisymmetric product, in order.
fn chain(expression: &Expression, operator: Operator) -> Option<Vec<usize>> {
    match &expression.kind {
        ExpressionKind::Parameter(index) => Some(vec![*index]),
        ExpressionKind::Binary(found, a, b) if *found == operator => {
            Some([chain(a, operator)?, chain(b, operator)?].concat())
        }
        _ => None,
    }
}

/// a & b & c = a & (b - a) & (c - a), and the same for ^, where the product of an input with itself is 0.
fn by_differences(specification: &Specification) -> Result<Vec<System>, Overflow> {
    let mut systems = Vec::new();
    for operator in [Operator::Regressive, Operator::Outer] {
        let Some(inputs) = chain(&specification.expression, operator).filter(|inputs| inputs.len() > 1) else {
            continue;
        };
        let input = |index: usize| &specification.inputs[inputs[index]];
        let first = input(0);
        if !Expression::apply(operator, first, first, &specification.basis)?.is_zero() {
            continue;
        }
        for materialised in [false, true] {
            let mut stage = Stage::new(specification);
            let mut product = first.clone();
            for index in 1..inputs.len() {
                let difference = stage.materialise(&input(index).sub(first)?);
                // Directions first: (b - a) & (c - a) is free of a, which joins it last.
                product = match (index, materialised) {
                    (1, _) => difference,
                    (_, true) => {
                        let next = Expression::apply(operator, &product, &difference, &specification.basis)?;
                        stage.materialise(&next)
                    }
                    (_, false) => Expression::apply(operator, &product, &difference, &specification.basis)?,
                };
            }
            let value = Expression::apply(operator, first, &product, &specification.basis)?;
            systems.push(stage.finish(&value)?);
        }
    }
    Ok(systems)
}

/// m x ~m and ±a x a by commutator and anticommutator, with the inner product as rows and without.
fn by_commutator(specification: &Specification) -> Result<Vec<System>, Overflow> {
    let basis = &specification.basis;
    let Some((m, x, n, minus)) = versor_pattern(specification)? else { return Ok(Vec::new()) };
    let two = Rational::integer(2);
    let mut systems = Vec::new();
    for (product, sign) in [(Product::Commutator, Rational::ONE), (Product::Anticommutator, Rational::MINUS_ONE)] {
        // m x = 2 (m × x) + x m = 2 (m ∘ x) - x m, so m x n = 2 (...) n ± x (m n), and m n reduces to a number.
        let inner = m.product(product, &x, basis)?;
        let square = m.product(Product::Geometric, &n, basis)?.map(|c| specification.relations.normal_form(c))?;
        for materialised in [false, true] {
            let mut stage = Stage::new(specification);
            let inner = if materialised { stage.materialise(&inner) } else { inner.clone() };
            let outer = inner.product(Product::Geometric, &n, basis)?.scale(two)?;
            let rest = x.product(Product::Geometric, &square, basis)?.scale(sign)?;
            let value = outer.add(&rest)?;
            systems.push(stage.finish(&if minus { value.neg() } else { value })?);
        }
    }
    Ok(systems)
}

/// The parts (m, x, n, minus) of a definition ±m x n.
type VersorPattern = (Multivector, Multivector, Multivector, bool);

fn versor_pattern(specification: &Specification) -> Result<Option<VersorPattern>, Overflow> {
    let value = |expression: &Expression| expression.evaluate(&specification.inputs, &specification.basis);
    let (expression, minus) = match &specification.expression.kind {
        ExpressionKind::Negate(inner) => (inner.as_ref(), true),
        _ => (&specification.expression, false),
    };
    Ok(match &expression.kind {
        ExpressionKind::Binary(Operator::Sandwich, m, x) => {
            let m = value(m)?;
            Some((m.clone(), value(x)?, m.reverse(), minus))
        }
        ExpressionKind::Binary(Operator::Geometric, inner, n) => match &inner.kind {
            ExpressionKind::Binary(Operator::Geometric, m, x) => Some((value(m)?, value(x)?, value(n)?, minus)),
            _ => None,
        },
        _ => None,
    })
}
