//! Without power the screws hold: in double precision, at the lowest friction, drives open and not braked.

use smartbed_firmware::plant::{Plant, double, leg};
use smartbed_firmware::tile::board::Outputs;
use smartbed_firmware::tile::drive::{DRIVE, Drive};

/// So many seconds under 1.5 times the working load, which pulsates by a fifth; how far the legs have gone (m).
fn creep(drive: Drive<f32>, seconds: u32) -> f64 {
    let wide = |x: f32| f64::from(x);
    let drive = Drive {
        ratio: wide(drive.ratio),
        lead: wide(drive.lead),
        diameter: wide(drive.diameter),
        worm_slope: wide(drive.worm_slope),
        screw_friction: wide(drive.screw_friction),
        worm_friction: wide(drive.worm_friction),
        inertia: wide(drive.inertia),
        constant: wide(drive.constant),
        resistance: wide(drive.resistance),
        supply: wide(drive.supply),
    };
    let mass = 1.5 * 30.0;
    let parameters = double::Parameters {
        m_payload: mass,
        x_payload: 0.04,
        mr: leg::reflected(&drive),
        ..double::Parameters::default()
    };
    let start = [0.01, 0.0, -0.005];
    let tile = double::Tile::new(parameters);
    let mut plant = Plant::new(tile, double::NOMINAL, start, drive).expect("a start");
    plant.brakes = false;
    let pulse = double::PARAMETER_NAMES.iter().position(|n| *n == "Fz").expect("an external force");
    let start = plant.heights();
    for tick in 0..seconds * 1000 {
        // Once a second, in tenths: a force is set when it changes.
        if tick % 100 == 0 {
            let phase = f64::from(tick / 100) * std::f64::consts::TAU / 10.0;
            plant.mechanism().set_parameter(pulse, -0.2 * mass * 9.81 * phase.sin());
        }
        plant.advance(&Outputs::default()).expect("a step");
    }
    plant.heights().iter().zip(start).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max)
}

#[test]
fn an_hour_without_power_moves_nothing() {
    assert!(DRIVE.with_friction(true).locking_margin() > 0.0);
    assert_eq!(creep(DRIVE.with_friction(true), 3600), 0.0);
}

/// The same test sees a drive that does not lock: two starts, oil on the worm.
#[test]
fn a_drive_that_does_not_lock_is_seen_to_run_down() {
    let slippery = Drive { lead: 0.008, worm_slope: 0.158, ..DRIVE }.with_friction(true);
    assert!(slippery.locking_margin() < 0.0);
    assert!(creep(slippery, 20) > 1e-3, "{}", creep(slippery, 20));
}
