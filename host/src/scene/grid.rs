//! A sheet's nodes in rows and columns, so that the runtime computes its forces row by row.
//!
//! In: the nodes of each row as the shape was built ([`Table`]), the lists. Out: the memory that a [`Grid`] borrows, or
//! nothing where the springs are not those of a grid.

use std::collections::BTreeMap;

use smartbed_runtime::flexible::grid::{Family, Grid, Run, pitch};
use smartbed_runtime::real::Scalar;

use super::lists::Lists;

/// Numbers of the nodes row by row, none where the grid has a hole.
#[derive(Clone, Debug, PartialEq)]
pub struct Table {
    /// Length of a row.
    pub columns: usize,
    /// Row after row.
    pub nodes: Vec<Option<usize>>,
}

/// What a [`Grid`] borrows.
#[derive(Clone, Debug)]
pub struct Woven<S> {
    columns: usize,
    rows: usize,
    runs: Vec<Run>,
    starts: Vec<usize>,
    right: [Vec<S>; 2],
    up: [Vec<S>; 2],
    mass: Vec<S>,
    cells: Vec<S>,
    facets: usize,
    is_damped: bool,
}

impl<S: Scalar> Woven<S> {
    /// Finds springs and facets of the lists in their table; none if there is no table, or a node or
    /// spring elsewhere.
    pub fn new(lists: &Lists) -> Option<Self> {
        let Table { columns, nodes } = lists.table.as_ref()?;
        let (columns, rows) = (*columns, nodes.len() / *columns);
        let place: BTreeMap<usize, usize> =
            nodes.iter().enumerate().filter_map(|(place, node)| Some(((*node)?, place))).collect();
        if place.len() != lists.points.len() {
            return None;
        }
        let in_rows = |place: usize| place / columns * pitch(columns) + place % columns;
        let mut taken = vec![[false; 2]; nodes.len()];
        let mut families = [(); 2].map(|()| [(); 2].map(|()| vec![S::ZERO; rows * pitch(columns)]));
        for (number, [tail, head]) in lists.springs.iter().enumerate() {
            let (tail, head) = (*place.get(tail)?, *place.get(head)?);
            let family = match head.checked_sub(tail)? {
                1 if head % columns > 0 => 0,
                way if way == columns => 1,
                _ => return None,
            };
            // A second one beside the first has no place.
            if std::mem::replace(&mut taken[tail][family], true) {
                return None;
            }
            let [stiffness, rest_length] = &mut families[family];
            let tail = in_rows(tail);
            stiffness[tail] = S::from_f64(*lists.stiffness.get(number)?);
            rest_length[tail] = S::from_f64(*lists.rest_lengths.get(number)?);
        }
        let (cells, facets) = cells(lists, &place, columns, rows)?;
        let mut mass = vec![S::ZERO; rows * pitch(columns)];
        for (node, place) in &place {
            mass[in_rows(*place)] = S::from_f64(lists.masses[*node]);
        }
        let (runs, starts) = runs(nodes, columns);
        let [right, up] = families;
        let is_damped = lists.damping.iter().any(|c| *c > 0.0);
        Some(Woven { columns, rows, runs, starts, mass, right, up, cells, facets, is_damped })
    }

    /// The grid.
    pub fn view(&self) -> Grid<'_, S> {
        Grid {
            columns: self.columns,
            rows: self.rows,
            runs: &self.runs,
            starts: &self.starts,
            right: Family { stiffness: &self.right[0], rest_length: &self.right[1] },
            up: Family { stiffness: &self.up[0], rest_length: &self.up[1] },
            mass: &self.mass,
            cells: &self.cells,
            facets: self.facets,
            is_damped: self.is_damped,
        }
    }
}

/// Nodes that follow one another in a row and in the lists, and where the runs of each row begin.
fn runs(nodes: &[Option<usize>], columns: usize) -> (Vec<Run>, Vec<usize>) {
    let (mut runs, mut starts): (Vec<Run>, Vec<usize>) = (Vec::new(), vec![0]);
    for row in nodes.chunks(columns) {
        let first = runs.len();
        for (column, node) in row.iter().enumerate().filter_map(|(column, node)| Some((column, (*node)?))) {
            match runs[first..].last_mut() {
                Some(run) if run.column + run.length == column && run.node + run.length == node => {
                    run.length += 1
                }
                _ => runs.push(Run { column, node, length: 1 }),
            }
        }
        starts.push(runs.len());
    }
    (runs, starts)
}

/// Which places of the table are first corners of facets, those of four corners that the list begins with, and their
/// number; none if they do not go row by row.
fn cells<S: Scalar>(
    lists: &Lists,
    place: &BTreeMap<usize, usize>,
    columns: usize,
    rows: usize,
) -> Option<(Vec<S>, usize)> {
    let mut cells = vec![S::ZERO; rows * pitch(columns)];
    let (mut count, mut next) = (0, 0);
    for facet in &lists.facets {
        let corners: Option<Vec<usize>> = facet.iter().map(|node| place.get(node).copied()).collect();
        let Some([a, b, c, d]) = corners.and_then(|corners| <[usize; 4]>::try_from(corners).ok()) else {
            break;
        };
        if [b, c, d] != [a + 1, a + columns + 1, a + columns] || b % columns == 0 {
            break;
        }
        if a < next {
            return None;
        }
        cells[a / columns * pitch(columns) + a % columns] = S::ONE;
        (count, next) = (count + 1, a + 1);
    }
    Some((cells, count))
}
