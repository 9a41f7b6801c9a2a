//! URDF text -> links and joints as they are in the file. <https://wiki.ros.org/urdf/XML>
//!
//! Only the kinematics and inertias are read; other elements are counted, so that a message can list them.

use super::pose::{self, Vector};
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
    /// Elements that are not read, and how often they occur.
    pub left_out: BTreeMap<&'static str, usize>,
    /// What was read in another way than it is written, a line each.
    pub notes: Vec<String>,
}

/// The place of an element, for messages.
fn place(node: Node<'_, '_>) -> String {
    let at = node.document().text_pos_at(node.range().start);
    format!("line {}, column {}", at.row, at.col)
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
            "transmission" => *robot.left_out.entry("transmissions").or_default() += 1,
            "gazebo" => *robot.left_out.entry("elements <gazebo>").or_default() += 1,
            _ => {}
        }
    }
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

/// The child element with this name.
fn child<'a, 'b>(node: Node<'a, 'b>, name: &str) -> Option<Node<'a, 'b>> {
    node.children().find(|n| n.has_tag_name(name) || n.tag_name().name() == name)
}

fn needed<'a>(node: Node<'a, '_>, attribute: &str) -> Result<&'a str, String> {
    let tag = node.tag_name().name();
    node.attribute(attribute).ok_or_else(|| {
        format!("<{tag}> at {} has no `{attribute}`; expected {attribute}=\"...\"", place(node))
    })
}

/// Parses exactly N numbers of an attribute.
fn numbers<const N: usize>(node: Node<'_, '_>, attribute: &str, text: &str) -> Result<[f64; N], String> {
    let parsed: Result<Vec<f64>, _> = text.split_whitespace().map(str::parse::<f64>).collect();
    let all = parsed.ok().filter(|all| all.iter().all(|x| x.is_finite()));
    all.and_then(|all| <[f64; N]>::try_from(all).ok()).ok_or_else(|| {
        let tag = node.tag_name().name();
        let expected = if N == 1 { "a number".to_owned() } else { format!("{N} numbers") };
        format!("{attribute}=\"{text}\" of <{tag}> at {}: expected {expected}", place(node))
    })
}

/// A number with a default.
fn number_or(node: Option<Node<'_, '_>>, attribute: &str, other: f64) -> Result<f64, String> {
    match node.and_then(|n| n.attribute(attribute).map(|text| (n, text))) {
        Some((node, text)) => numbers::<1>(node, attribute, text).map(|[x]| x),
        None => Ok(other),
    }
}

fn origin(node: Node<'_, '_>) -> Result<Origin, String> {
    let Some(node) = child(node, "origin") else { return Ok(Origin::default()) };
    let read = |attribute: &str| match node.attribute(attribute) {
        Some(text) => numbers::<3>(node, attribute, text),
        None => Ok([0.0; 3]),
    };
    Ok(Origin { xyz: read("xyz")?, rpy: read("rpy")? })
}

fn link(node: Node<'_, '_>, left_out: &mut BTreeMap<&'static str, usize>) -> Result<Link, String> {
    for name in ["visual", "collision"] {
        *left_out.entry("shapes of links").or_default() +=
            node.children().filter(|n| n.has_tag_name(name)).count();
    }
    let inertial = match child(node, "inertial") {
        None => None,
        Some(node) => {
            let [mass, inertia] = ["mass", "inertia"].map(|name| child(node, name));
            let mass = number_or(mass, "value", 0.0)?;
            let entries = ["ixx", "iyy", "izz", "ixy", "ixz", "iyz"];
            let mut moments = [0.0; 6];
            for (moment, name) in moments.iter_mut().zip(entries) {
                *moment = number_or(inertia, name, 0.0)?;
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

fn joint(node: Node<'_, '_>, left_out: &mut BTreeMap<&'static str, usize>) -> Result<Joint, String> {
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
        Some(node) => numbers::<3>(node, "xyz", needed(node, "xyz")?)?,
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
        *left_out.entry("damping of planar and floating joints").or_default() += 1;
    }
    if number_or(dynamics, "friction", 0.0)? != 0.0 {
        *left_out.entry("dry frictions of joints").or_default() += 1;
    }
    if limits.is_some_and(|n| n.attribute("effort").or(n.attribute("velocity")).is_some()) {
        *left_out.entry("limits of effort and velocity").or_default() += 1;
    }
    for (tag, what) in [("safety_controller", "safety controllers"), ("calibration", "calibrations")] {
        *left_out.entry(what).or_default() += usize::from(child(node, tag).is_some());
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
        *left_out.entry("limits of joints that follow others").or_default() += 1;
    }
    if follows && damping != 0.0 {
        *left_out.entry("damping of joints that follow others").or_default() += 1;
    }
    let limit = (limited && !follows).then_some(limit);
    Ok(Joint { name, kind, parent, child: outer, origin: origin(node)?, axis, limit, damping, mimic })
}
