//! Orthonormal vectors at every sampled configuration: is a row independent of others?
//!
//! Gram-Schmidt over all samples at once: a vector is a list of columns with one value a sample, so that what is
//! zero by structure costs nothing and the rest goes through the loops that a compiler turns into wide arithmetic.

use super::{Row, UnknownId};
use crate::expr::Dag;
use crate::expr::tape::SampleTable;
use rustc_hash::FxHashMap as HashMap;
use std::ops::Range;

/// Most dependent rows show at the first samples: no need to look at the others.
const FIRST: usize = 2;

/// Beside this part of a row's length what rounding has left in it of the vectors does not count.
const ROUNDED: f64 = 1e-2;

/// A row's entries in the columns of unknowns, ascending, at every sample.
pub(super) struct NumericRow<'t>(Vec<(usize, &'t [f64])>);

impl<'t> NumericRow<'t> {
    pub fn new(dag: &Dag, table: &'t mut SampleTable, row: &Row, column: &HashMap<UnknownId, usize>) -> Self {
        for &coefficient in row.coefficients.values() {
            table.compute(dag, coefficient);
        }
        let table: &'t SampleTable = table;
        let entries = row.coefficients.iter();
        Self(entries.filter_map(|(u, &c)| Some((*column.get(u)?, table.computed(c)))).collect())
    }
}

/// Orthonormal vectors, at every sample as many as have been found independent there.
#[derive(Clone)]
pub(super) struct Bases {
    vectors: Vec<Vector>,
    /// By sample: how many vectors are not zero there.
    ranks: Vec<usize>,
    dimensions: usize,
    /// The row at hand: by column one value a sample, and whether the column has any.
    rest: Vec<f64>,
    is_filled: Vec<bool>,
    /// Lengths of the row at hand, one a sample.
    lengths: Vec<f64>,
}

/// One value a sample in each of some columns, one column after the other.
#[derive(Clone)]
struct Vector {
    columns: Vec<usize>,
    values: Vec<f64>,
}

impl Bases {
    /// No vectors yet, of a space of so many dimensions.
    pub fn new(dimensions: usize, samples: usize) -> Self {
        Self {
            vectors: Vec::new(),
            ranks: vec![0; samples],
            dimensions,
            rest: vec![0.0; dimensions * samples],
            is_filled: vec![false; dimensions],
            lengths: vec![0.0; samples],
        }
    }

    /// Number of vectors at every sample.
    pub fn ranks(&self) -> &[usize] {
        &self.ranks
    }

    /// Adds the row, if at every sample more than this part of its length is left beside the others.
    pub fn extend(&mut self, row: &NumericRow, least: f64) -> bool {
        let samples = self.ranks.len();
        let first = FIRST.min(samples);
        for part in [0..first, first..samples] {
            self.orthogonalise(row, part.clone(), least);
            if !self.lengths[part].iter().all(|&length| length > least) {
                return false;
            }
        }
        self.push(least);
        true
    }

    /// Adds the row at those samples at which more than this part of its length is left beside the others.
    pub fn extend_where_independent(&mut self, row: &NumericRow, least: f64) {
        // Beside as many vectors as there are dimensions nothing is left.
        if self.ranks.iter().all(|&rank| rank == self.dimensions) {
            return;
        }
        self.orthogonalise(row, 0..self.ranks.len(), least);
        for (length, &rank) in self.lengths.iter_mut().zip(&self.ranks) {
            *length = if rank < self.dimensions { *length } else { 0.0 };
        }
        self.push(least);
    }

    /// What is left of a row, as a unit vector, beside the vectors, at a part of the samples: Gram-Schmidt, twice
    /// where so little is left that its rounding would count.
    fn orthogonalise(&mut self, row: &NumericRow, part: Range<usize>, least: f64) {
        let samples = self.ranks.len();
        let at = |k: usize| k * samples + part.start..k * samples + part.end;
        self.is_filled.fill(false);
        for &(column, values) in &row.0 {
            self.rest[at(column)].copy_from_slice(&values[part.clone()]);
            self.is_filled[column] = true;
        }
        self.measure(part.clone());
        for &(column, _) in &row.0 {
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

    /// Takes the vectors' parts out of the row at hand.
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
                let products = self.rest[at(column)].iter().zip(&vector.values[at(k)]);
                projection.iter_mut().zip(products).for_each(|(sum, (x, y))| *sum += x * y);
            }
            for (k, &column) in vector.columns.iter().enumerate() {
                let rest = &mut self.rest[at(column)];
                if !std::mem::replace(&mut self.is_filled[column], true) {
                    rest.fill(0.0);
                }
                let products = projection.iter().zip(&vector.values[at(k)]);
                rest.iter_mut().zip(products).for_each(|(x, (p, y))| *x -= p * y);
            }
        }
        self.measure(part);
    }

    /// Lengths of the row at hand.
    fn measure(&mut self, part: Range<usize>) {
        let samples = self.ranks.len();
        let lengths = &mut self.lengths[part.clone()];
        lengths.fill(0.0);
        for column in (0..self.dimensions).filter(|&column| self.is_filled[column]) {
            let values = &self.rest[column * samples..][part.clone()];
            lengths.iter_mut().zip(values).for_each(|(sum, x)| *sum += x * x);
        }
        lengths.iter_mut().for_each(|sum| *sum = sum.sqrt());
    }

    /// Adds the row at hand, made a unit vector, where it is long enough.
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
        self.vectors.push(Vector { columns, values });
        for (rank, &length) in self.ranks.iter_mut().zip(&self.lengths) {
            *rank += usize::from(length > least);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::{Bases, NumericRow};

    #[test]
    fn a_row_is_added_where_it_is_independent() {
        let (ones, slopes) = ([1.0; 4], [1.0, 2.0, 3.0, 1e-9]);
        let first = NumericRow(vec![(0, &ones), (2, &ones)]);
        // Beside the first, 1e-9 of it is left at the last sample.
        let second = NumericRow(vec![(0, &ones), (1, &slopes), (2, &ones)]);
        let mut bases = Bases::new(3, 4);
        assert!(bases.extend(&first, 1e-3));
        assert!(!bases.extend(&second, 1e-3));
        assert!(!bases.extend(&first, 1e-3));
        bases.extend_where_independent(&second, 1e-3);
        assert_eq!(bases.ranks(), [2, 2, 2, 1]);
        // The difference of the two, at the samples at which both count.
        bases.extend_where_independent(&NumericRow(vec![(1, &ones)]), 1e-3);
        assert_eq!(bases.ranks(), [2, 2, 2, 2]);
        assert!(bases.extend(&NumericRow(vec![(2, &ones)]), 1e-3));
    }
}
