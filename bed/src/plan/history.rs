//! What a run of a plan leaves: recordings of sensels and of the skin, what tiles did, and how well each moment carries
//! the weight.
//!
//! In: the bed and a solution at each moment, whatever found it. Out: a [`History`], or why the run is not valid.

use super::check::Refusal;
use super::maps::{self, Map, SkinPoint};
use super::{Move, Order, Plan};
use crate::dynamics::impact::Blow;
use crate::equilibrium::{Bed, Fault, GRAVITY, Solution, State};
use crate::map::{Frame, Grid, MapError, Recording, Site};
use crate::metrics::spatial::load_error;
use crate::pose::Pose;
use crate::sheet::LatticeError;
use std::fmt;

/// Contact forces must carry the weight to this, or the run is not valid.
pub const GATE: f64 = 1e-6;
/// What tiles and loads did at a time.
#[derive(Clone, Debug, PartialEq)]
pub struct Moment {
    /// s.
    pub time: f64,
    /// What tiles were told.
    pub orders: Vec<Order>,
    /// Pressures that they had (Pa).
    pub gauges: Vec<f64>,
    /// Nodes on plates.
    pub bottomed: Vec<usize>,
    /// Upward force of each tile on the load (N).
    pub borne: Vec<f64>,
    /// Contact forces against the weight.
    pub imbalance: f64,
    /// Sensed load against the weight.
    pub sensed: f64,
    /// Newton steps.
    pub steps: usize,
    /// Middles of the segments (m).
    pub segments: Vec<Pose>,
    /// Heights of the nodes that are shown (m), by tile: [`Layout::shown`](super::Layout::shown).
    pub heights: Vec<Vec<f32>>,
}

/// A run.
#[derive(Clone, Debug)]
pub struct History {
    /// Where sensels lie.
    pub grid: Grid,
    /// What they felt; their areas are those of the last map. Every frame stands for the time until the next, the last for none.
    pub sensels: Recording,
    /// Their areas (m^2), frame by frame.
    pub areas: Vec<Vec<f64>>,
    /// What the skin felt.
    pub skin: Recording,
    /// What tiles did.
    pub moments: Vec<Moment>,
    /// What they were told: the plan's moves, and those that were decided on the way.
    pub moves: Vec<Move>,
    /// From when (s) on somebody was asked what to tell: the load lay. None while it never did.
    pub lay: Option<f64>,
    /// What happened between moments, in motion.
    pub watched: Option<Watched>,
}

impl History {
    /// What sensels read, by forces over the sensels' nominal cells: what a sensor maker's file has, in which all areas are
    /// alike, so that its pressures add up to the same force.
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

/// What there is to decide by at a time.
#[derive(Clone, Copy, Debug)]
pub struct Seen<'a> {
    /// The plan with all that was told so far.
    pub plan: &'a Plan,
    /// Where sensels lie.
    pub grid: &'a Grid,
    /// Their areas.
    pub sites: &'a [Site],
    /// What they truly feel.
    pub frame: &'a Frame,
}

/// Why a run ended.
#[derive(Clone, Debug, PartialEq)]
pub enum RunError {
    /// There are no such sheets.
    Sheet(LatticeError),
    /// No equilibrium at a time (s).
    Fault(f64, Fault),
    /// Contact forces do not carry the weight at a time (s): by this share.
    Invalid(f64, f64),
    /// What was recorded is unsound.
    Map(MapError),
    /// What was decided on the way exceeds a limit.
    Refused(Refusal),
    /// It was asked to stop.
    Stopped,
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
            RunError::Map(error) => write!(f, "{error}"),
            RunError::Refused(refusal) => write!(f, "{refusal}"),
            RunError::Stopped => f.write_str("stopped"),
        }
    }
}

impl std::error::Error for RunError {}

/// What happened in motion.
#[derive(Clone, Copy, Debug, PartialEq, Default)]
pub struct Watched {
    /// Largest mean over 10 ms of the upward force of all contacts (N).
    pub peak: f64,
    /// When it ended (s).
    pub peak_time: f64,
    /// When everything was slower than 1 mm/s for good (s); none if it never was.
    pub still: Option<f64>,
    /// Largest kinetic energy (J).
    pub kinetic: f64,
    /// Energy (J) lost by the end.
    pub lost: f64,
    /// Impacts.
    pub blows: Blow,
    /// Energy (J) that sheets of neighbours have given by turning on each other.
    pub turned: f64,
    /// Largest energy (J) that the method made or lost.
    pub left_over: f64,
    /// Steps.
    pub steps: usize,
    /// Length of a step (s).
    pub step: f64,
    /// Newton's steps of the whole bed in all of them; sheets that nothing touches have come to rest before.
    pub newton: usize,
}

/// Says what is told from a moment on.
pub(super) type Decide<'a> = &'a mut dyn FnMut(&Seen<'_>) -> Result<Vec<Move>, Refusal>;

/// Shuts the valves of sealed bladders at the volumes that they have.
pub(super) fn seal(plan: &Plan, bed: &mut Bed, state: &State) {
    if !plan.layout.is_sealed {
        return;
    }
    let volumes: Vec<f64> = state.sheets.iter().map(|sheet| bed.volume(sheet)).collect();
    for (tile, volume) in bed.tiles.iter_mut().zip(volumes) {
        tile.air = plan.layout.shut(tile.air, volume);
    }
}

/// Heights of the nodes that are shown (m), by tile.
fn heights(plan: &Plan, bed: &Bed, solution: &Solution) -> Vec<Vec<f32>> {
    let [across, along] = plan.layout.shown();
    let width = plan.layout.intervals[0] + 1;
    let of = |(tile, sheet): (&crate::equilibrium::Tile, &Vec<[f64; 3]>)| {
        let node = |j: usize, i: usize| tile.pose.outwards(sheet[j * width + i])[2] as f32;
        along.iter().flat_map(|j| across.iter().map(|i| node(*j, *i))).collect()
    };
    bed.tiles.iter().zip(&solution.state.sheets).map(of).collect()
}

/// Frames as they come.
pub(super) struct Recorder {
    grid: Grid,
    /// Sensels with their areas of now.
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
        // Pressure is force over the area that the sheet has now: a bulging one has more than one that is pressed flat.
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

    /// Adds what is decided by the last frame. Nobody is asked before the load `lies` for the first time: what is in flight
    /// presses on no bladder that could be told to bear it.
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
        // The last moment is an end, not a stretch of time: those before stand for all of it.
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
            watched: None,
        })
    }
}

/// What sensels feel against what must be carried: p A n_z of their own areas and directions, and shear upwards.
fn sensed(plan: &Plan, solution: &Solution, sites: &[Site], felt: &Map) -> f64 {
    let weight = plan.load.body.mass() * GRAVITY;
    // Where next to nothing is carried, as in flight, there is nothing to feel.
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
