//! Impact at several points at once with e = 0, by sweeps: normal impulses that stop the approach, energy compensation
//! with them, friction within known impulses.
//!
//! In: contacts and velocities at the instant of impact. Out: impulses, and the velocities after. Every update of a
//! sweep lowers the kinetic energy, so that stopping early creates none.

use super::contact::{Inertia, Twist, rubbed};
use super::struck::{Outcome, Struck};
use crate::real::Scalar;
use crate::vec3;

/// Most sweeps.
const SWEEPS: usize = 2000;

/// The largest relative speed at a contact (m/s).
fn fastest<S: Scalar>(struck: &[Struck<S>], twists: &[Twist<S>]) -> S {
    struck.iter().fold(S::ZERO, |most, s| most.max(vec3::norm(s.contact.relative(twists))))
}

/// Stops the approach that is left, without friction: normal impulses J >= 0 with J v_n = 0.
///
/// Every update lowers the kinetic energy, so stopping early creates none. Returns false if the sweeps did not
/// converge.
pub fn stop<S: Scalar>(
    struck: &mut [Struck<S>],
    inertia: &(impl Inertia<S> + ?Sized),
    twists: &mut [Twist<S>],
) -> bool {
    let (mut settled, fastest) = (false, fastest(struck, twists));
    for s in struck.iter_mut() {
        s.piece = vec3::zero();
    }
    for _ in 0..SWEEPS {
        let mut moved = S::ZERO;
        for s in struck.iter_mut() {
            let yields = s.inverse_mass[0][0];
            if yields > S::ZERO {
                let next = (s.piece[0] - s.contact.relative(twists)[0] / yields).max(S::ZERO);
                let change = next - s.piece[0];
                s.piece[0] = next;
                s.contact.push(inertia, twists, [change, S::ZERO, S::ZERO]);
                moved = moved.max(change.abs() * yields);
            }
        }
        settled = moved <= S::from_f64(4.0) * S::EPSILON * fastest;
        if settled {
            break;
        }
    }
    for s in struck.iter_mut() {
        s.contact.impulse[0] = s.contact.impulse[0] + s.piece[0];
    }
    settled
}

/// Impact by energy compensation: first with e = 0, then a share `eta` of the loss Q is given back along the same
/// impulses.
///
/// ```text
/// J0: as `stop`;  u = M^-1 W' J0;  A = u.M u/2;  b = u.M v;  A lambda^2 + b lambda = eta Q;  J = (1 + lambda) J0 >= 0
/// ```
/// Friction acts afterwards within mu J and only dissipates.
pub fn compensate_all<S: Scalar>(
    struck: &mut [Struck<S>],
    eta: S,
    inertia: &(impl Inertia<S> + ?Sized),
    twists: &mut [Twist<S>],
) -> Outcome {
    for s in struck.iter_mut() {
        s.contact.impulse = vec3::zero();
        s.before = s.contact.relative(twists);
    }
    let settled = stop(struck, inertia, twists);
    let half = S::from_f64(0.5);
    // u = change by J0: J0 . W u = 2 A, J0 . W v+ = b (0 but for rounding), Q = -(J0 . W v- + A) .
    let (mut work, mut change) = (S::ZERO, S::ZERO);
    for s in struck.iter() {
        let (j, after) = (s.contact.impulse[0], s.contact.relative(twists)[0]);
        (work, change) = (work + j * after, change + j * (after - s.before[0]));
    }
    let (a, b) = (half * change, work);
    let loss = (a - b).max(S::ZERO);
    if a > S::ZERO {
        let share = eta * loss;
        let root = b + (b * b + S::from_f64(4.0) * a * share).max(S::ZERO).sqrt();
        let lambda = if root > S::ZERO { S::from_f64(2.0) * share / root } else { S::ZERO };
        for s in struck.iter_mut() {
            let more = lambda * s.contact.impulse[0];
            s.contact.impulse[0] = s.contact.impulse[0] + more;
            s.contact.push(inertia, twists, [more, S::ZERO, S::ZERO]);
        }
    }
    let complete = rub_within(struck, inertia, twists) && settled;
    Outcome { pieces: 1, complete }
}

/// Impact with e = 0 and friction of contacts that share it, from none: J_n >= 0, v_n >= 0, J_n v_n = 0 and |J_t| <= mu
/// J_n against the slip that is left, all with the velocities after. It loses energy: J . v+ <= 0.
///
/// Returns false if the sweeps did not converge; the impulses are then those of [`stop`].
pub(crate) fn end<S: Scalar>(
    struck: &mut [Struck<S>],
    inertia: &(impl Inertia<S> + ?Sized),
    twists: &mut [Twist<S>],
) -> bool {
    for s in struck.iter_mut() {
        (s.contact.impulse, s.piece) = (vec3::zero(), vec3::zero());
        s.before = s.contact.relative(twists);
    }
    let fastest = fastest(struck, twists);
    for _ in 0..SWEEPS {
        let mut moved = S::ZERO;
        for s in struck.iter_mut() {
            let (before, yields) = (s.piece, s.inverse_mass[0][0]);
            if yields <= S::ZERO {
                continue;
            }
            let normal = (before[0] - s.contact.relative(twists)[0] / yields).max(S::ZERO);
            s.contact.push(inertia, twists, [normal - before[0], S::ZERO, S::ZERO]);
            let [_, x, y] = s.contact.relative(twists);
            let radius = s.contact.friction * normal;
            let [x, y] = rubbed(&s.inverse_mass, [before[1], before[2]], [x, y], radius);
            s.contact.push(inertia, twists, [S::ZERO, x - before[1], y - before[2]]);
            s.piece = [normal, x, y];
            let size = yields.max(s.inverse_mass[1][1]).max(s.inverse_mass[2][2]);
            moved = moved.max(vec3::norm(vec3::sub(s.piece, before)) * size);
        }
        if moved <= S::from_f64(4.0) * S::EPSILON * fastest {
            struck.iter_mut().for_each(|s| s.contact.impulse = s.piece);
            return true;
        }
    }
    for s in struck.iter() {
        s.contact.push(inertia, twists, vec3::scale(s.piece, -S::ONE));
    }
    let _ = stop(struck, inertia, twists);
    false
}

/// Friction within mu J of known impulses J, with the normal impulses needed to keep the bodies apart: each update
/// lowers the kinetic energy. Returns false if the sweeps did not converge.
pub(crate) fn rub_within<S: Scalar>(
    struck: &mut [Struck<S>],
    inertia: &(impl Inertia<S> + ?Sized),
    twists: &mut [Twist<S>],
) -> bool {
    for s in struck.iter_mut() {
        s.piece = vec3::zero();
        s.trial = s.contact.impulse[0];
    }
    let (mut settled, fastest) = (false, fastest(struck, twists));
    for _ in 0..SWEEPS {
        let mut moved = S::ZERO;
        for s in struck.iter_mut() {
            let before = s.piece;
            let yields = s.inverse_mass[0][0];
            if yields > S::ZERO {
                let next = (s.piece[0] - s.contact.relative(twists)[0] / yields).max(S::ZERO);
                s.contact.push(inertia, twists, [next - s.piece[0], S::ZERO, S::ZERO]);
                s.piece[0] = next;
            }
            let radius = s.contact.friction * s.trial;
            if radius > S::ZERO {
                let [_, x, y] = s.contact.relative(twists);
                let [x, y] = rubbed(&s.inverse_mass, [s.piece[1], s.piece[2]], [x, y], radius);
                s.contact.push(inertia, twists, [S::ZERO, x - s.piece[1], y - s.piece[2]]);
                (s.piece[1], s.piece[2]) = (x, y);
            }
            let size = yields.max(s.inverse_mass[1][1]).max(s.inverse_mass[2][2]);
            moved = moved.max(vec3::norm(vec3::sub(s.piece, before)) * size);
        }
        settled = moved <= S::from_f64(4.0) * S::EPSILON * fastest;
        if settled {
            break;
        }
    }
    for s in struck.iter_mut() {
        s.contact.impulse = vec3::add(s.contact.impulse, s.piece);
    }
    settled
}
