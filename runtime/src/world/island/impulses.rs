//! How impulses change the speeds of an island: the inverse inertia of what they meet, and the velocities after them.

use super::super::carrier::{Carrier, Wrench};
use super::super::inertia::Inertias;
use super::{Cut, Island, free_nodes, write};
use crate::mechanism::Fault;
use crate::ode::Ode;
use crate::real::Scalar;
use crate::rigid::contact::{Contact, Twist};
use crate::vec3::{self, Vec3};

impl<S: Scalar, C: Carrier<S>> Island<'_, S, C> {
    /// Writes the inverse inertia of the `needed` ports and of all nodes at a state.
    pub(in super::super) fn ask_yields(
        &mut self,
        t: S,
        x: &[S],
        inertias: &mut Inertias<'_, S>,
        needed: impl Fn(usize) -> bool,
    ) -> Result<(), Fault> {
        let Cut { q, u, .. } = self.parts(x)?;
        inertias.ask(&mut self.carrier, t, (q, u), needed)?;
        for (node, yields) in inertias.nodes.iter_mut().enumerate() {
            *yields = self.body.inverse_mass(node);
        }
        Ok(())
    }

    /// Writes impulses of contacts, along n, t1, t2, as wrenches at the ports.
    pub(in super::super) fn load_impulses<'c>(
        &mut self,
        impulses: impl Iterator<Item = (&'c Contact<S>, Vec3<S>)>,
    ) where
        S: 'c,
    {
        let wrenches = &mut *self.memory.wrenches;
        wrenches.iter_mut().for_each(|wrench| *wrench = Wrench::zero());
        for (contact, impulse) in impulses {
            contact.deal(impulse, |body, arm, impulse| {
                if let Some(wrench) = wrenches.get_mut(body) {
                    wrench.force = vec3::add(wrench.force, impulse);
                    wrench.moment = vec3::add(wrench.moment, vec3::cross(arm, impulse));
                }
            });
        }
    }

    /// Writes the velocities of free nodes, which follow those of the ports in `twists`, into a state.
    pub(in super::super) fn set_speeds(&self, x: &mut [S], twists: &[Twist<S>]) -> Result<(), Fault> {
        let nodes = twists.get(self.memory.frames.len()..).ok_or(Fault::Shape)?;
        let parts = self.parts_mut(x)?;
        for (node, row) in free_nodes(&self.body).zip(parts.vel.chunks_exact_mut(3)) {
            write(row, nodes.get(node).ok_or(Fault::Shape)?.velocity);
        }
        Ok(())
    }

    /// Applies the wrenches in memory to the carrier of a state, as impulses (N s): u changes by M^-1 J' P. With
    /// `places` as displacements (kg m) instead: q changes by what those speeds do in 1 s. Each of the spare lists has
    /// one entry per entry of x.
    pub(in super::super) fn push_carrier(
        &mut self,
        t: S,
        x: &mut [S],
        [pushed, free, moved]: [&mut [S]; 3],
        places: bool,
    ) -> Result<(), Fault> {
        self.carrier_rates(t, x, pushed)?;
        self.memory.wrenches.iter_mut().for_each(|wrench| *wrench = Wrench::zero());
        self.carrier_rates(t, x, free)?;
        let (u, n_u) = (self.n_q(), self.carrier.n_u());
        let gains = pushed.iter().zip(free.iter()).skip(u).take(n_u);
        if !places {
            x.iter_mut().skip(u).zip(gains).for_each(|(x, (with, without))| *x = *x + (*with - *without));
            return Ok(());
        }
        moved.iter_mut().zip(x.iter()).for_each(|(to, from)| *to = *from);
        moved.iter_mut().skip(u).zip(gains).for_each(|(x, (with, without))| *x = *x + (*with - *without));
        self.carrier_rates(t, moved, pushed)?;
        let ways = pushed.iter().zip(free.iter()).take(self.carrier.n_q());
        x.iter_mut().zip(ways).for_each(|(x, (with, without))| *x = *x + (*with - *without));
        Ok(())
    }
}
