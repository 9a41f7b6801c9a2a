//! States with known answers, by name: from the stored references, and random ones from the oracle.

use crate::closed_form::{fourbar as fourbar_form, tile as tile_form};
use crate::newton_euler::arm6::Arm;
use crate::newton_euler::bicycle::Bicycle;
use crate::newton_euler::fourbar::Fourbar;
use crate::newton_euler::pendulum::Pendulum;
use crate::newton_euler::system::Motion;
use crate::newton_euler::tile::{Load, Parameters, Tile};
use crate::random::Random;
use crate::reference::data::{self, Reference, Sample};
use crate::subject::{Named, State, named};

/// The mechanisms that have both a stored reference and an oracle.
pub const MECHANISMS: [&str; 4] = ["pendulum3", "fourbar", "tile", "tile_minimal"];

/// A state and what the mechanism answers there.
#[derive(Clone, Debug)]
pub struct Case {
    /// Parameters.
    pub parameters: Named,
    /// The state.
    pub state: State,
    /// Rates of the coordinates, in the state's order.
    pub q_dot: Vec<f64>,
    /// Rates of the independent speeds, in the state's order.
    pub u_dot: Vec<f64>,
    /// Kinetic and potential energy, if known.
    pub energy: Option<[f64; 2]>,
}

/// The stored states of a mechanism.
#[must_use]
pub fn reference_cases(model: &str) -> Vec<Case> {
    if model == "tile_minimal" {
        return minimal_cases();
    }
    let reference = data::samples(model);
    let case = |s: &Sample| Case {
        parameters: named(&reference.parameter_names, &s.parameters),
        state: state_of(&reference, s),
        q_dot: s.q_dot.clone(),
        u_dot: s.u_dot.clone(),
        energy: None,
    };
    reference.samples.iter().map(case).collect()
}

/// A sample's state by name.
fn state_of(reference: &Reference, s: &Sample) -> State {
    State {
        q: named(&reference.q_names, &s.q),
        u: named(&reference.independent, &s.u),
        inputs: named(&reference.input_names, &s.inputs),
    }
}

/// Heights, their rates and thrusts by name.
#[must_use]
pub fn heights_state(h: [f64; 3], h_dot: [f64; 3], thrust: [f64; 3]) -> State {
    State {
        q: named(&["hA", "hB", "hC"], &h),
        u: named(&["u_hA", "u_hB", "u_hC"], &h_dot),
        inputs: named(&["FA", "FB", "FC"], &thrust),
    }
}

/// The same posture for the tile's twelve coordinates.
#[must_use]
pub fn tile_state(r: f64, h: [f64; 3], h_dot: [f64; 3], thrust: [f64; 3]) -> State {
    let q = tile_form::posture(r, h).coordinates(r, h);
    State { q: named(&tile_coordinates(), &q), ..heights_state(h, h_dot, thrust) }
}

/// hA psiA thA sA hB ...
#[must_use]
pub fn tile_coordinates() -> Vec<String> {
    ["A", "B", "C"].iter().flat_map(|leg| ["h", "psi", "th", "s"].map(|of| format!("{of}{leg}"))).collect()
}

fn minimal_cases() -> Vec<Case> {
    let minimal = data::minimal();
    let case = |s: &data::MinimalState| Case {
        parameters: minimal.parameters.clone(),
        state: heights_state(s.h, s.h_dot, s.thrust),
        q_dot: s.h_dot.to_vec(),
        u_dot: s.u_dot.to_vec(),
        energy: Some([s.kinetic, s.potential]),
    };
    minimal.states.iter().map(case).collect()
}

/// Random states with the Newton-Euler oracle's answers. Parameters are the references', each
/// scaled by up to 20 % where the mechanism allows.
///
/// # Panics
/// If no oracle is known for the model.
#[must_use]
pub fn random_cases(model: &str, count: usize, seed: u64) -> Vec<Case> {
    let mut random = Random::new(seed);
    (0..count)
        .map(|_| match model {
            "tile" | "tile_minimal" => tile_case(model, &mut random),
            "fourbar" => fourbar_case(&mut random),
            "pendulum3" => pendulum_case(3, &mut random),
            "pendulum10" => pendulum_case(10, &mut random),
            "arm6" => arm_case(&mut random),
            "bicycle" => bicycle_case(&mut random),
            _ => panic!("no oracle for `{model}`"),
        })
        .collect()
}

/// A list of numbers between two bounds.
fn draw(random: &mut Random, count: usize, low: f64, high: f64) -> Vec<f64> {
    (0..count).map(|_| random.between(low, high)).collect()
}

/// Three numbers between two bounds.
fn draw3(random: &mut Random, low: f64, high: f64) -> [f64; 3] {
    [(); 3].map(|()| random.between(low, high))
}

/// A case from the oracle's motion.
fn solved(parameters: Named, state: State, motion: &Motion) -> Case {
    Case {
        parameters,
        state,
        q_dot: motion.q_dot.clone(),
        u_dot: motion.u_dot.clone(),
        energy: Some([motion.kinetic, motion.potential]),
    }
}

/// Values around the reference's, each scaled by up to 20 %.
fn vary(random: &mut Random, values: &[f64]) -> Vec<f64> {
    values.iter().map(|x| x * random.between(0.8, 1.2)).collect()
}

fn tile_case(model: &str, random: &mut Random) -> Case {
    let base: Vec<f64> = data::minimal().parameters.iter().map(|(_, value)| *value).collect();
    let values = vary(random, &base);
    tile_motion(model, random, &values, Load::default(), Vec::new())
}

/// Cases of a tile with payload, support springs, end stops and external load: every extra parameter of the tile
/// models. The case's energy is left out, because end stops have no account in it.
#[must_use]
pub fn loaded_tile_cases(model: &str, count: usize, seed: u64) -> Vec<Case> {
    let mut random = Random::new(seed);
    let base: Vec<f64> = data::minimal().parameters.iter().map(|(_, value)| *value).collect();
    (0..count)
        .map(|_| {
            let load = Load {
                payload: random.between(0.5, 10.0),
                payload_at: draw3(&mut random, -0.1, 0.1),
                support: random.between(100.0, 2000.0),
                support_rest: random.between(-0.1, 0.1),
                force: draw3(&mut random, -20.0, 20.0),
                torque: draw3(&mut random, -2.0, 2.0),
                stop: 1000.0,
                stops_at: [-0.05, 0.05],
            };
            let extra = named(&LOAD_PARAMETERS, &load_values(&load));
            let values = vary(&mut random, &base);
            Case { energy: None, ..tile_motion(model, &mut random, &values, load, extra) }
        })
        .collect()
}

/// Names of the parameters of a [`Load`] in the tile models.
pub const LOAD_PARAMETERS: [&str; 15] = [
    "m_payload",
    "x_payload",
    "y_payload",
    "z_payload",
    "k_support",
    "h_support",
    "Fx",
    "Fy",
    "Fz",
    "Tx",
    "Ty",
    "Tz",
    "k_stop",
    "h_min",
    "h_max",
];

/// Values in the order of [`LOAD_PARAMETERS`].
fn load_values(load: &Load) -> Vec<f64> {
    let mut values = vec![load.payload];
    values.extend(load.payload_at);
    values.extend([load.support, load.support_rest]);
    values.extend(load.force);
    values.extend(load.torque);
    values.push(load.stop);
    values.extend(load.stops_at);
    values
}

fn tile_motion(model: &str, random: &mut Random, values: &[f64], load: Load, extra: Named) -> Case {
    let parameters = Parameters::new(values);
    let (h, h_dot) = tile_form::random_heights(random, parameters.r, 0.0);
    let thrust = draw3(random, -30.0, 80.0);
    let q = tile_form::posture(parameters.r, h).coordinates(parameters.r, h);
    let motion = Tile { parameters, q, h_dot, thrust, load }.solve();
    let names = [named(&data::TILE_PARAMETERS, values), extra].concat();
    if model == "tile" {
        return solved(names, tile_state(parameters.r, h, h_dot, thrust), &motion);
    }
    let case = solved(names, heights_state(h, h_dot, thrust), &motion);
    Case { q_dot: h_dot.to_vec(), ..case }
}

fn fourbar_case(random: &mut Random) -> Case {
    let reference = data::samples("fourbar");
    loop {
        let values = vary(random, &reference.samples[0].parameters);
        let lengths = [values[0], values[1], values[2], values[3]];
        let q1 = random.between(-3.1, 3.1);
        let side = if random.between(-1.0, 1.0) < 0.0 { -1.0 } else { 1.0 };
        let Some([q2, q3]) = fourbar_form::assemble(lengths, q1, side) else { continue };
        // Away from the dead centres, where the crank does not drive the rest.
        if (q3 - q2).sin().abs() < 0.3 {
            continue;
        }
        let state = State {
            q: named(&reference.q_names, &[q1, q2, q3]),
            u: named(&reference.independent, &draw(random, 1, -4.0, 4.0)),
            inputs: named(&reference.input_names, &draw(random, 1, -5.0, 5.0)),
        };
        let motion = Fourbar::new(&values, &[q1, q2, q3], &[state.inputs[0].1]).solve(&[state.u[0].1]);
        return solved(named(&reference.parameter_names, &values), state, &motion);
    }
}

fn pendulum_case(n: usize, random: &mut Random) -> Case {
    let masses = draw(random, n, 0.5, 1.5);
    let lengths = draw(random, n, 0.5, 1.5);
    let g = random.between(1.6, 12.0);
    let q = draw(random, n, -3.0, 3.0);
    let u = draw(random, n, -3.0, 3.0);
    let motion = Pendulum { masses: &masses, lengths: &lengths, g, q: &q }.solve(&u);
    let numbered = |prefix: &str| -> Vec<String> { (0..n).map(|i| format!("{prefix}{i}")).collect() };
    let names = [numbered("m"), numbered("l"), vec!["g".to_owned()]].concat();
    let state = State { q: named(&numbered("q"), &q), u: named(&numbered("u"), &u), inputs: Vec::new() };
    solved(named(&names, &[masses, lengths, vec![g]].concat()), state, &motion)
}

fn arm_case(random: &mut Random) -> Case {
    let reference = data::samples("arm6");
    // General inertias must stay those of real bodies: the reference's, unscaled.
    let parameters = &reference.samples[0].parameters;
    let sample = Sample {
        q: draw(random, 6, -3.0, 3.0),
        u: draw(random, 6, -2.0, 2.0),
        inputs: draw(random, 6, -10.0, 10.0),
        ..reference.samples[0].clone()
    };
    let arm = Arm::new(&reference.alpha_degrees, parameters, &sample.q, &sample.inputs);
    let motion = arm.solve(&sample.u);
    solved(named(&reference.parameter_names, parameters), state_of(&reference, &sample), &motion)
}

fn bicycle_case(random: &mut Random) -> Case {
    let reference = data::samples("bicycle");
    let parameters = &reference.samples[0].parameters;
    let mut q = draw(random, 6, -0.3, 0.3);
    let inputs = draw(random, 3, -5.0, 5.0);
    let speeds = [random.between(-1.0, 1.0), random.between(-1.0, 1.0), random.between(-15.0, -3.0)];
    q[2] = Bicycle::new(parameters, &q, &inputs).pitch();
    let sample = Sample { q, u: speeds.to_vec(), inputs, ..reference.samples[0].clone() };
    let motion = Bicycle::new(parameters, &sample.q, &sample.inputs).solve(&sample.u);
    solved(named(&reference.parameter_names, parameters), state_of(&reference, &sample), &motion)
}
