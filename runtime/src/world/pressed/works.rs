//! Energy accounts of motion under lasting contacts.
//!
//! In: two states of a piece of a step. Out: the work of dampers, drag, friction and drives between them, by Simpson's
//! rule over the powers at both ends and in the middle; each of these instants is shown to an observer. A piece that
//! ends where a contact loses its support, or passes to another face, ends behind a jump of forces: there by Radau's
//! rule, which does not look at the end,
//! ```text
//! h (P(t) + 3 P(t + 2/3 h))/4
//! ```

use super::{Pressed, Pressing};
use crate::mechanism::Fault;
use crate::ode::Ode;
use crate::real::Scalar;
use crate::vec3;
use crate::world::accounts::Accounts;
use crate::world::carrier::Carrier;
use crate::world::island::{Cut, Island};
use crate::world::observer::{Forces, Observer, Push};
use crate::world::whole::StepMemory;
use crate::world::yielding::Yield;

/// A contact that pulls by more than this share of the largest force at the start has not let go as its force passed 0.
const LOST: f64 = 0.01;

impl<S: Scalar, C: Carrier<S>> Pressed<'_, '_, '_, S, C> {
    /// Power of each account at a state (W), and the state's rates.
    fn powers(&mut self, t: S, x: &[S], dot: &mut [S]) -> Result<Accounts<S>, Fault> {
        self.rates(t, x, dot)?;
        let Island { body, memory: own, .. } = &self.world.island;
        let mut powers = Accounts::empty();
        for (viscous, velocity) in own.viscous.iter().zip(own.vel.iter()) {
            let drag = vec3::scale(*velocity, -body.air_drag);
            powers.drag = powers.drag - vec3::dot(drag, *velocity);
            powers.damping = powers.damping - vec3::dot(vec3::sub(*viscous, drag), *velocity);
        }
        for own in self.list.iter() {
            let [_, x, y] = own.held.contact.impulse;
            let force = own.held.contact.to_inertial([S::ZERO, x, y]);
            powers.friction = powers.friction - vec3::dot(force, own.velocity);
        }
        powers.impact = self.world.power_taken();
        self.carrier_powers(t, x, |_, [given, taken]| {
            powers.drive = powers.drive + given;
            powers.damping = powers.damping + taken;
        })?;
        Ok(powers)
    }

    /// Powers of the carriers' drives and dampers at a state whose rates were asked for last, by member of their group.
    fn carrier_powers(&mut self, t: S, x: &[S], mut tell: impl FnMut(usize, [S; 2])) -> Result<(), Fault> {
        let Cut { q, u, .. } = self.world.island.parts(x)?;
        let Island { carrier, memory: own, .. } = &mut self.world.island;
        carrier.powers(t, [q, u], (own.frames, own.wrenches), &mut tell)
    }

    /// Shows the instant whose powers were asked for last, which counts for `duration` (s).
    fn show(&mut self, (t, x): (S, &[S]), duration: S, watch: &mut impl Observer<S>) -> Result<(), Fault> {
        if !watch.watches() {
            return Ok(());
        }
        self.carrier_powers(t, x, |member, [given, taken]| {
            watch.carried(member, [duration * given, duration * taken]);
        })?;
        let StepMemory { twists: [_, twists, _], .. } = &mut *self.memory;
        Self::read_twists(self.world, twists);
        let (own, ends) = (&self.world.island.memory, [&**twists; 2]);
        watch.forces(&Forces { duration, elastic: own.elastic, viscous: own.viscous, ends });
        for Pressing { pair, held, .. } in self.list.iter() {
            let (pair, contact, taken) = (*pair, &held.contact, S::ZERO);
            watch.push(&Push { pair, contact, duration, ends, strikes: false, taken });
        }
        self.world.each_yield(|Yield { pair, contact, taken, .. }| {
            watch.push(&Push { pair: *pair, contact, duration, ends, strikes: false, taken: *taken });
        });
        Ok(())
    }

    /// Energy accounts between two states that are `length` apart in time, by Simpson's rule; three lists of memory.
    pub(in crate::world) fn works(
        &mut self,
        (t, length): (S, S),
        [old, new]: [&[S]; 2],
        [first, last, between]: [&mut [S]; 3],
        watch: &mut impl Observer<S>,
    ) -> Result<Accounts<S>, Fault> {
        let (half, sixth) = (S::from_f64(0.5), length / S::from_f64(6.0));
        let start = self.powers(t, old, first)?;
        self.show((t, old), sixth, watch)?;
        let force = |own: &Pressing<S>| own.held.contact.impulse[0];
        let largest = self.list.iter().map(force).fold(S::ZERO, S::max);
        let end = self.powers(t + length, new, last)?;
        let lost = |own: &Pressing<S>| own.lost || force(own) < -(S::from_f64(LOST) * largest);
        if self.list.iter().any(lost) {
            let (part, quarter) = (S::from_f64(2.0 / 3.0), S::from_f64(0.25) * length);
            for (to, ((a, b), da)) in between.iter_mut().zip(old.iter().zip(new).zip(first.iter())) {
                let way = length * *da;
                *to = *a + part * (way + part * ((*b - *a) - way));
            }
            if watch.watches() {
                // The start was shown with Simpson's weight. Forces in memory are those of the end by now: compute its
                // own once more to show what is missing.
                self.powers(t, old, first)?;
                self.show((t, old), quarter - sixth, watch)?;
            }
            let inside = self.powers(t + part * length, between, first)?.times(S::from_f64(3.0));
            self.show((t + part * length, between), S::from_f64(3.0) * quarter, watch)?;
            return Ok(start.plus(&inside).times(quarter));
        }
        self.show((t + length, new), sixth, watch)?;
        // The state at half time by Hermite interpolation.
        let ends = old.iter().zip(new).zip(first.iter().zip(last.iter()));
        for (to, ((a, b), (da, db))) in between.iter_mut().zip(ends) {
            *to = half * (*a + *b) + S::from_f64(0.125) * length * (*da - *db);
        }
        let inside = self.powers(t + half * length, between, first)?;
        self.show((t + half * length, between), S::from_f64(4.0) * sixth, watch)?;
        let sum = start.plus(&end).plus(&inside.times(S::from_f64(4.0)));
        Ok(sum.times(sixth))
    }
}
