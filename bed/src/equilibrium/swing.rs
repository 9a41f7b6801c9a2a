//! The terms that a stage of time adds to the energy of one sheet: inertia, and dampers parallel to its springs; in any
//! scalar.
//!
//! In: predicted positions of the nodes at the end of the stage. Out: terms of energy, gradient and Hessian. Inertia
//! gives m b^2/2 |p - p^|^2; a damper with retardation time c beside stiffness k gives c b k/2 (length minus its length
//! at p~)^2.

use crate::band::Band;
use crate::sheet::{Lattice, Spring};
use smartbed_runtime::real::Scalar;
use smartbed_runtime::vec3::{Vec3, add_at, dot, norm, scale, sub};

/// The terms of a stage for one sheet.
#[derive(Clone, Debug)]
pub struct Swing<T = f64> {
    /// m b^2 of a free node (N/m).
    pub inertia: T,
    /// c b, the ratio of a damper's term to its spring's stiffness.
    pub damping: T,
    /// p^ of nodes, in the tile's frame at the end of the stage.
    pub nodes: Vec<Vec3<T>>,
    /// One damper per spring.
    pub dampers: Vec<Damper<T>>,
}

/// A damper parallel to a spring.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Damper<T = f64> {
    /// Direction of the spring at the predicted positions.
    pub direction: Vec3<T>,
    /// Distance of its ends at p~ along that direction (m).
    pub apart: T,
}

impl Swing {
    /// The same in another scalar.
    #[must_use]
    pub fn rounded<T: Scalar>(&self) -> Swing<T> {
        let damper =
            |d: &Damper| Damper { direction: d.direction.map(T::from_f64), apart: T::from_f64(d.apart) };
        Swing {
            inertia: T::from_f64(self.inertia),
            damping: T::from_f64(self.damping),
            nodes: self.nodes.iter().map(|x| x.map(T::from_f64)).collect(),
            dampers: self.dampers.iter().map(damper).collect(),
        }
    }
}

impl<T: Scalar> Swing<T> {
    /// Energy terms of inertia and dampers.
    pub(super) fn energy(&self, lattice: &Lattice<T>, sheet: &[Vec3<T>]) -> T {
        let half = T::from_f64(0.5);
        let mut energy = T::ZERO;
        for (node, (x, hat)) in sheet.iter().zip(&self.nodes).enumerate() {
            let off = sub(*x, *hat);
            if lattice.free(node).is_some() {
                energy = energy + half * self.inertia * dot(off, off);
            }
        }
        for (spring, damper) in self.damped(lattice) {
            let stretch = damper.stretch(sheet, spring.ends);
            energy = energy + half * self.damping * spring.stiffness * stretch * stretch;
        }
        energy
    }

    /// Adds the gradient of that energy.
    pub(super) fn add_gradient(&self, lattice: &Lattice<T>, sheet: &[Vec3<T>], gradient: &mut [Vec3<T>]) {
        for (node, (x, hat)) in sheet.iter().zip(&self.nodes).enumerate() {
            add_at(gradient, node, scale(sub(*x, *hat), self.inertia));
        }
        for (spring, damper) in self.damped(lattice) {
            let size = self.damping * spring.stiffness * damper.stretch(sheet, spring.ends);
            let pull = scale(damper.direction, size);
            add_at(gradient, spring.ends[1], pull);
            add_at(gradient, spring.ends[0], scale(pull, -T::ONE));
        }
    }

    /// Adds the Hessian of that energy.
    pub(super) fn add_hessian(&self, lattice: &Lattice<T>, band: &mut Band<T>) {
        band.shift(self.inertia);
        for (spring, damper) in self.damped(lattice) {
            let d = damper.direction;
            let block = d.map(|x| scale(d, self.damping * spring.stiffness * x));
            let [tail, head] = spring.ends.map(|end| lattice.free(end));
            for end in [tail, head].into_iter().flatten() {
                band.add_block(end, end, &block);
            }
            if let (Some(tail), Some(head)) = (tail, head) {
                band.add_block(tail, head, &block.map(|row| row.map(|x| -x)));
            }
        }
    }

    fn damped<'a>(&'a self, lattice: &'a Lattice<T>) -> impl Iterator<Item = (&'a Spring<T>, &'a Damper<T>)> {
        lattice.springs.iter().zip(&self.dampers)
    }
}

impl Damper {
    /// A damper between two ends with these predicted positions and these p~.
    #[must_use]
    pub fn new(expected: [Vec3<f64>; 2], resting: [Vec3<f64>; 2]) -> Damper {
        let along = sub(expected[1], expected[0]);
        let direction = scale(along, 1.0 / norm(along).max(f64::MIN_POSITIVE));
        Damper { direction, apart: dot(direction, sub(resting[1], resting[0])) }
    }
}

impl<T: Scalar> Damper<T> {
    /// Length along the direction minus that at p~ (m).
    #[must_use]
    pub fn stretch(&self, sheet: &[Vec3<T>], ends: [usize; 2]) -> T {
        dot(self.direction, sub(sheet[ends[1]], sheet[ends[0]])) - self.apart
    }
}
