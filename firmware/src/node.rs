//! A tile as its bus sees it: link, controller and store in one call per millisecond.
//!
//! In: bodies of frames, readings. Out: outputs for the board, and bodies of reports.
//! Order of a tick: at most one body is taken; a command that is due, new or waiting, goes to the
//! controller; its outcome is answered; then log and telemetry. Before the first authenticated command only answers
//! are sent.

use crate::link::clock::Clock;
use crate::link::frame::Body;
use crate::link::log::Log;
use crate::link::message::{Command, Event, Outcome, Refusal, Report, Trim, VERSION, write};
use crate::link::session::{Accepted, Session};
use crate::link::stagger;
use crate::link::tag::Key;
use crate::tile::board::{Outputs, Readings};
use crate::tile::controller::Controller;
use crate::tile::fault::{Fault, Faults};
use crate::tile::store::{Record, Store};
use embedded_storage::nor_flash::NorFlash;
use heapless::{Deque, Vec};

/// Most bodies waiting to be taken: a tick brings two at most.
const INBOX: usize = 4;
/// Most commands waiting for their tick.
const WAITING: usize = 8;
/// Most reports waiting to be sent.
const OUTBOX: usize = 8;
/// Period of the state report while a supervisor is present (ticks).
const TELEMETRY: u32 = 100;

/// A tile on its bus.
#[derive(Clone, Debug)]
pub struct Node<F> {
    session: Session,
    controller: Controller,
    store: Store<F>,
    record: Option<Record>,
    clock: Clock,
    /// Whether the program has changed.
    is_damaged: bool,
    /// Whether the clocks were apart in this tick.
    is_apart: bool,
    /// Whether a stop without a body has arrived.
    is_halted: bool,
    log: Log,
    /// The next log entry requested.
    asked: Option<u32>,
    inbox: Deque<Body, INBOX>,
    waiting: Vec<Accepted, WAITING>,
    outbox: Deque<Body, OUTBOX>,
    /// Phase of the state report (ms).
    phase: u32,
    /// The tile's time (ms).
    now: u32,
    sequence: u32,
    lost: u32,
}

impl<F: NorFlash> Node<F> {
    /// Starts the tile with this number: the boot is counted and stored first. `reason` goes into the log.
    #[must_use]
    pub fn new(tile: u8, mut store: Store<F>, reason: u8) -> Self {
        let record = store.start();
        let key = Key::new(record.map_or([0; 16], |r| r.key));
        let mut log = Log::default();
        log.add(0, Event::Started(reason));
        Self {
            session: Session::new(tile, record.map(|r| r.boot), key),
            controller: Controller::new(record.map(|r| r.trim)),
            store,
            record,
            clock: Clock::default(),
            is_damaged: false,
            is_apart: false,
            is_halted: false,
            log,
            asked: None,
            inbox: Deque::new(),
            waiting: Vec::new(),
            outbox: Deque::new(),
            phase: stagger(tile),
            now: 0,
            sequence: 0,
            lost: 0,
        }
    }

    /// Hands over a received body; false if too many are waiting.
    pub fn deliver(&mut self, body: Body) -> bool {
        self.inbox.push_back(body).is_ok()
    }

    /// Stops in the next tick, whoever asked for it; earlier commands are dropped.
    pub fn halt(&mut self) {
        self.inbox.clear();
        self.waiting.clear();
        self.is_halted = true;
    }

    /// The next body to be sent.
    pub fn collect(&mut self) -> Option<Body> {
        self.outbox.pop_front()
    }

    /// Sets the number of frames lost so far, for identity reports.
    pub fn count_lost(&mut self, lost: u32) {
        self.lost = lost;
    }

    /// Reports that the program has changed: off in the next tick, and it cannot be cleared.
    pub fn report_damage(&mut self) {
        self.is_damaged = true;
    }

    /// The controller.
    #[must_use]
    pub fn controller(&self) -> &Controller {
        &self.controller
    }

    /// The store, which outlives a restart.
    pub fn store_mut(&mut self) -> &mut Store<F> {
        &mut self.store
    }

    /// The controller, for fault injection.
    pub fn controller_mut(&mut self) -> &mut Controller {
        &mut self.controller
    }

    /// The tile's time (ms).
    #[must_use]
    pub fn now(&self) -> u32 {
        self.now
    }

    /// One millisecond; returns the outputs for the board.
    pub fn tick(&mut self, readings: &Readings) -> &Outputs {
        self.now = self.now.wrapping_add(1);
        let is_halted = core::mem::take(&mut self.is_halted);
        let accepted = if is_halted { None } else { self.accept().or_else(|| self.due()) };
        let outside = self.outside();
        let before = self.controller.mode();
        let command = if is_halted { Some(&Command::Stop) } else { accepted.as_ref().map(|a| &a.command) };
        let (new, outcome) = self.controller.tick(readings, outside, command);
        if !new.is_empty() {
            self.log.add(self.now, Event::Faults(new.bits()));
        }
        if let (Some(accepted), Some(outcome)) = (accepted, outcome) {
            self.finish(&accepted, outcome);
        }
        let after = self.controller.mode();
        if after != before {
            self.log.add(self.now, Event::Mode(after as u8));
        }
        self.send_reports();
        self.controller.outputs()
    }

    /// Takes a body; returns its command if that is due now.
    fn accept(&mut self) -> Option<Accepted> {
        let body = self.inbox.pop_front()?;
        let accepted = match self.session.accept(&body, self.now) {
            Ok(accepted) => accepted?,
            Err((sequence, why)) => {
                self.refuse(sequence, why);
                return None;
            }
        };
        let Accepted { sequence, due, command } = accepted;
        match command {
            Command::Beat(theirs) => {
                self.is_apart = !self.clock.take(theirs, self.now);
                return None;
            }
            Command::Log(first) => self.asked = Some(first),
            Command::Status => self.send(&Report::State(self.controller.state())),
            Command::Identify => {
                let entries = self.log.next();
                self.send(&Report::Identity(VERSION, entries, self.lost, self.session.refused()));
            }
            // All waiting commands were sent before the stop.
            Command::Stop => {
                self.waiting.clear();
                return Some(accepted);
            }
            _ if is_later(due, self.now) => match self.waiting.push(accepted) {
                Ok(()) => self.send(&Report::Answer(sequence, Outcome::Waits)),
                Err(_) => self.refuse(sequence, Refusal::Full),
            },
            _ => return Some(accepted),
        }
        None
    }

    /// The first waiting command that is due.
    fn due(&mut self) -> Option<Accepted> {
        let place = self.waiting.iter().position(|a| !is_later(a.due, self.now))?;
        Some(self.waiting.remove(place))
    }

    /// Faults detected by the link.
    fn outside(&mut self) -> Faults {
        let mut outside = Faults::default();
        let is_silent = self.session.is_silent(self.now);
        if is_silent {
            self.clock.forget();
        }
        outside.set(Fault::Silence, is_silent);
        outside.set(Fault::Clock, core::mem::take(&mut self.is_apart));
        outside.set(Fault::Program, self.is_damaged);
        outside.set(Fault::Storage, self.record.is_none());
        outside
    }

    /// Stores the data that a command asked to store, answers the command, and logs it.
    fn finish(&mut self, accepted: &Accepted, outcome: Outcome) {
        let outcome = match (accepted.command, outcome) {
            (Command::Calibrate(trim), Outcome::Done) if !self.keep(trim) => {
                Outcome::Refused(Refusal::Storage)
            }
            (Command::Clear(bits), Outcome::Done) => {
                self.log.add(self.now, Event::Cleared(Faults::from_bits(bits).bits()));
                outcome
            }
            _ => outcome,
        };
        match outcome {
            Outcome::Refused(why) => self.refuse(accepted.sequence, why),
            _ => self.send(&Report::Answer(accepted.sequence, outcome)),
        }
    }

    /// Stores a calibration; the controller has made sure that drives are off.
    fn keep(&mut self, trim: Trim) -> bool {
        let Some(record) = self.record.map(|record| Record { trim, ..record }) else { return false };
        let is_stored = self.store.save(&record).is_ok();
        self.record = is_stored.then_some(record);
        is_stored
    }

    /// Sends requested log entries, and the state periodically.
    fn send_reports(&mut self) {
        let has_room = self.outbox.len() + 2 < OUTBOX;
        if let Some(number) = self.asked.filter(|_| has_room) {
            self.asked = self.log.from(number).map(|(number, tick, event)| {
                self.send(&Report::Entry(number, tick, event));
                number.wrapping_add(1)
            });
        }
        let is_time = self.now.wrapping_add(self.phase).is_multiple_of(TELEMETRY);
        if has_room && is_time && !self.session.is_silent(self.now) {
            self.send(&Report::State(self.controller.state()));
        }
    }

    fn refuse(&mut self, sequence: u32, why: Refusal) {
        self.log.add(self.now, Event::Refused(sequence, why));
        self.send(&Report::Answer(sequence, Outcome::Refused(why)));
    }

    /// Queues a report; drops it if the queue is full.
    fn send(&mut self, report: &Report) {
        let header = self.session.header(self.sequence, self.now);
        if let Some(body) = write(&header, report) {
            self.sequence = self.sequence.wrapping_add(1);
            let _ = self.outbox.push_back(body);
        }
    }
}

/// Whether `tick` is in the future; ticks wrap around.
fn is_later(tick: u32, now: u32) -> bool {
    tick.wrapping_sub(now).cast_signed() > 0
}
