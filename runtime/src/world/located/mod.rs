//! The step of a world with contacts located in time: methods keep their order through contact.
//!
//! In: state [q, x; u, v] at t, a method, a law of impact for each pair. Out: the state at t + h, accounts.
//! ```text
//! strike      if a touching contact approaches: impact of all touching contacts (`impact`)
//! hold        lasting contacts press or release, stick or slip, by their forces at the start of the step
//! advance     the method's step of the equations under these contacts (`pressed`)
//! shorten     to the first new touch, to where a normal force would pull, slip stops, sticking ends, or a lasting
//!             contact passes to another face
//! ```
//! Repeated until h is used up. A step is split at most [`SPLITS`] times; the rest is stepped in [`PIECES`] pieces with
//! e = 0 and without locating events, as in `step`, and the report says so: use that step for many contacts. The same
//! where an implicit method's iteration does not converge, because friction turns round however short the piece, and
//! where contact forces are not found or do not exist, because friction jams: the impulses of `step` always do. Gaps
//! and speeds that count as zero follow from the sizes and speeds present.

mod hold;
mod shorten;
mod strike;

use super::accounts::Accounts;
use super::carrier::{Carrier, Wrench};
use super::detect::{Touch, keep_only};
use super::island::{Cut, Island};
use super::observer::Observer;
use super::pressed::{Pressed, Pressing};
use super::step::Course;
use super::whole::{StepMemory, World};
use crate::mechanism::Fault;
use crate::ode::{Method, Ode, State, trial::split};
use crate::real::Scalar;
use crate::rigid::law::Kind;
use crate::rigid::scene::{PIECES, SPLITS};
use crate::rigid::struck::Struck;
use crate::vec3;

/// How far a lasting contact may move away from where it was detected in a step, relative to the world's size.
const DRIFT: f64 = 0.01;
/// Acceleration (m/s^2) from which the speed that counts as zero follows: of the order of gravity.
const USUAL: f64 = 10.0;

/// Working memory of a step with located contacts.
#[derive(Debug)]
pub struct LocatedMemory<'a, S> {
    /// Memory of the step without location, for the rest of a step that has used up its splits.
    pub step: StepMemory<'a, S>,
    /// [`LocatedMemory::scratch`] numbers.
    pub scratch: &'a mut [S],
    /// Lasting contacts: room for as many as there may be touches.
    pub pressing: &'a mut [Pressing<S>],
    /// Two lists of contacts of an impact.
    pub struck: [&'a mut [Struck<S>]; 2],
    /// By pair: whether a step that used up its splits has left overlaps. False at the start; kept from step to step.
    pub overlaps: &'a mut [bool],
    /// By pair: whether it pressed at the end of the last step. False at the start; kept from step to step. Only what
    /// has pressed may be off a facet and still touch it, because it slides on a smooth surface through the nodes.
    pub pressed: &'a mut [bool],
}

/// Diagnostics of a step.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LocatedReport<S> {
    /// Number of impacts.
    pub impacts: usize,
    /// Pieces the step was split into.
    pub pieces: usize,
    /// Contacts that push at the end.
    pub pressing: usize,
    /// Whether splits were used up, an implicit method did not converge or contact forces were not found: the rest of
    /// the step then went without location, with e = 0.
    pub forced: bool,
    /// Whether every impact converged to rounding; the rest of one that did not ended as with e = 0.
    pub settled: bool,
    /// Energy accounts of this step.
    pub accounts: Accounts<S>,
}

/// Tolerances: lengths and speeds that count as zero.
#[derive(Clone, Copy)]
struct Rounding<S> {
    /// Gap (m).
    gap: S,
    /// How far a point may come in a step (m).
    way: S,
    /// How far a lasting contact may be from where it was detected (m).
    drift: S,
    /// Speed (m/s).
    rate: S,
    /// Normal speed of a lasting contact (m/s): the same, or more where contacts have just come to rest.
    still: S,
}

/// Parts of a step beside its equations: the state so far, the trial state, the method's memory.
struct Sight<'p, S> {
    now: [&'p mut [S]; 2],
    trial: [&'p mut [S]; 2],
    room: &'p mut [S],
}

/// A step in progress: the state so far, and working memory.
struct PartialStep<'w, 'm, S> {
    /// State so far with its rounding errors; the same for the trial state.
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
    /// By pair: whether it overlaps by more than rounding.
    overlaps: &'w mut [bool],
    /// By pair: whether it has pressed in the last piece.
    pressed: &'w mut [bool],
    /// Number of contacts at the start of the piece, and how many of them push.
    known: usize,
    held: usize,
    /// Step size (s).
    h: S,
    rounding: Rounding<S>,
}

impl<'m, S: Scalar> LocatedMemory<'m, S> {
    /// Numbers of scratch memory for a state of `n` entries.
    #[must_use]
    pub const fn scratch(method: Method, n: usize) -> usize {
        10 * n + method.scratch(n)
    }

    /// The same memory, arranged for a step of h from a state.
    fn way<'w>(&'w mut self, h: S, state: &State<'_, S>) -> Result<PartialStep<'w, 'm, S>, Fault> {
        let n = state.x().len();
        let (rows, room) = self.scratch.split_at_mut_checked(10 * n).ok_or(Fault::Shape)?;
        let [a, b, c, d, e, f, g, i, j, k] = split(rows, n)?;
        a.iter_mut().zip(state.x()).for_each(|(to, from)| *to = *from);
        b.iter_mut().zip(state.low()).for_each(|(to, from)| *to = *from);
        let [struck, lifts] = &mut self.struck;
        Ok(PartialStep {
            now: [a, b],
            trial: [c, d],
            dots: [e, f, g],
            spare: [i, j, k],
            room,
            memory: &mut self.step,
            pressing: self.pressing,
            struck: [struck, lifts],
            overlaps: &mut *self.overlaps,
            pressed: &mut *self.pressed,
            known: 0,
            held: 0,
            h,
            rounding: Rounding { gap: S::ZERO, way: S::ZERO, drift: S::ZERO, rate: S::ZERO, still: S::ZERO },
        })
    }
}

impl<'m, S: Scalar> PartialStep<'_, 'm, S> {
    /// The equations under the contacts that push, and beside them the states and the method's memory.
    fn pressed<'p, 'a, C>(
        &'p mut self,
        world: &'p mut World<'a, S, C>,
    ) -> (Pressed<'p, 'a, 'm, S, C>, Sight<'p, S>) {
        let ([x, low], [from, from_low], [a, b, c]) = (&mut self.trial, &mut self.now, &mut self.spare);
        let pressed = Pressed {
            world,
            memory: &mut *self.memory,
            list: self.pressing.get_mut(..self.held).unwrap_or_default(),
            spare: [a, b, c],
            h: self.h,
            rounding: [self.rounding.drift, self.rounding.rate],
            t: S::ZERO,
        };
        (pressed, Sight { now: [from, from_low], trial: [x, low], room: self.room })
    }

    /// Does a contact that pushes slide against friction?
    fn rubs(&self) -> bool {
        let list = self.pressing.get(..self.held).unwrap_or_default();
        list.iter().any(|own| own.slip.is_some() && own.held.contact.friction > S::ZERO)
    }

    /// Keeps which pairs press at the end of a piece.
    fn note_pressed(&mut self) {
        self.pressed.fill(false);
        for own in self.pressing.iter().take(self.held).filter(|own| own.held.contact.impulse[0] > S::ZERO) {
            if let Some(pressed) = self.pressed.get_mut(own.pair) {
                *pressed = true;
            }
        }
    }

    /// The contacts at the start of the piece.
    fn touches(&self) -> &[Touch<S>] {
        self.memory.touches[0].get(..self.known).unwrap_or_default()
    }
}

impl<S: Scalar, C: Carrier<S>> World<'_, S, C> {
    /// Advances the state from t by h (s), > 0. `kinds` has the law of each pair (e and mu are the pair's own; for
    /// compensation e is the square root of its share); that of a pair with a force law is not read.
    ///
    /// # Errors
    /// Those of [`World::step`]; [`Fault::Shape`] if `kinds` or `pressed` has not one entry per pair; the method's faults. The state
    /// is then unchanged.
    pub fn step_located(
        &mut self,
        kinds: &[Kind],
        method: Method,
        (t, h): (S, S),
        state: &mut State<'_, S>,
        memory: &mut LocatedMemory<'_, S>,
        watch: &mut impl Observer<S>,
    ) -> Result<LocatedReport<S>, Fault> {
        self.check(h)?;
        let n_pairs = self.pairs.len();
        if state.x().len() != self.island.n_x() || kinds.len() != n_pairs || memory.pressed.len() != n_pairs {
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
        let (mut left, mut length) = (h, S::ZERO);
        for _ in 0..SPLITS {
            let start = t + (h - left);
            self.measure(start, way)?;
            let struck = self.strike(kinds, (start, length), way, &mut report, (h - left, watch))?;
            // An impact changes slips at once: none of them has come to rest slowly.
            if !struck {
                self.stop(start, way)?;
            }
            let (gone, works) = match self.piece(method, (start, left), way, watch) {
                Err(Fault::Jammed | Fault::Unbalanced) => break,
                // Next to a jam forces grow beyond bounds.
                Err(Fault::Unsettled | Fault::NonFinite) if way.rubs() => break,
                done => done?,
            };
            (length, report.accounts) = (gone, report.accounts.plus(&works));
            for (now, trial) in way.now.iter_mut().zip(&way.trial) {
                now.iter_mut().zip(trial.iter()).for_each(|(to, from)| *to = *from);
            }
            way.note_pressed();
            (report.pieces, report.pressing) = (report.pieces + 1, way.held);
            left = if length < left { left - length } else { S::ZERO };
            if left <= S::ZERO {
                break;
            }
        }
        if left > S::ZERO {
            (report.forced, report.pressing) = (true, 0);
            way.overlaps.fill(true);
            way.pressed.fill(false);
            way.memory.counts = [0; 2];
            let rest = self.finish((t + (h - left), left), way, watch)?;
            report.accounts = report.accounts.plus(&rest);
        }
        for ((x, low), (now, now_low)) in state.entries().zip(way.now[0].iter().zip(way.now[1].iter())) {
            (*x, *low) = (*now, *now_low);
        }
        Ok(report)
    }

    /// Advances over all the time left or to the first event, into the trial state; returns how far, and the accounts.
    fn piece(
        &mut self,
        method: Method,
        (start, left): (S, S),
        way: &mut PartialStep<S>,
        watch: &mut impl Observer<S>,
    ) -> Result<(S, Accounts<S>), Fault> {
        self.hold_at_start(start, way)?;
        let length = self.shorten(method, (start, left), way)?;
        Ok((length, self.works((start, length), way, watch)?))
    }

    /// The rest of a step that has used up its splits: as in `step`, with e = 0.
    fn finish(
        &mut self,
        (t, left): (S, S),
        way: &mut PartialStep<S>,
        watch: &mut impl Observer<S>,
    ) -> Result<Accounts<S>, Fault> {
        let piece = left / S::from_f64(f64::from(PIECES));
        let mut accounts = Accounts::empty();
        for k in 0..PIECES {
            let at = |part: f64| t + S::from_f64(f64::from(k) + part) * piece;
            let course = Course { times: [at(0.0), at(0.5), at(1.0)], rebounds: false };
            let [x, low] = &mut way.now;
            way.trial[0].iter_mut().zip(x.iter()).for_each(|(to, from)| *to = *from);
            let state = &mut State::resume(x, low)?;
            accounts = accounts.plus(&self.step_at((&course, piece), state, way.memory, watch)?.accounts);
            accounts = accounts.plus(&self.own_works((at(0.5), piece), way, watch)?);
        }
        Ok(accounts)
    }

    /// Works of the carriers' drives and dampers over a piece at whose start the trial state stands, by their powers
    /// half-way but for those against wrenches, which the step has counted.
    fn own_works(
        &mut self,
        (t, piece): (S, S),
        way: &mut PartialStep<S>,
        watch: &mut impl Observer<S>,
    ) -> Result<Accounts<S>, Fault> {
        let ([middle, _], [end, _], half) = (&mut way.trial, &way.now, S::from_f64(0.5));
        middle.iter_mut().zip(end.iter()).for_each(|(x, end)| *x = half * (*x + *end));
        let Cut { q, u, .. } = self.island.parts(middle)?;
        let Island { carrier, memory: own, .. } = &mut self.island;
        own.wrenches.iter_mut().for_each(|wrench| *wrench = Wrench::zero());
        let mut accounts = Accounts::empty();
        carrier.powers(t, [q, u], (own.frames, own.wrenches), &mut |member, powers| {
            let works = powers.map(|power| piece * power);
            (accounts.drive, accounts.damping) = (accounts.drive + works[0], accounts.damping + works[1]);
            watch.carried(member, works);
        })?;
        Ok(accounts)
    }

    /// The number of contacts that press at a state, in whose steps of h they are; their forces there are then those of
    /// `memory.pressing`, where a step leaves those of its middle. A contact that is about to strike does not press,
    /// nor does any where no forces are found.
    ///
    /// # Errors
    /// As [`World::step_located`]; no contact presses then.
    pub fn press_located(
        &mut self,
        (t, h): (S, S),
        state: &State<'_, S>,
        memory: &mut LocatedMemory<'_, S>,
    ) -> Result<usize, Fault> {
        if state.x().len() != self.island.n_x() {
            return Err(Fault::Shape);
        }
        let way = &mut memory.way(h, state)?;
        self.measure(t, way)?;
        self.find_touches(t, way)?;
        match self.hold_at_start(t, way) {
            Err(Fault::Jammed | Fault::Unbalanced) => Ok(0),
            done => done.map(|()| way.held),
        }
    }

    /// Sets the tolerances from sizes and speeds at the state so far.
    fn measure(&mut self, t: S, way: &mut PartialStep<S>) -> Result<(), Fault> {
        self.island.place(t, way.now[0])?;
        let StepMemory { twists: [_, twists, _], .. } = &mut *way.memory;
        Pressed::read_twists(self, twists);
        let own = &self.island.memory;
        let origins = own.frames.iter().map(|frame| frame.origin);
        let reach = self.reach_of_ports(S::ZERO);
        let farthest = origins.chain(own.pos.iter().copied()).fold(S::ZERO, |m, x| m.max(vec3::norm(x)));
        let size = self.largest() + farthest;
        let speed = twists.iter().fold(S::ZERO, |most, twist| {
            most.max(vec3::norm(twist.velocity) + reach * vec3::norm(twist.angular))
        });
        // The speed whose bounce is as high as the rounding of lengths. For gaps epsilon^(2/3), between the rounding
        // unit and 1.
        let lowest = S::from_f64(4.0) * (S::EPSILON * S::from_f64(USUAL) * size).sqrt();
        let rate = lowest + S::from_f64(64.0) * S::EPSILON * speed;
        way.rounding = Rounding {
            gap: (S::from_f64(2.0 / 3.0) * S::EPSILON.ln()).exp() * size,
            way: S::from_f64(2.0) * way.h * speed,
            drift: S::from_f64(DRIFT) * size,
            rate,
            still: rate,
        };
        Ok(())
    }

    /// Detects contacts at the state so far, with their velocities.
    fn find_touches(&mut self, t: S, way: &mut PartialStep<S>) -> Result<(), Fault> {
        self.island.place(t, way.now[0])?;
        let StepMemory { twists: [_, twists, _], normals, extents, touches: [now, _], counts, .. } =
            &mut *way.memory;
        Pressed::read_twists(self, twists);
        let found = self.detect((way.rounding.gap, true), normals, extents, now)?;
        let found = now.get_mut(..found).unwrap_or_default();
        let scenery = self.scenery(normals, way.rounding.gap, true);
        let count = keep_only(found, 0, |_, touch, _| {
            touch.start = touch.contact.relative(twists);
            let rides = way.pressed.get(touch.pair).is_some_and(|own| *own);
            let near = touch.gap <= way.rounding.gap || rides && touch.start[0].abs() <= way.rounding.still;
            near && !scenery.is_outside(self.pairs, touch, (way.h, way.rounding.way))
        });
        (counts[0], way.known) = (count, count);
        Ok(())
    }
}
