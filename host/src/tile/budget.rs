//! What the controller costs on the chip, held against its limits.
//!
//! In: nothing. Out: flash, RAM, stack by analysis and as used, instructions and cycles of a tick, and a failure where one is too
//! much. A nominal session and sessions with faults run in the emulator with the counting plug-in; the most of all of them counts.

use super::bus::Bus;
use super::machine::{self, Kind, Machine};
use super::order;
use crate::failure::Failure;
use crate::firmware::chip::STM32F405;
use crate::firmware::emulator::{count_option, plugin, read_counts};
use crate::firmware::image::Image;
use crate::firmware::image::rules::{self, Rule};
use crate::firmware::image::stack::Stack;
use crate::firmware::{board, lock, read, toolchain, workspace};
use crate::output;
use std::fmt::Write;

/// Flash of the loop's image: the board's less its drivers, and the simulated tile with its gas (bytes).
const FLASH: u64 = 60 * 1024;
/// Flash of control and equations: the image of a real board (bytes).
const CONTROL: u64 = 40 * 1024;
/// Static RAM and the stack's bound together, of either image (bytes).
const RAM: u64 = 16 * 1024;
/// Cycles of a tick, upper end of the interval: a tenth of a millisecond.
const CYCLES: u64 = 16_800;
/// The function that is counted.
const TICK: &str = "controller_tick";
/// Sessions: without a fault, and with some that show in a motion.
const SESSIONS: [&str; 4] = [
    "identify; enable; home; move 5_mm 2_deg 0_deg; inflate 4_kPa; wait 3_s; log; status; flatten; stop",
    "enable; break motor-on; move -15_mm; log; status",
    "enable; inflate 5_kPa; break block; move 5_mm; break supply-open; wait 5_s; break none; clear; log",
    "enable; break lvdt-stuck; move -15_mm; break switch-open; wait 1_s; clear; log; flatten",
];

/// Builds, runs and judges.
///
/// # Errors
/// Status 1 with everything that is too much; status 2 where a tool is missing.
pub fn run() -> Result<(), Failure> {
    let report = measure()?;
    output::print(&report.text)?;
    if report.failures.is_empty() { Ok(()) } else { Err(Failure::Wrong(report.failures.join("\nerror: "))) }
}

/// What was measured, and what of it is too much.
#[derive(Clone, PartialEq, Eq, Debug, Default)]
pub struct Report {
    /// A line for each.
    pub text: String,
    /// What exceeds its limit.
    pub failures: Vec<String>,
}

impl Report {
    fn hold(&mut self, name: &str, value: u64, limit: u64, unit: &str) {
        let _ = writeln!(self.text, "{name:<36}{value} of {limit} {unit}");
        if value > limit {
            self.failures.push(format!("{name}: {value} {unit}, at most {limit} are allowed"));
        }
    }
}

/// Builds and runs.
///
/// # Errors
/// As [`run`], except that what is too much is in the report.
pub fn measure() -> Result<Report, Failure> {
    let program = machine::build(Kind::Emulated(STM32F405))?;
    let image = read(&program.file)?;
    let stack = image.stack().map_err(Failure::Wrong)?;
    let mut report = Report::default();
    let board = read(&board()?)?;
    let board_stack = board.stack().map_err(Failure::Wrong)?;
    for (image, stack, name) in [(&board, &board_stack, "board"), (&image, &stack, "loop")] {
        let findings = rules::findings(image, stack, &STM32F405);
        for rule in Rule::ALL {
            let broken = findings.iter().filter(|finding| finding.rule == rule).count();
            let outcome = if broken == 0 { "ok".to_owned() } else { format!("FAILED ({broken})") };
            let _ = writeln!(report.text, "{name}: check {:<23}{outcome}", rule.name());
        }
        report.failures.extend(findings.iter().map(ToString::to_string));
    }
    let ram = |image: &Image, stack: &Stack| image.size.ram + u64::from(stack.bytes);
    report.hold("board: flash", board.size.flash, CONTROL, "bytes");
    report.hold("board: static RAM and stack bound", ram(&board, &board_stack), RAM, "bytes");
    report.hold("loop: flash", image.size.flash, FLASH, "bytes");
    report.hold("loop: static RAM and stack bound", ram(&image, &stack), RAM, "bytes");

    let workspace = workspace()?;
    let folder = workspace.join("target/image");
    let plugin = {
        let _lock = lock(&folder)?;
        plugin(&toolchain::toolchain(STM32F405.target)?, &workspace, &folder)?
    };
    let (mut used, mut instructions, mut cycles, mut calls) = (0, 0, 0, 0);
    for (number, session) in SESSIONS.iter().enumerate() {
        let counts = folder.join(format!("controller-{number}.counts"));
        let option = count_option(&plugin, &counts, &image, &[TICK]);
        let machine = Machine::start(&program, 0, Some(&["-plugin", &option]))?;
        let mut bus = Bus::new(vec![machine]);
        for order in order::read(session)? {
            // With a fault some orders are refused: that is part of what is counted.
            let _ = bus.take(&order, &mut |_| Ok(()));
        }
        used = used.max(bus.depth()?);
        let (_, found) = read_counts(&counts)?;
        let tick = found.first().ok_or_else(|| Failure::Wrong(format!("no call of {TICK} was counted")))?;
        instructions = instructions.max(tick.instructions[2]);
        cycles = cycles.max(tick.most_cycles);
        calls += tick.calls;
    }
    report.hold("stack used, painted", u64::from(used), u64::from(stack.bytes), "bytes");
    let _ = writeln!(report.text, "{:<36}{calls}", "ticks counted");
    let _ = writeln!(report.text, "{:<36}{instructions} at most", "instructions of a tick");
    report.hold("cycles of a tick, by model", cycles, CYCLES, "cycles");
    Ok(report)
}
