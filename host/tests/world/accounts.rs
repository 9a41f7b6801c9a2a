//! Accounts of each part and each seam: they close by themselves and add up to the world's ledger.

use super::support::{fails, fields, json, number, run, scene};
use std::collections::BTreeMap;
use std::path::Path;

pub type Row = BTreeMap<String, f64>;

fn file(name: &str) -> String {
    Path::new(env!("CARGO_TARGET_TMPDIR")).join(format!("accounts_{name}.csv")).display().to_string()
}

fn read(file: &str) -> Vec<Row> {
    let text = std::fs::read_to_string(file).expect("a file");
    let mut lines = text.lines();
    let names = fields(lines.next().expect("a header"));
    let row = |line: &str| {
        let values: Vec<f64> = line.split(',').map(|x| x.parse().expect("a number")).collect();
        assert_eq!(values.len(), names.len(), "{names:?}");
        names.iter().cloned().zip(values).collect()
    };
    lines.map(row).collect()
}

/// Rows of the accounts of a run.
fn accounts(name: &str, arguments: &[&str]) -> Vec<Row> {
    let to = file(name);
    run(&[&["run"], arguments, &["--accounts", &to]].concat());
    read(&to)
}

/// The last row.
pub fn last(name: &str, arguments: &[&str]) -> Row {
    accounts(name, arguments).pop().expect("a row")
}

/// A ball that strikes a bladder on a plate, all of them free.
fn struck(name: &str, law: &str) -> String {
    let text = "format = 2\n[parts.plate]\nrigid = \"box\"\nsize = [\"0.3_m\", \"0.3_m\", \"0.02_m\"]\nmass = \"2_kg\"\n\
        start = { position = [0, 0, \"0.1_m\"], spin = [0.3, 0.2, 0] }\n\
        [parts.bladder]\nshape = \"sheet\"\nrows = 5\ncolumns = 5\nwidth = \"0.28_m\"\ndepth = \"0.28_m\"\nbase = \"40_mm\"\n\
        mass = \"20_g\"\nK = \"2 kN/m\"\nC = \"0.8 N s/m\"\nair_drag = \"0.05 N s/m\"\n\
        start = { position = [\"-0.14_m\", \"-0.14_m\", \"50_mm\"] }\n\
        gas = { gauge = \"1_kPa\", sealed = true }\n\
        attach = [{ nodes = \"rim\", to = \"plate\" }, { facets = \"base\", to = \"plate\" }]\n\
        [parts.ball]\nrigid = \"sphere\"\nradius = \"50_mm\"\nmass = \"0.5_kg\"\n\
        start = { position = [\"10_mm\", \"5_mm\", \"0.215_m\"], velocity = [\"0.3 m/s\", 0, \"-1.5 m/s\"] }\n\
        [[contacts]]\nbetween = [\"ball\", \"bladder\"]\nfriction = 0.4\n";
    let end = "[run]\nseconds = 0.02\nstep = \"0.5_ms\"\n";
    scene(&format!("accounts_{name}"), &format!("{text}{law}\n{end}"))
}

#[test]
fn the_drive_pays_what_a_mass_on_a_spring_takes() {
    let (a, w, m, k, t) = (0.01_f64, 25.0_f64, 0.5_f64, 200.0_f64, 0.3_f64);
    let text = |mass: &str| {
        let law = "0.01_m*(1 - cos(25*t/1_s))";
        let tile = format!(
            "mechanism = \"tile_minimal\"\ncommand = {{ hA = \"{law}\", hB = \"{law}\", hC = \"{law}\" }}"
        );
        format!(
            "format = 2\ngravity = [0, 0, 0]\n[parts.tile]\n{tile}\n{mass}[run]\nseconds = 0.3\nstep = \"0.2_ms\"\n"
        )
    };
    let mass = "[parts.mass]\npoints = [[0, 0, 0], [0, 0, 0.1]]\nsprings = [[0, 1]]\nmass = 0.5\nK = 200\n\
        attach = [{ nodes = [0], to = \"tile.platform\" }]\n";
    let with = last("with", &[&scene("accounts_with", &text(mass))]);
    // Stretch of the mass's place beyond its start: e'' = -w0^2 (e - y), y = a (1 - cos w t).
    let w0 = (k / m).sqrt();
    let share = w0 * w0 / (w0 * w0 - w * w);
    let e = a - a * share * (w * t).cos() + a * (share - 1.0) * (w0 * t).cos();
    let speed = a * share * w * (w * t).sin() - a * (share - 1.0) * w0 * (w0 * t).sin();
    let y = a * (1.0 - (w * t).cos());
    let taken = 0.5 * m * speed * speed + 0.5 * k * (e - y) * (e - y);
    assert!(taken > 1e-2, "{taken}");
    let near = |name: &str, expected: f64| {
        assert!((with[name] - expected).abs() < 1e-8, "{name}: {} against {expected}", with[name]);
    };
    near("mass@tile.platform.to_mass", taken);
    near("mass@tile.platform.to_tile", -taken);
    near("mass.seams", taken);
    near("mass.imbalance", 0.0);
    near("tile.imbalance", 0.0);
    // Without the mass the drive gives that much less.
    let without = last("without", &[&scene("accounts_without", &text(""))]);
    near("tile.actuator", without["tile.actuator"] + taken);
}

#[test]
fn parts_of_a_tile_driven_by_forces_close_each_to_the_order_of_the_method() {
    let end = |step: &str| {
        last(&format!("driven_{step}"), &["tile_bladder_coupled", "--step", step, "--seconds", "0.1"])
    };
    let (coarse, fine) = (end("8e-4"), end("4e-4"));
    for part in ["tile", "bladder"] {
        let name = format!("{part}.imbalance");
        assert!(
            fine[&name].abs() < 1e-6 && fine[&name].abs() < coarse[&name].abs() / 10.0,
            "{name}: {coarse:?} {fine:?}"
        );
        assert!(fine[&format!("{part}.seams")].abs() > 1e-3, "{fine:?}");
    }
    assert!((fine["tile.seams"] + fine["bladder.seams"]).abs() < 1e-15);
}

#[test]
fn a_ball_strikes_a_bladder_and_every_part_closes_to_the_order_of_the_method() {
    let laws = [
        ("impact = \"compensation\"\nshare = 0.5", "rk4", 10.0, 1e-7),
        ("impact = \"moreau\"", "moreau", 3.0, 1e-4),
        ("impact = \"moreau\"", "energy_momentum", 0.0, 1e-13),
    ];
    for (law, method, fall, least) in laws {
        let text = struck(&format!("struck_{method}"), law);
        let end = |step: &str| {
            last(&format!("struck_{method}_{step}"), &[&text, "--method", method, "--step", step])
        };
        let (coarse, fine) = (end("2.5e-4"), end("1.25e-4"));
        for name in ["plate", "bladder", "ball", "bladder@plate", "ball-bladder"] {
            let name = format!("{name}.imbalance");
            let (coarse, fine) = (coarse[&name].abs(), fine[&name].abs());
            assert!(fine < least, "{method} {name}: {coarse:e} {fine:e}");
            assert!(fine < 1e-12 || fine < coarse / fall, "{method} {name}: {coarse:e} {fine:e}");
        }
        // Energy has passed: from the ball to the bladder, and on to the plate.
        assert!(fine["ball-bladder.to_ball"] < -1e-2 && fine["ball-bladder.to_bladder"] > 1e-3, "{fine:?}");
        assert!(fine["bladder@plate.to_plate"].abs() > 1e-3, "{fine:?}");
    }
}

#[test]
fn compensation_gives_back_along_springs_what_the_seam_lost() {
    let cube = |name: &str, start: &str| {
        format!(
            "[parts.{name}]\nshape = \"cube\"\nside = \"0.2_m\"\nmass = \"50_g\"\nK = \"2 kN/m\"\nstart = {{ {start} }}\n"
        )
    };
    let cubes = cube("left", "velocity = [\"1 m/s\", 0, 0]")
        + &cube("right", "position = [\"0.25_m\", \"0.05_m\", \"0.03_m\"]");
    let text = format!(
        "format = 2\ngravity = [0, 0, 0]\n{cubes}[[contacts]]\nbetween = [\"left\", \"right\"]\nimpact = \"compensation\"\n\
         [run]\nseconds = 0.0502\nstep = \"0.4_ms\"\n"
    );
    let text = scene("accounts_cubes", &text);
    let fine = last("cubes", &[&text, "--step", "1e-4"]);
    // Nothing is lost: the impulses along springs give both cubes what the contacts took.
    let [seam, left, right] = ["left-right", "left", "right"].map(|name| fine[&format!("{name}.impact")]);
    assert!(seam > 1e-3 && left < -1e-4 && right < -1e-4, "{fine:?}");
    assert!((seam + left + right).abs() < 1e-12, "{seam:e} {left:e} {right:e}");
    for name in ["left", "right", "left-right"] {
        let imbalance = fine[&format!("{name}.imbalance")];
        assert!(imbalance.abs() < 1e-8, "{name}: {imbalance:e}");
    }
}

/// Two balls meet on a line; `beside` is a part that nothing touches and that decides which engine moves them.
fn thrown(law: &str, beside: &str) -> String {
    let ball = |name: &str, mass: &str, x: &str, v: &str| {
        format!(
            "[parts.{name}]\nrigid = \"sphere\"\nradius = \"0.1_m\"\nmass = \"{mass}\"\n\
             start = {{ position = [\"{x}\", 0, 0], velocity = [\"{v}\", 0, 0] }}\n"
        )
    };
    let (one, other) = (ball("one", "1_kg", "0_m", "1 m/s"), ball("other", "2_kg", "0.3_m", "0 m/s"));
    format!(
        "format = 2\ngravity = [0, 0, 0]\n{one}{other}{beside}[[contacts]]\nbetween = [\"one\", \"other\"]\nimpact = \"{law}\"\n\
         restitution = 0.5\n[run]\nseconds = 0.2\nstep = \"1_ms\"\n"
    )
}

#[test]
fn two_balls_share_the_energy_of_an_impact_as_momentum_says() {
    // With e = 0.5, 1 kg at 1 m/s stops at 2 kg at rest, which leaves at 0.5 m/s.
    let beside = "[parts.far]\npoints = [[9, 0, 0], [9, 0, 1]]\nsprings = [[0, 1]]\nmass = 1\nK = 100\n";
    for (name, law, beside) in [
        ("rigid", "stronge", ""),
        ("located", "stronge", beside),
        ("newton", "newton", beside),
        ("swept", "moreau", ""),
    ] {
        let end = last(
            &format!("thrown_{name}"),
            &[&scene(&format!("accounts_thrown_{name}"), &thrown(law, beside))],
        );
        let expected =
            [("to_one", -0.5), ("to_other", 0.25), ("impact", 0.25), ("friction", 0.0), ("imbalance", 0.0)];
        for (account, value) in expected {
            let seen = end[&format!("one-other.{account}")];
            assert!((seen - value).abs() < 1e-12, "{name} {account}: {seen}");
        }
        for (part, kinetic, seams) in [("one", 0.0, -0.5), ("other", 0.25, 0.25)] {
            assert!((end[&format!("{part}.kinetic")] - kinetic).abs() < 1e-12, "{name}: {end:?}");
            assert!((end[&format!("{part}.seams")] - seams).abs() < 1e-12, "{name}: {end:?}");
        }
    }
}

#[test]
fn a_box_slides_to_rest_and_friction_takes_all_of_it() {
    let text = |law: &str| {
        format!(
            "format = 2\n[parts.ground]\nrigid = \"half_space\"\n[parts.box]\nrigid = \"box\"\nsize = [\"0.2_m\", \"0.2_m\", \"0.1_m\"]\n\
             mass = \"2_kg\"\nstart = {{ height = 0, velocity = [\"1 m/s\", 0, 0] }}\n[[contacts]]\nbetween = [\"box\", \"ground\"]\n\
             impact = \"{law}\"\nfriction = 0.5\n[run]\nseconds = 0.5\nstep = \"1_ms\"\n"
        )
    };
    for (law, error) in [("plastic", 1e-9), ("moreau", 1e-9)] {
        let end = last(&format!("slides_{law}"), &[&scene(&format!("accounts_slides_{law}"), &text(law))]);
        let seen = [end["box-ground.friction"], -end["box-ground.to_box"], 1.0 + end["box-ground.to_ground"]];
        assert!(seen.iter().all(|seen| (seen - 1.0).abs() < error), "{law}: {seen:?}");
    }
}

/// Kinds of accounts that parts, seams and the world have in common.
const SHARED: [&str; 11] = [
    "kinetic",
    "gravity",
    "spring",
    "pressure",
    "damping",
    "drag",
    "impact",
    "friction",
    "actuator",
    "total",
    "imbalance",
];

#[test]
fn accounts_add_up_to_the_ledger_of_the_world_and_change_no_bit() {
    let carried = struck("stronge", "impact = \"stronge\"");
    let scenes: [&[&str]; 9] = [
        &["box_bounce"],
        &["rod_with_friction"],
        &["two_cubes"],
        &["tile_with_bladder"],
        &["arm6_pushes_wall"],
        &["plate_on_bladder"],
        &["tile_bladder_coupled", "--method", "verlet"],
        &["ball_on_bladder", "--set", "run.sleep=0.05", "--every", "20"],
        &[&carried],
    ];
    for (number, arguments) in scenes.iter().enumerate() {
        let [plain, with, own] = ["plain", "with", "own"].map(|kind| file(&format!("sum_{number}_{kind}")));
        let arguments =
            [&["run"], *arguments, &["--seconds", if number == 7 { "2" } else { "0.1" }]].concat();
        run(&[&arguments[..], &["--csv", &plain]].concat());
        run(&[&arguments[..], &["--csv", &with, "--accounts", &own]].concat());
        assert!(std::fs::read(&plain).expect("rows") == std::fs::read(&with).expect("rows"), "{arguments:?}");
        let rows = read(&own);
        assert!(rows.len() > 2, "{arguments:?}");
        for (row, world) in rows.iter().zip(read(&plain)) {
            let largest =
                row.iter().filter(|(name, _)| *name != "t").map(|(_, x)| x.abs()).fold(1e-300, f64::max);
            for kind in SHARED {
                let of_kind = row.iter().filter(|(name, _)| name.ends_with(&format!(".{kind}")));
                let apart = of_kind.map(|(_, x)| x).sum::<f64>() - world[kind];
                assert!(apart.abs() < 1e-13 * largest, "{arguments:?} t = {}: {kind} {apart:e}", row["t"]);
            }
        }
    }
}

#[test]
fn gas_that_flows_in_is_booked_to_its_part() {
    let text = "format = 2\n[parts.ground]\nrigid = \"half_space\"\n[parts.bladder]\nshape = \"sheet\"\nrows = 5\ncolumns = 5\n\
        width = \"0.28_m\"\ndepth = \"0.28_m\"\nbase = \"40_mm\"\nmass = \"50_g\"\nK = \"2 kN/m\"\nC = \"2 N s/m\"\n\
        start = { position = [0, 0, \"40_mm\"] }\n\
        gas = { gauge = \"1_kPa\", sealed = true, supply = { gauge = \"30_kPa\", conductance = \"2e-8 m^3/(s Pa)\", opening = 1 } }\n\
        attach = [{ nodes = \"rim\", to = \"ground\" }, { facets = \"base\", to = \"ground\" }]\n[run]\nseconds = 0.05\nstep = \"0.1_ms\"\n";
    let to = file("gas");
    let done = json(&[&scene("accounts_gas", text), "--accounts", &to]);
    let end = read(&to).pop().expect("a row");
    assert!(
        end["bladder.actuator"] < -1e-3 && end["bladder.actuator"] == number(&done["last"]["actuator"]),
        "{end:?}"
    );
    assert!(end["bladder.imbalance"].abs() < 1e-5 * end["bladder.actuator"].abs(), "{end:?}");
    // The last row is in the JSON too.
    assert_eq!(number(&done["accounts"]["bladder.actuator"]), end["bladder.actuator"]);
}

/// Two tiles side by side, one screw of each commanded; a ball drops on each.
fn commanded_in_part(impact: &str) -> String {
    let mut text = "format = 2\n[run]\nseconds = 0.3\n".to_owned();
    for (k, rise) in [(0, "10_mm"), (1, "20_mm")] {
        text += &format!(
            "[parts.tile{k}]\nmechanism = \"tile_minimal\"\ncommand = {{ hA = \"{rise}*sin(20*t/1_s)\" }}\n\
             start = {{ position = [{k}, 0, 0] }}\n\
             [parts.pad{k}]\nrigid = \"box\"\nsize = [\"0.2_m\", \"0.2_m\", \"10_mm\"]\non = \"tile{k}.platform\"\n\
             start = {{ position = [0, 0, \"50_mm\"] }}\n\
             [parts.ball{k}]\nrigid = \"sphere\"\nradius = \"50_mm\"\nmass = \"1_kg\"\n\
             start = {{ position = [{k}, 0, \"0.3_m\"] }}\n\
             [[contacts]]\nbetween = [\"ball{k}\", \"pad{k}\"]\nrestitution = 0.5\nfriction = 0.2\nimpact = \"{impact}\"\n"
        );
    }
    scene(&format!("accounts_in_part_{impact}"), &text)
}

#[test]
fn each_drive_of_mechanisms_commanded_in_part_is_booked_where_it_works() {
    // Law, method, least factor by which half the step reduces the imbalance, largest imbalance (J).
    let kinds = [
        ("moreau", "moreau", 1.9, 5e-3),
        ("moreau", "energy_momentum", 1.9, 2e-5),
        ("stronge", "rk4", 8.0, 1e-11),
        ("stronge", "verlet", 3.5, 2e-6),
    ];
    for (impact, method, fall, largest) in kinds {
        let text = commanded_in_part(impact);
        let end =
            |step: &str| last(&format!("in_part_{method}"), &[&text, "--method", method, "--step", step]);
        let (coarse, fine) = (end("4e-4"), end("2e-4"));
        for tile in ["tile0", "tile1"] {
            let of = |end: &Row| end[&format!("{tile}.imbalance")].abs();
            println!("{method}, {tile}: {:e} J, {:e} J with half the step", of(&coarse), of(&fine));
            assert!(
                of(&coarse) < largest && of(&fine) < of(&coarse) / fall,
                "{method}, {tile}: {coarse:?} {fine:?}"
            );
        }
        assert!(fine["tile0.actuator"] > 0.05 && fine["tile1.actuator"] > 0.4, "{fine:?}");
        assert!(fine["tile0.seams"] > 1.0 && fine["ball0-pad0.imbalance"].abs() < 1e-12, "{fine:?}");
    }
}

#[test]
fn the_account_of_an_arm_with_laws_closes_over_impacts() {
    let text = std::fs::read_to_string(super::support::find("scenes/arm6_pushes_wall").expect("a scene"));
    let law = "impact = \"stronge\"\nrestitution = 0.5";
    let text = text.expect("a text").replace("impact = \"moreau\"", law);
    let arguments = [&scene("accounts_arm", &text), "--method", "rk4", "--seconds", "0.5", "--step", "4e-4"];
    let end = last("arm", &arguments);
    println!("{:e} J", end["arm.imbalance"]);
    assert!(end["arm.imbalance"].abs() < 1e-8 && end["tip-wall.impact"] > 0.1, "{end:?}");
}

#[test]
fn what_cannot_be_accounted_is_refused_by_name() {
    let to = file("refused");
    for model in ["tile", "single_spring"] {
        let said = fails(&["run", model, "--accounts", &to]);
        assert!(said.contains("--accounts: expected a scene of format 2"), "{said}");
    }
    let said = fails(&["run", "box_bounce", "--accounts", "-", "--csv", "-"]);
    assert!(said.contains("only one of them can go to standard output"), "{said}");
    let output = super::support::smartbed(&["run", "box_bounce", "--accounts", &to, "--resume", "box.state"]);
    assert!(!output.status.success() && String::from_utf8_lossy(&output.stderr).contains("--resume"));
}

#[test]
fn accounts_of_a_grid_have_one_column_for_each_name() {
    let text = r#"
format = 2
[parts.floor]
rigid = "half_space"
[parts.b]
rigid = "sphere"
radius = 0.1
mass = 2
grid = { count = [1, 2], pitch = [0.5, 0.5] }
start = { height = 0.5 }
[run]
seconds = 0.01
"#;
    let row = last("grid", &[&scene("accounts_grid", text)]);
    // The height of the centres is 0.6 m, and nothing is lost in flight.
    for name in ["b[0,0].total", "b[0,1].total"] {
        assert!((row[name] - 2.0 * 9.81 * 0.6).abs() < 1e-2, "{row:?}");
    }
}
