//! Laws, loads and commands that switch at times: pulses of every length, at ends of steps, for every method and row.

use crate::support::{smartbed, written};

/// A mass of 1 kg under a force, or tied by a spring to what is commanded.
fn pushed(name: &str, law: &str) -> String {
    let text = format!(
        "format = 1\nname = \"{name}\"\n[inputs]\nF = {{ unit = \"N\" }}\n[coordinates]\nx = {{ unit = \"m\" }}\n\
         [points]\nP = \"x*N.x\"\n[bodies]\nb = {{ centre = \"P\", mass = 1 }}\n[forces]\n\
         f = {{ point = \"P\", force = \"F*N.x\" }}\n[law]\nF = \"{law}\"\n[run]\nseconds = 1\nstep = 1e-3\n"
    );
    written(&format!("{name}.toml"), &text)
}

/// These columns of the last row.
fn last<const N: usize>(arguments: &[&str], columns: [&str; N]) -> [f64; N] {
    let done = smartbed(&[&["run", "--json", "--strict"], arguments].concat());
    assert_eq!(done.status, 0, "{arguments:?}: {done:?}");
    let row = done.json()["last"].clone();
    columns.map(|name| row[name].as_f64().unwrap_or_else(|| panic!("no {name}: {row}")))
}

/// Steps, methods and rows that a motion cut at every switch does not depend on.
const WAYS: [&[&str]; 9] = [
    &["--method=rk4"],
    &["--method=rk4", "--step=1e-2"],
    &["--method=rk4", "--step=5e-2", "--every=20"],
    &["--method=dormand-prince"],
    &["--method=dormand-prince", "--every=10"],
    &["--method=dormand-prince", "--every=500"],
    &["--method=dormand-prince", "--every=1000"],
    &["--method=dormand-prince", "--step=5e-2"],
    &["--error=1e-6", "--every=1000"],
];

/// It was dropped without a word where a row interval, or a step, held all of it, and 3.3 times as long where a stage
/// of a step happened to see it.
#[test]
fn a_pulse_that_is_written_as_a_product_is_seen_whole() {
    for (number, [from, to]) in [[0.3, 0.302], [0.3031, 0.3051], [0.5, 0.5003]].into_iter().enumerate() {
        let law = format!("50_N*(1 + sign((t - {from}_s)*({to}_s - t)/1_s/1_s))/2");
        let model = pushed(&format!("pulse_{number}"), &law);
        let speed = 50.0 * (to - from);
        let place = speed * (1.0 - 0.5 * (from + to));
        for way in WAYS {
            let [x, u] = last(&[&[model.as_str()], way].concat(), ["x", "u_x"]);
            let off = (x - place).abs().max((u - speed).abs());
            assert!(off < 1e-11, "{from} to {to}, {way:?}: x = {x}, u = {u}");
        }
    }
}

/// No product, but a function that comes back: above 0.9999 within 1.8 ms of its peaks, at 0.1 s, 0.5 s and 0.9 s.
#[test]
fn a_pulse_within_a_step_is_seen_where_its_function_turns() {
    let model = pushed("peaks", "50_N*(1 + sign(sin(2*pi*t/0.4_s) - 0.9999))/2");
    let half = 0.4 / std::f64::consts::TAU * 0.9999_f64.acos();
    let speed = 50.0 * 2.0 * half;
    let place = speed * (0.9 + 0.5 + 0.1);
    for way in WAYS {
        let [x, u] = last(&[&[model.as_str()], way].concat(), ["x", "u_x"]);
        let off = (x - place).abs().max((u - 3.0 * speed).abs());
        assert!(off < 1e-10, "{way:?}: x = {x}, u = {u}");
    }
}

/// Another switch in the same step does not hide it.
#[test]
fn a_pulse_before_another_switch_of_the_step_is_seen() {
    let model = pushed("both", "50_N*(1 + sign(sin(2*pi*t/0.4_s) - 0.9999))/2 + 3_N*(1 + sign(t - 0.13_s))");
    let speed = 50.0 * 2.0 * 0.4 / std::f64::consts::TAU * 0.9999_f64.acos();
    for step in ["--step=1e-3", "--step=2e-2", "--step=5e-2", "--step=0.2"] {
        let [x, u] = last(&[&model, step, "--seconds=0.2", "--method=rk4"], ["x", "u_x"]);
        let off = (x - 0.1 * speed - 3.0 * 0.07 * 0.07).abs().max((u - speed - 6.0 * 0.07).abs());
        assert!(off < 1e-11, "{step}: x = {x}, u = {u}");
    }
}

/// A spring is pulled by a bump of 30 ms; SciPy's DOP853 at 1e-12, cut at the bump's ends.
#[test]
fn a_bump_of_a_command_is_seen_whatever_the_rows() {
    let text = "format = 1\nname = \"bump\"\n[coordinates]\n\
                s = { unit = \"m\", closed_form = \"max(0, 2*(t - 0.30_s)*(0.33_s - t)*1_m/1_s/1_s)\" }\n\
                x = { unit = \"m\", independent = true }\n[points]\nP = \"x*N.x\"\n[bodies]\n\
                b = { centre = \"P\", mass = 1 }\n[forces]\n\
                f = { point = \"P\", force = \"-400_N/1_m*(x - s)*N.x\" }\n[run]\nseconds = 1\nstep = 1e-3\n\
                method = \"dormand-prince\"\n";
    let model = written("bump.toml", text);
    for every in ["--every=1", "--every=100", "--every=1000"] {
        let [x, u] = last(&[&model, every], ["x", "u_x"]);
        assert!((x - 1.6161e-4).abs() < 2e-8 && (u - 1.51048e-3).abs() < 3e-8, "{every}: {x}, {u}");
    }
}

/// sin(2 pi t/T) at t = 3 T is 0 but for rounding: its switch lies behind the end of a step by less than the last stage
/// of Runge's method, which saw the other side: 10 N for a sixth of a step.
#[test]
fn a_switch_at_the_end_of_a_step_but_for_rounding_is_at_its_end() {
    for (scalar, allowed) in [("--scalar=f64", 1e-12), ("--scalar=f32", 2e-5)] {
        let model = pushed("thirds", "5_N*sign(sin(2*pi*t/0.07_s)) + 3_N*max(0, sign(t - 0.07_s))");
        for step in ["--step=4e-3", "--step=2e-3", "--step=1e-3", "--step=5e-4"] {
            // Of 0.3 s the sine is positive in the first half of 0.07 s, four times, and in the last 20 ms.
            let [u] = last(&[&model, scalar, step, "--seconds=0.3", "--method=rk4"], ["u_x"]);
            assert!((u - (5.0 * 0.02 + 3.0 * 0.23)).abs() < allowed, "{scalar} {step}: {u}");
        }
    }
}

/// The accounts are in f64, the run's kinks are where f32 has them: powers were taken from the other side of a kink at
/// the end of a step. Closed form of both: c (A pi/T)^2/2.
#[test]
fn accounts_of_a_run_in_single_precision_are_of_the_sides_of_its_kinks() {
    let text = "format = 1\nname = \"hops\"\n[coordinates]\n\
                s = { unit = \"m\", closed_form = \"0.03_m*abs(sin(pi*t/0.05_s))\" }\n\
                x = { unit = \"m\", independent = true }\n[points]\nS = \"s*N.x\"\nP = \"x*N.x\"\n[bodies]\n\
                b = { centre = \"P\", mass = 1 }\nh = { centre = \"S\", mass = 1 }\n[forces]\n\
                d = { point = \"S\", force = \"-3_N*1_s/1_m*(u_s - 1_m/1_s)*N.x\" }\n[run]\nseconds = 1\n";
    let (model, work) = (written("hops.toml", text), 1.5 * (0.03 * std::f64::consts::PI / 0.05_f64).powi(2));
    for (scalar, allowed) in [("--scalar=f64", 2e-8_f64), ("--scalar=f32", 2e-4)] {
        for way in [&["--step=5e-3"][..], &["--step=1e-3"], &["--method=dormand-prince", "--tolerance=1e-6"]]
        {
            let allowed = if way.len() == 2 { allowed.max(2e-5) } else { allowed };
            let works = last(&[&[model.as_str(), scalar], way].concat(), ["damping", "drive"]);
            let off = works.map(|own| (own / work - 1.0).abs());
            assert!(off[0].max(off[1]) < allowed, "{scalar} {way:?}: {works:?} of {work} J");
        }
    }
}

/// Two columns had one name: readers took the energy for the coordinate.
/// Sixteen switches of a force that changes its sign: parabolas. The times that f32 gives to a switch, some 1e-5 s in
/// all, are part of the motion.
#[test]
fn single_precision_loses_no_time_at_switches() {
    let path = pushed("alternating", "4_N*sign(sin(25_rad/1_s*t))");
    let (mut x, mut u, mut t) = (0.0, 3.0, 0.0_f64);
    for half in 0..16 {
        let h = (f64::from(half + 1) * std::f64::consts::PI / 25.0).min(2.0) - t;
        let a = if half % 2 == 0 { 4.0 } else { -4.0 };
        x += u * h + 0.5 * a * h * h;
        u += a * h;
        t += h;
    }
    assert_eq!(t, 2.0);
    for way in ["--method=rk4", "--method=dormand-prince"] {
        for step in ["1e-2", "1e-3", "1e-4"] {
            for (scalar, near) in [("f32", 1e-5), ("f64", 1e-13)] {
                let run = [&path, "--set=u_x=3", "--seconds=2", way, "--step", step, "--scalar", scalar];
                let found: [f64; 2] = last(&run, ["x", "u_x"]);
                let off = (found[0] - x).abs().max((found[1] - u).abs());
                assert!(off < near, "{run:?}: {off:e}");
            }
        }
    }
}

#[test]
fn a_coordinate_named_like_an_energy_has_a_column_of_its_own() {
    let text = "format = 1\nname = \"spring\"\n[coordinates]\nspring = { unit = \"m\" }\n[points]\n\
                P = \"spring*N.x\"\n[bodies]\nb = { centre = \"P\", mass = 2 }\n[springs]\n\
                k = { coordinate = \"spring\", stiffness = \"50_N/1_m\", rest = 0.1 }\n[start]\nspring = 0.3\n\
                [run]\nseconds = 0.1\nstep = 1e-3\n";
    let model = written("named_spring.toml", text);
    let [place, energy] = last(&[&model], ["coordinate.spring", "spring"]);
    let stretch = 0.2 * 0.5_f64.cos();
    assert!((place - 0.1 - stretch).abs() < 1e-9 && (energy - 25.0 * stretch * stretch).abs() < 1e-8);
    let done = smartbed(&["run", &model, "--csv", "-"]);
    let header = done.out.lines().next().unwrap_or_default().to_owned();
    let mut names: Vec<&str> = header.split(',').collect();
    let all = names.len();
    names.sort_unstable();
    names.dedup();
    assert_eq!(names.len(), all, "{header}");
}

/// Pulses without any corner that could be located: steps of an adaptive method grow while nothing moves, and jumped over
/// them; every run of the calibration then missed them alike.
#[test]
fn a_smooth_pulse_is_seen_by_adaptive_steps() {
    let pulses = [
        (
            "ramps",
            "1000_N*(smooth_step(t - 0.75_s, 0.002_s) - smooth_step(t - 0.76_s, 0.002_s))",
            10.0,
            0.755,
        ),
        ("tanh", "1000_N*(tanh((t - 0.75_s)/0.001_s) - tanh((t - 0.76_s)/0.001_s))/2", 10.0, 0.755),
        ("bell", "1000_N*exp(-((t - 0.4321_s)/0.5e-3_s).powi(2))", 0.5 * std::f64::consts::PI.sqrt(), 0.4321),
    ];
    for (name, law, speed, middle) in pulses {
        let model = pushed(name, law);
        // By symmetry the momentum acts as if all at once in the middle.
        let place = speed * (1.0 - middle);
        for (way, most) in [
            (&["--method=dormand-prince", "--tolerance=1e-9"][..], 1e-6),
            (&["--method=dormand-prince", "--tolerance=1e-9", "--step=1e-2", "--every=100"], 1e-6),
            (&["--error=1e-5"], 1e-5),
        ] {
            let [x, u] = last(&[&[model.as_str()], way].concat(), ["x", "u_x"]);
            let off = [(x - place).abs(), (u - speed).abs()];
            assert!(
                off[0] < most && off[1] < 10.0 * most,
                "{name}, {way:?}: x = {x} for {place}, u = {u} for {speed}"
            );
        }
        let said = smartbed(&["run", &model, "--method=rk4", "--step=0.5"]);
        assert!(said.err.contains("changes and returns within a step near t = "), "{name}: {said:?}");
    }
}

/// A pulse and a bell of time as a load reads them: through a coordinate in closed form, a point, a velocity, axes, the
/// length of a vector. Each way of writing them once dropped them without a word.
#[test]
fn functions_of_time_are_seen_behind_names() {
    let model = |name: &str, value: &str, law: &str| {
        let text = format!(
            "format = 1\nname = \"{name}\"\n[coordinates]\ncam = {{ closed_form = \"3*t/1_s\" }}\n\
             x = {{ unit = \"m\", independent = true }}\n[frames]\nR = {{ parent = \"N\", rotations = [[\"z\", \"cam\"]] }}\n\
             [points]\nS = \"x*N.x\"\nC = \"1.5_m*t*t/1_s/1_s*N.y\"\nD = \"cam*1_m*N.y\"\n\
             [bodies]\nA = {{ centre = \"S\", mass = 1 }}\n[definitions]\nv = \"{value}\"\n\
             [forces]\nF = {{ point = \"S\", force = \"50_N*{law}*N.x\" }}\n[run]\nseconds = 1\nstep = 0.05\nevery = 20\n"
        );
        written(&format!("{name}.toml"), &text)
    };
    let read = [
        "cam",
        "dot(D, N.y)/1_m",
        "norm(velocity(C))*1_s/1_m",
        "atan2(dot(R.x, N.y), dot(R.x, N.x))",
        "dot(angular_velocity(R), N.z)*t",
        "norm((3*t/1_s)*N.x)",
    ];
    let laws = [
        ("(1 + sign(0.005 - abs(v - 1)))/2", 50.0 * 0.01 / 3.0, 1e-11),
        ("exp(-((v - 1)/0.003).powi(2))", 50.0 * 1e-3 * std::f64::consts::PI.sqrt(), 1e-6),
    ];
    for (number, value) in read.into_iter().enumerate() {
        for (law, speed, most) in laws {
            let model = model(&format!("behind_{number}"), value, law);
            let is_cut = most < 1e-10;
            let adaptive = ["--method=dormand-prince", "--tolerance=1e-9"];
            let fixed: &[&[&str]] = if is_cut { &[&["--method=rk4"], &["--error=1e-6"]] } else { &[] };
            for way in fixed.iter().copied().chain([&adaptive[..]]) {
                let [u] = last(&[&[model.as_str()], way].concat(), ["u_x"]);
                assert!((u - speed).abs() < most, "{value}, {law}, {way:?}: {u} for {speed}");
            }
            // A bell is not cut: fixed steps that hide it are warned of.
            let said = smartbed(&["run", &model, "--method=rk4"]);
            let hidden = said.err.contains("changes and returns within a step near t = 0.3");
            assert_eq!(hidden, !is_cut, "{value}, {law}: {said:?}");
        }
    }
}

/// A pivot that a point's place moves: it may not jump, and the drive gives its impulse where its speed does.
#[test]
fn places_that_read_places_switch_too() {
    let run = |name: &str, place: &str| {
        let text = format!(
            "format = 1\nname = \"{name}\"\ngravity = \"-9.81_m/1_s/1_s*N.z\"\n[coordinates]\nq = {{ unit = \"rad\" }}\n\
             [frames]\nrod = {{ parent = \"N\", rotations = [[\"y\", \"q\"]] }}\n[points]\nC = \"3_m*t/1_s*N.y\"\n\
             S = \"0.1_m*{place}*N.x\"\nP = \"S - 0.5_m*rod.z\"\n[bodies]\nA = {{ centre = \"P\", mass = 1 }}\n\
             [start]\nq = 0.2\n[run]\nseconds = 1\nstep = 1e-3\nevery = 200\n"
        );
        smartbed(&["run", "--json", &written(&format!("{name}.toml"), &text)])
    };
    let jumps = run("place_jumps", "sign(dot(C, N.y)/1_m - 1)");
    assert!(jumps.message().contains("the position of `S` jumps at t = 0.333333 s"), "{jumps:?}");
    let [through, of_time] =
        [("place_bends", "abs(dot(C, N.y)/1_m - 1)"), ("time_bends", "abs(3*t/1_s - 1)")].map(
            |(name, place)| {
                let done = run(name, place);
                assert_eq!(done.status, 0, "{done:?}");
                done.json()["last"]["q"].as_f64().expect("an angle")
            },
        );
    assert!((through - of_time).abs() < 1e-12 && (of_time + 0.005_626).abs() < 1e-6, "{through}, {of_time}");
}

/// The force turns over ever faster, at last twice within the step that is picked: the error holds for the run too.
#[test]
fn a_picked_step_is_searched_as_its_calibration_was() {
    let text = "format = 1\nname = \"chirp\"\n[coordinates]\nx = { unit = \"m\" }\n[points]\nP = \"x*N.x\"\n\
                [bodies]\na = { centre = \"P\", mass = 1 }\n[springs]\nk = { coordinate = \"x\", stiffness = 1 }\n\
                [forces]\nf = { point = \"P\", force = \"5_N*sign(sin(t*t/1_s/1_s))*N.x\" }\n\
                [run]\nseconds = 40\nstep = 1e-2\nevery = 100\n";
    let model = written("chirp.toml", text);
    // Between two turns the motion is a rotation about where the force holds it.
    let ([mut x, mut u], mut t, mut force) = ([0.0_f64; 2], 0.0_f64, 5.0_f64);
    for turn in 1.. {
        let end = (f64::from(turn) * std::f64::consts::PI).sqrt().min(40.0);
        let (s, c) = (end - t).sin_cos();
        (x, u) = (force + (x - force) * c + u * s, u * c - (x - force) * s);
        (t, force) = (end, -force);
        if t >= 40.0 {
            break;
        }
    }
    for way in [&["--error=1e-4"][..], &["--method=rk4", "--step=0.05", "--every=20"]] {
        let [own] = last(&[&[model.as_str()], way].concat(), ["x"]);
        assert!((own - x).abs() < 1e-4, "{way:?}: {own} for {x}");
    }
}

/// The references of a report take the steps of the scene where something depends on time.
#[test]
fn a_report_of_a_world_sees_a_smooth_pulse() {
    let law = "1000_N*(smooth_step(t - 0.75_s, 0.002_s) - smooth_step(t - 0.76_s, 0.002_s))";
    let model = pushed("world_ramps", law);
    let text = format!(
        "format = 2\n[parts.m]\nmechanism = \"{model}\"\nlaw = {{ F = \"{law}\" }}\n[run]\nseconds = 1\nstep = \"5_ms\"\n"
    );
    let world = written("world_of_ramps.toml", &text);
    // A run in steps that hide it is warned of, with the part's name; in shorter ones it is not.
    let warns = |step: &str| {
        let said = smartbed(&["run", &world, &format!("--step={step}")]);
        said.err.contains("law or command of `m` changes and returns within a step near t = 0.75")
    };
    assert!(warns("0.5") && !warns("0.001"));
    let done = smartbed(&["run", &world, "--error", "1e-4", "--json"]);
    assert_eq!(done.status, 0, "{done:?}");
    let x = done.json()["last"]["m.x"].as_f64().expect("a place");
    assert!((x - 2.45).abs() < 1e-4, "{x}");
}
