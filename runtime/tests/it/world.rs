//! Worlds without split steps: contacts of rigid and flexible parts at rest, sliding, rolling, colliding; energy
//! accounts.

use crate::island::Platform;
use crate::scenery::{Part, Scene};
use smartbed_runtime::flexible::{Body, Spring};
use smartbed_runtime::mechanism::Fault;
use smartbed_runtime::ode::State;
use smartbed_runtime::rigid::RigidBody;
use smartbed_runtime::rigid::contact::Twist;
use smartbed_runtime::surface::{Cuboid, Frame, Shape, Sphere};
use smartbed_runtime::vec3::{self, Vec3};
use smartbed_runtime::world::{
    Commanded, Coupling, Floating, Inertias, Island, Memory, Pair, Place, StepMemory, Thing, Touch, World,
    Wrench,
};

/// Sum of the contacts' forces on the first of each pair (N).
fn force(contacts: &[Touch<f64>], h: f64) -> Vec3<f64> {
    contacts.iter().fold([0.0; 3], |sum, touch| {
        vec3::axpy(sum, 1.0 / h, touch.contact.to_inertial(touch.contact.impulse))
    })
}

#[test]
fn a_ball_falls_rests_and_its_weight_is_carried() {
    let h = 1e-3;
    let mut scene = Scene::falling();
    let (floor, ball) = (scene.floor(), scene.ball(5.0, 0.1, [0.0, 0.0, 0.12], [0.0; 3]));
    scene.pair(ball, floor, 0.4, 0.0);
    let mut last = [0.0; 3];
    let (x, imbalance, accounts) = scene.run(h, 2000, |report, contacts, _| {
        assert!(report.settled);
        last = force(contacts, h);
    });
    let weight = 5.0 * 9.81;
    println!("gap {:e}, force off by {:e}", x[2] - 0.1, last[2] / weight - 1.0);
    assert!((last[2] / weight - 1.0).abs() < 1e-9 && last[0] == 0.0);
    assert!((x[2] - 0.1).abs() < 2.0 * h * h * 9.81);
    // All that fell is lost in the impact; free fall and rest are followed exactly.
    assert!(
        (accounts.impact - weight * (0.12 - x[2])).abs() < 1e-9 && imbalance.abs() < 1e-12,
        "{imbalance:e}"
    );
}

#[test]
fn what_overlaps_leaves_by_a_fifth_a_step_on_the_way_to_rest() {
    let (h, overlap) = (1e-3, 1e-3);
    let mut scene = Scene::falling();
    let (floor, ball) = (scene.floor(), scene.ball(5.0, 0.1, [0.0, 0.0, 0.1 - overlap], [0.0; 3]));
    scene.pair(ball, floor, 0.4, 0.0);
    let (x, ()) = scene.with(|world, state, mut memory| {
        let mut left = overlap;
        for _ in 0..20 {
            let (report, leaving) = world.relax(0.0, h, state, &mut memory).expect("a step");
            // The share that a step takes away, in one step; no speed stays, and the weight is carried all the while.
            assert!((leaving - 0.2 * left / h).abs() < 1e-12, "{leaving} of {left}");
            left *= 0.8;
            assert!((0.1 - state.x()[2] - left).abs() < 1e-15, "{left}");
            assert!(report.active == 1 && (force(memory.contacts(), h)[2] / 49.05 - 1.0).abs() < 1e-9);
        }
    });
    assert!(x[7..].iter().all(|speed| speed.abs() < 1e-15), "{x:?}");
}

#[test]
fn nothing_rebounds_on_the_way_to_rest() {
    // Dropped by 20 mm with e = 1: a step of relaxation ends its fall as e = 0 does.
    let h = 1e-3;
    let mut scene = Scene::falling();
    let (floor, ball) = (scene.floor(), scene.ball(5.0, 0.1, [0.0, 0.0, 0.12], [0.0; 3]));
    scene.pair(ball, floor, 0.4, 1.0);
    let (x, ()) = scene.with(|world, state, mut memory| {
        for _ in 0..200 {
            world.relax(0.0, h, state, &mut memory).expect("a step");
        }
        assert!((force(memory.contacts(), h)[2] / 49.05 - 1.0).abs() < 1e-9);
    });
    assert!(x[7..].iter().all(|speed| speed.abs() < 1e-15) && (x[2] - 0.1).abs() < 1e-12, "{x:?}");
}

#[test]
fn a_ball_bounces_with_its_restitution() {
    // Heights of the first bounces against v+ = e v-, to order 1.
    let off = |h: f64| {
        let mut scene = Scene::falling();
        let (floor, ball) = (scene.floor(), scene.ball(1.0, 0.1, [0.0, 0.0, 0.3], [0.0; 3]));
        scene.pair(ball, floor, 0.0, 0.8);
        let (mut top, mut rises) = (0.0_f64, false);
        let steps = (0.55 / h).round() as u32;
        scene.run(h, steps, |_, contacts, x| {
            rises |= contacts.iter().any(|touch| touch.contact.impulse[0] > 0.0);
            top = if rises { top.max(x[2] - 0.1) } else { top };
        });
        (top - 0.64 * 0.2).abs()
    };
    let [coarse, fine] = [1e-3, 1e-4].map(off);
    println!("height off by {coarse:e}, {fine:e} m");
    assert!(coarse < 4e-3 && fine < 4e-4);
}

#[test]
fn a_box_slides_as_far_as_friction_lets_it_and_a_ball_rolls() {
    let (h, mu, speed) = (1e-3, 0.3, 2.0);
    let mut scene = Scene::falling();
    let half = [0.1, 0.1, 0.05];
    let (floor, block) = (scene.floor(), scene.cuboid(2.0, half, [0.0, 0.0, 0.05], [speed, 0.0, 0.0]));
    let ball = scene.ball(3.0, 0.1, [0.0, 1.0, 0.1], [speed, 0.0, 0.0]);
    scene.pair(block, floor, mu, 0.0);
    scene.pair(ball, floor, mu, 0.0);
    let mut jitter = 0.0_f64;
    let (x, imbalance, accounts) = scene.run(h, 2000, |report, contacts, _| {
        assert!(report.settled);
        jitter = jitter.max((carried(contacts, 0, h) / (2.0 * 9.81) - 1.0).abs());
    });
    println!("normal force varies by {jitter:e}");
    assert!(jitter < 1e-3);
    let way = speed * speed / (2.0 * mu * 9.81);
    println!("slid {} of {way} m, ledger {imbalance:e}", x[0]);
    assert!((x[0] - way).abs() < 2.0 * h * speed && x[1].abs() < 1e-12 && x[2] - 0.05 < 1e-6);
    let speeds = &x[14..];
    assert!(speeds[..6].iter().all(|u| u.abs() < 1e-9), "{speeds:?}");
    // A ball that slides ends in rolling with 5/7 of its speed.
    let (rolling, spin) = (speeds[6], speeds[10] / (0.4 * 3.0 * 0.01));
    assert!((rolling - 5.0 / 7.0 * speed).abs() < 1e-9, "{rolling}");
    assert!((rolling - 0.1 * spin).abs() < 1e-9, "{spin}");
    let lost = 0.5 * 2.0 * speed * speed + 0.5 * 3.0 * speed * speed * (2.0 / 7.0);
    assert!(
        (accounts.friction - lost).abs() < 1e-6 * lost && imbalance.abs() < 1e-9,
        "{}",
        accounts.friction
    );
}

/// Upward force on the upper side of a pair's contacts (N), friction included: facets are a little warped.
fn carried(contacts: &[Touch<f64>], pair: usize, h: f64) -> f64 {
    let up = |touch: &Touch<f64>| {
        let z = touch.contact.to_inertial(touch.contact.impulse)[2] / h;
        // The normal of a lower node under an upper face points down: the upper side is the second one.
        if touch.contact.axes[0][2] > 0.0 { z } else { -z }
    };
    contacts.iter().filter(|touch| touch.pair == pair).map(up).sum()
}

#[test]
fn three_flexible_cubes_stand_on_one_another() {
    let h = 2e-4;
    let mut scene = Scene::falling();
    let floor = scene.floor();
    let (mut below, mut height) = (floor, 0.0);
    for (level, edge) in [0.2, 0.17, 0.14].into_iter().enumerate() {
        // Smaller upwards and off the middle: every lower node stands over a face, none over a node or an edge.
        let shift = 0.013 * level as f64;
        height += 1e-3;
        let cube = scene.cube(edge, [shift, 0.6 * shift, height], [0.0; 3], 4e4, 60.0);
        scene.pair(cube, below, 0.5, 0.0);
        (below, height) = (cube, height + edge);
    }
    let mut forces = [0.0; 3];
    let (x, imbalance, accounts) = scene.run(h, 20_000, |report, contacts, _| {
        assert!(report.settled);
        forces = [0, 1, 2].map(|pair| carried(contacts, pair, h));
    });
    let weights = [3.0, 2.0, 1.0].map(|n| n * 9.81);
    let off = [0, 1, 2].map(|k| forces[k] / weights[k] - 1.0);
    let fastest = x[72..].iter().fold(0.0_f64, |most, v| most.max(v.abs()));
    println!("forces off by {off:?}, fastest {fastest:e} m/s, ledger {imbalance:e} of {accounts:?}");
    assert!(off.iter().all(|off| off.abs() < 1e-9), "{off:?}");
    assert!(fastest < 1e-9 && imbalance.abs() < 1e-3 * accounts.lost());
    // The highest nodes are where three cubes reach, sunk by what the springs give.
    let top = (0..24).map(|k| x[3 * k + 2]).fold(0.0, f64::max);
    assert!(0.505 < top && top < 0.51, "{top}");
}

/// A plane inclined by `ANGLE` about n2 and lifted by a cosine, as commanded.
const ANGLE: f64 = 0.2;

fn inclined(t: f64, _: usize) -> Frame<f64> {
    let (s, c) = ANGLE.sin_cos();
    let axes = [[c, 0.0, -s], [0.0, 1.0, 0.0], [s, 0.0, c]];
    let turn = 3.0;
    Frame {
        origin: [0.0, 0.0, 0.02 * (1.0 - (turn * t).cos())],
        axes,
        velocity: [0.0, 0.0, 0.02 * turn * (turn * t).sin()],
        angular_velocity: [0.0; 3],
    }
}

#[test]
fn a_ball_on_a_commanded_tilted_plane_rolls_or_slides_as_friction_says() {
    let (mass, radius, seconds) = (5.0, 0.1, 1.5);
    let run = |mu: f64, h: f64| {
        let mut scene = Scene::falling();
        scene.parts.push(Part::Driven(Commanded { law: inclined, ports: 1 }));
        let plane =
            scene.thing(Thing::Rigid { shape: Shape::HalfSpace, port: Some(0), place: Place::same() });
        let start = vec3::scale(inclined(0.0, 0).axes[2], radius);
        let ball = scene.ball(mass, radius, start, [0.0; 3]);
        scene.pair(ball, plane, mu, 0.0);
        let (x, imbalance, accounts) = scene.run(h, (seconds / h).round() as u32, |_, _, _| {});
        let frame = inclined(seconds, 0);
        let place = frame.place([x[0], x[1], x[2]]);
        (place, x, imbalance, accounts)
    };
    // Along the plane the lift adds its acceleration to that of gravity: its integrals are those of the lift.
    let fall = 0.5 * 9.81 * seconds * seconds + inclined(seconds, 0).origin[2];
    let h = 1e-3;
    let (place, _, imbalance, accounts) = run(0.6, h);
    let rolled = 5.0 / 7.0 * ANGLE.sin() * fall;
    println!(
        "rolled {} of {rolled} m, gap {:e}, ledger {imbalance:e}, {accounts:?}",
        place[0],
        place[2] - radius
    );
    assert!((place[0] - rolled).abs() < 3e-3 * rolled && (place[2] - radius).abs() < 1e-4);
    assert!(imbalance.abs() < 1e-9 && accounts.drive.abs() > 0.1, "{imbalance:e}");
    let mu = 0.03;
    let (place, ..) = run(mu, h);
    let slid = (ANGLE.sin() - mu * ANGLE.cos()) * fall;
    println!("slid {} of {slid} m", place[0]);
    assert!((place[0] - slid).abs() < 3e-3 * slid && (place[2] - radius).abs() < 1e-4);
}

#[test]
fn a_ball_falls_onto_a_bladder_and_lies_on_it() {
    let (h, mass, radius, steps) = (1e-4, 5.0, 0.1, 12_000);
    let mut scene = Scene { air_drag: 2.0, room: 600, ..Scene::falling() };
    let sheet = scene.bladder(13, 0.4, 300.0, None);
    let ball = scene.ball(mass, radius, [0.0, 0.0, 0.15], [0.0; 3]);
    scene.pair(sheet, ball, 0.4, 0.0);
    let (mut up, mut impulse, mut most) = (0.0, 0.0, 0);
    let (x, imbalance, accounts) = scene.run(h, steps, |report, contacts, _| {
        assert!(report.settled);
        up = -force(contacts, h)[2];
        impulse += h * up;
        most = most.max(report.active);
    });
    let weight = mass * 9.81;
    let gained = mass * x[x.len() - 3 * 121 - 4] + weight * h * f64::from(steps) - impulse;
    println!(
        "{most} contacts, force off by {:e}, momentum by {gained:e}, ledger {imbalance:e} of {accounts:?}",
        up / weight - 1.0
    );
    // It comes to rest slowly: what the contacts gave is its momentum at every instant.
    assert!((up / weight - 1.0).abs() < 1e-3 && gained.abs() < 1e-11, "{up} {gained:e}");
    assert!(imbalance.abs() < 1e-4 * accounts.lost() && most > 8, "{imbalance:e}");
    assert!(accounts.impact > 0.0 && accounts.drag > 0.0 && accounts.friction > 0.0);
}

#[test]
fn a_plate_on_a_bladder_carries_pressure_times_area() {
    let share = |n: usize| {
        let (h, gauge, width) = (2e-4 * 12.0 / (n - 1) as f64, 3000.0, 0.4);
        let mut scene = Scene { air_drag: 300.0 / (n * n) as f64, room: 2 * n * n, ..Scene::default() };
        let sheet = scene.bladder(n, width, gauge, None);
        // A plate above that looks down, wider than what it touches.
        let axes = [[1.0, 0.0, 0.0], [0.0, -1.0, 0.0], [0.0, 0.0, -1.0]];
        let place = Place { origin: [0.0, 0.0, 0.02], axes };
        let plate = scene.thing(Thing::Rigid { shape: Shape::HalfSpace, port: None, place });
        scene.pair(sheet, plate, 0.0, 0.0);
        let mut last = (0.0, 0);
        scene.run(h, (0.6 / h) as u32, |report, contacts, _| {
            last = (-force(contacts, h)[2], report.active);
        });
        let cell = width / (n - 1) as f64;
        println!("{n}: {} N at {} nodes", last.0, last.1);
        last.0 / (gauge * cell * cell * last.1 as f64)
    };
    for (n, share) in [9, 17, 25].map(|n| (n, share(n))) {
        println!("{n}: N/(p A) = {share}");
        // The edge of the contact is known to a node: half a row of some n on either side.
        assert!((share - 1.0).abs() < 1.6 / f64::from(n as u32), "{share}");
    }
}

/// Linear and angular momentum of a world of one ball (port 0) and a cube of eight nodes, with the sums of sizes.
fn momenta(x: &[f64], mass: f64) -> ([Vec3<f64>; 2], [f64; 2]) {
    let row = |k: usize| [x[k], x[k + 1], x[k + 2]];
    let p = vec3::scale(row(31), mass);
    let turn = vec3::cross(row(0), p);
    let spin = row(34);
    let mut sums = [p, vec3::add(turn, spin)];
    let mut sizes = [vec3::norm(p), vec3::norm(turn) + vec3::norm(spin)];
    for node in 0..8 {
        let p = vec3::scale(row(37 + 3 * node), 0.125);
        let turn = vec3::cross(row(7 + 3 * node), p);
        sums = [vec3::add(sums[0], p), vec3::add(sums[1], turn)];
        sizes = [sizes[0] + vec3::norm(p), sizes[1] + vec3::norm(turn)];
    }
    (sums, sizes)
}

#[test]
fn a_ball_and_a_cube_that_collide_in_free_space_keep_their_momenta() {
    let mut scene = Scene { room: 64, ..Scene::default() };
    let ball = scene.ball(2.0, 0.1, [0.0, 0.0, 0.0], [0.0, 0.3, 2.0]);
    let cube = scene.cube(0.2, [-0.08, -0.05, 0.2], [0.0, 0.0, -1.0], 4e4, 5.0);
    scene.pair(ball, cube, 0.3, 0.0);
    let (mut start, mut hit, mut moved) = (None, 0, [0.0_f64; 2]);
    let (_, imbalance, accounts) = scene.run(1e-4, 4000, |report, _, x| {
        hit += report.active;
        let (sums, sizes) = momenta(x, 2.0);
        let (first, _) = *start.get_or_insert((sums, sizes));
        for k in 0..2 {
            moved[k] = moved[k].max(vec3::norm(vec3::sub(sums[k], first[k])) / sizes[k]);
        }
    });
    println!("{hit} contacts, momenta move by {moved:?}, ledger {imbalance:e} of {accounts:?}");
    assert!(hit > 0 && accounts.friction > 0.0);
    // Forces and impulses of the middle act on one line there, so that angular momentum is kept to rounding, too.
    assert!(moved.iter().all(|moved| *moved < 1e-12), "{moved:?}");
    assert!(imbalance.abs() < 1e-3 * accounts.lost());
}

#[test]
fn a_ball_on_a_sprung_platform_loads_its_spring() {
    // A mechanism of one coordinate: the impulse at its port meets 1/M along n3 and nothing across.
    let (h, mass, stiffness) = (2e-4, 5.0, 2e4);
    let mut scene = Scene::falling();
    scene.parts.push(Part::Sprung(Platform { mass: 3.0, stiffness, gravity: 9.81, damping: 300.0 }));
    (scene.q, scene.u) = (vec![0.0], vec![0.0]);
    let top = scene.thing(Thing::Rigid {
        shape: Shape::HalfSpace,
        port: Some(0),
        place: Place::at([0.0, 0.0, 0.03]),
    });
    let ball = scene.ball(mass, 0.1, [0.0, 0.0, 0.15], [0.0; 3]);
    scene.pair(ball, top, 0.4, 0.0);
    let mut up = 0.0;
    let (x, ..) = scene.run(h, 10_000, |report, contacts, _| {
        assert!(report.settled);
        up = force(contacts, h)[2];
    });
    let (sunk, weight) = (-x[0], mass * 9.81);
    println!("sunk {sunk} m, gap {:e}, force off by {:e}", x[3] - 0.13 + sunk, up / weight - 1.0);
    assert!((sunk * stiffness / ((mass + 3.0) * 9.81) - 1.0).abs() < 1e-9);
    assert!((up / weight - 1.0).abs() < 1e-9 && (x[3] - 0.13 + sunk).abs() < 1e-5);
}

/// A ball falls 20 mm onto a bladder without dampers: error of the ledger, and the largest mean force over 10 ms.
fn drop(h: f64) -> (f64, f64) {
    let mut scene = Scene { room: 600, ..Scene::falling() };
    let sheet = scene.bladder(13, 0.4, 1500.0, None);
    scene.springs.iter_mut().for_each(|spring| spring.damping = 0.0);
    // 20 mm over the flat sheet, which the gas lifts while the ball falls.
    let ball = scene.ball(5.0, 0.1, [0.0, 0.0, 0.12], [0.0; 3]);
    scene.pair(sheet, ball, 0.4, 0.0);
    let window = (0.01 / h).round() as usize;
    let mut forces = Vec::new();
    let (_, imbalance, accounts) = scene.run(h, (0.12 / h).round() as u32, |_, contacts, _| {
        forces.push(-force(contacts, h)[2]);
    });
    let mean = |at: &[f64]| at.iter().sum::<f64>() / window as f64;
    let peak = forces.windows(window).map(mean).fold(0.0, f64::max);
    println!("h = {h}: ledger {imbalance:e} of {accounts:?}, peak {peak} N");
    (imbalance, peak)
}

#[test]
fn a_drop_of_20_mm_closes_its_ledger_to_order_two_and_its_peak_stays() {
    let [(coarse, first), (fine, second)] = [5e-5, 2.5e-5].map(drop);
    let change = (second / first - 1.0).abs();
    println!("peak changes by {change:e}, ledger by a factor {}", coarse / fine);
    assert!(change < 0.02, "{first} {second}");
    assert!((coarse / fine - 4.0).abs() < 0.5 && fine.abs() < 1e-4, "{coarse:e} {fine:e}");
}

#[test]
fn in_f32_a_box_slides_to_rest_as_well() {
    let floating =
        Floating { body: RigidBody { mass: 2.0_f32, inertia: [0.008; 3] }, gravity: [0.0, 0.0, -9.81] };
    let things = [
        Thing::Rigid { shape: Shape::HalfSpace, port: None, place: Place::same() },
        Thing::Rigid {
            shape: Shape::Cuboid(Cuboid { half: [0.1_f32; 3] }),
            port: Some(0),
            place: Place::same(),
        },
    ];
    let pairs = [Pair::striking([1, 0], 0.0, 0.3_f32)];
    let (mut frames, mut wrenches) = ([Frame::inertial()], [Wrench::zero()]);
    let memory = Memory::without_nodes(&mut frames, &mut wrenches);
    let island = Island::new(floating, Body::none(), &[], memory).expect("an island");
    let (mut x, mut low) = ([0.0_f32; 13], [0.0_f32; 13]);
    island
        .load(&[0.0, 0.0, 0.1, 1.0, 0.0, 0.0, 0.0], &[1.0, 0.0, 0.0, 0.0, 0.0, 0.0], &mut x)
        .expect("lengths");
    let mut world = World { island, things: &things, pairs: &pairs };
    let (mut first, mut last) = ([Frame::inertial()], [Frame::inertial()]);
    let mut twists = [[Twist::zero()]; 3];
    let [a, b, c] = &mut twists;
    let (mut couplings, mut answers) = ([Coupling::default()], [[[0.0_f32; 6]; 6]]);
    let (mut now, mut before) = ([Touch::empty(); 8], [Touch::empty(); 8]);
    let mut memory = StepMemory {
        scratch: &mut [0.0; StepMemory::<f32>::scratch(13)],
        frames: [&mut first, &mut last],
        twists: [a, b, c],
        normals: &mut [],
        inertias: Inertias { couplings: &mut couplings, answers: &mut answers, nodes: &mut [] },
        extents: &mut [],
        touches: [&mut now, &mut before],
        counts: [0; 2],
    };
    let mut state = State::new(&mut x, &mut low).expect("a state");
    let h = 1e-3_f32;
    for step in 0..1000_u16 {
        world.step(f32::from(step) * h, h, &mut state, &mut memory).expect("a step");
    }
    let force: f32 = memory.contacts().iter().map(|touch| touch.contact.impulse[0] / h).sum();
    let way = 1.0 / (2.0 * 0.3 * 9.81);
    println!("slid {} of {way} m, force {force}", state.x()[0]);
    assert!((state.x()[0] - way).abs() < 1e-3 && (state.x()[2] - 0.1).abs() < 1e-5);
    assert!((force / (2.0 * 9.81) - 1.0).abs() < 1e-5);
    // Room for three contacts where four are needed: refused, and the state stays.
    let old = state.x().to_vec();
    let (mut few, mut other) = ([Touch::empty(); 3], [Touch::empty(); 3]);
    memory.touches = [&mut few[..], &mut other[..]];
    memory.counts = [0; 2];
    assert_eq!(world.step(1.0, h, &mut state, &mut memory), Err(Fault::TooManyContacts));
    assert_eq!(state.x(), old);
}

#[test]
fn a_ball_that_lies_off_the_middle_of_a_bladder_is_found_in_few_sweeps() {
    // Between nodes, on them and over facets, as it rolls: one load must not be shared by contacts that say the same.
    let mut scene = Scene { air_drag: 2.0, room: 600, ..Scene::falling() };
    let sheet = scene.bladder(13, 0.4, 300.0, None);
    let ball = scene.ball(5.0, 0.1, [0.003, 0.002, 0.15], [0.05, 0.1, 0.0]);
    scene.pair(sheet, ball, 0.4, 0.0);
    let (mut sweeps, mut unsettled) = (0, 0);
    let (x, ..) = scene.run(1e-4, 5000, |report, _, _| {
        sweeps += report.sweeps;
        unsettled += usize::from(!report.settled);
    });
    println!(
        "{} sweeps a step, {unsettled} steps not to rounding; the ball is at {:?}",
        sweeps / 5000,
        &x[..3]
    );
    assert!(sweeps / 5000 < 20 && unsettled == 0);
    assert!((x[0] - 0.003).abs() > 1e-2);
}

#[test]
fn a_ball_on_a_bladder_that_a_floating_body_carries_keeps_both_momenta() {
    // The rim and the base are attached: their part of a contact, and of the gas, goes to the body through its port.
    let mut scene = Scene::floating_bladder();
    let (mut drift, mut hit) = (scene.drift(), 0);
    let (_, imbalance, accounts) = scene.run(1e-4, 4000, |report, _, x| {
        hit += report.active;
        drift.see(x);
    });
    let moved = drift.moved;
    println!("{hit} contacts, momenta move by {moved:?}, ledger {imbalance:e} of {accounts:?}");
    assert!(hit > 100 && accounts.friction > 0.0);
    assert!(moved.iter().all(|moved| *moved < 1e-12), "{moved:?}");
    assert!(imbalance.abs() < 1e-3 * accounts.lost());
}

/// A body with three principal moments that tumbles freely, far from a floor: `moreau` turns it to order 2 where
/// nothing touches, and so is the length of Euler parameters, which grew at every step by an explicit half step alone.
#[test]
fn what_touches_nothing_tumbles_to_order_two() {
    let tumbled = |steps: u32| {
        let mut scene = Scene { room: 8, ..Scene::default() };
        let floor = scene.thing(Thing::Rigid {
            shape: Shape::HalfSpace,
            port: None,
            place: Place::at([0.0, 0.0, -50.0]),
        });
        let body = RigidBody { mass: 2.0, inertia: [0.0083, 0.0167, 0.0217] };
        let shape = Shape::Sphere(Sphere { radius: 0.1 });
        let body = scene.rigid(shape, body, [0.0; 3], [0.0; 3]);
        scene.pair(body, floor, 0.4, 0.0);
        let n = scene.u.len();
        scene.u[n - 3..].copy_from_slice(&[0.03, 0.17, -0.04]);
        let (x, imbalance, _) = scene.run(2.0 / f64::from(steps), steps, |_, _, _| ());
        assert!(x[..3].iter().all(|x| *x == 0.0));
        let length = x[3..7].iter().map(|e| e * e).sum::<f64>();
        (x, imbalance.abs(), (length - 1.0).abs())
    };
    let runs = [2000, 4000, 8000].map(tumbled);
    let off = |k: usize| {
        let pairs = runs[k].0.iter().zip(&runs[k + 1].0).take(7);
        pairs.map(|(x, y)| (x - y).abs()).fold(0.0, f64::max)
    };
    let (coarse, fine) = (off(0), off(1));
    let lengths = runs.each_ref().map(|run| run.2);
    println!(
        "halving moves it by {coarse:e}, {fine:e}; lengths {lengths:?}, ledgers {:?}",
        runs.each_ref().map(|run| run.1)
    );
    assert!(coarse / fine > 3.5 && fine < 1e-3, "{coarse:e} {fine:e}");
    assert!(runs[1].1 / runs[2].1 > 3.5, "{:e} {:e}", runs[1].1, runs[2].1);
    assert!(lengths[0] / lengths[1] > 3.5 && lengths[2] < 1e-6, "{lengths:?}");
}

/// A mass on a spring, far from a floor, let go with the spring stretched: order of the frequency, and its relative
/// error at the smaller step over (h w)^2 or (h w)^4.
fn frequency(restrained: &[[usize; 2]]) -> (f64, f64) {
    let (mass, stiffness, stretched) = (0.5, 200.0, 0.01);
    let w = f64::sqrt(stiffness / mass);
    let off = |h: f64| {
        let mut scene = Scene { room: 8, restrained: restrained.to_vec(), ..Scene::default() };
        let tail = scene.node(0.0, true, [0.0; 3], [0.0; 3]);
        let head = scene.node(mass, false, [1.0 + stretched, 0.0, 0.0], [0.0; 3]);
        scene.springs.push(Spring { tail, head, stiffness, damping: 0.0, rest_length: 1.0 });
        scene.floor();
        // A step turns the phase plane, stretched along its axes: from rest, the cosine of the angle is the way back.
        let (x, ..) = scene.run(h, 1, |_, _, _| ());
        ((x[0] - 1.0) / stretched).acos() / (w * h) - 1.0
    };
    let steps = [0.2 / w, 0.1 / w];
    let [coarse, fine] = steps.map(off);
    let order = (coarse / fine).log2();
    (order, fine.abs() / (w * steps[1]).powf(order.round()))
}

#[test]
fn held_bodies_oscillate_at_frequencies_of_order_four_and_floating_ones_of_order_two() {
    for (restrained, order, factor) in [(&[[0, 2]][..], 4.0, 1.0 / 720.0), (&[], 2.0, 1.0 / 24.0)] {
        let (found, error) = frequency(restrained);
        println!("order {found:.3}, error {error:e} (h w)^{order}");
        assert!((found - order).abs() < 0.02, "{found}");
        assert!((error / factor - 1.0).abs() < 0.02, "{error:e} of {factor:e}");
    }
}

/// How far what is at rest moves in so many steps of 1 ms (m), sweeps a step, steps that did not converge.
fn stirs(mut scene: Scene, steps: u32) -> (f64, usize, usize) {
    let (mut moved, mut sweeps, mut unsettled) = (0.0_f64, 0, 0);
    let mut first: Vec<f64> = Vec::new();
    scene.run(1e-3, steps, |report, _, x| {
        sweeps += report.sweeps;
        unsettled += usize::from(!report.settled);
        if first.is_empty() {
            first = x.to_vec();
        }
        moved = x.iter().zip(&first).fold(moved, |most, (now, then)| most.max((now - then).abs()));
    });
    (moved, sweeps / steps as usize, unsettled)
}

/// Boxes of these masses on one another, at rest; the upper ones are the smaller ones.
fn stacked(masses: &[f64], friction: f64) -> Scene {
    let mut scene = Scene { room: 64 + 8 * masses.len(), ..Scene::falling() };
    let mut below = scene.floor();
    for (number, mass) in (0..).map(f64::from).zip(masses) {
        let half = [0.15 - 1e-3 * number, 0.15 - 2e-3 * number, 0.05];
        let block = scene.cuboid(*mass, half, [0.0, 0.0, 0.05 + 0.1 * number], [0.0; 3]);
        scene.pair(below, block, friction, 0.0);
        below = block;
    }
    scene
}

#[test]
fn a_heavy_plate_rests_on_light_balls() {
    for mass in [0.2, 0.02, 1e-3, 1e-5] {
        let mut scene = Scene::falling();
        let floor = scene.floor();
        let plate = scene.cuboid(10.0, [0.2, 0.2, 0.01], [0.0, 0.0, 0.05], [0.0; 3]);
        for [x, y] in [[0.1, 0.1], [-0.1, 0.1], [0.0, -0.12]] {
            let ball = scene.ball(mass, 0.02, [x, y, 0.02], [0.0; 3]);
            scene.pair(floor, ball, 0.3, 0.0);
            scene.pair(ball, plate, 0.3, 0.0);
        }
        let (moved, sweeps, unsettled) = stirs(scene, 1000);
        println!("{mass} kg: moved by {moved:e} m in 1 s, {sweeps} sweeps a step, {unsettled} unsettled");
        assert!(moved < 1e-6 && unsettled == 0);
    }
}

#[test]
fn a_heavy_box_rests_on_a_light_one() {
    for friction in [0.0, 0.3] {
        for mass in [1.0, 0.02, 0.01, 1e-3] {
            let (moved, sweeps, unsettled) = stirs(stacked(&[mass, 10.0], friction), 500);
            println!("{mass} kg, mu {friction}: moved by {moved:e}, {sweeps} sweeps, {unsettled} unsettled");
            assert!(moved < 1e-7 && unsettled == 0);
        }
    }
}

#[test]
fn a_stack_of_many_boxes_stands() {
    for number in [10, 20] {
        let (moved, sweeps, unsettled) = stirs(stacked(&vec![1.0; number], 0.4), 100);
        println!("{number} boxes: moved by {moved:e}, {sweeps} sweeps, {unsettled} unsettled");
        assert!(moved < 1e-7 && unsettled == 0);
    }
}
