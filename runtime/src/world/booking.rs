//! Accounts of a step, and what an observer sees of it.
//!
//! In: forces and impulses at the middle of the step, twists at its start and end. Out: work by account, and the forces
//! and pushes by node and pair. Work is taken over the mean of the velocities at start and end.

use super::accounts::Accounts;
use super::attachment::Attachment;
use super::carrier::Carrier;
use super::island::Island;
use super::observer::{Forces, Observer, Push};
use super::sweep;
use super::whole::{StepMemory, World};
use super::yielding::Yield;
use crate::real::Scalar;
use crate::rigid::contact::Twist;
use crate::vec3::{self, Vec3};

impl<S: Scalar, C: Carrier<S>> World<'_, S, C> {
    /// Energy accounts of this step, of which those of the free nodes are given: work of the forces at the middle over
    /// the mean of the velocities at start and end.
    pub(super) fn observe(
        &mut self,
        h: S,
        mut accounts: Accounts<S>,
        memory: &mut StepMemory<'_, S>,
        watch: &mut impl Observer<S>,
    ) -> Accounts<S> {
        let (half, taken) = (S::from_f64(0.5), h * self.power_taken());
        let own = &self.island.memory;
        let [start, _, end] = &memory.twists;
        let mean = |port: usize, arm: Vec3<S>| {
            let at = |list: &[Twist<S>]| list.get(port).map_or_else(vec3::zero, |twist| twist.at(arm));
            vec3::scale(vec3::add(at(start), at(end)), half)
        };
        for attachment in self.island.attachments {
            let origin = own.frames.get(attachment.port).map_or_else(vec3::zero, |frame| frame.origin);
            let arm = vec3::sub(vec3::at(own.pos, attachment.node), origin);
            let viscous = vec3::at(own.viscous, attachment.node);
            let velocity = mean(attachment.port, arm);
            take(&mut accounts, h, (viscous, self.island.body.air_drag), velocity);
        }
        let Island { carrier, memory: own, .. } = &mut self.island;
        let touches = memory.touches[0].get(..memory.counts[0]).unwrap_or_default();
        let [normal, friction] = sweep::works(touches, end);
        (accounts.impact, accounts.friction) = (taken - normal, -friction);
        for (port, frame) in own.frames.iter_mut().enumerate() {
            frame.velocity = mean(port, vec3::zero());
            let spin = |list: &[Twist<S>]| list.get(port).map_or_else(vec3::zero, |twist| twist.angular);
            frame.angular_velocity = vec3::scale(vec3::add(spin(start), spin(end)), half);
        }
        carrier.drive_powers(own.frames, own.wrenches, &mut |member, power| {
            accounts.drive = accounts.drive + h * power;
            watch.carried(member, [h * power, S::ZERO]);
        });
        accounts
    }

    /// Shows this step: forces and impulses at the middle, velocities at start and end.
    pub(super) fn show(&self, h: S, memory: &mut StepMemory<'_, S>, watch: &mut impl Observer<S>) {
        let own = &self.island.memory;
        let ports = own.frames.len();
        let [start, _, end] = &mut memory.twists;
        for node in self.island.node_rates() {
            for (twists, velocity) in [(&mut **start, node.velocity), (&mut **end, node.after(h))] {
                if let Some(twist) = twists.get_mut(ports + node.node) {
                    twist.velocity = velocity;
                }
            }
        }
        for Attachment { node, port, .. } in self.island.attachments {
            let origin = own.frames.get(*port).map_or_else(vec3::zero, |frame| frame.origin);
            let arm = vec3::sub(vec3::at(own.pos, *node), origin);
            for twists in [&mut **start, &mut **end] {
                let velocity = twists.get(*port).map_or_else(vec3::zero, |twist| twist.at(arm));
                if let Some(twist) = twists.get_mut(ports + *node) {
                    twist.velocity = velocity;
                }
            }
        }
        let ends = [&**start, &**end];
        watch.forces(&Forces { duration: h, elastic: own.elastic, viscous: own.viscous, ends });
        for touch in memory.touches[0].iter().take(memory.counts[0]) {
            let (pair, contact) = (touch.pair, &touch.contact);
            watch.push(&Push { pair, contact, duration: S::ONE, ends, strikes: true, taken: S::ZERO });
        }
        self.each_yield(|Yield { pair, contact, taken, .. }| {
            watch.push(&Push { pair: *pair, contact, duration: h, ends, strikes: false, taken: *taken });
        });
    }
}

/// Adds what the viscous force of a node takes at a mean velocity; the drag of the air is a part of it.
#[inline(always)]
pub(super) fn take<S: Scalar>(
    accounts: &mut Accounts<S>,
    h: S,
    (viscous, air_drag): (Vec3<S>, S),
    velocity: Vec3<S>,
) {
    let drag = vec3::scale(velocity, -air_drag);
    let damping = vec3::sub(viscous, drag);
    accounts.damping = accounts.damping - h * vec3::dot(damping, velocity);
    accounts.drag = accounts.drag - h * vec3::dot(drag, velocity);
}
