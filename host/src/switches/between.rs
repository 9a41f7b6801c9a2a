//! What functions of time alone do between the times at which a step evaluates them.
//!
//! In: the observers of a mechanism; the length of a run, and its step. Out: whether a step hides a short pulse of a
//! load, a law or a command: one that neither its stages nor an estimate of its error can see. Functions are tabulated
//! once, several times within each step; where a step's own stages see much less of a function's range than the table,
//! it hides something.

use super::Switches;
use crate::observers::Observers;
use smartbed_codegen::Interpreted;
use smartbed_runtime::mechanism::{Fault, Mechanism as _};

/// Values within a step of the run; least and most values of the table, and most of all functions.
const EACH_STEP: f64 = 16.0;
const LEAST: f64 = 4096.0;
const MOST: f64 = 2e5;
const MOST_OF_ALL: f64 = 4e6;

/// A step of so few values of the table is short enough.
const SHORT: usize = 8;
/// Values beside the ends of a step, across which a function may switch.
const ENDS: usize = 2;
/// A step sees a function if its range is at most this many times that at its stages.
const RANGE: f64 = 1.5;
/// What changes by less than this part of a function's range, and of its size, does not count: the second is rounding.
const SMALL: f64 = 1e-6;
const ROUNDING: f64 = 1e-12;

/// Parts of a step at which methods of fixed step evaluate: the least that they have.
pub const STAGES: [f64; 3] = [0.0, 0.5, 1.0];

/// A table of functions of time.
#[derive(Clone, Debug)]
pub struct Between {
    /// Time between two values (s).
    spacing: f64,
    /// By function: its values, and the least change that counts.
    functions: Vec<(Vec<f64>, f64)>,
}

/// The middle (s) of the first of the steps of fixed length (s) of a run over so many seconds that hides something of
/// what these observers see.
///
/// # Errors
/// The engine's.
pub fn passed(observers: &Observers, run: [f64; 2]) -> Result<Option<f64>, Fault> {
    let [seconds, step] = run;
    match Between::new(observers, seconds, step)? {
        Some(between) => between.passed(run, &mut Switches::<f64>::new(observers)),
        None => Ok(None),
    }
}

impl Between {
    /// For a run over so many seconds with a step (s); `None` if nothing depends on time alone.
    ///
    /// # Errors
    /// The engine's.
    pub fn new(observers: &Observers, seconds: f64, step: f64) -> Result<Option<Self>, Fault> {
        let number: usize = observers.timed.iter().sum();
        if number == 0 || seconds <= 0.0 {
            return Ok(None);
        }
        let mut engine = Interpreted::<f64>::new(&observers.of_time());
        let [q, u] = [engine.n_q(), engine.n_u()].map(|n| vec![0.0; n]);
        let inputs = vec![0.0; engine.n_inputs()];
        let most = MOST.min(MOST_OF_ALL / number as f64).max(LEAST);
        let parts = (EACH_STEP * seconds / step).ceil().clamp(LEAST, most);
        let spacing = seconds / parts;
        let mut functions = vec![Vec::with_capacity(parts as usize + 1); number];
        for i in 0..=parts as usize {
            let values = engine.outputs(i as f64 * spacing, &q, &u, &inputs)?;
            functions.iter_mut().zip(values).for_each(|(own, value)| own.push(value));
        }
        // The acceleration of what is commanded acts as loads do.
        let bent: Vec<Vec<f64>> =
            functions[..observers.timed[0]].iter().map(|own| second_differences(own)).collect();
        let plain = functions.into_iter().map(|own| {
            let least = SMALL * range(&own) + ROUNDING * size(&own);
            (own, least)
        });
        let mut functions: Vec<_> = plain.collect();
        for (command, own) in bent.into_iter().enumerate() {
            let least = SMALL * range(&own) + 1e2 * ROUNDING * size(&functions[command].0);
            functions.push((own, least));
        }
        Ok(Some(Self { spacing, functions }))
    }

    /// The middle (s) of the first of the steps of fixed length (s) of a run over so many seconds that hides something,
    /// but for what is cut out by a switch.
    ///
    /// # Errors
    /// The engine's.
    pub fn passed(
        &self,
        [seconds, step]: [f64; 2],
        switches: &mut Switches<f64>,
    ) -> Result<Option<f64>, Fault> {
        let mut t = 0.0;
        for i in 1.. {
            if t >= seconds {
                break;
            }
            let end = (i as f64 * step).min(seconds);
            if self.hides(t, end - t, &STAGES) && switches.first(t, end)?.is_none() {
                return Ok(Some(0.5 * (t + end)));
            }
            t = end;
        }
        Ok(None)
    }

    /// Does a step from `t` to t + h (s), evaluated at these parts of it, hide something?
    #[must_use]
    pub fn hides(&self, t: f64, h: f64, stages: &[f64]) -> bool {
        let first = (t / self.spacing).ceil().max(0.0) as usize + ENDS;
        let last = (((t + h) / self.spacing).floor().max(0.0) as usize).saturating_sub(ENDS);
        if last < first + SHORT {
            return false;
        }
        let seen = stages.iter().map(|c| ((t + c * h) / self.spacing).round() as usize);
        let seen: Vec<usize> = seen.map(|i| i.clamp(first, last)).collect();
        self.functions.iter().any(|(own, least)| {
            let Some(all) = own.get(first..=last) else { return false };
            let all = range(all);
            all > *least && all > RANGE * range(&seen.iter().map(|i| own[*i]).collect::<Vec<_>>())
        })
    }
}

/// Largest less smallest value.
fn range(values: &[f64]) -> f64 {
    let ends = values.iter().fold([f64::INFINITY, f64::NEG_INFINITY], |[a, b], x| [a.min(*x), b.max(*x)]);
    (ends[1] - ends[0]).max(0.0)
}

fn size(values: &[f64]) -> f64 {
    values.iter().fold(0.0, |most, x| most.max(x.abs()))
}

/// As many as values; none at both ends.
fn second_differences(values: &[f64]) -> Vec<f64> {
    let inner = values.windows(3).map(|w| w[0] - 2.0 * w[1] + w[2]);
    std::iter::once(0.0).chain(inner).chain(std::iter::once(0.0)).collect()
}

#[cfg(test)]
mod tests {
    use super::{Between, STAGES};

    fn table(f: impl Fn(f64) -> f64) -> Between {
        let own: Vec<f64> = (0..=1000).map(|i| f(f64::from(i) * 1e-3)).collect();
        Between { spacing: 1e-3, functions: vec![(own, 1e-9)] }
    }

    #[test]
    fn a_pulse_between_stages_is_hidden() {
        let pulse = table(|t| (-((t - 0.33) / 0.005_f64).powi(2)).exp());
        assert!(pulse.hides(0.0, 1.0, &STAGES));
        assert!(pulse.hides(0.2, 0.2, &STAGES));
        // A stage at it, or a step that ends before it.
        assert!(!pulse.hides(0.0, 0.66, &STAGES));
        assert!(!pulse.hides(0.0, 0.3, &STAGES));
        // What is resolved, at its extrema and where it is flat, and a step of whole periods.
        let wave = table(|t| (20.0 * t).sin());
        for i in 0..90 {
            assert!(!wave.hides(f64::from(i) * 0.01, 0.1, &STAGES), "{i}");
        }
        assert!(wave.hides(0.0, std::f64::consts::TAU / 20.0, &STAGES));
        assert!(!table(|_| 3.0).hides(0.0, 1.0, &STAGES));
    }
}
