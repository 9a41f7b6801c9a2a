//! The reason why dependent coordinates could not be found, in words.

use std::fmt;

/// The dependent coordinates could not be found, or the mechanism is locked at them.
#[derive(Clone, PartialEq, Debug)]
pub struct Unreachable {
    /// Smallest residual reached.
    pub residual: f64,
    /// The constraint with that residual.
    pub constraint: Option<String>,
    /// A configuration exists there, but the way to it from the nominal one could not be followed; the residual is that
    /// of a place on the way.
    pub on_the_way: bool,
    /// A constraint that followed from the others at the default parameters no longer does: the mechanism is locked.
    /// The residual is what is left in that constraint where the others are met.
    pub locked: bool,
}

impl Default for Unreachable {
    fn default() -> Self {
        Self { residual: f64::INFINITY, constraint: None, on_the_way: false, locked: false }
    }
}

impl fmt::Display for Unreachable {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let name = self.constraint.as_deref().unwrap_or("a constraint");
        if self.locked {
            write!(f, "`{name}` no longer follows from the other constraints, and the mechanism is locked")?;
            return match self.residual {
                0.0 => Ok(()),
                left => write!(f, ": a residual of {left:.1e} is left in it where the others are met"),
            };
        }
        let on_the_way =
            if self.on_the_way { " on the way there from the nominal configuration" } else { "" };
        write!(f, "a constraint residual of {:.1e} is left{on_the_way}", self.residual)?;
        match &self.constraint {
            Some(name) => write!(f, ", the largest in `{name}`"),
            None => Ok(()),
        }
    }
}
