//! Scene text -> [`Scene`]: shape or lists, ground and law, gas, method, step; the largest stable step is checked here.

use smartbed_runtime::advance::Method;
use smartbed_runtime::body::stable_step::FORMULA;
use smartbed_runtime::body::{Gas, Inflation, PressureForm};
use smartbed_runtime::contact::{ContactLaw, Ground};

use super::fields::Fields;
use super::lists::Lists;
use super::method::method_named;
use super::shape;
use super::simulation::{Simulation, Surroundings};

/// Everything that a run needs.
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
    /// Step (s).
    pub step: f64,
    /// Length of the run (s).
    pub seconds: f64,
    /// Steps between two rows of output.
    pub every: usize,
    /// Largest stable step (s), if the springs set one.
    pub largest_step: Option<f64>,
    /// What is allowed but should be known; for standard error.
    pub warnings: Vec<String>,
}

impl Scene {
    /// Whole steps in the run; a rest below a thousandth of a step is rounding.
    #[must_use]
    pub fn steps(&self) -> usize {
        (self.seconds / self.step - 1e-3).ceil().max(0.0) as usize
    }
}

/// w_max h above which energy compensation lets an undamped body gain energy from impact to impact:
/// measured on a bar of 50 masses and 20 bounces with Verlet, below 1 % at 0.1, 64 % at 0.5.
const COMPENSATION_FINE: f64 = 0.1;

/// Part of the shortest rest length within which points touch together.
const CLUSTER: f64 = 1e-11;

/// Every key of a scene: about the text; shape and its numbers, or lists; what is around the body; the run.
const KNOWN: &str = "format title \
    shape links length corners side bays height rings radius bands cells rows columns width depth elements E rho A \
    points springs rest_lengths facets masses mass fixed K C stretch tilt drop_height initial_velocity \
    g air_drag floor law mu eta e stiffness dissipation cluster_tolerance anchor plastic_alone massless \
    pressure pressure_form gas ambient exponent volume dead_volume \
    T seconds step method tolerance every allow_unstable";

/// Is the text at this path a scene and not a mechanism?
#[must_use]
pub fn is_scene(path: &std::path::Path) -> bool {
    if path.extension().is_some_and(|e| e == "json") {
        return true;
    }
    let text = std::fs::read_to_string(path).unwrap_or_default();
    // A text that cannot be read is a mechanism's: its reader explains best.
    let table = text.parse::<toml::Table>().unwrap_or_default();
    table.contains_key("shape") || table.get("points").is_some_and(toml::Value::is_array)
}

/// Reads the scene at a path, or the one of that name under models/scenes.
///
/// # Errors
/// Where it was looked for, or what is wrong in it.
pub fn open(path_or_name: &str, settings: &[String]) -> Result<Scene, String> {
    let named = format!("models/scenes/{path_or_name}.toml");
    let path = if std::path::Path::new(path_or_name).is_file() { path_or_name } else { named.as_str() };
    let text = std::fs::read_to_string(path).map_err(|e| {
        format!(
            "no scene `{path_or_name}`: neither a file nor {named} ({e}); name a file or one of models/scenes"
        )
    })?;
    parse(path, &text, settings)
}

/// Reads a scene text.
///
/// # Errors
/// A message with file, line, what was expected.
pub fn parse(path: &str, text: &str, settings: &[String]) -> Result<Scene, String> {
    let mut fields = Fields::parse(path, text)?;
    if !path.ends_with(".json") {
        fields.refuse_unknown(KNOWN)?;
        if fields.get("format").and_then(serde_json::Value::as_u64) != Some(1) {
            return Err(fields.error("format", "expected format = 1"));
        }
    }
    for assignment in settings {
        fields.set(assignment)?;
        fields.refuse_unknown_name(assignment, KNOWN)?;
    }
    let mut lists = read_body(&fields)?;
    let around = read_surroundings(&fields, &mut lists)?;
    let mut scene = Scene {
        title: fields.word("title", path)?.to_string(),
        around,
        method: read_method(&fields)?,
        step: fields.number("step", 1e-3)?,
        seconds: fields.not_negative("T", fields.not_negative("seconds", 3.0)?)?,
        every: fields.count("every", 1, 1)?,
        largest_step: None,
        warnings: Vec::new(),
        lists,
    };
    if scene.step <= 0.0 {
        return Err(fields.error("step", "expected a step > 0 [s]"));
    }
    check_step(&fields, &mut scene)?;
    choose_anchor(&fields, &mut scene)?;
    scene.warnings.extend(warn_of_gain(path, &scene));
    Ok(scene)
}

/// Part of the largest stable step up to which the ledger anchor helps; above it, it harms.
const ANCHOR_STEP: f64 = 0.25;

/// Without a word about it, methods that let the energy of an undamped body drift are anchored to the ledger at
/// each touch: Verlet lifts it there, Runge-Kutta and Nystrom damp it. A damped body cannot be anchored.
fn choose_anchor(fields: &Fields, scene: &mut Scene) -> Result<(), String> {
    let damped = scene.around.air_drag > 0.0 || scene.lists.damping.iter().any(|c| *c > 0.0);
    let small = scene.largest_step.is_some_and(|largest| scene.step <= ANCHOR_STEP * largest);
    let Some(ContactLaw::Compensation { anchor, .. }) = scene.around.ground.as_mut().map(|g| &mut g.law)
    else {
        return Ok(());
    };
    if *anchor && damped {
        let message =
            "a damped body has no energy to be anchored to; set C = 0 and air_drag = 0, or anchor = false";
        return Err(fields.error("anchor", message));
    }
    if fields.get("anchor").is_none() {
        let drifts = matches!(scene.method, Method::Verlet | Method::Rk4 | Method::Nystrom4);
        *anchor = drifts && !damped && small;
    }
    Ok(())
}

/// Computes the largest stable step and refuses a larger one.
fn check_step(fields: &Fields, scene: &mut Scene) -> Result<(), String> {
    let probe = Simulation::<f64>::new(&scene.lists, &scene.around, scene.method)
        .map_err(|e| fields.error("shape", &format!("{e:?}")))?;
    scene.largest_step = probe.largest_stable_step();
    let adaptive = scene.method.control_order() > 0;
    if let Some(largest) =
        scene.largest_step.filter(|_| !adaptive && !fields.flag("allow_unstable").unwrap_or(false))
        && scene.step > largest * (1.0 + 1e-12)
    {
        let message = format!(
            "{} s is larger than the largest stable step {largest:.6e} s: {FORMULA}; take a smaller step or say allow_unstable = true",
            scene.step
        );
        return Err(fields.error("step", &message));
    }
    Ok(())
}

/// Says so where energy compensation and the step's own energy error add up. The method that keeps the
/// energy exactly has none; a damped body loses it again.
fn warn_of_gain(path: &str, scene: &Scene) -> Option<String> {
    let compensated = matches!(scene.around.ground?.law, ContactLaw::Compensation { eta, .. } if eta > 0.0);
    let damped = scene.around.air_drag > 0.0 || scene.lists.damping.iter().any(|c| *c > 0.0);
    let exact = matches!(scene.method, Method::EnergyMomentum) || scene.method.control_order() > 0;
    let stiffness = 2.0 * scene.step / scene.largest_step?;
    (compensated && !damped && !exact && stiffness > COMPENSATION_FINE * (1.0 + 1e-9)).then(|| {
        format!(
            "{path}: `step`: w_max h = {stiffness:.2} with energy compensation on an undamped body: above \
             {COMPENSATION_FINE} it may gain energy from impact to impact; take a step up to {:.1e} s, \
             method = \"energy_momentum\" or law = \"massless_point\"",
            scene.step * COMPENSATION_FINE / stiffness
        )
    })
}

fn read_body(fields: &Fields) -> Result<Lists, String> {
    let mut lists = match fields.get("shape") {
        Some(_) => read_shape(fields)?,
        None => read_lists(fields)?,
    };
    let n = lists.points.len();
    if lists.stiffness.is_empty() {
        lists.stiffness = fields.numbers("K", 5000.0, lists.springs.len())?;
        if fields.get("masses").is_some() || fields.get("mass").is_some() {
            let key = if fields.get("masses").is_some() { "masses" } else { "mass" };
            lists.masses = fields.numbers(key, 1.0, n)?;
        }
    }
    lists.damping = fields.numbers("C", 0.0, lists.springs.len())?;
    // `points` of a reference file already stand at their height.
    let raise = if fields.get("points").is_some() { 0.0 } else { fields.number("drop_height", 0.0)? };
    let tilt = fields.number("tilt", 0.0)?;
    for point in &mut lists.points {
        let [x, z] = [point[0], point[2]];
        point[0] = x * tilt.cos() - z * tilt.sin();
        point[2] = x * tilt.sin() + z * tilt.cos() + raise;
    }
    if let Some(fixed) = fields.points("fixed", n)? {
        fixed.into_iter().for_each(|p| lists.fixed[p] = true);
    }
    let velocity = read_vector(fields, "initial_velocity", 0.0)?;
    lists.velocities = lists.fixed.iter().map(|fixed| if *fixed { [0.0; 3] } else { velocity }).collect();
    if let Some(stretch) = fields.get("stretch") {
        let factor = stretch.as_f64().unwrap_or(1.0);
        lists.rest_lengths.iter_mut().for_each(|l| *l /= factor);
    }
    Ok(lists)
}

/// A vector, or a number for its z component.
fn read_vector(fields: &Fields, key: &str, default: f64) -> Result<[f64; 3], String> {
    match fields.get(key) {
        Some(serde_json::Value::Array(items)) => {
            let list: Option<Vec<f64>> = items.iter().map(serde_json::Value::as_f64).collect();
            let vector: Option<[f64; 3]> = list.and_then(|l| l.try_into().ok());
            vector.ok_or_else(|| fields.error(key, "expected a number (its z component) or three numbers"))
        }
        _ => Ok([0.0, 0.0, fields.number(key, default)?]),
    }
}

fn read_lists(fields: &Fields) -> Result<Lists, String> {
    let Some(points) = fields.rows::<3>("points")? else {
        return Err(
            fields.error("shape", "a scene needs a `shape` or `points`, `springs` and `rest_lengths`")
        );
    };
    let mut lists = Lists::default();
    points.into_iter().for_each(|p| {
        lists.point(p);
    });
    for (row, [tail, head]) in fields.rows::<2>("springs")?.unwrap_or_default().into_iter().enumerate() {
        let n = lists.points.len() as f64;
        if tail < 0.0 || head < 0.0 || tail >= n || head >= n || tail.fract() != 0.0 || head.fract() != 0.0 {
            let message =
                format!("spring {row} joins {tail} and {head}, but the points are 0 to {}", n - 1.0);
            return Err(fields.error("springs", &message));
        }
        lists.spring(tail as usize, head as usize);
    }
    if fields.get("rest_lengths").is_some() {
        lists.rest_lengths = fields.numbers("rest_lengths", 0.0, lists.springs.len())?;
    }
    for [a, b, c, d] in fields.rows::<4>("facets")?.unwrap_or_default() {
        lists.facets.push([a as usize, b as usize, c as usize, d as usize]);
    }
    Ok(lists)
}

fn read_shape(fields: &Fields) -> Result<Lists, String> {
    let length = |key: &str, default: f64| {
        let x = fields.number(key, default)?;
        if x > 0.0 { Ok(x) } else { Err(fields.error(key, &format!("expected a length > 0, found {x}"))) }
    };
    let side = length("side", 1.0)?;
    match fields.word("shape", "")? {
        "chain" => Ok(shape::chain(fields.count("links", 1, 1)?, length("length", 1.0)?)),
        "polygon" => Ok(shape::polygon(fields.count("corners", 3, 3)?, side)),
        "truss" => Ok(shape::truss(fields.count("bays", 2, 1)?, side)),
        "prism" => Ok(shape::prism(side, length("height", 1.0)?)),
        "cube" => Ok(shape::cube(side)),
        "cylinder" => Ok(shape::cylinder(
            fields.count("corners", 8, 3)?,
            fields.count("rings", 2, 1)?,
            length("radius", 0.5)?,
            length("height", 1.0)?,
        )),
        "ball" => {
            Ok(shape::ball(fields.count("corners", 8, 3)?, fields.count("bands", 6, 2)?, length("radius", 0.5)?))
        }
        "cubes" => {
            let cells = fields.rows::<3>("cells")?.and_then(|rows| rows.first().copied());
            let [n, m, k] = cells.unwrap_or([2.0, 1.0, 1.0]).map(|c| c.max(1.0) as usize);
            Ok(shape::cubes(n, m, k, side))
        }
        "sheet" => Ok(shape::sheet(
            fields.count("rows", 27, 1)?,
            fields.count("columns", 27, 1)?,
            length("width", 1.4)?,
            length("depth", 1.4)?,
        )),
        "bar" => Ok(shape::bar(
            fields.count("elements", 50, 1)?,
            length("length", 10.0)?,
            length("E", 900.0)?,
            length("rho", 1.0)?,
            length("A", 1.0)?,
        )),
        other => Err(fields.error(
            "shape",
            &format!(
                "unknown shape `{other}`; known: chain, polygon, truss, prism, cube, cylinder, ball, cubes, sheet, bar"
            ),
        )),
    }
}

fn read_surroundings(fields: &Fields, lists: &mut Lists) -> Result<Surroundings, String> {
    Ok(Surroundings {
        gravity: match fields.get("g") {
            Some(serde_json::Value::Array(_)) => read_vector(fields, "g", 0.0)?,
            _ => [0.0, 0.0, -fields.number("g", 9.81)?],
        },
        air_drag: fields.not_negative("air_drag", 0.0)?,
        ground: read_ground(fields, lists)?,
        inflation: read_inflation(fields)?,
    })
}

fn read_ground(fields: &Fields, lists: &mut Lists) -> Result<Option<Ground<f64>>, String> {
    let law_word = fields.word("law", "compensation")?;
    if law_word == "none" {
        return Ok(None);
    }
    let unit = |key: &str, default: f64| {
        let x = fields.not_negative(key, default)?;
        if x <= 1.0 { Ok(x) } else { Err(fields.error(key, &format!("expected 0 to 1, found {x}"))) }
    };
    let stiffness = fields.not_negative("stiffness", 1e5)?;
    let law = match law_word {
        "newton" => ContactLaw::Newton { restitution: unit("e", 0.0)? },
        "moreau" => ContactLaw::Moreau { restitution: unit("e", 0.0)? },
        "penalty" => ContactLaw::Penalty { stiffness },
        "hunt_crossley" => {
            ContactLaw::HuntCrossley { stiffness, dissipation: fields.not_negative("dissipation", 0.0)? }
        }
        "massless_point" => {
            let lowest = lists.points.iter().map(|p| p[2]).fold(f64::INFINITY, f64::min);
            let default = (0..lists.points.len()).filter(|p| lists.points[*p][2] <= lowest + 1e-9).collect();
            let massless = fields.points("massless", lists.points.len())?.unwrap_or(default);
            lists.redistribute(&massless).map_err(|e| fields.error("massless", &e))?;
            ContactLaw::MasslessPoint
        }
        // The references write "EC-P, frictionless floor ...".
        word if word == "compensation" || word.starts_with("EC-P") => ContactLaw::Compensation {
            eta: unit("eta", 1.0)?,
            anchor: fields.flag("anchor")?,
            plastic_alone: fields.flag("plastic_alone")?,
        },
        other => {
            return Err(fields.error(
                "law",
                &format!(
                    "unknown law `{other}`; known: compensation, massless_point, moreau, newton, penalty, hunt_crossley, none"
                ),
            ));
        }
    };
    let (normal, offset) = read_floor(fields)?;
    let shortest = lists.rest_lengths.iter().copied().filter(|l| *l > 0.0).fold(1.0, f64::min);
    let tolerance = fields.not_negative("cluster_tolerance", CLUSTER * shortest)?;
    Ok(Some(Ground { normal, offset, law, friction: fields.not_negative("mu", 0.0)?, tolerance }))
}

fn read_floor(fields: &Fields) -> Result<([f64; 3], f64), String> {
    let Some(floor) = fields.get("floor") else { return Ok(([0.0, 0.0, 1.0], 0.0)) };
    let expected = || fields.error("floor", "expected { normal = [x, y, z], offset = metres }");
    let normal: Option<Vec<f64>> = (floor.get("normal").and_then(serde_json::Value::as_array))
        .map_or(Some(vec![0.0, 0.0, 1.0]), |n| n.iter().map(serde_json::Value::as_f64).collect());
    let normal: [f64; 3] = normal.and_then(|n| n.try_into().ok()).ok_or_else(expected)?;
    let length = normal.iter().map(|c| c * c).sum::<f64>().sqrt();
    let offset = floor.get("offset").map_or(Some(0.0), serde_json::Value::as_f64).ok_or_else(expected)?;
    if length > 0.0 { Ok((normal.map(|c| c / length), offset)) } else { Err(expected()) }
}

fn read_inflation(fields: &Fields) -> Result<Option<Inflation<f64>>, String> {
    if fields.get("pressure").is_none() {
        return Ok(None);
    }
    let pressure = fields.number("pressure", 0.0)?;
    let form = match fields.word("pressure_form", "exact")? {
        "exact" => PressureForm::Exact,
        "facet" => PressureForm::Facet,
        "fan" => PressureForm::Fan,
        other => {
            let message = format!("unknown form `{other}`; known: exact, facet, fan (Eq. 3.10 as printed)");
            return Err(fields.error("pressure_form", &message));
        }
    };
    let gas = match fields.word("gas", "constant")? {
        "constant" => Gas::Constant(pressure),
        "polytropic" => Gas::Polytropic {
            pressure,
            ambient: fields.number("ambient", 101_325.0)?,
            volume: fields.number("volume", 1.0)?,
            exponent: fields.number("exponent", 1.4)?,
            dead_volume: fields.number("dead_volume", 0.0)?,
        },
        other => {
            return Err(fields.error("gas", &format!("unknown gas `{other}`; known: constant, polytropic")));
        }
    };
    Ok(Some(Inflation { gas, form }))
}

fn read_method(fields: &Fields) -> Result<Method<f64>, String> {
    let tolerance = fields.number("tolerance", 1e-9)?;
    method_named(fields.word("method", "energy_momentum")?, tolerance).map_err(|e| fields.error("method", &e))
}
