//! Conjugate gradients over contacts whose sweeps converge too slowly: heavy bodies on light ones, high stacks (Moreau's
//! problem as a quadratic program with bounds: More & Toraldo 1991; Renouf & Alart 2005).
//!
//! In: impulses as sweeps have left them, velocities with these. Out: the same, nearer to a solution.
//! ```text
//! r = w - W v - D (P - P_kept)    of impulses inside their bounds: J > 0, and T of contacts that stick
//! p = r/K + beta p,   P = P + alpha p,   alpha = p.r / p.(G + D) p
//! ```
//! Impulses at a bound stay there, so does the friction of contacts that slide; a step that would leave the bounds ends
//! at the first, which is kept from then on, so that no step adds energy; sweeps say which impulses become free again.
//! Weighed by a mean of K, alike in all directions, redundant impulses change as those of contacts would that yield a
//! little (`sweep`).

use super::detect::Touch;
use crate::real::Scalar;
use crate::rigid::contact::{Inertia, Twist, onto_disc, softness};
use crate::vec3::{self, Vec3};

/// A direction with less than this share of K as inverse mass moves nothing: redundant impulses.
const REDUNDANT: f64 = 1e-13;
/// Impulses nearer to their bound than this share are on it.
const ON_BOUND: f64 = 1e-9;

/// What the steps are about: step size and share by which contacts yield, largest speed and what is rounding of it.
#[derive(Clone, Copy)]
pub(super) struct Task<S> {
    pub(super) how: (S, S),
    pub(super) fastest: S,
    pub(super) rounding: S,
}

/// Takes at most so many steps; returns their number.
pub(super) fn descend<S: Scalar>(
    touches: &mut [Touch<S>],
    task: Task<S>,
    most: usize,
    inertia: &impl Inertia<S>,
    twists: &mut [Twist<S>],
) -> usize {
    touches.iter_mut().for_each(|touch| touch.history.moved = free(touch, task.how.0));
    let mut before = S::ZERO;
    for number in 0..most {
        let (mut square, mut cross, mut worst) = (S::ZERO, S::ZERO, S::ZERO);
        for touch in touches.iter_mut() {
            let (now, weight) = (lacks(touch, task.how, twists), mean(touch));
            square = square + vec3::dot(now, now) / weight;
            cross = cross + vec3::dot(now, touch.history.end) / weight;
            worst = worst.max(vec3::norm(now));
            touch.history.end = now;
        }
        if worst <= task.rounding {
            return number;
        }
        let beta = if before > S::ZERO { ((square - cross) / before).max(S::ZERO) } else { S::ZERO };
        before = square;
        let mut largest = S::ZERO;
        for touch in touches.iter_mut() {
            let now = vec3::scale(touch.history.end, S::ONE / mean(touch));
            let last = if beta > S::ZERO { touch.history.change } else { vec3::zero() };
            touch.history.change = vec3::axpy(now, beta, last);
            largest = largest.max(mean(touch) * vec3::norm(touch.history.change));
        }
        // Pushed so far that its effect does not drown in the rounding of the speeds, and they not in its own.
        let long = (task.fastest / largest).max(S::ONE);
        for touch in touches.iter_mut() {
            give(touch, vec3::scale(touch.history.change, long), inertia, twists);
        }
        let (mut slope, mut curvature, mut size) = (S::ZERO, S::ZERO, S::ZERO);
        for touch in touches.iter() {
            let way = vec3::scale(touch.history.change, long);
            slope = slope + vec3::dot(way, touch.history.end);
            let change = vec3::sub(touch.history.end, lacks(touch, task.how, twists));
            curvature = curvature + vec3::dot(way, change);
            size = size + mean(touch) * vec3::dot(way, way);
        }
        let moves = curvature > S::from_f64(REDUNDANT) * size;
        let whole = if moves { slope / curvature } else { S::ZERO };
        let part = touches.iter().fold(whole, |part, touch| part.min(reach(touch, long)));
        for touch in touches.iter_mut() {
            let stops = part < whole && reach(touch, long) <= part;
            let start = touch.contact.impulse[0] - long * touch.history.change[0];
            give(touch, vec3::scale(touch.history.change, long * (part - S::ONE)), inertia, twists);
            if stops {
                stop(touch, start, inertia, twists);
            }
        }
        if part < whole {
            before = S::ZERO;
        } else if !moves {
            return number + 1;
        }
    }
    most
}

/// Which of the impulses are inside their bounds: 1, else 0.
fn free<S: Scalar>(touch: &Touch<S>, h: S) -> Vec3<S> {
    let [n, x, y] = touch.contact.impulse;
    let radius = touch.contact.friction * n * (S::ONE - S::from_f64(ON_BOUND));
    let acts = touch.wanted(h).is_some() && touch.inverse_mass[0][0] > S::ZERO && n > S::ZERO;
    let sticks = acts && x * x + y * y < radius * radius;
    let [normal, rub] = [acts, sticks].map(|is| if is { S::ONE } else { S::ZERO });
    [normal, rub, rub]
}

/// Velocity that its free impulses have still to give.
fn lacks<S: Scalar>(touch: &Touch<S>, (h, yields): (S, S), twists: &[Twist<S>]) -> Vec3<S> {
    let free = touch.history.moved;
    if free[0] <= S::ZERO {
        return vec3::zero();
    }
    let soft = softness(yields, &touch.inverse_mass);
    let given = vec3::scale(vec3::sub(touch.contact.impulse, touch.unyielded), soft);
    let [n, x, y] = vec3::add(touch.end(twists), given);
    let end = touch.wanted(h).unwrap_or(S::ZERO);
    [free[0] * (end - n), -(free[1] * x), -(free[2] * y)]
}

/// Mean of K in all directions (1/kg), > 0.
fn mean<S: Scalar>(touch: &Touch<S>) -> S {
    let mean = softness(S::ONE, &touch.inverse_mass);
    if mean > S::ZERO { mean } else { S::ONE }
}

/// Adds to the impulse.
fn give<S: Scalar>(touch: &mut Touch<S>, more: Vec3<S>, inertia: &impl Inertia<S>, twists: &mut [Twist<S>]) {
    touch.contact.push(inertia, twists, more);
    touch.contact.impulse = vec3::add(touch.contact.impulse, more);
}

/// Share of the way that was pushed, counted from before, at which the impulse reaches a bound; infinite if it does not.
fn reach<S: Scalar>(touch: &Touch<S>, long: S) -> S {
    let (free, mu, never) = (touch.history.moved, touch.contact.friction, S::from_f64(f64::INFINITY));
    let way = vec3::scale(touch.history.change, long);
    let ([n, x, y], [dn, dx, dy]) = (vec3::sub(touch.contact.impulse, way), way);
    if free[0] <= S::ZERO {
        return never;
    }
    let lifts = if dn < S::ZERO { (n / -dn).max(S::ZERO) } else { never };
    if free[1] <= S::ZERO {
        return lifts;
    }
    // |T + s dT| = mu (J + s dJ): the first s >= 0.
    let (a, b) = (dx * dx + dy * dy - mu * mu * dn * dn, x * dx + y * dy - mu * mu * n * dn);
    let inside = (mu * mu * n * n - x * x - y * y).max(S::ZERO);
    let root = b * b + a * inside;
    let sum = b + root.max(S::ZERO).sqrt();
    if root >= S::ZERO && sum > S::ZERO { lifts.min(inside / sum) } else { lifts }
}

/// Keeps an impulse at the bound that it has reached from this normal impulse.
fn stop<S: Scalar>(touch: &mut Touch<S>, start: S, inertia: &impl Inertia<S>, twists: &mut [Twist<S>]) {
    let ([n, x, y], mu) = (touch.contact.impulse, touch.contact.friction);
    let sticks = touch.history.moved[1] > S::ZERO;
    let lifted = n <= S::from_f64(ON_BOUND) * start;
    let normal = if lifted { S::ZERO } else { n };
    let [p, q] = if sticks || lifted { onto_disc([x, y], mu * normal) } else { [x, y] };
    give(touch, vec3::sub([normal, p, q], touch.contact.impulse), inertia, twists);
    touch.history.moved = if lifted { vec3::zero() } else { [touch.history.moved[0], S::ZERO, S::ZERO] };
}
