//! Moreau's time stepping (Jean & Moreau 1992): impacts are resolved per step, not located in time.
//!
//! x_m = x + h/2 v;  v' = v + h f(x_m, v)/m;  where gap(x_m) <= 0 and v'.n < -e v.n:  v'.n := -e v.n; x' = x_m + h/2
//! v'. The displacement is h (v + v')/2, so an impulse J dissipates exactly -J.(v + v')/2. That is never negative for
//! an approaching point. A rising one may be reversed only to v'.n >= -v.n, and friction never reverses slip, so that
//! neither adds energy.

use super::state::State;
use crate::contact::{Frozen, Ground, Repertoire, System, friction};
use crate::flexible::BodyError;
use crate::ode::nodes::Workspace;
use crate::real::Scalar;
use crate::vec3::{self, Vec3};

/// Energy lost at the ground in one step.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Taken<S> {
    /// To the impact law (J).
    pub impact: S,
    /// To friction (J).
    pub friction: S,
}

/// One step into `work.end`; the impulses are stored in the state.
///
/// # Errors
/// Those of the gas law.
pub fn step<S: Scalar, R: Repertoire<S>>(
    system: &System<S, R>,
    state: &mut State<S>,
    h: S,
    restitution: S,
    work: &mut Workspace<S>,
) -> Result<Taken<S>, BodyError<S>> {
    let half = S::from_f64(0.5);
    for (i, x) in work.stage_pos.iter_mut().enumerate() {
        *x = vec3::axpy(vec3::at(state.motion.pos, i), half * h, vec3::at(state.motion.vel, i));
    }
    work.evaluations += 1;
    system.elastic(work.stage_pos, work.stage_elastic)?;
    system.viscous(work.stage_pos, state.motion.vel, work.stage_viscous);
    let mut taken = Taken { impact: S::ZERO, friction: S::ZERO };
    for i in 0..system.body.points() {
        let force = vec3::add(vec3::at(work.stage_elastic, i), vec3::at(work.stage_viscous, i));
        let before = vec3::at(state.motion.vel, i);
        let mut after = vec3::axpy(before, h, vec3::scale(force, system.body.inverse_mass(i)));
        let mut impulse = S::ZERO;
        if let Some(ground) = &system.ground
            && ground.gap(vec3::at(work.stage_pos, i)) <= S::ZERO
        {
            let mass = system.body.mass.get(i).copied().unwrap_or(S::ZERO);
            impulse = push(ground, mass, restitution, before, &mut after, &mut taken);
        }
        if let (Some(dx), Some(dv), Some(point)) =
            (work.dx.get_mut(i), work.dv.get_mut(i), state.impacts.get_mut(i))
        {
            *dv = vec3::sub(after, before);
            *dx = vec3::scale(vec3::add(before, after), half * h);
            point.impulse = impulse;
        }
    }
    work.finish(&Frozen { system, modes: state.modes }, &state.motion)?;
    Ok(taken)
}

/// Applies the ground's impulse and friction to one point; returns the normal impulse (N s).
fn push<S: Scalar>(
    ground: &Ground<S>,
    mass: S,
    restitution: S,
    before: Vec3<S>,
    after: &mut Vec3<S>,
    taken: &mut Taken<S>,
) -> S {
    let half = S::from_f64(0.5);
    let (came, rate) = (ground.gap_rate(before), ground.gap_rate(*after));
    let wanted = if came > S::ZERO { -came } else { -(restitution * came) };
    if rate >= wanted {
        return S::ZERO;
    }
    let impulse = mass * (wanted - rate);
    *after = vec3::axpy(*after, wanted - rate, ground.normal);
    taken.impact = taken.impact - half * impulse * (came + wanted);
    if ground.friction > S::ZERO {
        let (old, new) = (vec3::tangential(before, ground.normal), vec3::tangential(*after, ground.normal));
        let (size, along) = (vec3::dot(new, new), vec3::dot(old, new));
        // J_t.(v_t + v_t') <= 0 for the share f of the slip that friction may remove: f <= 1 + v_t.v_t*/v_t*^2.
        let share = if size > S::ZERO { (S::ONE + along.min(S::ZERO) / size).max(S::ZERO) } else { S::ZERO };
        let allowed = mass * size.sqrt() * share;
        friction::apply(after, ground.normal, mass, S::ONE, allowed.min(ground.friction * impulse));
        let kept = vec3::tangential(*after, ground.normal);
        let work = vec3::dot(vec3::sub(kept, new), vec3::add(old, kept));
        taken.friction = taken.friction + (-(half * mass * work)).max(S::ZERO);
    }
    impulse
}
