//! Dormand and Prince's pair 5(4): adaptive step, dense output of order 4.
//!
//! In: state at t, the longest step allowed. Out: state after a step that meets the tolerance. Time goes forward only.
//! The last stage is the first of the next step, unless a projection has moved the state. A rejected attempt is
//! repeated with a smaller step, at most [`MAX_REJECTIONS`] times.

use super::state::State;
use super::step_size::{Controller, Tolerance};
use super::system::Ode;
use super::tableau::{self, Tableau};
use super::trial::{Report, Trial, check_shape, evaluate, split};
use crate::mechanism::Fault;
use crate::real::{Constant, Scalar};

const METHOD: Tableau<Constant, 7> = tableau::DORMAND_PRINCE.rounded();
const DENSE: [Constant; 7] = tableau::row(tableau::DORMAND_PRINCE_DENSE);

/// Most rejected attempts in one step: 0.2^20 of the first step is below any resolution.
pub const MAX_REJECTIONS: u32 = 20;

/// Scratch numbers for a state of `n` entries.
#[must_use]
pub const fn scratch(n: usize) -> usize {
    11 * n
}

/// Where in a step its stages lie, but for the second one, which has no weight in the solution and in its error: what only
/// that one sees is hidden.
const SEEN: [Constant; 7] = {
    let mut seen = METHOD.c;
    seen[1] = seen[0];
    seen
};

/// Most halvings of a step that hides something ([`Ode::hides`]).
const MAX_HALVINGS: u32 = 64;

/// A step that was taken.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Taken<S> {
    /// Its length.
    pub h: S,
    /// Attempts rejected before it.
    pub rejected: u32,
    /// Worst pivot and residual.
    pub report: Report<S>,
}

/// The method with its memory.
#[derive(Debug)]
pub struct DormandPrince<'a, S> {
    /// Allowed error per step.
    pub tolerance: Tolerance<S>,
    /// The step to be tried next, above 0.
    pub next: S,
    controller: Controller<S>,
    /// Rates of the seven stages.
    k: [&'a mut [S]; 7],
    /// State at the start of the last step, rounded.
    x_old: &'a mut [S],
    stage: &'a mut [S],
    x_new: &'a mut [S],
    low_new: &'a mut [S],
    /// Length of the last step; 0 before the first and after a refused one.
    h: S,
    /// Whether the last stage holds the rates at `x_new`.
    reusable: bool,
}

impl<'a, S: Scalar> DormandPrince<'a, S> {
    /// For states of `n` entries, first trying the step `first`; `memory` holds [`scratch`]`(n)` numbers.
    ///
    /// # Errors
    /// [`Fault::Shape`] if `memory` is shorter.
    pub fn new(n: usize, tolerance: Tolerance<S>, first: S, memory: &'a mut [S]) -> Result<Self, Fault> {
        let [k0, k1, k2, k3, k4, k5, k6, x_old, stage, x_new, low_new] = split(memory, n)?;
        let k = [k0, k1, k2, k3, k4, k5, k6];
        let controller = Controller::default();
        let (h, reusable) = (S::ZERO, false);
        Ok(Self { tolerance, next: first, controller, k, x_old, stage, x_new, low_new, h, reusable })
    }

    /// Call when the system or its inputs have changed abruptly: discards the stored stage and the error history.
    pub fn restart(&mut self) {
        self.controller = Controller::default();
        self.reusable = false;
    }

    /// One step, at most `h_max` long.
    ///
    /// # Errors
    /// [`Fault::StepSize`] if the tolerance is not met after [`MAX_REJECTIONS`] attempts, or if `h_max` or `next` is
    /// not above 0, or both are infinite; the fault of the last attempt if it was one (singular, not finite). The state
    /// is then unchanged, bit for bit.
    pub fn step(
        &mut self,
        system: &mut impl Ode<S>,
        t: S,
        h_max: S,
        state: &mut State<'_, S>,
    ) -> Result<Taken<S>, Fault> {
        if check_shape(system, state)? != self.x_new.len() {
            return Err(Fault::Shape);
        }
        let mut h = self.next.min(h_max);
        if !h.is_finite() || h <= S::ZERO {
            return Err(Fault::StepSize);
        }
        // Forgets the last step, whose stages the attempts overwrite.
        self.h = S::ZERO;
        let mut last = Fault::StepSize;
        for rejected in 0..=MAX_REJECTIONS {
            for _ in 0..MAX_HALVINGS {
                if !system.hides(t, h, &SEEN.map(S::constant)) {
                    break;
                }
                h = h / (S::ONE + S::ONE);
            }
            let norm = match self.attempt(system, t, h, state) {
                Ok((norm, report)) if norm <= S::ONE => {
                    // A step cut short by `h_max` is no evidence against the longer one.
                    let proposed = h * self.controller.accept(norm);
                    let cut_short = rejected == 0 && h < self.next;
                    self.next = if cut_short { self.next.max(proposed) } else { proposed };
                    self.commit(system, h, state);
                    return Ok(Taken { h, rejected, report });
                }
                Ok((norm, _)) => {
                    last = Fault::StepSize;
                    norm
                }
                Err(Fault::Shape) => return Err(Fault::Shape),
                Err(fault) => {
                    last = fault;
                    S::ONE / S::ZERO
                }
            };
            self.reusable = false;
            h = h * self.controller.reject(norm);
        }
        Err(last)
    }

    /// Steps from `t` to exactly `end`; returns the number of steps.
    ///
    /// # Errors
    /// Those of [`DormandPrince::step`]; [`Fault::StepSize`] after `max_steps` steps, or if `end` is before `t` by more
    /// than rounding, or not finite. The state is then that of the last good step and `t` its time.
    pub fn advance_to(
        &mut self,
        system: &mut impl Ode<S>,
        t: &mut S,
        end: S,
        max_steps: u32,
        state: &mut State<'_, S>,
    ) -> Result<u32, Fault> {
        // A remainder below the resolution of t would never shrink to 0.
        let two = S::ONE + S::ONE;
        let resolution = two * S::EPSILON * t.abs().max(end.abs());
        let whole = end - *t;
        if !whole.is_finite() || whole < -resolution {
            return Err(Fault::StepSize);
        }
        for steps in 0..max_steps {
            let left = end - *t;
            if left <= resolution {
                *t = end;
                return Ok(steps);
            }
            // Two halves instead of one step and a tiny remainder.
            let h_max = if left < two * self.next && self.next < left { left / two } else { left };
            let taken = self.step(system, *t, h_max, state)?;
            *t = if taken.h == left { end } else { *t + taken.h };
        }
        if end - *t <= resolution { Ok(max_steps) } else { Err(Fault::StepSize) }
    }

    /// Dense output: the state at t + `theta` h of the last step, 0 <= `theta` <= 1; order 4.
    ///
    /// # Errors
    /// [`Fault::Shape`] if `x` and the state differ in length; [`Fault::StepSize`] before the first step, and after a
    /// refused one.
    pub fn dense(&self, theta: S, x: &mut [S]) -> Result<(), Fault> {
        if x.len() != self.x_new.len() {
            return Err(Fault::Shape);
        }
        if self.h == S::ZERO {
            return Err(Fault::StepSize);
        }
        let rest = S::ONE - theta;
        let [first, .., last] = &self.k;
        let ends = self.x_old.iter().zip(&*self.x_new).zip(first.iter().zip(&**last));
        for (index, (x, ((old, new), (k1, k7)))) in x.iter_mut().zip(ends).enumerate() {
            let bent = combine(&self.k, &DENSE, index);
            let difference = *new - *old;
            let start = self.h * *k1 - difference;
            let end = difference - self.h * *k7 - start;
            *x = *old + theta * (difference + rest * (start + theta * (end + rest * self.h * bent)));
        }
        Ok(())
    }

    /// The stages, the trial state and the norm of its error.
    fn attempt(
        &mut self,
        system: &mut impl Ode<S>,
        t: S,
        h: S,
        state: &State<'_, S>,
    ) -> Result<(S, Report<S>), Fault> {
        let mut pivot = S::ONE;
        for (number, (row, c)) in METHOD.a.iter().zip(METHOD.c).enumerate() {
            if number == 0 && self.reuse_last_stage(state) {
                continue;
            }
            for (index, (stage, (x, low))) in
                self.stage.iter_mut().zip(state.x().iter().zip(state.low())).enumerate()
            {
                *stage = *x + (*low + h * combine_some(&self.k, row, number, index));
            }
            let Some(k) = self.k.get_mut(number) else { return Err(Fault::Shape) };
            evaluate(system, t + S::constant(c) * h, self.stage, k, &mut pivot)?;
        }
        let mut trial = Trial { x: &mut *self.x_new, low: &mut *self.low_new };
        let k = &self.k;
        trial.advance_from(state, (0..k[0].len()).map(|index| h * combine(k, &METHOD.b, index)));
        let residual = trial.settle(system, t + h, self.stage)?;
        let errors = (0..k[0].len()).map(|index| h * combine(k, &METHOD.error.b, index));
        let values = state.x().iter().copied().zip(trial.x.iter().copied());
        let norm = self.tolerance.norm(errors, values);
        Ok((norm, Report { pivot, residual }))
    }

    /// Moves the last stage's rates to the first stage, if they belong to the present state; returns whether they did.
    fn reuse_last_stage(&mut self, state: &State<'_, S>) -> bool {
        let [first, .., last] = &mut self.k;
        let same = self.reusable && state.x().iter().zip(&*self.x_new).all(|(a, b)| a == b);
        if same {
            first.iter_mut().zip(&**last).for_each(|(first, last)| *first = *last);
        }
        same
    }

    /// Makes the trial state the state.
    fn commit(&mut self, system: &mut impl Ode<S>, h: S, state: &mut State<'_, S>) {
        self.x_old.iter_mut().zip(state.x()).for_each(|(old, x)| *old = *x);
        self.h = h;
        self.reusable = system.projections() == 0;
        Trial { x: &mut *self.x_new, low: &mut *self.low_new }.commit(system, state);
    }
}

/// Entry `index` of the sum over all stages of weight * rates.
fn combine<S: Scalar>(k: &[&mut [S]; 7], weights: &[Constant; 7], index: usize) -> S {
    combine_some(k, weights, 7, index)
}

/// The same over the first `count` stages; stages of weight 0 are skipped.
fn combine_some<S: Scalar>(k: &[&mut [S]; 7], weights: &[Constant; 7], count: usize, index: usize) -> S {
    let weights = weights.iter().map(|weight| S::constant(*weight));
    let stages = k.iter().zip(weights).take(count).filter(|(_, weight)| *weight != S::ZERO);
    stages.fold(S::ZERO, |sum, (k, weight)| sum + weight * k.get(index).copied().unwrap_or(S::ZERO))
}
