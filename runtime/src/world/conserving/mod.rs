//! Energy-conserving step of a world: forces are means over the step whose work is the change of the stored energy
//! (Simo & Tarnow 1992, Gonzalez 1996; rigid bodies Simo & Wong 1991).
//!
//! In: state [q, x; u, v] at t. Out: the state at t + h, contacts with their impulses, accounts.
//! ```text
//! v+ = v + h M^-1 f + M^-1 W' P,   x+ = x + h (v + v+)/2,   f = f(x, x+):  f . (x+ - x) = -(V(x+) - V(x)) - what dampers take
//! ```
//! Solved by fixed-point iteration with Anderson acceleration (1965). Contacts are detected as in `step`, at x + h/2 v;
//! each iteration recomputes their impulses P. For any step, the energy account closes to rounding and linear momentum
//! is conserved; so is angular momentum, except with gas and contacts between flexible parts (order 2). Mechanisms use
//! rates at the middle of the step: order 2.

mod anderson;
mod means;
mod observe;
mod turning;

use self::anderson::Anderson;
use super::carrier::{Carrier, Wrench};
use super::observer::Observer;
use super::step::StepReport;
use super::sweep::Sweeps;
use super::whole::{StepMemory, World};
use crate::flexible::force;
use crate::mechanism::Fault;
use crate::ode::nodes::{MeanStep, copy};
use crate::ode::{Ode, State, pivot_limit, state::advance, trial::split};
use crate::real::Scalar;
use crate::rigid::history::DEPTH;
use crate::surface::Frame;
use crate::vec3::{self, Vec3};

/// Most iterations; at h w = 1 about 15 reach the rounding of f64.
const ITERATIONS: usize = 300;
/// The iteration ends when changes fall below this many rounding units of the smaller of coordinates and speeds.
const SETTLED: f64 = 2.0;
/// Iterations without gain after which it ends near the solution: the last digits keep moving.
const PATIENCE: u32 = 3;

/// Working memory of a conserving step, in addition to a [`StepMemory`].
#[derive(Debug)]
pub struct MeanMemory<'a, S> {
    /// [`MeanMemory::scratch`] numbers.
    pub scratch: &'a mut [S],
    /// Positions at the start and in the middle, their changes, mean velocities: one entry per node each.
    pub nodes: [&'a mut [Vec3<S>]; 4],
    /// Frames of the ports at the start, and where contacts were detected: one entry per port each.
    pub frames: [&'a mut [Frame<S>]; 2],
}

impl<S: Scalar> MeanMemory<'_, S> {
    /// Numbers of scratch memory for a state of `n` entries.
    #[must_use]
    pub const fn scratch(n: usize) -> usize {
        (5 + 2 * DEPTH) * n
    }
}

/// A step being solved: start, middle and end, and the mean rates from start to end.
struct Span<'m, S> {
    t: S,
    h: S,
    /// The start, rounded.
    start: &'m mut [S],
    end: &'m mut [S],
    middle: &'m mut [S],
    rates: &'m mut [S],
}

/// Memory of the iteration: the state at which contacts were detected, new rates, and the history.
struct Spares<'m, S> {
    touched: &'m [S],
    found: &'m mut [S],
    spare: &'m mut [S],
    anderson: Anderson<'m, S>,
}

impl<S: Scalar, C: Carrier<S>> World<'_, S, C> {
    /// Advances the state from t by h (s), > 0, with forces that are means over the step.
    ///
    /// # Errors
    /// As [`World::step`]; [`Fault::Unsettled`] if the step is too long for the iteration to converge,
    /// [`Fault::Shape`] for a pair with a force law, whose mean over a step is not computed. The state is then unchanged.
    pub fn step_conserving(
        &mut self,
        t: S,
        h: S,
        state: &mut State<'_, S>,
        memory: &mut StepMemory<'_, S>,
        means: &mut MeanMemory<'_, S>,
    ) -> Result<StepReport<S>, Fault> {
        self.step_conserving_watched((t, h), state, memory, means, &mut ())
    }

    /// As [`World::step_conserving`], seen by an observer.
    ///
    /// # Errors
    /// As [`World::step_conserving`].
    pub fn step_conserving_watched(
        &mut self,
        time: (S, S),
        state: &mut State<'_, S>,
        memory: &mut StepMemory<'_, S>,
        means: &mut MeanMemory<'_, S>,
        watch: &mut impl Observer<S>,
    ) -> Result<StepReport<S>, Fault> {
        self.check(time.1)?;
        if self.yields() {
            return Err(Fault::Shape);
        }
        let own = core::mem::take(&mut memory.scratch);
        let more = core::mem::take(&mut means.scratch);
        let report = self.conserve(time, state, [&mut *own, &mut *more], (memory, means), watch);
        memory.scratch = own;
        means.scratch = more;
        report
    }

    fn conserve(
        &mut self,
        (t, h): (S, S),
        state: &mut State<'_, S>,
        [own, more]: [&mut [S]; 2],
        (memory, means): (&mut StepMemory<'_, S>, &mut MeanMemory<'_, S>),
        watch: &mut impl Observer<S>,
    ) -> Result<StepReport<S>, Fault> {
        let n = self.island.n_x();
        if own.len() < StepMemory::<S>::scratch(n) || more.len() < MeanMemory::<S>::scratch(n) {
            return Err(Fault::Shape);
        }
        let (more, differences) = more.split_at_mut_checked(5 * n).ok_or(Fault::Shape)?;
        let [start, end, middle, rates, touched] = split(own, n)?;
        let [found, spare, gained, off, low] = split(more, n)?;
        let fits = means.nodes.iter().all(|rows| rows.len() == self.island.body.points())
            && means.frames.iter().all(|frames| frames.len() == self.island.memory.frames.len());
        if state.x().len() != n || !fits {
            return Err(Fault::Shape);
        }
        copy(start, state.x());
        self.island.place(t, start)?;
        copy(means.nodes[0], self.island.memory.pos);
        copy(means.frames[0], self.island.memory.frames);
        self.predict((t, h), start, [&mut *middle, &mut *rates, &mut *spare], memory, means)?;
        // Contacts keep the middle at which they were detected, while the iteration moves the span's.
        copy(touched, middle);
        let mut span = Span { t, h, start, end, middle, rates };
        let anderson = Anderson { number: 0, least: S::ZERO, gained, off, differences };
        let spares = Spares { touched, found, spare, anderson };
        let (pivot, sweeps) = self.settle_rates(&mut span, spares, state.low(), memory, means)?;
        let accounts = self.observe_means(h, memory, means, watch);
        if watch.watches() {
            self.show_means(h, memory, means, watch);
        }
        let Span { end, middle, rates, .. } = span;
        let old = state.x().iter().zip(state.low()).zip(rates.iter());
        for ((x, l), ((old, old_low), rate)) in end.iter_mut().zip(low.iter_mut()).zip(old) {
            (*x, *l) = advance(*old, *old_low, h * *rate);
        }
        self.project(t + h, [&mut *end, &mut *low, middle])?;
        for ((x, l), (new, new_low)) in state.entries().zip(end.iter().zip(low.iter())) {
            (*x, *l) = (*new, *new_low);
        }
        let touches = memory.contacts();
        let active = touches.iter().filter(|touch| touch.contact.impulse[0] > S::ZERO).count();
        let near = touches.len();
        let Sweeps { number, settled, left } = sweeps;
        Ok(StepReport { pivot, near, active, sweeps: number, settled, left, accounts })
    }

    /// First guess: half the step with the speeds at the start gives the middle; rates and contacts there.
    fn predict(
        &mut self,
        (t, h): (S, S),
        start: &[S],
        [middle, rates, spare]: [&mut [S]; 3],
        memory: &mut StepMemory<'_, S>,
        means: &mut MeanMemory<'_, S>,
    ) -> Result<(), Fault> {
        let (half, n_q) = (S::from_f64(0.5) * h, self.island.n_q());
        self.coast(t, start, rates)?;
        for (index, (to, (x, rate))) in middle.iter_mut().zip(start.iter().zip(rates.iter())).enumerate() {
            *to = if index < n_q { *x + half * *rate } else { *x };
        }
        self.island.place(t + half, middle)?;
        copy(means.frames[1], self.island.memory.frames);
        self.island.load_seams()?;
        self.island.accelerate(t + half, middle, rates)?;
        self.carry_twists([t, t + h], h, middle, rates, spare, memory)?;
        let way = self.find_contacts((t + half, h), middle, memory)?;
        self.leave_out_behind((h, way), memory);
        Ok(())
    }

    /// Iterates the rates of a span until they converge; returns the worst pivot and the last sweeps.
    fn settle_rates(
        &mut self,
        span: &mut Span<'_, S>,
        Spares { touched, found, spare, mut anderson }: Spares<'_, S>,
        low: &[S],
        memory: &mut StepMemory<'_, S>,
        means: &mut MeanMemory<'_, S>,
    ) -> Result<(S, Sweeps<S>), Fault> {
        let (mut least, mut without_gain) = (S::ONE / S::ZERO, 0);
        let n_q = self.island.n_q();
        for _ in 0..ITERATIONS {
            let (half, rows) = (S::from_f64(0.5), span.start.iter().zip(low).zip(span.rates.iter()));
            for ((end, middle), ((x, low), rate)) in span.end.iter_mut().zip(span.middle.iter_mut()).zip(rows)
            {
                let way = span.h * *rate;
                (*end, *middle) = (*x + (*low + way), *x + (*low + half * way));
            }
            self.load_means(span, means)?;
            let mut pivot = self.mean_rates(span, found)?;
            let mut sweeps = Sweeps { number: 0, settled: true, left: S::ZERO };
            if memory.counts[0] > 0 {
                sweeps = self.press_turning(span, [touched, &*found], spare, memory, means)?;
                pivot = self.mean_rates(span, found)?;
                self.read_missed(span, [touched, &*found], spare, memory)?;
            }
            if !pivot.is_finite() {
                return Err(Fault::NonFinite);
            }
            if pivot < pivot_limit() {
                return Err(Fault::Singular);
            }
            let (mut step, mut size) = (S::ZERO, [S::ZERO; 2]);
            let rows = found.iter().zip(span.rates.iter()).zip(span.start.iter());
            for (index, ((rate, old), x)) in rows.enumerate() {
                step = step.max((span.h * (*rate - *old)).abs());
                let largest = &mut size[usize::from(index >= n_q)];
                *largest = largest.max(x.abs()).max((span.h * *rate).abs());
            }
            if !step.is_finite() {
                return Err(Fault::NonFinite);
            }
            without_gain = if step < least { 0 } else { without_gain + 1 };
            least = least.min(step);
            let [places, speeds] = size;
            let stalled = without_gain >= PATIENCE && step <= S::EPSILON.sqrt() * places.max(speeds);
            if step <= S::from_f64(SETTLED) * S::EPSILON * places.min(speeds) || stalled {
                copy(span.rates, found);
                return Ok((pivot, sweeps));
            }
            anderson.extrapolate(n_q, span.rates, found);
        }
        Err(Fault::Unsettled)
    }

    /// Mean forces on the nodes over a span, and the wrenches on the ports about the mean origins of their frames.
    fn load_means(&mut self, span: &Span<'_, S>, means: &mut MeanMemory<'_, S>) -> Result<(), Fault> {
        self.island.place(span.t + span.h, span.end)?;
        let rates = self.island.parts(span.rates)?.pos;
        let island = &mut self.island;
        let (half, own) = (S::from_f64(0.5), &mut island.memory);
        let [start, middle, change, velocity] = &mut means.nodes;
        let rows = middle.iter_mut().zip(change.iter_mut().zip(velocity.iter_mut()));
        for ((x, y), (middle, (change, velocity))) in start.iter().zip(own.pos.iter()).zip(rows) {
            *change = vec3::sub(*y, *x);
            *middle = vec3::scale(vec3::add(*x, *y), half);
            *velocity = vec3::scale(*change, S::ONE / span.h);
        }
        // In a tiny step the difference of two positions is mostly rounding, so free nodes take theirs from the rates.
        for (node, rate) in super::island::free_nodes(&island.body).zip(rates.chunks_exact(3)) {
            if let (Some(change), Some(velocity), [x, y, z]) =
                (change.get_mut(node), velocity.get_mut(node), rate)
            {
                (*velocity, *change) = ([*x, *y, *z], vec3::scale([*x, *y, *z], span.h));
            }
        }
        let way = MeanStep { h: span.h, pos: [start, middle, own.pos], dx: change, vel: velocity };
        force::eval_mean(&island.body, &island.body.elements(), &way, own.elastic)
            .map_err(|_| Fault::NonFinite)?;
        for cell in island.cells {
            cell.add_mean_force(island.body.facets, &way, own.elastic)?;
        }
        own.viscous.fill(vec3::zero());
        own.wrenches.fill(Wrench::zero());
        for attachment in island.attachments {
            let ends = [&*means.frames[0], &*own.frames].map(|list| list.get(attachment.port));
            let ([Some(from), Some(to)], Some(wrench)) = (ends, own.wrenches.get_mut(attachment.port)) else {
                continue;
            };
            let force = vec3::at(own.elastic, attachment.node);
            let origin = vec3::scale(vec3::add(from.origin, to.origin), half);
            let arm = vec3::sub(vec3::at(middle, attachment.node), origin);
            wrench.force = vec3::add(wrench.force, force);
            wrench.moment = vec3::add(wrench.moment, vec3::cross(arm, force));
        }
        Ok(())
    }

    /// Mean rates over a span under the forces in memory; returns the worst pivot.
    fn mean_rates(&mut self, span: &Span<'_, S>, rates: &mut [S]) -> Result<S, Fault> {
        let island = &mut self.island;
        let [from, between, to] = [&*span.start, &*span.middle, &*span.end].map(|x| island.parts(x));
        let (from, between, to) = (from?, between?, to?);
        let dot = island.parts_mut(rates)?;
        let (q, u) = ([from.q, between.q, to.q], [from.u, between.u, to.u]);
        let pivot =
            island.carrier.mean_rates([span.t, span.h], q, u, island.memory.wrenches, dot.q, dot.u)?.abs();
        let half = S::from_f64(0.5) * span.h;
        let rows = dot.pos.chunks_exact_mut(3).zip(dot.vel.chunks_exact_mut(3)).zip(from.vel.chunks_exact(3));
        for (node, ((way, rate), speed)) in super::island::free_nodes(&island.body).zip(rows) {
            let force = vec3::scale(vec3::at(island.memory.elastic, node), island.body.inverse_mass(node));
            for ((way, rate), (speed, force)) in way.iter_mut().zip(rate).zip(speed.iter().zip(force)) {
                (*rate, *way) = (force, *speed + half * force);
            }
        }
        Ok(pivot)
    }
}
