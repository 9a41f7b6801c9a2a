//! Contact of a sheet's node with a body's tissue: pressure from depth, friction from the slip since the state before.
//!
//! In: a node's position in the bed and a segment's pose. Out: energy, its gradient with respect to the node's
//! position, its Hessian. Tissue stores k A depth^2/2, modified if it has a memory. Friction has an incremental
//! potential: with u the slip of the node over the tissue since the state before, and P the tangential projection, the
//! trial force t = t0 + k_t P u is held up to the limit mu N, and beyond it |t| = mu N; the energy is |t|^2/(2 k_t), or
//! mu N (|t| - mu N/2)/k_t. Normal and limit are those of the pass before and are renewed until they do not change.

use super::bed::{ALONG, Bed};
use crate::body::{Body, Inside};
use crate::pose::Pose;
use crate::tissue::Line;
use smartbed_runtime::vec3::{Vec3, add, axpy, dot, norm, scale, sub, tangential};

/// A node in contact with tissue.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Touch {
    /// Node of the sheet.
    pub node: usize,
    /// Segment.
    pub segment: usize,
    /// Depth (m), > 0.
    pub depth: f64,
    /// Outward normal of the tissue, in the bed's frame.
    pub normal: Vec3<f64>,
    /// Decrease of the depth per distance along the normal.
    pub slope: f64,
    /// Normal stiffness (N/m).
    pub stiffness: f64,
    /// Depth (m) at which the force is 0.
    pub rest: f64,
    /// Tangential stiffness (N/m).
    pub along: f64,
}

/// Friction at a node since the state before, in the segment's axes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Anchor {
    /// Segment.
    pub segment: usize,
    /// Position of the node in the state before (m).
    pub place: Vec3<f64>,
    /// Force t0 (N) on the tissue.
    pub force: Vec3<f64>,
    /// Normal of the surface.
    pub normal: Vec3<f64>,
    /// mu N (N).
    pub limit: f64,
    /// k_t (N/m).
    pub stiffness: f64,
}

/// Gradient with respect to a node's position, and Hessian, in the bed's frame.
#[derive(Clone, Copy, Debug)]
pub struct Pull {
    pub gradient: Vec3<f64>,
    pub hessian: [Vec3<f64>; 3],
}

/// The segments that can reach a tile's sheet.
pub fn near(bed: &Bed, body: &Body, tile: &Pose, poses: &[Pose]) -> Vec<usize> {
    let [a, b] = bed.lattice.size;
    // Assumes that a sheet bulges by less than its width.
    let reach = 0.5 * a.hypot(b) + 0.5 * a.min(b);
    let is_near = |s: &usize| {
        norm(sub(poses[*s].place, tile.place)) < reach + body.segments[*s].shape.reach() + bed.cover.thickness
    };
    (0..poses.len()).filter(is_near).collect()
}

/// The contact of a node with a segment, if the node is inside its tissue.
pub fn touch(
    bed: &Bed,
    body: &Body,
    node: usize,
    place: Vec3<f64>,
    segment: usize,
    pose: &Pose,
    line: impl Fn() -> Line,
) -> Option<Touch> {
    let part = &body.segments[segment];
    // Most nodes are too far away, which their squared distance shows quickly.
    let away = sub(place, pose.place);
    let reach = part.shape.reach() + bed.cover.thickness;
    if dot(away, away) >= reach * reach {
        return None;
    }
    let Inside { depth, normal, slope } =
        part.shape.within(pose.attitude.to_body(away), bed.cover.thickness)?;
    let Line { slope: share, rest } = line();
    let layer = part.foundation * bed.lattice.cell();
    let (stiffness, along) = (share * layer, ALONG * layer);
    let normal = pose.attitude.to_inertial(normal);
    (depth > rest).then_some(Touch { node, segment, depth, normal, slope, stiffness, rest, along })
}

impl Touch {
    /// Normal force (N).
    #[must_use]
    pub fn force(&self) -> f64 {
        self.slope * self.tension()
    }

    /// Derivative of the layer's energy with respect to the depth (N).
    pub(super) fn tension(&self) -> f64 {
        self.stiffness * (self.depth - self.rest)
    }

    /// Energy (J).
    pub(super) fn energy(&self) -> f64 {
        0.5 * self.stiffness * (self.depth - self.rest).powi(2)
    }

    /// Gradient and Hessian, without the term of the surface's curvature, which is negative.
    pub(super) fn pull(&self) -> Pull {
        let n = self.normal;
        let stiffness = self.stiffness * self.slope * self.slope;
        Pull { gradient: scale(n, -self.force()), hessian: n.map(|x| scale(n, stiffness * x)) }
    }

    /// The anchor of friction from here on, with the force that it holds already (on the tissue, in the bed's frame).
    pub(super) fn anchor(&self, place: Vec3<f64>, pose: &Pose, held: Vec3<f64>, friction: f64) -> Anchor {
        let limit = friction * self.force();
        let along = tangential(held, self.normal);
        let size = norm(along);
        let share = if size > limit { limit / size } else { 1.0 };
        Anchor {
            segment: self.segment,
            place: pose.inwards(place),
            force: pose.attitude.to_body(scale(along, share)),
            normal: pose.attitude.to_body(self.normal),
            limit,
            stiffness: self.along,
        }
    }
}

impl Anchor {
    /// Trial force t, as for a spring, in the segment's axes.
    fn trial(&self, place: Vec3<f64>, pose: &Pose) -> Vec3<f64> {
        let slid = sub(pose.inwards(place), self.place);
        tangential(axpy(self.force, self.stiffness, slid), self.normal)
    }

    /// Energy (J) of the increment.
    pub(super) fn energy(&self, place: Vec3<f64>, pose: &Pose) -> f64 {
        let t = norm(self.trial(place, pose));
        let energy = if t <= self.limit { 0.5 * t * t } else { self.limit * (t - 0.5 * self.limit) };
        energy / self.stiffness
    }

    /// A touch without normal force.
    pub(super) fn without_touch(&self, node: usize, pose: &Pose) -> Touch {
        let normal = pose.attitude.to_inertial(self.normal);
        let along = self.stiffness;
        Touch {
            node,
            segment: self.segment,
            depth: 0.0,
            normal,
            slope: 1.0,
            stiffness: 0.0,
            rest: 0.0,
            along,
        }
    }

    /// Energy (J) stored by shear of the surface.
    #[must_use]
    pub fn held(&self) -> f64 {
        0.5 * dot(self.force, self.force) / self.stiffness
    }

    /// Friction force (N) of the sheet on the tissue, in the bed's frame.
    #[must_use]
    pub fn drag(&self, place: Vec3<f64>, pose: &Pose) -> Vec3<f64> {
        let t = self.trial(place, pose);
        let size = norm(t);
        let share = if size > self.limit { self.limit / size } else { 1.0 };
        pose.attitude.to_inertial(scale(t, share))
    }

    /// Gradient and Hessian.
    pub(super) fn pull(&self, place: Vec3<f64>, pose: &Pose) -> Pull {
        let t = self.trial(place, pose);
        let size = norm(t);
        let (k, along) = if size > self.limit {
            (self.stiffness * self.limit / size, pose.attitude.to_inertial(scale(t, 1.0 / size)))
        } else {
            (self.stiffness, [0.0; 3])
        };
        let n = pose.attitude.to_inertial(self.normal);
        let hessian = std::array::from_fn(|i| {
            std::array::from_fn(|j| {
                let same = if i == j { 1.0 } else { 0.0 };
                k * (same - n[i] * n[j] - along[i] * along[j])
            })
        });
        Pull { gradient: self.drag(place, pose), hessian }
    }
}

impl Pull {
    /// The sum of both.
    pub fn with(self, other: &Pull) -> Pull {
        let hessian = std::array::from_fn(|i| add(self.hessian[i], other.hessian[i]));
        Pull { gradient: add(self.gradient, other.gradient), hessian }
    }
}
