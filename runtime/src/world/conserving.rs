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

use super::accounts::Accounts;
use super::carrier::{Carrier, Wrench};
use super::contacts::{load_contacts, press};
use super::observer::{Forces, Observer, Push};
use super::step::StepReport;
use super::sweep::Sweeps;
use super::whole::{StepMemory, World};
use crate::flexible::{force, mean};
use crate::mechanism::Fault;
use crate::ode::nodes::MeanStep;
use crate::ode::{Ode, State, pivot_limit, state::advance, trial::split};
use crate::real::Scalar;
use crate::rigid::anderson::eliminate;
use crate::rigid::contact::{Contact, Point, Side, Twist};
use crate::rigid::trail::DEPTH;
use crate::surface::Frame;
use crate::vec3::{self, Vec3};

/// Most iterations; at h w = 1 about 15 reach the rounding of f64.
const ITERATIONS: usize = 300;
/// An iteration with |f|^2 above this many times the least of the history ends the history.
const WORSE: f64 = 16.0;
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
    trail: Trail<'m, S>,
}

/// History of Anderson acceleration: differences of f = g(k) - k and of g from one iteration to the next.
struct Trail<'m, S> {
    /// Iterations recorded since it began.
    number: usize,
    /// Least |f|^2 among them.
    least: S,
    /// g and f of the last one.
    gained: &'m mut [S],
    off: &'m mut [S],
    /// Differences of f, then of g.
    differences: &'m mut [S],
}

impl<S: Scalar, C: Carrier<S>> World<'_, S, C> {
    /// Advances the state from t by h (s), > 0, with forces that are means over the step.
    ///
    /// # Errors
    /// As [`World::step`]; [`Fault::Unsettled`] if the step is too long for the iteration to converge. The state is
    /// then unchanged.
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
        let (more, trail) = more.split_at_mut_checked(5 * n).ok_or(Fault::Shape)?;
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
        let trail = Trail { number: 0, least: S::ZERO, gained, off, differences: trail };
        let spares = Spares { touched, found, spare, trail };
        let (pivot, sweeps) = self.settle_rates(&mut span, spares, state.low(), memory, means)?;
        let accounts = self.observe_means(h, memory, means);
        if watch.watches() {
            self.show_means(h, memory, means, watch);
        }
        let Span { end, middle, rates, .. } = span;
        let old = state.x().iter().zip(state.low()).zip(rates.iter());
        for ((x, l), ((old, old_low), rate)) in end.iter_mut().zip(low.iter_mut()).zip(old) {
            (*x, *l) = advance(*old, *old_low, h * *rate);
        }
        self.project(t + h, end, low, middle)?;
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
        self.fill_twists([t, t + h], h, middle, rates, spare, memory)?;
        self.find_contacts((t + half, h), middle, memory)
    }

    /// Iterates the rates of a span until they converge; returns the worst pivot and the last sweeps.
    fn settle_rates(
        &mut self,
        span: &mut Span<'_, S>,
        Spares { touched, found, spare, mut trail }: Spares<'_, S>,
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
                self.fill_twists([span.t, span.t + span.h], span.h, touched, found, spare, memory)?;
                sweeps = press(span.h, memory);
                let own = &mut self.island.memory;
                let mean = Mean {
                    frames: [&*means.frames[0], &*own.frames, &*means.frames[1]],
                    nodes: &*means.nodes[1],
                };
                let contacts = memory.contacts().iter().map(|touch| mean.contact(&touch.contact));
                load_contacts(span.h, contacts, (&mut *own.elastic, &mut *own.wrenches));
                pivot = self.mean_rates(span, found)?;
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
            trail.go_on(n_q, span.rates, found);
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

    /// Energy accounts of this step: work of the mean forces over the actual displacements.
    fn observe_means(
        &mut self,
        h: S,
        memory: &mut StepMemory<'_, S>,
        means: &mut MeanMemory<'_, S>,
    ) -> Accounts<S> {
        let mut accounts = Accounts::empty();
        let island = &mut self.island;
        let ports = island.memory.frames.len();
        let [start, middle, change, velocity] = &means.nodes;
        let way = MeanStep { h, pos: [start, middle, island.memory.pos], dx: change, vel: velocity };
        accounts.damping = mean::dissipated(island.body.springs, &way);
        let squares = velocity.iter().fold(S::ZERO, |sum, v| sum + vec3::dot(*v, *v));
        accounts.drag = h * island.body.air_drag * squares;
        let twists = &mut *memory.twists[2];
        let (of_ports, of_nodes) = twists.split_at_mut_checked(ports).unwrap_or_default();
        for (twist, velocity) in of_nodes.iter_mut().zip(velocity.iter()) {
            *twist = Twist { velocity: *velocity, angular: vec3::zero() };
        }
        for ((from, to), twist) in means.frames[0].iter().zip(island.memory.frames.iter_mut()).zip(of_ports) {
            (to.velocity, to.angular_velocity) = from.way_to(to, h);
            *twist = Twist { velocity: to.velocity, angular: to.angular_velocity };
        }
        let own = &island.memory;
        let mean =
            Mean { frames: [&*means.frames[0], &*own.frames, &*means.frames[1]], nodes: &*means.nodes[1] };
        for touch in memory.touches[0].get(..memory.counts[0]).unwrap_or_default() {
            let contact = mean.contact(&touch.contact);
            let ([n, x, y], [vn, vx, vy]) = (contact.impulse, contact.relative(twists));
            accounts.impact = accounts.impact - n * vn;
            accounts.friction = accounts.friction - (x * vx + y * vy);
        }
        accounts.drive = h * island.carrier.drive_power(own.frames, own.wrenches).unwrap_or(S::ZERO);
        accounts
    }

    /// Shows this step, whose mean velocities are known: mean forces, what each damper takes, impulses.
    fn show_means(
        &self,
        h: S,
        memory: &StepMemory<'_, S>,
        means: &MeanMemory<'_, S>,
        watch: &mut impl Observer<S>,
    ) {
        let (body, own) = (&self.island.body, &self.island.memory);
        let [start, middle, change, velocity] = &means.nodes;
        let ends = [&*memory.twists[2]; 2];
        watch.forces(&Forces { duration: h, elastic: own.elastic, viscous: own.viscous, ends });
        let way = MeanStep { h, pos: [start, middle, own.pos], dx: change, vel: velocity };
        for spring in body.springs {
            watch.damped(spring.tail, mean::dissipated(core::slice::from_ref(spring), &way));
        }
        for (node, v) in velocity.iter().enumerate() {
            watch.damped(node, h * body.air_drag * vec3::dot(*v, *v));
        }
        let mean =
            Mean { frames: [&*means.frames[0], &*own.frames, &*means.frames[1]], nodes: &*means.nodes[1] };
        for touch in memory.contacts() {
            let contact = &mean.contact(&touch.contact);
            watch.push(&Push { pair: touch.pair, contact, duration: S::ONE, ends, strikes: true });
        }
    }
}

/// Mean positions over a step.
struct Mean<'m, S> {
    /// Frames of the ports at the start, at the end, and where contacts were detected.
    frames: [&'m [Frame<S>]; 3],
    /// Mean positions of the nodes.
    nodes: &'m [Vec3<S>],
}

impl<S: Scalar> Mean<'_, S> {
    /// The contact with arms from the mean origins of the frames to the mean contact points. A point of a rigid body
    /// slips along the other side during the step; it is moved to where the other side is, so that the two opposite
    /// forces leave no moment.
    fn contact(&self, contact: &Contact<S>) -> Contact<S> {
        let mut new = *contact;
        new.sides = contact.sides.map(|side| side.with_arms(|point| self.arm(point)));
        let [one, other] = new.sides.map(|side| self.place(&side));
        let Some(apart) = one.zip(other).map(|(one, other)| vec3::sub(other, one)) else { return new };
        let is_rigid = |side: &Side<S>| {
            let mut points = side.points();
            points.next().is_some_and(|point| point.body < self.frames[0].len()) && points.next().is_none()
        };
        let [one, other] = new.sides;
        if is_rigid(&one) {
            new.sides[0] = one.with_arms(|point| vec3::add(point.arm, apart));
        } else if is_rigid(&other) {
            new.sides[1] = other.with_arms(|point| vec3::sub(point.arm, apart));
        }
        new
    }

    /// The frames of a port; None for a node.
    fn port(&self, body: usize) -> Option<[&Frame<S>; 3]> {
        let [from, to, seen] = self.frames.map(|frames| frames.get(body));
        Some([from?, to?, seen?])
    }

    fn arm(&self, point: &Point<S>) -> Vec3<S> {
        let Some([from, to, seen]) = self.port(point.body) else { return point.arm };
        let own = seen.to_local(point.arm);
        vec3::scale(vec3::add(from.to_inertial(own), to.to_inertial(own)), S::from_f64(0.5))
    }

    /// The mean position of a side; None where it is fixed in space.
    fn place(&self, side: &Side<S>) -> Option<Vec3<S>> {
        let ports = self.frames[0].len();
        let of = |point: &Point<S>| match self.port(point.body) {
            Some([from, to, _]) => vec3::axpy(point.arm, S::from_f64(0.5), vec3::add(from.origin, to.origin)),
            None => vec3::at(self.nodes, point.body - ports),
        };
        let sum = |sum, point: &Point<S>| Some(vec3::axpy(sum?, point.weight, of(point)));
        side.points().next()?;
        // A side that is partly fixed in space has no such position: the weights of its points do not add up to 1.
        let whole = side.points().fold(S::ZERO, |sum, point| sum + point.weight);
        ((whole - S::ONE).abs() < S::from_f64(1e-3)).then(|| side.points().fold(Some(vec3::zero()), sum))?
    }
}

impl<S: Scalar> Trail<'_, S> {
    /// The next rates by Anderson's method: g - sum_i gamma_i dg_i, gamma = argmin |f - sum_i gamma_i df_i| over the
    /// rates of the speeds.
    fn go_on(&mut self, n_q: usize, rates: &mut [S], found: &[S]) {
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

fn copy<T: Copy>(to: &mut [T], from: &[T]) {
    to.iter_mut().zip(from).for_each(|(to, from)| *to = *from);
}
