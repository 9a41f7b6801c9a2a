//! Walks along the motion of a mechanism: in small steps of all coordinates at once, and of time in a driven model,
//! within their ranges.
//!
//! In: the nominal configuration. Out: configurations that satisfy the constraints, each reached from one before. A
//! random walk looks around; a descent goes from a place to where some measure is less.

use super::assemble::Assembly;
use super::quantities::{Kinematics, Sample};
use super::random::Random;
use crate::model::Model;
use crate::vector::Algebra;

/// Number of steps of the random walk, and most attempts per step on average.
const STEPS: usize = 64;
const ATTEMPTS: usize = 4;
/// Largest step in a coordinate: a share of its range, and a bound (rad, m).
const STRIDE: (f64, f64) = (0.15, 0.4);
/// Most rounds of a descent, and the steps that are tried in each.
const ROUNDS: usize = 24;
const TRIES: usize = 4;
/// Ranges are extended by this share of their width.
const ROUNDING: f64 = 1e-9;

/// Takes random steps.
pub(super) struct Walker {
    assembly: Assembly,
    ranges: Vec<(f64, f64)>,
    nominal: Vec<f64>,
    /// Seconds within which time is varied, in a driven model.
    seconds: Option<f64>,
    random: Random,
}

impl Walker {
    pub fn new(alg: &mut Algebra, model: &Model, k: &Kinematics) -> Self {
        Self {
            assembly: Assembly::free(alg, model, k),
            ranges: ranges(alg, model, k),
            nominal: k.samples[0].clone(),
            seconds: k.unknowns.clock().map(|_| model.run.seconds),
            random: Random(0xDEAD_9017),
        }
    }

    /// Configurations along the motion from the nominal one on, each reached from the one before.
    pub fn walk(&mut self) -> Vec<Sample> {
        let mut here = Sample { q: self.nominal.clone(), t: 0.0 };
        let mut found = vec![here.clone()];
        for _ in 0..STEPS * ATTEMPTS {
            if found.len() > STEPS {
                break;
            }
            if let Some(next) = self.step(&here, 1.0) {
                found.push(next.clone());
                here = next;
            }
        }
        found
    }

    /// Configurations from one on, at each of which `measure` is less than at the one before; ends where it is no
    /// longer above 0. Steps become shorter where none of those tried lessens it.
    pub fn descend(
        &mut self,
        start: Sample,
        value: f64,
        mut measure: impl FnMut(&[Sample]) -> Vec<f64>,
    ) -> Vec<Sample> {
        let (mut found, mut least, mut part) = (vec![start.clone()], value, 1.0);
        let mut here = start;
        for _ in 0..ROUNDS {
            let steps: Vec<Sample> = (0..TRIES).filter_map(|_| self.step(&here, part)).collect();
            let values = measure(&steps);
            let best = steps.into_iter().zip(values).min_by(|(_, a), (_, b)| a.total_cmp(b));
            match best.filter(|(_, value)| *value < least) {
                Some((step, value)) => {
                    (here, least) = (step, value);
                    found.push(here.clone());
                }
                None => part *= 0.5,
            }
            if least <= 0.0 {
                break;
            }
        }
        found
    }

    /// A random step, at most this part of the largest one; `None` if it leads out of the ranges or off the motion.
    fn step(&mut self, here: &Sample, part: f64) -> Option<Sample> {
        let mut next = here.clone();
        if let Some(seconds) = self.seconds {
            let stride = part * STRIDE.0 * seconds;
            next.t = (here.t + self.random.between((-stride, stride))).clamp(0.0, seconds);
            self.assembly.set_time(here.t);
            next.q = self.assembly.continue_in_time(&here.q, next.t).ok()?;
        }
        for (q, (low, high)) in next.q.iter_mut().zip(&self.ranges) {
            let stride = part * (STRIDE.0 * (high - low)).min(STRIDE.1);
            *q += self.random.between((-stride, stride));
        }
        self.assembly.to_unit_length(&mut next.q, |_| false);
        self.assembly.correct(&mut next.q).ok()?;
        is_inside(&self.ranges, &next.q).then_some(next)
    }
}

/// Ranges of the coordinates that are part of the state.
pub(super) fn ranges(alg: &Algebra, model: &Model, k: &Kinematics) -> Vec<(f64, f64)> {
    let state = model.coordinates.ids().filter(|&c| k.coordinate_symbol(&alg.dag, c).is_some());
    state.map(|c| model.coordinates[c].range).collect()
}

/// Are all coordinates within their ranges, up to rounding? A dead point may lie at an end of a range.
pub(super) fn is_inside(ranges: &[(f64, f64)], q: &[f64]) -> bool {
    ranges.iter().zip(q).all(|((low, high), q)| {
        let slack = ROUNDING * (high - low);
        (low - slack..=high + slack).contains(q)
    })
}
