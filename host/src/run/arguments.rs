//! Arguments of `smartbed run`.

use crate::engine::{EngineKind, ScalarKind};

/// Simulate a mechanism or a scene.
#[derive(clap::Args, Clone, Default, Debug)]
#[command(after_help = "Examples:
  cargo smartbed run pendulum3 --plot motion.svg
  cargo smartbed run tile --seconds 2 --step 1e-3 --method rk4 --set M=8 --set hA=0.02 --csv -
  cargo smartbed run fourbar --error 1e-9 --view fourbar.html
  cargo smartbed run single_spring --budget 200us
  cargo smartbed run single_spring --csv - --set C=10

Left-out settings are those of the model's [run]; the start is the model's [start], left-out
coordinates are nominal, dependent ones are solved for. SI units.")]
pub struct Arguments {
    /// The model or scene: a path, or a name under models/.
    pub model: String,
    /// Simulated time (s).
    #[arg(long, value_name = "T")]
    pub seconds: Option<f64>,
    /// Step (s); the first one of an adaptive method.
    #[arg(long, value_name = "H")]
    pub step: Option<f64>,
    /// Integration method: euler, semi-implicit, rk4 or dormand-prince; a scene has its own.
    #[arg(long, value_name = "M")]
    pub method: Option<String>,
    /// Error allowed per step, of a method of adaptive step [default: 1e-9].
    #[arg(long, value_name = "E")]
    pub tolerance: Option<f64>,
    /// Picks the fastest method and step that keep every coordinate this exact (m or rad).
    #[arg(long, value_name = "E", conflicts_with_all = ["step", "tolerance", "budget"])]
    pub error: Option<f64>,
    /// Picks the most exact method and step with this computing time per simulated second.
    #[arg(long, value_name = "TIME", conflicts_with_all = ["step", "tolerance"])]
    pub budget: Option<String>,
    /// What is computed with.
    #[arg(long, value_enum, default_value_t)]
    pub scalar: ScalarKind,
    /// A row every N steps.
    #[arg(long, value_name = "N")]
    pub every: Option<usize>,
    /// Write the rows to this file; - is standard output.
    #[arg(long, value_name = "FILE")]
    pub csv: Option<String>,
    /// Write the accounts of each part and each seam to this file, row by row; scenes of format 2.
    #[arg(long, value_name = "FILE", conflicts_with = "resume")]
    pub accounts: Option<String>,
    /// Plot coordinates and energies over time.
    #[arg(long, value_name = "FILE.svg|.png")]
    pub plot: Option<String>,
    /// What --plot shows beside energies: names of coordinates, speeds, outputs, inputs, with * and ?.
    #[arg(long, value_name = "h*,u_*", requires = "plot")]
    pub show: Option<String>,
    /// Write an animation that any browser shows; FILE.html#t=0.5 opens it at 0.5 s.
    #[arg(long, value_name = "FILE.html")]
    pub view: Option<String>,
    /// Changes a parameter or a start value; may be repeated.
    #[arg(long, value_name = "NAME=VALUE")]
    pub set: Vec<String>,
    /// Write where the run has come to, to go on from; scenes of format 2.
    #[arg(long, value_name = "FILE")]
    pub save: Option<String>,
    /// Go on from what --save wrote; --seconds counts from the first start.
    #[arg(long, value_name = "FILE")]
    pub resume: Option<String>,
    /// What evaluates.
    #[arg(long, value_enum, default_value_t)]
    pub engine: EngineKind,
    /// What went wrong in the motion (energy that no account explains, ranges left, a nearly singular
    /// configuration) is a failure, not a warning.
    #[arg(long)]
    pub strict: bool,
    /// Print one JSON object.
    #[arg(long)]
    pub json: bool,
}
