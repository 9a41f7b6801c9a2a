//! Metrics of shear: peak, resultant, slip, integral over time, and rotation of its direction.
//!
//! In: shear in two directions along the surface (Pa), and pressure. Out: numbers in SI units.

use crate::map::{Frame, Recording, Site};

/// |tau| of a site (Pa).
fn size(shear: &[f64; 2]) -> f64 {
    shear[0].hypot(shear[1])
}

/// Largest shear (Pa).
#[must_use]
pub fn peak(shear: &[[f64; 2]]) -> f64 {
    shear.iter().map(size).fold(0.0, f64::max)
}

/// Resultant sum tau A (N).
#[must_use]
pub fn resultant(sites: &[Site], shear: &[[f64; 2]]) -> [f64; 2] {
    let along = |axis: usize| sites.iter().zip(shear).map(|(s, t)| s.area * t[axis]).sum();
    [along(0), along(1)]
}

/// Slip index: the largest |tau|/(mu p) of the sites in contact; from 1 on a site slips. `None` if nothing is in
/// contact.
#[must_use]
pub fn slip(frame: &Frame, contact: f64, friction: f64) -> Option<f64> {
    let sites = frame.pressure.iter().zip(&frame.shear).filter(|(p, _)| **p > contact);
    // Without friction nothing is sheared.
    let index = |shear: f64, most: f64| if shear > 0.0 { shear / most } else { 0.0 };
    sites.map(|(p, t)| index(size(t), friction * p)).reduce(f64::max)
}

/// Largest pressure (Pa) with the same risk without shear, p (1 + c |tau|/tau_0). In swine shear lowers the pressure
/// that causes ulcers from 290 to 45 mmHg (Dinsdale 1974); c and tau_0 are parameters, not measurements.
#[must_use]
pub fn equivalent_pressure(frame: &Frame, factor: f64, reference: f64) -> Option<f64> {
    let sites = frame.pressure.iter().zip(&frame.shear);
    sites.map(|(p, t)| p * (1.0 + factor * size(t) / reference)).reduce(f64::max)
}

/// Shear over time of each site: sum |tau| dt (Pa s).
#[must_use]
pub fn shear_time(recording: &Recording) -> Vec<f64> {
    let mut sums = vec![0.0; recording.sites().len()];
    for frame in recording.frames() {
        for (sum, shear) in sums.iter_mut().zip(&frame.shear) {
            *sum += size(shear) * frame.seconds;
        }
    }
    sums
}

/// Total rotation of the direction of shear at each site (rad); frames with less shear than `least` (Pa) are skipped.
#[must_use]
pub fn turning(recording: &Recording, least: f64) -> Vec<f64> {
    let count = recording.sites().len();
    let (mut turned, mut before) = (vec![0.0; count], vec![None; count]);
    for frame in recording.frames() {
        for (site, shear) in frame.shear.iter().enumerate() {
            if size(shear) <= least {
                continue;
            }
            if let Some([x, y]) = before[site].replace(*shear) {
                let (cross, dot): (f64, f64) = (x * shear[1] - y * shear[0], x * shear[0] + y * shear[1]);
                turned[site] += cross.atan2(dot).abs();
            }
        }
    }
    turned
}

/// Stretch of the skin between two neighbouring tiles: |d_a - d_b|/gap, with d the displacement of each surface (m).
#[must_use]
pub fn differential_drag(one: [f64; 2], other: [f64; 2], gap: f64) -> f64 {
    (one[0] - other[0]).hypot(one[1] - other[1]) / gap
}
