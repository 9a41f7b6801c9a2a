//! Impacts of flexible bodies at several points at once: conservation laws on random bodies, the thesis' formula for
//! one point.

use crate::random::Random;
use smartbed_runtime::contact::pair;
use smartbed_runtime::flexible::{Body, Massless, Spring};
use smartbed_runtime::rigid::contact::{Contact, Point, Side, Twist};
use smartbed_runtime::rigid::law::Kind;
use smartbed_runtime::rigid::struck::Struck;
use smartbed_runtime::vec3::{self, Vec3};
use smartbed_runtime::world::{Coupling, Inertias, InverseInertia, Setting, Spare};

/// Two flexible bodies: nodes 0 to 7 of each carry its facets, the others touch those of the other one.
struct Pair {
    mass: Vec<f64>,
    fixed: Vec<bool>,
    springs: Vec<Spring<f64>>,
    pos: Vec<Vec3<f64>>,
    vel: Vec<Vec3<f64>>,
}

fn node(number: usize, weight: f64) -> Option<Point<f64>> {
    Some(Point { body: number, arm: [0.0; 3], weight })
}

impl Pair {
    fn random(random: &mut Random) -> Pair {
        let mut pair = Pair { mass: vec![], fixed: vec![], springs: vec![], pos: vec![], vel: vec![] };
        for body in 0..2 {
            let (first, drift) = (12 * body, random.vector(3.0));
            for _ in 0..12 {
                pair.mass.push(10_f64.powf(random.between(-3.0, 3.0)));
                pair.fixed.push(false);
                pair.pos.push(random.vector(1.0));
                pair.vel.push(vec3::add(drift, random.vector(1.0)));
            }
            for (tail, head) in (0..12).flat_map(|i| (0..i).map(move |j| (i, j))) {
                if random.between(0.0, 1.0) < 0.4 {
                    let (tail, head) = (first + tail, first + head);
                    pair.springs.push(Spring { tail, head, stiffness: 1.0, damping: 0.0, rest_length: 1.0 });
                }
            }
        }
        pair
    }

    /// Contacts of nodes 8 to 11 of one body with facets of the other, in any direction: the nodes stand on the facets.
    fn contacts(&mut self, random: &mut Random) -> Vec<Contact<f64>> {
        let mut contacts = Vec::new();
        for k in 0..1 + (random.between(0.0, 6.0) as usize).min(5) {
            let (own, other) = if random.between(0.0, 1.0) < 0.5 { (0, 12) } else { (12, 0) };
            let touching = own + 8 + k % 4;
            if contacts.iter().any(|c: &Contact<f64>| c.sides[0].points().any(|p| p.body == touching)) {
                continue;
            }
            let [u, v] = [random.between(0.0, 1.0), random.between(0.0, 1.0)];
            let weights = [(1.0 - u) * (1.0 - v), u * (1.0 - v), u * v, (1.0 - u) * v];
            let corners =
                [0, 1, 2, 3].map(|n| other + n + if random.between(0.0, 1.0) < 0.5 { 4 } else { 0 });
            let foot =
                corners.iter().zip(weights).fold([0.0; 3], |sum, (c, w)| vec3::axpy(sum, w, self.pos[*c]));
            self.pos[touching] = foot;
            let (normal, _) = vec3::direction(random.vector(1.0));
            let facet = Side::blend([0, 1, 2, 3].map(|n| node(corners[n], weights[n])));
            let mut contact =
                Contact::between([Side::blend([node(touching, 1.0), None, None, None]), facet], normal);
            contact.friction = if random.between(0.0, 1.0) < 0.3 { 0.0 } else { random.between(0.0, 1.5) };
            contacts.push(contact);
        }
        contacts
    }

    fn body(&self) -> Body<'_, f64> {
        Body {
            mass: &self.mass,
            fixed: &self.fixed,
            inverse_mass: &[],
            springs: &self.springs,
            gravity: [0.0; 3],
            air_drag: 0.0,
            facets: &[],
            inflation: None,
            massless: Massless::default(),
            grids: &[],
            patches: None,
        }
    }

    fn twists(&self) -> Vec<Twist<f64>> {
        self.vel.iter().map(|v| Twist { velocity: *v, angular: [0.0; 3] }).collect()
    }

    /// Kinetic energy; linear and angular momentum, and the sums of their sizes.
    fn totals(&self, twists: &[Twist<f64>]) -> (f64, [Vec3<f64>; 2], [f64; 2]) {
        let (mut energy, mut sums, mut sizes) = (0.0, [[0.0; 3]; 2], [0.0; 2]);
        for ((mass, twist), x) in self.mass.iter().zip(twists).zip(&self.pos) {
            let p = vec3::scale(twist.velocity, *mass);
            energy += 0.5 * vec3::dot(p, twist.velocity);
            for (k, own) in [p, vec3::cross(*x, p)].into_iter().enumerate() {
                sums[k] = vec3::add(sums[k], own);
                sizes[k] += vec3::norm(own);
            }
        }
        (energy, sums, sizes)
    }

    /// The velocities after, the contacts with their impulses; was the solution found to rounding?
    fn strike(&self, contacts: &[Contact<f64>], eta: f64) -> (Vec<Twist<f64>>, Vec<Struck<f64>>, bool) {
        let mut yields: Vec<f64> = self.mass.iter().map(|m| 1.0 / m).collect();
        let (mut couplings, mut answers): ([Coupling; 0], [InverseInertia<f64>; 0]) = ([], []);
        let inertia = Inertias { couplings: &mut couplings, answers: &mut answers, nodes: &mut yields };
        let mut struck: Vec<Struck<f64>> = contacts.iter().map(|c| Struck::new(*c, &inertia)).collect();
        let (mut lifts, mut twists) = (struck.clone(), self.twists());
        let [mut one, mut other] = [twists.clone(), twists.clone()];
        let mut spare = Spare { lifts: &mut lifts, twists: [&mut one, &mut other] };
        let setting = Setting { body: &self.body(), pos: &self.pos, ports: 0, inertia: &inertia };
        let settled =
            setting.strike(&mut struck, Some((Kind::Compensation, eta.sqrt())), &mut twists, &mut spare);
        (twists, struck, settled)
    }
}

/// `SMARTBED_IMPACTS` for another number of pairs.
#[test]
fn two_flexible_bodies_at_several_points_keep_momenta_and_make_no_energy() {
    let number: u32 = std::env::var("SMARTBED_IMPACTS").ok().and_then(|n| n.parse().ok()).unwrap_or(2_000);
    let mut random = Random::new(12);
    let (mut worst, mut cut_short, mut several, mut rebounds) = ([0.0_f64; 4], 0, 0, 0.0_f64);
    for trial in 0..number {
        let mut pair = Pair::random(&mut random);
        let contacts = pair.contacts(&mut random);
        let share = random.between(-0.1, 1.1).clamp(0.0, 1.0);
        let rough = contacts.iter().any(|c| c.friction > 0.0);
        let before = pair.totals(&pair.twists());
        let (twists, struck, settled) = pair.strike(&contacts, share);
        let after = pair.totals(&twists);
        cut_short += u32::from(!settled);
        several += u32::from(contacts.len() > 1);
        worst[0] = worst[0].max(after.0 / before.0 - 1.0);
        if share == 1.0 && !rough {
            rebounds = rebounds.max((after.0 / before.0 - 1.0).abs());
        }
        for k in 0..2 {
            let moved = vec3::norm(vec3::sub(after.1[k], before.1[k])) / (before.2[k] + after.2[k]);
            worst[1] = worst[1].max(moved);
        }
        for s in &struck {
            let [n, x, y] = s.contact.impulse;
            assert!(
                n >= 0.0 && x.hypot(y) <= s.contact.friction * n * (1.0 + 1e-12),
                "{trial}: {:?}",
                s.contact
            );
            if settled {
                worst[2] = worst[2].max(-s.contact.relative(&twists)[0]);
            }
        }
        assert!(worst[0] <= 1e-12 && worst[1] <= 1e-12 && worst[2] <= 1e-9, "{trial}: {worst:?}");
    }
    println!(
        "{number} pairs ({several} at several points): energy gained {:.1e}, momenta {:.1e}, approach left {:.1e} m/s, \
         elastic without friction to {rebounds:.1e}, cut short {cut_short}",
        worst[0], worst[1], worst[2]
    );
    assert!(several * 2 > number && cut_short * 40 <= number && rebounds < 1e-12);
}

#[test]
fn one_touch_is_that_of_a_point_on_a_facet() {
    let mut random = Random::new(5);
    let mut worst = 0.0_f64;
    for _ in 0..500 {
        let mut bodies = Pair::random(&mut random);
        let mut contacts = bodies.contacts(&mut random);
        contacts.truncate(1);
        contacts[0].friction = 0.0;
        let eta = random.between(0.0, 1.0);
        let facet: Vec<Point<f64>> = contacts[0].sides[1].points().copied().collect();
        let touch = pair::Touch {
            point: contacts[0].sides[0].points().next().expect("a node").body,
            corners: std::array::from_fn(|k| facet[k].body),
            weights: std::array::from_fn(|k| facet[k].weight),
            normal: contacts[0].axes[0],
        };
        let (mut vel, mut field) = (bodies.vel.clone(), vec![[0.0; 3]; bodies.vel.len()]);
        let expected = pair::apply(&bodies.body(), &touch, eta, &bodies.pos, &mut vel, &mut field);
        let (twists, struck, _) = bodies.strike(&contacts, eta);
        let impulse = expected.map_or(0.0, |impact| impact.impulse);
        worst = worst.max((struck[0].contact.impulse[0] - impulse).abs() / impulse.max(1e-9));
        for (twist, v) in twists.iter().zip(&vel) {
            worst = worst.max(vec3::norm(vec3::sub(twist.velocity, *v)) / (1.0 + vec3::norm(*v)));
        }
    }
    println!("off by {worst:e}");
    assert!(worst < 1e-9, "{worst:e}");
}

#[test]
fn two_stacked_unit_masses_on_a_floor_give_the_formula_of_the_thesis() {
    let spring = Spring { tail: 0, head: 1, stiffness: 1.0, damping: 0.0, rest_length: 1.0 };
    let stack = Pair {
        mass: vec![1.0, 1.0],
        fixed: vec![false; 2],
        springs: vec![spring],
        pos: vec![[0.0; 3], [0.0, 0.0, 1.0]],
        vel: vec![[0.0, 0.0, -3.0], [0.0, 0.0, -4.0]],
    };
    let lower = Side::blend([node(0, 1.0), None, None, None]);
    let contact = Contact::between([lower, Side::fixed()], [0.0, 0.0, 1.0]);
    let (twists, struck, settled) = stack.strike(&[contact], 1.0);
    assert!(settled && twists[0].velocity[2].abs() < 1e-15);
    assert!((twists[1].velocity[2] + 5.0).abs() < 1e-14, "Eq. 4.13: {:?}", twists[1]);
    // The floor gives what momentum was lost: -7 before, -5 after.
    assert!((struck[0].contact.impulse[0] - 2.0).abs() < 1e-14);
}
