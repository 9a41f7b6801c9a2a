//! Solves the sheets that nothing touches, each by itself, before the whole bed is solved.
//!
//! In: a scene in motion, a guess, factored stiffnesses kept from the stage before. Out: the guess with those sheets in
//! equilibrium. Modified Newton: a factored stiffness is reused as long as each step removes most of the residual
//! force, because a solution costs a tenth of a factorisation. A sheet that does not converge keeps its guess, for the
//! search over the whole bed. In an empty bed all of this may be done in f32.

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

/// By tile: the factored stiffness, if one is kept.
pub type Kept<T> = Vec<Option<Arc<Stiffness<T>>>>;

/// Most steps per sheet.
const STEPS: usize = 16;
/// A step that leaves more than this share of the residual asks for a new factorisation.
const SLOW: f64 = 0.2;
/// Longest step of a node (m).
const LONGEST: f64 = 0.02;

/// A sheet in equilibrium at the end of its stage.
struct Settled<T> {
    sheet: Vec<Vec3<T>>,
    stiffness: Option<Arc<Stiffness<T>>>,
}

/// Solves the untouched sheets, in the lattice's scalar. Returns the stiffnesses to keep, and whether all sheets were
/// solved.
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

/// Solves one sheet; `None` if it does not converge.
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
            // The residual has stopped falling: accept it if it is within the rounding of the positions.
            return (left <= rounding).then_some(Settled { sheet, stiffness });
        }
        let is_slow = before.is_some_and(|before| left > T::from_f64(SLOW) * before) && left > rounding;
        if stiffness.is_none() || is_slow {
            let band = lone.hessian(&sheet, false).ok()?;
            stiffness = Some(Arc::new(lone.factored(&sheet, &band, volume).ok()?));
        }
        let mut way = force;
        stiffness.as_ref()?.solve(&mut way);
        // Written so that NaN fails too.
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
