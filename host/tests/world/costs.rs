//! The cost of a step is proportional to the number of moving parts and contacts.

use super::support::{ELSEWHERE, least_times, parse, rubbing};
use smartbed::world::run::engine;
use std::time::{Duration, Instant};

/// Any two bladders may touch.
const NEIGHBOURS: &str = "[[contacts]]\nbetween = [\"bladder\", \"bladder\"]\nimpact = \"moreau\"\n";

/// The bed with so many tiles, and more in its text.
fn bed([columns, rows]: [usize; 2], more: &str) -> String {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/../models/scenes/bed.toml");
    let text = std::fs::read_to_string(path).expect("the scene");
    text.replace("count = [7, 4]", &format!("count = [{columns}, {rows}]")) + more
}

/// A closed sheet of so many nodes a side, one step long.
fn sheet(side: usize) -> String {
    format!(
        "format = 2\n[parts.ground]\nrigid = \"half_space\"\n[parts.sheet]\nshape = \"sheet\"\nrows = {side}\ncolumns = {side}\n\
         width = 2\ndepth = 2\nbase = 0.04\nmass = 1e-4\nK = 2e3\nC = 0.01\nstart = {{ position = [0, 0, 0.04] }}\n\
         gas = {{ gauge = 1e3, sealed = true }}\n\
         attach = [{{ nodes = \"rim\", to = \"ground\" }}, {{ facets = \"base\", to = \"ground\" }}]\n\
         [run]\nseconds = 1e-5\nstep = 1e-5\n"
    )
}

/// Processor time of this thread, if the system reports it; otherwise elapsed time.
fn spent(since: Instant) -> Duration {
    let told = std::fs::read_to_string("/proc/thread-self/schedstat").ok();
    let nanoseconds = told.and_then(|text| text.split_whitespace().next()?.parse().ok());
    nanoseconds.map_or_else(|| since.elapsed(), Duration::from_nanos)
}

/// From the text to the end of the first step. A machine that does other work, or has a hot processor, is slow for
/// minutes: there the first step may take as long as five later ones in the same minutes, which is no longer where
/// those take a fifth of the bar, as on a quiet core.
#[test]
fn a_sheet_of_200_x_200_takes_its_first_step_within_a_tenth_of_a_second() {
    let (text, begin) = (sheet(200), Instant::now());
    let (bar, mut first, mut later) = (Duration::from_millis(100), Duration::MAX, Duration::MAX);
    for _ in 0..40 {
        let start = spent(begin);
        let mut world = engine(&parse(&text).expect("a world")).expect("an engine");
        world.step(1e-5, &mut Vec::new()).expect("a step");
        let middle = spent(begin);
        world.step(1e-5, &mut Vec::new()).expect("a step");
        (first, later) = (first.min(middle - start), later.min(spent(begin) - middle));
        if first < bar {
            break;
        }
    }
    println!("from the text to the end of the first step: {first:?}; the next step: {later:?}");
    assert!(first < bar || first < 5 * later, "{first:?}, {later:?}");
}

/// The address space that a run may take is a straight line in the number of nodes.
#[test]
#[cfg(target_os = "linux")]
fn memory_is_linear_in_the_nodes_of_a_sheet() {
    for side in [100, 200, 300] {
        let file = super::support::scene(&format!("sheet_{side}"), &sheet(side));
        let kilobytes = 64 * 1024 + 3 * side * side;
        let program = env!("CARGO_BIN_EXE_smartbed");
        let command = format!("ulimit -v {kilobytes} && exec {program} run {file}");
        let output = std::process::Command::new("sh").args(["-c", &command]).output().expect("a shell");
        let said = String::from_utf8_lossy(&output.stderr);
        assert!(output.status.success(), "{side} x {side} within {kilobytes} KB: {said}");
    }
}

#[test]
fn a_step_costs_in_proportion_to_the_tiles() {
    for more in ["", NEIGHBOURS] {
        let counts = [[2, 2], [4, 4], [7, 4]];
        let each = |times: &[f64; 3]| [0, 1, 2].map(|k| times[k] / (counts[k][0] * counts[k][1]) as f64);
        // A cost by pairs of tiles would be seven times that of four at 28.
        let proportional = |times: &[f64; 3]| {
            let [four, sixteen, all] = each(times);
            sixteen < 2.0 * four && all < 2.0 * four
        };
        let times = least_times(counts.map(|count| bed(count, more)), 0, proportional);
        println!("4, 16, 28 tiles: {:?} s a step and tile", each(&times));
        assert!(proportional(&times), "{times:?}");
    }
}

/// Two boxes that bounce on one another and on the ground, with friction, beside a flexible part: eight redundant
/// contacts come to rest together. Sweeps over gaps that no position closes all at once took minutes.
#[test]
fn two_boxes_that_bounce_on_one_another_come_to_rest_in_a_short_time() {
    let of_box = |name: &str, size: f64, start: &str| {
        format!(
            "[parts.{name}]\nrigid = \"box\"\nsize = [{size}, {size}, 0.1]\nmass = 1\nstart = {{ {start} }}\n"
        )
    };
    let text = [
        "format = 2\n[parts.ground]\nrigid = \"half_space\"\n".to_owned(),
        of_box("lower", 0.2, "height = 0.05, axis = [0, 1, 0], angle = 0.1"),
        of_box("upper", 0.15, "position = [0.01, 0.012, 0], height = 0.25"),
        ELSEWHERE.to_owned(),
        rubbing("lower", "ground", 0.5),
        rubbing("upper", "lower", 0.5),
        "[run]\nseconds = 0.3\nstep = 1e-3\n".to_owned(),
    ]
    .concat();
    let mut world = engine(&parse(&text).expect("a world")).expect("an engine");
    let begin = Instant::now();
    let start = spent(begin);
    for _ in 0..300 {
        world.step(1e-3, &mut Vec::new()).expect("a step");
    }
    let time = spent(begin) - start;
    println!("300 steps: {time:?}");
    assert!(time < Duration::from_secs(15), "{time:?}");
}
