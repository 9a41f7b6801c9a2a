//! Contact impulses of a conserving step, whose arms turn while they act.
//!
//! In: a span being iterated, the rates that its forces give without contacts. Out: impulses, loaded on nodes and ports.
//! ```text
//! V    mean velocity at the mean arms: the work of an impulse P is P . V, exactly (`means`)
//! law  e > 0: for v_n+ = 2 V_n - v_n-, so that J (v_n- + v_n+)/2 is that work: J (1 - e) v_n-/2, never a gain
//! ```
//! Laws are solved for velocities that are linear in the impulses, with the arms where contacts were detected. What v_n+
//! differs from those by is taken from the iteration before, `Touch::turned`, until both agree. Friction, and what does
//! not rebound, take v+ with the arms of the detection: the error, of order h, is less than what they dissipate.

use super::{MeanMemory, Span};
use crate::mechanism::Fault;
use crate::real::Scalar;
use crate::vec3;
use crate::world::carrier::Carrier;
use crate::world::contacts::{load_contacts, press};
use crate::world::detect::Touch;
use crate::world::island::free_nodes;
use crate::world::sweep::Sweeps;
use crate::world::whole::{StepMemory, World};

impl<S: Scalar, C: Carrier<S>> World<'_, S, C> {
    /// Computes the impulses and loads their mean forces, given the state at which contacts were detected and the rates
    /// without contacts. `spare`: memory.
    pub(super) fn press_turning(
        &mut self,
        span: &Span<'_, S>,
        [touched, found]: [&[S]; 2],
        spare: &mut [S],
        memory: &mut StepMemory<'_, S>,
        means: &MeanMemory<'_, S>,
    ) -> Result<Sweeps<S>, Fault> {
        if self.turns(memory) {
            self.read_turned(span, [touched, found], spare, memory, means)?;
        }
        self.read_ends(span, [touched, found], spare, memory)?;
        let sweeps = press(span.h, memory);
        let own = &mut self.island.memory;
        let mean = means.at(own.frames);
        let contacts = memory.contacts().iter().map(|touch| mean.contact(&touch.contact));
        load_contacts(span.h, contacts, (&mut *own.elastic, &mut *own.wrenches));
        Ok(sweeps)
    }

    /// Reads by how much the speeds of the rates with contacts differ from those that the laws were solved for.
    pub(super) fn read_missed(
        &mut self,
        span: &Span<'_, S>,
        [touched, found]: [&[S]; 2],
        spare: &mut [S],
        memory: &mut StepMemory<'_, S>,
    ) -> Result<(), Fault> {
        if !self.turns(memory) {
            return Ok(());
        }
        self.read_ends(span, [touched, found], spare, memory)?;
        let StepMemory { twists: [_, given, solved], touches: [now, _], counts, .. } = memory;
        for touch in now.iter_mut().take(counts[0]) {
            let [given, solved] = [&*given, &*solved].map(|twists| touch.contact.relative(twists)[0]);
            touch.missed = given - solved;
        }
        Ok(())
    }

    /// Whether something rebounds that has arms: nodes have none.
    fn turns(&self, memory: &StepMemory<'_, S>) -> bool {
        let ports = self.island.memory.frames.len();
        memory.contacts().iter().any(|touch| {
            touch.contact.restitution > S::ZERO && touch.contact.points().any(|(_, point)| point.body < ports)
        })
    }

    /// Reads how far what rebounds is from the linear effect of its impulses, 2 V - v- against that. Ports go where the
    /// speeds of the span carry them, not those of the iteration before: else an impulse would be seen at the end, but
    /// not in the mean.
    fn read_turned(
        &mut self,
        span: &Span<'_, S>,
        [touched, found]: [&[S]; 2],
        spare: &mut [S],
        memory: &mut StepMemory<'_, S>,
        means: &MeanMemory<'_, S>,
    ) -> Result<(), Fault> {
        self.read_ends(span, [touched, &*span.rates], spare, memory)?;
        let island = &mut self.island;
        let n_q = island.carrier.n_q();
        let ways = span.start.iter().zip(found);
        spare.iter_mut().zip(ways).take(n_q).for_each(|(to, (from, rate))| *to = *from + span.h * *rate);
        let (q, u) = (spare.get(..n_q).ok_or(Fault::Shape)?, island.parts(span.end)?.u);
        island.carrier.frames(span.t + span.h, q, u, island.memory.frames)?;
        let (frames, half) = (&*island.memory.frames, S::from_f64(0.5));
        let StepMemory { twists: [start, end, mean], touches: [now, _], counts, .. } = memory;
        means.read_ports(span.h, frames, mean);
        let nodes = mean.iter_mut().zip(start.iter().zip(end.iter())).skip(frames.len());
        for (to, (from, end)) in nodes {
            to.velocity = vec3::scale(vec3::add(from.velocity, end.velocity), half);
        }
        let rebounding = |touch: &&mut Touch<S>| touch.contact.restitution > S::ZERO;
        for touch in now.iter_mut().take(counts[0]).filter(rebounding) {
            let way = means.at(frames).contact(&touch.contact).relative(mean)[0];
            let [from, to] = [&*start, &*end].map(|twists| touch.contact.relative(twists)[0]);
            let turned = (way + way) - from - to + touch.missed;
            // What rounding of places looks like in a step would move what rests.
            let is_rounding = turned.abs() <= touch.rounding() / span.h;
            touch.turned = if is_rounding { S::ZERO } else { turned };
        }
        Ok(())
    }

    /// Velocities at the end of a span under these rates: of the ports where contacts were detected, and of the nodes.
    fn read_ends(
        &mut self,
        span: &Span<'_, S>,
        [touched, rates]: [&[S]; 2],
        spare: &mut [S],
        memory: &mut StepMemory<'_, S>,
    ) -> Result<(), Fault> {
        self.carry_ends((span.t + span.h, span.h), [touched, rates], spare, memory)?;
        let ports = self.island.memory.frames.len();
        let [from, rates] =
            [self.island.parts(touched)?, self.island.parts(rates)?].map(|x| x.vel.as_chunks::<3>().0);
        for (node, (start, rate)) in free_nodes(&self.island.body).zip(from.iter().zip(rates)) {
            if let Some(twist) = memory.twists[1].get_mut(ports + node) {
                twist.velocity = vec3::axpy(*start, span.h, *rate);
            }
        }
        Ok(())
    }
}
