//! Numbers that cannot be are refused before anything moves: bodies, grounds, things, steps.

use crate::scenery::Scene;
use smartbed_runtime::contact::compensation::PointImpact;
use smartbed_runtime::contact::{ContactLaw, ContactState, ForceLaw, Ground, System};
use smartbed_runtime::flexible::{Body, BodyError, Gas, Inflation, Massless, PressureForm, Quantity, Spring};
use smartbed_runtime::mechanism::Fault;
use smartbed_runtime::ode::nodes::{MOTION_ROWS, Method, Motion, Step, Workspace, workspace_len};
use smartbed_runtime::scene::{State, step};
use smartbed_runtime::surface::{Shape, Sphere};
use smartbed_runtime::world::{Pair, Place, Thing};

const SPRINGS: [Spring<f64>; 2] = [
    Spring { tail: 0, head: 1, stiffness: 100.0, damping: 0.0, rest_length: 1.0 },
    Spring { tail: 1, head: 2, stiffness: 100.0, damping: 0.0, rest_length: 1.0 },
];

fn body() -> Body<'static, f64> {
    Body {
        mass: &[0.0, 2.0, 4.0],
        fixed: &[false, false, true],
        inverse_mass: &[[0.0; 3], [0.5; 3], [0.0; 3]],
        springs: &SPRINGS,
        facets: &[[0, 1, 2, 2]],
        massless: Massless { points: &[0], first: &[0, 1], springs: &[0] },
        ..Body::none()
    }
}

fn ground() -> Ground<f64> {
    let law = ContactLaw::Newton { restitution: 0.5 };
    Ground { normal: [0.0, 0.6, 0.8], offset: 0.0, law, friction: 0.3, tolerance: 1e-9 }
}

#[test]
fn constants_of_a_body_that_cannot_be_are_refused() {
    let refused = |body| Body::new(body).err();
    assert_eq!(refused(body()), None);
    let gas = |[volume, exponent, pressure]: [f64; 3]| {
        let gas = Gas::Polytropic { pressure, ambient: 1e5, volume, exponent, dead_volume: 0.0 };
        Body { inflation: Some(Inflation { gas, form: PressureForm::Exact }), ..body() }
    };
    assert_eq!(refused(gas([1.0, 1.4, 0.0])), None);
    let massless = |points, first, springs| Body { massless: Massless { points, first, springs }, ..body() };
    let (nan, most) = (f64::NAN, f64::INFINITY);
    for (body, quantity) in [
        (Body { air_drag: -1.0, ..body() }, Quantity::AirDrag),
        (Body { air_drag: nan, ..body() }, Quantity::AirDrag),
        (Body { gravity: [0.0, most, 0.0], ..body() }, Quantity::Gravity),
        (gas([0.0, 1.4, 0.0]), Quantity::Gas),
        (gas([-1.0, 1.4, 0.0]), Quantity::Gas),
        (gas([1.0, nan, 0.0]), Quantity::Gas),
        (gas([1.0, 1.4, nan]), Quantity::Gas),
        (Body { inverse_mass: &[[0.0; 3], [0.6; 3], [0.0; 3]], ..body() }, Quantity::InverseMass),
        (Body { inverse_mass: &[[0.0; 3], [0.5; 3], [0.25; 3]], ..body() }, Quantity::InverseMass),
        (Body { inverse_mass: &[[nan; 3], [0.5; 3], [0.0; 3]], ..body() }, Quantity::InverseMass),
        (massless(&[1], &[0, 1], &[0]), Quantity::MasslessPoints),
        (massless(&[0], &[0, 1], &[7]), Quantity::MasslessSprings),
        (massless(&[0], &[0, 1], &[1]), Quantity::MasslessSprings),
        (massless(&[0], &[0, 9], &[0]), Quantity::MasslessSprings),
    ] {
        assert_eq!(refused(body), Some(BodyError::OutOfRange(quantity)), "{body:?}");
    }
}

#[test]
fn numbers_of_a_ground_that_cannot_be_are_refused() {
    assert_eq!(ground().check(), Ok(()));
    let with = |law| Ground { law, ..ground() };
    let compensation =
        |eta| ContactLaw::Compensation { eta, anchor: false, plastic_alone: false, first_receiver: 0 };
    for (ground, quantity) in [
        (Ground { normal: [0.0; 3], ..ground() }, Quantity::Normal),
        (Ground { normal: [0.0, f64::NAN, 1.0], ..ground() }, Quantity::Normal),
        (Ground { normal: [0.0, 0.0, 2.0], ..ground() }, Quantity::Normal),
        (Ground { offset: f64::NAN, ..ground() }, Quantity::Place),
        (Ground { tolerance: -1.0, ..ground() }, Quantity::Place),
        (Ground { friction: f64::NAN, ..ground() }, Quantity::Friction),
        (Ground { friction: -0.1, ..ground() }, Quantity::Friction),
        (with(ContactLaw::Newton { restitution: 1.5 }), Quantity::Law),
        (with(ContactLaw::Moreau { restitution: f64::NAN }), Quantity::Law),
        (with(compensation(1.1)), Quantity::Law),
        (with(ContactLaw::Force(ForceLaw::Penalty { stiffness: -1.0 })), Quantity::Law),
        (
            with(ContactLaw::Force(ForceLaw::HuntCrossley { stiffness: 1.0, dissipation: f64::INFINITY })),
            Quantity::Law,
        ),
    ] {
        assert_eq!(ground.check(), Err(BodyError::OutOfRange(quantity)), "{ground:?}");
        assert_eq!(stepped(Some(ground), 0.1), Err(BodyError::OutOfRange(quantity)), "{ground:?}");
    }
}

/// A start and a step of a pendulum of one spring; a refusal leaves it where it was.
fn stepped(ground: Option<Ground<f64>>, h: f64) -> Result<(), BodyError<f64>> {
    let body = Body::new(Body {
        mass: &[1.0, 1.0],
        fixed: &[false, true],
        springs: SPRINGS.get(..1).unwrap_or_default(),
        ..Body::none()
    })?;
    let (system, method) = (System::new(body, ground), Method::Verlet);
    let mut memory = [[0.0; 3]; 2 * MOTION_ROWS];
    let mut scratch = vec![[0.0; 3]; workspace_len(2, method.stages())];
    let (mut modes, mut impacts) = ([ContactState::Free; 2], [PointImpact::none(); 2]);
    let (motion, _) = Motion::cut(&mut memory, 2)?;
    motion.pos.copy_from_slice(&[[1.3, 1.0, 1.0], [0.0, 1.0, 1.0]]);
    motion.vel[0] = [0.1, 0.0, 0.0];
    let (time, next_step, anchor) = ([0.0; 2], 0.0, 0.0);
    let mut state = State { motion, modes: &mut modes, impacts: &mut impacts, time, next_step, anchor };
    let mut work = Workspace::new(&mut scratch, 2, method.stages())?;
    state.begin(&system, 0.1, method, &mut work, &mut ())?;
    let done = step(&system, &mut state, h, method, &mut work, &mut ()).map(|_| ());
    let stays = state.motion.pos[0] == [1.3, 1.0, 1.0] && state.t() == 0.0;
    assert!(stays == done.is_err(), "{done:?}");
    done
}

#[test]
fn steps_that_do_not_lead_forward_are_refused() {
    let laws = [
        ContactLaw::Newton { restitution: 0.5 },
        ContactLaw::Moreau { restitution: 0.5 },
        ContactLaw::Force(ForceLaw::Penalty { stiffness: 1e3 }),
    ];
    let grounds = laws.map(|law| Some(Ground { law, ..ground() }));
    for ground in grounds.into_iter().chain([None]) {
        assert_eq!(stepped(ground, 0.01), Ok(()));
        for h in [0.0, -0.1, f64::NAN, f64::INFINITY] {
            assert_eq!(stepped(ground, h), Err(BodyError::OutOfRange(Quantity::Step)), "{h}");
        }
    }
    let mut scene = Scene::falling();
    let (floor, ball) = (scene.floor(), scene.ball(1.0, 0.1, [0.0, 0.0, 0.5], [0.0; 3]));
    scene.pair(ball, floor, 0.4, 0.0);
    let (_, ()) = scene.with(|world, state, mut memory| {
        let before = state.x().to_vec();
        for h in [0.0, -1e-3, f64::NAN, f64::INFINITY] {
            assert_eq!(world.step(0.0, h, state, &mut memory).err(), Some(Fault::StepSize), "{h}");
            assert_eq!(world.relax(0.0, h, state, &mut memory).err(), Some(Fault::StepSize), "{h}");
            assert_eq!(state.x(), before);
        }
    });
}

#[test]
fn things_and_pairs_of_what_does_not_exist_are_refused() {
    let sphere = Shape::Sphere(Sphere { radius: 0.1 });
    let refused = |spoil: &dyn Fn(&mut Scene)| {
        let mut scene = Scene::falling();
        let (floor, ball) = (scene.floor(), scene.ball(1.0, 0.1, [0.0, 0.0, 0.5], [0.0; 3]));
        scene.pair(ball, floor, 0.4, 0.0);
        spoil(&mut scene);
        scene.with(|world, state, mut memory| world.step(0.0, 1e-3, state, &mut memory).err()).1
    };
    let thing = |thing: Thing<f64>| refused(&move |scene| scene.things.push(thing));
    assert_eq!(refused(&|_| ()), None);
    let at_port = |port| Thing::Rigid { shape: sphere, port, place: Place::same() };
    assert_eq!([thing(at_port(Some(0))), thing(at_port(Some(1)))], [None, Some(Fault::Shape)]);
    for (nodes, facets) in [([0, 1], [0, 0]), ([1, 0], [0, 0]), ([0, 0], [0, 1]), ([0, 0], [1, 0])] {
        assert_eq!(
            thing(Thing::Mesh { nodes, facets, depth: 0.1 }),
            Some(Fault::Shape),
            "{nodes:?} {facets:?}"
        );
    }
    let pair = |things, friction, restitution| {
        refused(&move |scene| scene.pairs.push(Pair::striking(things, restitution, friction)))
    };
    assert_eq!(pair([0, 7], 0.0, 0.0), Some(Fault::Shape));
    assert_eq!(pair([0, 1], f64::NAN, 0.0), Some(Fault::NonFinite));
    assert_eq!(pair([0, 1], 0.0, f64::NAN), Some(Fault::NonFinite));
}
