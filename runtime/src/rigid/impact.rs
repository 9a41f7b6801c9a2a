//! Impact with friction at one point, along the normal impulse (thesis Eqs. 4.2 to 4.4, 4.14 to 4.26; Stronge 1990,
//! 2000).
//!
//! In: the relative velocity v with which two bodies meet at the point (along n, t1, t2; v_n < 0 closing), the inverse
//! mass matrix K at the point (v = v_0 + K P), friction mu, energetic restitution e. Out: the impulse P on the body
//! to which n points, and its works.
//!
//! Idea: the normal impulse p replaces time. Each phase has its own law for the tangential impulse:
//! ```text
//! slip   dP_t = -mu v_t/|v_t| dp                          the direction may swerve (`swerve`)
//! stick  dP_t = -K_tt^-1 K_tn dp                          while that is inside the cone
//! work   dW_n = v_n dp;  compression ends at v_n = 0 with W_c;  restitution where W_n = (1 - e^2) W_c   (Eq. 4.4)
//! ```
//! While the direction of slip is constant, v is linear and W quadratic in p, so such a phase is solved in closed form.
//! Friction's work is -mu |v_t| dp <= 0 and W_n <= 0 at the end, so no impact creates energy, for e from 0 to 1
//! and mu >= 0. The caller sees to these ranges, which [`Law`](super::law::Law) checks.

use super::swerve;
use super::touch::{BISECTIONS, Progress, slip_of};
pub use super::touch::{InverseMass, Touch};
use crate::real::Scalar;
use crate::vec3::{self, Vec3};

/// Most phases with one direction of slip: compression and restitution, before and after slip ends; a few to spare.
const PHASES: usize = 8;

/// Result of an impact.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Impact<S> {
    /// P (N s) along n, t1, t2; zero if the bodies are not closing.
    pub impulse: Vec3<S>,
    /// Normal impulse at the end of compression (N s).
    pub compression: S,
    /// W_c, work of the normal force in compression (J), <= 0.
    pub compression_work: S,
    /// W_n, work of the normal force (J), <= 0.
    pub normal_work: S,
    /// W_t, work of friction (J), <= 0.
    pub friction_work: S,
}

/// Phase at a point of the work-impulse curve (Fig. 4.2).
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Stage {
    /// The bodies meet.
    Collision,
    /// v_n < 0.
    Compression,
    /// v_n > 0.
    Restitution,
}

/// A point of the work-impulse curve; the impulse grows from one to the next.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CurvePoint<S> {
    /// Normal impulse p (N s).
    pub impulse: S,
    /// Relative velocity: n, t1, t2 (m/s).
    pub velocity: Vec3<S>,
    /// Normal work so far (J).
    pub work: S,
    /// The phase at this point.
    pub stage: Stage,
}

impl<S: Scalar> Progress<S> {
    fn point(&self, stage: Stage) -> CurvePoint<S> {
        CurvePoint { impulse: self.impulse[0], velocity: self.velocity, work: self.normal_work(), stage }
    }

    fn stage(&self) -> Stage {
        if self.compression.is_some() { Stage::Restitution } else { Stage::Compression }
    }
}

/// Resolves the impact; bodies that are not closing get no impulse.
#[must_use]
pub fn resolve<S: Scalar>(touch: &Touch<S>) -> Impact<S> {
    trace(touch, |_| {})
}

/// Resolves the impact and shows the ends of its phases and of the steps within, in the order of the impulse.
pub fn trace<S: Scalar>(touch: &Touch<S>, mut show: impl FnMut(CurvePoint<S>)) -> Impact<S> {
    let mut at =
        Progress { impulse: vec3::zero(), velocity: touch.velocity, work: S::ZERO, compression: None };
    show(at.point(Stage::Collision));
    if touch.velocity[0] < S::ZERO {
        let mut ended =
            touch.friction > S::ZERO && swerve::advance(touch, &mut at, |at| show(at.point(at.stage())));
        for _ in 0..PHASES {
            if ended {
                break;
            }
            ended = advance_straight(touch, &mut at);
            show(at.point(at.stage()));
        }
    }
    let (compression, compression_work) = at.compression.unwrap_or((S::ZERO, S::ZERO));
    Impact {
        impulse: at.impulse,
        compression,
        compression_work,
        normal_work: at.normal_work(),
        friction_work: total_work(touch, at.impulse) - at.normal_work(),
    }
}

/// v_0.P + P.K P/2: the change of kinetic energy (Eq. 4.2).
fn total_work<S: Scalar>(touch: &Touch<S>, impulse: Vec3<S>) -> S {
    let change = vec3::apply(&touch.inverse_mass, impulse);
    vec3::dot(impulse, vec3::axpy(touch.velocity, S::from_f64(0.5), change))
}

/// One phase of constant dP/dp, to its end: v_n = 0, end of slip, or end of the work. Returns true if the impact is
/// over.
fn advance_straight<S: Scalar>(touch: &Touch<S>, at: &mut Progress<S>) -> bool {
    let (rate, slips) = impulse_rate(touch, at.velocity);
    let change = vec3::apply(&touch.inverse_mass, rate);
    let (direction, slip) = slip_of(at.velocity);
    // Slip along -rate: its speed changes by the part of K rate along the direction of slip.
    let mut step = S::ZERO;
    let mut end = End::None;
    let mut first = |p: S, kind: End| {
        if p >= S::ZERO && (end == End::None || p < step) {
            (step, end) = (p, kind);
        }
    };
    // Without friction nothing changes where slip passes through 0.
    if slip > S::ZERO && touch.friction > S::ZERO {
        let slowing = -(direction[0] * change[1] + direction[1] * change[2]);
        if slowing > S::ZERO {
            first(slip / slowing, End::Slip);
        }
    }
    if at.velocity[0] < S::ZERO && change[0] > S::ZERO {
        first(-at.velocity[0] / change[0], End::Compression);
    }
    if at.velocity[0] >= S::ZERO
        && let Some(left) = at.work_left(touch.restitution)
    {
        // v_n p + (K rate)_n p^2/2 = the rest of -e^2 W_c: the smaller root, without cancellation.
        let left = left.max(S::ZERO);
        let square = at.velocity[0] * at.velocity[0] + S::from_f64(2.0) * change[0] * left;
        if left <= S::ZERO {
            first(S::ZERO, End::Restitution);
        } else if square >= S::ZERO && at.velocity[0] + square.sqrt() > S::ZERO {
            first(S::from_f64(2.0) * left / (at.velocity[0] + square.sqrt()), End::Restitution);
        } else if change[0] < S::ZERO {
            first(-at.velocity[0] / change[0], End::Recompression);
        }
    }
    let half = S::from_f64(0.5);
    at.work = at.work + step * (at.velocity[0] + half * change[0] * step);
    at.impulse = vec3::axpy(at.impulse, step, rate);
    at.velocity = vec3::axpy(at.velocity, step, change);
    if !slips || end == End::Slip {
        // Sticking is exact: a rounding error must not be taken for slip.
        (at.velocity[1], at.velocity[2]) = (S::ZERO, S::ZERO);
    }
    match end {
        End::Compression => at.compressed(),
        End::Recompression => at.compresses_again(),
        // Slip and compression may end at once, up to rounding.
        End::Slip if at.compression.is_none() && at.velocity[0] >= S::ZERO => at.compressed(),
        End::Slip | End::Restitution | End::None => {}
    }
    matches!(end, End::Restitution | End::None)
}

/// Why a phase ends.
#[derive(Clone, Copy, PartialEq, Eq)]
enum End {
    None,
    Slip,
    Compression,
    /// v_n fell to 0 again before the work was done (slip drives the bodies together).
    Recompression,
    Restitution,
}

/// dP/dp and whether the point slips: by Coulomb's law for the present slip, or for the motion that starts from rest.
fn impulse_rate<S: Scalar>(touch: &Touch<S>, velocity: Vec3<S>) -> (Vec3<S>, bool) {
    let mu = touch.friction;
    let (direction, slip) = slip_of(velocity);
    if slip > S::ZERO || mu <= S::ZERO {
        return ([S::ONE, -(mu * direction[0]), -(mu * direction[1])], true);
    }
    let [_, [kx, a, b], [ky, _, c]] = touch.inverse_mass;
    let determinant = a * c - b * b;
    let hold = [-(c * kx - b * ky) / determinant, -(a * ky - b * kx) / determinant];
    if hold[0] * hold[0] + hold[1] * hold[1] <= mu * mu {
        return ([S::ONE, hold[0], hold[1]], false);
    }
    let e = direction_of_departure(touch);
    ([S::ONE, -(mu * e[0]), -(mu * e[1])], true)
}

/// Direction in which a point at rest starts to slip: (mu K_tt + lambda) e = K_tn with lambda > 0 and |e| = 1.
///
/// |e| decreases with lambda from above 1 to 0, so there is one root, found by bisection to the last bit.
fn direction_of_departure<S: Scalar>(touch: &Touch<S>) -> [S; 2] {
    let (mu, half) = (touch.friction, S::from_f64(0.5));
    let [_, [kx, a, b], [ky, _, c]] = touch.inverse_mass;
    let solve = |lambda: S| {
        let (a, b, c) = (mu * a + lambda, mu * b, mu * c + lambda);
        let determinant = a * c - b * b;
        [(c * kx - b * ky) / determinant, (a * ky - b * kx) / determinant]
    };
    let length = |e: [S; 2]| (e[0] * e[0] + e[1] * e[1]).sqrt();
    // |e| <= |K_tn|/lambda, so the root lies below |K_tn|.
    let (mut low, mut high) = (S::ZERO, length([kx, ky]));
    for _ in 0..BISECTIONS {
        let middle = half * (low + high);
        if length(solve(middle)) > S::ONE { low = middle } else { high = middle }
    }
    let e = solve(high);
    let size = length(e);
    [e[0] / size, e[1] / size]
}
