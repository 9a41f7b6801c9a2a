//! A mechanism as a carrier: interpreted equations with ports, the laws of its inputs, its energy accounts.
//!
//! In: what is derived of its model with the ports that a scene uses. The wrench of a port is six inputs after the
//! model's own. Prescribed motion (coordinates in closed form) is independent of forces; the power of its drive is
//! booked.

use super::derived::Derived;
use super::picture::{INERTIA, Picture};
use crate::chatter::Chatter;
use crate::observers::LEDGER;
use crate::switches::{Switches, between};
use smartbed_codegen::Interpreted;
use smartbed_runtime::mechanism::{Fault, Mechanism as _};
use smartbed_runtime::real::Scalar;
use smartbed_runtime::surface::Frame;
use smartbed_runtime::vec3;
use smartbed_runtime::world::{InverseInertia, Wrench};
use std::ops::Range;
use std::sync::Arc;

/// Equations with ports.
#[derive(Clone, Debug)]
pub struct Ported<S = f64> {
    derived: Arc<Derived>,
    engine: Interpreted<S>,
    law: Interpreted<S>,
    observer: Interpreted<S>,
    places: Interpreted<S>,
    /// The model's own inputs, then six for each port.
    inputs: Vec<S>,
    own: usize,
    u_dot: Vec<S>,
    place: [S; 3],
    projections: u8,
    reads_time: bool,
    is_driven: bool,
    /// Time, coordinates and speeds at which rates or inverse inertias were asked for last, if only some of its motion
    /// is prescribed.
    last: (S, Vec<S>, Vec<S>),
    /// Number of points without the origin, of bodies with frames, and of bodies.
    counts: [usize; 3],
    /// Names and units of q and u.
    pub names: Vec<(String, String)>,
    closed_forms: Interpreted<S>,
    /// Times at which commands, laws and loads switch.
    pub(super) switches: Switches<S>,
    /// Signs of speeds in laws and loads, watched from step to step.
    pub(super) chatter: Chatter,
    /// Name of the model, which is that of the part where that commands coordinates.
    pub(super) name: String,
    /// Times between which no command has a kink.
    pub(super) smooth: [S; 2],
    /// Smallest pivot of all rates so far, relative to nominal.
    pub(super) pivot: S,
}

/// Energies (J) and powers (W) of a state.
#[derive(Clone, Copy, PartialEq, Default, Debug)]
pub struct Account<S = f64> {
    /// Kinetic, of weight, of springs (J).
    pub stored: [S; 3],
    /// Into it: actuators, other loads, drives (W).
    pub driven: S,
    /// Out of it: damping (W).
    pub damped: S,
}

impl<S: Scalar> Ported<S> {
    /// Interprets derived equations, the origin of the mechanism at a place in N (m).
    #[must_use]
    pub fn new(derived: &Arc<Derived>, place: [f64; 3]) -> Self {
        let Derived { model, program, observers, .. } = &**derived;
        let quantities = program.q.iter().chain(&program.u);
        Self {
            engine: Interpreted::new(program),
            law: Interpreted::new(&observers.laws()),
            observer: Interpreted::new(&observers.ledger()),
            places: Interpreted::new(&observers.places()),
            inputs: vec![S::ZERO; program.inputs.len()],
            own: model.inputs.len(),
            u_dot: vec![S::ZERO; program.u_dot.len()],
            place: place.map(S::from_f64),
            projections: u8::from(!program.correction.is_empty()),
            reads_time: model.is_driven() || model.reads_time(),
            is_driven: model.is_driven(),
            last: (S::ZERO, Vec::new(), Vec::new()),
            counts: [
                model.points.len() - 1,
                model.bodies.iter().filter(|body| body.frame.is_some()).count(),
                model.bodies.len(),
            ],
            names: quantities.map(|x| (x.name.clone(), x.unit.clone())).collect(),
            closed_forms: Interpreted::new(&observers.closed_forms()),
            switches: Switches::new(observers),
            chatter: Chatter::new(observers),
            name: model.name.clone(),
            smooth: [f64::NEG_INFINITY, f64::INFINITY].map(S::from_f64),
            pivot: S::ONE,
            derived: Arc::clone(derived),
        }
    }

    /// The ports in use.
    #[must_use]
    pub fn ports(&self) -> &[String] {
        &self.derived.ports
    }

    /// Names and units of the coordinates in closed form, commanded ones among them.
    #[must_use]
    pub fn closed(&self) -> &[(String, String)] {
        &self.derived.observers.closed
    }

    /// The same in another scalar.
    #[must_use]
    pub fn rounded<T: Scalar>(&self) -> Ported<T> {
        Ported::new(&self.derived, self.place.map(S::to_f64))
    }

    /// Inputs of the model without a law, by index and name. They keep the value at which they are held, 0 at the
    /// start.
    #[must_use]
    pub fn free_inputs(&self) -> Vec<(usize, String)> {
        let Derived { model, observers, .. } = &*self.derived;
        let own = model.inputs.iter().map(|input| input.name.clone()).enumerate();
        own.filter(|(input, _)| !observers.law_inputs.contains(input)).collect()
    }

    /// Holds one of them at a value; true if that changes it.
    pub fn hold(&mut self, input: usize, value: S) -> bool {
        let own = self.inputs[..self.own].get_mut(input);
        own.is_some_and(|own| std::mem::replace(own, value) != value)
    }

    /// Holds the inputs that another one of the same equations does.
    pub(super) fn hold_as(&mut self, other: &Ported<S>) {
        self.inputs[..self.own].copy_from_slice(&other.inputs[..self.own]);
    }

    /// Does its motion, or do its forces, depend on time explicitly?
    pub(super) fn reads_time(&self) -> bool {
        self.reads_time
    }

    /// Has it the same equations and commands?
    pub(super) fn is_copy_of(&self, other: &Self) -> bool {
        Arc::ptr_eq(&self.derived, &other.derived)
    }

    /// The time (s) near which a step of a run over so many seconds with a step (s) hides what happens in between.
    pub(super) fn passed(&self, run: [f64; 2]) -> Option<f64> {
        between::passed(&self.derived.observers, run).ok().flatten()
    }

    /// Is some of its motion prescribed, but not all?
    pub(super) fn is_driven_in_part(&self) -> bool {
        self.is_driven && self.n_u() > 0
    }

    /// Sets the inputs: laws at this state, wrenches at the ports.
    fn command(&mut self, t: S, q: &[S], u: &[S], wrenches: &[Wrench<S>]) -> Result<(), Fault> {
        let commanded = self.law.outputs(t, q, u, &vec![S::ZERO; self.own])?;
        for (&input, value) in self.derived.observers.law_inputs.iter().zip(commanded) {
            self.inputs[input] = value;
        }
        for (&first, wrench) in self.derived.wrenches.iter().zip(wrenches) {
            self.inputs[first..first + 3].copy_from_slice(&wrench.force);
            self.inputs[first + 3..first + 6].copy_from_slice(&wrench.moment);
        }
        Ok(())
    }

    /// Observes the state after a step, for [`Chatter::warning`].
    pub(super) fn watch(&mut self, t: S, q: &[S], u: &[S]) -> Result<(), Fault> {
        self.chatter.observe(t.to_f64(), &[q, u].concat(), &self.inputs[..self.own])
    }

    /// Keeps the state at which wrenches act, for [`Ported::drive_against`].
    fn remember(&mut self, t: S, q: &[S], u: &[S]) {
        if self.is_driven_in_part() {
            let (time, own_q, own_u) = &mut self.last;
            *time = t;
            for (to, from) in [(own_q, q), (own_u, u)] {
                to.clear();
                to.extend_from_slice(from);
            }
        }
    }

    /// Power (W) that its drives give because of these wrenches at the ports, or work of impulses (J), at the state at
    /// which rates or inverse inertias were asked for last; `None` if nothing is commanded.
    ///
    /// What a drive gives is affine in the wrenches: the force at a port acts on the commanded motion directly, and
    /// through the accelerations of the rest that it causes.
    pub(super) fn drive_against(&mut self, frames: &[Frame<S>], wrenches: &[Wrench<S>]) -> Option<S> {
        if self.n_u() == 0 {
            let taken = frames.iter().zip(wrenches).map(|(frame, wrench)| wrench.power(frame));
            return Some(-taken.fold(S::ZERO, |sum, power| sum + power));
        }
        if !self.is_driven_in_part() {
            return None;
        }
        let (t, q, u) = std::mem::replace(&mut self.last, (S::ZERO, Vec::new(), Vec::new()));
        let mut drive = |wrenches: &[Wrench<S>]| {
            self.command(t, &q, &u, wrenches)?;
            self.engine.drive(t, &q, &u, &self.inputs)
        };
        let loaded = drive(wrenches);
        let free = drive(&vec![Wrench::zero(); wrenches.len()]);
        self.last = (t, q, u);
        Some(loaded.ok()? - free.ok()?)
    }

    /// All answers of all ports.
    fn asked(&mut self, t: S, q: &[S], u: &[S]) -> Result<Vec<S>, Fault> {
        let t = self.switches.moment(t)?;
        self.engine.function(0, (t, q, u, &self.inputs, &self.u_dot))
    }

    /// All answers of all ports, continued beyond the times at which commands have kinks by parabolas: differences of
    /// frames in time look a little ahead and back.
    fn continued(&mut self, t: S, q: &[S], u: &[S]) -> Result<Vec<S>, Fault> {
        let [first, last] = self.smooth;
        let edge = if t < first { first } else { last };
        if first <= t && t <= last {
            return self.asked(t, q, u);
        }
        let beyond = t - edge;
        let [one, two, three] = [edge, edge - beyond, edge - beyond - beyond].map(|t| self.asked(t, q, u));
        let (one, two, three) = (one?, two?, three?);
        let inside = one.iter().zip(&two).zip(&three);
        Ok(inside.map(|((a, b), c)| S::from_f64(3.0) * (*a - *b) + *c).collect())
    }

    /// Number of coordinates.
    #[must_use]
    pub fn n_q(&self) -> usize {
        self.engine.n_q()
    }

    /// Number of independent speeds.
    #[must_use]
    pub fn n_u(&self) -> usize {
        self.engine.n_u()
    }

    /// Number of ports in use.
    #[must_use]
    pub fn n_ports(&self) -> usize {
        self.derived.first.len()
    }

    /// Frames of the ports.
    ///
    /// # Errors
    /// The engine's.
    pub fn frames(&mut self, t: S, q: &[S], u: &[S], frames: &mut [Frame<S>]) -> Result<(), Fault> {
        if self.derived.first.is_empty() {
            return Ok(());
        }
        let answers = self.continued(t, q, u)?;
        let three = |first: usize| [answers[first], answers[first + 1], answers[first + 2]];
        for ([position, rotation, twist, ..], frame) in self.derived.first.iter().zip(frames) {
            let rows = [0, 3, 6].map(|row| three(rotation + row));
            *frame = Frame {
                origin: vec3::add(three(*position), self.place),
                axes: [0, 1, 2].map(|axis| rows.map(|row| row[axis])),
                velocity: three(*twist),
                angular_velocity: three(twist + 3),
            };
        }
        Ok(())
    }

    /// Rates under wrenches at the ports; returns the worst pivot.
    ///
    /// # Errors
    /// The engine's.
    pub fn rates(
        &mut self,
        t: S,
        (q, u): (&[S], &[S]),
        wrenches: &[Wrench<S>],
        (q_dot, u_dot): (&mut [S], &mut [S]),
    ) -> Result<S, Fault> {
        let t = self.switches.moment(t)?;
        self.remember(t, q, u);
        self.command(t, q, u, wrenches)?;
        let pivot = self.engine.rates(t, q, u, &self.inputs, q_dot, u_dot)?;
        self.pivot = self.pivot.min(pivot.abs());
        Ok(pivot)
    }

    /// J M^-1 J': for one port as derived; for two ports, the twist at one of them due to a unit impulse at the other.
    ///
    /// # Errors
    /// The engine's.
    pub fn inverse_inertia(
        &mut self,
        t: S,
        q: &[S],
        u: &[S],
        [seen, at]: [usize; 2],
    ) -> Result<InverseInertia<S>, Fault> {
        self.remember(t, q, u);
        let answers = self.asked(t, q, u)?;
        let [.., inverse, jacobian] = *self.derived.first.get(seen).ok_or(Fault::Shape)?;
        if seen == at {
            return Ok(std::array::from_fn(|i| std::array::from_fn(|j| answers[inverse + 6 * i + j])));
        }
        let (n, mut columns) = (self.n_u(), [[S::ZERO; 6]; 6]);
        let mut accelerations = |wrench: Option<usize>| -> Result<Vec<S>, Fault> {
            let mut wrenches = vec![Wrench::zero(); self.n_ports()];
            if let Some(direction) = wrench {
                let side = if direction < 3 { &mut wrenches[at].force } else { &mut wrenches[at].moment };
                side[direction % 3] = S::ONE;
            }
            let (mut q_dot, mut u_dot) = (vec![S::ZERO; self.n_q()], vec![S::ZERO; n]);
            self.rates(t, (q, u), &wrenches, (&mut q_dot, &mut u_dot))?;
            Ok(u_dot)
        };
        let free = accelerations(None)?;
        for (direction, column) in columns.iter_mut().enumerate() {
            let pushed = accelerations(Some(direction))?;
            for (row, entry) in column.iter_mut().enumerate() {
                let terms = (0..n).map(|k| answers[jacobian + n * row + k] * (pushed[k] - free[k]));
                *entry = terms.fold(S::ZERO, |sum, term| sum + term);
            }
        }
        Ok(std::array::from_fn(|i| std::array::from_fn(|j| columns[j][i])))
    }

    /// The ports that an impulse at one of them moves: all ports, because they belong to one mechanism.
    #[must_use]
    pub fn coupled(&self) -> Range<usize> {
        if self.n_u() == 0 { 0..0 } else { 0..self.n_ports() }
    }

    /// Kinetic and potential energy (J).
    ///
    /// # Errors
    /// The engine's.
    pub fn energy(&mut self, t: S, q: &[S], u: &[S]) -> Result<(S, S), Fault> {
        let t = self.switches.moment(t)?;
        self.engine.set_time(t);
        self.engine.energy(q, u)
    }

    /// All speeds, dependent ones included.
    ///
    /// # Errors
    /// The engine's.
    pub fn speeds(&mut self, t: S, q: &[S], u: &[S]) -> Result<Vec<S>, Fault> {
        let t = self.switches.moment(t)?;
        self.engine.set_time(t);
        self.engine.speeds(q, u)
    }

    /// Values and rates of the coordinates in closed form.
    ///
    /// # Errors
    /// The engine's.
    pub fn closed_forms(&mut self, t: S, q: &[S], u: &[S]) -> Result<Vec<[S; 2]>, Fault> {
        if self.closed().is_empty() {
            return Ok(Vec::new());
        }
        let t = self.switches.moment(t)?;
        let values = self.closed_forms.outputs(t, q, u, &self.inputs[..self.own])?;
        Ok(values.chunks_exact(2).map(|both| [both[0], both[1]]).collect())
    }

    /// Energies and powers at a state under wrenches.
    ///
    /// # Errors
    /// The engine's.
    pub fn account(&mut self, t: S, q: &[S], u: &[S], wrenches: &[Wrench<S>]) -> Result<Account<S>, Fault> {
        let ([gravity, spring], [driven, damped]) = self.watched(t, q, u, wrenches)?;
        let (kinetic, _) = self.energy(t, q, u)?;
        Ok(Account { stored: [kinetic, gravity, spring], driven, damped })
    }

    /// The powers of its account alone: what its drives and actuators give, what its dampers take (W).
    ///
    /// # Errors
    /// The engine's.
    pub fn powers(&mut self, t: S, q: &[S], u: &[S], wrenches: &[Wrench<S>]) -> Result<[S; 2], Fault> {
        self.watched(t, q, u, wrenches).map(|(_, powers)| powers)
    }

    /// Energies of weight and springs, and powers.
    fn watched(&mut self, t: S, q: &[S], u: &[S], wrenches: &[Wrench<S>]) -> Result<([S; 2], [S; 2]), Fault> {
        let t = self.switches.moment(t)?;
        self.command(t, q, u, wrenches)?;
        let watched = self.observer.outputs(t, q, u, &self.inputs[..self.own])?;
        let [gravity, spring, actuator, damping, external]: [S; LEDGER.len()] =
            watched.try_into().map_err(|_| Fault::Shape)?;
        let drive = self.engine.drive(t, q, u, &self.inputs)?;
        Ok(([gravity, spring], [actuator + external + drive, damping]))
    }

    /// Its origin and points, axes of bodies, inertias and lengths of shapes, in N.
    ///
    /// # Errors
    /// The engine's.
    pub fn picture(&mut self, t: S, q: &[S], u: &[S]) -> Result<Picture, Fault> {
        let t = self.switches.moment(t)?;
        let numbers = self.places.outputs(t, q, u, &self.inputs[..self.own])?;
        let (numbers, place): (Vec<f64>, _) =
            (numbers.into_iter().map(S::to_f64).collect(), self.place.map(S::to_f64));
        let [points, frames, bodies] = self.counts;
        let cut = |first: usize, count: usize| numbers.get(first..first + count).ok_or(Fault::Shape);
        let (axes, inertias) = (3 * points, 3 * points + 6 * frames);
        let gravity = inertias + INERTIA * bodies;
        let three = |x: &[f64]| [x[0], x[1], x[2]];
        let own = cut(0, axes)?.chunks_exact(3).map(|point| vec3::add(three(point), place));
        let turned = cut(axes, 6 * frames)?.chunks_exact(6).map(|two| [three(two), three(&two[3..])]);
        let solid = |x: &[f64]| std::array::from_fn(|i| x[i]);
        Ok(Picture {
            points: std::iter::once(place).chain(own).collect(),
            axes: turned.collect(),
            inertias: cut(inertias, INERTIA * bodies)?.chunks_exact(INERTIA).map(solid).collect(),
            sizes: numbers.get(gravity + 3..).unwrap_or_default().to_vec(),
            forces: Vec::new(),
        })
    }

    /// One Newton correction towards the constraints; returns the residual before it.
    ///
    /// # Errors
    /// The engine's.
    pub fn project(&mut self, q: &mut [S]) -> Result<S, Fault> {
        self.engine.project(q)
    }

    /// The time of the next correction.
    pub fn set_time(&mut self, t: S) {
        let t = self.switches.moment(t).unwrap_or(t);
        self.engine.set_time(t);
    }

    /// Number of corrections after a step.
    #[must_use]
    pub fn projections(&self) -> u8 {
        self.projections
    }
}
