//! Metrics of pressure maps: of one map, over time, of shear, and of tissue under a history of load.
//!
//! In: a [`crate::map::Recording`] (and a grid, where neighbours count). Out: numbers in SI units, and [`report`]: all
//! of them with units and thresholds. They are fixed beforehand and all reported: five mattresses rank differently by
//! different indices, and an index can be built that makes any of them win (J Wound Care 12(6), 2003). So there is no
//! blended score.

pub mod braden;
pub mod report;
pub mod shear;
pub mod spatial;
pub mod time;
pub mod tissue;

use crate::map::MMHG;

/// What stands under every report.
pub const DISCLAIMER: &str = "engineering indices, not clinical evidence";

/// Pressures at which something is said to begin (Pa).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Thresholds {
    /// A site touches above this.
    pub contact: f64,
    /// Capillaries close above this.
    pub occlusion: f64,
    /// Length of a cycle (s), for persistent occlusion and contrast.
    pub cycle: f64,
}

impl Default for Thresholds {
    fn default() -> Self {
        Thresholds { contact: 5.0 * MMHG, occlusion: 32.0 * MMHG, cycle: 600.0 }
    }
}
