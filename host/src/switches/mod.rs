//! Times at which a mechanism's functions of time switch: what commands a motion may have a kink there, a law or a load
//! may jump.
//!
//! In: a model's observers. Out: these times; which commands switch there, and whether their values jump. A function of
//! time may have a kink where an argument of `abs` or `sign`, or the difference of those of `min` or `max`, changes sign
//! (`jumps.rs` lists all); that time is found by bisection, up to the rounding of times. What changes its sign there
//! and back within the time looked at is found where it comes nearest to 0 in between. What gives a place, be it a
//! coordinate in closed form, a position or a constraint, may not jump: its values on both sides are compared. What
//! the speeds are behind a kink is in `impulse.rs`.

pub mod between;
pub mod impulse;

use crate::observers::{Command, Observers};
use smartbed_codegen::Interpreted;
use smartbed_runtime::mechanism::{Fault, Mechanism as _};
use smartbed_runtime::real::Scalar;
use std::cmp::Ordering;

/// How far behind a kink it is evaluated: at least this time (s), and this many rounding units of the time.
const BEHIND: f64 = 1e-30;
const ROUNDING: f64 = 16.0;

/// A switch is looked for as exactly as times are numbers: its place in the time that it is given is its middle.
const FINER: f64 = 1.0 / 8.0;

/// A value jumps if it changes by more across a switch than beside it, within this time (s; relative to times beyond 1
/// s) and at least so many times that across the switch.
const BESIDE: f64 = 1e-7;
const WIDER: f64 = 10.0;

/// Rounding units by which a value may change.
const UNITS: f64 = 64.0;

/// Which way a value goes is seen over this part of a time.
const BEGINNING: f64 = 1.0 / 64.0;

/// Of a time that is searched, the part that is left by each value of the golden section.
const GOLDEN: f64 = 0.618_033_988_749_894_8;

/// A step that is longer than a part by this share of it is one part.
const WHOLE: f64 = 1e-6;

/// Most switches at which a step is cut.
pub const MOST: usize = 64;

/// Functions of time alone at whose zeros something may switch.
#[derive(Clone, Debug)]
pub struct Switches<S> {
    functions: Interpreted<S>,
    inputs: Vec<S>,
    state: [Vec<S>; 2],
    number: usize,
    commands: Vec<Command>,
    values: Interpreted<f64>,
    /// Whether one that commands a motion is among them: its speed may change at once.
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
        let (commands, values) = (observers.commands.clone(), Interpreted::new(&observers.commanded()));
        Self { functions, inputs, state, number, commands, values, may_leap }
    }

    /// Whether there are any.
    #[must_use]
    pub fn any(&self) -> bool {
        self.number > 0
    }

    /// The time at which what a time commands is to be evaluated: just behind it where something switches there, so
    /// that a mechanism moves as from then on, not with the mean of both speeds.
    ///
    /// # Errors
    /// The engine's.
    pub fn moment(&mut self, t: S) -> Result<S, Fault> {
        Ok(self.at(t)?.0)
    }

    /// Signs of the functions; where something switches those behind it.
    ///
    /// # Errors
    /// The engine's.
    pub fn sides(&mut self, t: S) -> Result<Vec<Ordering>, Fault> {
        Ok(signs(&self.at(t)?.1))
    }

    /// The moment of a time, and the values of the functions then.
    fn at(&mut self, t: S) -> Result<(S, Vec<S>), Fault> {
        if !self.any() {
            return Ok((t, Vec::new()));
        }
        let here = self.values(t)?;
        if !signs(&here).contains(&Ordering::Equal) {
            return Ok((t, here));
        }
        let later = t + S::from_f64(BEHIND).max(S::from_f64(ROUNDING) * S::EPSILON * t.abs());
        let behind = self.values(later)?;
        Ok(if signs(&behind) == signs(&here) { (t, here) } else { (later, behind) })
    }

    /// Whether something switches between two times, as they are.
    ///
    /// # Errors
    /// The engine's.
    pub fn differ(&mut self, [a, b]: [f64; 2]) -> Result<bool, Fault> {
        Ok(self.any() && self.sides(S::from_f64(a))? != self.sides(S::from_f64(b))?)
    }

    fn values(&mut self, t: S) -> Result<Vec<S>, Fault> {
        let [q, u] = &self.state;
        self.functions.outputs(t, q, u, &self.inputs)
    }

    /// Times (s) before and after the first switch that is met on the way from one time to another, back or ahead. One
    /// that lies beyond by rounding alone is met too: a method's last stage may be there.
    ///
    /// # Errors
    /// The engine's.
    pub fn first(&mut self, from: f64, to: f64) -> Result<Option<[f64; 2]>, Fault> {
        if !self.any() || from == to {
            return Ok(None);
        }
        let width = rounding::<S>(from.abs().max(to.abs()));
        let way = width.copysign(to - from);
        let [start, end] = [from, to + way];
        let [(_, own), (_, there)] = [self.at(S::from_f64(start))?, self.at(S::from_f64(end))?];
        let differs = signs(&own) != signs(&there);
        let mut other = if differs { Some(end) } else { self.dip([start, end], [&own, &there], width)? };
        let mut found = None;
        // Before a switch of one function another one may switch there and back.
        for _ in 0..=self.number {
            let Some(beyond) = other else { break };
            let (mut before, mut after) = (start, beyond);
            while (after - before).abs() > FINER * width {
                let middle = 0.5 * (before + after);
                let is_before = self.sides(S::from_f64(middle))? == signs(&own);
                if is_before { before = middle } else { after = middle }
            }
            found = Some([before, after]);
            let (_, there) = self.at(S::from_f64(before))?;
            other = self.dip([start, before], [&own, &there], width)?;
        }
        let [low, high] = [from.min(to), from.max(to)];
        Ok(found.map(|[before, after]| [(before - way).clamp(low, high), (after + way).clamp(low, high)]))
    }

    /// A time at which a function has another sign than at both ends, where it comes nearest to 0 in between: from
    /// both ends, where the functions have these values, it goes towards 0. `width`: the rounding of times.
    fn dip(
        &mut self,
        [from, to]: [f64; 2],
        [own, there]: [&[S]; 2],
        width: f64,
    ) -> Result<Option<f64>, Fault> {
        if (to - from).abs() <= width {
            return Ok(None);
        }
        let near = BEGINNING * (to - from);
        let [early, late] = [from + near, to - near].map(|t| self.values(S::from_f64(t)));
        let (early, late) = (early?, late?);
        for k in 0..self.number {
            let side = if own[k] > S::ZERO { S::ONE } else { -S::ONE };
            let [a, b, c, d] = [own[k], early[k], late[k], there[k]].map(|value| side * value);
            if !(a > S::ZERO && d > S::ZERO && b < a && c < d) {
                continue;
            }
            if let Some(t) = self.below_zero([from, to], (k, side), width)? {
                return Ok(Some(t));
            }
        }
        Ok(None)
    }

    /// A time between two at which the function k, times 1 or -1, is below 0, on the way to its least value: golden
    /// section.
    fn below_zero(
        &mut self,
        [mut low, mut high]: [f64; 2],
        (k, side): (usize, S),
        width: f64,
    ) -> Result<Option<f64>, Fault> {
        let mut at = |t: f64| Ok::<S, Fault>(side * self.values(S::from_f64(t))?[k]);
        let mut inner = [high - GOLDEN * (high - low), low + GOLDEN * (high - low)];
        let mut found = [at(inner[0])?, at(inner[1])?];
        while (high - low).abs() > width {
            let least = usize::from(found[1] < found[0]);
            if found[least] < S::ZERO {
                return Ok(Some(inner[least]));
            }
            if least == 0 {
                high = inner[1];
                inner = [high - GOLDEN * (high - low), inner[0]];
                found = [at(inner[0])?, found[0]];
            } else {
                low = inner[0];
                inner = [inner[1], low + GOLDEN * (high - low)];
                found = [found[1], at(inner[1])?];
            }
        }
        Ok(None)
    }

    /// The same over a step of fixed length, in parts, in each of which a function switches there and back once at most.
    ///
    /// # Errors
    /// The engine's.
    pub fn within(&mut self, [from, to]: [f64; 2], part: f64) -> Result<Option<[f64; 2]>, Fault> {
        // The last part ends with the step: one part may be all of it.
        let last = to - (1.0 + WHOLE) * part;
        if self.any()
            && from < last
            && let Some(kink) = self.next(from, last, part)?
        {
            return Ok(Some(kink));
        }
        self.first(from.max(last), to)
    }

    /// The same over a long time ahead, in parts, in each of which a function switches there and back once at most.
    ///
    /// # Errors
    /// The engine's.
    pub fn next(&mut self, from: f64, to: f64, part: f64) -> Result<Option<[f64; 2]>, Fault> {
        let mut start = from;
        while self.any() && start < to {
            let end = (start + part).min(to);
            if let Some(kink) = self.first(start, end)? {
                // The end of a part is none of the motion: a switch there ends behind it.
                let beyond = end + 4.0 * rounding::<S>(end);
                return if kink[1] < end { Ok(Some(kink)) } else { self.first(start, beyond) };
            }
            start = end;
        }
        Ok(None)
    }

    /// The commands that switch between two times.
    ///
    /// # Errors
    /// The engine's.
    pub fn changed(&mut self, times: [f64; 2]) -> Result<Vec<Command>, Fault> {
        let [before, after] = times.map(|t| self.sides(S::from_f64(t)));
        let (before, after) = (before?, after?);
        let mut end = 0;
        let changed = self.commands.iter().filter(|command| {
            let own = end..end + command.switches;
            end = own.end;
            before[own.clone()] != after[own]
        });
        Ok(changed.cloned().collect())
    }

    /// A command whose value jumps between two times, at a state.
    ///
    /// # Errors
    /// The engine's.
    pub fn jumped(&mut self, [before, after]: [f64; 2], q: &[S], u: &[S]) -> Result<Option<Command>, Fault> {
        let changed = self.changed([before, after])?;
        if changed.is_empty() {
            return Ok(None);
        }
        let [q, u] = [q, u].map(|x| x.iter().map(|x| x.to_f64()).collect::<Vec<_>>());
        let inputs = vec![0.0; self.inputs.len()];
        let wide = (BESIDE * after.max(1.0)).max(WIDER * (after - before));
        let mut at = |t: f64| {
            let t = self.moment(S::from_f64(t))?.to_f64();
            self.values.outputs(t, &q, &u, &inputs)
        };
        let [a, b, c, d] = [at(before - wide)?, at(before)?, at(after)?, at(after + wide)?];
        let size = q.iter().map(|q| q.abs()).sum::<f64>();
        let jumps = |i: usize| {
            // Before time 0 a value need not exist: then it says nothing.
            let moves = (b[i] - a[i]).abs().max(0.0) + (d[i] - c[i]).abs().max(0.0);
            let rounding = UNITS * f64::EPSILON * (size + b[i].abs() + c[i].abs());
            let change = (c[i] - b[i]).abs();
            change.is_nan() || change > moves + rounding
        };
        let mut end = 0;
        let found = self.commands.iter().find(|command| {
            let own = end..end + command.values;
            end = own.end;
            changed.contains(command) && own.into_iter().any(jumps)
        });
        Ok(found.cloned())
    }
}

fn signs<S: Scalar>(values: &[S]) -> Vec<Ordering> {
    values.iter().map(|value| value.partial_cmp(&S::ZERO).unwrap_or(Ordering::Equal)).collect()
}

/// Rounding of a time: no shorter part of a step is stepped.
pub fn rounding<S: Scalar>(t: f64) -> f64 {
    ROUNDING * S::EPSILON.to_f64() * t.abs()
}

/// The message for a step with more than [`MOST`] switches.
pub fn too_many() -> String {
    format!(
        "commands, laws and loads have more than {MOST} kinks (of abs, sign, min, max) in a step; take a smaller one"
    )
}
