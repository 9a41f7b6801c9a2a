//! One step of a body on the ground: try, shorten to the first touch or release, apply it, go on.
//!
//! In: a system, a state, a step h, a method. Out: the state h later (less what too many events left
//! over, which the next step makes up) and a report. The observer sees everything and changes nothing.
//! Invariant: on an error the state is the last good one. Work per step is bounded.

use crate::advance::{Method, Motion, Start, Workspace, advance, copy, moreau, shift_positions};
use crate::body::energy::eval_energies;
use crate::body::vec3::{self, Vec3};
use crate::body::{BodyError, pressure};
use crate::contact::compensation::{self, Compensation, Impact, PointImpact, Root};
use crate::contact::{ContactLaw, Ground, Mode, System, friction, restitution, soft};
use crate::guard::{self, Shortened};
use crate::real::Scalar;

/// Events handled in one step; the rest of the step is carried over to the next.
pub const MAX_EVENTS: usize = 64;
/// Substeps of an adaptive method within one step.
pub const MAX_SUBSTEPS: usize = 4096;
/// Passes of an anchored impact: the swing is some thousandths of the energy, each pass gains that factor.
const ANCHOR_PASSES: usize = 3;
/// A rebound whose flight would last less than this part of a step, or stay within the tolerance, ends at rest (Zeno).
const ZENO_FLIGHT: f64 = 1e-2;

/// What advances.
#[derive(Debug)]
pub struct State<'a, S> {
    /// Positions, velocities, forces.
    pub motion: Motion<'a, S>,
    /// Each point against the ground.
    pub modes: &'a mut [Mode],
    /// Time [s] and what rounding dropped from it.
    pub time: [S; 2],
    /// Part of earlier steps still to be made up [s].
    pub carry: S,
    /// Length with which an adaptive method goes on [s]; 0 before the first step.
    pub next_step: S,
    /// Energy that an undamped body should have [J]; kept only for the ledger anchor.
    pub anchor: S,
}

/// A touch or a release.
#[derive(Clone, Copy, Debug)]
pub struct Event<'a, S> {
    /// Time [s].
    pub time: S,
    /// The impact, for a touch.
    pub impact: Option<Impact<S>>,
    /// Impulses by point (of the touching ones).
    pub points: &'a [PointImpact<S>],
    /// Modes after the event.
    pub modes: &'a [Mode],
    /// Number of points let go.
    pub released: usize,
}

/// A stretch of motion without events.
#[derive(Clone, Copy, Debug)]
pub struct Flow<'a, 'm, S> {
    /// State at its start.
    pub before: &'a Motion<'m, S>,
    /// State at its end.
    pub after: &'a Motion<'m, S>,
    /// Its length [s].
    pub tau: S,
    /// Energy lost to sliding friction in it [J].
    pub friction: S,
    /// Energy lost to the impact law in it [J] (time stepping laws).
    pub impact: S,
}

/// Sees a run. The unit type looks away.
pub trait Observer<S> {
    /// Motion without events.
    fn flow(&mut self, system: &System<S>, flow: Flow<S>);
    /// A touch or release.
    fn event(&mut self, system: &System<S>, event: Event<S>);
}

impl<S> Observer<S> for () {
    fn flow(&mut self, _: &System<S>, _: Flow<S>) {}
    fn event(&mut self, _: &System<S>, _: Event<S>) {}
}

/// Counts of one step.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default)]
pub struct StepReport {
    /// Touches and releases.
    pub events: usize,
    /// Stretches without events.
    pub substeps: usize,
    /// Steps tried to locate events, each with the method's force evaluations.
    pub trials: usize,
    /// The step ended early: [`MAX_EVENTS`] or [`MAX_SUBSTEPS`] was reached.
    pub cut_short: bool,
}

impl<S: Scalar> State<'_, S> {
    /// Time [s].
    #[must_use]
    pub fn t(&self) -> S {
        self.time[0]
    }

    /// What the total energy has above its mean over the body's vibrations, because of the method [J].
    ///
    /// Verlet keeps m v^2/2 + V + h^2 (alpha v.V''v - (1/8 - alpha) m |a|^2) of a linear body, for every alpha;
    /// alpha = 1/16 has the total energy as its mean. A touch takes a point's acceleration away and so would
    /// lift that mean, if it left the total energy of the instant as it is.
    fn energy_swing(&self, system: &System<S>, h: S, method: Method<S>, mode: impl Fn(usize) -> Mode) -> S {
        if method != Method::Verlet {
            return S::ZERO;
        }
        let mut sum = S::ZERO;
        for (i, mass) in system.body.mass.iter().enumerate() {
            let a = system.acceleration(i, mode(i), self.motion.force(i));
            sum = sum + *mass * vec3::dot(a, a);
        }
        for spring in system.body.springs {
            let rate = spring.stretch(self.motion.pos, self.motion.vel).rate;
            sum = sum - spring.stiffness * rate * rate;
        }
        S::from_f64(1.0 / 16.0) * h * h * sum
    }

    fn pass(&mut self, tau: S) {
        let change = tau + self.time[1];
        let sum = self.time[0] + change;
        let part = sum - self.time[0];
        self.time = [sum, (self.time[0] - (sum - part)) + (change - part)];
    }

    /// Makes the state ready: forces, energy, points that lie on the ground or touch it now.
    ///
    /// # Errors
    /// From the gas law.
    pub fn begin<O: Observer<S>>(
        &mut self,
        system: &System<S>,
        h: S,
        method: Method<S>,
        work: &mut Workspace<S>,
        observer: &mut O,
    ) -> Result<(), BodyError<S>> {
        self.motion.refresh(system)?;
        self.anchor = eval_energies(&system.body, self.motion.pos, self.motion.vel).total()
            - self.energy_swing(system, h, method, |i| self.modes.get(i).copied().unwrap_or_default());
        if let Some(ground) = &system.ground
            && ground.has_events()
        {
            // A point lying still on the ground takes part as one that touches with speed 0.
            for (i, mode) in self.modes.iter_mut().enumerate() {
                let on_ground = ground.gap(vec3::at(self.motion.pos, i)) <= ground.tolerance;
                let still = ground.gap_rate(vec3::at(self.motion.vel, i)) == S::ZERO;
                *mode = if on_ground && still { Mode::Held } else { Mode::Free };
            }
            resolve(system, ground, self, (h, method), work, observer)?;
        }
        Ok(())
    }
}

/// Advances by h (and by what earlier steps left over).
///
/// # Errors
/// The state is then the last good one.
pub fn step<S: Scalar, O: Observer<S>>(
    system: &System<S>,
    state: &mut State<S>,
    h: S,
    method: Method<S>,
    work: &mut Workspace<S>,
    observer: &mut O,
) -> Result<StepReport, BodyError<S>> {
    if let Some(ContactLaw::Moreau { restitution }) = system.ground.map(|g| g.law) {
        return step_moreau(system, state, h, restitution, work, observer);
    }
    let mut report = StepReport::default();
    let mut remaining = h + state.carry;
    state.carry = S::ZERO;
    while remaining > S::ZERO {
        if report.events >= MAX_EVENTS || report.substeps >= MAX_SUBSTEPS {
            report.cut_short = true;
            state.carry = remaining;
            break;
        }
        report.substeps += 1;
        let tau = try_length(state, remaining, h, method);
        let start = Start { motion: &state.motion, modes: state.modes };
        let error = advance(system, start, tau, method, work)?;
        control_step(state, tau, error, remaining, method);
        if error > S::ONE {
            continue;
        }
        let start = Start { motion: &state.motion, modes: state.modes };
        let Shortened { tau, is_event, trials } = match &system.ground {
            Some(ground) if ground.has_events() => {
                guard::shorten_to_event(system, ground, start, tau, method, work)?
            }
            _ => Shortened { tau, is_event: false, trials: 0 },
        };
        report.trials += trials;
        pressure::check_inflation(&system.body, work.end.pos)?;
        accept(system, state, tau, work, observer)?;
        remaining = remaining - tau;
        if let (true, Some(ground)) = (is_event, &system.ground) {
            report.events += 1;
            resolve(system, ground, state, (h, method), work, observer)?;
        }
    }
    Ok(report)
}

/// Length of the next try [s].
fn try_length<S: Scalar>(state: &State<S>, remaining: S, h: S, method: Method<S>) -> S {
    let wanted = if method.control_order() == 0 {
        // What earlier steps left over does not lengthen this one: it is made up in pieces.
        h
    } else if state.next_step > S::ZERO {
        state.next_step
    } else {
        h * S::from_f64(0.01)
    };
    // A rest of less than one part in 1e3 of the try is not left for a step of its own.
    if wanted * S::from_f64(1.001) >= remaining { remaining } else { wanted }
}

/// Standard controller: factor 0.9 error^(-1/order), kept within 1/5 and 5.
fn control_step<S: Scalar>(state: &mut State<S>, tau: S, error: S, remaining: S, method: Method<S>) {
    let order = method.control_order();
    if order == 0 {
        return;
    }
    let exponent = S::from_f64(-1.0 / f64::from(order));
    let tiny = S::from_f64(1e-10);
    let factor = S::from_f64(0.9) * (exponent * error.max(tiny).ln()).exp();
    let wanted = tau * factor.max(S::from_f64(0.2)).min(S::from_f64(5.0));
    // A try cut by the end of the step says nothing against the longer one planned before.
    let cut = tau >= remaining && error <= S::ONE;
    state.next_step = if cut { wanted.max(state.next_step) } else { wanted };
}

/// Takes over the state in `work.end`, after sliding friction.
fn accept<S: Scalar, O: Observer<S>>(
    system: &System<S>,
    state: &mut State<S>,
    tau: S,
    work: &mut Workspace<S>,
    observer: &mut O,
) -> Result<(), BodyError<S>> {
    let lost = slide(system, state, tau, work)?;
    lift_departing(system, state.modes, work)?;
    let flow = Flow { before: &state.motion, after: &work.end, tau, friction: lost, impact: S::ZERO };
    observer.flow(system, flow);
    state.motion.copy_from(&work.end);
    state.anchor = state.anchor - lost;
    state.pass(tau);
    if let Some(ground) = &system.ground {
        settle_modes(system, ground, state);
    }
    Ok(())
}

/// Departing points that go away, yet lie below the surface by the method's error, are put on it.
fn lift_departing<S: Scalar>(
    system: &System<S>,
    modes: &[Mode],
    work: &mut Workspace<S>,
) -> Result<(), BodyError<S>> {
    let Some(ground) = system.ground.filter(Ground::has_events) else { return Ok(()) };
    let mut lifted = false;
    for (i, _) in modes.iter().enumerate().filter(|(_, m)| **m == Mode::Departing) {
        let leaves = ground.gap_rate(vec3::at(work.end.vel, i)) >= S::ZERO;
        if leaves && ground.gap(vec3::at(work.end.pos, i)) < -ground.tolerance {
            lift(&ground, &mut work.end, i);
            lifted = true;
        }
    }
    if lifted { work.end.refresh(system) } else { Ok(()) }
}

/// Friction of the points that slide, with the mean normal force of the stretch; returns the loss [J].
///
/// A change of speed dv spread over the stretch moves the point by dv tau/2: order 2, and a point that
/// sticks does not creep. The loss is what the speeds lose plus the work of the forces on that way.
fn slide<S: Scalar>(
    system: &System<S>,
    state: &State<S>,
    tau: S,
    work: &mut Workspace<S>,
) -> Result<S, BodyError<S>> {
    let Some(ground) = system.ground.filter(|g| g.friction > S::ZERO) else { return Ok(S::ZERO) };
    let half = S::from_f64(0.5);
    let push = |motion: &Motion<S>, i: usize, mode: Mode| match mode {
        Mode::Held => system.normal_force(motion.force(i)).max(S::ZERO),
        Mode::Stuck => S::ZERO,
        _ => soft::normal_force(&ground, vec3::at(motion.pos, i), vec3::at(motion.vel, i)).0,
    };
    let (mut lost, mut slid) = (S::ZERO, false);
    for (i, mode) in state.modes.iter().enumerate() {
        let mean = half * (push(&state.motion, i, *mode) + push(&work.end, i, *mode));
        let mass = system.body.mass.get(i).copied().unwrap_or(S::ZERO);
        let (mut way, mut loss) = (vec3::zero(), S::ZERO);
        if let Some(v) = work.end.vel.get_mut(i) {
            let before = *v;
            loss = friction::apply(v, ground.normal, mass, ground.friction, tau * mean);
            way = vec3::scale(vec3::sub(*v, before), half * tau);
        }
        slid |= loss > S::ZERO;
        lost = lost + loss + half * vec3::dot(vec3::at(work.end.elastic, i), way);
        if let Some(row) = work.dx.get_mut(i) {
            *row = way;
        }
    }
    if slid {
        shift_positions(work);
        work.end.refresh(system)?;
        for (way, force) in work.dx.iter().zip(work.end.elastic.iter()) {
            lost = lost + half * vec3::dot(*force, *way);
        }
    }
    Ok(lost)
}

/// Arms guards of points that are clear of the ground; sticks and unsticks the held ones.
fn settle_modes<S: Scalar>(system: &System<S>, ground: &Ground<S>, state: &mut State<S>) {
    for (i, mode) in state.modes.iter_mut().enumerate() {
        match mode {
            Mode::Departing if ground.gap(vec3::at(state.motion.pos, i)) > ground.tolerance => {
                *mode = Mode::Free;
            }
            Mode::Held | Mode::Stuck if ground.friction > S::ZERO => {
                let force = state.motion.force(i);
                let side = vec3::norm(vec3::tangential(force, ground.normal));
                let still = vec3::at(state.motion.vel, i) == vec3::zero();
                let sticks = still && side <= ground.friction * system.normal_force(force);
                *mode = if sticks { Mode::Stuck } else { Mode::Held };
            }
            _ => {}
        }
    }
}

/// Applies the touch of all points at the surface and closing, then lets go of those that would be pulled.
fn resolve<S: Scalar, O: Observer<S>>(
    system: &System<S>,
    ground: &Ground<S>,
    state: &mut State<S>,
    (h, method): (S, Method<S>),
    work: &mut Workspace<S>,
    observer: &mut O,
) -> Result<(), BodyError<S>> {
    let touching = mark_touching(system, ground, state, work.impacts);
    let mut impact = None;
    if touching {
        place_on_surface(ground, &mut state.motion, work.impacts);
        let mut hit = apply_law(system, ground, state, (h, method), work);
        hit.friction = rub(system, ground, state.motion.vel, work.impacts);
        state.motion.vel_rest.iter_mut().for_each(|v| *v = vec3::zero());
        state.motion.refresh(system)?;
        hit.lost = hit.lost + hold_or_rebound(system, ground, state, h, work.impacts);
        state.anchor = state.anchor - hit.lost - hit.friction;
        impact = Some(hit);
    }
    let released = release(system, state);
    settle_modes(system, ground, state);
    let event = Event { time: state.t(), impact, points: work.impacts, modes: state.modes, released };
    observer.event(system, event);
    Ok(())
}

/// Marks the set B; true if it has a member.
fn mark_touching<S: Scalar>(
    system: &System<S>,
    ground: &Ground<S>,
    state: &State<S>,
    points: &mut [PointImpact<S>],
) -> bool {
    let mut any = false;
    for (i, (point, mode)) in points.iter_mut().zip(state.modes.iter()).enumerate() {
        let near = ground.gap(vec3::at(state.motion.pos, i)) <= ground.tolerance;
        let closing = ground.gap_rate(vec3::at(state.motion.vel, i)) < S::ZERO;
        let moves = system.body.inverse_mass(i) > S::ZERO;
        *point = PointImpact::none();
        point.touching = near && closing && moves && !mode.is_held();
        any |= point.touching;
    }
    any
}

/// Lifts touching points by the rounding that located them below the surface.
fn place_on_surface<S: Scalar>(ground: &Ground<S>, motion: &mut Motion<S>, points: &[PointImpact<S>]) {
    for (i, _) in points.iter().enumerate().filter(|(_, p)| p.touching) {
        let x = vec3::at(motion.pos, i);
        // Deeper ones returned within the tolerance: lifting them would feed a bounce.
        let rounding = S::from_f64(2.0) * S::EPSILON * (S::ONE + ground.offset.abs() + vec3::norm(x));
        if ground.gap(x) >= -rounding {
            lift(ground, motion, i);
        }
    }
}

/// Puts point i on the surface.
fn lift<S: Scalar>(ground: &Ground<S>, motion: &mut Motion<S>, i: usize) {
    let gap = ground.gap(vec3::at(motion.pos, i));
    if gap < S::ZERO {
        vec3::add_at(motion.pos, i, vec3::scale(ground.normal, -gap));
        if let Some(rest) = motion.pos_rest.get_mut(i) {
            *rest = vec3::tangential(*rest, ground.normal);
        }
    }
}

fn apply_law<S: Scalar>(
    system: &System<S>,
    ground: &Ground<S>,
    state: &mut State<S>,
    (h, method): (S, Method<S>),
    work: &mut Workspace<S>,
) -> Impact<S> {
    match ground.law {
        ContactLaw::Newton { restitution } => {
            restitution::apply(system, restitution, state.motion.vel, work.impacts)
        }
        ContactLaw::Compensation { eta, anchor, plastic_alone } => {
            let law = Compensation { eta, anchor: S::ZERO, plastic_alone };
            if anchor {
                anchored(system, law, state, (h, method), work)
            } else {
                compensate(system, law, state, work.impacts)
            }
        }
        _ => Impact { root: Root::Alone, lambda: S::ZERO, lost: S::ZERO, friction: S::ZERO },
    }
}

fn compensate<S: Scalar>(
    system: &System<S>,
    law: Compensation<S>,
    state: &mut State<S>,
    points: &mut [PointImpact<S>],
) -> Impact<S> {
    let modes = &*state.modes;
    let receiver = |k: usize| {
        system.body.inverse_mass(k) > S::ZERO && !modes.get(k).is_some_and(|m| m.is_held())
    };
    compensation::apply(system, law, state.motion.pos, state.motion.vel, points, receiver)
}

/// Compensation that ends at the ledger's energy. The swing after it depends on the speeds it gives: the
/// first pass takes those before.
fn anchored<S: Scalar>(
    system: &System<S>,
    law: Compensation<S>,
    state: &mut State<S>,
    (h, method): (S, Method<S>),
    work: &mut Workspace<S>,
) -> Impact<S> {
    let now = eval_energies(&system.body, state.motion.pos, state.motion.vel).total();
    copy(work.stage_vel, state.motion.vel);
    let mut hit = Impact { root: Root::Alone, lambda: S::ZERO, lost: S::ZERO, friction: S::ZERO };
    for _ in 0..ANCHOR_PASSES {
        let held = |i: usize| match work.impacts.get(i) {
            Some(point) if point.touching => Mode::Held,
            _ => state.modes.get(i).copied().unwrap_or_default(),
        };
        let swing = state.energy_swing(system, h, method, held);
        let law = Compensation { anchor: state.anchor + swing - now, ..law };
        copy(state.motion.vel, work.stage_vel);
        hit = compensate(system, law, state, work.impacts);
    }
    hit
}

/// Friction of the impulses; returns the loss [J].
fn rub<S: Scalar>(
    system: &System<S>,
    ground: &Ground<S>,
    vel: &mut [Vec3<S>],
    points: &[PointImpact<S>],
) -> S {
    let mut lost = S::ZERO;
    for ((v, point), mass) in vel.iter_mut().zip(points).zip(system.body.mass) {
        if point.touching {
            lost = lost + friction::apply(v, ground.normal, *mass, ground.friction, point.impulse);
        }
    }
    lost
}

/// A touching point is held, or flies if it rebounds for longer than [`ZENO_FLIGHT`]; returns what resting costs [J].
fn hold_or_rebound<S: Scalar>(
    system: &System<S>,
    ground: &Ground<S>,
    state: &mut State<S>,
    h: S,
    points: &[PointImpact<S>],
) -> S {
    let mut lost = S::ZERO;
    for (i, (mode, point)) in state.modes.iter_mut().zip(points).enumerate() {
        if !point.touching {
            continue;
        }
        let rate = ground.gap_rate(vec3::at(state.motion.vel, i));
        let pressing = system.normal_force(state.motion.force(i)) * system.body.inverse_mass(i);
        let is_short = S::from_f64(2.0) * rate < S::from_f64(ZENO_FLIGHT) * h * pressing;
        let is_low = rate * rate < S::from_f64(2.0) * ground.tolerance * pressing;
        let flight_ends = is_short || is_low;
        if rate > S::ZERO && !flight_ends {
            *mode = Mode::Departing;
            continue;
        }
        *mode = Mode::Held;
        if rate > S::ZERO {
            let mass = system.body.mass.get(i).copied().unwrap_or(S::ZERO);
            lost = lost + S::from_f64(0.5) * mass * rate * rate;
        }
        if let Some(v) = state.motion.vel.get_mut(i) {
            *v = vec3::tangential(*v, ground.normal);
        }
    }
    lost
}

/// Lets go of held points that the ground would have to pull; returns how many.
fn release<S: Scalar>(system: &System<S>, state: &mut State<S>) -> usize {
    let mut released = 0;
    for (i, mode) in state.modes.iter_mut().enumerate() {
        if mode.is_held() && system.normal_force(state.motion.force(i)) < S::ZERO {
            *mode = Mode::Departing;
            released += 1;
        }
    }
    released
}

fn step_moreau<S: Scalar, O: Observer<S>>(
    system: &System<S>,
    state: &mut State<S>,
    h: S,
    restitution: S,
    work: &mut Workspace<S>,
    observer: &mut O,
) -> Result<StepReport, BodyError<S>> {
    let start = Start { motion: &state.motion, modes: state.modes };
    let taken = moreau::step(system, start, h, restitution, work)?;
    crate::advance::check_finite(&work.end)?;
    pressure::check_inflation(&system.body, work.end.pos)?;
    let flow = Flow {
        before: &state.motion,
        after: &work.end,
        tau: h,
        friction: taken.friction,
        impact: taken.impact,
    };
    observer.flow(system, flow);
    state.motion.copy_from(&work.end);
    state.pass(h);
    Ok(StepReport { substeps: 1, ..StepReport::default() })
}
