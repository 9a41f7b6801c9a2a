//! Dynamics: Kane's equations F_r + F*_r = 0 in the independent speeds.
//!
//! Over all unknowns y (speeds and lifted twists) the inertia is sparse; the solution of the
//! constraints, y = T u and y' = T u' + beta, projects it: M = T' M_y T, forcing = T' (F_y - h_y - M_y beta).
//! No mass matrix of the dependent speeds is ever inverted.

mod active_force;
mod augmented;
mod chain;
mod composite;
mod energy;
mod inertia_force;
mod segment;
mod solve;

pub use augmented::Augmented;

use crate::diagnostic::Diagnostics;
use crate::expr::cost::Optimise;
use crate::expr::tape::SampleTable;
use crate::expr::{Dag, ExprId, SymbolId};
use crate::kinematics::eliminate::{Pivot, Solution};
use crate::kinematics::{Kinematics, UnknownId, UnknownKind};
use crate::model::Model;
use rustc_hash::FxHashMap as HashMap;
use segment::Segment;
use std::collections::BTreeMap;

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
    /// Value of every unknown in terms of the independent speeds.
    pub values: HashMap<SymbolId, ExprId>,
    /// Pivots of the mass matrix.
    pub pivots: Vec<Pivot>,
    /// The same equations before the elimination.
    pub augmented: Augmented,
}

/// Inertia and forces over all unknowns.
#[derive(Clone, Debug, Default)]
pub(crate) struct Unprojected {
    /// Upper triangle of M_y: keys (k, l) with k <= l.
    mass: BTreeMap<(UnknownId, UnknownId), ExprId>,
    /// F_y - h_y: active forces less the inertia bias.
    force: BTreeMap<UnknownId, ExprId>,
}

impl Unprojected {
    fn add_mass(&mut self, dag: &mut Dag, k: UnknownId, l: UnknownId, term: ExprId) {
        let key = (k.min(l), k.max(l));
        let sum = match self.mass.get(&key) {
            Some(&mine) => dag.add(mine, term),
            None => term,
        };
        self.mass.insert(key, sum);
    }

    fn add_force(&mut self, dag: &mut Dag, k: UnknownId, term: ExprId) {
        let sum = match self.force.get(&k) {
            Some(&mine) => dag.add(mine, term),
            None => term,
        };
        self.force.insert(k, sum);
    }
}

/// Derives the equations of motion.
///
/// # Errors
/// If the mass matrix is singular: a coordinate moves without moving any mass.
pub fn derive(
    model: &Model,
    k: &mut Kinematics,
    solution: &Solution,
    table: &mut SampleTable,
    optimise: Optimise,
) -> Result<Dynamics, Diagnostics> {
    let mut parts = Unprojected::default();
    let segments = segment::sparse_tree(model, k);
    match &segments {
        Some(segments) => {
            composite::accumulate(k, segments, &mut parts);
            inertia_force::rotations(model, k, &mut parts);
        }
        None => inertia_force::accumulate(model, k, &mut parts),
    }
    active_force::accumulate(model, k, &mut parts);
    let (kinetic, potential) = (energy::kinetic(k, &parts), energy::potential(model, k));
    let values = unknown_values(k, solution);
    let augmented = augmented::derive(k, solution, &parts, &values);
    let (mass_matrix, forcing) = project(k, solution, &parts);
    let forcing = k.dag.substitute(&forcing, &values);
    let energies = k.dag.substitute(&[kinetic, potential], &values);
    let (u_dot, pivots) =
        accelerations(model, k, table, segments.as_deref(), (&mass_matrix, &forcing), optimise)?;
    Ok(Dynamics {
        mass_matrix,
        forcing,
        u_dot,
        kinetic: energies[0],
        potential: energies[1],
        values,
        pivots,
        augmented,
    })
}

/// u' and pivots in whichever form costs less: through the mass matrix, or as a chain.
fn accelerations(
    model: &Model,
    k: &mut Kinematics,
    table: &mut SampleTable,
    segments: Option<&[Segment]>,
    (mass_matrix, forcing): (&[Vec<ExprId>], &[ExprId]),
    optimise: Optimise,
) -> Result<(Vec<ExprId>, Vec<Pivot>), Diagnostics> {
    let chain = segments.and_then(|segments| chain::derive(model, k, table, segments));
    let chain = chain.map(|c| (k.dag.cost(&c.u_dot, optimise), c));
    // The mass matrix alone may cost more: then it need not be solved with.
    let entries: Vec<ExprId> = mass_matrix.iter().flatten().chain(forcing).copied().collect();
    if let Some((cost, chain)) = &chain
        && *cost <= k.dag.cost(&entries, optimise)
    {
        return Ok((chain.u_dot.clone(), chain.pivots.clone()));
    }
    let (u_dot, pivots) = solve::ldl(model, k, table, mass_matrix, forcing)?;
    match chain {
        Some((cost, chain)) if cost < k.dag.cost(&u_dot, optimise) => Ok((chain.u_dot, chain.pivots)),
        _ => Ok((u_dot, pivots)),
    }
}

/// y = T u for every unknown that is not an independent speed; named after the unknown.
fn unknown_values(k: &mut Kinematics, solution: &Solution) -> HashMap<SymbolId, ExprId> {
    let independent: Vec<ExprId> = (k.unknowns.iter())
        .filter(|u| matches!(u.kind, UnknownKind::Independent(_)))
        .map(|u| u.value)
        .collect();
    let mut values = HashMap::default();
    for (id, partials) in &solution.partials {
        let unknown = k.unknowns[*id].clone();
        if matches!(unknown.kind, UnknownKind::Independent(_)) {
            continue;
        }
        let terms: Vec<_> = partials.iter().zip(&independent).map(|(&t, &u)| k.dag.mul(t, u)).collect();
        let value = k.dag.sum(&terms);
        k.dag.name(value, &unknown.name);
        if let Some(symbol) = k.dag.as_symbol(unknown.value) {
            values.insert(symbol, value);
        }
    }
    values
}

/// M = T' M_y T and T' (force - M_y beta), sums over the few non-zero entries.
fn project(k: &mut Kinematics, solution: &Solution, parts: &Unprojected) -> (Vec<Vec<ExprId>>, Vec<ExprId>) {
    let n = solution.partials.values().next().map_or(0, Vec::len);
    let zero = k.dag.zero();
    let mut mass_matrix = vec![vec![zero; n]; n];
    let mut forcing = vec![zero; n];
    // Rows of M_y that are not zero: unknown -> [(other, entry)].
    let mut rows: BTreeMap<UnknownId, Vec<(UnknownId, ExprId)>> = BTreeMap::new();
    for (&(a, b), &entry) in &parts.mass {
        rows.entry(a).or_default().push((b, entry));
        if a != b {
            rows.entry(b).or_default().push((a, entry));
        }
    }
    let dag = &mut k.dag;
    for (a, entries) in &rows {
        let t_a = &solution.partials[a];
        // This row of M_y T, then its products with T': the upper triangle.
        let weighted: Vec<ExprId> = (0..n)
            .map(|column| {
                let terms: Vec<_> =
                    entries.iter().map(|(b, m)| dag.mul(*m, solution.partials[b][column])).collect();
                dag.sum(&terms)
            })
            .collect();
        for (row, entry) in mass_matrix.iter_mut().enumerate() {
            for (total, &w) in entry.iter_mut().zip(&weighted).skip(row) {
                let term = dag.mul(t_a[row], w);
                *total = dag.add(*total, term);
            }
        }
    }
    let acting: Vec<UnknownId> = solution.partials.keys().copied().collect();
    for a in acting {
        let mut force = parts.force.get(&a).copied().unwrap_or(zero);
        for (b, m) in rows.get(&a).into_iter().flatten() {
            let term = dag.mul(*m, solution.bias[b]);
            force = dag.sub(force, term);
        }
        for (total, &t) in forcing.iter_mut().zip(&solution.partials[&a]) {
            let term = dag.mul(t, force);
            *total = dag.add(*total, term);
        }
    }
    let upper = mass_matrix.clone();
    for (row, entries) in mass_matrix.iter_mut().enumerate() {
        for (entry, above) in entries.iter_mut().zip(&upper).take(row) {
            *entry = above[row];
        }
    }
    name_matrix(k, solution, &mass_matrix, &forcing);
    (mass_matrix, forcing)
}

/// Names for partial velocities, mass matrix and forcing.
fn name_matrix(k: &mut Kinematics, solution: &Solution, mass: &[Vec<ExprId>], forcing: &[ExprId]) {
    let speeds: Vec<String> = (k.unknowns.iter())
        .filter(|u| matches!(u.kind, UnknownKind::Independent(_)))
        .map(|u| u.name.clone())
        .collect();
    for (&id, partials) in &solution.partials {
        let name = k.unknowns[id].name.clone();
        for (&partial, speed) in partials.iter().zip(&speeds) {
            k.dag.name(partial, &format!("{name}_per_{speed}"));
        }
        k.dag.name(solution.bias[&id], &format!("{name}_dot_bias"));
    }
    for (i, row) in mass.iter().enumerate() {
        for j in i..row.len() {
            k.dag.name(row[j], &format!("mass_{}_{}", speeds[i], speeds[j]));
        }
        k.dag.name(forcing[i], &format!("forcing_{}", speeds[i]));
    }
}
