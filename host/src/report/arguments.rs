//! Arguments of `smartbed report`, and the plan that follows from them.

use super::chip::Chip;
use super::measure;
use super::plan::Plan;
use super::point::Control;
use crate::engine::{EngineKind, ScalarKind};
use crate::failure::Failure;
use std::time::Duration;

/// Images for the chip are built until so much time has passed since the report's begin.
const CHIP_TIME: Duration = Duration::from_secs(1080);

/// Measure computing time against error of all methods: tables, plots, one HTML page.
#[derive(clap::Args, Clone, Default, Debug)]
#[command(after_help = "Examples:
  cargo smartbed report --quick
  cargo smartbed report single_spring tile --out target/report
  cargo smartbed report single_spring --seconds 3 --method verlet --step 1e-4 --scalar f64

The last example measures one row of a table again. The command writes report.md, report.csv,
report.json, report.html and one plot for each scene or mechanism (SVG). docs/report.md explains
the numbers.")]
pub struct Arguments {
    /// Scenes and mechanisms: paths, or names under models/ [default: all that are shipped].
    pub subjects: Vec<String>,
    /// Take about a minute instead of some ten: fewer steps, shorter runs, mechanisms interpreted, no costs on the
    /// chip.
    #[arg(long)]
    pub quick: bool,
    /// Folder for the files; it is made if it does not exist.
    #[arg(long, value_name = "DIR", default_value = "target/report")]
    pub out: String,
    /// Simulated time in s [default: the file's, shortened to the time over which two reference solutions agree].
    #[arg(long, allow_negative_numbers = true, value_name = "T")]
    pub seconds: Option<f64>,
    /// Measure only this method.
    #[arg(long, value_name = "M")]
    pub method: Option<String>,
    /// Measure only this step in s, with methods of fixed step. Not with --tolerance.
    #[arg(long, allow_negative_numbers = true, value_name = "H", conflicts_with = "tolerance")]
    pub step: Option<f64>,
    /// Measure only this error allowed per step, with adaptive methods. Not with --step.
    #[arg(long, allow_negative_numbers = true, value_name = "E")]
    pub tolerance: Option<f64>,
    /// Measure only this number type [default: both].
    #[arg(long, value_enum)]
    pub scalar: Option<ScalarKind>,
    /// How the equations of mechanisms are evaluated [default: compiled; interpreter with --quick, --step or
    /// --tolerance].
    #[arg(long, value_enum)]
    pub engine: Option<EngineKind>,
    /// Do not measure costs on the microcontroller.
    #[arg(long)]
    pub no_chip: bool,
    /// Add points and tables of other simulators from this file, as `tests/peers/motions.py` writes them; may be
    /// repeated.
    #[arg(long, value_name = "FILE.json")]
    pub points: Vec<String>,
    /// Also write the summary as DIR/PROCESSOR.md, and the points that no other point beats in both time and error as
    /// DIR/PROCESSOR.json.
    #[arg(long, value_name = "DIR")]
    pub results: Option<String>,
    /// Print the report as JSON.
    #[arg(long)]
    pub json: bool,
}

impl Arguments {
    /// Is only one row asked for?
    pub(super) fn is_row(&self) -> bool {
        self.step.is_some() || self.tolerance.is_some()
    }

    /// Source of the costs on the chip, if `elapsed` seconds of the report have passed.
    pub(super) fn chip(&self, elapsed: f64) -> Chip {
        match (self.quick, self.no_chip, self.is_row()) {
            (true, ..) => Chip::none("left out by --quick"),
            (_, true, _) => Chip::none("left out by --no-chip"),
            (.., true) => Chip::none("not of a single row"),
            _ => Chip::new(CHIP_TIME.saturating_sub(Duration::from_secs_f64(elapsed))),
        }
    }

    /// The report as a command line.
    pub(super) fn command(&self) -> String {
        let mut words = vec!["cargo smartbed report".to_owned()];
        words.extend(self.subjects.iter().cloned());
        let mut option = |name: &str, value: Option<String>| {
            words.extend(value.map(|v| format!("--{name} {v}")));
        };
        option("seconds", self.seconds.map(|x| x.to_string()));
        option("method", self.method.clone());
        option("step", self.step.map(|x| format!("{x:e}")));
        option("tolerance", self.tolerance.map(|x| format!("{x:e}")));
        option("scalar", self.scalar.map(|s| measure::name_of(s).to_owned()));
        self.points.iter().for_each(|p| option("points", Some(p.clone())));
        words.extend(self.results.as_ref().map(|f| format!("--results {f}")));
        let flags = [("--quick", self.quick), ("--no-chip", self.no_chip)];
        words.extend(flags.into_iter().filter(|f| f.1).map(|f| f.0.to_owned()));
        words.join(" ")
    }

    pub(super) fn plan(&self) -> Result<Plan, Failure> {
        let positive = |name: &str, value: Option<f64>| match value {
            Some(x) if !(x > 0.0 && x.is_finite()) => {
                Err(Failure::Wrong(format!("--{name} {x}: expected a number above 0")))
            }
            _ => Ok(value),
        };
        positive("seconds", self.seconds)?;
        let step = positive("step", self.step)?.map(Control::Step);
        let control = step.or(positive("tolerance", self.tolerance)?.map(Control::Tolerance));
        let plan = if self.quick { Plan::quick() } else { Plan::full() };
        let single = if control.is_some() { EngineKind::Interpreter } else { plan.engine };
        let engine = self.engine.unwrap_or(single);
        Ok(Plan { method: self.method.clone(), control, scalar: self.scalar, engine, ..plan })
    }
}
