//! What is done to one multivector: involutions, duals, the parts of a grade, and norms.

use super::word;
use super::{Multivector, Number, Real};

impl<T: Number> Multivector<T> {
    /// The reverse, written `~`: every product of vectors in the opposite order.
    pub fn reverse(&self) -> Self {
        self.map_words(word::reverse)
    }

    /// The grade involution: the sign of every vector changes, so odd grades are negated.
    pub fn grade_involution(&self) -> Self {
        self.map_words(word::grade_involution)
    }

    /// The Clifford conjugate: the reverse of the grade involution.
    pub fn clifford_conjugate(&self) -> Self {
        self.grade_involution().reverse()
    }

    /// The dual J as right complement: `X ^ dual(X)` = pseudoscalar for every basis blade X. It is linear and asks for
    /// no metric, so it is defined with null generators too.
    pub fn dual(&self) -> Self {
        self.map_words(|word| word::dual(self.signature(), word))
    }

    /// The inverse of [`Multivector::dual`].
    pub fn undual(&self) -> Self {
        self.map_words(|word| word::undual(self.signature(), word))
    }

    /// The part of grade `k`, zero if `k` is more than the dimension.
    pub fn grade(&self, k: usize) -> Self {
        self.map_words(|word| (i8::from(word.len() == k), word.to_vec()))
    }

    /// The scalar part of X ~X. It may be negative if a generator squares to -1, and it does not see coefficients with
    /// a null generator.
    pub fn norm_squared(&self) -> T {
        self.scalar_product(&self.reverse()).coefficient("1")
    }

    /// The sum of the squares of the coefficients whose blade contains a null generator.
    pub fn ideal_norm_squared(&self) -> T {
        self.terms()
            .filter(|(word, _)| word::is_ideal(self.signature(), word))
            .fold(T::from(0), |sum, (_, value)| sum + value.clone() * value.clone())
    }
}

impl<T: Real> Multivector<T> {
    /// The square root of the absolute value of [`Multivector::norm_squared`].
    ///
    /// ```
    /// use ga_codegen::algebra::Signature;
    /// use ga_codegen::reference::Multivector;
    ///
    /// let pga2d = Signature::new(2, 0, 1);
    /// let line = Multivector::from_blades(pga2d, [("e1", 3.0), ("e2", 4.0), ("e0", 7.0)]).expect("a line");
    /// assert_eq!(line.norm(), 5.0);
    /// assert_eq!(line.ideal_norm(), 7.0);
    /// ```
    pub fn norm(&self) -> T {
        self.norm_squared().abs().sqrt()
    }

    /// The square root of [`Multivector::ideal_norm_squared`].
    pub fn ideal_norm(&self) -> T {
        self.ideal_norm_squared().sqrt()
    }

    /// The multivector over its [`Multivector::norm`]; `None` where that is 0, or its square leaves the range of the
    /// numbers.
    ///
    /// Of a sum of several grades, such as an even element, X ~X may have more than a scalar part, and keeps it: only
    /// that scalar part becomes 1 (or -1). An ideal element has the norm 0; it is to be divided by its
    /// [`Multivector::ideal_norm`].
    ///
    /// ```
    /// use ga_codegen::algebra::Signature;
    /// use ga_codegen::reference::Multivector;
    ///
    /// let pga2d = Signature::new(2, 0, 1);
    /// let line = Multivector::from_blades(pga2d, [("e1", 3.0), ("e2", 4.0), ("e0", 10.0)]).expect("a line");
    /// assert_eq!(line.normalize().expect("a line that is not at infinity").to_string(), "2 e0 + 0.6 e1 + 0.8 e2");
    /// assert_eq!(line.outer(&line).normalize(), None);
    /// ```
    pub fn normalize(&self) -> Option<Self> {
        let norm = self.norm();
        let is_finite = norm.clone() - norm.clone() == T::from(0);
        (is_finite && norm != T::from(0)).then(|| self.quotient(norm))
    }

    /// Every coefficient over a number.
    fn quotient(&self, divisor: T) -> Self {
        let mut quotient = self.empty();
        for (word, value) in self.terms() {
            quotient.accumulate(1, word.to_vec(), value.clone() / divisor.clone());
        }
        quotient
    }
}
