//! Forces of contacts as rows and pictures show them.
//!
//! In: located contacts that press after a step, whose forces are those of its middle. Out: their forces at the present
//! state, once a row, a picture or a controller asks.

use super::Touching;
use crate::contact_force::ContactForce;
use crate::world::pushed::Pushed;
use smartbed_runtime::mechanism::Fault;
use smartbed_runtime::ode::State;
use smartbed_runtime::real::Scalar;
use smartbed_runtime::vec3::Vec3;
use smartbed_runtime::world::{Carrier, Island, Pressing, World};

impl<S: Scalar> Touching<S> {
    /// Finds the forces of located contacts that rest at a state, before its next step of h, unless they are known.
    ///
    /// # Errors
    /// The step's, which it will have too.
    pub(in crate::world) fn press(
        &mut self,
        island: Island<'_, S, impl Carrier<S>>,
        (t, h): (S, S),
        state: &State<'_, S>,
    ) -> Result<(), Fault> {
        let Some(own) = self.located.as_mut().filter(|own| !own.pressed) else { return Ok(()) };
        own.pressed = true;
        let (_, _, mut memory) = own.parts(self.room.memory());
        let mut world = World { island, things: &self.things, pairs: &self.pairs };
        let pressing = world.press_located((t, h), state, &mut memory)?;
        self.show_pressing(pressing);
        Ok(())
    }

    /// The state is another one than that whose forces are known.
    pub(super) fn moved(&mut self) {
        self.located.iter_mut().for_each(|own| own.pressed = false);
    }

    /// Keeps the forces of so many lasting contacts for rows and pictures.
    pub(super) fn show_pressing(&mut self, count: usize) {
        let pressing = self.located.iter().flat_map(|own| own.pressing.iter().take(count));
        self.pushed = Pushed::new(self.pairs.len());
        for own in pressing.clone() {
            let contact = &own.held.contact;
            self.pushed.add(own.pair, self.bodies[own.pair].each_ref(), contact, contact.impulse);
        }
        let force = |own: &Pressing<S>| {
            let contact = &own.held.contact;
            between(self.moves[own.pair], own.place, contact.axes, contact.impulse)
        };
        self.forces = pressing.filter_map(force).collect();
    }
}

/// A force as pictures show it.
pub(super) fn between<S: Scalar>(
    moves: [bool; 2],
    point: Vec3<S>,
    axes: [Vec3<S>; 3],
    force: Vec3<S>,
) -> Option<ContactForce> {
    let wide = |x: Vec3<S>| x.map(S::to_f64);
    ContactForce::between(moves, wide(point), axes.map(wide), wide(force))
}
