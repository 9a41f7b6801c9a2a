//! Generates a random mechanism of a given kind: links joined into a tree, then loops, constraints, speeds, loads,
//! outputs.

use super::description::{Body, Coordinate, Description, Frame, Parameter};
use super::expression::{Scalar, Vector};
use super::nominal;
use super::oracle;
use crate::random::Random;
use nalgebra::{Matrix3, Vector3};

/// Kind of a mechanism.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Kind {
    /// Open chains in a plane.
    PlanarTree,
    /// Open chains in space.
    SpatialTree,
    /// Loops in a plane.
    PlanarLoop,
    /// Loops in space.
    SpatialLoop,
    /// Loops with more equations than they need.
    Redundant,
    /// Coordinates in closed form.
    ClosedForm,
    /// Constraints of motion, with and without loops.
    Motion,
    /// Discs and balls that roll on a plane.
    Rolling,
    /// Speeds that are combinations of rates.
    Combination,
    /// Everything together.
    Mixed,
    /// Loops and constraints of motion, discs that carry loops.
    LoopMotion,
    /// Driven by time, in closed forms and in constraints of configuration and motion.
    Driven,
}

/// All kinds.
pub const KINDS: [Kind; 12] = [
    Kind::PlanarTree,
    Kind::SpatialTree,
    Kind::PlanarLoop,
    Kind::SpatialLoop,
    Kind::Redundant,
    Kind::ClosedForm,
    Kind::Motion,
    Kind::Rolling,
    Kind::Combination,
    Kind::Mixed,
    Kind::LoopMotion,
    Kind::Driven,
];

/// Least distance of the nominal configuration from a singular one for a mechanism to be kept.
const HEALTHY: f64 = 0.03;
/// Draws before a seed is given up; about half of the loops are healthy.
const DRAWS: u64 = 60;

/// A link under construction: its frame and joint.
#[derive(Clone, Copy, Debug)]
pub(super) struct Link {
    pub frame: usize,
    pub origin: usize,
    pub centre: usize,
}

/// A description under construction.
pub(super) struct Draw {
    pub random: Random,
    pub d: Description,
    pub links: Vec<Link>,
    pub planar: bool,
    /// Whether its plane is not a coordinate plane of N.
    pub tilted: bool,
    /// Coordinates that closed forms read.
    pub read_by_forms: Vec<usize>,
    /// Whether frames declare vectors as fixed in them.
    pub states_fixed: bool,
}

/// The mechanism of a kind and a seed.
///
/// # Panics
/// If no draw of the seed is a regular mechanism.
#[must_use]
pub fn mechanism(kind: Kind, seed: u64) -> Description {
    let mut draws = (0..DRAWS).filter_map(|n| attempt(kind, seed, n));
    draws.next().unwrap_or_else(|| panic!("{kind:?} {seed}: no regular mechanism in {DRAWS} draws"))
}

fn attempt(kind: Kind, seed: u64, n: u64) -> Option<Description> {
    let mut draw = Draw {
        random: Random::new(seed.wrapping_mul(1_000_003).wrapping_add(n * 7919 + kind as u64)),
        d: Description::empty(format!("{kind:?}, seed {seed}")),
        links: Vec::new(),
        planar: false,
        tilted: false,
        read_by_forms: Vec::new(),
        states_fixed: matches!(kind, Kind::LoopMotion | Kind::Driven),
    };
    let mixed = |draw: &mut Draw| kind == Kind::Mixed && draw.chance(0.5);
    draw.planar = match kind {
        Kind::PlanarTree | Kind::PlanarLoop | Kind::Redundant => true,
        Kind::SpatialTree | Kind::SpatialLoop | Kind::Rolling => false,
        _ => draw.chance(0.5),
    };
    match kind {
        Kind::Redundant => draw.redundant(),
        Kind::Rolling => draw.rolling(),
        Kind::LoopMotion if !draw.planar && draw.chance(0.5) => draw.disc(),
        _ => draw.tree(),
    }
    let looped = match kind {
        Kind::PlanarLoop | Kind::SpatialLoop => true,
        Kind::Motion | Kind::Driven => draw.chance(0.3),
        Kind::LoopMotion => {
            draw.links_up_to(if draw.planar { 6 } else { 8 });
            true
        }
        _ => mixed(&mut draw),
    };
    if looped {
        draw.loops();
    }
    if kind == Kind::ClosedForm || mixed(&mut draw) {
        draw.closed_forms();
    }
    if matches!(kind, Kind::Motion | Kind::LoopMotion) || mixed(&mut draw) {
        draw.motion_constraints();
    }
    if kind == Kind::Driven {
        draw.drives();
    }
    draw.choose_independent();
    if kind == Kind::Combination || mixed(&mut draw) {
        draw.combine_speeds();
    }
    // A closed form reads independent coordinates only.
    if draw.d.independent_speeds().is_empty() || !draw.forms_are_free() {
        return None;
    }
    draw.loads();
    draw.outputs();
    let state = nominal::state(&draw.d);
    let answer = oracle::solve(&draw.d, &state)?;
    let held = !oracle::is_locked(&draw.d, &state) && oracle::largest_residual(&draw.d, &state) < 1e-12;
    (held && answer.health > HEALTHY && answer.u_dot_terms.iter().all(|t| *t < 1e6)).then_some(draw.d)
}

impl Draw {
    pub(super) fn between(&mut self, low: f64, high: f64) -> f64 {
        // Numbers as an author writes them; none is 0, which would mean something else.
        let number = (self.random.between(low, high) * 1e3).round() / 1e3;
        if number == 0.0 { 1e-3 } else { number }
    }

    pub(super) fn chance(&mut self, share: f64) -> bool {
        self.random.between(0.0, 1.0) < share
    }

    pub(super) fn below(&mut self, n: usize) -> usize {
        (self.random.between(0.0, n as f64) as usize).min(n - 1)
    }

    /// A parameter, or a literal if one unit suffices for it.
    pub(super) fn number(&mut self, value: f64, unit: &'static str, shape: bool) -> Scalar {
        if self.chance(0.5) && matches!(unit, "m" | "kg" | "N" | "") {
            return Scalar::Literal(value, unit);
        }
        let fixed = self.chance(0.25);
        self.d.parameters.push(Parameter { value, unit, fixed, shape });
        Scalar::Parameter(self.d.parameters.len() - 1)
    }

    pub(super) fn length(&mut self, low: f64, high: f64) -> Scalar {
        let value = self.between(low, high);
        self.number(value, "m", true)
    }

    /// A new coordinate.
    pub(super) fn coordinate(&mut self, angle: bool) -> usize {
        let reach = if angle { self.between(0.2, 0.6) } else { self.between(0.05, 0.15) };
        let nominal = if angle { self.between(-1.4, 1.4) } else { self.between(0.1, 0.4) };
        let unit = match (angle, self.chance(0.2)) {
            (true, false) => "rad",
            (true, true) => "deg",
            (false, false) => "m",
            (false, true) => "mm",
        };
        self.d.coordinates.push(Coordinate {
            angle,
            unit,
            nominal,
            reach,
            independent: true,
            closed_form: None,
        });
        self.d.coordinates.len() - 1
    }

    /// Axis of a frame, in the plane where the mechanism is planar.
    pub(super) fn axis(&mut self, frame: usize) -> Vector {
        let n = if self.planar { 2 } else { 3 };
        Vector::Axis(frame, self.below(n))
    }

    /// A vector fixed in a frame.
    pub(super) fn arm(&mut self, frame: usize, size: f64) -> Vector {
        let x = self.length(0.3 * size, size);
        let first = Vector::Axis(frame, 0).scaled(x);
        let y = self.length(-0.7 * size, 0.7 * size);
        let arm = first + Vector::Axis(frame, 1).scaled(y);
        if self.planar {
            return arm;
        }
        let z = self.length(-0.7 * size, 0.7 * size);
        arm + Vector::Axis(frame, 2).scaled(z)
    }

    fn tree(&mut self) {
        let n = if self.planar { 2 + self.below(4) } else { 1 + self.below(3) };
        for i in 0..n {
            let chained = self.chance(0.7);
            let parent = match i {
                0 => None,
                _ if chained => Some(i - 1),
                _ => Some(self.below(i)).filter(|_| self.d.coordinates.len().is_multiple_of(2)),
            };
            self.link(parent);
        }
    }

    /// A link on another one, or on the ground.
    pub(super) fn link(&mut self, parent: Option<usize>) {
        let base = parent.map_or(Link { frame: 0, origin: 0, centre: 0 }, |p| self.links[p]);
        let mut origin = Vector::Point(base.origin);
        if parent.is_some() || self.chance(0.3) {
            origin = origin + self.arm(base.frame, 0.4);
        }
        let mut rotations = Vec::new();
        let n = if self.planar { 1 } else { 1 + self.below(3) };
        let mut last = 3;
        for _ in 0..n {
            let axis = if self.planar { 2 } else { (last + 1 + self.below(2)) % 3 };
            last = axis;
            rotations.push((axis, self.angle()));
            if !self.planar && self.chance(0.2) {
                rotations.push(((axis + 1) % 3, Scalar::number(self.between(-0.5, 0.5))));
            }
        }
        for _ in 0..2 {
            if self.chance(0.15) {
                let slide = Scalar::Coordinate(self.coordinate(false));
                origin = origin + self.axis(base.frame).scaled(slide);
            }
        }
        let frame = self.d.frame(Frame::Rotations(base.frame, rotations));
        let origin = self.d.point(origin);
        self.finish(frame, origin);
    }

    /// Mass centre and bodies of a link.
    pub(super) fn finish(&mut self, frame: usize, origin: usize) {
        let to_centre = self.arm(frame, 0.2);
        let centre = self.d.point(Vector::Point(origin) + to_centre);
        self.links.push(Link { frame, origin, centre });
        self.bodies(frame, origin, centre);
    }

    /// An angle of a joint: a coordinate, or a sum with one.
    fn angle(&mut self) -> Scalar {
        let q = Scalar::Coordinate(self.coordinate(true));
        match self.below(6) {
            0 => q + Scalar::number(self.between(-0.5, 0.5)),
            1 => Scalar::number(self.between(-0.5, 0.5)) - q,
            2 if 1 < self.d.coordinates.len() => {
                let other = self.below(self.d.coordinates.len() - 1);
                if self.d.coordinates[other].angle { q - Scalar::Coordinate(other) } else { q }
            }
            _ => q,
        }
    }

    /// A rigid body, and perhaps a particle, a mass without weight or inertia without mass.
    pub(super) fn bodies(&mut self, frame: usize, origin: usize, centre: usize) {
        let mass = self.mass();
        let body = Body { centre, mass: Some(mass), inertia: Some((frame, self.inertia())), weight: true };
        self.d.bodies.push(body);
        if self.chance(0.3) {
            let arm = self.arm(frame, 0.3);
            let at = self.d.point(Vector::Point(origin) + arm);
            let (mass, weight) = (self.mass(), self.chance(0.7));
            self.d.bodies.push(Body { centre: at, mass: Some(mass), inertia: None, weight });
        }
        if self.chance(0.3) {
            // Principal axes of their own: a frame turned by constants, about any point of the link.
            let turn = Scalar::number(self.between(-1.0, 1.0));
            let axis = if self.planar { 2 } else { self.below(3) };
            let frame = self.d.frame(Frame::Rotations(frame, vec![(axis, turn)]));
            let mass = self.chance(0.5).then(|| self.mass());
            let body = Body { centre: origin, mass, inertia: Some((frame, self.inertia())), weight: true };
            self.d.bodies.push(body);
        }
        if self.chance(0.15) {
            let frame = self.directions(frame, centre);
            let body = Body { centre, mass: None, inertia: Some((frame, self.inertia())), weight: true };
            self.d.bodies.push(body);
        }
    }

    /// A frame by unit vectors: other axes of a frame or, in N's plane, the line from O to a point.
    fn directions(&mut self, frame: usize, point: usize) -> usize {
        let along = Vector::Point(point);
        let distance = nominal::at_nominal(&self.d, |p| p.points[point].value.norm());
        let in_plane = self.planar && !self.tilted;
        if in_plane && 0.2 < distance && self.chance(0.6) {
            let one = Box::new(Scalar::number(1.0));
            let x = along.clone().scaled(Scalar::Quotient(one, Box::new(along.norm())));
            let x = self.d.define_vector(x);
            let frame = self.d.frame(Frame::Directions(x.clone(), Vector::Axis(0, 2).cross(x.clone())));
            self.state_fixed(frame, [(x, 0), (Vector::Axis(0, 2), 2)]);
            return frame;
        }
        let (x, y) = if self.planar { (1, 0) } else { (1, 2) };
        let x = Vector::Axis(frame, x);
        let y = Vector::Axis(frame, y);
        let y = if self.planar { y.scaled(Scalar::number(-1.0)) } else { y };
        let frame = self.d.frame(Frame::Directions(x.clone(), y.clone()));
        self.state_fixed(frame, [(x, 0), (y, 1)]);
        frame
    }

    /// Declares vectors as axes of a frame; the statement is true.
    fn state_fixed(&mut self, frame: usize, vectors: [(Vector, usize); 2]) {
        if self.states_fixed && self.chance(0.5) {
            for (vector, axis) in vectors {
                let components = [0, 1, 2].map(|i| Scalar::number(if i == axis { 1.0 } else { 0.0 }));
                self.d.fixed.push((frame, vector, components));
            }
        }
    }

    fn mass(&mut self) -> Scalar {
        let mass = self.between(0.2, 3.0);
        self.number(mass, "kg", false)
    }

    /// The inertia of some point masses: it meets every rule of inertias.
    fn inertia(&mut self) -> [Option<Scalar>; 6] {
        let mut matrix = Matrix3::zeros();
        for _ in 0..4 {
            let r = Vector3::from_fn(|_, _| self.random.between(-0.3, 0.3));
            matrix += (Matrix3::identity() * r.norm_squared() - r * r.transpose()) * 0.3;
        }
        let entries = [(0, 0), (1, 1), (2, 2), (0, 1), (0, 2), (1, 2)].map(|place| matrix[place]);
        let skewed = self.chance(0.7);
        let mut index = 0;
        entries.map(|entry| {
            index += 1;
            let asked = if self.planar { index == 3 } else { index <= 3 || skewed };
            asked.then(|| self.number((entry * 1e5).round() / 1e5, "kg m^2", false))
        })
    }
}
