//! Impact at several points at once (Liu, Zhao & Brogliato 2008, contacts of equal stiffness; Stronge's restitution).
//!
//! In: bodies and their contacts at the instant of impact. Out: impulses, and the twists after.
//!
//! Each contact is a spring of stiffness 1 on a time scale of its own, with force F = sqrt(2 E) and stored energy E, so
//! the longer one pushes, the larger its share of the impulse. Over a short piece of the impact, with dP at all
//! contacts simultaneously,
//! ```text
//! dE_j = -(int of v_n < 0) dP_j - (int of v_n > 0) dP_j / e_j^2          restitution gives e^2 of what compression took
//! ```
//! v is linear in dP, so the energy balance is exact for any length of the piece; a piece ends where the first E_j
//! becomes 0. Every E >= 0 and friction opposes slip, so no impact creates energy, whatever e, mu and the shapes.

use super::contact::{Inertia, Twist, rubbed, stopping};
use super::impact::{Touch, resolve};
use super::plastic::stop;
use super::struck::{Group, Outcome, Struck, asking};
use crate::ode::root::reach;
use crate::real::Scalar;
use crate::vec3;

/// Most pieces of one impact; the rest is then resolved with e = 0.
const PIECES: usize = 10_000;
/// Length of a piece in units of 1/sqrt(sum of K_nn). Impulses are as exact as its square: 1e-4 for three balls in a
/// row; where a contact begins to push within a piece they are off by some 1e-4, too.
const PIECE: f64 = 0.0297;
/// Length of a piece in which friction may stop a slip, relative to the others.
const STOPPING: f64 = 0.5;
/// Most friction sweeps of one piece: stopped early, friction still opposes slip within its cone.
const RUBS: usize = 60;
/// Closing speeds below this share of the fastest do not start to push any more: less than the error of the pieces.
/// What is left of them at the end is stopped.
const SLOWEST: f64 = 1e-6;
/// Restitution coefficients below this do not shorten pieces: the end of the contact is located anyway.
const SOFTEST: f64 = 0.05;
/// Share of the energy of a contact that is a rounding error, in rounding units.
const ROUNDED: f64 = 256.0;

impl<S: Scalar> Struck<S> {
    /// Whether it pushes, or starts to.
    fn active(&self, closing: S) -> bool {
        self.group == Group::Now && (self.stored > S::ZERO || self.before[0] < -closing)
    }

    /// The stiffness of the unloading spring, 1/e^2.
    fn unloading(&self) -> S {
        let e = self.contact.restitution;
        S::ONE / (e * e)
    }

    /// The normal impulse of a piece of this length, by the force in the middle of the piece.
    fn press(&self, length: S, closing: S) -> S {
        if !self.active(closing) {
            return S::ZERO;
        }
        let half = S::from_f64(0.5);
        let force = (S::from_f64(2.0) * self.stored).sqrt();
        let rate = self.before[0];
        if rate < S::ZERO {
            return length * (force - half * length * rate);
        }
        // At least half of the force: the end of the contact is then located where E becomes 0.
        let fallen = if self.contact.restitution > S::ZERO {
            force - half * length * rate * self.unloading()
        } else {
            S::ZERO
        };
        length * fallen.max(half * force)
    }

    /// Whether friction may stop its slip within a piece of this length.
    fn stops_within(&self, length: S, closing: S) -> bool {
        let [_, x, y] = self.before;
        let slip = (x * x + y * y).sqrt();
        let [_, [_, a, _], [_, _, b]] = self.inverse_mass;
        slip > closing && slip < self.contact.friction * self.press(length, closing) * a.max(b)
    }

    /// E after the normal velocity has changed from `before` to v over the impulse of the piece, and how much the
    /// contact still lasts: from 1 down to 0 where it ends.
    fn charge(&self, v: S) -> [S; 2] {
        let (u, impulse, half) = (self.before[0], self.piece[0], S::from_f64(0.5));
        // Integrals over the piece of the parts of v_n below and above 0.
        let (closing, parting) = if u <= S::ZERO && v <= S::ZERO {
            (half * (u + v), S::ZERO)
        } else if u >= S::ZERO && v >= S::ZERO {
            (S::ZERO, half * (u + v))
        } else {
            let (low, high) = (u.min(v), u.max(v));
            let over = half / (high - low);
            (-(low * low * over), high * high * over)
        };
        let charged = self.stored - closing * impulse;
        let returned = parting * impulse;
        let lasts = |left: S, all: S| if all > S::ZERO { left / all } else { S::ONE };
        if self.contact.restitution > S::ZERO {
            let left = if returned > S::ZERO { charged - returned * self.unloading() } else { charged };
            [left, lasts(left, charged)]
        } else {
            // e = 0 gives nothing back: the contact ends where v_n changes sign.
            [if returned > S::ZERO { -returned } else { charged }, lasts(-v, u.abs().max(v.abs()))]
        }
    }
}

/// Resolves the impact of all these contacts at once; contacts that open or rest take part if others close them.
///
/// Contacts that do not feel one another's impulses are resolved apart, one contact alone in closed form
/// ([`resolve`]). `twists` and the contacts' impulses are changed; `spare` is working memory, one entry per body.
pub fn strike_all<S: Scalar>(
    struck: &mut [Struck<S>],
    inertia: &(impl Inertia<S> + ?Sized),
    twists: &mut [Twist<S>],
    spare: &mut [Twist<S>],
) -> Outcome {
    for s in struck.iter_mut() {
        s.before = s.contact.relative(twists);
        (s.contact.impulse, s.stored, s.ratio) = (vec3::zero(), S::ZERO, [S::ZERO; 2]);
        s.group = Group::Later;
    }
    let (mut all, mut rests) = (Outcome { pieces: 0, complete: true }, true);
    while gather(struck, inertia, spare) {
        let own = || struck.iter().filter(|s| s.group == Group::Now);
        let fastest = own().fold(S::ZERO, |most, s| most.max(-s.before[0]));
        let rounding = S::from_f64(64.0) * S::EPSILON * fastest;
        if own().count() == 1 {
            if let Some(only) = struck.iter_mut().find(|s| s.group == Group::Now && s.before[0] < S::ZERO) {
                strike_one(only, inertia, twists);
                all.pieces += 1;
            }
        } else {
            let closing = rounding.max(S::from_f64(SLOWEST) * fastest);
            let done = strike_group(struck, inertia, twists, spare, closing);
            all = Outcome { pieces: all.pieces + done.pieces, complete: all.complete && done.complete };
            rests &= !struck.iter().any(|s| s.group == Group::Now && s.before[0] < -rounding);
        }
        struck.iter_mut().filter(|s| s.group == Group::Now).for_each(|s| s.group = Group::Done);
    }
    if !all.complete || !rests {
        // Whether or not the sweeps were enough: what is left is slow, or the impact was cut short.
        let _ = stop(struck, inertia, twists);
    }
    all
}

/// Takes the next contacts that may feel one another's impulses, directly or through others; false if none is left.
fn gather<S: Scalar>(
    struck: &mut [Struck<S>],
    inertia: &(impl Inertia<S> + ?Sized),
    spare: &mut [Twist<S>],
) -> bool {
    let Some(first) = struck.iter_mut().find(|s| s.group == Group::Later) else { return false };
    first.group = Group::Asks;
    while let Some(at) = struck.iter().position(|s| s.group == Group::Asks) {
        let Some(asks) = struck.get_mut(at) else { break };
        asks.group = Group::Now;
        let contact = asks.contact;
        if !struck.iter().any(|s| s.group == Group::Later) {
            continue;
        }
        spare.fill(Twist::zero());
        contact.push(inertia, spare, asking());
        for other in struck.iter_mut().filter(|s| s.group == Group::Later) {
            // What is rounding of a shared inverse inertia makes no group.
            if vec3::norm(other.contact.relative(spare)) > S::EPSILON * other.inverse_mass[0][0] {
                other.group = Group::Asks;
            }
        }
    }
    true
}

/// Resolves the impact of the contacts of a group.
fn strike_group<S: Scalar>(
    struck: &mut [Struck<S>],
    inertia: &(impl Inertia<S> + ?Sized),
    twists: &mut [Twist<S>],
    spare: &mut [Twist<S>],
    closing: S,
) -> Outcome {
    for pieces in 0..PIECES {
        let Some(length) = piece_length(struck, closing) else {
            return Outcome { pieces, complete: true };
        };
        // The error of a piece in which a slip stops is of its length.
        let stops = struck.iter().any(|s| s.stops_within(length, closing));
        let length = if stops { S::from_f64(STOPPING) * length } else { length };
        shorten(struck, inertia, twists, spare, length, closing);
        accept(struck, twists, spare);
    }
    Outcome { pieces: PIECES, complete: false }
}

fn strike_one<S: Scalar>(
    only: &mut Struck<S>,
    inertia: &(impl Inertia<S> + ?Sized),
    twists: &mut [Twist<S>],
) {
    let contact = &mut only.contact;
    let impact = resolve(&Touch {
        inverse_mass: only.inverse_mass,
        velocity: only.before,
        friction: contact.friction,
        restitution: contact.restitution,
    });
    contact.impulse = impact.impulse;
    contact.push(inertia, twists, impact.impulse);
}

/// The length of the next piece; None when no contact pushes any more.
fn piece_length<S: Scalar>(struck: &[Struck<S>], closing: S) -> Option<S> {
    let mut sum = S::ZERO;
    for s in struck.iter().filter(|s| s.active(closing)) {
        let unloads = s.before[0] > S::ZERO && s.contact.restitution > S::from_f64(SOFTEST);
        sum = sum + s.inverse_mass[0][0] * if unloads { s.unloading() } else { S::ONE };
    }
    (sum > S::ZERO).then(|| S::from_f64(PIECE) / sum.sqrt())
}

/// Tries the piece, shortened to where the first contact has given back all its energy.
fn shorten<S: Scalar>(
    struck: &mut [Struck<S>],
    inertia: &(impl Inertia<S> + ?Sized),
    twists: &[Twist<S>],
    spare: &mut [Twist<S>],
    length: S,
    closing: S,
) {
    let near = S::from_f64(ROUNDED) * S::EPSILON;
    let mut least = |tau: S| {
        try_piece(struck, inertia, twists, spare, tau, closing);
        struck.iter().filter(|s| s.piece[0] > S::ZERO).fold(S::ONE, |least, s| least.min(s.lasts)) - near
    };
    let last = least(length);
    if last >= -near {
        return;
    }
    // At length 0 nothing has been given back.
    let guard = |tau: S| match tau {
        tau if tau <= S::ZERO => S::ONE,
        tau if tau >= length => last,
        tau => least(tau),
    };
    // As fine as friction is: its rounding would keep a finer search going.
    let (before, beyond) =
        reach(guard, [S::ZERO, length], S::EPSILON.sqrt() * length, near).unwrap_or((length, length));
    try_piece(struck, inertia, twists, spare, beyond, closing);
    for s in struck.iter_mut() {
        s.ended = s.piece[0] > S::ZERO && s.lasts <= S::from_f64(2.0) * near;
    }
    // Up to there none has given back more than it had.
    if before < beyond {
        try_piece(struck, inertia, twists, spare, before, closing);
    }
}

/// Tries a piece of this length: impulses, velocities after it in `spare`, stored energies after it.
fn try_piece<S: Scalar>(
    struck: &mut [Struck<S>],
    inertia: &(impl Inertia<S> + ?Sized),
    twists: &[Twist<S>],
    spare: &mut [Twist<S>],
    length: S,
    closing: S,
) {
    spare.iter_mut().zip(twists).for_each(|(to, from)| *to = *from);
    for s in struck.iter_mut() {
        let (normal, [x, y]) = (s.press(length, closing), s.ratio);
        s.piece = [normal, x * normal, y * normal];
        s.contact.push(inertia, spare, s.piece);
    }
    rub(struck, inertia, spare);
    for s in struck.iter_mut() {
        let v = s.contact.relative(spare)[0];
        [s.trial, s.lasts] = s.charge(v);
    }
}

/// Accepts the piece; contacts that have given back all their energy end.
fn accept<S: Scalar>(struck: &mut [Struck<S>], twists: &mut [Twist<S>], spare: &[Twist<S>]) {
    twists.iter_mut().zip(spare).for_each(|(to, from)| *to = *from);
    // A contact that ended at the same time as another keeps a rounding error of E, which is no energy.
    let rounding = S::from_f64(ROUNDED) * S::EPSILON;
    for s in struck.iter_mut() {
        let ended = core::mem::take(&mut s.ended) || s.trial <= rounding * s.stored;
        s.stored = if ended { S::ZERO } else { s.trial };
        s.contact.impulse = vec3::add(s.contact.impulse, s.piece);
        let [normal, x, y] = s.piece;
        s.ratio = if normal > S::ZERO { [x / normal, y / normal] } else { [S::ZERO; 2] };
        s.before = s.contact.relative(twists);
    }
}

/// Friction of a piece in the cone of its normal impulse, by Gauss-Seidel sweeps: it stops the slip where it can, else
/// it acts against the mean of the slips before and after, so that it takes the work mu P |mean slip|.
fn rub<S: Scalar>(struck: &mut [Struck<S>], inertia: &(impl Inertia<S> + ?Sized), twists: &mut [Twist<S>]) {
    let presses = |s: &Struck<S>| s.contact.friction > S::ZERO && s.piece[0] > S::ZERO;
    if !struck.iter().any(presses) {
        return;
    }
    for _ in 0..RUBS {
        let mut moved = S::ZERO;
        for s in struck.iter_mut().filter(|s| presses(s)) {
            let radius = s.contact.friction * s.piece[0];
            let [_, x, y] = s.contact.relative(twists);
            let own = [s.piece[1], s.piece[2]];
            let next = stopping(&s.inverse_mass, own, [x, y], radius)
                .unwrap_or_else(|| rubbed(&s.inverse_mass, own, [x + s.before[1], y + s.before[2]], radius));
            let change = [S::ZERO, next[0] - s.piece[1], next[1] - s.piece[2]];
            (s.piece[1], s.piece[2]) = (next[0], next[1]);
            s.contact.push(inertia, twists, change);
            moved = moved.max((change[1].abs() + change[2].abs()) / radius);
        }
        // Finer than the error of the piece itself.
        if moved <= S::EPSILON.sqrt() {
            break;
        }
    }
    // If sweeps that stopped early would add energy, the piece has no friction. The work of one that sticks is rounding.
    let half = S::from_f64(0.5);
    let (mut work, mut rounding) = (S::ZERO, S::ZERO);
    for s in struck.iter().filter(|s| presses(s)) {
        let ([_, x, y], [_, p, q]) = (s.contact.relative(twists), s.piece);
        work = work + half * (p * (x + s.before[1]) + q * (y + s.before[2]));
        let speed = vec3::norm(s.before) + (S::from_f64(2.0) * s.stored * s.inverse_mass[0][0]).sqrt();
        rounding = rounding + S::from_f64(ROUNDED) * S::EPSILON * (p.abs() + q.abs()) * speed;
    }
    if work > rounding {
        for s in struck.iter_mut().filter(|s| presses(s)) {
            let back = [S::ZERO, -s.piece[1], -s.piece[2]];
            s.contact.push(inertia, twists, back);
            (s.piece[1], s.piece[2]) = (S::ZERO, S::ZERO);
        }
    }
}
