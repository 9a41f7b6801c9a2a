//! Which points of the pairs are near each other: the list of contacts that a step works on.
//!
//! In: things where they stand, pairs, how near is near. Out: contacts with sides, axes, gap.
//! ```text
//! rigid on rigid    features of both shapes (`rigid::narrow`)
//! mesh on rigid     every node over the shape's surface; the shape's corners over the facet below them, round ones over every
//!                   facet that has a foot for them (a ball may lie between two)
//! mesh on mesh      every node of each over the nearest facet of the other
//! ```
//! Both sides of a contact have one place, a node's or the foot on a facet, so that impulse and opposite act on one line; but a
//! node over a facet, where friction's arm is the gap. Edges of facets that cross, and a mesh on itself, are not looked for.

use super::island::Attachment;
use super::thing::{Pair, Thing};
use super::trail::Trail;
use crate::flexible::Body;
use crate::mechanism::Fault;
use crate::real::Scalar;
use crate::rigid::contact::{Contact, Point, Side};
use crate::rigid::impact::InverseMass;
use crate::rigid::narrow::{Placed, core_points, features};
use crate::surface::facet::{Facet, FacetNearest};
use crate::surface::{Frame, Nearest, Shape, Surface};
use crate::vec3::{self, Vec3};

/// Numbers of contacts of a shape's points over facets begin here; below are nodes.
const OF_SHAPE: u32 = 1 << 30;
/// Points of a shape at most: numbers of contacts over the next facet are so many higher.
const POINTS: usize = 8;

/// Cosine of the angle between a facet and the mean of those around a corner beyond which the corner is sharp: there the facet
/// keeps its own normal (edges of a cube), below it normals pass from facet to facet without a jump (a sheet).
const CREASE: f64 = 0.85;

/// A foot with more than this share of one corner is that corner: two contacts there would share one load in any way, which
/// sweeps find slowly.
pub(super) const AT_NODE: f64 = 0.75;

/// A contact of a step.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Touch<S> {
    /// Number of its pair.
    pub pair: usize,
    /// Which of the pair's contacts: the same from step to step.
    pub id: u32,
    /// Gap (m) in the middle of the step.
    pub gap: S,
    /// Place in N (m).
    pub point: Vec3<S>,
    /// Sides, axes, law, impulse over the step (N s).
    pub contact: Contact<S>,
    /// K.
    pub(super) inverse_mass: InverseMass<S>,
    /// Relative velocity at the start of the step, n, t1, t2.
    pub(super) start: Vec3<S>,
    /// Normal velocity (m/s) that an overlap is left with, at least.
    pub(super) out: S,
    /// What the last sweep changed of the impulse, and what the ones before it did.
    pub(super) change: Vec3<S>,
    pub(super) trail: Trail<S>,
}

impl<S: Scalar> Touch<S> {
    /// Relative velocity n, t1, t2 (m/s) at the start of the step, or before an impact.
    #[must_use]
    pub fn velocity(&self) -> Vec3<S> {
        self.start
    }

    /// Largest of what it yields to an impulse (1/kg).
    pub(super) fn weight(&self) -> S {
        let [[a, ..], [_, b, _], [.., c]] = self.inverse_mass;
        a.max(b).max(c)
    }

    /// A place for one.
    #[must_use]
    pub fn empty() -> Touch<S> {
        let zero = vec3::zero();
        let contact = Contact::between([Side::fixed(); 2], [S::ZERO, S::ZERO, S::ONE]);
        let inverse_mass = [zero; 3];
        Touch {
            pair: 0,
            id: 0,
            gap: S::ZERO,
            point: zero,
            contact,
            inverse_mass,
            start: zero,
            out: S::ZERO,
            change: zero,
            trail: Trail::empty(),
        }
    }
}

/// What stands where.
pub(super) struct Scenery<'a, S> {
    pub(super) things: &'a [Thing<S>],
    pub(super) body: &'a Body<'a, S>,
    pub(super) attachments: &'a [Attachment<S>],
    pub(super) frames: &'a [Frame<S>],
    pub(super) pos: &'a [Vec3<S>],
    /// Unit normals at the nodes.
    pub(super) normals: &'a [Vec3<S>],
    /// Gaps up to this (m) count as near.
    pub(super) margin: S,
    /// Feet with more than this share of one corner are left to the corner's own contact.
    pub(super) at_node: S,
}

/// A place of touch: gap, point, contact.
type Place<S> = (S, Vec3<S>, Contact<S>);

/// A shape, the port that carries it, its frame.
type Standing<S> = (Shape<S>, Option<usize>, Frame<S>);

/// The list while it is filled.
pub(super) struct Found<'a, S> {
    pub(super) touches: &'a mut [Touch<S>],
    pub(super) count: usize,
    full: bool,
}

impl<S: Scalar> Found<'_, S> {
    fn push(&mut self, pair: (usize, &Pair<S>), id: u32, gap: S, point: Vec3<S>, mut contact: Contact<S>) {
        let (number, law) = pair;
        (contact.friction, contact.restitution) = (law.friction, law.restitution);
        match self.touches.get_mut(self.count) {
            Some(place) => {
                *place = Touch { pair: number, id, gap, point, contact, ..Touch::empty() };
                self.count += 1;
            }
            None => self.full = true,
        }
    }
}

/// Nodes and facets of a mesh.
#[derive(Clone, Copy)]
struct Mesh<'a, S> {
    nodes: [usize; 2],
    facets: &'a [[usize; 4]],
    depth: S,
}

impl<'a, S: Scalar> Scenery<'a, S> {
    /// Fills the list; returns how many.
    pub(super) fn find(&self, pairs: &[Pair<S>], touches: &mut [Touch<S>]) -> Result<usize, Fault> {
        let mut found = Found { touches, count: 0, full: false };
        for pair in pairs.iter().enumerate() {
            let [Some(one), Some(other)] = pair.1.things.map(|thing| self.things.get(thing)) else {
                return Err(Fault::Shape);
            };
            match (self.rigid(one), self.rigid(other)) {
                (Some(a), Some(b)) => self.shapes(pair, a, b, &mut found),
                (Some(shape), None) => self.mesh_and_shape(pair, other, shape, &mut found),
                (None, Some(shape)) => self.mesh_and_shape(pair, one, shape, &mut found),
                (None, None) => {
                    if let (Some(a), Some(b)) = (self.mesh(one), self.mesh(other)) {
                        self.nodes_on_mesh(pair, a, b, &mut found);
                        self.nodes_on_mesh(pair, b, a, &mut found);
                    }
                }
            }
        }
        if found.full { Err(Fault::TooManyContacts) } else { Ok(found.count) }
    }

    fn rigid(&self, thing: &Thing<S>) -> Option<Standing<S>> {
        let Thing::Rigid { shape, port, place } = thing else { return None };
        let frame = match port {
            Some(port) => place.in_frame(self.frames.get(*port)?),
            None => place.in_frame(&Frame::inertial()),
        };
        Some((*shape, *port, frame))
    }

    fn mesh(&self, thing: &Thing<S>) -> Option<Mesh<'a, S>> {
        let Thing::Mesh { nodes, facets: [first, end], depth } = thing else { return None };
        Some(Mesh { nodes: *nodes, facets: self.body.facets.get(*first..*end)?, depth: *depth })
    }

    /// A point of N as a point of a port; fixed in space without one.
    fn side_of_port(&self, port: Option<usize>, point: Vec3<S>) -> Side<S> {
        match port.and_then(|port| Some((port, self.frames.get(port)?))) {
            Some((port, frame)) => Side::of_body(port, vec3::sub(point, frame.origin)),
            None => Side::fixed(),
        }
    }

    /// A node with a share in a side: itself, a point of the port that holds it, or nothing.
    fn point_of_node(&self, node: usize, weight: S) -> Option<Point<S>> {
        if self.body.fixed.get(node) == Some(&false) {
            return Some(Point { body: self.frames.len() + node, arm: vec3::zero(), weight });
        }
        let port = self.attachments.iter().find(|a| a.node == node)?.port;
        let arm = vec3::sub(vec3::at(self.pos, node), self.frames.get(port)?.origin);
        Some(Point { body: port, arm, weight })
    }

    fn side_of_node(&self, node: usize) -> Side<S> {
        Side::blend([self.point_of_node(node, S::ONE), None, None, None])
    }

    fn side_of_facet(&self, facet: &[usize; 4], near: &FacetNearest<S>) -> Side<S> {
        let [a, b, c, d] = *facet;
        let [p, q, r, s] = near.weights;
        // A triangle's third corner stands twice.
        let corners = if c == d {
            [(a, p), (b, q), (c, r + s), (d, S::ZERO)]
        } else {
            [(a, p), (b, q), (c, r), (d, s)]
        };
        Side::blend(corners.map(|(node, weight)| self.point_of_node(node, weight)))
    }

    fn shapes(
        &self,
        pair: (usize, &Pair<S>),
        (shape, port, frame): Standing<S>,
        (other, other_port, other_frame): Standing<S>,
        found: &mut Found<S>,
    ) {
        let one = Placed { shape: &shape, frame: &frame };
        let two = Placed { shape: &other, frame: &other_frame };
        for feature in features(one, two, self.margin).iter() {
            let sides = [port, other_port].map(|port| self.side_of_port(port, feature.point));
            found.push(pair, feature.id, feature.gap, feature.point, Contact::between(sides, feature.normal));
        }
    }

    fn mesh_and_shape(
        &self,
        pair: (usize, &Pair<S>),
        mesh: &Thing<S>,
        shape: Standing<S>,
        found: &mut Found<S>,
    ) {
        let Some(mesh) = self.mesh(mesh).filter(|mesh| self.may_meet(mesh, &shape)) else { return };
        for (id, node) in (0..).zip(mesh.nodes[0]..mesh.nodes[1]) {
            if self.near_node(node, &shape).gap <= self.margin {
                let (gap, point, contact) = self.node_over_shape(node, &shape);
                found.push(pair, id, gap, point, contact);
            }
        }
        let (_, count, radius) = core_points(&shape.0);
        // A corner is over one facet, the one it is nearest to.
        let each = if radius > S::ZERO { mesh.facets.len() } else { 1 };
        for (facet, number) in (0..each).flat_map(|facet| (0..count).map(move |number| (facet, number))) {
            let Some((gap, point, contact)) = self.shape_over_mesh(&shape, [number, facet], &mesh) else {
                continue;
            };
            let Ok(id) = u32::try_from(POINTS * facet + number) else { continue };
            found.push(pair, OF_SHAPE + id, gap, point, contact);
        }
    }

    /// Is the shape's bounding sphere near the box around the mesh's nodes? If not, nothing of theirs is.
    fn may_meet(&self, mesh: &Mesh<S>, (shape, _, frame): &Standing<S>) -> bool {
        let Some(reach) = shape.reach() else { return true };
        let Some((low, high)) = self.bounds(mesh) else { return false };
        let outside = frame.origin.iter().zip(low.iter().zip(high));
        let outside = outside.fold(S::ZERO, |sum, (x, (low, high))| {
            let over = (*low - *x).max(*x - high).max(S::ZERO);
            sum + over * over
        });
        outside.sqrt() <= reach + self.margin.max(mesh.depth)
    }

    /// Where a shape's surface is nearest to a node, in the shape's axes.
    fn near_node(&self, node: usize, (shape, _, frame): &Standing<S>) -> Nearest<S> {
        shape.nearest(frame.place(vec3::at(self.pos, node)))
    }

    /// A node over the surface of a shape.
    fn node_over_shape(&self, node: usize, standing: &Standing<S>) -> Place<S> {
        let (x, near, (_, port, frame)) =
            (vec3::at(self.pos, node), self.near_node(node, standing), standing);
        let sides = [self.side_of_node(node), self.side_of_port(*port, x)];
        (near.gap, x, Contact::between(sides, frame.to_inertial(near.normal)))
    }

    /// A point of a shape's core over a facet; without a radius over the facet below it.
    fn shape_over_mesh(
        &self,
        standing: &Standing<S>,
        [number, facet]: [usize; 2],
        mesh: &Mesh<'a, S>,
    ) -> Option<Place<S>> {
        let (shape, port, frame) = standing;
        let (points, _, radius) = core_points(shape);
        let point = frame.point(*points.get(number)?);
        let (facet, near) = if radius > S::ZERO {
            let facet = mesh.facets.get(facet)?;
            (facet, self.over_facet(mesh, facet, point, radius)?)
        } else {
            self.facet_below(mesh, point)?
        };
        let gap = near.gap - radius;
        let one_corner = near.weights.iter().any(|weight| *weight > self.at_node);
        if one_corner || self.left_to_corners(facet, &near, gap, standing) {
            return None;
        }
        let sides = [self.side_of_port(*port, near.foot), self.side_of_facet(facet, &near)];
        Some((gap, near.foot, Contact::between(sides, near.normal)))
    }

    /// Are the corners under a foot nearer to the shape's surface than the foot, on the mean by its shares?
    ///
    /// A chord between corners that touch a round shape lies inside it: a contact at the foot would say what theirs say, and
    /// share their load with them in any way.
    fn left_to_corners(
        &self,
        facet: &[usize; 4],
        near: &FacetNearest<S>,
        gap: S,
        shape: &Standing<S>,
    ) -> bool {
        let mean = facet
            .iter()
            .zip(near.weights)
            .fold(S::ZERO, |sum, (node, weight)| sum + weight * self.near_node(*node, shape).gap.abs());
        self.at_node < S::ONE && mean < gap.abs()
    }

    /// A node over the facet below it.
    fn node_over_mesh(&self, node: usize, mesh: &Mesh<'a, S>) -> Option<Place<S>> {
        let x = vec3::at(self.pos, node);
        let (facet, near) = self.facet_below(mesh, x)?;
        let sides = [self.side_of_node(node), self.side_of_facet(facet, &near)];
        Some((near.gap, x, Contact::between(sides, near.normal)))
    }

    fn nodes_on_mesh(&self, pair: (usize, &Pair<S>), own: Mesh<S>, other: Mesh<'a, S>, found: &mut Found<S>) {
        let Some((low, high)) = self.bounds(&other).filter(|_| !other.facets.is_empty()) else { return };
        let far = self.margin.max(other.depth);
        let base = if own.nodes[0] < other.nodes[0] { 0 } else { OF_SHAPE };
        for (id, node) in (base..).zip(own.nodes[0]..own.nodes[1]) {
            let x = vec3::at(self.pos, node);
            if !(0..3).all(|i| low[i] - far <= x[i] && x[i] <= high[i] + far) {
                continue;
            }
            if let Some((gap, point, contact)) = self.node_over_mesh(node, &other) {
                found.push(pair, id, gap, point, contact);
            }
        }
    }

    /// A contact found before, where things stand now: gap, point, sides and axes. None where it is no more.
    pub(super) fn again(&self, pair: &Pair<S>, id: u32) -> Option<Place<S>> {
        let [one, other] = pair.things.map(|thing| self.things.get(thing));
        let (one, other) = (one?, other?);
        let number = (id % OF_SHAPE) as usize;
        let (gap, point, contact) = match (self.rigid(one), self.rigid(other)) {
            (Some(a), Some(b)) => {
                let (first, second) =
                    (Placed { shape: &a.0, frame: &a.2 }, Placed { shape: &b.0, frame: &b.2 });
                let feature = features(first, second, self.margin).iter().find(|feature| feature.id == id)?;
                let sides = [a.1, b.1].map(|port| self.side_of_port(port, feature.point));
                (feature.gap, feature.point, Contact::between(sides, feature.normal))
            }
            (None, None) => {
                let (a, b) = (self.mesh(one)?, self.mesh(other)?);
                let (low, high) = if a.nodes[0] < b.nodes[0] { (a, b) } else { (b, a) };
                let (own, below) = if id < OF_SHAPE { (low, high) } else { (high, low) };
                self.node_over_mesh(own.nodes[0] + number, &below)?
            }
            (Some(shape), None) | (None, Some(shape)) => {
                let mesh = self.mesh(one).or_else(|| self.mesh(other))?;
                if id < OF_SHAPE {
                    self.node_over_shape(mesh.nodes[0] + number, &shape)
                } else {
                    self.shape_over_mesh(&shape, [number % POINTS, number / POINTS], &mesh)?
                }
            }
        };
        let (friction, restitution) = (pair.friction, pair.restitution);
        Some((gap, point, Contact { friction, restitution, ..contact }))
    }

    /// The facet to whose surface a point is nearest, not deeper than the mesh allows.
    fn facet_below(&self, mesh: &Mesh<'a, S>, point: Vec3<S>) -> Option<(&'a [usize; 4], FacetNearest<S>)> {
        let mut best: Option<(&[usize; 4], FacetNearest<S>)> = None;
        for facet in mesh.facets {
            let Some(near) = self.over_facet(mesh, facet, point, S::ZERO) else { continue };
            if best.as_ref().is_none_or(|(_, b)| near.gap.abs() < b.gap.abs()) {
                best = Some((facet, near));
            }
        }
        best
    }

    /// The foot on a facet of a ball about a point, where it is near the surface and not deeper than the mesh allows.
    fn over_facet(
        &self,
        mesh: &Mesh<'a, S>,
        facet: &[usize; 4],
        point: Vec3<S>,
        radius: S,
    ) -> Option<FacetNearest<S>> {
        let corners = facet.map(|node| vec3::at(self.pos, node));
        let [a, _, c, _] = corners;
        let middle = vec3::scale(vec3::add(a, c), S::from_f64(0.5));
        let reach = corners.iter().fold(S::ZERO, |most, x| most.max(vec3::norm(vec3::sub(*x, middle))));
        let far = reach + radius + self.margin.max(mesh.depth);
        if vec3::norm(vec3::sub(point, middle)) > far {
            return None;
        }
        let own = vec3::direction(vec3::cross(vec3::sub(c, a), vec3::sub(corners[3], corners[1]))).0;
        let normals = facet.map(|node| {
            let mean = vec3::at(self.normals, node);
            let smooth = vec3::dot(mean, own) > S::from_f64(CREASE);
            if smooth { mean } else { own }
        });
        let near = (Facet { corners, normals }).nearest(point, S::from_f64(1e3) * S::EPSILON)?;
        let gap = near.gap - radius;
        (-mesh.depth <= gap && gap <= self.margin).then_some(near)
    }

    /// Box around a mesh's nodes.
    fn bounds(&self, mesh: &Mesh<S>) -> Option<(Vec3<S>, Vec3<S>)> {
        let [first, end] = mesh.nodes;
        let places = self.pos.get(first..end)?;
        let mut bounds = (*places.first()?, *places.first()?);
        for x in places {
            for ((low, high), x) in bounds.0.iter_mut().zip(bounds.1.iter_mut()).zip(x) {
                (*low, *high) = (low.min(*x), high.max(*x));
            }
        }
        Some(bounds)
    }
}
