//! `--view` and `smartbed view`: a motion in space as one HTML page without any outside resource.
//!
//! In: places of points and turns of bodies over time, curves, events. Out: a page that shows them with three.js
//! (`three/`, committed with its licence and the script that makes it; no build needs npm): [`film`] keeps the
//! frames, `film.js` to `player.js` are the page's scripts. [`still`] takes a picture, [`serve`] follows a file.

pub mod ellipsoid;
pub mod film;
#[cfg(feature = "whole")]
pub mod scene;
pub mod serve;
pub mod stage;
#[cfg(feature = "whole")]
pub mod still;
#[cfg(feature = "whole")]
pub mod world;

pub use film::Film;
pub use stage::Stage;

use crate::failure::Failure;
use crate::run;

/// The page without data and scripts.
const PAGE: &str = include_str!("page.html");
/// The library.
pub const THREE: &str = include_str!("three/three.min.js");
/// Our own scripts, in order.
const SCRIPTS: [&str; 5] = [
    include_str!("film.js"),
    include_str!("solids.js"),
    include_str!("skin.js"),
    include_str!("stage.js"),
    include_str!("player.js"),
];

/// The page's text for data as [`Film::data`] gives them.
#[must_use]
pub fn page(data: &str) -> String {
    // `<` would let a name end the script that the data stand in.
    let data = data.replace('<', "\\u003c");
    let page = PAGE.replacen("/*THREE*/", THREE, 1).replacen("/*SCRIPT*/", &SCRIPTS.concat(), 1);
    page.replacen("<!--DATA-->", &data, 1)
}

/// Show a mechanism or a scene in motion, in a page that follows its file.
#[derive(clap::Args, Clone, Default, Debug)]
#[command(after_help = "Examples:
  cargo smartbed view fourbar
  cargo smartbed view press.toml --set k=400
  cargo smartbed view truss --still t=0.5 truss.png

Without --still the page is served at the address printed, until Ctrl-C: an edit of the file is motion on
screen in a second. `cargo smartbed run MODEL --view FILE.html` writes the page as a file.")]
pub struct Arguments {
    /// The model or scene: a path, or a name under models/.
    pub model: String,
    /// Write the picture at time T (s) and end.
    #[arg(long, num_args = 2, value_names = ["t=T", "FILE.png"])]
    pub still: Option<Vec<String>>,
    /// Port of the page; 0 for any that is free.
    #[arg(long, value_name = "N", default_value_t = 0)]
    pub port: u16,
    /// Simulated time (s).
    #[arg(long, value_name = "T")]
    pub seconds: Option<f64>,
    /// Changes a parameter or a start value; may be repeated.
    #[arg(long, value_name = "NAME=VALUE")]
    pub set: Vec<String>,
    /// Print the address, or the picture's name, as one JSON object.
    #[arg(long)]
    pub json: bool,
}

impl Arguments {
    /// The run whose motion is shown.
    fn run(&self, view: Option<String>) -> run::Arguments {
        let (seconds, set) = (self.seconds, self.set.clone());
        run::Arguments { model: self.model.clone(), seconds, set, view, ..run::Arguments::default() }
    }
}

/// Does what the command line asks for.
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
    let page = page(&run::film(&arguments.run(None))?);
    still::take(&page, time, file)?;
    let name = crate::number::json_string(file);
    crate::output::print(&if arguments.json {
        format!("{{\"still\": {name}}}\n")
    } else {
        format!("{file}\n")
    })
}
