//! What a sheet's node and a body's tissue do to each other: pressure by depth, friction by what slid since before.
//!
//! In: a node's place in the bed and a segment's pose. Out: energy, the gradient by the node's place, its Hessian. Tissue
//! stores k A depth^2/2, more or less where it has a memory. Friction is an increment's potential: with u how far the node has gone over the tissue since the
//! state before, t = t0 + k_t P u is held up to the limit mu N, beyond it |t| stays there: |t|^2/(2 k_t), or
//! mu N (|t| - mu N/2)/k_t. Normal and limit are those of the pass before and are renewed until they do not change.

use super::bed::{ALONG, Bed};
use crate::body::{Body, Inside};
use crate::pose::Pose;
use crate::tissue::Line;
use smartbed_runtime::vec3::{Vec3, add, axpy, dot, norm, scale, sub, tangential};

/// A node in tissue.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Touch {
    /// Node of the sheet.
    pub node: usize,
    /// Segment.
    pub segment: usize,
    /// Depth (m), > 0.
    pub depth: f64,
    /// Out of the tissue, in the bed's frame.
    pub normal: Vec3<f64>,
    /// What the depth loses per way along the normal.
    pub slope: f64,
    /// N/m.
    pub stiffness: f64,
    /// Depth (m) at which tissue presses nothing.
    pub rest: f64,
    /// N/m along the surface.
    pub along: f64,
}

/// What friction holds at a node, in the segment's axes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Anchor {
    /// Segment.
    pub segment: usize,
    /// Where the node stood (m).
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

/// Gradient by a node's place and Hessian, in the bed's frame.
#[derive(Clone, Copy, Debug)]
pub struct Pull {
    pub gradient: Vec3<f64>,
    pub hessian: [Vec3<f64>; 3],
}

/// Segments that can reach a tile's sheet.
pub fn near(bed: &Bed, body: &Body, tile: &Pose, poses: &[Pose]) -> Vec<usize> {
    let [a, b] = bed.lattice.size;
    // A sheet bulges less than it is wide.
    let reach = 0.5 * a.hypot(b) + 0.5 * a.min(b);
    let is_near = |s: &usize| {
        norm(sub(poses[*s].place, tile.place)) < reach + body.segments[*s].shape.reach() + bed.cover.thickness
    };
    (0..poses.len()).filter(is_near).collect()
}

/// The touch of a node at a place in the bed with a segment, if it lies inside its tissue.
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
    // Most nodes are far away: their squared distance says so.
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

    /// What the layer's energy gains per depth (N).
    pub(super) fn tension(&self) -> f64 {
        self.stiffness * (self.depth - self.rest)
    }

    /// Energy (J).
    pub(super) fn energy(&self) -> f64 {
        0.5 * self.stiffness * (self.depth - self.rest).powi(2)
    }

    /// Gradient and Hessian without that of the surface's curvature, which is negative.
    pub(super) fn pull(&self) -> Pull {
        let n = self.normal;
        let stiffness = self.stiffness * self.slope * self.slope;
        Pull { gradient: scale(n, -self.force()), hessian: n.map(|x| scale(n, stiffness * x)) }
    }

    /// What friction can hold from here on, with a force that it holds already (on the tissue, in the bed's frame).
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
    /// t as a spring would have it, in the segment's axes.
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

    /// A touch that presses nothing.
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

    /// Energy (J) that the surface holds.
    #[must_use]
    pub fn held(&self) -> f64 {
        0.5 * dot(self.force, self.force) / self.stiffness
    }

    /// Force (N) that the sheet drags the tissue with, in the bed's frame.
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
    /// Both together.
    pub fn with(self, other: &Pull) -> Pull {
        let hessian = std::array::from_fn(|i| add(self.hessian[i], other.hessian[i]));
        Pull { gradient: add(self.gradient, other.gradient), hessian }
    }
}
