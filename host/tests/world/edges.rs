//! What slides or rolls off an edge, bounces that die out within the rounding of the gap, and fixed nodes on the
//! ground.

use super::support::{json, number, rows, scene};

/// A fixed part far away: with it contacts are those of any parts, without it those of rigid parts alone.
const FAR: &str = "[parts.far]\npoints = [[5, 0, 20], [6, 0, 20]]\nsprings = [[0, 1]]\nfixed = [0, 1]\n";

/// Last values of a run without warnings.
fn last(name: &str, text: &str) -> serde_json::Value {
    let done = json(&[&scene(&format!("edges_{name}"), text)]);
    assert!(done["warnings"].as_array().expect("a list").is_empty(), "{name}: {}", done["warnings"]);
    done["last"].clone()
}

#[test]
fn a_ball_that_slides_over_an_edge_falls_from_there() {
    for (other, bar) in [("", 1e-12), (FAR, 1e-6)] {
        for step in ["1e-3", "2.7e-4"] {
            let text = format!(
                "format = 2\n[parts.table]\nrigid = \"box\"\nsize = [0.2, 0.2, 0.1]\nfixed = true\n[parts.ball]\n\
                 rigid = \"sphere\"\nradius = 0.1\nmass = 1\nstart = {{ position = [-0.0521, 0, 0.15], velocity = [3, 0, 0] }}\n\
                 {other}[[contacts]]\nbetween = [\"ball\", \"table\"]\nimpact = \"plastic\"\n\
                 [run]\nseconds = 0.1\nstep = {step}\n"
            );
            let last = last(&format!("ball_{bar}_{step}"), &text);
            let falls = 0.1 - (0.1 + 0.0521) / 3.0;
            let exact =
                [("ball.z", 0.15 - 0.5 * 9.81 * falls * falls), ("ball.vz", -9.81 * falls), ("ball.vx", 3.0)];
            for (name, value) in exact {
                assert!((number(&last[name]) - value).abs() < bar, "{step}: {name} {} {value}", last[name]);
            }
        }
    }
}

#[test]
fn a_node_that_rubs_over_an_edge_keeps_its_speed() {
    for (law, method) in [("plastic", "rk4"), ("stronge", "verlet"), ("compensation", "implicit_midpoint")] {
        for mu in [1e-6, 0.2] {
            let law_of =
                if law == "stronge" { "\"stronge\"\nrestitution = 0.5" } else { &format!("\"{law}\"") };
            let text = format!(
                "format = 2\n[parts.table]\nrigid = \"box\"\nsize = [1, 1, 1]\nfixed = true\n[parts.node]\n\
                 points = [[0.2113, 0, 0.5]]\nsprings = []\nmass = 1\nstart = {{ velocity = [1.5, 0, 0] }}\n\
                 [[contacts]]\nbetween = [\"node\", \"table\"]\nimpact = {law_of}\nfriction = {mu}\n\
                 [run]\nmethod = \"{method}\"\nseconds = 0.5\nstep = 1e-3\n"
            );
            let last = last(&format!("node_{law}_{mu}"), &text);
            let v = (1.5_f64 * 1.5 - 2.0 * mu * 9.81 * (0.5 - 0.2113)).sqrt();
            let x = 0.5 + v * (0.5 - (1.5 - v) / (mu * 9.81));
            let off = number(&last["node.x0"]) - x;
            assert!(off.abs() < 1e-8, "{law}, {mu}: {off:e}");
        }
    }
}

#[test]
fn a_box_that_slides_off_a_table_turns_about_its_edge_alone() {
    let box_off = |name: &str, (v, mu): (f64, f64), (other, step): (&str, f64)| {
        let text = format!(
            "format = 2\n[parts.table]\nrigid = \"box\"\nsize = [1, 1, 1]\nfixed = true\n[parts.box]\nrigid = \"box\"\n\
             size = [0.2, 0.1, 0.06]\nmass = 1\nstart = {{ position = [0.3123, 0, 0.53], velocity = [{v}, 0, 0] }}\n\
             {other}[[contacts]]\nbetween = [\"box\", \"table\"]\nimpact = \"plastic\"\nfriction = {mu}\n\
             [run]\nseconds = 0.9\nstep = {step}\n"
        );
        last(&format!("{name}_{v}_{mu}"), &text)
    };
    // These lost their speed as their last corner passed the edge, one of the 75 per column of a grid.
    for start in [(1.1, 0.0), (1.2, 0.1), (1.5, 0.3), (1.7, 0.5), (2.0, 0.5)] {
        let (rigid, any) = (box_off("rigid", start, ("", 1e-3)), box_off("any", start, (FAR, 2e-4)));
        for name in ["box.x", "box.z", "box.wy"] {
            let apart = number(&rigid[name]) - number(&any[name]);
            assert!(
                apart.abs() < 1e-4 * number(&any[name]).abs(),
                "{start:?}: {name} {} {}",
                rigid[name],
                any[name]
            );
        }
        for name in ["box.wx", "box.wz"] {
            assert!(number(&rigid[name]).abs() < 1e-9, "{start:?}: {name} {}", rigid[name]);
        }
        assert!(number(&rigid["imbalance"]).abs() < 1e-5, "{start:?}: {}", rigid["imbalance"]);
    }
}

#[test]
fn bounces_within_the_rounding_of_the_gap_come_to_rest() {
    // A step so short, or a place so far out, that a bounce ends before it leaves that gap; it sank in, bounce by
    // bounce.
    for (x, height, step, seconds) in [(0.0, 1e-5, "1e-6", 0.05), (1000.0, 1e-3, "1e-4", 0.5)] {
        for (name, other) in [("rigid", ""), ("any", FAR)] {
            for e in [0.2, 0.5, 0.7] {
                let text = format!(
                    "format = 2\n[parts.ground]\nrigid = \"half_space\"\n[parts.ball]\nrigid = \"sphere\"\nradius = 0.1\nmass = 1\n\
                     start = {{ position = [{x}, 0, 0], height = {height} }}\n{other}\
                     [[contacts]]\nbetween = [\"ball\", \"ground\"]\nimpact = \"stronge\"\nrestitution = {e}\n\
                     [run]\nseconds = {seconds}\nstep = {step}\nevery = 1000\n"
                );
                let last = last(&format!("bounce_{x}_{name}_{e}"), &text);
                let deep = 0.1 - number(&last["ball.z"]);
                assert!(deep.abs() < 1e-8, "{name} at {x}, e = {e}: {deep:e} m deep");
                let force = number(&last["ball-ground.z"]);
                assert!((force - 9.81).abs() < 1e-6, "{name} at {x}, e = {e}: {force} N");
            }
        }
    }
}

#[test]
fn a_fixed_node_may_lie_on_the_ground() {
    for friction in [0.0, 0.3] {
        let text = format!(
            "format = 2\n[parts.ground]\nrigid = \"half_space\"\n[parts.body]\npoints = [[-1, 0, 0], [0.3, 0, 0]]\nfixed = [0]\n\
             springs = [[0, 1]]\nK = 50\nmass = 1\n[[contacts]]\nbetween = [\"body\", \"ground\"]\nimpact = \"plastic\"\n\
             friction = {friction}\n[run]\nseconds = 0.1\nstep = 1e-3\n"
        );
        let last = last(&format!("fixed_{friction}"), &text);
        assert_eq!((number(&last["body.x0"]), number(&last["body.x1"])), (-1.0, 0.3));
        assert!((number(&last["body-ground.z"]) - 9.81).abs() < 1e-9, "{}", last["body-ground.z"]);
    }
}

/// A bladder upside down, a ball at rest above the flat base, whose normals lean at the rim: it falls freely until it
/// touches, and is held only then.
#[test]
fn a_ball_at_rest_above_the_base_of_a_bladder_falls() {
    for (law, height) in [("plastic", 5.0_f64), ("stronge", 5.0), ("plastic", 1.0)] {
        let text = format!(
            "format = 2\n[parts.block]\nrigid = \"box\"\nsize = [0.01, 0.01, 0.01]\nfixed = true\n\
             start = {{ position = [0, 0, 0.2], axis = [0, 1, 0], angle = \"180_deg\" }}\n\
             [parts.bladder]\nshape = \"sheet\"\nrows = 3\ncolumns = 3\nwidth = \"0.2_m\"\ndepth = \"0.2_m\"\nbase = \"30_mm\"\n\
             mass = \"20_g\"\nK = \"1 kN/m\"\nC = \"0.5 N s/m\"\nstart = {{ position = [0.9, -0.1, 0.1] }}\n\
             gas = {{ gauge = \"0.5_kPa\", sealed = true }}\n\
             attach = [{{ nodes = \"rim\", to = \"block\" }}, {{ facets = \"base\", to = \"block\" }}]\n\
             [parts.ball]\nrigid = \"sphere\"\nradius = \"40_mm\"\nmass = \"0.1_kg\"\n\
             start = {{ position = [-1, 0, {z}] }}\n[[contacts]]\nbetween = [\"ball\", \"bladder\"]\nimpact = \"{law}\"\n\
             [run]\nseconds = 0.05\nstep = \"0.5_ms\"\n",
            z = 0.17 + 1e-3 * height
        );
        let (names, found) = rows(&[&scene(&format!("hovers_{law}_{height}"), &text)]);
        let column = |name: &str| names.iter().position(|own| own == name).expect("a column");
        let (z, force) = (column("ball.z"), column("ball-bladder.normal"));
        let lands = (2.0 * 1e-3 * height / 9.81).sqrt();
        for row in &found {
            let t = row[0];
            if t < lands - 1e-4 {
                let free = 0.17 + 1e-3 * height - 0.5 * 9.81 * t * t;
                assert!((row[z] - free).abs() < 1e-9 && row[force] == 0.0, "{law}, {t}: {row:?}");
            }
        }
        if law == "plastic" {
            let last = found.last().expect("a row");
            // Normals lean towards the rim: it begins to roll from the middle.
            let (off, force) = (last[z] - 0.17, last[force]);
            assert!(off.abs() < 3e-4 && (force - 0.981).abs() < 0.01, "{law}: {off}, {force}");
        }
    }
}
