//! Metrics of pressure maps: of a single map, over time, of shear, and of tissue under a history of load.
//!
//! In: a [`crate::map::Recording`] (and a grid, where neighbours matter). Out: numbers in SI units, and [`report`]: all
//! of them with units and thresholds. The set of metrics is fixed in advance and all are reported, because five
//! mattresses rank differently by different indices, and an index can be constructed by which any of them wins (J Wound
//! Care 12(6), 2003). For the same reason there is no combined score.

pub mod braden;
pub mod report;
pub mod shear;
pub mod spatial;
pub mod time;
pub mod tissue;

use crate::map::MMHG;

/// Stands below every report.
pub const DISCLAIMER: &str = "engineering indices, not clinical evidence";

/// Pressure thresholds (Pa), and estimated parameters of metrics.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Thresholds {
    /// A site above this is in contact.
    pub contact: f64,
    /// Above this capillaries are occluded.
    pub occlusion: f64,
    /// Length of a cycle (s), for persistent occlusion and contrast.
    pub cycle: f64,
    /// Ratio of the stress in muscle under bone to the pressure at the skin: 2 to 4 are in use, none measured.
    pub muscle_factor: f64,
    /// c of the pressure with the same risk without shear, p (1 + c tau/tau_0).
    pub shear_factor: f64,
    /// tau_0 of that formula (Pa).
    pub shear_reference: f64,
}

impl Default for Thresholds {
    fn default() -> Self {
        Thresholds {
            contact: 5.0 * MMHG,
            occlusion: 32.0 * MMHG,
            cycle: 600.0,
            muscle_factor: 2.0,
            // Six times the risk at a shear of 10 kPa: the ratio is Dinsdale's, the shear our estimate.
            shear_factor: 5.0,
            shear_reference: 10e3,
        }
    }
}
