//! Mechanisms of which the scene commands some coordinates, or all.

use super::rigid::G;
use super::support::{fails, find, json, number, rows, scene, times};

/// The numbers of a column.
pub fn column((names, rows): &(Vec<String>, Vec<Vec<f64>>), name: &str) -> Vec<f64> {
    let at = names.iter().position(|own| own == name).unwrap_or_else(|| panic!("no column {name}"));
    rows.iter().map(|row| row[at]).collect()
}

/// Copies a model of the repository under a name that no other test gives to a file beside its scenes.
fn copied(name: &str) -> String {
    let own = format!("commanded_{name}");
    scene(&own, &std::fs::read_to_string(find(name).expect("a model")).expect("its text"));
    own
}

/// The upper rod of a double pendulum stands still as commanded: the lower one keeps its energy, that of a rod about
/// its end.
#[test]
fn one_coordinate_of_an_open_chain_is_commanded() {
    let text = "format = 2\n[parts.arm]\nmechanism = \"MODEL\"\ncommand = { q1 = \"0*t/1_s\" }\nset = { c = 0 }\n\
                start = { q2 = \"50_deg\" }\n[run]\nseconds = 1\n";
    let text = text.replace("MODEL", &copied("double_pendulum"));
    let rows = rows(&[&scene("open_chain", &text)]);
    let (m, l) = (0.8, 0.4);
    let energy = |q: f64, u: f64| 0.5 * (m * l * l / 3.0) * u * u - m * G * 0.5 * l * q.cos();
    let (q, u) = (column(&rows, "arm.q2"), column(&rows, "arm.u_q2"));
    assert!(q.iter().any(|q| *q < -0.5), "it swings through");
    for (q, u) in q.iter().zip(&u) {
        assert!((energy(*q, *u) - energy(q_start(), 0.0)).abs() < 1e-9, "{q} {u}");
    }
    assert!(column(&rows, "arm.q1").iter().all(|q| *q == 0.0));
}

fn q_start() -> f64 {
    50_f64.to_radians()
}

#[test]
fn commanded_coordinates_have_columns() {
    let model = copied("pendulum");
    let text = |sensor: &str| {
        format!(
            "format = 2\n[parts.arm]\nmechanism = \"{model}\"\ncommand = {{ q = \"0.2*sin(t/0.1_s)\" }}\n{sensor}[run]\nseconds = 0.1\n"
        )
    };
    let sensor = "[sensors.angle]\nof = \"arm.q\"\nunit = \"deg\"\n";
    let rows = rows(&[&scene("columns", &text(sensor))]);
    let seen = column(&rows, "sensors.angle");
    for ((t, q), seen) in column(&rows, "t").iter().zip(column(&rows, "arm.q")).zip(seen) {
        assert!((q - 0.2 * (10.0 * t).sin()).abs() < 1e-15 && q == seen, "{t}: {q} {seen}");
    }
}

#[test]
fn commands_that_are_not_finite_are_refused_by_name_and_time() {
    let model = copied("pendulum");
    // Infinite speed at the start; no speed there, but infinite acceleration; infinite speed later.
    for (law, time) in
        [("sqrt(t/1_s)", "0.000000"), ("sqrt(t/1_s)*t/1_s", "0.000000"), ("sqrt(0.01 - t/1_s)", "0.01")]
    {
        let text = format!(
            "format = 2\n[parts.arm]\nmechanism = \"{model}\"\ncommand = {{ q = \"{law}\" }}\n[run]\nseconds = 0.02\n"
        );
        let said = fails(&["run", &scene("infinite", &text), "--csv", "-"]);
        assert!(said.contains(&format!("t = {time}")), "{law}: {said}");
        assert!(said.contains("`arm` has an energy or a power that is not finite"), "{law}: {said}");
    }
}

/// A block of 2 kg on a slope of 0.5 rad that is commanded along x; its plate is the port `top`.
const WEDGE: &str = r#"
format = 1
name = "wedge"
gravity = "-g*N.z"
parameters = { g = { value = 9.81, unit = "m/s^2" }, k = { value = 200, unit = "N/m" } }
coordinates.s = { unit = "m", independent = true }
coordinates.r = { unit = "m", independent = true }
frames.slope = { rotations = [["y", -0.5]] }
points = { C = "s*N.x", B = "C + r*slope.x" }
bodies = { cart = { centre = "C", mass = "5_kg" }, block = { centre = "B", mass = "2_kg" } }
springs.holds = { coordinate = "r", stiffness = "k", rest = 0 }
ports.top = { point = "B", frame = "N" }
"#;

/// What stands or hangs on the commanded wedge.
fn on_wedge(name: &str, parts: &str) -> String {
    scene("wedge_model", WEDGE);
    let command = "command = { s = \"0.3_m*t/1_s + 0.05_m*sin(6*t/1_s)\" }\nstart = { r = \"-0.02_m\" }\n";
    let plate = "[parts.plate]\nrigid = \"box\"\nsize = [1, 1, 0.02]\non = \"cart.top\"\nstart = { position = [0, 0, -0.01] }\n";
    let run = "[run]\nseconds = 0.3\n";
    scene(
        name,
        &format!("format = 2\n[parts.cart]\nmechanism = \"wedge_model\"\n{command}{plate}{parts}{run}"),
    )
}

/// A ball that loses nothing strikes the block. By Newton's law for cart and block along x, and for the block along its
/// slope, the drive has the impulse -J sin a cos a.
#[test]
fn an_impact_on_a_mechanism_commanded_in_part_books_the_work_of_its_drive() {
    let ball = "[parts.ball]\nrigid = \"sphere\"\nradius = 0.05\nmass = 1.3\nstart = { height = 0.1, position = [0.1, 0, 0] }\n\
                [[contacts]]\nbetween = [\"ball\", \"plate\"]\nimpact = \"stronge\"\nrestitution = 1\n";
    let file = on_wedge("struck_wedge", ball);
    let done = json(&[&file]);
    assert!(number(&done["last"]["impact"]).abs() < 1e-12, "{}", done["last"]["impact"]);
    assert!(number(&done["imbalance"]).abs() < 2e-5, "{}", done["imbalance"]);
    let (time, impulse) = (times(&done)[0], number(&done["events"][0]["impulse"]));
    let work = -impulse * 0.5_f64.sin() * 0.5_f64.cos() * (0.3 + 0.3 * (6.0 * time).cos());
    let drive = column(&rows(&[&file]), "actuator");
    let (at, change) = ((time / 1e-3) as usize, |n: usize| drive[n + 1] - drive[n]);
    let jump = change(at) - 0.5 * (change(at - 1) + change(at + 1));
    assert!(work < -0.6 && (jump - work).abs() < 5e-3, "{jump} {work}");
}

/// Accounts close to order 2 under lasting contacts and mean forces.
#[test]
fn loads_on_a_mechanism_commanded_in_part_book_the_work_of_its_drive() {
    let slider = |law: &str| {
        format!(
            "[parts.block]\nrigid = \"box\"\nsize = [0.1, 0.1, 0.1]\nmass = 1.3\n\
             start = {{ height = -0.00958851, position = [0.1, 0, 0] }}\n\
             [[contacts]]\nbetween = [\"block\", \"plate\"]\nimpact = \"{law}\"\nfriction = 0.2\n"
        )
    };
    let rod = "[parts.rod]\npoints = [[0, 0, 0], [0.1, 0, -0.3]]\nsprings = [[0, 1]]\nmass = 0.7\nK = 300\n\
               attach = [{ nodes = [0], to = \"cart.top\" }]\n";
    // Largest imbalance (J), and the least factor by which half the step reduces it. Located steps count powers between
    // events to order 4, so that rounding is left.
    let worlds = [
        (on_wedge("plastic_wedge", &slider("plastic")), None, 2e-8, 0.0),
        (on_wedge("moreau_wedge", &slider("moreau")), None, 5e-5, 3.0),
        (on_wedge("mean_wedge", rod), Some("energy_momentum"), 5e-5, 3.0),
    ];
    for (file, method, largest, fall) in &worlds {
        let imbalance = |step: &str| {
            let method: Vec<&str> = method.iter().flat_map(|method| ["--method", method]).collect();
            let done = json(&[&[file, "--step", step][..], &method].concat());
            assert!(number(&done["last"]["actuator"]) < -1.0, "{file}: {}", done["last"]["actuator"]);
            number(&done["imbalance"]).abs()
        };
        let (coarse, fine) = (imbalance("2e-3"), imbalance("1e-3"));
        assert!(coarse < *largest && fine < *largest && fine * fall <= coarse, "{file}: {coarse:e} {fine:e}");
    }
}

/// A piston that starts from rest throws a ball of 1.3 kg.
struct Piston;

impl Piston {
    const W: f64 = 8.0 * std::f64::consts::PI;
    const T: f64 = 0.02;

    fn place(t: f64) -> f64 {
        0.2 + 0.05 * (Self::W * t).sin() - 0.05 * Self::W * t * (-t / Self::T).exp()
    }

    fn speed(t: f64) -> f64 {
        0.05 * Self::W * ((Self::W * t).cos() - (1.0 - t / Self::T) * (-t / Self::T).exp())
    }

    /// Force on the ball while it rests (N).
    fn force(t: f64) -> f64 {
        let fades = (2.0 - t / Self::T) / Self::T * (-t / Self::T).exp();
        1.3 * (G - 0.05 * Self::W * (Self::W * (Self::W * t).sin() - fades))
    }

    fn world() -> String {
        let model = "format = 1\nname = \"piston\"\ncoordinates.s = { unit = \"m\" }\npoints.C = \"s*N.z\"\n\
                     bodies.head = { centre = \"C\", mass = \"40_kg\" }\nports.top = { point = \"C\", frame = \"N\" }\n";
        scene("piston_model", model);
        let command = "0.2_m + 0.05_m*sin(8*pi*t/1_s) - 0.05_m*8*pi*t/1_s*exp(-t/0.02_s)";
        scene(
            "piston",
            &format!(
                "format = 2\n[parts.piston]\nmechanism = \"piston_model\"\ncommand = {{ s = \"{command}\" }}\n\
                 [parts.top]\nrigid = \"box\"\nsize = [0.3, 0.3, 0.02]\non = \"piston.top\"\nstart = {{ position = [0, 0, -0.01] }}\n\
                 [parts.ball]\nrigid = \"sphere\"\nradius = 0.05\nmass = 1.3\nstart = {{ height = 0.2 }}\n\
                 [[contacts]]\nbetween = [\"ball\", \"top\"]\nimpact = \"plastic\"\nfriction = 0.3\n\
                 [run]\nseconds = 0.5\nmethod = \"rk4\"\n"
            ),
        )
    }
}

/// The zero of a function that falls from `low` to `high`.
fn falls(mut low: f64, mut high: f64, of: impl Fn(f64) -> f64) -> f64 {
    for _ in 0..100 {
        let middle = 0.5 * (low + high);
        if of(middle) > 0.0 { low = middle } else { high = middle }
    }
    low
}

#[test]
fn a_thrown_ball_leaves_its_piston_when_the_force_passes_zero() {
    let leaves = falls(0.02, 0.035, Piston::force);
    let flown = |t: f64| {
        let late = t - leaves;
        Piston::place(leaves) + Piston::speed(leaves) * late - 0.5 * G * late * late
    };
    let lands = falls(0.2, 0.3, |t| flown(t) - Piston::place(t));
    let file = Piston::world();
    for step in ["4e-3", "1e-3", "7e-4"] {
        let done = json(&[&file, "--step", step]);
        let struck = times(&done)[0];
        assert!((struck - lands).abs() < 1e-9, "{step}: {struck} {lands}");
    }
}

#[test]
fn rows_show_the_force_of_a_located_contact_at_their_time() {
    let rows = rows(&[&Piston::world(), "--seconds", "0.04"]);
    for (t, force) in column(&rows, "t").into_iter().zip(column(&rows, "ball-top.normal")) {
        let expected = Piston::force(t).max(0.0);
        assert!((force - expected).abs() < 1e-6, "{t}: {force} {expected}");
    }
}

/// A plate that stands until `at` and then rises at 2 m/s, with a ball on it.
fn kicked(name: &str, at: f64, law: &str) -> String {
    Piston::world();
    scene(
        name,
        &format!(
            "format = 2\n[parts.piston]\nmechanism = \"piston_model\"\n\
             command = {{ s = \"0.2_m + 1_m*(t/1_s - {at} + abs(t/1_s - {at}))\" }}\n\
             [parts.top]\nrigid = \"box\"\nsize = [0.3, 0.3, 0.02]\non = \"piston.top\"\nstart = {{ position = [0, 0, -0.01] }}\n\
             [parts.ball]\nrigid = \"sphere\"\nradius = 0.05\nmass = 1.3\nstart = {{ height = 0.2 }}\n\
             [[contacts]]\nbetween = [\"ball\", \"top\"]\n{law}\n[run]\nseconds = 0.131\nstep = \"1_ms\"\n"
        ),
    )
}

/// The ball is struck by the speed that the plate has after the kink, wherever in a step that is.
#[test]
fn a_plate_whose_commanded_speed_jumps_strikes_what_lies_on_it() {
    let laws = [
        ("impact = \"plastic\"", 0.0, 1e-12),
        ("impact = \"stronge\"\nrestitution = 0.5", 0.5, 1e-12),
        ("impact = \"compensation\"\nshare = 0.25", 0.5, 1e-12),
        // Of order 1: a step treats the impact as if at its end.
        ("impact = \"moreau\"\nrestitution = 0.5", 0.5, 2e-3),
    ];
    for at in [0.1003, 0.1, 0.0] {
        for (law, e, within) in laws {
            let rows = rows(&[&kicked("kicked", at, law)]);
            let (speed, late) = (2.0 * (1.0 + e), 0.131 - at);
            let falls = if e > 0.0 { 0.5 * G * late * late } else { 0.0 };
            let height = column(&rows, "ball.z").pop().expect("a row");
            assert!(
                (height - (0.25 + speed * late - falls)).abs() < within * late / 0.0307,
                "{at} {law}: {height}"
            );
            let lost = column(&rows, "imbalance").pop().expect("a row");
            assert!(lost.abs() < 1e-9, "{at} {law}: {lost} J in no account");
        }
    }
}

/// A plate that drops faster than things fall leaves its ball behind, and catches none when it stops below it.
#[test]
fn a_plate_that_drops_at_once_leaves_its_ball_behind() {
    let falls = |t: f64| 0.25 - 0.5 * G * t * t;
    let command = "0.2_m - 2_m*max(0, t/1_s - 0.0503)";
    for law in ["plastic", "moreau"] {
        let text = std::fs::read_to_string(kicked("dropped", 0.0, &format!("impact = \"{law}\"")))
            .expect("the scene");
        let (start, end) =
            (text.find("command").expect("a command"), text.find("[parts.top]").expect("a plate"));
        let text = format!("{}command = {{ s = \"{command}\" }}\n{}", &text[..start], &text[end..]);
        let rows = rows(&[&scene("dropped", &text)]);
        for (t, height) in column(&rows, "t").into_iter().zip(column(&rows, "ball.z")) {
            let expected = falls((t - 0.0503).max(0.0));
            assert!((height - expected).abs() < 1e-12, "{law} at {t}: {height} {expected}");
        }
    }
}

/// The drive's impulse on the cart leaves the block's momentum along its slope: m (r' + s' cos a).
#[test]
fn what_is_free_beside_a_commanded_kink_keeps_its_momentum() {
    let text = std::fs::read_to_string(on_wedge("kinked_wedge", "")).expect("the scene");
    let command = "0.3_m*t/1_s + 0.05_m*sin(6*t/1_s)";
    let text =
        text.replace(command, "0.3_m*max(0, t/1_s - 0.0503)").replace("seconds = 0.3", "seconds = 0.05031");
    let rows = rows(&[&scene("kinked_wedge", &text.replace("-0.02_m", "-0.0470300261_m"))]);
    let (before, after) = (column(&rows, "cart.u_r"), column(&rows, "imbalance"));
    let speed = before.last().expect("a row");
    assert!((speed + 0.3 * 0.5_f64.cos()).abs() < 1e-5, "{speed}");
    assert!(after.last().expect("a row").abs() < 1e-7, "{after:?}");
}

#[test]
fn a_command_whose_value_jumps_is_refused_by_name_and_time() {
    let text = std::fs::read_to_string(kicked("leaps", 0.0, "impact = \"moreau\"")).expect("the scene");
    let text = text.replace("0.2_m + 1_m*(t/1_s - 0 + abs(t/1_s - 0))", "0.2_m + 0.1_m*sign(t/1_s - 0.0503)");
    let said = fails(&["run", &scene("leaps", &text), "--csv", "-"]);
    assert!(said.contains("the command of `piston.s` jumps at t = 0.0503"), "{said}");
    // Angles between half a turn back and ahead: a saw.
    let saw = "0.02_m*atan2(sin(20_Hz*t), cos(20_Hz*t))";
    let said = fails(&["run", &pole("saw", saw, "seconds = 0.2\nstep = \"1_ms\"")]);
    assert!(said.contains("the command of `m.x` jumps at t = 0.157080 s"), "{said}");
    let said = fails(&["run", &hung("place", "", "0.1_m*sign(t - 0.1_s)*N.x", "")]);
    assert!(said.contains("the position of `hung.A` jumps at t = 0.1000"), "{said}");
}

/// A scene of one mechanism, a bob on a rod whose upper end A moves along x.
fn hung(name: &str, x: &str, a: &str, more: &str) -> String {
    let model = format!(
        "format = 1\nname = \"hung\"\ngravity = \"-g*N.y\"\n[parameters]\ng = {{ value = 9.81, unit = \"m/s^2\" }}\n\
         [coordinates]\nq = {{ unit = \"rad\", independent = true }}\n{x}\n[frames]\nrod = {{ rotations = [[\"z\", \"q\"]] }}\n\
         [points]\nA = \"{a}\"\nP = \"A - 0.5_m*rod.y\"\n[bodies]\nbob = {{ centre = \"P\", mass = \"1_kg\" }}\n{more}\n\
         [start]\nq = 0.3\n"
    );
    scene(&format!("hung_{name}_model"), &model);
    let run = "seconds = 0.3\nstep = \"1_ms\"";
    scene(
        &format!("hung_{name}"),
        &format!("format = 2\n[parts.hung]\nmechanism = \"hung_{name}_model\"\n[run]\n{run}\n"),
    )
}

/// Whether a coordinate in closed form, the position or a constraint has the kink, the drive's impulse is the same.
#[test]
fn a_kink_of_the_motion_acts_alike_in_a_world() {
    let form = "x = { unit = \"m\", closed_form = \"0.7_m/1_s*abs(t - 0.1003_s)\" }";
    let follows = "x = { unit = \"m\", nominal = 0.07, speed = { independent = false } }";
    let motion = "[constraints.motion]\nd = \"u_x - 0.7_m/1_s*sign(t - 0.1003_s)\"";
    let last = |file: String| {
        let last = json(&[&file])["last"].clone();
        ["hung.q", "hung.u_q", "actuator", "imbalance"].map(|name| number(&last[name]))
    };
    let expected = last(hung("closed", form, "x*N.x", ""));
    for file in [
        hung("position", "", "0.7_m/1_s*abs(t - 0.1003_s)*N.x", ""),
        hung("motion", follows, "x*N.x", motion),
    ] {
        let found = last(file);
        let off = found.iter().zip(expected).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
        assert!(off < 1e-10, "{found:?} {expected:?}");
    }
}

/// A pole on a cart that moves as commanded, without gravity; the cart weighs 1 kg, the pole hangs on it.
fn pole(name: &str, command: &str, run: &str) -> String {
    let set = "k_angle = 0, k_rate = 0, k_place = 0, k_speed = 0";
    let part = format!(
        "mechanism = \"cart_pole\"\nset = {{ {set} }}\ncommand = {{ x = \"{command}\" }}\nstart = {{ q = 0 }}"
    );
    scene(name, &format!("format = 2\n[parts.m]\n{part}\n[run]\n{run}\n"))
}

/// From time 0 on all of them are the same function: nothing is struck.
#[test]
fn a_command_with_a_kink_at_the_start_moves_as_from_then_on() {
    let run = "seconds = 0.05\nstep = \"1_ms\"";
    let smooth = rows(&[&pole("from_start_0", "0.5_m/1_s*t", run)]);
    for (n, command) in
        ["0.5_m/1_s*max(t, 0)", "0.5_m/1_s*abs(t)", "0.5_m*max(t/1_s, -t/1_s)"].iter().enumerate()
    {
        for more in [vec![], vec!["--method", "verlet"], vec!["--scalar", "f32"]] {
            let file = pole(&format!("from_start_{}", n + 1), command, run);
            let least = if more.contains(&"f32") { 1e-6 } else { 1e-14 };
            let found = rows(&[&[file.as_str()], &more[..]].concat());
            for name in ["m.q", "m.u_q", "m.x", "kinetic", "actuator"] {
                let pairs = column(&found, name).into_iter().zip(column(&smooth, name));
                let off = pairs.map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
                assert!(off < least, "{command}, {more:?}: {name} differs by {off}");
            }
        }
    }
    let scenes = find("scenes/tile_with_bladder").expect("a scene");
    let bladder = std::fs::read_to_string(scenes).expect("its text");
    let own = "heave = \"0.005_m*(1 - cos(2*pi*t/1_s))\"";
    assert!(bladder.contains(own));
    let kinked = bladder.replace(own, "heave = \"0.1_m/1_s*abs(t)\"") + "start = \"settled\"\n";
    let said = fails(&["run", &scene("from_start_settled", &kinked)]);
    assert!(said.contains("moves as commanded at the start"), "{said}");
}

/// The cart turns round within nothing: u_q = -m l/2 dv/I = -2.5 1/s; the drive's impulse does no work.
#[test]
fn a_row_at_the_time_of_a_kink_shows_the_motion_behind_it() {
    for method in ["rk4", "verlet", "energy_momentum"] {
        let run = format!("seconds = 0.25\nstep = 0.00390625\nmethod = \"{method}\"");
        let found = rows(&[&pole(&format!("at_row_{method}"), "0.5_m/1_s*abs(t - 0.25_s)", &run)]);
        let last = |name: &str| *column(&found, name).last().expect("a row");
        let off = [last("m.u_q") + 2.5, last("kinetic") - 0.15, last("actuator"), last("imbalance")];
        assert!(off.iter().all(|off| off.abs() < 1e-12), "{method}: {off:?}");
    }
}

/// A mass on a damped spring, whose force turns round within a step: errors fall by 2^4 when the step is halved.
#[test]
fn a_law_that_jumps_at_a_time_keeps_the_order_of_the_method() {
    let point = "[points]\nP = \"x*N.x\"\n[bodies]\nb = { centre = \"P\", mass = \"0.5_kg\" }\n";
    let spring = "stiffness = \"200_N/1_m\", rest_length = 0, damping = \"8_N*1_s/1_m\"";
    let loads = |force: &str| {
        format!(
            "[springs]\ns = {{ between = [\"P\", \"O\"], {spring} }}\n[forces]\nf = {{ point = \"P\", force = \"({force})*N.x\" }}\n"
        )
    };
    let inputs = "[inputs]\nF = { unit = \"N\" }\n[coordinates]\nx = { unit = \"m\" }\n";
    let jump = "5_N*sign(t - 0.2003_s)";
    for (name, force, law) in
        [("by_law", "F", format!("law = {{ F = \"{jump}\" }}\n")), ("by_load", jump, String::new())]
    {
        scene(
            &format!("jumps_{name}_model"),
            &format!("format = 1\nname = \"jumps\"\n{inputs}{point}{}", loads(force)),
        );
        let part = format!("[parts.m]\nmechanism = \"jumps_{name}_model\"\nstart = {{ x = 0.1 }}\n{law}");
        let file = scene(
            &format!("jumps_{name}"),
            &format!("format = 2\ngravity = [0, 0, 0]\n{part}[run]\nseconds = 0.4\n"),
        );
        let at = |step: &str| number(&json(&[&file, "--step", step])["last"]["m.x"]);
        let exact = at("1e-5");
        let [coarse, fine] = ["2e-3", "1e-3"].map(|step| (at(step) - exact).abs());
        assert!(fine < 1e-10 && coarse > 12.0 * fine, "{name}: {coarse} {fine}");
    }
}

/// What dry friction holds creeps, since its force reverses within a few steps again and again.
#[test]
fn dry_friction_that_chatters_in_a_world_is_told_of() {
    let sliding = |name: &str, friction: &str| {
        let model = format!(
            "format = 1\nname = \"sliding\"\n[coordinates]\nx = {{ unit = \"m\" }}\n[points]\nP = \"x*N.x\"\n\
             [bodies]\nb = {{ centre = \"P\", mass = 2 }}\n\
             [forces]\nfr = {{ point = \"P\", force = \"-6_N*{friction}*N.x\" }}\n\
             [springs]\ns = {{ coordinate = \"x\", stiffness = 50, rest = 0 }}\n[start]\nx = 1\n"
        );
        scene(&format!("chatters_{name}_model"), &model);
        // Two parts that are apart are stepped each for itself.
        let part = |part: &str| format!("[parts.{part}]\nmechanism = \"chatters_{name}_model\"\n");
        let parts = [part("block"), part("other")].concat();
        scene(&format!("chatters_{name}"), &format!("format = 2\n{parts}[run]\nseconds = 3\nstep = 1e-3\n"))
    };
    let warned = |file: &str, more: &[&str]| json(&[&[file], more].concat())["warnings"].to_string();
    let rough = sliding("rough", "sign(u_x)");
    let said = warned(&rough, &[]);
    for part in ["block", "other"] {
        assert!(said.contains(&format!("in `fr` of `{part}` changed again and again")), "{said}");
    }
    // While it slides nothing chatters; a smooth law never does.
    assert_eq!(warned(&rough, &["--seconds", "1"]), "[]");
    assert_eq!(warned(&sliding("smooth", "tanh(u_x/0.01_m*1_s)"), &[]), "[]");
}
