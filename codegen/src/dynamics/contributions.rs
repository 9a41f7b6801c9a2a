//! What bodies contribute to M_y and to the forces, term by term: forms of the same inertia are compared before one is taken.

use super::given::Given;
use super::unprojected::Unprojected;
use crate::expr::{Dag, ExprId};
use crate::kinematics::UnknownId;

/// Contributions to M_y (keys k <= l) and to the forces.
#[derive(Clone, Debug, Default)]
pub(super) struct Contributions {
    pub mass: Vec<(UnknownId, UnknownId, ExprId)>,
    pub force: Vec<(UnknownId, ExprId)>,
}

impl Contributions {
    /// Operations at every evaluation: of the forces alone where accelerations are given.
    pub(super) fn cost(&self, dag: &Dag, given: &Given) -> usize {
        let mass = self.mass.iter().filter(|_| !given.is_given()).map(|(_, _, e)| *e);
        let roots: Vec<ExprId> = mass.chain(self.force.iter().map(|(_, e)| *e)).collect();
        dag.state_cost(&roots)
    }

    /// The entry M_aa of a hinge that has been met.
    pub(super) fn mass_of(&self, unknown: UnknownId) -> ExprId {
        let entry = self.mass.iter().find(|(a, b, _)| *a == unknown && *b == unknown);
        entry.expect("a hinge farther out is met before").2
    }

    /// An unknown that meets its own column of a joint farther out counts twice.
    pub(super) fn add_mass(&mut self, dag: &mut Dag, a: UnknownId, b: UnknownId, product: ExprId) {
        let two = dag.number(crate::expr::number::Number::integer(2));
        let entry = if a == b { dag.mul(two, product) } else { product };
        self.mass.push((a.min(b), a.max(b), entry));
    }

    /// Adds all of it to what other bodies contribute.
    pub(super) fn join(self, dag: &mut Dag, parts: &mut Unprojected) {
        for (a, b, term) in self.mass {
            parts.add_mass(dag, a, b, term);
        }
        for (a, term) in self.force {
            parts.add_force(dag, a, term);
        }
    }
}
