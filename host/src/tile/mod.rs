//! `smartbed tile`: talks to tile controllers, in the emulator or on this machine.
//!
//! In: orders, as words or from standard input. Out: what the tiles say.
//! Each tile is a whole controller with the tile that it is tried on, in lock-step with this program
//! (`firmware/src/turns.rs`), so a session takes no longer than its computing and repeats byte for byte. [`order`] reads
//! the words, [`machine`] starts a tile, [`bus`] carries bytes between tiles and supervisor, [`budget`] holds what the
//! controller costs against its limits, [`show`] says it.

pub mod budget;
pub mod bus;
pub mod machine;
pub mod order;
pub mod show;

use crate::failure::Failure;
use crate::firmware::chip::{Chip, STM32F405};
use crate::output;
use bus::Bus;
use machine::{Kind, Machine};
use order::Order;
use std::io::BufRead;

/// Talk to tile controllers: move, tilt, inflate, ask.
#[derive(clap::Args, Clone, Default, PartialEq, Eq, Debug)]
#[command(
    after_help = "Orders: enable, home, move HEAVE [TILT_X TILT_Y], inflate PRESSURE, flatten, stop, clear, status, log, identify,\nwait TIME, tile N, break DEFECT.\n\nExample:\n  cargo smartbed tile 'enable; home; move 5_mm 2_deg 0_deg; inflate 4_kPa; log'\n  cargo smartbed tile --native --plot 'enable; move -10_mm; status'\n  cargo smartbed tile --budget"
)]
pub struct Arguments {
    /// Orders, with `;` between them; read from standard input if left out.
    pub orders: Option<String>,
    /// Run the tiles as programs of this machine instead of emulated chips: the same bytes, at once.
    #[arg(long)]
    pub native: bool,
    /// The emulated chip: a Cortex-M4F as on the board, M7 or M33.
    #[arg(long, value_name = "CORE", default_value = "m4", value_parser = ["m4", "m7", "m33"], conflicts_with = "native")]
    pub machine: String,
    /// Tiles on the bus.
    #[arg(long, value_name = "N", default_value_t = 1, value_parser = clap::value_parser!(u8).range(1..=28))]
    pub tiles: u8,
    /// Draw the heights while a tile moves.
    #[arg(long)]
    pub plot: bool,
    /// Hold what the controller costs on the chip against its limits: flash, RAM, stack, instructions of a tick.
    #[arg(long, conflicts_with_all = ["orders", "native", "machine", "tiles", "plot"])]
    pub budget: bool,
}

/// Does what the command line asks for.
///
/// # Errors
/// Status 1 for a wrong order, a refused command and a budget that is exceeded; status 2 where the machine lacks a tool.
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
    output::print(&show::margin(bus.margin()))?;
    match orders {
        Some(orders) => orders.iter().try_for_each(|order| take(&mut bus, order, arguments.plot))?,
        None => {
            for line in std::io::stdin().lock().lines() {
                let line = line.map_err(|e| Failure::Wrong(format!("standard input: {e}")))?;
                for order in order::read(&line)? {
                    take(&mut bus, &order, arguments.plot)?;
                }
            }
        }
    }
    bus.end()
}

/// Does one order and says what came of it.
fn take(bus: &mut Bus, order: &Order, plots: bool) -> Result<(), Failure> {
    let mut print = |text: String| output::print(&text);
    bus.take(order, &mut |said| show::said(&said, plots).map_or(Ok(()), &mut print))
}
