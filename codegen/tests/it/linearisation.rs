//! Linearisations and parameter derivatives against differences, in twice the digits, and against published matrices.

use crate::answers::{Asking, State, close};
use crate::models::shipped;
use crate::twofold::Twofold;
use smartbed_codegen::{Interpreted, Program, model, program};
use smartbed_runtime::mechanism::Mechanism;
use smartbed_runtime::real::Real;

/// Central differences of fourth order.
pub(crate) fn difference(mut of: impl FnMut(f64) -> Vec<f64>, step: f64) -> Vec<f64> {
    let [a, b, c, d] = [-2.0, -1.0, 1.0, 2.0].map(|n| of(n * step));
    (0..a.len()).map(|i| (a[i] - 8.0 * b[i] + 8.0 * c[i] - d[i]) / (12.0 * step)).collect()
}

/// The same numbers as scalars of twice the digits.
fn exact(list: &[f64]) -> Vec<Twofold> {
    list.iter().map(|&x| Twofold::new(x)).collect()
}

/// Rates of the independent state, and outputs, in twice the digits; dependent coordinates follow the constraints.
struct Exact {
    engine: Interpreted<Twofold>,
    independent: Vec<usize>,
    /// Places among the independent ones of Euler parameters, all four of which are independent.
    attitude: Vec<usize>,
    t: Twofold,
}

/// Accelerations over the parameters in twice the digits; q, u and inputs are held.
struct ByParameters {
    engine: Interpreted<Twofold>,
    values: Vec<f64>,
}

impl ByParameters {
    fn new(program: &Program) -> Self {
        Self {
            engine: Interpreted::new(program),
            values: program.parameters.iter().map(|p| p.value).collect(),
        }
    }

    /// The answer itself, evaluated in twice the digits.
    fn answer(&mut self, state: &State) -> Vec<f64> {
        let [q, u, inputs, u_dot] = [&state.q, &state.u, &state.inputs, &state.u_dot].map(|list| exact(list));
        let at = (Twofold::new(state.t), &q[..], &u[..], &inputs[..], &u_dot[..]);
        self.engine.function(0, at).expect("lengths fit").iter().map(|x| x.high).collect()
    }

    /// With one parameter moved by `change`.
    fn accelerations(&mut self, state: &State, column: usize, change: f64) -> Vec<Twofold> {
        let mut values = exact(&self.values);
        values[column] = values[column] + Twofold::new(change);
        self.engine.set_parameters(&values);
        let (q, u, inputs, t) =
            (exact(&state.q), exact(&state.u), exact(&state.inputs), Twofold::new(state.t));
        let (mut q_dot, mut u_dot) = (q.clone(), u.clone());
        self.engine.set_time(t);
        self.engine.rates(t, &q, &u, &inputs, &mut q_dot, &mut u_dot).expect("lengths fit");
        u_dot
    }

    /// Slopes by one parameter. Central differences of fourth order: their error is the step's fourth power, some
    /// 1e-20.
    fn slopes(&mut self, state: &State, column: usize) -> Vec<f64> {
        let step = 1e-5 * self.values[column].abs().max(1e-2);
        let [a, b, c, d] = [-2.0, -1.0, 1.0, 2.0].map(|n| self.accelerations(state, column, n * step));
        slopes([&a, &b, &c, &d], step)
    }
}

/// Slopes of numbers at -2, -1, 1 and 2 steps, to fourth order.
fn slopes([a, b, c, d]: [&[Twofold]; 4], step: f64) -> Vec<f64> {
    let eight = Twofold::new(8.0);
    let slope = |i: usize| (a[i] - d[i] + eight * (c[i] - b[i])) / Twofold::new(12.0 * step);
    (0..a.len()).map(|i| slope(i).high).collect()
}

/// Most corrections onto the constraints, and the change by one of them that counts as none.
const CORRECTIONS: (usize, f64) = (80, 1e-27);

impl Exact {
    /// At the numbers (independent q, u, inputs) one after the other, moved by `change` along a direction; Euler
    /// parameters are scaled to unit length.
    fn rates(&mut self, state: &State, direction: &[f64], change: f64) -> Vec<Twofold> {
        let (mut q, mut u, mut inputs) = (exact(&state.q), exact(&state.u), exact(&state.inputs));
        let n_u = u.len();
        let places = self.independent.iter().map(|&i| (0, i));
        let places = places.chain((0..n_u).map(|i| (1, i))).chain((0..inputs.len()).map(|i| (2, i)));
        for ((list, i), part) in places.collect::<Vec<_>>().into_iter().zip(direction) {
            let moved = [&mut q, &mut u, &mut inputs][list].get_mut(i).expect("as many as in the direction");
            *moved = *moved + Twofold::new(change) * Twofold::new(*part);
        }
        let own = self.attitude.iter().map(|&place| self.independent[place]);
        let squares = own.clone().map(|i| q[i] * q[i]).reduce(|sum, x| sum + x);
        own.for_each(|i| q[i] = q[i] / squares.expect("four").sqrt());
        self.engine.set_time(self.t);
        self.assemble(&mut q);
        let (mut q_dot, mut u_dot) = (vec![Twofold::new(0.0); q.len()], vec![Twofold::new(0.0); n_u]);
        self.engine.rates(self.t, &q, &u, &inputs, &mut q_dot, &mut u_dot).expect("lengths fit");
        let outputs = self.engine.outputs(self.t, &q, &u, &inputs).expect("lengths fit");
        self.independent.iter().map(|&i| q_dot[i]).chain(u_dot).chain(outputs).collect()
    }

    /// Corrects the dependent coordinates alone. A correction may move independent ones too, as it does with Euler
    /// parameters, along their own direction: these are restored, and the residual shrinks by a factor each time.
    fn assemble(&mut self, q: &mut [Twofold]) {
        let mut change = f64::INFINITY;
        for _ in 0..CORRECTIONS.0 {
            let mut corrected = q.to_vec();
            self.engine.project(&mut corrected).expect("lengths fit");
            self.independent.iter().for_each(|&i| corrected[i] = q[i]);
            let changes = corrected.iter().zip(&*q).map(|(&new, &old)| (new - old).high.abs());
            change = changes.fold(0.0, f64::max);
            q.copy_from_slice(&corrected);
            if change <= CORRECTIONS.1 {
                return;
            }
        }
        panic!("the dependent coordinates do not follow: {change:e}");
    }

    /// Slopes along a direction, by central differences of fourth order, whose error is some 1e-20.
    fn slopes(&mut self, state: &State, direction: &[f64]) -> Vec<f64> {
        const STEP: f64 = 1e-5;
        let [a, b, c, d] = [-2.0, -1.0, 1.0, 2.0].map(|n| self.rates(state, direction, n * STEP));
        slopes([&a, &b, &c, &d], STEP)
    }
}

#[test]
fn linearisation_is_the_slope_of_rates_and_outputs() {
    for name in [
        "arm6",
        "bicycle",
        "cart_pole",
        "delta",
        "fourbar",
        "pendulum3",
        "tile",
        "tile_minimal",
        "rolling_disc",
        "shaking_table",
        "slider_crank",
        "stewart",
    ] {
        let mut asking = Asking::new(name, &["linearisation", "outputs"]);
        let model = shipped(name);
        let state = asking.state.clone();
        let is_independent: Vec<bool> = (asking.program.q.iter())
            .map(|q| model.coordinates.iter().any(|c| c.name == q.name && c.independent))
            .collect();
        let independent: Vec<usize> = (0..state.q.len()).filter(|&i| is_independent[i]).collect();
        let n = independent.len() + state.u.len();
        let [a, b, c, d] = ["a", "b", "c", "d"].map(|part| asking.part(&state, "linearisation", part));
        let engine = Interpreted::new(&asking.program);
        let n_inputs = state.inputs.len();
        let is_euler = |place: &usize| {
            let name = &asking.program.q[independent[*place]].name;
            ["_e0", "_e1", "_e2", "_e3"].iter().any(|end| name.ends_with(end))
        };
        let attitude: Vec<usize> = (0..independent.len()).filter(is_euler).collect();
        let unit: Vec<f64> = attitude.iter().map(|&place| state.q[independent[place]]).collect();
        let mut exact = Exact { engine, independent, attitude: attitude.clone(), t: Twofold::new(state.t) };
        for column in 0..n + n_inputs {
            // Of Euler parameters a direction across them: they stay of unit length.
            let mut direction = vec![0.0; n + n_inputs];
            direction[column] = 1.0;
            if let Some(own) = attitude.iter().position(|&place| place == column) {
                attitude.iter().zip(&unit).for_each(|(&place, e)| direction[place] -= unit[own] * e);
            }
            let slopes = exact.slopes(&state, &direction);
            let along = |row: &[f64], part: &[f64]| row.iter().zip(part).map(|(x, d)| x * d).sum::<f64>();
            let (by_state, by_input) = direction.split_at(n);
            let whole = [[&a[..], &c].concat(), [&b[..], &d].concat()];
            let found: Vec<f64> = (0..slopes.len())
                .map(|i| {
                    along(&whole[0][i * n..(i + 1) * n], by_state)
                        + along(&whole[1][i * n_inputs..(i + 1) * n_inputs], by_input)
                })
                .collect();
            // Relative to what the row is made of.
            for (i, (found, slope)) in found.iter().zip(&slopes).enumerate() {
                let row = a.chunks(n).chain(c.chunks(n)).nth(i).expect("a row");
                let size = row.iter().fold(slope.abs().max(1e-3), |m, x| m.max(x.abs()));
                assert!(
                    (found - slope).abs() <= 1e-11 * size,
                    "{name} ({i}, {column}): {found:e} against {slope:e}"
                );
            }
        }
    }
}

#[test]
fn parameter_derivatives_are_slopes_of_the_accelerations() {
    for name in [
        "arm6",
        "bicycle",
        "cart_pole",
        "delta",
        "fourbar",
        "pendulum3",
        "rolling_disc",
        "slider_crank",
        "stewart",
        "tile",
        "tile_minimal",
    ] {
        let mut asking = Asking::new(name, &["parameter_derivatives"]);
        let state = asking.state.clone();
        let in_f64 = asking.part(&state, "parameter_derivatives", "u_dot");
        let mut exact = ByParameters::new(&asking.program);
        let in_twofold = exact.answer(&state);
        assert_eq!(in_f64.len(), in_twofold.len(), "{name}: u_dot is the only part");
        let n = exact.values.len();
        let slopes: Vec<Vec<f64>> = (0..n).map(|column| exact.slopes(&state, column)).collect();
        for row in 0..state.u.len() {
            // What a change of each parameter by its own size would do: the terms of the row.
            let weight = |column: usize| exact.values[column].abs().max(1e-2);
            let terms = (0..n).map(|column| slopes[column][row].abs() * weight(column)).fold(1e-3, f64::max);
            for (column, slope) in slopes.iter().enumerate() {
                let (slope, place) = (slope[row], row * n + column);
                let parameter = &asking.program.parameters[column].name;
                let formula =
                    (in_twofold[place] - slope).abs() / slope.abs().max(1e-9 * terms / weight(column));
                assert!(formula <= 1e-13, "{name}, {parameter}: the formula is off by {formula:e}");
                let rounding = (in_f64[place] - slope).abs() * weight(column) / terms;
                assert!(rounding <= 1e-12, "{name}, {parameter}: rounded by {rounding:e}");
            }
        }
    }
}

/// Matrices of the bicycle about upright straight running, Meijaard, Papadopoulos, Ruina and Schwab 2007:
/// M q'' + v C1 q' + (g K0 + v^2 K2) q = f, q = (roll, steer).
const PUBLISHED: [[f64; 4]; 4] = [
    [80.81722, 2.31941332208709, 2.31941332208709, 0.29784188199686],
    [0.0, 33.86641391492494, -0.85035641456978, 1.68540397397560],
    [-80.95, -2.59951685249872, -2.59951685249872, -0.80329488458618],
    [0.0, 76.59734589573222, 0.0, 2.65431523794604],
];

#[test]
fn the_linearised_bicycle_is_the_published_one() {
    let mut asking = Asking::new("bicycle", &["linearisation"]);
    let place =
        |list: &[program::Quantity], name: &str| list.iter().position(|x| x.name == name).expect(name);
    let value = |program: &Program, name: &str| program.parameters[place(&program.parameters, name)].value;
    let (g, radius) = (value(&asking.program, "g"), value(&asking.program, "rR"));
    let [mass, damping, weight, centrifugal] = PUBLISHED;
    for v in [0.0, 5.0] {
        let mut state = asking.state.clone();
        state.q.clone_from(&asking.program.nominal);
        state.inputs.iter_mut().for_each(|x| *x = 0.0);
        state.u.iter_mut().for_each(|x| *x = 0.0);
        state.u[place(&asking.program.u, "u_thR")] = -v / radius;
        let a = asking.part(&state, "linearisation", "a");
        // Pitch alone is dependent: the state is without it.
        let mut coordinates = asking.program.q.clone();
        coordinates.retain(|q| q.name != "pitch");
        let (n_q, n) = (coordinates.len(), coordinates.len() + state.u.len());
        let rows = ["u_roll", "u_steer"].map(|name| n_q + place(&asking.program.u, name));
        let columns = ["roll", "steer"].map(|name| place(&coordinates, name));
        // -M A: stiffness by the coordinates, damping by the speeds.
        let times = |columns: [usize; 2]| -> Vec<f64> {
            let entry = |i: usize, j: usize| -> f64 {
                -(0..2).map(|k| mass[2 * i + k] * a[rows[k] * n + columns[j]]).sum::<f64>()
            };
            vec![entry(0, 0), entry(0, 1), entry(1, 0), entry(1, 1)]
        };
        let stiffness: Vec<f64> = (0..4).map(|i| g * weight[i] + v * v * centrifugal[i]).collect();
        close(&times(columns), &stiffness, 1e-13, &format!("stiffness at {v} m/s"));
        let damping: Vec<f64> = damping.iter().map(|c| v * c).collect();
        if v > 0.0 {
            close(&times(rows), &damping, 1e-13, &format!("damping at {v} m/s"));
        }
    }
}

/// A drag c |v| v has no slope at rest, where |v| itself has a kink: whatever is asked there is finite.
#[test]
fn drag_of_the_second_power_has_slopes_at_rest() {
    let with = |drag: &str| {
        model::parse(
            "drag.toml",
            &format!(
                r#"format = 1
name = "drag"
gravity = "-9.81_N/1_kg*N.z"
[parameters]
c = {{ value = 0.3, unit = "kg/m" }}
[joints]
a = {{ kind = "revolute", axis = "x", child = "upper", nominal = 0.2 }}
b = {{ kind = "revolute", axis = "y", parent = "upper", child = "lower", at = "upper - 0.4_m*upper.z", nominal = 0.3 }}
[points]
P = "lower - 0.3_m*lower.z"
[bodies]
p = {{ centre = "P", mass = 1 }}
q = {{ centre = "lower", mass = 0.5 }}
[forces]
drag = {{ point = "P", force = "{drag}" }}
[outputs]
speed = "norm(velocity(P))"
"#
            ),
        )
        .unwrap_or_else(|found| panic!("{found}"))
    };
    let requests = ["linearisation", "parameter_derivatives"];
    let mut dragged = Asking::of(&with("-c*norm(velocity(P))*velocity(P)"), &requests);
    let mut free = Asking::of(&with("-0*c*norm(velocity(P))*velocity(P)"), &requests);
    let rest = State { u: vec![0.0; 2], ..dragged.state.clone() };
    for part in ["a", "b", "d"] {
        let expected = free.part(&rest, "linearisation", part);
        assert!(part != "a" || expected.iter().any(|x| x.abs() > 1.0), "{expected:?}");
        close(&dragged.part(&rest, "linearisation", part), &expected, 1e-15, part);
    }
    assert_eq!(dragged.part(&rest, "linearisation", "c"), [0.0; 4], "the mean over all directions");
    assert_eq!(dragged.part(&rest, "parameter_derivatives", "u_dot"), [0.0; 2]);
    // In motion, however slow, the slopes are those of the drag.
    for speed in [1.0, 1e-12] {
        let moving = State { u: vec![0.4 * speed, -0.3 * speed], ..rest.clone() };
        let slopes = dragged.part(&moving, "linearisation", "a");
        let others = free.part(&moving, "linearisation", "a");
        for column in 0..2 {
            let by_differences = difference(
                |step| {
                    let mut near = moving.clone();
                    near.u[column] += step;
                    let (_, dragged) = dragged.rates(&near);
                    let (_, free) = free.rates(&near);
                    dragged.iter().zip(&free).map(|(a, b)| a - b).collect()
                },
                1e-3 * speed,
            );
            let own: Vec<f64> =
                [2, 3].map(|row| slopes[4 * row + 2 + column] - others[4 * row + 2 + column]).to_vec();
            if speed == 1.0 {
                close(&own, &by_differences, 1e-9, "the drag's slopes");
            } else {
                assert!(own.iter().all(|x| x.abs() < 1e-11), "{own:?}");
            }
        }
    }
}
