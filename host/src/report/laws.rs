//! The table of laws and methods, measured: two springs on top of each other fall, touch and leave, with every law and
//! method.
//!
//! Error: the largest of any position at the end, averaged over several heights of the fall so that the touch occurs at
//! different places within a step; against Dormand-Prince 8(5,3) at 1e-13 (Moreau's law: against itself, 128 times
//! finer). Order: slope of error over step, for adaptive methods over work.

use super::front::slope;
use super::point::Table;
use crate::scene::describe::describe;
use crate::scene::method::{Entry, METHODS, Row, TABLE};
use crate::scene::{Scene, Simulation, parse};

/// Heights of the fall (m).
const HEIGHTS: [f64; 9] = [0.1, 0.1037, 0.1071, 0.1113, 0.1159, 0.1191, 0.1213, 0.1267, 0.1289];
/// Length of a run (s): it contains the first touches and releases.
const SECONDS: f64 = 0.32;
/// Steps of the coarsest run, and number of runs, each with twice as many steps as the one before.
const STEPS: (u32, u32) = (80, 7);
/// Tolerances 10^-n of an adaptive method.
const TOLERANCES: std::ops::Range<i32> = 6..13;
/// Errors in the asymptotic range: above rounding, below those of coarse steps (m).
const LINE: std::ops::Range<f64> = 2e-12..3e-3;

/// One entry of the table and what was observed of it.
#[derive(Clone, Debug)]
pub struct Observation {
    /// The row.
    pub row: Row,
    /// The method.
    pub method: &'static str,
    /// The table's entry.
    pub entry: Entry,
    /// Order observed and the number of runs used, unless the combination is refused.
    pub observed: Option<(f64, usize)>,
}

/// The scene of a row: its law, with dampers in a damped one.
///
/// # Errors
/// As reading any scene.
pub fn scene(row: &Row, height: f64, settings: &[String]) -> Result<Scene, String> {
    let law = match row.law {
        "penalty" => "law = \"penalty\"\nstiffness = 2e4",
        "hunt_crossley" if row.damped => "law = \"hunt_crossley\"\nstiffness = 2e5\ndissipation = 0.3",
        "hunt_crossley" => "law = \"hunt_crossley\"\nstiffness = 2e5",
        "newton" => "law = \"newton\"\ne = 0.3",
        "moreau" => "law = \"moreau\"\ne = 0.0",
        "none" => "law = \"none\"\nstretch = 1.1",
        "massless_point" => "law = \"massless_point\"",
        _ => "law = \"compensation\"\nanchor = false",
    };
    // A ground that dissipates makes the scene damped without dampers.
    let dampers = if row.damped && !matches!(row.law, "hunt_crossley" | "moreau") { 2.0 } else { 0.0 };
    let unstable = if row.law == "moreau" { "" } else { "allow_unstable = true\n" };
    let text = format!(
        "format = 1\nshape = \"chain\"\nlinks = 2\ndrop_height = {height}\nK = 2000.0\nC = {dampers}\n\
         T = {SECONDS}\n{unstable}{law}\n"
    );
    parse("laws", &text, settings)
}

fn settings(method: &str, step: f64, tolerance: Option<f64>) -> Vec<String> {
    let mut settings = vec![format!("step={step:e}")];
    // Moreau's law is a time-stepping scheme of its own: there is no method to be named.
    settings.extend((method != "moreau").then(|| format!("method={method}")));
    settings.extend(tolerance.map(|e| format!("tolerance={e:e}")));
    settings
}

/// Positions at the end and force evaluations.
fn end(scene: &Scene) -> Result<(Vec<f64>, usize), String> {
    let mut simulation =
        Simulation::<f64>::new(&scene.lists, &scene.around, scene.method).map_err(|e| describe(&e))?;
    simulation.begin(scene.step, &mut ()).map_err(|e| describe(&e))?;
    let mut evaluations = 0;
    for _ in 0..scene.steps() {
        evaluations += simulation.step(scene.step, &mut ()).map_err(|e| describe(&e))?.evaluations;
    }
    Ok((simulation.pos().concat(), evaluations))
}

/// Mean evaluations and mean error over the heights.
fn error(row: &Row, truth: &[Vec<f64>], settings: &[String]) -> Result<(f64, f64), String> {
    let (mut sum, mut work) = (0.0, 0.0);
    for (height, truth) in HEIGHTS.iter().zip(truth) {
        let (found, evaluations) = end(&scene(row, *height, settings)?)?;
        sum += found.iter().zip(truth).map(|(x, t)| (x - t).abs()).fold(0.0, f64::max);
        work += evaluations as f64;
    }
    let n = HEIGHTS.len() as f64;
    Ok((work / n, sum / n))
}

fn observe_one(row: &Row, truth: &[Vec<f64>], method: &str, adaptive: bool) -> Result<(f64, usize), String> {
    let mut line = Vec::new();
    if adaptive {
        for n in TOLERANCES {
            let (work, error) = error(row, truth, &settings(method, SECONDS, Some(10.0_f64.powi(-n))))?;
            line.push((1.0 / work, error));
        }
    } else {
        for n in 0..STEPS.1 {
            let step = SECONDS / f64::from(STEPS.0 * 2_u32.pow(n));
            line.push((step, error(row, truth, &settings(method, step, None))?.1));
        }
    }
    line.retain(|(_, error)| LINE.contains(error));
    Ok((slope(&line).unwrap_or(f64::NAN), line.len()))
}

/// Measures the whole table.
///
/// # Errors
/// A message if a run refuses an entry that the table allows.
pub fn observe() -> Result<Vec<Observation>, String> {
    let mut all = Vec::new();
    for row in TABLE {
        let finest = match row.law {
            "moreau" => settings("moreau", SECONDS / f64::from(STEPS.0 * 2_u32.pow(STEPS.1 - 1) * 128), None),
            _ => settings("dop853", 5e-4, Some(1e-13)),
        };
        let truth: Result<Vec<Vec<f64>>, String> =
            HEIGHTS.iter().map(|height| Ok(end(&scene(&row, *height, &finest)?)?.0)).collect();
        let truth = truth?;
        for ((method, _, adaptive), entry) in METHODS.into_iter().zip(row.entries) {
            let observed = match entry {
                Ok(_) => Some(observe_one(&row, &truth, method, adaptive)?),
                Err(_) => None,
            };
            all.push(Observation { row, method, entry, observed });
        }
    }
    Ok(all)
}

/// One row per law, one column per method: observed order, the stated one in brackets, `-` if it is refused.
#[must_use]
pub fn table(observations: &[Observation], command: &str) -> Table {
    let mut columns = vec!["law".to_owned()];
    columns.extend(METHODS.map(|(name, ..)| name.to_owned()));
    let rows = observations.chunks(METHODS.len()).map(|of_row| {
        let row = of_row.first().map(|o| o.row);
        let law = row.map_or(String::new(), |row| {
            row.law.to_owned() + if row.damped && row.law != "moreau" { ", damped" } else { "" }
        });
        let cells = of_row.iter().map(|o| match (o.entry, o.observed) {
            (Ok(order), Some((observed, _))) => format!("{observed:.1} ({order})"),
            _ => "-".to_owned(),
        });
        std::iter::once(law).chain(cells).collect()
    });
    let title = "Laws and methods: observed order (stated in brackets; - refused by name)".to_owned();
    Table { title, columns, rows: rows.collect(), command: command.to_owned() }
}
