//! Impulses of all contacts over a step (Moreau 1988, Jean 1999): Gauss-Seidel sweeps, accelerated where they converge
//! slowly (`anderson`).
//!
//! In: contacts with gap and relative velocity v- at the start, velocities at the end without impulses. Out: impulses,
//! and the velocities v+ with them.
//! ```text
//! 0 <= J,  v_n+ >= w,  J (v_n+ - w) = 0          |T| <= mu J, against the slip that is left
//! e = 0:  w = -max(gap/h, v_n-, 0)               half of the gap closes in this step, the rest by the next middle
//! e > 0:  w = -e v_n- where gap <= 0
//! ```
//! Kinetic energy changes by P . (v- + v+)/2. Its normal part is never positive, because w <= -v_n- (e <= 1). Friction
//! that reverses the slip within a step, or sweeps that stop early, could add a little energy: then the impulses of
//! contacts that feel one another are scaled down until they add none ([`take_no_more`]). So contacts only dissipate,
//! whatever their sides are.
//!
//! Redundant contacts that rub in different directions share their load as if each yielded a little, all alike, as
//! forces do (`rigid::share`): else the order of the sweeps would decide how a box turns on its four corners.

use super::conjugate::{Task, descend};
use super::detect::Touch;
use crate::real::Scalar;
use crate::rigid::anderson::Anderson;
use crate::rigid::contact::{Inertia, Twist, rubbed, softness};
use crate::rigid::share::{REDUNDANT, differ};
use crate::rigid::struck::{Group, asking};
use crate::vec3;

/// Up to this number of contacts, impulses converge to rounding.
pub const FEW: usize = 64;
/// Most sweeps, for few contacts and for many.
const SWEEPS: [usize; 2] = [500, 100];
/// Sweeps before acceleration begins.
const PLAIN: usize = 5;
/// Contradictions between contacts tolerated, relative to the fastest speed, where more contacts stick than can: sweeps
/// then change the impulses by the same amount each time, and the velocities are as close to a solution as they get.
const CONTRADICTION: f64 = 1e-6;
/// Change of the speeds by one sweep at which sweeps over many contacts end, relative to the fastest.
const COARSE: f64 = 1e-9;

/// Change of the speeds by one sweep that is rounding, in rounding units of the speeds of the points in contact.
const ROUNDING: f64 = 16.0;

/// Sweeps that may be slow before conjugate gradients take turns with them, and the sweeps between two turns.
const SLOW: [usize; 2] = [100, 8];
/// Most sweeps and steps over many contacts of rigid parts, which sweeps hand on to one another slowly.
const STACKED: usize = 800;
/// Change of the speeds by a sweep at which sweeps and conjugate gradients end, relative to the fastest.
const CLOSE: f64 = 1e-11;
/// Most steps of conjugate gradients at a time, for each contact, and in all.
const TURN: [usize; 2] = [4, 400];

/// Share of what an impulse gives its bodies by which redundant contacts yield to it.
const YIELDS: f64 = 0.01;
/// Number of times that they yield, each time from the impulses before, so that what is left falls by that share:
/// always as many, because the iteration of a conserving step would not converge on impulses that jump.
const TIMES: usize = 8;

/// How the sweeps went.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Sweeps<S> {
    pub(super) number: usize,
    pub(super) settled: bool,
    /// Change of the speeds by the last sweep, relative to the fastest.
    pub(super) left: S,
}

/// Computes the impulses, starting from those that the contacts have. `twists`: in, velocities without impulses; out,
/// with them.
pub(super) fn sweep<S: Scalar>(
    touches: &mut [Touch<S>],
    h: S,
    ports: usize,
    inertia: &impl Inertia<S>,
    twists: &mut [Twist<S>],
) -> Sweeps<S> {
    let (mut fastest, mut moving) = (S::ZERO, S::ZERO);
    for touch in touches.iter() {
        let speeds = vec3::norm(touch.end(twists)) + vec3::norm(touch.start);
        fastest = fastest.max(speeds + touch.out);
        moving = moving.max(touch.contact.fastest(twists));
    }
    for touch in touches.iter() {
        touch.contact.push(inertia, twists, touch.contact.impulse);
    }
    if touches.is_empty() || fastest <= S::ZERO {
        return Sweeps { number: 0, settled: true, left: S::ZERO };
    }
    // Relative speeds of points that move together are known to the rounding of their own.
    let speeds = [fastest, S::from_f64(ROUNDING) * S::EPSILON * moving];
    // Sweeps over the nodes of a sheet end soon enough.
    let turns = touches.iter().all(|touch| is_rigid(touch, ports));
    let mut slow = SLOW[0];
    if !are_redundant(touches, ports) {
        return settle(touches, (h, S::ZERO), speeds, (turns, &mut slow), inertia, twists);
    }
    // Contacts that yield in the end, too, may contradict one another by rounding, which moves the others for ever.
    touches.iter_mut().for_each(|touch| touch.unyielded = vec3::zero());
    let mut sum = Sweeps { number: 0, settled: true, left: S::ZERO };
    for _ in 0..TIMES {
        let how = (h, S::from_f64(YIELDS));
        let sweeps = settle(touches, how, speeds, (turns, &mut slow), inertia, twists);
        sum = Sweeps { number: sum.number + sweeps.number, ..sweeps };
        touches.iter_mut().for_each(|touch| touch.unyielded = touch.contact.impulse);
    }
    // What yields a little next to a light body yields much next to a heavy one: the rest without yielding.
    let worst = touches.iter().fold(S::ZERO, |worst, touch| worst.max(missing(touch, h, twists)));
    if worst > S::from_f64(CONTRADICTION).max(S::from_f64(64.0) * S::EPSILON) * fastest {
        slow = SLOW[1];
        let sweeps = settle(touches, (h, S::ZERO), speeds, (turns, &mut slow), inertia, twists);
        sum = Sweeps { number: sum.number + sweeps.number, ..sweeps };
    }
    sum
}

/// How far a contact is from its law (m/s), given the impulses of all: the velocity by which its own would change.
fn missing<S: Scalar>(touch: &Touch<S>, h: S, twists: &[Twist<S>]) -> S {
    let (k, before) = (&touch.inverse_mass, touch.contact.impulse);
    let Some(end) = touch.wanted(h).filter(|_| k[0][0] > S::ZERO) else {
        return touch.weight() * vec3::norm(before);
    };
    let [n, x, y] = touch.end(twists);
    let normal = (before[0] + (end - n) / k[0][0]).max(S::ZERO);
    let radius = touch.contact.friction * normal;
    let [p, q] =
        if radius > S::ZERO { rubbed(k, [before[1], before[2]], [x, y], radius) } else { [S::ZERO; 2] };
    touch.weight() * vec3::norm(vec3::sub([normal, p, q], before))
}

/// Whether impulses fit in more than one way, and which are taken makes a difference: contacts of rigid parts that rub
/// in different directions.
fn are_redundant<S: Scalar>(touches: &[Touch<S>], ports: usize) -> bool {
    let rubs = |touch: &&Touch<S>| touch.contact.friction > S::ZERO && is_rigid(touch, ports);
    let slip = |touch: &Touch<S>| {
        vec3::direction(touch.contact.to_inertial([S::ZERO, touch.start[1], touch.start[2]])).0
    };
    touches.iter().filter(rubs).count() >= REDUNDANT && differ(touches.iter().filter(rubs).map(slip))
}

/// Whether a contact is one of rigid parts alone.
fn is_rigid<S: Scalar>(touch: &Touch<S>, ports: usize) -> bool {
    touch.contact.points().all(|(_, point)| point.body < ports)
}

/// Sweeps until the speeds do not change any more, over contacts that yield to their impulses by a share of what these
/// give their bodies. Conjugate gradients take turns with them if `turns`; `slow`: sweeps after which they count as
/// slow; then it is less the next time.
fn settle<S: Scalar>(
    touches: &mut [Touch<S>],
    how: (S, S),
    [fastest, rounding]: [S; 2],
    (turns, slow): (bool, &mut usize),
    inertia: &impl Inertia<S>,
    twists: &mut [Twist<S>],
) -> Sweeps<S> {
    let few = touches.len() <= FEW;
    let (limit, fine) = match (few, turns) {
        (true, _) => (SWEEPS[0], S::from_f64(32.0) * S::EPSILON),
        (false, false) => (SWEEPS[1], S::from_f64(COARSE)),
        (false, true) => (STACKED, S::from_f64(COARSE)),
    };
    let (mut number, mut settled, mut since) = (0, false, 0);
    // What was left before the last turn of conjugate gradients.
    let mut turned = None;
    let (mut left, mut anderson) = (S::ZERO, Anderson::new());
    while number < limit && !settled {
        let (mut moved, mut caused) = (S::ZERO, S::ZERO);
        for touch in touches.iter_mut() {
            let before = touch.contact.impulse;
            moved = moved.max(relax(touch, how, inertia, twists));
            touch.history.moved = vec3::sub(touch.contact.impulse, before);
            caused = caused.max(touch.weight() * vec3::norm(before));
        }
        (number, since) = (number + 1, since + 1);
        left = moved / fastest;
        settled = left <= fine || moved <= rounding;
        if let Some(before) = turned.filter(|_| since >= SLOW[1]) {
            let gains = left <= S::from_f64(0.5) * before;
            settled |= left <= S::from_f64(if gains { CLOSE } else { CONTRADICTION });
        }
        if number >= limit || settled {
            break;
        }
        if turns && since >= *slow {
            let most = (TURN[0] * touches.len()).min(TURN[1]).min(limit - number);
            // Redundant impulses may contradict one another: they change little if all yield to a change, if only so
            // little that the next turn takes that away.
            let yields = if how.1 > S::ZERO { how.1 } else { S::EPSILON.sqrt() };
            if how.1 <= S::ZERO {
                touches.iter_mut().for_each(|touch| touch.unyielded = touch.contact.impulse);
            }
            // Large impulses on both sides of a light body cancel but for their rounding.
            let enough = rounding.max(S::EPSILON * caused).max(fine * fastest) * S::from_f64(0.25);
            let task = Task { how: (how.0, yields), fastest, rounding: enough };
            number += descend(touches, task, most, inertia, twists);
            (since, turned, *slow, anderson) = (0, Some(left), SLOW[1], Anderson::new());
        } else if since > PLAIN {
            let alike = anderson.record(touches).is_some_and(|apart| apart <= fine * fastest);
            settled = alike && left <= S::from_f64(CONTRADICTION);
            if !settled {
                anderson.extrapolate(touches, inertia, twists);
            }
        }
    }
    Sweeps { number, settled, left }
}

/// Solves one contact's impulse with the others held; returns the change of velocity.
fn relax<S: Scalar>(
    touch: &mut Touch<S>,
    (h, yields): (S, S),
    inertia: &impl Inertia<S>,
    twists: &mut [Twist<S>],
) -> S {
    let (mut k, before) = (touch.inverse_mass, touch.contact.impulse);
    let size = touch.weight();
    let Some(end) = touch.wanted(h).filter(|_| k[0][0] > S::ZERO) else {
        touch.contact.push(inertia, twists, vec3::scale(before, -S::ONE));
        touch.contact.impulse = vec3::zero();
        return size * vec3::norm(before);
    };
    // A contact that yields gives way to the impulse that it has more than before.
    let soft = softness(yields, &k);
    (0..3).for_each(|i| k[i][i] = k[i][i] + soft);
    let given = vec3::scale(vec3::sub(before, touch.unyielded), soft);
    let rate = touch.end(twists)[0] + given[0];
    let normal = (before[0] + (end - rate) / k[0][0]).max(S::ZERO);
    touch.contact.push(inertia, twists, [normal - before[0], S::ZERO, S::ZERO]);
    let radius = touch.contact.friction * normal;
    let mut rub = [S::ZERO; 2];
    if radius > S::ZERO {
        let [_, x, y] = vec3::add(touch.end(twists), given);
        rub = rubbed(&k, [before[1], before[2]], [x, y], radius);
    }
    touch.contact.push(inertia, twists, [S::ZERO, rub[0] - before[1], rub[1] - before[2]]);
    touch.contact.impulse = [normal, rub[0], rub[1]];
    size * vec3::norm(vec3::sub(touch.contact.impulse, before))
}

/// A contact's work over the step (J), given the velocities at its end, half that of its impulse at v- + v+: normal
/// part, friction.
fn work<S: Scalar>(touch: &Touch<S>, twists: &[Twist<S>]) -> [S; 2] {
    let [n, x, y] = touch.contact.impulse;
    let [vn, vx, vy] = vec3::scale(vec3::add(touch.start, touch.end(twists)), S::from_f64(0.5));
    [n * vn, x * vx + y * vy]
}

/// That of all contacts.
pub(super) fn works<S: Scalar>(touches: &[Touch<S>], twists: &[Twist<S>]) -> [S; 2] {
    touches.iter().fold([S::ZERO; 2], |[normal, friction], touch| {
        let [own_normal, own_friction] = work(touch, twists);
        [normal + own_normal, friction + own_friction]
    })
}

/// Scales the impulses of contacts that feel one another by one factor s, so that these contacts add no energy together,
/// if they would add some.
///
/// The work of s P is s P . (v- + v*)/2 + s^2 P . G P/2, with v* the velocities without impulses.
pub(super) fn take_no_more<S: Scalar>(
    touches: &mut [Touch<S>],
    ports: usize,
    free: &[Twist<S>],
    inertia: &impl Inertia<S>,
    twists: &mut [Twist<S>],
) {
    let both = |touch: &Touch<S>, twists: &[Twist<S>]| {
        let [normal, friction] = work(touch, twists);
        normal + friction
    };
    // What nothing moves feels nothing.
    let group = |touch: &Touch<S>| if touch.weight() > S::ZERO { Group::Later } else { Group::Done };
    touches.iter_mut().for_each(|touch| touch.group = group(touch));
    // Where none adds energy, no group of them does.
    while let Some(first) =
        touches.iter_mut().find(|touch| touch.group == Group::Later && both(touch, twists) > S::ZERO)
    {
        first.group = Group::Asks;
        gather(touches, ports, inertia);
        let (mut all, mut linear) = (S::ZERO, S::ZERO);
        for touch in touches.iter().filter(|touch| touch.group == Group::Now) {
            all = all + both(touch, twists);
            linear = linear + both(touch, free);
        }
        let square = all - linear;
        let part = if linear < S::ZERO && square > S::ZERO { -(linear / square) } else { S::ZERO };
        for touch in touches.iter_mut().filter(|touch| touch.group == Group::Now) {
            touch.group = Group::Done;
            if all > S::ZERO {
                touch.contact.push(inertia, twists, vec3::scale(touch.contact.impulse, part - S::ONE));
                touch.contact.impulse = vec3::scale(touch.contact.impulse, part);
            }
        }
    }
}

/// Gathers the contacts that feel the impulses of one that asks, directly or through others. Nodes feel one another
/// through springs, later in the step.
fn gather<S: Scalar>(touches: &mut [Touch<S>], ports: usize, inertia: &impl Inertia<S>) {
    // Many contacts of one body in a row ask once.
    let (mut last, mut nodes_asked) = (None, false);
    while touches.iter().any(|touch| touch.group == Group::Asks) {
        for k in 0..touches.len() {
            let Some(asks) = touches.get_mut(k).filter(|touch| touch.group == Group::Asks) else { continue };
            asks.group = Group::Now;
            let (contact, has_nodes) = (asks.contact, !is_rigid(asks, ports));
            if has_nodes && !nodes_asked {
                nodes_asked = true;
                ask(touches, |touch| !is_rigid(touch, ports));
            }
            for (_, at) in contact.points().filter(|(_, point)| point.body < ports) {
                if last == Some(at.body) {
                    continue;
                }
                last = Some(at.body);
                let impulse = asking();
                ask(touches, |touch| {
                    let mut seen = touch.contact.points().filter(|(_, point)| point.body < ports);
                    seen.any(|(_, seen)| inertia.response(at, impulse, seen) != vec3::zero())
                });
            }
        }
    }
}

/// Lets those of the contacts that belong to no group yet ask which feel an impulse.
fn ask<S: Scalar>(touches: &mut [Touch<S>], feels: impl Fn(&Touch<S>) -> bool) {
    for touch in touches.iter_mut().filter(|touch| touch.group == Group::Later) {
        if feels(touch) {
            touch.group = Group::Asks;
        }
    }
}
