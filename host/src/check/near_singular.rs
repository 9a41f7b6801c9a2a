//! Searches within the ranges for the configuration nearest to singular, starting from the samples.
//!
//! In: a program and the sampled configurations. Out: the configuration with the smallest worst pivot, relative to
//! nominal, and that pivot. Compass search: from the worst samples, one independent coordinate at a time, with a step
//! that is halved if no move makes the pivot smaller. Dependent coordinates follow by Newton's method; a configuration
//! that cannot be assembled or leaves its ranges is rejected. Bounded and deterministic.

use crate::configuration::Configurations;
use smartbed_codegen::model::Model;
use smartbed_codegen::{Interpreted, Program};
use smartbed_runtime::mechanism::Mechanism;

/// Samples from which a search starts, the worst first.
const STARTS: usize = 4;
/// First step, as a fraction of each coordinate's range.
const FIRST_STEP: f64 = 0.125;
/// The search ends below this step.
const LAST_STEP: f64 = 1e-9;
/// Largest number of configurations evaluated in all.
const MOST_LOOKS: usize = 6000;
/// Below this fraction of nominal a configuration counts as singular, and the search ends.
const SINGULAR: f64 = 1e-9;

/// A configuration and its worst pivot.
#[derive(Clone, PartialEq, Debug)]
pub(super) struct Nearest {
    /// All coordinates that are state.
    pub q: Vec<f64>,
    /// Smallest pivot there, relative to nominal.
    pub pivot: f64,
    /// The time (s), which matters for a driven mechanism.
    pub t: f64,
}

/// Searches for it; `None` if the program has no pivots.
pub(super) fn search(
    model: &Model,
    program: &Program,
    (samples, times): (&[Vec<f64>], &[f64]),
) -> Option<Nearest> {
    if program.pivots.is_empty() {
        return None;
    }
    let mut search = Search::new(model, program);
    let mut starts: Vec<Nearest> =
        samples.iter().zip(times).filter_map(|(q, &t)| search.look(t, q.clone())).collect();
    starts.sort_by(|a, b| a.pivot.total_cmp(&b.pivot));
    starts.truncate(STARTS);
    let found: Vec<Nearest> = starts.into_iter().map(|start| search.descend(start)).collect();
    found.into_iter().min_by(|a, b| a.pivot.total_cmp(&b.pivot))
}

struct Search {
    engine: Interpreted<f64>,
    configurations: Configurations,
    rates: [Vec<f64>; 2],
    zeros: [Vec<f64>; 2],
    /// By coordinate: whether it is independent, and its range.
    ranges: Vec<(bool, (f64, f64))>,
    looks: usize,
}

impl Search {
    fn new(model: &Model, program: &Program) -> Self {
        let declared = |name: &str| model.coordinates.iter().find(|c| c.name == name);
        let (n_q, n_u) = (program.q.len(), program.u.len());
        Self {
            engine: Interpreted::new(program),
            configurations: Configurations::new(model, program),
            rates: [vec![0.0; n_q], vec![0.0; n_u]],
            zeros: [vec![0.0; n_u], vec![0.0; program.inputs.len()]],
            ranges: program
                .q
                .iter()
                .filter_map(|q| declared(&q.name).map(|c| (c.independent, c.range)))
                .collect(),
            looks: 0,
        }
    }

    /// Evaluates the worst pivot at a configuration; `None` if it is not finite.
    fn look(&mut self, t: f64, q: Vec<f64>) -> Option<Nearest> {
        let ([q_dot, u_dot], [u, inputs]) = (&mut self.rates, &self.zeros);
        let pivot = self.engine.rates(t, &q, u, inputs, q_dot, u_dot).ok()?;
        pivot.is_finite().then_some(Nearest { q, pivot, t })
    }

    /// The configuration reached from another by moving one independent coordinate, at the same time.
    fn moved(&mut self, Nearest { q: from, t, .. }: &Nearest, index: usize, by: f64) -> Option<Nearest> {
        let (_, (low, high)) = self.ranges[index];
        let mut target = from.clone();
        target[index] = (from[index] + by).clamp(low.min(high), high.max(low));
        if target[index] == from[index] {
            return None;
        }
        self.looks += 1;
        let q = self.configurations.follow(*t, from, &target).ok()?;
        // Euler parameters change together.
        let tied = |i: usize| self.configurations.unit_vectors().iter().any(|places| places.contains(&i));
        let inside = self
            .ranges
            .iter()
            .zip(&q)
            .enumerate()
            .all(|(i, ((free, (low, high)), x))| (*free && !tied(i)) || (low..=high).contains(&x));
        if inside { self.look(*t, q) } else { None }
    }

    fn descend(&mut self, start: Nearest) -> Nearest {
        let (mut best, mut step) = (start, FIRST_STEP);
        let most = self.looks + MOST_LOOKS / STARTS;
        let free: Vec<usize> = (0..self.ranges.len()).filter(|&i| self.ranges[i].0).collect();
        while LAST_STEP < step && SINGULAR < best.pivot && self.looks < most {
            let mut better = false;
            for &index in &free {
                let (low, high) = self.ranges[index].1;
                for sign in [1.0, -1.0] {
                    let there = self.moved(&best.clone(), index, sign * step * (high - low));
                    if let Some(there) = there.filter(|there| there.pivot < best.pivot) {
                        (best, better) = (there, true);
                        break;
                    }
                }
            }
            if !better {
                step *= 0.5;
            }
        }
        best
    }
}
