//! Two tiles and their supervisors on one simulated CAN bus: frames lost, a controller off the bus, a stop.

use crate::wire::KEY;
use embedded_can::nb::Can;
use embedded_can::{ErrorKind, Frame, Id};
use smartbed_firmware::link::bus::{Arrival, Bus};
use smartbed_firmware::link::can::{Classic, Controller, End, FRAMES, REPORTS, REST, STOP, frame};
use smartbed_firmware::link::message::{Command, Outcome, Report, Target, read};
use smartbed_firmware::link::tag::Key;
use smartbed_firmware::node::Node;
use smartbed_firmware::plant::Tile;
use smartbed_firmware::plant::flash::{Flash, provided};
use smartbed_firmware::station::Station;
use smartbed_firmware::supervisor::Peer;
use smartbed_firmware::tile::board::Sensors;
use smartbed_firmware::tile::drive::DRIVE;
use smartbed_firmware::tile::fault::Fault;
use smartbed_firmware::tile::mode::Mode;
use std::cell::RefCell;
use std::collections::VecDeque;
use std::rc::Rc;

/// Frames that a controller holds each way, as bxCAN does.
const DEPTH: usize = 3;
/// Frames that 500 kbit/s carry in a millisecond.
const RATE: usize = 4;

/// What a controller holds.
#[derive(Default)]
struct Chip {
    waiting: VecDeque<Classic>,
    come: VecDeque<Classic>,
    has_overrun: bool,
    is_off: bool,
    restarts: u32,
}

/// A controller on the bus.
#[derive(Clone, Default)]
struct Pin(Rc<RefCell<Chip>>);

#[derive(Debug)]
struct Overrun;

impl embedded_can::Error for Overrun {
    fn kind(&self) -> ErrorKind {
        ErrorKind::Overrun
    }
}

impl Can for Pin {
    type Frame = Classic;
    type Error = Overrun;
    fn transmit(&mut self, frame: &Classic) -> nb::Result<Option<Classic>, Overrun> {
        let mut chip = self.0.borrow_mut();
        if chip.waiting.len() == DEPTH || chip.is_off {
            return Err(nb::Error::WouldBlock);
        }
        chip.waiting.push_back(frame.clone());
        Ok(None)
    }
    fn receive(&mut self) -> nb::Result<Classic, Overrun> {
        let mut chip = self.0.borrow_mut();
        if std::mem::take(&mut chip.has_overrun) {
            return Err(nb::Error::Other(Overrun));
        }
        chip.come.pop_front().ok_or(nb::Error::WouldBlock)
    }
}

impl Controller for Pin {
    fn is_off(&self) -> bool {
        self.0.borrow().is_off
    }
    fn restart(&mut self) {
        let mut chip = self.0.borrow_mut();
        chip.restarts += 1;
        chip.waiting.clear();
        chip.is_off = false;
    }
}

type Board = (Tile, Station<Flash, End<Pin>>, Pin);

/// The bed's side of one tile.
struct Talk {
    peer: Peer,
    end: End<Pin>,
    pin: Pin,
    out: VecDeque<smartbed_firmware::link::frame::Body>,
    reports: Vec<Report>,
}

struct Bed {
    boards: Vec<Board>,
    talks: Vec<Talk>,
    now: u32,
    /// Every so many frames one is lost; 0: none.
    lossy: u32,
    carried: u32,
    /// Most frames of a tick, and of all ticks.
    busiest: usize,
}

impl Bed {
    fn new() -> Self {
        let numbers = [3_u8, 4];
        let boards = numbers.map(|number| {
            let pin = Pin::default();
            let node = Node::new(number, provided(KEY), 0);
            let tile = Tile::loaded(20.0, [0.0; 2], [0.0; 3], DRIVE).expect("a start");
            (tile, Station::new(node, End::of_tile(pin.clone(), number), &[], 0), pin)
        });
        let talks = numbers.map(|number| {
            let pin = Pin::default();
            let end = End::of_supervisor(pin.clone(), number);
            let (out, reports) = (VecDeque::new(), Vec::new());
            Talk { peer: Peer::new(number, Key::new(KEY)), end, pin, out, reports }
        });
        Self { boards: boards.into(), talks: talks.into(), now: 50_000, lossy: 0, carried: 0, busiest: 0 }
    }

    fn pins(&self) -> Vec<Pin> {
        let boards = self.boards.iter().map(|(_, _, pin)| pin);
        boards.chain(self.talks.iter().map(|talk| &talk.pin)).cloned().collect()
    }

    /// The lowest identifier goes first; every other controller hears it, as far as it has room.
    fn carry(&mut self) {
        let pins = self.pins();
        for count in 0..RATE {
            let raw = |id: Id| match id {
                Id::Standard(id) => id.as_raw(),
                Id::Extended(_) => u16::MAX,
            };
            let first = |pin: &Pin| pin.0.borrow().waiting.front().map(|frame| raw(frame.id()));
            let Some(from) =
                (0..pins.len()).filter(|i| first(&pins[*i]).is_some()).min_by_key(|i| first(&pins[*i]))
            else {
                return;
            };
            let Some(frame) = pins[from].0.borrow_mut().waiting.pop_front() else { return };
            self.carried += 1;
            self.busiest = self.busiest.max(count + 1);
            if self.lossy > 0 && self.carried.is_multiple_of(self.lossy) {
                continue;
            }
            for (_, pin) in pins.iter().enumerate().filter(|(i, pin)| *i != from && !pin.0.borrow().is_off) {
                let mut chip = pin.0.borrow_mut();
                if chip.come.len() < 2 * DEPTH {
                    chip.come.push_back(frame.clone())
                } else {
                    chip.has_overrun = true
                }
            }
        }
    }

    fn tick(&mut self) {
        for Talk { peer, end, out, reports, .. } in &mut self.talks {
            out.extend(peer.beat(self.now));
            end.receive(self.now, |arrival| {
                let Arrival::Body(body) = arrival else { panic!("a supervisor is not stopped") };
                reports.extend(peer.take(&body, self.now));
            });
            end.transmit(self.now, || out.pop_front());
        }
        self.carry();
        for (tile, station, _) in &mut self.boards {
            let outputs = station.tick(&tile.read(), &[]);
            tile.advance(&outputs).expect("a step");
        }
        self.now += 1;
    }

    fn run(&mut self, ticks: u32) {
        (0..ticks).for_each(|_| self.tick());
    }

    fn order(&mut self, talk: usize, command: &Command) -> Option<Outcome> {
        let body = self.talks[talk].peer.command(command, self.now, 0)?;
        let sequence = match read(&body) {
            Ok(received) => received.header.sequence,
            Err((header, _)) => header.sequence,
        };
        self.talks[talk].reports.clear();
        self.talks[talk].out.push_back(body);
        self.run(250);
        self.talks[talk].reports.iter().find_map(|report| match report {
            Report::Answer(to, outcome) if *to == sequence => Some(*outcome),
            _ => None,
        })
    }

    fn mode(&self, board: usize) -> Mode {
        self.boards[board].1.node().controller().mode()
    }

    /// Started, known, and both may move.
    fn ready() -> Self {
        let mut bed = Self::new();
        bed.run(500);
        for talk in 0..2 {
            assert_eq!(bed.order(talk, &Command::Enable), Some(Outcome::Done));
        }
        bed
    }
}

const UP: Command = Command::Move(Target { heave: 0.004, slope_x: 0.0, slope_y: 0.0 });

#[test]
fn two_tiles_are_moved_one_after_the_other_over_one_bus() {
    let mut bed = Bed::ready();
    assert_eq!(bed.order(0, &UP), Some(Outcome::Done));
    bed.run(4000);
    let height = |bed: &Bed, board: usize| bed.boards[board].0.heights()[0];
    assert!((height(&bed, 0) - 0.004).abs() < 3e-4 && height(&bed, 1).abs() < 1e-5);
    assert_eq!(bed.order(1, &UP), Some(Outcome::Done));
    bed.run(4000);
    assert!((height(&bed, 1) - 0.004).abs() < 3e-4);
    for (_, station, pin) in &bed.boards {
        assert_eq!((station.bus.lost(), pin.0.borrow().restarts), (0, 0));
        assert!(station.node().controller().latched().is_empty());
    }
    assert!(bed.talks.iter().all(|talk| talk.peer.state().is_some() && talk.end.lost() == 0));
    println!("{} frames in {} ms, {} in a millisecond at most", bed.carried, bed.now - 50_000, bed.busiest);
}

#[test]
fn one_frame_stops_both_and_nothing_that_came_before_moves_them() {
    let mut bed = Bed::ready();
    for talk in 0..2 {
        assert_eq!(bed.order(talk, &UP), Some(Outcome::Done));
    }
    assert_eq!([0, 1].map(|board| bed.mode(board)), [Mode::Moving; 2]);
    // Orders for later, which the stop drops.
    for talk in 0..2 {
        let again = bed.talks[talk].peer.command(&UP, bed.now, 300).expect("it fits");
        bed.talks[talk].out.push_back(again);
    }
    bed.run(100);
    let stop = frame::<Classic>(STOP, &[]).expect("a frame");
    bed.talks[0].pin.0.borrow_mut().waiting.push_front(stop);
    bed.run(2);
    assert_eq!([0, 1].map(|board| bed.mode(board)), [Mode::Hold; 2]);
    bed.run(1000);
    assert_eq!([0, 1].map(|board| bed.mode(board)), [Mode::Hold; 2]);
    // A stop for one of them leaves the other alone.
    for talk in 0..2 {
        assert_eq!(bed.order(talk, &Command::Enable), Some(Outcome::Done));
    }
    bed.talks[0].pin.0.borrow_mut().waiting.push_front(frame(STOP, &[4]).expect("a frame"));
    bed.run(3);
    assert_eq!([bed.mode(0), bed.mode(1)], [Mode::Unhomed, Mode::Hold]);
}

#[test]
fn lost_frames_cost_their_message_alone() {
    let mut bed = Bed::ready();
    bed.lossy = 53;
    // A frame lost costs an order or its answer; a later one finds its way.
    let done = (0..40).filter(|_| bed.order(0, &Command::Enable) == Some(Outcome::Done)).count();
    bed.lossy = 0;
    let lost: u32 = bed.boards.iter().map(|(_, station, _)| station.bus.lost()).sum();
    println!("{done} orders of 40 done, {lost} messages lost");
    assert!(lost > 5 && done > 20, "{lost} lost, {done} done");
    bed.run(200);
    assert_eq!(bed.order(0, &Command::Enable), Some(Outcome::Done), "a whole message gets through at once");
}

/// Off the bus: nothing is sent, motion ends by silence, and the controller comes back each [`REST`] at most.
#[test]
fn a_controller_off_the_bus_comes_back_at_most_every_rest() {
    let mut bed = Bed::ready();
    assert_eq!(bed.order(0, &UP), Some(Outcome::Done));
    let pin = bed.boards[0].2.clone();
    let start = bed.now;
    for _ in 0..1000 {
        // It finds errors again as soon as it is back.
        pin.0.borrow_mut().is_off = true;
        bed.tick();
    }
    let restarts = pin.0.borrow().restarts;
    assert!((5..=(bed.now - start) / REST + 1).contains(&restarts), "{restarts}");
    let controller = bed.boards[0].1.node().controller();
    assert!(controller.latched().has(Fault::Silence) && bed.mode(0) == Mode::Hold);
    // Mended, it comes back by itself.
    bed.run(2 * REST + 200);
    assert!(!pin.0.borrow().is_off);
    assert_eq!(bed.order(0, &Command::Clear(1 << Fault::Silence as u32)), Some(Outcome::Done));
    assert_eq!(bed.order(0, &Command::Enable), Some(Outcome::Done));
}

/// Frames that nobody should send: no tile moves, and a good message gets through.
#[test]
fn noise_on_the_bus_moves_nothing() {
    let mut bed = Bed::ready();
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
        bed.talks[0].pin.0.borrow_mut().waiting.push_back(noise);
        bed.tick();
        for (_, station, _) in &bed.boards {
            assert!(!station.node().controller().outputs().enable);
        }
    }
    bed.run(200);
    assert_eq!(bed.order(0, &Command::Enable), Some(Outcome::Done));
    const { assert!(FRAMES > RATE, "a tick takes more than the bus brings") };
}
