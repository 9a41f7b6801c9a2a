//! Commands whose speed jumps, laws and loads that do: a step is cut there, so that equations are smooth in each part and
//! what touches is struck.
//!
//! In: a world and the length of a step. Out: the world after it. A function of time may have a kink where an argument of
//! `abs` or `sign`, or the difference of those of `min` or `max`, changes sign; that time is found by bisection, up to the
//! rounding of times. The drive's impulse there leaves the momenta of all speeds that are not commanded,
//! ```text
//! dT/du (q, u+, t+) = dT/du (q, u, t-)     T quadratic in u: differences of T over 2 are exact
//! ```
//! and gives the change of T as work. What lies on the mechanism meets its new speed at the start of the next part:
//! whatever law a contact has treats that as an impact. A command whose value jumps is refused: no motion follows it.

use super::{CarriedWorld, words};
use crate::world::carriers::HostCarrier;
use crate::world::engine::Event;
use crate::world::ported::Ported;
use smartbed_codegen::kinematics::linear;
use smartbed_runtime::mechanism::Fault;
use smartbed_runtime::real::Scalar;
use smartbed_runtime::world::Carrier;

/// Most kinks of commands in a step.
const MOST: usize = 64;
/// Rounding units of time within which a kink is found; no shorter part is stepped.
const ROUNDING: f64 = 16.0;
/// How far beyond a step differences of frames in time may look, relative to the step.
const BEYOND: f64 = 1e-3;

impl<S: Scalar> CarriedWorld<S> {
    /// A step of motion, lines of gas shut; an error leaves the state as it was.
    pub(super) fn move_on(&mut self, h: f64, found: &mut Vec<Event>) -> Result<(), String> {
        let (start, end) = (self.t, self.t + h);
        if self.next_kink(end, h).map_err(words)?.is_none() {
            return self.move_smoothly(h, found);
        }
        let saved = (self.x.clone(), self.low.clone(), self.books.clone());
        let works = [self.drive, self.damping, self.impact, self.friction];
        let done = self.move_past_kinks((end, h), found);
        if done.is_err() {
            (self.x, self.low, self.books) = saved;
            [self.drive, self.damping, self.impact, self.friction] = works;
            self.t = start;
        }
        done
    }

    /// A step of h up to a time, cut at kinks.
    fn move_past_kinks(&mut self, (end, h): (f64, f64), found: &mut Vec<Event>) -> Result<(), String> {
        let start = self.t;
        let mut go = |world: &mut Self, to: f64| {
            let (from, events) = (world.t, found.len());
            if to - from > rounding::<S>(to) {
                world.move_smoothly(to - from, found)?;
                found[events..].iter_mut().for_each(|event| event.time += from - start);
            }
            Ok::<_, String>(())
        };
        for _ in 0..MOST {
            let Some(kink) = self.next_kink(end, h).map_err(words)? else {
                go(self, end)?;
                self.t = end;
                return Ok(());
            };
            go(self, kink[0])?;
            self.t = kink[1];
            self.pass(kink)?;
        }
        Err(format!(
            "commands, laws and loads have more than {MOST} kinks (of abs, sign, min, max) in a step; take a smaller one"
        ))
    }

    /// Times just before and after the first kink of a command up to the end of a step of h; tells mechanisms between
    /// which times their commands have none.
    pub(super) fn next_kink(&mut self, end: f64, h: f64) -> Result<Option<[f64; 2]>, Fault> {
        let may = |own: &HostCarrier<S>| matches!(own, HostCarrier::Mechanism(ported) if ported.has_switches);
        if !self.carriers.iter().any(may) {
            return Ok(None);
        }
        let (now, x) = (self.t, self.x.clone());
        let (back, ahead) = ((now - BEYOND * h).max(0.0), end + BEYOND * h);
        let mut first: Option<[f64; 2]> = None;
        self.each_mechanism(self.of_carriers(&x), |_, ported, _, _, _| {
            let mut sides = |t: S| ported.sides(t);
            let (mut last, next) = (kink(&mut sides, now, back)?, kink(&mut sides, now, ahead)?);
            let begins =
                now < BEYOND * h && sides(S::from_f64(now - BEYOND * h))? != sides(S::from_f64(0.0))?;
            if begins {
                // The motion before time 0 is none of the world's.
                last = last.or(Some([0.0; 2]));
            }
            let cuts = sides(S::from_f64(end))? != sides(S::from_f64(now))?;
            if let Some([before, after]) =
                next.filter(|next| cuts && first.is_none_or(|first| next[0] < first[0]))
            {
                first = Some([before.min(end), after.min(end)]);
            }
            let times =
                [last.map_or(f64::NEG_INFINITY, |last| last[0]), next.map_or(f64::INFINITY, |next| next[0])];
            ported.smooth = times.map(S::from_f64);
            Ok(())
        })?;
        Ok(first)
    }

    /// Changes the speeds of mechanisms whose commands have a kink between two times.
    fn pass(&mut self, [before, after]: [f64; 2]) -> Result<(), String> {
        let [early, late] = [before, after].map(S::from_f64);
        let (mut changes, mut jumped, old) = (Vec::new(), None, self.x.clone());
        self.each_mechanism(self.of_carriers(&old), |number, ported, q, u, _| {
            if ported.sides(early)? == ported.sides(late)? {
                return Ok(());
            }
            let ends = [ported.closed_forms(early, q, u)?, ported.closed_forms(late, q, u)?];
            let leaps = ends[0].iter().zip(&ends[1]).position(|(a, b)| leaps(*a, *b, late - early));
            jumped = jumped.take().or(leaps.map(|form| format!("{}.{}", ported.name, ported.closed[form].0)));
            let kinetic = ported.energy(early, q, u)?.0;
            let new = kept(ported, [early, late], q, u)?;
            let work = (ported.energy(late, q, &new)?.0 - kinetic).to_f64();
            changes.push((number, new, work));
            Ok(())
        })
        .map_err(words)?;
        if let Some(name) = jumped {
            return Err(format!(
                "the command of `{name}` jumps at t = {after:.6} s, which no motion can follow; let its value pass \
                 over some steps, for example by smooth_step"
            ));
        }
        for (number, new, work) in changes {
            let first = self.split() + self.carriers[..number].iter().map(Carrier::n_u).sum::<usize>();
            self.x[first..first + new.len()].copy_from_slice(&new);
            self.drive += work;
            if let Some(books) = &mut self.books {
                books.driven[number] += work;
            }
        }
        for (low, (x, old)) in self.low.iter_mut().zip(self.x.iter().zip(&old)) {
            *low = if x == old { *low } else { S::ZERO };
        }
        Ok(())
    }
}

/// Rounding of a time.
fn rounding<S: Scalar>(t: f64) -> f64 {
    ROUNDING * S::EPSILON.to_f64() * t.abs()
}

/// Times before and after the first change of sides on the way from one time to another.
fn kink<S: Scalar, T: PartialEq>(
    sides: &mut impl FnMut(S) -> Result<T, Fault>,
    from: f64,
    to: f64,
) -> Result<Option<[f64; 2]>, Fault> {
    let mut at = |t: f64| sides(S::from_f64(t));
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

/// Does a value, given with its rate, change by more than it moves at these rates within a time?
fn leaps<S: Scalar>([a, fast]: [S; 2], [b, faster]: [S; 2], time: S) -> bool {
    let moves = S::from_f64(4.0) * fast.abs().max(faster.abs()) * time;
    (b - a).abs() > moves + S::from_f64(64.0) * S::EPSILON * a.abs().max(b.abs())
}

/// The speeds after a kink, whose momenta are those of the speeds before it.
fn kept<S: Scalar>(ported: &mut Ported<S>, [early, late]: [S; 2], q: &[S], u: &[S]) -> Result<Vec<S>, Fault> {
    let n = u.len();
    let mut momenta = |t: S, u: &[S]| -> Result<Vec<f64>, Fault> {
        let mut kinetic = |k: usize, by: S| {
            let mut moved = u.to_vec();
            moved[k] = moved[k] + by;
            ported.energy(t, q, &moved).map(|(kinetic, _)| kinetic.to_f64())
        };
        (0..n).map(|k| Ok(0.5 * (kinetic(k, S::ONE)? - kinetic(k, -S::ONE)?))).collect()
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
    Ok(u.iter().zip(change).map(|(u, change)| *u + S::from_f64(change)).collect())
}
