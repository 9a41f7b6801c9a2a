//! `smartbed figure`: a figure of the thesis, made by one command.
//!
//! In: its number. Out: a picture. One table ([`FIGURES`]) says for every figure of chapters 2 to 5 how it is made, or what
//! is still missing for it; `docs/figures.md` compares them with the thesis' captions.

use crate::failure::Failure;
use crate::plot::chart::{self, Chart, Curve, Panel};
use crate::{output, plot, run};
use smartbed_runtime::rigid::impact::{CurvePoint, Stage, Touch, trace};
use std::fmt::Write as _;

/// Make a figure of the thesis.
#[derive(clap::Args, Clone, Debug)]
#[command(after_help = "Examples:
  cargo smartbed figure 5.8
  cargo smartbed figure 5.8 --set C=20 -o damped.png
  cargo smartbed figure 4.2 --set e=1
  cargo smartbed figure --list")]
pub struct Arguments {
    /// Its number, for example 5.8.
    #[arg(required_unless_present = "list")]
    pub number: Option<String>,
    /// The picture; .svg or .png [default: figure_N.M.svg].
    #[arg(short, long, value_name = "FILE")]
    pub output: Option<String>,
    /// Changes a setting of the scene; of figure 4.2: e, mu, angle (deg), speed and slip (m/s).
    #[arg(long, value_name = "NAME=VALUE")]
    pub set: Vec<String>,
    /// List all figures and what each shows.
    #[arg(long)]
    pub list: bool,
}

/// How a figure is made.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Recipe {
    /// A run of a scene or model, with these settings.
    Run(&'static str, &'static [&'static str]),
    /// Work over impulse of a rigid rod that strikes the ground.
    WorkImpulse,
    /// It cannot be made yet: what is missing.
    Missing(&'static str),
}

/// A figure of the thesis.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Figure {
    /// Chapter and number.
    pub number: &'static str,
    /// The thesis' caption.
    pub caption: &'static str,
    /// How it is made.
    pub recipe: Recipe,
}

const fn figure(number: &'static str, caption: &'static str, recipe: Recipe) -> Figure {
    Figure { number, caption, recipe }
}

const UNDAMPED: &[&str] = &["C=0"];
const DAMPED: &[&str] = &["C=10"];
const SCHEME: Recipe = Recipe::Missing("a scheme, not a result; docs/notation.md has the frames and names");
const BED: Recipe = Recipe::Missing("needs the bed of 28 tiles");

/// All figures of chapters 2 to 5.
pub const FIGURES: [Figure; 37] = [
    figure("2.1", "Soft Manipulation on Flexible Bladder", Recipe::Missing("needs a body on a bladder")),
    figure("2.2", "Tile Design", SCHEME),
    figure("2.3", "Tile Frame Assignment", SCHEME),
    figure("2.4", "Constrained System", SCHEME),
    figure("2.5", "Bed Tilt", BED),
    figure("2.6", "Bed with Human", BED),
    figure("3.1", "Discretized Plate", Recipe::Run("bladder", &[])),
    figure("3.2", "Spring Mass Damper", Recipe::Missing("needs the scene of a damped mass on a fixed end")),
    figure("3.3", "Spring Loaded Pendulum", Recipe::Run("spring_loaded_pendulum", &[])),
    figure("3.4", "Closed Loop Flexible Body", Recipe::Run("closed_loop_3_links", &[])),
    figure("3.5", "Point mass constrained by 4 springs", Recipe::Run("mass_on_4_springs", &[])),
    figure("3.6", "Pressurized Mesh", Recipe::Run("bladder", &[])),
    figure("3.7", "Pressure in mesh", Recipe::Run("bladder", &[])),
    figure("3.8", "Configuration of Sensor Platform", SCHEME),
    figure("3.9", "Sensor Array", SCHEME),
    figure("4.1", "Contact", Recipe::Missing("needs a rigid ball that rests on the ground")),
    figure("4.2", "Rigid Body Work Plot", Recipe::WorkImpulse),
    figure("4.3", "Impact Phenomenon", Recipe::Run("single_spring", &["C=0", "seconds=0.6"])),
    figure("5.1", "Single Spring", Recipe::Run("single_spring", UNDAMPED)),
    figure("5.2", "Double Spring", Recipe::Run("double_spring", UNDAMPED)),
    figure("5.3", "Cylinder", Recipe::Run("cylinder", UNDAMPED)),
    figure("5.4", "Truss", Recipe::Run("truss", UNDAMPED)),
    figure("5.5", "Prism", Recipe::Run("prism", UNDAMPED)),
    figure("5.6", "Cube", Recipe::Run("cube", UNDAMPED)),
    figure("5.7", "Energy Graph of Spring w/o Damping", Recipe::Run("single_spring", UNDAMPED)),
    figure("5.8", "Energy Graph of Spring with Damping", Recipe::Run("single_spring", DAMPED)),
    figure("5.9", "Energy Graph of Double Spring w/o Damping", Recipe::Run("double_spring", UNDAMPED)),
    figure("5.10", "Energy Graph of Double Spring with Damping", Recipe::Run("double_spring", DAMPED)),
    figure("5.11", "Energy Graph of Cylinder w/o Damping", Recipe::Run("cylinder", UNDAMPED)),
    figure("5.12", "Energy Graph of Cylinder with Damping", Recipe::Run("cylinder", DAMPED)),
    figure("5.13", "Energy Graph of Truss w/o Damping", Recipe::Run("truss", UNDAMPED)),
    figure("5.14", "Energy Graph of Truss with Damping", Recipe::Run("truss", DAMPED)),
    figure("5.15", "Energy Graph of Prism w/o Damping", Recipe::Run("prism", UNDAMPED)),
    figure("5.16", "Energy Graph of Prism with Damping", Recipe::Run("prism", DAMPED)),
    figure("5.17", "Energy Graph of Cube w/o Damping", Recipe::Run("cube", UNDAMPED)),
    figure("5.18", "Energy Graph of Cube with Damping", Recipe::Run("cube", DAMPED)),
    figure("5.19", "Cube Structure", Recipe::Run("complex_structure", UNDAMPED)),
];

/// Does what the command line asks for.
///
/// # Errors
/// [`Failure::Wrong`] for an unknown figure, one that cannot be made, or a wrong setting.
pub fn run(arguments: &Arguments) -> Result<(), Failure> {
    let Some(number) = arguments.number.as_ref().filter(|_| !arguments.list) else {
        return output::print(&list());
    };
    let Some(figure) = FIGURES.iter().find(|f| f.number == number) else {
        return Err(Failure::Wrong(format!(
            "figure {number}: the thesis has none of that number; `cargo smartbed figure --list` shows all"
        )));
    };
    let file = arguments.output.clone().unwrap_or_else(|| format!("figure_{number}.svg"));
    plot::format_of(&file)?;
    match figure.recipe {
        Recipe::Missing(what) => {
            return Err(Failure::Wrong(format!("figure {number} ({}): {what}", figure.caption)));
        }
        Recipe::Run(model, settings) => {
            let set = settings.iter().map(|s| (*s).to_owned());
            let changed = |s: &String| arguments.set.iter().any(|own| name_of(own) == name_of(s));
            let set = set.filter(|s| !changed(s)).chain(arguments.set.iter().cloned()).collect();
            let model = model.to_owned();
            run::run(&run::Arguments { model, plot: Some(file.clone()), set, ..Default::default() })?;
        }
        Recipe::WorkImpulse => plot::write(&file, &Rod::new(&arguments.set)?.draw())?,
    }
    output::print(&format!("{file}: figure {number}, {}\n", figure.caption))
}

fn name_of(setting: &str) -> &str {
    setting.split('=').next().unwrap_or_default().trim()
}

fn list() -> String {
    let mut text = String::new();
    for Figure { number, caption, recipe } in FIGURES {
        let how = match recipe {
            Recipe::Run(model, []) => format!("run {model}"),
            Recipe::Run(model, settings) => format!("run {model} --set {}", settings.join(" --set ")),
            Recipe::WorkImpulse => "a rod strikes the ground".to_owned(),
            Recipe::Missing(what) => format!("not made: {what}"),
        };
        let _ = writeln!(text, "{number:<5} {caption:<44} {how}");
    }
    text
}

/// A slender rod of 1 kg and 1 m that strikes the ground with its lower end, without spin.
#[derive(Clone, Copy)]
struct Rod {
    restitution: f64,
    friction: f64,
    /// From the ground (rad).
    angle: f64,
    /// Downwards (m/s).
    speed: f64,
    /// Along the ground, away from the centre's side (m/s).
    slip: f64,
}

impl Rod {
    fn new(settings: &[String]) -> Result<Rod, Failure> {
        let mut rod =
            Rod { restitution: 0.6, friction: 0.3, angle: 60_f64.to_radians(), speed: 3.0, slip: 1.0 };
        for setting in settings {
            let wrong = |expected: &str| Failure::Wrong(format!("--set {setting}: expected {expected}"));
            let value = setting.split_once('=').and_then(|(_, v)| v.trim().parse::<f64>().ok());
            let value = value.filter(|v| v.is_finite()).ok_or_else(|| wrong("NAME=NUMBER"))?;
            match name_of(setting) {
                "e" if (0.0..=1.0).contains(&value) => rod.restitution = value,
                "mu" if value >= 0.0 => rod.friction = value,
                "angle" if (0.0..=90.0).contains(&value) => rod.angle = value.to_radians(),
                "speed" if value > 0.0 => rod.speed = value,
                _ => {
                    return Err(wrong(
                        "e from 0 to 1, mu of 0 or more, angle from 0 to 90, or speed above 0",
                    ));
                }
            }
        }
        Ok(rod)
    }

    fn touch(&self) -> Touch<f64> {
        // J = m l^2/12 with m = l = 1; the end lies at (x, y) from the centre.
        let (x, y) = (-0.5 * self.angle.cos(), -0.5 * self.angle.sin());
        let inverse_mass = [
            [1.0 + 12.0 * x * x, -12.0 * x * y, 0.0],
            [-12.0 * x * y, 1.0 + 12.0 * y * y, 0.0],
            [0.0, 0.0, 1.0],
        ];
        let (friction, restitution) = (self.friction, self.restitution);
        Touch { inverse_mass, velocity: [-self.speed, self.slip, 0.0], friction, restitution }
    }

    /// Work and relative speeds over the normal impulse, the phases in colours of their own.
    fn draw(&self) -> plot::drawing::Drawing {
        let mut points = Vec::new();
        let impact = trace(&self.touch(), |point| points.push(point));
        let phases = [("compression", Stage::Compression), ("restitution", Stage::Restitution)];
        let first = points.first().copied();
        let mut work: Vec<Curve> = phases
            .into_iter()
            .map(|(name, stage)| {
                let (across, values) = work_curve(&points, stage);
                Curve { name: name.to_owned(), values, color: None, across: Some(across) }
            })
            .collect();
        // Before the collision no impulse acts: the phase before it is the curve's first point too.
        if let Some(first) = first {
            let (values, across) = (vec![first.work], Some(vec![first.impulse]));
            work.push(Curve { name: "collision".to_owned(), values, color: None, across });
        }
        let speed = |name: &str, axis: usize| Curve {
            name: name.to_owned(),
            values: points.iter().map(|p| p.velocity[axis]).collect(),
            color: None,
            across: Some(points.iter().map(|p| p.impulse).collect()),
        };
        let panels = [
            Panel { label: "work [J]".to_owned(), curves: work },
            Panel { label: "speed [m/s]".to_owned(), curves: vec![speed("normal", 0), speed("slip", 1)] },
        ];
        let impulses: Vec<f64> = points.iter().map(|p| p.impulse).collect();
        let note = format!(
            "rod of 1 kg and 1 m at {:.0} deg, {} m/s down, {} m/s along, e = {}, mu = {}; W_c = {:.4} J, W_n = {:.4} J, friction {:.4} J",
            self.angle.to_degrees(),
            self.speed,
            self.slip,
            self.restitution,
            self.friction,
            impact.compression_work,
            impact.normal_work,
            impact.friction_work
        );
        chart::draw(&Chart {
            title: "Work over normal impulse of a rigid impact (Fig. 4.2)",
            note: &note,
            across: "normal impulse [N s]",
            time: &impulses,
            panels: &panels,
            events: &[],
        })
    }
}

/// The work over the impulse in one stage, between its points by cubics of the same slopes: dW/dp = `v_n`.
fn work_curve(points: &[CurvePoint<f64>], stage: Stage) -> (Vec<f64>, Vec<f64>) {
    /// Pieces between two points.
    const PIECES: u32 = 24;
    let mut curve = (Vec::new(), Vec::new());
    // A stage is what a piece runs through; the point at the end of compression is already marked as restitution.
    let inside =
        |pair: &&[CurvePoint<f64>]| (pair[0].stage == Stage::Restitution) == (stage == Stage::Restitution);
    for pair in points.windows(2).filter(inside) {
        let (a, b) = (pair[0], pair[1]);
        let length = b.impulse - a.impulse;
        for n in 0..=PIECES {
            let s = f64::from(n) / f64::from(PIECES);
            let (h00, h10) = ((1.0 + 2.0 * s) * (1.0 - s).powi(2), s * (1.0 - s).powi(2));
            let (h01, h11) = (s * s * (3.0 - 2.0 * s), s * s * (s - 1.0));
            curve.0.push(a.impulse + s * length);
            curve.1.push(
                h00 * a.work + h10 * length * a.velocity[0] + h01 * b.work + h11 * length * b.velocity[0],
            );
        }
    }
    curve
}
