//! The interface of the controller to the hardware, as traits.
//!
//! In: raw numbers of converters, counters and lines, as a board reads them. Out: the outputs that a board sets.
//! Every reading is an integer or a bit, so no sensor can hand in a NaN; [`Readings::measure`] converts
//! to SI units. A board implements [`Sensors`] and [`Actuators`]; [`Lines`] implements the latter for any
//! board whose drives use the traits of embedded-hal.

use embedded_hal::digital::OutputPin;
use embedded_hal::pwm::SetDutyCycle;
use smartbed_runtime::real::Real;

/// Counts of the encoder per turn of the motor: 1,024 lines, each edge.
pub const COUNTS: f32 = 4096.0;
/// Height per count of the displacement sensor (m): 64 mm over 4096 counts; 2048 is the middle.
pub const DISPLACEMENT: f32 = 64e-3 / 4096.0;
/// Pressure per count (Pa); [`NO_PRESSURE`] counts are ambient.
pub const PRESSURE: f32 = 5.0;
/// Counts at ambient pressure.
pub const NO_PRESSURE: i32 = 400;
/// Current per count (A); 2048 is none.
pub const CURRENT: f32 = 2e-3;
/// Supply per count (V).
pub const SUPPLY: f32 = 0.01;
/// Least and greatest count of a converter for a sound sensor; beyond them it is at a rail.
pub const RAILS: (u16, u16) = (8, 4087);

/// Raw readings of one tick.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Readings {
    /// Encoders of the motors: counts since start.
    pub encoder: [i32; 3],
    /// Displacement sensors (LVDT) of the legs.
    pub displacement: [u16; 3],
    /// Whether the circuits of the lower end switches are closed. A pressed switch or a broken wire opens them.
    pub low_closed: [bool; 3],
    /// The same for the upper ones.
    pub high_closed: [bool; 3],
    /// Two sensors of the bladder's pressure.
    pub pressure: [u16; 2],
    /// Currents of the motors.
    pub current: [u16; 3],
    /// Supply of the drives.
    pub supply: u16,
    /// Whether the drives report a fault.
    pub drive_fault: [bool; 3],
    /// Whether the last tick took too long.
    pub overrun: bool,
}

/// The same in SI units.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Measured {
    /// Heights by displacement sensor (m).
    pub displaced: [f32; 3],
    /// Pressures over ambient (Pa).
    pub pressure: [f32; 2],
    /// Currents (A).
    pub current: [f32; 3],
    /// Supply (V).
    pub supply: f32,
}

impl Readings {
    /// Readings of a tile at rest in the middle without faults, the bladder empty.
    #[must_use]
    pub const fn at_rest() -> Self {
        Self {
            encoder: [0; 3],
            displacement: [2048; 3],
            low_closed: [true; 3],
            high_closed: [true; 3],
            pressure: [NO_PRESSURE as u16; 2],
            current: [2048; 3],
            supply: 2400,
            drive_fault: [false; 3],
            overrun: false,
        }
    }

    /// The readings in SI units, except the encoders: [`super::sense`] converts their counts.
    #[must_use]
    pub fn measure(&self) -> Measured {
        Measured {
            displaced: self.displacement.map(|n| (i32::from(n) - 2048) as f32 * DISPLACEMENT),
            pressure: self.pressure.map(|n| (i32::from(n) - NO_PRESSURE) as f32 * PRESSURE),
            current: self.current.map(|n| (i32::from(n) - 2048) as f32 * CURRENT),
            supply: f32::from(self.supply) * SUPPLY,
        }
    }
}

/// Outputs of the tile in one tick. The default is safe: nothing moves, the bladder keeps its air.
#[derive(Clone, Copy, PartialEq, Debug, Default)]
pub struct Outputs {
    /// Whether the drives are enabled. The line cuts their power, whatever the duty.
    pub enable: bool,
    /// Duty of the drives (-1 to 1).
    pub duty: [f32; 3],
    /// Whether the valve from the pump is open.
    pub supply: bool,
    /// Whether the vent is open.
    pub vent: bool,
    /// Whether the duty is set although the drives are disabled; only the test of ENABLE at start uses it.
    pub test: bool,
}

/// Reads the hardware.
pub trait Sensors {
    /// All readings of this tick.
    fn read(&mut self) -> Readings;
}

/// Sets the hardware.
pub trait Actuators {
    /// Sets all outputs; false if one could not be set.
    fn set(&mut self, outputs: &Outputs) -> bool;
}

/// Outputs on pins: three pairs of PWM channels (up, down), ENABLE, and two valves.
#[derive(Debug)]
pub struct Lines<P, E> {
    /// PWM channels of each leg: the one that raises it, and the one that lowers it.
    pub drives: [(P, P); 3],
    /// High enables all drives.
    pub enable: E,
    /// High opens the valve from the pump.
    pub supply: E,
    /// High opens the vent.
    pub vent: E,
}

impl<P: SetDutyCycle, E: OutputPin> Actuators for Lines<P, E> {
    fn set(&mut self, outputs: &Outputs) -> bool {
        // Power goes off before anything else is set, and on after everything else is.
        let mut done = outputs.enable || self.enable.set_low().is_ok();
        for ((up, down), duty) in self.drives.iter_mut().zip(outputs.duty) {
            let wanted = if outputs.enable || outputs.test { duty } else { 0.0 };
            done &= set_duty(up, wanted) && set_duty(down, -wanted);
        }
        done &= self.supply.set_state(outputs.supply.into()).is_ok();
        done &= self.vent.set_state(outputs.vent.into()).is_ok();
        if !done {
            let _ = self.enable.set_low();
            return false;
        }
        !outputs.enable || self.enable.set_high().is_ok()
    }
}

/// Sets a channel to a duty; a duty that is not positive is off.
fn set_duty(channel: &mut impl SetDutyCycle, duty: f32) -> bool {
    let most = channel.max_duty_cycle();
    // The cast saturates, and turns NaN into 0.
    let counts = (Real::min(duty, 1.0) * f32::from(most)) as u16;
    channel.set_duty_cycle(counts).is_ok()
}

#[cfg(test)]
mod tests {
    use super::{Actuators, Lines, Outputs};
    use embedded_hal::digital::{self, ErrorKind, OutputPin};
    use embedded_hal::pwm::{self, SetDutyCycle};
    use std::rc::Rc;
    use std::vec::Vec;
    use std::{cell::RefCell, string::String};

    /// A pin or channel that writes down what is set, or fails.
    #[derive(Clone, Debug)]
    struct Pin {
        name: String,
        log: Rc<RefCell<Vec<(String, u16)>>>,
        is_broken: bool,
    }

    #[derive(Debug)]
    struct Broken;
    impl digital::Error for Broken {
        fn kind(&self) -> ErrorKind {
            ErrorKind::Other
        }
    }
    impl pwm::Error for Broken {
        fn kind(&self) -> pwm::ErrorKind {
            pwm::ErrorKind::Other
        }
    }
    impl digital::ErrorType for Pin {
        type Error = Broken;
    }
    impl pwm::ErrorType for Pin {
        type Error = Broken;
    }
    impl Pin {
        fn write(&self, value: u16) -> Result<(), Broken> {
            self.log.borrow_mut().push((self.name.clone(), value));
            if self.is_broken { Err(Broken) } else { Ok(()) }
        }
    }
    impl OutputPin for Pin {
        fn set_low(&mut self) -> Result<(), Broken> {
            self.write(0)
        }
        fn set_high(&mut self) -> Result<(), Broken> {
            self.write(1)
        }
    }
    impl SetDutyCycle for Pin {
        fn max_duty_cycle(&self) -> u16 {
            1000
        }
        fn set_duty_cycle(&mut self, duty: u16) -> Result<(), Broken> {
            self.write(duty)
        }
    }

    /// What is set, in order; `broken` names a pin that fails.
    fn set(outputs: &Outputs, broken: &str) -> (bool, Vec<(String, u16)>) {
        let log = Rc::new(RefCell::new(Vec::new()));
        let pin = |name: &str| Pin { name: name.into(), log: log.clone(), is_broken: name == broken };
        let drives = [("A+", "A-"), ("B+", "B-"), ("C+", "C-")].map(|(up, down)| (pin(up), pin(down)));
        let mut lines = Lines { drives, enable: pin("enable"), supply: pin("supply"), vent: pin("vent") };
        let done = lines.set(outputs);
        let log = log.borrow().clone();
        (done, log)
    }

    #[test]
    fn power_goes_off_first_and_on_last() {
        let (done, log) = set(&Outputs { duty: [1.0; 3], ..Outputs::default() }, "");
        assert!(done && log[0] == ("enable".into(), 0));
        assert!(log.iter().all(|(_, value)| *value == 0), "disabled drives get no duty");
        let (done, log) = set(&Outputs { enable: true, duty: [0.5, -0.25, 2.0], ..Outputs::default() }, "");
        let expected = [("A+", 500), ("A-", 0), ("B+", 0), ("B-", 250), ("C+", 1000), ("C-", 0)];
        assert!(done && log.last() == Some(&("enable".into(), 1)));
        assert_eq!(log[..6].to_vec(), expected.map(|(n, v)| (n.into(), v)));
    }

    #[test]
    fn what_cannot_be_set_disables() {
        for broken in ["A+", "C-", "vent"] {
            let (done, log) = set(&Outputs { enable: true, ..Outputs::default() }, broken);
            assert!(!done && log.last() == Some(&("enable".into(), 0)), "{broken}");
        }
    }

    #[test]
    fn no_number_is_no_duty() {
        let (_, log) = set(&Outputs { enable: true, duty: [f32::NAN; 3], ..Outputs::default() }, "");
        assert!(log[..6].iter().all(|(_, value)| *value <= 1000));
    }
}
