//! Chains and trees: the forces transmitted between mass centres as further unknowns.
//!
//! The mass centres form a tree of segments (see `segment`). R_s = sum m (a - g), over the centres at and
//! beyond the outer end of segment s, is the force that it transmits. With A = a - g, and A = 0, g = 0 at O:
//!
//! - Newton at the outer end: m_s A_s = R_s - sum of the R of the segments that begin there. It is divided by
//!   the mass and used up as a vector equation, whatever the triads.
//! - Segment: A_s - A_inner - sum_k v_k y_k' = bias + g_inner - g_s; v_k and bias are those of the segment alone.
//! - Kane, for every speed: sum_s v_k . R_s + (rotational inertia) y' = the other generalised forces.
//!
//! A segment's equations are resolved in the triad that turns with it. In the inertial one pivots would be sines
//! and cosines that vanish somewhere (measured on ten links: 3e-11 instead of 2e-15), and the form is longer.
//! Neighbours are turned against each other by the difference of their angles: two thirds of the operations of
//! products of their sines and cosines, and the smaller error (1.7e-15 instead of 2.4e-15).
//!
//! Every equation holds the unknowns of a few neighbours, so that the sparse elimination grows linearly with the
//! length of a chain; no recursion is written anywhere. Where speeds depend on others the form is not offered.

use super::mass_and_force::MassAndForce;
use super::segment::Segment;
use super::{active_force, inertia_force};
use crate::expr::tape::SampleTable;
use crate::expr::{Binary, Dag, ExprId, Label, Node};
use crate::id::Id;
use crate::kinematics::eliminate::{Pivot, pivot_of};
use crate::kinematics::sparse::{self, Equation, Screening, Values};
use crate::kinematics::{Kinematics, LinearForm, UnknownId};
use crate::model::Model;
use crate::section::Section;
use crate::vector::{Algebra, Components, TriadId, Vector};
use std::collections::{BTreeMap, BTreeSet};

/// u' without a mass matrix.
#[derive(Clone, Debug)]
pub(super) struct Chain {
    /// The independent accelerations.
    pub u_dot: Vec<ExprId>,
    /// What is divided by.
    pub pivots: Vec<Pivot>,
}

/// u' with the transmitted forces eliminated; none where no pivot is safe. All speeds are independent.
pub(super) fn derive(
    alg: &mut Algebra,
    model: &Model,
    k: &Kinematics,
    table: &mut SampleTable,
    segments: &[Segment],
) -> Option<Chain> {
    let mut rest = MassAndForce::default();
    inertia_force::rotations(alg, model, k, &mut rest);
    active_force::accumulate(alg, model, k, &mut rest);
    let equations = System::new(alg, k, segments).equations(&rest);
    let sizes = sizes(&alg.dag, table, &equations[..3 * segments.len()]);
    let screening = Screening { sizes, last_resort: false, divide_sums: true };
    let speeds: Vec<UnknownId> = k.unknowns.ids().collect();
    let equations = seen_by(&speeds, equations);
    let steps = sparse::eliminate_screened(&mut alg.dag, table, equations, &screening);
    let values = sparse::back_substitute(&mut alg.dag, &steps)?;
    let divisors = steps.iter().map(|step| step.pivot);
    name(alg, k, segments, &values);
    let u_dot = speeds.iter().map(|u| values.get(u).map(|v| v[0])).collect::<Option<Vec<_>>>()?;
    let masses = segments.iter().map(|s| s.mass);
    let divisors: BTreeSet<ExprId> = masses.chain(divisors).map(|d| alg.dag.unsigned(d)).collect();
    // To divide by 1 / m is to multiply by m.
    let divides = |&d: &ExprId| !alg.dag.is_constant(d) && !is_reciprocal(&alg.dag, d);
    let varying: Vec<ExprId> = divisors.into_iter().filter(divides).collect();
    let pivots = varying.into_iter().map(|d| pivot_of(&alg.dag, table, d)).collect();
    Some(Chain { u_dot, pivots })
}

fn is_reciprocal(dag: &Dag, expr: ExprId) -> bool {
    matches!(dag.node(expr), Node::Binary(Binary::Div, one, _) if dag.is_one(one))
}

/// Names for the forces.
fn name(alg: &mut Algebra, k: &Kinematics, segments: &[Segment], values: &Values) {
    for (s, segment) in segments.iter().enumerate() {
        for (axis, letter) in ["x", "y", "z"].into_iter().enumerate() {
            if let Some(value) = values.get(&force(k, s, axis)) {
                let name = format!("force_{}_{letter}", segment.name);
                alg.dag.label(value[0], Label::named(Section::Forces, name));
            }
        }
    }
}

/// The unknown that is a component of the force of segment `s`.
fn force(k: &Kinematics, s: usize, axis: usize) -> UnknownId {
    UnknownId::from_index(k.unknowns.len() + 3 * s + axis)
}

/// Typical sizes of the unknowns: what makes the largest entry 1 in every column of the segments' equations.
fn sizes(dag: &Dag, table: &mut SampleTable, equations: &[Equation]) -> BTreeMap<UnknownId, f64> {
    let mut largest: BTreeMap<UnknownId, f64> = BTreeMap::new();
    for (&unknown, &entry) in equations.iter().flat_map(|e| &e.coefficients) {
        let here = table.values(dag, entry).iter().fold(0.0_f64, |m, x| m.max(x.abs()));
        let mine = largest.entry(unknown).or_insert(0.0);
        *mine = mine.max(here);
    }
    largest.into_iter().filter(|(_, m)| *m > 0.0).map(|(unknown, m)| (unknown, 1.0 / m)).collect()
}

/// The equations that a speed's derivative has to do with, directly or through others: motion out of
/// the plane of a plane chain, for one, drops out.
fn seen_by(speeds: &[UnknownId], equations: Vec<Equation>) -> Vec<Equation> {
    let mut seen: BTreeSet<UnknownId> = speeds.iter().copied().collect();
    loop {
        let before = seen.len();
        for equation in &equations {
            if equation.coefficients.keys().any(|u| seen.contains(u)) {
                seen.extend(equation.coefficients.keys());
            }
        }
        if seen.len() == before {
            break;
        }
    }
    let keep = |e: &Equation| e.coefficients.keys().any(|u| seen.contains(u));
    equations.into_iter().filter(keep).collect()
}

/// What the equations are written with.
struct System<'a> {
    alg: &'a mut Algebra,
    k: &'a Kinematics,
    segments: &'a [Segment],
    /// Triad of every segment's force and equation: the one that turns with it.
    triad: Vec<TriadId>,
    /// Reciprocal of every segment's mass.
    lightness: Vec<ExprId>,
    /// Segments that begin at the outer end of every segment.
    outer: Vec<Vec<usize>>,
}

impl<'a> System<'a> {
    fn new(alg: &'a mut Algebra, k: &'a Kinematics, segments: &'a [Segment]) -> Self {
        let one = alg.dag.one();
        let mut outer = vec![Vec::new(); segments.len()];
        for (s, segment) in segments.iter().enumerate() {
            if let Some(inner) = segment.inner {
                outer[inner].push(s);
            }
        }
        let lightness = segments.iter().map(|s| alg.dag.div(one, s.mass)).collect();
        Self { triad: segments.iter().map(Segment::own_triad).collect(), lightness, outer, alg, k, segments }
    }

    fn equations(mut self, rest: &MassAndForce) -> Vec<Equation> {
        let mut kane: BTreeMap<UnknownId, Equation> = BTreeMap::new();
        for u in self.k.unknowns.ids() {
            let right = rest.force.get(&u).copied().unwrap_or_else(|| self.alg.dag.zero());
            kane.insert(u, Equation { coefficients: LinearForm::default(), right: vec![right] });
        }
        for (&(a, b), &inertia) in &rest.mass {
            for (row, column) in [(a, b), (b, a)].into_iter().take(if a == b { 1 } else { 2 }) {
                let row = kane.get_mut(&row).expect("every speed has an equation");
                row.coefficients.add_term(&mut self.alg.dag, column, &inertia);
            }
        }
        let mut equations = Vec::new();
        for s in 0..self.segments.len() {
            let mut rows = self.segment_rows(s);
            for (&u, v) in &self.segments[s].motion.partials {
                let v = self.components(v, self.triad[s]);
                for (axis, &component) in v.iter().enumerate() {
                    let force = force(self.k, s, axis);
                    let row = kane.get_mut(&u).expect("every speed has an equation");
                    row.coefficients.add_term(&mut self.alg.dag, force, &component);
                    let negative = self.alg.dag.negate(component);
                    rows[axis].coefficients.add_term(&mut self.alg.dag, u, &negative);
                }
            }
            equations.extend(rows);
        }
        equations.extend(kane.into_values());
        equations
    }

    /// A_s - A_inner in terms of the forces, = bias + g_inner - g_s.
    fn segment_rows(&mut self, s: usize) -> [Equation; 3] {
        let Segment { inner, gravity, motion, .. } = &self.segments[s];
        let mut right = motion.bias.minus(&mut self.alg.dag, gravity);
        if let Some(p) = *inner {
            right = right.plus(&mut self.alg.dag, &self.segments[p].gravity);
        }
        let right = self.components(&right, self.triad[s]);
        let mut rows =
            right.map(|value| Equation { coefficients: LinearForm::default(), right: vec![value] });
        self.add_acceleration(&mut rows, s, s, false);
        if let Some(p) = *inner {
            self.add_acceleration(&mut rows, s, p, true);
        }
        rows
    }

    /// Adds A of the outer end of segment `end`, or subtracts it, resolved in the triad of segment `s`.
    fn add_acceleration(&mut self, rows: &mut [Equation; 3], s: usize, end: usize, subtract: bool) {
        let weight = self.lightness[end];
        let outer = self.outer[end].clone();
        for (other, negative) in
            [(end, subtract)].into_iter().chain(outer.into_iter().map(|c| (c, !subtract)))
        {
            for axis in 0..3 {
                let mut unit = [self.alg.dag.zero(); 3];
                unit[axis] = self.alg.dag.one();
                let unit = Vector::new(&self.alg.dag, self.triad[other], unit);
                let turned = self.components(&unit, self.triad[s]);
                let force = force(self.k, other, axis);
                for (row, component) in rows.iter_mut().zip(turned) {
                    let term = self.alg.dag.mul(weight, component);
                    let term = if negative { self.alg.dag.negate(term) } else { term };
                    row.coefficients.add_term(&mut self.alg.dag, force, &term);
                }
            }
        }
    }

    fn components(&mut self, vector: &Vector, triad: TriadId) -> Components {
        self.alg.express_by_differences(vector, triad)
    }
}
