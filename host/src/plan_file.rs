//! The plan that a command line names: its file, found and read once.
//!
//! In: a path, or a name under `models/plans`, and settings. Out: the plan, checked against its limits, or the errors.

use crate::failure::Failure;
use crate::file_kind::FileKind;
use crate::plan::{Read, checked, parse};
use crate::world::read::settings::refuse_twice;
use crate::{hash, input, model_argument};

/// The file of a plan. It is read only once, so that later changes of the file have no effect.
#[derive(Clone, Debug)]
pub struct PlanFile {
    path: String,
    /// Its contents.
    text: String,
    /// Its SHA-256.
    pub hash: String,
}

impl PlanFile {
    /// Opens the plan of a command line: a path, or a name under `models/plans`.
    ///
    /// # Errors
    /// There is none, or it cannot be read.
    pub fn open(argument: &str) -> Result<Self, Failure> {
        let path = model_argument::find_plan(argument)?;
        let name = path.display().to_string();
        let text = input::text(&name).map_err(|e| format!("{name}: {e}"))?;
        FileKind::expect_text(&path, &text, &[FileKind::Plan])?;
        let hash = hash::hash(text.as_bytes());
        Ok(Self { path: name, text, hash })
    }

    /// The path of the mesh that the plan names under these `settings`, if any.
    #[must_use]
    pub fn mesh(&self, settings: &[String]) -> Option<std::path::PathBuf> {
        crate::plan::mesh_file(&self.path, &self.text, settings)
    }

    /// A refusal of the plan in one line, without the place of its file: the same on every machine.
    #[must_use]
    pub fn refusal(&self, failure: &Failure) -> String {
        let text = failure.to_string();
        let line = text.lines().next().unwrap_or_default();
        line.strip_prefix(&format!("{}: ", self.path)).unwrap_or(line).to_owned()
    }

    /// What the plan says of a key of these `settings` that it does not have: none of the words between its dots may be
    /// one that nothing reads.
    #[must_use]
    pub fn unknown(&self, settings: &[String], key: &str) -> Option<String> {
        let found = parse(&self.path, &self.text, settings).err()?;
        let words: Vec<String> = key.split(['.', '[']).map(|word| format!("has no field `{word}`")).collect();
        let item = found.items.iter().find(|item| words.iter().any(|word| item.message.ends_with(word)))?;
        let help = item.help.as_ref().map_or_else(String::new, |help| format!("; {help}"));
        Some(format!("{}{help}", item.message))
    }

    /// Parses the plan with `settings` applied and checks it against its limits.
    ///
    /// # Errors
    /// Everything that is wrong in its text, a key that is set twice, or the first limit that it exceeds.
    pub fn read(&self, settings: &[String]) -> Result<Read, Failure> {
        refuse_twice(settings).map_err(Failure::Wrong)?;
        let read = parse(&self.path, &self.text, settings).map_err(|found| model_argument::wrong(&found))?;
        Ok(checked(&self.path, read)?)
    }
}
