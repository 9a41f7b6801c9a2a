//! The reason why dependent coordinates could not be found, in words.

use std::fmt;

/// The dependent coordinates could not be found, or the mechanism is locked at them.
#[derive(Clone, PartialEq, Debug)]
pub struct Unreachable {
    /// Smallest residual reached.
    pub residual: f64,
    /// The constraint with that residual.
    pub constraint: Option<String>,
    /// A constraint that followed from the others at the default parameters no longer does: the mechanism is locked.
    pub locked: bool,
}

impl Default for Unreachable {
    fn default() -> Self {
        Self { residual: f64::INFINITY, constraint: None, locked: false }
    }
}

impl fmt::Display for Unreachable {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let name = self.constraint.as_deref().unwrap_or("a constraint");
        match (self.locked, &self.constraint) {
            (true, _) => {
                write!(
                    f,
                    "`{name}` no longer follows from the other constraints, and the mechanism is locked"
                )
            }
            (false, Some(name)) => {
                write!(f, "a constraint residual of {:.1e} is left, the largest in `{name}`", self.residual)
            }
            (false, None) => write!(f, "a constraint residual of {:.1e} is left", self.residual),
        }
    }
}
