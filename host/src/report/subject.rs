//! The trait of what is measured: a scene of a flexible body, a mechanism or a world.

use super::clock::Stop;
use super::point::Control;
use super::sheet::Sheet;
use crate::engine::ScalarKind;
use std::time::Duration;

/// If equations are smooth, the reference is used for the time over which references differ by at most this (m or rad).
pub const AGREEMENT: f64 = 1e-8;
/// Difference up to which a quotient of times counts as whole.
pub const ROUNDING: f64 = 1e-9;
/// Number of times at which runs are compared with the reference, equally spaced, the last one at the end.
pub const SAMPLES: usize = 10;

/// A method of integration.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Method {
    /// Its name on the command line.
    pub name: String,
    /// Order of the error in the step, on this subject; for an adaptive method the order of its step control.
    pub order: u32,
    /// Does it choose its own steps?
    pub adaptive: bool,
}

/// The result of a run.
#[derive(Clone, PartialEq, Debug)]
pub struct Trace {
    /// Coordinates at the samples.
    pub samples: Vec<Vec<f64>>,
    /// Evaluations of all forces, if they are counted.
    pub evaluations: Option<u64>,
    /// Computing time.
    pub elapsed: Duration,
}

impl Trace {
    /// Largest difference of a coordinate, sample by sample.
    #[must_use]
    pub fn differences(&self, other: &Trace) -> Vec<f64> {
        let largest = |(a, b): (&Vec<f64>, &Vec<f64>)| {
            let differences = a.iter().zip(b).map(|(a, b)| (a - b).abs());
            differences.fold(0.0, larger)
        };
        self.samples.iter().zip(&other.samples).map(largest).collect()
    }

    /// Largest difference at any time at which both have a sample; one may have more of them than the other.
    #[must_use]
    pub fn difference(&self, other: &Trace) -> f64 {
        self.thinned(other).differences(&other.thinned(self)).into_iter().fold(0.0, larger)
    }

    /// As [`Trace::difference`], at all times but the [`SAMPLES`], where the reference tells the error itself.
    #[must_use]
    pub fn difference_between(&self, other: &Trace) -> f64 {
        let differences = self.thinned(other).differences(&other.thinned(self));
        let each = (differences.len() / SAMPLES).max(1);
        let between = differences.into_iter().enumerate().filter(|(n, _)| (n + 1) % each != 0);
        between.map(|(_, difference)| difference).fold(0.0, larger)
    }

    /// Fraction of the time from the start on over which both differ by at most so much.
    #[must_use]
    pub fn agreement(&self, other: &Trace, most: f64) -> f64 {
        let differences = self.thinned(other).differences(&other.thinned(self));
        let agreeing = differences.iter().take_while(|difference| **difference <= most).count();
        agreeing as f64 / differences.len().max(1) as f64
    }

    /// Only the samples at times at which another trace over the same time has one, too.
    fn thinned(&self, other: &Trace) -> Trace {
        let (own, others) = (self.samples.len(), other.samples.len());
        let every = own / greatest_divisor(own, others).max(1);
        let samples = self.samples.iter().skip(every.max(1) - 1).step_by(every.max(1)).cloned().collect();
        Trace { samples, ..*self }
    }

    /// Size of the motion: the largest change of a coordinate between two samples.
    #[must_use]
    pub fn extent(&self) -> f64 {
        let n = self.samples.first().map_or(0, Vec::len);
        let range = |i: usize| {
            let column = self.samples.iter().map(|s| s[i]);
            column.clone().fold(f64::NEG_INFINITY, f64::max) - column.fold(f64::INFINITY, f64::min)
        };
        (0..n).map(range).fold(0.0, f64::max)
    }
}

/// Equal parts of a time so that none is longer than `longest`, but for rounding.
#[must_use]
pub fn parts(whole: f64, longest: f64) -> usize {
    (whole / longest - ROUNDING).ceil().max(1.0) as usize
}

/// The longest step of at most `longest` (s) that divides the time between two samples evenly.
#[must_use]
pub fn even_step(longest: f64, seconds: f64) -> f64 {
    step_of(seconds, parts(step_of(seconds, 1), longest))
}

/// The step that divides the time between two samples into `steps`.
#[must_use]
pub fn step_of(seconds: f64, steps: usize) -> f64 {
    seconds / (SAMPLES * steps) as f64
}

/// The larger number; NaN counts as the largest.
#[must_use]
pub fn larger(most: f64, x: f64) -> f64 {
    if x <= most { most } else { x }
}

fn greatest_divisor(a: usize, b: usize) -> usize {
    if b == 0 { a } else { greatest_divisor(b, a % b) }
}

/// Simulated time, times of samples and the limit on computing time.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Time {
    /// Simulated time (s).
    pub seconds: f64,
    /// Number of samples, equally spaced, the last one at the end; steps end there.
    pub samples: usize,
    /// Computing time.
    pub limit: Duration,
}

impl Time {
    /// With [`SAMPLES`].
    #[must_use]
    pub fn new(seconds: f64, limit: Duration) -> Self {
        Self { seconds, samples: SAMPLES, limit }
    }
}

/// Kinds of subjects.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Kind {
    /// A mechanism.
    Mechanism,
    /// A scene of one flexible body, of format 1.
    Body,
    /// A scene of format 2.
    World,
}

/// A subject with contacts of the other kind.
pub struct Exchanged {
    /// What is exchanged, in words.
    pub words: &'static str,
    /// The subject, or why there is none.
    pub subject: Result<Box<dyn Subject>, String>,
}

/// A scene, a mechanism or a world that can be run with any method.
pub trait Subject {
    /// Its name.
    fn name(&self) -> &str;
    /// One line about it.
    fn title(&self) -> String;
    /// Simulated time that its file asks for (s).
    fn seconds(&self) -> f64;
    /// The step with which a method's ladder begins (s): the largest stable one, or a coarse one.
    fn coarsest_step(&self, method: &str) -> f64;
    /// The step (s), of at most `longest`, that a run over so many seconds takes.
    fn step(&self, longest: f64, seconds: f64) -> f64 {
        even_step(longest, seconds)
    }
    /// Do fixed steps of this length (s) pass over something that depends on time alone, such as a short pulse?
    fn passes_over(&self, step: f64) -> bool {
        let _ = step;
        false
    }
    /// Is the motion smooth, without touches and releases?
    fn is_smooth(&self) -> bool;
    /// Work per simulated second, in rough units of one spring; quick runs are shortened by it.
    fn weight(&self) -> f64;
    /// All methods.
    fn methods(&self) -> Vec<Method>;
    /// The scalars it can be computed in.
    fn scalars(&self) -> &'static [ScalarKind] {
        &[ScalarKind::F64, ScalarKind::F32]
    }
    /// Its reference is used if two references differ by at most this (m or rad).
    fn agreement(&self) -> f64 {
        AGREEMENT
    }
    /// A run with a method.
    ///
    /// # Errors
    /// Why it stopped.
    fn run(&self, how: (&str, Control, ScalarKind), time: Time) -> Result<Trace, Stop>;
    /// The most accurate run: DOP853 at 1e-13 if the equations are smooth.
    ///
    /// # Errors
    /// Why it stopped.
    fn reference(&self, time: Time) -> Result<Trace, Stop>;
    /// The same run with a second, independent method, and that method's name.
    ///
    /// # Errors
    /// Why it stopped.
    fn second_reference(&self, time: Time) -> Result<(&'static str, Trace), Stop>;
    /// How [`Subject::reference`] was made.
    fn reference_name(&self) -> String {
        "DOP853 at 1e-13".to_owned()
    }
    /// The exact motion and its name, if there is a closed form.
    fn closed_form(&self, seconds: f64) -> Option<(&'static str, Trace)>;
    /// What it is.
    fn kind(&self) -> Kind;
    /// The cost as asked for and with everything turned on; `None` for subjects that have no such comparison.
    ///
    /// # Errors
    /// Why it could not be run, in words.
    fn sheet(&self) -> Result<Option<Sheet>, String>;
    /// The same with contacts of the other kind, which has methods of its own, if there are any to exchange.
    fn exchanged(&self) -> Option<Exchanged> {
        None
    }
    /// A plot of motion and energies at its own settings, as SVG, as far as they come within a limit of computing time.
    ///
    /// # Errors
    /// Why the run stopped, in words.
    fn graph(&self, limit: Duration) -> Result<String, String>;
}
