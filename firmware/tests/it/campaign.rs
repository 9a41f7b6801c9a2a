//! Single faults on the simulated tile: each kind in each activity, at many moments.
//!
//! 500 runs by default; `SMARTBED_RUNS` sets another number, `SMARTBED_TABLE` a file for the table. Asserted of every
//! run: legs within 1 mm and 1 degree of their command, pressure below 12 kPa, forces below 150 N.
//!
//! `SMARTBED_FAULT` selects one kind by its name, `SMARTBED_CASE` one run by its number.
//!
//! `SMARTBED_RUNS=10000 SMARTBED_TABLE=docs/campaign.md cargo test -p smartbed-firmware --test it -- campaign`

use crate::wire::Wire;
use smartbed_firmware::link::message::{Command, Outcome, Target};
use smartbed_firmware::plant::{Defect, Tile};
use smartbed_firmware::tile::drive::DRIVE;
use smartbed_firmware::tile::fault::Faults;
use smartbed_firmware::tile::mode::Mode;
use smartbed_firmware::tile::motion::pose;
use std::fmt::Write;

/// A fault of the campaign: its name, what it changes when it strikes, and whether every run must find it. Exempt are:
/// an obstacle, which may not be in the way; a corrupt bus, because silence counts only during motion; NaN, which is
/// refused; a power cut, which breaks nothing.
struct Kind {
    name: &'static str,
    must_be_found: bool,
    strike: fn(&mut Wire, u32),
}

/// A fault that every run finds.
const fn kind(name: &'static str, strike: fn(&mut Wire, u32)) -> Kind {
    Kind { name, must_be_found: true, strike }
}

/// A fault that some run need not find.
const fn harmless(name: &'static str, strike: fn(&mut Wire, u32)) -> Kind {
    Kind { name, must_be_found: false, strike }
}

/// All kinds; the number of a run selects leg, side and size.
const KINDS: [Kind; 20] = [
    kind("motor stuck on", |w, n| w.set(Defect::Motor(leg(n), [1.0, -1.0, 0.5, -0.5][pick(n, 4)]))),
    kind("motor dead", |w, n| w.set(Defect::MotorDead(leg(n)))),
    kind("ENABLE does not cut", |w, _| w.set(Defect::Enable)),
    kind("supply valve open", |w, _| w.set(Defect::ValveOpen { vent: false })),
    kind("vent open", |w, _| w.set(Defect::ValveOpen { vent: true })),
    kind("supply valve shut", |w, _| w.set(Defect::ValveShut { vent: false })),
    kind("vent shut", |w, _| w.set(Defect::ValveShut { vent: true })),
    kind("encoder stuck", |w, n| w.set(Defect::EncoderStuck(leg(n)))),
    kind("encoder drifts", |w, n| w.set(Defect::EncoderDrift(leg(n), [1, -2, 5, -20][pick(n, 4)]))),
    kind("LVDT stuck", |w, n| w.set(Defect::DisplacementStuck(leg(n)))),
    kind("LVDT wire broken", |w, n| w.set(Defect::DisplacementOpen(leg(n)))),
    kind("switch open", |w, n| w.set(Defect::SwitchOpen { leg: leg(n), high: pick(n, 2) == 0 })),
    kind("pressure biased 20 %", |w, n| {
        w.set(Defect::PressureBias((n % 2) as u8, [1.2, 0.8][pick(n, 2)]));
    }),
    kind("supply low", |w, _| w.set(Defect::Supply(14.0))),
    harmless("obstruction", obstruct),
    harmless("bus corrupt", |w, _| w.corrupt = true),
    kind("clock off 2 %", |w, n| w.drift = [1, -1][pick(n, 2)]),
    harmless("NaN commanded", |w, n| w.command_nonsense(n)),
    harmless("power cut", |w, _| w.restart()),
    kind("bit flipped", |w, n| w.node.controller_mut().flip(n as usize % 320)),
];

fn leg(n: u32) -> u8 {
    (n / 7 % 3) as u8
}

fn pick(n: u32, of: usize) -> usize {
    (n / 21) as usize % of
}

fn obstruct(wire: &mut Wire, n: u32) {
    let leg = leg(n);
    let at = wire.tile.heights()[usize::from(leg)];
    let above = pick(n, 2) == 0;
    wire.set(Defect::Block { leg, height: if above { at + 2e-4 } else { at - 2e-4 }, above });
}

/// Least duration of a run after its fault (ticks), and the duration if nothing is found: in up to 1,000 runs, and in
/// more.
const SHORTEST: u32 = 4000;
const LONGEST: (u32, u32) = (8000, 30_000);

/// Commands sent one after the other if nothing has been found by then: using the broken part shows a hidden fault, or
/// shows that it does no harm.
const USES: [Command; 4] = [
    Command::Move(Target { heave: 0.004, slope_x: 0.02, slope_y: -0.015 }),
    Command::Pressure(5200.0),
    Command::Move(Target { heave: -0.004, slope_x: -0.02, slope_y: 0.015 }),
    Command::Pressure(3600.0),
];
/// Time for each (ticks).
const USE: u32 = 6000;
/// Time for a restart (ticks), whose tests look for faults that have not been found by then.
const START: u32 = 400;

/// What the tile does when the fault strikes.
const ACTIVITIES: [(&str, Option<Command>); 5] = [
    ("rest", None),
    ("tilting", Some(Command::Move(Target { heave: 0.0, slope_x: 0.015, slope_y: 0.01 }))),
    ("rising", Some(Command::Move(Target { heave: 0.005, slope_x: 0.0, slope_y: 0.0 }))),
    ("sinking", Some(Command::Move(Target { heave: -0.005, slope_x: 0.0, slope_y: 0.0 }))),
    ("inflating", Some(Command::Pressure(4600.0))),
];

/// Result of a run.
#[derive(Clone, Copy, Default)]
struct Finding {
    /// Ticks from the fault until one was latched, before or after the restart.
    detected: Option<u32>,
    /// Was it found by the tests of the next start?
    at_start: bool,
    faults: Faults,
    /// Farthest from the command (m, degrees), highest pressure (Pa), largest force of an obstacle (N).
    way: f32,
    turn: f32,
    pressure: f32,
    force: f32,
}

fn run(mut wire: Wire, kind: &Kind, activity: &Option<Command>, n: u32, longest: u32) -> Finding {
    if let Some(command) = activity {
        assert_eq!(wire.order(command), Some(Outcome::Done));
    }
    let strike = 50 + n.wrapping_mul(2_654_435_761) % 1500;
    let mut finding = Finding::default();
    let mut commanded = wire.node.controller().state().wanted;
    let used = strike + longest;
    let start = used + USE * USES.len() as u32;
    for tick in 0..start + START {
        let seen = finding.detected.map_or(SHORTEST, |after| SHORTEST.max(after + 1000));
        if tick >= strike + seen && finding.detected.is_some() {
            break;
        }
        if let Some(place) = tick.checked_sub(used).filter(|after| tick < start && after.is_multiple_of(USE))
        {
            // A tile that is off refuses them.
            let body = wire.peer.command(&USES[(place / USE) as usize], wire.now, 0);
            body.iter().for_each(|body| wire.send(body));
        }
        if tick == strike {
            (kind.strike)(&mut wire, n);
        }
        if tick == start {
            wire.restart();
        }
        wire.tick();
        let controller = wire.node.controller();
        if matches!(controller.mode(), Mode::Moving | Mode::Retreat) {
            commanded = controller.state().wanted;
        }
        if finding.detected.is_none() && !controller.latched().is_empty() {
            finding.detected = Some(tick.saturating_sub(strike));
            finding.at_start = tick >= start;
        }
        finding.faults = controller.latched();
        let heights = wire.tile.heights();
        let (is, was) = (pose(heights), pose(commanded));
        let turn = ((is.tx - was.tx).powi(2) + (is.ty - was.ty).powi(2)).sqrt().atan().to_degrees();
        finding.turn = finding.turn.max(turn);
        for (height, commanded) in heights.iter().zip(commanded) {
            finding.way = finding.way.max((height - commanded).abs());
        }
        finding.pressure = finding.pressure.max(wire.tile.air.pressure());
        finding.force = wire.tile.contacts().iter().fold(finding.force, |most, f| most.max(f.abs()));
    }
    finding
}

/// A tile that is homed and level at middle height, with a patient off its middle and 4 kPa in the bladder.
fn prepared() -> Wire {
    let tile = Tile::loaded(25.0, [0.02, 0.0], [-0.027; 3], DRIVE).expect("a start");
    let mut wire = Wire::with(tile);
    wire.tile.air.fill(4000.0);
    wire.run(400);
    assert_eq!(wire.order(&Command::Enable), Some(Outcome::Done));
    assert_eq!(wire.order(&Command::Home), Some(Outcome::Done));
    wire.run(12_000);
    assert_eq!(wire.mode(), Mode::Ready);
    assert_eq!(wire.order(&Command::Pressure(4000.0)), Some(Outcome::Done));
    assert_eq!(wire.order(&Command::Move(Target::default())), Some(Outcome::Done));
    wire.run(12_000);
    assert_eq!(wire.mode(), Mode::Ready);
    wire
}

#[test]
fn no_single_fault_leaves_the_limits() {
    let runs = std::env::var("SMARTBED_RUNS").map_or(500, |n| n.parse::<u32>().expect("a number"));
    let wire = prepared();
    let mut rows = String::new();
    let strata = (KINDS.len() * ACTIVITIES.len()) as u32;
    let wanted = std::env::var("SMARTBED_FAULT").ok();
    let is_wanted = |name: &str| wanted.as_ref().is_none_or(|wanted| wanted == name);
    let case = std::env::var("SMARTBED_CASE").ok().map(|n| n.parse::<u32>().expect("a number"));
    for (kind, fault) in KINDS.iter().enumerate().filter(|(_, kind)| is_wanted(kind.name)) {
        let (mut worst, mut latest, mut total) = (Finding::default(), 0, 0);
        let (mut seen, mut used, mut started) = (0, 0, 0);
        for (doing, (name, activity)) in ACTIVITIES.iter().enumerate() {
            let stratum = (kind * ACTIVITIES.len() + doing) as u32;
            for repeat in 0..runs.div_ceil(strata) {
                let n = repeat.wrapping_mul(strata).wrapping_add(stratum).wrapping_mul(31);
                if case.is_some_and(|case| case != n) {
                    continue;
                }
                let longest = if runs > 1000 { LONGEST.1 } else { LONGEST.0 };
                let found = run(wire.clone(), fault, activity, n, longest);
                let is_within =
                    found.way < 1e-3 && found.turn < 1.0 && found.pressure < 12e3 && found.force < 150.0;
                assert!(
                    is_within,
                    "{} while {name} ({n}): {} m, {} deg, {} Pa, {} N, {:?}",
                    fault.name,
                    found.way,
                    found.turn,
                    found.pressure,
                    found.force,
                    names(found.faults)
                );
                let is_found = found.detected.is_some() || !fault.must_be_found;
                assert!(is_found, "{} while {name} ({n}) is never found", fault.name);
                total += 1;
                match found.detected {
                    Some(_) if found.at_start => started += 1,
                    Some(ticks) if ticks < longest => {
                        seen += 1;
                        latest = latest.max(ticks);
                    }
                    Some(_) => used += 1,
                    None => (),
                }
                worst.faults = worst.faults.with(found.faults);
                worst.way = worst.way.max(found.way);
                worst.turn = worst.turn.max(found.turn);
                worst.pressure = worst.pressure.max(found.pressure);
                worst.force = worst.force.max(found.force);
            }
        }
        let _ = writeln!(
            rows,
            "| {} | {total} | {seen} | {used} | {started} | {latest} | {:.3} | {:.3} | {:.2} | {:.0} | {} |",
            fault.name,
            worst.way * 1e3,
            worst.turn,
            worst.pressure * 1e-3,
            worst.force,
            names(worst.faults)
        );
    }
    if let Ok(file) = std::env::var("SMARTBED_TABLE") {
        let file = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("..").join(file);
        std::fs::write(file, HEAD.replace("RUNS=n", &format!("RUNS={runs}")) + &rows)
            .expect("the table is written");
    }
    println!("{rows}");
}

const HEAD: &str = "\
# Single faults on the simulated tile

Written by `SMARTBED_RUNS=n SMARTBED_TABLE=docs/campaign.md cargo test -p smartbed-firmware --test it -- campaign`; the test makes
500 of these runs by default. A patient of 25 kg lies on the tile, which is homed, at 4 kPa. Each fault strikes at rest and while the tile tilts, rises, sinks and inflates, at varying
moments and on varying legs. A run ends 4 s after the fault, or 1 s after its detection if that is later; without detection it goes on for 30 s. A fault that has not shown by then (a broken drive while ENABLE is off, a sensor
stuck at the right value while nothing moves) is exposed by use (column *in use*): the tile is tilted, inflated, tilted back and vented, for 24 s more. A fault that this does not find either must be
found by the tests of a new start (column *at a start*). The test fails if a fault is never found, except for: an obstacle that is not in the way, a corrupt bus while
nothing moves, commands that contain NaN (refused, answered, logged), and a power cut, which breaks nothing; all of these must do no harm. Limits of every run, with or without
detection, from the first tick to the last: 1 mm, 1 degree, 12 kPa, 150 N.

| fault | runs | found | in use | at a start | latest, not in use (ms) | farthest (mm) | most turn (deg) | pressure (kPa) | force (N) | found as |
|---|---|---|---|---|---|---|---|---|---|---|
";

fn names(faults: Faults) -> String {
    let names: Vec<&str> = faults.names().collect();
    names.join(", ")
}
