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

use super::contact::{Contact, Inertia, Twist, onto_disc, solve_tangential};
use super::impact::{InverseMass, Touch, resolve};
use crate::ode::root::locate;
use crate::real::Scalar;
use crate::vec3;

/// Most pieces of one impact; the rest is then resolved with e = 0.
const PIECES: usize = 10_000;
/// Length of a piece in units of 1/sqrt(sum of K_nn). Impulses are as exact as its square: 2e-4 for three balls in a row.
const PIECE: f64 = 0.04;
/// Most friction sweeps of one piece: stopped early, friction still opposes slip within its cone.
const RUBS: usize = 60;
/// Most sweeps for the normal impulses of e = 0.
const SWEEPS: usize = 2000;
/// Closing speeds below this share of the fastest do not start to push any more: less than the error of the pieces. What is
/// left of them at the end is stopped.
const SLOWEST: f64 = 1e-6;
/// Restitution coefficients below this do not shorten pieces: the end of the contact is located anyway.
const SOFTEST: f64 = 0.05;

/// A contact during an impact.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Struck<S> {
    /// The contact; its impulse is the result.
    pub contact: Contact<S>,
    /// The contact's inverse mass matrix K.
    inverse_mass: InverseMass<S>,
    /// E (J), stored.
    stored: S,
    /// Of the piece on trial: E after it, its impulse, the relative velocity before it.
    trial: S,
    /// Positive before the contact ends within the piece, negative beyond: E, or with e = 0 the energy that closing takes.
    lasts: S,
    piece: vec3::Vec3<S>,
    before: vec3::Vec3<S>,
    /// Whether it has ended at the end of the piece.
    ended: bool,
    /// Friction per normal impulse in the last piece, from which the next one starts.
    ratio: [S; 2],
}

/// Result of an impact at several points.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Outcome {
    /// Number of pieces.
    pub pieces: usize,
    /// Whether the pieces sufficed; if not, the rest ended as with e = 0.
    pub complete: bool,
}

impl<S: Scalar> Struck<S> {
    /// A contact that takes part, with its inverse mass.
    #[must_use]
    pub fn new(contact: Contact<S>, inertia: &(impl Inertia<S> + ?Sized)) -> Struck<S> {
        let inverse_mass = contact.inverse_mass(inertia);
        let zero = vec3::zero();
        let (piece, before, ratio) = (zero, zero, [S::ZERO; 2]);
        Struck {
            contact,
            inverse_mass,
            stored: S::ZERO,
            trial: S::ZERO,
            lasts: S::ZERO,
            piece,
            before,
            ended: false,
            ratio,
        }
    }

    /// The speed that its normal impulse alone would stop (m/s).
    pub(crate) fn stopped(&self) -> S {
        self.contact.impulse[0] * self.inverse_mass[0][0]
    }

    /// Whether it pushes, or starts to.
    fn active(&self, closing: S) -> bool {
        self.stored > S::ZERO || self.before[0] < -closing
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

    /// E after the normal velocity has changed from `before` to v over the impulse of the piece.
    fn charge(&self, v: S) -> S {
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
        if returned <= S::ZERO {
            charged
        } else if self.contact.restitution > S::ZERO {
            charged - returned * self.unloading()
        } else {
            // e = 0 gives nothing back: the contact ends where v_n changes sign.
            -returned
        }
    }
}

/// Resolves the impact of all these contacts at once; contacts that open or rest take part if others close them.
///
/// One contact alone is resolved in closed form ([`resolve`]). `twists` and the contacts' impulses are changed;
/// `spare` is working memory, one entry per body.
pub fn strike_all<S: Scalar>(
    struck: &mut [Struck<S>],
    inertia: &(impl Inertia<S> + ?Sized),
    twists: &mut [Twist<S>],
    spare: &mut [Twist<S>],
) -> Outcome {
    let mut fastest = S::ZERO;
    for s in struck.iter_mut() {
        s.before = s.contact.relative(twists);
        (s.contact.impulse, s.stored, s.ratio) = (vec3::zero(), S::ZERO, [S::ZERO; 2]);
        fastest = fastest.max(-s.before[0]);
    }
    if let [only] = struck {
        strike_one(only, inertia, twists);
        return Outcome { pieces: 1, complete: true };
    }
    let rounding = S::from_f64(64.0) * S::EPSILON;
    let closing = rounding.max(S::from_f64(SLOWEST)) * fastest;
    let (mut pieces, mut complete) = (0, false);
    while pieces < PIECES && !complete {
        match piece_length(struck, closing) {
            Some(length) => {
                shorten(struck, inertia, twists, spare, length, closing);
                accept(struck, twists, spare);
                pieces += 1;
            }
            None => complete = true,
        }
    }
    if !complete || struck.iter().any(|s| s.before[0] < -(rounding * fastest)) {
        // Whether or not the sweeps were enough: what is left is slow, or the impact was cut short.
        let _ = stop(struck, inertia, twists);
    }
    Outcome { pieces, complete }
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
    let mut least = |tau: S| {
        try_piece(struck, inertia, twists, spare, tau, closing);
        struck.iter().filter(|s| s.piece[0] > S::ZERO).fold(S::ONE / S::EPSILON, |m, s| m.min(s.lasts))
    };
    if least(length) >= S::ZERO {
        return;
    }
    // At length 0 nothing has been given back.
    let guard = |tau: S| if tau > S::ZERO { least(tau) } else { S::ZERO };
    // As fine as friction is: its rounding would keep a finer search going.
    let found = locate(guard, S::ZERO, length, S::EPSILON.sqrt() * length);
    let (before, beyond) = found.unwrap_or((length, length));
    try_piece(struck, inertia, twists, spare, beyond, closing);
    for s in struck.iter_mut() {
        s.ended = s.piece[0] > S::ZERO && s.lasts < S::ZERO;
    }
    // Up to there none has given back more than it had.
    try_piece(struck, inertia, twists, spare, before, closing);
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
        s.trial = s.charge(v);
        // E of a contact that gives nothing back jumps to 0 where v_n changes sign.
        s.lasts = if s.contact.restitution > S::ZERO { s.trial } else { -(v * s.piece[0]) };
    }
}

/// Accepts the piece; contacts that have given back all their energy end.
fn accept<S: Scalar>(struck: &mut [Struck<S>], twists: &mut [Twist<S>], spare: &[Twist<S>]) {
    twists.iter_mut().zip(spare).for_each(|(to, from)| *to = *from);
    // A contact that ended at the same time as another keeps a rounding error of E, which is no energy.
    let rounding = S::from_f64(256.0) * S::EPSILON;
    for s in struck.iter_mut() {
        let ended = core::mem::take(&mut s.ended) || s.trial <= rounding * s.stored;
        s.stored = if ended { S::ZERO } else { s.trial };
        s.contact.impulse = vec3::add(s.contact.impulse, s.piece);
        let [normal, x, y] = s.piece;
        s.ratio = if normal > S::ZERO { [x / normal, y / normal] } else { [S::ZERO; 2] };
        s.before = s.contact.relative(twists);
    }
}

/// Friction of a piece, against the slip at its end, in the cone of its normal impulse; by Gauss-Seidel sweeps.
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
            let next = rubbed(&s.inverse_mass, [s.piece[1], s.piece[2]], [x, y], radius);
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
    // If sweeps that stopped early would add energy, the piece has no friction.
    let work = |s: &Struck<S>| {
        let [_, x, y] = s.contact.relative(twists);
        let half = S::from_f64(0.5);
        half * (s.piece[1] * (x + s.before[1]) + s.piece[2] * (y + s.before[2]))
    };
    if struck.iter().fold(S::ZERO, |sum, s| sum + work(s)) > S::ZERO {
        for s in struck.iter_mut().filter(|s| presses(s)) {
            let back = [S::ZERO, -s.piece[1], -s.piece[2]];
            s.contact.push(inertia, twists, back);
            (s.piece[1], s.piece[2]) = (S::ZERO, S::ZERO);
        }
    }
}

/// One contact's friction for the slip that is left: the one that stops it, or one on the rim of the friction disc.
pub(super) fn rubbed<S: Scalar>(k: &InverseMass<S>, at: [S; 2], slip: [S; 2], radius: S) -> [S; 2] {
    let [x, y] = solve_tangential(k, slip);
    let rest = [at[0] - x, at[1] - y];
    if rest[0] * rest[0] + rest[1] * rest[1] <= radius * radius {
        return rest;
    }
    // Projected gradient step, its length the inverse of a bound on the larger eigenvalue.
    let step = S::ONE / (k[1][1] + k[2][2]).max(S::EPSILON);
    onto_disc([at[0] - step * slip[0], at[1] - step * slip[1]], radius)
}

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
