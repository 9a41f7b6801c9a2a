//! Frames of a motion, thinned out as they become many, and the page's data made from them.
//!
//! Numbers are stored as 16 bits between the least and the largest value: finer than any screen, and the page stays
//! below 2 MB however long the run.

use super::stage::Stage;
use crate::contact_force::ContactForce;
use serde_json::{Value, json};

/// Most numbers in all frames together; 16 bits take 8/3 letters of base64.
const NUMBERS: usize = 300_000;
/// Most and fewest frames.
const FRAMES: [usize; 2] = [1200, 60];
/// Most contacts in all frames together, ten numbers each, and the fewest of one frame; the strongest are kept.
const CONTACTS: [usize; 2] = [6000, 5];

/// A curve that the page shows beside the motion.
#[derive(Clone, Debug)]
pub struct Series {
    /// Its name.
    pub name: String,
    /// Quantity and unit: curves of one group share axes.
    pub group: String,
    /// Divisor of the values: SI units per unit shown.
    pub factor: f64,
}

/// A moment.
#[derive(Clone, Debug)]
struct Frame {
    t: f64,
    numbers: Vec<f64>,
    forces: Vec<ContactForce>,
}

/// Frames so far.
#[derive(Clone, Debug)]
pub struct Film {
    stage: Stage,
    series: Vec<Series>,
    first: Vec<f64>,
    frames: Vec<Frame>,
    most: usize,
    stride: usize,
    seen: usize,
    /// Is the last frame kept only until the next one comes? It is not a multiple of the stride.
    is_end: bool,
}

impl Film {
    /// Without frames.
    #[must_use]
    pub fn new(stage: Stage, series: Vec<Series>) -> Self {
        let width = (stage.moving + series.len()).max(1);
        let most = (NUMBERS / width).clamp(FRAMES[1], FRAMES[0]);
        Self { stage, series, first: Vec::new(), frames: Vec::new(), most, stride: 1, seen: 0, is_end: false }
    }

    /// Adds a frame: time, positions as the stage expects them, contacts, a value for every curve.
    pub fn push(
        &mut self,
        t: f64,
        places: &[f64],
        forces: &[ContactForce],
        values: impl IntoIterator<Item = f64>,
    ) {
        if self.seen == 0 {
            self.first = places.to_vec();
        }
        // A page shows a run to its end: the last frame stays, whatever the stride.
        if self.is_end {
            self.frames.pop();
        }
        self.is_end = !self.seen.is_multiple_of(self.stride);
        let mut numbers = places[..self.stage.moving.min(places.len())].to_vec();
        numbers.extend(values.into_iter().zip(&self.series).map(|(x, s)| x / s.factor));
        let forces = if self.stage.has_forces() { forces.to_vec() } else { Vec::new() };
        self.frames.push(Frame { t, numbers, forces });
        if self.frames.len() > self.most {
            self.thin();
        }
        self.seen += 1;
    }

    /// Doubles the stride: every second frame is dropped, but for the last one.
    fn thin(&mut self) {
        self.stride *= 2;
        self.is_end = !self.seen.is_multiple_of(self.stride);
        let (mut n, last) = (0, self.frames.len());
        self.frames.retain(|_| {
            n += 1;
            n % 2 == 1 || n == last
        });
    }

    /// The page's data as JSON.
    #[must_use]
    pub fn data(&self, title: &str, note: &str, events: &[(f64, String)]) -> String {
        let moving = self.stage.moving;
        let columns: Vec<Column> = (0..moving + self.series.len()).map(|n| self.column(n)).collect();
        let (places, curves) = columns.split_at(moving);
        let mut motion = Vec::with_capacity(2 * moving * self.frames.len());
        for frame in 0..self.frames.len() {
            motion.extend(places.iter().flat_map(|c| c.words[frame].to_le_bytes()));
        }
        // An account that stays 0 is left out.
        let told = |column: &Column| column.low != 0.0 || column.high != 0.0;
        let shown = self.series.iter().zip(curves).filter(|(s, c)| s.group != "energy [J]" || told(c));
        let series = shown.map(|(series, column)| {
            let words: Vec<u8> = column.words.iter().flat_map(|w| w.to_le_bytes()).collect();
            json!({"name": series.name, "group": series.group, "low": column.low, "high": column.high,
                "words": base64(&words)})
        });
        let mut data = self.stage.data(&self.first);
        data["title"] = json!(title);
        data["note"] = json!(note);
        data["events"] = json!(events);
        data["times"] = self.frames.iter().map(|frame| json!(frame.t)).collect();
        data["low"] = places.iter().map(|c| json!(c.low)).collect();
        data["high"] = places.iter().map(|c| json!(c.high)).collect();
        data["motion"] = json!(base64(&motion));
        data["series"] = Value::Array(series.collect());
        (data["contacts"], data["forces"]) = self.contacts();
        data.to_string()
    }

    /// Number of contacts per frame; for each contact the point, the forces along and across its normal, and 1 if it is
    /// between two bodies that are both pushed.
    fn contacts(&self) -> (Value, Value) {
        let most = (CONTACTS[0] / self.frames.len().max(1)).max(CONTACTS[1]);
        let (mut counts, mut bytes) = (Vec::new(), Vec::new());
        for frame in &self.frames {
            let mut forces = frame.forces.clone();
            forces.sort_by(|a, b| b.size().total_cmp(&a.size()));
            forces.truncate(most);
            counts.push(forces.len());
            for force in &forces {
                let numbers = [force.point, force.normal, force.friction];
                let both = f64::from(u8::from(force.on_both));
                let all = numbers.as_flattened().iter().copied().chain([both]);
                bytes.extend(all.flat_map(|x| (x as f32).to_le_bytes()));
            }
        }
        (json!(counts), json!(base64(&bytes)))
    }

    /// One number over all frames; values that are not finite become 0.
    fn column(&self, n: usize) -> Column {
        let value = |frame: &Frame| frame.numbers.get(n).copied().filter(|x| x.is_finite()).unwrap_or(0.0);
        let range = self.frames.iter().map(value);
        let (low, high) = range.fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), x| (l.min(x), h.max(x)));
        let (low, high) = if low <= high { (low, high) } else { (0.0, 0.0) };
        let step = (high - low) / f64::from(u16::MAX);
        let word = |x: f64| if step > 0.0 { ((x - low) / step).round() as u16 } else { 0 };
        Column { low, high, words: self.frames.iter().map(|frame| word(value(frame))).collect() }
    }
}

/// Numbers as fractions of their range.
struct Column {
    low: f64,
    high: f64,
    words: Vec<u16>,
}

/// Bytes as base64 (RFC 4648).
pub(crate) fn base64(bytes: &[u8]) -> String {
    const LETTERS: &[u8; 64] = b"ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    let mut text = String::with_capacity(bytes.len().div_ceil(3) * 4);
    for three in bytes.chunks(3) {
        let word = (0..3).fold(0_u32, |w, n| w << 8 | u32::from(three.get(n).copied().unwrap_or(0)));
        for n in 0..4 {
            let letter = LETTERS[(word >> (18 - 6 * n)) as usize & 63];
            text.push(if n <= three.len() { char::from(letter) } else { '=' });
        }
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_last_frame_is_kept_whatever_the_length() {
        for count in [1, 2, 60, 1199, 1200, 1201, 1202, 2401, 2402, 4802, 10_000] {
            let stage = Stage {
                fixed: json!({}),
                bodies: Vec::new(),
                shapes: Vec::new(),
                gravity: None,
                moving: 3,
                forces: false,
            };
            let mut film = Film::new(stage, Vec::new());
            for row in 0..count {
                film.push(f64::from(row), &[0.0; 3], &[], []);
            }
            let times: Vec<f64> = film.frames.iter().map(|frame| frame.t).collect();
            assert!(times.len() <= film.most, "{count}: {}", times.len());
            assert_eq!((times.first(), times.last()), (Some(&0.0), Some(&f64::from(count - 1))), "{count}");
            // Only the last step may be shorter.
            let mut steps: Vec<f64> = times.windows(2).map(|t| t[1] - t[0]).collect();
            let end = steps.pop().unwrap_or(1.0);
            assert!(steps.iter().all(|s| *s == film.stride as f64) && end <= film.stride as f64, "{count}");
        }
    }

    #[test]
    fn bytes_are_encoded_as_the_standard_says() {
        // RFC 4648, section 10.
        for (bytes, text) in
            [("", ""), ("f", "Zg=="), ("fo", "Zm8="), ("foo", "Zm9v"), ("foobar", "Zm9vYmFy")]
        {
            assert_eq!(base64(bytes.as_bytes()), text);
        }
    }
}
