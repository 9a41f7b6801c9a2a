//! Contact forces between the two parts of a pair, as rows show them.
//!
//! In: points in contact after a step, with their axes and forces. Out: five values per pair, `ONE-OTHER.normal` and so
//! on: means over the step if touches are not located in time, otherwise the forces at its end (of rigid parts alone:
//! in the middle of its last piece).

use super::engine::Column;
use smartbed_runtime::real::Scalar;
use smartbed_runtime::rigid::contact::Contact;
use smartbed_runtime::vec3::{self, Vec3};
use std::ops::Range;

/// The values of a pair in a row.
const NUMBERS: [(&str, &str); 5] =
    [("points", "points"), ("normal", "N"), ("x", "N"), ("y", "N"), ("z", "N")];

/// The force of the second part of each pair on the first.
#[derive(Clone, PartialEq, Default, Debug)]
pub(super) struct Pushed {
    /// Number of points in contact, sum of their normal forces (N), total force on the first part along x, y, z (N).
    rows: Vec<[f64; NUMBERS.len()]>,
}

impl Pushed {
    /// No forces.
    pub(super) fn new(pairs: usize) -> Self {
        Pushed { rows: vec![Default::default(); pairs] }
    }

    /// Names of the numbers, for pairs of parts with names.
    pub(super) fn columns<'n>(pairs: impl Iterator<Item = [&'n str; 2]>) -> Vec<Column> {
        let of = |[one, other]: [&str; 2]| {
            NUMBERS.map(|(number, unit)| Column {
                name: format!("{one}-{other}.{number}"),
                unit: unit.to_owned(),
                by_default: false,
            })
        };
        pairs.flat_map(of).collect()
    }

    /// Adds a point of a pair: its force n, t1, t2 (N), and the bodies that each of the two parts is to it.
    pub(super) fn add<S: Scalar>(
        &mut self,
        pair: usize,
        bodies: [&Range<usize>; 2],
        contact: &Contact<S>,
        force: Vec3<S>,
    ) {
        let Some([points, normal, sum @ ..]) = self.rows.get_mut(pair).filter(|_| force[0] > S::ZERO) else {
            return;
        };
        *points += 1.0;
        *normal += force[0].to_f64();
        // Where the first part is none, fixed in space: what the second one gets, turned round.
        let (own, sign) = if bodies[0].is_empty() { (bodies[1], -1.0) } else { (bodies[0], 1.0) };
        contact.deal(force, |body, _, share| {
            if own.contains(&body) {
                *sum = vec3::axpy(*sum, sign, share.map(S::to_f64));
            }
        });
    }

    /// Is the pair in contact?
    pub(super) fn presses(&self, pair: usize) -> bool {
        self.rows[pair][0] > 0.0
    }

    /// Copies the values of a pair from a pair of another list.
    pub(super) fn take(&mut self, pair: usize, of: &Pushed, other: usize) {
        self.rows[pair] = of.rows[other];
    }

    /// The numbers, pair by pair.
    pub(super) fn values(&self) -> &[f64] {
        self.rows.as_flattened()
    }

    /// Restores the values of [`Pushed::values`], of as many pairs.
    pub(super) fn load(&mut self, values: &[f64]) {
        self.rows.as_flattened_mut().copy_from_slice(values);
    }
}
