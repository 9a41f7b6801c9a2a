//! Adds the wrench at a port as six inputs: a force at its point and a moment about it, along the axes of N.
//!
//! In: a model and one of its ports. Out: the model with these inputs and the force and torque that they command. All
//! later stages derive them like any other load.

use super::data::*;
use super::expression::{Axis, Expr, ExprKind};
use super::ids::*;
use super::unit::Unit;
use crate::diagnostic::Diagnostic;
use crate::id::Id;

/// The two halves of a wrench: the ending of the inputs' names, and their unit.
const COMPONENTS: [(&str, &str); 2] = [("force", "N"), ("moment", "N m")];
const AXES: [(&str, Axis); 3] = [("x", Axis::X), ("y", Axis::Y), ("z", Axis::Z)];

impl Model {
    /// The model with six more inputs: `<port>_force_x` to `<port>_moment_z`.
    ///
    /// # Errors
    /// If the model has such a name already.
    pub fn with_wrench(&self, port: &Port) -> Result<Self, Diagnostic> {
        let mut model = self.clone();
        for (of, unit) in COMPONENTS {
            let terms = AXES.map(|(letter, axis)| {
                let name = format!("{}_{of}_{letter}", port.name);
                let doc = format!("{of} on the port {} along N.{letter}", port.name);
                let written_unit = (unit.to_owned(), 1.0);
                let input = Input { name, doc, unit: unit.to_owned(), written_unit, span: port.span };
                let input = model.inputs.push(input);
                let node = |kind| Expr { kind, span: port.span, unit: Unit::NONE };
                let axis = node(ExprKind::Axis(FrameId::from_index(0), axis));
                node(ExprKind::Multiply(Box::new(node(ExprKind::Input(input))), Box::new(axis)))
            });
            let add = |a: Expr, b: Expr| {
                let (span, unit) = (a.span, a.unit);
                Expr { kind: ExprKind::Add(Box::new(a), Box::new(b)), span, unit }
            };
            let vector = terms.into_iter().reduce(add);
            let Some(vector) = vector else { continue };
            let kind = match of {
                "force" => LoadKind::Force { point: port.point, force: vector, reaction: None },
                _ => LoadKind::Torque { frame: port.frame, torque: vector, reaction: None },
            };
            model.loads.push(Load { name: format!("{}_{of}", port.name), kind, span: port.span });
        }
        let is_taken = |name: &str| {
            let known = self.inputs.iter().map(|x| &x.name).chain(self.parameters.iter().map(|x| &x.name));
            let known = known.chain(self.coordinates.iter().map(|x| &x.name));
            known.chain(self.speeds.iter().map(|x| &x.name)).any(|x| x == name)
        };
        match model.inputs.iter().skip(self.inputs.len()).find(|input| is_taken(&input.name)) {
            None => Ok(model),
            Some(input) => Err(Diagnostic::error(format!("`{}` is declared twice", input.name))
                .label(port.span, "an input of the wrench on this port")
                .help("rename the port, or what has that name already")),
        }
    }
}
