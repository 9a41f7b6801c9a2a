//! Events of a mechanism's motion, for the page of `--view` and for plots: an independent coordinate reverses, a
//! coordinate leaves its declared range or returns.
//!
//! In: rows one after the other. Out: times and texts. Between rows a speed is interpolated linearly: a reversal is at
//! t* = t + h |u| / (|u| + |u'|), u' the speed of the next row, and the coordinate there is q + u (t* - t)/2.

use super::health::Range;
use smartbed_codegen::model::{Model, SpeedMeaning};
use std::collections::BTreeMap;

/// Most events; a page lists no more than this.
const MOST: usize = 400;
/// A coordinate that moves less than this between two reversals (rad or m, relative above 1) is at rest.
const REST: f64 = 1e-6;

/// A coordinate that is watched.
#[derive(Clone, Debug)]
struct Watched {
    name: String,
    /// Index in a row: of the coordinate, and of its speed if it is watched for reversals.
    place: usize,
    speed: Option<usize>,
    /// Unit as declared, and how many SI units make one.
    unit: (String, f64),
    range: Option<Range>,
    is_outside: bool,
    /// Its value at the last reversal.
    turned: Option<f64>,
}

/// The list as it grows.
#[derive(Clone, Debug)]
pub struct Events {
    watched: Vec<Watched>,
    last: Vec<f64>,
    found: Vec<(f64, String)>,
    crossings: Vec<f64>,
}

impl Events {
    /// Without events; `names` are those of a row's numbers, time first.
    #[must_use]
    pub fn new(model: &Model, names: &[String], ranges: &BTreeMap<String, Range>) -> Self {
        let place = |name: &str| names.iter().position(|n| n == name);
        let speed = |wanted: &str| {
            let is_rate = |s: &&smartbed_codegen::model::Speed| match s.meaning {
                SpeedMeaning::RateOf(id) => model.coordinates[id].name == wanted,
                SpeedMeaning::Combination(_) => false,
            };
            model.speeds.iter().find(is_rate).and_then(|s| place(&s.name))
        };
        let watched = model.coordinates.iter().filter_map(|c| {
            Some(Watched {
                place: place(&c.name)?,
                speed: speed(&c.name).filter(|_| c.independent),
                unit: c.written_unit.clone(),
                range: ranges.get(&c.name).cloned(),
                name: c.name.clone(),
                is_outside: false,
                turned: None,
            })
        });
        Self { watched: watched.collect(), last: Vec::new(), found: Vec::new(), crossings: Vec::new() }
    }

    /// The next row.
    pub fn row(&mut self, values: &[f64]) {
        for watched in &mut self.watched {
            self.found.extend(watched.turn(&self.last, values));
            let crossing = watched.range(values);
            self.crossings.extend(crossing.iter().map(|(t, _)| *t));
            self.found.extend(crossing);
        }
        self.last.clear();
        self.last.extend_from_slice(values);
    }

    /// Times at which a coordinate left its declared range or returned, in order; thinned out if there are many.
    #[must_use]
    pub fn crossings(&self) -> Vec<f64> {
        let mut times: Vec<f64> = self.crossings.iter().copied().take(MOST).collect();
        times.dedup();
        times
    }

    /// The events in order of time.
    #[must_use]
    pub fn finish(mut self) -> Vec<(f64, String)> {
        self.found.sort_by(|a, b| a.0.total_cmp(&b.0));
        let more = self.found.len().saturating_sub(MOST);
        self.found.truncate(MOST);
        if more > 0
            && let Some((t, _)) = self.found.last()
        {
            self.found.push((*t, format!("and {more} more")));
        }
        self.found
    }
}

impl Watched {
    fn shown(&self, value: f64) -> String {
        let (unit, factor) = &self.unit;
        let unit = if unit == "1" { "" } else { unit };
        format!("{:.4} {unit}", value / factor).trim_end().to_owned()
    }

    fn turn(&mut self, last: &[f64], now: &[f64]) -> Option<(f64, String)> {
        let speed = self.speed?;
        let (t, before, end, after) = (*last.first()?, *last.get(speed)?, *now.first()?, *now.get(speed)?);
        let turns = before * after < 0.0 || (before != 0.0 && after == 0.0);
        if !turns {
            return None;
        }
        let at = t + (end - t) * before.abs() / (before.abs() + after.abs());
        let q = last.get(self.place)? + 0.5 * before * (at - t);
        let moved = self.turned.is_none_or(|known| (q - known).abs() > REST * known.abs().max(1.0));
        self.turned = Some(q);
        moved.then(|| (at, format!("{} turns at {}", self.name, self.shown(q))))
    }

    fn range(&mut self, now: &[f64]) -> Option<(f64, String)> {
        let (t, q) = (*now.first()?, *now.get(self.place)?);
        let is_outside = self.range.as_ref()?.excess(q) > 0.0;
        if is_outside == self.is_outside {
            return None;
        }
        self.is_outside = is_outside;
        let what = if is_outside { "leaves" } else { "returns to" };
        Some((t, format!("{} {what} its range at {}", self.name, self.shown(q))))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_swing_turns_at_its_amplitude_and_leaves_its_range() {
        // q = 0.3 cos(2 t) rad: turns at multiples of pi/2 s, first at -0.3 rad; the range ends at 0.2 rad.
        let text = "format = 1\nname = \"m\"\n[coordinates]\nq = { unit = \"deg\", independent = true, range = [-60, 11.459] }\n\
                    [points]\nP = \"1_m*rod.x\"\n[frames]\nrod = { rotations = [[\"z\", \"q\"]] }\n[bodies]\nb = { centre = \"P\", mass = \"1_kg\" }\n";
        let model = smartbed_codegen::model::parse("m.toml", text).expect("a model");
        let names: Vec<String> = ["t", "q", "u_q"].map(str::to_owned).to_vec();
        let range = Range { ends: (-1.0, 0.2), unit: ("deg".to_owned(), 1.0), is_angle: false };
        let mut events = Events::new(&model, &names, &BTreeMap::from([("q".to_owned(), range)]));
        for n in 0..330 {
            let t = 0.01 * f64::from(n);
            events.row(&[t, 0.3 * (2.0 * t).cos(), -0.6 * (2.0 * t).sin()]);
        }
        let found = events.finish();
        let words: Vec<&str> = found.iter().map(|(_, w)| w.split(" at ").next().unwrap_or("")).collect();
        assert_eq!(
            words,
            ["q leaves its range", "q returns to its range", "q turns", "q leaves its range", "q turns"]
        );
        assert!((found[2].0 - 0.5 * std::f64::consts::PI).abs() < 1e-4, "{found:?}");
        assert!(found[2].1.starts_with("q turns at -17.18"), "{found:?}");
        // cos(2 t) = 2/3 at t = 0.4205 s: the first row after it.
        assert!((found[1].0 - 0.43).abs() < 1e-9, "{found:?}");
    }
}
