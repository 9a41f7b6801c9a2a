//! Momentum of the mechanism and its mass centre.
//!
//! In: bodies with the motions of their centres and frames. Out: mass, mass centre c = sum m r / sum m, momentum p =
//! sum m v, and angular momentum about O, H = sum r x m v + I w. p' and H' are the force and moment that everything
//! outside exerts on the mechanism, its bearings included (Kane, Levinson 1985, section 7.1).

use super::part::Part;
use super::stages::{Stages, Target};
use crate::diagnostic::Diagnostic;
use crate::expr::ExprId;
use crate::kinematics::{Marker, lower_scalar};
use crate::model::Body;

/// Components along the axes of one frame.
type Components = [ExprId; 3];

pub(super) fn momentum(stages: &mut Stages, target: &Target) -> Result<Vec<Part>, Diagnostic> {
    let zero = stages.alg.dag.zero();
    let (mut mass, mut first, mut linear, mut angular) = (zero, [zero; 3], [zero; 3], [zero; 3]);
    for body in stages.model.bodies.iter() {
        let centre = Marker { point: Some(body.centre), frame: None };
        if centre.unlocated(stages.model, stages.k).is_some() {
            return Err(Diagnostic::error(format!(
                "`{}`: the position of `{}` is not known: the model states its velocity",
                target.request, stages.model.points[body.centre].name
            ))
            .label(body.span, "this body")
            .help("locate the point by coordinates"));
        }
        if let Some(m) = &body.mass {
            let m = lower_scalar(stages.alg, stages.k, m);
            let position = centre.position(stages.alg, stages.k).unwrap_or([zero; 3]);
            let velocity = centre.twist(stages.alg, stages.k);
            let dag = &mut stages.alg.dag;
            let momentum: Components = std::array::from_fn(|i| dag.mul(m, velocity[i]));
            mass = dag.add(mass, m);
            let moment = position.map(|r| dag.mul(m, r));
            first = plus(stages, first, moment);
            linear = plus(stages, linear, momentum);
            let about = cross(stages, position, momentum);
            angular = plus(stages, angular, about);
        }
        let turning = of_turning(stages, body);
        angular = plus(stages, angular, turning);
    }
    let centre = first.map(|moment| stages.alg.dag.div(moment, mass));
    let named = |letter: &str| ["x", "y", "z"].map(|axis| format!("{letter}_{axis}")).to_vec();
    let mut list = |name, doc, letter, values: Components| {
        let values = stages.solved(&values);
        Part::list(name, doc, named(letter), values)
    };
    let mut parts = vec![Part::number("mass", "of all bodies (kg)", mass)];
    if mass != zero {
        parts.push(list("centre", "mass centre from O, along N's axes (m)", "c", centre));
    }
    parts.push(list("momentum", "sum of m v, along N's axes (kg m/s)", "p", linear));
    parts.push(list("moment_of_momentum", "about O, along N's axes (kg m^2/s)", "H", angular));
    Ok(parts)
}

/// I w, along the axes of N.
fn of_turning(stages: &mut Stages, body: &Body) -> Components {
    let zero = stages.alg.dag.zero();
    let Some(frame) = body.frame else { return [zero; 3] };
    let entry = |i: usize, stages: &mut Stages| {
        let e = body.inertia[i].as_ref();
        e.map_or(zero, |e| lower_scalar(stages.alg, stages.k, e))
    };
    let [xx, yy, zz, yz, zx, xy] = [0, 1, 2, 3, 4, 5].map(|i| entry(i, stages));
    let triad = stages.k.frame_triad[frame];
    let w = stages.k.angular[triad].value(stages.alg, stages.k);
    let w = stages.alg.express(&w, triad);
    let along = [[xx, xy, zx], [xy, yy, yz], [zx, yz, zz]].map(|row| dot(stages, row, w));
    let axes = Marker { point: None, frame: Some(frame) }.rotation(stages.alg, stages.k);
    axes.map_or(along, |rows| rows.map(|row| dot(stages, row, along)))
}

fn plus(stages: &mut Stages, a: Components, b: Components) -> Components {
    std::array::from_fn(|i| stages.alg.dag.add(a[i], b[i]))
}

fn dot(stages: &mut Stages, a: Components, b: Components) -> ExprId {
    let terms: Vec<ExprId> = a.into_iter().zip(b).map(|(x, y)| stages.alg.dag.mul(x, y)).collect();
    stages.alg.dag.sum(&terms)
}

fn cross(stages: &mut Stages, a: Components, b: Components) -> Components {
    let dag = &mut stages.alg.dag;
    std::array::from_fn(|i| {
        let (j, l) = ((i + 1) % 3, (i + 2) % 3);
        let (left, right) = (dag.mul(a[j], b[l]), dag.mul(a[l], b[j]));
        dag.sub(left, right)
    })
}
