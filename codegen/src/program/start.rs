//! The start of a motion: the model's `[start]` as coordinates and speeds.
//!
//! In: what `[start]` states. Out: a configuration that satisfies the constraints, on the branch of the nominal one or,
//! where dependent coordinates are stated, of these; and the speeds: independent ones, or all, where all are state, as
//! `run` completes them. Coordinates that are not stated are nominal, independent speeds 0. A warning names what is
//! stated although it follows from the rest.

use super::derived::Program;
use super::speeds;
use crate::diagnostic::Diagnostic;
use crate::model::{Model, StartRef};

/// Coordinates and speeds at the start, in the program's order (SI).
#[derive(Clone, PartialEq, Debug)]
pub struct Start {
    /// Coordinates, dependent ones included.
    pub q: Vec<f64>,
    /// Speeds that are state.
    pub u: Vec<f64>,
}

/// Names and values that `[start]` states.
pub(super) fn stated(model: &Model) -> Vec<(String, f64)> {
    let name = |owner: &StartRef| match owner {
        StartRef::Coordinate(id) => model.coordinates[*id].name.clone(),
        StartRef::Speed(id) => model.speeds[*id].name.clone(),
    };
    model.start.iter().map(|(owner, value)| (name(owner), *value)).collect()
}

impl Program {
    /// The first name in `[start]` that is no state: a dependent speed, or a coordinate in closed form.
    fn stated_in_vain(&self) -> Option<&str> {
        let is_state = |name: &str| self.q.iter().chain(&self.u).any(|quantity| quantity.name == name);
        self.stated_start.iter().map(|(name, _)| name.as_str()).find(|name| !is_state(name))
    }

    /// The warning for it.
    pub(super) fn warn_of_start(&self) -> Option<Diagnostic> {
        let name = self.stated_in_vain()?;
        let message = format!(
            "the start value of `{name}` cannot be used: it follows from the independent coordinates and speeds"
        );
        Some(Diagnostic::warning(message).help("leave it out, and state independent ones in [start]"))
    }

    /// The model's start.
    ///
    /// # Errors
    /// The configuration cannot be assembled, or `[start]` states what follows from the rest.
    pub fn start(&self) -> Result<Start, String> {
        if let Some(name) = self.stated_in_vain() {
            return Err(format!(
                "[start] states `{name}`, which follows from the independent coordinates and speeds"
            ));
        }
        let stated =
            |name: &str| self.stated_start.iter().find(|(of, _)| of == name).map(|(_, value)| *value);
        let given: Vec<Option<f64>> = self.q.iter().map(|q| stated(&q.name)).collect();
        let is_nominal = given.iter().zip(&self.nominal).all(|(given, own)| given.is_none_or(|x| x == *own));
        let q = match is_nominal {
            true => self.nominal.clone(),
            false => (self.assembly.clone().complete(&self.nominal, &given))
                .map_err(|unreachable| format!("[start] cannot be assembled: {unreachable}"))?,
        };
        let given: Vec<Option<f64>> = self.u.iter().map(|speed| stated(&speed.name)).collect();
        let parameters: Vec<f64> = self.parameters.iter().map(|parameter| parameter.value).collect();
        let u = speeds::complete(self, (0.0, &q, &parameters), &given)
            .map_err(|fault| format!("[start] has no speeds: {fault}"))?;
        Ok(Start { q, u })
    }
}
