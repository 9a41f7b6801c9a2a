//! Closed loops: what the derivation finds by itself to keep their equations short.

use smartbed_codegen::ParameterChoice;
use smartbed_codegen::expr::Dag;
use smartbed_codegen::id::{Id, IdVec};
use smartbed_codegen::kinematics::{self, Kinematics, eliminate};
use smartbed_codegen::model::{Axis, Model};
use smartbed_codegen::vector::{Triads, Turn, Vector};

use crate::models::shipped;

fn derived(name: &str) -> (Model, Kinematics) {
    let model = shipped(name);
    let k = kinematics::derive(&model, &ParameterChoice::default()).unwrap_or_else(|e| panic!("{e}"));
    (model, k)
}

fn names<'a>(k: &'a Kinematics, unknowns: impl Iterator<Item = &'a kinematics::UnknownId>) -> Vec<&'a str> {
    unknowns.map(|&u| k.unknowns[u].name.as_str()).collect()
}

#[test]
fn a_point_is_reached_the_shorter_way_round_a_loop() {
    let (model, k) = derived("fourbar");
    let speeds = |name: &str| {
        let (id, _) = model.points.enumerate().find(|(_, p)| p.name == name).expect(name);
        names(&k, k.velocities[id].partials.keys())
    };
    assert_eq!(speeds("rocker_centre"), ["u3"]);
    assert_eq!(speeds("coupler_centre"), ["u1", "u2"]);
}

#[test]
fn a_leg_across_its_rod_is_free_of_its_slide() {
    let (model, mut k) = derived("tile");
    let mut table = eliminate::sample_table(&model, &k);
    let solution = eliminate::solve(&model, &mut k, &mut table).unwrap_or_else(|e| panic!("{e}"));
    for (closure, height) in [("G closure 2", "u_hB"), ("G closure 3", "u_hC")] {
        let across = [height, "w_platform_z", "v_G_x", "v_G_y"];
        let found = solution
            .rows
            .iter()
            .any(|row| row.name == closure && names(&k, row.coefficients.keys()) == across);
        assert!(found, "{closure}");
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

#[test]
fn constraints_and_not_derivatives_give_the_speeds_of_closed_forms() {
    let (model, k) = derived("tile_minimal");
    assert_eq!(k.closed_forms.len(), 9);
    let forms = ["u_psiA", "u_thA", "u_sA"];
    assert!(k.rows.iter().all(|row| !forms.contains(&row.name.as_str())), "no row needs a derivative");
    assert!(k.residuals.is_empty(), "the forms solve the constraints");
    // Without constraints the derivatives of the forms are all there is.
    let (closed, k) = derived("slider_crank_closed");
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
