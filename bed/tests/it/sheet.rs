//! The bladder against closed forms, differences of itself, the runtime's forces and an independent static solve.

use crate::draw::Draw;
use smartbed_bed::body::{Body, Segment, Shape};
use smartbed_bed::equilibrium::{Bed, Cover, Solution, State, Tile, solve, stiffness};
use smartbed_bed::pose::Pose;
use smartbed_bed::sheet::air::{AMBIENT, Air};
use smartbed_bed::sheet::{Lattice, LatticeError, membrane};
use smartbed_runtime::flexible::Spring;
use smartbed_runtime::vec3::{add, norm};

const ET: f64 = 5000.0;

pub fn bed(intervals: [usize; 2], size: [f64; 2], air: Air) -> Bed {
    let lattice = Lattice::new(intervals, size, ET).expect("a sheet");
    Bed {
        lattice,
        depth: 0.1,
        tiles: vec![Tile { pose: Pose::at([0.0; 3]), air }],
        friction: 0.0,
        rubbing: 0.0,
        beside: Vec::new(),
        cover: Cover::default(),
    }
}

fn alone(bed: &Bed) -> Solution {
    solve(bed, &Body::default(), &bed.start(Vec::new())).expect("an equilibrium")
}

fn bulge(state: &State) -> f64 {
    state.sheets[0].iter().fold(0.0, |most: f64, x| most.max(x[2]))
}

/// Places near the flat sheet, from a fixed sequence.
fn shaken(lattice: &Lattice) -> Vec<[f64; 3]> {
    let mut draw = Draw(1);
    let mut next = || 0.5 * draw.next();
    lattice.bulged(0.03).into_iter().map(|x| add(x, [4e-3 * next(), 4e-3 * next(), 8e-3 * next()])).collect()
}

#[test]
fn the_square_bulges_as_computed() {
    let bed = bed([28, 28], [0.225, 0.225], Air::Regulated(4000.0));
    let found = bulge(&alone(&bed).state);
    assert!((found / 0.0378 - 1.0).abs() < 0.01, "{found}");
}

#[test]
fn the_bulge_grows_with_the_cube_root_of_a_small_pressure() {
    let at = |pressure: f64| bulge(&alone(&bed([28, 28], [0.225, 0.225], Air::Regulated(pressure))).state);
    for (low, high) in [(1.0, 10.0), (10.0, 100.0)] {
        let exponent = (at(high) / at(low)).ln() / f64::ln(high / low);
        assert!((exponent - 1.0 / 3.0).abs() < 0.01, "{exponent} from {low} to {high} Pa");
    }
}

#[test]
fn the_rectangle_agrees_with_an_independent_solve() {
    let text = std::fs::read_to_string("../tests/reference/bladder.json").expect("the reference");
    let reference: serde_json::Value = serde_json::from_str(&text).expect("JSON");
    let number = |key: &str| reference[key].as_f64().expect("a number");
    let bed = bed([14, 12], [0.2797, 0.219], Air::Regulated(number("pressure")));
    let solution = alone(&bed);
    assert!((bulge(&solution.state) / number("bulge") - 1.0).abs() < 1e-6, "{}", bulge(&solution.state));
    let volume = membrane::volume(&bed.lattice, &solution.state.sheets[0]);
    assert!((volume / number("volume") - 1.0).abs() < 1e-6, "{volume}");
    let node = solution.state.sheets[0][3 * 15 + 7];
    for (found, expected) in node.iter().zip(reference["quarter"].as_array().expect("three")) {
        assert!((found - expected.as_f64().expect("a number")).abs() < 1e-8, "{node:?}");
    }
}

#[test]
fn every_cell_is_an_isotropic_sheet() {
    // Uniform strains store E t/(2 (1 - nu^2)) (ex^2 + ey^2 + 2 nu ex ey) + G t g^2/2 per area, nu = 1/3.
    for (intervals, size) in [([8, 8], [0.2, 0.2]), ([10, 6], [0.2797, 0.219]), ([6, 9], [0.2, 0.2])] {
        let lattice = Lattice::new(intervals, size, ET).expect("a sheet");
        for [ex, ey, g] in
            [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [1.0, 1.0, 0.0], [0.0, 0.0, 1.0], [0.4, -0.3, 0.8]]
        {
            let h = 1e-6;
            let strained = |x: &[f64; 3]| [x[0] + h * (ex * x[0] + g * x[1]), x[1] + h * ey * x[1], 0.0];
            let places: Vec<_> = lattice.flat().iter().map(strained).collect();
            let found = membrane::energy(&lattice, &places) / (h * h * size[0] * size[1]);
            let plane: f64 = ex * ex + ey * ey + 2.0 / 3.0 * ex * ey;
            let expected = 0.5 * ET * (9.0 / 8.0 * plane + 3.0 / 8.0 * g * g);
            assert!((found / expected - 1.0).abs() < 1e-5, "{found} {expected} {intervals:?}");
        }
    }
    assert!(matches!(Lattice::new([4, 8], [0.2, 0.2], ET), Err(LatticeError::Aspect(r)) if r == 2.0));
    assert_eq!(Lattice::new([1, 8], [0.2, 0.2], ET), Err(LatticeError::Intervals(1)));
    assert!(Lattice::new([8, 8], [0.2, f64::NAN], ET).is_err());
}

#[test]
fn forces_are_the_runtimes() {
    let lattice = Lattice::new([9, 7], [0.25, 0.2], ET).expect("a sheet");
    let places = shaken(&lattice);
    let mut gradient = vec![[0.0; 3]; lattice.nodes()];
    membrane::add_gradient(&lattice, &places, &mut gradient);
    let mut force = vec![[0.0; 3]; lattice.nodes()];
    let mut energy = 0.0;
    for own in &lattice.springs {
        let [tail, head] = own.ends;
        let spring =
            Spring { tail, head, stiffness: own.stiffness, damping: 0.0, rest_length: own.rest_length };
        assert!(!spring.add_elastic(&places, &mut force));
        energy += spring.energy(&places);
    }
    assert!((membrane::energy(&lattice, &places) / energy - 1.0).abs() < 1e-13);
    let largest = force.iter().map(|f| norm(*f)).fold(0.0, f64::max);
    for (f, g) in force.iter().zip(&gradient) {
        assert!(norm(add(*f, *g)) < 1e-12 * largest, "{f:?} {g:?}");
    }
    let facets: Vec<[usize; 4]> = lattice.facets().collect();
    let volume = smartbed_runtime::flexible::pressure::enclosed_volume(&facets, &places);
    assert!((membrane::volume(&lattice, &places) / volume - 1.0).abs() < 1e-12, "{volume}");
}

#[test]
fn gradients_are_differences_of_the_energy() {
    let lattice = Lattice::new([6, 5], [0.25, 0.2], ET).expect("a sheet");
    let places = shaken(&lattice);
    let mut gradient = vec![[0.0; 3]; lattice.nodes()];
    membrane::add_gradient(&lattice, &places, &mut gradient);
    membrane::add_volume_gradient(&lattice, &places, -4000.0, &mut gradient);
    let largest = gradient.iter().map(|g| norm(*g)).fold(0.0, f64::max);
    let energy = |p: &[[f64; 3]]| membrane::energy(&lattice, p) - 4000.0 * membrane::volume(&lattice, p);
    for node in (0..lattice.nodes()).filter(|n| lattice.free(*n).is_some()) {
        for axis in 0..3 {
            let at = |h: f64| {
                let mut moved = places.clone();
                moved[node][axis] += h;
                energy(&moved)
            };
            let difference = (at(1e-5) - at(-1e-5)) / 2e-5;
            let error = (difference - gradient[node][axis]).abs();
            assert!(error < 1e-7 * largest, "{node} {axis}: {error:e} of {largest}");
        }
    }
}

/// A plate that covers the bladder's middle, or a ball, held at a height.
fn held(shape: Shape, foundation: f64, height: f64) -> (Body, Pose) {
    let segment = Segment {
        name: "piston".to_owned(),
        shape: shape.into(),
        mass: 0.0,
        centre: [0.0; 3],
        foundation,
        free: [false; 6],
    };
    (Body::single(segment), Pose::at([0.0, 0.0, height]))
}

#[test]
fn a_sealed_bladder_under_a_piston_is_as_stiff_as_its_gas() {
    // A bladder as a piston's chamber: a plate as wide as the sheet moves the whole of it, V = A x depth.
    for exponent in [1.0, 1.4] {
        let size = [0.225, 0.225];
        let area = size[0] * size[1];
        let volume = area * 0.1;
        let air = Air::sealed(4000.0, volume, exponent);
        let mut bed = bed([28, 28], size, air);
        // Nearly nothing but gas: a sheet that pulls little across when the plate dips below its rim.
        bed.lattice = Lattice::new([28, 28], size, 500.0).expect("a sheet");
        let force = |dip: f64| {
            let (body, pose) = held(Shape { half: [0.4, 0.4, 0.2], radius: 1e-4 }, 1e9, 0.2001 - dip);
            let solution = solve(&bed, &body, &bed.start(vec![pose])).expect("rests");
            (solution.contacts[0].iter().map(|c| c.force()[2]).sum::<f64>(), solution)
        };
        let h = 5e-5;
        let (here, solution) = force(1e-4);
        let found = (force(1e-4 + h).0 - force(1e-4 - h).0) / (2.0 * h);
        let volume = bed.volume(&solution.state.sheets[0]);
        let absolute = AMBIENT + solution.gauges[0];
        // The rim does not move: the plate carries what presses on free nodes.
        let carried = here / solution.gauges[0];
        let expected = exponent * absolute * carried * carried / volume;
        assert!((found / expected - 1.0).abs() < 0.02, "{found} {expected} {carried} {area}");
        assert!((carried / area - 1.0).abs() < 0.08, "{carried} {area}");
    }
}

#[test]
fn stiffness_is_the_difference_of_the_force() {
    for air in [Air::Regulated(4000.0), Air::sealed(4000.0, 0.225 * 0.225 * 0.1 + 7e-4, 1.4)] {
        let bed = bed([16, 16], [0.225, 0.225], air);
        let rest = |height: f64, start: &State| {
            let (body, pose) = held(Shape::ball(0.1), 1e7, height);
            let start = State { segments: vec![pose], ..start.clone() };
            let solution = solve(&bed, &body, &start).expect("rests");
            let (force, matrix) = stiffness(&bed, &body, &solution.state, 0).expect("rests");
            (force[2], matrix[2][2], solution.state)
        };
        let (_, stiff, state) = rest(0.121, &bed.start(vec![Pose::at([0.0; 3])]));
        // So small a step that no node begins or ends to touch.
        let h = 1e-6;
        let difference = -(rest(0.121 + h, &state).0 - rest(0.121 - h, &state).0) / (2.0 * h);
        assert!((difference / stiff - 1.0).abs() < 1e-6, "{difference} {stiff}");
        assert!(stiff > 100.0);
    }
}
