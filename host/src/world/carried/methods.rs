//! Integration methods of worlds by name, and which of them a world with contacts can use.

use crate::suggest;
use smartbed_codegen::diagnostic::Diagnostic;
use smartbed_runtime::ode::Method;

/// The kind of a step.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Stepping {
    /// By a method for any ordinary differential equations.
    Ode(Method),
    /// With forces averaged over the step (energy-momentum method).
    Conserving,
    /// With forces at its midpoint; impacts and lasting contacts are treated alike (Moreau).
    Moreau,
}

/// The kind of contacts, which restricts the methods.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Contacts {
    /// There are none.
    None,
    /// Touches are located in time, and steps are cut there.
    Located,
    /// Contact forces act over whole steps.
    Unlocated,
}

/// The method of free motion in the relaxation of a world without contacts.
pub(super) const RELAXED: Method = Method::SemiImplicitEuler;

/// A method: its name, its kind, its order while nothing touches.
pub type Named = (&'static str, Stepping, u32);

/// Methods by name.
const METHODS: [Named; 8] = [
    ("euler", Stepping::Ode(Method::ExplicitEuler), 1),
    ("semi-implicit", Stepping::Ode(Method::SemiImplicitEuler), 1),
    ("verlet", Stepping::Ode(Method::Verlet), 2),
    ("implicit_midpoint", Stepping::Ode(Method::ImplicitMidpoint), 2),
    ("energy_momentum", Stepping::Conserving, 2),
    ("moreau", Stepping::Moreau, 2),
    ("blanes_moan4", Stepping::Ode(Method::BlanesMoan4), 4),
    ("rk4", Stepping::Ode(Method::Rk4), 4),
];

impl Contacts {
    /// The methods for a world with such contacts.
    pub fn methods(self) -> impl Iterator<Item = Named> {
        METHODS.into_iter().filter(move |(_, stepping, _)| match (self, stepping) {
            (Contacts::None, Stepping::Moreau)
            | (Contacts::Located, Stepping::Conserving | Stepping::Moreau) => false,
            (Contacts::None | Contacts::Located, _) => true,
            (Contacts::Unlocated, stepping) => !matches!(stepping, Stepping::Ode(_)),
        })
    }

    /// The method if none is chosen. A flexible part without any damping would keep the energy error of every step, so
    /// that it gets a method that conserves energy.
    #[must_use]
    pub fn default_method(self, is_undamped: bool) -> &'static str {
        match self {
            Contacts::Unlocated if is_undamped => "energy_momentum",
            Contacts::Unlocated => "moreau",
            Contacts::None | Contacts::Located => "rk4",
        }
    }

    /// The method of this name.
    ///
    /// # Errors
    /// An error without a place: an unknown name, with the most similar one, or a method that does not suit such
    /// contacts, with advice.
    pub fn method(self, name: &str) -> Result<(&'static str, Stepping), Diagnostic> {
        if let Some((known, stepping, _)) = self.methods().find(|(known, ..)| *known == name) {
            return Ok((known, stepping));
        }
        let (why, help) = match (self, METHODS.iter().find(|(known, ..)| *known == name)) {
            (_, None) => {
                let known = suggest::help(name, self.methods().map(|(known, ..)| known));
                ("there is no such method for worlds", known.trim_start_matches("; ").to_owned())
            }
            (Contacts::None, _) => (
                "it is for contacts with impact = \"moreau\", and this world has no contacts",
                "leave the key out".to_owned(),
            ),
            (Contacts::Located, _) => (
                "it needs whole steps, but steps are split at located touches",
                "take impact = \"moreau\" for all contacts, or another method".to_owned(),
            ),
            (Contacts::Unlocated, _) => (
                "contacts with impact = \"moreau\" need a method of whole steps",
                "leave the key out, or take energy_momentum".to_owned(),
            ),
        };
        Err(Diagnostic::error(format!("run.method = \"{name}\": {why}")).help(help))
    }
}
