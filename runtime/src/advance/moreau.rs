//! Moreau's time stepping (Jean & Moreau 1992): impacts belong to the step, not to an instant.
//!
//! x_m = x + h/2 v;  v' = v + h f(x_m, v)/m;  where gap(x_m) <= 0 and v'.n < -e v.n:  v'.n := -e v.n;
//! x' = x_m + h/2 v'. The kinetic energy that the correction takes is the impact's loss.

use super::{Start, Workspace, eval_elastic, eval_viscous, finish};
use crate::body::BodyError;
use crate::body::vec3;
use crate::contact::{System, friction};
use crate::real::Scalar;

/// What the ground took in one step.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Taken<S> {
    /// By the impact law (J).
    pub impact: S,
    /// By friction (J).
    pub friction: S,
}

/// One step into `work.end`; the impulses are left in `work.impacts`.
///
/// # Errors
/// From the gas law.
pub fn step<S: Scalar>(
    system: &System<S>,
    start: Start<S>,
    h: S,
    restitution: S,
    work: &mut Workspace<S>,
) -> Result<Taken<S>, BodyError<S>> {
    let half = S::from_f64(0.5);
    for (i, x) in work.stage_pos.iter_mut().enumerate() {
        *x = vec3::axpy(vec3::at(start.motion.pos, i), half * h, vec3::at(start.motion.vel, i));
    }
    work.evaluations += 1;
    eval_elastic(system, work.stage_pos, work.stage_elastic)?;
    eval_viscous(system, work.stage_pos, start.motion.vel, work.stage_viscous);
    let mut taken = Taken { impact: S::ZERO, friction: S::ZERO };
    for i in 0..system.body.points() {
        let force = vec3::add(vec3::at(work.stage_elastic, i), vec3::at(work.stage_viscous, i));
        let before = vec3::at(start.motion.vel, i);
        let mut after = vec3::axpy(before, h, vec3::scale(force, system.body.inverse_mass(i)));
        let mut impulse = S::ZERO;
        if let Some(ground) = &system.ground
            && ground.gap(vec3::at(work.stage_pos, i)) <= S::ZERO
        {
            let mass = system.body.mass.get(i).copied().unwrap_or(S::ZERO);
            let rate = ground.gap_rate(after);
            let wanted = -(restitution * ground.gap_rate(before));
            if rate < wanted {
                impulse = mass * (wanted - rate);
                after = vec3::axpy(after, wanted - rate, ground.normal);
                taken.impact = taken.impact + half * mass * (rate * rate - wanted * wanted);
                taken.friction = taken.friction
                    + friction::apply(&mut after, ground.normal, mass, ground.friction, impulse);
            }
        }
        if let (Some(dx), Some(dv), Some(point)) =
            (work.dx.get_mut(i), work.dv.get_mut(i), work.impacts.get_mut(i))
        {
            *dv = vec3::sub(after, before);
            *dx = vec3::scale(vec3::add(before, after), half * h);
            point.impulse = impulse;
        }
    }
    finish(system, start, work)?;
    Ok(taken)
}
