//! Slip whose direction changes: the part of an impact without closed form (Keller 1986; Bhatt & Koechling 1995).
//!
//! With d tau = dp/|v_t| in place of time the equations are smooth up to the end of slip,
//! ```text
//! P_n' = s,   P_t' = -mu v_t,   W' = v_n s,   v = v_0 + K P,   s = |v_t|
//! ```
//! and their Taylor series follow from one recurrence. A step is as long as the last terms of the series allow; v_n = 0
//! and the end of the work are roots of its polynomials. The direction tends to an invariant one; from there on, or
//! once slip is below rounding, the straight phases of `impact` take over.

use super::touch::{BISECTIONS, Progress, Touch, slip_of};
use crate::real::Scalar;
use crate::vec3;

/// Terms of the series.
const TERMS: usize = 24;
/// Most steps; each covers a good part of the rotation of the slip that is left.
const STEPS: usize = 400;

/// Advances until the direction of slip is constant (false) or the impact is over (true).
pub(super) fn advance<S: Scalar>(
    touch: &Touch<S>,
    at: &mut Progress<S>,
    mut show: impl FnMut(&Progress<S>),
) -> bool {
    let scale = vec3::norm(touch.velocity);
    for _ in 0..STEPS {
        let (_, slip) = slip_of(at.velocity);
        if slip <= S::EPSILON * scale {
            (at.velocity[1], at.velocity[2]) = (S::ZERO, S::ZERO);
            return false;
        }
        if keeps_direction(touch, at.velocity) {
            return false;
        }
        let ended = advance_step(touch, at, &Series::new(touch, at));
        show(at);
        if ended {
            return true;
        }
    }
    false
}

/// One step of the series, shortened to v_n = 0 or to the end of the work. Returns true if the impact is over.
fn advance_step<S: Scalar>(touch: &Touch<S>, at: &mut Progress<S>, series: &Series<S>) -> bool {
    let step = series.step();
    let rate = |tau: S| value(&series.n, tau);
    let Some(left) = at.work_left(touch.restitution) else {
        let reaches = rate(step) >= S::ZERO;
        series.apply(at, if reaches { root(rate, step) } else { step });
        if reaches {
            at.compressed();
        }
        return false;
    };
    // v_n may fall to 0 again in restitution: the bodies compress again.
    let falls = rate(step) < S::ZERO;
    let step = if falls { root(|tau| -rate(tau), step) } else { step };
    let missing = |tau: S| value(&series.work, tau) - left;
    if missing(step) >= S::ZERO {
        series.apply(at, root(missing, step));
        return true;
    }
    series.apply(at, step);
    if falls {
        at.compresses_again();
    }
    false
}

/// Whether slip keeps its direction: the part of K dP/dp across it is no more than rounding.
fn keeps_direction<S: Scalar>(touch: &Touch<S>, velocity: vec3::Vec3<S>) -> bool {
    let ([x, y], _) = slip_of(velocity);
    let change = vec3::apply(&touch.inverse_mass, [S::ONE, -(touch.friction * x), -(touch.friction * y)]);
    let [_, [kx, a, b], [ky, _, c]] = touch.inverse_mass;
    let size = kx.abs() + ky.abs() + touch.friction * (a + c + b.abs());
    (x * change[2] - y * change[1]).abs() <= S::from_f64(4.0) * S::EPSILON * size
}

/// The point in (0, step] where f rises through 0, by bisection to the last bit.
fn root<S: Scalar>(f: impl Fn(S) -> S, step: S) -> S {
    let half = S::from_f64(0.5);
    let (mut low, mut high) = (S::ZERO, step);
    for _ in 0..BISECTIONS {
        let middle = half * (low + high);
        if f(middle) < S::ZERO { low = middle } else { high = middle }
    }
    high
}

/// Taylor coefficients in tau / scale of velocity, normal impulse and work. Over the scale 1/(|K| (1 + mu)) the
/// velocity changes by about its own size, whatever the masses: the last coefficients neither overflow nor vanish.
struct Series<S> {
    n: [S; TERMS],
    x: [S; TERMS],
    y: [S; TERMS],
    impulse: [S; TERMS],
    work: [S; TERMS],
    friction: S,
    scale: S,
}

impl<S: Scalar> Series<S> {
    fn new(touch: &Touch<S>, at: &Progress<S>) -> Series<S> {
        let (none, friction) = ([S::ZERO; TERMS], touch.friction);
        let entries = touch.inverse_mass.as_flattened().iter();
        let scale = S::ONE / (entries.fold(S::ZERO, |sum, entry| sum + entry.abs()) * (S::ONE + friction));
        let mut series = Series { n: none, x: none, y: none, impulse: none, work: none, friction, scale };
        let (mut slip, mut count) = (none, S::ZERO);
        let mut term = at.velocity;
        for k in 0..TERMS {
            (series.n[k], series.x[k], series.y[k]) = (term[0], term[1], term[2]);
            slip[k] = slip_term(&series.x, &series.y, &slip, k);
            count = count + S::ONE;
            let rate = [slip[k], -(friction * term[1]), -(friction * term[2])];
            let next = vec3::scale(rate, scale / count);
            let power = scale * convolution(&series.n, &slip, k) / count;
            // The last coefficient has no successor.
            if let (Some(impulse), Some(work)) = (series.impulse.get_mut(k + 1), series.work.get_mut(k + 1)) {
                (*impulse, *work) = (next[0], power);
            }
            term = vec3::apply(&touch.inverse_mass, next);
        }
        series
    }

    /// The step for which the last terms of v_t are rounding: (epsilon |v_t| / |term|)^(1/order).
    fn step(&self) -> S {
        let size = |k: usize| slip_of([S::ZERO, self.x[k], self.y[k]]).1;
        let order = S::from_f64((TERMS - 1) as f64);
        let last = size(TERMS - 1).max(size(TERMS - 2) * size(1) / size(0));
        // The first term bounds the step where the last ones happen to vanish.
        let by_first = size(0) / size(1);
        if last > S::ZERO {
            ((S::EPSILON * size(0) / last).ln() / order).exp().min(by_first)
        } else {
            by_first
        }
    }

    fn apply(&self, at: &mut Progress<S>, tau: S) {
        // P_t = -mu times the integral of v_t.
        let [mut x, mut y] = [S::ZERO; 2];
        let mut count = order_of::<S>();
        for (vx, vy) in self.x.iter().zip(&self.y).rev() {
            (x, y) = (x * tau + *vx / count, y * tau + *vy / count);
            count = count - S::ONE;
        }
        let sideways = -(self.friction * self.scale * tau);
        at.impulse = vec3::add(at.impulse, [value(&self.impulse, tau), sideways * x, sideways * y]);
        at.work = at.work + value(&self.work, tau);
        at.velocity = [value(&self.n, tau), value(&self.x, tau), value(&self.y, tau)];
    }
}

/// The number of terms.
fn order_of<S: Scalar>() -> S {
    S::from_f64(TERMS as f64)
}

/// Value of a polynomial at tau.
fn value<S: Scalar>(terms: &[S; TERMS], tau: S) -> S {
    terms.iter().rev().fold(S::ZERO, |sum, term| sum * tau + *term)
}

/// Coefficient k of the product of two series.
fn convolution<S: Scalar>(a: &[S; TERMS], b: &[S; TERMS], k: usize) -> S {
    let pairs = a.iter().take(k + 1).zip(b.iter().take(k + 1).rev());
    pairs.fold(S::ZERO, |sum, (a, b)| sum + *a * *b)
}

/// Coefficient k of s from s s = v_t . v_t, given the lower ones; entry k itself is still 0.
fn slip_term<S: Scalar>(x: &[S; TERMS], y: &[S; TERMS], s: &[S; TERMS], k: usize) -> S {
    let square = convolution(x, x, k) + convolution(y, y, k);
    if k == 0 { square.sqrt() } else { (square - convolution(s, s, k)) / (S::from_f64(2.0) * s[0]) }
}
