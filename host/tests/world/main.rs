//! Scenes of format 2: what is wrong in them is said with its place; worlds of rigid bodies against closed forms.

use smartbed::world::{Assembly, read};
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

const G: f64 = 9.81;

/// The program at the root of the workspace.
fn smartbed(arguments: &[&str]) -> Output {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    Command::new(env!("CARGO_BIN_EXE_smartbed")).args(arguments).current_dir(root).output().expect("it runs")
}

/// Standard output of a run that succeeds.
fn run(arguments: &[&str]) -> String {
    let output = smartbed(arguments);
    assert!(output.status.success(), "{arguments:?}: {}", String::from_utf8_lossy(&output.stderr));
    String::from_utf8(output.stdout).expect("text")
}

/// What a run says that is refused.
fn fails(arguments: &[&str]) -> String {
    let output = smartbed(arguments);
    assert_eq!(output.status.code(), Some(1), "{arguments:?}");
    String::from_utf8(output.stderr).expect("text")
}

fn find(name: &str) -> Result<PathBuf, String> {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../models").join(format!("{name}.toml"));
    if path.is_file() { Ok(path) } else { Err(format!("no model `{name}`")) }
}

fn parse(text: &str) -> Result<Assembly, String> {
    read::parse("w.toml", text, &[], &find).map_err(|found| found.to_string())
}

const GROUND: &str = "format = 2\n[parts.ground]\nrigid = \"half_space\"\n";
const TILE: &str = "format = 2\n[parts.tile]\nmechanism = \"tile\"\n";
const SHEET: &str = "[parts.bladder]\nshape = \"sheet\"\nrows = 3\ncolumns = 3\nbase = \"40_mm\"\n";
const BALL: &str = "[parts.ball]\nrigid = \"sphere\"\nradius = 0.1\nmass = 1\n";

/// A text with what is said of it, and the line.
fn refused(text: &str, words: &str, line: usize) {
    let found = parse(text).map(|_| ()).expect_err(text);
    assert!(found.contains(words), "{words}\n{found}");
    assert!(found.contains(&format!("w.toml:{line}:")), "line {line}\n{found}");
    assert!(found.contains("help: "), "what to do\n{found}");
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
        (format!("{GROUND}[parts.ball]\nmass = 1"), "what is the part `ball`?", 4),
        (format!("{GROUND}{BALL}"), "`ground` and `ball` overlap by 1.000e-1 m", 2),
        (format!("{GROUND}{BALL}start = {{ height = 0, speed = 1 }}"), "`start` has no field `speed`", 8),
        (
            format!("{GROUND}{BALL}start = {{ height = 1 }}\n[[contacts]]\nbetween = [\"ball\", \"ground\"]"),
            "a pair of parts without a law",
            9,
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
            "a contact is between two parts",
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
        (format!("{TILE}command = {{ hA = \"1_kg\" }}"), "what `tile` changes in its model is wrong", 2),
        (format!("{TILE}{SHEET}attach = [{{ nodes = \"rim\", to = \"tile.top\" }}]"), "has no port `top`", 9),
        (format!("{TILE}{SHEET}attach = [{{ nodes = \"rim\", to = \"tile\" }}]"), "which of its ports?", 9),
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
        (format!("{TILE}{SHEET}corners = 3"), "nothing of `bladder` reads `corners`", 9),
        (
            format!(
                "{TILE}[parts.bladder]\nshape = \"sheet\"\nrows = 3\ncolumns = 3\ngas = {{ gauge = \"4_kPa\" }}"
            ),
            "gas needs a closed surface",
            8,
        ),
        (format!("{TILE}{SHEET}gas = {{ gauge = \"4_kg\" }}"), "`gauge` must be", 9),
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

#[test]
fn laws_that_locate_touches_and_moreau_are_not_mixed() {
    let file = Path::new(env!("CARGO_TARGET_TMPDIR")).join("mixed.toml");
    let contact = |impact: &str, part: &str| {
        format!("[[contacts]]\nbetween = [\"{part}\", \"ground\"]\nimpact = \"{impact}\"\n")
    };
    let cube = "[parts.cube]\nshape = \"cube\"\nstart = { height = 1 }\n";
    let text = format!(
        "{GROUND}{BALL}start = {{ height = 1 }}\n{cube}{}{}",
        contact("moreau", "ball"),
        contact("plastic", "cube")
    );
    std::fs::write(&file, text).expect("a file");
    let said = fails(&["run", file.to_str().expect("a path")]);
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

/// What `run --json` says of a scene.
fn json(arguments: &[&str]) -> serde_json::Value {
    let output = run(&[&["run"], arguments, &["--json"]].concat());
    serde_json::from_str(&output).expect("JSON")
}

fn number(value: &serde_json::Value) -> f64 {
    value.as_f64().expect("a number")
}

fn times(json: &serde_json::Value) -> Vec<f64> {
    json["events"].as_array().expect("events").iter().map(|event| number(&event["time"])).collect()
}

#[test]
fn a_box_bounces_when_free_fall_says_and_does_not_spin() {
    let done = json(&["box_bounce"]);
    let (e, height) = (0.6_f64, 0.5_f64);
    let mut expected = (2.0 * height / G).sqrt();
    let mut flight = 2.0 * e * expected;
    for time in times(&done).iter().take(8) {
        assert!((time - expected).abs() < 1e-9, "{time} against {expected}");
        (expected, flight) = (expected + flight, e * flight);
    }
    for spin in ["box.wx", "box.wy", "box.wz"] {
        assert!(number(&done["last"][spin]).abs() < 1e-9, "{spin}");
    }
    // Energy to rest: the height of a box that lies.
    assert!((number(&done["last"]["box.z"]) - 0.05).abs() < 1e-9, "{}", done["last"]);
    assert!(number(&done["imbalance"]).abs() < 1e-9 * number(&done["total_at_start"]), "{done}");
}

#[test]
fn a_rod_slides_as_far_as_friction_says() {
    let (v, mu) = (1.5, 0.25);
    let done = json(&["rod_with_friction"]);
    let (distance, last) = (v * v / (2.0 * mu * G), &done["last"]);
    assert!((number(&last["rod.x"]) - distance).abs() < 1e-9, "{} against {distance}", last["rod.x"]);
    assert!(number(&last["rod.vx"]).abs() < 1e-9);
    assert!((number(&last["friction"]) - 0.5 * 0.5 * v * v).abs() < 1e-9, "{}", last["friction"]);
}

#[test]
fn boxes_stack_and_stay() {
    let done = json(&["stack_boxes"]);
    for (name, height) in [("lower", 0.05), ("middle", 0.15), ("upper", 0.25)] {
        let last = |what: &str| number(&done["last"][format!("{name}.{what}")]);
        assert!((last("z") - height).abs() < 1e-6, "{name}: {}", last("z"));
        assert!(last("vz").abs() < 1e-9 && last("wx").abs() < 1e-9 && last("wy").abs() < 1e-9, "{name}");
    }
    assert!(number(&done["imbalance"]).abs() < 1e-9, "{done}");
}

#[test]
fn a_ball_comes_to_rest_where_its_bounces_add_up() {
    let (e, height) = (0.5_f64, 0.4_f64);
    let done = json(&["rigid_ball_rests"]);
    // The series of all flights: t1 (1 + e)/(1 - e).
    let rest = (2.0 * height / G).sqrt() * (1.0 + e) / (1.0 - e);
    let times = times(&done);
    let last = times.last().copied().expect("bounces");
    assert!(times.len() > 10 && (last - rest).abs() < 2e-3 && last <= rest + 1e-9, "{last} against {rest}");
    assert!((number(&done["last"]["ball.z"]) - 0.1).abs() < 1e-9);
}

#[test]
fn a_thrown_ball_rolls_at_five_sevenths_of_its_speed() {
    let (v, mu) = (1.4, 0.2);
    let done = json(&[
        "rigid_ball_rests",
        "--set",
        "parts.ball.start={ height = 0, velocity = [\"1.4 m/s\", 0, 0] }",
        "--set",
        "contacts=[{ between = [\"ball\", \"ground\"], impact = \"plastic\", friction = 0.2 }]",
    ]);
    let last = &done["last"];
    let (slides, speed) = (2.0 * v / (7.0 * mu * G), 5.0 / 7.0 * v);
    let way = v * slides - 0.5 * mu * G * slides * slides + speed * (1.0 - slides);
    assert!((number(&last["ball.vx"]) - speed).abs() < 1e-8, "{}", last["ball.vx"]);
    assert!((number(&last["ball.wy"]) - speed / 0.1).abs() < 1e-7, "{}", last["ball.wy"]);
    assert!((number(&last["ball.x"]) - way).abs() < 1e-7, "{} against {way}", last["ball.x"]);
}

#[test]
fn a_world_has_rows_plots_and_a_page() {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR"));
    let file = |name: &str| folder.join(format!("world_{name}")).display().to_string();
    let (csv, svg, page) = (file("b.csv"), file("b.svg"), file("b.html"));
    let said =
        run(&["run", "box_bounce", "--csv", &csv, "--plot", &svg, "--view", &page, "--seconds", "0.5"]);
    assert!(said.contains("box strikes ground at 4 points"), "{said}");
    let rows = std::fs::read_to_string(&csv).expect("rows");
    assert!(
        rows.starts_with("t,box.x,box.y,box.z,box.e0,") && rows.lines().count() == 102,
        "{}",
        rows.lines().count()
    );
    assert!(std::fs::read_to_string(&svg).expect("a plot").contains("A box bounces"));
    let page = std::fs::read_to_string(&page).expect("a page");
    assert!(page.contains("\"kind\":\"box\"") && page.contains("\"ground\":{"), "stage");
}

#[test]
fn options_that_worlds_do_not_have_are_refused() {
    for (option, value) in
        [("--error", "1e-3"), ("--budget", "1ms"), ("--scalar", "f32"), ("--tolerance", "1e-6")]
    {
        let said = fails(&["run", "box_bounce", option, value]);
        assert!(said.contains("a scene of format 2 does not take it"), "{said}");
    }
    let said = fails(&["run", "box_bounce", "--method", "rk4"]);
    assert!(said.contains("rigid bodies have a step of their own"), "{said}");
    let said = fails(&["run", "box_bounce", "--set", "parts.box.mass=2_m"]);
    assert!(said.contains("`mass` must be in kg") && said.contains("--set"), "{said}");
}

#[test]
fn a_mass_on_spring_and_damper_swings_as_its_closed_form() {
    let done = json(&["damper_mass_fixed_end"]);
    let (m, k, c, t) = (0.5_f64, 50.0_f64, 0.8_f64, 3.0_f64);
    // Stretch beyond the equilibrium m g/k, from 0.1 m; x'' = -(k/m) x - (c/m) x'.
    let (rest, decay) = (m * G / k, c / (2.0 * m));
    let w = (k / m - decay * decay).sqrt();
    let amplitude = 0.1 - rest;
    let stretch = rest + amplitude * (-decay * t).exp() * ((w * t).cos() + decay / w * (w * t).sin());
    let z = number(&done["last"]["mass.z1"]);
    assert!((z - (0.1 - stretch)).abs() < 1e-9, "{z} against {}", 0.1 - stretch);
    assert!(number(&done["imbalance"]).abs() < 1e-9, "{}", done["imbalance"]);
}

#[test]
fn a_loop_hung_up_comes_to_rest_below_its_point() {
    let done = json(&["closed_loop_hung"]);
    let last = |name: &str| number(&done["last"][format!("loop.{name}")]);
    assert!(number(&done["last"]["kinetic"]) < 1e-9, "{}", done["last"]["kinetic"]);
    // At rest the weights' moment about A vanishes, and the two springs at A carry both weights.
    assert!((last("x1") + last("x2")).abs() < 1e-4, "{} {}", last("x1"), last("x2"));
    let lift = |node: usize| {
        let [x, z] = [last(&format!("x{node}")), last(&format!("z{node}"))];
        let length = x.hypot(z);
        5000.0 * (length - 1.0) * -z / length
    };
    assert!((lift(1) + lift(2) - 2.0 * G).abs() < 1e-3, "{}", lift(1) + lift(2));
}

#[test]
fn a_bladder_does_not_feel_that_its_tile_moves_on_at_one_speed() {
    let run = |law: &str| {
        let command = format!("parts.tile.command={{ hA = \"{law}\", hB = \"{law}\", hC = \"{law}\" }}");
        json(&["tile_with_bladder", "--set", &command, "--seconds", "0.1"])
    };
    let (still, moved) = (run("0_m*t/1_s"), run("0.1_m*t/1_s"));
    for node in [0, 24, 48] {
        for (axis, way) in [("x", 0.0), ("y", 0.0), ("z", 0.01)] {
            let name = format!("bladder.{axis}{node}");
            let (a, b) = (number(&still["last"][&name]), number(&moved["last"][&name]));
            assert!((b - a - way).abs() < 1e-10, "{name}: {a} {b}");
        }
    }
    // It has swollen, or nothing was tried.
    assert!(number(&still["last"]["bladder.z24"]) > 0.0505, "{}", still["last"]["bladder.z24"]);
}

#[test]
fn the_accounts_of_a_carried_bladder_close_to_the_order_of_the_method() {
    for scene in ["tile_with_bladder", "tile_bladder_coupled"] {
        let imbalance =
            |step: &str| number(&json(&[scene, "--step", step, "--seconds", "0.2"])["imbalance"]).abs();
        let (coarse, fine) = (imbalance("4e-4"), imbalance("2e-4"));
        assert!(coarse < 5e-5 && fine < coarse / 8.0, "{scene}: {coarse:e} {fine:e}");
    }
}

#[test]
fn a_page_shows_mechanism_and_body_together() {
    let page = Path::new(env!("CARGO_TARGET_TMPDIR")).join("world_tile.html").display().to_string();
    run(&["run", "tile_with_bladder", "--view", &page, "--seconds", "0.01"]);
    let page = std::fs::read_to_string(&page).expect("a page");
    for word in ["\"tile.connectorA\"", "\"tile.G\"", "\"bladder.48\"", "\"facets\":[["] {
        assert!(page.contains(word), "{word}");
    }
}

#[test]
fn a_settled_loop_hangs_where_its_run_comes_to_rest() {
    let rest = serde_json::from_str::<serde_json::Value>(&run(&["settle", "closed_loop_hung", "--json"]))
        .expect("JSON");
    assert!(number(&rest["acceleration"]) < 1e-8, "{}", rest["acceleration"]);
    let last = |name: &str| number(&rest["last"][format!("loop.{name}")]);
    let lift = |node: usize| {
        let [x, z] = [last(&format!("x{node}")), last(&format!("z{node}"))];
        let length = x.hypot(z);
        5000.0 * (length - 1.0) * -z / length
    };
    assert!((lift(1) + lift(2) - 2.0 * G).abs() < 1e-7, "{}", lift(1) + lift(2));
    assert!((last("x1") + last("x2")).abs() < 1e-9);
    // A run that begins there stays there.
    let stays = json(&["closed_loop_hung", "--set", "run.start=settled", "--seconds", "2"]);
    for name in ["x1", "z1", "x2", "z2"] {
        let moved = number(&stays["last"][format!("loop.{name}")]) - last(name);
        assert!(moved.abs() < 1e-9, "{name}: {moved:e}");
    }
}

#[test]
fn gas_and_membrane_carry_the_weight_of_a_settled_bladder() {
    let settled = run(&["settle", "tile_with_bladder", "--json"]);
    let rest: serde_json::Value = serde_json::from_str(&settled).expect("JSON");
    let last = |name: &str| number(&rest["last"][format!("bladder.{name}")]);
    // Sealed air: p V^n as filled in.
    let (gauge, volume) = (last("gauge"), last("volume"));
    let filled = (101_325.0 + 1000.0) * (volume_at_rest()).powf(1.4);
    assert!(((101_325.0 + gauge) * volume.powf(1.4) / filled - 1.0).abs() < 1e-12, "{gauge} {volume}");
    assert!(number(&rest["acceleration"]) < 1e-8 && last("top") > 0.05, "{settled}");
}

/// Volume of the flat cell of tile_with_bladder: a square of 0.28 m without the outer halves of its four corner cells.
fn volume_at_rest() -> f64 {
    let cell = 0.28 / 8.0_f64;
    0.04 * (0.28 * 0.28 - 4.0 * 0.5 * cell * cell)
}

#[test]
fn a_run_that_is_resumed_goes_on_bit_for_bit() {
    for scene in ["box_bounce", "tile_bladder_coupled"] {
        let file =
            Path::new(env!("CARGO_TARGET_TMPDIR")).join(format!("{scene}.state")).display().to_string();
        let whole = json(&[scene, "--seconds", "0.4"]);
        json(&[scene, "--seconds", "0.3", "--save", &file]);
        let resumed = json(&[scene, "--seconds", "0.4", "--resume", &file]);
        assert_eq!(whole["last"], resumed["last"], "{scene}");
        let said = fails(&["run", "closed_loop_hung", "--resume", &file]);
        assert!(said.contains("of another world"), "{said}");
    }
}

/// Numbers of a scene's rows, by column.
fn rows(arguments: &[&str]) -> (Vec<String>, Vec<Vec<f64>>) {
    let text = run(&[&["run"], arguments, &["--csv", "-"]].concat());
    let mut lines = text.lines();
    let names = lines.next().expect("a header").split(',').map(str::to_owned).collect();
    let row = |line: &str| line.split(',').map(|x| x.parse().expect("a number")).collect();
    (names, lines.map(row).collect())
}

/// A cube that falls on its edge, written in either format.
const CUBE: [&str; 2] = [
    "format = 1\ntitle = \"cube\"\nshape = \"cube\"\nside = 0.4\ndrop_height = 0.1\ntilt = 0.2\nK = 2000\nC = 0.5\nmass = 0.25\n\
     T = 0.5\nstep = 5e-4\nmethod = \"rk4\"\nevery = 100\n",
    "format = 2\n[parts.ground]\nrigid = \"half_space\"\n[parts.cube]\nshape = \"cube\"\nside = 0.4\nmass = 0.25\nK = 2000\nC = 0.5\n\
     start = { height = 0.1, tilt = 0.2 }\n[[contacts]]\nbetween = [\"cube\", \"ground\"]\nimpact = \"compensation\"\n\
     [run]\nseconds = 0.5\nstep = 5e-4\nevery = 100\n",
];

#[test]
fn a_cube_of_a_world_falls_as_that_of_a_scene_of_its_own() {
    let runs = [0, 1].map(|k| {
        let file = Path::new(env!("CARGO_TARGET_TMPDIR")).join(format!("cube{k}.toml"));
        std::fs::write(&file, CUBE[k]).expect("a file");
        rows(&[file.to_str().expect("a path")])
    });
    let mut off = 0.0_f64;
    for node in 0..8 {
        for axis in ["x", "y", "z"] {
            let names = [format!("{axis}{node}"), format!("cube.{axis}{node}")];
            let [one, other] =
                [0, 1].map(|k| runs[k].0.iter().position(|n| *n == names[k]).expect("a column"));
            for (a, b) in runs[0].1.iter().zip(&runs[1].1) {
                assert!((a[0] - b[0]).abs() < 1e-12);
                off = off.max((a[one] - b[other]).abs());
            }
        }
    }
    println!("off by {off:e} m");
    assert!(runs[0].1.len() > 9 && off < 1e-9, "{off:e}");
}

#[test]
fn two_cubes_that_collide_keep_their_momentum_and_make_no_energy() {
    let (names, rows) = rows(&["two_cubes"]);
    let column = |name: &str| names.iter().position(|n| n == name).expect(name);
    let places = |axis: &str| -> Vec<usize> {
        let of = |part: &str| (0..8).map(|n| column(&format!("{part}.{axis}{n}"))).collect::<Vec<_>>();
        [of("left"), of("right")].concat()
    };
    // All masses are alike: the mean place goes on at half the speed of the one cube.
    for (axis, speed) in [("x", 0.5), ("y", 0.0), ("z", 0.0)] {
        let own = places(axis);
        let mean = |row: &Vec<f64>| own.iter().map(|k| row[*k]).sum::<f64>() / 16.0;
        for row in &rows {
            let off = mean(row) - mean(&rows[0]) - speed * row[0];
            assert!(off.abs() < 1e-12, "{axis} at {}: {off:e}", row[0]);
        }
    }
    let total = column("total");
    assert!(rows.iter().all(|row| row[total] <= rows[0][total] * (1.0 + 1e-9)), "energy is created");
    // They met: the left one is slower, the right one moves.
    let (first, last) = (&rows[0], rows.last().expect("rows"));
    let way = last[column("right.x0")] - first[column("right.x0")];
    assert!(way > 0.05, "{way}");
}

#[test]
fn flexible_cubes_stack_and_come_to_rest() {
    let done = json(&["stack_cubes"]);
    let last = |name: &str| number(&done["last"][name]);
    assert!(last("kinetic") < 1e-6, "{}", last("kinetic"));
    for (part, top) in [("lower", 0.2), ("middle", 0.38), ("upper", 0.54)] {
        let found = last(&format!("{part}.top"));
        assert!((found - top).abs() < 4e-3, "{part}: {found}");
    }
    let start = number(&done["total_at_start"]);
    assert!(number(&done["imbalance"]).abs() < 0.02 * start, "{}", done["imbalance"]);
}

#[test]
fn a_bladder_carries_a_plate_and_a_ball() {
    for load in ["plate", "ball"] {
        let scene = format!("{load}_on_bladder");
        let rest = |mass: f64| {
            let mass = format!("parts.{load}.mass={mass}");
            let contacts =
                format!("contacts=[{{ between = [\"{load}\", \"bladder\"], impact = \"moreau\" }}]");
            let text = run(&["settle", &scene, "--json", "--set", &mass, "--set", &contacts]);
            let rest: serde_json::Value = serde_json::from_str(&text).expect("JSON");
            assert!(number(&rest["acceleration"]) < 1e-8, "{text}");
            let place = ["x", "y", "z"].map(|axis| number(&rest["last"][format!("{load}.{axis}")]));
            (number(&rest["total"]), place)
        };
        // Where the whole potential is least its change with the load's mass is g z, whatever carries it.
        let (less, more, (_, [x, y, z])) = (rest(0.98), rest(1.02), rest(1.0));
        let slope = (more.0 - less.0) / 0.04;
        assert!((slope / (G * z) - 1.0).abs() < 1e-3, "{load}: {slope} against {}", G * z);
        // In the middle of a symmetric sheet nothing moves it aside; more weight sinks deeper.
        assert!((x - 0.14).abs() < 1e-6 && (y - 0.14).abs() < 1e-6, "{load}: {x} {y}");
        assert!(more.1[2] < z && z < less.1[2], "{load}");
    }
}

#[test]
fn an_arm_that_pushes_a_wall_balances_one_force() {
    let done = json(&["arm6_pushes_wall"]);
    let q: Vec<f64> = (0..6).map(|i| number(&done["last"][format!("arm.q{i}")])).collect();
    let u: Vec<f64> = (0..6).map(|i| number(&done["last"][format!("arm.u{i}")])).collect();
    assert!(u.iter().all(|u| u.abs() < 1e-5), "at rest: {u:?}");
    let file = Path::new(env!("CARGO_TARGET_TMPDIR")).join("arm6_states.json");
    let given: Vec<String> = q.iter().enumerate().map(|(i, q)| format!("\"q{i}\": {q:e}")).collect();
    std::fs::write(&file, format!("{{\"states\": [{{\"q\": {{{}}}}}]}}", given.join(", "))).expect("states");
    let file = file.display().to_string();
    let answer = |what: &str| -> serde_json::Value {
        let text = run(&["eval", "arm6", "--answers", what, "--states", &file]);
        serde_json::from_str::<serde_json::Value>(&text).expect("JSON")["states"][0][what].clone()
    };
    let (port, held) = (answer("port:tool"), answer("inverse_dynamics"));
    let pi = std::f64::consts::PI;
    let torque = [
        60.0 * (0.3 - q[0]),
        -8.65 - 400.0 * (q[1] + pi / 6.0),
        20.5 - 400.0 * (q[2] - pi / 3.0),
        -200.0 * q[3],
        -200.0 * q[4],
        -200.0 * q[5],
    ];
    // What the joints give beyond holding the arm is the wall's force, along x at the tool: T - hold = -J' F.
    let left = |i: usize| torque[i] - number(&held["generalised_force"][format!("u{i}")]);
    let along = |i: usize| number(&port["jacobian"][0][i]);
    let force = -left(0) / along(0);
    assert!(force > 5.0, "it pushes: {force} N");
    for i in 0..6 {
        assert!(
            (left(i) + force * along(i)).abs() < 1e-3 * force,
            "joint {i}: {} {}",
            left(i),
            force * along(i)
        );
    }
    // The tip touches the wall's face at x = -0.14 m.
    assert!((number(&port["position"]["x"]) - 0.05 + 0.14).abs() < 1e-5, "{}", port["position"]["x"]);
}

#[test]
fn a_ball_on_a_tilted_bladder_goes_downhill_and_rolls_if_there_is_friction() {
    let place = |friction: &str| {
        let contacts = format!(
            "contacts=[{{ between = [\"ball\", \"bladder\"], impact = \"moreau\", friction = {friction} }}]"
        );
        let done = json(&["ball_on_tilted_bladder", "--set", &contacts]);
        ["x", "y", "wx", "wy"].map(|name| number(&done["last"][format!("ball.{name}")]))
    };
    // Screw A stands along y and is lifted: downhill is -y, and rolling that way is a turn about +x.
    let ([x, y, wx, wy], [_, slid, spin, _]) = (place("0.5"), place("0"));
    assert!(y < -0.01 && x.abs() < 1e-3 * y.abs() && wx > 0.1 && wy.abs() < 1e-2 * wx, "{x} {y} {wx} {wy}");
    // Without friction nothing turns it, and it gets further.
    assert!(slid < y && spin.abs() < 1e-9, "{slid} {y} {spin}");
}

#[test]
fn the_bed_carries_a_ball() {
    let done = json(&["bed"]);
    let last = |name: &str| number(&done["last"][name]);
    assert_eq!(done["parts"].as_f64(), Some(57.0));
    assert!(last("ball.z") > 0.2 && last("ball.x").is_finite(), "{}", last("ball.z"));
    // The bladders farthest from the ball do not know of it and are alike.
    let [a, b] = ["bladder[6,0].top", "bladder[6,3].top"].map(last);
    assert!((a - b).abs() < 1e-9, "{a} {b}");
    // What the drives give moves tiles, bladders and ball; a step of order 1 at its touches misses little of it.
    let (missed, given) = (number(&done["imbalance"]), last("drive"));
    assert!(given > 1.0 && missed.abs() < 1e-3 * given, "{missed} of {given}");
}

#[test]
fn sensors_read_late_and_coarse_and_change_nothing() {
    let sensors = "sensors={ seen = { of = \"ball.z\", resolution = 0.001, period = 0.01, delay = 0.01 }, \
                   low = { of = \"ball.z\", kind = \"switch\", closes = 0.3 } }";
    let (names, seen) =
        rows(&["rigid_ball_rests", "--set", sensors, "--set", "run.every=1", "--seconds", "0.4"]);
    let (_, blind) = rows(&["rigid_ball_rests", "--set", "run.every=1", "--seconds", "0.4"]);
    let column = |name: &str| names.iter().position(|n| n == name).expect(name);
    let (z, reading, low) = (column("ball.z"), column("sensors.seen"), column("sensors.low"));
    for (n, row) in seen.iter().enumerate() {
        assert_eq!(row[..blind[n].len()], blind[n][..], "row {n}");
        assert_eq!(row[low], f64::from(u8::from(row[z] >= 0.3)), "row {n}");
        // Behind a sample and its way there: what stood there one or two periods ago, to half a step of the reading.
        if n >= 20 {
            let sample = seen[10 * (n / 10) - 10][z];
            assert!((row[reading] - sample).abs() <= 0.5e-3 + 1e-12, "row {n}: {} {sample}", row[reading]);
        }
    }
}
