//! Velocities of points, angular velocities of triads, and the definitions that depend on them, in the model's order.
//!
//! In: positions and triads. Out: their motions as linear forms in the unknowns (`rate`). Bodies that close loops get
//! the components of their twists as unknowns.

use super::angular::angular_velocity;
use super::quantities::{Kinematics, Motion, Value};
use super::rate::{derivative, linear_motion};
use super::unknowns::{Unknown, UnknownKind, Unknowns};
use super::{lifted, lower, route};
use crate::expr::Label;
use crate::id::Id;
use crate::model::{Axis, DefinitionId, Entity, FrameId, Model, PointId};
use crate::section::Section;
use crate::vector::{Algebra, TriadId, Vector};
use std::collections::BTreeSet;

/// Adds angular velocities, velocities, and the definitions that depend on them.
pub(super) fn derive(alg: &mut Algebra, model: &Model, mut k: Kinematics, as_written: bool) -> Kinematics {
    k.angular = (0..alg.triads.len()).map(|_| Motion::default()).collect();
    k.velocities = model.points.iter().map(|_| Motion::default()).collect();
    k.term_derivatives.take();
    k = lift(alg, model, k);
    let lifted_triads: BTreeSet<_> = lifted_frames(model).map(|f| k.frame_triad[f]).collect();
    for triad in (0..alg.triads.len()).map(TriadId::from_index) {
        if !lifted_triads.contains(&triad) {
            k.angular[triad] = angular_velocity(alg, &k, triad);
        }
    }
    let loops = if as_written { Vec::new() } else { route::loops(alg, model, &k) };
    let stated = model.points.iter().filter_map(|point| point.velocity.as_ref());
    let reads_definitions = stated.into_iter().any(|velocity| lower::needs_definitions(&k, velocity));
    for entity in &model.order {
        if let (true, Entity::Definition(id)) = (reads_definitions, *entity) {
            k.definitions[id] = Some(definition(alg, model, &k, id));
        }
        let Entity::Point(point) = *entity else { continue };
        if let Some(velocity) = &model.points[point].velocity {
            let velocity = lower::vector(alg, &k, velocity);
            k.velocities[point] = linear_motion(alg, &k, &velocity);
        } else if !lifted::point_is_lifted(model, point) {
            let position = k.positions[point].clone();
            let position = route::shortest(alg, &k, position, &loops);
            k.velocities[point] = derivative(alg, &k, &position);
        }
    }
    for entity in &model.order {
        if let Entity::Definition(id) = *entity {
            k.definitions[id] = Some(definition(alg, model, &k, id));
        }
    }
    k
}

/// The value of a definition; lowers it now if it had to wait for velocities.
fn definition(alg: &mut Algebra, model: &Model, k: &Kinematics, id: DefinitionId) -> Value {
    if let Some(known) = &k.definitions[id] {
        return known.clone();
    }
    let value = lower::value(alg, k, &model.definitions[id].value);
    if let Value::Scalar(e) = value {
        let definition = &model.definitions[id];
        let label = Label::named(Section::Velocities, &*definition.name);
        alg.dag.label(e, label.at(model.source.place(definition.span)));
    }
    value
}

fn lifted_frames(model: &Model) -> impl Iterator<Item = FrameId> + '_ {
    model.frames.ids().filter(|&f| lifted::frame_is_lifted(model, f))
}

/// Is the triad's angular velocity an unknown of its own?
pub(crate) fn is_lifted_triad(model: &Model, k: &Kinematics, triad: TriadId) -> bool {
    lifted_frames(model).any(|f| k.frame_triad[f] == triad)
}

/// Adds the unknown twist components of bodies that close loops.
fn lift(alg: &mut Algebra, model: &Model, mut k: Kinematics) -> Kinematics {
    for frame in lifted_frames(model) {
        let triad = k.frame_triad[frame];
        let name = format!("w_{}", model.frames[frame].name);
        k.angular[triad] = unknown_vector(alg, &mut k.unknowns, triad, &name);
    }
    for point in model.points.ids().filter(|&p| !model.points[p].closures.is_empty()) {
        let triad = home_of(model, &k, point);
        let name = format!("v_{}", model.points[point].name);
        k.velocities[point] = unknown_vector(alg, &mut k.unknowns, triad, &name);
    }
    k
}

/// The triad in which a lifted point's velocity is resolved: that of the body centred there, if any.
fn home_of(model: &Model, k: &Kinematics, point: PointId) -> TriadId {
    let body = model.bodies.iter().find(|b| b.centre == point && b.frame.is_some());
    body.and_then(|b| b.frame).map_or(TriadId::INERTIAL, |f| k.frame_triad[f])
}

/// A vector whose three components are new unknowns.
fn unknown_vector(alg: &mut Algebra, unknowns: &mut Unknowns, triad: TriadId, name: &str) -> Motion {
    let mut motion = Motion::default();
    for (axis, letter) in [(Axis::X, 'x'), (Axis::Y, 'y'), (Axis::Z, 'z')] {
        let name = format!("{name}_{letter}");
        let value = alg.dag.symbol(&name);
        let unknown = unknowns.push(Unknown { name, value, kind: UnknownKind::Lifted });
        let axis = Vector::axis(&mut alg.dag, triad, axis);
        motion.partials.insert(unknown, axis);
    }
    motion
}
