//! Scene text -> [`Scene`]: shape or lists, ground and law, gas, method, step; checks the largest stable step.

pub mod body;
mod surroundings;
mod view;

pub use surroundings::AMBIENT;

use smartbed_codegen::words::count;
use smartbed_runtime::contact::ContactLaw;
use smartbed_runtime::contact::stable_step::FORMULA;
use smartbed_runtime::flexible::BodyError;
use smartbed_runtime::ode::nodes::{Method, Step};

use super::describe::describe;
use super::fields::Fields;
use super::keys::{self, Choice};
use super::lists::Lists;
use super::method::{self, Chosen, Situation};
use super::simulation::{Simulation, Surroundings};
use super::surface::open_edges;
use crate::input;
use crate::number::six_digits;

/// A scene, ready to run.
#[derive(Clone, Debug)]
pub struct Scene {
    /// One line about it.
    pub title: String,
    /// The body.
    pub lists: Lists,
    /// Gravity, air, ground, gas.
    pub around: Surroundings,
    /// Method of integration.
    pub method: Method<f64>,
    /// Its name, its order here, and why it was chosen.
    pub chosen: Chosen,
    /// Step (s).
    pub step: f64,
    /// Length of the run (s).
    pub seconds: f64,
    /// Steps per row of output.
    pub every: usize,
    /// Largest stable step (s), if the springs limit it.
    pub largest_step: Option<f64>,
    /// Options for pictures.
    pub view: view::View,
    /// Warnings, for standard error.
    pub warnings: Vec<String>,
}

impl Scene {
    /// Number of steps in the run, the last one perhaps shorter. A remainder below a thousandth of a step is rounding,
    /// but there is at least one step.
    #[must_use]
    pub fn steps(&self) -> usize {
        let whole = (self.seconds / self.step - ROUNDING).ceil().max(0.0) as usize;
        if self.seconds > 0.0 { whole.max(1) } else { 0 }
    }

    /// Length of the last step (s).
    #[must_use]
    pub fn last_step(&self) -> f64 {
        let left = self.seconds - self.steps().saturating_sub(1) as f64 * self.step;
        if left < (1.0 - ROUNDING) * self.step { left } else { self.step }
    }

    /// Method and step as text.
    #[must_use]
    pub fn note(&self) -> String {
        format!("{}, step {} s", self.chosen.name, six_digits(self.step))
    }
}

/// w_max h above which energy compensation lets an undamped body gain energy from impact to impact: measured on a bar
/// of 50 masses and 20 bounces with Verlet, below 1 % at 0.1, 64 % at 0.5.
const COMPENSATION_FINE: f64 = 0.1;

/// A remainder of the time below this fraction of a step is rounding.
const ROUNDING: f64 = 1e-3;

/// Most steps of a run.
const MOST_STEPS: f64 = 1e9;

/// Reads the scene at a path, or the one of that name under models/scenes.
///
/// # Errors
/// The places where it was searched for, or what is wrong in it.
pub fn open(path_or_name: &str, settings: &[String]) -> Result<Scene, String> {
    refuse_twice(settings)?;
    open_varied(path_or_name, settings, &[])
}

/// Refuses two settings of one key, the first of which would be ignored.
fn refuse_twice(settings: &[String]) -> Result<(), String> {
    let mut fields = Fields::parse("", "")?;
    let mut keys: Vec<String> = Vec::new();
    for setting in settings {
        let key = fields.set(setting)?;
        if keys.contains(&key) {
            return Err(fields.error(&key, &format!("`{key}` is set twice; leave one of them out")));
        }
        keys.push(key);
    }
    Ok(())
}

/// As [`open()`], then changed by more settings, which may choose another law or method than the first ones.
///
/// # Errors
/// As [`open()`].
pub fn open_varied(path_or_name: &str, settings: &[String], variation: &[String]) -> Result<Scene, String> {
    let named = format!("models/scenes/{path_or_name}.toml");
    let path = if std::path::Path::new(path_or_name).is_file() { path_or_name } else { named.as_str() };
    let text = input::text(path).map_err(|e| {
        format!(
            "no scene `{path_or_name}`: neither a file nor {named} ({e}); name a file or one of models/scenes"
        )
    })?;
    parse_varied(path, &text, [settings, variation])
}

/// Reads a scene text.
///
/// # Errors
/// A message with file, line and what was expected.
pub fn parse(path: &str, text: &str, settings: &[String]) -> Result<Scene, String> {
    parse_varied(path, text, [settings, &[]])
}

fn parse_varied(path: &str, text: &str, layers: [&[String]; 2]) -> Result<Scene, String> {
    let mut fields = Fields::parse(path, text)?;
    if fields.is_json() {
        leave_out_results(&mut fields);
    } else if fields.get("format").and_then(serde_json::Value::as_u64) != Some(1) {
        return Err(fields.error("format", "expected format = 1; 2 is that of scenes with `parts`"));
    }
    let keys: Vec<String> = fields.keys().cloned().collect();
    refuse_unread(&fields, &keys)?;
    for settings in layers {
        override_by(&mut fields, settings)?;
    }
    forget_unread(&mut fields)?;
    let mut lists = body::read(&fields)?;
    let dampers = count_dampers(&lists);
    let around = surroundings::read(&fields, &mut lists)?;
    let left_out = dampers - count_dampers(&lists);
    let step = fields.positive("step", 1e-3)?;
    let bound = |method: &str| {
        let place = if fields.get("shape").is_some() { "shape" } else { "points" };
        largest_step(&lists, &around, method).map_err(|e| fields.error(place, &describe(&e)))
    };
    let largest_step = bound("verlet")?;
    let situation = Situation::new(&around, &lists.damping, largest_step.map_or(0.0, |h| step / h));
    let chosen = read_method(&fields, &situation)?;
    let largest_step = if method::solves_dampers(chosen.name) { bound(chosen.name)? } else { largest_step };
    let mut scene = Scene {
        title: fields.word("title", path)?.to_string(),
        around,
        method: chosen.method,
        chosen,
        step,
        seconds: fields.not_negative("T", 3.0)?,
        every: fields.count("every", 1, 1)?,
        largest_step,
        view: view::read(&fields)?,
        warnings: Vec::new(),
        lists,
    };
    if scene.seconds / scene.step > MOST_STEPS {
        let message = format!(
            "{} s in steps of {} s are more than {MOST_STEPS:e} steps; take a larger step",
            scene.seconds, scene.step
        );
        return Err(fields.error("step", &message));
    }
    check_step(&fields, &scene)?;
    choose_anchor(&fields, &mut scene)?;
    scene.warnings.extend(warn_of_gain(path, &scene));
    scene.warnings.extend(warn_of_rim(path, &scene));
    if left_out > 0 {
        scene.warnings.push(fields.error(
            "C",
            &format!(
                "{left_out} of {} left out: a spring at a massless point has none, because the point's position follows from \
                 forces without speeds",
                count(dampers, "damper")
            ),
        ));
    }
    Ok(scene)
}

/// Removes the motion that a reference file contains besides the scene; its points are already in their initial
/// position.
fn leave_out_results(fields: &mut Fields) {
    keys::OF_REFERENCES.split_whitespace().for_each(|key| fields.remove(key));
    if fields.get("points").is_some() {
        fields.remove("drop_height");
    }
}

/// Sets keys. A key that is set but not read is refused.
fn override_by(fields: &mut Fields, settings: &[String]) -> Result<(), String> {
    let set = settings.iter().map(|setting| fields.set(setting)).collect::<Result<Vec<String>, String>>()?;
    match set.iter().any(|key| key == "format") {
        true => Err(fields.error("format", "the text has its format; leave it out")),
        false => refuse_unread(fields, &set),
    }
}

/// Refuses the first key that is not read.
fn refuse_unread(fields: &Fields, keys: &[String]) -> Result<(), String> {
    let choices = choices(fields)?;
    match keys.iter().find_map(|key| Some((key, keys::complaint(key, &choices)?))) {
        Some((key, complaint)) => Err(fields.error(key, &complaint)),
        None => Ok(()),
    }
}

/// Removes keys that were read with the previous choices (law, shape) only.
fn forget_unread(fields: &mut Fields) -> Result<(), String> {
    let read: Vec<&str> = keys::read_with(&choices(fields)?).collect();
    let unread: Vec<String> = fields.keys().filter(|k| !read.contains(&k.as_str())).cloned().collect();
    unread.iter().for_each(|key| fields.remove(key));
    Ok(())
}

/// The choices that the scene makes.
fn choices(fields: &Fields) -> Result<Vec<Choice>, String> {
    let mut choices = vec![match fields.get("shape") {
        None => Choice::Lists,
        Some(_) => Choice::Shape(body::shape(fields)?),
    }];
    let law = surroundings::law(fields)?;
    choices.push(Choice::Law(law));
    // Moreau's law is a method of its own: a scene with it names no other.
    if law != "moreau" {
        // No default method is adaptive.
        let adaptive = match named_method(fields)? {
            Some(name) => method::is_adaptive(name).map_err(|e| fields.error("method", &e))?,
            None => false,
        };
        choices.push(if adaptive { Choice::AdaptiveStep } else { Choice::FixedStep });
    }
    if fields.get("pressure").is_some() {
        choices.extend([Choice::Pressure, Choice::Gas(surroundings::gas(fields)?)]);
    }
    Ok(choices)
}

/// Fraction of the largest stable step up to which anchoring to the ledger helps; above it, it harms.
const ANCHOR_STEP: f64 = 0.25;

/// Sets the default of `anchor`: for an undamped body, methods whose energy drifts are corrected to the ledger's total
/// at each touch. With Verlet the correction adds energy, with Runge-Kutta and Nystrom it removes some. A damped body
/// cannot be anchored.
fn choose_anchor(fields: &Fields, scene: &mut Scene) -> Result<(), String> {
    let damped = scene.around.air_drag > 0.0 || scene.lists.damping.iter().any(|c| *c > 0.0);
    let small = scene.largest_step.is_some_and(|largest| scene.step <= ANCHOR_STEP * largest);
    let Some(ContactLaw::Compensation { anchor, .. }) = scene.around.ground.as_mut().map(|g| &mut g.law)
    else {
        return Ok(());
    };
    if *anchor && damped {
        let message = "`anchor` restores the total energy of the start, which a damped body loses; set C = 0 and air_drag = \
             0, or anchor = false";
        return Err(fields.error("anchor", message));
    }
    if fields.get("anchor").is_none() {
        let drifts = matches!(scene.method, Method::Verlet | Method::Rk4 | Method::Nystrom4);
        *anchor = drifts && !damped && small;
    }
    Ok(())
}

/// Largest stable step (s) of a method, if there is one. Dampers do not limit a method that treats them implicitly.
///
/// # Errors
/// A body that cannot be.
pub fn largest_step(
    lists: &Lists,
    around: &Surroundings,
    method: &str,
) -> Result<Option<f64>, BodyError<f64>> {
    let probe = |lists, around| Simulation::<f64>::new(lists, around, Method::Verlet);
    if method::solves_dampers(method) {
        let undamped = Lists { damping: vec![0.0; lists.damping.len()], ..lists.clone() };
        let airless = Surroundings { air_drag: 0.0, ..around.clone() };
        return Ok(probe(&undamped, &airless)?.largest_stable_step());
    }
    Ok(probe(lists, around)?.largest_stable_step())
}

/// Refuses a step larger than the stable one.
fn check_step(fields: &Fields, scene: &Scene) -> Result<(), String> {
    let adaptive = scene.method.control_order() > 0;
    if let Some(largest) =
        scene.largest_step.filter(|_| !adaptive && !fields.flag("allow_unstable").unwrap_or(false))
        && scene.step > largest * (1.0 + 1e-12)
    {
        let message = format!(
            "{} s is larger than the largest stable step {largest:.6e} s: {FORMULA}; take a smaller step{} or say allow_unstable = \
             true",
            scene.step,
            without_dampers(scene, largest)
        );
        return Err(fields.error("step", &message));
    }
    Ok(())
}

/// Number of springs with a damper.
fn count_dampers(lists: &Lists) -> usize {
    lists.damping.iter().filter(|c| **c > 0.0).count()
}

/// Advice for dampers that limit the step much more than springs do.
fn without_dampers(scene: &Scene, largest: f64) -> String {
    let situation = Situation::new(&scene.around, &scene.lists.damping, 0.0);
    let name = "damped_verlet";
    match largest_step(&scene.lists, &scene.around, name) {
        Ok(Some(step)) if step > 2.0 * largest && situation.order(name).is_ok() => {
            format!(", method = \"{name}\", which dampers do not limit (up to {step:.1e} s),")
        }
        _ => String::new(),
    }
}

/// A warning if a constant pressure acts on an open surface whose rim moves: its work then depends on the way, and no
/// energy stands for it.
fn warn_of_rim(path: &str, scene: &Scene) -> Option<String> {
    scene.around.inflation?;
    let open = open_edges(&scene.lists.facets);
    let point = open.keys().find(|point| !scene.lists.fixed[**point])?;
    Some(format!(
        "{path}: `pressure`: the surface is open and its rim, such as point {point}, is free: the pressure is a load that \
         follows the facets, without caps, and its work has no potential; the row `pressure` and the imbalance mean nothing"
    ))
}

/// A warning if energy compensation and the step's own energy error add up. A method that conserves energy exactly has
/// no such error; a damped body dissipates it.
fn warn_of_gain(path: &str, scene: &Scene) -> Option<String> {
    let compensated = matches!(scene.around.ground?.law, ContactLaw::Compensation { eta, .. } if eta > 0.0);
    let damped = scene.around.air_drag > 0.0 || scene.lists.damping.iter().any(|c| *c > 0.0);
    let exact = matches!(scene.method, Method::EnergyMomentum) || scene.method.control_order() > 0;
    let fine = if scene.method == Method::BlanesMoan4 { method::COARSE } else { COMPENSATION_FINE };
    let stiffness = 2.0 * scene.step / scene.largest_step?;
    (compensated && !damped && !exact && stiffness > fine * (1.0 + 1e-9)).then(|| {
        format!(
            "{path}: `step`: w_max h = {stiffness:.2} with energy compensation on an undamped body: above \
             {fine} it may gain energy from impact to impact; take a step up to {:.1e} s, \
             method = \"energy_momentum\" or law = \"massless_point\"",
            scene.step * fine / stiffness
        )
    })
}

/// The name of the method, if there is one.
fn named_method(fields: &Fields) -> Result<Option<&str>, String> {
    fields.get("method").map(|_| fields.word("method", "")).transpose()
}

fn read_method(fields: &Fields, situation: &Situation) -> Result<Chosen, String> {
    let tolerance = fields.positive("tolerance", 1e-9)?;
    method::choose(named_method(fields)?, tolerance, situation).map_err(|e| fields.error("method", &e))
}
