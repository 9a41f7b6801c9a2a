//! Supervises several tiles: one link to each, and the rules that concern more than one tile.
//!
//! In: orders for tiles, their reports. Out: bodies of commands, signed and timed by each tile's own clock, or the
//! reason why an order is refused. Neighbours may differ by a limited step, a limited number of tiles may move at once,
//! and a tile in trouble freezes the others: rules 6, 8 and 12 of `docs/safety.md`.

use crate::command::Pose;
use crate::link::frame::Body;
use crate::link::message::{Command, Header, Report, State, Target, VERSION, read_report};
use crate::link::session::sign;
use crate::link::stagger;
use crate::link::tag::Key;
use crate::tile::design::{HALF_SIDES, STEP_LIMIT};
use crate::tile::fault::{Faults, Response};
use crate::tile::mode::Mode;
use crate::tile::motion::pose;
use smartbed_runtime::real::Real;

/// Period of beats (ms): two may be lost before a tile detects silence.
pub const BEAT: u32 = 150;
/// Most tiles that may move at once, except for resuscitation: the limit of the power supply.
pub const MOST_MOVING: usize = 8;

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
    /// Target of the last move.
    target: Target,
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
            target: Target::default(),
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
        if command.needs_tag() {
            self.sequence = self.sequence.checked_add(1)?;
        }
        if let Command::Move(target) = command {
            self.target = *target;
        }
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
        }
        self.ahead = header.tick.wrapping_sub(now);
        if let Report::State(state) = report {
            self.state = Some(state);
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

    fn is_moving(&self) -> bool {
        let modes = [Mode::Moving, Mode::Homing, Mode::Retreat];
        self.state.is_some_and(|state| modes.iter().any(|mode| *mode as u8 == state.mode))
    }

    /// Whether a fault that makes its pose or its sensors doubtful has stopped it.
    fn is_in_trouble(&self) -> bool {
        self.state.is_some_and(|s| Faults::from_bits(s.faults).response() == Some(Response::Off))
    }
}

/// Why the supervisor refuses an order.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Denied {
    /// There is no such tile.
    NoTile,
    /// The tile, or a neighbour, has not reported its state.
    Unknown,
    /// The step to a neighbour's edge would exceed the limit.
    Step,
    /// As many tiles are moving as may.
    Power,
    /// A tile is in trouble: the others may not move.
    Frozen,
}

impl Denied {
    /// The reason in words, as the end of a sentence.
    #[must_use]
    pub fn words(self) -> &'static str {
        match self {
            Self::NoTile => "there is no such tile",
            Self::Unknown => "the tile or a neighbour has not reported its state",
            Self::Step => "the height step to a neighbour would be too large",
            Self::Power => "as many tiles are moving as may",
            Self::Frozen => "a tile is in trouble, so the others may not move",
        }
    }
}

/// Tiles in rows of `columns`, row by row.
#[derive(Debug)]
pub struct Bed<'a> {
    /// The tiles.
    pub peers: &'a mut [Peer],
    /// Tiles in a row.
    pub columns: usize,
}

impl Bed<'_> {
    /// The command that moves tile number `place`.
    ///
    /// # Errors
    /// The reason for the refusal; nothing is sent then.
    pub fn order(&mut self, place: usize, target: Target, now: u32, later: u32) -> Result<Body, Denied> {
        if self.peers.iter().any(Peer::is_in_trouble) {
            return Err(Denied::Frozen);
        }
        if self.peers.iter().filter(|p| p.is_moving()).count() >= MOST_MOVING {
            return Err(Denied::Power);
        }
        self.check_steps(place, target)?;
        let peer = self.peers.get_mut(place).ok_or(Denied::NoTile)?;
        peer.command(&Command::Move(target), now, later).ok_or(Denied::Unknown)
    }

    /// Flattens all tiles, regardless of power and neighbours. Calls `send` for each tile.
    pub fn flatten(&mut self, now: u32, mut send: impl FnMut(Body)) {
        for peer in self.peers.iter_mut() {
            peer.command(&Command::Flatten, now, 0).into_iter().for_each(&mut send);
        }
    }

    /// Checks that the steps between this tile at its target and its neighbours stay within the limit, at their present
    /// poses and at their targets.
    fn check_steps(&self, place: usize, target: Target) -> Result<(), Denied> {
        let ours = Pose { zc: target.heave, tx: target.slope_x, ty: target.slope_y };
        let (row, column) = (place.checked_div(self.columns), place.checked_rem(self.columns));
        let (row, column) = row.zip(column).ok_or(Denied::NoTile)?;
        for (other, peer) in self.peers.iter().enumerate() {
            let (r, c) = (other / self.columns, other % self.columns);
            let side = match (r.cast_signed() - row.cast_signed(), c.cast_signed() - column.cast_signed()) {
                (0, 1) => [1.0, 0.0],
                (0, -1) => [-1.0, 0.0],
                (1, 0) => [0.0, 1.0],
                (-1, 0) => [0.0, -1.0],
                _ => continue,
            };
            let here = pose(peer.state.ok_or(Denied::Unknown)?.heights);
            let there = Pose { zc: peer.target.heave, tx: peer.target.slope_x, ty: peer.target.slope_y };
            let going = if peer.is_moving() { there } else { here };
            if ![here, going].iter().all(|theirs| edge_step(ours, *theirs, side) <= STEP_LIMIT) {
                return Err(Denied::Step);
            }
        }
        Ok(())
    }
}

/// Largest step (m) between the common edges of two tiles; `side` points from the first to the second.
#[must_use]
pub fn edge_step(a: Pose, b: Pose, side: [f32; 2]) -> f32 {
    let [x, y] = side;
    let (half_x, half_y) = HALF_SIDES;
    let height = |pose: Pose, x: f32, y: f32| pose.zc - pose.tx * x - pose.ty * y;
    let corner = |along: f32| {
        // A corner of the common edge, relative to either centre.
        let (u, v) = (y * along * half_x, x * along * half_y);
        let ours = height(a, x * half_x + u, y * half_y + v);
        let theirs = height(b, -x * half_x + u, -y * half_y + v);
        Real::abs(ours - theirs)
    };
    Real::max(corner(1.0), corner(-1.0))
}

#[cfg(test)]
mod tests {
    use super::{Bed, Denied, Peer, edge_step};
    use crate::command::Pose;
    use crate::link::message::{Header, REPORT, Report, State, Target, VERSION, write};
    use crate::link::tag::Key;
    use crate::tile::fault::Fault;
    use crate::tile::mode::Mode;
    use std::vec::Vec;

    const KEY: Key = Key::new([1; 16]);

    fn report_state(peer: &mut Peer, tile: u8, state: State) {
        let header = Header { version: VERSION | REPORT, tile, boot: 1, sequence: 0, tick: 0 };
        let body = write(&header, &Report::State(state)).expect("it fits");
        assert!(peer.take(&body, 0).is_some());
    }

    fn bed(count: u8) -> Vec<Peer> {
        let mut peers: Vec<Peer> = (0..count).map(|n| Peer::new(n, KEY)).collect();
        for (n, peer) in peers.iter_mut().enumerate() {
            report_state(peer, n as u8, State { mode: Mode::Ready as u8, ..State::default() });
        }
        peers
    }

    #[test]
    fn steps_are_those_of_the_planes() {
        // 4 degrees each, against each other along x: twice the half length times the slope.
        let tilted = |tx: f32| Pose { zc: 0.0, tx, ty: 0.0 };
        let step = edge_step(tilted(0.07), tilted(0.07), [1.0, 0.0]);
        assert!((step - 2.0 * 0.1125 * 0.07).abs() < 1e-6, "{step}");
        assert!(edge_step(tilted(0.07), tilted(-0.07), [1.0, 0.0]) < 1e-7, "a roof has no step");
        assert!((edge_step(tilted(0.07), tilted(0.0), [0.0, 1.0]) - 0.1125 * 0.07).abs() < 1e-6);
    }

    #[test]
    fn neighbours_power_and_trouble_deny() {
        let high = Target { heave: 0.021, ..Target::default() };
        let low = Target { heave: 0.019, ..Target::default() };
        let mut peers = bed(28);
        let mut bed = Bed { peers: &mut peers, columns: 4 };
        assert_eq!(bed.order(5, high, 0, 0).map(drop), Err(Denied::Step));
        assert!(bed.order(5, low, 0, 0).is_ok());
        assert_eq!(bed.order(99, low, 0, 0).map(drop), Err(Denied::NoTile));
        for n in 20..28 {
            report_state(&mut bed.peers[n], n as u8, State { mode: Mode::Moving as u8, ..State::default() });
        }
        assert_eq!(bed.order(5, low, 0, 0).map(drop), Err(Denied::Power));
        let faults = 1 << Fault::Height as u32;
        report_state(&mut bed.peers[3], 3, State { mode: Mode::Off as u8, faults, ..State::default() });
        assert_eq!(bed.order(5, low, 0, 0).map(drop), Err(Denied::Frozen));
        let mut sent = 0;
        bed.flatten(0, |_| sent += 1);
        assert_eq!(sent, 28, "resuscitation goes to all");
    }

    #[test]
    fn where_a_neighbour_is_must_be_known() {
        let mut peers: Vec<Peer> = (0..2).map(|n| Peer::new(n, KEY)).collect();
        report_state(&mut peers[0], 0, State::default());
        let mut bed = Bed { peers: &mut peers, columns: 2 };
        assert_eq!(bed.order(0, Target::default(), 0, 0).map(drop), Err(Denied::Unknown));
    }
}
