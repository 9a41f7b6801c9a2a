//! Integration methods of scenes by their names.

use crate::suggest;
use smartbed_runtime::advance::Method;

/// Methods of scenes: name, order of the error, whether it chooses its own steps.
pub const METHODS: [(&str, u32, bool); 9] = [
    ("symplectic_euler", 1, false),
    ("verlet", 2, false),
    ("nystrom4", 4, false),
    ("blanes_moan4", 4, false),
    ("rk4", 4, false),
    ("implicit_midpoint", 2, false),
    ("energy_momentum", 2, false),
    ("dormand_prince", 5, true),
    ("dop853", 8, true),
];

/// The method named in a scene or on the command line, `-` for `_` as mechanisms spell theirs.
///
/// # Errors
/// An unknown name, with what was probably meant.
pub fn method_named(name: &str, tolerance: f64) -> Result<Method<f64>, String> {
    match name.replace('-', "_").as_str() {
        "symplectic_euler" => Ok(Method::SymplecticEuler),
        "verlet" => Ok(Method::Verlet),
        "nystrom4" => Ok(Method::Nystrom4),
        "blanes_moan4" => Ok(Method::BlanesMoan4),
        "rk4" => Ok(Method::Rk4),
        "implicit_midpoint" => Ok(Method::ImplicitMidpoint),
        "energy_momentum" => Ok(Method::EnergyMomentum),
        "dormand_prince" => Ok(Method::DormandPrince { tolerance }),
        "dop853" => Ok(Method::Dop853 { tolerance }),
        _ => Err(format!("unknown method `{name}`{}", suggest::help(name, METHODS.map(|(known, ..)| known)))),
    }
}

/// The name of a method.
#[must_use]
pub fn name_of(method: &Method<f64>) -> &'static str {
    let same = |name| {
        let named = method_named(name, 0.0).map(|named| std::mem::discriminant(&named));
        named == Ok(std::mem::discriminant(method))
    };
    METHODS.into_iter().map(|(name, ..)| name).find(|name| same(name)).unwrap_or("another method")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_method_is_known_in_both_spellings() {
        for (name, ..) in METHODS {
            assert_eq!(method_named(name, 1e-9).map(|method| name_of(&method)), Ok(name));
            assert!(method_named(&name.replace('_', "-"), 1e-9).is_ok(), "{name}");
        }
        let message = method_named("verlett", 1e-9).unwrap_err();
        assert_eq!(message, "unknown method `verlett`; did you mean `verlet`?");
    }
}
