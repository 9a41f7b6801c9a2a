//! Rates and their Jacobians at the state of a search for equilibrium.
//!
//! In: a [`Search`] with its present state. Out: the rates there, which of them have to vanish, their derivatives by
//! the unknowns, Newton's step, and how far from balance they are.

use super::search::{Entry, Flat, Rates, Search, Slopes, Unknown};
use nalgebra::{DMatrix, DVector};

/// Derivatives by a coordinate below this fraction of the largest are rounding: nothing depends on it.
pub(super) const NO_SLOPE: f64 = 1e-12;
/// The same of the largest of all rates, where those of the own one are compared first: a soft spring beside a stiff
/// one is no rounding.
const NO_SLOPE_OF_ALL: f64 = 1e-15;
/// Where a coordinate that moves is looked at too, from where it is, in units of its half range.
const FURTHER_ON: [f64; 2] = [0.37, -0.61];
/// Passes of scaling rows and columns to entries of size 1.
const PASSES: usize = 8;

impl Flat {
    /// Singular values below this fraction of the largest are zero.
    fn limit(self) -> f64 {
        match self {
            Self::Ranges => 1e-9,
            Self::Scaled => 1e-13,
        }
    }
}

impl Search<'_> {
    /// Rates and slopes here, or why there are none.
    pub(super) fn rates(&mut self) -> Result<Rates, &'static str> {
        let (n_q, n_u) = (self.q.len(), self.u.len());
        let (mut q_dot, mut u_dot) = (vec![0.0; n_q], vec![0.0; n_u]);
        self.engine.set_time(0.0);
        let pivot = (self.engine.rates(0.0, &self.q, &self.u, &self.inputs, &mut q_dot, &mut u_dot))
            .map_err(|fault| fault.reason())?;
        let near = self.near()?;
        let n = self.state.len();
        let (a, rest) = near.split_at(n * n);
        let b = &rest[..n * self.inputs.len()];
        let x_dot = self.state.iter().map(|e| if e.is_speed { u_dot[e.place] } else { q_dot[e.place] });
        let x_dot = DVector::from_iterator(n, x_dot);
        let slopes = Slopes {
            a: DMatrix::from_row_slice(n, n, a),
            b: DMatrix::from_row_slice(n, self.inputs.len(), b),
            directions: self.directions(),
        };
        if !x_dot.iter().all(|x| x.is_finite()) {
            return Err("the accelerations are not finite: the configuration is singular");
        }
        if !slopes.a.iter().chain(&slopes.b).all(|x| x.is_finite()) {
            return Err(
                "the slopes of the accelerations are not finite: a root of 0, or two points that coincide",
            );
        }
        let depends = if self.moves() { self.dependence(&x_dot, &slopes.a) } else { DMatrix::default() };
        Ok(Rates { x_dot, slopes, pivot, depends })
    }

    /// Which rates depend on which entries of the state: here, and on a coordinate that moves also further on, since its
    /// slope may vanish where it is, as on the crest of a wave.
    fn dependence(&mut self, x_dot: &DVector<f64>, a: &DMatrix<f64>) -> DMatrix<bool> {
        let mut depends = self.above_rounding(a);
        let (here, n) = (self.place(), self.state.len());
        let vectors = self.unit_vectors();
        let moves = |j: usize| x_dot[j] != 0.0 && !vectors.iter().flatten().any(|&own| own == j);
        let moving: Vec<usize> = (0..n).filter(|&j| !self.state[j].is_speed && moves(j)).collect();
        for j in moving {
            let Entry { place, scale, .. } = self.state[j];
            for part in FURTHER_ON {
                let mut q = here.0.clone();
                q[place] += part * scale;
                let Ok(q) = self.configurations.follow(0.0, &here.0, &q) else { continue };
                self.q = q;
                if let Ok(near) = self.near() {
                    let there = self.above_rounding(&DMatrix::from_row_slice(n, n, &near[..n * n]));
                    (0..n).for_each(|i| depends[(i, j)] |= there[(i, j)]);
                }
            }
        }
        self.return_to(here);
        depends
    }

    /// Which slopes here are more than rounding.
    fn above_rounding(&mut self, a: &DMatrix<f64>) -> DMatrix<bool> {
        let (bounds, largest) = (self.slope_bounds(), a.amax());
        DMatrix::from_fn(a.nrows(), a.ncols(), |i, j| {
            let least = (NO_SLOPE * a.row(i).amax()).max(NO_SLOPE_OF_ALL * largest).max(bounds[(i, j)]);
            a[(i, j)].is_finite() && a[(i, j)].abs() > least
        })
    }

    /// The identity, without one column for each vector of unit length e: its columns are Householder's reflection of
    /// the axis nearest to e, without the reflected axis, which is along e.
    fn directions(&self) -> DMatrix<f64> {
        let n = self.state.len();
        let mut all = DMatrix::identity(n, n);
        let mut along = Vec::new();
        for vector in self.unit_vectors() {
            let mut normal = self.along(&vector);
            let nearest = normal.iamax();
            normal[nearest] += normal[nearest].signum();
            all -= &normal * normal.transpose() * (2.0 / normal.norm_squared());
            along.push(nearest);
        }
        along.sort_unstable();
        all.remove_columns_at(&along)
    }

    /// The vectors of unit length among the coordinates, as places in the state.
    fn unit_vectors(&self) -> Vec<Vec<usize>> {
        let entry = |place: &usize| self.state.iter().position(|e| !e.is_speed && e.place == *place);
        let vectors = self.configurations.unit_vectors().iter();
        vectors.filter_map(|places| places.iter().map(entry).collect()).collect()
    }

    /// The state in which these entries are as they are and all others 0.
    fn along(&self, entries: &[usize]) -> DVector<f64> {
        let value = |i: usize, _| if entries.contains(&i) { self.q[self.state[i].place] } else { 0.0 };
        DVector::from_fn(self.state.len(), value)
    }

    /// What the derived function gives here: the linearisation, and the inputs as the laws command them.
    pub(super) fn near(&mut self) -> Result<Vec<f64>, &'static str> {
        self.engine.function(0, (0.0, &self.q, &self.u, &self.inputs, &[])).map_err(|fault| fault.reason())
    }

    /// The inputs, those with a law as it commands them.
    pub(super) fn commanded(&mut self) -> Result<Vec<f64>, &'static str> {
        if !self.has_laws {
            return Ok(self.inputs.clone());
        }
        let near = self.near()?;
        Ok(near[near.len() - self.inputs.len()..].to_vec())
    }

    /// Rates that have to vanish: accelerations, and rates of coordinates on which these rates depend. The heading of a
    /// disc moves its place, but neither of them its accelerations: both may change.
    pub(super) fn rows(&self, here: &Rates) -> Vec<usize> {
        let mut rows: Vec<usize> = (0..self.state.len()).filter(|&i| self.state[i].is_speed).collect();
        let vectors = if self.moves() { self.unit_vectors() } else { Vec::new() };
        // Rows are appended while they are gone through: each brings the coordinates that its rate depends on.
        let mut next = 0;
        while self.moves() && next < rows.len() {
            let i = rows[next];
            let found: Vec<usize> = (0..self.state.len()).filter(|&j| here.depends[(i, j)]).collect();
            // What depends on one Euler parameter to first order depends on all four a little further on.
            let whole = vectors.iter().filter(|v| v.iter().any(|j| found.contains(j))).flatten();
            for &j in found.iter().chain(whole) {
                if !rows.contains(&j) {
                    rows.push(j);
                }
            }
            next += 1;
        }
        rows.sort_unstable();
        rows
    }

    /// Is it one of the Euler parameters?
    pub(super) fn is_euler_parameter(&self, name: &str) -> bool {
        self.unit_vectors().iter().flatten().any(|&j| self.state[j].name == name)
    }

    /// The Jacobian J: rows of the rates that have to vanish, columns of the unknowns, scaled.
    pub(super) fn slopes_of_unknowns(&self, here: &Rates, rows: &[usize]) -> DMatrix<f64> {
        match self.unknown {
            Unknown::State => {
                let free: Vec<usize> = (0..self.state.len()).filter(|&j| !self.state[j].is_held).collect();
                let scales = free.iter().map(|&j| self.state[j].scale).collect::<Vec<_>>();
                let mut a = here.slopes.a.clone();
                // Across vectors of unit length only: along them nothing can change.
                for vector in
                    self.unit_vectors().iter().filter(|vector| vector.iter().all(|j| free.contains(j)))
                {
                    let e = self.along(vector);
                    a -= &a * &e * e.transpose();
                }
                DMatrix::from_fn(rows.len(), free.len(), |i, j| a[(rows[i], free[j])] * scales[j])
            }
            Unknown::Inputs => {
                let free = &self.free_inputs;
                DMatrix::from_fn(rows.len(), free.len(), |i, j| here.slopes.b[(rows[i], free[j])])
            }
        }
    }

    /// The step of least norm that makes the rates vanish to first order, in units of the unknowns' ranges.
    pub(super) fn newton_step(&self, here: &Rates, flat: Flat) -> Option<DVector<f64>> {
        let rows = self.rows(here);
        let mut slopes = self.slopes_of_unknowns(here, &rows);
        let mut rest = DVector::from_iterator(rows.len(), rows.iter().map(|&i| -here.x_dot[i]));
        if slopes.is_empty() {
            return None;
        }
        let (row_sizes, column_sizes) = scale(&mut slopes, flat);
        rest.component_div_assign(&row_sizes);
        let svd = slopes.svd(true, true);
        let step = svd.solve(&rest, flat.limit() * svd.singular_values.max()).ok()?;
        Some(step.component_div(&column_sizes))
    }

    /// The largest rate relative to its change over the ranges of the whole state, with its name.
    pub(super) fn off_balance(&self, here: &Rates) -> (String, f64) {
        let mut worst = (String::new(), 0.0);
        for i in self.rows(here) {
            let over_ranges: f64 =
                self.state.iter().enumerate().map(|(j, e)| (here.slopes.a[(i, j)] * e.scale).abs()).sum();
            let by_inputs: f64 = here.slopes.b.row(i).iter().map(|b| b.abs()).sum();
            let own = here.x_dot[i].abs();
            let share = own / (over_ranges + by_inputs + own).max(f64::MIN_POSITIVE);
            if share > worst.1 || worst.0.is_empty() {
                worst = (self.state[i].name.clone(), share);
            }
        }
        worst
    }

    pub(super) fn rate_of(&self, here: &Rates, name: &str) -> f64 {
        self.state.iter().position(|entry| entry.name == name).map_or(0.0, |i| here.x_dot[i])
    }
}

/// Divides rows by their largest entries, and in turn columns too where small slopes count; returns the divisors.
fn scale(slopes: &mut DMatrix<f64>, flat: Flat) -> (DVector<f64>, DVector<f64>) {
    let size = |largest: f64| if largest > 0.0 { largest } else { 1.0 };
    let mut rows = DVector::from_element(slopes.nrows(), 1.0);
    let mut columns = DVector::from_element(slopes.ncols(), 1.0);
    for _ in 0..if flat == Flat::Scaled { PASSES } else { 1 } {
        for (mut row, divisor) in slopes.row_iter_mut().zip(rows.iter_mut()) {
            let size = size(row.amax());
            row /= size;
            *divisor *= size;
        }
        for (mut column, divisor) in slopes.column_iter_mut().zip(columns.iter_mut()) {
            let size = if flat == Flat::Scaled { size(column.amax()) } else { 1.0 };
            column /= size;
            *divisor *= size;
        }
    }
    (rows, columns)
}
