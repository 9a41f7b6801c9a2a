//! The cost sheet of a scene: operations counted and time taken over its first steps.

use super::clock;
use super::sheet::{Cost, Sheet, Variant};
use crate::scene::describe::describe;
use crate::scene::run::open_ledger;
use crate::scene::{Scene, Simulation, read};
use smartbed_codegen::words;
use smartbed_runtime::real::Scalar;
use smartbed_runtime::real::counting::{Counting, count};

/// Springs times steps to be counted; it sets the number of steps, within limits.
const WORK: usize = 200_000;
const STEPS: [usize; 2] = [20, 1000];
/// The fastest of this many runs counts.
const REPEATS: usize = 5;
/// A damper, drag, friction or pressure too small to affect the motion.
const NOTHING: &str = "1e-12";

/// Makes the sheet of `scene`, read from `path` with `settings`.
///
/// # Errors
/// Why the scene could not be run, in words.
pub fn make(scene: &Scene, path: &str, settings: &[String]) -> Result<Sheet, String> {
    let (left_out, everything) = rest(scene);
    let full = read::open_varied(path, settings, &everything)?;
    let costs = [cost(scene, false)?, cost(&full, true)?];
    let lists = &scene.lists;
    let asked = format!(
        "{}, {}, {}; {}; step {:e} s",
        words::count(lists.points.len(), "point"),
        words::count(lists.springs.len(), "spring"),
        words::count(if scene.around.inflation.is_some() { lists.facets.len() } else { 0 }, "facet"),
        scene.chosen.name,
        scene.step
    );
    Ok(Sheet {
        asked,
        left_out: left_out.join(", "),
        costs,
        everything: Variant { set: everything, everything: false },
    })
}

/// What the scene does not use, and the settings that turn it on.
fn rest(scene: &Scene) -> (Vec<&'static str>, Vec<String>) {
    let around = &scene.around;
    let mut rest = vec![("ledger of 7 accounts", None)];
    let mut lacks = |is_lacking: bool, what: &'static str, setting: String| {
        if is_lacking {
            rest.push((what, Some(setting)));
        }
    };
    lacks(scene.lists.damping.iter().all(|c| *c == 0.0), "dampers", format!("C={NOTHING}"));
    lacks(around.air_drag == 0.0, "air", format!("air_drag={NOTHING}"));
    lacks(around.ground.is_none(), "ground", "law=compensation".to_owned());
    // A ground far below: every gap is evaluated, none closes.
    let below = "floor={\"normal\":[0,0,1],\"offset\":-1000}".to_owned();
    lacks(around.ground.is_none(), "touches", below);
    lacks(around.ground.is_none_or(|g| g.friction == 0.0), "friction", format!("mu={NOTHING}"));
    let has_facets = !scene.lists.facets.is_empty();
    lacks(has_facets && around.inflation.is_none(), "gas", format!("pressure={NOTHING}"));
    let names = rest.iter().map(|(name, _)| *name).collect();
    (names, rest.into_iter().filter_map(|(_, setting)| setting).collect())
}

/// Operations and time of a step, averaged over the first ones.
fn cost(scene: &Scene, ledger: bool) -> Result<Cost, String> {
    let steps = (WORK / scene.lists.springs.len().max(1)).clamp(STEPS[0], STEPS[1]).min(scene.steps().max(1));
    let (done, operations) = count(|| steps_of::<Counting>(scene, steps, ledger));
    done?;
    let mut nanoseconds = f64::INFINITY;
    for _ in 0..REPEATS {
        nanoseconds = nanoseconds.min(steps_of::<f64>(scene, steps, ledger)?);
    }
    Ok(Cost { operations: operations.total() as f64 / steps as f64, nanoseconds })
}

/// Takes steps; returns the time of one (ns).
fn steps_of<S: Scalar>(scene: &Scene, steps: usize, observed: bool) -> Result<f64, String> {
    let mut simulation =
        Simulation::<S>::new(&scene.lists, &scene.around, scene.method).map_err(|e| describe(&e))?;
    let h = S::from_f64(scene.step);
    let mut ledger = open_ledger(&simulation);
    let begin = clock::now();
    simulation.begin(h, &mut ()).map_err(|e| describe(&e))?;
    for _ in 0..steps {
        let done = if observed { simulation.step(h, &mut ledger) } else { simulation.step(h, &mut ()) };
        done.map_err(|e| describe(&e))?;
    }
    Ok((clock::now() - begin).as_nanos() as f64 / steps as f64)
}
