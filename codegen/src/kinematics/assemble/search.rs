//! Configurations far from any that is known: descent from many guesses.
//!
//! In: guesses of the dependent coordinates. Out: the nearest configuration that satisfies the constraints, or the one
//! that violates them least.

use super::super::linear;
use super::super::unreachable::Unreachable;
use super::{Assembly, Linearised};

/// Number of guesses from which the nominal configuration is searched for.
const STARTS: usize = 64;
/// Number of guesses from which the least residual is searched for.
const FEW_STARTS: usize = 16;
/// Number of guesses from which coordinates that were left out are searched for.
const LEFT_OUT_STARTS: usize = 64;
/// Fractional part of the golden section.
const GOLDEN: f64 = 0.618_033_988_749_894_9;
/// Most Levenberg-Marquardt steps, and the sum of squares at which they end.
const DESCENT: usize = 100;
const DESCENDED: f64 = 1e-10;

impl Assembly {
    /// The configuration in which what is given holds, from `nominal`, which satisfies the constraints: independent
    /// coordinates as given (Euler parameters scaled to unit length), left-out ones nominal; others solved for on the
    /// branch of `nominal`, or where some of them are given, nearest to these.
    ///
    /// # Errors
    /// If none is found.
    pub fn complete(&mut self, nominal: &[f64], given: &[Option<f64>]) -> Result<Vec<f64>, Unreachable> {
        let mut target = nominal.to_vec();
        for &i in &self.independent {
            target[i] = given[i].unwrap_or(target[i]);
        }
        self.to_unit_length(&mut target, |i| given[i].is_some());
        let reached = self.continue_to(nominal, &target);
        if self.dependent.iter().all(|&i| given[i].is_none()) {
            return reached;
        }
        let mut q = reached.unwrap_or(target);
        for (mine, value) in q.iter_mut().zip(given) {
            *mine = value.unwrap_or(*mine);
        }
        let near = q.clone();
        match self.correct(&mut q) {
            Ok(()) => Ok(q),
            Err(unreachable) => self.search_left_out(near, given).ok_or(unreachable),
        }
    }

    /// Newton's method from many guesses of the dependent coordinates that are not given; the solution nearest to those
    /// given.
    fn search_left_out(&mut self, near: Vec<f64>, given: &[Option<f64>]) -> Option<Vec<f64>> {
        let mut best: Option<(f64, Vec<f64>)> = None;
        let mut draw = 0_u64;
        for _ in 0..LEFT_OUT_STARTS {
            let mut q = near.clone();
            for &i in self.dependent.iter().filter(|&&i| given[i].is_none()) {
                let (low, high) = self.kinds[i].1;
                draw += 1;
                q[i] = low + (high - low) * (draw as f64 * GOLDEN).fract();
            }
            if self.correct(&mut q).is_ok() {
                let off =
                    q.iter().zip(given).filter_map(|(x, g)| Some((x - (*g)?).abs())).fold(0.0, f64::max);
                if best.as_ref().is_none_or(|(least, _)| off < *least) {
                    best = Some((off, q));
                }
            }
        }
        best.map(|(_, q)| q)
    }

    /// The configuration nearest to `guess`, among those found from many guesses of the dependent coordinates.
    ///
    /// # Errors
    /// If none is found.
    pub fn search(&mut self, guess: &[f64]) -> Result<Vec<f64>, Unreachable> {
        let mut q = guess.to_vec();
        let mut found = self.correct(&mut q).map(|()| (0.0, q));
        for start in 0..if found.is_ok() { 0 } else { STARTS } {
            let mut q = self.descended(guess, start);
            for &i in self.dependent.iter().filter(|&&i| self.kinds[i].0) {
                q[i] -= std::f64::consts::TAU * ((q[i] - guess[i]) / std::f64::consts::TAU).round();
            }
            match self.correct(&mut q) {
                Ok(()) => {
                    let way = |&i: &usize| (q[i] - guess[i]) / self.width(i);
                    let distance = self.dependent.iter().map(way).map(|x| x * x).sum::<f64>();
                    if found.as_ref().map_or(true, |(least, _)| distance < *least) {
                        found = Ok((distance, q));
                    }
                }
                Err(new) => match &mut found {
                    Err(old) if new.residual < old.residual => *old = new,
                    _ => {}
                },
            }
        }
        found.map(|(_, q)| q)
    }

    /// The least residual found at the independent coordinates of `guess`, with the constraint that it is left in;
    /// `None` if a configuration satisfies the constraints there.
    pub fn least_residual(&mut self, guess: &[f64]) -> Option<Unreachable> {
        let mut least = Unreachable::default();
        for start in 0..FEW_STARTS {
            let mut q = self.descended(guess, start);
            let (residual, place) = self.linearised(&q).absolute;
            if residual < least.residual {
                let constraint = self.names.get(place).cloned();
                least = Unreachable { residual, constraint, ..Unreachable::default() };
            }
            if self.correct(&mut q).is_ok() {
                return None;
            }
        }
        Some(least)
    }

    /// Where descent from a guess ends; the first start is the guess itself, others lie spread around it.
    fn descended(&mut self, guess: &[f64], start: usize) -> Vec<f64> {
        let mut q = guess.to_vec();
        for (place, &i) in self.dependent.iter().enumerate() {
            // Fractional parts of multiples of square roots cover the box evenly.
            let part = (start as f64 * ((place + 2) as f64).sqrt() * GOLDEN).fract();
            let (is_angle, (low, high)) = self.kinds[i];
            let width = if is_angle { std::f64::consts::TAU } else { high - low };
            q[i] += width * (part - part.round());
        }
        self.descend(&mut q);
        q
    }

    /// The length by which differences of a coordinate are measured: its range, or 1 for an angle.
    fn width(&self, index: usize) -> f64 {
        let (is_angle, (low, high)) = self.kinds[index];
        if is_angle { 1.0 } else { (high - low).abs().max(f64::MIN_POSITIVE) }
    }

    /// Levenberg-Marquardt steps that reduce the sum of squares until Newton's method converges.
    fn descend(&mut self, q: &mut Vec<f64>) {
        let n = self.dependent.len();
        let mut damping = 1e-2;
        let squares = |equations: &Linearised| equations.residual().iter().map(|r| r * r).sum::<f64>();
        let mut equations = self.linearised(q);
        for _ in 0..DESCENT {
            let size = squares(&equations);
            if size < DESCENDED || size.is_nan() {
                return;
            }
            let rows: Vec<&[f64]> = equations.jacobian().chunks_exact(n.max(1)).collect();
            let product = |i: usize, j: usize| rows.iter().map(|row| row[i] * row[j]).sum::<f64>();
            // Scales each unknown by the norm of its column, so that lengths of any size and angles count alike.
            let length = |i: usize| product(i, i).sqrt();
            let units: Vec<f64> =
                (0..n).map(|i| if length(i) > 0.0 { 1.0 / length(i) } else { 1.0 }).collect();
            let entry = |i: usize, j: usize| {
                let damped = if i == j { damping } else { 0.0 };
                product(i, j) * units[i] * units[j] + damped
            };
            let gram: Vec<f64> = (0..n * n).map(|ij| entry(ij / n, ij % n)).collect();
            let slope =
                |i: usize| rows.iter().zip(equations.residual()).map(|(row, r)| -row[i] * r).sum::<f64>();
            let mut right: Vec<f64> = (0..n).map(|i| slope(i) * units[i]).collect();
            let (step, _) = linear::solve(&gram, &mut right, n);
            let mut there = q.clone();
            let each = self.dependent.iter().zip(step).zip(&units);
            each.for_each(|((&i, d), unit)| there[i] += d * unit);
            let new = self.linearised(&there);
            if squares(&new) < size {
                (*q, equations, damping) = (there, new, damping * 0.2);
            } else {
                damping *= 5.0;
            }
        }
    }
}
