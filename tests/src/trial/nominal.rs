//! Numbers of a description under construction: its nominal posture, and which unknowns its rows determine.

use super::description::Description;
use super::oracle::{self, State};
use super::posture::Posture;
use crate::newton_euler::jet::Jet;
use nalgebra::DMatrix;

/// Pivots of a regular mechanism of links of some decimetres.
const PIVOT: f64 = 1e-6;

/// Reads something off the nominal posture.
pub(super) fn at_nominal<T>(d: &Description, read: impl FnOnce(&Posture<'_>) -> T) -> T {
    let q: Vec<Jet> = d.nominal().into_iter().map(Jet::constant).collect();
    let (parameters, inputs) = (d.parameter_values(), vec![0.0; d.inputs.len()]);
    read(&Posture::new(d, &parameters, &inputs, 0.0, &q))
}

/// The nominal configuration at rest.
pub(super) fn state(d: &Description) -> State {
    State {
        t: 0.0,
        q: at_nominal(d, |p| p.q.iter().map(|q| q.value).collect()),
        u: vec![0.0; d.independent_speeds().len()],
        inputs: vec![0.0; d.inputs.len()],
        parameters: d.parameter_values(),
    }
}

/// The state's coordinates that rows of configuration determine, and those whose speeds rows of motion do.
pub(super) fn dependent(d: &Description) -> [Vec<usize>; 2] {
    let (mut rows, n_configuration) = oracle::jacobian(d, &state(d));
    let n = rows.nrows();
    let of_configuration = eliminate(&mut rows, 0..n_configuration);
    let of_motion = eliminate(&mut rows, n_configuration..n);
    let moving = d.state();
    [of_configuration, of_motion].map(|columns| columns.into_iter().map(|c| moving[c]).collect())
}

/// Gauss and Jordan with full pivoting among some rows: the columns of the pivots.
fn eliminate(rows: &mut DMatrix<f64>, among: std::ops::Range<usize>) -> Vec<usize> {
    let mut left: Vec<usize> = among.collect();
    let mut columns: Vec<usize> = Vec::new();
    loop {
        let open = (0..rows.ncols()).filter(|c| !columns.contains(c));
        let entries = open.flat_map(|c| left.iter().map(move |&r| (r, c)));
        let size = |&(r, c): &(usize, usize)| rows[(r, c)].abs();
        let Some((row, column)) = entries.max_by(|a, b| size(a).total_cmp(&size(b))) else { return columns };
        if rows[(row, column)].abs() < PIVOT {
            return columns;
        }
        let pivot = rows.row(row) / rows[(row, column)];
        for other in (0..rows.nrows()).filter(|&r| r != row) {
            let factor = rows[(other, column)];
            let cleared = rows.row(other) - &pivot * factor;
            rows.set_row(other, &cleared);
        }
        left.retain(|&r| r != row);
        columns.push(column);
    }
}
