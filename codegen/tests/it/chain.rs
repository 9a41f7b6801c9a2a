//! Chains and trees: the forces between mass centres as unknowns against the mass matrix, and their operations.

use crate::augmented::agree;
use smartbed_codegen::{Optimise, ParameterChoice, Program, Settings, model, program};
use std::fmt::Write;

fn derived(text: &str) -> Program {
    derived_for(text, Optimise::Operations)
}

fn derived_for(text: &str, optimise: Optimise) -> Program {
    let model = model::parse("chain.toml", text).unwrap_or_else(|e| panic!("{e}"));
    program::derive_with(&model, &ParameterChoice::default(), Settings { optimise })
        .unwrap_or_else(|e| panic!("{e}"))
}

/// n point masses on massless rods, absolute angles from the downward vertical.
fn pendulum(n: usize) -> String {
    let mut text = format!(
        "format = 1\nname = \"pendulum{n}\"\ndof = {n}\ngravity = \"-g*N.y\"\n[parameters]\n\
         g = {{ value = 9.81, unit = \"m/s^2\" }}\n"
    );
    for (i, above) in (0..n).map(|i| (i, if i == 0 { "O".to_owned() } else { format!("P{}", i - 1) })) {
        let mass = 1.0 + 0.1 * (i % 3) as f64;
        write!(
            text,
            "[parameters.m{i}]\nvalue = {mass}\nunit = \"kg\"\n[parameters.l{i}]\nvalue = 0.7\nunit = \"m\"\n\
             [coordinates.q{i}]\nunit = \"rad\"\nspeed = \"u{i}\"\nrange = [-3, 3]\n\
             [frames.rod{i}]\nparent = \"N\"\nrotations = [[\"z\", \"q{i}\"]]\n\
             [points.P{i}]\nposition = \"{above} - l{i}*rod{i}.y\"\n\
             [bodies.mass{i}]\ncentre = \"P{i}\"\nmass = \"m{i}\"\n"
        )
        .expect("a string grows");
    }
    text
}

/// Does u' go through transmitted forces?
fn is_chain(program: &Program) -> bool {
    let nodes = program.dag.reachable(&program.rates.u_dot);
    nodes.into_iter().any(|id| program.dag.name_of(id).is_some_and(|name| name.starts_with("force_")))
}

/// Compares with the mass matrix at several states.
fn check(program: &Program) {
    for round in 0..5 {
        let number = |i: usize| (1.7 * (i + 1) as f64 + 2.3 * f64::from(round)).sin();
        let q: Vec<f64> = (0..program.q.len()).map(|i| 2.0 * number(i)).collect();
        let u: Vec<f64> = (0..program.u.len()).map(|i| 3.0 * number(i + 40)).collect();
        let inputs: Vec<f64> = (0..program.inputs.len()).map(|i| 5.0 * number(i + 80)).collect();
        agree(program, &q, &u, &inputs);
    }
}

/// Operations of a chain grow linearly: every link costs the same.
#[test]
fn operations_are_linear_in_the_number_of_links() {
    /// Of a link: angle difference, sine and cosine, centripetal acceleration, a row of a tridiagonal system,
    /// and the angular acceleration.
    const OF_A_LINK: usize = 22;
    /// A hand derivation of ten links takes some 340.
    const OF_TEN_LINKS: usize = 210;
    let operations = [5, 10, 20, 40].map(|n| derived(&pendulum(n)).operations());
    println!("5, 10, 20, 40 links: {operations:?}");
    assert!(operations[1] <= OF_TEN_LINKS);
    for (pair, links) in operations.windows(2).zip([5, 10, 20]) {
        assert!(pair[1] - pair[0] <= OF_A_LINK * links, "{operations:?}");
    }
}

#[test]
fn point_masses_on_rods() {
    for n in [3, 5, 10] {
        let program = derived(&pendulum(n));
        assert!(is_chain(&program));
        check(&program);
    }
}

/// The coordinates stand in sines and cosines of differences only: whole turns may be taken off.
#[test]
fn angles_in_differences_are_angles() {
    let program = derived(&pendulum(4));
    assert!(program.q.iter().all(|q| q.is_angle));
}

/// Centres half-way along rods with inertia.
fn rods(n: usize) -> String {
    let mut text = pendulum(n);
    for i in 0..n {
        text = text
            .replace(&format!("position = \"P{i} - "), &format!("position = \"H{i} - "))
            .replace(&format!("- l{i}*rod{i}.y\""), &format!("- l{i}/2*rod{i}.y\""))
            .replace(
                &format!("mass = \"m{i}\""),
                &format!(
                    "mass = \"m{i}\"\nframe = \"rod{i}\"\ninertia = {{ Izz = \"m{i}*l{i}.powi(2)/12\" }}"
                ),
            );
        write!(text, "[points.H{i}]\nposition = \"P{i} - l{i}/2*rod{i}.y\"\n").expect("a string grows");
    }
    text
}

/// Five rods: the chain is shorter, but divides more often; ten: it is shorter and faster.
#[test]
fn forms_are_chosen_by_operations_or_by_time() {
    for (n, faster) in [(5, false), (10, true)] {
        let [short, fast] =
            [Optimise::Operations, Optimise::Time].map(|optimise| derived_for(&rods(n), optimise));
        assert!(is_chain(&short));
        assert_eq!(is_chain(&fast), faster, "{n} rods");
        assert!(short.operations() <= fast.operations());
        assert!(fast.dag.cycles(&fast.rates.u_dot) <= short.dag.cycles(&short.rates.u_dot));
        check(&short);
        check(&fast);
    }
}

/// Rods with inertia, a spring to the ground, a force and a torque, one body without weight.
#[test]
fn rods_with_inertia_and_loads() {
    let mut text = pendulum(6).replace("mass = \"m2\"", "mass = \"m2\"\nweight = false");
    for i in 0..6 {
        text = text.replace(
            &format!("mass = \"m{i}\""),
            &format!("mass = \"m{i}\"\nframe = \"rod{i}\"\ninertia = {{ Izz = \"0.02*m{i}*l{i}.powi(2)\" }}"),
        );
    }
    text.push_str(
        "[parameters.k]\nvalue = 200\nunit = \"N/m\"\n[parameters.c]\nvalue = 2\nunit = \"N s/m\"\n\
         [points.A]\nposition = \"l0*N.x\"\n[inputs]\nF = { unit = \"N\" }\nT = { unit = \"N m\" }\n\
         [forces]\nwind = { point = \"P1\", force = \"F*N.x\" }\n\
         [torques]\nmotor = { frame = \"rod2\", torque = \"T*N.z\", reaction = \"rod1\" }\n\
         [springs]\nrope = { between = [\"A\", \"P3\"], stiffness = \"k\", rest_length = \"l0/2\", damping = \"c\" }\n",
    );
    let program = derived(&text);
    assert!(is_chain(&program));
    check(&program);
}

/// Two chains hang from the end of a third, and one centre carries two bodies.
#[test]
fn a_tree_of_point_masses() {
    let text = pendulum(7)
        .replace("\"P4 - l5", "\"P2 - l5")
        .replace("[bodies.mass4]", "[bodies.twin]\ncentre = \"P4\"\nmass = \"2*m0\"\n[bodies.mass4]");
    let program = derived(&text);
    assert!(is_chain(&program));
    check(&program);
}

/// Rods that swing in space: two angles each, cosines of the second in the pivots.
#[test]
fn rods_in_space() {
    let mut text = pendulum(3).replace("dof = 3", "dof = 6");
    for i in 0..3 {
        text = text.replace(
            &format!("rotations = [[\"z\", \"q{i}\"]]"),
            &format!("rotations = [[\"z\", \"q{i}\"], [\"x\", \"p{i}\"]]"),
        );
        write!(text, "[coordinates.p{i}]\nunit = \"rad\"\nrange = [-1, 1]\n").expect("a string grows");
    }
    check(&derived(&text));
}

/// Speeds that are relative from body to body: the mass matrix stays.
#[test]
fn relative_angles() {
    let mut text = pendulum(4);
    for i in 1..4 {
        let (before, parent) = (format!("[frames.rod{i}]\nparent = \"N\""), i - 1);
        text = text.replace(&before, &format!("[frames.rod{i}]\nparent = \"rod{parent}\""));
    }
    check(&derived(&text));
}
