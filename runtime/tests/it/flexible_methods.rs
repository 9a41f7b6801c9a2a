//! Adaptive methods: error against tolerance, work, rounding, NaN.

use crate::flexible::{Trial, spring};
use smartbed_runtime::contact::compensation::PointImpact;
use smartbed_runtime::contact::{ContactState, System};
use smartbed_runtime::flexible::{Body, Massless, Spring};
use smartbed_runtime::ode::nodes::method::{Dop853, DormandPrince};
use smartbed_runtime::ode::nodes::{MOTION_ROWS, Method, Motion, NodeFault, Step, Workspace, workspace_len};
use smartbed_runtime::scene::{State, step};

/// Adaptive methods on a spring: the error stays within the tolerance, the work within that of their order.
#[test]
fn adaptive_methods_are_worth_their_work() {
    let mut trial = Trial::point([1.3, 0.0, 0.0], [0.0; 3]).anchored([0.0; 3]);
    trial.springs = vec![spring([0, 1], 100.0, 0.0, 1.0)];
    for (tolerance, work_of_five, work_of_eight) in
        [(1e-6, 2050, 1020), (1e-9, 6700, 1900), (1e-12, 26_250, 4060)]
    {
        let five = Method::DormandPrince(DormandPrince { tolerance, longest: 10.0 });
        let eight = Method::Dop853(Dop853 { tolerance, longest: 10.0 });
        for (method, most) in [(five, work_of_five), (eight, work_of_eight)] {
            let rows = trial.run(method, 0.3, 6.0);
            let work: usize = rows.iter().map(|row| row.evaluations).sum();
            let error = rows.iter().map(|row| (row.pos[0][0] - 1.0 - 0.3 * (10.0 * row.t).cos()).abs());
            let error = error.fold(0.0, f64::max);
            println!("{method:?}: {work} evaluations, error {error:e}");
            assert!(
                error <= 20.0 * tolerance && work <= most,
                "{method:?}: {work} evaluations, error {error:e}"
            );
        }
    }
}

/// A tolerance finer than the scalar's rounding is met as far as rounding allows, without ever shorter steps.
#[test]
fn a_tolerance_below_rounding_shortens_no_step() {
    let springs = [Spring { tail: 0, head: 1, stiffness: 100.0_f32, damping: 0.0, rest_length: 1.0 }];
    let body = Body {
        mass: &[1.0, 1.0],
        fixed: &[false, true],
        inverse_mass: &[],
        springs: &springs,
        gravity: [0.0; 3],
        air_drag: 0.0,
        facets: &[],
        inflation: None,
        massless: Massless { points: &[], first: &[0], springs: &[] },
        grids: &[],
        patches: None,
    };
    let work_at = |tolerance: f32| {
        let method = Method::Dop853(Dop853 { tolerance, longest: 10.0 });
        let system = System::new(body, None);
        let mut memory = [[0.0_f32; 3]; 2 * MOTION_ROWS];
        let mut scratch = vec![[0.0_f32; 3]; workspace_len(2, method.stages())];
        let (mut modes, mut impacts) = ([ContactState::Free; 2], [PointImpact::none(); 2]);
        let (motion, _) = Motion::cut(&mut memory, 2).expect("room");
        motion.pos[0] = [1.3, 0.0, 0.0];
        let (time, next_step, anchor) = ([0.0; 2], 0.0, 0.0);
        let mut state = State { motion, modes: &mut modes, impacts: &mut impacts, time, next_step, anchor };
        let mut work = Workspace::new(&mut scratch, 2, method.stages()).expect("room");
        state.begin(&system, 0.1, method, &mut work, &mut ()).expect("a start");
        let mut evaluations = 0;
        for _ in 0..20 {
            let report = step(&system, &mut state, 0.1, method, &mut work, &mut ()).expect("a step");
            assert!(!report.cut_short, "{tolerance:e}");
            evaluations += report.evaluations;
        }
        let error = state.motion.pos[0][0] - 1.0 - 0.3 * 20.0_f32.cos();
        assert!(error.abs() <= 1e-4, "{tolerance:e}: {error:e}");
        evaluations
    };
    let [coarse, fine] = [1e-5, 1e-12].map(work_at);
    assert!(fine <= 3 * coarse, "{fine} evaluations for nothing, {coarse} before");
}

/// NaN, infinity or a huge number at any node: the check examines many numbers at once and must detect a single one.
#[test]
fn a_node_that_left_the_numbers_is_found_anywhere() {
    for n in [1, 7, 40, 300] {
        for node in [0, n / 2, n - 1] {
            for (row, bad) in [(0, f64::NAN), (2, f64::NAN), (0, f64::INFINITY), (2, 1e200)] {
                let mut memory = vec![[1.0; 3]; MOTION_ROWS * n];
                memory[row * n + node][1] = bad;
                let (motion, _) = Motion::cut(&mut memory, n).expect("room");
                assert_eq!(
                    motion.check_finite(),
                    Err(NodeFault::NotFinite { node }),
                    "{bad} in row {row} of {n}"
                );
            }
        }
    }
}
