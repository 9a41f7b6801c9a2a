//! Controller and plant in lock-step.

use smartbed_firmware::command::Pose;
use smartbed_firmware::link::message::{Command, Outcome, Target, Trim};
use smartbed_firmware::plant::Tile;
use smartbed_firmware::tile::board::Sensors;
use smartbed_firmware::tile::controller::Controller;
use smartbed_firmware::tile::drive::{DRIVE, Drive};
use smartbed_firmware::tile::fault::Faults;
use smartbed_firmware::tile::mode::Mode;
use smartbed_firmware::tile::motion::pose;

/// The command that moves it there: heave (m), slopes (1).
pub fn target(heave: f32, slope_x: f32, slope_y: f32) -> Command {
    Command::Move(Target { heave, slope_x, slope_y })
}

/// Usual friction, the least, the most.
pub const FRICTIONS: [Option<bool>; 3] = [None, Some(true), Some(false)];

/// The drive with this friction.
pub fn drive(friction: Option<bool>) -> Drive<f32> {
    friction.map_or(DRIVE, |is_least| DRIVE.with_friction(is_least))
}

/// Controller and plant in lock-step.
pub struct Bench {
    pub tile: Tile,
    pub controller: Controller,
}

impl Bench {
    pub fn new(mass: f32, offset: [f32; 2], heights: [f32; 3], drive: Drive<f32>) -> Self {
        let tile = Tile::loaded(mass, offset, heights, drive).expect("a start");
        Self { tile, controller: Controller::new(Some(Trim::default())) }
    }

    /// Started, and motion allowed.
    pub fn ready(mass: f32, offset: [f32; 2], heights: [f32; 3], drive: Drive<f32>) -> Self {
        let mut bench = Self::new(mass, offset, heights, drive);
        bench.run(200);
        assert_eq!(bench.controller.mode(), Mode::Unhomed, "{:?}", bench.faults());
        bench.order(Command::Enable);
        bench
    }

    pub fn homed(mass: f32, offset: [f32; 2], drive: Drive<f32>) -> Self {
        let mut bench = Self::ready(mass, offset, [-0.02; 3], drive);
        bench.order(Command::Home);
        bench.until(Mode::Ready, 60_000);
        bench
    }

    pub fn tick(&mut self, command: Option<&Command>) -> Option<Outcome> {
        let readings = self.tile.read();
        let (_, outcome) = self.controller.tick(&readings, Faults::default(), command);
        self.tile.advance(self.controller.outputs()).expect("a step");
        outcome
    }

    pub fn order(&mut self, command: Command) {
        assert_eq!(self.tick(Some(&command)), Some(Outcome::Done), "{command:?}");
    }

    pub fn run(&mut self, ticks: u32) {
        for _ in 0..ticks {
            self.tick(None);
        }
    }

    pub fn until(&mut self, mode: Mode, most: u32) -> u32 {
        for tick in 0..most {
            if self.controller.mode() == mode {
                return tick;
            }
            self.tick(None);
        }
        panic!("{:?} after {most} ticks, not {mode:?}: {:?}", self.controller.mode(), self.faults());
    }

    pub fn pose(&self) -> Pose {
        pose(self.tile.heights())
    }

    pub fn faults(&self) -> Vec<&'static str> {
        self.controller.latched().names().collect()
    }
}
