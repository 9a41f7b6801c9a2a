//! The Newton-Euler oracle against the stored references, before other tests rely on it.

use nalgebra::{Matrix2, Vector2, Vector3};
use smartbed_tests::closed_form::{pendulum as pendulum_form, tile as tile_form};
use smartbed_tests::newton_euler::arm6::Arm;
use smartbed_tests::newton_euler::bicycle::Bicycle;
use smartbed_tests::newton_euler::fourbar::Fourbar;
use smartbed_tests::newton_euler::pendulum::Pendulum;
use smartbed_tests::newton_euler::system::Motion;
use smartbed_tests::newton_euler::tile::{Load, PLATFORM, Parameters, Tile};
use smartbed_tests::reference::data::{self, Sample};
use smartbed_tests::tolerance::relative_error;

/// A dense solve of some eighty unknowns in f64, and states that satisfy their loops to 1e-16.
const ORACLE: f64 = 1e-13;

/// Outputs are angles below 1 rad and lengths below 1 m, in f64 on both sides.
const OUTPUT: f64 = 1e-14;

/// Compares rates and accelerations of all samples of a reference.
fn check(model: &str, oracle: impl Fn(&data::Reference, &Sample) -> Motion) {
    let reference = data::samples(model);
    let mut worst: f64 = 0.0;
    for sample in &reference.samples {
        let motion = oracle(&reference, sample);
        worst = worst.max(relative_error(&motion.q_dot, &sample.q_dot));
        worst = worst.max(relative_error(&motion.u_dot, &sample.u_dot));
    }
    println!("{model}: oracle against reference {worst:.1e}");
    assert!(worst <= ORACLE, "{model}: {worst:e}");
}

#[test]
fn pendulum3_equals_the_reference() {
    check("pendulum3", |_, sample| {
        let (masses, rest) = sample.parameters.split_at(3);
        Pendulum { masses, lengths: &rest[..3], g: rest[3], q: &sample.q }.solve(&sample.u)
    });
}

#[test]
fn fourbar_equals_the_reference() {
    check("fourbar", |_, s| Fourbar::new(&s.parameters, &s.q, &s.inputs).solve(&s.u));
}

#[test]
fn tile_equals_the_reference() {
    check("tile", |_, s| {
        let tile = Tile {
            parameters: Parameters::new(&s.parameters),
            q: s.q.as_slice().try_into().expect("12 coordinates"),
            h_dot: s.u.as_slice().try_into().expect("3 speeds"),
            thrust: s.inputs.as_slice().try_into().expect("3 thrusts"),
            load: Load::default(),
        };
        tile.solve()
    });
}

#[test]
fn arm6_equals_the_reference() {
    check("arm6", |r, s| Arm::new(&r.alpha_degrees, &s.parameters, &s.q, &s.inputs).solve(&s.u));
}

#[test]
fn bicycle_equals_the_reference() {
    check("bicycle", |_, s| Bicycle::new(&s.parameters, &s.q, &s.inputs).solve(&s.u));
}

#[test]
fn tile_from_heights_alone_equals_the_minimal_reference() {
    let minimal = data::minimal();
    let values: Vec<f64> = minimal.parameters.iter().map(|(_, value)| *value).collect();
    let parameters = Parameters::new(&values);
    let [mut worst, mut worst_output]: [f64; 2] = [0.0; 2];
    for state in &minimal.states {
        let posture = tile_form::posture(parameters.r, state.h);
        let q = posture.coordinates(parameters.r, state.h);
        let motion =
            Tile { parameters, q, h_dot: state.h_dot, thrust: state.thrust, load: Load::default() }.solve();
        worst = worst.max(relative_error(&motion.u_dot, &state.u_dot));
        worst = worst.max(relative_error(&[motion.kinetic], &[state.kinetic]));
        worst = worst.max(relative_error(&[motion.potential], &[state.potential]));
        for (name, value) in &state.outputs {
            let leg = ["A", "B", "C"].iter().position(|leg| name.ends_with(leg));
            let found = match (&name[..name.len() - 1], leg) {
                ("psi", Some(leg)) => q[4 * leg + 1],
                ("th", Some(leg)) => q[4 * leg + 2],
                ("s", Some(leg)) => q[4 * leg + 3],
                _ => posture.centre["xyz".find(&name[1..]).expect("Gx, Gy or Gz")],
            };
            worst_output = worst_output.max((found - value).abs());
        }
    }
    println!("tile_minimal: oracle against reference {worst:.1e}, outputs {worst_output:.1e}");
    assert!(worst <= ORACLE, "{worst:e}");
    assert!(worst_output <= OUTPUT, "{worst_output:e}");
}

/// A light tile on a circle of 0.1 m: m = 3 kg, massless legs, as in the golden rows.
fn golden_tile(h_dot: [f64; 3], thrust: [f64; 3]) -> Tile {
    let parameters =
        Parameters::new(&[0.1, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 3.0, 0.012, 0.016, 0.026, 0.0, 9.81]);
    let h = [0.03, 0.01, -0.01];
    Tile {
        parameters,
        q: tile_form::posture(0.1, h).coordinates(0.1, h),
        h_dot,
        thrust,
        load: Load::default(),
    }
}

/// From the golden rows' axes (screw A on x) to the bed's (screw A on y).
fn bed_axes(v: [f64; 3]) -> Vector3<f64> {
    Vector3::new(-v[1], v[0], v[2])
}

/// The golden kinematics are printed with ten digits or more.
const PRINTED: f64 = 1e-9;
/// The golden thrusts are printed to 5e-9 N; the effective masses are about 1 kg.
const PRINTED_FORCE: f64 = 1e-8;

#[test]
fn static_thrusts_carry_the_weight_and_rods_push_sideways() {
    let thrust = [9.432629465, 10.56474107, 9.432629465];
    let tile = golden_tile([0.0; 3], thrust);
    let motion = tile.solve();
    assert!(motion.u_dot.iter().all(|a| a.abs() < PRINTED_FORCE), "{:?}", motion.u_dot);
    let expected = [
        [-1.862021423, 1.07503857, 9.432629465],
        [1.862021423, 1.07503857, 10.56474107],
        [0.0, -2.15007714, 9.432629465],
    ];
    for (leg, force) in expected.into_iter().enumerate() {
        let found = tile.rod_force(&motion, leg);
        assert!((found - bed_axes(force)).norm() < PRINTED_FORCE, "leg {leg}: {found}");
    }
    assert!((thrust.iter().sum::<f64>() - tile.parameters.weight()).abs() < PRINTED_FORCE);
}

#[test]
fn platform_moves_as_in_the_golden_row() {
    let tile = golden_tile([0.004, -0.001, 0.002], [9.530457603, 10.51821224, 9.442808003]);
    let motion = tile.solve();
    let platform = &motion.bodies[PLATFORM];
    let v = bed_axes([-3.18034985413e-4, -3.36058643162e-5, 1.56408548144e-3]);
    let w = bed_axes([-0.0170205845768, -0.0224850669353, -0.00296126374532]);
    let a = bed_axes([-0.00956459694438, 4.41306998446e-4, 0.0204926169734]);
    let alpha = bed_axes([-0.3995318119, -0.7368459759, -0.081423459]);
    assert!((platform.velocity.linear - v).norm() < PRINTED);
    assert!((platform.velocity.angular - w).norm() < PRINTED);
    assert!(
        (platform.acceleration.linear - a).norm() < PRINTED_FORCE,
        "{}",
        platform.acceleration.linear - a
    );
    assert!(
        (platform.acceleration.angular - alpha).norm() < 10.0 * PRINTED_FORCE,
        "{}",
        platform.acceleration.angular - alpha
    );
    assert!(relative_error(&motion.u_dot, &[0.1, -0.05, 0.02]) * 0.1 < PRINTED_FORCE, "{:?}", motion.u_dot);
}

#[test]
fn forces_and_moments_of_every_body_balance() {
    let tile = golden_tile([0.2, -0.1, 0.3], [20.0, -5.0, 12.0]);
    let motion = tile.solve();
    // The platform: three rods and the weight give m a; their moments give I alpha + w x I w.
    let platform = &motion.bodies[PLATFORM];
    let g = Vector3::new(0.0, 0.0, -9.81);
    let mut force = g * 3.0;
    let mut moment = Vector3::zeros();
    for leg in 0..3 {
        let f = tile.rod_force(&motion, leg);
        force += f;
        moment += (tile.connector(leg) - platform.pose.centre).cross(&f);
    }
    assert!((force - platform.acceleration.linear * 3.0).norm() < 1e-11);
    let r = platform.pose.rotation;
    let inertia = r * nalgebra::Matrix3::from_diagonal(&Vector3::new(0.012, 0.016, 0.026)) * r.transpose();
    let w = platform.velocity.angular;
    let rate = inertia * platform.acceleration.angular + w.cross(&(inertia * w));
    assert!((moment - rate).norm() < 1e-11, "{moment} against {rate}");
}

#[test]
fn pendulum_energy_equals_the_closed_form() {
    for sample in &data::samples("pendulum3").samples {
        let (masses, rest) = sample.parameters.split_at(3);
        let (lengths, g) = (&rest[..3], rest[3]);
        let motion = Pendulum { masses, lengths, g, q: &sample.q }.solve(&sample.u);
        let (kinetic, potential) = pendulum_form::energy(masses, lengths, g, &sample.q, &sample.u);
        assert!(relative_error(&[motion.kinetic], &[kinetic]) < ORACLE);
        assert!(relative_error(&[motion.potential], &[potential]) < ORACLE);
    }
}

/// Central differences of accelerations up to 100 with steps of 1e-5.
const LINEARISED: f64 = 1e-7;

/// Rates of roll and steer speed of the benchmark bicycle near upright, at forward speed v.
fn lateral(q: [f64; 2], q_dot: [f64; 2], v: f64, torque: [f64; 2]) -> Vector2<f64> {
    let reference = data::samples("bicycle");
    let parameters = &reference.samples[0].parameters;
    let inputs = [torque[0], torque[1], 0.0];
    let mut coordinates = [0.0, q[0], 0.0, q[1], 0.0, 0.0];
    coordinates[2] = Bicycle::new(parameters, &coordinates, &inputs).pitch();
    let rear_radius = parameters[4];
    let motion =
        Bicycle::new(parameters, &coordinates, &inputs).solve(&[q_dot[0], q_dot[1], -v / rear_radius]);
    Vector2::new(motion.u_dot[0], motion.u_dot[1])
}

/// Derivative of `of` in each of two directions.
fn columns(of: impl Fn([f64; 2]) -> Vector2<f64>) -> Matrix2<f64> {
    let step = 1e-5;
    let along = |axis: usize| {
        let mut at = [0.0; 2];
        at[axis] = step;
        (of(at) - of(at.map(|x| -x))) / (2.0 * step)
    };
    Matrix2::from_columns(&[along(0), along(1)])
}

/// Meijaard, Papadopoulos, Ruina and Schwab (2007): M q'' + v C1 q' + (g K0 + v^2 K2) q = f.
#[test]
fn bicycle_linearises_to_the_published_benchmark() {
    let mass = Matrix2::new(80.81722, 2.31941332208709, 2.31941332208709, 0.29784188199686);
    let c1 = Matrix2::new(0.0, 33.86641391492494, -0.85035641456978, 1.6854039739756);
    let k0 = Matrix2::new(-80.95, -2.59951685249872, -2.59951685249872, -0.80329488458618);
    let k2 = Matrix2::new(0.0, 76.59734589573222, 0.0, 2.65431523794604);
    let still = [0.0; 2];
    let response = Matrix2::from_columns(&[
        lateral(still, still, 0.0, [1.0, 0.0]),
        lateral(still, still, 0.0, [0.0, 1.0]),
    ]);
    assert!((response * mass - Matrix2::identity()).abs().max() < 1e-10, "{response}");
    for v in [0.5, 5.0] {
        let damping = -mass * columns(|q_dot| lateral(still, q_dot, v, still));
        let stiffness = -mass * columns(|q| lateral(q, still, v, still));
        let expected = k0 * 9.81 + k2 * (v * v);
        let error = |found: Matrix2<f64>, expected: Matrix2<f64>| {
            (found - expected).abs().max() / expected.abs().max()
        };
        assert!(error(damping, c1 * v) < LINEARISED, "v = {v}: {damping}");
        assert!(error(stiffness, expected) < LINEARISED, "v = {v}: {stiffness}");
    }
}
