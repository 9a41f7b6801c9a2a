//! `smartbed import`: public arms against Pinocchio, small robots against closed forms, and what is refused.

use crate::schema::holds;
use crate::support::{smartbed, written};
use serde_json::Value;
use smartbed::import::{Base, Imported, import};
use smartbed_codegen::program::derive_asked;
use smartbed_codegen::{Asked, Function, Interpreted, ParameterChoice, Program, Settings, model, program};
use smartbed_runtime::mechanism::Mechanism;
use std::path::{Path, PathBuf};

fn reference(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../tests/reference").join(name)
}

fn imported(name: &str) -> Imported {
    let text = std::fs::read_to_string(reference(&format!("urdf/{name}.urdf"))).expect("a robot");
    import(name, &text, Base::Fixed).unwrap_or_else(|e| panic!("{e}"))
}

fn made(text: &str, base: Base) -> Imported {
    import("robot.urdf", text, base).unwrap_or_else(|e| panic!("{e}"))
}

fn read(imported: &Imported) -> model::Model {
    model::parse("imported.toml", &imported.model).unwrap_or_else(|e| panic!("{e}"))
}

fn derived(imported: &Imported) -> Program {
    program::derive(&read(imported), &ParameterChoice::default()).unwrap_or_else(|e| panic!("{e}"))
}

/// Accelerations at q, u and inputs by name.
fn rates(program: &Program, value: impl Fn(&str) -> f64) -> Vec<f64> {
    let mut mechanism = Interpreted::<f64>::new(program);
    let q: Vec<f64> = program.q.iter().map(|q| value(&q.name)).collect();
    let u: Vec<f64> = program.u.iter().map(|u| value(&u.name)).collect();
    let inputs: Vec<f64> = program.inputs.iter().map(|i| value(&i.name)).collect();
    let (mut q_dot, mut u_dot) = (vec![0.0; q.len()], vec![0.0; u.len()]);
    mechanism.rates(0.0, &q, &u, &inputs, &mut q_dot, &mut u_dot).expect("lengths fit");
    u_dot
}

fn list(value: &Value) -> Vec<f64> {
    value.as_array().expect("a list").iter().map(|x| x.as_f64().expect("a number")).collect()
}

/// Accelerations relative to the largest of the state, the mass matrix to its largest entry.
#[test]
fn public_arms_move_as_pinocchio_says() {
    let text = std::fs::read_to_string(reference("urdf_arms.json")).expect("the reference");
    let all: Value = serde_json::from_str(&text).expect("JSON");
    for name in ["ur5", "panda", "odd"] {
        let arm = &all["arms"][name];
        let joints: Vec<&str> =
            arm["joints"].as_array().expect("joints").iter().filter_map(Value::as_str).collect();
        let model = read(&imported(name));
        let asked = Asked::besides(Function::each(&["mass_matrix"]));
        let program = derive_asked(&model, &ParameterChoice::default(), Settings::default(), &asked)
            .unwrap_or_else(|e| panic!("{e}"));
        assert_eq!(program.q.len(), joints.len(), "{name}");
        let (mut worst, mut worst_mass) = (0.0_f64, 0.0_f64);
        for state in arm["states"].as_array().expect("states") {
            let [q, v, tau, a] = ["q", "v", "tau", "a"].map(|key| list(&state[key]));
            let of = |values: &[f64], name: &str| {
                joints
                    .iter()
                    .position(|j| *j == name)
                    .map(|n| values[n])
                    .unwrap_or_else(|| panic!("no {name}"))
            };
            let found = rates(&program, |name| match (name.strip_prefix("u_"), name.strip_prefix("tau_")) {
                (Some(joint), _) => of(&v, joint),
                (_, Some(joint)) => of(&tau, joint),
                _ => of(&q, name),
            });
            let largest = a.iter().fold(0.0_f64, |m, x| m.max(x.abs()));
            let order: Vec<usize> = (program.u.iter())
                .map(|u| joints.iter().position(|j| u.name.strip_prefix("u_") == Some(j)).expect("a joint"))
                .collect();
            for (x, &n) in found.iter().zip(&order) {
                worst = worst.max((x - a[n]).abs() / largest);
            }
            let rows: Vec<Vec<f64>> =
                state["mass_matrix"].as_array().expect("rows").iter().map(list).collect();
            let largest = rows.iter().flatten().fold(0.0_f64, |m, x| m.max(x.abs()));
            let mut mechanism = Interpreted::<f64>::new(&program);
            let q: Vec<f64> = program.q.iter().map(|c| of(&q, &c.name)).collect();
            let u = vec![0.0; order.len()];
            let inputs = vec![0.0; program.inputs.len()];
            let place = program.functions.iter().position(|f| f.name == "mass_matrix").expect("asked for");
            let matrix = mechanism.function(place, (0.0, &q, &u, &inputs, &[])).expect("lengths fit");
            for (i, &row) in order.iter().enumerate() {
                for (j, &column) in order.iter().enumerate() {
                    let off = (matrix[i * order.len() + j] - rows[row][column]).abs();
                    worst_mass = worst_mass.max(off / largest);
                }
            }
        }
        println!(
            "{name}: accelerations {worst:.1e}, mass matrix {worst_mass:.1e}, {} operations",
            program.operations()
        );
        assert!(worst <= 1e-12 && worst_mass <= 1e-12, "{name}: {worst:e}, {worst_mass:e}");
    }
}

/// A stone with a fixed handle: total mass 3, centre at 1/3 of the handle's offset.
const STONE: &str = r#"<robot name="stone">
  <link name="stone"><inertial><mass value="2"/><inertia ixx="0.1" iyy="0.2" izz="0.3"/></inertial></link>
  <joint name="held" type="fixed"><parent link="stone"/><child link="handle"/><origin xyz="0.3 0 0"/></joint>
  <link name="handle"><inertial><mass value="1"/></inertial></link>
</robot>"#;

#[test]
fn a_root_that_floats_falls_and_one_on_a_plane_slides() {
    let floating = derived(&made(STONE, Base::Floating));
    let names: Vec<&str> = floating.u.iter().map(|u| u.name.as_str()).collect();
    assert_eq!(names.len(), 6, "{names:?}");
    let found = rates(&floating, |name| {
        if name == "stone_base_wz" { 2.0 } else { f64::from(u8::from(name.ends_with("_e0"))) }
    });
    // The mass centre, 0.1 m off along x, falls; its turning throws the link's point outwards: a = g + w^2 c.
    let at = |name: &str| found[names.iter().position(|n| *n == name).unwrap_or_else(|| panic!("{names:?}"))];
    assert!(
        (at("u_stone_base_z") + 9.81).abs() < 1e-13 && (at("u_stone_base_x") - 0.4).abs() < 1e-13,
        "{found:?}"
    );
    let planar = derived(&made(STONE, Base::Planar));
    let names: Vec<&str> = planar.u.iter().map(|u| u.name.as_str()).collect();
    assert_eq!(names, ["u_stone_base_x", "u_stone_base_y", "u_stone_base_turn"]);
    let found = rates(&planar, |name| if name == "u_stone_base_turn" { 2.0 } else { 0.0 });
    assert!((found[0] - 0.4).abs() < 1e-13 && found[1].abs() < 1e-13 && found[2].abs() < 1e-13, "{found:?}");
    // A root that stands still weighs nothing, and is said to.
    let fixed = import("stone.urdf", STONE, Base::Fixed);
    assert!(
        fixed.is_err() || fixed.is_ok_and(|f| f.left_out.iter().any(|line| line.contains("stands still")))
    );
}

#[test]
fn floating_and_planar_joints_inside_a_tree_are_joints() {
    let robot = |kind: &str| {
        format!(
            r#"<robot name="r"><link name="base"/>
  <joint name="hold" type="{kind}"><parent link="base"/><child link="body"/><origin xyz="0 0 1" rpy="0 0 0.5"/><axis xyz="1 0 0"/></joint>
  <link name="body"><inertial><mass value="2"/><inertia ixx="0.1" iyy="0.2" izz="0.3"/></inertial></link></robot>"#
        )
    };
    let floating = derived(&made(&robot("floating"), Base::Fixed));
    assert_eq!(floating.u.len(), 6);
    let falling = rates(&floating, |name| f64::from(u8::from(name.ends_with("_e0"))));
    let z = floating.u.iter().position(|u| u.name == "u_hold_z").expect("z");
    assert!((falling[z] + 9.81).abs() < 1e-13, "{falling:?}");
    // Across x: y and z slide.
    let planar = derived(&made(&robot("planar"), Base::Fixed));
    let names: Vec<&str> = planar.u.iter().map(|u| u.name.as_str()).collect();
    assert_eq!(names, ["u_hold_y", "u_hold_z", "u_hold_turn"]);
    let falling = rates(&planar, |_| 0.0);
    assert!((falling[1] + 9.81).abs() < 1e-13 && falling[0].abs() < 1e-13, "{falling:?}");
}

#[test]
fn inertias_of_links_without_mass_add_up() {
    let link = |name: &str, izz: &str| {
        format!(
            r#"<link name="{name}"><inertial><mass value="0"/><inertia ixx="0.2" iyy="0.2" izz="{izz}"/></inertial></link>"#
        )
    };
    let robot = format!(
        r#"<robot name="r"><link name="base"/>
  <joint name="j" type="continuous"><parent link="base"/><child link="a"/><axis xyz="0 0 1"/></joint>
  <joint name="f" type="fixed"><parent link="a"/><child link="b"/><origin xyz="1 0 0"/></joint>{}{}</robot>"#,
        link("a", "0.2"),
        link("b", "0.3")
    );
    let found = rates(&derived(&made(&robot, Base::Fixed)), |name| if name == "tau_j" { 1.0 } else { 0.0 });
    assert!((found[0] - 2.0).abs() < 1e-15, "{found:?}");
}

/// Every name that a model makes of another one is a name in the robot too.
#[test]
fn names_that_models_make_are_not_taken_twice() {
    let joint = |name: &str, kind: &str, from: &str, to: &str| {
        format!(
            r#"<joint name="{name}" type="{kind}"><parent link="{from}"/><child link="{to}"/><axis xyz="0 0 -1"/>
  <limit lower="-1" upper="1" effort="1" velocity="1"/></joint>
<link name="{to}"><inertial><origin xyz="0.1 0 0"/><mass value="1"/><inertia ixx="1" iyy="1" izz="1"/></inertial></link>"#
        )
    };
    let names = [
        "u_sin",
        "sin",
        "tau_sin",
        "sin_centre",
        "slide",
        "slide_base",
        "u_slide",
        "plane",
        "plane_plane",
        "plane_x",
        "plane_turn",
        "ball",
        "ball_e0",
        "ball_wx",
        "ball_unit",
        "root_base",
        "root_base_x",
        "root_base_wz",
    ];
    let kinds = |name: &str| match name {
        "slide" => "prismatic",
        "plane" => "planar",
        "ball" => "floating",
        _ => "revolute",
    };
    // Joints named by the list with links named otherwise; links named by the list with joints named otherwise.
    for swapped in [false, true] {
        let mut text = String::from("<robot name=\"r\"><link name=\"root\"/>");
        let mut from = "root".to_owned();
        for (n, name) in names.iter().enumerate() {
            let other = format!("part{n}");
            let (called, to) = if swapped { (other.as_str(), *name) } else { (*name, other.as_str()) };
            text += &joint(called, kinds(name), &from, to);
            from = to.to_owned();
        }
        text += "</robot>";
        for base in [Base::Fixed, Base::Floating, Base::Planar] {
            let robot = read(&made(&text, base));
            assert!(robot.coordinates.len() >= names.len(), "{}", robot.coordinates.len());
        }
    }
}

#[test]
fn what_is_not_carried_over_is_said() {
    let panda = imported("odd");
    let all = panda.left_out.join("; ");
    for what in [
        "dry frictions of joints: 1",
        "limits of effort and velocity",
        "the mass of `world`, which stands still",
    ] {
        assert!(all.contains(what), "{what}: {all}");
        assert!(panda.model.contains(what), "{}", panda.model);
    }
    let hinge = |name: &str, from: &str, to: &str, limit: &str| {
        format!(
            "<joint name=\"{name}\" type=\"revolute\"><parent link=\"{from}\"/><child link=\"{to}\"/>{limit}</joint>"
        )
    };
    let follows = "<limit lower=\"-1\" upper=\"1\"/><mimic joint=\"j\"/>";
    let links = ["a", "b", "c"].map(|name| format!("<link name=\"{name}\"/>")).concat();
    let fixed = hinge("j", "a", "b", "<limit lower=\"0.5\" upper=\"0.5\"/>");
    let said = made(
        &format!("<robot name=\"r\">{links}{fixed}{}</robot>", hinge("k", "b", "c", follows)),
        Base::Fixed,
    );
    assert_eq!(said.left_out, ["limits of joints that follow others: 1"]);
    assert_eq!(
        said.notes,
        ["the limits of joint `j` coincide, but a joint follows it: it moves without limits"]
    );
    // The word, its names and a limit beside 0, as they stand in the text.
    let line =
        "turret = { kind = \"prismatic\", axis = [0, 0.6, -0.8], parent = \"turret_link\", child = \"slide\"";
    assert!(panda.model.contains(line), "{}", panda.model);
    assert!(panda.model.contains("range = [0.1, 0.5], nominal = 0.3"), "{}", panda.model);
    let warnings = read(&panda).warnings();
    assert!(warnings.items.is_empty(), "{warnings}");
}

/// Names that URDF does not have may be misspelt ones of what it has.
#[test]
fn what_is_misspelt_is_said() {
    let text = r#"<robot name="r" author="me"><link name="a"/><link name="b"/><jiont name="k"/>
  <joint name="j" type="continuous"><parent link="a"/><child link="b"/><origin xzy="1 2 3" rpy="0 0 1"/>
    <dynamics dampin="0.4"/><dinamics damping="3"/></joint></robot>"#;
    let said = made(text, Base::Fixed);
    let expected = [
        "attributes `author` of <robot>: 1",
        "attributes `dampin` of <dynamics>: 1",
        "attributes `xzy` of <origin>: 1",
        "elements <dinamics> in <joint>: 1",
        "elements <jiont> in <robot>: 1",
    ];
    assert_eq!(said.left_out, expected);
}

/// Of URDF 1.2: the same rotation as one about an axis, of any length.
#[test]
fn origins_may_turn_by_quaternions() {
    let robot = |origin: &str| {
        format!(
            r#"<robot name="r" version="1.2"><link name="a"/><link name="b"><inertial><origin xyz="0.1 0.2 0.3"/>
  <mass value="2"/><inertia ixx="0.1" iyy="0.2" izz="0.25"/></inertial></link><joint name="j" type="continuous">
  <parent link="a"/><child link="b"/><origin xyz="1 2 3" {origin}/></joint></robot>"#
        )
    };
    let model = |origin: &str| made(&robot(origin), Base::Fixed).model;
    let half = 0.2_f64;
    for scale in [1.0, -3.0] {
        let [y, w] = [half.sin(), half.cos()].map(|x| scale * x);
        let by_quaternion = model(&format!("quat_xyzw=\"0 {y} 0 {w}\""));
        let turned = by_quaternion.split("turned = [[\"y\", ").nth(1).expect("it turns about y");
        let angle: f64 =
            turned.trim_start_matches('"').split('"').next().and_then(|x| x.parse().ok()).expect("an angle");
        assert!((angle - 0.4).abs() < 1e-15, "{angle}");
    }
    // Half a turn about x + y: x to y, y to x, z to -z.
    let exact = model("quat_xyzw=\"0.7071067811865476 0.7071067811865476 0 0\"");
    assert_eq!(exact, model("rpy=\"3.141592653589793 0 1.5707963267948966\""));
    assert_eq!(model("quat_xyzw=\"0 0 0 1\""), model(""));
}

/// Two turns about y that come within 1e-12 to 1e-8 rad of a quarter turn, around one about x: the steps written give
/// the product of all three to rounding.
#[test]
fn pitches_near_a_quarter_turn_keep_the_rotation() {
    for short in [2e-12, 1e-11, 3e-10, 1e-8] {
        let first = std::f64::consts::FRAC_PI_3;
        let second = std::f64::consts::FRAC_PI_6 - short;
        let text = format!(
            r#"<robot name="r"><link name="a"/><link name="m"/><link name="b"><inertial><mass value="1"/>
  <inertia ixx="1" iyy="2" izz="2.5"/></inertial></link>
  <joint name="f" type="fixed"><parent link="a"/><child link="m"/><origin rpy="0 {first} 0"/></joint>
  <joint name="j" type="continuous"><parent link="m"/><child link="b"/><origin rpy="0.3 {second} 0"/></joint></robot>"#
        );
        let model = made(&text, Base::Fixed).model;
        let turned =
            model.split("turned = [").nth(1).and_then(|text| text.split("]]").next()).expect("turned");
        let product =
            turned.split(']').fold([[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]], |m, step| {
                let mut words =
                    step.split('"').filter(|word| word.chars().any(|c| c.is_ascii_alphanumeric()));
                let (Some(axis), Some(angle)) = (words.next(), words.next()) else { return m };
                let axis = ["x", "y", "z"].iter().position(|own| *own == axis).expect("an axis");
                let angle = match angle.strip_suffix("*deg") {
                    Some(degrees) => degrees.parse::<f64>().expect("an angle").to_radians(),
                    None => angle.parse().expect("an angle"),
                };
                times(&m, &turn(axis, angle))
            });
        let exact = times(&turn(1, first + second), &turn(0, 0.3));
        let off = (0..9).map(|k| (product[k / 3][k % 3] - exact[k / 3][k % 3]).abs()).fold(0.0, f64::max);
        assert!(off < 1e-15 * 8.0, "{short:e}: {off:e} by {turned}");
    }
}

/// The rotation by an angle about x, y or z.
fn turn(axis: usize, angle: f64) -> [[f64; 3]; 3] {
    let (s, c) = angle.sin_cos();
    let (i, j) = ((axis + 1) % 3, (axis + 2) % 3);
    let mut m = [[0.0; 3]; 3];
    (m[axis][axis], m[i][i], m[j][j], m[i][j], m[j][i]) = (1.0, c, c, -s, s);
    m
}

fn times(a: &[[f64; 3]; 3], b: &[[f64; 3]; 3]) -> [[f64; 3]; 3] {
    std::array::from_fn(|i| std::array::from_fn(|j| (0..3).map(|k| a[i][k] * b[k][j]).sum()))
}

/// Two joints whose limits coincide, one of each kind, then one without limits; a name that is a word of Rust, one of
/// models.
#[test]
fn joints_whose_limits_coincide_are_fixed_and_changed_names_are_said() {
    let text = r#"<robot name="fn"><link name="world"/>
  <joint name="shoulder" type="revolute"><parent link="world"/><child link="N"/><origin xyz="0 0 1" rpy="0 0 0.2"/>
    <axis xyz="0 0 2"/><limit lower="0.3" upper="0.3" effort="1" velocity="1"/></joint>
  <link name="N"/>
  <joint name="lift" type="prismatic"><parent link="N"/><child link="arm"/><axis xyz="0 1 0"/><limit lower="0.5" upper="0.5"/></joint>
  <link name="arm"/>
  <joint name="type" type="revolute"><parent link="arm"/><child link="hand"/><axis xyz="1 0 0"/><limit effort="1" velocity="1"/></joint>
  <link name="hand"><inertial><origin xyz="0 0 -0.2"/><mass value="1"/><inertia ixx="0.1" iyy="0.1" izz="0.1"/></inertial></link></robot>"#;
    let fixed = made(text, Base::Fixed);
    for note in [
        "robot `fn` is named `fn_robot`",
        "joint `type` is named `type_joint`",
        "joint `shoulder` is fixed at 0.3 rad, where its limits coincide",
        "joint `lift` is fixed at 0.5 m, where its limits coincide",
    ] {
        assert!(fixed.notes.iter().any(|line| line == note), "{note}: {:?}", fixed.notes);
        assert!(fixed.model.contains(&format!("# Note: {note}.")), "{}", fixed.model);
    }
    let program = derived(&fixed);
    assert_eq!(program.q.iter().map(|q| q.name.as_str()).collect::<Vec<_>>(), ["type_joint"]);
    // Turned by 0.2 + 0.3 about z, 0.5 along y there; the joint without limits has a whole turn.
    let place = "at = \"O - 0.23971276930210";
    assert!(fixed.model.contains(place) && fixed.model.contains("0.4387912809451"), "{}", fixed.model);
    assert!(fixed.model.contains("range = [-3.14159"), "{}", fixed.model);
    let said = smartbed(&["import", &written("locked.urdf", text)]);
    assert!(said.err.contains("note: joint `type` is named `type_joint`"), "{said:?}");
}

#[test]
fn robots_that_are_none_are_refused_with_place_and_cure() {
    let link = |name: &str| format!("<link name=\"{name}\"/>");
    let joint = |name: &str, from: &str, to: &str, more: &str| {
        format!(
            "<joint name=\"{name}\" type=\"revolute\"><parent link=\"{from}\"/><child link=\"{to}\"/>{more}</joint>"
        )
    };
    let robot = |inside: &str| format!("<robot name=\"r\">\n{inside}\n</robot>");
    let cases = [
        ("<robot", "not valid XML"),
        ("<model/>", "expected <robot>"),
        (&robot(""), "expected at least one"),
        (&robot("<link/>"), "line 2, column 1 has no `name`"),
        (&robot("<x:macro xmlns:x=\"http://www.ros.org/wiki/xacro\"/>"), "expand it first"),
        (&robot(&[link("a"), link("b")].concat()), "expected only one such root"),
        (&robot(&[link("a"), link("a")].concat()), "a second link `a`"),
        (&robot(&[link("a"), joint("j", "a", "c", "")].concat()), "names the link `c`, which does not exist"),
        (
            &robot(&[link("a"), link("b"), joint("j", "a", "b", "<axis xyz=\"0 0\"/>")].concat()),
            "expected 3 numbers",
        ),
        (
            &robot(&[link("a"), link("b"), joint("j", "a", "b", "<axis xyz=\"0 0 0\"/>")].concat()),
            "expected a direction",
        ),
        (
            &robot(
                &[link("a"), link("b"), joint("j", "a", "b", "<limit lower=\"2\" upper=\"-1\"/>")].concat(),
            ),
            "are 2 and -1; expected the lower one first",
        ),
        (
            &robot(&[link("a"), link("b"), joint("j", "a", "b", "<mimic joint=\"k\"/>")].concat()),
            "mimics `k`, which does not exist",
        ),
        (
            &robot(&[link("a"), link("b"), joint("j", "a", "b", "<mimic joint=\"j\"/>")].concat()),
            "mimics itself",
        ),
        (
            &robot(&[link("a"), link("b"), joint("j", "a", "b", ""), joint("k", "a", "b", "")].concat()),
            "expected a tree",
        ),
        (
            &robot(
                &[link("a"), link("b"), link("c"), joint("j", "b", "c", ""), joint("k", "c", "b", "")]
                    .concat(),
            ),
            "belongs to a closed chain of joints",
        ),
        (
            &robot(&[link("a"), link("b"), joint("j", "a", "b", "").replace("revolute", "screw")].concat()),
            "is of type `screw`",
        ),
        (&robot("<link name=\"a\"><inertial><mass value=\"-1\"/></inertial></link>"), "negative"),
        (&robot("<link name=\"a\"><inertial/></link>"), "has no <mass>"),
        (&robot("<link name=\"a\"><inertial><mass/></inertial></link>"), "has no `value`"),
        (
            &robot(
                "<link name=\"a\"><inertial><mass value=\"1\"/><inertia ixx=\"1\" izz=\"1\"/></inertial></link>",
            ),
            "has no `iyy`",
        ),
        (
            &robot("<link name=\"a\"><inertial><mass value=\"1\"/><mass value=\"2\"/></inertial></link>"),
            "a second <mass> at line 2, column 43; expected one in <inertial>",
        ),
        (
            &robot(
                &[
                    link("a"),
                    link("b"),
                    joint("j", "a", "b", "<origin rpy=\"0 0 1\" quat_xyzw=\"0 0 0 1\"/>"),
                ]
                .concat(),
            ),
            "expected one of them",
        ),
        (
            &robot(&[link("a"), link("b"), joint("j", "a", "b", "<origin quat_xyzw=\"0 0 0 0\"/>")].concat()),
            "expected a rotation",
        ),
        (&robot("<link name=\"a\"><inertial><mass value=\"1e999\"/></inertial></link>"), "expected a number"),
    ];
    for (text, expected) in cases {
        let message = match import("robot.urdf", text, Base::Fixed) {
            Err(failure) => failure.to_string(),
            Ok(imported) => panic!("{text} is taken: {}", imported.model),
        };
        assert!(message.contains("robot.urdf") && message.contains(expected), "{text}: {message}");
    }
}

#[test]
fn the_command_writes_a_model_that_runs() {
    let robot = written(
        "pendulum.urdf",
        r#"<robot name="pendulum"><link name="base"/>
  <joint name="hinge" type="continuous"><parent link="base"/><child link="rod"/><axis xyz="0 1 0"/></joint>
  <link name="rod"><inertial><origin xyz="0 0 -0.5"/><mass value="1"/></inertial></link></robot>"#,
    );
    let (from, to) = (robot.clone(), robot.replace(".urdf", ".toml"));
    let done = smartbed(&["import", &from, "-o", &to]);
    assert_eq!(done.status, 0, "{done:?}");
    let written = std::fs::read_to_string(&to).expect("a model");
    for (arguments, file, model) in [(&["-o", &to][..], Some(&*to), None), (&[], None, Some(&*written))] {
        let done = smartbed(&[&["import", &from, "--json"], arguments].concat());
        holds("imported", &done.json());
        assert_eq!((done.json()["file"].as_str(), done.json()["model"].as_str()), (file, model), "{done:?}");
    }
    let done = smartbed(&["check", &to]);
    assert_eq!(done.status, 0, "{done:?}");
    let done = smartbed(&["import", "nowhere.urdf"]);
    assert_eq!(done.status, 1, "{done:?}");
}
