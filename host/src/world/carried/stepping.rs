//! A step of a world of flexible parts, and the inputs that can be held over it.
//!
//! In: state, length of the step, inputs. Out: the state after it, works and events. If there are contacts, the
//! runtime's step keeps the accounts; otherwise works are integrals of powers by Simpson's rule.

use super::{CarriedWorld, Place, words};
use crate::world::carriers::HostCarrier;
use crate::world::engine::Event;
use smartbed_runtime::ode::State;
use smartbed_runtime::real::Scalar;

/// Inputs that controllers can drive.
#[derive(Clone, Copy, Debug)]
pub(super) enum Drivable {
    /// The opening of a gas line: indices of the gas and of the line (supply or vent).
    Line(usize, usize),
    /// Both lines of a gas: a positive value opens the supply, a negative one the vent.
    Valves(usize),
    /// An input of a mechanism: indices of the carrier and of the input.
    Input(usize, usize),
}

impl<S: Scalar> CarriedWorld<S> {
    /// A step of motion in which no command has a kink, lines of gas shut.
    pub(super) fn move_smoothly(&mut self, h: f64, found: &mut Vec<Event>) -> Result<(), String> {
        if self.steps_as_world() {
            let (mut x, mut low) = (std::mem::take(&mut self.x), std::mem::take(&mut self.low));
            let done = self.step_touching(h, (&mut x, &mut low), false, found);
            (self.x, self.low) = (x, low);
            self.works = self.works.plus(&done.map_err(words)?.accounts.to_f64());
            self.t += h;
            return Ok(());
        }
        let (t, old) = (self.t, self.x.clone());
        let before = self.rates(t, &old).map_err(words)?;
        let first = self.powers(t, &old, h / 6.0).map_err(words)?;
        let (mut x, mut low, mut scratch) =
            (std::mem::take(&mut self.x), std::mem::take(&mut self.low), std::mem::take(&mut self.scratch));
        let method = self.ode_method();
        // An empty state: time prescribes all motion, nothing is integrated.
        let done = if x.is_empty() {
            Ok(())
        } else {
            self.with(|mut island| {
                let mut state = State::resume(&mut x, &mut low)?;
                method.step(&mut island, S::from_f64(t), S::from_f64(h), &mut state, &mut scratch).map(|_| ())
            })
        };
        (self.x, self.low, self.scratch) = (x, low, scratch);
        done.map_err(words)?;
        let new = self.x.clone();
        let after = self.rates(t + h, &new).map_err(words)?;
        let last = self.powers(t + h, &new, h / 6.0).map_err(words)?;
        let ends = old.iter().zip(&new).zip(before.iter().zip(&after));
        let (half, eighth) = (S::from_f64(0.5), S::from_f64(0.125 * h));
        let middle: Vec<S> = ends.map(|((a, b), (da, db))| half * (*a + *b) + eighth * (*da - *db)).collect();
        self.rates(t + 0.5 * h, &middle).map_err(words)?;
        let between = self.powers(t + 0.5 * h, &middle, h / 1.5).map_err(words)?;
        self.works = self.works.plus(&first.plus(&between.times(4.0)).plus(&last).times(h / 6.0));
        self.t = t + h;
        Ok(())
    }

    /// All inputs by name.
    pub(super) fn drivable(&self) -> Vec<(String, Drivable)> {
        let mut list = Vec::new();
        for (number, air) in self.airs.iter().enumerate() {
            let name = &self.names[air.part];
            for (line, own) in
                ["supply", "vent"].iter().enumerate().filter(|(line, _)| air.lines[*line].is_some())
            {
                list.push((format!("{name}.{own}"), Drivable::Line(number, line)));
            }
            if air.lines.iter().all(Option::is_some) {
                list.push((format!("{name}.valves"), Drivable::Valves(number)));
            }
        }
        for (name, place) in self.names.iter().zip(&self.places) {
            let Place::Carrier(carrier, _) = place else { continue };
            if let HostCarrier::Mechanism(ported) = &self.carriers[*carrier] {
                let inputs = ported.free_inputs();
                list.extend(
                    inputs
                        .into_iter()
                        .map(|(input, own)| (format!("{name}.{own}"), Drivable::Input(*carrier, input))),
                );
            }
        }
        list
    }

    /// Sets an input by index; returns the part that it drives, if the value has changed.
    pub(super) fn drive_input(&mut self, input: usize, value: f64) -> Option<usize> {
        let (_, what) = self.drivable().into_iter().nth(input)?;
        let mut open = |air: usize, line: usize, share: f64| {
            let Some(line) = &mut self.airs[air].lines[line] else { return false };
            let before = std::mem::replace(&mut line.opening, S::from_f64(share.clamp(0.0, 1.0)));
            before != line.opening
        };
        let changed = match what {
            Drivable::Line(air, line) => open(air, line, value),
            Drivable::Valves(air) => {
                let supply = open(air, 0, value);
                open(air, 1, -value) || supply
            }
            Drivable::Input(carrier, input) => match &mut self.carriers[carrier] {
                HostCarrier::Mechanism(ported) => ported.hold(input, S::from_f64(value)),
                _ => false,
            },
        };
        let part = match what {
            Drivable::Line(air, _) | Drivable::Valves(air) => Some(self.airs[air].part),
            Drivable::Input(carrier, _) => self
                .places
                .iter()
                .position(|place| matches!(place, Place::Carrier(own, _) if *own == carrier)),
        };
        part.filter(|_| changed)
    }
}
