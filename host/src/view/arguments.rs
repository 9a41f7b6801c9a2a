//! Arguments of `smartbed view`.

use crate::run::arguments::Arguments as RunArguments;

/// Show a mechanism or a scene in motion, in a browser; the page is updated whenever the file changes.
#[derive(clap::Args, Clone, Default, Debug)]
#[command(after_help = "Examples:
  cargo smartbed view fourbar
  cargo smartbed view press.toml --set k=400
  cargo smartbed view truss --still t=0.5 truss.png

Without --still the command prints the address of the page and serves it until Ctrl-C. When the file
is saved, it is simulated anew and the page shows the new motion. To write the page as a file:
`cargo smartbed run MODEL --view FILE.html`.")]
pub struct Arguments {
    /// The model or scene: a path, or a name under models/.
    pub model: String,
    /// Write the picture at time T (s) to a PNG file, and end: that of the nearest row, whose time it says. Needs a
    /// Chromium browser.
    #[arg(long, num_args = 2, value_names = ["t=T", "FILE.png"])]
    pub still: Option<Vec<String>>,
    /// TCP port of the page; 0 takes any free one.
    #[arg(long, value_name = "N", default_value_t = 0)]
    pub port: u16,
    /// Simulated time in s [default: the file's].
    #[arg(long, value_name = "T")]
    pub seconds: Option<f64>,
    /// Change a parameter or a start value of a model, or a key of a scene; may be repeated.
    #[arg(long, value_name = "NAME=VALUE")]
    pub set: Vec<String>,
    /// Print the address of the page, or the name of the picture, as one JSON object.
    #[arg(long)]
    pub json: bool,
}

impl Arguments {
    /// The run whose motion is shown.
    pub(super) fn run(&self, view: Option<String>) -> RunArguments {
        let (seconds, set) = (self.seconds, self.set.clone());
        RunArguments { model: self.model.clone(), seconds, set, view, ..RunArguments::default() }
    }
}
