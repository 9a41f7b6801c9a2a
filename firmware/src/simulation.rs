//! The tile with its controller in the loop, one millisecond at a time.
//!
//! In: nothing but the number of steps. Out: the [`Digest`] of every (q, u).
//! Invariant: the forces are computed once per step and held, as a controller's tick would.
//! [`tile_step`] and [`tile_rates`] are symbols of the image so that the emulator can count them.

use crate::command::Profile;
use crate::control;
use crate::digest::Digest;
use crate::mechanism::{COORDINATES, INPUTS, Model, N_INPUTS, NQ, NU, PARAMETERS, SPEEDS, START_Q, START_U};
use crate::rk4;
use smartbed_runtime::mechanism::{Fault, Mechanism};

/// Step [s].
pub const STEP: f32 = 1e-3;

/// The three legs of a tile by their places in the model; none if the model is no tile. Another
/// mechanism moves without inputs.
pub const LEGS: Option<[Leg; 3]> =
    match (leg("hA", "u_hA", "FA"), leg("hB", "u_hB", "FB"), leg("hC", "u_hC", "FC")) {
        (Some(a), Some(b), Some(c)) => Some([a, b, c]),
        _ => None,
    };

/// Where a leg's numbers stand in q, u and the inputs.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Leg {
    /// Height in q.
    pub height: usize,
    /// Its rate in u.
    pub rate: usize,
    /// Force in the inputs.
    pub force: usize,
}

const fn leg(height: &str, rate: &str, force: &str) -> Option<Leg> {
    match (position(&COORDINATES, height), position(&SPEEDS, rate), position(&INPUTS, force)) {
        (Some(height), Some(rate), Some(force)) => Some(Leg { height, rate, force }),
        _ => None,
    }
}

/// Where `name` stands among `names`.
const fn position(names: &[&str], name: &str) -> Option<usize> {
    let mut i = 0;
    while i < names.len() {
        if equal(names[i].as_bytes(), name.as_bytes()) {
            return Some(i);
        }
        i += 1;
    }
    None
}

const fn equal(a: &[u8], b: &[u8]) -> bool {
    let mut i = 0;
    while i < a.len() && i < b.len() && a[i] == b[i] {
        i += 1;
    }
    i == a.len() && i == b.len()
}

/// The model's parameter of that name, 0 if it has none.
const fn parameter(name: &str) -> f32 {
    let mut i = 0;
    while i < PARAMETERS.len() {
        if equal(PARAMETERS[i].0.as_bytes(), name.as_bytes()) {
            return PARAMETERS[i].1;
        }
        i += 1;
    }
    0.0
}

/// Everything that changes from step to step.
pub struct Simulation {
    model: Counted,
    profile: Profile,
    /// Coordinates, SI.
    pub q: [f32; NQ],
    /// Independent speeds, SI.
    pub u: [f32; NU],
    steps: u32,
}

impl Default for Simulation {
    fn default() -> Self {
        Self::new()
    }
}

impl Simulation {
    /// At rest at the model's start.
    #[must_use]
    pub fn new() -> Self {
        let start = LEGS.map_or(0.0, |legs| legs.iter().map(|l| at(&START_Q, l.height)).sum::<f32>() / 3.0);
        let profile = Profile::demonstration(start);
        Self { model: Counted(Model::new()), profile, q: START_Q, u: START_U, steps: 0 }
    }

    /// Commanded heights of A, B, C now [m].
    #[must_use]
    pub fn commanded(&self) -> [f32; 3] {
        self.profile.at(self.time()).heights(parameter("R"))
    }

    /// Time [s]: a product, not a sum, so that it carries no error from step to step.
    #[must_use]
    pub fn time(&self) -> f32 {
        self.steps as f32 * STEP
    }

    /// Inputs of this step.
    fn inputs(&self) -> [f32; N_INPUTS] {
        let mut inputs = [0.0; N_INPUTS];
        if let Some(legs) = LEGS {
            let heights = legs.map(|l| at(&self.q, l.height));
            let rates = legs.map(|l| at(&self.u, l.rate));
            let weight = (3.0 * (parameter("ms") + parameter("mc")) + parameter("M")) * parameter("g");
            let forces = control::forces(weight, self.commanded(), heights, rates);
            for (leg, force) in legs.iter().zip(forces) {
                if let Some(input) = inputs.get_mut(leg.force) {
                    *input = force;
                }
            }
        }
        inputs
    }

    /// Takes so many steps and returns the digest of all states after each of them.
    ///
    /// # Errors
    /// The number of steps done and why the next one was refused.
    pub fn run(&mut self, steps: u32) -> Result<Digest, (u32, Fault)> {
        let mut digest = Digest::default();
        for done in 0..steps {
            tile_step(self).map_err(|fault| (done, fault))?;
            digest.add(&self.q);
            digest.add(&self.u);
        }
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
    let clock = (simulation.time(), STEP);
    let Simulation { model, q, u, .. } = simulation;
    rk4::step(model, clock, q, u, &inputs)?;
    simulation.steps += 1;
    Ok(())
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

/// The model, with its rates behind a symbol.
struct Counted(Model);

impl Mechanism<f32> for Counted {
    fn n_q(&self) -> usize {
        self.0.n_q()
    }
    fn n_u(&self) -> usize {
        self.0.n_u()
    }
    fn n_inputs(&self) -> usize {
        self.0.n_inputs()
    }
    fn rates(
        &mut self,
        t: f32,
        q: &[f32],
        u: &[f32],
        inputs: &[f32],
        q_dot: &mut [f32],
        u_dot: &mut [f32],
    ) -> Result<f32, Fault> {
        tile_rates(&mut self.0, t, (q, u, inputs), (q_dot, u_dot))
    }
    fn project(&mut self, q: &mut [f32]) -> Result<f32, Fault> {
        self.0.project(q)
    }
    fn energy(&mut self, q: &[f32], u: &[f32]) -> Result<(f32, f32), Fault> {
        self.0.energy(q, u)
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
        let mut simulation = Simulation::new();
        let legs = LEGS.expect("the model is a tile");
        for _ in 0..10 {
            simulation.run((1.0 / STEP) as u32).expect("a step");
            let commanded = simulation.commanded();
            for (leg, commanded) in legs.iter().zip(commanded) {
                let error = (simulation.q[leg.height] - commanded).abs();
                assert!(error < LAG, "at {} s off by {error} m", simulation.time());
            }
        }
    }

    #[test]
    fn runs_repeat_to_the_bit() {
        let digest = || Simulation::new().run(100).expect("a step");
        assert_eq!(digest(), digest());
    }
}
