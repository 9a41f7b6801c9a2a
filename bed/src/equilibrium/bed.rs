//! Tiles with the bladders they bear.

use crate::body::Body;
use crate::pose::Pose;
use crate::sheet::Lattice;
use crate::sheet::air::Air;
use smartbed_runtime::vec3::Vec3;

/// Gravity (m/s^2).
pub const GRAVITY: f64 = 9.81;
/// Pressure per depth (Pa/m) of the plate under a bladder.
pub(super) const PLATE: f64 = 1e7;
/// Stiffness of tissue along the surface over that across it: G/E of an incompressible layer.
pub(super) const ALONG: f64 = 1.0 / 3.0;

/// A tile as it stands.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Tile {
    /// The rim's plane: its middle and attitude in the bed.
    pub pose: Pose,
    /// Air in its bladder.
    pub air: Air,
}

/// Tiles that bear the same bladders.
#[derive(Clone, Debug, PartialEq)]
pub struct Bed {
    /// The sheets.
    pub lattice: Lattice,
    /// From the rim down to the base (m).
    pub depth: f64,
    /// Tiles.
    pub tiles: Vec<Tile>,
    /// Coulomb's coefficient of tissue on sheets.
    pub friction: f64,
    /// Neighbours whose sheets may touch.
    pub beside: Vec<[usize; 2]>,
}

impl Bed {
    /// Air's volume (m^3) under a sheet.
    #[must_use]
    pub fn volume(&self, sheet: &[Vec3<f64>]) -> f64 {
        let [a, b] = self.lattice.size;
        a * b * self.depth + crate::sheet::membrane::volume(&self.lattice, sheet)
    }

    /// Energy (J) of what a sheet presses on its plate.
    #[must_use]
    pub fn plate_energy(&self, sheet: &[Vec3<f64>]) -> f64 {
        let below = |x: &Vec3<f64>| (-self.depth - x[2]).max(0.0);
        0.5 * PLATE * self.lattice.cell() * sheet.iter().map(|x| below(x).powi(2)).sum::<f64>()
    }

    /// Weight of a body (N).
    #[must_use]
    pub fn weight(body: &Body) -> f64 {
        body.mass() * GRAVITY
    }
}
