//! Energy ledger: an account for everything that stores energy, puts it in or takes it out.
//!
//! An observer: it reads stretches of motion and events and changes nothing. Losses are integrals of
//! power over each stretch by Simpson's rule (the middle from the cubic through both ends), so the
//! imbalance shows the energy that the method itself invents or loses.
//! Sign: `damping, drag, impact, friction` are energy taken out so far; `actuator` is energy put in.

use crate::body::energy::{Energies, eval_energies};
use crate::body::vec3::{self, Vec3};
use crate::contact::{ContactLaw, System, soft};
use crate::real::Scalar;
use crate::scene::{Event, Flow, Observer, State};

/// Accounts of a run (J).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ledger<S> {
    /// Total energy at the start.
    pub start: S,
    /// Taken by dampers.
    pub damping: S,
    /// Taken by the air.
    pub drag: S,
    /// Taken by the impact law (and the dissipation of a soft ground).
    pub impact: S,
    /// Taken by friction.
    pub friction: S,
    /// Put in by actuators (none act on a body yet).
    pub actuator: S,
}

/// Stored energies with what a soft ground holds.
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

/// Powers of what dissipates at one time (W).
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
    for spring in system.body.springs.iter().filter(|s| s.damping > S::ZERO) {
        let (d, _) = vec3::direction(vec3::sub(x(spring.head), x(spring.tail)));
        let rate = vec3::dot(vec3::sub(v(spring.head), v(spring.tail)), d);
        power.damping = power.damping + spring.damping * rate * rate;
    }
    for i in 0..system.body.points() {
        power.drag = power.drag + system.body.air_drag * vec3::dot(v(i), v(i));
        if let Some(ground) = system.ground.filter(|g| matches!(g.law, ContactLaw::HuntCrossley { .. })) {
            let (_, viscous) = soft::normal_force(&ground, x(i), v(i));
            power.ground = power.ground - viscous * ground.gap_rate(v(i));
        }
    }
    power
}

impl<S: Scalar> Observer<S> for Ledger<S> {
    fn flow(&mut self, system: &System<S>, flow: Flow<S>) {
        let (a, b, tau) = (flow.before, flow.after, flow.tau);
        self.friction = self.friction + flow.friction;
        self.impact = self.impact + flow.impact;
        let half = S::from_f64(0.5);
        let x0 = |i| vec3::at(a.pos, i);
        let x1 = |i| vec3::at(b.pos, i);
        let v0 = |i| vec3::at(a.vel, i);
        let v1 = |i| vec3::at(b.vel, i);
        // Middle of the cubic through both ends: x = (x0 + x1)/2 + tau (v0 - v1)/8, v = 3 (x1 - x0)/(2 tau) - (v0 + v1)/4.
        let xm = |i| {
            let mean = vec3::scale(vec3::add(x0(i), x1(i)), half);
            vec3::axpy(mean, tau * S::from_f64(0.125), vec3::sub(v0(i), v1(i)))
        };
        let vm = |i| {
            let chord = vec3::scale(vec3::sub(x1(i), x0(i)), S::from_f64(1.5) / tau);
            vec3::axpy(chord, -S::from_f64(0.25), vec3::add(v0(i), v1(i)))
        };
        let powers = [eval_power(system, x0, v0), eval_power(system, xm, vm), eval_power(system, x1, v1)];
        for (power, weight) in powers.iter().zip([1.0 / 6.0, 4.0 / 6.0, 1.0 / 6.0]) {
            let part = tau * S::from_f64(weight);
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
