//! Newton's method for the whole bed, with a line search.
//!
//! In: a state. Out: the state of equilibrium. A step is shortened until the energy falls. Friction limits are those of
//! the pass before; passes end when the limits do not change any more. Neighbouring sheets near each other move only as
//! far as their contacts are known, which are then found anew; otherwise soft sheets could pass through one another.

use super::bed::{Bed, GRAVITY};
use super::beside;
use super::bridge::Bridge;
use super::scene::Scene;
use super::side_by_side;
use super::solution::{Solution, finish};
use super::state::State;
use super::step::{Ways, condensed, of_body, rows};
use super::tile::{Eliminated, Patch};
use super::touch::Anchor;
use crate::body::{Body, Rows};
use crate::sheet::air::Collapsed;
use crate::sheet::membrane;
use smartbed_runtime::vec3::{Vec3, norm, sub};
use std::fmt;

/// Most Newton steps of one pass.
const STEPS: usize = 2000;
/// Most passes in which friction limits are renewed.
const PASSES: usize = 60;
/// Largest area of a sheet relative to its rim. Sheets in equilibrium stay below about four; a larger one grows without
/// bound.
const LARGEST: f64 = 5.0;
/// Longest step of a node (m).
const LONGEST: f64 = 0.02;

/// The reason why there is no equilibrium.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Fault {
    /// A bladder has lost its air: its tile and volume (m^3).
    Collapsed(usize, f64),
    /// A sheet is too soft for its pressure: its tile, and its area relative to its rim.
    Burst(usize, f64),
    /// Nothing supports the body.
    Lost,
    /// Springs are so stiff (N/m) that rounding causes a larger residual force (N) on a node than is allowed.
    Rounded(f64, [f64; 2]),
    /// Residual force (N) after all steps: on nodes, on segments.
    NotFound(f64, f64),
}

impl fmt::Display for Fault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Fault::Collapsed(tile, volume) => {
                write!(
                    f,
                    "the bladder of tile {} has collapsed to {volume:.2e} m^3; raise its pressure",
                    tile + 1
                )
            }
            Fault::Burst(tile, share) => write!(
                f,
                "the sheet of tile {} is too soft for its pressure: its area has grown to {share:.0} times the \
                 original, where it holds less pressure the more it grows; expected a larger `modulus` or less \
                 pressure",
                tile + 1
            ),
            Fault::Lost => f.write_str(
                "the load touches no bladder: it lies beside them, has slid or rolled off, or fits between the \
                 nodes of a coarse grid; expected another `place`, more friction, or more `intervals`",
            ),
            Fault::Rounded(stiffest, [left, most]) => write!(
                f,
                "no equilibrium: springs of {stiffest:.1e} N/m are so stiff that rounding leaves {left:.1e} N on a \
                 node, expected {most:.1e} N at most; take softer sheets, or a softer foundation under the load"
            ),
            Fault::NotFound(node, segment) => write!(
                f,
                "no equilibrium: {node:.1e} N on a node and {segment:.1e} N on a segment of the load remain \
                 unbalanced; command smaller changes, or raise the pressure of slack bladders"
            ),
        }
    }
}

impl std::error::Error for Fault {}

/// Finds the equilibrium from a state; friction acts where contact existed in that state.
///
/// # Errors
/// [`Fault`].
pub fn solve(bed: &Bed, body: &Body, start: &State) -> Result<Solution, Fault> {
    find(&Scene::at_rest(bed, body), start)
}

/// Minimises the energy of a scene.
pub fn find(scene: &Scene, start: &State) -> Result<Solution, Fault> {
    let mut state = start.clone();
    let weight = Bed::weight(scene.body).max(1e-3);
    let mut met = beside::meetings(scene.bed, &state);
    let (mut steps, mut of_pass, mut pass) = (0, 0, 1);
    loop {
        let scene = &Scene { met: &met, ..*scene };
        let end = descend(scene, &mut state, weight, STEPS - of_pass)?;
        steps += end.steps;
        if !end.is_found {
            of_pass += end.steps;
            met = beside::meetings(scene.bed, &state);
            continue;
        }
        let Some(least) = scene.accuracy.friction else { break };
        let now = beside::meetings(scene.bed, &state);
        let pushed = beside::change(scene.bed, &state, [&met, &now]);
        let (anchors, change) = renewed(scene, &state);
        let (rubs, rubbed) = beside::renewed(scene.bed, &state, &now);
        // Reads the solution with the limits of this pass, in which it is in balance; those of a next pass would not
        // fit node by node.
        if change.max(rubbed) <= least * weight && pushed <= 100.0 * scene.calm() || pass == PASSES {
            break;
        }
        (state.anchors, state.rubs, met) = (anchors, rubs, now);
        (pass, of_pass) = (pass + 1, 0);
    }
    Ok(finish(&Scene { met: &met, ..*scene }, state, steps))
}

/// Puts a body down: first guided vertically, without rotation, then released and held by friction where it has
/// touched. A plate that was free from the beginning would slide off a round bladder.
///
/// # Errors
/// [`Fault`].
pub fn put_down(bed: &Bed, body: &Body, start: &State) -> Result<Solution, Fault> {
    let mut led = body.clone();
    for segment in &mut led.segments {
        segment.free = [false, false, segment.free[2], false, false, false];
    }
    let down = solve(bed, &led, start)?;
    let free = solve(bed, body, &down.state)?;
    Ok(Solution { steps: down.steps + free.steps, ..free })
}

/// Applies a body's weight in equal increments, so that friction acts where it touches first, as in a fall. Its first
/// segment is guided vertically, then released.
///
/// # Errors
/// [`Fault`].
pub fn lay_on(bed: &Bed, body: &Body, start: &State, parts: usize) -> Result<Solution, Fault> {
    let mut led = body.clone();
    if let Some(first) = led.segments.first_mut() {
        first.free = [false, false, first.free[2], false, false, false];
    }
    let (mut state, mut steps) = (start.clone(), 0);
    for part in 1..=parts {
        let segments = led.segments.iter_mut().zip(&body.segments);
        segments.for_each(|(own, whole)| own.mass = part as f64 / parts as f64 * whole.mass);
        let down = solve(bed, &led, &state)?;
        (state, steps) = (down.state, steps + down.steps);
    }
    let free = solve(bed, body, &state)?;
    Ok(Solution { steps: steps + free.steps, ..free })
}

/// Anchors with present normals and limits, and the largest change of a limit (N).
fn renewed(scene: &Scene, state: &State) -> (Vec<Vec<Option<Anchor>>>, f64) {
    let bed = scene.bed;
    let (mut all, mut most) = (state.anchors.clone(), 0.0_f64);
    for (tile, anchors) in all.iter_mut().enumerate() {
        if anchors.iter().all(Option::is_none) {
            continue;
        }
        let touches = Patch::new(scene, state, tile).touches();
        for (node, anchor) in anchors.iter_mut().enumerate() {
            let Some(anchor) = anchor else { continue };
            let now = touches.iter().find(|(t, _)| t.node == node && t.segment == anchor.segment);
            let limit = now.map_or(0.0, |(t, _)| bed.friction * t.force());
            most = most.max((limit - anchor.limit).abs());
            anchor.limit = limit;
            if let Some((t, _)) = now {
                anchor.normal = state.segments[anchor.segment].attitude.to_body(t.normal);
            }
        }
    }
    (all, most)
}

/// Result of a series of Newton steps.
struct Descent {
    steps: usize,
    /// True if it has converged; false if sheets have moved so far that their contacts must be found anew.
    is_found: bool,
}

/// At most `most` Newton steps, with constant friction limits and contacts.
fn descend(scene: &Scene, state: &mut State, weight: f64, most: usize) -> Result<Descent, Fault> {
    let calm = scene.calm();
    let (mut last, mut gone) = (None, 0.0);
    for step in 0..most {
        let tiles = eliminate(scene, state, calm)?;
        let rows = rows(scene, state, &tiles);
        let left = left_over(scene.body, &rows, &tiles);
        if left[0] <= calm && left[1] <= scene.accuracy.segment * weight {
            return Ok(Descent { steps: step, is_found: true });
        }
        let ways = Ways::new(scene, &rows, &tiles);
        let gradients: Vec<&[f64]> =
            tiles.iter().map(|t| t.as_ref().map_or(&[][..], |t| &t.gradient)).collect();
        let steepness = ways.slope(&gradients, &rows).abs();
        let before = last.map_or_else(|| energy(scene, state), Ok)?;
        let found = match search(scene, state, &ways, before, steepness)? {
            Some(found) if step + 1 < most => found,
            _ => {
                let is_lost = left[1] > 0.0 && tiles.iter().flatten().all(|tile| tile.bonds.is_empty());
                let other = if is_lost { Fault::Lost } else { Fault::NotFound(left[0], left[1]) };
                let named = burst(scene.bed, state).or_else(|| rounded(scene, left[0]));
                return Err(named.unwrap_or(other));
            }
        };
        gone += found.way;
        (*state, last) = (found.state, Some(found.energy));
        if gone > beside::FOLLOWED && beside::is_near(scene.bed, state) {
            return Ok(Descent { steps: step + 1, is_found: false });
        }
    }
    Ok(Descent { steps: most, is_found: true })
}

/// Detects a sheet that has grown beyond any equilibrium. The tension T = k (l - L) of springs grows more slowly than p
/// R, so that a soft sheet supports only a limited pressure, like a balloon.
fn burst(bed: &Bed, state: &State) -> Option<Fault> {
    let [a, b] = bed.lattice.size;
    let share = |sheet: &Vec<Vec3<f64>>| {
        membrane::areas(&bed.lattice, sheet).into_iter().map(norm).sum::<f64>() / (a * b)
    };
    let shares = state.sheets.iter().map(share).enumerate();
    let (tile, most) = shares.max_by(|x, y| x.1.total_cmp(&y.1))?;
    (most > LARGEST).then_some(Fault::Burst(tile, most))
}

/// Detects a residual due to rounding: positions are known to an ulp of the sheet's size, forces to that times a
/// stiffness.
fn rounded(scene: &Scene, left: f64) -> Option<Fault> {
    let lattice = &scene.bed.lattice;
    let springs = lattice.springs.iter().map(|spring| spring.stiffness);
    let layers = scene.body.segments.iter().map(|segment| segment.foundation * lattice.cell());
    let stiffest = springs.chain(layers).fold(0.0, f64::max);
    let known = f64::EPSILON * stiffest * lattice.size[0].max(lattice.size[1]);
    let calm = scene.calm();
    (known > 0.1 * calm && left < 100.0 * known).then_some(Fault::Rounded(stiffest, [left, calm]))
}

/// Adds the index of the tile to a collapse.
fn named<T>(results: Vec<Result<T, Collapsed>>) -> Result<Vec<T>, Fault> {
    let named =
        |(tile, result): (usize, Result<T, Collapsed>)| result.map_err(|c| Fault::Collapsed(tile, c.0));
    results.into_iter().enumerate().map(named).collect()
}

fn energy(scene: &Scene, state: &State) -> Result<f64, Fault> {
    let one = |tile| Patch::new(scene, state, tile).energy();
    let tiles = named(side_by_side::run(scene.bed.tiles.len(), one))?;
    let motion = scene.increment.map_or(0.0, |i| i.body_energy(scene.body, &state.segments));
    let met: f64 = scene.met.iter().map(|m| m.energy(scene.bed, &state.sheets)).sum();
    let rubbed: f64 = state.rubs.iter().map(|rub| rub.energy(scene.bed, &state.sheets)).sum();
    Ok(tiles.iter().sum::<f64>() + scene.body.energy(&state.segments, GRAVITY) + motion + met + rubbed)
}

fn eliminate(scene: &Scene, state: &State, calm: f64) -> Result<Vec<Option<Eliminated>>, Fault> {
    let one = |tile| Patch::new(scene, state, tile).eliminate(calm);
    named(side_by_side::run(scene.bed.tiles.len(), one))
}

/// Largest residual force on a node and on a segment.
fn left_over(body: &Body, rows: &Rows, tiles: &[Option<Eliminated>]) -> [f64; 2] {
    let nodes = tiles.iter().flatten().flat_map(|t| &t.gradient).fold(0.0_f64, |most, g| most.max(g.abs()));
    let mut most = 0.0_f64;
    for (index, segment) in body.segments.iter().enumerate() {
        for k in (0..6).filter(|k| segment.free[*k]) {
            let arm = if k < 3 { 1.0 } else { 10.0 };
            most = most.max(arm * rows.gradient[6 * index + k].abs());
        }
    }
    [nodes, most]
}

/// Derivative of the energy along a step, at a state.
fn slope(scene: &Scene, state: &State, ways: &Ways) -> Result<f64, Fault> {
    let one = |tile| Patch::new(scene, state, tile).gradient();
    let (nodes, bonds): (Vec<_>, Vec<_>) =
        named(side_by_side::run(scene.bed.tiles.len(), one))?.into_iter().unzip();
    let mut rows = of_body(scene, state);
    for bond in bonds.iter().flatten() {
        rows.add_gradient(bond.segment, bond.arm, bond.pull.gradient, -1.0);
    }
    Ok(ways.slope(&nodes, &rows))
}

/// Result of a line search.
struct Found {
    state: State,
    energy: f64,
    /// Largest displacement of a node (m).
    way: f64,
}

/// Finds a fraction of the step that lowers the energy. If the energy changes only by rounding, its slope decides: it
/// must have become less steep (approximate Wolfe conditions, Hager and Zhang 2005). Near a neighbour a sheet moves
/// only as far as its contacts are known.
fn search(
    scene: &Scene,
    state: &State,
    ways: &Ways,
    before: f64,
    steepness: f64,
) -> Result<Option<Found>, Fault> {
    let rounding = 1e-11 * (1.0 + before.abs());
    let longest = ways.longest();
    let mut share = (LONGEST / longest).min(1.0);
    for _ in 0..40 {
        let (next, way) = (ways.taken(scene.bed, state, share), share * longest);
        if way > beside::FOLLOWED && beside::is_near(scene.bed, &next) {
            share = (0.5 * share).max(0.99 * beside::FOLLOWED / longest);
            continue;
        }
        // A bladder that collapses on the way is rejected like a rise of the energy.
        if let Ok(after) = energy(scene, &next)
            && after <= before + rounding
        {
            let falls = after < before - rounding;
            // The slope of the parabola through both energies, if their difference exceeds rounding.
            let steep =
                if falls { 2.0 * (after - before) / share + steepness } else { slope(scene, &next, ways)? };
            if falls || steep <= 0.8 * steepness {
                let found = Found { state: next, energy: after, way };
                return go_on(scene, state, ways, (found, share, steep), [steepness, rounding]).map(Some);
            }
        }
        share *= 0.5;
    }
    Ok(None)
}

/// Extends a full step as long as the slope has hardly decreased. The curvature of tissue, which the Hessian neglects,
/// can make a bed much softer along a step than the Hessian says; every step would then be too short.
fn go_on(
    scene: &Scene,
    state: &State,
    ways: &Ways,
    (mut found, mut share, mut steep): (Found, f64, f64),
    [steepness, rounding]: [f64; 2],
) -> Result<Found, Fault> {
    let longest = ways.longest();
    while share >= 1.0 && steep < -0.5 * steepness && 2.0 * share * longest <= LONGEST {
        share *= 2.0;
        let (next, way) = (ways.taken(scene.bed, state, share), share * longest);
        if way > beside::FOLLOWED && beside::is_near(scene.bed, &next) {
            break;
        }
        let Ok(after) = energy(scene, &next) else { break };
        steep = slope(scene, &next, ways)?;
        if after > found.energy + rounding || steep > 0.5 * steepness {
            break;
        }
        found = Found { state: next, energy: after, way };
    }
    Ok(found)
}

/// Force on a fixed segment (N) and its derivative with respect to the segment's position (N/m), with all sheets in
/// equilibrium.
///
/// # Errors
/// [`Fault`].
pub fn stiffness(
    bed: &Bed,
    body: &Body,
    state: &State,
    segment: usize,
) -> Result<(Vec3<f64>, [Vec3<f64>; 3]), Fault> {
    let mut free = body.clone();
    free.segments[segment].free = [true; 6];
    let met = beside::meetings(bed, state);
    let scene = Scene { met: &met, ..Scene::at_rest(bed, &free) };
    let one = |tile| Patch::new(&scene, state, tile).exact().eliminate(0.0);
    let tiles = named(side_by_side::run(bed.tiles.len(), one))?;
    let rows = rows(&scene, state, &tiles);
    let size = rows.gradient.len();
    let condensed = condensed(&rows, &tiles, &Bridge::new(&tiles, size));
    let entry = |i: usize, j: usize| condensed[(6 * segment + i) * size + 6 * segment + j];
    let matrix = [0, 1, 2].map(|i| [0, 1, 2].map(|j| entry(i, j)));
    let gradient = [0, 1, 2].map(|i| rows.gradient[6 * segment + i]);
    let weight = [0.0, 0.0, body.segments[segment].mass * GRAVITY];
    Ok((sub(weight, gradient), matrix))
}
