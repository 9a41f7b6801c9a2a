//! Flexible parts and mechanisms in contact.

use super::rigid::G;
use super::support::{fails, json, number, rows, run, scene, settled, smartbed};
use std::path::Path;

/// A cube that falls on its edge, written in either format.
const CUBE: [&str; 2] = [
    "format = 1\ntitle = \"cube\"\nshape = \"cube\"\nside = 0.4\ndrop_height = 0.1\ntilt = 0.2\nK = 2000\nC = 0.5\nmass = 0.25\n\
     T = 0.5\nstep = 5e-4\nmethod = \"rk4\"\nevery = 100\n",
    "format = 2\n[parts.ground]\nrigid = \"half_space\"\n[parts.cube]\nshape = \"cube\"\nside = 0.4\nmass = 0.25\nK = 2000\nC = 0.5\n\
     start = { height = 0.1, tilt = 0.2 }\n[[contacts]]\nbetween = [\"cube\", \"ground\"]\nimpact = \"compensation\"\n\
     [run]\nseconds = 0.5\nstep = 5e-4\nevery = 100\n",
];

#[test]
fn a_cube_of_a_world_falls_as_that_of_a_scene_of_its_own() {
    let runs = [0, 1].map(|k| rows(&[&scene(&format!("cube{k}"), CUBE[k])]));
    let mut off = 0.0_f64;
    for node in 0..8 {
        for axis in ["x", "y", "z"] {
            let names = [format!("{axis}{node}"), format!("cube.{axis}{node}")];
            let [one, other] =
                [0, 1].map(|k| runs[k].0.iter().position(|n| *n == names[k]).expect("a column"));
            for (a, b) in runs[0].1.iter().zip(&runs[1].1) {
                assert!((a[0] - b[0]).abs() < 1e-12);
                off = off.max((a[one] - b[other]).abs());
            }
        }
    }
    println!("off by {off:e} m");
    assert!(runs[0].1.len() > 9 && off < 1e-9, "{off:e}");
}

#[test]
fn two_cubes_that_collide_keep_their_momentum_and_make_no_energy() {
    let (names, rows) = rows(&["two_cubes"]);
    let column = |name: &str| names.iter().position(|n| n == name).expect(name);
    let places = |axis: &str| -> Vec<usize> {
        let of = |part: &str| (0..8).map(|n| column(&format!("{part}.{axis}{n}"))).collect::<Vec<_>>();
        [of("left"), of("right")].concat()
    };
    // All masses are alike: the mean place goes on at half the speed of the one cube.
    for (axis, speed) in [("x", 0.5), ("y", 0.0), ("z", 0.0)] {
        let own = places(axis);
        let mean = |row: &Vec<f64>| own.iter().map(|k| row[*k]).sum::<f64>() / 16.0;
        for row in &rows {
            let off = mean(row) - mean(&rows[0]) - speed * row[0];
            assert!(off.abs() < 1e-12, "{axis} at {}: {off:e}", row[0]);
        }
    }
    let total = column("total");
    assert!(rows.iter().all(|row| row[total] <= rows[0][total] * (1.0 + 1e-9)), "energy is created");
    // They met: the left one is slower, the right one moves.
    let (first, last) = (&rows[0], rows.last().expect("rows"));
    let way = last[column("right.x0")] - first[column("right.x0")];
    assert!(way > 0.05, "{way}");
}

#[test]
fn flexible_cubes_stack_and_come_to_rest() {
    let done = json(&["stack_cubes"]);
    let last = |name: &str| number(&done["last"][name]);
    assert!(last("kinetic") < 1e-6, "{}", last("kinetic"));
    for (part, top) in [("lower", 0.2), ("middle", 0.38), ("upper", 0.54)] {
        let found = last(&format!("{part}.top"));
        assert!((found - top).abs() < 4e-3, "{part}: {found}");
    }
    let start = number(&done["total_at_start"]);
    assert!(number(&done["imbalance"]).abs() < 0.02 * start, "{}", done["imbalance"]);
}

#[test]
fn a_bladder_carries_a_plate_and_a_ball() {
    for load in ["plate", "ball"] {
        let scene = format!("{load}_on_bladder");
        let rest = |mass: f64| {
            let mass = format!("parts.{load}.mass={mass}");
            let contacts =
                format!("contacts=[{{ between = [\"{load}\", \"bladder\"], impact = \"moreau\" }}]");
            let rest = settled(&[&scene, "--set", &mass, "--set", &contacts]);
            assert!(number(&rest["acceleration"]) < 1e-8, "{rest}");
            let place = ["x", "y", "z"].map(|axis| number(&rest["last"][format!("{load}.{axis}")]));
            (number(&rest["total"]), place)
        };
        // Where the whole potential is least its change with the load's mass is g z, whatever carries it.
        let (less, more, (_, [x, y, z])) = (rest(0.98), rest(1.02), rest(1.0));
        let slope = (more.0 - less.0) / 0.04;
        assert!((slope / (G * z) - 1.0).abs() < 1e-3, "{load}: {slope} against {}", G * z);
        // In the middle of a symmetric sheet nothing moves it aside; more weight sinks deeper.
        assert!((x - 0.14).abs() < 1e-6 && (y - 0.14).abs() < 1e-6, "{load}: {x} {y}");
        assert!(more.1[2] < z && z < less.1[2], "{load}");
    }
}

#[test]
fn sweeps_over_contacts_come_to_their_end() {
    for scene in ["ball_on_tilted_bladder", "ball_on_bladder", "plate_on_bladder", "stack_cubes", "bed"] {
        let done = smartbed(&["run", scene]);
        let said = [done.stdout, done.stderr].map(|text| String::from_utf8(text).expect("text")).concat();
        assert!(said.contains("largest imbalance") && !said.contains("did not converge"), "{scene}: {said}");
    }
}

#[test]
fn an_arm_that_pushes_a_wall_balances_one_force() {
    let done = json(&["arm6_pushes_wall"]);
    let q: Vec<f64> = (0..6).map(|i| number(&done["last"][format!("arm.q{i}")])).collect();
    let u: Vec<f64> = (0..6).map(|i| number(&done["last"][format!("arm.u{i}")])).collect();
    assert!(u.iter().all(|u| u.abs() < 1e-5), "at rest: {u:?}");
    let file = Path::new(env!("CARGO_TARGET_TMPDIR")).join("arm6_states.json");
    let given: Vec<String> = q.iter().enumerate().map(|(i, q)| format!("\"q{i}\": {q:e}")).collect();
    std::fs::write(&file, format!("{{\"states\": [{{\"q\": {{{}}}}}]}}", given.join(", "))).expect("states");
    let file = file.display().to_string();
    let answer = |what: &str| -> serde_json::Value {
        let text = run(&["eval", "arm6", "--answers", what, "--states", &file]);
        serde_json::from_str::<serde_json::Value>(&text).expect("JSON")["states"][0][what].clone()
    };
    let (port, held) = (answer("port:tool"), answer("inverse_dynamics"));
    let pi = std::f64::consts::PI;
    let torque = [
        60.0 * (0.3 - q[0]),
        -8.65 - 400.0 * (q[1] + pi / 6.0),
        20.5 - 400.0 * (q[2] - pi / 3.0),
        -200.0 * q[3],
        -200.0 * q[4],
        -200.0 * q[5],
    ];
    // What the joints give beyond holding the arm is the wall's force, along x at the tool: T - hold = -J' F.
    let left = |i: usize| torque[i] - number(&held["generalised_force"][format!("u{i}")]);
    let along = |i: usize| number(&port["jacobian"][0][i]);
    let force = -left(0) / along(0);
    assert!(force > 5.0, "it pushes: {force} N");
    for i in 0..6 {
        assert!(
            (left(i) + force * along(i)).abs() < 1e-3 * force,
            "joint {i}: {} {}",
            left(i),
            force * along(i)
        );
    }
    // The tip touches the wall's face at x = -0.14 m.
    assert!((number(&port["position"]["x"]) - 0.05 + 0.14).abs() < 1e-5, "{}", port["position"]["x"]);
}

#[test]
fn a_ball_on_a_tilted_bladder_goes_downhill_and_rolls_if_there_is_friction() {
    let place = |friction: &str| {
        let contacts = format!(
            "contacts=[{{ between = [\"ball\", \"bladder\"], impact = \"moreau\", friction = {friction} }}]"
        );
        let done = json(&["ball_on_tilted_bladder", "--set", &contacts]);
        ["x", "y", "wx", "wy"].map(|name| number(&done["last"][format!("ball.{name}")]))
    };
    // Screw A stands along y and is lifted: downhill is -y, and rolling that way is a turn about +x.
    let ([x, y, wx, wy], [_, slid, spin, _]) = (place("0.5"), place("0"));
    assert!(y < -0.01 && x.abs() < 1e-3 * y.abs() && wx > 0.1 && wy.abs() < 1e-2 * wx, "{x} {y} {wx} {wy}");
    // Without friction nothing turns it, and it gets further.
    assert!(slid < y && spin.abs() < 1e-9, "{slid} {y} {spin}");
}

#[test]
fn the_bed_carries_a_ball() {
    let done = json(&["bed"]);
    let last = |name: &str| number(&done["last"][name]);
    assert_eq!(done["parts"].as_f64(), Some(57.0));
    assert!(last("ball.z") > 0.2 && last("ball.x").is_finite(), "{}", last("ball.z"));
    // The bladders farthest from the ball do not know of it and are alike.
    let [a, b] = ["bladder[6,0].top", "bladder[6,3].top"].map(last);
    assert!((a - b).abs() < 1e-9, "{a} {b}");
    // What the drives give moves tiles, bladders and ball; a step of order 1 at its touches misses little of it.
    let (missed, given) = (number(&done["imbalance"]), last("actuator"));
    assert!(given > 1.0 && missed.abs() < 1e-3 * given, "{missed} of {given}");
}

/// Scene of a part that falls into a valley of two facets at a right angle.
const IN_VALLEY: [&str; 2] = [
    "points = [[0, 0, 0], [0, 0.4, 0]]\nsprings = [[0, 1]]\nK = 1000\nC = 1\nmass = 1\n",
    "rigid = \"box\"\nsize = [0.2, 0.4, 0.2]\nmass = 2\n",
];

#[test]
fn a_fold_of_facets_holds_what_falls_into_it() {
    for (kind, body) in IN_VALLEY.iter().enumerate() {
        for (law, friction) in
            [("moreau", 0.0), ("moreau", 0.3), ("stronge", 0.0), ("stronge", 0.3), ("newton", 0.0)]
        {
            // Straight into the fold, and beside it; the box on an edge.
            for x in [0.0, 0.2] {
                let start = match kind {
                    0 => format!("start = {{ position = [{x}, 0.3, 0.5] }}\n"),
                    _ => format!(
                        "start = {{ position = [{x}, 0.5, 0.7], angle = 0.7853981633974483, axis = [0, 1, 0] }}\n"
                    ),
                };
                let text = format!(
                    "format = 2\n[parts.valley]\npoints = [[-1, 0, 1], [-1, 1, 1], [0, 0, 0], [0, 1, 0], [1, 0, 1], [1, 1, 1]]\n\
                     springs = [[0, 2], [2, 4], [1, 3], [3, 5]]\nfacets = [[0, 2, 3, 1], [2, 4, 5, 3]]\n\
                     fixed = [0, 1, 2, 3, 4, 5]\nmass = 1\n[parts.bar]\n{body}{start}\
                     [[contacts]]\nbetween = [\"bar\", \"valley\"]\nimpact = \"{law}\"\nfriction = {friction}\n\
                     [run]\nseconds = 2\nstep = 1e-3\nevery = 500\n"
                );
                let file = scene(&format!("valley_{kind}_{law}_{friction}_{x}"), &text);
                let done = json(&[&file]);
                let of = |name: &str| number(&done["last"][name]);
                let (across, height) = match kind {
                    0 => (of("bar.x0"), of("bar.z0")),
                    _ => (of("bar.x"), of("bar.z") - 0.1 * 2.0_f64.sqrt()),
                };
                let missed = number(&done["imbalance"]);
                println!("{kind} {law} mu {friction} from {x}: {across:.2e} {height:.2e}, {missed:e}");
                assert!(missed.abs() < 1e-7, "{kind} {law} {friction} from {x}: {missed:e} J");
                assert!(
                    across.abs() < 2e-3 && height.abs() < 2e-3,
                    "{kind} {law} {friction} from {x}: {across} {height}"
                );
            }
        }
    }
}

/// Scene of held facets in a plane: nodes, facets, a part on it, and seconds.
fn on_facets(name: &str, law: &str, (nodes, facets): (&str, &str), part: &str, seconds: f64) -> String {
    let held: Vec<usize> = (0..nodes.matches("], [").count() + 1).collect();
    let text = format!(
        "format = 2\n[parts.floor]\npoints = [{nodes}, [9, 9, 9]]\nfacets = [{facets}]\nsprings = [[0, {}]]\n\
         fixed = {held:?}\nmass = 1\n[parts.load]\n{part}\n\
         [[contacts]]\nbetween = [\"load\", \"floor\"]\nimpact = \"{law}\"\n\
         [run]\nseconds = {seconds}\nstep = 1e-3\n",
        held.len()
    );
    scene(&format!("{name}_{law}"), &text)
}

/// Laws, each as it is written in a scene.
const LAWS: [&str; 5] = ["moreau", "plastic", "stronge", "newton", "compensation"];

#[test]
fn a_ball_near_a_corner_of_a_facet_rests_on_it() {
    let floor = ("[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]", "[0, 1, 2, 3]");
    let ball = "rigid = \"sphere\"\nradius = 0.02\nmass = 1\nstart = { position = [0.1, 0.1, 0.0201] }";
    for law in LAWS {
        let done = json(&[&on_facets("near_corner", law, floor, ball, 0.5)]);
        let z = number(&done["last"]["load.z"]);
        println!("{law}: z {z}");
        // What rebounds stays below where it fell from.
        let elastic = matches!(law, "compensation" | "newton" | "stronge");
        let rests = (z - 0.02).abs() < 1e-6;
        assert!(rests || (elastic && 0.02 < z && z < 0.0202), "{law}: {z}");
    }
}

#[test]
fn a_box_slides_over_a_node_without_friction() {
    let floor = (
        "[-1, -1, 0], [0, -1, 0], [1, -1, 0], [-1, 0, 0], [0, 0, 0], [1, 0, 0], [-1, 1, 0], [0, 1, 0], [1, 1, 0]",
        "[0, 1, 4, 3], [1, 2, 5, 4], [3, 4, 7, 6], [4, 5, 8, 7]",
    );
    let block = "rigid = \"box\"\nsize = [0.8, 0.8, 0.2]\nmass = 1\nstart = { position = [-0.5, 0.01, 0.1], velocity = [0.5, 0, 0] }";
    for law in LAWS {
        let done = json(&[&on_facets("over_node", law, floor, block, 0.6)]);
        let [x, z, vx] = ["x", "z", "vx"].map(|name| number(&done["last"][format!("load.{name}")]));
        println!("{law}: x {x} z {z} vx {vx}");
        assert!(
            (x + 0.2).abs() < 1e-9 && (vx - 0.5).abs() < 1e-9 && (z - 0.1).abs() < 1e-9,
            "{law}: {x} {z} {vx}"
        );
    }
}

/// Scene of a stretched sheet whose rim is held, and of a part over it.
fn over_sheet(name: &str, law: &str, part: &str) -> String {
    let text = format!(
        "format = 2\n[parts.ground]\nrigid = \"half_space\"\n[parts.sheet]\nshape = \"sheet\"\nrows = 7\ncolumns = 7\n\
         width = 0.28\ndepth = 0.28\nmass = 0.01\nK = 2000\nC = 2\nstretch = 1.2\nstart = {{ position = [0, 0, 0.04] }}\n\
         attach = [{{ nodes = \"rim\", to = \"ground\" }}]\n[parts.load]\n{part}\n\
         [[contacts]]\nbetween = [\"sheet\", \"load\"]\nimpact = \"{law}\"\n[run]\nseconds = 0.5\nstep = 5e-4\nevery = 100\n"
    );
    scene(&format!("{name}_{law}"), &text)
}

#[test]
fn a_small_ball_beside_a_node_of_a_sheet_stays_on_it() {
    let ball = "rigid = \"sphere\"\nradius = 0.005\nmass = 0.02\nstart = { position = [0.16, 0.16, 0.05] }";
    for law in ["moreau", "plastic"] {
        let done = json(&[&over_sheet("small_ball", law, ball)]);
        let z = number(&done["last"]["load.z"]);
        println!("{law}: z {z}, ledger {}", number(&done["imbalance"]));
        assert!(0.02 < z && z < 0.06, "{law}: {z}");
    }
}

#[test]
fn a_bar_that_can_fall_between_nodes_is_named() {
    for (kind, bar, said) in [
        ("capsule", "rigid = \"capsule\"\nradius = 0.01\nlength = 0.5", true),
        ("box", "rigid = \"box\"\nsize = [0.02, 0.5, 0.02]", true),
        ("short", "rigid = \"capsule\"\nradius = 0.01\nlength = 0.1", false),
        ("plate", "rigid = \"box\"\nsize = [0.1, 0.5, 0.02]", false),
    ] {
        let part = format!("{bar}\nmass = 1\nstart = {{ position = [0.14, 0.1633, 0.4] }}");
        let output = smartbed(&["run", &over_sheet(kind, "moreau", &part), "--set", "run.seconds=0.01"]);
        let text = String::from_utf8_lossy(&output.stderr);
        assert!(output.status.success(), "{text}");
        assert_eq!(
            text.contains("`load` is longer than `sheet` and no wider than its facets"),
            said,
            "{kind}: {text}"
        );
    }
}

#[test]
fn parts_that_overlap_at_the_start_are_refused_unless_they_are_settled() {
    let floor = ("[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]", "[0, 1, 2, 3]");
    let at = |z: f64| {
        format!("rigid = \"sphere\"\nradius = 0.02\nmass = 1\nstart = {{ position = [0.5, 0.5, {z}] }}")
    };
    for law in LAWS {
        let deep = on_facets("deep", law, floor, &at(0.0195), 0.01);
        let text = fails(&["run", &deep]);
        assert!(
            text.contains("`load` and `floor` overlap by 5.000e-4 m at the start, near (0.5000, 0.5000,"),
            "{text}"
        );
        assert!(text.contains("move one of them by its `start`, or write start = \"settled\""), "{text}");
        // Touching is not overlapping.
        json(&[&on_facets("touching", law, floor, &at(0.02), 0.01)]);
    }
    // A relaxation moves them apart.
    let deep = on_facets("deep", "moreau", floor, &at(0.0195), 0.01);
    let done = json(&[&deep, "--set", "run.start=\"settled\""]);
    assert!((number(&done["last"]["load.z"]) - 0.02).abs() < 1e-6, "{}", done["last"]["load.z"]);
    settled(&[&deep]);

    let cubes = "models/scenes/two_cubes.toml";
    let text = fails(&["run", cubes, "--set", "parts.right.start.position=[0.19, 0.05, 0.03]"]);
    assert!(text.contains("`left` and `right` overlap by 1.000e-2 m at the start"), "{text}");
    let moved = "parts.wall.start.position=[-0.07, 0.6, 0.2]";
    let text = fails(&["run", "arm6_pushes_wall", "--set", moved]);
    assert!(text.contains("`tip` and `wall` overlap by"), "{text}");
}

#[test]
fn a_cube_that_sinks_into_an_equal_one_is_named() {
    // No node of either is over a facet of the other: the lower one's corners lie outside the turned one.
    let corners: Vec<String> = (0..8)
        .map(|k| {
            let [x, y, z] = [0, 1, 2].map(|i| if k >> i & 1 == 1 { 0.1 } else { -0.1 });
            let c = 0.5_f64.sqrt();
            format!("[{}, {}, {}]", 0.1 + c * (x - y), 0.1 + c * (x + y), z + 0.305)
        })
        .collect();
    let springs: Vec<String> = (0..8).flat_map(|a| (a + 1..8).map(move |b| format!("[{a}, {b}]"))).collect();
    let scene = |name: &str, height: &str| {
        scene(
            name,
            &format!(
                "format = 2\n[parts.ground]\nrigid = \"half_space\"\n\
                 [parts.low]\nshape = \"cube\"\nside = 0.2\nmass = 1\nK = 20000\nC = 5\n\
                 [parts.high]\npoints = [{}]\nsprings = [{}]\n\
                 facets = [[0, 4, 6, 2], [1, 3, 7, 5], [0, 1, 5, 4], [2, 6, 7, 3], [0, 2, 3, 1], [4, 5, 7, 6]]\n\
                 mass = 1\nK = 20000\nC = 5\n{height}\
                 [[contacts]]\nbetween = [\"low\", \"ground\"]\nimpact = \"moreau\"\n\
                 [[contacts]]\nbetween = [\"high\", \"low\"]\nimpact = \"moreau\"\n\
                 [run]\nseconds = 0.15\nstep = 5e-4\n",
                corners.join(", "),
                springs.join(", "),
            ),
        )
    };
    let warned = |file: &str| String::from_utf8_lossy(&smartbed(&["run", file]).stderr).into_owned();
    let text = warned(&scene("sinks", ""));
    assert!(text.contains("warning: `high` and `low` run through one another at the end, near ("), "{text}");
    let text = warned(&scene("falls", "start = { height = 0.5 }\n"));
    assert!(!text.contains("run through one another"), "{text}");
}
