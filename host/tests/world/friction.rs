//! Boxes that stand on four corners: they slide, ride and are shaken as closed forms say, with the laws that locate
//! events and take friction, alone and beside a flexible part.

use super::rigid::G;
use super::support::{ELSEWHERE, fails, json, number, scene};

const LAWS: [&str; 3] = ["plastic", "stronge", "compensation"];

/// A box 0.3 x 0.2 x 0.1 m at rest on an incline, mu = 0.3.
fn on_incline(degrees: f64, law: &str, more: &str) -> String {
    let turn = format!("axis = [0, 1, 0], angle = \"{degrees}_deg\"");
    let (sine, cosine) = degrees.to_radians().sin_cos();
    format!(
        "format = 2\n[parts.ground]\nrigid = \"half_space\"\nstart = {{ {turn} }}\n\
         [parts.box]\nrigid = \"box\"\nsize = [0.3, 0.2, 0.1]\nmass = 2\n\
         start = {{ position = [{:?}, 0, {:?}], {turn} }}\n{more}\
         [[contacts]]\nbetween = [\"box\", \"ground\"]\nimpact = \"{law}\"\nfriction = 0.3\n\
         [run]\nseconds = 0.5\nstep = \"1_ms\"\nevery = 100\n",
        0.05 * sine,
        0.05 * cosine
    )
}

/// From rest, friction turns slip that is still slow a hundred times faster than a step of 1 ms can follow.
#[test]
fn a_box_slides_down_an_incline_from_rest_without_turning() {
    for (more, name) in [("", "alone"), (ELSEWHERE, "beside")] {
        for law in LAWS {
            for degrees in [16.0_f64, 17.0, 17.3, 20.0] {
                let text = on_incline(degrees, law, more);
                let done = json(&[&scene(&format!("incline_{name}_{law}_{degrees}"), &text)]);
                let last = |what: &str| number(&done["last"][what]);
                let (sine, cosine) = degrees.to_radians().sin_cos();
                let expected = 0.125 * G * (sine - 0.3 * cosine).max(0.0);
                let gone = (last("box.x") - 0.05 * sine).hypot(last("box.z") - 0.05 * cosine);
                let name = format!("{name}, {law}, {degrees} degrees");
                assert!((gone - expected).abs() < 1e-10, "{name}: {gone} against {expected}");
                assert!(last("box.y").abs() < 1e-12, "{name}: {}", last("box.y"));
                assert!(number(&done["imbalance"]).abs() < 1e-10, "{name}: {}", done["imbalance"]);
                assert_eq!(
                    done["warnings"].as_array().map(Vec::len),
                    Some(0),
                    "{name}: {}",
                    done["warnings"]
                );
            }
        }
    }
}

/// Friction of the first contact changed for one run; the slope's closed form.
#[test]
fn keys_of_contacts_are_set_by_number() {
    let path = scene("set_by_number", &on_incline(20.0, "plastic", ""));
    let done = json(&[&path, "--set", "contacts[0].friction=0.1"]);
    let last = |what: &str| number(&done["last"][what]);
    let (sine, cosine) = 20.0_f64.to_radians().sin_cos();
    let gone = (last("box.x") - 0.05 * sine).hypot(last("box.z") - 0.05 * cosine);
    let expected = 0.125 * G * (sine - 0.1 * cosine);
    assert!((gone - expected).abs() < 1e-10, "{gone} against {expected}");
    for (setting, told) in [
        ("contacts[1].friction=0.1", "`contacts` is a list of 1 entry, numbered from 0"),
        ("contacts.friction=0.1", "--set contacts[0]"),
    ] {
        let text = fails(&["run", &path, "--set", setting]);
        assert!(text.contains(told), "{text}");
    }
}

/// Four corners that slip in different directions leave open how they share the weight, and friction's torque depends
/// on it. 1.1541939552 cos 0.2 is the spin of a planar motion with normal forces linear in the place of the corners, as
/// on springs of one stiffness, by scipy's DOP853 to 1e-11.
#[test]
fn a_box_slides_and_turns_down_an_incline_alike_in_every_step_alone_and_beside() {
    let expected = -1.154_193_955_2 * 0.2_f64.cos();
    for (more, name, within) in [("", "alone", 1e-5), (ELSEWHERE, "beside", 1e-8)] {
        for step in ["2e-3", "1e-3", "2.5e-4"] {
            let text = format!(
                "format = 2\n[parts.ground]\nrigid = \"half_space\"\nstart = {{ axis = [0, 1, 0], angle = 0.2 }}\n\
                 [parts.b]\nrigid = \"box\"\nsize = [0.3, 0.2, 0.1]\nmass = 2\ninertia = [0.02, 0.03, 0.045]\n\
                 start = {{ position = [0.009933466539753064, 0, 0.04900332889206208],\
                 axis = [0.09297939928698411, 0.3641368359819642, 0.9266926113816142],\
                 angle = 0.5377384348400953, velocity = [0.9800665778412416, 0.2, -0.19866933079506124],\
                 spin = [-0.794677323180245, 0, -3.9202663113649665] }}\n{more}\
                 [[contacts]]\nbetween = [\"b\", \"ground\"]\nimpact = \"plastic\"\nfriction = 0.3\n\
                 [run]\nseconds = 0.4\nstep = {step}\n"
            );
            let done = json(&[&scene(&format!("turning_{name}_{step}"), &text)]);
            let spin = number(&done["last"]["b.wz"]);
            assert!((spin - expected).abs() < within, "{name}, {step}: {spin} against {expected}");
            assert_eq!(done["warnings"].as_array().map(Vec::len), Some(0), "{name}: {}", done["warnings"]);
        }
    }
}

/// A mechanism of one coordinate with a port, and a box that stands on it with friction.
fn carried(
    name: &str,
    model: &str,
    command: &str,
    start: &str,
    friction: f64,
    law: &str,
    step: f64,
) -> String {
    scene(&format!("friction_{name}"), &format!("format = 1\nname = \"friction_{name}\"\n{model}"));
    let text = format!(
        "format = 2\n[parts.mover]\nmechanism = \"friction_{name}\"\ncommand = {{ q = \"{command}\" }}\n\
         [parts.plate]\nrigid = \"half_space\"\non = \"mover.top\"\n\
         [parts.box]\nrigid = \"box\"\nsize = [0.1, 0.1, 0.04]\nmass = 1\nstart = {{ height = 0, {start} }}\n\
         [[contacts]]\nbetween = [\"plate\", \"box\"]\nimpact = \"{law}\"\nfriction = {friction}\n\
         [run]\nseconds = 0.5\nstep = {step}\nevery = 100\n"
    );
    scene(&format!("carried_{name}_{law}_{friction}_{step}"), &text)
}

const TURNTABLE: &str = "[coordinates]\nq = { unit = \"rad\" }\n[frames]\ntable = { rotations = [[\"z\", \"q\"]] }\n\
    [bodies]\ntable = { centre = \"O\", frame = \"table\", mass = 3, inertia = { Izz = 0.1 } }\n\
    [ports]\ntop = { frame = \"table\", point = \"O\" }\n";

/// Twelve components of friction for three accelerations: no smaller step makes the forces of redundant contacts
/// unique.
#[test]
fn a_box_that_stands_off_the_axis_rides_on_a_turntable() {
    let start = "position = [0.2, 0.1, 0], velocity = [-0.1, 0.2, 0], spin = [0, 0, 1]";
    for law in LAWS {
        for step in [1e-3, 1e-4] {
            let done = json(&[&carried("turntable", TURNTABLE, "t/1_s", start, 1.0, law, step)]);
            let last = |what: &str| number(&done["last"][what]);
            let (sine, cosine) = 0.5_f64.sin_cos();
            let off =
                (last("box.x") - 0.2 * cosine + 0.1 * sine).hypot(last("box.y") - 0.2 * sine - 0.1 * cosine);
            assert!(off < 1e-10, "{law}, {step}: {off:e}");
            assert!(number(&done["imbalance"]).abs() < 1e-10, "{law}, {step}: {}", done["imbalance"]);
            assert_eq!(done["warnings"].as_array().map(Vec::len), Some(0), "{law}: {}", done["warnings"]);
        }
    }
}

/// Boxes of three shapes at many places, with as much friction as it takes to ride or much more.
#[test]
fn boxes_ride_anywhere_on_a_turntable() {
    for n in 0..18 {
        let share =
            |k: usize| (f64::from(n + 1) * [0.618_033_988_7, 0.754_877_666_2, 0.569_840_291_0][k]).fract();
        let (x, y, w) = (0.05 + 0.25 * share(0), 0.2 * share(1), 0.5 + 1.5 * share(2));
        let needed = w * w * f64::hypot(x, y) / G;
        let friction = if n % 2 == 0 { 1.2 * needed } else { 0.6 + share(0) };
        let (law, step) = (LAWS[n as usize % 3], [1e-3, 1e-4, 5e-5][n as usize / 3 % 3]);
        let start =
            format!("position = [{x}, {y}, 0], velocity = [{}, {}, 0], spin = [0, 0, {w}]", -w * y, w * x);
        let text =
            carried(&format!("ride_{n}"), TURNTABLE, &format!("{w}*t/1_s"), &start, friction, law, step);
        let text = std::fs::read_to_string(&text).expect("text");
        let sizes = ["[0.2, 0.1, 0.3]", "[0.05, 0.3, 0.02]", "[0.1, 0.1, 0.04]"];
        let text = text.replace("[0.1, 0.1, 0.04]", sizes[(n + n / 3) as usize % 3]);
        let done = json(&[&scene(&format!("ride_box_{n}"), &text), "--seconds", "0.1"]);
        let last = |what: &str| number(&done["last"][what]);
        let (sine, cosine) = (0.1 * w).sin_cos();
        let off = (last("box.x") - x * cosine + y * sine).hypot(last("box.y") - x * sine - y * cosine);
        assert!(off < 1e-10, "{text}: {off:e}");
        assert_eq!(done["warnings"].as_array().map(Vec::len), Some(0), "{text}: {}", done["warnings"]);
    }
}

const SLIDE: &str = "[coordinates]\nq = { unit = \"m\" }\n[points]\nP = \"q*N.x\"\n[bodies]\n\
    slide = { centre = \"P\", mass = 3 }\n[ports]\ntop = { frame = \"N\", point = \"P\" }\n";

/// Where a block on a plate at 0.05 m (1 - cos w t) is after 0.5 s: Coulomb's law in one dimension, in short steps.
fn shaken(friction: f64) -> f64 {
    let (w, h) = (4.0 * std::f64::consts::PI, 1e-6);
    let (mut x, mut v) = (0.0, 0.0);
    for k in 1..=500_000 {
        let plate = 0.05 * w * (w * h * f64::from(k)).sin();
        let change = (plate - v).clamp(-friction * G * h, friction * G * h);
        x += h * (v + 0.5 * change);
        v += change;
    }
    x
}

#[test]
fn a_box_on_a_shaken_plate_sticks_or_slides_as_a_point_does() {
    for friction in [1.2, 0.6] {
        let ends = [1e-3, 5e-4].map(|step| {
            let command = "0.05_m*(1 - cos(4*pi*t/1_s))";
            let text = carried("slide", SLIDE, command, "position = [0, 0, 0]", friction, "stronge", step);
            let done = json(&[&text]);
            assert_eq!(
                done["warnings"].as_array().map(Vec::len),
                Some(0),
                "{friction}: {}",
                done["warnings"]
            );
            assert!(number(&done["imbalance"]).abs() < 1e-6, "{friction}: {}", done["imbalance"]);
            number(&done["last"]["box.x"])
        });
        let expected = shaken(friction);
        println!("mu = {friction}: {ends:?}, {expected}");
        assert!((ends[1] - expected).abs() < 1e-9, "mu = {friction}: {} against {expected}", ends[1]);
        assert!((ends[0] - ends[1]).abs() < 1e-8, "mu = {friction}: {ends:?}");
    }
}

/// A box of 20 kg slides to rest on a smaller one of 1 kg, which stays: v^2/(2 mu g).
#[test]
fn a_heavy_box_slides_to_rest_on_a_smaller_one() {
    let text = "format = 2\n[parts.ground]\nrigid = \"half_space\"\n\
        [parts.low]\nrigid = \"box\"\nsize = [0.2, 0.2, 0.1]\nmass = 1\nstart = { height = 0 }\n\
        [parts.high]\nrigid = \"box\"\nsize = [0.4, 0.4, 0.1]\nmass = 20\n\
        start = { position = [0, 0, 0.15], velocity = [0.5, 0.1, 0] }\n\
        [[contacts]]\nbetween = [\"low\", \"ground\"]\nimpact = \"plastic\"\nfriction = 0.5\n\
        [[contacts]]\nbetween = [\"high\", \"low\"]\nimpact = \"plastic\"\nfriction = 0.2\n\
        [run]\nseconds = 0.3\nstep = 1e-3\n";
    let done = json(&[&scene("heavy", text)]);
    let last = |what: &str| number(&done["last"][what]);
    let way = 0.26 / (0.4 * G);
    let gone = last("high.x").hypot(last("high.y"));
    assert!((gone - way).abs() < 1e-10, "{gone} against {way}");
    assert!(last("low.x").hypot(last("low.y")) < 1e-12 && last("high.wz").abs() < 1e-12, "{}", done["last"]);
}

/// It stands on one end, topples, slaps down on both and rides: gaps then close to some digits only, and two sticking
/// points on one line contradict one another.
#[test]
fn a_capsule_that_topples_on_a_turntable_comes_to_lie_and_rides() {
    let start = "position = [0.2, 0.1, 0], velocity = [-0.1, 0.2, 0], spin = [0, 0, 1]";
    let ends = [2e-3, 1e-3, 1e-4].map(|step| {
        let text = carried("capsule", TURNTABLE, "t/1_s", start, 1.0, "plastic", step);
        let boxed = "rigid = \"box\"\nsize = [0.1, 0.1, 0.04]";
        let text = std::fs::read_to_string(&text).expect("text");
        let text = text.replace(boxed, "rigid = \"capsule\"\nradius = 0.03\nlength = 0.1");
        let done = json(&[&scene(&format!("capsule_{step}"), &text), "--seconds", "1"]);
        let last = |what: &str| number(&done["last"][what]);
        assert!(
            (last("box.z") - 0.03).abs() < 1e-9 && (last("box.wz") - 1.0).abs() < 1e-9,
            "{}",
            done["last"]
        );
        [last("box.x"), last("box.y")]
    });
    // It topples out of a state of rest that any error disturbs.
    let apart = |k: usize| (ends[k][0] - ends[2][0]).hypot(ends[k][1] - ends[2][1]);
    assert!(apart(0) < 1e-4 && apart(1) < 1e-4, "{ends:?}");
}

/// Masses, inertias and impulses that are multiplied by one number give the same motion.
#[test]
fn an_oblique_impact_does_not_depend_on_the_unit_of_mass() {
    let text = "format = 2\n[parts.ground]\nrigid = \"half_space\"\n[parts.box]\nrigid = \"box\"\n\
        size = [\"0.3_mm\", \"0.2_mm\", \"0.1_mm\"]\nmass = \"1_kg\"\n\
        start = { height = \"1_mm\", axis = [1, 2, 0.3], angle = 0.5, velocity = [\"20 mm/s\", \"6 mm/s\", 0] }\n\
        [[contacts]]\nbetween = [\"box\", \"ground\"]\nimpact = \"stronge\"\nrestitution = 0.5\nfriction = 0.3\n\
        [run]\nseconds = 0.0146\nstep = \"0.02_ms\"\n";
    let file = scene("friction_unit_of_mass", text);
    let first = |mass: f64, friction: f64| {
        let (mass_set, friction_set) =
            (format!("parts.box.mass={mass:e}"), format!("contacts.0.friction={friction:e}"));
        let done = json(&[&file, "--set", &mass_set, "--set", &friction_set]);
        number(&done["events"][0]["impulse"]) / mass
    };
    for friction in [0.3, 1e4, 1e9] {
        let expected = first(1.0, friction);
        assert!(expected > 0.05, "{expected}");
        for mass in [1e-12, 1e-9, 1e-7, 1e-3, 1e8, 1e12] {
            let off = (first(mass, friction) / expected - 1.0).abs();
            assert!(off < 1e-12, "mass {mass:e} kg, friction {friction:e}: {off:e}");
        }
    }
}

/// Angle (rad) by which a box of 0.2 x 0.3 x 0.1 m that slides and turns on the ground comes to rest: Coulomb's
/// friction at its four corners, normal forces in a plane over them, so that it does not tilt; Heun's steps of 20 us.
fn turned_at_rest(velocity: [f64; 2], spin: f64, friction: f64) -> f64 {
    let (sides, height, gravity) = ([0.1, 0.15], 0.05, 9.81);
    let inertia = (0.2_f64.powi(2) + 0.3_f64.powi(2)) / 12.0;
    let rates = |[vx, vy, w, angle]: [f64; 4]| {
        let (sine, cosine) = angle.sin_cos();
        let corners = [[-1.0, -1.0], [-1.0, 1.0], [1.0, -1.0], [1.0, 1.0]].map(|[i, j]: [f64; 2]| {
            let ([x, y], arms) = ([i * sides[0], j * sides[1]], [i, j]);
            let at = [cosine * x - sine * y, sine * x + cosine * y];
            let slip = [vx - w * at[1], vy + w * at[0]];
            let speed = slip[0].hypot(slip[1]).max(1e-12);
            (at, arms, slip.map(|s| s / speed))
        });
        // N = g/4 + a i + b j; moments about the centre vanish: sum x N = -height sum F_x, and so along y.
        let (mut slope, mut rate) = ([0.0; 2], [0.0; 3]);
        for _ in 0..30 {
            rate = [0.0; 3];
            for (at, arms, slip) in corners {
                let normal = gravity / 4.0 + slope[0] * arms[0] + slope[1] * arms[1];
                let force = slip.map(|s| -friction * normal * s);
                rate[0] += force[0];
                rate[1] += force[1];
                rate[2] += (at[0] * force[1] - at[1] * force[0]) / inertia;
            }
            let along = [cosine * rate[0] + sine * rate[1], cosine * rate[1] - sine * rate[0]];
            slope = std::array::from_fn(|i| -height * along[i] / (4.0 * sides[i]));
        }
        [rate[0], rate[1], rate[2], w]
    };
    let (h, mut x) = (2e-5, [velocity[0], velocity[1], spin, 0.0]);
    while x[0].hypot(x[1]) > 1e-4 {
        let first = rates(x);
        let second = rates(std::array::from_fn(|i| x[i] + h * first[i]));
        x = std::array::from_fn(|i| x[i] + 0.5 * h * (first[i] + second[i]));
    }
    x[3]
}

/// The four corners of a box fit one load in many ways, and friction turns the box differently with each.
#[test]
fn a_box_that_slides_and_turns_comes_to_rest_as_its_corners_say() {
    for (case, (velocity, spin)) in [([0.99, 0.899], -1.391), ([-0.636, 0.787], 2.44)].into_iter().enumerate()
    {
        let expected = turned_at_rest(velocity, spin, 0.3);
        for (mirror, sign) in [("", 1.0), ("mirrored", -1.0)] {
            let text = format!(
                "format = 2\n[parts.g]\nrigid = \"half_space\"\n[parts.a]\nrigid = \"box\"\nsize = [0.2, 0.3, 0.1]\nmass = 1\n\
                 start = {{ height = 0, velocity = [{}, {}, 0], spin = [0, 0, {}] }}\n\
                 [[contacts]]\nbetween = [\"a\", \"g\"]\nimpact = \"moreau\"\nfriction = 0.3\n[run]\nseconds = 0.5\nstep = 1e-3\n",
                velocity[0],
                sign * velocity[1],
                sign * spin
            );
            let file = scene(&format!("turning_{case}{mirror}"), &text);
            for method in ["moreau", "energy_momentum"] {
                let done = json(&[&file, "--method", method]);
                let [e0, e3] = ["a.e0", "a.e3"].map(|key| number(&done["last"][key]));
                let turned = sign * 2.0 * e3.atan2(e0);
                println!("{method}{mirror}: {turned} rad of {expected}");
                assert!(
                    (turned - expected).abs() < 2e-3 * expected.abs(),
                    "{method}: {turned} of {expected}"
                );
                assert!(done["warnings"].as_array().is_some_and(Vec::is_empty), "{}", done["warnings"]);
            }
        }
    }
}
