//! Scenes of rigid bodies against closed forms: rest, bounce, slide, roll, leave, stack.

use smartbed_runtime::rigid::attitude::Attitude;
use smartbed_runtime::rigid::contact::{Mobility, Twist};
use smartbed_runtime::rigid::law::Law;
use smartbed_runtime::rigid::narrow::{Placed, features};
use smartbed_runtime::rigid::scene::{Fault, Memory, Pair, Part, Report, RigidScene, Touching};
use smartbed_runtime::rigid::struck::Struck;
use smartbed_runtime::rigid::{RigidBody, RigidState};
use smartbed_runtime::surface::{Capsule, Cuboid, Shape, Sphere};

pub const G: f64 = 9.81;

/// A scene that owns its memory.
pub struct World {
    pub parts: Vec<Part<f64>>,
    pub pairs: Vec<Pair<f64>>,
    pub states: Vec<RigidState<f64>>,
    pub room: usize,
    pub gravity: f64,
}

impl World {
    /// The half-space z <= 0, turned by an angle about y, and these bodies on it and on each other.
    pub fn new(incline: f64, law: Law<f64>, bodies: &[(Part<f64>, RigidState<f64>)]) -> World {
        let ground = Part { shape: Shape::HalfSpace, body: None };
        let attitude = Attitude::new([(0.5 * incline).cos(), 0.0, (0.5 * incline).sin(), 0.0]);
        let mut world = World {
            parts: vec![ground],
            pairs: Vec::new(),
            states: vec![RigidState { attitude, ..RigidState::at_rest([0.0; 3]) }],
            room: 64,
            gravity: G,
        };
        for (part, state) in bodies {
            let k = world.parts.len();
            (0..k).for_each(|other| world.pairs.push(Pair { parts: [k, other], law }));
            world.parts.push(*part);
            world.states.push(*state);
        }
        world
    }

    pub fn scene(&self) -> RigidScene<'_, f64> {
        RigidScene { parts: &self.parts, pairs: &self.pairs, gravity: [0.0, 0.0, -self.gravity] }
    }

    pub fn energy(&self) -> f64 {
        self.scene().energy(&self.states)
    }

    pub fn try_step(&mut self, h: f64) -> Result<Report<f64>, Fault> {
        let n = self.parts.len();
        let mut states = self.states.clone();
        let [mut a, mut b, mut c] = [0; 3].map(|_| states.clone());
        let (mut twists, mut spare) = (vec![Twist::zero(); n], vec![Twist::zero(); n]);
        let mut mobilities = vec![Mobility::fixed(); n];
        let (mut touching, mut along) =
            (vec![Touching::empty(); self.room], vec![Touching::empty(); self.room]);
        let mut struck = vec![Struck::new(Touching::empty().held.contact, &mobilities[..]); self.room];
        let mut memory = Memory {
            states: [&mut a, &mut b, &mut c],
            twists: &mut twists,
            spare: &mut spare,
            mobilities: &mut mobilities,
            touching: &mut touching,
            along: &mut along,
            struck: &mut struck,
        };
        let report = self.scene().step(&mut states, h, &mut memory);
        let same = format!("{states:?}") == format!("{:?}", self.states);
        assert!(report.is_ok() || same, "a refused step leaves the states");
        self.states = states;
        report
    }

    pub fn step(&mut self, h: f64) -> Report<f64> {
        self.try_step(h).expect("a step")
    }
}

pub fn stronge(e: f64, mu: f64) -> Law<f64> {
    Law::stronge(e, mu).expect("a law")
}

pub fn ball(mass: f64, radius: f64) -> Part<f64> {
    let inertia = [0.4 * mass * radius * radius; 3];
    Part { shape: Shape::Sphere(Sphere { radius }), body: Some(RigidBody { mass, inertia }) }
}

pub fn cuboid(mass: f64, half: [f64; 3]) -> Part<f64> {
    let [x, y, z] = half.map(|h| h * h);
    let inertia = [y + z, x + z, x + y].map(|s| mass * s / 3.0);
    Part { shape: Shape::Cuboid(Cuboid { half }), body: Some(RigidBody { mass, inertia }) }
}

pub fn close(a: f64, b: f64, within: f64) {
    assert!((a - b).abs() <= within, "{a} is not {b}: {:e} apart", (a - b).abs());
}

#[test]
fn a_ball_that_just_touches_rests_and_presses_with_its_weight() {
    // Fig. 4.1: F = F_internal + F_gravity, the first 0.
    let law = stronge(0.5, 0.3);
    let mut world = World::new(0.0, law, &[(ball(2.0, 0.1), RigidState::at_rest([0.3, 0.2, 0.1]))]);
    let start = world.states.clone();
    for _ in 0..1000 {
        let report = world.step(1e-2);
        assert_eq!((report.impacts, report.splits, report.held), (0, 1, 1));
        close(report.pressing, 2.0 * G, 1e-13);
    }
    assert_eq!(world.states, start, "not a bit moves in 10 s");
}

#[test]
fn a_flat_box_bounces_by_the_closed_form_until_it_rests() {
    for (e, law) in [(0.5, stronge(0.5, 0.4)), (0.6, Law::newton(0.6, 0.0).expect("a law"))] {
        let mut world =
            World::new(0.0, law, &[(cuboid(1.0, [0.2, 0.3, 0.1]), RigidState::at_rest([0.0, 0.0, 1.1]))]);
        let (h, mut impacts, mut lost) = (1e-2, 0, 0.0);
        let fall = (2.0 / G).sqrt();
        let end = fall * (1.0 + 2.0 * e / (1.0 - e));
        for step in 1..=((end / h) as usize + 20) {
            let report = world.step(h);
            impacts += report.impacts;
            lost += report.impact_loss;
            let (t, body) = (step as f64 * h, world.states[1]);
            assert!(body.position[2] >= 0.1 - 1e-10, "{t} {report:?} {body:?}");
            // Flight between the first impacts, each of speed e^k sqrt(2 g).
            let mut since = t - fall;
            let mut speed = e * G * fall;
            for bounce in 0..6 {
                let flight = 2.0 * speed / G;
                if since > 0.0 && since < flight {
                    let height = speed * since - 0.5 * G * since * since;
                    close(body.position[2] - 0.1, height, 1e-9);
                    assert_eq!(impacts, bounce + 1);
                }
                (since, speed) = (since - flight, speed * e);
            }
            assert!(body.angular_momentum.iter().all(|x| x.abs() <= 1e-12), "no spin");
        }
        let report = world.step(h);
        assert_eq!((report.impacts, report.held), (0, 4), "it rests in the end");
        close(report.pressing, G, 1e-9);
        close(world.energy(), 0.1 * G, 1e-9);
        close(lost, G, 1e-8);
    }
}

#[test]
fn three_boxes_stand_on_one_another() {
    let law = stronge(0.3, 0.5);
    let half = [0.2, 0.2, 0.2];
    let boxes: Vec<_> = (0..3)
        .map(|k| (cuboid(1.5, half), RigidState::at_rest([0.0, 0.0, 0.2 + 0.4 * f64::from(k)])))
        .collect();
    let mut world = World::new(0.0, law, &boxes);
    let start = world.states.clone();
    let mut events = 0;
    for _ in 0..1000 {
        let report = world.step(1e-2);
        events += report.impacts;
        // Three, two and one of them weigh on the faces from below.
        assert_eq!(report.held, 12);
        close(report.pressing, 6.0 * 1.5 * G, 1e-9 * 6.0 * 1.5 * G);
    }
    assert_eq!(events, 0, "no event in 10 s");
    for (now, then) in world.states.iter().zip(&start) {
        for i in 0..3 {
            close(now.position[i], then.position[i], 1e-12);
            close(now.velocity[i], 0.0, 1e-12);
        }
    }
    // Dropped together from a little above each other, they come to stand too, and no energy appears.
    let mut world = World::new(0.0, law, &boxes);
    (1..4).for_each(|k| world.states[k].position[2] += 0.01 * k as f64);
    let mut energy = world.energy();
    for _ in 0..400 {
        world.step(5e-3);
        assert!(world.energy() <= energy + 1e-9);
        energy = world.energy();
    }
    close(energy, 1.5 * G * (0.2 + 0.6 + 1.0), 1e-6);
}

/// Along the slope downwards, of a point.
fn down(incline: f64, x: [f64; 3]) -> f64 {
    x[0] * incline.cos() - x[2] * incline.sin()
}

#[test]
fn a_ball_rolls_or_slips_down_an_incline_as_friction_says() {
    let radius = 0.1;
    for (incline, mu) in [(0.3_f64, 0.5), (0.3, 0.02), (0.8, 0.2), (0.6, 0.0), (1.0, 1.0)] {
        let place = [radius * incline.sin(), 0.0, radius * incline.cos()];
        let mut world =
            World::new(incline, stronge(0.5, mu), &[(ball(0.7, radius), RigidState::at_rest(place))]);
        let rolls = mu >= 2.0 / 7.0 * incline.tan();
        let share = if rolls { 5.0 / 7.0 * incline.sin() } else { incline.sin() - mu * incline.cos() };
        for step in 1..=200 {
            world.step(1e-2);
            let t = f64::from(step) * 1e-2;
            let state = world.states[1];
            let gone: [f64; 3] = std::array::from_fn(|i| state.position[i] - place[i]);
            close(down(incline, gone), 0.5 * share * G * t * t, 1e-9 * t.max(1.0));
            let spin = state.angular_momentum[1] / (0.4 * 0.7 * radius * radius);
            let rate = if rolls { share * G * t / radius } else { 2.5 * mu * G * incline.cos() * t / radius };
            close(spin * radius, rate * radius, 1e-9);
        }
    }
}

#[test]
fn a_box_slides_to_rest_and_a_ball_comes_to_roll() {
    let (mu, speed) = (0.3, 2.0);
    let mut world = World::new(
        0.0,
        stronge(0.0, mu),
        &[(cuboid(1.0, [0.3, 0.2, 0.1]), RigidState::at_rest([0.0, 0.0, 0.1]))],
    );
    world.states[1].velocity = [speed * 0.6, speed * 0.8, 0.0];
    let stop = speed / (mu * G);
    let (mut friction, before) = (0.0, world.energy());
    for step in 1..=100 {
        friction += world.step(1e-2).friction_loss;
        let t = (f64::from(step) * 1e-2).min(stop);
        let way = speed * t - 0.5 * mu * G * t * t;
        close(world.states[1].position[0], 0.6 * way, 1e-11);
        close(world.states[1].position[1], 0.8 * way, 1e-11);
    }
    assert!(world.states[1].velocity.iter().all(|v| v.abs() <= 1e-12), "{:?}", world.states[1]);
    close(friction, before - world.energy(), 1e-10);
    // A ball set down sliding: rolls from t = 2 v/(7 mu g) on, with 5/7 of its speed.
    let mut world =
        World::new(0.0, stronge(0.0, mu), &[(ball(1.0, 0.1), RigidState::at_rest([0.0, 0.0, 0.1]))]);
    world.states[1].velocity = [speed, 0.0, 0.0];
    let rolls = 2.0 * speed / (7.0 * mu * G);
    for step in 1..=60 {
        world.step(1e-2);
        let t = f64::from(step) * 1e-2;
        let slid = t.min(rolls);
        let way = speed * slid - 0.5 * mu * G * slid * slid + 5.0 / 7.0 * speed * (t - slid);
        close(world.states[1].position[0], way, 1e-11);
    }
    close(world.states[1].velocity[0], 5.0 / 7.0 * speed, 1e-11);
}

#[test]
fn a_ball_leaves_a_dome_where_the_cosine_is_two_thirds() {
    let off = |h: f64| {
        let dome = Part { shape: Shape::Sphere(Sphere { radius: 1.0 }), body: None };
        let start = 0.05_f64;
        let reach = 1.1;
        let state = RigidState::at_rest([reach * start.sin(), 0.0, reach * start.cos()]);
        let mut world = World::new(0.0, stronge(0.0, 0.0), &[]);
        world.parts = vec![dome, ball(0.3, 0.1)];
        world.states = vec![RigidState::at_rest([0.0; 3]), state];
        world.pairs = vec![Pair { parts: [1, 0], law: stronge(0.0, 0.0) }];
        let energy = world.energy();
        loop {
            let before = world.states[1];
            let report = world.step(h);
            close(world.energy(), energy, 1e-2);
            if report.held == 0 {
                return (before.position[2] / reach - 2.0 / 3.0 * start.cos()).abs();
            }
            let radius = world.states[1].position.iter().map(|x| x * x).sum::<f64>().sqrt();
            close(radius, reach, 1e-9);
        }
    };
    // The end of contact is found to a step.
    for h in [4e-3, 1e-3, 2.5e-4] {
        let error = off(h);
        assert!(error <= 5.0 * h, "{h}: {error}");
    }
}

/// How deep the deepest overlap is.
pub fn depth(world: &World) -> f64 {
    let frames: Vec<_> = world.parts.iter().zip(&world.states).map(|(p, s)| p.frame(s)).collect();
    let placed = |k: usize| Placed { shape: &world.parts[k].shape, frame: &frames[k] };
    let gaps = world.pairs.iter().flat_map(|pair| {
        let found = features(placed(pair.parts[0]), placed(pair.parts[1]), 0.0);
        found.iter().map(|f| f.gap).collect::<Vec<_>>()
    });
    -gaps.fold(0.0, f64::min)
}

/// Two balls that strike the floor at the same instant by laws of their own: each rebounds by its own.
#[test]
fn laws_of_contacts_at_the_same_instant_stay_apart() {
    let [bouncy, dull] = [Law::newton(1.0, 0.0).expect("a law"), stronge(0.2, 0.0)];
    let balls = [-1.0, 1.0].map(|x| (ball(1.0, 0.1), RigidState::at_rest([x, 0.0, 0.6])));
    for laws in [[bouncy, dull], [dull, bouncy]] {
        let mut world = World::new(0.0, bouncy, &balls);
        for pair in &mut world.pairs {
            pair.law = if pair.parts[0] == 2 { laws[1] } else { laws[0] };
        }
        let (fall, h) = ((2.0 * 0.5 / G).sqrt(), 1e-2);
        let steps = (fall / h).ceil();
        (0..steps as usize).for_each(|_| assert!(world.step(h).impacts <= 1));
        for (state, law) in world.states[1..].iter().zip(laws) {
            let (since, speed) = (steps * h - fall, law.restitution() * G * fall);
            close(state.position[2], 0.1 + speed * since - 0.5 * G * since * since, 1e-10);
        }
    }
}

/// Two balls that overlap at the start and part: nothing strikes, nothing is split.
#[test]
fn bodies_that_overlap_and_part_fly_freely() {
    let moving =
        |x: f64, v: f64| RigidState { velocity: [v, 0.0, 0.0], ..RigidState::at_rest([x, 0.0, 5.0]) };
    let balls = [(ball(1.0, 0.1), moving(-0.095, -0.02)), (ball(2.0, 0.1), moving(0.095, 0.03))];
    let mut world = World::new(0.0, stronge(0.5, 0.3), &balls);
    for n in 1..=50 {
        let report = world.step(1e-2);
        let t = f64::from(n) * 1e-2;
        assert_eq!((report.impacts, report.splits, report.held), (0, 1, 0), "{t}");
        close(world.states[1].position[0], -0.095 - 0.02 * t, 1e-12);
        close(world.states[2].position[0], 0.095 + 0.03 * t, 1e-12);
    }
}

#[test]
fn a_capsule_rests_across_a_box_and_a_plank_on_two_rollers() {
    let quarter = core::f64::consts::FRAC_PI_2;
    let rod = |half_length| Shape::Capsule(Capsule { radius: 0.02, half_length });
    // A rod along y, tilted by a small angle in the plane of y, z.
    let lying = |tilt: f64| {
        let half = 0.5 * (quarter + tilt);
        Attitude::new([half.cos(), half.sin(), 0.0, 0.0])
    };
    let fixed = |shape| Part { shape, body: None };
    let at = |attitude, position| RigidState { attitude, ..RigidState::at_rest(position) };
    let slab = Shape::Cuboid(Cuboid { half: [0.1, 0.15, 0.05] });
    let long = Part { shape: rod(0.25), ..ball(0.7, 0.02) };
    let rest = |bodies: &[(Part<f64>, RigidState<f64>)], own: usize, weight: f64| {
        let mut world = World::new(0.0, stronge(0.0, 0.4), bodies);
        // Only what lies on the last part counts.
        world.pairs.retain(|pair| pair.parts[0] == own && pair.parts[1] != 0);
        let start = world.states[own].position;
        for step in 1..=1000 {
            let report = world.step(1e-2);
            let now = world.states[own];
            assert!((now.position[2] - start[2]).abs() < 2e-3, "{step}: {now:?}");
            if step > 900 {
                close(report.pressing, weight, 1e-9 * weight);
                assert!(now.velocity.iter().all(|v| v.abs() < 1e-9), "{now:?}");
            }
        }
        world.states[own].position[2]
    };
    for size in [0.0, 1e-12, 1e-6, 1e-3] {
        for tilt in [size, -size] {
            let bodies = [
                (fixed(slab), at(Attitude::identity(), [0.0; 3])),
                (long, at(lying(tilt), [0.03, 0.0, 0.07 + 0.15 * size])),
            ];
            close(rest(&bodies, 2, 0.7 * G), 0.07, 1e-8);
            // A plank on two rollers that are longer than it is wide; it comes to lie inclined as they are.
            let roller = |x| (fixed(rod(0.3)), at(lying(tilt), [x, 0.0, 0.0]));
            let plank =
                (cuboid(1.0, [0.4, 0.15, 0.015]), at(Attitude::identity(), [0.0, 0.0, 0.035 + 0.15 * size]));
            let height = rest(&[roller(-0.2), roller(0.2), plank], 3, G * tilt.cos());
            close(height, 0.035, 1e-8 + size * size);
        }
    }
}

#[test]
fn a_box_on_a_smaller_one_stays_there() {
    // Eight redundant contacts with friction: sweeps over their forces converge slowly (condition some 1e3).
    for (mu, mass, half, x) in [
        (0.05, 2.0, 0.2, 0.02),
        (0.2, 2.0, 0.2, 0.02),
        (0.4, 2.0, 0.2, 0.02),
        (0.5, 1.0, 0.2, 0.0),
        (0.5, 20.0, 0.2, 0.03),
        (0.9, 20.0, 0.5, 0.0),
    ] {
        let small = (cuboid(1.0, [0.05; 3]), RigidState::at_rest([0.0, 0.0, 0.05]));
        let big = (cuboid(mass, [half, half, 0.05]), RigidState::at_rest([x, 0.0, 0.15]));
        let mut world = World::new(0.0, stronge(0.0, mu), &[small, big]);
        world.pairs.retain(|pair| pair.parts != [2, 0]);
        for step in 0..300 {
            world.try_step(1e-3).unwrap_or_else(|fault| panic!("mu {mu}, {mass} kg, step {step}: {fault:?}"));
        }
        close(world.states[2].position[2], 0.15, 1e-12);
        close(world.states[2].position[0], x, 1e-12);
    }
}
