//! Lines of gas and controllers.

use super::support::{self, fails, json, number};

const R: f64 = 287.05;
const ROOM: f64 = 293.15;
const AMBIENT: f64 = 101_325.0;
/// rho_0 of ISO 6358 (kg/m^3).
const DENSITY: f64 = 1.185;

/// A scene in a file of its own.
fn scene(name: &str, text: &str) -> String {
    support::scene(&format!("air_{name}"), &format!("format = 2\n{text}"))
}

/// A litre that cannot move.
fn litre(gas: &str) -> String {
    format!(
        "gravity = [0, 0, 0]\n[parts.box]\nshape = \"cube\"\nside = \"0.1_m\"\nmass = \"1_kg\"\nK = \"1 kN/m\"\n\
         fixed = [0, 1, 2, 3, 4, 5, 6, 7]\ngas = {{ sealed = true, {gas} }}\n[run]\nseconds = 0.05\nstep = \"1_ms\"\n"
    )
}

#[test]
fn a_fixed_volume_fills_as_choked_flow_says() {
    let line = "supply = { gauge = \"500_kPa\", conductance = \"1e-8 m^3/(s Pa)\", opening = 1 }";
    let done = json(&[&scene("fill", &litre(&format!("gauge = 0, {line}")))]);
    // Choked: m' = C rho_0 p_1; n = gamma: V p' = gamma R T_in m'.
    let mass = 1e-8 * DENSITY * (AMBIENT + 500e3) * 0.05;
    let gauge = 1.4 * R * ROOM * mass / 1e-3;
    let last = |name: &str| number(&done["last"][format!("box.{name}")]);
    assert!((last("gauge") / gauge - 1.0).abs() < 1e-9, "{} {gauge}", last("gauge"));
    let whole = mass + AMBIENT * 1e-3 / (R * ROOM);
    assert!((last("gas_mass") / whole - 1.0).abs() < 1e-9);
    assert!(last("heat").abs() < 1e-9, "n = gamma takes no heat: {}", last("heat"));
}

/// A facet of four corners that are not in a plane is bilinear, from whichever corner it is listed: the gas starts with
/// the pressure that it is given.
#[test]
fn gas_behind_a_twisted_facet_starts_at_its_pressure() {
    for top in ["[4, 5, 6, 7]", "[5, 6, 7, 4]"] {
        let text = format!(
            "gravity = [0, 0, 0]\n[parts.c]\n\
             points = [[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0], [0, 0, 1], [1, 0, 1], [1, 1, 2], [0, 1, 1]]\n\
             facets = [[3, 2, 1, 0], {top}, [0, 1, 5, 4], [1, 2, 6, 5], [2, 3, 7, 6], [3, 0, 4, 7]]\n\
             fixed = [0, 1, 2, 3, 4, 5, 6, 7]\nmass = 1\ngas = {{ gauge = 1000, sealed = true }}\n[run]\nseconds = 0.01\n"
        );
        let last = &json(&[&scene("twisted", &text)])["last"];
        let [gauge, temperature] = ["gauge", "temperature"].map(|name| number(&last[format!("c.{name}")]));
        assert!(
            (gauge - 1000.0).abs() < 1e-6 && (temperature - ROOM).abs() < 1e-9,
            "{top}: {gauge} {temperature}"
        );
    }
}

#[test]
fn a_fixed_volume_blows_down_isothermally_and_books_its_heat() {
    let line = "vent = { conductance = \"1e-8 m^3/(s Pa)\", opening = 0.5 }";
    let done = json(&[&scene("vent", &litre(&format!("gauge = \"400_kPa\", exponent = 1, {line}")))]);
    let last = |name: &str| number(&done["last"][format!("box.{name}")]);
    // Choked, T = T_0: p' = -(R T/V) C rho_0 p/2.
    let rate = R * ROOM / 1e-3 * 0.5e-8 * DENSITY;
    let pressure = (AMBIENT + 400e3) * (-rate * 0.05).exp();
    assert!((last("gauge") / (pressure - AMBIENT) - 1.0).abs() < 1e-7, "{} {pressure}", last("gauge"));
    assert!((last("temperature") / ROOM - 1.0).abs() < 1e-9);
    // The gas that left took c_p T each kg, what is left keeps c_v T: heat R T for each kg that left.
    let left = (AMBIENT + 400e3) * 1e-3 / (R * ROOM) - last("gas_mass");
    assert!((last("heat") / (R * ROOM * left) - 1.0).abs() < 1e-7, "{}", last("heat"));
}

/// A bladder on the ground with supply and vent.
const BLADDER: &str = "[parts.ground]\nrigid = \"half_space\"\n[parts.bladder]\nshape = \"sheet\"\nrows = 5\ncolumns = 5\n\
    width = \"0.28_m\"\ndepth = \"0.28_m\"\nbase = \"40_mm\"\nmass = \"50_g\"\nK = \"2 kN/m\"\nC = \"2 N s/m\"\nair_drag = \"0.2 N s/m\"\n\
    start = { position = [0, 0, \"40_mm\"] }\n\
    gas = { gauge = \"1_kPa\", sealed = true, exponent = 1.2, supply = { gauge = \"30_kPa\", conductance = \"2e-8 m^3/(s Pa)\" }, \
    vent = { conductance = \"4e-8 m^3/(s Pa)\" } }\n\
    attach = [{ nodes = \"rim\", to = \"ground\" }, { facets = \"base\", to = \"ground\" }]\n";

#[test]
fn flow_beside_motion_is_of_order_two_and_the_accounts_close() {
    let run = |step: &str| {
        let text = format!("{BLADDER}[run]\nseconds = 0.1\nstep = {step}\n");
        let open = "parts.bladder.gas.supply.opening=1";
        let done = json(&[&scene("order", &text), "--step", step, "--set", open]);
        let last = |name: &str| number(&done["last"][format!("bladder.{name}")]);
        assert!(number(&done["last"]["actuator"]) < 0.0, "gas that flows in lowers its potential");
        ([last("gauge"), last("top")], number(&done["imbalance"]), number(&done["last"]["actuator"]))
    };
    let [a, b, c] = ["2.5e-4", "1.25e-4", "6.25e-5"].map(run);
    for k in 0..2 {
        let fall = (a.0[k] - b.0[k]) / (b.0[k] - c.0[k]);
        assert!((3.3..4.8).contains(&fall), "{fall}: {:?} {:?} {:?}", a.0, b.0, c.0);
    }
    assert!(c.1.abs() < 1e-5 * c.2.abs(), "{} of {}", c.1, c.2);
}

/// A controller of the bladder's pressure.
const HELD: &str = "[sensors.pressure]\nof = \"bladder.gauge\"\nkind = \"pressure\"\nunit = \"Pa\"\nlag = \"1_ms\"\n\
    [controllers.air]\nreads = \"sensors.pressure\"\ndrives = \"bladder.valves\"\nunit = \"Pa\"\nperiod = \"5_ms\"\n\
    target = [[0, \"2_kPa\"], [\"3_s\", \"1.5_kPa\"]]\ngain = 5e-3\nintegral = 2e-3\nlimits = [-1, 1]\n";

#[test]
fn a_controller_holds_a_bladder_at_its_pressures() {
    let text = format!("{BLADDER}{HELD}[run]\nseconds = 1\nstep = \"0.5_ms\"\n");
    let file = scene("held", &text);
    let gauge = |seconds: &str| number(&json(&[&file, "--seconds", seconds])["last"]["bladder.gauge"]);
    for (seconds, target) in [("2.995", 2e3), ("6", 1.5e3)] {
        let found = gauge(seconds);
        assert!((found / target - 1.0).abs() < 0.01, "{found} at {seconds} s");
    }
    // The same run, the same bits.
    assert_eq!(gauge("0.2").to_bits(), gauge("0.2").to_bits());
}

#[test]
fn a_held_input_is_what_a_law_of_that_value_is() {
    let run = |name: &str, given: &str| {
        let text = format!(
            "[parts.arm]\nmechanism = \"double_pendulum\"\n{given}\n[run]\nseconds = 0.5\nstep = \"1_ms\"\n"
        );
        let done = json(&[&scene(name, &text)]);
        ["arm.q1", "arm.q2"].map(|q| number(&done["last"][q]).to_bits())
    };
    let held = "[controllers.hold]\nreads = \"arm.q1\"\ndrives = \"arm.T\"\ntarget = 0\nperiod = \"10_ms\"\nbias = 0.3\n";
    assert_eq!(run("held_input", held), run("law", "law = { T = 0.3 }"));
    assert_ne!(run("held_input", held), run("free", ""));
    // An integral that would pass its limit within one sample goes up to it; it was left where it was, at 0 for ever.
    let wound = "[controllers.hold]\nreads = \"arm.q1\"\ndrives = \"arm.T\"\ntarget = 100\nperiod = \"10_ms\"\n\
                 integral = 1e3\nlimits = [-0.2, 0.3]\n";
    assert_eq!(run("wound", wound), run("law", "law = { T = 0.3 }"));
    assert_eq!(run("unwound", &wound.replace("100", "-100")), run("law", "law = { T = -0.2 }"));
}

/// What a membrane feels of a swinging angle, at steps of half its lag and a tenth of that: it lagged half a step less.
#[test]
fn a_membrane_lags_as_long_whatever_the_step() {
    let felt = |step: &str| {
        let text = format!(
            "[parts.arm]\nmechanism = \"double_pendulum\"\n[sensors.felt]\nof = \"arm.q1\"\nkind = \"pressure\"\n\
             lag = \"20_ms\"\n[run]\nseconds = 0.5\nstep = \"{step}\"\n"
        );
        let done = json(&[&scene(&format!("membrane_{step}"), &text)]);
        ["sensors.felt", "arm.q1", "arm.u_q1"].map(|name| number(&done["last"][name]))
    };
    let ([coarse, ..], [fine, q, u]) = (felt("10_ms"), felt("1_ms"));
    assert!((coarse - fine).abs() < 2e-3 * u.abs() * 20e-3, "{coarse} {fine}");
    assert!((q - fine - 20e-3 * u).abs() < 0.3 * (20e-3 * u).abs(), "it lags: {q} {fine} {u}");
}

/// A noisy sensor that is read late, and sampled at times of its own.
fn sampled() -> String {
    let held = HELD.replace(
        "lag = \"1_ms\"",
        "lag = \"1_ms\"\nnoise = \"5_Pa\"\nperiod = \"5_ms\"\ndelay = \"5_ms\"\nseed = 3",
    );
    format!(
        "{BLADDER}{held}[sensors.top]\nof = \"bladder.top\"\nkind = \"switch\"\nunit = \"m\"\ncloses = \"0_m\"\nchatter = \"3_ms\"\n"
    )
}

#[test]
fn a_controlled_run_that_is_resumed_goes_on_bit_for_bit() {
    let file = scene("resumed", &format!("{}[run]\nseconds = 0.4\nstep = \"0.5_ms\"\n", sampled()));
    let saved =
        std::path::Path::new(env!("CARGO_TARGET_TMPDIR")).join("air_resumed.state").display().to_string();
    let whole = json(&[&file]);
    // Within a period, with a reading on its way.
    for seconds in ["0.1015", "0.25"] {
        json(&[&file, "--seconds", seconds, "--save", &saved]);
        let resumed = json(&[&file, "--resume", &saved]);
        assert_eq!(whole["last"], resumed["last"], "from {seconds} s");
    }
}

#[test]
fn a_controlled_world_is_as_exact_as_asked() {
    let file = scene("exact", &format!("{}[run]\nseconds = 0.1\nstep = \"0.5_ms\"\n", sampled()));
    let places = |arguments: &[&str]| {
        let done = json(&[&[&file as &str], arguments].concat());
        let last = |k: usize| number(&done["last"][format!("bladder.z{k}")]);
        ((0..25).map(last).collect::<Vec<_>>(), number(&done["steps"]))
    };
    let (fine, _) = places(&["--method", "rk4", "--step", "1e-5"]);
    for error in [1e-4, 1e-6] {
        let (picked, steps) = places(&["--error", &error.to_string()]);
        let apart = picked.iter().zip(&fine).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
        println!("asked for {error:e}: {apart:e} with {steps} steps");
        assert!(apart <= error, "{error:e}: {apart:e}");
        // Periods stay whole numbers of steps.
        assert!((steps / 200.0).fract() == 0.0, "{steps}");
    }
}

#[test]
fn what_controllers_and_lines_cannot_do_is_refused_by_name() {
    let text = format!("{BLADDER}{HELD}[run]\nseconds = 0.1\nstep = \"0.5_ms\"\n");
    let file = scene("refused", &text);
    let says = |arguments: &[&str], words: &str| {
        let said = fails(&[&["run", &file], arguments].concat());
        assert!(said.contains(words), "{arguments:?}: {said}");
    };
    says(&["--set", "controllers.air.drives=bladder.valve"], "did you mean `bladder.valves`?");
    says(&["--set", "controllers.air.reads=bladder.gage"], "did you mean `bladder.gauge`?");
    says(&["--set", "controllers.air.period=\"0.7_ms\""], "is no whole number of steps");
    says(&["--set", "controllers.air.target=[[1, 2]]"], "must begin with 0 and rise");
    says(&["--set", "controllers.air.limits=[1, -1]"], "the least output, then the largest");
    says(&["--error", "1e-3"], "a controller reads sensors.pressure, which samples or chatters by steps");
    let switch = "period = \"5_ms\"\nkind = \"switch\"\ncloses = \"1_Pa\"\nchatter = \"5_ms\"";
    let chatters = HELD.replace("kind = \"pressure\"", switch).replace("lag = \"1_ms\"\n", "");
    let chatters =
        scene("chatters", &format!("{BLADDER}{chatters}[run]\nseconds = 0.1\nstep = \"0.5_ms\"\n"));
    let said = fails(&["run", &chatters, "--error", "1e-3"]);
    assert!(said.contains("chatters by steps"), "{said}");
    let other =
        "controllers.other={ reads = \"bladder.top\", drives = \"bladder.vent\", target = 0, period = 0.01 }";
    says(&["--set", other], "is driven by controllers.air already");
    says(&["--set", "parts.bladder.gas.supply.conductance=\"2_kg\""], "conductance");
    says(&["--set", "parts.bladder.gas.supply.critical_ratio=1"], "must be below 1");
    says(&["--set", "parts.bladder.gas.supply.gauge=\"-200_kPa\""], "the supply has no pressure");
    let wide = ["--set", "parts.bladder.gas.vent={ conductance = 1000 }"];
    says(
        &["--set", "parts.bladder.gas.supply.opening=0.5"],
        "it drives `bladder.valves`, so that `opening` has no effect",
    );
    says(
        &[&wide[..], &["--set", "controllers.air.limits=[-1, -0.5]"]].concat(),
        "could adapt to that of a line",
    );
    let saved =
        std::path::Path::new(env!("CARGO_TARGET_TMPDIR")).join("air_saved.state").display().to_string();
    super::support::run(&["run", &file, "--seconds", "0.05", "--save", &saved]);
    let blind = scene("blind", &format!("{BLADDER}[run]\nseconds = 0.1\nstep = \"0.5_ms\"\n"));
    assert!(fails(&["run", &blind, "--resume", &saved]).contains("belongs to another scene"));
    // Gas that keeps its pressure has no lines.
    says(&["--set", "parts.bladder.gas.sealed=false"], "supply");
    let chip = fails(&["firmware", &file]);
    assert!(chip.contains("without lines of gas and controllers"), "{chip}");
}

/// Two points on a spring without load fly through air: their velocity falls by exp(-c t/m), and all they lose is drag.
#[test]
fn drag_is_an_account_of_its_own() {
    let (mass, drag, speed, seconds) = (0.1_f64, 0.02_f64, 3.0_f64, 0.2_f64);
    let pair = "gravity = [0, 0, 0]\n[parts.pair]\npoints = [[0, 0, 0], [0.1, 0, 0]]\nsprings = [[0, 1]]\nmass = 0.05\nK = 500\n\
                C = 0.3\nair_drag = 0.02\nstart = { velocity = [3, 0, 0], position = [0, 0, 1] }\n";
    let ground = "[parts.ground]\nrigid = \"half_space\"\n[[contacts]]\nbetween = [\"pair\", \"ground\"]\nimpact = \"LAW\"\n";
    let start = 0.5 * mass * speed * speed;
    let lost = start * (1.0 - (-2.0 * drag * seconds / (mass / 2.0)).exp());
    let contacts = [(String::new(), ["rk4", "verlet", "energy_momentum"])]
        .into_iter()
        .chain(["plastic"].map(|law| (ground.replace("LAW", law), ["rk4", "verlet", "verlet"])))
        .chain(["moreau"].map(|law| (ground.replace("LAW", law), ["moreau"; 3])));
    for (n, (contact, methods)) in contacts.enumerate() {
        for method in methods {
            let run = format!("[run]\nseconds = {seconds}\nstep = 0.0005\nmethod = \"{method}\"\n");
            let file = scene(&format!("drag_{n}_{method}"), &format!("{pair}{contact}{run}"));
            let done = json(&[&file]);
            let [seen, damping, imbalance] =
                ["drag", "damping", "imbalance"].map(|name| number(&done["last"][name]));
            assert!((seen - lost).abs() < 1e-4 * lost, "{n}, {method}: {seen} is not {lost}");
            assert!(
                damping.abs() < 1e-9 && imbalance.abs() < 1e-4 * lost,
                "{n}, {method}: {damping} {imbalance}"
            );
        }
    }
}
