//! Constraint rows: closures, fixed vectors and stated constraints, differentiated with respect to time.
//!
//! A vector equation f(q) = 0 gives f' = sum_k V_k y_k = 0 and f'' = sum_k V_k y_k' + b = 0. Its projections on several
//! directions are candidate [`Row`]s, of which the elimination takes the cheapest independent ones. Equations with
//! lifted unknowns: (1) the velocity of a closing point equals the rate of each of its expressions, one short row per
//! leg; (2) a vector fixed in a frame turns with it. Any set of independent rows that spans all of them is equivalent
//! where the constraints hold.

use super::linear_form::LinearForm;
use super::quantities::{Direction, Kinematics, Motion, Place, Rate, Row, Value};
use super::unknowns::UnknownId;
use super::{lifted, lower, orientation, rank, rate, sampling};
use crate::expr::ExprId;
use crate::model::{Axis, FrameId, Model, PointId, SpeedMeaning};
use crate::vector::{Algebra, Components, TriadId, Vector, cross_components, dot_components};
use std::collections::{BTreeMap, BTreeSet};

const AXES: [Axis; 3] = [Axis::X, Axis::Y, Axis::Z];

/// A vector equation, and the triads and vectors on which it is projected.
struct VectorEquation {
    name: String,
    motion: Motion,
    residual: Vector,
    /// A vector fixed in the frame: the equation is projected on its cross products with the axes too.
    fixed: Option<Vector>,
    triads: BTreeSet<TriadId>,
}

/// The position level of the configuration constraints.
#[derive(Default)]
struct Configuration {
    /// Scalar residuals, 0 when satisfied, and the equation that each belongs to.
    residuals: Vec<(ExprId, Place)>,
    /// Vectors stated to be fixed in a frame, less their stated components.
    fixed_vectors: Vec<(Place, [ExprId; 3])>,
}

/// Adds the candidate rows (cheapest first) and the residuals.
pub(super) fn derive(alg: &mut Algebra, model: &Model, k: Kinematics) -> Kinematics {
    let mut found = Configuration::default();
    let rows = rows(alg, model, &k, &mut found);
    let (residuals, residual_names) = found.residuals.into_iter().unzip();
    Kinematics { rows, residuals, residual_names, fixed_vectors: found.fixed_vectors, ..k }
}

/// Candidate rows, cheapest first; residuals and fixed vectors are added to `found`.
fn rows(alg: &mut Algebra, model: &Model, k: &Kinematics, found: &mut Configuration) -> Vec<Row> {
    let mut rows = Vec::new();
    for point in model.points.ids().filter(|&p| !model.points[p].closures.is_empty()) {
        for equation in closures(alg, model, k, point, found) {
            rows.extend(project(alg, equation));
        }
    }
    for frame in model.frames.ids().filter(|&f| lifted::frame_is_lifted(model, f)) {
        for equation in turning(alg, model, k, frame, found) {
            rows.extend(project(alg, equation));
        }
    }
    for constraint in &model.configuration_constraints {
        match lower::value(alg, k, &constraint.expression) {
            Value::Vector(v) => {
                let residual = lifted::flatten(alg, k, &v);
                let motion = rate::derivative(alg, k, &residual);
                let triads = triads_of(&motion);
                let name = constraint.name.clone();
                let place = Place { name: name.clone(), span: constraint.span };
                found.add_residuals(alg, &residual, &place);
                let residual = rigid(alg, model, k, residual);
                rows.extend(project(alg, VectorEquation { name, motion, residual, fixed: None, triads }));
            }
            Value::Scalar(e) => {
                let rate = rate::scalar_rate(alg, k, e);
                let place = Place { name: constraint.name.clone(), span: constraint.span };
                found.residuals.push((e, place));
                rows.extend(row(alg, &constraint.name, rate, e));
            }
        }
    }
    for constraint in &model.motion_constraints {
        match lower::value(alg, k, &constraint.expression) {
            Value::Vector(v) => {
                let motion = rate::linear_motion(alg, k, &v);
                let triads = triads_of(&motion);
                // A vector that stays 0 has components that stay 0, so their rates vanish too, in any triad.
                for &triad in &triads {
                    for (axis, e) in AXES.into_iter().zip(alg.express(&v, triad)) {
                        let along = Some(Direction { triad, axis, turning: false });
                        let row = motion_row(alg, k, &constraint.name, e);
                        rows.extend(row.map(|row| Row { along, ..row }));
                    }
                }
                let (name, residual) = (constraint.name.clone(), Vector::zero());
                rows.extend(project(alg, VectorEquation { name, motion, residual, fixed: None, triads }));
            }
            Value::Scalar(e) => rows.extend(motion_row(alg, k, &constraint.name, e)),
        }
    }
    rows.sort_by_key(|row| row.cost);
    rows
}

/// Adds rows for the derivatives of closed forms, if the constraints do not determine all dependent speeds, or
/// determine them otherwise.
pub(super) fn complete(alg: &mut Algebra, model: &Model, mut k: Kinematics) -> Kinematics {
    if k.is_state.iter().all(|&state| state)
        || (rank::determined(alg, model, &k) && !contradicts_closed_forms(alg, model, &k))
    {
        return k;
    }
    let rows = speeds_in_closed_form(alg, model, &k);
    k.rows.extend(rows);
    k.rows.sort_by_key(|row| row.cost);
    k
}

/// Do motion constraints say something else of the speed of a coordinate than its closed form? Configuration
/// constraints have been compared with the forms themselves.
fn contradicts_closed_forms(alg: &Algebra, model: &Model, k: &Kinematics) -> bool {
    if model.motion_constraints.is_empty() {
        return false;
    }
    // A copy, so that rows needed for numbers alone leave no nodes in the program's DAG.
    let mut alg = alg.clone();
    let mut rows = k.rows.clone();
    let unknowns: Vec<UnknownId> = k.unknowns.moving().into_iter().chain(k.unknowns.clock()).collect();
    let mut table = sampling::sample_table(&alg, model, k);
    let without = rank::ranks(&alg, &mut table, &rows, &unknowns);
    rows.extend(speeds_in_closed_form(&mut alg, model, k));
    rank::ranks(&alg, &mut table, &rows, &unknowns) != without
}

/// u_c - d/dt(closed form) = 0 for a speed that is the rate of a coordinate in closed form.
fn speeds_in_closed_form(alg: &mut Algebra, model: &Model, k: &Kinematics) -> Vec<Row> {
    let mut rows = Vec::new();
    for (speed, declared) in model.speeds.enumerate() {
        let SpeedMeaning::RateOf(coordinate) = declared.meaning else { continue };
        if !k.is_state[coordinate] {
            let form = k.closed_forms.iter().find(|(c, _)| *c == coordinate).map(|(_, form)| *form);
            let closed = match form {
                Some(form) => rate::scalar_rate(alg, k, form),
                None => k.rates[coordinate].clone(),
            };
            let (one, mut partials) = (alg.dag.one(), closed.partials);
            partials.values_mut().for_each(|partial| *partial = alg.dag.negate(*partial));
            partials.insert(k.unknowns.of(speed), one);
            let rate = Rate { partials, bias: alg.dag.negate(closed.bias) };
            let zero = alg.dag.zero();
            rows.extend(row(alg, &declared.name, rate, zero));
        }
    }
    rows
}

/// V_P - d/dt(expression) = 0 for every expression of a closing point's position.
fn closures(
    alg: &mut Algebra,
    model: &Model,
    k: &Kinematics,
    point: PointId,
    found: &mut Configuration,
) -> Vec<VectorEquation> {
    let declared = &model.points[point];
    let velocity = k.velocities[point].clone();
    let home = velocity.partials.values().flat_map(|v| v.terms.keys()).next().copied();
    let home = home.unwrap_or(TriadId::INERTIAL);
    let reference = k.flat_positions[&point].clone();
    let mut equations = Vec::new();
    for (nth, expression) in std::iter::once(&declared.position).chain(&declared.closures).enumerate() {
        let place = lower::vector(alg, k, expression);
        if nth > 0 {
            let flat = lifted::flatten(alg, k, &place);
            let residual = reference.minus(&mut alg.dag, &flat);
            let name = format!("{} closure {}", declared.name, nth + 1);
            found.add_residuals(alg, &residual, &Place { name, span: expression.span });
        }
        // Vectors that are constant in the body's triad turn with the body. Newton's residual must take them there too,
        // or the iteration would not converge quadratically.
        let leg = orientation::aligned(alg, &place, home);
        let place = alg.with_constants(&place, leg);
        let place = alg.with_constants(&place, home);
        let flat = lifted::flatten(alg, k, &place);
        let flat = in_frame(alg, &flat, leg, home);
        let flat = orientation::flattened(alg, &flat, home);
        let residual = reference.minus(&mut alg.dag, &flat);
        let residual = rigid(alg, model, k, residual);
        let rate = rate::derivative(alg, k, &place);
        let mut motion = velocity.clone();
        let minus_one = {
            let one = alg.dag.one();
            alg.dag.negate(one)
        };
        motion.add(&mut alg.dag, minus_one, &rate);
        let triads = BTreeSet::from([TriadId::INERTIAL, home, leg]);
        let name = format!("{} closure {}", declared.name, nth + 1);
        equations.push(VectorEquation { name, motion, residual, fixed: None, triads });
    }
    equations
}

/// d/dt(vector) - w x vector = 0 for every vector stated to be fixed in a frame.
fn turning(
    alg: &mut Algebra,
    model: &Model,
    k: &Kinematics,
    frame: FrameId,
    found: &mut Configuration,
) -> Vec<VectorEquation> {
    let triad = k.frame_triad[frame];
    let orthonormal = orientation::orthonormal(alg, triad);
    let mut equations = Vec::new();
    for (nth, fixed) in model.frames[frame].fixed_vectors.iter().enumerate() {
        let vector = lower::vector(alg, k, &fixed.vector);
        let components: [ExprId; 3] = std::array::from_fn(|j| lower::scalar(alg, k, &fixed.components[j]));
        let here = Vector::new(&alg.dag, triad, components);
        let along = orientation::aligned(alg, &vector, triad);
        let turning = alg.with_constants(&vector, along);
        let turning = if along == triad { here.clone() } else { turning };
        let mut motion = rate::derivative(alg, k, &vector);
        let turned = rate::derivative(alg, k, &turning);
        let minus_one = {
            let one = alg.dag.one();
            alg.dag.negate(one)
        };
        motion.add(&mut alg.dag, minus_one, &turned);
        let flat = lifted::flatten(alg, k, &vector);
        let residual = match orthonormal {
            Some((parent, rows)) => {
                let stated = std::array::from_fn(|i| {
                    let column: [ExprId; 3] = std::array::from_fn(|j| rows[j][i]);
                    dot_components(&mut alg.dag, &components, &column)
                });
                let stated = Vector::new(&alg.dag, parent, stated);
                flat.minus(&mut alg.dag, &stated)
            }
            None => flat.minus(&mut alg.dag, &here),
        };
        let triads = BTreeSet::from([TriadId::INERTIAL, triad, along]);
        let name = format!("{} fixed vector {}", model.frames[frame].name, nth + 1);
        let difference = alg.express(&residual, TriadId::INERTIAL);
        found.fixed_vectors.push((Place { name: name.clone(), span: fixed.span }, difference));
        equations.push(VectorEquation { name, motion, residual, fixed: Some(vector), triads });
    }
    equations
}

/// The vector with its part in `triad`, which is fixed in `frame`, expressed in the axes of `frame`.
fn in_frame(alg: &mut Algebra, vector: &Vector, triad: TriadId, frame: TriadId) -> Vector {
    let mut rest = vector.clone();
    let Some(part) = rest.terms.remove(&triad) else { return rest };
    let part = Vector::new(&alg.dag, triad, part);
    let part = alg.express(&part, frame);
    let part = Vector::new(&alg.dag, frame, part);
    rest.plus(&mut alg.dag, &part)
}

/// The vector with its parts in lifted frames taken as rigidly attached, as their rates assume: the residual for
/// Newton.
fn rigid(alg: &mut Algebra, model: &Model, k: &Kinematics, vector: Vector) -> Vector {
    let lifted = model.frames.ids().filter(|&f| lifted::frame_is_lifted(model, f));
    let triads: Vec<TriadId> = lifted.map(|f| k.frame_triad[f]).collect();
    triads.into_iter().fold(vector, |vector, triad| orientation::flattened(alg, &vector, triad))
}

fn triads_of(motion: &Motion) -> BTreeSet<TriadId> {
    let mut triads: BTreeSet<_> = motion.partials.values().flat_map(|v| v.terms.keys().copied()).collect();
    triads.insert(TriadId::INERTIAL);
    triads
}

impl Configuration {
    /// Adds the inertial components of a residual that are not identically zero.
    fn add_residuals(&mut self, alg: &mut Algebra, residual: &Vector, place: &Place) {
        let components = alg.express(residual, TriadId::INERTIAL).into_iter();
        self.residuals.extend(components.filter(|&e| !alg.dag.is_zero(e)).map(|e| (e, place.clone())));
    }
}

/// Projects an equation on the axes a of its triads and on a x (fixed vector).
fn project(alg: &mut Algebra, equation: VectorEquation) -> Vec<Row> {
    let mut rows = Vec::new();
    let mut fixed = equation.fixed.as_ref().map(Resolved::new);
    for &triad in &equation.triads {
        for axis in AXES {
            let along = |turning| Direction { triad, axis, turning };
            let axis = Vector::axis(&mut alg.dag, triad, axis);
            let mut a = Resolved::new(&axis);
            rows.extend(projection(alg, (&equation, along(false)), |alg, triad| a.within(alg, triad)));
            if let Some(fixed) = &mut fixed {
                let mut formed: BTreeMap<TriadId, Components> = BTreeMap::new();
                let mut product = |alg: &mut Algebra, triad| {
                    let (here, times) = (a.within(alg, triad), fixed.within(alg, triad));
                    cross_components(&mut alg.dag, &here, &times)
                };
                let direction =
                    |alg: &mut Algebra, triad| *formed.entry(triad).or_insert_with(|| product(alg, triad));
                rows.extend(projection(alg, (&equation, along(true)), direction));
            }
        }
    }
    rows
}

/// A vector with its components in the triads asked for so far.
struct Resolved<'v> {
    vector: &'v Vector,
    components: BTreeMap<TriadId, Components>,
}

impl<'v> Resolved<'v> {
    fn new(vector: &'v Vector) -> Self {
        Self { vector, components: BTreeMap::new() }
    }

    fn within(&mut self, alg: &mut Algebra, triad: TriadId) -> Components {
        let express = || alg.express(self.vector, triad);
        *self.components.entry(triad).or_insert_with(express)
    }
}

/// The projection of the equation on a direction, which `direction` gives in any triad.
fn projection(
    alg: &mut Algebra,
    (equation, along): (&VectorEquation, Direction),
    mut direction: impl FnMut(&mut Algebra, TriadId) -> Components,
) -> Option<Row> {
    let mut dot = |alg: &mut Algebra, vector: &Vector| {
        let mut total = alg.dag.zero();
        for (&triad, components) in &vector.terms {
            let here = direction(alg, triad);
            let term = dot_components(&mut alg.dag, &here, components);
            total = alg.dag.add(total, term);
        }
        total
    };
    let mut coefficients = LinearForm::default();
    for (&unknown, vector) in &equation.motion.partials {
        let coefficient = dot(alg, vector);
        if !alg.dag.is_zero(coefficient) {
            coefficients.insert(unknown, coefficient);
        }
    }
    if coefficients.is_empty() {
        return None;
    }
    let bias = dot(alg, &equation.motion.bias);
    let residual = dot(alg, &equation.residual);
    let cost = cost(alg, &coefficients);
    Some(Row { name: equation.name.clone(), along: Some(along), coefficients, bias, residual, cost })
}

fn cost(alg: &Algebra, coefficients: &LinearForm) -> usize {
    /// Each unknown in a row costs a product and a sum per right-hand side in the elimination.
    const PER_UNKNOWN: usize = 3;
    let roots: Vec<_> = coefficients.values().copied().collect();
    alg.dag.cone_cost(&roots) + PER_UNKNOWN * coefficients.len()
}

fn row(alg: &Algebra, name: &str, rate: Rate, residual: ExprId) -> Option<Row> {
    let coefficients: LinearForm = rate.partials.into_iter().filter(|(_, c)| !alg.dag.is_zero(*c)).collect();
    let cost = cost(alg, &coefficients);
    let row = Row { name: name.to_owned(), along: None, coefficients, bias: rate.bias, residual, cost };
    (!row.coefficients.is_empty()).then_some(row)
}

/// A motion constraint e(q, u, t) = 0, linear in the speeds: e = sum_k c_k y_k.
fn motion_row(alg: &mut Algebra, k: &Kinematics, name: &str, e: ExprId) -> Option<Row> {
    let partials = rate::coefficients(alg, k, [e]).into_iter().map(|(unknown, [c])| (unknown, c)).collect();
    let rate = Rate { partials, bias: rate::configuration_rate(alg, k, e) };
    let zero = alg.dag.zero();
    row(alg, name, rate, zero)
}
