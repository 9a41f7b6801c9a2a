//! The model with its controller in the loop, one millisecond at a time.
//!
//! A model with a `[law]` is commanded by it, at every stage of a step as `smartbed run` does it; a tile without one by
//! the demonstration, whose forces are held for a step; nothing commands the inputs of another model.
//! It starts where the model's `[start]` says.
//! In: nothing but the number of steps. Out: the [`Digest`] of every (q, u) and of the energies at the end.
//! [`tile_step`] and the answers [`tile_rates`], [`tile_project`] and [`tile_energy`] are symbols of the image, so that
//! the emulator can count them and the report can tell their size.

use crate::command::Profile;
use crate::control;
use crate::digest::Digest;
use crate::mechanism::{
    HAS_LAW, INPUT_NAMES, Model, N_INPUTS, NQ, NU, PARAMETER_NAMES, Q_NAMES, START_Q, START_U, U_NAMES,
    command,
};
use crate::names::{equal, position};
use smartbed_runtime::mechanism::{Fault, Mechanism};
use smartbed_runtime::ode::Ode;
use smartbed_runtime::ode::State;
use smartbed_runtime::ode::{rk4, runge_kutta};

/// Length of the state x = [q, u].
pub const NX: usize = NQ + NU;
/// Step (s).
pub const STEP: f32 = 1e-3;
/// Newton corrections of the start: the nominal values of dependent coordinates are first guesses.
const START_CORRECTIONS: u32 = 8;

/// The three legs of a tile by their places in the model; none if the model is no tile, or has a law of its own.
pub const LEGS: Option<[Leg; 3]> =
    match (leg("hA", "u_hA", "FA"), leg("hB", "u_hB", "FB"), leg("hC", "u_hC", "FC")) {
        (Some(a), Some(b), Some(c)) if !HAS_LAW => Some([a, b, c]),
        _ => None,
    };

/// Where a leg's numbers stand in the state and in the inputs.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Leg {
    /// Height in x.
    pub height: usize,
    /// Its rate in x.
    pub rate: usize,
    /// Force in the inputs.
    pub force: usize,
}

const fn leg(height: &str, rate: &str, force: &str) -> Option<Leg> {
    match (position(&Q_NAMES, height), position(&U_NAMES, rate), position(&INPUT_NAMES, force)) {
        (Some(height), Some(rate), Some(force)) => Some(Leg { height, rate: NQ + rate, force }),
        _ => None,
    }
}

/// The model's parameter of that name, 0 if it has none that is tunable.
fn parameter(model: &Model, name: &str) -> f32 {
    let place = PARAMETER_NAMES.iter().position(|n| equal(n.as_bytes(), name.as_bytes()));
    place.and_then(|place| model.parameter(place)).unwrap_or(0.0)
}

/// Everything that changes from step to step.
pub struct Simulation {
    model: Model,
    profile: Profile,
    radius: f32,
    weight: f32,
    x: [f32; NX],
    low: [f32; NX],
    scratch: [f32; runge_kutta::rk4_scratch(NX)],
    steps: u32,
}

impl Simulation {
    /// At the model's start; at rest at its nominal configuration where it states none.
    ///
    /// # Errors
    /// As [`Mechanism::project`].
    pub fn new() -> Result<Self, Fault> {
        let mut model = Model::default();
        let radius = parameter(&model, "R");
        let mut load = parameter(&model, "M");
        for each_leg in ["ms", "mc"] {
            load += 3.0 * parameter(&model, each_leg);
        }
        let weight = load * parameter(&model, "g");
        let mut q = START_Q;
        for _ in 0..START_CORRECTIONS {
            tile_project(&mut model, &mut q)?;
        }
        let mut x = [0.0; NX];
        x.iter_mut().zip(q.iter().chain(&START_U)).for_each(|(x, start)| *x = *start);
        let start = LEGS.map_or(0.0, |legs| legs.iter().map(|l| at(&x, l.height)).sum::<f32>() / 3.0);
        let profile = Profile::demonstration(start);
        let (low, scratch) = ([0.0; NX], [0.0; runge_kutta::rk4_scratch(NX)]);
        Ok(Self { model, profile, radius, weight, x, low, scratch, steps: 0 })
    }

    /// The state x = [q, u], SI.
    #[must_use]
    pub fn x(&self) -> &[f32; NX] {
        &self.x
    }

    /// Commanded heights of A, B, C now (m).
    #[must_use]
    pub fn commanded(&self) -> [f32; 3] {
        self.profile.at(self.time()).heights(self.radius)
    }

    /// Time (s): a product, not a sum, so that it carries no error from step to step.
    #[must_use]
    pub fn time(&self) -> f32 {
        self.steps as f32 * STEP
    }

    /// Inputs of this step.
    fn inputs(&self) -> [f32; N_INPUTS] {
        let mut inputs = [0.0; N_INPUTS];
        if let Some(legs) = LEGS {
            let heights = legs.map(|l| at(&self.x, l.height));
            let rates = legs.map(|l| at(&self.x, l.rate));
            let forces = control::forces(self.weight, self.commanded(), heights, rates);
            for (leg, force) in legs.iter().zip(forces) {
                if let Some(input) = inputs.get_mut(leg.force) {
                    *input = force;
                }
            }
        }
        inputs
    }

    /// Takes so many steps and returns the digest of all states after each of them, and of the energies after the last.
    ///
    /// # Errors
    /// The number of steps done and why the next one was refused.
    pub fn run(&mut self, steps: u32) -> Result<Digest, (u32, Fault)> {
        let mut digest = Digest::default();
        for done in 0..steps {
            tile_step(self).map_err(|fault| (done, fault))?;
            digest.add(&self.x);
        }
        let time = self.time();
        self.model.set_time(time);
        let (kinetic, potential) = tile_energy(&mut self.model, &self.x).map_err(|fault| (steps, fault))?;
        digest.add(&[kinetic, potential]);
        Ok(digest)
    }
}

/// The number at a place that the compiler cannot see to be in range.
fn at(numbers: &[f32], place: usize) -> f32 {
    numbers.get(place).copied().unwrap_or(0.0)
}

/// One step of 1 ms: command, law, equations of motion.
///
/// # Errors
/// What the integrator refuses; the state is then as it was.
#[expect(unsafe_code, reason = "the emulator's plug-in finds the function by its plain name")]
#[unsafe(no_mangle)]
#[inline(never)]
pub fn tile_step(simulation: &mut Simulation) -> Result<(), Fault> {
    let inputs = simulation.inputs();
    let t = simulation.time();
    let Simulation { model, x, low, scratch, .. } = simulation;
    rk4(&mut Held { model, inputs }, t, STEP, &mut State::resume(x, low)?, scratch)?;
    #[cfg(feature = "everything")]
    answer(model, t, x, &inputs);
    simulation.steps += 1;
    Ok(())
}

/// Every other answer of the model, seen by nobody: what a step costs that leaves nothing out.
#[cfg(feature = "everything")]
fn answer(model: &Model, t: f32, x: &[f32; NX], inputs: &[f32; N_INPUTS]) {
    use crate::mechanism::{energy, outputs, speeds};
    use core::hint::black_box;
    if let (Some(q), Some(u)) = (x.first_chunk::<NQ>(), x.last_chunk::<NU>()) {
        let p = model.prepared();
        black_box((energy(t, q, u, inputs, p), speeds(t, q, u, inputs, p), outputs(t, q, u, inputs, p)));
    }
}

/// One evaluation of the equations of motion.
///
/// # Errors
/// As [`Mechanism::rates`].
#[expect(unsafe_code, reason = "the emulator's plug-in finds the function by its plain name")]
#[unsafe(no_mangle)]
#[inline(never)]
pub fn tile_rates(
    model: &mut Model,
    t: f32,
    (q, u, inputs): (&[f32], &[f32], &[f32]),
    (q_dot, u_dot): (&mut [f32], &mut [f32]),
) -> Result<f32, Fault> {
    model.rates(t, q, u, inputs, q_dot, u_dot)
}

/// One correction of the dependent coordinates; returns the largest residual before it.
///
/// # Errors
/// As [`Mechanism::project`].
#[expect(unsafe_code, reason = "the emulator's plug-in finds the function by its plain name")]
#[unsafe(no_mangle)]
#[inline(never)]
pub fn tile_project(model: &mut Model, q: &mut [f32]) -> Result<f32, Fault> {
    model.project(q)
}

/// Kinetic and potential energy (J) at the state x = [q, u].
///
/// # Errors
/// As [`Mechanism::energy`].
#[expect(unsafe_code, reason = "the emulator's plug-in finds the function by its plain name")]
#[unsafe(no_mangle)]
#[inline(never)]
pub fn tile_energy(model: &mut Model, x: &[f32]) -> Result<(f32, f32), Fault> {
    let (q, u) = x.split_at_checked(NQ).ok_or(Fault::Shape)?;
    model.energy(q, u)
}

/// The model with its inputs held, or commanded by its law.
struct Held<'a> {
    model: &'a mut Model,
    inputs: [f32; N_INPUTS],
}

impl Ode<f32> for Held<'_> {
    fn n_x(&self) -> usize {
        NX
    }
    fn n_q(&self) -> usize {
        NQ
    }
    fn rates(&mut self, t: f32, x: &[f32], x_dot: &mut [f32]) -> Result<f32, Fault> {
        let (q, u) = x.split_at_checked(NQ).ok_or(Fault::Shape)?;
        let rates = x_dot.split_at_mut_checked(NQ).ok_or(Fault::Shape)?;
        if HAS_LAW {
            let (Some(q), Some(u)) = (q.first_chunk::<NQ>(), u.first_chunk::<NU>()) else {
                return Err(Fault::Shape);
            };
            let inputs = command(t, q, u, &self.inputs, self.model.prepared());
            return tile_rates(self.model, t, (q, u, &inputs), rates);
        }
        tile_rates(self.model, t, (q, u, &self.inputs), rates)
    }
    fn set_time(&mut self, t: f32) {
        self.model.set_time(t);
    }
    fn project(&mut self, x: &mut [f32]) -> Result<f32, Fault> {
        let (q, _) = x.split_at_mut_checked(NQ).ok_or(Fault::Shape)?;
        tile_project(self.model, q)
    }
    fn projections(&self) -> u8 {
        1
    }
}

#[cfg(test)]
mod tests {
    use super::{LEGS, STEP, Simulation};
    use crate::control::{DAMPING, STIFFNESS};

    /// The law has no velocity feed-forward, so a moving command is followed with a lag of
    /// (D + friction)/K; heights move at up to slope x R x turn + rise rate < 0.06 m/s. Twice that.
    const LAG: f32 = 2.0 * 0.06 * (DAMPING + 40.0) / STIFFNESS;

    #[test]
    fn the_tile_follows_the_command() {
        let mut simulation = Simulation::new().expect("a start");
        let legs = LEGS.expect("the model is a tile");
        for _ in 0..10 {
            simulation.run((1.0 / STEP) as u32).expect("a step");
            let commanded = simulation.commanded();
            for (leg, commanded) in legs.iter().zip(commanded) {
                let error = (simulation.x[leg.height] - commanded).abs();
                assert!(error < LAG, "at {} s off by {error} m", simulation.time());
            }
        }
    }

    #[test]
    fn runs_repeat_to_the_bit() {
        let digest = || Simulation::new().expect("a start").run(100).expect("a step");
        assert_eq!(digest(), digest());
    }
}
