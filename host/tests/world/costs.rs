//! What a step costs: in proportion to the parts that move and what touches.

use super::support::parse;
use smartbed::world::run::engine;
use std::time::{Duration, Instant};

/// Least time of a step of the bed with so many tiles (s).
fn step([columns, rows]: [usize; 2]) -> f64 {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/../models/scenes/bed.toml");
    let text = std::fs::read_to_string(path).expect("the scene");
    let text = text.replace("count = [7, 4]", &format!("count = [{columns}, {rows}]"));
    let mut world = engine(&parse(&text).expect("a world")).expect("an engine");
    let mut least = Duration::MAX;
    for _ in 0..30 {
        let start = Instant::now();
        world.step(1e-3, &mut Vec::new()).expect("a step");
        least = least.min(start.elapsed());
    }
    least.as_secs_f64()
}

#[test]
fn a_step_costs_in_proportion_to_the_tiles() {
    let each = [[1, 1], [2, 2], [4, 4], [7, 4]].map(|count| {
        let tiles = (count[0] * count[1]) as f64;
        let each = step(count) / tiles;
        println!("{tiles} tiles: {:.1} us a step and tile", 1e6 * each);
        each
    });
    // A cost by pairs of tiles would be seven times that of four at 28.
    assert!(each[3] < 2.0 * each[1] && each[2] < 2.0 * each[1], "{each:?}");
}
