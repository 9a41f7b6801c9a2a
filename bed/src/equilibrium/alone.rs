//! Sheets that nothing touches, not even a neighbour, each by itself: they come to the end of a stage before the whole bed is looked at.
//!
//! In: a scene in motion, a guess, stiffnesses kept from the stage before. Out: the guess with those sheets where their
//! forces balance. Newton's method with a stiffness that is kept as long as each step takes most of what is left over away
//! (modified Newton): a solution costs a tenth of a factor. What does not come near stays a guess for the search.

use super::beside::meetings;
use super::scene::Scene;
use super::side_by_side;
use super::state::State;
use super::stiffness::Stiffness;
use super::tile::Patch;
use smartbed_runtime::vec3::{Vec3, sub};
use std::sync::Arc;

/// Stiffnesses by tile, where one is kept.
pub type Kept = Vec<Option<Arc<Stiffness>>>;

/// Most steps of a sheet.
const STEPS: usize = 16;
/// A step that leaves more than this share asks for another stiffness.
const SLOW: f64 = 0.2;
/// No node goes further in one step (m).
const LONGEST: f64 = 0.02;

/// A sheet at the end of its stage.
struct Settled {
    sheet: Vec<Vec3<f64>>,
    stiffness: Option<Arc<Stiffness>>,
}

/// Brings sheets that nothing touches to rest; returns the stiffnesses to keep.
pub fn settle(scene: &Scene, guess: &mut State, kept: &Kept) -> Kept {
    let met = meetings(scene.bed, guess);
    let one = |tile: usize| {
        let patch = Patch::new(scene, guess, tile);
        let old = kept.get(tile).cloned().flatten();
        if patch.is_alone() && !met.iter().any(|m| m.is_of(tile)) {
            own(&patch, old, scene.calm())
        } else {
            None
        }
    };
    let found = side_by_side::run(scene.bed.tiles.len(), one);
    let keep = |(sheet, settled): (&mut Vec<Vec3<f64>>, Option<Settled>)| {
        let settled = settled?;
        *sheet = settled.sheet;
        settled.stiffness
    };
    guess.sheets.iter_mut().zip(found).map(keep).collect()
}

/// One sheet; `None` where it does not come nearer.
fn own(patch: &Patch, kept: Option<Arc<Stiffness>>, calm: f64) -> Option<Settled> {
    let (mut sheet, mut stiffness) = (patch.sheet().to_vec(), kept);
    let mut before = f64::INFINITY;
    for _ in 0..STEPS {
        let here = patch.with(&sheet);
        let [mut way, volume] = here.gradients(&[]).ok()?;
        let left = way.iter().fold(0.0_f64, |most, g| most.max(g.abs()));
        if left <= calm {
            return Some(Settled { sheet, stiffness });
        }
        if left >= before {
            return None;
        }
        if stiffness.is_none() || before.is_finite() && left > SLOW * before {
            stiffness = Some(Arc::new(here.stiffness(&[], volume).ok()?));
        }
        stiffness.as_ref()?.solve(&mut way);
        // A comparison that not-a-number fails too.
        if !way.iter().all(|x| x.abs() <= LONGEST) {
            return None;
        }
        patch.free_nodes(&mut sheet, |x, k| *x = sub(*x, [way[3 * k], way[3 * k + 1], way[3 * k + 2]]));
        before = left;
    }
    None
}
