//! `smartbed view --still`: a picture of the page at one time, taken by a browser in headless mode.

use crate::failure::Failure;
use crate::firmware::process::which;
use crate::{install, output};
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

/// Names under which distributions install the browser.
const NAMES: [&str; 4] = ["chromium", "chromium-browser", "google-chrome", "google-chrome-stable"];
/// Size of the picture (pixels).
const SIZE: [usize; 2] = [1280, 900];

/// Checks that the file's name ends in `.png`.
///
/// # Errors
/// [`Failure::Wrong`] if not.
pub fn check(file: &str) -> Result<(), Failure> {
    if file.to_ascii_lowercase().ends_with(".png") {
        return Ok(());
    }
    Err(Failure::Wrong(format!("--still {file}: expected a name that ends in .png")))
}

/// Parses a time such as `t=0.5`.
///
/// # Errors
/// [`Failure::Wrong`] for anything else.
pub fn time(text: &str) -> Result<f64, Failure> {
    let number = text.strip_prefix("t=").and_then(|t| t.parse().ok());
    number.filter(|t: &f64| t.is_finite() && *t >= 0.0).ok_or_else(|| {
        Failure::Wrong(format!("--still {text}: expected a time of 0 or more, for example t=0.5"))
    })
}

/// The time that a still shows: of the moments that the page keeps the one nearest to the time asked for. Places
/// between two of them are nobody's: a ball that bounced there would hang in the air.
///
/// # Errors
/// [`Failure::Wrong`] for a time after the last of them.
pub fn shown(data: &str, time: f64) -> Result<f64, Failure> {
    let data: serde_json::Value = serde_json::from_str(data).unwrap_or_default();
    let times: Vec<f64> =
        data["times"].as_array().into_iter().flatten().filter_map(serde_json::Value::as_f64).collect();
    let end = times.last().copied().unwrap_or_default();
    // The end of a run may be below its length by rounding.
    if time > end * (1.0 + 1e-9) {
        return Err(Failure::Wrong(format!(
            "--still t={time}: the run ends at {end} s; expected a time up to there, or a longer run: --seconds {time}"
        )));
    }
    let apart = |t: &f64| (t - time).abs();
    Ok(times.into_iter().min_by(|a, b| apart(a).total_cmp(&apart(b))).unwrap_or_default())
}

/// Opens the page at a time, and writes a picture of it.
///
/// # Errors
/// [`Failure::Wrong`] if the file cannot be written; [`Failure::Lacking`] without a browser.
pub fn take(page: &str, time: f64, file: &str) -> Result<(), Failure> {
    let browser = browser()?;
    let folder = std::env::temp_dir().join(format!("smartbed-still-{}", std::process::id()));
    let wrong = |e: std::io::Error| Failure::Wrong(format!("{}: {e}", folder.display()));
    std::fs::create_dir_all(&folder).map_err(wrong)?;
    let (html, png) = (folder.join("page.html"), folder.join("still.png"));
    std::fs::write(&html, page).map_err(wrong)?;
    let status = Command::new(browser)
        .args([
            "--headless",
            "--no-sandbox",
            "--disable-gpu",
            "--enable-unsafe-swiftshader",
            "--hide-scrollbars",
        ])
        .args(["--no-first-run", "--disable-background-networking", "--virtual-time-budget=4000"])
        .arg(format!("--window-size={},{}", SIZE[0], SIZE[1]))
        .arg(format!("--user-data-dir={}", folder.join("profile").display()))
        .arg(format!("--screenshot={}", png.display()))
        .arg(format!("file://{}#t={time},still", html.display()))
        .stdin(Stdio::null())
        .stdout(Stdio::null())
        .stderr(Stdio::null())
        .status()
        .map_err(wrong)?;
    let picture = std::fs::read(&png);
    // The browser's child processes may still be writing: files that cannot be removed are left to the system.
    let _ = std::fs::remove_dir_all(Path::new(&folder));
    match picture {
        Ok(picture) if status.success() => output::write(file, &picture),
        _ => Err(Failure::Lacking(format!(
            "the browser took no picture ({status}); try `smartbed view` without --still"
        ))),
    }
}

fn browser() -> Result<PathBuf, Failure> {
    let find = || NAMES.iter().find_map(|name| which(name));
    if let Some(found) = find() {
        return Ok(found);
    }
    let why = "--still needs a browser, and no chromium is on PATH";
    install::install(why, &["chromium"], "apt-get install chromium")?;
    find().ok_or_else(|| Failure::Lacking(format!("{why}: `apt-get install chromium`")))
}
