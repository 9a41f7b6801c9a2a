//! Many steps at once against the same steps one by one, spring by spring and facet by facet: every bit, in all
//! registers.

use proptest::prelude::*;
use smartbed_runtime::contact::compensation::PointImpact;
use smartbed_runtime::contact::{ContactState, System};
use smartbed_runtime::flexible::grid::{Corner, Family, Grid, Line, March, Run, Span, pitch};
use smartbed_runtime::flexible::{Body, BodyError, Gas, Inflation, PressureForm, Spring};
use smartbed_runtime::kernel::{self, Registers};
use smartbed_runtime::ode::nodes::{MOTION_ROWS, Method, Motion, Workspace, workspace_len};
use smartbed_runtime::real::Scalar;
use smartbed_runtime::scene::{Marching, Rows, State, can_march, march, step};
use smartbed_runtime::vec3::Vec3;

use crate::random::Random;

/// Steps one by one: which was refused, and why.
pub type Stepped<S> = Result<(), (usize, BodyError<S>)>;

/// A sheet with holes among its springs and cells, some nodes fixed, numbered with jumps; as lists and as a grid.
pub struct Sheet<S> {
    pub columns: usize,
    pub rows: usize,
    pub runs: Vec<Run>,
    pub starts: Vec<usize>,
    pub families: [[Vec<S>; 2]; 2],
    pub grid_mass: Vec<S>,
    pub cells: Vec<S>,
    pub mass: Vec<S>,
    pub fixed: Vec<bool>,
    pub inverse_mass: Vec<Vec3<S>>,
    pub springs: Vec<Spring<S>>,
    pub facets: Vec<[usize; 4]>,
    pub cell_count: usize,
    pub beside: Vec<[Corner; 4]>,
    pub pressure: S,
    /// Positions and velocities.
    pub start: [Vec<Vec3<S>>; 2],
}

impl<S: Scalar> Sheet<S> {
    pub fn new(rows: usize, columns: usize, seed: u64, pressure: f64) -> Self {
        let mut random = Random::new(seed);
        let mut draw = move |from: f64, to: f64| random.between(from, to);
        let count = rows * columns;
        // Some nodes come behind all others in the lists, as the frame of a sheet does.
        let late: Vec<bool> = (0..count).map(|_| draw(0.0, 1.0) < 0.1).collect();
        let order = (0..count).filter(|i| !late[*i]).chain((0..count).filter(|i| late[*i]));
        let mut node = vec![0; count];
        order.enumerate().for_each(|(number, place)| node[place] = number);
        let (mut runs, mut starts): (Vec<Run>, Vec<usize>) = (Vec::new(), vec![0]);
        for row in 0..rows {
            let first = runs.len();
            for column in 0..columns {
                let node = node[row * columns + column];
                match runs[first..].last_mut() {
                    Some(run) if run.node + run.length == node => run.length += 1,
                    _ => runs.push(Run { column, node, length: 1 }),
                }
            }
            starts.push(runs.len());
        }
        let numbers = || vec![S::ZERO; rows * pitch(columns)];
        let in_rows = |place: usize| place / columns * pitch(columns) + place % columns;
        let [mut places, mut speeds] = [vec![[S::ZERO; 3]; count], vec![[S::ZERO; 3]; count]];
        let (mut mass, mut grid_mass, mut fixed) = (vec![S::ZERO; count], numbers(), vec![false; count]);
        for (place, node) in node.iter().enumerate() {
            let [x, y] = [place % columns, place / columns].map(|i| i as f64);
            places[*node] = [x + draw(-0.2, 0.2), y + draw(-0.2, 0.2), draw(-0.3, 0.3)].map(S::from_f64);
            speeds[*node] = [(); 3].map(|()| S::from_f64(draw(-1.0, 1.0)));
            mass[*node] = S::from_f64(draw(0.5, 2.0));
            grid_mass[in_rows(place)] = mass[*node];
            // The first row is fixed as a whole.
            fixed[*node] = place < columns || draw(0.0, 1.0) < 0.15;
        }
        let mut families = [(); 2].map(|()| [(); 2].map(|()| numbers()));
        let mut springs = Vec::new();
        for (family, way) in [(0, 1), (1, columns)] {
            for place in 0..count {
                let exists =
                    if family == 0 { place % columns + 1 < columns } else { place + columns < count };
                if exists && draw(0.0, 1.0) < 0.8 {
                    let [stiffness, rest_length] = [draw(0.0, 100.0), draw(0.6, 1.4)].map(S::from_f64);
                    let (tail, head) = (node[place], node[place + way]);
                    springs.push(Spring { tail, head, stiffness, damping: S::ZERO, rest_length });
                    families[family][0][in_rows(place)] = stiffness;
                    families[family][1][in_rows(place)] = rest_length;
                }
            }
        }
        let (mut cells, mut facets, mut holes) = (numbers(), Vec::new(), Vec::new());
        for place in (0..count).filter(|place| place % columns + 1 < columns && place + columns < count) {
            let corners = [place, place + 1, place + columns + 1, place + columns];
            if draw(0.0, 1.0) < 0.8 {
                facets.push(corners.map(|place| node[place]));
                cells[in_rows(place)] = S::ONE;
            } else if (place % columns).is_multiple_of(2) && (place / columns).is_multiple_of(2) {
                holes.push(corners);
            }
        }
        let cell_count = facets.len();
        let mut beside = Vec::new();
        for [_, b, c, d] in holes {
            facets.push([b, c, d, d].map(|place| node[place]));
            let corner = |place, rank| Corner { row: place / columns, column: place % columns, rank };
            beside.push([corner(b, 0), corner(c, 0), corner(d, 0), corner(d, 1)]);
        }
        let inverse = |(mass, fixed): (&S, &bool)| [if *fixed { S::ZERO } else { S::ONE / *mass }; 3];
        Sheet {
            inverse_mass: mass.iter().zip(&fixed).map(inverse).collect(),
            pressure: S::from_f64(pressure),
            start: [places, speeds],
            columns,
            rows,
            runs,
            starts,
            families,
            grid_mass,
            cells,
            mass,
            fixed,
            springs,
            facets,
            cell_count,
            beside,
        }
    }

    pub fn grid(&self) -> Grid<'_, S> {
        let [right, up] = [0, 1].map(|n: usize| Family {
            stiffness: &self.families[n][0],
            rest_length: &self.families[n][1],
            damping: &[],
        });
        Grid {
            columns: self.columns,
            rows: self.rows,
            runs: &self.runs,
            starts: &self.starts,
            right,
            up,
            mass: &self.grid_mass,
            cells: &self.cells,
            nodes: [0, self.mass.len()],
            springs: [0, self.springs.len()],
            facets: [0, self.cell_count],
        }
    }

    pub fn system<'a>(&'a self, grids: &'a [Grid<'a, S>], form: PressureForm) -> System<'a, S> {
        let body = Body {
            mass: &self.mass,
            fixed: &self.fixed,
            inverse_mass: &self.inverse_mass,
            springs: &self.springs,
            facets: &self.facets,
            gravity: [0.5, 0.0, -9.81].map(S::from_f64),
            inflation: Some(Inflation { gas: Gas::Constant(self.pressure), form }),
            grids,
            ..Body::none()
        };
        System::new(body, None)
    }

    /// Lets `work` go on from the start; returns all numbers of the motion then, and the time.
    pub fn run<R>(
        &self,
        form: PressureForm,
        work: impl for<'a> FnOnce(&System<S>, &mut State<'a, S>, &mut Workspace<'a, S>) -> R,
    ) -> (Vec<u64>, R) {
        let n = self.mass.len();
        let mut buffer = vec![[S::ZERO; 3]; MOTION_ROWS * n];
        let mut memory = vec![[S::ZERO; 3]; workspace_len(n, 1)];
        let (motion, _) = Motion::cut(&mut buffer, n).expect("memory");
        let mut workspace = Workspace::new(&mut memory, n, 1).expect("memory");
        motion.pos.copy_from_slice(&self.start[0]);
        motion.vel.copy_from_slice(&self.start[1]);
        let (mut modes, mut impacts) = (vec![ContactState::Free; n], vec![PointImpact::none(); n]);
        let mut state = State {
            motion,
            modes: &mut modes,
            impacts: &mut impacts,
            time: [S::ZERO; 2],
            next_step: S::ZERO,
            anchor: S::ZERO,
        };
        let system = self.system(&[], form);
        state.begin(&system, S::ONE, Method::Verlet, &mut workspace, &mut ()).expect("a start");
        let done = work(&system, &mut state, &mut workspace);
        let Motion { pos, pos_rest, vel, vel_rest, elastic, viscous } = &state.motion;
        let rows = [pos, pos_rest, vel, vel_rest, elastic, viscous];
        let numbers = rows.iter().flat_map(|row| row.as_flattened());
        (numbers.chain(&state.time).map(|x| x.to_f64().to_bits()).collect(), done)
    }

    /// Steps one by one, in lists.
    pub fn step_by_step(
        &self,
        method: Method<S>,
        form: PressureForm,
        h: S,
        steps: usize,
    ) -> (Vec<u64>, Stepped<S>) {
        self.run(form, |system, state, work| {
            (0..steps).try_for_each(|n| {
                step(system, state, h, method, work, &mut ()).map_err(|why| (n, why)).map(|_| ())
            })
        })
    }

    /// Steps from the start.
    pub fn span<'a, 'm>(
        &'a self,
        grid: &'a Grid<'a, S>,
        form: PressureForm,
        (h, steps): (S, usize),
        system: &System<S>,
        state: &'a mut State<'m, S>,
    ) -> Span<'a, 'm, S> {
        Span {
            grid,
            form,
            pressure: self.pressure,
            beside: &self.beside,
            gravity: system.body.gravity,
            h,
            steps,
            motion: &mut state.motion,
            goes_on: false,
        }
    }

    fn lines(&self) -> Vec<Line<S>> {
        let grid = self.grid();
        (0..=self.rows).map(|row| Line::new(&grid, row, &self.inverse_mass, &self.beside)).collect()
    }

    /// Spans of steps at once, each going on from the rows in which the one before left its numbers.
    fn marched(&self, form: PressureForm, h: S, spans: &[usize]) -> (Vec<u64>, Vec<bool>) {
        let (grids, mut lines, mut is_current) = ([self.grid()], self.lines(), false);
        let system = self.system(&grids, form);
        assert!(can_march(&system));
        self.run(form, |_, state, work| {
            let mut span = |steps: &usize| {
                let marching = Marching {
                    rows: Rows::Verlet(&mut lines),
                    beside: &self.beside,
                    is_current: &mut is_current,
                };
                march(&system, state, (h, *steps), marching, work)
            };
            spans.iter().map(&mut span).collect()
        })
    }

    fn check(&self, spans: &[usize]) {
        let h = S::from_f64(1e-2);
        for form in [PressureForm::Exact, PressureForm::Facet] {
            let (marched, taken) = self.marched(form, h, spans);
            assert!(taken.iter().all(|taken| *taken), "{form:?} {spans:?}");
            let (stepped, done) = self.step_by_step(Method::Verlet, form, h, spans.iter().sum());
            assert_eq!(done, Ok(()));
            assert!(marched == stepped, "{form:?} {spans:?}");
        }
    }

    /// The same in each kind of registers.
    fn check_registers(&self, steps: usize) {
        let (form, h) = (PressureForm::Exact, S::from_f64(1e-2));
        let (stepped, _) = self.step_by_step(Method::Verlet, form, h, steps);
        let grid = self.grid();
        for registers in [Registers::Plain, Registers::Avx2, Registers::Avx512] {
            let mut lines = self.lines();
            let (marched, taken) = self.run(form, |system, state, _| {
                let span = self.span(&grid, form, (h, steps), system, state);
                kernel::run_within(registers, March { span, lines: &mut lines })
            });
            assert!(taken);
            // The time is the caller's.
            let count = marched.len() - 2;
            assert!(marched[..count] == stepped[..count], "{registers:?}");
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(60))]

    #[test]
    fn a_march_has_the_bits_of_its_steps(rows in 1_usize..9, columns in 1_usize..=32, seed in 0..u64::MAX, first in 1_usize..6) {
        Sheet::<f64>::new(rows, columns, seed, 3.0).check(&[first, 1, 2]);
        Sheet::<f32>::new(rows, columns, seed, 3.0).check(&[first, 1, 2]);
    }

    #[test]
    fn wider_registers_march_to_the_same_bits(rows in 1_usize..9, columns in 1_usize..=32, seed in 0..u64::MAX) {
        Sheet::<f64>::new(rows, columns, seed, 3.0).check_registers(3);
        Sheet::<f32>::new(rows, columns, seed, 3.0).check_registers(3);
    }
}

/// Steps one by one between two marches, and a march that was refused, leave nothing of themselves in the rows.
#[test]
fn a_march_goes_on_from_what_the_state_has_become() {
    let (form, h) = (PressureForm::Exact, 1e-2);
    let sheet = Sheet::<f64>::new(6, 20, 11, 3.0);
    let (grids, mut lines, mut is_current) = ([sheet.grid()], sheet.lines(), false);
    let system = sheet.system(&grids, form);
    let (marched, ()) = sheet.run(form, |_, state, work| {
        let mut span = |h: f64, steps: usize| {
            let marching = Marching {
                rows: Rows::Verlet(&mut lines),
                beside: &sheet.beside,
                is_current: &mut is_current,
            };
            march(&system, state, (h, steps), marching, work)
        };
        assert!(span(h, 4));
        // Steps so long that springs run away: refused, and what the rows hold then is of no use.
        assert!(!span(1e3, 5));
        assert!(span(h, 3) && span(h, 2));
        step(&system, state, h, Method::Verlet, work, &mut ()).expect("a step");
        let marching =
            Marching { rows: Rows::Verlet(&mut lines), beside: &sheet.beside, is_current: &mut false };
        assert!(march(&system, state, (h, 5), marching, work));
    });
    let (stepped, done) = sheet.step_by_step(Method::Verlet, form, h, 15);
    assert_eq!(done, Ok(()));
    assert!(marched == stepped);
}

/// A march of which a step would be refused does not begin; the step is then found, and refused, one by one.
#[test]
fn a_march_into_a_refusal_does_not_begin() {
    let h = 1e-2;
    // The pressure stretches a spring beyond what is allowed.
    let sheet = Sheet::<f64>::new(6, 20, 11, 300.0);
    let (start, _) = sheet.step_by_step(Method::Verlet, PressureForm::Exact, h, 0);
    let (_, refused) = sheet.step_by_step(Method::Verlet, PressureForm::Exact, h, 1000);
    let Err((at, why)) = refused else { panic!("no step is refused") };
    assert!(matches!(why, BodyError::PressureTooHigh { .. }), "{why:?}");
    assert!(at > 2, "{at}");
    for steps in [at + 1, at + 2, at + 30] {
        assert!(sheet.marched(PressureForm::Exact, h, &[steps]) == (start.clone(), vec![false]), "{steps}");
    }
    sheet.check(&[at - 1]);
    // A velocity whose square is no number.
    let mut sheet = Sheet::<f64>::new(6, 20, 11, 3.0);
    let moving = sheet.fixed.iter().position(|fixed| !fixed).expect("one moves");
    sheet.start[1][moving] = [1e153, 0.0, 0.0];
    let (start, _) = sheet.step_by_step(Method::Verlet, PressureForm::Exact, h, 0);
    assert!(sheet.step_by_step(Method::Verlet, PressureForm::Exact, h, 50).1.is_err());
    assert!(sheet.marched(PressureForm::Exact, h, &[50]) == (start, vec![false]));
}

/// What has a ground, dampers, air, another gas or more than its grid goes step by step.
#[test]
fn what_cannot_be_marched_is_told() {
    let sheet = Sheet::<f64>::new(6, 20, 11, 3.0);
    let grids = [sheet.grid()];
    let system = sheet.system(&grids, PressureForm::Exact);
    assert!(can_march(&system));
    let with = |change: &dyn Fn(&mut Body<f64>)| {
        let mut body = system.body;
        change(&mut body);
        can_march(&System::new(body, None))
    };
    assert!(!with(&|body| body.air_drag = 0.1));
    assert!(!with(&|body| body.grids = &[]));
    assert!(!with(&|body| body.inflation = None));
    assert!(!with(&|body| body.inflation.as_mut().expect("gas").form = PressureForm::Fan));
    let sealed =
        Gas::Polytropic { pressure: 1.0, ambient: 1.0, volume: 1.0, exponent: 1.0, dead_volume: 1.0 };
    assert!(!with(&|body| body.inflation.as_mut().expect("gas").gas = sealed));
    let wide = Sheet::<f64>::new(2, 33, 11, 3.0);
    assert!(!can_march(&wide.system(&[wide.grid()], PressureForm::Exact)));
}
