//! Does a world at rest stay there? It is disturbed a little, and relaxed for a while.
//!
//! In: a world and its state at rest. Out: the part in which the disturbance grows, if there is one.
//! ```text
//! s_n = sum of h u_n,   D = sum of m_n s_n^2 by part,   D > 100 D at the beginning: unstable
//! ```
//! What is stable stays within its disturbance and what is neutral keeps it. What is unstable grows with
//! cosh(sigma t), faster and faster: for as long as it does, the search goes on.

use super::relaxing::{Relaxation, Relaxing};
use smartbed_runtime::mechanism::Fault;

/// A disturbance moves each coordinate at most so far (m, rad).
const FARTHEST: f64 = 1e-6;
/// Steps without speed in which parts come back into contact and stiff springs to their lengths.
const CLOSING: usize = 10;
/// Steps in which rest is watched at least, those of the way there included.
const FEWEST: usize = 500;
/// Share of the steps to rest that each of two disturbances takes.
const SHARE: usize = 20;
/// Growth of D that no stable part shows: modes of a part that meet make it larger for a while.
const UNSTABLE: f64 = 100.0;
/// Growth of D that is more than what was left of the acceleration at rest.
const GROWTH: f64 = 1e-4;
/// D of a part below this share of what was intended was stopped by friction.
const STOPPED: f64 = 1e-2;

/// Finds the part of a world at rest that leaves its place after a disturbance, in one direction or the opposite one.
/// Something is disturbed by as much as `acceleration` moves it in a step. `steps` led to rest, `most` may follow.
///
/// # Errors
/// A step that is refused.
pub(super) fn unstable_part(
    world: &impl Relaxing,
    still: &[f64],
    acceleration: f64,
    [steps, most]: [usize; 2],
) -> Result<Option<usize>, Fault> {
    let watched = FEWEST.saturating_sub(steps).max(steps / SHARE);
    for direction in [1.0, -1.0] {
        // Contacts remember their forces, and chambers of gas their volumes: those at rest are kept.
        let mut world = world.clone();
        let motion = Relaxation::from(&world, still.to_vec());
        let (_, h) = motion.acceleration(&mut world)?;
        let size = direction * (acceleration * h * h).min(FARTHEST);
        let mut disturbed = Disturbed { way: vec![0.0; motion.speeds().len()], motion };
        let first = disturbed.begin(&mut world, size, h)?;
        let found = disturbed.watch(&mut world, &first, [watched, most])?;
        if found.is_some() {
            return Ok(found);
        }
    }
    Ok(None)
}

/// A motion after a disturbance, and how far it went by each speed.
struct Disturbed {
    motion: Relaxation,
    way: Vec<f64>,
}

impl Disturbed {
    fn step(&mut self, world: &mut impl Relaxing) -> Result<(), Fault> {
        let way = &mut self.way;
        let add = |h: f64, speeds: &[f64]| {
            way.iter_mut().zip(speeds).for_each(|(way, speed)| *way += h * speed);
        };
        self.motion.step(world, add).map(|_| ())
    }

    /// Disturbs each coordinate by about `size` in a step h, then closes contacts. Returns D by part.
    fn begin(&mut self, world: &mut impl Relaxing, size: f64, h: f64) -> Result<Vec<f64>, Fault> {
        let push: Vec<f64> = (0..self.way.len()).map(|n| size * unequal(n)).collect();
        for (speed, push) in self.motion.speeds_mut().iter_mut().zip(&push) {
            *speed = push / h;
        }
        for _ in 0..CLOSING {
            self.step(world)?;
            self.motion.speeds_mut().fill(0.0);
        }
        let intended = self.motion.weigh(&push);
        let moved = self.motion.weigh(&self.way);
        Ok(moved.iter().zip(intended).map(|(moved, intended)| moved.max(STOPPED * intended)).collect())
    }

    /// Watches D for some steps, and for twice as many while it grows faster and faster. Returns the unstable part.
    fn watch(
        &mut self,
        world: &mut impl Relaxing,
        first: &[f64],
        [mut watched, most]: [usize; 2],
    ) -> Result<Option<usize>, Fault> {
        // D after half and three quarters of the steps.
        let [mut half, mut late] = [first.to_vec(), first.to_vec()];
        for step in 1..=most {
            self.step(world)?;
            let now = self.motion.weigh(&self.way);
            if let Some(part) = now.iter().zip(first).position(|(now, first)| *now > UNSTABLE * first) {
                return Ok(Some(part));
            }
            if step == watched / 2 {
                half.clone_from(&now);
            }
            if step == watched * 3 / 4 {
                late.clone_from(&now);
            }
            if step >= watched {
                // From rest cosh^2 grows at least 1.4 times as much in the last quarter as in the one before.
                let grows = |part: usize| {
                    let (before, after) = (late[part] - half[part], now[part] - late[part]);
                    after > 1.2 * before && after > GROWTH * first[part]
                };
                if !(0..now.len()).any(grows) {
                    return Ok(None);
                }
                (watched, half) = (2 * watched, now);
            }
        }
        Ok(None)
    }
}

/// A number between 1/4 and 1, another one for each n: fractions of multiples of the golden ratio are spread evenly.
fn unequal(n: usize) -> f64 {
    0.25 + 0.75 * ((n + 1) as f64 * 0.618_033_988_749_895).fract()
}
