//! What a stage of time adds to the energy of one sheet: inertia and dampers beside its springs, in any scalar.
//!
//! In: where nodes are expected at the end of the stage. Out: terms of energy, gradient and Hessian. Inertia is
//! m b^2/2 |p - p^|^2; a damper of retardation times stiffness k is c b k/2 (what the spring is longer than p~ has it)^2.

use crate::band::Band;
use crate::sheet::{Lattice, Spring};
use smartbed_runtime::real::Scalar;
use smartbed_runtime::vec3::{Vec3, add_at, dot, norm, scale, sub};

/// A sheet's stage.
#[derive(Clone, Debug)]
pub struct Swing<T = f64> {
    /// m b^2 of a free node (N/m).
    pub inertia: T,
    /// c b: a damper's stiffness over its spring's.
    pub damping: T,
    /// p^ of nodes, in the tile's frame at the end of the stage.
    pub nodes: Vec<Vec3<T>>,
    /// Of each spring.
    pub dampers: Vec<Damper<T>>,
}

/// Beside a spring.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Damper<T = f64> {
    /// Direction, from where the nodes are expected.
    pub direction: Vec3<T>,
    /// Along it, between p~ of the ends (m).
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
    /// Energy of inertia and dampers.
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

    /// Adds that energy's gradient.
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

    /// Adds its Hessian.
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
    /// Between two ends whose p~ and expected places are known.
    #[must_use]
    pub fn new(expected: [Vec3<f64>; 2], resting: [Vec3<f64>; 2]) -> Damper {
        let along = sub(expected[1], expected[0]);
        let direction = scale(along, 1.0 / norm(along).max(f64::MIN_POSITIVE));
        Damper { direction, apart: dot(direction, sub(resting[1], resting[0])) }
    }
}

impl<T: Scalar> Damper<T> {
    /// How much longer than p~ have it (m).
    #[must_use]
    pub fn stretch(&self, sheet: &[Vec3<T>], ends: [usize; 2]) -> T {
        dot(self.direction, sub(sheet[ends[1]], sheet[ends[0]])) - self.apart
    }
}
