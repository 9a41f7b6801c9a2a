//! Rank of the constraints at sampled configurations, from numbers.
//!
//! In: the candidate rows of the kinematics over all unknowns (speeds and lifted twists). Out: rank at
//! every sample by singular values of the rows at unit length, and the worst conditioning.

use nalgebra::DMatrix;
use smartbed_codegen::id::Id;
use smartbed_codegen::kinematics::{Kinematics, eliminate};
use smartbed_codegen::model::Model;

/// A singular value below this share of the largest counts as zero.
const ZERO: f64 = 1e-8;

/// What the samples say.
#[derive(Clone, PartialEq, Debug)]
pub(super) struct Rank {
    /// Speeds and lifted unknowns.
    pub unknowns: usize,
    /// Scalar configuration constraints.
    pub residuals: usize,
    /// Configurations looked at.
    pub samples: usize,
    /// Smallest rank over the samples.
    pub smallest: usize,
    /// Largest rank over the samples.
    pub largest: usize,
    /// Smallest over largest non-zero singular value, at the worst sample; 1 without constraints.
    pub worst_ratio: f64,
    /// That sample's coordinates.
    pub worst_at: Vec<f64>,
}

impl Rank {
    /// Looks at every sample.
    pub fn over_samples(model: &Model, k: &mut Kinematics) -> Self {
        let mut table = eliminate::sample_table(model, k);
        let (samples, unknowns) = (k.samples.len(), k.unknowns.len());
        let mut rank = Self {
            unknowns,
            residuals: k.residuals.len(),
            samples,
            smallest: usize::MAX,
            largest: 0,
            worst_ratio: 1.0,
            worst_at: k.samples.first().cloned().unwrap_or_default(),
        };
        let mut matrices = vec![DMatrix::<f64>::zeros(k.rows.len(), unknowns); samples];
        for (r, row) in k.rows.iter().enumerate() {
            for (unknown, &coefficient) in &row.coefficients {
                let values = table.values(&k.dag, coefficient);
                for (matrix, value) in matrices.iter_mut().zip(values) {
                    matrix[(r, unknown.index())] = *value;
                }
            }
        }
        for (sample, matrix) in matrices.into_iter().enumerate() {
            let (found, ratio) = numeric_rank(matrix);
            rank.smallest = rank.smallest.min(found);
            rank.largest = rank.largest.max(found);
            if ratio < rank.worst_ratio {
                rank.worst_ratio = ratio;
                rank.worst_at.clone_from(&k.samples[sample]);
            }
        }
        rank.smallest = rank.smallest.min(rank.largest);
        rank
    }

    /// Degrees of freedom left by the constraints.
    pub fn freedom(&self) -> usize {
        self.unknowns - self.largest
    }
}

/// Rank, and smallest over largest singular value that counts.
fn numeric_rank(mut matrix: DMatrix<f64>) -> (usize, f64) {
    if matrix.is_empty() || matrix.iter().any(|x| !x.is_finite()) {
        return (0, 1.0);
    }
    for mut row in matrix.row_iter_mut() {
        let length = row.norm();
        if length > 0.0 {
            row /= length;
        }
    }
    let values = matrix.singular_values();
    let largest = values.max();
    let counted = values.iter().filter(|v| **v > ZERO * largest);
    let (n, smallest) = counted.fold((0, largest), |(n, s), v| (n + 1, s.min(*v)));
    (n, if n > 0 { smallest / largest } else { 1.0 })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn dependent_rows_do_not_count() {
        let matrix = DMatrix::from_row_slice(3, 3, &[1.0, 2.0, 0.0, 2.0, 4.0, 0.0, 0.0, 0.0, 5.0]);
        let (rank, ratio) = numeric_rank(matrix);
        assert_eq!(rank, 2);
        assert!(ratio > 0.5 && ratio < 1.0, "{ratio}");
    }
}
