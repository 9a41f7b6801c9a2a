//! Pages and stills of worlds: what a surface shows, arrows where parts touch, bytes of a page, time of a still.

use crate::browser::{Picture, open};
use crate::support::{command, file, smartbed, timed, written};
use serde_json::Value;
use std::path::Path;

/// Goes to a time and writes as JSON what the page draws there.
const LOOK: &str = r#"<p id="look"></p><script>
play(false); wind(TIME);
const list = film.touching(time).map(({ point, normal, friction, both }) => [...point, ...normal, ...friction, both ? 1 : 0]);
const skin = stage.surface, { triangles, calls } = stage.renderer.info.render;
const tints = skin ? [...new Set([...skin.skin.geometry.attributes.color.array].map((x) => Math.round(100 * x)))].length : 0;
element("look").textContent = JSON.stringify({ list, normals: stage.normals.count, frictions: stage.frictions.count, triangles, calls, tints,
  solids: stage.solids.groups.reduce((sum, { bodies }) => sum + bodies.length, 0), facets: skin ? [skin.moving.length, skin.base.length, skin.rim.length] : [],
  range: skin ? skin.range() : [], full: film.full });
</script></body>"#;

/// The page of a scene, and the values that [`LOOK`] reads from it.
fn looked(scene: &str, more: &[&str], time: &str) -> (u64, Value) {
    let name = Path::new(scene).file_stem().expect("a name").to_string_lossy().into_owned();
    let path = file(&format!("world_{name}.html"));
    let page = path.display().to_string();
    let mut arguments = vec!["run", scene, "--view", &page];
    arguments.extend(more);
    let done = smartbed(&arguments);
    assert_eq!(done.status, 0, "{done:?}");
    let text = std::fs::read_to_string(&path).expect("a page");
    let visited = text.replace("</body>", &LOOK.replace("TIME", time));
    let dom = open(Path::new(&written(&format!("world_{name}_looked.html"), &visited)), "");
    (text.len() as u64, serde_json::from_str(dom.text("look")).expect("JSON"))
}

/// Contacts as the page has them: point, forces along and across the normal, 1 where both parts are pushed.
fn contacts(seen: &Value) -> Vec<[f64; 10]> {
    let list = seen["list"].as_array().expect("a list").iter();
    list.map(|one| std::array::from_fn(|i| one[i].as_f64().expect("a number"))).collect()
}

#[test]
fn a_tile_and_its_bladder_keep_within_their_bytes_for_a_minute() {
    let (bytes, seen) = looked("tile_with_bladder", &["--seconds", "60", "--step", "1e-3"], "30.2");
    assert!(bytes <= 2_000_000, "{bytes} bytes");
    // A sheet with 7 x 7 nodes between its edges; walls and base are held all round, and what they share with the sheet
    // is the rim.
    assert_eq!(seen["facets"], serde_json::json!([64, 54, 28]), "{seen}");
    let [low, high] = [0, 1].map(|n| seen["range"][n].as_f64().expect("a pressure"));
    assert!(low <= 0.0 && high > 500.0 && high < 3000.0, "gauge from {low} to {high} Pa");
    assert!(seen["full"].as_f64().is_some_and(|full| full > 1e-5 && full < 0.2), "{seen}");
    assert!(seen["tints"].as_u64().is_some_and(|n| n > 3), "facets differ in colour: {seen}");
    let [triangles, calls] = ["triangles", "calls"].map(|key| seen[key].as_u64().expect("a number"));
    assert!(triangles < 50_000 && calls < 60, "{triangles} triangles, {calls} calls");
}

#[test]
fn parts_that_touch_have_arrows_each() {
    // At rest: four corners a joint, 6, 3 and 1 kg above them.
    let (_, seen) = looked("stack_boxes", &[], "1");
    let contacts = contacts(&seen);
    for (height, mass, both) in [(0.0, 6.0, 0.0), (0.1, 3.0, 1.0), (0.2, 1.0, 1.0)] {
        let here: Vec<_> = contacts.iter().filter(|c| (c[2] - height).abs() < 1e-3).collect();
        let weight: f64 = here.iter().map(|c| c[5].abs()).sum();
        assert!((weight - 9.81 * mass).abs() < 1e-3 * weight, "{weight} N at {height} m: {contacts:?}");
        assert!(here.iter().all(|c| c[9] == both), "{contacts:?}");
    }
    let arrows: f64 = contacts.iter().map(|c| 1.0 + c[9]).sum();
    assert_eq!(seen["normals"].as_f64(), Some(arrows));
    assert_eq!(seen["solids"], 3);
    // What the scene leaves out is not there.
    let text = include_str!("../../../models/scenes/stack_boxes.toml");
    let view = "\n[view]\nhide = [\"upper\", \"forces\"]\ncolours = { lower = \"sky\" }\n";
    let (_, seen) =
        looked(&written("stack_hidden.toml", &format!("{text}{view}")), &["--seconds", "0.1"], "0.1");
    assert!(seen["solids"] == 2 && seen["list"] == serde_json::json!([]), "{seen}");
}

#[test]
fn every_half_space_is_drawn() {
    let slope = |name: &str, angle: f64| {
        format!(
            "[parts.{name}]\nrigid = \"half_space\"\nstart = {{ axis = [0, 1, 0], angle = \"{angle}_deg\" }}\n"
        )
    };
    let ball =
        "[parts.ball]\nrigid = \"sphere\"\nradius = 0.1\nmass = 1\nstart = { position = [0.1, 0, 0.3] }\n";
    let touch = |of: &str| format!("[[contacts]]\nbetween = [\"ball\", \"{of}\"]\nimpact = \"plastic\"\n");
    let [left, right, contacts] =
        [slope("left", 40.0), slope("right", -40.0), touch("left") + &touch("right")];
    let scene = format!("format = 2\n{left}{right}{ball}{contacts}[run]\nseconds = 0.1\n[view]\nHIDE\n");
    for (name, hide, lines) in [("both", "", 2), ("one", "hide = [\"left\"]", 1)] {
        let path = written(&format!("groove_{name}.toml"), &scene.replace("HIDE", hide));
        let picture = file(&format!("groove_{name}.svg"));
        let (seen, page) = (picture.display().to_string(), file(&format!("groove_{name}.html")));
        let done = smartbed(&["run", &path, "--plot", &seen, "--view", &page.display().to_string()]);
        assert_eq!(done.status, 0, "{done:?}");
        let page = std::fs::read_to_string(page).expect("a page");
        let (_, grounds) = page.split_once("\"grounds\":[").expect("grounds");
        let (grounds, _) = grounds.split_once("}]").expect("their end");
        assert_eq!(grounds.matches("\"normal\":").count(), 2, "{grounds}");
        assert_eq!(grounds.matches("\"shown\":true").count(), lines, "{grounds}");
        // In each of the pictures: start, first touch and end, of which two may be at one time.
        let picture = std::fs::read_to_string(picture).expect("a picture");
        let moments = ["start, ", "first touch, ", "end, "].iter().filter(|m| picture.contains(**m)).count();
        assert_eq!(picture.matches("stroke-width=\"2.5\"").count(), lines * moments, "{hide}");
    }
}

#[test]
fn friction_points_against_the_slip() {
    // A rod of 0.5 kg slides along x with mu = 0.25, by located contacts and without locating.
    let text = include_str!("../../../models/scenes/rod_with_friction.toml");
    let moreau = written("rod_moreau.toml", &text.replace("\"stronge\"", "\"moreau\""));
    for scene in ["rod_with_friction", &moreau] {
        let (_, seen) = looked(scene, &["--seconds", "0.3"], "0.2");
        let contacts = contacts(&seen);
        let sum = |at: usize| contacts.iter().map(|c| c[at]).sum::<f64>();
        let (weight, rub) = (0.5 * 9.81, [sum(6), sum(7), sum(8)]);
        assert!((sum(5) - weight).abs() < 0.02 * weight, "{scene}: {contacts:?}");
        assert!((rub[0] + 0.25 * weight).abs() < 0.02 * weight, "{scene}: {rub:?}");
        assert!(rub[1].abs() < 0.02 * weight && rub[2].abs() < 0.02 * weight, "{scene}: {rub:?}");
        assert_eq!(seen["frictions"].as_u64(), Some(contacts.len() as u64), "{scene}");
    }
}

#[test]
fn points_of_one_body_rub_on_the_ground() {
    let more = ["--set", "mu=0.3", "--set", "initial_velocity=[3,0,0]", "--set", "C=20", "--seconds", "1.5"];
    let (_, seen) = looked("truss", &more, "1");
    let contacts = contacts(&seen);
    assert!(!contacts.is_empty(), "it touches");
    for c in &contacts {
        let (normal, rub) = (c[5], c[6].hypot(c[7]));
        assert!(c[8].abs() < 1e-6 * normal && rub <= 0.3 * normal * (1.0 + 1e-5), "{contacts:?}");
    }
    assert!(contacts.iter().map(|c| c[6]).sum::<f64>() < 0.0, "against the way: {contacts:?}");
}

#[test]
fn a_still_of_the_bed_takes_less_than_half_a_minute() {
    let png = file("bed.png").display().to_string();
    let (done, seconds) = timed(&command(&["view", "bed", "--still", "t=0.1", &png]));
    assert_eq!(done.status, 0, "{done:?}");
    println!("still of the bed: {seconds} s of processor time");
    assert!(seconds < 30.0, "{seconds} s");
    let picture = Picture::read(Path::new(&png));
    let white = picture.count([255, 255, 255], 0);
    assert!(white < 9 * picture.pixels.len() / 10, "{white} of {} pixels are white", picture.pixels.len());
}
