//! Joint reactions against Newton's and Euler's equations of every body, with accelerations from other answers.

use crate::answers::{Asking, State, close};
use crate::models::shipped;
use smartbed_codegen::model::Model;
use smartbed_codegen::{Asked, Function, Interpreted, ParameterChoice, Request, program};

pub(crate) type Vector = [f64; 3];

/// Of the largest term.
const BALANCE: f64 = 1e-12;

pub(crate) fn add(a: Vector, b: Vector) -> Vector {
    std::array::from_fn(|i| a[i] + b[i])
}

pub(crate) fn scaled(a: Vector, s: f64) -> Vector {
    a.map(|x| s * x)
}

pub(crate) fn cross(a: Vector, b: Vector) -> Vector {
    std::array::from_fn(|i| {
        let (j, k) = ((i + 1) % 3, (i + 2) % 3);
        a[j] * b[k] - a[k] * b[j]
    })
}

pub(crate) fn vector(list: &[f64]) -> Vector {
    [list[0], list[1], list[2]]
}

/// Columns: axes along N's.
pub(crate) struct Turn([Vector; 3]);

impl Turn {
    pub fn outward(&self, v: Vector) -> Vector {
        std::array::from_fn(|i| (0..3).map(|j| self.0[i][j] * v[j]).sum())
    }

    pub fn inward(&self, v: Vector) -> Vector {
        std::array::from_fn(|j| (0..3).map(|i| self.0[i][j] * v[i]).sum())
    }
}

/// Where a place is, how it is accelerated.
pub(crate) struct Moving {
    pub position: Vector,
    pub turn: Turn,
    angular: Vector,
    pub acceleration: Vector,
    angular_acceleration: Vector,
}

/// A model at a state with its accelerations, asked for places and cuts.
pub(crate) struct Balance {
    asking: Asking,
    state: State,
    u_dot: Vec<f64>,
}

impl Balance {
    fn new(name: &str, places: &[&str], cuts: &[&str]) -> Self {
        Self::of(&shipped(name), places, cuts)
    }

    pub fn of(model: &Model, places: &[&str], cuts: &[&str]) -> Self {
        let mut requests = Vec::new();
        for place in places {
            requests
                .extend(["pose", "twist", "bias_acceleration", "jacobian"].map(|of| format!("{of}:{place}")));
        }
        requests.extend(cuts.iter().map(|cut| format!("reaction:{cut}")));
        let mut asking = Asking::of(model, &requests.iter().map(String::as_str).collect::<Vec<_>>());
        let state = asking.state.clone();
        let u_dot = asking.rates(&state).1;
        Self { asking, state, u_dot }
    }

    fn value(&self, parameter: &str) -> f64 {
        let found = self.asking.program.parameters.iter().find(|p| p.name == parameter);
        found.unwrap_or_else(|| panic!("{parameter}")).value
    }

    pub fn input(&self, name: &str) -> f64 {
        let place = self.asking.program.inputs.iter().position(|i| i.name == name).expect("an input");
        self.state.inputs[place]
    }

    fn part(&mut self, answer: &str, of: &str, part: &str) -> Vec<f64> {
        self.asking.part(&self.state, &format!("{answer}:{of}"), part)
    }

    /// `frame@point`.
    pub fn moving(&mut self, place: &str) -> Moving {
        let rotation = self.part("pose", place, "rotation");
        let twist = self.part("twist", place, "twist");
        let jacobian = self.part("jacobian", place, "jacobian");
        let n = self.state.u.len();
        let rates: Vec<f64> =
            (jacobian.chunks(n).zip(self.part("bias_acceleration", place, "bias_acceleration")))
                .map(|(row, bias)| row.iter().zip(&self.u_dot).map(|(j, u)| j * u).sum::<f64>() + bias)
                .collect();
        Moving {
            position: vector(&self.part("pose", place, "position")),
            turn: Turn([vector(&rotation), vector(&rotation[3..]), vector(&rotation[6..])]),
            angular: vector(&twist[3..]),
            acceleration: vector(&rates),
            angular_acceleration: vector(&rates[3..]),
        }
    }

    /// The components by name; those that are not determined are 0.
    pub fn reaction(&mut self, cut: &str) -> [f64; 6] {
        let values = self.part("reaction", cut, "reaction");
        let labels = self.labels(cut);
        let mut all = [0.0; 6];
        for (label, value) in labels.iter().zip(values) {
            let place = ["F_x", "F_y", "F_z", "M_x", "M_y", "M_z"].iter().position(|name| name == label);
            all[place.expect("a component")] = value;
        }
        all
    }

    pub fn labels(&self, cut: &str) -> Vec<String> {
        let name = format!("reaction:{cut}");
        let answer = self.asking.program.answers.iter().find(|answer| answer.name == name).expect("asked");
        answer.parts[0].labels.clone()
    }
}

/// Rate of the angular momentum about the mass centre, along N's axes; inertia as `Ixx, Iyy, Izz, Ixy, Ixz, Iyz` in the
/// body.
pub(crate) fn rate_of_momentum(body: &Moving, inertia: [f64; 6]) -> Vector {
    let [xx, yy, zz, xy, xz, yz] = inertia;
    let times = |v: Vector| {
        [
            xx * v[0] + xy * v[1] + xz * v[2],
            xy * v[0] + yy * v[1] + yz * v[2],
            xz * v[0] + yz * v[1] + zz * v[2],
        ]
    };
    let w = body.turn.inward(body.angular);
    let alpha = body.turn.inward(body.angular_acceleration);
    body.turn.outward(add(times(alpha), cross(w, times(w))))
}

#[track_caller]
pub(crate) fn balanced(terms: &[Vector], what: &str) {
    let size = terms.iter().flatten().fold(0.0_f64, |most, x| most.max(x.abs()));
    for i in 0..3 {
        let rest: f64 = terms.iter().map(|term| term[i]).sum();
        assert!(rest.abs() <= BALANCE * size, "{what}[{i}]: {rest:e} of {size:e}");
    }
}

#[test]
fn reactions_balance_every_link_of_an_arm() {
    let cuts: [String; 6] = std::array::from_fn(|i| format!("link{i}@J{i}"));
    let centres: [String; 6] = std::array::from_fn(|i| format!("link{i}@C{i}"));
    let places: Vec<&str> = centres.iter().chain(&cuts).map(String::as_str).collect();
    let mut arm = Balance::new("arm6", &places, &cuts.each_ref().map(String::as_str));
    let g = arm.value("g");
    // The wrench of a joint on what is outside it, along N's axes, and the joint's place.
    let mut joints = Vec::new();
    for (i, cut) in cuts.iter().enumerate() {
        assert_eq!(arm.labels(cut).len(), 6, "a tree leaves nothing undetermined");
        let at = arm.moving(cut);
        let [fx, fy, fz, mx, my, mz] = arm.reaction(cut);
        // About the hinge's own axis nothing but the drive, which is a load and no part of the reaction.
        let size = fx.abs().max(fy.abs()).max(fz.abs());
        assert!(mz.abs() <= BALANCE * size, "{cut}: {mz:e}");
        let drive = at.turn.outward([0.0, 0.0, arm.input(&format!("T{i}"))]);
        let moment = add(at.turn.outward([mx, my, mz]), drive);
        joints.push((at.position, at.turn.outward([fx, fy, fz]), moment));
    }
    for (i, centre) in centres.iter().enumerate() {
        let link = arm.moving(centre);
        let mass = arm.value(&format!("m{i}"));
        let inertia = ["Ixx", "Iyy", "Izz", "Ixy", "Ixz", "Iyz"].map(|name| arm.value(&format!("{name}{i}")));
        let mut forces = vec![[0.0, 0.0, -mass * g], scaled(link.acceleration, -mass)];
        let mut moments = vec![scaled(rate_of_momentum(&link, inertia), -1.0)];
        for (joint, sign) in [(joints.get(i), 1.0), (joints.get(i + 1), -1.0)] {
            let Some((place, force, moment)) = joint else { continue };
            let arm = add(*place, scaled(link.position, -1.0));
            forces.push(scaled(*force, sign));
            moments.push(scaled(add(*moment, cross(arm, *force)), sign));
        }
        balanced(&forces, &format!("force on link {i}"));
        balanced(&moments, &format!("moment on link {i}"));
    }
}

#[test]
fn reactions_balance_the_links_of_a_loop_and_what_the_plane_shares_is_named() {
    let cuts = ["crank@O", "coupler@A", "rocker@B", "C"];
    let places = [
        "crank@crank_centre",
        "coupler@coupler_centre",
        "rocker@rocker_centre",
        "crank@O",
        "coupler@A",
        "rocker@B",
        "rocker@C",
    ];
    let mut loop_of_four = Balance::new("fourbar", &places, &cuts);
    // Every link is kept in the plane by its own hinge and by the others. About its own line it is turned by its hinge
    // alone.
    for cut in &cuts[..3] {
        assert_eq!(loop_of_four.labels(cut), ["F_x", "F_y", "M_x", "M_z"], "{cut}");
    }
    assert_eq!(loop_of_four.labels("C"), ["F_x", "F_y"]);
    let answer = &loop_of_four.asking.program.answers;
    let doc = &answer.iter().find(|answer| answer.name == "reaction:crank@O").expect("asked").parts[0].doc;
    assert!(doc.contains("other joints hold F_z, M_y as well"), "{doc}");
    let g = loop_of_four.value("g");
    let drive = loop_of_four.input("T");
    // Force on the outer side at each joint along N's axes; the last acts on the ground.
    let mut joints = Vec::new();
    for (cut, at) in cuts.iter().zip(["crank@O", "coupler@A", "rocker@B", "rocker@C"]) {
        let at = loop_of_four.moving(at);
        let [fx, fy, _, mx, _, mz] = loop_of_four.reaction(cut);
        let force = if *cut == "C" { [fx, fy, 0.0] } else { at.turn.outward([fx, fy, 0.0]) };
        assert!(mx.abs().max(mz.abs()) <= BALANCE * (fx.abs() + fy.abs()), "{cut}: {mx:e} {mz:e}");
        joints.push((at.position, force));
    }
    for (i, place) in places[..3].iter().enumerate() {
        let link = loop_of_four.moving(place);
        let mass = loop_of_four.value(&format!("m{}", i + 1));
        let inertia = [0.0, 0.0, loop_of_four.value(&format!("I{}", i + 1)), 0.0, 0.0, 0.0];
        let mut forces = vec![[0.0, -mass * g, 0.0], scaled(link.acceleration, -mass)];
        let torque = [0.0, 0.0, if i == 0 { drive } else { 0.0 }];
        let mut moments = vec![torque, scaled(rate_of_momentum(&link, inertia), -1.0)];
        for ((place, force), sign) in [(joints[i], 1.0), (joints[i + 1], -1.0)] {
            let arm = add(place, scaled(link.position, -1.0));
            forces.push(scaled(force, sign));
            moments.push(scaled(cross(arm, force), sign));
        }
        balanced(&forces, &format!("force on {place}"));
        balanced(&moments, &format!("moment on {place}"));
    }
}

#[test]
fn reactions_balance_the_tile() {
    let legs = ["A", "B", "C"];
    let connectors = legs.map(|leg| format!("connector{leg}@P{leg}"));
    let screws = legs.map(|leg| format!("P{leg}"));
    let ends = legs.map(|leg| format!("G{leg}"));
    let cuts: Vec<&str> = connectors.iter().chain(&screws).chain(&ends).map(String::as_str).collect();
    let places: Vec<&str> = connectors.iter().map(String::as_str).chain(["platform@G"]).collect();
    let mut tile = Balance::new("tile", &places, &cuts);
    let g = tile.value("g");
    let platform = tile.moving("platform@G");
    let mass = tile.value("M");
    let mut on_platform = vec![[0.0, 0.0, -mass * g], scaled(platform.acceleration, -mass)];
    let inertia = |names: [&str; 3], tile: &Balance| {
        let [x, y, z] = names.map(|name| tile.value(name));
        [x, y, z, 0.0, 0.0, 0.0]
    };
    let mut turning = vec![scaled(rate_of_momentum(&platform, inertia(["Ix", "Iy", "Iz"], &tile)), -1.0)];
    for (leg, name) in legs.iter().enumerate() {
        let connector = tile.moving(&connectors[leg]);
        let joint = tile.reaction(&connectors[leg]);
        assert_eq!(tile.labels(&connectors[leg]).len(), 6);
        let force = connector.turn.outward(vector(&joint));
        let moment = connector.turn.outward(vector(&joint[3..]));
        // The end of the rod, where it reaches the platform's centre.
        let end = vector(&tile.reaction(&ends[leg]));
        let mc = tile.value("mc");
        let weight = |mass: f64| [0.0, 0.0, -mass * g];
        let inert = |mass: f64| scaled(connector.acceleration, -mass);
        balanced(&[force, scaled(end, -1.0), weight(mc), inert(mc)], &format!("force on connector {name}"));
        on_platform.push(end);
        // A screw: its guide, the drive with its friction, the connector on it.
        let guide = vector(&tile.reaction(&screws[leg]));
        let place =
            tile.asking.program.u.iter().position(|u| u.name == format!("u_h{name}")).expect("a speed");
        let drive = tile.input(&format!("F{name}")) - tile.value("c") * tile.state.u[place];
        let (ms, mr) = (tile.value("ms"), tile.value("mr"));
        let terms = [guide, [0.0, 0.0, drive], scaled(force, -1.0), weight(ms), inert(ms + mr)];
        balanced(&terms, &format!("force on screw {name}"));
        assert!(
            guide[2].abs() <= BALANCE * drive.abs().max(force[2].abs()),
            "the guide is free along the screw"
        );
        // Platform and connectors together turn by what the screws give the connectors.
        let arm = add(connector.position, scaled(platform.position, -1.0));
        turning.extend([moment, cross(arm, add(add(force, weight(mc)), inert(mc)))]);
        turning.push(scaled(rate_of_momentum(&connector, inertia(["Ic1", "Ic2", "Ic3"], &tile)), -1.0));
    }
    balanced(&on_platform, "force on the platform");
    balanced(&turning, "moment on platform and connectors");
}

#[test]
fn cuts_that_part_nothing_are_refused() {
    let refused = |model: &str, of: &str| {
        let asked = Asked::only(vec![Function::single(Request::of("reaction", of))]);
        let model = shipped(model);
        let found =
            program::derive_asked(&model, &ParameterChoice::default(), program::Settings::default(), &asked);
        found.expect_err(of).to_string()
    };
    for (model, of, message) in [
        ("arm6", "link2", "a reaction needs the joint's point"),
        ("arm6", "link2@C2", "moves with `link2`"),
        ("arm6", "link2@J1", "does not start from `J1`"),
        ("fourbar", "crank@A", "moves with `crank`"),
        ("tile", "platform", "no reaction can be computed at `G`"),
        ("tile", "connectorA@PB", "does not start from `PB`"),
        ("tile_minimal", "PA", "closed form, which does not hold once a joint is released"),
    ] {
        let found = refused(model, of);
        assert!(found.contains(message), "{model} {of}: {found}");
    }
}

/// By `tests/reference/tile_loads.py`, in 70 digits from the geometry alone: heights (0.03, 0.01, -0.01) m.
const IN_MOTION: [f64; 3] = [9.530457602671612, 10.518212244824523, 9.44280800342392];
const AT_REST: [f64; 3] = [9.432629464834347, 10.564741070331303, 9.432629464834347];
const LEGS_AT_REST: [Vector; 3] = [
    [-1.0750385698127929, -1.862021423011939, 9.432629464834347],
    [-1.0750385698127929, 1.862021423011939, 10.564741070331303],
    [2.150077139625586, 0.0, 9.432629464834347],
];

/// A model of the tile at its start, with the thrusts of its screws and the loads of its guides as answers.
fn at_start(name: &str) -> (Asking, State) {
    let requests = ["inverse_dynamics", "law", "rates", "reaction:PA", "reaction:PB", "reaction:PC"];
    let requests: Vec<Request> = requests.iter().map(|text| text.parse().expect("a request")).collect();
    let asked = Asked::besides(vec![Function { name: "answers".to_owned(), requests }]);
    let (choice, settings) = (ParameterChoice::default(), program::Settings::default());
    let program = program::derive_asked(&shipped(name), &choice, settings, &asked)
        .unwrap_or_else(|found| panic!("{found}"));
    let program::Start { q, u } = program.start().expect("it can be assembled");
    let state = State { t: 0.0, q, u, inputs: vec![0.0; 3], u_dot: vec![0.0; 3] };
    (Asking { state: state.clone(), engine: Interpreted::new(&program), program }, state)
}

#[test]
fn thrusts_of_the_moving_tile_are_those_of_its_geometry() {
    let (mut tile, start) = at_start("tile_inverse");
    let moving = State { u_dot: vec![0.1, -0.05, 0.02], ..start.clone() };
    close(&tile.part(&moving, "inverse_dynamics", "inputs"), &IN_MOTION, 1e-12, "in motion");
    let resting = State { u: vec![0.0; 3], ..start };
    close(&tile.part(&resting, "inverse_dynamics", "inputs"), &AT_REST, 1e-12, "at rest");
}

/// Its law gives the thrusts for zero acceleration; the guides carry all other components of the reactions.
#[test]
fn reactions_of_the_resting_tile_are_those_of_its_geometry() {
    let (mut tile, mut start) = at_start("tile_reactions");
    start.inputs = tile.part(&start, "law", "inputs");
    close(&start.inputs, &AT_REST, 1e-12, "the law");
    let accelerations = tile.part(&start, "rates", "u_dot");
    assert!(accelerations.iter().all(|a| a.abs() < 1e-12 * 9.81), "{accelerations:?}");
    for (leg, expected) in ["PA", "PB", "PC"].iter().zip(LEGS_AT_REST) {
        let found = tile.part(&start, &format!("reaction:{leg}"), "reaction");
        close(&found, &[expected[0], expected[1], 0.0], 1e-12, leg);
    }
}
