//! A sheet stepped in one pass over its nodes, against the forces of its lists and against itself with short steps.

use smartbed_runtime::flexible::walk::{Lost, Node, Sheet, Tie};
use smartbed_runtime::flexible::{Body, Gas, Inflation, Massless, PressureForm, Spring, force};
use smartbed_runtime::vec3::Vec3;

use crate::random::Random;

const ROWS: usize = 5;
const COLUMNS: usize = 7;
/// Of a free node (kg), its weight (N).
const MASS: f64 = 0.2;
const WEIGHT: Vec3<f64> = [0.1, -0.2, -2.0];

fn sheet() -> Sheet<f64> {
    let tie = |rest_length| Tie { stiffness: 300.0, rest_length, damping: Some(0.7) };
    let springs = Some([tie(0.8), tie(0.9)]);
    Sheet { columns: COLUMNS, springs, weight: WEIGHT, air_drag: 0.3, pressure: Some(20.0) }
}

fn is_edge(place: usize) -> [bool; 2] {
    let (row, column) = (place / COLUMNS, place % COLUMNS);
    [row == 0 || row + 1 == ROWS, column == 0 || column + 1 == COLUMNS]
}

fn is_free(place: usize) -> bool {
    is_edge(place) == [false; 2]
}

/// Nodes about a metre apart, drawn by lot; corners midway between their neighbours.
fn nodes(seed: u64, spread: f64) -> Vec<Node<f64>> {
    let mut random = Random::new(seed);
    let mut draw = move || random.between(-spread, spread);
    let mut nodes: Vec<Node<f64>> = (0..ROWS * COLUMNS)
        .map(|place| {
            let at = [(place % COLUMNS) as f64 + draw(), (place / COLUMNS) as f64 + draw(), draw()];
            let free = is_free(place);
            let vel = if free { [draw(), draw(), draw()] } else { [0.0; 3] };
            Node::new(at, vel, if free { 1.0 / MASS } else { 0.0 })
        })
        .collect();
    for (row, column) in [(0, 0), (0, COLUMNS - 1), (ROWS - 1, 0), (ROWS - 1, COLUMNS - 1)] {
        let inwards = |at: usize| if at == 0 { 1 } else { at - 1 };
        let beside = nodes[row * COLUMNS + inwards(column)];
        let above = nodes[inwards(row) * COLUMNS + column];
        nodes[row * COLUMNS + column].pos = [0, 1, 2].map(|c| 0.5 * (beside.pos[c] + above.pos[c]));
    }
    nodes
}

/// The same forces spring by spring and facet by facet; a corner's facet is a triangle.
fn by_lists(nodes: &[Node<f64>]) -> Vec<Vec3<f64>> {
    let Sheet { springs: Some(ties), pressure: Some(pressure), .. } = sheet() else { panic!("a sheet") };
    let mut springs = Vec::new();
    let mut facets = Vec::new();
    for place in 0..ROWS * COLUMNS {
        for (tie, head) in ties.iter().zip([place + 1, place + COLUMNS]) {
            let joined = head < nodes.len() && (head != place + 1 || head % COLUMNS > 0);
            if joined && (is_free(place) || is_free(head)) {
                let Tie { stiffness, rest_length, damping } = *tie;
                let damping = damping.expect("a damper");
                springs.push(Spring { tail: place, head, stiffness, damping, rest_length });
            }
        }
        if place / COLUMNS + 1 < ROWS && place % COLUMNS + 1 < COLUMNS {
            let cell = [place, place + 1, place + COLUMNS + 1, place + COLUMNS];
            let left: Vec<usize> = cell.into_iter().filter(|node| is_edge(*node) != [true; 2]).collect();
            facets.push([left[0], left[1], left[2], *left.last().expect("a corner")]);
        }
    }
    let free: Vec<bool> = (0..nodes.len()).map(is_free).collect();
    let (mass, fixed) = (vec![MASS; nodes.len()], free.iter().map(|free| !free).collect::<Vec<_>>());
    let body = Body::new(Body {
        mass: &mass,
        fixed: &fixed,
        inverse_mass: &[],
        springs: &springs,
        gravity: WEIGHT.map(|weight| weight / MASS),
        air_drag: sheet().air_drag,
        facets: &facets,
        inflation: Some(Inflation { gas: Gas::Constant(pressure), form: PressureForm::Exact }),
        massless: Massless::default(),
        grids: &[],
        patches: None,
    });
    let body = body.expect("a body");
    let pos: Vec<_> = nodes.iter().map(|node| node.pos).collect();
    let vel: Vec<_> = nodes.iter().map(|node| node.vel).collect();
    let [mut elastic, mut viscous] = [(); 2].map(|()| vec![[0.0; 3]; nodes.len()]);
    force::eval_elastic(&body, &body.elements(), &pos, &mut elastic).expect("forces");
    force::eval_viscous(&body, &body.elements(), &pos, &vel, &mut viscous);
    let sum = elastic.iter().zip(&viscous).map(|(a, b)| [0, 1, 2].map(|c| a[c] + b[c]));
    sum.zip(&free).map(|(force, free)| if *free { force } else { [0.0; 3] }).collect()
}

#[test]
fn forces_are_those_of_the_lists() {
    for seed in 0..20 {
        let mut nodes = nodes(seed, 0.3);
        let forces = by_lists(&nodes);
        sheet().begin(&mut nodes).expect("numbers");
        for (node, force) in nodes.iter().zip(&forces) {
            for (acc, force) in node.acc.iter().zip(force) {
                assert!((acc * MASS - force).abs() < 1e-12 * 300.0, "{acc} {force}");
            }
        }
    }
}

/// Where all nodes are after 0.4 s in so many steps.
fn after(steps: u32) -> Vec<Vec3<f64>> {
    let (sheet, mut nodes) = (sheet(), nodes(7, 0.1));
    sheet.begin(&mut nodes).expect("numbers");
    for _ in 0..steps {
        sheet.step(&mut nodes, 0.4 / f64::from(steps)).expect("numbers");
    }
    nodes.iter().map(|node| node.pos).collect()
}

#[test]
fn the_order_is_two_with_dampers() {
    let truth = after(6400);
    let error = |steps| {
        let off = after(steps).into_iter().flatten().zip(truth.iter().flatten()).map(|(a, b)| (a - b).abs());
        off.fold(0.0, f64::max)
    };
    let errors = [100, 200, 400].map(error);
    assert!(errors[0] < 2e-3, "{errors:?}");
    for pair in errors.windows(2) {
        let order = (pair[0] / pair[1]).log2();
        assert!((order - 2.0).abs() < 0.15, "{errors:?}");
    }
}

#[test]
fn a_step_too_long_is_refused() {
    let (sheet, mut nodes) = (sheet(), nodes(7, 0.1));
    sheet.begin(&mut nodes).expect("numbers");
    assert!((0..2000).any(|_| sheet.step(&mut nodes, 0.5) == Err(Lost)));
}
