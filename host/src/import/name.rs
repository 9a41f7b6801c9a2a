//! Turns names of URDF, which may contain any characters, into unique names of a model.

use smartbed_codegen::model::{RESERVED, is_keyword};
use std::collections::BTreeSet;

/// Longest name, so that with `tau_`, `u_` and endings it stays below 64 letters.
const LONGEST: usize = 48;

/// The names in use.
#[derive(Debug)]
pub struct Names(BTreeSet<String>);

impl Names {
    /// With the names that every model has.
    pub fn new() -> Self {
        Self(["N", "O", "g"].into_iter().chain(RESERVED).map(str::to_owned).collect())
    }

    /// A name as near to `wanted` as possible; if it is in use, with `ending` or a number appended.
    pub fn take(&mut self, wanted: &str, ending: &str) -> String {
        let letter = |c: char| if c.is_ascii_alphanumeric() { c } else { '_' };
        let mut word: String = wanted.chars().map(letter).take(LONGEST).collect();
        if !word.starts_with(|c: char| c.is_ascii_alphabetic()) {
            word = format!("{}_{word}", ending.trim_start_matches('_'));
        }
        let free = |name: &String| !self.0.contains(name) && !is_keyword(name);
        let others =
            std::iter::once(format!("{word}{ending}")).chain((2..).map(|n| format!("{word}{ending}{n}")));
        let name = std::iter::once(word.clone()).chain(others).find(free).unwrap_or(word);
        self.0.insert(name.clone());
        name
    }
}
