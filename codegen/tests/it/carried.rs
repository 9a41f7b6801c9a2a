//! A flexible body on a port of a derived mechanism, against the single system in which the same nodes are bodies of
//! the model itself: what is joined when it runs moves as what is derived in one piece.

use crate::models::shipped;
use smartbed_codegen::{Asked, Function, Interpreted, ParameterChoice, Program, Request, model, program};
use smartbed_runtime::flexible::{Body, Massless, Spring};
use smartbed_runtime::mechanism::{Fault, Mechanism};
use smartbed_runtime::ode::{Driven, Ode, State, rk4, runge_kutta};
use smartbed_runtime::surface::Frame;
use smartbed_runtime::world::{Attachment, Carrier, InverseInertia, Island, Memory, Wrench};
use std::path::Path;

/// Thrusts of the legs (N).
const THRUST: [f64; 3] = [30.0, 29.0, 31.0];
/// Where the body is attached, along the platform's axes from G (m).
const PLACES: [[f64; 3]; 3] = [[0.1, 0.0, 0.02], [-0.05, 0.08, 0.02], [-0.05, -0.08, 0.02]];
/// Nodes: mass (kg) and start (m).
const NODES: [(f64, [f64; 3]); 2] = [(0.3, [0.01, -0.01, 0.12]), (0.2, [0.02, 0.03, 0.22])];
/// Springs: ends (attachments, then nodes), stiffness (N/m), damping (N s/m), rest length (m).
const SPRINGS: [(usize, usize, f64, f64, f64); 5] = [
    (0, 3, 900.0, 2.0, 0.13),
    (1, 3, 900.0, 2.0, 0.13),
    (2, 3, 800.0, 1.0, 0.13),
    (3, 4, 700.0, 0.5, 0.1),
    (2, 4, 100.0, 0.0, 0.2),
];
/// Steps of 1 ms.
const STEPS: u32 = 400;

/// Answers of a port that a carrier gives.
const PARTS: [&str; 4] = ["position", "rotation", "twist", "inverse_inertia"];

/// The mechanism with a port's answers.
struct Ported {
    engine: Interpreted<f64>,
    inputs: Vec<f64>,
    u_dot: Vec<f64>,
    /// First numbers of position, rotation, twist and inverse inertia among the answers.
    first: [usize; 4],
}

impl Ported {
    fn new(program: &Program) -> Self {
        let mut first = [usize::MAX; 4];
        let mut place = 0;
        for part in program.answers_of(&program.functions[0]).into_iter().flat_map(|answer| answer.parts) {
            if let Some(which) = PARTS.iter().position(|name| *name == part.name) {
                first[which] = place;
            }
            place += part.values.len();
        }
        assert!(first.iter().all(|place| *place != usize::MAX), "the port answers all four");
        let mut inputs = vec![0.0; program.inputs.len()];
        inputs[..3].copy_from_slice(&THRUST);
        Ported { engine: Interpreted::new(program), inputs, u_dot: vec![0.0; program.u_dot.len()], first }
    }
}

impl Carrier<f64> for Ported {
    fn n_q(&self) -> usize {
        self.engine.n_q()
    }
    fn n_u(&self) -> usize {
        self.engine.n_u()
    }
    fn n_ports(&self) -> usize {
        1
    }
    fn inverse_inertia(
        &mut self,
        t: f64,
        q: &[f64],
        u: &[f64],
        _: [usize; 2],
    ) -> Result<InverseInertia<f64>, Fault> {
        let answers = self.engine.function(0, (t, q, u, &self.inputs, &self.u_dot))?;
        let first = self.first[3];
        Ok(std::array::from_fn(|row| std::array::from_fn(|column| answers[first + 6 * row + column])))
    }
    fn frames(&mut self, t: f64, q: &[f64], u: &[f64], frames: &mut [Frame<f64>]) -> Result<(), Fault> {
        let answers = self.engine.function(0, (t, q, u, &self.inputs, &self.u_dot))?;
        let three = |first: usize| [answers[first], answers[first + 1], answers[first + 2]];
        let [position, rotation, twist, _] = self.first;
        let rows = [0, 3, 6].map(|row| three(rotation + row));
        frames[0] = Frame {
            origin: three(position),
            axes: [0, 1, 2].map(|axis| rows.map(|row| row[axis])),
            velocity: three(twist),
            angular_velocity: three(twist + 3),
        };
        Ok(())
    }
    fn rates(
        &mut self,
        t: f64,
        q: &[f64],
        u: &[f64],
        wrenches: &[Wrench<f64>],
        q_dot: &mut [f64],
        u_dot: &mut [f64],
    ) -> Result<f64, Fault> {
        let own = self.inputs.len() - 6;
        self.inputs[own..own + 3].copy_from_slice(&wrenches[0].force);
        self.inputs[own + 3..].copy_from_slice(&wrenches[0].moment);
        self.engine.rates(t, q, u, &self.inputs, q_dot, u_dot)
    }
    fn energy(&mut self, t: f64, q: &[f64], u: &[f64]) -> Result<(f64, f64), Fault> {
        self.engine.set_time(t);
        self.engine.energy(q, u)
    }
    fn project(&mut self, q: &mut [f64]) -> Result<f64, Fault> {
        self.engine.project(q)
    }
    fn projections(&self) -> u8 {
        1
    }
}

/// The mechanism with the nodes as bodies of its own.
fn in_one_piece(name: &str) -> Program {
    let mut text =
        format!("format = 1\nextends = \"{name}.toml\"\nname = \"in_one_piece\"\ndof = 9\n\n[coordinates]\n");
    for (node, (_, start)) in NODES.iter().enumerate() {
        for (axis, start) in ["x", "y", "z"].iter().zip(start) {
            text += &format!(
                "{axis}{node} = {{ unit = \"m\", independent = true, nominal = {start}, range = [-1.0, 1.0] }}\n"
            );
        }
    }
    text += "\n[points]\n";
    for (number, [x, y, z]) in PLACES.iter().enumerate() {
        text +=
            &format!("node{number} = \"G + ({x}_m)*platform.x + ({y}_m)*platform.y + ({z}_m)*platform.z\"\n");
    }
    for node in 0..NODES.len() {
        let number = PLACES.len() + node;
        text += &format!("node{number} = \"x{node}*N.x + y{node}*N.y + z{node}*N.z\"\n");
    }
    text += "\n[bodies]\n";
    for (node, (mass, _)) in NODES.iter().enumerate() {
        let number = PLACES.len() + node;
        text += &format!("node{number} = {{ centre = \"node{number}\", mass = {mass:?} }}\n");
    }
    text += "\n[springs]\n";
    for (number, (tail, head, stiffness, damping, rest)) in SPRINGS.iter().enumerate() {
        text += &format!(
            "s{number} = {{ between = [\"node{tail}\", \"node{head}\"], stiffness = {stiffness:?}, damping = {damping:?}, \
             rest_length = {rest:?} }}\n"
        );
    }
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).parent().expect("in the workspace").join("models");
    let load = |base: &Path| {
        let file = base.file_name().expect("a file");
        std::fs::read_to_string(folder.join(file)).map_err(|error| error.to_string())
    };
    let model =
        model::parse_with("in_one_piece.toml", &text, &load).unwrap_or_else(|found| panic!("{found}"));
    program::derive_with(&model, &ParameterChoice::default(), program::Settings::default())
        .unwrap_or_else(|found| panic!("{found}"))
}

/// Heights of the legs and positions of the nodes after the run, and the platform's own start.
fn start(names: &[String]) -> Vec<f64> {
    let heights = [("hA", 0.02), ("hB", -0.01), ("hC", 0.015)];
    names
        .iter()
        .map(|name| heights.iter().find(|(known, _)| known == name).map_or(f64::NAN, |h| h.1))
        .collect()
}

fn run(system: &mut impl Ode<f64>, x: &mut [f64]) {
    let (mut low, mut scratch) = (vec![0.0; x.len()], vec![0.0; runge_kutta::rk4_scratch(x.len())]);
    let mut state = State::new(x, &mut low).expect("a state");
    for step in 0..STEPS {
        rk4(system, f64::from(step) * 1e-3, 1e-3, &mut state, &mut scratch).expect("a step");
    }
}

/// Coordinates of a program that satisfy its constraints, the heights as in [`start`].
fn assembled(program: &Program) -> Vec<f64> {
    let names: Vec<String> = program.q.iter().map(|q| q.name.clone()).collect();
    let wanted = start(&names);
    let mut q: Vec<f64> = program
        .nominal
        .iter()
        .zip(&wanted)
        .map(|(own, given)| if given.is_nan() { *own } else { *given })
        .collect();
    let mut engine = Interpreted::<f64>::new(program);
    for _ in 0..8 {
        engine.project(&mut q).expect("lengths fit");
    }
    q
}

#[test]
fn a_body_on_a_tile_moves_as_the_model_that_has_its_nodes() {
    let request: Request = "port:platform".parse().expect("a request");
    let asked = Asked::besides(vec![Function { name: "port".to_owned(), requests: vec![request] }]);
    let carrier = program::derive_asked(
        &shipped("tile_minimal"),
        &ParameterChoice::default(),
        program::Settings::default(),
        &asked,
    )
    .unwrap_or_else(|found| panic!("{found}"));
    let mass: Vec<f64> = [0.0; 3].into_iter().chain(NODES.map(|(mass, _)| mass)).collect();
    let fixed = [true, true, true, false, false];
    let springs = SPRINGS.map(|(tail, head, stiffness, damping, rest_length)| Spring {
        tail,
        head,
        stiffness,
        damping,
        rest_length,
    });
    let body = Body::new(Body {
        mass: &mass,
        fixed: &fixed,
        springs: &springs,
        gravity: [0.0, 0.0, -9.81],
        air_drag: 0.0,
        facets: &[],
        inflation: None,
        massless: Massless::default(),
    })
    .expect("a body");
    let attachments = [0, 1, 2].map(|node| Attachment { node, port: 0, place: PLACES[node] });
    let mut pos: Vec<[f64; 3]> = [[0.0; 3]; 3].into_iter().chain(NODES.map(|(_, start)| start)).collect();
    let mut rows = [[[0.0; 3]; 5]; 3];
    let [vel, elastic, viscous] = &mut rows;
    let (mut frames, mut wrenches) = ([Frame::inertial()], [Wrench::zero()]);
    let (frames, wrenches) = (&mut frames, &mut wrenches);
    let memory = Memory { pos: &mut pos, vel, elastic, viscous, frames, wrenches };
    let mut island = Island::new(Ported::new(&carrier), body, &attachments, memory).expect("an island");
    let mut joined = vec![0.0; island.n_x()];
    island.load(&assembled(&carrier), &vec![0.0; carrier.u.len()], &mut joined).expect("lengths");
    run(&mut island, &mut joined);

    let single = in_one_piece("tile_minimal");
    let mut x = assembled(&single);
    x.extend(vec![0.0; single.u.len()]);
    let mut inputs = vec![0.0; single.inputs.len()];
    let law = |_: f64, _: &[f64], _: &[f64], inputs: &mut [f64]| inputs.copy_from_slice(&THRUST);
    run(&mut Driven::new(Interpreted::new(&single), law, &mut inputs).expect("inputs"), &mut x);

    let of_single = |name: &str| x[single.q.iter().position(|q| q.name == name).expect("a coordinate")];
    let mut largest = 0.0_f64;
    for (place, quantity) in carrier.q.iter().enumerate() {
        largest = largest.max((joined[place] - of_single(&quantity.name)).abs());
    }
    let n_q = carrier.q.len();
    for node in 0..NODES.len() {
        for (axis, name) in ["x", "y", "z"].iter().enumerate() {
            largest =
                largest.max((joined[n_q + 3 * node + axis] - of_single(&format!("{name}{node}"))).abs());
        }
    }
    println!("largest difference after {STEPS} steps: {largest:e} m or rad");
    assert!(largest < 1e-10, "{largest:e}");
    // Something has happened: the nodes sank and swung, the platform gave way.
    let swung = (joined[n_q + 2] - NODES[0].1[2]).abs();
    assert!(swung > 1e-3 && (of_single("hA") - 0.02).abs() > 1e-4, "{swung}");
}
