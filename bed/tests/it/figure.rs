//! The patient's figure: masses, postures, joint angles that are refused, and rest on the bed.

use smartbed_bed::body::anthropometry::{Part, Table};
use smartbed_bed::body::figure::{Figure, FigureError, Posture};
use smartbed_bed::body::{Limits, Rows};
use smartbed_bed::equilibrium::{Bed, Cover, Solution, Tile, put_down};
use smartbed_bed::map::Region;
use smartbed_bed::pose::Pose;
use smartbed_bed::sheet::Lattice;
use smartbed_bed::sheet::air::Air;
use smartbed_runtime::vec3::{norm, sub};

const TABLES: [Table; 3] = [Table::DeLevaMale, Table::DeLevaFemale, Table::Winter];

#[test]
fn masses_sum_to_one() {
    for table in TABLES {
        assert!((table.sum() - 1.0).abs() <= 1e-4 + 1e-12, "{table:?}: {}", table.sum());
        let all: f64 = Part::ALL.into_iter().map(|part| part.count() * table.share(part)).sum();
        assert!((all - 1.0).abs() < 1e-15);
        let figure = Figure::new(table, 75.0, 1.75, Posture::Supine, &[]).expect("a figure");
        assert!((figure.body.mass() / 75.0 - 1.0).abs() < 1e-14);
    }
}

#[test]
fn joints_meet_and_refuse_what_they_do_not_allow() {
    let bent = [("left knee".to_owned(), [-90.0, 0.0, 0.0]), ("right elbow".to_owned(), [90.0, 0.0, 0.0])];
    for posture in [Posture::Supine, Posture::SideLying, Posture::Sitting] {
        for own in [&bent[..], &[]] {
            let figure = Figure::new(Table::DeLevaMale, 75.0, 1.75, posture, own).expect("a figure");
            for joint in &figure.body.joints {
                let [a, b] = [0, 1].map(|k| figure.poses[joint.segments[k]].outwards(joint.points[k]));
                assert!(norm(sub(a, b)) < 1e-14, "{}", joint.name);
                assert!(joint.angle(&figure.poses) < 1e-7, "{}", joint.name);
            }
        }
    }
    let make = |joint: &str, angles| {
        Figure::new(Table::Winter, 75.0, 1.75, Posture::Supine, &[(joint.to_owned(), angles)])
            .expect_err("refused")
            .to_string()
    };
    assert_eq!(
        make("left knee", [30.0, 0.0, 0.0]),
        "joint `left knee`: flexion is 30 deg, expected -140 to 5 deg"
    );
    assert_eq!(
        make("right hip", [0.0, 60.0, 0.0]),
        "joint `right hip`: spread is 60 deg, expected -30 to 45 deg"
    );
    assert!(
        make("tail", [0.0; 3]).starts_with("no joint `tail`; there are waist, chest, neck, left shoulder")
    );
    assert_eq!(
        Figure::new(Table::Winter, 7.0, 1.75, Posture::Supine, &[]),
        Err(FigureError::Size(7.0, 1.75))
    );
    // Left and right are mirrors of one another.
    let figure = Figure::new(Table::DeLevaMale, 75.0, 1.75, Posture::Sitting, &[]).expect("a figure");
    for left in [4, 6, 8, 10, 12, 14] {
        let [a, b] = [left, left + 1].map(|k| figure.poses[k].place);
        assert!(norm(sub(a, [-b[0], b[1], b[2]])) < 1e-14, "{left}");
    }
}

pub fn whole_bed(intervals: [usize; 2], pressure: f64) -> Bed {
    let lattice = Lattice::new(intervals, [0.219, 0.2797], 5000.0).expect("a sheet");
    let at = |k: usize| Pose::at([((k % 4) as f64 - 1.5) * 0.225, (3.0 - (k / 4) as f64) * 0.2857, 0.0]);
    let tiles = (0..28).map(|k| Tile { pose: at(k), air: Air::Regulated(pressure) }).collect();
    Bed {
        lattice,
        depth: 0.1,
        tiles,
        friction: 0.4,
        rubbing: 0.0,
        beside: Vec::new(),
        cover: Cover::default(),
    }
}

pub fn lie(bed: &Bed, figure: &Figure, along: f64) -> Solution {
    let mut poses = figure.poses.clone();
    poses.iter_mut().for_each(|p| p.place[1] += along);
    // Above all bulges.
    let lowest = figure.body.segments.iter().zip(&poses).map(|(s, p)| p.place[2] - s.shape.reach());
    let lowest = lowest.fold(f64::INFINITY, f64::min);
    poses.iter_mut().for_each(|p| p.place[2] += 0.05 - lowest.min(0.0) * 0.5);
    put_down(bed, &figure.body, &bed.start(poses)).expect("rests")
}

#[test]
fn a_figure_rests_on_the_bed_in_each_posture() {
    let bed = whole_bed([8, 10], 4000.0);
    for (posture, along) in [(Posture::Supine, 0.0), (Posture::SideLying, 0.0), (Posture::Sitting, -0.2)] {
        let figure = Figure::new(Table::DeLevaMale, 75.0, 1.75, posture, &[]).expect("a figure");
        let solution = lie(&bed, &figure, along);
        assert!(solution.imbalance < 1e-6, "{posture:?}: {:e}", solution.imbalance);
        let carried = |region: Region| -> f64 {
            let contacts = solution.contacts.iter().flatten().filter(|c| {
                let pose = &solution.state.segments[c.touch.segment];
                let (point, normal) = (pose.inwards(c.place), pose.attitude.to_body(c.touch.normal));
                figure.region(c.touch.segment, point, normal) == Some(region)
            });
            contacts.map(|c| c.force()[2]).sum()
        };
        let [sacrum, ischia, side] = [Region::Sacrum, Region::Ischia, Region::Trochanters].map(carried);
        println!(
            "{posture:?} {} steps, sacrum {sacrum:.0} N, ischia {ischia:.0} N, trochanters {side:.0} N",
            solution.steps
        );
        match posture {
            Posture::Supine => {
                assert!(sacrum > 50.0 && ischia < 20.0);
                assert!(
                    carried(Region::Occiput) > 5.0 && carried(Region::Heels) > 1.0,
                    "{}",
                    carried(Region::Heels)
                );
            }
            Posture::SideLying => assert!(side > 10.0),
            Posture::Sitting => assert!(ischia > 100.0),
        }
        for joint in &figure.body.joints {
            let angle = joint.angle(&solution.state.segments).to_degrees();
            assert!(angle < 50.0, "{posture:?} {}: {angle}", joint.name);
        }
    }
}

/// A figure with its left knee bent by an angle (deg), and the result of its joint limits.
fn knee(degrees: f64) -> (Figure, [[[f64; 3]; 3]; 2], Limits) {
    let own = [("left knee".to_owned(), [-60.0, 0.0, 0.0])];
    let mut figure =
        Figure::new(Table::DeLevaMale, 75.0, 1.75, Posture::Supine, &own).expect("a figure").with_stops();
    let joint = figure.body.joints.iter().find(|j| j.name == "left knee").expect("a knee").clone();
    let [inner, outer] = joint.segments;
    let turn = Pose::turned([0.0; 3], [1.0, 0.0, 0.0], degrees.to_radians());
    figure.poses[outer].attitude = figure.poses[inner].of(&turn).attitude;
    let axes = [inner, outer].map(|s| figure.poses[s].attitude.axes());
    (figure, axes, joint.limits.expect("limits"))
}

#[test]
fn a_joint_presses_back_beyond_its_range() {
    // A knee bends by 140 deg and stretches by 5.
    for (degrees, beyond) in [(-60.0, 0.0), (4.9, 0.0), (10.0, 5.0_f64), (-145.0, -5.0)] {
        let (figure, [inner, outer], limits) = knee(degrees);
        assert!((limits.angles(&inner, &outer)[0] - degrees.to_radians()).abs() < 1e-12);
        let stops: Vec<_> = limits.stops(&inner, &outer).collect();
        assert_eq!(stops.len(), usize::from(beyond != 0.0), "{degrees}: {stops:?}");
        let energy = 0.5 * limits.stiffness * beyond.to_radians().powi(2);
        assert!((limits.energy(&inner, &outer) - energy).abs() < 1e-9);
        // Moments are the slope of the energy, about any axis.
        let joint = figure.body.joints.iter().find(|j| j.name == "left knee").expect("a knee");
        let mut rows = Rows::new(figure.body.segments.len());
        figure.body.add_to(&figure.poses, 0.0, &mut rows);
        for k in 0..3 {
            let energy = |way: f64| {
                let mut turned = figure.poses.clone();
                let mut axis = [0.0; 3];
                axis[k] = way;
                turned[joint.segments[1]] = turned[joint.segments[1]].moved([0.0; 3], axis);
                figure.body.energy(&turned, 0.0)
            };
            let slope = (energy(1e-5) - energy(-1e-5)) / 2e-5;
            let found = rows.gradient[6 * joint.segments[1] + 3 + k];
            assert!(
                (slope - found).abs() < 1e-5 * (1.0 + slope.abs()) + 1e-4,
                "{degrees} {k}: {slope} {found}"
            );
        }
    }
    // A raised arm is spread by more than a right angle and still within its range.
    for spread in [60.0, 120.0, 170.0] {
        let own = [("right shoulder".to_owned(), [20.0, spread, 10.0])];
        let figure =
            Figure::new(Table::DeLevaMale, 75.0, 1.75, Posture::Supine, &own).expect("a figure").with_stops();
        for joint in &figure.body.joints {
            let [inner, outer] = joint.segments.map(|s| figure.poses[s].attitude.axes());
            let limits = joint.limits.expect("limits");
            assert!(limits.energy(&inner, &outer) < 1e-12, "{} {spread}", joint.name);
        }
    }
}
