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

Settings that are left out are taken from [run] of the file. A mechanism starts as its [start] says;
coordinates that are not given there have their nominal values, dependent ones are solved for.
Numbers are in SI units.")]
pub struct Arguments {
    /// The model or scene: a path, or a name under models/.
    pub model: String,
    /// Simulated time in s [default: the file's].
    #[arg(long, value_name = "T", allow_negative_numbers = true)]
    pub seconds: Option<f64>,
    /// Step in s; of an adaptive method the first step [default: the file's]. Not with --error or --budget.
    #[arg(long, value_name = "H", allow_negative_numbers = true)]
    pub step: Option<f64>,
    /// Integration method [default: the file's]. Of a mechanism: euler, semi-implicit, rk4 or dormand-prince
    /// (adaptive); of a scene: see docs/scenes.md.
    #[arg(long, value_name = "M")]
    pub method: Option<String>,
    /// Error allowed per step, absolute (SI) and relative [default: 1e-9]. Only for adaptive methods; refused by
    /// scenes of format 2.
    #[arg(long, value_name = "E", allow_negative_numbers = true)]
    pub tolerance: Option<f64>,
    /// Choose the fastest method and step whose error in every coordinate is at most this (m or rad), by trial runs
    /// of some seconds. Not with --step, --tolerance or --budget.
    #[arg(long, value_name = "E", allow_negative_numbers = true, conflicts_with_all = ["step", "tolerance", "budget"])]
    pub error: Option<f64>,
    /// Choose the most accurate method and step that take at most this computing time per simulated second, with its
    /// unit: ns, us, ms or s. Not with --step, --tolerance or --error.
    #[arg(long, value_name = "TIME", conflicts_with_all = ["step", "tolerance"])]
    pub budget: Option<String>,
    /// Number type of the computation.
    #[arg(long, value_enum, default_value_t)]
    pub scalar: ScalarKind,
    /// Write a row every N steps; of an adaptive method every N times --step [default: the file's].
    #[arg(long, value_name = "N")]
    pub every: Option<usize>,
    /// Write the rows as CSV to this file; - is standard output.
    #[arg(long, value_name = "FILE")]
    pub csv: Option<String>,
    /// Write the energy accounts of each part and each seam as CSV to this file, row by row. Only for scenes of
    /// format 2; not with --resume.
    #[arg(long, value_name = "FILE", conflicts_with = "resume")]
    pub accounts: Option<String>,
    /// Plot coordinates and energies over time; the ending of the name decides the format.
    #[arg(long, value_name = "FILE.svg|.png")]
    pub plot: Option<String>,
    /// Curves that --plot shows beside the energies: names of coordinates, speeds, outputs or inputs, separated by
    /// commas; * and ? stand for any letters and any one letter.
    #[arg(long, value_name = "h*,u_*", requires = "plot")]
    pub show: Option<String>,
    /// Write an animation as a page for the browser; FILE.html#t=0.5 opens it at 0.5 s.
    #[arg(long, value_name = "FILE.html")]
    pub view: Option<String>,
    /// Change a parameter or a start value of a model, or a key of a scene; may be repeated.
    #[arg(long, value_name = "NAME=VALUE")]
    pub set: Vec<String>,
    /// Write the state at the end of the run to this file, for --resume. Only for scenes of format 2; the run must be
    /// a whole number of steps long.
    #[arg(long, value_name = "FILE")]
    pub save: Option<String>,
    /// Continue from a file that --save wrote, with the same scene and step. --seconds counts from t = 0, not from
    /// the saved state. Not with --error or --budget.
    #[arg(long, value_name = "FILE")]
    pub resume: Option<String>,
    /// How the equations of a mechanism are evaluated. Scenes refuse `compiled`.
    #[arg(long, value_enum, default_value_t)]
    pub engine: EngineKind,
    /// End with status 1 instead of a warning if energy is gained or lost that no account explains, if a coordinate
    /// leaves its range, or if the motion comes near a singular configuration.
    #[arg(long)]
    pub strict: bool,
    /// Print the summary as one JSON object.
    #[arg(long)]
    pub json: bool,
}
