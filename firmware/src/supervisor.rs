//! Supervises several tiles: one link to each, and the rules that concern more than one tile.
//!
//! In: orders for tiles, their reports. Out: bodies of commands (`peer.rs`), or the reason why an order is refused.
//! Neighbours may differ by a limited step, a limited number of tiles may move at once, and a tile in trouble freezes
//! the others: rules 6, 8 and 12 of `docs/safety.md`. What was ordered counts at once, not from when it is reported.

mod peer;

pub use peer::{BEAT, Peer};

use crate::command::Pose;
use crate::link::frame::Body;
use crate::link::message::{Command, Target};
use crate::tile::design::{HALF_SIDES, STEP_LIMIT};
use smartbed_runtime::real::Real;

/// Most tiles that may move at once, except for resuscitation: the limit of the power supply.
pub const MOST_MOVING: usize = 8;

/// Why the supervisor refuses an order.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Denied {
    /// There is no such tile.
    NoTile,
    /// The tile, or a neighbour, has not reported its state within half a second.
    Unknown,
    /// The tile moves, or is about to.
    Busy,
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
            Self::Unknown => "the tile or a neighbour has not reported its state within half a second",
            Self::Busy => "the tile moves already, or is about to",
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
        if self.peers.iter().filter(|p| p.is_going()).count() >= MOST_MOVING {
            return Err(Denied::Power);
        }
        let ordered = self.peers.get(place).ok_or(Denied::NoTile)?;
        if !ordered.is_known(now) {
            return Err(Denied::Unknown);
        }
        if ordered.is_going() {
            return Err(Denied::Busy);
        }
        self.check_steps(place, target, now)?;
        let peer = self.peers.get_mut(place).ok_or(Denied::NoTile)?;
        peer.command(&Command::Move(target), now, later).ok_or(Denied::Unknown)
    }

    /// Flattens all tiles, regardless of power and neighbours. Calls `send` for each tile.
    pub fn flatten(&mut self, now: u32, mut send: impl FnMut(Body)) {
        for peer in self.peers.iter_mut() {
            peer.command(&Command::Flatten, now, 0).into_iter().for_each(&mut send);
        }
    }

    /// Stops the neighbours that go while a tile is in trouble: their heights beside it are no longer those that were
    /// checked. Calls `send` for each; to be called after reports have been taken.
    pub fn freeze(&mut self, now: u32, mut send: impl FnMut(Body)) {
        for place in 0..self.peers.len() {
            let is_beside_trouble = self.sides(place).any(|(peer, _)| peer.is_in_trouble());
            if let Some(peer) = self.peers.get_mut(place).filter(|peer| is_beside_trouble && peer.is_going())
            {
                peer.command(&Command::Stop, now, 0).into_iter().for_each(&mut send);
            }
        }
    }

    /// Checks that the steps between this tile at its target and its neighbours stay within the limit, at their present
    /// poses and where they are going.
    fn check_steps(&self, place: usize, target: Target, now: u32) -> Result<(), Denied> {
        let ours = Pose { zc: target.heave, tx: target.slope_x, ty: target.slope_y };
        for (peer, side) in self.sides(place) {
            let mut theirs = peer.poses(now).ok_or(Denied::Unknown)?;
            if theirs.any(|theirs| edge_step(ours, theirs, side) > STEP_LIMIT) {
                return Err(Denied::Step);
            }
        }
        Ok(())
    }

    /// The neighbours of a place, each with the direction to it.
    fn sides(&self, place: usize) -> impl Iterator<Item = (&Peer, [f32; 2])> {
        let columns = self.columns.max(1);
        let (row, column) = (place / columns, place % columns);
        self.peers.iter().enumerate().filter_map(move |(other, peer)| {
            let (r, c) = (other / columns, other % columns);
            let side = match (r.cast_signed() - row.cast_signed(), c.cast_signed() - column.cast_signed()) {
                (0, 1) => [1.0, 0.0],
                (0, -1) => [-1.0, 0.0],
                (1, 0) => [0.0, 1.0],
                (-1, 0) => [0.0, -1.0],
                _ => return None,
            };
            Some((peer, side))
        })
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
    use super::{Bed, Denied, MOST_MOVING, Peer, edge_step};
    use crate::command::Pose;
    use crate::link::message::{
        Command, Header, Outcome, REPORT, Refusal, Report, State, Target, VERSION, read, write,
    };
    use crate::link::tag::Key;
    use crate::tile::fault::Fault;
    use crate::tile::mode::Mode;
    use std::vec::Vec;

    const KEY: Key = Key::new([1; 16]);

    /// The tile reports this at a time (ms), by its clock and ours.
    fn report(peer: &mut Peer, report: Report, time: u32) {
        let header =
            Header { version: VERSION | REPORT, tile: peer.tile(), boot: 1, sequence: 0, tick: time };
        let body = write(&header, &report).expect("it fits");
        assert!(peer.take(&body, time).is_some());
    }

    fn state(mode: Mode) -> State {
        State { mode: mode as u8, ..State::default() }
    }

    fn bed(count: u8) -> Vec<Peer> {
        let mut peers: Vec<Peer> = (0..count).map(|n| Peer::new(n, KEY)).collect();
        for peer in &mut peers {
            report(peer, Report::State(state(Mode::Ready)), 0);
        }
        peers
    }

    fn heave(heave: f32) -> Target {
        Target { heave, ..Target::default() }
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
            report(&mut bed.peers[n], Report::State(state(Mode::Moving)), 0);
        }
        assert_eq!(bed.order(5, low, 0, 0).map(drop), Err(Denied::Power));
        let faults = 1 << Fault::Height as u32;
        report(&mut bed.peers[3], Report::State(State { faults, ..state(Mode::Off) }), 0);
        assert_eq!(bed.order(5, low, 0, 0).map(drop), Err(Denied::Frozen));
        let mut sent = 0;
        bed.flatten(0, |_| sent += 1);
        assert_eq!(sent, 28, "resuscitation goes to all");
    }

    #[test]
    fn where_a_neighbour_is_must_be_known() {
        let mut peers: Vec<Peer> = (0..2).map(|n| Peer::new(n, KEY)).collect();
        report(&mut peers[0], Report::State(State::default()), 0);
        let mut bed = Bed { peers: &mut peers, columns: 2 };
        assert_eq!(bed.order(0, Target::default(), 0, 0).map(drop), Err(Denied::Unknown));
    }

    /// Before any report tells of it.
    #[test]
    fn an_order_counts_from_when_it_is_given() {
        let mut peers = bed(28);
        let mut bed = Bed { peers: &mut peers, columns: 4 };
        assert!(bed.order(5, heave(0.019), 0, 0).is_ok());
        assert_eq!(bed.order(6, heave(-0.019), 1, 0).map(drop), Err(Denied::Step));
        assert_eq!(bed.order(5, heave(-0.019), 1, 0).map(drop), Err(Denied::Busy));
        let others = (0..28).filter(|place| bed.order(*place, heave(0.001), 1, 0).is_ok()).count();
        assert_eq!(others + 1, MOST_MOVING);
    }

    #[test]
    fn an_order_ends_when_it_is_refused_or_its_tile_rests_after_it() {
        let mut peers = bed(2);
        let mut bed = Bed { peers: &mut peers, columns: 2 };
        let ordered = |bed: &mut Bed, now| {
            let body = bed.order(0, heave(0.019), now, 0).expect("an order");
            read(&body).expect("a command").header.sequence
        };
        let sequence = ordered(&mut bed, 0);
        report(&mut bed.peers[0], Report::State(state(Mode::Ready)), 100);
        assert!(bed.peers[0].is_going(), "it may still be on its way to the tile");
        report(&mut bed.peers[0], Report::Answer(sequence, Outcome::Refused(Refusal::Mode)), 110);
        assert!(!bed.peers[0].is_going());
        // Carried out: it goes until it rests.
        let sequence = ordered(&mut bed, 200);
        report(&mut bed.peers[0], Report::Answer(sequence, Outcome::Done), 210);
        report(&mut bed.peers[0], Report::State(state(Mode::Moving)), 300);
        report(&mut bed.peers[1], Report::State(state(Mode::Ready)), 300);
        // A second order, which it refuses, changes nothing of where it goes.
        assert!(bed.peers[0].command(&Command::Move(heave(0.0)), 310, 0).is_some());
        report(&mut bed.peers[0], Report::Answer(sequence + 1, Outcome::Refused(Refusal::Busy)), 320);
        assert_eq!(bed.order(1, heave(-0.019), 330, 0).map(drop), Err(Denied::Step));
        report(&mut bed.peers[0], Report::State(state(Mode::Ready)), 400);
        assert!(!bed.peers[0].is_going());
        // Lost: it counts as long as the tile would accept it.
        ordered(&mut bed, 410);
        report(&mut bed.peers[0], Report::State(state(Mode::Ready)), 900);
        assert!(bed.peers[0].is_going());
        report(&mut bed.peers[0], Report::State(state(Mode::Ready)), 1000);
        assert!(!bed.peers[0].is_going());
    }

    #[test]
    fn a_neighbour_that_is_lowered_goes_to_the_bottom() {
        let mut peers = bed(2);
        let mut bed = Bed { peers: &mut peers, columns: 2 };
        assert!(bed.peers[1].command(&Command::Flatten, 0, 0).is_some());
        assert_eq!(bed.order(0, heave(0.0), 1, 0).map(drop), Err(Denied::Step));
        assert!(bed.order(0, heave(-0.019), 1, 0).is_ok());
    }

    #[test]
    fn a_state_of_long_ago_is_none() {
        let mut peers = bed(2);
        let mut bed = Bed { peers: &mut peers, columns: 2 };
        report(&mut bed.peers[0], Report::State(state(Mode::Ready)), 3_600_000);
        assert_eq!(bed.order(0, heave(0.0), 3_600_001, 0).map(drop), Err(Denied::Unknown));
        report(&mut bed.peers[1], Report::State(state(Mode::Ready)), 3_600_000);
        assert!(bed.order(0, heave(0.0), 3_600_001, 0).is_ok());
    }

    #[test]
    fn trouble_stops_the_neighbours_that_go() {
        let mut peers = bed(12);
        let mut bed = Bed { peers: &mut peers, columns: 4 };
        for place in [4, 6, 11] {
            assert!(bed.order(place, heave(0.001), 0, 0).is_ok());
        }
        let faults = 1 << Fault::Height as u32;
        report(&mut bed.peers[5], Report::State(State { faults, ..state(Mode::Off) }), 10);
        let mut stopped = Vec::new();
        bed.freeze(10, |body| {
            let told = read(&body).expect("a command");
            assert_eq!(told.command, Command::Stop);
            stopped.push(told.header.tile);
        });
        assert_eq!(stopped, [4, 6], "not one farther away, nor one that rests");
    }
}
