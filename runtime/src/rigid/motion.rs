//! Free rotation that conserves energy and angular momentum to rounding (Simo & Wong 1991), of order 4 (Suzuki 1990).
//!
//! With m = J W the angular momentum in body axes, a step of Cayley's rotation by h W~ takes m_0 to m_1 with
//! ```text
//! m_1 - m_0 = -h W~ x m~,   m~ = (m_0 + m_1)/2 = J W~      so    J W~ + h/2 W~ x J W~ = m_0
//! ```
//! W~ . (m_1 - m_0) = 0: energy is conserved; the momentum in N is state and not recomputed at all. Five such steps of
//! suitable lengths give order 4. A step too long for the iteration is split.

use super::attitude::Attitude;
use super::{RigidBody, RigidState};
use crate::real::Scalar;
use crate::vec3::{self, Vec3};

/// Largest angle (rad) of one application of the map.
const LARGEST_TURN: f64 = 0.5;
/// Most parts of a step.
const PARTS: u32 = 1 << 20;
/// Newton iterations: they start within a tenth of the root and converge quadratically.
const ITERATIONS: usize = 5;

/// The largest moment of inertia (kg m^2) may be between this and its inverse: products of three are numbers in f32,
/// too.
const SIZE: f64 = 65536.0;
/// So many changes by [`SIZE`]^2 bring any f64 there.
const SIZES: usize = 34;

/// A step that rotates the body too far, or after which a number is not finite.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct TooFast;

/// Advances by h (s) under a constant force and moment (N, N m, in N); exact for the centre of mass.
///
/// # Errors
/// [`TooFast`] where h times the angular velocity exceeds half a million radians, or where a number of the state at the
/// end would not be finite; the state is unchanged.
pub fn advance<S: Scalar>(
    body: &RigidBody<S>,
    state: &mut RigidState<S>,
    force: Vec3<S>,
    moment: Vec3<S>,
    h: S,
) -> Result<(), TooFast> {
    let half = S::from_f64(0.5) * h;
    let kicked = vec3::axpy(state.angular_momentum, half, moment);
    let attitude = rotate(body, state.attitude, kicked, h)?;
    let acceleration = vec3::scale(force, S::ONE / body.mass);
    let mean = vec3::axpy(state.velocity, half, acceleration);
    let end = RigidState {
        position: vec3::axpy(state.position, h, mean),
        velocity: vec3::axpy(state.velocity, h, acceleration),
        attitude,
        angular_momentum: vec3::axpy(kicked, half, moment),
    };
    if !end.is_finite() {
        return Err(TooFast);
    }
    *state = end;
    Ok(())
}

/// The attitude after h (s) of free rotation with the angular momentum `momentum` (in N).
///
/// # Errors
/// As for [`advance`].
pub fn rotate<S: Scalar>(
    body: &RigidBody<S>,
    attitude: Attitude<S>,
    momentum: Vec3<S>,
    h: S,
) -> Result<Attitude<S>, TooFast> {
    // Suzuki's p = 1/(4 - 4^(1/3)): steps p, p, 1 - 4 p, p, p.
    const P: f64 = 0.414_490_771_794_375_7;
    const STEPS: [f64; 5] = [P, P, 1.0 - 4.0 * P, P, P];
    // No rotation is faster than |m| over the smallest moment of inertia.
    let (inertia, momentum) = brought_to_size(body.inertia, momentum);
    let [a, b, c] = inertia;
    let fastest = vec3::norm(momentum) / a.min(b).min(c) * h.abs();
    let parts = parts_of(fastest).ok_or(TooFast)?;
    let (body, mut attitude, mut part) = (RigidBody { inertia, ..*body }, attitude, 0);
    let length = h / count::<S>(parts);
    while part < parts {
        for step in STEPS {
            attitude = turn(&body, attitude, momentum, S::from_f64(step) * length);
        }
        part += 1;
    }
    Ok(attitude)
}

/// Inertia and momentum, both times the power of two that brings the largest moment of inertia between 1/[`SIZE`] and
/// [`SIZE`]: a body turns by their quotient, to the same bits.
fn brought_to_size<S: Scalar>(mut inertia: Vec3<S>, mut momentum: Vec3<S>) -> (Vec3<S>, Vec3<S>) {
    let (size, up, down) = (S::from_f64(SIZE), S::from_f64(SIZE * SIZE), S::from_f64(1.0 / (SIZE * SIZE)));
    for _ in 0..SIZES {
        let [a, b, c] = inertia;
        let largest = a.max(b).max(c);
        let (is_small, is_large) = (largest * size < S::ONE, largest > size);
        if !(is_small || is_large) {
            break;
        }
        let factor = if is_small { up } else { down };
        (inertia, momentum) = (vec3::scale(inertia, factor), vec3::scale(momentum, factor));
    }
    (inertia, momentum)
}

/// Number of parts for a rotation by this angle (rad); None where it is too large or not finite.
fn parts_of<S: Scalar>(angle: S) -> Option<u32> {
    let mut parts = 1;
    let mut reach = S::from_f64(LARGEST_TURN);
    if !angle.is_finite() {
        return None;
    }
    while angle > reach {
        if parts >= PARTS {
            return None;
        }
        parts *= 2;
        reach = reach + reach;
    }
    Some(parts)
}

/// A power of two as a scalar.
fn count<S: Scalar>(parts: u32) -> S {
    let (mut value, mut n) = (S::ONE, 1);
    while n < parts {
        value = value + value;
        n *= 2;
    }
    value
}

/// One rotation by Cayley's map, of order 2.
fn turn<S: Scalar>(body: &RigidBody<S>, attitude: Attitude<S>, momentum: Vec3<S>, h: S) -> Attitude<S> {
    let half = S::from_f64(0.5) * h;
    let target = attitude.to_body(momentum);
    let mut w = body.body_rate(target);
    for _ in 0..ITERATIONS {
        w = vec3::sub(w, newton_correction(body.inertia, w, target, half));
    }
    attitude.turned(vec3::scale(w, half))
}

/// Newton's correction for J w + half w x J w = target: the residual over its Jacobian J + half ([w] J - [J w]).
fn newton_correction<S: Scalar>(inertia: Vec3<S>, w: Vec3<S>, target: Vec3<S>, half: S) -> Vec3<S> {
    let ([a, b, c], [x, y, z]) = (inertia, w);
    let momentum = [a * x, b * y, c * z];
    let residual = vec3::sub(vec3::axpy(momentum, half, vec3::cross(w, momentum)), target);
    // (w x J w)_1 = (c - b) y z and so on: the Jacobian's rows.
    let (f, g, k) = (half * (c - b), half * (a - c), half * (b - a));
    solve([[a, f * z, f * y], [g * z, b, g * x], [k * y, k * x, c]], residual)
}

/// Solves a 3 x 3 system by Cramer's rule.
fn solve<S: Scalar>(rows: [Vec3<S>; 3], right: Vec3<S>) -> Vec3<S> {
    let [r0, r1, r2] = rows;
    let (c0, c1, c2) = (vec3::cross(r1, r2), vec3::cross(r2, r0), vec3::cross(r0, r1));
    let over = S::ONE / vec3::dot(r0, c0);
    let [x, y, z] = right;
    vec3::scale(vec3::axpy(vec3::axpy(vec3::scale(c0, x), y, c1), z, c2), over)
}
