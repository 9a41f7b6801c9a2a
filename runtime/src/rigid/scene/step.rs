//! The whole step: impacts, then an advance to the next event, repeated until the step is used up.

use super::advance::{By, Start};
use super::memory::{Memory, Piece, Report, Strike};
use super::parts::{Fault, NEAR, RigidScene, Rounding};
use super::touching::Touching;
use crate::ode::root::reach;
use crate::real::Scalar;
use crate::rigid::RigidState;
use crate::rigid::law::Kind;
use crate::rigid::plastic::{compensate_all, end, stop};
use crate::rigid::several::strike_all;
use crate::rigid::struck::Struck;
use crate::vec3;

/// Most splits of one step.
pub const SPLITS: usize = 64;
/// Pieces of equal length for the rest of a step that has used up its splits; contacts are detected only between them.
pub(crate) const PIECES: u32 = 16;

/// A bounce higher than this, in gaps that count as zero, has not died out, however little energy it has.
pub(crate) const HIGHEST: f64 = 1e4;
/// A contact deeper than this many gaps that count as zero is an overlap; a shallower one was located.
pub(crate) const OVERLAP: f64 = 64.0;

/// A small whole number.
fn whole<S: Scalar>(n: u32) -> S {
    S::from_f64(f64::from(n))
}

impl<S: Scalar> RigidScene<'_, S> {
    /// Advances the states by h (s), > 0.
    ///
    /// # Errors
    /// [`Fault`]; the states are then those before the step.
    pub fn step(
        &self,
        states: &mut [RigidState<S>],
        h: S,
        memory: &mut Memory<S>,
    ) -> Result<Report<S>, Fault> {
        self.step_watched(states, h, memory, (|_| {}, |_| {}))
    }

    /// As [`RigidScene::step`]; shows every impact and every piece between them, even of a step that is refused in the
    /// end.
    ///
    /// # Errors
    /// As [`RigidScene::step`].
    pub fn step_watched(
        &self,
        states: &mut [RigidState<S>],
        h: S,
        memory: &mut Memory<S>,
        mut watch: (impl FnMut(Strike<'_, S>), impl FnMut(Piece<'_, S>)),
    ) -> Result<Report<S>, Fault> {
        self.check_sizes(states, memory)?;
        self.check_numbers(states, h)?;
        let mut report = Report {
            impacts: 0,
            splits: 0,
            held: 0,
            pressing: S::ZERO,
            impact_loss: S::ZERO,
            friction_loss: S::ZERO,
            forced: false,
            impulsive: false,
        };
        let [now, ..] = &mut memory.states;
        now.iter_mut().zip(states.iter()).for_each(|(to, from)| *to = *from);
        self.go(h, memory, &mut report, &mut watch)?;
        if !memory.states[0].iter().all(RigidState::is_finite) {
            return Err(Fault::TooFast);
        }
        states.iter_mut().zip(memory.states[0].iter()).for_each(|(to, from)| *to = *from);
        Ok(report)
    }

    fn check_numbers(&self, states: &[RigidState<S>], h: S) -> Result<(), Fault> {
        if !(h > S::ZERO && h.is_finite()) {
            return Err(Fault::StepSize);
        }
        if !self.gravity.iter().all(|g| g.is_finite()) {
            return Err(Fault::Gravity);
        }
        match self.parts.iter().zip(states).position(|(part, state)| !part.is_sound(state)) {
            Some(part) => Err(Fault::Part(part)),
            None => Ok(()),
        }
    }

    fn check_sizes(&self, states: &[RigidState<S>], memory: &Memory<S>) -> Result<(), Fault> {
        let n = self.parts.len();
        let [a, b, c] = &memory.states;
        let sizes = [states.len(), a.len(), b.len(), c.len(), memory.twists.len(), memory.spare.len()];
        let all = sizes.iter().all(|size| *size == n) && memory.mobilities.len() == n;
        let pairs = self.pairs.iter().flat_map(|pair| pair.parts).all(|part| part < n);
        if all && pairs { Ok(()) } else { Err(Fault::WrongSizes) }
    }

    /// Runs the stages on the first of the memory's states.
    fn go(
        &self,
        h: S,
        memory: &mut Memory<S>,
        report: &mut Report<S>,
        (strikes, pieces): &mut (impl FnMut(Strike<'_, S>), impl FnMut(Piece<'_, S>)),
    ) -> Result<(), Fault> {
        let (mut left, mut rest) = (h, PIECES);
        for split in 0..SPLITS + PIECES as usize {
            let last = split >= SPLITS;
            let rounding = self.rounding(memory.states[0], h);
            self.strike(memory, rounding, last, report, |strike| {
                strikes(Strike { time: h - left, ..strike })
            })?;
            let mut start = self.hold_at_start(memory, rounding, h)?;
            let (length, pressing) = if last {
                // No event ends the piece: friction by forces could turn slips round and do work.
                start.give_up_forces(memory);
                let piece = left / whole(rest);
                rest -= 1;
                (piece, self.advance(memory, piece, &mut start, rounding)?)
            } else {
                self.shorten(memory, left, &mut start, rounding)?
            };
            self.commit(memory, (length, start.by), pressing, report);
            let along = memory.along.get(..pressing).unwrap_or_default();
            let strikes = start.by == By::Impulses;
            report.impulsive |= strikes && !last;
            pieces(Piece { length, along, twists: memory.twists, strikes });
            self.project(memory, pressing, rounding)?;
            (report.splits, report.forced) = (split + 1, last);
            left = left - length;
            if left <= S::ZERO || rest == 0 {
                break;
            }
        }
        Ok(())
    }

    /// Resolves the impact of all contacts, if any of them closes.
    fn strike(
        &self,
        memory: &mut Memory<S>,
        rounding: Rounding<S>,
        last: bool,
        report: &mut Report<S>,
        show: impl FnOnce(Strike<'_, S>),
    ) -> Result<(), Fault> {
        let Memory { states: [now, ..], twists, spare, mobilities, touching, struck, .. } = memory;
        let count = self.detect(now, twists, mobilities, touching, rounding.gap, |_| true)?;
        let touching = touching.get_mut(..count).unwrap_or_default();
        let closes = |t: &&Touching<S>| t.velocity[0] < -rounding.rate;
        if !touching.iter().any(|t| closes(&t)) {
            return Ok(());
        }
        let ends = touching.iter().filter(closes).all(|t| self.has_died_out(t, rounding));
        if ends {
            touching.iter_mut().for_each(|t| t.held.contact.restitution = S::ZERO);
        }
        let touching = &*touching;
        let struck = struck.get_mut(..count).ok_or(Fault::TooManyContacts)?;
        for (s, t) in struck.iter_mut().zip(touching) {
            *s = Struck::new(t.held.contact, &**mobilities);
        }
        let before = self.energy(now);
        let law_of = |t: &Touching<S>| Some((self.pairs.get(t.pair)?.law, t.held.contact.restitution));
        let law = touching.first().and_then(law_of);
        let alike = touching.iter().all(|t| law_of(t) == law);
        match law {
            _ if last => {
                // Converged or not, its effect is only dissipative.
                let _ = stop(struck, &**mobilities, twists);
            }
            // The last bounce is too low to tell how contacts share it.
            _ if ends => {
                let _ = end(struck, &**mobilities, twists);
            }
            Some((law, e)) if alike && law.kind() != Kind::Stronge => {
                // Newton's law with one e at all points and without friction is compensation with eta = e^2.
                compensate_all(struck, e * e, &**mobilities, twists);
            }
            _ => {
                strike_all(struck, &**mobilities, twists, spare);
            }
        }
        self.read_twists(now, spare);
        for s in struck.iter() {
            self.push(now, &s.contact, s.contact.impulse);
        }
        let loss = before - self.energy(now);
        report.impacts += 1;
        report.impact_loss = report.impact_loss + loss;
        show(Strike { time: S::ZERO, loss, touching, struck, ends: [&**spare, &**twists] });
        Ok(())
    }

    /// Whether the bounces of a contact that closes have died out: the height that one loses, (1 - e^2) v^2/(2 g), is
    /// less than the gap that counts as zero, in which no touch is located, or it has sunk in bounce by bounce. What
    /// comes from higher has not, however deep it is: a lasting contact that was put back onto its surface moves others
    /// too. With e = 1 no bounce dies out.
    fn has_died_out(&self, t: &Touching<S>, rounding: Rounding<S>) -> bool {
        let (e, v) = (t.held.contact.restitution, t.velocity[0]);
        let (lost, height) = (S::ONE - e * e, S::from_f64(0.5) * v * v / vec3::norm(self.gravity));
        let is_low = height <= S::from_f64(HIGHEST) * rounding.gap;
        let has_sunk = t.gap < -S::from_f64(OVERLAP) * rounding.gap;
        lost > S::ZERO && is_low && (has_sunk || lost * height <= rounding.gap)
    }

    /// Advances over all the time left, or to the first new contact, end of slip or passage of a contact to another
    /// face, edge or end; returns how far, and the number of contacts in `along`.
    fn shorten(
        &self,
        memory: &mut Memory<S>,
        left: S,
        start: &mut Start,
        rounding: Rounding<S>,
    ) -> Result<(S, usize), Fault> {
        let near = S::from_f64(NEAR);
        let pressing = self.advance(memory, left, start, rounding)?;
        let last = self.clearance(memory, *start, rounding).to_event();
        if last >= near - S::ONE {
            return Ok((left, pressing));
        }
        // At the start no contact is new or lost, and no slip has reversed. One that opens has no gap there, and says
        // nothing of when it closes.
        let [now, trial, _] = &mut memory.states;
        trial.iter_mut().zip(now.iter()).for_each(|(to, from)| *to = *from);
        let first = self.clearance(memory, *start, rounding).to_event().max(-last);
        let mut fault = None;
        let guard = |length: S| {
            if length <= S::ZERO || length >= left {
                return if length <= S::ZERO { first } else { last };
            }
            match self.advance(memory, length, start, rounding) {
                Ok(_) => self.clearance(memory, *start, rounding).to_event(),
                Err(why) => {
                    fault = Some(why);
                    S::ZERO
                }
            }
        };
        // Where a clearance jumps, as fine as a gap that counts as zero is in the size of the bodies.
        let found = reach(guard, [S::ZERO, left], rounding.share * left, near);
        if let Some(why) = fault {
            return Err(why);
        }
        // Stop behind the event: a new contact then touches within rounding, a slip has just stopped.
        let length = found.map_or(left, |(_, beyond)| beyond);
        Ok((length, self.advance(memory, length, start, rounding)?))
    }
}
