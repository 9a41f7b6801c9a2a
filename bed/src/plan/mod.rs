//! A plan of the bed: tiles, what lies on them, and what tiles are told over time.
//!
//! In: sizes and moves, as numbers. Out: what each tile is told at a time ([`Plan::order`]), what is wrong with that
//! ([`check`]), and what happens ([`run`]).

pub mod check;
pub mod history;
pub mod maps;
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

/// Tiles and their limits.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Layout {
    /// Rows of tiles, the first at the head.
    pub rows: usize,
    /// Columns.
    pub columns: usize,
    /// Distance of tiles along x and y (m).
    pub pitch: [f64; 2],
    /// Between the rims of neighbours (m).
    pub gap: f64,
    /// Height of a bladder below its rim (m).
    pub depth: f64,
    /// E t of the sheets (N/m).
    pub modulus: f64,
    /// Intervals of a sheet along x and y.
    pub intervals: [usize; 2],
    /// Coulomb's coefficient of skin on sheets.
    pub friction: f64,
    /// That of sheets on sheets of neighbours.
    pub rubbing: f64,
    /// Radius of the screws' circle (m).
    pub circle: f64,
    /// Way of a screw (m), half of it up and half down.
    pub stroke: f64,
    /// Fastest a screw goes (m/s).
    pub speed: f64,
    /// Largest step between edges of neighbours (m).
    pub step: f64,
    /// Largest pressure (Pa).
    pub most_pressure: f64,
    /// Rim above the star (m).
    pub above: f64,
    /// Valves are shut between changes of pressure.
    pub is_sealed: bool,
    /// What is mounted on the sheets.
    pub cover: Cover,
    /// n of p V^n in a sealed bladder: 1 where its gas keeps the temperature, 1.4 where nothing is quick enough to.
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
    /// The air of a bladder whose valves are shut at a volume (m^3), if they are not already.
    #[must_use]
    pub fn shut(&self, air: Air, volume: f64) -> Air {
        match air {
            Air::Regulated(gauge) => Air::sealed(gauge, volume, self.exponent),
            Air::Sealed(..) => air,
        }
    }

    /// Tiles.
    #[must_use]
    pub fn count(&self) -> usize {
        self.rows * self.columns
    }

    /// Size of a sheet (m).
    #[must_use]
    pub fn size(&self) -> [f64; 2] {
        self.pitch.map(|p| p - self.gap)
    }

    /// Nodes of a sheet along x and y that pictures show: nine at most, rims among them.
    #[must_use]
    pub fn shown(&self) -> [Vec<usize>; 2] {
        self.intervals.map(|n| {
            let count = n.clamp(1, 8);
            (0..=count).map(|k| (k * n + count / 2) / count).collect()
        })
    }

    /// Middle of a tile (m); the bed's middle is the origin, the head lies towards +y.
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

    /// Neighbours: the tile to the left or nearer to the head first, and whether they lie side by side along x.
    pub fn neighbours(&self) -> impl Iterator<Item = (usize, usize, bool)> {
        let (columns, count) = (self.columns, self.count());
        (0..count).flat_map(move |tile| {
            let beside = (tile % columns + 1 < columns).then_some((tile, tile + 1, true));
            let below = (tile + columns < count).then_some((tile, tile + columns, false));
            beside.into_iter().chain(below)
        })
    }
}

/// What a tile is told.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Order {
    /// Gauge pressure (Pa).
    pub pressure: f64,
    /// Heave and slopes.
    pub command: Command,
}

/// A change of what some tiles are told.
#[derive(Clone, Debug, PartialEq)]
pub struct Move {
    /// When it begins (s).
    pub at: f64,
    /// How long it takes (s).
    pub over: f64,
    /// Tiles, from 0.
    pub tiles: Vec<usize>,
    /// Gauge pressure (Pa).
    pub pressure: Option<f64>,
    /// m.
    pub heave: Option<f64>,
    /// Slopes towards +x and +y.
    pub slope: Option<[f64; 2]>,
}

/// What lies on the bed.
#[derive(Clone, Debug, PartialEq)]
pub struct Load {
    /// Segments and joints.
    pub body: Body,
    /// Where they are before they are put down (m).
    pub poses: Vec<Pose>,
    /// The figure, if it is one: regions of its skin.
    pub figure: Option<Figure>,
}

impl Load {
    /// Lifts all segments so far that none begins inside a bladder, and shifts them.
    #[must_use]
    pub fn placed(mut self, [x, y]: [f64; 2]) -> Load {
        let bottom = |(segment, pose): (&crate::body::Segment, &Pose)| {
            pose.place[2] - segment.shape.extent(pose.attitude.to_body([0.0, 0.0, -1.0]))
        };
        let lowest = self.body.segments.iter().zip(&self.poses).map(bottom).fold(f64::INFINITY, f64::min);
        // Bladders bulge by some 40 mm; tissue and sheets give way to as much.
        let up = 0.03 - lowest;
        for pose in &mut self.poses {
            let way: Vec3<f64> = [x, y, up];
            pose.place = smartbed_runtime::vec3::add(pose.place, way);
        }
        self
    }
}

/// How what happens is computed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Clock {
    /// One equilibrium after the other.
    QuasiStatic,
    /// Motion.
    Dynamics(Dynamics),
}

/// How motion is computed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Dynamics {
    /// Longest step (s).
    pub step: f64,
    /// Method of steps.
    pub method: Method,
    /// Where the load begins.
    pub start: Start,
    /// Masses and losses.
    pub matter: Matter,
    /// What happens where sheets come to touch the load.
    pub impact: Impact,
    /// An empty bed's sheets move in f32.
    pub is_f32: bool,
}

/// Where a load begins to move.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Start {
    /// This far (m) above the sheets, let go.
    Dropped(f64),
    /// In the equilibrium that the other clock begins with.
    AtRest,
}

/// How a load comes to lie where equilibria begin: friction keeps what it was like.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Laying {
    /// Straight down with all its weight, then let go.
    AtOnce,
    /// Its weight in so many equal parts.
    InParts(usize),
    /// It falls as motion says, and settles for so long (s).
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

/// Height (m) that a load falls from where none is told.
pub const DROP: f64 = 0.02;

/// A plan.
#[derive(Clone, Debug, PartialEq)]
pub struct Plan {
    /// What it is called.
    pub title: String,
    /// Tiles.
    pub layout: Layout,
    /// Pressure of all bladders at the start (Pa).
    pub pressure: f64,
    /// What lies on the bed.
    pub load: Load,
    /// Changes, by when they begin.
    pub moves: Vec<Move>,
    /// How long (s).
    pub seconds: f64,
    /// Between two equilibria (s).
    pub every: f64,
    /// Length of a cycle for metrics (s).
    pub cycle: f64,
    /// How what happens is computed.
    pub clock: Clock,
    /// How the load comes to lie before the first equilibrium.
    pub laying: Laying,
}

impl Plan {
    /// What a tile is told at a time: moves one after the other, each from what was told when it began.
    #[must_use]
    pub fn order(&self, tile: usize, time: f64) -> Order {
        self.told(tile, time, |change| change.at <= time)
    }

    /// The same just before: without moves that begin at that time.
    #[must_use]
    pub fn order_before(&self, tile: usize, time: f64) -> Order {
        self.told(tile, time, |change| change.at < time)
    }

    fn told(&self, tile: usize, time: f64, has_begun: impl Fn(&Move) -> bool) -> Order {
        let mut order = Order { pressure: self.pressure, command: Command::default() };
        for change in self.moves.iter().filter(|m| has_begun(m) && m.tiles.contains(&tile)) {
            let done = if change.over > 0.0 { ((time - change.at) / change.over).min(1.0) } else { 1.0 };
            let towards = |from: f64, to: Option<f64>| to.map_or(from, |to| from + done * (to - from));
            order.pressure = towards(order.pressure, change.pressure);
            order.command.heave = towards(order.command.heave, change.heave);
            let slope = order.command.slope;
            order.command.slope = [0, 1].map(|k| towards(slope[k], change.slope.map(|s| s[k])));
        }
        order
    }

    /// The same plan with more moves.
    #[must_use]
    pub fn with(&self, moves: &[Move]) -> Plan {
        let mut plan = self.clone();
        plan.moves.extend_from_slice(moves);
        plan.moves.sort_by(|a, b| a.at.total_cmp(&b.at));
        plan
    }

    /// Times of all equilibria (s): the grid of `every`.
    #[must_use]
    pub fn times(&self) -> Vec<f64> {
        let count = (self.seconds / self.every + 1e-9).floor() as usize;
        (0..=count).map(|k| k as f64 * self.every).collect()
    }

    /// Alternating pressure: two groups of tiles, as the squares of a chess board, in turn low for five twelfths of a
    /// cycle, both high for a twelfth between (250 s, 50 s, 250 s, 50 s of 600 s).
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
        let cycles = (seconds / cycle).ceil() as usize;
        let one = |n: usize| {
            let start = n as f64 * cycle;
            [(0.0, 0, low), (5.0, 0, high), (6.0, 1, low), (11.0, 1, high)]
                .map(|(at, k, pressure)| turn(start + at * twelfth, k, pressure))
        };
        (0..cycles).flat_map(one).collect()
    }

    /// The bed at a time, regulated.
    ///
    /// # Errors
    /// [`LatticeError`] for sheets that cannot be.
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

    /// Tiles at a time, regulated.
    #[must_use]
    pub fn tiles(&self, time: f64) -> Vec<Tile> {
        let tile = |tile: usize| {
            let order = self.order(tile, time);
            Tile { pose: self.layout.rim(tile, &order.command), air: Air::Regulated(order.pressure) }
        };
        (0..self.layout.count()).map(tile).collect()
    }
}
