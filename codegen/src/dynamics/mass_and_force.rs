//! Inertia and generalised forces over all unknowns y, before the eliminations take them to the independent speeds.
//!
//! In: terms of M_y and of F_y - h_y, body by body and load by load. Out: their sums. [`Terms`] are not summed yet,
//! because equivalent forms of the same inertia are compared by the operations of their terms before one is taken.

use super::given::Given;
use crate::expr::number::Number;
use crate::expr::{Dag, ExprId};
use crate::kinematics::{LinearForm, UnknownId};
use std::collections::BTreeMap;

/// M_y and F_y - h_y.
#[derive(Clone, Debug, Default)]
pub(crate) struct MassAndForce {
    /// Upper triangle of M_y: keys (k, l) with k <= l.
    pub mass: BTreeMap<(UnknownId, UnknownId), ExprId>,
    /// F_y - h_y: active forces less the inertia bias.
    pub force: LinearForm,
}

impl MassAndForce {
    /// Adds a term of M_kl.
    pub fn add_mass(&mut self, dag: &mut Dag, k: UnknownId, l: UnknownId, term: ExprId) {
        let key = (k.min(l), k.max(l));
        let sum = match self.mass.get(&key) {
            Some(&mine) => dag.add(mine, term),
            None => term,
        };
        self.mass.insert(key, sum);
    }

    /// Adds a term of the force on y_k.
    pub fn add_force(&mut self, dag: &mut Dag, k: UnknownId, term: ExprId) {
        self.force.add_term(dag, k, &term);
    }

    /// Adds all terms in their order.
    pub fn add(&mut self, dag: &mut Dag, terms: Terms) {
        for (a, b, term) in terms.mass {
            self.add_mass(dag, a, b, term);
        }
        for (a, term) in terms.force {
            self.add_force(dag, a, term);
        }
    }
}

/// Terms of M_y (keys k <= l) and of the forces.
#[derive(Clone, Debug, Default)]
pub(super) struct Terms {
    pub mass: Vec<(UnknownId, UnknownId, ExprId)>,
    pub force: Vec<(UnknownId, ExprId)>,
}

impl Terms {
    /// The terms whose operations count: if accelerations are given, those of the forces alone.
    fn counted(&self, given: &Given) -> Vec<ExprId> {
        let mass = self.mass.iter().filter(|_| !given.is_given()).map(|(_, _, e)| *e);
        mass.chain(self.force.iter().map(|(_, e)| *e)).collect()
    }

    /// Operations of one evaluation; those of parameters alone are left out.
    pub(super) fn state_cost(&self, dag: &Dag, given: &Given) -> usize {
        dag.state_cost(&self.counted(given))
    }

    /// Operations, including those of parameters.
    pub(super) fn cone_cost(&self, dag: &Dag, given: &Given) -> usize {
        dag.cone_cost(&self.counted(given))
    }

    /// The entry M_aa of a hinge whose column has been formed already.
    pub(super) fn mass_of(&self, unknown: UnknownId) -> ExprId {
        let entry = self.mass.iter().find(|(a, b, _)| *a == unknown && *b == unknown);
        entry.expect("a hinge farther out has its column before").2
    }

    /// Adds v_a . (column of b) to M_ab; twice if a = b, where the unknown already has a column from a joint farther
    /// out.
    pub(super) fn add_product(&mut self, dag: &mut Dag, a: UnknownId, b: UnknownId, product: ExprId) {
        let two = dag.number(Number::integer(2));
        let entry = if a == b { dag.mul(two, product) } else { product };
        self.mass.push((a.min(b), a.max(b), entry));
    }

    /// Appends the terms of others.
    pub(super) fn extend(&mut self, others: Self) {
        self.mass.extend(others.mass);
        self.force.extend(others.force);
    }
}
