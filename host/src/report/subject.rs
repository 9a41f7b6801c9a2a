//! The trait of what is measured: a scene of a flexible body, a mechanism or a world.

use super::clock::Stop;
use super::point::Control;
use super::sheet::Sheet;
use crate::engine::ScalarKind;
use std::time::Duration;

/// If equations are smooth, the reference is used for the time over which references differ by at most this (m or rad).
pub const AGREEMENT: f64 = 1e-8;
/// Number of times at which runs are compared, equally spaced, the last one at the end.
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
            // NaN counts as the largest difference.
            differences.fold(0.0, |m: f64, d| if d <= m { m } else { d })
        };
        self.samples.iter().zip(&other.samples).map(largest).collect()
    }

    /// Largest difference at any sample.
    #[must_use]
    pub fn difference(&self, other: &Trace) -> f64 {
        self.differences(other).into_iter().fold(0.0, |m: f64, d| if d <= m { m } else { d })
    }
}

/// Simulated time and the limit on computing time.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Time {
    /// Simulated time (s).
    pub seconds: f64,
    /// Computing time.
    pub limit: Duration,
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
    /// A plot of motion and energies at its own settings, as SVG, as far as they come within a limit of computing time.
    ///
    /// # Errors
    /// Why the run stopped, in words.
    fn graph(&self, limit: Duration) -> Result<String, String>;
}
