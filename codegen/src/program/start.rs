//! The start of a motion: the model's `[start]` as coordinates and speeds.
//!
//! In: what `[start]` states. Out: a configuration that satisfies the constraints, on the branch of the nominal one,
//! and the independent speeds. Coordinates that are not stated are nominal, speeds 0. A warning names what is stated
//! although it follows from the rest.

use super::derived::Program;
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
    /// The configuration cannot be assembled, `[start]` states what follows from the rest, or only some of several
    /// speeds that the constraints tie.
    pub fn start(&self) -> Result<Start, String> {
        if let Some(name) = self.stated_in_vain() {
            return Err(format!(
                "[start] states `{name}`, which follows from the independent coordinates and speeds"
            ));
        }
        let stated =
            |name: &str| self.stated_start.iter().find(|(of, _)| of == name).map(|(_, value)| *value);
        let u: Vec<f64> = self.u.iter().map(|speed| stated(&speed.name).unwrap_or(0.0)).collect();
        if self.is_redundant() && u.iter().any(|speed| *speed != 0.0) {
            return Err("all speeds are state and [start] states some of them".to_owned());
        }
        let wanted = self.q.iter().zip(&self.nominal);
        let mut wanted: Vec<f64> = wanted.map(|(q, nominal)| stated(&q.name).unwrap_or(*nominal)).collect();
        self.assembly.to_unit_length(&mut wanted, |i| stated(&self.q[i].name).is_some());
        if wanted == self.nominal {
            return Ok(Start { q: wanted, u });
        }
        match self.assembly.clone().continue_to(&self.nominal, &wanted) {
            Ok(q) => Ok(Start { q, u }),
            Err(unreachable) => Err(format!("[start] cannot be assembled: {unreachable}")),
        }
    }
}
