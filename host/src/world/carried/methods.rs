//! Methods of worlds by name.

use crate::suggest;
use smartbed_runtime::ode::Method;

/// Methods by name, with their order.
pub const METHODS: [(&str, Method, u32); 6] = [
    ("euler", Method::ExplicitEuler, 1),
    ("semi-implicit", Method::SemiImplicitEuler, 1),
    ("verlet", Method::Verlet, 2),
    ("implicit_midpoint", Method::ImplicitMidpoint, 2),
    ("blanes_moan4", Method::BlanesMoan4, 4),
    ("rk4", Method::Rk4, 4),
];

/// The method of this name.
///
/// # Errors
/// There is none, with the likely name.
pub(super) fn method(name: &str) -> Result<(&'static str, Method), String> {
    let found = METHODS.iter().find(|(known, ..)| *known == name);
    found.map(|(known, method, _)| (*known, *method)).ok_or_else(|| {
        let known = METHODS.map(|(known, ..)| known);
        format!("run.method = \"{name}\": no method of worlds{}", suggest::help(name, known))
    })
}
