//! What a run of a world writes: rows, plots, pages, checkpoints, sensors.

use super::support::{ELSEWHERE, fails, json, number, rows, run, scene, smartbed, times};
use std::path::Path;

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
    // Beside the curves the parts from the side, at three times.
    let plot = std::fs::read_to_string(&svg).expect("a plot");
    for word in ["A box bounces", "From the side", "start, 0.000 s", "first touch, 0.", "end, 0.500 s"] {
        assert!(plot.contains(word), "{word}");
    }
    let page = std::fs::read_to_string(&page).expect("a page");
    assert!(page.contains("\"kind\":\"box\"") && page.contains("\"grounds\":[{"), "stage");
}

#[test]
fn numbers_of_a_picture_far_from_the_origin_keep_apart() {
    let text = "format = 2\n[parts.ground]\nrigid = \"half_space\"\n\
                [parts.ball]\nrigid = \"sphere\"\nradius = 0.1\nmass = 1\n\
                start = { position = [1e9, 0, 1], velocity = [1, 0, 0] }\n\
                [[contacts]]\nbetween = [\"ball\", \"ground\"]\nimpact = \"stronge\"\n[run]\nseconds = 1\n";
    let svg = Path::new(env!("CARGO_TARGET_TMPDIR")).join("runs_far.svg").display().to_string();
    run(&["run", &scene("runs_far", text), "--plot", &svg]);
    let plot = std::fs::read_to_string(&svg).expect("a plot");
    // Left and right end of each number below the three pictures.
    let field = |element: &str, name: &str| -> f64 {
        let rest = element.split_once(&format!("{name}=\"")).expect(name).1;
        rest.split('"').next().and_then(|number| number.parse().ok()).expect("a number")
    };
    let numbers = plot.split("<text ").filter(|element| element.contains(">1.0000000"));
    let found: Vec<(f64, f64, &str)> = numbers
        .map(|element| {
            let (middle, half) = (field(element, "x"), 0.5 * field(element, "textLength"));
            let words = element.split_once('>').and_then(|(_, rest)| rest.split('<').next());
            (middle - half, middle + half, words.expect("a number"))
        })
        .collect();
    assert!(found.len() >= 3, "{found:?}");
    assert!(found.iter().all(|(_, _, words)| words.ends_with("5e9")), "half a metre: {found:?}");
    assert!(found.windows(2).all(|pair| pair[0].1 < pair[1].0), "they meet: {found:?}");
}

#[test]
fn names_with_commas_stay_one_column_each() {
    let text = r#"
format = 2
[parts.floor]
rigid = "half_space"
[parts.b]
rigid = "sphere"
radius = 0.1
mass = 1
grid = { count = [1, 2], pitch = [0.5, 0.5] }
start = { height = 0.5 }
[parts."a,\"b\""]
rigid = "sphere"
radius = 0.1
mass = 1
start = { height = 0.5, position = [3, 0, 0] }
[run]
seconds = 0
"#;
    let file = scene("names_with_commas", text);
    let (names, found) = rows(&[&file]);
    assert!(found.iter().all(|row| row.len() == names.len()), "{names:?}");
    // Each name has the number that its part starts with: a pitch away from its neighbour, at the same height.
    let of =
        |name: &str| found[0][names.iter().position(|n| n == name).unwrap_or_else(|| panic!("{names:?}"))];
    let places = [of("b[0,1].x") - of("b[0,0].x"), of("b[0,1].y") - of("b[0,0].y")];
    assert_eq!((places[0].hypot(places[1]), of("b[0,1].z") - of("b[0,0].z")), (0.5, 0.0), "{places:?}");
    assert_eq!(of("a,\"b\".x"), 3.0);
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
fn a_run_that_is_resumed_goes_on_bit_for_bit() {
    for scene in ["box_bounce", "tile_bladder_coupled", "ball_on_bladder", "stack_cubes"] {
        let file =
            Path::new(env!("CARGO_TARGET_TMPDIR")).join(format!("{scene}.state")).display().to_string();
        let whole = json(&[scene, "--seconds", "0.4"]);
        json(&[scene, "--seconds", "0.3", "--save", &file]);
        let resumed = json(&[scene, "--seconds", "0.4", "--resume", &file]);
        // Another scene than that of the checkpoint is told of; the same one, in another format of rows, is not.
        let told =
            |json: &serde_json::Value| json["warnings"].to_string().contains("another text of the scene");
        let changed = json(&[scene, "--seconds", "0.4", "--resume", &file, "--set", "gravity=[0, 0, -9]"]);
        assert!(told(&changed) && !told(&resumed), "{scene}: {}", changed["warnings"]);
        assert_eq!(whole["last"], resumed["last"], "{scene}");
        let late = |json: &serde_json::Value| -> Vec<f64> {
            times(json).into_iter().filter(|time| *time > 0.3).collect()
        };
        // What presses already is no event.
        assert_eq!(late(&whole), late(&resumed), "{scene}");
        let said = fails(&["run", "closed_loop_hung", "--resume", &file]);
        assert!(said.contains("belongs to another scene"), "{said}");
        let said = fails(&["run", scene, "--step", "1e-4", "--resume", &file]);
        assert!(said.contains("was reached by steps of") && said.contains("give --step"), "{said}");
        let said = fails(&["run", scene, "--error", "1e-3", "--resume", &file]);
        assert!(said.contains("goes on with the step it began with"), "{said}");
    }
}

#[test]
fn a_run_that_is_resumed_by_another_method_says_so() {
    let file = Path::new(env!("CARGO_TARGET_TMPDIR")).join("other_method.state").display().to_string();
    let run = |more: &[&str]| json(&[&["tile_bladder_coupled"], more].concat());
    let whole = run(&["--seconds", "0.04"]);
    run(&["--seconds", "0.02", "--save", &file]);
    let same = run(&["--seconds", "0.04", "--resume", &file, "--method", "rk4"]);
    assert!(!same["warnings"].to_string().contains("by the method"), "{}", same["warnings"]);
    let other = run(&["--seconds", "0.04", "--resume", &file, "--method", "blanes_moan4"]);
    let told = "reached by the method rk4, the run goes on with blanes_moan4";
    assert!(other["warnings"].to_string().contains(told), "{}", other["warnings"]);
    let height = |json: &serde_json::Value| json["last"]["bladder.z24"].as_f64().expect("a height");
    let apart = (height(&whole) - height(&other)).abs();
    assert!(apart < 1e-6, "{apart:e} m");
}

#[test]
fn a_delay_of_too_many_periods_is_refused_in_words() {
    let sensors = "sensors={ seen = { of = \"ball.z\", period = 0.01, delay = 0.2 } }";
    let said = fails(&["run", "rigid_ball_rests", "--set", sensors]);
    assert!(said.contains("sensors.seen: `delay` is") && said.contains("at most 15 periods"), "{said}");
}

#[test]
fn what_no_sensor_reads_is_said() {
    for name in ["kinetic", "total", "t"] {
        let sensor = format!("sensors={{ seen = {{ of = \"{name}\" }} }}");
        let said = fails(&["run", "rigid_ball_rests", "--seconds", "0.01", "--set", &sensor]);
        let words = format!("sensors.seen: no number `{name}` in the rows");
        assert!(said.contains(&words) && said.contains("energies are written, not sensed"), "{said}");
    }
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
        // Behind a sample and its way there: what stood there one or two periods ago, to half a step of the reading;
        // before that the first sample.
        let sample = seen[(10 * (n / 10)).saturating_sub(10)][z];
        assert!((row[reading] - sample).abs() <= 0.5e-3 + 1e-12, "row {n}: {} {sample}", row[reading]);
    }
}

/// Differences of sensors with the same noise would have none, and their means as much as one.
#[test]
fn sensors_have_noise_of_their_own_unless_they_share_a_seed() {
    let readings = |seed: &str| {
        let sensor = format!("{{ of = \"ball.z\", noise = 1, period = 0.001{seed} }}");
        let sensors = format!("sensors={{ one = {sensor}, other = {sensor} }}");
        let (names, seen) =
            rows(&["rigid_ball_rests", "--set", &sensors, "--set", "run.every=1", "--seconds", "0.5"]);
        let column = |name: &str| names.iter().position(|n| n == name).expect(name);
        let [z, one, other] = ["ball.z", "sensors.one", "sensors.other"].map(column);
        // Readings and what is read are of about the same time.
        seen.iter().skip(2).map(|row| [row[one] - row[z], row[other] - row[z]]).collect::<Vec<_>>()
    };
    let alike = |seen: &[[f64; 2]]| {
        let sum = |of: fn(&[f64; 2]) -> f64| seen.iter().map(of).sum::<f64>();
        sum(|[a, b]| a * b) / (sum(|[a, _]| a * a) * sum(|[_, b]| b * b)).sqrt()
    };
    assert!(alike(&readings("")).abs() < 0.15, "{}", alike(&readings("")));
    assert!(alike(&readings(", seed = 3")) > 0.999);
    assert_eq!(readings(""), readings(""));
}

#[test]
fn a_key_is_set_once() {
    for twice in [
        &["--seconds", "0.3", "--set", "run.seconds=0.2"][..],
        &["--set", "run.step=2e-3", "--set", "run.step=1e-3"],
        &["--method", "verlet", "--set", "run.method=rk4"],
        &["--set", "contacts[0].friction=0.1", "--set", "contacts.0.friction=0.2"],
    ] {
        let said = fails(&[&["run", "box_bounce"], twice].concat());
        assert!(said.contains("is set twice; leave one of them out"), "{twice:?}: {said}");
    }
    // A key and then the table that holds it, which would take it away.
    let whole = [
        "run",
        "box_bounce",
        "--set",
        "parts.box.mass=2",
        "--set",
        "parts.box={rigid=\"sphere\",radius=1,mass=1}",
    ];
    let said = fails(&whole);
    assert!(said.contains("`parts.box.mass` is set twice; this replaces the whole table"), "{said}");
    let said = fails(&["settle", "plate_on_bladder", "--set", "run.step=1e-3", "--set", "run.step=1e-3"]);
    assert!(said.contains("`run.step` is set twice"), "{said}");
}

#[test]
fn a_table_that_is_set_replaces_that_of_the_file() {
    let text = "format = 2\ngravity = [0, 0, 0]\n[parts.ball]\nrigid = \"sphere\"\nradius = 0.1\nmass = 1\n\
                start = { position = [1, 0, 0], velocity = [0, 2, 0] }\n[run]\nseconds = 0.1\nstep = 0.01\n";
    let file = scene("runs_replaced", text);
    let place = |settings: &[&str]| {
        let settings = settings.iter().flat_map(|setting| ["--set", *setting]);
        let last =
            &json(&[&file].into_iter().map(String::as_str).chain(settings).collect::<Vec<_>>())["last"];
        ["x", "y", "z"].map(|axis| (number(&last[format!("ball.{axis}")]) * 1e6).round() / 1e6)
    };
    assert_eq!(place(&[]), [1.0, 0.2, 0.0]);
    assert_eq!(place(&["parts.ball.start.position=[0, 0, 5]"]), [0.0, 0.2, 5.0], "one key of the table");
    assert_eq!(place(&["parts.ball.start={ position = [0, 0, 5] }"]), [0.0, 0.0, 5.0], "the whole table");
    assert_eq!(place(&["parts.ball={ start = {}, rigid = \"sphere\", radius = 1, mass = 1 }"]), [0.0; 3]);
    // One after the other.
    let both = ["parts.ball.start={ position = [0, 0, 5] }", "parts.ball.start.velocity=[1, 0, 0]"];
    assert_eq!(place(&both), [0.1, 0.0, 5.0]);
    let said = fails(&["run", "box_bounce", "--set", "contacts[0]={between=[\"box\",\"ground\"]}"]);
    assert!(said.contains("a pair of parts without a law"), "{said}");
}

/// What of a scene that was changed since can be continued.
#[test]
fn a_checkpoint_is_continued_with_or_without_sleep_but_with_the_same_sensors() {
    let state = |name: &str| {
        Path::new(env!("CARGO_TARGET_TMPDIR")).join(format!("runs_{name}.state")).display().to_string()
    };
    let (awake, slow) = (state("awake"), state("slow"));
    let run = |more: &[&str]| json(&[&["ball_on_bladder", "--seconds"], more].concat());
    let sleep = ["--set", "run.sleep=\"1 mm/s\""];
    run(&["0.01", "--save", &awake]);
    run(&[&["0.01", "--save", &slow], &sleep[..]].concat());
    let told = |done: &serde_json::Value| {
        done["warnings"].to_string().contains("run.sleep, unlike this run: all parts were awake")
    };
    let whole = run(&["0.02"]);
    for (file, more, is_told) in
        [(&awake, &[][..], false), (&awake, &sleep, true), (&slow, &[], true), (&slow, &sleep, false)]
    {
        let done = run(&[&["0.02", "--resume", file], more].concat());
        assert_eq!(told(&done), is_told, "{file} {more:?}: {}", done["warnings"]);
        // Nothing sleeps yet.
        let z = |done: &serde_json::Value| number(&done["last"]["ball.z"]);
        assert!((z(&whole) - z(&done)).abs() < 1e-12, "{file} {more:?}");
    }
    let sensor = ["--set", "sensors={ high = { of = \"ball.z\" } }"];
    let seen = state("seen");
    run(&[&["0.01", "--save", &seen], &sensor[..]].concat());
    let refused = |file: &str, more: &[&str]| {
        fails(&[&["run", "ball_on_bladder", "--seconds", "0.02", "--resume", file], more].concat())
    };
    assert!(refused(&awake, &sensor).contains("this one is with sensors.high;"), "a new sensor");
    assert!(refused(&seen, &[]).contains("this one is without sensors.high;"), "a sensor that is gone");
    run(&[&["0.02", "--resume", &seen], &sensor[..]].concat());
}

/// Two bodies of one kind whose places in the text are exchanged would take each other's state.
#[test]
fn a_checkpoint_is_not_continued_with_other_parts() {
    let [a, b, c] = ["a", "b", "c"].map(|name| {
        format!("[parts.{name}]\nrigid = \"sphere\"\nradius = 0.1\nmass = 1\nstart = {{ position = [0, {}, 0] }}\n", name.as_bytes()[0])
    });
    let of = |name: &str, parts: &[&String]| {
        let parts: String = parts.iter().map(|part| part.as_str()).collect();
        scene(name, &format!("format = 2\ngravity = [0, 0, 0]\n{parts}[run]\nseconds = 0.02\n"))
    };
    let saved = Path::new(env!("CARGO_TARGET_TMPDIR")).join("runs_parts.state").display().to_string();
    json(&[&of("one_way", &[&a, &b]), "--seconds", "0.01", "--save", &saved]);
    let refused = |file: &str| fails(&["run", file, "--resume", &saved]);
    assert!(refused(&of("other_way", &[&b, &a])).contains("this one is with them in another order;"));
    let said = refused(&of("others", &[&a, &c]));
    assert!(said.contains("this one is without b (rigid) and with c (rigid);"), "{said}");
    json(&[&of("one_way", &[&a, &b]), "--resume", &saved]);
}

#[test]
fn rows_have_euler_parameters_of_unit_length() {
    // As a part of any world a box is integrated in Euler parameters, whose length drifts.
    let text = format!(
        "format = 2\ngravity = [0, 0, 0]\n[parts.box]\nrigid = \"box\"\nsize = [0.1, 0.2, 0.3]\nmass = 1\n\
         start = {{ spin = [10, 1, 30] }}\n{ELSEWHERE}\
         [sensors.turn]\nof = \"box.e0\"\n[run]\nseconds = 2\nstep = 0.005\nmethod = \"rk4\"\nevery = 20\n"
    );
    let (names, found) = rows(&[&scene("runs_unit_length", &text)]);
    let place = |name: &str| names.iter().position(|own| own == name).expect(name);
    let (e0, turn) = (place("box.e0"), place("sensors.turn"));
    for row in &found {
        let length: f64 = row[e0..e0 + 4].iter().map(|e| e * e).sum();
        assert!((length - 1.0).abs() < 1e-12, "t = {}: {length}", row[0]);
        assert_eq!(row[turn], row[e0], "a sensor reads the row");
    }
}

#[test]
fn parts_that_no_force_moves_are_no_pair() {
    let text = |law: &str| {
        format!(
            "format = 2\n[parts.ground]\nrigid = \"half_space\"\n[parts.tile]\nmechanism = \"tile_minimal\"\n\
             command = {{ hA = \"-0.1_m*t/1_s\", hB = \"-0.1_m*t/1_s\", hC = \"-0.1_m*t/1_s\" }}\nstart = {{ position = [0, 0, \"50_mm\"] }}\n\
             [parts.plate]\nrigid = \"box\"\nsize = [0.2, 0.2, 0.02]\non = \"tile.platform\"\n\
             [[contacts]]\nbetween = [\"plate\", \"ground\"]\nimpact = \"{law}\"\n"
        )
    };
    for law in ["moreau", "stronge", "newton"] {
        let said = fails(&["run", &scene(&format!("runs_immovable_{law}"), &text(law))]);
        assert!(said.contains("`plate` and `ground` are both fixed or follow commands"), "{law}: {said}");
    }
    // Rigid parts alone, too.
    let text = "format = 2\n[parts]\nground = { rigid = \"half_space\" }\n\
                w = { rigid = \"half_space\", start = { position = [0, 0, -3] } }\n\
                ball = { rigid = \"sphere\", radius = 0.1, mass = 1, start = { height = 1 } }\n\
                [[contacts]]\nbetween = [\"w\", \"ground\"]\nimpact = \"stronge\"\n";
    let said = fails(&["run", &scene("runs_immovable_rigid", text)]);
    assert!(said.contains("`w` and `ground` are both fixed or follow commands"), "{said}");
}

#[test]
fn a_last_step_that_is_shorter_is_no_tick_of_sensors() {
    let text = |seconds: f64| {
        format!(
            "format = 2\ngravity = [0, 0, 0]\n\
             [parts.ball]\nrigid = \"sphere\"\nradius = 0.1\nmass = 1\nstart = {{ velocity = [1, 0, 0] }}\n\
             [sensors]\nslow = {{ of = \"ball.x\", period = 0.011 }}\nlate = {{ of = \"ball.x\", delay = 0.001 }}\n\
             lag = {{ of = \"ball.x\", kind = \"pressure\", lag = 0.005 }}\n\
             [run]\nseconds = {seconds}\nstep = 0.001\nevery = 100\n"
        )
    };
    let at = |seconds: f64, wanted: &str| {
        let (names, found) = rows(&[&scene(&format!("runs_ticks_{seconds}"), &text(seconds))]);
        found[1][names.iter().position(|name| name == wanted).expect(wanted)]
    };
    assert_eq!((at(0.01, "t"), at(0.0101, "t")), (0.01, 0.0101));
    assert!((at(0.0101, "ball.x") - 0.0101).abs() < 1e-12, "the ball moves on");
    for name in ["sensors.slow", "sensors.late", "sensors.lag"] {
        assert_eq!(at(0.0101, name), at(0.01, name), "{name}");
    }
    assert_eq!(at(0.0101, "sensors.slow"), 0.0, "its next sample is that of 0.011 s");
    assert!((at(0.0101, "sensors.late") - 0.009).abs() < 1e-12, "{}", at(0.0101, "sensors.late"));
    assert!((at(0.011, "sensors.slow") - 0.011).abs() < 1e-12);
}

#[test]
fn what_a_mechanism_warns_of_alone_it_warns_of_in_a_scene() {
    let part = "[parts.m]\nmechanism = \"parallelogram\"\n";
    let text = |others: &str| format!("format = 2\n{part}{others}[run]\nseconds = 0.5\n");
    let single = scene("runs_ranges", &text(""));
    // Stepped apart from another mechanism.
    let apart = scene("runs_ranges_apart", &text("[parts.other]\nmechanism = \"fourbar\"\n"));
    let said = |arguments: &[&str], warning: &str| {
        let done = json(arguments);
        let all = done["warnings"].as_array().expect("warnings");
        all.iter().filter(|text| text.as_str().is_some_and(|text| text.contains(warning))).count()
    };
    for warning in ["left the ranges", "nearly singular (a pivot of 3.3e-4 of nominal)"] {
        assert_eq!(said(&["parallelogram", "--seconds", "0.5"], warning), 1, "{warning}");
    }
    for file in [&single, &apart] {
        for warning in [
            "left the ranges",
            "motion of `m` passed a configuration that is nearly singular (a pivot of 3.3e-4",
        ] {
            assert_eq!(said(&[file], warning), 1, "{file}: {warning}");
        }
    }
    assert!(fails(&["run", &single, "--strict"]).contains("`m.q3` = "));
}

#[test]
fn an_iteration_over_contacts_that_fails_names_what_helps() {
    // A cube is squeezed flat between the ground and a ball of a hundred times its mass.
    let text = "format = 2\n[parts.ground]\nrigid = \"half_space\"\n\
                [parts.cube]\nshape = \"cube\"\nside = 0.1\nmass = 0.1\nK = 100\nstart = { height = 0.5, velocity = [3, 0, -30] }\n\
                [parts.ball]\nrigid = \"sphere\"\nradius = 0.05\nmass = 10\nstart = { position = [0.05, 0.05, 1.5], velocity = [0, 0, -60] }\n\
                [[contacts]]\nbetween = [\"cube\", \"ground\"]\nimpact = \"moreau\"\nrestitution = 0.5\nfriction = 0.5\n\
                [[contacts]]\nbetween = [\"cube\", \"ball\"]\nimpact = \"moreau\"\nfriction = 0.5\n\
                [run]\nseconds = 0.3\nstep = 0.01\nmethod = \"energy_momentum\"\n";
    let file = scene("runs_unsettled", text);
    let said = fails(&["run", &file]);
    assert!(said.contains("does not converge") && said.contains("method = \"moreau\" or laws"), "{said}");
    run(&["run", &file, "--method", "moreau"]);
}

#[test]
fn energies_that_are_no_numbers_end_a_run() {
    let text = "format = 2\n[parts.ball]\nrigid = \"sphere\"\nradius = 0.1\nmass = 1\nstart = { velocity = [1e200, 0, 0] }\n";
    let said = fails(&["run", &scene("runs_infinite", text)]);
    assert!(said.contains("t = 0.000000 s: the energy is not finite"), "{said}");
}

/// The energy of a gas is the small difference of numbers 400 times as large.
#[test]
fn rounding_of_a_gas_at_rest_is_no_finding() {
    let text = "format = 2\n[parts.ground]\nrigid = \"half_space\"\n[parts.bladder]\nshape = \"sheet\"\nrows = 5\ncolumns = 5\n\
        width = 0.28\ndepth = 0.28\nbase = 0.04\nmass = 0.01\nK = 2000\nC = 0.5\nstart = { position = [0, 0, 0.04] }\n\
        gas = { gauge = 1000, sealed = true, exponent = 1.2 }\n\
        attach = [{ nodes = \"rim\", to = \"ground\" }, { facets = \"base\", to = \"ground\" }]\n\
        [parts.ball]\nrigid = \"sphere\"\nradius = 0.06\nmass = 1\nstart = { position = [0.14, 0.14, 0], height = 0.06 }\n\
        [[contacts]]\nbetween = [\"ball\", \"bladder\"]\nimpact = \"moreau\"\nfriction = 0.3\n\
        [run]\nseconds = 0.3\nstep = 0.0005\nstart = \"settled\"\n";
    let done = json(&[&scene("runs_gas_at_rest", text), "--strict"]);
    assert_eq!(done["warnings"], serde_json::json!([]));
}

#[test]
fn a_ball_that_may_have_passed_through_a_plate_is_told_of() {
    let text = |law: &str| {
        format!(
            "format = 2\ngravity = [0, 0, 0]\n[parts.plate]\nrigid = \"box\"\nsize = [\"1_m\", \"1_m\", \"2_mm\"]\nfixed = true\n\
             [parts.ball]\nrigid = \"sphere\"\nradius = \"10_mm\"\nmass = \"10_g\"\n\
             start = {{ position = [0, 0, \"1.01_m\"], velocity = [0, 0, \"-70 m/s\"] }}\n\
             [[contacts]]\nbetween = [\"ball\", \"plate\"]\nimpact = \"{law}\"\nrestitution = 0.5\n\
             [run]\nseconds = 0.03\nstep = \"1_ms\"\n"
        )
    };
    for law in ["stronge", "moreau"] {
        let file = scene(&format!("runs_tunnel_{law}"), &text(law));
        let missed = json(&[&file]);
        assert!(number(&missed["last"]["ball.z"]) < -0.1, "{law}: a step of 70 mm does not see 22");
        let said = missed["warnings"].to_string();
        assert!(
            said.contains("`ball` and `plate` moved by more than both are wide in 1 step"),
            "{law}: {said}"
        );
        assert!(said.contains("at most 3.1e-4 s"), "{law}: {said}");
        let seen = json(&[&file, "--step", "2e-4"]);
        assert!(
            number(&seen["last"]["ball.z"]) > 0.1 && seen["warnings"] == serde_json::json!([]),
            "{law}: {seen}"
        );
    }
}

/// Boxes that rest on four corners each: above 64 contacts a run of located laws names the law that splits no steps.
#[test]
fn many_contacts_of_located_laws_are_told() {
    let boxes = |count: usize, law: &str| {
        let text = format!(
            "format = 2\n[parts.ground]\nrigid = \"half_space\"\n[parts.box]\nrigid = \"box\"\nsize = [0.1, 0.1, 0.1]\nmass = 1\n\
             start = {{ height = 0 }}\ngrid = {{ count = [{count}, 1], pitch = [0.5, 0.5] }}\n[[contacts]]\nbetween = [\"box\", \"ground\"]\n\
             impact = \"{law}\"\n[run]\nseconds = 0.003\n"
        );
        let output = smartbed(&["run", &scene(&format!("boxes_{count}_{law}"), &text)]);
        assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
        String::from_utf8_lossy(&output.stderr).into_owned()
    };
    let said = boxes(17, "plastic");
    assert!(
        said.contains("note: up to 68 contacts press at once") && said.contains("impact = \"moreau\""),
        "{said}"
    );
    assert!(
        !boxes(16, "plastic").contains("press at once") && !boxes(17, "moreau").contains("press at once")
    );
}
