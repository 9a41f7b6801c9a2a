//! Time-stepping of a world without splitting (Moreau 1988, Jean 1999): impacts and lasting contacts are treated alike.
//!
//! In: state [q, x; u, v] at t. Out: the state at t + h, contacts with their impulses, accounts.
//! ```text
//! advance   x_m = x + h/2 N(x) v
//! forces    f there, with the speeds of the start
//! detect    contacts at x_m: gap, axes, W, K = W M^-1 W';  those that push
//! correct   f with the speeds v + h/2 M^-1 f of what does not touch, and the places x_m + h^2/12 M^-1 f of what is held
//! sweep     v+ = v + h M^-1 f + M^-1 W' P,  P by the laws of the contacts (`sweep`)
//! close     x+ = x_m + h/2 N(x+) v+, by one correction;  projection onto the carriers' constraints
//! observe   accounts, contacts by pair
//! ```
//! Order 2 where nothing touches, else 1; contacts only dissipate. Flexible bodies that space or a commanded part holds
//! oscillate at frequencies of order 4 where they touch nothing; those that float keep their angular momentum to
//! rounding. No event is located in time, so the cost of a step hardly depends on how many events it holds.

use super::accounts::Accounts;
use super::booking::take;
use super::carrier::{Carrier, Wrench};
use super::contacts::{load_contacts, press};
use super::observer::Observer;
use super::whole::{StepMemory, World};
use crate::mechanism::Fault;
use crate::ode::{Ode, State, pivot_limit, state::advance, trial::split};
use crate::real::Scalar;
use crate::vec3;

/// How a step goes through time.
pub(super) struct Course<S> {
    /// Times of its start, middle and end: all one where time stands still.
    pub(super) times: [S; 3],
    /// Does what meets rebound as its law says? On the way to rest it does not.
    pub(super) rebounds: bool,
}

/// What a step did.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StepReport<S> {
    /// Worst pivot of the carriers.
    pub pivot: S,
    /// Contacts that were near.
    pub near: usize,
    /// Contacts with an impulse.
    pub active: usize,
    /// Sweeps over the contacts.
    pub sweeps: usize,
    /// Whether the sweeps converged.
    pub settled: bool,
    /// Change of the speeds by the last sweep, relative to the fastest.
    pub left: S,
    /// Energy accounts of this step.
    pub accounts: Accounts<S>,
}

impl<S: Scalar, C: Carrier<S>> World<'_, S, C> {
    /// Advances the state from t by h (s), > 0.
    ///
    /// # Errors
    /// [`Fault::Shape`] for lists of wrong length, and for things and pairs that name what does not exist;
    /// [`Fault::StepSize`] if h is not > 0 and finite; [`Fault::TooManyContacts`] where the lists have no room;
    /// [`Fault::Singular`] or [`Fault::NonFinite`] if the middle or the end is so, or a pair's law is no number. The
    /// state is then unchanged.
    pub fn step(
        &mut self,
        t: S,
        h: S,
        state: &mut State<'_, S>,
        memory: &mut StepMemory<'_, S>,
    ) -> Result<StepReport<S>, Fault> {
        self.step_watched((t, h), state, memory, &mut ())
    }

    /// As [`World::step`], seen by an observer.
    ///
    /// # Errors
    /// As [`World::step`].
    pub fn step_watched(
        &mut self,
        (t, h): (S, S),
        state: &mut State<'_, S>,
        memory: &mut StepMemory<'_, S>,
        watch: &mut impl Observer<S>,
    ) -> Result<StepReport<S>, Fault> {
        self.check(h)?;
        let course = Course { times: [t, t + S::from_f64(0.5) * h, t + h], rebounds: true };
        self.step_at((&course, h), state, memory, watch)
    }

    /// A step over a course of time.
    pub(super) fn step_at(
        &mut self,
        course: (&Course<S>, S),
        state: &mut State<'_, S>,
        memory: &mut StepMemory<'_, S>,
        watch: &mut impl Observer<S>,
    ) -> Result<StepReport<S>, Fault> {
        let scratch = core::mem::take(&mut memory.scratch);
        let report = self.step_within(course, state, scratch, memory, watch);
        memory.scratch = scratch;
        report
    }

    fn step_within(
        &mut self,
        (course, h): (&Course<S>, S),
        state: &mut State<'_, S>,
        scratch: &mut [S],
        memory: &mut StepMemory<'_, S>,
        watch: &mut impl Observer<S>,
    ) -> Result<StepReport<S>, Fault> {
        let [t, t_middle, t_end] = course.times;
        let n = self.island.n_x();
        let [middle, dot, rest, new, low] = split(scratch, n)?;
        if state.x().len() != n {
            return Err(Fault::Shape);
        }
        // `rest` gets the carriers' q' at the start.
        self.advance_to_middle((t, h), state, rest, middle)?;
        let mut pivot = self.forces_at_middle(t_middle, middle, dot)?;

        // Contact impulses act as forces at the middle.
        self.carry_twists([t, t_end], h, middle, dot, new, memory)?;
        let way = self.find_contacts((t_middle, h), middle, memory)?;
        // A relaxation, in which no time passes, moves out of one another what starts so.
        if t_end > t {
            self.leave_out_behind((h, way), memory);
        }
        if !course.rebounds {
            memory.touches[0].iter_mut().for_each(|touch| touch.contact.restitution = S::ZERO);
        }
        let corrects =
            self.island.is_damped() || !self.island.restrained.is_empty() || self.yields_by_speed();
        if corrects {
            // Only what pushes touches: what is near may pass by.
            press(h, memory);
            pivot = pivot.min(self.correct((t_middle, h), [middle, &mut *dot, &mut *low], memory)?);
            if self.island.carrier.n_u() > 0 {
                self.carry_twists([t, t_end], h, middle, dot, new, memory)?;
            }
            self.read_touched(h, memory);
        }
        let sweeps = press(h, memory);
        let own = &mut self.island.memory;
        let forces = (&mut *own.elastic, &mut *own.wrenches);
        let active = load_contacts(h, memory.contacts().iter().map(|touch| touch.contact), forces);
        if active > 0 {
            self.island.carrier_rates(t_middle, if corrects { low } else { middle }, dot)?;
        }
        let accounts = self.accelerate(h, dot)?;

        let accounts = self.observe(h, accounts, memory, watch);
        if watch.watches() {
            self.show(h, memory, watch);
        }

        self.turn_at_end(([t_middle, t_end], h), [&*middle, &*dot], [&mut *new, &mut *low])?;
        let finite = self.close(h, state, [rest, dot], [new, low])?;
        self.project_carriers(t_end, [&mut *new, &mut *low, middle])?;
        let [ends, lows] = [self.island.parts(new)?, self.island.parts(low)?];
        if !(finite && [ends.q, ends.u, lows.q, lows.u].into_iter().all(is_finite)) {
            return Err(Fault::NonFinite);
        }
        for ((x, l), (new, new_low)) in state.entries().zip(new.iter().zip(low.iter())) {
            (*x, *l) = (*new, *new_low);
        }
        let near = memory.counts[0];
        Ok(StepReport {
            pivot,
            near,
            active,
            sweeps: sweeps.number,
            settled: sweeps.settled,
            left: sweeps.left,
            accounts,
        })
    }

    /// Advances by half the step with the speeds at the start: carriers turn by their q', which `rest` gets, nodes move
    /// by their velocities.
    fn advance_to_middle(
        &mut self,
        (t, h): (S, S),
        state: &State<'_, S>,
        rest: &mut [S],
        middle: &mut [S],
    ) -> Result<(), Fault> {
        self.turn(t, state.x(), rest)?;
        let (half, island) = (S::from_f64(0.5) * h, &self.island);
        let [from, error] = [island.parts(state.x())?, island.parts(state.low())?];
        let to = island.parts_mut(middle)?;
        for (to, from, error, rates) in
            [(to.q, from.q, error.q, &*rest), (to.pos, from.pos, error.pos, from.vel)]
        {
            for ((to, rate), (from, error)) in to.iter_mut().zip(rates).zip(from.iter().zip(error)) {
                *to = *from + (*error + half * *rate);
            }
        }
        for (to, from) in [(to.u, from.u), (to.vel, from.vel)] {
            to.iter_mut().zip(from).for_each(|(to, from)| *to = *from);
        }
        Ok(())
    }

    /// Turns the carriers by the other half with their speeds at the end; `low` gets their q' there.
    fn turn_at_end(
        &mut self,
        ([t_middle, t_end], h): ([S; 2], S),
        [middle, dot]: [&[S]; 2],
        [new, low]: [&mut [S]; 2],
    ) -> Result<(), Fault> {
        let (turning, n_q, n_u) = (self.island.carrier.n_q(), self.island.n_q(), self.island.carrier.n_u());
        if turning == 0 {
            return Ok(());
        }
        for ((to, from), rate) in new.iter_mut().zip(middle).zip(dot).skip(n_q).take(n_u) {
            *to = *from + h * *rate;
        }
        new.iter_mut().zip(middle).take(turning).for_each(|(to, from)| *to = *from);
        self.turn(t_middle, new, low)?;
        // N at the end, so that both halves together are symmetric in time: order 2, and Euler parameters of unit
        // length.
        let (half, ends) = (S::from_f64(0.5) * h, new.iter_mut().zip(middle.iter().zip(low.iter())));
        ends.take(turning).for_each(|(to, (from, rate))| *to = *from + half * *rate);
        self.turn(t_end, new, low)
    }

    /// Forces at the middle, and the carriers' rates under them; returns the worst pivot.
    fn forces_at_middle(&mut self, t: S, middle: &[S], dot: &mut [S]) -> Result<S, Fault> {
        self.island.place(t, middle)?;
        self.load_seams()?;
        checked(self.island.carrier_rates(t, middle, dot)?)
    }

    /// Forces at what their rates predict of parts on which no contact pushes, and the carriers' rates under them;
    /// returns the worst pivot. What touches keeps its place and speed, since what holds it is not known yet: a load at
    /// rest stays at rest. `predicted` gets the carriers' speeds; the nodes are left as they were placed.
    fn correct(
        &mut self,
        (t, h): (S, S),
        [middle, dot, predicted]: [&mut [S]; 3],
        memory: &StepMemory<'_, S>,
    ) -> Result<S, Fault> {
        let (half, yields, island) = (S::from_f64(0.5) * h, self.yields(), &mut self.island);
        let ports = island.memory.frames.len();
        let pushing = || memory.contacts().iter().filter(|touch| touch.contact.impulse[0] > S::ZERO);
        let mut points = pushing().flat_map(|touch| touch.contact.points());
        let way = if points.any(|(_, point)| point.body < ports) { S::ZERO } else { half };
        let ([from, rates], to) = ([island.parts(middle)?, island.parts(dot)?], island.parts_mut(predicted)?);
        to.q.iter_mut().zip(from.q).for_each(|(to, from)| *to = *from);
        for (to, (from, rate)) in to.u.iter_mut().zip(from.u.iter().zip(rates.u)) {
            *to = *from + way * *rate;
        }
        // Speeds of the middle: with those of the start a step is of order 1 wherever forces depend on speeds.
        island.predict_speeds(t, half, (to.q, to.u))?;
        let touching = || pushing().flat_map(|touch| touch.nodes(ports));
        for node in touching() {
            if let (Some(velocity), Some(start)) =
                (island.memory.vel.get_mut(node), memory.twists[0].get(ports + node))
            {
                *velocity = start.velocity;
            }
        }
        if island.restrained.is_empty() && !yields {
            island.load_speeds();
        } else {
            // A step turns an oscillator by too much, w h (1 + (w h)^2 / 24): f(x + h^2/12 M^-1 f(x)) takes that away
            // (Rowlands 1991). Its torque about x is not 0, so bodies that float are left alone.
            touching().for_each(|node| island.unload(node));
            island.displace(h * h * S::from_f64(1.0 / 12.0));
            self.load_seams()?;
        }
        let pivot = checked(self.island.carrier_rates(t, predicted, dot)?)?;
        self.island.place_nodes(middle)?;
        Ok(pivot)
    }

    /// Writes the state at the end: coordinates by the mean of their rates at start and end, speeds by those in the
    /// middle. In: `start` and `low` hold the carriers' q' at start and end, `dot` the rates of speeds.
    /// Returns whether the nodes are at finite places and speeds.
    fn close(
        &self,
        h: S,
        state: &State<'_, S>,
        [start, dot]: [&[S]; 2],
        [new, low]: [&mut [S]; 2],
    ) -> Result<bool, Fault> {
        let half = S::from_f64(0.5) * h;
        let island = &self.island;
        let [old, old_low, rates] =
            [island.parts(state.x())?, island.parts(state.low())?, island.parts(dot)?];
        let [new, low] = [island.parts_mut(new)?, island.parts_mut(low)?];
        let ends = new.q.iter_mut().zip(low.q).zip(old.q.iter().zip(old_low.q));
        for (((x, l), (old, old_low)), start) in ends.zip(start) {
            (*x, *l) = advance(*old, *old_low, half * (*start + *l));
        }
        let ends = new.u.iter_mut().zip(low.u).zip(old.u.iter().zip(old_low.u));
        for (((u, l), (old, old_low)), rate) in ends.zip(rates.u) {
            (*u, *l) = advance(*old, *old_low, h * *rate);
        }
        let places = new.pos.iter_mut().zip(low.pos).zip(old.pos.iter().zip(old_low.pos));
        let speeds = new.vel.iter_mut().zip(low.vel).zip(old.vel.iter().zip(old_low.vel));
        let mut finite = true;
        for ((((x, x_low), (x_old, x_old_low)), ((v, v_low), (v_old, v_old_low))), rate) in
            places.zip(speeds).zip(rates.vel)
        {
            let change = h * *rate;
            (*x, *x_low) = advance(*x_old, *x_old_low, half * (*v_old + (*v_old + change)));
            (*v, *v_low) = advance(*v_old, *v_old_low, change);
            // Without stopping at the first that is not, so that the compiler can look at several at once.
            finite &= x.is_finite() & x_low.is_finite() & v.is_finite() & v_low.is_finite();
        }
        Ok(finite)
    }

    /// Rates of the carriers' coordinates at the speeds of x, without wrenches; those of nodes are not written.
    fn turn(&mut self, t: S, x: &[S], x_dot: &mut [S]) -> Result<(), Fault> {
        let island = &mut self.island;
        if island.carrier.n_q() > 0 {
            island.memory.wrenches.iter_mut().for_each(|wrench| *wrench = Wrench::zero());
            island.carrier_rates(t, x, x_dot)?;
        }
        Ok(())
    }

    /// Rates of the coordinates at the speeds of x: of the carriers without wrenches, and of the nodes.
    pub(super) fn coast(&mut self, t: S, x: &[S], x_dot: &mut [S]) -> Result<(), Fault> {
        self.island.memory.wrenches.iter_mut().for_each(|wrench| *wrench = Wrench::zero());
        self.island.coordinate_rates(t, x, x_dot).map(|_| ())
    }

    /// Puts coordinates back on the constraints and checks the new state; `before` is memory.
    pub(super) fn project(&mut self, t: S, [new, low, before]: [&mut [S]; 3]) -> Result<(), Fault> {
        self.project_carriers(t, [&mut *new, &mut *low, before])?;
        if is_finite(new) & is_finite(low) { Ok(()) } else { Err(Fault::NonFinite) }
    }

    /// The same without the check.
    fn project_carriers(&mut self, t: S, [new, low, before]: [&mut [S]; 3]) -> Result<(), Fault> {
        let island = &mut self.island;
        island.set_time(t);
        for _ in 0..island.projections().min(2) {
            let (kept, now) = (island.parts_mut(before)?, island.parts(new)?);
            for (kept, now) in [(kept.q, now.q), (kept.u, now.u)] {
                kept.iter_mut().zip(now).for_each(|(to, from)| *to = *from);
            }
            island.project(new)?;
            // A coordinate that was moved has lost its rounding error.
            let (kept, now, low) = (island.parts(before)?, island.parts(new)?, island.parts_mut(low)?);
            for (low, kept, now) in [(low.q, kept.q, now.q), (low.u, kept.u, now.u)] {
                for ((low, kept), now) in low.iter_mut().zip(kept).zip(now) {
                    *low = if *kept == *now { *low } else { S::ZERO };
                }
            }
        }
        Ok(())
    }

    /// Rates of the nodes' velocities; returns the accounts of dampers and air at the free nodes.
    fn accelerate(&self, h: S, dot: &mut [S]) -> Result<Accounts<S>, Fault> {
        let (half, air_drag) = (S::from_f64(0.5), self.island.body.air_drag);
        let mut accounts = Accounts::empty();
        self.island.accelerate_nodes(dot, |node| {
            let velocity = vec3::scale(vec3::add(node.velocity, node.after(h)), half);
            take(&mut accounts, h, (node.viscous, air_drag), velocity);
        })?;
        Ok(accounts)
    }
}

fn is_finite<S: Scalar>(list: &[S]) -> bool {
    list.iter().fold(true, |finite, value| finite & value.is_finite())
}

/// The pivot's magnitude if the equations could be solved.
fn checked<S: Scalar>(pivot: S) -> Result<S, Fault> {
    let pivot = pivot.abs();
    match pivot.is_finite() {
        false => Err(Fault::NonFinite),
        true if pivot < pivot_limit() => Err(Fault::Singular),
        true => Ok(pivot),
    }
}
