//! A lasting contact, and one sweep over several: each takes the force that fits it, given those of all others.
//!
//! In: contacts with their slip, their forces so far, and accelerations with the effect of these. Out: forces and
//! accelerations after the sweep, and how much changed. `hold` repeats sweeps until nothing does, `share` with contacts
//! that yield.

use super::contact::{Contact, Inertia, Twist, onto_disc, rubbed, softness};
use super::history::{History, Swept};
use super::impact::InverseMass;
use crate::real::Scalar;
use crate::vec3::{self, Vec3};

/// Contacts of a rigid body that may turn its slip together: the corners of a face.
pub(crate) const CORNERS: f64 = 4.0;
/// A sliding contact whose normal force changes its own normal acceleration by less than this share of K_nn jams
/// (Painleve).
const JAMMED: f64 = 1e-3;

/// Slip of a contact.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Slip<S> {
    /// Unit direction (t1, t2); zero without friction.
    pub direction: [S; 2],
    /// Speed (m/s).
    pub speed: S,
    /// Step size (s): friction that turns slip faster than a step resolves acts against the slip at its end.
    pub horizon: S,
    /// Contacts that may turn it together.
    pub together: S,
    /// Unit direction against which friction acts.
    against: [S; 2],
}

impl<S: Scalar> Slip<S> {
    /// A slip of this unit direction (0 without friction) and speed in a step of h, before friction turns it.
    #[must_use]
    pub fn new(direction: [S; 2], speed: S, horizon: S, together: S) -> Self {
        Slip { direction, speed, horizon, together, against: direction }
    }

    /// The slip of a contact that has this relative velocity in N now; where no more than `least` of it is left along
    /// its `first` direction it has reversed: at rest in that direction, so that its end is found.
    pub(crate) fn now(
        contact: &Contact<S>,
        [velocity, first]: [Vec3<S>; 2],
        least: S,
        (horizon, together): (S, S),
    ) -> Self {
        let lasts = vec3::dot(velocity, first) > least;
        let [_, x, y] = vec3::apply(&contact.axes, if lasts { velocity } else { first });
        let ([_, x, y], speed) = vec3::direction([S::ZERO, x, y]);
        Slip::new([x, y], if lasts { speed } else { S::ZERO }, horizon, together)
    }
}

/// A lasting contact.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Held<S> {
    /// Geometry and mu; its impulse is a force here (N).
    pub contact: Contact<S>,
    /// K.
    pub inverse_mass: InverseMass<S>,
    /// W' u: the part of the relative acceleration that does not depend on accelerations, along n, t1, t2 (m/s^2).
    pub bias: Vec3<S>,
    /// None where the contact sticks.
    pub slip: Option<Slip<S>>,
    /// The force at which a contact that yields has not given way (N).
    pub(super) unyielded: Vec3<S>,
    /// History of the sweeps over it.
    pub(crate) history: History<S>,
}

impl<S: Scalar> Held<S> {
    /// A contact that sticks, with its K and W' u.
    #[must_use]
    pub fn new(contact: Contact<S>, inverse_mass: InverseMass<S>, bias: Vec3<S>) -> Self {
        Held { contact, inverse_mass, bias, slip: None, unyielded: vec3::zero(), history: History::empty() }
    }
}

/// Why the forces were not found.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Unheld {
    /// More normal force would press a sliding contact together (Painleve), or nothing can move there.
    Jammed,
    /// The sweeps did not converge.
    Unbalanced,
}

impl<S> AsMut<Held<S>> for Held<S> {
    fn as_mut(&mut self) -> &mut Held<S> {
        self
    }
}

impl<S: Scalar, T: AsMut<Held<S>>> Swept<S> for T {
    fn parts(&mut self) -> (&mut Contact<S>, S, &mut History<S>) {
        let Held { contact, inverse_mass: [[a, ..], [_, b, _], [.., c]], history, .. } = self.as_mut();
        (contact, a.max(*b).max(*c), history)
    }
}

/// What forces are sought.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Sought<S> {
    /// Whether normal forces may be negative, for callers that locate the time of release.
    pub pulls: bool,
    /// Whether redundant contacts may contradict one another somewhat, because their accelerations are differences.
    pub rough: bool,
    /// Acceleration (m/s^2) that counts as zero.
    pub least: S,
}

/// One sweep: whether friction turns, whether contacts pull, how much they yield. Returns its largest change relative
/// to the largest force or `scale`.
pub(super) fn sweep<S: Scalar>(
    held: &mut [impl AsMut<Held<S>>],
    how: (bool, bool, S),
    scale: S,
    inertia: &(impl Inertia<S> + ?Sized),
    accelerations: &mut [Twist<S>],
) -> Result<S, Unheld> {
    let (mut moved, mut largest) = (S::ZERO, scale);
    for h in held.iter_mut().map(AsMut::as_mut) {
        let before = h.contact.impulse;
        h.update(how, inertia, accelerations)?;
        h.history.moved = vec3::sub(h.contact.impulse, before);
        moved = moved.max(vec3::norm(h.history.moved));
        largest = largest.max(vec3::norm(h.contact.impulse));
    }
    Ok(if moved > S::ZERO { moved / largest } else { S::ZERO })
}

impl<S: Scalar> Held<S> {
    /// Force (N) that would end the tangential acceleration left by friction on its limit, given all accelerations with
    /// the effect of the forces.
    pub(crate) fn missing(&self, accelerations: &[Twist<S>]) -> S {
        let [_, x, y] = self.acceleration(accelerations);
        let [_, [_, a, _], [.., c]] = self.inverse_mass;
        let size = a.max(c);
        if size > S::ZERO { (x * x + y * y).sqrt() / size } else { S::ZERO }
    }

    /// Force (N) that would end the normal acceleration with which the contact opens, given all accelerations with the
    /// effect of the forces.
    pub(crate) fn opens(&self, accelerations: &[Twist<S>]) -> S {
        self.acceleration(accelerations)[0] / self.inverse_mass[0][0]
    }

    /// Changes the force so that it fits the contact, given those of all others.
    fn update(
        &mut self,
        (turns, pulls, yields): (bool, bool, S),
        inertia: &(impl Inertia<S> + ?Sized),
        accelerations: &mut [Twist<S>],
    ) -> Result<(), Unheld> {
        let bodies = self.acceleration(accelerations);
        let [_, x, y] = bodies;
        let mu = self.contact.friction;
        if let Some(slip) = self.slip.filter(|_| turns) {
            self.slip = Some(Slip { against: self.turned(&slip, [x, y]), ..slip });
        }
        let direction = self.slip.map(|slip| slip.against);
        let ([[k, kx, ky], ..], [n, tx, ty]) = (self.inverse_mass, self.contact.impulse);
        // Sliding, friction on the rim changes the normal acceleration too.
        let rigid = direction.map_or(k, |[x, y]| k - mu * (kx * x + ky * y));
        if k <= S::ZERO || rigid <= S::from_f64(JAMMED) * k {
            return Err(Unheld::Jammed);
        }
        let soft = softness(yields, &self.inverse_mass);
        let normal = n - self.yielding(bodies, soft)[0] / (rigid + soft);
        let normal = if pulls { normal } else { normal.max(S::ZERO) };
        let radius = mu * normal;
        let [x, y] = direction.map_or_else(
            || onto_disc([tx, ty], radius.max(S::ZERO)),
            |[x, y]| [-(radius * x), -(radius * y)],
        );
        self.set([normal, x, y], inertia, accelerations);
        if direction.is_none() && radius > S::ZERO {
            let [_, a, b] = self.yielding(self.acceleration(accelerations), soft);
            let mut k = self.inverse_mass;
            (k[1][1], k[2][2]) = (k[1][1] + soft, k[2][2] + soft);
            let [x, y] = rubbed(&k, [x, y], [a, b], radius);
            self.set([normal, x, y], inertia, accelerations);
        }
        Ok(())
    }

    /// Yields no more to its present force.
    pub(super) fn keep(&mut self) {
        self.unyielded = self.contact.impulse;
    }

    /// Relative acceleration along n, t1, t2.
    fn acceleration(&self, accelerations: &[Twist<S>]) -> Vec3<S> {
        vec3::add(self.contact.relative(accelerations), self.bias)
    }

    /// Adds to the acceleration of the bodies that by which the contact yields to its force: `soft` (1/kg) of it.
    fn yielding(&self, bodies: Vec3<S>, soft: S) -> Vec3<S> {
        vec3::axpy(bodies, soft, vec3::sub(self.contact.impulse, self.unyielded))
    }

    /// Direction against which friction acts, given the tangential acceleration.
    ///
    /// Friction R turns slip of speed s at the rate `R k/s`, k the inverse mass across it: no explicit step follows a
    /// slow slip. There the direction is that of the slip after tau = h - s/(j R k), with j contacts together, which
    /// limits the rate to about 1/h; a slip fast enough, or on a straight line, keeps its own.
    fn turned(&self, slip: &Slip<S>, [ax, ay]: [S; 2]) -> [S; 2] {
        let ([x, y], [_, [_, a, b], [_, _, c]]) = (slip.direction, self.inverse_mass);
        let [n, tx, ty] = self.contact.impulse;
        let (radius, k) = (self.contact.friction * n, a * y * y - S::from_f64(2.0) * b * x * y + c * x * x);
        let ahead = slip.horizon - slip.speed / (slip.together * radius * k);
        if !(ahead > S::ZERO && radius > S::ZERO) {
            return [x, y];
        }
        let (across, along) = (ay * x - ax * y, (ax * x + ay * y).max(S::ZERO));
        let free = across - k * (ty * x - tx * y);
        let (_, after) = vec3::direction([S::ZERO, slip.speed + ahead * along, ahead * across]);
        let sine = (ahead * free / (after + ahead * k * radius)).max(-S::ONE).min(S::ONE);
        let cosine = (S::ONE - sine * sine).sqrt();
        [cosine * x - sine * y, cosine * y + sine * x]
    }

    fn set(&mut self, force: Vec3<S>, inertia: &(impl Inertia<S> + ?Sized), accelerations: &mut [Twist<S>]) {
        self.contact.push(inertia, accelerations, vec3::sub(force, self.contact.impulse));
        self.contact.impulse = force;
    }
}
