//! A piece of a step in which contact forces were not found, or do not exist: contacts act by impulses over it.
//!
//! In: the middle of the piece without contacts. Out: impulses, as mean forces; velocities half-way between start and
//! end.
//! ```text
//! W (v + h a) + h/2 W' u + W M^-1 W' P:   0 <= P_n, 0 <= v_n+, P_n v_n+ = 0     |P_t| <= mu P_n, against the slip left
//! ```
//! Where friction jams a sliding contact (Painleve), its impulse grows until it sticks: such a solution there always
//! is. Contacts take no more energy than there is, also where the sweeps end early. Of order 1.

use super::advance::{By, Start};
use super::memory::Memory;
use super::parts::RigidScene;
use super::touching::Touching;
use crate::real::Scalar;
use crate::rigid::share::press;
use crate::vec3;

impl Start {
    /// Lets contacts act by impulses from here on: forces and slips of the start mean nothing then.
    pub(super) fn give_up_forces<S: Scalar>(&mut self, memory: &mut Memory<S>) {
        self.by = By::Impulses;
        for t in memory.touching.iter_mut().take(self.held) {
            (t.held.contact.impulse, t.held.slip) = (vec3::zero(), None);
        }
    }
}

impl<S: Scalar> RigidScene<'_, S> {
    /// Finds the impulses of the first `count` contacts of `along` over a piece of this length, in whose middle they
    /// are; `held` contacts were there at its start.
    pub(super) fn find_impulses(&self, memory: &mut Memory<S>, [held, count]: [usize; 2], length: S) {
        let Memory { states: [.., middle], twists, spare, mobilities, touching, along, .. } = memory;
        let half = S::from_f64(0.5);
        self.fall(middle, twists, mobilities, spare);
        // Velocities at the end without contacts, divided by the length: what impulses add is then what forces do.
        for (free, rates) in spare.iter_mut().zip(twists.iter()) {
            free.velocity = vec3::axpy(vec3::scale(free.velocity, half), S::ONE / length, rates.velocity);
            free.angular = vec3::axpy(vec3::scale(free.angular, half), S::ONE / length, rates.angular);
        }
        let list = along.get_mut(..count).unwrap_or_default();
        for t in list.iter_mut() {
            (t.held.contact.impulse, t.held.slip) = (vec3::zero(), None);
            t.held.bias = vec3::scale(t.held.bias, half);
        }
        press(list, &**mobilities, spare);
        let before = power(list);
        let mut add = |list: &mut [Touching<S>], share: S| {
            for t in list.iter() {
                let force = t.held.contact.impulse;
                t.held.contact.push(&**mobilities, twists, vec3::scale(force, share * half * length));
            }
            list.iter_mut().for_each(|t| t.velocity = t.held.contact.relative(twists));
        };
        add(list, S::ONE);
        let after = power(list);
        if after > S::ZERO {
            // The power is linear in a common factor of all forces, but for what they add to the velocities themselves.
            let part = if before < S::ZERO { -(before / (after - before)) } else { S::ZERO };
            add(list, part - S::ONE);
            list.iter_mut().for_each(|t| t.held.contact.impulse = vec3::scale(t.held.contact.impulse, part));
        }
        // A contact that pushes must not pass to another face or edge within the piece.
        for t in touching.iter_mut().take(held) {
            let same = list.iter().find(|own| own.stays_as(t));
            t.held.contact.impulse = same.map_or_else(vec3::zero, |own| own.held.contact.impulse);
        }
    }
}

/// Power of the contacts' forces at their velocities (W).
fn power<S: Scalar>(list: &[Touching<S>]) -> S {
    list.iter().fold(S::ZERO, |sum, t| sum + vec3::dot(t.held.contact.impulse, t.velocity))
}
