//! Resolves an event: marks the touching points, puts them on the surface, applies impact law and friction; then holds
//! them or lets them rebound, and releases points that the ground would have to pull.
//!
//! Invariant: positions change only by the rounding with which the event was located.

use super::state::State;
use crate::contact::compensation::{self, Compensation, Impact, PointImpact, Root};
use crate::contact::{ContactLaw, ContactState, Ground, Repertoire, System, friction, restitution};
use crate::flexible::energy::eval_energies;
use crate::ode::nodes::{Motion, Workspace, copy};
use crate::real::Scalar;
use crate::vec3::{self, Vec3};

/// A rebound whose flight is shorter than this share of a step, or lower than the tolerance, ends at rest (Zeno).
const ZENO_FLIGHT: f64 = 1e-2;
/// Iterations of an anchored impact: the oscillation is some thousandths of the energy, which is the convergence
/// factor.
const ANCHOR_PASSES: usize = 3;

/// Marks the set B of touching points; returns whether there is any.
pub(super) fn mark_touching<S: Scalar, R: Repertoire<S>>(
    system: &System<S, R>,
    ground: &Ground<S>,
    state: &mut State<S>,
) -> bool {
    let mut any = false;
    for (i, (point, mode)) in state.impacts.iter_mut().zip(state.modes.iter()).enumerate() {
        let near = ground.gap(vec3::at(state.motion.pos, i)) <= ground.tolerance;
        let closing = ground.gap_rate(vec3::at(state.motion.vel, i)) < S::ZERO;
        let moves = system.body.inverse_mass(i) > S::ZERO;
        *point = PointImpact::none();
        point.touching = near && closing && moves && !mode.is_held();
        any |= point.touching;
    }
    any
}

/// Lifts touching points that were located below the surface, by rounding or because the method let a rising point
/// sink.
pub(super) fn place_on_surface<S: Scalar>(
    ground: &Ground<S>,
    motion: &mut Motion<S>,
    points: &[PointImpact<S>],
) {
    for (i, _) in points.iter().enumerate().filter(|(_, p)| p.touching) {
        let x = vec3::at(motion.pos, i);
        // Points in between returned within the tolerance: lifting them would add energy to a bounce.
        let rounding = S::from_f64(2.0) * S::EPSILON * (S::ONE + ground.offset.abs() + vec3::norm(x));
        if ground.gap(x) >= -rounding || ground.is_deep(x) {
            lift(ground, motion, i);
        }
    }
}

/// Moves point i up to the surface if it is below.
pub(super) fn lift<S: Scalar>(ground: &Ground<S>, motion: &mut Motion<S>, i: usize) {
    let gap = ground.gap(vec3::at(motion.pos, i));
    if gap < S::ZERO {
        vec3::add_at(motion.pos, i, vec3::scale(ground.normal, -gap));
        if let Some(rest) = motion.pos_rest.get_mut(i) {
            *rest = vec3::tangential(*rest, ground.normal);
        }
    }
}

pub(super) fn apply_law<S: Scalar, R: Repertoire<S>>(
    system: &System<S, R>,
    ground: &Ground<S>,
    state: &mut State<S>,
    (h, method): (S, R::Method),
    work: &mut Workspace<S>,
) -> Impact<S> {
    match ground.law {
        ContactLaw::Newton { restitution } if R::NEWTON => {
            restitution::apply(system, restitution, state.motion.vel, state.impacts)
        }
        ContactLaw::Compensation { eta, anchor, plastic_alone, first_receiver } if R::COMPENSATION => {
            let law = Compensation { eta, anchor: S::ZERO, plastic_alone, first_receiver };
            if R::ANCHOR && anchor {
                anchored(system, law, state, (h, method), work)
            } else {
                compensate(system, law, state)
            }
        }
        _ => Impact { root: Root::Alone, lambda: S::ZERO, lost: S::ZERO, friction: S::ZERO },
    }
}

fn compensate<S: Scalar, R: Repertoire<S>>(
    system: &System<S, R>,
    law: Compensation<S>,
    state: &mut State<S>,
) -> Impact<S> {
    let modes = &*state.modes;
    let receiver = |k: usize| {
        let is_held = modes.get(k).is_some_and(|m| m.is_held());
        k >= law.first_receiver && system.body.inverse_mass(k) > S::ZERO && !is_held
    };
    compensation::apply(system, law, state.motion.pos, state.motion.vel, state.impacts, receiver)
}

/// Compensation whose result has the energy of the anchor. The oscillation after the impact depends on the speeds after
/// it, so the first pass uses those before.
fn anchored<S: Scalar, R: Repertoire<S>>(
    system: &System<S, R>,
    law: Compensation<S>,
    state: &mut State<S>,
    (h, method): (S, R::Method),
    work: &mut Workspace<S>,
) -> Impact<S> {
    let now = eval_energies(&system.body, state.motion.pos, state.motion.vel).total();
    copy(work.stage_vel, state.motion.vel);
    let mut hit = Impact { root: Root::Alone, lambda: S::ZERO, lost: S::ZERO, friction: S::ZERO };
    for _ in 0..ANCHOR_PASSES {
        let held = |i: usize| match state.impacts.get(i) {
            Some(point) if point.touching => ContactState::Held,
            _ => state.modes.get(i).copied().unwrap_or_default(),
        };
        let swing = state.energy_swing(system, h, method, held);
        let law = Compensation { anchor: state.anchor + swing - now, ..law };
        copy(state.motion.vel, work.stage_vel);
        hit = compensate(system, law, state);
    }
    hit
}

/// Applies the friction of the impulses; returns the loss (J).
pub(super) fn rub<S: Scalar, R: Repertoire<S>>(
    system: &System<S, R>,
    ground: &Ground<S>,
    vel: &mut [Vec3<S>],
    points: &[PointImpact<S>],
) -> S {
    let mut lost = S::ZERO;
    if !R::FRICTION {
        return lost;
    }
    for ((v, point), mass) in vel.iter_mut().zip(points).zip(system.body.mass) {
        if point.touching {
            lost = lost + friction::apply(v, ground.normal, *mass, ground.friction, point.impulse);
        }
    }
    lost
}

/// Holds each touching point, or releases it if its rebound lasts longer than [`ZENO_FLIGHT`]; returns the energy lost
/// by resting (J).
pub(super) fn hold_or_rebound<S: Scalar, R: Repertoire<S>>(
    system: &System<S, R>,
    ground: &Ground<S>,
    state: &mut State<S>,
    h: S,
) -> S {
    let mut lost = S::ZERO;
    for (i, (mode, point)) in state.modes.iter_mut().zip(state.impacts.iter()).enumerate() {
        if !point.touching {
            continue;
        }
        let rate = ground.gap_rate(vec3::at(state.motion.vel, i));
        let pressing = system.normal_force(state.motion.force(i)) * system.body.inverse_mass(i);
        let is_short = S::from_f64(2.0) * rate < S::from_f64(ZENO_FLIGHT) * h * pressing;
        let is_low = rate * rate < S::from_f64(2.0) * ground.tolerance * pressing;
        let flight_ends = is_short || is_low;
        if rate > S::ZERO && !flight_ends {
            *mode = ContactState::Departing;
            continue;
        }
        *mode = ContactState::Held;
        if rate > S::ZERO {
            let mass = system.body.mass.get(i).copied().unwrap_or(S::ZERO);
            lost = lost + S::from_f64(0.5) * mass * rate * rate;
        }
        if let Some(v) = state.motion.vel.get_mut(i) {
            *v = vec3::tangential(*v, ground.normal);
        }
    }
    lost
}

/// Releases held points that the ground would have to pull; returns how many.
pub(super) fn release<S: Scalar, R: Repertoire<S>>(system: &System<S, R>, state: &mut State<S>) -> usize {
    let mut released = 0;
    for (i, mode) in state.modes.iter_mut().enumerate() {
        if mode.is_held() && system.normal_force(state.motion.force(i)) < S::ZERO {
            *mode = ContactState::Departing;
            released += 1;
        }
    }
    released
}
