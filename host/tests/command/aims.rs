//! `--error` and `--budget` of scenes of format 1: what is told holds at every row, not only at samples.

use crate::support::{Done, smartbed, written};

/// A mass on a spring of rest length `rest` under a fixed point, let go 1 m below it.
fn hung(file: &str, rest: f64, more: &str) -> String {
    written(
        file,
        &format!(
            "format = 1\npoints = [[0, 0, 1], [0, 0, 0]]\nsprings = [[0, 1]]\nrest_lengths = [{rest}]\nfixed = [0]\nlaw = \"none\"\n\
             g = 0\nT = 10\n{more}"
        ),
    )
}

/// Rows of time and height of the mass.
fn rows(done: &Done) -> Vec<[f64; 2]> {
    assert_eq!(done.status, 0, "{}", done.err);
    let number = |row: &str, column| row.split(',').nth(column).and_then(|x: &str| x.parse().ok());
    let row = |row: &str| Some([number(row, 0)?, number(row, 6)?]);
    done.out.lines().skip(1).map(|line| row(line).expect("numbers")).collect()
}

/// The error that was told.
fn told(done: &Done) -> f64 {
    let told = done.err.split_once(": error ").and_then(|(_, rest)| rest.split(',').next());
    told.and_then(|x| x.parse().ok()).unwrap_or_else(|| panic!("{}", done.err))
}

/// Asserts that the error told is that of the rows, and that it is what was asked for.
fn assert_told(done: &Done, asked: f64, exact: impl Fn(f64) -> f64) {
    let error = rows(done).iter().map(|[t, z]| (z - exact(*t)).abs()).fold(0.0, f64::max);
    assert!(error <= asked, "{error:e}: {}", done.err);
    // Two digits are told, of an estimate to the first order.
    assert!((0.7..1.5).contains(&(told(done) / error)), "{error:e}: {}", done.err);
}

/// x = 1/2 + exp(-50 t) (cos 50 t + sin 50 t)/2 is at rest at the first of ten samples.
#[test]
fn the_error_of_a_motion_that_ends_before_the_first_sample_is_told() {
    let scene = hung("transient.toml", 0.5, "K = 5000\nC = 100\nstep = 1e-3\n");
    let exact = |t: f64| 0.5 - 0.5 * (-50.0 * t).exp() * ((50.0 * t).cos() + (50.0 * t).sin());
    for (asked, method) in [("1e-3", "damped_verlet"), ("1e-2", "symplectic_euler"), ("1e-6", "rk4")] {
        let done = smartbed(&["run", &scene, "--csv", "-", "--error", asked, "--method", method]);
        assert_told(&done, asked.parse().expect("a number"), exact);
    }
}

/// z = 0.1 - 0.1 cos(2 pi t): every sample is a whole number of periods.
#[test]
fn the_error_of_a_motion_whose_period_divides_the_samples_is_told() {
    let scene = hung("aliasing.toml", 0.9, "K = 39.47841760435743\nstep = 1e-2\n");
    let exact = |t: f64| 0.1 - 0.1 * (2.0 * std::f64::consts::PI * t).cos();
    for (asked, method) in [("1e-3", "energy_momentum"), ("1e-5", "verlet"), ("1e-8", "blanes_moan4")] {
        let done = smartbed(&["run", &scene, "--csv", "-", "--error", asked, "--method", method]);
        assert_told(&done, asked.parse().expect("a number"), exact);
    }
}

/// A calibration's steps are not longer than the interval between rows, and divide it.
#[test]
fn rows_stay_as_far_apart_as_asked() {
    let scene = hung("rows.toml", 0.9, "K = 39.47841760435743\nstep = 1e-3\nevery = 5\n");
    for asked in ["1e-1", "1e-7"] {
        let rows = rows(&smartbed(&["run", &scene, "--csv", "-", "--error", asked]));
        assert_eq!(rows.len(), 2001, "{asked}");
        rows.iter().enumerate().for_each(|(n, [t, _])| assert!((t - 5e-3 * n as f64).abs() < 1e-9, "{t}"));
    }
}

/// Adaptive methods are calibrated in the steps that the run takes from row to row.
#[test]
fn an_adaptive_method_is_as_exact_as_told() {
    let exact = |t: f64| 0.1 - 0.1 * (2.0 * std::f64::consts::PI * t).cos();
    for step in ["2e-3", "5e-2"] {
        let scene = hung("adaptive.toml", 0.9, &format!("K = 39.47841760435743\nstep = {step}\n"));
        let done = smartbed(&["run", &scene, "--csv", "-", "--error", "1e-6", "--method", "dormand_prince"]);
        assert_told(&done, 1e-6, exact);
    }
}

/// With friction, only the start has a reference: the whole run is judged by finer ones, and keeps what was asked for.
#[test]
fn what_has_no_reference_is_judged_by_finer_runs() {
    let slides = ["run", "truss", "--set", "mu=0.3", "--set", "tilt=0.2", "--seconds", "0.8"];
    let asked = smartbed(&[&slides[..], &["--error", "1e-6", "--csv", "-", "--strict"]].concat());
    let fine = ["--method", "verlet", "--step", "1e-6", "--set", "every=1000", "--csv", "-"];
    let (asked, fine) = (asked, smartbed(&[&slides[..], &fine].concat()));
    assert!(asked.err.contains("over all 0.8 s; method by"), "{}", asked.err);
    let (found, exact) = (rows(&asked), rows(&fine));
    let at = |t: f64| found.iter().find(|row| (row[0] - t).abs() < 1e-9);
    let errors: Vec<f64> = exact.iter().filter_map(|[t, z]| Some((at(*t)?[1] - z).abs())).collect();
    let error = errors.iter().copied().fold(0.0, f64::max);
    assert!(errors.len() > 100 && error <= told(&asked) && told(&asked) <= 1e-6, "{error:e}: {}", asked.err);
}

/// What is not kept over the whole run is a warning of its own, in JSON too, which --strict turns into a failure.
#[test]
fn what_is_not_kept_is_a_warning() {
    let slides =
        ["run", "truss", "--set", "mu=0.3", "--set", "tilt=0.2", "--seconds", "3", "--error", "1e-6"];
    let done = smartbed(&[&slides[..], &["--json"]].concat());
    let warning = "--error 1e-6 is not known to be kept over all 3 s";
    assert!(done.status == 0 && done.err.contains(&format!("\nwarning: {warning}")), "{}", done.err);
    assert!(done.out.contains(&format!("\"warnings\": [\"{warning}")), "{}", done.out);
    let strict = smartbed(&[&slides[..], &["--strict"]].concat());
    assert!(
        strict.status == 1 && strict.err.contains(&format!("error: --strict: {warning}")),
        "{}",
        strict.err
    );
    let known = smartbed(&["run", "single_spring", "--seconds", "0.4", "--error", "1e-6", "--strict"]);
    assert!(known.status == 0 && !known.err.contains("warning"), "{}", known.err);
    let report = smartbed(&[
        "report",
        "truss",
        "--method",
        "verlet",
        "--step",
        "1e-3",
        "--scalar",
        "f64",
        "--out",
        "target/report-of-friction",
    ]);
    assert!(!report.err.contains("errors are known"), "{}", report.err);
}
