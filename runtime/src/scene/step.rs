//! The step: try, accept, resolve events, until it is used up.

use super::attempt::{Attempt, attempt, control_step, try_length};
use super::modes::{lift_departing, settle_modes, stop_creeping, take_over};
use super::state::State;
use super::touch::{apply_law, hold_or_rebound, mark_touching, place_on_surface, release, rub};
use super::watch::{Event, Flow, Observer, StepReport};
use super::{slide, stepping};
use crate::contact::{ContactLaw, ContactState, Frozen, Ground, Repertoire, System};
use crate::flexible::energy::eval_energies;
use crate::flexible::{BodyError, ON_HOST, Quantity};
use crate::guard::Shortened;
use crate::ode::nodes::{Step, Workspace};
use crate::real::Scalar;
use crate::vec3;

/// Most events located in one step.
pub const MAX_EVENTS: usize = 64;
/// Most substeps of an adaptive method within one step.
pub const MAX_SUBSTEPS: usize = 4096;

/// Advances the state by h (s), > 0.
///
/// # Errors
/// The state is then the last good one. A host refuses a step that is not a finite time above 0.
pub fn step<'a, S: Scalar, R: Repertoire<S>, O: Observer<S, R>>(
    system: &System<S, R>,
    state: &mut State<'a, S>,
    h: S,
    method: R::Method,
    work: &mut Workspace<'a, S>,
    observer: &mut O,
) -> Result<StepReport, BodyError<S>> {
    if ON_HOST && !(h > S::ZERO && h.is_finite()) {
        return Err(BodyError::OutOfRange(Quantity::Step));
    }
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
        // Soft ground needs no events to keep points off it: the method continues without them.
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
            // For an adaptive method, the shortest bounce resolved depends on its own step, not on the caller's.
            let length = if method.control_order() == 0 { h } else { state.next_step.min(h) };
            resolve(system, ground, state, (length, method), work, observer)?;
        }
    }
    report.evaluations = work.evaluations - before;
    Ok(report)
}

/// Accepts the state in `work.end`, after sliding friction.
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

/// Refuses a point with mass below the ground: statics keeps only massless points off it.
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

/// Resolves the impact of all points at the surface that are closing, then releases those that the ground would have to
/// pull.
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

impl<S: Scalar> State<'_, S> {
    /// Prepares a start: forces, energy, points that lie on the ground or touch it now.
    ///
    /// # Errors
    /// A ground whose numbers are out of range, a point below a rigid ground, an energy that is not finite, or a fault
    /// of the gas law.
    pub fn begin<R: Repertoire<S>, O: Observer<S, R>>(
        &mut self,
        system: &System<S, R>,
        h: S,
        method: R::Method,
        work: &mut Workspace<S>,
        observer: &mut O,
    ) -> Result<(), BodyError<S>> {
        if ON_HOST && let Some(ground) = &system.ground {
            ground.check()?;
        }
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

    /// Refuses a point below a rigid ground: impact laws do not apply to a point that is already through the surface.
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
