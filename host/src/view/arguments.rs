//! Arguments of `smartbed view`.

use crate::run::arguments::Arguments as RunArguments;

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
    pub(super) fn run(&self, view: Option<String>) -> RunArguments {
        let (seconds, set) = (self.seconds, self.set.clone());
        RunArguments { model: self.model.clone(), seconds, set, view, ..RunArguments::default() }
    }
}
