//! The data of a model: what each section states, with names resolved to ids and every place in the text kept.

use super::expression::Expr;
use super::ids::*;
use super::unit::Unit;
use crate::id::IdVec;
use crate::source::{Source, Span};

pub use super::frame::*;
pub use super::load::*;
pub use super::picture::*;

/// The contents of a model file.
#[derive(Clone, PartialEq, Debug)]
pub struct Model {
    /// The text it was read from.
    pub source: Source,
    /// The model's name, an identifier.
    pub name: String,
    /// Title or description, for documentation of the generated code.
    pub doc: String,
    /// Degrees of freedom as stated by the author.
    pub dof: Option<(usize, Span)>,
    /// Parameters, in the author's order.
    pub parameters: IdVec<ParameterId, Parameter>,
    /// Generalised coordinates q.
    pub coordinates: IdVec<CoordinateId, Coordinate>,
    /// Generalised speeds u.
    pub speeds: IdVec<SpeedId, Speed>,
    /// Inputs.
    pub inputs: IdVec<InputId, Input>,
    /// Intermediate quantities.
    pub definitions: IdVec<DefinitionId, Definition>,
    /// Frames; id 0 is N.
    pub frames: IdVec<FrameId, Frame>,
    /// Points; id 0 is O.
    pub points: IdVec<PointId, Point>,
    /// Bodies.
    pub bodies: IdVec<BodyId, Body>,
    /// Configuration constraints, each expression = 0.
    pub configuration_constraints: Vec<Constraint>,
    /// Motion constraints, each expression (linear in the speeds) = 0.
    pub motion_constraints: Vec<Constraint>,
    /// Uniform gravity (m/s^2), a vector; acts on every body with `weight`.
    pub gravity: Option<Expr>,
    /// Forces, torques and spring-dampers.
    pub loads: Vec<Load>,
    /// Ports, where other parts attach.
    pub ports: Vec<Port>,
    /// Requested outputs, in order.
    pub outputs: Vec<Output>,
    /// Configurations to be sampled besides the nominal one: (name, given coordinates).
    pub configurations: Vec<Configuration>,
    /// Entities in an order in which each refers only to earlier ones.
    pub order: Vec<Entity>,
    /// `[start]`: values of independent coordinates and speeds (dependent ones are start guesses).
    pub start: Vec<(StartRef, f64)>,
    /// The values of `start` as expressions, as the author wrote them.
    pub start_written: Vec<(StartRef, Expr)>,
    /// `[law]`: inputs as expressions of t, q, u and parameters.
    pub laws: Vec<(InputId, Expr)>,
    /// `[commanded]`: coordinates by quantities that a scene may command in their place.
    pub commanded: Vec<Commanded>,
    /// `[run]`.
    pub run: Run,
    /// `[view]`.
    pub view: View,
}

/// What an entry of [`Model::order`] stands for.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Entity {
    /// A parameter's value expression.
    Parameter(ParameterId),
    /// A definition.
    Definition(DefinitionId),
    /// A frame.
    Frame(FrameId),
    /// A point.
    Point(PointId),
    /// A coordinate given in closed form.
    Coordinate(CoordinateId),
}

/// A number the author may change.
#[derive(Clone, PartialEq, Debug)]
pub struct Parameter {
    /// Its name.
    pub name: String,
    /// Description, for documentation.
    pub doc: String,
    /// Coherent SI unit, e.g. `kg m^2`.
    pub unit: String,
    /// Unit as written, such as `mm`, and its value in `unit`.
    pub written_unit: (String, f64),
    /// Value: a constant, or an expression of earlier parameters.
    pub value: Expr,
    /// A tunable parameter stays a field of the generated code; a fixed one is folded.
    pub tunable: bool,
    /// Lowest and highest value that it may have, SI.
    pub range: (f64, f64),
    /// Where it is declared.
    pub span: Span,
}

/// A generalised coordinate q.
#[derive(Clone, PartialEq, Debug)]
pub struct Coordinate {
    /// Its name.
    pub name: String,
    /// Description.
    pub doc: String,
    /// Coherent SI unit, such as `m` or `rad`.
    pub unit: String,
    /// Unit as written, such as `mm` or `deg`, and its value in `unit`.
    pub written_unit: (String, f64),
    /// Independent (state) or solved from the configuration constraints.
    pub independent: bool,
    /// Value at the nominal configuration (a start guess where dependent), SI.
    pub nominal: f64,
    /// Range for sampling (independent) or plausible range (dependent), SI.
    pub range: (f64, f64),
    /// Nominal value and ends of the range as expressions, as the author wrote them.
    pub written: [Option<Expr>; 3],
    /// Closed form of a dependent coordinate, which then is not part of the state.
    pub closed_form: Option<Expr>,
    /// Where it is declared.
    pub span: Span,
}

/// A generalised speed u.
#[derive(Clone, PartialEq, Debug)]
pub struct Speed {
    /// Its name, `u_<coordinate>` unless given.
    pub name: String,
    /// Unit as written.
    pub unit: String,
    /// u = q_dot of this coordinate, or a linear combination of coordinate rates.
    pub meaning: SpeedMeaning,
    /// Independent, or eliminated through the constraints.
    pub independent: bool,
    /// Where it is declared.
    pub span: Span,
}

/// How a speed relates to the rates of the coordinates.
#[derive(Clone, PartialEq, Debug)]
pub enum SpeedMeaning {
    /// u = q_dot.
    RateOf(CoordinateId),
    /// u = expression, linear in [`Rate`](super::expression::ExprKind::Rate)s.
    Combination(Expr),
}

impl Coordinate {
    /// Does the model state an end of its range?
    #[must_use]
    pub fn states_range(&self) -> bool {
        self.written[1..].iter().any(Option::is_some)
    }
}

/// An input.
#[derive(Clone, PartialEq, Debug)]
pub struct Input {
    /// Its name.
    pub name: String,
    /// Description.
    pub doc: String,
    /// Coherent SI unit.
    pub unit: String,
    /// Unit as written, such as `kN`, and its value in `unit`.
    pub written_unit: (String, f64),
    /// Where it is declared.
    pub span: Span,
}

/// A named intermediate quantity; its name survives into the generated code.
#[derive(Clone, PartialEq, Debug)]
pub struct Definition {
    /// Its name.
    pub name: String,
    /// Scalar or vector expression.
    pub value: Expr,
    /// Unit as written, such as `mm`, and its value in SI units, where it is stated.
    pub written_unit: Option<(String, f64)>,
    /// Where it is declared.
    pub span: Span,
}

/// A point.
#[derive(Clone, PartialEq, Debug)]
pub struct Point {
    /// Its name.
    pub name: String,
    /// Position from the origin O (m); may name other points (their positions from O).
    pub position: Expr,
    /// Other expressions of the same position, one per closed loop: each gives the configuration
    /// constraint `position - closure = 0` (3 equations).
    pub closures: Vec<Expr>,
    /// Its velocity in N (m/s), where no coordinates locate it: a body that rolls. The position
    /// then counts only up to a displacement that nothing depends on.
    pub velocity: Option<Expr>,
    /// Where it is declared.
    pub span: Span,
}

/// A rigid body or a particle.
#[derive(Clone, PartialEq, Debug)]
pub struct Body {
    /// Its name.
    pub name: String,
    /// Mass centre.
    pub centre: PointId,
    /// Mass (kg), 0 for a body of pure inertia.
    pub mass: Option<Expr>,
    /// The frame fixed in it; none for a particle.
    pub frame: Option<FrameId>,
    /// Ixx, Iyy, Izz, Iyz, Ixz, Ixy of the inertia matrix about the mass centre, in `frame`.
    pub inertia: [Option<Expr>; 6],
    /// Lengths of the shape from which mass or inertia are computed (m), the wall of a hollow one among them; all 0 or
    /// more.
    pub lengths: Vec<Expr>,
    /// Does gravity act on it?
    pub weight: bool,
    /// Where it is declared.
    pub span: Span,
}

/// An equation `expression = 0`.
#[derive(Clone, PartialEq, Debug)]
pub struct Constraint {
    /// Its name.
    pub name: String,
    /// Scalar, or vector (then three equations).
    pub expression: Expr,
    /// What it is measured in, once units have been checked.
    pub unit: Unit,
    /// Where it is declared.
    pub span: Span,
}

/// A requested output.
#[derive(Clone, PartialEq, Debug)]
pub struct Output {
    /// Its name.
    pub name: String,
    /// Scalar expression.
    pub value: Expr,
    /// Unit as inferred.
    pub unit: String,
    /// Where it is declared.
    pub span: Span,
}

/// A configuration to be sampled when pivots are chosen.
#[derive(Clone, PartialEq, Debug)]
pub struct Configuration {
    /// Its name.
    pub name: String,
    /// Given coordinates; left-out independent ones are nominal.
    pub values: Vec<(CoordinateId, f64)>,
    /// The same as they are written.
    pub written: Vec<(CoordinateId, Expr)>,
}

/// A coordinate as a function of definitions, such as a height by heave and slopes. It becomes the coordinate's closed
/// form where a scene commands one of these definitions.
#[derive(Clone, PartialEq, Debug)]
pub struct Commanded {
    /// The coordinate.
    pub coordinate: CoordinateId,
    /// Its value.
    pub value: Expr,
    /// The same as it is written.
    pub written: String,
}

/// A start value's owner.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum StartRef {
    /// A coordinate.
    Coordinate(CoordinateId),
    /// A speed.
    Speed(SpeedId),
}

/// `[run]`: defaults for `smartbed run`.
#[derive(Clone, PartialEq, Debug)]
pub struct Run {
    /// Simulated time (s).
    pub seconds: f64,
    /// Step size (s).
    pub step: f64,
    /// Method by name.
    pub method: String,
    /// Steps per row written.
    pub every: usize,
}

impl Default for Run {
    fn default() -> Self {
        Self { seconds: 1.0, step: 1e-3, method: "rk4".to_owned(), every: 1 }
    }
}
