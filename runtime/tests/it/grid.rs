//! Forces of a grid against those of its lists of springs and facets: equal numbers, whichever elements are missing.

use proptest::prelude::*;
use smartbed_runtime::flexible::block::Pulls;
use smartbed_runtime::flexible::force;
use smartbed_runtime::flexible::grid::{DampingForces, ElasticForces, Family, Grid, Run, pitch};
use smartbed_runtime::flexible::{Body, BodyError, Gas, Inflation, PressureForm, Spring};
use smartbed_runtime::kernel::{self, Registers};
use smartbed_runtime::ode::nodes::MeanStep;
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
    families: [[Vec<S>; 3]; 2],
    mass: Vec<S>,
    cells: Vec<S>,
    /// First node, spring and facet in the lists of the body.
    offsets: [usize; 3],
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
            families: [(); 2].map(|()| [(); 3].map(|()| vec![S::ZERO; rows * pitch(columns)])),
            mass: vec![S::ZERO; rows * pitch(columns)],
            cells: vec![S::ZERO; rows * pitch(columns)],
            offsets: [usize::MAX; 3],
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
                    let damping = if draw(0.0, 1.0) < S::from_f64(0.3) { S::ZERO } else { draw(0.0, 10.0) };
                    net.springs.push(Spring { tail, head, stiffness, damping, rest_length });
                    let place = place / columns * pitch(columns) + place % columns;
                    net.families[family][0][place] = stiffness;
                    net.families[family][1][place] = rest_length;
                    net.families[family][2][place] = damping;
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
        let [right, up] = [0, 1].map(|n: usize| {
            let [stiffness, rest_length, damping] = &self.families[n];
            Family { stiffness, rest_length, damping }
        });
        let [node, spring, facet] = self.offsets;
        Grid {
            columns: self.columns,
            rows: self.rows,
            runs: &self.runs,
            starts: &self.starts,
            right,
            up,
            mass: &self.mass,
            cells: &self.cells,
            nodes: [node, node + self.pos.len()],
            springs: [spring, spring + self.springs.len()],
            facets: [facet, facet + self.facets.len()],
        }
    }

    /// Numbers of nodes, springs and facets counted from those given, as in a body of several parts.
    fn shift(&mut self, [node, spring, facet]: [usize; 3]) {
        self.offsets = [node, spring, facet];
        self.runs.iter_mut().for_each(|run| run.node += node);
        for end in self.springs.iter_mut().flat_map(|spring| [&mut spring.tail, &mut spring.head]) {
            *end += node;
        }
        self.facets.iter_mut().flatten().for_each(|corner| *corner += node);
    }

    /// Forces of positions, of speeds and their means over a step on all nodes of some nets, whose lists follow one
    /// another, with grids or without; behind each net stand three nodes, joined by two springs and a facet, that are
    /// on none.
    fn forces(
        nets: &mut [Net<S>],
        form: PressureForm,
        woven: bool,
    ) -> Result<[Vec<Vec3<S>>; 3], BodyError<S>> {
        let (mut pos, mut springs, mut facets) = (Vec::new(), Vec::new(), Vec::new());
        for net in nets.iter_mut() {
            if net.offsets == [usize::MAX; 3] {
                net.shift([pos.len(), springs.len(), facets.len()]);
            }
            pos.extend(&net.pos);
            let [a, b, c] = [0, 1, 2].map(|n| pos.len() + n);
            pos.extend([[0.0, 0.1, 0.7], [0.4, -0.3, 0.1], [0.9, 1.1, -0.6]].map(|x| x.map(S::from_f64)));
            springs.extend(&net.springs);
            let [stiffness, damping, rest_length] = [7.0, 0.3, 0.8].map(S::from_f64);
            springs.extend([(a, b), (b, c)].map(|(tail, head)| Spring {
                tail,
                head,
                stiffness,
                damping,
                rest_length,
            }));
            facets.extend(&net.facets);
            facets.push([a, b, c, c]);
        }
        let n = pos.len();
        let vel: Vec<Vec3<S>> = pos.iter().map(|[x, y, z]| [*y, -*z, *x * *y]).collect();
        let (mass, fixed) = (vec![S::ONE; n], vec![false; n]);
        let gas = Gas::Constant(S::from_f64(3.0));
        let grids: Vec<Grid<S>> = nets.iter().filter(|_| woven).map(Net::grid).collect();
        let body = Body {
            mass: &mass,
            fixed: &fixed,
            inverse_mass: &[],
            springs: &springs,
            facets: &facets,
            inflation: Some(Inflation { gas, form }),
            gravity: [S::from_f64(0.25); 3],
            air_drag: S::from_f64(0.125),
            grids: &grids,
            ..Body::none()
        };
        // Nodes that stand nowhere in the grid keep what they have.
        let [mut elastic, mut viscous, mut mean] = [(); 3].map(|()| vec![body.gravity; n]);
        force::eval_elastic(&body, &body.elements(), &pos, &mut elastic)?;
        force::eval_viscous(&body, &body.elements(), &pos, &vel, &mut viscous);
        let h = S::from_f64(0.25);
        let dx: Vec<Vec3<S>> = vel.iter().map(|v| v.map(|v| v * h)).collect();
        let end: Vec<Vec3<S>> =
            pos.iter().zip(&dx).map(|(x, d)| [0, 1, 2].map(|c: usize| x[c] + d[c])).collect();
        let way = MeanStep { h, pos: [&pos, &pos, &end], dx: &dx, vel: &vel };
        force::eval_mean(&body, &body.elements(), &way, &mut mean)?;
        Ok([elastic, viscous, mean])
    }

    fn check(mut nets: Vec<Net<S>>) {
        for form in [PressureForm::Exact, PressureForm::Facet, PressureForm::Fan] {
            let (woven, listed) = (Net::forces(&mut nets, form, true), Net::forces(&mut nets, form, false));
            assert!(woven == listed, "{form:?} of {} grids", nets.len());
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(200))]

    #[test]
    fn a_grid_gives_the_forces_of_its_lists(rows in 1_usize..6, columns in 1_usize..100, seed in 0..u64::MAX) {
        Net::check(vec![Net::<f64>::new(rows, columns, seed)]);
        Net::check(vec![Net::<f32>::new(rows, columns, seed), Net::new(columns.min(7), rows, seed + 1)]);
    }

    /// Code compiled for wider registers gives results bitwise equal to the plain loop.
    #[test]
    fn wider_registers_give_the_same_bits(rows in 1_usize..6, columns in 1_usize..100, seed in 0..u64::MAX) {
        let mut net = Net::<f32>::new(rows, columns, seed);
        net.shift([0; 3]);
        let vel: Vec<Vec3<f32>> = net.pos.iter().map(|[x, y, z]| [*y, -*z, *x * *y]).collect();
        let grid = net.grid();
        let forces = |elastic: bool, registers: Registers| {
            let mut force = vec![[0.5; 3]; net.pos.len()];
            let (pressure, gravity) = (Some((PressureForm::Exact, 2.0)), [0.5; 3]);
            let (pos, springs) = (&net.pos, &net.springs);
            let runaway = if elastic {
                let mut damping = force.clone();
                let air_drag = 0.25;
                kernel::run_within(registers, DampingForces { grid: &grid, pos, vel: &vel, air_drag, force: &mut damping });
                let runaway =
                    kernel::run_within(registers, ElasticForces { grid: &grid, pressure, pos, gravity, force: &mut force });
                force.extend(damping);
                runaway
            } else {
                kernel::run_within(registers, Pulls { springs, pos, force: &mut force })
            };
            let bits: Vec<u32> = force.as_flattened().iter().map(|x| x.to_bits()).collect();
            (runaway, bits)
        };
        for registers in [Registers::Avx2, Registers::Avx512] {
            for elastic in [true, false] {
                prop_assert_eq!(forces(elastic, registers), forces(elastic, Registers::Plain));
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
    let mut nets = [net];
    let found = Net::forces(&mut nets, PressureForm::Exact, true);
    assert!(matches!(found, Err(BodyError::PressureTooHigh { .. })), "{found:?}");
    assert_eq!(found, Net::forces(&mut nets, PressureForm::Exact, false));
}

/// The last block is seldom full: values left in its lanes by the previous block are not examined.
#[test]
fn no_runaway_is_seen_where_there_is_none() {
    let mut net = Net::<f64>::new(5, 40, 7);
    for spring in &mut net.springs {
        (spring.stiffness, spring.rest_length) = (1e4, 1.0);
    }
    let mut force = vec![[0.0; 3]; net.pos.len()];
    assert!(!kernel::run(Pulls { springs: &net.springs, pos: &net.pos, force: &mut force }));
}
