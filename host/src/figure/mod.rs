//! `smartbed figure`: makes a figure of the thesis with one command.
//!
//! In: its number. Out: a picture. One table ([`FIGURES`]) says for every figure of chapters 2 to 5 how it is made;
//! `docs/figures.md` compares them with the thesis' captions.

mod bed;
mod rest;
mod rod;
mod scheme;
mod setting;

use crate::failure::Failure;
use crate::number::json_string;
use crate::{output, plot, run};
use scheme::Tile;
use setting::name_of;
use std::fmt::Write as _;

/// Draw a figure of the thesis anew: from a run, or as a schematic drawing of the design.
#[derive(clap::Args, Clone, Debug)]
#[command(after_help = "Examples:
  cargo smartbed figure 5.8
  cargo smartbed figure 5.8 --set C=20 -o damped.png
  cargo smartbed figure 4.2 --set e=1
  cargo smartbed figure --list")]
pub struct Arguments {
    /// Number of the figure, for example 5.8.
    #[arg(required_unless_present = "list")]
    pub number: Option<String>,
    /// File for the picture, .svg or .png [default: figure_N.M.svg].
    #[arg(short, long, value_name = "FILE")]
    pub output: Option<String>,
    /// Change a key of the scene or plan behind the figure; may be repeated. Figure 4.1 has e, height (m) and mass
    /// (kg); figure 4.2 has e, mu, angle (deg), speed (m/s) and slip (m/s). Schematic drawings refuse it.
    #[arg(long, value_name = "NAME=VALUE")]
    pub set: Vec<String>,
    /// List all figures, and how each is made.
    #[arg(long)]
    pub list: bool,
    /// Print JSON: the run's object if there is a run, then one with the figure's file; with --list one object with
    /// all figures.
    #[arg(long)]
    pub json: bool,
}

/// How a figure is made.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Recipe {
    /// A run of a scene or model, with these settings.
    Run(&'static str, &'static [&'static str]),
    /// A rigid ball falls and comes to rest: the force of the ground on it.
    Rest,
    /// Work over impulse for the impact of a rigid rod.
    WorkImpulse,
    /// Four states of one bladder under a load.
    Soft,
    /// A patient on all tiles.
    Human,
    /// A schematic drawing of the tile, not a result.
    Tile(Tile),
    /// A schematic drawing of a site of sensors.
    Platform,
    /// A schematic drawing of four sites, with their frequency bands.
    Array,
}

impl Recipe {
    /// Is it a schematic drawing of the design, not a result?
    fn is_scheme(self) -> bool {
        matches!(self, Recipe::Tile(_) | Recipe::Platform | Recipe::Array)
    }
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
/// All tiles at one tilt; the ball's impact needs shorter steps than lifting it.
const TILTED: &[&str] = &["parts.tile.command={ slope_y = '-0.15' }", "run.step=0.2_ms"];

/// All figures of chapters 2 to 5.
pub const FIGURES: [Figure; 37] = [
    figure("2.1", "Soft Manipulation on Flexible Bladder", Recipe::Soft),
    figure("2.2", "Tile Design", Recipe::Tile(Tile::Design)),
    figure("2.3", "Tile Frame Assignment", Recipe::Tile(Tile::Frames)),
    figure("2.4", "Constrained System", Recipe::Tile(Tile::Loops)),
    figure("2.5", "Bed Tilt", Recipe::Run("bed", TILTED)),
    figure("2.6", "Bed with Human", Recipe::Human),
    figure("3.1", "Discretized Plate", Recipe::Run("bladder", &[])),
    figure("3.2", "Spring Mass Damper", Recipe::Run("damper_mass_fixed_end", &[])),
    figure("3.3", "Spring Loaded Pendulum", Recipe::Run("spring_loaded_pendulum", &[])),
    figure("3.4", "Closed Loop Flexible Body", Recipe::Run("closed_loop_3_links", &[])),
    figure("3.5", "Point mass constrained by 4 springs", Recipe::Run("mass_on_4_springs", &[])),
    figure("3.6", "Pressurized Mesh", Recipe::Run("bladder", &[])),
    figure("3.7", "Pressure in mesh", Recipe::Run("bladder", &[])),
    figure("3.8", "Configuration of Sensor Platform", Recipe::Platform),
    figure("3.9", "Sensor Array", Recipe::Array),
    figure("4.1", "Contact", Recipe::Rest),
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
    figure("5.19", "Cube Structure", Recipe::Run("centre_masses", UNDAMPED)),
];

/// Runs the command.
///
/// # Errors
/// [`Failure::Wrong`] for an unknown figure, one that cannot be made, or a wrong setting.
pub fn run(arguments: &Arguments) -> Result<(), Failure> {
    let Some(number) = arguments.number.as_ref().filter(|_| !arguments.list) else {
        return output::print(&if arguments.json { list_json() } else { list() });
    };
    let Some(figure) = FIGURES.iter().find(|f| f.number == number) else {
        return Err(Failure::Wrong(format!(
            "figure {number}: the thesis has no figure of this number; `cargo smartbed figure --list` shows all"
        )));
    };
    let file = arguments.output.clone().unwrap_or_else(|| format!("figure_{number}.svg"));
    plot::format_of(&file)?;
    match figure.recipe {
        recipe if recipe.is_scheme() && !arguments.set.is_empty() => {
            return Err(Failure::Wrong(format!(
                "figure {number} is a schematic drawing without settings; leave --set \
                                               out"
            )));
        }
        Recipe::Tile(what) => plot::write(&file, &scheme::tile(what))?,
        Recipe::Platform => plot::write(&file, &scheme::platform())?,
        Recipe::Array => plot::write(&file, &scheme::array())?,
        Recipe::Human => plot::write(&file, &bed::human(&arguments.set)?)?,
        Recipe::Soft => {
            let (drawing, claims) = bed::soft(&arguments.set)?;
            plot::write(&file, &drawing)?;
            for claim in claims.iter().filter(|_| !arguments.json) {
                let verdict = if claim.holds { "shown" } else { "refuted" };
                output::print(&format!("{verdict}: {} ({})\n", claim.says, claim.found))?;
            }
        }
        Recipe::Run(model, settings) => {
            let set = settings.iter().map(|s| (*s).to_owned());
            let changed = |s: &String| arguments.set.iter().any(|own| name_of(own) == name_of(s));
            let set = set.filter(|s| !changed(s)).chain(arguments.set.iter().cloned()).collect();
            let model = model.to_owned();
            run::run(&run::Arguments {
                model,
                plot: Some(file.clone()),
                set,
                json: arguments.json,
                ..Default::default()
            })?;
        }
        Recipe::Rest => plot::write(&file, &rest::Ball::new(&arguments.set)?.draw()?)?,
        Recipe::WorkImpulse => plot::write(&file, &rod::Rod::new(&arguments.set)?.draw())?,
    }
    if arguments.json {
        let (file, caption) = (json_string(&file), json_string(figure.caption));
        return output::print(&format!(
            "{{\"figure\": \"{number}\", \"file\": {file}, \"caption\": {caption}}}\n"
        ));
    }
    output::print(&format!("{file}: figure {number}, {}\n", figure.caption))
}

/// All figures as one line of JSON.
fn list_json() -> String {
    let one = |figure: &Figure| {
        let is_scheme = figure.recipe.is_scheme();
        let caption = json_string(figure.caption);
        format!("{{\"figure\": \"{}\", \"caption\": {caption}, \"scheme\": {is_scheme}}}", figure.number)
    };
    format!("{{\"figures\": [{}]}}\n", FIGURES.iter().map(one).collect::<Vec<_>>().join(", "))
}

/// All figures and how each is made.
fn list() -> String {
    let mut text = String::new();
    for Figure { number, caption, recipe } in FIGURES {
        let how = match recipe {
            Recipe::Run(model, []) => format!("run {model}"),
            Recipe::Run(model, settings) => format!("run {model} --set {}", settings.join(" --set ")),
            Recipe::Rest => "a rigid ball comes to rest".to_owned(),
            Recipe::WorkImpulse => "a rod strikes the ground".to_owned(),
            Recipe::Soft => "plan soft_manipulation, stiff, deflated, tilted, both".to_owned(),
            Recipe::Human => "plan alternating at rest".to_owned(),
            Recipe::Tile(_) | Recipe::Platform | Recipe::Array => {
                "a schematic drawing, not a result".to_owned()
            }
        };
        let _ = writeln!(text, "{number:<5} {caption:<44} {how}");
    }
    text
}
