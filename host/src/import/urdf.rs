//! URDF text -> links and joints as they are in the file. <https://wiki.ros.org/urdf/XML>
//!
//! Only the kinematics and inertias are read; other elements are counted, so that a message can list them.

use super::pose::{self, Vector};
use super::xml::{check, child, needed, needed_numbers, number_or, numbers, place};
use roxmltree::{Document, Node, ParsingOptions};
use std::collections::BTreeMap;

/// Most elements: each link and joint takes some ten.
const MOST_NODES: u32 = 200_000;

/// Mass and inertia of a link.
#[derive(Clone, Copy, Debug)]
pub struct Inertial {
    /// Mass (kg).
    pub mass: f64,
    /// Mass centre, and axes of the inertia, in the link.
    pub origin: Origin,
    /// Entries xx, yy, zz, xy, xz, yz of the inertia matrix about the mass centre.
    pub inertia: [f64; 6],
}

/// A pose: position, and fixed-axis rotations about x, y, z (roll, pitch, yaw) in this order.
#[derive(Clone, Copy, Default, Debug)]
pub struct Origin {
    /// Position (m).
    pub xyz: Vector,
    /// Angles (rad).
    pub rpy: Vector,
}

/// Types of joints.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Kind {
    /// Rotation within limits.
    Revolute,
    /// Rotation without limits.
    Continuous,
    /// Translation along the axis.
    Prismatic,
    /// No motion.
    Fixed,
    /// All six degrees of freedom.
    Floating,
    /// Motion in the plane perpendicular to the axis.
    Planar,
}

/// A link.
#[derive(Clone, Debug)]
pub struct Link {
    /// Its name.
    pub name: String,
    /// Its mass and inertia, if it has any.
    pub inertial: Option<Inertial>,
}

/// A joint.
#[derive(Clone, Debug)]
pub struct Joint {
    /// Its name.
    pub name: String,
    /// Its type.
    pub kind: Kind,
    /// Name of the inner link.
    pub parent: String,
    /// Name of the outer link.
    pub child: String,
    /// Pose of the child's frame in the parent.
    pub origin: Origin,
    /// Axis in the child's frame, of any length.
    pub axis: Vector,
    /// Lower and upper limit; `None` if there are none, or both are 0 without being stated.
    pub limit: Option<(f64, f64)>,
    /// Viscous friction coefficient.
    pub damping: f64,
    /// For a mimic joint the joint that it follows: name, multiplier, offset.
    pub mimic: Option<(String, f64, f64)>,
}

/// A robot.
#[derive(Clone, Debug)]
pub struct Robot {
    /// Its name.
    pub name: String,
    /// Links in the order of the text.
    pub links: Vec<Link>,
    /// Joints in the order of the text.
    pub joints: Vec<Joint>,
    /// Elements and attributes that are not read, and how often they occur.
    pub left_out: BTreeMap<String, usize>,
    /// What was read in another way than it is written, a line each.
    pub notes: Vec<String>,
}

/// Reads a robot.
///
/// # Errors
/// What is wrong, where, and what was expected.
pub fn read(text: &str) -> Result<Robot, String> {
    let options = ParsingOptions { nodes_limit: MOST_NODES, ..ParsingOptions::default() };
    let document = Document::parse_with_options(text, options).map_err(|e| format!("not valid XML: {e}"))?;
    let root = document.root_element();
    if root.tag_name().name() != "robot" {
        let found = root.tag_name().name();
        return Err(format!("<{found}> at {}: expected <robot>, the root of a URDF file", place(root)));
    }
    let xacro = |node: &Node<'_, '_>| node.tag_name().namespace().is_some_and(|n| n.contains("xacro"));
    if let Some(macros) = root.descendants().find(xacro) {
        let at = place(macros);
        return Err(format!(
            "a macro of xacro at {at}; expand it first: xacro robot.urdf.xacro > robot.urdf"
        ));
    }
    let mut robot = Robot {
        name: root.attribute("name").unwrap_or("robot").to_owned(),
        links: Vec::new(),
        joints: Vec::new(),
        left_out: BTreeMap::new(),
        notes: Vec::new(),
    };
    for node in root.children().filter(Node::is_element) {
        match node.tag_name().name() {
            "link" => {
                let link = link(node, &mut robot.left_out)?;
                if robot.links.iter().any(|l| l.name == link.name) {
                    return Err(format!("a second link `{}` at {}; names differ", link.name, place(node)));
                }
                robot.links.push(link);
            }
            "joint" => {
                let joint = joint(node, &mut robot.left_out)?;
                if robot.joints.iter().any(|j| j.name == joint.name) {
                    return Err(format!("a second joint `{}` at {}; names differ", joint.name, place(node)));
                }
                robot.joints.push(joint);
            }
            "transmission" => *robot.left_out.entry("transmissions".to_owned()).or_default() += 1,
            "gazebo" => *robot.left_out.entry("elements <gazebo>".to_owned()).or_default() += 1,
            _ => {}
        }
    }
    check(root, &mut robot.left_out)?;
    robot.lock();
    match robot.links.is_empty() {
        true => Err(format!("robot `{}` has no <link>; expected at least one", robot.name)),
        false => Ok(robot),
    }
}

impl Robot {
    /// Fixes joints whose limits coincide where these are, unless another joint follows them.
    fn lock(&mut self) {
        let followed: Vec<String> =
            self.joints.iter().filter_map(|j| j.mimic.as_ref()).map(|(name, ..)| name.clone()).collect();
        for joint in &mut self.joints {
            let Some((at, _)) = joint.limit.filter(|(low, high)| low == high) else { continue };
            if followed.contains(&joint.name) {
                joint.limit = None;
                self.notes.push(format!(
                    "the limits of joint `{}` coincide, but a joint follows it: it moves without limits",
                    joint.name
                ));
                continue;
            }
            let unit = if joint.kind == Kind::Prismatic { "m" } else { "rad" };
            joint.fix(at);
            self.notes
                .push(format!("joint `{}` is fixed at {at} {unit}, where its limits coincide", joint.name));
        }
    }
}

impl Joint {
    /// Replaces the joint by a fixed one in the pose that it has at this value.
    fn fix(&mut self, at: f64) {
        let turn = pose::rotation(self.origin.rpy);
        let axis = self.axis.map(|x| x / pose::norm(self.axis));
        if self.kind == Kind::Prismatic {
            let way = pose::turned(&turn, axis.map(|x| x * at));
            self.origin.xyz = std::array::from_fn(|i| self.origin.xyz[i] + way[i]);
        } else if at != 0.0 {
            self.origin.rpy = pose::angles(&pose::product(&turn, &pose::about(axis, at)));
        }
        self.kind = Kind::Fixed;
        self.limit = None;
    }
}

fn origin(node: Node<'_, '_>) -> Result<Origin, String> {
    let Some(node) = child(node, "origin") else { return Ok(Origin::default()) };
    let read = |attribute: &str| match node.attribute(attribute) {
        Some(text) => numbers::<3>(node, attribute, text),
        None => Ok([0.0; 3]),
    };
    let xyz = read("xyz")?;
    let Some(text) = node.attribute("quat_xyzw") else { return Ok(Origin { xyz, rpy: read("rpy")? }) };
    if node.has_attribute("rpy") {
        return Err(format!("<origin> at {} has rpy and quat_xyzw; expected one of them", place(node)));
    }
    let [x, y, z, w] = numbers::<4>(node, "quat_xyzw", text)?;
    let (sine, length) = (pose::norm([x, y, z]), pose::norm([x, y, z]).hypot(w));
    if length == 0.0 {
        return Err(format!("quat_xyzw of <origin> at {} is 0 0 0 0; expected a rotation", place(node)));
    }
    if sine == 0.0 {
        return Ok(Origin { xyz, rpy: [0.0; 3] });
    }
    let axis = [x, y, z].map(|x| x / sine);
    Ok(Origin { xyz, rpy: pose::angles(&pose::about(axis, 2.0 * libm::atan2(sine, w))) })
}

fn link(node: Node<'_, '_>, left_out: &mut BTreeMap<String, usize>) -> Result<Link, String> {
    for name in ["visual", "collision"] {
        *left_out.entry("shapes of links".to_owned()).or_default() +=
            node.children().filter(|n| n.has_tag_name(name)).count();
    }
    let inertial = match child(node, "inertial") {
        None => None,
        Some(node) => {
            let Some(mass) = child(node, "mass") else {
                return Err(format!(
                    "<inertial> at {} has no <mass>; expected <mass value=\"...\"/>",
                    place(node)
                ));
            };
            let [mass] = needed_numbers(mass, "value")?;
            let mut moments = [0.0; 6];
            // Without it the mass is a point. What mixes axes is often left out where it is 0.
            if let Some(inertia) = child(node, "inertia") {
                let [own, mixed] = [["ixx", "iyy", "izz"], ["ixy", "ixz", "iyz"]];
                let (axes, others) = moments.split_at_mut(3);
                for (moment, name) in axes.iter_mut().zip(own) {
                    [*moment] = needed_numbers(inertia, name)?;
                }
                for (moment, name) in others.iter_mut().zip(mixed) {
                    *moment = number_or(Some(inertia), name, 0.0)?;
                }
            }
            let [xx, yy, zz, ..] = moments;
            if mass < 0.0 || xx < 0.0 || yy < 0.0 || zz < 0.0 {
                return Err(format!(
                    "<inertial> at {}: a mass or moment is negative; expected 0 or more",
                    place(node)
                ));
            }
            Some(Inertial { mass, origin: origin(node)?, inertia: moments })
        }
    };
    Ok(Link { name: needed(node, "name")?.to_owned(), inertial })
}

fn joint(node: Node<'_, '_>, left_out: &mut BTreeMap<String, usize>) -> Result<Joint, String> {
    let name = needed(node, "name")?.to_owned();
    let at = place(node);
    let kind = match needed(node, "type")? {
        "revolute" => Kind::Revolute,
        "continuous" => Kind::Continuous,
        "prismatic" => Kind::Prismatic,
        "fixed" => Kind::Fixed,
        "floating" => Kind::Floating,
        "planar" => Kind::Planar,
        other => {
            let known = "revolute, continuous, prismatic, fixed, floating, planar";
            return Err(format!("joint `{name}` at {at} is of type `{other}`; expected one of {known}"));
        }
    };
    let link = |tag: &str| match child(node, tag) {
        Some(node) => needed(node, "link").map(str::to_owned),
        None => Err(format!("joint `{name}` at {at} has no <{tag}>; expected <{tag} link=\"...\"/>")),
    };
    let (parent, outer) = (link("parent")?, link("child")?);
    let axis = match child(node, "axis") {
        Some(node) => needed_numbers(node, "xyz")?,
        None => [1.0, 0.0, 0.0],
    };
    let has_axis = !matches!(kind, Kind::Fixed | Kind::Floating);
    if has_axis && pose::norm(axis) == 0.0 {
        return Err(format!("the axis of joint `{name}` at {at} is 0 0 0; expected a direction"));
    }
    let limits = child(node, "limit");
    let limit = (number_or(limits, "lower", 0.0)?, number_or(limits, "upper", 0.0)?);
    let has_limits = matches!(kind, Kind::Revolute | Kind::Prismatic);
    if has_limits && limit.0 > limit.1 {
        let (lower, upper) = limit;
        return Err(format!(
            "the limits of joint `{name}` at {at} are {lower} and {upper}; expected the lower one first"
        ));
    }
    // Both limits are 0 by default: many files that state neither mean none.
    let stated = limits.is_some_and(|n| n.has_attribute("lower") && n.has_attribute("upper"));
    let limited = has_limits && (limit.0 < limit.1 || stated);
    let dynamics = child(node, "dynamics");
    let damping = number_or(dynamics, "damping", 0.0)?;
    if damping != 0.0 && matches!(kind, Kind::Planar | Kind::Floating) {
        // One number in N s/m and N m s at once: URDF does not say along and about which axes it acts.
        *left_out.entry("damping of planar and floating joints".to_owned()).or_default() += 1;
    }
    if number_or(dynamics, "friction", 0.0)? != 0.0 {
        *left_out.entry("dry frictions of joints".to_owned()).or_default() += 1;
    }
    if limits.is_some_and(|n| n.attribute("effort").or(n.attribute("velocity")).is_some()) {
        *left_out.entry("limits of effort and velocity".to_owned()).or_default() += 1;
    }
    for (tag, what) in [("safety_controller", "safety controllers"), ("calibration", "calibrations")] {
        *left_out.entry(what.to_owned()).or_default() += usize::from(child(node, tag).is_some());
    }
    let mimic = match child(node, "mimic") {
        None => None,
        Some(node) => {
            let factor = number_or(Some(node), "multiplier", 1.0)?;
            Some((needed(node, "joint")?.to_owned(), factor, number_or(Some(node), "offset", 0.0)?))
        }
    };
    if mimic.is_some() && !matches!(kind, Kind::Revolute | Kind::Continuous | Kind::Prismatic) {
        return Err(format!("joint `{name}` at {at} mimics another; expected a revolute or prismatic joint"));
    }
    let follows = mimic.is_some();
    if follows && limited {
        *left_out.entry("limits of joints that follow others".to_owned()).or_default() += 1;
    }
    if follows && damping != 0.0 {
        *left_out.entry("damping of joints that follow others".to_owned()).or_default() += 1;
    }
    let limit = (limited && !follows).then_some(limit);
    Ok(Joint { name, kind, parent, child: outer, origin: origin(node)?, axis, limit, damping, mimic })
}
