//! The bicycle linearised about upright straight running, against the published benchmark of
//! Meijaard, Papadopoulos, Ruina and Schwab, 2007: M q'' + v C1 q' + (g K0 + v^2 K2) q = f.
//!
//! The derivatives are symbolic, taken from the expressions that are emitted. Pitch follows roll and
//! steer only to second order at upright, so partial derivatives are enough.

use nalgebra::{Complex, ComplexField, Matrix2, Matrix4};
use serde_json::Value;
use smartbed_codegen::program::{Program, Quantity};
use smartbed_tests::interpreted::program;

/// The published numbers have 15 digits.
const PUBLISHED: f64 = 1e-12;
/// Indices of roll and steer among the independent speeds.
const ROLL_AND_STEER: [usize; 2] = [0, 1];
/// Rate of the rear wheel among the independent speeds.
const REAR_WHEEL: usize = 2;
/// A speed (m/s) at which the velocity-dependent matrices are read off.
const SPEED: f64 = 5.0;

/// d(u_dot of roll, steer)/d(two quantities), upright at forward speed `v`.
fn slopes(program: &Program, by: [&Quantity; 2], v: f64) -> Matrix2<f64> {
    let mut dag = program.dag.clone();
    let radius = program.parameters.iter().find(|p| p.name == "rR").expect("radius").value;
    let wheel = program.u[REAR_WHEEL].symbol;
    let value = |symbol| {
        let parameter = program.parameters.iter().find(|p| p.symbol == symbol);
        if symbol == wheel { -v / radius } else { parameter.map_or(0.0, |p| p.value) }
    };
    Matrix2::from_fn(|row, column| {
        let u_dot = program.rates.u_dot[ROLL_AND_STEER[row]];
        let slope = dag.derivative(u_dot, by[column].symbol);
        dag.evaluate::<f64>(&[slope], &value)[0]
    })
}

/// M, v C1 and the stiffness at speed `v`.
fn linearised(program: &Program, v: f64) -> [Matrix2<f64>; 3] {
    let coordinate = |name| program.q.iter().find(|q| q.name == name).expect("a coordinate");
    let mass = slopes(program, [&program.inputs[0], &program.inputs[1]], v).try_inverse().expect("regular");
    let damping = -mass * slopes(program, [&program.u[0], &program.u[1]], v);
    let stiffness = -mass * slopes(program, [coordinate("roll"), coordinate("steer")], v);
    [mass, damping, stiffness]
}

/// The published matrices and eigenvalues.
fn published() -> Value {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/reference/bicycle.json");
    let text = std::fs::read_to_string(path).expect("the reference is there");
    let reference: Value = serde_json::from_str(&text).expect("JSON");
    reference["linear_benchmark_published"].clone()
}

fn number(value: &Value) -> f64 {
    value.as_f64().expect("a number")
}

/// Largest difference relative to the largest entry.
fn distance(actual: &Matrix2<f64>, published: &Value) -> f64 {
    let expected = Matrix2::from_fn(|row, column| number(&published[row][column]));
    (actual - expected).amax() / expected.amax()
}

#[test]
fn linearised_matrices_are_the_published_ones() {
    let program = program("bicycle", &[]);
    let published = published();
    let g = program.parameters.iter().find(|p| p.name == "g").expect("gravity").value;
    let [mass, damping, stiffness] = linearised(&program, SPEED);
    let [_, at_rest, gravity] = linearised(&program, 0.0);
    assert!(at_rest.amax() == 0.0, "a bicycle at rest has no damping: {at_rest}");
    let found = [
        ("M", mass),
        ("C1", damping / SPEED),
        ("K0", gravity / g),
        ("K2", (stiffness - gravity) / (SPEED * SPEED)),
    ];
    for (name, matrix) in found {
        let error = distance(&matrix, &published[name]);
        println!("{name}: {error:.1e}");
        assert!(error <= PUBLISHED, "{name}: {error:e}: {matrix}");
    }
}

#[test]
fn eigenvalues_at_5_metres_per_second_are_the_published_ones() {
    let program = program("bicycle", &[]);
    let [mass, damping, stiffness] = linearised(&program, SPEED);
    let inverse = mass.try_inverse().expect("regular");
    let mut system = Matrix4::zeros();
    system.fixed_view_mut::<2, 2>(0, 2).copy_from(&Matrix2::identity());
    system.fixed_view_mut::<2, 2>(2, 0).copy_from(&(-inverse * stiffness));
    system.fixed_view_mut::<2, 2>(2, 2).copy_from(&(-inverse * damping));
    let found = system.complex_eigenvalues();
    for pair in published()["eigenvalues_v5"].as_array().expect("a list") {
        let expected = Complex::new(number(&pair[0]), number(&pair[1]));
        let error =
            found.iter().map(|e| (e - expected).modulus()).fold(f64::INFINITY, f64::min) / expected.modulus();
        println!("{expected}: {error:.1e}");
        assert!(error <= PUBLISHED, "{expected}: {error:e}");
    }
}
