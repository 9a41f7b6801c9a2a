//! The keys of a scene: one table of which choice reads which key, by which the reader refuses keys that are not read.
//!
//! In: the choices that a scene makes (shape, law, method, gas). Out: the keys read with them, and for any other key
//! the choices that would read it.

use super::method::METHODS;

/// A group of keys and the choice that reads them.
#[derive(Clone, Copy, Debug)]
pub struct Reader {
    /// The choice.
    pub choice: Choice,
    /// The keys, separated by blanks.
    pub keys: &'static str,
}

/// Choices that a scene makes.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Choice {
    /// No choice: read in every scene.
    Always,
    /// Lists of points and springs instead of a shape.
    Lists,
    /// A shape of this name.
    Shape(&'static str),
    /// A law of contact of this name.
    Law(&'static str),
    /// A method of fixed step.
    FixedStep,
    /// A method that chooses its steps.
    AdaptiveStep,
    /// A pressure.
    Pressure,
    /// A gas of this name.
    Gas(&'static str),
}

impl std::fmt::Display for Choice {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Self::Always => f.write_str("every scene"),
            Self::Lists => f.write_str("`points` in place of a shape"),
            Self::Shape(name) => write!(f, "shape = \"{name}\""),
            Self::Law(name) => write!(f, "law = \"{name}\""),
            Self::FixedStep => f.write_str("a method of fixed step"),
            Self::AdaptiveStep => {
                let adaptive: Vec<&str> = METHODS.iter().filter(|m| m.2).map(|m| m.0).collect();
                write!(f, "method = \"{}\"", adaptive.join("\" or \""))
            }
            Self::Pressure => f.write_str("a `pressure`"),
            Self::Gas(name) => write!(f, "gas = \"{name}\""),
        }
    }
}

const fn reader(choice: Choice, keys: &'static str) -> Reader {
    Reader { choice, keys }
}

/// The table. A bar computes its own masses and stiffness; only closed surfaces hold a pressure; Moreau's law is a
/// method of its own.
pub const READERS: [Reader; 24] = [
    reader(
        Choice::Always,
        "format title view shape fixed C stretch tilt initial_velocity g air_drag law step T every",
    ),
    reader(Choice::Lists, "points springs rest_lengths facets mass K pressure"),
    reader(Choice::Shape("chain"), "links length mass K drop_height"),
    reader(Choice::Shape("polygon"), "corners side mass K drop_height"),
    reader(Choice::Shape("truss"), "bays side mass K drop_height"),
    reader(Choice::Shape("prism"), "side height mass K drop_height pressure"),
    reader(Choice::Shape("cube"), "side mass K drop_height pressure"),
    reader(Choice::Shape("cylinder"), "corners rings radius height mass K drop_height pressure"),
    reader(Choice::Shape("ball"), "corners bands radius mass K drop_height pressure"),
    reader(Choice::Shape("cubes"), "cells side mass K drop_height"),
    reader(Choice::Shape("sheet"), "rows columns width depth mass K drop_height pressure"),
    reader(Choice::Shape("bar"), "elements length E rho A drop_height"),
    reader(Choice::Law("none"), "method"),
    reader(
        Choice::Law("compensation"),
        "method floor mu cluster_tolerance eta anchor plastic_alone receivers",
    ),
    reader(Choice::Law("newton"), "method floor mu cluster_tolerance e"),
    reader(Choice::Law("moreau"), "floor mu e"),
    reader(Choice::Law("penalty"), "method floor mu stiffness"),
    reader(Choice::Law("hunt_crossley"), "method floor mu stiffness dissipation"),
    reader(Choice::Law("massless_point"), "method floor mu cluster_tolerance massless"),
    reader(Choice::FixedStep, "allow_unstable"),
    reader(Choice::AdaptiveStep, "tolerance"),
    reader(Choice::Pressure, "pressure_form gas"),
    reader(Choice::Gas("constant"), ""),
    reader(Choice::Gas("polytropic"), "ambient volume exponent dead_volume"),
];

/// Keys that mean the same as another one.
pub const ALIASES: [(&str, &str); 2] = [("seconds", "T"), ("masses", "mass")];

/// Keys of a reference file in JSON besides those of the scene: they describe the motion that was computed from it.
pub const OF_REFERENCES: &str = "case description sample_times columns states \
    energies_ke_spring_gravity_dissipated total_energy_initial max_energy_balance_error events events_dop853 agreement";

/// Names of the shapes.
pub fn shapes() -> impl Iterator<Item = &'static str> {
    READERS.iter().filter_map(|r| if let Choice::Shape(name) = r.choice { Some(name) } else { None })
}

/// Names of the laws.
pub fn laws() -> impl Iterator<Item = &'static str> {
    READERS.iter().filter_map(|r| if let Choice::Law(name) = r.choice { Some(name) } else { None })
}

/// Names of the gases.
pub fn gases() -> impl Iterator<Item = &'static str> {
    READERS.iter().filter_map(|r| if let Choice::Gas(name) = r.choice { Some(name) } else { None })
}

/// Keys read with any of these choices.
pub fn read_with(choices: &[Choice]) -> impl Iterator<Item = &'static str> + '_ {
    let chosen = READERS.iter().filter(|r| r.choice == Choice::Always || choices.contains(&r.choice));
    chosen.flat_map(|r| r.keys.split_whitespace())
}

/// The message for a key that is not read, with the choices that would read it; `None` if it is read.
#[must_use]
pub fn complaint(key: &str, choices: &[Choice]) -> Option<String> {
    if read_with(choices).any(|k| k == key) {
        return None;
    }
    let readers: Vec<Choice> =
        (READERS.iter()).filter(|r| r.keys.split_whitespace().any(|k| k == key)).map(|r| r.choice).collect();
    if readers.is_empty() {
        return Some(format!("unknown key{}", crate::suggest::help(key, read_with(choices))));
    }
    let alike = |a: &Choice| readers.iter().any(|b| same_kind(*a, *b));
    let chosen: Vec<String> = choices.iter().filter(|c| alike(c)).map(ToString::to_string).collect();
    let here = if chosen.is_empty() { String::new() } else { format!(" with {}", chosen.join(" and ")) };
    let readers: Vec<String> = readers.iter().map(ToString::to_string).collect();
    Some(format!("nothing reads it{here}; leave it out: it belongs to {}", readers.join(", ")))
}

/// Are the two alternatives of one kind: two shapes, two laws?
fn same_kind(a: Choice, b: Choice) -> bool {
    use Choice::{AdaptiveStep, FixedStep, Gas, Law, Lists, Shape};
    matches!(
        (a, b),
        (Shape(_) | Lists, Shape(_) | Lists)
            | (Law(_), Law(_))
            | (FixedStep | AdaptiveStep, FixedStep | AdaptiveStep)
            | (Gas(_), Gas(_))
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_key_is_refused_with_those_who_read_it() {
        let cube = [Choice::Shape("cube"), Choice::Law("compensation"), Choice::FixedStep];
        assert_eq!(complaint("side", &cube), None);
        let corners = complaint("corners", &cube).expect("a cube has none to choose");
        assert!(corners.starts_with("nothing reads it with shape = \"cube\"; leave it out"), "{corners}");
        assert!(
            corners.ends_with("shape = \"polygon\", shape = \"cylinder\", shape = \"ball\""),
            "{corners}"
        );
        let unknown = complaint("stifness", &cube).expect("a slip");
        assert!(unknown.starts_with("unknown key"), "{unknown}");
    }
}
