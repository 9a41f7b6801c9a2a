//! Every refusal of a scene of format 2 has its row in docs/guide/every-error.md.

use crate::guide::{error_of, messages, same};
use crate::support::{smartbed, written};
use smartbed::failure::Failure;
use smartbed::world::read::parse;
use smartbed::world::run::{engine, run};
use std::path::{Path, PathBuf};

const GROUND: &str = "[parts.ground]\nrigid = \"half_space\"\n";
const TILE: &str = "[parts.tile]\nmechanism = \"tile_minimal\"\n";
const BALL: &str = "[parts.ball]\nrigid = \"sphere\"\nradius = 0.1\nmass = 1\n";
const HIGH: &str = "start = { height = 1 }\n";
const SHEET: &str = "[parts.sheet]\nshape = \"sheet\"\nrows = 3\ncolumns = 3\n";
const CUBE: &str = "[parts.cube]\nshape = \"cube\"\nstart = { height = 1 }\n";

const BLADDER: &str = "[parts.cube]\nshape = \"cube\"\ngas = { gauge = 0, sealed = true";
const DRIVEN: &str = "[parts.arm]\nmechanism = \"double_pendulum\"\n";
const HELD: &str = "reads = \"arm.q1\"\ndrives = \"arm.T\"\ntarget = 0\n";

fn find(name: &str) -> Result<PathBuf, String> {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../models").join(format!("{name}.toml"));
    if path.is_file() { Ok(path) } else { Err(format!("no model `{name}`")) }
}

/// Message for a scene with these lines, when it is read, assembled or run.
fn refusal(lines: &str) -> String {
    let text = format!("format = 2\n{lines}");
    let assembly = match parse("scene.toml", &text, &[], &find) {
        Ok(assembly) => assembly,
        Err(found) => return first_line(&Failure::Found(Box::new(found))),
    };
    let run = |engine: &mut dyn smartbed::world::engine::Engine| {
        run::<Failure>(&assembly, engine, None, |_, _| Ok(()), |_| Ok(()))
    };
    match engine(&assembly) {
        Ok(mut engine) => first_line(&run(engine.as_mut()).map(|_| ()).expect_err(&text)),
        Err(said) => first_line(&said),
    }
}

fn first_line(failure: &Failure) -> String {
    failure.to_string().lines().next().expect("an error").to_owned()
}

/// A ball above the ground, with the contact between them.
fn pair(contact: &str) -> String {
    format!("{GROUND}{BALL}{HIGH}[[contacts]]\nbetween = [\"ball\", \"ground\"]\n{contact}")
}

fn attached(items: &str) -> String {
    format!("{TILE}{BALL}{HIGH}{SHEET}attach = {items}\n")
}

fn controlled(lines: &str) -> String {
    format!("{BALL}{HIGH}[controllers.c]\n{lines}")
}

fn rigid(words: &str) -> String {
    format!("[parts.a]\nrigid = \"box\"\nmass = 1\n{words}\n")
}

#[test]
fn every_refusal_of_a_scene_has_its_cause_and_cure() {
    let texts = [
        // Read.
        format!("zzzzzzzzzz = 1\n{GROUND}"),
        "parts = {}".to_owned(),
        format!("{GROUND}{BALL}friction = 1"),
        "[parts.a]\nrigid = \"sphere\"\nradius = 1".to_owned(),
        "[parts.a]\nrigid = \"sphere\"\nradius = \"1_kg\"\nmass = 1".to_owned(),
        "[parts.a]\nrigid = \"ball\"\nradius = 1".to_owned(),
        "[parts.a]\nmass = 1".to_owned(),
        "[parts.\"a b\"]\nrigid = \"half_space\"".to_owned(),
        "[parts.\"\"]\nrigid = \"half_space\"".to_owned(),
        "[parts.sensors]\nrigid = \"half_space\"".to_owned(),
        "[parts.a]\nrigid = \"half_space\"\nfixed = false".to_owned(),
        rigid("size = [1, 1, 0]"),
        rigid("size = [1, 1, 1]\ninertia = [1, 1, 3]"),
        rigid("size = [1, 1, 1]\nstart = { axis = [0, 0, 0], angle = 1 }"),
        "[parts.a]\nrigid = \"box\"\nsize = [1, 1, 1]\nfixed = true\nstart = { velocity = [1, 0, 0] }"
            .to_owned(),
        rigid("size = [1, 1, 1]\ngrid = { count = [0, 4], pitch = [1, 1] }"),
        format!("{GROUND}{BALL}"),
        format!("{TILE}[parts.skin]\nrigid = \"sphere\"\nradius = 1\non = \"tile.top\""),
        format!("{BALL}{HIGH}[parts.skin]\nrigid = \"sphere\"\nradius = 1\non = \"ball\""),
        "[parts.a]\nmechanism = \"tyle\"".to_owned(),
        "[parts.arm]\nmechanism = \"pendulum\"\nset = { l = 0.4 }".to_owned(),
        format!("{TILE}command = {{ hA = \"1_kg\" }}"),
        format!("{TILE}command = {{ hA = \"1_mm\", heave = \"1_mm\" }}"),
        format!("{TILE}command = {{ hA = \"1_mm\" }}\nstart = {{ hA = \"2_mm\" }}"),
        format!(
            "{TILE}[parts.deck]\nrigid = \"sphere\"\nradius = 1\non = \"tile.platform\"\n{SHEET}attach = [{{ nodes = \"rim\", to = \"deck\" }}]"
        ),
        rigid("size = [1, 1, 1]\nstart = { axis = [0, 1, 0] }"),
        format!("{SHEET}corners = 3"),
        format!("{SHEET}K = true"),
        format!("{SHEET}gas = {{ gauge = \"4_kPa\" }}"),
        format!("{CUBE}gas = {{ gauge = \"-200_kPa\" }}"),
        format!("{CUBE}gas = {{ gauge = 0, sealed = true, exponent = 1.5 }}"),
        "[parts.s]\nshape = \"sheet\"\nrows = 200\ncolumns = 200\ngrid = { count = [9, 9], pitch = [1, 1] }"
            .to_owned(),
        attached("[{ nodes = \"rim\", to = \"tille.platform\" }]"),
        attached("[{ nodes = \"rim\", to = \"tile\" }]"),
        attached("[{ nodes = \"rim\", to = \"ball.top\" }]"),
        attached("[{ nodes = \"rim\", to = \"sheet\" }]"),
        attached("[{ nodes = \"base\", to = \"ball\" }]"),
        attached("[{ nodes = [99], to = \"ball\" }]"),
        format!("{CUBE}base = \"40_mm\"\n"),
        attached("[{ to = \"ball\" }]"),
        attached("[{ nodes = [0, 0], to = \"ball\" }]"),
        pair(""),
        pair("impact = \"newton\"\nfriction = 0.1"),
        pair("impact = \"plastic\"\nshare = 0.5"),
        pair("impact = \"plastic\"\nforce = \"penalty\""),
        pair("force = \"penalty\"\nstiffness = 1e4\nfriction = 0.5"),
        format!(
            "{CUBE}{}[[contacts]]\nbetween = [\"cube\", \"other\"]\nforce = \"penalty\"\nstiffness = 1",
            CUBE.replace("cube]", "other]").replace("height = 1", "height = 3")
        ),
        pair("impact = \"plastic\"\n[[contacts]]\nbetween = [\"ball\", \"ground\"]\nimpact = \"stronge\""),
        format!("{}[parts.ball-ground]\nrigid = \"half_space\"", pair("impact = \"plastic\"\n")),
        format!("{BALL}[[contacts]]\nbetween = [\"ball\", \"ball\"]\nimpact = \"plastic\""),
        format!("{BALL}[[contacts]]\nbetween = [\"ball\"]\nimpact = \"plastic\""),
        format!("{GROUND}[run]\nseconds = 1e9\nstep = 1e-9"),
        format!("{TILE}[view]\ncolours = {{ tile = \"sky\" }}"),
        // Assembled.
        format!("{GROUND}{BALL}{HIGH}[run]\nmethod = \"rk4\""),
        format!("{GROUND}{BALL}{HIGH}[run]\nsleep = 0.1"),
        format!("{CUBE}[run]\nmethod = \"rk5\""),
        format!("{CUBE}[run]\nstep = 1"),
        format!("{TILE}{BALL}{HIGH}[[contacts]]\nbetween = [\"ball\", \"tile\"]\nimpact = \"plastic\""),
        format!(
            "{CUBE}{}",
            pair("impact = \"plastic\"\n[[contacts]]\nbetween = [\"cube\", \"ground\"]\nimpact = \"moreau\"")
        ),
        format!(
            "{GROUND}{CUBE}[[contacts]]\nbetween = [\"cube\", \"ground\"]\nimpact = \"moreau\"\n[run]\nmethod = \"rk4\""
        ),
        format!(
            "{GROUND}{}[[contacts]]\nbetween = [\"cube\", \"ground\"]\nimpact = \"moreau\"",
            CUBE.replace("height = 1", "height = -0.01")
        ),
        format!(
            "{GROUND}[parts.pad]\nrigid = \"sphere\"\nradius = 1\nfixed = true\n{HIGH}[[contacts]]\nbetween = [\"pad\", \"ground\"]\nimpact = \"moreau\""
        ),
        format!("{CUBE}air_drag = 1\n[parts.other]\nshape = \"cube\"\nstart = {{ height = 3 }}"),
        // Gas and controllers.
        format!("{BLADDER}, supply = {{ gauge = \"-200_kPa\", conductance = 1e-8 }} }}"),
        format!("{BLADDER}, vent = {{ conductance = 1e6, opening = 1 }} }}")
            .replace("gauge = 0", "gauge = 1000"),
        format!("{BLADDER}, vent = {{ critical_ratio = 1, conductance = 1e-8 }} }}"),
        format!(
            "{BLADDER}, supply = {{ gauge = 1000, conductance = 1e-8, opening = 1 }} }}\n[controllers.a]\nreads = \"cube.gauge\"\n\
             drives = \"cube.supply\"\ntarget = 0\nperiod = 0.001"
        ),
        controlled("reads = \"ball.w\"\ndrives = \"ball.F\"\ntarget = 0\nperiod = 0.001"),
        controlled("reads = \"ball.z\"\ndrives = \"ball.F\"\ntarget = 0\nperiod = 0.001"),
        controlled("reads = \"ball.z\"\ndrives = \"ball.F\"\ntarget = [[1, 0]]\nperiod = 0.001"),
        controlled("reads = \"ball.z\"\ndrives = \"ball.F\"\ntarget = 0\nperiod = 0.001\nlimits = [1, 0]"),
        format!("{DRIVEN}[controllers.a]\n{HELD}period = \"1.5_ms\""),
        format!("{DRIVEN}[controllers.a]\n{HELD}period = 0.001\n[controllers.b]\n{HELD}period = 0.001"),
        // Run.
        format!("{BALL}[run]\nstart = \"settled\""),
        format!("{CUBE}[run]\nstart = \"settled\""),
        format!("{CUBE}[run]\nstart = \"settled\"\nstep = 1e-7"),
        "[parts.cube]\nshape = \"cube\"\nstart = { velocity = [1, 0, 0] }\n[run]\nstart = \"settled\""
            .to_owned(),
        "[parts.tile]\nmechanism = \"tile\"\nstart = { u_hA = 0.1 }\n[run]\nstart = \"settled\"".to_owned(),
        "[parts.tile]\nmechanism = \"tile\"\n[parts.a]\nrigid = \"half_space\"\non = \"tile.platform\"\nfixed = true"
            .to_owned(),
        format!("{BALL}[sensors.s]\nof = \"ball.w\""),
        "[parts.top]\nmechanism = \"spinning_top\"\ncommand = { tip_e0 = \"cos(t/1_s)\" }".to_owned(),
        format!("{BALL}[sensors.s]\nof = \"ball.z\"\nnoise = \"1_mm\""),
        format!(
            "{DRIVEN}[controllers.a]\n{}period = 0.001",
            HELD.replace("target = 0", "target = [[0, \"1_m + 3_mm\"]]")
        ),
        format!("{BALL}[sensors.s]\nof = \"ball.z\"\nunit = \"meter\""),
        format!("{BALL}[sensors.s]\nof = \"ball.z\"\nunit = \"N\""),
        format!("{DRIVEN}[controllers.a]\n{HELD}period = 0.001\nunit = \"m\""),
        "[parts.arm]\nmechanism = \"pendulum\"\ncommand = { q = \"sqrt(t/1_s)\" }".to_owned(),
        "[parts.a]\nrigid = \"sphere\"\nradius = 1\nfixed = true\nmass = 1".to_owned(),
        format!(
            "{DRIVEN}command = {{ q1 = \"1_rad*t/1_s\", q2 = \"1_rad*t/1_s\" }}\nlaw = {{ T = \"1_N*1_m\" }}"
        ),
        format!("{BLADDER}, ambient = 0, vent = {{ conductance = 1e-8 }} }}\n")
            .replace("gauge = 0", "gauge = 9"),
        format!("{BALL}[sensors.s]\nof = \"ball.z\"\nperiod = \"1.5_ms\""),
        format!("{BALL}[sensors.s]\nof = \"ball.z\"\ndelay = \"0.1_s\""),
        format!(
            "[parts.tile]\nmechanism = \"tile_minimal\"\ncommand = {{ {} }}\n{SHEET}attach = [{{ nodes = \"rim\", to = \"tile.platform\" }}]\n[run]\nstart = \"settled\"",
            ["hA", "hB", "hC"].map(|height| format!("{height} = \"0.01_m*t/1_s\"")).join(", ")
        ),
    ];
    let mut found: Vec<String> = texts.iter().map(|text| refusal(text)).collect();
    let controlled = format!("format = 2\n{DRIVEN}[controllers.a]\n{HELD}period = 0.001");
    let file = written("controlled.toml", &controlled);
    found.push(error_of(&["firmware", &file]));
    let by_step =
        controlled.replace("reads = \"arm.q1\"", "reads = \"sensors.s\"") + "\n[sensors.s]\nof = \"arm.q1\"";
    found.push(error_of(&["run", &written("by_step.toml", &by_step), "--error", "1e-3"]));
    let flight = written("flight.toml", &format!("format = 2\n{BALL}[run]\nseconds = 0.01\n"));
    let state = format!("{flight}.state");
    assert_eq!(smartbed(&["run", &flight, "--save", &state]).status, 0);
    let seen = "sensors={ s = { of = \"ball.z\" } }";
    found.push(error_of(&["run", &flight, "--resume", &state, "--set", seen]));
    let other = written(
        "other_flight.toml",
        &format!("format = 2\n{}[run]\nseconds = 0.01\n", BALL.replace("ball", "bowl")),
    );
    found.push(error_of(&["run", &other, "--resume", &state]));
    let coarse =
        "[parts.sheet]\nshape = \"sheet\"\nrows = 60\ncolumns = 60\n[run]\nseconds = 1e-5\nstep = 1e-5\n";
    let for_chip = [
        pair("impact = \"newton\""),
        format!("{BALL}{HIGH}"),
        format!("{BALL}{HIGH}{coarse}[[contacts]]\nbetween = [\"ball\", \"sheet\"]\nimpact = \"moreau\""),
    ];
    for (number, text) in for_chip.iter().enumerate() {
        let file = written(&format!("for_chip_{number}.toml"), &format!("format = 2\n{text}"));
        found.push(error_of(&["firmware", &file]));
    }
    for (scene, way) in [("single_spring", "--by-rows"), ("two_cubes", "--by-rows"), ("ball", "--at-rest")] {
        found.push(error_of(&["firmware", scene, way]));
    }
    found.iter().for_each(|said| println!("{said}"));
    same(&found, &messages("## Scenes of format 2", Some("## Plans of the bed")));
}
