//! Static equilibrium by dynamic relaxation with kinetic damping (Cundall 1976, Barnes 1999).
//!
//! In: a world at its start. Out: the same at rest, where nothing accelerates. Time is fixed. Free motion by small
//! steps reduces a part's kinetic energy: whenever it begins to fall, that part's velocities are set to 0. This is done
//! part by part, so that slow oscillations are not stopped by fast ones. Frames that a law moves stay at their start.

use super::engine::Settled;
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
/// A speed counts as an acceleration over this many steps.
const SLOW: f64 = 1e-3;

/// A world that can be relaxed. Its state x is coordinates, then speeds.
pub(super) trait Relaxing {
    /// The state.
    fn vector(&self) -> Vec<f64>;
    /// Index in the state at which speeds begin.
    fn split(&self) -> usize;
    /// Masses that belong to the speeds.
    fn masses(&self) -> Vec<f64>;
    /// By speed: the index of its part.
    fn owners(&self) -> Vec<usize>;
    /// Name of such a part.
    fn name(&self, owner: usize) -> String;
    /// Largest speed of a frame at the start (m/s or rad/s).
    fn fastest_frame(&self) -> f64;
    /// Length of gravity (m/s^2).
    fn gravity(&self) -> f64;
    /// Takes a step of free motion at the time of the start; `low` holds the rounding errors. Returns the step (s), and
    /// the speed with which overlapping parts leave one another, which is not part of their velocities (m/s, rad/s).
    fn advance(&mut self, x: &mut [f64], low: &mut [f64]) -> Result<(f64, f64), Fault>;
    /// Restarts at a state.
    fn restart(&mut self, x: Vec<f64>);
}

/// Relaxes a world.
///
/// # Errors
/// What moves as commanded at the start, falls away, or does not come to rest, in words.
pub(super) fn relax(world: &mut impl Relaxing) -> Result<Settled, String> {
    let words = |fault: Fault| format!("settle: {}", fault.reason());
    let (mut x, n_q, masses, owners) = (world.vector(), world.split(), world.masses(), world.owners());
    let mut power = vec![0.0; owners.iter().max().map_or(0, |last| last + 1)];
    x[n_q..].fill(0.0);
    if world.fastest_frame() > STILL {
        return Err(
            "settle: a frame moves as commanded at the start; begin with a law that starts at rest, such as \
                    1 - cos(w*t)"
                .to_owned(),
        );
    }
    if x.is_empty() {
        // Nothing is free to move: time prescribes everything.
        return Ok(Settled { steps: 0, acceleration: 0.0 });
    }
    let (first, h) = acceleration(world, &x, n_q).map_err(words)?;
    let size = x[..n_q].iter().fold(0.0_f64, |most, x| most.max(x.abs()));
    let gravity = world.gravity();
    let rest = if gravity > 0.0 { REST * gravity } else { (REST * first).max(f64::EPSILON * size / (h * h)) };
    let (start, far) = (x[..n_q].to_vec(), AWAY * size.max(1.0));
    let mut low = vec![0.0; x.len()];
    let mut left = first;
    for step in 0..MOST_STEPS {
        if left <= rest {
            let mut still = x.clone();
            still[n_q..].fill(0.0);
            (left, _) = acceleration(world, &still, n_q).map_err(words)?;
            if left <= rest {
                world.restart(still);
                return Ok(Settled { steps: step, acceleration: left });
            }
        }
        let before = x[n_q..].to_vec();
        let (h, leaving) = world.advance(&mut x, &mut low).map_err(words)?;
        power.fill(0.0);
        left = leaving / h * SLOW;
        for (n, (now, before)) in x[n_q..].iter().zip(&before).enumerate() {
            power[owners[n]] += masses[n] * now * (now - before);
            left = left.max(((now - before) / h).abs()).max((now / h).abs() * SLOW);
        }
        if x.iter().zip(&start).any(|(x, start)| (x - start).abs() > far) {
            let speeds = x[n_q..].iter().zip(&owners);
            let fastest =
                speeds.max_by(|a, b| a.0.abs().total_cmp(&b.0.abs())).map_or(0, |(_, owner)| *owner);
            return Err(format!(
                "settle: `{}` has moved {far:.0} m (or rad) and does not come to rest: nothing holds it, or it \
                 slides or rolls off; hold it, or give its support friction",
                world.name(fastest)
            ));
        }
        for (speed, owner) in x[n_q..].iter_mut().zip(&owners) {
            *speed = if power[*owner] < 0.0 { 0.0 } else { *speed };
        }
    }
    Err(format!(
        "settle: after {MOST_STEPS} steps an acceleration of {left:.1e} m/s^2 is left; expected every part to be \
         held or supported; if all are, take a smaller step"
    ))
}

/// Largest acceleration at a state at rest, from the result of one step, and the step (s).
fn acceleration(world: &mut impl Relaxing, x: &[f64], n_q: usize) -> Result<(f64, f64), Fault> {
    let (mut tried, mut low) = (x.to_vec(), vec![0.0; x.len()]);
    let (h, leaving) = world.advance(&mut tried, &mut low)?;
    Ok((tried[n_q..].iter().fold(leaving / h * SLOW, |largest, speed| (speed / h).abs().max(largest)), h))
}
