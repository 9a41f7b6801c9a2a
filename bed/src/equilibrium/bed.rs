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
    /// That of sheets on sheets of neighbours.
    pub rubbing: f64,
    /// Neighbours whose sheets may touch.
    pub beside: Vec<[usize; 2]>,
    /// What is mounted on the sheets.
    pub cover: Cover,
}

/// What is mounted on sheets: it weighs on them, and stands between them and tissue.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Cover {
    /// Mass over area (kg/m^2).
    pub density: f64,
    /// m.
    pub thickness: f64,
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

    /// Weight of what a free node bears (N).
    #[must_use]
    pub fn borne(&self) -> f64 {
        self.cover.density * self.lattice.cell() * GRAVITY
    }

    /// Energy (J) of the weight that a tile's sheet bears.
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
