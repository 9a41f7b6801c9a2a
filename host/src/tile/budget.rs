//! Measures the cost of the controller on each core and compares it with its limits.
//!
//! In: nothing. Out: flash, RAM, stack by analysis and as used, instructions of a tick and of the check of a tag in it,
//! on the board's core also cycles, and a failure for each limit that is exceeded; for RISC-V only what the image
//! shows. A nominal session and sessions with faults are run in the emulator with the counting plug-in; the largest
//! values of all count.

use super::bus::Bus;
use super::machine::{self, Kind, Machine, Program};
use super::order;
use crate::failure::Failure;
use crate::firmware::arguments::Bus as Wires;
use crate::firmware::chip::{Chip, M7, M33, RV32, STM32F405};
use crate::firmware::emulator::{count_option, plugin, read_counts};
use crate::firmware::image::Image;
use crate::firmware::image::rules::{self, Rule};
use crate::firmware::workspace::{lock, workspace};
use crate::firmware::{bare, board, toolchain};
use crate::output;
use std::fmt::Write;

/// Flash of control and equations: the image of a real board (bytes).
const CONTROL: u64 = 40 * 1024;
/// Flash of the loop's image: the board's without its drivers, plus the simulated tile with its gas (bytes).
const LOOP: u64 = 60 * 1024;
/// Static RAM plus the stack's bound, of any image (bytes).
const RAM: u64 = 16 * 1024;
/// Instructions of a tick on any core.
const INSTRUCTIONS: u64 = 9500;
/// Cycles of a tick on the board's core, upper end of the interval: a tenth of a millisecond.
const CYCLES: u64 = 16_800;
/// Instructions for the check of a tag on any core. A tick takes one message, so it checks at most one tag, which its
/// own figures include.
const TAG_INSTRUCTIONS: u64 = 700;
/// Cycles for the same on the board's core.
const TAG_CYCLES: u64 = 1000;
/// The functions counted: a tick, and the check of a tag.
const COUNTED: [&str; 2] = ["controller_tick", "<smartbed_firmware::link::tag::Key>::vouches"];
/// Sessions: one without a fault, and some with faults that show in a motion.
const SESSIONS: [&str; 4] = [
    "identify; enable; home; move 5_mm 2_deg 0_deg; inflate 4_kPa; wait 3_s; log; status; flatten; stop",
    "enable; break motor-on; move -15_mm; log; status",
    "enable; inflate 5_kPa; break block; move 5_mm; break supply-open; wait 5_s; break none; clear; log",
    "enable; break lvdt-stuck; move -15_mm; break switch-open; wait 1_s; clear; log; flatten",
];

/// Builds, runs and compares with the limits.
///
/// # Errors
/// Status 1 with every limit that is exceeded; status 2 if a tool is missing.
pub fn run() -> Result<(), Failure> {
    let report = measure()?;
    output::print(&report.text)?;
    if report.failures.is_empty() { Ok(()) } else { Err(Failure::Wrong(report.failures.join("\nerror: "))) }
}

/// The measurements, and the limits that they exceed.
#[derive(Clone, PartialEq, Eq, Debug, Default)]
pub struct Report {
    /// One line per measurement.
    pub text: String,
    /// Limits that are exceeded.
    pub failures: Vec<String>,
}

impl Report {
    fn hold(&mut self, name: &str, value: u64, limit: u64, unit: &str) {
        let _ = writeln!(self.text, "{name:<40}{value} of {limit} {unit}");
        if value > limit {
            self.failures.push(format!("{name}: {value} {unit}, at most {limit} are allowed"));
        }
    }

    /// Checks an image's rules and limits; returns the bound of its stack.
    fn judge(&mut self, name: &str, image: &Image, chip: &Chip, flash: u64) -> Result<u64, Failure> {
        let stack = image.stack().map_err(Failure::Wrong)?;
        let findings = rules::findings(image, &stack, chip);
        let broken: Vec<&str> =
            Rule::ALL.into_iter().filter(|r| findings.iter().any(|f| f.rule == *r)).map(Rule::name).collect();
        let outcome =
            if broken.is_empty() { "kept".to_owned() } else { format!("FAILED: {}", broken.join(", ")) };
        let _ = writeln!(self.text, "{:<40}{outcome}", format!("{name}: {} rules", Rule::ALL.len()));
        self.failures.extend(findings.iter().map(|finding| format!("{name}: {finding}")));
        self.hold(&format!("{name}: flash"), image.size.flash, flash, "bytes");
        let stack = u64::from(stack.bytes);
        self.hold(&format!("{name}: static RAM and stack bound"), image.size.ram + stack, RAM, "bytes");
        Ok(stack)
    }
}

/// Builds and runs.
///
/// # Errors
/// As [`run`], except that exceeded limits are in the report.
pub fn measure() -> Result<Report, Failure> {
    let mut report = Report::default();
    for (bus, name) in [(Wires::Serial, "board"), (Wires::Can, "board on CAN")] {
        report.judge(name, &Image::open(&board(bus)?)?, &STM32F405, CONTROL)?;
    }
    report.judge(&format!("controller on {}", RV32.short), &Image::open(&bare(&RV32)?)?, &RV32, CONTROL)?;
    for chip in [STM32F405, M7, M33] {
        let name = format!("loop on {}", chip.short);
        let program = machine::build(Kind::Emulated(chip))?;
        let image = Image::open(&program.file)?;
        let bound = report.judge(&name, &image, &chip, LOOP)?;
        let used = sessions(&program, &image)?;
        report.hold(&format!("{name}: stack used, painted"), used.stack, bound, "bytes");
        let kinds =
            [("a tick", "ticks", INSTRUCTIONS, CYCLES), ("a tag", "tags", TAG_INSTRUCTIONS, TAG_CYCLES)];
        for ((one, many, instructions, cycles), calls) in kinds.into_iter().zip(used.calls) {
            let _ = writeln!(report.text, "{:<40}{}", format!("{name}: {many} counted"), calls.count);
            report.hold(&format!("{name}: {one}"), calls.instructions, instructions, "instructions");
            if chip == STM32F405 {
                report.hold(&format!("{name}: {one}, by model"), calls.cycles, cycles, "cycles");
            }
        }
    }
    Ok(report)
}

/// The largest values of all sessions.
#[derive(Clone, Copy, Default)]
struct Used {
    stack: u64,
    /// Of each of [`COUNTED`].
    calls: [Calls; 2],
}

/// Calls of a function: their number, and the largest cost of one.
#[derive(Clone, Copy, Default)]
struct Calls {
    count: u64,
    instructions: u64,
    cycles: u64,
}

/// Runs all sessions with the counting plug-in.
fn sessions(program: &Program, image: &Image) -> Result<Used, Failure> {
    let workspace = workspace()?;
    let folder = workspace.join("target/image");
    let plugin = {
        let _lock = lock(&folder)?;
        plugin(&toolchain::toolchain(STM32F405.target)?, &workspace, &folder)?
    };
    let mut used = Used::default();
    for (number, session) in SESSIONS.iter().enumerate() {
        let counts = folder.join(format!("controller-{number}.counts"));
        let option = count_option(&plugin, &counts, image, &COUNTED);
        let machine = Machine::start(program, 0, Some(&["-plugin", &option]))?;
        let mut bus = Bus::new(vec![machine]);
        for order in order::read(session)? {
            // Faults make the controller refuse some orders, which is part of what is measured.
            let _ = bus.take(&order, &mut |_| Ok(()));
        }
        used.stack = used.stack.max(bus.depth()?.into());
        let (_, found) = read_counts(&counts)?;
        for (name, calls) in COUNTED.into_iter().zip(&mut used.calls) {
            let one = found.iter().find(|one| one.name == name);
            let one = one.filter(|one| one.calls > 0);
            let one = one.ok_or_else(|| Failure::Wrong(format!("no call of {name} was counted")))?;
            calls.instructions = calls.instructions.max(one.instructions[2]);
            calls.cycles = calls.cycles.max(one.most_cycles);
            calls.count += one.calls;
        }
    }
    Ok(used)
}
