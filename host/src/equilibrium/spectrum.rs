//! Eigenvalues of a real matrix, each with a bound of its rounding.
//!
//! In: A, and bounds of the errors of its entries. Out: eigenvalues lambda and, to first order,
//! ```text
//! bound = (n eps |B| + |y|' E |x|) / |y* x|,   B x = lambda x,   y* B = lambda y*,   |x| = |y| = 1
//! ```
//! B is the block of A that lambda belongs to, balanced, E the errors of its entries. Blocks are the sets of entries of
//! the state that act on one another in circles: what is fast in one of them does not round the others. Where
//! eigenvalues repeat, x and y are bases of their null spaces; where these are too small, |y* x| is nearly 0 and the
//! bound as wide as rounding splits the eigenvalue. In exact numbers, as of critical damping, it is not split, and |y*
//! x| is 0: the bound is then the radius of a circle that no eigenvalue crosses while B changes by rounding.

use nalgebra::linalg::{Schur, balancing};
use nalgebra::{Complex, ComplexField, DMatrix, DVector};

/// Iterations for the eigenvalues of one block, at most.
const SWEEPS: usize = 10_000;
/// Where rounding splits an eigenvalue that has one direction for up to four, |y* x| is larger than this.
const SPLIT: f64 = 1e-12;
/// Points of a circle, and how often its radius is doubled.
const POINTS: usize = 16;
const DOUBLINGS: usize = 60;
/// Bounds are wider than to first order by this factor.
const WIDER: f64 = 4.0;

/// An eigenvalue and how far rounding may have moved it.
#[derive(Clone, Copy, Debug)]
pub(super) struct Eigenvalue {
    pub value: Complex<f64>,
    pub bound: f64,
}

/// The eigenvalues; `None` if the iteration does not converge.
pub(super) fn of(a: &DMatrix<f64>, errors: &DMatrix<f64>) -> Option<Vec<Eigenvalue>> {
    let a = a.zip_map(errors, |x, error| if x.abs() <= error { 0.0 } else { x });
    let mut all = Vec::new();
    for places in blocks(&a) {
        let block = |of: &DMatrix<f64>| of.select_rows(&places).select_columns(&places);
        all.extend(of_block(block(&a), block(errors))?);
    }
    Some(all)
}

/// The sets of rows that depend on one another in circles.
fn blocks(a: &DMatrix<f64>) -> Vec<Vec<usize>> {
    let n = a.nrows();
    let mut reaches = a.map(|x| x != 0.0);
    for over in 0..n {
        for from in 0..n {
            for to in 0..n {
                reaches[(from, to)] |= reaches[(from, over)] && reaches[(over, to)];
            }
        }
    }
    let mut blocks: Vec<Vec<usize>> = Vec::new();
    for i in 0..n {
        let mutual = |block: &&mut Vec<usize>| reaches[(i, block[0])] && reaches[(block[0], i)];
        match blocks.iter_mut().find(mutual) {
            Some(block) => block.push(i),
            None => blocks.push(vec![i]),
        }
    }
    blocks
}

fn of_block(block: DMatrix<f64>, errors: DMatrix<f64>) -> Option<Vec<Eigenvalue>> {
    if block.len() == 1 {
        return Some(vec![Eigenvalue { value: Complex::new(block[0], 0.0), bound: errors[0] }]);
    }
    // With its errors: an entry far below those of its row must not make them large.
    let scales = balancing::balance_parlett_reinsch(&mut block.zip_map(&errors, |x, error| x.abs() + error));
    let scaled = |of: &DMatrix<f64>| of.map_with_location(|i, j, x| x * scales[j] / scales[i]);
    let [block, errors] = [&block, &errors].map(scaled);
    let schur = Schur::try_new(block.clone(), f64::EPSILON, SWEEPS)?;
    let values = schur.complex_eigenvalues();
    Some(values.iter().map(|&value| Eigenvalue { value, bound: bound(&block, &errors, value) }).collect())
}

fn bound(block: &DMatrix<f64>, errors: &DMatrix<f64>, value: Complex<f64>) -> f64 {
    let rounding = block.nrows() as f64 * f64::EPSILON * block.norm();
    let (bound, overlap) = first_order(block, errors, value, rounding);
    if overlap > SPLIT { bound } else { bound.min(far(block, value, WIDER * (rounding + errors.norm()))) }
}

/// Radius of a circle about an eigenvalue that no eigenvalue crosses while B changes by up to `epsilon`: on it the
/// smallest singular value of B - z is larger (Trefethen & Embree, Spectra and Pseudospectra, 2.1).
fn far(block: &DMatrix<f64>, value: Complex<f64>, epsilon: f64) -> f64 {
    let n = block.nrows();
    let is_clear = |radius: f64| {
        (0..POINTS).all(|k| {
            let (sin, cos) = (std::f64::consts::TAU * k as f64 / POINTS as f64).sin_cos();
            let z = value + Complex::new(radius * cos, radius * sin);
            let away = block.map(|x| Complex::new(x, 0.0)) - DMatrix::identity(n, n) * z;
            away.singular_values().min() > epsilon
        })
    };
    let radii = std::iter::successors(Some(epsilon), |radius| Some(2.0 * radius));
    radii.take(DOUBLINGS).find(|radius| is_clear(*radius)).unwrap_or(f64::INFINITY)
}

/// The bound to first order of an eigenvalue, and |y* x|.
fn first_order(
    block: &DMatrix<f64>,
    errors: &DMatrix<f64>,
    value: Complex<f64>,
    rounding: f64,
) -> (f64, f64) {
    let n = block.nrows();
    let svd = (block.map(|x| Complex::new(x, 0.0)) - DMatrix::identity(n, n) * value).svd(true, true);
    let (Some(left), Some(right)) = (&svd.u, &svd.v_t) else { return (f64::INFINITY, 0.0) };
    let null = vanishing(&svd.singular_values, WIDER * (rounding + errors.norm()));
    let y = left.select_columns(&null);
    let x = right.select_rows(&null).adjoint();
    let overlap = (y.adjoint() * &x).singular_values().min();
    let size = |of: &DMatrix<Complex<f64>>| of.map(|x| x.modulus());
    let by_errors = (size(&y).transpose() * errors * size(&x)).norm();
    (WIDER * (rounding + by_errors) / overlap.max(f64::MIN_POSITIVE), overlap)
}

/// Places of the singular values up to `none`, of the smallest one at least, the smallest first.
pub(super) fn vanishing(singular_values: &DVector<f64>, none: f64) -> Vec<usize> {
    let mut order: Vec<usize> = (0..singular_values.len()).collect();
    order.sort_by(|&i, &j| singular_values[i].total_cmp(&singular_values[j]));
    let count = order.iter().filter(|&&i| singular_values[i] <= none).count();
    order.truncate(count.max(1));
    order
}

#[cfg(test)]
mod tests {
    use super::*;

    fn exact(rows: &[f64], n: usize) -> Vec<Eigenvalue> {
        of(&DMatrix::from_row_slice(n, n, rows), &DMatrix::zeros(n, n)).expect("eigenvalues")
    }

    #[test]
    fn an_entry_far_below_the_errors_of_its_row_hides_no_eigenvalue() {
        // x' = u, u' = 4 x + y + z, y' = v, v' = e x + 0 z, z' = w, w' = y - 9 z: the 0 is a difference of two 3.
        for small in [1e-12, 1e-20, 1e-26, 1e-34] {
            let (mut a, mut errors) = (DMatrix::zeros(6, 6), DMatrix::zeros(6, 6));
            for (row, column, x) in [
                (0, 1, 1.0),
                (1, 0, 4.0),
                (1, 2, 1.0),
                (1, 4, 1.0),
                (2, 3, 1.0),
                (3, 0, small),
                (4, 5, 1.0),
                (5, 2, 1.0),
                (5, 4, -9.0),
            ] {
                (a[(row, column)], errors[(row, column)]) = (x, x.abs() * 1e-16);
            }
            errors[(3, 4)] = 1e-15;
            let all = of(&a, &errors).expect("eigenvalues");
            let is_found = |value: Complex<f64>| {
                all.iter().any(|own| (own.value - value).modulus() < 1e-10 && own.bound < 1e-6)
            };
            let exact = [(2.0, 0.0), (-2.0, 0.0), (0.0, 3.0), (0.0, -3.0)];
            assert!(exact.iter().all(|(re, im)| is_found(Complex::new(*re, *im))), "{small}: {all:?}");
        }
    }

    #[test]
    fn bounds_hold_and_are_narrow_beside_fast_motions() {
        // The fast one drives the slow ones and does not round them.
        let all = exact(&[0.0, 1.0, 0.3, 0.3, 0.0, 0.2, 0.0, 0.0, -1e12], 3);
        let slow = 0.3_f64.sqrt();
        for expected in [slow, -slow, -1e12] {
            let off = |e: &Eigenvalue| (e.value - Complex::new(expected, 0.0)).modulus();
            let nearest = all.iter().min_by(|a, b| off(a).total_cmp(&off(b))).expect("one");
            assert!(off(nearest) <= nearest.bound, "{expected}: {nearest:?}");
            assert!(nearest.bound <= 1e-14 * expected.abs(), "{expected}: {nearest:?}");
        }
    }

    #[test]
    fn bounds_are_narrow_where_exact_numbers_do_not_split_an_eigenvalue() {
        // m x'' + c x' + k x = 0 with c^2 = 4 k: -c/2 twice; damped, and driven by a negative damper.
        for (k, c) in
            [(4.0, 4.0), (1.0, 2.0), (9.0, 6.0), (0.25, 1.0), (100.0, 20.0), (1e4, 200.0), (1.0, -2.0)]
        {
            for own in exact(&[0.0, 1.0, -k, -c], 2) {
                let off = (own.value - Complex::new(-0.5 * c, 0.0)).modulus();
                assert!(off <= own.bound && own.bound < 1e-6 * f64::abs(c), "{k}, {c}: {own:?}");
            }
        }
        // Two of them, each in two numbers that are coupled: T diag(J, J') T^-1 with T^-1 of whole numbers.
        let t = DMatrix::from_row_slice(
            4,
            4,
            &[1.0, 2.0, 0.0, 1.0, 0.0, 1.0, 3.0, 0.0, 0.0, 0.0, 1.0, 2.0, 0.0, 0.0, 0.0, 1.0],
        );
        let turn = DMatrix::from_row_slice(
            4,
            4,
            &[1.0, 0.0, 0.0, 0.0, 1.0, 1.0, 0.0, 0.0, 2.0, 0.0, 1.0, 0.0, 0.0, 1.0, 1.0, 1.0],
        );
        let jordan = DMatrix::from_row_slice(
            4,
            4,
            &[-2.0, 1.0, 0.0, 0.0, 0.0, -2.0, 0.0, 0.0, 0.0, 0.0, -3.0, 1.0, 0.0, 0.0, 0.0, -3.0],
        );
        let both = &t * &turn;
        let a = &both * jordan * both.clone().try_inverse().expect("regular");
        for own in exact(a.transpose().as_slice(), 4) {
            let off = [-2.0, -3.0].map(|x| (own.value - Complex::new(x, 0.0)).modulus());
            assert!(off[0].min(off[1]) <= own.bound && own.bound < 1e-3, "{own:?}");
        }
    }

    #[test]
    fn bounds_hold_where_rounding_splits_an_eigenvalue() {
        // Three times 2, with one direction: T J T^-1 with T = [1 2 3; 0 1 4; 5 6 0].
        let t = DMatrix::from_row_slice(3, 3, &[1.0, 2.0, 3.0, 0.0, 1.0, 4.0, 5.0, 6.0, 0.0]);
        let jordan = DMatrix::from_row_slice(3, 3, &[2.0, 1.0, 0.0, 0.0, 2.0, 1.0, 0.0, 0.0, 2.0]);
        let a = &t * jordan * t.clone().try_inverse().expect("regular");
        for eigenvalue in of(&a, &DMatrix::zeros(3, 3)).expect("eigenvalues") {
            let off = (eigenvalue.value - Complex::new(2.0, 0.0)).modulus();
            assert!(off <= eigenvalue.bound && eigenvalue.bound < 0.1, "{eigenvalue:?}");
        }
    }
}
