//! A rectangular sheet in a frame, stepped by one walk through its nodes: for cores that compute number by number.
//!
//! In: nodes row by row, the frame's among them, and what all springs of a direction share. Out: the nodes a step later, in place.
//! Velocity Verlet whose dampers and air see predicted speeds (Groot and Warren 1997): x += h v + h^2/2 a; v~ = v + h a;
//! v += h/2 (a + a(x, v~)): order 2, one evaluation, explicit. A row moves just before the row below it asks for its places; each spring and
//! facet is computed once, and what a node hears from its left stays in registers.
//! Pressure: the gradient of the volume ([`super::PressureForm::Exact`]). A corner of the frame, which no spring holds, stands midway
//! between its neighbours: its facet is then the triangle of the other three.

use crate::real::Scalar;
use crate::vec3::{self, Vec3};

/// A node of the sheet.
#[derive(Clone, Copy, Debug)]
pub struct Node<S> {
    /// Position (m).
    pub pos: Vec3<S>,
    /// Velocity (m/s); from when its row has moved until its forces are known, the predicted one.
    pub vel: Vec3<S>,
    /// Acceleration (m/s^2).
    pub acc: Vec3<S>,
    /// Force of springs and facets below it (N).
    below: Vec3<S>,
    /// 1/mass (1/kg); 0 in the frame.
    pub inverse_mass: S,
}

impl<S: Scalar> Node<S> {
    /// Where it is (m) and how fast it moves (m/s).
    #[must_use]
    pub fn new(pos: Vec3<S>, vel: Vec3<S>, inverse_mass: S) -> Self {
        Node { pos, vel, acc: vec3::zero(), below: vec3::zero(), inverse_mass }
    }
}

/// What all springs of a direction are.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Tie<S> {
    /// K (N/m).
    pub stiffness: S,
    /// L (m).
    pub rest_length: S,
    /// C (N s/m), where they have dampers.
    pub damping: Option<S>,
}

/// What never changes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sheet<S> {
    /// Nodes of a row, the frame's two among them.
    pub columns: usize,
    /// Springs along rows, and along columns; none where nothing is stiff.
    pub springs: Option<[Tie<S>; 2]>,
    /// Weight of a node (N).
    pub weight: Vec3<S>,
    /// Force of the air on a node over its speed (N s/m).
    pub air_drag: S,
    /// Gauge pressure (Pa), where there is gas.
    pub pressure: Option<S>,
}

/// The sheet has been lost: a number has left the numbers, the step was too long. The nodes are worthless.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Lost;

impl<S: Scalar> Sheet<S> {
    /// Computes the accelerations of the start.
    ///
    /// # Errors
    /// Where one is no number.
    pub fn begin(&self, nodes: &mut [Node<S>]) -> Result<(), Lost> {
        self.step(nodes, S::ZERO)
    }

    /// Advances all nodes by h (s), row by row; they must be whole rows.
    ///
    /// # Errors
    /// Where an acceleration is no number.
    #[inline(always)]
    pub fn step(&self, nodes: &mut [Node<S>], h: S) -> Result<(), Lost> {
        let half = S::from_f64(0.5) * h;
        let mut sum = S::ZERO;
        let mut rows = nodes.chunks_exact_mut(self.columns.max(1));
        let Some(mut here) = rows.next() else { return Ok(()) };
        for above in rows {
            sum = sum + self.row(here, above, [h, half]);
            here = above;
        }
        if sum.is_finite() { Ok(()) } else { Err(Lost) }
    }

    /// Moves the row above, then finishes this one; returns a number that is none where an acceleration is none.
    #[inline(always)]
    fn row(&self, here: &mut [Node<S>], above: &mut [Node<S>], [h, half]: [S; 2]) -> S {
        let mut sum = S::ZERO;
        let mut pairs = here.iter_mut().zip(above);
        // The first and the last stand in the frame, which nothing moves.
        let Some((mut left, mut corner)) = pairs.next() else { return sum };
        let mut rise = vec3::sub(corner.pos, left.pos);
        let (mut force, mut pushed) = (vec3::zero(), vec3::zero());
        for (right, above) in pairs {
            above.advance(h, half);
            let (along, next) = (vec3::sub(right.pos, left.pos), vec3::sub(above.pos, right.pos));
            let [a, b, c, d] = self.shares(along, rise, next);
            let tie = self.pull(0, along, vec3::sub(right.vel, left.vel));
            force = vec3::add(vec3::add(force, tie), a);
            sum = sum + self.finish(left, force, half);
            corner.below = vec3::add(pushed, d);
            let lift = self.pull(1, next, vec3::sub(above.vel, right.vel));
            force = vec3::add(vec3::add(vec3::sub(right.below, tie), lift), b);
            pushed = vec3::sub(c, lift);
            (left, corner, rise) = (right, above, next);
        }
        sum
    }

    /// Force on the tail of a spring (N), of its way to the head (m) and of that way's rate (m/s).
    #[inline(always)]
    fn pull(&self, direction: usize, way: Vec3<S>, rate: Vec3<S>) -> Vec3<S> {
        let Some(springs) = &self.springs else { return vec3::zero() };
        let Tie { stiffness, rest_length, damping } = springs[direction & 1];
        let inverse = S::ONE / vec3::norm(way);
        // K (l - L)/l, and C l_dot/l = C way.rate/l^2.
        let elastic = stiffness - stiffness * rest_length * inverse;
        let over_length = match damping {
            Some(damping) => elastic + damping * vec3::dot(way, rate) * (inverse * inverse),
            None => elastic,
        };
        vec3::scale(way, over_length)
    }

    /// Acceleration and velocity of a node under a force (N) of springs and facets.
    #[inline(always)]
    fn finish(&self, node: &mut Node<S>, force: Vec3<S>, half: S) -> S {
        let force = vec3::axpy(vec3::add(force, self.weight), -self.air_drag, node.vel);
        let acc = vec3::scale(force, node.inverse_mass);
        node.vel = vec3::axpy(node.vel, half, vec3::sub(acc, node.acc));
        node.acc = acc;
        acc[0] + acc[1] + acc[2]
    }

    /// Forces of the pressure on the corners of a facet (N), of its sides a -> b, a -> d, b -> c (m).
    //   p = c - a, q = d - b, g = a + c - b - d in the shares of `pressure::corner_shares`, written in the sides s, u, w:
    //   p x q = s x u + s x w - u x w,  q x g = s x u - s x w + u x w,  p x g = s x w - s x u + u x w
    #[inline(always)]
    fn shares(&self, side: Vec3<S>, left: Vec3<S>, right: Vec3<S>) -> [Vec3<S>; 4] {
        let Some(pressure) = self.pressure else { return [vec3::zero(); 4] };
        let twelfth = S::from_f64(1.0 / 12.0) * pressure;
        let (side, turn) = (vec3::scale(side, twelfth), vec3::scale(vec3::cross(left, right), twelfth));
        let (x, y) = (vec3::cross(side, left), vec3::cross(side, right));
        let area = vec3::sub(vec3::add(x, y), turn);
        let (a, b) = (vec3::add(area, x), vec3::add(area, y));
        [a, b, vec3::sub(b, turn), vec3::sub(a, turn)]
    }
}

impl<S: Scalar> Node<S> {
    /// x += h v + h^2/2 a, v += h a: v as it is predicted.
    #[inline(always)]
    fn advance(&mut self, h: S, half: S) {
        let middle = vec3::axpy(self.vel, half, self.acc);
        self.pos = vec3::axpy(self.pos, h, middle);
        self.vel = vec3::axpy(middle, half, self.acc);
    }
}
