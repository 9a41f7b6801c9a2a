//! Elements and attributes of a URDF file.
//!
//! In: an element. Out: its attributes as numbers, with place and expectation where one is wrong; which names no
//! version of URDF has.

use roxmltree::Node;
use std::collections::BTreeMap;

/// An element of which something is read: its name, its attributes, elements in it that may stand once, and others.
struct Known {
    name: &'static str,
    attributes: &'static [&'static str],
    once: &'static [&'static str],
    others: &'static [&'static str],
}

const fn known(
    name: &'static str,
    attributes: &'static [&'static str],
    once: &'static [&'static str],
    others: &'static [&'static str],
) -> Known {
    Known { name, attributes, once, others }
}

/// All of them, after the specification of URDF 1.0 to 1.2; an unknown name may be a misspelt one.
const KNOWN: [Known; 13] = [
    known("robot", &["name", "version"], &[], &["link", "joint", "material", "transmission", "gazebo"]),
    known("link", &["name", "type"], &["inertial"], &["visual", "collision"]),
    known("inertial", &[], &["origin", "mass", "inertia"], &[]),
    known("mass", &["value"], &[], &[]),
    known("inertia", &["ixx", "iyy", "izz", "ixy", "ixz", "iyz"], &[], &[]),
    known("origin", &["xyz", "rpy", "quat_xyzw"], &[], &[]),
    known(
        "joint",
        &["name", "type"],
        &[
            "origin",
            "parent",
            "child",
            "axis",
            "calibration",
            "dynamics",
            "limit",
            "mimic",
            "safety_controller",
        ],
        &[],
    ),
    known("parent", &["link"], &[], &[]),
    known("child", &["link"], &[], &[]),
    known("axis", &["xyz"], &[], &[]),
    known(
        "limit",
        &["lower", "upper", "effort", "velocity", "acceleration", "deceleration", "jerk"],
        &[],
        &[],
    ),
    known("dynamics", &["damping", "friction"], &[], &[]),
    known("mimic", &["joint", "multiplier", "offset"], &[], &[]),
];

/// Counts attributes and elements with other names, which are not read.
///
/// # Errors
/// A second element where one is expected.
pub(super) fn check(root: Node<'_, '_>, unknown: &mut BTreeMap<String, usize>) -> Result<(), String> {
    let of = |node: &Node<'_, '_>| KNOWN.iter().find(|own| own.name == node.tag_name().name());
    let mut count = |what: String| *unknown.entry(what).or_default() += 1;
    let mut open = vec![root];
    while let Some(node) = open.pop() {
        let Some(own) = of(&node) else { continue };
        for attribute in node.attributes() {
            let is_own = attribute.namespace().is_none();
            if is_own && !own.attributes.contains(&attribute.name()) {
                count(format!("attributes `{}` of <{}>", attribute.name(), own.name));
            }
        }
        let inside: Vec<_> = node.children().filter(Node::is_element).collect();
        for (n, child) in inside.iter().enumerate() {
            let name = child.tag_name().name();
            if own.once.contains(&name) {
                if inside.iter().take(n).any(|other| other.tag_name().name() == name) {
                    return Err(format!(
                        "a second <{name}> at {}; expected one in <{}>",
                        place(*child),
                        own.name
                    ));
                }
            } else if !own.others.contains(&name) {
                count(format!("elements <{name}> in <{}>", own.name));
                continue;
            }
            open.push(*child);
        }
    }
    Ok(())
}

/// The place of an element, for messages.
pub(super) fn place(node: Node<'_, '_>) -> String {
    let at = node.document().text_pos_at(node.range().start);
    format!("line {}, column {}", at.row, at.col)
}

/// The child element with this name.
pub(super) fn child<'a, 'b>(node: Node<'a, 'b>, name: &str) -> Option<Node<'a, 'b>> {
    node.children().find(|n| n.tag_name().name() == name)
}

/// An attribute that must be there.
///
/// # Errors
/// Its name and the place.
pub(super) fn needed<'a>(node: Node<'a, '_>, attribute: &str) -> Result<&'a str, String> {
    let tag = node.tag_name().name();
    node.attribute(attribute).ok_or_else(|| {
        format!("<{tag}> at {} has no `{attribute}`; expected {attribute}=\"...\"", place(node))
    })
}

/// Parses exactly N numbers of an attribute.
///
/// # Errors
/// The attribute and the place.
pub(super) fn numbers<const N: usize>(
    node: Node<'_, '_>,
    attribute: &str,
    text: &str,
) -> Result<[f64; N], String> {
    let parsed: Result<Vec<f64>, _> = text.split_whitespace().map(str::parse::<f64>).collect();
    let all = parsed.ok().filter(|all| all.iter().all(|x| x.is_finite()));
    all.and_then(|all| <[f64; N]>::try_from(all).ok()).ok_or_else(|| {
        let tag = node.tag_name().name();
        let expected = if N == 1 { "a number".to_owned() } else { format!("{N} numbers") };
        format!("{attribute}=\"{text}\" of <{tag}> at {}: expected {expected}", place(node))
    })
}

/// N numbers that must be there.
///
/// # Errors
/// As [`needed`] and [`numbers`].
pub(super) fn needed_numbers<const N: usize>(
    node: Node<'_, '_>,
    attribute: &str,
) -> Result<[f64; N], String> {
    numbers(node, attribute, needed(node, attribute)?)
}

/// A number with a default.
///
/// # Errors
/// As [`numbers`].
pub(super) fn number_or(node: Option<Node<'_, '_>>, attribute: &str, other: f64) -> Result<f64, String> {
    match node.and_then(|n| n.attribute(attribute).map(|text| (n, text))) {
        Some((node, text)) => numbers::<1>(node, attribute, text).map(|[x]| x),
        None => Ok(other),
    }
}
