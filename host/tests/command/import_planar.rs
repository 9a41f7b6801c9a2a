//! `smartbed import` of joints that slide on any plane, against rotations written out by hand.

use smartbed::import::{Base, import};
use smartbed_codegen::program::derive_asked;
use smartbed_codegen::{Asked, Function, Interpreted, ParameterChoice, Settings, model};

/// A vector turned by an angle about a unit axis (Rodrigues).
fn about([x, y, z]: [f64; 3], angle: f64, v: [f64; 3]) -> [f64; 3] {
    let (s, c) = angle.sin_cos();
    let along = (x * v[0] + y * v[1] + z * v[2]) * (1.0 - c);
    let across = [y * v[2] - z * v[1], z * v[0] - x * v[2], x * v[1] - y * v[0]];
    [0, 1, 2].map(|i| c * v[i] + s * across[i] + along * [x, y, z][i])
}

#[test]
fn a_link_that_slides_on_any_plane_has_the_axes_of_the_robot() {
    let centre = [0.3, -0.2, 0.1];
    for axis in [[0.0, 0.0, -1.0], [-1.0, 0.0, 0.0], [0.0, 0.6, 0.8], [0.48, -0.6, 0.64], [0.0, 1.0, 0.0]] {
        let [x, y, z] = axis;
        let robot = format!(
            r#"<robot name="r"><link name="base"/>
  <joint name="hold" type="planar"><parent link="base"/><child link="body"/><origin xyz="0 0 1" rpy="0.4 0 0"/>
    <axis xyz="{x} {y} {z}"/><dynamics damping="0.5"/></joint>
  <link name="body"><inertial><origin xyz="0.3 -0.2 0.1"/><mass value="2"/><inertia ixx="0.1" iyy="0.2" izz="0.3"/></inertial></link></robot>"#
        );
        let planar = import("robot.urdf", &robot, Base::Fixed).unwrap_or_else(|e| panic!("{e}"));
        assert_eq!(planar.left_out, ["damping of planar and floating joints: 1"]);
        let model = model::parse("imported.toml", &planar.model).unwrap_or_else(|e| panic!("{e}"));
        let asked = Asked::besides(Function::each(&["momentum"]));
        let program = derive_asked(&model, &ParameterChoice::default(), Settings::default(), &asked)
            .unwrap_or_else(|e| panic!("{e}"));
        let mut mechanism = Interpreted::<f64>::new(&program);
        let place = program.functions.iter().position(|f| f.name == "momentum").expect("asked for");
        for turn in [0.0, 0.7] {
            let q: Vec<f64> =
                program.q.iter().map(|q| if q.name == "hold_turn" { turn } else { 0.0 }).collect();
            let found = mechanism.function(place, (0.0, &q, &[0.0; 3], &[], &[])).expect("lengths fit");
            let [x, y, z] = about([1.0, 0.0, 0.0], 0.4, about(axis, turn, centre));
            for (found, expected) in found[1..4].iter().zip([x, y, z + 1.0]) {
                assert!((found - expected).abs() < 1e-15, "{axis:?}, {turn}: {found} for {expected}");
            }
        }
    }
}
