//! Checks what each expression may depend on.
//!
//! Masses are constant, positions do not depend on speeds, constraints do not depend on inputs, motion constraints and
//! stated velocities are linear in the speeds: each rule is one line of [`check`].

use std::ops::BitOr;

use crate::diagnostic::{Diagnostic, Diagnostics};
use crate::id::IdVec;
use crate::model::data::*;
use crate::model::draft::Draft;
use crate::model::expression::{Expr, ExprKind};
use crate::model::ids::*;
use crate::model::walk::Role;

/// A set of things an expression depends on.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Reach(u8);

impl Reach {
    /// Parameters and numbers only.
    pub const CONSTANT: Self = Self(0);
    /// Independent coordinates, or closed forms of them.
    pub const COORDINATES: Self = Self(1);
    /// Dependent coordinates.
    pub const DEPENDENT: Self = Self(2);
    /// Speeds, velocities.
    pub const SPEEDS: Self = Self(4);
    /// `q_dot(...)`.
    pub const RATES: Self = Self(8);
    /// Inputs.
    pub const INPUTS: Self = Self(16);
    /// Time.
    pub const TIME: Self = Self(32);

    /// Is this a subset of the other set?
    #[must_use]
    pub fn within(self, other: Self) -> bool {
        self.0 & !other.0 == 0
    }

    /// The first member that the other set lacks, in words.
    fn beyond(self, other: Self) -> &'static str {
        let names =
            ["the coordinates", "dependent coordinates", "the speeds", "rates q_dot", "the inputs", "time"];
        let first = (self.0 & !other.0).trailing_zeros() as usize;
        names.get(first).copied().unwrap_or("nothing")
    }
}

impl BitOr for Reach {
    type Output = Self;
    fn bitor(self, other: Self) -> Self {
        Self(self.0 | other.0)
    }
}

/// What positions may depend on: coordinates, and time in a driven model.
const CONFIGURATION: Reach = Reach(1 | 2 | 32);
const MOTION: Reach = Reach(1 | 2 | 4 | 8 | 32);
const STATE: Reach = Reach(1 | 2 | 4);

/// Everything there is.
const ANYTHING: Reach = Reach(1 | 2 | 4 | 8 | 16 | 32);

/// The dependences of each entity.
struct Reaches {
    coordinates: IdVec<CoordinateId, Reach>,
    definitions: IdVec<DefinitionId, Reach>,
    frames: IdVec<FrameId, Reach>,
    points: IdVec<PointId, Reach>,
    /// Degree of each definition in the speeds; 2 stands for anything more than linear.
    degrees: IdVec<DefinitionId, u32>,
}

/// Checks every rule.
pub fn check(draft: &Draft, found: &mut Diagnostics) {
    let model = &draft.model;
    let of = Reaches::of_entities(model);
    for (role, expression) in model.expressions() {
        let (what, allowed) = rule(role);
        of.within(expression, allowed, what, found);
        if let Role::MotionConstraint | Role::StatedVelocity(_) | Role::Speed(_) = role {
            of.linear(expression, role, what, found);
        }
    }
}

/// What an expression is called, and what it may depend on.
fn rule(role: Role) -> (&'static str, Reach) {
    match role {
        Role::Parameter(_) => ("a parameter", Reach::CONSTANT),
        // A definition is judged where it is used.
        Role::Definition(_) => ("a definition", ANYTHING),
        Role::Orientation(..) => ("an orientation", CONFIGURATION),
        Role::FixedVector(..) => ("a fixed vector", CONFIGURATION),
        Role::FixedComponent(..) => ("a component of a fixed vector", Reach::CONSTANT),
        Role::Position(_) | Role::Closure(_) => ("a position", CONFIGURATION),
        Role::StatedVelocity(_) => ("a stated velocity", MOTION),
        Role::Mass(_) => ("a mass", Reach::CONSTANT),
        Role::Inertia(_) => ("a moment of inertia", Reach::CONSTANT),
        Role::ConfigurationConstraint => ("a configuration constraint", CONFIGURATION),
        Role::MotionConstraint => ("a motion constraint", MOTION),
        Role::Gravity => ("gravity", Reach::CONSTANT),
        Role::ClosedForm(_) => ("a closed form", Reach::COORDINATES | Reach::TIME),
        Role::Commanded(_) => ("a commanded coordinate", Reach::COORDINATES | Reach::TIME),
        Role::Nominal(_) => ("a nominal value or range", Reach::CONSTANT),
        Role::Speed(_) => ("a speed", CONFIGURATION | Reach::RATES),
        Role::Start(_) => ("a start value", Reach::CONSTANT),
        Role::Configuration(_) => ("a configuration", Reach::CONSTANT),
        Role::Law(_) => ("a law", STATE | Reach::TIME),
        Role::Force => ("a force", ANYTHING),
        Role::Torque => ("a torque", ANYTHING),
        Role::Stiffness | Role::RestLength | Role::Damping => ("a number of a spring", Reach::CONSTANT),
        Role::CoordinateStiffness(_) | Role::CoordinateRest(_) | Role::CoordinateDamping(_) => {
            ("a number of a spring", Reach::CONSTANT)
        }
        Role::Output(_) => ("an output", ANYTHING),
        Role::Size => ("a length of a shape", Reach::CONSTANT),
    }
}

impl Reaches {
    /// The dependences of definitions, frames, points and closed forms, each after what it refers to.
    fn of_entities(model: &Model) -> Self {
        let free = |c: &Coordinate| if c.independent { Reach::COORDINATES } else { Reach::DEPENDENT };
        let mut of = Self {
            coordinates: model.coordinates.iter().map(free).collect(),
            definitions: model.definitions.iter().map(|_| Reach::CONSTANT).collect(),
            frames: model.frames.iter().map(|_| Reach::CONSTANT).collect(),
            points: model.points.iter().map(|_| Reach::CONSTANT).collect(),
            degrees: model.definitions.iter().map(|_| 0).collect(),
        };
        for entity in &model.order {
            match *entity {
                Entity::Parameter(_) => {}
                Entity::Definition(id) => {
                    let value = &model.definitions[id].value;
                    of.definitions[id] = of.of(value);
                    of.degrees[id] = of.degree(value);
                }
                Entity::Frame(id) => of.frames[id] = of.orientation(&model.frames[id].orientation),
                Entity::Coordinate(id) => {
                    if let Some(form) = &model.coordinates[id].closed_form {
                        of.coordinates[id] = of.of(form);
                    }
                }
                Entity::Point(id) => of.points[id] = of.of(&model.points[id].position),
            }
        }
        of
    }

    fn orientation(&self, orientation: &Orientation) -> Reach {
        let parent = orientation.parent().map_or(Reach::CONSTANT, |parent| self.frames[parent]);
        orientation.expressions().into_iter().fold(parent, |all, (_, part)| all | self.of(part))
    }

    /// Requires motion constraints, stated velocities and speeds to be linear in speeds and rates.
    fn linear(&self, expression: &Expr, role: Role, what: &str, found: &mut Diagnostics) {
        match self.degree(expression) {
            0 if matches!(role, Role::StatedVelocity(_)) => {}
            1 => {}
            0 => found.push(
                Diagnostic::error(format!("{what} must depend on the motion"))
                    .label(expression.span, "no speed and no rate occurs here")
                    .help("equations between coordinates alone belong into [constraints.configuration]"),
            ),
            _ => found.push(
                Diagnostic::error(format!("{what} must be linear in the speeds"))
                    .label(self.nonlinear(expression).span, "this is not linear in the speeds")
                    .help("Kane's method needs velocities of the form sum of a_r(q, t) u_r + b(q, t)"),
            ),
        }
    }

    /// Requires the expression to depend on nothing but `allowed`; the error points at the first name that violates
    /// this.
    fn within(&self, expr: &Expr, allowed: Reach, what: &str, found: &mut Diagnostics) {
        let mut culprit = None;
        expr.visit(&mut |e| {
            if culprit.is_none() && !self.leaf(e).within(allowed) {
                culprit = Some(e);
            }
        });
        if let Some(culprit) = culprit {
            let help = match allowed {
                Reach::CONSTANT => "only numbers, parameters and functions of them may stand here",
                CONFIGURATION => {
                    "positions, orientations and configuration constraints depend on coordinates, parameters and time only; speeds may enter loads, outputs and [constraints.motion]"
                }
                _ if !Reach::DEPENDENT.within(allowed) => {
                    "only independent coordinates and time may stand here"
                }
                _ => "this kind of quantity is not known where the expression is used",
            };
            let beyond = self.leaf(culprit).beyond(allowed);
            found.push(
                Diagnostic::error(format!("{what} cannot depend on {beyond}"))
                    .label(culprit.span, format!("this depends on {beyond}"))
                    .help(help),
            );
        }
    }

    fn of(&self, expr: &Expr) -> Reach {
        let mut reach = Reach::CONSTANT;
        expr.visit(&mut |e| reach = reach | self.leaf(e));
        reach
    }

    /// The dependences that a node has by itself, without its parts.
    fn leaf(&self, expr: &Expr) -> Reach {
        match &expr.kind {
            ExprKind::Time => Reach::TIME,
            ExprKind::Coordinate(id) => self.coordinates[*id],
            ExprKind::Rate(_) => Reach::RATES,
            ExprKind::Speed(_) => Reach::SPEEDS,
            ExprKind::Input(_) => Reach::INPUTS,
            ExprKind::Definition(id) => self.definitions[*id],
            ExprKind::Point(id) => self.points[*id],
            ExprKind::Velocity(id) => self.points[*id] | Reach::SPEEDS,
            ExprKind::Axis(id, _) => self.frames[*id],
            ExprKind::AngularVelocity(id) => self.frames[*id] | Reach::SPEEDS,
            _ => Reach::CONSTANT,
        }
    }

    /// Degree in speeds and rates; 2 for anything more than linear.
    fn degree(&self, expr: &Expr) -> u32 {
        let of_parts = || expr.parts().into_iter().map(|e| self.degree(e)).max().unwrap_or(0);
        match &expr.kind {
            ExprKind::Speed(_) | ExprKind::Rate(_) | ExprKind::Velocity(_) | ExprKind::AngularVelocity(_) => {
                1
            }
            ExprKind::Definition(id) => self.degrees[*id],
            ExprKind::Multiply(a, b) | ExprKind::Dot(a, b) | ExprKind::Cross(a, b) => {
                (self.degree(a) + self.degree(b)).min(2)
            }
            ExprKind::Divide(a, b) => (self.degree(a) + 2 * self.degree(b)).min(2),
            ExprKind::Power(a, 1) => self.degree(a),
            ExprKind::Power(..) | ExprKind::Call(..) | ExprKind::Norm(_) => (2 * of_parts()).min(2),
            _ => of_parts(),
        }
    }

    /// The smallest part that is not linear, for the error message.
    fn nonlinear<'e>(&self, expr: &'e Expr) -> &'e Expr {
        let mut at = expr;
        while let Some(part) = at.parts().into_iter().find(|part| 1 < self.degree(part)) {
            at = part;
        }
        at
    }
}
