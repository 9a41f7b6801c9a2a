//! `smartbed tile`: the controller in the emulator and on this machine.
//!
//! If toolchain or emulator are missing these tests fail, they are not skipped; the message names the command that
//! installs them.

use crate::support::smartbed;
use object::{Object, ObjectSection, ObjectSymbol};
use smartbed::firmware::chip::{M7, M33, STM32F405};
use smartbed::tile::bus::{Bus, Received};
use smartbed::tile::machine::{Kind, Machine, Program, build};
use smartbed::tile::{budget, order};
use smartbed_firmware::link::message::Report;
use smartbed_firmware::tile::fault::Fault;
use smartbed_firmware::tile::mode::Mode;
use smartbed_firmware::turns::FAULT;
use std::fs;

/// Ticks of a session.
const TICKS: u32 = 100_000;

/// Every byte that a tile sends in a session, and its last state.
fn session(kind: Kind) -> (Vec<u8>, Option<Report>) {
    let program = &build(kind).unwrap_or_else(|e| panic!("{e}"));
    let machine = Machine::start(program, 0, None).unwrap_or_else(|e| panic!("{e}"));
    let mut bus = Bus::new(vec![machine]);
    let (mut ticks, mut last) = (0, None);
    let mut listen = |received: Received| {
        ticks = received.time;
        if matches!(received.report, Report::State(_)) {
            last = Some(received.report);
        }
        Ok(())
    };
    let orders = "identify; enable; home; move 4_mm 2_deg -1_deg; inflate 3.5_kPa; log; move -2_mm; break encoder-stuck";
    for order in order::read(orders).expect("orders") {
        bus.take(&order, &mut listen).unwrap_or_else(|e| panic!("{order:?}: {e}"));
    }
    // The encoder that is stuck shows itself, and the rest of the time passes in OFF.
    let refused = order::read("move 5_mm").expect("an order");
    bus.take(&refused[0], &mut listen).unwrap_or_else(|e| panic!("{e}"));
    bus.run(TICKS.saturating_sub(bus.now()), &mut listen).unwrap_or_else(|e| panic!("{e}"));
    let heard = std::mem::take(&mut bus.heard);
    bus.end().unwrap_or_else(|e| panic!("{e}"));
    assert!(ticks > TICKS - 1000);
    assert!(heard.len() > 50_000, "{} bytes", heard.len());
    (heard, last)
}

#[test]
fn chip_and_host_send_the_same_bytes() {
    let here = session(Kind::Native);
    for chip in [STM32F405, M33, M7] {
        let there = session(Kind::Emulated(chip));
        assert!(there.0 == here.0, "{}: the bytes differ: {:?} {:?}", chip.name, there.1, here.1);
    }
}

#[test]
fn the_controller_keeps_to_its_budget() {
    let report = budget::measure().unwrap_or_else(|e| panic!("{e}"));
    println!("{}", report.text);
    assert!(report.failures.is_empty(), "{}\n{}", report.failures.join("\n"), report.text);
}

#[test]
fn the_verdict_on_an_image_is_what_the_schema_says() {
    let program = build(Kind::Emulated(STM32F405)).unwrap_or_else(|e| panic!("{e}"));
    let done = smartbed(&["firmware", "--elf", &program.file.display().to_string(), "--json"]);
    crate::schema::holds("image", &done.json());
}

/// After an undefined instruction the first thing that is written to a port is ENABLE's line, low.
#[test]
fn a_hard_fault_turns_the_drives_off_first() {
    let program = build(Kind::Emulated(STM32F405)).unwrap_or_else(|e| panic!("{e}"));
    let log = std::env::temp_dir().join(format!("smartbed-fault-{}", std::process::id()));
    let options = ["-d", "unimp", "-D", log.to_str().expect("a path")];
    let mut machine = Machine::start(&program, 0, Some(&options)).unwrap_or_else(|e| panic!("{e}"));
    machine.turn(&[], 100).unwrap_or_else(|e| panic!("{e}"));
    machine.signal(FAULT).unwrap_or_else(|e| panic!("{e}"));
    let status = machine.wait().unwrap_or_else(|e| panic!("{e}"));
    assert!(!status.success());
    let text = fs::read_to_string(&log).expect("the emulator's log");
    let first = text.lines().find(|line| line.contains("GPIO") && line.contains("write"));
    assert!(first.is_some_and(|l| l.contains("offset 0x018") && l.contains("0x00200000")), "{text}");
    let _ = fs::remove_file(&log);
}

/// A byte of the image that changed while the power was off is found before the first tick and reported: here in the
/// handler of hard faults, which only a fault executes, and in the vector of the last interrupt, which is unused.
#[test]
fn an_image_with_a_changed_byte_moves_nothing_and_says_why() {
    let program = build(Kind::Emulated(STM32F405)).unwrap_or_else(|e| panic!("{e}"));
    let image = fs::read(&program.file).expect("an image");
    let mut elf = image.clone();
    let file = object::File::parse(&*image).expect("an ELF file");
    let handler = file.symbols().find(|s| s.name() == Ok("HardFault")).expect("a handler").address() & !1;
    let code = file.sections().find(|s| (s.address()..s.address() + s.size()).contains(&handler));
    let (offset, _) = code.as_ref().and_then(|s| s.file_range()).expect("code");
    let handler = (offset + handler - code.expect("code").address()) as usize;
    let (offset, length) =
        file.section_by_name(".vector_table").and_then(|s| s.file_range()).expect("vectors");
    let vector = (offset + length) as usize - 4;
    let orders = |elf: &[u8]| {
        let file = std::env::temp_dir().join(format!("smartbed-changed-{}", std::process::id()));
        fs::write(&file, elf).expect("an image");
        let machine = Machine::start(&Program { file: file.clone(), ..program.clone() }, 0, None);
        let mut bus = Bus::new(vec![machine.unwrap_or_else(|e| panic!("{e}"))]);
        let mut last = None;
        let mut listen = |received: Received| {
            if let Report::State(state) = received.report {
                last = Some(state);
            }
            Ok(())
        };
        let orders = order::read("status; enable; move 5_mm").expect("orders");
        let done = orders.iter().try_for_each(|order| bus.take(order, &mut listen));
        let _ = fs::remove_file(&file);
        (done, last.expect("a state"))
    };
    let (done, state) = orders(&elf);
    assert!(done.is_ok() && state.faults == 0, "{done:?} {state:?}");
    for place in [handler, vector] {
        elf[place] ^= 0x10;
        let (done, state) = orders(&elf);
        assert!(done.is_err_and(|why| why.to_string().contains("a fault is latched")));
        // Drives and valves are off, motion is not allowed, and nothing but the program is wrong.
        assert_eq!((state.faults, state.flags), (1 << Fault::Program as u32, 0));
        assert_eq!(state.mode, Mode::Off as u8);
        elf[place] ^= 0x10;
    }
}

#[test]
fn a_session_is_told_in_words() {
    let orders = "enable; move 0_mm; tile 1; identify; status; tile 0; status; log";
    let done = smartbed(&["tile", "--native", "--tiles", "2", orders]);
    assert_eq!(done.status, 0, "{done:?}");
    let out = done.out;
    for expected in
        ["screws hold their load", "tile 0  unhomed: heave -0.0", "tile 1  unhomed: heave -20.0", "log 3 at"]
    {
        assert!(out.contains(expected), "`{expected}` is not in\n{out}");
    }
}

#[test]
fn several_emulators_share_a_bus_and_heights_are_drawn() {
    let orders = "enable; move -15_mm; status; tile 1; status";
    let done = smartbed(&["tile", "--tiles", "3", "--plot", orders]);
    assert_eq!(done.status, 0, "{done:?}");
    let drawn = done.out.lines().filter(|line| line.contains("tile 0  |") && line.contains("| ")).count();
    assert!(drawn >= 20, "ten lines a second while it moves: {drawn}\n{}", done.out);
    for expected in ["tile 0  unhomed: heave -15.0", "tile 1  unhomed: heave -20.0"] {
        assert!(done.out.contains(expected), "`{expected}` is not in\n{}", done.out);
    }
}

#[test]
fn what_is_refused_says_why_and_what_to_do() {
    for (orders, expected) in [
        ("move 5_mm", "`move` is refused: it is not allowed in this mode: `enable` first"),
        ("enable; move 35_mm", "`move` is refused: a height would leave the stroke"),
        ("fly", "expected enable, home, move"),
    ] {
        let done = smartbed(&["tile", "--native", orders]);
        assert!(done.status == 1 && done.err.contains(expected), "{done:?}");
    }
}

#[test]
fn a_motion_that_is_not_waited_for_can_be_stopped() {
    let done =
        smartbed(&["tile", "--native", "enable; move 10_mm &; wait 1_s; status; stop; wait 200_ms; status"]);
    assert_eq!(done.status, 0, "{done:?}");
    assert!(done.out.contains("moving: heave") && done.out.contains("hold: heave -1"), "{done:?}");
}

/// As when `stop` is typed on a terminal: `Typed` says so (its own test), and the bus ends the motion that it waits
/// for.
#[test]
fn a_motion_that_is_waited_for_ends_when_stop_is_typed() {
    let program = build(Kind::Native).unwrap_or_else(|e| panic!("{e}"));
    let mut bus = Bus::new(vec![Machine::start(&program, 0, None).unwrap_or_else(|e| panic!("{e}"))]);
    let mut last = None;
    let mut listen = |received: Received| {
        if let Report::State(state) = received.report {
            last = Some(state);
        }
        Ok(())
    };
    let (mut asked, mut moves) = (0, 0);
    for order in order::read("enable; move 10_mm; status").expect("orders") {
        let start = bus.now();
        let mut interrupt = || {
            asked += 1;
            Ok(asked == 20)
        };
        bus.take_until(&order, &mut listen, &mut interrupt).unwrap_or_else(|e| panic!("{order:?}: {e}"));
        moves = moves.max(bus.now() - start);
    }
    // The way of 30 mm takes 20 s at half speed.
    assert!(moves < 3000, "{moves} ms");
    let state = last.expect("a state");
    assert_eq!((state.mode, state.flags & 1, state.faults), (Mode::Hold as u8, 0, 0));
    assert!(state.heights.iter().all(|height| (-0.0199..0.0).contains(height)), "{state:?}");
}

#[test]
fn json_is_what_the_schema_says() {
    let done =
        smartbed(&["tile", "--native", "--json", "identify; enable; move -19_mm; inflate 99_kPa; log"]);
    // The pressure is refused, in an answer too.
    assert_eq!(done.status, 1, "{done:?}");
    let mut kinds = std::collections::BTreeSet::new();
    for line in done.out.lines() {
        let value: serde_json::Value = serde_json::from_str(line).expect("JSON");
        crate::schema::holds("tile", &value);
        kinds.insert(value["kind"].as_str().expect("a kind").to_owned());
    }
    assert_eq!(kinds.into_iter().collect::<Vec<_>>(), ["answer", "identity", "start", "state"]);
}
