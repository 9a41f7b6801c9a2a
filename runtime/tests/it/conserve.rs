//! Many steps of the energy-momentum method at once: against the same steps one by one in lists, to rounding; the same
//! bits in all registers and however many are taken at once; energy and momenta.

use proptest::prelude::*;
use smartbed_runtime::flexible::PressureForm;
use smartbed_runtime::flexible::energy::eval_energies;
use smartbed_runtime::flexible::grid::{Conserve, Course};
use smartbed_runtime::kernel::{self, Registers};
use smartbed_runtime::ode::nodes::Method;
use smartbed_runtime::real::Scalar;
use smartbed_runtime::scene::{Marching, Rows, State, march};
use smartbed_runtime::vec3::{self, Vec3};

use crate::march::Sheet;

const H: f64 = 0.05;

fn courses<S: Scalar>(sheet: &Sheet<S>) -> Vec<Course<S>> {
    let grid = sheet.grid();
    (0..=sheet.rows).map(|row| Course::new(&grid, row, &sheet.inverse_mass, &sheet.beside)).collect()
}

/// Spans of steps at once; all numbers of the motion then, and how many were taken. `look` sees the state after each.
fn marched<S: Scalar>(
    sheet: &Sheet<S>,
    form: PressureForm,
    h: f64,
    spans: &[usize],
    mut look: impl FnMut(&State<S>),
) -> (Vec<u64>, usize) {
    let (grids, mut courses, mut is_current) = ([sheet.grid()], courses(sheet), false);
    let system = sheet.system(&grids, form);
    sheet.run(form, |_, state, work| {
        let mut taken = 0;
        for steps in spans {
            let rows = Rows::EnergyMomentum(&mut courses);
            let marching = Marching { rows, beside: &sheet.beside, is_current: &mut is_current };
            taken += usize::from(march(&system, state, (S::from_f64(h), *steps), marching, work));
            look(state);
        }
        taken
    })
}

/// The largest difference of two motions' positions, velocities and forces, over the largest such number.
fn difference(one: &[u64], other: &[u64]) -> f64 {
    let numbers = |bits: &[u64]| bits.iter().map(|bits| f64::from_bits(*bits)).collect::<Vec<f64>>();
    let (one, other) = (numbers(one), numbers(other));
    let largest = one.iter().fold(0.0, |largest: f64, x| largest.max(x.abs()));
    let differences = one.iter().zip(&other).map(|(a, b)| (a - b).abs() / largest);
    differences.fold(0.0, f64::max)
}

fn check<S: Scalar>(sheet: &Sheet<S>, bound: f64) {
    for form in [PressureForm::Exact, PressureForm::Facet] {
        let (at_once, taken) = marched(sheet, form, H, &[5], |_| {});
        let (stepped, done) = sheet.step_by_step(Method::EnergyMomentum, form, S::from_f64(H), 5);
        assert_eq!(taken == 1, done.is_ok(), "{done:?}");
        // A sheet that is torn is refused both ways.
        if taken == 0 {
            continue;
        }
        let off = difference(&stepped, &at_once);
        assert!(off <= bound, "{off:e}");
        assert!(marched(sheet, form, H, &[2, 1, 2], |_| {}).0 == at_once);
    }
}

fn check_registers<S: Scalar>(sheet: &Sheet<S>) {
    let (form, grid) = (PressureForm::Exact, sheet.grid());
    let [plain, avx2, avx512] = [Registers::Plain, Registers::Avx2, Registers::Avx512].map(|registers| {
        let (mut courses, mut evaluations) = (courses(sheet), 0);
        let (numbers, taken) = sheet.run(form, |system, state, _| {
            let span = sheet.span(&grid, form, (S::from_f64(H), 3), system, state);
            let kernel = Conserve { span, courses: &mut courses, evaluations: &mut evaluations };
            kernel::run_within(registers, kernel)
        });
        (numbers, evaluations, taken)
    });
    assert!(plain == avx2 && plain == avx512);
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(60))]

    #[test]
    fn steps_at_once_are_those_one_by_one(rows in 1_usize..9, columns in 1_usize..=32, seed in 0..u64::MAX) {
        check(&Sheet::<f64>::new(rows, columns, seed, 3.0), 1e-12);
        check(&Sheet::<f32>::new(rows, columns, seed, 3.0), 1e-4);
    }

    #[test]
    fn wider_registers_conserve_with_the_same_bits(rows in 1_usize..9, columns in 1_usize..=32, seed in 0..u64::MAX) {
        check_registers(&Sheet::<f64>::new(rows, columns, seed, 3.0));
        check_registers(&Sheet::<f32>::new(rows, columns, seed, 3.0));
    }
}

/// A spring that collapses pushes sideways: the iteration then converges far more slowly than it should, which it sees.
#[test]
fn a_spring_collapses() {
    check(&Sheet::<f64>::new(8, 7, 12_103_137_908_093_219_573, 3.0), 1e-12);
    check(&Sheet::<f32>::new(8, 7, 12_103_137_908_093_219_573, 3.0), 1e-4);
}

/// A sheet without gas whose springs are all stiff enough to hold it together.
fn stiff(rows: usize, seed: u64) -> Sheet<f64> {
    let mut sheet = Sheet::<f64>::new(rows, 30, seed, 0.0);
    let stiffer = |stiffness: &mut f64| *stiffness = if *stiffness > 0.0 { 100.0 + *stiffness } else { 0.0 };
    sheet.springs.iter_mut().for_each(|spring| stiffer(&mut spring.stiffness));
    sheet.families.iter_mut().flat_map(|[stiffness, _]| stiffness).for_each(stiffer);
    sheet
}

/// Momentum (kg m/s) and angular momentum (kg m^2/s).
fn momenta(sheet: &Sheet<f64>, state: &State<f64>) -> [Vec3<f64>; 2] {
    let nodes = sheet.mass.iter().zip(state.motion.pos.iter().zip(state.motion.vel.iter()));
    nodes.fold([[0.0; 3]; 2], |[linear, angular], (mass, (x, v))| {
        [vec3::axpy(linear, *mass, *v), vec3::axpy(angular, *mass, vec3::cross(*x, *v))]
    })
}

/// A free sheet without gas: gravity adds its impulse to the momentum, its moment to the angular momentum.
#[test]
fn a_free_sheet_keeps_its_momenta() {
    let mut sheet = stiff(8, 5);
    sheet.fixed.fill(false);
    sheet.inverse_mass = sheet.mass.iter().map(|mass| [1.0 / mass; 3]).collect();
    let (mass, g) = (sheet.mass.iter().sum::<f64>(), sheet.system(&[], PressureForm::Exact).body.gravity);
    let mut before = None;
    let mut look = |state: &State<f64>| {
        let [linear, angular] = momenta(&sheet, state);
        let time = state.time[0];
        let moment = sheet.mass.iter().zip(state.motion.pos.iter());
        let centre = moment.fold([0.0; 3], |sum, (mass, x)| vec3::axpy(sum, *mass, *x));
        // The centre's parabola: its moment about the origin integrates to t (centre x g) less the drift's part.
        let linear = vec3::axpy(linear, -mass * time, g);
        let angular = vec3::axpy(angular, -time, vec3::cross(centre, g));
        let angular = vec3::axpy(angular, 0.5 * time * time, vec3::cross(linear, g));
        let [first, spin] = *before.get_or_insert([linear, angular]);
        let size = |a: Vec3<f64>| vec3::norm(a);
        assert!(size(vec3::sub(linear, first)) <= 1e-12 * mass * 10.0, "{time}");
        assert!(size(vec3::sub(angular, spin)) <= 1e-12 * mass * 300.0, "{time}");
    };
    let (_, taken) = marched(&sheet, PressureForm::Exact, 0.01, &[100; 10], &mut look);
    assert_eq!(taken, 10);
}

/// Energy over a thousand steps, h w up to 2, where plain iteration ends.
#[test]
fn a_sheet_keeps_its_energy() {
    let sheet = stiff(4, 7);
    for h in [0.005, 0.02, 0.05] {
        let system = sheet.system(&[], PressureForm::Exact);
        let (mut start, mut worst, mut exchanged) = (None, 0.0_f64, 0.0_f64);
        let look = |state: &State<f64>| {
            let energies = eval_energies(&system.body, state.motion.pos, state.motion.vel);
            let total = energies.total();
            worst = worst.max((total - *start.get_or_insert(total)).abs());
            exchanged = exchanged.max(energies.spring);
        };
        let (_, taken) = marched(&sheet, PressureForm::Exact, h, &[20; 50], look);
        assert_eq!(taken, 50, "{h}");
        assert!(worst <= 1e-12 * exchanged, "{h}: {worst:e} of {exchanged}");
    }
}
