//! Impacts between sides of any kind at random: nodes, facets, floating bodies, a commanded frame, two ports of one
//! body.

use crate::random::Random;
use smartbed_runtime::mechanism::Fault;
use smartbed_runtime::rigid::attitude::Attitude;
use smartbed_runtime::rigid::contact::{Contact, Point, Side, Twist};
use smartbed_runtime::rigid::plastic::{compensate_all, stop};
use smartbed_runtime::rigid::several::strike_all;
use smartbed_runtime::rigid::struck::Struck;
use smartbed_runtime::rigid::{RigidBody, RigidState};
use smartbed_runtime::surface::Frame;
use smartbed_runtime::vec3::{self, Vec3};
use smartbed_runtime::world::{Carrier, Coupling, Floating, Group, Inertias, InverseInertia, Wrench};

/// A rigid body with ports at its centre and at two more places: impulses at one move the others.
#[derive(Clone)]
struct Ported {
    floating: Floating<f64>,
    /// From the centre, in N.
    places: Vec<Vec3<f64>>,
    fixed: bool,
}

impl Carrier<f64> for Ported {
    fn n_q(&self) -> usize {
        7
    }
    fn n_u(&self) -> usize {
        6
    }
    fn n_ports(&self) -> usize {
        self.places.len()
    }
    fn inverse_inertia(
        &mut self,
        t: f64,
        q: &[f64],
        u: &[f64],
        [seen, at]: [usize; 2],
    ) -> Result<InverseInertia<f64>, Fault> {
        if self.fixed {
            return Ok([[0.0; 6]; 6]);
        }
        let centre = self.floating.inverse_inertia(t, q, u, [0, 0])?;
        let columns: [[f64; 6]; 6] = std::array::from_fn(|column| {
            let unit: [f64; 6] = std::array::from_fn(|i| if i == column { 1.0 } else { 0.0 });
            let [fx, fy, fz, mx, my, mz] = unit;
            let [mx, my, mz] = vec3::add([mx, my, mz], vec3::cross(self.places[at], [fx, fy, fz]));
            let wrench = [fx, fy, fz, mx, my, mz];
            let change = centre.map(|row| row.iter().zip(wrench).map(|(c, w)| c * w).sum::<f64>());
            let [vx, vy, vz, wx, wy, wz] = change;
            let [x, y, z] = vec3::add([vx, vy, vz], vec3::cross([wx, wy, wz], self.places[seen]));
            [x, y, z, wx, wy, wz]
        });
        Ok(std::array::from_fn(|row| columns.map(|column| column[row])))
    }
    fn frames(&mut self, _: f64, _: &[f64], _: &[f64], _: &mut [Frame<f64>]) -> Result<(), Fault> {
        Ok(())
    }
    fn rates(
        &mut self,
        _: f64,
        _: &[f64],
        _: &[f64],
        _: &[Wrench<f64>],
        _: &mut [f64],
        _: &mut [f64],
    ) -> Result<f64, Fault> {
        Ok(1.0)
    }
    fn energy(&mut self, _: f64, _: &[f64], _: &[f64]) -> Result<(f64, f64), Fault> {
        Ok((0.0, 0.0))
    }
}

/// Three bodies (ports 0, 1 | 2 | 3) and nodes.
struct Scene {
    members: Vec<Ported>,
    states: Vec<RigidState<f64>>,
    masses: Vec<f64>,
    places: Vec<Vec3<f64>>,
    twists: Vec<Twist<f64>>,
}

const PORTS: usize = 4;
const NODES: usize = 12;
/// The body of each port.
const OWNER: [usize; PORTS] = [0, 0, 1, 2];

impl Scene {
    fn random(random: &mut Random) -> Scene {
        let mut members = Vec::new();
        let mut states = Vec::new();
        for number in 0..3 {
            let [x, y, z] = random.vector(1.0).map(|x| x.abs() + 0.05);
            let mass = 10_f64.powf(random.between(-2.0, 2.0));
            let inertia = [y * y + z * z, x * x + z * z, x * x + y * y].map(|s| mass * s / 12.0);
            let [a, b, c] = random.vector(1.0);
            let body = RigidBody { mass, inertia };
            let attitude = Attitude::new([1.1 - a, a, b, c]);
            let angular_momentum = vec3::scale(random.vector(1.0), mass);
            let (position, velocity) = (random.vector(1.0), random.vector(3.0));
            states.push(RigidState { position, velocity, attitude, angular_momentum });
            let places =
                if number == 0 { vec![random.vector(0.3), random.vector(0.3)] } else { vec![[0.0; 3]] };
            // Sometimes the last one moves as commanded, whatever strikes it.
            let fixed = number == 2 && random.between(0.0, 1.0) < 0.5;
            members.push(Ported { floating: Floating { body, gravity: [0.0; 3] }, places, fixed });
        }
        let masses = (0..NODES).map(|_| 10_f64.powf(random.between(-3.0, 1.0))).collect();
        let places = (0..NODES).map(|_| random.vector(1.0)).collect();
        let mut twists = Vec::new();
        for (port, owner) in OWNER.into_iter().enumerate() {
            let (body, state) = (members[owner].floating.body, &states[owner]);
            let own: &[Vec3<f64>] = &members[owner].places;
            let place = own[port.min(own.len() - 1)];
            let angular = body.angular_velocity(state);
            twists.push(Twist { velocity: body.point_velocity(state, place), angular });
        }
        twists.extend((0..NODES).map(|_| Twist { velocity: random.vector(3.0), angular: [0.0; 3] }));
        Scene { members, states, masses, places, twists }
    }

    /// A place of N seen from a port's origin.
    fn arm(&self, port: usize, place: Vec3<f64>) -> Vec3<f64> {
        let (owner, own) = (OWNER[port], if port == 1 { 1 } else { 0 });
        let origin = vec3::add(self.states[owner].position, self.members[owner].places[own]);
        vec3::sub(place, origin)
    }

    /// A side at a place: a point of a port, a node that stands there, or a facet whose foot it is, perhaps with a
    /// corner on a port or fixed in space. Returns its bodies too: impulses must act along one line.
    fn side(&self, random: &mut Random, place: Vec3<f64>) -> Side<f64> {
        let node = |random: &mut Random| (random.between(0.0, NODES as f64) as usize).min(NODES - 1);
        let port = |random: &mut Random| (random.between(0.0, PORTS as f64) as usize).min(PORTS - 1);
        match random.between(0.0, 4.0) as u32 {
            0 => Side::fixed(),
            1 => {
                let port = port(random);
                Side::of_body(port, self.arm(port, place))
            }
            2 => Side::of_body(PORTS + node(random), [0.0; 3]),
            _ => {
                let (u, v) = (random.between(0.0, 1.0), random.between(0.0, 1.0));
                let weights = [(1.0 - u) * (1.0 - v), u * (1.0 - v), u * v, (1.0 - u) * v];
                let first = (random.between(0.0, (NODES - 4) as f64)) as usize;
                let mut points = [None; 4];
                for (number, weight) in weights.into_iter().enumerate() {
                    let node = PORTS + first + number;
                    points[number] = Some(Point { body: node, arm: [0.0; 3], weight });
                }
                if random.between(0.0, 1.0) < 0.4 {
                    let port = port(random);
                    let arm = self.arm(port, self.places[first]);
                    points[0] = Some(Point { body: port, arm, weight: weights[0] });
                }
                if random.between(0.0, 1.0) < 0.2 {
                    points[3] = None;
                }
                Side::blend(points)
            }
        }
    }

    /// Kinetic energy of all parts from their masses, independent of the carriers' functions.
    fn energy(&self) -> f64 {
        let mut sum = 0.0;
        for port in [0, 2, 3] {
            let member = &self.members[OWNER[port]];
            if member.fixed {
                continue;
            }
            let (twist, place) = (self.twists[port], member.places[0]);
            let centre = vec3::sub(twist.velocity, vec3::cross(twist.angular, place));
            let local = self.states[OWNER[port]].attitude.to_body(twist.angular);
            let body = member.floating.body;
            sum += 0.5 * body.mass * vec3::dot(centre, centre);
            sum += (0..3).map(|i| 0.5 * body.inertia[i] * local[i] * local[i]).sum::<f64>();
        }
        let nodes = self.masses.iter().zip(&self.twists[PORTS..]);
        sum + nodes.map(|(m, t)| 0.5 * m * vec3::dot(t.velocity, t.velocity)).sum::<f64>()
    }

    /// Linear momentum and the sum of magnitudes; `given` is the momentum that commanded and fixed sides received.
    fn momentum(&self) -> (Vec3<f64>, f64) {
        let (mut sum, mut size) = ([0.0; 3], 0.0);
        let mut count = |m: f64, v: Vec3<f64>| {
            sum = vec3::axpy(sum, m, v);
            size += m * vec3::norm(v);
        };
        for port in [0, 2, 3] {
            let member = &self.members[OWNER[port]];
            if !member.fixed {
                let turn = vec3::cross(self.twists[port].angular, member.places[0]);
                count(member.floating.body.mass, vec3::sub(self.twists[port].velocity, turn));
            }
        }
        self.masses.iter().zip(&self.twists[PORTS..]).for_each(|(m, t)| count(*m, t.velocity));
        (sum, size)
    }
}

/// Random impacts at one to five touches, three laws in turn; `SMARTBED_IMPACTS` for another number of them.
#[test]
fn no_impact_of_random_sides_creates_energy_leaves_a_cone_or_changes_momentum() {
    let wanted = std::env::var("SMARTBED_IMPACTS").ok().and_then(|n| n.parse().ok());
    let number: u32 = wanted.unwrap_or(3_000);
    let mut random = Random::new(47);
    let (mut gain, mut moved, mut books, mut hits) = (0.0_f64, 0.0_f64, 0.0_f64, 0_u32);
    for trial in 0..number {
        let mut scene = Scene::random(&mut random);
        let mut members = scene.members.clone();
        let group = &mut Group { members: &mut members };
        let (mut q, mut u) = (Vec::new(), Vec::new());
        for state in &scene.states {
            q.extend(state.position);
            q.extend(state.attitude.parameters());
            u.extend(state.velocity);
            u.extend(state.angular_momentum);
        }
        let mut answers = vec![[[0.0; 6]; 6]; Inertias::answers(group)];
        assert_eq!(answers.len(), 6);
        let mut nodes: Vec<f64> = scene.masses.iter().map(|m| 1.0 / m).collect();
        let mut couplings = [Coupling::default(); PORTS];
        let mut inertia = Inertias { couplings: &mut couplings, answers: &mut answers, nodes: &mut nodes };
        inertia.ask(group, 0.0, (&q, &u), |_| true).expect("lengths");

        let mut contacts = Vec::new();
        for _ in 0..1 + (random.between(0.0, 5.0) as usize).min(4) {
            let place = random.vector(1.0);
            let sides = [scene.side(&mut random, place), scene.side(&mut random, place)];
            let normal = vec3::direction(random.vector(1.0)).0;
            let mut contact = Contact::between(sides, normal);
            contact.friction = random.between(-0.3, 1.5).max(0.0);
            contact.restitution = random.between(-0.1, 1.1).clamp(0.0, 1.0);
            // Two sides that move as one do not meet.
            if contact.inverse_mass(&inertia)[0][0] > 1e-9 {
                contacts.push(contact);
            }
        }
        let mut struck: Vec<_> = contacts.iter().map(|c| Struck::new(*c, &inertia)).collect();
        let (before, (momentum, size)) = (scene.energy(), scene.momentum());
        let start = scene.twists.clone();
        let settled = match trial % 3 {
            0 => stop(&mut struck, &inertia, &mut scene.twists),
            1 => compensate_all(&mut struck, random.between(0.0, 1.0), &inertia, &mut scene.twists).complete,
            _ => {
                let mut spare = scene.twists.clone();
                strike_all(&mut struck, &inertia, &mut scene.twists, &mut spare).complete
            }
        };
        hits += u32::from(scene.twists != start && settled);
        // A commanded body does work on what it strikes: there energy is judged in its own frame, at rest here.
        let commanded = scene.members[2].fixed;
        let mut given = [0.0; 3];
        for s in &struck {
            let [n, x, y] = s.contact.impulse;
            assert!(n >= 0.0, "{trial}: {n}");
            let rim = s.contact.friction * n;
            assert!((x * x + y * y).sqrt() <= rim * (1.0 + 1e-9) + 1e-15, "{trial}: cone");
            // What fixed sides, and corners fixed in space, have taken.
            s.contact.deal(s.contact.impulse, |body, _, impulse| {
                let held = body < PORTS && scene.members[OWNER[body]].fixed;
                given = if held { given } else { vec3::add(given, impulse) };
            });
        }
        let (after, _) = scene.momentum();
        let change = vec3::sub(vec3::sub(after, momentum), given);
        let impulses = struck.iter().fold(size, |sum, s| sum + vec3::norm(s.contact.impulse));
        moved = moved.max(vec3::norm(change) / impulses);
        let work: f64 = struck
            .iter()
            .map(|s| {
                let mean = vec3::scale(
                    vec3::add(s.contact.relative(&start), s.contact.relative(&scene.twists)),
                    0.5,
                );
                vec3::dot(s.contact.impulse, mean)
            })
            .sum();
        let held = &scene.twists[3];
        let drive: f64 = struck
            .iter()
            .map(|s| {
                let mut sum = 0.0;
                s.contact.deal(s.contact.impulse, |body, arm, impulse| {
                    sum += if commanded && body == 3 { vec3::dot(impulse, held.at(arm)) } else { 0.0 };
                });
                sum
            })
            .sum();
        // Energy by masses falls by the contacts' own work, which is never positive, less what the commanded body
        // gives; to rounding of the terms, works of single contacts before they cancel.
        let terms = struck.iter().fold(before, |sum, s| {
            let speed =
                vec3::norm(s.contact.relative(&start)) + vec3::norm(s.contact.relative(&scene.twists));
            sum + vec3::norm(s.contact.impulse) * speed
        });
        let off = (scene.energy() - before - (work - drive)).abs() / terms;
        books = books.max(off);
        assert!(off <= 1e-11, "{trial}: books {off:e}");
        gain = gain.max(work / before);
    }
    println!(
        "{hits} of {number}: energy rises by {gain:e} at most, momentum is off by {moved:e} of all terms, books by {books:e}"
    );
    assert!(gain <= 1e-12 && moved <= 1e-12, "{gain:e} {moved:e}");
    assert!(hits > number / 4);
}
