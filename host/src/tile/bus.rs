//! Tiles and their supervisor on one bus, in steps of a millisecond.
//!
//! In: orders. Out: reports, each with its tile and time. Every tile receives what the supervisor sends.

use super::machine::Machine;
use super::order::{self, Order};
use crate::failure::Failure;
use crate::output;
use smartbed_firmware::link::frame::{Decoder, encode};
use smartbed_firmware::link::message::{Command, Outcome, Refusal, Report, read};
use smartbed_firmware::link::serial::BYTES;
use smartbed_firmware::link::tag::Key;
use smartbed_firmware::supervisor::Peer;
use smartbed_firmware::tile::fault::Faults;
use smartbed_firmware::tile::mode::Mode;
use smartbed_firmware::turns::KEY;
use std::collections::VecDeque;

/// Time limit for an answer (ms).
const PATIENCE: u32 = 200;
/// Time limit for a motion (ms).
const LONGEST: u32 = 300_000;
/// Ticks that tiles take in one turn if nothing has to be sent.
const BATCH: u32 = 50;

/// A report of a tile.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Received {
    /// The tile.
    pub tile: u8,
    /// Its time (ms).
    pub time: u32,
    /// The report.
    pub report: Report,
    /// Was it asked for? Telemetry is sent unasked.
    pub is_asked: bool,
}

/// Called for every report.
pub type Listen<'a> = &'a mut dyn FnMut(Received) -> Result<(), Failure>;
/// Asked during a motion: shall it be stopped?
pub type Interrupt<'a> = &'a mut dyn FnMut() -> Result<bool, Failure>;

/// A bus with its tiles.
#[derive(Debug)]
pub struct Bus {
    tiles: Vec<(Machine, Peer, Decoder)>,
    current: usize,
    /// Bytes waiting to be sent.
    down: VecDeque<u8>,
    now: u32,
    /// The tile whose state has been asked for and has not arrived yet.
    asked: Option<u8>,
    /// Everything that the tiles have sent.
    pub heard: Vec<u8>,
}

impl Bus {
    /// A bus with these tiles, numbered from 0.
    #[must_use]
    pub fn new(machines: Vec<Machine>) -> Self {
        let tile = |(number, machine)| (machine, Peer::new(number, Key::new(KEY)), Decoder::default());
        let tiles = (0_u8..).zip(machines).map(tile).collect();
        Self { tiles, current: 0, down: VecDeque::new(), now: 1, asked: None, heard: Vec::new() }
    }

    /// Margin of self-locking of the first tile.
    #[must_use]
    pub fn margin(&self) -> f64 {
        self.tiles.first().map_or(0.0, |(machine, ..)| machine.margin())
    }

    /// The time (ms).
    #[must_use]
    pub fn now(&self) -> u32 {
        self.now
    }

    /// Executes an order to its end.
    ///
    /// # Errors
    /// [`Failure::Wrong`] if a command is refused, or a tile does not answer.
    pub fn take(&mut self, order: &Order, listen: Listen) -> Result<(), Failure> {
        self.take_until(order, listen, &mut || Ok(false))
    }

    /// Executes an order; a motion to its end, or until `interrupt` stops it.
    ///
    /// # Errors
    /// As [`Self::take`], and the interrupt's.
    pub fn take_until(&mut self, order: &Order, listen: Listen, interrupt: Interrupt) -> Result<(), Failure> {
        match order {
            Order::Wait(ticks) => self.run(*ticks, listen),
            Order::Tile(number) if usize::from(*number) < self.tiles.len() => {
                self.current = usize::from(*number);
                Ok(())
            }
            Order::Tile(number) => {
                let count = self.tiles.len();
                Err(Failure::Wrong(format!("no tile {number}: there are {count}, from 0; see --tiles")))
            }
            Order::Break(defect) => self.tiles[self.current].0.strike(*defect),
            Order::Begin(command) => self.send(command, listen).map(drop),
            Order::Send(command) => match self.send(command, listen)? {
                true if moves(command) => self.settle(listen, interrupt),
                _ => Ok(()),
            },
        }
    }

    /// Ends all tiles.
    ///
    /// # Errors
    /// As [`Machine::end`].
    pub fn end(self) -> Result<(), Failure> {
        self.tiles.into_iter().try_for_each(|(machine, ..)| machine.end().map(drop))
    }

    /// Ends the first tile; returns the bytes of stack that it used.
    ///
    /// # Errors
    /// As [`Machine::end`].
    pub fn depth(mut self) -> Result<u32, Failure> {
        self.tiles.remove(0).0.end()
    }

    /// Sends a command and waits for its answer; returns whether it is completed.
    fn send(&mut self, command: &Command, listen: Listen) -> Result<bool, Failure> {
        self.greet(listen)?;
        // `clear` stands for all faults that are present.
        let peer = &self.tiles[self.current].1;
        let command = match command {
            Command::Clear(_) => Command::Clear(peer.state().map_or(0, |state| state.faults)),
            other => *other,
        };
        let body = self.tiles[self.current].1.command(&command, self.now, 0);
        let body = body.ok_or_else(|| Failure::Wrong("the tile has not identified itself".to_owned()))?;
        let sequence = match read(&body) {
            Ok(received) => received.header.sequence,
            Err((header, _)) => header.sequence,
        };
        self.down.extend(encode(&body));
        if command == Command::Status {
            self.asked = u8::try_from(self.current).ok();
        }
        if !command.needs_tag() && command != Command::Stop {
            return self.run(PATIENCE, listen).map(|()| true);
        }
        let mut answer = None;
        for _ in 0..PATIENCE {
            let mut hear = |received: Received| {
                if let Report::Answer(to, outcome) = received.report
                    && to == sequence
                {
                    answer = Some(outcome);
                }
                listen(received)
            };
            self.tick(1, &mut hear)?;
            if answer.is_some() {
                break;
            }
        }
        match answer {
            Some(outcome @ (Outcome::Done | Outcome::Waits)) => Ok(outcome == Outcome::Done),
            Some(Outcome::Refused(why)) => Err(refused(&command, why)),
            None => {
                Err(Failure::Wrong(format!("`{}`: no answer within {PATIENCE} ms", order::word(&command))))
            }
        }
    }

    /// Runs until every tile has sent its identity and state.
    fn greet(&mut self, listen: Listen) -> Result<(), Failure> {
        for _ in 0..10 * PATIENCE {
            let is_ready = |peer: &Peer| {
                let starts = [Mode::Boot as u8, Mode::SelfTest as u8];
                peer.state().is_some_and(|state| !starts.contains(&state.mode))
            };
            if self.tiles.iter().all(|(_, peer, _)| is_ready(peer)) {
                return Ok(());
            }
            self.tick(1, listen)?;
        }
        Err(Failure::Wrong("a tile has not identified itself".to_owned()))
    }

    /// Runs until the current tile has come to rest.
    fn settle(&mut self, listen: Listen, interrupt: Interrupt) -> Result<(), Failure> {
        // Until new telemetry has arrived, the state is the one before the motion.
        self.run(250, listen)?;
        let start = self.now;
        while self.is_moving() {
            if self.now.wrapping_sub(start) > LONGEST {
                return Err(Failure::Wrong("the tile still moves".to_owned()));
            }
            if interrupt()? {
                return self.send(&Command::Stop, listen).map(drop);
            }
            self.run(BATCH, listen)?;
        }
        let (tile, state) = (self.current, self.tiles[self.current].1.state());
        let faults = state.map_or_else(Faults::default, |state| Faults::from_bits(state.faults));
        if !faults.is_empty() {
            let names = faults.names().collect::<Vec<_>>().join(", ");
            let is_down = state.is_some_and(|state| state.mode == Mode::Flatten as u8);
            let what = if is_down { "it is down, with a fault" } else { "the motion ended by a fault" };
            output::say(&format!("warning: tile {tile}: {what}: {names}; see `status`"));
        }
        Ok(())
    }

    fn is_moving(&self) -> bool {
        let state = self.tiles[self.current].1.state();
        // A flattened tile stays in its mode: the flag of its drives tells whether it moves.
        state.is_some_and(|state| state.flags & 1 == 1)
    }

    /// Runs for a number of ticks.
    ///
    /// # Errors
    /// As [`Machine::turn`].
    pub fn run(&mut self, ticks: u32, listen: Listen) -> Result<(), Failure> {
        let mut left = ticks;
        while left > 0 {
            let some = left.min(BATCH);
            self.tick(some, listen)?;
            left -= some;
        }
        Ok(())
    }

    /// Runs for a number of ticks, with the supervisor's heartbeats first; one tick at a time as long as there are
    /// bytes to send.
    fn tick(&mut self, ticks: u32, listen: Listen) -> Result<(), Failure> {
        for (_, peer, _) in &mut self.tiles {
            if let Some(body) = peer.beat(self.now) {
                self.down.extend(encode(&body));
            }
        }
        let mut left = ticks;
        while left > 0 {
            let some = if self.down.is_empty() { left } else { 1 };
            self.step(some, listen)?;
            left -= some;
        }
        Ok(())
    }

    /// Sends as many bytes as fit into a tick, and runs for a number of ticks.
    fn step(&mut self, ticks: u32, listen: Listen) -> Result<(), Failure> {
        let count = self.down.len().min(BYTES);
        let bytes: Vec<u8> = self.down.drain(..count).collect();
        for (machine, peer, decoder) in &mut self.tiles {
            for (time, sent) in (self.now..).zip(machine.turn(&bytes, ticks)?) {
                self.heard.extend(&sent);
                for body in sent.into_iter().filter_map(|byte| decoder.take(byte)) {
                    if let Some(report) = peer.take(&body, time) {
                        let is_state = matches!(report, Report::State(_));
                        let is_asked = !is_state || self.asked == Some(peer.tile());
                        self.asked = self.asked.filter(|_| !(is_state && is_asked));
                        listen(Received { tile: peer.tile(), time, report, is_asked })?;
                    }
                }
            }
        }
        self.now = self.now.wrapping_add(ticks);
        Ok(())
    }
}

fn moves(command: &Command) -> bool {
    matches!(command, Command::Home | Command::Move(_) | Command::Flatten)
}

fn refused(command: &Command, why: Refusal) -> Failure {
    let help = match why {
        Refusal::Mode if *command == Command::Flatten || matches!(command, Command::Clear(_)) => {
            ": see `status`"
        }
        Refusal::Mode => ": `enable` first, and see `status`",
        Refusal::Faulted => ": `clear` once the cause is gone",
        Refusal::Busy => ": `stop` first",
        _ => "",
    };
    Failure::Wrong(format!("`{}` is refused: {}{help}", order::word(command), why.words()))
}
