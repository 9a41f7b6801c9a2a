//! Orientations of frames, positions of points, values of definitions and of coordinates in closed
//! form, in the model's order.

use super::lower::{self, Value};
use super::{Kinematics, orientation, speed_map};
use crate::expr::Label;
use crate::model::{Entity, Model, PointId};
use crate::section::Section;
use crate::vector::Vector;

/// Fills triads, positions and those definitions that need no velocities.
pub(super) fn derive(model: &Model, k: &mut Kinematics) {
    for entity in &model.order {
        match *entity {
            Entity::Parameter(_) => {}
            Entity::Definition(id) => {
                let definition = &model.definitions[id];
                if lower::needs_motion(k, &definition.value) {
                    continue;
                }
                let value = lower::value(k, &definition.value);
                if let Value::Scalar(e) = value {
                    let label = Label::named(Section::Orientations, &*definition.name);
                    k.dag.label(e, label.at(model.source.place(definition.span)));
                }
                k.definitions[id] = value;
            }
            Entity::Coordinate(id) => {
                if let Some(form) = &model.coordinates[id].closed_form {
                    let value = lower::scalar(k, form);
                    let name = &model.coordinates[id].name;
                    let label = Label::named(Section::Orientations, name);
                    k.dag.label(value, label.at(model.source.place(model.coordinates[id].span)));
                    k.q[id] = if speed_map::is_variable(model, id) {
                        k.closed_forms.push((id, value));
                        k.dag.symbol(name)
                    } else {
                        value
                    };
                }
            }
            Entity::Frame(id) => orientation::derive(model, k, id),
            Entity::Point(id) => {
                let position = lower::vector(k, &model.points[id].position);
                k.positions[id] = position.clone();
                if is_lifted(model, id) {
                    let flat = flatten(k, &position);
                    k.flat_positions.insert(id, flat);
                    k.positions[id] = Vector::position(&mut k.dag, id);
                }
            }
        }
    }
}

/// A point that closes loops, whose velocity is an unknown of its own, or whose velocity is stated:
/// later positions refer to it by itself.
pub(super) fn is_lifted(model: &Model, point: PointId) -> bool {
    !model.points[point].closures.is_empty() || model.points[point].velocity.is_some()
}

/// The same vector without lifted points: each is replaced by its first position expression.
pub(crate) fn flatten(k: &mut Kinematics, vector: &Vector) -> Vector {
    let mut flat = Vector { terms: vector.terms.clone(), ..Vector::default() };
    for (&point, &factor) in &vector.points {
        let base = k.flat_positions[&point].clone().scaled(&mut k.dag, factor);
        flat = flat.plus(&mut k.dag, &base);
    }
    flat
}
