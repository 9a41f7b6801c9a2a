//! Angular velocities. A simple rotation or Euler parameters add to the parent's angular velocity; a triad given by
//! directions takes Kane's definition.

use super::quantities::{Kinematics, Motion, Rate};
use super::rate::{scalar_rate, sum_of_rates};
use super::unknowns::UnknownId;
use crate::expr::ExprId;
use crate::model::Axis;
use crate::vector::{Algebra, Spin, TriadId, Turn, Vector, dot_components};
use std::collections::BTreeSet;

/// Angular velocity of a triad, after those of all its ancestors.
pub(super) fn angular_velocity(alg: &mut Algebra, k: &Kinematics, triad: TriadId) -> Motion {
    match alg.triads.turn(triad).clone() {
        Turn::Inertial => Motion::default(),
        Turn::Simple { parent, axis, angle } => {
            let rate = scalar_rate(alg, k, angle);
            let mut motion = k.angular[parent].clone();
            let (home, axis) = outermost_axis(alg, parent, axis);
            let direction = Vector::axis(&mut alg.dag, home, axis);
            // w = w_parent + angle' e ; alpha = alpha_parent + angle'' e + w_parent x (angle' e)
            for (&unknown, &partial) in &rate.partials {
                let term = direction.scaled(&mut alg.dag, partial);
                motion.partials.add_term(&mut alg.dag, unknown, &term);
            }
            let w_parent = k.angular[parent].value(alg, k);
            let spin = rate.value(alg, k);
            let spin = direction.scaled(&mut alg.dag, spin);
            let turning = alg.cross(&w_parent, &spin);
            let bias = direction.scaled(&mut alg.dag, rate.bias);
            motion.bias = motion.bias.plus(&mut alg.dag, &bias).plus(&mut alg.dag, &turning);
            motion
        }
        Turn::Directions { parent, spin: Some(spin), .. } => spinning(alg, k, (triad, parent), &spin),
        Turn::Directions { rows, .. } => kane_angular_velocity(alg, k, triad, rows),
    }
}

/// w = w_parent + sum_i s_i e_i; alpha = alpha_parent + sum_i s_i' e_i + w_parent x sum_i s_i e_i, with e_i the axes of
/// the triad itself (w x s = w_parent x s, since s x s = 0).
fn spinning(alg: &mut Algebra, k: &Kinematics, (triad, parent): (TriadId, TriadId), spin: &Spin) -> Motion {
    let rates = spin.each_ref().map(|terms| sum_of_rates(alg, k, terms));
    let mut motion = k.angular[parent].clone();
    motion.add_components(alg, triad, &rates);
    let relative = rates.each_ref().map(|rate| rate.value(alg, k));
    let relative = Vector::new(&alg.dag, triad, relative);
    let w_parent = k.angular[parent].value(alg, k);
    let turning = alg.cross(&w_parent, &relative);
    let bias = Vector::new(&alg.dag, triad, rates.map(|rate| rate.bias));
    motion.bias = motion.bias.plus(&mut alg.dag, &bias).plus(&mut alg.dag, &turning);
    motion
}

/// A rotation axis is fixed in the parent too. Climbs to the outermost triad in which it is still fixed.
fn outermost_axis(alg: &Algebra, parent: TriadId, axis: Axis) -> (TriadId, Axis) {
    let mut home = parent;
    while let Turn::Simple { parent, axis: about, .. } = alg.triads.turn(home) {
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
fn kane_angular_velocity(
    alg: &mut Algebra,
    k: &Kinematics,
    triad: TriadId,
    rows: [[ExprId; 3]; 3],
) -> Motion {
    let rates: Vec<[Rate; 3]> = rows.iter().map(|row| row.map(|c| scalar_rate(alg, k, c))).collect();
    let values: Vec<[ExprId; 3]> =
        rates.iter().map(|r| std::array::from_fn(|c| r[c].value(alg, k))).collect();
    let mut motion = Motion::default();
    let unknowns: BTreeSet<UnknownId> =
        rates.iter().flatten().flat_map(|r| r.partials.keys().copied()).collect();
    let zero = alg.dag.zero();
    for unknown in unknowns {
        let components = std::array::from_fn(|i| {
            let (j, l) = ((i + 1) % 3, (i + 2) % 3);
            let partial =
                std::array::from_fn(|c| rates[j][c].partials.get(&unknown).copied().unwrap_or(zero));
            dot_components(&mut alg.dag, &partial, &rows[l])
        });
        let term = Vector::new(&alg.dag, triad, components);
        motion.partials.add_term(&mut alg.dag, unknown, &term);
    }
    let bias = std::array::from_fn(|i| {
        let (j, l) = ((i + 1) % 3, (i + 2) % 3);
        let second = std::array::from_fn(|c| rates[j][c].bias);
        let curvature = dot_components(&mut alg.dag, &second, &rows[l]);
        let product = dot_components(&mut alg.dag, &values[j], &values[l]);
        alg.dag.add(curvature, product)
    });
    motion.bias = Vector::new(&alg.dag, triad, bias);
    motion
}
