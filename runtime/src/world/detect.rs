//! Contact detection: lists the places where the parts of each pair are near each other, for one step.
//!
//! In: things at their present positions, pairs, the margin within which a gap counts. Out: contacts with sides, axes,
//! gap.
//! ```text
//! rigid on rigid    features of both shapes (`rigid::narrow`)
//! mesh on rigid     every node over the shape's surface (`over_shape`); the shape's corners over the facet below them, round
//!                   ones over every facet that has a foot for them (a ball may lie between two; `round`)
//! mesh on mesh      every node of each over the nearest facet of the other
//! in a fold         a node or corner between two facets that face each other is over both
//! ```
//! Both sides of a contact share one point, a node's or the foot on a facet, so that action and reaction lie on one
//! line. A node over a facet is a gap off it: what lies below it turns with the facet (`Contact::couple`). Edges of
//! facets that cross, and a mesh on itself, are not detected.

use super::extent::Extent;
use super::scenery::{Feet, Foot, Mesh, Over, Scenery, Standing, edge, shares};
use super::thing::{Pair, Thing};
use crate::mechanism::Fault;
use crate::real::Scalar;
use crate::rigid::contact::{Contact, Side, Twist};
use crate::rigid::history::{History, Swept};
use crate::rigid::impact::InverseMass;
use crate::rigid::narrow::{Placed, core_points, features};
use crate::rigid::struck::Group;
use crate::vec3::{self, Vec3};

/// A gap of this many rounding units of the contact's coordinates counts as closed.
const ROUNDED: f64 = 64.0;

/// Contact numbers from here on are those of a shape's points over facets; smaller ones are those of nodes.
pub(super) const OF_SHAPE: u32 = 1 << 30;
/// Most points of a shape: contacts over the next facet are numbered this much higher.
pub(super) const POINTS: u32 = 8;
/// Added to the number of a point in a fold, one for each of its two facets.
const IN_FOLD: [u32; 2] = [1 << 28, 1 << 29];

/// A contact of a step.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Touch<S> {
    /// Number of its pair.
    pub pair: usize,
    /// Number of the contact within its pair: the same from step to step.
    pub id: u32,
    /// Gap (m) in the middle of the step.
    pub gap: S,
    /// How much the gap (m) may change while it slides on a smooth surface with the normals of the facet below it.
    pub sagitta: S,
    /// Whether it is at an edge or a corner of a box, whose normal is anything between those of the faces.
    pub sharp: bool,
    /// Contact point in N (m).
    pub point: Vec3<S>,
    /// Sides, axes, law, impulse over the step (N s).
    pub contact: Contact<S>,
    /// K = W M^-1 W', the contact's inverse mass (1/kg).
    pub(super) inverse_mass: InverseMass<S>,
    /// Relative velocity at the start of the step, along n, t1, t2.
    pub(super) start: Vec3<S>,
    /// By how much its normal velocity at the end of the step differs from what the impulses give it at the arms of the
    /// detection (m/s): 0 but in a conserving step, whose arms turn (`conserving::turning`).
    pub(super) turned: S,
    /// The part of that which is left when the arms are those of the detection (m/s).
    pub(super) missed: S,
    /// Which contacts feel its impulse (`sweep`).
    pub(super) group: Group,
    /// Least normal velocity (m/s) with which an overlap is left after the step.
    pub(super) out: S,
    /// History of the sweeps over it.
    pub(super) history: History<S>,
    /// The impulse (N s) at which a contact that yields has not given way (`sweep`).
    pub(super) unyielded: Vec3<S>,
}

impl<S: Scalar> Touch<S> {
    /// The normal velocity w (m/s) to reach at the end of a step of h; None where the contact does not act.
    pub(super) fn wanted(&self, h: S) -> Option<S> {
        if self.out > S::ZERO {
            return Some(self.out);
        }
        let (came, e) = (self.start[0], self.contact.restitution);
        let closed = self.gap <= S::ZERO;
        if e <= S::ZERO {
            let opening = if closed { S::ZERO } else { self.gap / h };
            return Some(-(opening.max(came).max(S::ZERO)));
        }
        let turned = if came > S::ZERO { -came } else { -(e * came) };
        (self.gap <= self.rounding()).then_some(turned)
    }

    /// A gap (m) that is rounding of where the contact is: what stands there stands on it.
    pub(super) fn rounding(&self) -> S {
        let farthest = self.point.iter().fold(S::ZERO, |most, x| most.max(x.abs()));
        S::from_f64(ROUNDED) * S::EPSILON * farthest
    }

    /// Relative velocity n, t1, t2 (m/s) at the end of the step, given the velocities there.
    pub(super) fn end(&self, twists: &[Twist<S>]) -> Vec3<S> {
        let [n, x, y] = self.contact.relative(twists);
        [n + self.turned, x, y]
    }

    /// Relative velocity n, t1, t2 (m/s) at the start of the step, or before an impact.
    #[must_use]
    pub fn velocity(&self) -> Vec3<S> {
        self.start
    }

    /// Is it this contact of this pair?
    pub(super) fn is(&self, pair: usize, id: u32) -> bool {
        self.pair == pair && self.id == id
    }

    /// The nodes that touch here, given the number of ports.
    pub(super) fn nodes(&self, ports: usize) -> impl Iterator<Item = usize> {
        self.contact.points().filter_map(move |(_, point)| point.body.checked_sub(ports))
    }

    /// Largest diagonal entry of K (1/kg).
    pub(super) fn weight(&self) -> S {
        let [[a, ..], [_, b, _], [.., c]] = self.inverse_mass;
        a.max(b).max(c)
    }

    /// An empty entry of a list.
    #[must_use]
    pub fn empty() -> Touch<S> {
        let zero = vec3::zero();
        let contact = Contact::between([Side::fixed(); 2], [S::ZERO, S::ZERO, S::ONE]);
        let inverse_mass = [zero; 3];
        Touch {
            pair: 0,
            id: 0,
            gap: S::ZERO,
            sagitta: S::ZERO,
            sharp: false,
            point: zero,
            contact,
            inverse_mass,
            start: zero,
            turned: S::ZERO,
            missed: S::ZERO,
            group: Group::Later,
            out: S::ZERO,
            history: History::empty(),
            unyielded: zero,
        }
    }
}

impl<S: Scalar> Swept<S> for Touch<S> {
    fn parts(&mut self) -> (&mut Contact<S>, S, &mut History<S>) {
        let weight = self.weight();
        (&mut self.contact, weight, &mut self.history)
    }
}

/// Where two things meet.
pub(super) struct Meeting<S> {
    /// Gap (m).
    pub(super) gap: S,
    /// Contact point in N (m).
    pub(super) point: Vec3<S>,
    /// Sides and axes.
    pub(super) contact: Contact<S>,
    /// How much the gap (m) may change while it slides on a smooth surface with the normals of the facet below it.
    pub(super) sagitta: S,
    /// Whether it is at an edge or a corner of a box, whose normal is anything between those of the faces.
    pub(super) sharp: bool,
}

impl<S: Scalar> Meeting<S> {
    /// On a surface whose normals are its own.
    pub(super) fn exact(gap: S, point: Vec3<S>, contact: Contact<S>) -> Self {
        Self { gap, point, contact, sagitta: S::ZERO, sharp: false }
    }
}

/// The list of contacts while it is filled.
pub(super) struct Found<'a, S> {
    pub(super) touches: &'a mut [Touch<S>],
    pub(super) count: usize,
    full: bool,
}

impl<S: Scalar> Found<'_, S> {
    pub(super) fn push(
        &mut self,
        pair: (usize, &Pair<S>),
        id: u32,
        Meeting { gap, point, mut contact, sagitta, sharp }: Meeting<S>,
    ) {
        let (number, law) = pair;
        (contact.friction, contact.restitution) = (law.friction, law.restitution);
        match self.touches.get_mut(self.count) {
            Some(place) => {
                *place = Touch { pair: number, id, gap, sagitta, sharp, point, contact, ..Touch::empty() };
                self.count += 1;
            }
            None => self.full = true,
        }
    }

    /// The contacts from this one on.
    pub(super) fn from(&self, first: usize) -> &[Touch<S>] {
        self.touches.get(first..self.count).unwrap_or_default()
    }

    /// Removes those contacts from `first` to `end` for which one of the later ones stands; the others keep their
    /// order.
    pub(super) fn leave_out(
        &mut self,
        [first, end]: [usize; 2],
        stands: impl Fn(&Touch<S>, &Touch<S>) -> bool,
    ) {
        let touches = self.touches.get_mut(..self.count).unwrap_or_default();
        self.count = keep_only(touches, first, |k, own, all| {
            k >= end || !all.iter().skip(end).any(|later| stands(own, later))
        });
    }
}

/// Moves the contacts from `first` on that `keeps` wants, given number, contact and list, to the front of those;
/// returns the number of all that are left. The later ones of the list are in their places when it is asked.
pub(super) fn keep_only<S: Scalar>(
    touches: &mut [Touch<S>],
    first: usize,
    mut keeps: impl FnMut(usize, &mut Touch<S>, &[Touch<S>]) -> bool,
) -> usize {
    let mut kept = first;
    for k in first..touches.len() {
        let Some(mut own) = touches.get(k).copied() else { break };
        if keeps(k, &mut own, touches) {
            if let Some(place) = touches.get_mut(kept) {
                *place = own;
            }
            kept += 1;
        }
    }
    kept
}

impl<'a, S: Scalar> Scenery<'a, S> {
    /// Fills the list; returns its length. Pairs whose bounding boxes are too far apart are skipped, and those with a
    /// force law (`yielding`); those without boxes are always examined.
    pub(super) fn find(
        &self,
        pairs: &[Pair<S>],
        touches: &mut [Touch<S>],
        extents: &[Extent<S>],
    ) -> Result<usize, Fault> {
        let mut found = Found { touches, count: 0, full: false };
        for pair in pairs.iter().enumerate() {
            if pair.1.force.is_some() || !pair.1.may_meet(extents, self.margin) {
                continue;
            }
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
            let contact = Contact::between(sides, feature.normal);
            found.push(pair, feature.id, Meeting::exact(feature.gap, feature.point, contact));
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
        let first = found.count;
        for (id, node) in (0..).zip(mesh.nodes[0]..mesh.nodes[1]) {
            if self.near_node(node, &shape).gap <= self.margin
                && let Some(meeting) = self.node_over_shape(&mesh, node, &shape)
                && meeting.gap <= self.margin
            {
                found.push(pair, id, meeting);
            }
        }
        let (points, count, radius) = core_points(&shape.0);
        for (number, place) in (0..).zip(points.iter().take(count)) {
            let point = shape.2.point(*place);
            if radius > S::ZERO {
                self.round_over_mesh(pair, &mesh, &shape, (number, point, radius), (first, &mut *found));
                continue;
            }
            for (flag, foot) in self.flagged_feet(&mesh, point) {
                if !self.on_a_node(&mesh, &foot, &shape) {
                    found.push(pair, OF_SHAPE + number + flag, self.shape_over_facet(&shape, foot));
                }
            }
        }
    }

    /// The contact of a point of a shape's core with a facet.
    pub(super) fn shape_over_facet(&self, standing: &Standing<S>, (facet, near): Foot<S>) -> Meeting<S> {
        let (shape, port, _) = standing;
        let (_, _, radius) = core_points(shape);
        let sides = [self.side_of_port(*port, near.foot), self.side_of_facet(facet, &near)];
        let contact = Contact::between(sides, near.normal);
        Meeting { sagitta: near.sagitta, ..Meeting::exact(near.gap - radius, near.foot, contact) }
    }

    /// Whether the foot of a box's corner is a node, up to rounding, that touches the box itself.
    fn on_a_node(&self, mesh: &Mesh<S>, (facet, near): &Foot<S>, shape: &Standing<S>) -> bool {
        shares(facet, near).into_iter().any(|(node, weight)| {
            weight > S::ONE - edge()
                && mesh.has(node)
                && self.node_over_shape(mesh, node, shape).is_some_and(|meeting| meeting.gap <= self.margin)
        })
    }

    /// The contact of a node with a facet.
    fn node_over_facet(&self, node: usize, (facet, near): Foot<'a, S>) -> Meeting<S> {
        let (below, couple) = self.side_below(facet, &near);
        let contact = Contact::between([self.side_of_node(node), below], near.normal);
        let contact = Contact { couple: Some(couple), ..contact };
        Meeting { sagitta: near.sagitta, ..Meeting::exact(near.gap, vec3::at(self.pos, node), contact) }
    }

    fn nodes_on_mesh(&self, pair: (usize, &Pair<S>), own: Mesh<S>, other: Mesh<'a, S>, found: &mut Found<S>) {
        let Some(Extent { low, high }) = self.bounds(&other).filter(|_| !other.facets.is_empty()) else {
            return;
        };
        let far = self.margin.max(other.depth);
        let base = if own.nodes[0] < other.nodes[0] { 0 } else { OF_SHAPE };
        for (id, node) in (base..).zip(own.nodes[0]..own.nodes[1]) {
            let x = vec3::at(self.pos, node);
            if !(0..3).all(|i| low[i] - far <= x[i] && x[i] <= high[i] + far) {
                continue;
            }
            for (flag, foot) in self.flagged_feet(&other, x) {
                found.push(pair, id + flag, self.node_over_facet(node, foot));
            }
        }
    }

    /// The feet of a point, each with the flag to add to its contact's number.
    fn flagged_feet(
        &self,
        mesh: &Mesh<'a, S>,
        point: Vec3<S>,
    ) -> impl Iterator<Item = (u32, Foot<'a, S>)> + use<'a, S> {
        let [low, high] = IN_FOLD;
        let (first, second) = match self.feet(mesh, point) {
            Feet::Below(foot) => (foot.map(|foot| (0, foot)), None),
            Feet::Fold(first, second) => (Some((low, first)), Some((high, second))),
        };
        first.into_iter().chain(second)
    }

    /// Of a contact between two meshes: the one whose node touches, and the one whose facet does.
    pub(super) fn meshes(&self, [one, other]: [&'a Thing<S>; 2], id: u32) -> Option<[Mesh<'a, S>; 2]> {
        let (a, b) = (self.mesh(one)?, self.mesh(other)?);
        Some(if (a.nodes[0] < b.nodes[0]) == (id < OF_SHAPE) { [a, b] } else { [b, a] })
    }

    /// A contact found earlier, at the present positions. None if it no longer exists.
    pub(super) fn again(&self, pair: &Pair<S>, id: u32) -> Option<Meeting<S>> {
        let [one, other] = pair.things.map(|thing| self.things.get(thing));
        let (one, other) = (one?, other?);
        let over = match IN_FOLD.map(|flag| id & flag > 0) {
            [true, _] => Over::First,
            [_, true] => Over::Second,
            _ => Over::Nearest,
        };
        let number = (id % IN_FOLD[0]) as usize;
        let meeting = match (self.rigid(one), self.rigid(other)) {
            (Some(a), Some(b)) => {
                let (first, second) =
                    (Placed { shape: &a.0, frame: &a.2 }, Placed { shape: &b.0, frame: &b.2 });
                let feature = features(first, second, self.margin).iter().find(|feature| feature.id == id)?;
                let sides = [a.1, b.1].map(|port| self.side_of_port(port, feature.point));
                Meeting::exact(feature.gap, feature.point, Contact::between(sides, feature.normal))
            }
            (None, None) => {
                let [own, below] = self.meshes([one, other], id)?;
                let node = own.nodes[0] + number;
                self.node_over_facet(node, self.foot(&below, (vec3::at(self.pos, node), S::ZERO), over)?)
            }
            (Some(shape), None) | (None, Some(shape)) => {
                let mesh = self.mesh(one).or_else(|| self.mesh(other))?;
                if id < OF_SHAPE {
                    self.node_over_shape(&mesh, mesh.nodes[0] + number, &shape)?
                } else {
                    let (points, _, radius) = core_points(&shape.0);
                    let point = shape.2.point(*points.get(number % POINTS as usize)?);
                    let over = if radius > S::ZERO { Over::Facet(number / POINTS as usize) } else { over };
                    self.shape_over_facet(&shape, self.foot(&mesh, (point, radius), over)?)
                }
            }
        };
        let (friction, restitution) = (pair.friction, pair.restitution);
        Some(Meeting { contact: Contact { friction, restitution, ..meeting.contact }, ..meeting })
    }

    /// Where a contact that was found before is now, of its node or of the same point of its facet; None between rigid
    /// shapes.
    pub(super) fn place_of(&self, pair: &Pair<S>, id: u32, contact: &Contact<S>) -> Option<Vec3<S>> {
        let [one, other] = pair.things.map(|thing| self.things.get(thing));
        let (one, other) = (one?, other?);
        let mesh = match (self.rigid(one), self.rigid(other)) {
            (Some(_), Some(_)) => return None,
            (None, None) => {
                let [own, _] = self.meshes([one, other], id)?;
                own
            }
            _ => self.mesh(one).or_else(|| self.mesh(other))?,
        };
        if id < OF_SHAPE || (self.rigid(one).is_none() && self.rigid(other).is_none()) {
            return Some(vec3::at(self.pos, mesh.nodes[0] + (id % IN_FOLD[0]) as usize));
        }
        let nodes = contact.sides.iter().flat_map(Side::points).filter_map(|point| {
            point.body.checked_sub(self.frames.len()).map(|node| (point.weight, vec3::at(self.pos, node)))
        });
        let sum = nodes.fold((S::ZERO, vec3::zero()), |(sum, place), (weight, pos)| {
            (sum + weight, vec3::axpy(place, weight, pos))
        });
        // A facet with held nodes has no such point.
        ((sum.0 - S::ONE).abs() <= S::EPSILON.sqrt()).then_some(sum.1)
    }
}
