//! Resamples a map on a finer grid of sites than the sheets' nodes, for example 1 mm.
//!
//! In: a map on nodes. Out: the map on a grid that divides each node's cell evenly; pressure is bilinear between nodes,
//! which conserves the load.

use crate::map::{Frame, Grid, Site};

/// Number of parts of each cell along x and y such that none is wider than `pitch` (m).
#[must_use]
pub fn parts(grid: &Grid, pitch: f64) -> [usize; 2] {
    [grid.column_pitch, grid.row_pitch].map(|side| ((side / pitch - 1e-9).ceil() as usize).max(1))
}

/// The grid of the parts.
#[must_use]
pub fn grid(grid: &Grid, [across, along]: [usize; 2]) -> Grid {
    Grid {
        rows: grid.rows * along,
        columns: grid.columns * across,
        row_pitch: grid.row_pitch / along as f64,
        column_pitch: grid.column_pitch / across as f64,
    }
}

/// A frame on the finer grid. A node is at the lower left corner of its cell. The forces p A of the nodes, divided by
/// the area of a cell, are interpolated bilinearly; the total is conserved up to rounding if the outer rims carry
/// nothing.
#[must_use]
pub fn frame(coarse: &Grid, sites: &[Site], truth: &Frame, parts: [usize; 2]) -> Frame {
    let cell = coarse.cell();
    let value = |row: usize, column: usize| {
        let site = row * coarse.columns + column;
        if row >= coarse.rows || column >= coarse.columns {
            return [0.0; 3];
        }
        let share = sites[site].area / cell;
        let [x, y] = truth.shear.get(site).copied().unwrap_or_default();
        [truth.pressure[site] * share, x * share, y * share]
    };
    let fine = grid(coarse, parts);
    let one = |site: usize| {
        let (row, column) = (site / fine.columns, site % fine.columns);
        let split = |at: usize, parts: usize| (at / parts, ((at % parts) as f64 + 0.5) / parts as f64);
        let ((j, t), (i, s)) = (split(row, parts[1]), split(column, parts[0]));
        let corners = [value(j, i), value(j, i + 1), value(j + 1, i), value(j + 1, i + 1)];
        let weights = [(1.0 - s) * (1.0 - t), s * (1.0 - t), (1.0 - s) * t, s * t];
        [0, 1, 2].map(|k| corners.iter().zip(weights).map(|(c, w)| c[k] * w).sum::<f64>())
    };
    let values: Vec<[f64; 3]> = (0..fine.sites()).map(one).collect();
    let shear =
        if truth.shear.is_empty() { Vec::new() } else { values.iter().map(|v| [v[1], v[2]]).collect() };
    Frame { time: truth.time, seconds: truth.seconds, pressure: values.iter().map(|v| v[0]).collect(), shear }
}
