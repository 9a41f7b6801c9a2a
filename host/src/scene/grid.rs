//! The nodes of a sheet arranged in rows and columns, so that the runtime computes its forces row by row (SIMD).
//!
//! In: the nodes of each row as the shape was built ([`Table`]), the lists. Out: the memory that a [`Grid`] borrows, or
//! nothing if the springs are not those of a grid.

use smartbed_runtime::flexible::grid::{Family, Grid, Run, pitch};
use smartbed_runtime::real::Scalar;

use super::lists::{Lists, Table};

/// Rows shorter than this do not fill the registers: springs and facets are then faster as lists
/// (`docs/performance.md`).
const SHORTEST: usize = 12;

/// The index in the table of each node from `first` on.
struct Places {
    first: usize,
    list: Vec<usize>,
}

impl Places {
    /// `None` if the table has no nodes, or does not have each from its first to its last exactly once.
    fn new(nodes: &[Option<usize>]) -> Option<Self> {
        let all = || nodes.iter().flatten().copied();
        let (first, last) = (all().min()?, all().max()?);
        let mut list = vec![usize::MAX; last + 1 - first];
        if all().count() != list.len() {
            return None;
        }
        for (place, node) in nodes.iter().enumerate().filter_map(|(place, node)| Some((place, (*node)?))) {
            list[node - first] = place;
        }
        (!list.contains(&usize::MAX)).then_some(Places { first, list })
    }

    fn of(&self, node: usize) -> Option<usize> {
        self.list.get(node.checked_sub(self.first)?).copied()
    }
}

/// The memory that a [`Grid`] borrows.
#[derive(Clone, Debug)]
pub struct Woven<S> {
    columns: usize,
    rows: usize,
    runs: Vec<Run>,
    starts: Vec<usize>,
    right: [Vec<S>; 3],
    up: [Vec<S>; 3],
    mass: Vec<S>,
    cells: Vec<S>,
    nodes: [usize; 2],
    springs: [usize; 2],
    facets: [usize; 2],
}

impl<S: Scalar> Woven<S> {
    /// Arranges the springs and facets of the lists by the table; indices of nodes, springs and facets are counted from
    /// those given. `None` without a table, if rows are too short, if a spring does not connect neighbours of the grid,
    /// or if the nodes of the table are not consecutive.
    pub fn new(lists: &Lists, [node, spring, facet]: [usize; 3]) -> Option<Self> {
        let Table { columns, nodes } = lists.table.as_ref().filter(|table| table.columns >= SHORTEST)?;
        let (columns, rows) = (*columns, nodes.len() / *columns);
        let place = Places::new(nodes)?;
        let (first, last) = (place.first, place.first + place.list.len() - 1);
        let in_rows = |place: usize| place / columns * pitch(columns) + place % columns;
        let mut taken = vec![[false; 2]; nodes.len()];
        let mut families = [(); 2].map(|()| [(); 3].map(|()| vec![S::ZERO; rows * pitch(columns)]));
        for (number, [tail, head]) in lists.springs.iter().enumerate() {
            let (tail, head) = (place.of(*tail)?, place.of(*head)?);
            let family = match head.checked_sub(tail)? {
                1 if head % columns > 0 => 0,
                way if way == columns => 1,
                _ => return None,
            };
            // Two springs between the same nodes do not fit into a grid.
            if std::mem::replace(&mut taken[tail][family], true) {
                return None;
            }
            let [stiffness, rest_length, damping] = &mut families[family];
            let tail = in_rows(tail);
            damping[tail] = S::from_f64(*lists.damping.get(number)?);
            stiffness[tail] = S::from_f64(*lists.stiffness.get(number)?);
            rest_length[tail] = S::from_f64(*lists.rest_lengths.get(number)?);
        }
        let (cells, facets) = cells(lists, &place, columns, rows)?;
        let mut mass = vec![S::ZERO; rows * pitch(columns)];
        for (node, place) in (first..).zip(&place.list) {
            mass[in_rows(*place)] = S::from_f64(lists.masses[node]);
        }
        let (mut runs, starts) = runs(nodes, columns);
        runs.iter_mut().for_each(|run| run.node += node);
        if lists.damping.iter().all(|c| *c == 0.0) {
            families.iter_mut().for_each(|[_, _, damping]| damping.clear());
        }
        let [right, up] = families;
        let nodes = [node + first, node + last + 1];
        let springs = [spring, spring + lists.springs.len()];
        let facets = [facet, facet + facets];
        Some(Woven { columns, rows, runs, starts, mass, right, up, cells, nodes, springs, facets })
    }

    /// Index of its first node.
    #[must_use]
    pub fn first_node(&self) -> usize {
        self.nodes[0]
    }

    /// The same grid with shifted indices: node `old` becomes `new`; its springs and facets begin with the numbers
    /// given.
    #[must_use]
    pub fn from(&self, [old, new]: [usize; 2], spring: usize, facet: usize) -> Self {
        let mut moved = self.clone();
        moved.runs.iter_mut().for_each(|run| run.node = run.node - old + new);
        moved.nodes = self.nodes.map(|node| node - old + new);
        moved.springs = [spring, spring + self.springs[1] - self.springs[0]];
        moved.facets = [facet, facet + self.facets[1] - self.facets[0]];
        moved
    }

    /// The same in another scalar, every number rounded once.
    #[must_use]
    pub fn rounded<T: Scalar>(&self) -> Woven<T> {
        let numbers = |list: &Vec<S>| list.iter().map(|x| T::from_f64(x.to_f64())).collect();
        Woven {
            columns: self.columns,
            rows: self.rows,
            runs: self.runs.clone(),
            starts: self.starts.clone(),
            right: self.right.each_ref().map(numbers),
            up: self.up.each_ref().map(numbers),
            mass: numbers(&self.mass),
            cells: numbers(&self.cells),
            nodes: self.nodes,
            springs: self.springs,
            facets: self.facets,
        }
    }

    /// The grid.
    pub fn view<'s>(&'s self) -> Grid<'s, S> {
        let family =
            |[stiffness, rest_length, damping]: &'s [Vec<S>; 3]| Family { stiffness, rest_length, damping };
        Grid {
            columns: self.columns,
            rows: self.rows,
            runs: &self.runs,
            starts: &self.starts,
            right: family(&self.right),
            up: family(&self.up),
            mass: &self.mass,
            cells: &self.cells,
            nodes: self.nodes,
            springs: self.springs,
            facets: self.facets,
        }
    }
}

/// Runs of nodes that are consecutive both in a row and in the lists, and the index at which each row's runs begin.
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

/// The cells of the table that have a facet of four corners, by their first corner, and their number: those that the
/// list of facets begins with. `None` if these are not in row order.
fn cells<S: Scalar>(lists: &Lists, place: &Places, columns: usize, rows: usize) -> Option<(Vec<S>, usize)> {
    let mut cells = vec![S::ZERO; rows * pitch(columns)];
    let (mut count, mut next) = (0, 0);
    for facet in &lists.facets {
        let corners: Option<Vec<usize>> = facet.iter().map(|node| place.of(*node)).collect();
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
