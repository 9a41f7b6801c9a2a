//! Corrections that put a state back onto its lasting contacts: displacements that close gaps, impulses that end their
//! rates.
//!
//! In: contacts with the change that each of them wants. Out: a state moved by W M^-1 W' z, with z such that every
//! change is reached (Gauss-Seidel sweeps).

use super::{Pressed, Pressing};
use crate::mechanism::Fault;
use crate::real::Scalar;
use crate::rigid::anderson::Anderson;
use crate::rigid::contact::{Twist, solve_tangential};
use crate::rigid::sweeps::{PLAIN, Patience, fine};
use crate::vec3::{self, Vec3};
use crate::world::carrier::Carrier;
use crate::world::island::free_nodes;
use crate::world::whole::StepMemory;

/// Most sweeps over the contacts.
const SWEEPS: usize = 2000;
/// Sweeps within which what is left halves at least; else it is rounding of redundant contacts, or gaps that no
/// position closes together, as those of a box's four corners.
const PATIENCE: usize = 40;

impl<S: Scalar, C: Carrier<S>> Pressed<'_, '_, '_, S, C> {
    /// Corrections that change each contact's relative velocity (or gap) by `wanted`; with `across`, tangentially too
    /// where it sticks.
    pub(super) fn correct(&mut self, across: bool, wanted: impl Fn(&Pressing<S>) -> Vec3<S>) {
        let StepMemory { twists: [gained, ..], inertias, .. } = &mut *self.memory;
        gained.fill(Twist::zero());
        let mut scale = S::ZERO;
        for own in self.list.iter_mut() {
            // The forces wait in the place of the corrections, which are swept in theirs.
            (own.correction, own.held.contact.impulse) = (own.held.contact.impulse, vec3::zero());
            scale = scale.max(vec3::norm(wanted(own)));
        }
        let (mut anderson, mut patience) =
            (Anderson::new(), Patience::new(PATIENCE, S::from_f64(f64::INFINITY)));
        for number in 0..SWEEPS {
            let mut left = S::ZERO;
            for own in self.list.iter_mut() {
                let (aim, k) = (wanted(own), own.held.inverse_mass);
                let contact = &own.held.contact;
                let off = aim[0] - contact.relative(gained)[0];
                let mut more = [off / k[0][0], S::ZERO, S::ZERO];
                contact.push(inertias, gained, more);
                left = left.max(off.abs());
                if across && own.slip.is_none() {
                    let [_, x, y] = vec3::sub(aim, contact.relative(gained));
                    left = left.max(x.abs()).max(y.abs());
                    let [x, y] = solve_tangential(&k, [x, y]);
                    contact.push(inertias, gained, [S::ZERO, x, y]);
                    (more[1], more[2]) = (x, y);
                }
                own.held.contact.impulse = vec3::add(own.held.contact.impulse, more);
                own.held.history.moved = more;
            }
            if patience.ends(number, left) || left <= fine::<S>(number) * scale {
                break;
            }
            if (PLAIN..SWEEPS - 1).contains(&number) {
                anderson.record(self.list);
                anderson.extrapolate(self.list, inertias, gained);
            }
        }
        for own in self.list.iter_mut() {
            core::mem::swap(&mut own.correction, &mut own.held.contact.impulse);
        }
    }

    /// Applies the corrections to a state: with `places` as displacements, else as impulses.
    pub(super) fn move_by_corrections(&mut self, t: S, x: &mut [S], places: bool) -> Result<(), Fault> {
        let ports = self.world.island.memory.frames.len();
        let impulses = self.list.iter().map(|own| (&own.held.contact, own.correction));
        self.world.island.load_impulses(impulses);
        let island = &mut self.world.island;
        let gained = self.memory.twists[0].get(ports..).unwrap_or_default();
        let parts = island.parts_mut(x)?;
        let rows = if places { parts.pos } else { parts.vel };
        for (node, row) in free_nodes(&island.body).zip(rows.chunks_exact_mut(3)) {
            let change = gained.get(node).map_or_else(vec3::zero, |twist| twist.velocity);
            row.iter_mut().zip(change).for_each(|(x, change)| *x = *x + change);
        }
        let on_ports = |port: usize| self.list.iter().any(|own| own.held.contact.touches_body(port));
        if island.carrier.n_u() == 0 || !(0..ports).any(on_ports) {
            return Ok(());
        }
        let [pushed, free, moved] = &mut self.spare;
        island.push_carrier(t, x, [&mut **pushed, &mut **free, &mut **moved], places)
    }
}
