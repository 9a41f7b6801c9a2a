//! Sheets that nothing touches, not even a neighbour, each by itself: they come to the end of a stage before the whole bed is looked at.
//!
//! In: a scene in motion, a guess, stiffnesses kept from the stage before. Out: the guess with those sheets where their
//! forces balance. Newton's method with a stiffness that is kept as long as each step takes most of what is left over away
//! (modified Newton): a solution costs a tenth of a factor. What does not come near stays a guess for the search. An empty
//! bed may do all of this in f32.

use super::beside::meetings;
use super::lone::Lone;
use super::scene::Scene;
use super::side_by_side;
use super::state::State;
use super::stiffness::Stiffness;
use super::swing::Swing;
use super::tile::Patch;
use crate::sheet::Lattice;
use smartbed_runtime::real::Scalar;
use smartbed_runtime::vec3::{Vec3, sub};
use std::borrow::Cow;
use std::sync::Arc;

/// Stiffnesses by tile, where one is kept.
pub type Kept<T> = Vec<Option<Arc<Stiffness<T>>>>;

/// Most steps of a sheet.
const STEPS: usize = 16;
/// A step that leaves more than this share asks for another stiffness.
const SLOW: f64 = 0.2;
/// No node goes further in one step (m).
const LONGEST: f64 = 0.02;

/// A sheet at the end of its stage.
struct Settled<T> {
    sheet: Vec<Vec3<T>>,
    stiffness: Option<Arc<Stiffness<T>>>,
}

/// Brings sheets that nothing touches to rest, in the lattice's scalar; returns the stiffnesses to keep, and whether all
/// sheets rest.
pub fn settle<T: Scalar + Send + Sync>(
    scene: &Scene,
    lattice: &Lattice<T>,
    guess: &mut State,
    kept: &Kept<T>,
    in_scalar: impl Fn(&Swing) -> Cow<'_, Swing<T>> + Sync,
) -> (Kept<T>, bool) {
    let met = meetings(scene.bed, guess);
    let one = |tile: usize| {
        let patch = Patch::new(scene, guess, tile);
        let old = kept.get(tile).cloned().flatten();
        let is_met = met.iter().any(|m| m.is_of(tile)) || guess.rubs.iter().any(|rub| rub.is_of(tile));
        if !patch.is_alone() || is_met {
            return None;
        }
        let swing = scene.increment.map(|i| in_scalar(&i.sheets[tile]));
        let lone = Lone::new(scene.bed, &scene.bed.tiles[tile], lattice, swing.as_deref());
        let start = guess.sheets[tile].iter().map(|x| x.map(T::from_f64)).collect();
        own(&lone, start, old, T::from_f64(scene.calm()))
    };
    let found = side_by_side::run(scene.bed.tiles.len(), one);
    let all = found.iter().all(Option::is_some);
    let keep = |(sheet, settled): (&mut Vec<Vec3<f64>>, Option<Settled<T>>)| {
        let settled = settled?;
        *sheet = settled.sheet.into_iter().map(|x| x.map(T::to_f64)).collect();
        settled.stiffness
    };
    (guess.sheets.iter_mut().zip(found).map(keep).collect(), all)
}

/// One sheet; `None` where it does not come nearer.
fn own<T: Scalar>(
    lone: &Lone<T>,
    mut sheet: Vec<Vec3<T>>,
    kept: Option<Arc<Stiffness<T>>>,
    calm: T,
) -> Option<Settled<T>> {
    let (mut stiffness, mut before) = (kept, None);
    let rounding = lone.rounding();
    for _ in 0..STEPS {
        let [force, volume] = lone.gradients(&sheet).ok()?.map(|rows| lone.of_free(&rows));
        let left = force.iter().fold(T::ZERO, |most, g| if size(*g) > most { size(*g) } else { most });
        if left <= calm {
            return Some(Settled { sheet, stiffness });
        }
        if before.is_some_and(|before| left >= before) {
            // As near as places are rounded, nothing is left to gain.
            return (left <= rounding).then_some(Settled { sheet, stiffness });
        }
        let is_slow = before.is_some_and(|before| left > T::from_f64(SLOW) * before) && left > rounding;
        if stiffness.is_none() || is_slow {
            let band = lone.hessian(&sheet, false).ok()?;
            stiffness = Some(Arc::new(lone.factored(&sheet, &band, volume).ok()?));
        }
        let mut way = force;
        stiffness.as_ref()?.solve(&mut way);
        // A comparison that not-a-number fails too.
        if !way.iter().all(|x| size(*x) <= T::from_f64(LONGEST)) {
            return None;
        }
        for (node, x) in sheet.iter_mut().enumerate() {
            if let Some(k) = lone.lattice.free(node) {
                *x = sub(*x, [way[3 * k], way[3 * k + 1], way[3 * k + 2]]);
            }
        }
        before = Some(left);
    }
    None
}

fn size<T: Scalar>(x: T) -> T {
    if x < T::ZERO { -x } else { x }
}
