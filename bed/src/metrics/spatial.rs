//! Metrics of one map: peak, mean, spread, areas, gradient, centre of pressure, and load balance.
//!
//! In: pressures (Pa) with areas or a grid. Out: numbers in SI units; `None` if there is nothing to measure.

use crate::map::{Grid, Site};

/// Largest pressure (Pa).
#[must_use]
pub fn peak(pressure: &[f64]) -> f64 {
    pressure.iter().fold(0.0, |most: f64, p| most.max(*p))
}

/// Mean and spread of the pressure over the sites in contact.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Spread {
    /// Mean, weighted by area (Pa).
    pub mean: f64,
    /// Standard deviation, weighted by area (Pa).
    pub deviation: f64,
    /// Standard deviation divided by mean.
    pub variation: f64,
}

/// Mean and spread over the sites in contact; `None` if there are none.
#[must_use]
pub fn spread(sites: &[Site], pressure: &[f64], contact: f64) -> Option<Spread> {
    let touching = || sites.iter().zip(pressure).filter(|(_, p)| **p > contact);
    let area: f64 = touching().map(|(s, _)| s.area).sum();
    if area <= 0.0 {
        return None;
    }
    let mean = touching().map(|(s, p)| s.area * p).sum::<f64>() / area;
    let square = touching().map(|(s, p)| s.area * (p - mean) * (p - mean)).sum::<f64>() / area;
    let deviation = square.sqrt();
    Some(Spread { mean, deviation, variation: deviation / mean })
}

/// Area (m^2) with more than this pressure (Pa).
#[must_use]
pub fn area_above(sites: &[Site], pressure: &[f64], limit: f64) -> f64 {
    // `sum` of no floats would be -0.
    sites.iter().zip(pressure).filter(|(_, p)| **p > limit).fold(0.0, |sum, (s, _)| sum + s.area)
}

/// Dispersion index (%): share of the pressure on the sites of a region, 100 sum_R p/sum p; `None` without load.
#[must_use]
pub fn dispersion(sites: &[Site], pressure: &[f64], of_region: impl Fn(&Site) -> bool) -> Option<f64> {
    let all: f64 = pressure.iter().sum();
    let part: f64 = sites.iter().zip(pressure).filter(|(s, _)| of_region(s)).map(|(_, p)| p).sum();
    (all > 0.0).then(|| 100.0 * part / all)
}

/// Peak pressure index (Pa): largest mean over a square window of this area (m^2), at any position within the map.
///
/// Between the edges of sensels the mean is bilinear in the window's position, so that its maximum occurs where edges
/// of the window coincide with edges of sensels: only these positions are tried. `None` if the map is smaller than the
/// window.
#[must_use]
pub fn peak_pressure_index(grid: &Grid, pressure: &[f64], area: f64) -> Option<f64> {
    let side = area.sqrt();
    let across = starts(grid.columns, grid.column_pitch, side);
    let along = starts(grid.rows, grid.row_pitch, side);
    if pressure.len() != grid.sites() || across.is_empty() || along.is_empty() {
        return None;
    }
    let load = Integral::new(grid, pressure);
    let mut most = 0.0_f64;
    for y in &along {
        for x in &across {
            let (right, top) = (x + side / grid.column_pitch, y + side / grid.row_pitch);
            let inside = load.at(right, top) - load.at(*x, top) - load.at(right, *y) + load.at(*x, *y);
            most = most.max(inside * grid.cell() / area);
        }
    }
    Some(most)
}

/// Positions (in sensels) at which a window of this side begins or ends on an edge of sensels.
fn starts(count: usize, pitch: f64, side: f64) -> Vec<f64> {
    let (length, width) = (count as f64, side / pitch);
    // Tolerance so that a window as wide as the map is not lost to rounding.
    let fits = |x: f64| x > -1e-9 && x + width < length + 1e-9;
    let edges = (0..=count).map(|edge| edge as f64);
    edges.flat_map(|edge| [edge, edge - width]).filter(|x| fits(*x)).map(|x| x.max(0.0)).collect()
}

/// Summed-area table: sum of the pressures at lower rows and columns.
struct Integral {
    columns: usize,
    rows: usize,
    sums: Vec<f64>,
}

impl Integral {
    fn new(grid: &Grid, pressure: &[f64]) -> Integral {
        let (rows, columns) = (grid.rows, grid.columns);
        let wide = columns + 1;
        let mut sums = vec![0.0; wide * (rows + 1)];
        for row in 0..rows {
            let mut line = 0.0;
            for column in 0..columns {
                line += pressure[row * columns + column];
                sums[(row + 1) * wide + column + 1] = sums[row * wide + column + 1] + line;
            }
        }
        Integral { columns, rows, sums }
    }

    /// The sum at a position in sensels; bilinear between the edges.
    fn at(&self, x: f64, y: f64) -> f64 {
        let split = |at: f64, count: usize| {
            let whole = (at.floor().max(0.0) as usize).min(count.saturating_sub(1));
            (whole, (at - whole as f64).clamp(0.0, 1.0))
        };
        let ((i, u), (j, v)) = (split(x, self.columns), split(y, self.rows));
        let sum = |i: usize, j: usize| self.sums[j * (self.columns + 1) + i];
        let below = (1.0 - u) * sum(i, j) + u * sum(i + 1, j);
        let above = (1.0 - u) * sum(i, j + 1) + u * sum(i + 1, j + 1);
        (1.0 - v) * below + v * above
    }
}

/// Gradients of a map. They depend on the pitch of the grid, which is therefore always reported with them.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Gradient {
    /// Largest difference between two neighbours, divided by their distance (Pa/m).
    pub largest: f64,
    /// Root mean square of the gradient (Pa/m): central differences inside, one-sided ones at edges.
    pub root_mean_square: f64,
}

/// Gradients of a map; a single row or column has none in the other direction.
#[must_use]
pub fn gradient(grid: &Grid, pressure: &[f64]) -> Gradient {
    let at = |row: usize, column: usize| pressure[row * grid.columns + column];
    let (mut largest, mut squares) = (0.0_f64, 0.0);
    for row in 0..grid.rows {
        for column in 0..grid.columns {
            if column + 1 < grid.columns {
                largest = largest.max((at(row, column + 1) - at(row, column)).abs() / grid.column_pitch);
            }
            if row + 1 < grid.rows {
                largest = largest.max((at(row + 1, column) - at(row, column)).abs() / grid.row_pitch);
            }
            let across = slope(grid.columns, column, grid.column_pitch, |i| at(row, i));
            let along = slope(grid.rows, row, grid.row_pitch, |i| at(i, column));
            squares += across * across + along * along;
        }
    }
    let count = grid.sites().max(1) as f64;
    Gradient { largest, root_mean_square: (squares / count).sqrt() }
}

/// Difference quotient at one of several values along a line.
fn slope(count: usize, index: usize, pitch: f64, value: impl Fn(usize) -> f64) -> f64 {
    let (low, high) = (index.saturating_sub(1), (index + 1).min(count - 1));
    if high > low { (value(high) - value(low)) / ((high - low) as f64 * pitch) } else { 0.0 }
}

/// Root mean square of the difference between two maps of the same sites.
#[must_use]
pub fn apart(one: &[f64], other: &[f64]) -> f64 {
    let squares = one.iter().zip(other).map(|(p, q)| (p - q).powi(2));
    (squares.sum::<f64>() / one.len().max(1) as f64).sqrt()
}

/// Centre of pressure (m); `None` without load.
#[must_use]
pub fn centre(grid: &Grid, pressure: &[f64]) -> Option<[f64; 2]> {
    let load: f64 = pressure.iter().sum();
    if load <= 0.0 {
        return None;
    }
    let mut moment = [0.0; 2];
    for (site, p) in pressure.iter().enumerate() {
        let [x, y] = grid.middle(site);
        moment[0] += p * x;
        moment[1] += p * y;
    }
    Some([moment[0] / load, moment[1] / load])
}

/// Relative error of the load of a map: |sum p A n_z + sum tau_z A - W|/W, with n_z and tau_z upwards. At rest a map is
/// valid below 1 %.
#[must_use]
pub fn load_error(sites: &[Site], pressure: &[f64], up: &[f64], shear_up: &[f64], weight: f64) -> f64 {
    let normal: f64 = sites.iter().zip(pressure).zip(up).map(|((s, p), n)| p * s.area * n).sum();
    let tangential: f64 = sites.iter().zip(shear_up).map(|(s, t)| t * s.area).sum();
    (normal + tangential - weight).abs() / weight
}
