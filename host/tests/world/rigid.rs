//! Worlds of rigid bodies against closed forms.

use super::support::{self, json, number, times};

/// Free fall (m/s^2).
pub const G: f64 = 9.81;

#[test]
fn a_box_bounces_when_free_fall_says_and_does_not_spin() {
    let done = json(&["box_bounce"]);
    let (e, height) = (0.6_f64, 0.5_f64);
    let mut expected = (2.0 * height / G).sqrt();
    let mut flight = 2.0 * e * expected;
    for time in times(&done).iter().take(8) {
        assert!((time - expected).abs() < 1e-9, "{time} against {expected}");
        (expected, flight) = (expected + flight, e * flight);
    }
    for spin in ["box.wx", "box.wy", "box.wz"] {
        assert!(number(&done["last"][spin]).abs() < 1e-9, "{spin}");
    }
    // Energy to rest: the height of a box that lies.
    assert!((number(&done["last"]["box.z"]) - 0.05).abs() < 1e-9, "{}", done["last"]);
    assert!(number(&done["imbalance"]).abs() < 1e-9 * number(&done["total_at_start"]), "{done}");
}

#[test]
fn a_rod_slides_as_far_as_friction_says() {
    let (v, mu) = (1.5, 0.25);
    let done = json(&["rod_with_friction"]);
    let (distance, last) = (v * v / (2.0 * mu * G), &done["last"]);
    assert!((number(&last["rod.x"]) - distance).abs() < 1e-9, "{} against {distance}", last["rod.x"]);
    assert!(number(&last["rod.vx"]).abs() < 1e-9);
    assert!((number(&last["friction"]) - 0.5 * 0.5 * v * v).abs() < 1e-9, "{}", last["friction"]);
}

#[test]
fn boxes_stack_and_stay() {
    let done = json(&["stack_boxes"]);
    for (name, height) in [("lower", 0.05), ("middle", 0.15), ("upper", 0.25)] {
        let last = |what: &str| number(&done["last"][format!("{name}.{what}")]);
        assert!((last("z") - height).abs() < 1e-6, "{name}: {}", last("z"));
        assert!(last("vz").abs() < 1e-9 && last("wx").abs() < 1e-9 && last("wy").abs() < 1e-9, "{name}");
    }
    assert!(number(&done["imbalance"]).abs() < 1e-9, "{done}");
}

#[test]
fn a_ball_comes_to_rest_where_its_bounces_add_up() {
    let (e, height) = (0.5_f64, 0.4_f64);
    let done = json(&["rigid_ball_rests"]);
    // The series of all flights: t1 (1 + e)/(1 - e).
    let rest = (2.0 * height / G).sqrt() * (1.0 + e) / (1.0 - e);
    let times = times(&done);
    let last = times.last().copied().expect("bounces");
    assert!(times.len() > 10 && (last - rest).abs() < 2e-3 && last <= rest + 1e-9, "{last} against {rest}");
    assert!((number(&done["last"]["ball.z"]) - 0.1).abs() < 1e-9);
}

#[test]
fn a_thrown_ball_rolls_at_five_sevenths_of_its_speed() {
    let (v, mu) = (1.4, 0.2);
    let done = json(&[
        "rigid_ball_rests",
        "--set",
        "parts.ball.start={ height = 0, velocity = [\"1.4 m/s\", 0, 0] }",
        "--set",
        "contacts=[{ between = [\"ball\", \"ground\"], impact = \"plastic\", friction = 0.2 }]",
    ]);
    let last = &done["last"];
    let (slides, speed) = (2.0 * v / (7.0 * mu * G), 5.0 / 7.0 * v);
    let way = v * slides - 0.5 * mu * G * slides * slides + speed * (1.0 - slides);
    assert!((number(&last["ball.vx"]) - speed).abs() < 1e-8, "{}", last["ball.vx"]);
    assert!((number(&last["ball.wy"]) - speed / 0.1).abs() < 1e-7, "{}", last["ball.wy"]);
    assert!((number(&last["ball.x"]) - way).abs() < 1e-7, "{} against {way}", last["ball.x"]);
}

/// Five equal balls in a row: the last one takes all of the speed if e = 1. Normals are unit vectors up to rounding
/// only.
#[test]
fn a_row_of_balls_passes_its_speed_on() {
    for axis in 0..2 {
        let mut text = "gravity = [0, 0, 0]\n".to_owned();
        for n in 0..5_u32 {
            let mut place = [0.0; 3];
            place[axis] = f64::from(n) * 0.1003;
            let speed = if n == 0 { [1.0, 0.0, 0.0] } else { [0.0; 3] };
            let velocity: Vec<f64> = (0..3).map(|k| speed[(k + 3 - axis) % 3]).collect();
            text += &format!(
                "[parts.p{n}]\nrigid = \"sphere\"\nradius = 0.05\nmass = 1\nstart = {{ position = {place:?}, velocity = {velocity:?} }}\n"
            );
        }
        for n in 0..4 {
            text += &format!(
                "[[contacts]]\nbetween = [\"p{n}\", \"p{}\"]\nimpact = \"stronge\"\nrestitution = 1\n",
                n + 1
            );
        }
        for elsewhere in ["", support::ELSEWHERE] {
            let file = support::scene(
                "row_of_balls",
                &format!("format = 2\n{text}{elsewhere}[run]\nseconds = 0.1\n"),
            );
            let last = &json(&[&file])["last"];
            let name = ["vx", "vy"][axis];
            let speeds: Vec<f64> = (0..5).map(|n| number(&last[format!("p{n}.{name}")])).collect();
            for (n, speed) in speeds.iter().enumerate() {
                assert!((speed - f64::from(u8::from(n == 4))).abs() < 1e-12, "{axis}: {speeds:?}");
            }
        }
    }
}

/// Masses whose squares vanish are named as what they are.
#[test]
fn a_mass_that_is_too_small_is_named() {
    let text = "format = 2\n[parts.ground]\nrigid = \"half_space\"\n[parts.ball]\nrigid = \"sphere\"\nradius = 0.1\n\
                mass = MASS\nstart = { height = 1 }\n[[contacts]]\nbetween = [\"ball\", \"ground\"]\n\
                impact = \"LAW\"\n[run]\nseconds = 1\n";
    let with = |law: &str, mass: &str| {
        support::scene(&format!("mass_{mass}_{law}"), &text.replace("LAW", law).replace("MASS", mass))
    };
    let said = support::fails(&["run", &with("moreau", "1e-310")]);
    assert!(said.contains("a value has become infinite or not a number"), "{said}");
    let said = support::fails(&["run", &with("plastic", "1e-310")]);
    assert!(said.contains("the mass, inertia or size of `ball` is not > 0 and finite"), "{said}");
    // What can be computed is: it falls 0.9 m.
    let last = support::json(&[&with("plastic", "1e-300"), "--seconds", "0.4"])["last"]["ball.z"].as_f64();
    assert!(last.is_some_and(|z| (z - (1.1 - 0.5 * 9.81 * 0.16)).abs() < 1e-12), "{last:?}");
}
