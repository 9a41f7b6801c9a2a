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
//! (`anderson`: a box on a smaller one). Where contacts are redundant (a box on four
//! corners) forces are not unique, but accelerations are.

use super::anderson::Ahead;
use super::contact::{Contact, Inertia, Twist, onto_disc};
use super::impact::InverseMass;
use super::several::rubbed;
use super::trail::{Swept, Trail};
use crate::real::Scalar;
use crate::vec3::{self, Vec3};

/// Most sweeps.
const SWEEPS: usize = 1000;
/// Sweeps before acceleration begins.
pub(crate) const PLAIN: usize = 30;
/// A sliding contact whose normal force changes its own normal acceleration by less than this share of K_nn jams
/// (Painleve).
const JAMMED: f64 = 1e-3;

/// A lasting contact.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Held<S> {
    /// Geometry and mu; its impulse is a force here (N).
    pub contact: Contact<S>,
    /// K.
    pub inverse_mass: InverseMass<S>,
    /// W' u: the part of the relative acceleration that does not depend on accelerations, along n, t1, t2 (m/s^2).
    pub bias: Vec3<S>,
    /// Unit direction of slip (t1, t2); None where the contact sticks.
    pub slip: Option<[S; 2]>,
    /// History of the sweeps over it.
    pub(crate) trail: Trail<S>,
}

impl<S: Scalar> Held<S> {
    /// A contact that sticks, with its K and W' u.
    #[must_use]
    pub fn new(contact: Contact<S>, inverse_mass: InverseMass<S>, bias: Vec3<S>) -> Self {
        Held { contact, inverse_mass, bias, slip: None, trail: Trail::empty() }
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
    fn parts(&mut self) -> (&mut Contact<S>, S, &mut Trail<S>) {
        let Held { contact, inverse_mass: [[a, ..], [_, b, _], [.., c]], trail, .. } = self.as_mut();
        (contact, a.max(*b).max(*c), trail)
    }
}

/// Computes the forces and adds their effect to the accelerations.
///
/// Sweeps start from the forces that the contacts have; `accelerations` must not contain these yet.
///
/// # Errors
/// [`Unheld`]; forces and accelerations are then those of the last sweep.
pub fn hold<S: Scalar>(
    held: &mut [impl AsMut<Held<S>>],
    inertia: &(impl Inertia<S> + ?Sized),
    accelerations: &mut [Twist<S>],
) -> Result<(), Unheld> {
    // Scale of the forces, even where they nearly cancel: those that would stop the initial accelerations.
    let mut scale = S::ZERO;
    for h in held.iter_mut().map(AsMut::as_mut) {
        let acceleration = vec3::norm(h.contact.relative(accelerations)) + vec3::norm(h.bias);
        scale = scale.max(acceleration / h.inverse_mass[0][0]);
    }
    for h in held.iter_mut().map(AsMut::as_mut) {
        h.contact.push(inertia, accelerations, h.contact.impulse);
    }
    let (mut left, mut ahead) = (S::ZERO, Ahead::new());
    for number in 0..SWEEPS {
        let (mut moved, mut largest) = (S::ZERO, scale);
        for h in held.iter_mut().map(AsMut::as_mut) {
            let before = h.contact.impulse;
            let goes = match h.slip {
                Some(direction) => slide(h, direction, inertia, accelerations),
                None => rest(h, inertia, accelerations),
            };
            if !goes {
                return Err(Unheld::Jammed);
            }
            h.trail.moved = vec3::sub(h.contact.impulse, before);
            moved = moved.max(vec3::norm(h.trail.moved));
            largest = largest.max(vec3::norm(h.contact.impulse));
        }
        if moved <= fine::<S>(number) * largest {
            return Ok(());
        }
        left = moved / largest;
        if (PLAIN..SWEEPS - 1).contains(&number) {
            ahead.note(held);
            ahead.go_on(held, inertia, accelerations);
        }
    }
    // Where contacts are redundant, rounding keeps changing forces that cancel one another.
    if left <= S::from_f64(0.01) * S::EPSILON.sqrt() { Ok(()) } else { Err(Unheld::Unbalanced) }
}

/// Change of the forces by a sweep at which sweeps end, relative to the largest. Extrapolation stirs rounding: it never
/// settles to the last digit.
pub(crate) fn fine<S: Scalar>(number: usize) -> S {
    S::from_f64(if number < PLAIN { 4.0 } else { 64.0 }) * S::EPSILON
}

/// Normal force of a sliding contact with friction on the rim, against the slip. Returns false if it jams.
fn slide<S: Scalar>(
    h: &mut Held<S>,
    [x, y]: [S; 2],
    inertia: &(impl Inertia<S> + ?Sized),
    accelerations: &mut [Twist<S>],
) -> bool {
    let mu = h.contact.friction;
    let [k, kx, ky] = h.inverse_mass[0];
    let yields = k - mu * (kx * x + ky * y);
    if yields <= S::from_f64(JAMMED) * k {
        return false;
    }
    let acceleration = h.contact.relative(accelerations)[0] + h.bias[0];
    let normal = (h.contact.impulse[0] - acceleration / yields).max(S::ZERO);
    set(h, [normal, -(mu * normal * x), -(mu * normal * y)], inertia, accelerations);
    true
}

/// Normal force, then the friction that prevents slip as far as the cone allows. Returns false if nothing can move.
fn rest<S: Scalar>(
    h: &mut Held<S>,
    inertia: &(impl Inertia<S> + ?Sized),
    accelerations: &mut [Twist<S>],
) -> bool {
    if h.inverse_mass[0][0] <= S::ZERO {
        return false;
    }
    let [n, x, y] = h.contact.impulse;
    let acceleration = h.contact.relative(accelerations)[0] + h.bias[0];
    let normal = (n - acceleration / h.inverse_mass[0][0]).max(S::ZERO);
    let radius = h.contact.friction * normal;
    let [x, y] = onto_disc([x, y], radius);
    set(h, [normal, x, y], inertia, accelerations);
    if radius > S::ZERO {
        let [_, a, b] = vec3::add(h.contact.relative(accelerations), h.bias);
        let [x, y] = rubbed(&h.inverse_mass, [x, y], [a, b], radius);
        set(h, [normal, x, y], inertia, accelerations);
    }
    true
}

fn set<S: Scalar>(
    h: &mut Held<S>,
    force: Vec3<S>,
    inertia: &(impl Inertia<S> + ?Sized),
    accelerations: &mut [Twist<S>],
) {
    h.contact.push(inertia, accelerations, vec3::sub(force, h.contact.impulse));
    h.contact.impulse = force;
}
