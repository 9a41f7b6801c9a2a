//! `--view` and `smartbed view`: a motion in space as one self-contained HTML page.
//!
//! In: positions of points and attitudes of bodies over time, curves, events. Out: a page that shows them with three.js
//! (`three/`, committed with its licence and the script that makes it; no build needs npm). [`film`] keeps the frames;
//! `film.js` to `player.js` are the page's scripts. [`still`] takes a picture, [`serve`] follows a file.

pub mod arguments;
pub mod ellipsoid;
pub mod film;
pub mod page;
#[cfg(feature = "whole")]
pub mod scene;
pub mod serve;
#[cfg(feature = "whole")]
pub mod side;
pub mod stage;
#[cfg(feature = "whole")]
pub mod still;
#[cfg(feature = "whole")]
pub mod world;

pub use arguments::Arguments;
pub use film::Film;
pub use page::{THREE, page};
pub use stage::Stage;

use crate::failure::Failure;
#[cfg(feature = "whole")]
use crate::run;

/// Runs the command.
///
/// # Errors
/// Status 1 for a wrong model or setting; status 2 without a browser for `--still`, or without a free port.
pub fn run(arguments: &Arguments) -> Result<(), Failure> {
    match arguments.still.as_deref() {
        Some([time, file]) => take_still(arguments, time, file),
        _ => serve::serve(arguments),
    }
}

#[cfg(not(feature = "whole"))]
fn take_still(_: &Arguments, _: &str, _: &str) -> Result<(), Failure> {
    Err(Failure::not_built("--still"))
}

#[cfg(feature = "whole")]
fn take_still(arguments: &Arguments, time: &str, file: &str) -> Result<(), Failure> {
    still::check(file)?;
    let time = still::time(time)?;
    let film = run::film(&arguments.run(None))?;
    let time = still::shown(&film, time)?;
    still::take(&page(&film), time, file)?;
    let name = crate::number::json_string(file);
    crate::output::print(&if arguments.json {
        format!("{{\"still\": {name}}}\n")
    } else {
        format!("{file}\n")
    })
}
