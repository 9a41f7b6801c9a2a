//! Warnings about what is declared and then never used.

use std::collections::BTreeSet;

use crate::diagnostic::{Diagnostic, Diagnostics};
use crate::model::data::*;
use crate::model::expression::ExprKind;
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
        // Frames and points at the place of a coordinate have come with it from a joint: nobody wrote them.
        let made: BTreeSet<Span> = self.coordinates.iter().map(|c| c.span).collect();
        for (id, f) in self.frames.enumerate().skip(1).filter(|(_, f)| !made.contains(&f.span)) {
            warn(mentioned.frames.contains(&id), "frame", &f.name, f.span);
        }
        for (id, p) in self.points.enumerate().skip(1).filter(|(_, p)| !made.contains(&p.span)) {
            // A point with closures states constraints by itself.
            warn(mentioned.points.contains(&id) || !p.closures.is_empty(), "point", &p.name, p.span);
        }
        found
    }
}

impl Mentioned {
    fn in_model(model: &Model) -> Self {
        let mut found = Self::default();
        for (_, expr) in model.expressions() {
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
        found.frames.extend(model.frames.iter().filter_map(|frame| frame.orientation.parent()));
        for body in model.bodies.iter() {
            found.points.insert(body.centre);
            found.frames.extend(body.frame);
        }
        for port in &model.ports {
            found.frames.insert(port.frame);
            found.points.insert(port.point);
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
        // A point may be there for the picture alone.
        found.points.extend(model.view.links.iter().flatten().flatten());
        found.points.extend(model.view.shapes.iter().filter_map(|(_, shape)| shape.at));
        found
    }
}
