//! Errors in a scene of format 2 are reported with their place.

use super::support::{fails, parse, scene, unread};
use smartbed::world::assembly::Kind;

const GROUND: &str = "format = 2\n[parts.ground]\nrigid = \"half_space\"\n";
const TILE: &str = "format = 2\n[parts.tile]\nmechanism = \"tile\"\n";
const SHEET: &str = "[parts.bladder]\nshape = \"sheet\"\nrows = 3\ncolumns = 3\nbase = \"40_mm\"\n";
const BALL: &str = "[parts.ball]\nrigid = \"sphere\"\nradius = 0.1\nmass = 1\n";

/// A text with its message and the line.
fn refused(text: &str, words: &str, line: usize) {
    unread(text, words, &format!("{line}:"));
}

#[test]
fn what_is_wrong_in_a_world_is_said_with_its_place() {
    let cases = [
        ("format = 3\n[parts.a]\nrigid = \"half_space\"".to_owned(), "`format` must be 2", 1),
        (format!("{GROUND}{BALL}friction = 1"), "`ball` has no field `friction`", 8),
        (
            format!("{GROUND}[parts.ball]\nrigid = \"sphere\"\nradius = \"0.1_kg\"\nmass = 1"),
            "`radius` must be in m",
            6,
        ),
        (format!("{GROUND}[parts.ball]\nrigid = \"ball\"\nradius = 1"), "unknown shape `ball`", 5),
        (format!("{GROUND}[parts.ball]\nrigid = \"sphere\"\nradius = 1"), "`ball` has no `mass`", 4),
        (
            format!("{GROUND}[parts.ball]\nrigid = \"sphere\"\nradius = -1\nmass = 1"),
            "`radius` must be a number > 0",
            6,
        ),
        (
            format!("{GROUND}[parts.ball]\nmass = 1"),
            "the kind of part `ball` is not given, or given twice",
            4,
        ),
        (format!("{GROUND}{BALL}"), "`ground` and `ball` overlap by 1.000e-1 m", 2),
        (format!("{GROUND}{BALL}start = {{ height = 0, speed = 1 }}"), "`start` has no field `speed`", 8),
        (
            format!("{GROUND}{BALL}start = {{ height = 1 }}\n[[contacts]]\nbetween = [\"ball\", \"ground\"]"),
            "a pair of parts without a law",
            9,
        ),
        (
            format!(
                "{GROUND}{BALL}start = {{ height = 1 }}\n[[contacts]]\nbetween = [\"ball\", \"ground\"]\nimpact = \"moreau\"\n\
                 [[contacts]]\nbetween = [\"ground\", \"ball\"]\nimpact = \"moreau\"\nfriction = 0.3"
            ),
            "`ground` and `ball` have a law of contact already",
            13,
        ),
        (
            format!("{TILE}command = {{ heave = \"1_mm\" }}\nstart = {{ u_hB = \"2 mm/s\" }}"),
            "`u_hB` starts as `hB` is commanded",
            5,
        ),
        (
            format!(
                "{TILE}{SHEET}attach = [{{ nodes = \"rim\", to = \"deck\" }}]\n[parts.deck]\nrigid = \"sphere\"\nradius = 1\non = \"tile.platform\""
            ),
            "`deck` is the shape of `tile.platform`: it has no frame of its own",
            9,
        ),
        (
            format!("{GROUND}{BALL}start = {{ height = 1, axis = [1, 0, 0] }}"),
            "`axis` without `angle` turns nothing",
            8,
        ),
        (
            format!("{GROUND}{BALL}start = {{ height = 1, spin = [0, 0, 1] }}\n[run]\nstart = \"settled\""),
            "`velocity` and `spin` have no effect with start = \"settled\"",
            4,
        ),
        (
            format!("{TILE}start = {{ u_hA = 0.1 }}\n[run]\nstart = \"settled\""),
            "speeds of a start have no effect with start = \"settled\"",
            2,
        ),
        (
            format!("{TILE}[parts.deck]\nrigid = \"half_space\"\non = \"tile.platform\"\nfixed = true"),
            "`fixed = true` has no effect beside `on`",
            7,
        ),
        (
            format!(
                "{GROUND}{SHEET}attach = [{{ nodes = \"rim\", to = \"ground\" }},\n{{ nodes = [0, 0], to = \"ground\" }}]"
            ),
            "node 0 of `bladder` is attached twice",
            10,
        ),
        (
            format!(
                "{GROUND}{BALL}start = {{ height = 1 }}\n[[contacts]]\nbetween = [\"bal\", \"ground\"]\nimpact = \"newton\""
            ),
            "there is no part `bal`",
            10,
        ),
        (
            format!(
                "{GROUND}{BALL}start = {{ height = 1 }}\n[[contacts]]\nbetween = [\"ball\", \"ground\"]\nimpact = \"newton\"\nfriction = 0.1"
            ),
            "can create energy",
            11,
        ),
        (
            format!(
                "{GROUND}{BALL}start = {{ height = 1 }}\n[[contacts]]\nbetween = [\"ball\", \"ball\"]\nimpact = \"newton\""
            ),
            "`between` names one part twice",
            10,
        ),
        (
            format!("{GROUND}{BALL}start = {{ height = 1 }}\n[run]\nstep = 0"),
            "`step` must be a number > 0",
            10,
        ),
        (
            "format = 2\n[parts.tile]\nmechanism = \"tyle\"".to_owned(),
            "`tile` has no model: no model `tyle`",
            3,
        ),
        (format!("{TILE}command = {{ hX = \"1_m\" }}"), "unknown coordinate `hX`", 4),
        (
            format!("{TILE}command = {{ hA = \"1_kg\" }}"),
            "what `tile` changes in its model is wrong: `hA` must be",
            4,
        ),
        (
            format!("{GROUND}{BALL}start = {{ height = 1, spin = [\"3 rev/s\", 0, 0] }}"),
            "`spin`: unknown unit `rev`",
            8,
        ),
        (format!("{TILE}{SHEET}attach = [{{ nodes = \"rim\", to = \"tile.top\" }}]"), "has no port `top`", 9),
        (
            format!(
                "{TILE}grid = {{ count = [2, 1], pitch = [\"0.4_m\", \"0.4_m\"] }}\n{SHEET}grid = {{ count = [1, 3], pitch = [\"0.4_m\", \"0.4_m\"] }}\nattach = [{{ nodes = \"rim\", to = \"tile.platform\" }}]"
            ),
            "`tile` is repeated with another `grid`; leave that of this part out, or name one of the copies, such as `tile[0,0]`",
            11,
        ),
        (
            format!("{TILE}{SHEET}attach = [{{ nodes = \"rim\", to = \"tile\" }}]"),
            "expected one of its ports",
            9,
        ),
        (
            format!("{TILE}{SHEET}attach = [{{ nodes = \"edge\", to = \"tile.platform\" }}]"),
            "unknown group of nodes `edge`",
            9,
        ),
        (
            format!("{TILE}{SHEET}attach = [{{ nodes = [99], to = \"tile.platform\" }}]"),
            "must be numbers of nodes",
            9,
        ),
        (format!("{TILE}{SHEET}corners = 3"), "part `bladder` has no key `corners`", 9),
        (
            "format = 2\n[parts.cart]\nmechanism = \"cart_pole\"\nstart = { u_q = 5 }".to_owned(),
            "`u_q` needs a unit: numbers of a scene are in SI units, those of its model in deg/s",
            4,
        ),
        (
            format!(
                "{TILE}[parts.bladder]\nshape = \"sheet\"\nrows = 3\ncolumns = 3\ngas = {{ gauge = \"4_kPa\" }}"
            ),
            "gas needs a closed surface",
            8,
        ),
        (format!("{TILE}{SHEET}gas = {{ gauge = \"4_kg\" }}"), "`gauge` must be", 9),
        (
            format!(
                "{TILE}{SHEET}gas = {{ gauge = \"4_kPa\", sealed = true, ambient = 0, vent = {{ conductance = 1e-8 }} }}"
            ),
            "`ambient` must be above 0 where there is a `vent`",
            9,
        ),
        (
            format!("{GROUND}[parts.ball]\nrigid = \"sphere\"\nradius = 1\nfixed = true\nmass = 1"),
            "`ball` has `mass`, but it is fixed in space",
            8,
        ),
        (
            format!(
                "{TILE}[parts.ball]\nrigid = \"sphere\"\nradius = 1\ninertia = [1, 1, 1]\non = \"tile.platform\""
            ),
            "`ball` has `inertia`, but it is only the surface of what carries it",
            7,
        ),
        (format!("{TILE}grid = {{ count = [0, 4], pitch = [1, 1] }}"), "is repeated 0 x 4 times", 4),
        (format!("{GROUND}[view]\nhide = [\"grund\"]"), "there is no part `grund`", 5),
        (format!("{GROUND}[view]\nsurfaces = \"strain\""), "unknown colouring of surfaces `strain`", 5),
        (format!("{GROUND}[view]\ncolours = {{ ground = \"red\" }}"), "unknown colour `red`", 5),
        (format!("{TILE}[view]\ncolours = {{ tile = \"sky\" }}"), "`tile` is a mechanism of many bodies", 5),
        (format!("{GROUND}[run]\nmethode = \"rk4\""), "`run` has no field `methode`", 5),
    ];
    for (text, words, line) in cases {
        refused(&text, words, line);
    }
}

/// Parts that overlap at the start are refused, a pair or not; only a pair can be moved apart.
#[test]
fn parts_and_pairs_of_one_name_are_refused() {
    let ball = |name: &str, x: f64| {
        format!(
            "[parts.{name}]\nrigid = \"sphere\"\nradius = 0.1\nmass = 1\nstart = {{ position = [{x}, 0, 1] }}\n"
        )
    };
    let pair = |one: &str, other: &str| {
        format!("[[contacts]]\nbetween = [\"{one}\", \"{other}\"]\nimpact = \"stronge\"\n")
    };
    let one_pair =
        format!("{GROUND}{}{}{}", ball("ball", 0.0), ball("ball-ground", 1.0), pair("ball", "ground"));
    let said = "part `ball-ground` and the pair of `ball` and `ground` have one name in rows and accounts, `ball-ground`";
    refused(&one_pair, said, 4);
    let names = ["a", "b-c", "a-b", "c"];
    let balls: String = names.iter().zip(0..).map(|(name, n)| ball(name, f64::from(n))).collect();
    let two_pairs = format!("format = 2\n{balls}{}{}", pair("a", "b-c"), pair("a-b", "c"));
    refused(&two_pairs, "the pair of `a` and `b-c` and the pair of `a-b` and `c` have one name", 12);
    let sheet = format!("{SHEET}attach = [{{ nodes = [0], to = \"ball\" }}]\n").replace("bladder", "s");
    let seam = format!("{GROUND}{}{}{sheet}", ball("ball", 0.0), ball("\"s@ball\"", 3.0));
    refused(&seam, "part `s@ball` and the attachment of `s` to `ball` have one name", 14);
    assert!(parse(&one_pair.replace("ball-ground", "other")).is_ok());
}

#[test]
fn overlapping_parts_are_told_of_settling_where_they_are_a_pair() {
    let other = BALL.replace("ball", "other");
    let pair = |of: &str| format!("[[contacts]]\nbetween = [\"ball\", \"{of}\"]\nimpact = \"moreau\"\n");
    let text = format!(
        "{GROUND}{BALL}start = {{ height = 0.1 }}\n{other}start = {{ height = 0.15 }}\n{}",
        pair("ground")
    );
    let said = |text: &str| parse(text).map(|_| ()).expect_err("refused");
    for (text, may_settle) in [(text.clone(), false), (text + &pair("other"), true)] {
        refused(&text, "`ball` and `other` overlap by 1.500e-1 m", 4);
        assert_eq!(said(&text).contains("start = \"settled\""), may_settle, "{}", said(&text));
    }
}

/// Squares of an axis neither overflow nor vanish.
#[test]
fn an_axis_of_any_length_has_its_direction() {
    let turned = |axis: &str| {
        let text = format!("{GROUND}{BALL}start = {{ height = 1, axis = {axis}, angle = 0.7 }}\n");
        let assembly = parse(&text).expect(axis);
        let (_, ball) = assembly.rigid().last().expect("the ball");
        ball.start.attitude.parameters()
    };
    for (axis, same) in [
        ("[0, 1, 1e200]", "[0, 0, 1]"),
        ("[1e200, 1e200, 0]", "[1, 1, 0]"),
        ("[0, 1e-300, 0]", "[0, 1, 0]"),
        ("[0, 0, -1e308]", "[0, 0, -2]"),
    ] {
        for (found, expected) in turned(axis).into_iter().zip(turned(same)) {
            assert!((found - expected).abs() < 1e-15, "{axis}: {found}, expected {expected}");
        }
    }
}

/// A ball above the ground, its height seen by a sensor.
fn seen(more: &str) -> String {
    format!(
        "{GROUND}{BALL}start = {{ height = 1 }}\n[sensors.high]\nof = \"ball.z\"\n{more}\n[run]\nseconds = 0.01\n"
    )
}

#[test]
fn sensors_and_controllers_name_a_unit_of_what_they_read() {
    for unit in ["m", "mm", "km"] {
        super::support::run(&[
            "run",
            &scene("unit", &seen(&format!("unit = \"{unit}\"\nresolution = \"1_mm\""))),
        ]);
    }
    let said = |more: &str| fails(&["run", &scene("unit", &seen(more))]);
    let found = said("unit = \"N\"\nresolution = \"1_mN\"");
    assert!(found.contains("sensors.high: `unit` is that of a number in N, but `ball.z` is in m"), "{found}");
    assert!(found.contains("expected unit = \"m\""), "{found}");
    let found = said("unit = \"meter\"");
    assert!(found.contains("did you mean `m`?") && found.contains(":11:"), "{found}");
    let controlled = |unit: &str| {
        let held =
            include_str!("../../../docs/scenes.md").split("toml file=held.toml\n").nth(1).expect("a scene");
        let held = held.split("```").next().expect("its text");
        held.replacen(
            "drives = \"bladder.valves\"\nunit = \"Pa\"",
            &format!("drives = \"bladder.valves\"\nunit = \"{unit}\""),
            1,
        )
    };
    let found = fails(&["run", &scene("held_unit", &controlled("m").replace("_kPa\"]", "_m\"]"))]);
    assert!(found.contains("controllers.air: `unit` is that of a number in m"), "{found}");
    assert!(found.contains("`sensors.pressure` is in Pa"), "{found}");
    super::support::run(&["run", &scene("held_unit", &controlled("kPa")), "--seconds", "0.01"]);
}

#[test]
fn a_run_that_is_refused_leaves_the_rows_of_an_earlier_one() {
    let rows = std::path::Path::new(env!("CARGO_TARGET_TMPDIR")).join("earlier.csv");
    let file = rows.display().to_string();
    let kept = |text: &str, options: &[&str]| {
        std::fs::write(&rows, "earlier\n").expect("a file");
        let said = fails(&[&["run", &scene("refused", text), "--csv", &file][..], options].concat());
        assert_eq!(std::fs::read_to_string(&rows).expect("a file"), "earlier\n", "{said}");
        said
    };
    let said = kept(&seen("period = \"1.5_ms\""), &[]);
    assert!(said.contains("is no whole number of steps"), "{said}");
    let said = kept(&(seen("") + "start = \"settled\"\n"), &[]);
    assert!(said.contains("settle"), "{said}");
    super::support::run(&["run", &scene("fine", &seen("")), "--csv", &file]);
    assert!(std::fs::read_to_string(&rows).expect("a file").starts_with("t,ball.x"));
}

#[test]
fn laws_that_locate_touches_and_moreau_are_not_mixed() {
    let contact = |impact: &str, part: &str| {
        format!("[[contacts]]\nbetween = [\"{part}\", \"ground\"]\nimpact = \"{impact}\"\n")
    };
    let cube = "[parts.cube]\nshape = \"cube\"\nstart = { height = 1 }\n";
    let text = format!(
        "{GROUND}{BALL}start = {{ height = 1 }}\n{cube}{}{}",
        contact("moreau", "ball"),
        contact("plastic", "cube")
    );
    let said = fails(&["run", &scene("mixed", &text)]);
    assert!(said.contains("take moreau for all or for none"), "{said}");
}

#[test]
fn units_expressions_and_plain_numbers_say_the_same() {
    let ball = |radius: &str, mass: &str| {
        let text = format!(
            "{GROUND}[parts.ball]\nrigid = \"sphere\"\nradius = {radius}\nmass = {mass}\nstart = {{ height = \"20_mm\" }}"
        );
        let assembly = parse(&text).unwrap_or_else(|found| panic!("{found}"));
        let (_, rigid) = assembly.rigid().nth(1).expect("a ball");
        (rigid.body.expect("a body"), rigid.start.position)
    };
    let plain = ball("0.1", "2");
    assert_eq!(plain, ball("\"100_mm\"", "\"2000_g\""));
    assert_eq!(plain, ball("\"0.05_m*2\"", "\"2 kg\""));
    assert!((plain.1[2] - 0.12).abs() < 1e-15 && (plain.0.inertia[0] - 0.4 * 2.0 * 0.01).abs() < 1e-15);
}

#[test]
fn a_grid_repeats_a_part_and_what_is_attached_to_it() {
    let grid = "grid = { count = [2, 3], pitch = [\"0.4_m\", \"0.5_m\"] }\n";
    let text = format!("{TILE}{grid}{SHEET}{grid}attach = [{{ nodes = \"rim\", to = \"tile.platform\" }}]\n");
    let assembly = parse(&text).unwrap_or_else(|found| panic!("{found}"));
    let names: Vec<&str> = assembly.parts.iter().map(|part| part.name.as_str()).collect();
    assert_eq!(names.len(), 12);
    assert_eq!((names[0], names[5], names[11]), ("tile[0,0]", "tile[1,2]", "bladder[1,2]"));
    let pairs: Vec<(usize, usize)> = assembly.attachments.iter().map(|a| (a.part, a.to)).collect();
    assert_eq!(pairs, [(6, 0), (7, 1), (8, 2), (9, 3), (10, 4), (11, 5)]);
}

#[test]
fn options_that_worlds_do_not_have_are_refused() {
    let said = fails(&["run", "box_bounce", "--tolerance", "1e-6"]);
    assert!(said.contains("a scene of format 2 is interpreted and takes fixed steps"), "{said}");
    let said = fails(&["run", "box_bounce", "--method", "rk4"]);
    assert!(said.contains("rigid bodies have a step of their own"), "{said}");
    let said = fails(&["run", "box_bounce", "--set", "parts.box.mass=2_m"]);
    assert!(said.contains("`mass` must be in kg") && said.contains("--set"), "{said}");
}

#[test]
fn a_model_is_looked_for_beside_its_scene_first() {
    let folder = std::path::Path::new(env!("CARGO_TARGET_TMPDIR")).join("beside");
    std::fs::create_dir_all(&folder).expect("a folder");
    let model = std::fs::read_to_string(concat!(env!("CARGO_MANIFEST_DIR"), "/../models/pendulum.toml"));
    let model = model.expect("a model").replace("value = 300", "value = 450");
    std::fs::write(folder.join("pendulum.toml"), model).expect("a file");
    let text = "format = 2\n[parts.arm]\nmechanism = \"pendulum\"\nstart = { q = \"30_deg\" }\n[run]\nseconds = 0.1\n";
    let run = |name: &str, folder: &std::path::Path| {
        let file = folder.join(name);
        std::fs::write(&file, text).expect("a file");
        super::support::number(&super::support::json(&[&file.display().to_string()])["last"]["total"])
    };
    // Energy goes with the length of the rod, but for what friction takes; a scene of the model's own name does not
    // take itself for the model.
    let elsewhere = folder.join("elsewhere");
    std::fs::create_dir_all(&elsewhere).expect("a folder");
    let ratio = run("scene.toml", &folder) / run("pendulum.toml", &elsewhere);
    assert!((ratio - 1.5).abs() < 1e-2, "{ratio}");
}

#[test]
fn what_is_attached_to_a_repeated_part_is_repeated_with_it() {
    let grid = "grid = { count = [2, 1], pitch = [\"0.4_m\", \"0.4_m\"] }\n";
    let with = |own: &str| {
        let text = format!(
            "{TILE}{grid}{SHEET}{own}attach = [{{ nodes = \"rim\", to = \"tile.platform\" }}]\n[parts.board]\n\
             rigid = \"box\"\nsize = [0.1, 0.1, 0.01]\n{own}on = \"tile.platform\"\n\
             start = {{ position = [0, 0, \"20_mm\"] }}\n"
        );
        parse(&text).expect("a scene")
    };
    let assembly = with("");
    let names: Vec<&str> = assembly.parts.iter().map(|part| part.name.as_str()).collect();
    let expected = ["tile[0,0]", "tile[1,0]", "bladder[0,0]", "bladder[1,0]", "board[0,0]", "board[1,0]"];
    assert_eq!(names, expected);
    let carried: Vec<(usize, [f64; 3])> = (assembly.parts.iter())
        .filter_map(|part| match &part.kind {
            Kind::Rigid(board) => Some((board.on.as_ref()?.0, board.start.position)),
            _ => None,
        })
        .collect();
    // Each lies on its own tile, in the middle of it.
    assert_eq!(carried, [(0, [0.0, 0.0, 0.02]), (1, [0.0, 0.0, 0.02])]);
    assert_eq!(format!("{assembly:?}"), format!("{:?}", with(grid)), "as with a grid of its own");
}
