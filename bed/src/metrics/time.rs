//! Metrics over time, site by site: points of the skin move with the skin, sensels stay in place.
//!
//! In: a recording. Out: one number per site, areas, and the motion of the centre of pressure. A frame represents its
//! duration, so that sums over frames are integrals; the last frame may have duration 0.

use super::spatial;
use crate::map::{Frame, Grid, Recording};

/// Rounding of times, relative: ten frames of 0.1 s make a second, whatever their sum rounds to.
const ROUNDING: f64 = 1e-12;

/// Frames of the last `cycle` seconds, between which there may be gaps; `None` if less was recorded.
fn last_cycle(recording: &Recording, cycle: f64) -> Option<&[Frame]> {
    let frames = recording.frames();
    let last = frames.last()?;
    let (end, rounding) = (last.time + last.seconds, ROUNDING * (cycle + last.time));
    let begin = end - cycle;
    if frames[0].time > begin + rounding {
        return None;
    }
    let first = frames.iter().position(|frame| frame.time + frame.seconds > begin + rounding)?;
    Some(&frames[first..])
}

/// A number for each site, computed from all frames.
fn by_site(recording: &Recording, of: impl Fn(usize) -> f64) -> Vec<f64> {
    (0..recording.sites().len()).map(of).collect()
}

/// Area of the sites whose numbers satisfy a condition.
fn area_where(recording: &Recording, numbers: &[f64], holds: impl Fn(f64) -> bool) -> f64 {
    let sites = recording.sites().iter().zip(numbers);
    // `sum` of no floats would be -0.
    sites.filter(|(_, x)| holds(**x)).fold(0.0, |sum, (s, _)| sum + s.area)
}

/// Persistent occlusion (m^2): area whose minimum pressure over the last cycle exceeds the occlusion pressure; `None`
/// if less than a cycle was recorded. Yang et al., Science Robotics 10(103), 2025.
#[must_use]
pub fn persistent_occlusion(recording: &Recording, cycle: f64, occlusion: f64) -> Option<f64> {
    let frames = last_cycle(recording, cycle)?;
    let least = by_site(recording, |i| frames.iter().fold(f64::INFINITY, |low, f| low.min(f.pressure[i])));
    Some(area_where(recording, &least, |p| p > occlusion))
}

/// Always at risk (m^2): area above the limit for at least 95 % of the time. Peterson et al., JRRD 50(4), 2013.
#[must_use]
pub fn always_at_risk(recording: &Recording, limit: f64) -> f64 {
    let share = share_of_time(recording, |p| p > limit);
    area_where(recording, &share, |s| s >= 0.95 - 1e-12)
}

/// Contrast between load and off-load at each site over the last cycle: max p - min p (Pa); `None` if less was
/// recorded.
#[must_use]
pub fn contrast(recording: &Recording, cycle: f64) -> Option<Vec<f64>> {
    let frames = last_cycle(recording, cycle)?;
    Some(by_site(recording, |i| {
        let (low, high) = frames.iter().fold((f64::INFINITY, 0.0_f64), |(low, high), f| {
            (low.min(f.pressure[i]), high.max(f.pressure[i]))
        });
        high - low
    }))
}

/// Pressure-time integral above a limit at each site: sum max(0, p - limit) dt (Pa s); limit 0 gives the whole
/// integral.
#[must_use]
pub fn pressure_time(recording: &Recording, limit: f64) -> Vec<f64> {
    by_site(recording, |i| {
        recording.frames().iter().map(|f| (f.pressure[i] - limit).max(0.0) * f.seconds).sum()
    })
}

/// Pressure relief index of each site: share of time below a limit (Pa).
#[must_use]
pub fn relief(recording: &Recording, limit: f64) -> Vec<f64> {
    share_of_time(recording, |p| p < limit)
}

fn share_of_time(recording: &Recording, holds: impl Fn(f64) -> bool) -> Vec<f64> {
    let all = recording.seconds();
    by_site(recording, |i| {
        let held = recording.frames().iter().filter(|f| holds(f.pressure[i]));
        if all > 0.0 { held.map(|f| f.seconds).sum::<f64>() / all } else { 0.0 }
    })
}

/// Motion of the centre of pressure.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Mobility {
    /// Length of its path (m).
    pub path: f64,
    /// How often it has moved farther than the limit from where the last shift was counted.
    pub shifts: usize,
}

/// Path of the centre of pressure; frames without load are skipped. A shift is counted once it exceeds `limit` (m),
/// usually 20 mm.
#[must_use]
pub fn mobility(grid: &Grid, recording: &Recording, limit: f64) -> Mobility {
    let mut mobility = Mobility { path: 0.0, shifts: 0 };
    let mut centres = recording.frames().iter().filter_map(|f| spatial::centre(grid, &f.pressure));
    let Some(first) = centres.next() else { return mobility };
    let (mut before, mut counted) = (first, first);
    let distance = |a: [f64; 2], b: [f64; 2]| (a[0] - b[0]).hypot(a[1] - b[1]);
    for centre in centres {
        mobility.path += distance(centre, before);
        before = centre;
        if distance(centre, counted) > limit {
            mobility.shifts += 1;
            counted = centre;
        }
    }
    mobility
}
