//! Facets that a port holds, as one wall of a cell: the same rates as facet by facet.

use proptest::prelude::*;
use smartbed_runtime::flexible::PressureForm;
use smartbed_runtime::flexible::pressure::{corner_shares, corners, enclosed_volume};
use smartbed_runtime::mechanism::Fault;
use smartbed_runtime::ode::Ode;
use smartbed_runtime::vec3;
use smartbed_runtime::world::{Cell, Wall};

use crate::island::{FLOATING, Lists, cell, content};

/// The closed cell on a floating body, its held facets last, and the wall that they make.
fn walled() -> (Lists, Cell<f64>) {
    let mut lists = cell(0.3);
    lists.inflation = None;
    let free = 4;
    lists.facets.sort_by_key(|facet| !facet.contains(&free));
    let first = lists.facets.iter().position(|facet| !facet.contains(&free)).expect("a held facet");
    let mut places = vec![[0.0; 3]; lists.mass.len()];
    for held in &lists.attachments {
        places[held.node] = held.place;
    }
    let (wall, mut area) = (&lists.facets[first..], [0.0; 3]);
    for facet in wall {
        for (node, share) in facet.iter().zip(corner_shares(PressureForm::Exact, corners(&places, facet))) {
            let held = lists.attachments.iter_mut().find(|held| held.node == *node).expect("a held node");
            held.push = vec3::add(held.push, share);
            area = vec3::add(area, share);
        }
    }
    let volume = enclosed_volume(wall, &places);
    let wall = Wall { first, port: 0, attachments: [0, lists.attachments.len()], volume, area };
    let cell = Cell { wall: Some(wall), ..content([0, lists.facets.len()]) };
    (lists, cell)
}

/// Rates and the volume of the gas at a state.
fn rates(wall: bool, [q, u]: [&[f64]; 2]) -> (Vec<f64>, f64) {
    let (mut lists, cell) = walled();
    let cells = [if wall { cell } else { Cell { wall: None, ..cell } }];
    let mut rows = lists.rows();
    let mut island = lists.island(FLOATING, &mut rows).with_cells(&cells).expect("a cell");
    let mut x = vec![0.0; island.n_x()];
    island.load(q, u, &mut x).expect("lengths");
    island.place(0.0, &x).expect("a place");
    // The free node of the sheet, above the base.
    let above = island.seams().0[0].point([0.02, -0.01, 0.13]);
    x[q.len()..q.len() + 3].copy_from_slice(&above);
    let mut x_dot = vec![0.0; x.len()];
    island.rates(0.0, &x, &mut x_dot).expect("rates");
    let volume = island.volumes().next().expect("one cell");
    (x_dot, volume)
}

#[test]
fn a_wall_gives_the_rates_of_its_facets() {
    proptest!(|(
        at in proptest::array::uniform3(-2.0..2.0_f64),
        turn in proptest::array::uniform4(-1.0..1.0_f64),
        momenta in proptest::array::uniform6(-0.3..0.3_f64),
    )| {
        let length = turn.iter().map(|e| e * e).sum::<f64>().sqrt();
        prop_assume!(length > 0.1);
        let q = [&at[..], &turn.map(|e| e / length)].concat();
        let [(one, volume), (other, by_facets)] = [true, false].map(|wall| rates(wall, [&q, &momenta]));
        let largest = other.iter().fold(0.0_f64, |most, rate| most.max(rate.abs()));
        let apart = one.iter().zip(&other).fold(0.0_f64, |most, (a, b)| most.max((a - b).abs()));
        prop_assert!(apart < 1e-11 * largest, "{apart:e} of {largest:e}");
        prop_assert!((volume - by_facets).abs() < 1e-14, "{volume} {by_facets}");
    });
}

#[test]
fn a_wall_must_name_facets_attachments_and_a_port_that_exist() {
    let refused = |change: fn(&mut Wall<f64>)| {
        let (mut lists, cell) = walled();
        let mut wall = cell.wall.expect("a wall");
        change(&mut wall);
        let (cells, mut rows) = ([Cell { wall: Some(wall), ..cell }], lists.rows());
        lists.island(FLOATING, &mut rows).with_cells(&cells).err()
    };
    assert_eq!(refused(|_| ()), None);
    assert_eq!(refused(|wall| wall.port = 1), Some(Fault::Shape));
    assert_eq!(refused(|wall| wall.first = 9), Some(Fault::Shape));
    assert_eq!(refused(|wall| wall.attachments[1] += 1), Some(Fault::Shape));
}
