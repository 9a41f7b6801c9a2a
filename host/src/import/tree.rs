//! The kinematic tree: links connected by fixed joints are merged into one carrier.
//!
//! In: a robot. Out: its carriers from the root outwards, each with the joint that moves it, its links, and their total
//! mass.

use super::pose::{self, IDENTITY, Matrix, Vector};
use super::urdf::{Inertial, Joint, Kind, Robot};
use std::collections::BTreeMap;

/// Pose of a link in its carrier.
#[derive(Clone, Debug)]
pub struct Place {
    /// Index of the carrier.
    pub carrier: usize,
    /// Rotation relative to the carrier's axes.
    pub turn: Matrix,
    /// Position relative to the carrier's point, along its axes.
    pub at: Vector,
}

/// Links that move as one rigid body.
#[derive(Clone, Debug)]
pub struct Carrier {
    /// Its first link: the child of the joint.
    pub link: usize,
    /// The joint that moves it; `None` for the root.
    pub joint: Option<usize>,
    /// Combined mass and inertia of its links; `None` if no link has mass.
    pub inertial: Option<Inertial>,
}

/// The joint that a mimic joint finally follows: its index, factor, offset.
pub type Leader = (usize, f64, f64);

/// The whole tree.
#[derive(Clone, Debug)]
pub struct Tree {
    /// Of every joint; `None` for one that moves independently.
    pub leaders: Vec<Option<Leader>>,
    /// Carriers from the root outwards.
    pub carriers: Vec<Carrier>,
    /// Pose of every link.
    pub places: Vec<Place>,
    /// Links that are attached by fixed joints and have no children: tools and flanges.
    pub ends: Vec<usize>,
}

/// Builds the tree.
///
/// # Errors
/// A joint that names an unknown link, a link that two joints move, several roots, or a cycle.
pub fn build(robot: &Robot) -> Result<Tree, String> {
    let link: BTreeMap<&str, usize> =
        robot.links.iter().enumerate().map(|(i, l)| (l.name.as_str(), i)).collect();
    let find = |joint: &Joint, name: &str| {
        link.get(name).copied().ok_or_else(|| {
            format!(
                "joint `{}` names the link `{name}`, which does not exist; expected the name of a <link>",
                joint.name
            )
        })
    };
    let mut above: Vec<Option<usize>> = vec![None; robot.links.len()];
    let mut below: Vec<Vec<(usize, usize)>> = vec![Vec::new(); robot.links.len()];
    for (n, joint) in robot.joints.iter().enumerate() {
        let (parent, child) = (find(joint, &joint.parent)?, find(joint, &joint.child)?);
        if let Some(other) = above[child].replace(n) {
            return Err(format!(
                "the link `{}` is the child of `{}` and of `{}`; expected a tree: close the loop in the model, by `closures`",
                joint.child, robot.joints[other].name, joint.name
            ));
        }
        below[parent].push((n, child));
    }
    let roots: Vec<usize> = (0..robot.links.len()).filter(|&l| above[l].is_none()).collect();
    let [root] = roots[..] else {
        let names: Vec<&str> = roots.iter().map(|&l| robot.links[l].name.as_str()).collect();
        return Err(match names.is_empty() {
            true => "every link is the child of a joint; expected one root link that is not".to_owned(),
            false => format!(
                "the links {} are not children of any joint; expected only one such root link",
                names.join(", ")
            ),
        });
    };
    let none = Place { carrier: usize::MAX, turn: IDENTITY, at: [0.0; 3] };
    let leaders = robot.joints.iter().map(|j| leader(robot, j)).collect::<Result<_, _>>()?;
    let mut tree =
        Tree { leaders, carriers: Vec::new(), places: vec![none; robot.links.len()], ends: Vec::new() };
    tree.carriers.push(Carrier { link: root, joint: None, inertial: None });
    tree.places[root].carrier = 0;
    let mut waiting = std::collections::VecDeque::from([root]);
    while let Some(link) = waiting.pop_front() {
        for &(n, child) in &below[link] {
            let joint = &robot.joints[n];
            tree.places[child] = match joint.kind {
                Kind::Fixed => {
                    let inner = &tree.places[link];
                    let offset = pose::turned(&inner.turn, joint.origin.xyz);
                    Place {
                        carrier: inner.carrier,
                        turn: pose::product(&inner.turn, &pose::rotation(joint.origin.rpy)),
                        at: std::array::from_fn(|i| inner.at[i] + offset[i]),
                    }
                }
                _ => {
                    tree.carriers.push(Carrier { link: child, joint: Some(n), inertial: None });
                    Place { carrier: tree.carriers.len() - 1, turn: IDENTITY, at: [0.0; 3] }
                }
            };
            if joint.kind == Kind::Fixed && below[child].is_empty() {
                tree.ends.push(child);
            }
            waiting.push_back(child);
        }
    }
    if let Some(lost) = tree.places.iter().position(|p| p.carrier == usize::MAX) {
        let name = &robot.links[lost].name;
        return Err(format!("the link `{name}` belongs to a closed chain of joints; expected a tree"));
    }
    for (n, carrier) in tree.carriers.iter_mut().enumerate() {
        let links = robot.links.iter().zip(&tree.places).filter(|(_, place)| place.carrier == n);
        let parts: Vec<Inertial> = links.filter_map(|(l, place)| Some(moved(&l.inertial?, place))).collect();
        carrier.inertial = together(&parts);
    }
    Ok(tree)
}

/// A link's mass and inertia along the axes of its carrier.
fn moved(inertial: &Inertial, place: &Place) -> Inertial {
    let at = pose::turned(&place.turn, inertial.origin.xyz);
    let turn = pose::product(&place.turn, &pose::rotation(inertial.origin.rpy));
    let xyz = std::array::from_fn(|i| place.at[i] + at[i]);
    let origin = super::urdf::Origin { xyz, rpy: [0.0; 3] };
    Inertial { mass: inertial.mass, origin, inertia: pose::along(&turn, inertial.inertia) }
}

/// Combined mass and inertia about the common mass centre.
fn together(parts: &[Inertial]) -> Option<Inertial> {
    if let [one] = parts {
        return Some(*one);
    }
    let first = parts.first()?;
    let mass: f64 = parts.iter().map(|p| p.mass).sum();
    // Where nothing weighs, inertias are the same about every point.
    let xyz: Vector = match mass == 0.0 {
        true => first.origin.xyz,
        false => std::array::from_fn(|i| parts.iter().map(|p| p.mass * p.origin.xyz[i]).sum::<f64>() / mass),
    };
    let mut inertia = [0.0; 6];
    for part in parts {
        let away = std::array::from_fn(|i| part.origin.xyz[i] - xyz[i]);
        let added = pose::of_point(part.mass, away);
        inertia
            .iter_mut()
            .zip(part.inertia.iter().zip(added))
            .for_each(|(sum, (own, far))| *sum += own + far);
    }
    Some(Inertial { mass, origin: super::urdf::Origin { xyz, rpy: [0.0; 3] }, inertia })
}

/// q = factor*q_leader + offset, through chains of mimic joints.
fn leader(robot: &Robot, joint: &Joint) -> Result<Option<Leader>, String> {
    let (mut factor, mut offset, mut at) = (1.0, 0.0, joint);
    for n in 0..=robot.joints.len() {
        let Some((name, times, plus)) = &at.mimic else {
            let leader = robot.joints.iter().position(|j| j.name == at.name).unwrap_or(0);
            return match at.kind {
                _ if n == 0 => Ok(None),
                Kind::Revolute | Kind::Continuous | Kind::Prismatic => Ok(Some((leader, factor, offset))),
                _ => Err(format!(
                    "joint `{}` mimics `{}`; expected a revolute or prismatic joint",
                    joint.name, at.name
                )),
            };
        };
        (factor, offset) = (factor * times, factor * plus + offset);
        at = robot.joints.iter().find(|j| j.name == *name).ok_or_else(|| {
            format!(
                "joint `{}` mimics `{name}`, which does not exist; expected the name of a <joint>",
                at.name
            )
        })?;
    }
    Err(format!(
        "joint `{}` mimics itself through a chain of mimic joints; expected a chain that ends at a joint \
                 without <mimic>",
        joint.name
    ))
}
