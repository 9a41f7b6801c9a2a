//! The table of joints: for each word the motions it allows, in order, and how it rolls.
//!
//! In: a joint whose names and axes have been read. Out: rows of data only and, for joints that roll, their motion
//! constraints. A new joint is a new row here; no other file knows the words. Joints as lists of simple motions:
//! Featherstone, Rigid Body Dynamics Algorithms (2008), table 4.1.

use super::axis::{Along, Motion};
use super::parts::Parts;
use Along::{Across, Given, Letter};
use Motion::{Attitude, Slide, Turn};

/// A joint of the language.
pub struct Kind {
    /// Its word.
    pub word: &'static str,
    /// Number of axes that must be given.
    pub axes: usize,
    /// Can a force or torque drive its coordinates? Only if it acts along the joint's axis and so on no other
    /// coordinate.
    pub driven: bool,
    /// The motions, translations first, because they go along axes of the inner side.
    pub motions: &'static [Motion],
    /// Places a rolling link and adds its constraints. A link that does not roll sits at the end of the translations.
    pub rolls: Option<fn(&mut Parts<'_>)>,
}

const PLANE: [Motion; 2] = [Slide(Letter('x'), None), Slide(Letter('y'), None)];

/// All joints.
pub const KINDS: [Kind; 10] = [
    Kind { word: "revolute", axes: 1, driven: true, motions: &[Turn(Given(0), "turn")], rolls: None },
    Kind { word: "prismatic", axes: 1, driven: true, motions: &[Slide(Given(0), None)], rolls: None },
    Kind {
        word: "cylindrical",
        axes: 1,
        driven: true,
        motions: &[Slide(Given(0), Some("slide")), Turn(Given(0), "turn")],
        rolls: None,
    },
    Kind {
        word: "universal",
        axes: 2,
        driven: true,
        motions: &[Turn(Given(0), "first"), Turn(Given(1), "second")],
        rolls: None,
    },
    Kind { word: "spherical", axes: 0, driven: false, motions: &[Attitude], rolls: None },
    Kind {
        word: "planar",
        axes: 1,
        driven: false,
        motions: &[Slide(Across(0), None), Slide(Across(1), None), Turn(Given(0), "turn")],
        rolls: None,
    },
    Kind {
        word: "free",
        axes: 0,
        driven: false,
        motions: &[PLANE[0], PLANE[1], Slide(Letter('z'), None), Attitude],
        rolls: None,
    },
    Kind {
        word: "knife_edge",
        axes: 0,
        driven: false,
        motions: &[PLANE[0], PLANE[1], Turn(Letter('z'), "yaw")],
        rolls: Some(knife_edge),
    },
    Kind {
        word: "rolling_disc",
        axes: 0,
        driven: false,
        motions: &[
            PLANE[0],
            PLANE[1],
            Turn(Letter('z'), "yaw"),
            Turn(Letter('x'), "lean"),
            Turn(Letter('y'), "spin"),
        ],
        rolls: Some(rolling_disc),
    },
    Kind {
        word: "rolling_ball",
        axes: 0,
        driven: false,
        motions: &[PLANE[0], PLANE[1], Attitude],
        rolls: Some(rolling_ball),
    },
];

/// A knife edge along the link's x axis: no sideways slip. Its speeds are those ahead and sideways, so that no heading
/// is singular.
fn knife_edge(joint: &mut Parts<'_>) {
    let [x, y, yaw] = ["x", "y", "yaw"].map(|word| joint.named(word));
    joint.link(&[]);
    joint.place(&joint.child.clone());
    joint.combine("ahead", "m/s", true, &format!("q_dot({x})*cos({yaw}) + q_dot({y})*sin({yaw})"));
    joint.combine("aside", "m/s", false, &format!("q_dot({y})*cos({yaw}) - q_dot({x})*sin({yaw})"));
    let slip = joint.slip(&format!("velocity({})", joint.child));
    joint.constrain("edge", &slip, &format!("{}.y", joint.child));
}

/// A thin disc that spins about the link's y axis. Coordinates: place of contact, heading, lean from upright, spin.
/// Speeds: its angular velocity along axes that lean with it but do not spin.
fn rolling_disc(joint: &mut Parts<'_>) {
    let [yaw, lean, spin] = ["yaw", "lean", "spin"].map(|word| joint.named(word));
    let (leaned, foot, child) = (joint.named("leaned"), joint.named("foot"), joint.child.clone());
    joint.split_frame(&leaned, 2);
    joint.place(&foot);
    joint.depend(&["x", "y"]);
    joint.combine("wx", "rad/s", true, &format!("q_dot({lean})"));
    joint.combine("wy", "rad/s", true, &format!("q_dot({spin}) + q_dot({yaw})*sin({lean})"));
    joint.combine("wz", "rad/s", true, &format!("q_dot({yaw})*cos({lean})"));
    let radius = joint.length("radius", "\"r\"");
    joint.point(&child, &format!("{foot} + ({radius})*{leaned}.z"));
    let point = format!("velocity({child}) - cross(angular_velocity({child}), ({radius})*{leaned}.z)");
    joint.does_not_slip(&point);
}

/// A ball on the plane. Coordinates: place of contact and attitude.
fn rolling_ball(joint: &mut Parts<'_>) {
    joint.link(&[]);
    let (base, foot, child) = (joint.base.clone(), joint.named("foot"), joint.child.clone());
    joint.place(&foot);
    joint.depend(&["x", "y"]);
    let radius = joint.length("radius", "\"r\"");
    joint.point(&child, &format!("{foot} + ({radius})*{base}.z"));
    let point = format!("velocity({child}) - cross(angular_velocity({child}), ({radius})*{base}.z)");
    joint.does_not_slip(&point);
}
