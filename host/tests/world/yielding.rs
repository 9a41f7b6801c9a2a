//! Pairs with force laws: closed forms, order of every method, accounts, rest, limits, refusals.

use super::accounts;
use super::support::{fails, json, number, scene, settled};

const PI: f64 = std::f64::consts::PI;

/// Two balls without weight that meet at 1 m/s.
fn balls(law: &str) -> String {
    format!(
        "format = 2\ngravity = [0, 0, 0]\n\
         [parts.one]\nrigid = \"sphere\"\nradius = \"0.1_m\"\nmass = \"1_kg\"\nstart = {{ velocity = [1, 0, 0] }}\n\
         [parts.other]\nrigid = \"sphere\"\nradius = \"0.1_m\"\nmass = \"3_kg\"\nstart = {{ position = [\"0.2037_m\", 0, 0] }}\n\
         [[contacts]]\nbetween = [\"one\", \"other\"]\n{law}\n[run]\nseconds = 0.05\nstep = \"1_ms\"\n"
    )
}

const PENALTY: &str = "force = \"penalty\"\nstiffness = \"1e5 N/m\"";

/// Value of a column in the last row.
fn last(output: &serde_json::Value, column: &str) -> f64 {
    number(&output["last"][column])
}

/// Where the first ball is after 0.05 s, if the balls met after so long: together they move at 1/4 m/s while the spring
/// turns their relative velocity, for half a period, pi/w; then they move at -1/2 and 1/2 m/s.
fn place(met: f64) -> f64 {
    let left = met + PI / (1e5_f64 * (1.0 + 1.0 / 3.0)).sqrt();
    let apart = 0.2 + (0.05 - left);
    0.25 * 0.05 + 0.75 * (0.2 + met) - 0.75 * apart
}

#[test]
fn two_balls_leave_a_spring_as_its_half_period_says() {
    let output = json(&[&scene("balls", &balls(PENALTY)), "--step", "5e-5"]);
    assert!((last(&output, "one.x") - place(0.0037)).abs() < 1e-6, "{output}");
    assert!((last(&output, "one.vx") + 0.5).abs() < 1e-5, "{output}");
    assert!(last(&output, "imbalance").abs() < 1e-5, "{output}");
    let momentum = last(&output, "one.vx") + 3.0 * last(&output, "other.vx");
    assert!((momentum - 1.0).abs() < 1e-12, "{momentum}");
}

/// The stiffness jumps somewhere within a step: errors are the largest of five starts, the order the mean of four
/// halvings.
#[test]
fn every_method_keeps_the_order_that_the_manual_states() {
    let path = scene("orders", &balls(PENALTY));
    let methods = [
        ("euler", 1.0),
        ("semi-implicit", 1.0),
        ("verlet", 2.0),
        ("implicit_midpoint", 2.0),
        ("blanes_moan4", 2.0),
        ("rk4", 2.0),
    ];
    for (method, order) in methods {
        let [coarse, fine] = ["4e-4", "2.5e-5"].map(|step| {
            let error = |met: f64| {
                let start = format!("parts.other.start.position=[{}, 0, 0]", 0.2 + met);
                let output = json(&[&path, "--method", method, "--step", step, "--set", &start]);
                (last(&output, "one.x") - place(met)).abs()
            };
            [0.0037, 0.0031, 0.0023, 0.0044, 0.0019].map(error).into_iter().fold(0.0, f64::max)
        });
        let seen = (coarse / fine).log2() / 4.0;
        assert!(seen > order - 0.1, "{method}: order {seen}, {coarse:e} {fine:e}");
    }
}

/// m v dv/(1 + a v) = -k d^1.5 dd: both ends of the contact have the same v/a - ln(1 + a v)/a^2.
#[test]
fn hunt_crossley_returns_what_its_closed_form_says() {
    let law = "force = \"hunt_crossley\"\nstiffness = \"1e7 N/m^(3/2)\"\ndissipation = \"0.5 s/m\"";
    let output = json(&[&scene("hunt", &balls(law)), "--step", "5e-6"]);
    let out = last(&output, "other.vx") - last(&output, "one.vx");
    let side = |v: f64| v / 0.5 - (1.0 + 0.5 * v).ln() / 0.25;
    assert!((side(1.0) - side(-out)).abs() < 1e-8, "{out}");
    let lost = 0.5 * 0.75 * (1.0 - out * out);
    assert!(
        (last(&output, "impact") - lost).abs() < 1e-8 && last(&output, "imbalance").abs() < 1e-8,
        "{output}"
    );
}

/// A cube of nodes, free to turn, on a box on the ground.
fn stack(law: &str) -> String {
    format!(
        "format = 2\n[parts.ground]\nrigid = \"half_space\"\n\
         [parts.box]\nrigid = \"box\"\nsize = [\"0.3_m\", \"0.3_m\", \"0.1_m\"]\nmass = \"5_kg\"\nstart = {{ height = \"1_mm\" }}\n\
         [parts.cube]\nshape = \"cube\"\nside = \"0.1_m\"\nmass = \"0.4_kg\"\nK = \"20 kN/m\"\nC = \"5 N s/m\"\n\
         start = {{ position = [\"0.02_m\", \"0.01_m\", \"0.103_m\"] }}\n\
         [[contacts]]\nbetween = [\"box\", \"ground\"]\n{law}\n[[contacts]]\nbetween = [\"cube\", \"box\"]\n{law}\n\
         [run]\nseconds = 0.2\nstep = \"0.1_ms\"\nevery = 10\n"
    )
}

#[test]
fn accounts_close_for_the_world_each_part_and_each_seam() {
    let law = "force = \"hunt_crossley\"\nstiffness = \"1e6 N/m^(3/2)\"\ndissipation = \"0.3 s/m\"";
    let path = scene("stack", &stack(law));
    let [coarse, fine] = ["1e-4", "2.5e-5"].map(|step| {
        let output = json(&[&path, "--step", step]);
        assert!(last(&output, "impact") > 1e-3 && last(&output, "spring") > 1e-4, "{output}");
        last(&output, "imbalance").abs()
    });
    assert!(fine < 1e-6 && fine < coarse / 8.0, "{coarse:e} {fine:e}");
    let row = accounts::last("yielding", &[&path, "--step", "2.5e-5"]);
    let of = |ending: &str| row.iter().filter(|(name, _)| name.ends_with(ending)).collect::<Vec<_>>();
    assert_eq!(of(".imbalance").len(), 4);
    of(".imbalance").iter().for_each(|(name, x)| assert!(x.abs() < 1e-6, "{name}: {x:e}"));
    let world = json(&[&path, "--step", "2.5e-5"]);
    for account in ["spring", "impact", "damping"] {
        let apart = of(&format!(".{account}")).iter().map(|(_, x)| **x).sum::<f64>() - last(&world, account);
        assert!(apart.abs() < 1e-9, "{account}: {apart:e}");
    }
}

/// A ball of 1 kg rests m g/k deep; the rows say what presses it.
#[test]
fn a_ball_settles_at_the_depth_of_its_weight() {
    let text = "format = 2\n[parts.ground]\nrigid = \"half_space\"\n\
        [parts.ball]\nrigid = \"sphere\"\nradius = \"0.1_m\"\nmass = \"1_kg\"\nstart = { height = \"1_mm\" }\n\
        [[contacts]]\nbetween = [\"ball\", \"ground\"]\nforce = \"penalty\"\nstiffness = \"1e4 N/m\"\n\
        [run]\nseconds = 0.1\nstep = \"1_ms\"\nstart = \"settled\"\n";
    let path = scene("settled", text);
    let depth = 9.81 / 1e4;
    let rest = settled(&[&path]);
    assert!((number(&rest["last"]["ball.z"]) - (0.1 - depth)).abs() < 1e-9, "{rest}");
    let output = json(&[&path]);
    assert!((last(&output, "ball.z") - (0.1 - depth)).abs() < 1e-9, "{output}");
    assert!((last(&output, "ball-ground.normal") - 9.81).abs() < 1e-4, "{output}");
    assert!((last(&output, "spring") - 0.5 * 1e4 * depth * depth).abs() < 1e-7, "{output}");
}

/// Two masses on a spring: the largest step of explicit methods is 2 sqrt(m/k), m = 3/4 kg.
#[test]
fn the_step_is_bounded_by_the_stiffness() {
    let inside =
        balls(PENALTY).replace("0.2037_m", "0.199_m").replace("velocity = [1, 0, 0]", "velocity = [0, 0, 0]");
    let path = scene("limit", &inside);
    let limit = 2.0 * (0.75_f64 / 1e5).sqrt();
    let said = fails(&["run", &path, "--step", &(1.02 * limit).to_string()]);
    assert!(said.contains("largest stable step of the contact of `one` and `other`"), "{said}");
    let output = json(&[&path, "--method", "verlet", "--step", &(0.95 * limit).to_string()]);
    assert!(last(&output, "one.vx").abs() < 1.0, "{output}");
}

/// Laws of both kinds in one world: a ball on a spring strikes a second one by its law of impact.
#[test]
fn force_laws_stand_beside_located_impacts() {
    let text = balls(PENALTY).replace(
        "[run]",
        "[parts.third]\nrigid = \"sphere\"\nradius = \"0.1_m\"\nmass = \"3_kg\"\nstart = { position = [\"0.41_m\", 0, 0] }\n\
         [[contacts]]\nbetween = [\"other\", \"third\"]\nimpact = \"newton\"\nrestitution = 1\n[run]",
    );
    let output = json(&[&scene("beside", &text), "--step", "1e-4"]);
    assert!(
        (last(&output, "third.vx") - 0.5).abs() < 1e-3 && last(&output, "other.vx").abs() < 1e-3,
        "{output}"
    );
    assert_eq!(output["events"].as_array().map(Vec::len), Some(1));
}

#[test]
fn what_no_force_law_does_is_refused_with_its_place() {
    let refused = |from: &str, to: &str, expected: &[&str]| {
        let text = balls(PENALTY);
        assert!(text.contains(from));
        let said = fails(&["run", &scene("refused", &text.replace(from, to))]);
        expected.iter().for_each(|part| assert!(said.contains(part), "{part}\n{said}"));
    };
    refused("stiffness = \"1e5 N/m\"", "", &["has no `stiffness`", "refused.toml:"]);
    refused("1e5 N/m", "1e5 N", &["`stiffness` must be in", "refused.toml:"]);
    refused("1e5 N/m", "0 N/m", &["`stiffness` must be a number > 0"]);
    refused(
        "stiffness =",
        "friction = 0.3\nstiffness =",
        &["force = \"penalty\" reads no `friction`", "impact ="],
    );
    refused(
        "stiffness =",
        "dissipation = 1\nstiffness =",
        &["reads no `dissipation`", "force = \"hunt_crossley\""],
    );
    refused("force = \"penalty\"", "impact = \"newton\"", &["impact = \"newton\" reads no `stiffness`"]);
    refused("force =", "impact = \"newton\"\nforce =", &["a pair of parts with two laws"]);
    refused("force = \"penalty\"", "force = \"penalti\"", &["did you mean `penalty`?"]);
    let boxes = "rigid = \"box\"\nsize = [0.2, 0.2, 0.2]";
    refused(
        "rigid = \"sphere\"\nradius = \"0.1_m\"",
        boxes,
        &["no force law for `one` and `other`", "refused.toml:"],
    );
    let path = scene("methods", &balls(PENALTY));
    for method in ["energy_momentum", "moreau"] {
        assert!(fails(&["run", &path, "--method", method]).contains("run.method"), "{method}");
    }
    assert!(fails(&["run", &path, "--scalar", "f32"]).contains("in f64 only"));
    assert!(fails(&["firmware", &path]).contains("impact = \"moreau\""));
}
