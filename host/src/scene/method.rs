//! Integration methods of scenes: names, the table of laws and methods with the order that each keeps, and the default.
//!
//! In: a name or none, and the properties of the scene on which the choice depends (law, forces that depend on speeds,
//! friction, step). Out: a method and why it was chosen, or why it is refused. [`TABLE`] is the single source: the
//! reader of scenes uses it, the report prints it, a test measures every entry.

use super::simulation::Surroundings;
use crate::suggest;
use smartbed_runtime::contact::{ContactLaw, ForceLaw};
use smartbed_runtime::ode::nodes::Method;
use smartbed_runtime::ode::nodes::method::{Dop853, DormandPrince};

/// Methods of scenes: name, order of the error of smooth motion, whether it chooses its own steps.
pub const METHODS: [(&str, u32, bool); 11] = [
    ("symplectic_euler", 1, false),
    ("verlet", 2, false),
    ("damped_verlet", 2, false),
    ("nystrom4", 4, false),
    ("blanes_moan4", 4, false),
    ("rk4", 4, false),
    ("implicit_midpoint", 2, false),
    ("energy_momentum", 2, false),
    ("dormand_prince", 5, true),
    ("dop853", 8, true),
    ("moreau", 1, false),
];

/// The order that a method keeps with a law, or why it is refused.
pub type Entry = Result<u32, &'static str>;

/// A law with all methods, in the order of [`METHODS`].
#[derive(Clone, Copy, Debug)]
pub struct Row {
    /// The law's name in a scene.
    pub law: &'static str,
    /// Does a force depend on speeds: dampers, air, a ground that dissipates?
    pub damped: bool,
    /// One entry per method.
    pub entries: [Entry; METHODS.len()],
}

/// Splitting off the dampers does not help: above order 2 every splitting has substeps of negative length (Goldman and
/// Kaper 1996), in which a damper adds energy.
const SPEEDS: Entry = Err(
    "is for forces that depend on positions only: with dampers, air or a dissipative ground it has order 1; \
         take rk4 or verlet",
);
const STATICS: Entry = Err(
    "loses energy with law = \"massless_point\": it gives springs their mean force, but the work on a point placed \
     by statics is then missing; take verlet or blanes_moan4",
);
const GROUND: Entry =
    Err("solves for forces that are linear in the speeds, which those of law = \"hunt_crossley\" \
                           are not; take verlet or rk4");
const OWN: Entry = Err("is for law = \"moreau\" only");
const NONE: Entry =
    Err("cannot be used with law = \"moreau\", which has its own time step; leave `method` out");

/// Touches are located and split the step, so that every method keeps its order. Of Newton's infinite sequence of
/// bounces those shorter than a hundredth of a step are left out, an error of order 2. The force of a compliant ground,
/// and that on a massless point, has a kink within a step, which limits the order to 2. Adaptive methods refine their
/// steps at such a kink: their orders are those of error over work.
#[rustfmt::skip]
pub const TABLE: [Row; 13] = [
    row("none", false,           [Ok(1), Ok(2), Ok(2),  Ok(4),  Ok(4),  Ok(4), Ok(2), Ok(2),   Ok(5), Ok(8), OWN]),
    row("none", true,            [Ok(1), Ok(2), Ok(2),  SPEEDS, SPEEDS, Ok(4), Ok(2), Ok(2),   Ok(5), Ok(8), OWN]),
    row("compensation", false,   [Ok(1), Ok(2), Ok(2),  Ok(4),  Ok(4),  Ok(4), Ok(2), Ok(2),   Ok(5), Ok(8), OWN]),
    row("compensation", true,    [Ok(1), Ok(2), Ok(2),  SPEEDS, SPEEDS, Ok(4), Ok(2), Ok(2),   Ok(5), Ok(8), OWN]),
    row("newton", false,         [Ok(1), Ok(2), Ok(2),  Ok(2),  Ok(2),  Ok(2), Ok(2), Ok(2),   Ok(2), Ok(2), OWN]),
    row("newton", true,          [Ok(1), Ok(2), Ok(2),  SPEEDS, SPEEDS, Ok(2), Ok(2), Ok(2),   Ok(2), Ok(2), OWN]),
    row("massless_point", false, [Ok(1), Ok(2), Ok(2),  Ok(2),  Ok(2),  Ok(2), Ok(2), STATICS, Ok(2), Ok(2), OWN]),
    row("massless_point", true,  [Ok(1), Ok(2), Ok(2),  SPEEDS, SPEEDS, Ok(2), Ok(2), STATICS, Ok(2), Ok(2), OWN]),
    row("penalty", false,        [Ok(1), Ok(2), Ok(2),  Ok(2),  Ok(2),  Ok(2), Ok(2), Ok(2),   Ok(2), Ok(2), OWN]),
    row("penalty", true,         [Ok(1), Ok(2), Ok(2),  SPEEDS, SPEEDS, Ok(2), Ok(2), Ok(2),   Ok(2), Ok(2), OWN]),
    row("hunt_crossley", false,  [Ok(1), Ok(2), Ok(2),  Ok(2),  Ok(2),  Ok(2), Ok(2), Ok(2),   Ok(2), Ok(2), OWN]),
    row("hunt_crossley", true,   [Ok(1), Ok(2), GROUND, SPEEDS, SPEEDS, Ok(2), Ok(2), Ok(2),   Ok(2), Ok(2), OWN]),
    row("moreau", true,          [NONE,  NONE,  NONE,   NONE,   NONE,   NONE,  NONE,  NONE,    NONE,  NONE,  Ok(1)]),
];

const fn row(law: &'static str, damped: bool, entries: [Entry; METHODS.len()]) -> Row {
    Row { law, damped, entries }
}

/// Friction is applied to the speeds after each stretch, which ends where a point sticks, reverses or slips: this
/// limits the order to 2.
const FRICTION_ORDER: u32 = 2;
/// From this value of w_max h on, the default for energy compensation is the energy-momentum method: with all others an
/// undamped body may gain energy from impact to impact (bar of 50 masses, 20 bounces: `tests/it/bar_on_wall.rs`).
pub const COARSE: f64 = 0.4;

/// The properties of a scene on which the choice of its method depends.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Situation {
    /// The law's name.
    pub law: &'static str,
    /// Does a force depend on speeds?
    pub damped: bool,
    /// Is mu > 0?
    pub friction: bool,
    /// w_max h for the scene's step: 2 at the largest stable one.
    pub coarseness: f64,
}

impl Situation {
    /// From a scene's surroundings, the dampers of its springs, and its step relative to the largest stable one.
    #[must_use]
    pub fn new(around: &Surroundings, damping: &[f64], step_over_stable: f64) -> Situation {
        let law = around.ground.as_ref().map(|ground| ground.law);
        let (law, dissipates) = match law {
            None => ("none", false),
            Some(ContactLaw::Compensation { .. }) => ("compensation", false),
            Some(ContactLaw::Newton { .. }) => ("newton", false),
            Some(ContactLaw::Moreau { .. }) => ("moreau", false),
            Some(ContactLaw::MasslessPoint) => ("massless_point", false),
            Some(ContactLaw::Force(ForceLaw::Penalty { .. })) => ("penalty", false),
            Some(ContactLaw::Force(law @ ForceLaw::HuntCrossley { .. })) => {
                ("hunt_crossley", law.dissipation() > 0.0)
            }
        };
        Situation {
            law,
            damped: dissipates || around.air_drag > 0.0 || damping.iter().any(|c| *c > 0.0),
            friction: around.ground.as_ref().is_some_and(|ground| ground.friction > 0.0),
            coarseness: 2.0 * step_over_stable,
        }
    }

    /// The order of a method here, or why it is refused.
    ///
    /// # Errors
    /// The reason.
    pub fn order(&self, name: &str) -> Entry {
        let row = TABLE.iter().find(|r| r.law == self.law && (r.damped == self.damped || r.law == "moreau"));
        let column = METHODS.iter().position(|(known, ..)| *known == name);
        let entry = row.zip(column).and_then(|(row, column)| row.entries.get(column).copied());
        let order = entry.unwrap_or(OWN)?;
        Ok(if self.friction { order.min(FRICTION_ORDER) } else { order })
    }

    /// Methods that are not refused here: name, order, whether it chooses its own steps.
    #[must_use]
    pub fn methods(&self) -> Vec<(&'static str, u32, bool)> {
        METHODS.iter().filter_map(|(name, _, own)| Some((*name, self.order(name).ok()?, *own))).collect()
    }

    /// The default method of the scene, and why.
    #[must_use]
    pub fn default_method(&self) -> (&'static str, String) {
        let choice = match self.law {
            "moreau" => ("moreau", "the law steps by itself"),
            "none" | "compensation" | "newton" if self.damped => {
                ("rk4", "order 4 while nothing touches, with forces of speeds")
            }
            "compensation" if self.coarseness >= COARSE => {
                ("energy_momentum", "keeps the energy at steps this coarse")
            }
            "none" | "compensation" | "newton" => {
                ("blanes_moan4", "order 4 while nothing touches, and energy does not drift")
            }
            _ if self.damped => {
                ("verlet", "the law leaves order 2, with one evaluation a step and dampers implicit")
            }
            _ => ("verlet", "the law leaves order 2, with one evaluation a step"),
        };
        let coarse = format!(
            " (w_max h = {:.2}), but not the phases of fast vibrations; below {COARSE} the default is blanes_moan4",
            self.coarseness
        );
        let is_coarse = choice.0 == "energy_momentum";
        (choice.0, format!("{}{}", choice.1, if is_coarse { &coarse } else { "" }))
    }
}

/// A scene's method and why it is this one.
#[derive(Clone, Debug, PartialEq)]
pub struct Chosen {
    /// Its name.
    pub name: &'static str,
    /// The method.
    pub method: Method<f64>,
    /// Its order in the scene.
    pub order: u32,
    /// Why it was chosen; empty if the scene names it.
    pub why: String,
}

/// The method named in a scene or on the command line (with `-` for `_`, as for mechanisms), or the default one.
///
/// # Errors
/// An unknown name, with a suggestion; a method that the law or the forces do not allow, with the reason.
pub fn choose(name: Option<&str>, tolerance: f64, situation: &Situation) -> Result<Chosen, String> {
    let (name, why) = match name {
        Some(given) => (known(given)?, String::new()),
        None => situation.default_method(),
    };
    let order = situation.order(name).map_err(|reason| format!("{name} {reason}"))?;
    Ok(Chosen { name, method: method_of(name, tolerance), order, why })
}

/// Does the method of this name choose its own steps?
///
/// # Errors
/// An unknown name, with a suggestion.
pub fn is_adaptive(name: &str) -> Result<bool, String> {
    let name = known(name)?;
    Ok(METHODS.iter().any(|(method, _, adaptive)| *method == name && *adaptive))
}

/// Does the method of this name treat dampers implicitly, so that they do not limit the step?
#[must_use]
pub fn solves_dampers(name: &str) -> bool {
    name == "damped_verlet"
}

/// The name as it is in the table.
fn known(name: &str) -> Result<&'static str, String> {
    let spelled = name.replace('-', "_");
    let found = METHODS.iter().find(|(known, ..)| **known == *spelled).map(|(known, ..)| *known);
    found.ok_or_else(|| {
        format!("unknown method `{name}`{}", suggest::help(name, METHODS.map(|(known, ..)| known)))
    })
}

fn method_of(name: &str, tolerance: f64) -> Method<f64> {
    let longest = f64::INFINITY;
    match name {
        "verlet" => Method::Verlet,
        "damped_verlet" => Method::DampedVerlet,
        "nystrom4" => Method::Nystrom4,
        "blanes_moan4" => Method::BlanesMoan4,
        "rk4" => Method::Rk4,
        "implicit_midpoint" => Method::ImplicitMidpoint,
        "energy_momentum" => Method::EnergyMomentum,
        "dormand_prince" => Method::DormandPrince(DormandPrince { tolerance, longest }),
        "dop853" => Method::Dop853(Dop853 { tolerance, longest }),
        // Moreau's law is a method of its own: this one only sets the memory that it needs, and is never called.
        _ => Method::SymplecticEuler,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const FREE: Situation = Situation { law: "none", damped: false, friction: false, coarseness: 0.1 };

    #[test]
    fn every_method_is_known_in_both_spellings() {
        for (name, ..) in METHODS {
            assert_eq!(known(name), Ok(name));
            assert_eq!(known(&name.replace('_', "-")), Ok(name));
        }
        let message = choose(Some("verlett"), 1e-9, &FREE).unwrap_err();
        assert_eq!(message, "unknown method `verlett`; did you mean `verlet`?");
    }

    #[test]
    fn defaults_are_never_refused() {
        for row in TABLE {
            for (friction, coarseness) in [(false, 0.1), (false, 1.5), (true, 0.1)] {
                let situation = Situation { law: row.law, damped: row.damped, friction, coarseness };
                let choice = choose(None, 1e-9, &situation);
                assert!(choice.is_ok(), "{situation:?}: {choice:?}");
            }
        }
    }
}
