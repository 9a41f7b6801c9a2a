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

/// Pressures at which something is said to begin (Pa), and estimates that metrics go by.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Thresholds {
    /// A site touches above this.
    pub contact: f64,
    /// Capillaries close above this.
    pub occlusion: f64,
    /// Length of a cycle (s), for persistent occlusion and contrast.
    pub cycle: f64,
    /// Stress in muscle under bone over pressure at the skin: 2 to 4 are in use, unmeasured.
    pub muscle_factor: f64,
    /// c of the pressure of the same risk without shear, p (1 + c tau/tau_0).
    pub shear_factor: f64,
    /// tau_0 of the same (Pa).
    pub shear_reference: f64,
}

impl Default for Thresholds {
    fn default() -> Self {
        Thresholds {
            contact: 5.0 * MMHG,
            occlusion: 32.0 * MMHG,
            cycle: 600.0,
            muscle_factor: 2.0,
            // Six times the risk where shear is 10 kPa: Dinsdale's ratio, at a shear that is our estimate.
            shear_factor: 5.0,
            shear_reference: 10e3,
        }
    }
}
