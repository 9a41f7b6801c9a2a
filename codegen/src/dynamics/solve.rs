//! M u' = forcing by L D L', written out; M is symmetric and positive definite.

use super::absolute::Absolute;
use crate::diagnostic::{Diagnostic, Diagnostics};
use crate::expr::tape::SampleTable;
use crate::expr::{Dag, ExprId};
use crate::kinematics::Kinematics;
use crate::kinematics::eliminate::{Pivot, pivot_of};
use crate::model::Model;

/// M = L D L', for right-hand sides that are known later.
pub(super) struct Factors {
    /// `lower[i][j]` = L_ij for j < i.
    lower: Vec<Vec<ExprId>>,
    diagonal: Vec<ExprId>,
}

impl Factors {
    pub fn new(dag: &mut Dag, mass: &[Vec<ExprId>]) -> Self {
        let n = mass.len();
        let zero = dag.zero();
        let (mut scaled, mut lower) = (vec![vec![zero; n]; n], vec![vec![zero; n]; n]);
        let mut diagonal = Vec::with_capacity(n);
        for i in 0..n {
            for j in 0..=i {
                let mut entry = mass[i][j];
                for c in 0..j {
                    let term = dag.mul(scaled[i][c], lower[j][c]);
                    entry = dag.sub(entry, term);
                }
                if j == i {
                    diagonal.push(entry);
                } else {
                    scaled[i][j] = entry;
                    lower[i][j] = dag.div(entry, diagonal[j]);
                }
            }
        }
        Self { lower, diagonal }
    }

    /// L^-1 right.
    pub fn forward(&self, dag: &mut Dag, right: &[ExprId]) -> Vec<ExprId> {
        let mut x = right.to_vec();
        for i in 0..x.len() {
            for c in 0..i {
                let term = dag.mul(self.lower[i][c], x[c]);
                x[i] = dag.sub(x[i], term);
            }
        }
        x
    }

    /// D^-1 x.
    pub fn divide(&self, dag: &mut Dag, x: &[ExprId]) -> Vec<ExprId> {
        x.iter().zip(&self.diagonal).map(|(&x, &d)| dag.div(x, d)).collect()
    }

    /// M^-1 right.
    pub fn solve(&self, dag: &mut Dag, right: &[ExprId]) -> Vec<ExprId> {
        let x = self.forward(dag, right);
        let mut x = self.divide(dag, &x);
        for i in (0..x.len()).rev() {
            for c in i + 1..x.len() {
                let term = dag.mul(self.lower[c][i], x[c]);
                x[i] = dag.sub(x[i], term);
            }
        }
        x
    }
}

/// A pivot of the mass matrix this small against its diagonal entry means: no inertia.
const NO_INERTIA: f64 = 1e-12;

/// u' and the pivots that are not constants.
pub(super) fn ldl(
    model: &Model,
    k: &mut Kinematics,
    table: &mut SampleTable,
    mass: &[Vec<ExprId>],
    forcing: &[ExprId],
) -> Result<(Vec<ExprId>, Vec<Pivot>), Diagnostics> {
    let n = forcing.len();
    let dag = &mut k.dag;
    let zero = dag.zero();
    let absolute = Absolute::new(dag, mass, forcing);
    let (mass, forcing) = (&absolute.mass, &absolute.forcing);
    // scaled[i][j] = L_ij D_j, lower[i][j] = L_ij for j < i.
    let (mut scaled, mut lower) = (vec![vec![zero; n]; n], vec![vec![zero; n]; n]);
    let mut pivots = Vec::new();
    let mut diagonal = Vec::with_capacity(n);
    for i in 0..n {
        for j in 0..=i {
            let mut entry = mass[i][j];
            for c in 0..j {
                let term = dag.mul(scaled[i][c], lower[j][c]);
                entry = dag.sub(entry, term);
            }
            if j < i {
                scaled[i][j] = entry;
                lower[i][j] = dag.div(entry, diagonal[j]);
                continue;
            }
            let reference = table.values(dag, mass[i][i]).to_vec();
            let values = table.values(dag, entry);
            if !values.iter().zip(&reference).all(|(d, m)| *d > NO_INERTIA * m.abs()) {
                return Err(without_inertia(model, k, absolute.order[i]));
            }
            dag.name(entry, &format!("pivot_{}", absolute.order[i]));
            if !dag.is_constant(entry) {
                pivots.push(pivot_of(dag, table, entry));
            }
            diagonal.push(entry);
        }
    }
    // L z = forcing, then D L' u' = z.
    let mut u_dot = forcing.to_vec();
    for i in 0..n {
        for c in 0..i {
            let term = dag.mul(lower[i][c], u_dot[c]);
            u_dot[i] = dag.sub(u_dot[i], term);
        }
    }
    for i in (0..n).rev() {
        u_dot[i] = dag.div(u_dot[i], diagonal[i]);
        for c in i + 1..n {
            let term = dag.mul(lower[c][i], u_dot[c]);
            u_dot[i] = dag.sub(u_dot[i], term);
        }
    }
    Ok((absolute.relative(dag, &u_dot), pivots))
}

fn without_inertia(model: &Model, k: &Kinematics, index: usize) -> Diagnostics {
    let independent: Vec<_> = model.speeds.iter().filter(|s| s.independent).collect();
    let mut error = Diagnostic::error(format!(
        "the mass matrix is singular: some motion of `{}` moves no mass",
        independent.get(index).map_or("?", |s| s.name.as_str())
    ))
    .help(if model.bodies.is_empty() {
        "the model has no bodies: add `[bodies]` with masses, or derive what needs none (`--form kinematic`)"
    } else {
        "give a mass or an inertia to every body that this coordinate moves"
    });
    if let Some(speed) = independent.get(index) {
        error = error.label(speed.span, format!("speed {} of {}", index + 1, k.unknowns.len()));
    }
    Diagnostics { source: model.source.clone(), items: vec![error] }
}
