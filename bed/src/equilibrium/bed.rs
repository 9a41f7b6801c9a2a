//! The bed: tiles with their bladders.

use crate::body::Body;
use crate::pose::Pose;
use crate::sheet::Lattice;
use crate::sheet::air::Air;
use smartbed_runtime::vec3::Vec3;

/// Gravity (m/s^2).
pub const GRAVITY: f64 = 9.81;
/// Pressure per depth (Pa/m) of the plate under a bladder.
pub(super) const PLATE: f64 = 1e7;
/// Ratio of the tissue's tangential to normal stiffness: G/E of an incompressible layer.
pub(super) const ALONG: f64 = 1.0 / 3.0;

/// A tile at one time.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Tile {
    /// Pose in the bed of the plane of the rim, at its centre.
    pub pose: Pose,
    /// Air in its bladder.
    pub air: Air,
}

/// Tiles with identical bladders.
#[derive(Clone, Debug, PartialEq)]
pub struct Bed {
    /// The grid of springs of each sheet.
    pub lattice: Lattice,
    /// From the rim down to the base (m).
    pub depth: f64,
    /// Tiles.
    pub tiles: Vec<Tile>,
    /// Coulomb's friction coefficient of tissue on sheets.
    pub friction: f64,
    /// Friction coefficient of sheets on neighbouring sheets.
    pub rubbing: f64,
    /// Pairs of neighbours whose sheets may touch.
    pub beside: Vec<[usize; 2]>,
    /// What is mounted on the sheets.
    pub cover: Cover,
}

/// A layer mounted on the sheets: it has weight and separates them from tissue.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Cover {
    /// Mass per area (kg/m^2).
    pub density: f64,
    /// Thickness (m).
    pub thickness: f64,
}

impl Bed {
    /// Volume of the air (m^3) under a sheet.
    #[must_use]
    pub fn volume(&self, sheet: &[Vec3<f64>]) -> f64 {
        let [a, b] = self.lattice.size;
        a * b * self.depth + crate::sheet::membrane::volume(&self.lattice, sheet)
    }

    /// Energy (J) of a sheet's contact with the plate below it.
    #[must_use]
    pub fn plate_energy(&self, sheet: &[Vec3<f64>]) -> f64 {
        let below = |x: &Vec3<f64>| (-self.depth - x[2]).max(0.0);
        0.5 * PLATE * self.lattice.cell() * sheet.iter().map(|x| below(x).powi(2)).sum::<f64>()
    }

    /// Weight of the cover on a free node (N).
    #[must_use]
    pub fn borne(&self) -> f64 {
        self.cover.density * self.lattice.cell() * GRAVITY
    }

    /// Potential energy (J) of the cover on a tile's sheet.
    #[must_use]
    pub fn cover_energy(&self, tile: &Tile, sheet: &[Vec3<f64>]) -> f64 {
        if self.cover.density == 0.0 {
            return 0.0;
        }
        let free = sheet.iter().enumerate().filter(|(node, _)| self.lattice.free(*node).is_some());
        self.borne() * free.map(|(_, x)| tile.pose.outwards(*x)[2]).sum::<f64>()
    }

    /// Weight of a body (N).
    #[must_use]
    pub fn weight(body: &Body) -> f64 {
        body.mass() * GRAVITY
    }
}
