//! The data that the stages of kinematics pass on: rates, motions, constraint rows, and all of them for one model.
//!
//! Plain data: the stages fill it in the order of `derive`; later stages only read it.

use super::linear_form::LinearForm;
use super::unknowns::{UnknownId, Unknowns};
use crate::expr::{Dag, ExprId, SymbolId};
use crate::id::IdVec;
use crate::model::{Axis, CoordinateId, DefinitionId, FrameId, InputId, ParameterId, PointId};
use crate::source::Span;
use crate::vector::{Components, TriadId, Vector};
use rustc_hash::FxHashMap as HashMap;
use std::cell::RefCell;
use std::collections::BTreeMap;

/// The name and the place of an equation of the model, for messages.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Place {
    /// Its name.
    pub name: String,
    /// Where it is declared.
    pub span: Span,
}

/// Rate of a scalar: `s' = sum_k partials[k] y_k`, `s'' = sum_k partials[k] y_k' + bias`.
#[derive(Clone, PartialEq, Debug)]
pub struct Rate {
    /// Coefficients of the unknowns.
    pub partials: LinearForm,
    /// The part of s'' without y'.
    pub bias: ExprId,
}

/// Rate of a vector in N: `v = sum_k partials[k] y_k`, `a = sum_k partials[k] y_k' + bias`.
#[derive(Clone, PartialEq, Debug, Default)]
pub struct Motion {
    /// Partial velocities.
    pub partials: LinearForm<Vector>,
    /// The part of a without y'.
    pub bias: Vector,
}

/// The value of an expression of the model.
#[derive(Clone, PartialEq, Debug)]
pub enum Value {
    /// A number at run time.
    Scalar(ExprId),
    /// A vector.
    Vector(Vector),
}

/// The direction on which a vector equation is projected.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Direction {
    /// An axis of this triad.
    pub triad: TriadId,
    /// Which one.
    pub axis: Axis,
    /// Is it crossed with the vector that the equation is about? The row then says how that turns about the axis.
    pub turning: bool,
}

/// One scalar equation: `sum_k coefficients[k] y_k = 0`, `sum_k coefficients[k] y_k' + bias = 0`, and for Newton's
/// correction d of the configuration `sum_k coefficients[k] d_k = -residual`. The clock's coefficient is the part
/// without speeds.
#[derive(Clone, Debug)]
pub struct Row {
    /// The name of the equation it comes from.
    pub name: String,
    /// The direction on which a vector equation is projected.
    pub along: Option<Direction>,
    /// Non-zero coefficients.
    pub coefficients: LinearForm,
    /// The part of the differentiated equation without y'.
    pub bias: ExprId,
    /// The equation at position level; 0 for motion constraints.
    pub residual: ExprId,
    /// Operations of the coefficients plus a charge per unknown.
    pub cost: usize,
}

/// Positions, motions and constraint rows of a model.
#[derive(Clone, Debug)]
pub struct Kinematics {
    /// Time.
    pub time: ExprId,
    /// Coordinates: symbols, those of [`Self::closed_forms`] included, or closed forms of other coordinates.
    pub q: IdVec<CoordinateId, ExprId>,
    /// Is the coordinate state? (Else it is given in closed form.)
    pub is_state: IdVec<CoordinateId, bool>,
    /// Coordinates in closed form that are symbols during the derivation, with their forms, ordered so that each form
    /// needs only earlier ones.
    pub closed_forms: Vec<(CoordinateId, ExprId)>,
    /// Inputs: symbols.
    pub inputs: IdVec<InputId, ExprId>,
    /// Parameters: symbols where tunable, folded expressions where fixed.
    pub parameters: IdVec<ParameterId, ExprId>,
    /// Default values of the parameters, overrides applied.
    pub parameter_values: IdVec<ParameterId, f64>,
    /// Speeds, the clock, components of lifted twists.
    pub unknowns: Unknowns,
    /// Triad of every frame.
    pub frame_triad: IdVec<FrameId, TriadId>,
    /// Position of every point from O; lifted points appear as themselves.
    pub positions: IdVec<PointId, Vector>,
    /// Positions of lifted points without lifted points: by their first expressions.
    pub flat_positions: BTreeMap<PointId, Vector>,
    /// Values of definitions; `None` for those that depend on velocities until the motions are known.
    pub definitions: IdVec<DefinitionId, Option<Value>>,
    /// Rate of every coordinate.
    pub rates: IdVec<CoordinateId, Rate>,
    /// Angular velocity of every triad in N.
    pub angular: IdVec<TriadId, Motion>,
    /// Velocity of every point in N.
    pub velocities: IdVec<PointId, Motion>,
    /// Cache: derivatives of terms of positions, by triad and components, consistent with [`Self::angular`] and
    /// [`Self::rates`].
    pub(super) term_derivatives: RefCell<HashMap<(TriadId, Components), Motion>>,
    /// Candidate constraint rows, cheapest first.
    pub rows: Vec<Row>,
    /// Rows of constraints that follow from others: used only if the others do not suffice.
    pub spare_rows: Vec<Row>,
    /// Configuration constraints as scalars: 0 when satisfied.
    pub residuals: Vec<ExprId>,
    /// The equation of each residual.
    pub residual_names: Vec<Place>,
    /// Constraints that follow from the others at the nominal parameters: not solved, but they must stay satisfied.
    pub implied: Vec<ExprId>,
    /// The equation of each implied constraint.
    pub implied_names: Vec<Place>,
    /// Motion constraints that follow from the others at the nominal parameters, and whether as a whole or in a
    /// component only.
    pub implied_motions: Vec<(Place, bool)>,
    /// Vectors stated to be fixed in a frame: their inertial components less the stated ones.
    pub fixed_vectors: Vec<(Place, [ExprId; 3])>,
    /// Speeds that the model defines as sums of rates. In these forms the unknown with index c is the rate of
    /// coordinate c.
    pub(super) combinations: Vec<(UnknownId, LinearForm)>,
    /// Divisors in the solution of the speeds' definitions for the rates.
    pub rate_pivots: Vec<ExprId>,
    /// Coordinates at sampled configurations that satisfy the constraints, nominal first.
    pub samples: Vec<Vec<f64>>,
    /// Times (s) of the samples: 0 unless the model is driven.
    pub sample_times: Vec<f64>,
}

/// A configuration that satisfies the constraints at a time.
#[derive(Clone, PartialEq, Debug)]
pub(crate) struct Sample {
    /// Coordinates.
    pub q: Vec<f64>,
    /// Time (s).
    pub t: f64,
}

impl Kinematics {
    /// The sampled configurations with their times.
    pub(crate) fn sampled(&self) -> Vec<Sample> {
        let samples = self.samples.iter().zip(&self.sample_times);
        samples.map(|(q, &t)| Sample { q: q.clone(), t }).collect()
    }

    /// Symbol of a coordinate; `None` for a closed form.
    #[must_use]
    pub fn coordinate_symbol(&self, dag: &Dag, coordinate: CoordinateId) -> Option<SymbolId> {
        if self.is_state[coordinate] { dag.as_symbol(self.q[coordinate]) } else { None }
    }

    /// The symbol of a coordinate during the derivation: a state, or a closed form that is substituted at the end.
    pub(crate) fn variable(&self, dag: &Dag, coordinate: CoordinateId) -> Option<SymbolId> {
        let is_variable =
            self.is_state[coordinate] || self.closed_forms.iter().any(|(c, _)| *c == coordinate);
        if is_variable { dag.as_symbol(self.q[coordinate]) } else { None }
    }

    /// The expressions, as functions of the state, that replace the symbols of coordinates in closed form.
    pub(crate) fn closed_form_values(&self, dag: &mut Dag) -> HashMap<SymbolId, ExprId> {
        let mut values = HashMap::default();
        for &(coordinate, form) in &self.closed_forms {
            let value = dag.substitute(&[form], &values)[0];
            if let Some(symbol) = dag.as_symbol(self.q[coordinate]) {
                values.insert(symbol, value);
            }
        }
        values
    }
}
