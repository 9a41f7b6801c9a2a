//! `run`: rows, settings, energies, pictures.

use crate::support::{file, smartbed, written};

/// Header and rows of a CSV text.
fn table(text: &str) -> (Vec<String>, Vec<Vec<f64>>) {
    let mut lines = text.lines();
    let header = lines.next().expect("a header").split(',').map(str::to_owned).collect();
    let row = |line: &str| line.split(',').map(|x| x.parse().expect("a number")).collect();
    (header, lines.map(row).collect())
}

fn column(table: &(Vec<String>, Vec<Vec<f64>>), name: &str) -> Vec<f64> {
    let index = table.0.iter().position(|n| n == name).unwrap_or_else(|| panic!("no column {name}"));
    table.1.iter().map(|row| row[index]).collect()
}

#[test]
fn rows_have_the_columns_of_the_contract() {
    let done =
        smartbed(&["run", "fourbar", "--seconds", "0.5", "--step", "1e-3", "--every", "100", "--csv", "-"]);
    assert_eq!(done.status, 0, "{done:?}");
    let table = table(&done.out);
    let expected = [
        "t",
        "q1",
        "q2",
        "q3",
        "u1",
        "u2",
        "u3",
        "kinetic",
        "gravity",
        "spring",
        "pressure",
        "damping",
        "drag",
        "impact",
        "friction",
        "actuator",
        "external",
        "total",
        "imbalance",
        "T",
    ];
    assert_eq!(table.0, expected);
    assert_eq!(table.1.len(), 6);
    let t = column(&table, "t");
    assert!(t.iter().enumerate().all(|(n, t)| (t - 0.1 * n as f64).abs() < 1e-15), "{t:?}");
    // 17 significant digits.
    let field = done.out.lines().nth(2).and_then(|l| l.split(',').nth(1)).expect("a field");
    let digits = field.split('e').next().map_or(0, |m| m.chars().filter(char::is_ascii_digit).count());
    assert_eq!(digits, 17, "{field}");
}

#[test]
fn every_method_falls_like_a_stone() {
    // A pendulum at small swing: q = q0 cos(w t) up to q0^2/16 of the period.
    let model = r#"
format = 1
name = "swing"
gravity = "-g*N.y"
[parameters]
l = { value = 0.5, unit = "m" }
m = { value = 2.0, unit = "kg" }
g = { value = 9.81, unit = "m/s^2", fixed = true }
[coordinates]
q = { unit = "rad" }
[frames]
rod = { parent = "N", rotations = [["z", "q"]] }
[points]
tip = "-l*rod.y"
[bodies]
bob = { centre = "tip", mass = "m" }
[start]
q = 1e-4
"#;
    let path = written("swing.toml", model);
    let exact = 1e-4 * (9.81_f64 / 0.5).sqrt().cos();
    // Bounds: first order, h w^2 T / 2 = 1e-2 of the amplitude; else what (q0^2 / 16) and rounding leave.
    let cases = [("euler", 2e-6), ("semi-implicit", 1e-6), ("rk4", 1e-12), ("dormand-prince", 1e-8)];
    for (method, bound) in cases {
        let done =
            smartbed(&["run", &path, "--seconds", "1", "--step", "1e-3", "--method", method, "--json"]);
        let q = done.json()["last"]["q"].as_f64().expect("a number");
        assert!((q - exact).abs() < bound, "{method}: {:.1e}", q - exact);
    }
}

#[test]
fn the_ledger_closes_with_damping_springs_and_a_motor() {
    let model = r#"
format = 1
name = "shaker"
gravity = "-g*N.z"
[parameters]
m = { value = 2.0, unit = "kg" }
k = { value = 300.0, unit = "N/m" }
c = { value = 4.0, unit = "N s/m" }
b = { value = 3.0, unit = "N s/m" }
f = { value = 7.0, unit = "N" }
g = { value = 9.81, unit = "m/s^2" }
[inputs]
F = { unit = "N" }
[coordinates]
z = { unit = "m", nominal = 0.5, range = [0.3, 0.7] }
[points]
P = "z*N.z"
[bodies]
mass = { centre = "P", mass = "m" }
[springs]
leg = { between = ["O", "P"], stiffness = "k", rest_length = "0.5_m", damping = "c" }
[forces]
motor = { point = "P", force = "(F - b*u_z)*N.z" }
push = { point = "P", force = "f*N.z" }
[law]
F = "20_N*sin(9*t/1_s)"
[start]
z = 0.6
"#;
    let path = written("shaker.toml", model);
    for (method, accuracy) in [("rk4", "--step=1e-3"), ("dormand-prince", "--tolerance=1e-10")] {
        let line = ["run", &path, "--seconds=2", "--every=50", "--method", method, accuracy, "--csv=-"];
        let done = smartbed(&line);
        assert_eq!(done.status, 0, "{done:?}");
        let table = table(&done.out);
        let last = |name: &str| *column(&table, name).last().expect("rows");
        for account in ["kinetic", "damping", "external", "actuator"] {
            assert!(last(account).abs() > 1e-3, "{account} has no entry: {}", last(account));
        }
        // The push is constant: its work is force times way.
        let z = column(&table, "z");
        let way = z[z.len() - 1] - z[0];
        assert!((last("external") - 7.0 * way).abs() < 1e-9, "{method}: {}", last("external") - 7.0 * way);
        // Energies of order 10 J, quadrature of order 4 at 1 ms or along steps of the tolerance.
        let worst = column(&table, "imbalance").into_iter().fold(0.0, |m: f64, x| m.max(x.abs()));
        assert!(worst < 1e-8, "{method}: {worst:.1e} J");
    }
}

#[test]
fn settings_take_parameters_and_start_values() {
    let last = |set: &[&str]| {
        let mut arguments = vec!["run", "pendulum3", "--seconds", "0.2", "--json"];
        arguments.extend(set.iter().flat_map(|s| ["--set", s]));
        let done = smartbed(&arguments);
        assert_eq!(done.status, 0, "{done:?}");
        done.json()["last"]["q2"].as_f64().expect("a number")
    };
    let (plain, heavy, turned) = (last(&[]), last(&["m1=3"]), last(&["q2=0.5", "u2=1"]));
    assert!(plain != heavy && plain != turned && heavy != turned);
    // A fixed parameter causes a new derivation: external force against weight of the whole tile.
    let up = smartbed(&["run", "tile", "--seconds", "0.1", "--set", "Fz=1000", "--json"]);
    assert!(up.json()["last"]["Gz"].as_f64().expect("a number") > 0.01, "{up:?}");
    let wrong = smartbed(&["run", "pendulum3", "--set", "m9=3"]);
    assert!(wrong.message().contains("no parameter or start value `m9`; did you mean `m"), "{wrong:?}");
    let wrong = smartbed(&["run", "fourbar", "--set", "u2=3"]);
    assert!(wrong.message().contains("the speed `u2` is dependent"), "{wrong:?}");
}

#[test]
fn single_precision_and_compiled_code_run_too() {
    let last = |more: &[&str]| {
        let mut arguments = vec!["run", "fourbar", "--seconds", "0.5", "--json"];
        arguments.extend(more);
        let done = smartbed(&arguments);
        assert_eq!(done.status, 0, "{done:?}");
        done.json()["last"].clone()
    };
    let double = last(&[]);
    assert_eq!(double, last(&["--engine", "compiled"]), "the same bits");
    let single = last(&["--scalar", "f32"]);
    assert_eq!(single, last(&["--scalar", "f32", "--engine", "compiled"]), "the same bits in f32");
    let q1 = |x: &serde_json::Value| x["q1"].as_f64().expect("a number");
    // 500 steps of single precision with compensated sums.
    assert!(q1(&double) != q1(&single) && (q1(&double) - q1(&single)).abs() < 1e-5);
}

#[test]
fn pictures_are_what_their_names_say() {
    let path = |name: &str| file(name).display().to_string();
    let (svg, png, html) = (path("motion.svg"), path("motion.png"), path("motion.html"));
    for picture in [&svg, &png] {
        let done = smartbed(&["run", "tile", "--seconds", "0.5", "--plot", picture, "--view", &html]);
        assert_eq!(done.status, 0, "{done:?}");
    }
    let text = std::fs::read_to_string(svg).expect("an svg");
    for part in [
        "<svg ",
        "time [s]",
        "length [m]",
        "angle [rad]",
        "energy [J]",
        ">hA, hB, hC, Gz<",
        ">kinetic",
        "</svg>",
    ] {
        assert!(text.contains(part), "{part}");
    }
    let bytes = std::fs::read(png).expect("a png");
    assert_eq!(bytes[..8], [0x89, b'P', b'N', b'G', b'\r', b'\n', 0x1a, b'\n']);
    // Two pixels for each of the drawing.
    assert_eq!(bytes[16..20], 2000_u32.to_be_bytes());
    assert!(bytes.len() > 10_000, "{}", bytes.len());
    let page = std::fs::read_to_string(html).expect("a page");
    assert!(page.contains("<canvas") && page.contains("\"GA\"") || page.contains("\"G\""));
    // The library's own text names standards and its manual.
    let page = page.replace(smartbed::view::THREE, "");
    assert!(!page.contains("http://") && !page.contains("https://"), "self-contained");
    let wrong = smartbed(&["run", "tile", "--plot", "x.pdf"]);
    assert!(wrong.message().contains(".svg or .png"), "{wrong:?}");
}

#[test]
fn a_plot_says_how_it_was_made_and_shows_what_is_asked_for() {
    let svg = file("shown.svg").display().to_string();
    let run = |model: &str, more: &[&str]| {
        let mut arguments = vec!["run", model, "--plot", &svg];
        arguments.extend(more);
        let done = smartbed(&arguments);
        assert_eq!(done.status, 0, "{done:?}");
        std::fs::read_to_string(&svg).expect("a plot")
    };
    let plot = run(
        "tile",
        &[
            "--seconds",
            "0.2",
            "--method",
            "rk4",
            "--step",
            "0.002",
            "--set",
            "hA=0.01",
            "--show",
            "h*,u_psi*",
        ],
    );
    assert!(plot.contains("rk4, step 0.002 s, hA = 0.01") && plot.contains("rate [rad/s]"));
    assert!(
        plot.contains(">hA<") && plot.contains("u_psiA") && !plot.contains("u_h") && !plot.contains(">thA")
    );
    // Symmetry keeps these angles at 0, rounding at 1e-17.
    assert!(run("tile", &["--seconds", "0.2"]).contains(">psiC, thC = 0<"), "rounding noise is 0");
    let drop = run("single_spring", &["--seconds", "0.6", "--show", "vz*"]);
    assert!(drop.contains("speed [m/s]") && drop.contains("grey: touches") && !drop.contains(">z0"));
    let wrong = smartbed(&["run", "tile", "--plot", &svg, "--show", "hD"]);
    assert!(wrong.message().contains("--show hD: no curve has such a name; did you mean"), "{wrong:?}");
}

#[test]
fn numbers_out_of_range_are_refused() {
    let cases: [(&[&str], &str); 8] = [
        (&["--tolerance", "0"], "--tolerance 0: expected"),
        (&["--budget", "3"], "--budget 3: expected a time with its unit"),
        (&["--step", "0"], "--step 0: expected a time above 0"),
        (&["--step", "nan"], "--step NaN: expected"),
        (&["--seconds", "-1"], "expected a time of 0 or more"),
        (&["--seconds", "1e12"], "take a larger --step"),
        (&["--every", "0"], "--every 0: expected"),
        (&["--error", "0"], "--error 0: expected"),
    ];
    for (more, message) in cases {
        let arguments: Vec<String> =
            ["run", "pendulum3"].iter().map(|s| (*s).to_owned()).chain(joined(more)).collect();
        let arguments: Vec<&str> = arguments.iter().map(String::as_str).collect();
        let done = smartbed(&arguments);
        assert!(done.message().contains(message), "{more:?}: {done:?}");
    }
}

/// `--name=value`, so that negative numbers are no options.
fn joined(pair: &[&str]) -> Vec<String> {
    vec![pair.join("=")]
}

#[test]
fn scenes_run_with_the_same_arguments() {
    let picture = file("drop.png").display().to_string();
    let done = smartbed(&[
        "run",
        "single_spring",
        "--seconds",
        "0.5",
        "--every",
        "50",
        "--set",
        "K=4000",
        "--csv",
        "-",
        "--plot",
        &picture,
    ]);
    assert_eq!(done.status, 0, "{done:?}");
    let table = table(&done.out);
    assert_eq!(table.0[..4], ["t", "x0", "y0", "z0"]);
    assert!(column(&table, "kinetic").last().expect("rows") > &1.0);
    // Energies of order 30 J.
    assert!(column(&table, "imbalance").iter().all(|x| x.abs() < 1e-9));
    assert!(std::fs::metadata(picture).expect("a picture").len() > 5_000);
    let wrong = smartbed(&["run", "single_spring", "--set", "CC=10"]);
    assert!(wrong.message().contains("CC"), "{wrong:?}");
}

#[test]
fn coordinates_in_closed_form_have_columns() {
    let rows = |model: &str| {
        let done = smartbed(&["run", model, "--seconds", "0.2", "--every", "100", "--csv", "-"]);
        assert_eq!(done.status, 0, "{done:?}");
        table(&done.out)
    };
    let (closed, solved) = (rows("slider_crank_closed"), rows("slider_crank"));
    assert_eq!(closed.0[..7], ["t", "q", "b", "x", "u_q", "u_b", "u_x"]);
    for name in ["q", "b", "x", "u_b", "u_x"] {
        let pairs = column(&closed, name).into_iter().zip(column(&solved, name));
        // One integrates b and x and puts them back, the other does not: RK4 at 1 ms is off by some 1e-9.
        assert!(pairs.into_iter().all(|(a, b)| (a - b).abs() < 2e-8), "{name}");
    }
}

/// The shipped slider-crank by its piston: the crank turns on through both dead points of each turn.
#[test]
fn a_run_goes_through_dead_points() {
    let shipped = concat!(env!("CARGO_MANIFEST_DIR"), "/../models/slider_crank.toml");
    let text = std::fs::read_to_string(shipped).expect("it is shipped");
    let text = text
        .replace("q = { unit = \"rad\", independent = true, nominal", "q = { unit = \"rad\", nominal")
        .replace("x = { unit = \"m\", nominal", "x = { unit = \"m\", independent = true, nominal");
    let path = written("slider_crank_by_its_piston.toml", &text);
    let done = smartbed(&["run", &path, "--seconds", "2", "--strict", "--every", "10", "--csv", "-"]);
    assert_eq!(done.status, 0, "{done:?}");
    let table = table(&done.out);
    let [q, b, x, imbalance] = ["q", "b", "x", "imbalance"].map(|name| column(&table, name));
    assert!(*q.last().expect("rows") > 4.0 * std::f64::consts::TAU, "{q:?}");
    for (row, q) in q.iter().enumerate() {
        let rod = -(0.1 * q.sin() / 0.3).asin();
        let piston = 0.1 * q.cos() + 0.3 * rod.cos();
        assert!((b[row] - rod).abs() < 1e-9 && (x[row] - piston).abs() < 1e-9, "{q}: {} {}", b[row], x[row]);
    }
    // The crank turns with some 4 J.
    assert!(imbalance.iter().all(|x| x.abs() < 1e-5), "{imbalance:?}");
}

#[test]
fn outputs_that_are_not_finite_are_warned_of() {
    let text = r#"format = 1
name = "falling"
gravity = "-9.81_m/1_s/1_s*N.z"
[parameters]
k = { value = 1, unit = "m" }
[coordinates]
z = { unit = "m" }
[points]
P = "z*N.z"
[bodies]
p = { centre = "P", mass = 1 }
[outputs]
share = "(z - 1_m)/k"
"#;
    let model = written("falling_share.toml", text);
    let run = |k: &str| smartbed(&["run", &model, "--set", k, "--seconds", "0.01", "--step", "0.001"]);
    let done = run("k=0");
    assert!(done.err.contains("outputs are not finite: `share` = -inf first at t = 0.0000 s"), "{done:?}");
    let done = run("k=2");
    assert!(done.err.is_empty(), "{done:?}");
}

#[test]
fn a_tiny_step_is_refused_in_few_words() {
    let tiny = smartbed(&["run", "pendulum", "--step", "1e-300"]);
    assert!(tiny.message().contains("10 s in steps of 1e-300 s are more than 1e9 steps"), "{tiny:?}");
    assert!(tiny.err.len() < 120, "{tiny:?}");
}

/// What shares its name with another column is told apart, and none is dropped.
#[test]
fn outputs_and_inputs_with_the_name_of_a_column_have_columns_of_their_own() {
    let text = "format = 1\nname = \"names\"\n[inputs]\nF = { unit = \"N\" }\n[coordinates]\nx = { unit = \"m\" }\n[points]\nP = \"x*N.x\"\n\
        [bodies]\nb = { centre = \"P\", mass = 1 }\n[forces]\nf = { point = \"P\", force = \"F*N.x\" }\n\
        [outputs]\nfriction = \"1_N\"\nu_x = \"7*x\"\nF = \"11\"\nother = \"x\"\n[law]\nF = \"2_N\"\n\
        [start]\nx = 1\n[run]\nseconds = 0.1\nstep = 0.1\n";
    let done = smartbed(&["run", &written("names.toml", text), "--csv", "-"]);
    let rows: Vec<Vec<&str>> = done.out.lines().map(|line| line.split(',').collect()).collect();
    let at = |name: &str| {
        let places: Vec<usize> = (0..rows[0].len()).filter(|n| rows[0][*n] == name).collect();
        assert_eq!(places.len(), 1, "{name}: {:?}", rows[0]);
        rows[1][places[0]].parse::<f64>().expect("a number")
    };
    let found = ["x", "u_x", "friction", "output.friction", "output.u_x", "F", "input.F", "other"].map(at);
    assert_eq!(found, [1.0, 0.0, 0.0, 1.0, 7.0, 11.0, 2.0, 1.0]);
    // Speeds of a run of no length are shown as they are.
    let done = smartbed(&["run", &written("names.toml", text), "--seconds", "0", "--set", "u_x=0.25"]);
    assert!(done.out.contains("0.250000 m/s"), "{}", done.out);
}

/// Folded into its line of centres a parallelogram is singular; what its pivots of 0 make of the numbers behind them is
/// not the cause.
#[test]
fn a_run_that_starts_at_a_change_point_is_told_so() {
    for start in ["q1=0", "q1=pi"] {
        let start = start.replace("pi", &std::f64::consts::PI.to_string());
        let done = smartbed(&["run", "parallelogram", "--set", &start, "--set", "u_q1=1"]);
        assert_eq!(done.status, 1, "{done:?}");
        assert!(done.err.contains("the configuration is singular"), "{start}: {done:?}");
    }
}

#[test]
fn a_run_that_starts_with_a_spring_of_no_length_names_the_spring() {
    let text = "format = 1\nname = \"loose\"\n[parameters]\nm = { value = 1, unit = \"kg\" }\n\
                l = { value = 0.5, unit = \"m\" }\nk = { value = 100, unit = \"N/m\" }\n\
                [coordinates]\nx = { unit = \"m\" }\ny = { unit = \"m\" }\n[points]\nP = \"x*N.x + y*N.y\"\n\
                [bodies]\nb = { centre = \"P\", mass = \"m\" }\n\
                [springs]\nstay = { between = [\"O\", \"P\"], stiffness = \"k\", rest_length = \"l\" }\n";
    let path = written("loose.toml", text);
    for method in ["rk4", "dormand-prince"] {
        let done = smartbed(&["run", &path, "--method", method]);
        assert!(
            done.message().contains("the spring `stay` has no length, hence its force no direction"),
            "{done:?}"
        );
    }
    assert_eq!(smartbed(&["run", &path, "--set", "x=0.1"]).status, 0);
}
