//! Modes of the tile, and the commands that each allows.
//!
//! In: a command and the mode. Out: whether it may be executed, and if not, why. The whole table is here;
//! `super::controller` executes commands.

use super::fault::{Faults, Response};
use crate::link::message::{Command, Refusal};

/// Mode of the tile. Its number is sent in the telemetry.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
#[repr(u8)]
pub enum Mode {
    /// Sensors settle.
    #[default]
    Boot,
    /// ENABLE is being tested.
    SelfTest,
    /// Heights are those of the displacement sensors; half speed.
    Unhomed,
    /// End switches are searched.
    Homing,
    /// Heights are known; nothing moves.
    Ready,
    /// Moving to a target.
    Moving,
    /// Moving back from an obstruction.
    Retreat,
    /// Stopped; screws hold the pose, the bladder is kept.
    Hold,
    /// Stopped by a fault; valves shut.
    Off,
    /// Level, at the bottom, and vented.
    Flatten,
}

impl Mode {
    /// All, by number.
    pub const ALL: [Self; 10] = [
        Self::Boot,
        Self::SelfTest,
        Self::Unhomed,
        Self::Homing,
        Self::Ready,
        Self::Moving,
        Self::Retreat,
        Self::Hold,
        Self::Off,
        Self::Flatten,
    ];

    /// Its name.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Boot => "boot",
            Self::SelfTest => "self-test",
            Self::Unhomed => "unhomed",
            Self::Homing => "homing",
            Self::Ready => "ready",
            Self::Moving => "moving",
            Self::Retreat => "retreat",
            Self::Hold => "hold",
            Self::Off => "off",
            Self::Flatten => "flatten",
        }
    }

    /// Whether it waits for a target.
    #[must_use]
    pub const fn rests(self) -> bool {
        matches!(self, Self::Unhomed | Self::Ready)
    }

    /// Checks whether a command is allowed in this mode, if motion is allowed or not, and something moves or not.
    ///
    /// # Errors
    /// The reason for a refusal.
    pub fn allows(
        self,
        command: &Command,
        (is_armed, is_moving): (bool, bool),
        latched: Faults,
    ) -> Result<(), Refusal> {
        let starts = matches!(self, Self::Boot | Self::SelfTest);
        match command {
            Command::Stop | Command::Status | Command::Log(_) | Command::Identify | Command::Beat(_) => {
                Ok(())
            }
            _ if starts => Err(Refusal::Mode),
            Command::Clear(_) if matches!(self, Self::Hold | Self::Off) => Ok(()),
            Command::Clear(_) => Err(Refusal::Mode),
            Command::Flatten => match latched.response() {
                Some(Response::Off) => Err(Refusal::Faulted),
                _ if matches!(self, Self::Off | Self::Flatten) => Err(Refusal::Mode),
                _ => Ok(()),
            },
            Command::Calibrate(_) if is_armed => Err(Refusal::Busy),
            Command::Calibrate(_) if self.rests() || matches!(self, Self::Hold | Self::Off) => Ok(()),
            _ if !latched.is_empty() => Err(Refusal::Faulted),
            Command::Enable if is_moving => Err(Refusal::Busy),
            Command::Enable if self.rests() || matches!(self, Self::Hold | Self::Flatten) => Ok(()),
            Command::Home | Command::Move(_) | Command::Pressure(_) if !is_armed => Err(Refusal::Mode),
            Command::Pressure(_) if self.rests() || self == Self::Moving => Ok(()),
            Command::Home | Command::Move(_) if self.rests() => Ok(()),
            _ if matches!(self, Self::Moving | Self::Homing | Self::Retreat | Self::Flatten) => {
                Err(Refusal::Busy)
            }
            _ => Err(Refusal::Mode),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::Mode;
    use crate::link::message::{Command, Refusal, Target, Trim};
    use crate::tile::fault::{Fault, Faults};

    #[test]
    fn numbers_are_those_of_the_list() {
        for (number, mode) in Mode::ALL.into_iter().enumerate() {
            assert_eq!(mode as usize, number, "{}", mode.name());
        }
    }

    #[test]
    fn nothing_moves_unless_it_is_allowed_and_nothing_is_wrong() {
        let moves = [Command::Home, Command::Move(Target::default()), Command::Pressure(0.0)];
        let mut faults = Faults::default();
        faults.set(Fault::Silence, true);
        for mode in Mode::ALL {
            for command in moves {
                assert!(
                    mode.allows(&command, (false, false), Faults::default()).is_err(),
                    "{mode:?} {command:?}"
                );
                assert!(mode.allows(&command, (true, false), faults).is_err(), "{mode:?} {command:?}");
            }
            assert_eq!(mode.allows(&Command::Stop, (false, false), faults), Ok(()));
            assert!(
                mode.allows(&Command::Calibrate(Trim::default()), (true, false), Faults::default()).is_err()
            );
        }
        assert_eq!(Mode::Ready.allows(&moves[1], (true, false), Faults::default()), Ok(()));
        assert_eq!(Mode::Moving.allows(&moves[1], (true, true), Faults::default()), Err(Refusal::Busy));
    }

    #[test]
    fn resuscitation_is_allowed_while_held_but_not_when_off() {
        let mut faults = Faults::default();
        faults.set(Fault::Obstruction, true);
        for mode in [Mode::Hold, Mode::Retreat] {
            assert_eq!(mode.allows(&Command::Flatten, (false, false), faults), Ok(()));
        }
        faults.set(Fault::Runaway, true);
        assert_eq!(Mode::Off.allows(&Command::Flatten, (false, false), faults), Err(Refusal::Faulted));
        assert_eq!(
            Mode::Boot.allows(&Command::Flatten, (true, false), Faults::default()),
            Err(Refusal::Mode)
        );
        // What lowers the tile is not interrupted by the permission for something else.
        let enable =
            |is_moving: bool| Mode::Flatten.allows(&Command::Enable, (false, is_moving), Faults::default());
        assert_eq!([enable(false), enable(true)], [Ok(()), Err(Refusal::Busy)]);
    }
}
