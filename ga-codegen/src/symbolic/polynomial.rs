//! Polynomials with rational coefficients, expanded: a sum of distinct monomials.

use super::effort;
use super::rational::{Overflow, Rational};
use crate::algebra::Sign;
use std::collections::BTreeMap;
use std::collections::btree_map::Entry;

/// An unknown, by its number. Names are kept apart, by whoever numbered the unknowns.
pub type Symbol = u16;

/// A product of symbols, ascending, a power written as repetition. The empty product is 1.
#[derive(Clone, Debug, Default, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Monomial(Vec<Symbol>);

impl Monomial {
    /// The product of these symbols.
    pub fn new(mut symbols: Vec<Symbol>) -> Self {
        symbols.sort_unstable();
        Self(symbols)
    }

    /// The symbols, ascending, repeated according to their powers.
    pub fn symbols(&self) -> &[Symbol] {
        &self.0
    }

    /// The total degree.
    pub fn degree(&self) -> usize {
        self.0.len()
    }

    /// The power of one symbol.
    pub fn power(&self, symbol: Symbol) -> usize {
        self.0.iter().filter(|&&other| other == symbol).count()
    }

    /// The product of two monomials.
    pub fn times(&self, other: &Self) -> Self {
        let (a, b) = (&self.0, &other.0);
        let mut merged = Vec::with_capacity(a.len() + b.len());
        let (mut i, mut j) = (0, 0);
        while i < a.len() && j < b.len() {
            if a[i] <= b[j] {
                merged.push(a[i]);
                i += 1;
            } else {
                merged.push(b[j]);
                j += 1;
            }
        }
        merged.extend_from_slice(&a[i..]);
        merged.extend_from_slice(&b[j..]);
        Self(merged)
    }

    /// What is left after division by `divisor`; `None` where it does not divide.
    pub fn divided_by(&self, divisor: &Self) -> Option<Self> {
        let mut wanted = divisor.0.iter().peekable();
        let mut rest = Vec::with_capacity(self.0.len());
        for &symbol in &self.0 {
            if wanted.peek() == Some(&&symbol) {
                wanted.next();
            } else {
                rest.push(symbol);
            }
        }
        wanted.peek().is_none().then_some(Self(rest))
    }

    /// The least common multiple.
    pub fn least_common_multiple(&self, other: &Self) -> Self {
        let mut symbols = self.0.clone();
        let mut last = None;
        for &symbol in &other.0 {
            if last != Some(symbol) {
                let lacking = other.power(symbol).saturating_sub(self.power(symbol));
                symbols.extend(std::iter::repeat_n(symbol, lacking));
                last = Some(symbol);
            }
        }
        Self::new(symbols)
    }
}

/// A polynomial: the coefficient of every monomial whose coefficient is not 0.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Polynomial(BTreeMap<Monomial, Rational>);

impl Polynomial {
    /// 0
    pub fn zero() -> Self {
        Self::default()
    }

    /// A constant.
    pub fn constant(value: Rational) -> Self {
        Self::term(Monomial::default(), value)
    }

    /// 1
    pub fn one() -> Self {
        Self::constant(Rational::ONE)
    }

    /// One unknown.
    pub fn symbol(symbol: Symbol) -> Self {
        Self::term(Monomial(vec![symbol]), Rational::ONE)
    }

    /// A coefficient times a monomial.
    pub fn term(monomial: Monomial, coefficient: Rational) -> Self {
        let mut terms = BTreeMap::new();
        if !coefficient.is_zero() {
            terms.insert(monomial, coefficient);
        }
        Self(terms)
    }

    /// Whether it is 0 as a polynomial.
    pub fn is_zero(&self) -> bool {
        self.0.is_empty()
    }

    /// The terms, in a fixed order.
    pub fn terms(&self) -> impl DoubleEndedIterator<Item = (&Monomial, Rational)> {
        self.0.iter().map(|(monomial, &coefficient)| (monomial, coefficient))
    }

    /// How many terms there are.
    pub fn term_count(&self) -> usize {
        self.0.len()
    }

    /// The coefficient of a monomial.
    pub fn coefficient(&self, monomial: &Monomial) -> Rational {
        self.0.get(monomial).copied().unwrap_or(Rational::ZERO)
    }

    /// The value, if it is a constant.
    pub fn as_constant(&self) -> Option<Rational> {
        match self.0.len() {
            0 => Some(Rational::ZERO),
            1 => self.0.get(&Monomial::default()).copied(),
            _ => None,
        }
    }

    /// Adds one term in place.
    ///
    /// # Errors
    /// [`Overflow`]
    pub fn add_term(&mut self, monomial: Monomial, coefficient: Rational) -> Result<(), Overflow> {
        if coefficient.is_zero() {
            return Ok(());
        }
        if !effort::spend(1) {
            return Err(Overflow);
        }
        match self.0.entry(monomial) {
            Entry::Vacant(vacant) => {
                vacant.insert(coefficient);
            }
            Entry::Occupied(mut occupied) => {
                let sum = occupied.get().checked_add(coefficient)?;
                if sum.is_zero() {
                    occupied.remove();
                } else {
                    occupied.insert(sum);
                }
            }
        }
        Ok(())
    }

    /// Adds `factor * monomial * other` in place.
    ///
    /// # Errors
    /// [`Overflow`]
    pub fn add_multiple(&mut self, factor: Rational, monomial: &Monomial, other: &Self) -> Result<(), Overflow> {
        for (other_monomial, coefficient) in other.terms() {
            // Counted before memory is taken: degrees can double as well as numbers of terms.
            if !effort::spend(1 + (other_monomial.degree() + monomial.degree()) / 8) {
                return Err(Overflow);
            }
            self.add_term(other_monomial.times(monomial), coefficient.checked_mul(factor)?)?;
        }
        Ok(())
    }

    /// Removes and returns the last term in the fixed order.
    pub(crate) fn pop(&mut self) -> Option<(Monomial, Rational)> {
        self.0.pop_last()
    }

    /// The sum.
    ///
    /// # Errors
    /// [`Overflow`]
    pub fn add(&self, other: &Self) -> Result<Self, Overflow> {
        effort::spend(self.0.len());
        let mut sum = self.clone();
        sum.add_multiple(Rational::ONE, &Monomial::default(), other)?;
        Ok(sum)
    }

    /// The difference.
    ///
    /// # Errors
    /// [`Overflow`]
    pub fn sub(&self, other: &Self) -> Result<Self, Overflow> {
        effort::spend(self.0.len());
        let mut difference = self.clone();
        difference.add_multiple(Rational::MINUS_ONE, &Monomial::default(), other)?;
        Ok(difference)
    }

    /// The product.
    ///
    /// # Errors
    /// [`Overflow`]
    pub fn mul(&self, other: &Self) -> Result<Self, Overflow> {
        let mut product = Self::zero();
        for (monomial, coefficient) in self.terms() {
            product.add_multiple(coefficient, monomial, other)?;
        }
        Ok(product)
    }

    /// The negative.
    pub fn neg(&self) -> Self {
        effort::spend(self.0.len());
        Self(self.0.iter().map(|(monomial, coefficient)| (monomial.clone(), coefficient.neg())).collect())
    }

    /// The polynomial or its negative.
    pub fn signed(self, sign: Sign) -> Self {
        if sign.is_minus() { self.neg() } else { self }
    }

    /// The product with a number.
    ///
    /// # Errors
    /// [`Overflow`]
    pub fn scale(&self, factor: Rational) -> Result<Self, Overflow> {
        let mut product = Self::zero();
        product.add_multiple(factor, &Monomial::default(), self)?;
        Ok(product)
    }

    /// The polynomial with every symbol `i` replaced by `values[i]`; symbols beyond the list stay.
    ///
    /// # Errors
    /// [`Overflow`]
    pub fn substitute(&self, values: &[Self]) -> Result<Self, Overflow> {
        let mut sum = Self::zero();
        for (monomial, coefficient) in self.terms() {
            let mut product = Self::constant(coefficient);
            for &symbol in monomial.symbols() {
                product = match values.get(usize::from(symbol)) {
                    Some(value) => product.mul(value)?,
                    None => product.mul(&Self::symbol(symbol))?,
                };
            }
            sum = sum.add(&product)?;
        }
        Ok(sum)
    }

    /// The polynomial written out with these names, such as `m.s^2 - 2 m.e23 p.x`.
    pub fn display(&self, names: &[String]) -> String {
        if self.is_zero() {
            return "0".to_owned();
        }
        let mut text = String::new();
        for (index, (monomial, coefficient)) in self.terms().enumerate() {
            text += match (index, coefficient.is_negative()) {
                (0, false) => "",
                (0, true) => "-",
                (_, false) => " + ",
                (_, true) => " - ",
            };
            text += &display_term(monomial, coefficient.abs(), names);
        }
        text
    }
}

fn display_term(monomial: &Monomial, coefficient: Rational, names: &[String]) -> String {
    let mut factors = Vec::new();
    if coefficient != Rational::ONE || monomial.degree() == 0 {
        factors.push(coefficient.to_string());
    }
    for group in monomial.symbols().chunk_by(|a, b| a == b) {
        let name = names.get(usize::from(group[0])).cloned().unwrap_or_else(|| format!("x{}", group[0]));
        factors.push(if group.len() == 1 { name } else { format!("{name}^{}", group.len()) });
    }
    factors.join(" ")
}

#[cfg(test)]
mod tests {
    use super::*;

    fn squared_within(steps: u64, polynomial: &Polynomial) -> Result<Polynomial, Overflow> {
        effort::limited(steps, || polynomial.mul(polynomial))
    }

    /// Work ends between half and twice of what there is to do: looking at 100 terms and adding them up, or writing down
    /// a monomial of degree 1600.
    #[test]
    fn terms_and_degrees_count_as_work() {
        let power = Polynomial::term(Monomial::new(vec![0; 800]), Rational::ONE);
        assert!(squared_within(100, &power).is_err() && squared_within(400, &power).is_ok());
        let mut sum = Polynomial::zero();
        for symbol in 0..10 {
            sum = sum.add(&Polynomial::symbol(symbol)).expect("small numbers");
        }
        assert!(squared_within(150, &sum).is_err() && squared_within(400, &sum).is_ok());
        let within =
            |steps, work: fn(&Polynomial) -> bool| effort::limited(steps, || work(&sum) && !effort::is_exhausted());
        for work in [
            (|sum| !sum.neg().is_zero()) as fn(&Polynomial) -> bool,
            |sum| sum.add(&Polynomial::one()).is_ok(),
            |sum| sum.sub(&Polynomial::one()).is_ok(),
        ] {
            assert!(!within(8, work) && within(40, work));
        }
    }
}
