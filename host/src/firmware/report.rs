//! The results of `smartbed firmware`, as text and as JSON.

use super::chip::STM32F405;
use super::emulator::{Count, Run};
use super::equations::Equations;
use super::fit::RAM;
use super::image::Image;
use super::image::rules::{Finding, Rule};
use super::image::size::Size;
use super::image::stack::Stack;
use super::settings::{RATES, SIN_COS, Settings, Subject};
use super::toolchain::Toolchain;
use crate::failure::Failure;
use serde_json::{Value, json};
use smartbed_codegen::words::count;
use std::path::{Path, PathBuf};

/// The results.
#[derive(Clone, PartialEq, Debug)]
pub struct Report {
    /// Settings of the build.
    pub settings: Settings,
    /// Description of the toolchain.
    pub toolchain: String,
    /// The image.
    pub elf: PathBuf,
    /// Bytes of flash and static RAM.
    pub size: Size,
    /// Stack bound.
    pub stack: Stack,
    /// Broken rules; if there are any, the image is not run.
    pub findings: Vec<Finding>,
    /// Results of the run.
    pub run: Option<Outcome>,
}

/// Results of running the image.
#[derive(Clone, PartialEq, Debug)]
pub struct Outcome {
    /// Digest of the chip's trajectory.
    pub digest: String,
    /// Digest of the host's trajectory, if it was run.
    pub host_digest: Option<String>,
    /// The last state of a mechanism on the host: coordinates, then independent speeds.
    pub state: Vec<f32>,
    /// Instructions from reset to the end.
    pub instructions: u64,
    /// Cost of a step.
    pub step: Count,
    /// Cost of an evaluation of a mechanism's rates; `None` for a scene.
    pub rates: Option<Count>,
    /// Cost of the mechanism's equations; `None` for a scene.
    pub equations: Option<Equations>,
}

impl Report {
    /// The report of an image that has not run.
    #[must_use]
    pub fn new(
        toolchain: &Toolchain,
        settings: &Settings,
        elf: &Path,
        image: &Image,
        stack: Stack,
        findings: Vec<Finding>,
    ) -> Self {
        Self {
            settings: settings.clone(),
            toolchain: toolchain.describe(),
            elf: elf.to_owned(),
            size: image.size,
            stack,
            findings,
            run: None,
        }
    }

    /// Adds a run in the emulator and what the host's simulation printed, if it was run.
    ///
    /// # Errors
    /// [`Failure::Wrong`] if either printed no digest or the counts are not one per step.
    pub fn add_run(&mut self, run: &Run, host: Option<&str>, image: &Image) -> Result<(), Failure> {
        let Some((step, rest)) = run.counts.split_first() else {
            return Err(Failure::Wrong("the plug-in counted nothing".to_owned()));
        };
        let find = |name: &str| rest.iter().find(|count| count.name == name);
        let (steps, rates) = (u64::from(self.settings.steps), find(RATES));
        if step.calls != steps || rates.is_some_and(|r| r.calls == 0) {
            let evaluations = rates.map_or(0, |r| r.calls);
            return Err(Failure::Wrong(format!(
                "{steps} steps, but {} calls of a step and {evaluations} of the rates were counted",
                step.calls
            )));
        }
        let equations = match (rates, find(SIN_COS)) {
            (Some(rates), Some(sin_cos)) => Some(Equations::new(&self.settings, image, rates, sin_cos)?),
            _ => None,
        };
        self.run = Some(Outcome {
            digest: digest(&run.output)?,
            host_digest: host.map(digest).transpose()?,
            state: host.map(state).unwrap_or_default(),
            instructions: run.instructions,
            step: step.clone(),
            rates: rates.cloned(),
            equations,
        });
        Ok(())
    }

    /// Why the image is refused; empty if it is not.
    #[must_use]
    pub fn failures(&self) -> Vec<String> {
        let mut failures: Vec<String> = self.findings.iter().map(Finding::to_string).collect();
        let digests = self.run.as_ref().and_then(|run| Some((&run.digest, run.host_digest.as_ref()?)));
        if let Some((chip, host)) = digests.filter(|(chip, host)| chip != host) {
            failures.push(format!("trajectory: the chip's digest {chip} differs from the host's {host}"));
        }
        failures
    }

    /// Least and largest time of a step by the cycle model, relative to its length.
    fn real_time(&self, run: &Outcome) -> [f64; 2] {
        let length = self.settings.step as f64 * 1e-9;
        run.step.cycles.map(|cycles| cycles as f64 / STM32F405.clock as f64 / length)
    }

    /// The report as text.
    #[must_use]
    pub fn text(&self) -> String {
        let mut lines = self.image_lines();
        lines.extend(self.subject_line());
        if let Some(run) = &self.run {
            lines.extend(self.run_lines(run));
            lines.extend(run.equations.iter().flat_map(equation_lines));
        }
        lines.extend(Rule::ALL.map(|rule| {
            let broken = self.findings.iter().filter(|f| f.rule == rule).count();
            let found = if broken == 0 { "ok".to_owned() } else { format!("FAILED ({broken})") };
            line(&format!("check {}", rule.name()), found)
        }));
        lines.concat()
    }

    /// What the image is, and what it takes.
    fn image_lines(&self) -> Vec<String> {
        let chip = &STM32F405;
        let path: Vec<String> =
            self.stack.path.iter().map(|(name, frame)| format!("{name} {frame}")).collect();
        let mut lines = vec![
            line("model", self.settings.model.display().to_string()),
            line("toolchain", self.toolchain.clone()),
            line("image", self.elf.display().to_string()),
            line("chip", format!("{} at {} MHz", chip.name, chip.clock / 1_000_000)),
            line("flash", format!("{} of {} bytes", self.size.flash, chip.flash)),
            line("static RAM", format!("{} of {} bytes", self.size.ram, chip.ram)),
            line(
                "stack bound",
                format!("{} bytes, an exception of each priority included", self.stack.bytes),
            ),
            line("  deepest path", path.join(" > ")),
        ];
        if let Subject::World(world) = &self.settings.subject {
            let sheets = world.rows.map_or(String::new(), |rows| {
                format!(
                    ", in sheets of {rows} x {rows}: the finest that fit into {} KB of RAM; `mass` is that of a node, `K` of a spring",
                    RAM / 1024
                )
            });
            lines.push(line("nodes", format!("{}{sheets}", world.demand.nodes)));
            if world.demand.contacts() > 0 {
                lines.push(line("contacts", format!("room for {} at once", world.demand.contacts())));
            }
        }
        lines
    }

    /// How exact a reduced body at rest is.
    fn subject_line(&self) -> Option<String> {
        let Subject::Rest(found, _) = &self.settings.subject else { return None };
        let ([low, high], [off, behind]) = (found.range, found.errors);
        let terms = count(found.volume.len(), "term");
        Some(line(
            "at rest",
            format!(
                "{low} to {high} Pa and back: {terms}, error {off:.1e} of the displacement against equilibria, \
                 {behind:.1e} against the moving sheet"
            ),
        ))
    }

    /// What a run in the emulator gave, and what it cost.
    fn run_lines(&self, run: &Outcome) -> Vec<String> {
        let compared = match &run.host_digest {
            None => "not run".to_owned(),
            Some(host) if *host == run.digest => "the same, bit for bit".to_owned(),
            Some(host) => format!("DIFFERS: {host}"),
        };
        let [low, high] = self.real_time(run);
        let fits = if high <= 1.0 { "within real time" } else { "not within real time" };
        let length = self.settings.step as f64 * 1e-3;
        let mut lines = vec![
            line("trajectory", format!("{}, digest {}", count(self.settings.steps, "step"), run.digest)),
            line("  on the host", compared),
            line(
                "real time",
                format!("{fits}: a step of {length} us takes {low:.2}..{high:.2} of it by cycle model"),
            ),
        ];
        let counts = [("step", Some(&run.step)), ("rates", run.rates.as_ref())];
        for (name, counted) in counts.into_iter().filter_map(|(name, counted)| Some((name, counted?))) {
            let ([min, median, max], [low, high]) = (counted.instructions, counted.cycles);
            let calls = count(counted.calls, "call");
            let instructions =
                format!("{min} / {median} / {max} instructions (min / median / max of {calls})");
            let micro = |cycles: u64| cycles as f64 * 1e6 / STM32F405.clock as f64;
            let ([least, longest], most) = ([low, high].map(micro), counted.most_cycles);
            let cycles =
                format!("{low}..{high} cycles ({least:.1}..{longest:.1} us), never more than {most}");
            lines.extend([line(name, instructions), line("  by cycle model", cycles)]);
        }
        lines
    }

    /// The report as one JSON object.
    #[must_use]
    pub fn json(&self) -> String {
        let count = |count: &Count| {
            json!({
                "calls": count.calls,
                "instructions": { "min": count.instructions[0], "median": count.instructions[1], "max": count.instructions[2] },
                "cycles": { "low": count.cycles[0], "high": count.cycles[1], "most": count.most_cycles },
            })
        };
        let checks: serde_json::Map<String, Value> = Rule::ALL
            .iter()
            .map(|rule| (rule.name().to_owned(), json!(self.findings.iter().all(|f| f.rule != *rule))))
            .collect();
        let findings: Vec<Value> = self
            .findings
            .iter()
            .map(|f| json!({ "check": f.rule.name(), "what": f.what, "reason": f.rule.reason() }))
            .collect();
        let run = self.run.as_ref().map(|run| {
            json!({
                "digest": run.digest,
                "host_digest": run.host_digest,
                "state": run.state,
                "instructions": run.instructions,
                "real_time": self.real_time(run),
                "step": count(&run.step),
                "rates": run.rates.as_ref().map(count),
                "equations": run.equations.as_ref().map(|equations| json!({
                    "operations": equations.operations,
                    "angles": equations.angles,
                    "sin_cos": equations.sin_cos,
                    "apart": equations.apart,
                    "by_operation": equations.by_operation(),
                    "by_operation_with_constants": equations.by_operation_with_constants(),
                    "bytes": equations.bytes,
                })),
            })
        });
        let world = if let Subject::World(world) = &self.settings.subject { Some(world) } else { None };
        let rest =
            if let Subject::Rest(found, _) = &self.settings.subject { Some(found.errors) } else { None };
        let report = json!({
            "model": self.settings.model,
            "set": self.settings.set,
            "steps": self.settings.steps,
            "toolchain": self.toolchain,
            "image": self.elf,
            "chip": STM32F405.name,
            "flash": self.size.flash,
            "ram": self.size.ram,
            "stack": { "bytes": self.stack.bytes, "path": self.stack.path },
            "nodes": world.map(|world| world.demand.nodes),
            "rows": world.and_then(|world| world.rows),
            "rest_errors": rest,
            "checks": checks,
            "findings": findings,
            "run": run,
        });
        format!("{report:#}\n")
    }
}

/// A name and its value, aligned.
fn line(name: &str, value: String) -> String {
    format!("{name:<32}{value}\n")
}

/// What an evaluation of the equations costs.
fn equation_lines(equations: &Equations) -> [String; 3] {
    let Equations { operations, angles, sin_cos, apart, bytes, .. } = equations;
    let (ratio, strict) = (equations.by_operation(), equations.by_operation_with_constants());
    let for_each =
        format!("{ratio:.2} for each of {operations} operations ({strict:.2} with their constants)");
    [
        line("  sines and cosines apart", format!("{apart} instructions, {for_each}")),
        line("sine and cosine", format!("{sin_cos} instructions an angle, {angles} angles")),
        line("rates, projection, energy", format!("{bytes} bytes of code")),
    ]
}

/// The report of an image that was built elsewhere.
pub fn of_image(elf: &Path, image: &Image, stack: &Stack, findings: &[Finding], as_json: bool) -> String {
    let kept = |rule: &Rule| findings.iter().all(|finding| finding.rule != *rule);
    if as_json {
        let checks: serde_json::Map<String, Value> =
            Rule::ALL.iter().map(|rule| (rule.name().to_owned(), json!(kept(rule)))).collect();
        let report = json!({
            "image": elf,
            "flash": image.size.flash,
            "ram": image.size.ram,
            "stack": { "bytes": stack.bytes, "path": stack.path },
            "checks": checks,
            "findings": findings.iter().map(ToString::to_string).collect::<Vec<_>>(),
        });
        return format!("{report:#}\n");
    }
    let path: Vec<String> = stack.path.iter().map(|(name, frame)| format!("{name} {frame}")).collect();
    let mut lines = vec![
        ("image".to_owned(), elf.display().to_string()),
        ("flash".to_owned(), format!("{} bytes", image.size.flash)),
        ("static RAM".to_owned(), format!("{} bytes", image.size.ram)),
        ("stack bound".to_owned(), format!("{} bytes, one exception included", stack.bytes)),
        ("  deepest path".to_owned(), path.join(" > ")),
    ];
    for rule in Rule::ALL {
        let judged = if kept(&rule) { "ok" } else { "FAILED" };
        lines.push((format!("check {}", rule.name()), judged.to_owned()));
    }
    lines.into_iter().map(|(name, value)| format!("{name:<32}{value}\n")).collect()
}

/// The digest in the output of a simulation.
fn digest(output: &str) -> Result<String, Failure> {
    let found = output.lines().find_map(|l| l.strip_prefix("digest "));
    found
        .map(str::to_owned)
        .ok_or_else(|| Failure::Wrong(format!("expected a line `digest ...`, got `{output}`")))
}

/// The last state in the output of a mechanism's simulation; empty for a scene.
fn state(output: &str) -> Vec<f32> {
    let line = output.lines().find_map(|line| line.strip_prefix("state"));
    line.into_iter().flat_map(str::split_whitespace).filter_map(|number| number.parse().ok()).collect()
}
