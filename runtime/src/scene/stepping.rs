//! Steps without events: Moreau's time stepping, and the end of a step that has used up its splits.
//!
//! The end, with e = 0 (Stewart & Trinkle 1996): v' = v + tau a(x, v); a point that would pass the surface is stopped
//! there, v'.n >= -gap/tau; x' = x + tau v'; then it is held. Order 1, never below the surface,
//! and the law dissipates or does nothing.

use super::modes::take_over;
use super::moreau;
use super::state::State;
use super::touch::{lift, release};
use super::watch::{Flow, Observer, StepReport};
use crate::contact::{ContactState, Frozen, Ground, Repertoire, System, friction};
use crate::flexible::BodyError;
use crate::ode::nodes::Workspace;
use crate::real::Scalar;
use crate::vec3::{self, Vec3};

/// One step of Moreau's time stepping.
pub(super) fn step<'a, S: Scalar, R: Repertoire<S>, O: Observer<S, R>>(
    system: &System<S, R>,
    state: &mut State<'a, S>,
    h: S,
    restitution: S,
    work: &mut Workspace<'a, S>,
    observer: &mut O,
) -> Result<StepReport, BodyError<S>> {
    let before = work.evaluations;
    let taken = moreau::step(system, state, h, restitution, work)?;
    close(system, state, h, taken, work, observer);
    Ok(StepReport { substeps: 1, evaluations: work.evaluations - before, ..StepReport::default() })
}

/// Ends a step of which the time `tau` is left.
pub(super) fn finish<'a, S: Scalar, R: Repertoire<S>, O: Observer<S, R>>(
    system: &System<S, R>,
    state: &mut State<'a, S>,
    tau: S,
    work: &mut Workspace<'a, S>,
    observer: &mut O,
) -> Result<(), BodyError<S>> {
    let ground = system.event_ground();
    let mut taken = moreau::Taken { impact: S::ZERO, friction: S::ZERO };
    for i in 0..system.body.points() {
        let (v, mode) = (vec3::at(state.motion.vel, i), state.modes.get(i).copied().unwrap_or_default());
        let free = vec3::axpy(v, tau, system.acceleration(i, mode, state.motion.force(i)));
        let moves = system.body.inverse_mass(i) > S::ZERO;
        let (mut way, mut after) = (if moves { free } else { vec3::zero() }, free);
        if let Some(ground) = ground.filter(|_| moves && !mode.is_held()) {
            let gap = ground.gap(vec3::at(state.motion.pos, i)).max(S::ZERO);
            let rate = ground.gap_rate(free);
            if rate * tau < -gap {
                (way, after) = stop(system, &ground, i, (free, gap / tau), &mut taken);
                if let Some(mode) = state.modes.get_mut(i) {
                    *mode = ContactState::Held;
                }
            }
        }
        if let (Some(dx), Some(dv)) = (work.dx.get_mut(i), work.dv.get_mut(i)) {
            *dx = vec3::scale(way, tau);
            *dv = vec3::sub(after, v);
        }
    }
    work.finish(&Frozen { system, modes: state.modes }, &state.motion)?;
    if let Some(ground) = &ground {
        // What is held in space stays there, even below the ground.
        let lies = |i: &usize| {
            system.body.inverse_mass(*i) > S::ZERO && state.modes.get(*i).is_some_and(|m| m.is_held())
        };
        (0..system.body.points()).filter(lies).for_each(|i| lift(ground, &mut work.end, i));
    }
    close(system, state, tau, taken, work, observer);
    state.anchor = state.anchor - taken.impact - taken.friction;
    if ground.is_some() {
        release(system, state);
    }
    Ok(())
}

/// Velocity towards the surface, with normal part `approach`, and the velocity of the held point there.
fn stop<S: Scalar, R: Repertoire<S>>(
    system: &System<S, R>,
    ground: &Ground<S>,
    i: usize,
    (free, approach): (Vec3<S>, S),
    taken: &mut moreau::Taken<S>,
) -> (Vec3<S>, Vec3<S>) {
    let mass = system.body.mass.get(i).copied().unwrap_or(S::ZERO);
    let rate = ground.gap_rate(free);
    let mut after = vec3::tangential(free, ground.normal);
    taken.impact = taken.impact + S::from_f64(0.5) * mass * rate * rate;
    if !R::FRICTION {
        return (vec3::axpy(after, -approach, ground.normal), after);
    }
    let lost = friction::apply(&mut after, ground.normal, mass, ground.friction, -(mass * rate));
    taken.friction = taken.friction + lost;
    (vec3::axpy(after, -approach, ground.normal), after)
}

/// Makes the state in `work.end` the state and shows it to the observer.
fn close<'a, S: Scalar, R: Repertoire<S>, O: Observer<S, R>>(
    system: &System<S, R>,
    state: &mut State<'a, S>,
    tau: S,
    taken: moreau::Taken<S>,
    work: &mut Workspace<'a, S>,
    observer: &mut O,
) {
    observer.flow(
        system,
        Flow {
            before: &state.motion,
            after: &work.end,
            modes: state.modes,
            tau,
            is_smooth: false,
            braked: &[],
            friction: taken.friction,
            impact: taken.impact,
        },
    );
    take_over(system, state, tau, work);
}
