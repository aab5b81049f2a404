//! The spectral norm of a matrix without negative entries, from above.

/// How often the test vector is improved.
const STEPS: usize = 12;

/// Above the rounding errors of the computation itself.
const SLACK: f64 = 1.0 + 1e-12;

/// A number that the spectral norm of the matrix with these columns does not exceed.
///
/// The squared norm is the greatest eigenvalue of B = A A^T, which is at most the maximum of (B v)_i / v_i for every
/// positive vector v (Collatz). Steps of the power method bring v to the eigenvector and the maximum down.
pub(super) fn norm_bound(columns: &[Vec<f64>]) -> f64 {
    let height = columns.first().map_or(0, Vec::len);
    let mut square = vec![vec![0.0; height]; height];
    for column in columns {
        for (row, &a) in square.iter_mut().zip(column).filter(|(_, a)| **a > 0.0) {
            for (sum, &b) in row.iter_mut().zip(column) {
                *sum += a * b;
            }
        }
    }
    square.retain(|row| row.iter().any(|&entry| entry > 0.0));
    let live: Vec<usize> = (0..height).filter(|&row| columns.iter().any(|column| column[row] > 0.0)).collect();
    let mut vector = vec![1.0; live.len()];
    let mut least = f64::INFINITY;
    for _ in 0..STEPS {
        let image: Vec<f64> =
            square.iter().map(|row| live.iter().zip(&vector).map(|(&column, v)| row[column] * v).sum()).collect();
        let ratio = image.iter().zip(&vector).map(|(image, v)| image / v).fold(0.0, f64::max);
        least = least.min(ratio);
        let greatest = image.iter().copied().fold(0.0, f64::max);
        // Adding a little of every direction keeps the vector positive.
        vector = image.iter().map(|entry| entry / greatest + 1e-6).collect();
    }
    if live.is_empty() { 0.0 } else { least.sqrt() * SLACK }
}
