//! What is known to be wrong only once a world is built is told with its place in the text, too.

use super::support::{fails, parse, scene, unread};

/// A mechanism with an input that no law gives.
const ARM: &str = "format = 2\n[parts.arm]\nmechanism = \"double_pendulum\"\n";
/// A controller of it.
const HELD: &str = "reads = \"arm.q1\"\ndrives = \"arm.T\"\ntarget = 0\nperiod = 0.001\n";

/// The message for a scene: the words, the place `line:column`, and what to do.
fn told(lines: &str, options: &[&str], words: &str, place: &str) {
    let said = fails(&[&["run", &scene("placed", lines)], options].concat());
    assert!(said.contains(words), "{words}\n{said}");
    assert!(said.contains(&format!("{place}\n")), "{words}: expected {place}\n{said}");
    assert!(said.contains("help: "), "what to do\n{said}");
}

#[test]
fn sensors_are_refused_where_they_stand() {
    let sensor = |lines: &str| format!("{ARM}[sensors.s]\n{lines}\n");
    let cases = [
        ("of = \"arm.q3\"", "sensors.s: no number `arm.q3` in the rows", 5, 6),
        ("of = \"kinetic\"", "sensors.s: no number `kinetic` in the rows", 5, 6),
        ("of = \"arm.q1\"\nunit = \"N\"", "sensors.s: `unit` is that of a number in N", 6, 8),
        (
            "of = \"arm.q1\"\nperiod = \"1.5_ms\"",
            "sensors.s: period = 0.0015 s is no whole number of steps",
            6,
            10,
        ),
        (
            "of = \"arm.q1\"\ndelay = \"0.5_ms\"",
            "sensors.s: delay = 0.0005 s is no whole number of steps",
            6,
            9,
        ),
        ("of = \"arm.q1\"\ndelay = \"0.1_s\"", "sensors.s: `delay` is 100 steps, `period` 1", 6, 9),
        ("of = \"arm.q1\"\nperiod = 1e-12", "sensors.s: `period` is shorter than a step", 6, 10),
        ("of = \"arm.q1\"\nrange = [1, 0]", "sensors.s: a number of it is out of range", 4, 10),
    ];
    for (lines, words, line, column) in cases {
        told(&sensor(lines), &[], words, &format!("placed.toml:{line}:{column}"));
    }
    // A setting is a text of its own.
    let fine = sensor("of = \"arm.q1\"");
    told(&fine, &["--set", "sensors.s.of=arm.q3"], "no number `arm.q3`", "--set:1:16");
}

#[test]
fn controllers_are_refused_where_they_stand() {
    let held = |from: &str, to: &str| format!("{ARM}[controllers.c]\n{}", HELD.replace(from, to));
    let cases = [
        (held("arm.q1", "arm.q3"), "controllers.c: no number `arm.q3` in the rows or of a sensor", 5, 9),
        (
            held("arm.q1", "sensors.s"),
            "controllers.c: no number `sensors.s` in the rows or of a sensor",
            5,
            9,
        ),
        (held("arm.T", "arm.F"), "controllers.c: `arm.F` is no valve and no free input", 6, 10),
        (held("0.001", "0.0015"), "controllers.c: period = 0.0015 s is no whole number of steps", 8, 10),
        (held("target", "unit = \"m\"\ntarget"), "controllers.c: `unit` is that of a number in m", 7, 8),
        (
            format!("{ARM}[controllers.c]\n{HELD}[controllers.d]\n{HELD}"),
            "controllers.d: `arm.T` is driven by controllers.c already",
            11,
            10,
        ),
    ];
    for (text, words, line, column) in cases {
        told(&text, &[], words, &format!("placed.toml:{line}:{column}"));
        // A choice of the method, too, says where.
        told(&text, &["--error", "1e-3"], words, &format!("placed.toml:{line}:{column}"));
    }
}

const GROUND: &str = "format = 2\n[parts.ground]\nrigid = \"half_space\"\n";
const BALL: &str = "[parts.ball]\nrigid = \"sphere\"\nradius = 0.1\nmass = 1\nstart = { height = 1 }\n";
const CUBE: &str = "[parts.cube]\nshape = \"cube\"\nstart = { height = 1 }\n";

/// A pair with its law, in lines of its own.
fn pair(one: &str, other: &str, impact: &str) -> String {
    format!("[[contacts]]\nbetween = [\"{one}\", \"{other}\"]\nimpact = \"{impact}\"\n")
}

#[test]
fn methods_and_steps_are_refused_where_they_stand() {
    let run = |key: &str| format!("[run]\n{key}\n");
    let moreau = pair("cube", "ground", "moreau");
    let stronge = pair("cube", "ground", "stronge");
    let cases = [
        (format!("{GROUND}{CUBE}{}", run("method = \"rk5\"")), "there is no such method for worlds", "8:10"),
        (format!("{GROUND}{CUBE}{}", run("method = \"moreau\"")), "this world has no contacts", "8:10"),
        (format!("{GROUND}{CUBE}{stronge}{}", run("method = \"moreau\"")), "it needs whole steps", "11:10"),
        (
            format!("{GROUND}{CUBE}{moreau}{}", run("method = \"rk4\"")),
            "need a method of whole steps",
            "11:10",
        ),
        (
            format!("{GROUND}{BALL}{}", run("method = \"rk4\"")),
            "rigid bodies have a step of their own",
            "10:10",
        ),
        (format!("{GROUND}{BALL}{}", run("sleep = 0.1")), "are never put to sleep", "10:9"),
        (format!("{GROUND}{CUBE}{}", run("step = 1")), "run.step = 1 s is larger than", "8:8"),
        (format!("{GROUND}{CUBE}K = 1e12\n"), "run.step = 0.001 s is larger than", "7:5"),
    ];
    for (text, words, place) in cases {
        told(&text, &[], words, &format!("placed.toml:{place}"));
    }
    let cube = format!("{GROUND}{CUBE}");
    told(&cube, &["--method", "rk5"], "there is no such method for worlds", "--set:1:14");
}

#[test]
fn parts_are_refused_where_they_stand() {
    let other = CUBE.replace("parts.cube", "parts.other").replace("height = 1", "height = 3");
    told(
        &format!("{GROUND}{CUBE}air_drag = 1\n{other}air_drag = 2\n"),
        &[],
        "`other`: air_drag differs from that of another flexible part",
        "placed.toml:11:12",
    );
    let sunk = CUBE.replace("height = 1", "height = -0.01");
    told(
        &format!("{GROUND}{sunk}{}", pair("cube", "ground", "moreau")),
        &[],
        "`cube` and `ground` overlap by 1.000e-2 m at the start",
        "placed.toml:6:1",
    );
    // What stands on a port is placed once the mechanism is assembled.
    let tip = "[parts.tip]\nrigid = \"sphere\"\nradius = 0.1\non = \"arm.tool\"\n";
    let wall = "[parts.wall]\nrigid = \"box\"\nsize = [9, 9, 9]\nmass = 1\n";
    let arm = "format = 2\n[parts.arm]\nmechanism = \"arm6\"\n";
    told(
        &format!("{arm}{tip}{wall}{}", pair("tip", "wall", "moreau")),
        &[],
        "`tip` and `wall` overlap by",
        "placed.toml:4:8",
    );
    told(
        &format!(
            "{GROUND}{CUBE}[parts.pad]\nrigid = \"sphere\"\nradius = 1\nfixed = true\nstart = {{ height = 9 }}\n{}",
            pair("pad", "ground", "moreau")
        ),
        &[],
        "`pad` and `ground` are both fixed or follow commands",
        "placed.toml:13:11",
    );
}

/// The message of a scene that is refused when it is read, at `line:column`.
fn unread_at(text: &str, words: &str, place: &str) {
    unread(text, words, &format!("{place}\n"));
}

#[test]
fn pairs_that_no_world_has_are_refused_when_they_are_read() {
    let tile = "[parts.tile]\nmechanism = \"tile_minimal\"\n";
    let deck = "[parts.deck]\nrigid = \"sphere\"\nradius = 1\non = \"tile.platform\"\n";
    let bare = format!("{GROUND}{BALL}{tile}{}", pair("ball", "tile", "moreau"));
    unread_at(&bare, "`tile` is a mechanism, which has no surface", "12:20");
    unread_at(&bare, "give it one by a rigid part with on = \"tile.PORT\"", "12:20");
    let decked = format!("{GROUND}{BALL}{tile}{deck}{}", pair("tile", "ball", "stronge"));
    unread_at(&decked, "name what is on it: deck", "16:12");
    let mixed = format!(
        "{GROUND}{BALL}{CUBE}{}{}",
        pair("ball", "ground", "moreau"),
        pair("cube", "ground", "plastic")
    );
    unread_at(&mixed, "some contacts have impact = \"moreau\", others another law", "17:10");
    assert!(parse(&mixed.replace("plastic", "moreau")).is_ok());
}

/// Where functions of the time give all motion, an input would only change the work of the drive.
#[test]
fn inputs_that_move_nothing_are_refused_by_name() {
    let commanded = |coordinates: &[&str], lines: &str| {
        let commands: Vec<String> = coordinates.iter().map(|q| format!("{q} = \"0.1_rad*t/1_s\"")).collect();
        format!("{ARM}command = {{ {} }}\n{lines}", commands.join(", "))
    };
    let law = "law = { T = \"1_N*1_m\" }\n";
    let words = "`T` of `arm` moves nothing: functions of the time give all its motion";
    unread_at(&commanded(&["q1", "q2"], law), words, "5:9");
    let held = format!("[controllers.c]\n{HELD}");
    unread_at(&commanded(&["q1", "q2"], &held), words, "7:10");
    for input in [law, &held] {
        for free in [&["q1"][..], &[]] {
            let text = if free.is_empty() { format!("{ARM}{input}") } else { commanded(free, input) };
            assert!(parse(&text).is_ok(), "{text}");
        }
    }
}

#[test]
fn numbers_that_are_none_are_named_as_such() {
    let ball = |mass: &str| format!("{GROUND}{}", BALL.replace("mass = 1", &format!("mass = {mass}")));
    let cube = |mass: &str| format!("{GROUND}{CUBE}mass = {mass}\n");
    for mass in ["nan", "inf", "-inf"] {
        unread_at(&ball(mass), "`mass` must be a finite number", "7:8");
        unread_at(&cube(mass), "`mass` must be a finite number", "7:8");
        unread_at(&cube(&format!("[1, {mass}]")), "`mass` must be a finite number", "7:12");
    }
    unread_at(&ball("true"), "`mass` must be a number in kg", "7:8");
}
