//! Coulomb friction of the points that slide over a stretch without events, with their mean normal force.
//!
//! A change of speed dv spread over the stretch moves the point by dv tau/2: order 2, and a point that
//! sticks does not creep. The loss is what the speeds lose plus the work of the forces on that way.
//! Invariant: friction takes energy out or does nothing.

use super::State;
use crate::contact::{ContactState, Frozen, Repertoire, System, friction, soft};
use crate::flexible::BodyError;
use crate::ode::nodes::{Motion, Workspace};
use crate::real::Scalar;
use crate::vec3;

/// Takes the sliding points in `work.end` back; returns the loss (J), >= 0.
pub(super) fn slide<S: Scalar, R: Repertoire<S>>(
    system: &System<S, R>,
    state: &State<S>,
    tau: S,
    work: &mut Workspace<S>,
) -> Result<S, BodyError<S>> {
    let Some(ground) = system.rough_ground() else { return Ok(S::ZERO) };
    let half = S::from_f64(0.5);
    let push = |motion: &Motion<S>, i: usize, mode: ContactState| match mode {
        ContactState::Held => system.normal_force(motion.force(i)).max(S::ZERO),
        ContactState::Stuck => S::ZERO,
        _ if !R::SOFT => S::ZERO,
        _ => soft::normal_force(&ground, vec3::at(motion.pos, i), vec3::at(motion.vel, i)).0,
    };
    let (mut lost, mut braked, mut slid) = (S::ZERO, S::ZERO, false);
    for (i, mode) in state.modes.iter().enumerate() {
        let mean = half * (push(&state.motion, i, *mode) + push(&work.end, i, *mode));
        let mass = system.body.mass.get(i).copied().unwrap_or(S::ZERO);
        let (mut way, mut loss) = (vec3::zero(), S::ZERO);
        if let Some(v) = work.end.vel.get_mut(i) {
            let before = *v;
            loss = friction::apply(v, ground.normal, mass, ground.friction, tau * mean);
            way = vec3::scale(vec3::sub(*v, before), half * tau);
        }
        // A point that turned around within the stretch would be pushed up its force for more than its speed held.
        let climb = -vec3::dot(vec3::at(work.end.elastic, i), way);
        if climb > loss {
            way = vec3::scale(way, loss / climb);
        }
        slid |= loss > S::ZERO;
        braked = braked + loss;
        lost = lost + loss + half * vec3::dot(vec3::at(work.end.elastic, i), way);
        if let Some(row) = work.dx.get_mut(i) {
            *row = way;
        }
    }
    if slid {
        work.shift_positions();
        work.refresh_end(&Frozen { system, modes: state.modes })?;
        for (way, force) in work.dx.iter().zip(work.end.elastic.iter()) {
            lost = lost + half * vec3::dot(*force, *way);
        }
        if lost < S::ZERO {
            // What stiff springs took together on the way is more than friction had: the places stay, speeds lose.
            work.dx.iter_mut().for_each(|way| *way = vec3::scale(*way, -S::ONE));
            work.shift_positions();
            work.refresh_end(&Frozen { system, modes: state.modes })?;
            lost = braked;
        }
    }
    Ok(lost)
}
