//! The data of a program: its quantities, its answers, and how it was derived.

use super::answer::part::Answer;
use super::answer::request::Function;
use crate::diagnostic::Diagnostics;
use crate::dynamics::Augmented;
use crate::expr::cost::Optimise;
use crate::expr::{Dag, ExprId, SymbolId};
use crate::kinematics::eliminate::Pivot;
use crate::kinematics::{Assembly, ParameterChoice};
use crate::model::Model;
use crate::value::Effort;

/// Everything derived from a model.
#[derive(Clone, Debug)]
pub struct Program {
    /// The model's name.
    pub name: String,
    /// The model's description.
    pub doc: String,
    /// Path of the model text as given.
    pub path: String,
    /// The model's text and the settings from which it was derived.
    pub origin: Origin,
    /// The expressions of all answers.
    pub dag: Dag,
    /// Time.
    pub time: SymbolId,
    /// Coordinates that are state.
    pub q: Vec<Quantity>,
    /// Independent speeds.
    pub u: Vec<Quantity>,
    /// Inputs.
    pub inputs: Vec<Quantity>,
    /// Tunable parameters; `value` is the default.
    pub parameters: Vec<Quantity>,
    /// q' and u' and the worst pivot.
    pub rates: Rates,
    /// Kinetic and potential energy (J).
    pub energy: [ExprId; 2],
    /// Power (W) supplied by the drive, if the model prescribes a motion by time or stated velocities.
    pub drive: Option<ExprId>,
    /// All speeds of the model by name, dependent ones in terms of the independent.
    pub speeds: Vec<(String, ExprId)>,
    /// Requested outputs.
    pub outputs: Vec<(String, ExprId)>,
    /// Unit and place of declaration of each output.
    pub output_facts: Vec<[String; 2]>,
    /// Newton's correction of the dependent coordinates: (index into q, correction).
    pub correction: Vec<(usize, ExprId)>,
    /// Correction of redundant speeds, which are all state and tied by the constraints; empty if the speeds are
    /// independent.
    pub speed_correction: Vec<ExprId>,
    /// Largest constraint residual before the correction, implied constraints included.
    pub residual: ExprId,
    /// Are there constraints that follow from the others at the default parameters but perhaps not at other ones?
    pub has_implied: bool,
    /// The equations before the elimination, with multipliers; empty unless asked for.
    pub augmented: Augmented,
    /// Given derivatives of the speeds; empty unless an answer takes them.
    pub u_dot: Vec<Quantity>,
    /// The answers that were asked for.
    pub answers: Vec<Answer>,
    /// The functions that return them.
    pub functions: Vec<Function>,
    /// Pivots of all eliminations.
    pub pivots: Vec<Pivot>,
    /// Number of configurations at which the pivots were screened.
    pub n_samples: usize,
    /// Solver for the dependent coordinates at the start.
    pub assembly: Assembly,
    /// The nominal configuration.
    pub nominal: Vec<f64>,
    /// Which of the speeds the model declares independent: all, unless all speeds are state.
    pub is_independent: Vec<bool>,
    /// Names and values of `[start]`; [`Program::start`] turns them into a state.
    pub stated_start: Vec<(String, f64)>,
    /// Warnings that only numbers show, such as redundant constraints that were dropped.
    pub warnings: Diagnostics,
}

/// The model's text and the settings from which a program was derived.
#[derive(Clone, Debug)]
pub struct Origin {
    /// Name of the model's file, without its folder.
    pub file: String,
    /// Fingerprint of the model's text, with the files that it extends.
    pub fingerprint: u64,
    /// Parameters that were kept tunable or changed.
    pub choice: ParameterChoice,
    /// How the equations were derived.
    pub settings: Settings,
}

impl Origin {
    pub(super) fn new(model: &Model, choice: &ParameterChoice, settings: Settings) -> Self {
        let source = &model.source;
        let file = source.files.first().map_or_else(String::new, |file| file.name().to_owned());
        Self { file, fingerprint: source.fingerprint(), choice: choice.clone(), settings }
    }
}

/// The forward dynamics answer.
#[derive(Clone, Debug)]
pub struct Rates {
    /// One per coordinate.
    pub q_dot: Vec<ExprId>,
    /// One per independent speed.
    pub u_dot: Vec<ExprId>,
    /// Smallest pivot relative to nominal; 1 if there are no pivots.
    pub worst_pivot: ExprId,
}

/// A named number of the state, the inputs or the parameters.
#[derive(Clone, Debug)]
pub struct Quantity {
    /// Name in the model.
    pub name: String,
    /// Its symbol.
    pub symbol: SymbolId,
    /// Unit as written in the model.
    pub unit: String,
    /// What it is.
    pub doc: String,
    /// Default (parameters), nominal value (coordinates), else 0.
    pub value: f64,
    /// Lowest and highest value, of parameters and of coordinates for which the model states them; else every number.
    pub range: (f64, f64),
    /// File and line of the declaration.
    pub place: String,
    /// Is it used only in sines and cosines, so that it may be wrapped by whole turns?
    pub is_angle: bool,
}

/// How a program is derived; no setting changes the values that the equations define.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub struct Settings {
    /// Effort spent on reducing the number of operations.
    pub effort: Effort,
    /// What is minimised when one of several forms of the equations is chosen.
    pub optimise: Optimise,
}

impl From<Effort> for Settings {
    fn from(effort: Effort) -> Self {
        Self { effort, ..Self::default() }
    }
}

impl Program {
    /// Are all speeds state, tied by the constraints, because the motion passes dead points of the independent ones?
    #[must_use]
    pub fn is_redundant(&self) -> bool {
        !self.speed_correction.is_empty()
    }
}
