//! Bladders of a world with forces computed row by row, against the same bladders as lists of springs and facets.

use crate::support::parse;
use smartbed::scene::grid::Woven;
use smartbed::world::Assembly;
use smartbed::world::assembly::Kind;
use smartbed::world::carried::CarriedWorld;
use smartbed::world::engine::Engine;
use std::path::Path;

/// The state after some steps, as bits.
fn bits(assembly: &Assembly, steps: usize) -> Vec<u64> {
    let mut world = CarriedWorld::new(assembly).unwrap_or_else(|why| panic!("{why}"));
    for _ in 0..steps {
        world.step(assembly.run.step, &mut Vec::new()).unwrap_or_else(|why| panic!("{why}"));
    }
    world.numbers().iter().map(|x| x.to_bits()).collect()
}

/// The scene's text with other numbers of nodes in a row, gas regulated or sealed, as grids and as lists.
fn check(scene: &str, changes: &[(&str, &str)], steps: usize) {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../models/scenes").join(format!("{scene}.toml"));
    let mut text = std::fs::read_to_string(path).expect("the scene is there");
    for (from, to) in changes {
        assert!(text.contains(from), "{scene} has `{from}`");
        text = text.replace(from, to);
    }
    let assembly = parse(&text).unwrap_or_else(|found| panic!("{found}"));
    let (mut listed, mut grids) = (assembly.clone(), 0);
    for part in &mut listed.parts {
        if let Kind::Flexible(body) = &mut part.kind {
            grids += usize::from(Woven::<f64>::new(&body.lists, [0; 3]).is_some());
            body.lists.table = None;
        }
    }
    assert!(grids > 0, "{scene} has sheets that are grids");
    assert_eq!(bits(&assembly, steps), bits(&listed, steps), "{scene} {changes:?}");
}

#[test]
fn a_bladder_on_a_tile_moves_by_rows_as_by_lists() {
    let wide = [("rows = 7", "rows = 11"), ("columns = 7", "columns = 40"), ("0.5_ms", "0.05_ms")];
    check("tile_with_bladder", &wide, 20);
    check(
        "tile_bladder_coupled",
        &[("rows = 5", "rows = 3"), ("columns = 5", "columns = 13"), ("0.5_ms", "0.1_ms")],
        20,
    );
}

#[test]
fn bladders_beside_one_another_touch_by_rows_as_by_lists() {
    let fine = [("rows = 7", "rows = 12"), ("columns = 7", "columns = 12"), ("0.5_ms", "0.1_ms")];
    check("ball_on_bladder", &[&fine[..], &[("height = \"70_mm\"", "height = \"41_mm\"")]].concat(), 100);
    let fine =
        [("count = [7, 4]", "count = [2, 2]"), ("rows = 3", "rows = 12"), ("columns = 3", "columns = 12")];
    let fine =
        [&fine[..], &[("step = \"1_ms\"", "step = \"0.2_ms\""), ("0.9_m", "0.15_m"), ("0.45_m", "0.15_m")]]
            .concat();
    check("bed", &[&fine[..], &[("height = \"70_mm\"", "height = \"51_mm\"")]].concat(), 60);
    check("bed", &[&fine[..], &[(", sealed = true", "")]].concat(), 20);
}
