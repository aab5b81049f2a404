//! The products of two multivectors. Each is bilinear, so each is said by what it does to two words.

use super::word::{self, Word};
use super::{Multivector, Number};

impl<T: Number> Multivector<T> {
    /// The geometric product, written `*`.
    ///
    /// ```
    /// use ga_codegen::algebra::Signature;
    /// use ga_codegen::reference::Multivector;
    ///
    /// let blade = |word| Multivector::from_blades(Signature::new(3, 0, 1), [(word, 1)]).expect("a blade of 3D PGA");
    /// assert_eq!(blade("e23").geometric(&blade("e31")), blade("e21"));
    /// assert_eq!(blade("e0").geometric(&blade("e0")).to_string(), "0");
    /// ```
    ///
    /// # Panics
    ///
    /// If the signatures differ.
    #[track_caller]
    pub fn geometric(&self, other: &Self) -> Self {
        let signature = self.signature();
        self.bilinear(other, |left, right| word::geometric(signature, left, right))
    }

    /// The outer product, written `^`. Where vectors stand for planes it is the meet.
    ///
    /// # Panics
    ///
    /// If the signatures differ.
    #[track_caller]
    pub fn outer(&self, other: &Self) -> Self {
        self.bilinear(other, word::outer)
    }

    /// The regressive product, written `&`. Where vectors stand for planes it is the join.
    ///
    /// It is summed over the shuffles of the words of `self`, and equals `undual(dual(self) ^ dual(other))`.
    ///
    /// ```
    /// use ga_codegen::algebra::Signature;
    /// use ga_codegen::reference::Multivector;
    ///
    /// let pga2d = Signature::new(2, 0, 1);
    /// let point = |x, y| Multivector::from_blades(pga2d, [("e12", 1), ("e20", x), ("e01", y)]).expect("a point");
    /// // The line y = 0 through the origin and (1, 0).
    /// assert_eq!(point(0, 0).regressive(&point(1, 0)).to_string(), "e2");
    /// ```
    ///
    /// # Panics
    ///
    /// If the signatures differ.
    #[track_caller]
    pub fn regressive(&self, other: &Self) -> Self {
        self.assert_same_signature(other);
        let mut sum = self.empty();
        for (left, left_value) in self.terms() {
            for (right, right_value) in other.terms() {
                for (sign, word) in word::regressive(self.signature(), left, right) {
                    sum.accumulate(sign, word, left_value.clone() * right_value.clone());
                }
            }
        }
        sum
    }

    /// The inner product, written `|`: of grades r and s, the part of grade |r - s| of the geometric product. A scalar
    /// takes part like any other grade.
    ///
    /// # Panics
    ///
    /// If the signatures differ.
    #[track_caller]
    pub fn inner(&self, other: &Self) -> Self {
        self.geometric_of_grade(other, |r, s| Some(r.abs_diff(s)))
    }

    /// The left contraction: of grades r and s, the part of grade s - r of the geometric product, zero if r > s.
    ///
    /// # Panics
    ///
    /// If the signatures differ.
    #[track_caller]
    pub fn left_contraction(&self, other: &Self) -> Self {
        self.geometric_of_grade(other, |r, s| s.checked_sub(r))
    }

    /// The right contraction: of grades r and s, the part of grade r - s of the geometric product, zero if s > r.
    ///
    /// # Panics
    ///
    /// If the signatures differ.
    #[track_caller]
    pub fn right_contraction(&self, other: &Self) -> Self {
        self.geometric_of_grade(other, |r, s| r.checked_sub(s))
    }

    /// The scalar product: the part of grade 0 of the geometric product, as a multivector.
    ///
    /// # Panics
    ///
    /// If the signatures differ.
    #[track_caller]
    pub fn scalar_product(&self, other: &Self) -> Self {
        self.geometric_of_grade(other, |_, _| Some(0))
    }

    /// The commutator (ab - ba)/2.
    ///
    /// Two words multiply in either order to the same word up to a sign, so of words the commutator is ab where they
    /// anticommute and 0 where they commute. The halving is that of a difference of signs, and no coefficient is
    /// divided.
    ///
    /// # Panics
    ///
    /// If the signatures differ.
    #[track_caller]
    pub fn commutator(&self, other: &Self) -> Self {
        let signature = self.signature();
        self.bilinear(other, |left, right| {
            let (forward, word) = word::geometric(signature, left, right);
            let (backward, _) = word::geometric(signature, right, left);
            ((forward - backward) / 2, word)
        })
    }

    /// The anticommutator (ab + ba)/2: of words, ab where they commute and 0 where they anticommute.
    ///
    /// # Panics
    ///
    /// If the signatures differ.
    #[track_caller]
    pub fn anticommutator(&self, other: &Self) -> Self {
        let signature = self.signature();
        self.bilinear(other, |left, right| {
            let (forward, word) = word::geometric(signature, left, right);
            let (backward, _) = word::geometric(signature, right, left);
            ((forward + backward) / 2, word)
        })
    }

    /// The sandwich `self * x * ~self`, with the reverse and not the inverse: a versor that is not of unit norm scales.
    ///
    /// # Panics
    ///
    /// If the signatures differ.
    #[track_caller]
    pub fn sandwich(&self, x: &Self) -> Self {
        self.geometric(x).geometric(&self.reverse())
    }

    /// The part of the geometric product that has, for words of grades r and s, the grade `wanted(r, s)`.
    #[track_caller]
    fn geometric_of_grade(&self, other: &Self, wanted: impl Fn(usize, usize) -> Option<usize>) -> Self {
        let signature = self.signature();
        self.bilinear(other, |left, right| {
            let (sign, word) = word::geometric(signature, left, right);
            if wanted(left.len(), right.len()) == Some(word.len()) { (sign, word) } else { (0, word) }
        })
    }

    /// The bilinear map that takes each pair of words to a signed word.
    #[track_caller]
    fn bilinear(&self, other: &Self, image: impl Fn(&[u8], &[u8]) -> (i8, Word)) -> Self {
        self.assert_same_signature(other);
        let mut sum = self.empty();
        for (left, left_value) in self.terms() {
            for (right, right_value) in other.terms() {
                let (sign, word) = image(left, right);
                sum.accumulate(sign, word, left_value.clone() * right_value.clone());
            }
        }
        sum
    }
}
