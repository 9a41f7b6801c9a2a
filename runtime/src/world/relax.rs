//! A step on the way to rest: what a step does while time stands still and nothing rebounds, then parts leave one
//! another where they overlap.
//!
//! In: as for a step. Out: the same, and the speed at which parts were moved apart.
//! ```text
//! x <- x + h w,   w = M^-1 W' P,   w_n >= share of the overlap / h,  no friction, no speed kept
//! ```
//! Overlaps are not removed by the step's own impulses: sticking contacts would resist, and two contacts that have to
//! separate at different speeds may contradict one another for ever (positions split from velocities: Guendelman,
//! Bridson & Fedkiw 2003).

use super::carrier::Carrier;
use super::contacts::load_contacts;
use super::step::{Course, StepReport};
use super::sweep::sweep;
use super::whole::{StepMemory, World};
use crate::mechanism::Fault;
use crate::ode::{Ode, State, state::advance, trial::split};
use crate::real::Scalar;
use crate::rigid::contact::Twist;
use crate::vec3;

/// Share of an overlap that one step removes.
const OUT: f64 = 0.2;

impl<S: Scalar, C: Carrier<S>> World<'_, S, C> {
    /// A step towards rest, with the time frozen at t. Returns its report and the largest speed (m/s, rad/s) at which
    /// overlapping parts were moved apart. Energy is not conserved.
    ///
    /// # Errors
    /// As [`World::step`]; if only the separation is refused, the state is that after the step.
    pub fn relax(
        &mut self,
        t: S,
        h: S,
        state: &mut State<'_, S>,
        memory: &mut StepMemory<'_, S>,
    ) -> Result<(StepReport<S>, S), Fault> {
        self.check(h)?;
        let report = self.step_at((&Course { times: [t; 3], rebounds: false }, h), state, memory, &mut ())?;
        let scratch = core::mem::take(&mut memory.scratch);
        // The contacts of the step are kept in the second list during the separation.
        memory.swap_lists();
        let leaving = self.leave((t, h), state, scratch, memory);
        memory.swap_lists();
        memory.scratch = scratch;
        Ok((report, leaving?))
    }

    /// Moves overlapping parts apart.
    fn leave(
        &mut self,
        (t, h): (S, S),
        state: &mut State<'_, S>,
        scratch: &mut [S],
        memory: &mut StepMemory<'_, S>,
    ) -> Result<S, Fault> {
        let (n, n_q) = (self.island.n_x(), self.island.n_q());
        let [here, without, with, new, low] = split(scratch, n)?;
        here.copy_from_slice(state.x());
        self.island.place(t, here)?;
        self.find_contacts((t, h), here, memory)?;
        let touches = memory.touches[0].get_mut(..memory.counts[0]).unwrap_or_default();
        for touch in touches.iter_mut() {
            touch.out = S::from_f64(OUT) * (-touch.gap).max(S::ZERO) / h;
            (touch.start, touch.contact.impulse, touch.contact.friction) =
                (vec3::zero(), vec3::zero(), S::ZERO);
        }
        if touches.iter().all(|touch| touch.out <= S::ZERO) {
            return Ok(S::ZERO);
        }
        let [.., twists] = &mut memory.twists;
        twists.fill(Twist::zero());
        let ports = memory.inertias.couplings.len();
        sweep(touches, h, ports, &memory.inertias, twists);

        // Speeds caused by the impulses alone: rates with them minus rates without.
        self.load_seams()?;
        self.island.accelerate(t, here, without)?;
        let own = &mut self.island.memory;
        let forces = (&mut *own.elastic, &mut *own.wrenches);
        load_contacts(h, memory.contacts().iter().map(|touch| touch.contact), forces);
        self.island.accelerate(t, here, with)?;
        let mut fastest = S::ZERO;
        new.copy_from_slice(here);
        for (to, (with, without)) in new.iter_mut().zip(with.iter().zip(without.iter())).skip(n_q) {
            *to = h * (*with - *without);
            fastest = fastest.max(to.abs());
        }
        let rates = with;
        self.coast(t, new, rates)?;
        for (index, (x, l)) in state.entries().enumerate() {
            let way = rates.get(index).filter(|_| index < n_q).map_or(S::ZERO, |rate| h * *rate);
            if let (Some(to), Some(to_low)) = (new.get_mut(index), low.get_mut(index)) {
                (*to, *to_low) = advance(*x, *l, way);
            }
        }
        self.project(t, [&mut *new, &mut *low, here])?;
        for ((x, l), (new, new_low)) in state.entries().zip(new.iter().zip(low.iter())) {
            (*x, *l) = (*new, *new_low);
        }
        Ok(fastest)
    }
}
