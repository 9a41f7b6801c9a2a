//! The files of a report: names and places.
//!
//! In: a report, a folder. Out: its renderings in that folder, or a summary named after the processor.

use super::point::Report;
use super::{csv, front, json, markdown, page, work_precision};
use crate::failure::Failure;
use crate::output;
use crate::plot::svg;
use std::path::Path;

/// Refuses a folder that cannot be made, before anything is measured for it.
///
/// # Errors
/// [`Failure::Wrong`] names what is in the way.
pub fn check(folder: &Path) -> Result<(), Failure> {
    let folder = Path::new(".").join(folder);
    let Some(there) = folder.ancestors().find(|part| part.exists()) else { return Ok(()) };
    let why = match there.metadata() {
        Ok(there) if !there.is_dir() => "is not a folder",
        Ok(there) if there.permissions().readonly() => "may not be written to",
        _ => return Ok(()),
    };
    Err(Failure::Wrong(format!(
        "cannot write the report to {}: {} {why}; name another folder",
        folder.display(),
        there.display()
    )))
}

/// Writes all files into a folder.
///
/// # Errors
/// [`Failure::Wrong`] if one cannot be written.
pub fn write(report: &Report, folder: &Path) -> Result<(), Failure> {
    let wrong = |e: std::io::Error| Failure::Wrong(format!("{}: {e}", folder.display()));
    std::fs::create_dir_all(folder.join("plots")).map_err(wrong)?;
    let put =
        |name: &str, text: &str| output::write(&folder.join(name).display().to_string(), text.as_bytes());
    put("report.md", &markdown::text(report))?;
    put("report.csv", &csv::text(report))?;
    put("report.json", &json::text(report))?;
    put("report.html", &page::text(report))?;
    let plots = plot_names(report.sections.iter().map(|s| s.name.as_str()));
    for (n, section) in report.sections.iter().enumerate() {
        if let Some(drawing) = work_precision::draw(section, work_precision::COSTS[0]) {
            put(&format!("plots/{}.svg", plots[n]), &svg::text(&drawing))?;
        }
    }
    Ok(())
}

/// Names of the plots' files, made unique: subjects may be named by paths, two of which may end alike.
fn plot_names<'a>(subjects: impl Iterator<Item = &'a str>) -> Vec<String> {
    let mut names: Vec<String> = Vec::new();
    for subject in subjects {
        let stem = Path::new(subject).file_stem().map_or_else(|| "plot".into(), |s| s.to_string_lossy());
        let plain = |c: char| if c.is_alphanumeric() || c == '_' || c == '-' { c } else { '_' };
        let name: String = stem.chars().map(plain).collect();
        let mut numbered = name.clone();
        for n in 2.. {
            if !names.contains(&numbered) {
                break;
            }
            numbered = format!("{name}-{n}");
        }
        names.push(numbered);
    }
    names
}

/// Writes the summary, the points of our own fronts and all those of other simulators, to files named after the
/// processor.
///
/// # Errors
/// [`Failure::Wrong`] if one cannot be written.
pub fn write_results(report: &Report, folder: &Path) -> Result<(), Failure> {
    let wrong = |e: std::io::Error| Failure::Wrong(format!("{}: {e}", folder.display()));
    std::fs::create_dir_all(folder).map_err(wrong)?;
    let mut fronts = report.clone();
    // Our points that only a peer dominates are kept, so that the file shows them.
    fronts.sections.iter_mut().for_each(|section| {
        let ours: Vec<_> = section.points.iter().filter(|p| !p.is_peer).cloned().collect();
        section.points.retain(|p| p.is_peer || !ours.iter().any(|own| front::dominates(own, p)));
    });
    let put = |ending: &str, text: &str| {
        let file = folder.join(file_name(&report.machine)).with_extension(ending);
        output::write(&file.display().to_string(), text.as_bytes())
    };
    put("md", &markdown::results(report))?;
    put("json", &json::text(&fronts))
}

/// The name in lower case, without parts in brackets, words joined by hyphens.
fn file_name(machine: &str) -> String {
    let mut depth = 0_usize;
    let plain = machine.chars().filter(|c| {
        depth = if *c == '(' { depth + 1 } else { depth };
        let outside = depth == 0;
        depth = if *c == ')' { depth.saturating_sub(1) } else { depth };
        outside
    });
    let text: String =
        plain.map(|c| if c.is_ascii_alphanumeric() { c.to_ascii_lowercase() } else { ' ' }).collect();
    text.split_whitespace().collect::<Vec<_>>().join("-")
}

/// The processor's name.
#[must_use]
pub fn machine() -> String {
    let text = std::fs::read_to_string("/proc/cpuinfo").unwrap_or_default();
    let name = text.lines().find_map(|l| l.strip_prefix("model name")?.split_once(':'));
    name.map_or_else(|| std::env::consts::ARCH.to_owned(), |(_, name)| name.trim().to_owned())
}

#[cfg(test)]
mod tests {
    use super::{file_name, plot_names};

    #[test]
    fn plots_stay_in_their_folder() {
        let subjects = ["tile", "../../tile.toml", "/tmp/a b.toml", "..", "sub/tile"];
        assert_eq!(plot_names(subjects.into_iter()), ["tile", "tile-2", "a_b", "plot", "tile-3"]);
    }

    #[test]
    fn a_processor_is_a_file_name() {
        assert_eq!(file_name("Intel(R) Xeon(R) Processor @ 2.10GHz"), "intel-xeon-processor-2-10ghz");
    }
}
