//! `bed` and `sweep`: plans run and refused, pages in which no text runs as script, sweeps with reproducible bytes.

use crate::schema::holds;
use crate::support::{command, file, smartbed, timed, written};
use smartbed::plan::parse;
use std::collections::BTreeMap;
use std::path::Path;
use std::process::Stdio;
use std::time::Duration;

#[test]
fn a_plan_is_run_and_prints_what_the_schema_says() {
    let maps = ["bed_map.csv", "bed_map.asf"].map(|name| file(name).display().to_string());
    for map in &maps {
        let done = smartbed(&["bed", "run", "ball_on_four", "--json", "--map", map]);
        assert_eq!(done.status, 0, "{done:?}");
        let json = done.json();
        holds("bed", &json);
        assert_eq!(
            (&json["version"], &json["seeds"]),
            (&env!("CARGO_PKG_VERSION").into(), &serde_json::json!({}))
        );
        assert_eq!(json["command"], "smartbed bed run ball_on_four");
        assert!(
            json["plan_sha256"].as_str().is_some_and(|hash| hash.len() == 64) && json["motion"].is_null()
        );
        assert!(json["imbalance"].as_f64().expect("a number") < 1e-6);
        assert!(json["sensed_error"].as_f64().expect("a number") < 0.01);
        assert_eq!(json["note"], "engineering indices, not clinical evidence");
        let text = std::fs::read_to_string(map).expect("a map");
        let read = smartbed_bed::files::read(&text).expect("read back");
        assert_eq!((read.grid.rows, read.grid.columns, read.recording.frames().len()), (20, 16, 5));
    }
}

#[test]
fn maps_of_sensor_makers_are_read_compared_and_written() {
    // Two frames of 2 x 3 sensels of 30 by 20 mm, 9 cm2 being less than two of them.
    let movie = |last: &str| {
        format!(
            "DATA_TYPE MOVIE\nROWS 2\nCOLS 3\nROW_SPACING 20 mm\nCOL_SPACING 30 mm\nSECONDS_PER_FRAME 5\nUNITS mmHg\n\
             ASCII_DATA @@\nFrame 1\n10,20,30\n40,50,60\n\nFrame 2\n{last}\n40,50,60\n\n@@\n"
        )
    };
    let (one, other) = (written("one.asf", &movie("10,20,30")), written("other.asf", &movie("10,20,36")));
    let [again, metrics] = ["again.csv", "map_metrics.csv"].map(|name| file(name).display().to_string());
    let done = smartbed(&["bed", "map", &one, "--against", &other, "-o", &again, "--csv", &metrics]);
    assert_eq!(done.status, 0, "{done:?}");
    assert!(done.out.contains("2 x 3 sensels of 30.00 by 20.00 mm, 2 frames over 10 s"), "{done:?}");
    // Six mmHg at one of six sensels in one of two frames: sqrt(36/12) mmHg. The window: (2 x 60 + 30)/3 and
    // (2 x 60 + 36)/3.
    assert!(done.out.contains("1.732 mmHg root mean square, peak pressure index -3.85 % of it"), "{done:?}");
    assert!(done.out.contains("engineering indices, not clinical evidence"));
    let table = std::fs::read_to_string(&metrics).expect("metrics");
    let value = |name: &str| {
        let row = table.lines().find(|line| line.starts_with("sensels,bed,") && line.contains(name));
        row.and_then(|row| row.split(',').rev().nth(2)?.parse::<f64>().ok()).expect("a value")
    };
    // 40, 50 and 60 mmHg lie above 32, on 6 cm2 each; all of the time.
    assert!(
        (value("\"peak pressure\"") - 60.0).abs() < 1e-9 && (value("area above 32 mmHg") - 18.0).abs() < 1e-9
    );
    assert!((value("always at risk") - 18.0).abs() < 1e-9);
    let text = std::fs::read_to_string(&again).expect("maps");
    let read = smartbed_bed::files::read(&text).expect("read back");
    assert_eq!((read.grid.rows, read.grid.columns, read.recording.seconds()), (2, 3, 10.0));
    assert!(!done.err.contains("warning"), "{done:?}");
    let done = smartbed(&["bed", "map", &one, "--against", &other, "--json"]).json();
    holds("map", &done);
    assert_eq!((&done["rows"], &done["pitch"][0], &done["seconds"]), (&2.into(), &0.03.into(), &10.0.into()));
    let apart = &done["difference"];
    assert!((apart["rms"].as_f64().expect("a number") - 3.0_f64.sqrt()).abs() < 1e-9, "{apart}");
    assert!((apart["peak_pressure_index"].as_f64().expect("a number") + 6.0 / 156.0).abs() < 1e-9, "{apart}");
    // A last moment of no time lasts as long as the others in a movie, and stays as it is in the other format.
    let ended =
        written("ended.csv", &text.replace("Time (s),5\nDuration (s),5", "Time (s),5\nDuration (s),0"));
    let movie_again = file("ended.asf").display().to_string();
    let done = smartbed(&["bed", "map", &ended, "-o", &movie_again]);
    assert!(done.status == 0 && done.out.contains("2 frames over 5 s"), "{done:?}");
    assert!(
        done.err.contains("ended.asf: the last moment, which stands for no time, lasts 5 s there"),
        "{done:?}"
    );
    let done = smartbed(&["bed", "map", &movie_again, "-o", &file("ended_again.csv").display().to_string()]);
    assert!(done.out.contains("2 frames over 10 s") && !done.err.contains("warning"), "{done:?}");
    let say = |arguments: &[&str]| smartbed(&[&["bed", "map"], arguments].concat()).message().to_owned();
    let wide = written("wide.asf", &movie("10,20,30").replace("30 mm", "31 mm"));
    assert!(say(&[&one, "--against", &wide]).contains("expected the same sensels and as many frames"));
    let raw = written("raw.asf", &movie("10,20,30").replace("UNITS mmHg", "UNITS RAW"));
    assert!(say(&[&raw]).contains("raw.asf: line 7: unit of pressure `RAW`"));
    assert!(say(&[&one, "-o", "map.txt"]).contains("map.txt: expected a name that ends in .csv or .asf"));
    assert!(say(&[&one, "--json", "--csv", "-"]).contains("--csv - and --json"));
    assert!(say(&[&one, "--cycle", "0"]).contains("--cycle 0: expected seconds > 0"));
}

#[test]
fn a_plan_with_sensors_is_read_and_one_with_a_policy_decided() {
    let run = |settings: &[&str]| {
        let set: Vec<&str> = settings.iter().flat_map(|s| ["--set", s]).collect();
        let done = smartbed(&[&["bed", "run", "ball_on_four", "--json"], &set[..]].concat());
        assert_eq!(done.status, 0, "{done:?}");
        holds("bed", &done.json());
        done.json()
    };
    let nodes = run(&["sensors.seed=3"]);
    let read = &nodes["sensors"];
    assert_eq!((read["rows"].as_f64(), read["columns"].as_f64()), (Some(20.0), Some(16.0)));
    let error = read["map_error"].as_f64().expect("a number");
    assert!(error > 0.0 && error < 0.01 && nodes["valid"] == true, "{nodes}");
    assert!((read["ph"].as_f64().expect("a number") - 5.0).abs() < 0.1);
    assert_eq!(run(&["sensors.seed=3"]), nodes);
    assert_ne!(run(&["sensors.seed=4"])["sensors"], *read);
    let fine = run(&["sensors.pitch=1_mm"]);
    assert!(
        fine["sensors"]["map_error"].as_f64().expect("a number") < 0.01 && fine["valid"] == true,
        "{fine}"
    );
    assert!(fine["sensors"]["columns"].as_f64().expect("a number") >= 450.0);
    let noisy = run(&["sensors.noise=0.01"]);
    assert!(noisy["valid"] == false, "{noisy}");
    let goal =
        ["policy.cycle=40_s", "policy.slots=2", "policy.ramp=5_s", "policy.hold=5_s", "policy.low=2_kPa"];
    let bounds = ["policy.most_low=3", "policy.low_below=2.5_kPa"];
    // In the middle of four alike bladders rounding would say which of them are let down.
    let place = "load.place=[\"12_mm\", \"8_mm\"]";
    let told = run(&[&["policy.kind=\"planner\"", "sensors.seed=1", place], &goal[..], &bounds[..]].concat());
    assert_eq!(told["policy"], "planner");
    assert!(told["moves"].as_f64().expect("a number") >= 1.0);
}

#[test]
fn what_a_nurse_enters_stands_beside_what_is_computed_and_changes_nothing() {
    let plan = |braden: &str| {
        let name = if braden.is_empty() { "unscored.toml" } else { "scored.toml" };
        let bed = "[bed]\nintervals = [6, 8]\npressure = \"5_kPa\"\n";
        written(name, &format!("format = 1\n{bed}[patient]\nmass = 60\n{braden}"))
    };
    let run = |plan: &str| smartbed(&["bed", "run", plan, "--json"]);
    let marks = "[patient.braden]\nsensory = 2\nmoisture = 3\nactivity = 1\nmobility = 2\nnutrition = 2\n";
    let scored = plan(&format!("{marks}friction_and_shear = 1\n"));
    let (with, without) = (run(&scored), run(&plan("")));
    assert_eq!((with.status, without.status), (0, 0), "{with:?} {without:?}");
    let (with, without) = (with.json(), without.json());
    holds("bed", &with);
    assert_eq!((&with["braden"]["sum"], &with["braden"]["band"]), (&11.into(), &"high risk".into()));
    assert!(
        without["braden"].is_null()
            && with["skin"] == without["skin"]
            && with["sensels"] == without["sensels"]
    );
    let page = file("scored.html").display().to_string();
    let done = smartbed(&["bed", "report", &scored, "-o", &page, "--json"]);
    assert_eq!(done.status, 0, "{done:?}");
    holds("bed", &done.json());
    assert_eq!(done.json()["page"], page.as_str());
    let text = std::fs::read_to_string(&page).expect("a page");
    assert!(text.contains("Braden, as the nurse entered it: 11 of 23, high risk (sensory 2, moisture 3"));
    assert!(text.contains("command smartbed bed report") && text.contains("plan sha256"));
    // A mark left out, one beyond its scale.
    let say = |marks: &str| {
        run(&written("wrong_marks.toml", &format!("format = 1\n[patient]\n{marks}"))).message().to_owned()
    };
    assert!(say(marks).contains("`friction_and_shear`"), "{}", say(marks));
    let beyond = say(&format!("{marks}friction_and_shear = 4\n"));
    assert!(beyond.contains("Braden mark `friction_and_shear` is 4, expected 1 to 3"), "{beyond}");
}

#[test]
fn what_could_not_be_written_is_refused_before_the_run() {
    let say = |arguments: &[&str]| smartbed(arguments).message().to_owned();
    // A run of this load would say that it touches no bladder.
    let lost = ["bed", "run", "ball_on_four", "--set", "load.place=[5, 0]"];
    let run = |more: &[&str]| say(&[&lost, more].concat());
    assert!(run(&[]).contains("the load touches no bladder"));
    assert!(run(&["--map", "map.txt"]).contains("map.txt: expected a name that ends in .csv or .asf"));
    assert!(run(&["--readings", "r.csv"]).contains("the plan has no [instruments]"));
    assert!(say(&["sweep", "ball_on_four", "--cores", "0"]).contains("--cores 0: expected at least 1"));
    let pressure = say(&["bed", "run", "ball_on_four", "--set", "bed.pressure=5_kN/m"]);
    assert!(pressure.contains("`pressure` must be in Pa"), "{pressure}");
}

#[test]
fn a_planner_tells_nothing_that_exceeds_its_bounds_before_a_run_ends() {
    // A ramp that the end of the run cuts off was judged by its start alone, and refused on its way.
    let load = "[load]\nshape = \"ball\"\nradius = \"150_mm\"\nmass = \"12_kg\"\n";
    let clock = "[run]\nclock = \"dynamics\"\nseconds = 6\nevery = 0.5\n[dynamics]\nstep = \"4_ms\"\n";
    let bed = "[bed]\nrows = 2\ncolumns = 2\n[policy]\nkind = \"planner\"\n";
    let plan = written("short_planner.toml", &format!("format = 1\n{bed}{load}{clock}"));
    let done = smartbed(&["bed", "run", &plan, "--json"]);
    assert_eq!(done.status, 0, "{done:?}");
    let json = done.json();
    holds("bed", &json);
    let from = json["policy_from"].as_f64().expect("the ball lies");
    assert!((0.5..6.0).contains(&from) && json["motion"]["steps"] == 1500 && json["valid"] == true, "{json}");
}

#[test]
fn a_move_after_the_end_of_the_run_is_named_with_its_place() {
    let parsed = |at: &str| {
        let text =
            format!("format = 1\n[[move]]\ntiles = \"all\"\nat = {at}\nheave = 0\n[run]\nseconds = 60\n");
        parse("plan.toml", &text, &[]).expect("a plan").warnings.to_string()
    };
    assert_eq!(parsed("60"), "", "the last moment shows what is commanded then");
    let said = parsed("61");
    let message = "warning: a move at 61 s has no effect: the run ends at 60 s";
    assert!(said.starts_with(message) && said.contains(" --> plan.toml:4:6"), "{said}");
    let done = smartbed(&["bed", "run", "ball_on_four", "--set", "run.seconds=0"]);
    assert!(done.status == 0 && done.err.contains("has no effect: the run ends at 0 s"), "{done:?}");
}

#[test]
fn a_motion_of_0_s_says_that_it_took_no_step() {
    let of = |clock: &str| {
        let clock = format!("run.clock=\"{clock}\"");
        let done = smartbed(&["bed", "run", "ball_on_four", "--set", "run.seconds=0", "--set", &clock]);
        assert_eq!(done.status, 0, "{done:?}");
        done.out
    };
    let motion = of("dynamics");
    assert!(motion.contains("motion: no step, since run.seconds is 0"), "{motion}");
    assert!(
        motion.contains(": 1 moment over 0 s") && !motion.contains("largest force over 0 ms"),
        "{motion}"
    );
    assert!(of("quasi_static").contains(": 1 equilibrium over 0 s"));
}

#[test]
fn plans_beyond_their_limits_are_refused_with_the_tile() {
    let say =
        |setting: &str| smartbed(&["bed", "run", "ball_on_four", "--set", setting]).message().to_owned();
    let pressure = say("bed.pressure=20_kPa");
    assert!(
        pressure.contains("tile 1 at 0.0000 s: pressure of 20.00 kPa, expected 0 to 12.00 kPa"),
        "{pressure}"
    );
    assert!(say("bed.rows=20").contains("40 tiles, expected 1 to 28"));
    assert!(say("bed.rwos=2").contains("`bed` has no field `rwos`"));
    assert!(say("load.mass=2000_kg").contains("all bladders can carry"));
    let knee =
        smartbed(&["bed", "run", "alternating", "--set", "patient.joints={\"left knee\"=[\"30_deg\",0,0]}"]);
    assert!(knee.message().contains("joint `left knee`: flexion is 30 deg, expected -140 to 5 deg"));
    assert!(smartbed(&["bed", "run", "no_such"]).message().contains("no plan `no_such`"));
    let map = smartbed(&["bed", "run", "ball_on_four", "--map", "map.txt"]);
    assert!(map.message().contains("expected a name that ends in .csv or .asf"));
}

#[test]
fn no_text_of_a_plan_can_run_in_its_page() {
    let plan = include_str!("../../../models/plans/ball_on_four.toml");
    let evil = "</script><script>alert(1)</script><img src=x onerror=alert(2)>@DATA@";
    let plan = plan.replace("A ball on four bladders\"", &format!("{evil}\""));
    let (plan, page) = (written("evil.toml", &plan), file("evil.html").display().to_string());
    let done = smartbed(&["bed", "report", &plan, "-o", &page]);
    assert_eq!(done.status, 0, "{done:?}");
    let text = std::fs::read_to_string(page).expect("a page");
    assert!(!text.contains("<script>alert") && !text.contains("<img"));
    // Data, library, script.
    assert_eq!(text.matches("</script>").count(), 3);
    let outside = text.replacen(smartbed::view::THREE, "", 1);
    assert_eq!(outside.matches("<script").count(), 3);
    assert!(text.contains("engineering indices, not clinical evidence"));
}

/// Names and texts of a folder's files.
fn texts(folder: &Path) -> BTreeMap<String, String> {
    let files = std::fs::read_dir(folder).expect("a folder").map(|e| e.expect("an entry").path());
    let text = |p: &Path| std::fs::read_to_string(p).expect("text");
    files.map(|p| (p.file_name().expect("a name").to_string_lossy().into_owned(), text(&p))).collect()
}

#[test]
fn a_sweep_gives_the_same_bytes_in_shards_on_any_cores_and_after_a_break() {
    let folder = |name: &str| {
        let folder = file(name);
        let _ = std::fs::remove_dir_all(&folder);
        folder
    };
    let [whole, shards] = ["sweep_whole", "sweep_shards"].map(folder);
    let [one, two] = [&whole, &shards].map(|f| f.display().to_string());
    let run = |arguments: &[&str]| {
        let done = smartbed(&[&["sweep", "ball_on_four"], arguments].concat());
        assert_eq!(done.status, 0, "{done:?}");
        done.out
    };
    assert!(run(&["-o", &one, "--cores", "1"]).contains("4 cases"));
    assert!(run(&["-o", &two, "--shard", "2/2", "--cores", "3"]).contains("2 cases of 4 left"));
    let early = smartbed(&["sweep", "ball_on_four", "-o", &two, "--merge"]);
    assert!(early.message().contains("2 cases of 4 missing"), "{early:?}");
    // A case that was cut off does not count as done.
    std::fs::write(shards.join("case_00002.json"), "{\"version\"").expect("written");
    run(&["-o", &two, "--shard", "1/2"]);
    let summary: serde_json::Value = serde_json::from_str(&run(&["-o", &two, "--json"])).expect("JSON");
    holds("swept", &summary);
    let numbers = ["cases", "left", "refused"].map(|key| summary[key].as_u64());
    assert_eq!(numbers, [Some(4), Some(0), Some(0)], "{summary}");
    assert_eq!(texts(&whole), texts(&shards));
    let table = &texts(&whole)["sweep.csv"];
    assert_eq!(table.lines().count(), 5);
    assert!(table.starts_with("case,\"load.mass\",\"bed.pressure\","), "{table}");
    let bad = smartbed(&["sweep", "ball_on_four", "-o", &one, "--shard", "3/2"]);
    assert!(bad.message().contains("expected I/N with I from 1 to N"));
    // A setting that every case would override.
    let vain = smartbed(&["sweep", "ball_on_four", "-o", &one, "--set", "load.mass=5_kg"]);
    assert!(
        vain.message().contains("--set load.mass=5_kg: the [sweep] gives this key its values"),
        "{vain:?}"
    );
    let spelled = smartbed(&["sweep", "ball_on_four", "-o", &one, "--set", "load . \"mass\" = 5"]);
    assert!(spelled.message().contains("the [sweep] gives this key its values"), "{spelled:?}");
    let twice =
        smartbed(&["sweep", "ball_on_four", "-o", &one, "--set", "run.seconds=1", "--set", "run.seconds=2"]);
    assert!(twice.message().contains("`run.seconds` is set twice; leave one of them out"), "{twice:?}");
    let plan = written(
        "sweep_spelled.toml",
        "format = 1\n[bed]\nrows = 1\ncolumns = 1\n[load]\nshape = \"ball\"\nradius = \"150_mm\"\nmass = 1\n\
         [sweep]\n\"load.mass\" = [1, 2]\n\"load.\\\"mass\\\"\" = [3]\n",
    );
    let same = smartbed(&["sweep", &plan, "-o", &one]);
    assert!(same.message().contains("in [sweep] replaces `load.mass`; leave one of them out"), "{same:?}");
    assert!(smartbed(&["sweep", "alternating", "-o", &one]).message().contains("it has no [sweep]"));
}

#[test]
fn a_sweep_with_refused_cases_has_its_table_and_says_why() {
    let plan = written(
        "sweep_refused.toml",
        "format = 1\n[bed]\nrows = 1\ncolumns = 1\nintervals = [8, 8]\n[load]\nshape = \"ball\"\nradius = \"150_mm\"\nmass = 1\n\
         [sweep]\n\"load.mass\" = [1, 2]\n\"bed.pressure\" = [100, 4000]\n",
    );
    let [whole, shards] = ["sweep_refused_whole", "sweep_refused_shards"].map(file);
    let _ = [&whole, &shards].map(std::fs::remove_dir_all);
    let [one, two] = [&whole, &shards].map(|f| f.display().to_string());
    let run = |arguments: &[&str]| {
        let done = smartbed(&[&["sweep", &plan], arguments].concat());
        assert_eq!(done.status, 0, "{done:?}");
        done.out
    };
    let said = "4 cases, 2 of them refused: the column `refused` says why";
    assert!(run(&["-o", &one, "--cores", "1"]).contains(said));
    run(&["-o", &two, "--shard", "2/2"]);
    run(&["-o", &two, "--shard", "1/2"]);
    assert!(run(&["-o", &two, "--merge"]).contains(said));
    assert_eq!(texts(&whole), texts(&shards));
    let table = &texts(&whole)["sweep.csv"];
    let lines: Vec<&str> = table.lines().collect();
    assert!(
        lines.len() == 5 && lines[0].starts_with("case,\"load.mass\",\"bed.pressure\",\"refused\","),
        "{table}"
    );
    // 100 Pa on a tile of 219 x 279.7 mm bear 6 N, the balls weigh 10 and 20 N.
    let why = "at 0.0000 s: all bladders can carry 6 N, expected at least 1.2 times the weight of";
    for (line, weight) in [(1, "10 N"), (3, "20 N")] {
        assert!(lines[line].contains(&format!("\"{why} {weight}\",,")), "{}", lines[line]);
    }
    for line in [2, 4] {
        let numbers = lines[line].split_once("\"4000\",\"\",").expect("no reason").1;
        assert!(numbers.starts_with(|letter: char| letter.is_ascii_digit()), "{}", lines[line]);
    }
    let case: serde_json::Value = serde_json::from_str(&texts(&whole)["case_00001.json"]).expect("JSON");
    assert!(case["refused"].as_str().is_some_and(|text| text.starts_with(why)) && case["valid"] == false);
}

/// One bladder under a ball, with these lines of a sweep.
fn ball_swept(name: &str, lines: &str) -> (String, String) {
    let text = "format = 1\n[bed]\nrows = 1\ncolumns = 1\nintervals = [8, 8]\n[load]\nshape = \"ball\"\nradius = \"150_mm\"\nmass = 1\n";
    let folder = file(&format!("sweep_{name}"));
    let _ = std::fs::remove_dir_all(&folder);
    let plan = written(&format!("sweep_{name}.toml"), &format!("{text}[sweep]\n{lines}\n"));
    (plan, folder.display().to_string())
}

#[test]
fn a_sweep_of_a_key_that_no_case_has_is_refused_before_the_first() {
    let (plan, folder) = ball_swept("unknown", "\"load.mass\" = [1, 2]\n\"load.masss\" = [1, 2]");
    let done = smartbed(&["sweep", &plan, "-o", &folder]);
    let words = "`load.masss` in [sweep]: `load` has no field `masss`; did you mean `mass`?";
    assert!(done.message().contains(words), "{done:?}");
    assert!(!Path::new(&folder).exists(), "nothing was computed");
    // A key of some cases only: a ball has no size, a plate has one.
    let shapes = "\"load.shape\" = [\"ball\", \"plate\"]\n\"load.size\" = [[0.1, 0.1, 0.02]]\n\"load.radius\" = [0.005]";
    let (plan, folder) = ball_swept("shapes", shapes);
    let done = smartbed(&["sweep", &plan, "-o", &folder]);
    assert!(!done.err.contains("in [sweep]") && Path::new(&folder).exists(), "{done:?}");
}

#[test]
fn a_sweep_in_which_every_case_is_refused_fails_with_its_table() {
    let (plan, folder) = ball_swept("vain", "\"bed.pressure\" = [100, 110]");
    let done = smartbed(&["sweep", &plan, "-o", &folder]);
    let said = "2 cases, all of them refused: the column `refused` says why; the first: at 0.0000 s: all bladders can carry";
    assert!(done.message().contains(said), "{done:?}");
    let table = std::fs::read_to_string(Path::new(&folder).join("sweep.csv")).expect("a table");
    assert_eq!(table.lines().count(), 3, "{table}");
}

#[test]
fn a_sweep_takes_lists_as_values() {
    let (plan, folder) = ball_swept("lists", "\"bed.intervals\" = [[6, 8], [8, 8]]");
    let done = smartbed(&["sweep", &plan, "-o", &folder]);
    assert!(done.status == 0 && done.out.contains("2 cases\n"), "{done:?}");
    let table = std::fs::read_to_string(Path::new(&folder).join("sweep.csv")).expect("a table");
    assert!(table.contains("\n1,\"[6, 8]\",") && table.contains("\n2,\"[8, 8]\","), "{table}");
}

/// Starts the program and kills it after a while.
fn killed(arguments: &[&str], milliseconds: u64) {
    let mut child = command(arguments).stdout(Stdio::null()).stderr(Stdio::null()).spawn().expect("runs");
    std::thread::sleep(Duration::from_millis(milliseconds));
    child.kill().expect("killed, or ended before");
    child.wait().expect("ended");
}

#[test]
fn what_is_killed_leaves_complete_files_only() {
    let folder = file("sweep_killed");
    let _ = std::fs::remove_dir_all(&folder);
    let (csv, name) = (folder.join("metrics.csv"), folder.display().to_string());
    std::fs::create_dir_all(&folder).expect("a folder");
    for milliseconds in [5, 20, 50, 100, 150, 200, 300, 400, 600, 800] {
        killed(&["sweep", "ball_on_four", "-o", &name, "--cores", "2"], milliseconds);
        killed(&["bed", "run", "ball_on_four", "--csv", &csv.display().to_string()], milliseconds);
        for (file, text) in texts(&folder) {
            if file.ends_with(".json") {
                assert!(serde_json::from_str::<serde_json::Value>(&text).is_ok(), "{file}: {text}");
            }
            assert!(file != "metrics.csv" || text.lines().count() > 40, "{file}: {text}");
            assert!(file != "sweep.csv" || text.lines().count() == 5, "{file}: {text}");
        }
    }
    // What was cut off is cleared away; what is being written stays.
    std::fs::write(folder.join("case_00003.part-1"), "{\"version\"").expect("written");
    std::fs::write(folder.join("sweep.part-1"), "case,").expect("written");
    let written = std::fs::File::create(folder.join("sweep.part-2")).expect("written");
    written.lock().expect("locked");
    std::fs::write(folder.join("case_00004.json"), "{\"version\"").expect("written");
    let done = smartbed(&["sweep", "ball_on_four", "-o", &name]);
    assert_eq!(done.status, 0, "{done:?}");
    let files: Vec<String> = texts(&folder).into_keys().filter(|f| !f.starts_with("metrics")).collect();
    let cases = [1, 2, 3, 4].map(|n| format!("case_{n:05}.json"));
    assert_eq!(files, [&cases[..], &["sweep.csv", "sweep.part-2"].map(str::to_owned)].concat());
}

#[test]
fn ten_minutes_on_the_thesis_grid_take_less_than_two_of_a_processor() {
    let settings = ["--set", "bed.intervals=[28,28]", "--set", "run.every=25_s"];
    let (done, seconds) =
        timed(&command(&[&["bed", "run", "alternating", "--json"], &settings[..]].concat()));
    assert_eq!(done.status, 0, "{done:?}");
    let json = done.json();
    assert!(json["moments"] == 25 && json["valid"] == true, "{json}");
    println!("{seconds:.0} s of processor time");
    assert!(seconds < 120.0, "{seconds} s");
}

#[test]
fn a_motion_whose_energy_does_not_close_says_so() {
    let text = "format = 1\n[bed]\nrows = 1\ncolumns = 1\n[load]\nshape = \"ball\"\nradius = \"0.1_m\"\nmass = \"2_kg\"\n\
                [run]\nclock = \"dynamics\"\nseconds = 0.4\nevery = 0.2\n";
    let plan = written("bed_not_closed.toml", text);
    let said = |set: &[&str]| {
        let set = set.iter().flat_map(|s| ["--set", s]);
        let arguments: Vec<&str> = ["bed", "run", plan.as_str()].into_iter().chain(set).collect();
        let done = smartbed(&arguments);
        assert!(done.out.contains("motion:"), "{}", done.err);
        done.out.contains("NOT CLOSED")
    };
    assert!(said(&["dynamics.step=0.1"]));
    assert!(!said(&[]));
    assert!(!said(&["dynamics.sheet_loss=0", "dynamics.tissue_loss=0"]));
}
