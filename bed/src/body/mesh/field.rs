//! A smooth approximation of the distance field: cubic B-splines through values on a grid.
//!
//! In: the bounds of a surface and its distance at a point. Out: value, gradient and second derivatives anywhere near
//! it, all continuous: f = sum c_ijk B(x - i) B(y - j) B(z - k), which interpolates the exact distance at every point
//! of the grid, with natural ends. The error on a smooth surface is of order h^4; edges are rounded over about one cell
//! h.

use crate::equilibrium::side_by_side;
use smartbed_runtime::vec3::Vec3;

/// Approximate number of grid points within the bounds.
const POINTS: f64 = 3e5;
/// Smallest cell (m).
const SMALLEST: f64 = 5e-4;
/// Margin of the field around the bounds (m): the largest distance of the thickest sensors between tissue and sheets.
pub const AROUND: f64 = 0.02;

/// Spline coefficients on a grid.
#[derive(Clone, Debug, PartialEq)]
pub struct Field {
    cell: f64,
    start: Vec3<f64>,
    counts: [usize; 3],
    coefficients: Vec<f64>,
}

/// Distance (m) with its first and second derivatives.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Near {
    /// Distance (m).
    pub distance: f64,
    /// Unit length except near edges.
    pub gradient: Vec3<f64>,
    /// Second derivatives (1/m).
    pub hessian: [Vec3<f64>; 3],
}

/// Spacing of the grid for these bounds (m).
pub(super) fn cell([low, high]: &[Vec3<f64>; 2]) -> f64 {
    let volume: f64 = (0..3).map(|k| high[k] - low[k]).product();
    (volume / POINTS).cbrt().max(SMALLEST)
}

impl Field {
    /// Fills a grid around the bounds; `distance` is given an upper bound of the distance.
    pub(super) fn new(bounds: [Vec3<f64>; 2], distance: impl Fn(Vec3<f64>, f64) -> f64 + Sync) -> Field {
        let sides = [0, 1, 2].map(|k| bounds[1][k] - bounds[0][k]);
        let cell = cell(&bounds);
        // Near the ends the splines degenerate to lines: one more cell at each end is not used.
        let around = (AROUND / cell).ceil() as usize + 2;
        let counts = sides.map(|side| (side / cell).ceil() as usize + 1 + 2 * around);
        let start = [0, 1, 2].map(|k| {
            let spare = (counts[k] - 1) as f64 * cell - sides[k];
            bounds[0][k] - 0.5 * spare
        });
        let at = |i: usize, j: usize, k: usize| {
            let cells = [i, j, k];
            [0, 1, 2].map(|axis| start[axis] + cells[axis] as f64 * cell)
        };
        let slab = |k: usize| {
            let mut values = Vec::with_capacity(counts[0] * counts[1]);
            for j in 0..counts[1] {
                // One step along a row changes the distance by at most its length.
                let mut near = f64::INFINITY;
                for i in 0..counts[0] {
                    let value: f64 = distance(at(i, j, k), near);
                    near = value.abs() + cell;
                    values.push(value);
                }
            }
            values
        };
        let mut coefficients = side_by_side::run(counts[2], slab).concat();
        let strides = [1, counts[0], counts[0] * counts[1]];
        for axis in 0..3 {
            for line in 0..coefficients.len() / counts[axis] {
                let (low, high) = (line % strides[axis], line / strides[axis]);
                let first = high * strides[axis] * counts[axis] + low;
                through(&mut coefficients[first..], strides[axis], counts[axis]);
            }
        }
        Field { cell, start, counts, coefficients }
    }

    /// Spacing of the grid (m).
    #[must_use]
    pub fn cell(&self) -> f64 {
        self.cell
    }

    /// The field at a point within [`AROUND`] of the bounds; `None` elsewhere.
    #[must_use]
    pub fn near(&self, point: Vec3<f64>) -> Option<Near> {
        let (mut first, mut weights) = ([0; 3], [[[0.0; 3]; 4]; 3]);
        for axis in 0..3 {
            let x = (point[axis] - self.start[axis]) / self.cell;
            if !(1.0..(self.counts[axis] - 2) as f64).contains(&x) {
                return None;
            }
            first[axis] = x as usize - 1;
            weights[axis] = splines(x.fract());
        }
        let [wx, wy, wz] = weights;
        // Values and first and second derivatives: summed along x, then along y, then along z.
        let mut sums = [0.0; 10];
        for (k, [w, dw, ddw]) in wz.into_iter().enumerate() {
            let mut plane = [0.0; 6];
            for (j, wy) in wy.iter().enumerate() {
                let from = ((first[2] + k) * self.counts[1] + first[1] + j) * self.counts[0] + first[0];
                let row = &self.coefficients[from..from + 4];
                let x = [0, 1, 2].map(|of| row.iter().zip(&wx).map(|(c, w)| c * w[of]).sum::<f64>());
                for (own, (dx, dy)) in plane.iter_mut().zip(ORDERS) {
                    *own += x[dx] * wy[dy];
                }
            }
            let [f, fx, fy, fxx, fxy, fyy] = plane;
            let values = [f, fx, fy, fxx, fxy, fyy].map(|value| value * w).into_iter();
            let terms = values.chain([f * dw, fx * dw, fy * dw, f * ddw]);
            sums.iter_mut().zip(terms).for_each(|(sum, term)| *sum += term);
        }
        let (h, square) = (self.cell, self.cell * self.cell);
        let [f, fx, fy, fxx, fxy, fyy, fz, fxz, fyz, fzz] = sums;
        Some(Near {
            distance: f,
            gradient: [fx, fy, fz].map(|g| g / h),
            hessian: [[fxx, fxy, fxz], [fxy, fyy, fyz], [fxz, fyz, fzz]].map(|row| row.map(|x| x / square)),
        })
    }
}

/// Orders of derivatives in x and y for which planes are summed.
const ORDERS: [(usize, usize); 6] = [(0, 0), (1, 0), (0, 1), (2, 0), (1, 1), (0, 2)];

/// The four B-splines that are non-zero in a cell, at the share t of it, each with first and second derivatives.
fn splines(t: f64) -> [[f64; 3]; 4] {
    let s = 1.0 - t;
    let inner = |t: f64| (4.0 - 6.0 * t * t + 3.0 * t * t * t) / 6.0;
    [
        [s * s * s / 6.0, -0.5 * s * s, s],
        [inner(t), 1.5 * t * t - 2.0 * t, 3.0 * t - 2.0],
        [inner(s), 2.0 * s - 1.5 * s * s, 3.0 * s - 2.0],
        [t * t * t / 6.0, 0.5 * t * t, t],
    ]
}

/// Converts values along a line to coefficients: c_0 = f_0, c_i-1 + 4 c_i + c_i+1 = 6 f_i, c_n = f_n.
fn through(values: &mut [f64], stride: usize, count: usize) {
    let mut factors = vec![0.0; count];
    for i in 1..count - 1 {
        let before = values[(i - 1) * stride];
        factors[i] = 1.0 / (4.0 - factors[i - 1]);
        values[i * stride] = (6.0 * values[i * stride] - before) * factors[i];
    }
    // Back substitution, from the last row, whose neighbour is known.
    for i in (1..count - 1).rev() {
        values[i * stride] -= factors[i] * values[(i + 1) * stride];
    }
}
