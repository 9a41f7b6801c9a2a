//! Flexible parts on their carriers, without contacts.

use super::rigid::G;
use super::support::{fails, json, number, rows, scene, settled};

#[test]
fn a_mass_on_spring_and_damper_swings_as_its_closed_form() {
    let done = json(&["damper_mass_fixed_end"]);
    let (m, k, c, t) = (0.5_f64, 50.0_f64, 0.8_f64, 3.0_f64);
    // Stretch beyond the equilibrium m g/k, from 0.1 m; x'' = -(k/m) x - (c/m) x'.
    let (rest, decay) = (m * G / k, c / (2.0 * m));
    let w = (k / m - decay * decay).sqrt();
    let amplitude = 0.1 - rest;
    let stretch = rest + amplitude * (-decay * t).exp() * ((w * t).cos() + decay / w * (w * t).sin());
    let z = number(&done["last"]["mass.z1"]);
    assert!((z - (0.1 - stretch)).abs() < 1e-9, "{z} against {}", 0.1 - stretch);
    assert!(number(&done["imbalance"]).abs() < 1e-9, "{}", done["imbalance"]);
}

#[test]
fn a_loop_hung_up_comes_to_rest_below_its_point() {
    let done = json(&["closed_loop_hung"]);
    let last = |name: &str| number(&done["last"][format!("loop.{name}")]);
    assert!(number(&done["last"]["kinetic"]) < 1e-9, "{}", done["last"]["kinetic"]);
    // At rest the weights' moment about A vanishes, and the two springs at A carry both weights.
    assert!((last("x1") + last("x2")).abs() < 1e-4, "{} {}", last("x1"), last("x2"));
    let lift = |node: usize| {
        let [x, z] = [last(&format!("x{node}")), last(&format!("z{node}"))];
        let length = x.hypot(z);
        5000.0 * (length - 1.0) * -z / length
    };
    assert!((lift(1) + lift(2) - 2.0 * G).abs() < 1e-3, "{}", lift(1) + lift(2));
}

#[test]
fn a_bladder_does_not_feel_that_its_tile_moves_on_at_one_speed() {
    let run = |law: &str| {
        let command = format!("parts.tile.command={{ hA = \"{law}\", hB = \"{law}\", hC = \"{law}\" }}");
        json(&["tile_with_bladder", "--set", &command, "--seconds", "0.1"])
    };
    let (still, moved) = (run("0_m*t/1_s"), run("0.1_m*t/1_s"));
    for node in [0, 24, 48] {
        for (axis, way) in [("x", 0.0), ("y", 0.0), ("z", 0.01)] {
            let name = format!("bladder.{axis}{node}");
            let (a, b) = (number(&still["last"][&name]), number(&moved["last"][&name]));
            assert!((b - a - way).abs() < 1e-10, "{name}: {a} {b}");
        }
    }
    // It has swollen, or nothing was tried.
    assert!(number(&still["last"]["bladder.z24"]) > 0.0505, "{}", still["last"]["bladder.z24"]);
}

#[test]
fn the_accounts_of_a_carried_bladder_close_to_the_order_of_the_method() {
    for scene in ["tile_with_bladder", "tile_bladder_coupled"] {
        let imbalance =
            |step: &str| number(&json(&[scene, "--step", step, "--seconds", "0.2"])["imbalance"]).abs();
        let (coarse, fine) = (imbalance("4e-4"), imbalance("2e-4"));
        assert!(coarse < 5e-5 && fine < coarse / 8.0, "{scene}: {coarse:e} {fine:e}");
    }
}

#[test]
fn a_settled_loop_hangs_where_its_run_comes_to_rest() {
    let rest = settled(&["closed_loop_hung"]);
    assert!(number(&rest["acceleration"]) < 1e-8, "{}", rest["acceleration"]);
    let last = |name: &str| number(&rest["last"][format!("loop.{name}")]);
    let lift = |node: usize| {
        let [x, z] = [last(&format!("x{node}")), last(&format!("z{node}"))];
        let length = x.hypot(z);
        5000.0 * (length - 1.0) * -z / length
    };
    assert!((lift(1) + lift(2) - 2.0 * G).abs() < 1e-7, "{}", lift(1) + lift(2));
    assert!((last("x1") + last("x2")).abs() < 1e-9);
    // A run that begins there stays there.
    let stays = json(&["closed_loop_hung", "--set", "run.start=settled", "--seconds", "2"]);
    for name in ["x1", "z1", "x2", "z2"] {
        let moved = number(&stays["last"][format!("loop.{name}")]) - last(name);
        assert!(moved.abs() < 1e-9, "{name}: {moved:e}");
    }
}

#[test]
fn gas_and_membrane_carry_the_weight_of_a_settled_bladder() {
    let rest = settled(&["tile_with_bladder"]);
    let last = |name: &str| number(&rest["last"][format!("bladder.{name}")]);
    // Sealed air: p V^n as filled in.
    let (gauge, volume) = (last("gauge"), last("volume"));
    let filled = (101_325.0 + 1000.0) * (volume_at_rest()).powf(1.4);
    assert!(((101_325.0 + gauge) * volume.powf(1.4) / filled - 1.0).abs() < 1e-12, "{gauge} {volume}");
    assert!(number(&rest["acceleration"]) < 1e-8 && last("top") > 0.05, "{rest}");
}

/// Volume of the flat cell of tile_with_bladder: a square of 0.28 m without the outer halves of its four corner cells.
fn volume_at_rest() -> f64 {
    let cell = 0.28 / 8.0_f64;
    0.04 * (0.28 * 0.28 - 4.0 * 0.5 * cell * cell)
}

#[test]
fn every_method_of_a_world_comes_to_the_same_motion() {
    let last = |method: &str, step: &str| {
        json(&["damper_mass_fixed_end", "--seconds", "0.2", "--method", method, "--step", step])["last"]
            .clone()
    };
    let exact = last("rk4", "2e-5");
    for (method, step, error) in [
        ("verlet", "2e-4", 1e-6),
        ("implicit_midpoint", "2e-4", 1e-6),
        ("blanes_moan4", "2e-4", 1e-6),
        ("rk4", "2e-4", 1e-9),
        ("semi-implicit", "2e-4", 1e-3),
    ] {
        let seen = last(method, step);
        for (name, value) in exact.as_object().expect("a row").iter().filter(|(name, _)| name.contains(".z"))
        {
            let apart = (number(value) - number(&seen[name])).abs();
            assert!(apart < error, "{method} {name}: {apart:e}");
        }
    }
    let said = fails(&["run", "damper_mass_fixed_end", "--method", "verlett"]);
    assert!(said.contains("there is no such method for worlds") && said.contains("verlet"), "{said}");
}

/// Three heights in motion, each its own: the rim lies in a plane parallel to that through the three connectors.
#[test]
fn a_tile_whose_three_heights_are_commanded_carries_its_rim_along() {
    let laws = [("hA", 10.0), ("hB", 8.0), ("hC", 12.0)];
    let command = laws.map(|(name, mm)| format!("{name} = \"{mm}_mm*(1 - cos(2*pi*t/1_s))\"")).join(", ");
    let command = format!("parts.tile.command={{ {command} }}");
    let (names, rows) = rows(&["tile_with_bladder", "--set", &command, "--seconds", "0.5"]);
    let (first, last) = (&rows[0], rows.last().expect("rows"));
    let node = |row: &[f64], n: usize| {
        ["x", "y", "z"].map(|axis| {
            let name = format!("bladder.{axis}{n}");
            row[names.iter().position(|known| *known == name).expect("a node")]
        })
    };
    // Three corners of the rim, which is level at the start.
    let count = names.iter().filter(|name| name.starts_with("bladder.z")).count();
    let rim: Vec<usize> = (0..count).filter(|n| (node(first, *n)[2] - 0.05).abs() < 1e-12).collect();
    let corner = |along: [f64; 2]| {
        let far = |n: &usize| along[0] * node(first, *n)[0] + along[1] * node(first, *n)[1];
        *rim.iter().max_by(|a, b| far(a).total_cmp(&far(b))).expect("a rim")
    };
    let corners = [corner([-1.0, -1.0]), corner([1.0, -1.0]), corner([-1.0, 1.0])].map(|n| node(last, n));
    let screws = laws.map(|(name, mm)| {
        let azimuth = match name {
            "hA" => 90.0_f64,
            "hB" => 210.0,
            _ => 330.0,
        }
        .to_radians();
        [0.2 * azimuth.cos(), 0.2 * azimuth.sin(), 2e-3 * mm]
    });
    let normal = |[a, b, c]: [[f64; 3]; 3]| {
        let [u, v] = [b, c].map(|p| [0, 1, 2].map(|i| p[i] - a[i]));
        let cross = [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]];
        let length = cross.iter().map(|x| x * x).sum::<f64>().sqrt().copysign(cross[2]);
        cross.map(|x| x / length)
    };
    let (found, expected) = (normal(corners), normal(screws));
    println!("{found:?} {expected:?}");
    assert!(
        expected[0].abs() > 1e-2 && (0..3).all(|i| (found[i] - expected[i]).abs() < 1e-9),
        "{found:?} {expected:?}"
    );
}

/// The start as the manual says it: `tilt` is a turn about -y, free nodes begin as if fixed in what carries them.
#[test]
fn flexible_parts_start_tilted_and_in_motion_as_the_manual_says() {
    let rod = "points = [[0, 0, 0], [2, 0, 0]]\nsprings = [[0, 1]]\nK = 1\nmass = 3\n";
    let (tilt, [w, v]) = (0.3_f64, [1.5, 0.5]);
    let text = format!(
        "format = 2\ngravity = [0, 0, 0]\n[parts.rod]\n{rod}start = {{ tilt = {tilt}, velocity = [0, {v}, 0] }}\n\
         attach = [{{ nodes = [0], to = \"box\" }}]\n\
         [parts.box]\nrigid = \"box\"\nsize = [1, 1, 1]\nmass = 6\nstart = {{ axis = [0, 1, 0], angle = -0.2, spin = [0, 0, {w}] }}\n\
         [run]\nseconds = 1e-3\n"
    );
    let (names, rows) = rows(&[&scene("tilted", &text)]);
    let first = |name: &str| rows[0][names.iter().position(|own| own == name).expect("a column")];
    // Both turns lift what lies at x > 0: they add up.
    let [x, z] = [2.0 * (tilt + 0.2).cos(), 2.0 * (tilt + 0.2).sin()];
    let [far_x, far_z] = [first("rod.x1"), first("rod.z1")];
    assert!((far_x - x).abs() < 1e-14 && (far_z - z).abs() < 1e-14, "{far_x} {far_z}");
    // A cube has the same moment about any axis; the free node moves along y only.
    let kinetic = 0.5 * (w * w + 3.0 * (w * x + v).powi(2));
    assert!((first("kinetic") - kinetic).abs() < 1e-13, "{} {kinetic}", first("kinetic"));
}

/// A damper between a ball and a node that is fixed in space: v = v0 exp(-C t/m). The node took the speed that the ball
/// had at the start, since both belong to one part.
#[test]
fn a_fixed_node_of_a_part_that_is_carried_stands_still() {
    let text = "format = 2\ngravity = [0, 0, 0]\n[parts.ball]\nrigid = \"sphere\"\nradius = 0.1\nmass = 1\n\
        start = { velocity = [1, 0, 0] }\n[parts.s]\npoints = [[0, 0, 0], [1, 0, 0]]\nsprings = [[0, 1]]\nK = 0\n\
        C = 2\nfixed = [1]\nattach = [{ nodes = [0], to = \"ball\" }]\n[run]\nseconds = 0.5\n";
    let file = scene("still", text);
    for method in ["rk4", "verlet", "implicit_midpoint", "energy_momentum"] {
        let done = json(&[&file, "--method", method]);
        let v = number(&done["last"]["ball.vx"]);
        assert!((v - (-1.0_f64).exp()).abs() < 1e-4, "{method}: {v}");
        let start = number(&done["total_at_start"]);
        assert!((start - 0.5).abs() < 1e-14, "{method}: {start}");
    }
}

/// A closed sheet that is tilted is the same body, turned: its base lies below it, not below the horizon.
#[test]
fn a_closed_sheet_is_tilted_as_a_whole() {
    let bladder = |tilt: &str| {
        let text = format!(
            "format = 2\ngravity = [0, 0, 0]\n[parts.b]\nshape = \"sheet\"\nrows = 2\ncolumns = 2\nwidth = 0.3\ndepth = 0.3\n\
             base = \"100_mm\"\nstart = {{ tilt = {tilt} }}\ngas = {{ gauge = 100 }}\n[run]\nseconds = 0.01\n"
        );
        json(&[&scene("tilted_bladder", &text)])["last"].clone()
    };
    let level = number(&bladder("0")["b.volume"]);
    for tilt in ["\"60_deg\"", "\"100_deg\"", "-2"] {
        let volume = number(&bladder(tilt)["b.volume"]);
        assert!((volume / level - 1.0).abs() < 1e-12, "{tilt}: {volume} for {level}");
    }
}

/// Numbers of facets hold their corners; they were taken for numbers of nodes.
#[test]
fn facets_are_attached_by_all_their_corners() {
    let cube = |held: &str| {
        let text = format!(
            "format = 2\n[parts.w]\nrigid = \"box\"\nsize = [1, 1, 1]\nfixed = true\n[parts.c]\nshape = \"cube\"\nside = 0.2\n\
             K = 500\nmass = 0.1\nattach = [{{ {held}, to = \"w\" }}]\n[run]\nseconds = 0.1\n"
        );
        scene("held_cube", &text)
    };
    // The first two facets of a cube lie opposite: all eight corners are held.
    let held = json(&[&cube("facets = [0, 1]")]);
    assert!(number(&held["total"]).abs() < 20.0 && number(&held["last"]["kinetic"]) == 0.0, "{held}");
    assert!(number(&json(&[&cube("nodes = [0, 1]")])["last"]["kinetic"]) > 0.01);
    assert!(fails(&["run", &cube("facets = [9]")]).contains("`facets` must be numbers of facets"));
    assert!(fails(&["run", &cube("nodes = []")]).contains("there are none"));
}
