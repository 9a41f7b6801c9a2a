//! Costs on the chip: an image of a subject in f32 is built, checked and run in the emulator, as
//! `smartbed firmware` does (without comparing it with the host, which tests do); a step's instructions are
//! counted and its cycles modelled.

use super::point::{ChipCost, Section};
use super::sheet::Variant;
use super::subject::{Kind, Subject};
use crate::failure::Failure;
use crate::firmware;
use std::time::{Duration, Instant};

/// Steps run by an image.
const STEPS: u32 = 200;

/// Measures costs on the chip, as long as tools and time allow.
#[derive(Clone, PartialEq, Debug)]
pub struct Chip {
    end: Instant,
    lacking: Option<String>,
}

impl Chip {
    /// Images are built for at most this long.
    #[must_use]
    pub fn new(time: Duration) -> Self {
        Self { end: Instant::now() + time, lacking: None }
    }

    /// Measures nothing, for this reason.
    #[must_use]
    pub fn none(why: &str) -> Self {
        Self { end: Instant::now(), lacking: Some(why.to_owned()) }
    }

    /// The reason, if nothing can be measured any more.
    #[must_use]
    pub fn lacking(&self) -> Option<&str> {
        self.lacking.as_deref()
    }

    /// Builds and runs an image.
    ///
    /// # Errors
    /// A message if it could not be done.
    pub fn measure(&mut self, name: &str, method: &str, variant: &Variant) -> Result<ChipCost, String> {
        if let Some(why) = &self.lacking {
            return Err(why.clone());
        }
        if Instant::now() > self.end {
            self.lacking = Some("the time limit for building images had passed".to_owned());
        }
        let arguments = firmware::Arguments {
            model: Some(name.to_owned()),
            steps: Some(STEPS),
            set: variant.set.clone(),
            everything: variant.everything,
            ..firmware::Arguments::default()
        };
        let report = firmware::cost(&arguments).map_err(|failure| {
            if let Failure::Lacking(why) = &failure {
                self.lacking = Some(why.clone());
            }
            failure.to_string()
        })?;
        let broken = || report.failures().first().cloned().unwrap_or_default();
        let run = report.run.as_ref().ok_or_else(|| format!("the image breaks a rule: {}", broken()))?;
        let mut changes: String = variant.set.iter().map(|s| format!(" --set '{s}'")).collect();
        changes += if variant.everything { " --everything" } else { "" };
        Ok(ChipCost {
            method: method.to_owned(),
            instructions: run.step.instructions[1],
            cycles: run.step.cycles,
            flash: report.size.flash,
            ram: report.size.ram,
            stack: u64::from(report.stack.bytes),
            command: format!("cargo smartbed firmware {name} --steps {STEPS}{changes}"),
        })
    }

    /// Fills in the sections' costs: every method of fixed step for a scene; rk4 at 1 ms for a mechanism. Goes method
    /// by method over all subjects, so that every subject has some when time runs out.
    pub fn add(&mut self, subjects: &[Box<dyn Subject>], sections: &mut [Section]) {
        let methods: Vec<Vec<String>> = subjects.iter().map(|s| methods(s.as_ref())).collect();
        for n in 0..methods.iter().map(Vec::len).max().unwrap_or(0) {
            for ((subject, section), methods) in subjects.iter().zip(&mut *sections).zip(&methods) {
                let Some(method) = methods.get(n) else { continue };
                let is_body = subject.kind() == Kind::Body;
                let set = if is_body { vec![format!("method={method}")] } else { Vec::new() };
                match self.measure(subject.name(), method, &Variant { set, everything: false }) {
                    Ok(cost) => section.chip.push(cost),
                    // A lack of tools is stated once, at the head of the report.
                    Err(_) if self.lacking.is_some() => return,
                    Err(why) => section.notes.push(format!("{method} on the chip: {}", first_line(&why))),
                }
            }
        }
    }
}

/// The methods for which an image can be built.
fn methods(subject: &dyn Subject) -> Vec<String> {
    match subject.kind() {
        Kind::Body => subject.methods().into_iter().filter(|m| !m.adaptive).map(|m| m.name).collect(),
        Kind::Mechanism => vec!["rk4".to_owned()],
        // Its image would have as many nodes as fit into the memory: a different world from the one measured.
        Kind::World => Vec::new(),
    }
}

fn first_line(text: &str) -> &str {
    text.lines().next().unwrap_or_default()
}
