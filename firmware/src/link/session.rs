//! Authentication: the only way for commands into the tile.
//!
//! In: bodies of frames and the tile's time. Out: commands that are fresh and authenticated, or refusals.
//! State: the highest sequence number used since the start. Commands without a tag do not change it, so nobody can
//! use up sequence numbers without the key.

use super::message::{Command, EVERY_TILE, Header, REPORT, Received, Refusal, VERSION, read};
use super::tag::Key;

/// Limits of a command's tick: ms before now, ms after now.
pub const WINDOW: (u32, u32) = (500, 2000);
/// Time without authenticated command that stops motion (ms).
pub const SILENCE: u32 = 500;

/// A command that may be executed.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Accepted {
    /// Its sequence number.
    pub sequence: u32,
    /// Tick at which to execute it.
    pub due: u32,
    /// What is asked for.
    pub command: Command,
}

/// A session, from one start of the tile to the next.
#[derive(Clone, Debug)]
pub struct Session {
    tile: u8,
    /// Number of this start; None if it could not be stored.
    boot: Option<u32>,
    key: Key,
    /// Lowest unused sequence number.
    next: u32,
    /// Tick of the last authenticated command.
    heard: Option<u32>,
    refused: u32,
}

impl Session {
    /// A session of a tile; `boot` is None if the counter could not be stored, and then no tag is fresh.
    #[must_use]
    pub fn new(tile: u8, boot: Option<u32>, key: Key) -> Self {
        Self { tile, boot, key, next: 0, heard: None, refused: 0 }
    }

    /// Accepts or refuses a command; ignores messages for other tiles, and reports.
    ///
    /// # Errors
    /// The sequence number, and the reason for the refusal.
    pub fn accept(&mut self, body: &[u8], now: u32) -> Result<Option<Accepted>, (u32, Refusal)> {
        let received = match read(body) {
            Ok(received) => received,
            Err((header, _)) if !self.is_meant(&header) => return Ok(None),
            Err((header, why)) => return Err(self.refuse(&header, why)),
        };
        let Received { header, command, .. } = received;
        if !self.is_meant(&header) {
            return Ok(None);
        }
        if command.needs_tag() {
            self.check(&received, now).map_err(|why| self.refuse(&header, why))?;
            self.next = header.sequence.saturating_add(1);
            self.heard = Some(now);
            Ok(Some(Accepted { sequence: header.sequence, due: header.tick, command }))
        } else {
            Ok(Some(Accepted { sequence: header.sequence, due: now, command }))
        }
    }

    /// Whether no authenticated command has come for too long.
    #[must_use]
    pub fn is_silent(&self, now: u32) -> bool {
        self.heard.is_none_or(|heard| now.wrapping_sub(heard) > SILENCE)
    }

    /// Number of refusals so far.
    #[must_use]
    pub fn refused(&self) -> u32 {
        self.refused
    }

    /// Header of a report.
    #[must_use]
    pub fn header(&self, sequence: u32, tick: u32) -> Header {
        Header { version: VERSION | REPORT, tile: self.tile, boot: self.boot.unwrap_or(0), sequence, tick }
    }

    fn is_meant(&self, header: &Header) -> bool {
        let is_report = header.version & REPORT != 0;
        !is_report && (header.tile == self.tile || header.tile == EVERY_TILE)
    }

    fn refuse(&mut self, header: &Header, why: Refusal) -> (u32, Refusal) {
        self.refused = self.refused.saturating_add(1);
        (header.sequence, why)
    }

    // Cheap checks first, so that only commands that can be fresh are hashed.
    fn check(&self, received: &Received, now: u32) -> Result<(), Refusal> {
        let Header { tile, boot, sequence, tick, .. } = received.header;
        let tag = received.tag.filter(|_| tile != EVERY_TILE).ok_or(Refusal::Untagged)?;
        let ours = self.boot.ok_or(Refusal::Storage)?;
        // Ticks wrap around after 49 days, so compare their difference. Half a wrap is neither late nor early.
        let ahead = tick.wrapping_sub(now).cast_signed();
        match () {
            () if boot != ours => Err(Refusal::WrongBoot),
            () if sequence < self.next || sequence == u32::MAX => Err(Refusal::Replayed),
            () if ahead < -WINDOW.0.cast_signed() => Err(Refusal::Late),
            () if ahead > WINDOW.1.cast_signed() => Err(Refusal::Early),
            () if !self.key.vouches(&received.vouched, tag) => Err(Refusal::WrongTag),
            () => Ok(()),
        }
    }
}

/// The supervisor's counterpart: the body of a command, with its tag if it needs one.
#[must_use]
pub fn sign(header: &Header, command: &Command, key: &Key) -> Option<super::frame::Body> {
    let mut body = super::message::write(header, command)?;
    if command.needs_tag() {
        let tag = key.tag(&body);
        body.extend_from_slice(&tag).ok()?;
    }
    Some(body)
}

#[cfg(test)]
mod tests {
    use super::{Accepted, SILENCE, Session, WINDOW, sign};
    use crate::link::message::{Command, EVERY_TILE, Header, REPORT, Refusal, Target, VERSION};
    use crate::link::tag::Key;

    const KEY: Key = Key::new([3; 16]);
    const NOW: u32 = 10_000;
    const MOVE: Command = Command::Move(Target { heave: 0.01, slope_x: 0.0, slope_y: 0.0 });

    fn header(sequence: u32) -> Header {
        Header { version: VERSION, tile: 5, boot: 9, sequence, tick: NOW }
    }

    fn session() -> Session {
        Session::new(5, Some(9), KEY)
    }

    fn outcome(
        session: &mut Session,
        header: &Header,
        command: &Command,
    ) -> Result<Option<Accepted>, Refusal> {
        let body = sign(header, command, &KEY).expect("it fits");
        session.accept(&body, NOW).map_err(|(_, why)| why)
    }

    #[test]
    fn a_fresh_command_comes_through_once() {
        let mut session = session();
        let accepted = Accepted { sequence: 4, due: NOW, command: MOVE };
        assert_eq!(outcome(&mut session, &header(4), &MOVE), Ok(Some(accepted)));
        assert_eq!(outcome(&mut session, &header(4), &MOVE), Err(Refusal::Replayed));
        assert_eq!(outcome(&mut session, &header(3), &MOVE), Err(Refusal::Replayed));
        assert!(outcome(&mut session, &header(5), &MOVE).is_ok());
        assert_eq!(session.refused(), 2);
    }

    #[test]
    fn what_is_not_fresh_or_not_ours_is_refused_by_name() {
        let cases = [
            (Header { boot: 8, ..header(0) }, Refusal::WrongBoot),
            (Header { boot: 10, ..header(0) }, Refusal::WrongBoot),
            (Header { tick: NOW - WINDOW.0 - 1, ..header(0) }, Refusal::Late),
            (Header { tick: NOW + WINDOW.1 + 1, ..header(0) }, Refusal::Early),
            (Header { tick: NOW ^ 1 << 31, ..header(0) }, Refusal::Late),
            (Header { version: 2, ..header(0) }, Refusal::Version),
            (Header { tile: EVERY_TILE, ..header(0) }, Refusal::Untagged),
            (header(u32::MAX), Refusal::Replayed),
        ];
        for (header, why) in cases {
            assert_eq!(outcome(&mut session(), &header, &MOVE), Err(why), "{header:?}");
        }
        for edge in [NOW - WINDOW.0, NOW + WINDOW.1] {
            assert!(outcome(&mut session(), &Header { tick: edge, ..header(0) }, &MOVE).is_ok());
        }
    }

    #[test]
    fn other_tiles_and_reports_are_ignored() {
        let mut session = session();
        for other in [Header { tile: 6, ..header(0) }, Header { version: VERSION | REPORT, ..header(0) }] {
            assert_eq!(outcome(&mut session, &other, &MOVE), Ok(None));
        }
        assert_eq!(session.refused(), 0);
    }

    #[test]
    fn a_stop_needs_no_tag_no_boot_counter_and_no_sequence() {
        let mut session = Session::new(5, None, KEY);
        for header in [Header { boot: 0, tick: 0, ..header(0) }, Header { tile: EVERY_TILE, ..header(0) }] {
            let accepted = outcome(&mut session, &header, &Command::Stop).expect("it is let through");
            assert_eq!(accepted.map(|a| a.command), Some(Command::Stop));
        }
        assert_eq!(outcome(&mut session, &header(0), &MOVE), Err(Refusal::Storage));
    }

    #[test]
    fn untagged_commands_use_up_nothing_and_are_no_sign_of_life() {
        let mut session = session();
        let stop = sign(&header(4_000_000), &Command::Stop, &KEY).expect("it fits");
        assert!(session.accept(&stop, NOW).is_ok());
        assert!(session.is_silent(NOW));
        assert!(outcome(&mut session, &header(0), &Command::Beat(0)).is_ok());
        assert!(!session.is_silent(NOW + SILENCE));
        assert!(session.is_silent(NOW + SILENCE + 1));
    }

    #[test]
    fn a_tag_is_needed_and_must_be_of_this_key() {
        let body = sign(&header(0), &MOVE, &KEY).expect("it fits");
        let why = |body: &[u8]| session().accept(body, NOW).map_err(|(_, why)| why);
        assert_eq!(why(&body[..body.len() - 8]), Err(Refusal::Untagged));
        assert_eq!(why(&body[..body.len() - 1]), Err(Refusal::Malformed));
        let other = sign(&header(0), &MOVE, &Key::new([4; 16])).expect("it fits");
        assert_eq!(why(&other), Err(Refusal::WrongTag));
        let not_a_number = Command::Pressure(f32::NAN);
        assert_eq!(why(&sign(&header(0), &not_a_number, &KEY).expect("it fits")), Err(Refusal::NonFinite));
    }
}
