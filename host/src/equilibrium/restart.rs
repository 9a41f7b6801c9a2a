//! Starts the search for an equilibrium again where Newton's method ends without one, or outside the ranges.
//!
//! In: the search where it starts. Out: the equilibrium to which it leads from there; if it leads to none within the
//! ranges that the model states, the nearest of those found from places spread evenly over the ranges; if there is
//! none, the end from the start.

use super::rates::NO_SLOPE;
use super::search::{End, Entry, Found, Place, Rates, Search, Unknown};

/// Number of places.
const PLACES: usize = 64;
/// Number of places at which it is looked up which coordinates the rates depend on.
const PROBES: usize = 4;
/// Values (SI) from which inputs are searched for that have no slope at 0.
const OTHER_INPUTS: [f64; 3] = [1.0, -1.0, 1e3];
/// A range is a whole turn up to this fraction.
const ROUNDING: f64 = 1e-9;
const TURN: f64 = std::f64::consts::TAU;

impl Search<'_> {
    /// Runs the search.
    pub fn find(&mut self) -> Result<Found, String> {
        self.assemble_held()?;
        let here = self
            .rates()
            .map_err(|why| format!("where the search starts {why}; give another start by --set"))?;
        let start = self.place();
        let first = self.settle(here);
        if self.unknown == Unknown::Inputs {
            let end = self.trimmed_elsewhere(&start, first);
            return self.result(end);
        }
        let (first, is_within) = self.within_ranges(first);
        if is_within {
            return self.result(first);
        }
        let mut nearest = (f64::INFINITY, self.place(), first);
        for place in self.other_places(&start) {
            if self.go_to(&start, &place)
                && let Ok(here) = self.rates()
            {
                let found = self.settle(here);
                let (found, is_within) = self.within_ranges(found);
                let distance = self.distance(&start);
                if is_within && distance < nearest.0 {
                    nearest = (distance, self.place(), found);
                }
            }
        }
        self.return_to(nearest.1);
        self.result(nearest.2)
    }

    /// The end of a search for inputs; if it is no equilibrium, that from other values of inputs without a slope at 0,
    /// such as the speed of a rotor whose thrust goes with its square.
    fn trimmed_elsewhere(&mut self, start: &Place, first: End) -> End {
        if first.fault.is_none() {
            return first;
        }
        let ended = self.place();
        self.return_to(start.clone());
        let idle: Vec<usize> = match self.rates() {
            Ok(here) => {
                self.free_inputs.iter().copied().filter(|&i| here.slopes.b.column(i).amax() == 0.0).collect()
            }
            Err(_) => Vec::new(),
        };
        for value in OTHER_INPUTS {
            self.return_to(start.clone());
            idle.iter().for_each(|&i| self.inputs[i] = value);
            if let Ok(here) = self.rates() {
                let end = self.settle(here);
                if end.fault.is_none() {
                    return end;
                }
            }
        }
        self.return_to(ended);
        first
    }

    /// How far the coordinates are from the start, in units of half their ranges.
    fn distance(&self, start: &Place) -> f64 {
        let free = self.state.iter().filter(|entry| entry.is_free_coordinate());
        let ways = free.map(|entry| (self.q[entry.place] - start.0[entry.place]) / entry.scale);
        ways.map(|way| way * way).sum::<f64>().sqrt()
    }

    /// The end of a search, if need be after whole turns of angles, and whether it is an equilibrium within the ranges.
    fn within_ranges(&mut self, end: End) -> (End, bool) {
        if end.fault.is_some() {
            return (end, false);
        }
        let before = self.place();
        if self.turn_back()
            && let Ok(here) = self.rates()
        {
            let turned = self.settle(here);
            if turned.fault.is_none() && self.is_in_ranges() {
                return (turned, true);
            }
        }
        self.return_to(before);
        (end, self.is_in_ranges())
    }

    /// Are all coordinates that were searched for within the ranges that the model states?
    fn is_in_ranges(&self) -> bool {
        let outside = |entry: &&Entry| {
            let ((low, high), q) = (entry.range, self.q[entry.place]);
            entry.is_free_coordinate() && entry.states_range && !(low..=high).contains(&q)
        };
        !self.state.iter().any(|entry| outside(&entry))
    }

    /// What to say of coordinates outside the ranges that the model states, unless they are held there.
    pub fn outside(&self) -> Option<String> {
        let is_held = |place| self.state.iter().any(|e| !e.is_speed && e.place == place && e.is_held);
        let all = self.program.q.iter().zip(&self.ranges).zip(&self.q).enumerate();
        let named = all.filter_map(|(place, ((quantity, &((low, high), is_stated)), &q))| {
            let slack = ROUNDING * (high - low);
            let is_outside = !(low - slack..=high + slack).contains(&q);
            let is_whole_turn = quantity.unit == "rad" && high - low >= TURN * (1.0 - ROUNDING);
            let counts = is_stated && is_outside && !is_whole_turn && !is_held(place);
            let unit = if quantity.unit == "1" { String::new() } else { format!(" {}", quantity.unit) };
            counts.then(|| format!("`{}` = {q:.4} (range {low:.4} to {high:.4}{unit})", quantity.name))
        });
        let named: Vec<String> = named.collect();
        (!named.is_empty() && self.unknown == Unknown::State).then(|| {
            format!("the equilibrium is outside of ranges that the model states: {}", named.join(", "))
        })
    }

    /// Turns angles that have left a range of a whole turn or more back into it; false if there are none.
    fn turn_back(&mut self) -> bool {
        let mut q = self.q.clone();
        for entry in self.state.iter().filter(|entry| entry.is_free_coordinate()) {
            let ((low, high), angle) = (entry.range, &mut q[entry.place]);
            let is_angle = self.program.q[entry.place].unit == "rad";
            if is_angle && high - low >= TURN * (1.0 - ROUNDING) && !(low..=high).contains(angle) {
                *angle -= TURN * ((*angle - 0.5 * (low + high)) / TURN).round();
            }
        }
        if q == self.q {
            return false;
        }
        let assembled = self.configurations.follow(0.0, &q, &q);
        assembled.map(|q| self.q = q).is_ok()
    }

    /// Other values of the coordinates on which the rates depend.
    fn other_places(&mut self, start: &Place) -> Vec<Vec<(usize, f64)>> {
        let has_range = |entry: &Entry| {
            let width = entry.range.1 - entry.range.0;
            entry.is_free_coordinate() && width > 0.0 && width.is_finite()
        };
        let mut moved: Vec<usize> = (0..self.state.len()).filter(|&i| has_range(&self.state[i])).collect();
        let places = |this: &Self, moved: &[usize]| -> Vec<Vec<(usize, f64)>> {
            let ranges: Vec<(f64, f64)> = moved.iter().map(|&i| this.state[i].range).collect();
            let named = |place: Vec<f64>| moved.iter().map(|&i| this.state[i].place).zip(place).collect();
            around(&ranges).into_iter().map(named).collect()
        };
        // At one place a slope may vanish, as by a symmetry of the first, which is the middle of all ranges.
        let all = places(self, &moved);
        let reached =
            all.iter().filter_map(|place| if self.go_to(start, place) { self.rates().ok() } else { None });
        let probes: Vec<Rates> = reached.take(PROBES).collect();
        let counts = |i: usize| {
            let mut slopes = probes.iter().map(|rates| &rates.slopes.a);
            slopes.any(|a| a.column(i).amax() > NO_SLOPE * a.amax())
        };
        if !probes.is_empty() {
            moved.retain(|&i| counts(i));
        }
        if moved.is_empty() { Vec::new() } else { places(self, &moved) }
    }

    /// Goes to the start with these values of coordinates, given by their indices in q; false if that cannot be
    /// assembled.
    fn go_to(&mut self, start: &Place, values: &[(usize, f64)]) -> bool {
        let mut q = start.0.clone();
        values.iter().for_each(|&(place, value)| q[place] = value);
        let Ok(q) = self.configurations.follow(0.0, &start.0, &q) else { return false };
        self.return_to((q, start.1.clone(), start.2.clone()));
        true
    }
}

/// The places, each with a value for every coordinate.
fn around(ranges: &[(f64, f64)]) -> Vec<Vec<f64>> {
    let ratio = ratio(ranges.len());
    let place = |n: usize| -> Vec<f64> {
        let mut step = 1.0;
        let mut along = |&(low, high): &(f64, f64)| {
            step /= ratio;
            low + (high - low) * (0.5 + n as f64 * step).fract()
        };
        ranges.iter().map(&mut along).collect()
    };
    (0..PLACES).map(place).collect()
}

/// The root above 1 of x^(n + 1) = x + 1, for one coordinate the golden section. Fractional parts of multiples of its
/// negative powers fill a box of n dimensions evenly.
fn ratio(n: usize) -> f64 {
    (0..60).fold(1.5, |x: f64, _| (1.0 + x).powf(1.0 / (n + 1) as f64))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn places_lie_close_to_every_point_of_the_ranges() {
        let places = around(&[(-1.0, 3.0), (0.0, 0.1)]);
        assert!(places.iter().all(|p| (-1.0..3.0).contains(&p[0]) && (0.0..0.1).contains(&p[1])));
        let apart = |p: &[f64], x: f64, y: f64| ((p[0] - x) / 2.0).hypot((p[1] - y) / 0.05);
        for (x, y) in (0..=20).flat_map(|i| (0..=20).map(move |j| (i, j))) {
            let (x, y) = (f64::from(x) * 0.2 - 1.0, f64::from(y) * 0.005);
            let nearest = places.iter().map(|p| apart(p, x, y)).fold(f64::INFINITY, f64::min);
            assert!(nearest < 0.35, "({x}, {y}): {nearest}");
        }
    }
}
