//! The section `[bodies]`: mass and inertia, stated or computed from a shape; and gravity.

use super::builder::Builder;
use super::document::Value;
use super::fields::Fields;
use super::shapes::Solid;
use crate::diagnostic::Diagnostic;
use crate::id::Id;
use crate::model::data::*;
use crate::model::expression::Expr;
use crate::model::ids::*;
use crate::model::unit::Unit;
use crate::source::Span;

impl Builder<'_> {
    pub(super) fn bodies(&mut self) {
        for (key, value) in self.entries("bodies") {
            let Some(fields) = Fields::new(key, value, self.found) else { continue };
            let centre = fields.need("centre", "\"P\"", self.found);
            let centre = self.point_of(centre);
            let Ok(solid) = self.solid(&fields) else { continue };
            let given = fields.get("frame");
            let frame = self.frame_of(given);
            let mass = self.mass(&fields, solid.as_ref());
            let inertia = self.inertia(&fields, solid.as_ref(), mass.as_ref());
            let weight = fields.boolean("weight", self.found).unwrap_or(true);
            // An inertia that could not be read has been reported.
            let inertial = inertia.iter().any(Option::is_some)
                || fields.get("inertia").is_some_and(|given| !matches!(given, Value::Table(_)));
            fields.finish(self.found);
            self.check_body(key.span, &key.name, mass.is_some(), given.is_some(), inertial);
            let centre = centre.unwrap_or(PointId::from_index(0));
            let name = key.name.clone();
            let id = BodyId::from_index(self.draft.model.bodies.len());
            let lengths = solid.as_ref().map(|solid| solid.lengths.clone()).unwrap_or_default();
            if let Some((kind, sizes, axis)) = solid.and_then(|solid| solid.picture) {
                self.draft.model.view.shapes.push((id, Shape { kind, sizes, axis, at: None }));
            }
            self.draft.model.bodies.push(Body {
                name,
                centre,
                mass,
                frame,
                inertia,
                lengths,
                weight,
                span: key.span,
            });
        }
        self.draft.model.gravity = self
            .sections
            .scalars
            .iter()
            .find(|(key, _)| key.name == "gravity")
            .map(|(_, value)| self.expression(value));
    }

    /// A body's mass: stated, or the amount of its shape times its density.
    fn mass(&mut self, fields: &Fields<'_>, solid: Option<&Solid>) -> Option<Expr> {
        let mass = self.optional(fields, "mass", Unit::MASS);
        let Some(solid) = solid else { return mass };
        let density = self.optional(fields, "density", solid.density);
        let fault = match (&mass, &density) {
            (None, None) => {
                Some(("has a shape, but neither mass nor density", "add density = \"rho\" or mass = \"m\""))
            }
            (Some(_), Some(_)) => {
                Some(("has a mass and a density", "leave one of them out: the shape gives the other"))
            }
            _ => None,
        };
        if let Some((what, help)) = fault {
            self.found.push(
                Diagnostic::error(format!("body `{}` {what}", fields.name))
                    .label(fields.span, "this body")
                    .help(help),
            );
        }
        mass.or_else(|| density.map(|density| density * solid.amount.clone()))
    }

    /// A body's inertia: stated, or that of its shape.
    fn inertia(
        &mut self,
        fields: &Fields<'_>,
        solid: Option<&Solid>,
        mass: Option<&Expr>,
    ) -> [Option<Expr>; 6] {
        let table = fields.table("inertia", self.found);
        if let (Some(table), Some(_)) = (table, solid) {
            self.found.push(
                Diagnostic::error(format!("body `{}` has a shape and an inertia", fields.name))
                    .label(table.span, "the shape gives it")
                    .help("leave one of them out"),
            );
        }
        match (table, solid.zip(mass)) {
            (Some(table), _) => {
                let moments = Fields::of("inertia", table.span, table);
                let inertia = ["Ixx", "Iyy", "Izz", "Iyz", "Ixz", "Ixy"];
                let inertia = inertia.map(|name| self.optional(&moments, name, Unit::INERTIA));
                moments.finish(self.found);
                inertia
            }
            (None, Some((solid, mass))) => {
                let [x, y, z] = solid.moments.clone().map(|per_mass| Some(mass.clone() * per_mass?));
                [x, y, z, None, None, None]
            }
            (None, None) => Default::default(),
        }
    }

    fn check_body(&mut self, span: Span, name: &str, mass: bool, frame: bool, inertial: bool) {
        let fault = match (mass, frame, inertial) {
            (false, _, false) => Some(("has neither mass nor inertia", "mass = \"m\"")),
            (_, false, true) => Some(("has inertia, but no frame to measure it in", "frame = \"link\"")),
            (_, true, false) => Some((
                "has a frame, but no inertia",
                "inertia = { Izz = \"I\" }; or leave `frame` out: the body is then a particle",
            )),
            _ => None,
        };
        if let Some((what, example)) = fault {
            self.found.push(
                Diagnostic::error(format!("body `{name}` {what}"))
                    .label(span, "this body")
                    .help(format!("add {example}")),
            );
        }
    }
}
