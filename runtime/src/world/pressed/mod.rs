//! Equations of motion of an island under lasting contacts, whose forces keep the parts from entering one another.
//!
//! In: an island, lasting contacts and the state of each (sticking, sliding), a state. Out: rates, forces of the
//! contacts; states projected back onto the contacts.
//! ```text
//! G lambda = -(d/dt W v)      N at every contact, T where friction holds;  T = -mu N w_t/|w_t| where it slides
//! d/dt W v                    along the motion without these forces: a central difference over a short way
//! ```
//! The difference includes every cause of a change of the gap rate: curved and moving surfaces, facets that bend,
//! commanded frames. Its error is 1e-9 of the accelerations, none at rest; a projection corrects gaps and gap rates
//! after every step.

mod corrections;
mod works;

use super::carrier::Carrier;
use super::contacts::load;
use super::detect::{Meeting, Touch};
use super::scenery::Scenery;
use super::thing::Pair;
use super::whole::{StepMemory, World};
use crate::mechanism::Fault;
use crate::ode::Ode;
use crate::real::Scalar;
use crate::rigid::contact::{Contact, Twist};
use crate::rigid::hold::{CORNERS, Held, Slip, Sought, Unheld, hold, negligible};
use crate::rigid::scene::TURN;
use crate::vec3::{self, Vec3};

/// Half the interval of central differences relative to the step: balances errors of rounding and of curvature.
const SPAN: f64 = 1e-4;

/// Force missing to stick, above which slip starts, relative to the contact's own force; below it is rounding and the
/// error of the difference.
const MISSING: f64 = 1e-6;
/// The same relative to the largest force of all contacts.
const MISSING_OF_ALL: f64 = 1e-8;

/// A lasting contact.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pressing<S> {
    /// Number of its pair.
    pub pair: usize,
    /// Number of the contact within its pair.
    pub id: u32,
    /// Gap (m).
    pub gap: S,
    /// The gap to keep (m): 0, or the overlap that a shortened step has left. Pushing it out would add energy: the
    /// overlap times the contact force.
    pub kept: S,
    /// How much the gap (m) may change while it slides on a smooth surface with the normals of the facet below it.
    pub sagitta: S,
    /// How far (m) it may be off the facet for having been so at the start of the piece of a step.
    pub(super) off: S,
    /// Contact point in N (m).
    pub place: Vec3<S>,
    /// Sides, axes, force (N), inverse mass.
    pub held: Held<S>,
    /// Direction of slip in N; None where the contact sticks. Zero without friction.
    pub slip: Option<Vec3<S>>,
    /// Normal at the start of the piece of a step.
    pub(super) normal: Vec3<S>,
    /// Whether the contact has passed to another face or an edge since, or has none. It is held on the one before.
    pub(super) lost: bool,
    /// Relative velocity in N (m/s).
    pub(super) velocity: Vec3<S>,
    /// Speed of slip at the start of the piece of a step (m/s).
    pub(super) speed: S,
    /// Gap rate and relative velocity in N a short way ahead and a short way behind, where it is not lost.
    pub(super) seen: [Option<(S, Vec3<S>)>; 2],
    /// Impulse or displacement of the projection, along n, t1, t2.
    pub(super) correction: Vec3<S>,
}

impl<S> AsMut<Held<S>> for Pressing<S> {
    fn as_mut(&mut self) -> &mut Held<S> {
        &mut self.held
    }
}

impl<S: Scalar> Pressing<S> {
    /// An empty entry of a list.
    #[must_use]
    pub fn empty() -> Pressing<S> {
        let (zero, touch) = (vec3::zero(), Touch::empty());
        let held = Held::new(touch.contact, [zero; 3], zero);
        let (slip, seen) = (None, [None; 2]);
        Pressing {
            pair: 0,
            id: 0,
            gap: S::ZERO,
            kept: S::ZERO,
            sagitta: S::ZERO,
            off: S::ZERO,
            place: zero,
            held,
            slip,
            normal: zero,
            lost: false,
            velocity: zero,
            speed: S::ZERO,
            seen,
            correction: zero,
        }
    }

    /// Finds the contact at what was placed last. One that is lost keeps its axes and the points that it had.
    fn follow(&mut self, scenery: &Scenery<'_, S>, pair: &Pair<S>) {
        let old = self.held.contact;
        let meeting = scenery.again(pair, self.id).filter(|m| !m.sharp && !self.turned(&m.contact));
        self.lost = meeting.is_none();
        if let Some(Meeting { gap, point, mut contact, sagitta, .. }) = meeting {
            // The axes turn with the normal: the old tangential impulse is resolved along the new tangents.
            let [_, x, y] = vec3::apply(&contact.axes, old.to_inertial(old.impulse));
            contact.impulse = [old.impulse[0], x, y];
            (self.gap, self.place, self.held.contact, self.sagitta) = (gap, point, contact, sagitta);
        } else if let Some(place) = scenery.place_of(pair, self.id, &old) {
            let arm = |port: usize| scenery.frames.get(port).map(|frame| vec3::sub(place, frame.origin));
            self.held.contact.sides =
                old.sides.map(|side| side.with_arms(|at| arm(at.body).unwrap_or(at.arm)));
            self.place = place;
        }
    }

    /// Whether the contact is another one now: its normal has turned from one face to another.
    pub(super) fn turned(&self, now: &Contact<S>) -> bool {
        vec3::dot(now.axes[0], self.normal) < S::from_f64(TURN)
    }

    /// Sets the bias: by a central difference, or to one side where the other lies behind the end of the contact; where
    /// both do, it stays.
    fn set_bias(&mut self, now: Option<(S, Vec3<S>)>, span: S) {
        let ([ahead, behind], twice) = (self.seen, span + span);
        let ends = match (ahead, behind, now) {
            (Some(ahead), Some(behind), _) => Some((ahead, behind, twice)),
            (Some(ahead), None, Some(now)) => Some((ahead, now, span)),
            (None, Some(behind), Some(now)) => Some((now, behind, span)),
            _ => None,
        };
        if let Some(((rate, velocity), (old_rate, old_velocity), time)) = ends {
            let one = S::ONE / time;
            let change = vec3::scale(vec3::sub(velocity, old_velocity), one);
            let [_, x, y] = vec3::apply(&self.held.contact.axes, change);
            self.held.bias = [one * (rate - old_rate), x, y];
        }
    }

    /// The gap (m) to which a projection moves the contact: the present one, as long as it is within the sagitta, now or
    /// before the facet flattened. Forces act along the normals of a smooth surface, and to move the contact back to the
    /// facet would do work against them.
    fn aim(&self) -> S {
        let off = self.sagitta.max(self.off);
        self.gap.max(self.kept - off).min(self.kept + off)
    }

    /// Force that a sticking contact is missing, 1 where slip starts. `gained`: accelerations by the forces of all
    /// contacts, the largest of which is given.
    pub(super) fn starts(&self, gained: &[Twist<S>], largest: S) -> S {
        let (own, all) = (S::from_f64(MISSING), S::from_f64(MISSING_OF_ALL));
        self.held.missing(gained) / (own * vec3::norm(self.held.contact.impulse) + all * largest)
    }

    /// Slip for the forces of a step of h.
    fn slides(&self, rate: S, h: S, ports: usize) -> Option<Slip<S>> {
        let contact = &self.held.contact;
        let rigid = contact.points().any(|(_, point)| point.body < ports);
        let together = if rigid { S::from_f64(CORNERS) } else { S::ONE };
        Some(Slip::now(contact, [self.velocity, self.slip?], rate, (h, together)))
    }
}

impl From<Unheld> for Fault {
    fn from(unheld: Unheld) -> Fault {
        match unheld {
            Unheld::Jammed => Fault::Jammed,
            Unheld::Unbalanced => Fault::Unbalanced,
        }
    }
}

/// An island under lasting contacts.
pub(super) struct Pressed<'w, 'a, 'm, S, C> {
    pub(super) world: &'w mut World<'a, S, C>,
    pub(super) memory: &'w mut StepMemory<'m, S>,
    pub(super) list: &'w mut [Pressing<S>],
    /// Three memories of one state each.
    pub(super) spare: [&'w mut [S]; 3],
    /// Step size (s): of the whole step, whose pieces follow the same equations.
    pub(super) h: S,
    /// How far a contact may be from where it was detected (m), and the speed that counts as zero (m/s).
    pub(super) rounding: [S; 2],
    /// Time of the next projection.
    pub(super) t: S,
}

impl<S: Scalar, C: Carrier<S>> Pressed<'_, '_, '_, S, C> {
    /// Copies the velocities of ports and nodes as they were placed last.
    pub(super) fn read_twists(world: &World<'_, S, C>, twists: &mut [Twist<S>]) {
        let own = &world.island.memory;
        let ports = own.frames.iter().map(|f| Twist { velocity: f.velocity, angular: f.angular_velocity });
        let nodes = own.vel.iter().map(|v| Twist { velocity: *v, angular: vec3::zero() });
        twists.iter_mut().zip(ports.chain(nodes)).for_each(|(to, from)| *to = from);
    }

    /// Places everything at a state and passes each contact to `see`, with its gap rate and its relative velocity in N.
    fn look(
        &mut self,
        t: S,
        x: &[S],
        mut see: impl FnMut(&mut Pressing<S>, S, Vec3<S>),
    ) -> Result<(), Fault> {
        self.world.island.place(t, x)?;
        let StepMemory { twists: [_, twists, _], normals, .. } = &mut *self.memory;
        let pairs = || self.list.iter().filter_map(|own| self.world.pairs.get(own.pair));
        self.world.turn_normals(normals, |thing| pairs().any(|pair| pair.things.contains(&thing)));
        Self::read_twists(self.world, twists);
        let scenery = self.world.scenery(normals, self.rounding[0], true);
        for own in self.list.iter_mut() {
            let pair = self.world.pairs.get(own.pair).ok_or(Fault::Shape)?;
            own.follow(&scenery, pair);
            let [n, x, y] = own.held.contact.relative(twists);
            let velocity = own.held.contact.to_inertial([n, x, y]);
            see(own, n, velocity);
        }
        Ok(())
    }

    /// Sets the biases d/dt W v, along the rates `dot`, and contacts and inverse masses at (t, x).
    fn set_biases(&mut self, t: S, x: &[S], dot: &[S]) -> Result<(), Fault> {
        let span = S::from_f64(SPAN) * self.h;
        for (k, way) in [span, -span].into_iter().enumerate() {
            let shifted = core::mem::take(&mut self.spare[0]);
            for ((to, from), rate) in shifted.iter_mut().zip(x).zip(dot) {
                *to = *from + way * *rate;
            }
            let looked = self.look(t + way, shifted, |own, rate, velocity| {
                if let Some(seen) = own.seen.get_mut(k) {
                    *seen = (!own.lost).then_some((rate, velocity));
                }
            });
            self.spare[0] = shifted;
            looked?;
        }
        let (rounding, h, ports) = (self.rounding[1], self.h, self.world.island.memory.frames.len());
        self.look(t, x, |own, rate, velocity| {
            own.velocity = velocity;
            own.set_bias((!own.lost).then_some((rate, velocity)), span);
            own.held.slip = own.slides(rounding, h, ports);
        })?;
        self.ask(t, x)
    }

    /// Computes the inverse mass of every contact.
    fn ask(&mut self, t: S, x: &[S]) -> Result<(), Fault> {
        let list = &*self.list;
        let touched = |port: usize| list.iter().any(|own| own.held.contact.touches_body(port));
        let inertias = &mut self.memory.inertias;
        self.world.island.ask_yields(t, x, inertias, touched)?;
        for own in self.list.iter_mut() {
            own.held.inverse_mass = own.held.contact.inverse_mass(inertias);
        }
        Ok(())
    }

    /// Rates without contact forces, and the biases that those have to balance; returns the worst pivot.
    pub(super) fn prepare(&mut self, t: S, x: &[S], dot: &mut [S]) -> Result<S, Fault> {
        self.world.island.place(t, x)?;
        self.world.load_seams()?;
        let pivot = self.world.island.accelerate(t, x, dot)?;
        if !self.list.is_empty() {
            self.set_biases(t, x, dot)?;
        }
        Ok(pivot)
    }

    /// Forces that keep every contact closed. They pull only where pushing cannot do it, because the caller locates the
    /// time of release; those of redundant contacts could pull and push against one another without an effect. Where
    /// these contradict one another no forces keep all of them closed, and one opens.
    fn balance(&mut self) -> Result<(), Fault> {
        self.find_forces(false)?;
        let gained = &*self.memory.twists[0];
        let largest = self.list.iter().fold(S::ZERO, |most, own| most.max(own.held.contact.impulse[0]));
        let opens = |own: &Pressing<S>| own.held.opens(gained) > S::from_f64(MISSING_OF_ALL) * largest;
        if self.list.iter().any(opens) && self.find_forces(true) == Err(Unheld::Unbalanced) {
            self.find_forces(false)?;
        }
        Ok(())
    }

    /// Finds the forces of all contacts, which may pull or not, and the accelerations by them.
    fn find_forces(&mut self, pulls: bool) -> Result<(), Unheld> {
        let StepMemory { twists: [gained, ..], inertias, .. } = &mut *self.memory;
        gained.fill(Twist::zero());
        let sought = Sought { pulls, rough: true, least: negligible(self.rounding[1], self.h) };
        hold(self.list, sought, &*inertias, gained)
    }

    /// Adds the contact forces to those on the nodes and to the wrenches on the ports.
    fn load(&mut self) {
        let own = &mut self.world.island.memory;
        for contact in self.list.iter().map(|own| &own.held.contact) {
            load(contact, |force| force, (own.elastic, own.wrenches));
        }
    }
}

impl<S: Scalar, C: Carrier<S>> Ode<S> for Pressed<'_, '_, '_, S, C> {
    fn n_x(&self) -> usize {
        self.world.island.n_x()
    }

    fn n_q(&self) -> usize {
        self.world.island.n_q()
    }

    fn rates(&mut self, t: S, x: &[S], x_dot: &mut [S]) -> Result<S, Fault> {
        let pivot = self.prepare(t, x, x_dot)?;
        if self.list.is_empty() {
            return Ok(pivot);
        }
        self.balance()?;
        self.load();
        self.world.island.accelerate(t, x, x_dot)
    }

    fn project(&mut self, x: &mut [S]) -> Result<S, Fault> {
        let mut residual = S::ZERO;
        if self.world.island.projections() > 0 {
            residual = self.world.island.project(x)?;
        }
        if self.list.is_empty() {
            return Ok(residual);
        }
        let t = self.t;
        self.look(t, x, |_, _, _| {})?;
        self.ask(t, x)?;
        self.correct(false, |own| [own.aim() - own.gap, S::ZERO, S::ZERO]);
        self.move_by_corrections(t, x, true)?;
        self.look(t, x, |own, _, velocity| own.velocity = velocity)?;
        self.ask(t, x)?;
        self.correct(true, |own| vec3::scale(vec3::apply(&own.held.contact.axes, own.velocity), -S::ONE));
        self.move_by_corrections(t, x, false)?;
        Ok(residual)
    }

    fn set_time(&mut self, t: S) {
        self.t = t;
        self.world.island.set_time(t);
    }

    fn projections(&self) -> u8 {
        self.world.island.projections().max(u8::from(!self.list.is_empty()))
    }
}
