//! What was derived from a drawn model's text against the oracle, at random states.

use super::description::{Coordinate, Description};
use super::expression::Scalar;
use super::oracle::{self, Answer, State};
use super::{nominal, text};
use crate::random::Random;
use smartbed_codegen::kinematics::ParameterChoice;
use smartbed_codegen::program::interpreter::Interpreted;
use smartbed_codegen::program::{self, Program};
use smartbed_codegen::{Settings, model};
use smartbed_runtime::mechanism::Mechanism;
use smartbed_runtime::ode::pivot_limit;

/// Largest difference, relative to the terms that a number is made of.
pub const AGREEMENT: f64 = 1e-9;
/// A state is singular where the oracle's smallest pivot is below this share of the largest.
pub const SINGULAR: f64 = 1e-3;
/// States looked at where a model is refused, and the health of one that explains it.
const SEARCH: usize = 2000;
const NEARLY: f64 = 0.02;
/// Moments of inertia that a change of each by itself has made those of no body leave motions of less than this share.
const NO_INERTIA: f64 = 1e-4;
/// Terms of one acceleration below this share of the largest term of all are rounding.
const NOTHING: f64 = 1e-3;
/// A state is reached from nominal in so many steps.
const STEPS: usize = 8;
/// Dependent coordinates are put this far off before they are projected back (rad, m).
const OFF: f64 = 1e-4;

/// What became of a mechanism.
#[derive(Clone, Debug, Default)]
pub struct Verdict {
    /// States that were compared.
    pub compared: usize,
    /// Those of them with all speeds as state.
    pub redundant: usize,
    /// States that the oracle calls singular, or that the mechanism cannot reach.
    pub singular: usize,
    /// Worst pivot at regular states where it refuses to answer.
    pub refused: Vec<f64>,
    /// Worst difference, relative to its terms.
    pub worst: f64,
    /// Where that was.
    pub place: String,
    /// The model was refused as a whole, with this message.
    pub refusal: Option<String>,
}

impl Verdict {
    fn note(&mut self, what: &str, found: f64, expected: f64, terms: f64) {
        let difference = (found - expected).abs() / terms.abs().max(f64::MIN_POSITIVE);
        // NaN is the worst of all.
        let difference = if difference.is_nan() { f64::INFINITY } else { difference };
        if difference > self.worst {
            self.worst = difference;
            self.place = format!("{what}: {found:e}, expected {expected:e}, terms {terms:e}");
        }
    }
}

/// Does the oracle, too, meet a singular state or an end of the motion within the ranges? It looks around the worst
/// state that it has found, ever closer.
#[must_use]
pub fn is_singular_somewhere(d: &Description, random: &mut Random) -> bool {
    let mut best = vec![0.0; d.coordinates.len()];
    let mut worst = f64::INFINITY;
    for n in 0..SEARCH {
        let radius = 2.0 * (-6.0 * n as f64 / SEARCH as f64).exp();
        let near = |(c, at): (&Coordinate, &f64)| {
            (at + radius * random.between(-1.0, 1.0) * c.reach).clamp(-c.reach, c.reach)
        };
        let way: Vec<f64> = d.coordinates.iter().zip(&best).map(near).collect();
        let state = state_at(d, 0, &way, random);
        let health = state.and_then(|state| oracle::solve(d, &state)).map_or(0.0, |answer| answer.health);
        if health < worst {
            (worst, best) = (health, way);
        }
        if worst < NEARLY {
            return true;
        }
    }
    false
}

/// Derives a text.
///
/// # Errors
/// The message, if it is refused.
pub fn derive(text: &str, settings: Settings) -> Result<Program, String> {
    let model = model::parse("trial.toml", text).map_err(|e| e.to_string())?;
    program::derive_with(&model, &ParameterChoice::default(), settings).map_err(|e| e.to_string())
}

/// Derives the description's own text and compares.
#[must_use]
pub fn of(d: &Description, settings: Settings, states: usize, random: &mut Random) -> Verdict {
    of_text(d, &text::model(d), settings, states, random)
}

/// Compares what is derived from `text` with the oracle of `d`.
#[must_use]
pub fn of_text(
    d: &Description,
    text: &str,
    settings: Settings,
    states: usize,
    random: &mut Random,
) -> Verdict {
    let mut verdict = Verdict::default();
    let program = match derive(text, settings) {
        Ok(program) => program,
        Err(message) => return Verdict { refusal: Some(message), ..verdict },
    };
    let mut engine = Interpreted::<f64>::new(&program);
    for n in 0..states {
        let Some(state) = draw_state(d, n, random) else {
            verdict.singular += 1;
            continue;
        };
        match oracle::solve(d, &state).filter(|answer| answer.health >= SINGULAR) {
            Some(answer) => compare(d, &program, &mut engine, &state, &answer, &mut verdict),
            None => verdict.singular += 1,
        }
    }
    verdict
}

/// A state that satisfies the constraints: the first near nominal, later ones with other parameters too.
fn draw_state(d: &Description, n: usize, random: &mut Random) -> Option<State> {
    let way: Vec<f64> = d.coordinates.iter().map(|c| random.between(-1.0, 1.0) * c.reach).collect();
    state_at(d, n, &way, random)
}

/// The state at this way from nominal.
fn state_at(d: &Description, n: usize, way: &[f64], random: &mut Random) -> Option<State> {
    let mut state = nominal::state(d);
    let nominal = state.parameters.clone();
    let mut parameters = nominal.clone();
    if 0 < n {
        // The shape of a loop of too many equations stays: it would be locked.
        let keeps_shape = oracle::is_redundant(d, &state);
        for (value, p) in parameters.iter_mut().zip(&d.parameters) {
            if !(p.fixed || p.shape && keeps_shape) {
                *value *= random.between(0.9, 1.1);
            }
        }
    }
    let t = random.between(0.0, 3.0);
    state.u.iter_mut().for_each(|u| *u = random.between(-2.0, 2.0));
    state.inputs.iter_mut().for_each(|i| *i = random.between(-5.0, 5.0));
    let free: Vec<usize> = d.state().into_iter().filter(|&i| d.coordinates[i].independent).collect();
    for step in 1..=STEPS {
        let part = step as f64 / STEPS as f64;
        state.t = part * t;
        for ((value, from), to) in state.parameters.iter_mut().zip(&nominal).zip(&parameters) {
            *value = if step == STEPS { *to } else { from + part * (to - from) };
        }
        free.iter().for_each(|&i| state.q[i] += way[i] / STEPS as f64);
        if !oracle::assemble(d, &mut state) {
            return None;
        }
    }
    Some(state)
}

/// Every answer of the program at one state.
fn compare(
    d: &Description,
    program: &Program,
    engine: &mut Interpreted<f64>,
    state: &State,
    answer: &Answer,
    verdict: &mut Verdict,
) {
    let number = |name: &str| name[1..].parse::<usize>().expect("a letter and a number");
    let parameters: Vec<f64> = program.parameters.iter().map(|p| state.parameters[number(&p.name)]).collect();
    engine.set_parameters(&parameters);
    let places: Vec<usize> = program.q.iter().map(|q| number(&q.name)).collect();
    let q: Vec<f64> = places.iter().map(|&i| answer.q[i]).collect();
    // Where the motion passes dead points of the independent speeds all of them are state.
    let (u, order, expected, terms) = match program.is_redundant() {
        true => {
            let [rates, terms] = &answer.speeds_dot;
            (&answer.speeds, (0..d.speeds.len()).collect(), rates, terms)
        }
        false => (&state.u, d.independent_speeds(), &answer.u_dot, &answer.u_dot_terms),
    };
    verdict.redundant += usize::from(program.is_redundant());
    assert_eq!(program.u.len(), u.len(), "speeds that are state");
    for (found, &i) in program.u.iter().zip(&order) {
        assert_eq!(found.name, text::speed(d, i), "order of the speeds");
    }
    let (mut q_dot, mut u_dot) = (vec![0.0; q.len()], vec![0.0; u.len()]);
    let pivot = engine.rates(state.t, &q, u, &state.inputs, &mut q_dot, &mut u_dot).expect("lengths fit");
    // Integrators refuse such a step: the program has said that it does not answer.
    if pivot.is_nan() || pivot.abs() < pivot_limit::<f64>() {
        match answer.inertia < NO_INERTIA {
            true => verdict.singular += 1,
            false => verdict.refused.push(pivot),
        }
        return;
    }
    verdict.compared += 1;
    let fastest = answer.q_dot.iter().chain(&answer.speeds).fold(1.0, |m: f64, x| m.max(x.abs()));
    for (&i, found) in places.iter().zip(&q_dot) {
        verdict.note(&format!("rate of q{i}"), *found, answer.q_dot[i], fastest);
    }
    // Near a singularity what rounding does to the constraints moves the motions that they leave by so much more.
    let amplified = if answer.health < NEARLY { 1.0 / answer.health } else { 1.0 };
    let largest = terms.iter().fold(0.0, |m: f64, t| m.max(*t));
    for (i, found) in u_dot.iter().enumerate() {
        // What cancels to nothing in one speed is the rounding of the others.
        let terms = terms[i].max(NOTHING * largest.max(1.0));
        verdict.note(&format!("u_dot {i}"), *found, expected[i], amplified * terms);
    }
    if program.is_redundant() {
        let slip = slip_after_correction(d, engine, state, &q, u);
        verdict.note("slip after the correction of the speeds", slip, 0.0, amplified * fastest);
    }
    let (kinetic, potential) = engine.energy(&q, u).expect("lengths fit");
    verdict.note("kinetic energy", kinetic, answer.energy[0], answer.energy[0]);
    verdict.note("potential energy", potential, answer.energy[1], answer.potential_terms);
    let speeds = engine.speeds(&q, u).expect("lengths fit");
    assert_eq!(speeds.len(), answer.speeds.len(), "speeds");
    for (i, (found, expected)) in speeds.iter().zip(&answer.speeds).enumerate() {
        verdict.note(&format!("speed {i}"), *found, *expected, fastest);
    }
    let outputs = engine.outputs(state.t, &q, u, &state.inputs).expect("lengths fit");
    assert_eq!(outputs.len(), answer.outputs.len(), "outputs");
    for (i, (found, expected)) in outputs.iter().zip(&answer.outputs).enumerate() {
        let terms = fastest.max(expected.abs());
        match d.outputs[i] {
            // A length is the root of a sum, which is what is accurate where it vanishes.
            Scalar::Norm(_) if *found < NOTHING && *expected < NOTHING => {
                verdict.note(&format!("output {i} squared"), found.powi(2), expected.powi(2), terms.powi(2));
            }
            _ => verdict.note(&format!("output {i}"), *found, *expected, terms),
        }
    }
    // What the program says of the constraints, and whether its corrections lead back to them.
    let residual = engine.residual(&q).expect("lengths fit");
    verdict.note("residual on the constraints", residual, 0.0, 1.0);
    // Near a singularity the way back is long: a row of motion that holds a coordinate adds to it.
    if d.motion.is_empty() || answer.health >= NEARLY {
        project(d, engine, state, (&places, program.is_redundant()), q, verdict);
    }
}

/// What speeds that are put off the constraints still leave of them after their correction.
fn slip_after_correction(
    d: &Description,
    engine: &mut Interpreted<f64>,
    state: &State,
    q: &[f64],
    u: &[f64],
) -> f64 {
    let mut u: Vec<f64> = u.iter().enumerate().map(|(i, u)| u + (i as f64 + 1.0).sin()).collect();
    engine.project_speeds(q, &mut u).expect("lengths fit");
    let (mut q_dot, mut u_dot) = (vec![0.0; q.len()], vec![0.0; u.len()]);
    engine.rates(state.t, q, &u, &state.inputs, &mut q_dot, &mut u_dot).expect("lengths fit");
    oracle::largest_slip(d, state, &q_dot)
}

/// Dependent coordinates put off by [`OFF`] come back to the constraints, and the residual says that they were off.
fn project(
    d: &Description,
    engine: &mut Interpreted<f64>,
    state: &State,
    (places, moves_all): (&[usize], bool),
    mut q: Vec<f64>,
    verdict: &mut Verdict,
) {
    let mut off = state.clone();
    for (slot, &i) in places.iter().enumerate() {
        if !d.coordinates[i].independent {
            q[slot] += OFF;
            off.q[i] += OFF;
        }
    }
    if oracle::largest_residual(d, &off) < 0.01 * OFF {
        return;
    }
    let before = engine.project(&mut q).expect("lengths fit");
    let blind = if before < 1e-3 * oracle::largest_residual(d, &off) { 1.0 } else { 0.0 };
    verdict.note("residual off the constraints", blind, 0.0, 1.0);
    for _ in 0..3 {
        engine.project(&mut q).expect("lengths fit");
    }
    for (slot, &i) in places.iter().enumerate() {
        off.q[i] = q[slot];
        // Where the others alone would hardly do, those whose speeds motion constraints give are corrected too.
        let given = d.speeds.iter().any(|speed| speed.of == Some(i) && !speed.independent);
        if d.coordinates[i].independent && !given && !moves_all {
            verdict.note("independent coordinate after projection", q[slot], state.q[i], 1.0);
        }
    }
    verdict.note("residual after projection", oracle::largest_residual(d, &off), 0.0, 1.0);
}
