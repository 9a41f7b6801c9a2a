//! `smartbed tile`: talks to tile controllers, in the emulator or on this machine.
//!
//! In: orders, as words or from standard input. Out: reports of the tiles. Each tile is a complete controller with a
//! simulated tile, in lock-step with this program (`firmware/src/turns.rs`), so that a session takes no longer than its
//! computation and is reproducible byte for byte. [`order`] parses orders, [`machine`] starts a tile, [`bus`] carries
//! bytes between tiles and supervisor, [`budget`] compares the controller's costs with its limits, [`show`] prints
//! reports.

pub mod budget;
pub mod bus;
pub mod machine;
pub mod order;
pub mod show;

use crate::failure::Failure;
use crate::firmware::chip::{Chip, STM32F405};
use crate::output;
use bus::{Bus, Received};
use machine::{Kind, Machine};
use order::Order;
use smartbed_firmware::link::message::Command;
use std::collections::VecDeque;
use std::io::{BufRead, IsTerminal};
use std::sync::mpsc::{Receiver, channel};

/// Send orders to tile controllers that run in the emulator or on this machine.
#[derive(clap::Args, Clone, Default, PartialEq, Eq, Debug)]
#[command(
    after_help = "Orders: enable, home, move HEAVE [TILT_X TILT_Y], inflate PRESSURE, flatten, stop, clear, status,\nlog, identify, wait TIME, tile N, break DEFECT.\nThe next order is sent when a motion has ended, or at once if `&` follows the order of the motion.\nOn a terminal, `stop` may be typed during a motion.\n\nExample:\n  cargo smartbed tile 'enable; home; move 5_mm 2_deg 0_deg; inflate 4_kPa; log'\n  cargo smartbed tile --native --plot 'enable; move -10_mm; status'\n  cargo smartbed tile --budget"
)]
pub struct Arguments {
    /// Orders, separated by `;` [default: read from standard input].
    pub orders: Option<String>,
    /// Run the tiles as programs of this machine instead of emulated chips: the same output to the byte, much sooner.
    /// Not with --machine.
    #[arg(long)]
    pub native: bool,
    /// Emulated processor: a Cortex-M4F as on the board, a Cortex-M7 or a Cortex-M33.
    #[arg(long, value_name = "CORE", default_value = "m4", value_parser = ["m4", "m7", "m33"], conflicts_with = "native")]
    pub machine: String,
    /// Number of tiles on the bus, 1 to 28.
    #[arg(long, value_name = "N", default_value_t = 1, value_parser = clap::value_parser!(u8).range(1..=28))]
    pub tiles: u8,
    /// Draw the heights of a tile's legs in the terminal while it moves.
    #[arg(long)]
    pub plot: bool,
    /// Print the reports of the tiles as JSON, one object per line, and their telemetry.
    #[arg(long)]
    pub json: bool,
    /// Build the controller and compare its cost on the chip with the limits: flash, RAM, stack, instructions per
    /// tick. Takes no other option.
    #[arg(long, conflicts_with_all = ["orders", "native", "machine", "tiles", "plot", "json"])]
    pub budget: bool,
}

/// Runs the command.
///
/// # Errors
/// Status 1 for a wrong order, a refused command and a budget that is exceeded; status 2 where the machine lacks a
/// tool.
pub fn run(arguments: &Arguments) -> Result<(), Failure> {
    if arguments.budget {
        return budget::run();
    }
    let orders = arguments.orders.as_deref().map(order::read).transpose()?;
    let chip = Chip::named(&arguments.machine).unwrap_or(STM32F405);
    let kind = if arguments.native { Kind::Native } else { Kind::Emulated(chip) };
    let program = machine::build(kind)?;
    let machines = (0..arguments.tiles).map(|number| Machine::start(&program, number, None));
    let mut bus = Bus::new(machines.collect::<Result<_, _>>()?);
    let (json, plots) = (arguments.json, arguments.plot);
    output::print(&if json { show::start(bus.margin()) } else { show::margin(bus.margin()) })?;
    let mut print = |received: Received| {
        show::line_of(&received, plots, json).map_or(Ok(()), |text| output::print(&text))
    };
    match orders {
        Some(orders) => orders.iter().try_for_each(|order| bus.take(order, &mut print))?,
        None => {
            let mut typed = Typed::new();
            while let Some(order) = typed.next()? {
                bus.take_until(&order, &mut print, &mut || typed.is_stopped())?;
            }
        }
    }
    bus.end()
}

/// Orders from standard input, read while earlier ones are executed.
struct Typed {
    lines: Receiver<std::io::Result<String>>,
    waiting: VecDeque<Order>,
    /// Orders of a script are executed in sequence: only on a terminal can `stop` interrupt a motion.
    is_terminal: bool,
}

impl Typed {
    fn new() -> Self {
        let (sender, lines) = channel();
        // The thread ends with standard input, or with the program.
        std::thread::spawn(move || {
            std::io::stdin().lock().lines().try_for_each(|line| sender.send(line)).unwrap_or_default();
        });
        Self::of(lines, std::io::stdin().is_terminal())
    }

    fn of(lines: Receiver<std::io::Result<String>>, is_terminal: bool) -> Self {
        Self { lines, waiting: VecDeque::new(), is_terminal }
    }

    fn take(&mut self, line: std::io::Result<String>) -> Result<(), Failure> {
        let line = line.map_err(|e| Failure::Wrong(format!("standard input: {e}")))?;
        self.waiting.extend(order::read(&line)?);
        Ok(())
    }

    /// Waits for the next order; `None` at the end of the input.
    fn next(&mut self) -> Result<Option<Order>, Failure> {
        while self.waiting.is_empty() {
            let Ok(line) = self.lines.recv() else { return Ok(None) };
            self.take(line)?;
        }
        Ok(self.waiting.pop_front())
    }

    /// Has `stop` been typed meanwhile? Orders typed before it are dropped.
    fn is_stopped(&mut self) -> Result<bool, Failure> {
        if !self.is_terminal {
            return Ok(false);
        }
        while let Ok(line) = self.lines.try_recv() {
            self.take(line)?;
        }
        let place = self.waiting.iter().rposition(|order| *order == Order::Send(Command::Stop));
        place.into_iter().for_each(|place| drop(self.waiting.drain(..=place)));
        Ok(place.is_some())
    }
}

#[cfg(test)]
mod tests {
    use super::{Order, Typed, channel};
    use smartbed_firmware::link::message::Command;

    /// Orders left after these lines, and whether a stop was seen between the first and the second.
    fn typed(lines: [&str; 2], is_terminal: bool) -> (bool, Vec<Order>) {
        let (sender, receiver) = channel();
        let send = |line: &str| sender.send(Ok(line.to_owned())).expect("somebody reads");
        let mut typed = Typed::of(receiver, is_terminal);
        send(lines[0]);
        assert!(typed.next().expect("an order").is_some());
        assert!(!typed.is_stopped().expect("orders"), "nothing was typed meanwhile");
        send(lines[1]);
        let is_stopped = typed.is_stopped().expect("orders");
        drop(sender);
        (is_stopped, std::iter::from_fn(|| typed.next().expect("orders")).collect())
    }

    #[test]
    fn a_stop_is_taken_at_once_on_a_terminal_and_in_its_order_in_a_script() {
        let [home, stop, status] = [Command::Home, Command::Stop, Command::Status].map(Order::Send);
        let lines = ["move 5_mm; home", "home; stop; status"];
        // Orders typed before the stop are dropped.
        assert_eq!(typed(lines, true), (true, vec![status]));
        assert_eq!(typed(lines, false), (false, vec![home, home, stop, status]));
        assert_eq!(typed(["move 5_mm", "status"], true), (false, vec![status]));
    }
}
