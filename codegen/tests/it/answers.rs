//! Answers on request against independent computations: energy, forward dynamics, finite differences.

use crate::linearisation::difference;
use crate::models::shipped;
use smartbed_codegen::kinematics::linear;
use smartbed_codegen::model::Model;
use smartbed_codegen::program::answer::Shape;
use smartbed_codegen::{Asked, Function, Interpreted, ParameterChoice, Program, Request, program};
use smartbed_runtime::mechanism::Mechanism;

/// A program and one function with all requested answers.
pub(crate) struct Asking {
    pub program: Program,
    pub engine: Interpreted<f64>,
    pub state: State,
}

/// A state that satisfies the constraints.
#[derive(Clone)]
pub(crate) struct State {
    pub t: f64,
    pub q: Vec<f64>,
    pub u: Vec<f64>,
    pub inputs: Vec<f64>,
    pub u_dot: Vec<f64>,
}

/// Time of the states (s).
const TIME: f64 = 0.05;

/// Numbers in [-1, 1].
fn number(n: usize) -> f64 {
    2.0 * ((n + 1) as f64 * 0.618_033_988_749_894_9).fract() - 1.0
}

impl Asking {
    /// The model's standing answers and these, at a state off the nominal one.
    pub fn new(name: &str, requests: &[&str]) -> Self {
        Self::of(&shipped(name), requests)
    }

    /// The same of any model.
    pub fn of(model: &Model, requests: &[&str]) -> Self {
        let requests: Vec<Request> = requests.iter().map(|text| text.parse().expect("a request")).collect();
        let asked = Asked::besides(vec![Function { name: "answers".to_owned(), requests }]);
        let program =
            program::derive_asked(model, &ParameterChoice::default(), program::Settings::default(), &asked)
                .unwrap_or_else(|found| panic!("{found}"));
        let mut q = program.nominal.clone();
        for (n, (value, quantity)) in q.iter_mut().zip(&program.q).enumerate() {
            let declared = model.coordinates.iter().find(|c| c.name == quantity.name).expect("declared");
            let (low, high) = declared.range;
            if declared.independent {
                *value += 0.15 * number(n) * (high - low).min(2.0);
            }
        }
        // Where all four Euler parameters of a joint are independent they are kept of unit length.
        for n in (0..q.len()).filter(|&n| program.q[n].name.ends_with("_e0")) {
            let others: f64 = q[n + 1..n + 4].iter().map(|e| e * e).sum();
            q[n] = (1.0 - others).sqrt();
        }
        let mut assembly = program.assembly.clone();
        assembly.set_time(TIME);
        assembly.correct(&mut q).expect("near the nominal configuration");
        let u = (0..program.u.len()).map(|n| 0.5 * number(n + 7)).collect();
        let inputs = (0..program.inputs.len()).map(|n| 9.0 * number(n + 19)).collect();
        let u_dot = (0..program.u_dot.len()).map(|n| 3.0 * number(n + 31)).collect();
        let engine = Interpreted::new(&program);
        Self { state: State { t: TIME, q, u, inputs, u_dot }, program, engine }
    }

    /// The numbers of a part of an answer at a state.
    pub fn part(&mut self, state: &State, answer: &str, part: &str) -> Vec<f64> {
        let values = self
            .engine
            .function(0, (state.t, &state.q, &state.u, &state.inputs, &state.u_dot))
            .expect("lengths fit");
        let mut first = 0;
        for found in self.program.answers_of(&self.program.functions[0]) {
            for own in &found.parts {
                let n = own.values.len();
                if found.name == answer && own.name == part {
                    return values[first..first + n].to_vec();
                }
                first += n;
            }
        }
        panic!("{answer}.{part}");
    }

    pub fn has(&self, answer: &str, part: &str) -> bool {
        let found = self.program.answers.iter().find(|found| found.name == answer).expect("asked");
        found.parts.iter().any(|own| own.name == part)
    }

    pub fn rates(&mut self, state: &State) -> (Vec<f64>, Vec<f64>) {
        let (mut q_dot, mut u_dot) = (vec![0.0; state.q.len()], vec![0.0; state.u.len()]);
        self.engine
            .rates(state.t, &state.q, &state.u, &state.inputs, &mut q_dot, &mut u_dot)
            .expect("lengths fit");
        (q_dot, u_dot)
    }

    /// The derivative of a part along the motion with the speeds held, by central differences of fourth order.
    fn along(&mut self, state: &State, answer: &str, part: &str) -> Vec<f64> {
        const STEP: f64 = 1e-3;
        let (q_dot, _) = self.rates(state);
        let mut at = |steps: f64| {
            let mut moved = state.clone();
            moved.t += steps * STEP;
            moved.q.iter_mut().zip(&q_dot).for_each(|(q, rate)| *q += steps * STEP * rate);
            // On the constraints, whatever the path's curvature: dependent coordinates follow the independent ones.
            self.engine.set_time(moved.t);
            for _ in 0..4 {
                self.engine.project(&mut moved.q).expect("lengths fit");
            }
            self.part(&moved, answer, part)
        };
        let [a, b, c, d] = [-2.0, -1.0, 1.0, 2.0].map(&mut at);
        (0..a.len()).map(|i| (a[i] - 8.0 * b[i] + 8.0 * c[i] - d[i]) / (12.0 * STEP)).collect()
    }
}

/// Relative to the largest of the numbers expected.
#[track_caller]
pub(crate) fn close(found: &[f64], expected: &[f64], bound: f64, what: &str) {
    assert_eq!(found.len(), expected.len(), "{what}");
    let size = expected.iter().fold(1e-300_f64, |m, x| m.max(x.abs()));
    for (i, (a, b)) in found.iter().zip(expected).enumerate() {
        assert!((a - b).abs() <= bound * size, "{what}[{i}]: {a:e} against {b:e}");
    }
}

/// Mechanisms that nothing drives and that have masses.
const MECHANISMS: [&str; 9] = [
    "arm6",
    "bicycle",
    "cart_pole",
    "fourbar",
    "free_body",
    "pendulum3",
    "pendulum10",
    "tile",
    "tile_minimal",
];

#[test]
fn the_mass_matrix_is_that_of_the_kinetic_energy() {
    for name in MECHANISMS {
        let mut asking = Asking::new(name, &["mass_matrix"]);
        let state = asking.state.clone();
        let n = state.u.len();
        let mut kinetic = |ones: &[usize]| {
            let mut u = vec![0.0; n];
            ones.iter().for_each(|&i| u[i] += 1.0);
            asking.engine.energy(&state.q, &u).expect("lengths fit").0
        };
        // 2 T is a quadratic form: T(e_i + e_j) - T(e_i) - T(e_j) = M_ij.
        let mut expected = Vec::new();
        for i in 0..n {
            for j in 0..n {
                expected.push(kinetic(&[i, j]) - kinetic(&[i]) - kinetic(&[j]));
            }
        }
        let found = asking.part(&state, "mass_matrix", "mass_matrix");
        close(&found, &expected, 1e-13, name);
    }
}

/// M u' + bias = forces of the inputs, those of a port's wrench included, and a given wrench is a load on the others.
#[test]
fn no_input_is_part_of_the_bias() {
    for (name, port) in [("tile", "port:platform"), ("arm6", "port:tool")] {
        let mut asking = Asking::new(name, &["mass_matrix", "bias", "forcing", "inverse_dynamics", port]);
        let mut free = asking.state.clone();
        free.inputs.iter_mut().for_each(|x| *x = 0.0);
        let mut loaded = free.clone();
        let own = loaded.inputs.len() - 6;
        loaded.inputs[own..].copy_from_slice(&[3.0, -5.0, 20.0, 1.0, 2.0, -0.5]);
        assert_eq!(asking.part(&free, "bias", "bias"), asking.part(&loaded, "bias", "bias"), "{name}");
        let forcing = [&free, &loaded].map(|state| asking.part(state, "forcing", "forcing"));
        let needed =
            [&free, &loaded].map(|state| asking.part(state, "inverse_dynamics", "generalised_force"));
        let of_wrench: Vec<f64> =
            forcing[1].iter().zip(&forcing[0]).map(|(with, without)| with - without).collect();
        let carried: Vec<f64> =
            needed[0].iter().zip(&needed[1]).map(|(without, with)| without - with).collect();
        assert!(of_wrench.iter().any(|f| f.abs() > 1.0), "{of_wrench:?}");
        close(&carried, &of_wrench, 1e-10, name);
    }
}

#[test]
fn inverse_dynamics_undoes_forward_dynamics() {
    let mut with_inputs = Vec::new();
    for name in MECHANISMS.into_iter().chain([
        "tile_drive",
        "rolling_disc",
        "slider_crank_closed",
        "shaking_table",
        "turntable",
    ]) {
        let mut asking = Asking::new(name, &["inverse_dynamics", "mass_matrix", "bias"]);
        let mut state = asking.state.clone();
        state.u_dot = asking.rates(&state).1;
        let force = asking.part(&state, "inverse_dynamics", "generalised_force");
        let (mass, bias) =
            (asking.part(&state, "mass_matrix", "mass_matrix"), asking.part(&state, "bias", "bias"));
        // With the inputs that the accelerations came from, nothing else is missing: force = B inputs. At inputs of 0
        // it is 0.
        let mut free = state.clone();
        free.inputs.iter_mut().for_each(|x| *x = 0.0);
        free.u_dot = asking.rates(&free).1;
        let nothing = asking.part(&free, "inverse_dynamics", "generalised_force");
        let n = state.u.len();
        let terms = |i: usize| {
            let inertia: f64 = (0..n).map(|j| (mass[i * n + j] * free.u_dot[j]).abs()).sum();
            inertia + bias[i].abs()
        };
        for (i, rest) in nothing.iter().enumerate() {
            assert!(rest.abs() <= 1e-13 * terms(i), "{name}[{i}]: {rest:e} of {:e}", terms(i));
        }
        if asking.has("inverse_dynamics", "inputs") {
            let inputs = asking.part(&state, "inverse_dynamics", "inputs");
            close(&inputs, &state.inputs, 1e-11, name);
            with_inputs.push(name);
        } else {
            let product: Vec<f64> = (0..n)
                .map(|i| bias[i] + (0..n).map(|j| mass[i * n + j] * state.u_dot[j]).sum::<f64>())
                .collect();
            for (i, (a, b)) in force.iter().zip(&product).enumerate() {
                assert!((a - b).abs() <= 1e-13 * terms(i), "{name}[{i}]: {a:e} {b:e}");
            }
        }
    }
    assert_eq!(
        with_inputs,
        ["arm6", "bicycle", "fourbar", "tile", "tile_minimal", "tile_drive", "slider_crank_closed"]
    );
}

#[test]
fn twist_and_bias_acceleration_are_rates_of_what_stands_before() {
    let places = [
        ("tile", "platform"),
        ("tile_minimal", "platform"),
        ("tile_drive", "platform"),
        ("arm6", "tool"),
        ("fourbar", "coupler@B"),
        ("shaking_table", "rod@storey"),
        ("free_body", "body@C"),
    ];
    for (name, place) in places {
        let requests =
            ["pose", "twist", "bias_acceleration", "jacobian"].map(|answer| format!("{answer}:{place}"));
        let mut asking = Asking::new(name, &requests.each_ref().map(String::as_str));
        let state = asking.state.clone();
        let [pose, twist, bias, jacobian] = &requests;
        let value = asking.part(&state, twist, "twist");
        let has_point = asking.has(pose, "position");
        if has_point {
            let velocity = asking.along(&state, pose, "position");
            close(&velocity, &value[..3], 1e-9, &format!("{name}: velocity"));
        }
        if asking.has(pose, "rotation") {
            // R' = [w] R.
            let rotation = asking.part(&state, pose, "rotation");
            let rate = asking.along(&state, pose, "rotation");
            let w = &value[value.len() - 3..];
            let mut expected = Vec::new();
            for i in 0..3 {
                for j in 0..3 {
                    let (a, b) = ((i + 1) % 3, (i + 2) % 3);
                    expected.push(w[a] * rotation[3 * b + j] - w[b] * rotation[3 * a + j]);
                }
            }
            close(&rate, &expected, 1e-9, &format!("{name}: turning"));
            for (i, j) in (0..3).flat_map(|i| (0..3).map(move |j| (i, j))) {
                let dot: f64 = (0..3).map(|k| rotation[3 * i + k] * rotation[3 * j + k]).sum();
                assert!((dot - f64::from(u8::from(i == j))).abs() < 1e-13, "{name}: {dot}");
            }
        }
        let rate = asking.along(&state, twist, "twist");
        // A body turned about principal axes may have no bias at all: differences of the twist are rounded.
        let size = value.iter().fold(0.0_f64, |m, x| m.max(x.abs()));
        for (found, rate) in asking.part(&state, bias, "bias_acceleration").iter().zip(&rate) {
            assert!(
                (found - rate).abs() <= 1e-8 * size.max(rate.abs()),
                "{name}: {found:e} against {rate:e}"
            );
        }
        // twist = J u + v_t.
        let rows = asking.part(&state, jacobian, "jacobian");
        let mut still = state.clone();
        still.u.iter_mut().for_each(|u| *u = 0.0);
        let alone = asking.part(&still, twist, "twist");
        let n = state.u.len();
        let moved: Vec<f64> =
            rows.chunks(n).map(|row| row.iter().zip(&state.u).map(|(j, u)| j * u).sum()).collect();
        let total: Vec<f64> = moved.iter().zip(&alone).map(|(a, b)| a + b).collect();
        close(&total, &value, 1e-13, &format!("{name}: J u"));
    }
}

#[test]
fn a_wrench_on_a_port_moves_it_as_its_inverse_inertia_says() {
    for (name, port) in
        [("tile", "platform"), ("tile_minimal", "platform"), ("tile_drive", "platform"), ("arm6", "tool")]
    {
        let request = format!("port:{port}");
        let mut asking = Asking::new(name, &[&request]);
        let n_inputs = asking.program.inputs.len();
        let names: Vec<String> =
            asking.program.inputs[n_inputs - 6..].iter().map(|i| i.name.clone()).collect();
        assert_eq!(names[0], format!("{port}_force_x"));
        assert_eq!(names[5], format!("{port}_moment_z"));
        let mut state = asking.state.clone();
        state.inputs.iter_mut().for_each(|x| *x = 0.0);
        let n = state.u.len();
        let rest = asking.rates(&state).1;
        let jacobian = asking.part(&state, &request, "jacobian");
        let inverse = asking.part(&state, &request, "inverse_inertia");
        for component in 0..6 {
            let mut pushed = state.clone();
            pushed.inputs[n_inputs - 6 + component] = 1.0;
            let change: Vec<f64> = asking.rates(&pushed).1.iter().zip(&rest).map(|(a, b)| a - b).collect();
            let moved: Vec<f64> =
                jacobian.chunks(n).map(|row| row.iter().zip(&change).map(|(j, u)| j * u).sum()).collect();
            let column: Vec<f64> = (0..6).map(|row| inverse[6 * row + component]).collect();
            close(&column, &moved, 1e-10, &format!("{name}: {}", names[component]));
        }
    }
}

#[test]
fn what_is_not_asked_for_is_not_derived() {
    let model = shipped("tile");
    let asked = |requests: &[&str]| {
        let requests = requests.iter().map(|text| text.parse().expect("a request")).collect();
        let asked = Asked::only(vec![Function::together("answers", requests)]);
        program::derive_asked(&model, &ParameterChoice::default(), program::Settings::default(), &asked)
            .expect("derives")
    };
    let pose = asked(&["pose:platform"]);
    let all: usize = pose.dag.state_cost(&pose.all_roots());
    assert_eq!(all, pose.dag.state_cost(&pose.function_roots(&pose.functions[0])));
    assert!(all < 80, "{all}");
    assert_eq!(pose.inputs.len(), 3);
    assert!(pose.augmented.mass.is_empty());
    // Together they share: one function of both costs less than two.
    let cost = |program: &Program| program.dag.state_cost(&program.all_roots());
    let (mass, inverse) = (asked(&["mass_matrix"]), asked(&["inverse_inertia:platform"]));
    let both = asked(&["mass_matrix", "inverse_inertia:platform"]);
    assert!(
        cost(&both) < cost(&mass) + cost(&inverse) - cost(&mass) / 2,
        "{} {} {}",
        cost(&both),
        cost(&mass),
        cost(&inverse)
    );
    let parts = &both.answers[1].parts;
    assert_eq!((parts[0].shape, parts[0].labels.len()), (Shape::Matrix(6, 6), 6));
}

#[test]
fn requests_that_mean_nothing_are_refused() {
    let model = shipped("tile");
    let refused = |text: &str| {
        let request: Request = text.parse().expect("a request");
        let asked = Asked::only(vec![Function::single(request)]);
        let found =
            program::derive_asked(&model, &ParameterChoice::default(), program::Settings::default(), &asked);
        found.expect_err(text).to_string()
    };
    for (text, message) in [
        ("colour", "no such answer: `colour`"),
        ("pose", "of what?"),
        ("pose:nowhere", "the model has no such port, point or frame"),
        ("port:G", "ports of the model: platform"),
        ("mass_matrix:G", "about the mechanism as a whole"),
    ] {
        assert!(refused(text).contains(message), "{text}: {}", refused(text));
    }
    let bicycle = shipped("bicycle");
    let rolling =
        bicycle.points.iter().find(|p| p.velocity.is_some()).expect("a point located by its velocity");
    let asked = Asked::only(vec![Function::single(Request::of("pose", &rolling.name))]);
    let found =
        program::derive_asked(&bicycle, &ParameterChoice::default(), program::Settings::default(), &asked);
    assert!(found.expect_err("no position").to_string().contains("the model states its velocity"));
}

#[test]
fn a_name_that_would_mean_two_things_is_refused() {
    let model = shipped("pendulum");
    let derived = |texts: &[&str]| {
        let functions = texts.iter().enumerate().map(|(place, text)| Function::parse(text, place));
        let asked = Asked::only(functions.collect::<Result<_, _>>().expect("requests"));
        program::derive_asked(&model, &ParameterChoice::default(), program::Settings::default(), &asked)
    };
    for (texts, message) in [
        (&["rates=energy", "rates"][..], "the function `rates` would not be the answer `rates`"),
        (&["rates", "rates"], "two functions are named `rates`"),
        (&["a = rates, energy", "a = speeds, rates"], "two functions are named `a`"),
        (&["a = pose:P, rates, pose:P"], "`a` asks for `pose:P` twice"),
    ] {
        let said = derived(texts).map(|_| ()).expect_err(message).to_string();
        assert!(said.contains(message) && said.contains("help: "), "{said}");
    }
    derived(&["rates", "a = rates, pose:P", "b = rates"]).expect("names of their own");
}

#[test]
fn multipliers_are_those_of_the_equations_before_the_elimination() {
    for name in ["fourbar", "tile", "tile_minimal", "slider_crank", "bicycle"] {
        let mut asking = Asking::new(name, &["augmented", "multipliers"]);
        let state = asking.state.clone();
        let part = |asking: &mut Asking, part: &str| asking.part(&state, "augmented", part);
        let (mass, forcing) = (part(&mut asking, "mass"), part(&mut asking, "forcing"));
        let (jacobian, bias) = (part(&mut asking, "jacobian"), part(&mut asking, "bias"));
        let (n, m) = (forcing.len(), bias.len());
        let size = n + m;
        let mut matrix = vec![0.0; size * size];
        for i in 0..n {
            matrix[i * size..][..n].copy_from_slice(&mass[i * n..][..n]);
            for r in 0..m {
                matrix[i * size + n + r] = -jacobian[r * n + i];
                matrix[(n + r) * size + i] = jacobian[r * n + i];
            }
        }
        let mut right: Vec<f64> = forcing.iter().copied().chain(bias.iter().map(|b| -b)).collect();
        let (solution, rank) = linear::solve(&matrix, &mut right, size);
        assert_eq!(rank, size, "{name}");
        close(&asking.part(&state, "multipliers", "multipliers"), &solution[n..], 1e-10, name);
    }
}

/// A rod without mass passes on a force along itself only: the bob's weight is borne by the rod on which the model puts
/// it, although both ends are one place.
#[test]
fn multipliers_leave_a_mass_on_the_rod_that_carries_it() {
    let text = |centre: &str| {
        format!(
            "format = 1\nname = \"bob\"\ngravity = \"-10_m/1_s/1_s*N.y\"\n[coordinates]\n\
             s = {{ unit = \"m\", independent = true, nominal = 0.7, range = [0.5, 0.75] }}\n\
             a = {{ unit = \"rad\", nominal = 0.9, range = [0.2, 1.8] }}\nb = {{ unit = \"rad\", nominal = 2.5, range = [1.6, 3] }}\n\
             [frames]\nla = {{ rotations = [[\"z\", \"a\"]] }}\nlb = {{ rotations = [[\"z\", \"b\"]] }}\n\
             [points]\nP = \"0.3_m*la.x\"\nS = \"s*N.x\"\nQ = \"S + 0.5_m*lb.x\"\n[constraints.configuration]\nloop = \"P - Q\"\n\
             [bodies]\nbob = {{ centre = \"{centre}\", mass = 1 }}\nslider = {{ centre = \"S\", mass = 2 }}\n"
        )
    };
    let found = ["P", "Q"].map(|centre| {
        let model = smartbed_codegen::model::parse("bob.toml", &text(centre)).expect("it is read");
        let mut asking = Asking::of(&model, &["multipliers"]);
        let state = asking.state.clone();
        asking.part(&state, "multipliers", "multipliers")
    });
    let [[on_a, along_b], [along_a, on_b]] = found.each_ref().map(|of| [of[0], of[1]]);
    assert!(on_a.abs() < 1e-12 && on_b.abs() < 1e-12, "{found:?}");
    assert!(along_a.abs() > 1.0 && along_b.abs() > 1.0, "{found:?}");
}

#[test]
fn every_multiplier_has_a_name_of_its_own() {
    for name in ["fourbar", "tile", "tile_minimal", "slider_crank", "bicycle"] {
        let asking = Asking::new(name, &["multipliers"]);
        let labels = &asking.program.answers[0].parts[0].labels;
        for (n, label) in labels.iter().enumerate() {
            assert!(!labels[..n].contains(label), "{name}: {labels:?}");
        }
    }
    let four_bar = Asking::new("fourbar", &["multipliers"]);
    let labels = &four_bar.program.answers[0].parts[0].labels;
    assert!(labels.iter().all(|label| label.starts_with("loop along ")), "{labels:?}");
}

#[test]
fn powers_are_the_rate_of_the_kinetic_energy() {
    for name in ["arm6", "bicycle", "fourbar", "tile", "tile_drive", "shaking_table", "driven_pendulum"] {
        let mut asking = Asking::new(name, &["power", "energy", "drive"]);
        let state = asking.state.clone();
        let (q_dot, u_dot) = asking.rates(&state);
        let powers = asking.part(&state, "power", "power");
        let drive =
            if asking.program.drive.is_some() { asking.part(&state, "drive", "power")[0] } else { 0.0 };
        let rate = difference(
            |change| {
                let mut moved = state.clone();
                moved.t += change;
                moved.q.iter_mut().zip(&q_dot).for_each(|(q, rate)| *q += change * rate);
                moved.u.iter_mut().zip(&u_dot).for_each(|(u, rate)| *u += change * rate);
                asking.part(&moved, "energy", "kinetic")
            },
            1e-4,
        );
        let size = powers.iter().fold(rate[0].abs().max(drive.abs()), |most, power| most.max(power.abs()));
        let sum = powers.iter().sum::<f64>() + drive;
        assert!((sum - rate[0]).abs() <= 1e-9 * size, "{name}: {sum:e} against {:e}", rate[0]);
    }
}

#[test]
fn inverse_dynamics_takes_fewer_operations_than_the_mass_matrix() {
    let cost = |name: &str, request: &str| {
        let asked = Asked::only(vec![Function::single(request.parse().expect("a request"))]);
        let program = program::derive_asked(
            &shipped(name),
            &ParameterChoice::default(),
            program::Settings::default(),
            &asked,
        )
        .expect("derives");
        program.dag.state_cost(&program.all_roots())
    };
    for (name, most) in [("arm6", 640), ("tile", 450)] {
        let (inverse, matrix) = (cost(name, "inverse_dynamics"), cost(name, "mass_matrix"));
        println!("{name}: inverse dynamics {inverse}, mass matrix {matrix}");
        assert!(inverse <= most, "{name}: {inverse}");
    }
    // Over forward dynamics.
    for (name, most) in [("arm6", 4.0), ("tile", 4.0), ("bicycle", 4.0)] {
        let (linear, forward) = (cost(name, "linearisation"), cost(name, "rates"));
        let ratio = linear as f64 / forward as f64;
        println!("{name}: linearisation {linear}, {ratio:.2} times forward dynamics");
        assert!(ratio <= most, "{name}: {ratio}");
    }
}

/// Values of `inverse_dynamics` that are those of another answer where given accelerations cancel: the function of that
/// answer is not given them. Here a disc that rolls, with an arm on a universal joint.
#[test]
fn answers_read_given_accelerations_only_where_they_have_them() {
    let text = r#"
format = 1
name = "rolling_arm"
gravity = "-g*N.z"
[parameters]
m = { value = 1, unit = "kg" }
r = { value = 0.5, unit = "m" }
g = { value = 9.81, unit = "m/s^2" }
mp = { value = 0.3, unit = "kg" }
d = { value = 0.2, unit = "m" }
a = { value = 0.1, unit = "m" }
w = { value = 2, unit = "Hz" }
[joints]
disc = { kind = "rolling_disc", child = "wheel", radius = "r", at = "a*sin(w*t)*N.x" }
pend = { kind = "universal", axes = ["z", "x"], parent = "wheel", child = "bob", at = "wheel + d*wheel.x", stiffness = [2, 1.5], rest = [0.1, 0.2] }
[points]
tip = "bob - 0.15_m*bob.z"
[bodies]
disc = { centre = "wheel", frame = "wheel", mass = "m", disc = "r", axis = "y" }
bob = { centre = "tip", frame = "bob", mass = "mp", box = ["0.05_m", "0.1_m", "0.3_m"] }
"#;
    let model = smartbed_codegen::model::parse("rolling_arm.toml", text).expect("a model");
    let one =
        |name: &str| Function { name: name.to_owned(), requests: vec![name.parse().expect("a request")] };
    let asked = Asked::only(vec![one("inverse_dynamics"), one("linearisation")]);
    let program =
        program::derive_asked(&model, &ParameterChoice::default(), program::Settings::default(), &asked)
            .expect("derives");
    let given: Vec<_> = program.u_dot.iter().map(|quantity| quantity.symbol).collect();
    assert!(!given.is_empty());
    let reads = |function: usize| {
        let roots = program.function_roots(&program.functions[function]);
        program.dag.symbols_of_all(&roots).iter().any(|symbol| given.contains(symbol))
    };
    assert!(reads(0) && !reads(1));
}
