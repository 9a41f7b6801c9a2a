//! Force laws between the parts of a world: action and reaction, energy, and what refuses them.

use crate::scenery::Scene;
use smartbed_runtime::contact::ForceLaw;
use smartbed_runtime::mechanism::Fault;
use smartbed_runtime::rigid::law::Kind;
use smartbed_runtime::world::{MeanMemory, Pair};

const SPRING: ForceLaw<f64> = ForceLaw::Penalty { stiffness: 2e4 };
const DAMPED: ForceLaw<f64> = ForceLaw::HuntCrossley { stiffness: 1e6, dissipation: 0.5 };

/// A cube of nodes that flies into a box, both free.
fn collision(law: ForceLaw<f64>) -> Scene {
    let mut scene = Scene { room: 64, ..Scene::default() };
    let block = scene.cuboid(2.0, [0.1, 0.15, 0.05], [0.0, 0.0, 0.0], [0.0; 3]);
    let cube = scene.cube(0.1, [0.02, 0.01, 0.052], [0.1, 0.0, -1.0], 2e4, 0.0);
    scene.pairs.push(Pair::yielding([cube, block], law));
    scene
}

#[test]
fn momentum_stays_and_angular_momentum_to_the_order_of_the_method() {
    for law in [SPRING, DAMPED] {
        let mut moved = Vec::new();
        for (h, steps) in [(1e-4, 400), (5e-5, 800)] {
            let mut scene = collision(law);
            let mut drift = scene.drift();
            let (_, _, accounts) = scene.run_located(Kind::Stronge, (h, steps), |report, _, x| {
                assert_eq!((report.impacts, report.pressing), (0, 0));
                drift.see(x);
            });
            assert!(drift.moved[0] < 1e-12, "{:?}", drift.moved);
            assert_eq!(accounts.impact > 1e-3, law == DAMPED, "{accounts:?}");
            moved.push(drift.moved[1]);
        }
        assert!(moved[1] < 1e-8 && moved[1] < moved[0] / 8.0, "{moved:?}");
    }
}

/// Both steps see the same forces: the one that locates touches, and the one that does not and is of order 2 here.
#[test]
fn the_step_without_location_has_the_same_forces() {
    for law in [SPRING, DAMPED] {
        let (fine, ..) = collision(law).run_located(Kind::Stronge, (1e-5, 3000), |_, _, _| {});
        let mut errors = Vec::new();
        for (h, steps) in [(4e-4, 75), (1e-4, 300)] {
            let (x, ..) = collision(law).run(h, steps, |_, touches, _| assert!(touches.is_empty()));
            errors.push(x.iter().zip(&fine).take(3).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max));
        }
        assert!(errors[1] < 1e-6 && errors[1] < errors[0] / 8.0, "{errors:?}");
    }
}

#[test]
fn the_energy_of_overlaps_is_the_integral_of_their_force() {
    for law in [SPRING, DAMPED] {
        for depth in [1e-4, 3e-3] {
            let n = 2000;
            let mean = |k: i32| law.force(depth * (f64::from(k) + 0.5) / f64::from(n), 0.0).0;
            let sum: f64 = (0..n).map(mean).sum::<f64>() * depth / f64::from(n);
            assert!((sum - law.energy(depth)).abs() < 1e-6 * sum, "{law:?} {depth}");
            let step = 1e-6 * depth;
            let slope = (law.force(depth + step, 0.0).0 - law.force(depth - step, 0.0).0) / (2.0 * step);
            assert!((slope - law.slope(depth)).abs() < 1e-8 * slope, "{law:?} {depth}");
        }
        assert_eq!(law.force(-1e-3, 1.0), (0.0, 0.0));
        assert!(law.force(1e-3, -1e9).0 >= 0.0, "the ground never pulls");
    }
}

#[test]
fn a_law_without_numbers_and_a_step_of_means_are_refused() {
    for stiffness in [f64::NAN, -1.0, f64::INFINITY] {
        let mut scene = collision(ForceLaw::Penalty { stiffness });
        let (_, fault) =
            scene.with(|world, state, mut memory| world.step(0.0, 1e-3, state, &mut memory).err());
        assert_eq!(fault, Some(Fault::NonFinite), "{stiffness}");
    }
    let (_, fault) = collision(SPRING).with(|world, state, mut memory| {
        let nodes = [&mut [][..], &mut [], &mut [], &mut []];
        let mut means = MeanMemory { scratch: &mut [], nodes, frames: [&mut [], &mut []] };
        world.step_conserving(0.0, 1e-3, state, &mut memory, &mut means).err()
    });
    assert_eq!(fault, Some(Fault::Shape), "its means are not computed");
}
