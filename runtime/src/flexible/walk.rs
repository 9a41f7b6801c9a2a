//! A rectangular sheet in a frame, stepped in one pass over its nodes: for cores without vector registers.
//!
//! In: nodes row by row, including the frame's, and the common properties of all springs of a direction. Out: the nodes
//! one step later, in place. Velocity Verlet in which dampers and air drag use predicted speeds (Groot & Warren 1997):
//! x += h v + h^2/2 a; v~ = v + h a; v += h/2 (a + a(x, v~)): order 2, one evaluation, explicit. A row is moved just
//! before the row below it needs its positions; each spring and facet is computed once, and the forces from a node's
//! left stay in registers. Pressure: the gradient of the volume ([`super::PressureForm::Exact`]). A corner of the
//! frame, which no spring holds, lies midway between its neighbours, so that its facet is the triangle of the other
//! three.

use crate::real::Scalar;
use crate::vec3::{self, Vec3};

/// A node of the sheet.
#[derive(Clone, Copy, Debug)]
pub struct Node<S> {
    /// Position (m).
    pub pos: Vec3<S>,
    /// Velocity (m/s); the predicted one between the move of its row and the evaluation of its forces.
    pub vel: Vec3<S>,
    /// Acceleration (m/s^2).
    pub acc: Vec3<S>,
    /// Force of the springs and facets below it (N).
    below: Vec3<S>,
    /// 1/mass (1/kg); 0 in the frame.
    pub inverse_mass: S,
}

impl<S: Scalar> Node<S> {
    /// A node at a position (m) with a velocity (m/s).
    #[must_use]
    pub fn new(pos: Vec3<S>, vel: Vec3<S>, inverse_mass: S) -> Self {
        Node { pos, vel, acc: vec3::zero(), below: vec3::zero(), inverse_mass }
    }
}

/// Common properties of all springs of a direction.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Tie<S> {
    /// K (N/m).
    pub stiffness: S,
    /// L (m).
    pub rest_length: S,
    /// C (N s/m); None without dampers.
    pub damping: Option<S>,
}

/// The constants of a sheet.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sheet<S> {
    /// Nodes of a row, including two of the frame.
    pub columns: usize,
    /// Springs along rows and along columns; None for a sheet without stiffness.
    pub springs: Option<[Tie<S>; 2]>,
    /// Weight of a node (N).
    pub weight: Vec3<S>,
    /// Drag of the air on a node per speed (N s/m).
    pub air_drag: S,
    /// Gauge pressure (Pa); None without gas.
    pub pressure: Option<S>,
}

/// A number became infinite or NaN because the step was too long; the nodes are unusable.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Lost;

impl<S: Scalar> Sheet<S> {
    /// Computes the accelerations at the start.
    ///
    /// # Errors
    /// [`Lost`] if one is not finite.
    pub fn begin(&self, nodes: &mut [Node<S>]) -> Result<(), Lost> {
        self.step(nodes, S::ZERO)
    }

    /// Advances all nodes by h (s), row by row; the slice must hold whole rows.
    ///
    /// # Errors
    /// [`Lost`] if an acceleration is not finite.
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

    /// Moves the row above, then finishes this one; returns a sum that is not finite if any acceleration is not.
    #[inline(always)]
    fn row(&self, here: &mut [Node<S>], above: &mut [Node<S>], [h, half]: [S; 2]) -> S {
        let mut sum = S::ZERO;
        let mut pairs = here.iter_mut().zip(above);
        // The first and the last node belong to the frame, which does not move.
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

    /// Force (N) on the tail of a spring, given the vector to its head (m) and the rate of that vector (m/s).
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

    /// Sets acceleration and velocity of a node under a force (N) of springs and facets; returns the sum of the
    /// acceleration's components.
    #[inline(always)]
    fn finish(&self, node: &mut Node<S>, force: Vec3<S>, half: S) -> S {
        let force = vec3::axpy(vec3::add(force, self.weight), -self.air_drag, node.vel);
        let acc = vec3::scale(force, node.inverse_mass);
        node.vel = vec3::axpy(node.vel, half, vec3::sub(acc, node.acc));
        node.acc = acc;
        acc[0] + acc[1] + acc[2]
    }

    /// Pressure forces on the corners of a facet (N), given its sides a -> b, a -> d, b -> c (m).
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
    /// x += h v + h^2/2 a, and the predicted v += h a.
    #[inline(always)]
    fn advance(&mut self, h: S, half: S) {
        let middle = vec3::axpy(self.vel, half, self.acc);
        self.pos = vec3::axpy(self.pos, h, middle);
        self.vel = vec3::axpy(middle, half, self.acc);
    }
}
