//! The data of a model: what each section states, with names resolved to ids and every place in the text kept.

use super::expression::{Axis, Expr};
use super::ids::*;
use super::unit::Unit;
use crate::id::IdVec;
use crate::source::{Source, Span};

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

/// A reference frame.
#[derive(Clone, PartialEq, Debug)]
pub struct Frame {
    /// Its name.
    pub name: String,
    /// How it is oriented.
    pub orientation: Orientation,
    /// Vectors stated to be constant in this frame: (vector, its x, y, z components here). A consequence of the
    /// constraints that the derivation may use; checked at the sampled configurations.
    pub fixed_vectors: Vec<FixedVector>,
    /// Where it is declared.
    pub span: Span,
}

/// `vector` has the constant components `components` in the frame that states it.
#[derive(Clone, PartialEq, Debug)]
pub struct FixedVector {
    /// The vector, given in other frames.
    pub vector: Expr,
    /// Its components here: expressions of parameters only.
    pub components: [Expr; 3],
    /// Where it is stated.
    pub span: Span,
}

/// Orientation of a frame.
#[derive(Clone, PartialEq, Debug)]
pub enum Orientation {
    /// The inertial frame.
    Inertial,
    /// Successive simple rotations from the parent, each about an axis of the frame reached so far (rad).
    Rotations {
        /// The frame to start from.
        parent: FrameId,
        /// (axis, angle) in order.
        rotations: Vec<(Axis, Expr)>,
    },
    /// Unit vectors given as vector expressions of other frames. Two are enough (the third is
    /// their cross product); they are orthonormal wherever the constraints hold. Angular velocity by Kane's definition.
    Directions {
        /// x, y, z.
        axes: [Option<Expr>; 3],
    },
    /// Euler parameters of the turn from the parent: cos(angle/2) and axis sin(angle/2), of unit length.
    Euler {
        /// The frame to start from.
        parent: FrameId,
        /// e0, e1, e2, e3.
        parameters: Box<[Expr; 4]>,
    },
}

/// The role of an expression of an [`Orientation`]: a number without unit, or a vector of such.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct OrientationPart {
    /// In words.
    pub what: &'static str,
    /// A vector?
    pub is_vector: bool,
}

impl OrientationPart {
    const ANGLE: Self = Self { what: "an angle of rotation", is_vector: false };
    const EULER: Self = Self { what: "an Euler parameter", is_vector: false };
    const DIRECTION: Self = Self { what: "a unit vector", is_vector: true };
}

impl Orientation {
    /// The frame from which the rotations start, whatever frames the expressions name.
    #[must_use]
    pub fn parent(&self) -> Option<FrameId> {
        match self {
            Self::Rotations { parent, .. } | Self::Euler { parent, .. } => Some(*parent),
            Self::Inertial | Self::Directions { .. } => None,
        }
    }

    /// Its expressions. Checks and walks go through these alone: they know of no kind of orientation.
    #[must_use]
    pub fn expressions(&self) -> Vec<(OrientationPart, &Expr)> {
        match self {
            Self::Inertial => Vec::new(),
            Self::Rotations { rotations, .. } => {
                rotations.iter().map(|(_, angle)| (OrientationPart::ANGLE, angle)).collect()
            }
            Self::Euler { parameters, .. } => {
                parameters.iter().map(|e| (OrientationPart::EULER, e)).collect()
            }
            Self::Directions { axes } => {
                axes.iter().flatten().map(|axis| (OrientationPart::DIRECTION, axis)).collect()
            }
        }
    }
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

/// Something that does work on the mechanism.
#[derive(Clone, PartialEq, Debug)]
pub struct Load {
    /// Its name.
    pub name: String,
    /// Its kind, and where it acts.
    pub kind: LoadKind,
    /// Where it is declared.
    pub span: Span,
}

/// Kinds of loads.
#[derive(Clone, PartialEq, Debug)]
pub enum LoadKind {
    /// Force vector (N) at a point; the reaction acts on `reaction` if given, else on the ground.
    Force {
        /// Point of application.
        point: PointId,
        /// Force.
        force: Expr,
        /// Point that feels the reaction.
        reaction: Option<PointId>,
    },
    /// Torque vector (N m) on a frame's body; the reaction on `reaction` if given, else on the ground.
    Torque {
        /// Frame it acts on.
        frame: FrameId,
        /// Torque.
        torque: Expr,
        /// Frame that feels the reaction.
        reaction: Option<FrameId>,
    },
    /// Linear spring-damper between two points. Tension = stiffness (length - rest_length) + damping length_rate.
    Spring {
        /// The two ends.
        ends: [PointId; 2],
        /// Stiffness (N/m).
        stiffness: Expr,
        /// Rest length (m).
        rest_length: Expr,
        /// Damping (N s/m).
        damping: Option<Expr>,
    },
    /// Spring-damper on a coordinate: generalised force -stiffness (q - rest) - damping q_dot.
    CoordinateSpring {
        /// The coordinate.
        coordinate: CoordinateId,
        /// Stiffness (unit of force per unit of q).
        stiffness: Expr,
        /// Value without force.
        rest: Expr,
        /// Damping.
        damping: Option<Expr>,
    },
}

/// A frame with a point at which other parts attach: they follow its pose and push it with a wrench.
#[derive(Clone, PartialEq, Debug)]
pub struct Port {
    /// Its name.
    pub name: String,
    /// Description.
    pub doc: String,
    /// The frame that attached parts turn with.
    pub frame: FrameId,
    /// The point that they move with; moments are about it.
    pub point: PointId,
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

/// `[view]`: options of pictures. No equation depends on it.
#[derive(Clone, PartialEq, Default, Debug)]
pub struct View {
    /// Shapes in place of inertia ellipsoids.
    pub shapes: Vec<(BodyId, Shape)>,
    /// Colours (red, green, blue).
    pub colours: Vec<(Shown, [u8; 3])>,
    /// Items that are left out.
    pub hidden: Vec<Shown>,
    /// Rods between points; `None` for those that the points' expressions suggest.
    pub links: Option<Vec<[PointId; 2]>>,
}

/// An item of a picture.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Shown {
    /// A body.
    Body(BodyId),
    /// A point.
    Point(PointId),
    /// A spring, by its index among the loads.
    Spring(usize),
}

/// The shape of a body, along the axes of its frame.
#[derive(Clone, PartialEq, Debug)]
pub struct Shape {
    /// Its kind.
    pub kind: ShapeKind,
    /// Its lengths (m), in the order of [`ShapeKind`].
    pub sizes: Vec<Expr>,
    /// Axis of a cylinder.
    pub axis: Axis,
    /// Its middle, if that is not the mass centre.
    pub at: Option<PointId>,
}

/// Kinds of shapes.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum ShapeKind {
    /// Edges along x, y, z.
    Box,
    /// Radius, length.
    Cylinder,
    /// Radius.
    Ball,
}
