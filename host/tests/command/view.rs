//! `run --view` and `view`: the page is opened in a browser, played, stopped, moved to other times; a file is followed.

use crate::browser::{Picture, open, screenshot};
use crate::support::{command, file, model, smartbed, written};
use std::io::{BufRead, BufReader, Read, Write};
use std::net::TcpStream;
use std::path::{Path, PathBuf};
use std::process::{Child, Stdio};
use std::time::{Duration, Instant};

/// A user's actions, one after the other; the results go into a separate element.
const VISIT: &str = r##"<p id="visit"></p><script>
const said = [], say = (word, ok) => said.push(word + "=" + ok);
const canvas = stage.renderer.domElement, picture = () => { draw(); return canvas.toDataURL(); };
const slide = (share) => { element("time").value = share; element("time").dispatchEvent(new Event("input")); };
setTimeout(() => {
  say("plays", time > 0 && playing);
  element("play").click();
  const stopped = time;
  setTimeout(() => {
    say("stops", time === stopped && element("play").textContent === "play");
    slide(0.5);
    say("winds", Math.abs(time - 0.5 * film.end) < 1e-3 * film.end && element("clock").textContent.startsWith((0.5 * film.end).toFixed(3)));
    const before = picture();
    slide(0.25);
    say("moves", picture() !== before);
    slide(0.5);
    say("same", picture() === before);
    const plot = element("energies"), box = plot.getBoundingClientRect();
    plot.dispatchEvent(new PointerEvent("pointerdown", { clientX: box.left + 52 + 0.75 * (box.width - 58), clientY: box.top + 50, buttons: 1 }));
    say("cursor", Math.abs(time - 0.75 * film.end) < 0.01 * film.end);
    slide(0.5);
    canvas.dispatchEvent(new WheelEvent("wheel", { deltaY: -500, cancelable: true }));
    say("zooms", picture() !== before);
    const { triangles, calls } = stage.renderer.info.render;
    say("light", triangles > 100 && triangles < 50000 && calls < 60);
    element("play").click();
    setTimeout(() => {
      say("again", time !== 0.5 * film.end);
      say("quiet", faults.length === 0 && performance.getEntriesByType("resource").length === 0);
      element("visit").textContent = said.join(" ");
    }, 300);
  }, 300);
}, 500);
</script></body>"##;

/// Records errors on the page, and draws frames by the clock of the page's timers: the browser paints at times of its
/// own, but the test is about the content of frames.
const FRAMES: &str = r#"<head><script>
const faults = [];
window.onerror = (message) => { faults.push(message); };
console.error = console.warn = (message) => { faults.push(message); };
document.addEventListener("securitypolicyviolation", (event) => { faults.push(event.blockedURI); });
window.requestAnimationFrame = frame => setTimeout(() => frame(performance.now()), 16);
</script>"#;

/// A page of a model that runs for `seconds`.
fn page(model: &str, seconds: &str) -> PathBuf {
    let name = Path::new(model).file_stem().expect("a name").to_string_lossy().into_owned();
    let path = file(&format!("view_{name}.html"));
    let done = smartbed(&["run", model, "--seconds", seconds, "--view", &path.display().to_string()]);
    assert_eq!(done.status, 0, "{done:?}");
    path
}

/// A picture of the stage alone.
fn seen(path: &Path, time: &str) -> Picture {
    Picture::read(&screenshot(path, &format!("t={time},still")))
}

/// Middle of the pixels of a kind; how many there are.
fn middle(picture: &Picture, kind: fn([u8; 3]) -> bool) -> (f64, f64, usize) {
    let places: Vec<usize> = (0..picture.pixels.len()).filter(|&i| kind(picture.pixels[i])).collect();
    let mean = |of: &dyn Fn(usize) -> usize| {
        places.iter().map(|&i| of(i) as f64).sum::<f64>() / places.len().max(1) as f64
    };
    (mean(&|i| i % picture.width), mean(&|i| i / picture.width), places.len())
}

/// The vermilion of bodies, in light and shade.
fn is_body([r, g, b]: [u8; 3]) -> bool {
    r > 90 && i32::from(r) > i32::from(g) + 55 && i32::from(g) > i32::from(b) + 20
}

/// The blue of links.
fn is_link([r, g, b]: [u8; 3]) -> bool {
    b > 60 && i32::from(b) > i32::from(r) + 50 && g > r
}

/// A link inside a solid: dark, and neither's colour.
fn is_covered_link([r, g, b]: [u8; 3]) -> bool {
    let (least, most) = (r.min(g).min(b), r.max(g).max(b));
    most - least < 60 && least > 45 && most < 140
}

/// The green of springs.
fn is_spring([r, g, b]: [u8; 3]) -> bool {
    i32::from(g) > i32::from(r) + 60 && i32::from(g) > i32::from(b) + 20
}

#[test]
fn a_page_plays_stops_winds_and_zooms() {
    let text = std::fs::read_to_string(page("fourbar", "2")).expect("a page");
    let text = text.replacen("<head>", FRAMES, 1).replace("</body>", VISIT);
    assert!(text.contains(FRAMES), "the page has a head");
    let visited = written("view_visited.html", &text);
    let said = open(Path::new(&visited), "").text("visit").to_owned();
    let expected = "plays=true stops=true winds=true moves=true same=true cursor=true zooms=true light=true again=true \
                    quiet=true";
    assert_eq!(said, expected);
}

#[test]
fn what_moves_is_seen_to_move() {
    // A pendulum let go at 30 degrees: its bob, below the pin, passes from one side to the other in half a
    // period of 2 pi sqrt(0.3 / 9.81) = 1.1 s, and ends on nearly the same height.
    let path = page("pendulum", "0.6");
    let (first, last) = (seen(&path, "0"), seen(&path, "0.55"));
    let (x, y, n) = middle(&first, is_body);
    assert!(n > 80, "the bob has {n} pixels");
    let (x_later, y_later, _) = middle(&last, is_body);
    let (pin, links) = (first.width as f64 / 2.0, middle(&first, is_link).2);
    assert!(links > 500, "the rod has {links} pixels");
    assert!((x - pin) * (x_later - pin) < 0.0, "from {x} to {x_later} across {pin}");
    assert!((x - pin + x_later - pin).abs() < 0.1 * (x - x_later).abs(), "to the same distance");
    assert!((y - y_later).abs() < 0.1 * (x - x_later).abs(), "and the same height: {y}, {y_later}");
    // The drawing fills the page: a third of its height or width at least.
    assert!((x - x_later).abs() > 0.3 * first.width as f64, "{x} {x_later}");
}

#[test]
fn springs_and_bodies_in_space_are_drawn() {
    let picture = seen(&page("arm6", "0.5"), "0.2");
    let (links, bodies) = (middle(&picture, is_covered_link).2, middle(&picture, is_body).2);
    assert!(links > 1000 && bodies > 3000, "{links} {bodies}");
    let sprung = model("fourbar").replace(
        "[torques]",
        "[springs]\ns = { between = [\"A\", \"D\"], stiffness = 40, rest_length = 1 }\n\n[torques]",
    );
    let path = page(&written("view_sprung.toml", &sprung), "0.1");
    let springs = middle(&seen(&path, "0.05"), is_spring).2;
    assert!(springs > 300, "{springs}");
}

#[test]
fn a_body_falls_touches_and_keeps_within_its_bytes() {
    // A minute: two megabytes at most.
    let path = page("truss", "60");
    let bytes = std::fs::metadata(&path).expect("a page").len();
    assert!(bytes < 2_000_000, "{bytes}");
    let path = page("truss", "0.6");
    let html = open(&path, "t=0.5").html;
    assert!(html.contains("3 points touch") && html.contains("class=\"past\""), "events are listed");
    let ink = |p: [u8; 3]| p.iter().all(|c| *c < 150);
    let (high, low) = (middle(&seen(&path, "0"), ink).1, middle(&seen(&path, "0.45"), ink).1);
    assert!(low > high + 100.0, "it falls: {high} {low}");
}

#[test]
fn no_text_of_a_model_runs_as_script() {
    let markup = "</script><script>document.body.id='owned'</script><img src=x onerror=\\\"document.body.id='owned'\\\"><!--";
    let models = Path::new(env!("CARGO_MANIFEST_DIR")).join("../models");
    let fourbar = std::fs::read_to_string(models.join("fourbar.toml")).expect("a model");
    let doc = fourbar.replace("Four-bar linkage driven by", &format!("{markup} driven by"));
    let spring = std::fs::read_to_string(models.join("scenes/single_spring.toml")).expect("a scene");
    let titled: Vec<String> = spring
        .lines()
        .map(|l| if l.starts_with("title") { format!("title = \"{markup}\"") } else { l.to_owned() })
        .collect();
    for (name, text) in [("view_markup.toml", doc), ("view_markup_scene.toml", titled.join("\n"))] {
        assert!(text.contains(markup), "{name}");
        let html = open(&page(&written(name, &text), "0.1"), "").html;
        assert!(!html.contains("id=\"owned\""), "{name}: the markup ran");
        assert!(
            html.contains("&lt;/script&gt;&lt;script&gt;"),
            "{name}: the title is shown as it is written"
        );
    }
}

#[test]
fn a_still_is_a_picture() {
    let png = file("still.png").display().to_string();
    let done = smartbed(&["view", "pendulum", "--still", "t=0.3", &png]);
    assert_eq!(done.status, 0, "{done:?}");
    assert!(middle(&Picture::read(Path::new(&png)), is_body).2 > 80);
    let wrong = smartbed(&["view", "pendulum", "--still", "0.3", &png]);
    assert!(wrong.message().contains("for example t=0.5"), "{wrong:?}");
    let wrong = smartbed(&["view", "pendulum", "--still", "t=0.3", "x.jpg"]);
    assert!(wrong.message().contains("ends in .png"), "{wrong:?}");
    let late = smartbed(&["view", "pendulum", "--seconds", "0.1", "--still", "t=5", &png]);
    assert_eq!(late.status, 1, "{late:?}");
    assert!(late.message().contains("--still t=5: the run ends at 0.1 s;"), "{late:?}");
}

#[test]
fn a_still_shows_a_row_and_says_its_time() {
    // A ball that bounces between its rows, at 0, 0.4 and 0.6 s.
    let text = "format = 2\ntitle = \"b\"\n[parts.ground]\nrigid = \"half_space\"\n\
        [parts.ball]\nrigid = \"sphere\"\nradius = 0.1\nmass = 1\nstart = { height = 0.5 }\n\
        [[contacts]]\nbetween = [\"ball\", \"ground\"]\nimpact = \"stronge\"\nrestitution = 0.5\n\
        [run]\nseconds = 0.6\nevery = 400\n";
    let world = written("still_rows.toml", text);
    let taken = |t: &str| {
        let png = file(&format!("still_rows_{t}.png")).display().to_string();
        let done = smartbed(&["view", &world, "--still", &format!("t={t}"), &png]);
        assert_eq!(done.status, 0, "{done:?}");
        std::fs::read(png).expect("a picture")
    };
    let row = taken("0.4");
    assert!(row == taken("0.3") && row != taken("0"), "the picture and its caption are those of the row");
    let page = page(&world, "0.6");
    assert!(open(&page, "t=0.30000000000000004,still").text("note").ends_with(", t = 0.3 s"));
}

/// A wheel with a bob, as the guide's page on pictures shows it; `hide` says what it leaves out.
fn wheel(name: &str, hide: &str) -> String {
    let guide = std::fs::read_to_string(concat!(env!("CARGO_MANIFEST_DIR"), "/../docs/guide/pictures.md"));
    let guide = guide.expect("the guide");
    let model =
        guide.split_once("file=press.toml\n").expect("the model").1.split_once("```").expect("its end").0;
    written(name, &model.replace("hide = [\"rim\"]", hide))
}

/// The colour sky, in light and shade.
fn is_sky([r, g, b]: [u8; 3]) -> bool {
    i32::from(b) > i32::from(r) + 60 && i32::from(g) > i32::from(r) + 35 && r > 60
}

#[test]
fn shapes_colours_and_what_to_leave_out_are_the_model_s() {
    let shown = seen(&page(&wheel("view_wheel.toml", "hide = []"), "0.5"), "0.4");
    let hidden = seen(&page(&wheel("view_no_wheel.toml", "hide = [\"wheel\", \"back\"]"), "0.5"), "0.4");
    let count = |picture: &Picture, kind: fn([u8; 3]) -> bool| middle(picture, kind).2;
    let (disc, none) = (count(&shown, is_sky), count(&hidden, is_sky));
    assert!(disc > 20_000 && none < disc / 100, "{disc} {none}");
    let (spring, none) = (count(&shown, is_spring), count(&hidden, is_spring));
    assert!(spring > 300 && none == 0, "{spring} {none}");
    // The rod from the origin to the bob stays.
    assert!(count(&hidden, is_link) > 1000);
}

/// Goes to the end, adds up the ground's forces, and jumps to the second event.
const LOOK: &str = r#"<p id="look"></p><script>
play(false); wind(film.end);
let sum = 0;
film.touching(time).forEach(({ normal }) => { sum += normal.length(); });
const arrows = stage.normals.count, buttons = element("events").querySelectorAll("button");
if (buttons.length > 1) buttons[1].click();
element("look").textContent = [sum, arrows, buttons.length, buttons.length > 1 ? time - film.events[1][0] : 0].join(" ");
</script></body>"#;

/// Values that [`LOOK`] reads from a page.
fn looked(path: &Path, name: &str) -> Vec<f64> {
    let text = std::fs::read_to_string(path).expect("a page").replace("</body>", LOOK);
    let dom = open(Path::new(&written(name, &text)), "");
    dom.text("look").split(' ').map(|x| x.parse().expect("a number")).collect()
}

#[test]
fn arrows_at_rest_carry_the_weight_and_events_jump() {
    // Damped well, the truss lies after 4 s: what holds its five masses of 1 kg are arrows at its three feet.
    let path = file("view_truss_rest.html");
    let page_of = path.display().to_string();
    let done = smartbed(&["run", "truss", "--set", "C=20", "--seconds", "4", "--view", &page_of]);
    assert_eq!(done.status, 0, "{done:?}");
    let found = looked(&path, "view_truss_looked.html");
    let &[weight, arrows, events, late] = found.as_slice() else { panic!("{found:?}") };
    assert!((weight - 5.0 * 9.81).abs() < 0.02 && arrows == 3.0, "{found:?}");
    assert!(events > 2.0 && late.abs() < 1e-6, "{found:?}");
}

#[test]
fn a_mechanism_s_page_lists_its_turns() {
    // Without losses the wheel swings between its start at 20 degrees and 160: the bob hangs below the rim.
    let path = page(&wheel("view_turns.toml", "hide = []"), "3");
    let html = open(&path, "").html;
    assert!(html.contains("angle turns at 160.0000 deg") && html.contains("angle turns at 20.0000 deg"));
    assert!(looked(&path, "view_turns_looked.html")[2..] == [3.0, 0.0]);
}

/// A server that ends with its test.
struct Server(Child);

impl Drop for Server {
    fn drop(&mut self) {
        let _ = self.0.kill().and_then(|()| self.0.wait());
    }
}

/// Body of a server's answer.
fn get(address: &str, path: &str) -> String {
    let mut stream = TcpStream::connect(address).expect("the server listens");
    write!(stream, "GET {path} HTTP/1.1\r\nHost: {address}\r\n\r\n").expect("asked");
    let mut text = String::new();
    stream.read_to_string(&mut text).expect("an answer");
    text.split_once("\r\n\r\n").expect("a head").1.to_owned()
}

#[test]
fn a_served_page_follows_its_file() {
    let models = Path::new(env!("CARGO_MANIFEST_DIR")).join("../models");
    let model = std::fs::read_to_string(models.join("pendulum.toml")).expect("a model");
    let folder = file("followed");
    std::fs::create_dir_all(&folder).expect("a folder");
    let path = folder.join("pendulum.toml");
    std::fs::write(&path, &model).expect("written");
    let mut view = command(&["view", &path.display().to_string(), "--json"]);
    let mut server = Server(view.stdout(Stdio::piped()).spawn().expect("the program runs"));
    let mut line = String::new();
    let out = server.0.stdout.take().expect("its output");
    BufReader::new(out).read_line(&mut line).expect("the address");
    let address: serde_json::Value = serde_json::from_str(&line).expect("JSON");
    let address = address["address"].as_str().expect("an address").trim_start_matches("http://");
    let address = address.trim_end_matches('/');
    assert!(get(address, "/").contains("<canvas") && get(address, "/nowhere").contains("/state"));
    let state = || serde_json::from_str::<serde_json::Value>(&get(address, "/state")).expect("JSON");
    let (first, version) = (get(address, "/data"), state()["version"].as_u64());
    assert_eq!(state()["version"].as_u64(), version, "nothing was edited");
    let edited = |text: &str, done: &dyn Fn(&serde_json::Value) -> bool| {
        std::fs::write(&path, text).expect("written");
        let start = Instant::now();
        while !done(&state()) {
            assert!(start.elapsed() < Duration::from_secs(300), "the edit was not seen");
            std::thread::sleep(Duration::from_millis(20));
        }
    };
    let is_later = |s: &serde_json::Value| s["version"].as_u64() > version;
    edited(&model.replace("9.81", "1.62"), &is_later);
    let moon = get(address, "/data");
    assert!(moon != first, "the moon's gravity moves it otherwise");
    // What is wrong is said, and the last motion stays.
    edited(&model.replace("[coordinates]", "[cordinates]"), &|s| {
        s["fault"].as_str().is_some_and(|f| f.contains("did you mean `coordinates`"))
    });
    assert_eq!(get(address, "/data"), moon);
}
