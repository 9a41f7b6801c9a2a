//! Inertias (by their moments) and wrenches, the quantities that are passed along a tree of bodies.
//!
//! An [`Inertia`] about an origin is the mass m, the first moment h = int r dm and the second moment S = int r r' dm.
//! Moments are added, turned and shifted with fewer operations than the inertia matrix J = tr(S) 1 - S: no trace, and a
//! shift by p adds p h' + h p' + m p p'.

use crate::expr::{Dag, ExprId};
use crate::model::Axis;
use crate::vector::{Components, cross_components, dot_components, turn_components};

/// A symmetric 3 x 3 matrix: xx, yy, zz, yz, zx, xy, the order of a body's moments in the model too.
pub(super) type Symmetric = [ExprId; 6];

/// Index of entry (i, j) of a [`Symmetric`].
pub(super) const fn entry(i: usize, j: usize) -> usize {
    // Off the diagonal, the entry (i, j) is stored at 3 + l, where l = 3 - i - j is the third axis.
    if i == j { i } else { 6 - i - j }
}

/// Mass (kg), first moment (kg m) and second moment (kg m^2) about an origin, in one triad.
#[derive(Clone, PartialEq, Debug)]
pub(super) struct Inertia {
    pub mass: ExprId,
    pub first: Components,
    pub second: Symmetric,
}

/// Force (N) and moment about an origin (N m) in one triad; or momentum and its moment.
#[derive(Clone, PartialEq, Debug)]
pub(super) struct Wrench {
    pub force: Components,
    pub moment: Components,
}

/// Acceleration of a rigid body: that of the origin (less gravity), and U = [alpha] + [w][w], so that the point at r
/// has the acceleration a + U r.
#[derive(Clone, Debug)]
pub(super) struct Acceleration {
    pub origin: Components,
    pub gradient: [Components; 3],
}

impl Acceleration {
    /// Acceleration of the point at `r`: a + U r.
    pub(super) fn at(&self, dag: &mut Dag, r: &Components) -> Components {
        std::array::from_fn(|i| {
            let turning = dot_components(dag, &self.gradient[i], r);
            dag.add(self.origin[i], turning)
        })
    }
}

/// U = [alpha] + [w][w].
pub(super) fn gradient(dag: &mut Dag, w: &Components, alpha: &Components) -> [Components; 3] {
    let square = w.map(|c| dag.mul(c, c));
    std::array::from_fn(|i| {
        std::array::from_fn(|j| {
            if i == j {
                let sum = dag.add(square[(i + 1) % 3], square[(i + 2) % 3]);
                return dag.negate(sum);
            }
            let (l, product) = (3 - i - j, dag.mul(w[i], w[j]));
            // [alpha]_ij is -alpha_l for (i, j, l) in cyclic order, else +alpha_l.
            if (i + 1) % 3 == j { dag.sub(product, alpha[l]) } else { dag.add(product, alpha[l]) }
        })
    })
}

impl Inertia {
    pub(super) fn zero(dag: &mut Dag) -> Self {
        let zero = dag.zero();
        Self { mass: zero, first: [zero; 3], second: [zero; 6] }
    }

    /// The inertia of a body with its mass centre at `centre` and the inertia matrix `matrix` about it.
    pub(super) fn of_body(dag: &mut Dag, mass: ExprId, centre: &Components, matrix: &Symmetric) -> Self {
        let [xx, yy, zz, yz, zx, xy] = *matrix;
        let half = dag.number(crate::expr::number::Number::rational(1, 2));
        let mut central = |a: ExprId, b: ExprId, c: ExprId| {
            let sum = dag.add(a, b);
            let difference = dag.sub(sum, c);
            dag.mul(half, difference)
        };
        let diagonal = [central(yy, zz, xx), central(zz, xx, yy), central(xx, yy, zz)];
        let products = [yz, zx, xy].map(|e| dag.negate(e));
        let [a, b, c] = diagonal;
        let [d, e, f] = products;
        let at_centre = Self { mass, first: [dag.zero(); 3], second: [a, b, c, d, e, f] };
        at_centre.shifted(dag, centre)
    }

    pub(super) fn is_zero(&self, dag: &Dag) -> bool {
        [self.mass].iter().chain(&self.first).chain(&self.second).all(|&e| dag.is_zero(e))
    }

    pub(super) fn plus(&self, dag: &mut Dag, other: &Self) -> Self {
        Self {
            mass: dag.add(self.mass, other.mass),
            first: std::array::from_fn(|i| dag.add(self.first[i], other.first[i])),
            second: std::array::from_fn(|i| dag.add(self.second[i], other.second[i])),
        }
    }

    /// About an origin at -`offset` in the same triad.
    pub(super) fn shifted(&self, dag: &mut Dag, offset: &Components) -> Self {
        let at_offset = offset.map(|c| dag.mul(self.mass, c));
        let mut second = self.second;
        for i in 0..3 {
            for j in i..3 {
                // p_i h_j + h_i p_j + m p_i p_j = p_i (h_j + m p_j) + h_i p_j
                let outer = dag.add(self.first[j], at_offset[j]);
                let first = dag.mul(offset[i], outer);
                let second_term = dag.mul(self.first[i], offset[j]);
                let sum = dag.add(first, second_term);
                second[entry(i, j)] = dag.add(second[entry(i, j)], sum);
            }
        }
        let first = std::array::from_fn(|i| dag.add(self.first[i], at_offset[i]));
        Self { mass: self.mass, first, second }
    }

    /// In the parent's axes, against which the triad is turned by `angle` about `axis`.
    pub(super) fn turned(&self, dag: &mut Dag, axis: Axis, angle: ExprId) -> Self {
        let second = turned_symmetric(dag, axis, angle, &self.second);
        let first = turn_components(dag, axis, angle, self.first, false);
        Self { mass: self.mass, first, second }
    }

    /// Splits into the part that a rotation about `axis` does not change, and the rest: the mass and the moments along
    /// the axis can be counted with the body inside (base parameters).
    pub(super) fn split(&self, dag: &mut Dag, axis: Axis) -> (Self, Self) {
        let a = axis as usize;
        let (mut inner, mut outer) = (Self::zero(dag), self.clone());
        inner.mass = std::mem::replace(&mut outer.mass, dag.zero());
        inner.first[a] = std::mem::replace(&mut outer.first[a], dag.zero());
        inner.second[a] = std::mem::replace(&mut outer.second[a], dag.zero());
        (inner, outer)
    }

    /// Is the whole inertia unchanged by a rotation about `axis`?
    pub(super) fn is_axisymmetric(&self, dag: &Dag, axis: Axis) -> bool {
        let a = axis as usize;
        let (i, j) = ((a + 1) % 3, (a + 2) % 3);
        let none = [self.first[i], self.first[j]].into_iter().chain(self.second[3..].iter().copied());
        self.second[i] == self.second[j] && none.into_iter().all(|e| dag.is_zero(e))
    }

    /// Moment of inertia about the axis, J_aa = S_ii + S_jj.
    pub(super) fn about(&self, dag: &mut Dag, axis: Axis) -> ExprId {
        let a = axis as usize;
        dag.add(self.second[(a + 1) % 3], self.second[(a + 2) % 3])
    }

    /// Momentum m v + w x h and its moment h x v + J w.
    pub(super) fn momentum(&self, dag: &mut Dag, v: &Components, w: &Components) -> Wrench {
        let swept = cross_components(dag, w, &self.first);
        let force = std::array::from_fn(|i| {
            let straight = dag.mul(self.mass, v[i]);
            dag.add(straight, swept[i])
        });
        let lever = cross_components(dag, &self.first, v);
        let moment = std::array::from_fn(|i| {
            let (j, l) = ((i + 1) % 3, (i + 2) % 3);
            let diagonal = dag.add(self.second[j], self.second[l]);
            let own = dag.mul(diagonal, w[i]);
            let other = [(j, w[j]), (l, w[l])].map(|(n, w)| dag.mul(self.second[entry(i, n)], w));
            let coupled = dag.add(other[0], other[1]);
            let turning = dag.sub(own, coupled);
            dag.add(turning, lever[i])
        });
        Wrench { force, moment }
    }

    /// Wrench that the acceleration takes: force m a + U h, moment h x a + (axial part of U S).
    pub(super) fn resistance(&self, dag: &mut Dag, acceleration: &Acceleration) -> Wrench {
        let (a, u) = (&acceleration.origin, &acceleration.gradient);
        let force = std::array::from_fn(|i| {
            let straight = dag.mul(self.mass, a[i]);
            let turning = dot_components(dag, &u[i], &self.first);
            dag.add(straight, turning)
        });
        let lever = cross_components(dag, &self.first, a);
        let moment = std::array::from_fn(|i| {
            let (j, l) = ((i + 1) % 3, (i + 2) % 3);
            // sum_n U_ln S_nj - U_jn S_nl
            let column = |n: usize| [0, 1, 2].map(|m| self.second[entry(m, n)]);
            let plus = dot_components(dag, &u[l], &column(j));
            let minus = dot_components(dag, &u[j], &column(l));
            let axial = dag.sub(plus, minus);
            dag.add(axial, lever[i])
        });
        Wrench { force, moment }
    }
}

impl Wrench {
    pub(super) fn zero(dag: &mut Dag) -> Self {
        Self { force: [dag.zero(); 3], moment: [dag.zero(); 3] }
    }

    /// Applies `f` to every component.
    pub(super) fn map(&self, mut f: impl FnMut(ExprId) -> ExprId) -> Self {
        Self { force: self.force.map(&mut f), moment: self.moment.map(&mut f) }
    }

    pub(super) fn plus(&self, dag: &mut Dag, other: &Self) -> Self {
        Self {
            force: std::array::from_fn(|i| dag.add(self.force[i], other.force[i])),
            moment: std::array::from_fn(|i| dag.add(self.moment[i], other.moment[i])),
        }
    }

    /// In the parent's axes, against which the triad is turned by `angle` about `axis`.
    pub(super) fn turned(&self, dag: &mut Dag, axis: Axis, angle: ExprId) -> Self {
        Self {
            force: turn_components(dag, axis, angle, self.force, false),
            moment: turn_components(dag, axis, angle, self.moment, false),
        }
    }

    /// About an origin at -`offset`.
    pub(super) fn shifted(&self, dag: &mut Dag, offset: &Components) -> Self {
        let lever = cross_components(dag, offset, &self.force);
        let moment = std::array::from_fn(|i| dag.add(self.moment[i], lever[i]));
        Self { force: self.force, moment }
    }
}

/// R S R' in sixteen operations: sub-expressions common to both sides of the diagonal are formed once.
pub(super) fn turned_symmetric(dag: &mut Dag, axis: Axis, angle: ExprId, s: &Symmetric) -> Symmetric {
    let full = [0, 1, 2].map(|i| [0, 1, 2].map(|j| s[entry(i, j)]));
    let [x, y, z] = turned_matrix(dag, axis, angle, &full);
    [x[0], y[1], z[2], y[2], z[0], x[1]]
}

/// R A R' by products of single sines and cosines: with r = A_ij + A_ji and x = s (A_ii - A_jj) + c r the turned block
/// is A_ii - s x, c x - A_ji, c x - A_ij and A_jj + s x.
pub(super) fn turned_matrix(
    dag: &mut Dag,
    axis: Axis,
    angle: ExprId,
    a: &[Components; 3],
) -> [Components; 3] {
    let l = axis as usize;
    let (i, j) = ((l + 1) % 3, (l + 2) % 3);
    let (sin, cos) = (dag.sin(angle), dag.cos(angle));
    let mut turned = *a;
    let difference = dag.sub(a[i][i], a[j][j]);
    let along = dag.mul(sin, difference);
    let both = dag.add(a[i][j], a[j][i]);
    let across = dag.mul(cos, both);
    let x = dag.add(along, across);
    let (sx, cx) = (dag.mul(sin, x), dag.mul(cos, x));
    turned[i][i] = dag.sub(a[i][i], sx);
    turned[j][j] = dag.add(a[j][j], sx);
    turned[i][j] = dag.sub(cx, a[j][i]);
    turned[j][i] = dag.sub(cx, a[i][j]);
    turned[l] = turn_components(dag, axis, angle, a[l], false);
    let column = turn_components(dag, axis, angle, [0, 1, 2].map(|m| a[m][l]), false);
    turned[i][l] = column[i];
    turned[j][l] = column[j];
    turned
}

#[cfg(test)]
mod tests {
    use super::*;

    const MASS: f64 = 2.0;
    const CENTRE: [f64; 3] = [0.3, -0.2, 0.5];
    /// About the mass centre: xx, yy, zz, yz, zx, xy.
    const MATRIX: [f64; 6] = [0.9, 0.8, 0.7, 0.2, -0.05, 0.1];

    fn constants<const N: usize>(dag: &mut Dag, values: [f64; N]) -> [ExprId; N] {
        values.map(|x| dag.constant(x))
    }

    fn body(dag: &mut Dag) -> Inertia {
        let (mass, centre, matrix) = (dag.constant(MASS), constants(dag, CENTRE), constants(dag, MATRIX));
        Inertia::of_body(dag, mass, &centre, &matrix)
    }

    fn cross(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
        std::array::from_fn(|i| a[(i + 1) % 3] * b[(i + 2) % 3] - a[(i + 2) % 3] * b[(i + 1) % 3])
    }

    fn times(w: [f64; 3]) -> [f64; 3] {
        let [xx, yy, zz, yz, zx, xy] = MATRIX;
        [[xx, xy, zx], [xy, yy, yz], [zx, yz, zz]].map(|row| row.iter().zip(w).map(|(a, b)| a * b).sum())
    }

    fn plus(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
        std::array::from_fn(|i| a[i] + b[i])
    }

    fn assert_close(dag: &Dag, found: Components, expected: [f64; 3]) {
        for (found, expected) in found.map(|e| dag.evaluate_constant(e)).into_iter().zip(expected) {
            assert!((found - expected).abs() < 1e-14, "{found} against {expected}");
        }
    }

    #[test]
    fn momentum_is_that_of_the_mass_centre_and_about_it() {
        let mut dag = Dag::default();
        let (v, w) = ([0.4, 0.6, -0.3], [1.1, -0.7, 0.9]);
        let at_centre = plus(v, cross(w, CENTRE)).map(|x| MASS * x);
        let about_origin = plus(times(w), cross(CENTRE, at_centre));
        let inertia = body(&mut dag);
        let (v, w) = (constants(&mut dag, v), constants(&mut dag, w));
        let momentum = inertia.momentum(&mut dag, &v, &w);
        assert_close(&dag, momentum.force, at_centre);
        assert_close(&dag, momentum.moment, about_origin);
    }

    #[test]
    fn resistance_is_newtons_and_eulers() {
        let mut dag = Dag::default();
        let (a, w, alpha) = ([0.4, 0.6, -9.3], [1.1, -0.7, 0.9], [-0.2, 0.8, 0.5]);
        let centre = plus(a, plus(cross(alpha, CENTRE), cross(w, cross(w, CENTRE))));
        let force = centre.map(|x| MASS * x);
        let moment = plus(plus(times(alpha), cross(w, times(w))), cross(CENTRE, force));
        let inertia = body(&mut dag);
        let [origin, w, alpha] = [a, w, alpha].map(|v| constants(&mut dag, v));
        let gradient = gradient(&mut dag, &w, &alpha);
        let found = inertia.resistance(&mut dag, &Acceleration { origin, gradient });
        assert_close(&dag, found.force, force);
        assert_close(&dag, found.moment, moment);
    }

    #[test]
    fn momentum_may_be_formed_before_or_after_a_turn_and_a_shift() {
        for axis in [Axis::X, Axis::Y, Axis::Z] {
            let mut dag = Dag::default();
            let inertia = body(&mut dag);
            let (angle, offset) = (dag.constant(0.7), constants(&mut dag, [0.1, 0.4, -0.6]));
            let w = constants(&mut dag, [1.1, -0.7, 0.9]);
            let zero = [dag.zero(); 3];
            // The node turns about its own origin, which the parent's w moves at w x offset.
            let outside = turn_components(&mut dag, axis, angle, w, true);
            let moved = cross_components(&mut dag, &w, &offset);
            let moved = turn_components(&mut dag, axis, angle, moved, true);
            let momentum = inertia.momentum(&mut dag, &moved, &outside);
            let before = momentum.turned(&mut dag, axis, angle).shifted(&mut dag, &offset);
            let inertia = inertia.turned(&mut dag, axis, angle).shifted(&mut dag, &offset);
            let after = inertia.momentum(&mut dag, &zero, &w);
            assert_close(&dag, before.force, after.force.map(|e| dag.evaluate_constant(e)));
            assert_close(&dag, before.moment, after.moment.map(|e| dag.evaluate_constant(e)));
        }
    }

    #[test]
    fn what_is_moved_inwards_feels_no_turn() {
        for axis in [Axis::X, Axis::Y, Axis::Z] {
            let mut dag = Dag::default();
            let (inner, outer) = body(&mut dag).split(&mut dag, axis);
            let angle = dag.symbol("angle");
            assert_eq!(inner.turned(&mut dag, axis, angle), inner);
            assert_ne!(outer.turned(&mut dag, axis, angle), outer);
            let mut wheel = Inertia::zero(&mut dag);
            wheel.second = [dag.one(); 6];
            assert!(!wheel.is_axisymmetric(&dag, axis));
            wheel.second[3..].fill(dag.zero());
            assert!(wheel.is_axisymmetric(&dag, axis));
            assert_eq!(wheel.turned(&mut dag, axis, angle), wheel);
        }
    }
}
