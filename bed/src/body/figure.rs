//! A figure of sixteen segments in a posture, and the region of the skin to which a point belongs.
//!
//! In: table, mass, stature, posture. Out: a [`Body`] with its poses when it lies straight. Axes of a segment of the
//! figure on its back: x to its left, y towards the head, z up. A joint turns the outer segment by flexion (about x),
//! spread (about z) and twist (about y), in this order from the inner segment; angles beyond the joint's range are
//! refused. Shapes and tissue moduli are our estimates, scaled with the square root of mass over stature.

use super::anthropometry::{Part, Table};
use super::{Body, Joint, Limits, Segment, Shape};
use crate::map::Region;
use crate::pose::Pose;
use smartbed_runtime::vec3::Vec3;
use std::fmt;

/// Stiffness (N m/rad) of a joint beyond its range; an estimate of ours.
const STOP: f64 = 300.0;

/// How the figure lies.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Posture {
    /// On its back.
    Supine,
    /// Turned by 30 deg to its right side; a cushion keeps the trunk from rolling back.
    SideLying,
    /// Legs straight, the trunk held upright.
    Sitting,
}

/// Angles of a joint (deg): flexion, spread, twist.
pub type Angles = [f64; 3];

/// A joint of the figure.
struct Link {
    name: String,
    /// Inner and outer segment.
    segments: [usize; 2],
    /// Position on each segment: in half lengths along y and in m across, with x for the left side.
    at: [Vec3<f64>; 2],
    /// Stiffness against rotation (N m/rad).
    turning: f64,
    /// Range of each angle (deg).
    range: [[f64; 2]; 3],
}

/// The reason why a figure cannot be made.
#[derive(Clone, Debug, PartialEq)]
pub enum FigureError {
    /// An angle outside its range: joint, which angle, its value, the range (deg).
    Range(String, &'static str, f64, [f64; 2]),
    /// There is no joint with this name.
    Unknown(String),
    /// Mass (kg) and stature (m) that no child or adult has.
    Size(f64, f64),
}

impl fmt::Display for FigureError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            FigureError::Range(joint, angle, found, [low, high]) => {
                write!(f, "joint `{joint}`: {angle} is {found} deg, expected {low} to {high} deg")
            }
            FigureError::Unknown(joint) => {
                let names: Vec<String> = links().into_iter().map(|l| l.name).collect();
                write!(f, "no joint `{joint}`; there are {}", names.join(", "))
            }
            FigureError::Size(mass, stature) => {
                write!(f, "{mass} kg and {stature} m: expected 20 to 350 kg and 1 to 2.3 m")
            }
        }
    }
}

impl std::error::Error for FigureError {}

/// Segments in their order: name, part, side (1 left, -1 right, 0 middle).
const SEGMENTS: [(&str, Part, f64); 16] = [
    ("lower trunk", Part::LowerTrunk, 0.0),
    ("middle trunk", Part::MiddleTrunk, 0.0),
    ("upper trunk", Part::UpperTrunk, 0.0),
    ("head", Part::Head, 0.0),
    ("left upper arm", Part::UpperArm, 1.0),
    ("right upper arm", Part::UpperArm, -1.0),
    ("left forearm", Part::Forearm, 1.0),
    ("right forearm", Part::Forearm, -1.0),
    ("left hand", Part::Hand, 1.0),
    ("right hand", Part::Hand, -1.0),
    ("left thigh", Part::Thigh, 1.0),
    ("right thigh", Part::Thigh, -1.0),
    ("left shank", Part::Shank, 1.0),
    ("right shank", Part::Shank, -1.0),
    ("left foot", Part::Foot, 1.0),
    ("right foot", Part::Foot, -1.0),
];

fn links() -> Vec<Link> {
    let mut links = vec![
        link(
            "waist",
            [0, 1],
            [[0.0, 1.0, 0.0], [0.0, -1.0, 0.0]],
            60.0,
            [[-30.0, 70.0], [-25.0, 25.0], [-30.0, 30.0]],
        ),
        link(
            "chest",
            [1, 2],
            [[0.0, 1.0, 0.0], [0.0, -1.0, 0.0]],
            60.0,
            [[-20.0, 40.0], [-20.0, 20.0], [-30.0, 30.0]],
        ),
        link(
            "neck",
            [2, 3],
            [[0.0, 1.0, 0.0], [0.0, -1.0, 0.0]],
            20.0,
            [[-60.0, 50.0], [-40.0, 40.0], [-70.0, 70.0]],
        ),
    ];
    for (k, (name, side)) in [("left", 1.0), ("right", -1.0)].into_iter().enumerate() {
        let name = |joint: &str| format!("{name} {joint}");
        let end = [[0.0, -1.0, 0.0], [0.0, 1.0, 0.0]];
        let beside = |x: f64, y: f64| [[side * x, y, 0.0], [0.0, 1.0, 0.0]];
        links.push(link(
            name("shoulder"),
            [2, 4 + k],
            beside(0.2, 0.5),
            20.0,
            [[-60.0, 180.0], [-45.0, 180.0], [-90.0, 90.0]],
        ));
        links.push(link(name("elbow"), [4 + k, 6 + k], end, 8.0, [[0.0, 145.0], [-5.0, 5.0], [-90.0, 90.0]]));
        links.push(link(
            name("wrist"),
            [6 + k, 8 + k],
            end,
            2.0,
            [[-70.0, 80.0], [-30.0, 30.0], [-5.0, 5.0]],
        ));
        links.push(link(
            name("hip"),
            [0, 10 + k],
            beside(0.09, -1.0),
            25.0,
            [[-20.0, 125.0], [-30.0, 45.0], [-45.0, 45.0]],
        ));
        links.push(link(
            name("knee"),
            [10 + k, 12 + k],
            end,
            15.0,
            [[-140.0, 5.0], [-5.0, 5.0], [-10.0, 10.0]],
        ));
        // The foot stands up from the shank's end, its heel behind.
        let ankle = [[0.0, -1.0, 0.0], [0.0, 0.0, -0.6]];
        links.push(link(
            name("ankle"),
            [12 + k, 14 + k],
            ankle,
            8.0,
            [[-50.0, 20.0], [-20.0, 20.0], [-30.0, 30.0]],
        ));
    }
    links
}

fn link(
    name: impl Into<String>,
    segments: [usize; 2],
    at: [Vec3<f64>; 2],
    turning: f64,
    range: [[f64; 2]; 3],
) -> Link {
    Link { name: name.into(), segments, at, turning, range }
}

/// Half lengths of the box across (x) and up (z), radius (m), and modulus of the tissue foundation (Pa/m).
fn outside(part: Part) -> ([f64; 2], f64, f64) {
    match part {
        Part::Head => ([0.0, 0.02], 0.075, 4e6),
        Part::UpperTrunk => ([0.10, 0.02], 0.09, 1.5e6),
        Part::MiddleTrunk => ([0.075, 0.015], 0.09, 1e6),
        Part::LowerTrunk => ([0.09, 0.01], 0.10, 0.8e6),
        Part::UpperArm => ([0.0, 0.0], 0.045, 1.5e6),
        Part::Forearm => ([0.01, 0.0], 0.035, 2e6),
        Part::Hand => ([0.02, 0.0], 0.016, 3e6),
        Part::Thigh => ([0.0, 0.0], 0.08, 0.8e6),
        Part::Shank => ([0.0, 0.0], 0.052, 1.2e6),
        Part::Foot => ([0.01, 0.0], 0.032, 4e6),
    }
}

/// A figure: its body, and the poses of its segments before it is put down.
#[derive(Clone, Debug, PartialEq)]
pub struct Figure {
    /// Segments and joints.
    pub body: Body,
    /// Part of the body that each segment is.
    pub parts: Vec<Part>,
    /// Poses, with the centre of the lower trunk above the origin.
    pub poses: Vec<Pose>,
    /// Limits of each joint.
    pub limits: Vec<Limits>,
}

impl Figure {
    /// A figure of this mass (kg) and stature (m), in a posture in which some joints have other angles.
    ///
    /// # Errors
    /// [`FigureError`].
    pub fn new(
        table: Table,
        mass: f64,
        stature: f64,
        posture: Posture,
        own: &[(String, Angles)],
    ) -> Result<Figure, FigureError> {
        if !((20.0..=350.0).contains(&mass) && (1.0..=2.3).contains(&stature)) {
            return Err(FigureError::Size(mass, stature));
        }
        let links = links();
        if let Some((joint, _)) = own.iter().find(|(joint, _)| links.iter().all(|l| l.name != *joint)) {
            return Err(FigureError::Unknown(joint.clone()));
        }
        // A heavier body of the same stature is wider and deeper: its cross section grows with mass over stature.
        let girth = ((mass / stature) / (73.0 / 1.741)).sqrt();
        let segments: Vec<Segment> = SEGMENTS
            .iter()
            .map(|(name, part, _)| segment(name, *part, table, mass, stature, girth))
            .collect();
        let mut body = Body { segments, joints: Vec::new() };
        let mut allowed = Vec::new();
        let mut poses = vec![Pose::at([0.0; 3]); SEGMENTS.len()];
        poses[0] = root(posture);
        for link in &links {
            let angles = own.iter().rev().find(|(joint, _)| *joint == link.name).map(|(_, angles)| *angles);
            let angles = angles.unwrap_or_else(|| usual(posture, &link.name));
            check(link, angles)?;
            // Spread and twist of the right side are those of the left side mirrored.
            let mirror = if link.name.starts_with("right") { -1.0 } else { 1.0 };
            let turned = [angles[0], mirror * angles[1], mirror * angles[2]];
            let joint = joint(link, turned, table, stature, girth);
            let inner = Pose { place: joint.points[0], attitude: joint.posture };
            let outer = poses[link.segments[0]].of(&inner);
            let place = outer.outwards(joint.points[1].map(|x| -x));
            poses[link.segments[1]] = Pose { place, attitude: outer.attitude };
            body.joints.push(joint);
            allowed.push(limits(link, turned, link.name.starts_with("right")));
        }
        // A cushion or muscles hold trunk and head in place besides the bed.
        for segment in &mut body.segments[..4] {
            match posture {
                Posture::Supine => {}
                Posture::SideLying => segment.free[4] = false,
                Posture::Sitting => (segment.free[3], segment.free[4]) = (false, false),
            }
        }
        let parts = SEGMENTS.iter().map(|s| s.1).collect();
        Ok(Figure { body, parts, poses, limits: allowed })
    }

    /// The figure with stops at the ends of its joints' ranges.
    #[must_use]
    pub fn with_stops(mut self) -> Figure {
        self.body
            .joints
            .iter_mut()
            .zip(&self.limits)
            .for_each(|(joint, limits)| joint.limits = Some(*limits));
        self
    }

    /// The region of a point on a segment's skin, given in the segment's axes with its outward normal.
    #[must_use]
    pub fn region(&self, segment: usize, point: Vec3<f64>, normal: Vec3<f64>) -> Option<Region> {
        let Shape { half, radius } = *self.body.segments[segment].shape.round()?;
        let length = half[1] + radius;
        let (is_back, is_side) = (normal[2] < -0.5, normal[0].abs() > 0.6);
        match self.parts[segment] {
            Part::Head if is_back => Some(Region::Occiput),
            Part::UpperTrunk if is_back && point[0].abs() > 0.03 => Some(Region::Scapulae),
            Part::LowerTrunk if normal[1] < -0.5 => Some(Region::Ischia),
            Part::LowerTrunk if is_side => Some(Region::Trochanters),
            Part::LowerTrunk if is_back => Some(Region::Sacrum),
            Part::Thigh if is_side && point[1] > 0.4 * length => Some(Region::Trochanters),
            Part::UpperArm if point[1] < -0.6 * length => Some(Region::Elbows),
            Part::Forearm if point[1] > 0.6 * length => Some(Region::Elbows),
            Part::Foot if point[2] < -0.5 * (half[2] + radius) => Some(Region::Heels),
            _ => None,
        }
    }
}

fn segment(name: &str, part: Part, table: Table, mass: f64, stature: f64, girth: f64) -> Segment {
    let length = table.length(part, stature);
    let ([across, up], radius, foundation) = outside(part);
    let radius = girth * radius;
    // Ends are round: the box is shorter by what the radius adds, except for trunks, which adjoin each other.
    let is_trunk = matches!(part, Part::UpperTrunk | Part::MiddleTrunk | Part::LowerTrunk);
    let inner = if is_trunk { 0.5 * length - 0.5 * radius } else { 0.5 * length - radius };
    let inner = inner.max(0.0);
    let (_, from_head) = table.printed(part);
    let along = (0.5 - from_head) * length;
    let (half, centre) = match part {
        Part::Foot => ([girth * across, 0.0, inner], [0.0, 0.0, -along]),
        _ => ([girth * across, inner, girth * up], [0.0, along, 0.0]),
    };
    let mass = table.share(part) * mass;
    Segment {
        name: name.to_owned(),
        shape: Shape { half, radius }.into(),
        mass,
        centre,
        foundation,
        free: [true; 6],
    }
}

fn joint(link: &Link, angles: Angles, table: Table, stature: f64, girth: f64) -> Joint {
    let point = |k: usize| {
        let part = SEGMENTS[link.segments[k]].1;
        let half = 0.5 * table.length(part, stature);
        let [x, y, z] = link.at[k];
        [girth * x, y * half, z * half]
    };
    let turn = |axis: Vec3<f64>, degrees: f64| Pose::turned([0.0; 3], axis, degrees.to_radians());
    let [flexion, spread, twist] = angles;
    let turns =
        turn([1.0, 0.0, 0.0], flexion).of(&turn([0.0, 0.0, 1.0], spread)).of(&turn([0.0, 1.0, 0.0], twist));
    Joint {
        name: link.name.clone(),
        segments: link.segments,
        points: [point(0), point(1)],
        posture: turns.attitude,
        stiffness: 2e5,
        turning: link.turning,
        limits: None,
    }
}

/// Limits of a joint, mirrored for the right side.
fn limits(link: &Link, posture: Angles, is_right: bool) -> Limits {
    let mut range = link.range;
    if is_right {
        (1..3).for_each(|k| range[k] = [-range[k][1], -range[k][0]]);
    }
    let radians = |degrees: [f64; 2]| degrees.map(f64::to_radians);
    Limits { posture: posture.map(f64::to_radians), range: range.map(radians), stiffness: STOP }
}

fn check(link: &Link, angles: Angles) -> Result<(), FigureError> {
    for ((name, angle), [low, high]) in ["flexion", "spread", "twist"].into_iter().zip(angles).zip(link.range)
    {
        if !(low..=high).contains(&angle) {
            return Err(FigureError::Range(link.name.clone(), name, angle, [low, high]));
        }
    }
    Ok(())
}

/// Pose of the lower trunk.
fn root(posture: Posture) -> Pose {
    match posture {
        Posture::Supine => Pose::at([0.0; 3]),
        Posture::SideLying => Pose::turned([0.0; 3], [0.0, 1.0, 0.0], 30.0_f64.to_radians()),
        Posture::Sitting => Pose::turned([0.0; 3], [1.0, 0.0, 0.0], 80.0_f64.to_radians()),
    }
}

/// Joint angles of a posture (deg); arms and legs lie slightly apart.
fn usual(posture: Posture, joint: &str) -> Angles {
    let name = joint.rsplit(' ').next().unwrap_or_default();
    match (posture, name) {
        (Posture::Sitting, "hip") => [80.0, 6.0, 0.0],
        (Posture::Sitting, "shoulder") => [20.0, 10.0, 0.0],
        // Arms that hang down are longer than the trunk: hands would reach into the bed.
        (Posture::Sitting, "elbow") => [90.0, 0.0, 0.0],
        (_, "hip") => [0.0, 6.0, 0.0],
        (_, "shoulder") => [0.0, 15.0, 0.0],
        _ => [0.0; 3],
    }
}
