//! Messages of the protocol: commands to a tile and its reports, serialised by postcard.
//!
//! In: a [`Header`] and a [`Command`] or [`Report`]. Out: a body, and back.
//! Layout of a body: header, message, and its [`tag`](super::tag) if the command needs one.
//! Numbers that are not finite, and surplus bytes, are refused here, so no later stage sees them.

use super::frame::{Body, MAX_BODY};
use super::tag::{TAG, Tag};
use serde::{Deserialize, Serialize};

/// Version of this protocol; another one is refused.
pub const VERSION: u8 = 1;
/// Marks a report in the header's version.
pub const REPORT: u8 = 0x80;
/// Address of every tile; only commands without a tag may use it.
pub const EVERY_TILE: u8 = 0xFF;

/// Header of every message.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default, Serialize, Deserialize)]
pub struct Header {
    /// [`VERSION`], with [`REPORT`] in a tile's answer.
    pub version: u8,
    /// The tile addressed, or reporting.
    pub tile: u8,
    /// Number of starts of that tile: a command from before a restart is refused.
    pub boot: u32,
    /// Counts the sender's messages since the start.
    pub sequence: u32,
    /// The tile's time (ms) at which to execute a command, or at which a report was made.
    pub tick: u32,
}

/// A command to a tile. SI units.
#[derive(Clone, Copy, PartialEq, Debug, Serialize, Deserialize)]
pub enum Command {
    /// Drives off, valves closed. Needs no tag.
    Stop,
    /// Report the state. Needs no tag.
    Status,
    /// Report the log from this entry on. Needs no tag.
    Log(u32),
    /// Report who you are. Needs no tag.
    Identify,
    /// Heartbeat of the sender, with its clock (ms).
    Beat(u32),
    /// Allow motion.
    Enable,
    /// Clear these latched faults, if their causes are gone.
    Clear(u32),
    /// Find the switches.
    Home,
    /// Move the platform.
    Move(Target),
    /// Keep this pressure over ambient in the bladder (Pa).
    Pressure(f32),
    /// Level, lower and vent, for resuscitation.
    Flatten,
    /// Take and store this calibration; drives must be off.
    Calibrate(Trim),
}

/// A pose of the platform: see [`crate::command::Pose`].
#[derive(Clone, Copy, PartialEq, Debug, Default, Serialize, Deserialize)]
pub struct Target {
    /// Mean height of the connectors (m).
    pub heave: f32,
    /// Slope along x (1).
    pub slope_x: f32,
    /// Slope along y (1).
    pub slope_y: f32,
}

/// Calibration offsets of a tile.
#[derive(Clone, Copy, PartialEq, Debug, Default, Serialize, Deserialize)]
pub struct Trim {
    /// Added to the heights that the position sensors give (m).
    pub height: [f32; 3],
    /// Added to both pressures (Pa).
    pub pressure: f32,
}

/// A report of a tile.
#[derive(Clone, Copy, PartialEq, Debug, Serialize, Deserialize)]
pub enum Report {
    /// Outcome of the command with this sequence number.
    Answer(u32, Outcome),
    /// The state.
    State(State),
    /// An entry of the log: number, tick, event.
    Entry(u32, u32, Event),
    /// Protocol, entries of the log so far, frames lost, commands refused.
    Identity(u8, u32, u32, u32),
}

/// Outcome of a command.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Serialize, Deserialize)]
pub enum Outcome {
    /// It is done, or has started.
    Done,
    /// It will be executed at its tick.
    Waits,
    /// Refused; it has no effect.
    Refused(Refusal),
}

/// Why a command is refused.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Serialize, Deserialize)]
pub enum Refusal {
    /// Another version of the protocol, or a report.
    Version,
    /// Not a complete message.
    Malformed,
    /// A number that is not finite.
    NonFinite,
    /// It needs a tag but has none, or is addressed to every tile.
    Untagged,
    /// The tag was not made with this tile's key.
    WrongTag,
    /// From before the tile's restart.
    WrongBoot,
    /// Its sequence number has been used.
    Replayed,
    /// Its tick is too far in the past.
    Late,
    /// Its tick is too far in the future.
    Early,
    /// No room among the waiting commands.
    Full,
    /// Not allowed in this mode.
    Mode,
    /// A fault is latched.
    Faulted,
    /// A motion is in progress: stop it first.
    Busy,
    /// A height would leave the stroke.
    Stroke,
    /// The tilt would be too steep.
    Tilt,
    /// The pressure is outside the allowed range.
    Pressure,
    /// The cause of a fault is still there, or it cannot be cleared.
    Cause,
    /// The boot counter could not be stored, so no tag is fresh.
    Storage,
    /// An offset larger than any sound sensor needs.
    Trim,
}

impl Refusal {
    /// The reason in words, as the end of a sentence.
    #[must_use]
    pub fn words(self) -> &'static str {
        match self {
            Self::Version => "it is of another version of the protocol",
            Self::Malformed => "the message is incomplete",
            Self::NonFinite => "a number is not finite",
            Self::Untagged => "it has no tag",
            Self::WrongTag => "its tag was made with another key",
            Self::WrongBoot => "it is from before the tile's restart",
            Self::Replayed => "it was sent before",
            Self::Late => "it comes too late",
            Self::Early => "its time is too far ahead",
            Self::Full => "too many commands wait already",
            Self::Mode => "it is not allowed in this mode",
            Self::Faulted => "a fault is latched",
            Self::Busy => "a motion is in progress",
            Self::Stroke => "a height would leave the stroke",
            Self::Tilt => "the tilt would be too steep",
            Self::Pressure => "the pressure is outside the allowed range",
            Self::Cause => "the cause of a fault is still there, or it cannot be cleared",
            Self::Storage => "the number of starts could not be stored",
            Self::Trim => "the offset is larger than any sound sensor needs",
        }
    }
}

/// An event of the log.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Serialize, Deserialize)]
pub enum Event {
    /// The tile has started, for this reason.
    Started(u8),
    /// These faults are new.
    Faults(u32),
    /// These faults were cleared.
    Cleared(u32),
    /// A command of this sequence number was refused.
    Refused(u32, Refusal),
    /// The mode has changed to this one.
    Mode(u8),
}

/// State of a tile. SI units.
#[derive(Clone, Copy, PartialEq, Debug, Default, Serialize, Deserialize)]
pub struct State {
    /// Number of the mode.
    pub mode: u8,
    /// Latched faults, a bit each.
    pub faults: u32,
    /// Heights of the connectors (m).
    pub heights: [f32; 3],
    /// Heights commanded now (m).
    pub wanted: [f32; 3],
    /// Duty of the drives (-1 to 1).
    pub duty: [f32; 3],
    /// Pressure over ambient (Pa).
    pub pressure: f32,
    /// Mass that the bladder carries (kg).
    pub load: f32,
    /// Bits: drives enabled, supply valve open, vent open, homed, motion allowed.
    pub flags: u8,
}

impl Command {
    /// Whether it needs a tag: all commands do, except those that stop or ask.
    #[must_use]
    pub fn needs_tag(&self) -> bool {
        !matches!(self, Self::Stop | Self::Status | Self::Log(_) | Self::Identify)
    }

    fn is_finite(&self) -> bool {
        match self {
            Self::Move(t) => t.heave.is_finite() && t.slope_x.is_finite() && t.slope_y.is_finite(),
            Self::Pressure(p) => p.is_finite(),
            Self::Calibrate(t) => t.height.iter().all(|h| h.is_finite()) && t.pressure.is_finite(),
            _ => true,
        }
    }
}

/// A received command whose tag has not been checked yet.
#[derive(Clone, PartialEq, Debug)]
pub struct Received {
    /// Its header.
    pub header: Header,
    /// What is asked for.
    pub command: Command,
    /// Its tag, if it has one.
    pub tag: Option<Tag>,
    /// The bytes that the tag authenticates.
    pub vouched: Body,
}

/// Reads a command.
///
/// # Errors
/// [`Refusal::Version`], [`Refusal::Malformed`], [`Refusal::NonFinite`], with the header if there is one.
pub fn read(body: &[u8]) -> Result<Received, (Header, Refusal)> {
    let (header, rest) =
        postcard::take_from_bytes::<Header>(body).map_err(|_| (Header::default(), Refusal::Malformed))?;
    if header.version != VERSION {
        return Err((header, Refusal::Version));
    }
    let (command, rest) =
        postcard::take_from_bytes::<Command>(rest).map_err(|_| (header, Refusal::Malformed))?;
    if !command.is_finite() {
        return Err((header, Refusal::NonFinite));
    }
    let tag = match rest.len() {
        0 => None,
        TAG => Some(rest.first_chunk().copied().ok_or((header, Refusal::Malformed))?),
        _ => return Err((header, Refusal::Malformed)),
    };
    let vouched = body.len().checked_sub(rest.len()).and_then(|end| body.get(..end)).unwrap_or_default();
    let vouched = Body::from_slice(vouched).map_err(|_| (header, Refusal::Malformed))?;
    Ok(Received { header, command, tag, vouched })
}

/// The body of a header and a message; None if it is too long, which no message of ours is.
#[must_use]
pub fn write<M: Serialize>(header: &Header, message: &M) -> Option<Body> {
    let mut bytes = [0_u8; MAX_BODY];
    let used = postcard::to_slice(&(header, message), &mut bytes).ok()?;
    Body::from_slice(used).ok()
}

/// Reads a report.
#[must_use]
pub fn read_report(body: &[u8]) -> Option<(Header, Report)> {
    let (header, rest) = postcard::take_from_bytes::<Header>(body).ok()?;
    if header.version != VERSION | REPORT {
        return None;
    }
    let (report, rest) = postcard::take_from_bytes::<Report>(rest).ok()?;
    rest.is_empty().then_some((header, report))
}
