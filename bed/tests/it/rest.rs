//! Bodies at rest on bladders: contact forces, their positions, and friction. Poses of tiles against golden vectors.

use crate::sheet::bed;
use smartbed_bed::body::{Body, Joint, Segment, Shape};
use smartbed_bed::equilibrium::{Bed, Fault, GRAVITY, Solution, State, Tile, put_down, solve};
use smartbed_bed::pose::Pose;
use smartbed_bed::sheet::air::Air;
use smartbed_bed::tile::{self, Command};
use smartbed_runtime::rigid::attitude::Attitude;
use smartbed_runtime::vec3::{dot, norm, sub};

fn segment(shape: Shape, mass: f64) -> Segment {
    let name = "load".to_owned();
    Segment { name, shape: shape.into(), mass, centre: [0.0; 3], foundation: 2e6, free: [true; 6] }
}

fn place(bed: &Bed, body: &Body, poses: Vec<Pose>) -> Solution {
    let solution = put_down(bed, body, &bed.start(poses)).expect("rests");
    assert!(solution.imbalance < 1e-6, "{:e}", solution.imbalance);
    solution
}

const SIZE: [f64; 2] = [0.219, 0.2797];

pub fn four(intervals: [usize; 2], air: Air, friction: f64) -> Bed {
    let mut four = bed(intervals, SIZE, air);
    four.friction = friction;
    let at = |k: usize| Pose::at([((k % 2) as f64 - 0.5) * 0.225, ((k / 2) as f64 - 0.5) * 0.2857, 0.0]);
    four.tiles = (0..4).map(|k| Tile { pose: at(k), air }).collect();
    four
}

#[test]
fn a_ball_put_down_beside_the_middle_rolls_towards_it_and_rests() {
    let mut bed = bed([16, 16], [0.225, 0.225], Air::Regulated(1000.0));
    bed.friction = 0.4;
    let body = Body::single(segment(Shape::ball(0.1), 5.0));
    let solution = place(&bed, &body, vec![Pose::at([0.004, -0.003, 0.145])]);
    let up: f64 = solution.contacts[0].iter().map(|c| c.force()[2]).sum();
    assert!((up / (5.0 * GRAVITY) - 1.0).abs() < 1e-6);
    let [x, y, z] = solution.state.segments[0].place;
    // It rolls as it sinks, straight towards the middle, and not beyond.
    let [left_x, left_y] = [x / 0.004, y / -0.003];
    assert!((0.2..0.8).contains(&left_x) && (left_x - left_y).abs() < 0.05, "{x} {y}");
    assert!((0.05..0.1).contains(&z), "{z}");
    assert!(solution.contacts[0].iter().all(|c| c.touch.depth < 0.01));
}

#[test]
fn a_plate_feels_the_gas_where_the_sheet_lies_flat_on_it() {
    let bed = bed([24, 24], [0.225, 0.225], Air::Regulated(4000.0));
    let mut body = Body::single(segment(Shape { half: [0.2, 0.2, 0.05], radius: 0.01 }, 8.0));
    body.segments[0].foundation = 1e8;
    let solution = place(&bed, &body, vec![Pose::at([0.0, 0.0, 0.1])]);
    let inside = |c: &&smartbed_bed::equilibrium::Contact| c.place[0].abs().max(c.place[1].abs()) < 0.03;
    let pressures: Vec<f64> = solution.contacts[0].iter().filter(inside).map(|c| c.pressure()).collect();
    assert!(pressures.len() > 20);
    for p in pressures {
        assert!((p / 4000.0 - 1.0).abs() < 2e-3, "{p}");
    }
}

#[test]
fn loads_rest_on_four_bladders_regulated_or_sealed() {
    for air in [Air::Regulated(4000.0), Air::sealed(4000.0, SIZE[0] * SIZE[1] * 0.1 + 1.29e-3, 1.0)] {
        let bed = four([14, 16], air, 0.4);
        for (shape, height) in [
            (Shape::ball(0.15), 0.19),
            (Shape { half: [0.2, 0.0, 0.0], radius: 0.1 }, 0.14),
            (Shape { half: [0.2, 0.25, 0.02], radius: 0.02 }, 0.09),
        ] {
            let body = Body::single(segment(shape, 20.0));
            let solution = place(&bed, &body, vec![Pose::at([0.0, 0.0, height])]);
            let shares: Vec<f64> = solution
                .contacts
                .iter()
                .map(|own| own.iter().map(|c| c.force()[2]).sum::<f64>() / (20.0 * GRAVITY))
                .collect();
            // In the middle of four, each bears a quarter.
            for share in &shares {
                assert!((share - 0.25).abs() < 1e-4, "{shares:?}");
            }
            let sealed = matches!(air, Air::Sealed(..));
            assert!(solution.gauges.iter().all(|g| if sealed { *g > 4000.0 } else { *g == 4000.0 }));
        }
    }
}

/// A slab on four tiles that tilt together by steps; how far it has gone over the middle of the tiles.
fn tilted(friction: f64, slope: f64) -> Result<(f64, Solution), Fault> {
    let mut bed = four([14, 16], Air::Regulated(4000.0), friction);
    let body = Body::single(segment(Shape { half: [0.15, 0.2, 0.02], radius: 0.02 }, 20.0));
    let mut solution = place(&bed, &body, vec![Pose::at([0.0, 0.0, 0.09])]);
    for step in 1..=4 {
        let angle = (slope * step as f64 / 4.0).atan();
        for (k, tile) in bed.tiles.iter_mut().enumerate() {
            let x = ((k % 2) as f64 - 0.5) * 0.225;
            let y = ((k / 2) as f64 - 0.5) * 0.2857;
            tile.pose = Pose::turned([x * angle.cos(), y, -x * angle.sin()], [0.0, 1.0, 0.0], angle);
        }
        solution = solve(&bed, &body, &solution.state)?;
        assert!(solution.imbalance < 1e-6, "{:e}", solution.imbalance);
    }
    Ok((bed.tiles[0].pose.inwards(solution.state.segments[0].place)[0], solution))
}

#[test]
fn friction_holds_a_load_on_a_slope_and_keeps_to_its_cone() {
    let (before, flat) = tilted(0.4, 0.0).expect("rests");
    let (held, solution) = tilted(0.4, 0.06).expect("rests");
    assert!((held - before).abs() < 0.01, "{before} {held}");
    // A cover too smooth for the slope lets it slide off.
    assert!(matches!(tilted(0.02, 0.06), Err(Fault::NotFound(..))));
    assert!(flat.contacts.iter().flatten().all(|c| norm(c.drag) < 1e-3));
    let mut along = 0.0;
    for contact in solution.contacts.iter().flatten() {
        assert!(norm(contact.drag) <= 0.4 * contact.touch.force() * (1.0 + 1e-4) + 1e-4, "{contact:?}");
        assert!(dot(contact.drag, contact.touch.normal).abs() <= 1e-3 * (1.0 + norm(contact.drag)));
        along += contact.drag[0];
    }
    // What friction does along x balances what the normals do: together nothing.
    let all: f64 = solution.contacts.iter().flatten().map(|c| c.force()[0]).sum();
    assert!(all.abs() < 1e-6 * 20.0 * GRAVITY && along.abs() > 1.0, "{all} {along}");
}

#[test]
fn a_state_at_rest_stays_where_it_is() {
    let bed = four([14, 16], Air::Regulated(3000.0), 0.3);
    let body = Body::single(segment(Shape { half: [0.2, 0.0, 0.0], radius: 0.1 }, 15.0));
    let first = place(&bed, &body, vec![Pose::at([0.02, 0.0, 0.14])]);
    let again = solve(&bed, &body, &first.state).expect("rests");
    assert!(again.steps <= 1, "{}", again.steps);
    assert!(norm(sub(again.state.segments[0].place, first.state.segments[0].place)) < 1e-9);
}

#[test]
fn a_slack_bladder_lets_a_load_down_on_its_plate() {
    let mut bed = bed([12, 12], [0.225, 0.225], Air::Regulated(100.0));
    bed.depth = 0.03;
    let body = Body::single(segment(Shape::ball(0.08), 10.0));
    let solution = place(&bed, &body, vec![Pose::at([0.0, 0.0, 0.1])]);
    assert!(solution.bottomed[0] > 0);
    assert!(solution.state.segments[0].place[2] > 0.08 - 0.03 - 0.02);
}

#[test]
fn a_joint_holds_two_segments_and_turns_them_back() {
    let half = Shape { half: [0.08, 0.02, 0.0], radius: 0.04 };
    let mut body = Body { segments: vec![segment(half, 6.0), segment(half, 6.0)], joints: Vec::new() };
    body.joints.push(Joint {
        name: "hinge".to_owned(),
        segments: [0, 1],
        points: [[0.1, 0.0, 0.0], [-0.1, 0.0, 0.0]],
        posture: Attitude::identity(),
        stiffness: 1e6,
        turning: 20.0,
        limits: None,
    });
    let bed = four([14, 16], Air::Regulated(4000.0), 0.3);
    let poses = vec![Pose::at([-0.1, 0.0, 0.1]), Pose::at([0.1, 0.0, 0.1])];
    let solution = place(&bed, &body, poses);
    let [a, b] = [0, 1].map(|k| &solution.state.segments[k]);
    assert!(norm(sub(a.outwards([0.1, 0.0, 0.0]), b.outwards([-0.1, 0.0, 0.0]))) < 1e-3);
    let angle = body.joints[0].angle(&solution.state.segments);
    assert!(angle > 1e-4 && angle < 0.5, "{angle}");
    // Alike on both sides: each bears half.
    let up = |s: usize| -> f64 {
        solution.contacts.iter().flatten().filter(|c| c.touch.segment == s).map(|c| c.force()[2]).sum()
    };
    assert!((up(0) - up(1)).abs() < 1e-4 * up(0), "{} {}", up(0), up(1));
}

#[test]
fn a_load_beside_the_bed_is_a_fault() {
    let body = Body::single(segment(Shape::ball(0.05), 2.0));
    let bed = four([6, 6], Air::Regulated(4000.0), 0.4);
    let fault =
        solve(&bed, &body, &bed.start(vec![Pose::at([2.0, 0.0, 0.2])])).expect_err("nothing holds it");
    assert_eq!(fault, Fault::Lost);
    assert!(fault.to_string().contains("touches no bladder"), "{fault}");
}

#[test]
fn an_air_that_is_gone_is_a_fault() {
    let air = Air::sealed(4000.0, 1e-3, 1.4);
    let mut bed = bed([8, 8], [0.2, 0.2], air);
    bed.depth = -0.2;
    let state: State = bed.start(Vec::new());
    let message = solve(&bed, &Body::default(), &state).expect_err("no volume").to_string();
    assert!(message.starts_with("the bladder of tile 1 has collapsed to -"), "{message}");
}

/// Domain vectors of a star with its first screw on x: heights, tilt (deg), place; b = 0.1 m.
const GOLDEN: [([f64; 3], f64, [f64; 3]); 5] = [
    ([0.02, 0.0, 0.0], 7.594_643_368_59, [-4.386_049_658_68e-4, 0.0, 6.608_186_004_55e-3]),
    ([0.03, 0.01, -0.01], 13.003_911_942_8, [-6.580_071_972_34e-4, 1.139_701_897_36e-3, 0.01]),
    ([0.0, 0.02, -0.02], 13.003_911_942_8, [1.316_014_394_47e-3, 0.0, 0.0]),
    ([0.05, 0.02, 0.035], 9.826_429_815_83, [-3.722_289_127_31e-4, -6.447_193_888_95e-4, 0.035]),
    ([-0.04, 0.02, 0.02], 21.801_409_486_4, [-3.576_165_455_74e-3, 0.0, 1.430_466_182_29e-3]),
];

#[test]
fn tiles_stand_where_their_screws_put_them() {
    for (heights, tilt, expected) in GOLDEN {
        let command = tile::command(heights, 0.1);
        assert!((command.tilt().to_degrees() - tilt).abs() < 1e-10, "{command:?}");
        // The star's x lies along the bed's y: x_star = y, y_star = -x.
        let [x, y, z] = tile::pose(&command, 0.1).place;
        assert!(norm(sub([y, -x, z], expected)) < 1e-14, "{x} {y} {z} {expected:?}");
        let back = tile::heights(&command, 0.1);
        assert!(norm(sub(back, heights)) < 1e-16);
        // Each screw's connector lies in the platform's plane above its screw.
        let pose = tile::pose(&command, 0.1);
        let normal = pose.attitude.to_inertial([0.0, 0.0, 1.0]);
        for (k, height) in heights.iter().enumerate() {
            let azimuth = std::f64::consts::FRAC_PI_2 + std::f64::consts::TAU / 3.0 * k as f64;
            let connector = [0.1 * azimuth.cos(), 0.1 * azimuth.sin(), *height];
            assert!(dot(sub(connector, pose.place), normal).abs() < 1e-15);
        }
    }
}

#[test]
fn slopes_lean_the_normal_in_the_beds_axes() {
    let command = Command { heave: 0.01, slope: [0.1, 0.0] };
    let pose = tile::pose(&command, 0.09);
    let normal = pose.attitude.to_inertial([0.0, 0.0, 1.0]);
    assert!((normal[0] / normal[2] - 0.1).abs() < 1e-15 && normal[1].abs() < 1e-16);
    // 130 mm above the star a tilt of 5 deg drags the surface by 11.3 mm.
    let five = Command { heave: 0.0, slope: [5.0_f64.to_radians().tan(), 0.0] };
    assert!((tile::drag(&five, 0.09, 0.13)[0] - 0.0113).abs() < 2e-4);
}
