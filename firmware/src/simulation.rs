//! The model with its controller in the loop, one millisecond at a time.
//!
//! A model with a `[law]` is controlled by it, at every stage of a step as in `smartbed run`. A tile without one is
//! controlled by the demonstration, whose forces are constant during a step; the inputs of any other model are 0. The
//! start is the model's `[start]`. In: the number of steps. Out: the [`Digest`] of every (q, u), and of energies and
//! rates at the end. The first evaluation of a step also corrects the state ([`smartbed_runtime::ode::shared_work`]).
//! [`tile_step`] and the answers [`tile_rates`], [`tile_project`] and [`tile_energy`] are symbols of the image, so that
//! the emulator can count them and the report can tell their size.

use crate::command::Profile;
use crate::control;
use crate::digest::Digest;
use crate::mechanism::{
    self, BeginStep, CORRECTED, HAS_LAW, INPUT_NAMES, Model, N_INPUTS, NQ, NU, PARAMETER_NAMES, Q_NAMES,
    START_Q, START_U, U_NAMES, command,
};
use crate::names::{equal, position};
use smartbed_runtime::mechanism::{Fault, Mechanism};
use smartbed_runtime::ode::Ode;
use smartbed_runtime::ode::State;
use smartbed_runtime::ode::shared_work::{Begun, rk4_shared_scratch};
use smartbed_runtime::ode::{SharedWork, rk4_shared};
use smartbed_runtime::real::Turn;

/// Length of the state x = [q, u].
pub const NX: usize = NQ + NU;
/// Step (s).
pub const STEP: f32 = 1e-3;
/// Newton corrections at the start: nominal values of dependent coordinates are first guesses.
const START_CORRECTIONS: u32 = 8;

/// Indices of the three legs of a tile in the model; None if the model is no tile, or has a law of its own.
pub const LEGS: Option<[Leg; 3]> =
    match (leg("hA", "u_hA", "FA"), leg("hB", "u_hB", "FB"), leg("hC", "u_hC", "FC")) {
        (Some(a), Some(b), Some(c)) if !HAS_LAW => Some([a, b, c]),
        _ => None,
    };

/// Indices of a leg's numbers in the state and in the inputs.
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

/// Value of the model's tunable parameter of this name; 0 if there is none.
fn parameter(model: &Model, name: &str) -> f32 {
    let place = PARAMETER_NAMES.iter().position(|n| equal(n.as_bytes(), name.as_bytes()));
    place.and_then(|place| model.parameter(place)).unwrap_or(0.0)
}

/// State of the simulation.
pub struct Simulation {
    model: Model,
    profile: Profile,
    radius: f32,
    weight: f32,
    x: [f32; NX],
    low: [f32; NX],
    scratch: [f32; rk4_shared_scratch(NX)],
    steps: u32,
}

impl Simulation {
    /// At the model's start; without one at rest at its nominal configuration.
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
        let (low, scratch) = ([0.0; NX], [0.0; rk4_shared_scratch(NX)]);
        Ok(Self { model, profile, radius, weight, x, low, scratch, steps: 0 })
    }

    /// The state x = [q, u], SI.
    #[must_use]
    pub fn x(&self) -> &[f32; NX] {
        &self.x
    }

    /// Present commanded heights of A, B, C (m).
    #[must_use]
    pub fn commanded(&self) -> [f32; 3] {
        self.profile.at(self.time()).heights(self.radius)
    }

    /// Time (s): a product, not a sum, so that no error accumulates.
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

    /// Takes this many steps and returns the digest of all states after each of them, and of the energies after the
    /// last.
    ///
    /// # Errors
    /// The number of steps done, and why the next one was refused.
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
        let mut rates = [0.0; NX];
        let inputs = self.inputs();
        let last = Held { model: &mut self.model, inputs }.rates(time, &self.x, &mut rates);
        last.map_err(|fault| (steps, fault))?;
        digest.add(&rates);
        Ok(digest)
    }
}

/// Entry at an index that the compiler cannot prove to be in range; 0 beyond the end.
fn at(numbers: &[f32], place: usize) -> f32 {
    numbers.get(place).copied().unwrap_or(0.0)
}

/// One step of 1 ms: command, control law, equations of motion.
///
/// # Errors
/// Faults of the integrator; the state is then unchanged.
#[expect(unsafe_code, reason = "the emulator's plug-in finds the function by its plain name")]
#[unsafe(no_mangle)]
#[inline(never)]
pub fn tile_step(simulation: &mut Simulation) -> Result<(), Fault> {
    let inputs = simulation.inputs();
    let t = simulation.time();
    let Simulation { model, x, low, scratch, .. } = simulation;
    rk4_shared(&mut Held { model, inputs }, t, STEP, &mut State::resume(x, low)?, scratch)?;
    #[cfg(feature = "everything")]
    answer(model, t, x, &inputs);
    simulation.steps += 1;
    Ok(())
}

/// Computes every other answer of the model and discards it: the cost of a step that leaves nothing out.
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
    (x, inputs): (&[f32; NX], &[f32; N_INPUTS]),
    x_dot: &mut [f32; NX],
) -> Result<f32, Fault> {
    let ((q, u), (q_dot, u_dot)) = (parts(x)?, parts_mut(x_dot)?);
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

/// Sines and cosines that the evaluations of a step share.
type Near = [Turn<f32>; N_NEAR];
const N_NEAR: usize = mechanism::N_NEAR;

/// One evaluation of the equations of motion at a state close to the start of the step.
#[expect(unsafe_code, reason = "the emulator's plug-in finds the function by its plain name")]
#[unsafe(no_mangle)]
#[inline(never)]
pub fn tile_rates_near(
    model: &Model,
    t: f32,
    (x, inputs): (&[f32; NX], &[f32; N_INPUTS]),
    x_dot: &mut [f32; NX],
    near: &Near,
) -> f32 {
    let (Ok((q, u)), Ok((q_dot, u_dot))) = (parts(x), parts_mut(x_dot)) else { return f32::NAN };
    mechanism::rates_near_into(t, q, u, inputs, model.prepared(), near, q_dot, u_dot)
}

/// The model with constant inputs, or with those of its control law.
struct Held<'a> {
    model: &'a mut Model,
    inputs: [f32; N_INPUTS],
}

impl Held<'_> {
    /// Inputs by the control law, or constant.
    #[inline(always)]
    fn inputs<'i>(
        &'i self,
        t: f32,
        q: &[f32; NQ],
        u: &[f32; NU],
        commanded: &'i mut [f32; N_INPUTS],
    ) -> &'i [f32; N_INPUTS] {
        if !HAS_LAW {
            return &self.inputs;
        }
        *commanded = command(t, q, u, &self.inputs, self.model.prepared());
        commanded
    }
}

/// x or x_dot as coordinates and speeds.
fn parts(x: &[f32]) -> Result<(&[f32; NQ], &[f32; NU]), Fault> {
    let (q, u) = x.split_first_chunk::<NQ>().ok_or(Fault::Shape)?;
    Ok((q, u.try_into().map_err(|_| Fault::Shape)?))
}

/// The same, mutable.
fn parts_mut(x: &mut [f32]) -> Result<(&mut [f32; NQ], &mut [f32; NU]), Fault> {
    let (q, u) = x.split_first_chunk_mut::<NQ>().ok_or(Fault::Shape)?;
    Ok((q, u.try_into().map_err(|_| Fault::Shape)?))
}

/// x and x_dot with their length, which the equations then need not compare.
fn arrays<'x>(x: &'x [f32], x_dot: &'x mut [f32]) -> Result<(&'x [f32; NX], &'x mut [f32; NX]), Fault> {
    Ok((x.try_into().map_err(|_| Fault::Shape)?, x_dot.try_into().map_err(|_| Fault::Shape)?))
}

impl Ode<f32> for Held<'_> {
    fn n_x(&self) -> usize {
        NX
    }
    fn n_q(&self) -> usize {
        NQ
    }
    fn rates(&mut self, t: f32, x: &[f32], x_dot: &mut [f32]) -> Result<f32, Fault> {
        let (x, x_dot) = arrays(x, x_dot)?;
        let (q, u) = parts(x)?;
        let inputs = *self.inputs(t, q, u, &mut [0.0; N_INPUTS]);
        tile_rates(self.model, t, (x, &inputs), x_dot)
    }
}

impl SharedWork<f32> for Held<'_> {
    type Near = Near;
    fn begin(&mut self, t: f32, x: &mut [f32], x_dot: &mut [f32]) -> Result<Begun<f32, Near>, Fault> {
        let ((q, u), (q_dot, u_dot)) = (parts_mut(x)?, parts_mut(x_dot)?);
        let mut commanded = [0.0; N_INPUTS];
        let inputs = self.inputs(t, q, u, &mut commanded);
        let begun = mechanism::begin_step(t, q, u, inputs, self.model.prepared());
        let BeginStep { rates: (q_rates, u_rates, pivot), projection: (_, residual), near, .. } = begun;
        (*q_dot, *u_dot) = (q_rates, u_rates);
        mechanism::correct(&begun, q, u);
        Ok(Begun { pivot, residual, near })
    }
    fn rates_near(&mut self, t: f32, x: &[f32], x_dot: &mut [f32], near: &Near) -> Result<f32, Fault> {
        let mut commanded = [0.0; N_INPUTS];
        let (x, x_dot) = arrays(x, x_dot)?;
        let (q, u) = parts(x)?;
        let inputs = self.inputs(t, q, u, &mut commanded);
        Ok(tile_rates_near(self.model, t, (x, inputs), x_dot, near))
    }
    fn is_corrected(&self, index: usize) -> bool {
        IS_CORRECTED.get(index).copied().unwrap_or(false)
    }
}

/// Whether the correction onto the constraints determines each entry of x.
const IS_CORRECTED: [bool; NX] = {
    let mut is = [false; NX];
    let mut place = 0;
    while place < CORRECTED.len() {
        is[CORRECTED[place]] = true;
        place += 1;
    }
    is
};

#[cfg(test)]
mod tests {
    use super::{Held, LEGS, NQ, NX, STEP, Simulation, tile_step};
    use crate::control::{DAMPING, STIFFNESS};
    use smartbed_runtime::mechanism::{Fault, Mechanism};
    use smartbed_runtime::ode::runge_kutta::rk4_scratch;
    use smartbed_runtime::ode::{Ode, State, rk4};

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

    /// The same equations without shared work: every evaluation by itself, a correction behind each step.
    struct Plain<'a>(Held<'a>);

    impl Ode<f32> for Plain<'_> {
        fn n_x(&self) -> usize {
            NX
        }
        fn n_q(&self) -> usize {
            NQ
        }
        fn rates(&mut self, t: f32, x: &[f32], x_dot: &mut [f32]) -> Result<f32, Fault> {
            self.0.rates(t, x, x_dot)
        }
        fn project(&mut self, x: &mut [f32]) -> Result<f32, Fault> {
            self.0.model.project(&mut x[..NQ])
        }
        fn projections(&self) -> u8 {
            1
        }
    }

    /// A quarter of an hour beside the step that shares no work: what rounding makes of either stays where it is.
    #[test]
    fn a_million_steps_stay_beside_those_that_share_no_work() {
        let mut shared = Simulation::new().expect("a start");
        let mut plain = Simulation::new().expect("a start");
        let mut scratch = [0.0; rk4_scratch(NX)];
        let (mut apart, mut off) = (0.0_f32, 0.0_f32);
        for step in 0..1_000_000 {
            tile_step(&mut shared).expect("a step");
            let (inputs, t) = (plain.inputs(), plain.time());
            let Simulation { model, x, low, .. } = &mut plain;
            let mut state = State::resume(x, low).expect("equal lengths");
            rk4(&mut Plain(Held { model, inputs }), t, STEP, &mut state, &mut scratch).expect("a step");
            plain.steps += 1;
            if step % 100 == 0 {
                let by_entry = shared.x.iter().zip(&plain.x).map(|(a, b)| (a - b).abs());
                apart = by_entry.fold(apart, f32::max);
                let mut q = *shared.x.first_chunk::<NQ>().expect("coordinates");
                off = off.max(shared.model.project(&mut q).expect("a correction"));
            }
        }
        std::println!("{apart:e} apart, {off:e} off the constraints");
        assert!(apart < 1e-6 && off < 5e-7, "{apart:e} {off:e}");
    }

    #[test]
    fn runs_repeat_to_the_bit() {
        let digest = || Simulation::new().expect("a start").run(100).expect("a step");
        assert_eq!(digest(), digest());
    }
}
