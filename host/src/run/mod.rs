//! `smartbed run`: simulates a mechanism or a scene; rows as CSV, plots, an animation, a summary.

#[cfg(feature = "whole")]
mod accounts;
pub mod arguments;
#[cfg(feature = "whole")]
mod body;
#[cfg(feature = "whole")]
mod choose;
pub mod events;
pub mod health;
mod kink;
pub mod ledger;
mod mechanism;
mod outcome;
mod plant;
#[cfg(feature = "whole")]
mod records;
#[cfg(feature = "whole")]
pub(crate) mod rows;
pub mod settings;
pub mod simulate;
pub(crate) mod start;
#[cfg(feature = "whole")]
mod world;

pub use arguments::Arguments;

use crate::failure::Failure;
#[cfg(feature = "whole")]
use crate::file_kind::FileKind;
use crate::view::page::page;
#[cfg(feature = "whole")]
use crate::{model_argument, world::Assembly};
use crate::{output, plot};
use outcome::Outcome;

/// Runs the command.
///
/// # Errors
/// Status 1 for a wrong model or setting and for a motion that cannot go on; status 2 without a
/// compiler for `--engine compiled`.
pub fn run(arguments: &Arguments) -> Result<(), Failure> {
    let results = [
        ("--csv", arguments.csv.as_deref()),
        ("--accounts", arguments.accounts.as_deref()),
        ("--plot", arguments.plot.as_deref()),
        ("--view", arguments.view.as_deref()),
        ("--save", arguments.save.as_deref()),
    ];
    output::replace_none(&results, &[&arguments.model])?;
    let Outcome { text, film, findings } = carry_out(arguments)?;
    if let (Some(file), Some(film)) = (&arguments.view, film) {
        output::write(file, page(&film).as_bytes())?;
    }
    tell(arguments, &text, &findings)
}

/// The world that the arguments name, changed by their settings.
///
/// # Errors
/// [`Failure::Found`] with all errors in it; [`Failure::Wrong`] if the file is no world.
#[cfg(feature = "whole")]
pub fn world(arguments: &Arguments) -> Result<Assembly, Failure> {
    let path = model_argument::find(&arguments.model)?;
    FileKind::expect(&path, &[FileKind::World])?;
    world::open(arguments, &path)
}

/// Runs, and returns the data of the motion's page; does not write `--view`.
///
/// # Errors
/// As [`run`].
pub fn film(arguments: &Arguments) -> Result<String, Failure> {
    let arguments = Arguments { view: Some(String::new()), ..arguments.clone() };
    Ok(carry_out(&arguments)?.film.unwrap_or_default())
}

/// Runs and writes everything asked for except the page; returns the summary, and the page's data if `--view` is given.
fn carry_out(arguments: &Arguments) -> Result<Outcome, Failure> {
    if let Some(file) = &arguments.plot {
        plot::format_of(file)?;
    }
    #[cfg(feature = "whole")]
    return any(arguments);
    #[cfg(not(feature = "whole"))]
    mechanism::run(arguments, &[])
}

/// Runs a world, a scene or a mechanism.
#[cfg(feature = "whole")]
fn any(arguments: &Arguments) -> Result<Outcome, Failure> {
    let path = model_argument::find(&arguments.model)?;
    let kind = FileKind::expect(&path, &[FileKind::Model, FileKind::Body, FileKind::World])?;
    let is_world = kind == FileKind::World;
    if !is_world && (arguments.save.is_some() || arguments.resume.is_some()) {
        return Err(Failure::Wrong("--save and --resume: expected a scene of format 2".to_owned()));
    }
    if !is_world && arguments.accounts.is_some() {
        return Err(Failure::Wrong(
            "--accounts: expected a scene of format 2; a mechanism and a scene of format 1 are one part, whose accounts are columns \
             of --csv"
                .to_owned(),
        ));
    }
    let (arguments, unexamined) = &choose::resolve(arguments, (&path, kind))?;
    let unexamined = unexamined.as_slice();
    match kind {
        FileKind::World => world::simulate(arguments, &path, unexamined),
        FileKind::Body => body::simulate(arguments, &path, unexamined),
        _ => mechanism::run(arguments, unexamined),
    }
}

/// Prints the summary, unless rows go there; then the findings, which `--strict` turns into a failure.
fn tell(arguments: &Arguments, text: &str, findings: &[String]) -> Result<(), Failure> {
    if [&arguments.csv, &arguments.accounts].iter().any(|file| file.as_deref() == Some("-")) {
        output::say(text.trim_end());
    } else {
        output::print(text)?;
    }
    match findings {
        [] => Ok(()),
        _ if arguments.strict => {
            Err(Failure::Wrong(format!("--strict: {}", findings.join("\nerror: --strict: "))))
        }
        _ => {
            findings.iter().for_each(|finding| output::say(&format!("warning: {finding}")));
            Ok(())
        }
    }
}
