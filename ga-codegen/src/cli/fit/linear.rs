//! Systems of linear equations.

use super::number::{Number, magnitude};

/// The solution of a regular system by Gaussian elimination with partial pivoting; every row is followed by its right
/// side.
pub(super) fn solve(mut rows: Vec<Vec<Number>>) -> Vec<Number> {
    let size = rows.len();
    for column in 0..size {
        let pivot = (column..size).max_by_key(|&row| magnitude(rows[row][column].clone())).unwrap_or(column);
        rows.swap(column, pivot);
        let (above, below) = rows.split_at_mut(column + 1);
        let pivot = &above[column];
        for row in below {
            let factor = &row[column] / &pivot[column];
            for (entry, subtracted) in row.iter_mut().zip(pivot).skip(column) {
                *entry -= &factor * subtracted;
            }
        }
    }
    let mut solution: Vec<Number> = Vec::new();
    // From the last unknown to the first.
    for (index, row) in rows.iter().enumerate().rev() {
        let known = row[index + 1..size].iter().zip(solution.iter().rev());
        let rest = known.fold(row[size].clone(), |rest, (entry, value)| rest - entry * value);
        solution.push(rest / &row[index]);
    }
    solution.reverse();
    solution
}
