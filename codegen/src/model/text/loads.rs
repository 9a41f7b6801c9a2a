//! The sections of loads: forces, torques, springs; and the ports, at which other parts exert forces.

use super::builder::{Builder, si};
use super::fields::Fields;
use crate::diagnostic::Diagnostic;
use crate::model::data::*;
use crate::model::expression::{Expr, ExprKind};
use crate::model::unit::Unit;

impl Builder<'_> {
    pub(super) fn loads(&mut self) {
        for section in ["forces", "torques", "springs"] {
            for (key, value) in self.entries(section) {
                let Some(fields) = Fields::new(key, value, self.found) else { continue };
                let kind = match section {
                    "forces" => self.force(&fields),
                    "torques" => self.torque(&fields),
                    _ => self.spring(&fields),
                };
                fields.finish(self.found);
                let name = key.name.clone();
                self.draft.model.loads.extend(kind.map(|kind| Load { name, kind, span: key.span }));
            }
        }
    }

    pub(super) fn ports(&mut self) {
        for (key, value) in self.entries("ports") {
            let Some(fields) = Fields::new(key, value, self.found) else { continue };
            let doc = fields.doc(self.found);
            let frame = fields.need("frame", "\"platform\"", self.found);
            let frame = self.frame_of(frame);
            let point = fields.need("point", "\"G\"", self.found);
            let point = self.point_of(point);
            fields.finish(self.found);
            let (Some(frame), Some(point)) = (frame, point) else { continue };
            self.draft.model.ports.push(Port { name: key.name.clone(), doc, frame, point, span: key.span });
        }
    }

    fn force(&mut self, fields: &Fields<'_>) -> Option<LoadKind> {
        let point = fields.need("point", "\"P\"", self.found);
        let point = self.point_of(point);
        let force = self.needed(fields, "force", Unit::FORCE, "\"F*N.z\"");
        let reaction = self.point_of(fields.get("reaction"));
        Some(LoadKind::Force { point: point?, force, reaction })
    }

    fn torque(&mut self, fields: &Fields<'_>) -> Option<LoadKind> {
        let frame = fields.need("frame", "\"link\"", self.found);
        let frame = self.frame_of(frame);
        let torque = self.needed(fields, "torque", Unit::TORQUE, "\"T*N.z\"");
        let reaction = self.frame_of(fields.get("reaction"));
        Some(LoadKind::Torque { frame: frame?, torque, reaction })
    }

    fn spring(&mut self, fields: &Fields<'_>) -> Option<LoadKind> {
        if let Some(coordinate) = fields.get("coordinate") {
            let coordinate = self.coordinate_of(Some(coordinate));
            let scale = coordinate.and_then(|id| self.draft.units.coordinates.get(id)).copied();
            let scale = scale.unwrap_or(si(Unit::NONE));
            // A generalised force does work along q: its unit is J per unit of q.
            let per_q = over(over(Unit::TORQUE, scale.unit), scale.unit);
            let stiffness = self.needed(fields, "stiffness", per_q, "\"k\"");
            let rest = match fields.get("rest") {
                Some(value) => self.quantity(value, scale),
                None => Expr { kind: ExprKind::Number(0.0), span: fields.span, unit: Unit::NONE },
            };
            let damping = self.optional(fields, "damping", over(per_q, Unit::RATE));
            return Some(LoadKind::CoordinateSpring { coordinate: coordinate?, stiffness, rest, damping });
        }
        let ends = match fields.array("between", self.found) {
            Some(([a, b], _)) => self.point_of(Some(a)).zip(self.point_of(Some(b))),
            _ => {
                self.found.push(
                    Diagnostic::error(format!("spring `{}` has no ends", fields.name))
                        .label(fields.span, "neither `between` with two points nor `coordinate` is here")
                        .help("between = [\"P\", \"Q\"] or coordinate = \"q\""),
                );
                None
            }
        };
        let stiffness = self.needed(fields, "stiffness", over(Unit::FORCE, Unit::LENGTH), "\"k\"");
        let rest_length = self.needed(fields, "rest_length", Unit::LENGTH, "\"l0\"");
        let damping = self.optional(fields, "damping", over(Unit::FORCE, Unit::VELOCITY));
        let (a, b) = ends?;
        Some(LoadKind::Spring { ends: [a, b], stiffness, rest_length, damping })
    }
}

/// Quotient of two units; exponents that are too large have been reported where they arose.
fn over(a: Unit, b: Unit) -> Unit {
    a.per(b).unwrap_or(Unit::NONE)
}
