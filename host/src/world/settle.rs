//! Static equilibrium by dynamic relaxation with kinetic damping (Cundall 1976, Barnes 1999).
//!
//! In: a world at its start. Out: the same at rest, where nothing accelerates, and the part that does not stay there.
//! Time is fixed. Free motion by small steps reduces a part's kinetic energy: whenever it begins to fall, that part's
//! velocities are set to 0. This is done part by part, so that slow oscillations are not stopped by fast ones. Frames
//! that a law moves stay at their start.

use super::engine::Settled;
use super::relaxing::{Relaxation, Relaxing};
use super::stability::unstable_part;
use smartbed_runtime::mechanism::Fault;

/// Most steps.
const MOST_STEPS: usize = 500_000;
/// Acceleration that counts as zero, relative to gravity; without gravity relative to the largest at the start, or the
/// apparent acceleration due to rounding of positions within a step.
const REST: f64 = 1e-10;
/// A frame slower than this (m/s, rad/s) counts as fixed.
const STILL: f64 = 1e-9;
/// What has gone so many times the world's size, or so many metres or radians, comes to rest nowhere.
const AWAY: f64 = 100.0;

/// Relaxes a world.
///
/// # Errors
/// What moves as commanded at the start, falls away, or does not come to rest, in words.
pub(super) fn relax(world: &mut impl Relaxing) -> Result<Settled, String> {
    if world.fastest_frame() > STILL {
        return Err(
            "settle: a frame moves as commanded at the start; begin with a law that starts at rest, such as \
                    1 - cos(w*t)"
                .to_owned(),
        );
    }
    let mut motion = Relaxation::from(world, world.vector());
    if motion.x.is_empty() {
        // Nothing is free to move: time prescribes everything.
        return Ok(Settled { steps: 0, acceleration: 0.0, unstable: None });
    }
    let (first, h) = motion.acceleration(world).map_err(words)?;
    let size = motion.places().iter().fold(0.0_f64, |most, x| most.max(x.abs()));
    let gravity = world.gravity();
    let rest = if gravity > 0.0 { REST * gravity } else { (REST * first).max(f64::EPSILON * size / (h * h)) };
    let (steps, acceleration) = to_rest(world, &mut motion, first, [rest, AWAY * size.max(1.0)])?;
    let watched = [steps, MOST_STEPS - steps];
    // A disturbance that a step refuses tells nothing; the world is at rest all the same.
    let unstable = unstable_part(world, &motion.x, rest / REST, watched).unwrap_or(None);
    world.restart(motion.x);
    Ok(Settled { steps, acceleration, unstable: unstable.map(|part| world.name(part)) })
}

/// Relaxes from an acceleration `left` until nothing accelerates by more than `rest`; leaves the state without speeds.
/// Returns the steps and the largest acceleration that is left.
fn to_rest(
    world: &mut impl Relaxing,
    motion: &mut Relaxation,
    mut left: f64,
    [rest, far]: [f64; 2],
) -> Result<(usize, f64), String> {
    let start = motion.places().to_vec();
    // Largest acceleration in the second and in the last quarter of the steps.
    let mut largest = [0.0_f64; 2];
    for step in 0..MOST_STEPS {
        if left <= rest {
            (left, _) = motion.acceleration(world).map_err(words)?;
            if left <= rest {
                motion.speeds_mut().fill(0.0);
                return Ok((step, left));
            }
        }
        left = motion.step(world, |_, _| ()).map_err(words)?;
        match step * 4 / MOST_STEPS {
            1 => largest[0] = largest[0].max(left),
            3 => largest[1] = largest[1].max(left),
            _ => {}
        }
        if motion.places().iter().zip(&start).any(|(x, start)| (x - start).abs() > far) {
            return Err(format!(
                "settle: `{}` has moved {far:.0} m (or rad) and does not come to rest: nothing holds it, or it \
                 slides or rolls off; hold it, or give its support friction",
                world.name(motion.fastest())
            ));
        }
    }
    Err(unfinished(left, largest))
}

fn words(fault: Fault) -> String {
    format!("settle: {}", fault.reason())
}

/// The message for a relaxation that does not end, after the largest accelerations in its second and last quarters.
fn unfinished(left: f64, [before, last]: [f64; 2]) -> String {
    let advice = if last < 0.9 * before {
        "it still falls: what is heavy on soft springs moves slowly, and a larger step brings it further"
    } else {
        "expected every part to be held or supported; if all are, take a smaller step, or a larger one for heavy parts \
         on soft springs"
    };
    format!("settle: after {MOST_STEPS} steps an acceleration of {left:.1e} m/s^2 is left; {advice}")
}
