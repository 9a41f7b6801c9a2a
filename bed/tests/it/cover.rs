//! Sensors mounted on sheets, against closed forms: weight, inertia, and thickness between sheet and tissue.

use crate::mesh::ball;
use crate::rest::four;
use crate::sheet::bed;
use smartbed_bed::body::mesh::Solid;
use smartbed_bed::body::{Body, Segment, Shape, Surface};
use smartbed_bed::dynamics::{Matter, Method, Motion};
use smartbed_bed::equilibrium::{Cover, GRAVITY, put_down, solve};
use smartbed_bed::pose::Pose;
use smartbed_bed::sheet::air::Air;
use std::sync::Arc;

/// Sensors of 0.5 g on squares of 10 mm (kg/m^2).
const DENSITY: f64 = 5.0;

#[test]
fn a_sheet_whose_air_bears_its_sensors_stays_flat() {
    let mut own = bed([8, 8], [0.225; 2], Air::Regulated(DENSITY * GRAVITY));
    own.cover = Cover { density: DENSITY, thickness: 0.0 };
    let found = solve(&own, &Body::default(), &own.start(Vec::new())).expect("rests");
    for (x, flat) in found.state.sheets[0].iter().zip(own.lattice.flat()) {
        // The flat sheet gives way with the cube of what is left over: 1e-8 of 1 kPa.
        assert!((x[2] - flat[2]).abs() < 2e-4, "{x:?}");
    }
    // Without them it bulges, with twice as many it sags by as much.
    let middle = |density: f64| {
        let own = smartbed_bed::equilibrium::Bed { cover: Cover { density, thickness: 0.0 }, ..own.clone() };
        let found = solve(&own, &Body::default(), &own.start(Vec::new())).expect("rests");
        found.state.sheets[0][40][2]
    };
    let [light, heavy] = [0.0, 2.0 * DENSITY].map(middle);
    // Pressure follows the sheet, weight does not: they differ with the slope squared.
    assert!(light > 5e-3 && (heavy / light + 1.0).abs() < 0.02, "{light} {heavy}");
}

#[test]
fn a_sheet_starts_as_fast_as_its_mass_and_that_of_its_sensors_allow() {
    let (pressure, step) = (200.0, 1e-5);
    let way = |cover: Cover| {
        let mut own = bed([8, 8], [0.225; 2], Air::Regulated(pressure));
        own.cover = cover;
        let mut state = own.start(Vec::new());
        state.sheets = vec![own.lattice.flat()];
        let still = own.clone();
        let matter = Matter { sheet_loss: 0.0, ..Matter::default() };
        let mut motion = Motion::new(own, Body::default(), state, matter, Method::Trapezoid, step);
        for _ in 0..100 {
            motion.step(|_| still.clone()).expect("steps");
        }
        (motion.now.state.sheets[0][40][2], motion.ledger.left_over())
    };
    for density in [0.0, DENSITY] {
        let (found, left) = way(Cover { density, thickness: 0.0 });
        // a = p/(rho + rho') - rho' g/(rho + rho') from rest for a millisecond.
        let mass = Matter::default().density + density;
        let expected = 0.5 * (pressure - density * GRAVITY) / mass * 1e-6;
        assert!((found / expected - 1.0).abs() < 0.02, "{density}: {found} {expected}");
        assert!(left.abs() < 1e-6, "{left}");
    }
}

#[test]
fn tissue_meets_sensors_as_it_would_a_sheet_nearer_by_their_thickness() {
    let rest = |shape: Surface, thickness: f64| {
        let segment = Segment {
            name: "ball".to_owned(),
            shape,
            mass: 12.0,
            centre: [0.0; 3],
            foundation: 1e6,
            free: [true; 6],
        };
        let mut own = four([8, 10], Air::Regulated(4000.0), 0.0);
        own.cover = Cover { density: 0.0, thickness };
        let body = Body::single(segment);
        let found = put_down(&own, &body, &own.start(vec![Pose::at([0.0, 0.0, 0.2])])).expect("rests");
        assert!(found.imbalance < 1e-6);
        found.state.segments[0].place[2]
    };
    // A ball grown by the thickness touches at the same depths along the same normals.
    let [covered, grown] = [rest(Shape::ball(0.14).into(), 0.01), rest(Shape::ball(0.15).into(), 0.0)];
    assert!((covered - grown).abs() < 1e-9, "{covered} {grown}");
    let (solid, _) = Solid::new(ball(0.14, 4)).expect("a solid");
    let meshed = rest(Surface::Mesh(Arc::new(solid)), 0.01);
    assert!((meshed - grown).abs() < 3e-4, "{meshed} {grown}");
}
