//! Inertia and forces over all unknowns, before the eliminations take them to the independent speeds.

use crate::expr::{Dag, ExprId};
use crate::kinematics::UnknownId;
use std::collections::BTreeMap;

/// Inertia and forces over all unknowns.
#[derive(Clone, Debug, Default)]
pub(crate) struct Unprojected {
    /// Upper triangle of M_y: keys (k, l) with k <= l.
    pub mass: BTreeMap<(UnknownId, UnknownId), ExprId>,
    /// F_y - h_y: active forces less the inertia bias.
    pub force: BTreeMap<UnknownId, ExprId>,
}

impl Unprojected {
    pub fn add_mass(&mut self, dag: &mut Dag, k: UnknownId, l: UnknownId, term: ExprId) {
        let key = (k.min(l), k.max(l));
        let sum = match self.mass.get(&key) {
            Some(&mine) => dag.add(mine, term),
            None => term,
        };
        self.mass.insert(key, sum);
    }

    pub fn add_force(&mut self, dag: &mut Dag, k: UnknownId, term: ExprId) {
        let sum = match self.force.get(&k) {
            Some(&mine) => dag.add(mine, term),
            None => term,
        };
        self.force.insert(k, sum);
    }
}
