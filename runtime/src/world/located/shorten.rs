//! Advances to the first event: the method's step under lasting contacts, and the clearance at its end.

use super::hold::LIGHT;
use super::{PartialStep, Rounding, Sight};
use crate::mechanism::Fault;
use crate::ode::root::reach;
use crate::ode::{Method, Ode, State};
use crate::real::Scalar;
use crate::rigid::scene::NEAR;
use crate::vec3;
use crate::world::accounts::Accounts;
use crate::world::carrier::Carrier;
use crate::world::detect::Touch;
use crate::world::observer::Observer;
use crate::world::pressed::{Pressed, Pressing};
use crate::world::whole::{StepMemory, World};

/// Clearance where nothing is near, in units of rounding.
fn far<S: Scalar>() -> S {
    S::ONE / S::EPSILON
}

impl<S: Scalar> Touch<S> {
    /// Clearance of a contact that is not held, given the same at the start of the piece.
    fn clearance(&self, before: Option<&Self>, rounding: &Rounding<S>) -> S {
        // An overlap that is opening counts as new only where it goes deeper.
        let depth = before.map_or(S::ZERO, |own| own.gap.min(S::ZERO));
        let by_gap = (self.gap - depth) / rounding.gap + S::ONE;
        // What slides above or below a facet, within its sagitta, comes nearer to it also where nothing closes; no law
        // acts on a known contact that opens, wherever it goes.
        let by_rate = self.start[0] / rounding.rate;
        match (self.gap <= -self.sagitta, before) {
            (true, None) => by_gap,
            (true, Some(_)) => by_gap.max(by_rate - S::ONE),
            (false, _) => by_gap.max(by_rate + S::ONE),
        }
    }
}

impl<S: Scalar, C: Carrier<S>> World<'_, S, C> {
    /// Advances from the state so far by a length of time, into the trial state.
    fn advance(
        &mut self,
        method: Method,
        (t, length): (S, S),
        way: &mut PartialStep<S>,
    ) -> Result<(), Fault> {
        let (mut pressed, Sight { now: [from, from_low], trial: [x, low], room }) = way.pressed(self);
        x.iter_mut().zip(from.iter()).for_each(|(to, from)| *to = *from);
        low.iter_mut().zip(from_low.iter()).for_each(|(to, from)| *to = *from);
        method.step(&mut pressed, t, length, &mut State::resume(x, low)?, room).map(|_| ())
    }

    /// Advances over all the time left, or over a half, a quarter, ... of it where an implicit method finds no end of
    /// the step because friction turns round within it; returns how far.
    fn halve(&mut self, method: Method, (t, left): (S, S), way: &mut PartialStep<S>) -> Result<S, Fault> {
        let mut length = left;
        loop {
            match self.advance(method, (t, length), way) {
                Err(Fault::Unsettled) if way.rubs() && length > S::EPSILON * left => {
                    length = S::from_f64(0.5) * length;
                }
                done => return done.map(|()| length),
            }
        }
    }

    /// Advances over all the time left, or to the first event; returns how far.
    pub(super) fn shorten(
        &mut self,
        method: Method,
        (t, left): (S, S),
        way: &mut PartialStep<S>,
    ) -> Result<S, Fault> {
        let left = self.halve(method, (t, left), way)?;
        let last = self.clearance(t + left, way)?;
        if last >= S::ZERO {
            return Ok(left);
        }
        let near = S::from_f64(NEAR);
        let mut fault = None;
        let guard = |length: S| {
            // At the start no contact is new, pulls or has reversed its slip, and nothing says how far it is from that.
            if length <= S::ZERO || length >= left {
                return if length <= S::ZERO { -last } else { last + near };
            }
            let gone = self.advance(method, (t, length), way).and_then(|()| self.clearance(t + length, way));
            gone.map(|clear| clear + near).unwrap_or_else(|why| {
                // No end of the step: beyond the event.
                let unsettled = why == Fault::Unsettled && way.rubs();
                fault = fault.or((!unsettled).then_some(why));
                if unsettled { -S::ONE } else { S::ZERO }
            })
        };
        let found = reach(guard, [S::ZERO, left], S::from_f64(4.0) * S::EPSILON * left, near);
        if let Some(why) = fault {
            return Err(why);
        }
        // Stop behind the event: a new contact then touches within rounding, one that pulls has let go.
        let (before, length) = found.unwrap_or((left, left));
        match self.advance(method, (t, length), way) {
            Err(Fault::Unsettled) if way.rubs() && before > S::ZERO => {
                self.advance(method, (t, before), way).map(|()| before)
            }
            done => done.map(|()| length),
        }
    }

    /// Clearance of the trial state to the first event, negative beyond it: the least over all contacts, each in units
    /// of its rounding.
    fn clearance(&mut self, t: S, way: &mut PartialStep<S>) -> Result<S, Fault> {
        let dot = core::mem::take(&mut way.dots[1]);
        let (mut pressed, Sight { trial: [x, _], .. }) = way.pressed(self);
        let gone = pressed.rates(t, x, dot);
        way.dots[1] = dot;
        gone?;
        let list = way.pressing.get(..way.held).unwrap_or_default();
        let StepMemory { twists: [gained, twists, _], normals, extents, touches: [known, found], .. } =
            &mut *way.memory;
        Pressed::read_twists(self, twists);
        let count = self.detect((way.rounding.gap, true), normals, extents, found)?;
        let known = known.get(..way.known).unwrap_or_default();
        let mut clear = far::<S>();
        let scenery = self.scenery(normals, way.rounding.gap, true);
        for touch in found.iter_mut().take(count) {
            touch.start = touch.contact.relative(twists);
            if !list.iter().any(|own| touch.is(own.pair, own.id))
                && !scenery.is_outside(self.pairs, touch, (way.h, way.rounding.way))
            {
                let before = known.iter().find(|own| own.is(touch.pair, touch.id));
                clear = clear.min(touch.clearance(before, &way.rounding));
            }
        }
        let force = |own: &Pressing<S>| own.held.contact.impulse;
        let largest = list.iter().fold(S::ZERO, |most, own| most.max(force(own)[0].abs()));
        let light = S::from_f64(LIGHT) * largest;
        // A force that passes through 0 is exactly 0 over a short while, because accelerations are differences. Where
        // all are, none pulls yet and none is missing: no share of them is a number.
        let presses = largest > S::ZERO;
        for own in list {
            clear = if own.lost { -S::ONE } else { clear };
            let (n, mu) = (force(own)[0], own.held.contact.friction);
            if presses {
                clear = clear.min(n / light + S::ONE);
            }
            match own.slip {
                Some(first) if mu > S::ZERO => {
                    // Half of the speed that counts as rest, so that a contact that has stopped is found at rest.
                    let rest = S::from_f64(0.5) * way.rounding.rate;
                    clear = clear.min(vec3::dot(own.velocity, first) / rest + S::ONE);
                }
                Some(_) => {}
                None if presses => clear = clear.min(S::ONE - own.starts(gained, largest)),
                None => {}
            }
        }
        Ok(clear)
    }

    /// Energy accounts of the piece from the state so far to the trial state: powers by Simpson's rule.
    pub(super) fn works(
        &mut self,
        time: (S, S),
        way: &mut PartialStep<S>,
        watch: &mut impl Observer<S>,
    ) -> Result<Accounts<S>, Fault> {
        let [first, last, between] = core::mem::take(&mut way.dots);
        let (mut pressed, Sight { now: [old, _], trial: [new, _], .. }) = way.pressed(self);
        let sum = pressed.works(time, [old, new], [&mut *first, &mut *last, &mut *between], watch);
        way.dots = [first, last, between];
        sum
    }
}
