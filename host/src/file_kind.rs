//! What a file is: a model, a scene of format 1 or 2, or a plan of the bed; refusals that name the commands that take
//! it.
//!
//! In: the path of a file. Out: its kind, by its keys alone. What is wrong in the file is found by the reader of its
//! kind.

use crate::failure::Failure;
use crate::input;
use smartbed_codegen::model::marks;
use std::path::Path;

/// Values, keys and lines beyond which a text is not parsed only to learn its kind: that would take more memory than
/// its reader does.
const MANY: usize = 100_000;
/// Keys that only a model has, at its top.
const OF_MODELS: [&str; 8] =
    ["name", "extends", "coordinates", "speeds", "frames", "joints", "bodies", "parameters"];
/// Keys that only a plan of the bed has, at its top.
const OF_PLANS: [&str; 6] = ["bed", "patient", "load", "move", "alternating", "policy"];

/// The kind of a file.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum FileKind {
    /// A model of a mechanism.
    Model,
    /// A scene of format 1: one flexible body.
    Body,
    /// A scene of format 2: a world of parts.
    World,
    /// A plan of the bed.
    Plan,
    /// No key tells, or the text cannot be parsed: whoever expects a kind may read it as that.
    Unknown,
}

impl FileKind {
    /// The kind of the file at a path; [`FileKind::Unknown`] also if it cannot be read.
    #[must_use]
    pub fn of(path: &Path) -> Self {
        let is_told = Self::of_ending(path);
        is_told
            .unwrap_or_else(|| Self::of_text(&input::text(&path.display().to_string()).unwrap_or_default()))
    }

    /// The kind that the ending of a path tells: references are the only JSON that is run.
    fn of_ending(path: &Path) -> Option<Self> {
        path.extension().is_some_and(|ending| ending == "json").then_some(FileKind::Body)
    }

    /// The kind of a text in TOML.
    #[must_use]
    pub fn of_text(text: &str) -> Self {
        let mut lines = text.lines().map(str::trim_start);
        // Also where the text has a slip that no parser takes: that of worlds has the best messages.
        if lines.clone().any(|line| ["[parts.", "[parts]", "parts."].iter().any(|w| line.starts_with(w))) {
            return FileKind::World;
        }
        let table = if marks(text) > MANY { None } else { text.parse::<toml::Table>().ok() };
        if let Some(table) = table {
            return Self::of_table(&table);
        }
        // By how its lines begin.
        let gives = |line: &str, key: &str| {
            line.strip_prefix(key).is_some_and(|rest| rest.trim_start().starts_with('='))
        };
        let is_table = |line: &str| OF_PLANS.iter().any(|key| line.trim_start_matches('[').starts_with(key));
        if lines.clone().any(|line| line.starts_with('[') && is_table(line)) {
            return FileKind::Plan;
        }
        let is_body = lines.any(|line| gives(line, "shape") || gives(line, "points"));
        if is_body { FileKind::Body } else { FileKind::Unknown }
    }

    fn of_table(table: &toml::Table) -> Self {
        let has = |keys: &[&str]| keys.iter().any(|key| table.contains_key(*key));
        if has(&["shape"]) || table.get("points").is_some_and(toml::Value::is_array) {
            FileKind::Body
        } else if has(&OF_MODELS) {
            FileKind::Model
        } else if has(&["parts", "contacts"])
            || table.get("format").and_then(toml::Value::as_integer) == Some(2)
        {
            FileKind::World
        } else if has(&OF_PLANS) {
            FileKind::Plan
        } else if has(&["title"]) {
            // A model has a `doc` instead: this is a scene of format 1 without a body.
            FileKind::Body
        } else {
            FileKind::Unknown
        }
    }

    /// The kind of a file; refuses another kind than a command takes. One that no key tells passes.
    ///
    /// # Errors
    /// [`Failure::Wrong`] says what the file is, what was expected, and which commands take it.
    pub fn expect(path: &Path, taken: &[FileKind]) -> Result<Self, Failure> {
        Self::of(path).among(taken, path)
    }

    /// As [`FileKind::expect`], for a file whose text has been read already.
    ///
    /// # Errors
    /// As [`FileKind::expect`].
    pub fn expect_text(path: &Path, text: &str, taken: &[FileKind]) -> Result<Self, Failure> {
        Self::of_ending(path).unwrap_or_else(|| Self::of_text(text)).among(taken, path)
    }

    /// As [`FileKind::expect`], for a file of this kind.
    ///
    /// # Errors
    /// As [`FileKind::expect`].
    pub fn among(self, taken: &[FileKind], path: &Path) -> Result<Self, Failure> {
        if self == FileKind::Unknown || taken.contains(&self) {
            return Ok(self);
        }
        let expected: Vec<&str> = taken.iter().map(|kind| kind.words()).collect();
        Err(Failure::Wrong(format!(
            "{}: this is {}; expected {}. {}",
            path.display(),
            self.words(),
            expected.join(" or "),
            self.commands()
        )))
    }

    fn words(self) -> &'static str {
        match self {
            FileKind::Model => "a model of a mechanism",
            FileKind::Body => "a scene of format 1, a flexible body",
            FileKind::World => "a scene of format 2, a world of parts",
            FileKind::Plan => "a plan of the bed",
            FileKind::Unknown => "a file of no known kind",
        }
    }

    /// What to do with it instead.
    fn commands(self) -> &'static str {
        match self {
            FileKind::Model => {
                "Models are taken by `run`, `view`, `check`, `equilibrium` (their static equilibrium), `eval`, `derive`, `report` and `firmware`"
            }
            FileKind::Body => {
                "Scenes of format 1 are taken by `run`, which also checks them, `view`, `report` and `firmware`"
            }
            FileKind::World => {
                "Worlds are taken by `run`, which also checks them, `settle` (their static equilibrium), `view`, `report` and `firmware`"
            }
            FileKind::Plan => "Plans are taken by `bed run`, `bed report` and `sweep`",
            FileKind::Unknown => "",
        }
    }
}

#[cfg(test)]
mod tests {
    use super::FileKind;
    use std::path::Path;

    fn all_of(folder: &str) -> Vec<(String, FileKind)> {
        let files = std::fs::read_dir(folder).expect("a folder").map(|f| f.expect("a file").path());
        let texts = files.filter(|f| f.extension().is_some_and(|e| e == "toml"));
        texts.map(|f| (f.display().to_string(), FileKind::of(&f))).collect()
    }

    #[test]
    fn shipped_files_are_what_their_folders_say() {
        let [models, scenes, plans] = ["../models", "../models/scenes", "../models/plans"].map(all_of);
        assert!(models.len() > 15 && scenes.len() > 15 && plans.len() > 5);
        assert_eq!(models.iter().find(|(_, kind)| *kind != FileKind::Model), None);
        assert_eq!(plans.iter().find(|(_, kind)| *kind != FileKind::Plan), None);
        let is_scene = |kind: FileKind| matches!(kind, FileKind::Body | FileKind::World);
        assert_eq!(scenes.iter().find(|(_, kind)| !is_scene(*kind)), None);
    }

    #[test]
    fn texts_without_a_part_or_with_a_slip_are_told_by_what_is_left() {
        for (text, kind) in [
            ("format = 2\ntitle = \"empty\"\n", FileKind::World),
            ("format = 2\nname = \"m\"\n", FileKind::Model),
            ("format = 1\n[parts.ball\nrigid = 3", FileKind::World),
            ("shape = \"cube\"\n", FileKind::Body),
            ("points = [[0, 0, 0]]\n", FileKind::Body),
            ("[points]\nA = \"N.x\"\n[bodies]\n", FileKind::Model),
            ("format = 1\n[run]\nseconds = 1\n", FileKind::Unknown),
            ("format = ", FileKind::Unknown),
        ] {
            assert_eq!(FileKind::of_text(text), kind, "{text}");
        }
    }

    #[test]
    fn refusals_say_what_it_is_and_which_command_takes_it() {
        let said = |file: &str, taken: FileKind| {
            FileKind::expect(Path::new(file), &[taken]).map(|_| ()).map_err(|failure| failure.to_string())
        };
        assert_eq!(said("../models/tile.toml", FileKind::Model), Ok(()));
        let world = said("../models/scenes/bed.toml", FileKind::Model).expect_err("a world");
        assert!(world.contains("this is a scene of format 2") && world.contains("`run`"), "{world}");
        let model = said("../models/tile.toml", FileKind::World).expect_err("a model");
        assert!(model.contains("this is a model") && model.contains("`equilibrium`"), "{model}");
    }
}
