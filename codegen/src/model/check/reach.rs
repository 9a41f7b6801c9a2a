//! What an expression depends on, and what may depend on what.
//!
//! Masses are constant, positions know no speeds, constraints know no inputs, motion constraints and
//! stated velocities are linear in the speeds: each rule is one line of [`check`].

use std::ops::BitOr;

use crate::diagnostic::{Diagnostic, Diagnostics};
use crate::id::IdVec;
use crate::model::data::*;
use crate::model::draft::Draft;
use crate::model::expression::{Expr, ExprKind};
use crate::model::ids::*;

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

    /// Is all of this in the other set?
    #[must_use]
    pub fn within(self, other: Self) -> bool {
        self.0 & !other.0 == 0
    }

    /// The first member that is not in the other set, in words.
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

/// What a place may depend on: coordinates, and time where it is driven.
const CONFIGURATION: Reach = Reach(1 | 2 | 32);
const MOTION: Reach = Reach(1 | 2 | 4 | 8 | 32);
const STATE: Reach = Reach(1 | 2 | 4);

/// What each entity depends on.
struct Reaches<'a> {
    model: &'a Model,
    coordinates: IdVec<CoordinateId, Reach>,
    definitions: IdVec<DefinitionId, Reach>,
    frames: IdVec<FrameId, Reach>,
    points: IdVec<PointId, Reach>,
    /// Degree of each definition in the speeds; 2 stands for more than one.
    degrees: IdVec<DefinitionId, u32>,
}

/// Checks every rule.
pub fn check(draft: &Draft, found: &mut Diagnostics) {
    let model = &draft.model;
    let mut of = Reaches {
        model,
        coordinates: model
            .coordinates
            .iter()
            .map(|c| if c.independent { Reach::COORDINATES } else { Reach::DEPENDENT })
            .collect(),
        definitions: model.definitions.iter().map(|_| Reach::CONSTANT).collect(),
        frames: model.frames.iter().map(|_| Reach::CONSTANT).collect(),
        points: model.points.iter().map(|_| Reach::CONSTANT).collect(),
        degrees: model.definitions.iter().map(|_| 0).collect(),
    };
    of.entities(found);
    for point in model.points.iter() {
        point.closures.iter().for_each(|e| of.within(e, CONFIGURATION, "a position", found));
    }
    for fixed in model.frames.iter().flat_map(|f| &f.fixed_vectors) {
        of.within(&fixed.vector, CONFIGURATION, "a fixed vector", found);
        fixed
            .components
            .iter()
            .for_each(|e| of.within(e, Reach::CONSTANT, "a component of a fixed vector", found));
    }
    for body in model.bodies.iter() {
        body.mass.iter().for_each(|e| of.within(e, Reach::CONSTANT, "a mass", found));
        body.inertia
            .iter()
            .flatten()
            .for_each(|e| of.within(e, Reach::CONSTANT, "a moment of inertia", found));
    }
    model.gravity.iter().for_each(|e| of.within(e, Reach::CONSTANT, "gravity", found));
    for constraint in &model.configuration_constraints {
        of.within(&constraint.expression, CONFIGURATION, "a configuration constraint", found);
    }
    of.motion(found);
    of.values(draft, found);
    model.loads.iter().for_each(|load| of.load(&load.kind, found));
    for output in &model.outputs {
        of.within(&output.value, STATE | Reach::RATES | Reach::INPUTS | Reach::TIME, "an output", found);
    }
}

impl Reaches<'_> {
    fn entities(&mut self, found: &mut Diagnostics) {
        for entity in &self.model.order {
            match *entity {
                Entity::Parameter(id) => {
                    self.within(&self.model.parameters[id].value, Reach::CONSTANT, "a parameter", found);
                }
                Entity::Definition(id) => {
                    let value = &self.model.definitions[id].value;
                    self.definitions[id] = self.of(value);
                    self.degrees[id] = self.degree(value);
                }
                Entity::Frame(id) => {
                    let expressions: Vec<&Expr> = match &self.model.frames[id].orientation {
                        Orientation::Inertial => Vec::new(),
                        Orientation::Rotations { parent, rotations } => {
                            self.frames[id] = self.frames[*parent];
                            rotations.iter().map(|(_, angle)| angle).collect()
                        }
                        Orientation::Directions { axes } => axes.iter().flatten().collect(),
                    };
                    for e in expressions {
                        self.within(e, CONFIGURATION, "an orientation", found);
                        self.frames[id] = self.frames[id] | self.of(e);
                    }
                }
                Entity::Coordinate(id) => {
                    if let Some(form) = &self.model.coordinates[id].closed_form {
                        let allowed = Reach::COORDINATES | Reach::TIME;
                        self.within(form, allowed, "a closed form", found);
                        self.coordinates[id] = self.of(form);
                    }
                }
                Entity::Point(id) => {
                    let position = &self.model.points[id].position;
                    self.within(position, CONFIGURATION, "a position", found);
                    self.points[id] = self.of(position);
                }
            }
        }
    }

    /// Motion constraints, stated velocities and speeds: linear in speeds and rates.
    fn motion(&self, found: &mut Diagnostics) {
        let constraints =
            self.model.motion_constraints.iter().map(|c| (&c.expression, "a motion constraint", MOTION));
        let velocities = self
            .model
            .points
            .iter()
            .filter_map(|p| Some((p.velocity.as_ref()?, "a stated velocity", MOTION)));
        let combinations = self.model.speeds.iter().filter_map(|speed| match &speed.meaning {
            SpeedMeaning::Combination(e) => Some((e, "a speed", CONFIGURATION | Reach::RATES)),
            SpeedMeaning::RateOf(_) => None,
        });
        for (expression, what, allowed) in constraints.chain(velocities).chain(combinations) {
            self.within(expression, allowed, what, found);
            match self.degree(expression) {
                0 if what == "a stated velocity" => {}
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
    }

    fn values(&self, draft: &Draft, found: &mut Diagnostics) {
        let model = self.model;
        for id in model.coordinates.ids() {
            for e in draft.coordinate_values[id].iter().flatten() {
                self.within(e, Reach::CONSTANT, "a nominal value or range", found);
            }
        }
        for (_, e) in draft.configuration_values.iter().flatten() {
            self.within(e, Reach::CONSTANT, "a configuration", found);
        }
        draft.start_values.iter().for_each(|(_, e)| self.within(e, Reach::CONSTANT, "a start value", found));
        model.laws.iter().for_each(|(_, e)| self.within(e, STATE | Reach::TIME, "a law", found));
    }

    fn load(&self, kind: &LoadKind, found: &mut Diagnostics) {
        let anything = STATE | Reach::RATES | Reach::INPUTS | Reach::TIME;
        let constants = |of: [Option<&Expr>; 3], found: &mut Diagnostics| {
            of.into_iter()
                .flatten()
                .for_each(|e| self.within(e, Reach::CONSTANT, "a number of a spring", found));
        };
        match kind {
            LoadKind::Force { force, .. } => self.within(force, anything, "a force", found),
            LoadKind::Torque { torque, .. } => self.within(torque, anything, "a torque", found),
            LoadKind::Spring { stiffness, rest_length, damping, .. } => {
                constants([Some(stiffness), Some(rest_length), damping.as_ref()], found);
            }
            LoadKind::CoordinateSpring { stiffness, rest, damping, .. } => {
                constants([Some(stiffness), Some(rest), damping.as_ref()], found);
            }
        }
    }

    /// The expression may depend on `allowed` only; the error points at the first name that does not.
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

    /// What one node adds by itself.
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

    /// Degree in speeds and rates, 2 for anything more than linear.
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

    /// The smallest part that is not linear.
    fn nonlinear<'e>(&self, expr: &'e Expr) -> &'e Expr {
        let mut at = expr;
        while let Some(part) = at.parts().into_iter().find(|part| 1 < self.degree(part)) {
            at = part;
        }
        at
    }
}
