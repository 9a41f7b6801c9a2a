//! Methods of worlds by name, and which of them a world with contacts takes.

use crate::suggest;
use smartbed_runtime::ode::Method;

/// How a step is made.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Stepping {
    /// By a method for any ordinary differential equations.
    Ode(Method),
    /// By forces that are means over the step (energy-momentum).
    Conserving,
    /// By forces in its middle, impacts and lasting contacts alike (Moreau).
    Moreau,
}

/// What a world's contacts ask of its method.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Contacts {
    /// There are none.
    None,
    /// Their touches are located in time, steps cut there.
    Located,
    /// They act over whole steps.
    Unlocated,
}

/// The method of free motion while a world without contacts is relaxed.
pub(super) const RELAXED: Method = Method::SemiImplicitEuler;

/// A method: name, step, order where nothing touches.
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
    /// Methods for a world with such contacts.
    pub fn methods(self) -> impl Iterator<Item = Named> {
        METHODS.into_iter().filter(move |(_, stepping, _)| match (self, stepping) {
            (Contacts::None, Stepping::Moreau)
            | (Contacts::Located, Stepping::Conserving | Stepping::Moreau) => false,
            (Contacts::None | Contacts::Located, _) => true,
            (Contacts::Unlocated, stepping) => !matches!(stepping, Stepping::Ode(_)),
        })
    }

    /// The method where nobody chooses. A flexible part without any damping keeps what a step errs in energy: there the
    /// method is one that errs in none.
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
    /// There is none, with the likely name, or it is not for such contacts, with what to do.
    pub fn method(self, name: &str) -> Result<(&'static str, Stepping), String> {
        if let Some((known, stepping, _)) = self.methods().find(|(known, ..)| *known == name) {
            return Ok((known, stepping));
        }
        let why = match (self, METHODS.iter().find(|(known, ..)| *known == name)) {
            (_, None) => {
                let known = self.methods().map(|(known, ..)| known).collect::<Vec<_>>();
                return Err(format!(
                    "run.method = \"{name}\": no method of worlds{}",
                    suggest::help(name, known)
                ));
            }
            (Contacts::None, _) => {
                "it is the step of contacts whose touches are not located; this world has no contacts, leave the key out"
            }
            (Contacts::Located, _) => {
                "it acts over whole steps, and located touches cut them; take impact = \"moreau\" for all contacts, or another method"
            }
            (Contacts::Unlocated, _) => {
                "contacts with impact = \"moreau\" act over whole steps; leave the key out, or take energy_momentum"
            }
        };
        Err(format!("run.method = \"{name}\": {why}"))
    }
}
