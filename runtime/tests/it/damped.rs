//! Verlet's method with implicit dampers, against closed forms, other methods and conservation laws.

use crate::flexible::{Row, Trial, spring};
use crate::random::Random;
use smartbed_runtime::ode::nodes::Method;

const METHOD: Method<f64> = Method::DampedVerlet;

/// Two masses of 1 kg that a damper of c joins and nothing else: (x2 - x1)' = u e^(-2 c t).
fn error_of_a_damper(h: f64) -> f64 {
    let (c, u) = (3.0, 0.2);
    let mut trial = Trial::point([0.0; 3], [0.0; 3]).anchored([1.0, 0.0, 0.0]);
    (trial.vel[1], trial.fixed[1]) = ([u, 0.0, 0.0], false);
    trial.springs = vec![spring([0, 1], 0.0, c, 1.0)];
    let rows = trial.run(METHOD, h, 1.0);
    let errors = rows.iter().map(|row| {
        let exact = 1.0 + u * (1.0 - (-2.0 * c * row.t).exp()) / (2.0 * c);
        (row.pos[1][0] - row.pos[0][0] - exact).abs()
    });
    errors.fold(0.0, f64::max)
}

#[test]
fn a_damper_between_two_masses_follows_its_closed_form() {
    let [coarse, fine] = [0.02, 0.01].map(error_of_a_damper);
    println!("{coarse:e} m, {fine:e} m");
    assert!(coarse < 2e-5 && (coarse / fine - 4.0).abs() < 0.1, "{coarse:e}, {fine:e}");
}

/// K = 100 N/m against C = 1e5 N s/m: x decays as e^(-K t/C), at steps 1000 times the limit of explicit methods.
#[test]
fn a_stiff_damper_creeps_at_steps_beyond_explicit_ones() {
    let (k, c, h) = (100.0, 1e5, 0.02);
    let mut trial = Trial::point([1.3, 0.0, 0.0], [0.0; 3]).anchored([0.0; 3]);
    trial.springs = vec![spring([0, 1], k, c, 1.0)];
    let stretch = |row: &Row| row.pos[0][0] - 1.0;
    let rows = trial.run(METHOD, h, 1000.0);
    let error =
        rows.iter().map(|row| (stretch(row) - 0.3 * (-k / c * row.t).exp()).abs()).fold(0.0, f64::max);
    println!("{error:e} m");
    assert!(error < 1e-6, "{error:e}");
    assert!(trial.try_run(Method::Rk4, h, 1.0).is_err());
}

/// Five masses in space, every pair joined by a spring and a damper of different strength.
fn floating(random: &mut Random, stiffness: f64, damping: f64) -> Trial {
    let mut trial = Trial::point([0.0; 3], [0.0; 3]);
    trial.pos = (0..5).map(|_| random.vector(1.0)).collect();
    trial.vel = (0..5).map(|_| random.vector(2.0)).collect();
    trial.mass = (0..5).map(|_| random.between(0.1, 3.0)).collect();
    trial.fixed = vec![false; 5];
    for head in 1..5 {
        for tail in 0..head {
            let (damping, length) = (damping * random.between(0.0, 1.0), random.between(0.5, 1.5));
            trial.springs.push(spring([tail, head], stiffness, damping, length));
        }
    }
    trial
}

/// Linear and angular momentum, each with the sum of the magnitudes of its terms.
fn momenta(mass: &[f64], row: &Row) -> ([f64; 6], [f64; 2]) {
    let (mut sums, mut sizes) = ([0.0; 6], [0.0; 2]);
    for ((mass, [x, y, z]), [u, v, w]) in mass.iter().zip(&row.pos).zip(&row.vel) {
        let terms = [*u, *v, *w, y * w - z * v, z * u - x * w, x * v - y * u].map(|term| mass * term);
        for (i, (sum, term)) in sums.iter_mut().zip(terms).enumerate() {
            *sum += term;
            sizes[i / 3] += term.abs();
        }
    }
    (sums, sizes)
}

fn kinetic(mass: &[f64], row: &Row) -> f64 {
    mass.iter().zip(&row.vel).map(|(m, v)| 0.5 * m * v.iter().map(|v| v * v).sum::<f64>()).sum()
}

/// The iteration stops far from rounding, but each of its steps is made of forces between pairs.
#[test]
fn momenta_are_kept_wherever_the_iteration_stops() {
    let mut random = Random::new(5);
    for damping in [1.0, 30.0, 3000.0] {
        let trial = floating(&mut random, 50.0, damping);
        let rows = trial.run(METHOD, 0.02, 2.0);
        let (start, sizes) = momenta(&trial.mass, &rows[0]);
        for row in &rows {
            let (now, _) = momenta(&trial.mass, row);
            let lost = (0..6).map(|i| (start[i] - now[i]).abs() / sizes[i / 3]).fold(0.0, f64::max);
            assert!(lost < 1e-13, "C = {damping}, t = {}: {lost:e}", row.t);
        }
    }
}

/// Dampers alone, from very weak ones to a thousand times the limit of an explicit step.
#[test]
fn dampers_alone_never_give_energy() {
    let mut random = Random::new(6);
    for trial in 0..60 {
        let damping = 10.0_f64.powf(random.between(-2.0, 5.0));
        let body = floating(&mut random, 0.0, damping);
        let rows = body.run(METHOD, 0.01, 0.5);
        let energies: Vec<f64> = rows.iter().map(|row| kinetic(&body.mass, row)).collect();
        assert!(energies.is_sorted_by(|a, b| *b <= *a * (1.0 + 1e-14)), "trial {trial}: {energies:?}");
        assert!(energies[energies.len() - 1] < 0.999 * energies[0], "trial {trial}: nothing was taken");
    }
}

/// Springs and dampers together against Kutta's method at a tenth of the step; the account of energy closes alike.
#[test]
fn a_damped_body_is_of_order_two() {
    let mut random = Random::new(7);
    let trial = floating(&mut random, 50.0, 4.0);
    let truth = trial.run(Method::Rk4, 2e-4, 1.0);
    let [coarse, fine] = [4e-3, 2e-3].map(|h| {
        let rows = trial.run(METHOD, h, 1.0);
        let [(end, truth)] = [(rows.last().expect("a row"), truth.last().expect("a row"))];
        let places = end.pos.as_flattened().iter().zip(truth.pos.as_flattened());
        let error = places.map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
        [error, rows.iter().map(|row| row.imbalance.abs()).fold(0.0, f64::max)]
    });
    println!("{coarse:?}, {fine:?}");
    for ((coarse, fine), most) in coarse.iter().zip(fine).zip([1e-3, 0.2]) {
        assert!(*coarse < most && (coarse / fine - 4.0).abs() < 0.4, "{coarse:e}, {fine:e}");
    }
}
