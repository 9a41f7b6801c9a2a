//! The terms that a sheet has by itself, whatever lies on it: springs, air, plate, cover and inertia; in any scalar.
//!
//! In: a tile and, in motion, a stage of time. Out: energy, gradient and Hessian with respect to the positions of its
//! nodes.

use super::bed::{Bed, PLATE, Tile};
use super::stiffness::Stiffness;
use super::swing::Swing;
use crate::band::Band;
use crate::sheet::air::{Air, Collapsed};
use crate::sheet::{Lattice, membrane};
use smartbed_runtime::real::Scalar;
use smartbed_runtime::vec3::{Vec3, add, scale};

/// A sheet with its own terms.
#[derive(Clone, Copy)]
pub struct Lone<'a, T = f64> {
    pub lattice: &'a Lattice<T>,
    pub swing: Option<&'a Swing<T>>,
    air: Air,
    /// From the rim down to the base (m).
    depth: T,
    /// Weight on a free node, in the tile's frame (N).
    borne: Vec3<T>,
}

impl<'a, T: Scalar> Lone<'a, T> {
    pub fn new(bed: &Bed, tile: &Tile, lattice: &'a Lattice<T>, swing: Option<&'a Swing<T>>) -> Lone<'a, T> {
        let borne = tile.pose.attitude.to_body([0.0, 0.0, bed.borne()]).map(T::from_f64);
        Lone { lattice, swing, air: tile.air, depth: T::from_f64(bed.depth), borne }
    }

    /// Air's volume (m^3).
    fn volume(&self, sheet: &[Vec3<T>]) -> f64 {
        let [a, b] = self.lattice.size;
        a * b * self.depth.to_f64() + membrane::volume(self.lattice, sheet).to_f64()
    }

    /// Bound of the residual force (N) that rounding of the positions causes.
    pub fn rounding(&self) -> T {
        let [a, b] = self.lattice.size;
        let stiffness = self.lattice.springs.iter().map(|s| s.stiffness);
        let most = stiffness.fold(T::ZERO, |most, k| if k > most { k } else { most });
        let damped = self.swing.map_or(T::ZERO, |swing| swing.damping);
        T::from_f64(8.0 * a.max(b)) * T::EPSILON * most * (T::ONE + damped)
    }

    /// Depth of a node in the plate (m).
    pub fn below(&self, x: &Vec3<T>) -> T {
        let below = -self.depth - x[2];
        if below > T::ZERO { below } else { T::ZERO }
    }

    /// Stiffness of a node's share of the plate (N/m).
    fn plate(&self) -> T {
        T::from_f64(PLATE * self.lattice.cell())
    }

    /// Gradients of the energy and of the volume, by node.
    pub fn gradients(&self, sheet: &[Vec3<T>]) -> Result<[Vec<Vec3<T>>; 2], Collapsed> {
        let pressure = T::from_f64(self.air.gauge(self.volume(sheet))?);
        let (mut force, mut volume) = (vec![[T::ZERO; 3]; sheet.len()], vec![[T::ZERO; 3]; sheet.len()]);
        membrane::add_volume_gradient(self.lattice, sheet, T::ONE, &mut volume);
        membrane::add_gradient(self.lattice, sheet, &mut force);
        if let Some(swing) = self.swing {
            swing.add_gradient(self.lattice, sheet, &mut force);
        }
        for ((f, v), x) in force.iter_mut().zip(&volume).zip(sheet) {
            *f = add(add(*f, scale(*v, -pressure)), self.borne);
            f[2] = f[2] - self.plate() * self.below(x);
        }
        Ok([force, volume])
    }

    /// The entries of the free nodes, as a flat vector.
    pub fn of_free(&self, rows: &[Vec3<T>]) -> Vec<T> {
        let free = rows.iter().enumerate().filter(|(node, _)| self.lattice.free(*node).is_some());
        free.flat_map(|(_, v)| *v).collect()
    }

    /// Hessian of the free nodes, without the contribution of a sealed gas.
    pub fn hessian(&self, sheet: &[Vec3<T>], is_exact: bool) -> Result<Band<T>, Collapsed> {
        let lattice = self.lattice;
        let pressure = T::from_f64(self.air.gauge(self.volume(sheet))?);
        let mut band = Band::new(3 * lattice.free_nodes(), lattice.width());
        membrane::add_hessian(lattice, sheet, is_exact, &mut band);
        membrane::add_volume_hessian(lattice, sheet, -pressure, &mut band);
        if let Some(swing) = self.swing {
            swing.add_hessian(lattice, &mut band);
        }
        for (node, x) in sheet.iter().enumerate() {
            let Some(free) = lattice.free(node) else { continue };
            if self.below(x) > T::ZERO {
                band.add(3 * free + 2, 3 * free + 2, self.plate());
            }
        }
        Ok(band)
    }

    /// Factors a Hessian and adds the gas, by the volume's gradient with respect to the free nodes.
    pub fn factored(
        &self,
        sheet: &[Vec3<T>],
        band: &Band<T>,
        by_nodes: Vec<T>,
    ) -> Result<Stiffness<T>, Collapsed> {
        let volume = self.volume(sheet);
        // A slack sheet has no transverse stiffness: shifts the diagonal until the band is positive definite.
        let mut shift = 0.0;
        while shift < 1e12 {
            let mut shifted = band.clone();
            shifted.shift(T::from_f64(shift));
            if let Some(factor) = shifted.factor() {
                return Ok(Stiffness::new(factor, by_nodes, T::from_f64(self.air.stiffness(volume)?)));
            }
            shift = if shift == 0.0 { 1.0 } else { 4.0 * shift };
        }
        Err(Collapsed(volume))
    }
}
