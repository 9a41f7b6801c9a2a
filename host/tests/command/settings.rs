//! Settings of scenes are never ignored: each is read, or refused with its place and what was expected.

use crate::support::{smartbed, written};
use smartbed::scene::parse;

fn read(text: &str, settings: &[&str]) -> Result<smartbed::scene::Scene, String> {
    let settings: Vec<String> = settings.iter().map(|s| (*s).to_owned()).collect();
    parse("s.toml", &format!("format = 1\n{text}"), &settings)
}

/// Each text is wrong in its last line.
#[test]
fn texts_with_what_nothing_reads() {
    let cube = "shape = \"cube\"\n";
    let lists = "points = [[0, 0, 0], [0, 0, 1]]\nsprings = [[0, 1]]\n";
    let cases = [
        (cube, "corners = 5", "nothing reads it with shape = \"cube\""),
        (cube, "e = 0.5", "nothing reads it with law = \"compensation\""),
        (cube, "stiffness = 3e5", "it belongs to law = \"penalty\", law = \"hunt_crossley\""),
        (cube, "tolerance = 1e-6", "it belongs to method = \"dormand_prince\" or \"dop853\""),
        (cube, "gas = \"polytropic\"", "it belongs to a `pressure`"),
        (cube, "floor = { normal = [1, 0, 1], offset = 0 }", "length 1, found [1,0,1] of length 1.4142"),
        (cube, "floor = { normal = [0, 0], offset = 0 }", "`normal` is [0,0]"),
        (cube, "floor = { offset = \"low\" }", "`offset` is \"low\""),
        (cube, "floor = { norml = [0, 0, 1] }", "unknown key `norml`; did you mean `normal`?"),
        (cube, "floor = 3", "expected a table of normal and offset, found 3"),
        (cube, "stretch = \"abc\"", "expected a number, found \"abc\""),
        (cube, "stretch = 0", "expected a number > 0"),
        (cube, "K = inf", "expected a number, found \"inf\""),
        (cube, "mass = 0", "point 0 has mass 0"),
        (cube, "masses = [1, 1, 1, 1, 1, 1, 1, 0.0]", "point 7 has mass 0"),
        (cube, "fixed = [-1]", "entry 0 is -1"),
        (cube, "fixed = [1, 1]", "names point 1 twice"),
        (cube, "fixed = [0.5]", "entry 0 is 0.5"),
        (cube, "side = 1e308", "beyond 1e308"),
        (cube, "step = 1e-12", "are more than 1e9 steps"),
        (cube, "step = -1", "expected a number > 0"),
        (cube, "stifness = 3.0", "unknown key"),
        ("shape = \"cubes\"\n", "cells = [[1.5, 1, 1]]", "entry 0 is [1.5,1,1]"),
        ("shape = \"cubes\"\n", "cells = [[1, 1, 1], [2, 2, 2]]", "expected one row"),
        ("shape = \"cubes\"\n", "pressure = 3", "nothing reads it with shape = \"cubes\""),
        ("shape = \"bar\"\n", "K = 3", "nothing reads it with shape = \"bar\""),
        (
            "law = \"moreau\"\nshape = \"cube\"\n",
            "method = \"verlet\"",
            "nothing reads it with law = \"moreau\"",
        ),
        ("law = \"massless_point\"\nshape = \"cube\"\n", "massless = []", "expected at least one point"),
        (lists, "drop_height = 1", "nothing reads it with `points` in place of a shape"),
        (lists, "side = 1", "nothing reads it with `points`"),
        (lists, "pressure = 1", "has no `facets`"),
        (lists, "facets = [[0, 1, 2, 2]]", "facet 0 is [0, 1, 2, 2], but the points are 0 to 1"),
        (lists, "facets = [[0, 1, -1, 1]]", "entry 0 is [0,1,-1,1]"),
        ("points = [[0, 0, 0], [0, 0, 1]]\n", "springs = [[0, 1.5]]", "entry 0 is [0,1.5]"),
        ("points = [[0, 0, 0], [0, 0, 1]]\n", "springs = [[1, 1]]", "joins 1 and 1"),
        ("shape = \"cube\"\nT = 1\n", "seconds = 2", "means the same as `T`"),
    ];
    for (head, line, message) in cases {
        let found = read(&format!("{head}{line}\n"), &[]).expect_err(line);
        let place = format!("s.toml:{}: `", head.lines().count() + 2);
        assert!(found.contains(message), "{line}: {found}");
        // What an overflow or a step's length comes from may stand elsewhere.
        let elsewhere = line == "side = 1e308";
        assert!(found.starts_with(&place) || elsewhere, "{line}: {found}");
    }
}

#[test]
fn settings_with_what_nothing_reads() {
    let cube = "shape = \"cube\"\n";
    let cases: [(&str, &[&str], &str); 13] = [
        (cube, &["corners=5"], "--set corners=5: nothing reads it with shape = \"cube\""),
        (cube, &["e=0.5"], "--set e=0.5: nothing reads it with law = \"compensation\""),
        (
            cube,
            &["floor={normal=[1,0,1],offset=0}"],
            "--set floor={normal=[1,0,1],offset=0}: expected a `normal`",
        ),
        (cube, &["floor={\"normal\":[0,0,1],\"offest\":1}"], "unknown key `offest`; did you mean `offset`?"),
        (cube, &["stretch=abc"], "--set stretch=abc: expected a number"),
        (cube, &["mu=null"], "--set mu=null: expected a number"),
        (cube, &["mu="], "--set mu=: expected a number"),
        (cube, &["C"], "--set C: expected NAME=VALUE"),
        (cube, &["format=1"], "--set format=1: the text has its format"),
        (cube, &["--tolerance=1e-3"], "--tolerance 1e-3: nothing reads it with a method of fixed step"),
        (cube, &["--method=verlet", "law=moreau"], "--method verlet: nothing reads it with law = \"moreau\""),
        (cube, &["law=newtn"], "--set law=newtn: unknown law `newtn`; did you mean `newton`?"),
        (cube, &["shape=ball", "bands=1e9"], "--set bands=1e9: expected a whole number"),
    ];
    for (text, settings, message) in cases {
        let found = read(text, settings).expect_err(message);
        assert!(found.contains(message), "{settings:?}: {found}");
    }
    let huge = read(cube, &["shape=ball", "bands=1000000000"]).expect_err("too many");
    assert!(huge.contains("a body has 100000 at most"), "{huge}");
}

/// A setting replaces a choice of the text, and the keys that belonged only to the replaced choice are dropped.
#[test]
fn a_setting_replaces_the_choice_and_what_belonged_to_it() {
    let text = "shape = \"chain\"\nlaw = \"newton\"\ne = 0.5\nmethod = \"verlet\"\nseconds = 2\n";
    let scene = read(text, &["law=moreau", "--seconds=0.5"]).expect("e is read by both, verlet falls away");
    assert_eq!(scene.seconds, 0.5);
    let scene = read(text, &["law=penalty", "stiffness=3e4"]).expect("e falls away with its law");
    assert!(format!("{:?}", scene.around.ground).contains("Penalty { stiffness: 30000.0 }"));
    // A normal with few digits is meant as a unit vector; the plane stays where it was.
    let scene =
        read(text, &["floor={ normal = [0.6, 0, 0.80001], offset = 0.25 }"]).expect("TOML as in a file");
    let ground = scene.around.ground.expect("a floor");
    assert_eq!(ground.offset, 0.25);
    assert!((ground.normal.iter().map(|c| c * c).sum::<f64>() - 1.0).abs() < 1e-15);
}

#[test]
fn json_scenes_are_held_to_the_same() {
    let scene = |more: &str| {
        let text =
            format!("{{\"points\": [[0, 0, 1]], \"drop_height\": 1, \"events\": [], \"masses\": [1]{more}}}");
        parse("s.json", &text, &[])
    };
    let read = scene("").expect("what a reference file says beside the scene is let be");
    assert_eq!(read.lists.points, [[0.0, 0.0, 1.0]], "the drop height of a reference is in its points");
    for (more, message) in [
        (", \"mas\": 3", "`mas`: unknown key"),
        (", \"mu\": null", "`mu`: expected a number, found null"),
        (", \"g\": 1, \"g\": 2", "`g` is given twice"),
        (", \"mass\": 2", "means the same"),
        (", \"e\": 0.5", "nothing reads it with law"),
    ] {
        let found = scene(more).expect_err(more);
        assert!(found.contains(message) && found.starts_with("s.json"), "{more}: {found}");
    }
}

#[test]
fn the_command_line_refuses_them_too() {
    let path = written("settings.toml", "format = 1\nshape = \"cube\"\ncorners = 5\n");
    let done = smartbed(&["run", &path, "--seconds", "0.01"]);
    assert!(done.message().contains("settings.toml:3: `corners`: nothing reads it"), "{done:?}");
    let done = smartbed(&["run", "cube", "--seconds", "0.01", "--set", "law=moreau", "--method", "rk4"]);
    assert!(done.message().starts_with("error: --method rk4: nothing reads it"), "{done:?}");
    let done = smartbed(&["run", "cube", "--seconds", "0.01", "--set", "T=1"]);
    assert!(done.message().starts_with("error: --set T=1: `T` is set twice"), "{done:?}");
    // A mechanism's methods of fixed step know no tolerance either.
    let done = smartbed(&["run", "pendulum", "--method", "rk4", "--tolerance", "1e-9"]);
    assert!(done.message().starts_with("error: --tolerance 1e-9: rk4 takes fixed steps"), "{done:?}");
    let done = smartbed(&["run", "pendulum", "--set", "m=1", "--set", "m=2"]);
    assert!(done.message().starts_with("error: --set m=2: `m` is set twice"), "{done:?}");
}
