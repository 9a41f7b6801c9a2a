//! The results of a run: recordings of sensels and of the skin, what tiles did, and how well each moment balances the
//! weight.
//!
//! In: the bed and a solution at each moment, whether static or dynamic. Out: a [`History`], or why the run is not
//! valid.

use super::check::Refusal;
use super::maps::{self, Map, SkinPoint};
use super::{Move, Order, Plan};
use crate::dynamics::impact::Blow;
use crate::equilibrium::passed::{Passed, passed};
use crate::equilibrium::{Bed, Fault, GRAVITY, Solution, State};
use crate::map::{Frame, Grid, MapError, Recording, Site};
use crate::metrics::spatial::load_error;
use crate::pose::Pose;
use crate::sheet::LatticeError;
use std::fmt;

/// Largest relative error of the contact forces against the weight; beyond it the run is not valid.
pub const GATE: f64 = 1e-6;
/// The state of tiles and load at a time.
#[derive(Clone, Debug, PartialEq)]
pub struct Moment {
    /// s.
    pub time: f64,
    /// Orders of the tiles.
    pub orders: Vec<Order>,
    /// Actual gauge pressures (Pa).
    pub gauges: Vec<f64>,
    /// Number of nodes on the plate, by tile.
    pub bottomed: Vec<usize>,
    /// Upward force of each tile on the load (N).
    pub borne: Vec<f64>,
    /// Relative error of the contact forces against the weight.
    pub imbalance: f64,
    /// Relative error of the sensed load against the weight.
    pub sensed: f64,
    /// Newton steps.
    pub steps: usize,
    /// Poses of the segments.
    pub segments: Vec<Pose>,
    /// Heights of the nodes that pictures show (m), by tile: [`Layout::shown`](super::Layout::shown).
    pub heights: Vec<Vec<f32>>,
}

/// The results of a run.
#[derive(Clone, Debug)]
pub struct History {
    /// Where sensels lie.
    pub grid: Grid,
    /// True readings of the sensels, with the areas of the last map. Each frame lasts until the next one; the last has
    /// duration 0.
    pub sensels: Recording,
    /// Their areas (m^2), frame by frame.
    pub areas: Vec<Vec<f64>>,
    /// True readings of the points of the skin.
    pub skin: Recording,
    /// The state of tiles and load, frame by frame.
    pub moments: Vec<Moment>,
    /// All moves: those of the plan, and those decided during the run.
    pub moves: Vec<Move>,
    /// Time (s) from which on decisions were asked for, because the load had come to rest; `None` if it never did.
    pub lay: Option<f64>,
    /// Number of parts in which the load was laid on although the plan puts it down at once: so put down, a part of it
    /// passed through a sheet, or no equilibrium was found.
    pub parts: Option<usize>,
    /// Extremes between moments, in motion.
    pub watched: Option<Watched>,
}

impl History {
    /// Readings of the sensels related to their nominal cells, as in a sensor maker's file, in which all areas are
    /// equal: the pressures then add up to the same force.
    ///
    /// # Errors
    /// [`MapError`].
    pub fn over_cells(&self, read: &Recording) -> Result<Recording, MapError> {
        let cell = self.grid.cell();
        let one = |(frame, areas): (&Frame, &Vec<f64>)| Frame {
            pressure: frame.pressure.iter().zip(areas).map(|(p, area)| p * area / cell).collect(),
            shear: frame.shear.iter().zip(areas).map(|(s, area)| s.map(|t| t * area / cell)).collect(),
            ..*frame
        };
        Recording::new(self.grid.all(), read.frames().iter().zip(&self.areas).map(one).collect())
    }
}

/// What a decision may be based on at a time.
#[derive(Clone, Copy, Debug)]
pub struct Seen<'a> {
    /// The plan with all moves so far.
    pub plan: &'a Plan,
    /// Positions of the sensels.
    pub grid: &'a Grid,
    /// Their areas.
    pub sites: &'a [Site],
    /// Their true readings.
    pub frame: &'a Frame,
}

/// The reason why a run has ended early.
#[derive(Clone, Debug, PartialEq)]
pub enum RunError {
    /// The sheets cannot be modelled.
    Sheet(LatticeError),
    /// No equilibrium at a time (s).
    Fault(f64, Fault),
    /// At a time (s) the contact forces miss the weight by this share.
    Invalid(f64, f64),
    /// At a time (s) a segment of this name lies below the sheet of a tile by a depth (m).
    Passed(f64, String, usize, f64),
    /// The recording is not valid.
    Map(MapError),
    /// A decision during the run exceeds a limit.
    Refused(Refusal),
    /// The caller asked it to stop.
    Stopped,
}

impl RunError {
    /// Names the segment that has passed through a sheet.
    pub(super) fn of_passed(plan: &Plan, time: f64, found: Passed) -> RunError {
        let Passed { segment, tile, depth } = found;
        RunError::Passed(time, plan.load.body.segments[segment].name.clone(), tile, depth)
    }
}

impl fmt::Display for RunError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            RunError::Sheet(error) => write!(f, "{error}"),
            RunError::Fault(time, fault) => write!(f, "at {time} s: {fault}"),
            RunError::Invalid(time, share) => {
                write!(
                    f,
                    "at {time} s: contact forces miss the weight by {share:.1e} of it, expected {GATE:.0e}"
                )
            }
            RunError::Passed(time, segment, tile, depth) => write!(
                f,
                "at {time} s: {segment} has passed through the sheet of tile {} and lies {:.0} mm below it, expected \
                 above; lay the load on in parts (`run.parts = 8`), let it fall (`run.fall`), begin a motion at rest \
                 (`dynamics.start`), or take more `intervals` or more pressure",
                tile + 1,
                1e3 * depth
            ),
            RunError::Map(error) => write!(f, "{error}"),
            RunError::Refused(refusal) => write!(f, "{refusal}"),
            RunError::Stopped => f.write_str("stopped"),
        }
    }
}

impl std::error::Error for RunError {}

/// Extremes and totals of a motion.
#[derive(Clone, Copy, Debug, PartialEq, Default)]
pub struct Watched {
    /// Largest mean over 10 ms, or over a longer step, of the upward force of all contacts (N).
    pub peak: f64,
    /// End of the interval of that mean (s).
    pub peak_time: f64,
    /// Length of that interval (s): whole steps, the nearest to 10 ms; less at the start of a run.
    pub peak_window: f64,
    /// Largest gauge pressure of a bladder (Pa).
    pub pressed: f64,
    /// Index of the tile of that bladder.
    pub pressed_tile: usize,
    /// When it had that pressure (s).
    pub pressed_time: f64,
    /// Time (s) since which everything has been slower than 1 mm/s; `None` if it never was.
    pub still: Option<f64>,
    /// Largest kinetic energy (J).
    pub kinetic: f64,
    /// Energy (J) dissipated by the end.
    pub lost: f64,
    /// Effects of impacts.
    pub blows: Blow,
    /// Energy (J) gained because contacts between neighbouring sheets were found anew with other feet and normals.
    pub turned: f64,
    /// Largest energy (J) that the method itself has added or removed.
    pub left_over: f64,
    /// Number of steps.
    pub steps: usize,
    /// Length of a step (s).
    pub step: f64,
    /// Number of Newton steps of the whole bed; sheets that nothing touches are solved before them.
    pub newton: usize,
}

/// Decides which moves to make from a moment on.
pub(super) type Decide<'a> = &'a mut dyn FnMut(&Seen<'_>) -> Result<Vec<Move>, Refusal>;

/// Closes the valves of sealed bladders at their present volumes.
pub(super) fn seal(plan: &Plan, bed: &mut Bed, state: &State) {
    if !plan.layout.is_sealed {
        return;
    }
    let volumes: Vec<f64> = state.sheets.iter().map(|sheet| bed.volume(sheet)).collect();
    for (tile, volume) in bed.tiles.iter_mut().zip(volumes) {
        tile.air = plan.layout.shut(tile.air, volume);
    }
}

/// Heights of the nodes that pictures show (m), by tile.
fn heights(plan: &Plan, bed: &Bed, solution: &Solution) -> Vec<Vec<f32>> {
    let [across, along] = plan.layout.shown();
    let width = plan.layout.intervals[0] + 1;
    let of = |(tile, sheet): (&crate::equilibrium::Tile, &Vec<[f64; 3]>)| {
        let node = |j: usize, i: usize| tile.pose.outwards(sheet[j * width + i])[2] as f32;
        along.iter().flat_map(|j| across.iter().map(|i| node(*j, *i))).collect()
    };
    bed.tiles.iter().zip(&solution.state.sheets).map(of).collect()
}

/// Collects frames and moments during a run.
pub(super) struct Recorder {
    grid: Grid,
    /// Sensels with their present areas.
    sites: Vec<Site>,
    /// Areas of all frames.
    areas: Vec<Vec<f64>>,
    points: Vec<SkinPoint>,
    skin_sites: Vec<Site>,
    frames: [Vec<Frame>; 2],
    moments: Vec<Moment>,
    lay: Option<f64>,
}

impl Recorder {
    pub fn new(plan: &Plan, bed: &Bed, solution: &Solution) -> Recorder {
        let (points, skin_sites) = maps::skin(&plan.load);
        let sites = maps::sensels(&plan.layout, bed, solution);
        let grid = maps::grid(&plan.layout);
        let frames = [Vec::new(), Vec::new()];
        let (areas, moments) = (Vec::new(), Vec::new());
        Recorder { grid, sites, areas, points, skin_sites, frames, moments, lay: None }
    }

    pub fn take(&mut self, plan: &Plan, bed: &Bed, solution: &Solution, time: f64) -> Result<(), RunError> {
        if solution.imbalance.is_nan() || solution.imbalance > GATE {
            return Err(RunError::Invalid(time, solution.imbalance));
        }
        if let Some(found) = passed(bed, &plan.load.body, &solution.state) {
            return Err(RunError::of_passed(plan, time, found));
        }
        // Pressure is force over the present area of the sheet, which is larger where it bulges.
        let sites = maps::sensels(&plan.layout, bed, solution);
        let felt = maps::felt(&plan.layout, solution, &sites);
        let sensed = sensed(plan, solution, &sites, &felt);
        self.areas.push(sites.iter().map(|site| site.area).collect());
        self.sites = sites;
        let skin = maps::on_skin(bed, solution, &self.points);
        let seconds = plan.every;
        for (frames, map) in self.frames.iter_mut().zip([felt, skin]) {
            frames.push(Frame { time, seconds, pressure: map.pressure, shear: map.shear });
        }
        self.moments.push(Moment {
            time,
            orders: (0..plan.layout.count()).map(|tile| plan.order(tile, time)).collect(),
            gauges: solution.gauges.clone(),
            bottomed: solution.bottomed.clone(),
            borne: solution.contacts.iter().map(|own| own.iter().map(|c| c.force()[2]).sum()).collect(),
            imbalance: solution.imbalance,
            sensed,
            steps: solution.steps,
            segments: solution.state.segments.clone(),
            heights: heights(plan, bed, solution),
        });
        Ok(())
    }

    /// Adds the moves decided on the last frame. No decision is asked for before the load `lies` for the first time:
    /// while it falls it presses on no bladder.
    pub fn decide(&mut self, plan: &mut Plan, lies: bool, decide: Decide<'_>) -> Result<(), RunError> {
        let Some(frame) = self.frames[0].last() else { return Ok(()) };
        if lies && self.lay.is_none() {
            self.lay = Some(frame.time);
        }
        if self.lay.is_none() {
            return Ok(());
        }
        let seen = Seen { plan, grid: &self.grid, sites: &self.sites, frame };
        let moves = decide(&seen).map_err(RunError::Refused)?;
        if !moves.is_empty() {
            *plan = plan.with(&moves);
        }
        Ok(())
    }

    pub fn finish(self, plan: &Plan) -> Result<History, RunError> {
        let [mut sensels, mut skin] = self.frames;
        // The last moment has duration 0; the frames before it cover the whole time.
        for end in [sensels.last_mut(), skin.last_mut()].into_iter().flatten() {
            end.seconds = 0.0;
        }
        Ok(History {
            grid: self.grid,
            sensels: Recording::new(self.sites, sensels).map_err(RunError::Map)?,
            areas: self.areas,
            skin: Recording::new(self.skin_sites, skin).map_err(RunError::Map)?,
            moments: self.moments,
            moves: plan.moves.clone(),
            lay: self.lay,
            parts: None,
            watched: None,
        })
    }
}

/// Relative error of the load that sensels sense: p A n_z by their own areas and directions, plus upward shear.
fn sensed(plan: &Plan, solution: &Solution, sites: &[Site], felt: &Map) -> f64 {
    let weight = plan.load.body.mass() * GRAVITY;
    // When almost nothing is carried, as in free fall, there is nothing to sense.
    if solution.carried <= 0.01 * weight {
        return 0.0;
    }
    let count = felt.pressure.len();
    let (mut up, mut shear) = (vec![0.0; count], vec![0.0; count]);
    for (tile, contacts) in solution.contacts.iter().enumerate() {
        for contact in contacts {
            if let Some(site) = maps::sensel(&plan.layout, tile, contact.touch.node) {
                let own = contact.touch.force() / sites[site].area;
                let share = own / felt.pressure[site].max(f64::MIN_POSITIVE);
                up[site] -= share * contact.touch.normal[2];
                shear[site] += contact.drag[2] / sites[site].area;
            }
        }
    }
    load_error(sites, &felt.pressure, &up, &shear, solution.carried)
}
