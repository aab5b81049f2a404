//! Names and orientations of the basis blades.

use super::{Blade, Sign, Signature};
use std::fmt;

/// A basis blade under the name and with the orientation that the user chose.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct NamedBlade {
    /// The name, by default the word itself, such as `e31`; the scalar is `1`.
    pub name: String,
    /// The blade in ascending order.
    pub blade: Blade,
    /// The orientation: `name` = `sign` * `blade`.
    pub sign: Sign,
}

/// Every blade of an algebra, each once, named and oriented, in the order that the user wants to see.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Basis {
    signature: Signature,
    blades: Vec<NamedBlade>,
    by_blade: Vec<usize>,
}

/// Why a list of words is no basis, and at which entry of the list.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct BasisError {
    /// The offending entry; `None` where the list as a whole is at fault.
    pub index: Option<usize>,
    /// What is wrong.
    pub kind: BasisErrorKind,
}

/// What can be wrong with a basis.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum BasisErrorKind {
    /// The signature has more generators than [`Signature::MAX_DIMENSION`].
    TooManyGenerators(Signature),
    /// The word is not `1` and not `e` followed by indices of generators, each at most once.
    NotABlade(String, Signature),
    /// The blade stands in the list already, under the second name.
    Repeated(String, String),
    /// The name stands in the list already.
    NameTaken(String),
    /// These blades are not in the list.
    Missing(Vec<String>),
}

impl fmt::Display for BasisErrorKind {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::TooManyGenerators(signature) => {
                write!(f, "expected at most {} generators, found {signature}", Signature::MAX_DIMENSION)
            }
            Self::NotABlade(word, signature) => {
                write!(f, "expected a blade of {signature}, found `{word}`: its generators are ")?;
                let names: Vec<_> = (0..signature.dimension()).map(|p| generator_name(*signature, p)).collect();
                write!(f, "{}, each at most once in a blade", names.join(" "))
            }
            Self::Repeated(word, earlier) => {
                write!(f, "expected every blade once, found `{word}` and `{earlier}`, which are the same up to sign")
            }
            Self::NameTaken(name) => write!(f, "expected distinct names, found `{name}` twice"),
            Self::Missing(words) => {
                let quoted: Vec<_> = words.iter().map(|word| format!("`{word}`")).collect();
                write!(f, "expected every blade of the algebra, found none for {}", quoted.join(", "))
            }
        }
    }
}

impl fmt::Display for BasisError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.kind.fmt(f)
    }
}

impl std::error::Error for BasisError {}

fn generator_name(signature: Signature, position: usize) -> String {
    format!("e{}", position + signature.first_index())
}

/// The word of a blade in ascending order: `1`, `e0`, `e13`.
fn ascending_word(signature: Signature, blade: Blade) -> String {
    if blade == Blade::SCALAR {
        return "1".to_owned();
    }
    let indices = blade.positions().map(|position| (position + signature.first_index()).to_string());
    format!("e{}", indices.collect::<String>())
}

/// Reads a word such as `e31` as a signed blade.
fn parse_word(signature: Signature, word: &str) -> Option<(Sign, Blade)> {
    if word == "1" {
        return Some((Sign::Plus, Blade::SCALAR));
    }
    let digits = word.strip_prefix('e').filter(|digits| !digits.is_empty())?;
    let (mut sign, mut blade) = (Sign::Plus, Blade::SCALAR);
    for digit in digits.chars() {
        let position = (digit.to_digit(10)? as usize).checked_sub(signature.first_index())?;
        if position >= signature.dimension() || blade.0 >> position & 1 == 1 {
            return None;
        }
        let generator = Blade(1 << position);
        sign = sign * blade.reordering_sign(generator);
        blade = Blade(blade.0 | generator.0);
    }
    Some((sign, blade))
}

impl Basis {
    /// A basis from names and the words that they stand for, every blade exactly once.
    ///
    /// # Errors
    /// The first entry that is no blade of the algebra or is there twice; else the list of the blades that are missing.
    pub fn new<N, W>(signature: Signature, words: impl IntoIterator<Item = (N, W)>) -> Result<Self, BasisError>
    where
        N: Into<String>,
        W: AsRef<str>,
    {
        let dimension = signature.dimension();
        if dimension > Signature::MAX_DIMENSION {
            return Err(BasisError { index: None, kind: BasisErrorKind::TooManyGenerators(signature) });
        }
        let mut blades: Vec<NamedBlade> = Vec::new();
        let mut by_blade = vec![usize::MAX; 1 << dimension];
        for (index, (name, word)) in words.into_iter().enumerate() {
            let (name, word) = (name.into(), word.as_ref());
            let at = |kind| BasisError { index: Some(index), kind };
            let (sign, blade) =
                parse_word(signature, word).ok_or_else(|| at(BasisErrorKind::NotABlade(word.to_owned(), signature)))?;
            if let Some(earlier) = blades.get(by_blade[usize::from(blade.0)]) {
                return Err(at(BasisErrorKind::Repeated(name, earlier.name.clone())));
            }
            if blades.iter().any(|earlier| earlier.name == name) {
                return Err(at(BasisErrorKind::NameTaken(name)));
            }
            by_blade[usize::from(blade.0)] = index;
            blades.push(NamedBlade { name, blade, sign });
        }
        let missing: Vec<_> = (0..by_blade.len())
            .filter(|&bits| by_blade[bits] == usize::MAX)
            .map(|bits| ascending_word(signature, Blade(bits as u8)))
            .collect();
        if missing.is_empty() {
            Ok(Self { signature, blades, by_blade })
        } else {
            Err(BasisError { index: None, kind: BasisErrorKind::Missing(missing) })
        }
    }

    /// The basis of ascending words, by grade, then by generators.
    ///
    /// # Errors
    /// A signature with more than [`Signature::MAX_DIMENSION`] generators.
    pub fn canonical(signature: Signature) -> Result<Self, BasisError> {
        let dimension = signature.dimension().min(Signature::MAX_DIMENSION);
        let mut blades: Vec<Blade> = (0..1u16 << dimension).map(|bits| Blade(bits as u8)).collect();
        blades.sort_by_key(|blade| (blade.grade(), blade.positions().collect::<Vec<_>>()));
        let words = blades.into_iter().map(|blade| ascending_word(signature, blade));
        Self::new(signature, words.map(|word| (word.clone(), word)))
    }

    /// The signature.
    pub fn signature(&self) -> Signature {
        self.signature
    }

    /// The blades in the user's order.
    pub fn blades(&self) -> &[NamedBlade] {
        &self.blades
    }

    /// The blade of that name.
    pub fn find(&self, name: &str) -> Option<&NamedBlade> {
        self.blades.iter().find(|named| named.name == name)
    }

    /// The blade of a word in any order of its generators, whatever its name here.
    pub(crate) fn word(&self, word: &str) -> Option<(Sign, Blade)> {
        parse_word(self.signature, word)
    }

    /// The name and orientation of a blade of this algebra.
    ///
    /// # Panics
    /// For a blade with a generator that the algebra does not have, which is a mistake of the caller.
    pub fn named(&self, blade: Blade) -> &NamedBlade {
        let index = self.by_blade.get(usize::from(blade.0)).expect("a blade of this basis's algebra");
        &self.blades[*index]
    }

    /// The pseudoscalar with the orientation of this basis; duals are taken against it.
    pub fn pseudoscalar(&self) -> &NamedBlade {
        // Every blade of the algebra is there, and the pseudoscalar has the most bits.
        &self.blades[self.by_blade[self.by_blade.len() - 1]]
    }

    /// The right complement J with X ^ J(X) = the basis's pseudoscalar, of an ascending blade X. It needs no metric.
    pub fn dual(&self, blade: Blade) -> (Sign, Blade) {
        let complement = Blade(self.pseudoscalar().blade.0 & !blade.0);
        (blade.reordering_sign(complement) * self.pseudoscalar().sign, complement)
    }

    /// The inverse of [`Basis::dual`].
    pub fn undual(&self, blade: Blade) -> (Sign, Blade) {
        let complement = Blade(self.pseudoscalar().blade.0 & !blade.0);
        (complement.reordering_sign(blade) * self.pseudoscalar().sign, complement)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn words_are_blades_in_any_order_whatever_the_names() {
        let names = [("1", "1"), ("x", "e1"), ("y", "e2"), ("i", "e21")];
        let basis = Basis::new(Signature::new(2, 0, 0), names).expect("a basis");
        assert_eq!(basis.word("1"), Some((Sign::Plus, Blade::SCALAR)));
        assert_eq!(basis.word("e12"), Some((Sign::Plus, Blade(0b11))));
        assert_eq!(basis.word("e21"), Some((Sign::Minus, Blade(0b11))));
        assert_eq!((basis.word("i"), basis.word("e3"), basis.word("e11")), (None, None, None));
    }
}
