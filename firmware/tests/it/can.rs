//! Tiles and their supervisor on one simulated CAN bus: frames lost, a controller off the bus, a stop.

use crate::bxcan::Chip;
use crate::can_bus::{Carrier, OnBus, Pin, RATE};
use crate::wire::KEY;
use smartbed_firmware::link::bus::{Arrival, Bus};
use smartbed_firmware::link::bxcan::Bxcan;
use smartbed_firmware::link::can::{Classic, End, FRAMES, REST, STOP, frame};
use smartbed_firmware::link::frame::Body;
use smartbed_firmware::link::hub::Hub;
use smartbed_firmware::link::message::{Command, Outcome, Report, Target, read};
use smartbed_firmware::link::tag::Key;
use smartbed_firmware::link::talk::{REPORTS, Talk};
use smartbed_firmware::node::Node;
use smartbed_firmware::plant::Tile;
use smartbed_firmware::plant::flash::{Flash, provided};
use smartbed_firmware::station::Station;
use smartbed_firmware::supervisor::{self, Denied, MOST_MOVING, Peer};
use smartbed_firmware::tile::board::Sensors;
use smartbed_firmware::tile::drive::DRIVE;
use smartbed_firmware::tile::fault::Fault;
use smartbed_firmware::tile::integrity::Program;
use smartbed_firmware::tile::mode::Mode;
use std::collections::VecDeque;

/// Number of the first tile.
const FIRST: u8 = 3;
/// Tiles in a row of the bed.
const COLUMNS: usize = 4;

/// A tile with its end of the bus.
struct Board {
    tile: Tile,
    station: Station<Flash, End<Bxcan<Chip>>>,
    pin: Chip,
}

impl Board {
    fn new(number: u8) -> Self {
        let pin = Chip::default();
        let node = Node::new(number, provided(KEY), 0);
        let tile = Tile::loaded(20.0, [0.0; 2], [0.0; 3], DRIVE).expect("a start");
        let end = End::of_tile(Bxcan::of_tile(pin.clone(), number), number);
        Self { tile, station: Station::new(node, end, Program::default(), 0), pin }
    }
}

/// Tiles, and a supervisor with one controller for all of them.
struct Bed<'a> {
    boards: Vec<Board>,
    peers: Vec<Peer>,
    hub: Hub<'a, Pin>,
    /// The hub's controller.
    pin: Pin,
    /// Bodies waiting for each tile, and the reports of each.
    out: Vec<VecDeque<Body>>,
    reports: Vec<Vec<Report>>,
    carrier: Carrier,
    now: u32,
}

/// The supervisor's talks with so many tiles.
fn talks(tiles: u8) -> Vec<Talk> {
    (FIRST..FIRST + tiles).map(Talk::of_supervisor).collect()
}

impl<'a> Bed<'a> {
    /// Started, known, and all may move.
    fn ready(talks: &'a mut [Talk]) -> Self {
        let (count, pin) = (talks.len(), Pin::default());
        let numbers = || (FIRST..).take(count);
        let mut bed = Self {
            boards: numbers().map(Board::new).collect(),
            peers: numbers().map(|number| Peer::new(number, Key::new(KEY))).collect(),
            hub: Hub::new(pin.clone(), talks),
            pin,
            out: vec![VecDeque::new(); count],
            reports: vec![Vec::new(); count],
            carrier: Carrier::default(),
            now: 50_000,
        };
        bed.run(700);
        for place in 0..count {
            assert_eq!(bed.order(place, &Command::Enable), Some(Outcome::Done), "{place}");
        }
        bed
    }

    fn tick(&mut self) {
        let Self { peers, hub, out, reports, now, .. } = self;
        hub.receive(*now, |place, arrival| match arrival {
            Arrival::Body(body) => reports[place].extend(peers[place].take(&body, *now)),
            Arrival::Stop => out[place].clear(),
        });
        hub.transmit(*now, |place| out[place].pop_front().or_else(|| peers[place].beat(*now)));
        let tiles = self.boards.iter().map(|board| &board.pin as &dyn OnBus);
        let pins: Vec<&dyn OnBus> = tiles.chain([&self.pin as &dyn OnBus]).collect();
        self.carrier.carry(&pins);
        for Board { tile, station, .. } in &mut self.boards {
            let outputs = station.tick(&tile.read(), Program::default());
            tile.advance(&outputs).expect("a step");
        }
        self.now += 1;
    }

    fn run(&mut self, ticks: u32) {
        (0..ticks).for_each(|_| self.tick());
    }

    /// Sends a command and waits for its outcome.
    fn order(&mut self, place: usize, command: &Command) -> Option<Outcome> {
        let body = self.peers[place].command(command, self.now, 0)?;
        let sequence = match read(&body) {
            Ok(received) => received.header.sequence,
            Err((header, _)) => header.sequence,
        };
        self.reports[place].clear();
        self.out[place].push_back(body);
        self.run(250);
        self.reports[place].iter().find_map(|report| match report {
            Report::Answer(to, outcome) if *to == sequence => Some(*outcome),
            _ => None,
        })
    }

    fn mode(&self, place: usize) -> Mode {
        self.boards[place].station.node().controller().mode()
    }

    fn modes(&self) -> Vec<Mode> {
        (0..self.boards.len()).map(|place| self.mode(place)).collect()
    }

    fn has(&self, place: usize, fault: Fault) -> bool {
        self.boards[place].station.node().controller().latched().has(fault)
    }
}

const UP: Command = Command::Move(Target { heave: 0.004, slope_x: 0.0, slope_y: 0.0 });

/// Sixteen tiles in four rows, eight of which may move at once.
#[test]
fn a_supervisor_moves_sixteen_tiles_over_one_controller() {
    let mut talks = talks(16);
    let mut bed = Bed::ready(&mut talks);
    let Command::Move(target) = UP else { panic!("a motion") };
    for place in 0..MOST_MOVING {
        let mut all = supervisor::Bed { peers: &mut bed.peers, columns: COLUMNS };
        let body = all.order(place, target, bed.now, 0).expect("it may move");
        bed.out[place].push_back(body);
    }
    bed.run(250);
    let moving = (0..16).filter(|place| bed.mode(*place) == Mode::Moving).count();
    assert_eq!(moving, MOST_MOVING);
    let mut all = supervisor::Bed { peers: &mut bed.peers, columns: COLUMNS };
    assert_eq!(all.order(9, target, bed.now, 0), Err(Denied::Power));
    bed.run(4000);
    for (place, Board { tile, station, pin }) in bed.boards.iter().enumerate() {
        let expected = if place < MOST_MOVING { 0.004 } else { 0.0 };
        assert!(tile.heights().iter().all(|height| (height - expected).abs() < 3e-4), "{place}");
        // It has begun once.
        assert_eq!((station.bus.lost(), pin.0.borrow().restarts), (0, 1));
        assert!(station.node().controller().latched().is_empty());
    }
    assert!(bed.peers.iter().all(|peer| peer.state().is_some()));
    assert_eq!(bed.hub.lost(), 0);
    let ticks = bed.now - 50_000;
    let Carrier { carried, busiest, .. } = bed.carrier;
    println!("16 tiles: {carried} frames in {ticks} ms, {busiest} in a millisecond at most");
}

#[test]
fn one_frame_stops_all_and_nothing_that_came_before_moves_them() {
    let mut talks = talks(2);
    let mut bed = Bed::ready(&mut talks);
    for place in 0..2 {
        assert_eq!(bed.order(place, &UP), Some(Outcome::Done));
    }
    assert_eq!(bed.modes(), [Mode::Moving; 2]);
    // Orders for later, which the stop drops.
    for place in 0..2 {
        let again = bed.peers[place].command(&UP, bed.now, 300).expect("it fits");
        bed.out[place].push_back(again);
    }
    bed.run(100);
    assert!(bed.hub.stop(&[]));
    bed.run(2);
    assert_eq!(bed.modes(), [Mode::Hold; 2]);
    bed.run(1000);
    assert_eq!(bed.modes(), [Mode::Hold; 2]);
    // A stop for one of them leaves the other alone; more numbers than a frame holds are refused.
    for place in 0..2 {
        assert_eq!(bed.order(place, &Command::Enable), Some(Outcome::Done));
    }
    assert!(bed.hub.stop(&[FIRST + 1]) && !bed.hub.stop(&[9; 9]));
    bed.run(3);
    assert_eq!(bed.modes(), [Mode::Unhomed, Mode::Hold]);
    // A second stop before the first is out never stops less.
    assert_eq!(bed.order(1, &Command::Enable), Some(Outcome::Done));
    assert!(bed.hub.stop(&[FIRST]) && bed.hub.stop(&[FIRST + 1]));
    bed.run(3);
    assert_eq!(bed.modes(), [Mode::Hold; 2]);
}

/// Commands signed before a stop, by us or by somebody else, that are still with the supervisor or half-way to the
/// tile.
#[test]
fn what_is_under_way_when_a_stop_comes_is_not_carried_out() {
    for (is_ours, delay) in [true, false].into_iter().flat_map(|ours| (0..8).map(move |delay| (ours, delay)))
    {
        let mut talks = talks(2);
        let mut bed = Bed::ready(&mut talks);
        assert_eq!(bed.order(0, &UP), Some(Outcome::Done));
        assert!(bed.hub.stop(&[]));
        bed.run(100);
        assert_eq!(bed.mode(0), Mode::Hold);
        for command in [Command::Enable, UP] {
            let body = bed.peers[0].command(&command, bed.now, 0).expect("it fits");
            bed.out[0].push_back(body);
        }
        bed.run(delay);
        let is_allowed = bed.mode(0) != Mode::Hold;
        if is_ours {
            assert!(bed.hub.stop(&[]));
            bed.out[0].clear();
        } else {
            let stop = frame::<Classic>(STOP, &[FIRST]).expect("a frame");
            bed.boards[0].pin.hear(&stop);
            bed.pin.hear(&stop);
        }
        bed.run(300);
        assert_eq!(bed.mode(0), Mode::Hold, "ours {is_ours}, after {delay} ms, allowed before {is_allowed}");
        assert!(bed.order(1, &Command::Enable) == Some(Outcome::Done), "the other one is reached");
        assert_eq!(bed.order(0, &Command::Enable), Some(Outcome::Done), "and so is this one");
    }
}

#[test]
fn lost_frames_cost_their_message_alone() {
    let mut talks = talks(4);
    let mut bed = Bed::ready(&mut talks);
    bed.carrier.lossy = 53;
    // A frame lost costs an order or its answer; a later one finds its way.
    let done = (0..40).filter(|n| bed.order(n % 4, &Command::Enable) == Some(Outcome::Done)).count();
    bed.carrier.lossy = 0;
    let lost = bed.boards.iter().map(|b| b.station.bus.lost()).sum::<u32>() + bed.hub.lost();
    println!("{done} orders of 40 done, {lost} messages lost");
    assert!(lost > 5 && done > 20, "{lost} lost, {done} done");
    bed.run(200);
    for place in 0..4 {
        let outcome = bed.order(place, &Command::Enable);
        assert_eq!(outcome, Some(Outcome::Done), "a whole message gets through at once");
    }
}

/// Off the bus: nothing is sent, motion ends by silence, the controller comes back each [`REST`] at most, and the other
/// tiles of the bus are moved on.
#[test]
fn a_tile_off_the_bus_leaves_the_others_alone_and_comes_back() {
    let mut talks = talks(4);
    let mut bed = Bed::ready(&mut talks);
    for place in [0, 2] {
        assert_eq!(bed.order(place, &UP), Some(Outcome::Done));
    }
    let pin = bed.boards[0].pin.clone();
    let start = bed.now;
    for _ in 0..1000 {
        // It finds errors again as soon as it is back.
        pin.0.borrow_mut().is_off = true;
        bed.tick();
    }
    let restarts = pin.0.borrow().restarts - 1;
    assert!((5..=(bed.now - start) / REST + 1).contains(&restarts), "{restarts}");
    assert!(bed.has(0, Fault::Silence));
    assert_eq!(bed.modes(), [Mode::Hold, Mode::Unhomed, Mode::Moving, Mode::Unhomed]);
    pin.0.borrow_mut().is_off = true;
    assert_eq!(bed.order(1, &UP), Some(Outcome::Done), "another tile is ordered about meanwhile");
    // Mended, it comes back by itself.
    bed.run(2 * REST + 200);
    assert!(!pin.0.borrow().is_off);
    assert_eq!(bed.order(0, &Command::Clear(1 << Fault::Silence as u32)), Some(Outcome::Done));
    assert_eq!(bed.order(0, &Command::Enable), Some(Outcome::Done));
}

/// The supervisor's own controller is off the bus: moving tiles hold, and operation continues when it is back.
#[test]
fn a_supervisor_off_the_bus_is_silence() {
    let mut talks = talks(2);
    let mut bed = Bed::ready(&mut talks);
    assert_eq!(bed.order(1, &UP), Some(Outcome::Done));
    for _ in 0..800 {
        bed.pin.0.borrow_mut().is_off = true;
        bed.tick();
    }
    assert_eq!(bed.modes(), [Mode::Unhomed, Mode::Hold]);
    assert!(bed.has(1, Fault::Silence));
    bed.run(2 * REST + 200);
    assert_eq!(bed.order(1, &Command::Clear(1 << Fault::Silence as u32)), Some(Outcome::Done));
    assert_eq!(bed.order(1, &Command::Enable), Some(Outcome::Done));
}

/// Invalid frames: no tile moves, and a valid message arrives.
#[test]
fn noise_on_the_bus_moves_nothing() {
    let mut talks = talks(2);
    let mut bed = Bed::ready(&mut talks);
    let mut state = 7_u64;
    let mut dice = || {
        state ^= state << 13;
        state ^= state >> 7;
        state ^= state << 17;
        state
    };
    for _ in 0..20_000 {
        let data = dice().to_le_bytes();
        // Not the identifier that stops: whoever sends it is obeyed.
        let id = [0x103, 0x104, REPORTS + 3, 0x7FF][(dice() % 4) as usize];
        let noise = frame::<Classic>(id, &data[..(dice() % 9) as usize]).expect("a frame");
        bed.pin.0.borrow_mut().waiting.push_back(noise);
        bed.tick();
        for board in &bed.boards {
            assert!(!board.station.node().controller().outputs().enable);
        }
    }
    bed.run(200);
    assert_eq!(bed.order(0, &Command::Enable), Some(Outcome::Done));
    const { assert!(FRAMES > RATE, "a tick takes more than the bus brings") };
}
