//! Warnings about what is declared and then never used.

use std::collections::BTreeSet;

use crate::diagnostic::{Diagnostic, Diagnostics};
use crate::model::data::*;
use crate::model::expression::{Expr, ExprKind};
use crate::model::ids::*;
use crate::source::Span;

/// What is mentioned somewhere.
#[derive(Default)]
struct Mentioned {
    parameters: BTreeSet<ParameterId>,
    definitions: BTreeSet<DefinitionId>,
    inputs: BTreeSet<InputId>,
    frames: BTreeSet<FrameId>,
    points: BTreeSet<PointId>,
}

impl Model {
    /// Warnings: parameters, definitions, inputs, frames and points that nothing refers to.
    #[must_use]
    pub fn warnings(&self) -> Diagnostics {
        let mut found = Diagnostics::new(self.source.clone());
        let mentioned = Mentioned::in_model(self);
        let mut warn = |used: bool, kind: &str, name: &str, span: Span| {
            if !used {
                found.push(
                    Diagnostic::warning(format!("{kind} `{name}` is never used"))
                        .label(span, "nothing refers to it")
                        .help("remove it, or use it"),
                );
            }
        };
        for (id, p) in self.parameters.enumerate() {
            warn(mentioned.parameters.contains(&id), "parameter", &p.name, p.span);
        }
        for (id, d) in self.definitions.enumerate() {
            warn(mentioned.definitions.contains(&id), "definition", &d.name, d.span);
        }
        for (id, i) in self.inputs.enumerate() {
            warn(mentioned.inputs.contains(&id), "input", &i.name, i.span);
        }
        for (id, f) in self.frames.enumerate().skip(1) {
            warn(mentioned.frames.contains(&id), "frame", &f.name, f.span);
        }
        for (id, p) in self.points.enumerate().skip(1) {
            // A point with closures states constraints by itself.
            warn(mentioned.points.contains(&id) || !p.closures.is_empty(), "point", &p.name, p.span);
        }
        found
    }

    /// Every expression of the model.
    pub fn expressions(&self) -> Vec<&Expr> {
        let mut all: Vec<&Expr> = self.parameters.iter().map(|p| &p.value).collect();
        all.extend(self.coordinates.iter().filter_map(|c| c.closed_form.as_ref()));
        all.extend(self.speeds.iter().filter_map(|s| match &s.meaning {
            SpeedMeaning::Combination(e) => Some(e),
            SpeedMeaning::RateOf(_) => None,
        }));
        all.extend(self.definitions.iter().map(|d| &d.value));
        for frame in self.frames.iter() {
            match &frame.orientation {
                Orientation::Inertial => {}
                Orientation::Rotations { rotations, .. } => all.extend(rotations.iter().map(|(_, e)| e)),
                Orientation::Directions { axes } => all.extend(axes.iter().flatten()),
            }
            all.extend(
                frame.fixed_vectors.iter().flat_map(|f| std::iter::once(&f.vector).chain(&f.components)),
            );
        }
        all.extend(self.points.iter().flat_map(|p| std::iter::once(&p.position).chain(&p.closures)));
        all.extend(self.bodies.iter().flat_map(|b| b.mass.iter().chain(b.inertia.iter().flatten())));
        all.extend(
            self.configuration_constraints.iter().chain(&self.motion_constraints).map(|c| &c.expression),
        );
        all.extend(&self.gravity);
        all.extend(self.loads.iter().flat_map(|l| l.kind.expressions()));
        all.extend(self.outputs.iter().map(|o| &o.value));
        all.extend(self.laws.iter().map(|(_, e)| e));
        all
    }
}

impl LoadKind {
    /// Its expressions.
    fn expressions(&self) -> Vec<&Expr> {
        match self {
            Self::Force { force, .. } => vec![force],
            Self::Torque { torque, .. } => vec![torque],
            Self::Spring { stiffness, rest_length, damping, .. } => {
                [stiffness, rest_length].into_iter().chain(damping).collect()
            }
            Self::CoordinateSpring { stiffness, rest, damping, .. } => {
                [stiffness, rest].into_iter().chain(damping).collect()
            }
        }
    }
}

impl Mentioned {
    fn in_model(model: &Model) -> Self {
        let mut found = Self::default();
        for expr in model.expressions() {
            expr.visit(&mut |e| match &e.kind {
                ExprKind::Parameter(id) => {
                    found.parameters.insert(*id);
                }
                ExprKind::Definition(id) => {
                    found.definitions.insert(*id);
                }
                ExprKind::Input(id) => {
                    found.inputs.insert(*id);
                }
                ExprKind::Axis(id, _) | ExprKind::AngularVelocity(id) => {
                    found.frames.insert(*id);
                }
                ExprKind::Point(id) | ExprKind::Velocity(id) => {
                    found.points.insert(*id);
                }
                _ => {}
            });
        }
        for frame in model.frames.iter() {
            if let Orientation::Rotations { parent, .. } = &frame.orientation {
                found.frames.insert(*parent);
            }
        }
        for body in model.bodies.iter() {
            found.points.insert(body.centre);
            found.frames.extend(body.frame);
        }
        for load in &model.loads {
            match &load.kind {
                LoadKind::Force { point, reaction, .. } => {
                    found.points.insert(*point);
                    found.points.extend(*reaction);
                }
                LoadKind::Torque { frame, reaction, .. } => {
                    found.frames.insert(*frame);
                    found.frames.extend(*reaction);
                }
                LoadKind::Spring { ends, .. } => found.points.extend(ends),
                LoadKind::CoordinateSpring { .. } => {}
            }
        }
        found
    }
}
