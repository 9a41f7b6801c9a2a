//! Commands whose speed jumps, laws and loads that do: a step is cut there, so that equations are smooth in each part
//! and what touches is struck.
//!
//! In: a world and the length of a step. Out: the world after it. What lies on a mechanism meets its new speed at the
//! start of the next part: whatever law a contact has treats that as an impact. A command whose value jumps is refused:
//! no motion follows it.

use super::{CarriedWorld, words};
use crate::observers::Command;
use crate::switches::impulse::{self, Placed};
use crate::switches::{MOST, rounding, too_many};
use crate::world::carriers::HostCarrier;
use crate::world::engine::Event;
use crate::world::ported::Ported;
use smartbed_runtime::mechanism::Fault;
use smartbed_runtime::real::Scalar;
use smartbed_runtime::world::Carrier;

/// How far beyond a step differences of frames in time may look, relative to the step.
const BEYOND: f64 = 1e-3;

/// A mechanism at its coordinates.
struct Here<'a, S> {
    ported: &'a mut Ported<S>,
    q: &'a [S],
}

impl<S: Scalar> Placed<S> for Here<'_, S> {
    fn kinetic(&mut self, t: S, u: &[S]) -> Result<S, Fault> {
        Ok(self.ported.energy(t, self.q, u)?.0)
    }
    fn speeds(&mut self, t: S, u: &[S]) -> Result<Vec<S>, Fault> {
        self.ported.speeds(t, self.q, u)
    }
}

impl<S: Scalar> CarriedWorld<S> {
    /// A step of motion, lines of gas shut; an error leaves the state as it was.
    pub(super) fn move_on(&mut self, h: f64, found: &mut Vec<Event>) -> Result<(), String> {
        let (start, end) = (self.t, self.t + h);
        if self.next_kink(end, h).map_err(words)?.is_none() {
            return self.move_smoothly(h, found);
        }
        let saved = (self.x.clone(), self.low.clone(), self.books.clone(), self.works);
        let done = self.move_past_kinks((end, h), found);
        if done.is_err() {
            (self.x, self.low, self.books, self.works) = saved;
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
        Err(too_many())
    }

    /// Times just before and after the first kink of a command up to the end of a step of h; tells mechanisms between
    /// which times their commands have none.
    pub(super) fn next_kink(&mut self, end: f64, h: f64) -> Result<Option<[f64; 2]>, Fault> {
        let may =
            |own: &HostCarrier<S>| matches!(own, HostCarrier::Mechanism(ported) if ported.switches.any());
        if !self.carriers.iter().any(may) {
            return Ok(None);
        }
        let (now, x) = (self.t, self.x.clone());
        let (back, ahead) = ((now - BEYOND * h).max(0.0), end + BEYOND * h);
        let mut first: Option<[f64; 2]> = None;
        self.each_mechanism(self.of_carriers(&x), |_, ported, _, _, _| {
            let own = &mut ported.switches;
            let (mut last, next) = (own.first(now, back)?, own.first(now, ahead)?);
            if now < BEYOND * h && own.first(now - BEYOND * h, 0.0)?.is_some() {
                // The motion before time 0 is none of the world's.
                last = last.or(Some([0.0; 2]));
            }
            let cuts = next.is_some() && own.first(now, end)?.is_some();
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
        let (mut changes, mut refused, old) = (Vec::new(), None, self.x.clone());
        self.each_mechanism(self.of_carriers(&old), |number, ported, q, u, _| {
            if ported.switches.sides(early)? == ported.switches.sides(late)? {
                return Ok(());
            }
            let part = ported.name.clone();
            let named = |command: &Command| command.words(Some(&part));
            let jumped = ported.switches.jumped([before, after], q, u)?;
            let mut why = jumped.map(|command| impulse::jumped(&named(&command), after));
            if impulse::ties_change(&mut Here { ported, q }, [early, late], u)? {
                let changed = ported.switches.changed([before, after])?;
                let command = changed.iter().find(|command| command.values == 0).or(changed.first());
                why = why.or(command.map(|command| impulse::tied(&named(command), after)));
            }
            refused = refused.take().or(why);
            let (new, work) = impulse::pass(&mut Here { ported, q }, [early, late], u)?;
            changes.push((number, new, work));
            Ok(())
        })
        .map_err(words)?;
        if let Some(why) = refused {
            return Err(why);
        }
        for (number, new, work) in changes {
            let first = self.split() + self.carriers[..number].iter().map(Carrier::n_u).sum::<usize>();
            self.x[first..first + new.len()].copy_from_slice(&new);
            self.works.drive += work;
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
