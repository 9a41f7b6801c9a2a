//! Reads a rigid part: shape, mass, and start.

use super::value::{Bound, list, needed, number, one_of, vector};
use crate::world::assembly::Rigid;
use smartbed_codegen::diagnostic::{Diagnostic, Diagnostics};
use smartbed_codegen::model::Fields;
use smartbed_codegen::model::document::Value;
use smartbed_runtime::rigid::attitude::Attitude;
use smartbed_runtime::rigid::{RigidBody, RigidState};
use smartbed_runtime::surface::{Capsule, Cuboid, Shape, Sphere};
use smartbed_runtime::vec3;
use std::f64::consts::PI;

/// Names of the shapes.
const SHAPES: [&str; 4] = ["sphere", "box", "capsule", "half_space"];

/// Reads it; `offset` is the displacement of a copy in a grid.
pub(super) fn read(fields: &Fields<'_>, offset: [f64; 3], found: &mut Diagnostics) -> Option<Rigid> {
    let word = fields.text("rigid", found)?;
    let kind = one_of(&word.text, word.span, ("shape", &SHAPES), found)?;
    let shape = shape(kind, fields, found)?;
    let said = fields.boolean("fixed", found);
    let fixed = said.unwrap_or(kind == "half_space");
    if kind == "half_space" && !fixed {
        let error = Diagnostic::error("a half-space is fixed in space");
        found.push(error.label(word.span, "it has no mass").help("leave `fixed = false` out"));
        return None;
    }
    let carried = fields.get("on").is_some();
    if carried && said == Some(true) {
        let error = Diagnostic::error("`fixed = true` has no effect beside `on`");
        let place = fields.get("fixed").map_or(word.span, Value::span);
        found.push(error.label(place, "it moves with its port").help("leave one of the two out"));
        return None;
    }
    let body = match fixed || carried {
        true => {
            refuse_inertia(carried, fields, found)?;
            None
        }
        false => Some(body(&shape, fields, found)?),
    };
    let mut start = start(&shape, body.as_ref(), fields, found)?;
    start.position = vec3::add(start.position, offset);
    Some(Rigid { shape, body, on: None, start })
}

fn shape(kind: &str, fields: &Fields<'_>, found: &mut Diagnostics) -> Option<Shape<f64>> {
    let length = ("m", "\"0.1_m\"");
    Some(match kind {
        "half_space" => Shape::HalfSpace,
        "sphere" => Shape::Sphere(Sphere { radius: needed(fields, "radius", length, found)? }),
        "capsule" => {
            let radius = needed(fields, "radius", length, found);
            let half = needed(fields, "length", length, found).map(|l| 0.5 * l);
            Shape::Capsule(Capsule { radius: radius?, half_length: half? })
        }
        _ => {
            let value = fields.need("size", "[\"0.2_m\", \"0.1_m\", \"0.1_m\"]", found)?;
            let size: [f64; 3] = list(value, "size", "m", found)?;
            if size.iter().any(|edge| *edge <= 0.0) {
                let error = Diagnostic::error("`size` must be three lengths > 0");
                found.push(
                    error.label(value.span(), "one of them is not").help("give the edges along x, y, z"),
                );
                return None;
            }
            Shape::Cuboid(Cuboid { half: size.map(|edge| 0.5 * edge) })
        }
    })
}

/// Refuses the inertia of a part that has none.
fn refuse_inertia(carried: bool, fields: &Fields<'_>, found: &mut Diagnostics) -> Option<()> {
    let Some((key, value)) = ["mass", "inertia"].iter().find_map(|key| Some((key, fields.get(key)?))) else {
        return Some(());
    };
    let (why, help) = match carried {
        true => ("it is only the surface of what carries it", "leave it out; the model's bodies have mass"),
        false => (
            "it is fixed in space and never moves",
            "leave it out; what has mass and may move is not `fixed`",
        ),
    };
    let error = Diagnostic::error(format!("`{}` has `{key}`, but {why}", fields.name));
    found.push(error.label(value.span(), "has no effect").help(help));
    None
}

/// Mass, and the moments of a homogeneous body unless they are given.
fn body(shape: &Shape<f64>, fields: &Fields<'_>, found: &mut Diagnostics) -> Option<RigidBody<f64>> {
    let mass = needed(fields, "mass", ("kg", "\"1_kg\", or fixed = true"), found);
    let given = fields.get("inertia");
    let inertia = match given {
        None => homogeneous(shape).map(|per_mass| per_mass * mass.unwrap_or(1.0)),
        Some(value) => list(value, "inertia", "kg m^2", found)?,
    };
    let [x, y, z] = inertia;
    let is_body = inertia.iter().all(|i| *i > 0.0) && x <= y + z && y <= z + x && z <= x + y;
    if let Some(value) = given.filter(|_| !is_body) {
        let error = Diagnostic::error("no body can have these moments of inertia");
        let help = "principal moments are > 0, and none is larger than the sum of the other two";
        found.push(error.label(value.span(), format!("{x}, {y}, {z} kg m^2")).help(help));
        return None;
    }
    Some(RigidBody { mass: mass?, inertia })
}

/// Moments of a homogeneous body of mass 1 (m^2).
fn homogeneous(shape: &Shape<f64>) -> [f64; 3] {
    match shape {
        Shape::HalfSpace => [1.0; 3],
        Shape::Sphere(sphere) => [0.4 * sphere.radius.powi(2); 3],
        Shape::Cuboid(cuboid) => {
            let [x, y, z] = cuboid.half.map(|h| h * h / 3.0);
            [y + z, z + x, x + y]
        }
        Shape::Capsule(capsule) => {
            // A cylinder and two half balls, weighted by their shares of the volume.
            let (r, l) = (capsule.radius, 2.0 * capsule.half_length);
            let (cylinder, ball) = (PI * r * r * l, 4.0 / 3.0 * PI * r.powi(3));
            let (cylinder, ball) = (cylinder / (cylinder + ball), ball / (cylinder + ball));
            let along = cylinder * r * r / 2.0 + ball * 0.4 * r * r;
            let across =
                cylinder * (l * l / 12.0 + r * r / 4.0) + ball * (0.4 * r * r + l * l / 4.0 + 0.375 * l * r);
            [across, across, along]
        }
    }
}

/// `start = { position, height, axis, angle, velocity, spin }`, all along N's axes.
fn start(
    shape: &Shape<f64>,
    body: Option<&RigidBody<f64>>,
    part: &Fields<'_>,
    found: &mut Diagnostics,
) -> Option<RigidState<f64>> {
    let mut state = RigidState::at_rest([0.0; 3]);
    let Some(table) = part.table("start", found) else { return Some(state) };
    let fields = Fields::of("start", table.span, table);
    if let Some(position) = vector(&fields, "position", "m", found) {
        state.position = position;
    }
    let axis = vector(&fields, "axis", "", found);
    let angle = number(&fields, "angle", "rad", Bound::Any, found);
    if let (Some(_), None, Some(value)) =
        (axis, angle, table.get("axis").filter(|_| table.get("angle").is_none()))
    {
        let error = Diagnostic::error("`axis` without `angle` turns nothing");
        found.push(error.label(value.span(), "by no angle").help("add for example angle = \"30_deg\""));
        return None;
    }
    let (axis, angle) = (axis.unwrap_or([0.0, 0.0, 1.0]), angle.unwrap_or(0.0));
    let largest = axis.into_iter().map(f64::abs).fold(0.0, f64::max);
    if largest <= 0.0 {
        let error = Diagnostic::error("`axis` has no direction");
        found.push(
            error
                .label(table.span, "its length is 0")
                .help("for example axis = [0, 1, 0], angle = \"30_deg\""),
        );
        return None;
    }
    // By its largest component first: squares of 1e200 overflow, and those of 1e-200 vanish.
    let axis = if (1e-100..1e100).contains(&largest) { axis } else { axis.map(|x| x / largest) };
    let [x, y, z] = vec3::scale(axis, (0.5 * angle).sin() / vec3::norm(axis));
    state.attitude = Attitude::new([(0.5 * angle).cos(), x, y, z]);
    if let Some(height) = number(&fields, "height", "m", Bound::Any, found) {
        state.position[2] = height + below(shape, &state.attitude);
    }
    let velocity = vector(&fields, "velocity", "m/s", found);
    let spin = vector(&fields, "spin", "rad/s", found);
    match body {
        Some(body) => {
            state.velocity = velocity.unwrap_or_default();
            let local = state.attitude.to_body(spin.unwrap_or_default());
            let momentum = [0, 1, 2].map(|i| body.inertia[i] * local[i]);
            state.angular_momentum = state.attitude.to_inertial(momentum);
        }
        None if velocity.is_some() || spin.is_some() => {
            let error = Diagnostic::error("a part that is fixed has no velocity");
            found
                .push(error.label(table.span, "it starts in motion").help("leave `velocity` and `spin` out"));
        }
        None => {}
    }
    fields.finish(found);
    Some(state)
}

/// Distance from its centre to its lowest point (m).
fn below(shape: &Shape<f64>, attitude: &Attitude<f64>) -> f64 {
    let axes: [[f64; 3]; 3] = attitude.axes();
    match shape {
        Shape::HalfSpace => 0.0,
        Shape::Sphere(sphere) => sphere.radius,
        Shape::Capsule(capsule) => capsule.radius + capsule.half_length * axes[2][2].abs(),
        Shape::Cuboid(cuboid) => cuboid.half.iter().zip(axes).map(|(half, axis)| half * axis[2].abs()).sum(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Mean of y^2 + z^2 and x^2 + y^2 over the capsule, by counting points of a fine grid.
    #[test]
    fn a_capsule_has_the_moments_of_its_volume() {
        let (r, half) = (0.1_f64, 0.15_f64);
        let (mut volume, mut across, mut along) = (0.0, 0.0, 0.0);
        let n = 120;
        for i in 0..n {
            for j in 0..n {
                for k in 0..2 * n {
                    let at = |m: i32, count: i32, reach: f64| {
                        reach * ((2.0 * f64::from(m) + 1.0) / f64::from(count) - 1.0)
                    };
                    let (x, y, z) = (at(i, n, r), at(j, n, r), at(k, 2 * n, r + half));
                    let beyond = (z.abs() - half).max(0.0);
                    if x * x + y * y + beyond * beyond <= r * r {
                        volume += 1.0;
                        across += y * y + z * z;
                        along += x * x + y * y;
                    }
                }
            }
        }
        let [xx, _, zz] = homogeneous(&Shape::Capsule(Capsule { radius: r, half_length: half }));
        assert!(
            (across / volume / xx - 1.0).abs() < 2e-3 && (along / volume / zz - 1.0).abs() < 5e-3,
            "{xx} {zz}"
        );
    }
}
