//! A supervisor, a serial line, a node and its tile, simulated millisecond by millisecond.

use smartbed_firmware::link::bus::{Arrival, Bus};
use smartbed_firmware::link::frame::{Body, Decoder, encode};
use smartbed_firmware::link::message::{Command, Outcome, Report, Target, Trim, read};
use smartbed_firmware::link::serial::{Line, Serial};
use smartbed_firmware::link::tag::Key;
use smartbed_firmware::node::Node;
use smartbed_firmware::plant::flash::{Flash, provided};
use smartbed_firmware::plant::{Defect, Tile};
use smartbed_firmware::supervisor::Peer;
use smartbed_firmware::tile::board::Sensors;
use smartbed_firmware::tile::drive::DRIVE;
use smartbed_firmware::tile::fault::Fault;
use smartbed_firmware::tile::mode::Mode;
pub use smartbed_firmware::turns::KEY;
use std::collections::VecDeque;

/// Bytes both ways.
#[derive(Clone, Default)]
pub struct Ends {
    pub down: VecDeque<u8>,
    pub up: VecDeque<u8>,
}

impl Line for Ends {
    fn read(&mut self) -> Option<u8> {
        self.down.pop_front()
    }
    fn write(&mut self, byte: u8) -> bool {
        self.up.push_back(byte);
        true
    }
}

#[derive(Clone)]
pub struct Wire {
    pub tile: Tile,
    pub node: Node<Flash>,
    pub serial: Serial<Ends>,
    pub peer: Peer,
    pub reports: Vec<Report>,
    decoder: Decoder,
    /// The supervisor's time (ms).
    pub now: u32,
    /// Does the supervisor say that it is there?
    pub beats: bool,
    /// Is a bit of every frame wrong?
    pub corrupt: bool,
    /// Milliseconds by which the supervisor's clock gains in every 50.
    pub drift: i32,
    ticks: u32,
}

impl Wire {
    pub fn new(mass: f32) -> Self {
        Self::with(Tile::loaded(mass, [0.0; 2], [0.0; 3], DRIVE).expect("a start"))
    }

    pub fn with(tile: Tile) -> Self {
        Self {
            tile,
            node: Node::new(5, provided(KEY), 0),
            serial: Serial::default(),
            peer: Peer::new(5, Key::new(KEY)),
            reports: Vec::new(),
            decoder: Decoder::default(),
            now: 7_000_000,
            beats: true,
            corrupt: false,
            drift: 0,
            ticks: 0,
        }
    }

    /// Started, known, and motion allowed.
    pub fn ready(mass: f32) -> Self {
        let mut wire = Self::new(mass);
        wire.run(400);
        assert_eq!(wire.order(&Command::Enable), Some(Outcome::Done));
        wire
    }

    pub fn send(&mut self, body: &Body) {
        let mut frame = encode(body);
        if self.corrupt {
            frame[3] ^= 4;
        }
        self.serial.line.down.extend(frame);
    }

    pub fn set(&mut self, defect: Defect) {
        self.tile.set_defect(Some(defect));
    }

    /// A signed order of numbers that are none, one kind after the other.
    pub fn command_nonsense(&mut self, kind: u32) {
        let target = Target { heave: 0.001, slope_x: 0.01, slope_y: 0.0 };
        let nonsense = [
            Command::Move(Target { heave: f32::NAN, ..target }),
            Command::Move(Target { slope_x: f32::INFINITY, ..target }),
            Command::Move(Target { slope_y: f32::NAN, ..target }),
            Command::Pressure(f32::NAN),
            Command::Pressure(f32::NEG_INFINITY),
            Command::Calibrate(Trim { height: [0.0, f32::NAN, 0.0], pressure: 0.0 }),
            Command::Calibrate(Trim { height: [0.0; 3], pressure: f32::NAN }),
        ];
        let command = &nonsense[kind as usize % nonsense.len()];
        let body = self.peer.command(command, self.now, 0).expect("it fits");
        self.send(&body);
    }

    /// The power is cut and comes back: only stored data remain.
    pub fn restart(&mut self) {
        self.node = Node::new(5, provided(KEY), 1);
    }

    pub fn tick(&mut self) {
        if self.beats {
            let beat = self.peer.beat(self.now);
            beat.iter().for_each(|body| self.send(body));
        }
        let readings = self.tile.read();
        let Self { serial, node, .. } = self;
        serial.receive(node.now(), |arrival| {
            let Arrival::Body(body) = arrival else { panic!("a line has no other stop") };
            node.deliver(body);
        });
        self.tile.advance(node.tick(&readings)).expect("a step");
        serial.transmit(node.now(), || node.collect());
        while let Some(byte) = self.serial.line.up.pop_front() {
            if let Some(body) = self.decoder.take(byte) {
                self.reports.extend(self.peer.take(&body, self.now));
            }
        }
        self.now += 1;
        self.ticks += 1;
        if self.ticks.is_multiple_of(50) {
            self.now = self.now.wrapping_add_signed(self.drift);
        }
    }

    pub fn run(&mut self, ticks: u32) {
        (0..ticks).for_each(|_| self.tick());
    }

    /// Sends a command and waits for its outcome.
    pub fn order(&mut self, command: &Command) -> Option<Outcome> {
        self.order_later(command, 0)
    }

    pub fn order_later(&mut self, command: &Command, later: u32) -> Option<Outcome> {
        let body = self.peer.command(command, self.now, later)?;
        let sequence = match read(&body) {
            Ok(received) => received.header.sequence,
            Err((header, _)) => header.sequence,
        };
        self.reports.clear();
        self.send(&body);
        self.run(30);
        self.reports.iter().find_map(|report| match report {
            Report::Answer(to, outcome) if *to == sequence => Some(*outcome),
            _ => None,
        })
    }

    pub fn mode(&self) -> Mode {
        self.node.controller().mode()
    }

    pub fn has(&self, fault: Fault) -> bool {
        self.node.controller().latched().has(fault)
    }

    pub fn is_enabled(&self) -> bool {
        self.node.controller().outputs().enable
    }
}
