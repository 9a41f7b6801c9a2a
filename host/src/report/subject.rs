//! What is measured: a scene of a flexible body, a mechanism or a world, all behind one trait.

use super::clock::Stop;
use super::point::Control;
use super::sheet::Sheet;
use crate::engine::ScalarKind;
use std::time::Duration;

/// Largest difference of the references (m or rad) for the time to be used, where equations are smooth.
pub const AGREEMENT: f64 = 1e-8;
/// Times at which a run is compared, evenly over it, its end included.
pub const SAMPLES: usize = 10;

/// A method of integration as a report sees it.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Method {
    /// Its name on the command line.
    pub name: String,
    /// Order of the error in the step, on this subject; of an adaptive method, that of its step control.
    pub order: u32,
    /// Chooses its own steps.
    pub adaptive: bool,
}

/// A run.
#[derive(Clone, PartialEq, Debug)]
pub struct Trace {
    /// Coordinates at the samples.
    pub samples: Vec<Vec<f64>>,
    /// Evaluations of all forces, where they are counted.
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
            // A number that is none is the largest of all.
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

/// How long a run is, and how long it may take.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Time {
    /// Simulated time (s).
    pub seconds: f64,
    /// Computing time.
    pub limit: Duration,
}

/// What a subject is.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Kind {
    /// A mechanism.
    Mechanism,
    /// A scene of one flexible body, of format 1.
    Body,
    /// A scene of format 2.
    World,
}

/// A scene or a mechanism that can be run with any method.
pub trait Subject {
    /// Its name.
    fn name(&self) -> &str;
    /// One line about it.
    fn title(&self) -> String;
    /// Simulated time that its file asks for (s).
    fn seconds(&self) -> f64;
    /// The step to start a method's ladder with (s): the largest that is stable, or a coarse one.
    fn coarsest_step(&self, method: &str) -> f64;
    /// Without touches and releases?
    fn is_smooth(&self) -> bool;
    /// Work of a simulated second in rough units of one spring over one second: what quick runs are cut by.
    fn weight(&self) -> f64;
    /// All methods.
    fn methods(&self) -> Vec<Method>;
    /// What it is computed in.
    fn scalars(&self) -> &'static [ScalarKind] {
        &[ScalarKind::F64, ScalarKind::F32]
    }
    /// Largest difference of its two references for them to be used (m or rad).
    fn agreement(&self) -> f64 {
        AGREEMENT
    }
    /// A run with a method.
    ///
    /// # Errors
    /// Why it stopped.
    fn run(&self, how: (&str, Control, ScalarKind), time: Time) -> Result<Trace, Stop>;
    /// The most exact run: DOP853 at 1e-13 where the equations are smooth.
    ///
    /// # Errors
    /// Why it stopped.
    fn reference(&self, time: Time) -> Result<Trace, Stop>;
    /// A second, independent method for the same.
    ///
    /// # Errors
    /// Why it stopped.
    fn second_reference(&self, time: Time) -> Result<(&'static str, Trace), Stop>;
    /// How [`Subject::reference`] was made.
    fn reference_name(&self) -> String {
        "DOP853 at 1e-13".to_owned()
    }
    /// The exact motion, where it is known, and its name.
    fn closed_form(&self, seconds: f64) -> Option<(&'static str, Trace)>;
    /// What it is.
    fn kind(&self) -> Kind;
    /// What is asked for and what it costs, beside everything on; none where there is no everything.
    ///
    /// # Errors
    /// Why it could not be run, in words.
    fn sheet(&self) -> Result<Option<Sheet>, String>;
    /// Motion and energies at its own settings, as SVG, as far as they come within a time of computing.
    ///
    /// # Errors
    /// Why the run stopped, in words.
    fn graph(&self, limit: Duration) -> Result<String, String>;
}
