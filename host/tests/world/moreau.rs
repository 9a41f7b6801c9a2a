//! Time-stepping without splitting: its order where nothing touches.

use super::support::{json, number, rows, scene};

/// A mechanism with Coriolis forces and a damper, and a damped bladder that a commanded tile shakes, below a ball that
/// does not come down in time.
const APART: &str = "format = 2\n[parts.pendulum]\nmechanism = \"double_pendulum\"\n\
    [parts.tile]\nmechanism = \"tile_minimal\"\n\
    command = { hA = \"5_mm*(1 - cos(4*pi*t/1_s))\", hB = \"5_mm*(1 - cos(5*pi*t/1_s))\", hC = \"5_mm*(1 - cos(7*pi*t/1_s))\" }\n\
    [parts.bladder]\nshape = \"sheet\"\nrows = 4\ncolumns = 4\nwidth = \"0.28_m\"\ndepth = \"0.28_m\"\nbase = \"40_mm\"\n\
    mass = \"40_g\"\nK = \"2 kN/m\"\nC = \"5 N s/m\"\nair_drag = \"0.1 N s/m\"\n\
    start = { position = [\"-0.14_m\", \"-0.14_m\", \"50_mm\"] }\ngas = { gauge = \"0.3_kPa\" }\n\
    attach = [{ nodes = \"rim\", to = \"tile.platform\" }, { facets = \"base\", to = \"tile.platform\" }]\n\
    [parts.ball]\nrigid = \"sphere\"\nradius = \"0.2_m\"\nmass = \"5_kg\"\nstart = { position = [0, 0, \"2_m\"] }\n\
    [[contacts]]\nbetween = [\"ball\", \"bladder\"]\nimpact = \"moreau\"\n[run]\nseconds = 0.16\nstep = 4e-4\n";

#[test]
fn a_step_is_of_order_two_under_forces_of_speeds() {
    let file = scene("moreau_apart", APART);
    let last = |step: &str| {
        let done = json(&[&file, "--step", step]);
        let of = |name: &str| number(&done["last"][name]);
        assert!(of("ball.z") > 1.8, "nothing touches");
        (0..16)
            .map(|node| of(&format!("bladder.z{node}")))
            .chain(["q1", "q2"].map(|q| of(&format!("pendulum.{q}"))))
            .collect::<Vec<_>>()
    };
    let ends = ["4e-4", "2e-4", "1e-4"].map(last);
    for part in [0..16, 16..18] {
        let [coarse, fine] = [0, 1].map(|k| {
            let pairs = ends[k][part.clone()].iter().zip(&ends[k + 1][part.clone()]);
            pairs.map(|(a, b)| (a - b).powi(2)).sum::<f64>().sqrt()
        });
        let order = (coarse / fine).log2();
        println!("{part:?}: {coarse:.1e} {fine:.1e}, order {order:.2}");
        assert!((1.9..2.1).contains(&order), "{part:?}: {coarse} {fine}, order {order}");
    }
}

/// What is near and not touched changes nothing, to the bit: a damped spring that slides past the ground, and a damped
/// slider whose ball stays a millimetre from a wall.
#[test]
fn what_is_near_and_untouched_changes_no_bit() {
    let slider = "format = 1\nname = \"slider\"\n[coordinates]\nx = { unit = \"m\" }\n[points]\nP = \"x*N.x\"\n\
        [bodies]\nb = { centre = \"P\", mass = \"2_kg\" }\n[springs]\ns = { coordinate = \"x\", stiffness = 200, damping = 4 }\n\
        [ports]\ntool = { point = \"P\", frame = \"N\" }\n[start]\nu_x = 0.5\n";
    scene("moreau_slider", slider);
    let spring = |gap: f64| {
        format!(
            "[parts.wall]\nrigid = \"half_space\"\nstart = {{ position = [0, 0, -{gap}] }}\n\
             [parts.part]\npoints = [[0, 0, 0], [1, 0, 0]]\nsprings = [[0, 1]]\nrest_lengths = [0.8]\nmass = 1\nK = 100\nC = 2\n\
             start = {{ velocity = [0.5, 0.3, 0] }}\n"
        )
    };
    let ball = |gap: f64| {
        format!(
            "[parts.wall]\nrigid = \"box\"\nsize = [1, 1, 1]\nfixed = true\nstart = {{ position = [0, {}, 0] }}\n\
             [parts.slider]\nmechanism = \"moreau_slider\"\n[parts.part]\nrigid = \"sphere\"\nradius = \"50_mm\"\non = \"slider.tool\"\n",
            0.55 + gap
        )
    };
    for (name, world, state) in [
        ("spring", &spring as &dyn Fn(f64) -> String, &["part.x0", "part.x1", "part.y1"][..]),
        ("ball", &ball, &["slider.x"]),
    ] {
        let ends = [1e-3, 10.0].map(|gap| {
            let text = format!(
                "format = 2\ngravity = [0, 0, 0]\n{}[[contacts]]\nbetween = [\"part\", \"wall\"]\nimpact = \"moreau\"\n[run]\nseconds = 0.3\nstep = \"2_ms\"\n",
                world(gap)
            );
            let done = json(&[&scene(&format!("moreau_near_{name}_{gap}"), &text)]);
            assert_eq!(number(&done["last"]["part-wall.points"]), 0.0, "{name}: nothing touches");
            state.iter().map(|of| number(&done["last"][of])).collect::<Vec<_>>()
        });
        assert_eq!(ends[0], ends[1], "{name}");
    }
}

/// A ball rolls on a plate that a command shakes: 2/7 of the plate's way (solid ball), and no sweep over its one
/// contact is said not to have converged, though their speeds relative to each other are far below their own.
#[test]
fn a_ball_that_rolls_on_a_shaken_plate_converges() {
    let shaken = "format = 1\nname = \"shaken\"\n[coordinates]\nx = { unit = \"m\" }\n[points]\nP = \"x*N.x\"\n\
        [bodies]\nb = { centre = \"P\", mass = \"2_kg\" }\n[ports]\ntop = { point = \"P\", frame = \"N\" }\n";
    scene("moreau_shaken", shaken);
    let text = "format = 2\n[parts.shaker]\nmechanism = \"moreau_shaken\"\ncommand = { x = \"0.3_m*(1 - cos(5*t/1_s))\" }\n\
        [parts.plate]\nrigid = \"box\"\nsize = [8, 8, 0.2]\non = \"shaker.top\"\nstart = { position = [0, 0, -0.1] }\n\
        [parts.ball]\nrigid = \"sphere\"\nradius = 0.145\nmass = 0.67\nstart = { position = [0.2, 0.1, 0.145] }\n\
        [[contacts]]\nbetween = [\"ball\", \"plate\"]\nimpact = \"moreau\"\nfriction = 2\n[run]\nseconds = 1\nstep = 2e-4\n";
    let done = json(&[&scene("moreau_rolls", text)]);
    let warnings = done["warnings"].as_array().map_or(0, Vec::len);
    assert_eq!(warnings, 0, "{}", done["warnings"]);
    let way = number(&done["last"]["ball.x"]) - 0.2;
    let expected = 2.0 / 7.0 * 0.3 * (1.0 - 5.0_f64.cos());
    assert!((way - expected).abs() < 1e-6, "{way}, expected {expected}");
}

/// Redundant contacts with friction under a load 500 times as heavy.
#[test]
fn a_heavy_plate_stays_on_three_light_balls() {
    let mut text = "format = 2\n[parts.ground]\nrigid = \"half_space\"\n[parts.plate]\nrigid = \"box\"\n\
                    size = [0.4, 0.4, 0.02]\nmass = 10\nstart = { position = [0, 0, 0.05] }\n"
        .to_owned();
    for (k, [x, y]) in [[0.1, 0.1], [-0.1, 0.1], [0.0, -0.12]].into_iter().enumerate() {
        text += &format!(
            "[parts.ball{k}]\nrigid = \"sphere\"\nradius = 0.02\nmass = 0.02\nstart = {{ position = [{x}, {y}, 0.02] }}\n"
        );
        for pair in [format!("\"ground\", \"ball{k}\""), format!("\"ball{k}\", \"plate\"")] {
            text += &format!("[[contacts]]\nbetween = [{pair}]\nimpact = \"moreau\"\nfriction = 0.3\n");
        }
    }
    let file = scene("moreau_plate_on_balls", &(text + "[run]\nseconds = 1\nstep = \"1_ms\"\n"));
    let done = json(&[&file, "--strict"]);
    let [y, z] = ["plate.y", "plate.z"].map(|name| number(&done["last"][name]));
    assert!((z - 0.05).abs() < 1e-9 && y.abs() < 1e-9, "{y} {z}");
}

/// Four corners of a plate that can only rise and sink stand on the ground, and a box with friction on it: impulses fit
/// in more than one way. It was shot away.
#[test]
fn a_box_at_rest_on_a_guided_plate_stays_there() {
    let guided = "format = 1\nname = \"guided\"\ngravity = \"-g*N.z\"\n[parameters]\nm = { value = 2, unit = \"kg\" }\n\
        g = { value = 9.81, unit = \"m/s^2\" }\n[coordinates]\nz = { unit = \"m\" }\n[points]\nC = \"z*N.z\"\n\
        [bodies]\nb = { centre = \"C\", mass = \"m\" }\n[ports]\np = { frame = \"N\", point = \"C\" }\n";
    scene("moreau_guided", guided);
    let text = "format = 2\n[parts.ground]\nrigid = \"half_space\"\n[parts.lift]\nmechanism = \"moreau_guided\"\n\
        start = { z = \"50_mm\" }\n[parts.plate]\nrigid = \"box\"\nsize = [1, 1, 0.1]\non = \"lift.p\"\n[parts.box]\n\
        rigid = \"box\"\nsize = [0.1, 0.1, 0.1]\nmass = 1\nstart = { height = 0.1 }\n[[contacts]]\n\
        between = [\"plate\", \"ground\"]\nimpact = \"moreau\"\n[[contacts]]\nbetween = [\"box\", \"plate\"]\n\
        impact = \"moreau\"\nfriction = 0.6\n[run]\nseconds = 2\nstep = \"1_ms\"\n";
    for step in ["1e-3", "2e-4"] {
        let (names, rows) = rows(&[&scene("moreau_on_guided", text), "--step", step]);
        let column = |name: &str| names.iter().position(|own| own == name).expect("a column");
        let largest = |name: &str| rows.iter().fold(0.0_f64, |most, row| most.max(row[column(name)].abs()));
        let [speed, lost] = ["box.vz", "impact"].map(largest);
        assert!(speed < 1e-10 && lost < 1e-12, "step {step}: {speed:e} m/s, {lost:e} J");
    }
}

/// Bounces need a speed: boxes that stand on each other rest with e > 0 as with e = 0, though gaps of their corners are
/// rounding, here above and there below 0.
#[test]
fn boxes_with_restitution_rest_where_they_stand() {
    let law = "impact = \"moreau\"\nfriction = 0.4\nrestitution = 0.5\n";
    let text = format!(
        "format = 2\n[parts.ground]\nrigid = \"half_space\"\n[parts.lower]\nrigid = \"box\"\nsize = [0.5, 0.5, 0.1]\nmass = 2\n\
         start = {{ height = 0 }}\n[parts.upper]\nrigid = \"box\"\nsize = [0.2, 0.2, 0.111]\nmass = 1\nstart = {{ height = 0.1 }}\n\
         [[contacts]]\nbetween = [\"lower\", \"ground\"]\n{law}[[contacts]]\nbetween = [\"upper\", \"lower\"]\n{law}\
         [run]\nseconds = 0.5\nstep = \"1_ms\"\n"
    );
    let file = scene("moreau_restitution_at_rest", &text);
    for method in ["moreau", "energy_momentum"] {
        let (names, rows) = rows(&[&file, "--method", method]);
        for name in ["upper.z", "lower.z", "impact", "friction", "kinetic"] {
            let column = names.iter().position(|own| own == name).expect("a column");
            let moved =
                rows.iter().fold(0.0_f64, |most, row| most.max((row[column] - rows[0][column]).abs()));
            assert!(moved < 1e-13, "{method}: {name} moves by {moved:e}");
        }
    }
}
