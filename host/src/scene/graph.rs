//! What a run of a scene looks like: heights, energies in the thesis' colours, work over impulse, pictures.
//!
//! In: rows and events as [`super::run::run`] gives them. Out: a [`Drawing`], written as SVG or PNG.
//! Colours of chapter 5: total blue, kinetic orange, potential green, gravity purple, spring red.

use super::pictures::Pictures;
use super::read::Scene;
use super::run::{EventRecord, Row};
use crate::failure::Failure;
use crate::plot::chart::{self, Curve, Panel};
use crate::plot::drawing::{Color, Drawing, Item};
use crate::plot::{self, Recording};

/// Energies of the graph: name and colour, back to front.
pub const ENERGIES: [(&str, Color); 6] = [
    ("pressure", [110, 110, 110]),
    ("spring", [214, 39, 40]),
    ("gravity", [148, 103, 189]),
    ("potential", [44, 160, 44]),
    ("kinetic", [255, 127, 14]),
    ("total", [31, 119, 180]),
];
/// Accounts of what left the body.
const ACCOUNTS: [&str; 5] = ["damping", "drag", "impact", "friction", "actuator"];
/// Most points whose height is plotted.
const HEIGHTS: usize = 8;
/// Most impacts whose work is plotted, the strongest; more curves cannot be told apart.
const IMPACTS: usize = 8;
/// Points of one phase of a work-impulse curve.
const PHASE: usize = 24;

/// What of a run is kept for its drawing.
#[derive(Clone, Debug)]
pub struct Album {
    heights: usize,
    recording: Recording,
    pictures: Pictures,
}

impl Album {
    /// Nothing yet.
    #[must_use]
    pub fn new(scene: &Scene) -> Self {
        let heights = scene.lists.points.len().min(HEIGHTS);
        let columns = 1 + heights + ENERGIES.len() + ACCOUNTS.len();
        Self { heights, recording: Recording::new(columns), pictures: Pictures::new(scene) }
    }

    /// Looks at a row.
    pub fn push(&mut self, row: &Row) {
        let [kinetic, gravity, spring, pressure] = row.energy.stored;
        let potential = gravity + spring + pressure;
        let heights = row.pos.iter().take(self.heights).map(|x| x[2]);
        let energies = [pressure, spring, gravity, potential, kinetic, row.energy.total];
        let numbers: Vec<f64> =
            std::iter::once(row.t).chain(heights).chain(energies).chain(row.energy.accounts).collect();
        self.recording.push(&numbers);
        self.pictures.push(row);
    }

    /// The whole drawing: charts, then pictures.
    #[must_use]
    pub fn draw(&self, scene: &Scene, events: &[EventRecord]) -> Drawing {
        let mut drawing = self.charts(scene);
        let impacts = impact_curves(events);
        if !impacts.is_empty() {
            let panel = Panel { label: "work [J]".to_owned(), curves: impacts };
            let impulse = panel.curves.iter().flat_map(|c| c.across.clone().unwrap_or_default());
            let impulse: Vec<f64> = impulse.collect();
            let title = "work over impulse: the ground takes it, the springs give it back";
            below(&mut drawing, chart::draw(title, "impulse [N s]", &impulse, &[panel]));
        }
        below(&mut drawing, self.pictures.draw(scene));
        drawing
    }

    /// Heights, energies, losses over time.
    fn charts(&self, scene: &Scene) -> Drawing {
        let column = |name: &str, index: usize, color: Option<Color>| {
            let values = self.recording.column(index);
            Curve { name: name.to_owned(), values, color, across: None }
        };
        let heights = (0..self.heights).map(|i| column(&format!("z{i}"), 1 + i, None)).collect();
        let first = 1 + self.heights;
        let energies =
            ENERGIES.iter().enumerate().map(|(n, (name, color))| column(name, first + n, Some(*color)));
        let first = first + ENERGIES.len();
        let accounts = ACCOUNTS.iter().enumerate().map(|(n, name)| column(name, first + n, None));
        // An account that nothing was booked to tells nothing.
        let told = |c: &Curve| c.values.iter().any(|x| *x != 0.0);
        let mut panels = vec![
            Panel { label: "height [m]".to_owned(), curves: heights },
            Panel { label: "energy [J]".to_owned(), curves: energies.filter(told).collect() },
        ];
        let accounts: Vec<Curve> = accounts.filter(told).collect();
        if !accounts.is_empty() {
            panels.push(Panel { label: "taken out [J]".to_owned(), curves: accounts });
        }
        chart::draw(&scene.title, "time [s]", &self.recording.column(0), &panels)
    }
}

/// Draws a run and writes it; SVG or PNG by the file's name.
///
/// # Errors
/// [`Failure::Wrong`] if the file cannot be written or has another ending.
pub fn write(file: &str, album: &Album, scene: &Scene, events: &[EventRecord]) -> Result<(), Failure> {
    plot::write(file, &album.draw(scene, events))
}

/// Curves of the strongest impacts, in order of time.
fn impact_curves(events: &[EventRecord]) -> Vec<Curve> {
    let mut strongest: Vec<&EventRecord> =
        events.iter().filter(|e| e.work.is_some_and(|w| w.taken > 0.0)).collect();
    let taken = |e: &EventRecord| e.work.map_or(0.0, |w| w.taken);
    strongest.sort_by(|a, b| taken(b).total_cmp(&taken(a)));
    strongest.truncate(IMPACTS);
    strongest.sort_by(|a, b| a.time.total_cmp(&b.time));
    let curve = |event: &EventRecord| {
        let (across, values) = event.work?.curve(PHASE).into_iter().unzip();
        Some(Curve { name: format!("{:.4} s", event.time), values, color: None, across: Some(across) })
    };
    strongest.into_iter().filter_map(curve).collect()
}

/// Puts a drawing under another.
fn below(drawing: &mut Drawing, lower: Drawing) {
    let down = drawing.height as f64;
    let moved = lower.items.into_iter().map(|item| match item {
        Item::Line { points, color, width } => {
            Item::Line { points: points.into_iter().map(|(x, y)| (x, y + down)).collect(), color, width }
        }
        Item::Text { at, text, size, anchor, upwards } => {
            Item::Text { at: (at.0, at.1 + down), text, size, anchor, upwards }
        }
    });
    drawing.items.extend(moved);
    drawing.width = drawing.width.max(lower.width);
    drawing.height += lower.height;
}
