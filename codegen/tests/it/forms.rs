//! The goal of optimisation changes a program's operations, never its answers.

use crate::models::shipped;
use smartbed_codegen::{
    Core, Effort, EmitOptions, Interpreted, Optimise, ParameterChoice, Program, ScalarType, Settings,
    program, rust,
};
use smartbed_runtime::mechanism::Mechanism;

/// States by model, and how far coordinates and speeds lie from nominal and from rest at most.
const STATES: usize = 20;
const SPREAD: f64 = 0.05;
/// Newton corrections that put a state on its constraints.
const CORRECTIONS: usize = 8;
/// Two formulations of u' at the same state, relative to the largest.
const AGREEMENT: f64 = 1e-10;

/// Names of the mechanisms of models/.
fn names() -> Vec<String> {
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/../models");
    let files = std::fs::read_dir(folder).expect("the models").map(|entry| entry.expect("an entry").path());
    let models = files.filter(|path| path.extension().is_some_and(|e| e == "toml"));
    let mut names: Vec<String> =
        models.filter_map(|path| Some(path.file_stem()?.to_str()?.to_owned())).collect();
    names.sort();
    assert!(names.len() >= 15, "{names:?}");
    names
}

/// Numbers that look random, in [-1, 1].
fn spread(n: usize, seed: usize) -> Vec<f64> {
    (0..n).map(|k| (1.7 * (k + 1) as f64 + 2.3 * (seed * (k + 3)) as f64).sin()).collect()
}

/// q', u' and the energies.
fn answers(program: &Program, q: &[f64], u: &[f64], inputs: &[f64]) -> [Vec<f64>; 3] {
    let mut engine = Interpreted::<f64>::new(program);
    let (mut q_dot, mut u_dot) = (vec![0.0; q.len()], vec![0.0; u.len()]);
    engine.rates(0.0, q, u, inputs, &mut q_dot, &mut u_dot).expect("slices fit");
    let (kinetic, potential) = engine.energy(q, u).expect("slices fit");
    [q_dot, u_dot, vec![kinetic, potential]]
}

#[test]
fn all_forms_of_every_model_agree() {
    for name in names() {
        let model = shipped(&name);
        let forms = [
            (Effort::None, Optimise::Operations),
            (Effort::All, Optimise::Operations),
            (Effort::Default, Optimise::Time),
            (Effort::Default, Optimise::Accuracy),
            (Effort::All, Optimise::Accuracy),
        ]
        .map(|(effort, optimise)| {
            let derived =
                program::derive_with(&model, &ParameterChoice::default(), Settings { effort, optimise });
            derived.unwrap_or_else(|found| panic!("{found}"))
        });
        let first = &forms[0];
        for seed in 0..STATES {
            let mut q = first.nominal.clone();
            q.iter_mut().zip(spread(first.q.len(), seed)).for_each(|(q, x)| *q += SPREAD * x);
            let mut engine = Interpreted::<f64>::new(first);
            (0..CORRECTIONS).for_each(|_| {
                engine.project(&mut q).expect("slices fit");
            });
            let (u, inputs) = (spread(first.u.len(), seed + 1), spread(first.inputs.len(), seed + 2));
            let expected = answers(first, &q, &u, &inputs);
            for form in &forms[1..] {
                for (found, expected) in answers(form, &q, &u, &inputs).iter().zip(&expected) {
                    let scale = expected.iter().fold(1e-300_f64, |most, x| most.max(x.abs()));
                    let worst = found.iter().zip(expected).fold(0.0_f64, |w, (a, b)| w.max((a - b).abs()));
                    assert!(worst <= AGREEMENT * scale, "{name}: {found:?} against {expected:?}");
                }
            }
        }
    }
}

#[test]
fn the_core_is_a_choice_and_the_scalar_only_its_default() {
    let program = program::derive(&shipped("fourbar"), &ParameterChoice::default()).expect("derives");
    let text = |scalar: ScalarType, core: Option<Core>| {
        rust::emit(&program, &EmitOptions { scalar, core, ..EmitOptions::default() })
    };
    for (scalar, usual, other) in
        [(ScalarType::F32, Core::CortexM4, Core::Host), (ScalarType::F64, Core::Host, Core::CortexM4)]
    {
        let [left_out, chosen, changed] =
            [None, Some(usual), Some(other)].map(|core| text(scalar.clone(), core));
        assert_eq!(left_out, chosen);
        assert_ne!(left_out, changed);
        // Only a host computes two sines at a time; what is computed stays the same.
        let pairs = |text: &str| text.contains("sin_cos_of_two");
        assert_eq!([pairs(&chosen), pairs(&changed)], [usual, other].map(|core| core == Core::Host));
        let counts =
            |text: &str| text.lines().filter(|l| l.starts_with("// Cost")).collect::<Vec<_>>().join("\n");
        assert_eq!(counts(&chosen), counts(&changed));
    }
}
