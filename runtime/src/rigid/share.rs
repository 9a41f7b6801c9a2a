//! How redundant contacts share their load: as if each yielded a little, all alike.
//!
//! In: contacts as `hold` has them, from any forces. Out: their forces, and whether these are exact.
//! ```text
//! G lambda + D (lambda - lambda_before) = -(W M^-1 f + W' u)     D = share of K, from lambda_before = 0, repeated
//! ```
//! Many forces of redundant contacts give the same accelerations where these slip in one direction, but not where they
//! slip in different ones: the pattern + - + - at the corners of a box that turns is a torque of friction. Contacts
//! that yield have one solution, in whatever order and from whatever forces they are swept. In the limit of the
//! repetitions they yield no more, and D lambda fits one motion of the bodies: under a box, the normal forces are a
//! plane over its corners, as on springs of one stiffness. Nor do contacts whose accelerations contradict one another
//! drive the forces away: each repetition moves them by that contradiction over D only. A large D takes few sweeps a
//! repetition and moves them least: forces that plain sweeps did not find are found so (`soften`).

use super::anderson::Anderson;
use super::contact::{Inertia, Twist};
use super::held::{Held, Slip, Sought, Unheld, sweep};
use super::sweeps::{Patience, accepted, fine};
use crate::real::Scalar;
use crate::vec3::{self, Vec3};

/// D: the acceleration by which a contact yields to a force, as a share of the one that the force gives its bodies.
const YIELDS: f64 = 1e-3;
/// Fewest contacts whose normal forces fit in more than one way.
pub(crate) const REDUNDANT: usize = 4;
/// D of contacts that push by impulses, as the share above.
const PRESSED: f64 = 0.01;
/// Most repetitions with it.
const PRESSED_TIMES: usize = 8;
/// Closing that such impulses may leave, relative to the largest velocity without them.
const CLOSING: f64 = 1e-6;
/// D of contacts that contradict one another, as the share above.
const SOFT: f64 = 0.1;
/// Most repetitions with it, and those within which what is left halves at least.
const SOFT_TIMES: [usize; 2] = [80, 8];
/// Most sweeps of each.
const SOFT_SWEEPS: usize = 400;
/// They end where one changes the forces by less than this share of what the repetition does.
const INEXACT: f64 = 0.1;
/// What contradictions may leave, relative to the largest acceleration without contact forces: contacts that stick move
/// by the error of a step's middle, and redundant ones contradict one another by it.
const CONTRADICTION: f64 = 1e-3;
/// Directions of slip that differ by more (rad) are different.
const TURNED: f64 = 1e-6;
/// Most repetitions.
const TIMES: usize = 12;
/// Most sweeps of each; where many contacts would need more, forces are those that plain sweeps find from there.
const SWEEPS: usize = 200;
/// Sweeps within which what is left must halve.
const PATIENCE: usize = 20;
/// What may be left where it does not (rounding units).
const ROUGHEST: f64 = 4096.0;
/// A repetition that leaves more than this share of what the one before left gains nothing: contacts contradict one
/// another.
const STAYS: f64 = 0.9;
/// Sweeps of each before acceleration begins.
const PLAIN: usize = 4;

/// Finds forces and adds their effect to the accelerations; returns whether nothing is left to sweep. `scale`: least
/// force (N) that counts as large.
pub(super) fn share<S: Scalar>(
    held: &mut [impl AsMut<Held<S>>],
    Sought { pulls, rough, .. }: Sought<S>,
    scale: S,
    inertia: &(impl Inertia<S> + ?Sized),
    accelerations: &mut [Twist<S>],
) -> Result<bool, Unheld> {
    if held.len() < REDUNDANT || !turns(held) {
        return Ok(false);
    }
    held.iter_mut().for_each(|h| h.as_mut().unyielded = vec3::zero());
    let mut before = S::from_f64(f64::INFINITY);
    for _ in 0..TIMES {
        if !settle(held, (pulls, S::from_f64(YIELDS)), scale, inertia, accelerations)? {
            return Ok(false);
        }
        let [left, largest] = yielding(held, S::from_f64(YIELDS), scale);
        held.iter_mut().for_each(|h| h.as_mut().keep());
        if left <= fine::<S>(SWEEPS) * largest {
            return Ok(true);
        }
        let left = left / largest;
        if left > S::from_f64(STAYS) * before {
            return Ok(rough && left <= accepted(rough));
        }
        before = left;
    }
    Ok(false)
}

/// Finds forces of contacts that contradict one another, or that plain sweeps do not find, from no forces.
pub(super) fn soften<S: Scalar>(
    held: &mut [impl AsMut<Held<S>>],
    pulls: bool,
    scale: S,
    inertia: &(impl Inertia<S> + ?Sized),
    accelerations: &mut [Twist<S>],
) -> Result<(), Unheld> {
    release(held, inertia, accelerations);
    let (soft, [times, within]) = (S::from_f64(SOFT), SOFT_TIMES);
    let mut patience = Patience::new(within, S::from_f64(CONTRADICTION));
    let mut left = S::ZERO;
    for number in 0..times {
        let mut largest = scale;
        for _ in 0..SOFT_SWEEPS {
            let moved = sweep(held, (true, pulls, soft), scale, inertia, accelerations)?;
            [left, largest] = yielding(held, soft, scale);
            if moved * largest <= S::from_f64(INEXACT) * left {
                break;
            }
        }
        held.iter_mut().for_each(|h| h.as_mut().keep());
        if left <= fine::<S>(SWEEPS) * largest || patience.ends(number, left / scale) {
            return Ok(());
        }
    }
    if patience.accepts(left / scale) { Ok(()) } else { Err(Unheld::Unbalanced) }
}

/// Whether contacts slip in different directions: else all forces that fit give the same accelerations.
fn turns<S: Scalar>(held: &mut [impl AsMut<Held<S>>]) -> bool {
    differ(held.iter_mut().filter_map(|h| {
        let Held { contact, slip, .. } = h.as_mut();
        let Slip { direction: [x, y], .. } = slip.filter(|_| contact.friction > S::ZERO)?;
        let [_, t1, t2] = contact.axes;
        Some(vec3::axpy(vec3::scale(t1, x), y, t2))
    }))
}

/// Whether these directions are not all the same.
pub(crate) fn differ<S: Scalar>(mut slips: impl Iterator<Item = Vec3<S>>) -> bool {
    let Some(first) = slips.next() else { return false };
    slips.any(|slip| vec3::norm(vec3::sub(slip, first)) > S::from_f64(TURNED))
}

/// Finds impulses over a piece of time, from none, and adds their effect: velocities stand for accelerations, and every
/// contact sticks as far as its friction goes. Such impulses there always are; sweeps that do not find them end early.
pub(crate) fn press<S: Scalar>(
    held: &mut [impl AsMut<Held<S>>],
    inertia: &(impl Inertia<S> + ?Sized),
    velocities: &mut [Twist<S>],
) {
    let (mut scale, yields) = (S::ZERO, S::from_f64(PRESSED));
    for h in held.iter_mut().map(AsMut::as_mut) {
        let rate = vec3::norm(h.contact.relative(velocities)) + vec3::norm(h.bias);
        scale = scale.max(rate / h.inverse_mass[0][0].max(S::EPSILON));
        h.unyielded = vec3::zero();
    }
    for _ in 0..PRESSED_TIMES {
        let _ = settle(held, (false, yields), scale, inertia, velocities);
        let [left, largest] = yielding(held, yields, scale);
        held.iter_mut().for_each(|h| h.as_mut().keep());
        if left <= fine::<S>(SWEEPS) * largest {
            break;
        }
    }
    let closing = S::from_f64(CLOSING) * scale;
    if held.iter_mut().any(|h| h.as_mut().opens(velocities) < -closing) {
        // Where friction jams, the impulse grows from sweep to sweep until the contact sticks: no extrapolation follows
        // that.
        release(held, inertia, velocities);
        for _ in 0..SOFT_SWEEPS {
            let left = sweep(held, (false, false, S::ZERO), scale, inertia, velocities);
            if left.is_ok_and(|left| left <= fine::<S>(SWEEPS)) {
                break;
            }
        }
    }
}

/// Takes all forces and their effect away.
fn release<S: Scalar>(
    held: &mut [impl AsMut<Held<S>>],
    inertia: &(impl Inertia<S> + ?Sized),
    accelerations: &mut [Twist<S>],
) {
    for h in held.iter_mut().map(AsMut::as_mut) {
        h.contact.push(inertia, accelerations, vec3::scale(h.contact.impulse, -S::ONE));
        (h.contact.impulse, h.unyielded) = (vec3::zero(), vec3::zero());
    }
}

/// Sweeps over contacts that pull or do not and yield; returns whether they came to an end.
fn settle<S: Scalar>(
    held: &mut [impl AsMut<Held<S>>],
    (pulls, yields): (bool, S),
    scale: S,
    inertia: &(impl Inertia<S> + ?Sized),
    accelerations: &mut [Twist<S>],
) -> Result<bool, Unheld> {
    let (mut anderson, mut patience) =
        (Anderson::new(), Patience::new(PATIENCE, S::from_f64(ROUGHEST) * S::EPSILON));
    for number in 0..SWEEPS {
        let left = sweep(held, (true, pulls, yields), scale, inertia, accelerations)?;
        if left <= fine::<S>(number) || patience.ends(number, left) {
            return Ok(true);
        }
        if patience.fails(number, SWEEPS) {
            return Ok(false);
        }
        if number >= PLAIN {
            anderson.record(held);
            anderson.extrapolate(held, inertia, accelerations);
        }
    }
    Ok(false)
}

/// The largest force (N) by which a contact yields, and the largest of all forces.
fn yielding<S: Scalar>(held: &mut [impl AsMut<Held<S>>], yields: S, scale: S) -> [S; 2] {
    let (mut most, mut largest) = (S::ZERO, scale);
    for h in held.iter_mut().map(AsMut::as_mut) {
        let force = h.contact.impulse;
        most = most.max(vec3::norm(vec3::sub(force, h.unyielded)));
        largest = largest.max(vec3::norm(force));
    }
    [yields * most, largest]
}
