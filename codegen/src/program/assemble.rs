//! Builds a program from the results of the stages: solved constraints, dynamics, answers.

use super::answer::Answered;
use super::derived::{Origin, Program, Quantity, Rates};
use super::{reciprocal, start};
use crate::diagnostic::Diagnostics;
use crate::dynamics::{self, Dynamics};
use crate::expr::tape::SampleTable;
use crate::expr::{Binary, Dag, ExprId, Node, Unary};
use crate::id::Id;
use crate::kinematics::eliminate::{self, Pivot, Solution};
use crate::kinematics::{self, Algebra, Assembly, Kinematics, projection, redundant};
use crate::model::{CoordinateId, Model, Speed, SpeedId, SpeedMeaning};

/// The solution of the constraints, with the algebra, kinematics and samples to which it refers.
pub(super) type Solved = (Algebra, Kinematics, SampleTable, Solution);

/// Solves the constraints for the dependent unknowns. If the motion passes dead points of the independent speeds, and
/// every motion there moves some mass, all speeds become state instead.
pub(super) fn constraints(
    mut alg: Algebra,
    model: &Model,
    k: Kinematics,
    mut table: SampleTable,
) -> Result<Solved, Diagnostics> {
    let minimal = eliminate::solve(&mut alg, model, &k, &mut table);
    if let Some((mut wider, all, solution, mut samples)) =
        redundant::solve(&alg, model, &k, &mut table, minimal.as_ref().ok())
    {
        let moved =
            model.bodies.is_empty() || dynamics::is_inert(&mut wider, model, &all, &solution, &mut samples);
        if moved || minimal.is_err() {
            return Ok((wider, all, samples, solution));
        }
    }
    let mut solution = minimal?;
    projection::correct(&mut alg, model, &k, &mut table, &mut solution);
    Ok((alg, k, table, solution))
}

pub(super) fn assemble(
    model: &Model,
    (mut alg, k): (Algebra, Kinematics),
    (solution, table): (&Solution, &mut SampleTable),
    dynamics: Dynamics,
    (assembly, answered, origin): (Assembly, Answered, Origin),
) -> Program {
    let state: Vec<CoordinateId> =
        model.coordinates.ids().filter(|&c| k.coordinate_symbol(&alg.dag, c).is_some()).collect();
    let speeds: Vec<(String, ExprId)> = model
        .speeds
        .enumerate()
        .map(|(id, speed)| (speed.name.clone(), k.unknowns[k.unknowns.of(id)].value))
        .collect();
    let q_dot: Vec<ExprId> = state.iter().map(|&c| k.rates[c].value(&mut alg, &k)).collect();
    let outputs: Vec<ExprId> =
        model.outputs.iter().map(|o| kinematics::lower_scalar(&mut alg, &k, &o.value)).collect();
    // Replaces the symbols of dependent unknowns by their values in the independent speeds.
    let speed_values: Vec<ExprId> = speeds.iter().map(|(_, e)| *e).collect();
    let q_dot = alg.dag.substitute(&q_dot, &dynamics.values);
    let outputs = alg.dag.substitute(&outputs, &dynamics.values);
    let speed_values = alg.dag.substitute(&speed_values, &dynamics.values);
    let pivots: Vec<Pivot> = solution.pivots.iter().chain(&dynamics.pivots).copied().collect();
    let worst_pivot = worst_pivot(&mut alg.dag, &pivots);
    let needless = needless_motions(&mut alg, model, &k, (solution, table), assembly.size());
    let watched = [&k.residuals[..], &k.implied, &needless].concat();
    let residual = largest(&mut alg.dag, &watched);
    let correction = correction(&mut alg, &k, table, &state, solution);
    let [q, u, inputs, parameters] = quantities(&alg, model, &k, &state);
    let closed_forms = k.closed_form_values(&mut alg.dag);
    let u_dot = given_accelerations(&alg, model, &k, &answered.u_dot);
    let mut program = Program {
        name: model.name.clone(),
        doc: model.doc.clone(),
        path: model.source.files.first().map_or(String::new(), |f| f.path.clone()),
        origin,
        time: alg.dag.as_symbol(k.time).expect("time is a symbol"),
        q,
        u,
        inputs,
        parameters,
        rates: Rates { q_dot, u_dot: dynamics.u_dot, worst_pivot },
        energy: [dynamics.kinetic, dynamics.potential],
        drive: dynamics.drive,
        speeds: speeds.into_iter().map(|(name, _)| name).zip(speed_values).collect(),
        outputs: model.outputs.iter().map(|o| o.name.clone()).zip(outputs).collect(),
        output_facts: model.outputs.iter().map(|o| [o.unit.clone(), model.source.place(o.span)]).collect(),
        correction,
        speed_correction: dynamics.speed_correction,
        residual,
        has_implied: !k.implied.is_empty() || !needless.is_empty(),
        augmented: dynamics.augmented,
        u_dot,
        answers: answered.answers,
        functions: answered.functions,
        pivots,
        n_samples: k.samples.len(),
        assembly,
        nominal: k.samples[0].clone(),
        is_independent: state_speeds(model, &k).map(|(_, speed)| speed.independent).collect(),
        stated_start: start::stated(model),
        warnings: Diagnostics::default(),
        dag: alg.dag,
    };
    program.substitute(&closed_forms);
    reciprocal::share(&mut program);
    program
}

/// The minimum over the pivots of |pivot| / nominal; pivots with the same nominal value share the scaling.
///
/// A sine or cosine is omitted if its square is a pivot of the same nominal value, because the square is never larger.
fn worst_pivot(dag: &mut Dag, pivots: &[Pivot]) -> ExprId {
    let smaller_square = |pivot: &Pivot| {
        let square = Node::Binary(Binary::Mul, pivot.value, pivot.value);
        matches!(dag.node(pivot.value), Node::Unary(Unary::Sin | Unary::Cos, _))
            && pivots.iter().any(|p| p.nominal == pivot.nominal && dag.node(p.value) == square)
    };
    let weakest: Vec<Pivot> = pivots.iter().filter(|pivot| !smaller_square(pivot)).copied().collect();
    let mut groups: Vec<(f64, ExprId)> = Vec::new();
    for pivot in &weakest {
        let size = dag.unary(Unary::Abs, pivot.value);
        match groups.iter_mut().find(|(nominal, _)| *nominal == pivot.nominal) {
            Some((_, smallest)) => *smallest = dag.binary(Binary::Min, *smallest, size),
            None => groups.push((pivot.nominal, size)),
        }
    }
    let mut worst = dag.one();
    for (nominal, smallest) in groups {
        let scale = dag.constant(1.0 / nominal);
        let relative = dag.mul(scale, smallest);
        worst = if dag.is_one(worst) { relative } else { dag.binary(Binary::Min, worst, relative) };
    }
    worst
}

/// What is left of the rows that were not solved, for each independent speed, where a motion constraint follows from
/// the others: 0 as long as it does. Relative to the row's terms, times `size`, so that it can stand among residuals.
fn needless_motions(
    alg: &mut Algebra,
    model: &Model,
    k: &Kinematics,
    (solution, table): (&Solution, &mut SampleTable),
    size: f64,
) -> Vec<ExprId> {
    if k.implied_motions.is_empty() || !solution.ties.is_empty() {
        return Vec::new();
    }
    let n = solution.partials.values().next().map_or(0, Vec::len);
    let mut left = Vec::new();
    for row in solution.not_solved(model, k) {
        let column = |alg: &mut Algebra, j: usize| -> Vec<ExprId> {
            let terms = row.coefficients.iter().map(|(unknown, &c)| (c, solution.partials[unknown][j]));
            terms.map(|(c, partial)| alg.dag.mul(c, partial)).collect()
        };
        let columns: Vec<Vec<ExprId>> = (0..n).map(|j| column(alg, j)).collect();
        let nominal = |&e: &ExprId| table.values(&alg.dag, e)[0].abs();
        let terms = columns.iter().flatten().map(nominal).fold(0.0, f64::max);
        let scale = alg.dag.constant(if terms > 0.0 { size / terms } else { size });
        for terms in columns {
            let sum = alg.dag.sum(&terms);
            left.push(alg.dag.mul(scale, sum));
        }
    }
    left.retain(|&e| !alg.dag.is_zero(e));
    left
}

fn largest(dag: &mut Dag, residuals: &[ExprId]) -> ExprId {
    let zero = dag.zero();
    residuals.iter().fold(zero, |largest, &r| {
        let size = dag.unary(Unary::Abs, r);
        if dag.is_zero(largest) { size } else { dag.binary(Binary::Max, largest, size) }
    })
}

/// Corrections of the coordinates: those of the unknowns (0 for independent speeds), mapped by q_dot = N u.
///
/// Coordinates that share a dependent speed move together, as Euler parameters do along their own direction.
fn correction(
    alg: &mut Algebra,
    k: &Kinematics,
    table: &mut SampleTable,
    state: &[CoordinateId],
    solution: &Solution,
) -> Vec<(usize, ExprId)> {
    let mut corrections = Vec::new();
    if !solution.ties.is_empty() {
        corrections = redundant::correction(alg, k, table, state).into_iter().enumerate().collect();
        corrections.retain(|(_, e)| !alg.dag.is_zero(*e));
        return corrections;
    }
    for (index, &c) in state.iter().enumerate() {
        let rate = k.rates[c].partials.clone();
        let terms: Vec<ExprId> =
            rate.into_iter().map(|(unknown, n)| alg.dag.mul(n, solution.correction[&unknown])).collect();
        corrections.push((index, alg.dag.sum(&terms)));
    }
    corrections.retain(|(_, e)| !alg.dag.is_zero(*e));
    corrections
}

/// The speeds that are state.
fn state_speeds<'m>(model: &'m Model, k: &'m Kinematics) -> impl Iterator<Item = (SpeedId, &'m Speed)> {
    model.speeds.enumerate().filter(|(id, _)| k.unknowns.is_independent(*id))
}

/// The range of a quantity for which none is stated.
const ANY: (f64, f64) = (f64::NEG_INFINITY, f64::INFINITY);

/// Given derivatives of the independent speeds, in their order.
fn given_accelerations(alg: &Algebra, model: &Model, k: &Kinematics, symbols: &[ExprId]) -> Vec<Quantity> {
    let speeds = state_speeds(model, k).map(|(_, speed)| speed).zip(symbols);
    let quantity = |(speed, &expr): (&Speed, &ExprId)| {
        let symbol = alg.dag.as_symbol(expr)?;
        Some(Quantity {
            name: alg.dag.symbol_name(symbol).to_owned(),
            symbol,
            unit: format!("{}/s", speed.unit),
            doc: "derivative of the speed".to_owned(),
            value: 0.0,
            range: ANY,
            place: model.source.place(speed.span),
            is_angle: false,
        })
    };
    speeds.filter_map(quantity).collect()
}

fn quantities(alg: &Algebra, model: &Model, k: &Kinematics, state: &[CoordinateId]) -> [Vec<Quantity>; 4] {
    let quantity = |name: &str, expr: ExprId, unit: &str, doc: &str, value: f64, span| {
        alg.dag.as_symbol(expr).map(|symbol| Quantity {
            name: name.to_owned(),
            symbol,
            unit: unit.to_owned(),
            doc: doc.to_owned(),
            value,
            range: ANY,
            place: model.source.place(span),
            is_angle: false,
        })
    };
    let q = state
        .iter()
        .zip(&k.samples[0])
        .filter_map(|(&c, &nominal)| {
            let declared = &model.coordinates[c];
            let found =
                quantity(&declared.name, k.q[c], &declared.unit, &declared.doc, nominal, declared.span)?;
            let range = if declared.states_range() { declared.range } else { ANY };
            Some(Quantity { range, ..found })
        })
        .collect();
    let u = state_speeds(model, k)
        .filter_map(|(id, s)| {
            let doc = match s.meaning {
                SpeedMeaning::RateOf(c) => format!("rate of {}", model.coordinates[c].name),
                SpeedMeaning::Combination(_) => "speed".to_owned(),
            };
            quantity(&s.name, k.unknowns[k.unknowns.of(id)].value, &s.unit, &doc, 0.0, s.span)
        })
        .collect();
    let inputs = model
        .inputs
        .enumerate()
        .filter_map(|(id, i)| quantity(&i.name, k.inputs[id], &i.unit, &i.doc, 0.0, i.span))
        .collect();
    let parameters = model
        .parameters
        .enumerate()
        .filter_map(|(id, p)| {
            let found = quantity(&p.name, k.parameters[id], &p.unit, &p.doc, k.parameter_values[id], p.span)?;
            Some(Quantity { range: p.range, ..found })
        })
        .collect();
    [q, u, inputs, parameters]
}

/// Marks coordinates that may be wrapped by whole turns: those used only in sines and cosines, directly or in sums and
/// differences that are themselves used only there.
pub(super) fn mark_angles(program: &mut Program) {
    let roots = program.all_roots();
    let dag = &program.dag;
    let mut periodic = vec![true; dag.len()];
    for &root in &roots {
        periodic[root.index()] = false;
    }
    for &id in dag.reachable(&roots).iter().rev() {
        let reads_turns = match dag.node(id) {
            Node::Unary(Unary::Sin | Unary::Cos, _) => true,
            Node::Negate(_) | Node::Binary(Binary::Add | Binary::Sub, ..) => periodic[id.index()],
            _ => false,
        };
        if !reads_turns {
            dag.operands(id).into_iter().flatten().for_each(|a| periodic[a.index()] = false);
        }
    }
    let coordinates = program.q.iter_mut().filter(|q| q.unit == "rad");
    for quantity in coordinates {
        let node = dag.find(Node::Symbol(quantity.symbol));
        quantity.is_angle = node.is_none_or(|id| periodic[id.index()]);
    }
}
