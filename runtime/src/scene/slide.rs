//! Coulomb friction of points that slide over a piece without events, by their mean normal force.
//!
//! A change of speed dv spread over the piece displaces the point by dv tau/2: order 2, and a sticking
//! point does not creep. Speed-dependent forces have acted all along on speeds without friction: half of their
//! change is added, dv += tau/2 (F(v') - F(v))/m, and the normal force at the end is the one after it.
//! The loss is the kinetic energy removed plus the work of the forces on that displacement.
//! Massless points slide by statics (`contact::massless`); only their loss is counted here.
//! Invariant: friction dissipates or does nothing.

use super::state::State;
use crate::contact::{ContactState, Frozen, Ground, Repertoire, System, friction, massless};
use crate::flexible::BodyError;
use crate::ode::nodes::{Motion, Workspace, copy};
use crate::real::Scalar;
use crate::vec3;

/// Applies friction to the sliding points in `work.end`, with changes of speed in `work.dv`; returns the loss (J), >=
/// 0.
pub(super) fn slide<S: Scalar, R: Repertoire<S>>(
    system: &System<S, R>,
    state: &State<S>,
    tau: S,
    work: &mut Workspace<S>,
) -> Result<S, BodyError<S>> {
    let Some(ground) = system.rough_ground() else { return Ok(S::ZERO) };
    if system.massless_ground().is_some() {
        work.dv.iter_mut().for_each(|change| *change = vec3::zero());
        let (places, forces) =
            ([&*state.motion.pos, work.end.pos], [&*state.motion.elastic, work.end.elastic]);
        return Ok(massless::friction_loss(&system.body, &ground, places, forces));
    }
    let half = S::from_f64(0.5);
    copy(work.stages, work.end.vel);
    copy(work.stage_viscous, work.end.viscous);
    let mut braked = brake(system, &ground, state, tau, work, false);
    if braked == S::ZERO {
        return Ok(S::ZERO);
    }
    let mut climbed = S::ZERO;
    for (i, way) in work.dx.iter().enumerate() {
        climbed = climbed + half * vec3::dot(work.end.force(i), *way);
    }
    work.shift_positions();
    work.refresh_end(&Frozen { system, modes: state.modes })?;
    for (i, way) in work.dx.iter().enumerate() {
        climbed = climbed + half * vec3::dot(work.end.force(i), *way);
    }
    if system.is_damped() {
        make_up(system, state, tau, work);
        braked = brake(system, &ground, state, tau, work, true);
        system.viscous(work.end.pos, work.end.vel, work.end.viscous);
    }
    if braked + climbed < S::ZERO {
        // Stiff springs together took more energy on the displacement than friction had: undo it, keep the changes of
        // speed.
        work.dx.iter_mut().for_each(|way| *way = vec3::scale(*way, -S::ONE));
        work.shift_positions();
        work.refresh_end(&Frozen { system, modes: state.modes })?;
        return Ok(braked);
    }
    Ok(braked + climbed)
}

/// Adds to the speeds without friction half of the change that friction causes in speed-dependent forces.
fn make_up<S: Scalar, R: Repertoire<S>>(
    system: &System<S, R>,
    state: &State<S>,
    tau: S,
    work: &mut Workspace<S>,
) {
    let half = S::from_f64(0.5) * tau;
    for (i, mode) in state.modes.iter().enumerate() {
        let change = vec3::sub(vec3::at(work.end.viscous, i), vec3::at(work.stage_viscous, i));
        let kick = vec3::scale(system.acceleration(i, *mode, change), half);
        if let Some(v) = work.stages.get_mut(i) {
            *v = vec3::add(*v, kick);
        }
    }
}

/// Writes the speeds `work.stages` (without friction) less friction into `work.end`, with changes in `work.dv`; returns
/// the kinetic energy lost (J).
///
/// The first time also writes displacements into `work.dx`. With `again`, positions stay, and a point that has stuck
/// stays stuck.
fn brake<S: Scalar, R: Repertoire<S>>(
    system: &System<S, R>,
    ground: &Ground<S>,
    state: &State<S>,
    tau: S,
    work: &mut Workspace<S>,
    again: bool,
) -> S {
    let half = S::from_f64(0.5);
    let push = |motion: &Motion<S>, i: usize, mode: ContactState| match mode {
        ContactState::Stuck => S::ZERO,
        _ => system.pressure(motion, i, mode).max(S::ZERO),
    };
    let mut braked = S::ZERO;
    for (i, mode) in state.modes.iter().enumerate() {
        let mean = half * (push(&state.motion, i, *mode) + push(&work.end, i, *mode));
        let mass = system.body.mass.get(i).copied().unwrap_or(S::ZERO);
        let (start, before) = (vec3::at(state.motion.vel, i), vec3::at(work.stages, i));
        let stuck =
            again && vec3::at(work.dv, i) != vec3::zero() && ground.is_still(vec3::at(work.end.vel, i));
        let impulse = if stuck { S::ONE / S::EPSILON } else { tau * mean };
        let mut v = before;
        let loss = friction::apply_over(&mut v, start, ground.normal, mass, ground.friction, impulse);
        let change = vec3::sub(v, before);
        braked = braked + loss;
        if !again {
            // A point that reversed within the piece would be displaced against its force by more work than its kinetic
            // energy.
            let way = vec3::scale(change, half * tau);
            let climb = -vec3::dot(vec3::at(work.end.elastic, i), way);
            let way = if climb > loss { vec3::scale(way, loss / climb) } else { way };
            vec3::set_at(work.dx, i, way);
        }
        vec3::set_at(work.dv, i, change);
        vec3::set_at(work.end.vel, i, v);
    }
    braked
}
