//! Checks that the pivots of an elimination vanish only where the constraints themselves are singular.
//!
//! In: the pivots of an elimination, and all rows of the constraints. Out: configurations at which a pivot vanishes
//! although the rows determine the unknowns there; none if the elimination is regular. A pivot whose sign differs
//! between two samples vanishes in between: bisection along the motion from one to the other finds where.

use super::assemble::Assembly;
use super::basis::NumericRow;
use super::quantities::{Kinematics, Row, Sample};
use super::sampling::table_at;
use super::unknowns::UnknownId;
use crate::expr::ExprId;
use crate::expr::tape::SampleTable;
use crate::model::Model;
use crate::vector::Algebra;
use rustc_hash::FxHashMap as HashMap;

/// If a pivot falls below this share of its nominal value, the constraints themselves are examined there.
const SMALL: f64 = 0.02;
/// The constraints count as regular if their least determined direction keeps this share of its nominal value.
const REGULAR: f64 = 0.05;
/// Number of samples of opposite sign towards which a zero is searched for.
const ATTEMPTS: usize = 4;
/// Halvings of the path between two configurations of opposite sign.
const HALVINGS: usize = 40;

/// Measures how well the rows determine the unknowns at a configuration.
pub(super) struct Regularity<'a> {
    alg: &'a Algebra,
    model: &'a Model,
    k: &'a Kinematics,
    rows: &'a [Row],
    column: HashMap<UnknownId, usize>,
    /// Rank that the rows must have.
    rank: usize,
    /// Largest length of each row over the samples, by which it is divided: multiplying a row by a number changes
    /// nothing.
    lengths: Vec<f64>,
    /// The measure at the nominal configuration: what is left of the last row in Gram-Schmidt with pivoting.
    nominal: f64,
}

impl<'a> Regularity<'a> {
    /// For all rows of the constraints, including spare ones, which must determine every unknown.
    pub fn new(
        alg: &'a Algebra,
        model: &'a Model,
        k: &'a Kinematics,
        rows: &'a [Row],
        unknown: &[UnknownId],
        samples: &mut SampleTable,
    ) -> Self {
        Self::of_rank(alg, model, k, rows, (unknown, unknown.len()), samples)
    }

    /// For rows that must have the given rank over the unknowns.
    pub fn of_rank(
        alg: &'a Algebra,
        model: &'a Model,
        k: &'a Kinematics,
        rows: &'a [Row],
        (unknown, rank): (&[UnknownId], usize),
        samples: &mut SampleTable,
    ) -> Self {
        let column = unknown.iter().enumerate().map(|(i, &u)| (u, i)).collect();
        let mut this = Self { alg, model, k, rows, column, rank, lengths: Vec::new(), nominal: 0.0 };
        let points = samples.points();
        for row in this.rows {
            let row = NumericRow::new(&alg.dag, samples, row, &this.column);
            this.lengths.push((0..points).map(|s| row.length(s)).fold(0.0, f64::max));
        }
        this.nominal = this.determined(samples, 0, None).1;
        this
    }

    /// Rank at a sample, of all rows or only some, and the remaining length of the last pivot row; 0 if the rank is too
    /// small.
    fn determined(&self, table: &mut SampleTable, sample: usize, only: Option<&[usize]>) -> (usize, f64) {
        let n = self.column.len();
        let mut matrix = Vec::new();
        for (i, (row, &length)) in self.rows.iter().zip(&self.lengths).enumerate() {
            if length > 0.0 && only.is_none_or(|only| only.contains(&i)) {
                let mut dense = vec![0.0; n];
                NumericRow::new(&self.alg.dag, table, row, &self.column).write(sample, &mut dense);
                dense.iter_mut().for_each(|x| *x /= length);
                matrix.push(dense);
            }
        }
        least_left(matrix, self.rank)
    }

    /// The remaining length of the last pivot row at these configurations.
    pub fn at(&self, configurations: &[Sample]) -> Vec<f64> {
        let mut table = table_at(self.alg, self.model, self.k, configurations);
        (0..configurations.len()).map(|s| self.determined(&mut table, s, None).1).collect()
    }

    /// The configurations at which the rows determine the unknowns.
    pub fn regular(&self, configurations: Vec<Sample>) -> Vec<Sample> {
        let mut table = table_at(self.alg, self.model, self.k, &configurations);
        let places = configurations.into_iter().enumerate();
        let regular =
            places.filter(|(s, _)| self.determined(&mut table, *s, None).1 > REGULAR * self.nominal);
        regular.map(|(_, q)| q).collect()
    }

    /// Rows that determine the unknowns at every sample about as well as all rows do: starts from `first` and adds,
    /// where the measure is worst, the row that improves it most.
    pub fn complete(&self, table: &mut SampleTable, first: Vec<Row>) -> Vec<Row> {
        /// "About as well": at least this share of the measure of all rows.
        const SHARE: f64 = 0.2;
        let place = |row: &Row| {
            self.rows.iter().position(|r| r.name == row.name && r.coefficients == row.coefficients)
        };
        let mut taken: Vec<usize> = first.iter().filter_map(place).collect();
        let whole: Vec<f64> = (0..table.points()).map(|s| self.determined(table, s, None).1).collect();
        while taken.len() < self.rows.len() {
            let needed = (0..whole.len()).filter(|&s| whole[s] > REGULAR * self.nominal);
            let shares: Vec<(usize, f64)> =
                needed.map(|s| (s, self.determined(table, s, Some(&taken)).1 / whole[s])).collect();
            let Some(&(worst, left)) = shares.iter().min_by(|a, b| a.1.total_cmp(&b.1)) else { break };
            if left > SHARE {
                break;
            }
            let others = (0..self.rows.len()).filter(|i| !taken.contains(i) && self.lengths[*i] > 0.0);
            let with = others.map(|i| {
                let rows: Vec<usize> = taken.iter().copied().chain([i]).collect();
                (i, self.determined(table, worst, Some(&rows)), self.rows[i].cost)
            });
            let by_gain = |a: (usize, f64), b: (usize, f64)| a.0.cmp(&b.0).then(a.1.total_cmp(&b.1));
            let best = with.max_by(|a, b| by_gain(a.1, b.1).then(b.2.cmp(&a.2)));
            let Some((row, ..)) = best else { break };
            taken.push(row);
        }
        taken.into_iter().map(|i| self.rows[i].clone()).collect()
    }
}

/// Configurations at which one of the pivots is zero or small; `table` holds the samples.
pub(super) fn suspects(
    alg: &Algebra,
    model: &Model,
    k: &Kinematics,
    table: &mut SampleTable,
    samples: &[Sample],
    pivots: &[ExprId],
) -> Vec<Sample> {
    let mut suspects: Vec<Sample> = Vec::new();
    let mut assembly = None;
    for &pivot in pivots.iter().filter(|p| !alg.dag.is_constant(**p)) {
        let values = table.values(&alg.dag, pivot);
        let smallest = (0..values.len()).min_by(|&a, &b| values[a].abs().total_cmp(&values[b].abs()));
        let small = |&s: &usize| values[s].is_nan() || values[s].abs() <= SMALL * values[0].abs();
        suspects.extend(smallest.filter(small).map(|s| samples[s].clone()));
        let others = (1..values.len()).filter(|&s| values[s] * values[0] < 0.0);
        for s in others.take(ATTEMPTS) {
            let assembly = assembly.get_or_insert_with(|| Assembly::new(&mut alg.clone(), model, k));
            suspects.extend(zero_between(alg, model, k, assembly, pivot, [&samples[0], &samples[s]]));
        }
    }
    suspects
}

/// A zero or pole of the pivot on the path between two configurations; `None` if the path cannot be followed.
fn zero_between(
    alg: &Algebra,
    model: &Model,
    k: &Kinematics,
    assembly: &mut Assembly,
    pivot: ExprId,
    [from, to]: [&Sample; 2],
) -> Option<Sample> {
    let is_positive = |sample: &Sample| {
        table_at(alg, model, k, std::slice::from_ref(sample)).values(&alg.dag, pivot)[0] > 0.0
    };
    let (mut from, mut to) = (from.clone(), to.clone());
    let first = is_positive(&from);
    if is_positive(&to) == first {
        return None;
    }
    for _ in 0..HALVINGS {
        let mut target: Vec<f64> = from.q.iter().zip(&to.q).map(|(a, b)| 0.5 * (a + b)).collect();
        assembly.to_unit_length(&mut target, |_| false);
        let t = 0.5 * (from.t + to.t);
        assembly.set_time(from.t);
        let later = if t == from.t { from.q.clone() } else { assembly.continue_in_time(&from.q, t).ok()? };
        let middle = Sample { q: assembly.continue_to(&later, &target).ok()?, t };
        if is_positive(&middle) == first { from = middle } else { to = middle }
    }
    Some(to)
}

/// Gram-Schmidt with row pivoting: the rank up to n, and the smallest remaining length; 0 if the rank is less than n.
fn least_left(mut rows: Vec<Vec<f64>>, n: usize) -> (usize, f64) {
    /// A unit row with less than this left depends on the others.
    const ZERO: f64 = 1e-8;
    let mut least = 1.0_f64;
    for count in 0..n {
        let norm = |row: &Vec<f64>| row.iter().map(|x| x * x).sum::<f64>().sqrt();
        let longest = rows.iter().map(norm).enumerate().max_by(|a, b| a.1.total_cmp(&b.1));
        let Some((index, left)) = longest.filter(|(_, left)| *left > ZERO) else { return (count, 0.0) };
        let unit: Vec<f64> = rows.swap_remove(index).iter().map(|x| x / left).collect();
        for row in &mut rows {
            let along: f64 = row.iter().zip(&unit).map(|(x, e)| x * e).sum();
            row.iter_mut().zip(&unit).for_each(|(x, e)| *x -= along * e);
        }
        least = least.min(left);
    }
    (n, least)
}

#[cfg(test)]
mod tests {
    use super::least_left;

    #[test]
    fn the_least_determined_direction_counts() {
        let rows = vec![vec![1.0, 0.0], vec![0.1_f64.cos(), 0.1_f64.sin()]];
        assert!((least_left(rows.clone(), 2).1 - 0.1_f64.sin()).abs() < 1e-15);
        // A third row across the first determines both.
        assert!((least_left([rows, vec![vec![0.0, 1.0]]].concat(), 2).1 - 1.0).abs() < 1e-15);
        assert_eq!(least_left(vec![vec![1.0, 2.0]], 2), (1, 0.0));
    }
}
