//! One step of a body on the ground: try, shorten to the first touch or release, apply it, go on.
//!
//! In: a system, a state, a step h, a method. Out: the state h later and a report. The observer sees
//! everything and changes nothing. Work per step is bounded and no clock lags: after its last split a step
//! ends by Moreau's law with e = 0 (`stepping`), and the report says so.
//! Invariant: on an error the state is the last good one.

mod attempt;
mod moreau;
mod slide;
mod stepping;
mod touch;

use crate::contact::compensation::{Impact, PointImpact};
use crate::contact::{ContactLaw, ContactState, Frozen, Full, Ground, Repertoire, System};
use crate::flexible::BodyError;
use crate::flexible::energy::eval_energies;
use crate::guard::Shortened;
use crate::ode::nodes::{Motion, Step, Workspace};
use crate::real::Scalar;
use crate::vec3;
use attempt::{Attempt, attempt, control_step, try_length};
use touch::{apply_law, hold_or_rebound, lift, mark_touching, place_on_surface, release, rub};

/// Events located in one step.
pub const MAX_EVENTS: usize = 64;
/// Substeps of an adaptive method within one step.
pub const MAX_SUBSTEPS: usize = 4096;

/// What advances.
#[derive(Debug)]
pub struct State<'a, S> {
    /// Positions, velocities, forces.
    pub motion: Motion<'a, S>,
    /// Each point against the ground.
    pub modes: &'a mut [ContactState],
    /// Impulses of the last impact.
    pub impacts: &'a mut [PointImpact<S>],
    /// Time (s) and what rounding dropped from it.
    pub time: [S; 2],
    /// Length with which an adaptive method goes on (s); 0 before the first step.
    pub next_step: S,
    /// Energy that an undamped body should have (J); kept only for the ledger anchor.
    pub anchor: S,
}

/// A touch or a release.
#[derive(Clone, Copy, Debug)]
pub struct Event<'a, S> {
    /// Time (s).
    pub time: S,
    /// The impact, for a touch.
    pub impact: Option<Impact<S>>,
    /// Impulses by point (of the touching ones).
    pub points: &'a [PointImpact<S>],
    /// Modes after the event.
    pub modes: &'a [ContactState],
    /// Number of points let go.
    pub released: usize,
}

/// A stretch of motion without events.
#[derive(Clone, Copy, Debug)]
pub struct Flow<'a, 'm, S> {
    /// State at its start.
    pub before: &'a Motion<'m, S>,
    /// State at its end.
    pub after: &'a Motion<'m, S>,
    /// Each point against the ground, all the way.
    pub modes: &'a [ContactState],
    /// Its length (s).
    pub tau: S,
    /// True where the speeds follow from the forces and friction alone: no impulse within.
    pub is_smooth: bool,
    /// Changes of speed that sliding friction made all along it, point by point; empty without friction.
    pub braked: &'a [vec3::Vec3<S>],
    /// Energy lost to sliding friction in it (J).
    pub friction: S,
    /// Energy lost to the impact law in it (J) (time stepping laws).
    pub impact: S,
}

/// Sees a run. The unit type looks away.
pub trait Observer<S, R = Full> {
    /// Motion without events.
    fn flow(&mut self, system: &System<S, R>, flow: Flow<S>);
    /// A touch or release.
    fn event(&mut self, system: &System<S, R>, event: Event<S>);
}

impl<S, R> Observer<S, R> for () {
    fn flow(&mut self, _: &System<S, R>, _: Flow<S>) {}
    fn event(&mut self, _: &System<S, R>, _: Event<S>) {}
}

/// Counts of one step.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default)]
pub struct StepReport {
    /// Touches and releases.
    pub events: usize,
    /// Stretches without events.
    pub substeps: usize,
    /// Steps tried to locate events, each with the method's force evaluations.
    pub trials: usize,
    /// Evaluations of all forces, those of trials included.
    pub evaluations: usize,
    /// Its end was stepped over without events: [`MAX_EVENTS`] or [`MAX_SUBSTEPS`] was reached.
    pub cut_short: bool,
}

impl<S: Scalar> State<'_, S> {
    /// Time (s).
    #[must_use]
    pub fn t(&self) -> S {
        self.time[0]
    }

    /// What the total energy has above its mean over the body's vibrations, because of the method (J).
    ///
    /// Verlet keeps m v^2/2 + V + h^2 (alpha v.V''v - (1/8 - alpha) m |a|^2) of a linear body, for every alpha;
    /// alpha = 1/16 has the total energy as its mean. A touch takes a point's acceleration away and so would
    /// lift that mean, if it left the total energy of the instant as it is.
    fn energy_swing<R: Repertoire<S>>(
        &self,
        system: &System<S, R>,
        h: S,
        method: R::Method,
        mode: impl Fn(usize) -> ContactState,
    ) -> S {
        if !method.is_verlet() {
            return S::ZERO;
        }
        let mut sum = S::ZERO;
        for (i, mass) in system.body.mass.iter().enumerate() {
            let a = system.acceleration(i, mode(i), self.motion.force(i));
            sum = sum + *mass * vec3::dot(a, a);
        }
        for spring in system.body.springs {
            let rate = spring.stretch(self.motion.pos, self.motion.vel).rate;
            sum = sum - spring.stiffness * rate * rate;
        }
        S::from_f64(1.0 / 16.0) * h * h * sum
    }

    fn pass(&mut self, tau: S) {
        let change = tau + self.time[1];
        let sum = self.time[0] + change;
        let part = sum - self.time[0];
        self.time = [sum, (self.time[0] - (sum - part)) + (change - part)];
    }

    /// Makes the state ready: forces, energy, points that lie on the ground or touch it now.
    ///
    /// # Errors
    /// A point below a ground that does not give way, an energy that is no number, or from the gas law.
    pub fn begin<R: Repertoire<S>, O: Observer<S, R>>(
        &mut self,
        system: &System<S, R>,
        h: S,
        method: R::Method,
        work: &mut Workspace<S>,
        observer: &mut O,
    ) -> Result<(), BodyError<S>> {
        self.refuse_below_ground(system)?;
        self.motion.check_finite()?;
        self.motion.refresh(&Frozen { system, modes: self.modes })?;
        work.end.viscous.as_flattened_mut().fill(S::ZERO);
        if R::ANCHOR {
            self.anchor = eval_energies(&system.body, self.motion.pos, self.motion.vel).total()
                - self.energy_swing(system, h, method, |i| self.modes.get(i).copied().unwrap_or_default());
        }
        if let Some(ground) = &system.event_ground() {
            // A point lying still on the ground takes part as one that touches with speed 0.
            for (i, mode) in self.modes.iter_mut().enumerate() {
                let on_ground = ground.gap(vec3::at(self.motion.pos, i)) <= ground.tolerance;
                let still = ground.gap_rate(vec3::at(self.motion.vel, i)) == S::ZERO;
                *mode = if on_ground && still { ContactState::Held } else { ContactState::Free };
            }
            resolve(system, ground, self, (h, method), work, observer)?;
        } else if let Some(ground) = &system.watched_ground() {
            settle_modes(system, ground, self);
        }
        Ok(())
    }

    /// A law of touches says nothing about a point that is through the surface already.
    fn refuse_below_ground<R: Repertoire<S>>(&self, system: &System<S, R>) -> Result<(), BodyError<S>> {
        let Some(ground) = system.ground.filter(Ground::is_rigid) else { return Ok(()) };
        for (point, (x, fixed)) in self.motion.pos.iter().zip(system.body.fixed).enumerate() {
            let depth = -ground.gap(*x);
            if !fixed && depth > ground.tolerance {
                return Err(BodyError::BelowGround { point, depth });
            }
        }
        Ok(())
    }
}

/// Advances by h.
///
/// # Errors
/// The state is then the last good one.
pub fn step<'a, S: Scalar, R: Repertoire<S>, O: Observer<S, R>>(
    system: &System<S, R>,
    state: &mut State<'a, S>,
    h: S,
    method: R::Method,
    work: &mut Workspace<'a, S>,
    observer: &mut O,
) -> Result<StepReport, BodyError<S>> {
    if let Some(ContactLaw::Moreau { restitution }) = system.ground.map(|g| g.law)
        && R::MOREAU
    {
        return stepping::step(system, state, h, restitution, work, observer);
    }
    let (mut report, before) = (StepReport::default(), work.evaluations);
    let mut remaining = h;
    while remaining > S::ZERO {
        let spent = report.events >= MAX_EVENTS;
        report.cut_short |= spent || report.substeps >= MAX_SUBSTEPS;
        // Ground that gives way needs no events to keep points off it: the method goes on without them.
        if report.substeps >= MAX_SUBSTEPS || spent && system.soft_ground().is_none() {
            stepping::finish(system, state, remaining, work, observer)?;
            break;
        }
        let watched = system.watched_ground().filter(|_| !spent);
        report.substeps += 1;
        let tau = try_length(state, remaining, h, method);
        let Attempt { length, error, shortened } =
            attempt(system, watched.as_ref(), state, tau, method, work)?;
        control_step(state, length, error, remaining, method);
        if error > S::ONE {
            continue;
        }
        let Shortened { tau, is_event, trials } = shortened;
        report.trials += trials;
        refuse_through_ground(system, work.end.pos)?;
        accept(system, state, tau, work, observer)?;
        remaining = remaining - tau;
        if let (true, Some(ground)) = (is_event, &watched) {
            report.events += 1;
            if !ground.is_rigid() {
                stop_creeping(system, ground, state, h);
                settle_modes(system, ground, state);
                continue;
            }
            // A method that chooses its steps leaves out bounces by their lengths, not by the caller's.
            let length = if method.control_order() == 0 { h } else { state.next_step.min(h) };
            resolve(system, ground, state, (length, method), work, observer)?;
        }
    }
    report.evaluations = work.evaluations - before;
    Ok(report)
}

/// Takes over the state in `work.end`, after sliding friction.
fn accept<'a, S: Scalar, R: Repertoire<S>, O: Observer<S, R>>(
    system: &System<S, R>,
    state: &mut State<'a, S>,
    tau: S,
    work: &mut Workspace<'a, S>,
    observer: &mut O,
) -> Result<(), BodyError<S>> {
    let lost = slide::slide(system, state, tau, work)?;
    let lifted = lift_departing(system, state.modes, work)?;
    let flow = Flow {
        before: &state.motion,
        after: &work.end,
        modes: state.modes,
        tau,
        is_smooth: !lifted,
        braked: if system.rough_ground().is_some() { work.dv } else { &[] },
        friction: lost,
        impact: S::ZERO,
    };
    observer.flow(system, flow);
    take_over(system, state, tau, work);
    state.anchor = state.anchor - lost;
    Ok(())
}

/// The state in `work.end` is the state, tau later; the two exchange their memory.
fn take_over<'a, S: Scalar, R: Repertoire<S>>(
    system: &System<S, R>,
    state: &mut State<'a, S>,
    tau: S,
    work: &mut Workspace<'a, S>,
) {
    core::mem::swap(&mut state.motion, &mut work.end);
    state.pass(tau);
    if let Some(ground) = system.watched_ground() {
        settle_modes(system, &ground, state);
    }
}

/// Massless points are put on the surface by statics; nothing keeps a point with mass off it.
fn refuse_through_ground<S: Scalar, R: Repertoire<S>>(
    system: &System<S, R>,
    pos: &[vec3::Vec3<S>],
) -> Result<(), BodyError<S>> {
    let Some(ground) = system.massless_ground() else { return Ok(()) };
    let through = |(i, x): (usize, &vec3::Vec3<S>)| {
        system.body.inverse_mass(i) > S::ZERO && ground.gap(*x) < -ground.tolerance
    };
    match pos.iter().enumerate().position(through) {
        Some(point) => Err(BodyError::ThroughGround { point }),
        None => Ok(()),
    }
}

/// Departing points that go away, yet lie below the surface by the method's error, are put on it; true if any was.
fn lift_departing<S: Scalar, R: Repertoire<S>>(
    system: &System<S, R>,
    modes: &[ContactState],
    work: &mut Workspace<S>,
) -> Result<bool, BodyError<S>> {
    let Some(ground) = system.event_ground() else { return Ok(false) };
    let mut lifted = false;
    for (i, _) in modes.iter().enumerate().filter(|(_, m)| **m == ContactState::Departing) {
        let leaves = ground.gap_rate(vec3::at(work.end.vel, i)) >= S::ZERO;
        if leaves && ground.is_deep(vec3::at(work.end.pos, i)) {
            lift(&ground, &mut work.end, i);
            lifted = true;
        }
    }
    if lifted {
        work.refresh_end(&Frozen { system, modes })?;
    }
    Ok(lifted)
}

/// Arms guards of points that are clear of the ground; sticks and unsticks the held ones.
fn settle_modes<S: Scalar, R: Repertoire<S>>(
    system: &System<S, R>,
    ground: &Ground<S>,
    state: &mut State<S>,
) {
    for (i, mode) in state.modes.iter_mut().enumerate() {
        match mode {
            ContactState::Departing if ground.gap(vec3::at(state.motion.pos, i)) > ground.tolerance => {
                *mode = ContactState::Free;
            }
            _ if R::FRICTION && ground.friction > S::ZERO && (mode.is_held() || !ground.is_rigid()) => {
                let push = system.pressure(&state.motion, i, *mode);
                let side = vec3::norm(vec3::tangential(state.motion.force(i), ground.normal));
                let still = ground.is_still(vec3::at(state.motion.vel, i));
                let sticks = still && push > S::ZERO && side <= ground.friction * push;
                let slides = if ground.is_rigid() { ContactState::Held } else { ContactState::Free };
                *mode = if sticks { ContactState::Stuck } else { slides };
            }
            _ => {}
        }
    }
}

/// Takes the slip that the location of an event has left, its rounding: what is slower would end the next stretch at once.
fn stop_creeping<S: Scalar, R: Repertoire<S>>(
    system: &System<S, R>,
    ground: &Ground<S>,
    state: &mut State<S>,
    h: S,
) {
    let slowest = S::from_f64(4.0) * S::EPSILON * (S::ONE + ground.offset.abs()) / h;
    for (i, mode) in state.modes.iter().enumerate() {
        let v = vec3::at(state.motion.vel, i);
        let slip = vec3::tangential(v, ground.normal);
        let slides = *mode != ContactState::Stuck && system.pressure(&state.motion, i, *mode) > S::ZERO;
        if slides
            && vec3::norm(slip) <= slowest
            && let Some(kept) = state.motion.vel.get_mut(i)
        {
            *kept = vec3::sub(v, slip);
        }
    }
}

/// Applies the touch of all points at the surface and closing, then lets go of those that would be pulled.
fn resolve<S: Scalar, R: Repertoire<S>, O: Observer<S, R>>(
    system: &System<S, R>,
    ground: &Ground<S>,
    state: &mut State<S>,
    (h, method): (S, R::Method),
    work: &mut Workspace<S>,
    observer: &mut O,
) -> Result<(), BodyError<S>> {
    let touching = mark_touching(system, ground, state);
    let mut impact = None;
    if touching {
        place_on_surface(ground, &mut state.motion, state.impacts);
        let mut hit = apply_law(system, ground, state, (h, method), work);
        hit.friction = rub(system, ground, state.motion.vel, state.impacts);
        state.motion.vel_rest.iter_mut().for_each(|v| *v = vec3::zero());
        work.evaluations += 1;
        state.motion.refresh(&Frozen { system, modes: state.modes })?;
        hit.lost = hit.lost + hold_or_rebound(system, ground, state, h);
        state.anchor = state.anchor - hit.lost - hit.friction;
        impact = Some(hit);
    }
    let released = release(system, state);
    if system.rough_ground().is_some() {
        stop_creeping(system, ground, state, h);
    }
    settle_modes(system, ground, state);
    let event = Event { time: state.t(), impact, points: state.impacts, modes: state.modes, released };
    observer.event(system, event);
    Ok(())
}
