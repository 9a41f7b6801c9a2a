//! Solves M u' = forcing by L D L', written out symbolically; M is symmetric and positive definite.

use super::absolute::Absolute;
use crate::diagnostic::{Diagnostic, Diagnostics};
use crate::expr::tape::SampleTable;
use crate::expr::{Dag, ExprId, Label};
use crate::kinematics::Kinematics;
use crate::kinematics::eliminate::{Pivot, pivot_of};
use crate::model::Model;
use crate::section::Section;
use crate::vector::Algebra;
use std::convert::Infallible;

/// The factors of M = L D L', for right-hand sides that become known later.
pub(super) struct Factors {
    /// `lower[i][j]` = L_ij for j < i.
    lower: Vec<Vec<ExprId>>,
    pub diagonal: Vec<ExprId>,
}

impl Factors {
    pub fn new(dag: &mut Dag, mass: &[Vec<ExprId>]) -> Self {
        let Ok(factors) = Self::checked(dag, mass, |_, _, _| Ok::<(), Infallible>(()));
        factors
    }

    /// Factors M; `check` sees each pivot D with its row as it arises.
    fn checked<E>(
        dag: &mut Dag,
        mass: &[Vec<ExprId>],
        mut check: impl FnMut(&mut Dag, usize, ExprId) -> Result<(), E>,
    ) -> Result<Self, E> {
        let n = mass.len();
        let zero = dag.zero();
        // scaled[i][j] = L_ij D_j.
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
                    check(dag, i, entry)?;
                    diagonal.push(entry);
                } else {
                    scaled[i][j] = entry;
                    lower[i][j] = dag.div(entry, diagonal[j]);
                }
            }
        }
        Ok(Self { lower, diagonal })
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

    /// M^-1 right: L z = right, then D L' x = z.
    pub fn solve(&self, dag: &mut Dag, right: &[ExprId]) -> Vec<ExprId> {
        let mut x = self.forward(dag, right);
        for i in (0..x.len()).rev() {
            x[i] = dag.div(x[i], self.diagonal[i]);
            for c in i + 1..x.len() {
                let term = dag.mul(self.lower[c][i], x[c]);
                x[i] = dag.sub(x[i], term);
            }
        }
        x
    }

    /// M^-1 = L^-T D^-1 L^-1: with X = L^-1, entry (i, j) is sum over k >= i, j of X_ki X_kj / D_k.
    pub fn inverse(&self, dag: &mut Dag) -> Vec<Vec<ExprId>> {
        let n = self.diagonal.len();
        let (zero, one) = (dag.zero(), dag.one());
        let mut columns = Vec::new();
        for j in 0..n {
            let mut unit = vec![zero; n];
            unit[j] = one;
            columns.push(self.forward(dag, &unit));
        }
        let mut inverse = vec![vec![zero; n]; n];
        for j in 0..n {
            let scaled = self.divide(dag, &columns[j]);
            for i in 0..=j {
                let terms: Vec<ExprId> =
                    columns[i].iter().zip(&scaled).map(|(&x, &y)| dag.mul(x, y)).collect();
                inverse[i][j] = dag.sum(&terms);
                inverse[j][i] = inverse[i][j];
            }
        }
        inverse
    }
}

/// A pivot below this share of its diagonal entry means that no mass is moved.
pub(super) const NO_INERTIA: f64 = 1e-12;

/// Why a pivot of the mass matrix is no inertia.
enum Fault {
    /// It has no value at this sample.
    Undefined(usize),
    /// It is below 0 by more than rounding.
    Negative,
    /// It is 0.
    Zero,
}

impl Fault {
    /// The fault of a pivot with these values, compared with its diagonal entry.
    fn of(values: &[f64], diagonal: &[f64]) -> Option<Self> {
        if let Some(sample) = values.iter().position(|d| !d.is_finite()) {
            return Some(Self::Undefined(sample));
        }
        let mut pairs = values.iter().zip(diagonal);
        if pairs.clone().all(|(d, m)| *d > NO_INERTIA * m.abs()) {
            return None;
        }
        let is_negative = pairs.any(|(d, m)| *d < -NO_INERTIA * m.abs() || *m < 0.0);
        Some(if is_negative { Self::Negative } else { Self::Zero })
    }
}

/// u' and the pivots that are not constants.
pub(super) fn ldl(
    alg: &mut Algebra,
    model: &Model,
    k: &Kinematics,
    table: &mut SampleTable,
    mass: &[Vec<ExprId>],
    forcing: &[ExprId],
) -> Result<(Vec<ExprId>, Vec<Pivot>), Diagnostics> {
    let dag = &mut alg.dag;
    let absolute = Absolute::new(dag, mass, forcing);
    let Absolute { mass, forcing, order, .. } = &absolute;
    let mut pivots = Vec::new();
    let factors = Factors::checked(dag, mass, |dag, i, entry| {
        let reference = table.values(dag, mass[i][i]).to_vec();
        let values = table.values(dag, entry);
        if let Some(fault) = Fault::of(values, &reference) {
            return Err((order[i], fault));
        }
        dag.label(entry, Label::named(Section::Results, format!("pivot_{}", order[i])));
        if !dag.is_constant(entry) {
            pivots.push(pivot_of(dag, table, entry));
        }
        Ok(())
    });
    let factors = match factors {
        Ok(factors) => factors,
        Err((index, fault)) => return Err(without_inertia(alg, model, k, (index, fault))),
    };
    let u_dot = factors.solve(&mut alg.dag, forcing);
    Ok((absolute.relative(&mut alg.dag, &u_dot), pivots))
}

/// The error for a model whose speeds are all state and in which some motion that their ties allow moves no mass.
pub(super) fn still_masses(model: &Model) -> Diagnostics {
    let mut error = Diagnostic::error("the independent speeds have a dead point at which some motion moves no mass")
        .help("give a mass or an inertia to every body that moves there; or keep the dead point out of `range` and `nominal`");
    for speed in model.speeds.iter().filter(|s| s.independent) {
        error = error.label(speed.span, "declared independent");
    }
    Diagnostics { source: model.source.clone(), items: vec![error] }
}

fn without_inertia(
    alg: &Algebra,
    model: &Model,
    k: &Kinematics,
    (index, fault): (usize, Fault),
) -> Diagnostics {
    let independent: Vec<_> = model.speeds.iter().filter(|s| s.independent).collect();
    let name = independent.get(index).map_or("?", |s| s.name.as_str());
    let (message, help) = match fault {
        Fault::Undefined(sample) => (
            format!(
                "the inertia that `{name}` moves has no finite value at {}",
                place(alg, model, k, sample)
            ),
            "look for atan2(0, 0), a norm or root of 0, or a division by 0 in frames, points or inertias there; if \
             only this configuration has none, give another `nominal` or `range`",
        ),
        Fault::Negative => (
            format!("the mass matrix is not positive: some motion of `{name}` has a negative inertia"),
            "no mass moves in that way: correct the inertias, whose products (Ixy and its like) may be too large for \
             their moments",
        ),
        Fault::Zero => (
            format!("the mass matrix is singular: some motion of `{name}` moves no mass"),
            match model.bodies.is_empty() {
                true => {
                    "the model has no bodies: add `[bodies]` with masses, or derive what needs none (`--form kinematic`)"
                }
                false => "give a mass or an inertia to every body that this coordinate moves",
            },
        ),
    };
    let mut error = Diagnostic::error(message).help(help);
    if let Some(speed) = independent.get(index) {
        error = error.label(speed.span, format!("speed {} of {}", index + 1, k.unknowns.len()));
    }
    Diagnostics { source: model.source.clone(), items: vec![error] }
}

/// A sampled configuration in words.
fn place(alg: &Algebra, model: &Model, k: &Kinematics, sample: usize) -> String {
    let states = model.coordinates.ids().filter(|&c| k.coordinate_symbol(&alg.dag, c).is_some());
    let values = states.zip(&k.samples[sample]);
    values.map(|(c, q)| format!("{} = {q:.4}", model.coordinates[c].name)).collect::<Vec<_>>().join(", ")
}
