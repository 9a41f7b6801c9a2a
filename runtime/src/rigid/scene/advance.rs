//! Advances between events: contact forces at the start and in the middle, or impulses; clearance at the end,
//! projection of drift.

use super::memory::{Memory, Report};
use super::parts::{Fault, NEAR, RigidScene, Rounding};
use super::touching::Touching;
use crate::real::Scalar;
use crate::rigid::RigidState;
use crate::rigid::contact::{Mobility, Twist, solve_tangential};
use crate::rigid::hold::{CORNERS, Held, Slip, Sought, Unheld, hold};
use crate::rigid::motion;
use crate::vec3::{self, Vec3};

/// Most sweeps of a projection.
const SWEEPS: usize = 200;

/// Share of the kinetic energy, and of that of a free fall, by which a piece under forces may miss its energy account.
const LEEWAY: f64 = 0.05;

/// How lasting contacts act over a piece.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum By {
    /// By forces, at the start and in the middle.
    Forces,
    /// By impulses over the piece, where there are no such forces or none were found.
    Impulses,
}

/// Number of lasting contacts at the start of a piece, and number of all features that touch there.
#[derive(Clone, Copy)]
pub(super) struct Start {
    pub(super) held: usize,
    pub(super) known: usize,
    pub(super) by: By,
}

/// Clearance to the first event; negative beyond it.
pub(super) struct Clearance<S> {
    /// Whether a contact that pushed has passed to another face, edge or end.
    lost: bool,
    /// Least gap of features that do not touch yet, in gaps that count as zero.
    gap: S,
    /// Least speed of slip along its direction at the start, in speeds that count as zero.
    slip: S,
}

impl<S: Scalar> Clearance<S> {
    /// Clearance less that at an event, where a gap or a slip has just passed zero.
    pub(super) fn to_event(&self) -> S {
        let passed = if self.lost { -S::from_f64(2.0) } else { self.gap.min(self.slip) };
        passed + S::from_f64(NEAR)
    }
}

impl<S: Scalar> RigidScene<'_, S> {
    /// Detects the contacts at the start of a piece: first the lasting ones, with their forces, then those that open.
    pub(super) fn hold_at_start(
        &self,
        memory: &mut Memory<S>,
        rounding: Rounding<S>,
        h: S,
    ) -> Result<Start, Fault> {
        let Memory { states: [now, ..], twists, mobilities, touching, .. } = memory;
        let known = self.detect(now, twists, mobilities, touching, rounding.gap, |_| true)?;
        let touching = touching.get_mut(..known).unwrap_or_default();
        let mut held = 0;
        for k in 0..known {
            let lasts = touching.get(k).is_some_and(|t| t.velocity[0].abs() <= rounding.rate);
            if lasts {
                touching.swap(held, k);
                held += 1;
            }
        }
        for t in touching.iter_mut().take(held) {
            let ([_, x, y], speed) = vec3::direction([S::ZERO, t.velocity[1], t.velocity[2]]);
            let slides = speed > rounding.rate && t.held.contact.friction > S::ZERO;
            t.held.slip = slides.then_some(Slip::new([x, y], speed, h, S::from_f64(CORNERS)));
        }
        let mut start = Start { held, known, by: By::Forces };
        if self.find_forces(memory, 0, held, rounding).is_err() {
            start.give_up_forces(memory);
        }
        Ok(start)
    }

    /// Computes the forces of the first `count` contacts of `touching` (stage 0, at the start) or `along` (stage 1, in
    /// the middle).
    fn find_forces(
        &self,
        memory: &mut Memory<S>,
        stage: usize,
        count: usize,
        rounding: Rounding<S>,
    ) -> Result<(), Unheld> {
        let Memory { states: [now, _, middle], twists, spare, mobilities, touching, along, .. } = memory;
        let (states, list) = if stage == 0 { (now, touching) } else { (middle, along) };
        self.fall(states, twists, mobilities, spare);
        let list = list.get_mut(..count).unwrap_or_default();
        let sought = Sought { pulls: false, rough: false, least: rounding.acceleration };
        hold(list, sought, &**mobilities, spare)
    }

    /// Accelerations without contacts: free fall, and m' = 0 with m = J omega: J omega' = -omega x m.
    pub(super) fn fall(
        &self,
        states: &[RigidState<S>],
        twists: &[Twist<S>],
        mobilities: &[Mobility<S>],
        free: &mut [Twist<S>],
    ) {
        let rows = states.iter().zip(twists).zip(mobilities);
        for ((part, ((state, rates), mobility)), free) in self.parts.iter().zip(rows).zip(free) {
            let turning = vec3::cross(state.angular_momentum, rates.angular);
            let angular = vec3::apply(&mobility.inverse_inertia, turning);
            *free = match part.body {
                Some(_) => Twist { velocity: self.gravity, angular },
                None => Twist::zero(),
            };
        }
    }

    /// Advances the states so far by a length of time into the trial states; returns the number of contacts in `along`.
    /// From the first piece whose forces are not found on, contacts act by impulses.
    pub(super) fn advance(
        &self,
        memory: &mut Memory<S>,
        length: S,
        start: &mut Start,
        rounding: Rounding<S>,
    ) -> Result<usize, Fault> {
        let half = S::from_f64(0.5) * length;
        if start.by == By::Forces {
            if let Some(count) = self.advance_by_forces(memory, length, start.held, rounding)? {
                return Ok(count);
            }
            start.give_up_forces(memory);
        }
        self.move_by(memory, 0, 0, half)?;
        let count = self.meet_again(memory, start.held, rounding)?;
        self.find_impulses(memory, [start.held, count], length);
        self.move_by(memory, 1, count, length)?;
        Ok(count)
    }

    /// The same by forces; None where they are not found, or so large next to a jam that no step follows them.
    fn advance_by_forces(
        &self,
        memory: &mut Memory<S>,
        length: S,
        held: usize,
        rounding: Rounding<S>,
    ) -> Result<Option<usize>, Fault> {
        if self.move_by(memory, 0, held, S::from_f64(0.5) * length).is_err() {
            return Ok(None);
        }
        let count = self.meet_again(memory, held, rounding)?;
        let found = self.find_forces(memory, 1, count, rounding).is_ok();
        let moved = found && self.move_by(memory, 1, count, length).is_ok();
        Ok((moved && self.spends(memory, count, length, rounding)).then_some(count))
    }

    /// Whether the trial states have about the energy that friction leaves, and it takes some: next to a jam forces
    /// grow beyond bounds within a piece.
    fn spends(&self, memory: &Memory<S>, count: usize, length: S, rounding: Rounding<S>) -> bool {
        let [now, trial, _] = &memory.states;
        let along = memory.along.get(..count).unwrap_or_default();
        let friction = |t: &Touching<S>| {
            let [_, x, y] = t.held.contact.impulse;
            -(x * t.velocity[1] + y * t.velocity[2])
        };
        let lost = length * along.iter().fold(S::ZERO, |sum, t| sum + friction(t));
        let ([before, kinetic], [after, later]) = (self.energies(now), self.energies(trial));
        // What falls freely meanwhile gets this speed.
        let fall = length * vec3::norm(self.gravity);
        let bodies = self.parts.iter().filter_map(|part| part.body);
        let falling = bodies.fold(S::ZERO, |sum, body| sum + body.mass * fall * fall);
        let rounded = rounding.share * (before.abs() + after.abs());
        let leeway = S::from_f64(LEEWAY) * (kinetic + later + falling) + rounded;
        lost >= -leeway && (after - before + lost).abs() <= leeway
    }

    /// Detects the contacts of the start again in the middle of the piece, with initial forces and slip.
    fn meet_again(&self, memory: &mut Memory<S>, held: usize, rounding: Rounding<S>) -> Result<usize, Fault> {
        let Memory { states: [_, _, middle], twists, mobilities, touching, along, .. } = memory;
        let start = touching.get(..held).unwrap_or_default();
        let same = |t: &Touching<S>| start.iter().find(|s| s.stays_as(t));
        let count = self.detect(middle, twists, mobilities, along, rounding.drift, |t| same(t).is_some())?;
        for t in along.iter_mut().take(count) {
            let Some(before) = same(t) else { continue };
            t.held.contact.impulse = before.held.contact.impulse;
            if let Some(known) = before.held.slip {
                let slip = t.held.contact.to_inertial([S::ZERO, t.velocity[1], t.velocity[2]]);
                let first = before.slip();
                let step = (known.horizon, known.together);
                t.held.slip = Some(Slip::now(&t.held.contact, [slip, first], S::ZERO, step));
            }
        }
        Ok(count)
    }

    /// Advances the states so far by a length of time with the forces of a stage: 0 into the middle, 1 into the trial
    /// states.
    fn move_by(&self, memory: &mut Memory<S>, stage: usize, count: usize, length: S) -> Result<(), Fault> {
        let Memory { states: [now, trial, middle], touching, along, .. } = memory;
        let (list, target) = if stage == 0 { (touching, middle) } else { (along, trial) };
        let list = list.get(..count).unwrap_or_default();
        for (k, ((part, state), to)) in self.parts.iter().zip(now.iter()).zip(target.iter_mut()).enumerate() {
            *to = *state;
            let Some(body) = &part.body else { continue };
            let (mut force, mut moment) = (vec3::scale(self.gravity, body.mass), vec3::zero());
            for contact in list.iter().map(|t| &t.held.contact) {
                contact.deal(contact.impulse, |number, arm, own| {
                    if number == k {
                        force = vec3::add(force, own);
                        moment = vec3::add(moment, vec3::cross(arm, own));
                    }
                });
            }
            motion::advance(body, to, force, moment, length).map_err(|_| Fault::TooFast)?;
        }
        Ok(())
    }

    /// Clearance at the end of the trial piece.
    pub(super) fn clearance(&self, memory: &Memory<S>, start: Start, rounding: Rounding<S>) -> Clearance<S> {
        let [_, trial, _] = &memory.states;
        let held = memory.touching.get(..start.held).unwrap_or_default();
        let parting = memory.touching.get(start.held..start.known).unwrap_or_default();
        let far = S::ONE / S::EPSILON;
        let far = Clearance { lost: false, gap: rounding.drift / rounding.gap, slip: far };
        let (mut clear, mut stay) = (far, 0);
        let pushes = |t: &Touching<S>| t.held.contact.impulse[0] > S::ZERO;
        self.visit(trial, rounding.drift, |pair, feature| {
            let found = (feature.id, feature.curved, feature.normal);
            stay += held.iter().filter(|t| pushes(t) && t.stays(pair, found)).count();
            if !held.iter().any(|t| t.is(pair, feature.id)) {
                // An overlap that is opening counts as new only where it goes deeper, by more than rounding.
                let known = parting.iter().find(|t| t.is(pair, feature.id));
                let depth = known.map_or(S::ZERO, |t| t.gap.min(S::ZERO) - rounding.length);
                clear.gap = clear.gap.min((feature.gap - depth) / rounding.gap);
            }
        });
        clear.lost = stay < held.iter().filter(|t| pushes(t)).count();
        for t in held.iter().filter(|t| t.held.slip.is_some()) {
            clear.slip = clear.slip.min(self.slip_along(trial, t) / rounding.rate);
        }
        clear
    }

    /// Slip speed, along the direction at the start, of the material points that touched then.
    fn slip_along(&self, states: &[RigidState<S>], t: &Touching<S>) -> S {
        let contact = &t.held.contact;
        let [one, other] = contact.sides.map(|side| {
            side.points().fold(vec3::zero(), |sum, point| {
                let body = self.parts.get(point.body).and_then(|part| part.body);
                match (body, states.get(point.body)) {
                    (Some(body), Some(state)) => vec3::add(sum, body.point_velocity(state, point.arm)),
                    _ => sum,
                }
            })
        });
        vec3::dot(t.slip(), vec3::sub(one, other))
    }

    /// Accepts the piece: the trial states become the states so far.
    pub(super) fn commit(
        &self,
        memory: &mut Memory<S>,
        (length, by): (S, By),
        count: usize,
        report: &mut Report<S>,
    ) {
        let [now, trial, _] = &mut memory.states;
        now.iter_mut().zip(trial.iter()).for_each(|(to, from)| *to = *from);
        (report.held, report.pressing) = (0, S::ZERO);
        for t in memory.along.iter().take(count) {
            let [normal, x, y] = t.held.contact.impulse;
            if normal > S::ZERO {
                report.held += 1;
                report.pressing = report.pressing + normal;
                let power = x * t.velocity[1] + y * t.velocity[2];
                report.friction_loss = report.friction_loss - length * power;
                if by == By::Impulses {
                    report.impact_loss = report.impact_loss - length * normal * t.velocity[0];
                }
            }
        }
    }

    /// Projects contacts that push: gap and gap rate to 0, and tangential velocity to 0 where they stick.
    pub(super) fn project(
        &self,
        memory: &mut Memory<S>,
        pressing: usize,
        rounding: Rounding<S>,
    ) -> Result<(), Fault> {
        if pressing == 0 {
            return Ok(());
        }
        let Memory { states: [now, ..], twists, spare, mobilities, touching, along, .. } = memory;
        let along = along.get(..pressing).unwrap_or_default();
        let presses = |t: &Touching<S>| {
            along.iter().find(|a| a.stays_as(t)).filter(|a| a.held.contact.impulse[0] > S::ZERO)
        };
        let wanted = |t: &Touching<S>| presses(t).is_some();
        let count = self.detect(now, twists, mobilities, touching, rounding.drift, wanted)?;
        // Displacements instead of velocities: W d = -gap.
        spare.fill(Twist::zero());
        for _ in 0..SWEEPS {
            let mut moved = S::ZERO;
            for t in touching.iter_mut().take(count) {
                let contact = &t.held.contact;
                let off = t.gap + contact.relative(spare)[0];
                let push = -(off / t.held.inverse_mass[0][0]);
                contact.push(&**mobilities, spare, [push, S::ZERO, S::ZERO]);
                moved = moved.max(off.abs());
            }
            if moved <= S::EPSILON * rounding.drift {
                break;
            }
        }
        for ((part, state), shift) in self.parts.iter().zip(now.iter_mut()).zip(spare.iter()) {
            if part.body.is_some() {
                state.position = vec3::add(state.position, shift.velocity);
                let turn = state.attitude.to_body(vec3::scale(shift.angular, S::from_f64(0.5)));
                state.attitude = state.attitude.turned(turn);
            }
        }
        let count = self.detect(now, twists, mobilities, touching, rounding.drift, wanted)?;
        for _ in 0..SWEEPS {
            let mut moved = S::ZERO;
            for t in touching.iter_mut().take(count) {
                let sticks = presses(t).is_some_and(|a| a.held.slip.is_none() && inside_cone(&a.held));
                let k = t.held.inverse_mass;
                let mut change: Vec3<S> = vec3::zero();
                let contact = &mut t.held.contact;
                change[0] = -(contact.relative(twists)[0] / k[0][0]);
                contact.push(&**mobilities, twists, change);
                if sticks {
                    let [_, x, y] = contact.relative(twists);
                    let [x, y] = solve_tangential(&k, [x, y]);
                    contact.push(&**mobilities, twists, [S::ZERO, -x, -y]);
                    (change[1], change[2]) = (-x, -y);
                }
                contact.impulse = vec3::add(contact.impulse, change);
                moved = moved.max(vec3::norm(change) * k[0][0]);
            }
            if moved <= S::EPSILON * rounding.rate {
                break;
            }
        }
        for t in touching.iter().take(count) {
            self.push(now, &t.held.contact, t.held.contact.impulse);
        }
        Ok(())
    }
}

/// Whether friction is strictly inside its cone; on the rim the contact slips.
fn inside_cone<S: Scalar>(held: &Held<S>) -> bool {
    let [n, x, y] = held.contact.impulse;
    let rim = held.contact.friction * n;
    x * x + y * y < rim * rim * (S::ONE - S::from_f64(16.0) * S::EPSILON)
}
