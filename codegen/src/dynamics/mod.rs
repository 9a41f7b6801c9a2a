//! Dynamics: Kane's equations F_r + F*_r = 0 in the independent speeds.
//!
//! In: kinematics, and the solution of the constraints. Out: M u' = forcing, u', energies. Over all unknowns y (speeds
//! and lifted twists) the inertia is sparse. The eliminations that solve the constraints, y = sum c z and
//! y' = sum c z' + b, reduce it one unknown at a time (`reduce`) to M = T' M_y T and T' (F_y - h_y - M_y beta), with
//! y = T u, but T is never formed. No mass matrix of the dependent speeds is ever inverted.

mod absolute;
mod active_force;
mod articulated;
mod articulated_inertia;
mod augmented;
mod chain;
mod composite;
mod energy;
mod given;
mod implicit;
mod inertia_force;
mod inverse;
mod mass_and_force;
mod parallel;
mod power;
mod reduce;
mod redundant;
mod rigid_inertia;
mod rotation;
mod segment;
mod segment_inertia;
mod shared_axis;
mod slide;
mod solve;
mod spatial;
mod tree;
mod tree_motion;

pub use augmented::Augmented;
pub(crate) use implicit::Implicit;
pub(crate) use inverse::{
    forces_for, inputs_for, inverse_inertia, missing_forces, multipliers, on_independent, response,
};
pub(crate) use power::powers;

use crate::diagnostic::Diagnostics;
use crate::expr::cost::Optimise;
use crate::expr::tape::SampleTable;
use crate::expr::{Dag, ExprId, Label, SymbolId};
use crate::kinematics::eliminate::{Pivot, Solution};
use crate::kinematics::{Kinematics, Unknown, UnknownId, UnknownKind};
use crate::model::Model;
use crate::section::Section;
use crate::vector::Algebra;
use given::Given;
use mass_and_force::MassAndForce;
use reduce::Reduced;
use rustc_hash::FxHashMap as HashMap;
use segment::Segment;

/// Equations of motion of the independent speeds, and the energies.
#[derive(Clone, Debug)]
pub struct Dynamics {
    /// M, symmetric, `n_u` x `n_u`.
    pub mass_matrix: Vec<Vec<ExprId>>,
    /// Right-hand side of M u' = forcing, `n_u`.
    pub forcing: Vec<ExprId>,
    /// u', `n_u`.
    pub u_dot: Vec<ExprId>,
    /// Kinetic energy (J).
    pub kinetic: ExprId,
    /// Potential energy (J) of gravity and springs.
    pub potential: ExprId,
    /// Power (W) of the forces that enforce the prescribed motion, in a driven model.
    pub drive: Option<ExprId>,
    /// Correction of redundant speeds, one entry per speed; empty if the speeds are independent.
    pub speed_correction: Vec<ExprId>,
    /// By symbol: the value of every eliminated unknown in terms of the independent speeds.
    pub values: HashMap<SymbolId, ExprId>,
    /// Pivots of the mass matrix.
    pub pivots: Vec<Pivot>,
    /// The equations before the elimination, if they were asked for.
    pub augmented: Augmented,
}

/// Derives the equations of motion and, if `with_augmented`, the augmented form.
///
/// # Errors
/// If the mass matrix is singular: some coordinate moves no mass.
pub fn derive(
    alg: &mut Algebra,
    model: &Model,
    k: &Kinematics,
    solution: &Solution,
    table: &mut SampleTable,
    (optimise, with_augmented): (Optimise, bool),
) -> Result<Dynamics, Diagnostics> {
    let mut parts = MassAndForce::default();
    let segments = if solution.ties.is_empty() { segment::sparse_tree(alg, model, k) } else { None };
    match &segments {
        Some(segments) => {
            segment_inertia::accumulate(alg, segments, &mut parts);
            inertia_force::rotations(alg, model, k, &mut parts);
        }
        None => inertia_force::accumulate(alg, model, k, &Given::default(), &mut parts),
    }
    active_force::accumulate(alg, model, k, &mut parts);
    let (kinetic, potential) = (energy::kinetic(alg, k, &parts), energy::potential(alg, model, k));
    let values = unknown_values(alg, model, k, solution);
    let augmented = match with_augmented {
        true => augmented::derive(alg, k, solution, &parts, &values),
        false => Augmented::default(),
    };
    let Reduced { mass: mass_matrix, forcing, drive } = reduce::reduce(alg, k, solution, parts);
    let forcing = alg.dag.substitute(&forcing, &values);
    let energies = alg.dag.substitute(&[kinetic, potential], &values);
    let Solved { u_dot, speed_correction, of_ties, pivots } = match solution.ties.is_empty() {
        true => {
            let equations = (&mass_matrix[..], &forcing[..]);
            let (u_dot, pivots) =
                accelerations(alg, (model, k, solution), table, segments.as_deref(), equations, optimise)?;
            Solved { u_dot, pivots, ..Solved::default() }
        }
        false => tied(alg, model, k, table, (solution, &values), (&mass_matrix, &forcing))?,
    };
    let drive = drive.map(|(mass, force)| {
        let power = drive_power(&mut alg.dag, &mass, &u_dot, force, &values);
        of_ties.map_or(power, |part| alg.dag.sub(power, part))
    });
    if let Some(power) = drive {
        alg.dag.label(power, Label::named(Section::Results, "drive"));
    }
    Ok(Dynamics {
        mass_matrix,
        forcing,
        u_dot,
        kinetic: energies[0],
        potential: energies[1],
        drive,
        speed_correction,
        values,
        pivots,
        augmented,
    })
}

/// u', with the pivots and corrections that belong to it.
#[derive(Default)]
struct Solved {
    u_dot: Vec<ExprId>,
    speed_correction: Vec<ExprId>,
    /// The part of the drive's power that the multipliers of redundant speeds supply.
    of_ties: Option<ExprId>,
    pivots: Vec<Pivot>,
}

/// u' of redundant speeds.
fn tied(
    alg: &mut Algebra,
    model: &Model,
    k: &Kinematics,
    table: &mut SampleTable,
    (solution, values): (&Solution, &HashMap<SymbolId, ExprId>),
    (mass, forcing): (&[Vec<ExprId>], &[ExprId]),
) -> Result<Solved, Diagnostics> {
    let rows = &solution.ties;
    let Some(found) = redundant::solve(alg, model, k, table, (rows, values), (mass, forcing)) else {
        return Err(solve::still_masses(model));
    };
    let of_ties = redundant::power_of_drive(alg, k, rows, &found.multipliers);
    Ok(Solved { u_dot: found.u_dot, speed_correction: found.correction, of_ties, pivots: found.pivots })
}

/// M_t u' - f_t: the power of the forces that enforce the prescribed motion.
fn drive_power(
    dag: &mut Dag,
    mass: &[ExprId],
    u_dot: &[ExprId],
    force: ExprId,
    values: &HashMap<SymbolId, ExprId>,
) -> ExprId {
    let terms: Vec<ExprId> = mass.iter().zip(u_dot).map(|(&m, &u)| dag.mul(m, u)).collect();
    let inertia = dag.sum(&terms);
    let force = dag.substitute(&[force], values)[0];
    dag.sub(inertia, force)
}

/// Does every motion that the ties between redundant speeds allow move some mass, at every sample?
pub(crate) fn is_inert(
    alg: &mut Algebra,
    model: &Model,
    k: &Kinematics,
    solution: &Solution,
    table: &mut SampleTable,
) -> bool {
    let mut parts = MassAndForce::default();
    inertia_force::accumulate(alg, model, k, &Given::default(), &mut parts);
    let values = unknown_values(alg, model, k, solution);
    let Reduced { mass, .. } = reduce::reduce(alg, k, solution, parts);
    let forcing = vec![alg.dag.zero(); mass.len()];
    redundant::solve(alg, model, k, table, (&solution.ties, &values), (&mass, &forcing)).is_some()
}

/// The result for a model without masses: the values of the unknowns; every force, acceleration and energy is 0.
pub(crate) fn without_mass(
    alg: &mut Algebra,
    model: &Model,
    k: &Kinematics,
    solution: &Solution,
    table: &mut SampleTable,
) -> Dynamics {
    let values = unknown_values(alg, model, k, solution);
    let speed_correction = match solution.ties.is_empty() {
        true => Vec::new(),
        false => redundant::shortest_correction(alg, model, k, table, &solution.ties).unwrap_or_default(),
    };
    let (zero, n_u) = (alg.dag.zero(), k.unknowns.independent().len());
    Dynamics {
        mass_matrix: Vec::new(),
        forcing: Vec::new(),
        u_dot: vec![zero; n_u],
        kinetic: zero,
        potential: zero,
        drive: None,
        speed_correction,
        values,
        pivots: Vec::new(),
        augmented: Augmented::default(),
    }
}

/// u' and pivots by the cheapest form: through the mass matrix, as a chain, or hinge by hinge.
fn accelerations(
    alg: &mut Algebra,
    (model, k, solution): (&Model, &Kinematics, &Solution),
    table: &mut SampleTable,
    segments: Option<&[Segment]>,
    (mass_matrix, forcing): (&[Vec<ExprId>], &[ExprId]),
    optimise: Optimise,
) -> Result<(Vec<ExprId>, Vec<Pivot>), Diagnostics> {
    let chain = segments.and_then(|segments| chain::derive(alg, model, k, table, segments));
    let hinges = articulated::derive(alg, model, k, solution, table, mass_matrix);
    let forms = chain.map(|c| (c.u_dot, c.pivots)).into_iter().chain(hinges.map(|h| (h.u_dot, h.pivots)));
    let shortest = forms.map(|form| (alg.dag.cost(&form.0, optimise), form)).min_by_key(|(cost, _)| *cost);
    // If forming the mass matrix alone costs more, its factorisation need not be tried.
    let entries: Vec<ExprId> = mass_matrix.iter().flatten().chain(forcing).copied().collect();
    if let Some((cost, form)) = &shortest
        && *cost <= alg.dag.cost(&entries, optimise)
    {
        return Ok(form.clone());
    }
    let (u_dot, pivots) = solve::ldl(alg, model, k, table, mass_matrix, forcing)?;
    match shortest {
        Some((cost, form)) if cost < alg.dag.cost(&u_dot, optimise) => Ok(form),
        _ => Ok((u_dot, pivots)),
    }
}

/// By symbol: the value of every eliminated unknown, each from those eliminated after it. Labels each with the
/// unknown's name and a dependent speed with the model's line.
pub(crate) fn unknown_values(
    alg: &mut Algebra,
    model: &Model,
    k: &Kinematics,
    solution: &Solution,
) -> HashMap<SymbolId, ExprId> {
    let mut values: HashMap<UnknownId, ExprId> =
        k.unknowns.enumerate().map(|(id, u)| (id, u.value)).collect();
    let mut by_symbol = HashMap::default();
    for step in solution.steps.iter().rev() {
        let terms: Vec<_> = step.coefficients.iter().map(|(z, &c)| alg.dag.mul(c, values[z])).collect();
        let value = alg.dag.sum(&terms);
        let Unknown { name, kind, .. } = &k.unknowns[step.unknown];
        let mut label = Label::named(Section::Velocities, &**name);
        if let UnknownKind::Dependent(speed) = *kind {
            label = label.at(model.source.place(model.speeds[speed].span));
        }
        alg.dag.label(value, label);
        values.insert(step.unknown, value);
        if let Some(symbol) = alg.dag.as_symbol(k.unknowns[step.unknown].value) {
            by_symbol.insert(symbol, value);
        }
    }
    by_symbol
}
