//! Nodes that touch a body: energy compensation along the sheet's springs.

use crate::draw::Draw;
use crate::dynamics::{go, up};
use smartbed_bed::body::{Body, Segment, Shape};
use smartbed_bed::dynamics::impact::{Sheet, Yields, strike};
use smartbed_bed::dynamics::{Impact, Matter, Method, Motion, Track, dropped};
use smartbed_bed::equilibrium::{GRAVITY, Touch};
use smartbed_bed::pose::Pose;
use smartbed_bed::sheet::Lattice;
use smartbed_bed::sheet::air::Air;
use smartbed_bed::tissue::Tissue;
use smartbed_runtime::vec3::{Vec3, add, axpy, cross, dot, norm, scale, sub};

const BALL: f64 = 5.0;

fn fall(matter: Matter, impact: Impact, method: Method, step: f64) -> Motion {
    let mut bed = crate::sheet::bed([8; 2], [0.219, 0.2797], Air::Regulated(4000.0));
    bed.friction = 0.4;
    let body = Body::single(Segment {
        name: "ball".to_owned(),
        shape: Shape::ball(0.1).into(),
        mass: BALL,
        centre: [0.0; 3],
        foundation: 2e6,
        free: [true; 6],
    });
    let state = dropped(&bed, &body, &[Pose::at([0.004, -0.003, 0.2])], 0.02).expect("sheets at rest");
    Motion::new(bed, body, state, matter, method, step).touching(impact)
}

/// Six points that have a segment's mass and moments.
fn points(segment: &Segment, pose: &Pose) -> [Vec3<f64>; 6] {
    let at = segment.shape.gyration();
    std::array::from_fn(|k| {
        let mut place = segment.centre;
        place[k / 2] += if k % 2 == 0 { at[k / 2] } else { -at[k / 2] };
        pose.outwards(place)
    })
}

/// Energy, momentum and its moment of points with masses.
fn books<'a>(points: impl Iterator<Item = (f64, Vec3<f64>, &'a Track)>) -> (f64, [Vec3<f64>; 2]) {
    let (mut energy, mut momenta) = (0.0, [[0.0; 3]; 2]);
    for (mass, place, track) in points {
        let p = scale(track.velocity, mass);
        energy += 0.5 * dot(p, track.velocity);
        momenta = [add(momenta[0], p), add(momenta[1], cross(place, p))];
    }
    (energy, momenta)
}

/// Two slabs and a sheet whose nodes move at random, some of them about to touch.
#[test]
fn an_impact_keeps_energy_and_momenta_and_ends_the_approach() {
    let mut dice = Draw(5);
    let lattice = Lattice::new([8, 10], [0.219, 0.2797], 5000.0).expect("a sheet");
    let (mass, mut struck, mut apart) = (5e-4, 0, 0);
    for case in 0..300 {
        // The first slab is free, held, or led straight down.
        let free = [[true; 6], [false; 6], [false, false, true, false, false, false]][case % 3];
        let one = |free, mass| Segment {
            name: String::new(),
            shape: Shape { half: [0.05, 0.03, 0.01], radius: 0.02 }.into(),
            mass,
            centre: [0.01, -0.02, 0.005],
            foundation: 2e6,
            free,
        };
        let body = Body { segments: vec![one(free, 2.0), one([true; 6], 0.1)], joints: Vec::new() };
        let poses = [0, 1].map(|_| {
            let [x, y, z] = dice.vector();
            Pose::turned([0.05 * x, 0.05 * y, 0.1 + 0.02 * z], [0.6, 0.0, 0.8], dice.next())
        });
        let mut places = lattice.bulged(0.03);
        places.iter_mut().for_each(|x| *x = axpy(*x, 2e-3, dice.vector()));
        let mut nodes: Vec<Track> = places.iter().map(|x| Track::at_rest(*x, [0.0; 3])).collect();
        nodes.iter_mut().for_each(|t| t.velocity = scale(dice.vector(), 0.3));
        let arms = [0, 1].map(|s| points(&body.segments[s], &poses[s]));
        let mut segments: Vec<[Track; 6]> = Vec::new();
        for (s, (arms, pose)) in arms.iter().zip(&poses).enumerate() {
            let (way, spin) = (dice.vector(), dice.vector());
            let allowed = |k: usize| if body.segments[s].free[k] { 1.0 } else { 0.0 };
            let way = [0, 1, 2].map(|k| allowed(k) * way[k]);
            let spin = [0, 1, 2].map(|k| allowed(3 + k) * spin[k]);
            segments.push(arms.map(|p| {
                let track = Track::at_rest(p, [0.0; 3]);
                Track { velocity: add(way, cross(spin, sub(p, pose.place))), ..track }
            }));
        }
        let count = 1 + case % 9;
        let touches: Vec<Touch> = (0..count)
            .map(|k| {
                let normal = dice.vector();
                Touch {
                    node: lattice.nodes() / 2 - 4 + k,
                    segment: k % 2,
                    depth: 1e-4,
                    normal: scale(normal, 1.0 / norm(normal)),
                    slope: 1.0,
                    stiffness: 1e3,
                    rest: 0.0,
                    along: 300.0,
                }
            })
            .collect();
        let is_free: Vec<bool> = (0..lattice.nodes()).map(|n| lattice.free(n).is_some()).collect();
        let masses = [2.0, 0.1];
        let all = |nodes: &[Track], segments: &[[Track; 6]]| {
            let of_nodes = nodes.iter().zip(&places).map(|(t, x)| (mass, *x, t));
            let of_cores =
                (0..12).map(|k| (masses[k / 6] / 6.0, arms[k / 6][k % 6], &segments[k / 6][k % 6]));
            books(of_nodes.chain(of_cores))
        };
        let rate = |touch: &Touch, nodes: &[Track], segments: &[[Track; 6]]| {
            // Velocity of the core at the node, from that of its middle and its turning.
            let (own, arms) = (&segments[touch.segment], &arms[touch.segment]);
            let middle =
                |f: &dyn Fn(usize) -> Vec3<f64>| scale((0..6).fold([0.0; 3], |s, k| add(s, f(k))), 1.0 / 6.0);
            let (at, way) = (middle(&|k| arms[k]), middle(&|k| own[k].velocity));
            let spin = (0..3).fold([0.0; 3], |sum, k| {
                let arm = sub(arms[2 * k], arms[2 * k + 1]);
                let part = cross(arm, sub(own[2 * k].velocity, own[2 * k + 1].velocity));
                axpy(sum, 0.5 / dot(arm, arm), part)
            });
            let core = add(way, cross(spin, sub(places[touch.node], at)));
            dot(touch.normal, sub(nodes[touch.node].velocity, core))
        };
        let rates: Vec<f64> = touches.iter().map(|t| rate(t, &nodes, &segments)).collect();
        let (energy, momenta) = all(&nodes, &segments);
        let lasting = [1.0, 0.3, 0.0][case / 3 % 3];
        let sheet = Sheet { lattice: &lattice, is_free: &is_free, seconds: 1e-3, last: 1e-3, lasting };
        let yields = Yields::new(&body, &poses, mass);
        let blow = strike(&sheet, &yields, &touches, &poses, &mut nodes, &mut segments);
        assert_eq!(blow.touches, rates.iter().filter(|r| **r < 0.0).count());
        let (after, sums) = all(&nodes, &segments);
        struck += blow.touches;
        let lost = (1.0 - lasting) * blow.handed_on;
        assert!((energy - after - lost).abs() < 1e-12 * energy, "{case}: {energy} {after} {blow:?}");
        assert!(blow.touches == 0 || blow.handed_on > 0.0);
        if case % 3 == 0 {
            for k in 0..2 {
                assert!(norm(sub(sums[k], momenta[k])) < 1e-13, "{case}: {momenta:?} {sums:?}");
            }
        }
        for (touch, before) in touches.iter().zip(&rates).filter(|(_, before)| **before < 0.0) {
            let now = rate(touch, &nodes, &segments);
            assert!(now > -1e-9, "{case}: {before} {now}");
            apart += usize::from(now > 1e-6);
        }
    }
    println!("{struck} touches, {apart} of which part");
    assert!(struck > 500 && apart < struck / 4, "{struck} {apart}");
}

/// Results of a fall: largest imbalance of energy, largest gain, peak of the 10 ms mean force, height.
fn fallen(mut motion: Motion, step: f64, seconds: f64) -> (f64, f64, f64, f64) {
    let (mut worst, mut made, mut forces, mut given) = (0.0_f64, 0.0_f64, Vec::new(), 0.0);
    go(&mut motion, seconds, |m| {
        worst = worst.max(m.ledger.left_over().abs());
        made = made.max(m.ledger.left_over());
        forces.push(up(m) + (m.blows.upwards - given) / step);
        given = m.blows.upwards;
    });
    let window = (0.01 / step).round() as usize;
    let means = forces.windows(window).map(|f| f.iter().sum::<f64>() / window as f64);
    let unit = BALL * GRAVITY * 0.05;
    (worst / unit, made / unit, means.fold(0.0, f64::max), motion.now.state.segments[0].place[2])
}

#[test]
fn compensation_and_implicit_contact_have_one_limit_and_compensation_keeps_better_books() {
    let both = [Impact::Compensation, Impact::Implicit];
    let steps = [4e-3, 2e-3, 1e-3, 2.5e-4];
    let run = |impact, step| fallen(fall(Matter::default(), impact, Method::Bdf2, step), step, 0.3);
    let [law, plain] = both.map(|impact| steps.map(|step| run(impact, step)));
    println!("compensation: {law:?}\nimplicit: {plain:?}");
    for (own, other) in law.iter().zip(&plain).take(3) {
        assert!(own.0 < 0.6 * other.0, "{own:?} {other:?}");
    }
    assert!(law[2].0 < 3e-4 && law[0].0 > 3.0 * law[2].0, "{law:?}");
    for (own, other) in law.iter().zip(&plain) {
        assert!(
            (own.2 / other.2 - 1.0).abs() < 2e-3 && (own.3 - other.3).abs() < 1.5e-4,
            "{own:?} {other:?}"
        );
    }
    assert!((law[3].2 / plain[3].2 - 1.0).abs() < 3e-4 && (law[3].3 - plain[3].3).abs() < 1.5e-5);
    for pair in law.windows(2) {
        assert!((pair[1].2 / pair[0].2 - 1.0).abs() < 0.02, "{law:?}");
    }
}

#[test]
fn without_losses_compensation_makes_no_energy_and_a_step_that_resolves_it_loses_little() {
    let still =
        Matter { sheet_loss: 0.0, tissue: Tissue { loss: 0.0, ..Tissue::DEFAULT }, ..Matter::default() };
    for method in [Method::Bdf2, Method::TrBdf2] {
        for step in [4e-3, 1e-3, 2.5e-4] {
            let found = fallen(fall(still, Impact::Compensation, method, step), step, 0.2);
            println!("{method:?} at {step:.1e}: {found:?}");
            assert!(found.0 < 4e-3 && found.1 < 1e-8, "{found:?}");
        }
    }
    // A node swings by some 1e4 rad/s: a sixteenth of a millisecond resolves it.
    let found = fallen(fall(still, Impact::Compensation, Method::TrBdf2, 6.25e-5), 6.25e-5, 0.2);
    println!("resolved: {found:?}");
    assert!(found.0 < 1e-4, "{found:?}");
}
