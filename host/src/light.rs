//! Decides what the light program does by itself: it starts, runs and shows mechanisms.
//!
//! In: the arguments of a command. Out: whether it can do without scenes, reports, a browser and a compiler. `cargo
//! smartbed` builds the light program first, without the feature `whole`; that program builds the whole one when it is
//! first needed.

use crate::engine::EngineKind;
use crate::file_kind::FileKind;
use crate::{model_argument, run, view};

/// Can the light program run this? Yes also for a file that cannot be read, which both programs refuse alike.
#[must_use]
pub fn runs(arguments: &run::Arguments) -> bool {
    let is_picked = arguments.error.is_some() || arguments.budget.is_some();
    let is_kept = arguments.save.is_some() || arguments.resume.is_some() || arguments.accounts.is_some();
    let is_compiled = arguments.engine == EngineKind::Compiled;
    let is_painted = arguments.plot.as_ref().is_some_and(|file| file.to_ascii_lowercase().ends_with(".png"));
    !(is_picked || is_kept || is_compiled || is_painted) && is_mechanism(&arguments.model)
}

/// Can the light program show this?
#[must_use]
pub fn shows(arguments: &view::Arguments) -> bool {
    arguments.still.is_none() && is_mechanism(&arguments.model)
}

/// Is it no scene?
fn is_mechanism(argument: &str) -> bool {
    let Ok(path) = model_argument::find(argument) else { return true };
    !matches!(FileKind::of(&path), FileKind::Body | FileKind::World)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn of(model: &str) -> run::Arguments {
        run::Arguments { model: model.to_owned(), ..run::Arguments::default() }
    }

    #[test]
    fn every_shipped_mechanism_is_run_and_no_scene() {
        let names = |folder: &str| {
            let files = std::fs::read_dir(folder).expect("a folder").map(|f| f.expect("a file").path());
            files.filter(|f| f.extension().is_some_and(|e| e == "toml")).map(|f| f.display().to_string())
        };
        let (mechanisms, scenes): (Vec<_>, Vec<_>) =
            (names("../models").collect(), names("../models/scenes").collect());
        assert!(mechanisms.len() > 15 && scenes.len() > 15);
        for file in mechanisms {
            assert!(runs(&of(&file)), "{file}");
        }
        for file in scenes {
            assert!(!runs(&of(&file)), "{file}");
        }
    }

    #[test]
    fn what_needs_more_than_the_equations_is_left() {
        assert!(runs(&run::Arguments { plot: Some("a.svg".to_owned()), ..of("fourbar") }));
        for more in [
            run::Arguments { error: Some(1e-6), ..of("fourbar") },
            run::Arguments { budget: Some("1us".to_owned()), ..of("fourbar") },
            run::Arguments { save: Some("a.json".to_owned()), ..of("fourbar") },
            run::Arguments { engine: EngineKind::Compiled, ..of("fourbar") },
            run::Arguments { plot: Some("a.PNG".to_owned()), ..of("fourbar") },
        ] {
            assert!(!runs(&more), "{more:?}");
        }
        let shown = view::Arguments { model: "fourbar".to_owned(), ..view::Arguments::default() };
        assert!(shows(&shown));
        assert!(!shows(&view::Arguments { still: Some(Vec::new()), ..shown }));
    }
}
