//! The controller: one call a millisecond, always in the same order, in bounded time.
//!
//! In: readings, conditions of the link, at most one command. Out: what the board is to set.
//! Order of a tick: sense, detect faults, respond to new ones, execute the command, advance the motion, set drives and
//! valves. The outputs follow from the mode alone, so a response that changes the mode takes effect in the same tick.

use super::bladder::{Bladder, Valves, commanded};
use super::board::{Outputs, Readings};
use super::design::{
    ARRIVED, FLATTEN_FACTOR, NOT_ARRIVED, PAYLOAD, PRESSURE, SETTLING, STROKE, SWITCH, TRIM, UNHOMED_FACTOR,
};
use super::drive::DRIVE;
use super::dynamics::loads;
use super::fault::{Fault, Faults, Latch, Response};
use super::guarded::Guarded;
use super::home::{Homing, Step};
use super::mode::Mode;
use super::motion::{Heights, Motion, heights};
use super::plausible::{Doing, Watch, load};
use super::profile::Along;
use super::sense::Sense;
use super::servo::Servo;
use crate::command::Pose;
use crate::link::message::{Command, Outcome, Refusal, State, Trim};
use smartbed_runtime::real::Real;

/// Time for the sensors to settle after a start (ticks).
const BOOT: u32 = 100;
/// Time of the test of ENABLE (ticks).
const SELF_TEST: u32 = 50;
/// Duty of that test: enough current to be seen if ENABLE does not cut it.
const TEST_DUTY: f32 = 0.04;
/// Value of the permission to move; a single flipped bit does not produce it.
const ARMED: u32 = 0x5AFE_A11D;

/// Speed below which a leg counts as standing (m/s).
const STANDS: f32 = 1e-4;

/// What the legs follow.
#[derive(Clone, Copy, PartialEq, Debug)]
enum Following {
    None,
    /// They come to rest, drives off, because a profile begins at rest.
    Soon(Aim),
    Motion(Motion),
    Homing(Homing),
}

/// Where a motion will go.
#[derive(Clone, Copy, PartialEq, Debug)]
enum Aim {
    /// To these heights, at this part of the full speed.
    To(Heights, f32),
    Switches,
}

/// State of the controller.
#[derive(Clone, Debug)]
pub struct Controller {
    mode: Mode,
    /// Ticks in this mode.
    since: u32,
    /// [`ARMED`] once motion has been allowed.
    permission: Guarded<1>,
    trim: Guarded<4>,
    is_homed: bool,
    latch: Latch,
    /// Faults detected after the checks of this tick, which count in the next.
    found: Faults,
    sense: Sense,
    watch: Watch,
    servo: Servo,
    following: Following,
    /// Flatten was ordered during a retreat, and begins at its end.
    flattens: bool,
    /// Heights when the drives were switched off.
    rest: Heights,
    /// Forces of the screws (N) along the motion, by the derived equations.
    loads: [f32; 3],
    bladder: Bladder,
    wanted_pressure: Option<f32>,
    outputs: Outputs,
}

impl Controller {
    /// A tile that has just started; without a calibration it is off.
    #[must_use]
    pub fn new(trim: Option<Trim>) -> Self {
        let mut found = Faults::default();
        found.set(Fault::Storage, trim.is_none());
        Self {
            mode: Mode::Boot,
            since: 0,
            permission: Guarded::new([0]),
            trim: guard(&trim.unwrap_or_default()),
            is_homed: false,
            latch: Latch::default(),
            found,
            sense: Sense::default(),
            watch: Watch::default(),
            servo: Servo::default(),
            following: Following::None,
            flattens: false,
            rest: [0.0; 3],
            loads: [0.0; 3],
            bladder: Bladder::default(),
            wanted_pressure: None,
            outputs: Outputs::default(),
        }
    }

    /// One millisecond. `outside`: faults detected by the link; silence counts only during motion.
    /// Returns the new faults, and the outcome of the command.
    pub fn tick(
        &mut self,
        readings: &Readings,
        outside: Faults,
        command: Option<&Command>,
    ) -> (Faults, Option<Outcome>) {
        self.since = self.since.saturating_add(1);
        let (new, active) = self.check(readings, outside);
        self.respond(new);
        if self.mode == Mode::Retreat && self.since > 0 && active.has(Fault::Obstruction) {
            // Neither the way forward nor the way back is free.
            self.stop(Mode::Hold);
        }
        let outcome = command.map(|command| match self.execute(command) {
            Ok(()) => Outcome::Done,
            Err(why) => Outcome::Refused(why),
        });
        self.advance(readings);
        self.outputs = self.act();
        (new, outcome)
    }

    /// Outputs for the board.
    #[must_use]
    pub fn outputs(&self) -> &Outputs {
        &self.outputs
    }

    /// The mode.
    #[must_use]
    pub fn mode(&self) -> Mode {
        self.mode
    }

    /// The latched faults.
    #[must_use]
    pub fn latched(&self) -> Faults {
        self.latch.latched()
    }

    /// The estimated state of the tile.
    #[must_use]
    pub fn sense(&self) -> &Sense {
        &self.sense
    }

    /// State for the telemetry.
    #[must_use]
    pub fn state(&self) -> State {
        let Outputs { enable, duty, supply, vent, .. } = self.outputs;
        let bits = [enable, supply, vent, self.is_homed, self.is_armed()];
        let flags = bits.into_iter().rev().fold(0, |flags, bit| flags << 1 | u8::from(bit));
        let pressure = self.sense.pressure();
        State {
            mode: self.mode as u8,
            faults: self.latched().bits(),
            heights: self.sense.heights,
            wanted: self.following().map_or(self.rest, |(wanted, _)| wanted.map(|w| w.position)),
            duty,
            pressure,
            load: load(pressure),
            flags,
        }
    }

    /// Flips a bit of a guarded value, as radiation might; for fault injection.
    pub fn flip(&mut self, bit: usize) {
        if bit < 64 { self.permission.flip(bit) } else { self.trim.flip(bit - 64) }
    }

    fn is_armed(&self) -> bool {
        self.permission.get() == Some([ARMED])
    }

    /// Updates the estimates and detects faults; returns the new ones, and all that are present.
    fn check(&mut self, readings: &Readings, outside: Faults) -> (Faults, Faults) {
        let trim = self.trim.get_numbers();
        let [a, b, c, pressure] = trim.unwrap_or_default();
        self.sense.take(readings, &Trim { height: [a, b, c], pressure });
        let doing = match self.following() {
            Some((wanted, ways)) => {
                let seeks = matches!(&self.following, Following::Homing(homing) if homing.seeks());
                let patient = Real::min(load(self.sense.pressure()), PAYLOAD);
                self.loads = loads(&wanted, patient);
                let retreats = self.mode == Mode::Retreat;
                Doing::Follow { wanted, ways, seeks, retreats, loads: loads(&wanted, PAYLOAD) }
            }
            None => Doing::Rest(self.rest),
        };
        if self.mode == Mode::Boot {
            // No command yet: the present heights are those of rest.
            self.rest = self.sense.heights;
        }
        let mut active = self.watch.take(readings, &self.sense, &doing).with(self.found).with(outside);
        self.found = Faults::default();
        let is_moving = matches!(doing, Doing::Follow { .. });
        active.set(Fault::Memory, trim.is_none() || self.permission.get().is_none());
        let mut silence = Faults::default();
        silence.set(Fault::Silence, !is_moving);
        let testing = self.mode == Mode::SelfTest;
        active.set(Fault::EnableTest, testing && active.has(Fault::Current));
        let active = active.without(silence);
        (self.latch.take(active, is_moving), active)
    }

    /// Executes the response to new faults.
    fn respond(&mut self, new: Faults) {
        let lowers = self.mode == Mode::Flatten || self.flattens;
        let new = if lowers { new.against_lowering() } else { new };
        match new.response() {
            None => (),
            Some(Response::Off) => self.stop(Mode::Off),
            Some(_) if matches!(self.mode, Mode::Off | Mode::Boot | Mode::SelfTest) => self.stop(Mode::Off),
            Some(Response::Retreat) => {
                let here = self.sense.heights;
                let back = match self.following {
                    Following::Motion(motion) if self.mode != Mode::Retreat => motion.back(here),
                    Following::Homing(homing) => homing.back(here),
                    _ => return self.stop(Mode::Hold),
                };
                self.start(Mode::Retreat, Following::Motion(back));
            }
            Some(Response::Hold) => self.stop(Mode::Hold),
        }
    }

    /// Executes a command, or says why not; a refused command changes nothing.
    fn execute(&mut self, command: &Command) -> Result<(), Refusal> {
        let is_moving = self.following != Following::None;
        self.mode.allows(command, (self.is_armed(), is_moving), self.latched())?;
        match command {
            Command::Status | Command::Log(_) | Command::Identify | Command::Beat(_) => (),
            Command::Stop => {
                let is_done = matches!(self.mode, Mode::Off | Mode::Boot | Mode::SelfTest);
                self.stop(if is_done { self.mode } else { Mode::Hold });
                self.wanted_pressure = None;
            }
            Command::Enable => {
                self.permission = Guarded::new([ARMED]);
                self.switch(self.resting());
            }
            Command::Clear(bits) => self.clear(Faults::from_bits(*bits))?,
            Command::Home => self.begin(Mode::Homing, Aim::Switches),
            Command::Move(target) => {
                let pose = Pose { zc: target.heave, tx: target.slope_x, ty: target.slope_y };
                let factor = if self.is_homed { 1.0 } else { UNHOMED_FACTOR };
                self.begin(Mode::Moving, Aim::To(heights(pose)?, factor));
            }
            Command::Pressure(wanted) => self.wanted_pressure = Some(commanded(*wanted)?),
            // Who is in the way is released first.
            Command::Flatten if self.mode == Mode::Retreat => {
                (self.flattens, self.wanted_pressure) = (true, None);
            }
            Command::Flatten => self.flatten(),
            Command::Calibrate(trim) => {
                let (height, pressure) = TRIM;
                let fits = trim.height.iter().all(|h| Real::abs(*h) <= height);
                if !(fits && Real::abs(trim.pressure) <= pressure) {
                    return Err(Refusal::Trim);
                }
                // Start again, so that the sensors settle; faults stay, and with them the safe state.
                let (latch, sense) = (self.latch, self.sense.anew());
                *self = Self { latch, sense, ..Self::new(Some(*trim)) };
            }
        }
        Ok(())
    }

    /// Lowers the tile, and lets the air out.
    fn flatten(&mut self) {
        // A low supply voltage cannot give full speed.
        let factor = FLATTEN_FACTOR * Real::min(self.sense.measured.supply / DRIVE.supply, 1.0);
        self.wanted_pressure = None;
        self.begin(Mode::Flatten, Aim::To([-STROKE; 3], factor));
    }

    /// Clears faults. After a fault that switched the tile off, heights are taken from the displacement sensors again.
    fn clear(&mut self, faults: Faults) -> Result<(), Refusal> {
        if !self.latch.clear(faults) {
            return Err(Refusal::Cause);
        }
        if self.mode == Mode::Off {
            self.is_homed = false;
            self.sense.recover();
            self.rest = self.sense.heights;
        }
        if self.latched().is_empty() {
            self.switch(self.resting());
        }
        Ok(())
    }

    /// Advances the motion, or the start-up, by a tick.
    fn advance(&mut self, readings: &Readings) {
        if let Following::Soon(aim) = self.following {
            self.begin(self.mode, aim);
        }
        let here = self.sense.heights;
        let ended = match &mut self.following {
            Following::Motion(motion) => motion.advance().map(|ago| (ago, motion.end())),
            Following::Homing(homing) => match homing.advance(here, readings.low_closed) {
                Step::Found(found) => {
                    let new = found.into_iter().enumerate().filter(|(_, is_new)| *is_new);
                    new.for_each(|(leg, _)| self.sense.refer(leg, -SWITCH));
                    None
                }
                Step::Lost => {
                    self.found.set(Fault::SwitchPlace, true);
                    self.stop(Mode::Off);
                    None
                }
                Step::Done(ago) => Some((ago, [-STROKE; 3])),
            },
            Following::None | Following::Soon(_) => None,
        };
        match (self.mode, ended) {
            (_, Some((ago, end))) => self.settle(ago, end),
            (Mode::Boot, _) if self.since >= BOOT => {
                self.sense.recover();
                self.rest = self.sense.heights;
                self.switch(Mode::SelfTest);
            }
            (Mode::SelfTest, _) if self.since >= SELF_TEST => self.switch(match self.latched().response() {
                None => Mode::Unhomed,
                Some(Response::Off) => Mode::Off,
                Some(_) => Mode::Hold,
            }),
            _ => (),
        }
    }

    /// Ends a motion whose profile ended `ago` ticks ago: switches the drives off once the legs have arrived.
    fn settle(&mut self, ago: u32, end: Heights) {
        let is_within = |distance: f32| {
            self.sense.heights.iter().zip(end).all(|(height, end)| Real::abs(height - end) <= distance)
        };
        if !is_within(ARRIVED) && ago < SETTLING {
            return;
        }
        let is_there = is_within(NOT_ARRIVED);
        self.following = Following::None;
        self.rest = self.sense.heights;
        match self.mode {
            _ if !is_there => {
                self.found.set(Fault::Settling, true);
                self.stop(Mode::Hold);
            }
            Mode::Retreat => {
                let flattens = self.flattens;
                self.stop(Mode::Hold);
                if flattens {
                    self.flatten();
                }
            }
            // Level and at the bottom; the vent stays open.
            Mode::Flatten => (),
            Mode::Homing => {
                self.is_homed = true;
                self.switch(Mode::Ready);
            }
            _ => self.switch(self.resting()),
        }
    }

    /// Outputs in this mode.
    fn act(&mut self) -> Outputs {
        let mut outputs = Outputs::default();
        if let Some((wanted, ways)) = self.following() {
            (outputs.enable, outputs.duty) =
                (true, self.servo.duties(&self.sense, &wanted, &ways, &self.loads));
        } else if self.mode == Mode::SelfTest {
            (outputs.test, outputs.duty) = (true, [TEST_DUTY; 3]);
        }
        let pressure = self.sense.pressure();
        let valves = match self.mode {
            // Vent down to the highest pressure that may be commanded, even if a valve does not shut.
            Mode::Off | Mode::Boot | Mode::SelfTest
                if self.latched().has(Fault::Overpressure) && pressure > PRESSURE =>
            {
                self.bladder.force(Valves::Vent, pressure)
            }
            Mode::Off | Mode::Boot | Mode::SelfTest => self.bladder.force(Valves::Shut, pressure),
            Mode::Flatten => self.bladder.force(Valves::Vent, pressure),
            Mode::Retreat if self.flattens => self.bladder.force(Valves::Vent, pressure),
            _ => self.bladder.regulate(self.wanted_pressure, pressure),
        };
        let watched = self.bladder.watch(pressure, !outputs.enable);
        self.found = self.found.with(watched);
        (outputs.supply, outputs.vent) = (valves == Valves::Supply, valves == Valves::Vent);

        let is_finite = outputs.duty.iter().chain(&self.sense.heights).all(|x| x.is_finite());
        if !(is_finite && pressure.is_finite()) {
            self.found.set(Fault::NonFinite, true);
            self.stop(Mode::Off);
            return Outputs::default();
        }
        outputs
    }

    /// Wanted motion of each leg and its total displacement, while drives are on; else None.
    fn following(&self) -> Option<([Along; 3], [f32; 3])> {
        match &self.following {
            Following::None | Following::Soon(_) => None,
            Following::Motion(motion) => Some((motion.wanted(), motion.ways())),
            Following::Homing(homing) => Some(homing.wanted()),
        }
    }

    fn resting(&self) -> Mode {
        if self.is_homed { Mode::Ready } else { Mode::Unhomed }
    }

    /// Starts a motion as soon as the legs stand.
    fn begin(&mut self, mode: Mode, aim: Aim) {
        if !self.sense.speeds.iter().all(|speed| Real::abs(*speed) < STANDS) {
            if !matches!(self.following, Following::Soon(_)) {
                self.rest = self.sense.heights;
            }
            self.following = Following::Soon(aim);
            return self.switch(mode);
        }
        let here = self.sense.heights;
        let following = match aim {
            Aim::To(end, factor) => Following::Motion(Motion::new(here, end, factor)),
            Aim::Switches => Following::Homing(Homing::new(here)),
        };
        self.start(mode, following);
    }

    // Once in the image: a tile on CAN has little flash left.
    #[inline(never)]
    fn start(&mut self, mode: Mode, following: Following) {
        self.following = following;
        if let Some((wanted, _)) = self.following() {
            self.loads = loads(&wanted, Real::min(load(self.sense.pressure()), PAYLOAD));
        }
        self.servo = Servo::default();
        self.switch(mode);
    }

    /// Switches the drives off and withdraws the permission to move; off also withdraws the pressure that was ordered.
    fn stop(&mut self, mode: Mode) {
        (self.following, self.flattens) = (Following::None, false);
        self.permission = Guarded::new([0]);
        self.rest = self.sense.heights;
        if mode == Mode::Off {
            // The valves stay shut when the fault is cleared, too.
            self.wanted_pressure = None;
        }
        self.switch(mode);
    }

    fn switch(&mut self, mode: Mode) {
        if mode != self.mode {
            (self.mode, self.since) = (mode, 0);
        }
    }
}

fn guard(trim: &Trim) -> Guarded<4> {
    let [a, b, c] = trim.height;
    Guarded::numbers([a, b, c, trim.pressure])
}
