//! Tests of the naive multivector against published tables, hand calculation and the laws of the algebra. None of them
//! uses the generator.

mod blade_notation;
mod cayley_tables;
mod fraction;
mod independence;
mod laws;
mod plane_geometry;
mod space_geometry;
mod surd;
mod terms;

use ga_codegen::algebra::Signature;
use ga_codegen::reference::{Multivector, Number};

const PGA_2D: Signature = Signature::new(2, 0, 1);
const PGA_3D: Signature = Signature::new(3, 0, 1);

/// A multivector of blades that are known to be right.
#[track_caller]
fn multivector<T: Number, const N: usize>(signature: Signature, blades: [(&str, T); N]) -> Multivector<T> {
    Multivector::from_blades(signature, blades).expect("the test names blades of its signature")
}

/// The words of all basis blades, in ascending order within each word.
fn basis_words(signature: Signature) -> Vec<String> {
    let first = if signature.null() > 0 { 0 } else { 1 };
    let subsets = 0..1_u32 << signature.dimension();
    subsets.map(|subset| word_of_subset(subset, first)).collect()
}

fn word_of_subset(subset: u32, first: u32) -> String {
    let digits: String = (0..8).filter(|bit| subset >> bit & 1 == 1).map(|bit| (bit + first).to_string()).collect();
    if digits.is_empty() { "1".to_owned() } else { format!("e{digits}") }
}

/// All basis blades, each with coefficient 1.
fn basis(signature: Signature) -> Vec<Multivector<i64>> {
    basis_words(signature).iter().map(|word| multivector(signature, [(word.as_str(), 1)])).collect()
}

/// The pseudoscalar: the generators in ascending order.
fn pseudoscalar(signature: Signature) -> Multivector<i64> {
    basis(signature).pop().expect("every algebra has a pseudoscalar")
}
