//! Chains and trees: the forces between mass centres as unknowns against the mass matrix, and their operations.

use crate::augmented::{agree, with_augmented};
use smartbed_codegen::expr::{Binary, Dependence, ExprId, Node};
use smartbed_codegen::{Effort, Interpreted, Optimise, Program, Settings, model};
use smartbed_runtime::mechanism::Mechanism;
use std::fmt::Write;

fn derived(text: &str) -> Program {
    derived_with(text, Settings::default())
}

fn derived_with(text: &str, settings: Settings) -> Program {
    let model = model::parse("chain.toml", text).unwrap_or_else(|e| panic!("{e}"));
    with_augmented(&model, settings)
}

/// n point masses on massless rods, absolute angles from the downward vertical.
fn pendulum(n: usize) -> String {
    let mut text = format!(
        "format = 1\nname = \"pendulum{n}\"\ndof = {n}\ngravity = \"-g*N.y\"\n[parameters]\n\
         g = {{ value = 9.81, unit = \"m/s^2\" }}\n"
    );
    for (i, above) in (0..n).map(|i| (i, if i == 0 { "O".to_owned() } else { format!("P{}", i - 1) })) {
        let mass = masses(n)[i];
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

/// The text with the positions of all masses as outputs.
fn with_positions(text: &str, n: usize) -> String {
    let lines: String = (0..n)
        .map(|i| format!("x{i} = \"dot(P{i}, N.x)\"\ny{i} = \"dot(P{i}, N.y)\"\nz{i} = \"dot(P{i}, N.z)\"\n"))
        .collect();
    format!("{text}[outputs]\n{lines}")
}

/// Kinetic energy is sum 1/2 m v^2 with velocities from differences of positions, and the total energy is constant:
/// detects errors that mass matrix and accelerations have in common.
fn check_energy(program: &Program, masses: &[f64]) {
    /// Step of central differences (s), and their tolerance.
    const STEP: f64 = 1e-5;
    const ROUNDING: f64 = 1e-7;
    let mut mechanism = Interpreted::<f64>::new(program);
    for round in 0..5 {
        let number = |i: usize| (0.9 * (i + 1) as f64 + 1.3 * f64::from(round)).sin();
        let q: Vec<f64> = (0..program.q.len()).map(number).collect();
        let u: Vec<f64> = (0..program.u.len()).map(|i| number(i + 40)).collect();
        let (mut q_dot, mut u_dot) = (q.clone(), u.clone());
        mechanism.rates(0.0, &q, &u, &[], &mut q_dot, &mut u_dot).expect("lengths fit");
        let moved = |x: &[f64], rate: &[f64], h: f64| -> Vec<f64> {
            x.iter().zip(rate).map(|(x, r)| x + h * r).collect()
        };
        let [before, after] = [-STEP, STEP].map(|h| (moved(&q, &q_dot, h), moved(&u, &u_dot, h)));
        let places = [&before, &after].map(|(q, u)| mechanism.outputs(0.0, q, u, &[]).expect("lengths fit"));
        let speeds = places[0].iter().zip(&places[1]).map(|(a, b)| (b - a) / (2.0 * STEP));
        let squares = speeds.map(|v| v * v).collect::<Vec<_>>();
        let expected: f64 = squares.chunks(3).zip(masses).map(|(v, m)| 0.5 * m * v.iter().sum::<f64>()).sum();
        let (kinetic, _) = mechanism.energy(&q, &u).expect("lengths fit");
        assert!((kinetic - expected).abs() < ROUNDING * (1.0 + expected), "{kinetic} {expected}");
        let total = [&before, &after].map(|(q, u)| {
            let (kinetic, potential) = mechanism.energy(q, u).expect("lengths fit");
            kinetic + potential
        });
        let gain = (total[1] - total[0]) / (2.0 * STEP);
        assert!(gain.abs() < ROUNDING * (1.0 + 10.0 * total[0].abs()), "{gain} W of {} J", total[0]);
    }
}

/// Masses of [`pendulum`].
fn masses(n: usize) -> Vec<f64> {
    (0..n).map(|i| 1.0 + 0.1 * (i % 3) as f64).collect()
}

/// Pivots of parameters alone are compared when a parameter changes, and still watched: with a mass of 0 the equations
/// are singular at every configuration.
#[test]
fn pivots_of_parameters_alone_are_compared_once() {
    let program = derived(&pendulum(10));
    let is_minimum = |id: &ExprId| matches!(program.dag.node(*id), Node::Binary(Binary::Min, ..));
    let minima = program.dag.reachable(&[program.rates.worst_pivot]).into_iter().filter(is_minimum);
    let (varying, fixed): (Vec<_>, Vec<_>) =
        minima.partition(|&id| program.dag.dependence(id) == Dependence::State);
    assert!(varying.len() <= 9 && fixed.len() >= 9, "{} {}", varying.len(), fixed.len());
    let mut mechanism = Interpreted::<f64>::new(&program);
    let nominal: Vec<f64> = program.parameters.iter().map(|p| p.value).collect();
    let q: Vec<f64> = (0..10).map(|i| 0.3 * f64::from(i)).collect();
    let mut pivot = |parameters: &[f64]| {
        mechanism.set_parameters(parameters);
        mechanism.rates(0.0, &q, &[0.1; 10], &[], &mut [0.0; 10], &mut [0.0; 10]).expect("lengths fit")
    };
    assert!(pivot(&nominal) > 0.01);
    for name in ["m0", "m4", "m9", "l0", "l9"] {
        let mut singular = nominal.clone();
        singular[program.parameters.iter().position(|p| p.name == name).expect(name)] = 0.0;
        let found = pivot(&singular);
        println!("{name} = 0: {found:e}");
        assert!(found.is_nan() || found.abs() < 1e-12, "{name} = 0: {found:e}");
    }
    assert!(pivot(&nominal) > 0.01);
}

/// Operations of a chain grow linearly: every link costs the same.
#[test]
fn operations_are_linear_in_the_number_of_links() {
    /// Of a link: angle difference, sine and cosine, centripetal acceleration, a row of a tridiagonal system,
    /// and the angular acceleration.
    const OF_A_LINK: usize = 20;
    /// A hand derivation of ten links takes some 340.
    const OF_TEN_LINKS: usize = 190;
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
        let program = derived(&with_positions(&pendulum(n), n));
        assert!(is_chain(&program));
        check(&program);
        check_energy(&program, &masses(n));
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

/// Seven rods: the chain is shorter, but divides more often; twelve: it is shorter and faster. Without the value
/// graph, which comes after the choice.
#[test]
fn forms_are_chosen_by_operations_or_by_time() {
    for (n, faster) in [(7, false), (12, true)] {
        let [short, fast] = [Optimise::Operations, Optimise::Time]
            .map(|optimise| derived_with(&rods(n), Settings { optimise, effort: Effort::None }));
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
    let mut text = pendulum(8).replace("mass = \"m2\"", "mass = \"m2\"\nweight = false");
    for i in 0..8 {
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
    let program = derived(&with_positions(&text, 7));
    assert!(is_chain(&program));
    check(&program);
    let mut masses = masses(7);
    masses[4] += 2.0 * masses[0];
    check_energy(&program, &masses);
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
    let program = derived(&with_positions(&text, 3));
    check(&program);
    check_energy(&program, &masses(3));
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

/// Point masses on rods that hang on hinges about x, y and z in turn.
fn hinges(n: usize) -> String {
    let mut text = format!(
        "format = 1\nname = \"hinges{n}\"\ndof = {n}\ngravity = \"-g*N.z\"\n[parameters]\n\
         g = {{ value = 9.81, unit = \"m/s^2\" }}\n"
    );
    for i in 0..n {
        let (point, frame) = match i {
            0 => ("O".to_owned(), "N".to_owned()),
            _ => (format!("P{}", i - 1), format!("rod{}", i - 1)),
        };
        let (axis, mass) = (["x", "y", "z"][i % 3], masses(n)[i]);
        write!(
            text,
            "[coordinates.q{i}]\nunit = \"rad\"\nnominal = 0.1\nrange = [-1, 1]\n\
             [frames.rod{i}]\nparent = \"{frame}\"\nrotations = [[\"{axis}\", \"q{i}\"]]\n\
             [points.P{i}]\nposition = \"{point} - 0.1_m*rod{i}.z + 0.02_m*rod{i}.x\"\n\
             [bodies.mass{i}]\ncentre = \"P{i}\"\nmass = \"{mass}_kg\"\n"
        )
        .expect("a string grows");
    }
    text
}

/// D'Alembert's principle by differences of the masses' places alone: sum m (a - g) . dP/dq = 0 for every coordinate.
#[test]
fn forty_hinges_in_space() {
    /// Step of the differences, and their tolerance relative to the terms of the sum.
    const STEP: f64 = 1e-4;
    const DIFFERENCES: f64 = 1e-5;
    /// Nodes that the derivation makes: it had made 416,000 for half as many links, and many millions for all.
    const NODES: usize = 300_000;
    let n = 40;
    let program = derived(&with_positions(&hinges(n), n));
    assert!(program.dag.len() < NODES, "{} nodes", program.dag.len());
    let mut mechanism = Interpreted::<f64>::new(&program);
    let number = |i: usize| (0.9 * (i + 1) as f64).sin();
    let q: Vec<f64> = (0..n).map(number).collect();
    let u: Vec<f64> = (0..n).map(|i| number(i + 40)).collect();
    let (mut q_dot, mut u_dot) = (q.clone(), u.clone());
    mechanism.rates(0.0, &q, &u, &[], &mut q_dot, &mut u_dot).expect("lengths fit");
    let mut places = |q: &[f64]| mechanism.outputs(0.0, q, &u, &[]).expect("lengths fit");
    let along = |h: f64| -> Vec<f64> {
        q.iter().zip(&u).zip(&u_dot).map(|((q, u), a)| q + h * u + 0.5 * h * h * a).collect()
    };
    // Second differences with steps h and 2 h, extrapolated.
    let [far, before, here, after, farther] =
        [-2.0, -1.0, 0.0, 1.0, 2.0].map(|steps| places(&along(steps * STEP)));
    let forces: Vec<f64> = (0..3 * n)
        .map(|i| {
            let [near, wide] = [before[i] + after[i], far[i] + farther[i]].map(|sum| sum - 2.0 * here[i]);
            let acceleration = (16.0 * near - wide) / (12.0 * STEP * STEP);
            let gravity = if i % 3 == 2 { -9.81 } else { 0.0 };
            masses(n)[i / 3] * (acceleration - gravity)
        })
        .collect();
    for k in 0..n {
        let moved = |h: f64| q.iter().enumerate().map(|(i, q)| q + if i == k { h } else { 0.0 }).collect();
        let [less, more]: [Vec<f64>; 2] = [-STEP, STEP].map(moved);
        let (less, more) = (places(&less), places(&more));
        let terms = forces.iter().zip(more.iter().zip(&less)).map(|(f, (a, b))| f * (a - b) / (2.0 * STEP));
        let (sum, size) = terms.fold((0.0, 0.0), |(sum, size): (f64, f64), x| (sum + x, size + x.abs()));
        assert!(sum.abs() <= DIFFERENCES * size, "q{k}: {sum:e} of terms {size:e}");
    }
}

/// Forces are divided by the masses that they move: without one of these the chain's equations are singular.
#[test]
fn a_chain_watches_its_masses() {
    let program = derived(&pendulum(5));
    assert!(is_chain(&program));
    let mut mechanism = Interpreted::<f64>::new(&program);
    let (q, u) = (vec![0.3; program.q.len()], vec![0.1; program.u.len()]);
    let mut pivot = |mass: f64| {
        let values: Vec<f64> =
            program.parameters.iter().map(|p| if p.name == "m2" { mass } else { p.value }).collect();
        mechanism.set_parameters(&values);
        let (mut q_dot, mut u_dot) = (q.clone(), u.clone());
        mechanism.rates(0.0, &q, &u, &[], &mut q_dot, &mut u_dot).expect("lengths fit")
    };
    assert!(pivot(1.0) > 0.1 && pivot(1e-9) < 1e-8);
}
