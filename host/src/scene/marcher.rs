//! Memory of many steps at once.
//!
//! In: a body. Out: the rows of its grid and the facets beside it, if the runtime can take many steps of it at once.

use smartbed_runtime::contact::System;
use smartbed_runtime::flexible::grid::{Corner, Course, Grid, Line};
use smartbed_runtime::ode::nodes::Method;
use smartbed_runtime::real::Scalar;
use smartbed_runtime::scene::{Marching, Rows, can_march};

/// Facets beside the cells at most: each is taken by itself in every step.
const MOST_BESIDE: usize = 16;
/// Forces of such facets on a node at most.
const MOST_FORCES: usize = 2;

/// What a [`Marching`] borrows.
#[derive(Clone, Debug)]
pub struct Marcher<S> {
    rows: Memory<S>,
    beside: Vec<[Corner; 4]>,
    is_current: bool,
}

/// What [`Rows`] borrow.
#[derive(Clone, Debug)]
enum Memory<S> {
    Verlet(Vec<Line<S>>),
    EnergyMomentum(Vec<Course<S>>),
}

impl<S: Scalar> Marcher<S> {
    /// None where the body cannot be marched by the method.
    pub fn new(system: &System<S>, method: Method<S>) -> Option<Self> {
        let body = &system.body;
        let [grid] = body.grids else { return None };
        if !can_march(system) {
            return None;
        }
        let beside = beside(grid, body.facets, body.points())?;
        let (all, masses) = (0..=grid.rows, body.inverse_mass);
        let rows = match method {
            Method::Verlet => Memory::Verlet(all.map(|row| Line::new(grid, row, masses, &beside)).collect()),
            Method::EnergyMomentum => {
                Memory::EnergyMomentum(all.map(|row| Course::new(grid, row, masses, &beside)).collect())
            }
            _ => return None,
        };
        Some(Marcher { rows, beside, is_current: false })
    }

    /// The memory.
    pub fn view(&mut self) -> Marching<'_, S> {
        let rows = match &mut self.rows {
            Memory::Verlet(lines) => Rows::Verlet(lines),
            Memory::EnergyMomentum(courses) => Rows::EnergyMomentum(courses),
        };
        Marching { rows, beside: &self.beside, is_current: &mut self.is_current }
    }

    /// Says that something else than a march may have changed the state.
    pub fn forget(&mut self) {
        self.is_current = false;
    }
}

/// Corners of the facets that are no cells; none where they, or the forces on one of their nodes, are too many.
fn beside<S>(grid: &Grid<S>, facets: &[[usize; 4]], points: usize) -> Option<Vec<[Corner; 4]>> {
    let mut places = vec![None; points];
    for (row, range) in grid.starts.windows(2).enumerate() {
        for run in grid.runs.get(range[0]..range[1])? {
            for i in 0..run.length {
                *places.get_mut(run.node + i)? = Some([row, run.column + i]);
            }
        }
    }
    let [first, end] = grid.facets;
    let others = || facets[..first].iter().chain(&facets[end..]);
    if first > 0 || others().count() > MOST_BESIDE {
        return None;
    }
    let mut forces = vec![0; points];
    let mut corner = |node: usize| {
        let [row, column] = places[node]?;
        let rank = forces[node];
        forces[node] += 1;
        (rank < MOST_FORCES).then_some(Corner { row, column, rank })
    };
    others().map(|[a, b, c, d]| Some([corner(*a)?, corner(*b)?, corner(*c)?, corner(*d)?])).collect()
}
