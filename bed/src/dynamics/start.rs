//! The start of a motion: sheets in equilibrium, the body at rest above them.

use crate::body::Body;
use crate::equilibrium::{Bed, Fault, State, solve};
use crate::pose::Pose;

/// Sheets in equilibrium, and a body above them at this smallest distance (m).
///
/// # Errors
/// [`Fault`].
pub fn dropped(bed: &Bed, body: &Body, poses: &[Pose], distance: f64) -> Result<State, Fault> {
    let alone = solve(bed, &Body::default(), &bed.start(Vec::new()))?;
    let mut state = alone.state;
    state.segments = lowered(bed, body, &state, poses, distance);
    Ok(state)
}

/// The poses moved vertically until the smallest distance of a segment from a node is this (m).
#[must_use]
pub fn lowered(bed: &Bed, body: &Body, state: &State, poses: &[Pose], distance: f64) -> Vec<Pose> {
    let mut poses = poses.to_vec();
    // A step down by the excess distance never goes too far; it shrinks as distance and height approach each other.
    for _ in 0..100 {
        let mut least = f64::INFINITY;
        for (tile, sheet) in bed.tiles.iter().zip(&state.sheets) {
            for node in sheet {
                let place = tile.pose.outwards(*node);
                let gap = |(segment, pose): (&crate::body::Segment, &Pose)| {
                    segment.shape.distance(pose.inwards(place)) - bed.cover.thickness
                };
                least = body.segments.iter().zip(&poses).map(gap).fold(least, f64::min);
            }
        }
        let way = distance - least;
        if !way.is_finite() || way.abs() < 1e-9 {
            break;
        }
        poses.iter_mut().for_each(|pose| pose.place[2] += way);
    }
    poses
}
