//! Figures of the bed with a load: soft manipulation (2.1) and the bed with a human (2.6).
//!
//! In: plans under `models/plans`, changed by `--set`. Out: drawings of equilibria, in section and from above.

use crate::failure::Failure;
use crate::interrupt;
use crate::plan::Read;
use crate::plan_file::PlanFile;
use crate::plot::chart::{LARGE, SMALL, line, text};
use crate::plot::drawing::{Anchor, Color, Drawing, INK, Item, PALE};
use crate::progress::Progress;
use smartbed_bed::body::Surface;
use smartbed_bed::map::MMHG;
use smartbed_bed::plan::Plan;
use smartbed_bed::plan::history::{History, Moment, RunError};
use smartbed_bed::pose::Pose;
use smartbed_bed::soft::{Claim, Comparison, NAMES, commands, compare};

const SHEET: Color = [0, 114, 178];
const SKIN: Color = [213, 94, 0];

/// Runs something while a progress bar is shown.
fn with_progress<T>(
    name: &str,
    run: impl FnOnce(&mut dyn FnMut(f64) -> bool) -> Result<T, RunError>,
) -> Result<T, Failure> {
    interrupt::watch();
    let mut progress = Progress::new(name);
    let mut at = |done: f64| {
        progress.at(done);
        !interrupt::is_asked()
    };
    run(&mut at).map_err(|error| Failure::Wrong(format!("{name}: {error}")))
}

fn plan(name: &str, settings: &[String]) -> Result<Read, Failure> {
    PlanFile::open(name)?.read(settings)
}

/// Figure 2.1, and which of the thesis' claims it confirms.
pub(super) fn soft(settings: &[String]) -> Result<(Drawing, Vec<Claim>), Failure> {
    let read = plan("soft_manipulation", settings)?;
    // A quarter of the pressure and a tilt of 8 deg, within the stroke and the steps of one tile.
    let (low, slope) = (0.25 * read.plan.pressure, 8.0_f64.to_radians().tan());
    for change in commands(&read.plan, low, slope) {
        read.allows(&[change]).map_err(|refusal| Failure::Wrong(format!("soft manipulation: {refusal}")))?;
    }
    let found = with_progress("soft manipulation", |at| compare(&read.plan, low, slope, at))?;
    let claims = found.claims();
    Ok((four(&read.plan, &found, &claims), claims))
}

/// Four sections side by side, with numbers below, then the claims.
fn four(plan: &Plan, found: &Comparison, claims: &[Claim]) -> Drawing {
    let (wide, high) = (300.0, 310.0);
    let mut items = Vec::new();
    for (k, (history, state)) in found.histories.iter().zip(&found.states).enumerate() {
        let middle = (wide * (k as f64 + 0.5), 220.0);
        let moment = &history.moments[history.sensels.frames().len() - 1];
        items.push(text(
            (middle.0, 24.0),
            &format!("({}) {}", ["a", "b", "c", "d"][k], NAMES[k]),
            LARGE,
            Anchor::Middle,
        ));
        items.extend(section(plan, history, moment, middle, 1000.0));
        let numbers = [
            format!("peak {:.1} kPa, area {:.0} cm²", state.peak / 1e3, 1e4 * state.area),
            format!("first point of contact {:.1} kPa", state.first / 1e3),
            format!("shear up to {:.2} kPa", state.shear[0] / 1e3),
            format!("moved {:.0} mm, turned {:.1} deg", 1e3 * state.moved[0], state.moved[1].to_degrees()),
        ];
        for (n, words) in numbers.iter().enumerate() {
            items.push(text((middle.0, high + 20.0 * n as f64), words, SMALL, Anchor::Middle));
        }
    }
    let from = high + 110.0;
    for (n, claim) in claims.iter().enumerate() {
        let verdict = if claim.holds { "shown" } else { "refuted" };
        let words = format!("{verdict}: {} ({})", claim.says, claim.found);
        items.push(text((20.0, from + 22.0 * n as f64), &words, SMALL, Anchor::Start));
    }
    Drawing { width: 1200, height: (from + 22.0 * claims.len() as f64 + 10.0) as usize, items }
}

/// The middle row of the first tile's sheet with the pressure on it, and the load; `scale` in pixels per metre.
fn section(plan: &Plan, history: &History, moment: &Moment, middle: (f64, f64), scale: f64) -> Vec<Item> {
    let at = |x: f64, z: f64| (middle.0 + scale * x, middle.1 - scale * z);
    let [across, along] = plan.layout.shown();
    let row = along.len() / 2;
    let width = plan.layout.size()[0];
    let x = |i: usize| width * (across[i] as f64 / plan.layout.intervals[0] as f64 - 0.5);
    let sheet: Vec<(f64, f64)> =
        (0..across.len()).map(|i| at(x(i), f64::from(moment.heights[0][row * across.len() + i]))).collect();
    let mut items = vec![line(sheet.clone(), SHEET, 3.0)];
    let frame = &history.sensels.frames()[history.sensels.frames().len() - 1];
    let (wide, longest) = (plan.layout.intervals[0] + 1, 8000.0);
    for (i, (px, py)) in sheet.iter().enumerate() {
        let node = along[row] * wide + across[i];
        let pressure =
            smartbed_bed::plan::maps::sensel(&plan.layout, 0, node).map_or(0.0, |site| frame.pressure[site]);
        if pressure > 5.0 * MMHG {
            items.push(line(vec![(*px, *py), (*px, *py + 60.0 * pressure / longest)], SKIN, 2.0));
        }
    }
    for (segment, pose) in plan.load.body.segments.iter().zip(&moment.segments) {
        let outline = outline(&segment.shape, pose, 0, 2).into_iter().map(|[x, z]| at(x, z)).collect();
        items.push(line(outline, INK, 1.5));
    }
    items
}

/// The outline of a shape projected on axes `u` and `v`: the support points in all directions.
fn outline(shape: &Surface, pose: &Pose, u: usize, v: usize) -> Vec<[f64; 2]> {
    let farthest = |angle: f64| {
        let mut direction = [0.0; 3];
        (direction[u], direction[v]) = (angle.cos(), angle.sin());
        let place = pose.outwards(shape.farthest(pose.attitude.to_body(direction)));
        [place[u], place[v]]
    };
    (0..=96).map(|n| farthest(f64::from(n) / 96.0 * std::f64::consts::TAU)).collect()
}

/// Figure 2.6: a patient on all tiles, pressure and segments from above, and segments from the side.
pub(super) fn human(settings: &[String]) -> Result<Drawing, Failure> {
    let still = ["run.seconds=0".to_owned()];
    let read = plan("alternating", &[&still[..], settings].concat())?;
    let history = with_progress("the bed with a human", |at| read.run(at))?;
    let (plan, moment) = (&read.plan, &history.moments[0]);
    let (scale, middle) = (330.0, (230.0, 380.0));
    let at = |x: f64, y: f64| (middle.0 + scale * x, middle.1 - scale * y);
    let mut items = vec![text((middle.0, 24.0), "from above: pressure, mmHg", LARGE, Anchor::Middle)];
    let (grid, frame) = (&history.grid, &history.sensels.frames()[0]);
    let [left, low] = [0, 1].map(|k| {
        let last = plan.layout.middle(plan.layout.count() - 1);
        if k == 0 { -last[0] - 0.5 * plan.layout.pitch[0] } else { last[1] - 0.5 * plan.layout.pitch[1] }
    });
    for (site, pressure) in frame.pressure.iter().enumerate().filter(|(_, p)| **p > 5.0 * MMHG) {
        let [x, y] = grid.middle(site);
        // A sensel is centred on its node, which is the lower left corner of its cell in the grid.
        let (x, y) = (x + left - 0.5 * grid.column_pitch, y + low - 0.5 * grid.row_pitch);
        let (a, b) = (0.5 * grid.column_pitch, 0.5 * grid.row_pitch);
        let share = (pressure / (80.0 * MMHG)).min(1.0);
        let color =
            [(70.0 + 185.0 * share) as u8, (160.0 - 120.0 * share) as u8, (255.0 - 225.0 * share) as u8];
        items.push(Item::Area {
            points: vec![at(x - a, y - b), at(x + a, y - b), at(x + a, y + b), at(x - a, y + b)],
            color,
        });
    }
    let [a, b] = plan.layout.size().map(|s| 0.5 * s);
    for tile in 0..plan.layout.count() {
        let [x, y] = plan.layout.middle(tile);
        let corners = [(-a, -b), (a, -b), (a, b), (-a, b), (-a, -b)].map(|(u, v)| at(x + u, y + v));
        items.push(line(corners.to_vec(), PALE, 1.0));
    }
    let side = |y: f64, z: f64| (830.0 - scale * y, 260.0 - scale * z);
    items.push(text((830.0, 24.0), "from the side, head to the left", LARGE, Anchor::Middle));
    for (segment, pose) in plan.load.body.segments.iter().zip(&moment.segments) {
        let seen = |u: usize, v: usize, at: &dyn Fn(f64, f64) -> (f64, f64)| {
            line(outline(&segment.shape, pose, u, v).into_iter().map(|[x, y]| at(x, y)).collect(), INK, 1.2)
        };
        items.push(seen(0, 1, &at));
        items.push(seen(1, 2, &side));
    }
    let [across, along] = plan.layout.shown();
    for row in 0..plan.layout.rows {
        // The tiles of this column are under the patient's left side.
        let tile = row * plan.layout.columns + plan.layout.columns / 2;
        let y = |j: usize| {
            plan.layout.middle(tile)[1] + 2.0 * b * (along[j] as f64 / plan.layout.intervals[1] as f64 - 0.5)
        };
        let sheet = (0..along.len())
            .map(|j| side(y(j), f64::from(moment.heights[tile][j * across.len() + across.len() / 2])));
        items.push(line(sheet.collect(), SHEET, 2.0));
    }
    let peak = frame.pressure.iter().copied().fold(0.0, f64::max) / MMHG;
    let words = [
        format!("{} tiles of a bladder each at {:.1} kPa", plan.layout.count(), plan.pressure / 1e3),
        format!(
            "{:.0} kg in {} segments; peak {peak:.0} mmHg",
            plan.load.body.mass(),
            plan.load.body.segments.len()
        ),
        format!("contact forces balance the weight within {:.0e}", moment.imbalance),
    ];
    for (n, words) in words.iter().enumerate() {
        items.push(text((480.0, 480.0 + 24.0 * n as f64), words, SMALL, Anchor::Start));
    }
    Ok(Drawing { width: 1200, height: 760, items })
}
