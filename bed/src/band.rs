//! Symmetric positive definite matrices whose entries lie near the diagonal: Cholesky's factors and solutions.
//!
//! In: entries on and below the diagonal, at most `width` columns away from it. Out: L with A = L L', in the same
//! place; rows are slices, so that the inner loop is a dot product. Width n - 1 is a full matrix.

/// A band of a symmetric matrix, or of its factor.
#[derive(Clone, Debug)]
pub struct Band {
    size: usize,
    width: usize,
    entries: Vec<f64>,
}

impl Band {
    /// A matrix of zeros.
    #[must_use]
    pub fn new(size: usize, width: usize) -> Band {
        let width = width.min(size.saturating_sub(1));
        Band { size, width, entries: vec![0.0; size * (width + 1)] }
    }

    /// Rows.
    #[must_use]
    pub fn size(&self) -> usize {
        self.size
    }

    /// Adds to the entry of a row and a column, which lies on or below the diagonal; what lies above is left out.
    pub fn add(&mut self, row: usize, column: usize, value: f64) {
        if column <= row {
            let place = row * (self.width + 1) + column + self.width - row;
            self.entries[place] += value;
        }
    }

    /// Adds a 3 x 3 block of two nodes and, by symmetry, its transpose.
    pub fn add_block(&mut self, row: usize, column: usize, block: &[[f64; 3]; 3]) {
        for (i, line) in block.iter().enumerate() {
            for (j, value) in line.iter().enumerate() {
                let (a, b) = (3 * row + i, 3 * column + j);
                if row == column {
                    self.add(a, b, *value);
                } else {
                    self.add(a.max(b), a.min(b), *value);
                }
            }
        }
    }

    /// Adds to every diagonal entry.
    pub fn shift(&mut self, value: f64) {
        (0..self.size).for_each(|i| self.add(i, i, value));
    }

    /// Row i from column i - width on.
    fn row(&self, i: usize) -> &[f64] {
        &self.entries[i * (self.width + 1)..(i + 1) * (self.width + 1)]
    }

    /// L of A = L L'; `None` if a pivot is not positive.
    #[must_use]
    pub fn factor(mut self) -> Option<Factor> {
        let wide = self.width + 1;
        for i in 0..self.size {
            let first = i.saturating_sub(self.width);
            let (done, rest) = self.entries.split_at_mut(i * wide);
            let line = &mut rest[..wide];
            for j in first..i {
                let above = &done[j * wide..(j + 1) * wide];
                let (at, shared) = (j + self.width - i, j - first);
                let sum = dot(&line[at - shared..at], &above[self.width - shared..self.width]);
                line[at] = (line[at] - sum) / above[self.width];
            }
            let known = &line[self.width - (i - first)..self.width];
            let pivot = line[self.width] - dot(known, known);
            // A comparison that not-a-number fails too.
            if !(pivot > 0.0 && pivot.is_finite()) {
                return None;
            }
            line[self.width] = pivot.sqrt();
        }
        Some(Factor(self))
    }
}

/// Cholesky's factor.
#[derive(Clone, Debug)]
pub struct Factor(Band);

impl Factor {
    /// Solves A x = b in place for several b at once, row by row: rows of the factor are read once for all.
    pub fn solve_all<const N: usize>(&self, b: &mut [[f64; N]]) {
        let Factor(band) = self;
        let width = band.width;
        for i in 0..band.size {
            let first = i.saturating_sub(width);
            let row = band.row(i);
            let (known, own) = b.split_at_mut(i);
            for (l, x) in row[width - (i - first)..width].iter().zip(&known[first..]) {
                (0..N).for_each(|k| own[0][k] -= l * x[k]);
            }
            own[0].iter_mut().for_each(|x| *x /= row[width]);
        }
        for i in (0..band.size).rev() {
            let first = i.saturating_sub(width);
            let row = band.row(i);
            let (rest, own) = b.split_at_mut(i);
            own[0].iter_mut().for_each(|x| *x /= row[width]);
            for (l, x) in row[width - (i - first)..width].iter().zip(&mut rest[first..]) {
                (0..N).for_each(|k| x[k] -= l * own[0][k]);
            }
        }
    }

    /// Solves A x = b in place.
    pub fn solve(&self, b: &mut [f64]) {
        let Factor(band) = self;
        let width = band.width;
        for i in 0..band.size {
            let first = i.saturating_sub(width);
            let row = band.row(i);
            let sum = dot(&row[width - (i - first)..width], &b[first..i]);
            b[i] = (b[i] - sum) / row[width];
        }
        for i in (0..band.size).rev() {
            let first = i.saturating_sub(width);
            let row = band.row(i);
            let x = b[i] / row[width];
            b[i] = x;
            for (entry, l) in b[first..i].iter_mut().zip(&row[width - (i - first)..width]) {
                *entry -= l * x;
            }
        }
    }
}

/// Dot product in four sums, which the compiler computes side by side.
fn dot(a: &[f64], b: &[f64]) -> f64 {
    let mut sums = [0.0; 4];
    let (a4, b4) = (a.chunks_exact(4), b.chunks_exact(4));
    let tail: f64 = a4.remainder().iter().zip(b4.remainder()).map(|(x, y)| x * y).sum();
    for (x, y) in a4.zip(b4) {
        for k in 0..4 {
            sums[k] += x[k] * y[k];
        }
    }
    (sums[0] + sums[1]) + (sums[2] + sums[3]) + tail
}
