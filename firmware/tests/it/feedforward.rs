//! Benefit of the derived loads as feedforward in the servo: legs deviate less from their trajectory.

use crate::bench::{FRICTIONS, drive};
use smartbed_firmware::link::message::Trim;
use smartbed_firmware::plant::Tile;
use smartbed_firmware::tile::board::{Outputs, Sensors};
use smartbed_firmware::tile::design::{GRAVITY, OWN_WEIGHT};
use smartbed_firmware::tile::drive::Drive;
use smartbed_firmware::tile::dynamics::loads;
use smartbed_firmware::tile::motion::Motion;
use smartbed_firmware::tile::profile::Along;
use smartbed_firmware::tile::sense::Sense;
use smartbed_firmware::tile::servo::Servo;

/// Load of each leg (N) given to the servo.
type Feed = fn(&[Along; 3]) -> [f32; 3];

/// Ways (m): 5 degrees, 20 mm up, 20 mm down.
const WAYS: [[f32; 3]; 3] = [[0.0, 0.007, -0.007], [0.02; 3], [-0.02; 3]];

/// Farthest that a leg is from where it should be (m) along a way, under 25 kg 40 mm off the middle.
fn farthest(drive: Drive<f32>, way: [f32; 3], feed: Feed) -> f32 {
    let mut tile = Tile::loaded(25.0, [0.04, 0.0], [0.0; 3], drive).expect("a start");
    let (mut sense, mut servo) = (Sense::default(), Servo::default());
    for _ in 0..100 {
        sense.take(&tile.read(), &Trim::default());
        tile.advance(&Outputs::default()).expect("a step");
    }
    sense.recover();
    let from = sense.heights;
    let mut motion = Motion::new(from, std::array::from_fn(|leg| from[leg] + way[leg]), 1.0);
    let mut farthest = 0.0_f32;
    while motion.advance().is_none() {
        sense.take(&tile.read(), &Trim::default());
        let wanted = motion.wanted();
        let duty = servo.duties(&sense, &wanted, &motion.ways(), &feed(&wanted));
        tile.advance(&Outputs { enable: true, duty, ..Outputs::default() }).expect("a step");
        let legs = wanted.iter().zip(sense.heights);
        farthest = legs.fold(farthest, |most, (wanted, height)| most.max((wanted.position - height).abs()));
    }
    farthest
}

/// The servo's integral removes most of the deviation; the derived loads remove two fifths of the rest, as would a
/// third of the weight on each leg: legs are so slow that loads depend on positions alone, and drives so stiff that
/// they matter little.
#[test]
fn the_derived_loads_keep_the_legs_nearer_to_their_way() {
    let worst = |feed: Feed| {
        let trials = FRICTIONS.into_iter().flat_map(|friction| WAYS.map(|way| (friction, way)));
        trials.map(|(friction, way)| farthest(drive(friction), way, feed)).fold(0.0, f32::max)
    };
    let none = worst(|_| [0.0; 3]);
    let thirds = worst(|_| [(OWN_WEIGHT + 25.0 * GRAVITY) / 3.0; 3]);
    let derived = worst(|wanted| loads(wanted, 25.0));
    println!("um at most: without {}, by thirds {}, derived {}", none * 1e6, thirds * 1e6, derived * 1e6);
    assert!(derived < 0.65 * none && derived < 1.02 * thirds);
}
