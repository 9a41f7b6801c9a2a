//! The augmented form: all equations before any elimination (thesis Eq. 2.5 with its multipliers).
//!
//! `[ M_y  -J' ] [ y'     ]   [ forcing ]`
//! `[ J     0  ] [ lambda ] = [ -bias   ]`
//!
//! y: all speeds and lifted twists. The multipliers depend on how the rows are written and are not joint reactions.

use super::mass_and_force::MassAndForce;
use crate::expr::{ExprId, SymbolId};
use crate::kinematics::Kinematics;
use crate::kinematics::eliminate::Solution;
use crate::vector::Algebra;
use rustc_hash::FxHashMap as HashMap;

/// Matrices of the augmented system, row-major.
#[derive(Clone, Debug, Default)]
pub struct Augmented {
    /// Names of the unknowns y.
    pub unknowns: Vec<String>,
    /// M_y, n x n.
    pub mass: Vec<ExprId>,
    /// J, m x n.
    pub jacobian: Vec<ExprId>,
    /// Active forces less the inertia bias, n.
    pub forcing: Vec<ExprId>,
    /// Acceleration-level bias of the rows, m.
    pub bias: Vec<ExprId>,
}

/// Collects the matrices; speeds inside forces and biases are expressed by the independent ones.
pub(super) fn derive(
    alg: &mut Algebra,
    k: &Kinematics,
    solution: &Solution,
    parts: &MassAndForce,
    values: &HashMap<SymbolId, ExprId>,
) -> Augmented {
    let zero = alg.dag.zero();
    let all = k.unknowns.moving();
    let mut mass = Vec::new();
    for &a in &all {
        for &b in &all {
            mass.push(parts.mass.get(&(a.min(b), a.max(b))).copied().unwrap_or(zero));
        }
    }
    let mut jacobian = Vec::new();
    let mut bias = Vec::new();
    for row in &solution.rows {
        jacobian.extend(all.iter().map(|u| row.coefficients.get(u).copied().unwrap_or(zero)));
        bias.push(row.bias);
    }
    let forcing: Vec<ExprId> = all.iter().map(|u| parts.force.get(u).copied().unwrap_or(zero)).collect();
    Augmented {
        unknowns: all.iter().map(|&u| k.unknowns[u].name.clone()).collect(),
        mass,
        jacobian,
        forcing: alg.dag.substitute(&forcing, values),
        bias: alg.dag.substitute(&bias, values),
    }
}
