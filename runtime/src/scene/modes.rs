//! Contact states of the points after a piece of a step.

use super::state::State;
use super::touch::lift;
use crate::contact::{ContactState, Frozen, Ground, Repertoire, System};
use crate::flexible::BodyError;
use crate::guard::{PASSED_OVER, are_free};
use crate::ode::nodes::Workspace;
use crate::real::Scalar;
use crate::vec3;

/// Makes the state in `work.end` the state, tau later, by swapping their memory.
pub(super) fn take_over<'a, S: Scalar, R: Repertoire<S>>(
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

/// Departing points that move away but lie below the surface, by the method's error, are put on it; returns whether any
/// was.
pub(super) fn lift_departing<S: Scalar, R: Repertoire<S>>(
    system: &System<S, R>,
    modes: &[ContactState],
    work: &mut Workspace<S>,
) -> Result<bool, BodyError<S>> {
    let Some(ground) = system.event_ground() else { return Ok(false) };
    let mut lifted = false;
    let blocks = modes.chunks(PASSED_OVER).enumerate().filter(|(_, modes)| !are_free(modes));
    let points = blocks.flat_map(|(block, modes)| {
        modes.iter().enumerate().map(move |(i, mode)| (block * PASSED_OVER + i, mode))
    });
    let departs = |(i, mode): &(usize, &ContactState)| {
        **mode == ContactState::Departing && system.body.inverse_mass(*i) > S::ZERO
    };
    for (i, _) in points.filter(departs) {
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

/// Arms the guards of points that are clear of the ground; decides for held points whether they stick.
pub(super) fn settle_modes<S: Scalar, R: Repertoire<S>>(
    system: &System<S, R>,
    ground: &Ground<S>,
    state: &mut State<S>,
) {
    let rubs = R::FRICTION && ground.friction > S::ZERO;
    for (block, modes) in state.modes.chunks_mut(PASSED_OVER).enumerate() {
        // A free point stays free, unless a soft ground rubs it.
        if are_free(modes) && (ground.is_rigid() || !rubs) {
            continue;
        }
        for (i, mode) in modes.iter_mut().enumerate().map(|(i, mode)| (block * PASSED_OVER + i, mode)) {
            match mode {
                ContactState::Departing if ground.gap(vec3::at(state.motion.pos, i)) > ground.tolerance => {
                    *mode = ContactState::Free;
                }
                _ if rubs && (mode.is_held() || !ground.is_rigid()) => {
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
}

/// Removes slip that is only the rounding of an event's location: a slip as slow as that would end the next piece at
/// once.
pub(super) fn stop_creeping<S: Scalar, R: Repertoire<S>>(
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
