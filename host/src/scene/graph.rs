//! The graph of a scene's run: heights, energies in the thesis' colours, work over impulse, pictures.
//!
//! In: rows and events from [`super::run::run`]. Out: a [`Drawing`], written as SVG or PNG. Colours of chapter 5: total
//! blue, kinetic orange, potential green, gravity purple, spring red.

use super::pictures::Pictures;
use super::read::Scene;
use super::run::{EventRecord, Row};
use crate::engine::ScalarKind;
use crate::failure::Failure;
use crate::plot::chart::{self, Chart, Curve, Panel};
use crate::plot::drawing::Drawing;
use crate::plot::energies;
use crate::plot::panels::{self, Shown};
use crate::plot::{Recording, pattern};

/// Energies of the graph, back to front.
const ENERGIES: [&str; 6] = ["pressure", "spring", "gravity", "potential", "kinetic", "total"];
/// Accounts of energy that left the body.
const ACCOUNTS: [&str; 5] = ["damping", "drag", "impact", "friction", "actuator"];
/// Most points whose height is plotted by default.
const HEIGHTS: usize = 7;
/// Most impacts whose work is plotted, the strongest ones; more curves cannot be distinguished.
const IMPACTS: usize = 7;
/// Points in each phase of a work-impulse curve.
const PHASE: usize = 24;

/// The part of a run that is kept for its drawing.
#[derive(Clone, Debug)]
pub struct Drawings {
    /// Points' coordinates and velocities that are drawn: name, unit, index in a row's state.
    curves: Vec<(String, &'static str, usize)>,
    /// Are the curves the default ones, heights only?
    heights: bool,
    /// A note on how the run was made.
    note: String,
    recording: Recording,
    pictures: Pictures,
}

impl Drawings {
    /// Without rows. The heights of the first points are drawn, or what `show` names (see [`pattern`]).
    ///
    /// # Errors
    /// [`Failure::Wrong`] for a pattern that matches nothing.
    pub fn new(scene: &Scene, show: Option<&str>, note: &str) -> Result<Self, Failure> {
        let n = scene.lists.points.len();
        let axes = ["x", "y", "z"];
        let name = |part: &str, i: usize| format!("{part}{}{}", axes[i % 3], i / 3);
        let places = (0..3 * n).map(|i| (name("", i), "m", i));
        let all: Vec<(String, &'static str, usize)> =
            places.chain((0..3 * n).map(|i| (name("v", i), "m/s", 3 * n + i))).collect();
        let curves: Vec<(String, &str, usize)> = match show {
            None => (0..n.min(HEIGHTS)).map(|i| all[3 * i + 2].clone()).collect(),
            Some(patterns) => {
                let names: Vec<&str> = all.iter().map(|c| c.0.as_str()).collect();
                let chosen = pattern::chosen(patterns, &names)?;
                all.iter().filter(|c| chosen.contains(&c.0.as_str())).cloned().collect()
            }
        };
        let recording = Recording::new(1 + curves.len() + ENERGIES.len() + ACCOUNTS.len());
        Ok(Self {
            curves,
            heights: show.is_none(),
            note: note.to_owned(),
            recording,
            pictures: Pictures::new(scene),
        })
    }

    /// Records a row.
    pub fn push(&mut self, row: &Row) {
        let [kinetic, gravity, spring, pressure] = row.energy.stored;
        let potential = gravity + spring + pressure;
        let state: Vec<f64> = row.pos.iter().chain(&row.vel).flatten().copied().collect();
        let curves = self.curves.iter().map(|c| state[c.2]);
        let energies = [pressure, spring, gravity, potential, kinetic, row.energy.total];
        let numbers: Vec<f64> =
            std::iter::once(row.t).chain(curves).chain(energies).chain(row.energy.accounts).collect();
        self.recording.push(&numbers);
        self.pictures.push(row);
    }

    /// The whole drawing: charts, then pictures.
    #[must_use]
    pub fn draw(&self, scene: &Scene, events: &[EventRecord]) -> Drawing {
        let mut drawing = self.charts(scene, events);
        let impacts = impact_curves(events);
        if !impacts.is_empty() {
            let panels = [Panel { label: "work [J]".to_owned(), curves: impacts }];
            let impulse = panels[0].curves.iter().flat_map(|c| c.across.clone().unwrap_or_default());
            let time: Vec<f64> = impulse.collect();
            let title = "Work over impulse: less in compression, given back in restitution";
            let (note, across) = ("", "impulse [N s]");
            let lower = Chart { title, note, across, time: &time, panels: &panels, events: &[] };
            chart::below(&mut drawing, chart::draw(&lower));
        }
        chart::below(&mut drawing, self.pictures.draw(scene));
        drawing
    }

    /// Heights or what was asked for, energies, and losses over time, with touches as events.
    fn charts(&self, scene: &Scene, events: &[EventRecord]) -> Drawing {
        let column = |name: &str, index: usize| {
            let values = self.recording.column(index);
            Curve { name: name.to_owned(), values, color: energies::color(name), across: None }
        };
        let curves = self.curves.iter().enumerate().map(|(n, (name, unit, _))| {
            let curve = column(name, 1 + n);
            Shown { curve, unit: (*unit).to_owned(), natural: 0.0 }
        });
        let first = 1 + self.curves.len();
        let energies = ENERGIES.iter().enumerate().map(|(n, name)| column(name, first + n));
        let first = first + ENERGIES.len();
        let accounts = ACCOUNTS.iter().enumerate().map(|(n, name)| column(name, first + n));
        // Accounts that stay 0 are left out.
        let told = |c: &Curve| c.values.iter().any(|x| *x != 0.0);
        let mut panels = panels::of(curves.collect(), ScalarKind::F64.noise());
        if self.heights {
            panels.iter_mut().for_each(|p| p.label = "height [m]".to_owned());
        }
        let energies = energies.filter(told).map(|curve| Shown { curve, unit: "J".to_owned(), natural: 0.0 });
        panels.extend(panels::of(energies.collect(), ScalarKind::F64.noise()));
        let accounts: Vec<Curve> = accounts.filter(told).collect();
        if !accounts.is_empty() {
            panels.push(Panel { label: "taken out [J]".to_owned(), curves: accounts });
        }
        let touches = events.iter().filter(|e| !e.touches.is_empty()).map(|e| e.time);
        let events: Vec<f64> = touches.collect();
        let note = match events.len() {
            0 => self.note.clone(),
            _ => format!("{}; grey: touches", self.note),
        };
        let (title, time) = (&scene.title, &self.recording.column(0));
        chart::draw(&Chart { title, note: &note, across: "time [s]", time, panels: &panels, events: &events })
    }
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
