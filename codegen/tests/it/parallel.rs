//! Parallel hinges: relative angles, solved in absolute rates, against a model in absolute angles.

use smartbed_codegen::{Effort, Interpreted, ParameterChoice, Program, model, program};
use smartbed_runtime::mechanism::Mechanism;
use std::fmt::Write;

/// Hinges about z on a frame that turns about y, lying on a side.
const HINGES: usize = 3;
/// Relative to the largest acceleration.
const ROUNDING: f64 = 1e-13;

/// An arm of lopsided links; its angles relative to the link below or absolute.
fn arm(relative: bool) -> String {
    let mut text = "format = 1\nname = \"arm\"\ndof = 4\ngravity = \"-g*N.x\"\n\
                    [coordinates.base]\nunit = \"rad\"\nspeed = \"v\"\nrange = [-3, 3]\n\
                    [frames.turned]\nparent = \"N\"\nrotations = [[\"y\", \"base\"]]\n\
                    [parameters]\ng = { value = 9.81, unit = \"m/s^2\" }\nl = { value = 0.4, unit = \"m\" }\nc = { value = 0.1, unit = \"m\" }\n\
                    m = { value = 1.3, unit = \"kg\" }\nI = { value = 0.05, unit = \"kg m^2\" }\n\
                    D = { value = 0.01, unit = \"kg m^2\" }\n"
        .to_owned();
    let (mut below, mut base) = ("turned".to_owned(), "O".to_owned());
    for i in 0..HINGES {
        let parent = if relative { &below } else { "turned" };
        write!(
            text,
            "[coordinates.q{i}]\nunit = \"rad\"\nspeed = \"u{i}\"\nrange = [-3, 3]\n\
             [frames.link{i}]\nparent = \"{parent}\"\nrotations = [[\"z\", \"q{i}\"]]\n\
             [points.J{i}]\nposition = \"{base} + l*{below}.x + c*{below}.z\"\n\
             [points.C{i}]\nposition = \"J{i} + l*link{i}.x + c*link{i}.y - c*link{i}.z\"\n\
             [bodies.link{i}]\ncentre = \"C{i}\"\nmass = \"m\"\nframe = \"link{i}\"\n\
             inertia = {{ Ixx = \"I\", Iyy = \"2*I\", Izz = \"2*I\", Ixy = \"D\", Iyz = \"D\" }}\n"
        )
        .expect("a string grows");
        (below, base) = (format!("link{i}"), format!("J{i}"));
    }
    text
}

fn derived(text: &str, effort: Effort) -> Program {
    let model = model::parse("arm.toml", text).unwrap_or_else(|e| panic!("{e}"));
    program::derive_with(&model, &ParameterChoice::default(), effort).unwrap_or_else(|e| panic!("{e}"))
}

fn accelerations(program: &Program, q: &[f64], u: &[f64]) -> Vec<f64> {
    let mut mechanism = Interpreted::<f64>::new(program);
    let (mut q_dot, mut u_dot) = (vec![0.0; q.len()], vec![0.0; u.len()]);
    mechanism.rates(0.0, q, u, &[], &mut q_dot, &mut u_dot).expect("slices fit");
    u_dot
}

/// The base as it is, then the sums of the hinges up to each.
fn absolute(x: &[f64]) -> Vec<f64> {
    let mut sum = 0.0;
    let hinges = x[1..].iter().map(|x| {
        sum += x;
        sum
    });
    [x[0]].into_iter().chain(hinges).collect()
}

#[test]
fn relative_and_absolute_angles_describe_one_arm() {
    let other = derived(&arm(false), Effort::None);
    for effort in [Effort::None, Effort::Default] {
        let program = derived(&arm(true), effort);
        for round in 0..20 {
            let number = |i: usize| (1.7 * (i + 1) as f64 + 2.3 * f64::from(round)).sin();
            let q: Vec<f64> = (0..=HINGES).map(|i| 2.0 * number(i)).collect();
            let u: Vec<f64> = (0..=HINGES).map(|i| 3.0 * number(i + 40)).collect();
            let found = absolute(&accelerations(&program, &q, &u));
            let expected = accelerations(&other, &absolute(&q), &absolute(&u));
            let scale = expected.iter().fold(1.0_f64, |m, x| m.max(x.abs()));
            for (a, b) in found.iter().zip(&expected) {
                assert!((a - b).abs() <= ROUNDING * scale, "{found:?} against {expected:?}");
            }
        }
    }
}
