//! Soft manipulation, the thesis' Fig. 2.1: one load on one bladder: stiff, deflated, tilted stiff, tilted and
//! deflated.
//!
//! In: a plan for the stiff, level bladder, a low pressure and a tilt. Out: four runs that all begin stiff and level,
//! how each ends ([`State`]), and whether they confirm the statements of the thesis' section 2.1 ([`Claim`]).

use crate::map::MMHG;
use crate::metrics::{shear, spatial};
use crate::plan::history::{History, RunError};
use crate::plan::maps::skin;
use crate::plan::run::run;
use crate::plan::{Move, Plan};
use smartbed_runtime::vec3::{norm, sub};

/// Pressure (Pa) below which a point of the skin counts as unloaded.
const FREE: f64 = 5.0 * MMHG;
/// Radius (m) of the patch of skin around the point of highest initial pressure.
const AROUND: f64 = 0.025;

/// Names of the four runs.
pub const NAMES: [&str; 4] = ["stiff", "deflated", "tilted stiff", "tilted and deflated"];

/// The state at the end of a run.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct State {
    /// Largest pressure on a sensel (Pa).
    pub peak: f64,
    /// Area of contact (m^2).
    pub area: f64,
    /// Mean pressure on the patch of skin that carried most at the beginning (Pa).
    pub first: f64,
    /// Largest shear (Pa), and the total, sum |tau| A (N).
    pub shear: [f64; 2],
    /// Distance on the skin from the point of highest pressure at the beginning to that at the end (m).
    pub wandered: f64,
    /// How far the load has moved along the bed (m) and tilted (rad).
    pub moved: [f64; 2],
}

/// A statement of the thesis.
#[derive(Clone, Debug, PartialEq)]
pub struct Claim {
    /// The statement.
    pub says: &'static str,
    /// What was found, in figures.
    pub found: String,
    /// Is it confirmed?
    pub holds: bool,
}

/// The four runs.
#[derive(Clone, Debug)]
pub struct Comparison {
    /// In the order of [`NAMES`].
    pub histories: Vec<History>,
    /// Their final states.
    pub states: Vec<State>,
}

/// The commands to all tiles in each of the four runs, executed over half of the plan's time.
#[must_use]
pub fn commands(plan: &Plan, low: f64, slope: f64) -> [Move; 4] {
    let tiles: Vec<usize> = (0..plan.layout.count()).collect();
    let over = 0.5 * plan.seconds;
    [(None, None), (Some(low), None), (None, Some([slope, 0.0])), (Some(low), Some([slope, 0.0]))]
        .map(|(pressure, slope)| Move { at: 0.0, over, tiles: tiles.clone(), pressure, heave: None, slope })
}

/// Runs the four. `at` is given the share that is done and returns whether to go on.
///
/// # Errors
/// [`RunError`], for example if a load finds no equilibrium.
pub fn compare(
    plan: &Plan,
    low: f64,
    slope: f64,
    mut at: impl FnMut(f64) -> bool,
) -> Result<Comparison, RunError> {
    let mut histories = Vec::new();
    for (n, change) in commands(plan, low, slope).into_iter().enumerate() {
        let history = run(&plan.with(&[change]), |done| at(0.25 * (n as f64 + done)))?;
        histories.push(history);
    }
    let states = histories.iter().map(|history| state(plan, history)).collect();
    Ok(Comparison { histories, states })
}

/// Evaluates the final state of a run.
fn state(plan: &Plan, history: &History) -> State {
    let (sensels, skins) = (&history.sensels, &history.skin);
    let (Some(last), Some([start, .., end])) = (sensels.frames().last(), skins.frames().get(..)) else {
        return State { peak: 0.0, area: 0.0, first: 0.0, shear: [0.0; 2], wandered: 0.0, moved: [0.0; 2] };
    };
    let (points, sites) = skin(&plan.load);
    let most = |pressure: &[f64]| {
        (0..pressure.len()).max_by(|a, b| pressure[*a].total_cmp(&pressure[*b])).unwrap_or_default()
    };
    let (from, to) = (points[most(&start.pressure)].place, points[most(&end.pressure)].place);
    let near: Vec<usize> = (0..points.len()).filter(|i| norm(sub(points[*i].place, from)) < AROUND).collect();
    let area: f64 = near.iter().map(|i| sites[*i].area).sum();
    let moments = [&history.moments[0], &history.moments[sensels.frames().len() - 1]];
    let [before, after] = moments.map(|moment| moment.segments[0]);
    let turn = after.attitude.to_body(before.attitude.to_inertial([0.0, 0.0, 1.0]));
    State {
        peak: spatial::peak(&last.pressure),
        area: spatial::area_above(sensels.sites(), &last.pressure, FREE),
        first: near.iter().map(|i| end.pressure[*i] * sites[*i].area).sum::<f64>() / area,
        shear: [
            shear::peak(&last.shear),
            sensels.sites().iter().zip(&last.shear).map(|(s, t)| s.area * t[0].hypot(t[1])).sum(),
        ],
        wandered: norm(sub(to, from)),
        moved: [
            (after.place[0] - before.place[0]).hypot(after.place[1] - before.place[1]),
            turn[0].hypot(turn[1]).atan2(turn[2]),
        ],
    }
}

impl Comparison {
    /// The statements of section 2.1, each compared with the runs.
    #[must_use]
    pub fn claims(&self) -> Vec<Claim> {
        let [a, b, c, d] = [0, 1, 2, 3].map(|k| self.states[k]);
        let kpa = |x: f64| 1e-3 * x;
        let claim = |says, holds, found| Claim { says, found, holds };
        vec![
            claim(
                "deflating distributes and reduces the force at each point of contact",
                b.peak < a.peak && b.area > a.area,
                format!(
                    "peak {:.1} kPa stiff, {:.1} deflated; area {:.0} and {:.0} cm2",
                    kpa(a.peak),
                    kpa(b.peak),
                    1e4 * a.area,
                    1e4 * b.area
                ),
            ),
            claim(
                "deflated, the first point of contact still bears a normal force",
                b.first > FREE,
                format!("{:.1} kPa there, {:.1} stiff", kpa(b.first), kpa(a.first)),
            ),
            claim(
                "deflating can increase the shear stress",
                b.shear[0] > a.shear[0],
                format!("largest shear {:.2} kPa stiff, {:.2} deflated", kpa(a.shear[0]), kpa(b.shear[0])),
            ),
            claim(
                "tilted stiff, the point of most force moves across the surface of the body",
                c.wandered > 0.01,
                format!("it goes {:.0} mm over the skin", 1e3 * c.wandered),
            ),
            claim(
                "tilted stiff, the force is still large",
                c.peak > 0.8 * a.peak && c.peak > d.peak,
                format!(
                    "peak {:.1} kPa, {:.1} level, {:.1} deflated as well",
                    kpa(c.peak),
                    kpa(a.peak),
                    kpa(d.peak)
                ),
            ),
            claim(
                "tilted and deflated, forces are smaller and redistributed",
                d.peak < c.peak && d.area > c.area,
                format!("area {:.0} cm2, {:.0} stiff", 1e4 * d.area, 1e4 * c.area),
            ),
            claim(
                "tilted and deflated, the first point of contact bears no force",
                d.first < FREE,
                format!("{:.1} kPa there, contact counts from {:.2}", kpa(d.first), kpa(FREE)),
            ),
            claim(
                "tilting while deflating can reduce the shear stress",
                d.shear[0] < b.shear[0],
                format!("largest shear {:.2} kPa, {:.2} deflated alone", kpa(d.shear[0]), kpa(b.shear[0])),
            ),
            claim(
                "tilted and deflated, the body moves and turns less than tilted stiff",
                d.moved[0] < c.moved[0] && d.moved[1] < c.moved[1],
                format!(
                    "{:.0} mm and {:.1} deg, {:.0} mm and {:.1} deg stiff",
                    1e3 * d.moved[0],
                    d.moved[1].to_degrees(),
                    1e3 * c.moved[0],
                    c.moved[1].to_degrees()
                ),
            ),
        ]
    }
}
