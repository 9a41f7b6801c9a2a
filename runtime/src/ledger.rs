//! Energy ledger of a run: an account for every way in which energy is stored, supplied or dissipated.
//!
//! An observer: it reads pieces of motion and events and changes nothing. Losses are integrals of
//! power over each piece (Lobatto's rule on a quartic of the speeds), so the imbalance is the energy
//! that the method itself adds or loses.
//! Sign: `damping, drag, impact, friction` are energy lost so far; `actuator` is energy supplied.

use crate::contact::{System, soft};
use crate::flexible::element::Element;
use crate::flexible::energy::{Energies, eval_energies};
use crate::real::Scalar;
use crate::scene::{Event, Flow, Observer, State};
use crate::vec3::{self, Vec3};

/// Accounts of a run (J).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ledger<S> {
    /// Total energy at the start.
    pub start: S,
    /// Dissipated by dampers.
    pub damping: S,
    /// Dissipated by air drag.
    pub drag: S,
    /// Lost to the impact law (and to the dissipation of a soft ground).
    pub impact: S,
    /// Dissipated by friction.
    pub friction: S,
    /// Supplied by actuators: 0, as none acts on a body; a column of the rows.
    pub actuator: S,
}

/// Stored energies, including that of a soft ground.
#[must_use]
pub fn eval_stored<S: Scalar>(system: &System<S>, pos: &[Vec3<S>], vel: &[Vec3<S>]) -> Energies<S> {
    let mut energies = eval_energies(&system.body, pos, vel);
    if let Some(ground) = &system.ground {
        for x in pos {
            energies.spring = energies.spring + soft::energy(ground, *x);
        }
    }
    energies
}

impl<S: Scalar> Ledger<S> {
    /// Opens the accounts.
    #[must_use]
    pub fn open(system: &System<S>, state: &State<S>) -> Ledger<S> {
        let start = eval_stored(system, state.motion.pos, state.motion.vel).total();
        Ledger {
            start,
            damping: S::ZERO,
            drag: S::ZERO,
            impact: S::ZERO,
            friction: S::ZERO,
            actuator: S::ZERO,
        }
    }

    /// Change of the total energy minus the sum of the entries (J).
    #[must_use]
    pub fn imbalance(&self, energies: &Energies<S>) -> S {
        let taken = self.damping + self.drag + self.impact + self.friction;
        (energies.total() - self.start) - (self.actuator - taken)
    }
}

/// Dissipated powers at one instant (W).
#[derive(Clone, Copy)]
struct Power<S> {
    damping: S,
    drag: S,
    ground: S,
}

fn eval_power<S: Scalar>(
    system: &System<S>,
    x: impl Fn(usize) -> Vec3<S>,
    v: impl Fn(usize) -> Vec3<S>,
) -> Power<S> {
    let mut power = Power { damping: S::ZERO, drag: S::ZERO, ground: S::ZERO };
    power.damping = system.elements().power(&x, &v);
    for i in 0..system.body.points() {
        power.drag = power.drag + system.body.air_drag * vec3::dot(v(i), v(i));
        if let Some(ground) = system.ground.filter(|ground| ground.is_damped()) {
            let (_, viscous) = soft::normal_force(&ground, x(i), v(i));
            power.ground = power.ground - viscous * ground.gap_rate(v(i));
        }
    }
    power
}

/// Nodes and weights of Lobatto's rule with five points (inner nodes at 1/2 -+ sqrt(3/28)): exact to degree 7.
const LOBATTO: [(f64, f64); 5] = [
    (0.0, 1.0 / 20.0),
    (0.172_673_164_646_011_43, 49.0 / 180.0),
    (0.5, 16.0 / 45.0),
    (0.827_326_835_353_988_6, 49.0 / 180.0),
    (1.0, 1.0 / 20.0),
];

/// Motion of one point over a piece: v(s) = sum c_n s^n, x(s) = x0 + tau sum c_n s^(n+1)/(n+1), 0 <= s <= 1.
struct Course<S> {
    x0: Vec3<S>,
    tau: S,
    c: [Vec3<S>; 5],
}

impl<S: Scalar> Course<S> {
    /// From positions, speeds and accelerations at both ends; linear speeds where impulses act within the piece.
    fn new(system: &System<S>, flow: &Flow<S>, i: usize) -> Course<S> {
        let (before, after, tau) = (flow.before, flow.after, flow.tau);
        let (x0, v0, v1) = (vec3::at(before.pos, i), vec3::at(before.vel, i), vec3::at(after.vel, i));
        let change = vec3::sub(v1, v0);
        let zero = vec3::zero();
        if !flow.is_smooth {
            return Course { x0, tau, c: [v0, change, zero, zero, zero] };
        }
        let real = S::from_f64;
        let mode = flow.modes.get(i).copied().unwrap_or_default();
        // Friction changes the speed evenly over the piece.
        let braked = vec3::at(flow.braked, i);
        let b = vec3::axpy(braked, tau, system.acceleration(i, mode, before.force(i)));
        let b1 = vec3::axpy(braked, tau, system.acceleration(i, mode, after.force(i)));
        let mut c = vec3::sub(vec3::axpy(vec3::scale(change, real(3.0)), real(-2.0), b), b1);
        let mut d = vec3::add(vec3::axpy(b, real(-2.0), change), b1);
        // e s^2 (1-s)^2 corrects the displacement of the cubic; 1/30 is its integral.
        let moved = vec3::sub(vec3::at(after.pos, i), x0);
        let rest = vec3::sub(vec3::at(after.pos_rest, i), vec3::at(before.pos_rest, i));
        let mean = vec3::scale(vec3::add(moved, rest), S::ONE / tau);
        let cubic = vec3::axpy(vec3::axpy(v0, real(1.0 / 2.0), b), real(1.0 / 3.0), c);
        let cubic = vec3::axpy(cubic, real(1.0 / 4.0), d);
        let mut e = vec3::scale(vec3::sub(mean, cubic), real(30.0));
        // For a vanishing length the displacement is rounding only.
        if !e.iter().all(|e| e.is_finite()) {
            e = zero;
        }
        c = vec3::add(c, e);
        d = vec3::axpy(d, real(-2.0), e);
        Course { x0, tau, c: [v0, b, c, d, e] }
    }

    fn speed(&self, s: S) -> Vec3<S> {
        self.c.iter().rev().fold(vec3::zero(), |sum, c| vec3::axpy(*c, s, sum))
    }

    fn place(&self, s: S) -> Vec3<S> {
        let shares = [1.0, 1.0 / 2.0, 1.0 / 3.0, 1.0 / 4.0, 1.0 / 5.0].map(S::from_f64);
        let terms = self.c.iter().zip(shares).rev();
        let sum = terms.fold(vec3::zero(), |sum, (c, share)| vec3::axpy(vec3::scale(*c, share), s, sum));
        vec3::axpy(self.x0, s * self.tau, sum)
    }
}

impl<S: Scalar> Observer<S> for Ledger<S> {
    fn flow(&mut self, system: &System<S>, flow: Flow<S>) {
        self.friction = self.friction + flow.friction;
        self.impact = self.impact + flow.impact;
        if !system.is_damped() {
            return;
        }
        for (node, weight) in LOBATTO {
            let (s, part) = (S::from_f64(node), flow.tau * S::from_f64(weight));
            let course = |i| Course::new(system, &flow, i);
            let power = eval_power(system, |i| course(i).place(s), |i| course(i).speed(s));
            self.damping = self.damping + part * power.damping;
            self.drag = self.drag + part * power.drag;
            self.impact = self.impact + part * power.ground;
        }
    }

    fn event(&mut self, _: &System<S>, event: Event<S>) {
        if let Some(impact) = event.impact {
            self.impact = self.impact + impact.lost;
            self.friction = self.friction + impact.friction;
        }
    }
}
