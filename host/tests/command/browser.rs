//! A page in a real browser without a window: its document after its scripts ran, and its picture.
//!
//! A page tests itself: asked for with a fragment (`page.html#self-test`) it clicks and zooms and writes
//! the results into an element, which [`open`] returns with the rest. No driver, no network.
//! The browser is found, or installed by the machine's package manager; where neither is possible, tests
//! that need it fail.

use smartbed::firmware::process::which;
use smartbed::install;
use std::fs::{self, File};
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::sync::atomic::{AtomicUsize, Ordering};
use std::time::{Duration, Instant};

/// Names under which distributions install the browser.
const NAMES: [&str; 3] = ["chromium", "chromium-browser", "google-chrome"];
/// Time limit; our pages take less than a tenth of it, but a machine may be busy.
const TIME_LIMIT: Duration = Duration::from_secs(600);
/// Time that the page's scripts and timers see pass before the document is read (ms).
const VIRTUAL_TIME: &str = "--virtual-time-budget=8000";
/// Size of the window (pixels).
pub const WINDOW: [usize; 2] = [1280, 900];

/// A page's document after its scripts ran.
#[derive(Debug)]
pub struct Dom {
    /// As HTML.
    pub html: String,
}

impl Dom {
    /// Content of the element with this id, which must contain only text.
    pub fn text(&self, id: &str) -> &str {
        let at = self.html.find(&format!("id=\"{id}\"")).unwrap_or_else(|| panic!("no element `{id}`"));
        let rest = &self.html[at..];
        let start = rest.find('>').expect("the tag ends") + 1;
        let length = rest[start..].find('<').expect("the element ends");
        &rest[start..start + length]
    }
}

/// Opens a file with a fragment (may be empty) and returns the document.
pub fn open(page: &Path, fragment: &str) -> Dom {
    let html = chromium(page, fragment, &["--dump-dom", VIRTUAL_TIME]);
    assert!(html.contains("</html>"), "the browser printed no document: {html}");
    Dom { html }
}

/// Opens a file with a fragment and takes its picture, into a PNG beside it.
pub fn screenshot(page: &Path, fragment: &str) -> PathBuf {
    let name = fragment.replace(|c: char| !c.is_ascii_alphanumeric(), "-");
    let picture = page.with_extension(format!("{name}.png"));
    let option = format!("--screenshot={}", picture.display());
    chromium(page, fragment, &[&option, VIRTUAL_TIME]);
    assert!(picture.is_file(), "the browser took no picture");
    picture
}

/// Runs the browser to its end, with an empty profile of its own; returns its standard output.
fn chromium(page: &Path, fragment: &str, more: &[&str]) -> String {
    static RUNS: AtomicUsize = AtomicUsize::new(0);
    let number = RUNS.fetch_add(1, Ordering::Relaxed);
    let profile = std::env::temp_dir().join(format!("smartbed-browser-{}-{number}", std::process::id()));
    fs::create_dir_all(&profile).expect("a folder for the profile");
    let printed = profile.join("printed");
    let page = fs::canonicalize(page).expect("the page exists");
    let mut command = Command::new(browser());
    command.args([
        "--headless",
        "--no-sandbox",
        "--disable-gpu",
        "--enable-unsafe-swiftshader",
        "--no-first-run",
    ]);
    command.arg("--disable-quic");
    command.args(["--disable-background-networking", "--disable-component-update", "--disable-sync"]);
    command.args(["--hide-scrollbars", "--force-device-scale-factor=1"]);
    command.arg(format!("--window-size={},{}", WINDOW[0], WINDOW[1]));
    command.arg(format!("--user-data-dir={}", profile.display())).args(more);
    command.arg(format!("file://{}#{fragment}", page.display()));
    // A document is longer than a pipe, and a full pipe would stop the browser.
    command.stdin(Stdio::null()).stdout(File::create(&printed).expect("a file")).stderr(Stdio::null());
    let mut child = command.spawn().expect("the browser starts");
    let start = Instant::now();
    let status = loop {
        if let Some(status) = child.try_wait().expect("the browser can be waited for") {
            break status;
        }
        if start.elapsed() > TIME_LIMIT {
            let _ = child.kill().and_then(|()| child.wait());
            panic!("the browser did not end within {} s", TIME_LIMIT.as_secs());
        }
        std::thread::sleep(Duration::from_millis(20));
    };
    assert!(status.success(), "the browser failed: {status}");
    let text = fs::read_to_string(&printed).expect("what the browser printed");
    // Its helpers may still be writing: what cannot be removed is left to the system.
    let _ = fs::remove_dir_all(&profile);
    text
}

/// The browser's program; installed where none is found.
fn browser() -> PathBuf {
    let find = || NAMES.iter().find_map(|name| which(name));
    find().unwrap_or_else(|| {
        let why = "no chromium is on PATH";
        install::install(why, &["chromium"], "apt-get install chromium").unwrap_or_else(|e| panic!("{e}"));
        find().expect(why)
    })
}

/// A picture's pixels.
#[derive(Debug)]
pub struct Picture {
    /// Pixels in a row.
    pub width: usize,
    /// Red, green, blue, row by row from the top.
    pub pixels: Vec<[u8; 3]>,
}

impl Picture {
    /// Reads a PNG of 8 bits per channel, with or without transparency, as browsers write it.
    pub fn read(path: &Path) -> Self {
        let bytes = fs::read(path).expect("the picture can be read");
        let word = |at: usize| bytes[at..at + 4].iter().fold(0, |n, b| n << 8 | usize::from(*b));
        let (width, height) = (word(16), word(20));
        assert_eq!((bytes[24], bytes[28]), (8, 0), "8 bits per channel, not interlaced");
        let channels = match bytes[25] {
            2 => 3,
            6 => 4,
            kind => panic!("a picture of colour type {kind}"),
        };
        let (mut data, mut at) = (Vec::new(), 8);
        while at + 12 <= bytes.len() {
            let length = word(at);
            if &bytes[at + 4..at + 8] == b"IDAT" {
                data.extend(&bytes[at + 8..at + 8 + length]);
            }
            at += 12 + length;
        }
        let raw = miniz_oxide::inflate::decompress_to_vec_zlib(&data).expect("a deflated picture");
        let rows = unfilter(&raw, width * channels, height, channels);
        let pixels = rows.chunks_exact(channels).map(|p| [p[0], p[1], p[2]]).collect();
        Self { width, pixels }
    }

    /// How many pixels are within `tolerance` of a colour, channel by channel.
    pub fn count(&self, color: [u8; 3], tolerance: u8) -> usize {
        let near = |p: &&[u8; 3]| p.iter().zip(color).all(|(a, b)| a.abs_diff(b) <= tolerance);
        self.pixels.iter().filter(near).count()
    }
}

/// Undoes the filters of PNG (ISO 15948, 9): each row starts with the number of its filter.
fn unfilter(raw: &[u8], stride: usize, height: usize, channels: usize) -> Vec<u8> {
    let mut rows = vec![0_u8; stride * height];
    for (row, line) in raw.chunks_exact(stride + 1).take(height).enumerate() {
        for i in 0..stride {
            let at = row * stride + i;
            let left = if i < channels { 0 } else { rows[at - channels] };
            let up = if row == 0 { 0 } else { rows[at - stride] };
            let corner = if row == 0 || i < channels { 0 } else { rows[at - stride - channels] };
            let guess = match line[0] {
                0 => 0,
                1 => left,
                2 => up,
                3 => u16::midpoint(left.into(), up.into()) as u8,
                _ => paeth(left, up, corner),
            };
            rows[at] = line[i + 1].wrapping_add(guess);
        }
    }
    rows
}

/// The neighbour nearest to left + up - corner.
fn paeth(left: u8, up: u8, corner: u8) -> u8 {
    let [a, b, c] = [left, up, corner].map(i16::from);
    let p = a + b - c;
    let [da, db, dc] = [a, b, c].map(|x| (p - x).abs());
    if da <= db && da <= dc {
        left
    } else if db <= dc {
        up
    } else {
        corner
    }
}

#[test]
fn a_page_is_opened_run_and_seen() {
    let page = super::support::written(
        "browser.html",
        "<!DOCTYPE html><html><body style=\"margin:0;background:#0a64c8\"><p id=\"said\">before</p>\
         <script>document.getElementById(\"said\").textContent = location.hash + \" \" + innerWidth;</script>\
         </body></html>",
    );
    let page = Path::new(&page);
    assert_eq!(open(page, "self-test").text("said"), format!("#self-test {}", WINDOW[0]));
    let picture = Picture::read(&screenshot(page, "seen"));
    assert_eq!(picture.width, WINDOW[0]);
    let blue = picture.count([10, 100, 200], 2);
    assert!(10 * blue > 9 * picture.pixels.len(), "{blue} of {}", picture.pixels.len());
}
