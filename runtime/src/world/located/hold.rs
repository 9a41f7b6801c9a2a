//! Lasting contacts at the start of a piece of a step: which of them push, and whether they stick or slide.

use super::{PartialStep, Sight};
use crate::mechanism::Fault;
use crate::ode::Ode;
use crate::real::Scalar;
use crate::rigid::contact::Twist;
use crate::rigid::hold::{Sought, hold, negligible};
use crate::rigid::scene::OVERLAP;
use crate::vec3;
use crate::world::carrier::Carrier;
use crate::world::detect::Touch;
use crate::world::pressed::Pressing;
use crate::world::whole::{StepMemory, World};

/// Forces below this share of the largest one count as zero.
pub(super) const LIGHT: f64 = 1e-9;
/// A slip that reverses at less than this share of its initial speed has come to rest.
const SLOW: f64 = 0.1;

impl<S: Scalar, C: Carrier<S>> World<'_, S, C> {
    /// Stops contacts whose slip has reversed slowly: towards the end of a slip its direction is known less and less,
    /// and the rest of it is the method's error. One that has passed to another face has no slip along the old one
    /// there.
    pub(super) fn stop(&mut self, t: S, way: &mut PartialStep<S>) -> Result<(), Fault> {
        let touches = way.memory.touches[0].get(..way.known).unwrap_or_default();
        let list = way.pressing.get_mut(..way.held).unwrap_or_default();
        let mut stopped = 0;
        for k in 0..list.len() {
            let Some(own) = list.get_mut(k) else { continue };
            let Some(first) = own.slip.filter(|_| own.held.contact.friction > S::ZERO) else { continue };
            let same = |touch: &&Touch<S>| touch.is(own.pair, own.id) && !own.turned(&touch.contact);
            let Some(touch) = touches.iter().find(same) else { continue };
            let slip = touch.contact.to_inertial([S::ZERO, touch.start[1], touch.start[2]]);
            if vec3::dot(slip, first) <= S::ZERO && vec3::norm(slip) <= S::from_f64(SLOW) * own.speed {
                (own.slip, own.held.contact, own.normal) = (None, touch.contact, touch.contact.axes[0]);
                list.swap(stopped, k);
                stopped += 1;
            }
        }
        way.held = stopped;
        if stopped == 0 {
            return Ok(());
        }
        let (mut pressed, Sight { now: [x, _], .. }) = way.pressed(self);
        pressed.set_time(t);
        pressed.project(x)?;
        self.find_touches(t, way)
    }

    /// Selects the contacts that push from here on, and whether each sticks or slides.
    pub(super) fn hold_at_start(&mut self, t: S, way: &mut PartialStep<S>) -> Result<(), Fault> {
        let (rate, deepest) = (way.rounding.rate, -S::from_f64(OVERLAP) * way.rounding.gap);
        let touches = way.memory.touches[0].get(..way.known).unwrap_or_default();
        for (pair, overlaps) in way.overlaps.iter_mut().enumerate() {
            *overlaps &= touches.iter().any(|touch| touch.pair == pair && touch.gap < deepest);
        }
        way.held = 0;
        let rests = |touch: &&Touch<S>| touch.start[0].abs() <= way.rounding.still && !touch.sharp;
        for touch in way.memory.touches[0].iter().take(way.known).filter(rests) {
            let own = way.pressing.get_mut(way.held).ok_or(Fault::TooManyContacts)?;
            let overlaps = way.overlaps.get(touch.pair).is_some_and(|overlaps| *overlaps);
            let kept = if overlaps && touch.gap < deepest { touch.gap } else { S::ZERO };
            // Twice: it goes on as it went. What is off by rounding alone is put back.
            let off = if kept < S::ZERO || touch.gap.abs() <= -deepest { S::ZERO } else { touch.gap.abs() };
            let off = S::from_f64(2.0) * off;
            *own = Pressing { pair: touch.pair, id: touch.id, kept, off, ..Pressing::empty() };
            (own.held.contact, own.normal) = (touch.contact, touch.contact.axes[0]);
            let [_, x, y] = touch.start;
            own.velocity = touch.contact.to_inertial([S::ZERO, x, y]);
            own.speed = vec3::norm(own.velocity);
            let ([_, x, y], speed) = vec3::direction([S::ZERO, x, y]);
            let smooth = touch.contact.friction <= S::ZERO;
            own.slip = match (smooth, speed > rate) {
                (true, _) => Some(vec3::zero()),
                (false, true) => Some(touch.contact.to_inertial([S::ZERO, x, y])),
                (false, false) => None,
            };
            way.held += 1;
        }
        if way.held == 0 {
            return Ok(());
        }
        let dot = core::mem::take(&mut way.dots[0]);
        let (mut pressed, Sight { now: [x, _], .. }) = way.pressed(self);
        let prepared = pressed.prepare(t, x, dot);
        way.dots[0] = dot;
        prepared?;
        let StepMemory { twists: [gained, ..], inertias, .. } = &mut *way.memory;
        gained.fill(Twist::zero());
        // A fixed node on a fixed surface: no force moves anything there, and none is needed.
        let list = way.pressing.get_mut(..way.held).unwrap_or_default();
        way.held = first_of(list, |own| own.held.inverse_mass[0][0] > S::ZERO);
        let list = way.pressing.get_mut(..way.held).unwrap_or_default();
        // The foot of a deep overlap may be another one than was detected: keep the gap that projections will measure.
        list.iter_mut().filter(|own| own.kept < S::ZERO).for_each(|own| own.kept = own.gap.min(S::ZERO));
        let sought = Sought { pulls: false, rough: true, least: negligible(rate, way.h) };
        hold(list, sought, &*inertias, gained)?;
        let largest = list.iter().fold(S::ZERO, |most, own| most.max(own.held.contact.impulse[0]));
        let mut held = 0;
        for k in 0..list.len() {
            let Some(own) = list.get_mut(k) else { continue };
            let ([n, x, y], mu) = (own.held.contact.impulse, own.held.contact.friction);
            if n <= S::from_f64(LIGHT) * largest {
                continue;
            }
            // Friction on its limit leaves an acceleration: it starts to slide against its friction force.
            let ([_, x, y], rub) = vec3::direction([S::ZERO, x, y]);
            let rims = rub >= mu * n * (S::ONE - S::from_f64(LIGHT));
            if own.slip.is_none() && rims && own.starts(gained, largest) > S::from_f64(0.5) {
                own.slip = Some(own.held.contact.to_inertial([S::ZERO, -x, -y]));
            }
            list.swap(held, k);
            held += 1;
        }
        way.held = held;
        Ok(())
    }
}

/// Moves the contacts that are kept to the front; returns their number.
fn first_of<S: Scalar>(list: &mut [Pressing<S>], keeps: impl Fn(&Pressing<S>) -> bool) -> usize {
    let mut kept = 0;
    for k in 0..list.len() {
        if list.get(k).is_some_and(&keeps) {
            list.swap(kept, k);
            kept += 1;
        }
    }
    kept
}
