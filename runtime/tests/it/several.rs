//! Impacts at several points at once: energy, friction cone and momentum on random cases, springs in small steps, a
//! flat box.

use crate::random::Random;
use crate::vector::{Vector, cross, dot};
use smartbed_runtime::rigid::attitude::Attitude;
use smartbed_runtime::rigid::contact::{Contact, Mobility, Side, Twist};
use smartbed_runtime::rigid::impact::{Touch, resolve};
use smartbed_runtime::rigid::plastic::compensate_all;
use smartbed_runtime::rigid::several::strike_all;
use smartbed_runtime::rigid::struck::{Outcome, Struck};
use smartbed_runtime::rigid::{RigidBody, RigidState};

/// Bodies at rest in their poses, with velocities beside them.
struct Scene {
    bodies: Vec<Option<RigidBody<f64>>>,
    states: Vec<RigidState<f64>>,
    mobilities: Vec<Mobility<f64>>,
    twists: Vec<Twist<f64>>,
}

impl Scene {
    fn new(bodies: Vec<Option<RigidBody<f64>>>, states: Vec<RigidState<f64>>) -> Scene {
        let of = |(b, s): (&Option<RigidBody<f64>>, &RigidState<f64>)| match b {
            Some(body) => {
                (Mobility::of(body, s), Twist { velocity: s.velocity, angular: body.angular_velocity(s) })
            }
            None => (Mobility::fixed(), Twist::zero()),
        };
        let (mobilities, twists) = bodies.iter().zip(&states).map(of).unzip();
        Scene { bodies, states, mobilities, twists }
    }

    /// Energy, and momentum with angular momentum about the origin, with the sizes of their terms.
    fn totals(&self) -> (f64, [f64; 6], f64) {
        let (mut energy, mut momentum, mut size) = (0.0, [0.0; 6], 0.0);
        for ((body, state), twist) in self.bodies.iter().zip(&self.states).zip(&self.twists) {
            let Some(body) = body else { continue };
            let local = state.attitude.to_body(twist.angular);
            let spin = state.attitude.to_inertial(std::array::from_fn(|i| body.inertia[i] * local[i]));
            let p = twist.velocity.map(|v| body.mass * v);
            energy += 0.5 * (dot(p, twist.velocity) + dot(spin, twist.angular));
            let moment = cross(state.position, p);
            for i in 0..3 {
                momentum[i] += p[i];
                momentum[3 + i] += moment[i] + spin[i];
                size += p[i].abs() + moment[i].abs() + spin[i].abs();
            }
        }
        (energy, momentum, size)
    }

    fn struck(&self, contacts: &[Contact<f64>]) -> Vec<Struck<f64>> {
        contacts.iter().map(|c| Struck::new(*c, &self.mobilities[..])).collect()
    }

    fn strike(&mut self, struck: &mut [Struck<f64>]) -> Outcome {
        let mut spare = self.twists.clone();
        strike_all(struck, &self.mobilities[..], &mut self.twists, &mut spare)
    }
}

fn still(position: Vector) -> RigidState<f64> {
    let attitude = Attitude::identity();
    RigidState { position, velocity: [0.0; 3], attitude, angular_momentum: [0.0; 3] }
}

/// Moments of inertia of a box of these edges.
fn of_box(mass: f64, [x, y, z]: Vector) -> RigidBody<f64> {
    let inertia = [y * y + z * z, x * x + z * z, x * x + y * y].map(|s| mass * s / 12.0);
    RigidBody { mass, inertia }
}

fn random_scene(random: &mut Random) -> (Scene, Vec<Contact<f64>>) {
    let count = 2 + (random.between(0.0, 3.0) as usize).min(2);
    let mut bodies = Vec::new();
    let mut states = Vec::new();
    for number in 0..count {
        let edges = random.vector(1.0).map(|x| x.abs() + 0.05);
        let body = of_box(10_f64.powf(random.between(-2.0, 2.0)), edges);
        let [a, b, c] = random.vector(1.0);
        let attitude = Attitude::new([1.1 - a, a, b, c]);
        let spin = random.vector(3.0);
        let momentum = attitude.to_inertial(std::array::from_fn(|i| spin[i] * body.inertia[i]));
        let (position, velocity) = (random.vector(1.0), random.vector(3.0));
        states.push(RigidState { position, velocity, attitude, angular_momentum: momentum });
        // Sometimes the first body is fixed.
        let fixed = number == 0 && random.between(0.0, 1.0) < 0.3;
        bodies.push((!fixed).then_some(body));
    }
    let touches = 1 + (random.between(0.0, 4.0) as usize).min(3);
    let pick = |random: &mut Random| (random.between(0.0, count as f64) as usize).min(count - 1);
    let mut contacts = Vec::new();
    while contacts.len() < touches {
        let pair = [pick(random), pick(random)];
        if pair[0] == pair[1] {
            continue;
        }
        let n = random.vector(1.0);
        let normal = n.map(|x| x / dot(n, n).sqrt());
        let centers = pair.map(|k| states[k].position);
        let mut contact = Contact::new(pair, random.vector(1.0), normal, centers);
        contact.friction = if random.between(0.0, 1.0) < 0.2 { 0.0 } else { random.between(0.0, 2.0) };
        // The ends, 0 and 1, are among them.
        contact.restitution = random.between(-0.1, 1.1).clamp(0.0, 1.0);
        contacts.push(contact);
    }
    (Scene::new(bodies, states), contacts)
}

/// Random impacts of two to four bodies at one to four points; `SMARTBED_IMPACTS` for another number of them.
#[test]
fn no_impact_at_several_points_creates_energy_leaves_a_cone_or_changes_momentum() {
    let wanted = std::env::var("SMARTBED_IMPACTS").ok().and_then(|n| n.parse().ok());
    let mut random = Random::new(31);
    let (mut cut_short, mut worst) = (0, [0.0_f64; 3]);
    let number: u32 = wanted.unwrap_or(2_000);
    for trial in 0..number {
        let (mut scene, contacts) = random_scene(&mut random);
        let (energy, momentum, size) = scene.totals();
        let fixed = scene.bodies[0].is_none();
        let mut struck = scene.struck(&contacts);
        let compensated = trial % 4 == 3;
        let outcome = if compensated {
            let eta = random.between(0.0, 1.0);
            compensate_all(&mut struck, eta, &scene.mobilities[..], &mut scene.twists)
        } else {
            scene.strike(&mut struck)
        };
        cut_short += u32::from(!outcome.complete);
        let (after, end, size_after) = scene.totals();
        worst[0] = worst[0].max((after - energy) / energy);
        assert!(after <= energy * (1.0 + 1e-12), "{trial}: {energy} {after} {struck:?}");
        let mut impulses = 0.0;
        for s in &struck {
            let [n, x, y] = s.contact.impulse;
            impulses += 10.0 * n;
            assert!(
                n >= 0.0 && x.hypot(y) <= s.contact.friction * n * (1.0 + 1e-12),
                "{trial}: {:?}",
                s.contact
            );
            let speed = s.contact.relative(&scene.twists)[0];
            if outcome.complete {
                worst[1] = worst[1].max(-speed);
            }
            assert!(
                !outcome.complete || speed >= -1e-9,
                "{trial}: they part: {speed} {outcome:?} {compensated} {struck:?}"
            );
        }
        if !fixed {
            for (a, b) in momentum.iter().zip(end) {
                worst[2] = worst[2].max((a - b).abs() / (size + size_after + impulses));
            }
            assert!(worst[2] <= 1e-12, "{trial}: {}", worst[2]);
        }
    }
    let [gain, approach, momentum] = worst;
    println!(
        "{number} impacts: energy gained {gain:.1e}, approach left {approach:.1e} m/s, momentum {momentum:.1e}, cut short {cut_short}"
    );
    assert!(cut_short * 40 <= number, "{cut_short} of {number} took too many pieces");
}

/// A cube of 1 m that comes down flat on four corners.
fn flat_box(velocity: Vector, restitution: f64, friction: f64) -> (Scene, Vec<Contact<f64>>) {
    let state = RigidState { velocity, ..still([0.0, 0.0, 0.5]) };
    let scene = Scene::new(vec![Some(of_box(2.0, [1.0; 3])), None], vec![state, still([0.0; 3])]);
    let corners = [[-0.5, -0.5], [0.5, -0.5], [0.5, 0.5], [-0.5, 0.5]];
    let contact = |[x, y]: [f64; 2]| {
        let mut contact = Contact::new([0, 1], [x, y, 0.0], [0.0, 0.0, 1.0], [[0.0, 0.0, 0.5], [0.0; 3]]);
        (contact.restitution, contact.friction) = (restitution, friction);
        contact
    };
    (scene, corners.map(contact).to_vec())
}

#[test]
fn a_flat_box_rebounds_without_spin() {
    for e in [0.0, 0.01, 0.3, 0.7, 1.0] {
        for mu in [0.0, 0.4] {
            let (mut scene, contacts) = flat_box([0.0, 0.0, -3.0], e, mu);
            let mut struck = scene.struck(&contacts);
            assert!(scene.strike(&mut struck).complete);
            let twist = scene.twists[0];
            assert!((twist.velocity[2] - 3.0 * e).abs() <= 1e-11, "{e}: {twist:?}");
            assert!(twist.angular.iter().chain(&twist.velocity[..2]).all(|x| x.abs() <= 1e-13), "{twist:?}");
            for s in &struck {
                assert!((s.contact.impulse[0] - 0.25 * 2.0 * 3.0 * (1.0 + e)).abs() <= 1e-11);
            }
        }
    }
}

#[test]
fn one_contact_is_the_exact_impact_and_parting_bodies_are_left_alone() {
    let mut random = Random::new(33);
    for _ in 0..500 {
        let (mut scene, contacts) = random_scene(&mut random);
        let contact = contacts[0];
        let touch = Touch {
            inverse_mass: contact.inverse_mass(&scene.mobilities[..]),
            velocity: contact.relative(&scene.twists),
            friction: contact.friction,
            restitution: contact.restitution,
        };
        let exact = resolve(&touch).impulse;
        let mut struck = scene.struck(&[contact]);
        scene.strike(&mut struck);
        assert_eq!(struck[0].contact.impulse, exact);
        // A second contact that does not take part changes what the pieces can resolve only.
        let (mut apart, _) = flat_box([0.0, 0.0, 3.0], 0.5, 0.5);
        let mut away = apart.struck(&flat_box([0.0; 3], 0.5, 0.5).1);
        let before = apart.twists.clone();
        assert_eq!(apart.strike(&mut away), Outcome { pieces: 0, complete: true });
        assert_eq!(apart.twists, before);
    }
}

/// Springs of stiffness 1 (1/e^2 when unloading) between the bodies, by the midpoint rule in very small steps.
fn by_springs(scene: &mut Scene, contacts: &[Contact<f64>], dt: f64) -> Vec<f64> {
    let mut force = vec![0.0_f64; contacts.len()];
    let mut impulse = vec![0.0; contacts.len()];
    for _ in 0..4_000_000 {
        let mut pressing = false;
        let rates: Vec<f64> = contacts.iter().map(|c| c.relative(&scene.twists)[0]).collect();
        for (j, contact) in contacts.iter().enumerate() {
            if force[j] <= 0.0 && rates[j] >= 0.0 {
                continue;
            }
            pressing = true;
            let stiffness = if rates[j] > 0.0 { contact.restitution.powi(-2) } else { 1.0 };
            let middle = (force[j] - 0.5 * dt * stiffness * rates[j]).max(0.0);
            force[j] = (force[j] - dt * stiffness * rates[j]).max(0.0);
            impulse[j] += dt * middle;
            contact.push(&scene.mobilities[..], &mut scene.twists, [dt * middle, 0.0, 0.0]);
        }
        if !pressing {
            return impulse;
        }
    }
    impulse
}

#[test]
fn without_friction_impulses_are_shared_as_equal_springs_share_them() {
    // Three balls in a row, the first comes with 1 m/s; and a bar on two supports, hit beside its middle.
    let ball = RigidBody { mass: 1.0, inertia: [0.4; 3] };
    let balls = || {
        let mut states: Vec<_> = (0..3).map(|k| still([f64::from(k) * 2.0, 0.0, 0.0])).collect();
        states[0].velocity = [1.0, 0.0, 0.0];
        let scene = Scene::new(vec![Some(ball); 3], states);
        let contact = |k: usize, e: f64| {
            let x = 2.0 * k as f64;
            let centers = [[x, 0.0, 0.0], [x + 2.0, 0.0, 0.0]];
            let mut contact = Contact::new([k, k + 1], [x + 1.0, 0.0, 0.0], [-1.0, 0.0, 0.0], centers);
            contact.restitution = e;
            contact
        };
        (scene, contact)
    };
    for (e, f) in [(1.0, 1.0), (0.6, 0.9)] {
        let (mut scene, contact) = balls();
        let contacts = [contact(0, e), contact(1, f)];
        let mut struck = scene.struck(&contacts);
        scene.strike(&mut struck);
        let (mut other, _) = balls();
        let impulses = by_springs(&mut other, &contacts, 1e-5);
        for (s, p) in struck.iter().zip(impulses) {
            assert!((s.contact.impulse[0] - p).abs() <= 3e-4 * p, "{e}: {} {p}", s.contact.impulse[0]);
        }
    }
    // Equal springs: the third ball leaves first, the first falls back a little (no chain of two-body impacts gives
    // that).
    let (mut scene, contact) = balls();
    let mut struck = scene.struck(&[contact(0, 1.0), contact(1, 1.0)]);
    scene.strike(&mut struck);
    let [a, b, c] = [0, 1, 2].map(|k| scene.twists[k].velocity[0]);
    // v_a = 1/3 + cos(t)/2 + cos(3^(1/2) t)/6 until its force ends; then the other two follow one spring.
    let exact = [-0.130_261_7, 0.150_229_6, 0.980_032_1];
    let off = [a, b, c].iter().zip(exact).map(|(v, exact)| (v - exact).abs()).fold(0.0, f64::max);
    assert!(off < 2e-4 && (a * a + b * b + c * c - 1.0).abs() < 1e-12, "{a} {b} {c}");
}

#[test]
fn contacts_that_close_one_another_again_and_again_end_soon() {
    // A rod comes down on two points, one first: what stops an end pushes the other down, half as fast each time.
    for (e, friction) in [(0.0, 0.0), (0.0, 0.9), (0.3, 0.6)] {
        let (half, body) = (0.5, of_box(2.0, [1.0, 0.01, 0.01]));
        let state = RigidState { velocity: [0.1, 0.0, -0.5], ..still([0.0; 3]) };
        let mut scene = Scene::new(vec![Some(body), None], vec![state, still([0.0; 3])]);
        scene.twists[0].angular = [0.0, 1.0, 0.0];
        let contacts = [-half, half].map(|x| {
            let mut contact = Contact::new([0, 1], [x, 0.0, 0.0], [0.0, 0.0, 1.0], [[0.0; 3]; 2]);
            (contact.restitution, contact.friction) = (e, friction);
            contact
        });
        let (before, ..) = scene.totals();
        let mut struck = scene.struck(&contacts);
        let outcome = scene.strike(&mut struck);
        let (after, ..) = scene.totals();
        println!("e = {e}, mu = {friction}: {} pieces, {before} J, then {after} J", outcome.pieces);
        assert!(outcome.complete && outcome.pieces < 900, "{}", outcome.pieces);
        assert!(after <= before);
        // What closes more slowly than the pieces are exact is stopped in the end.
        let slowest = struck.iter().map(|s| s.contact.relative(&scene.twists)[0]).fold(f64::MAX, f64::min);
        assert!(slowest > -1e-13, "{slowest:e}");
    }
}

/// Random contacts of two bodies, one of each written twice: equal springs at one point share what one alone would
/// give, which is known in closed form. Friction turns with the slip in most of them.
#[test]
fn a_contact_written_twice_takes_the_impulse_of_one() {
    let mut random = Random::new(77);
    let mut all = Vec::new();
    while all.len() < 2000 {
        let (mut scene, contacts) = random_scene(&mut random);
        let contact = contacts[0];
        let start = scene.twists.clone();
        let before = contact.relative(&start);
        if before[0] > -0.1 {
            continue;
        }
        let mut alone = scene.struck(&[contact]);
        scene.strike(&mut alone);
        let expected = contact.relative(&scene.twists);
        scene.twists.copy_from_slice(&start);
        let mut both = scene.struck(&[contact, contact]);
        assert!(scene.strike(&mut both).complete);
        let found = contact.relative(&scene.twists);
        let off = (0..3).map(|i| (found[i] - expected[i]).abs()).fold(0.0, f64::max);
        all.push(off / dot(before, before).sqrt());
    }
    all.sort_by(f64::total_cmp);
    let [half, most, worst] = [0.5, 0.95, 1.0].map(|share| all[(share * all.len() as f64) as usize - 1]);
    println!(
        "of the speed before: half of them below {half:.1e}, 95 of 100 below {most:.1e}, worst {worst:.1e}"
    );
    // Largest where a slip stops within a piece and mu is above 1.
    assert!(half < 3e-6 && most < 2e-4 && worst < 1e-2);
}

/// What touches only an immovable body feels no other contact, and none feels it.
#[test]
fn contacts_that_feel_nothing_of_one_another_are_resolved_apart() {
    let mut random = Random::new(78);
    for _ in 0..500 {
        let (one, mut contacts) = random_scene(&mut random);
        let (other, more) = random_scene(&mut random);
        let apart = one.bodies.len();
        let mut both = Scene::new(
            [one.bodies.clone(), other.bodies.clone()].concat(),
            [one.states.clone(), other.states.clone()].concat(),
        );
        let (mut first, mut second) = (one, other);
        let (mut alone, mut beside) = (first.struck(&contacts), second.struck(&more));
        first.strike(&mut alone);
        second.strike(&mut beside);
        let moved = |side: Side<f64>| {
            let point = *side.points().next().expect("a body");
            Side::of_body(point.body + apart, point.arm)
        };
        contacts.extend(more.iter().map(|contact| Contact { sides: contact.sides.map(moved), ..*contact }));
        let mut all = both.struck(&contacts);
        both.strike(&mut all);
        let expected = [first.twists, second.twists].concat();
        for (found, expected) in both.twists.iter().zip(expected) {
            let off =
                found.velocity.iter().zip(expected.velocity).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
            assert!(off < 1e-10, "{off:e}");
        }
    }
}
