//! The bed without a load: cost and error of a step.

use smartbed_bed::body::{Body, Segment, Shape};
use smartbed_bed::dynamics::{Matter, Method, Motion};
use smartbed_bed::equilibrium::side_by_side::cores;
use smartbed_bed::equilibrium::{Bed, State, Tile, solve};
use smartbed_bed::plan::Layout;
use smartbed_bed::pose::Pose;
use smartbed_bed::sheet::air::Air;
use smartbed_bed::sheet::{Lattice, membrane};
use smartbed_bed::tile::Command;
use smartbed_runtime::vec3::{dot, sub};
use std::f64::consts::TAU;

/// How long tiles move (s).
const SECONDS: f64 = 1.0;
/// The thesis' grid.
const THESIS: [usize; 2] = [28, 28];
/// Sheets are compared this often (s).
const EVERY: f64 = 0.2;

/// A value over time: its size, its frequency (Hz) and its phase.
type Course = fn(f64, f64, f64) -> f64;

/// Swings from 0 on.
fn smooth(time: f64, hertz: f64, phase: f64) -> f64 {
    (TAU * hertz * time + phase).sin() - phase.sin()
}

/// A ramp that begins and ends at once, as a plan's moves do.
fn ramp(time: f64, hertz: f64, phase: f64) -> f64 {
    TAU * hertz * time.min(0.6 * SECONDS) * phase.cos()
}

/// Twenty-eight tiles that all move, each its own way: screws at 3 mm/s and more, bladders that change by 1 kPa and
/// more.
fn busy(layout: &Layout, course: Course, time: f64) -> Bed {
    let lattice = Lattice::new(layout.intervals, layout.size(), layout.modulus).expect("a sheet");
    let tile = |tile: usize| {
        let value = |k: usize, hertz: f64| course(time, hertz, 0.7 * tile as f64 + k as f64);
        let slope = [0.01 * value(1, 0.2), 0.01 * value(2, 0.15)];
        let command = Command { heave: 2e-3 * value(0, 0.25), slope };
        let air = Air::Regulated(4000.0 + 1000.0 * value(3, 0.2));
        Tile { pose: layout.rim(tile, &command), air }
    };
    let beside = layout.neighbours().map(|(a, b, _)| [a, b]).collect();
    Bed {
        lattice,
        depth: layout.depth,
        tiles: (0..layout.count()).map(tile).collect(),
        friction: 0.4,
        rubbing: 0.0,
        beside,
        cover: smartbed_bed::equilibrium::Cover::default(),
    }
}

/// Processor time (s) of this thread so far, as Linux counts it.
fn processor() -> f64 {
    let text = std::fs::read_to_string("/proc/thread-self/schedstat").unwrap_or_default();
    text.split(' ').next().and_then(|word| word.parse::<f64>().ok()).map_or(f64::NAN, |ns| 1e-9 * ns)
}

/// Sheets in their tiles' frames, first at rest, then at each time that is compared; seconds that it took.
fn run(intervals: [usize; 2], course: Course, step: f64, is_f32: bool) -> (Vec<Vec<[f64; 3]>>, f64) {
    let layout = Layout { intervals, ..Layout::default() };
    let bed = busy(&layout, course, 0.0);
    let body = Body::default();
    let state = solve(&bed, &body, &bed.start(Vec::new())).expect("rests").state;
    let motion = Motion::new(bed, body, state, Matter::default(), Method::Bdf2, step);
    let mut motion = if is_f32 { motion.in_f32() } else { motion };
    let begin = processor();
    let mut seen = vec![motion.now.state.sheets.concat()];
    for moment in 1..=(SECONDS / EVERY).round() as usize {
        while motion.time() < moment as f64 * EVERY - 1e-9 {
            motion.step(|time| busy(&layout, course, time)).expect("a step");
        }
        seen.push(motion.now.state.sheets.concat());
    }
    (seen, processor() - begin)
}

/// Root mean square of the distances between two lists of positions.
fn apart(a: &[[f64; 3]], b: &[[f64; 3]]) -> f64 {
    let square = |(x, y): (&[f64; 3], &[f64; 3])| dot(sub(*x, *y), sub(*x, *y));
    (a.iter().zip(b).map(square).sum::<f64>() / a.len() as f64).sqrt()
}

/// Errors of steps, largest of all times over the largest way, and processor time a simulated second.
fn curve(course: Course, is_f32: bool, truth: &[Vec<[f64; 3]>], steps: &[f64]) -> Vec<(f64, f64)> {
    let way = truth.iter().map(|places| apart(places, &truth[0])).fold(0.0, f64::max);
    let one = |step: &f64| {
        let (seen, taken) = run(THESIS, course, *step, is_f32);
        let off = seen.iter().zip(truth).map(|(a, b)| apart(a, b)).fold(0.0, f64::max);
        println!(
            "{} {step} s: {:.1e} of {:.1} mm, {:.2} s a simulated second",
            if is_f32 { "f32" } else { "f64" },
            off / way,
            1e3 * way,
            taken / SECONDS
        );
        (off / way, taken / SECONDS)
    };
    steps.iter().map(one).collect()
}

#[test]
fn a_busy_bed_is_right_at_steps_that_keep_up_with_time() {
    // By `taskset -c 0` on one core, whose time is then this thread's.
    for course in [smooth as Course, ramp] {
        let (truth, _) = run(THESIS, course, 8e-3, false);
        let found = curve(course, false, &truth, &[0.2, 0.1, 0.05, 0.025]);
        assert!(found[0].0 > 1e-3 && found[2].0 < 1e-3 && found[3].0 < 0.3 * found[2].0, "{found:?}");
        assert!(cores() > 1 || found[2].1 < 1.0, "{found:?}");
        let single = curve(course, true, &truth, &[0.1, 0.05, 0.025]);
        assert!(single[0].0 > 1e-3 && single[1].0 < 1e-3 && single[2].0 < 1e-3, "{single:?}");
        // The same errors but for rounding, which makes numbers that are not the same.
        assert!((single[1].0 - found[2].0).abs() < 1e-4 && single[1].0 != found[2].0, "{single:?} {found:?}");
        assert!(cores() > 1 || single[1].1 < 1.0, "{single:?}");
    }
}

#[test]
fn a_sheet_comes_to_the_same_end_by_itself_and_with_the_bed() {
    // A ball out of reach of one tile and within reach of the other: where it touches nothing both move alike.
    let layout = Layout { rows: 1, columns: 2, intervals: [10, 12], is_sealed: true, ..Layout::default() };
    let at = |x: f64| {
        let mut bed = busy(&layout, smooth, 0.0);
        let state = solve(&bed, &Body::default(), &bed.start(Vec::new())).expect("rests").state;
        for (tile, sheet) in bed.tiles.iter_mut().zip(&state.sheets) {
            let [a, b] = layout.size();
            tile.air = Air::sealed(4000.0, a * b * layout.depth + membrane::volume(&bed.lattice, sheet), 1.4);
        }
        let airs: Vec<Air> = bed.tiles.iter().map(|tile| tile.air).collect();
        let body = Body::single(Segment {
            name: "ball".to_owned(),
            shape: Shape::ball(0.05).into(),
            mass: 1.0,
            centre: [0.0; 3],
            foundation: 1e6,
            free: [false; 6],
        });
        let state = State { segments: vec![Pose::at([x, 0.0, 0.1])], ..state };
        let mut motion = Motion::new(bed, body, state, Matter::default(), Method::Bdf2, 0.01);
        for _ in 0..50 {
            let told = |time: f64| {
                let mut bed = busy(&layout, ramp, time);
                bed.tiles.iter_mut().zip(&airs).for_each(|(tile, air)| tile.air = *air);
                bed
            };
            motion.step(told).expect("a step");
        }
        assert!(motion.now.contacts.iter().all(Vec::is_empty));
        motion.now.state.sheets.concat()
    };
    let [near, far] = [-0.1125, -5.0].map(at);
    assert!(apart(&near, &far) < 1e-9, "{}", apart(&near, &far));
}
