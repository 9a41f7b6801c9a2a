//! Pages of the bed in a browser: frames are drawn, maps are framed by their tiles, a text describes the run; size of
//! pages; the page that compares a sweep.

use crate::browser::open;
use crate::support::{file, smartbed, written};
use std::path::Path;

/// A number of an element's attribute.
fn attribute(html: &str, element: &str, name: &str) -> f64 {
    let tag = html.split(element).nth(1).and_then(|rest| rest.split('>').next()).expect("the element");
    let value = tag.split(&format!("{name}=\"")).nth(1).and_then(|rest| rest.split('"').next());
    value.and_then(|v| v.parse().ok()).unwrap_or_else(|| panic!("no {name} in {tag}"))
}

fn report(plan: &str, name: &str) -> String {
    let page = file(name).display().to_string();
    let done = smartbed(&["bed", "report", plan, "-o", &page]);
    assert_eq!(done.status, 0, "{done:?}");
    page
}

#[test]
fn a_page_of_the_bed_shows_its_frames_in_a_browser() {
    let page = report("ball_on_four", "bed_page.html");
    let html = open(Path::new(&page), "").html;
    assert_eq!(attribute(&html, "<body", "data-frames"), 5.0);
    // As wide and high as two by two tiles: the frame has no room beside them.
    let [width, height] = ["width", "height"].map(|name| attribute(&html, "id=\"pressure\"", name));
    let expected = (2.0 * 0.2857 - 0.006) / (2.0 * 0.225 - 0.006);
    assert!((height / width - expected).abs() < 0.01, "{width} {height}");
    assert!(html.contains("1: 3.00 · 0.0 · 0.0"), "the table of tiles shows the first frame");
    for words in [
        "Preview",
        "The bed works for 40 s",
        "tiles 1 and 4 go to 15 mmHg",
        "Alarms: none.",
        "entered by the nurse",
    ] {
        assert!(html.contains(words), "{words}");
    }
}

/// A patient while everything moves, ten frames a second; more tiles at once than a supervisor lets move.
const BUSY: &str = "format = 1
[bed]
pressure = \"5_kPa\"
[patient]
[[move]]
over = 3
tiles = \"all\"
pressure = \"3.5_kPa\"
tilt = [\"1_deg\", \"1_deg\"]
[run]
seconds = 3
every = 0.1
cycle = 3
supervised = false
";

#[test]
fn a_minute_of_a_busy_bed_takes_less_than_four_megabytes() {
    let page = report(&written("busy.toml", BUSY), "busy.html");
    let text = std::fs::read_to_string(page).expect("a page");
    let frames = text.split("\"frames\":\"").nth(1).and_then(|rest| rest.split('"').next()).expect("frames");
    let minute = text.len() - frames.len() + 20 * frames.len();
    println!("{} bytes of three seconds, {minute} of a minute", frames.len());
    assert!(frames.len() > 10_000 && minute < 4_000_000, "{minute}");
    assert!(
        text.contains("heels: above 32 mmHg for") || text.contains("Never above 32 mmHg"),
        "regions are told"
    );
}

#[test]
fn a_sweep_is_compared_on_a_page_from_which_no_text_can_run() {
    let plan = include_str!("../../../models/plans/ball_on_four.toml");
    let folder = file("sweep_page");
    let _ = std::fs::remove_dir_all(&folder);
    let name = written("</script><img src=x onerror=alert(2)>.toml".replace('/', "_").as_str(), plan);
    let page = file("sweep_page.html").display().to_string();
    let done = smartbed(&["sweep", &name, "-o", &folder.display().to_string(), "--page", &page]);
    assert_eq!(done.status, 0, "{done:?}");
    let text = std::fs::read_to_string(&page).expect("a page");
    assert!(!text.contains("<img"), "a name stands there as text");
    let html = open(Path::new(&page), "").html;
    assert_eq!(html.matches("class=\"bar\"").count(), 4, "a bar a case");
    assert!(html.contains("engineering indices, not clinical evidence") && html.contains("<td>8_kg</td>"));
}
