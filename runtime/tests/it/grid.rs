//! A grid's forces against those of its lists, spring by spring and facet by facet: the same numbers, whatever is missing.

use proptest::prelude::*;
use smartbed_runtime::flexible::block::Pulls;
use smartbed_runtime::flexible::force;
use smartbed_runtime::flexible::grid::{Family, Grid, Run, Weave, pitch};
use smartbed_runtime::flexible::{Body, BodyError, Gas, Inflation, PressureForm, Spring};
use smartbed_runtime::kernel::{self, Registers};
use smartbed_runtime::real::Scalar;
use smartbed_runtime::vec3::Vec3;

use crate::random::Random;

/// A grid of nodes with holes among its springs and cells, as lists and as what a [`Grid`] borrows.
struct Net<S> {
    columns: usize,
    rows: usize,
    pos: Vec<Vec3<S>>,
    springs: Vec<Spring<S>>,
    facets: Vec<[usize; 4]>,
    runs: Vec<Run>,
    starts: Vec<usize>,
    families: [[Vec<S>; 2]; 2],
    mass: Vec<S>,
    cells: Vec<S>,
}

impl<S: Scalar> Net<S> {
    /// Nodes about a metre apart, numbered with a jump wherever the seed says so.
    fn new(rows: usize, columns: usize, seed: u64) -> Net<S> {
        let mut random = Random::new(seed);
        let mut draw = move |from: f64, to: f64| S::from_f64(random.between(from, to));
        let mut net = Net {
            columns,
            rows,
            pos: Vec::new(),
            springs: Vec::new(),
            facets: Vec::new(),
            runs: Vec::new(),
            starts: vec![0],
            families: [(); 2].map(|()| [(); 2].map(|()| vec![S::ZERO; rows * pitch(columns)])),
            mass: vec![S::ZERO; rows * pitch(columns)],
            cells: vec![S::ZERO; rows * pitch(columns)],
        };
        let mut nodes = Vec::new();
        for row in 0..rows {
            for column in 0..columns {
                if column == 0 || draw(0.0, 1.0) < S::from_f64(0.1) {
                    net.pos.push([S::ZERO; 3]);
                    net.runs.push(Run { column, node: net.pos.len(), length: 0 });
                }
                nodes.push(net.pos.len());
                net.runs.last_mut().expect("a run").length += 1;
                net.mass[row * pitch(columns) + column] = S::ONE;
                let [x, y] = [column, row].map(|i| S::from_f64(i as f64));
                net.pos.push([x + draw(-0.3, 0.3), y + draw(-0.3, 0.3), draw(-0.5, 0.5)]);
            }
            net.starts.push(net.runs.len());
        }
        for (family, way, [last_row, last_column]) in
            [(0, 1, [rows, columns - 1]), (1, columns, [rows - 1, columns])]
        {
            for place in 0..rows * columns {
                let exists = place / columns < last_row && place % columns < last_column;
                if exists && draw(0.0, 1.0) < S::from_f64(0.8) {
                    let (stiffness, rest_length) = (draw(0.0, 100.0), draw(0.2, 1.5));
                    let (tail, head) = (nodes[place], nodes[place + way]);
                    net.springs.push(Spring { tail, head, stiffness, damping: S::ZERO, rest_length });
                    let place = place / columns * pitch(columns) + place % columns;
                    net.families[family][0][place] = stiffness;
                    net.families[family][1][place] = rest_length;
                }
            }
        }
        for row in 0..rows {
            let width = if row + 1 < rows { columns as f64 - 1.0 } else { 0.0 };
            let [a, b] = [draw(0.0, width), draw(0.0, width)].map(|x| x.to_f64().round() as usize);
            for column in a.min(b)..a.max(b) {
                let place = row * columns + column;
                let corners = [place, place + 1, place + columns + 1, place + columns];
                net.facets.push(corners.map(|place| nodes[place]));
                net.cells[row * pitch(columns) + column] = S::ONE;
            }
        }
        net
    }

    fn grid(&self) -> Grid<'_, S> {
        let [[right, right_rest], [up, up_rest]] = &self.families;
        Grid {
            columns: self.columns,
            rows: self.rows,
            runs: &self.runs,
            starts: &self.starts,
            right: Family { stiffness: right, rest_length: right_rest },
            up: Family { stiffness: up, rest_length: up_rest },
            mass: &self.mass,
            cells: &self.cells,
            facets: self.facets.len(),
            is_damped: false,
        }
    }

    /// Forces with the grid or without it.
    fn forces(&self, form: PressureForm, grid: Option<Grid<S>>) -> Result<Vec<Vec3<S>>, BodyError<S>> {
        let n = self.pos.len();
        let (mass, fixed) = (vec![S::ONE; n], vec![false; n]);
        let gas = Gas::Constant(S::from_f64(3.0));
        let body = Body {
            mass: &mass,
            fixed: &fixed,
            inverse_mass: &[],
            springs: &self.springs,
            facets: &self.facets,
            inflation: Some(Inflation { gas, form }),
            gravity: [S::from_f64(0.25); 3],
            grid,
            ..Body::none()
        };
        // Nodes that stand nowhere in the grid keep what they have.
        let mut force = vec![body.gravity; n];
        force::eval_elastic(&body, &body.elements(), &self.pos, &mut force)?;
        Ok(force)
    }

    fn check(&self) {
        for form in [PressureForm::Exact, PressureForm::Facet, PressureForm::Fan] {
            let (woven, listed) = (self.forces(form, Some(self.grid())), self.forces(form, None));
            assert!(woven == listed, "{form:?} of {} x {}", self.rows, self.columns);
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(200))]

    #[test]
    fn a_grid_gives_the_forces_of_its_lists(rows in 1_usize..6, columns in 1_usize..100, seed in 0_u64..u64::MAX) {
        Net::<f64>::new(rows, columns, seed).check();
        Net::<f32>::new(rows, columns, seed).check();
    }

    /// What is compiled for wider registers gives the bits of the plain loop.
    #[test]
    fn wider_registers_give_the_same_bits(rows in 1_usize..6, columns in 1_usize..100, seed in 0_u64..u64::MAX) {
        let net = Net::<f32>::new(rows, columns, seed);
        let grid = net.grid();
        let forces = |weave: bool, registers: Registers| {
            let mut force = vec![[0.5; 3]; net.pos.len()];
            let (pressure, gravity) = (Some((PressureForm::Exact, 2.0)), [0.5; 3]);
            let (pos, springs) = (&net.pos, &net.springs);
            let runaway = if weave {
                kernel::run_within(registers, Weave { grid: &grid, pressure, pos, gravity, force: &mut force })
            } else {
                kernel::run_within(registers, Pulls { springs, pos, force: &mut force })
            };
            let bits: Vec<u32> = force.as_flattened().iter().map(|x| x.to_bits()).collect();
            (runaway, bits)
        };
        for registers in [Registers::Avx2, Registers::Avx512] {
            for weave in [true, false] {
                prop_assert_eq!(forces(weave, registers), forces(weave, Registers::Plain));
            }
        }
        let mut force = vec![[0.5; 3]; net.pos.len()];
        let runaway = net.springs.iter().fold(false, |any, spring| any | spring.add_elastic(&net.pos, &mut force));
        let bits: Vec<u32> = force.as_flattened().iter().map(|x| x.to_bits()).collect();
        prop_assert_eq!(forces(false, Registers::Plain), (runaway, bits));
    }
}

/// A spring that has run away is named, with the grid as without it.
#[test]
fn a_runaway_is_found_in_a_grid() {
    let mut net = Net::<f64>::new(5, 40, 7);
    let far = net.springs[61].head;
    net.pos[far] = [300.0, -200.0, 100.0];
    let found = net.forces(PressureForm::Exact, Some(net.grid()));
    assert!(matches!(found, Err(BodyError::PressureTooHigh { .. })), "{found:?}");
    assert_eq!(found, net.forces(PressureForm::Exact, None));
}

/// The last block is seldom full: what the one before left in its lanes is not looked at.
#[test]
fn no_runaway_is_seen_where_there_is_none() {
    let mut net = Net::<f64>::new(5, 40, 7);
    for spring in &mut net.springs {
        (spring.stiffness, spring.rest_length) = (1e4, 1.0);
    }
    let mut force = vec![[0.0; 3]; net.pos.len()];
    assert!(!kernel::run(Pulls { springs: &net.springs, pos: &net.pos, force: &mut force }));
}
