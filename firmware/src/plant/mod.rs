//! The simulated tile for tests of the controller: mechanism, drives, bladder, sensors, and their defects.
//!
//! In: [`Outputs`]. Out: [`Readings`], a millisecond later. The controller sees nothing else of it. The mechanism's
//! equations are derived from `models/tile.toml`; [`leg`] models motor, worm and screw with stiction in each leg,
//! [`air`] a bladder with two valves on top, [`sensors`] the readings of a board, [`flash`] the storage that survives a
//! power cut. It is not a `World` of the runtime, though it uses the runtime's gas, orifices and noise: the drive's
//! damping would force a world's explicit methods to thousands of steps per second, and a bladder of sheet nodes costs
//! hundreds of times the instructions. Here a tick is two steps, so that hours and tens of thousands of runs can be
//! simulated, on the chip too. A motor's inertia at its screw is four tonnes and a leg's load some kilograms, so a
//! drive's speed is computed with the load of the step before; the equations then give the new load.

pub mod air;
pub mod flash;
pub mod leg;
pub mod sensors;

pub use crate::defect::Defect;
use crate::names::position;
use crate::tile::board::{Actuators, Outputs, Readings, Sensors};
use crate::tile::drive::Drive;
use air::Air;
use sensors::Converters;
use smartbed_runtime::mechanism::{Fault, Mechanism};
use smartbed_runtime::real::{Real, Scalar};

/// The tile's equations with the mass of its drives, in single precision.
#[allow(clippy::all, reason = "generated, for scalars that may lack assignment operators")]
pub mod single {
    include!(concat!(env!("OUT_DIR"), "/plant_f32.rs"));
}

/// The same in double precision.
#[cfg(not(target_os = "none"))]
#[allow(clippy::all, reason = "generated, for scalars that may lack assignment operators")]
pub mod double {
    include!(concat!(env!("OUT_DIR"), "/plant_f64.rs"));
}

use single::{N_INPUTS, NQ, NU, Q_NAMES, U_NAMES};

/// Indices of the heights in q, and of their rates in u.
const HEIGHTS: [usize; 3] = [place(&Q_NAMES, "hA"), place(&Q_NAMES, "hB"), place(&Q_NAMES, "hC")];
const _: () = assert!(place(&U_NAMES, "u_hA") == 0 && place(&U_NAMES, "u_hC") == 2, "speeds in order");

#[expect(clippy::panic, reason = "evaluated by the compiler")]
const fn place(names: &[&str], name: &str) -> usize {
    match position(names, name) {
        Some(place) => place,
        None => panic!("the model has no such name"),
    }
}

/// Steps of the plant per tick.
const STEPS: u32 = 2;
/// Length of a step (s).
const STEP: f64 = 1e-3 / STEPS as f64;
/// Increments in which a start pose is reached.
const START_CORRECTIONS: u8 = 8;

/// The plant of the loop, in single precision on host and chip.
pub type Tile = Plant<f32, single::Tile>;

/// The state of the simulated tile from one step to the next.
#[derive(Clone, Debug)]
pub struct Plant<S, M> {
    mechanism: M,
    q: [S; NQ],
    /// Rounding errors of the heights.
    low: [S; 3],
    u: [S; 3],
    /// Force of the screw on its load (N).
    load: [S; 3],
    /// Forces of obstacles on the legs (N).
    contact: [S; 3],
    drive: Drive<S>,
    /// The bladder.
    pub air: Air<S>,
    /// Whether disabled drives brake, because ENABLE shorts the windings.
    pub brakes: bool,
    defect: Option<Defect>,
    converters: Converters,
    outputs: Outputs,
}

impl<S: Scalar + From<f32>, M: Mechanism<S>> Plant<S, M> {
    /// At rest at these heights (m); `nominal` are the model's coordinates.
    ///
    /// # Errors
    /// As [`Mechanism::project`].
    pub fn new(mut mechanism: M, nominal: [S; NQ], heights: [S; 3], drive: Drive<S>) -> Result<Self, Fault> {
        let mut q = nominal;
        // In increments, so that the dependent coordinates follow.
        for part in 1..=START_CORRECTIONS {
            let share = S::from(f32::from(part) / f32::from(START_CORRECTIONS));
            HEIGHTS.iter().zip(heights).for_each(|(place, height)| q[*place] = height * share);
            mechanism.project(&mut q)?;
            mechanism.project(&mut q)?;
        }
        let zero = [S::ZERO; 3];
        let mut plant = Self {
            mechanism,
            q,
            low: zero,
            u: zero,
            load: zero,
            contact: zero,
            drive,
            air: Air::default(),
            brakes: true,
            defect: None,
            converters: Converters::default(),
            outputs: Outputs::default(),
        };
        for _ in 0..START_CORRECTIONS {
            plant.hold(zero)?;
        }
        Ok(plant)
    }

    /// The equations, to change the load.
    pub fn mechanism(&mut self) -> &mut M {
        &mut self.mechanism
    }

    /// Heights of the legs (m).
    #[must_use]
    pub fn heights(&self) -> [S; 3] {
        HEIGHTS.map(|place| self.q[place])
    }

    /// Speeds of the legs (m/s).
    #[must_use]
    pub fn speeds(&self) -> [S; 3] {
        self.u
    }

    /// Forces of the screws on their loads (N).
    #[must_use]
    pub fn loads(&self) -> [S; 3] {
        self.load
    }

    /// Forces of obstacles (N).
    #[must_use]
    pub fn contacts(&self) -> [S; 3] {
        self.contact
    }

    /// Sets a defect, or repairs it.
    pub fn set_defect(&mut self, defect: Option<Defect>) {
        self.defect = defect;
    }

    /// Advances by a millisecond with these outputs.
    ///
    /// # Errors
    /// As [`Mechanism::rates`].
    #[inline(never)]
    pub fn advance(&mut self, outputs: &Outputs) -> Result<(), Fault> {
        self.outputs = *outputs;
        for _ in 0..STEPS {
            self.step()?;
        }
        let supply = (outputs.supply || self.has(Defect::ValveOpen { vent: false }))
            && !self.has(Defect::ValveShut { vent: false });
        let vent = (outputs.vent || self.has(Defect::ValveOpen { vent: true }))
            && !self.has(Defect::ValveShut { vent: true });
        self.air.advance(supply, vent);
        Ok(())
    }

    fn has(&self, defect: Defect) -> bool {
        self.defect == Some(defect)
    }

    /// Voltage at a motor; None if its windings are open.
    fn voltage(&self, leg: usize) -> Option<S> {
        let Outputs { enable, duty, test, .. } = &self.outputs;
        let live = *enable || self.has(Defect::Enable);
        let duty = if *enable || *test { duty[leg] } else { 0.0 };
        let duty = match self.defect {
            Some(Defect::Motor(broken, stuck)) if usize::from(broken) == leg => stuck,
            Some(Defect::MotorDead(broken)) if usize::from(broken) == leg => return None,
            _ => duty,
        };
        let supply = match self.defect {
            Some(Defect::Supply(volts)) => S::from(volts),
            _ => self.drive.supply,
        };
        match (live, self.brakes) {
            (true, _) => Some(supply * S::from(duty)),
            (false, true) => Some(S::ZERO),
            (false, false) => None,
        }
    }

    fn step(&mut self) -> Result<(), Fault> {
        let h = S::from_f64(STEP);
        let mut rate = [S::ZERO; 3];
        for (leg, rate) in rate.iter_mut().enumerate() {
            let after = leg::speed_after(&self.drive, self.voltage(leg), self.u[leg], self.load[leg], h);
            *rate = (after - self.u[leg]) / h;
            self.u[leg] = after;
        }
        self.contact = self.touch();
        let q_dot = self.hold(rate)?;
        self.q.iter_mut().zip(q_dot).for_each(|(q, rate)| *q = *q + h * rate);
        for (leg, place) in HEIGHTS.into_iter().enumerate() {
            // Compensated sum of the heights: a step changes only a few of their last digits.
            let before = self.q[place] - h * q_dot[place];
            let change = h * self.u[leg] + self.low[leg];
            let after = before + change;
            self.low[leg] = change - (after - before);
            self.q[place] = after;
        }
        self.mechanism.project(&mut self.q)?;
        Ok(())
    }

    /// Rates of the coordinates under these accelerations of the legs; updates the loads of the screws.
    fn hold(&mut self, rate: [S; 3]) -> Result<[S; NQ], Fault> {
        let mass = leg::reflected(&self.drive);
        let mut inputs = [S::ZERO; N_INPUTS];
        for (leg, input) in inputs.iter_mut().enumerate() {
            *input = mass * rate[leg] + self.load[leg] + self.contact[leg];
        }
        let (mut q_dot, mut u_dot) = ([S::ZERO; NQ], [S::ZERO; NU]);
        self.mechanism.rates(S::ZERO, &self.q, &self.u, &inputs, &mut q_dot, &mut u_dot)?;
        for (leg, load) in self.load.iter_mut().enumerate() {
            *load = *load + mass * (rate[leg] - u_dot[leg]);
        }
        Ok(q_dot)
    }

    /// Forces of end stops and obstacles.
    fn touch(&self) -> [S; 3] {
        let (stop, block, end) = (S::from_f64(2e6), S::from_f64(5e4), S::from_f64(0.0305));
        let mut forces = [S::ZERO; 3];
        for (leg, force) in forces.iter_mut().enumerate() {
            let height = self.q[HEIGHTS[leg]];
            *force = stop * (Real::max(-end - height, S::ZERO) - Real::max(height - end, S::ZERO));
            match self.defect {
                Some(Defect::Block { leg: l, height: at, above }) if usize::from(l) == leg => {
                    let into = if above { height - S::from(at) } else { S::from(at) - height };
                    let push = block * Real::max(into, S::ZERO);
                    *force = *force + if above { -push } else { push };
                }
                _ => (),
            }
        }
        forces
    }
}

impl Tile {
    /// A tile with a patient of this mass (kg), this far off its centre (m), at these heights (m).
    ///
    /// # Errors
    /// As [`Plant::new`].
    #[inline(never)]
    pub fn loaded(mass: f32, offset: [f32; 2], heights: [f32; 3], drive: Drive<f32>) -> Result<Self, Fault> {
        let [x_payload, y_payload] = offset;
        let parameters = single::Parameters {
            m_payload: mass,
            x_payload,
            y_payload,
            mr: leg::reflected(&drive),
            ..single::Parameters::default()
        };
        let mut plant = Self::new(single::Tile::new(parameters), single::NOMINAL, heights, drive)?;
        plant.air = Air::under(mass);
        Ok(plant)
    }
}

impl Sensors for Tile {
    #[inline(never)]
    fn read(&mut self) -> Readings {
        let place = sensors::Place {
            heights: self.heights(),
            currents: core::array::from_fn(|leg| {
                let volts = self.voltage(leg).filter(|_| self.outputs.enable || self.has(Defect::Enable));
                volts.map_or(0.0, |volts| leg::current(&self.drive, volts, self.u[leg]))
            }),
            pressure: self.air.pressure(),
            supply: match self.defect {
                Some(Defect::Supply(volts)) => volts,
                _ => self.drive.supply,
            },
        };
        self.converters.read(&place, self.defect)
    }
}

impl Actuators for Tile {
    fn set(&mut self, outputs: &Outputs) -> bool {
        self.advance(outputs).is_ok()
    }
}
