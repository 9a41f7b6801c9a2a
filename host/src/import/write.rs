//! Writes the text of a model from a tree of carriers.

use super::name::Names;
use super::pose::{self, Vector};
use super::tree::{Carrier, Leader, Place, Tree};
use super::urdf::{Joint, Kind, Robot};
use std::fmt::Write as _;

/// How the root link is held.
#[derive(Clone, Copy, PartialEq, Eq, Default, Debug, clap::ValueEnum)]
pub enum Base {
    /// Not at all.
    #[default]
    Fixed,
    /// Freely, with six degrees of freedom.
    Floating,
    /// In the plane perpendicular to z, and by rotation about z.
    Planar,
}

/// Result of an import.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Imported {
    /// The model.
    pub model: String,
    /// Parts of the robot that were not converted, a line each.
    pub left_out: Vec<String>,
    /// What is named or held otherwise than in the robot, a line each.
    pub notes: Vec<String>,
}

/// The robot's names in the model.
struct Words {
    /// Frame and point of each carrier: `N` and `O` for a fixed root.
    carriers: Vec<(String, String)>,
    /// Of each joint; fixed joints have none.
    joints: Vec<String>,
    /// Names of tools and flanges.
    ends: Vec<String>,
}

/// Writes the model of a robot read from `path`.
pub fn write(path: &str, robot: &Robot, tree: &Tree, base: Base) -> Imported {
    let mut names = Names::new();
    let words = name(&mut names, robot, tree, base);
    let sections = Sections::of(robot, tree, base, &words);
    let mut left_out: Vec<String> =
        robot.left_out.iter().filter(|(_, n)| **n > 0).map(|(what, n)| format!("{what}: {n}")).collect();
    let root = &tree.carriers[0];
    if base == Base::Fixed && root.inertial.is_some_and(|i| i.mass > 0.0) {
        left_out.push(format!("the mass of `{}`, which stands still", robot.links[root.link].name));
    }
    let mut text = String::from("# Made by `cargo smartbed import`");
    let file = std::path::Path::new(path).file_name().map(|name| name.to_string_lossy());
    let shown = |text: &str| text.chars().filter(|c| !c.is_control()).collect::<String>();
    let _ = writeln!(text, " from {}, robot {}.", shown(&file.unwrap_or_default()), shown(&robot.name));
    let title = names.take(&robot.name, "robot");
    let notes = [names.changed, robot.notes.clone()].concat();
    for line in &left_out {
        let _ = writeln!(text, "# Not converted: {}.", shown(line));
    }
    for line in &notes {
        let _ = writeln!(text, "# Note: {}.", shown(line));
    }
    let _ = write!(
        text,
        "format = 1\nname = \"{}\"\ndof = {}\ngravity = \"-g*N.z\"\n\n[parameters]\ng = {{ value = 9.81, unit = \"m/s^2\" }}\n",
        title, sections.dof
    );
    for (section, entries) in sections.all {
        if !entries.is_empty() {
            let _ = write!(text, "\n[{section}]\n{entries}");
        }
    }
    Imported { model: text, left_out, notes }
}

fn name(names: &mut Names, robot: &Robot, tree: &Tree, base: Base) -> Words {
    let joint = |names: &mut Names, (n, joint): (usize, &Joint)| match joint.kind {
        Kind::Fixed => String::new(),
        // A joint that follows another one has no coordinate: nothing is called after it.
        _ if tree.leaders[n].is_some() => joint.name.clone(),
        _ => names.take_with(&joint.name, "joint", &made_of(joint.kind, "*")),
    };
    let joints = robot.joints.iter().enumerate().map(|j| joint(names, j)).collect();
    let carrier = |names: &mut Names, carrier: &Carrier| {
        let mut made = match (carrier.joint, base) {
            (None, Base::Fixed) => return ("N".to_owned(), "O".to_owned()),
            (None, Base::Floating) => made_of(Kind::Floating, "*_base"),
            (None, Base::Planar) => made_of(Kind::Planar, "*_base"),
            _ => Vec::new(),
        };
        made.extend(is_off_centre(carrier).then(|| "*_centre".to_owned()));
        let name = names.take_with(&robot.links[carrier.link].name, "link", &made);
        (name.clone(), name)
    };
    let carriers = tree.carriers.iter().map(|c| carrier(names, c)).collect();
    let ends = tree.ends.iter().map(|&l| names.take(&robot.links[l].name, "link")).collect();
    Words { carriers, joints, ends }
}

/// Names that a model makes of the name `joint` of a joint.
fn made_of(kind: Kind, joint: &str) -> Vec<String> {
    let patterns: &[&str] = match kind {
        Kind::Fixed => &[],
        Kind::Revolute | Kind::Continuous => &["u_*", "tau_*"],
        Kind::Prismatic => &["u_*", "tau_*", "*_base"],
        Kind::Planar => {
            &["*_base", "*_x", "*_y", "*_z", "*_turn", "u_*_x", "u_*_y", "u_*_z", "u_*_turn", "*_plane"]
        }
        Kind::Floating => &[
            "*_base", "*_x", "*_y", "*_z", "*_e0", "*_e1", "*_e2", "*_e3", "u_*_x", "u_*_y", "u_*_z", "*_w0",
            "*_wx", "*_wy", "*_wz", "*_unit",
        ],
    };
    patterns.iter().map(|pattern| pattern.replace('*', joint)).collect()
}

/// Does a carrier's body need a point of its own for its mass centre?
fn is_off_centre(carrier: &Carrier) -> bool {
    carrier.inertial.is_some_and(|i| i.origin.xyz != [0.0; 3])
}

/// A number by its shortest digits, never with an exponent.
fn number(x: f64) -> String {
    format!("{x}")
}

/// An angle: multiples of a quarter turn in degrees, which are exact.
fn angle(x: f64) -> String {
    match pose::quarters(x) {
        Some(n) => format!("{}*deg", 90 * n),
        None => number(x),
    }
}

/// A vector as a sum along a frame's axes, each term with its sign in front; empty for the zero vector.
fn way(v: Vector, frame: &str, unit: &str) -> String {
    let mut sum = String::new();
    for (x, axis) in v.into_iter().zip(["x", "y", "z"]).filter(|(x, _)| *x != 0.0) {
        let sign = if x < 0.0 { "-" } else { "+" };
        let _ = write!(sum, " {sign} {}{unit}*{frame}.{axis}", number(x.abs()));
    }
    sum
}

/// Rotations by constants: yaw, pitch, roll, without those by 0.
fn steps([roll, pitch, yaw]: Vector) -> Vec<String> {
    let all = [("z", yaw), ("y", pitch), ("x", roll)];
    all.into_iter()
        .filter(|(_, by)| *by != 0.0)
        .map(|(axis, by)| format!("[\"{axis}\", \"{}\"]", angle(by)))
        .collect()
}

/// Azimuth and angle from z of an axis.
fn directed([x, y, z]: Vector) -> (f64, f64) {
    (libm::atan2(y, x), libm::atan2(x.hypot(y), z))
}

/// Rotations that take z to an axis.
fn onto(axis: Vector) -> Vec<String> {
    let (azimuth, polar) = directed(axis);
    steps([0.0, polar, azimuth])
}

/// The same rotations, undone.
fn back(axis: Vector) -> Vec<String> {
    let (azimuth, polar) = directed(axis);
    let undone = [("y", -polar), ("z", -azimuth)].into_iter().filter(|(_, by)| *by != 0.0);
    undone.map(|(axis, by)| format!("[\"{axis}\", \"{}\"]", angle(by))).collect()
}

/// The coordinate axis along which a vector lies, if any: its index, and whether it points the other way.
fn letter(axis: Vector) -> Option<(usize, bool)> {
    let along = axis.iter().position(|x| *x != 0.0)?;
    axis.iter().skip(along + 1).all(|x| *x == 0.0).then_some((along, axis[along] < 0.0))
}

const LETTERS: [&str; 3] = ["x", "y", "z"];

/// An axis as a model writes it.
fn axis(v: Vector) -> String {
    match letter(v) {
        Some((n, back)) => format!("\"{}{}\"", if back { "-" } else { "" }, LETTERS[n]),
        None => format!("[{}]", v.map(number).join(", ")),
    }
}

/// Lines of the model's sections.
struct Sections {
    all: [(&'static str, String); 6],
    dof: usize,
}

impl Sections {
    fn of(robot: &Robot, tree: &Tree, base: Base, words: &Words) -> Self {
        let mut this = Self {
            all: ["inputs", "joints", "frames", "points", "bodies", "ports"].map(|s| (s, String::new())),
            dof: 0,
        };
        if base != Base::Fixed {
            let (kind, dof) =
                if base == Base::Floating { ("free\"", 6) } else { ("planar\", axis = \"z\"", 3) };
            let child = &words.carriers[0].0;
            this.add("joints", &format!("{child}_base = {{ kind = \"{kind}, child = \"{child}\" }}"));
            this.dof += dof;
        }
        for (n, carrier) in tree.carriers.iter().enumerate() {
            if let Some(joint) = carrier.joint {
                this.joint(robot, tree, words, n, joint);
            }
            if n > 0 || base != Base::Fixed {
                this.body(carrier, &words.carriers[n].0);
            }
        }
        for (&end, name) in tree.ends.iter().zip(&words.ends) {
            let place = &tree.places[end];
            // A port on the fixed root would have no effect.
            if place.carrier > 0 || base != Base::Fixed {
                this.end(place, &words.carriers[place.carrier], name);
            }
        }
        this
    }

    fn add(&mut self, section: &str, line: &str) {
        if let Some((_, entries)) = self.all.iter_mut().find(|(name, _)| *name == section) {
            entries.push_str(line);
            entries.push('\n');
        }
    }

    /// Adds the joint that moves a carrier.
    fn joint(&mut self, robot: &Robot, tree: &Tree, words: &Words, carrier: usize, n: usize) {
        let joint = &robot.joints[n];
        let (name, child) = (&words.joints[n], &words.carriers[carrier].0);
        let inner = robot.links.iter().position(|l| l.name == joint.parent).unwrap_or(0);
        let place = &tree.places[inner];
        let (parent, hold) = &words.carriers[place.carrier];
        let offset = pose::turned(&place.turn, joint.origin.xyz);
        let from = std::array::from_fn(|i| place.at[i] + offset[i]);
        let at = format!("{hold}{}", way(from, parent, "_m"));
        let turn = match place.turn == pose::IDENTITY {
            true => joint.origin.rpy,
            false => pose::angles(&pose::product(&place.turn, &pose::rotation(joint.origin.rpy))),
        };
        let mut turned = steps(turn);
        if let Some(leader) = tree.leaders[n] {
            return self.mimic(robot, words, (joint, child), leader, (parent, &at, turned));
        }
        let slides = joint.kind == Kind::Prismatic;
        let (kind, dof) = match joint.kind {
            Kind::Prismatic => ("prismatic", 1),
            Kind::Planar => ("planar", 3),
            Kind::Floating => ("free", 6),
            _ => ("revolute", 1),
        };
        self.dof += dof;
        let mut fields = vec![format!("kind = \"{kind}\"")];
        let mut moved = child.clone();
        match joint.kind {
            Kind::Floating => {}
            Kind::Planar => match letter(joint.axis) {
                Some((n, false)) => fields.push(format!("axis = \"{}\"", LETTERS[n])),
                _ => {
                    turned.extend(onto(joint.axis));
                    fields.push("axis = \"z\"".to_owned());
                    moved = format!("{name}_plane");
                    self.turned_back(child, &moved, joint.axis);
                }
            },
            _ => fields.push(format!("axis = {}", axis(joint.axis))),
        }
        fields.extend([
            format!("parent = \"{parent}\""),
            format!("child = \"{moved}\""),
            format!("at = \"{at}\""),
        ]);
        if !turned.is_empty() {
            fields.push(format!("turned = [{}]", turned.join(", ")));
        }
        if dof == 1 {
            let (low, high) = joint.limit.unwrap_or((-std::f64::consts::PI, std::f64::consts::PI));
            if joint.limit.is_some() || !slides {
                fields.push(format!("range = [{}, {}]", number(low), number(high)));
            }
            if joint.limit.is_some() && !(low..=high).contains(&0.0) {
                fields.push(format!("nominal = {}", number((low + high) / 2.0)));
            }
            if joint.damping != 0.0 {
                fields.push(format!("damping = {}", number(joint.damping)));
            }
            let (unit, what) = if slides { ("N", "force") } else { ("N m", "torque") };
            self.add(
                "inputs",
                &format!("tau_{name} = {{ unit = \"{unit}\", doc = \"{what} of the drive of {name}\" }}"),
            );
            fields.push(format!("drive = \"tau_{name}\""));
        }
        self.add("joints", &format!("{name} = {{ {} }}", fields.join(", ")));
    }

    /// Adds a mimic joint as a frame and a point that depend on the leader's coordinate.
    fn mimic(
        &mut self,
        robot: &Robot,
        words: &Words,
        (joint, child): (&Joint, &String),
        (leader, factor, offset): Leader,
        (parent, at, mut turned): (&String, &String, Vec<String>),
    ) {
        let slides = joint.kind == Kind::Prismatic;
        // The factor of a translation that follows a rotation is in m, that of a rotation that follows a translation in
        // 1/m.
        let unit = match (slides, robot.joints[leader].kind == Kind::Prismatic) {
            (true, false) => "_m",
            (false, true) => "/1_m",
            _ => "",
        };
        let mut by = format!("{}{unit}*{}", number(factor), words.joints[leader]);
        if offset != 0.0 {
            let _ = write!(by, " + {}{}", number(offset), if slides { "_m" } else { "" });
        }
        let unit_axis = joint.axis.map(|x| x / pose::norm(joint.axis));
        let mut position = at.clone();
        if slides {
            let along = way(unit_axis, child, "");
            let _ = write!(position, " + ({by})*({})", along.trim_start_matches(" +"));
        } else {
            match letter(joint.axis) {
                Some((n, back)) => {
                    turned.push(format!("[\"{}\", \"{}({by})\"]", LETTERS[n], if back { "-" } else { "" }));
                }
                None => {
                    turned.extend(onto(joint.axis));
                    turned.push(format!("[\"z\", \"{by}\"]"));
                    turned.extend(back(joint.axis));
                }
            }
        }
        let rotations = turned.join(", ");
        self.add("frames", &format!("{child} = {{ parent = \"{parent}\", rotations = [{rotations}] }}"));
        self.add("points", &format!("{child} = \"{position}\""));
    }

    /// Adds the link of a planar joint, whose plane is normal to z of the frame `plane`, along the axes that it has in
    /// the robot: z was rotated to the joint's axis, and is rotated back.
    fn turned_back(&mut self, link: &str, plane: &str, axis: Vector) {
        let rotations = back(axis).join(", ");
        self.add("frames", &format!("{link} = {{ parent = \"{plane}\", rotations = [{rotations}] }}"));
        self.add("points", &format!("{link} = \"{plane}\""));
    }

    /// Adds the body of a carrier.
    fn body(&mut self, carrier: &Carrier, name: &str) {
        let Some(inertial) = carrier.inertial.filter(|i| i.mass > 0.0 || i.inertia != [0.0; 6]) else {
            return;
        };
        let mut centre = name.to_owned();
        if inertial.origin.xyz != [0.0; 3] {
            centre.push_str("_centre");
            self.add("points", &format!("{centre} = \"{name}{}\"", way(inertial.origin.xyz, name, "_m")));
        }
        let mut fields = vec![format!("centre = \"{centre}\"")];
        if inertial.mass > 0.0 {
            fields.push(format!("mass = {}", number(inertial.mass)));
        }
        let entries = ["Ixx", "Iyy", "Izz", "Ixy", "Ixz", "Iyz"].into_iter().zip(inertial.inertia);
        let entries: Vec<String> =
            entries.filter(|(_, x)| *x != 0.0).map(|(entry, x)| format!("{entry} = {}", number(x))).collect();
        if !entries.is_empty() {
            fields.push(format!("frame = \"{name}\", inertia = {{ {} }}", entries.join(", ")));
        }
        self.add("bodies", &format!("{name} = {{ {} }}", fields.join(", ")));
    }

    /// Adds a flange or tool as a port, which costs nothing unless it is asked for.
    fn end(&mut self, place: &Place, (frame, point): &(String, String), name: &str) {
        let turned = steps(pose::angles(&place.turn));
        let held = match turned.is_empty() {
            true => frame.clone(),
            false => {
                let rotations = turned.join(", ");
                self.add(
                    "frames",
                    &format!("{name} = {{ parent = \"{frame}\", rotations = [{rotations}] }}"),
                );
                name.to_owned()
            }
        };
        self.add("points", &format!("{name} = \"{point}{}\"", way(place.at, frame, "_m")));
        self.add("ports", &format!("{name} = {{ frame = \"{held}\", point = \"{name}\" }}"));
    }
}
