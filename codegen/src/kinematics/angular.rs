//! Angular velocities: w of a simple rotation adds to its parent's; w of a triad of directions by Kane's definition.

use super::quantities::{Kinematics, Motion, Rate, UnknownId};
use super::rate::{motion_value, rate_value, scalar_rate};
use crate::expr::ExprId;
use crate::model::Axis;
use crate::vector::{TriadId, Turn, Vector, dot_components};
use std::collections::BTreeSet;

/// Angular velocity of a triad whose parents are done.
pub(super) fn angular_velocity(k: &mut Kinematics, triad: TriadId) -> Motion {
    match k.triads.turn(triad).clone() {
        Turn::Inertial => Motion::default(),
        Turn::Simple { parent, axis, angle } => {
            let rate = scalar_rate(k, angle);
            let mut motion = k.angular[parent].clone();
            let (home, axis) = outermost_axis(k, parent, axis);
            let direction = Vector::axis(&mut k.dag, home, axis);
            // w = w_parent + angle' e ; alpha = alpha_parent + angle'' e + w_parent x (angle' e)
            for (&unknown, &partial) in &rate.partials {
                let term = direction.scaled(&mut k.dag, partial);
                motion.add_partial(k, unknown, &term);
            }
            let parent_motion = k.angular[parent].clone();
            let w_parent = motion_value(k, &parent_motion);
            let spin = rate_value(k, &rate);
            let spin = direction.scaled(&mut k.dag, spin);
            let turning = k.triads.cross(&mut k.dag, &w_parent, &spin);
            let bias = direction.scaled(&mut k.dag, rate.bias);
            motion.bias = motion.bias.plus(&mut k.dag, &bias).plus(&mut k.dag, &turning);
            motion
        }
        Turn::Directions { rows } => kane_angular_velocity(k, triad, rows),
    }
}

/// A rotation axis is fixed in the parent too; climb as long as the parent turns about the same axis.
fn outermost_axis(k: &Kinematics, parent: TriadId, axis: Axis) -> (TriadId, Axis) {
    let mut home = parent;
    while let Turn::Simple { parent, axis: about, .. } = k.triads.turn(home) {
        if *about != axis {
            break;
        }
        home = *parent;
    }
    (home, axis)
}

/// Kane's definition: w = e1 (e2' . e3) + e2 (e3' . e1) + e3 (e1' . e2).
///
/// The derivative of w_1 = e2' . e3 is e2'' . e3 + e2' . e3'; it is the component of alpha along e1
/// because a vector's rates of change in N and in its own triad agree for w itself.
fn kane_angular_velocity(k: &mut Kinematics, triad: TriadId, rows: [[ExprId; 3]; 3]) -> Motion {
    let rates: Vec<[Rate; 3]> = rows.iter().map(|row| row.map(|c| scalar_rate(k, c))).collect();
    let values: Vec<[ExprId; 3]> =
        rates.iter().map(|r| std::array::from_fn(|c| rate_value(k, &r[c]))).collect();
    let mut motion = Motion::default();
    let unknowns: BTreeSet<UnknownId> =
        rates.iter().flatten().flat_map(|r| r.partials.keys().copied()).collect();
    let zero = k.dag.zero();
    for unknown in unknowns {
        let components = std::array::from_fn(|i| {
            let (j, l) = ((i + 1) % 3, (i + 2) % 3);
            let partial =
                std::array::from_fn(|c| rates[j][c].partials.get(&unknown).copied().unwrap_or(zero));
            dot_components(&mut k.dag, &partial, &rows[l])
        });
        let term = Vector::new(&k.dag, triad, components);
        motion.add_partial(k, unknown, &term);
    }
    let bias = std::array::from_fn(|i| {
        let (j, l) = ((i + 1) % 3, (i + 2) % 3);
        let second = std::array::from_fn(|c| rates[j][c].bias);
        let curvature = dot_components(&mut k.dag, &second, &rows[l]);
        let product = dot_components(&mut k.dag, &values[j], &values[l]);
        k.dag.add(curvature, product)
    });
    motion.bias = Vector::new(&k.dag, triad, bias);
    motion
}
