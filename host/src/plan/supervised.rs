//! Checks a plan's orders by the code that runs in a tile's controller and in the supervisor of several tiles.
//!
//! In: a plan, a time. Out: the first order from then on that the tile's controller refuses or the supervisor denies,
//! with the limit and the tile. Each order goes through the controller's own functions (mode, pressure, heights, time
//! of the way) and through `supervisor::Bed::order`, to whose peers the state of every tile at that time is reported.
//! Drives, valves and faults are not simulated: a tile is where the plan has ordered it to be, and moves as long as the
//! plan's move lasts.

use smartbed_bed::plan::check::Refusal;
use smartbed_bed::plan::{Layout, Move, Plan};
use smartbed_bed::policy::Supervisor;
use smartbed_bed::tile;
use smartbed_firmware::command::Pose;
use smartbed_firmware::link::message::{
    self, Command, Header, Outcome, REPORT, Report, State, Target, VERSION, write,
};
use smartbed_firmware::link::tag::Key;
use smartbed_firmware::supervisor::{Bed, Denied, MOST_MOVING, Peer};
use smartbed_firmware::tile::bladder;
use smartbed_firmware::tile::design::{HALF_SIDES, PRESSURE, RADIUS, SLOPE, STEP_LIMIT, STROKE};
use smartbed_firmware::tile::fault::Faults;
use smartbed_firmware::tile::mode::Mode;
use smartbed_firmware::tile::motion::{Motion, heights};
use smartbed_firmware::tile::profile::TICK;

/// Tolerance for times (s), which are sums of steps: a move may begin exactly when another ends.
const ROUNDING: f64 = 1e-6;
/// Lengths (m) of a plan and of the controller that differ by less count as equal.
const ALIKE: f64 = 1e-4;

/// The supervisor made of the firmware's own code.
#[derive(Clone, Copy, Debug)]
pub struct Controller;

impl Supervisor for Controller {
    fn check(&self, plan: &Plan, from: f64) -> Result<(), Refusal> {
        let mut tiles = Tiles::new(plan);
        for told in plan.moves.iter().filter(|m| m.at >= from || m.at + m.over > from) {
            for tile in &told.tiles {
                let judged = tiles.order(told, *tile);
                // Earlier orders were checked then.
                let judged = if told.at >= from { judged } else { Ok(()) };
                judged.map_err(|what| Refusal { time: told.at, tile: Some(*tile + 1), what })?;
            }
        }
        Ok(())
    }
}

/// Why the controller does not fit this bed; `None` if it does.
pub(super) fn misfit(layout: &Layout) -> Option<String> {
    let own = [2.0 * f64::from(HALF_SIDES.0), 2.0 * f64::from(HALF_SIDES.1), f64::from(RADIUS)];
    let [x, y] = layout.pitch;
    let is_alike = own.iter().zip([x, y, layout.circle]).all(|(a, b)| (a - b).abs() < ALIKE);
    let [a, b, c] = own.map(|x| 1e3 * x);
    (!is_alike).then(|| {
        format!(
            "the tiles' controller is made for a `pitch` of {a:.1} by {b:.1} mm and a `circle` of {c:.1} mm"
        )
    })
}

/// Tiles as their supervisor knows them.
struct Tiles<'a> {
    plan: &'a Plan,
    /// Row by row from the foot, because a pose's y points to the head.
    peers: Vec<Peer>,
    /// The time (s) until which each tile moves, by its index in the plan.
    until: Vec<f64>,
}

impl Tiles<'_> {
    fn new(plan: &Plan) -> Tiles<'_> {
        let count = plan.layout.count();
        // Nothing is sent, so that any key will do.
        let peers = (0..count).map(|number| Peer::new(number as u8, Key::new([0; 16]))).collect();
        Tiles { plan, peers, until: vec![f64::NEG_INFINITY; count] }
    }

    /// Index of a tile of the plan among the peers.
    fn place(&self, tile: usize) -> usize {
        let Layout { rows, columns, .. } = self.plan.layout;
        (rows - 1 - tile / columns) * columns + tile % columns
    }

    fn mode(&self, tile: usize, time: f64) -> Mode {
        if time < self.until[tile] - ROUNDING { Mode::Moving } else { Mode::Ready }
    }

    /// Pose of a tile when the moves of that time are ordered.
    fn pose(&self, tile: usize, time: f64) -> Pose {
        pose(&self.plan.order_before(tile, time).command)
    }

    /// Reports the state of all tiles to their peers.
    fn report(&mut self, time: f64) {
        for tile in 0..self.until.len() {
            let heights = self.pose(tile, time).heights(RADIUS);
            let state = State { mode: self.mode(tile, time) as u8, heights, ..State::default() };
            self.tell(tile, &Report::State(state), time);
        }
    }

    /// Reports something of a tile to its peer.
    fn tell(&mut self, tile: usize, report: &Report, time: f64) {
        let place = self.place(tile);
        let (peer, tick) = (&mut self.peers[place], ticks(time));
        let header = Header { version: VERSION | REPORT, tile: peer.tile(), boot: 1, sequence: 0, tick };
        write(&header, report).and_then(|body| peer.take(&body, tick));
    }

    /// Checks one tile's part of a move by the tile's controller, then by the supervisor.
    fn order(&mut self, told: &Move, tile: usize) -> Result<(), String> {
        let mode = self.mode(tile, told.at);
        let allow = |command: &Command| {
            mode.allows(command, (true, mode == Mode::Moving), Faults::default()).map_err(refused)
        };
        if let Some(pressure) = told.pressure {
            let pressure = bladder::commanded(pressure as f32).map_err(refused)?;
            allow(&Command::Pressure(pressure))?;
        }
        if told.heave.is_none() && told.slope.is_none() {
            return Ok(());
        }
        let mut command = self.plan.order_before(tile, told.at).command;
        command.heave = told.heave.unwrap_or(command.heave);
        command.slope = told.slope.unwrap_or(command.slope);
        let there = pose(&command);
        let target = Target { heave: there.zc, slope_x: there.tx, slope_y: there.ty };
        self.report(told.at);
        self.until[tile] = told.at + told.over;
        allow(&Command::Move(target))?;
        let ways = [self.pose(tile, told.at).heights(RADIUS), heights(there).map_err(refused)?];
        let takes = f64::from(Motion::new(ways[0], ways[1], 1.0).ticks()) * f64::from(TICK);
        if takes > told.over + f64::from(TICK) {
            let over = told.over;
            return Err(format!(
                "its controller needs {takes:.1} s for a move of {over:.1} s; give the move more time (`over`)"
            ));
        }
        let (place, columns) = (self.place(tile), self.plan.layout.columns);
        let mut bed = Bed { peers: &mut self.peers, columns };
        let body = bed.order(place, target, ticks(told.at), 0).map_err(denied)?;
        if let Ok(received) = message::read(&body) {
            let carried_out = Report::Answer(received.header.sequence, Outcome::Done);
            self.tell(tile, &carried_out, told.at);
        }
        Ok(())
    }
}

fn pose(command: &tile::Command) -> Pose {
    let [tx, ty] = command.slope.map(|slope| slope as f32);
    Pose { zc: command.heave as f32, tx, ty }
}

/// A time (s) in ticks of the supervisor's clock (ms).
fn ticks(time: f64) -> u32 {
    (time / f64::from(TICK)).round() as u32
}

/// The message if the tile's controller refuses.
fn refused(why: message::Refusal) -> String {
    let most = match why {
        message::Refusal::Stroke => format!(": {:.1} mm up and down at most", 1e3 * STROKE),
        message::Refusal::Tilt => format!(": {:.1} deg at most", SLOPE.atan().to_degrees()),
        message::Refusal::Pressure => format!(": 0 to {:.3} kPa", 1e-3 * PRESSURE),
        _ => String::new(),
    };
    format!("its controller refuses: {}{most}", why.words())
}

/// The message if the supervisor denies.
fn denied(why: Denied) -> String {
    let most = match why {
        Denied::Step => {
            format!(", where that is or will be: {:.1} mm at most", 1e3 * STEP_LIMIT)
        }
        Denied::Power => {
            format!(": {MOST_MOVING} at once at most")
        }
        _ => String::new(),
    };
    format!("the supervisor refuses: {}{most}", why.words())
}
