//! Words of generators: how they are put in order, multiplied and split.
//!
//! A word in canonical form lists distinct generators in ascending order; the empty word is the scalar 1. A sign is
//! -1, 0 or +1, and 0 says that the result vanishes, whatever word stands beside it.

use crate::algebra::Signature;

pub(super) type Word = Vec<u8>;

/// All generators in ascending order, which is the word of the pseudoscalar.
pub(super) fn generators(signature: Signature) -> Word {
    let first = first_generator(signature);
    (first..=u8::MAX).take(signature.dimension()).collect()
}

/// `e0` is always null: without a null generator, counting starts at 1.
fn first_generator(signature: Signature) -> u8 {
    if signature.null() > 0 { 0 } else { 1 }
}

/// The square of a generator. Null generators come first, then positive, then negative.
fn square(signature: Signature, generator: u8) -> i8 {
    let position = usize::from(generator - first_generator(signature));
    if position < signature.null() {
        0
    } else if position < signature.null() + signature.positive() {
        1
    } else {
        -1
    }
}

/// Whether the word contains a null generator.
pub(super) fn is_ideal(signature: Signature, word: &[u8]) -> bool {
    word.iter().any(|&generator| square(signature, generator) == 0)
}

/// Puts a word in order one swap of neighbours at a time; distinct generators anticommute, so each swap changes the
/// sign. Equal letters end up side by side and are left standing.
pub(super) fn sort(mut word: Word) -> (i8, Word) {
    let mut sign = 1;
    while let Some(at) = word.windows(2).position(|pair| pair[0] > pair[1]) {
        word.swap(at, at + 1);
        sign = -sign;
    }
    (sign, word)
}

/// Where two equal letters stand side by side.
fn equal_neighbours(word: &[u8]) -> Option<usize> {
    word.windows(2).position(|pair| pair[0] == pair[1])
}

/// The geometric product: sort, then replace each pair of equal neighbours by the square of the generator.
pub(super) fn geometric(signature: Signature, left: &[u8], right: &[u8]) -> (i8, Word) {
    let (mut sign, mut word) = sort([left, right].concat());
    while let Some(at) = equal_neighbours(&word) {
        sign *= square(signature, word[at]);
        word.drain(at..at + 2);
    }
    (sign, word)
}

/// The outer product: sort, and vanish if a generator occurs in both words. It never asks for the metric.
pub(super) fn outer(left: &[u8], right: &[u8]) -> (i8, Word) {
    let (sign, word) = sort([left, right].concat());
    if equal_neighbours(&word).is_some() { (0, word) } else { (sign, word) }
}

/// The regressive product of two words, as the terms of its shuffle formula.
///
/// With n generators, `left` is split in every possible way into a front of n - |`right`| letters and a back of the
/// others, and the sum is taken of
///
/// sign(front back as an order of `left`) * [front `right`] * back,
///
/// where the bracket is the coefficient of the pseudoscalar in front ^ `right`. Both factors carry a sign: that of the
/// split, and that of the order in which front and `right` make the pseudoscalar.
///
/// Source: M. Barnabei, A. Brini, G.-C. Rota, "On the exterior calculus of invariant theory", J. Algebra 96 (1985).
pub(super) fn regressive(signature: Signature, left: &[u8], right: &[u8]) -> Vec<(i8, Word)> {
    let front_length = signature.dimension() - right.len();
    partitions(left, front_length)
        .into_iter()
        .map(|(front, back)| {
            let (order, _) = sort([front.as_slice(), &back].concat());
            // n letters: either they are all the generators, or one occurs twice and the outer product vanishes.
            let (bracket, _) = outer(&front, right);
            (order * bracket, back)
        })
        .collect()
}

/// Every way of splitting a word into a front of `length` letters and a back, both in the order of the word.
fn partitions(word: &[u8], length: usize) -> Vec<(Word, Word)> {
    (0..1_usize << word.len()).map(|choice| split(word, choice)).filter(|(front, _)| front.len() == length).collect()
}

/// The letters whose bits are set in `choice`, and the others.
fn split(word: &[u8], choice: usize) -> (Word, Word) {
    let mut front = Word::new();
    let mut back = Word::new();
    for (position, &generator) in word.iter().enumerate() {
        let side = if choice >> position & 1 == 1 { &mut front } else { &mut back };
        side.push(generator);
    }
    (front, back)
}

/// The reverse: the letters backwards, put in order again.
pub(super) fn reverse(word: &[u8]) -> (i8, Word) {
    sort(word.iter().rev().copied().collect())
}

/// The grade involution: every generator changes its sign.
pub(super) fn grade_involution(word: &[u8]) -> (i8, Word) {
    let sign = word.iter().fold(1, |sign: i8, _| -sign);
    (sign, word.to_vec())
}

/// The right complement J(X), with X ^ J(X) = pseudoscalar.
pub(super) fn dual(signature: Signature, word: &[u8]) -> (i8, Word) {
    let complement = missing_generators(signature, word);
    let (sign, _) = outer(word, &complement);
    (sign, complement)
}

/// The word X of which `word` is the right complement: X ^ `word` = pseudoscalar.
pub(super) fn undual(signature: Signature, word: &[u8]) -> (i8, Word) {
    let complement = missing_generators(signature, word);
    let (sign, _) = outer(&complement, word);
    (sign, complement)
}

fn missing_generators(signature: Signature, word: &[u8]) -> Word {
    generators(signature).into_iter().filter(|generator| !word.contains(generator)).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sorting_counts_the_swaps_and_keeps_equal_letters() {
        assert_eq!(sort(vec![3, 1]), (-1, vec![1, 3]));
        assert_eq!(sort(vec![2, 3, 1]), (1, vec![1, 2, 3]));
        assert_eq!(sort(vec![1, 2, 1]), (-1, vec![1, 1, 2]));
    }

    #[test]
    fn partitions_are_all_the_choices_of_that_length_and_no_other() {
        let found = partitions(&[1, 2, 3], 2);
        assert_eq!(found, [(vec![1, 2], vec![3]), (vec![1, 3], vec![2]), (vec![2, 3], vec![1])]);
        assert_eq!(partitions(&[1, 2], 3), []);
        assert_eq!(partitions(&[], 0), [(vec![], vec![])]);
    }

    #[test]
    fn generators_are_null_then_positive_then_negative() {
        let signature = Signature::new(2, 1, 2);
        assert_eq!(generators(signature), [0, 1, 2, 3, 4]);
        let squares: Vec<i8> = generators(signature).into_iter().map(|each| square(signature, each)).collect();
        assert_eq!(squares, [0, 0, 1, 1, -1]);
        assert_eq!(generators(Signature::new(1, 1, 0)), [1, 2]);
        assert_eq!(generators(Signature::new(0, 0, 0)), []);
    }
}
