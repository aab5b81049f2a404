//! What a type promises about its coefficients, as rewriting rules with unique normal forms.
//!
//! A [`Relation`] says that a polynomial is 0 and which of its monomials is rewritten, the leading one. [`Relations`]
//! holds several of which it has checked two things:
//! - **Termination:** the leading monomials are the greatest of their relations in some lexicographic order, which is a
//!   well-order, so rewriting ends.
//! - **Confluence:** the S-polynomial of every two relations reduces to 0, so the relations are a Groebner basis for
//!   that order and normal forms are unique (Buchberger, 1965).
//!
//! Hence a difference with normal form 0 vanishes on every value that satisfies the relations, and no other polynomial
//! of their ideal is missed.

use super::effort;
use super::polynomial::{Monomial, Polynomial, Symbol};
use super::rational::{Overflow, Rational};

/// A polynomial that is 0 and its leading monomial.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Relation {
    polynomial: Polynomial,
    leading: Monomial,
}

impl Relation {
    /// The relation `polynomial` = 0, rewritten at `leading`; `None` where that monomial is constant or not in it.
    pub fn new(polynomial: Polynomial, leading: Monomial) -> Option<Self> {
        let present = !polynomial.coefficient(&leading).is_zero() && leading.degree() > 0;
        present.then_some(Self { polynomial, leading })
    }

    /// The polynomial that is 0.
    pub fn polynomial(&self) -> &Polynomial {
        &self.polynomial
    }

    /// The monomial that is rewritten.
    pub fn leading(&self) -> &Monomial {
        &self.leading
    }

    /// The same relation with every symbol moved by `offset`.
    pub fn shifted(&self, offset: Symbol) -> Self {
        let shift = |monomial: &Monomial| Monomial::new(monomial.symbols().iter().map(|s| s + offset).collect());
        let mut polynomial = Polynomial::zero();
        for (monomial, coefficient) in self.polynomial.terms() {
            // Distinct monomials stay distinct, so nothing adds up and nothing can overflow.
            polynomial.add_term(shift(monomial), coefficient).expect("invariant: shifted monomials are distinct");
        }
        Self { polynomial, leading: shift(&self.leading) }
    }

    /// What the leading monomial is equal to.
    fn replacement(&self) -> Result<Polynomial, Overflow> {
        let coefficient = self.polynomial.coefficient(&self.leading);
        let factor = Rational::MINUS_ONE.checked_div(coefficient)?.ok_or(Overflow)?;
        let mut replacement = self.polynomial.scale(factor)?;
        replacement.add_term(self.leading.clone(), Rational::ONE)?;
        Ok(replacement)
    }
}

/// Why relations have no normal form.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum RelationsError {
    /// No lexicographic order makes every leading monomial the greatest of its relation; the index is of one that fails.
    NotTerminating(usize),
    /// The S-polynomial of two relations does not reduce to 0 but to this.
    NotConfluent(usize, usize, Polynomial),
    /// [`Overflow`]
    Overflow,
}

impl From<Overflow> for RelationsError {
    fn from(_: Overflow) -> Self {
        Self::Overflow
    }
}

#[derive(Clone, Debug, PartialEq, Eq)]
struct Rule {
    leading: Monomial,
    replacement: Polynomial,
}

/// Relations with unique normal forms.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Relations(Vec<Rule>);

impl Relations {
    /// Checks termination and confluence.
    ///
    /// # Errors
    /// [`RelationsError`], with the indices of the offending relations.
    pub fn new(relations: &[Relation]) -> Result<Self, RelationsError> {
        check_termination(relations)?;
        let rule = |r: &Relation| Ok(Rule { leading: r.leading.clone(), replacement: r.replacement()? });
        let rules = Self(relations.iter().map(rule).collect::<Result<_, Overflow>>()?);
        rules.check_confluence()?;
        Ok(rules)
    }

    /// These relations and `root`^2 = `square`, for a symbol that is in none of them and not in the square. Its square is
    /// coprime to the leading monomials, and greater than `square` in an order that has the symbol first: so termination and
    /// confluence stay.
    #[must_use]
    pub(crate) fn with_square(&self, root: Symbol, square: Polynomial) -> Self {
        let mut rules = self.0.clone();
        rules.push(Rule { leading: Monomial::new(vec![root, root]), replacement: square });
        Self(rules)
    }

    /// Whether there are none.
    pub fn is_empty(&self) -> bool {
        self.0.is_empty()
    }

    fn check_confluence(&self) -> Result<(), RelationsError> {
        for (j, second) in self.0.iter().enumerate() {
            for (i, first) in self.0[..j].iter().enumerate() {
                if !effort::spend(1) {
                    return Err(RelationsError::Overflow);
                }
                let common = first.leading.least_common_multiple(&second.leading);
                if common.degree() == first.leading.degree() + second.leading.degree() {
                    continue; // Coprime leading monomials: Buchberger's first criterion.
                }
                let s_polynomial = first.rewrite(&common)?.sub(&second.rewrite(&common)?)?;
                let remainder = self.normal_form(&s_polynomial)?;
                if !remainder.is_zero() {
                    return Err(RelationsError::NotConfluent(i, j, remainder));
                }
            }
        }
        Ok(())
    }

    /// The unique polynomial without any leading monomial that equals this one wherever the relations hold.
    ///
    /// # Errors
    /// [`Overflow`]
    pub fn normal_form(&self, polynomial: &Polynomial) -> Result<Polynomial, Overflow> {
        if self.0.is_empty() {
            return Ok(polynomial.clone());
        }
        let (mut pending, mut reduced) = (polynomial.clone(), Polynomial::zero());
        while let Some((monomial, coefficient)) = pending.pop() {
            if !effort::spend(self.0.len() * (1 + monomial.degree() / 8)) {
                return Err(Overflow);
            }
            let step = self.0.iter().find_map(|rule| Some((rule, monomial.divided_by(&rule.leading)?)));
            match step {
                Some((rule, rest)) => pending.add_multiple(coefficient, &rest, &rule.replacement)?,
                None => reduced.add_term(monomial, coefficient)?,
            }
        }
        Ok(reduced)
    }

    /// Whether two polynomials are equal wherever the relations hold; if not, the normal form of their difference.
    ///
    /// # Errors
    /// [`Overflow`]
    pub fn difference(&self, a: &Polynomial, b: &Polynomial) -> Result<Polynomial, Overflow> {
        self.normal_form(&a.sub(b)?)
    }
}

impl Rule {
    /// A multiple of the leading monomial after one step.
    fn rewrite(&self, multiple: &Monomial) -> Result<Polynomial, Overflow> {
        let rest = multiple.divided_by(&self.leading).unwrap_or_default();
        let mut result = Polynomial::zero();
        result.add_multiple(Rational::ONE, &rest, &self.replacement)?;
        Ok(result)
    }
}

/// Looks for an order of the symbols whose lexicographic order has every leading monomial on top. The next symbol of
/// the order may be any that no unsettled relation has in a higher power outside its leading monomial; taking one
/// only settles relations and so never closes a way.
fn check_termination(relations: &[Relation]) -> Result<(), RelationsError> {
    let mut unsettled: Vec<(usize, &Monomial, &Monomial)> = Vec::new();
    for (index, relation) in relations.iter().enumerate() {
        let others = relation.polynomial.terms().map(|(monomial, _)| monomial).filter(|m| **m != relation.leading);
        unsettled.extend(others.map(|other| (index, &relation.leading, other)));
    }
    let mut symbols: Vec<Symbol> = unsettled.iter().flat_map(|(_, leading, _)| leading.symbols().to_vec()).collect();
    symbols.sort_unstable();
    symbols.dedup();
    while let Some(&(index, ..)) = unsettled.first() {
        if !effort::spend(unsettled.len() * symbols.len()) {
            return Err(RelationsError::Overflow);
        }
        let harmless = |&&symbol: &&Symbol| unsettled.iter().all(|(_, l, o)| l.power(symbol) >= o.power(symbol));
        let useful = |&&symbol: &&Symbol| unsettled.iter().any(|(_, l, o)| l.power(symbol) > o.power(symbol));
        let Some(&symbol) = symbols.iter().filter(useful).find(harmless) else {
            return Err(RelationsError::NotTerminating(index));
        };
        unsettled.retain(|(_, leading, other)| leading.power(symbol) == other.power(symbol));
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    /// x_first = x_second for each pair.
    fn renamed(pairs: impl Iterator<Item = (Symbol, Symbol)>) -> Vec<Relation> {
        let relation = |(first, second): (Symbol, Symbol)| {
            let difference = Polynomial::symbol(first).sub(&Polynomial::symbol(second)).expect("small numbers");
            Relation::new(difference, Monomial::new(vec![first])).expect("a leading monomial")
        };
        pairs.map(relation).collect()
    }

    /// Every term is compared with every rule, symbol by symbol; limits lie between half and twice of that.
    #[test]
    fn looking_for_rules_counts_as_work() {
        let relations = Relations::new(&renamed([(900, 901), (902, 903)].into_iter())).expect("it ends");
        let form = |steps, polynomial: &Polynomial| effort::limited(steps, || relations.normal_form(polynomial));
        let power = Polynomial::term(Monomial::new(vec![0; 1600]), Rational::ONE);
        assert!(form(300, &power).is_err() && form(800, &power) == Ok(power));
        let mut sum = Polynomial::zero();
        (0..100).for_each(|symbol| sum.add_term(Monomial::new(vec![symbol]), Rational::ONE).expect("small numbers"));
        assert!(form(200, &sum).is_err() && form(600, &sum) == Ok(sum));
    }

    /// Of n relations and n symbols one of each is settled at a time: n^2 (n + 1) / 2 comparisons.
    #[test]
    fn looking_for_an_order_counts_as_work() {
        let relations = renamed((0..20).map(|symbol| (symbol, symbol + 100)));
        let check = |steps| effort::limited(steps, || Relations::new(&relations).map(|_| ()));
        assert_eq!((check(2000), check(9000)), (Err(RelationsError::Overflow), Ok(())));
    }
}
