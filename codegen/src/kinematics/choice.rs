//! Parameters that a derivation keeps tunable or whose defaults it changes.
//!
//! In: names and values from a command line or a build script. Out: nothing, or an error for each name that the model
//! does not have and each value that it does not allow, so that no caller has to compare.

use crate::diagnostic::{Diagnostic, Diagnostics};
use crate::model::Model;
use std::borrow::Cow;
use std::collections::BTreeMap;

/// How the derivation treats parameters.
#[derive(Clone, Debug, Default)]
pub struct ParameterChoice {
    /// Names of fixed parameters that shall stay fields of the generated code.
    pub keep: Vec<String>,
    /// Other default values, by name; what the model states as an expression of these parameters follows.
    pub values: BTreeMap<String, f64>,
}

impl ParameterChoice {
    /// Checks that the model has these parameters and allows their values.
    ///
    /// # Errors
    /// Every parameter that the model does not have, and every value outside its range.
    pub fn check(&self, model: &Model) -> Result<(), Diagnostics> {
        let mut found = Diagnostics::new(model.source.clone());
        let is_unknown = |name: &&String| model.parameters.iter().all(|p| p.name != **name);
        for name in self.keep.iter().chain(self.values.keys()).filter(is_unknown) {
            let known: Vec<&str> = model.parameters.iter().map(|p| p.name.as_str()).collect();
            let error = Diagnostic::error(format!("`{}` has no parameter `{name}`", model.name));
            found.push(error.help(format!("expected one of {}", known.join(", "))));
        }
        for parameter in model.parameters.iter() {
            let value = self.values.get(&parameter.name);
            if let Some(message) = value.and_then(|value| parameter.refuses(*value)) {
                let error = Diagnostic::error(message).label(parameter.span, "declared here");
                found.push(error.help("set another value, or give another `range`"));
            }
        }
        if found.has_errors() { Err(found) } else { Ok(()) }
    }

    /// The model with these values, and with what follows from them.
    ///
    /// # Errors
    /// As [`ParameterChoice::check`]; also what has no finite value then, and parameters that leave their ranges.
    pub fn applied<'m>(&self, model: &'m Model) -> Result<Cow<'m, Model>, Diagnostics> {
        self.check(model)?;
        if self.values.is_empty() {
            return Ok(Cow::Borrowed(model));
        }
        model.with_values(&self.values).map(Cow::Owned)
    }
}
