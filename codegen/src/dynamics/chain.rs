//! Chains and trees: u' with the forces transmitted between mass centres as additional unknowns.
//!
//! The mass centres form a tree of segments (see `segment`). R_s = sum m (a - g), over the centres at and beyond the
//! outer end of segment s, is the force that the segment transmits. With A = a - g, and A = 0, g = 0 at O:
//!
//! - Newton at the outer end: m_s A_s = R_s - sum of the R of the segments that begin there. It is solved for A_s as a
//!   vector equation, whatever the triads, by dividing by the mass.
//! - Segment: A_s - A_inner - sum_k v_k y_k' = bias + g_inner - g_s; v_k and bias are those of the segment alone.
//! - Kane, for every speed: sum_s v_k . R_s + (rotational inertia) y' = the other generalised forces.
//!
//! A segment's equations are resolved in the triad that turns with it. In the inertial triad pivots would be sines and
//! cosines that vanish somewhere (measured on ten links: error 3e-11 instead of 2e-15), and the form is longer.
//! Neighbouring segments are related by the difference of their angles, which takes two thirds of the operations of
//! products of their sines and cosines and has the smaller error (1.7e-15 instead of 2.4e-15).
//!
//! Every equation contains the unknowns of a few neighbours, so that the sparse elimination grows linearly with the
//! length of a chain without any explicit recursion. If some speeds depend on others, this form is not offered.

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

/// u' by elimination of the transmitted forces.
#[derive(Clone, Debug)]
pub(super) struct Chain {
    /// The independent accelerations.
    pub u_dot: Vec<ExprId>,
    /// The divisors that are not constants.
    pub pivots: Vec<Pivot>,
}

/// u' with the transmitted forces eliminated; `None` if no safe pivot is left. All speeds must be independent.
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
    // Dividing by 1 / m multiplies by m.
    let divides = |&d: &ExprId| !alg.dag.is_constant(d) && !is_reciprocal(&alg.dag, d);
    let varying: Vec<ExprId> = divisors.into_iter().filter(divides).collect();
    let pivots = varying.into_iter().map(|d| pivot_of(&alg.dag, table, d)).collect();
    Some(Chain { u_dot, pivots })
}

fn is_reciprocal(dag: &Dag, expr: ExprId) -> bool {
    matches!(dag.node(expr), Node::Binary(Binary::Div, one, _) if dag.is_one(one))
}

/// Labels the transmitted forces.
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

/// The unknown for one component of the force of segment `s`.
fn force(k: &Kinematics, s: usize, axis: usize) -> UnknownId {
    UnknownId::from_index(k.unknowns.len() + 3 * s + axis)
}

/// Typical sizes of the unknowns: such that the largest entry in every column of the segments' equations is 1.
fn sizes(dag: &Dag, table: &mut SampleTable, equations: &[Equation]) -> BTreeMap<UnknownId, f64> {
    let mut largest: BTreeMap<UnknownId, f64> = BTreeMap::new();
    for (&unknown, &entry) in equations.iter().flat_map(|e| &e.coefficients) {
        let here = table.values(dag, entry).iter().fold(0.0_f64, |m, x| m.max(x.abs()));
        let mine = largest.entry(unknown).or_insert(0.0);
        *mine = mine.max(here);
    }
    largest.into_iter().filter(|(_, m)| *m > 0.0).map(|(unknown, m)| (unknown, 1.0 / m)).collect()
}

/// Keeps the equations coupled to the derivative of a speed, directly or through others. In a planar chain, for
/// example, the equations of motion out of the plane are dropped.
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

/// The data from which the equations are written.
struct System<'a> {
    alg: &'a mut Algebra,
    k: &'a Kinematics,
    segments: &'a [Segment],
    /// Triad of every segment's force and equation: the one that turns with it.
    triad: Vec<TriadId>,
    /// Reciprocal of every segment's mass.
    lightness: Vec<ExprId>,
    /// By segment: the segments that begin at its outer end.
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

    /// The segment's equations with A_s - A_inner in terms of the forces: ... = bias + g_inner - g_s.
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

    /// Adds or subtracts A of the outer end of segment `end`, resolved in the triad of segment `s`.
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
