//! Finds what went wrong in a run in which no step was refused; observed all along, reported once at the end.
//!
//! In: coordinates and energies, row by row. Out: one line per kind of finding. It observes; no step is changed.

use crate::number::worst;
use smartbed_codegen::words;
use std::collections::BTreeMap;

/// Largest admitted imbalance of the ledger, as a fraction of the energy that moved (kinetic, stored, worked).
const IMBALANCE: f64 = 1e-3;
/// An imbalance below this many epsilons of the energies is rounding.
const ROUNDING: f64 = 1e3;
/// Rounding that every step may add, in epsilons of the energies.
const EACH_STEP: f64 = 10.0;
/// What steps add is at most this fraction of the energies, however many they are: what is more is an error.
const MOST_ROUNDING: f64 = 1e-6;
/// Gaps below some 1e-10 of the size of a world are closed without an account: so much of its energies is rounding.
const GAPS: f64 = 1e-10;
/// Pivots below this fraction of nominal are close to a singular configuration.
pub(super) const NEARLY_SINGULAR: f64 = 1e-3;
/// A coordinate may exceed its range by this fraction of it, because of rounding or a start at its end.
const SLACK: f64 = 1e-6;
/// An angle whose range exceeds this fraction of a turn may rotate without limit.
const WHOLE_TURN: f64 = 0.95;
/// Most coordinates that are named; more are counted.
const NAMED: usize = 4;

/// A declared range of a coordinate.
#[derive(Clone, PartialEq, Debug)]
pub struct Range {
    /// Ends (SI).
    pub ends: (f64, f64),
    /// Unit that it was written in, and how many SI units make one of it.
    pub unit: (String, f64),
    /// The value may be taken modulo whole turns, as that of a crank.
    pub is_angle: bool,
}

impl Range {
    /// How far a value lies outside (SI).
    #[must_use]
    pub fn excess(&self, value: f64) -> f64 {
        let (low, high) = self.ends;
        if self.is_angle && high - low > WHOLE_TURN * std::f64::consts::TAU {
            return f64::NEG_INFINITY;
        }
        let middle = 0.5 * (low + high);
        let turns = if self.is_angle { ((value - middle) / std::f64::consts::TAU).round() } else { 0.0 };
        let value = value - turns * std::f64::consts::TAU;
        (low - value).max(value - high) - SLACK * (high - low)
    }
}

/// The largest excess of a coordinate over its range.
#[derive(Clone, Copy, PartialEq, Debug)]
struct Outside {
    t: f64,
    value: f64,
    excess: f64,
}

/// Observations so far.
#[derive(Clone, PartialEq, Debug)]
pub struct Health {
    ranges: BTreeMap<String, Range>,
    outside: BTreeMap<String, Outside>,
    /// By column: the first time at which it was not finite, and its value then.
    infinite: BTreeMap<String, (f64, f64)>,
    /// Smallest pivot so far, relative to nominal, and the part that has it, if it is one of several.
    pivot: (f64, Option<String>),
    imbalance: f64,
    moved: f64,
    size: f64,
    epsilon: f64,
    /// Rounding as a fraction of the energies.
    rounding: f64,
    /// Most of the energy (J) that contacts had taken, and most that they gave after that.
    taken: [f64; 2],
    /// What chatters, as a message.
    chatter: Option<String>,
    /// The part, if it is one of several, and the time (s) near which a step passes over what depends on time alone.
    passed: Option<(Option<String>, f64)>,
}

/// Energies at a row (J).
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Energies<'a> {
    /// Stored energies of the state, the kinetic one first.
    pub stored: &'a [f64],
    /// Work put in and taken out, and how much the total has changed.
    pub moved: &'a [f64],
    /// Imbalance of the ledger.
    pub imbalance: f64,
}

impl Health {
    /// Without observations; `epsilon` is the scalar's.
    #[must_use]
    pub fn new(ranges: BTreeMap<String, Range>, epsilon: f64) -> Self {
        let (outside, infinite) = (BTreeMap::new(), BTreeMap::new());
        let (pivot, chatter) = ((1.0, None), None);
        let (imbalance, moved, size, rounding) = (0.0, 0.0, 0.0, ROUNDING * epsilon);
        Self {
            ranges,
            outside,
            infinite,
            pivot,
            imbalance,
            moved,
            size,
            epsilon,
            rounding,
            taken: [0.0; 2],
            chatter,
            passed: None,
        }
    }

    /// Observes a coordinate at a time.
    pub fn place(&mut self, name: &str, value: f64, t: f64) {
        let Some(range) = self.ranges.get(name) else { return };
        let excess = range.excess(value);
        let is_inside = excess <= 0.0;
        if !is_inside && self.outside.get(name).is_none_or(|known| excess > known.excess || excess.is_nan()) {
            self.outside.insert(name.to_owned(), Outside { t, value, excess });
        }
    }

    /// Observes an output at a time.
    pub fn output(&mut self, name: &str, value: f64, t: f64) {
        if !value.is_finite() && !self.infinite.contains_key(name) {
            self.infinite.insert(name.to_owned(), (t, value));
        }
    }

    /// Observes the worst pivot of a step, or that of a part so far, relative to nominal.
    pub fn pivot(&mut self, part: Option<&str>, pivot: f64) {
        if pivot.is_nan() || pivot < self.pivot.0 {
            self.pivot = (pivot, part.map(str::to_owned));
        }
    }

    /// Observes the energies of a row.
    pub fn energies(&mut self, at: Energies<'_>) {
        // The first stored energy, the kinetic one, counts as energy that moved.
        self.moved = at.moved.iter().chain(at.stored.first()).fold(self.moved, |m, x| worst(m, *x));
        self.size = at.stored.iter().fold(self.size, |m, x| worst(m, *x));
        self.imbalance = worst(self.imbalance, at.imbalance);
    }

    /// Observes the energy (J) that contacts have taken so far, which never falls.
    pub fn taken(&mut self, by_contacts: f64) {
        let [most, given] = self.taken;
        self.taken = [most.max(by_contacts), worst(given, most.max(by_contacts) - by_contacts)];
    }

    /// Energies are differences of numbers of this size (J), whose rounding they have.
    pub fn differences_of(&mut self, size: f64) {
        self.size = self.size.max(size);
    }

    /// Energies are rounded by so many steps, and by gaps if parts touch.
    pub fn rounded_by(&mut self, steps: usize, parts_touch: bool) {
        let added = (EACH_STEP * steps as f64 * self.epsilon).min(MOST_ROUNDING);
        let gaps = if parts_touch { GAPS } else { 0.0 };
        self.rounding = self.rounding.max(added).max(gaps);
    }

    /// Notes that a `sign` of a speed changed from step to step.
    pub fn chatter(&mut self, warning: Option<String>) {
        self.chatter = warning;
    }

    /// Notes the time (s) near which a step passes over what a load, a law or a command does, of a part if it is one of
    /// several.
    pub fn passed_over(&mut self, part: Option<&str>, t: f64) {
        self.passed = Some((part.map(str::to_owned), t));
    }

    /// The findings, as messages for the user.
    #[must_use]
    pub fn findings(&self) -> Vec<String> {
        let chatter = self.chatter.clone();
        let findings = [
            self.unbalanced(),
            self.given(),
            self.left_ranges(),
            self.singular(),
            self.not_finite(),
            chatter,
            self.passed_by(),
        ];
        findings.into_iter().flatten().collect()
    }

    fn passed_by(&self) -> Option<String> {
        let (part, t) = self.passed.as_ref()?;
        let of = part.as_ref().map_or_else(String::new, |part| format!(" of `{part}`"));
        Some(format!(
            "a load, law or command{of} changes and returns within a step near t = {t:.4} s, which does not see it; take a smaller step"
        ))
    }

    fn not_finite(&self) -> Option<String> {
        let first =
            |(name, (t, value)): (_, &(f64, f64))| format!("`{name}` = {value} first at t = {t:.4} s");
        let named: Vec<String> = self.infinite.iter().map(first).collect();
        (!named.is_empty()).then(|| {
            format!(
                "outputs are not finite: {}; something they are divided by is 0, or a number is too large",
                words::first_of(&named, NAMED)
            )
        })
    }

    /// Energy (J) that an error of the motion may be.
    fn allowed(&self) -> f64 {
        IMBALANCE * self.moved + self.rounding * self.size
    }

    fn unbalanced(&self) -> Option<String> {
        // False also for NaN.
        let is_balanced = self.imbalance <= self.allowed();
        (!is_balanced).then(|| {
            format!(
                "energy: {:.1e} J of the {:.1e} J that were converted are in no account (allowed: {IMBALANCE:e} of \
                 them); the motion is not to be trusted: take a smaller --step or another --method",
                self.imbalance, self.moved
            )
        })
    }

    fn given(&self) -> Option<String> {
        let [_, given] = self.taken;
        (given > self.allowed()).then(|| {
            format!(
                "energy: contacts gave {given:.1e} J of the {:.1e} J that were converted, where they can only take \
                 (allowed: {IMBALANCE:e} of them); the motion is not to be trusted: take a smaller --step, or \
                 method = \"moreau\" where it is energy_momentum",
                self.moved
            )
        })
    }

    fn left_ranges(&self) -> Option<String> {
        let mut worst: Vec<(&String, &Outside)> = self.outside.iter().collect();
        worst.sort_by(|a, b| b.1.excess.total_cmp(&a.1.excess));
        let named = worst.iter().filter_map(|(name, found)| {
            let range = self.ranges.get(*name)?;
            let (unit, factor) = &range.unit;
            let [value, low, high] = [found.value, range.ends.0, range.ends.1].map(|x| x / factor);
            Some(format!("`{name}` = {value:.4} {unit} at t = {:.4} s (range {low} to {high})", found.t))
        });
        let named: Vec<String> = named.collect();
        (!named.is_empty()).then(|| {
            format!("the motion left the ranges that the model declares: {}", words::first_of(&named, NAMED))
        })
    }

    fn singular(&self) -> Option<String> {
        let (pivot, part) = &self.pivot;
        let is_regular = *pivot >= NEARLY_SINGULAR;
        (!is_regular).then(|| {
            let of = part.as_ref().map(|part| format!(" of `{part}`")).unwrap_or_default();
            format!(
                "the motion{of} passed a configuration that is nearly singular (a pivot of {pivot:.1e} of nominal): near \
                 it the equations hardly determine the motion; `smartbed check` finds such configurations"
            )
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn health() -> Health {
        let metre = Range { ends: (-0.1, 0.2), unit: ("mm".to_owned(), 1e-3), is_angle: false };
        let crank = Range { ends: (-3.1, 3.1), unit: ("rad".to_owned(), 1.0), is_angle: true };
        Health::new(BTreeMap::from([("h".to_owned(), metre), ("crank".to_owned(), crank)]), f64::EPSILON)
    }

    #[test]
    fn a_run_in_order_has_no_findings() {
        let mut health = health();
        health.place("h", 0.2, 1.0);
        health.place("unknown", 9.0, 1.0);
        health.place("crank", -4.126, 1.0);
        health.place("crank", 63.0, 1.0);
        health.place("crank", 3.12, 1.0);
        health.pivot(None, 0.5);
        health.energies(Energies { stored: &[2.0, -50.0], moved: &[2.0], imbalance: 1e-3 });
        assert_eq!(health.findings(), [""; 0]);
    }

    /// What contacts took may grow, and waver by rounding; what falls is what they gave.
    #[test]
    fn contacts_that_give_energy_are_told() {
        let told = |taken: [f64; 3]| {
            let mut health = health();
            taken.into_iter().for_each(|taken| health.taken(taken));
            health.energies(Energies { stored: &[4.0, 0.0], moved: &[4.0], imbalance: 0.0 });
            health.findings().iter().any(|finding| finding.contains("contacts gave 5.0e-1 J"))
        };
        assert!(told([0.0, 2.0, 1.5]) && told([0.0, -0.5, -0.5]));
        assert!(!told([0.0, 2.0, 2.5]) && !told([1.0, 1.0 - 1e-12, 1.0]));
    }

    /// Two boxes at rest: all that was converted is rounding of gaps, or of many steps.
    #[test]
    fn rounding_of_gaps_and_of_many_steps_is_no_error() {
        let told = |steps: usize, parts_touch: bool, imbalance: f64, epsilon: f64| {
            let mut health = Health::new(BTreeMap::new(), epsilon);
            health.rounded_by(steps, parts_touch);
            health.energies(Energies { stored: &[0.0, 14.7], moved: &[0.0, 1e-10], imbalance });
            !health.findings().is_empty()
        };
        let (wide, single) = (f64::EPSILON, f64::from(f32::EPSILON));
        assert!(!told(1000, true, 1.2e-10, wide), "gaps");
        assert!(told(1000, false, 1.2e-10, wide), "nothing touches");
        assert!(!told(100_000, false, 1.2e-10, wide), "many steps");
        // An error stays one however long the run is, and in whatever scalar.
        assert!(told(1000, true, 1e-8, wide));
        assert!(told(1_000_000_000, true, 1e-4, wide));
        assert!(told(1_000_000_000, true, 1e-2, single));
    }

    #[test]
    fn the_worst_of_each_kind_is_told() {
        let mut health = health();
        [(0.3, 1.0), (1.2, 2.0), (0.4, 3.0)].iter().for_each(|(x, t)| health.place("h", *x, *t));
        health.pivot(None, 1e-6);
        health.energies(Energies { stored: &[2.0], moved: &[], imbalance: f64::NAN });
        health.energies(Energies { stored: &[2.0], moved: &[], imbalance: 0.0 });
        let found = health.findings();
        assert!(found[0].contains("NaN J of the 2.0e0 J"), "{found:?}");
        assert!(found[1].ends_with("`h` = 1200.0000 mm at t = 2.0000 s (range -100 to 200)"), "{found:?}");
        assert!(found[2].contains("1.0e-6 of nominal"), "{found:?}");
    }

    #[test]
    fn outputs_that_are_not_finite_are_told_once() {
        let mut health = health();
        [(1.0, 0.0), (f64::NEG_INFINITY, 0.5), (f64::NAN, 1.0)]
            .iter()
            .for_each(|(x, t)| health.output("p", *x, *t));
        let found = health.findings();
        assert!(found.len() == 1 && found[0].contains("`p` = -inf first at t = 0.5000 s"), "{found:?}");
    }
}
