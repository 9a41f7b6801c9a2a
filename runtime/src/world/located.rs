//! The step of a world with touches located in time: methods keep their order through contact.
//!
//! In: state [q, x; u, v] at t, a method, a law of impact for each pair. Out: the state at t + h, accounts.
//! ```text
//! strike      if some of what touches closes: impact of all that touches (`impact`)
//! hold        contacts that last: they press or let go, hold or slide, by their forces at the start of the way
//! advance     the method's step of the equations under these contacts (`pressed`)
//! shorten     to the first new touch, to where a force would pull, a slip stops, or friction no longer holds
//! ```
//! and again until h is gone. A step is split at most [`SPLITS`] times; the rest goes without locating anything, as in `step`,
//! and the report says so: many contacts are for that step. Gaps and speeds of rounding follow from sizes and speeds at hand.

use super::accounts::Accounts;
use super::carrier::Carrier;
use super::detect::{AT_NODE, Touch};
use super::impact::{Setting, Spare};
use super::pressed::{Pressed, Pressing};
use super::step::{StepMemory, World};
use crate::mechanism::Fault;
use crate::ode::root::locate;
use crate::ode::{Method, Ode, State};
use crate::real::Scalar;
use crate::rigid::contact::Twist;
use crate::rigid::hold::hold;
use crate::rigid::law::Kind;
use crate::rigid::several::Struck;
use crate::vec3;

/// Splits of one step at most.
pub const SPLITS: usize = 64;
/// Half the way of the differences as a part of the step: errors of rounding and of curvature are alike.
const SPAN: f64 = 1e-4;
/// How far a contact that lasts may drift off in a step, as a part of the world's size.
const DRIFT: f64 = 0.01;
/// Forces below this share of the largest one count as none.
const LIGHT: f64 = 1e-9;
/// A slip that turns back with less than this share of its speed has come to rest.
const SLOW: f64 = 0.1;
/// Acceleration (m/s^2) at which speeds are those of rounding: of the order of gravity's.
const USUAL: f64 = 10.0;

/// Working memory of a step with located touches.
#[derive(Debug)]
pub struct LocatedMemory<'a, S> {
    /// That of a step without locating, for the rest of a step that has used up its splits.
    pub step: StepMemory<'a, S>,
    /// [`LocatedMemory::scratch`] numbers.
    pub scratch: &'a mut [S],
    /// Contacts that last: as many as there may be touches.
    pub pressing: &'a mut [Pressing<S>],
    /// Contacts of an impact, twice.
    pub struck: [&'a mut [Struck<S>]; 2],
}

/// An impact within a step, shown while it happens.
#[derive(Clone, Copy, Debug)]
pub struct Strike<'a, S> {
    /// Time since the start of the step (s).
    pub time: S,
    /// What touched, with the velocities before.
    pub touches: &'a [Touch<S>],
    /// The same with their impulses.
    pub struck: &'a [Struck<S>],
}

/// What a step did.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LocatedReport<S> {
    /// Impacts.
    pub impacts: usize,
    /// Pieces the step was split into.
    pub pieces: usize,
    /// Contacts that press at the end.
    pub pressing: usize,
    /// Splits were used up: the rest of the step went without locating, with e = 0.
    pub forced: bool,
    /// Was every impact found to rounding? What is left ends as by e = 0.
    pub settled: bool,
    /// Energy by its ways in this step.
    pub accounts: Accounts<S>,
}

/// What counts as nothing.
#[derive(Clone, Copy)]
struct Rounding<S> {
    /// Length (m).
    gap: S,
    /// How far a contact that lasts may be from where it was found (m).
    drift: S,
    /// Speed (m/s).
    rate: S,
}

/// A step under way: where it has come to, and the memory it works with.
struct Way<'w, 'm, S> {
    /// State so far and what rounding left out; the same on trial.
    now: [&'w mut [S]; 2],
    trial: [&'w mut [S]; 2],
    /// Rates at the start, the end and in between.
    dots: [&'w mut [S]; 3],
    spare: [&'w mut [S]; 3],
    /// The method's memory.
    room: &'w mut [S],
    memory: &'w mut StepMemory<'m, S>,
    pressing: &'w mut [Pressing<S>],
    struck: [&'w mut [Struck<S>]; 2],
    /// How many touch at the start of the piece, and how many of them press.
    known: usize,
    held: usize,
    span: S,
    rounding: Rounding<S>,
}

impl<'m, S: Scalar> LocatedMemory<'m, S> {
    /// Numbers of scratch memory for a state of `n` entries.
    #[must_use]
    pub const fn scratch(method: Method, n: usize) -> usize {
        10 * n + method.scratch(n)
    }

    /// The same, ordered for a step of h from a state.
    fn way<'w>(&'w mut self, h: S, state: &State<'_, S>) -> Result<Way<'w, 'm, S>, Fault> {
        let n = state.x().len();
        let (rows, room) = self.scratch.split_at_mut_checked(10 * n).ok_or(Fault::Shape)?;
        let mut rows = rows.chunks_exact_mut(n.max(1));
        let [Some(a), Some(b), Some(c), Some(d), Some(e), Some(f), Some(g), Some(i), Some(j), Some(k)] =
            core::array::from_fn(|_| rows.next())
        else {
            return Err(Fault::Shape);
        };
        a.iter_mut().zip(state.x()).for_each(|(to, from)| *to = *from);
        b.iter_mut().zip(state.low()).for_each(|(to, from)| *to = *from);
        let [struck, lifts] = &mut self.struck;
        Ok(Way {
            now: [a, b],
            trial: [c, d],
            dots: [e, f, g],
            spare: [i, j, k],
            room,
            memory: &mut self.step,
            pressing: self.pressing,
            struck: [struck, lifts],
            known: 0,
            held: 0,
            span: S::from_f64(SPAN) * h,
            rounding: Rounding { gap: S::ZERO, drift: S::ZERO, rate: S::ZERO },
        })
    }
}

impl<'m, S: Scalar> Way<'_, 'm, S> {
    /// The equations under the contacts that press; the states on trial and the method's memory beside them.
    fn pressed<'p, 'a, C>(
        &'p mut self,
        world: &'p mut World<'a, S, C>,
    ) -> (Pressed<'p, 'a, 'm, S, C>, [&'p mut [S]; 2], [&'p mut [S]; 2], &'p mut [S]) {
        let ([x, low], [from, from_low], [a, b, c]) = (&mut self.trial, &mut self.now, &mut self.spare);
        let pressed = Pressed {
            world,
            memory: &mut *self.memory,
            list: self.pressing.get_mut(..self.held).unwrap_or_default(),
            spare: [a, b, c],
            span: self.span,
            rounding: [self.rounding.drift, self.rounding.rate],
            t: S::ZERO,
        };
        (pressed, [x, low], [from, from_low], self.room)
    }

    /// What touches at the start of the piece.
    fn touches(&self) -> &[Touch<S>] {
        self.memory.touches[0].get(..self.known).unwrap_or_default()
    }
}

impl<S: Scalar, C: Carrier<S>> World<'_, S, C> {
    /// Advances the state from t by h (s), > 0; `kinds` has the law of each pair (e and mu are the pair's own, e of compensation
    /// the root of its share), `watch` sees every impact, those of a step refused in the end too.
    ///
    /// # Errors
    /// [`Fault::TooManyContacts`], [`Fault::Jammed`] where friction jams what slides; [`Fault::Shape`] for lists of wrong length;
    /// the method's faults. The state is then unchanged.
    pub fn step_located(
        &mut self,
        kinds: &[Kind],
        method: Method,
        (t, h): (S, S),
        state: &mut State<'_, S>,
        memory: &mut LocatedMemory<'_, S>,
        mut watch: impl FnMut(Strike<'_, S>),
    ) -> Result<LocatedReport<S>, Fault> {
        if state.x().len() != self.island.n_x() || state.x().is_empty() || kinds.len() != self.pairs.len() {
            return Err(Fault::Shape);
        }
        let mut report = LocatedReport {
            impacts: 0,
            pieces: 0,
            pressing: 0,
            forced: false,
            settled: true,
            accounts: Accounts::empty(),
        };
        let way = &mut memory.way(h, state)?;
        let mut left = h;
        for _ in 0..SPLITS {
            let start = t + (h - left);
            self.measure(start, way)?;
            self.strike(kinds, start, way, &mut report, |touches, struck| {
                watch(Strike { time: h - left, touches, struck });
            })?;
            self.hold_at_start(start, way)?;
            let length = self.shorten(method, (start, left), way)?;
            report.accounts = report.accounts.plus(&self.works(start, length, way)?);
            for (now, trial) in way.now.iter_mut().zip(&way.trial) {
                now.iter_mut().zip(trial.iter()).for_each(|(to, from)| *to = *from);
            }
            (report.pieces, report.pressing) = (report.pieces + 1, way.held);
            left = if length < left { left - length } else { S::ZERO };
            if left <= S::ZERO {
                break;
            }
        }
        if left > S::ZERO {
            report.forced = true;
            let [x, low] = &mut way.now;
            way.memory.counts = [0; 2];
            let rest = self.step(t + (h - left), left, &mut State::resume(x, low)?, way.memory)?;
            report.accounts = report.accounts.plus(&rest.accounts);
        }
        for ((x, low), (now, now_low)) in state.entries().zip(way.now[0].iter().zip(way.now[1].iter())) {
            (*x, *low) = (*now, *now_low);
        }
        Ok(report)
    }

    /// What counts as nothing, by sizes and speeds at the state so far.
    fn measure(&mut self, t: S, way: &mut Way<S>) -> Result<(), Fault> {
        self.island.place(t, way.now[0])?;
        let StepMemory { twists: [_, twists, _], .. } = &mut *way.memory;
        Pressed::read_twists(self, twists);
        let own = &self.island.memory;
        let origins = own.frames.iter().map(|frame| frame.origin);
        let reach = self.largest();
        let farthest = origins.chain(own.pos.iter().copied()).fold(S::ZERO, |m, x| m.max(vec3::norm(x)));
        let size = reach + farthest;
        let speed = twists.iter().fold(S::ZERO, |most, twist| {
            most.max(vec3::norm(twist.velocity) + reach * vec3::norm(twist.angular))
        });
        // A speed whose bounce is as high as lengths are rounded; epsilon^(2/3): halfway to nothing.
        let lowest = S::from_f64(4.0) * (S::EPSILON * S::from_f64(USUAL) * size).sqrt();
        way.rounding = Rounding {
            gap: (S::from_f64(2.0 / 3.0) * S::EPSILON.ln()).exp() * size,
            drift: S::from_f64(DRIFT) * size,
            rate: lowest + S::from_f64(64.0) * S::EPSILON * speed,
        };
        Ok(())
    }

    /// Finds what touches at the state so far, with its velocity.
    fn find_touches(&mut self, t: S, way: &mut Way<S>) -> Result<(), Fault> {
        self.island.place(t, way.now[0])?;
        let StepMemory { twists: [_, twists, _], normals, touches: [now, _], counts, .. } = &mut *way.memory;
        self.turn_normals(normals);
        Pressed::read_twists(self, twists);
        let count = self.scenery(normals, way.rounding.gap, S::from_f64(AT_NODE)).find(self.pairs, now)?;
        for touch in now.iter_mut().take(count) {
            touch.start = touch.contact.relative(twists);
        }
        (counts[0], way.known) = (count, count);
        Ok(())
    }

    /// Impact of all that touches, if some of it closes.
    fn strike(
        &mut self,
        kinds: &[Kind],
        t: S,
        way: &mut Way<S>,
        report: &mut LocatedReport<S>,
        show: impl FnOnce(&[Touch<S>], &[Struck<S>]),
    ) -> Result<(), Fault> {
        self.find_touches(t, way)?;
        if !way.touches().iter().any(|touch| touch.start[0] < -way.rounding.rate) {
            return Ok(());
        }
        let before = self.island.energy(t, way.now[0])?.total();
        let StepMemory { twists: [one, twists, other], inertias, touches: [touches, _], .. } =
            &mut *way.memory;
        let touches = touches.get(..way.known).unwrap_or_default();
        let [struck, lifts] = &mut way.struck;
        let struck = struck.get_mut(..touches.len()).ok_or(Fault::TooManyContacts)?;
        let touched = |port: usize| touches.iter().any(|own| own.contact.touches_body(port));
        self.island.ask_yields(t, way.now[0], inertias, touched)?;
        for (s, touch) in struck.iter_mut().zip(touches) {
            *s = Struck::new(touch.contact, inertias);
        }
        let law_of = |touch: &Touch<S>| Some((*kinds.get(touch.pair)?, touch.contact.restitution));
        let law =
            touches.first().and_then(law_of).filter(|law| touches.iter().all(|t| law_of(t) == Some(*law)));
        let island = &self.island;
        let ports = island.memory.frames.len();
        let setting = Setting { body: &island.body, pos: island.memory.pos, ports, inertia: &*inertias };
        let settled = setting.strike(struck, law, twists, &mut Spare { lifts, twists: [one, other] });
        report.settled &= settled;
        show(touches, struck);
        let [x, low] = &mut way.now;
        let [a, b, c] = &mut way.spare;
        let contacts = struck.iter().map(|s| (&s.contact, s.contact.impulse));
        self.island.load_impulses(contacts);
        self.island.set_speeds(x, twists)?;
        self.island.push_carrier(t, x, [&mut **a, &mut **b, &mut **c], false)?;
        if self.island.projections() > 0 {
            self.island.set_time(t);
            self.island.project(x)?;
        }
        let n_q = self.island.n_q();
        low.iter_mut().skip(n_q).for_each(|low| *low = S::ZERO);
        let after = self.island.energy(t, x)?.total();
        report.impacts += 1;
        report.accounts.impact = report.accounts.impact + (before - after);
        self.find_touches(t, way)
    }

    /// Puts to rest what has slid and turned back: towards the end of a slip its direction is known less and less, and what is
    /// left of it is the method's error.
    fn stop(&mut self, t: S, way: &mut Way<S>) -> Result<(), Fault> {
        let touches = way.memory.touches[0].get(..way.known).unwrap_or_default();
        let list = way.pressing.get_mut(..way.held).unwrap_or_default();
        let mut stopped = 0;
        for k in 0..list.len() {
            let Some(own) = list.get_mut(k) else { continue };
            let Some(first) = own.slip.filter(|_| own.held.contact.friction > S::ZERO) else { continue };
            let same = |touch: &&Touch<S>| touch.pair == own.pair && touch.id == own.id;
            let Some(touch) = touches.iter().find(same) else { continue };
            let slip = touch.contact.to_inertial([S::ZERO, touch.start[1], touch.start[2]]);
            if vec3::dot(slip, first) <= S::ZERO && vec3::norm(slip) <= S::from_f64(SLOW) * own.speed {
                (own.slip, own.held.contact) = (None, touch.contact);
                list.swap(stopped, k);
                stopped += 1;
            }
        }
        way.held = stopped;
        if stopped == 0 {
            return Ok(());
        }
        let (mut pressed, _, [x, _], _) = way.pressed(self);
        pressed.set_time(t);
        pressed.project(x)?;
        self.find_touches(t, way)
    }

    /// Which contacts press from here on, and how each goes.
    fn hold_at_start(&mut self, t: S, way: &mut Way<S>) -> Result<(), Fault> {
        self.stop(t, way)?;
        let rate = way.rounding.rate;
        way.held = 0;
        for touch in way.memory.touches[0].iter().take(way.known).filter(|touch| touch.start[0].abs() <= rate)
        {
            let own = way.pressing.get_mut(way.held).ok_or(Fault::TooManyContacts)?;
            *own = Pressing { pair: touch.pair, id: touch.id, ..Pressing::empty() };
            own.held.contact = touch.contact;
            let [_, x, y] = touch.start;
            own.velocity = touch.contact.to_inertial([S::ZERO, x, y]);
            own.speed = vec3::norm(own.velocity);
            let ([_, x, y], speed) = vec3::direction([S::ZERO, x, y]);
            let smooth = touch.contact.friction <= S::ZERO;
            own.slip = match (smooth, speed > rate) {
                (true, _) => Some(vec3::zero()),
                (false, true) => Some(touch.contact.to_inertial([S::ZERO, x, y])),
                (false, false) => None,
            };
            way.held += 1;
        }
        if way.held == 0 {
            return Ok(());
        }
        let dot = core::mem::take(&mut way.dots[0]);
        let (mut pressed, _, [x, _], _) = way.pressed(self);
        let prepared = pressed.prepare(t, x, dot);
        way.dots[0] = dot;
        prepared?;
        let StepMemory { twists: [gained, ..], inertias, .. } = &mut *way.memory;
        gained.fill(Twist::zero());
        let list = way.pressing.get_mut(..way.held).unwrap_or_default();
        if !hold(list, &*inertias, gained) {
            return Err(Fault::Jammed);
        }
        let largest = list.iter().fold(S::ZERO, |most, own| most.max(own.held.contact.impulse[0]));
        let mut held = 0;
        for k in 0..list.len() {
            let Some(own) = list.get_mut(k) else { continue };
            let ([n, x, y], mu) = (own.held.contact.impulse, own.held.contact.friction);
            if n <= S::from_f64(LIGHT) * largest {
                continue;
            }
            // On the rim friction holds no longer: it starts to slide the other way.
            let ([_, x, y], rub) = vec3::direction([S::ZERO, x, y]);
            if own.slip.is_none() && rub >= mu * n * (S::ONE - S::from_f64(LIGHT)) {
                own.slip = Some(own.held.contact.to_inertial([S::ZERO, -x, -y]));
            }
            list.swap(held, k);
            held += 1;
        }
        way.held = held;
        Ok(())
    }

    /// Goes a length from the state so far into that on trial.
    fn advance(&mut self, method: Method, (t, length): (S, S), way: &mut Way<S>) -> Result<(), Fault> {
        let (mut pressed, [x, low], [from, from_low], room) = way.pressed(self);
        x.iter_mut().zip(from.iter()).for_each(|(to, from)| *to = *from);
        low.iter_mut().zip(from_low.iter()).for_each(|(to, from)| *to = *from);
        method.step(&mut pressed, t, length, &mut State::resume(x, low)?, room).map(|_| ())
    }

    /// Goes all that is left, or to the first event: how far.
    fn shorten(&mut self, method: Method, (t, left): (S, S), way: &mut Way<S>) -> Result<S, Fault> {
        self.advance(method, (t, left), way)?;
        if self.clearance(t + left, way)? >= S::ZERO {
            return Ok(left);
        }
        let mut fault = None;
        let guard = |length: S| {
            // At the start nothing new touches, pulls or has turned back.
            if length <= S::ZERO {
                return S::ZERO;
            }
            let gone = self.advance(method, (t, length), way).and_then(|()| self.clearance(t + length, way));
            gone.unwrap_or_else(|why| {
                fault = Some(why);
                S::ZERO
            })
        };
        let found = locate(guard, S::ZERO, left, S::from_f64(4.0) * S::EPSILON * left);
        if let Some(why) = fault {
            return Err(why);
        }
        // To the far side: what touches does so within rounding, what pulls has let go.
        let length = found.map_or(left, |(_, beyond)| beyond);
        self.advance(method, (t, length), way)?;
        Ok(length)
    }

    /// What is left until the first event, at the end on trial; below 0 beyond it. Each part is measured by its rounding.
    fn clearance(&mut self, t: S, way: &mut Way<S>) -> Result<S, Fault> {
        let dot = core::mem::take(&mut way.dots[1]);
        let (mut pressed, [x, _], ..) = way.pressed(self);
        let gone = pressed.rates(t, x, dot);
        way.dots[1] = dot;
        gone?;
        let list = way.pressing.get(..way.held).unwrap_or_default();
        let StepMemory { normals, touches: [known, found], .. } = &mut *way.memory;
        self.turn_normals(normals);
        let count = self.scenery(normals, way.rounding.gap, S::from_f64(AT_NODE)).find(self.pairs, found)?;
        let known = known.get(..way.known).unwrap_or_default();
        let mut clear = S::ONE;
        for touch in found.iter().take(count) {
            let same = |pair: usize, id: u32| pair == touch.pair && id == touch.id;
            if !list.iter().any(|own| same(own.pair, own.id)) {
                // What overlaps already and parts is met anew only where it goes deeper.
                let before = known.iter().find(|own| same(own.pair, own.id));
                let depth = before.map_or(S::ZERO, |own| own.gap.min(S::ZERO));
                clear = clear.min((touch.gap - depth) / way.rounding.gap + S::ONE);
            }
        }
        let force = |own: &Pressing<S>| own.held.contact.impulse;
        let largest = list.iter().fold(S::ZERO, |most, own| most.max(force(own)[0].abs()));
        let light = S::from_f64(LIGHT) * largest;
        for own in list {
            let ([n, x, y], mu) = (force(own), own.held.contact.friction);
            clear = clear.min(n / light + S::ONE);
            match own.slip {
                Some(first) if mu > S::ZERO => {
                    // Half of what counts as rest, so that what has stopped is found at rest.
                    let rest = S::from_f64(0.5) * way.rounding.rate;
                    clear = clear.min(vec3::dot(own.velocity, first) / rest + S::ONE);
                }
                Some(_) => {}
                None => clear = clear.min((mu * n - (x * x + y * y).sqrt()) / light + S::ONE),
            }
        }
        Ok(clear)
    }

    /// Energy by its ways over the piece from the state so far to that on trial: powers by Simpson's rule.
    fn works(&mut self, t: S, length: S, way: &mut Way<S>) -> Result<Accounts<S>, Fault> {
        let [first, last, between] = core::mem::take(&mut way.dots);
        let (mut pressed, [new, _], [old, _], _) = way.pressed(self);
        let sum = pressed.works((t, length), [old, new], [&mut *first, &mut *last, &mut *between]);
        way.dots = [first, last, between];
        sum
    }
}
