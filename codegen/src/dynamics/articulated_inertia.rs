//! Articulated-body inertia: the resistance of a tree to an acceleration of its innermost body, with its hinges
//! released.
//!
//! An acceleration a of the origin and an angular acceleration alpha take the force M a + H alpha + f and the moment H'
//! a + J alpha + n. A rigid body has M = m 1, H = -[h] and J = tr(S) 1 - S; releasing a hinge subtracts a matrix of
//! rank one. Featherstone 2008, chapter 7.

use super::spatial::{Inertia, Symmetric, Wrench, entry, turned_matrix, turned_symmetric};
use crate::expr::{Dag, ExprId};
use crate::model::Axis;
use crate::vector::{Components, cross_components, dot_components};

/// M, H, J, and the wrench (f, n) at the accelerations relative to which others are counted; about an origin, in one
/// triad.
#[derive(Clone, Debug)]
pub(super) struct Articulated {
    mass: Symmetric,
    /// H: `coupling[i][j]` is component i of the force that component j of the angular acceleration takes.
    coupling: [Components; 3],
    inertia: Symmetric,
    pub wrench: Wrench,
}

impl Articulated {
    /// The inertia of a rigid body, with no hinge released.
    pub(super) fn rigid(dag: &mut Dag, own: &Inertia, wrench: Wrench) -> Self {
        let (zero, m, h, s) = (dag.zero(), own.mass, own.first, own.second);
        let mut coupling = [[zero; 3]; 3];
        let mut inertia = s.map(|e| dag.negate(e));
        for i in 0..3 {
            let (j, l) = ((i + 1) % 3, (i + 2) % 3);
            // alpha x h
            coupling[i][j] = h[l];
            coupling[i][l] = dag.negate(h[j]);
            inertia[i] = dag.add(s[j], s[l]);
        }
        Self { mass: [m, m, m, zero, zero, zero], coupling, inertia, wrench }
    }

    pub(super) fn plus(&self, dag: &mut Dag, other: &Self) -> Self {
        let mut sum = |a: &Symmetric, b: &Symmetric| std::array::from_fn(|n| dag.add(a[n], b[n]));
        let (mass, inertia) = (sum(&self.mass, &other.mass), sum(&self.inertia, &other.inertia));
        let coupling = std::array::from_fn(|i| {
            std::array::from_fn(|j| dag.add(self.coupling[i][j], other.coupling[i][j]))
        });
        Self { mass, coupling, inertia, wrench: self.wrench.plus(dag, &other.wrench) }
    }

    /// The wrench that an acceleration (a, alpha) takes in addition to (f, n).
    pub(super) fn resistance(&self, dag: &mut Dag, a: &Components, alpha: &Components) -> Wrench {
        let row = |matrix: &Symmetric, i: usize| [0, 1, 2].map(|j| matrix[entry(i, j)]);
        let column = |i: usize| [0, 1, 2].map(|j| self.coupling[j][i]);
        let mut six = |left: Components, right: Components| {
            let terms: Vec<ExprId> =
                (left.iter().zip(a)).chain(right.iter().zip(alpha)).map(|(&m, &x)| dag.mul(m, x)).collect();
            dag.sum(&terms)
        };
        Wrench {
            force: std::array::from_fn(|i| six(row(&self.mass, i), self.coupling[i])),
            moment: std::array::from_fn(|i| six(column(i), row(&self.inertia, i))),
        }
    }

    /// Releases a motion s: subtracts U (U / D)', with `column` = U = I s, D = s . U, and `share` = U / D.
    pub(super) fn release(&mut self, dag: &mut Dag, column: &Wrench, share: &Wrench) {
        let mut less = |entry: &mut ExprId, a: ExprId, b: ExprId| {
            let term = dag.mul(a, b);
            *entry = dag.sub(*entry, term);
        };
        for i in 0..3 {
            for j in 0..3 {
                less(&mut self.coupling[i][j], column.force[i], share.moment[j]);
                if i <= j {
                    less(&mut self.mass[entry(i, j)], column.force[i], share.force[j]);
                    less(&mut self.inertia[entry(i, j)], column.moment[i], share.moment[j]);
                }
            }
        }
    }

    /// In the parent's axes, against which the triad is turned by `angle` about `axis`.
    pub(super) fn turned(&self, dag: &mut Dag, axis: Axis, angle: ExprId) -> Self {
        let mass = turned_symmetric(dag, axis, angle, &self.mass);
        let inertia = turned_symmetric(dag, axis, angle, &self.inertia);
        Self {
            mass,
            coupling: turned_matrix(dag, axis, angle, &self.coupling),
            inertia,
            wrench: self.wrench.turned(dag, axis, angle),
        }
    }

    /// What remains of a body behind a released ball joint: no resistance to rotation, and no moment transmitted except
    /// `moment`, that of the forces on the joint's speeds. In the parent's axes; `rows` are the body's axes in them.
    pub(super) fn held_by_force(&self, dag: &mut Dag, rows: &[Components; 3], moment: Components) -> Self {
        let zero = dag.zero();
        let turned = |dag: &mut Dag, v: &Components| -> Components {
            std::array::from_fn(|i| dot_components(dag, &[0, 1, 2].map(|j| rows[j][i]), v))
        };
        // R' M R: columns of M turned, then rows.
        let columns = [0, 1, 2].map(|j| [0, 1, 2].map(|i| self.mass[entry(i, j)]));
        let columns = columns.map(|column| turned(dag, &column));
        let mut mass = self.mass;
        for i in 0..3 {
            for j in i..3 {
                let row = [0, 1, 2].map(|n| columns[n][i]);
                mass[entry(i, j)] = dot_components(dag, &row, &[0, 1, 2].map(|n| rows[n][j]));
            }
        }
        let wrench = Wrench { force: turned(dag, &self.wrench.force), moment: turned(dag, &moment) };
        Self { mass, coupling: [[zero; 3]; 3], inertia: [zero; 6], wrench }
    }

    /// About an origin at -`offset`, relative to which the old origin moves by alpha x offset = C alpha: the new
    /// matrices are H + M C and J + H' C + C' (H + M C).
    pub(super) fn shifted(&self, dag: &mut Dag, offset: &Components) -> Self {
        // Column j of C, e_j x offset, is non-zero in the other two axes.
        let (zero, one) = (dag.zero(), dag.one());
        let columns: [Components; 3] = std::array::from_fn(|j| {
            let mut unit = [zero; 3];
            unit[j] = one;
            cross_components(dag, &unit, offset)
        });
        let coupling: [Components; 3] = std::array::from_fn(|i| {
            std::array::from_fn(|j| {
                let terms = [0, 1, 2].map(|m| dag.mul(self.mass[entry(i, m)], columns[j][m]));
                let moved = dag.sum(&terms);
                dag.add(self.coupling[i][j], moved)
            })
        });
        let mut inertia = self.inertia;
        for i in 0..3 {
            for j in i..3 {
                let terms: Vec<ExprId> = if i == j {
                    let both = [0, 1, 2].map(|m| dag.add(self.coupling[m][i], coupling[m][i]));
                    (0..3).map(|m| dag.mul(both[m], columns[i][m])).collect()
                } else {
                    let before = (0..3).map(|m| (self.coupling[m][i], columns[j][m]));
                    let after = (0..3).map(|m| (coupling[m][j], columns[i][m]));
                    before.chain(after).map(|(h, c)| dag.mul(h, c)).collect()
                };
                let sum = dag.sum(&terms);
                inertia[entry(i, j)] = dag.add(inertia[entry(i, j)], sum);
            }
        }
        Self { mass: self.mass, coupling, inertia, wrench: self.wrench.shifted(dag, offset) }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A body about whose hinge nothing is symmetric.
    fn body(dag: &mut Dag) -> Inertia {
        let numbers = [0.9, 0.8, 0.7, 0.1, -0.05, 0.2].map(|x| dag.constant(x));
        let centre = [0.3, -0.2, 0.5].map(|x| dag.constant(x));
        let mass = dag.constant(2.0);
        Inertia::of_body(dag, mass, &centre, &numbers)
    }

    fn close(dag: &Dag, a: &Wrench, b: &Wrench) {
        let numbers =
            |w: &Wrench| [w.force, w.moment].concat().into_iter().map(|e| dag.evaluate_constant(e)).collect();
        let (a, b): (Vec<f64>, Vec<f64>) = (numbers(a), numbers(b));
        assert!(a.iter().zip(&b).all(|(a, b)| (a - b).abs() < 1e-14), "{a:?} {b:?}");
    }

    #[test]
    fn a_rigid_body_resists_as_its_momentum_says() {
        let mut dag = Dag::default();
        let inertia = body(&mut dag);
        let (a, alpha) =
            ([0.4, 0.6, -0.3].map(|x| dag.constant(x)), [1.1, -0.7, 0.9].map(|x| dag.constant(x)));
        let nothing = Wrench::zero(&mut dag);
        let found = Articulated::rigid(&mut dag, &inertia, nothing).resistance(&mut dag, &a, &alpha);
        let expected = inertia.momentum(&mut dag, &a, &alpha);
        close(&dag, &found, &expected);
    }

    #[test]
    fn a_turn_and_a_shift_move_it_as_a_rigid_body() {
        for axis in [Axis::X, Axis::Y, Axis::Z] {
            let mut dag = Dag::default();
            let inertia = body(&mut dag);
            let (angle, offset) = (dag.constant(0.7), [0.1, 0.4, -0.6].map(|x| dag.constant(x)));
            let (a, alpha) =
                ([0.4, 0.6, -0.3].map(|x| dag.constant(x)), [1.1, -0.7, 0.9].map(|x| dag.constant(x)));
            let nothing = Wrench::zero(&mut dag);
            let moved = Articulated::rigid(&mut dag, &inertia, nothing).turned(&mut dag, axis, angle);
            let moved = moved.shifted(&mut dag, &offset).resistance(&mut dag, &a, &alpha);
            let expected = inertia.turned(&mut dag, axis, angle).shifted(&mut dag, &offset);
            let expected = expected.momentum(&mut dag, &a, &alpha);
            close(&dag, &moved, &expected);
        }
    }

    #[test]
    fn a_free_hinge_takes_no_moment() {
        let mut dag = Dag::default();
        let inertia = body(&mut dag);
        let nothing = Wrench::zero(&mut dag);
        let mut body = Articulated::rigid(&mut dag, &inertia, nothing);
        let zero = [dag.zero(); 3];
        let axis = [dag.zero(), dag.one(), dag.zero()];
        let column = body.resistance(&mut dag, &zero, &axis);
        let pivot = column.moment[1];
        let share = column.map(|e| dag.div(e, pivot));
        body.release(&mut dag, &column, &share);
        let (a, alpha) =
            ([0.4, 0.6, -0.3].map(|x| dag.constant(x)), [1.1, -0.7, 0.9].map(|x| dag.constant(x)));
        let found = body.resistance(&mut dag, &a, &alpha);
        assert!(dag.evaluate_constant(found.moment[1]).abs() < 1e-15);
        let found = body.resistance(&mut dag, &zero, &axis);
        let nothing = Wrench::zero(&mut dag);
        close(&dag, &found, &nothing);
    }
}
