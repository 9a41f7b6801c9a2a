//! Mode shapes: bases of the null spaces of A - lambda.
//!
//! In: A, an eigenvalue and how often it occurs, directions Z in which the state can change. Out: as many shapes Z v,
//! (Z'AZ - lambda) v = 0, as are independent. Where there are several any mixture of them is one too; each of those
//! given has an entry of its own, the largest that there is, in which the others have no part.

use super::spectrum::vanishing;
use nalgebra::linalg::balancing;
use nalgebra::{Complex, ComplexField, DMatrix};

/// Singular values below this fraction of the largest are 0: rounding splits a double eigenvalue by the root of
/// epsilon.
const NONE: f64 = 1e-6;
/// Sizes that differ by less than this fraction are the same, and the first of them counts.
const SAME: f64 = 1e-6;
/// Imaginary parts below this fraction of an entry are rounding.
const REAL: f64 = 1e-9;

type Matrix = DMatrix<Complex<f64>>;

/// At most `most` shapes, each relative to its largest entry.
pub(super) fn of(
    a: &DMatrix<f64>,
    z: &DMatrix<f64>,
    eigenvalue: Complex<f64>,
    most: usize,
) -> Vec<Vec<Complex<f64>>> {
    let space = z.map(|x| Complex::new(x, 0.0)) * null_space(a, eigenvalue, most);
    let own = own_entries(&space);
    let Some(inverse) = space.select_rows(&own).try_inverse() else { return Vec::new() };
    let shapes = space * inverse;
    (0..own.len()).map(|j| relative(shapes.column(j).iter().copied().collect())).collect()
}

/// Columns that span the null space.
fn null_space(a: &DMatrix<f64>, eigenvalue: Complex<f64>, most: usize) -> Matrix {
    let n = a.nrows();
    let mut balanced = a.clone();
    let scales = balancing::balance_parlett_reinsch(&mut balanced);
    let mut shifted = balanced.map(|x| Complex::new(x, 0.0)) - Matrix::identity(n, n) * eigenvalue;
    // Rows of one size: what is soft does not vanish beside what is stiff.
    for mut row in shifted.row_iter_mut() {
        let size = row.iter().map(|x| x.modulus()).fold(0.0, f64::max);
        if size > 0.0 {
            row /= Complex::new(size, 0.0);
        }
    }
    let svd = shifted.svd(false, true);
    let Some(rows) = svd.v_t else { return Matrix::zeros(n, 0) };
    let mut null = vanishing(&svd.singular_values, NONE * svd.singular_values.max());
    null.truncate(most);
    let scales = Matrix::from_diagonal(&scales.map(|x| Complex::new(x, 0.0)));
    scales * rows.select_rows(&null).adjoint()
}

/// An entry for each column, in which the columns are as large and as independent as can be.
fn own_entries(space: &Matrix) -> Vec<usize> {
    let mut rest = space.clone();
    let mut own = Vec::new();
    for _ in 0..space.ncols() {
        let sizes: Vec<f64> = rest.row_iter().map(|row| row.norm()).collect();
        let place = first_largest(&sizes);
        let along = rest.row(place).normalize();
        rest -= &rest * along.adjoint() * &along;
        own.push(place);
    }
    own
}

/// Entries divided by the largest of them.
fn relative(shape: Vec<Complex<f64>>) -> Vec<Complex<f64>> {
    let sizes: Vec<f64> = shape.iter().map(|x| x.modulus()).collect();
    let largest = first_largest(&sizes);
    let without_rounding = |x: Complex<f64>| {
        if x.im.abs() <= REAL * x.modulus() { Complex::new(x.re, 0.0) } else { x }
    };
    let part = |(i, x): (usize, &Complex<f64>)| match i == largest {
        true => Complex::new(1.0, 0.0),
        false => without_rounding(x / shape[largest]),
    };
    shape.iter().enumerate().map(part).collect()
}

fn first_largest(sizes: &[f64]) -> usize {
    let largest = sizes.iter().copied().fold(0.0, f64::max);
    sizes.iter().position(|size| *size >= largest * (1.0 - SAME)).unwrap_or(0)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn shapes_of_one_eigenvalue_have_entries_of_their_own() {
        // A = 3 - w w' with w = (1, 1, 1): 3 twice, across w.
        let a = DMatrix::from_fn(3, 3, |i, j| if i == j { 2.0 } else { -1.0 });
        let shapes = of(&a, &DMatrix::identity(3, 3), Complex::new(3.0, 0.0), 2);
        let [first, second] = shapes.as_slice() else { panic!("{shapes:?}") };
        for (shape, own, other) in [(first, 0, 1), (second, 1, 0)] {
            let sum: Complex<f64> = shape.iter().sum();
            assert!(sum.modulus() < 1e-14, "{shape:?} is not across w");
            assert_eq!(shape[own], Complex::new(1.0, 0.0), "{shape:?}");
            assert!(shape[other].modulus() < 1e-14, "{shape:?}");
        }
    }

    #[test]
    fn an_eigenvalue_with_one_direction_has_one_shape() {
        let a = DMatrix::from_row_slice(2, 2, &[2.0, 1.0, 0.0, 2.0]);
        let shapes = of(&a, &DMatrix::identity(2, 2), Complex::new(2.0, 0.0), 2);
        assert_eq!(shapes, [[Complex::new(1.0, 0.0), Complex::new(0.0, 0.0)]]);
    }
}
