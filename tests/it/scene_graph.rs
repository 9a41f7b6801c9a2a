//! Drawings of a scene's run: colours, labels, number of points, nothing that is not a number.

use smartbed::plot::{energies, png, svg};
use smartbed::scene::graph::Drawings;
use smartbed::scene::run::{EventRecord, run};
use smartbed::scene::{Scene, open};

fn scene(name: &str, settings: &[&str]) -> Scene {
    let path = format!("{}/../models/scenes/{name}.toml", env!("CARGO_MANIFEST_DIR"));
    let settings: Vec<String> = settings.iter().map(|s| (*s).to_owned()).collect();
    open(&path, &settings).unwrap_or_else(|message| panic!("{message}"))
}

fn drawn(scene: &Scene) -> (String, Vec<EventRecord>, usize) {
    let mut drawings = Drawings::new(scene, None, &scene.note()).expect("an drawings");
    let mut rows = 0;
    let events = run::<f64>(scene, |row| {
        drawings.push(row);
        rows += 1;
    })
    .expect("a run");
    let drawing = drawings.draw(scene, &events);
    assert!(png::bytes(&drawing).expect("pixels").starts_with(b"\x89PNG"), "the same drawing in pixels");
    (svg::text(&drawing), events, rows)
}

/// Points of the longest polyline of a colour.
fn points(svg: &str, color: &str) -> usize {
    let lines = svg.lines().filter(|l| l.starts_with("<polyline") && l.contains(color));
    lines.map(|l| l.split('"').nth(1).unwrap_or_default().split(' ').count()).max().unwrap_or(0)
}

#[test]
fn energies_have_the_colours_of_the_thesis() {
    let scene = scene("truss", &["C=10"]);
    let (svg, _, rows) = drawn(&scene);
    // Blue, orange, green, purple, red as Okabe and Ito (2008) have them, least channel first: read off the
    // drawing, not off the constants under test.
    for (name, color, channels) in [
        ("total", "#0072b2", [0, 1, 2]),
        ("kinetic", "#e69f00", [2, 1, 0]),
        ("potential", "#009e73", [0, 2, 1]),
        ("gravity", "#cc79a7", [1, 2, 0]),
        ("spring", "#d55e00", [2, 1, 0]),
    ] {
        assert!(svg.contains(&format!(">{name}</text>")), "{name} in the legend");
        assert_eq!(points(&svg, color), rows, "{name}: one point per row");
        let value = |c: usize| u8::from_str_radix(&color[1 + 2 * c..3 + 2 * c], 16).expect("hex");
        let [low, middle, high] = channels.map(value);
        assert!(low <= middle && middle <= high, "{name}");
        assert_eq!(energies::color(name), Some([0, 1, 2].map(value)), "{name}");
    }
    for label in
        ["time [s]", "height [m]", "energy [J]", "taken out [J]", "impulse [N s]", "work [J]", "z [m]"]
    {
        assert!(svg.contains(&format!(">{label}</text>")), "{label}");
    }
    for picture in ["start, 0.000 s", "first touch, ", "compressed, ", "end, 3.000 s"] {
        assert!(svg.contains(picture), "{picture}");
    }
    assert!(!svg.contains("NaN") && !svg.contains("inf"), "numbers only");
    let width = svg.split("width=\"").nth(1).and_then(|s| s.split('"').next()).expect("a width");
    let width: f64 = width.parse().expect("a number");
    for place in svg.split("points=\"").skip(1).flat_map(|l| l.split('"').next().unwrap_or("").split(' ')) {
        let x: f64 = place.split(',').next().and_then(|x| x.parse().ok()).expect("a place");
        assert!((0.0..=width).contains(&x), "{place} is outside");
    }
}

#[test]
fn work_over_impulse_follows_the_energy_balance_and_never_runs_backwards() {
    for (settings, kept) in [(&["eta=1"][..], 1.0), (&["eta=0.5"], 0.5), (&["law=newton", "e=0.5"], 0.25)] {
        let scene = scene("truss", settings);
        let (_, events, _) = drawn(&scene);
        let first = events.iter().find(|e| !e.touches.is_empty()).expect("an impact");
        let work = first.work.expect("a touch does work");
        let curve = work.curve(10);
        assert_eq!(curve.len(), 21);
        assert!(curve.windows(2).all(|pair| pair[0].0 <= pair[1].0), "the impulse only grows");
        // Masses of 1 kg: Q = sum v_b^2/2, J = sum of the impulses; what the law keeps is lost at the end.
        let taken: f64 = first.touches.iter().map(|(_, v, _)| 0.5 * v * v).sum();
        let impulse: f64 = first.touches.iter().map(|(_, _, j)| j).sum();
        assert_eq!(curve[0], (0.0, 0.0));
        assert!((curve[20].0 - impulse).abs() <= 1e-12 * impulse, "{:?}", curve[20]);
        assert!((curve[20].1 + (1.0 - kept) * taken).abs() <= 1e-9 * taken, "{settings:?} {:?}", curve[20]);
        // Compression ends where the work is least.
        assert!(curve.iter().all(|(_, w)| *w >= curve[10].1), "{curve:?}");
    }
    // Newton's law point by point is Eq. 4.25 itself: the least work is -Q, at P = sum m v_b.
    let scene = scene("truss", &["law=newton", "e=0.5"]);
    let (_, events, _) = drawn(&scene);
    let first = events.iter().find(|e| !e.touches.is_empty()).expect("an impact");
    let stopping: f64 = first.touches.iter().map(|(_, v, _)| v).sum();
    let curve = first.work.expect("a touch does work").curve(10);
    assert!((curve[10].0 - stopping).abs() <= 1e-12 * stopping, "{curve:?}");
    let taken: f64 = first.touches.iter().map(|(_, v, _)| 0.5 * v * v).sum();
    assert!((curve[10].1 + taken).abs() <= 1e-12 * taken, "{curve:?}");
}

#[test]
fn a_coarse_step_with_energy_compensation_is_warned_of() {
    let warned = |settings: &[&str]| scene("truss", settings).warnings;
    let [warning] = &warned(&["method=verlet"])[..] else { panic!("one warning") };
    assert!(warning.contains("w_max h") && warning.contains("above 0.1"), "{warning}");
    for fine in [
        &["method=verlet", "step=1e-4"][..],
        &["method=verlet", "C=10"],
        &["method=verlet", "law=newton"],
        &[],
    ] {
        assert_eq!(warned(fine), Vec::<String>::new(), "{fine:?}");
    }
}
