//! Forces of contacts that last (thesis Eq. 4.1): they press as long as they must, stick within the cone, slide on its rim.
//!
//! In: accelerations without contact forces, contacts with their velocities and W' u. Out: forces N, T and the accelerations.
//! ```text
//! G lambda = -(W M^-1 f + W' u) where a contact holds:   0 <= N, 0 <= g'', N g'' = 0
//! sliding: T = -mu N v_t/|v_t|          resting: |T| <= mu N, against the acceleration it cannot stop
//! ```
//! By Gauss and Seidel's method, contact after contact, to the last digits; where contacts outnumber what determines them
//! (a box on four corners) the accelerations are still unique.

use super::contact::{Contact, Inertia, Twist, onto_disc};
use super::impact::InverseMass;
use super::several::rubbed;
use crate::real::Scalar;
use crate::vec3::{self, Vec3};

/// Sweeps at most.
const SWEEPS: usize = 1000;
/// A sliding contact whose normal force moves its own normal acceleration less than this share of K_nn jams (Painleve).
const JAMMED: f64 = 1e-3;

/// A contact that lasts.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Held<S> {
    /// Its geometry and mu; its impulse is a force here (N).
    pub contact: Contact<S>,
    /// K.
    pub inverse_mass: InverseMass<S>,
    /// W' u: relative acceleration n, t1, t2 that comes without accelerations (m/s^2).
    pub bias: Vec3<S>,
    /// Unit direction of slip (t1, t2), or none at rest.
    pub slip: Option<[S; 2]>,
}

impl<S> AsMut<Held<S>> for Held<S> {
    fn as_mut(&mut self) -> &mut Held<S> {
        self
    }
}

/// Finds the forces and adds what they do to the accelerations. False: they did not settle.
///
/// Forces that the contacts already have are where the sweeps start; `accelerations` must not contain them yet.
pub fn hold<S: Scalar>(
    held: &mut [impl AsMut<Held<S>>],
    inertia: &(impl Inertia<S> + ?Sized),
    accelerations: &mut [Twist<S>],
) -> bool {
    // The forces' size, also where they all but cancel: what would stop the accelerations to begin with.
    let mut scale = S::ZERO;
    for h in held.iter_mut().map(AsMut::as_mut) {
        let acceleration = vec3::norm(h.contact.relative(accelerations)) + vec3::norm(h.bias);
        scale = scale.max(acceleration / h.inverse_mass[0][0]);
    }
    for h in held.iter_mut().map(AsMut::as_mut) {
        h.contact.push(inertia, accelerations, h.contact.impulse);
    }
    let mut left = S::ZERO;
    for _ in 0..SWEEPS {
        let (mut moved, mut largest) = (S::ZERO, scale);
        for h in held.iter_mut().map(AsMut::as_mut) {
            let before = h.contact.impulse;
            let goes = match h.slip {
                Some(direction) => slide(h, direction, inertia, accelerations),
                None => rest(h, inertia, accelerations),
            };
            if !goes {
                return false;
            }
            moved = moved.max(vec3::norm(vec3::sub(h.contact.impulse, before)));
            largest = largest.max(vec3::norm(h.contact.impulse));
        }
        if moved <= S::from_f64(4.0) * S::EPSILON * largest {
            return true;
        }
        left = moved / largest;
    }
    // Where contacts outnumber what determines them, rounding keeps moving forces that cancel.
    left <= S::from_f64(0.01) * S::EPSILON.sqrt()
}

/// Normal force with friction on the rim, against the slip. False: it jams.
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

/// Normal force, then friction that stops the slip from starting as far as the cone allows. False: nothing can move.
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
