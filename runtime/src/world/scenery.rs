//! Geometry of all things at one instant, and the foot of a point on the things near it.
//!
//! In: things, and the frames and nodes that carry them. Out: sides of contacts, the facet below a point, the two
//! facets of a fold around it.

use super::attachment::Attachment;
use super::extent::Extent;
use super::thing::Thing;
use crate::flexible::Body;
use crate::real::Scalar;
use crate::rigid::contact::{Point, Side};
use crate::surface::facet::{Facet, FacetNearest, weight_slopes};
use crate::surface::{Frame, Nearest, Shape, Surface};
use crate::vec3::{self, Vec3};

/// Cosine of the angle between a facet's normal and the mean normal at a corner, below which the corner is sharp and
/// the facet keeps its own normal (edges of a cube).
const SHARP: f64 = 0.75;
/// Cosine of that angle above which normals are interpolated from facet to facet without a jump (a sheet). Between the
/// two one normal passes into the other: one that changed at once, while a sheet folds, would be an impact.
const SMOOTH: f64 = 0.85;

/// Least sine of the angle by which the middle of a facet rises over another's plane for the two to form a fold.
const FOLD: f64 = 0.2;

/// Facets of a fold are extended behind their edge by this many times the depth of a point: the largest tangent of
/// their slope.
const BEYOND: f64 = 8.0;

/// A foot within this many rounding units of a facet's edge or corner, relative to the facet, is on it.
const EDGE: f64 = 1e3;

/// [`EDGE`] in the scalar's rounding units.
pub(super) fn edge<S: Scalar>() -> S {
    S::from_f64(EDGE) * S::EPSILON
}

/// Geometry of all things at one instant.
pub(super) struct Scenery<'a, S> {
    pub(super) things: &'a [Thing<S>],
    pub(super) body: &'a Body<'a, S>,
    pub(super) attachments: &'a [Attachment<S>],
    pub(super) frames: &'a [Frame<S>],
    pub(super) pos: &'a [Vec3<S>],
    /// Unit normals at the nodes.
    pub(super) normals: &'a [Vec3<S>],
    /// Gaps up to this count as near (m).
    pub(super) margin: S,
    /// Whether gaps up to a facet's sagitta count as near, too.
    pub(super) rides: bool,
}

/// Nodes and facets of a mesh, and how deep a point may be below them (m).
#[derive(Clone, Copy)]
pub(super) struct Mesh<'a, S> {
    pub(super) nodes: [usize; 2],
    pub(super) facets: &'a [[usize; 4]],
    pub(super) depth: S,
}

impl<S> Mesh<'_, S> {
    /// Whether a node is one of its own, so that it can touch.
    pub(super) fn has(&self, node: usize) -> bool {
        self.nodes[0] <= node && node < self.nodes[1]
    }
}

/// A shape, the port that carries it, its frame.
pub(super) type Standing<S> = (Shape<S>, Option<usize>, Frame<S>);

/// A facet and the foot of a point on it.
pub(super) type Foot<'a, S> = (&'a [usize; 4], FacetNearest<S>);

/// How far a facet is extended beyond its edges.
#[derive(Clone, Copy, PartialEq)]
pub(super) enum Beyond {
    /// By rounding.
    Edges,
    /// In proportion to a point's depth: [`BEYOND`] times.
    Depth,
    /// By its own width: a lasting contact is followed past an edge to the end of the piece of a step.
    Width,
}

/// The facets on which a point has a foot.
pub(super) enum Feet<'a, S> {
    /// The facet below it, if there is one.
    Below(Option<Foot<'a, S>>),
    /// Both facets of a fold.
    Fold(Foot<'a, S>, Foot<'a, S>),
}

/// The facet of a mesh on which a foot is wanted.
#[derive(Clone, Copy, PartialEq)]
pub(super) enum Over {
    /// The facet of this number.
    Facet(usize),
    /// The nearest one.
    Nearest,
    /// The first of a fold.
    First,
    /// The second of a fold.
    Second,
}

impl<'a, S: Scalar> Scenery<'a, S> {
    /// Measures a bounding box of each thing.
    pub(super) fn measure(&self, extents: &mut [Extent<S>]) {
        extents.iter_mut().zip(self.things).for_each(|(extent, thing)| *extent = self.extent(thing));
    }

    pub(super) fn rigid(&self, thing: &Thing<S>) -> Option<Standing<S>> {
        let Thing::Rigid { shape, port, place } = thing else { return None };
        let frame = match port {
            Some(port) => place.in_frame(self.frames.get(*port)?),
            None => place.in_frame(&Frame::inertial()),
        };
        Some((*shape, *port, frame))
    }

    pub(super) fn mesh(&self, thing: &Thing<S>) -> Option<Mesh<'a, S>> {
        let Thing::Mesh { nodes, facets: [first, end], depth } = thing else { return None };
        Some(Mesh { nodes: *nodes, facets: self.body.facets.get(*first..*end)?, depth: *depth })
    }

    /// A point of N as a point of a port; fixed in space if there is no port.
    pub(super) fn side_of_port(&self, port: Option<usize>, point: Vec3<S>) -> Side<S> {
        match port.and_then(|port| Some((port, self.frames.get(port)?))) {
            Some((port, frame)) => Side::of_body(port, vec3::sub(point, frame.origin)),
            None => Side::fixed(),
        }
    }

    /// A node of this weight as a point of a side: the node itself, a point of the port that holds it, or nothing if it
    /// is fixed.
    fn point_of_node(&self, node: usize, weight: S) -> Option<Point<S>> {
        if self.body.fixed.get(node) == Some(&false) {
            return Some(Point { body: self.frames.len() + node, arm: vec3::zero(), weight });
        }
        let port = self.attachments.iter().find(|a| a.node == node)?.port;
        let arm = vec3::sub(vec3::at(self.pos, node), self.frames.get(port)?.origin);
        Some(Point { body: port, arm, weight })
    }

    pub(super) fn side_of_node(&self, node: usize) -> Side<S> {
        Side::blend([self.point_of_node(node, S::ONE), None, None, None])
    }

    pub(super) fn side_of_facet(&self, facet: &[usize; 4], near: &FacetNearest<S>) -> Side<S> {
        Side::blend(shares(facet, near).map(|(node, weight)| self.point_of_node(node, weight)))
    }

    /// The same where the other side is a gap g off it, with c_i = -g a_i of each point (see [`Contact::couple`]).
    pub(super) fn side_below(&self, facet: &[usize; 4], near: &FacetNearest<S>) -> (Side<S>, [Vec3<S>; 4]) {
        let corners = facet.map(|node| vec3::at(self.pos, node));
        let [a, b, c, d] = weight_slopes(&corners, near).map(|slope| vec3::scale(slope, -near.gap));
        let couple = if facet[2] == facet[3] { [a, b, vec3::add(c, d), vec3::zero()] } else { [a, b, c, d] };
        let (shares, is_none) = (shares(facet, near), |value: &Vec3<S>| *value == vec3::zero());
        let point = |k: usize| {
            let (node, weight) = shares[k];
            let acts = weight != S::ZERO || !is_none(&couple[k]);
            self.point_of_node(node, weight).filter(|_| acts).map(|point| (point, couple[k]))
        };
        Side::blend_with(core::array::from_fn(point), vec3::zero())
    }

    /// Whether the shape's bounding sphere is near the box around the mesh's nodes; if not, none of them is near the
    /// shape.
    pub(super) fn may_meet(&self, mesh: &Mesh<S>, (shape, _, frame): &Standing<S>) -> bool {
        let Some(reach) = shape.reach() else { return true };
        let Some(Extent { low, high }) = self.bounds(mesh) else { return false };
        let outside = frame.origin.iter().zip(low.iter().zip(high));
        let outside = outside.fold(S::ZERO, |sum, (x, (low, high))| {
            let over = (*low - *x).max(*x - high).max(S::ZERO);
            sum + over * over
        });
        outside.sqrt() <= reach + self.margin.max(mesh.depth)
    }

    /// The point of a shape's surface nearest to a node, in the shape's axes.
    pub(super) fn near_node(&self, node: usize, (shape, _, frame): &Standing<S>) -> Nearest<S> {
        shape.nearest(frame.place(vec3::at(self.pos, node)))
    }

    /// The facet whose surface is nearest to a point, with its number, unless the point is deeper than the mesh allows.
    /// With `faces`, a foot on another facet, only facets that face that one count.
    fn nearest_facet(
        &self,
        mesh: &Mesh<'a, S>,
        point: Vec3<S>,
        beyond: Beyond,
        faces: Option<&Foot<'a, S>>,
    ) -> Option<(usize, Foot<'a, S>)> {
        let mut best: Option<(usize, Foot<'a, S>)> = None;
        for (number, facet) in mesh.facets.iter().enumerate() {
            let Some(near) = self.over_facet(mesh, facet, (point, S::ZERO), beyond) else { continue };
            if near.gap < -self.margin.max(near.sagitta) && self.is_around_edge(mesh, facet, point) {
                continue;
            }
            let faces = faces
                .is_none_or(|(other, foot)| self.rises_over(foot, facet) && self.rises_over(&near, other));
            if faces && best.as_ref().is_none_or(|(_, (_, b))| near.gap.abs() < b.gap.abs()) {
                best = Some((number, (facet, near)));
            }
        }
        best
    }

    /// The feet of a point on a mesh: on the nearest facet, or on the two facets of a fold around it (the nearest, and
    /// the nearest of those that face it) in the order of the mesh. A point below both, at the bottom of a fold,
    /// projects onto neither, so the facets are extended behind their edge in proportion to the point's depth.
    pub(super) fn feet(&self, mesh: &Mesh<'a, S>, point: Vec3<S>) -> Feet<'a, S> {
        let below = self.nearest_facet(mesh, point, Beyond::Edges, None);
        let first = below.or_else(|| self.nearest_facet(mesh, point, Beyond::Depth, None));
        let second = first.and_then(|(_, foot)| self.nearest_facet(mesh, point, Beyond::Depth, Some(&foot)));
        match (first, second) {
            (Some((m, one)), Some((n, two))) if m < n => Feet::Fold(one, two),
            (Some((_, one)), Some((_, two))) => Feet::Fold(two, one),
            _ => Feet::Below(below.map(|(_, foot)| foot)),
        }
    }

    /// The foot of a ball on the same facet as before.
    pub(super) fn foot(
        &self,
        mesh: &Mesh<'a, S>,
        (point, radius): (Vec3<S>, S),
        over: Over,
    ) -> Option<Foot<'a, S>> {
        let in_fold = || match self.feet(mesh, point) {
            Feet::Fold(first, second) => Some((first, second)),
            Feet::Below(_) => None,
        };
        match over {
            Over::Facet(number) => {
                let facet = mesh.facets.get(number)?;
                Some((facet, self.over_facet(mesh, facet, (point, radius), Beyond::Width)?))
            }
            Over::Nearest => Some(self.nearest_facet(mesh, point, Beyond::Edges, None)?.1),
            Over::First => Some(in_fold()?.0),
            Over::Second => Some(in_fold()?.1),
        }
    }

    /// The mean of a facet's corners.
    pub(super) fn middle(&self, facet: &[usize; 4]) -> Vec3<S> {
        let sum = facet.iter().fold(vec3::zero(), |sum, node| vec3::add(sum, vec3::at(self.pos, *node)));
        vec3::scale(sum, S::from_f64(0.25))
    }

    /// Whether the middle of a facet lies above the tangent plane at a foot.
    fn rises_over(&self, near: &FacetNearest<S>, facet: &[usize; 4]) -> bool {
        let way = vec3::sub(self.middle(facet), near.foot);
        vec3::dot(near.normal, way) > S::from_f64(FOLD) * vec3::norm(way)
    }

    /// The foot of a ball on a facet, if it is near the surface and not deeper than the mesh allows.
    pub(super) fn over_facet(
        &self,
        mesh: &Mesh<'a, S>,
        facet: &[usize; 4],
        (point, radius): (Vec3<S>, S),
        beyond: Beyond,
    ) -> Option<FacetNearest<S>> {
        // A foot on the facet is |radius + gap| away, with the gap between -depth and the margin.
        let within = radius + self.margin;
        let beside =
            if self.rides || beyond != Beyond::Edges { radius + mesh.depth } else { mesh.depth - radius };
        let edge = edge();
        let widest = if beyond == Beyond::Edges { edge } else { S::ONE };
        let (near, reach) = self.nearest_on(facet, point, within.max(beside), widest)?;
        let gap = near.gap - radius;
        let outside = -near.weights.iter().fold(S::ZERO, |least, weight| least.min(*weight));
        let allowed = match beyond {
            Beyond::Edges => edge,
            Beyond::Depth => edge.max(S::from_f64(BEYOND) * -gap / reach),
            Beyond::Width => S::from_f64(f64::INFINITY),
        };
        let margin = if self.rides { self.margin.max(near.sagitta) } else { self.margin };
        (-mesh.depth <= gap && gap <= margin && outside <= allowed).then_some(near)
    }

    /// The foot of a point on a facet that is extended beyond its edges by `widest` of its width, and the facet's reach
    /// (m); None also where the facet is surely farther away than this.
    pub(super) fn nearest_on(
        &self,
        facet: &[usize; 4],
        point: Vec3<S>,
        farthest: S,
        widest: S,
    ) -> Option<(FacetNearest<S>, S)> {
        let corners = facet.map(|node| vec3::at(self.pos, node));
        let [a, _, c, _] = corners;
        let middle = vec3::scale(vec3::add(a, c), S::from_f64(0.5));
        let square = |x: Vec3<S>| vec3::dot(x, x);
        let reach = corners.iter().fold(S::ZERO, |most, x| most.max(square(vec3::sub(*x, middle)))).sqrt();
        let far = reach + farthest;
        if square(vec3::sub(point, middle)) > far * far {
            return None;
        }
        let normals = self.corner_normals(facet, &corners);
        Some(((Facet { corners, normals }).nearest(point, widest)?, reach))
    }

    /// Normals at the corners of a facet, by which its own normals are interpolated.
    pub(super) fn corner_normals(&self, facet: &[usize; 4], corners: &[Vec3<S>; 4]) -> [Vec3<S>; 4] {
        let [a, b, c, d] = *corners;
        let own = vec3::direction(vec3::cross(vec3::sub(c, a), vec3::sub(d, b))).0;
        facet.map(|node| {
            let mean = vec3::at(self.normals, node);
            let above = vec3::dot(mean, own) - S::from_f64(SHARP);
            match above * S::from_f64(1.0 / (SMOOTH - SHARP)) {
                share if share <= S::ZERO => own,
                share if share >= S::ONE => mean,
                share => vec3::direction(vec3::axpy(own, share, vec3::sub(mean, own))).0,
            }
        })
    }

    /// Box around a mesh's nodes.
    pub(super) fn bounds(&self, mesh: &Mesh<S>) -> Option<Extent<S>> {
        let [first, end] = mesh.nodes;
        Extent::around(self.pos.get(first..end)?)
    }

    /// Box around a thing, enlarged by the depth to which something may be inside it.
    pub(super) fn extent(&self, thing: &Thing<S>) -> Extent<S> {
        let (Extent { low, high }, wider) = match (self.rigid(thing), self.mesh(thing)) {
            (Some((shape, _, frame)), _) => match shape.reach() {
                Some(reach) => (Extent { low: frame.origin, high: frame.origin }, reach),
                None => return Extent::everywhere(),
            },
            (_, Some(mesh)) => match self.bounds(&mesh) {
                Some(extent) => (extent, mesh.depth),
                None => return Extent::everywhere(),
            },
            _ => return Extent::everywhere(),
        };
        Extent { low: low.map(|x| x - wider), high: high.map(|x| x + wider) }
    }
}

/// The corners of a facet with their weights at a foot; a triangle repeats its third corner.
pub(super) fn shares<S: Scalar>(facet: &[usize; 4], near: &FacetNearest<S>) -> [(usize, S); 4] {
    let ([a, b, c, d], [p, q, r, s]) = (*facet, near.weights);
    if c == d { [(a, p), (b, q), (c, r + s), (d, S::ZERO)] } else { [(a, p), (b, q), (c, r), (d, s)] }
}
