//! Times at which a mechanism's functions of time switch: a command of a coordinate may have a kink there, a law or a
//! load may jump.
//!
//! In: a model's observers. Out: these times, and the speeds behind a kink. A function of time may have a kink where an
//! argument of `abs` or `sign`, or the difference of those of `min` or `max`, changes sign; that time is found by
//! bisection, up to the rounding of times. A drive that changes its speed at once gives an impulse, which leaves the
//! momenta of all speeds that are not commanded:
//! ```text
//! dT/du (q, u+, t+) = dT/du (q, u, t-)     T quadratic in u: differences of T over 2 are exact
//! ```

use crate::observers::Observers;
use smartbed_codegen::Interpreted;
use smartbed_codegen::kinematics::linear;
use smartbed_runtime::mechanism::{Fault, Mechanism as _};
use smartbed_runtime::real::Scalar;
use std::cmp::Ordering;

/// How far behind a kink it is evaluated: at least this time (s), and this many rounding units of the time.
const BEHIND: f64 = 1e-30;
const ROUNDING: f64 = 16.0;

/// Most switches at which a step is cut.
pub const MOST: usize = 64;

/// Functions of time alone at whose zeros something may switch.
#[derive(Clone, Debug)]
pub struct Switches<S> {
    functions: Interpreted<S>,
    inputs: Vec<S>,
    state: [Vec<S>; 2],
    number: usize,
    /// Whether one that commands a coordinate is among them: its speed may change at once.
    pub may_leap: bool,
}

impl<S: Scalar> Switches<S> {
    /// Of a model with these observers.
    #[must_use]
    pub fn new(observers: &Observers) -> Self {
        let functions = Interpreted::new(&observers.switches());
        // They read neither coordinates, speeds nor inputs.
        let state = [functions.n_q(), functions.n_u()].map(|n| vec![S::ZERO; n]);
        let inputs = vec![S::ZERO; functions.n_inputs()];
        let (number, may_leap) = (observers.switches.iter().sum(), observers.switches[0] > 0);
        Self { functions, inputs, state, number, may_leap }
    }

    /// Whether there are any.
    #[must_use]
    pub fn any(&self) -> bool {
        self.number > 0
    }

    /// The time at which what a time commands is to be evaluated: just behind it where something switches there, so that
    /// a mechanism moves as from then on, not with the mean of both speeds.
    ///
    /// # Errors
    /// The engine's.
    pub fn moment(&mut self, t: S) -> Result<S, Fault> {
        if !self.any() {
            return Ok(t);
        }
        let here = self.signs(t)?;
        if !here.contains(&Ordering::Equal) {
            return Ok(t);
        }
        let later = t + S::from_f64(BEHIND).max(S::from_f64(ROUNDING) * S::EPSILON * t.abs());
        Ok(if self.signs(later)? == here { t } else { later })
    }

    /// Signs of the functions; where something switches those behind it.
    ///
    /// # Errors
    /// The engine's.
    pub fn sides(&mut self, t: S) -> Result<Vec<Ordering>, Fault> {
        let t = self.moment(t)?;
        self.signs(t)
    }

    fn signs(&mut self, t: S) -> Result<Vec<Ordering>, Fault> {
        let [q, u] = &self.state;
        let values = self.functions.outputs(t, q, u, &self.inputs)?;
        Ok(values.iter().map(|value| value.partial_cmp(&S::ZERO).unwrap_or(Ordering::Equal)).collect())
    }

    /// Times (s) before and after the first switch that is met on the way from one time to another, back or ahead.
    ///
    /// # Errors
    /// The engine's.
    pub fn first(&mut self, from: f64, to: f64) -> Result<Option<[f64; 2]>, Fault> {
        if !self.any() {
            return Ok(None);
        }
        let mut at = |t: f64| self.sides(S::from_f64(t));
        let (own, width) = (at(from)?, rounding::<S>(from.max(to)));
        if at(to)? == own {
            return Ok(None);
        }
        let (mut before, mut after) = (from, to);
        while (after - before).abs() > width {
            let middle = 0.5 * (before + after);
            if at(middle)? == own { before = middle } else { after = middle }
        }
        let way = width.copysign(to - from);
        let [low, high] = [from.min(to), from.max(to)];
        Ok(Some([(before - way).clamp(low, high), (after + way).clamp(low, high)]))
    }
}

/// Rounding of a time: no shorter part of a step is stepped.
pub fn rounding<S: Scalar>(t: f64) -> f64 {
    ROUNDING * S::EPSILON.to_f64() * t.abs()
}

/// The coordinate in closed form, by number, whose value jumps, given values and rates before and after a time.
pub fn jumps<S: Scalar>([before, after]: [&[[S; 2]]; 2], time: S) -> Option<usize> {
    before.iter().zip(after).position(|([a, fast], [b, faster])| {
        let moves = S::from_f64(4.0) * fast.abs().max(faster.abs()) * time;
        (*b - *a).abs() > moves + S::from_f64(64.0) * S::EPSILON * a.abs().max(b.abs())
    })
}

/// The coordinate in closed form, by number, whose rate changes at once, given values and rates before and after a time.
pub fn leaps<S: Scalar>([before, after]: [&[[S; 2]]; 2]) -> Option<usize> {
    before.iter().zip(after).position(|([_, fast], [_, faster])| {
        (*faster - *fast).abs() > S::EPSILON.sqrt() * fast.abs().max(faster.abs())
    })
}

/// The message for a step with more than [`MOST`] switches.
pub fn too_many() -> String {
    format!(
        "commands, laws and loads have more than {MOST} kinks (of abs, sign, min, max) in a step; take a smaller one"
    )
}

/// The message for a coordinate whose value jumps.
pub fn jumped(name: &str, t: f64) -> String {
    format!(
        "the command of `{name}` jumps at t = {t:.6} s, which no motion can follow; let its value pass \
         over some steps, for example by smooth_step"
    )
}

/// The speeds after a kink, whose momenta are those of the speeds `u` before it, and the work (J) of the drive's impulse;
/// `kinetic`: energy (J) at a time with some speeds.
///
/// # Errors
/// Those of `kinetic`.
pub fn pass<S: Scalar>(
    mut kinetic: impl FnMut(S, &[S]) -> Result<S, Fault>,
    [early, late]: [S; 2],
    u: &[S],
) -> Result<(Vec<S>, f64), Fault> {
    let n = u.len();
    let mut momenta = |t: S, u: &[S]| -> Result<Vec<f64>, Fault> {
        let mut with = |k: usize, by: S| {
            let mut moved = u.to_vec();
            moved[k] = moved[k] + by;
            kinetic(t, &moved).map(S::to_f64)
        };
        (0..n).map(|k| Ok(0.5 * (with(k, S::ONE)? - with(k, -S::ONE)?))).collect()
    };
    let (before, after) = (momenta(early, u)?, momenta(late, u)?);
    let mut missing: Vec<f64> = before.iter().zip(&after).map(|(before, after)| before - after).collect();
    let mut mass = Vec::new();
    for k in 0..n {
        let mut moved = u.to_vec();
        moved[k] = moved[k] + S::ONE;
        mass.extend(momenta(late, &moved)?.iter().zip(&after).map(|(with, without)| with - without));
    }
    let (change, _) = linear::solve_to(&mass, &mut missing, n, 0.0);
    let new: Vec<S> = u.iter().zip(change).map(|(u, change)| *u + S::from_f64(change)).collect();
    let work = kinetic(late, &new)? - kinetic(early, u)?;
    Ok((new, work.to_f64()))
}
