//! Turns names of URDF, which may contain any characters, into unique names of a model.

use smartbed_codegen::model::{RESERVED, is_keyword};
use std::collections::BTreeSet;

/// Longest name, so that with `tau_`, `u_` and endings it stays below 64 letters.
const LONGEST: usize = 48;

/// The names in use.
#[derive(Debug)]
pub struct Names {
    taken: BTreeSet<String>,
    /// Names that were changed, with what they name.
    pub changed: Vec<String>,
}

impl Names {
    /// With the names that every model has.
    pub fn new() -> Self {
        let taken = ["N", "O", "g"].into_iter().chain(RESERVED).map(str::to_owned).collect();
        Self { taken, changed: Vec::new() }
    }

    /// A name for a joint, link or robot (`what`) as near to `wanted` as possible; if it is in use, with that word or a
    /// number appended.
    pub fn take(&mut self, wanted: &str, what: &str) -> String {
        self.take_with(wanted, what, &[])
    }

    /// The same, together with the names that the model makes of it: in each of `made` a `*` stands for the name.
    pub fn take_with(&mut self, wanted: &str, what: &str, made: &[String]) -> String {
        let ending = format!("_{what}");
        let letter = |c: char| if c.is_ascii_alphanumeric() { c } else { '_' };
        let mut word: String = wanted.chars().map(letter).take(LONGEST).collect();
        if !word.starts_with(|c: char| c.is_ascii_alphabetic()) {
            word = format!("{what}_{word}");
        }
        let with = |name: &str| -> Vec<String> {
            made.iter().map(|pattern| pattern.replace('*', name)).chain([name.to_owned()]).collect()
        };
        let free =
            |name: &String| !is_keyword(name) && with(name).iter().all(|name| !self.taken.contains(name));
        let others =
            std::iter::once(format!("{word}{ending}")).chain((2..).map(|n| format!("{word}{ending}{n}")));
        let name = std::iter::once(word.clone()).chain(others).find(free).unwrap_or(word);
        self.taken.extend(with(&name));
        if name != wanted {
            self.changed.push(format!("{what} `{wanted}` is named `{name}`"));
        }
        name
    }
}
