//! Closed loops: simplifications that the derivation finds automatically.

use smartbed_codegen::expr::{Dag, ExprId, SymbolId};
use smartbed_codegen::id::{Id, IdVec};
use smartbed_codegen::kinematics::{self, Kinematics, Row, eliminate, sampling};
use smartbed_codegen::model::{Axis, Model};
use smartbed_codegen::vector::{Algebra, Triads, Turn, Vector};
use smartbed_codegen::{Interpreted, Optimise, ParameterChoice, Program, model, program};
use smartbed_runtime::mechanism::Mechanism;
use std::collections::HashMap;
use std::path::Path;

use crate::models::shipped;

fn derived(name: &str) -> (Model, Algebra, Kinematics) {
    let model = shipped(name);
    let (alg, k) = kinematics::derive(&model, &ParameterChoice::default(), Optimise::default())
        .unwrap_or_else(|e| panic!("{e}"));
    (model, alg, k)
}

fn names<'a>(k: &'a Kinematics, unknowns: impl Iterator<Item = &'a kinematics::UnknownId>) -> Vec<&'a str> {
    unknowns.map(|&u| k.unknowns[u].name.as_str()).collect()
}

#[test]
fn a_point_is_reached_the_shorter_way_round_a_loop() {
    let (model, _, k) = derived("fourbar");
    let speeds = |name: &str| {
        let (id, _) = model.points.enumerate().find(|(_, p)| p.name == name).expect(name);
        names(&k, k.velocities[id].partials.keys())
    };
    assert_eq!(speeds("rocker_centre"), ["u3"]);
    assert_eq!(speeds("coupler_centre"), ["u1", "u2"]);
}

#[test]
fn a_leg_across_its_rod_is_free_of_its_slide() {
    let (model, mut alg, k) = derived("tile");
    let mut table = sampling::sample_table(&alg, &model, &k);
    let solution = eliminate::solve(&mut alg, &model, &k, &mut table).unwrap_or_else(|e| panic!("{e}"));
    // Resolved along the leg and across: offered always, taken where it is the cheaper choice.
    for (closure, height) in [("G closure 1", "u_hA"), ("G closure 2", "u_hB"), ("G closure 3", "u_hC")] {
        let slide = height.replace("u_h", "u_s");
        let across = |row: &&Row| {
            let speeds = names(&k, row.coefficients.keys());
            row.name == closure && speeds.contains(&height) && !speeds.contains(&slide.as_str())
        };
        assert!(k.rows.iter().filter(across).count() >= 2, "{closure}");
    }
    // Every dependent unknown has one step, by unknowns that come later and independent speeds.
    let mut eliminated = Vec::new();
    for step in &solution.steps {
        eliminated.push(step.unknown);
        assert!(
            step.coefficients.keys().all(|u| !eliminated.contains(u)),
            "{}",
            k.unknowns[step.unknown].name
        );
    }
    assert_eq!(eliminated.len(), k.unknowns.len() - 3);
}

/// The tile with connectors of three different moments of inertia, in frames of their own or in copies of
/// them, of which nothing says that an axis is fixed in the platform.
fn tile_with_connectors_in(frame: &str) -> Program {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../models/tile.toml");
    let text = std::fs::read_to_string(path).expect("the tile");
    let rotations = r#"{ parent = "screw{leg}", rotations = [["z", "psi{leg}"], ["y", "th{leg}"]] }"#;
    let text = text
        .replace("[repeat.leg.frames]", &format!("[repeat.leg.frames]\n\"copy{{leg}}\" = {rotations}"))
        .replace(r#"frame = "connector{leg}""#, &format!(r#"frame = "{frame}{{leg}}""#))
        .replace("Ic1 = { value = 1e-4", "Ic1 = { value = 2e-3")
        .replace("Ic2 = { value = 1e-4", "Ic2 = { value = 7e-3")
        .replace("Ic3 = { value = 2e-4", "Ic3 = { value = 4e-3");
    let model = model::parse("tile.toml", &text).unwrap_or_else(|e| panic!("{e}"));
    program::derive(&model, &ParameterChoice::default()).unwrap_or_else(|e| panic!("{e}"))
}

#[test]
fn inertia_across_a_shared_axis_moves_with_the_frame_that_shares_it() {
    let [handed, own] = ["connector", "copy"].map(tile_with_connectors_in);
    assert!(handed.operations() + 50 < own.operations(), "{} {}", handed.operations(), own.operations());
    let (u, inputs) = ([0.7, -0.4, 0.9], [30.0, 10.0, 25.0]);
    for heights in [[0.0; 3], [0.05, -0.08, 0.02], [-0.11, 0.1, 0.06]] {
        let mut q = handed.nominal.clone();
        for _ in 0..4 {
            heights.iter().enumerate().for_each(|(leg, h)| q[4 * leg] += 0.25 * h);
            handed.assembly.clone().correct(&mut q).unwrap_or_else(|_| panic!("in small steps"));
        }
        let answers = [&handed, &own].map(|program| {
            let mut mechanism = Interpreted::<f64>::new(program);
            let (mut q_dot, mut u_dot) = ([0.0; 12], [0.0; 3]);
            mechanism.rates(0.0, &q, &u, &inputs, &mut q_dot, &mut u_dot).expect("lengths fit");
            let (kinetic, _) = mechanism.energy(&q, &u).expect("lengths fit");
            [u_dot[0], u_dot[1], u_dot[2], kinetic]
        });
        for (a, b) in answers[0].iter().zip(&answers[1]) {
            assert!((a - b).abs() < 1e-12 * b.abs().max(1.0), "{heights:?}: {answers:?}");
        }
    }
}

#[test]
fn constraints_and_not_derivatives_give_the_speeds_of_closed_forms() {
    let (model, _, k) = derived("tile_minimal");
    assert_eq!(k.closed_forms.len(), 12);
    let forms = ["u_psiA", "u_thA", "u_sA"];
    assert!(k.rows.iter().all(|row| !forms.contains(&row.name.as_str())), "no row needs a derivative");
    assert!(k.residuals.is_empty(), "the forms solve the constraints");
    // Without constraints the derivatives of the forms are all there is.
    let (closed, _, k) = derived("slider_crank_closed");
    assert!(k.rows.iter().any(|row| row.name == "u_b") && k.rows.iter().any(|row| row.name == "u_x"));
    assert_eq!((model.dof.map(|d| d.0), closed.dof.map(|d| d.0)), (Some(3), Some(1)));
}

#[test]
fn products_along_axes_share_one_cosine() {
    let mut dag = Dag::default();
    let mut triads = Triads::default();
    let inertial = triads.push(Turn::Inertial);
    let [p, q, a, b, c] = ["p", "q", "a", "b", "c"].map(|name| dag.symbol(name));
    let turned =
        |triads: &mut Triads, angle| triads.push(Turn::Simple { parent: inertial, axis: Axis::Z, angle });
    let (first, second) = (turned(&mut triads, p), turned(&mut triads, q));
    let along = |dag: &mut Dag, triad, size| Vector::axis(dag, triad, Axis::X).scaled(dag, size);
    let (va, vb, vc) = (along(&mut dag, first, a), along(&mut dag, second, b), along(&mut dag, second, c));
    let (ab, ac) = (triads.dot(&mut dag, &va, &vb), triads.dot(&mut dag, &va, &vc));
    // Two sines, two cosines, the cosine of the difference in three, and two products each.
    assert_eq!(dag.cone_cost(&[ab, ac]), 4 + 3 + 2 + 2);
    let values: IdVec<smartbed_codegen::expr::SymbolId, f64> =
        [0.3, 1.1, 2.0, 3.0, 5.0].into_iter().collect();
    let found = dag.evaluate::<f64>(&[ab, ac], &|s| values[Id::from_index(s.index())]);
    let cosine = (0.3_f64 - 1.1).cos();
    assert!((found[0] - 6.0 * cosine).abs() < 1e-14 && (found[1] - 10.0 * cosine).abs() < 1e-14);
}

/// A sine or cosine whose square is also a pivot is left out of the minimum; the result must not change.
#[test]
fn the_worst_pivot_is_the_smallest_of_all() {
    let program =
        program::derive(&shipped("tile"), &ParameterChoice::default()).unwrap_or_else(|e| panic!("{e}"));
    let roots: Vec<ExprId> =
        [program.rates.worst_pivot].into_iter().chain(program.pivots.iter().map(|p| p.value)).collect();
    for k in 0..50 {
        let mut values: HashMap<SymbolId, f64> =
            program.parameters.iter().map(|p| (p.symbol, p.value)).collect();
        for (i, q) in program.q.iter().enumerate() {
            values.insert(q.symbol, q.value + 0.5 * f64::from(k * 13).sin() * (i as f64 + 1.0).cos());
        }
        let found = program.dag.evaluate::<f64>(&roots, &|symbol| values[&symbol]);
        let relative = program.pivots.iter().zip(&found[1..]).map(|(pivot, x)| x.abs() / pivot.nominal);
        let smallest = relative.fold(f64::INFINITY, f64::min);
        assert!((found[0] - smallest).abs() <= 1e-12 * smallest, "{k}: {} {smallest}", found[0]);
    }
}

/// In a chain that is solved for the forces between its links too.
#[test]
fn what_a_chain_divides_by_is_watched() {
    for name in ["pendulum3", "pendulum10", "arm6"] {
        let program =
            program::derive(&shipped(name), &ParameterChoice::default()).unwrap_or_else(|e| panic!("{e}"));
        let read = program.dag.symbols_of(program.rates.worst_pivot);
        assert!(program.q.iter().any(|q| read.contains(&q.symbol)), "{name}: its pivots vary with q");
    }
}

#[test]
fn a_fixed_vector_may_be_a_definition_that_nothing_else_needs() {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../models/tile.toml");
    let text = std::fs::read_to_string(path).expect("a model");
    let named = text.replace("{ vector = \"dA\",", "{ vector = \"rod\",");
    let named = named.replace("\n[definitions]\n", "\n[definitions]\nrod = \"dA\"\n");
    assert!(named.contains("\"rod\"") && named.contains("rod = "));
    let operations = |text: &str| {
        let model = model::parse("tile.toml", text).unwrap_or_else(|e| panic!("{e}"));
        let derived = program::derive(&model, &ParameterChoice::default()).unwrap_or_else(|e| panic!("{e}"));
        derived.operations()
    };
    assert_eq!(operations(&named), operations(&text));
}

/// A bracket fixed askew on an arm that turns about two axes, stated by its directions and by what is fixed in it:
/// twice along the sum of two axes of the arm, which is no axis of it.
#[test]
fn a_frame_stated_by_sums_of_axes_is_turned_by_half_a_right_angle() {
    let text = |bracket: &str| {
        format!(
            r#"
format = 1
name = "bracket"
dof = 2
gravity = "-g*N.z"

[parameters]
g = {{ value = 9.81, unit = "m/s^2" }}
m = {{ value = 2, unit = "kg" }}
a = {{ value = 0.1, unit = "m" }}

[coordinates]
q1 = {{ unit = "rad" }}
q2 = {{ unit = "rad" }}

[frames]
arm = {{ rotations = [["z", "q1"], ["y", "q2"]] }}
bracket = {{ {bracket} }}

[points]
P = "5*a*bracket.x + 2*a*bracket.y"

[bodies]
plate = {{ centre = "P", mass = "m", frame = "bracket", inertia = {{ Ixx = "5*m*a*a", Iyy = "10*m*a*a", Izz = "12*m*a*a", Ixy = "m*a*a" }} }}
"#
        )
    };
    let turned = text("parent = \"arm\", rotations = [[\"z\", \"pi/4\"]]");
    let stated = text(
        "x = \"(arm.x + arm.y)/sqrt(2)\", y = \"(arm.y - arm.x)/sqrt(2)\", z = \"arm.z\", fixed = [\
         { vector = \"arm.x + arm.y\", components = [\"sqrt(2)\", \"0\", \"0\"] }, \
         { vector = \"arm.y - arm.x\", components = [\"0\", \"sqrt(2)\", \"0\"] }, \
         { vector = \"arm.z\", components = [\"0\", \"0\", \"1\"] }]",
    );
    let [turned, stated] = [turned, stated].map(|text| {
        let model = model::parse("bracket.toml", &text).unwrap_or_else(|e| panic!("{e}"));
        program::derive(&model, &ParameterChoice::default()).unwrap_or_else(|e| panic!("{e}"))
    });
    for k in 0..100 {
        let at = |i: usize| 2.0 * ((7 * k + 3 * i) as f64).sin();
        let accelerations = |program: &Program| {
            let (mut q_dot, mut u_dot) = ([0.0; 2], [0.0; 2]);
            let (q, u) = ([at(0), at(1)], [at(2), at(3)]);
            let mut mechanism = Interpreted::<f64>::new(program);
            mechanism.rates(0.0, &q, &u, &[], &mut q_dot, &mut u_dot).expect("lengths fit");
            u_dot
        };
        let (one, other) = (accelerations(&turned), accelerations(&stated));
        let size = one[0].abs().max(one[1].abs());
        assert!((0..2).all(|i| (one[i] - other[i]).abs() <= 1e-12 * size), "{k}: {one:?} {other:?}");
    }
}
