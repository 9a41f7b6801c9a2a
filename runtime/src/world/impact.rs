//! Impact of all contacts that strike at one instant, between sides of any kind: Stronge's law, or energy compensation
//! with flexible sides.
//!
//! In: contacts at the instant, velocities before, springs of the flexible bodies. Out: impulses of the contacts,
//! velocities after. Compensation is that of a body on the ground (`contact::compensation`) with all sides free to
//! move:
//! ```text
//! J0 >= 0, W v >= 0, J0 . W v = 0                      e = 0; Q: eta times the kinetic energy that it takes
//! node i of a side, its share b (+ first, - second side):  springs from i to k with w = b d.n > 1e-6 and k not in touch
//!   D_k += w d/m_k;  D_i -= w d/m_i;   then u >= 0 like J0, so that D moves no side into the other: W D >= 0
//! A = D.M D/2;  B = v.M D;  A lambda^2 + B lambda = Q;  v += lambda D;  J = J0 + lambda u
//! ```
//! A contact that stops no more than the rounding of speeds was at rest and is no source of D, or the last digit would
//! decide.
//! The smaller root is taken if B <= 0, J >= 0 and no side enters another, else the larger one. Springs and contacts
//! give opposite impulses along one line, so linear and angular momentum are conserved. Without a spring that could
//! take energy both sides rebound along J0. All contacts of one instant share one lambda.

use crate::contact::compensation::FLATTEST_RECEIVER;
use crate::flexible::Body;
use crate::flexible::element::Element;
use crate::real::Scalar;
use crate::rigid::contact::{Inertia, Point, Twist};
use crate::rigid::law::Kind;
use crate::rigid::plastic::{compensate_all, rub_within, stop};
use crate::rigid::several::strike_all;
use crate::rigid::struck::Struck;
use crate::vec3::{self, Vec3};

/// Rounding errors of speeds, in units of the largest.
const ROUNDING: f64 = 1e3;

/// Data that an impact does not change.
#[derive(Clone, Copy, Debug)]
pub struct Setting<'a, S, I: ?Sized> {
    /// Flexible bodies: their springs pass impulses on.
    pub body: &'a Body<'a, S>,
    /// Positions of the nodes.
    pub pos: &'a [Vec3<S>],
    /// Number of ports: bodies from this number on are nodes.
    pub ports: usize,
    /// Inverse inertia of the bodies.
    pub inertia: &'a I,
}

/// Memory of an impact: as many contacts as strike, two lists with one entry per body.
#[derive(Debug)]
pub struct Spare<'a, S> {
    /// Contacts.
    pub lifts: &'a mut [Struck<S>],
    /// Velocities.
    pub twists: [&'a mut [Twist<S>]; 2],
}

impl<S: Scalar, I: Inertia<S> + ?Sized> Setting<'_, S, I> {
    /// Resolves the impact. `law`: one kind of law with its e for all contacts (compensation: e is the square root of
    /// eta); None: Stronge's law with each contact's own e.
    ///
    /// Returns false if sweeps or integration pieces did not suffice; the rest then ended as with e = 0.
    pub fn strike(
        &self,
        struck: &mut [Struck<S>],
        law: Option<(Kind, S)>,
        twists: &mut [Twist<S>],
        spare: &mut Spare<S>,
    ) -> bool {
        match law {
            Some((Kind::Compensation, e)) => self.compensate(struck, e * e, twists, spare),
            // Newton's law with one e at all points and without friction is compensation with eta = e^2 along the
            // impulses of e = 0.
            Some((Kind::Newton, e)) => compensate_all(struck, e * e, self.inertia, twists).complete,
            _ => strike_all(struck, self.inertia, twists, spare.twists[0]).complete,
        }
    }

    /// Energy compensation along the springs.
    fn compensate(
        &self,
        struck: &mut [Struck<S>],
        eta: S,
        twists: &mut [Twist<S>],
        spare: &mut Spare<S>,
    ) -> bool {
        let Spare { lifts, twists: [field, before] } = spare;
        before.iter_mut().zip(twists.iter()).for_each(|(to, from)| *to = *from);
        struck.iter_mut().for_each(|s| s.contact.impulse = vec3::zero());
        let settled = stop(struck, self.inertia, twists);
        field.fill(Twist::zero());
        let mut receivers = false;
        let fastest = before.iter().fold(S::ZERO, |most, twist| most.max(vec3::norm(twist.velocity)));
        let least = S::from_f64(ROUNDING) * S::EPSILON * fastest;
        self.each_link((struck, least), |[i, k], d, w| {
            receivers = true;
            for (node, impulse) in [(k, w), (i, -w)] {
                let change = vec3::scale(d, impulse * self.body.inverse_mass(node));
                if let Some(twist) = field.get_mut(self.ports + node) {
                    twist.velocity = vec3::add(twist.velocity, change);
                }
            }
        });
        if !receivers {
            twists.iter_mut().zip(before.iter()).for_each(|(to, from)| *to = *from);
            return compensate_all(struck, eta, self.inertia, twists).complete;
        }
        for (lift, s) in lifts.iter_mut().zip(struck.iter()) {
            *lift = *s;
            lift.contact.impulse = vec3::zero();
        }
        let lifts = lifts.get_mut(..struck.len()).unwrap_or_default();
        let lifted = stop(lifts, self.inertia, field);

        let half = S::from_f64(0.5);
        let (mut a, mut b, mut taken) = (S::ZERO, S::ZERO, S::ZERO);
        let between = |list: &[Twist<S>], [i, k]: [usize; 2], d: Vec3<S>| {
            let at =
                |node: usize| list.get(self.ports + node).map_or_else(vec3::zero, |twist| twist.velocity);
            vec3::dot(d, vec3::sub(at(k), at(i)))
        };
        self.each_link((struck, least), |link, d, w| {
            a = a + half * w * between(field, link, d);
            b = b + w * between(twists, link, d);
        });
        for (s, lift) in struck.iter().zip(lifts.iter()) {
            let [j, u] = [s.contact.impulse[0], lift.contact.impulse[0]];
            let [was, now, gains] = [before as &[_], twists, field].map(|list| s.contact.relative(list)[0]);
            taken = taken - half * j * (was + now);
            a = a + half * u * gains;
            b = b + u * now;
        }
        let energy = (eta * taken).max(S::ZERO);
        // Rounding is measured against the largest speed of a point, which may be far above that of approach, and for D
        // against the largest one that the contacts stopped.
        let points = struck.iter().flat_map(|s| s.contact.points().map(|(_, point)| point));
        let speeds = points.filter_map(|point| Some(vec3::norm(before.get(point.body)?.at(point.arm))));
        let stopped = lifts.iter().map(Struck::stopped);
        let sizes = [speeds.fold(S::ZERO, S::max), stopped.fold(S::ZERO, S::max)];
        let lambda = root(a, b, energy, |lambda| {
            let rounding = S::from_f64(ROUNDING) * S::EPSILON * (sizes[0] + lambda.abs() * sizes[1]);
            struck.iter().zip(lifts.iter()).all(|(s, lift)| {
                let [now, gains] = [&*twists, field].map(|list| s.contact.relative(list)[0]);
                let impulse = s.contact.impulse[0] + lambda * lift.contact.impulse[0];
                impulse >= S::ZERO && now + lambda * gains >= -rounding
            })
        });
        for (twist, gain) in twists.iter_mut().zip(field.iter()) {
            twist.velocity = vec3::axpy(twist.velocity, lambda, gain.velocity);
            twist.angular = vec3::axpy(twist.angular, lambda, gain.angular);
        }
        for (s, lift) in struck.iter_mut().zip(lifts.iter()) {
            let sum = s.contact.impulse[0] + lambda * lift.contact.impulse[0];
            s.contact.impulse[0] = sum.max(S::ZERO);
        }
        let rubbed = rub_within(struck, self.inertia, twists);
        settled && lifted && rubbed
    }

    /// Shows the springs from pressed nodes to nodes without contact: both nodes, the direction d, the share w > 0. A
    /// contact that stops no more than `least` (m/s) is not pressed.
    fn each_link(&self, (struck, least): (&[Struck<S>], S), mut show: impl FnMut([usize; 2], Vec3<S>, S)) {
        let touches = |node: usize| {
            let is = |(share, point): (S, &Point<S>)| share != S::ZERO && point.body == self.ports + node;
            struck.iter().any(|s| s.contact.points().any(is))
        };
        self.body.elements().each_link(&mut |[tail, head]| {
            for [i, k] in [[tail, head], [head, tail]] {
                if self.body.inverse_mass(k) <= S::ZERO || !touches(i) || touches(k) {
                    continue;
                }
                let (d, _) = vec3::direction(vec3::sub(vec3::at(self.pos, k), vec3::at(self.pos, i)));
                let mut w = S::ZERO;
                for contact in struck.iter().filter(|s| s.stopped() > least).map(|s| &s.contact) {
                    let own = contact.points().filter(|(_, point)| point.body == self.ports + i);
                    let share =
                        own.fold(S::ZERO, |sum, (share, _)| sum + share) * vec3::dot(d, contact.axes[0]);
                    w = w + if share > S::from_f64(FLATTEST_RECEIVER) { share } else { S::ZERO };
                }
                if w > S::ZERO {
                    show([i, k], d, w);
                }
            }
        });
    }
}

/// Solves A lambda^2 + B lambda = Q, A > 0: the smaller root where it is allowed, else the larger.
fn root<S: Scalar>(a: S, b: S, energy: S, allowed: impl Fn(S) -> bool) -> S {
    if a <= S::ZERO {
        return S::ZERO;
    }
    let two = S::from_f64(2.0);
    let s = (b * b + two * two * a * energy).sqrt();
    if b > S::ZERO {
        return two * energy / (b + s);
    }
    let minus = if b < s { two * energy / (b - s) } else { S::ZERO };
    if allowed(minus) { minus } else { (s - b) / (two * a) }
}
