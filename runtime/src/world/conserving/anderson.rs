//! Anderson acceleration (1965) of the iteration for the mean rates.
//!
//! In: rates k and what an iteration makes of them, g(k). Out: the next rates, from the differences of earlier
//! iterations.

use crate::ode::nodes::copy;
use crate::real::Scalar;
use crate::rigid::anderson::eliminate;
use crate::rigid::history::DEPTH;

/// An iteration with |f|^2 above this many times the least of the history ends the history.
const WORSE: f64 = 16.0;

/// What earlier iterations left: differences of f = g(k) - k and of g from one iteration to the next.
pub(super) struct Anderson<'m, S> {
    /// Iterations recorded since it began.
    pub(super) number: usize,
    /// Least |f|^2 among them.
    pub(super) least: S,
    /// g and f of the last one.
    pub(super) gained: &'m mut [S],
    pub(super) off: &'m mut [S],
    /// Differences of f, then of g.
    pub(super) differences: &'m mut [S],
}

impl<S: Scalar> Anderson<'_, S> {
    /// The next rates by Anderson's method: g - sum_i gamma_i dg_i, gamma = argmin |f - sum_i gamma_i df_i| over the
    /// rates of the speeds.
    pub(super) fn extrapolate(&mut self, n_q: usize, rates: &mut [S], found: &[S]) {
        let n = rates.len().max(1);
        let square =
            found.iter().zip(rates.iter()).skip(n_q).fold(S::ZERO, |sum, (g, k)| sum + (*g - *k) * (*g - *k));
        // An iteration that is much worse than the best ends the history.
        let goes_on = self.number > 0 && square <= S::from_f64(WORSE) * self.least;
        if goes_on {
            let place = (self.number - 1) % DEPTH;
            let mut rows = self.differences.chunks_exact_mut(n).skip(place);
            if let (Some(of_f), Some(of_g)) = (rows.next(), rows.nth(DEPTH - 1)) {
                let ends = found.iter().zip(rates.iter()).zip(self.gained.iter().zip(self.off.iter()));
                for ((of_f, of_g), ((g, k), (old_g, old_f))) in of_f.iter_mut().zip(of_g).zip(ends) {
                    (*of_f, *of_g) = ((*g - *k) - *old_f, *g - *old_g);
                }
            }
        } else {
            self.number = 0;
        }
        self.least = if self.number == 0 { square } else { self.least.min(square) };
        self.number += 1;
        for ((gained, off), (g, k)) in
            self.gained.iter_mut().zip(self.off.iter_mut()).zip(found.iter().zip(rates.iter()))
        {
            (*gained, *off) = (*g, *g - *k);
        }
        let count = (self.number - 1).min(DEPTH);
        let (mut matrix, mut right) = ([[S::ZERO; DEPTH]; DEPTH], [S::ZERO; DEPTH]);
        let dot = |a: &[S], b: &[S]| a.iter().zip(b).skip(n_q).fold(S::ZERO, |sum, (a, b)| sum + *a * *b);
        for (i, own) in self.differences.chunks_exact(n).take(count).enumerate() {
            right[i] = dot(own, self.off);
            for (j, other) in self.differences.chunks_exact(n).take(i + 1).enumerate() {
                matrix[i][j] = dot(own, other);
                matrix[j][i] = matrix[i][j];
            }
        }
        let gamma = eliminate(matrix, right, square);
        copy(rates, found);
        for (of_g, gamma) in self.differences.chunks_exact(n).skip(DEPTH).take(count).zip(gamma) {
            rates.iter_mut().zip(of_g).for_each(|(rate, change)| *rate = *rate - gamma * *change);
        }
    }
}
