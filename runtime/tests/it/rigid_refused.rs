//! Scenes of rigid bodies that are refused: laws that create energy, numbers out of range.

use crate::rigid_scene::{World, cuboid, stronge};
use smartbed_runtime::rigid::RigidState;
use smartbed_runtime::rigid::attitude::Attitude;
use smartbed_runtime::rigid::law::{Law, LawFault};
use smartbed_runtime::rigid::scene::{Fault, Part};
use smartbed_runtime::surface::{Capsule, Cuboid, Shape, Sphere};

#[test]
fn laws_that_create_energy_and_numbers_out_of_range_are_refused() {
    assert_eq!(Law::newton(0.5, 0.1), Err(LawFault::NewtonWithFriction));
    assert_eq!(Law::stronge(1.5, 0.1), Err(LawFault::Restitution));
    assert_eq!(Law::stronge(f64::NAN, 0.1), Err(LawFault::Restitution));
    assert_eq!(Law::compensation(0.5, -0.1), Err(LawFault::Friction));
    assert_eq!(Law::compensation(0.25, 0.1).map(|law| law.restitution()), Ok(0.5));
    let mut world =
        World::new(0.0, stronge(0.0, 0.0), &[(cuboid(1.0, [0.1; 3]), RigidState::at_rest([0.0, 0.0, 0.1]))]);
    world.room = 3;
    assert_eq!(world.try_step(1e-2), Err(Fault::TooManyContacts));
    world.pairs[0].parts = [1, 7];
    assert_eq!(world.try_step(1e-2), Err(Fault::WrongSizes));
    world.room = 64;
    world.pairs[0].parts = [1, 0];
    for h in [0.0, -1e-2, f64::NAN, f64::INFINITY] {
        assert_eq!(world.try_step(h), Err(Fault::StepSize));
    }
}

/// A body as it is before it is spoilt, and what spoils it.
type Spoilt = fn(&mut Part<f64>, &mut RigidState<f64>, f64);

#[test]
fn numbers_out_of_range_are_refused() {
    let spoil: [Spoilt; 9] = [
        |part, _, x| part.body.as_mut().unwrap().mass = x,
        |part, _, x| part.body.as_mut().unwrap().inertia[1] = x,
        |part, _, x| part.shape = Shape::Sphere(Sphere { radius: x }),
        |part, _, x| part.shape = Shape::Capsule(Capsule { radius: 0.1, half_length: x }),
        |part, _, x| part.shape = Shape::Cuboid(Cuboid { half: [0.1, x, 0.1] }),
        |_, state, x| state.position[1] = if x <= 0.0 { f64::NAN } else { x },
        |_, state, x| state.velocity[2] = if x <= 0.0 { f64::NAN } else { x },
        |_, state, x| state.angular_momentum[0] = if x <= 0.0 { f64::NAN } else { x },
        |_, state, x| {
            state.attitude = Attitude::restored([1.0, if x <= 0.0 { f64::NAN } else { x }, 0.0, 0.0])
        },
    ];
    for (number, spoil) in spoil.iter().enumerate() {
        for x in [-1.0, f64::NAN, f64::INFINITY] {
            let (mut part, mut state) = (cuboid(1.0, [0.1; 3]), RigidState::at_rest([0.0, 0.0, 0.5]));
            spoil(&mut part, &mut state, x);
            let mut world = World::new(0.0, stronge(0.5, 0.3), &[(part, state)]);
            assert_eq!(world.try_step(1e-2), Err(Fault::Part(1)), "{number}: {x}");
        }
    }
    for x in [0.0, 1e-320] {
        let (mut part, state) = (cuboid(1.0, [0.1; 3]), RigidState::at_rest([0.0, 0.0, 0.5]));
        part.body.as_mut().unwrap().mass = x;
        let mut world = World::new(0.0, stronge(0.5, 0.3), &[(part, state)]);
        assert_eq!(world.try_step(1e-2), Err(Fault::Part(1)), "mass {x}");
    }
    let fast = RigidState { velocity: [1e308, 0.0, 0.0], ..RigidState::at_rest([0.0, 0.0, 0.5]) };
    let mut world = World::new(0.0, stronge(0.5, 0.3), &[(cuboid(1.0, [0.1; 3]), fast)]);
    assert_eq!(world.try_step(10.0), Err(Fault::TooFast));
    for gravity in [f64::NAN, f64::INFINITY] {
        world.gravity = gravity;
        assert_eq!(world.try_step(1e-2), Err(Fault::Gravity));
    }
}
