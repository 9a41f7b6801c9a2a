//! Reports of tiles as text or JSON, and heights as a line of the terminal.

use super::bus::Received;
use serde_json::{Value, json};
use smartbed_firmware::link::message::{Event, Outcome, Refusal, Report, State};
use smartbed_firmware::tile::design::STROKE;
use smartbed_firmware::tile::fault::Faults;
use smartbed_firmware::tile::mode::Mode;
use smartbed_firmware::tile::motion::pose;

/// Characters of a line that shows heights.
const COLUMNS: usize = 49;

/// The text for a tile's margin of self-locking, which it sends at its start.
#[must_use]
pub fn margin(margin: f64) -> String {
    let word = if margin > 0.0 { "hold" } else { "DO NOT HOLD" };
    format!("screws {word} their load without power: margin {margin:.3} at the lowest friction\n")
}

/// The same as JSON.
#[must_use]
pub fn start(margin: f64) -> String {
    format!("{}\n", json!({ "kind": "start", "time": 0.0, "margin": margin }))
}

/// The line for a report, if it has one: in JSON every report; as text all but telemetry, which comes ten times a
/// second and is only drawn.
#[must_use]
pub fn line_of(received: &Received, plots: bool, as_json: bool) -> Option<String> {
    if as_json {
        return Some(format!("{}\n", object(received)));
    }
    let Received { tile, time, report, is_asked } = received;
    let text = match report {
        Report::State(state) if *is_asked => describe(state),
        Report::State(state) if plots && state.flags & 1 == 1 => line(state),
        Report::State(_) => return None,
        Report::Answer(sequence, Outcome::Refused(why)) => refusal(*sequence, *why),
        Report::Answer(..) => return None,
        Report::Entry(number, tick, event) => format!("log {number} at {tick} ms: {}", entry(event)),
        Report::Identity(protocol, entries, lost, refused) => {
            format!(
                "protocol {protocol}, {entries} log entries, {lost} frames lost, {refused} commands refused"
            )
        }
    };
    Some(format!("{:>9.3} s  tile {tile}  {text}\n", f64::from(*time) * 1e-3))
}

/// A report as an object of `docs/json.schema.json`.
fn object(received: &Received) -> Value {
    let mut object = match &received.report {
        Report::State(state) => json!({
            "kind": "state",
            "mode": mode(state.mode),
            "faults": names(state.faults),
            "heights": state.heights,
            "wanted": state.wanted,
            "duties": state.duty,
            "pressure": state.pressure,
            "load": state.load,
            "enabled": state.flags & 1 != 0,
            "supply": state.flags & 2 != 0,
            "vent": state.flags & 4 != 0,
            "homed": state.flags & 8 != 0,
            "armed": state.flags & 16 != 0,
        }),
        Report::Answer(sequence, outcome) => {
            json!({ "kind": "answer", "sequence": sequence, "outcome": told(*outcome) })
        }
        Report::Entry(number, tick, event) => {
            json!({ "kind": "entry", "number": number, "tick": tick, "event": entry(event) })
        }
        Report::Identity(protocol, entries, lost, refused) => json!({
            "kind": "identity", "protocol": protocol, "entries": entries, "lost": lost, "refused": refused,
        }),
    };
    object["time"] = json!(f64::from(received.time) * 1e-3);
    object["tile"] = json!(received.tile);
    object
}

fn describe(state: &State) -> String {
    let at = pose(state.heights);
    let tilt = |slope: f32| f64::from(slope).atan().to_degrees();
    let valve = match state.flags >> 1 & 3 {
        0 => "shut",
        1 => "filling",
        _ => "venting",
    };
    format!(
        "{}: heave {:.3} mm, tilt {:.3} {:.3} deg, {:.3} kPa ({valve}), at most {:.1} kg{}{}",
        mode(state.mode),
        f64::from(at.zc) * 1e3,
        tilt(at.tx),
        tilt(at.ty),
        f64::from(state.pressure) * 1e-3,
        state.load,
        if state.flags & 8 == 0 { ", not homed" } else { "" },
        faults(state.faults),
    )
}

/// The three heights between the ends of the stroke.
fn line(state: &State) -> String {
    let mut columns = vec![' '; COLUMNS];
    columns[COLUMNS / 2] = '.';
    for (height, name) in state.heights.iter().zip(['A', 'B', 'C']) {
        let share = f64::from((height / STROKE).clamp(-1.0, 1.0)) * 0.5 + 0.5;
        columns[(share * (COLUMNS - 1) as f64).round() as usize] = name;
    }
    let columns: String = columns.into_iter().collect();
    format!("|{columns}| {:.2} kPa", f64::from(state.pressure) * 1e-3)
}

fn entry(event: &Event) -> String {
    match event {
        Event::Started(reason) => format!("started, reason {reason}"),
        Event::Faults(bits) => format!("new{}", faults(*bits)),
        Event::Cleared(bits) => format!("cleared{}", faults(*bits)),
        Event::Refused(sequence, why) => refusal(*sequence, *why),
        Event::Mode(number) => mode(*number).to_owned(),
    }
}

fn refusal(sequence: u32, why: Refusal) -> String {
    format!("command {sequence} refused: {}", why.words())
}

/// The outcome of a command in words.
fn told(outcome: Outcome) -> String {
    match outcome {
        Outcome::Done => "done".to_owned(),
        Outcome::Waits => "waits for its time".to_owned(),
        Outcome::Refused(why) => format!("refused: {}", why.words()),
    }
}

fn mode(number: u8) -> &'static str {
    Mode::ALL.get(usize::from(number)).map_or("unknown mode", |mode| mode.name())
}

fn faults(bits: u32) -> String {
    let names = names(bits);
    if names.is_empty() { String::new() } else { format!(", faults: {}", names.join(", ")) }
}

fn names(bits: u32) -> Vec<&'static str> {
    Faults::from_bits(bits).names().collect()
}

#[cfg(test)]
mod tests {
    use super::{line, line_of};
    use crate::tile::bus::Received;
    use smartbed_firmware::link::message::{Event, Report, State};

    #[test]
    fn states_are_told_in_words_and_drawn() {
        let state = State { mode: 4, faults: 1, heights: [0.029, 0.0, -0.029], flags: 8, ..State::default() };
        let told = Received { tile: 3, time: 1001, report: Report::State(state), is_asked: true };
        let text = line_of(&told, false, false).unwrap();
        assert!(text.contains("1.001 s  tile 3  ready") && text.contains("faults: Height"), "{text}");
        assert_eq!(line_of(&Received { is_asked: false, ..told }, false, false), None, "telemetry");
        let drawn = line(&state);
        assert!(drawn.starts_with("|C") && drawn.contains("A| 0.00 kPa"), "{drawn}");
        let entry =
            line_of(&Received { report: Report::Entry(7, 4, Event::Mode(8)), ..told }, true, false).unwrap();
        assert!(entry.contains("log 7 at 4 ms: off"), "{entry}");
    }
}
