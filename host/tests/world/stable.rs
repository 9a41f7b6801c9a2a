//! The largest stable step knows what holds nodes: a light rigid part or mechanism on stiff springs is refused a step at
//! which it would grow without bound, as a free node of its mass is.

use super::support::{find, parse, scene};
use smartbed::world::run::engine;
use smartbed::world::{Assembly, read};

/// A slider of 10 g along x, as a model.
const SLIDER: &str = r#"
format = 1
name = "slider"
[parameters]
m = { value = 10, unit = "g" }
[coordinates]
x = { unit = "m", independent = true }
[points]
P = "x*N.x"
[bodies]
b = { centre = "P", mass = "m" }
[ports]
tip = { frame = "N", point = "P" }
"#;

/// A ball of so many grams that flies along x at 10 mm/s.
fn ball(grams: f64) -> String {
    format!(
        "[parts.holder]\nrigid = \"sphere\"\nradius = 0.02\nmass = \"{grams}_g\"\nstart = {{ velocity = [0.01, 0, 0] }}\n"
    )
}

/// The slider as fast.
fn slider() -> String {
    let path = scene("slider", SLIDER);
    format!("[parts.holder]\nmechanism = \"{path}\"\nstart = {{ u_x = 0.01 }}\n")
}

/// What holds one end of a spring of 1e5 N/m along x, whose other end is fixed or has 10 g.
fn on_a_spring(holder: &str, (to, other): (&str, &str), run: &str) -> String {
    format!(
        "format = 2\ngravity = [0, 0, 0]\n{holder}[parts.spring]\npoints = [[0, 0, 0], [0.5, 0, 0]]\nsprings = [[0, 1]]\n\
         K = 1e5\nmass = 0.01\n{other}attach = [{{ nodes = [0], to = \"{to}\" }}]\n[run]\nseconds = 0.1\n{run}"
    )
}

fn read(text: &str) -> Assembly {
    let own = |name: &str| if name.contains('/') { Ok(name.into()) } else { find(name) };
    read::parse("w.toml", text, &[], &own).map_err(|found| found.to_string()).expect("a world")
}

/// The largest stable step that a refusal of a step of 10 ms names, and the part.
fn refused(text: &str) -> (String, f64) {
    let Err(refusal) = engine(&read(text)) else { panic!("a step of 10 ms is refused") };
    let message = refusal.to_string();
    let line = message.lines().next().expect("a line");
    let said = line.split_once("largest stable step of `").expect("the reason").1;
    let (who, step) = said.rsplit_once(", ").expect("a step");
    let step = step.strip_suffix(" s").expect("a step");
    (who.split('`').next().expect("a name").to_owned(), step.parse().expect("a number"))
}

/// The largest place along x of what holds the spring, in so many steps of this length (m).
fn reach(text: &str, h: f64, steps: usize) -> f64 {
    let mut engine = engine(&read(text)).expect("an engine");
    let column = engine.columns().iter().position(|own| own.name == "holder.x").expect("a column");
    let mut most = 0.0_f64;
    for _ in 0..steps {
        if engine.step(h, &mut Vec::new()).is_err() {
            return f64::INFINITY;
        }
        most = most.max(engine.state().expect("a state")[column].abs());
    }
    most
}

#[test]
fn what_holds_a_node_has_the_stable_step_of_a_node_of_its_mass() {
    let limit = 2.0 * (0.01_f64 / 1e5).sqrt();
    let ground = "[parts.ground]\nrigid = \"half_space\"\nstart = { position = [0, 0, -1] }\n\
                  [parts.other]\nrigid = \"sphere\"\nradius = 0.01\nmass = 1\nstart = { position = [0, 3, 0] }\n\
                  [[contacts]]\nbetween = [\"other\", \"ground\"]\nimpact = \"moreau\"\n";
    for (holder, to) in [(ball(10.0), "holder"), (slider(), "holder.tip")] {
        for (method, more) in [("verlet", ""), ("moreau", ground)] {
            let run = |step: f64| format!("step = {step}\nmethod = \"{method}\"\n{more}");
            let text = |step| on_a_spring(&holder, (to, "fixed = [1]\n"), &run(step));
            let (who, told) = refused(&text(1e-2));
            assert!(who == "holder" && (told / limit - 1.0).abs() < 1e-3, "{to}, {method}: {who}, {told}");
            // The amplitude of the motion itself is 3.2 um, at 95 % of the limit by this method 10 um.
            let stays = reach(&text(0.95 * limit), 0.95 * limit, 2000);
            assert!(stays < 2e-5, "{to}, {method}: {stays} m");
            let grows = reach(&text(0.95 * limit), 1.2 * limit, 12);
            assert!(grows > 1e-2, "{to}, {method}: {grows} m");
        }
    }
}

/// Without springs, and with springs so weak that they do not matter: h = 2 m/c at a node on a fixed damper or in air,
/// half of it between two nodes.
#[test]
fn dampers_and_drag_alone_limit_the_step() {
    let spring = |more: &str| format!("points = [[0, 0, 2], [0, 0, 3]]\nsprings = [[0, 1]]\n{more}");
    let cases = [
        ("points = [[0, 0, 2]]\nsprings = []\nair_drag = 5\n".to_owned(), 4e-4),
        (spring("K = 0\nC = 5\nfixed = [1]\n"), 4e-4),
        (spring("K = 1e-12\nC = 5\nfixed = [1]\n"), 4e-4),
        (spring("K = 1e-12\nC = 5\n"), 2e-4),
    ];
    for (part, limit) in cases {
        let text = |step: f64| {
            format!("format = 2\n[parts.lump]\n{part}mass = 0.001\n[run]\nseconds = 0.02\nstep = {step}\n")
        };
        let (who, told) = refused(&text(1e-2));
        assert!(who == "lump" && (told / limit - 1.0).abs() < 1e-3, "{who}: {told}\n{part}");
        assert!(engine(&read(&text(0.99 * limit))).is_ok(), "{part}");
    }
}

/// A ball and a node on one spring are faster than either alone: w^2 = k/m + k/M.
#[test]
fn a_node_and_what_holds_the_other_end_of_its_spring_are_judged_together() {
    for grams in [5.0, 20.0, 200.0] {
        let limit = 2.0 / (1e5_f64 * (1.0 / 0.01 + 1e3 / grams)).sqrt();
        let run = |step: f64| format!("step = {step}\nmethod = \"verlet\"\n");
        let text = |step| on_a_spring(&ball(grams), ("holder", ""), &run(step));
        let (who, told) = refused(&text(1.01 * limit));
        assert!(who == "holder" && (told / limit - 1.0).abs() < 1e-3, "{grams} g: {who}, {told}");
        assert!(engine(&read(&text(0.99 * limit))).is_ok());
    }
}

/// Nothing is refused where what holds the nodes is heavy, or where springs are carried along by one port.
#[test]
fn what_is_held_by_heavy_parts_is_judged_as_before() {
    let stiff =
        on_a_spring(&ball(10.0), ("holder", ""), "step = 1e-3\n").replace("nodes = [0]", "nodes = [0, 1]");
    assert!(engine(&read(&stiff)).is_ok());
    let heavy = on_a_spring(&ball(1e5), ("holder", ""), "step = 6.3e-4\n");
    assert!(engine(&parse(&heavy).expect("a world")).is_ok());
}
