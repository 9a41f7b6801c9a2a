//! Orientations of frames, positions of points, values of definitions and of coordinates in closed
//! form, in the model's order.

use super::lifted::{flatten, point_is_lifted};
use super::quantities::{Kinematics, Value};
use super::{lower, orientation, speed_map};
use crate::expr::Label;
use crate::model::{Entity, Model};
use crate::section::Section;
use crate::vector::{Algebra, Vector};

/// Adds triads, positions and those definitions that do not depend on velocities.
pub(super) fn derive(alg: &mut Algebra, model: &Model, mut k: Kinematics) -> Kinematics {
    for entity in &model.order {
        match *entity {
            Entity::Parameter(_) => {}
            Entity::Definition(id) => {
                let definition = &model.definitions[id];
                if lower::needs_motion(&k, &definition.value) {
                    continue;
                }
                let value = lower::value(alg, &k, &definition.value);
                if let Value::Scalar(e) = value {
                    let label = Label::named(Section::Orientations, &*definition.name);
                    alg.dag.label(e, label.at(model.source.place(definition.span)));
                }
                k.definitions[id] = Some(value);
            }
            Entity::Coordinate(id) => {
                if let Some(form) = &model.coordinates[id].closed_form {
                    let value = lower::scalar(alg, &k, form);
                    let name = &model.coordinates[id].name;
                    let label = Label::named(Section::Orientations, name);
                    alg.dag.label(value, label.at(model.source.place(model.coordinates[id].span)));
                    k.q[id] = if speed_map::is_variable(model, id) {
                        k.closed_forms.push((id, value));
                        alg.dag.symbol(name)
                    } else {
                        value
                    };
                }
            }
            Entity::Frame(id) => k.frame_triad[id] = orientation::derive(alg, model, &k, id),
            Entity::Point(id) => {
                let position = lower::vector(alg, &k, &model.points[id].position);
                k.positions[id] = position.clone();
                if point_is_lifted(model, id) {
                    let flat = flatten(alg, &k, &position);
                    k.flat_positions.insert(id, flat);
                    k.positions[id] = Vector::position(&mut alg.dag, id);
                }
            }
        }
    }
    k
}
