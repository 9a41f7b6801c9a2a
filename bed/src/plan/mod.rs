//! A plan: the tiles of a bed, what lies on them, and the orders of the tiles over time.
//!
//! In: sizes and moves, as numbers. Out: the order of each tile at a time ([`Plan::order`]), violated limits
//! ([`check`]), and the results of a run ([`run`]).

pub mod check;
pub mod history;
pub mod maps;
pub mod moments;
pub mod motion;
pub mod readings;
pub mod run;
mod start;
pub mod states;

use crate::body::Body;
use crate::body::figure::Figure;
use crate::dynamics::{Impact, Matter, Method};
use crate::equilibrium::{Bed, Cover, Tile};
use crate::pose::Pose;
use crate::sheet::air::Air;
use crate::sheet::{Lattice, LatticeError};
use crate::tile::{self, Command};
use smartbed_runtime::vec3::Vec3;

/// Geometry and limits of the tiles.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Layout {
    /// Number of rows of tiles, the first at the head.
    pub rows: usize,
    /// Number of columns.
    pub columns: usize,
    /// Distance of tiles along x and y (m).
    pub pitch: [f64; 2],
    /// Gap between the rims of neighbours (m).
    pub gap: f64,
    /// Height of a bladder below its rim (m).
    pub depth: f64,
    /// Membrane stiffness E t of the sheets (N/m).
    pub modulus: f64,
    /// Number of cells of a sheet along x and y.
    pub intervals: [usize; 2],
    /// Coulomb's friction coefficient of skin on sheets.
    pub friction: f64,
    /// Friction coefficient of sheets on neighbouring sheets.
    pub rubbing: f64,
    /// Radius of the screws' circle (m).
    pub circle: f64,
    /// Stroke of a screw (m), half of it up and half down.
    pub stroke: f64,
    /// Largest speed of a screw (m/s).
    pub speed: f64,
    /// Largest step between edges of neighbours (m).
    pub step: f64,
    /// Largest pressure (Pa).
    pub most_pressure: f64,
    /// Height of the rim above the star (m).
    pub above: f64,
    /// Are valves closed between changes of pressure?
    pub is_sealed: bool,
    /// What is mounted on the sheets.
    pub cover: Cover,
    /// Polytropic exponent n of p V^n in a sealed bladder: 1 if the gas keeps its temperature, 1.4 if no heat is
    /// exchanged.
    pub exponent: f64,
}

impl Default for Layout {
    fn default() -> Self {
        Layout {
            rows: 7,
            columns: 4,
            pitch: [0.225, 0.2857],
            gap: 0.006,
            depth: 0.1,
            modulus: 5000.0,
            intervals: [8, 10],
            friction: 0.4,
            rubbing: 0.0,
            circle: 0.09,
            stroke: 0.06,
            speed: 6.7e-3,
            step: 0.02,
            most_pressure: 12e3,
            above: 0.13,
            is_sealed: false,
            cover: Cover::default(),
            exponent: 1.0,
        }
    }
}

impl Layout {
    /// The air of a bladder with its valves closed at a volume (m^3), if they are not closed already.
    #[must_use]
    pub fn shut(&self, air: Air, volume: f64) -> Air {
        match air {
            Air::Regulated(gauge) => Air::sealed(gauge, volume, self.exponent),
            Air::Sealed(..) => air,
        }
    }

    /// Number of tiles.
    #[must_use]
    pub fn count(&self) -> usize {
        self.rows * self.columns
    }

    /// Size of a sheet (m).
    #[must_use]
    pub fn size(&self) -> [f64; 2] {
        self.pitch.map(|p| p - self.gap)
    }

    /// Indices of the nodes of a sheet along x and y that pictures show: at most nine, including the rims.
    #[must_use]
    pub fn shown(&self) -> [Vec<usize>; 2] {
        self.intervals.map(|n| {
            let count = n.clamp(1, 8);
            (0..=count).map(|k| (k * n + count / 2) / count).collect()
        })
    }

    /// Centre of a tile (m); the bed's centre is the origin, the head lies towards +y.
    #[must_use]
    pub fn middle(&self, tile: usize) -> [f64; 2] {
        let (row, column) = (tile / self.columns, tile % self.columns);
        let at = |k: usize, count: usize| k as f64 - 0.5 * (count as f64 - 1.0);
        [at(column, self.columns) * self.pitch[0], -at(row, self.rows) * self.pitch[1]]
    }

    /// Pose of a rim's plane.
    #[must_use]
    pub fn rim(&self, tile: usize, command: &Command) -> Pose {
        let [x, y] = self.middle(tile);
        let star = tile::pose(command, self.circle);
        let place = star.outwards([0.0, 0.0, self.above]);
        Pose { place: [place[0] + x, place[1] + y, place[2] - self.above], attitude: star.attitude }
    }

    /// Pairs of neighbours, the tile to the left or nearer to the head first, and whether they are side by side along
    /// x.
    pub fn neighbours(&self) -> impl Iterator<Item = (usize, usize, bool)> {
        let (columns, count) = (self.columns, self.count());
        (0..count).flat_map(move |tile| {
            let beside = (tile % columns + 1 < columns).then_some((tile, tile + 1, true));
            let below = (tile + columns < count).then_some((tile, tile + columns, false));
            beside.into_iter().chain(below)
        })
    }
}

/// The order of a tile: its commanded pressure and pose.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Order {
    /// Gauge pressure (Pa).
    pub pressure: f64,
    /// Heave and slopes.
    pub command: Command,
}

/// A change of the orders of some tiles.
#[derive(Clone, Debug, PartialEq)]
pub struct Move {
    /// Time at which it begins (s).
    pub at: f64,
    /// Duration (s).
    pub over: f64,
    /// Indices of the tiles, from 0.
    pub tiles: Vec<usize>,
    /// Gauge pressure (Pa).
    pub pressure: Option<f64>,
    /// Heave (m).
    pub heave: Option<f64>,
    /// Slopes towards +x and +y.
    pub slope: Option<[f64; 2]>,
}

/// A quantity on its way from one order to the next.
struct Ramp {
    from: f64,
    to: f64,
    /// Time at which it begins (s), and duration (s).
    at: f64,
    over: f64,
}

impl Ramp {
    fn still(value: f64) -> Ramp {
        Ramp { from: value, to: value, at: 0.0, over: 0.0 }
    }

    fn at(&self, time: f64) -> f64 {
        let done = if self.over > 0.0 { ((time - self.at) / self.over).min(1.0) } else { 1.0 };
        self.from + done * (self.to - self.from)
    }

    /// Goes on towards another value from where it is, if the move gives one.
    fn turn(&mut self, change: &Move, to: Option<f64>) {
        if let Some(to) = to {
            *self = Ramp { from: self.at(change.at), to, at: change.at, over: change.over };
        }
    }
}

/// What lies on the bed.
#[derive(Clone, Debug, PartialEq)]
pub struct Load {
    /// Segments and joints.
    pub body: Body,
    /// Poses before it is put down (m).
    pub poses: Vec<Pose>,
    /// The figure, if it is one, which knows the regions of its skin.
    pub figure: Option<Figure>,
}

impl Load {
    /// Shifts all segments and lifts them just so far that none begins inside a bladder.
    #[must_use]
    pub fn placed(mut self, [x, y]: [f64; 2]) -> Load {
        let bottom = |(segment, pose): (&crate::body::Segment, &Pose)| {
            pose.place[2] - segment.shape.extent(pose.attitude.to_body([0.0, 0.0, -1.0]))
        };
        let lowest = self.body.segments.iter().zip(&self.poses).map(bottom).fold(f64::INFINITY, f64::min);
        // Bladders bulge by about 40 mm; tissue and sheets yield by as much.
        let up = 0.03 - lowest;
        for pose in &mut self.poses {
            let way: Vec3<f64> = [x, y, up];
            pose.place = smartbed_runtime::vec3::add(pose.place, way);
        }
        self
    }
}

/// How a run is computed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Clock {
    /// As a sequence of equilibria.
    QuasiStatic,
    /// As a motion.
    Dynamics(Dynamics),
}

/// Settings for computing a motion.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Dynamics {
    /// Longest step (s).
    pub step: f64,
    /// Integration method.
    pub method: Method,
    /// Initial position of the load.
    pub start: Start,
    /// Masses and dissipation.
    pub matter: Matter,
    /// What happens when sheets touch the load.
    pub impact: Impact,
    /// Solve the sheets of an empty bed in f32?
    pub is_f32: bool,
}

/// Initial position of a load.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Start {
    /// At this height (m) above the sheets, then released.
    Dropped(f64),
    /// In the equilibrium with which a quasi-static run would begin.
    AtRest,
}

/// How a load is laid down before a sequence of equilibria; friction depends on it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Laying {
    /// Guided vertically with all its weight, then released.
    AtOnce,
    /// With its weight applied in this number of equal parts.
    InParts(usize),
    /// It falls with these settings of the motion and settles for this time (s).
    Fallen(Dynamics, f64),
}

impl Default for Dynamics {
    fn default() -> Dynamics {
        Dynamics {
            step: 2e-3,
            method: Method::Bdf2,
            start: Start::Dropped(DROP),
            matter: Matter::default(),
            impact: Impact::default(),
            is_f32: false,
        }
    }
}

/// Height (m) of a fall if none is stated.
pub const DROP: f64 = 0.02;

/// A plan.
#[derive(Clone, Debug, PartialEq)]
pub struct Plan {
    /// Its title.
    pub title: String,
    /// Geometry and limits of the tiles.
    pub layout: Layout,
    /// Pressure of all bladders at the start (Pa).
    pub pressure: f64,
    /// What lies on the bed.
    pub load: Load,
    /// Changes of orders, sorted by their beginning.
    pub moves: Vec<Move>,
    /// Duration (s).
    pub seconds: f64,
    /// Time between two equilibria (s).
    pub every: f64,
    /// Length of a cycle, for metrics (s).
    pub cycle: f64,
    /// How the run is computed.
    pub clock: Clock,
    /// How the load is laid down before the first equilibrium.
    pub laying: Laying,
}

impl Plan {
    /// The order of a tile at a time: each move of a quantity starts from its order at that moment, and ends the one
    /// before it.
    #[must_use]
    pub fn order(&self, tile: usize, time: f64) -> Order {
        self.order_after(tile, time, |change| change.at <= time)
    }

    /// The order just before a time, without moves that begin at it.
    #[must_use]
    pub fn order_before(&self, tile: usize, time: f64) -> Order {
        self.order_after(tile, time, |change| change.at < time)
    }

    fn order_after(&self, tile: usize, time: f64, has_begun: impl Fn(&Move) -> bool) -> Order {
        let [mut pressure, mut heave] = [self.pressure, 0.0].map(Ramp::still);
        let mut slope = [0.0; 2].map(Ramp::still);
        for change in self.moves.iter().filter(|m| has_begun(m) && m.tiles.contains(&tile)) {
            pressure.turn(change, change.pressure);
            heave.turn(change, change.heave);
            (0..2).for_each(|k| slope[k].turn(change, change.slope.map(|s| s[k])));
        }
        let command = Command { heave: heave.at(time), slope: slope.map(|own| own.at(time)) };
        Order { pressure: pressure.at(time), command }
    }

    /// The same plan with more moves.
    #[must_use]
    pub fn with(&self, moves: &[Move]) -> Plan {
        let mut plan = self.clone();
        plan.moves.extend_from_slice(moves);
        plan.moves.sort_by(|a, b| a.at.total_cmp(&b.at));
        plan
    }

    /// Times of all equilibria (s): multiples of `every`.
    #[must_use]
    pub fn times(&self) -> Vec<f64> {
        let count = (self.seconds / self.every + 1e-9).floor() as usize;
        (0..=count).map(|k| k as f64 * self.every).collect()
    }

    /// Most cycles of [`Plan::alternating`].
    pub const MOST_CYCLES: usize = 10_000;

    /// Alternating pressure: two groups of tiles, like the squares of a chess board, are low in turn for five twelfths
    /// of a cycle; between these times both are high for a twelfth (of 600 s: 250 s, 50 s, 250 s, 50 s). The second group
    /// rises to `high` at once. After [`Plan::MOST_CYCLES`] cycles both stay high.
    #[must_use]
    pub fn alternating(layout: &Layout, low: f64, high: f64, cycle: f64, seconds: f64) -> Vec<Move> {
        let group = |k: usize| -> Vec<usize> {
            let is_in = |t: &usize| (t / layout.columns + t % layout.columns) % 2 == k;
            (0..layout.count()).filter(is_in).collect()
        };
        let twelfth = cycle / 12.0;
        let turn = |at: f64, k: usize, pressure: f64| Move {
            at,
            over: 0.4 * twelfth,
            tiles: group(k),
            pressure: Some(pressure),
            heave: None,
            slope: None,
        };
        let cycles = ((seconds / cycle).ceil() as usize).min(Self::MOST_CYCLES);
        let one = |n: usize| {
            let start = n as f64 * cycle;
            [(0.0, 0, low), (5.0, 0, high), (6.0, 1, low), (11.0, 1, high)]
                .map(|(at, k, pressure)| turn(start + at * twelfth, k, pressure))
        };
        std::iter::once(turn(0.0, 1, high)).chain((0..cycles).flat_map(one)).collect()
    }

    /// The bed at a time, with regulated pressures.
    ///
    /// # Errors
    /// [`LatticeError`] if the sheets cannot be modelled.
    pub fn bed(&self, time: f64) -> Result<Bed, LatticeError> {
        let layout = &self.layout;
        let lattice = Lattice::new(layout.intervals, layout.size(), layout.modulus)?;
        let beside = layout.neighbours().map(|(a, b, _)| [a, b]).collect();
        Ok(Bed {
            lattice,
            depth: layout.depth,
            tiles: self.tiles(time),
            friction: layout.friction,
            rubbing: layout.rubbing,
            beside,
            cover: layout.cover,
        })
    }

    /// Tiles at a time, with regulated pressures.
    #[must_use]
    pub fn tiles(&self, time: f64) -> Vec<Tile> {
        let tile = |tile: usize| {
            let order = self.order(tile, time);
            Tile { pose: self.layout.rim(tile, &order.command), air: Air::Regulated(order.pressure) }
        };
        (0..self.layout.count()).map(tile).collect()
    }
}
