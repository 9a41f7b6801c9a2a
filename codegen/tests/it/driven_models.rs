//! Every shipped mechanism with one of its coordinates prescribed, in three ways: as a function of time, by a
//! configuration constraint, by a motion constraint.
//!
//! Oracle: the augmented form of the shipped mechanism without the drive, with one more row that prescribes the
//! coordinate's acceleration; its multiplier is the drive's force. Solved by dense elimination.

use crate::augmented;
use crate::draw::Draw;
use crate::models::shipped;
use smartbed_codegen::expr::SymbolId;
use smartbed_codegen::id::Id;
use smartbed_codegen::kinematics::linear;
use smartbed_codegen::model::expression::{Expr, ExprKind, Function};
use smartbed_codegen::model::unit::Unit;
use smartbed_codegen::model::{Constraint, CoordinateId, Entity, Model, SpeedId, SpeedMeaning};
use smartbed_codegen::source::Span;
use smartbed_codegen::{Interpreted, ParameterChoice, Program, Settings, program};
use smartbed_runtime::mechanism::Mechanism;
use std::collections::HashMap;

/// Rounding of the dense solve, relative to the largest acceleration of the state.
const ROUNDING: f64 = 1e-9;
const STATES: usize = 40;
/// The coordinate is nominal + SWING sin(TURN t + 1).
const SWING: f64 = 0.03;
const TURN: f64 = 7.0;

#[derive(Clone, Copy, Debug)]
enum Way {
    Function,
    Configuration,
    Motion,
}

fn node(kind: ExprKind) -> Expr {
    Expr { kind, span: Span::default(), unit: Unit::NONE }
}

fn of_phase(size: f64, function: Function) -> Expr {
    let turn = ExprKind::Multiply(Box::new(node(ExprKind::Number(TURN))), Box::new(node(ExprKind::Time)));
    let phase = ExprKind::Add(Box::new(node(turn)), Box::new(node(ExprKind::Number(1.0))));
    let wave = node(ExprKind::Call(function, vec![node(phase)]));
    node(ExprKind::Multiply(Box::new(node(ExprKind::Number(size))), Box::new(wave)))
}

/// Place, rate and acceleration of the prescribed coordinate.
fn prescribed(nominal: f64, t: f64) -> [f64; 3] {
    let (sin, cos) = (TURN * t + 1.0).sin_cos();
    [nominal + SWING * sin, SWING * TURN * cos, -SWING * TURN * TURN * sin]
}

/// The model with a coordinate of an independent speed prescribed; none if it has no such coordinate at that place.
fn driven(model: &Model, way: Way, speed: SpeedId) -> Option<(Model, CoordinateId)> {
    let declared = &model.speeds[speed];
    let SpeedMeaning::RateOf(coordinate) = declared.meaning else { return None };
    // A closed form of a coordinate that a constraint gives is refused on the text.
    let is_read =
        matches!(way, Way::Configuration) && model.coordinates.iter().any(|c| c.closed_form.is_some());
    if !declared.independent || is_read {
        return None;
    }
    let mut model = model.clone();
    model.dof = None;
    model.speeds[speed].independent = false;
    let nominal = model.coordinates[coordinate].nominal;
    let place =
        ExprKind::Add(Box::new(node(ExprKind::Number(nominal))), Box::new(of_phase(SWING, Function::Sin)));
    let equation = |quantity: ExprKind, value: Expr| {
        let expression = node(ExprKind::Subtract(Box::new(node(quantity)), Box::new(value)));
        Constraint { name: "drive".to_owned(), expression, unit: Unit::NONE, span: Span::default() }
    };
    match way {
        Way::Function => {
            model.coordinates[coordinate].closed_form = Some(node(place));
            model.coordinates[coordinate].independent = false;
            model.order.insert(0, Entity::Coordinate(coordinate));
        }
        Way::Configuration => {
            model.coordinates[coordinate].independent = false;
            // The nominal configuration is that of time 0.
            model.coordinates[coordinate].nominal = prescribed(nominal, 0.0)[0];
            model.configuration_constraints.push(equation(ExprKind::Coordinate(coordinate), node(place)));
        }
        Way::Motion => {
            let rate = of_phase(SWING * TURN, Function::Cos);
            model.motion_constraints.push(equation(ExprKind::Speed(speed), rate));
        }
    }
    Some((model, coordinate))
}

/// Accelerations of all unknowns of the free mechanism at a state, one of them prescribed, and the force that this
/// takes.
fn oracle(
    free: &Program,
    q: &[f64],
    u: &[f64],
    speed: &str,
    acceleration: f64,
) -> (HashMap<String, f64>, f64) {
    let zeros = vec![0.0; free.inputs.len()];
    let parameters: Vec<f64> = free.parameters.iter().map(|p| p.value).collect();
    let mut values: HashMap<SymbolId, f64> = HashMap::from([(free.time, 0.0)]);
    for (names, numbers) in
        [(&free.q, q), (&free.u, u), (&free.inputs, &zeros[..]), (&free.parameters, &parameters[..])]
    {
        values.extend(names.iter().zip(numbers).map(|(name, &x)| (name.symbol, x)));
    }
    let numbers = free.dag.evaluate::<f64>(&free.augmented_roots(), &|s| values[&s]);
    let (n, m) = (free.augmented.unknowns.len(), free.augmented.bias.len());
    let (mass, rest) = numbers.split_at(n * n);
    let (jacobian, rest) = rest.split_at(m * n);
    let (forcing, bias) = rest.split_at(n);
    let size = n + m + 1;
    let mut matrix = vec![0.0; size * size];
    for i in 0..n {
        matrix[i * size..][..n].copy_from_slice(&mass[i * n..][..n]);
        for r in 0..m {
            matrix[i * size + n + r] = -jacobian[r * n + i];
            matrix[(n + r) * size + i] = jacobian[r * n + i];
        }
    }
    let driven = free.augmented.unknowns.iter().position(|x| x == speed).expect("a speed");
    matrix[driven * size + n + m] = -1.0;
    matrix[(n + m) * size + driven] = 1.0;
    let mut right: Vec<f64> = forcing.iter().copied().chain(bias.iter().map(|b| -b)).collect();
    right.push(acceleration);
    let (solution, rank) = linear::solve(&matrix, &mut right, size);
    assert_eq!(rank, size, "{}", free.name);
    (free.augmented.unknowns.iter().cloned().zip(solution[..n].iter().copied()).collect(), solution[n + m])
}

/// The coordinates of `program` among those of `all`.
fn picked(program: &Program, all: &Program, q: &[f64]) -> Vec<f64> {
    let place = |name: &str| all.q.iter().position(|c| c.name == name).expect("a coordinate");
    program.q.iter().map(|c| q[place(&c.name)]).collect()
}

/// Compares at random states; returns how many were compared.
fn check(name: &str, way: Way, index: usize) -> usize {
    let model = shipped(name);
    let speed = SpeedId::from_index(index);
    let Some((with_drive, coordinate)) = driven(&model, way, speed) else { return 0 };
    let free = augmented::with_augmented(&model, Settings::default());
    let program = program::derive(&with_drive, &ParameterChoice::default())
        .unwrap_or_else(|e| panic!("{name} {way:?} {index}: {e}"));
    let (coordinate, speed) = (&model.coordinates[coordinate], &model.speeds[speed].name);
    let at = free.q.iter().position(|q| q.name == coordinate.name).expect("state");
    let u_at = free.u.iter().position(|u| u.name == *speed).expect("an independent speed");
    let mut engine = Interpreted::<f64>::new(&program);
    let mut random = Draw(7);
    let (mut assembly, mut compared) = (free.assembly.clone(), 0);
    for _ in 0..STATES {
        let t = 1.0 + random.next();
        let [place, rate, acceleration] = prescribed(coordinate.nominal, t);
        let mut target: Vec<f64> = free.nominal.iter().map(|q| q + SWING * random.next()).collect();
        target[at] = place;
        let Ok(q) = assembly.continue_to(&free.nominal, &target) else { continue };
        let mut u: Vec<f64> = free.u.iter().map(|_| random.next()).collect();
        u[u_at] = rate;
        let (expected, force) = oracle(&free, &q, &u, speed, acceleration);
        let scale = expected.values().fold(1.0_f64, |m, x| m.max(x.abs()));
        let (own_q, mut own_u) = (picked(&program, &free, &q), u.clone());
        own_u.remove(u_at);
        let (mut q_dot, mut u_dot) = (vec![0.0; own_q.len()], vec![0.0; own_u.len()]);
        let inputs = vec![0.0; program.inputs.len()];
        engine.rates(t, &own_q, &own_u, &inputs, &mut q_dot, &mut u_dot).expect("lengths fit");
        for (name_of, found) in program.u.iter().zip(&u_dot) {
            let off = (found - expected[&name_of.name]).abs() / scale;
            assert!(off <= ROUNDING, "{name} {way:?} {speed} -> {}': {off:e}", name_of.name);
        }
        let power = engine.drive(t, &own_q, &own_u, &inputs).expect("lengths fit");
        let (needed, scale) = (force * rate, scale.max((force * rate).abs()));
        assert!((power - needed).abs() <= ROUNDING * scale, "{name} {way:?} {speed}: {power} {needed}");
        compared += 1;
    }
    compared
}

/// Each of a model's independent speeds that is the rate of a coordinate, each way.
fn check_all(name: &str) {
    let speeds = shipped(name).speeds.len();
    let mut compared = 0;
    for way in [Way::Function, Way::Configuration, Way::Motion] {
        compared += (0..speeds).map(|index| check(name, way, index)).sum::<usize>();
    }
    assert!(STATES < compared, "{name}: only {compared} states");
}

#[test]
fn chains_with_a_driven_joint() {
    ["pendulum3", "double_pendulum", "cart_pole"].iter().for_each(|name| check_all(name));
}

#[test]
fn a_spatial_arm_with_a_driven_joint() {
    check_all("arm6");
}

#[test]
fn closed_loops_with_a_driven_coordinate() {
    ["fourbar", "slider_crank", "slider_crank_closed"].iter().for_each(|name| check_all(name));
}

#[test]
fn a_tile_with_a_driven_screw() {
    ["tile", "tile_minimal", "tile_drive"].iter().for_each(|name| check_all(name));
}

#[test]
fn rolling_bodies_with_a_driven_coordinate() {
    ["sleigh", "bicycle"].iter().for_each(|name| check_all(name));
}
