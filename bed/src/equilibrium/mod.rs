//! The quasi-static bed: where air, sheets and bodies rest after each command, contact with friction kept.
//!
//! In: a [`Bed`] with its tiles' poses and air, a [`Body`], a [`State`] to start from. Out: the state of least energy:
//! springs, air, weight, joints, tissue pressed by sheets, and what friction takes up since the state before. Newton's
//! method with a search along each step (`newton`); each tile's sheet is a band, bodies are what is left when all sheets
//! are eliminated (`tile`), so that tiles are solved side by side and the result does not depend on how many at a time.

mod newton;
mod side_by_side;
mod solution;
mod step;
mod tile;
mod touch;

pub use newton::{Fault, put_down, solve, stiffness};
pub use solution::{Contact, Solution};
pub use touch::{Anchor, Touch};

use crate::body::Body;
use crate::pose::Pose;
use crate::sheet::Lattice;
use crate::sheet::air::Air;
use smartbed_runtime::vec3::Vec3;

/// Gravity (m/s^2).
pub const GRAVITY: f64 = 9.81;
/// Pressure per depth (Pa/m) of the plate under a bladder.
const PLATE: f64 = 1e7;
/// Stiffness of tissue along the surface over that across it: G/E of an incompressible layer.
const ALONG: f64 = 1.0 / 3.0;

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
}

/// Where everything is.
#[derive(Clone, Debug, PartialEq)]
pub struct State {
    /// Nodes of each sheet in its tile's frame (m).
    pub sheets: Vec<Vec<Vec3<f64>>>,
    /// Segments in the bed's frame.
    pub segments: Vec<Pose>,
    /// What friction holds, by tile and node.
    pub anchors: Vec<Vec<Option<Anchor>>>,
}

impl Bed {
    /// Air's volume (m^3) under a sheet.
    #[must_use]
    pub fn volume(&self, sheet: &[Vec3<f64>]) -> f64 {
        let [a, b] = self.lattice.size;
        a * b * self.depth + crate::sheet::membrane::volume(&self.lattice, sheet)
    }

    /// Sheets that bulge a little, without friction so far.
    #[must_use]
    pub fn start(&self, body: Vec<Pose>) -> State {
        // Away from the flat sheet, where its bulge has no stiffness.
        let bulged = self.lattice.bulged(0.1 * self.lattice.size[0].min(self.lattice.size[1]));
        let tiles = self.tiles.len();
        let anchors = vec![vec![None; self.lattice.nodes()]; tiles];
        State { sheets: vec![bulged; tiles], segments: body, anchors }
    }

    /// Weight of a body (N).
    #[must_use]
    pub fn weight(body: &Body) -> f64 {
        body.mass() * GRAVITY
    }
}
