//! Orthonormal bases at every sampled configuration: tests whether a row is linearly independent of others.
//!
//! Gram-Schmidt at all samples at once: a vector is a list of columns with one value per sample, so that structural
//! zeros cost nothing and the inner loops vectorise.

use super::linear;
use super::quantities::Row;
use super::unknowns::UnknownId;
use crate::expr::tape::SampleTable;
use crate::expr::{Dag, ExprId};
use rustc_hash::FxHashMap as HashMap;
use std::ops::Range;

/// Most dependent rows show at the first samples: these are tested before the others.
const FIRST: usize = 2;

/// If more than this share of a row's length is left, the rounding of one Gram-Schmidt pass does not matter.
const ROUNDED: f64 = 1e-2;

/// A remainder below this share of the longest entry may be mere rounding error, which is then bounded explicitly.
const DOUBTFUL: f64 = 1e-5;

/// A row's entries in the columns of the unknowns, in ascending order, with their values at every sample.
pub(super) struct NumericRow<'t> {
    entries: Vec<(usize, &'t [f64])>,
    coefficients: Vec<ExprId>,
    table: &'t SampleTable,
}

impl<'t> NumericRow<'t> {
    pub fn new(dag: &Dag, table: &'t mut SampleTable, row: &Row, column: &HashMap<UnknownId, usize>) -> Self {
        for &coefficient in row.coefficients.values() {
            table.compute(dag, coefficient);
        }
        let table: &'t SampleTable = table;
        let inside = row.coefficients.iter().filter_map(|(u, &c)| Some((*column.get(u)?, c)));
        let (columns, coefficients): (Vec<usize>, Vec<ExprId>) = inside.unzip();
        let values = coefficients.iter().map(|&c| table.computed(c));
        Self { entries: columns.into_iter().zip(values).collect(), coefficients, table }
    }

    /// The length of the row at a sample.
    pub fn length(&self, sample: usize) -> f64 {
        self.entries.iter().map(|(_, values)| values[sample] * values[sample]).sum::<f64>().sqrt()
    }

    /// Writes the row's entries at a sample into a dense row.
    pub fn write(&self, sample: usize, dense: &mut [f64]) {
        self.entries.iter().for_each(|(column, values)| dense[*column] = values[sample]);
    }

    /// Bound of the rounding error of the row at a sample. Expensive: use it for doubtful rows only.
    pub fn rounding(&self, dag: &Dag, sample: usize) -> f64 {
        let errors = self.table.rounding_errors(dag, &self.coefficients, sample);
        errors.iter().map(|error| error * error).sum::<f64>().sqrt()
    }
}

/// The largest absolute entry of all rows at all samples.
pub(super) fn longest_entry(dag: &Dag, rows: &[Row], table: &mut SampleTable) -> f64 {
    let coefficients = rows.iter().flat_map(|row| row.coefficients.values());
    coefficients.fold(0.0, |most: f64, &c| most.max(longest(table.values(dag, c))))
}

/// The largest absolute value; what is not a number counts as 0.
fn longest(values: &[f64]) -> f64 {
    let (blocks, rest) = values.as_chunks();
    rest.iter().fold(linear::largest(blocks), |most, &x| linear::larger(most, x))
}

/// sums + x y, sample by sample. Functions of their own, in which the lists are known not to overlap, so that several
/// samples are taken at a time.
#[inline(never)]
fn add_products(sums: &mut [f64], x: &[f64], y: &[f64]) {
    sums.iter_mut().zip(x).zip(y).for_each(|((sum, x), y)| *sum += x * y);
}

/// rest - x y, sample by sample.
#[inline(never)]
fn subtract_products(rest: &mut [f64], x: &[f64], y: &[f64]) {
    rest.iter_mut().zip(x).zip(y).for_each(|((rest, x), y)| *rest -= x * y);
}

/// Orthonormal vectors at every sample: those of the rows that were found independent there.
#[derive(Clone)]
pub(super) struct Bases {
    vectors: Vec<BasisVector>,
    /// By sample: number of vectors that are not zero there.
    ranks: Vec<usize>,
    dimensions: usize,
    /// The row being orthogonalised: values by column and sample, and which columns are non-zero.
    rest: Vec<f64>,
    is_filled: Vec<bool>,
    /// By sample: length of the remainder of that row as a share of the row, and the length of the row itself.
    lengths: Vec<f64>,
    whole: Vec<f64>,
    /// The largest entry of any row.
    longest: f64,
}

/// A vector at every sample: its non-zero columns, and their values column by column.
#[derive(Clone)]
struct BasisVector {
    columns: Vec<usize>,
    values: Vec<f64>,
}

impl Bases {
    /// Empty bases of a space with this number of dimensions; `longest` is the largest entry of any row.
    pub fn new(dimensions: usize, longest: f64, samples: usize) -> Self {
        Self {
            vectors: Vec::new(),
            ranks: vec![0; samples],
            dimensions,
            rest: vec![0.0; dimensions * samples],
            is_filled: vec![false; dimensions],
            lengths: vec![0.0; samples],
            whole: vec![0.0; samples],
            longest,
        }
    }

    /// Rank at every sample.
    pub fn ranks(&self) -> &[usize] {
        &self.ranks
    }

    /// Adds the row if at every sample more than the share `least` of its length is left after projection; returns
    /// whether.
    ///
    /// A remainder of rounding errors could be normalised too but means nothing: where least is left, the remainder
    /// must exceed the rounding error of the row.
    pub fn extend(&mut self, dag: &Dag, row: &NumericRow, least: f64) -> bool {
        let samples = self.ranks.len();
        let first = FIRST.min(samples);
        for part in [0..first, first..samples] {
            self.orthogonalise(row, part.clone(), least);
            if !self.lengths[part].iter().all(|&length| length > least) {
                return false;
            }
        }
        let left = self.lengths.iter().zip(&self.whole).map(|(part, length)| part * length).enumerate();
        if let Some((sample, left)) = left.min_by(|a, b| a.1.total_cmp(&b.1))
            && left < DOUBTFUL * self.longest
            && left <= row.rounding(dag, sample)
        {
            return false;
        }
        self.push(least);
        true
    }

    /// Adds the row at those samples at which more than the share `least` of its length is left after projection, and
    /// more than rounding error.
    pub fn extend_where_independent(&mut self, dag: &Dag, row: &NumericRow, least: f64) {
        // Where the rank equals the number of dimensions every row is dependent.
        if self.ranks.iter().all(|&rank| rank == self.dimensions) {
            return;
        }
        self.orthogonalise(row, 0..self.ranks.len(), least);
        for (sample, length) in self.lengths.iter_mut().enumerate() {
            let whole = self.whole[sample];
            let is_rounding =
                || *length * whole < DOUBTFUL * self.longest && *length * whole <= row.rounding(dag, sample);
            if self.ranks[sample] == self.dimensions || (*length > least && is_rounding()) {
                *length = 0.0;
            }
        }
        self.push(least);
    }

    /// Subtracts from the normalised row its projections on the vectors, at some of the samples (Gram-Schmidt), a
    /// second time where so little is left that rounding would count.
    fn orthogonalise(&mut self, row: &NumericRow, part: Range<usize>, least: f64) {
        let samples = self.ranks.len();
        let at = |k: usize| k * samples + part.start..k * samples + part.end;
        self.is_filled.fill(false);
        for &(column, values) in &row.entries {
            self.rest[at(column)].copy_from_slice(&values[part.clone()]);
            self.is_filled[column] = true;
        }
        self.measure(part.clone());
        self.whole[part.clone()].copy_from_slice(&self.lengths[part.clone()]);
        for &(column, _) in &row.entries {
            let lengths = &self.lengths[part.clone()];
            for (x, &length) in self.rest[at(column)].iter_mut().zip(lengths) {
                *x = if length > f64::MIN_POSITIVE { *x / length } else { *x };
            }
        }
        self.take_out_vectors(part.clone());
        if self.lengths[part.clone()].iter().any(|length| (0.5 * least..ROUNDED).contains(length)) {
            self.take_out_vectors(part);
        }
    }

    /// Subtracts the projections on all vectors from the current row.
    fn take_out_vectors(&mut self, part: Range<usize>) {
        let samples = self.ranks.len();
        let at = |k: usize| k * samples + part.start..k * samples + part.end;
        let mut projection = vec![0.0; part.len()];
        for vector in &self.vectors {
            if !vector.columns.iter().any(|&column| self.is_filled[column]) {
                continue;
            }
            projection.fill(0.0);
            for (k, &column) in vector.columns.iter().enumerate().filter(|(_, c)| self.is_filled[**c]) {
                add_products(&mut projection, &self.rest[at(column)], &vector.values[at(k)]);
            }
            for (k, &column) in vector.columns.iter().enumerate() {
                let rest = &mut self.rest[at(column)];
                if !std::mem::replace(&mut self.is_filled[column], true) {
                    rest.fill(0.0);
                }
                subtract_products(rest, &projection, &vector.values[at(k)]);
            }
        }
        self.measure(part);
    }

    /// Computes the lengths of the current row.
    fn measure(&mut self, part: Range<usize>) {
        let samples = self.ranks.len();
        let lengths = &mut self.lengths[part.clone()];
        lengths.fill(0.0);
        for column in (0..self.dimensions).filter(|&column| self.is_filled[column]) {
            let values = &self.rest[column * samples..][part.clone()];
            add_products(lengths, values, values);
        }
        lengths.iter_mut().for_each(|sum| *sum = sum.sqrt());
    }

    /// Adds the current row, normalised, at the samples where enough of it is left.
    fn push(&mut self, least: f64) {
        let samples = self.ranks.len();
        if self.lengths.iter().all(|&length| length <= least) {
            return;
        }
        let columns: Vec<usize> = (0..self.dimensions).filter(|&column| self.is_filled[column]).collect();
        let mut values = Vec::with_capacity(columns.len() * samples);
        for &column in &columns {
            let rest = &self.rest[column * samples..][..samples];
            let lengths = rest.iter().zip(&self.lengths);
            values.extend(lengths.map(|(x, &length)| if length > least { x / length } else { 0.0 }));
        }
        self.vectors.push(BasisVector { columns, values });
        for (rank, &length) in self.ranks.iter_mut().zip(&self.lengths) {
            *rank += usize::from(length > least);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::{Bases, NumericRow};
    use crate::expr::Dag;
    use crate::expr::tape::SampleTable;

    #[test]
    fn a_row_is_added_where_it_is_independent() {
        let (dag, table) = (Dag::default(), SampleTable::new(Default::default(), 4));
        let row = |entries| NumericRow { entries, coefficients: Vec::new(), table: &table };
        let (ones, slopes) = ([1.0; 4], [1.0, 2.0, 3.0, 1e-9]);
        let first = row(vec![(0, &ones[..]), (2, &ones[..])]);
        // Beside the first, 1e-9 of it is left at the last sample.
        let second = row(vec![(0, &ones[..]), (1, &slopes[..]), (2, &ones[..])]);
        let mut bases = Bases::new(3, 1.0, 4);
        assert!(bases.extend(&dag, &first, 1e-3));
        assert!(!bases.extend(&dag, &second, 1e-3));
        assert!(!bases.extend(&dag, &first, 1e-3));
        bases.extend_where_independent(&dag, &second, 1e-3);
        assert_eq!(bases.ranks(), [2, 2, 2, 1]);
        // The difference of the two, at the samples at which both count.
        bases.extend_where_independent(&dag, &row(vec![(1, &ones[..])]), 1e-3);
        assert_eq!(bases.ranks(), [2, 2, 2, 2]);
        assert!(bases.extend(&dag, &row(vec![(2, &ones[..])]), 1e-3));
    }
}
