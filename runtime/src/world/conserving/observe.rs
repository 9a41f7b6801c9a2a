//! What a conserving step did: its energy accounts, and its mean forces and impulses for an observer.
//!
//! In: a step that was taken, with its mean forces and velocities. Out: works over the actual displacements.

use super::MeanMemory;
use crate::flexible::mean;
use crate::ode::nodes::MeanStep;
use crate::real::Scalar;
use crate::rigid::contact::Twist;
use crate::vec3;
use crate::world::accounts::Accounts;
use crate::world::carrier::Carrier;
use crate::world::observer::{Forces, Observer, Push};
use crate::world::whole::{StepMemory, World};

impl<S: Scalar, C: Carrier<S>> World<'_, S, C> {
    /// Energy accounts of this step: work of the mean forces over the actual displacements.
    pub(super) fn observe_means(
        &mut self,
        h: S,
        memory: &mut StepMemory<'_, S>,
        means: &mut MeanMemory<'_, S>,
        watch: &mut impl Observer<S>,
    ) -> Accounts<S> {
        let mut accounts = Accounts::empty();
        let island = &mut self.island;
        let [start, middle, change, velocity] = &means.nodes;
        let way = MeanStep { h, pos: [start, middle, island.memory.pos], dx: change, vel: velocity };
        accounts.damping = mean::dissipated(island.body.springs, &way);
        let squares = velocity.iter().fold(S::ZERO, |sum, v| sum + vec3::dot(*v, *v));
        accounts.drag = h * island.body.air_drag * squares;
        let ports = island.memory.frames.len();
        for (twist, velocity) in memory.twists[2].iter_mut().skip(ports).zip(velocity.iter()) {
            *twist = Twist { velocity: *velocity, angular: vec3::zero() };
        }
        means.read_ports(h, island.memory.frames, memory.twists[2]);
        for (frame, twist) in island.memory.frames.iter_mut().zip(memory.twists[2].iter()) {
            (frame.velocity, frame.angular_velocity) = (twist.velocity, twist.angular);
        }
        let (own, twists) = (&island.memory, &*memory.twists[2]);
        let mean = means.at(own.frames);
        for touch in memory.touches[0].get(..memory.counts[0]).unwrap_or_default() {
            let contact = mean.contact(&touch.contact);
            let ([n, x, y], [vn, vx, vy]) = (contact.impulse, contact.relative(twists));
            accounts.impact = accounts.impact - n * vn;
            accounts.friction = accounts.friction - (x * vx + y * vy);
        }
        island.carrier.drive_powers(own.frames, own.wrenches, &mut |member, power| {
            accounts.drive = accounts.drive + h * power;
            watch.carried(member, [h * power, S::ZERO]);
        });
        accounts
    }

    /// Shows this step, whose mean velocities are known: mean forces, what each damper takes, impulses.
    pub(super) fn show_means(
        &self,
        h: S,
        memory: &StepMemory<'_, S>,
        means: &MeanMemory<'_, S>,
        watch: &mut impl Observer<S>,
    ) {
        let (body, own) = (&self.island.body, &self.island.memory);
        let [start, middle, change, velocity] = &means.nodes;
        let ends = [&*memory.twists[2]; 2];
        watch.forces(&Forces { duration: h, elastic: own.elastic, viscous: own.viscous, ends });
        let way = MeanStep { h, pos: [start, middle, own.pos], dx: change, vel: velocity };
        for spring in body.springs {
            watch.damped(spring.tail, mean::dissipated(core::slice::from_ref(spring), &way));
        }
        for (node, v) in velocity.iter().enumerate() {
            watch.damped(node, h * body.air_drag * vec3::dot(*v, *v));
        }
        let mean = means.at(own.frames);
        for touch in memory.contacts() {
            let contact = &mean.contact(&touch.contact);
            watch.push(&Push {
                pair: touch.pair,
                contact,
                duration: S::ONE,
                ends,
                strikes: true,
                taken: S::ZERO,
            });
        }
    }
}
