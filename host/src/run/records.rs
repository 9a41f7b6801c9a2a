//! Where each row of a running world goes: files, plot and page, and what the summary says of the rows.

use super::accounts::{Closed, Rows};
use super::arguments::Arguments;
use super::health::{Energies as Moved, Health, Range};
use super::outcome::{ended_early, line};
use super::rows::{drawing, names, shown, told, values};
use super::settings;
use crate::engine::ScalarKind;
use crate::failure::Failure;
use crate::number::worst;
use crate::output::Output;
use crate::plot::{self, Recording, chart, panels};
use crate::view::film::{Film, Series};
use crate::view::side::Sides;
use crate::view::world as stage;
use crate::world::assembly::{Assembly, Kind, Part};
use crate::world::engine::{ACCOUNTS, Column, Engine, Event};
use crate::world::run::Row;
use crate::{csv, interrupt};
use std::collections::BTreeMap;

/// What takes the rows of a run.
pub(super) struct Records<'a> {
    arguments: &'a Arguments,
    assembly: &'a Assembly,
    columns: Vec<Column>,
    shown: Vec<usize>,
    csv: Option<Output>,
    accounts: Option<Rows>,
    recording: Option<Recording>,
    sides: Option<Sides>,
    film: Option<Film>,
    kept: Kept,
}

/// What remains of the rows when a run has ended.
pub(super) struct Kept {
    /// Names of a row's values.
    pub(super) names: Vec<String>,
    /// The last row.
    pub(super) last: Vec<f64>,
    pub(super) rows: u64,
    /// The largest imbalance of the ledger (J).
    pub(super) imbalance: f64,
    /// Total energy at the start and at the end (J).
    pub(super) total: [f64; 2],
    pub(super) health: Health,
    /// The values of the state that have ranges.
    ranged: Vec<usize>,
    pub(super) accounts: Option<Closed>,
}

impl<'a> Records<'a> {
    /// Files are opened with the first row: what is refused before it leaves those of an earlier run as they are.
    ///
    /// # Errors
    /// If `--show` names no column.
    pub(super) fn open(
        arguments: &'a Arguments,
        assembly: &'a Assembly,
        columns: Vec<Column>,
    ) -> Result<Self, Failure> {
        let names = names(assembly, &columns);
        let shown = shown(&columns, arguments.show.as_deref())?;
        let ranges = ranges(assembly);
        let ranged = (0..columns.len()).filter(|place| ranges.contains_key(&columns[*place].name)).collect();
        let epsilon = match arguments.scalar {
            ScalarKind::F64 => f64::EPSILON,
            ScalarKind::F32 => f64::from(f32::EPSILON),
        };
        Ok(Self {
            arguments,
            assembly,
            shown,
            csv: None,
            accounts: None,
            recording: arguments.plot.as_ref().map(|_| Recording::new(names.len())),
            sides: arguments.plot.as_ref().map(|_| Sides::new(stage::stage(assembly))),
            film: arguments.view.as_ref().map(|_| Film::new(stage::stage(assembly), series(&columns))),
            columns,
            kept: Kept {
                names,
                last: Vec::new(),
                rows: 0,
                imbalance: 0.0,
                total: [f64::NAN; 2],
                health: Health::new(ranges, epsilon),
                ranged,
                accounts: None,
            },
        })
    }

    /// Opens the files.
    fn begin(&mut self, engine: &mut dyn Engine) -> Result<(), Failure> {
        self.kept.health.differences_of(engine.largest_term());
        let parts_touch = !self.assembly.contacts.is_empty();
        self.kept.health.rounded_by(self.assembly.run.steps(), parts_touch);
        let csv_file = self.arguments.csv.as_deref();
        let open = |file: &str| Rows::open(file, csv_file, engine);
        self.accounts = self.arguments.accounts.as_deref().map(open).transpose()?;
        self.csv = csv_file.map(Output::open).transpose()?;
        if let Some(csv) = &mut self.csv {
            csv.write(&csv::header(&self.kept.names))?;
            interrupt::watch();
        }
        Ok(())
    }

    /// Takes a row.
    ///
    /// # Errors
    /// If a file cannot be created or the row not be written, or the engine has no picture or accounts of its state.
    pub(super) fn push(&mut self, row: &Row<'_>, engine: &mut dyn Engine) -> Result<(), Failure> {
        if self.kept.rows == 0 {
            self.begin(engine)?;
        }
        let values = values(row);
        if !row.energies.total().is_finite() {
            let t = row.t;
            let why = "a speed, a length or a mass is too large";
            return Err(Failure::Wrong(format!("t = {t:.6} s: the energy is not finite; {why}")));
        }
        if let Some(csv) = &mut self.csv {
            csv.write(&line(&values))?;
        }
        if let Some(accounts) = &mut self.accounts {
            accounts.push(row.t, engine)?;
        }
        if let Some(recording) = &mut self.recording {
            recording.push(&values);
        }
        let is_drawn = self.sides.as_ref().is_some_and(|sides| sides.wants(row.events > 0, row.is_last));
        if is_drawn || self.film.is_some() {
            self.show(row, engine, is_drawn)?;
        }
        self.kept.count(row, &self.columns);
        self.kept.last = values;
        Ok(())
    }

    /// Adds a picture of the row to the page, and to the plot if it `is_drawn` there.
    /// Pictures cost time, and most rows of a plot are not drawn.
    fn show(&mut self, row: &Row<'_>, engine: &mut dyn Engine, is_drawn: bool) -> Result<(), Failure> {
        let picture = engine.picture().map_err(Failure::Wrong)?;
        let places = stage::places(&picture, self.assembly);
        if let Some(film) = &mut self.film {
            let curves = self.columns.iter().zip(row.state).filter(|(c, _)| c.by_default).map(|(_, x)| *x);
            let curves: Vec<f64> = curves.chain(row.energies.numbers(row.start)).collect();
            film.push(row.t, &places, &picture.forces, curves);
        }
        if let Some(sides) = self.sides.as_mut().filter(|_| is_drawn) {
            sides.push(row.t, places, row.events > 0);
        }
        Ok(())
    }

    /// Total energy at the start (J).
    pub(super) fn start(&self) -> f64 {
        self.kept.total[0]
    }

    /// What is told of a run that ended early; completes the file of its rows.
    pub(super) fn ended_early(self, failure: Failure, csv_file: Option<&str>) -> Failure {
        ended_early(failure, self.csv, self.kept.rows, csv_file.unwrap_or_default())
    }

    /// Completes files and plot; returns what remains, and the data of the page.
    ///
    /// # Errors
    /// If something cannot be written.
    pub(super) fn finish(
        self,
        arguments: &Arguments,
        note: &str,
        events: &[Event],
    ) -> Result<(Kept, Option<String>), Failure> {
        let Self { assembly, columns, shown, csv, accounts, recording, sides, film, mut kept, .. } = self;
        csv.map_or(Ok(()), Output::finish)?;
        kept.accounts = accounts.map(Rows::finish).transpose()?;
        if let (Some(file), Some(recording)) = (&arguments.plot, &recording) {
            let mut drawing = drawing(assembly, &columns, &shown, recording, note, events);
            if let Some(lower) = sides.and_then(|sides| sides.draw()) {
                chart::below(&mut drawing, lower);
            }
            plot::write(file, &drawing)?;
        }
        let film = film.map(|film| film.data(&assembly.title, note, &told(events, assembly)));
        Ok((kept, film))
    }
}

impl Kept {
    /// Counts a row; judges its energies.
    fn count(&mut self, row: &Row<'_>, columns: &[Column]) {
        let energies = row.energies;
        let imbalance = energies.imbalance(row.start);
        self.rows += 1;
        self.total = [row.start, energies.total()];
        self.imbalance = worst(self.imbalance, imbalance);
        let stored = [energies.kinetic, energies.gravity, energies.spring, energies.pressure];
        let change = self.total[1] - self.total[0];
        let [damping, drag, friction] = [energies.damping, energies.drag, energies.friction];
        let moved = [damping, drag, energies.impact, friction, energies.actuator, change];
        for &place in &self.ranged {
            self.health.place(&columns[place].name, row.state[place], row.t);
        }
        self.health.energies(Moved { stored: &stored, moved: &moved, imbalance });
        self.health.taken(energies.impact + friction);
    }
}

/// Ranges that the models of the mechanisms declare, by column; those of angles count modulo whole turns.
fn ranges(assembly: &Assembly) -> BTreeMap<String, Range> {
    let of = |part: &Part| match &part.kind {
        Kind::Mechanism(mechanism) => settings::ranges(&mechanism.model),
        _ => BTreeMap::new(),
    };
    let named = |part: &Part| {
        let name = part.name.clone();
        of(part).into_iter().map(move |(own, range)| {
            let is_angle = range.unit.0 == "rad" || range.unit.0 == "deg";
            (format!("{name}.{own}"), Range { is_angle, ..range })
        })
    };
    assembly.parts.iter().flat_map(named).collect()
}

/// Curves that the page shows beside the motion, in the order of [`values`].
fn series(columns: &[Column]) -> Vec<Series> {
    let own = columns.iter().filter(|c| c.by_default).map(|c| (c.name.clone(), panels::label(&c.unit)));
    let accounts = ACCOUNTS.iter().map(|name| {
        let is_account = ["damping", "drag", "impact", "friction", "actuator", "imbalance"].contains(name);
        ((*name).to_owned(), if is_account { "ledger".to_owned() } else { panels::label("J") })
    });
    own.chain(accounts).map(|(name, group)| Series { name, group, factor: 1.0 }).collect()
}
