//! Runs an image in the emulator, counts its instructions, and captures what it prints.

use super::chip::Chip;
use super::image::Image;
use super::process::{clean, run_limited, run_quietly};
use super::toolchain::Toolchain;
use crate::failure::Failure;
use std::fs;
use std::path::{Path, PathBuf};
use std::time::Duration;

/// Time limit of a run: 10,000 steps take seconds.
const TIME_LIMIT: Duration = Duration::from_secs(120);
/// Source of the plug-in, relative to the workspace.
const PLUGIN: &str = "host/src/firmware/plugin/lib.rs";

/// The cost of one function over all its calls, callees included.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Count {
    /// Its symbol.
    pub name: String,
    /// Number of calls.
    pub calls: u64,
    /// Fewest, median and most executed instructions of a call.
    pub instructions: [u64; 3],
    /// Cycles of the median call, as an interval of the model.
    pub cycles: [u64; 2],
    /// Largest number of cycles of any call, by the model.
    pub most_cycles: u64,
}

/// A run of the image.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Run {
    /// What the image printed.
    pub output: String,
    /// Executed instructions from reset to the end.
    pub instructions: u64,
    /// Counts of the functions asked for.
    pub counts: Vec<Count>,
}

/// Compiles the plug-in into `folder`.
///
/// # Errors
/// [`Failure::Lacking`] if rustc cannot build it.
pub fn plugin(toolchain: &Toolchain, workspace: &Path, folder: &Path) -> Result<PathBuf, Failure> {
    let (library, source) = (folder.join("libcount.so"), workspace.join(PLUGIN));
    let changed = |path: &Path| fs::metadata(path).and_then(|m| m.modified()).ok();
    if changed(&library).is_some_and(|built| changed(&source).is_some_and(|written| written < built)) {
        return Ok(library);
    }
    let mut rustc = clean(&toolchain.rustc);
    rustc.args(["-O", "--crate-type", "cdylib", "--crate-name", "count", "--edition", "2024"]);
    rustc.arg(source).arg("-o").arg(&library);
    run_quietly(&mut rustc).map_err(|log| {
        Failure::Lacking(format!("the emulator's plug-in does not build: run `apt-get install gcc`\n{log}"))
    })?;
    Ok(library)
}

/// Runs `elf` and counts the calls of the function `step`, and of those among `others` that are in the image.
///
/// # Errors
/// [`Failure::Wrong`] if the image has no such function, fails or hangs.
pub fn run(
    emulator: &Path,
    plugin: &Path,
    chip: &Chip,
    elf: &Path,
    image: &Image,
    (step, others): (&str, &[&str]),
) -> Result<Run, Failure> {
    let counts = elf.with_extension("counts");
    if image.find(step).is_none() {
        return Err(Failure::Wrong(format!("the image has no function `{step}`")));
    }
    let counted: Vec<&str> = [step].iter().chain(others).copied().collect();
    let option = count_option(plugin, &counts, image, &counted);
    let mut command = clean(emulator);
    command.args(["-M", chip.machine, "-nographic", "-monitor", "none", "-serial", "none"]);
    command.args(["-semihosting-config", "enable=on,target=native", "-plugin", &option, "-kernel"]).arg(elf);
    let output = run_limited(&mut command, TIME_LIMIT)
        .map_err(|e| Failure::Wrong(format!("the image fails in the emulator: {e}")))?;
    let (instructions, counts) = read_counts(&counts)?;
    Ok(Run { output, instructions, counts })
}

/// The emulator's option for counting the calls of those of these functions that are in the image.
#[must_use]
pub fn count_option(plugin: &Path, counts: &Path, image: &Image, names: &[&str]) -> String {
    let mut option = format!("{},out={}", plugin.display(), counts.display());
    for name in names {
        if let Some(function) = image.find(name) {
            option += &format!(",fn={name}@{}", image.functions[function].address);
        }
    }
    option
}

/// The plug-in's result: all instructions, and the counts of the functions.
///
/// # Errors
/// [`Failure::Wrong`] if it wrote no counts.
pub fn read_counts(counts: &Path) -> Result<(u64, Vec<Count>), Failure> {
    let text = fs::read_to_string(counts)
        .map_err(|e| Failure::Wrong(format!("the plug-in wrote no counts to {}: {e}", counts.display())))?;
    parse(&text).ok_or_else(|| Failure::Wrong(format!("the plug-in's counts are not readable:\n{text}")))
}

/// Total and counts from the plug-in's text.
fn parse(text: &str) -> Option<(u64, Vec<Count>)> {
    let mut total = None;
    let mut counts = Vec::new();
    for line in text.lines() {
        let (name, numbers) = line.split_once(' ')?;
        let numbers: Vec<u64> = numbers.split(' ').map(str::parse).collect::<Result<_, _>>().ok()?;
        match (name, numbers.as_slice()) {
            ("total", [instructions, _, _]) => total = Some(*instructions),
            (_, &[calls, min, median, max, low, high, most_cycles]) => counts.push(Count {
                name: name.to_owned(),
                calls,
                instructions: [min, median, max],
                cycles: [low, high],
                most_cycles,
            }),
            _ => return None,
        }
    }
    Some((total?, counts))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn counts_are_read() {
        let (total, counts) = parse("total 10 11 12\ntile_step 2 3 4 5 6 7 8\n").unwrap();
        assert_eq!(total, 10);
        assert_eq!(counts[0].calls, 2);
        assert_eq!(counts[0].instructions, [3, 4, 5]);
        assert_eq!(counts[0].cycles, [6, 7]);
        assert_eq!(counts[0].most_cycles, 8);
        assert_eq!(parse("tile_step 1\n"), None);
    }
}
