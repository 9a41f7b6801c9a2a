//! What a stage of time adds to the energy: inertia and losses, so that its end is found as an equilibrium is.
//!
//! In: what a method of steps expects of every point. Out: terms of energy, gradient and Hessian. Every formula of
//! [`Method`](crate::method::Method) gives the velocity at the end as v = b (p - p~) and the acceleration as b (v - v~) =
//! b^2 (p - p^), so that the equations of motion at the end make m b^2/2 |p - p^|^2 + energy least. A segment's inertia is
//! that of six points on its axes. Losses are Kelvin and Voigt's: a damper of retardation times stiffness beside a spring.

use crate::band::Band;
use crate::body::{Body, Rows, Segment};
use crate::pose::Pose;
use crate::sheet::Lattice;
use crate::tissue::Memory;
use smartbed_runtime::vec3::{Vec3, add_at, dot, norm, scale, sub};

/// A stage of time for all points.
#[derive(Clone, Debug)]
pub struct Increment<'a> {
    /// b (1/s).
    pub rate: f64,
    /// Mass of a free node (kg).
    pub node_mass: f64,
    /// Retardation of the sheets (s).
    pub sheet_loss: f64,
    /// Retardation of what turns joints back (s).
    pub joint_loss: f64,
    /// p^ of nodes by tile, in the tile's frame at the end of the step.
    pub nodes: Vec<Vec<Vec3<f64>>>,
    /// Directions of dampers by tile, and how far apart along them p~ of their ends are.
    pub dampers: Vec<Vec<Damper>>,
    /// p^ of six points of each segment, in the bed's frame.
    pub segments: Vec<[Vec3<f64>; 6]>,
    /// p~ of the segments' attitudes.
    pub resting: Vec<Pose>,
    /// What tissue remembers, by tile.
    pub tissue: Vec<Memory<'a>>,
}

/// A sheet of a tile.
#[derive(Clone, Copy)]
pub struct Placed<'a> {
    pub lattice: &'a Lattice,
    pub sheet: &'a [Vec3<f64>],
    pub tile: usize,
}

/// Beside a spring.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Damper {
    /// Direction, from where the nodes are expected.
    pub direction: Vec3<f64>,
    /// Along it, between p~ of the ends (m).
    pub apart: f64,
}

/// Points that have a segment's mass and moments of inertia, a sixth of its mass each.
#[must_use]
pub fn points(segment: &Segment, pose: &Pose) -> [Vec3<f64>; 6] {
    let at = segment.shape.gyration();
    std::array::from_fn(|k| {
        let mut place = segment.centre;
        place[k / 2] += if k % 2 == 0 { at[k / 2] } else { -at[k / 2] };
        pose.outwards(place)
    })
}

impl Increment<'_> {
    /// Energy of a sheet's inertia and dampers.
    pub(super) fn sheet_energy(&self, placed: Placed) -> f64 {
        let inertia = 0.5 * self.node_mass * self.rate * self.rate;
        let kinetic = |(node, (x, hat)): (usize, (&Vec3<f64>, &Vec3<f64>))| {
            let off = sub(*x, *hat);
            placed.lattice.free(node).map_or(0.0, |_| inertia * dot(off, off))
        };
        let kinetic: f64 = placed.sheet.iter().zip(&self.nodes[placed.tile]).enumerate().map(kinetic).sum();
        let damped = |(spring, damper): (&crate::sheet::Spring, &Damper)| {
            let stretch = damper.stretch(placed.sheet, spring.ends);
            0.5 * self.sheet_loss * self.rate * spring.stiffness * stretch * stretch
        };
        kinetic + placed.lattice.springs.iter().zip(&self.dampers[placed.tile]).map(damped).sum::<f64>()
    }

    /// Adds that energy's gradient.
    pub(super) fn add_sheet_gradient(&self, placed: Placed, gradient: &mut [Vec3<f64>]) {
        let inertia = self.node_mass * self.rate * self.rate;
        for (node, (x, hat)) in placed.sheet.iter().zip(&self.nodes[placed.tile]).enumerate() {
            add_at(gradient, node, scale(sub(*x, *hat), inertia));
        }
        for (spring, damper) in placed.lattice.springs.iter().zip(&self.dampers[placed.tile]) {
            let pull = scale(
                damper.direction,
                self.damping(spring.stiffness) * damper.stretch(placed.sheet, spring.ends),
            );
            add_at(gradient, spring.ends[1], pull);
            add_at(gradient, spring.ends[0], scale(pull, -1.0));
        }
    }

    /// Adds its Hessian.
    pub(super) fn add_sheet_hessian(&self, lattice: &Lattice, tile: usize, band: &mut Band) {
        band.shift(self.node_mass * self.rate * self.rate);
        for (spring, damper) in lattice.springs.iter().zip(&self.dampers[tile]) {
            let d = damper.direction;
            let block = d.map(|x| scale(d, self.damping(spring.stiffness) * x));
            let [tail, head] = spring.ends.map(|end| lattice.free(end));
            for end in [tail, head].into_iter().flatten() {
                band.add_block(end, end, &block);
            }
            if let (Some(tail), Some(head)) = (tail, head) {
                band.add_block(tail, head, &block.map(|row| row.map(|x| -x)));
            }
        }
    }

    /// N/m of a damper beside a spring in this step.
    fn damping(&self, stiffness: f64) -> f64 {
        self.sheet_loss * self.rate * stiffness
    }

    /// Energy of the segments' inertia and of what joints lose.
    pub(super) fn body_energy(&self, body: &Body, poses: &[Pose]) -> f64 {
        let one = |(segment, (pose, hats)): (&Segment, (&Pose, &[Vec3<f64>; 6]))| {
            let factor = segment.mass / 12.0 * self.rate * self.rate;
            let off = points(segment, pose).into_iter().zip(hats).map(|(p, hat)| sub(p, *hat));
            factor * off.map(|o| dot(o, o)).sum::<f64>()
        };
        let kinetic: f64 = body.segments.iter().zip(poses.iter().zip(&self.segments)).map(one).sum();
        let share = self.joint_loss * self.rate;
        let lost: f64 = body.joints.iter().map(|j| share * j.turning_since(&self.resting, poses)).sum();
        kinetic + lost
    }

    /// Adds their gradient and Hessian; what turns of a segment have of second order is left out.
    pub(super) fn add_body(&self, body: &Body, poses: &[Pose], rows: &mut Rows) {
        for (index, (segment, pose)) in body.segments.iter().zip(poses).enumerate() {
            let factor = segment.mass / 6.0 * self.rate * self.rate;
            let same = std::array::from_fn(|i| std::array::from_fn(|j| if i == j { factor } else { 0.0 }));
            for (point, hat) in points(segment, pose).into_iter().zip(self.segments[index]) {
                let arm = sub(point, pose.place);
                rows.add_gradient(index, arm, scale(sub(point, hat), factor), 1.0);
                rows.add_hessian([index; 2], [arm; 2], &same, 1.0);
            }
        }
        let share = self.joint_loss * self.rate;
        body.joints.iter().for_each(|j| j.add_turning_since(&self.resting, poses, share, rows));
    }
}

impl Damper {
    /// Between two ends whose p~ and expected places are known.
    #[must_use]
    pub fn new(expected: [Vec3<f64>; 2], resting: [Vec3<f64>; 2]) -> Damper {
        let along = sub(expected[1], expected[0]);
        let direction = scale(along, 1.0 / norm(along).max(f64::MIN_POSITIVE));
        Damper { direction, apart: dot(direction, sub(resting[1], resting[0])) }
    }

    /// How much longer than p~ have it (m).
    #[must_use]
    pub fn stretch(&self, sheet: &[Vec3<f64>], ends: [usize; 2]) -> f64 {
        dot(self.direction, sub(sheet[ends[1]], sheet[ends[0]])) - self.apart
    }
}
