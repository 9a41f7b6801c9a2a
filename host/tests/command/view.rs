//! `run --view`: the page is opened in a browser, played, stopped, wound, and looked at.

use crate::browser::{Picture, open, screenshot};
use crate::support::{file, smartbed};
use std::path::{Path, PathBuf};

/// Colours of the page: links, springs, mass centres.
const LINK: [u8; 3] = [0x00, 0x72, 0xb2];
const SPRING: [u8; 3] = [0x00, 0x9e, 0x73];
const BODY: [u8; 3] = [0xd5, 0x5e, 0x00];

/// What a user does, in turn; what came of it goes into an element of its own.
const VISIT: &str = r##"<p id="visit"></p><script>
const said = [], say = (word, ok) => said.push(word + "=" + ok);
const color = (r, g, b) => {
  const { data } = pen.getImageData(0, 0, canvas.width, canvas.height);
  let n = 0;
  for (let i = 0; i < data.length; i += 4) n += data[i] === r && data[i + 1] === g && data[i + 2] === b;
  return n;
};
setTimeout(() => {
  say("plays", time > 0 && playing);
  element("play").click();
  const stopped = time;
  setTimeout(() => {
    say("stops", time === stopped && element("play").textContent === "play");
    element("time").value = 0.5; element("time").dispatchEvent(new Event("input")); draw();
    say("winds", Math.abs(time - 0.5 * end) < 1e-3 * end && element("clock").textContent.startsWith((0.5 * end).toFixed(2)));
    const before = canvas.toDataURL();
    element("names").click(); draw();
    say("names", canvas.toDataURL() !== before);
    element("names").click(); draw();
    say("same", canvas.toDataURL() === before);
    canvas.dispatchEvent(new WheelEvent("wheel", { deltaY: -500, cancelable: true })); draw();
    say("zooms", canvas.toDataURL() !== before);
    say("links", color(0, 114, 178) > 1000);
    document.dispatchEvent(new KeyboardEvent("keydown", { key: " " }));
    element("play").click();
    setTimeout(() => { say("again", time !== 0.5 * end); element("visit").textContent = said.join(" "); }, 300);
  }, 300);
}, 500);
</script></body>"##;

/// Frames on the clock that the page's timers see. The browser paints in its own time, on a busy machine the
/// first frame later than the visit's timers, and what is tested is what the page does with its frames.
const FRAMES: &str = r#"<head><script>
window.requestAnimationFrame = frame => setTimeout(() => frame(performance.now()), 16);
</script>"#;

/// A page of a model that runs for `seconds`.
fn page(model: &str, seconds: &str) -> PathBuf {
    let path = file(&format!("view_{model}.html"));
    let done = smartbed(&["run", model, "--seconds", seconds, "--view", &path.display().to_string()]);
    assert_eq!(done.status, 0, "{done:?}");
    path
}

#[test]
fn a_page_plays_stops_winds_and_zooms() {
    let path = page("fourbar", "2");
    let text = std::fs::read_to_string(&path).expect("a page");
    let text = text.replacen("<head>", FRAMES, 1).replace("</body>", VISIT);
    assert!(text.contains(FRAMES), "the page has a head");
    let visited = file("view_visited.html");
    std::fs::write(&visited, text).expect("written");
    let said = open(&visited, "").text("visit").to_owned();
    let expected = "plays=true stops=true winds=true names=true same=true zooms=true links=true again=true";
    assert_eq!(said, expected);
}

/// Middle of the pixels of a colour; how many there are.
fn middle(picture: &Picture, color: [u8; 3]) -> (f64, f64, usize) {
    let near = |p: &[u8; 3]| p.iter().zip(color).all(|(a, b)| a.abs_diff(b) <= 2);
    let places: Vec<usize> =
        picture.pixels.iter().enumerate().filter(|(_, p)| near(p)).map(|(i, _)| i).collect();
    let mean = |of: &dyn Fn(usize) -> usize| {
        places.iter().map(|&i| of(i) as f64).sum::<f64>() / places.len().max(1) as f64
    };
    (mean(&|i| i % picture.width), mean(&|i| i / picture.width), places.len())
}

fn seen(path: &Path, moment: &str) -> Picture {
    Picture::read(&screenshot(path, moment))
}

#[test]
fn what_moves_is_seen_to_move() {
    // A pendulum let go at 30 degrees: its bob, below the pin, passes from one side to the other in half a
    // period of 2 pi sqrt(0.3 / 9.81) = 1.1 s, and ends on nearly the same height.
    let path = page("pendulum", "0.6");
    let (first, last) = (seen(&path, "t=0"), seen(&path, "t=0.55"));
    let (x, y, n) = middle(&first, BODY);
    assert!(n > 80, "the bob is a disk of {n} pixels");
    let (x_later, y_later, _) = middle(&last, BODY);
    let (pin, links) = (first.width as f64 / 2.0, middle(&first, LINK).2);
    assert!(links > 500, "the rod has {links} pixels");
    assert!((x - pin) * (x_later - pin) < 0.0, "from {x} to {x_later} across {pin}");
    assert!((x - pin + x_later - pin).abs() < 0.1 * (x - x_later).abs(), "to the same distance");
    assert!((y - y_later).abs() < 0.1 * (x - x_later).abs(), "and the same height: {y}, {y_later}");
    // The drawing fills the page: a third of its height or width at least.
    assert!((x - x_later).abs() > 0.3 * first.width as f64, "{x} {x_later}");
}

#[test]
fn springs_and_bodies_in_space_are_drawn() {
    let path = page("tile", "0.5");
    let picture = seen(&path, "t=0.2");
    assert!(middle(&picture, LINK).2 > 3000 && middle(&picture, BODY).2 > 300);
    let model = std::fs::read_to_string(concat!(env!("CARGO_MANIFEST_DIR"), "/../models/fourbar.toml"));
    let sprung = model.expect("a model").replace(
        "[torques]",
        "[springs]\ns = { between = [\"A\", \"D\"], stiffness = 40, rest_length = 1 }\n\n[torques]",
    );
    let sprung = crate::support::written("view_sprung.toml", &sprung);
    let path = file("view_sprung.html");
    let done = smartbed(&["run", &sprung, "--seconds", "0.1", "--view", &path.display().to_string()]);
    assert_eq!(done.status, 0, "{done:?}");
    assert!(middle(&seen(&path, "t=0.05"), SPRING).2 > 500);
}
