//! Forces of lasting contacts (thesis Eq. 4.1): normal forces push only, friction sticks inside its cone and slides on
//! its rim.
//!
//! In: accelerations without contact forces, contacts with their velocities and W' u. Out: forces N, T and the
//! accelerations.
//! ```text
//! G lambda = -(W M^-1 f + W' u) where a contact holds:   0 <= N, 0 <= g'', N g'' = 0
//! sliding: T = -mu N v_t/|v_t|          resting: |T| <= mu N, against the acceleration it cannot stop
//! ```
//! Solved by Gauss-Seidel sweeps over the contacts, to the last digits, accelerated where they converge slowly
//! (`anderson`: a box on a smaller one). Where contacts are redundant (a box on four corners) forces are not unique,
//! and where they slip in different directions accelerations depend on which are taken: `share` says which.

use super::anderson::Anderson;
use super::contact::{Inertia, Twist};
pub(crate) use super::held::CORNERS;
use super::held::sweep;
pub use super::held::{Held, Slip, Sought, Unheld};
use super::share::{share, soften};
use super::sweeps::{PLAIN, Patience, fine};
use crate::real::Scalar;
use crate::vec3;

/// Most sweeps.
const SWEEPS: usize = 2000;
/// Sweeps in which friction may turn; then it keeps its direction, so that sweeps end.
const TURNS: usize = 300;

/// Computes the forces and adds their effect to the accelerations.
///
/// Sweeps start from the forces that the contacts have; `accelerations` must not contain these yet.
///
/// # Errors
/// [`Unheld`]; forces and accelerations are then those of the last sweep.
pub fn hold<S: Scalar>(
    held: &mut [impl AsMut<Held<S>>],
    sought: Sought<S>,
    inertia: &(impl Inertia<S> + ?Sized),
    accelerations: &mut [Twist<S>],
) -> Result<(), Unheld> {
    let Sought { pulls, rough, least } = sought;
    // Scale of the forces, even where they nearly cancel: those that would stop the initial accelerations.
    let mut scale = S::ZERO;
    for h in held.iter_mut().map(AsMut::as_mut) {
        let acceleration = vec3::norm(h.contact.relative(accelerations)) + vec3::norm(h.bias);
        scale = scale.max(acceleration.max(least) / h.inverse_mass[0][0]);
    }
    for h in held.iter_mut().map(AsMut::as_mut) {
        h.contact.push(inertia, accelerations, h.contact.impulse);
    }
    // Redundant contacts that may pull could pull and push against one another without an end.
    if pulls && held.len() > 1 {
        return soften(held, pulls, scale, inertia, accelerations);
    }
    // One sweep without yielding then gives contacts that do not touch one another their exact forces.
    let shared = share(held, sought, scale, inertia, accelerations)?;
    let (mut left, mut anderson, mut patience) = (S::ZERO, Anderson::new(), Patience::of_forces(rough));
    for number in 0..SWEEPS {
        left = sweep(held, (number < TURNS, pulls, S::ZERO), scale, inertia, accelerations)?;
        let stays = patience.iter_mut().any(|patience| patience.ends(number, left));
        if shared || stays || left <= fine::<S>(number) {
            return Ok(());
        }
        if patience.iter().all(|patience| patience.fails(number, SWEEPS)) {
            break;
        }
        if (PLAIN..SWEEPS - 1).contains(&number) {
            anderson.record(held);
            anderson.extrapolate(held, inertia, accelerations);
        }
    }
    if patience.iter().any(|patience| patience.accepts(left)) {
        return Ok(());
    }
    soften(held, pulls, scale, inertia, accelerations)
}

/// The acceleration (m/s^2) that counts as zero in a step of h, where this speed does: below it are rounding errors and
/// those of the differences from which accelerations are computed.
pub(crate) fn negligible<S: Scalar>(rate: S, h: S) -> S {
    S::from_f64(1e-3) * rate / h
}
