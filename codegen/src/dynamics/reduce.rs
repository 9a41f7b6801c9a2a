//! Reduces the equations from all unknowns to the independent speeds, one elimination after the other.
//!
//! With `y = sum c_z z` and `y' = sum c_z z' + b` the virtual power `sum_a da (sum_b M_ab b' - f_a)` keeps its form in
//! the remaining unknowns: `M_zw += c_z M_yy c_w + c_z M_yw + M_zy c_w`, `f_a -= M_ay b`, `f_z += c_z (f_y - M_yy b)`.
//! Each step has few coefficients: the partial velocities T are never formed, and in M = T' M_y T and T' (f - M_y beta)
//! the sub-expressions that several unknowns share are formed once.
//!
//! The clock, which no step eliminates, keeps its row too: M_t u' - f_t is the power supplied by the drive, because the
//! virtual power along v_t is that of all forces except those that enforce the prescribed motion.

use super::mass_and_force::MassAndForce;
use crate::expr::number::Number;
use crate::expr::{Dag, ExprId, Label};
use crate::kinematics::eliminate::{Solution, Step};
use crate::kinematics::{Kinematics, LinearForm, UnknownId};
use crate::section::Section;
use crate::vector::Algebra;

/// The equations of the independent speeds, M u' = forcing.
pub(super) struct Reduced {
    pub mass: Vec<Vec<ExprId>>,
    pub forcing: Vec<ExprId>,
    /// M_t and f_t of the clock, in a driven model.
    pub drive: Option<(Vec<ExprId>, ExprId)>,
}

/// Applies all eliminations to inertia and forces.
pub(super) fn reduce(
    alg: &mut Algebra,
    k: &Kinematics,
    solution: &Solution,
    mut parts: MassAndForce,
) -> Reduced {
    for step in &solution.steps {
        eliminate(&mut alg.dag, &mut parts, step);
        label_step(alg, k, step);
    }
    let independent = k.unknowns.independent();
    let zero = alg.dag.zero();
    let entry =
        |&a: &UnknownId, &b: &UnknownId| parts.mass.get(&(a.min(b), a.max(b))).copied().unwrap_or(zero);
    let row = |a: &UnknownId| -> Vec<ExprId> { independent.iter().map(|b| entry(a, b)).collect() };
    let force = |a: &UnknownId| parts.force.get(a).copied().unwrap_or(zero);
    let mass: Vec<Vec<ExprId>> = independent.iter().map(row).collect();
    let forcing: Vec<ExprId> = independent.iter().map(force).collect();
    let drive = k.unknowns.clock().map(|clock| (row(&clock), force(&clock)));
    for (i, a) in independent.iter().enumerate() {
        let name = k.unknowns[*a].name.clone();
        for (j, b) in independent.iter().enumerate().skip(i) {
            let name = format!("mass_{name}_{}", k.unknowns[*b].name);
            alg.dag.label(mass[i][j], Label::named(Section::Inertia, name));
        }
        alg.dag.label(forcing[i], Label::named(Section::Forces, format!("forcing_{name}")));
    }
    Reduced { mass, forcing, drive }
}

/// Eliminates the unknown y of one step.
fn eliminate(dag: &mut Dag, parts: &mut MassAndForce, step: &Step) {
    let y = step.unknown;
    let zero = dag.zero();
    let own = parts.mass.remove(&(y, y)).unwrap_or(zero);
    let others: LinearForm = (parts.mass.iter())
        .filter(|((a, b), _)| *a == y || *b == y)
        .map(|((a, b), &m)| (if *a == y { *b } else { *a }, m))
        .collect();
    parts.mass.retain(|(a, b), _| *a != y && *b != y);
    let force = parts.force.remove(&y).unwrap_or(zero);
    for (&a, &m) in &others {
        let term = dag.mul(m, step.bias);
        let term = dag.negate(term);
        parts.add_force(dag, a, term);
    }
    let term = dag.mul(own, step.bias);
    let force = dag.sub(force, term);
    for (&z, &c) in &step.coefficients {
        let term = dag.mul(c, force);
        parts.add_force(dag, z, term);
        add_masses(dag, parts, step, (z, c), own, &others);
    }
}

/// Adds the terms of M that have c_z as first factor.
fn add_masses(
    dag: &mut Dag,
    parts: &mut MassAndForce,
    step: &Step,
    (z, c): (UnknownId, ExprId),
    own: ExprId,
    others: &LinearForm,
) {
    let zero = dag.zero();
    for (&w, &d) in step.coefficients.range(z..) {
        let mixed = others.get(&w).copied().unwrap_or(zero);
        let square = dag.mul(own, d);
        // c_z (M_yy c_w + M_yw), on the diagonal c_z (M_yy c_z + 2 M_yz)
        let mixed = if w == z {
            let two = dag.number(Number::integer(2));
            dag.mul(two, mixed)
        } else {
            mixed
        };
        let sum = dag.add(square, mixed);
        let term = dag.mul(c, sum);
        parts.add_mass(dag, z, w, term);
    }
    for (&w, &m) in others {
        // If both z and w have coefficients, half of the pair was added above; otherwise add all of it.
        if w < z || !step.coefficients.contains_key(&w) {
            let term = dag.mul(c, m);
            parts.add_mass(dag, z, w, term);
        }
    }
}

/// Labels values for the generated code. A coefficient gets no name, because its value often serves several speeds.
fn label_step(alg: &mut Algebra, k: &Kinematics, step: &Step) {
    for &coefficient in step.coefficients.values() {
        alg.dag.label(coefficient, Label::of(Section::Constraints));
    }
    let bias = format!("{}_dot_bias", k.unknowns[step.unknown].name);
    alg.dag.label(step.bias, Label::named(Section::Velocities, bias));
}
