//! Separate parts are stepped separately; slow parts stand still, if the scene says so.

use super::support::{json, least_times, number, rows, scene, settled};
use std::fmt::Write as _;

/// A cube of springs that falls from so high (m) at this place, with a floor of its own under it.
fn cube(name: &str, [x, height]: [f64; 2], law: &str) -> String {
    format!(
        "[parts.{name}_floor]\nrigid = \"box\"\nsize = [0.5, 0.5, 0.1]\nfixed = true\nstart = {{ position = [{x}, 0, -0.05] }}\n\
         [parts.{name}]\nshape = \"cube\"\nside = 0.1\nmass = 0.1\nK = 500\nC = 0.3\nair_drag = 0.02\n\
         start = {{ position = [{x}, 0, {height}] }}\n\
         [[contacts]]\nbetween = [\"{name}\", \"{name}_floor\"]\n{law}\n"
    )
}

/// A tile, commanded so, with its bladder; as many as the counts say.
fn tiles(name: &str, command: &str, grid: &str) -> String {
    format!(
        "[parts.{name}]\nmechanism = \"tile_minimal\"\ncommand = {{ hA = \"{command}\", hB = \"{command}\", hC = \"{command}\" }}\n{grid}\n\
         [parts.{name}_bladder]\nshape = \"sheet\"\nrows = 5\ncolumns = 5\nwidth = 0.28\ndepth = 0.28\nbase = 0.04\nmass = 0.04\n\
         K = 2e3\nC = 2\nair_drag = 0.4\nstart = {{ position = [-0.14, -0.14, 0.05] }}\ngas = {{ gauge = 300, sealed = true }}\n\
         attach = [{{ nodes = \"rim\", to = \"{name}.platform\" }}, {{ facets = \"base\", to = \"{name}.platform\" }}]\n{grid}\n"
    )
}

const RISING: &str = "5_mm*(1 - cos(2*pi*t/2_s))";

#[test]
fn parts_that_are_apart_step_as_they_do_alone_bit_for_bit() {
    let end = "[run]\nseconds = 0.3\nstep = 1e-3\n";
    for law in ["impact = \"moreau\"\nfriction = 0.3", "impact = \"newton\"\nrestitution = 0.5"] {
        let (one, other) = (cube("one", [0.0, 0.12], law), cube("other", [2.0, 0.2], law));
        let said = |name: &str, text: &str| rows(&[&scene(name, &format!("format = 2\n{text}{end}"))]);
        let both = said("apart", &format!("{one}{other}"));
        let alone = [said("one_alone", &one), said("other_alone", &other)];
        for (name, alone) in ["one", "other"].into_iter().zip(&alone) {
            let mut compared = 0;
            for (own, column) in
                alone.0.iter().enumerate().filter(|(_, c)| c.starts_with(&format!("{name}.")))
            {
                let there = both.0.iter().position(|c| c == column).expect("the same columns");
                for (a, b) in alone.1.iter().zip(&both.1) {
                    assert_eq!(a[own], b[there], "{law}: {column} at {}", a[0]);
                    compared += 1;
                }
            }
            assert!(compared > 1000, "{compared}");
        }
        // The accounts are the sum of both.
        let last = |(names, rows): &(Vec<String>, Vec<Vec<f64>>), name: &str| {
            rows[rows.len() - 1][names.iter().position(|own| own == name).expect("a column")]
        };
        for account in ["kinetic", "spring", "damping", "impact", "imbalance"] {
            let sum = last(&alone[0], account) + last(&alone[1], account);
            assert!((last(&both, account) - sum).abs() < 1e-13, "{law}: {account} {sum:e}");
        }
    }
}

/// Steps cost in proportion to moving parts: of 28 tiles one rises, then four, then all; the others are at rest.
#[test]
fn a_step_costs_what_moves_of_28_tiles() {
    let run = |sleep: &str| format!("[run]\nseconds = 1\nstep = 1e-3\n{sleep}\n");
    let sleep = run("sleep = \"10 mm/s\"");
    let mover = |count: usize| {
        tiles("mover", RISING, &format!("grid = {{ count = [{count}, 1], pitch = [0.3, 0.3] }}"))
    };
    let still = |count: usize| {
        tiles("still", "5_mm", &format!("grid = {{ count = [{count}, 1], pitch = [0.3, 0.3] }}"))
    };
    let alone = format!("format = 2\n{}{}", tiles("mover", RISING, ""), run(""));
    let one = format!("format = 2\n{}{}{sleep}", tiles("mover", RISING, ""), still(27));
    let four = format!("format = 2\n{}{}{sleep}", mover(4), still(24));
    let all = format!("format = 2\n{}{}", mover(28), run(""));
    let proportional =
        |&[alone, one, four, all]: &[f64; 4]| one < 1.5 * alone && four < 6.0 * alone && all > 5.0 * one;
    let least @ [alone, one, four, all] = least_times([alone, one, four, all], 800, proportional);
    println!("steps: alone {alone:.2e} s, one of 28 {one:.2e}, four {four:.2e}, all {all:.2e}");
    assert!(proportional(&least), "{least:?}");
}

/// A ball falls on a cube that sleeps: it wakes before they meet, and both move as if it had never slept.
#[test]
fn what_sleeps_wakes_when_something_comes_near() {
    let text = |sleep: &str| {
        let cube = cube("one", [0.0, 0.0], "impact = \"moreau\"\nfriction = 0.3");
        let mut text = format!("format = 2\n{}", cube.replace("C = 0.3", "C = 2").replace("0.02", "0.1"));
        let _ = write!(
            text,
            "[parts.ball]\nrigid = \"sphere\"\nradius = 0.05\nmass = 0.05\nstart = {{ position = [0, 0, 3] }}\n\
             [[contacts]]\nbetween = [\"ball\", \"one\"]\nimpact = \"moreau\"\n\
             [run]\nseconds = 0.9\nstep = 2e-4\nevery = 50\nstart = \"given\"\n{sleep}\n"
        );
        text
    };
    let awake = rows(&[&scene("never_sleeps", &text(""))]);
    let sleeps = rows(&[&scene("sleeps", &text("sleep = \"1 mm/s\""))]);
    let column = |name: &str| awake.0.iter().position(|own| own == name).expect("a column");
    let (t, ball, top, imbalance) = (column("t"), column("ball.z"), column("one.top"), column("imbalance"));
    let stood = sleeps.1.windows(2).filter(|pair| pair[0][top] == pair[1][top]).count();
    assert!(stood > 10, "it slept over {stood} rows");
    let moved = sleeps.1.iter().any(|row| row[t] > 0.75 && (row[top] - sleeps.1[40][top]).abs() > 1e-3);
    assert!(moved, "the ball presses it");
    for (a, b) in awake.1.iter().zip(&sleeps.1) {
        assert!((a[ball] - b[ball]).abs() < 1e-4 && (a[top] - b[top]).abs() < 1e-4, "at {}", a[t]);
        assert!(b[imbalance].abs() < 1e-3, "{:e} at {}", b[imbalance], b[t]);
    }
}

/// A run stopped while one part sleeps and then resumed equals the uninterrupted run.
#[test]
fn what_sleeps_goes_on_sleeping_when_a_run_is_resumed() {
    let text = format!(
        "format = 2\n{}{}[run]\nseconds = 0.8\nstep = 1e-3\nsleep = \"1 mm/s\"\n",
        tiles("still", "5_mm", ""),
        tiles("mover", RISING, ""),
    );
    let file = scene("sleeps_and_goes_on", &text);
    let state = format!("{file}.state");
    let whole = json(&[&file]);
    json(&[&file, "--seconds", "0.5", "--save", &state]);
    let resumed = json(&[&file, "--seconds", "0.8", "--resume", &state]);
    assert_eq!(whole["last"], resumed["last"]);
}

/// Air that a controller lets out of a bladder at rest moves it again.
#[test]
fn what_sleeps_wakes_when_a_controller_changes_its_input() {
    let text = |sleep: &str| {
        let bladder = tiles("still", "5_mm", "").replace(
            "gas = { gauge = 300, sealed = true }",
            "gas = { gauge = 300, sealed = true, vent = { conductance = \"1e-7 m^3/(s Pa)\", opening = 0 } }",
        );
        format!(
            "format = 2\n{bladder}[controllers.valve]\nreads = \"still_bladder.gauge\"\ndrives = \"still_bladder.vent\"\nperiod = 0.01\n\
             target = [[0, 1000], [0.6, 0]]\ngain = -0.01\nlimits = [0, 1]\n\
             [run]\nseconds = 1\nstep = 1e-3\nevery = 20\n{sleep}\n"
        )
    };
    let (names, awake) = rows(&[&scene("air_awake", &text(""))]);
    let (_, slept) = rows(&[&scene("air_sleeps", &text("sleep = \"10 mm/s\""))]);
    let gauge = names.iter().position(|own| own == "still_bladder.gauge").expect("a column");
    let stood = slept.windows(2).filter(|pair| pair[0][gauge] == pair[1][gauge]).count();
    assert!(stood > 3, "it slept over {stood} rows");
    let (a, b) = (awake[awake.len() - 1][gauge], slept[slept.len() - 1][gauge]);
    assert!(a < 200.0 && (a - b).abs() < 0.02 * a, "{a} and {b} Pa");
}

#[test]
fn rigid_parts_alone_are_never_put_to_sleep() {
    let said = super::support::fails(&["run", "box_bounce", "--set", "run.sleep=0.001"]);
    assert!(said.contains("run.sleep") && said.contains("leave the key out"), "{said}");
    let said = super::support::fails(&["run", "bed", "--set", "run.sleep=0"]);
    assert!(said.contains("sleep"), "{said}");
    let rest = settled(&["ball_on_bladder", "--set", "run.sleep=0.001"]);
    assert!(number(&rest["steps"]) > 0.0, "{rest}");
}
