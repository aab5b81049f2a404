//! Multiplication tables as text.

use super::multivector::write_terms;
use super::{Multivector, ReferenceError, notation};
use crate::algebra::Signature;

/// The multiplication table of a product on a basis, in aligned columns: the left factor at the head of its row, the
/// right one at the head of its column. Blades keep the orientation in which the basis names them; one that it does not
/// name is written with its generators ascending.
///
/// # Errors
/// If the signature has too many dimensions, or a word is not a blade of it.
///
/// ```
/// use ga_codegen::algebra::Signature;
/// use ga_codegen::reference::{Multivector, table};
///
/// let complex = table(Signature::new(0, 1, 0), &["1", "e1"], Multivector::geometric).expect("blades of Cl(0,1,0)");
/// assert_eq!(complex, "    1 e1\n 1  1 e1\ne1 e1 -1\n");
/// ```
pub fn table(
    signature: Signature,
    basis: &[&str],
    product: impl Fn(&Multivector<i64>, &Multivector<i64>) -> Multivector<i64>,
) -> Result<String, ReferenceError> {
    Multivector::<i64>::from_blades::<&str>(signature, [])?;
    let blades: Vec<Multivector<i64>> =
        basis.iter().map(|word| Multivector::from_blades(signature, [(word, 1)])).collect::<Result<_, _>>()?;
    let names: Vec<(&str, _)> =
        basis.iter().map(|&word| Ok((word, notation::parse(signature, word)?))).collect::<Result<_, _>>()?;
    let oriented = |(ascending, value): (String, i64)| {
        let named = names.iter().find(|(_, (_, letters))| notation::name(letters) == ascending);
        named.map_or((ascending, value), |&(word, (sign, _))| (word.to_owned(), value * i64::from(sign)))
    };
    let entry = |left: &Multivector<i64>, right: &Multivector<i64>| {
        write_terms(&product(left, right).blades().into_iter().map(oriented).collect::<Vec<_>>())
    };
    let head = std::iter::once(String::new()).chain(basis.iter().map(|&word| word.to_owned())).collect();
    let row = |(word, left): (&&str, _)| {
        std::iter::once((*word).to_owned()).chain(blades.iter().map(|right| entry(left, right))).collect()
    };
    let rows: Vec<Vec<String>> = std::iter::once(head).chain(basis.iter().zip(&blades).map(row)).collect();
    Ok(aligned(&rows))
}

/// Rows in columns of one width, right-aligned.
fn aligned(rows: &[Vec<String>]) -> String {
    let width = rows.iter().flatten().map(String::len).max().unwrap_or(0);
    let line =
        |row: &Vec<String>| row.iter().map(|cell| format!("{cell:>width$}")).collect::<Vec<_>>().join(" ") + "\n";
    rows.iter().map(line).collect()
}
