//! One tile as its supervisor knows it: its time, its last reported state, and where its orders send it.
//!
//! In: commands for the tile, its reports. Out: bodies of commands, signed and timed by the tile's own clock.
//! An order counts from when it is given until the tile refuses it, or reports that it rests after it was carried out.

use crate::command::Pose;
use crate::link::frame::Body;
use crate::link::message::{Command, Header, Outcome, Report, State, Target, VERSION, read_report};
use crate::link::session::{WINDOW, sign};
use crate::link::stagger;
use crate::link::tag::Key;
use crate::tile::design::STROKE;
use crate::tile::fault::{Faults, Response};
use crate::tile::mode::Mode;
use crate::tile::motion::pose;
use heapless::Vec;

/// Period of beats (ms): two may be lost before a tile detects silence.
pub const BEAT: u32 = 150;
/// Time (ms) after which a reported state says nothing about the present: a tile sends it every 100 ms.
const STALE: u32 = 500;
/// Most orders under way to one tile: one that it carries out, and others that it will refuse.
const ORDERS: usize = 4;

/// An order of which the tile has not reported the end.
#[derive(Clone, Copy, Debug)]
struct Order {
    sequence: u32,
    there: Pose,
    /// The tile's tick after which a state of rest is one of after the order.
    done: u32,
}

/// One tile, as its supervisor knows it.
#[derive(Clone, Debug)]
pub struct Peer {
    tile: u8,
    key: Key,
    boot: Option<u32>,
    /// The tile's time minus ours (ms).
    ahead: u32,
    sequence: u32,
    /// Number of the last beat.
    beat: Option<u32>,
    state: Option<State>,
    /// Our time of that (ms).
    heard: u32,
    orders: Vec<Order, ORDERS>,
}

impl Peer {
    /// A tile that has not yet identified itself.
    #[must_use]
    pub fn new(tile: u8, key: Key) -> Self {
        Self {
            tile,
            key,
            boot: None,
            ahead: 0,
            sequence: 0,
            beat: None,
            state: None,
            heard: 0,
            orders: Vec::new(),
        }
    }

    /// The body of a command to be executed `later` ms from now; None before the tile has identified itself,
    /// unless the command needs no tag.
    pub fn command(&mut self, command: &Command, now: u32, later: u32) -> Option<Body> {
        if command.needs_tag() && self.boot.is_none() {
            return None;
        }
        let tick = now.wrapping_add(self.ahead).wrapping_add(later);
        let (boot, sequence) = (self.boot.unwrap_or(0), self.sequence);
        let header = Header { version: VERSION, tile: self.tile, boot, sequence, tick };
        if *command == Command::Flatten {
            // It ends what was ordered before.
            self.orders.clear();
        }
        if let Some(there) = destination(command) {
            if self.orders.is_full() {
                // The tile carries out the first of them.
                self.orders.pop();
            }
            let _ = self.orders.push(Order { sequence, there, done: tick.wrapping_add(WINDOW.0) });
        }
        // Each has a number of its own, so that answers can be told apart.
        self.sequence = self.sequence.checked_add(1)?;
        sign(&header, command, &self.key)
    }

    /// A beat, if one is due, to be sent at once; before the first answer, a request for identification.
    pub fn beat(&mut self, now: u32) -> Option<Body> {
        let number = now.wrapping_add(stagger(self.tile)) / BEAT;
        if self.beat.replace(number) == Some(number) {
            return None;
        }
        let command = if self.boot.is_some() { Command::Beat(now) } else { Command::Identify };
        self.command(&command, now, 0)
    }

    /// Takes a body from the bus; returns the report, if it is this tile's. After a restart of the tile sequence
    /// numbers start again.
    pub fn take(&mut self, body: &[u8], now: u32) -> Option<Report> {
        let (header, report) = read_report(body).filter(|(header, _)| header.tile == self.tile)?;
        if self.boot != Some(header.boot) {
            (self.boot, self.sequence) = (Some(header.boot), 0);
            self.orders.clear();
        }
        self.ahead = header.tick.wrapping_sub(now);
        match report {
            Report::State(state) => {
                (self.state, self.heard) = (Some(state), now);
                if !moves(&state) {
                    self.orders.retain(|order| header.tick.wrapping_sub(order.done).cast_signed() <= 0);
                }
            }
            Report::Answer(sequence, Outcome::Refused(_)) => {
                self.orders.retain(|order| order.sequence != sequence);
            }
            Report::Answer(sequence, Outcome::Done) => {
                let carried_out = self.orders.iter_mut().filter(|order| order.sequence == sequence);
                carried_out.for_each(|order| order.done = header.tick);
            }
            _ => (),
        }
        Some(report)
    }

    /// Its last reported state.
    #[must_use]
    pub fn state(&self) -> Option<&State> {
        self.state.as_ref()
    }

    /// Number of the tile.
    #[must_use]
    pub fn tile(&self) -> u8 {
        self.tile
    }

    /// Whether it moves, or has been ordered to.
    #[must_use]
    pub fn is_going(&self) -> bool {
        self.state.as_ref().is_some_and(moves) || !self.orders.is_empty()
    }

    /// Whether it has reported its state lately.
    #[must_use]
    pub fn is_known(&self, now: u32) -> bool {
        self.state.is_some() && now.wrapping_sub(self.heard) <= STALE
    }

    /// Its pose as it was reported last, and poses that it is going to; None if it has not reported lately.
    pub(super) fn poses(&self, now: u32) -> Option<impl Iterator<Item = Pose>> {
        let state = self.state.filter(|_| self.is_known(now))?;
        Some([pose(state.heights)].into_iter().chain(self.orders.iter().map(|order| order.there)))
    }

    /// Whether a fault that makes its pose or its sensors doubtful has stopped it.
    #[must_use]
    pub fn is_in_trouble(&self) -> bool {
        self.state.is_some_and(|s| Faults::from_bits(s.faults).response() == Some(Response::Off))
    }
}

/// Where a command sends the tile; None if nowhere.
fn destination(command: &Command) -> Option<Pose> {
    match command {
        Command::Move(Target { heave, slope_x, slope_y }) => {
            Some(Pose { zc: *heave, tx: *slope_x, ty: *slope_y })
        }
        Command::Home | Command::Flatten => Some(Pose { zc: -STROKE, tx: 0.0, ty: 0.0 }),
        _ => None,
    }
}

/// Whether the legs move: in these modes, and down for resuscitation while drives are on.
fn moves(state: &State) -> bool {
    let is_in = |modes: &[Mode]| modes.iter().any(|mode| *mode as u8 == state.mode);
    is_in(&[Mode::Moving, Mode::Homing, Mode::Retreat]) || is_in(&[Mode::Flatten]) && state.flags & 1 == 1
}
